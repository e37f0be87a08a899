"""Closed form and defining integral as Arb balls that overlap, both narrower than 10**-digits.

The integrals are those of `integrals` in real variables without singular
ends; the pressure comes by (11.23) from the derivative of the entry for the
depth, which is enclosed against its own integral.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping
from functools import lru_cache, partial

import mpmath as mp
import sympy as sp
from flint import acb

from .. import notation as nt
from ..entry import FOUR, Case, Entry
from ..oracle.balls import Ball, NotAvailableError, enclose, integral, point, shrinking
from ..oracle.evaluate import case_at, evaluated
from ..oracle.evidence import Evidence, agreed, not_available, point_text
from ..oracle.sampling import Point, fields, points
from ..oracle.shape import Values, concrete
from ..profiles.profile import Profile

Entries = Mapping[str, Entry]
COMPARED = "overlapping Arb enclosures of the result and of its defining integral"
ENCLOSED = (*FOUR, "pm")
_T, _S, _Z = sp.symbols("T S Z", positive=True)


def check(
    profile: Profile, entries: Entries, suffix: str, *, digits: int = 40, points: int = 3, seed: int = 0
) -> Evidence:
    """Enclose both sides at `points` points of every case where Arb can; say why where it cannot."""
    entry = entries[suffix]
    reason = _unsuited(profile, entry)
    if reason:
        return not_available(entry.key, COMPARED, reason)
    bits, extremes, count = 1 << 20, 0, 0
    for drawn in _points(profile, entry, points, seed):
        values = drawn.values
        try:
            ours = enclose(case_at(entry, values).expr, values, digits)
            wanted = shrinking(partial(_definition, profile, entries, suffix, values), digits)
        except NotAvailableError as error:
            return not_available(entry.key, COMPARED, str(error))
        if not ours.overlaps(wanted):
            worst = mp.nstr(mp.mpf(abs((ours - wanted) / wanted).mid().str(10, radius=False)), 2)
            return Evidence(
                entry.key, COMPARED, "failed", seed, count + 1, extremes, worst, 0, digits, point_text(values)
            )
        bits = min(bits, ours.rel_accuracy_bits(), wanted.rel_accuracy_bits())
        count, extremes = count + 1, extremes + drawn.extreme
    width = mp.mpf(2) ** -bits
    return Evidence(
        entry.key, COMPARED, "passed", seed, count, extremes, mp.nstr(width, 2), agreed(width, bits), digits
    )


def check_profile(
    profile: Profile, entries: Entries, *, digits: int = 40, points: int = 3, seed: int = 0
) -> dict[str, Evidence]:
    """Evidence by suffix, for those of d, F, pm, p and w that the profile has."""
    return {
        suffix: check(profile, entries, suffix, digits=digits, points=points, seed=seed)
        for suffix in ENCLOSED
        if suffix in entries
    }


def _unsuited(profile: Profile, entry: Entry) -> str:
    if entry.suffix not in ENCLOSED:
        return "no integral of its own; see the quadrature and the identities"
    if entry.status == "integral":
        return "the result is its defining integral"
    if entry.suffix == "p" and profile.complete:
        return "the depth g of (11.23) is no entry of a complete contact"
    if entry.suffix == "p" and len(profile.breaks) > 1:
        return "two breaks leave no substitution that removes both roots"
    return ""


def _points(profile: Profile, entry: Entry, count: int, seed: int) -> list[Point]:
    """Points in every case; a power that is no integer has a branch point at the tip, which boxes cannot pass."""
    complete = profile.complete
    found: list[Point] = []
    for case in entry.cases:
        if complete and any(x.has(nt.d) for x in case.chain[: case.chain.index(nt.a)]):
            continue
        drawn = points(profile, case.chain, 5 * count, seed, fields(profile, entry))
        fitting = [p for p in drawn if nt.n not in p.values or p.values[nt.n].is_Integer]
        found += fitting[:count]
    return found


def _definition(profile: Profile, entries: Entries, suffix: str, values: Values) -> acb:
    known = point(values)
    a, modulus = known[nt.a], known[nt.E_star]
    if suffix == "p":
        return modulus / acb.pi() * _pressure(profile, entries, values)
    free = None
    if profile.complete:
        free = known[nt.d] - _over_angle(profile, values, lambda s, z: acb(1)) * a
    match suffix:
        case "d":
            return a * _over_angle(profile, values, lambda s, z: acb(1))
        case "F" | "pm":
            total = _over_angle(profile, values, lambda s, z: s * s) + (free * a if free is not None else 0)
            return 2 * modulus * total / (acb.pi() * a * a if suffix == "pm" else 1)
    q = ((known[nt.r] - a) * (known[nt.r] + a)).sqrt()
    inclination = (a / q).atan()

    def weight(s: acb, z: acb) -> acb:
        return a * inclination - z * Ball({}, True).atan(z / q)

    return 2 / acb.pi() * (_over_angle(profile, values, weight) + (free * inclination if free is not None else 0))


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
    slopes = [(_merged(sp.diff(piece.expr, nt.r)), piece.upper) for piece in profile.pieces]
    return tuple((_from_the_edge(slope) if upper is None else slope, upper) for slope, upper in slopes)


def _merged(expr: sp.Expr) -> sp.Expr:
    """(r/a)**n/r as one power of r, which boxes around r = 0 can be put into."""
    return sp.powsimp(sp.expand_power_base(expr))


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
        inner = _inner(entries["d"], b, values)
        total = _plain(inner.expr, known, r, ball_b, values)
    slope = concrete(_regular_slope(depth, b), values)
    c = ((ball_b - r) * (ball_b + r) if inside else (r - ball_b) * (r + ball_b)).sqrt()
    reach = ((a - ball_b) * (a + ball_b)).sqrt() / c

    def f(v: acb, analytic: bool) -> acb:
        root = c * (v.sinh() if inside else v.cosh())
        ball = Ball({**known, _S: root, _T: Ball({}, bool(analytic)).sqrt(ball_b**2 + root**2)}, bool(analytic))
        return ball(slope)

    return total + integral(f, acb(0), reach.asinh() if inside else reach.acosh())


def _inner(entry: Entry, b: sp.Expr, values: Values) -> Case:
    """The case of the depth just below the break."""
    return next(case for case in entry.cases if (nt.a, b) in itertools.pairwise(case.chain))


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
