"""Bodies of axicontact.cohesive.sphere_tipped_cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, atan2, cos, exp, expm1, fsum, hypot, inf, sin, tanh

from ...._programs.bodies.normal import sphere_tipped_cone as normal
from ...._programs.bodies._runtime.interface import either
from ...._programs.bodies._runtime.physics.cohesive import alone, lift_of_zone, opening_beyond, opening_tip, outer_radius, root_near, root_of_zone, still, tension_of_zone
from ...._programs.bodies._runtime.physics.cohesive_states import parted, radii_by, radius_of_pull_off, radius_under
from ...._runtime.physics.cohesive_states import State
from ....cohesive.sphere_tipped_cone import partial
from ...._runtime.plain import log1p, sqrt, rule, MATH as np

TIP = 64
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def _opened(q, a, R, theta):
    """Gap of the normal contact at c, and its rate with c."""
    b = R * np.sin(theta)
    tip, tip_rate = opening_tip(lambda t: normal._slope(t, np.sqrt((R - t) * (R + t)), R), q, a, b, TIP)
    beyond, rate = opening_beyond(lambda t, root: normal._slope_beyond(t, root, R, theta), q, a, b)
    return (tip + beyond, tip_rate + rate)


def _zone(a, R, theta, E_star, dgamma, sigma_0):
    """sqrt(c**2 - a**2) of the zone."""
    return root_of_zone(partial(_opened, R=R, theta=theta), a, E_star, dgamma, sigma_0)


def _cohesive_radius(a, R, theta, E_star, dgamma, sigma_0):
    return outer_radius(_zone(a, R, theta, E_star, dgamma, sigma_0), a)


def _depth_of(a, q, R, theta, E_star, dgamma, sigma_0):
    v8 = R * sin(theta)
    v13 = R - a
    if a < v8:
        v45 = a * (log1p(2.0 * a / v13) / 2.0)
    else:
        v10 = R * cos(theta)
        v20 = v10 * v10 - v13 * (R + a) if v10 < v8 else (a - v8) * (a + v8)
        v23 = sqrt(v20 if v20 > 0.0 or v20 != v20 else 0.0)
        v26 = v8 * v8
        v45 = a * (log1p((v26 / (v23 + a) + v26 / (v10 + R)) / (v23 + v10)) + v8 * atan2(v23, v8) / v10)
    return v45 - 2.0 * (sigma_0 / E_star) * q


def _depth(a, R, theta, E_star, dgamma, sigma_0):
    return _depth_of(a, _zone(a, R, theta, E_star, dgamma, sigma_0), R, theta, E_star, dgamma, sigma_0)


def _force_of(a, q, R, theta, E_star, dgamma, sigma_0):
    v8 = R * sin(theta)
    v10 = R * cos(theta)
    v20 = v10 * v10 - (R - a) * (R + a) if v10 < v8 else (a - v8) * (a + v8)
    v23 = sqrt(v20 if v20 > 0.0 or v20 != v20 else 0.0)
    v24 = a if a < v8 or a != a else v8
    v32 = asinh(v24 / (sqrt((R - v24) * (v24 + R)) if a < v8 else v10))
    v37 = tanh(v32)
    if v32 < 1.0:
        v43 = v32 * v32
        v78 = v37 * (v37 * v37) * ((((((1.0716932453474512e-06 * v43 + 0.00019982814521087247) * v43 + 0.007076196047699156) * v43 + 0.08608622548411103) * v43 + 0.3073858328214721) * v43 + 0.3333333333333333) / (((((2.565078604208634e-08 * v43 + 2.0203143566039827e-05) * v43 + 0.001617010334189783) * v43 + 0.03639274880225476) * v43 + 0.32215749846441627) * v43 + 1.0))
    else:
        v78 = v32 - v37
    v86 = 1.0 - 2.0 * theta / 3.141592653589793
    v88 = asinh(v23 / v8)
    v92 = 0.0 - expm1(-2.0 * v88)
    v95 = v92 if v92 > 0.0 else inf
    v106 = v8 * v8
    v111 = v8 * v8
    v115 = v111 / (v10 + R)
    v123 = v111 * R
    v124 = v10 * v10
    v133 = []
    for node, weight in RULE_0(v88 / v86):
        v96 = node * v88
        v105 = v23 * (exp(-v96) * (0.0 - expm1(-2.0 * (v88 - v96))) / v95)
        v109 = sqrt(v106 + v105 * v105)
        v132 = (log1p((v111 / (v105 + v109) + v115) / (v105 + v10)) + v8 * atan2(v105, v8) / v10 + v123 / (v109 * v124 + R * v105 * v10)) * v105 * v109
        v133.append(weight * v132)
    v133 = fsum(v133) * v88
    v137 = hypot(a, q)
    return E_star * (v24 * v24 * v32 + R * R * v78) + 2.0 * E_star * v133 - 2.0 * sigma_0 * (v137 * v137 * atan2(q, a) + a * q)


def _force(a, R, theta, E_star, dgamma, sigma_0):
    return _force_of(a, _zone(a, R, theta, E_star, dgamma, sigma_0), R, theta, E_star, dgamma, sigma_0)


def _pressure_of(r, a, q, R, theta, E_star, dgamma, sigma_0):
    return normal._pressure(r, a, R, theta, E_star) - tension_of_zone(r, q, a, sigma_0)


def _pressure(r, a, R, theta, E_star, dgamma, sigma_0):
    return _pressure_of(r, a, _zone(a, R, theta, E_star, dgamma, sigma_0), R, theta, E_star, dgamma, sigma_0)


def _displacement_of(r, a, q, R, theta, E_star, dgamma, sigma_0):
    return normal._displacement(r, a, R, theta) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r, a, R, theta, E_star, dgamma, sigma_0):
    return _displacement_of(r, a, _zone(a, R, theta, E_star, dgamma, sigma_0), R, theta, E_star, dgamma, sigma_0)


def _radii(R, theta, E_star, dgamma, sigma_0):
    first = _zone(np.zeros_like(sigma_0), R, theta, E_star, dgamma, sigma_0)
    return radii_by(first, R * np.sin(theta))


def _state(a, start, R, theta, E_star, dgamma, sigma_0, control):
    q, rate = root_near(partial(_opened, R=R, theta=theta), start, a, E_star, dgamma, sigma_0)
    load = _force_of if control == 'force' else _depth_of
    return State(a, q, still(rate, a, q, control, E_star, sigma_0), load(a, q, R, theta, E_star, dgamma, sigma_0))


def _pull_off_radius(R, theta, E_star, dgamma, sigma_0, control):
    return radius_of_pull_off(lambda a, start: _state(a, start, R, theta, E_star, dgamma, sigma_0, control), _radii(R, theta, E_star, dgamma, sigma_0))


def _parted(R, theta, E_star, dgamma, sigma_0):
    first = _zone(np.zeros_like(sigma_0), R, theta, E_star, dgamma, sigma_0)
    return parted(partial(_opened, R=R, theta=theta), first, E_star, sigma_0)


def _pull_off_zone(a, R, theta, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: _zone(a, R, theta, E_star, dgamma, sigma_0), lambda: _parted(R, theta, E_star, dgamma, sigma_0) if a == 0.0 else np.nan)


def _pull_off_depth(a, q, R, theta, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: _depth_of(a, q, R, theta, E_star, dgamma, sigma_0), lambda: alone(partial(_opened, R=R, theta=theta), q, E_star, dgamma, sigma_0))


def _held_apart(d, R, theta, E_star, dgamma, sigma_0):
    apart = _pull_off_radius(R, theta, E_star, dgamma, sigma_0, 'depth') == 0.0
    deeper = d >= alone(partial(_opened, R=R, theta=theta), _parted(R, theta, E_star, dgamma, sigma_0), E_star, dgamma, sigma_0)
    return 0.0 if apart & deeper else np.nan


def _radius_from_depth(d, R, theta, E_star, dgamma, sigma_0):
    a = radius_under(lambda a, start: _state(a, start, R, theta, E_star, dgamma, sigma_0, 'depth'), d, _radii(R, theta, E_star, dgamma, sigma_0))
    return _held_apart(d, R, theta, E_star, dgamma, sigma_0) if np.isnan(a) else a


def _radius_from_force(F, R, theta, E_star, dgamma, sigma_0):
    return radius_under(lambda a, start: _state(a, start, R, theta, E_star, dgamma, sigma_0, 'force'), F, _radii(R, theta, E_star, dgamma, sigma_0))
