"""Programs of axicontact.normal.rounded_cone."""

from __future__ import annotations

from math import asinh, atan, atan2, exp, expm1, fsum, inf, nextafter, sqrt, tan

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.normal import rounded_cone as bodies

C0 = np.array(2.0)
C1 = np.array(3.0)
C2 = np.array(4.0)
C3 = np.array(9.42477796076938)
C4 = np.array(3.141592653589793)
C5 = np.array(0.0)
C6 = np.array(0.5)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def depth(a, theta, b):
    if a.__class__ is theta.__class__ is b.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30):
        try:
            v3 = tan(theta)
            if a < b:
                return v3 / b * (a * a)
            v11 = sqrt((a - b) * (a + b))
            return v3 * a * (atan(v11 / b) + b / (v11 + a))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(theta, b):
    v3 = np.tan(theta)
    v4 = v3 / b
    return (b, v3, v4)


def block_depth_a(out, a, b, v3, v4, t0, t1, t2, m0):
    size = out.size
    np.less(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some20 = np.count_nonzero(m0)
    if some20:
        np.square(a, out)
        np.multiply(v4, out, out)
    if some20 != size:
        other20 = t0 if some20 else out
        np.subtract(a, b, other20)
        np.add(a, b, t1)
        np.multiply(other20, t1, t1)
        np.sqrt(t1, t1)
        np.divide(t1, b, other20)
        np.arctan(other20, other20)
        np.multiply(v3, a, t2)
        np.add(t1, a, t1)
        np.divide(b, t1, t1)
        np.add(other20, t1, t1)
        np.multiply(t2, t1, other20)
        if some20:
            np.copyto(out, other20, where=~m0)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, theta, b, t0, t1, t2, t3, m0):
    size = out.size
    np.tan(theta, t0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.less(a, b, m0)
    some20 = np.count_nonzero(m0)
    if some20:
        np.divide(t0, b, out)
        np.square(a, t1)
        np.multiply(out, t1, out)
    if some20 != size:
        other20 = t1 if some20 else out
        np.subtract(a, b, other20)
        np.add(a, b, t2)
        np.multiply(other20, t2, t2)
        np.sqrt(t2, t2)
        np.divide(t2, b, other20)
        np.arctan(other20, other20)
        np.multiply(t0, a, t3)
        np.add(t2, a, t2)
        np.divide(b, t2, t2)
        np.add(other20, t2, t2)
        np.multiply(t3, t2, other20)
        if some20:
            np.copyto(out, other20, where=~m0)


def depth_from_force(F, theta, b, E_star):
    if F.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._depth_from_force(F, theta, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, theta, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, theta, b):
    if r.__class__ is a.__class__ is theta.__class__ is b.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30):
        try:
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
                value = 2.0 * v61 / (3.141592653589793 * b) * (v4 * v4) * (v4 / r * (0.6666666666666666 + v90 * (((((((((-0.7327347664453868 * v90 + -32.15553480435792) * v90 + -332.23363563146734) * v90 + -1070.7082873491413) * v90 + -85.27694715374247) * v90 + 5044.821368830373) * v90 + 8082.413158212496) * v90 + 3759.725330928701) * v90 + 0.26666666666720995) / ((((((((0.21387262524856868 * v90 + 32.12935731379798) * v90 + 746.8124983579742) * v90 + 6202.125133759036) * v90 + 23553.080984642995) * v90 + 44404.005348491315) * v90 + 40380.01430284195) * v90 + 14099.684276696918) * v90 + 1.0)))) + 0.6366197723675814 * v76
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, theta, b):
                    return value
                return None
            if a < b:
                v162 = v61 / b * (a * a)
            else:
                v153 = sqrt(v12 * v14)
                v162 = v61 * a * (atan(v153 / b) + b / (v153 + a))
            return v162 - (v61 / v63 * (r * r) if r < b else v61 * (r - b / 2.0))
        except (ArithmeticError, ValueError):
            pass
    return None


def energy(a, theta, b, E_star):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v4 = tan(theta)
            v5 = v4 / b
            v9 = a - b
            v10 = a + b
            if a < b:
                v21 = v5 * (a * a)
            else:
                v12 = sqrt(v9 * v10)
                v21 = v4 * a * (atan(v12 / b) + b / (v12 + a))
            v22 = a if a < b or a != a else b
            v24 = asinh(v22 / v22)
            v30 = 0.0 - expm1(-2.0 * v24)
            v33 = v30 if v30 > 0.0 else inf
            v61 = v22 * v22
            v66 = []
            for node, weight in RULE_0(v24 / 1.0):
                v34 = node * v24
                v43 = v22 * (exp(-v34) * (0.0 - expm1(-2.0 * (v24 - v34))) / v33)
                if v43 < b:
                    v58 = v5 * (v43 * v43)
                else:
                    v49 = sqrt((v43 - b) * (v43 + b))
                    v58 = v4 * v43 * (atan(v49 / b) + b / (v49 + v43))
                v59 = v21 - v58
                v65 = v59 * v59 * sqrt(v61 + v43 * v43)
                v66.append(weight * v65)
            v66 = fsum(v66) * v24
            if a > b:
                v70 = sqrt((v9 if v9 > 0.0 or v9 != v9 else 0.0) * v10)
                v72 = asinh(v70 / b)
                v75 = 0.0 - expm1(-2.0 * v72)
                v77 = v75 if v75 > 0.0 else inf
                v89 = b * b
                v103 = []
                for node, weight in RULE_0(v72 / 1.0):
                    v79 = node * v72
                    v88 = v70 * (exp(-v79) * (0.0 - expm1(-2.0 * (v72 - v79))) / v77)
                    v92 = sqrt(v89 + v88 * v88)
                    v100 = v21 - v4 * v92 * (atan(v88 / b) + b / (v88 + v92))
                    v102 = v100 * v100 * v88
                    v103.append(weight * v102)
                v103 = fsum(v103) * v72
                v104 = v103
            else:
                v104 = 0.0
            value = E_star * (v66 + v104)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, theta, b, E_star):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, theta, b, E_star):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v6 = tan(theta)
            v12 = a * a
            if a < b:
                return 4.0 * E_star * v6 / (3.0 * b) * (a * v12)
            v18 = sqrt((a - b) * (a + b))
            return E_star * v6 * (v12 * atan(v18 / b) + 4.0 * b * v12 / (3.0 * (v18 + a)) + b / 3.0 * v18)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(theta, b, E_star):
    v5 = (4.0) * E_star
    v6 = np.tan(theta)
    v7 = v5 * v6
    v9 = (3.0) * b
    v10 = v7 / v9
    v21 = E_star * v6
    v23 = (4.0) * b
    v29 = b / (3.0)
    return (b, v10, v21, v23, v29)


def block_force_a(out, a, b, v10, v21, v23, v29, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.square(a, t0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.less(a, b, m0)
    some34 = np.count_nonzero(m0)
    if some34:
        np.multiply(a, t0, out)
        np.multiply(v10, out, out)
    if some34 != size:
        other34 = t1 if some34 else out
        np.subtract(a, b, other34)
        np.add(a, b, t2)
        np.multiply(other34, t2, t2)
        np.sqrt(t2, t2)
        np.divide(t2, b, other34)
        np.arctan(other34, other34)
        np.multiply(t0, other34, other34)
        np.multiply(v23, t0, t3)
        np.add(t2, a, t4)
        np.multiply(C1, t4, t4)
        np.divide(t3, t4, t4)
        np.add(other34, t4, t4)
        np.multiply(v29, t2, t2)
        np.add(t4, t2, t2)
        np.multiply(v21, t2, other34)
        if some34:
            np.copyto(out, other34, where=~m0)


def prepare_force_all():
    return ()


def block_force_all(out, a, theta, b, E_star, t0, t1, t2, t3, t4, t5, t6, m0):
    size = out.size
    np.tan(theta, t0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.square(a, t1)
    np.less(a, b, m0)
    some34 = np.count_nonzero(m0)
    if some34:
        np.multiply(C2, E_star, out)
        np.multiply(out, t0, out)
        np.multiply(C1, b, t2)
        np.divide(out, t2, t2)
        np.multiply(a, t1, out)
        np.multiply(t2, out, out)
    if some34 != size:
        other34 = t2 if some34 else out
        np.subtract(a, b, other34)
        np.add(a, b, t3)
        np.multiply(other34, t3, t3)
        np.sqrt(t3, t3)
        np.divide(t3, b, other34)
        np.arctan(other34, other34)
        np.multiply(E_star, t0, t4)
        np.multiply(t1, other34, other34)
        np.multiply(C2, b, t5)
        np.multiply(t5, t1, t5)
        np.add(t3, a, t6)
        np.multiply(C1, t6, t6)
        np.divide(t5, t6, t6)
        np.add(other34, t6, t6)
        np.divide(b, C1, other34)
        np.multiply(other34, t3, t3)
        np.add(t6, t3, t3)
        np.multiply(t4, t3, other34)
        if some34:
            np.copyto(out, other34, where=~m0)


def force_from_depth(d, theta, b, E_star):
    if d.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._force_from_depth(d, theta, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, theta, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def load_within(r, a, theta, b, E_star):
    if r.__class__ is a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v5 = a if a < b or a != a else b
            v6 = r if r < v5 or r != r else v5
            v38 = tan(theta)
            if v6 > 0.0:
                v7 = v5 - v6
                v12 = sqrt((v7 if v7 > 0.0 or v7 != v7 else 0.0) * (v5 + v6))
                v14 = asinh(v12 / v6)
                v19 = 0.0 - expm1(-2.0 * v14)
                v22 = v19 if v19 > 0.0 else inf
                v23 = v6 * v6
                v41 = 2.0 * v38 / b
                v46 = []
                for node, weight in RULE_0(v14 / 1.0):
                    v25 = node * v14
                    v34 = v12 * (exp(-v25) * (0.0 - expm1(-2.0 * (v14 - v25))) / v22)
                    v37 = sqrt(v23 + v34 * v34)
                    v45 = v41 * v37 * (v34 / (v37 + v34))
                    v46.append(weight * v45)
                v46 = fsum(v46) * v14
                v48 = v23 * v46
            else:
                v48 = 0.0
            v51 = nextafter(b, inf) if r == b else r
            if a > (v51 if v51 > b or v51 != v51 else b):
                v52 = v51 < b
                v53 = 0.0 if v52 else 1.0
                v54 = a - b
                v58 = sqrt((v54 if v54 > 0.0 or v54 != v54 else 0.0) * (a + b))
                v59 = a - v51
                v63 = sqrt((v59 if v59 > 0.0 or v59 != v59 else 0.0) * (a + v51))
                v71 = asinh((v58 if v52 else v63) / sqrt(abs(v51 - b) * (v51 + b)))
                v72 = 2.0 * v53
                v73 = 1.0 - v72
                v75 = expm1(-2.0 * v71)
                v77 = v72 - v73 * v75
                v79 = v77 if v77 > 0.0 else inf
                v81 = 2.0 * (1.0 - v53)
                v82 = 1.0 - v81
                v84 = v81 - v82 * v75
                v86 = v84 if v84 > 0.0 else inf
                v106 = b * b
                v112 = 2.0 * b
                v122 = []
                for node, weight in RULE_0(v71 / 1.0):
                    v90 = node * v71
                    v92 = exp(-v90)
                    v95 = expm1(-2.0 * (v71 - v90))
                    v100 = v58 * (v92 * (v72 - v73 * v95) / v79)
                    v105 = v63 * (v92 * (v81 - v82 * v95) / v86)
                    v109 = sqrt(v106 + v100 * v100)
                    v121 = v38 * (atan(v100 / b) + v112 / (v100 + v109)) * (v100 / v109) * (v105 / (v109 + v105))
                    v122.append(weight * v121)
                v122 = fsum(v122) * v71
                v124 = v51 * v51 * v122
            else:
                v124 = 0.0
            v125 = r if r < a or r != r else a
            v132 = v125 * v125
            if v125 < b:
                v154 = 4.0 * E_star * v38 / (3.0 * b) * (v125 * v132)
            else:
                v138 = sqrt((v125 - b) * (v125 + b))
                v154 = E_star * v38 * (v132 * atan(v138 / b) + 4.0 * b * v132 / (3.0 * (v138 + v125)) + b / 3.0 * v138)
            value = v154 + 2.0 * E_star * (v48 + v124)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, theta, b, E_star):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def mean_pressure(a, theta, b, E_star):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v6 = tan(theta)
            if a < b:
                return 4.0 * E_star * v6 / (9.42477796076938 * b) * a
            v15 = sqrt((a - b) * (a + b))
            return E_star * v6 / 3.141592653589793 * (atan(v15 / b) + 4.0 * b / (3.0 * (v15 + a)) + b * v15 / (3.0 * (a * a)))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_mean_pressure_a(theta, b, E_star):
    v5 = (4.0) * E_star
    v6 = np.tan(theta)
    v7 = v5 * v6
    v9 = (9.42477796076938) * b
    v10 = v7 / v9
    v18 = E_star * v6
    v20 = v18 / (3.141592653589793)
    v21 = (4.0) * b
    return (b, v10, v20, v21)


def block_mean_pressure_a(out, a, b, v10, v20, v21, t0, t1, t2, m0):
    size = out.size
    np.less(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some35 = np.count_nonzero(m0)
    if some35:
        np.multiply(v10, a, out)
    if some35 != size:
        other35 = t0 if some35 else out
        np.subtract(a, b, other35)
        np.add(a, b, t1)
        np.multiply(other35, t1, t1)
        np.sqrt(t1, t1)
        np.divide(t1, b, other35)
        np.arctan(other35, other35)
        np.add(t1, a, t2)
        np.multiply(C1, t2, t2)
        np.divide(v21, t2, t2)
        np.add(other35, t2, t2)
        np.multiply(b, t1, t1)
        np.square(a, other35)
        np.multiply(C1, other35, other35)
        np.divide(t1, other35, other35)
        np.add(t2, other35, other35)
        np.multiply(v20, other35, other35)
        if some35:
            np.copyto(out, other35, where=~m0)


def prepare_mean_pressure_all():
    return ()


def block_mean_pressure_all(out, a, theta, b, E_star, t0, t1, t2, t3, t4, t5, m0):
    size = out.size
    np.tan(theta, t0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.less(a, b, m0)
    some35 = np.count_nonzero(m0)
    if some35:
        np.multiply(C2, E_star, out)
        np.multiply(out, t0, out)
        np.multiply(C3, b, t1)
        np.divide(out, t1, t1)
        np.multiply(t1, a, out)
    if some35 != size:
        other35 = t1 if some35 else out
        np.subtract(a, b, other35)
        np.add(a, b, t2)
        np.multiply(other35, t2, t2)
        np.sqrt(t2, t2)
        np.divide(t2, b, other35)
        np.arctan(other35, other35)
        np.multiply(E_star, t0, t3)
        np.divide(t3, C4, t3)
        np.multiply(C2, b, t4)
        np.add(t2, a, t5)
        np.multiply(C1, t5, t5)
        np.divide(t4, t5, t5)
        np.add(other35, t5, t5)
        np.multiply(b, t2, t2)
        np.square(a, other35)
        np.multiply(C1, other35, other35)
        np.divide(t2, other35, other35)
        np.add(t5, other35, other35)
        np.multiply(t3, other35, other35)
        if some35:
            np.copyto(out, other35, where=~m0)


def peak_pressure(a, theta, b, E_star):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if 0.0 < a:
                v5 = a if a < b or a != a else b
                v13 = tan(theta)
                v23 = nextafter(b, inf) if 0.0 == b else 0.0
                if a > (v23 if v23 > b or v23 != v23 else b):
                    v24 = v23 < b
                    v27 = a - b
                    v31 = sqrt((v27 if v27 > 0.0 or v27 != v27 else 0.0) * (a + b))
                    if v24:
                        v37 = v31
                    else:
                        v32 = a - v23
                        v37 = sqrt((v32 if v32 > 0.0 or v32 != v32 else 0.0) * (a + v23))
                    v44 = asinh(v37 / sqrt(abs(v23 - b) * (v23 + b)))
                    v45 = 2.0 * (0.0 if v24 else 1.0)
                    v46 = 1.0 - v45
                    v51 = v45 - v46 * expm1(-2.0 * v44)
                    v53 = v51 if v51 > 0.0 else inf
                    v67 = b * b
                    v73 = 2.0 * b
                    v80 = []
                    for node, weight in RULE_0(v44 / 1.0):
                        v56 = node * v44
                        v66 = v31 * (exp(-v56) * (v45 - v46 * expm1(-2.0 * (v44 - v56))) / v53)
                        v70 = sqrt(v67 + v66 * v66)
                        v79 = v13 * (atan(v66 / b) + v73 / (v66 + v70)) * v66 / v70
                        v80.append(weight * v79)
                    v80 = fsum(v80) * v44
                    v81 = v80
                else:
                    v81 = 0.0
                value = (2.0 * E_star * v13 / (3.141592653589793 * b) * sqrt((v5 - 0.0) * (v5 + 0.0)) if 0.0 < v5 else 0.0) + E_star / 3.141592653589793 * v81
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(a, theta, b, E_star):
                    return value
                return None
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def peak_radius(a, theta=0.7853981633974483, b=1.0, E_star=1.0):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_peak_radius_all():
    return ()


def block_peak_radius_all(out, a):
    np.copyto(out, C5)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError


def pressure(r, a, theta, b, E_star):
    if r.__class__ is a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if r < a:
                v5 = a if a < b or a != a else b
                v13 = tan(theta)
                v24 = nextafter(b, inf) if r == b else r
                if a > (v24 if v24 > b or v24 != v24 else b):
                    v25 = v24 < b
                    v28 = a - b
                    v32 = sqrt((v28 if v28 > 0.0 or v28 != v28 else 0.0) * (a + b))
                    if v25:
                        v38 = v32
                    else:
                        v33 = a - v24
                        v38 = sqrt((v33 if v33 > 0.0 or v33 != v33 else 0.0) * (a + v24))
                    v45 = asinh(v38 / sqrt(abs(v24 - b) * (v24 + b)))
                    v46 = 2.0 * (0.0 if v25 else 1.0)
                    v47 = 1.0 - v46
                    v52 = v46 - v47 * expm1(-2.0 * v45)
                    v54 = v52 if v52 > 0.0 else inf
                    v68 = b * b
                    v74 = 2.0 * b
                    v81 = []
                    for node, weight in RULE_0(v45 / 1.0):
                        v57 = node * v45
                        v67 = v32 * (exp(-v57) * (v46 - v47 * expm1(-2.0 * (v45 - v57))) / v54)
                        v71 = sqrt(v68 + v67 * v67)
                        v80 = v13 * (atan(v67 / b) + v74 / (v67 + v71)) * v67 / v71
                        v81.append(weight * v80)
                    v81 = fsum(v81) * v45
                    v82 = v81
                else:
                    v82 = 0.0
                value = (2.0 * E_star * v13 / (3.141592653589793 * b) * sqrt((v5 - r) * (v5 + r)) if r < v5 else 0.0) + E_star / 3.141592653589793 * v82
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, theta, b, E_star):
                    return value
                return None
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def profile(r, theta, b):
    if r.__class__ is theta.__class__ is b.__class__ is float and r > 1e-30 and (r < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30):
        try:
            v4 = tan(theta)
            if r < b:
                return v4 / (2.0 * b) * (r * r)
            return v4 * (r - b / 2.0)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_r(theta, b):
    v4 = np.tan(theta)
    v6 = (2.0) * b
    v7 = v4 / v6
    v10 = b / (2.0)
    return (b, v4, v7, v10)


def block_profile_r(out, r, b, v4, v7, v10, t0, m0):
    size = out.size
    np.less(r, b, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some13 = np.count_nonzero(m0)
    if some13:
        np.square(r, out)
        np.multiply(v7, out, out)
    if some13 != size:
        other13 = t0 if some13 else out
        np.subtract(r, v10, other13)
        np.multiply(v4, other13, other13)
        if some13:
            np.copyto(out, other13, where=~m0)


def prepare_profile_all():
    return ()


def block_profile_all(out, r, theta, b, t0, t1, m0):
    size = out.size
    np.less(r, b, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.tan(theta, t0)
    some14 = np.count_nonzero(m0)
    if some14:
        np.multiply(C0, b, out)
        np.divide(t0, out, out)
        np.square(r, t1)
        np.multiply(out, t1, out)
    if some14 != size:
        other14 = t1 if some14 else out
        np.multiply(b, C6, other14)
        np.subtract(r, other14, other14)
        np.multiply(t0, other14, other14)
        if some14:
            np.copyto(out, other14, where=~m0)


def radius_from_depth(d, theta, b):
    if d.__class__ is theta.__class__ is b.__class__ is float and d > 1e-30 and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30):
        try:
            value = bodies._radius_from_depth(d, theta, b)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, theta, b):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, theta, b, E_star):
    if F.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._radius_from_force(F, theta, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, theta, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def stiffness(a, E_star, theta=0.7853981633974483, b=1.0):
    if a.__class__ is E_star.__class__ is theta.__class__ is b.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30):
        try:
            return 2.0 * E_star * a
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_stiffness_a(E_star):
    v3 = (2.0) * E_star
    return (v3,)


def block_stiffness_a(out, a, v3):
    np.multiply(v3, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError


def prepare_stiffness_all():
    return ()


def block_stiffness_all(out, a, E_star):
    np.multiply(C0, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(out, a, out)


BLOCKS = {
    ('_depth', 1, 'a', 'theta', 'b'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 3, 1, (), False),
        ('a', 'theta', 'b'): (('a', 'theta', 'b'), prepare_depth_all, block_depth_all, 4, 1, (), False),
    },
    ('_force', 1, 'a', 'theta', 'b', 'E_star'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 5, 1, (), False),
        ('a', 'theta', 'b', 'E_star'): (('a', 'theta', 'b', 'E_star'), prepare_force_all, block_force_all, 7, 1, (), False),
    },
    ('_mean_pressure', 1, 'a', 'theta', 'b', 'E_star'): {
        ('a',): (('a',), prepare_mean_pressure_a, block_mean_pressure_a, 3, 1, (), False),
        ('a', 'theta', 'b', 'E_star'): (('a', 'theta', 'b', 'E_star'), prepare_mean_pressure_all, block_mean_pressure_all, 6, 1, (), False),
    },
    ('_peak_radius', 1, 'a'): {
        ('a',): (('a',), prepare_peak_radius_all, block_peak_radius_all, 0, 0, (), False),
    },
    ('_profile', 1, 'r', 'theta', 'b'): {
        ('r',): (('r',), prepare_profile_r, block_profile_r, 1, 1, (), False),
        ('r', 'theta', 'b'): (('r', 'theta', 'b'), prepare_profile_all, block_profile_all, 2, 1, (), False),
    },
    ('_stiffness', 1, 'a', 'E_star'): {
        ('a',): (('a',), prepare_stiffness_a, block_stiffness_a, 0, 0, (), False),
        ('a', 'E_star'): (('a', 'E_star'), prepare_stiffness_all, block_stiffness_all, 0, 0, (), False),
    },
}
