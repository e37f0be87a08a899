"""Bodies of axicontact.normal.capped_paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, atan2, exp, expm1, fsum, inf

from ...._programs.bodies._runtime.shapes.across import inverse_beyond
from ...._runtime.plain import sqrt, rule, MATH as np

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def _slope_beyond(t, root, R1, R2, b):
    v8 = R1 - R2
    v10 = R1 * R2
    return 2.0 * t / R1 + 2.0 * v8 / v10 * root + b * b * v8 / (v10 * root)


def _depth_beyond(a, root, R1, R2):
    return a * (a + (R1 - R2) / R2 * root) / R1


def _depth(a, R1, R2, b):
    if a < b:
        return a * a / R1
    return a * (a + (R1 - R2) / R2 * sqrt((a - b) * (a + b))) / R1


def _force_beyond(a, root, R1, R2, b, E_star):
    v11 = a * a
    return 2.0 * E_star / (3.0 * R1) * (2.0 * (a * v11) + (R1 - R2) / R2 * (2.0 * v11 + b * b) * root)


def _force(a, R1, R2, b, E_star):
    v8 = 3.0 * R1
    v11 = a * a
    v12 = a * v11
    if a < b:
        return 4.0 * E_star / v8 * v12
    return 2.0 * E_star / v8 * (2.0 * v12 + (R1 - R2) / R2 * (2.0 * v11 + b * b) * sqrt((a - b) * (a + b)))


def _displacement(r, a, R1, R2, b):
    v6 = r - b
    v9 = r + b
    v13 = a - b
    v15 = a + b
    v63 = R1 - R2
    v69 = b * b
    if r > a:
        v5 = a if a < b or a != a else b
        if a > b:
            v11 = sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * v9)
            v12 = b / r
            v18 = r - a
            v23 = sqrt((v13 if v13 > 0.0 or v13 != v13 else 0.0) * v15) / sqrt((v18 if v18 > 0.0 or v18 != v18 else 0.0) * (r + a))
            v25 = asinh(v23 / v12)
            v30 = 0.0 - expm1(-2.0 * v25)
            v33 = v30 if v30 > 0.0 else inf
            v50 = b * b
            v54 = v12 * v12
            v65 = R1 * R2
            v66 = 2.0 * v63 / v65
            v70 = v69 * v63
            v80 = []
            for node, weight in RULE_0(v25 / 1.0):
                v35 = node * v25
                v44 = v23 * (exp(-v35) * (0.0 - expm1(-2.0 * (v25 - v35))) / v33)
                v45 = v44 * v44
                v47 = sqrt(1.0 + v45)
                v49 = v11 * v44 / v47
                v53 = sqrt(v50 + v49 * v49)
                v79 = (2.0 * v53 / R1 + v66 * v49 + v70 / (v65 * v49)) * v49 / v53 * atan2(v53, v11 / v47) * (sqrt(v54 + v45) / (v47 * v47 * v47))
                v80.append(weight * v79)
            v80 = fsum(v80) * v25
            v82 = v11 * v80
        else:
            v82 = 0.0
        v93 = v5 / (r + sqrt((r - v5) * (r + v5)))
        v95 = v93 * v93
        return 2.0 * (v5 * v5) / (3.141592653589793 * R1) * (v5 / r * (0.6666666666666666 + v95 * (((((((((-0.7327347664453868 * v95 + -32.15553480435792) * v95 + -332.23363563146734) * v95 + -1070.7082873491413) * v95 + -85.27694715374247) * v95 + 5044.821368830373) * v95 + 8082.413158212496) * v95 + 3759.725330928701) * v95 + 0.26666666666720995) / ((((((((0.21387262524856868 * v95 + 32.12935731379798) * v95 + 746.8124983579742) * v95 + 6202.125133759036) * v95 + 23553.080984642995) * v95 + 44404.005348491315) * v95 + 40380.01430284195) * v95 + 14099.684276696918) * v95 + 1.0)))) + 0.6366197723675814 * v82
    v167 = 2.0 * R1
    return (a * a / R1 if a < b else a * (a + v63 / R2 * sqrt(v13 * v15)) / R1) - (r * r / v167 if r < b else v69 / v167 + v6 * v9 / (2.0 * R2))


def _radius_from_depth(d, R1, R2, b):

    def curve(a, root):
        rate = a * _slope_beyond(a, root, R1, R2, b)
        return (_depth_beyond(a, root, R1, R2), rate)
    return inverse_beyond(curve, d, b, 2.0, leaving=(1.0, 2.0))


def _radius_from_force(F, R1, R2, b, E_star):

    def curve(a, root):
        rate = 2 * E_star * a ** 2 * _slope_beyond(a, root, R1, R2, b)
        return (_force_beyond(a, root, R1, R2, b, E_star), rate)
    return inverse_beyond(curve, F, b, 3.0, leaving=(1.0, 3.0))


def _force_from_depth(d, R1, R2, b, E_star):
    a = _radius_from_depth(d, R1, R2, b)
    change = 2 * E_star * a * (d - _depth(a, R1, R2, b)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force(a, R1, R2, b, E_star) + change


def _depth_from_force(F, R1, R2, b, E_star):
    a = _radius_from_force(F, R1, R2, b, E_star)
    change = (F - _force(a, R1, R2, b, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth(a, R1, R2, b) + change
