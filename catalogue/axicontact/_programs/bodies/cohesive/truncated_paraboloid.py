"""Bodies of axicontact.cohesive.truncated_paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import truncated_paraboloid as normal
from ...._programs.bodies._runtime.integrals import difference_root
from ...._programs.bodies._runtime.physics.cohesive import alone, lift_of_zone, opening_beyond, outer_radius, root_of_zone, sunk, work_of_zone
from ....cohesive.truncated_paraboloid import partial
from ...._runtime.plain import MATH as np


def _opened(q, a, R, b):
    """Gap of the normal contact at c, and its rate with c."""
    beyond, rate = opening_beyond(lambda t, root: normal._slope_beyond(t, root, R, b), q, a, b)
    return (beyond, rate)


def _zone(a, R, b, E_star, dgamma, sigma_0):
    """sqrt(c**2 - a**2) of the zone."""
    return root_of_zone(partial(_opened, R=R, b=b), a, E_star, dgamma, sigma_0)


def _work_of_separation(a, c, R, b, E_star, sigma_0):
    return work_of_zone(partial(_opened, R=R, b=b), difference_root(c, a), a, E_star, sigma_0)


def _cohesive_radius(a, R, b, E_star, dgamma, sigma_0):
    return outer_radius(_zone(a, R, b, E_star, dgamma, sigma_0), a)


def _displacement_of(r, q, a, R, b, E_star, dgamma, sigma_0):
    return (0.0 if a < b else normal._displacement(r, a, R, b)) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r, a, R, b, E_star, dgamma, sigma_0):
    return _displacement_of(r, _zone(a, R, b, E_star, dgamma, sigma_0), a, R, b, E_star, dgamma, sigma_0)


def _without_contact_depth(c, R, b, E_star, dgamma, sigma_0):
    depth = alone(partial(_opened, R=R, b=b), c, E_star, dgamma, sigma_0)
    return depth if depth <= -sunk(c, E_star, sigma_0) else np.nan


def _without_contact_force(c, R, b, E_star, dgamma, sigma_0):
    depth = alone(partial(_opened, R=R, b=b), c, E_star, dgamma, sigma_0)
    return -np.pi * sigma_0 * c * c if depth <= -sunk(c, E_star, sigma_0) else np.nan
