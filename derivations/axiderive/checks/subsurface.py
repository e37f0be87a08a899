"""Fields below the surface against the transform of the pressure, and against each other and the normal contact."""

from __future__ import annotations

import random
from collections.abc import Callable

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import FOUR, Case
from ..oracle.evaluate import decades, evaluated
from ..oracle.half_space import HalfSpace
from ..oracle.shape import Number, Values
from ..oracle.subsurface import numbers
from ..physics.normal import derive
from .comparison import Comparison, Evidence, Rows, formula_value, residual

_, FORCE, PRESSURE, _ = FOUR
DIGITS = 30
"""Of the integrals over wave numbers, which take seconds."""
EACH, AMONG = 2, 24
"""Points of a case: those of so many whose lengths are most alike, because few waves reach great depths."""
SHALLOW, REMOTE = sp.Rational(1, 10**45), sp.Integer(10**16)
"""Depth of the surface and a far point, in radii of the contact; the contact seems a point to twice the digits."""
INSIDE = mp.mpf(3) / 8
"""Where the pressure is compared, in radii of the contact."""
OUT_OF_REACH = {"integral": 60, "closed": 160}
"""Digits that formulas lose at the far point; a closed one of a high power loses some of them for each power."""


def check_profile(own: Comparison) -> list[Evidence]:
    """Every check of the numbers below one profile."""
    places = [(i, values) for i, case in enumerate(own.entries["S0"].cases) for values in _places(own, case)]
    rows: dict[str, Rows] = {suffix: [] for suffix in own.entries}
    sums: dict[str, Rows] = {"S1": [], "S2": [], "W": [], "D0": []}
    for i, values in places:
        with mp.workdps(DIGITS + 10):
            wanted = numbers(HalfSpace(own.profile, values, DIGITS, graded=False))
            found = {s: _value(own, s, i, values) for s in own.entries}
            for suffix, number in found.items():
                rows[suffix].append((values, residual(number, wanted[suffix])))
            spread = 2 * evaluated(nt.z / nt.r, values)
            for m in (1, 2):
                gap = residual(found[f"D{m - 1}"] + found[f"D{m + 1}"], m * spread * found[f"S{m}"])
                sums[f"S{m}"].append((values, gap))
            sinking = _value(own, "W", i, values, lambda expr: sp.diff(expr, nt.z))
            sums["W"].append((values, residual(sinking, -found["S0"])))
        sums["D0"].append((values, _far(own, i, values)))
    identities = {
        "S1": "equilibrium: D0 + D2 = 2 z S1/r", "S2": "equilibrium: D1 + D3 = 4 z S2/r", "W": "dW/dz = -S0",
        "D0": "S0 + D0 of a point load F far away",
    }  # fmt: skip
    compared = "integrals over the wave number of the transform of the pressure"
    return [
        *(own.judge(suffix, compared, found, digits=DIGITS) for suffix, found in rows.items()),
        *(own.judge(suffix, identities[suffix], found, digits=DIGITS) for suffix, found in sums.items()),
        own.judge("S0", "pi p/E_star on the surface", [_surface(own, i, v) for i, v in places], digits=DIGITS),
    ]


def _places(own: Comparison, case: Case) -> list[Values]:
    """Contacts of a case, each with a point below."""
    fields = (nt.r, nt.z, *own.profile.free_depth)
    contacts = sorted(own.tame(case.chain, AMONG, fields), key=decades)[:EACH]
    dice = random.Random(f"{own.seed} {own.profile.name} {case.chain}")
    out: list[Values] = []
    for values in contacts:
        r, z = (values[nt.a] * sp.Rational(dice.randint(*ends), 100) for ends in ((20, 160), (50, 120)))
        out.append({**values, nt.r: r, nt.z: z})
    return out


def _value(
    own: Comparison, suffix: str, case: int, values: Values, change: Callable[[sp.Expr], sp.Expr] = lambda expr: expr
) -> Number:
    """A formula at the working precision; the integral over punches is cut where the radius is that of the point."""

    def cut(f: Callable[[Number], Number], low: Number, high: Number) -> Number:
        place = evaluated(nt.r, values)
        return mp.quad(f, [low, place, high] if low < place < high else [low, high])

    return evaluated(change(own.entries[suffix].cases[case].expr), values, cut)


def _surface(own: Comparison, case: int, values: Values) -> tuple[Values, Number]:
    """S0 just below the contact beside the pressure."""
    with mp.workdps(2 * DIGITS):
        plain, chain = derive(own.profile), own.entries["S0"].cases[case].chain
        radius = evaluated(chain[0] if own.profile.complete else nt.a, values)
        inside = {**values, nt.r: radius * INSIDE, nt.z: SHALLOW * values[nt.a]}
        pressure = formula_value(plain[PRESSURE], inside, DIGITS) / evaluated(nt.E_star, inside)
        return inside, residual(_value(own, "S0", case, inside), mp.pi * pressure)


def _far(own: Comparison, case: int, values: Values) -> Number:
    """S0 + D0 = 3 pi F z**3/(2 pi E_star R**5) where the contact is a point."""
    with mp.workdps(DIGITS + OUT_OF_REACH[own.entries["S0"].status]):
        away = {**values, nt.r: REMOTE * values[nt.a] * sp.Rational(3, 5), nt.z: REMOTE * values[nt.a]}
        force = formula_value(derive(own.profile)[FORCE], away, DIGITS) / evaluated(nt.E_star, away)
        r, z = (evaluated(symbol, away) for symbol in (nt.r, nt.z))
        wanted = 3 * force * z**3 / (2 * mp.hypot(r, z) ** 5)
        return residual(_value(own, "S0", case, away) + _value(own, "D0", case, away), wanted)
