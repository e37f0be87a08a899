"""Ring, least depth and least force of a concave face on the graded half-space.

p >= 0 asks for d >= g(a) - W(r), W(r) = (a**2 - r**2)**((1 - k)/2) int_r^a g'(t) (t**2 - r**2)**((k - 1)/2) dt,
so that the ring is where W has its minimum.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Case, Entry
from ..oracle.definitions import stationary
from ..oracle.evaluate import evaluate, evaluated, holds
from ..oracle.evidence import Evidence, judge, residual
from ..oracle.integrals import Graded
from ..oracle.sampling import points
from ..oracle.shape import Number, Values, number, shape
from ..profiles.profile import Profile
from .quadrature import root

DIGITS = 50
LOST = 10
EXPONENTS = tuple(sp.Rational(x) for x in ("-3/10", "1/5", "1/2"))
ELSEWHERE = (0.05, 0.3, 0.6, 0.9)


def check(profile: Profile, entries: Mapping[str, Entry], suffix: str, *, seed: int = 0) -> Evidence:
    """Evidence for rz, dmin or Fmin at one point, with each of `EXPONENTS` for k and another n if there is one."""
    entry = entries[suffix]
    rows: list[tuple[Values, Number]] = []
    with mp.workdps(DIGITS + 30):
        for i, exponent in enumerate(EXPONENTS):
            values = {**points(profile, (nt.a,), 1, seed, (nt.H,))[0].values, nt.k: exponent}
            if nt.n in profile.parameters:
                values[nt.n] = (sp.Rational(37, 10), sp.Rational(9, 5), sp.Rational(5, 2))[i]
            rows.append((values, _residual(profile, entries, suffix, values)))
    compared = "least weighted pressure by quadrature of its definition"
    return judge(entry.key, compared, rows, seed=seed, extremes=0, digits=DIGITS, required=DIGITS - LOST)


def _residual(profile: Profile, entries: Mapping[str, Entry], suffix: str, values: Values) -> Number:
    face = Graded(shape(profile, values), number(values[nt.k]), DIGITS)
    a = number(values[nt.a])
    case = next(case for case in entries["rz"].cases if holds(case, values))

    def weighted(r: Number) -> Number:
        return mp.pi * face.pressure(a, r) * ((a - r) * (a + r)) ** ((1 - face.k) / 2)

    ring = _ring(case, values, a)
    least = weighted(ring)
    if suffix == "rz":
        return _offset(weighted, ring, least, a)
    depth = face.depth(a) - least
    found = {**values, nt.r_zero: ring}
    got = next(case.expr for case in entries[suffix].cases if holds(case, values))
    if suffix == "dmin":
        return residual(evaluate(got, found, DIGITS), depth)
    return residual(evaluate(got, found, DIGITS), number(values[nt.H]) * face.force(a, depth))


def _ring(case: Case, values: Values, a: Number) -> Number:
    """What the entry says, its equation solved from a bracket; whether it is the minimum is measured afterwards."""
    if not isinstance(case.expr, sp.Eq):
        return evaluate(case.expr, values, DIGITS) if case.expr != 0 else mp.mpf(0)
    starts = [a * i / 40 for i in range(1, 40)]

    def gap(x: Number) -> Number:
        return evaluated(case.expr.lhs - case.expr.rhs, {**values, nt.r_zero: x})

    for lo, hi in zip(starts, starts[1:], strict=False):
        if gap(lo) * gap(hi) < 0:
            near = mp.findroot(gap, (lo, hi), solver="anderson", tol=mp.mpf(10) ** -12, verify=False)
            at_start = {**values, nt.r_zero: near}
            return root(Case((sp.S.Zero, nt.r_zero, nt.a), case.expr), nt.r_zero, at_start, DIGITS)
    message = f"the equation of the ring {case.expr} has no root below a"
    raise ArithmeticError(message)


def _offset(weighted: Callable[[Number], Number], ring: Number, least: Number, a: Number) -> Number:
    """How far the least value next to the ring lies from it, relative to the ring; 1 if there is a lower one."""
    if any(weighted(a * mp.mpf(x)) <= least for x in ELSEWHERE):
        return mp.mpf(1)
    return mp.mpf(0) if ring == 0 else residual(ring, stationary(weighted, ring, a)[0])
