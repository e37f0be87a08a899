"""Bodies of axicontact.cohesive.truncated_cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, atan, atan2, cos, cosh, exp, expm1, fsum, hypot, inf, nan, nextafter, sin, sinh, tan

from ...._programs.bodies.normal import truncated_cone as normal
from ...._programs.bodies._runtime.interface import either
from ...._programs.bodies._runtime.physics.cohesive import alone, lift_of_zone, outer_radius, root_of_zone, zone_like
from ...._programs.bodies._runtime.physics.cohesive_states import parted_by, radii_by, radius_of_pull_off, radius_under, state_near
from ....cohesive.truncated_cone import partial
from ...._runtime.plain import sqrt, rule, MATH as np

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64), (18.03, 128)))
RULE_1 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def _opened(q, a, theta, b):
    v4 = hypot(a, q)
    v5 = a - b
    v10 = sqrt((v5 if v5 > 0.0 or v5 != v5 else 0.0) * (a + b))
    v16 = a < b
    if v16:
        v11 = b - a
        v15 = sqrt((v11 if v11 > 0.0 or v11 != v11 else 0.0) * (b + a))
        v17 = q - v15
        v23 = sqrt((v17 if v17 > 0.0 or v17 != v17 else 0.0) * (q + v15))
    else:
        v23 = hypot(v10, q)
    v24 = v23 if v16 else q
    v26 = v23 if v24 > 0.0 else b
    v28 = asinh(b / v26)
    v32 = 1.5707963267948966 / v28
    v33 = atan2(v10, v24) / v28
    v34 = asinh(v32)
    v49 = asinh(atan2(v24, v10) / v28 * (v32 + v33) / (v32 * sqrt(1.0 + v33 * v33) + v33 * sqrt(1.0 + v32 * v32)))
    v52 = 2.0 * v28
    v66 = b * b
    v72 = tan(theta)
    v74 = b * v72
    v87 = []
    v88 = []
    if abs(v49) > 0.0:
        for node, weight in RULE_0(v49 / 1.0):
            v50 = node * v49
            v54 = 0.5 * v50
            v59 = v52 * cosh(v34 - v54) * sinh(v54)
            v60 = cos(v59)
            v63 = v26 * (v60 if v60 > 1e-17 or v60 != v60 else 1e-17)
            v65 = v26 * sin(v59)
            v69 = sqrt(v66 + v63 * v63)
            v81 = (v72 * atan(v63 / b) + v74 / v63) * v63 * v28 * cosh(v34 - v50)
            v85 = v81 * atan2(v65, v69) * (v65 / v69)
            v86 = v81 / v4
            v87.append(weight * v85)
            v88.append(weight * v86)
    v87 = fsum(v87) * v49
    v88 = fsum(v88) * v49
    return (0.6366197723675814 * v87, 0.6366197723675814 * v88)


def _zone(a, theta, b, E_star, dgamma, sigma_0):
    """sqrt(c**2 - a**2) of the zone."""
    return root_of_zone(partial(_opened, theta=theta, b=b), a, E_star, dgamma, sigma_0)


def _cohesive_radius(a, theta, b, E_star, dgamma, sigma_0):
    return outer_radius(_zone(a, theta, b, E_star, dgamma, sigma_0), a)


def _depth_of(a, q, theta, b, E_star, dgamma, sigma_0):
    return (0.0 if a < b else tan(theta) * a * atan(sqrt((a - b) * (a + b)) / b)) - 2.0 * (sigma_0 / E_star) * q


def _depth(a, theta, b, E_star, dgamma, sigma_0):
    return _depth_of(a, _zone(a, theta, b, E_star, dgamma, sigma_0), theta, b, E_star, dgamma, sigma_0)


def _force_of(a, q, theta, b, E_star, dgamma, sigma_0):
    if a < b:
        v23 = 0.0
    else:
        v11 = sqrt((a - b) * (a + b))
        v23 = E_star * tan(theta) * (a * a * atan(v11 / b) + b * v11)
    v24 = hypot(a, q)
    return v23 - 2.0 * sigma_0 * (v24 * v24 * atan2(q, a) + a * q)


def _force(a, theta, b, E_star, dgamma, sigma_0):
    return _force_of(a, _zone(a, theta, b, E_star, dgamma, sigma_0), theta, b, E_star, dgamma, sigma_0)


def _pressure_of(r, a, q, theta, b, E_star, dgamma, sigma_0):
    v79 = r < a
    if a < b:
        v84 = 0.0
    else:
        if a >= b:
            if v79:
                v9 = r == b
                if v9 and a > b:
                    v78 = inf
                else:
                    v12 = nextafter(b, inf) if v9 else r
                    if a > (v12 if v12 > b or v12 != v12 else b):
                        v13 = v12 < b
                        v17 = a - b
                        v21 = sqrt((v17 if v17 > 0.0 or v17 != v17 else 0.0) * (a + b))
                        if v13:
                            v27 = v21
                        else:
                            v22 = a - v12
                            v27 = sqrt((v22 if v22 > 0.0 or v22 != v22 else 0.0) * (a + v12))
                        v34 = asinh(v27 / sqrt(abs(v12 - b) * (v12 + b)))
                        v36 = 2.0 * (0.0 if v13 else 1.0)
                        v37 = 1.0 - v36
                        v42 = v36 - v37 * expm1(-2.0 * v34)
                        v44 = v42 if v42 > 0.0 else inf
                        v58 = b * b
                        v64 = tan(theta)
                        v66 = b * v64
                        v71 = []
                        for node, weight in RULE_1(v34 / 1.0):
                            v47 = node * v34
                            v57 = v21 * (exp(-v47) * (v36 - v37 * expm1(-2.0 * (v34 - v47))) / v44)
                            v70 = (v64 * atan(v57 / b) + v66 / v57) * v57 / sqrt(v58 + v57 * v57)
                            v71.append(weight * v70)
                        v71 = fsum(v71) * v34
                        v72 = v71
                    else:
                        v72 = 0.0
                    v78 = E_star / 3.141592653589793 * v72
                v80 = v78
            else:
                v80 = 0.0
            v83 = v80
        else:
            v83 = nan
        v84 = v83
    if v79:
        v85 = a - r
        v96 = 0.6366197723675814 * atan2(q, sqrt((v85 if v85 > 0.0 or v85 != v85 else 0.0) * (a + r)))
    else:
        v96 = 1.0 if r < hypot(a, q) else 0.0
    return v84 - sigma_0 * v96


def _pressure(r, a, theta, b, E_star, dgamma, sigma_0):
    return _pressure_of(r, a, _zone(a, theta, b, E_star, dgamma, sigma_0), theta, b, E_star, dgamma, sigma_0)


def _displacement_of(r, a, q, theta, b, E_star, dgamma, sigma_0):
    return (0.0 if a < b else normal._displacement(r, a, theta, b)) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r, a, theta, b, E_star, dgamma, sigma_0):
    return _displacement_of(r, a, _zone(a, theta, b, E_star, dgamma, sigma_0), theta, b, E_star, dgamma, sigma_0)


def _growth(a, theta, b):
    if a < b:
        return 0.0
    v3 = a - b
    v8 = sqrt((v3 if v3 > 0.0 or v3 != v3 else 0.0) * (a + b))
    v10 = 1e-09 * b
    v11 = v8 if v8 > v10 or v8 != v8 else v10
    v15 = tan(theta)
    return v15 * atan(v11 / b) + b * v15 / v11


def _radii(theta, b, E_star, dgamma, sigma_0):
    a = np.zeros_like(sigma_0)
    first = zone_like(partial(_opened, theta=theta, b=b), a, E_star, dgamma, sigma_0)
    return radii_by(first, b)


def _state(a, start, theta, b, E_star, dgamma, sigma_0, control):
    growth = _growth(a, theta, b)
    return state_near(partial(_opened, theta=theta, b=b), growth, start, a, control, E_star, dgamma, sigma_0)


def _pull_off_radius(theta, b, E_star, dgamma, sigma_0, control):
    load = _force_of if control == 'force' else _depth_of
    return radius_of_pull_off(lambda a, start: _state(a, start, theta, b, E_star, dgamma, sigma_0, control), lambda a, q: load(a, q, theta, b, E_star, dgamma, sigma_0), _radii(theta, b, E_star, dgamma, sigma_0))


def _parted(theta, b, E_star, dgamma, sigma_0):
    first = _zone(np.zeros_like(sigma_0), theta, b, E_star, dgamma, sigma_0)
    return parted_by(partial(_opened, theta=theta, b=b), first, b, E_star, sigma_0)


def _pull_off_zone(a, theta, b, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: root_of_zone(partial(_opened, theta=theta, b=b), a, E_star, dgamma, sigma_0), lambda: _parted(theta, b, E_star, dgamma, sigma_0) if a == 0.0 else np.nan)


def _pull_off_depth(a, q, theta, b, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: _depth_of(a, q, theta, b, E_star, dgamma, sigma_0), lambda: alone(partial(_opened, theta=theta, b=b), q, E_star, dgamma, sigma_0))


def _held_apart(d, theta, b, E_star, dgamma, sigma_0):
    apart = _pull_off_radius(theta, b, E_star, dgamma, sigma_0, 'depth') == 0.0
    deeper = d >= alone(partial(_opened, theta=theta, b=b), _parted(theta, b, E_star, dgamma, sigma_0), E_star, dgamma, sigma_0)
    return 0.0 if apart & deeper else np.nan


def _radius_from_depth(d, theta, b, E_star, dgamma, sigma_0):
    a = radius_under(lambda a, start: _state(a, start, theta, b, E_star, dgamma, sigma_0, 'depth'), lambda a, q: _depth_of(a, q, theta, b, E_star, dgamma, sigma_0), d, _radii(theta, b, E_star, dgamma, sigma_0))
    return _held_apart(d, theta, b, E_star, dgamma, sigma_0) if np.isnan(a) else a


def _radius_from_force(F, theta, b, E_star, dgamma, sigma_0):
    return radius_under(lambda a, start: _state(a, start, theta, b, E_star, dgamma, sigma_0, 'force'), lambda a, q: _force_of(a, q, theta, b, E_star, dgamma, sigma_0), F, _radii(theta, b, E_star, dgamma, sigma_0))
