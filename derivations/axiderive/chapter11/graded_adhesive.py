"""Section 11.6: adhesive contact on the graded half-space, (11.62)-(11.66)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import mpmath as mp

from .equation import ENERGY, FORCE, LENGTH, STIFFNESS, STRESS, Draw, Formula, PowerSum, Residual, equation
from .graded_punch import Medium, medium
from .quadrature import derivative, panels, pressure, total_force


def spring_stiffness(foundation: Any, dx: Any) -> Any:
    """Stiffness (force over length) of one spring of width dx; `foundation` is a stiffness per length."""
    return foundation * dx


def energy_balance(a: Any, dx: Any, dgamma: Any, foundation: Any, dl: Any) -> tuple[Any, Any]:
    """Both sides of (11.63)."""
    return 2 * mp.pi * a * dx * dgamma, foundation * dx * dl**2


def retraction(a: Any, dgamma: Any, foundation: Any) -> Any:
    """Length by which the body is lifted until its edge springs come off; `foundation` is c_N at the edge."""
    return mp.sqrt(2 * mp.pi * a * dgamma / foundation)


def foundation_modulus(x: Any, h_N: Any, E_star: Any, c0: Any, k: Any) -> Any:
    """Stiffness of the foundation per length at x, a force over the square of a length."""
    return h_N * E_star * (abs(x) / c0) ** k


def retraction_printed(a: Any, dgamma: Any, h_N: Any, E_star: Any, c0: Any, k: Any) -> Any:
    """The retraction as printed, which has the dimension of a length to the power 3/2."""
    return mp.sqrt(2 * mp.pi * a * dgamma * c0**k * a ** (1 - k) / (E_star * h_N))


def retraction_corrected(a: Any, dgamma: Any, h_N: Any, E_star: Any, c0: Any, k: Any) -> Any:
    """The retraction, a length, from the constants of the medium."""
    return mp.sqrt(2 * mp.pi * dgamma * c0**k * a ** (1 - k) / (E_star * h_N))


def spring_energy(g: PowerSum, d: Any, a: Any, m: Medium) -> Any:
    """int c_N (d - g)**2 dx over (0, a), each product of powers integrated."""
    terms = ((d, mp.mpf(0)), *((-c, n) for c, n in g.terms))
    return m.H * mp.fsum(c * e * a ** (n + q + m.k + 1) / (n + q + m.k + 1) for c, n in terms for e, q in terms)


@equation(62, spring_stiffness, "the springs under a flat punch add up to (11.46)")
def check_spring_stiffness(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """The springs under a flat punch add up to its stiffness (11.46)."""
    a, m = draw.length(), medium(draw)
    dx = draw.length()
    total = panels(lambda x: formula(m.foundation(x), dx) / dx, -a, a, (mp.mpf(0),))
    yield Residual(2 * m.H * a ** (1 + m.k) / (1 + m.k), total, STIFFNESS)


@equation(63, energy_balance, "rates of the surface energy and of the elastic energy at fixed depth")
def check_energy_balance(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """Derivatives by a of pi a**2 dgamma and of the energy of the springs, times dx, beside the two sides."""
    g, a, dgamma, m = draw.power_sum(), draw.length(), draw.quantity(-1, 1), medium(draw)
    dx, dl = draw.length(), draw.length()
    surface, elastic = formula(a, dx, dgamma, m.foundation(a), dl)
    yield Residual(derivative(lambda x: mp.pi * x**2 * dgamma, a, a / 2) * dx, surface, ENERGY)
    d = g(a) - dl
    yield Residual(derivative(lambda x: spring_energy(g, d, x, m), a, a / 4) * dx, elastic, ENERGY)


def _is_stationary(g: PowerSum, a: Any, dgamma: Any, dl: Any, m: Medium) -> Residual:
    """The retraction at which the elastic energy falls as fast as the surface energy grows."""
    d = g(a) - dl
    released = derivative(lambda x: spring_energy(g, d, x, m), a, a / 4)
    return Residual(dl * mp.sqrt(2 * mp.pi * a * dgamma / released), dl, LENGTH)


@equation(64, retraction, "stationary energy of random powers")
def check_retraction(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """The retraction, rescaled until the springs release what the surface takes up, beside the formula."""
    g, a, dgamma, m = draw.power_sum(), draw.length(), draw.quantity(-1, 1), medium(draw)
    yield _is_stationary(g, a, dgamma, formula(a, dgamma, m.foundation(a)), m)


@equation(65, foundation_modulus, "value at c0; force of the springs against the closed pressure over the area")
def check_foundation_modulus(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """Stiffness per length at c0, and the force of the springs against the closed pressure over the area."""
    g, a, m = draw.power_sum(), draw.length(), medium(draw)
    yield Residual(m.h_N * m.E0 / (1 - m.nu**2), formula(-m.c0, m.h_N, m.E_star, m.c0, m.k), STRESS)

    def spring(x: Any) -> Any:
        return formula(x, m.h_N, m.E_star, m.c0, m.k) * (g(a) - g(abs(x)))

    yield Residual(total_force(lambda r: pressure(g, r, a, m.H, m.k), a), panels(spring, -a, a, (mp.mpf(0),)), FORCE)


@equation(
    66,
    retraction_printed,
    "(11.65) put into (11.64); stationary energy of random powers; limit k = 0 against (11.31)",
    corrected=retraction_corrected,
    printed_form="dl = sqrt(2 pi a dgamma c0^k a^(1-k) / (E* h_N))",
    right_form="dl = sqrt(2 pi dgamma c0^k a^(1-k) / (E* h_N))",
    reason="The power a^(1-k) holds the factor a already: as printed, dl is not in metres and misses (11.31) for k = 0",
)
def check_retraction_of_rigid(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """(11.64) with c_N put in, the balance of both energies, and (11.31) for k = 0, each beside the formula."""
    g, a, dgamma, m = draw.power_sum(), draw.length(), draw.quantity(-1, 1), medium(draw)
    constants = (m.h_N, m.E_star, m.c0, m.k)
    yield Residual(mp.sqrt(2 * mp.pi * a * dgamma / m.foundation(a)), formula(a, dgamma, *constants), LENGTH)
    yield _is_stationary(g, a, dgamma, formula(a, dgamma, *constants), m)
    homogeneous = formula(a, dgamma, mp.mpf(1), m.E_star, m.c0, mp.mpf(0))
    yield Residual(mp.sqrt(2 * mp.pi * a * dgamma / m.E_star), homogeneous, LENGTH)
