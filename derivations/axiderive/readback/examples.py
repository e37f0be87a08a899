"""The worked examples of a spread, computed anew from the source by the printed formulas, at the numbers printed too.

Those with friction, on a graded and on a viscoelastic half-space stand behind that of the normal contact, and take
its parameters, load and radius. The check values are compared with the functions of the package.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache, partial
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..oracle.shape import coefficient
from ..profiles.loads import Load
from ..rows import laws
from ..rows.row import row
from ..worked.contact import largest
from .claims import DIGITS, Entries, Line, Printed, Stored, functions_of, name_in_print, name_of, value
from .grammar import read
from .meaning import Node

BESIDE = "1e-20"
"""How far beside its place a field is evaluated: the place may be a border, which no printed range contains."""
EXTENT = {"": 1, "G": 10**9, "M": 10**6, "k": 10**3, "m": "1e-3", r"\textmu{}": "1e-6", "n": "1e-9", "p": "1e-12"}
_NUMBER = re.compile(
    r"(?P<digits>-?\d[\d.]*)?(?:\\times)?(?P<power>10\^\{-?\d+\})?"
    r"(?:\\text\{(?P<prefix>G|M|k|m(?=\w)|\\textmu\{\}|n|p|)(?P<unit>m|Pa|N|N/m|rad|s|Pam\}\^\{-k|\(SI\))\}(?:\^\{(?P<degree>-?\d+)\})?)?"
)
_MATHEMATICS = re.compile(r"\$([^$]+)\$")


@dataclass(frozen=True)
class Number:
    """A printed number, and half a unit of its last digit."""

    value: Any
    half: Any


def number(tex: str) -> Number:
    r"""1.5, 0.288\,785, 2\times10^{13}, 291.0\,\text{\textmu{}m} or 20\,\text{m}^{-1} in the units of the SI.

    Raises
    ------
    SyntaxError
        If this is no number.
    """
    match = _NUMBER.fullmatch(tex.replace(r"\,", ""))
    if not match or not (match["digits"] or match["power"]):
        message = f"{tex} is not a number; write digits, a power of ten and a unit of the SI"
        raise SyntaxError(message)
    digits = match["digits"] or "1"
    scale = mp.mpf(EXTENT[match["prefix"] or ""]) ** int(match["degree"] or 1)
    if match["power"]:
        scale *= mp.mpf(10) ** int(match["power"][4:-1])
    decimals = len(digits.partition(".")[2])
    return Number(mp.mpf(digits) * scale, scale * mp.mpf(10) ** -decimals / 2)


def rounded(place: str, tex: str, want: Any) -> Line:
    """A printed number that has to be this one, rounded to its last digit."""

    def wrong(text: str) -> bool:
        found = number(text)
        return bool(abs(found.value - want) > found.half * (1 + mp.mpf(10) ** -6))

    return Line(place, tex, wrong)


def near(tex: str, excess: Callable[[Any], Any]) -> Any:
    """The root next to a printed number."""
    start = number(tex).value
    return mp.findroot(excess, (start, start * mp.mpf("1.0001")), solver="secant")


@cache
def _symbols() -> dict[str, sp.Symbol]:
    return {name_in_print(n.symbol): n.symbol for n in nt.all_notation() if n.name not in ("j", "N", "stiffness")}


def given_in(text: str) -> dict[str, Any]:
    """The assignments of a heading, $name=number$, by the name in print."""
    found: dict[str, Any] = {}
    for tex in _MATHEMATICS.findall(text):
        name, equals, right = tex.partition("=")
        if not equals:
            continue
        left = read(name)[0].members[0].name
        found[left] = number(right).value if _NUMBER.fullmatch(right.replace(r"\,", "")) else read(right)[0].members[0]
    return {name: one(found) if callable(one) else one for name, one in found.items()}


class Contact:
    """The printed formulas of a profile at parameters that are printed too.

    `base` are the entries of the normal contact where these rest on one.
    """

    def __init__(self, entries: Entries, given: Mapping[str, Any], base: Entries | None = None) -> None:
        profile = next(iter(entries.values())).profile
        self.profile, self.entries, self.plane = profile, entries, "w" not in (base or entries)
        values: dict[Any, Any] = {}
        for name, given_value in given.items():
            index = re.fullmatch(r"A_(\d)", name)
            symbol = coefficient(int(index[1])) if index else _symbols().get(name)
            if symbol is not None:
                values[symbol] = sp.Float(str(given_value), DIGITS + 10)
        if nt.coefficients in profile.parameters:
            values[nt.N] = sp.Integer(sum(1 for name in given if re.fullmatch(r"A_\d", name)))
        for symbol, expr in profile.abbreviations:
            values.setdefault(symbol, expr.xreplace(values).evalf(DIGITS + 10))
        self.printed, self.values = Printed(entries, base or entries), values
        self.given = dict(given)

    def at(self, suffix: str, **known: Any) -> Any:
        """The value of a quantity by its printed formula, at the given parameters and those passed by name."""
        # an integral is split where its place says that a break is crossed
        place = {nt.r: known["r"]} if "r" in known else {}
        env = self.printed.environment(self.values | place) | self.given | known
        return self.printed.at(suffix, env, self.entries)

    def field(self, suffix: str, place: Any, **known: Any) -> Any:
        """The same of a field at a place r, or x in a plane contact."""
        return self.at(suffix, **known, **{"x" if self.plane else "r": place})

    def under(self, load: Any, shown: Mapping[str, str]) -> dict[str, Any]:
        """Contact radius and depth at which the printed force carries a load, near the printed ones."""
        force = "P" if self.plane else "F"
        if "d" not in self.entries:  # the edge is fixed, and the depth is free
            depth = {"d": near(shown["d"], lambda d: self.at(force, d=d) / load - 1)} if "d" in shown else {}
            return {"a": self.given["a"], **depth}
        known = self.given["a"] if "a" in self.given else near(shown["a"], lambda a: self.at(force, a=a) / load - 1)
        return {"a": known, "d": self.at("d", a=known)}

    def names(self, **known: Any) -> dict[str, Any]:
        """What stands over a number: every quantity and field, each by its printed formula unless it is given."""
        found: dict[str, Any] = self.printed.environment(self.values)
        for entry in self.entries.values():
            name, place, _ = name_of(entry).partition("(")
            if place:
                found[f"{name}()"] = partial(self._beside, entry.suffix, known)
            elif not entry.quantity.inverts:
                found[name] = Node(lambda env, suffix=entry.suffix: self.at(suffix, **known))  # type: ignore[misc]
        if isinstance(self.profile, Load):
            found["F"] = found["F_N"] = Node(lambda env: self._force())
        if self.plane:  # relative to the level that the depth is measured from
            found["w()"] = lambda place: self.at("d", **known) - self.at("d", **known, L=place)
        found["bar p"] = read("P/(2a)" if self.plane else r"F_{\mathrm N}/(\pi a^{2})")[0].members[0]
        return found | self.given | known

    def _beside(self, suffix: str, known: Mapping[str, Any], place: Any) -> Any:
        """A field next to its place, which may be a border or where a formula is a quotient of zeros."""
        radius = known.get("a", self.given.get("a"))
        return self.field(suffix, place * (1 + mp.mpf(BESIDE)) if place else radius * mp.mpf(BESIDE), **known)

    def _force(self) -> Any:
        """The force of a prescribed pressure, as the integral of p_0 (1 - r**2/a**2)**s."""
        assert isinstance(self.profile, Load)
        power = mp.mpf(str(sp.sympify(self.profile.exponent).xreplace(self.values)))
        inside = mp.quad(lambda u: (1 - u) ** power, [0, 1])
        return mp.pi * self.given["a"] ** 2 * self.given["p_0"] * inside


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
