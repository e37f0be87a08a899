"""The worked examples with friction, on a graded and on a viscoelastic half-space, computed anew from the source."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from typing import Any

import mpmath as mp
import sympy as sp

from ..entry import Entry
from ..rows import laws
from ..rows.row import Row, row
from .grammar import read
from .meaning import environment
from .numbers import DIGITS, Contact, Printout, given_in, number
from .printed import Printed, name_in_print
from .tables import SHOWN, WORKED, heading

Entries = Mapping[str, Entry]
Stored = Callable[[str], Entries]
"""The entries of a problem by its key."""
Wanted = dict[str, Callable[[], Any]]
_EXAMPLE = re.compile(
    r"\\textcolor\{ink\}\{([A-Z][a-z -]+)\}\\enspace\\textcolor\{note\}\{(.*?):\}\\hspace.*?%\n((?:\\mbox\{.*\n)+)"
)
_SHOWN = re.compile(r"\\mbox\{\$([^$=]+)=([^$]+)\$(?:~\\own\{([\w.]+)\})?\}")


def further_examples(text: str, name: str, stored: Stored) -> Iterator[Printout]:
    """The moduli and numbers of the examples behind the normal contact, with the key that each is said to follow from.

    Raises
    ------
    KeyError
        If a number is none of its example, or names a key that the catalogue does not have.
    """
    with mp.workdps(DIGITS):
        for title, words, numbers in _EXAMPLE.findall(text):
            shown = [(symbol, tex) for symbol, tex, _ in _SHOWN.findall(numbers)]
            for _, _, key in _SHOWN.findall(numbers):
                if key:
                    group, _, suffix = key.rpartition(".")
                    stored(f"{name}.{group}")[suffix]
            yield from _READERS[title](text, words, dict(shown), name, stored)


def _near(excess: Callable[[Any], Any], tex: str) -> Any:
    """The root next to a printed number."""
    start = number(tex).value
    return mp.findroot(excess, (start, start * mp.mpf("1.0001")), solver="secant")


def _printouts(title: str, shown: Mapping[str, str], wanted: Wanted) -> Iterator[Printout]:
    for name, tex in shown.items():
        yield Printout(f"{title} {name}", tex, wanted[name]())


def _with_friction(text: str, words: str, shown: dict[str, str], name: str, stored: Stored) -> Iterator[Printout]:
    solid = heading(text)
    stated = given_in(words)
    shear = 4 * solid.young / (2 * (1 + solid.poisson)) / (solid.bodies * (2 - solid.poisson))
    yield Printout("partial slip G*", _stated(words, "G^{*}"), shear)
    contact = Contact(stored(name), solid.given)
    radius = _radius(contact, text, solid.given["F_N"])
    entries = stored(f"{name}.tan")
    printed = Printed(entries, stored(name))
    env = printed.environment(contact.values) | contact.given | {**stated, "G*": shear, "a": radius}
    pulled = stated["F_x"]
    stick = _near(lambda c: printed.at("F", env | {"c": c}, entries) / pulled - 1, shown["c"])
    env["c"] = stick
    yield from _printouts(
        "partial slip",
        shown,
        {
            "c": lambda: stick,
            "u": lambda: printed.at("u", env, entries),
            r"u_{\mathrm s}": lambda: printed.at("us", env, entries),
            r"\tau(a/2)": lambda: printed.at("tau", env | {"r": radius / 2}, entries),
        },
    )


def _radius(contact: Contact, text: str, load: Any) -> Any:
    """The radius of the normal contact, near the one its example prints."""
    if "a" in contact.given:
        return contact.given["a"]
    (tex,) = re.findall(r"\\parbox\[t\]\{27mm\}\{\$a\$\\\\\$([^$]+)\$", text)
    return _near(lambda a: contact.load(a=a) / load - 1, tex)


def _graded(text: str, words: str, shown: dict[str, str], name: str, stored: Stored) -> Iterator[Printout]:
    stated = given_in(words)
    modulus = _foundation_modulus(stored("materials"), stated)
    yield Printout("graded H", _stated(words, "H"), modulus)
    load = heading(text).given["F_N"]
    own = {key: x for key, x in heading(text).given.items() if key not in ("E*", "F_N")}
    entries = stored(f"{name}.fgm")
    contact = Contact(entries, own | {"k": stated["k"], "H": modulus})
    known: dict[str, Any] = {}
    if "a" in shown:
        known["a"] = _near(lambda a: contact.load(a=a) / load - 1, shown["a"])
        depth = contact.at("d", **known)
    else:
        known["d"] = depth = _near(lambda d: contact.load(d=d) / load - 1, shown["d"])
    radius = known["a"] if "a" in known else own["a"]
    yield from _printouts(
        "graded",
        shown,
        {
            "a": lambda: radius,
            "d": lambda: depth,
            r"\bar p": lambda: contact.mean(radius, load),
        },
    )


def body_constants(text: str, constants: Entries) -> Iterator[Printout]:
    """The numbers of the worked example of the elastic constants, by their printed formulas."""
    match = WORKED.search(text)
    if match is None:
        message = "no worked example among the elastic constants; the spread prints one"
        raise ValueError(message)
    with mp.workdps(DIGITS):
        stated = given_in(match[1])
        wanted: Wanted = {
            "E^{*}": lambda: 1 / _value(row(constants["E_star"]), stated),
            "G^{*}": lambda: 1 / _value(row(constants["G_star"]), stated),
            r"h_{\mathrm N}": lambda: _with_factor(constants, stated)["h_N"],
            "H": lambda: _foundation_modulus(constants, stated),
        }
        yield from _printouts("constant", dict(SHOWN.findall(match[2])), wanted)


def _foundation_modulus(constants: Entries, stated: Mapping[str, Any]) -> Any:
    """H by its printed formula."""
    return _value(row(constants["H"]), _with_factor(constants, stated))


def _with_factor(constants: Entries, stated: Mapping[str, Any]) -> dict[str, Any]:
    """The factor of H by its printed formula, whose shorthand stands in the panel of the definitions."""
    env = {key: value for key, value in stated.items() if key != "H"}
    factor = constants["h_N"]
    for symbol, expr in factor.profile.abbreviations:
        values = {s: sp.Float(str(env[name_in_print(s)]), DIGITS) for s in expr.free_symbols}
        env[name_in_print(symbol)] = mp.mpf(str(expr.subs(values)))
    return env | {name_in_print(factor.quantity.symbol): _value(row(factor), env)}


def _relaxing(text: str, words: str, shown: dict[str, str], name: str, stored: Stored) -> Iterator[Printout]:
    stated = given_in(words)
    plain = stored(name)
    contact = Contact(plain, heading(text).given)
    step, *others = laws.rows(stored(f"{name}.vis"), plain)
    env = contact.printed.environment(contact.values) | contact.given
    if "dF" in plain and "d" not in plain:
        load = contact.given["F_N"]
        (tex,) = re.findall(r"\\parbox\[t\]\{27mm\}\{\$d\$\\\\\$([^$]+)\$", text)
        env["d"] = _near(lambda d: contact.load(d=d) / load - 1, tex)
        env["F_N()"] = lambda depth: contact.printed.at("F", {**env, "d": depth})
    else:
        env["a"] = _radius(contact, text, contact.given["F_N"])
        env["d"] = contact.at("d", a=env["a"])
    law = next(law for law in laws.laws() if law.suffix == "sls")
    # the modulus E_1 and the time tau of the law are no names of the contact
    env |= {key: _of_time(read(law_text)[0].members[-1], stated) for key, law_text in law.functions().items()}
    time = stated["tau"]

    def force(t: Any) -> Any:
        return _value(step, env | {"t": t})

    def grown(t: Any, tex: str) -> Any:
        at = env | {"F_N": force(mp.mpf(0)), "t": t}
        left, right = read(others[0].regions[0].tex)[0].members[:2]
        if others[0].remark:
            return _near(lambda a: left({**at, "a": a}) / right({**at, "a": a}) - 1, tex)
        return _value(others[0], at)

    yield from _printouts(
        "standard solid",
        shown,
        {
            r"F_{\mathrm N}(0)": lambda: force(mp.mpf(0)),
            r"F_{\mathrm N}(\tau)": lambda: force(time),
            r"F_{\mathrm N}(10\tau)": lambda: force(10 * time),
            r"a(\tau)": lambda: grown(time, shown[r"a(\tau)"]),
            r"a(10\tau)": lambda: grown(10 * time, shown[r"a(10\tau)"]),
        },
    )


def _of_time(body: Any, stated: Mapping[str, Any]) -> Callable[[Any], Any]:
    return lambda t: body({**stated, "t": t})


def _value(one: Row, env: Mapping[str, Any]) -> Any:
    """What a row gives where its names have these values."""
    statements = read(one.regions[0].tex)
    return statements[0].members[-1](environment(statements[1:], env))


def _stated(words: str, name: str) -> str:
    """The printed value of a name."""
    assigned = dict(one.split("=") for one in re.findall(r"\$([^$]+=[^$]+)\$", words))
    return assigned[name]


def _sharp(text: str, _: str, shown: dict[str, str], name: str, stored: Stored) -> Iterator[Printout]:
    """A cone at the depth of the contact."""
    contact, cone = Contact(stored(name), heading(text).given), stored("cone")
    depth = contact.at("d", a=_radius(contact, text, contact.given["F_N"]))
    force = _value(row(cone["Fd"]), contact.given | {"d": depth})
    yield from _printouts("sharp cone", shown, {r"F_{\mathrm N}": lambda: force})


_READERS = {
    "Sharp cone": _sharp,
    "Partial slip": _with_friction,
    "Graded half-space": _graded,
    "Standard solid": _relaxing,
}
