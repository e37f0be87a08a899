"""Bodies of axicontact.cohesive.truncated_paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan2, hypot

from ...._programs.bodies.normal import truncated_paraboloid as normal
from ...._programs.bodies._runtime.interface import either
from ...._programs.bodies._runtime.physics.cohesive import alone, lift_of_zone, opening_beyond, outer_radius, root_of_zone, still
from ...._runtime.physics.cohesive_single import parted, radii_by, radius_of_pull_off, radius_under
from ....cohesive.truncated_paraboloid import partial
from ...._runtime.plain import sqrt, MATH as np


def _opened(q, a, R, b):
    """Gap of the normal contact at c, and its rate with c."""
    beyond, rate = opening_beyond(lambda t, root: normal._slope_beyond(t, root, R, b), q, a, b)
    return (beyond, rate)


def _zone(a, R, b, E_star, dgamma, sigma_0):
    """sqrt(c**2 - a**2) of the zone."""
    return root_of_zone(partial(_opened, R=R, b=b), a, E_star, dgamma, sigma_0)


def _cohesive_radius(a, R, b, E_star, dgamma, sigma_0):
    return outer_radius(_zone(a, R, b, E_star, dgamma, sigma_0), a)


def _depth_of(a, q, R, b, E_star, dgamma, sigma_0):
    return (0.0 if a < b else a * sqrt((a - b) * (a + b)) / R) - 2.0 * (sigma_0 / E_star) * q


def _depth(a, R, b, E_star, dgamma, sigma_0):
    return _depth_of(a, _zone(a, R, b, E_star, dgamma, sigma_0), R, b, E_star, dgamma, sigma_0)


def _force_of(a, q, R, b, E_star, dgamma, sigma_0):
    v25 = hypot(a, q)
    return (0.0 if a < b else 2.0 * E_star / (3.0 * R) * (2.0 * (a * a) + b * b) * sqrt((a - b) * (a + b))) - 2.0 * sigma_0 * (v25 * v25 * atan2(q, a) + a * q)


def _force(a, R, b, E_star, dgamma, sigma_0):
    return _force_of(a, _zone(a, R, b, E_star, dgamma, sigma_0), R, b, E_star, dgamma, sigma_0)


def _displacement_of(r, a, q, R, b, E_star, dgamma, sigma_0):
    return (0.0 if a < b else normal._displacement(r, a, R, b)) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r, a, R, b, E_star, dgamma, sigma_0):
    return _displacement_of(r, a, _zone(a, R, b, E_star, dgamma, sigma_0), R, b, E_star, dgamma, sigma_0)


def _radii(R, b, E_star, dgamma, sigma_0):
    """Radii that separate the minima of the load."""
    first = _zone(np.zeros(1), R, b, E_star, dgamma, sigma_0)
    return radii_by(first, b)


def _state(a, R, b, E_star, dgamma, sigma_0, control):
    q = _zone(a, R, b, E_star, dgamma, sigma_0)
    load = _force_of if control == 'force' else _depth_of
    return (still(partial(_opened, R=R, b=b), a, q, control, E_star, sigma_0), load(a, q, R, b, E_star, dgamma, sigma_0))


def _pull_off_radius(R, b, E_star, dgamma, sigma_0, control):
    return radius_of_pull_off(lambda a: _state(a, R, b, E_star, dgamma, sigma_0, control), _radii(R, b, E_star, dgamma, sigma_0))


def _parted(R, b, E_star, dgamma, sigma_0):
    first = _zone(np.zeros(1), R, b, E_star, dgamma, sigma_0)
    return parted(partial(_opened, R=R, b=b), first, E_star, sigma_0)


def _parted_depth(R, b, E_star, dgamma, sigma_0):
    c = _parted(R, b, E_star, dgamma, sigma_0)
    return alone(partial(_opened, R=R, b=b), c, E_star, dgamma, sigma_0)


def _pull_off_depth(a, R, b, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: _depth(a, R, b, E_star, dgamma, sigma_0), lambda: _parted_depth(R, b, E_star, dgamma, sigma_0))


def _pull_off_force(a, R, b, E_star, dgamma, sigma_0):
    return _force(a, R, b, E_star, dgamma, sigma_0) if a > 0.0 else -np.pi * sigma_0 * _parted(R, b, E_star, dgamma, sigma_0) ** 2


def _held_apart(d, R, b, E_star, dgamma, sigma_0):
    apart = _pull_off_radius(R, b, E_star, dgamma, sigma_0, 'depth') == 0.0
    deeper = d >= _pull_off_depth(np.zeros_like(d), R, b, E_star, dgamma, sigma_0)
    return 0.0 if apart & deeper else np.nan


def _radius_from_depth(d, R, b, E_star, dgamma, sigma_0):
    a = radius_under(lambda a: _state(a, R, b, E_star, dgamma, sigma_0, 'depth'), d, _radii(R, b, E_star, dgamma, sigma_0))
    return _held_apart(d, R, b, E_star, dgamma, sigma_0) if np.isnan(a) else a


def _radius_from_force(F, R, b, E_star, dgamma, sigma_0):
    return radius_under(lambda a: _state(a, R, b, E_star, dgamma, sigma_0, 'force'), F, _radii(R, b, E_star, dgamma, sigma_0))
