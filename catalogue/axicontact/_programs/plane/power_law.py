"""Programs of axicontact.plane.power_law."""

from __future__ import annotations

from math import exp, expm1, fsum, inf, isfinite, log, log1p, nan, pow, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule

C0 = np.array(2.0)
C1 = np.array(0.0)
C2 = np.array(np.inf)
C3 = np.array(1.0)
C4 = np.array(0.5)
C5 = np.array(1.75)
C6 = np.array(1.5)
C7 = np.array(0.75)
C8 = np.array(0.01524698625788054)
C9 = np.array(0.5334320651111477)
C10 = np.array(2.250488865813539)
C11 = np.array(2.8612106440066865)
C12 = np.array(1.3794681629043655)
C13 = np.array(0.2596058532893223)
C14 = np.array(0.015624999999999823)
C15 = np.array(3.278794792785737)
C16 = np.array(49.328555418276075)
C17 = np.array(167.28648538571198)
C18 = np.array(195.37226190335065)
C19 = np.array(90.69722535867314)
C20 = np.array(16.763212110504565)
C21 = np.array(1.7724538509055159)
RULE_0 = rule(((inf, 64),))
RULE_1 = rule(((16.0, 64), (inf, 128)))


def depth(L, a, A, n):
    if L.__class__ is a.__class__ is A.__class__ is n.__class__ is float and L > 1e-30 and (L < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30):
        try:
            if a <= L:
                v92 = a > 0.0
                if v92:
                    v7 = (n + 1.0) / 2.0
                    v9 = v7 + 1.75
                    v14 = (v7 + 0.5) * (v7 + 1.5)
                    v27 = 1.0 / (v9 * v9)
                    v69 = L - a
                    if v92:
                        v75 = v69 / a
                        v82 = sqrt(log1p(v75) if isfinite(v75) else log(L) - log(a))
                        v83 = n + 2.0
                        v85 = 42.0 / v83
                        v90 = v85 / (sqrt(v82 * v82 + v85) + v82)
                        v93 = a / L
                        v104 = -v83
                        v106 = 2.0 * v82
                        v115 = []
                        for node, weight in RULE_0(v90 / 1.0):
                            v96 = node * v90
                            v97 = v82 + v96
                            v103 = sqrt(-expm1(-2.0 * v97 * v97))
                            v114 = exp(v104 * v96 * (v106 + v96)) * (2.0 * v97 / v103) / (1.0 + v103)
                            v115.append(weight * v114)
                        v115 = fsum(v115) * v90
                        v118 = 1.0 + n * (v93 * v93) * v115
                    else:
                        v118 = 1.0
                    value = A * pow(a, n) * (L * (v118 / L) + n * log1p((v69 + sqrt(v69 * (a + L))) / a)) / (1.7724538509055159 * ((v7 * (v7 + 1.0) / v14 if v7 < 1.0 else 1.0 - (v7 + 0.75) / v14) * sqrt(v9) * (1.0 + v27 * (((((((0.01524698625788054 * v27 + 0.5334320651111477) * v27 + 2.250488865813539) * v27 + 2.8612106440066865) * v27 + 1.3794681629043655) * v27 + 0.2596058532893223) * v27 + 0.015624999999999823) / ((((((3.278794792785737 * v27 + 49.328555418276075) * v27 + 167.28648538571198) * v27 + 195.37226190335065) * v27 + 90.69722535867314) * v27 + 16.763212110504565) * v27 + 1.0)))))
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    if value != value and ordinary(L, a, A, n):
                        return value
                    return None
                return 0.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def half_width_from_load(P, A, n, E_star):
    if P.__class__ is A.__class__ is n.__class__ is E_star.__class__ is float and P > 1e-30 and (P < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v7 = n / 2.0 + 0.5
            v9 = v7 + 1.75
            v13 = (v7 + 0.5) * (v7 + 1.5)
            v27 = 1.0 / (v9 * v9)
            v75 = 2.0 * P * ((v7 * (v7 + 1.0) / v13 if v7 < 1.0 else 1.0 - (v7 + 0.75) / v13) * sqrt(v9) * (1.0 + v27 * (((((((0.01524698625788054 * v27 + 0.5334320651111477) * v27 + 2.250488865813539) * v27 + 2.8612106440066865) * v27 + 1.3794681629043655) * v27 + 0.2596058532893223) * v27 + 0.015624999999999823) / ((((((3.278794792785737 * v27 + 49.328555418276075) * v27 + 167.28648538571198) * v27 + 195.37226190335065) * v27 + 90.69722535867314) * v27 + 16.763212110504565) * v27 + 1.0)))) / (1.7724538509055159 * E_star * n * A)
            v77 = n + 0.0
            v79 = pow(v75, 1.0 / v77)
            if v75 > 0.0 and v75 < inf:
                value = v79 + v79 * ((v75 / (pow(v79, n) * pow(v79, 0.0)) - 1.0) / v77)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            value = v79
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_half_width_from_load_P(A, n, E_star):
    v5 = n / (2.0)
    v7 = v5 + (0.5)
    v9 = v7 + (1.75)
    v10 = v7 + (0.5)
    v12 = v7 + (1.5)
    v13 = v10 * v12
    v15 = np.less(v7, (1.0))
    v16 = v7 + (1.0)
    v17 = v7 * v16
    v18 = v17 / v13
    v20 = v7 + (0.75)
    v21 = v20 / v13
    v22 = (1.0) - v21
    v23 = v18 if v15 else v22
    v24 = np.sqrt(v9)
    v25 = v23 * v24
    v26 = v9 * v9
    v27 = (1.0) / v26
    v29 = (0.01524698625788054) * v27
    v31 = v29 + (0.5334320651111477)
    v32 = v31 * v27
    v34 = v32 + (2.250488865813539)
    v35 = v34 * v27
    v37 = v35 + (2.8612106440066865)
    v38 = v37 * v27
    v40 = v38 + (1.3794681629043655)
    v41 = v40 * v27
    v43 = v41 + (0.2596058532893223)
    v44 = v43 * v27
    v46 = v44 + (0.015624999999999823)
    v48 = (3.278794792785737) * v27
    v50 = v48 + (49.328555418276075)
    v51 = v50 * v27
    v53 = v51 + (167.28648538571198)
    v54 = v53 * v27
    v56 = v54 + (195.37226190335065)
    v57 = v56 * v27
    v59 = v57 + (90.69722535867314)
    v60 = v59 * v27
    v62 = v60 + (16.763212110504565)
    v63 = v62 * v27
    v64 = v63 + (1.0)
    v65 = v46 / v64
    v66 = v27 * v65
    v67 = (1.0) + v66
    v68 = v25 * v67
    v72 = (1.7724538509055159) * E_star
    v73 = v72 * n
    v74 = v73 * A
    v77 = n + (0.0)
    v78 = (1.0) / v77
    return (n, v68, v74, v77, v78)


def block_half_width_from_load_P(out, P, n, v68, v74, v77, v78, t0, t1, t2, m0, m1):
    size = out.size
    np.multiply(C0, P, t0)
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    np.multiply(t0, v68, t0)
    np.divide(t0, v74, t0)
    np.power(t0, v78, t1)
    np.greater(t0, C1, m0)
    np.less(t0, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some92 = np.count_nonzero(m1)
    if some92:
        np.power(t1, n, out)
        np.power(t1, C1, t2)
        np.multiply(out, t2, t2)
        np.divide(t0, t2, t2)
        np.subtract(t2, C3, t2)
        np.divide(t2, v77, t2)
        np.multiply(t1, t2, t2)
        np.add(t1, t2, out)
    if some92 != size:
        np.copyto(out, t1, where=~m1)


def prepare_half_width_from_load_all():
    return ()


def block_half_width_from_load_all(out, P, A, n, E_star, t0, t1, t2, t3, t4, m0, m1):
    size = out.size
    np.multiply(n, C4, t0)
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    np.add(t0, C4, t0)
    np.add(t0, C5, t1)
    np.add(t0, C4, t2)
    np.add(t0, C6, t3)
    np.multiply(t2, t3, t3)
    np.less(t0, C3, m0)
    some23 = np.count_nonzero(m0)
    if some23:
        np.add(t0, C3, t2)
        np.multiply(t0, t2, t2)
        np.divide(t2, t3, t2)
    if some23 != size:
        other23 = t4 if some23 else t2
        np.add(t0, C7, other23)
        np.divide(other23, t3, other23)
        np.subtract(C3, other23, other23)
        if some23:
            np.copyto(t2, other23, where=~m0)
    np.sqrt(t1, t3)
    np.multiply(t2, t3, t3)
    np.multiply(t1, t1, t1)
    np.divide(C3, t1, t1)
    np.multiply(C8, t1, t2)
    np.add(t2, C9, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C10, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C11, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C12, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C13, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C14, t2)
    np.multiply(C15, t1, t0)
    np.add(t0, C16, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C17, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C18, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C19, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C20, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C3, t0)
    np.divide(t2, t0, t0)
    np.multiply(t1, t0, t0)
    np.add(C3, t0, t0)
    np.multiply(t3, t0, t0)
    np.multiply(C0, P, t3)
    np.multiply(t3, t0, t0)
    np.multiply(C21, E_star, t3)
    np.multiply(t3, n, t3)
    np.multiply(t3, A, t3)
    np.divide(t0, t3, t3)
    np.add(n, C1, t0)
    np.divide(C3, t0, t1)
    np.power(t3, t1, t1)
    np.greater(t3, C1, m0)
    np.less(t3, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some92 = np.count_nonzero(m1)
    if some92:
        np.power(t1, n, out)
        np.power(t1, C1, t2)
        np.multiply(out, t2, t2)
        np.divide(t3, t2, t2)
        np.subtract(t2, C3, t2)
        np.divide(t2, t0, t2)
        np.multiply(t1, t2, t2)
        np.add(t1, t2, out)
    if some92 != size:
        np.copyto(out, t1, where=~m1)


def load(a, A, n, E_star):
    if a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v7 = n / 2.0 + 0.5
            v9 = v7 + 1.75
            v13 = (v7 + 0.5) * (v7 + 1.5)
            v27 = 1.0 / (v9 * v9)
            value = 1.7724538509055159 * E_star * n * A * pow(a, n) / (2.0 * ((v7 * (v7 + 1.0) / v13 if v7 < 1.0 else 1.0 - (v7 + 0.75) / v13) * sqrt(v9) * (1.0 + v27 * (((((((0.01524698625788054 * v27 + 0.5334320651111477) * v27 + 2.250488865813539) * v27 + 2.8612106440066865) * v27 + 1.3794681629043655) * v27 + 0.2596058532893223) * v27 + 0.015624999999999823) / ((((((3.278794792785737 * v27 + 49.328555418276075) * v27 + 167.28648538571198) * v27 + 195.37226190335065) * v27 + 90.69722535867314) * v27 + 16.763212110504565) * v27 + 1.0)))))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_load_a(A, n, E_star):
    v5 = n / (2.0)
    v7 = v5 + (0.5)
    v9 = v7 + (1.75)
    v10 = v7 + (0.5)
    v12 = v7 + (1.5)
    v13 = v10 * v12
    v15 = np.less(v7, (1.0))
    v16 = v7 + (1.0)
    v17 = v7 * v16
    v18 = v17 / v13
    v20 = v7 + (0.75)
    v21 = v20 / v13
    v22 = (1.0) - v21
    v23 = v18 if v15 else v22
    v24 = np.sqrt(v9)
    v25 = v23 * v24
    v26 = v9 * v9
    v27 = (1.0) / v26
    v29 = (0.01524698625788054) * v27
    v31 = v29 + (0.5334320651111477)
    v32 = v31 * v27
    v34 = v32 + (2.250488865813539)
    v35 = v34 * v27
    v37 = v35 + (2.8612106440066865)
    v38 = v37 * v27
    v40 = v38 + (1.3794681629043655)
    v41 = v40 * v27
    v43 = v41 + (0.2596058532893223)
    v44 = v43 * v27
    v46 = v44 + (0.015624999999999823)
    v48 = (3.278794792785737) * v27
    v50 = v48 + (49.328555418276075)
    v51 = v50 * v27
    v53 = v51 + (167.28648538571198)
    v54 = v53 * v27
    v56 = v54 + (195.37226190335065)
    v57 = v56 * v27
    v59 = v57 + (90.69722535867314)
    v60 = v59 * v27
    v62 = v60 + (16.763212110504565)
    v63 = v62 * v27
    v64 = v63 + (1.0)
    v65 = v46 / v64
    v66 = v27 * v65
    v67 = (1.0) + v66
    v68 = v25 * v67
    v70 = (1.7724538509055159) * E_star
    v71 = v70 * n
    v72 = v71 * A
    v75 = (2.0) * v68
    return (n, v72, v75)


def block_load_a(out, a, n, v72, v75):
    np.power(a, n, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(v72, out, out)
    np.divide(out, v75, out)


def prepare_load_all():
    return ()


def block_load_all(out, a, A, n, E_star, t0, t1, t2, t3, m0):
    size = out.size
    np.multiply(n, C4, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(out, C4, out)
    np.add(out, C5, t0)
    np.add(out, C4, t1)
    np.add(out, C6, t2)
    np.multiply(t1, t2, t2)
    np.less(out, C3, m0)
    some23 = np.count_nonzero(m0)
    if some23:
        np.add(out, C3, t1)
        np.multiply(out, t1, t1)
        np.divide(t1, t2, t1)
    if some23 != size:
        other23 = t3 if some23 else t1
        np.add(out, C7, other23)
        np.divide(other23, t2, other23)
        np.subtract(C3, other23, other23)
        if some23:
            np.copyto(t1, other23, where=~m0)
    np.sqrt(t0, t2)
    np.multiply(t1, t2, t2)
    np.multiply(t0, t0, t0)
    np.divide(C3, t0, t0)
    np.multiply(C8, t0, t1)
    np.add(t1, C9, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C10, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C11, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C12, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C13, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C14, t1)
    np.multiply(C15, t0, out)
    np.add(out, C16, out)
    np.multiply(out, t0, out)
    np.add(out, C17, out)
    np.multiply(out, t0, out)
    np.add(out, C18, out)
    np.multiply(out, t0, out)
    np.add(out, C19, out)
    np.multiply(out, t0, out)
    np.add(out, C20, out)
    np.multiply(out, t0, out)
    np.add(out, C3, out)
    np.divide(t1, out, out)
    np.multiply(t0, out, out)
    np.add(C3, out, out)
    np.multiply(t2, out, out)
    np.multiply(C21, E_star, t2)
    np.multiply(t2, n, t2)
    np.multiply(t2, A, t2)
    np.power(a, n, t0)
    np.multiply(t2, t0, t0)
    np.multiply(C0, out, out)
    np.divide(t0, out, out)


def pressure(x, a, A, n, E_star):
    if x.__class__ is a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is float and x > 1e-30 and (x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if x < a:
                v8 = (n + 1.0) / 2.0
                v10 = v8 + 1.75
                v15 = (v8 + 0.5) * (v8 + 1.5)
                v28 = 1.0 / (v10 * v10)
                v77 = n - 1.0
                v81 = n > 1.0
                v82 = abs(v77)
                if x > 0.0:
                    v93 = (a - x) / x
                    v99 = log1p(v93) if isfinite(v93) else log(a) - log(x)
                    if v99 > 0.0:
                        v104 = v99 - 42.0 / (v82 if v82 > 0.001 or v82 != v82 else 0.001)
                        v105 = v104 if v104 > 0.0 or v104 != v104 else 0.0
                        v106 = sqrt(v99)
                        v111 = v106 - sqrt(v105) if v81 else sqrt(v99 - v105)
                        v114 = 2.0 * v106
                        v119 = -v82
                        v134 = []
                        for node, weight in RULE_1(v111 / 1.0):
                            v113 = node * v111
                            if v81:
                                v122 = v106 - v113
                                v124 = v122 if v122 > 0.0 or v122 != v122 else 0.0
                            else:
                                v124 = v113
                            v133 = exp(v119 * (v113 * (v114 - v113) if v81 else v113 * v113)) * (2.0 * v124 / sqrt(-expm1(-2.0 * v124 * v124)))
                            v134.append(weight * v133)
                        v134 = fsum(v134) * v111
                        v135 = v134
                    else:
                        v135 = 0.0
                    v137 = (1.0 if v81 else pow(x / a, n) * (a / x)) * v135
                else:
                    v137 = 1.0 / v82 if v81 else inf
                value = E_star * (n * n) * A * (pow(a, n) / a if a > 0.0 else pow(a, v77)) * v137 / (3.5449077018110318 * ((v8 * (v8 + 1.0) / v15 if v8 < 1.0 else 1.0 - (v8 + 0.75) / v15) * sqrt(v10) * (1.0 + v28 * (((((((0.01524698625788054 * v28 + 0.5334320651111477) * v28 + 2.250488865813539) * v28 + 2.8612106440066865) * v28 + 1.3794681629043655) * v28 + 0.2596058532893223) * v28 + 0.015624999999999823) / ((((((3.278794792785737 * v28 + 49.328555418276075) * v28 + 167.28648538571198) * v28 + 195.37226190335065) * v28 + 90.69722535867314) * v28 + 16.763212110504565) * v28 + 1.0)))))
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and x > a)) and ordinary(x, a, A, n, E_star):
                    return value
                return None
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def profile(x, A, n):
    if x.__class__ is A.__class__ is n.__class__ is float and x > 1e-30 and (x < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30):
        try:
            value = A * pow(x, n)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_x(A, n):
    return (A, n)


def block_profile_x(out, x, A, n):
    np.power(x, n, out)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    np.multiply(A, out, out)


def prepare_profile_all():
    return ()


def block_profile_all(out, x, A, n):
    np.power(x, n, out)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    np.multiply(A, out, out)


def slope(x, a, A, n):
    if x.__class__ is a.__class__ is A.__class__ is n.__class__ is float and x > 1e-30 and (x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30):
        try:
            if x > a:
                v7 = (n + 1.0) / 2.0
                v9 = v7 + 1.75
                v14 = (v7 + 0.5) * (v7 + 1.5)
                v27 = 1.0 / (v9 * v9)
                if a > 0.0:
                    v74 = (x - a) / a
                    v81 = sqrt(log1p(v74) if isfinite(v74) else log(x) - log(a))
                    v82 = n + 2.0
                    v84 = 42.0 / v82
                    v89 = v84 / (sqrt(v81 * v81 + v84) + v81)
                    v92 = a / x
                    v103 = -v82
                    v105 = 2.0 * v81
                    v114 = []
                    for node, weight in RULE_0(v89 / 1.0):
                        v95 = node * v89
                        v96 = v81 + v95
                        v102 = sqrt(-expm1(-2.0 * v96 * v96))
                        v113 = exp(v103 * v95 * (v105 + v95)) * (2.0 * v96 / v102) / (1.0 + v102)
                        v114.append(weight * v113)
                    v114 = fsum(v114) * v89
                    v117 = 1.0 + n * (v92 * v92) * v114
                else:
                    v117 = 1.0
                value = -n * A * pow(a, n) * (v117 / x) / (1.7724538509055159 * ((v7 * (v7 + 1.0) / v14 if v7 < 1.0 else 1.0 - (v7 + 0.75) / v14) * sqrt(v9) * (1.0 + v27 * (((((((0.01524698625788054 * v27 + 0.5334320651111477) * v27 + 2.250488865813539) * v27 + 2.8612106440066865) * v27 + 1.3794681629043655) * v27 + 0.2596058532893223) * v27 + 0.015624999999999823) / ((((((3.278794792785737 * v27 + 49.328555418276075) * v27 + 167.28648538571198) * v27 + 195.37226190335065) * v27 + 90.69722535867314) * v27 + 16.763212110504565) * v27 + 1.0)))))
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and x > a)) and ordinary(x, a, A, n):
                    return value
                return None
            value = -(n * A * (pow(x, n) / x if x > 0.0 else pow(x, n - 1.0)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and x > a)) and ordinary(x, a, A, n):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_half_width_from_load', 1, 'P', 'A', 'n', 'E_star'): {
        ('P',): (('P',), prepare_half_width_from_load_P, block_half_width_from_load_P, 3, 2, (), False),
        ('P', 'A', 'n', 'E_star'): (('P', 'A', 'n', 'E_star'), prepare_half_width_from_load_all, block_half_width_from_load_all, 5, 2, (), False),
    },
    ('_load', 1, 'a', 'A', 'n', 'E_star'): {
        ('a',): (('a',), prepare_load_a, block_load_a, 0, 0, (), False),
        ('a', 'A', 'n', 'E_star'): (('a', 'A', 'n', 'E_star'), prepare_load_all, block_load_all, 4, 1, (), False),
    },
    ('_profile', 1, 'x', 'A', 'n'): {
        ('x',): (('x',), prepare_profile_x, block_profile_x, 0, 0, (), False),
        ('x', 'A', 'n'): (('x', 'A', 'n'), prepare_profile_all, block_profile_all, 0, 0, (), False),
    },
}
