"""Viscoelastic laws in print, and the rows of growing contacts that hold for all of them at once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

import sympy as sp

from ..contact import viscoelastic
from ..entry import Entry
from ..notation import E_star, d, time, v
from .arrangement import HALF
from .naming import LEFT
from .printer import Printer
from .rows import Region, Row
from .shorthand import with_kappa
from .width import width

EXPONENT = sp.Symbol("m", positive=True)
"""The power of d that the elastic force goes with, as the laws carry it."""
RELAXATION, COMPLIANCE, RAMP = (sp.Symbol(name, positive=True) for name in ("E(t)", "J(t)", "Phi_m(t)"))
KEY = 16.0
"""Points that a key of two letters would take."""
NAMES = {RELAXATION: "E(t)", COMPLIANCE: "J(t)", RAMP: r"\Phi_{m}(t)"}


@dataclass(frozen=True)
class LawText:
    """A viscoelastic law in print: relaxation function, creep function, and the factor of a ramp."""

    suffix: str
    name: str
    relaxation: str
    creep: str
    ramp: str

    @property
    def paired(self) -> bool:
        """Whether relaxation and creep stand side by side."""
        return max(width(self.relaxation), width(self.creep)) <= HALF + KEY

    def functions(self) -> dict[str, str]:
        """The three functions by the name a row calls them by."""
        return {"E()": self.relaxation, "J()": self.creep, "Phi_m()": self.ramp}


TITLES = {"mx": "Maxwell fluid", "kv": "Kelvin--Voigt solid", "sls": "Standard solid", "pc": "Power-law creep"}


@cache
def laws() -> tuple[LawText, ...]:
    """E(t), J(t) and Phi_m(t) of every law."""
    return tuple(_law(law) for law in viscoelastic.LAWS)


def _law(law: viscoelastic.Law) -> LawText:
    printer = Printer(names={EXPONENT: "m"})
    return LawText(
        law.suffix,
        TITLES[law.suffix],
        f"E(t)={printer(law.relaxation)}",
        f"J(t)={printer(law.creep)}",
        # E_1 and the index of 1F1 behind it are read as one without more space
        rf"\Phi_{{m}}(t)={printer(law.ramp)}".replace(r"\, {}_{1}", r"\,\, {}_{1}"),
    )


def rows(entries: Mapping[str, Entry], plain: Mapping[str, Entry]) -> list[Row]:
    """Step of the depth, step of the load and ramp of the depth: one row each for the four laws."""
    found = [_step(_of("step", entries), plain)]
    if own := _of("load", entries):
        found.append(_load(own, plain))
    if own := _of("ramp", entries):
        found.append(_ramp(own, plain))
    return found


def _of(kind: str, entries: Mapping[str, Entry]) -> tuple[Entry, ...]:
    return tuple(entry for suffix, entry in entries.items() if suffix.startswith(kind + "_"))


def _row(own: tuple[Entry, ...], regions: tuple[Region, ...], remark: str = "", uses: str = "") -> Row:
    return Row(own[0], "rule", regions, remark, uses, also=own[1:])


def _elastic(plain: Mapping[str, Entry]) -> Entry:
    return plain["Fd"] if "Fd" in plain else plain["F"]


def _simple(entry: Entry) -> bool:
    return entry.status == "closed" and len(entry.cases) == 1 and not entry.composed


def _text(entry: Entry, *replaced: tuple[sp.Expr, sp.Expr]) -> str:
    short = with_kappa(entry.cases[0].expr.subs(replaced))
    return Printer(entry.cases[0].chain, NAMES | short.names)(short.expr)


def _step(own: tuple[Entry, ...], plain: Mapping[str, Entry]) -> Row:
    elastic = _elastic(plain)
    if _simple(elastic):
        text = _text(elastic, (E_star, RELAXATION))
        return _row(own, (Region("", (rf"F_{{\mathrm N}}(t)={text}",)),))
    if "Fd" not in plain:
        return _row(own, (Region("", (r"F_{\mathrm N}(t)=\frac{E(t)}{E^{*}}\,F_{\mathrm N}(d)",)),))
    return _row(own, (Region("", (r"F_{\mathrm N}(t)=\frac{E(t)}{E^{*}}\,F_{\mathrm N}(a)",)),), "with $a$ from", "ad")


def _load(own: tuple[Entry, ...], plain: Mapping[str, Entry]) -> Row:
    radius = plain["aF"]
    if _simple(radius):
        text = _text(radius, (E_star, 1 / COMPLIANCE))
        return _row(own, (Region("", (f"a={text}",)),))
    return _row(own, (Region("", (rf"F_{{\mathrm N}}(a)=E^{{*}}J(t)\,{LEFT['F']}",)),), "solved for $a$")


def _ramp(own: tuple[Entry, ...], plain: Mapping[str, Entry]) -> Row:
    elastic = _elastic(plain)
    power = viscoelastic.elastic_exponent(elastic)
    if _simple(elastic):
        text = _text(elastic, (E_star, RAMP), (d, v * time))
    else:
        text = r"\frac{\Phi_{m}(t)}{E^{*}}\,F_{\mathrm N}(v t)"
    return _row(own, (Region("", (rf"F_{{\mathrm N}}(t)={text},\qquad m={Printer()(power)}",)),))
