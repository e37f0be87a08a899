"""Worked examples of what has no profile: prescribed pressures, a punch under an eccentric load, elastic constants."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..figures.values import Values
from ..letters import name_of
from ..oracle.evaluate import evaluated
from ..profiles.loads import Load
from ..profiles.profile import Profile
from .cases import BLOCK, CERAMIC
from .python import Lines, called, shown
from .python import modulus as modulus_line
from .quantities import DIGITS, given_text, quantity_text

PRESSED: Mapping[sp.Symbol, str] = {nt.p_0: "500e6", nt.a: "2e-3", nt.sigma: "2"}
TILTED: Mapping[sp.Symbol, str] = {nt.P: "1e6", nt.a: "2e-3", nt.e: "5e-4"}
BODIES: Mapping[sp.Symbol, str] = {nt.young_1: "210e9", nt.nu_1: "0.3", nt.young_2: "70e9", nt.nu_2: "0.33"}
"""Steel and aluminium."""
GRADED: Mapping[sp.Symbol, str] = {nt.E_0: CERAMIC.E_0, nt.c_0: CERAMIC.c_0, nt.k: CERAMIC.k, nt.nu: CERAMIC.nu}


def worked_bodies(entries: Mapping[str, Entry]) -> dict[str, Any]:
    """Two bodies in one modulus, and a graded half-space."""
    values: Values = {symbol: sp.Rational(text) for symbol, text in {**BODIES, **GRADED}.items()}
    with mp.workdps(DIGITS):
        for symbol, expr in entries["h_N"].profile.abbreviations:
            values[symbol] = evaluated(expr, values)
        normal, shear, modulus, factor = (
            mp.re(evaluated(entries[suffix].cases[0].expr, values)) for suffix in ("E_star", "G_star", "H", "h_N")
        )
        numbers = [
            ("E^{*}", quantity_text(normal, "Pa"), "E_star"),
            ("G^{*}", quantity_text(shear, "Pa"), "G_star"),
            (r"h_{\mathrm N}", mp.nstr(factor, 4, strip_zeros=False), "h_N"),
            ("H", rf"{quantity_text(modulus, 'Pa')[:-1]}\,m}}^{{-k}}", "H"),
        ]
    bodies, graded = (
        ", ".join(f"${nt.describe(symbol).latex}={given_text(symbol.name, text)}$" for symbol, text in known.items())
        for known in (BODIES, GRADED)
    )
    words = f"steel on aluminium, {bodies}; {CERAMIC.words}, {graded}"
    both = {name_of(symbol): text for symbol, text in BODIES.items()}
    lines = [
        ("from axicontact import materials", ""),
        (called("materials", entries["E_star"], both), shown(normal)),
        (called("materials", entries["H"], {name_of(symbol): text for symbol, text in GRADED.items()}), shown(modulus)),
    ]
    return {"words": words, "numbers": numbers, "further": [], "python": lines}


def worked_given(profile: Profile, entries: Mapping[str, Entry]) -> dict[str, Any]:
    """Heading, and the numbers with the key of their formula."""
    pressed = isinstance(profile, Load)
    known = {
        symbol: text for symbol, text in (PRESSED if pressed else TILTED).items()
        if symbol in profile.parameters or symbol == nt.P
    }  # fmt: skip
    values: Values = {symbol: sp.Rational(text) for symbol, text in known.items()}
    values[nt.E_star] = BLOCK.modulus
    with mp.workdps(DIGITS):
        numbers = _displacements(profile, entries, values) if isinstance(profile, Load) else _tilt(entries, values)
    modulus = rf"$E^{{*}}={quantity_text(mp.mpf(int(BLOCK.modulus.p)) / int(BLOCK.modulus.q), 'Pa')}$"
    given = [f"${nt.describe(symbol).latex}={given_text(symbol.name, text)}$" for symbol, text in known.items()]
    words = "; ".join([BLOCK.words, modulus, *given])
    return {"words": words, "numbers": numbers, "further": [], "python": _lines(profile, entries, known, values)}


def _lines(profile: Profile, entries: Mapping[str, Entry], known: Mapping[sp.Symbol, str], values: Values) -> Lines:
    """The displacement of a pressure at twice its radius, or the inclination of the punch."""
    given = {name_of(symbol): text for symbol, text in known.items()}
    if isinstance(profile, Load):
        package, entry, fields, place = "loads", entries["w"], (f"2*{given['a']}",), {nt.r: 2 * values[nt.a]}
    else:
        package, entry, fields, place = "plane", entries["phi"], (given["P"],), {}
    with mp.workdps(DIGITS):
        result = shown(_value(entry, values | place))
    call = called(profile.name, entry, given, *fields)
    return [(f"from axicontact.{package} import {profile.name}", ""), (modulus_line(BLOCK), ""), (call, result)]


def _displacements(load: Load, entries: Mapping[str, Entry], values: Values) -> list[tuple[str, str, str]]:
    force = sp.pi * nt.p_0 * nt.a**2 / (load.exponent + 1)
    near = values[nt.a] * sp.Rational(1, 10**12)  # the middle itself is the border of the first range
    places = (("w(0)", near), ("w(a/2)", values[nt.a] / 2), ("w(2a)", 2 * values[nt.a]), ("w(10a)", 10 * values[nt.a]))
    found = [("F", quantity_text(evaluated(force, values), "N"), "")]
    return found + [(name, _at(entries["w"], values | {nt.r: place}, "m"), "w") for name, place in places]


def _tilt(entries: Mapping[str, Entry], values: Values) -> list[tuple[str, str, str]]:
    places = (("p(-a/2)", -values[nt.a] / 2), ("p(0)", sp.S.Zero), ("p(a/2)", values[nt.a] / 2))
    found = [(name, _at(entries["p"], values | {nt.x: place}, "Pa"), "p") for name, place in places]
    return [
        (r"\varphi", _at(entries["phi"], values, "rad"), "phi"),
        (r"\ell", _at(entries["cw"], values, "m"), "cw"),
        *found,
    ]


def _at(entry: Entry, values: Values, unit: str) -> str:
    return quantity_text(_value(entry, values), unit)


def _value(entry: Entry, values: Values) -> Any:
    case = next(case for case in entry.cases if _holds(case.chain, values))
    return evaluated(case.expr, values)


def _holds(chain: tuple[sp.Expr, ...], values: Values) -> bool:
    known = [length.xreplace(values) for length in chain]
    return all(bool(low < high) for low, high in zip(known, known[1:], strict=False))
