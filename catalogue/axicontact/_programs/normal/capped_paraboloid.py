"""Programs of axicontact.normal.capped_paraboloid."""

from __future__ import annotations

from math import asinh, atan2, exp, expm1, fsum, inf, nextafter, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.normal import capped_paraboloid as bodies

C0 = np.array(2.0)
C1 = np.array(3.0)
C2 = np.array(4.0)
C3 = np.array(9.42477796076938)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def depth(a, R1, R2, b):
    if a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is float and a > 1e-30 and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30):
        try:
            if a < b:
                return a * a / R1
            return a * (a + (R1 - R2) / R2 * sqrt((a - b) * (a + b))) / R1
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(R1, R2, b):
    v11 = R1 - R2
    v12 = v11 / R2
    return (R1, b, v12)


def block_depth_a(out, a, R1, b, v12, t0, t1, m0):
    size = out.size
    np.less(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some18 = np.count_nonzero(m0)
    if some18:
        np.square(a, out)
        np.divide(out, R1, out)
    if some18 != size:
        other18 = t0 if some18 else out
        np.subtract(a, b, other18)
        np.add(a, b, t1)
        np.multiply(other18, t1, t1)
        np.sqrt(t1, t1)
        np.multiply(v12, t1, t1)
        np.add(a, t1, t1)
        np.multiply(a, t1, t1)
        np.divide(t1, R1, other18)
        if some18:
            np.copyto(out, other18, where=~m0)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, R1, R2, b, t0, t1, m0):
    size = out.size
    np.less(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some18 = np.count_nonzero(m0)
    if some18:
        np.square(a, out)
        np.divide(out, R1, out)
    if some18 != size:
        other18 = t0 if some18 else out
        np.subtract(a, b, other18)
        np.add(a, b, t1)
        np.multiply(other18, t1, t1)
        np.sqrt(t1, t1)
        np.subtract(R1, R2, other18)
        np.divide(other18, R2, other18)
        np.multiply(other18, t1, t1)
        np.add(a, t1, t1)
        np.multiply(a, t1, t1)
        np.divide(t1, R1, other18)
        if some18:
            np.copyto(out, other18, where=~m0)


def depth_from_force(F, R1, R2, b, E_star):
    if F.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._depth_from_force(F, R1, R2, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, R1, R2, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, R1, R2, b):
    if r.__class__ is a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30):
        try:
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
                value = 2.0 * (v5 * v5) / (3.141592653589793 * R1) * (v5 / r * (0.6666666666666666 + v95 * (((((((((-0.7327347664453868 * v95 + -32.15553480435792) * v95 + -332.23363563146734) * v95 + -1070.7082873491413) * v95 + -85.27694715374247) * v95 + 5044.821368830373) * v95 + 8082.413158212496) * v95 + 3759.725330928701) * v95 + 0.26666666666720995) / ((((((((0.21387262524856868 * v95 + 32.12935731379798) * v95 + 746.8124983579742) * v95 + 6202.125133759036) * v95 + 23553.080984642995) * v95 + 44404.005348491315) * v95 + 40380.01430284195) * v95 + 14099.684276696918) * v95 + 1.0)))) + 0.6366197723675814 * v82
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R1, R2, b):
                    return value
                return None
            v167 = 2.0 * R1
            return (a * a / R1 if a < b else a * (a + v63 / R2 * sqrt(v13 * v15)) / R1) - (r * r / v167 if r < b else v69 / v167 + v6 * v9 / (2.0 * R2))
        except (ArithmeticError, ValueError):
            pass
    return None


def energy(a, R1, R2, b, E_star):
    if a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v8 = a - b
            v9 = a + b
            v13 = (R1 - R2) / R2
            v19 = a * a / R1 if a < b else a * (a + v13 * sqrt(v8 * v9)) / R1
            v20 = a if a < b or a != a else b
            v22 = asinh(v20 / v20)
            v28 = 0.0 - expm1(-2.0 * v22)
            v31 = v28 if v28 > 0.0 else inf
            v56 = v20 * v20
            v61 = []
            for node, weight in RULE_0(v22 / 1.0):
                v32 = node * v22
                v41 = v20 * (exp(-v32) * (0.0 - expm1(-2.0 * (v22 - v32))) / v31)
                v54 = v19 - (v41 * v41 / R1 if v41 < b else v41 * (v41 + v13 * sqrt((v41 - b) * (v41 + b))) / R1)
                v60 = v54 * v54 * sqrt(v56 + v41 * v41)
                v61.append(weight * v60)
            v61 = fsum(v61) * v22
            if a > b:
                v65 = sqrt((v8 if v8 > 0.0 or v8 != v8 else 0.0) * v9)
                v67 = asinh(v65 / b)
                v70 = 0.0 - expm1(-2.0 * v67)
                v72 = v70 if v70 > 0.0 else inf
                v84 = b * b
                v95 = []
                for node, weight in RULE_0(v67 / 1.0):
                    v74 = node * v67
                    v83 = v65 * (exp(-v74) * (0.0 - expm1(-2.0 * (v67 - v74))) / v72)
                    v87 = sqrt(v84 + v83 * v83)
                    v92 = v19 - v87 * (v87 + v13 * v83) / R1
                    v94 = v92 * v92 * v83
                    v95.append(weight * v94)
                v95 = fsum(v95) * v67
                v96 = v95
            else:
                v96 = 0.0
            value = E_star * (v61 + v96)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R1, R2, b, E_star):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, R1, R2, b, E_star):
    if a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v8 = 3.0 * R1
            v11 = a * a
            v12 = a * v11
            if a < b:
                return 4.0 * E_star / v8 * v12
            return 2.0 * E_star / v8 * (2.0 * v12 + (R1 - R2) / R2 * (2.0 * v11 + b * b) * sqrt((a - b) * (a + b)))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(R1, R2, b, E_star):
    v6 = (4.0) * E_star
    v8 = (3.0) * R1
    v9 = v6 / v8
    v18 = (2.0) * E_star
    v19 = v18 / v8
    v21 = R1 - R2
    v22 = v21 / R2
    v24 = np.square(b)
    return (b, v9, v19, v22, v24)


def block_force_a(out, a, b, v9, v19, v22, v24, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.square(a, t0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(a, t0, t1)
    np.less(a, b, m0)
    some31 = np.count_nonzero(m0)
    if some31:
        np.multiply(v9, t1, out)
    if some31 != size:
        other31 = t2 if some31 else out
        np.subtract(a, b, other31)
        np.add(a, b, t3)
        np.multiply(other31, t3, t3)
        np.sqrt(t3, t3)
        np.multiply(C0, t1, other31)
        np.multiply(C0, t0, t4)
        np.add(t4, v24, t4)
        np.multiply(v22, t4, t4)
        np.multiply(t4, t3, t3)
        np.add(other31, t3, t3)
        np.multiply(v19, t3, other31)
        if some31:
            np.copyto(out, other31, where=~m0)


def prepare_force_all():
    return ()


def block_force_all(out, a, R1, R2, b, E_star, t0, t1, t2, t3, t4, t5, t6, t7, t8, m0):
    size = out.size
    np.multiply(C1, R1, t0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.square(a, t1)
    np.multiply(a, t1, t2)
    np.less(a, b, m0)
    some31 = np.count_nonzero(m0)
    if some31:
        np.multiply(C2, E_star, out)
        np.divide(out, t0, out)
        np.multiply(out, t2, out)
    if some31 != size:
        other31 = t3 if some31 else out
        np.subtract(a, b, other31)
        np.add(a, b, t4)
        np.multiply(other31, t4, t4)
        np.sqrt(t4, t4)
        np.multiply(C0, E_star, other31)
        np.divide(other31, t0, other31)
        np.multiply(C0, t2, t5)
        np.subtract(R1, R2, t6)
        np.divide(t6, R2, t6)
        np.multiply(C0, t1, t7)
        np.square(b, t8)
        np.add(t7, t8, t8)
        np.multiply(t6, t8, t8)
        np.multiply(t8, t4, t4)
        np.add(t5, t4, t4)
        np.multiply(other31, t4, other31)
        if some31:
            np.copyto(out, other31, where=~m0)


def force_from_depth(d, R1, R2, b, E_star):
    if d.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._force_from_depth(d, R1, R2, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, R1, R2, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def load_within(r, a, R1, R2, b, E_star):
    if r.__class__ is a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v6 = a if a < b or a != a else b
            v7 = r if r < v6 or r != r else v6
            if v7 > 0.0:
                v8 = v6 - v7
                v13 = sqrt((v8 if v8 > 0.0 or v8 != v8 else 0.0) * (v6 + v7))
                v15 = asinh(v13 / v7)
                v20 = 0.0 - expm1(-2.0 * v15)
                v23 = v20 if v20 > 0.0 else inf
                v24 = v7 * v7
                v45 = []
                for node, weight in RULE_0(v15 / 1.0):
                    v26 = node * v15
                    v35 = v13 * (exp(-v26) * (0.0 - expm1(-2.0 * (v15 - v26))) / v23)
                    v38 = sqrt(v24 + v35 * v35)
                    v44 = 2.0 * v38 / R1 * (v35 / (v38 + v35))
                    v45.append(weight * v44)
                v45 = fsum(v45) * v15
                v47 = v24 * v45
            else:
                v47 = 0.0
            v50 = nextafter(b, inf) if r == b else r
            v111 = R1 - R2
            v117 = b * b
            if a > (v50 if v50 > b or v50 != v50 else b):
                v51 = v50 < b
                v52 = 0.0 if v51 else 1.0
                v53 = a - b
                v57 = sqrt((v53 if v53 > 0.0 or v53 != v53 else 0.0) * (a + b))
                v58 = a - v50
                v62 = sqrt((v58 if v58 > 0.0 or v58 != v58 else 0.0) * (a + v50))
                v70 = asinh((v57 if v51 else v62) / sqrt(abs(v50 - b) * (v50 + b)))
                v71 = 2.0 * v52
                v72 = 1.0 - v71
                v74 = expm1(-2.0 * v70)
                v76 = v71 - v72 * v74
                v78 = v76 if v76 > 0.0 else inf
                v80 = 2.0 * (1.0 - v52)
                v81 = 1.0 - v80
                v83 = v80 - v81 * v74
                v85 = v83 if v83 > 0.0 else inf
                v105 = b * b
                v113 = R1 * R2
                v114 = 2.0 * v111 / v113
                v118 = v117 * v111
                v127 = []
                for node, weight in RULE_0(v70 / 1.0):
                    v89 = node * v70
                    v91 = exp(-v89)
                    v94 = expm1(-2.0 * (v70 - v89))
                    v99 = v57 * (v91 * (v71 - v72 * v94) / v78)
                    v104 = v62 * (v91 * (v80 - v81 * v94) / v85)
                    v108 = sqrt(v105 + v99 * v99)
                    v126 = (2.0 * v108 / R1 + v114 * v99 + v118 / (v113 * v99)) * (v99 / v108) * (v104 / (v108 + v104))
                    v127.append(weight * v126)
                v127 = fsum(v127) * v70
                v129 = v50 * v50 * v127
            else:
                v129 = 0.0
            v130 = r if r < a or r != r else a
            v134 = 3.0 * R1
            v136 = v130 * v130
            v137 = v130 * v136
            v143 = 2.0 * E_star
            value = (4.0 * E_star / v134 * v137 if v130 < b else v143 / v134 * (2.0 * v137 + v111 / R2 * (2.0 * v136 + v117) * sqrt((v130 - b) * (v130 + b)))) + v143 * (v47 + v129)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R1, R2, b, E_star):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def mean_pressure(a, R1, R2, b, E_star):
    if a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v8 = 9.42477796076938 * R1
            if a < b:
                return 4.0 * E_star / v8 * a
            v20 = a * a
            value = 2.0 * E_star / v8 * (2.0 * a + (R1 - R2) * (2.0 * v20 + b * b) * sqrt((a - b) * (a + b)) / (v20 * R2))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_mean_pressure_a(R1, R2, b, E_star):
    v6 = (4.0) * E_star
    v8 = (9.42477796076938) * R1
    v9 = v6 / v8
    v16 = (2.0) * E_star
    v17 = v16 / v8
    v19 = R1 - R2
    v22 = np.square(b)
    return (R2, b, v9, v17, v19, v22)


def block_mean_pressure_a(out, a, R2, b, v9, v17, v19, v22, t0, t1, t2, t3, m0):
    size = out.size
    np.less(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some31 = np.count_nonzero(m0)
    if some31:
        np.multiply(v9, a, out)
    if some31 != size:
        other31 = t0 if some31 else out
        np.subtract(a, b, other31)
        np.add(a, b, t1)
        np.multiply(other31, t1, t1)
        np.sqrt(t1, t1)
        np.multiply(C0, a, other31)
        np.square(a, t2)
        np.multiply(C0, t2, t3)
        np.add(t3, v22, t3)
        np.multiply(v19, t3, t3)
        np.multiply(t3, t1, t1)
        np.multiply(t2, R2, t2)
        np.divide(t1, t2, t2)
        np.add(other31, t2, t2)
        np.multiply(v17, t2, other31)
        if some31:
            np.copyto(out, other31, where=~m0)


def prepare_mean_pressure_all():
    return ()


def block_mean_pressure_all(out, a, R1, R2, b, E_star, t0, t1, t2, t3, t4, t5, t6, t7, m0):
    size = out.size
    np.multiply(C3, R1, t0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.less(a, b, m0)
    some31 = np.count_nonzero(m0)
    if some31:
        np.multiply(C2, E_star, out)
        np.divide(out, t0, out)
        np.multiply(out, a, out)
    if some31 != size:
        other31 = t1 if some31 else out
        np.subtract(a, b, other31)
        np.add(a, b, t2)
        np.multiply(other31, t2, t2)
        np.sqrt(t2, t2)
        np.multiply(C0, E_star, other31)
        np.divide(other31, t0, other31)
        np.multiply(C0, a, t3)
        np.subtract(R1, R2, t4)
        np.square(a, t5)
        np.multiply(C0, t5, t6)
        np.square(b, t7)
        np.add(t6, t7, t7)
        np.multiply(t4, t7, t7)
        np.multiply(t7, t2, t2)
        np.multiply(t5, R2, t5)
        np.divide(t2, t5, t5)
        np.add(t3, t5, t5)
        np.multiply(other31, t5, other31)
        if some31:
            np.copyto(out, other31, where=~m0)


def pressure(r, a, R1, R2, b, E_star):
    if r.__class__ is a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if r < a:
                v20 = r == b
                if (v20 and a > b) and R1 > R2:
                    return inf
                v6 = a if a < b or a != a else b
                v23 = nextafter(b, inf) if v20 else r
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
                    v73 = R1 - R2
                    v75 = R1 * R2
                    v76 = 2.0 * v73 / v75
                    v80 = b * b * v73
                    v86 = []
                    for node, weight in RULE_0(v44 / 1.0):
                        v56 = node * v44
                        v66 = v31 * (exp(-v56) * (v45 - v46 * expm1(-2.0 * (v44 - v56))) / v53)
                        v70 = sqrt(v67 + v66 * v66)
                        v85 = (2.0 * v70 / R1 + v76 * v66 + v80 / (v75 * v66)) * v66 / v70
                        v86.append(weight * v85)
                    v86 = fsum(v86) * v44
                    v87 = v86
                else:
                    v87 = 0.0
                value = (2.0 * E_star / (3.141592653589793 * R1) * sqrt((v6 - r) * (v6 + r)) if r < v6 else 0.0) + E_star / 3.141592653589793 * v87
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R1, R2, b, E_star):
                    return value
                return None
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def profile(r, R1, R2, b):
    if r.__class__ is R1.__class__ is R2.__class__ is b.__class__ is float and r > 1e-30 and (r < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30):
        try:
            v7 = 2.0 * R1
            if r < b:
                return r * r / v7
            return b * b / v7 + (r - b) * (r + b) / (2.0 * R2)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_r(R1, R2, b):
    v7 = (2.0) * R1
    v9 = np.square(b)
    v10 = v9 / v7
    v14 = (2.0) * R2
    return (b, v7, v10, v14)


def block_profile_r(out, r, b, v7, v10, v14, t0, t1, m0):
    size = out.size
    np.less(r, b, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some17 = np.count_nonzero(m0)
    if some17:
        np.square(r, out)
        np.divide(out, v7, out)
    if some17 != size:
        other17 = t0 if some17 else out
        np.subtract(r, b, other17)
        np.add(r, b, t1)
        np.multiply(other17, t1, t1)
        np.divide(t1, v14, t1)
        np.add(v10, t1, other17)
        if some17:
            np.copyto(out, other17, where=~m0)


def prepare_profile_all():
    return ()


def block_profile_all(out, r, R1, R2, b, t0, t1, t2, t3, m0):
    size = out.size
    np.less(r, b, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.multiply(C0, R1, t0)
    some17 = np.count_nonzero(m0)
    if some17:
        np.square(r, out)
        np.divide(out, t0, out)
    if some17 != size:
        other17 = t1 if some17 else out
        np.square(b, other17)
        np.divide(other17, t0, other17)
        np.subtract(r, b, t2)
        np.add(r, b, t3)
        np.multiply(t2, t3, t3)
        np.multiply(C0, R2, t2)
        np.divide(t3, t2, t2)
        np.add(other17, t2, other17)
        if some17:
            np.copyto(out, other17, where=~m0)


def radius_from_depth(d, R1, R2, b):
    if d.__class__ is R1.__class__ is R2.__class__ is b.__class__ is float and d > 1e-30 and (d < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30):
        try:
            value = bodies._radius_from_depth(d, R1, R2, b)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, R1, R2, b):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, R1, R2, b, E_star):
    if F.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._radius_from_force(F, R1, R2, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, R1, R2, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def stiffness(a, E_star, R1=1.0, R2=1.0, b=1.0):
    if a.__class__ is E_star.__class__ is R1.__class__ is R2.__class__ is b.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30):
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
    ('_depth', 1, 'a', 'R1', 'R2', 'b'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 2, 1, (), False),
        ('a', 'R1', 'R2', 'b'): (('a', 'R1', 'R2', 'b'), prepare_depth_all, block_depth_all, 2, 1, (), False),
    },
    ('_force', 1, 'a', 'R1', 'R2', 'b', 'E_star'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 5, 1, (), False),
        ('a', 'R1', 'R2', 'b', 'E_star'): (('a', 'R1', 'R2', 'b', 'E_star'), prepare_force_all, block_force_all, 9, 1, (), False),
    },
    ('_mean_pressure', 1, 'a', 'R1', 'R2', 'b', 'E_star'): {
        ('a',): (('a',), prepare_mean_pressure_a, block_mean_pressure_a, 4, 1, (), False),
        ('a', 'R1', 'R2', 'b', 'E_star'): (('a', 'R1', 'R2', 'b', 'E_star'), prepare_mean_pressure_all, block_mean_pressure_all, 8, 1, (), False),
    },
    ('_profile', 1, 'r', 'R1', 'R2', 'b'): {
        ('r',): (('r',), prepare_profile_r, block_profile_r, 2, 1, (), False),
        ('r', 'R1', 'R2', 'b'): (('r', 'R1', 'R2', 'b'), prepare_profile_all, block_profile_all, 4, 1, (), False),
    },
    ('_stiffness', 1, 'a', 'E_star'): {
        ('a',): (('a',), prepare_stiffness_a, block_stiffness_a, 0, 0, (), False),
        ('a', 'E_star'): (('a', 'E_star'), prepare_stiffness_all, block_stiffness_all, 0, 0, (), False),
    },
}
