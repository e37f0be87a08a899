"""Numbers in print, and what they have to be: values of the printed formulas at the parameters that are printed too."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..oracle.shape import coefficient
from ..profiles.loads import Load
from .claims import DIGITS, Line
from .grammar import read
from .printed import Printed, name_in_print

Entries = Mapping[str, Entry]
Wanted = dict[str, Callable[[], Any]]
"""What the numbers of a table or an example have to be, by their names in print."""
Columns = dict[str, Callable[[Any], Any]]
"""What the entries of a table have to be at a place, by the key of their column."""
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
    """The printed formulas of a profile at parameters that are printed too."""

    def __init__(self, entries: Entries, given: Mapping[str, Any]) -> None:
        profile = next(iter(entries.values())).profile
        self.profile, self.entries, self.plane = profile, entries, "w" not in entries
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
        """The value of a quantity by its printed formula, at the given parameters and those passed by name."""
        # an integral is split where its place says that a break is crossed
        place = {nt.r: known["r"]} if "r" in known else {}
        env = self.printed.environment(self.values | place) | self.given | known
        return self.printed.at(suffix, env)

    @property
    def free(self) -> bool:
        """Whether the edge is fixed, so that the depth follows from the load and not from the radius."""
        return "d" not in self.entries

    def under(self, load: Any, shown: Mapping[str, str]) -> dict[str, Any]:
        """Contact radius and depth at which the printed force carries a load, near the printed ones."""
        if self.free:
            return {"a": self.given["a"], "d": near(shown["d"], lambda d: self.load(d=d) / load - 1)}
        known = self.given["a"] if "a" in self.given else near(shown["a"], lambda a: self.load(a=a) / load - 1)
        return {"a": known, "d": self.at("d", a=known)}

    def load(self, **known: Any) -> Any:
        """The normal force, or line load of a plane contact: by its formula, else as given."""
        suffix = "P" if self.plane else "F"
        given = {"P": "P", "F": "F_N"}[suffix]
        return self.at(suffix, **known) if suffix in self.entries else self.given[given]

    def depth(self, **known: Any) -> Any:
        """The depth: as given, else by its formula."""
        return self.given["d"] if "d" in self.given else self.at("d", **known)

    def mean(self, radius: Any = None, load: Any = None) -> Any:
        """The mean pressure, of what is given unless a radius and a load are."""
        radius = self.given["a"] if radius is None else radius
        load = self.load() if load is None else load
        return load / (2 * radius) if self.plane else load / (mp.pi * radius**2)

    def pressure(self, place: Any, **known: Any) -> Any:
        """The pressure at a place r, or x in a plane contact, by its formula."""
        return self.at("p", **known, **{"x" if self.plane else "r": place})

    def displacement(self, place: Any, **known: Any) -> Any:
        """Of a half-plane relative to the level that the depth is measured from."""
        if self.plane:
            return self.at("d", **known) - self.at("d", **known, L=place)
        return self.at("w", **known, r=place)


SHARES = {"0": BESIDE, "a/2": "0.5", "-a/2": "-0.5", "2a": "2", "10a": "10"}
"""Places of a worked example over the contact radius; at zero a formula may be a quotient of zeros."""


def without_profile(contact: Contact) -> tuple[Wanted, Columns] | None:
    """Numbers by name and columns of a prescribed pressure and of a punch that its load tilts; None of all others."""
    given, load = contact.given, contact.profile
    if isinstance(load, Load):
        scale = given["p_0"] * given["a"] / given["E*"]
        wanted = _at_places("w", "r", contact) | dict.fromkeys(("F", r"F_{\mathrm N}"), lambda: _force(contact, load))
        return wanted, {"w": lambda place: contact.at("w", r=place) / scale}
    if nt.e not in load.parameters:
        return None
    wanted = _at_places("p", "x", contact)
    wanted |= {r"\varphi": lambda: contact.at("phi"), r"\ell": lambda: contact.at("cw"), r"\bar p": contact.mean}
    return wanted, {"p": lambda place: contact.at("p", x=place) / contact.mean()}


def _at_places(suffix: str, axis: str, contact: Contact) -> Wanted:
    def at(share: str) -> Any:
        return contact.at(suffix, **{axis: mp.mpf(share) * contact.given["a"]})

    return {f"{suffix}({place})": lambda share=share: at(share) for place, share in SHARES.items()}  # type: ignore[misc]


def _force(contact: Contact, load: Load) -> Any:
    """The force of a prescribed pressure, as the integral of p_0 (1 - r**2/a**2)**s."""
    power = mp.mpf(str(sp.sympify(load.exponent).xreplace(contact.values)))
    inside = mp.quad(lambda u: (1 - u) ** power, [0, 1])
    return mp.pi * contact.given["a"] ** 2 * contact.given["p_0"] * inside
