"""Programs of axicontact.normal.power_law."""

from __future__ import annotations

from math import asinh, atan2, exp, expm1, fsum, hypot, inf, isfinite, log, log1p, pow, sinh, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule

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
C19 = np.array(0.0)
C20 = np.array(np.inf)
C21 = np.array(3.5449077018110318)
C22 = np.array(6.283185307179586)
C23 = np.array(2.0)
RULE_0 = rule(((inf, 64),))
RULE_1 = rule(((16.0, 64), (inf, 128)))
RULE_2 = rule(((1.5, 32), (8.0, 64), (inf, 128)))


def depth(a, A, n):
    if a.__class__ is A.__class__ is n.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30):
        try:
            v6 = n / 2.0 + 0.5
            v8 = v6 + 1.75
            v12 = (v6 + 0.5) * (v6 + 1.5)
            v26 = 1.0 / (v8 * v8)
            value = 1.7724538509055159 * A * pow(a, n) * ((v6 * (v6 + 1.0) / v12 if v6 < 1.0 else 1.0 - (v6 + 0.75) / v12) * sqrt(v8) * (1.0 + v26 * (((((((0.01524698625788054 * v26 + 0.5334320651111477) * v26 + 2.250488865813539) * v26 + 2.8612106440066865) * v26 + 1.3794681629043655) * v26 + 0.2596058532893223) * v26 + 0.015624999999999823) / ((((((3.278794792785737 * v26 + 49.328555418276075) * v26 + 167.28648538571198) * v26 + 195.37226190335065) * v26 + 90.69722535867314) * v26 + 16.763212110504565) * v26 + 1.0))))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(A, n):
    v4 = n / (2.0)
    v6 = v4 + (0.5)
    v8 = v6 + (1.75)
    v9 = v6 + (0.5)
    v11 = v6 + (1.5)
    v12 = v9 * v11
    v14 = np.less(v6, (1.0))
    v15 = v6 + (1.0)
    v16 = v6 * v15
    v17 = v16 / v12
    v19 = v6 + (0.75)
    v20 = v19 / v12
    v21 = (1.0) - v20
    v22 = v17 if v14 else v21
    v23 = np.sqrt(v8)
    v24 = v22 * v23
    v25 = v8 * v8
    v26 = (1.0) / v25
    v28 = (0.01524698625788054) * v26
    v30 = v28 + (0.5334320651111477)
    v31 = v30 * v26
    v33 = v31 + (2.250488865813539)
    v34 = v33 * v26
    v36 = v34 + (2.8612106440066865)
    v37 = v36 * v26
    v39 = v37 + (1.3794681629043655)
    v40 = v39 * v26
    v42 = v40 + (0.2596058532893223)
    v43 = v42 * v26
    v45 = v43 + (0.015624999999999823)
    v47 = (3.278794792785737) * v26
    v49 = v47 + (49.328555418276075)
    v50 = v49 * v26
    v52 = v50 + (167.28648538571198)
    v53 = v52 * v26
    v55 = v53 + (195.37226190335065)
    v56 = v55 * v26
    v58 = v56 + (90.69722535867314)
    v59 = v58 * v26
    v61 = v59 + (16.763212110504565)
    v62 = v61 * v26
    v63 = v62 + (1.0)
    v64 = v45 / v63
    v65 = v26 * v64
    v66 = (1.0) + v65
    v67 = v24 * v66
    v69 = (1.7724538509055159) * A
    return (n, v67, v69)


def block_depth_a(out, a, n, v67, v69):
    np.power(a, n, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(v69, out, out)
    np.multiply(out, v67, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, A, n, t0, t1, t2, t3, m0):
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
    some22 = np.count_nonzero(m0)
    if some22:
        np.add(out, C3, t1)
        np.multiply(out, t1, t1)
        np.divide(t1, t2, t1)
    if some22 != size:
        other22 = t3 if some22 else t1
        np.add(out, C4, other22)
        np.divide(other22, t2, other22)
        np.subtract(C3, other22, other22)
        if some22:
            np.copyto(t1, other22, where=~m0)
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


def depth_from_force(F, A, n, E_star):
    if F.__class__ is A.__class__ is n.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v7 = n / 2.0 + 0.5
            v9 = v7 + 1.75
            v13 = (v7 + 0.5) * (v7 + 1.5)
            v27 = 1.0 / (v9 * v9)
            v68 = (v7 * (v7 + 1.0) / v13 if v7 < 1.0 else 1.0 - (v7 + 0.75) / v13) * sqrt(v9) * (1.0 + v27 * (((((((0.01524698625788054 * v27 + 0.5334320651111477) * v27 + 2.250488865813539) * v27 + 2.8612106440066865) * v27 + 1.3794681629043655) * v27 + 0.2596058532893223) * v27 + 0.015624999999999823) / ((((((3.278794792785737 * v27 + 49.328555418276075) * v27 + 167.28648538571198) * v27 + 195.37226190335065) * v27 + 90.69722535867314) * v27 + 16.763212110504565) * v27 + 1.0)))
            v69 = n + 1.0
            v76 = v69 * F / (3.5449077018110318 * E_star * n * A * v68)
            v84 = v76 > 0.0 and v76 < inf
            if v84:
                v86 = pow(v76, 1.0 / v69)
                v97 = v76 / (v86 + v86 * ((v76 / (pow(v86, n) * pow(v86, 1.0)) - 1.0) / v69) if v84 else v86)
            else:
                v97 = v76
            value = 1.7724538509055159 * A * v68 * v97
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_from_force_F(A, n, E_star):
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
    v69 = n + (1.0)
    v72 = (3.5449077018110318) * E_star
    v73 = v72 * n
    v74 = v73 * A
    v75 = v74 * v68
    v78 = (1.7724538509055159) * A
    v79 = v78 * v68
    v85 = (1.0) / v69
    return (n, v69, v75, v79, v85)


def block_depth_from_force_F(out, F, n, v69, v75, v79, v85, t0, t1, t2, m0, m1):
    size = out.size
    np.multiply(v69, F, out)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    np.divide(out, v75, out)
    np.greater(out, C19, m0)
    np.less(out, C20, m1)
    np.bitwise_and(m0, m1, m1)
    some97 = np.count_nonzero(m1)
    if some97:
        np.power(out, v85, t0)
        some95 = np.count_nonzero(m1)
        if some95:
            np.power(t0, n, t1)
            np.power(t0, C3, t2)
            np.multiply(t1, t2, t2)
            np.divide(out, t2, t2)
            np.subtract(t2, C3, t2)
            np.divide(t2, v69, t2)
            np.multiply(t0, t2, t2)
            np.add(t0, t2, t1)
        if some95 != size:
            np.copyto(t1, t0, where=~m1)
        np.divide(out, t1, t0)
    if some97 != size:
        np.copyto(t0, out, where=~m1)
    np.multiply(v79, t0, out)


def prepare_depth_from_force_all():
    return ()


def block_depth_from_force_all(out, F, A, n, E_star, t0, t1, t2, t3, t4, m0, m1):
    size = out.size
    np.multiply(n, C0, out)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    np.add(out, C0, out)
    np.add(out, C1, t0)
    np.add(out, C0, t1)
    np.add(out, C2, t2)
    np.multiply(t1, t2, t2)
    np.less(out, C3, m0)
    some23 = np.count_nonzero(m0)
    if some23:
        np.add(out, C3, t1)
        np.multiply(out, t1, t1)
        np.divide(t1, t2, t1)
    if some23 != size:
        other23 = t3 if some23 else t1
        np.add(out, C4, other23)
        np.divide(other23, t2, other23)
        np.subtract(C3, other23, other23)
        if some23:
            np.copyto(t1, other23, where=~m0)
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
    np.add(n, C3, t2)
    np.multiply(t2, F, t0)
    np.multiply(C21, E_star, t1)
    np.multiply(t1, n, t1)
    np.multiply(t1, A, t1)
    np.multiply(t1, out, t1)
    np.divide(t0, t1, t1)
    np.multiply(C18, A, t0)
    np.multiply(t0, out, out)
    np.greater(t1, C19, m0)
    np.less(t1, C20, m1)
    np.bitwise_and(m0, m1, m1)
    some97 = np.count_nonzero(m1)
    if some97:
        np.divide(C3, t2, t0)
        np.power(t1, t0, t0)
        some95 = np.count_nonzero(m1)
        if some95:
            np.power(t0, n, t3)
            np.power(t0, C3, t4)
            np.multiply(t3, t4, t4)
            np.divide(t1, t4, t4)
            np.subtract(t4, C3, t4)
            np.divide(t4, t2, t4)
            np.multiply(t0, t4, t4)
            np.add(t0, t4, t3)
        if some95 != size:
            np.copyto(t3, t0, where=~m1)
        np.divide(t1, t3, t0)
    if some97 != size:
        np.copyto(t0, t1, where=~m1)
    np.multiply(out, t0, out)


def displacement(r, a, A, n):
    if r.__class__ is a.__class__ is A.__class__ is n.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30):
        try:
            v7 = n / 2.0 + 0.5
            v9 = v7 + 1.75
            v13 = (v7 + 0.5) * (v7 + 1.5)
            v27 = 1.0 / (v9 * v9)
            v68 = (v7 * (v7 + 1.0) / v13 if v7 < 1.0 else 1.0 - (v7 + 0.75) / v13) * sqrt(v9) * (1.0 + v27 * (((((((0.01524698625788054 * v27 + 0.5334320651111477) * v27 + 2.250488865813539) * v27 + 2.8612106440066865) * v27 + 1.3794681629043655) * v27 + 0.2596058532893223) * v27 + 0.015624999999999823) / ((((((3.278794792785737 * v27 + 49.328555418276075) * v27 + 167.28648538571198) * v27 + 195.37226190335065) * v27 + 90.69722535867314) * v27 + 16.763212110504565) * v27 + 1.0)))
            v72 = pow(a, n)
            if r > a:
                if a > 0.0:
                    v75 = (r - a) / a
                    v82 = sqrt(log1p(v75) if isfinite(v75) else log(r) - log(a))
                    v85 = 42.0 / (n + 1.0)
                    v90 = v85 / (sqrt(v82 * v82 + v85) + v82)
                    v95 = 2.0 * v82
                    v98 = a / r
                    v109 = -n
                    v115 = []
                    for node, weight in RULE_0(v90 / 1.0):
                        v93 = node * v90
                        v94 = v82 + v93
                        v97 = v93 * (v95 + v93)
                        v114 = atan2(v98 * exp(-v97), sqrt(-expm1(-2.0 * v94 * v94))) * exp(v109 * v97) * 2.0 * v94
                        v115.append(weight * v114)
                    v115 = fsum(v115) * v90
                    v117 = n * v115
                else:
                    v117 = 0.0
                value = 2.0 * A / 1.7724538509055159 * v72 * v117 * v68
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, A, n):
                    return value
                return None
            value = 1.7724538509055159 * A * v72 * v68 - A * pow(r, n)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, A, n):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def energy(a, A, n, E_star):
    if a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v7 = n / 2.0 + 0.5
            v9 = v7 + 1.75
            v13 = (v7 + 0.5) * (v7 + 1.5)
            v27 = 1.0 / (v9 * v9)
            v68 = (v7 * (v7 + 1.0) / v13 if v7 < 1.0 else 1.0 - (v7 + 0.75) / v13) * sqrt(v9) * (1.0 + v27 * (((((((0.01524698625788054 * v27 + 0.5334320651111477) * v27 + 2.250488865813539) * v27 + 2.8612106440066865) * v27 + 1.3794681629043655) * v27 + 0.2596058532893223) * v27 + 0.015624999999999823) / ((((((3.278794792785737 * v27 + 49.328555418276075) * v27 + 167.28648538571198) * v27 + 195.37226190335065) * v27 + 90.69722535867314) * v27 + 16.763212110504565) * v27 + 1.0)))
            v75 = 2.0 * n
            value = 6.283185307179586 * E_star * (n * n) * (A * A) / ((v75 + 1.0) * (n + 1.0)) * a * pow(a, v75) * (v68 * v68)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_energy_a(A, n, E_star):
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
    v70 = (6.283185307179586) * E_star
    v71 = np.square(n)
    v72 = v70 * v71
    v73 = np.square(A)
    v74 = v72 * v73
    v75 = (2.0) * n
    v76 = v75 + (1.0)
    v77 = n + (1.0)
    v78 = v76 * v77
    v79 = v74 / v78
    v83 = np.square(v68)
    return (v75, v79, v83)


def block_energy_a(out, a, v75, v79, v83, t0):
    np.multiply(v79, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.power(a, v75, t0)
    np.multiply(out, t0, t0)
    np.multiply(t0, v83, out)


def prepare_energy_all():
    return ()


def block_energy_all(out, a, A, n, E_star, t0, t1, t2, t3, m0):
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
    some23 = np.count_nonzero(m0)
    if some23:
        np.add(out, C3, t1)
        np.multiply(out, t1, t1)
        np.divide(t1, t2, t1)
    if some23 != size:
        other23 = t3 if some23 else t1
        np.add(out, C4, other23)
        np.divide(other23, t2, other23)
        np.subtract(C3, other23, other23)
        if some23:
            np.copyto(t1, other23, where=~m0)
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
    np.multiply(C22, E_star, t2)
    np.square(n, t0)
    np.multiply(t2, t0, t0)
    np.square(A, t2)
    np.multiply(t0, t2, t2)
    np.multiply(C23, n, t0)
    np.add(t0, C3, t1)
    np.add(n, C3, t3)
    np.multiply(t1, t3, t3)
    np.divide(t2, t3, t3)
    np.multiply(t3, a, t3)
    np.power(a, t0, t0)
    np.multiply(t3, t0, t0)
    np.square(out, out)
    np.multiply(t0, out, out)


def force(a, A, n, E_star):
    if a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v7 = n / 2.0 + 0.5
            v9 = v7 + 1.75
            v13 = (v7 + 0.5) * (v7 + 1.5)
            v27 = 1.0 / (v9 * v9)
            value = 3.5449077018110318 * E_star * n * A / (n + 1.0) * a * pow(a, n) * ((v7 * (v7 + 1.0) / v13 if v7 < 1.0 else 1.0 - (v7 + 0.75) / v13) * sqrt(v9) * (1.0 + v27 * (((((((0.01524698625788054 * v27 + 0.5334320651111477) * v27 + 2.250488865813539) * v27 + 2.8612106440066865) * v27 + 1.3794681629043655) * v27 + 0.2596058532893223) * v27 + 0.015624999999999823) / ((((((3.278794792785737 * v27 + 49.328555418276075) * v27 + 167.28648538571198) * v27 + 195.37226190335065) * v27 + 90.69722535867314) * v27 + 16.763212110504565) * v27 + 1.0))))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(A, n, E_star):
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
    v70 = (3.5449077018110318) * E_star
    v71 = v70 * n
    v72 = v71 * A
    v73 = n + (1.0)
    v74 = v72 / v73
    return (n, v68, v74)


def block_force_a(out, a, n, v68, v74, t0):
    np.multiply(v74, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.power(a, n, t0)
    np.multiply(out, t0, t0)
    np.multiply(t0, v68, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, A, n, E_star, t0, t1, t2, t3, m0):
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
    some23 = np.count_nonzero(m0)
    if some23:
        np.add(out, C3, t1)
        np.multiply(out, t1, t1)
        np.divide(t1, t2, t1)
    if some23 != size:
        other23 = t3 if some23 else t1
        np.add(out, C4, other23)
        np.divide(other23, t2, other23)
        np.subtract(C3, other23, other23)
        if some23:
            np.copyto(t1, other23, where=~m0)
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
    np.multiply(C21, E_star, t2)
    np.multiply(t2, n, t2)
    np.multiply(t2, A, t2)
    np.add(n, C3, t0)
    np.divide(t2, t0, t0)
    np.multiply(t0, a, t0)
    np.power(a, n, t2)
    np.multiply(t0, t2, t2)
    np.multiply(t2, out, out)


def force_from_depth(d, A, n, E_star):
    if d.__class__ is A.__class__ is n.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v7 = n / 2.0 + 0.5
            v9 = v7 + 1.75
            v13 = (v7 + 0.5) * (v7 + 1.5)
            v27 = 1.0 / (v9 * v9)
            v68 = (v7 * (v7 + 1.0) / v13 if v7 < 1.0 else 1.0 - (v7 + 0.75) / v13) * sqrt(v9) * (1.0 + v27 * (((((((0.01524698625788054 * v27 + 0.5334320651111477) * v27 + 2.250488865813539) * v27 + 2.8612106440066865) * v27 + 1.3794681629043655) * v27 + 0.2596058532893223) * v27 + 0.015624999999999823) / ((((((3.278794792785737 * v27 + 49.328555418276075) * v27 + 167.28648538571198) * v27 + 195.37226190335065) * v27 + 90.69722535867314) * v27 + 16.763212110504565) * v27 + 1.0)))
            v72 = d / (1.7724538509055159 * A * v68)
            v82 = n + 0.0
            v84 = pow(v72, 1.0 / v82)
            value = 3.5449077018110318 * E_star * n * A / (n + 1.0) * v68 * v72 * (v84 + v84 * ((v72 / (pow(v84, n) * pow(v84, 0.0)) - 1.0) / v82) if v72 > 0.0 and v72 < inf else v84)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_from_depth_d(A, n, E_star):
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
    v70 = (1.7724538509055159) * A
    v71 = v70 * v68
    v74 = (3.5449077018110318) * E_star
    v75 = v74 * n
    v76 = v75 * A
    v77 = n + (1.0)
    v78 = v76 / v77
    v79 = v78 * v68
    v82 = n + (0.0)
    v83 = (1.0) / v82
    return (n, v71, v79, v82, v83)


def block_force_from_depth_d(out, d, n, v71, v79, v82, v83, t0, t1, t2, t3, m0, m1):
    size = out.size
    np.divide(d, v71, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.multiply(v79, out, t0)
    np.power(out, v83, t1)
    np.greater(out, C19, m0)
    np.less(out, C20, m1)
    np.bitwise_and(m0, m1, m1)
    some97 = np.count_nonzero(m1)
    if some97:
        np.power(t1, n, t2)
        np.power(t1, C19, t3)
        np.multiply(t2, t3, t3)
        np.divide(out, t3, t3)
        np.subtract(t3, C3, t3)
        np.divide(t3, v82, t3)
        np.multiply(t1, t3, t3)
        np.add(t1, t3, t2)
    if some97 != size:
        np.copyto(t2, t1, where=~m1)
    np.multiply(t0, t2, out)


def prepare_force_from_depth_all():
    return ()


def block_force_from_depth_all(out, d, A, n, E_star, t0, t1, t2, t3, t4, m0, m1):
    size = out.size
    np.multiply(n, C0, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.add(out, C0, out)
    np.add(out, C1, t0)
    np.add(out, C0, t1)
    np.add(out, C2, t2)
    np.multiply(t1, t2, t2)
    np.less(out, C3, m0)
    some23 = np.count_nonzero(m0)
    if some23:
        np.add(out, C3, t1)
        np.multiply(out, t1, t1)
        np.divide(t1, t2, t1)
    if some23 != size:
        other23 = t3 if some23 else t1
        np.add(out, C4, other23)
        np.divide(other23, t2, other23)
        np.subtract(C3, other23, other23)
        if some23:
            np.copyto(t1, other23, where=~m0)
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
    np.multiply(t2, out, t2)
    np.divide(d, t2, t2)
    np.multiply(C21, E_star, t0)
    np.multiply(t0, n, t0)
    np.multiply(t0, A, t0)
    np.add(n, C3, t1)
    np.divide(t0, t1, t1)
    np.multiply(t1, out, out)
    np.multiply(out, t2, out)
    np.add(n, C19, t1)
    np.divide(C3, t1, t0)
    np.power(t2, t0, t0)
    np.greater(t2, C19, m0)
    np.less(t2, C20, m1)
    np.bitwise_and(m0, m1, m1)
    some97 = np.count_nonzero(m1)
    if some97:
        np.power(t0, n, t3)
        np.power(t0, C19, t4)
        np.multiply(t3, t4, t4)
        np.divide(t2, t4, t4)
        np.subtract(t4, C3, t4)
        np.divide(t4, t1, t4)
        np.multiply(t0, t4, t4)
        np.add(t0, t4, t3)
    if some97 != size:
        np.copyto(t3, t0, where=~m1)
    np.multiply(out, t3, out)


def load_within(r, a, A, n, E_star):
    if r.__class__ is a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v8 = n / 2.0 + 0.5
            v10 = v8 + 1.75
            v14 = (v8 + 0.5) * (v8 + 1.5)
            v28 = 1.0 / (v10 * v10)
            v69 = (v8 * (v8 + 1.0) / v14 if v8 < 1.0 else 1.0 - (v8 + 0.75) / v14) * sqrt(v10) * (1.0 + v28 * (((((((0.01524698625788054 * v28 + 0.5334320651111477) * v28 + 2.250488865813539) * v28 + 2.8612106440066865) * v28 + 1.3794681629043655) * v28 + 0.2596058532893223) * v28 + 0.015624999999999823) / ((((((3.278794792785737 * v28 + 49.328555418276075) * v28 + 167.28648538571198) * v28 + 195.37226190335065) * v28 + 90.69722535867314) * v28 + 16.763212110504565) * v28 + 1.0)))
            v137 = 3.5449077018110318 * E_star * n * A / (n + 1.0)
            v138 = pow(a, n)
            if r < a:
                v86 = r > 0.0
                if v86:
                    v70 = a - r
                    v74 = n > 1.0
                    v76 = abs(n - 1.0)
                    if v86:
                        v87 = v70 / r
                        v93 = log1p(v87) if isfinite(v87) else log(a) - log(r)
                        if v93 > 0.0:
                            v98 = v93 - 42.0 / (v76 if v76 > 0.001 or v76 != v76 else 0.001)
                            v99 = v98 if v98 > 0.0 or v98 != v98 else 0.0
                            v100 = sqrt(v93)
                            v105 = v100 - sqrt(v99) if v74 else sqrt(v93 - v99)
                            v108 = 2.0 * v100
                            v113 = -v76
                            v128 = []
                            for node, weight in RULE_1(v105 / 1.0):
                                v107 = node * v105
                                if v74:
                                    v116 = v100 - v107
                                    v118 = v116 if v116 > 0.0 or v116 != v116 else 0.0
                                else:
                                    v118 = v107
                                v127 = exp(v113 * (v107 * (v108 - v107) if v74 else v107 * v107)) * (2.0 * v118 / sqrt(-expm1(-2.0 * v118 * v118)))
                                v128.append(weight * v127)
                            v128 = fsum(v128) * v105
                            v129 = v128
                        else:
                            v129 = 0.0
                        v131 = (1.0 if v74 else pow(r / a, n) * (a / r)) * v129
                    else:
                        v131 = 1.0 / v76 if v74 else inf
                    value = v137 * v138 * (r * r) * (1.0 / (sqrt(v70 * (a + r)) + a) + v131 / a) * v69
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, A, n, E_star):
                        return value
                    return None
                return 0.0
            value = v137 * a * v138 * v69
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, A, n, E_star):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def mean_pressure(a, A, n, E_star):
    if a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v7 = n / 2.0 + 0.5
            v9 = v7 + 1.75
            v13 = (v7 + 0.5) * (v7 + 1.5)
            v27 = 1.0 / (v9 * v9)
            value = 2.0 * E_star * n * A / (1.7724538509055159 * (n + 1.0)) * (pow(a, n) / a if a > 0.0 else pow(a, n - 1.0)) * ((v7 * (v7 + 1.0) / v13 if v7 < 1.0 else 1.0 - (v7 + 0.75) / v13) * sqrt(v9) * (1.0 + v27 * (((((((0.01524698625788054 * v27 + 0.5334320651111477) * v27 + 2.250488865813539) * v27 + 2.8612106440066865) * v27 + 1.3794681629043655) * v27 + 0.2596058532893223) * v27 + 0.015624999999999823) / ((((((3.278794792785737 * v27 + 49.328555418276075) * v27 + 167.28648538571198) * v27 + 195.37226190335065) * v27 + 90.69722535867314) * v27 + 16.763212110504565) * v27 + 1.0))))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_mean_pressure_a(A, n, E_star):
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
    v69 = (2.0) * E_star
    v70 = v69 * n
    v71 = v70 * A
    v72 = n + (1.0)
    v74 = (1.7724538509055159) * v72
    v75 = v71 / v74
    v80 = n - (1.0)
    return (n, v68, v75, v80)


def block_mean_pressure_a(out, a, n, v68, v75, v80, t0, m0):
    size = out.size
    np.greater(a, C19, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some82 = np.count_nonzero(m0)
    if some82:
        np.power(a, n, out)
        np.divide(out, a, out)
    if some82 != size:
        other82 = t0 if some82 else out
        np.power(a, v80, other82)
        if some82:
            np.copyto(out, other82, where=~m0)
    np.multiply(v75, out, out)
    np.multiply(out, v68, out)


def prepare_mean_pressure_all():
    return ()


def block_mean_pressure_all(out, a, A, n, E_star, t0, t1, t2, t3, m0):
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
    some23 = np.count_nonzero(m0)
    if some23:
        np.add(out, C3, t1)
        np.multiply(out, t1, t1)
        np.divide(t1, t2, t1)
    if some23 != size:
        other23 = t3 if some23 else t1
        np.add(out, C4, other23)
        np.divide(other23, t2, other23)
        np.subtract(C3, other23, other23)
        if some23:
            np.copyto(t1, other23, where=~m0)
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
    np.multiply(C23, E_star, t2)
    np.multiply(t2, n, t2)
    np.multiply(t2, A, t2)
    np.add(n, C3, t0)
    np.multiply(C18, t0, t0)
    np.divide(t2, t0, t0)
    np.greater(a, C19, m0)
    some82 = np.count_nonzero(m0)
    if some82:
        np.power(a, n, t2)
        np.divide(t2, a, t2)
    if some82 != size:
        other82 = t1 if some82 else t2
        np.subtract(n, C3, other82)
        np.power(a, other82, other82)
        if some82:
            np.copyto(t2, other82, where=~m0)
    np.multiply(t0, t2, t2)
    np.multiply(t2, out, out)


def peak_pressure(a, A, n, E_star):
    if a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if n > 1.0:
                v7 = n / 2.0 + 0.5
                v9 = v7 + 1.75
                v13 = (v7 + 0.5) * (v7 + 1.5)
                v27 = 1.0 / (v9 * v9)
                v69 = n > 2.0
                if v69:
                    v72 = (n if v69 else 3.0) - 2.0
                    v80 = 2.0 / (3.141592653589793 * v72) * sqrt(1.0 + 4.215 * v72)
                    v83 = v80 * v80
                    v84 = asinh(v80)
                    v89 = 1.0 + v83
                    v99 = 0.5 * (v72 - 1.0)
                    v102 = []
                    for node, weight in RULE_2(v84 / 1.0):
                        v85 = node * v84
                        v86 = sinh(v85)
                        v87 = v86 * v86
                        v90 = (v83 - v87) / v89
                        v101 = exp(v99 * (log1p(-v90) if v90 < 0.5 else log((1.0 + v87) / v89)))
                        v102.append(weight * v101)
                    v102 = fsum(v102) * v84
                    v104 = hypot(1.0, v80) / (v72 * v102)
                    v106 = v104 * v104
                    v107 = asinh(v104)
                    v112 = 1.0 + v106
                    v124 = []
                    for node, weight in RULE_2(v107 / 1.0):
                        v108 = node * v107
                        v109 = sinh(v108)
                        v110 = v109 * v109
                        v113 = (v106 - v110) / v112
                        v123 = exp(v99 * (log1p(-v113) if v113 < 0.5 else log((1.0 + v110) / v112)))
                        v124.append(weight * v123)
                    v124 = fsum(v124) * v107
                    v126 = hypot(1.0, v104) / (v72 * v124)
                    v128 = v126 * v126
                    v129 = asinh(v126)
                    v134 = 1.0 + v128
                    v146 = []
                    for node, weight in RULE_2(v129 / 1.0):
                        v130 = node * v129
                        v131 = sinh(v130)
                        v132 = v131 * v131
                        v135 = (v128 - v132) / v134
                        v145 = exp(v99 * (log1p(-v135) if v135 < 0.5 else log((1.0 + v132) / v134)))
                        v146.append(weight * v145)
                    v146 = fsum(v146) * v129
                    v148 = hypot(1.0, v126) / (v72 * v146)
                    v150 = v148 * v148
                    v151 = asinh(v148)
                    v156 = 1.0 + v150
                    v168 = []
                    for node, weight in RULE_2(v151 / 1.0):
                        v152 = node * v151
                        v153 = sinh(v152)
                        v154 = v153 * v153
                        v157 = (v150 - v154) / v156
                        v167 = exp(v99 * (log1p(-v157) if v157 < 0.5 else log((1.0 + v154) / v156)))
                        v168.append(weight * v167)
                    v168 = fsum(v168) * v151
                    v170 = hypot(1.0, v148) / (v72 * v168)
                    v172 = v170 * v170
                    v173 = asinh(v170)
                    v178 = 1.0 + v172
                    v190 = []
                    for node, weight in RULE_2(v173 / 1.0):
                        v174 = node * v173
                        v175 = sinh(v174)
                        v176 = v175 * v175
                        v179 = (v172 - v176) / v178
                        v189 = exp(v99 * (log1p(-v179) if v179 < 0.5 else log((1.0 + v176) / v178)))
                        v190.append(weight * v189)
                    v190 = fsum(v190) * v173
                    v195 = hypot(1.0, 1.0 / (hypot(1.0, v170) / (v72 * v190)))
                else:
                    v195 = 1.0
                v199 = n - 1.0
                value = E_star * n * A * v195 / (1.7724538509055159 * v199) * (pow(a, n) / a if a > 0.0 else pow(a, v199)) * ((v7 * (v7 + 1.0) / v13 if v7 < 1.0 else 1.0 - (v7 + 0.75) / v13) * sqrt(v9) * (1.0 + v27 * (((((((0.01524698625788054 * v27 + 0.5334320651111477) * v27 + 2.250488865813539) * v27 + 2.8612106440066865) * v27 + 1.3794681629043655) * v27 + 0.2596058532893223) * v27 + 0.015624999999999823) / ((((((3.278794792785737 * v27 + 49.328555418276075) * v27 + 167.28648538571198) * v27 + 195.37226190335065) * v27 + 90.69722535867314) * v27 + 16.763212110504565) * v27 + 1.0))))
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(a, A, n, E_star):
                    return value
                return None
            return inf
        except (ArithmeticError, ValueError):
            pass
    return None


def peak_radius(a, n, A=1.0, E_star=1.0):
    if a.__class__ is n.__class__ is A.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (n > 1e-30) and (n < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v3 = n > 2.0
            if v3:
                v6 = (n if v3 else 3.0) - 2.0
                v15 = 2.0 / (3.141592653589793 * v6) * sqrt(1.0 + 4.215 * v6)
                v18 = v15 * v15
                v19 = asinh(v15)
                v24 = 1.0 + v18
                v35 = 0.5 * (v6 - 1.0)
                v38 = []
                for node, weight in RULE_2(v19 / 1.0):
                    v20 = node * v19
                    v21 = sinh(v20)
                    v22 = v21 * v21
                    v25 = (v18 - v22) / v24
                    v37 = exp(v35 * (log1p(-v25) if v25 < 0.5 else log((1.0 + v22) / v24)))
                    v38.append(weight * v37)
                v38 = fsum(v38) * v19
                v40 = hypot(1.0, v15) / (v6 * v38)
                v42 = v40 * v40
                v43 = asinh(v40)
                v48 = 1.0 + v42
                v60 = []
                for node, weight in RULE_2(v43 / 1.0):
                    v44 = node * v43
                    v45 = sinh(v44)
                    v46 = v45 * v45
                    v49 = (v42 - v46) / v48
                    v59 = exp(v35 * (log1p(-v49) if v49 < 0.5 else log((1.0 + v46) / v48)))
                    v60.append(weight * v59)
                v60 = fsum(v60) * v43
                v62 = hypot(1.0, v40) / (v6 * v60)
                v64 = v62 * v62
                v65 = asinh(v62)
                v70 = 1.0 + v64
                v82 = []
                for node, weight in RULE_2(v65 / 1.0):
                    v66 = node * v65
                    v67 = sinh(v66)
                    v68 = v67 * v67
                    v71 = (v64 - v68) / v70
                    v81 = exp(v35 * (log1p(-v71) if v71 < 0.5 else log((1.0 + v68) / v70)))
                    v82.append(weight * v81)
                v82 = fsum(v82) * v65
                v84 = hypot(1.0, v62) / (v6 * v82)
                v86 = v84 * v84
                v87 = asinh(v84)
                v92 = 1.0 + v86
                v104 = []
                for node, weight in RULE_2(v87 / 1.0):
                    v88 = node * v87
                    v89 = sinh(v88)
                    v90 = v89 * v89
                    v93 = (v86 - v90) / v92
                    v103 = exp(v35 * (log1p(-v93) if v93 < 0.5 else log((1.0 + v90) / v92)))
                    v104.append(weight * v103)
                v104 = fsum(v104) * v87
                v106 = hypot(1.0, v84) / (v6 * v104)
                v108 = v106 * v106
                v109 = asinh(v106)
                v114 = 1.0 + v108
                v126 = []
                for node, weight in RULE_2(v109 / 1.0):
                    v110 = node * v109
                    v111 = sinh(v110)
                    v112 = v111 * v111
                    v115 = (v108 - v112) / v114
                    v125 = exp(v35 * (log1p(-v115) if v115 < 0.5 else log((1.0 + v112) / v114)))
                    v126.append(weight * v125)
                v126 = fsum(v126) * v109
                v132 = 1.0 / hypot(1.0, hypot(1.0, v106) / (v6 * v126))
            else:
                v132 = 0.0
            value = a * v132
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, n, A, E_star):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def pressure(r, a, A, n, E_star):
    if r.__class__ is a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if r < a:
                v8 = n / 2.0 + 0.5
                v10 = v8 + 1.75
                v14 = (v8 + 0.5) * (v8 + 1.5)
                v28 = 1.0 / (v10 * v10)
                v78 = n - 1.0
                v82 = n > 1.0
                v83 = abs(v78)
                if r > 0.0:
                    v94 = (a - r) / r
                    v100 = log1p(v94) if isfinite(v94) else log(a) - log(r)
                    if v100 > 0.0:
                        v105 = v100 - 42.0 / (v83 if v83 > 0.001 or v83 != v83 else 0.001)
                        v106 = v105 if v105 > 0.0 or v105 != v105 else 0.0
                        v107 = sqrt(v100)
                        v112 = v107 - sqrt(v106) if v82 else sqrt(v100 - v106)
                        v115 = 2.0 * v107
                        v120 = -v83
                        v135 = []
                        for node, weight in RULE_1(v112 / 1.0):
                            v114 = node * v112
                            if v82:
                                v123 = v107 - v114
                                v125 = v123 if v123 > 0.0 or v123 != v123 else 0.0
                            else:
                                v125 = v114
                            v134 = exp(v120 * (v114 * (v115 - v114) if v82 else v114 * v114)) * (2.0 * v125 / sqrt(-expm1(-2.0 * v125 * v125)))
                            v135.append(weight * v134)
                        v135 = fsum(v135) * v112
                        v136 = v135
                    else:
                        v136 = 0.0
                    v138 = (1.0 if v82 else pow(r / a, n) * (a / r)) * v136
                else:
                    v138 = 1.0 / v83 if v82 else inf
                value = E_star * n * A / 1.7724538509055159 * (pow(a, n) / a if a > 0.0 else pow(a, v78)) * v138 * ((v8 * (v8 + 1.0) / v14 if v8 < 1.0 else 1.0 - (v8 + 0.75) / v14) * sqrt(v10) * (1.0 + v28 * (((((((0.01524698625788054 * v28 + 0.5334320651111477) * v28 + 2.250488865813539) * v28 + 2.8612106440066865) * v28 + 1.3794681629043655) * v28 + 0.2596058532893223) * v28 + 0.015624999999999823) / ((((((3.278794792785737 * v28 + 49.328555418276075) * v28 + 167.28648538571198) * v28 + 195.37226190335065) * v28 + 90.69722535867314) * v28 + 16.763212110504565) * v28 + 1.0))))
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, A, n, E_star):
                    return value
                return None
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def profile(r, A, n):
    if r.__class__ is A.__class__ is n.__class__ is float and r > 1e-30 and (r < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30):
        try:
            value = A * pow(r, n)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_r(A, n):
    return (A, n)


def block_profile_r(out, r, A, n):
    np.power(r, n, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.multiply(A, out, out)


def prepare_profile_all():
    return ()


def block_profile_all(out, r, A, n):
    np.power(r, n, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.multiply(A, out, out)


def radius_from_depth(d, A, n):
    if d.__class__ is A.__class__ is n.__class__ is float and d > 1e-30 and (d < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30):
        try:
            v6 = n / 2.0 + 0.5
            v8 = v6 + 1.75
            v12 = (v6 + 0.5) * (v6 + 1.5)
            v26 = 1.0 / (v8 * v8)
            v71 = d / (1.7724538509055159 * A * ((v6 * (v6 + 1.0) / v12 if v6 < 1.0 else 1.0 - (v6 + 0.75) / v12) * sqrt(v8) * (1.0 + v26 * (((((((0.01524698625788054 * v26 + 0.5334320651111477) * v26 + 2.250488865813539) * v26 + 2.8612106440066865) * v26 + 1.3794681629043655) * v26 + 0.2596058532893223) * v26 + 0.015624999999999823) / ((((((3.278794792785737 * v26 + 49.328555418276075) * v26 + 167.28648538571198) * v26 + 195.37226190335065) * v26 + 90.69722535867314) * v26 + 16.763212110504565) * v26 + 1.0)))))
            v73 = n + 0.0
            v75 = pow(v71, 1.0 / v73)
            if v71 > 0.0 and v71 < inf:
                value = v75 + v75 * ((v71 / (pow(v75, n) * pow(v75, 0.0)) - 1.0) / v73)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            value = v75
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_radius_from_depth_d(A, n):
    v4 = n / (2.0)
    v6 = v4 + (0.5)
    v8 = v6 + (1.75)
    v9 = v6 + (0.5)
    v11 = v6 + (1.5)
    v12 = v9 * v11
    v14 = np.less(v6, (1.0))
    v15 = v6 + (1.0)
    v16 = v6 * v15
    v17 = v16 / v12
    v19 = v6 + (0.75)
    v20 = v19 / v12
    v21 = (1.0) - v20
    v22 = v17 if v14 else v21
    v23 = np.sqrt(v8)
    v24 = v22 * v23
    v25 = v8 * v8
    v26 = (1.0) / v25
    v28 = (0.01524698625788054) * v26
    v30 = v28 + (0.5334320651111477)
    v31 = v30 * v26
    v33 = v31 + (2.250488865813539)
    v34 = v33 * v26
    v36 = v34 + (2.8612106440066865)
    v37 = v36 * v26
    v39 = v37 + (1.3794681629043655)
    v40 = v39 * v26
    v42 = v40 + (0.2596058532893223)
    v43 = v42 * v26
    v45 = v43 + (0.015624999999999823)
    v47 = (3.278794792785737) * v26
    v49 = v47 + (49.328555418276075)
    v50 = v49 * v26
    v52 = v50 + (167.28648538571198)
    v53 = v52 * v26
    v55 = v53 + (195.37226190335065)
    v56 = v55 * v26
    v58 = v56 + (90.69722535867314)
    v59 = v58 * v26
    v61 = v59 + (16.763212110504565)
    v62 = v61 * v26
    v63 = v62 + (1.0)
    v64 = v45 / v63
    v65 = v26 * v64
    v66 = (1.0) + v65
    v67 = v24 * v66
    v69 = (1.7724538509055159) * A
    v70 = v69 * v67
    v73 = n + (0.0)
    v74 = (1.0) / v73
    return (n, v70, v73, v74)


def block_radius_from_depth_d(out, d, n, v70, v73, v74, t0, t1, t2, m0, m1):
    size = out.size
    np.divide(d, v70, t0)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.power(t0, v74, t1)
    np.greater(t0, C19, m0)
    np.less(t0, C20, m1)
    np.bitwise_and(m0, m1, m1)
    some88 = np.count_nonzero(m1)
    if some88:
        np.power(t1, n, out)
        np.power(t1, C19, t2)
        np.multiply(out, t2, t2)
        np.divide(t0, t2, t2)
        np.subtract(t2, C3, t2)
        np.divide(t2, v73, t2)
        np.multiply(t1, t2, t2)
        np.add(t1, t2, out)
    if some88 != size:
        np.copyto(out, t1, where=~m1)


def prepare_radius_from_depth_all():
    return ()


def block_radius_from_depth_all(out, d, A, n, t0, t1, t2, t3, t4, m0, m1):
    size = out.size
    np.multiply(n, C0, t0)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.add(t0, C0, t0)
    np.add(t0, C1, t1)
    np.add(t0, C0, t2)
    np.add(t0, C2, t3)
    np.multiply(t2, t3, t3)
    np.less(t0, C3, m0)
    some22 = np.count_nonzero(m0)
    if some22:
        np.add(t0, C3, t2)
        np.multiply(t0, t2, t2)
        np.divide(t2, t3, t2)
    if some22 != size:
        other22 = t4 if some22 else t2
        np.add(t0, C4, other22)
        np.divide(other22, t3, other22)
        np.subtract(C3, other22, other22)
        if some22:
            np.copyto(t2, other22, where=~m0)
    np.sqrt(t1, t3)
    np.multiply(t2, t3, t3)
    np.multiply(t1, t1, t1)
    np.divide(C3, t1, t1)
    np.multiply(C5, t1, t2)
    np.add(t2, C6, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C7, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C8, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C9, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C10, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C11, t2)
    np.multiply(C12, t1, t0)
    np.add(t0, C13, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C14, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C15, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C16, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C17, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C3, t0)
    np.divide(t2, t0, t0)
    np.multiply(t1, t0, t0)
    np.add(C3, t0, t0)
    np.multiply(t3, t0, t0)
    np.multiply(C18, A, t3)
    np.multiply(t3, t0, t0)
    np.divide(d, t0, t0)
    np.add(n, C19, t3)
    np.divide(C3, t3, t1)
    np.power(t0, t1, t1)
    np.greater(t0, C19, m0)
    np.less(t0, C20, m1)
    np.bitwise_and(m0, m1, m1)
    some88 = np.count_nonzero(m1)
    if some88:
        np.power(t1, n, out)
        np.power(t1, C19, t2)
        np.multiply(out, t2, t2)
        np.divide(t0, t2, t2)
        np.subtract(t2, C3, t2)
        np.divide(t2, t3, t2)
        np.multiply(t1, t2, t2)
        np.add(t1, t2, out)
    if some88 != size:
        np.copyto(out, t1, where=~m1)


def radius_from_force(F, A, n, E_star):
    if F.__class__ is A.__class__ is n.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v7 = n / 2.0 + 0.5
            v9 = v7 + 1.75
            v13 = (v7 + 0.5) * (v7 + 1.5)
            v27 = 1.0 / (v9 * v9)
            v69 = n + 1.0
            v76 = v69 * F / (3.5449077018110318 * E_star * n * A * ((v7 * (v7 + 1.0) / v13 if v7 < 1.0 else 1.0 - (v7 + 0.75) / v13) * sqrt(v9) * (1.0 + v27 * (((((((0.01524698625788054 * v27 + 0.5334320651111477) * v27 + 2.250488865813539) * v27 + 2.8612106440066865) * v27 + 1.3794681629043655) * v27 + 0.2596058532893223) * v27 + 0.015624999999999823) / ((((((3.278794792785737 * v27 + 49.328555418276075) * v27 + 167.28648538571198) * v27 + 195.37226190335065) * v27 + 90.69722535867314) * v27 + 16.763212110504565) * v27 + 1.0)))))
            v78 = pow(v76, 1.0 / v69)
            if v76 > 0.0 and v76 < inf:
                value = v78 + v78 * ((v76 / (pow(v78, n) * pow(v78, 1.0)) - 1.0) / v69)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            value = v78
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_radius_from_force_F(A, n, E_star):
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
    v69 = n + (1.0)
    v72 = (3.5449077018110318) * E_star
    v73 = v72 * n
    v74 = v73 * A
    v75 = v74 * v68
    v77 = (1.0) / v69
    return (n, v69, v75, v77)


def block_radius_from_force_F(out, F, n, v69, v75, v77, t0, t1, t2, m0, m1):
    size = out.size
    np.multiply(v69, F, t0)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    np.divide(t0, v75, t0)
    np.power(t0, v77, t1)
    np.greater(t0, C19, m0)
    np.less(t0, C20, m1)
    np.bitwise_and(m0, m1, m1)
    some92 = np.count_nonzero(m1)
    if some92:
        np.power(t1, n, out)
        np.power(t1, C3, t2)
        np.multiply(out, t2, t2)
        np.divide(t0, t2, t2)
        np.subtract(t2, C3, t2)
        np.divide(t2, v69, t2)
        np.multiply(t1, t2, t2)
        np.add(t1, t2, out)
    if some92 != size:
        np.copyto(out, t1, where=~m1)


def prepare_radius_from_force_all():
    return ()


def block_radius_from_force_all(out, F, A, n, E_star, t0, t1, t2, t3, t4, m0, m1):
    size = out.size
    np.multiply(n, C0, t0)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    np.add(t0, C0, t0)
    np.add(t0, C1, t1)
    np.add(t0, C0, t2)
    np.add(t0, C2, t3)
    np.multiply(t2, t3, t3)
    np.less(t0, C3, m0)
    some23 = np.count_nonzero(m0)
    if some23:
        np.add(t0, C3, t2)
        np.multiply(t0, t2, t2)
        np.divide(t2, t3, t2)
    if some23 != size:
        other23 = t4 if some23 else t2
        np.add(t0, C4, other23)
        np.divide(other23, t3, other23)
        np.subtract(C3, other23, other23)
        if some23:
            np.copyto(t2, other23, where=~m0)
    np.sqrt(t1, t3)
    np.multiply(t2, t3, t3)
    np.multiply(t1, t1, t1)
    np.divide(C3, t1, t1)
    np.multiply(C5, t1, t2)
    np.add(t2, C6, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C7, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C8, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C9, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C10, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C11, t2)
    np.multiply(C12, t1, t0)
    np.add(t0, C13, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C14, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C15, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C16, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C17, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C3, t0)
    np.divide(t2, t0, t0)
    np.multiply(t1, t0, t0)
    np.add(C3, t0, t0)
    np.multiply(t3, t0, t0)
    np.add(n, C3, t3)
    np.multiply(t3, F, t1)
    np.multiply(C21, E_star, t2)
    np.multiply(t2, n, t2)
    np.multiply(t2, A, t2)
    np.multiply(t2, t0, t0)
    np.divide(t1, t0, t0)
    np.divide(C3, t3, t1)
    np.power(t0, t1, t1)
    np.greater(t0, C19, m0)
    np.less(t0, C20, m1)
    np.bitwise_and(m0, m1, m1)
    some92 = np.count_nonzero(m1)
    if some92:
        np.power(t1, n, out)
        np.power(t1, C3, t2)
        np.multiply(out, t2, t2)
        np.divide(t0, t2, t2)
        np.subtract(t2, C3, t2)
        np.divide(t2, t3, t2)
        np.multiply(t1, t2, t2)
        np.add(t1, t2, out)
    if some92 != size:
        np.copyto(out, t1, where=~m1)


def stiffness(a, E_star, A=1.0, n=1.0):
    if a.__class__ is E_star.__class__ is A.__class__ is n.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30):
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
    np.multiply(C23, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(out, a, out)


BLOCKS = {
    ('_depth', 1, 'a', 'A', 'n'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 0, 0, (), False),
        ('a', 'A', 'n'): (('a', 'A', 'n'), prepare_depth_all, block_depth_all, 4, 1, (), False),
    },
    ('_depth_from_force', 1, 'F', 'A', 'n', 'E_star'): {
        ('F',): (('F',), prepare_depth_from_force_F, block_depth_from_force_F, 3, 2, (), False),
        ('F', 'A', 'n', 'E_star'): (('F', 'A', 'n', 'E_star'), prepare_depth_from_force_all, block_depth_from_force_all, 5, 2, (), False),
    },
    ('_energy', 1, 'a', 'A', 'n', 'E_star'): {
        ('a',): (('a',), prepare_energy_a, block_energy_a, 1, 0, (), False),
        ('a', 'A', 'n', 'E_star'): (('a', 'A', 'n', 'E_star'), prepare_energy_all, block_energy_all, 4, 1, (), False),
    },
    ('_force', 1, 'a', 'A', 'n', 'E_star'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 1, 0, (), False),
        ('a', 'A', 'n', 'E_star'): (('a', 'A', 'n', 'E_star'), prepare_force_all, block_force_all, 4, 1, (), False),
    },
    ('_force_from_depth', 1, 'd', 'A', 'n', 'E_star'): {
        ('d',): (('d',), prepare_force_from_depth_d, block_force_from_depth_d, 4, 2, (), False),
        ('d', 'A', 'n', 'E_star'): (('d', 'A', 'n', 'E_star'), prepare_force_from_depth_all, block_force_from_depth_all, 5, 2, (), False),
    },
    ('_mean_pressure', 1, 'a', 'A', 'n', 'E_star'): {
        ('a',): (('a',), prepare_mean_pressure_a, block_mean_pressure_a, 1, 1, (), False),
        ('a', 'A', 'n', 'E_star'): (('a', 'A', 'n', 'E_star'), prepare_mean_pressure_all, block_mean_pressure_all, 4, 1, (), False),
    },
    ('_profile', 1, 'r', 'A', 'n'): {
        ('r',): (('r',), prepare_profile_r, block_profile_r, 0, 0, (), False),
        ('r', 'A', 'n'): (('r', 'A', 'n'), prepare_profile_all, block_profile_all, 0, 0, (), False),
    },
    ('_radius_from_depth', 1, 'd', 'A', 'n'): {
        ('d',): (('d',), prepare_radius_from_depth_d, block_radius_from_depth_d, 3, 2, (), False),
        ('d', 'A', 'n'): (('d', 'A', 'n'), prepare_radius_from_depth_all, block_radius_from_depth_all, 5, 2, (), False),
    },
    ('_radius_from_force', 1, 'F', 'A', 'n', 'E_star'): {
        ('F',): (('F',), prepare_radius_from_force_F, block_radius_from_force_F, 3, 2, (), False),
        ('F', 'A', 'n', 'E_star'): (('F', 'A', 'n', 'E_star'), prepare_radius_from_force_all, block_radius_from_force_all, 5, 2, (), False),
    },
    ('_stiffness', 1, 'a', 'E_star'): {
        ('a',): (('a',), prepare_stiffness_a, block_stiffness_a, 0, 0, (), False),
        ('a', 'E_star'): (('a', 'E_star'), prepare_stiffness_all, block_stiffness_all, 0, 0, (), False),
    },
}
