"""Bodies of axicontact.cohesive.sphere over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan2, hypot

from ...._programs.bodies.normal import sphere as normal
from ...._programs.bodies._runtime.integrals import difference_root
from ...._programs.bodies._runtime.interface import either
from ...._programs.bodies._runtime.physics.cohesive import alone, lift_of_zone, opening_below, outer_radius, root_near, root_of_zone, still, tension_of_zone, zone_within
from ...._programs.bodies._runtime.physics.cohesive_states import parted, radii_up_to, radius_of_pull_off, radius_under
from ...._runtime.physics.cohesive_states import State
from ....cohesive.sphere import partial
from ...._runtime.plain import log1p, MATH as np


def _opened(q, a, R):
    """Gap of the normal contact at c, and its rate with c."""
    return opening_below(lambda t, root: normal._slope(t, root, R), q, a, R)


def _zone(a, R, E_star, dgamma, sigma_0):
    """sqrt(c**2 - a**2) of the zone."""
    largest = difference_root(R, a)
    a = zone_within(partial(_opened, R=R), a, E_star, dgamma, sigma_0, largest)
    return np.nan if np.isnan(a) else root_of_zone(partial(_opened, R=R), a, E_star, dgamma, sigma_0, largest)


def _cohesive_radius(a, R, E_star, dgamma, sigma_0):
    return outer_radius(_zone(a, R, E_star, dgamma, sigma_0), a)


def _depth_of(a, q, R, E_star, dgamma, sigma_0):
    return a * (log1p(2.0 * a / (R - a)) / 2.0) - 2.0 * (sigma_0 / E_star) * q


def _depth(a, R, E_star, dgamma, sigma_0):
    return _depth_of(a, _zone(a, R, E_star, dgamma, sigma_0), R, E_star, dgamma, sigma_0)


def _force_of(a, q, R, E_star, dgamma, sigma_0):
    v11 = log1p(2.0 * a / (R - a)) / 2.0
    v15 = a / R
    if v11 < 1.0:
        v21 = v11 * v11
        v56 = v15 * (v15 * v15) * ((((((1.0716932453474512e-06 * v21 + 0.00019982814521087247) * v21 + 0.007076196047699156) * v21 + 0.08608622548411103) * v21 + 0.3073858328214721) * v21 + 0.3333333333333333) / (((((2.565078604208634e-08 * v21 + 2.0203143566039827e-05) * v21 + 0.001617010334189783) * v21 + 0.03639274880225476) * v21 + 0.32215749846441627) * v21 + 1.0))
    else:
        v56 = v11 - v15
    v60 = hypot(a, q)
    return E_star * (a * a * v11 + R * R * v56) - 2.0 * sigma_0 * (v60 * v60 * atan2(q, a) + a * q)


def _force(a, R, E_star, dgamma, sigma_0):
    return _force_of(a, _zone(a, R, E_star, dgamma, sigma_0), R, E_star, dgamma, sigma_0)


def _pressure_of(r, a, q, R, E_star, dgamma, sigma_0):
    return normal._pressure(r, a, R, E_star) - tension_of_zone(r, q, a, sigma_0)


def _pressure(r, a, R, E_star, dgamma, sigma_0):
    return _pressure_of(r, a, _zone(a, R, E_star, dgamma, sigma_0), R, E_star, dgamma, sigma_0)


def _displacement_of(r, a, q, R, E_star, dgamma, sigma_0):
    return normal._displacement(r, a, R) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r, a, R, E_star, dgamma, sigma_0):
    return _displacement_of(r, a, _zone(a, R, E_star, dgamma, sigma_0), R, E_star, dgamma, sigma_0)


def _radii(R, E_star, dgamma, sigma_0):
    first = _zone(np.zeros_like(sigma_0), R, E_star, dgamma, sigma_0)
    return radii_up_to(first, R, lambda a: zone_within(partial(_opened, R=R), a, E_star, dgamma, sigma_0, difference_root(R, a)))


def _state(a, start, R, E_star, dgamma, sigma_0, control):
    q, rate = root_near(partial(_opened, R=R), start, a, E_star, dgamma, sigma_0, difference_root(R, a))
    load = _force_of if control == 'force' else _depth_of
    return State(a, q, still(rate, a, q, control, E_star, sigma_0), load(a, q, R, E_star, dgamma, sigma_0))


def _pull_off_radius(R, E_star, dgamma, sigma_0, control):
    return radius_of_pull_off(lambda a, start: _state(a, start, R, E_star, dgamma, sigma_0, control), _radii(R, E_star, dgamma, sigma_0))


def _parted(R, E_star, dgamma, sigma_0):
    first = _zone(np.zeros_like(sigma_0), R, E_star, dgamma, sigma_0)
    return parted(partial(_opened, R=R), first, E_star, sigma_0)


def _pull_off_zone(a, R, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: _zone(a, R, E_star, dgamma, sigma_0), lambda: _parted(R, E_star, dgamma, sigma_0) if a == 0.0 else np.nan)


def _pull_off_depth(a, q, R, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: _depth_of(a, q, R, E_star, dgamma, sigma_0), lambda: alone(partial(_opened, R=R), q, E_star, dgamma, sigma_0))


def _held_apart(d, R, E_star, dgamma, sigma_0):
    apart = _pull_off_radius(R, E_star, dgamma, sigma_0, 'depth') == 0.0
    deeper = d >= alone(partial(_opened, R=R), _parted(R, E_star, dgamma, sigma_0), E_star, dgamma, sigma_0)
    return 0.0 if apart & deeper else np.nan


def _radius_from_depth(d, R, E_star, dgamma, sigma_0):
    a = radius_under(lambda a, start: _state(a, start, R, E_star, dgamma, sigma_0, 'depth'), d, _radii(R, E_star, dgamma, sigma_0))
    return _held_apart(d, R, E_star, dgamma, sigma_0) if np.isnan(a) else a


def _radius_from_force(F, R, E_star, dgamma, sigma_0):
    return radius_under(lambda a, start: _state(a, start, R, E_star, dgamma, sigma_0, 'force'), F, _radii(R, E_star, dgamma, sigma_0))
