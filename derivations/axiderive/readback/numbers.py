"""Numbers in print, and what they have to be: values of the printed formulas at the parameters that are printed too.

The worked examples are read in `examples`; the check values are compared with the functions of the package.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache, partial
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..oracle.shape import coefficient
from ..profiles.loads import Load
from .claims import DIGITS, Line
from .grammar import read
from .meaning import Node
from .printed import Printed, name_in_print, name_of

Entries = Mapping[str, Entry]
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
        name, equals, value = tex.partition("=")
        if not equals:
            continue
        left = read(name)[0].members[0].name
        found[left] = number(value).value if _NUMBER.fullmatch(value.replace(r"\,", "")) else read(value)[0].members[0]
    return {name: value(found) if callable(value) else value for name, value in found.items()}


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
