"""Bodies of axicontact.cohesive.cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan2, hypot, tan

from ...._programs.bodies.normal import cone as normal
from ...._programs.bodies._runtime.physics.cohesive import lift_of_zone, opening, outer_radius, root_of_zone
from ....cohesive.cone import partial
from ...._runtime.plain import log1p, sqrt


def _opened(q, a, theta):
    """Gap of the normal contact at c, and its rate with c."""
    return opening(lambda t: normal._slope(t, theta), q, a)


def _zone(a, theta, E_star, dgamma, sigma_0):
    """sqrt(c**2 - a**2) of the zone."""
    return root_of_zone(partial(_opened, theta=theta), a, E_star, dgamma, sigma_0)


def _cohesive_radius(a, theta, E_star, dgamma, sigma_0):
    return outer_radius(_zone(a, theta, E_star, dgamma, sigma_0), a)


def _pressure_of(r, q, a, theta, E_star, dgamma, sigma_0):
    v7 = a - r
    v8 = a + r
    v11 = r < a
    return (E_star * tan(theta) * log1p((v7 + sqrt(v7 * v8)) / r) / 2.0 if v11 else 0.0) - sigma_0 * (0.6366197723675814 * atan2(q, sqrt((v7 if v7 > 0.0 or v7 != v7 else 0.0) * v8)) if v11 else 1.0 if r < hypot(a, q) else 0.0)


def _pressure(r, a, theta, E_star, dgamma, sigma_0):
    return _pressure_of(r, _zone(a, theta, E_star, dgamma, sigma_0), a, theta, E_star, dgamma, sigma_0)


def _displacement_of(r, q, a, theta, E_star, dgamma, sigma_0):
    return normal._displacement(r, a, theta) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r, a, theta, E_star, dgamma, sigma_0):
    return _displacement_of(r, _zone(a, theta, E_star, dgamma, sigma_0), a, theta, E_star, dgamma, sigma_0)
