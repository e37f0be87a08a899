"""Bodies of axicontact.cohesive.polynomial over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import inf

from ...._programs.bodies.normal import polynomial as normal
from ...._programs.bodies._runtime.functions import depth_over_height
from ...._programs.bodies._runtime.integrals import difference_root
from ...._programs.bodies._runtime.interface import either
from ...._programs.bodies._runtime.physics.cohesive import alone, lift_of_zone, opening, outer_radius, pull_of_zone, root_of_zone, sunk, tension_of_zone, work_of_zone, zone_like
from ...._programs.bodies._runtime.physics.cohesive_states import parted, radii, radius_of_pull_off, radius_under, state_near
from ....cohesive.polynomial import partial
from ...._runtime.plain import MATH as np

ENTIRE = ((0.5, 16,), (inf, 32,),)


def _opened(q, a, A):
    """Gap of the normal contact at c, and its rate with c."""
    terms = [(j - 1, j * depth_over_height(j) * A_j) for j, A_j in enumerate(A, 1)]
    return opening(lambda t: sum((rate * t ** power for power, rate in terms)), q, a, ENTIRE)


def _zone(a, A, E_star, dgamma, sigma_0):
    """sqrt(c**2 - a**2) of the zone."""
    return root_of_zone(partial(_opened, A=A), a, E_star, dgamma, sigma_0)


def _work_of_separation(a, c, A, E_star, sigma_0):
    return work_of_zone(partial(_opened, A=A), difference_root(c, a), a, E_star, sigma_0)


def _cohesive_radius(a, A, E_star, dgamma, sigma_0):
    return outer_radius(_zone(a, A, E_star, dgamma, sigma_0), a)


def _depth_of(a, q, A, E_star, dgamma, sigma_0):
    return normal._depth(a, A) - sunk(q, E_star, sigma_0)


def _depth(a, A, E_star, dgamma, sigma_0):
    return _depth_of(a, _zone(a, A, E_star, dgamma, sigma_0), A, E_star, dgamma, sigma_0)


def _force_of(a, q, A, E_star, dgamma, sigma_0):
    return normal._force(a, A, E_star) - pull_of_zone(q, a, sigma_0)


def _force(a, A, E_star, dgamma, sigma_0):
    return _force_of(a, _zone(a, A, E_star, dgamma, sigma_0), A, E_star, dgamma, sigma_0)


def _pressure_of(r, a, q, A, E_star, dgamma, sigma_0):
    return normal._pressure(r, a, A, E_star) - tension_of_zone(r, q, a, sigma_0)


def _pressure(r, a, A, E_star, dgamma, sigma_0):
    return _pressure_of(r, a, _zone(a, A, E_star, dgamma, sigma_0), A, E_star, dgamma, sigma_0)


def _displacement_of(r, a, q, A, E_star, dgamma, sigma_0):
    return normal._displacement(r, a, A) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r, a, A, E_star, dgamma, sigma_0):
    return _displacement_of(r, a, _zone(a, A, E_star, dgamma, sigma_0), A, E_star, dgamma, sigma_0)


def _growth(a, A):
    """Rate g'(a) of the depth of the normal contact."""
    return normal._slope(a, A) if a > 0.0 else 0.0


def _radii(A, E_star, dgamma, sigma_0):
    a = np.zeros_like(sigma_0)
    first = zone_like(partial(_opened, A=A), a, E_star, dgamma, sigma_0)
    return radii(first)


def _state(a, start, A, E_star, dgamma, sigma_0, control):
    growth = _growth(a, A)
    return state_near(partial(_opened, A=A), growth, start, a, control, E_star, dgamma, sigma_0)


def _pull_off_radius(A, E_star, dgamma, sigma_0, control):
    load = _force_of if control == 'force' else _depth_of
    return radius_of_pull_off(lambda a, start: _state(a, start, A, E_star, dgamma, sigma_0, control), lambda a, q: load(a, q, A, E_star, dgamma, sigma_0), _radii(A, E_star, dgamma, sigma_0))


def _parted(A, E_star, dgamma, sigma_0):
    first = _zone(np.zeros_like(sigma_0), A, E_star, dgamma, sigma_0)
    return parted(partial(_opened, A=A), first, E_star, sigma_0)


def _pull_off_zone(a, A, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: root_of_zone(partial(_opened, A=A), a, E_star, dgamma, sigma_0), lambda: _parted(A, E_star, dgamma, sigma_0) if a == 0.0 else np.nan)


def _pull_off_depth(a, q, A, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: _depth_of(a, q, A, E_star, dgamma, sigma_0), lambda: alone(partial(_opened, A=A), q, E_star, dgamma, sigma_0))


def _without_contact_depth(c, A, E_star, dgamma, sigma_0):
    depth = alone(partial(_opened, A=A), c, E_star, dgamma, sigma_0)
    return depth if depth <= -sunk(c, E_star, sigma_0) else np.nan


def _without_contact_force(c, A, E_star, dgamma, sigma_0):
    depth = alone(partial(_opened, A=A), c, E_star, dgamma, sigma_0)
    return -np.pi * sigma_0 * c * c if depth <= -sunk(c, E_star, sigma_0) else np.nan


def _held_apart(d, A, E_star, dgamma, sigma_0):
    apart = _pull_off_radius(A, E_star, dgamma, sigma_0, 'depth') == 0.0
    deeper = d >= alone(partial(_opened, A=A), _parted(A, E_star, dgamma, sigma_0), E_star, dgamma, sigma_0)
    return 0.0 if apart & deeper else np.nan


def _radius_from_depth(d, A, E_star, dgamma, sigma_0):
    a = radius_under(lambda a, start: _state(a, start, A, E_star, dgamma, sigma_0, 'depth'), lambda a, q: _depth_of(a, q, A, E_star, dgamma, sigma_0), d, _radii(A, E_star, dgamma, sigma_0))
    return _held_apart(d, A, E_star, dgamma, sigma_0) if np.isnan(a) else a


def _radius_from_force(F, A, E_star, dgamma, sigma_0):
    return radius_under(lambda a, start: _state(a, start, A, E_star, dgamma, sigma_0, 'force'), lambda a, q: _force_of(a, q, A, E_star, dgamma, sigma_0), F, _radii(A, E_star, dgamma, sigma_0))
