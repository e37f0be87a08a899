"""Every plane formula against the integral that defines it; the half-width by a round trip from the integral."""

from __future__ import annotations

from collections.abc import Mapping

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Case, Entry
from ..oracle import plane as integrals
from ..oracle.evaluate import at_precision, case_at, evaluate, holds
from ..oracle.evidence import Evidence, judge, not_available, residual
from ..oracle.sampling import Point, points
from ..oracle.shape import Number, Values, number
from ..profiles.profile import Profile
from .quadrature import LOST, inverse, root

FIELDS = {"p": (integrals.pressure, nt.x), "s": (integrals.slope, nt.x), "d": (integrals.depth, nt.L)}
TILTED = "the pressure of the eccentric punch is no integral; its closure is checked"


def check(
    profile: Profile, entries: Mapping[str, Entry], suffix: str, *, digits: int = 50, points: int = 8, seed: int = 0
) -> Evidence:
    """Compare one entry with its definition at `points` points or more: every case gets at least three."""
    entry = entries[suffix]
    compared = "mpmath quadrature of the defining integral" + (", round trip" if entry.quantity.inverts else "")
    if nt.e in profile.parameters:
        return not_available(entry.key, compared, TILTED)
    drawn = _points(profile, entries, suffix, points, seed)
    with mp.workdps(digits + integrals.GUARD):
        rows = [(point.values, _residual(profile, entries, suffix, point.values, digits)) for point in drawn]
    return judge(
        entry.key,
        compared,
        rows,
        seed=seed,
        extremes=sum(point.extreme for point in drawn),
        digits=digits,
        required=digits - LOST,
    )


def check_profile(
    profile: Profile, entries: Mapping[str, Entry], *, digits: int = 50, points: int = 8, seed: int = 0
) -> dict[str, Evidence]:
    """The evidence for every entry of a plane profile, keyed by suffix."""
    return {suffix: check(profile, entries, suffix, digits=digits, points=points, seed=seed) for suffix in entries}


def _points(profile: Profile, entries: Mapping[str, Entry], suffix: str, count: int, seed: int) -> list[Point]:
    """Points spread over the cases; those of an inverse are drawn in the regions of the load."""
    if entries[suffix].quantity.threshold:
        drawn = points(profile, (nt.a,), count, seed)
        return [point for point in drawn if any(holds(case, point.values) for case in entries["xz"].cases)]
    chains = [case.chain for case in entries[entries[suffix].quantity.inverts or suffix].cases]
    each = max(3, -(-count // len(chains)))
    fields = (nt.P,) if profile.complete else ()
    return [point for chain in chains for point in points(profile, chain, each, seed, fields)]


def _residual(profile: Profile, entries: Mapping[str, Entry], suffix: str, values: Values, digits: int) -> Number:
    if entries[suffix].quantity.threshold:
        return _threshold_residual(profile, entries, suffix, values, digits)
    if suffix == "aP":
        known = {**values, nt.P: defined(profile, "P", values, digits)}
        if entries["aP"].status == "root":
            found = root(case_at(entries["aP"], known), nt.a, known, digits)
        else:
            found = inverse(dict(entries), suffix, known, digits)
        return residual(found, number(values[nt.a]))
    return residual(
        evaluate(case_at(entries[suffix], values).expr, values, digits), defined(profile, suffix, values, digits)
    )


def defined(profile: Profile, suffix: str, values: Values, digits: int) -> Number:
    """The quantity as its defining integral; in complete contact the strip takes P - P_f(a)."""
    face, a, modulus = integrals.face(profile, values), number(values[nt.a]), number(values[nt.E_star])
    if suffix == "P":
        return modulus * integrals.load(face, a, digits)
    field, symbol = FIELDS[suffix]
    point = number(values[symbol])
    scale = modulus if suffix == "p" else mp.mpf(1)
    own = field(face, a, point, digits)
    if profile.compact:
        return scale * own
    strips = {
        "p": lambda: 1 / mp.sqrt((a - point) * (a + point)) / mp.pi,
        "s": lambda: -2 / mp.pi / mp.sqrt((point - a) * (point + a)),
        "d": lambda: 2 / mp.pi * mp.acosh(point / a),
    }
    edge = number(values[nt.P]) / modulus + integrals.load(face, a, digits)
    return scale * (edge * strips[suffix]() - own)


def level(face: integrals.Face, a: Number, x: Number, digits: int) -> Number:
    """The load over E* under which the pressure at x is zero."""
    weighted = mp.pi * mp.sqrt((a - x) * (a + x)) * integrals.pressure(face, a, x, digits)
    return weighted - integrals.load(face, a, digits)


def _threshold_residual(
    profile: Profile, entries: Mapping[str, Entry], suffix: str, values: Values, digits: int
) -> Number:
    """The least load is the level at x_0; the level falls on both sides of x_0 and, inside, is stationary there."""
    face, a = integrals.face(profile, values), number(values[nt.a])
    x_0 = zero_distance(case_at(entries["xz"], values), values)
    top = level(face, a, x_0, digits)
    if suffix == "Pmin":
        least = at_precision(entries["Pmin"].cases[0].expr, {**values, nt.x_zero: x_0})
        return residual(least / number(values[nt.E_star]), top)
    step = a * mp.mpf(10) ** -3 * (1 - x_0 / a)
    if level(face, a, x_0 + step, digits) >= top or (x_0 > 0 and level(face, a, x_0 - step, digits) >= top):
        return mp.mpf(1)
    if x_0 == 0:
        return mp.mpf(0)
    # x sqrt(a^2 - x^2) d/dx of sqrt(a^2 - x^2) p for a face of one power
    growth = a * face.at(face.growths[0], nt.a, a) / mp.pi
    order = x_0 * face.at(face.slopes[0], nt.x, x_0) / face.at(face.heights[0], nt.x, x_0)
    pressure = integrals.pressure(face, a, x_0, digits)
    return residual(((order - 1) * a**2 - order * x_0**2) * pressure, growth * mp.sqrt((a - x_0) * (a + x_0)))


def zero_distance(case: Case, values: Values) -> Number:
    """x_0 in closed form, or the root of its equation, below the place where the right side is infinite."""
    if not isinstance(case.expr, sp.Eq):
        return at_precision(case.expr, values)
    top, bottom = sp.fraction(case.expr.rhs)
    expr = (case.expr.lhs * bottom - top) * (nt.x_zero / nt.a) ** (nt.n - 1)

    def gap(x: Number) -> Number:
        return at_precision(expr, {**values, nt.x_zero: x})

    a, n = number(values[nt.a]), number(values[nt.n])
    lo, hi = a * mp.mpf(10) ** -3, a * mp.sqrt((n - 1) / n)
    for _ in range(20):
        middle = (lo + hi) / 2
        lo, hi = (middle, hi) if gap(lo) * gap(middle) > 0 else (lo, middle)
    return mp.findroot(gap, (lo, hi), solver="secant", tol=mp.mpf(10) ** (-2 * mp.mp.dps), verify=False)
