"""Bodies of axicontact.cohesive.sphere over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, atan2, cos, cosh, fsum, hypot, inf, sin, sinh

from ...._programs.bodies.normal import sphere as normal
from ...._programs.bodies._runtime.integrals import difference_root
from ...._programs.bodies._runtime.interface import either
from ...._programs.bodies._runtime.physics.cohesive import alone, lift_of_zone, outer_radius, root_of_zone, tension_of_zone, zone_like, zone_within
from ...._programs.bodies._runtime.physics.cohesive_states import parted, radii_up_to, radius_of_pull_off, radius_under, state_near
from ....cohesive.sphere import partial
from ...._runtime.plain import log1p, sqrt, rule, MATH as np

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64), (18.03, 128)))


def _opened(q, a, R):
    v3 = hypot(a, q)
    v5 = R - a
    v10 = sqrt((v5 if v5 > 0.0 or v5 != v5 else 0.0) * (R + a))
    v11 = v10 - q
    v15 = sqrt((v11 if v11 > 0.0 or v11 != v11 else 0.0) * (v10 + q))
    v17 = asinh(v15 / v3)
    v18 = v17 > 0.0
    v20 = v17 if v18 else 1.0
    v22 = asinh(atan2(q, a) / v20)
    v45 = []
    v46 = []
    if abs(v22) > 0.0:
        for node, weight in RULE_0(v22 / 0.7):
            v24 = node * v22
            v26 = v20 * sinh(v24)
            v27 = sin(v26)
            v28 = cos(v26)
            v29 = v3 * v28
            v31 = hypot(v15, v3 * v27)
            v41 = (asinh(v29 / v31) + R * v29 / (v31 * v31)) * v20 * cosh(v24)
            v43 = v41 * v26 * v27
            v44 = v41 * v28
            v45.append(weight * v43)
            v46.append(weight * v44)
    v45 = fsum(v45) * v22
    v46 = fsum(v46) * v22
    v49 = 0.6366197723675814 if v18 else inf
    return (v49 * v3 * v45, v49 * v46)


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


def _growth(a, R):
    if a > 0.0:
        v4 = R - a
        v8 = sqrt((v4 if v4 > 0.0 or v4 != v4 else 0.0) * (R + a))
        return asinh(a / v8) + R * a / (v8 * v8)
    return 0.0


def _radii(R, E_star, dgamma, sigma_0):
    a = np.zeros_like(sigma_0)
    largest = difference_root(R, a)
    a = zone_within(partial(_opened, R=R), a, E_star, dgamma, sigma_0, largest)
    first = np.nan if np.isnan(a) else zone_like(partial(_opened, R=R), a, E_star, dgamma, sigma_0, largest)
    return radii_up_to(first, R)


def _state(a, start, R, E_star, dgamma, sigma_0, control):
    growth = _growth(a, R)
    return state_near(partial(_opened, R=R), growth, start, a, control, E_star, dgamma, sigma_0, difference_root(R, a))


def _pull_off_radius(R, E_star, dgamma, sigma_0, control):
    load = _force_of if control == 'force' else _depth_of
    return radius_of_pull_off(lambda a, start: _state(a, start, R, E_star, dgamma, sigma_0, control), lambda a, q: load(a, q, R, E_star, dgamma, sigma_0), _radii(R, E_star, dgamma, sigma_0))


def _parted(R, E_star, dgamma, sigma_0):
    first = _zone(np.zeros_like(sigma_0), R, E_star, dgamma, sigma_0)
    return parted(partial(_opened, R=R), first, E_star, sigma_0)


def _pull_off_zone(a, R, E_star, dgamma, sigma_0):
    largest = difference_root(R, a)
    return either(a > 0.0, lambda: root_of_zone(partial(_opened, R=R), a, E_star, dgamma, sigma_0, largest), lambda: _parted(R, E_star, dgamma, sigma_0) if a == 0.0 else np.nan)


def _pull_off_depth(a, q, R, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: _depth_of(a, q, R, E_star, dgamma, sigma_0), lambda: alone(partial(_opened, R=R), q, E_star, dgamma, sigma_0))


def _held_apart(d, R, E_star, dgamma, sigma_0):
    apart = _pull_off_radius(R, E_star, dgamma, sigma_0, 'depth') == 0.0
    deeper = d >= alone(partial(_opened, R=R), _parted(R, E_star, dgamma, sigma_0), E_star, dgamma, sigma_0)
    return 0.0 if apart & deeper else np.nan


def _radius_from_depth(d, R, E_star, dgamma, sigma_0):
    a = radius_under(lambda a, start: _state(a, start, R, E_star, dgamma, sigma_0, 'depth'), lambda a, q: _depth_of(a, q, R, E_star, dgamma, sigma_0), d, _radii(R, E_star, dgamma, sigma_0))
    return _held_apart(d, R, E_star, dgamma, sigma_0) if np.isnan(a) else a


def _radius_from_force(F, R, E_star, dgamma, sigma_0):
    return radius_under(lambda a, start: _state(a, start, R, E_star, dgamma, sigma_0, 'force'), lambda a, q: _force_of(a, q, R, E_star, dgamma, sigma_0), F, _radii(R, E_star, dgamma, sigma_0))
