"""Programs of axicontact.tangential.power_law."""

from __future__ import annotations

from math import expm1, inf, log1p, nan, pow, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._programs.bodies.tangential import power_law as bodies

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
C20 = np.array(np.nan)
C21 = np.array(np.inf)
C22 = np.array(2e-16)
C23 = np.array(3.5449077018110318)


def full_slip_displacement(a, A, n, E_star, G_star, mu):
    if a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v11 = n / 2.0 + 0.5
            v13 = v11 + 1.75
            v17 = (v11 + 0.5) * (v11 + 1.5)
            v31 = 1.0 / (v13 * v13)
            value = mu * (E_star / G_star) * (1.7724538509055159 * A * pow(a, n) * ((v11 * (v11 + 1.0) / v17 if v11 < 1.0 else 1.0 - (v11 + 0.75) / v17) * sqrt(v13) * (1.0 + v31 * (((((((0.01524698625788054 * v31 + 0.5334320651111477) * v31 + 2.250488865813539) * v31 + 2.8612106440066865) * v31 + 1.3794681629043655) * v31 + 0.2596058532893223) * v31 + 0.015624999999999823) / ((((((3.278794792785737 * v31 + 49.328555418276075) * v31 + 167.28648538571198) * v31 + 195.37226190335065) * v31 + 90.69722535867314) * v31 + 16.763212110504565) * v31 + 1.0)))))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_full_slip_displacement_a(A, n, E_star, G_star, mu):
    v6 = E_star / G_star
    v7 = mu * v6
    v9 = n / (2.0)
    v11 = v9 + (0.5)
    v13 = v11 + (1.75)
    v14 = v11 + (0.5)
    v16 = v11 + (1.5)
    v17 = v14 * v16
    v19 = np.less(v11, (1.0))
    v20 = v11 + (1.0)
    v21 = v11 * v20
    v22 = v21 / v17
    v24 = v11 + (0.75)
    v25 = v24 / v17
    v26 = (1.0) - v25
    v27 = v22 if v19 else v26
    v28 = np.sqrt(v13)
    v29 = v27 * v28
    v30 = v13 * v13
    v31 = (1.0) / v30
    v33 = (0.01524698625788054) * v31
    v35 = v33 + (0.5334320651111477)
    v36 = v35 * v31
    v38 = v36 + (2.250488865813539)
    v39 = v38 * v31
    v41 = v39 + (2.8612106440066865)
    v42 = v41 * v31
    v44 = v42 + (1.3794681629043655)
    v45 = v44 * v31
    v47 = v45 + (0.2596058532893223)
    v48 = v47 * v31
    v50 = v48 + (0.015624999999999823)
    v52 = (3.278794792785737) * v31
    v54 = v52 + (49.328555418276075)
    v55 = v54 * v31
    v57 = v55 + (167.28648538571198)
    v58 = v57 * v31
    v60 = v58 + (195.37226190335065)
    v61 = v60 * v31
    v63 = v61 + (90.69722535867314)
    v64 = v63 * v31
    v66 = v64 + (16.763212110504565)
    v67 = v66 * v31
    v68 = v67 + (1.0)
    v69 = v50 / v68
    v70 = v31 * v69
    v71 = (1.0) + v70
    v72 = v29 * v71
    v74 = (1.7724538509055159) * A
    return (n, v7, v72, v74)


def block_full_slip_displacement_a(out, a, n, v7, v72, v74):
    np.power(a, n, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(v74, out, out)
    np.multiply(out, v72, out)
    np.multiply(v7, out, out)


def prepare_full_slip_displacement_all():
    return ()


def block_full_slip_displacement_all(out, a, A, n, E_star, G_star, mu, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.divide(E_star, G_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(mu, out, out)
    np.multiply(n, C0, t0)
    np.add(t0, C0, t0)
    np.add(t0, C1, t1)
    np.add(t0, C0, t2)
    np.add(t0, C2, t3)
    np.multiply(t2, t3, t3)
    np.less(t0, C3, m0)
    some27 = np.count_nonzero(m0)
    if some27:
        np.add(t0, C3, t2)
        np.multiply(t0, t2, t2)
        np.divide(t2, t3, t2)
    if some27 != size:
        other27 = t4 if some27 else t2
        np.add(t0, C4, other27)
        np.divide(other27, t3, other27)
        np.subtract(C3, other27, other27)
        if some27:
            np.copyto(t2, other27, where=~m0)
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
    np.power(a, n, t1)
    np.multiply(t3, t1, t1)
    np.multiply(t1, t0, t0)
    np.multiply(out, t0, out)


def stick_radius(F_x, a, A, n, E_star, mu):
    if F_x.__class__ is a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is mu.__class__ is float and F_x > 1e-30 and (F_x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            if F_x == 0.0 and a >= 0.0:
                return a
            v9 = n / 2.0 + 0.5
            v11 = v9 + 1.75
            v15 = (v9 + 0.5) * (v9 + 1.5)
            v29 = 1.0 / (v11 * v11)
            v70 = (v9 * (v9 + 1.0) / v15 if v9 < 1.0 else 1.0 - (v9 + 0.75) / v15) * sqrt(v11) * (1.0 + v29 * (((((((0.01524698625788054 * v29 + 0.5334320651111477) * v29 + 2.250488865813539) * v29 + 2.8612106440066865) * v29 + 1.3794681629043655) * v29 + 0.2596058532893223) * v29 + 0.015624999999999823) / ((((((3.278794792785737 * v29 + 49.328555418276075) * v29 + 167.28648538571198) * v29 + 195.37226190335065) * v29 + 90.69722535867314) * v29 + 16.763212110504565) * v29 + 1.0)))
            v74 = 3.5449077018110318 * E_star * n * A
            v75 = n + 1.0
            v80 = v74 / v75 * a * pow(a, n) * v70
            v82 = v80 - F_x / mu
            v88 = 0.0 if abs(v82) <= 2e-16 * v80 else v82
            v97 = v75 * (v88 if v88 >= 0.0 else nan) / (v74 * v70)
            v99 = pow(v97, 1.0 / v75)
            if v97 > 0.0 and v97 < inf:
                value = v99 + v99 * ((v97 / (pow(v99, n) * pow(v99, 1.0)) - 1.0) / v75)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            value = v99
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_stick_radius_F_x(a, A, n, E_star, mu):
    v7 = n / (2.0)
    v9 = v7 + (0.5)
    v11 = v9 + (1.75)
    v12 = v9 + (0.5)
    v14 = v9 + (1.5)
    v15 = v12 * v14
    v17 = np.less(v9, (1.0))
    v18 = v9 + (1.0)
    v19 = v9 * v18
    v20 = v19 / v15
    v22 = v9 + (0.75)
    v23 = v22 / v15
    v24 = (1.0) - v23
    v25 = v20 if v17 else v24
    v26 = np.sqrt(v11)
    v27 = v25 * v26
    v28 = v11 * v11
    v29 = (1.0) / v28
    v31 = (0.01524698625788054) * v29
    v33 = v31 + (0.5334320651111477)
    v34 = v33 * v29
    v36 = v34 + (2.250488865813539)
    v37 = v36 * v29
    v39 = v37 + (2.8612106440066865)
    v40 = v39 * v29
    v42 = v40 + (1.3794681629043655)
    v43 = v42 * v29
    v45 = v43 + (0.2596058532893223)
    v46 = v45 * v29
    v48 = v46 + (0.015624999999999823)
    v50 = (3.278794792785737) * v29
    v52 = v50 + (49.328555418276075)
    v53 = v52 * v29
    v55 = v53 + (167.28648538571198)
    v56 = v55 * v29
    v58 = v56 + (195.37226190335065)
    v59 = v58 * v29
    v61 = v59 + (90.69722535867314)
    v62 = v61 * v29
    v64 = v62 + (16.763212110504565)
    v65 = v64 * v29
    v66 = v65 + (1.0)
    v67 = v48 / v66
    v68 = v29 * v67
    v69 = (1.0) + v68
    v70 = v27 * v69
    v72 = (3.5449077018110318) * E_star
    v73 = v72 * n
    v74 = v73 * A
    v75 = n + (1.0)
    v76 = v74 / v75
    v77 = v76 * a
    v78 = np.power(a, n)
    v79 = v77 * v78
    v80 = v79 * v70
    v85 = (2e-16) * v80
    v93 = np.greater_equal(a, (0.0))
    v96 = v74 * v70
    v98 = (1.0) / v75
    return (a, n, mu, v75, v80, v85, v93, v96, v98)


def block_stick_radius_F_x(out, F_x, a, n, mu, v75, v80, v85, v93, v96, v98, t0, t1, t2, t3, m0, m1, m2):
    size = out.size
    np.equal(F_x, C19, m0)
    largest_F_x = largest(F_x)
    if largest_F_x == np.inf:
        raise FloatingPointError
    np.bitwise_and(m0, v93, m0)
    some113 = np.count_nonzero(m0)
    if some113:
        np.copyto(out, a)
    if some113 != size:
        other113 = t0 if some113 else out
        np.divide(F_x, mu, t1)
        np.subtract(v80, t1, t1)
        np.absolute(t1, t2)
        np.less_equal(t2, v85, m1)
        some88 = np.count_nonzero(m1)
        if some88:
            np.copyto(t2, C19)
        if some88 != size:
            np.copyto(t2, t1, where=~m1)
        np.greater_equal(t2, C19, m1)
        some91 = np.count_nonzero(m1)
        if some91:
            np.copyto(t1, t2)
        if some91 != size:
            np.copyto(t1, C20, where=~m1)
        np.multiply(v75, t1, t1)
        np.divide(t1, v96, t1)
        np.power(t1, v98, t2)
        np.greater(t1, C19, m1)
        np.less(t1, C21, m2)
        np.bitwise_and(m1, m2, m2)
        some112 = np.count_nonzero(m2)
        if some112:
            np.power(t2, n, other113)
            np.power(t2, C3, t3)
            np.multiply(other113, t3, t3)
            np.divide(t1, t3, t3)
            np.subtract(t3, C3, t3)
            np.divide(t3, v75, t3)
            np.multiply(t2, t3, t3)
            np.add(t2, t3, other113)
        if some112 != size:
            np.copyto(other113, t2, where=~m2)
        if some113:
            np.copyto(out, other113, where=~m0)


def prepare_stick_radius_F_x_a(A, n, E_star, mu):
    v7 = n / (2.0)
    v9 = v7 + (0.5)
    v11 = v9 + (1.75)
    v12 = v9 + (0.5)
    v14 = v9 + (1.5)
    v15 = v12 * v14
    v17 = np.less(v9, (1.0))
    v18 = v9 + (1.0)
    v19 = v9 * v18
    v20 = v19 / v15
    v22 = v9 + (0.75)
    v23 = v22 / v15
    v24 = (1.0) - v23
    v25 = v20 if v17 else v24
    v26 = np.sqrt(v11)
    v27 = v25 * v26
    v28 = v11 * v11
    v29 = (1.0) / v28
    v31 = (0.01524698625788054) * v29
    v33 = v31 + (0.5334320651111477)
    v34 = v33 * v29
    v36 = v34 + (2.250488865813539)
    v37 = v36 * v29
    v39 = v37 + (2.8612106440066865)
    v40 = v39 * v29
    v42 = v40 + (1.3794681629043655)
    v43 = v42 * v29
    v45 = v43 + (0.2596058532893223)
    v46 = v45 * v29
    v48 = v46 + (0.015624999999999823)
    v50 = (3.278794792785737) * v29
    v52 = v50 + (49.328555418276075)
    v53 = v52 * v29
    v55 = v53 + (167.28648538571198)
    v56 = v55 * v29
    v58 = v56 + (195.37226190335065)
    v59 = v58 * v29
    v61 = v59 + (90.69722535867314)
    v62 = v61 * v29
    v64 = v62 + (16.763212110504565)
    v65 = v64 * v29
    v66 = v65 + (1.0)
    v67 = v48 / v66
    v68 = v29 * v67
    v69 = (1.0) + v68
    v70 = v27 * v69
    v72 = (3.5449077018110318) * E_star
    v73 = v72 * n
    v74 = v73 * A
    v75 = n + (1.0)
    v76 = v74 / v75
    v96 = v74 * v70
    v98 = (1.0) / v75
    return (n, mu, v70, v75, v76, v96, v98)


def block_stick_radius_F_x_a(out, F_x, a, n, mu, v70, v75, v76, v96, v98, t0, t1, t2, t3, m0, m1, m2):
    size = out.size
    np.equal(F_x, C19, m0)
    largest_F_x = largest(F_x)
    if largest_F_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.greater_equal(a, C19, m1)
    np.bitwise_and(m0, m1, m1)
    some113 = np.count_nonzero(m1)
    if some113:
        np.copyto(out, a)
    if some113 != size:
        other113 = t0 if some113 else out
        np.multiply(v76, a, t1)
        np.power(a, n, t2)
        np.multiply(t1, t2, t2)
        np.multiply(t2, v70, t2)
        np.divide(F_x, mu, t1)
        np.subtract(t2, t1, t1)
        np.absolute(t1, t3)
        np.multiply(C22, t2, t2)
        np.less_equal(t3, t2, m0)
        some88 = np.count_nonzero(m0)
        if some88:
            np.copyto(t2, C19)
        if some88 != size:
            np.copyto(t2, t1, where=~m0)
        np.greater_equal(t2, C19, m0)
        some91 = np.count_nonzero(m0)
        if some91:
            np.copyto(t1, t2)
        if some91 != size:
            np.copyto(t1, C20, where=~m0)
        np.multiply(v75, t1, t1)
        np.divide(t1, v96, t1)
        np.power(t1, v98, t2)
        np.greater(t1, C19, m0)
        np.less(t1, C21, m2)
        np.bitwise_and(m0, m2, m2)
        some112 = np.count_nonzero(m2)
        if some112:
            np.power(t2, n, other113)
            np.power(t2, C3, t3)
            np.multiply(other113, t3, t3)
            np.divide(t1, t3, t3)
            np.subtract(t3, C3, t3)
            np.divide(t3, v75, t3)
            np.multiply(t2, t3, t3)
            np.add(t2, t3, other113)
        if some112 != size:
            np.copyto(other113, t2, where=~m2)
        if some113:
            np.copyto(out, other113, where=~m1)


def prepare_stick_radius_all():
    return ()


def block_stick_radius_all(out, F_x, a, A, n, E_star, mu, t0, t1, t2, t3, t4, t5, t6, m0, m1, m2):
    size = out.size
    np.equal(F_x, C19, m0)
    largest_F_x = largest(F_x)
    if largest_F_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.greater_equal(a, C19, m1)
    np.bitwise_and(m0, m1, m1)
    some113 = np.count_nonzero(m1)
    if some113:
        np.copyto(out, a)
    if some113 != size:
        other113 = t0 if some113 else out
        np.multiply(n, C0, t1)
        np.add(t1, C0, t1)
        np.add(t1, C1, t2)
        np.add(t1, C0, t3)
        np.add(t1, C2, t4)
        np.multiply(t3, t4, t4)
        np.less(t1, C3, m0)
        some25 = np.count_nonzero(m0)
        if some25:
            np.add(t1, C3, t3)
            np.multiply(t1, t3, t3)
            np.divide(t3, t4, t3)
        if some25 != size:
            other25 = t5 if some25 else t3
            np.add(t1, C4, other25)
            np.divide(other25, t4, other25)
            np.subtract(C3, other25, other25)
            if some25:
                np.copyto(t3, other25, where=~m0)
        np.sqrt(t2, t4)
        np.multiply(t3, t4, t4)
        np.multiply(t2, t2, t2)
        np.divide(C3, t2, t2)
        np.multiply(C5, t2, t3)
        np.add(t3, C6, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C7, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C8, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C9, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C10, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C11, t3)
        np.multiply(C12, t2, t1)
        np.add(t1, C13, t1)
        np.multiply(t1, t2, t1)
        np.add(t1, C14, t1)
        np.multiply(t1, t2, t1)
        np.add(t1, C15, t1)
        np.multiply(t1, t2, t1)
        np.add(t1, C16, t1)
        np.multiply(t1, t2, t1)
        np.add(t1, C17, t1)
        np.multiply(t1, t2, t1)
        np.add(t1, C3, t1)
        np.divide(t3, t1, t1)
        np.multiply(t2, t1, t1)
        np.add(C3, t1, t1)
        np.multiply(t4, t1, t1)
        np.multiply(C23, E_star, t4)
        np.multiply(t4, n, t4)
        np.multiply(t4, A, t4)
        np.add(n, C3, t2)
        np.divide(t4, t2, t3)
        np.multiply(t3, a, t3)
        np.power(a, n, t5)
        np.multiply(t3, t5, t5)
        np.multiply(t5, t1, t5)
        np.divide(F_x, mu, t3)
        np.subtract(t5, t3, t3)
        np.absolute(t3, t6)
        np.multiply(C22, t5, t5)
        np.less_equal(t6, t5, m0)
        some88 = np.count_nonzero(m0)
        if some88:
            np.copyto(t5, C19)
        if some88 != size:
            np.copyto(t5, t3, where=~m0)
        np.greater_equal(t5, C19, m0)
        some91 = np.count_nonzero(m0)
        if some91:
            np.copyto(t3, t5)
        if some91 != size:
            np.copyto(t3, C20, where=~m0)
        np.multiply(t2, t3, t3)
        np.multiply(t4, t1, t1)
        np.divide(t3, t1, t1)
        np.divide(C3, t2, t3)
        np.power(t1, t3, t3)
        np.greater(t1, C19, m0)
        np.less(t1, C21, m2)
        np.bitwise_and(m0, m2, m2)
        some112 = np.count_nonzero(m2)
        if some112:
            np.power(t3, n, other113)
            np.power(t3, C3, t4)
            np.multiply(other113, t4, t4)
            np.divide(t1, t4, t4)
            np.subtract(t4, C3, t4)
            np.divide(t4, t2, t4)
            np.multiply(t3, t4, t4)
            np.add(t3, t4, other113)
        if some112 != size:
            np.copyto(other113, t3, where=~m2)
        if some113:
            np.copyto(out, other113, where=~m1)


def tangential_displacement(a, c, A, n, E_star, G_star, mu):
    if a.__class__ is c.__class__ is A.__class__ is n.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v12 = n / 2.0 + 0.5
            v14 = v12 + 1.75
            v18 = (v12 + 0.5) * (v12 + 1.5)
            v32 = 1.0 / (v14 * v14)
            value = mu * (E_star / G_star) * (1.7724538509055159 * A * pow(a, n) * ((v12 * (v12 + 1.0) / v18 if v12 < 1.0 else 1.0 - (v12 + 0.75) / v18) * sqrt(v14) * (1.0 + v32 * (((((((0.01524698625788054 * v32 + 0.5334320651111477) * v32 + 2.250488865813539) * v32 + 2.8612106440066865) * v32 + 1.3794681629043655) * v32 + 0.2596058532893223) * v32 + 0.015624999999999823) / ((((((3.278794792785737 * v32 + 49.328555418276075) * v32 + 167.28648538571198) * v32 + 195.37226190335065) * v32 + 90.69722535867314) * v32 + 16.763212110504565) * v32 + 1.0))))) * -expm1(-n * (log1p((a - c) / c) if a > c else 0.0))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_tangential_displacement_a(c, A, n, E_star, G_star, mu):
    v7 = E_star / G_star
    v8 = mu * v7
    v10 = n / (2.0)
    v12 = v10 + (0.5)
    v14 = v12 + (1.75)
    v15 = v12 + (0.5)
    v17 = v12 + (1.5)
    v18 = v15 * v17
    v20 = np.less(v12, (1.0))
    v21 = v12 + (1.0)
    v22 = v12 * v21
    v23 = v22 / v18
    v25 = v12 + (0.75)
    v26 = v25 / v18
    v27 = (1.0) - v26
    v28 = v23 if v20 else v27
    v29 = np.sqrt(v14)
    v30 = v28 * v29
    v31 = v14 * v14
    v32 = (1.0) / v31
    v34 = (0.01524698625788054) * v32
    v36 = v34 + (0.5334320651111477)
    v37 = v36 * v32
    v39 = v37 + (2.250488865813539)
    v40 = v39 * v32
    v42 = v40 + (2.8612106440066865)
    v43 = v42 * v32
    v45 = v43 + (1.3794681629043655)
    v46 = v45 * v32
    v48 = v46 + (0.2596058532893223)
    v49 = v48 * v32
    v51 = v49 + (0.015624999999999823)
    v53 = (3.278794792785737) * v32
    v55 = v53 + (49.328555418276075)
    v56 = v55 * v32
    v58 = v56 + (167.28648538571198)
    v59 = v58 * v32
    v61 = v59 + (195.37226190335065)
    v62 = v61 * v32
    v64 = v62 + (90.69722535867314)
    v65 = v64 * v32
    v67 = v65 + (16.763212110504565)
    v68 = v67 * v32
    v69 = v68 + (1.0)
    v70 = v51 / v69
    v71 = v32 * v70
    v72 = (1.0) + v71
    v73 = v30 * v72
    v75 = (1.7724538509055159) * A
    v80 = np.negative(n)
    return (c, n, v8, v73, v75, v80)


def block_tangential_displacement_a(out, a, c, n, v8, v73, v75, v80, t0, m0):
    size = out.size
    np.power(a, n, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(v75, out, out)
    np.multiply(out, v73, out)
    np.multiply(v8, out, out)
    np.greater(a, c, m0)
    some86 = np.count_nonzero(m0)
    if some86:
        np.subtract(a, c, t0)
        np.divide(t0, c, t0)
        np.log1p(t0, t0)
    if some86 != size:
        np.copyto(t0, C19, where=~m0)
    np.multiply(v80, t0, t0)
    np.expm1(t0, t0)
    np.negative(t0, t0)
    np.multiply(out, t0, out)


def prepare_tangential_displacement_a_c(A, n, E_star, G_star, mu):
    v7 = E_star / G_star
    v8 = mu * v7
    v10 = n / (2.0)
    v12 = v10 + (0.5)
    v14 = v12 + (1.75)
    v15 = v12 + (0.5)
    v17 = v12 + (1.5)
    v18 = v15 * v17
    v20 = np.less(v12, (1.0))
    v21 = v12 + (1.0)
    v22 = v12 * v21
    v23 = v22 / v18
    v25 = v12 + (0.75)
    v26 = v25 / v18
    v27 = (1.0) - v26
    v28 = v23 if v20 else v27
    v29 = np.sqrt(v14)
    v30 = v28 * v29
    v31 = v14 * v14
    v32 = (1.0) / v31
    v34 = (0.01524698625788054) * v32
    v36 = v34 + (0.5334320651111477)
    v37 = v36 * v32
    v39 = v37 + (2.250488865813539)
    v40 = v39 * v32
    v42 = v40 + (2.8612106440066865)
    v43 = v42 * v32
    v45 = v43 + (1.3794681629043655)
    v46 = v45 * v32
    v48 = v46 + (0.2596058532893223)
    v49 = v48 * v32
    v51 = v49 + (0.015624999999999823)
    v53 = (3.278794792785737) * v32
    v55 = v53 + (49.328555418276075)
    v56 = v55 * v32
    v58 = v56 + (167.28648538571198)
    v59 = v58 * v32
    v61 = v59 + (195.37226190335065)
    v62 = v61 * v32
    v64 = v62 + (90.69722535867314)
    v65 = v64 * v32
    v67 = v65 + (16.763212110504565)
    v68 = v67 * v32
    v69 = v68 + (1.0)
    v70 = v51 / v69
    v71 = v32 * v70
    v72 = (1.0) + v71
    v73 = v30 * v72
    v75 = (1.7724538509055159) * A
    v80 = np.negative(n)
    return (n, v8, v73, v75, v80)


def block_tangential_displacement_a_c(out, a, c, n, v8, v73, v75, v80, t0, m0):
    size = out.size
    np.power(a, n, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.multiply(v75, out, out)
    np.multiply(out, v73, out)
    np.multiply(v8, out, out)
    np.greater(a, c, m0)
    some86 = np.count_nonzero(m0)
    if some86:
        np.subtract(a, c, t0)
        np.divide(t0, c, t0)
        np.log1p(t0, t0)
    if some86 != size:
        np.copyto(t0, C19, where=~m0)
    np.multiply(v80, t0, t0)
    np.expm1(t0, t0)
    np.negative(t0, t0)
    np.multiply(out, t0, out)


def prepare_tangential_displacement_all():
    return ()


def block_tangential_displacement_all(out, a, c, A, n, E_star, G_star, mu, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.divide(E_star, G_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.multiply(mu, out, out)
    np.multiply(n, C0, t0)
    np.add(t0, C0, t0)
    np.add(t0, C1, t1)
    np.add(t0, C0, t2)
    np.add(t0, C2, t3)
    np.multiply(t2, t3, t3)
    np.less(t0, C3, m0)
    some28 = np.count_nonzero(m0)
    if some28:
        np.add(t0, C3, t2)
        np.multiply(t0, t2, t2)
        np.divide(t2, t3, t2)
    if some28 != size:
        other28 = t4 if some28 else t2
        np.add(t0, C4, other28)
        np.divide(other28, t3, other28)
        np.subtract(C3, other28, other28)
        if some28:
            np.copyto(t2, other28, where=~m0)
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
    np.power(a, n, t1)
    np.multiply(t3, t1, t1)
    np.multiply(t1, t0, t0)
    np.multiply(out, t0, t0)
    np.negative(n, out)
    np.greater(a, c, m0)
    some86 = np.count_nonzero(m0)
    if some86:
        np.subtract(a, c, t1)
        np.divide(t1, c, t1)
        np.log1p(t1, t1)
    if some86 != size:
        np.copyto(t1, C19, where=~m0)
    np.multiply(out, t1, t1)
    np.expm1(t1, t1)
    np.negative(t1, t1)
    np.multiply(t0, t1, out)


def tangential_force(a, c, A, n, E_star, mu):
    if a.__class__ is c.__class__ is A.__class__ is n.__class__ is E_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v9 = n / 2.0 + 0.5
            v11 = v9 + 1.75
            v15 = (v9 + 0.5) * (v9 + 1.5)
            v29 = 1.0 / (v11 * v11)
            v75 = n + 1.0
            value = mu * (3.5449077018110318 * E_star * n * A / v75 * a * pow(a, n) * ((v9 * (v9 + 1.0) / v15 if v9 < 1.0 else 1.0 - (v9 + 0.75) / v15) * sqrt(v11) * (1.0 + v29 * (((((((0.01524698625788054 * v29 + 0.5334320651111477) * v29 + 2.250488865813539) * v29 + 2.8612106440066865) * v29 + 1.3794681629043655) * v29 + 0.2596058532893223) * v29 + 0.015624999999999823) / ((((((3.278794792785737 * v29 + 49.328555418276075) * v29 + 167.28648538571198) * v29 + 195.37226190335065) * v29 + 90.69722535867314) * v29 + 16.763212110504565) * v29 + 1.0))))) * -expm1(-v75 * (log1p((a - c) / c) if a > c else 0.0))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_tangential_force_a(c, A, n, E_star, mu):
    v7 = n / (2.0)
    v9 = v7 + (0.5)
    v11 = v9 + (1.75)
    v12 = v9 + (0.5)
    v14 = v9 + (1.5)
    v15 = v12 * v14
    v17 = np.less(v9, (1.0))
    v18 = v9 + (1.0)
    v19 = v9 * v18
    v20 = v19 / v15
    v22 = v9 + (0.75)
    v23 = v22 / v15
    v24 = (1.0) - v23
    v25 = v20 if v17 else v24
    v26 = np.sqrt(v11)
    v27 = v25 * v26
    v28 = v11 * v11
    v29 = (1.0) / v28
    v31 = (0.01524698625788054) * v29
    v33 = v31 + (0.5334320651111477)
    v34 = v33 * v29
    v36 = v34 + (2.250488865813539)
    v37 = v36 * v29
    v39 = v37 + (2.8612106440066865)
    v40 = v39 * v29
    v42 = v40 + (1.3794681629043655)
    v43 = v42 * v29
    v45 = v43 + (0.2596058532893223)
    v46 = v45 * v29
    v48 = v46 + (0.015624999999999823)
    v50 = (3.278794792785737) * v29
    v52 = v50 + (49.328555418276075)
    v53 = v52 * v29
    v55 = v53 + (167.28648538571198)
    v56 = v55 * v29
    v58 = v56 + (195.37226190335065)
    v59 = v58 * v29
    v61 = v59 + (90.69722535867314)
    v62 = v61 * v29
    v64 = v62 + (16.763212110504565)
    v65 = v64 * v29
    v66 = v65 + (1.0)
    v67 = v48 / v66
    v68 = v29 * v67
    v69 = (1.0) + v68
    v70 = v27 * v69
    v72 = (3.5449077018110318) * E_star
    v73 = v72 * n
    v74 = v73 * A
    v75 = n + (1.0)
    v76 = v74 / v75
    v82 = np.negative(v75)
    return (c, n, mu, v70, v76, v82)


def block_tangential_force_a(out, a, c, n, mu, v70, v76, v82, t0, m0):
    size = out.size
    np.multiply(v76, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.power(a, n, t0)
    np.multiply(out, t0, t0)
    np.multiply(t0, v70, t0)
    np.multiply(mu, t0, t0)
    np.greater(a, c, m0)
    some88 = np.count_nonzero(m0)
    if some88:
        np.subtract(a, c, out)
        np.divide(out, c, out)
        np.log1p(out, out)
    if some88 != size:
        np.copyto(out, C19, where=~m0)
    np.multiply(v82, out, out)
    np.expm1(out, out)
    np.negative(out, out)
    np.multiply(t0, out, out)


def prepare_tangential_force_a_c(A, n, E_star, mu):
    v7 = n / (2.0)
    v9 = v7 + (0.5)
    v11 = v9 + (1.75)
    v12 = v9 + (0.5)
    v14 = v9 + (1.5)
    v15 = v12 * v14
    v17 = np.less(v9, (1.0))
    v18 = v9 + (1.0)
    v19 = v9 * v18
    v20 = v19 / v15
    v22 = v9 + (0.75)
    v23 = v22 / v15
    v24 = (1.0) - v23
    v25 = v20 if v17 else v24
    v26 = np.sqrt(v11)
    v27 = v25 * v26
    v28 = v11 * v11
    v29 = (1.0) / v28
    v31 = (0.01524698625788054) * v29
    v33 = v31 + (0.5334320651111477)
    v34 = v33 * v29
    v36 = v34 + (2.250488865813539)
    v37 = v36 * v29
    v39 = v37 + (2.8612106440066865)
    v40 = v39 * v29
    v42 = v40 + (1.3794681629043655)
    v43 = v42 * v29
    v45 = v43 + (0.2596058532893223)
    v46 = v45 * v29
    v48 = v46 + (0.015624999999999823)
    v50 = (3.278794792785737) * v29
    v52 = v50 + (49.328555418276075)
    v53 = v52 * v29
    v55 = v53 + (167.28648538571198)
    v56 = v55 * v29
    v58 = v56 + (195.37226190335065)
    v59 = v58 * v29
    v61 = v59 + (90.69722535867314)
    v62 = v61 * v29
    v64 = v62 + (16.763212110504565)
    v65 = v64 * v29
    v66 = v65 + (1.0)
    v67 = v48 / v66
    v68 = v29 * v67
    v69 = (1.0) + v68
    v70 = v27 * v69
    v72 = (3.5449077018110318) * E_star
    v73 = v72 * n
    v74 = v73 * A
    v75 = n + (1.0)
    v76 = v74 / v75
    v82 = np.negative(v75)
    return (n, mu, v70, v76, v82)


def block_tangential_force_a_c(out, a, c, n, mu, v70, v76, v82, t0, m0):
    size = out.size
    np.multiply(v76, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.power(a, n, t0)
    np.multiply(out, t0, t0)
    np.multiply(t0, v70, t0)
    np.multiply(mu, t0, t0)
    np.greater(a, c, m0)
    some88 = np.count_nonzero(m0)
    if some88:
        np.subtract(a, c, out)
        np.divide(out, c, out)
        np.log1p(out, out)
    if some88 != size:
        np.copyto(out, C19, where=~m0)
    np.multiply(v82, out, out)
    np.expm1(out, out)
    np.negative(out, out)
    np.multiply(t0, out, out)


def prepare_tangential_force_all():
    return ()


def block_tangential_force_all(out, a, c, A, n, E_star, mu, t0, t1, t2, t3, m0):
    size = out.size
    np.multiply(n, C0, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.add(out, C0, out)
    np.add(out, C1, t0)
    np.add(out, C0, t1)
    np.add(out, C2, t2)
    np.multiply(t1, t2, t2)
    np.less(out, C3, m0)
    some25 = np.count_nonzero(m0)
    if some25:
        np.add(out, C3, t1)
        np.multiply(out, t1, t1)
        np.divide(t1, t2, t1)
    if some25 != size:
        other25 = t3 if some25 else t1
        np.add(out, C4, other25)
        np.divide(other25, t2, other25)
        np.subtract(C3, other25, other25)
        if some25:
            np.copyto(t1, other25, where=~m0)
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
    np.divide(t2, t0, t2)
    np.multiply(t2, a, t2)
    np.power(a, n, t1)
    np.multiply(t2, t1, t1)
    np.multiply(t1, out, out)
    np.multiply(mu, out, out)
    np.negative(t0, t0)
    np.greater(a, c, m0)
    some88 = np.count_nonzero(m0)
    if some88:
        np.subtract(a, c, t1)
        np.divide(t1, c, t1)
        np.log1p(t1, t1)
    if some88 != size:
        np.copyto(t1, C19, where=~m0)
    np.multiply(t0, t1, t1)
    np.expm1(t1, t1)
    np.negative(t1, t1)
    np.multiply(out, t1, out)


def traction(r, a, c, A, n, E_star, mu):
    if r.__class__ is a.__class__ is c.__class__ is A.__class__ is n.__class__ is E_star.__class__ is mu.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = bodies._traction(r, a, c, A, n, E_star, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, c, A, n, E_star, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_full_slip_displacement', 1, 'a', 'A', 'n', 'E_star', 'G_star', 'mu'): {
        ('a',): (('a',), prepare_full_slip_displacement_a, block_full_slip_displacement_a, 0, 0, (), False),
        ('a', 'A', 'n', 'E_star', 'G_star', 'mu'): (('a', 'A', 'n', 'E_star', 'G_star', 'mu'), prepare_full_slip_displacement_all, block_full_slip_displacement_all, 5, 1, (), False),
    },
    ('_stick_radius', 2, 'F_x', 'a', 'A', 'n', 'E_star', 'mu'): {
        ('F_x',): (('F_x',), prepare_stick_radius_F_x, block_stick_radius_F_x, 4, 3, (), False),
        ('F_x', 'a'): (('F_x', 'a'), prepare_stick_radius_F_x_a, block_stick_radius_F_x_a, 4, 3, (), False),
        ('F_x', 'a', 'A', 'n', 'E_star', 'mu'): (('F_x', 'a', 'A', 'n', 'E_star', 'mu'), prepare_stick_radius_all, block_stick_radius_all, 7, 3, (), False),
    },
    ('_tangential_displacement', 2, 'a', 'c', 'A', 'n', 'E_star', 'G_star', 'mu'): {
        ('a',): (('a',), prepare_tangential_displacement_a, block_tangential_displacement_a, 1, 1, (), False),
        ('a', 'c'): (('a', 'c'), prepare_tangential_displacement_a_c, block_tangential_displacement_a_c, 1, 1, (), False),
        ('a', 'c', 'A', 'n', 'E_star', 'G_star', 'mu'): (('a', 'c', 'A', 'n', 'E_star', 'G_star', 'mu'), prepare_tangential_displacement_all, block_tangential_displacement_all, 5, 1, (), False),
    },
    ('_tangential_force', 2, 'a', 'c', 'A', 'n', 'E_star', 'mu'): {
        ('a',): (('a',), prepare_tangential_force_a, block_tangential_force_a, 1, 1, (), False),
        ('a', 'c'): (('a', 'c'), prepare_tangential_force_a_c, block_tangential_force_a_c, 1, 1, (), False),
        ('a', 'c', 'A', 'n', 'E_star', 'mu'): (('a', 'c', 'A', 'n', 'E_star', 'mu'), prepare_tangential_force_all, block_tangential_force_all, 4, 1, (), False),
    },
}
