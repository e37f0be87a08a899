"""Least load of complete contact: the largest of the loads at which the pressure vanishes at some place."""

from __future__ import annotations

import sympy as sp

from ..abel.masters import IncompleteBeta
from ..entry import Entry
from ..notation import P, a, x, x_zero
from .domain import Domain, NotProvedError
from .functions import canonical, sign, tower
from .identity import at
from .statement import require_zero


def by_squares(weighted: sp.Expr, place: sp.Expr, domain: Domain, edge: Domain) -> list[str]:
    """sqrt(a^2 - x^2) p at the least load is a polynomial of positive factors and squares, zero at the place."""
    arithmetic = tower(domain, weighted)
    element = arithmetic.collect(arithmetic.convert(weighted))
    if len(element) != 1:
        message = "sqrt(a^2 - x^2) p is not a polynomial in x"
        raise NotProvedError(message)
    ((_, polynomial),) = element.items()
    unit, factors = arithmetic.factors(polynomial)
    if unit < 0 or any(arithmetic.polynomial_sign(f) <= 0 and power % 2 for f, power in factors.items()):
        message = "p >= 0 at P_min is not shown"
        raise NotProvedError(message)
    if not (sign(a - place, edge) > 0 and (place == 0 or sign(place, edge) > 0)):
        message = "0 <= x_0 < a is not shown"
        raise NotProvedError(message)
    steps = ["sqrt(a^2 - x^2) p >= 0 at P = P_min: positive factors and squares"]
    return [*steps, require_zero(at(weighted, x, place), edge, "p = 0 at P = P_min, x = x_0")]


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
    centre, ring = place.cases
    return [*steps, *_centre(centre.expr, face, strip, n, domain, k), _ring(ring.expr, N, domain)]


def _centre(place: sp.Expr, face: sp.Expr, strip: sp.Expr, n: sp.Expr, domain: Domain, k: sp.Expr) -> list[str]:
    """For 1 < m, n <= 2 both terms of (m - 1) N are negative where D > 0, by one step of the Beta function."""
    if place != 0:
        message = f"{place} is not the centre"
        raise NotProvedError(message)
    m = n + k
    tail = x ** (m - 1) * IncompleteBeta(1 - x**2 / a**2, (1 + k) / 2, (3 - m) / 2) / (2 * a**n)
    split = strip * ((a**2 - x**2) ** ((1 + k) / 2) / a**2 - (2 - n) * tail)
    return [
        require_zero((m - 1) * face - split, domain, "(m - 1) p_f = s [S/a^2 - (2 - n) B], s, B > 0"),
        "hence (m - 1) N = -s [n x^2 S/a^2 + (2 - n) D B] < 0: W falls for 1 < m, n <= 2",
    ]


def _ring(equation: sp.Expr, N: sp.Expr, domain: Domain) -> str:
    master, top, bottom = _solved(equation, domain)
    level = sp.Dummy("level", positive=True)
    linear = canonical(N, domain).subs(master, level)
    rest = sp.diff(linear, level) * top + linear.subs(level, 0) * bottom
    return require_zero(rest, domain, "N = 0 is the equation of x_0")


def _solved(equation: sp.Expr, domain: Domain) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """The equation master = top/bottom of x_0, in x."""
    master = canonical(equation.lhs.subs(x_zero, x), domain)
    return master, *sp.fraction(equation.rhs.subs(x_zero, x))


def at_root(pressure: sp.Expr, least: sp.Expr, place: Entry, domain: Domain) -> list[str]:
    """The pressure, linear in the load and in the function of the equation, vanishes at x_0 under the least load."""
    _, ring = place.cases
    master, top, bottom = _solved(ring.expr, domain)
    load, below = sp.fraction(least.subs(x_zero, x))
    level = sp.Dummy("level", positive=True)
    linear = canonical(pressure, domain).subs(master, level)
    parts = sp.diff(linear, level), sp.diff(linear, P), linear.subs({level: 0, P: 0})
    total = parts[0] * top * below + parts[1] * load * bottom + parts[2] * bottom * below
    return [require_zero(total, domain, "p = 0 at P = P_min, x = x_0")]
