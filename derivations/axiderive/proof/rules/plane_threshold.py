"""Least load of complete contact: the largest of the loads at which the pressure vanishes at some place."""

from __future__ import annotations

import sympy as sp

from ...abel.masters import IncompleteBeta
from ...entry import Entry
from ...notation import P, a, x, x_zero
from ..algebra.domain import Domain, NotProvedError
from ..algebra.functions import canonical, sign, tower
from ..algebra.identity import at
from ..statement import require_regions, require_zero

SHARE = sp.Symbol("share", positive=True)


def by_squares(weighted: sp.Expr, variable: sp.Symbol, place: sp.Expr, domain: Domain, edge: Domain) -> list[str]:
    """The weighted pressure at the least load is a polynomial of positive factors and squares, zero at the place."""
    arithmetic = tower(domain, weighted)
    element = arithmetic.collect(arithmetic.convert(weighted))
    if len(element) != 1:
        message = f"the weighted pressure is not a polynomial in {variable}"
        raise NotProvedError(message)
    ((below, polynomial),) = element.items()
    unit, factors = arithmetic.factors(polynomial)
    odd = [factor for factor, power in (*factors.items(), *below) if power % 2]
    if unit < 0 or any(arithmetic.polynomial_sign(factor) <= 0 for factor in odd):
        message = "p >= 0 at the least load is not shown"
        raise NotProvedError(message)
    if sign(a - place, edge) <= 0 or (place != 0 and sign(place, edge) <= 0):
        message = f"0 <= {place} < a is not shown"
        raise NotProvedError(message)
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
        if sign(positive, domain) <= 0:
            message = f"{positive} > 0 is not shown"
            raise NotProvedError(message)
    return [*steps, *_centre(place, face, strip, n, domain, k), _ring(place, N, n, domain, k)]


def _case(place: Entry, n: sp.Expr, k: sp.Expr, ring: bool) -> sp.Expr:
    """The centre up to n = 2, or the equation of the ring beyond."""
    regions = (1 - k, n, sp.Integer(2)), (sp.Integer(2), n)
    require_regions(place, regions)
    (found,) = (case.expr for case in place.cases if case.chain == regions[ring])
    return found


def _centre(place: Entry, face: sp.Expr, strip: sp.Expr, n: sp.Expr, domain: Domain, k: sp.Expr) -> list[str]:
    """For 1 < m, n <= 2 both terms of (m - 1) N are negative where D > 0, by one step of the Beta function."""
    if _case(place, n, k, ring=False) != 0:
        message = f"{place.key} is not the centre"
        raise NotProvedError(message)
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
