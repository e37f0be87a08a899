"""Rules for the rings of a contact: where the pressure is greatest, and where it first vanishes.

The greatest one stands where dp/dr changes its sign, which it does once.  The least load, or depth, of complete contact
is the largest of those at which the pressure vanishes at some place; it is written for a strip, with x and P.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import sympy as sp

from ...abel.masters import IncompleteBeta
from ...entry import Case, Entry
from ...notation import P, a, r, r_peak, x, x_zero
from ..algebra.domain import Domain, NotProvedError, require
from ..algebra.functions import canonical, normal, require_analytic, sign, tower
from ..algebra.identity import at
from ..statement import require_regions, require_zero
from .compact import Compact


def greatest(proof: Compact) -> list[str]:
    """The ring, given as a formula or by an equation."""
    entry = proof.entries["rp"]
    if (n := free_power(proof)) is not None:
        return _of_power(proof, entry, n)
    if len(proof.profile.pieces) == 1 and entry.status == "root":
        return _of_arc(proof, entry)
    regimes = tuple(case.chain for case in proof.entry("d").cases)
    require_regions(entry, regimes)
    if all(case.expr == 0 for case in entry.cases):
        return _on_axis(proof)
    (case,) = entry.cases
    return _balance(proof, case) if entry.status == "root" else _formula(proof, case.expr)


def _on_axis(proof: Compact) -> list[str]:
    """Where f'(r)/r is positive and never rises, by the sum of faces that `physics/peak.py` speaks of."""
    breaks = proof.profile.breaks
    steps, before = list[str](), sp.S.Zero
    for i, piece in enumerate(proof.profile.pieces):
        lower, chain = [sp.S.Zero, *breaks][i], (*breaks[:i], r, *breaks[i:], a)
        domain, slope = proof.domain(chain), sp.diff(piece.expr, r)
        jump = at(slope, r, lower) - before
        steps.append(require_zero(jump, proof.domain(breaks), f"f'(r) has no jump at r = {lower}"))
        curvature = normal(canonical(sp.diff(slope / r, r), domain), domain)
        require(sign(slope, domain) > 0, "f'(r) > 0 is not shown: {}", slope)
        require(curvature == 0 or sign(curvature, domain) < 0, "(f'(r)/r)' <= 0 is not shown: {}", curvature)
        before = at(slope, r, piece.upper) if piece.upper else slope
    return [*steps, "f'(r) > 0, (f'(r)/r)' <= 0: no place has more pressure than the axis"]


def _formula(proof: Compact, place: sp.Expr) -> list[str]:
    """By Descartes' rule of signs: the coefficients of the powers of r in sqrt(a^2 - r^2)/r dp/dr change sign once."""
    (pressure,) = proof.entry("p").cases
    inside, edge = proof.domain(pressure.chain), proof.domain((a,))
    slope = normal(canonical(sp.sqrt(a**2 - r**2) / r * sp.diff(pressure.expr, r), inside), inside)
    signs = [sign(c, edge) for c in reversed(sp.Poly(slope, r).coeffs())]
    changes = sum(x != y for x, y in itertools.pairwise(signs))
    if 0 in signs or signs[0] < 0 or changes != 1 or sign(slope.subs(r, a), edge) >= 0:
        message = "one change of the sign of dp/dr, from positive to negative, is not shown"
        raise NotProvedError(message)
    require(place.is_positive, "{} > 0 is not shown", place)
    return [
        "sqrt(a^2 - r^2)/r dp/dr is a polynomial of r whose coefficients change sign once, and negative at r = a",
        require_zero(slope.subs(r, place), edge, f"dp/dr = 0 at r = {place}"),
    ]


def free_power(proof: Compact) -> sp.Symbol | None:
    """The exponent of a profile that is one power of r, where it is a parameter."""
    exponents = {piece.expr.as_independent(r, as_Add=False)[1].as_base_exp()[1] for piece in proof.profile.pieces}
    (n,) = exponents if len(exponents) == 1 else (None,)
    return n if n in proof.profile.parameters else None


def _of_power(proof: Compact, entry: Entry, n: sp.Symbol) -> list[str]:
    """With D = left - right of the equation, of which left is C, dp/dr = F [(n - 2) C - L], L = (n - 2) right.

    F, C and L are positive for all n > 1, so that p falls for n <= 2. For n > 2, D falls with r and
    d/dr (r^(n - 2) C) = (n - 2) r^(n - 3) D. Were D < 0 up to some r, r^(n - 2) C would fall there from a value above
    zero, but it would be less than r^(n - 2) times the right side, which goes to zero with r.
    """
    one, two = sp.Integer(1), sp.Integer(2)
    require_regions(entry, ((one, n, two), (two, n)))
    said = {case.chain: case.expr for case in entry.cases}
    centre, ring = said[one, n, two], said[two, n]
    (whole,) = proof.entry("p").cases
    # what is no equation has sides that do not differ, which the signs below refuse
    left, right = (side.subs(r_peak, r) for side in (ring.args if isinstance(ring, sp.Eq) else (ring, ring)))
    beyond, every = Domain(whole.chain, (two, n)), Domain(whole.chain, (one, n))
    level, factor = (n - 2) * right, r ** (n - 2) * _scale(proof) / (2 * a ** (n - 1))
    positive = all(sign(part, every) > 0 for part in (left, level, factor))
    if centre != 0 or not positive or sign(sp.diff(left - right, r), beyond) >= 0:
        message = "one change of the sign of dp/dr for n > 2, and none for n <= 2, is not shown"
        raise NotProvedError(message)
    gap = sp.diff(whole.expr, r) - factor * ((n - 2) * left - level)
    grown = sp.diff(r ** (n - 2) * left, r) - (n - 2) * r ** (n - 3) * (left - right)
    rim, axis = (
        at(normal(canonical(side, beyond), beyond), r, end)
        for side, end in ((left, a), (right * r ** (n - 2), sp.S.Zero))
    )
    return [
        "F, left and (n - 2) right are positive, for n > 1; left - right falls with r, for n > 2",
        require_zero(gap, every, "dp/dr = F [(n - 2) left - (n - 2) right], which is negative for n <= 2"),
        require_zero(grown, beyond, "d/dr (r^(n-2) left) = (n - 2) r^(n-3) (left - right)"),
        require_zero(axis, beyond.at(r, sp.S.Zero), "r^(n-2) right -> 0 as r -> 0: left > right next to the axis"),
        require_zero(rim, beyond.at(r, a), "left -> 0 < right at the edge"),
    ]


def _of_arc(proof: Compact, entry: Entry) -> list[str]:
    """With D = left - right of the equation, of which the left side is a number, dp/dr = F D.

    D is zero on the axis and below zero at the edge. dD/dr over a positive weight falls with r, from a positive
    multiple of level - 1 on: D falls up to level = 1, and beyond it rises and then falls, through one zero.
    """
    level, one = next(member for member in entry.cases[0].chain if member != 1), sp.S.One
    require_regions(entry, ((level, one), (one, level)))
    said = {case.chain: case.expr for case in entry.cases}
    centre, ring = said[level, one], said[one, level]
    (whole,), end = proof.entry("p").cases, proof.profile.chain[-1]
    inside, regime = proof.domain(whole.chain), proof.domain((a, end))
    left, right = (side.subs(r_peak, r) for side in (ring.args if isinstance(ring, sp.Eq) else (ring, ring)))
    inner, outer = sp.sqrt(a**2 - r**2), sp.sqrt(end**2 - r**2)
    stretch = normal(canonical(sp.diff(proof.profile.pieces[0].expr, r) * outer / r, inside), inside)
    factor = proof.medium.pressure_scale * stretch * end / (r * inner)
    bend = normal(canonical(-sp.diff(right, r) * (outer**2 / end) ** 2 / (r * sp.atanh(inner / outer)), inside), inside)
    start = 3 * (level - 1) / sp.atanh(a / end)
    falls = sign(factor, inside) > 0 and sign(sp.diff(bend, r), inside) < 0
    if centre != 0 or left.has(r) or not falls or sign(left - at(right, r, a), regime) >= 0:
        message = "dp/dr that is negative up to level = 1, and changes its sign once beyond, is not shown"
        raise NotProvedError(message)
    return [
        require_zero(sp.diff(whole.expr, r) - factor * (left - right), inside, "dp/dr = F (left - right), F > 0"),
        require_zero(left - at(right, r, sp.S.Zero), regime, "left = right on the axis, left < right at the edge"),
        "d(left - right)/dr over a positive weight falls with r",
        require_zero(at(bend, r, sp.S.Zero) - start, regime, "from a positive multiple of level - 1"),
    ]


def _scale(proof: Compact) -> sp.Expr:
    """E* g'(a)/pi, from the proved depth."""
    return proof.medium.pressure_scale * sp.diff(proof.depth_of((a,)), a)


def _balance(proof: Compact, case: Case) -> list[str]:
    """In t = sqrt(r^2 + u^2) p has the slope E* r/pi [I - g'(a)/(a S)], I = int_r^a (g'(t)/t)'/sqrt(t^2 - r^2) dt.

    S I is the integral of (a^2 - r^2) (g'(t)/t)'/t over v = u/S from 0 to 1, which falls with r where
    (g'(t)/t)'/t falls with t, from beyond all bounds at the break to 0 at the edge.
    """
    (b,) = proof.profile.breaks
    outside, regime = proof.domain((b, r, a)), proof.domain(case.chain)
    left, right = (side.subs(r_peak, r) for side in case.expr.args)
    rate = sp.diff(proof.depth_of(case.chain), a)
    growth, punch = sp.diff(rate / a, a), 1 / sp.sqrt(a**2 - r**2)
    edge = rate / a * punch
    # what has the wanted growth is the wanted integral only where it does not jump on the way
    require_analytic(left, outside)
    factor = _factor(right, edge, sp.acos(b / a), proof, (b, r, a))
    steps = [
        require_zero(right - factor * edge, outside, "the right side is a multiple of g'(a)/(a S), S^2 = a^2 - r^2"),
        require_zero(
            sp.diff(left, a) - factor * growth * punch, outside, "d/da of the left one = that of (g'(a)/a)'/S"
        ),
        require_zero(
            at(normal(canonical(left, outside), outside), a, r), outside.at(a, r), "the left side -> 0 as a -> r"
        ),
        "hence dp/dr is a positive multiple of left - right for r > b; for r < b it is positive as g' is",
        require_zero(at(normal(canonical(rate, regime), regime), a, b), regime.at(a, b), "g'(a) -> 0 as a -> b"),
    ]
    start = at(normal(canonical(growth * sp.sqrt(a**2 - b**2), regime), regime), a, b)
    rises = sign(growth, regime) > 0 and sign(start, regime.at(a, b)) > 0
    if not rises or sign(sp.diff(growth / a, a), regime) >= 0:
        message = "(g'(a)/a)' > 0, over a falling with a and beyond all bounds as a -> b, is not shown"
        raise NotProvedError(message)
    return [*steps, "(g'(a)/a)'/a > 0 falls with a: S (left - right) falls with r, from infinity at b to below 0 at a"]


def _factor(right: sp.Expr, edge: sp.Expr, angle: sp.Expr, proof: Compact, chain: tuple[sp.Expr, ...]) -> sp.Expr:
    """What the equation was multiplied with: by the factors of the angle on either side."""
    domain, linear = proof.domain(chain), sp.Dummy("angle")
    parts = [sp.diff(canonical(side, domain).subs(canonical(angle, domain), linear), linear) for side in (right, edge)]
    factor = normal(parts[0] / parts[1], domain)
    require(
        not factor.has(a) and sign(factor, domain) > 0, "{} is no positive factor that does not depend on a", factor
    )
    return factor


def greatest_pressure(proof: Compact) -> list[str]:
    """p on that ring."""
    entry = proof.entry("pp")
    if (n := free_power(proof)) is not None:
        return _pressure_of_power(proof, entry, n)
    rings, pressure = proof.entries["rp"].cases, proof.entry("p").cases
    require_regions(entry, tuple(case.chain for case in proof.entry("d").cases))
    if all(case.expr == 0 for case in rings):
        return [_on_axis_is(proof, own, pressure) for own in entry.cases]
    (ring, *_), (own,) = rings, entry.cases
    if proof.entries["rp"].status != "root":
        (whole,) = pressure
        require(
            own.expr.is_positive and sign(whole.expr, proof.domain(whole.chain)) > 0, "{} > 0 is not shown", own.expr
        )
        # roots of irrational numbers are not in the tower, their squares are
        squares = sp.expand(own.expr**2) - sp.expand((whole.expr**2).subs(r, ring.expr))
        return [require_zero(squares, proof.domain(ring.chain), "p_max^2 = p(r_max)^2, both positive")]
    outer = next(case for case in pressure if case.chain[case.chain.index(a) - 1] == r)
    return [require_zero(own.expr.subs(r_peak, r) - outer.expr, proof.domain(outer.chain), "p_max = p(r_max)")]


def _on_axis_is(proof: Compact, own: Case, pressure: Sequence[Case]) -> str:
    whole = next(case.expr for case in pressure if case.chain == (r, *own.chain))
    return require_zero(own.expr - at(whole, r, sp.S.Zero), proof.domain(own.chain), "p_max = p(0)")


def _pressure_of_power(proof: Compact, entry: Entry, n: sp.Symbol) -> list[str]:
    """r dp/dr = (n - 1) [p - p_max(r)], so that p = p_max(r) where dp/dr = 0; on the axis r dp/dr -> 0."""
    require_regions(entry, ((sp.Integer(1), n),))
    (greatest,), (whole,) = entry.cases, proof.entry("p").cases
    domain = Domain(whole.chain, (sp.Integer(1), n))
    there = greatest.expr.subs(r_peak, r)
    gap = r * sp.diff(whole.expr, r) - (n - 1) * (whole.expr - there)
    tail = (2 - n) * r ** (n - 1) * IncompleteBeta(1 - r**2 / a**2, sp.S.Half, (3 - n) / 2) / (2 * a ** (n - 1))
    split = whole.expr - there * (1 - r**2 / a**2) + _scale(proof) / (n - 1) * tail
    return [
        require_zero(gap, domain, "r dp/dr = (n - 1) [p - p_max(r)], and dp/dr = 0 at r = r_max > 0"),
        require_zero(split, domain, "p = p_max(r) (1 - r^2/a^2) - r^(n-1) B times a number, B bounded for n <= 2"),
    ]


# the least load

SHARE = sp.Symbol("share", positive=True)


def by_squares(weighted: sp.Expr, variable: sp.Symbol, place: sp.Expr, domain: Domain, edge: Domain) -> list[str]:
    """The weighted pressure at the least load is a polynomial of positive factors and squares, zero at the place."""
    arithmetic = tower(domain, weighted)
    element = arithmetic.collect(arithmetic.convert(weighted))
    require(len(element) == 1, "the weighted pressure is not a polynomial in {}", variable)
    ((below, polynomial),) = element.items()
    unit, factors = arithmetic.factors(polynomial)
    odd = [factor for factor, power in (*factors.items(), *below) if power % 2]
    if unit < 0 or any(arithmetic.polynomial_sign(factor) <= 0 for factor in odd):
        message = "p >= 0 at the least load is not shown"
        raise NotProvedError(message)
    require(sign(a - place, edge) > 0 and (place == 0 or sign(place, edge) > 0), "0 <= {} < a is not shown", place)
    steps = ["weighted p >= 0 at the least load: positive factors and squares"]
    statement = f"p = 0 at the least load, {variable} = {place}"
    return [*steps, require_zero(at(weighted, variable, place), edge, statement)]


def by_root(
    face: sp.Expr, strip: sp.Expr, place: Entry, n: sp.Expr, domain: Domain, k: sp.Expr = sp.S.Zero
) -> list[str]:
    """The weighted pressure W = (a^2 - x^2)^((1-k)/2) p of the unbounded face C x^n has its only maximum at x_0.

    With s = a P'(a)/pi, m = n + k and D = (m - 1) a^2 - n x^2, x S W' = N = D p - s S, S = (a^2 - x^2)^((1+k)/2).
    Where D <= 0, W falls, because p > 0; where D > 0, x^(1-m) N/D falls, so that N changes sign once at most.
    """
    inside, m = a**2 - x**2, n + k
    root, D = inside ** ((1 + k) / 2), (m - 1) * a**2 - n * x**2
    N = D * face - strip * root
    scaled = x ** (1 - m) * N
    falling = D * sp.diff(scaled, x) - scaled * sp.diff(D, x)
    steps = [
        require_zero(x * root * sp.diff(inside ** ((1 - k) / 2) * face, x) - N, domain, "x S dW/dx = N"),
        require_zero(
            x ** (m - 2) * falling + 2 * (1 - k) * a**2 * strip * inside ** ((k - 1) / 2),
            domain,
            "D^2 d/dx (x^(1-m) N/D) = -2 (1 - k) a^2 s x^(2-m) (a^2 - x^2)^((k-1)/2) < 0",
        ),
    ]
    for positive in (face, strip):
        require(sign(positive, domain) > 0, "{} > 0 is not shown", positive)
    return [*steps, *_centre(place, face, strip, n, domain, k), _ring(place, N, n, domain, k)]


def _case(place: Entry, n: sp.Expr, k: sp.Expr, ring: bool) -> sp.Expr:
    """The centre up to n = 2, or the equation of the ring beyond."""
    regions = (1 - k, n, sp.Integer(2)), (sp.Integer(2), n)
    require_regions(place, regions)
    (found,) = (case.expr for case in place.cases if case.chain == regions[ring])
    return found


def _centre(place: Entry, face: sp.Expr, strip: sp.Expr, n: sp.Expr, domain: Domain, k: sp.Expr) -> list[str]:
    """For 1 < m, n <= 2 both terms of (m - 1) N are negative where D > 0, by one step of the Beta function."""
    require(_case(place, n, k, ring=False) == 0, "{} is not the centre", place.key)
    m = n + k
    tail = x ** (m - 1) * IncompleteBeta(1 - x**2 / a**2, (1 + k) / 2, (3 - m) / 2) / (2 * a**n)
    split = strip * ((a**2 - x**2) ** ((1 + k) / 2) / a**2 - (2 - n) * tail)
    return [
        require_zero((m - 1) * face - split, domain, "(m - 1) p_f = s [S/a^2 - (2 - n) B], s, B > 0"),
        "hence (m - 1) N = -s [n x^2 S/a^2 + (2 - n) D B] < 0: W falls for 1 < m, n <= 2",
    ]


def _ring(place: Entry, N: sp.Expr, n: sp.Expr, domain: Domain, k: sp.Expr) -> str:
    master, top, bottom = _solved(place, n, k, domain)
    level = sp.Dummy("level", positive=True)
    linear = canonical(N, domain).subs(master, level)
    _require_no_zero(sp.diff(linear, level), n, k, domain)
    rest = sp.diff(linear, level) * top + linear.subs(level, 0) * bottom
    return require_zero(rest, domain, "N = 0 is the equation of x_0")


def _require_no_zero(expr: sp.Expr, n: sp.Expr, k: sp.Expr, domain: Domain) -> None:
    """Refuse what may vanish at the ring: an equation divided by it would have another root, or none."""
    if sign(on_the_ring(expr, x, n, k), Domain(*domain.chains(), (SHARE, 1))) == 0:
        message = f"{expr} is not shown to have no zero at the ring"
        raise NotProvedError(message)


def _solved(place: Entry, n: sp.Expr, k: sp.Expr, domain: Domain) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """The equation master = top/bottom of x_0, in x."""
    equation = _case(place, n, k, ring=True)
    master = canonical(equation.lhs.subs(x_zero, x), domain)
    return master, *sp.fraction(equation.rhs.subs(x_zero, x))


def on_the_ring(expr: sp.Expr, place: sp.Symbol, n: sp.Expr, k: sp.Expr) -> sp.Expr:
    """The expression at the ring, where D > 0: x_0^2 is a share below 1 of (m - 1) a^2/n.

    N = 0 there, so that D p_f = s S, in which p_f, s and S are positive.
    """
    return expr.subs(place, a * sp.sqrt((n + k - 1) * SHARE / n))


def at_root(
    pressure: sp.Expr, least: sp.Expr, place: Entry, n: sp.Expr, domain: Domain, k: sp.Expr = sp.S.Zero
) -> list[str]:
    """The pressure, linear in the load and in the function of the equation, vanishes at x_0 under the least load."""
    master, top, bottom = _solved(place, n, k, domain)
    load, below = sp.fraction(least.subs(x_zero, x))
    for denominator in (bottom, below):
        _require_no_zero(denominator, n, k, domain)
    level = sp.Dummy("level", positive=True)
    linear = canonical(pressure, domain).subs(master, level)
    parts = sp.diff(linear, level), sp.diff(linear, P), linear.subs({level: 0, P: 0})
    total = parts[0] * top * below + parts[1] * load * bottom + parts[2] * bottom * below
    return [require_zero(total, domain, "p = 0 at P = P_min, x = x_0")]
