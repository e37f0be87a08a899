"""Adhesive contact on the homogeneous half-space, section 11.3, and on the graded one, section 11.6."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import mpmath as mp

from .equation import ENERGY, FORCE, LENGTH, STIFFNESS, STRESS, Draw, Formula, PowerSum, Residual, equation
from .graded_punch import medium
from .quadrature import area_force, derivative, panels, singular

ZERO = mp.mpf(0)


def energy_balance(a: Any, dx: Any, dgamma: Any, foundation: Any, dl: Any) -> tuple[Any, Any]:
    """Both sides of (11.30) and (11.63); `foundation` is a stiffness per length, E* on the homogeneous half-space."""
    return 2 * mp.pi * a * dx * dgamma, foundation * dx * dl**2


def retraction(a: Any, dgamma: Any, foundation: Any) -> Any:
    """Length by which the body is lifted, its contact radius a held, until the springs at the edge come off."""
    return mp.sqrt(2 * mp.pi * a * dgamma / foundation)


def spring_energy(g: PowerSum, d: Any, a: Any, H: Any, k: Any = ZERO) -> Any:
    """H int x**k (d - g)**2 dx over (0, a), each product of powers integrated."""
    terms = ((d, ZERO), *((-c, n) for c, n in g.terms))
    return H * mp.fsum(c * e * a ** (n + q + k + 1) / (n + q + k + 1) for c, n in terms for e, q in terms)


def _rates(g: PowerSum, a: Any, dgamma: Any, dx: Any, dl: Any, H: Any, k: Any) -> tuple[Any, Any]:
    """Derivatives by a of pi a**2 dgamma and of the energy of the springs at fixed depth, times dx."""
    d = g(a) - dl
    released = derivative(lambda x: spring_energy(g, d, x, H, k), a, a / 4) * dx
    return derivative(lambda x: mp.pi * x**2 * dgamma, a, a / 2) * dx, released


@equation(30, energy_balance, "rates of the surface energy and of the elastic energy at fixed depth")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, a, E_star, dgamma = draw.power_sum(), draw.length(), draw.stress(5, 50), draw.quantity(-1, 1)
    dx, dl = draw.length(), draw.length()
    rates, sides = _rates(g, a, dgamma, dx, dl, E_star, ZERO), formula(a, dx, dgamma, E_star, dl)
    yield from (Residual(rate, side, ENERGY) for rate, side in zip(rates, sides, strict=True))


@equation(31, retraction, "JKR force of the paraboloid, its minimum, stationary energy of random powers")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
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
    yield _is_stationary(draw.power_sum(), a, dgamma, formula(a, dgamma, E_star), E_star, ZERO)


@equation(62, lambda foundation, dx: foundation * dx, "the springs under a flat punch add up to (11.46)")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, m = draw.length(), medium(draw)
    dx = draw.length()
    total = panels(lambda x: formula(m.foundation(x), dx) / dx, -a, a, (ZERO,))
    yield Residual(2 * m.H * a ** (1 + m.k) / (1 + m.k), total, STIFFNESS)


@equation(63, energy_balance, "rates of the surface energy and of the elastic energy at fixed depth")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, a, dgamma, m = draw.power_sum(), draw.length(), draw.quantity(-1, 1), medium(draw)
    dx, dl = draw.length(), draw.length()
    rates, sides = _rates(g, a, dgamma, dx, dl, m.H, m.k), formula(a, dx, dgamma, m.foundation(a), dl)
    yield from (Residual(rate, side, ENERGY) for rate, side in zip(rates, sides, strict=True))


def _is_stationary(g: PowerSum, a: Any, dgamma: Any, dl: Any, H: Any, k: Any) -> Residual:
    """The retraction at which the elastic energy falls as fast as the surface energy grows."""
    _, released = _rates(g, a, dgamma, 1, dl, H, k)
    return Residual(dl * mp.sqrt(2 * mp.pi * a * dgamma / released), dl, LENGTH)


@equation(64, retraction, "stationary energy of random powers")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, a, dgamma, m = draw.power_sum(), draw.length(), draw.quantity(-1, 1), medium(draw)
    yield _is_stationary(g, a, dgamma, formula(a, dgamma, m.foundation(a)), m.H, m.k)


@equation(
    65,
    lambda x, h_N, E_star, c0, k: h_N * E_star * (abs(x) / c0) ** k,
    "value at c0; force of the springs against the closed pressure over the area",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, a, m = draw.power_sum(), draw.length(), medium(draw)
    yield Residual(m.h_N * m.E0 / (1 - m.nu**2), formula(-m.c0, m.h_N, m.E_star, m.c0, m.k), STRESS)

    def spring(x: Any) -> Any:
        return formula(x, m.h_N, m.E_star, m.c0, m.k) * (g(a) - g(abs(x)))

    yield Residual(area_force(g, a, m.H, m.k), panels(spring, -a, a, (ZERO,)), FORCE)


@equation(
    66,
    lambda a, dgamma, h_N, E_star, c0, k: mp.sqrt(2 * mp.pi * a * dgamma * c0**k * a ** (1 - k) / (E_star * h_N)),
    "(11.65) put into (11.64); stationary energy of random powers; limit k = 0 against (11.31)",
    corrected=lambda a, dgamma, h_N, E_star, c0, k: mp.sqrt(2 * mp.pi * dgamma * c0**k * a ** (1 - k) / (E_star * h_N)),
    printed_form="dl = sqrt(2 pi a dgamma c0^k a^(1-k) / (E* h_N))",
    right_form="dl = sqrt(2 pi dgamma c0^k a^(1-k) / (E* h_N))",
    reason="The power a^(1-k) holds the factor a already: as printed, dl is not in metres and misses (11.31) for k = 0",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, a, dgamma, m = draw.power_sum(), draw.length(), draw.quantity(-1, 1), medium(draw)
    constants = (m.h_N, m.E_star, m.c0, m.k)
    yield Residual(retraction(a, dgamma, m.foundation(a)), formula(a, dgamma, *constants), LENGTH)
    yield _is_stationary(g, a, dgamma, formula(a, dgamma, *constants), m.H, m.k)
    homogeneous = formula(a, dgamma, mp.mpf(1), m.E_star, m.c0, ZERO)
    yield Residual(retraction(a, dgamma, m.E_star), homogeneous, LENGTH)
