"""Closed form and defining integral as Arb balls that overlap, both narrower than 10**-digits.

The integrals are those of `integrals` in real variables without singular
ends; the pressure comes by (11.23) from the derivative of the entry for the
depth, which is enclosed against its own integral.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable
from functools import lru_cache, partial

import mpmath as mp
import sympy as sp
from flint import acb

from .. import notation as nt
from ..entry import FOUR, Entry
from ..oracle.balls import Ball, NotAvailableError, enclose, integral, point, shrinking
from ..oracle.evaluate import case_at, evaluated
from ..oracle.sampling import Point, fields, points
from ..oracle.shape import Values, concrete
from ..profiles.profile import Profile
from .comparison import Comparison, Entries, Evidence, agreed, not_available, point_text

COMPARED = "overlapping Arb enclosures of the result and of its defining integral"
ENCLOSED = (*FOUR, "pm")
POINTS = 3
"""Of every case."""
_T, _S, _Z = sp.symbols("T S Z", positive=True)


def check(own: Comparison, suffix: str) -> Evidence:
    """Enclose both sides at `POINTS` points of every case where Arb can; say why where it cannot."""
    entry, digits = own.entries[suffix], own.digits
    reason = _unsuited(own.profile, entry)
    if reason:
        return not_available(entry.key, COMPARED, reason)
    bits, extremes, count = 1 << 20, 0, 0
    for drawn in _points(own, entry):
        values = drawn.values
        try:
            ours = enclose(case_at(entry, values).expr, values, digits)
            wanted = shrinking(partial(_definition, own, suffix, values), digits)
        except NotAvailableError as error:
            return not_available(entry.key, COMPARED, str(error))
        count, extremes = count + 1, extremes + drawn.extreme
        if not ours.overlaps(wanted):
            worst = mp.nstr(mp.mpf(abs((ours - wanted) / wanted).mid().str(10, radius=False)), 2)
            return Evidence(
                entry.key, COMPARED, "failed", own.seed, count, extremes, worst, 0, digits, point_text(values)
            )
        bits = min(bits, ours.rel_accuracy_bits(), wanted.rel_accuracy_bits())
    width = mp.mpf(2) ** -bits
    return Evidence(
        entry.key, COMPARED, "passed", own.seed, count, extremes, mp.nstr(width, 2), agreed(width, bits), digits
    )


def check_profile(own: Comparison) -> list[Evidence]:
    """Evidence for those of d, F, pm, p and w that the profile has."""
    return [check(own, suffix) for suffix in ENCLOSED if suffix in own.entries]


def _unsuited(profile: Profile, entry: Entry) -> str:
    if entry.status == "integral":
        return "the result is its defining integral"
    if entry.suffix == "p" and profile.complete:
        return "the depth g of (11.23) is no entry of a complete contact"
    if entry.suffix == "p" and len(profile.breaks) > 1:
        return "two breaks leave no substitution that removes both roots"
    return ""


def _points(own: Comparison, entry: Entry) -> list[Point]:
    """Points in every case; a power that is no integer has a branch point at the tip, which boxes cannot pass."""
    found: list[Point] = []
    for case in entry.cases:
        if own.profile.complete and any(x.has(nt.d) for x in case.chain[: case.chain.index(nt.a)]):
            continue
        drawn = points(own.profile, case.chain, 5 * POINTS, own.seed, fields(own.profile, entry))
        fitting = [p for p in drawn if nt.n not in p.values or p.values[nt.n].is_Integer]
        found += fitting[:POINTS]
    return found


def _definition(own: Comparison, suffix: str, values: Values) -> acb:
    known, profile = point(values), own.profile
    a, modulus = known[nt.a], known[nt.E_star]
    if suffix == "p":
        return modulus / acb.pi() * _pressure(profile, own.entries, values)

    def depth() -> acb:
        return a * _over_angle(profile, values, lambda s, z: acb(1))

    free = known[nt.d] - depth() if profile.complete else acb(0)
    if suffix == "d":
        return depth()
    if suffix in ("F", "pm"):
        force = 2 * modulus * (_over_angle(profile, values, lambda s, z: s * s) + free * a)
        return force if suffix == "F" else force / (acb.pi() * a * a)
    q = ((known[nt.r] - a) * (known[nt.r] + a)).sqrt()
    inclination = (a / q).atan()

    def weight(s: acb, z: acb) -> acb:
        return a * inclination - z * Ball({}, True).atan(z / q)

    return 2 / acb.pi() * (_over_angle(profile, values, weight) + free * inclination)


def _over_angle(profile: Profile, values: Values, weight: Callable[[acb, acb], acb]) -> acb:
    """int f'(s) weight(s, a cos u) du with s = a sin(u), piece by piece."""
    known = point(values)
    a, total, lo = known[nt.a], acb(0), acb(0)
    for slope, upper in _slopes(profile):
        end = known[nt.a] if upper is None else Ball(known, False)(upper)
        last = upper is None or bool(evaluated(upper, values) >= evaluated(nt.a, values))
        hi = acb.pi() / 2 if last else (end / ((a - end) * (a + end)).sqrt()).atan()
        plain = concrete(slope, values)

        def f(u: acb, analytic: bool, slope: sp.Expr = plain) -> acb:
            s, z = a * u.sin(), a * u.cos()
            return Ball({**known, nt.r: s, _Z: z}, bool(analytic))(slope) * weight(s, z)

        if plain != 0:
            total += integral(f, lo, hi)
        if last:
            break
        lo = hi
    return total


@lru_cache(maxsize=64)
def _slopes(profile: Profile) -> tuple[tuple[sp.Expr, sp.Expr | None], ...]:
    # (r/a)**n/r as one power of r, which boxes around r = 0 can be put into
    slopes = [(sp.powsimp(sp.expand_power_base(sp.diff(piece.expr, nt.r))), piece.upper) for piece in profile.pieces]
    return tuple((_from_the_edge(slope) if upper is None else slope, upper) for slope, upper in slopes)


def _from_the_edge(slope: sp.Expr) -> sp.Expr:
    """R**2 - r**2 under a root as R**2 - a**2 + Z**2: with Z = a cos(u) a box next to the edge stays narrow."""
    falling = {
        power.base: power.base.subs(nt.r**2, nt.a**2 - _Z**2)
        for power in slope.atoms(sp.Pow)
        if power.base.is_polynomial(nt.r) and sp.degree(power.base, nt.r) == 2 and sp.LC(power.base, nt.r).is_negative
    }
    return slope.xreplace(falling)


def _pressure(profile: Profile, entries: Entries, values: Values) -> acb:
    """int_r^a g'(t)/sqrt(t**2 - r**2) dt, in pieces without a root at either end."""
    known = point(values)
    r, a = known[nt.r], known[nt.a]
    crossed = [b for b in profile.breaks if evaluated(b, values) < evaluated(nt.a, values)]
    depth = case_at(entries["d"], values).expr
    if not crossed:
        return _plain(depth, known, r, a, values)
    (b,) = crossed
    ball_b = Ball(known, False)(b)
    total, inside = acb(0), bool(evaluated(nt.r, values) < evaluated(b, values))
    if inside and not profile.truncated:
        below = next(case for case in entries["d"].cases if (nt.a, b) in itertools.pairwise(case.chain))
        total = _plain(below.expr, known, r, ball_b, values)
    slope = concrete(_regular_slope(depth, b), values)
    c = ((ball_b - r) * (ball_b + r) if inside else (r - ball_b) * (r + ball_b)).sqrt()
    reach = ((a - ball_b) * (a + ball_b)).sqrt() / c

    def f(v: acb, analytic: bool) -> acb:
        root = c * (v.sinh() if inside else v.cosh())
        ball = Ball({**known, _S: root, _T: Ball({}, bool(analytic)).sqrt(ball_b**2 + root**2)}, bool(analytic))
        return ball(slope)

    return total + integral(f, acb(0), reach.asinh() if inside else reach.acosh())


def _plain(depth: sp.Expr, known: dict[sp.Symbol, acb], r: acb, end: acb, values: Values) -> acb:
    """With t = r cosh(v), where g' has no root of its own."""
    slope = concrete(sp.powsimp(sp.diff(depth, nt.a)), values)

    def f(v: acb, analytic: bool) -> acb:
        return Ball({**known, nt.a: r * v.cosh()}, bool(analytic))(slope)

    return integral(f, acb(0), (end / r).acosh())


@lru_cache(maxsize=256)
def _regular_slope(depth: sp.Expr, b: sp.Expr) -> sp.Expr:
    """S g'(T)/T with S = sqrt(T**2 - b**2) written out, so that the root in g' cancels."""
    slope = sp.diff(depth, nt.a).subs(nt.a, _T)
    roots: dict[sp.Expr, sp.Expr] = {sp.acos(b / _T): sp.atan(_S / b)}
    for power in slope.atoms(sp.Pow):
        if power.exp.is_Rational and power.exp.q == 2 and power.base.has(_T):
            base = sp.factor(sp.together(power.base))
            if base.subs(_T, b) == 0:
                roots[power] = _S ** (2 * power.exp) * sp.cancel(base / (_T**2 - b**2)) ** power.exp
    regular = sp.expand(slope.xreplace(roots) * _S / _T)
    if any(power.base == _S and power.exp.is_negative for power in regular.atoms(sp.Pow)):
        message = f"a root at {b} stays in {slope}"
        raise NotAvailableError(message)
    return regular
