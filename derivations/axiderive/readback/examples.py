"""The worked examples of a spread, computed anew from the source.

Those with friction, on a graded and on a viscoelastic half-space stand behind that of the normal contact, and take
its parameters, load and radius.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..rows import laws
from ..rows.row import row
from ..worked.contact import largest
from .claims import DIGITS, Line
from .grammar import read
from .meaning import Node
from .numbers import Contact, Entries, given_in, near, number, rounded
from .printed import Printed, functions_of, name_in_print, value

Stored = Callable[[str], Entries]
"""The entries of a problem by its key."""
_WORKED = re.compile(r"\\sect(?:\[([^\]]*)\])?\{Worked example\}(.*?)\\par\}", re.DOTALL)
_BESIDE = re.compile(r"\\textcolor\{note\}\{(.*?)\}\\par")
"""The words of the example of a plane entry, which stands beside its plot."""
_SHOWN = re.compile(r"\\parbox\[t\]\{[\d.]+mm\}\{\$([^$]+)\$\\\\\$([^$]+)\$")
_MATERIAL = re.compile(r"\$E=([\d.]+)\$\\,(GPa|MPa), \$\\nu=([\d.]+)\$(?:, \$\\Delta\\gamma=([\d.]+)\$\\,mJ)?")
_FURTHER = re.compile(
    r"\\textcolor\{ink\}\{([A-Z][a-z -]+)\}\\enspace\\textcolor\{note\}\{(.*?):\}\\hspace.*?%\n((?:\\mbox\{.*\n)+)"
)
_SHOWN_FURTHER = re.compile(r"\\mbox\{\$([^$=]+)=([^$]+)\$(?:~\\own\{([\w.]+)\})?\}")


@dataclass(frozen=True)
class Example:
    """What the worked example of a spread states of Young's modulus and Poisson's ratio of so many equal bodies."""

    young: Any
    poisson: Any
    bodies: int
    separation: str
    stated: str
    """E* as it is printed."""
    given: dict[str, Any]
    """E* as it follows from the constants, the parameters and the load by their names."""
    shown: dict[str, str]
    """The numbers that follow, by their names in print."""

    @property
    def load(self) -> Any:
        """The normal force, or line load of a plane contact; None of a prescribed pressure."""
        return self.given.get("P", self.given.get("F_N"))


def _example(text: str) -> Example:
    """The worked example of a spread.

    Raises
    ------
    LookupError
        If the spread has none, or it does not name a material.
    """
    match = _WORKED.search(text)
    words = (match[1] or _BESIDE.findall(match[2])[0]) if match else ""
    material, stated = _MATERIAL.search(words), re.search(r"\$E\^\{\*\}=([^$]+)\$", words)
    if not match or not material or not stated:
        message = f"no material and E* in {words!r}; a worked example starts with them"
        raise LookupError(message)
    bodies = 2 if words.startswith("steel on steel") else 1
    young, poisson = number(rf"{material[1]}\text{{{material[2]}}}").value, mp.mpf(material[3])
    modulus = young / (bodies * (1 - poisson**2))
    given = given_in(words[stated.end() :]) | {"E*": modulus}
    shown = dict(_SHOWN.findall(match[2])) or {name: tex for name, tex, _ in _SHOWN_FURTHER.findall(match[2])}
    return Example(young, poisson, bodies, material[4], stated[1], given, shown)


def worked_example(text: str, entries: Entries, adhesive: Entries | None = None) -> Iterator[Line]:
    """The numbers of the worked example of a spread, from its source: the modulus, then those of the load."""
    if not _WORKED.search(text):
        return
    with mp.workdps(DIGITS):
        own = _example(text)
        yield rounded("worked example E*", own.stated, own.given["E*"])
        contact = Contact(entries, own.given)
        state = contact.under(own.load, own.shown)
        names = contact.names(**state)
        names["F_c"] = Node(lambda env: _pull_off(contact, adhesive or {}, own.separation, state["a"]))
        names["p_max"] = Node(lambda env: _largest(contact, state))
        for name, tex in own.shown.items():
            if tex == r"\infty":
                _require_infinite(contact, name, state)
            else:
                yield rounded(f"worked example {name}", tex, value(name, names))


def _largest(contact: Contact, state: Mapping[str, Any]) -> Any:
    """The greatest pressure; the face is searched between its breaks."""
    ends = [mp.mpf(0), *(mp.mpf(str(contact.values[b])) for b in contact.profile.breaks), state["a"]]
    return largest(lambda place: mp.re(contact.field("p", place, **state)), ends)


def _require_infinite(contact: Contact, name: str, state: Mapping[str, Any]) -> None:
    """That the printed pressure does not come to an end where it is said to be infinite.

    Raises
    ------
    ValueError
        If it grows by less over the last five decades towards that place than over the five before them.
    """
    at = value(name[2:-1], contact.names(**state))
    # from the side where the face is in contact, and from above its tip
    side = -1 if at else 1
    beside = (at + side * state["a"] * mp.mpf(10) ** -power for power in (3, 8, 13))
    first, second, third = (mp.re(contact.field("p", place, **state)) for place in beside)
    if not third - second > 0.9 * (second - first) > 0:
        message = f"{name} is printed as infinite and comes to {third}"
        raise ValueError(message)


def _pull_off(contact: Contact, adhesive: Entries, separation: str, radius: Any) -> Any:
    """The printed force of pull-off at the radius that its printed formula or equation gives, below the loaded one."""
    printed = Printed(adhesive, contact.entries)
    values = contact.values | {nt.dgamma: sp.Float(separation, DIGITS) / 1000}
    env = printed.environment(values) | contact.given
    first = read(row(adhesive["ac"]).regions[0].tex)[0].members

    def excess(a: Any) -> Any:
        return first[0](env | {"a_c": a}) / first[-1](env | {"a_c": a}) - 1

    closed = adhesive["ac"].status == "closed"
    env["a_c"] = first[-1](env) if closed else mp.findroot(excess, (radius / 3, radius / 6), solver="secant")
    return printed.at("Fc", env, adhesive)


def further_examples(text: str, name: str, stored: Stored) -> Iterator[Line]:
    """The moduli and numbers of the examples behind the normal contact, with the key that each is said to follow from.

    Raises
    ------
    KeyError
        If a number is none of its example, or names a key that the catalogue does not have.
    """
    with mp.workdps(DIGITS):
        for title, words, numbers in _FURTHER.findall(text):
            found = _SHOWN_FURTHER.findall(numbers)
            for _, _, key in found:
                if key:
                    group, _, suffix = key.rpartition(".")
                    stored(f"{name}.{group}")[suffix]
            assigned = dict(one.split("=") for one in re.findall(r"\$([^$]+=[^$]+)\$", words))
            first, shown = _example(text), {symbol: tex for symbol, tex, _ in found}
            own = Further(first, Contact(stored(name), first.given), given_in(words), shown)
            place, moduli, names = _READERS[title](own, name, stored)
            yield from (rounded(f"{place} {symbol}", assigned[symbol], want) for symbol, want in moduli.items())
            for symbol, tex in shown.items():
                # to the grammar a radius before a bracket is a factor
                want = names[symbol] if symbol.startswith("a(") else value(symbol, names)
                yield rounded(f"{place} {symbol}", tex, want)


@dataclass(frozen=True)
class Further:
    """An example behind that of the normal contact, whose contact it starts from."""

    first: Example
    contact: Contact
    stated: dict[str, Any]
    """The values of its heading by the names the grammar reads."""
    shown: dict[str, str]

    def state(self) -> dict[str, Any]:
        """Radius and depth of the normal contact."""
        return self.contact.under(self.first.load, self.first.shown)


Result = tuple[str, dict[str, Any], dict[str, Any]]
"""The words for an example, the moduli in its heading, and what the names over its numbers mean."""


def _with_friction(own: Further, name: str, stored: Stored) -> Result:
    solid = own.first
    shear = 4 * solid.young / (2 * (1 + solid.poisson)) / (solid.bodies * (2 - solid.poisson))
    given = solid.given | own.stated | {"G*": shear, "a": own.state()["a"]}
    contact = Contact(stored(f"{name}.tan"), given, stored(name))
    stick = near(own.shown["c"], lambda c: contact.at("F", c=c) / own.stated["F_x"] - 1)
    return "partial slip", {"G^{*}": shear}, contact.names(a=given["a"], c=stick)


def _graded(own: Further, name: str, stored: Stored) -> Result:
    modulus = _foundation_modulus(stored("materials"), own.stated)
    given = {key: x for key, x in own.first.given.items() if key not in ("E*", "F_N")}
    contact = Contact(stored(f"{name}.fgm"), given | {"k": own.stated["k"], "H": modulus})
    return "graded", {"H": modulus}, contact.names(**contact.under(own.first.load, own.shown))


def _relaxing(own: Further, name: str, stored: Stored) -> Result:
    contact, plain = own.contact, stored(name)
    step, *others = laws.rows(stored(f"{name}.vis"), plain)
    env = contact.printed.environment(contact.values) | contact.given | own.state()
    if "d" not in plain:
        env["F_N()"] = lambda depth, env=dict(env): contact.printed.at("F", {**env, "d": depth})
    law = next(law for law in laws.laws() if law.suffix == "sls")
    # the modulus E_1 and the time tau of the law are no names of the contact
    env |= functions_of(law, own.stated)

    def force(t: Any) -> Any:
        return value(step.regions[0].tex, env | {"t": t})

    def grown(t: Any, tex: str) -> Any:
        at, formula = env | {"F_N": force(mp.mpf(0)), "t": t}, others[0].regions[0].tex
        if not others[0].remark:
            return value(formula, at)
        left, right = read(formula)[0].members[:2]
        return near(tex, lambda a: left({**at, "a": a}) / right({**at, "a": a}) - 1)

    names: dict[str, Any] = {"tau": own.stated["tau"], "F_N()": force}
    radii = {symbol: tex for symbol, tex in own.shown.items() if symbol.startswith("a(")}
    return "standard solid", {}, names | {s: grown(value(s[2:-1], names), tex) for s, tex in radii.items()}


def _sharp(own: Further, name: str, stored: Stored) -> Result:
    """A cone at the depth of the contact."""
    force = value(row(stored("cone")["Fd"]).regions[0].tex, own.contact.given | {"d": own.state()["d"]})
    return "sharp cone", {}, {"F_N": force}


_READERS: Mapping[str, Callable[[Further, str, Stored], Result]] = {
    "Sharp cone": _sharp,
    "Partial slip": _with_friction,
    "Graded half-space": _graded,
    "Standard solid": _relaxing,
}


def body_constants(text: str, constants: Entries) -> Iterator[Line]:
    """The numbers of the worked example of the elastic constants, by their printed formulas."""
    match = _WORKED.search(text)
    if match is None:
        message = "no worked example among the elastic constants; the spread prints one"
        raise ValueError(message)
    with mp.workdps(DIGITS):
        stated = given_in(match[1])
        moduli = (("E*", "E_star"), ("G*", "G_star"))
        names = {name: 1 / value(row(constants[suffix]).regions[0].tex, stated) for name, suffix in moduli}
        names |= {"h_N": _with_factor(constants, stated)["h_N"], "H": _foundation_modulus(constants, stated)}
        for name, tex in _SHOWN.findall(match[2]):
            yield rounded(f"constant {name}", tex, value(name, names))


def _foundation_modulus(constants: Entries, stated: Mapping[str, Any]) -> Any:
    """H by its printed formula."""
    return value(row(constants["H"]).regions[0].tex, _with_factor(constants, stated))


def _with_factor(constants: Entries, stated: Mapping[str, Any]) -> dict[str, Any]:
    """The factor of H by its printed formula, whose shorthand stands in the panel of the definitions."""
    env = {key: value for key, value in stated.items() if key != "H"}
    factor = constants["h_N"]
    for symbol, expr in factor.profile.abbreviations:
        values = {s: sp.Float(str(env[name_in_print(s)]), DIGITS) for s in expr.free_symbols}
        env[name_in_print(symbol)] = mp.mpf(str(expr.subs(values)))
    return env | {name_in_print(factor.quantity.symbol): value(row(factor).regions[0].tex, env)}
