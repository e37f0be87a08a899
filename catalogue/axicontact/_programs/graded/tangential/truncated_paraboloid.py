"""Programs of axicontact.graded.tangential.truncated_paraboloid."""

from __future__ import annotations

from math import nan, pow, sqrt

import numpy as np

from ...._runtime.arrays.blocks import Program, largest
from ...._programs.bodies.graded.tangential import truncated_paraboloid as bodies

C0 = np.array(0.0)
C1 = np.array(np.nan)
C2 = np.array(1.0)
C3 = np.array(0.25)
C4 = np.array(2.0)
C5 = np.array(3.0)


def full_slip_displacement(a, R, b, H, H_x, k, mu):
    if a.__class__ is R.__class__ is b.__class__ is H.__class__ is H_x.__class__ is k.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (H_x > 1e-30) and (H_x < 1e+30) and (k > 1e-30) and (k < 1.0) and (mu > 1e-30) and (mu < 1e+30) and (b <= a):
        try:
            if a >= b:
                v10 = a - b
                v16 = sqrt((v10 if v10 > 0.0 or v10 != v10 else 0.0) * (a + b)) / a
                v30 = (a * a * (v16 * pow(v16, k) if v16 > 0.0 else 0.0) / (1.0 + k) + 0.0 * b) / R
            else:
                v30 = nan
            value = mu * (H / H_x) * v30
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_full_slip_displacement_a(R, b, H, H_x, k, mu):
    v7 = H / H_x
    v8 = mu * v7
    v24 = (1.0) + k
    v26 = (0.0) * b
    return (R, b, k, v8, v24, v26)


def block_full_slip_displacement_a(out, a, R, b, k, v8, v24, v26, t0, t1, m0, m1, f0):
    size = out.size
    np.greater_equal(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some30 = np.count_nonzero(m0)
    if some30:
        np.subtract(a, b, out)
        np.maximum(out, f0, out=out)
        np.add(a, b, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.divide(t0, a, t0)
        np.multiply(a, a, out)
        np.greater(t0, C0, m1)
        some21 = np.count_nonzero(m1)
        if some21:
            np.power(t0, k, t1)
            np.multiply(t0, t1, t1)
        if some21 != size:
            np.copyto(t1, C0, where=~m1)
        np.multiply(out, t1, t1)
        np.divide(t1, v24, t1)
        np.add(t1, v26, t1)
        np.divide(t1, R, out)
    if some30 != size:
        np.copyto(out, C1, where=~m0)
    np.multiply(v8, out, out)


def prepare_full_slip_displacement_all():
    return ()


def block_full_slip_displacement_all(out, a, R, b, H, H_x, k, mu, t0, t1, t2, m0, m1, f0):
    size = out.size
    np.divide(H, H_x, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(mu, out, out)
    np.greater_equal(a, b, m0)
    some30 = np.count_nonzero(m0)
    if some30:
        np.subtract(a, b, t0)
        np.maximum(t0, f0, out=t0)
        np.add(a, b, t1)
        np.multiply(t0, t1, t1)
        np.sqrt(t1, t1)
        np.divide(t1, a, t1)
        np.multiply(a, a, t0)
        np.greater(t1, C0, m1)
        some21 = np.count_nonzero(m1)
        if some21:
            np.power(t1, k, t2)
            np.multiply(t1, t2, t2)
        if some21 != size:
            np.copyto(t2, C0, where=~m1)
        np.multiply(t0, t2, t2)
        np.add(C2, k, t0)
        np.divide(t2, t0, t0)
        np.multiply(C0, b, t2)
        np.add(t0, t2, t2)
        np.divide(t2, R, t0)
    if some30 != size:
        np.copyto(t0, C1, where=~m0)
    np.multiply(out, t0, out)


def stick_radius(F_x, a, R, b, H, k, mu):
    if F_x.__class__ is a.__class__ is R.__class__ is b.__class__ is H.__class__ is k.__class__ is mu.__class__ is float and F_x > 1e-30 and (F_x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (mu > 1e-30) and (mu < 1e+30) and (b <= a):
        try:
            value = bodies._stick_radius(F_x, a, R, b, H, k, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_displacement(a, c, R, b, H, H_x, k, mu):
    if a.__class__ is c.__class__ is R.__class__ is b.__class__ is H.__class__ is H_x.__class__ is k.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (H_x > 1e-30) and (H_x < 1e+30) and (k > 1e-30) and (k < 1.0) and (mu > 1e-30) and (mu < 1e+30) and (b <= a):
        try:
            v8 = a - b
            v14 = sqrt((v8 if v8 > 0.0 or v8 != v8 else 0.0) * (a + b)) / a
            v22 = 1.0 + k
            v24 = 0.0 * b
            v25 = a * a * (v14 * pow(v14, k) if v14 > 0.0 else 0.0) / v22 + v24
            v26 = c - b
            v31 = sqrt((v26 if v26 > 0.0 or v26 != v26 else 0.0) * (c + b)) / c
            v39 = c * c * (v31 * pow(v31, k) if v31 > 0.0 else 0.0) / v22 + v24
            if v39 >= 0.25 * v25:
                return None
            if c >= b:
                value = mu * (H / H_x) * ((v25 - v39) / R)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_tangential_displacement_a(c, R, b, H, H_x, k, mu):
    v22 = (1.0) + k
    v24 = (0.0) * b
    v26 = c - b
    v27 = np.maximum(v26, (0.0))
    v28 = c + b
    v29 = v27 * v28
    v30 = np.sqrt(v29)
    v31 = v30 / c
    v32 = c * c
    v33 = np.greater(v31, (0.0))
    v34 = np.power(v31, k)
    v35 = v31 * v34
    v36 = v35 if v33 else (0.0)
    v37 = v32 * v36
    v38 = v37 / v22
    v39 = v38 + v24
    v45 = np.greater_equal(c, b)
    v46 = H / H_x
    v47 = mu * v46
    return (R, b, k, v22, v24, v39, v45, v47)


def block_tangential_displacement_a(out, a, R, b, k, v22, v24, v39, v45, v47, t0, t1, t2, m0, f0):
    size = out.size
    np.subtract(a, b, t0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.maximum(t0, f0, out=t0)
    np.add(a, b, t1)
    np.multiply(t0, t1, t1)
    np.sqrt(t1, t1)
    np.divide(t1, a, t1)
    np.multiply(a, a, t0)
    np.greater(t1, C0, m0)
    some19 = np.count_nonzero(m0)
    if some19:
        np.power(t1, k, t2)
        np.multiply(t1, t2, t2)
    if some19 != size:
        np.copyto(t2, C0, where=~m0)
    np.multiply(t0, t2, t2)
    np.divide(t2, v22, t2)
    np.add(t2, v24, t2)
    np.multiply(C3, t2, t0)
    np.greater_equal(v39, t0, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    if v45:
        np.subtract(t2, v39, out)
        np.divide(out, R, out)
        np.multiply(v47, out, out)
    else:
        np.copyto(out, C1)


def prepare_tangential_displacement_a_c(R, b, H, H_x, k, mu):
    v22 = (1.0) + k
    v24 = (0.0) * b
    v46 = H / H_x
    v47 = mu * v46
    return (R, b, k, v22, v24, v47)


def block_tangential_displacement_a_c(out, a, c, R, b, k, v22, v24, v47, t0, t1, t2, t3, m0, m1, f0):
    size = out.size
    np.subtract(a, b, t0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.maximum(t0, f0, out=t0)
    np.add(a, b, t1)
    np.multiply(t0, t1, t1)
    np.sqrt(t1, t1)
    np.divide(t1, a, t1)
    np.multiply(a, a, t0)
    np.greater(t1, C0, m0)
    some19 = np.count_nonzero(m0)
    if some19:
        np.power(t1, k, t2)
        np.multiply(t1, t2, t2)
    if some19 != size:
        np.copyto(t2, C0, where=~m0)
    np.multiply(t0, t2, t2)
    np.divide(t2, v22, t2)
    np.add(t2, v24, t2)
    np.subtract(c, b, t0)
    np.maximum(t0, f0, out=t0)
    np.add(c, b, t1)
    np.multiply(t0, t1, t1)
    np.sqrt(t1, t1)
    np.divide(t1, c, t1)
    np.multiply(c, c, t0)
    np.greater(t1, C0, m0)
    some36 = np.count_nonzero(m0)
    if some36:
        np.power(t1, k, t3)
        np.multiply(t1, t3, t3)
    if some36 != size:
        np.copyto(t3, C0, where=~m0)
    np.multiply(t0, t3, t3)
    np.divide(t3, v22, t3)
    np.add(t3, v24, t3)
    np.multiply(C3, t2, t0)
    np.greater_equal(t3, t0, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    np.greater_equal(c, b, m1)
    some50 = np.count_nonzero(m1)
    if some50:
        np.subtract(t2, t3, out)
        np.divide(out, R, out)
        np.multiply(v47, out, out)
    if some50 != size:
        np.copyto(out, C1, where=~m1)


def prepare_tangential_displacement_all():
    return ()


def block_tangential_displacement_all(out, a, c, R, b, H, H_x, k, mu, t0, t1, t2, t3, t4, t5, m0, m1, f0):
    size = out.size
    np.subtract(a, b, t0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.maximum(t0, f0, out=t0)
    np.add(a, b, t1)
    np.multiply(t0, t1, t1)
    np.sqrt(t1, t1)
    np.divide(t1, a, t1)
    np.multiply(a, a, t0)
    np.greater(t1, C0, m0)
    some19 = np.count_nonzero(m0)
    if some19:
        np.power(t1, k, t2)
        np.multiply(t1, t2, t2)
    if some19 != size:
        np.copyto(t2, C0, where=~m0)
    np.multiply(t0, t2, t2)
    np.add(C2, k, t0)
    np.divide(t2, t0, t2)
    np.multiply(C0, b, t1)
    np.add(t2, t1, t2)
    np.subtract(c, b, t3)
    np.maximum(t3, f0, out=t3)
    np.add(c, b, t4)
    np.multiply(t3, t4, t4)
    np.sqrt(t4, t4)
    np.divide(t4, c, t4)
    np.multiply(c, c, t3)
    np.greater(t4, C0, m0)
    some36 = np.count_nonzero(m0)
    if some36:
        np.power(t4, k, t5)
        np.multiply(t4, t5, t5)
    if some36 != size:
        np.copyto(t5, C0, where=~m0)
    np.multiply(t3, t5, t5)
    np.divide(t5, t0, t0)
    np.add(t0, t1, t1)
    np.multiply(C3, t2, t0)
    np.greater_equal(t1, t0, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    np.greater_equal(c, b, m1)
    some50 = np.count_nonzero(m1)
    if some50:
        np.subtract(t2, t1, out)
        np.divide(out, R, out)
        np.divide(H, H_x, t0)
        np.multiply(mu, t0, t0)
        np.multiply(t0, out, out)
    if some50 != size:
        np.copyto(out, C1, where=~m1)


def tangential_force(a, c, R, b, H, k, mu):
    if a.__class__ is c.__class__ is R.__class__ is b.__class__ is H.__class__ is k.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (mu > 1e-30) and (mu < 1e+30) and (b <= a):
        try:
            v7 = a - b
            v14 = sqrt((v7 if v7 > 0.0 or v7 != v7 else 0.0) * (a + b)) / (a if a > b or a != a else b)
            v27 = 3.0 + k
            v29 = 1.0 + k
            v35 = v29 * v27
            v37 = 0.0 * b
            v38 = a * a * (a * pow(a, k) if a > 0.0 else 0.0) * (v14 * pow(v14, k) if v14 > 0.0 else 0.0) * (v27 - v29 * (v14 * v14)) / v35 + v37
            v39 = c - b
            v45 = sqrt((v39 if v39 > 0.0 or v39 != v39 else 0.0) * (c + b)) / (c if c > b or c != c else b)
            v62 = c * c * (c * pow(c, k) if c > 0.0 else 0.0) * (v45 * pow(v45, k) if v45 > 0.0 else 0.0) * (v27 - v29 * (v45 * v45)) / v35 + v37
            if v62 >= 0.25 * v38:
                return None
            if c >= b:
                value = mu * (2.0 * H / v29) * ((v38 - v62) / R)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_tangential_force_a(c, R, b, H, k, mu):
    v27 = (3.0) + k
    v29 = (1.0) + k
    v35 = v29 * v27
    v37 = (0.0) * b
    v39 = c - b
    v40 = np.maximum(v39, (0.0))
    v41 = c + b
    v42 = v40 * v41
    v43 = np.sqrt(v42)
    v44 = np.maximum(c, b)
    v45 = v43 / v44
    v46 = c * c
    v47 = np.greater(c, (0.0))
    v48 = np.power(c, k)
    v49 = c * v48
    v50 = v49 if v47 else (0.0)
    v51 = v46 * v50
    v52 = np.greater(v45, (0.0))
    v53 = np.power(v45, k)
    v54 = v45 * v53
    v55 = v54 if v52 else (0.0)
    v56 = v51 * v55
    v57 = np.square(v45)
    v58 = v29 * v57
    v59 = v27 - v58
    v60 = v56 * v59
    v61 = v60 / v35
    v62 = v61 + v37
    v68 = np.greater_equal(c, b)
    v69 = (2.0) * H
    v70 = v69 / v29
    v71 = mu * v70
    return (R, b, k, v27, v29, v35, v37, v62, v68, v71)


def block_tangential_force_a(out, a, R, b, k, v27, v29, v35, v37, v62, v68, v71, t0, t1, t2, m0, f0):
    size = out.size
    np.subtract(a, b, t0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.maximum(t0, f0, out=t0)
    np.add(a, b, t1)
    np.multiply(t0, t1, t1)
    np.sqrt(t1, t1)
    np.maximum(a, b, out=t0)
    np.divide(t1, t0, t0)
    np.multiply(a, a, t1)
    np.greater(a, C0, m0)
    some19 = np.count_nonzero(m0)
    if some19:
        np.power(a, k, t2)
        np.multiply(a, t2, t2)
    if some19 != size:
        np.copyto(t2, C0, where=~m0)
    np.multiply(t1, t2, t2)
    np.greater(t0, C0, m0)
    some24 = np.count_nonzero(m0)
    if some24:
        np.power(t0, k, t1)
        np.multiply(t0, t1, t1)
    if some24 != size:
        np.copyto(t1, C0, where=~m0)
    np.multiply(t2, t1, t1)
    np.square(t0, t0)
    np.multiply(v29, t0, t0)
    np.subtract(v27, t0, t0)
    np.multiply(t1, t0, t0)
    np.divide(t0, v35, t0)
    np.add(t0, v37, t0)
    np.multiply(C3, t0, t1)
    np.greater_equal(v62, t1, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    if v68:
        np.subtract(t0, v62, out)
        np.divide(out, R, out)
        np.multiply(v71, out, out)
    else:
        np.copyto(out, C1)


def prepare_tangential_force_a_c(R, b, H, k, mu):
    v27 = (3.0) + k
    v29 = (1.0) + k
    v35 = v29 * v27
    v37 = (0.0) * b
    v69 = (2.0) * H
    v70 = v69 / v29
    v71 = mu * v70
    return (R, b, k, v27, v29, v35, v37, v71)


def block_tangential_force_a_c(out, a, c, R, b, k, v27, v29, v35, v37, v71, t0, t1, t2, t3, m0, m1, f0):
    size = out.size
    np.subtract(a, b, t0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.maximum(t0, f0, out=t0)
    np.add(a, b, t1)
    np.multiply(t0, t1, t1)
    np.sqrt(t1, t1)
    np.maximum(a, b, out=t0)
    np.divide(t1, t0, t0)
    np.multiply(a, a, t1)
    np.greater(a, C0, m0)
    some19 = np.count_nonzero(m0)
    if some19:
        np.power(a, k, t2)
        np.multiply(a, t2, t2)
    if some19 != size:
        np.copyto(t2, C0, where=~m0)
    np.multiply(t1, t2, t2)
    np.greater(t0, C0, m0)
    some24 = np.count_nonzero(m0)
    if some24:
        np.power(t0, k, t1)
        np.multiply(t0, t1, t1)
    if some24 != size:
        np.copyto(t1, C0, where=~m0)
    np.multiply(t2, t1, t1)
    np.square(t0, t0)
    np.multiply(v29, t0, t0)
    np.subtract(v27, t0, t0)
    np.multiply(t1, t0, t0)
    np.divide(t0, v35, t0)
    np.add(t0, v37, t0)
    np.subtract(c, b, t1)
    np.maximum(t1, f0, out=t1)
    np.add(c, b, t2)
    np.multiply(t1, t2, t2)
    np.sqrt(t2, t2)
    np.maximum(c, b, out=t1)
    np.divide(t2, t1, t1)
    np.multiply(c, c, t2)
    np.greater(c, C0, m0)
    some50 = np.count_nonzero(m0)
    if some50:
        np.power(c, k, t3)
        np.multiply(c, t3, t3)
    if some50 != size:
        np.copyto(t3, C0, where=~m0)
    np.multiply(t2, t3, t3)
    np.greater(t1, C0, m0)
    some55 = np.count_nonzero(m0)
    if some55:
        np.power(t1, k, t2)
        np.multiply(t1, t2, t2)
    if some55 != size:
        np.copyto(t2, C0, where=~m0)
    np.multiply(t3, t2, t2)
    np.square(t1, t1)
    np.multiply(v29, t1, t1)
    np.subtract(v27, t1, t1)
    np.multiply(t2, t1, t1)
    np.divide(t1, v35, t1)
    np.add(t1, v37, t1)
    np.multiply(C3, t0, t2)
    np.greater_equal(t1, t2, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    np.greater_equal(c, b, m1)
    some74 = np.count_nonzero(m1)
    if some74:
        np.subtract(t0, t1, out)
        np.divide(out, R, out)
        np.multiply(v71, out, out)
    if some74 != size:
        np.copyto(out, C1, where=~m1)


def prepare_tangential_force_all():
    return ()


def block_tangential_force_all(out, a, c, R, b, H, k, mu, t0, t1, t2, t3, t4, t5, t6, t7, m0, m1, f0):
    size = out.size
    np.subtract(a, b, t0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.maximum(t0, f0, out=t0)
    np.add(a, b, t1)
    np.multiply(t0, t1, t1)
    np.sqrt(t1, t1)
    np.maximum(a, b, out=t0)
    np.divide(t1, t0, t0)
    np.multiply(a, a, t1)
    np.greater(a, C0, m0)
    some19 = np.count_nonzero(m0)
    if some19:
        np.power(a, k, t2)
        np.multiply(a, t2, t2)
    if some19 != size:
        np.copyto(t2, C0, where=~m0)
    np.multiply(t1, t2, t2)
    np.greater(t0, C0, m0)
    some24 = np.count_nonzero(m0)
    if some24:
        np.power(t0, k, t1)
        np.multiply(t0, t1, t1)
    if some24 != size:
        np.copyto(t1, C0, where=~m0)
    np.multiply(t2, t1, t1)
    np.add(C5, k, t2)
    np.add(C2, k, t3)
    np.square(t0, t0)
    np.multiply(t3, t0, t0)
    np.subtract(t2, t0, t0)
    np.multiply(t1, t0, t0)
    np.multiply(t3, t2, t1)
    np.divide(t0, t1, t0)
    np.multiply(C0, b, t4)
    np.add(t0, t4, t0)
    np.subtract(c, b, t5)
    np.maximum(t5, f0, out=t5)
    np.add(c, b, t6)
    np.multiply(t5, t6, t6)
    np.sqrt(t6, t6)
    np.maximum(c, b, out=t5)
    np.divide(t6, t5, t5)
    np.multiply(c, c, t6)
    np.greater(c, C0, m0)
    some50 = np.count_nonzero(m0)
    if some50:
        np.power(c, k, t7)
        np.multiply(c, t7, t7)
    if some50 != size:
        np.copyto(t7, C0, where=~m0)
    np.multiply(t6, t7, t7)
    np.greater(t5, C0, m0)
    some55 = np.count_nonzero(m0)
    if some55:
        np.power(t5, k, t6)
        np.multiply(t5, t6, t6)
    if some55 != size:
        np.copyto(t6, C0, where=~m0)
    np.multiply(t7, t6, t6)
    np.square(t5, t5)
    np.multiply(t3, t5, t5)
    np.subtract(t2, t5, t5)
    np.multiply(t6, t5, t5)
    np.divide(t5, t1, t1)
    np.add(t1, t4, t4)
    np.multiply(C3, t0, t1)
    np.greater_equal(t4, t1, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    np.greater_equal(c, b, m1)
    some74 = np.count_nonzero(m1)
    if some74:
        np.subtract(t0, t4, out)
        np.divide(out, R, out)
        np.multiply(C4, H, t1)
        np.divide(t1, t3, t1)
        np.multiply(mu, t1, t1)
        np.multiply(t1, out, out)
    if some74 != size:
        np.copyto(out, C1, where=~m1)


BLOCKS = {
    ('_full_slip_displacement', 1, 'a', 'R', 'b', 'H', 'H_x', 'k', 'mu'): {
        ('a',): Program(('a',), prepare_full_slip_displacement_a, block_full_slip_displacement_a, scratch=2, masks=2, filled=(0.0,)),
        ('a', 'R', 'b', 'H', 'H_x', 'k', 'mu'): Program(('a', 'R', 'b', 'H', 'H_x', 'k', 'mu'), prepare_full_slip_displacement_all, block_full_slip_displacement_all, scratch=3, masks=2, filled=(0.0,)),
    },
    ('_tangential_displacement', 2, 'a', 'c', 'R', 'b', 'H', 'H_x', 'k', 'mu'): {
        ('a',): Program(('a',), prepare_tangential_displacement_a, block_tangential_displacement_a, scratch=3, masks=1, filled=(0.0,)),
        ('a', 'c'): Program(('a', 'c'), prepare_tangential_displacement_a_c, block_tangential_displacement_a_c, scratch=4, masks=2, filled=(0.0,)),
        ('a', 'c', 'R', 'b', 'H', 'H_x', 'k', 'mu'): Program(('a', 'c', 'R', 'b', 'H', 'H_x', 'k', 'mu'), prepare_tangential_displacement_all, block_tangential_displacement_all, scratch=6, masks=2, filled=(0.0,)),
    },
    ('_tangential_force', 2, 'a', 'c', 'R', 'b', 'H', 'k', 'mu'): {
        ('a',): Program(('a',), prepare_tangential_force_a, block_tangential_force_a, scratch=3, masks=1, filled=(0.0,)),
        ('a', 'c'): Program(('a', 'c'), prepare_tangential_force_a_c, block_tangential_force_a_c, scratch=4, masks=2, filled=(0.0,)),
        ('a', 'c', 'R', 'b', 'H', 'k', 'mu'): Program(('a', 'c', 'R', 'b', 'H', 'k', 'mu'), prepare_tangential_force_all, block_tangential_force_all, scratch=8, masks=2, filled=(0.0,)),
    },
}
