"""Bodies of axicontact.cohesive.rounded_punch over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan, atan2, hypot

from ...._programs.bodies.normal import rounded_punch as normal
from ...._programs.bodies._runtime.interface import either
from ...._programs.bodies._runtime.physics.cohesive import alone, lift_of_zone, opening_beyond, outer_radius, root_of_zone, still
from ...._runtime.physics.cohesive_single import parted, radii_by, radius_of_pull_off, radius_under
from ....cohesive.rounded_punch import partial
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
    if a < b:
        v60 = 0.0
    else:
        v10 = a - b
        v11 = v10 / b
        if v11 < 0.42:
            v57 = v11 * sqrt(v11) * ((((((0.0005288491342179178 * v11 + 0.038096760299703034) * v11 + 0.4065213849117787) * v11 + 1.438682033198726) * v11 + 1.9979042349620892) * v11 + 0.9428090415820634) / (((((0.006421883194715949 * v11 + 0.15001504718401248) * v11 + 0.9450913324352289) * v11 + 2.37401087025821) * v11 + 2.569097449054519) * v11 + 1.0))
        else:
            v17 = sqrt(v10 * (a + b)) / b
            v57 = v17 - atan(v17)
        v60 = b / R * a * v57
    return v60 - 2.0 * (sigma_0 / E_star) * q


def _depth(a, R, b, E_star, dgamma, sigma_0):
    return _depth_of(a, _zone(a, R, b, E_star, dgamma, sigma_0), R, b, E_star, dgamma, sigma_0)


def _force_of(a, q, R, b, E_star, dgamma, sigma_0):
    if a < b:
        v67 = 0.0
    else:
        v8 = a - b
        v10 = v8 * (a + b)
        v11 = sqrt(v10)
        v16 = v8 / b
        if v16 < 0.42:
            v59 = v16 * sqrt(v16) * ((((((0.0005288491342179178 * v16 + 0.038096760299703034) * v16 + 0.4065213849117787) * v16 + 1.438682033198726) * v16 + 1.9979042349620892) * v16 + 0.9428090415820634) / (((((0.006421883194715949 * v16 + 0.15001504718401248) * v16 + 0.9450913324352289) * v16 + 2.37401087025821) * v16 + 2.569097449054519) * v16 + 1.0))
        else:
            v19 = v11 / b
            v59 = v19 - atan(v19)
        v67 = E_star / R * (b * (a * a) * v59 + v10 * v11 / 3.0)
    v68 = hypot(a, q)
    return v67 - 2.0 * sigma_0 * (v68 * v68 * atan2(q, a) + a * q)


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
