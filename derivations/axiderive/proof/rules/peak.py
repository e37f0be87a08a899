"""Rules for the greatest pressure: the ring where dp/dr changes its sign, that there is one alone, and p on it."""

from __future__ import annotations

import itertools

import sympy as sp

from ...abel.masters import IncompleteBeta
from ...entry import Case, Entry
from ...notation import a, r, r_peak
from ..algebra.domain import Domain, NotProvedError
from ..algebra.functions import canonical, normal, require_analytic, sign
from ..algebra.identity import at
from ..statement import require_regions, require_zero
from .compact import Compact


def radius(proof: Compact) -> list[str]:
    """The ring, given as a formula or by an equation."""
    entry = proof.entries["rp"]
    if (n := free_power(proof)) is not None:
        return _of_power(proof, entry, n)
    regimes = tuple(case.chain for case in proof.entry("d").cases)
    require_regions(entry, regimes)
    (case,) = entry.cases
    return _balance(proof, case) if entry.status == "root" else _formula(proof, case.expr)


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
    if not place.is_positive:
        message = f"{place} > 0 is not shown"
        raise NotProvedError(message)
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
    if factor.has(a) or sign(factor, domain) <= 0:
        message = f"{factor} is no positive factor that does not depend on a"
        raise NotProvedError(message)
    return factor


def pressure(proof: Compact) -> list[str]:
    """p on that ring."""
    entry = proof.entry("pp")
    if (n := free_power(proof)) is not None:
        return _pressure_of_power(proof, entry, n)
    (ring,), (own,) = proof.entries["rp"].cases, entry.cases
    require_regions(entry, (ring.chain,))
    if proof.entries["rp"].status != "root":
        (whole,) = proof.entry("p").cases
        if not own.expr.is_positive or sign(whole.expr, proof.domain(whole.chain)) <= 0:
            message = f"{own.expr} > 0 is not shown"
            raise NotProvedError(message)
        # roots of irrational numbers are not in the tower, their squares are
        squares = sp.expand(own.expr**2) - sp.expand((whole.expr**2).subs(r, ring.expr))
        return [require_zero(squares, proof.domain(ring.chain), "p_max^2 = p(r_max)^2, both positive")]
    (b,) = proof.profile.breaks
    outer = next(case for case in proof.entry("p").cases if case.chain == (b, r, a))
    return [require_zero(own.expr.subs(r_peak, r) - outer.expr, proof.domain(outer.chain), "p_max = p(r_max), r > b")]


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
