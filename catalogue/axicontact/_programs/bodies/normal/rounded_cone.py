"""Bodies of axicontact.normal.rounded_cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, atan, atan2, exp, expm1, fsum, inf, tan

from ...._programs.bodies._runtime.shapes.across import inverse_beyond
from ...._runtime.plain import sqrt, rule, MATH as np

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def _slope_beyond(t, root, theta, b):
    return tan(theta) * (atan(root / b) + 2.0 * b / (root + t))


def _depth_beyond(a, root, theta, b):
    return tan(theta) * a * (atan(root / b) + b / (root + a))


def _depth(a, theta, b):
    v3 = tan(theta)
    if a < b:
        return v3 / b * (a * a)
    v11 = sqrt((a - b) * (a + b))
    return v3 * a * (atan(v11 / b) + b / (v11 + a))


def _force_beyond(a, root, theta, b, E_star):
    v10 = a * a
    return E_star * tan(theta) * (v10 * atan(root / b) + 4.0 * b * v10 / (3.0 * (root + a)) + b / 3.0 * root)


def _force(a, theta, b, E_star):
    v6 = tan(theta)
    v12 = a * a
    if a < b:
        return 4.0 * E_star * v6 / (3.0 * b) * (a * v12)
    v18 = sqrt((a - b) * (a + b))
    return E_star * v6 * (v12 * atan(v18 / b) + 4.0 * b * v12 / (3.0 * (v18 + a)) + b / 3.0 * v18)


def _displacement(r, a, theta, b):
    v12 = a - b
    v14 = a + b
    v61 = tan(theta)
    v63 = 2.0 * b
    if r > a:
        v4 = a if a < b or a != a else b
        if a > b:
            v5 = r - b
            v10 = sqrt((v5 if v5 > 0.0 or v5 != v5 else 0.0) * (r + b))
            v11 = b / r
            v17 = r - a
            v22 = sqrt((v12 if v12 > 0.0 or v12 != v12 else 0.0) * v14) / sqrt((v17 if v17 > 0.0 or v17 != v17 else 0.0) * (r + a))
            v24 = asinh(v22 / v11)
            v29 = 0.0 - expm1(-2.0 * v24)
            v32 = v29 if v29 > 0.0 else inf
            v49 = b * b
            v53 = v11 * v11
            v74 = []
            for node, weight in RULE_0(v24 / 1.0):
                v34 = node * v24
                v43 = v22 * (exp(-v34) * (0.0 - expm1(-2.0 * (v24 - v34))) / v32)
                v44 = v43 * v43
                v46 = sqrt(1.0 + v44)
                v48 = v10 * v43 / v46
                v52 = sqrt(v49 + v48 * v48)
                v73 = v61 * (atan(v48 / b) + v63 / (v48 + v52)) * v48 / v52 * atan2(v52, v10 / v46) * (sqrt(v53 + v44) / (v46 * v46 * v46))
                v74.append(weight * v73)
            v74 = fsum(v74) * v24
            v76 = v10 * v74
        else:
            v76 = 0.0
        v88 = v4 / (r + sqrt((r - v4) * (r + v4)))
        v90 = v88 * v88
        return 2.0 * v61 / (3.141592653589793 * b) * (v4 * v4) * (v4 / r * (0.6666666666666666 + v90 * (((((((((-0.7327347664453868 * v90 + -32.15553480435792) * v90 + -332.23363563146734) * v90 + -1070.7082873491413) * v90 + -85.27694715374247) * v90 + 5044.821368830373) * v90 + 8082.413158212496) * v90 + 3759.725330928701) * v90 + 0.26666666666720995) / ((((((((0.21387262524856868 * v90 + 32.12935731379798) * v90 + 746.8124983579742) * v90 + 6202.125133759036) * v90 + 23553.080984642995) * v90 + 44404.005348491315) * v90 + 40380.01430284195) * v90 + 14099.684276696918) * v90 + 1.0)))) + 0.6366197723675814 * v76
    if a < b:
        v162 = v61 / b * (a * a)
    else:
        v153 = sqrt(v12 * v14)
        v162 = v61 * a * (atan(v153 / b) + b / (v153 + a))
    return v162 - (v61 / v63 * (r * r) if r < b else v61 * (r - b / 2.0))


def _radius_from_depth(d, theta, b):

    def curve(a, root):
        rate = a * _slope_beyond(a, root, theta, b)
        return (_depth_beyond(a, root, theta, b), rate)
    return inverse_beyond(curve, d, b, 2.0, powers=(2.0, 1.0))


def _radius_from_force(F, theta, b, E_star):

    def curve(a, root):
        rate = 2 * E_star * a ** 2 * _slope_beyond(a, root, theta, b)
        return (_force_beyond(a, root, theta, b, E_star), rate)
    return inverse_beyond(curve, F, b, 3.0, powers=(2.0, 2.0))


def _force_from_depth(d, theta, b, E_star):
    a = _radius_from_depth(d, theta, b)
    change = 2 * E_star * a * (d - _depth(a, theta, b)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force(a, theta, b, E_star) + change


def _depth_from_force(F, theta, b, E_star):
    a = _radius_from_force(F, theta, b, E_star)
    change = (F - _force(a, theta, b, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth(a, theta, b) + change
