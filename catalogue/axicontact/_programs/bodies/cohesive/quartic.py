"""Bodies of axicontact.cohesive.quartic over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan2, hypot

from ...._programs.bodies.normal import quartic as normal
from ...._programs.bodies._runtime.physics.cohesive import lift_of_zone, opening, outer_radius, root_of_zone
from ....cohesive.quartic import partial
from ...._runtime.plain import sqrt


def _opened(q, a, A):
    """Gap of the normal contact at c, and its rate with c."""
    return opening(lambda t: normal._slope(t, A), q, a)


def _zone(a, A, E_star, dgamma, sigma_0):
    """sqrt(c**2 - a**2) of the zone."""
    return root_of_zone(partial(_opened, A=A), a, E_star, dgamma, sigma_0)


def _cohesive_radius(a, A, E_star, dgamma, sigma_0):
    return outer_radius(_zone(a, A, E_star, dgamma, sigma_0), a)


def _pressure_of(r, q, a, A, E_star, dgamma, sigma_0):
    v7 = a - r
    v8 = a + r
    v11 = r < a
    return (32.0 * E_star * A / 28.274333882308138 * (a * a + 2.0 * (r * r)) * sqrt(v7 * v8) if v11 else 0.0) - sigma_0 * (0.6366197723675814 * atan2(q, sqrt((v7 if v7 > 0.0 or v7 != v7 else 0.0) * v8)) if v11 else 1.0 if r < hypot(a, q) else 0.0)


def _pressure(r, a, A, E_star, dgamma, sigma_0):
    return _pressure_of(r, _zone(a, A, E_star, dgamma, sigma_0), a, A, E_star, dgamma, sigma_0)


def _displacement_of(r, q, a, A, E_star, dgamma, sigma_0):
    return normal._displacement(r, a, A) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r, a, A, E_star, dgamma, sigma_0):
    return _displacement_of(r, _zone(a, A, E_star, dgamma, sigma_0), a, A, E_star, dgamma, sigma_0)
