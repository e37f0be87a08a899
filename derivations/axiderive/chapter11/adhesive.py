"""Section 11.3: adhesive contact on the homogeneous half-space, (11.30) and (11.31)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import mpmath as mp

from .equation import ENERGY, FORCE, LENGTH, Draw, Formula, PowerSum, Residual, equation
from .quadrature import derivative, singular

ZERO = mp.mpf(0)


def energy_balance(a: Any, dx: Any, dgamma: Any, E_star: Any, dl: Any) -> tuple[Any, Any]:
    """Both sides of (11.30)."""
    return 2 * mp.pi * a * dx * dgamma, E_star * dx * dl**2


def retraction(a: Any, dgamma: Any, E_star: Any) -> Any:
    """Length by which the body is lifted, its contact radius a held, until the springs at the edge come off."""
    return mp.sqrt(2 * mp.pi * a * dgamma / E_star)


def spring_energy(g: PowerSum, d: Any, a: Any, E_star: Any) -> Any:
    """E* int (d - g)**2 dx over (0, a), each product of powers integrated."""
    terms = ((d, ZERO), *((-c, n) for c, n in g.terms))
    return E_star * mp.fsum(c * e * a ** (n + m + 1) / (n + m + 1) for c, n in terms for e, m in terms)


@equation(30, energy_balance, "rates of the surface energy and of the elastic energy at fixed depth")
def check_energy_balance(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """Derivatives by a of pi a**2 dgamma and of the energy of the springs, times dx, beside the two sides."""
    g, a, E_star, dgamma = draw.power_sum(), draw.length(), draw.stress(5, 50), draw.quantity(-1, 1)
    dx, dl = draw.length(), draw.length()
    surface, elastic = formula(a, dx, dgamma, E_star, dl)
    yield Residual(derivative(lambda x: mp.pi * x**2 * dgamma, a, a / 2) * dx, surface, ENERGY)
    d = g(a) - dl
    yield Residual(derivative(lambda x: spring_energy(g, d, x, E_star), a, a / 4) * dx, elastic, ENERGY)


@equation(31, retraction, "JKR force of the paraboloid, its minimum, stationary energy of random powers")
def check_retraction(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """The paraboloid: force of Johnson, Kendall and Roberts, its minimum -3/2 pi dgamma R, and a stationary energy."""
    R, E_star, dgamma = draw.length(), draw.stress(5, 50), draw.quantity(-1, 1)
    a = draw.length()
    known = 4 * E_star * a**3 / (3 * R) - mp.sqrt(8 * mp.pi * E_star * dgamma * a**3)
    gap = a**2 / R - formula(a, dgamma, E_star)
    force = 2 * E_star * singular(lambda x: gap - x**2 / R, ZERO, a)
    yield Residual(known, force, FORCE)
    weakest = mp.cbrt(9 * mp.pi * dgamma * R**2 / (8 * E_star))
    depth = weakest**2 / R - formula(weakest, dgamma, E_star)
    pull_off = 2 * E_star * singular(lambda x: depth - x**2 / R, ZERO, weakest)
    yield Residual(-3 * mp.pi * dgamma * R / 2, pull_off, FORCE)
    g = draw.power_sum()
    d = g(a) - formula(a, dgamma, E_star)
    grown = derivative(lambda x: spring_energy(g, d, x, E_star), a, a / 4)
    yield Residual(mp.sqrt(grown / E_star), formula(a, dgamma, E_star), LENGTH)
