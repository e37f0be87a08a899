"""Fields below the surface against the transform of the pressure, and against each other and the normal contact."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import FOUR, Case
from ..oracle.evaluate import decades, evaluated
from ..oracle.half_space import HalfSpace
from ..oracle.rules import gauss_rule
from ..oracle.shape import Number, Values, number
from ..oracle.subsurface import numbers
from ..physics import subsurface
from ..physics.normal import derive
from ..physics.subsurface import DISPLACEMENT, STRESS
from .comparison import Comparison, Evidence, Rows, formula_value, residual

_, FORCE, PRESSURE, _ = FOUR
DIGITS = 30
"""Of the integrals over wave numbers, which take seconds."""
EACH, AMONG = 2, 24
"""Points of a case: those of so many whose lengths are most alike, because few waves reach great depths."""
SHALLOW, REMOTE = sp.Rational(1, 10**45), sp.Integer(10**16)
"""Depth of the surface and a far point, in radii of the contact; the contact seems a point to twice the digits."""
INSIDE, OUTSIDE = mp.mpf(3) / 8, sp.Rational(8, 5)
"""Where the surface is compared with the pressure and with the force, in radii of the contact."""
SUMMED, NODES = 12, 24
"""Digits of a load over a plane and of the strains, and places at which the first is summed."""
STEP = 10
"""Decades below the contact radius, of the distances over which displacements are taken from each other."""
RATIO = sp.Rational(3, 10)
"""Poisson's."""
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
    last = places[-1]
    compared = "integrals over the wave number of the transform of the pressure"
    return [
        *(own.judge(suffix, compared, found, digits=DIGITS) for suffix, found in rows.items()),
        *(own.judge(suffix, identities[suffix], found, digits=DIGITS) for suffix, found in sums.items()),
        own.judge("S0", "pi p/E_star on the surface", [_surface(own, i, v) for i, v in places], digits=DIGITS),
        own.judge("S2", "F/(E_star r^2) on the surface beside the contact", [_beside(own, *last)], digits=DIGITS),
        own.judge("S0", "2 int (S0 + D0) r dr = F/E_star over a plane", [_carried(own, *last)], digits=SUMMED, lost=1),
        own.judge("D2", "Hooke's law of displacements and stresses", [_hooke(own, *last)], digits=SUMMED, lost=1),
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


def _beside(own: Comparison, case: int, values: Values) -> tuple[Values, Number]:
    """S2 beside the contact, where a surface is stretched as by a point load."""
    with mp.workdps(2 * DIGITS):
        there = {**values, nt.r: values[nt.a] * OUTSIDE, nt.z: SHALLOW * values[nt.a]}
        force = formula_value(derive(own.profile)[FORCE], there, DIGITS)
        wanted = force / (evaluated(nt.E_star, there) * evaluated(nt.r, there) ** 2)
        return there, residual(_value(own, "S2", case, there), wanted)


def _carried(own: Comparison, case: int, values: Values) -> tuple[Values, Number]:
    """The load of a plane at the depth a, in v = z/hypot(r, z), in which what it carries has no singular point."""
    with mp.workdps(3 * SUMMED):  # far away the sums of a high power cancel, ten digits of a sextic
        deep, total = {**values, nt.z: values[nt.a]}, mp.mpf(0)
        z = evaluated(nt.z, deep)
        for x, weight in gauss_rule(NODES, int(mp.mp.prec)):
            point = {**deep, nt.r: sp.Rational(str(z * mp.sqrt(1 / x**2 - 1)))}
            total += weight * 2 * z**2 / x**3 * (_value(own, "S0", case, point) + _value(own, "D0", case, point))
        force = formula_value(derive(own.profile)[FORCE], deep, SUMMED) / evaluated(nt.E_star, deep)
        return deep, residual(total, force)


def _hooke(own: Comparison, case: int, values: Values) -> tuple[Values, Number]:
    """The stresses beside those of the strains: differences of the displacements on either side of the point."""
    with mp.workdps(SUMMED + 2 * STEP):
        step, nu = values[nt.a] / sp.Integer(10) ** STEP, number(RATIO)

        def moved(along: sp.Symbol) -> list[Number]:
            near = [_stated(own, case, {**values, along: values[along] + way * step}, DISPLACEMENT) for way in (1, -1)]
            return [(more - less) / (2 * number(step)) for more, less in zip(*near, strict=True)]

        (zr, rr), (zz, rz) = moved(nt.r), moved(nt.z)
        tt = _stated(own, case, values, DISPLACEMENT)[1] / number(values[nt.r])
        alike = nu / (1 - 2 * nu) * (rr + tt + zz)
        scale = evaluated(nt.E_star, values) * (1 - nu)
        strained = [scale * x for x in (alike + zz, (rz + zr) / 2, 2 * alike + rr + tt, rr - tt)]
        gaps = (abs(x - y) for x, y in zip(_stated(own, case, values, STRESS), strained, strict=True))
        return values, max(gaps) / max(map(abs, strained))


def _stated(own: Comparison, case: int, values: Values, sums: Mapping[str, sp.Expr]) -> list[Number]:
    """Displacements or stresses of the numbers."""
    symbols = {subsurface.NUMBERS[suffix].symbol: suffix for suffix in own.entries}
    known = {nt.nu: RATIO} | {
        symbol: _value(own, suffix, case, values)
        for symbol, suffix in symbols.items() if any(expr.has(symbol) for expr in sums.values())
    }  # fmt: skip
    return [evaluated(expr, {**values, **known}) for expr in sums.values()]


def _far(own: Comparison, case: int, values: Values) -> Number:
    """S0 + D0 = 3 pi F z**3/(2 pi E_star R**5) where the contact is a point."""
    with mp.workdps(DIGITS + OUT_OF_REACH[own.entries["S0"].status]):
        away = {**values, nt.r: REMOTE * values[nt.a] * sp.Rational(3, 5), nt.z: REMOTE * values[nt.a]}
        force = formula_value(derive(own.profile)[FORCE], away, DIGITS) / evaluated(nt.E_star, away)
        r, z = (evaluated(symbol, away) for symbol in (nt.r, nt.z))
        wanted = 3 * force * z**3 / (2 * mp.hypot(r, z) ** 5)
        return residual(_value(own, "S0", case, away) + _value(own, "D0", case, away), wanted)
