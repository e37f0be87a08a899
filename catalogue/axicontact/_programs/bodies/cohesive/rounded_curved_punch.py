"""Bodies of axicontact.cohesive.rounded_curved_punch over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, atan, atan2, cos, cosh, exp, expm1, fsum, hypot, inf, nextafter, sin, sinh

from ...._programs.bodies.normal import rounded_curved_punch as normal
from ...._programs.bodies._runtime.interface import either
from ...._programs.bodies._runtime.physics.cohesive import alone, lift_of_zone, outer_radius, root_of_zone, zone_like
from ...._programs.bodies._runtime.physics.cohesive_states import parted_by, radii_by, radius_of_pull_off, radius_under, state_near
from ....cohesive.rounded_curved_punch import partial
from ...._runtime.plain import sqrt, rule, MATH as np

RULE_0 = rule(((0.45, 8), (inf, 16)))
RULE_1 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64), (18.03, 128)))
RULE_2 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def _opened(q, a, R1, R2, b):
    v5 = hypot(a, q)
    v6 = atan2(q, a)
    v7 = a < b
    v8 = b - a
    v13 = sqrt((v8 if v8 > 0.0 or v8 != v8 else 0.0) * (b + a))
    v14 = q - v13
    v18 = sqrt((v14 if v14 > 0.0 or v14 != v14 else 0.0) * (q + v13))
    if v7:
        v23 = (atan2(v18 if v7 else q, b) if v7 else v6) if v5 > b else 0.0
        v25 = v23 if v23 < v6 or v23 != v23 else v6
    else:
        v25 = v6
    v26 = v6 - v25
    v41 = []
    v42 = []
    if abs(v26) > 0.0:
        for node, weight in RULE_0(v26 / 1.0):
            v28 = node * v26
            v29 = v25 + v28
            v30 = cos(v29)
            v32 = abs(v5 * v30)
            v36 = 2.0 * (v32 if v32 < b or v32 != v32 else b) / R1
            v39 = v36 * v29 * sin(v29)
            v40 = v36 * v30
            v41.append(weight * v39)
            v42.append(weight * v40)
    v41 = fsum(v41) * v26
    v42 = fsum(v42) * v26
    v47 = a - b
    v51 = sqrt((v47 if v47 > 0.0 or v47 != v47 else 0.0) * (a + b))
    v53 = v18 if v7 else hypot(v51, q)
    v54 = v53 if v7 else q
    v56 = v53 if v54 > 0.0 else b
    v58 = asinh(b / v56)
    v62 = 1.5707963267948966 / v58
    v63 = atan2(v51, v54) / v58
    v64 = asinh(v62)
    v78 = asinh(atan2(v54, v51) / v58 * (v62 + v63) / (v62 * sqrt(1.0 + v63 * v63) + v63 * sqrt(1.0 + v62 * v62)))
    v80 = 2.0 * v58
    v94 = b * b
    v104 = b / R2
    v117 = []
    v118 = []
    if abs(v78) > 0.0:
        for node, weight in RULE_1(v78 / 1.0):
            v79 = node * v78
            v82 = 0.5 * v79
            v87 = v80 * cosh(v64 - v82) * sinh(v82)
            v88 = cos(v87)
            v91 = v56 * (v88 if v88 > 1e-17 or v88 != v88 else 1e-17)
            v93 = v56 * sin(v87)
            v97 = sqrt(v94 + v91 * v91)
            v111 = (2.0 * v97 / R1 + 2.0 * v91 / R2 - v104 * atan2(v91, b)) * v91 * v58 * cosh(v64 - v79)
            v115 = v111 * atan2(v93, v97) * (v93 / v97)
            v116 = v111 / v5
            v117.append(weight * v115)
            v118.append(weight * v116)
    v117 = fsum(v117) * v78
    v118 = fsum(v118) * v78
    return (0.6366197723675814 * v5 * v41 + 0.6366197723675814 * v117, 0.6366197723675814 * v42 + 0.6366197723675814 * v118)


def _zone(a, R1, R2, b, E_star, dgamma, sigma_0):
    """sqrt(c**2 - a**2) of the zone."""
    return root_of_zone(partial(_opened, R1=R1, R2=R2, b=b), a, E_star, dgamma, sigma_0)


def _cohesive_radius(a, R1, R2, b, E_star, dgamma, sigma_0):
    return outer_radius(_zone(a, R1, R2, b, E_star, dgamma, sigma_0), a)


def _depth_of(a, q, R1, R2, b, E_star, dgamma, sigma_0):
    if a < b:
        v65 = a * a / R1
    else:
        v13 = a - b
        v14 = v13 / b
        if v14 < 0.42:
            v60 = v14 * sqrt(v14) * ((((((0.0005288491342179178 * v14 + 0.038096760299703034) * v14 + 0.4065213849117787) * v14 + 1.438682033198726) * v14 + 1.9979042349620892) * v14 + 0.9428090415820634) / (((((0.006421883194715949 * v14 + 0.15001504718401248) * v14 + 0.9450913324352289) * v14 + 2.37401087025821) * v14 + 2.569097449054519) * v14 + 1.0))
        else:
            v20 = sqrt(v13 * (a + b)) / b
            v60 = v20 - atan(v20)
        v65 = a * (a / R1 + b / R2 * v60)
    return v65 - 2.0 * (sigma_0 / E_star) * q


def _depth(a, R1, R2, b, E_star, dgamma, sigma_0):
    return _depth_of(a, _zone(a, R1, R2, b, E_star, dgamma, sigma_0), R1, R2, b, E_star, dgamma, sigma_0)


def _force_of(a, q, R1, R2, b, E_star, dgamma, sigma_0):
    v11 = 3.0 * R1
    v14 = a * a
    v15 = a * v14
    if a < b:
        v77 = 4.0 * E_star / v11 * v15
    else:
        v17 = a - b
        v19 = v17 * (a + b)
        v20 = sqrt(v19)
        v25 = v17 / b
        if v25 < 0.42:
            v68 = v25 * sqrt(v25) * ((((((0.0005288491342179178 * v25 + 0.038096760299703034) * v25 + 0.4065213849117787) * v25 + 1.438682033198726) * v25 + 1.9979042349620892) * v25 + 0.9428090415820634) / (((((0.006421883194715949 * v25 + 0.15001504718401248) * v25 + 0.9450913324352289) * v25 + 2.37401087025821) * v25 + 2.569097449054519) * v25 + 1.0))
        else:
            v28 = v20 / b
            v68 = v28 - atan(v28)
        v77 = E_star * (4.0 * v15 / v11 + b / R2 * v14 * v68 + v19 * v20 / (3.0 * R2))
    v78 = hypot(a, q)
    return v77 - 2.0 * sigma_0 * (v78 * v78 * atan2(q, a) + a * q)


def _force(a, R1, R2, b, E_star, dgamma, sigma_0):
    return _force_of(a, _zone(a, R1, R2, b, E_star, dgamma, sigma_0), R1, R2, b, E_star, dgamma, sigma_0)


def _pressure_of(r, a, q, R1, R2, b, E_star, dgamma, sigma_0):
    v87 = r < a
    if v87:
        v9 = a if a < b or a != a else b
        v26 = nextafter(b, inf) if r == b else r
        if a > (v26 if v26 > b or v26 != v26 else b):
            v27 = v26 < b
            v30 = a - b
            v34 = sqrt((v30 if v30 > 0.0 or v30 != v30 else 0.0) * (a + b))
            if v27:
                v40 = v34
            else:
                v35 = a - v26
                v40 = sqrt((v35 if v35 > 0.0 or v35 != v35 else 0.0) * (a + v26))
            v47 = asinh(v40 / sqrt(abs(v26 - b) * (v26 + b)))
            v48 = 2.0 * (0.0 if v27 else 1.0)
            v49 = 1.0 - v48
            v54 = v48 - v49 * expm1(-2.0 * v47)
            v56 = v54 if v54 > 0.0 else inf
            v70 = b * b
            v80 = b / R2
            v85 = []
            for node, weight in RULE_2(v47 / 1.0):
                v59 = node * v47
                v69 = v34 * (exp(-v59) * (v48 - v49 * expm1(-2.0 * (v47 - v59))) / v56)
                v73 = sqrt(v70 + v69 * v69)
                v84 = (2.0 * v73 / R1 + 2.0 * v69 / R2 - v80 * atan2(v69, b)) * v69 / v73
                v85.append(weight * v84)
            v85 = fsum(v85) * v47
            v86 = v85
        else:
            v86 = 0.0
        v91 = (2.0 * E_star / (3.141592653589793 * R1) * sqrt((v9 - r) * (v9 + r)) if r < v9 else 0.0) + E_star / 3.141592653589793 * v86
    else:
        v91 = 0.0
    if v87:
        v92 = a - r
        v103 = 0.6366197723675814 * atan2(q, sqrt((v92 if v92 > 0.0 or v92 != v92 else 0.0) * (a + r)))
    else:
        v103 = 1.0 if r < hypot(a, q) else 0.0
    return v91 - sigma_0 * v103


def _pressure(r, a, R1, R2, b, E_star, dgamma, sigma_0):
    return _pressure_of(r, a, _zone(a, R1, R2, b, E_star, dgamma, sigma_0), R1, R2, b, E_star, dgamma, sigma_0)


def _displacement_of(r, a, q, R1, R2, b, E_star, dgamma, sigma_0):
    return normal._displacement(r, a, R1, R2, b) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r, a, R1, R2, b, E_star, dgamma, sigma_0):
    return _displacement_of(r, a, _zone(a, R1, R2, b, E_star, dgamma, sigma_0), R1, R2, b, E_star, dgamma, sigma_0)


def _growth(a, R1, R2, b):
    if a < b:
        return 2.0 * a / R1
    v4 = a - b
    v9 = sqrt((v4 if v4 > 0.0 or v4 != v4 else 0.0) * (a + b))
    v11 = 1e-09 * b
    v12 = v9 if v9 > v11 or v9 != v9 else v11
    return 2.0 * a / R1 + 2.0 * v12 / R2 - b / R2 * atan2(v12, b)


def _radii(R1, R2, b, E_star, dgamma, sigma_0):
    a = np.zeros_like(sigma_0)
    first = zone_like(partial(_opened, R1=R1, R2=R2, b=b), a, E_star, dgamma, sigma_0)
    return radii_by(first, b)


def _state(a, start, R1, R2, b, E_star, dgamma, sigma_0, control):
    growth = _growth(a, R1, R2, b)
    return state_near(partial(_opened, R1=R1, R2=R2, b=b), growth, start, a, control, E_star, dgamma, sigma_0)


def _pull_off_radius(R1, R2, b, E_star, dgamma, sigma_0, control):
    load = _force_of if control == 'force' else _depth_of
    return radius_of_pull_off(lambda a, start: _state(a, start, R1, R2, b, E_star, dgamma, sigma_0, control), lambda a, q: load(a, q, R1, R2, b, E_star, dgamma, sigma_0), _radii(R1, R2, b, E_star, dgamma, sigma_0))


def _parted(R1, R2, b, E_star, dgamma, sigma_0):
    first = _zone(np.zeros_like(sigma_0), R1, R2, b, E_star, dgamma, sigma_0)
    return parted_by(partial(_opened, R1=R1, R2=R2, b=b), first, b, E_star, sigma_0)


def _pull_off_zone(a, R1, R2, b, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: root_of_zone(partial(_opened, R1=R1, R2=R2, b=b), a, E_star, dgamma, sigma_0), lambda: _parted(R1, R2, b, E_star, dgamma, sigma_0) if a == 0.0 else np.nan)


def _pull_off_depth(a, q, R1, R2, b, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: _depth_of(a, q, R1, R2, b, E_star, dgamma, sigma_0), lambda: alone(partial(_opened, R1=R1, R2=R2, b=b), q, E_star, dgamma, sigma_0))


def _held_apart(d, R1, R2, b, E_star, dgamma, sigma_0):
    apart = _pull_off_radius(R1, R2, b, E_star, dgamma, sigma_0, 'depth') == 0.0
    deeper = d >= alone(partial(_opened, R1=R1, R2=R2, b=b), _parted(R1, R2, b, E_star, dgamma, sigma_0), E_star, dgamma, sigma_0)
    return 0.0 if apart & deeper else np.nan


def _radius_from_depth(d, R1, R2, b, E_star, dgamma, sigma_0):
    a = radius_under(lambda a, start: _state(a, start, R1, R2, b, E_star, dgamma, sigma_0, 'depth'), lambda a, q: _depth_of(a, q, R1, R2, b, E_star, dgamma, sigma_0), d, _radii(R1, R2, b, E_star, dgamma, sigma_0))
    return _held_apart(d, R1, R2, b, E_star, dgamma, sigma_0) if np.isnan(a) else a


def _radius_from_force(F, R1, R2, b, E_star, dgamma, sigma_0):
    return radius_under(lambda a, start: _state(a, start, R1, R2, b, E_star, dgamma, sigma_0, 'force'), lambda a, q: _force_of(a, q, R1, R2, b, E_star, dgamma, sigma_0), F, _radii(R1, R2, b, E_star, dgamma, sigma_0))
