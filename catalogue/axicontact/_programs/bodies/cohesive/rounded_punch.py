"""Bodies of axicontact.cohesive.rounded_punch over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, atan, atan2, cos, cosh, exp, expm1, fsum, hypot, inf, nan, nextafter, sin, sinh

from ...._programs.bodies.normal import rounded_punch as normal
from ...._programs.bodies._runtime.interface import either
from ...._programs.bodies._runtime.physics.cohesive import alone, lift_of_zone, outer_radius, root_of_zone, zone_like
from ...._programs.bodies._runtime.physics.cohesive_states import parted_by, radii_by, radius_of_pull_off, radius_under, state_near
from ....cohesive.rounded_punch import partial
from ...._runtime.plain import sqrt, rule, MATH as np

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64), (18.03, 128)))
RULE_1 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def _opened(q, a, R, b):
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
    v73 = b / R
    v86 = []
    v87 = []
    if abs(v49) > 0.0:
        for node, weight in RULE_0(v49 / 1.0):
            v50 = node * v49
            v54 = 0.5 * v50
            v59 = v52 * cosh(v34 - v54) * sinh(v54)
            v60 = cos(v59)
            v63 = v26 * (v60 if v60 > 1e-17 or v60 != v60 else 1e-17)
            v65 = v26 * sin(v59)
            v69 = sqrt(v66 + v63 * v63)
            v80 = (2.0 * v63 / R - v73 * atan2(v63, b)) * v63 * v28 * cosh(v34 - v50)
            v84 = v80 * atan2(v65, v69) * (v65 / v69)
            v85 = v80 / v4
            v86.append(weight * v84)
            v87.append(weight * v85)
    v86 = fsum(v86) * v49
    v87 = fsum(v87) * v49
    return (0.6366197723675814 * v86, 0.6366197723675814 * v87)


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


def _pressure_of(r, a, q, R, b, E_star, dgamma, sigma_0):
    v72 = r < a
    if a < b:
        v80 = 0.0
    else:
        if a >= b:
            if v72:
                v12 = nextafter(b, inf) if r == b else r
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
                    v65 = b / R
                    v70 = []
                    for node, weight in RULE_1(v34 / 1.0):
                        v47 = node * v34
                        v57 = v21 * (exp(-v47) * (v36 - v37 * expm1(-2.0 * (v34 - v47))) / v44)
                        v69 = (2.0 * v57 / R - v65 * atan2(v57, b)) * v57 / sqrt(v58 + v57 * v57)
                        v70.append(weight * v69)
                    v70 = fsum(v70) * v34
                    v71 = v70
                else:
                    v71 = 0.0
                v76 = E_star / 3.141592653589793 * v71
            else:
                v76 = 0.0
            v79 = v76
        else:
            v79 = nan
        v80 = v79
    if v72:
        v81 = a - r
        v92 = 0.6366197723675814 * atan2(q, sqrt((v81 if v81 > 0.0 or v81 != v81 else 0.0) * (a + r)))
    else:
        v92 = 1.0 if r < hypot(a, q) else 0.0
    return v80 - sigma_0 * v92


def _pressure(r, a, R, b, E_star, dgamma, sigma_0):
    return _pressure_of(r, a, _zone(a, R, b, E_star, dgamma, sigma_0), R, b, E_star, dgamma, sigma_0)


def _displacement_of(r, a, q, R, b, E_star, dgamma, sigma_0):
    return (0.0 if a < b else normal._displacement(r, a, R, b)) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r, a, R, b, E_star, dgamma, sigma_0):
    return _displacement_of(r, a, _zone(a, R, b, E_star, dgamma, sigma_0), R, b, E_star, dgamma, sigma_0)


def _growth(a, R, b):
    if a < b:
        return 0.0
    v3 = a - b
    v8 = sqrt((v3 if v3 > 0.0 or v3 != v3 else 0.0) * (a + b))
    v10 = 1e-09 * b
    v11 = v8 if v8 > v10 or v8 != v8 else v10
    return 2.0 * v11 / R - b / R * atan2(v11, b)


def _radii(R, b, E_star, dgamma, sigma_0):
    a = np.zeros_like(sigma_0)
    first = zone_like(partial(_opened, R=R, b=b), a, E_star, dgamma, sigma_0)
    return radii_by(first, b)


def _state(a, start, R, b, E_star, dgamma, sigma_0, control):
    growth = _growth(a, R, b)
    return state_near(partial(_opened, R=R, b=b), growth, start, a, control, E_star, dgamma, sigma_0)


def _pull_off_radius(R, b, E_star, dgamma, sigma_0, control):
    load = _force_of if control == 'force' else _depth_of
    return radius_of_pull_off(lambda a, start: _state(a, start, R, b, E_star, dgamma, sigma_0, control), lambda a, q: load(a, q, R, b, E_star, dgamma, sigma_0), _radii(R, b, E_star, dgamma, sigma_0))


def _parted(R, b, E_star, dgamma, sigma_0):
    first = _zone(np.zeros_like(sigma_0), R, b, E_star, dgamma, sigma_0)
    return parted_by(partial(_opened, R=R, b=b), first, b, E_star, sigma_0)


def _pull_off_zone(a, R, b, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: root_of_zone(partial(_opened, R=R, b=b), a, E_star, dgamma, sigma_0), lambda: _parted(R, b, E_star, dgamma, sigma_0) if a == 0.0 else np.nan)


def _pull_off_depth(a, q, R, b, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: _depth_of(a, q, R, b, E_star, dgamma, sigma_0), lambda: alone(partial(_opened, R=R, b=b), q, E_star, dgamma, sigma_0))


def _held_apart(d, R, b, E_star, dgamma, sigma_0):
    apart = _pull_off_radius(R, b, E_star, dgamma, sigma_0, 'depth') == 0.0
    deeper = d >= alone(partial(_opened, R=R, b=b), _parted(R, b, E_star, dgamma, sigma_0), E_star, dgamma, sigma_0)
    return 0.0 if apart & deeper else np.nan


def _radius_from_depth(d, R, b, E_star, dgamma, sigma_0):
    a = radius_under(lambda a, start: _state(a, start, R, b, E_star, dgamma, sigma_0, 'depth'), lambda a, q: _depth_of(a, q, R, b, E_star, dgamma, sigma_0), d, _radii(R, b, E_star, dgamma, sigma_0))
    return _held_apart(d, R, b, E_star, dgamma, sigma_0) if np.isnan(a) else a


def _radius_from_force(F, R, b, E_star, dgamma, sigma_0):
    return radius_under(lambda a, start: _state(a, start, R, b, E_star, dgamma, sigma_0, 'force'), lambda a, q: _force_of(a, q, R, b, E_star, dgamma, sigma_0), F, _radii(R, b, E_star, dgamma, sigma_0))
