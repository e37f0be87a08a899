"""Programs of axicontact.adhesive.power_law."""

from __future__ import annotations

from math import atan2, exp, expm1, fsum, inf, isfinite, log, log1p, nan, pow, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.adhesive import power_law as bodies

C0 = np.array(0.5)
C1 = np.array(1.75)
C2 = np.array(1.5)
C3 = np.array(1.0)
C4 = np.array(0.75)
C5 = np.array(0.01524698625788054)
C6 = np.array(0.5334320651111477)
C7 = np.array(2.250488865813539)
C8 = np.array(2.8612106440066865)
C9 = np.array(1.3794681629043655)
C10 = np.array(0.2596058532893223)
C11 = np.array(0.015624999999999823)
C12 = np.array(3.278794792785737)
C13 = np.array(49.328555418276075)
C14 = np.array(167.28648538571198)
C15 = np.array(195.37226190335065)
C16 = np.array(90.69722535867314)
C17 = np.array(16.763212110504565)
C18 = np.array(1.7724538509055159)
C19 = np.array(6.283185307179586)
C20 = np.array(3.5449077018110318)
C21 = np.array(2.0)
C22 = np.array(0.0)
C23 = np.array(np.nan)
C24 = np.array(3.0)
C25 = np.array(np.inf)
C26 = np.array(25.132741228718345)
RULE_0 = rule(((inf, 64),))
RULE_1 = rule(((16.0, 64), (inf, 128)))


def depth(a, A, n, E_star, dgamma):
    if a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v8 = n / 2.0 + 0.5
            v10 = v8 + 1.75
            v14 = (v8 + 0.5) * (v8 + 1.5)
            v28 = 1.0 / (v10 * v10)
            value = 1.7724538509055159 * A * pow(a, n) * ((v8 * (v8 + 1.0) / v14 if v8 < 1.0 else 1.0 - (v8 + 0.75) / v14) * sqrt(v10) * (1.0 + v28 * (((((((0.01524698625788054 * v28 + 0.5334320651111477) * v28 + 2.250488865813539) * v28 + 2.8612106440066865) * v28 + 1.3794681629043655) * v28 + 0.2596058532893223) * v28 + 0.015624999999999823) / ((((((3.278794792785737 * v28 + 49.328555418276075) * v28 + 167.28648538571198) * v28 + 195.37226190335065) * v28 + 90.69722535867314) * v28 + 16.763212110504565) * v28 + 1.0)))) - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(A, n, E_star, dgamma):
    v6 = n / (2.0)
    v8 = v6 + (0.5)
    v10 = v8 + (1.75)
    v11 = v8 + (0.5)
    v13 = v8 + (1.5)
    v14 = v11 * v13
    v16 = np.less(v8, (1.0))
    v17 = v8 + (1.0)
    v18 = v8 * v17
    v19 = v18 / v14
    v21 = v8 + (0.75)
    v22 = v21 / v14
    v23 = (1.0) - v22
    v24 = v19 if v16 else v23
    v25 = np.sqrt(v10)
    v26 = v24 * v25
    v27 = v10 * v10
    v28 = (1.0) / v27
    v30 = (0.01524698625788054) * v28
    v32 = v30 + (0.5334320651111477)
    v33 = v32 * v28
    v35 = v33 + (2.250488865813539)
    v36 = v35 * v28
    v38 = v36 + (2.8612106440066865)
    v39 = v38 * v28
    v41 = v39 + (1.3794681629043655)
    v42 = v41 * v28
    v44 = v42 + (0.2596058532893223)
    v45 = v44 * v28
    v47 = v45 + (0.015624999999999823)
    v49 = (3.278794792785737) * v28
    v51 = v49 + (49.328555418276075)
    v52 = v51 * v28
    v54 = v52 + (167.28648538571198)
    v55 = v54 * v28
    v57 = v55 + (195.37226190335065)
    v58 = v57 * v28
    v60 = v58 + (90.69722535867314)
    v61 = v60 * v28
    v63 = v61 + (16.763212110504565)
    v64 = v63 * v28
    v65 = v64 + (1.0)
    v66 = v47 / v65
    v67 = v28 * v66
    v68 = (1.0) + v67
    v69 = v26 * v68
    v71 = (1.7724538509055159) * A
    v77 = (6.283185307179586) * dgamma
    v78 = v77 / E_star
    v79 = np.sqrt(v78)
    return (n, v69, v71, v79)


def block_depth_a(out, a, n, v69, v71, v79, t0):
    np.power(a, n, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(v71, out, out)
    np.multiply(out, v69, out)
    np.sqrt(a, t0)
    np.multiply(t0, v79, t0)
    np.subtract(out, t0, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, A, n, E_star, dgamma, t0, t1, t2, t3, m0):
    size = out.size
    np.multiply(n, C0, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(out, C0, out)
    np.add(out, C1, t0)
    np.add(out, C0, t1)
    np.add(out, C2, t2)
    np.multiply(t1, t2, t2)
    np.less(out, C3, m0)
    some24 = np.count_nonzero(m0)
    if some24:
        np.add(out, C3, t1)
        np.multiply(out, t1, t1)
        np.divide(t1, t2, t1)
    if some24 != size:
        other24 = t3 if some24 else t1
        np.add(out, C4, other24)
        np.divide(other24, t2, other24)
        np.subtract(C3, other24, other24)
        if some24:
            np.copyto(t1, other24, where=~m0)
    np.sqrt(t0, t2)
    np.multiply(t1, t2, t2)
    np.multiply(t0, t0, t0)
    np.divide(C3, t0, t0)
    np.multiply(C5, t0, t1)
    np.add(t1, C6, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C7, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C8, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C9, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C10, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C11, t1)
    np.multiply(C12, t0, out)
    np.add(out, C13, out)
    np.multiply(out, t0, out)
    np.add(out, C14, out)
    np.multiply(out, t0, out)
    np.add(out, C15, out)
    np.multiply(out, t0, out)
    np.add(out, C16, out)
    np.multiply(out, t0, out)
    np.add(out, C17, out)
    np.multiply(out, t0, out)
    np.add(out, C3, out)
    np.divide(t1, out, out)
    np.multiply(t0, out, out)
    np.add(C3, out, out)
    np.multiply(t2, out, out)
    np.multiply(C18, A, t2)
    np.power(a, n, t0)
    np.multiply(t2, t0, t0)
    np.multiply(t0, out, out)
    np.sqrt(a, t0)
    np.multiply(C19, dgamma, t2)
    np.divide(t2, E_star, t2)
    np.sqrt(t2, t2)
    np.multiply(t0, t2, t2)
    np.subtract(out, t2, out)


def displacement(r, a, A, n, E_star, dgamma):
    if r.__class__ is a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v9 = n / 2.0 + 0.5
            v11 = v9 + 1.75
            v15 = (v9 + 0.5) * (v9 + 1.5)
            v29 = 1.0 / (v11 * v11)
            v70 = (v9 * (v9 + 1.0) / v15 if v9 < 1.0 else 1.0 - (v9 + 0.75) / v15) * sqrt(v11) * (1.0 + v29 * (((((((0.01524698625788054 * v29 + 0.5334320651111477) * v29 + 2.250488865813539) * v29 + 2.8612106440066865) * v29 + 1.3794681629043655) * v29 + 0.2596058532893223) * v29 + 0.015624999999999823) / ((((((3.278794792785737 * v29 + 49.328555418276075) * v29 + 167.28648538571198) * v29 + 195.37226190335065) * v29 + 90.69722535867314) * v29 + 16.763212110504565) * v29 + 1.0)))
            v74 = pow(a, n)
            v76 = r - a
            v128 = r > a
            if v128:
                if a > 0.0:
                    v77 = v76 / a
                    v84 = sqrt(log1p(v77) if isfinite(v77) else log(r) - log(a))
                    v87 = 42.0 / (n + 1.0)
                    v92 = v87 / (sqrt(v84 * v84 + v87) + v84)
                    v97 = 2.0 * v84
                    v100 = a / r
                    v111 = -n
                    v117 = []
                    for node, weight in RULE_0(v92 / 1.0):
                        v95 = node * v92
                        v96 = v84 + v95
                        v99 = v95 * (v97 + v95)
                        v116 = atan2(v100 * exp(-v99), sqrt(-expm1(-2.0 * v96 * v96))) * exp(v111 * v99) * 2.0 * v96
                        v117.append(weight * v116)
                    v117 = fsum(v117) * v92
                    v119 = n * v117
                else:
                    v119 = 0.0
                v129 = 2.0 * A / 1.7724538509055159 * v74 * v119 * v70
            else:
                v129 = 1.7724538509055159 * A * v74 * v70 - A * pow(r, n)
            value = v129 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star) * (0.6366197723675814 * atan2(a, sqrt((v76 if v76 > 0.0 or v76 != v76 else 0.0) * (r + a))) if v128 else 1.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, A, n, E_star, dgamma):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, A, n, E_star, dgamma):
    if a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v8 = n / 2.0 + 0.5
            v10 = v8 + 1.75
            v14 = (v8 + 0.5) * (v8 + 1.5)
            v28 = 1.0 / (v10 * v10)
            value = 3.5449077018110318 * E_star * n * A / (n + 1.0) * a * pow(a, n) * ((v8 * (v8 + 1.0) / v14 if v8 < 1.0 else 1.0 - (v8 + 0.75) / v14) * sqrt(v10) * (1.0 + v28 * (((((((0.01524698625788054 * v28 + 0.5334320651111477) * v28 + 2.250488865813539) * v28 + 2.8612106440066865) * v28 + 1.3794681629043655) * v28 + 0.2596058532893223) * v28 + 0.015624999999999823) / ((((((3.278794792785737 * v28 + 49.328555418276075) * v28 + 167.28648538571198) * v28 + 195.37226190335065) * v28 + 90.69722535867314) * v28 + 16.763212110504565) * v28 + 1.0)))) - 2.0 * E_star * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(A, n, E_star, dgamma):
    v6 = n / (2.0)
    v8 = v6 + (0.5)
    v10 = v8 + (1.75)
    v11 = v8 + (0.5)
    v13 = v8 + (1.5)
    v14 = v11 * v13
    v16 = np.less(v8, (1.0))
    v17 = v8 + (1.0)
    v18 = v8 * v17
    v19 = v18 / v14
    v21 = v8 + (0.75)
    v22 = v21 / v14
    v23 = (1.0) - v22
    v24 = v19 if v16 else v23
    v25 = np.sqrt(v10)
    v26 = v24 * v25
    v27 = v10 * v10
    v28 = (1.0) / v27
    v30 = (0.01524698625788054) * v28
    v32 = v30 + (0.5334320651111477)
    v33 = v32 * v28
    v35 = v33 + (2.250488865813539)
    v36 = v35 * v28
    v38 = v36 + (2.8612106440066865)
    v39 = v38 * v28
    v41 = v39 + (1.3794681629043655)
    v42 = v41 * v28
    v44 = v42 + (0.2596058532893223)
    v45 = v44 * v28
    v47 = v45 + (0.015624999999999823)
    v49 = (3.278794792785737) * v28
    v51 = v49 + (49.328555418276075)
    v52 = v51 * v28
    v54 = v52 + (167.28648538571198)
    v55 = v54 * v28
    v57 = v55 + (195.37226190335065)
    v58 = v57 * v28
    v60 = v58 + (90.69722535867314)
    v61 = v60 * v28
    v63 = v61 + (16.763212110504565)
    v64 = v63 * v28
    v65 = v64 + (1.0)
    v66 = v47 / v65
    v67 = v28 * v66
    v68 = (1.0) + v67
    v69 = v26 * v68
    v71 = (3.5449077018110318) * E_star
    v72 = v71 * n
    v73 = v72 * A
    v74 = n + (1.0)
    v75 = v73 / v74
    v80 = (2.0) * E_star
    v84 = (6.283185307179586) * dgamma
    v85 = v84 / E_star
    v86 = np.sqrt(v85)
    return (n, v69, v75, v80, v86)


def block_force_a(out, a, n, v69, v75, v80, v86, t0, t1):
    np.multiply(v75, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.power(a, n, t0)
    np.multiply(out, t0, t0)
    np.multiply(t0, v69, t0)
    np.multiply(v80, a, out)
    np.sqrt(a, t1)
    np.multiply(t1, v86, t1)
    np.multiply(out, t1, t1)
    np.subtract(t0, t1, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, A, n, E_star, dgamma, t0, t1, t2, t3, m0):
    size = out.size
    np.multiply(n, C0, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(out, C0, out)
    np.add(out, C1, t0)
    np.add(out, C0, t1)
    np.add(out, C2, t2)
    np.multiply(t1, t2, t2)
    np.less(out, C3, m0)
    some24 = np.count_nonzero(m0)
    if some24:
        np.add(out, C3, t1)
        np.multiply(out, t1, t1)
        np.divide(t1, t2, t1)
    if some24 != size:
        other24 = t3 if some24 else t1
        np.add(out, C4, other24)
        np.divide(other24, t2, other24)
        np.subtract(C3, other24, other24)
        if some24:
            np.copyto(t1, other24, where=~m0)
    np.sqrt(t0, t2)
    np.multiply(t1, t2, t2)
    np.multiply(t0, t0, t0)
    np.divide(C3, t0, t0)
    np.multiply(C5, t0, t1)
    np.add(t1, C6, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C7, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C8, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C9, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C10, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C11, t1)
    np.multiply(C12, t0, out)
    np.add(out, C13, out)
    np.multiply(out, t0, out)
    np.add(out, C14, out)
    np.multiply(out, t0, out)
    np.add(out, C15, out)
    np.multiply(out, t0, out)
    np.add(out, C16, out)
    np.multiply(out, t0, out)
    np.add(out, C17, out)
    np.multiply(out, t0, out)
    np.add(out, C3, out)
    np.divide(t1, out, out)
    np.multiply(t0, out, out)
    np.add(C3, out, out)
    np.multiply(t2, out, out)
    np.multiply(C20, E_star, t2)
    np.multiply(t2, n, t2)
    np.multiply(t2, A, t2)
    np.add(n, C3, t0)
    np.divide(t2, t0, t0)
    np.multiply(t0, a, t0)
    np.power(a, n, t2)
    np.multiply(t0, t2, t2)
    np.multiply(t2, out, out)
    np.multiply(C21, E_star, t2)
    np.multiply(t2, a, t2)
    np.sqrt(a, t0)
    np.multiply(C19, dgamma, t1)
    np.divide(t1, E_star, t1)
    np.sqrt(t1, t1)
    np.multiply(t0, t1, t1)
    np.multiply(t2, t1, t1)
    np.subtract(out, t1, out)


def pressure(r, a, A, n, E_star, dgamma):
    if r.__class__ is a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v94 = a - r
            if r < a:
                v9 = n / 2.0 + 0.5
                v11 = v9 + 1.75
                v15 = (v9 + 0.5) * (v9 + 1.5)
                v29 = 1.0 / (v11 * v11)
                v79 = n - 1.0
                v83 = n > 1.0
                v84 = abs(v79)
                if r > 0.0:
                    v95 = v94 / r
                    v101 = log1p(v95) if isfinite(v95) else log(a) - log(r)
                    if v101 > 0.0:
                        v106 = v101 - 42.0 / (v84 if v84 > 0.001 or v84 != v84 else 0.001)
                        v107 = v106 if v106 > 0.0 or v106 != v106 else 0.0
                        v108 = sqrt(v101)
                        v113 = v108 - sqrt(v107) if v83 else sqrt(v101 - v107)
                        v116 = 2.0 * v108
                        v121 = -v84
                        v136 = []
                        for node, weight in RULE_1(v113 / 1.0):
                            v115 = node * v113
                            if v83:
                                v124 = v108 - v115
                                v126 = v124 if v124 > 0.0 or v124 != v124 else 0.0
                            else:
                                v126 = v115
                            v135 = exp(v121 * (v115 * (v116 - v115) if v83 else v115 * v115)) * (2.0 * v126 / sqrt(-expm1(-2.0 * v126 * v126)))
                            v136.append(weight * v135)
                        v136 = fsum(v136) * v113
                        v137 = v136
                    else:
                        v137 = 0.0
                    v139 = (1.0 if v83 else pow(r / a, n) * (a / r)) * v137
                else:
                    v139 = 1.0 / v84 if v83 else inf
                v143 = E_star * n * A / 1.7724538509055159 * (pow(a, n) / a if a > 0.0 else pow(a, v79)) * v139 * ((v9 * (v9 + 1.0) / v15 if v9 < 1.0 else 1.0 - (v9 + 0.75) / v15) * sqrt(v11) * (1.0 + v29 * (((((((0.01524698625788054 * v29 + 0.5334320651111477) * v29 + 2.250488865813539) * v29 + 2.8612106440066865) * v29 + 1.3794681629043655) * v29 + 0.2596058532893223) * v29 + 0.015624999999999823) / ((((((3.278794792785737 * v29 + 49.328555418276075) * v29 + 167.28648538571198) * v29 + 195.37226190335065) * v29 + 90.69722535867314) * v29 + 16.763212110504565) * v29 + 1.0))))
            else:
                v143 = 0.0
            if r <= a:
                v149 = sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
                v161 = E_star * v149 / (3.141592653589793 * sqrt((v94 if v94 > 0.0 or v94 != v94 else 0.0) * (a + r))) if v149 > 0.0 else 0.0
            else:
                v161 = 0.0
            value = v143 - v161
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, A, n, E_star, dgamma):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_depth(a, A, n, E_star, dgamma, control):
    if a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_depth(a, A, n, E_star, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, A, n, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_force(a, A, n, E_star, dgamma, control):
    if a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_force(a, A, n, E_star, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, A, n, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(A, n, E_star, dgamma, control):
    if A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is float and A > 1e-30 and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_radius(A, n, E_star, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(A, n, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, A, n, E_star, dgamma):
    if d.__class__ is A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is float and d > -1e+30 and (d < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_depth(d, A, n, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, A, n, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, A, n, E_star, dgamma):
    if F.__class__ is A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is float and F > -1e+30 and (F < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_force(F, A, n, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, A, n, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_adhesion_from_pull_off(F, A, n, E_star):
    if F.__class__ is A.__class__ is n.__class__ is E_star.__class__ is float and F > -1e+30 and (F < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if F == 0.0:
                value = 0.0
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            v8 = -F if F < 0.0 else nan
            v15 = 3.0 * v8 / (2.0 * n - 1.0)
            v18 = n / 2.0 + 0.5
            v20 = v18 + 1.75
            v24 = (v18 + 0.5) * (v18 + 1.5)
            v37 = 1.0 / (v20 * v20)
            v79 = n + 1.0
            v86 = v79 * v15 / (3.5449077018110318 * E_star * n * A * ((v18 * (v18 + 1.0) / v24 if v18 < 1.0 else 1.0 - (v18 + 0.75) / v24) * sqrt(v20) * (1.0 + v37 * (((((((0.01524698625788054 * v37 + 0.5334320651111477) * v37 + 2.250488865813539) * v37 + 2.8612106440066865) * v37 + 1.3794681629043655) * v37 + 0.2596058532893223) * v37 + 0.015624999999999823) / ((((((3.278794792785737 * v37 + 49.328555418276075) * v37 + 167.28648538571198) * v37 + 195.37226190335065) * v37 + 90.69722535867314) * v37 + 16.763212110504565) * v37 + 1.0)))))
            v88 = pow(v86, 1.0 / v79)
            v101 = v88 + v88 * ((v86 / (pow(v88, n) * pow(v88, 1.0)) - 1.0) / v79) if v86 > 0.0 and v86 < inf else v88
            v104 = (v8 + v15) / v101
            value = v104 * v104 / (25.132741228718345 * E_star * v101)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_work_of_adhesion_from_pull_off_all_signed():
    return ()


def block_work_of_adhesion_from_pull_off_all_signed(out, F, A, n, E_star, t0, t1, t2, t3, t4, t5, t6, m0, m1, m2):
    size = out.size
    np.equal(F, C22, m0)
    some110 = np.count_nonzero(m0)
    if some110:
        np.copyto(out, C22)
    if some110 != size:
        other110 = t0 if some110 else out
        np.less(F, C22, m1)
        some8 = np.count_nonzero(m1)
        if some8:
            np.negative(F, other110)
        if some8 != size:
            np.copyto(other110, C23, where=~m1)
        np.multiply(C24, other110, t1)
        np.multiply(C21, n, t2)
        np.subtract(t2, C3, t2)
        np.divide(t1, t2, t2)
        np.multiply(n, C0, t1)
        np.add(t1, C0, t1)
        np.add(t1, C1, t3)
        np.add(t1, C0, t4)
        np.add(t1, C2, t5)
        np.multiply(t4, t5, t5)
        np.less(t1, C3, m1)
        some33 = np.count_nonzero(m1)
        if some33:
            np.add(t1, C3, t4)
            np.multiply(t1, t4, t4)
            np.divide(t4, t5, t4)
        if some33 != size:
            other33 = t6 if some33 else t4
            np.add(t1, C4, other33)
            np.divide(other33, t5, other33)
            np.subtract(C3, other33, other33)
            if some33:
                np.copyto(t4, other33, where=~m1)
        np.sqrt(t3, t5)
        np.multiply(t4, t5, t5)
        np.multiply(t3, t3, t3)
        np.divide(C3, t3, t3)
        np.multiply(C5, t3, t4)
        np.add(t4, C6, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C7, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C8, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C9, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C10, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C11, t4)
        np.multiply(C12, t3, t1)
        np.add(t1, C13, t1)
        np.multiply(t1, t3, t1)
        np.add(t1, C14, t1)
        np.multiply(t1, t3, t1)
        np.add(t1, C15, t1)
        np.multiply(t1, t3, t1)
        np.add(t1, C16, t1)
        np.multiply(t1, t3, t1)
        np.add(t1, C17, t1)
        np.multiply(t1, t3, t1)
        np.add(t1, C3, t1)
        np.divide(t4, t1, t1)
        np.multiply(t3, t1, t1)
        np.add(C3, t1, t1)
        np.multiply(t5, t1, t1)
        np.add(n, C3, t5)
        np.multiply(t5, t2, t3)
        np.multiply(C20, E_star, t4)
        np.multiply(t4, n, t4)
        np.multiply(t4, A, t4)
        np.multiply(t4, t1, t1)
        np.divide(t3, t1, t1)
        np.divide(C3, t5, t3)
        np.power(t1, t3, t3)
        np.greater(t1, C22, m1)
        np.less(t1, C25, m2)
        np.bitwise_and(m1, m2, m2)
        some101 = np.count_nonzero(m2)
        if some101:
            np.power(t3, n, t4)
            np.power(t3, C3, t6)
            np.multiply(t4, t6, t6)
            np.divide(t1, t6, t6)
            np.subtract(t6, C3, t6)
            np.divide(t6, t5, t6)
            np.multiply(t3, t6, t6)
            np.add(t3, t6, t4)
        if some101 != size:
            np.copyto(t4, t3, where=~m2)
        np.add(other110, t2, t2)
        np.divide(t2, t4, t2)
        np.square(t2, t2)
        np.multiply(C26, E_star, other110)
        np.multiply(other110, t4, t4)
        np.divide(t2, t4, other110)
        if some110:
            np.copyto(out, other110, where=~m0)


BLOCKS = {
    ('_depth', 1, 'a', 'A', 'n', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 1, 0, (), False),
        ('a', 'A', 'n', 'E_star', 'dgamma'): (('a', 'A', 'n', 'E_star', 'dgamma'), prepare_depth_all, block_depth_all, 4, 1, (), False),
    },
    ('_force', 1, 'a', 'A', 'n', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 2, 0, (), False),
        ('a', 'A', 'n', 'E_star', 'dgamma'): (('a', 'A', 'n', 'E_star', 'dgamma'), prepare_force_all, block_force_all, 4, 1, (), False),
    },
    ('_work_of_adhesion_from_pull_off', 0, 'F', 'A', 'n', 'E_star'): {
        ('F', 'A', 'n', 'E_star'): (('F', 'A', 'n', 'E_star'), prepare_work_of_adhesion_from_pull_off_all_signed, block_work_of_adhesion_from_pull_off_all_signed, 7, 3, (), False),
    },
}
