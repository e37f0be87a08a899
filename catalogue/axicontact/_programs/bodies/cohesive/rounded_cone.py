"""Bodies of axicontact.cohesive.rounded_cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan, atan2, hypot, tan

from ...._programs.bodies.normal import rounded_cone as normal
from ...._programs.bodies._runtime.interface import either
from ...._programs.bodies._runtime.physics.cohesive import alone, lift_of_zone, opening_beyond, opening_tip, outer_radius, root_of_zone, still
from ...._runtime.physics.cohesive_single import parted, radii_by, radius_of_pull_off, radius_under
from ....cohesive.rounded_cone import partial
from ...._runtime.plain import sqrt, MATH as np

SHORT = 16


def _opened(q, a, theta, b):
    """Gap of the normal contact at c, and its rate with c."""
    tip, tip_rate = opening_tip(lambda t: normal._slope(t, theta, b), q, a, b, SHORT)
    beyond, rate = opening_beyond(lambda t, root: normal._slope_beyond(t, root, theta, b), q, a, b)
    return (tip + beyond, tip_rate + rate)


def _zone(a, theta, b, E_star, dgamma, sigma_0):
    """sqrt(c**2 - a**2) of the zone."""
    return root_of_zone(partial(_opened, theta=theta, b=b), a, E_star, dgamma, sigma_0)


def _cohesive_radius(a, theta, b, E_star, dgamma, sigma_0):
    return outer_radius(_zone(a, theta, b, E_star, dgamma, sigma_0), a)


def _depth_of(a, q, theta, b, E_star, dgamma, sigma_0):
    v7 = tan(theta)
    if a < b:
        v24 = v7 / b * (a * a)
    else:
        v15 = sqrt((a - b) * (a + b))
        v24 = v7 * a * (atan(v15 / b) + b / (v15 + a))
    return v24 - 2.0 * (sigma_0 / E_star) * q


def _depth(a, theta, b, E_star, dgamma, sigma_0):
    return _depth_of(a, _zone(a, theta, b, E_star, dgamma, sigma_0), theta, b, E_star, dgamma, sigma_0)


def _force_of(a, q, theta, b, E_star, dgamma, sigma_0):
    v9 = tan(theta)
    v15 = a * a
    if a < b:
        v37 = 4.0 * E_star * v9 / (3.0 * b) * (a * v15)
    else:
        v21 = sqrt((a - b) * (a + b))
        v37 = E_star * v9 * (v15 * atan(v21 / b) + 4.0 * b * v15 / (3.0 * (v21 + a)) + b / 3.0 * v21)
    v38 = hypot(a, q)
    return v37 - 2.0 * sigma_0 * (v38 * v38 * atan2(q, a) + a * q)


def _force(a, theta, b, E_star, dgamma, sigma_0):
    return _force_of(a, _zone(a, theta, b, E_star, dgamma, sigma_0), theta, b, E_star, dgamma, sigma_0)


def _displacement_of(r, a, q, theta, b, E_star, dgamma, sigma_0):
    return normal._displacement(r, a, theta, b) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r, a, theta, b, E_star, dgamma, sigma_0):
    return _displacement_of(r, a, _zone(a, theta, b, E_star, dgamma, sigma_0), theta, b, E_star, dgamma, sigma_0)


def _radii(theta, b, E_star, dgamma, sigma_0):
    """Radii that separate the minima of the load."""
    first = _zone(np.zeros(1), theta, b, E_star, dgamma, sigma_0)
    return radii_by(first, b)


def _state(a, theta, b, E_star, dgamma, sigma_0, control):
    q = _zone(a, theta, b, E_star, dgamma, sigma_0)
    load = _force_of if control == 'force' else _depth_of
    return (still(partial(_opened, theta=theta, b=b), a, q, control, E_star, sigma_0), load(a, q, theta, b, E_star, dgamma, sigma_0))


def _pull_off_radius(theta, b, E_star, dgamma, sigma_0, control):
    return radius_of_pull_off(lambda a: _state(a, theta, b, E_star, dgamma, sigma_0, control), _radii(theta, b, E_star, dgamma, sigma_0))


def _parted(theta, b, E_star, dgamma, sigma_0):
    first = _zone(np.zeros(1), theta, b, E_star, dgamma, sigma_0)
    return parted(partial(_opened, theta=theta, b=b), first, E_star, sigma_0)


def _parted_depth(theta, b, E_star, dgamma, sigma_0):
    c = _parted(theta, b, E_star, dgamma, sigma_0)
    return alone(partial(_opened, theta=theta, b=b), c, E_star, dgamma, sigma_0)


def _pull_off_depth(a, theta, b, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: _depth(a, theta, b, E_star, dgamma, sigma_0), lambda: _parted_depth(theta, b, E_star, dgamma, sigma_0))


def _pull_off_force(a, theta, b, E_star, dgamma, sigma_0):
    return _force(a, theta, b, E_star, dgamma, sigma_0) if a > 0.0 else -np.pi * sigma_0 * _parted(theta, b, E_star, dgamma, sigma_0) ** 2


def _held_apart(d, theta, b, E_star, dgamma, sigma_0):
    apart = _pull_off_radius(theta, b, E_star, dgamma, sigma_0, 'depth') == 0.0
    deeper = d >= _pull_off_depth(np.zeros_like(d), theta, b, E_star, dgamma, sigma_0)
    return 0.0 if apart & deeper else np.nan


def _radius_from_depth(d, theta, b, E_star, dgamma, sigma_0):
    a = radius_under(lambda a: _state(a, theta, b, E_star, dgamma, sigma_0, 'depth'), d, _radii(theta, b, E_star, dgamma, sigma_0))
    return _held_apart(d, theta, b, E_star, dgamma, sigma_0) if np.isnan(a) else a


def _radius_from_force(F, theta, b, E_star, dgamma, sigma_0):
    return radius_under(lambda a: _state(a, theta, b, E_star, dgamma, sigma_0, 'force'), F, _radii(theta, b, E_star, dgamma, sigma_0))
