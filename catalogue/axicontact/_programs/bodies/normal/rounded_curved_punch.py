"""Bodies of axicontact.normal.rounded_curved_punch over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, atan, atan2, exp, expm1, fsum, inf

from ...._programs.bodies._runtime.shapes.across import inverse_beyond
from ...._runtime.plain import sqrt, rule, MATH as np

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def _slope_beyond(t, root, R1, R2, b):
    return 2.0 * t / R1 + 2.0 * root / R2 - b / R2 * atan2(root, b)


def _depth_beyond(a, root, R1, R2, b):
    v7 = root / b
    if v7 < 1.0:
        v11 = v7 * v7
        v54 = v7 * v11 * (((((((2.229767813968649e-06 * v11 + 0.0021043873129700233) * v11 + 0.04325113828415611) * v11 + 0.2725778671008127) * v11 + 0.7123414383945195) * v11 + 0.8116412201960678) * v11 + 0.3333333333333333) / ((((((0.002445452808893491 * v11 + 0.06453295925870227) * v11 + 0.5368820963772863) * v11 + 1.9680296155712274) * v11 + 3.5294070829658954) * v11 + 3.034923660588189) * v11 + 1.0))
    else:
        v54 = v7 - atan(v7)
    return a * (a / R1 + b / R2 * v54)


def _depth(a, R1, R2, b):
    if a < b:
        return a * a / R1
    v9 = a - b
    v10 = v9 / b
    if v10 < 0.42:
        v56 = v10 * sqrt(v10) * ((((((0.0005288491342179178 * v10 + 0.038096760299703034) * v10 + 0.4065213849117787) * v10 + 1.438682033198726) * v10 + 1.9979042349620892) * v10 + 0.9428090415820634) / (((((0.006421883194715949 * v10 + 0.15001504718401248) * v10 + 0.9450913324352289) * v10 + 2.37401087025821) * v10 + 2.569097449054519) * v10 + 1.0))
    else:
        v16 = sqrt(v9 * (a + b)) / b
        v56 = v16 - atan(v16)
    return a * (a / R1 + b / R2 * v56)


def _force_beyond(a, root, R1, R2, b, E_star):
    v8 = a * a
    v21 = root / b
    if v21 < 1.0:
        v25 = v21 * v21
        v68 = v21 * v25 * (((((((2.229767813968649e-06 * v25 + 0.0021043873129700233) * v25 + 0.04325113828415611) * v25 + 0.2725778671008127) * v25 + 0.7123414383945195) * v25 + 0.8116412201960678) * v25 + 0.3333333333333333) / ((((((0.002445452808893491 * v25 + 0.06453295925870227) * v25 + 0.5368820963772863) * v25 + 1.9680296155712274) * v25 + 3.5294070829658954) * v25 + 3.034923660588189) * v25 + 1.0))
    else:
        v68 = v21 - atan(v21)
    return E_star * (4.0 * (a * v8) / (3.0 * R1) + root * (root * root) / (3.0 * R2) + b / R2 * v8 * v68)


def _force(a, R1, R2, b, E_star):
    v8 = 3.0 * R1
    v11 = a * a
    v12 = a * v11
    if a < b:
        return 4.0 * E_star / v8 * v12
    v14 = a - b
    v16 = v14 * (a + b)
    v17 = sqrt(v16)
    v22 = v14 / b
    if v22 < 0.42:
        v65 = v22 * sqrt(v22) * ((((((0.0005288491342179178 * v22 + 0.038096760299703034) * v22 + 0.4065213849117787) * v22 + 1.438682033198726) * v22 + 1.9979042349620892) * v22 + 0.9428090415820634) / (((((0.006421883194715949 * v22 + 0.15001504718401248) * v22 + 0.9450913324352289) * v22 + 2.37401087025821) * v22 + 2.569097449054519) * v22 + 1.0))
    else:
        v25 = v17 / b
        v65 = v25 - atan(v25)
    return E_star * (4.0 * v12 / v8 + b / R2 * v11 * v65 + v16 * v17 / (3.0 * R2))


def _displacement(r, a, R1, R2, b):
    v6 = r - b
    v13 = a - b
    v15 = a + b
    v67 = b / R2
    if r > a:
        v5 = a if a < b or a != a else b
        if a > b:
            v11 = sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * (r + b))
            v12 = b / r
            v18 = r - a
            v23 = sqrt((v13 if v13 > 0.0 or v13 != v13 else 0.0) * v15) / sqrt((v18 if v18 > 0.0 or v18 != v18 else 0.0) * (r + a))
            v25 = asinh(v23 / v12)
            v30 = 0.0 - expm1(-2.0 * v25)
            v33 = v30 if v30 > 0.0 else inf
            v50 = b * b
            v54 = v12 * v12
            v76 = []
            for node, weight in RULE_0(v25 / 1.0):
                v35 = node * v25
                v44 = v23 * (exp(-v35) * (0.0 - expm1(-2.0 * (v25 - v35))) / v33)
                v45 = v44 * v44
                v47 = sqrt(1.0 + v45)
                v49 = v11 * v44 / v47
                v53 = sqrt(v50 + v49 * v49)
                v75 = (2.0 * v53 / R1 + 2.0 * v49 / R2 - v67 * atan2(v49, b)) * v49 / v53 * atan2(v53, v11 / v47) * (sqrt(v54 + v45) / (v47 * v47 * v47))
                v76.append(weight * v75)
            v76 = fsum(v76) * v25
            v78 = v11 * v76
        else:
            v78 = 0.0
        v89 = v5 / (r + sqrt((r - v5) * (r + v5)))
        v91 = v89 * v89
        return 2.0 * (v5 * v5) / (3.141592653589793 * R1) * (v5 / r * (0.6666666666666666 + v91 * (((((((((-0.7327347664453868 * v91 + -32.15553480435792) * v91 + -332.23363563146734) * v91 + -1070.7082873491413) * v91 + -85.27694715374247) * v91 + 5044.821368830373) * v91 + 8082.413158212496) * v91 + 3759.725330928701) * v91 + 0.26666666666720995) / ((((((((0.21387262524856868 * v91 + 32.12935731379798) * v91 + 746.8124983579742) * v91 + 6202.125133759036) * v91 + 23553.080984642995) * v91 + 44404.005348491315) * v91 + 40380.01430284195) * v91 + 14099.684276696918) * v91 + 1.0)))) + 0.6366197723675814 * v78
    if a < b:
        v202 = a * a / R1
    else:
        v153 = v13 / b
        if v153 < 0.42:
            v197 = v153 * sqrt(v153) * ((((((0.0005288491342179178 * v153 + 0.038096760299703034) * v153 + 0.4065213849117787) * v153 + 1.438682033198726) * v153 + 1.9979042349620892) * v153 + 0.9428090415820634) / (((((0.006421883194715949 * v153 + 0.15001504718401248) * v153 + 0.9450913324352289) * v153 + 2.37401087025821) * v153 + 2.569097449054519) * v153 + 1.0))
        else:
            v158 = sqrt(v13 * v15) / b
            v197 = v158 - atan(v158)
        v202 = a * (a / R1 + v67 * v197)
    v206 = r * r / (2.0 * R1)
    return v202 - (v206 if r < b else v206 + v6 * v6 / (2.0 * R2))


def _radius_from_depth(d, R1, R2, b):

    def curve(a, root):
        rate = a * _slope_beyond(a, root, R1, R2, b)
        return (_depth_beyond(a, root, R1, R2, b), rate)
    return inverse_beyond(curve, d, b, 2.0, leaving=(3.0, 2.0))


def _radius_from_force(F, R1, R2, b, E_star):

    def curve(a, root):
        rate = 2 * E_star * a ** 2 * _slope_beyond(a, root, R1, R2, b)
        return (_force_beyond(a, root, R1, R2, b, E_star), rate)
    return inverse_beyond(curve, F, b, 3.0, leaving=(3.0, 3.0))


def _force_from_depth(d, R1, R2, b, E_star):
    a = _radius_from_depth(d, R1, R2, b)
    change = 2 * E_star * a * (d - _depth(a, R1, R2, b)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force(a, R1, R2, b, E_star) + change


def _depth_from_force(F, R1, R2, b, E_star):
    a = _radius_from_force(F, R1, R2, b, E_star)
    change = (F - _force(a, R1, R2, b, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth(a, R1, R2, b) + change
