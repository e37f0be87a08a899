"""Numbers in print: check values and worked examples, computed anew from the printed formulas and parameters."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

import mpmath as mp
import sympy as sp

from ... import notation as nt
from ...entry import Entry
from ...proof.shape import coefficient
from ..rows import row
from .grammar import read
from .printed import Printed, name_in_print

Entries = Mapping[str, Entry]
DIGITS = 30
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


@dataclass(frozen=True)
class Printout:
    """A number of the book: where it stands, its LaTeX, and what it has to be."""

    place: str
    tex: str
    want: Any

    def wrong(self, tex: str) -> bool:
        """Whether a number in its place is not what the formulas give, rounded."""
        found = number(tex)
        return bool(abs(found.value - self.want) > found.half * (1 + mp.mpf(10) ** -6))


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


@cache
def _symbols() -> dict[str, sp.Symbol]:
    return {name_in_print(n.symbol): n.symbol for n in nt.all_notation() if n.name not in ("j", "N", "stiffness")}


def given_in(text: str) -> dict[str, Any]:
    """The assignments of a heading, $name=number$, by the name in print."""
    found: dict[str, Any] = {}
    for tex in _MATHEMATICS.findall(text):
        name, equals, value = tex.partition("=")
        if not equals:
            continue
        left = read(name)[0].members[0].name
        found[left] = number(value).value if _NUMBER.fullmatch(value.replace(r"\,", "")) else read(value)[0].members[0]
    return {name: value(found) if callable(value) else value for name, value in found.items()}


class Contact:
    """The printed formulas of a profile at parameters that are printed too."""

    def __init__(self, entries: Entries, given: Mapping[str, Any]) -> None:
        profile = next(iter(entries.values())).profile
        self.entries, self.plane = entries, "w" not in entries
        values: dict[Any, Any] = {}
        for name, value in given.items():
            index = re.fullmatch(r"A_(\d)", name)
            symbol = coefficient(int(index[1])) if index else _symbols().get(name)
            if symbol is not None:
                values[symbol] = sp.Float(str(value), DIGITS + 10)
        if nt.coefficients in profile.parameters:
            values[nt.N] = sp.Integer(sum(1 for name in given if re.fullmatch(r"A_\d", name)))
        for symbol, expr in profile.abbreviations:
            values.setdefault(symbol, expr.xreplace(values).evalf(DIGITS + 10))
        self.printed, self.values = Printed(entries, entries), values
        self.given = dict(given)

    def at(self, suffix: str, **known: Any) -> Any:
        # an integral is split where its place says that a break is crossed
        place = {nt.r: known["r"]} if "r" in known else {}
        env = self.printed.environment(self.values | place) | self.given | known
        return self.printed.at(suffix, env)

    def load(self, **known: Any) -> Any:
        suffix = "P" if self.plane else "F"
        given = {"P": "P", "F": "F_N"}[suffix]
        return self.at(suffix, **known) if suffix in self.entries else self.given[given]

    def depth(self, **known: Any) -> Any:
        return self.given["d"] if "d" in self.given else self.at("d", **known)

    def mean(self, radius: Any, load: Any) -> Any:
        return load / (2 * radius) if self.plane else load / (mp.pi * radius**2)

    def pressure(self, place: Any, **known: Any) -> Any:
        return self.at("p", **known, **{"x" if self.plane else "r": place})

    def displacement(self, place: Any, **known: Any) -> Any:
        """Of a half-plane relative to the level that the depth is measured from."""
        if self.plane:
            return self.at("d", **known) - self.at("d", **known, L=place)
        return self.at("w", **known, r=place)


CHECKS = re.compile(r"\\sect\[([^\]]*?); last digit rounded\]\{Check values\}(.*?)\\bottomrule", re.DOTALL)
HEAD = re.compile(r"\$([^$=]+)=([^$]+)\$")
LINE = re.compile(r"^\$([^$]+)\$ & \$([^$]+)\$ & \$([^$]+)\$ & \$([^$]+)\$\\\\$", re.MULTILINE)


def check_values(text: str, entries: Entries) -> Iterator[Printout]:
    """The table of check values of a spread, from its source."""
    match = CHECKS.search(text)
    if match is None:
        return
    with mp.workdps(DIGITS):
        contact = Contact(entries, given_in(match[1]))
        depth, load = contact.depth(), contact.load()
        radius = contact.given["a"]
        heads = {"d": depth, "F_N": load, "P": load, "bar p": contact.mean(radius, load)}
        for name, tex in HEAD.findall(match[2]):
            yield Printout(f"check value {name}", tex, heads[read(name)[0].members[0].name])
        for inside, pressure, outside, displacement in LINE.findall(match[2]):
            want = contact.pressure(number(inside).value * radius * (1 + mp.mpf(BESIDE))) / heads["bar p"]
            yield Printout(f"check value p at {inside}", pressure, want)
            want = contact.displacement(number(outside).value * radius * (1 + mp.mpf(BESIDE))) / depth
            yield Printout(f"check value w at {outside}", displacement, want)


WORKED = re.compile(r"\\sect\[([^\]]*)\]\{Worked example\}(.*?)\\par\}", re.DOTALL)
SHOWN = re.compile(r"\\parbox\[t\]\{[\d.]+mm\}\{\$([^$]+)\$\\\\\$([^$]+)\$")
_MATERIAL = re.compile(r"\$E=([\d.]+)\$\\,(GPa|MPa), \$\\nu=([\d.]+)\$(?:, \$\\Delta\\gamma=([\d.]+)\$\\,mJ)?")


@dataclass(frozen=True)
class Heading:
    """What the heading of a worked example states: Young's modulus and Poisson's ratio of so many equal bodies."""

    young: Any
    poisson: Any
    bodies: int
    separation: str
    stated: str
    """E* as it is printed."""
    given: dict[str, Any]
    """E* as it follows from the constants, the parameters and the load by their names."""


def heading(text: str) -> Heading:
    """The heading of the worked example of a spread.

    Raises
    ------
    LookupError
        If the spread has none, or it does not name a material.
    """
    match = WORKED.search(text)
    words = match[1] if match else ""
    material, stated = _MATERIAL.search(words), re.search(r"\$E\^\{\*\}=([^$]+)\$", words)
    if not material or not stated:
        message = f"no material and E* in {words!r}; a worked example starts with them"
        raise LookupError(message)
    bodies = 2 if words.startswith("steel on steel") else 1
    young, poisson = number(rf"{material[1]}\text{{{material[2]}}}").value, mp.mpf(material[3])
    modulus = young / (bodies * (1 - poisson**2))
    given = given_in(words[stated.end() :]) | {"E*": modulus}
    return Heading(young, poisson, bodies, material[4], stated[1], given)


def worked_example(text: str, entries: Entries, adhesive: Entries | None = None) -> Iterator[Printout]:
    """The numbers of the worked example of a spread, from its source: the modulus, then those of the load."""
    match = WORKED.search(text)
    if match is None:
        return
    with mp.workdps(DIGITS):
        solid = heading(text)
        yield Printout("worked example E*", solid.stated, solid.given["E*"])
        given = solid.given
        contact = Contact(entries, given)
        shown = SHOWN.findall(match[2])
        radius = _radius(contact, shown)
        depth = _depth(contact, radius)
        known = {"a": radius} | ({"d": depth} if "dF" in entries and "d" not in entries else {})
        load = given["P" if contact.plane else "F_N"]
        wanted: dict[str, Callable[[], Any]] = {
            "a": lambda: radius,
            "d": lambda: depth,
            r"\bar p": lambda: contact.mean(radius, load),
            "p(a/2)": lambda: contact.pressure(radius / 2, **known),
            "w(2a)": lambda: contact.displacement(2 * radius, **known),
            r"F_{\mathrm c}": lambda: _pull_off(contact, adhesive or {}, solid.separation, radius),
        }
        for name, tex in shown:
            yield Printout(f"worked example {name}", tex, wanted[name]())


def _radius(contact: Contact, shown: list[tuple[str, str]]) -> Any:
    """The contact radius at which the printed force carries the load, near the printed one."""
    if "a" in contact.given:
        return contact.given["a"]
    load = contact.given["P" if contact.plane else "F_N"]
    start = number(dict(shown)["a"]).value
    return mp.findroot(lambda a: contact.load(a=a) / load - 1, (start, start * mp.mpf("1.001")), solver="secant")


def _depth(contact: Contact, radius: Any) -> Any:
    """The depth of the compact contact; that of a complete one from its load."""
    if "d" in contact.entries:
        return contact.at("d", a=radius)
    load = contact.given["F_N"]
    start = load / (2 * contact.given["E*"] * radius)
    return mp.findroot(lambda d: contact.load(d=d) / load - 1, (start, start * mp.mpf("1.1")), solver="secant")


def _pull_off(contact: Contact, adhesive: Entries, separation: str, radius: Any) -> Any:
    """The printed force of pull-off at the radius that its printed formula or equation gives, below the loaded one."""
    printed = Printed(adhesive, contact.entries)
    values = contact.values | {nt.dgamma: sp.Float(separation, DIGITS) / 1000}
    env = printed.environment(values) | contact.given
    first = read(row(adhesive["ac"]).regions[0].tex)[0].members
    if adhesive["ac"].status == "closed":
        env["a_c"] = first[-1](env)
    else:
        start = radius / 3
        env["a_c"] = mp.findroot(
            lambda a: first[0](env | {"a_c": a}) / first[-1](env | {"a_c": a}) - 1, (start, start / 2), solver="secant"
        )
    return printed.at("Fc", env, adhesive)
