"""Bodies of axicontact.cohesive.capped_paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import capped_paraboloid as normal
from ...._programs.bodies._runtime.integrals import difference_root
from ...._programs.bodies._runtime.physics.cohesive import alone, lift_of_zone, opening_beyond, opening_tip, outer_radius, root_of_zone, sunk, work_of_zone
from ....cohesive.capped_paraboloid import partial
from ...._runtime.plain import MATH as np


def _opened(q, a, R1, R2, b):
    """Gap of the normal contact at c, and its rate with c."""
    tip, tip_rate = opening_tip(lambda t: normal._slope(t, R1), q, a, b)
    beyond, rate = opening_beyond(lambda t, root: normal._slope_beyond(t, root, R1, R2, b), q, a, b)
    return (tip + beyond, tip_rate + rate)


def _zone(a, R1, R2, b, E_star, dgamma, sigma_0):
    """sqrt(c**2 - a**2) of the zone."""
    return root_of_zone(partial(_opened, R1=R1, R2=R2, b=b), a, E_star, dgamma, sigma_0)


def _work_of_separation(a, c, R1, R2, b, E_star, sigma_0):
    return work_of_zone(partial(_opened, R1=R1, R2=R2, b=b), difference_root(c, a), a, E_star, sigma_0)


def _cohesive_radius(a, R1, R2, b, E_star, dgamma, sigma_0):
    return outer_radius(_zone(a, R1, R2, b, E_star, dgamma, sigma_0), a)


def _displacement_of(r, q, a, R1, R2, b, E_star, dgamma, sigma_0):
    return normal._displacement(r, a, R1, R2, b) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r, a, R1, R2, b, E_star, dgamma, sigma_0):
    return _displacement_of(r, _zone(a, R1, R2, b, E_star, dgamma, sigma_0), a, R1, R2, b, E_star, dgamma, sigma_0)


def _without_contact_depth(c, R1, R2, b, E_star, dgamma, sigma_0):
    depth = alone(partial(_opened, R1=R1, R2=R2, b=b), c, E_star, dgamma, sigma_0)
    return depth if depth <= -sunk(c, E_star, sigma_0) else np.nan


def _without_contact_force(c, R1, R2, b, E_star, dgamma, sigma_0):
    depth = alone(partial(_opened, R1=R1, R2=R2, b=b), c, E_star, dgamma, sigma_0)
    return -np.pi * sigma_0 * c * c if depth <= -sunk(c, E_star, sigma_0) else np.nan
