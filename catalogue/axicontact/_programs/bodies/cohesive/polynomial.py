"""Bodies of axicontact.cohesive.polynomial over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import polynomial as normal
from ...._programs.bodies._runtime.integrals import difference_root
from ...._programs.bodies._runtime.physics.cohesive import alone, lift_of_zone, opening, outer_radius, root_of_zone, sunk, tension_of_zone, work_of_zone
from ....cohesive.polynomial import partial
from ...._runtime.plain import MATH as np


def _opened(q, a, A):
    """Gap of the normal contact at c, and its rate with c."""
    return opening(lambda t: normal._slope(t, A), q, a)


def _zone(a, A, E_star, dgamma, sigma_0):
    """sqrt(c**2 - a**2) of the zone."""
    return root_of_zone(partial(_opened, A=A), a, E_star, dgamma, sigma_0)


def _work_of_separation(a, c, A, E_star, sigma_0):
    return work_of_zone(partial(_opened, A=A), difference_root(c, a), a, E_star, sigma_0)


def _cohesive_radius(a, A, E_star, dgamma, sigma_0):
    return outer_radius(_zone(a, A, E_star, dgamma, sigma_0), a)


def _pressure_of(r, q, a, A, E_star, dgamma, sigma_0):
    return normal._pressure(r, a, A, E_star) - tension_of_zone(r, q, a, sigma_0)


def _pressure(r, a, A, E_star, dgamma, sigma_0):
    return _pressure_of(r, _zone(a, A, E_star, dgamma, sigma_0), a, A, E_star, dgamma, sigma_0)


def _displacement_of(r, q, a, A, E_star, dgamma, sigma_0):
    return normal._displacement(r, a, A) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r, a, A, E_star, dgamma, sigma_0):
    return _displacement_of(r, _zone(a, A, E_star, dgamma, sigma_0), a, A, E_star, dgamma, sigma_0)


def _without_contact_depth(c, A, E_star, dgamma, sigma_0):
    depth = alone(partial(_opened, A=A), c, E_star, dgamma, sigma_0)
    return depth if depth <= -sunk(c, E_star, sigma_0) else np.nan


def _without_contact_force(c, A, E_star, dgamma, sigma_0):
    depth = alone(partial(_opened, A=A), c, E_star, dgamma, sigma_0)
    return -np.pi * sigma_0 * c * c if depth <= -sunk(c, E_star, sigma_0) else np.nan
