"""Bodies of axicontact.cohesive.sphere_tipped_cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, atan2, cos, cosh, exp, expm1, fsum, hypot, inf, sin, sinh, tanh

from ...._programs.bodies.normal import sphere_tipped_cone as normal
from ...._programs.bodies._runtime.interface import either
from ...._programs.bodies._runtime.physics.cohesive import alone, lift_of_zone, outer_radius, root_of_zone, tension_of_zone, zone_like
from ...._programs.bodies._runtime.physics.cohesive_states import parted_by, radii_by, radius_of_pull_off, radius_under, state_near
from ....cohesive.sphere_tipped_cone import partial
from ...._runtime.plain import log1p, sqrt, rule, MATH as np

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))
RULE_1 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64), (18.03, 128)))


def _opened(q, a, R, theta):
    v5 = R * sin(theta)
    v6 = hypot(a, q)
    v7 = atan2(q, a)
    v8 = a < v5
    v9 = v5 - a
    v14 = sqrt((v9 if v9 > 0.0 or v9 != v9 else 0.0) * (v5 + a))
    v15 = q - v14
    v19 = sqrt((v15 if v15 > 0.0 or v15 != v15 else 0.0) * (q + v14))
    if v8:
        v24 = (atan2(v19 if v8 else q, v5) if v8 else v7) if v6 > v5 else 0.0
        v26 = v24 if v24 < v7 or v24 != v24 else v7
    else:
        v26 = v7
    v27 = v7 - v26
    v28 = v6 if v6 > R or v6 != v6 else R
    v36 = 0.6366197723675814 * (R - v5) / sqrt((v28 - v5) * (v28 + v5))
    v40 = v27 / 9.0 + 1e-300
    v41 = v36 if v36 > v40 or v36 != v36 else v40
    v63 = []
    v64 = []
    if abs(v27) > 0.0:
        for node, weight in RULE_0(v27 / v41):
            v42 = node * v27
            v43 = v26 + v42
            v44 = cos(v43)
            v46 = abs(v6 * v44)
            v47 = v46 if v46 < v5 or v46 != v46 else v5
            v51 = sqrt((R - v47) * (R + v47))
            v58 = asinh(v47 / v51) + R * v47 / (v51 * v51)
            v61 = v58 * v43 * sin(v43)
            v62 = v58 * v44
            v63.append(weight * v61)
            v64.append(weight * v62)
    v63 = fsum(v63) * v27
    v64 = fsum(v64) * v27
    v68 = a - v5
    v72 = sqrt((v68 if v68 > 0.0 or v68 != v68 else 0.0) * (a + v5))
    v74 = v19 if v8 else hypot(v72, q)
    v75 = v74 if v8 else q
    v77 = v74 if v75 > 0.0 else v5
    v79 = asinh(v5 / v77)
    v83 = 1.5707963267948966 / v79
    v84 = atan2(v72, v75) / v79
    v85 = asinh(v83)
    v100 = asinh(atan2(v75, v72) / v79 * (v83 + v84) / (v83 * sqrt(1.0 + v84 * v84) + v84 * sqrt(1.0 + v83 * v83)))
    v102 = 2.0 * v79
    v116 = v5 * v5
    v121 = R * cos(theta)
    v123 = v5 * v5
    v127 = v123 / (v121 + R)
    v135 = v123 * R
    v136 = v121 * v121
    v153 = []
    v154 = []
    if abs(v100) > 0.0:
        for node, weight in RULE_1(v100 / 1.0):
            v101 = node * v100
            v104 = 0.5 * v101
            v109 = v102 * cosh(v85 - v104) * sinh(v104)
            v110 = cos(v109)
            v113 = v77 * (v110 if v110 > 1e-17 or v110 != v110 else 1e-17)
            v115 = v77 * sin(v109)
            v119 = sqrt(v116 + v113 * v113)
            v147 = (log1p((v123 / (v113 + v119) + v127) / (v113 + v121)) + v5 * atan2(v113, v5) / v121 + v135 / (v119 * v136 + R * v113 * v121)) * v113 * v79 * cosh(v85 - v101)
            v151 = v147 * atan2(v115, v119) * (v115 / v119)
            v152 = v147 / v6
            v153.append(weight * v151)
            v154.append(weight * v152)
    v153 = fsum(v153) * v100
    v154 = fsum(v154) * v100
    return (0.6366197723675814 * v6 * v63 + 0.6366197723675814 * v153, 0.6366197723675814 * v64 + 0.6366197723675814 * v154)


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


def _growth(a, R, theta):
    v4 = R * sin(theta)
    if a < v4:
        v19 = sqrt((R - a) * (R + a))
        return asinh(a / v19) + R * a / (v19 * v19)
    v5 = a - v4
    v10 = sqrt((v5 if v5 > 0.0 or v5 != v5 else 0.0) * (a + v4))
    v12 = 1e-09 * v4
    v13 = v10 if v10 > v12 or v10 != v10 else v12
    v28 = R * cos(theta)
    v30 = v4 * v4
    return log1p((v30 / (v13 + a) + v30 / (v28 + R)) / (v13 + v28)) + v4 * atan2(v13, v4) / v28 + v30 * R / (a * (v28 * v28) + R * v13 * v28)


def _radii(R, theta, E_star, dgamma, sigma_0):
    a = np.zeros_like(sigma_0)
    first = zone_like(partial(_opened, R=R, theta=theta), a, E_star, dgamma, sigma_0)
    return radii_by(first, R * np.sin(theta))


def _state(a, start, R, theta, E_star, dgamma, sigma_0, control):
    growth = _growth(a, R, theta)
    return state_near(partial(_opened, R=R, theta=theta), growth, start, a, control, E_star, dgamma, sigma_0)


def _pull_off_radius(R, theta, E_star, dgamma, sigma_0, control):
    load = _force_of if control == 'force' else _depth_of
    return radius_of_pull_off(lambda a, start: _state(a, start, R, theta, E_star, dgamma, sigma_0, control), lambda a, q: load(a, q, R, theta, E_star, dgamma, sigma_0), _radii(R, theta, E_star, dgamma, sigma_0))


def _parted(R, theta, E_star, dgamma, sigma_0):
    first = _zone(np.zeros_like(sigma_0), R, theta, E_star, dgamma, sigma_0)
    return parted_by(partial(_opened, R=R, theta=theta), first, R * np.sin(theta), E_star, sigma_0)


def _pull_off_zone(a, R, theta, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: root_of_zone(partial(_opened, R=R, theta=theta), a, E_star, dgamma, sigma_0), lambda: _parted(R, theta, E_star, dgamma, sigma_0) if a == 0.0 else np.nan)


def _pull_off_depth(a, q, R, theta, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: _depth_of(a, q, R, theta, E_star, dgamma, sigma_0), lambda: alone(partial(_opened, R=R, theta=theta), q, E_star, dgamma, sigma_0))


def _held_apart(d, R, theta, E_star, dgamma, sigma_0):
    apart = _pull_off_radius(R, theta, E_star, dgamma, sigma_0, 'depth') == 0.0
    deeper = d >= alone(partial(_opened, R=R, theta=theta), _parted(R, theta, E_star, dgamma, sigma_0), E_star, dgamma, sigma_0)
    return 0.0 if apart & deeper else np.nan


def _radius_from_depth(d, R, theta, E_star, dgamma, sigma_0):
    a = radius_under(lambda a, start: _state(a, start, R, theta, E_star, dgamma, sigma_0, 'depth'), lambda a, q: _depth_of(a, q, R, theta, E_star, dgamma, sigma_0), d, _radii(R, theta, E_star, dgamma, sigma_0))
    return _held_apart(d, R, theta, E_star, dgamma, sigma_0) if np.isnan(a) else a


def _radius_from_force(F, R, theta, E_star, dgamma, sigma_0):
    return radius_under(lambda a, start: _state(a, start, R, theta, E_star, dgamma, sigma_0, 'force'), lambda a, q: _force_of(a, q, R, theta, E_star, dgamma, sigma_0), F, _radii(R, theta, E_star, dgamma, sigma_0))
