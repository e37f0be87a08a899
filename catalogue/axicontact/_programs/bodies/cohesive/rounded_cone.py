"""Bodies of axicontact.cohesive.rounded_cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, atan, atan2, cos, cosh, exp, expm1, fsum, hypot, inf, nextafter, sin, sinh, tan

from ...._programs.bodies.normal import rounded_cone as normal
from ...._programs.bodies._runtime.interface import either
from ...._programs.bodies._runtime.physics.cohesive import alone, lift_of_zone, outer_radius, root_of_zone, zone_like
from ...._programs.bodies._runtime.physics.cohesive_states import parted_by, radii_by, radius_of_pull_off, radius_under, state_near
from ....cohesive.rounded_cone import partial
from ...._runtime.plain import sqrt, rule, MATH as np

RULE_0 = rule(((0.45, 8), (inf, 16)))
RULE_1 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64), (18.03, 128)))
RULE_2 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def _opened(q, a, theta, b):
    v4 = hypot(a, q)
    v5 = atan2(q, a)
    v6 = a < b
    v7 = b - a
    v12 = sqrt((v7 if v7 > 0.0 or v7 != v7 else 0.0) * (b + a))
    v13 = q - v12
    v17 = sqrt((v13 if v13 > 0.0 or v13 != v13 else 0.0) * (q + v12))
    if v6:
        v22 = (atan2(v17 if v6 else q, b) if v6 else v5) if v4 > b else 0.0
        v24 = v22 if v22 < v5 or v22 != v22 else v5
    else:
        v24 = v5
    v25 = v5 - v24
    v33 = tan(theta)
    v36 = 2.0 * v33 / b
    v42 = []
    v43 = []
    if abs(v25) > 0.0:
        for node, weight in RULE_0(v25 / 1.0):
            v27 = node * v25
            v28 = v24 + v27
            v29 = cos(v28)
            v31 = abs(v4 * v29)
            v37 = v36 * (v31 if v31 < b or v31 != v31 else b)
            v40 = v37 * v28 * sin(v28)
            v41 = v37 * v29
            v42.append(weight * v40)
            v43.append(weight * v41)
    v42 = fsum(v42) * v25
    v43 = fsum(v43) * v25
    v48 = a - b
    v52 = sqrt((v48 if v48 > 0.0 or v48 != v48 else 0.0) * (a + b))
    v54 = v17 if v6 else hypot(v52, q)
    v55 = v54 if v6 else q
    v57 = v54 if v55 > 0.0 else b
    v59 = asinh(b / v57)
    v63 = 1.5707963267948966 / v59
    v64 = atan2(v52, v55) / v59
    v65 = asinh(v63)
    v79 = asinh(atan2(v55, v52) / v59 * (v63 + v64) / (v63 * sqrt(1.0 + v64 * v64) + v64 * sqrt(1.0 + v63 * v63)))
    v81 = 2.0 * v59
    v95 = b * b
    v101 = 2.0 * b
    v116 = []
    v117 = []
    if abs(v79) > 0.0:
        for node, weight in RULE_1(v79 / 1.0):
            v80 = node * v79
            v83 = 0.5 * v80
            v88 = v81 * cosh(v65 - v83) * sinh(v83)
            v89 = cos(v88)
            v92 = v57 * (v89 if v89 > 1e-17 or v89 != v89 else 1e-17)
            v94 = v57 * sin(v88)
            v98 = sqrt(v95 + v92 * v92)
            v110 = v33 * (atan(v92 / b) + v101 / (v92 + v98)) * v92 * v59 * cosh(v65 - v80)
            v114 = v110 * atan2(v94, v98) * (v94 / v98)
            v115 = v110 / v4
            v116.append(weight * v114)
            v117.append(weight * v115)
    v116 = fsum(v116) * v79
    v117 = fsum(v117) * v79
    return (0.6366197723675814 * v4 * v42 + 0.6366197723675814 * v116, 0.6366197723675814 * v43 + 0.6366197723675814 * v117)


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


def _pressure_of(r, a, q, theta, b, E_star, dgamma, sigma_0):
    v86 = r < a
    if v86:
        v8 = a if a < b or a != a else b
        v16 = tan(theta)
        v27 = nextafter(b, inf) if r == b else r
        if a > (v27 if v27 > b or v27 != v27 else b):
            v28 = v27 < b
            v31 = a - b
            v35 = sqrt((v31 if v31 > 0.0 or v31 != v31 else 0.0) * (a + b))
            if v28:
                v41 = v35
            else:
                v36 = a - v27
                v41 = sqrt((v36 if v36 > 0.0 or v36 != v36 else 0.0) * (a + v27))
            v48 = asinh(v41 / sqrt(abs(v27 - b) * (v27 + b)))
            v49 = 2.0 * (0.0 if v28 else 1.0)
            v50 = 1.0 - v49
            v55 = v49 - v50 * expm1(-2.0 * v48)
            v57 = v55 if v55 > 0.0 else inf
            v71 = b * b
            v77 = 2.0 * b
            v84 = []
            for node, weight in RULE_2(v48 / 1.0):
                v60 = node * v48
                v70 = v35 * (exp(-v60) * (v49 - v50 * expm1(-2.0 * (v48 - v60))) / v57)
                v74 = sqrt(v71 + v70 * v70)
                v83 = v16 * (atan(v70 / b) + v77 / (v70 + v74)) * v70 / v74
                v84.append(weight * v83)
            v84 = fsum(v84) * v48
            v85 = v84
        else:
            v85 = 0.0
        v90 = (2.0 * E_star * v16 / (3.141592653589793 * b) * sqrt((v8 - r) * (v8 + r)) if r < v8 else 0.0) + E_star / 3.141592653589793 * v85
    else:
        v90 = 0.0
    if v86:
        v91 = a - r
        v102 = 0.6366197723675814 * atan2(q, sqrt((v91 if v91 > 0.0 or v91 != v91 else 0.0) * (a + r)))
    else:
        v102 = 1.0 if r < hypot(a, q) else 0.0
    return v90 - sigma_0 * v102


def _pressure(r, a, theta, b, E_star, dgamma, sigma_0):
    return _pressure_of(r, a, _zone(a, theta, b, E_star, dgamma, sigma_0), theta, b, E_star, dgamma, sigma_0)


def _displacement_of(r, a, q, theta, b, E_star, dgamma, sigma_0):
    return normal._displacement(r, a, theta, b) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r, a, theta, b, E_star, dgamma, sigma_0):
    return _displacement_of(r, a, _zone(a, theta, b, E_star, dgamma, sigma_0), theta, b, E_star, dgamma, sigma_0)


def _growth(a, theta, b):
    v14 = tan(theta)
    if a < b:
        return 2.0 * v14 / b * a
    v3 = a - b
    v8 = sqrt((v3 if v3 > 0.0 or v3 != v3 else 0.0) * (a + b))
    v10 = 1e-09 * b
    v11 = v8 if v8 > v10 or v8 != v8 else v10
    return v14 * (atan(v11 / b) + 2.0 * b / (v11 + a))


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
