"""Programs of axicontact.viscoelastic.truncated_paraboloid."""

from __future__ import annotations

from math import expm1, inf, log1p, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._programs.bodies.viscoelastic import truncated_paraboloid as bodies

C0 = np.array(1.0)
C1 = np.array(np.inf)
C2 = np.array(0.0)
C3 = np.array(2.0)
C4 = np.array(4.0)
C5 = np.array(0.5)


def contact_time_kelvin_voigt(v, v_2, t_m, E, eta):
    if v.__class__ is v_2.__class__ is t_m.__class__ is E.__class__ is eta.__class__ is float and v > 1e-30 and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            v8 = t_m / (v_2 / v) - eta / E
            return t_m + (v8 if v8 > 0.0 or v8 != v8 else 0.0)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_contact_time_kelvin_voigt_all_signed():
    return ()


def block_contact_time_kelvin_voigt_all_signed(out, v, v_2, t_m, E, eta, t0, f0):
    np.divide(v_2, v, out)
    np.divide(t_m, out, out)
    np.divide(eta, E, t0)
    np.subtract(out, t0, t0)
    np.maximum(t0, f0, out=t0)
    np.add(t_m, t0, out)


def contact_time_maxwell(v, v_2, t_m, E, tau):
    if v.__class__ is v_2.__class__ is t_m.__class__ is E.__class__ is tau.__class__ is float and v > 1e-30 and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = t_m + tau * log1p(-expm1(-t_m / tau) / (v_2 / v))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_contact_time_maxwell_all_signed():
    return ()


def block_contact_time_maxwell_all_signed(out, v, v_2, t_m, E, tau, t0):
    np.divide(v_2, v, out)
    np.negative(t_m, t0)
    np.divide(t0, tau, t0)
    np.expm1(t0, t0)
    np.negative(t0, t0)
    np.divide(t0, out, out)
    np.log1p(out, out)
    np.multiply(tau, out, out)
    np.add(t_m, out, out)


def contact_time_power_creep(v, v_2, t_m, E, alpha, t_0):
    if v.__class__ is v_2.__class__ is t_m.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and v > 1e-30 and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            v10 = log1p(v_2 / v) / (1.0 - alpha)
            value = t_m + t_m / expm1(v10 if v10 < 700.0 or v10 != v10 else 700.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_contact_time_power_creep_all_signed():
    return ()


def block_contact_time_power_creep_all_signed(out, v, v_2, t_m, E, alpha, t_0, t0, f0):
    np.divide(v_2, v, out)
    np.log1p(out, out)
    np.subtract(C0, alpha, t0)
    np.divide(out, t0, t0)
    np.minimum(t0, f0, out=t0)
    np.expm1(t0, t0)
    np.divide(t_m, t0, t0)
    np.add(t_m, t0, out)


def contact_time_standard_solid(v, v_2, t_m, E_inf, E_1, tau):
    if v.__class__ is v_2.__class__ is t_m.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and v > 1e-30 and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > -1e+30) and (tau < 1e+30):
        try:
            value = bodies._contact_time_standard_solid(v, v_2, t_m, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(v, v_2, t_m, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def earlier_time_kelvin_voigt(t, v, v_2, t_m, E, eta):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            if t > t_m:
                v7 = t - t_m
                v14 = t_m - v_2 / v * ((v7 if v7 > 0.0 or v7 != v7 else 0.0) + eta / E)
                return v14 if v14 > 0.0 or v14 != v14 else 0.0
            return t
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_earlier_time_kelvin_voigt_t(v, v_2, t_m, E, eta):
    v6 = v_2 / v
    v10 = eta / E
    return (t_m, v6, v10)


def block_earlier_time_kelvin_voigt_t(out, t, t_m, v6, v10, m0, f0):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some16 = np.count_nonzero(m0)
    if some16:
        np.subtract(t, t_m, out)
        np.maximum(out, f0, out=out)
        np.add(out, v10, out)
        np.multiply(v6, out, out)
        np.subtract(t_m, out, out)
        np.maximum(out, f0, out=out)
    if some16 != size:
        np.copyto(out, t, where=~m0)


def prepare_earlier_time_kelvin_voigt_all():
    return ()


def block_earlier_time_kelvin_voigt_all(out, t, v, v_2, t_m, E, eta, t0, t1, m0, f0):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some16 = np.count_nonzero(m0)
    if some16:
        np.divide(v_2, v, out)
        np.subtract(t, t_m, t0)
        np.maximum(t0, f0, out=t0)
        np.divide(eta, E, t1)
        np.add(t0, t1, t1)
        np.multiply(out, t1, t1)
        np.subtract(t_m, t1, t1)
        np.maximum(t1, f0, out=out)
    if some16 != size:
        np.copyto(out, t, where=~m0)


def earlier_time_maxwell(t, v, v_2, t_m, E, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            if t > t_m:
                v7 = t - t_m
                v10 = (v7 if v7 > 0.0 or v7 != v7 else 0.0) / tau
                v14 = v_2 / v * expm1(v10 if v10 < 700.0 or v10 != v10 else 700.0)
                v26 = t_m - (-tau * log1p(-(v14 if v14 < 0.9999999999999998 or v14 != v14 else 0.9999999999999998)) if v14 < 1.0 else inf)
                value = v26 if v26 > 0.0 or v26 != v26 else 0.0
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return t
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_earlier_time_maxwell_t(v, v_2, t_m, E, tau):
    v5 = v_2 / v
    v16 = np.negative(tau)
    return (t_m, tau, v5, v16)


def block_earlier_time_maxwell_t(out, t, t_m, tau, v5, v16, t0, m0, m1, f0, f1, f2):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some27 = np.count_nonzero(m0)
    if some27:
        np.subtract(t, t_m, out)
        np.maximum(out, f0, out=out)
        np.divide(out, tau, out)
        np.minimum(out, f1, out=out)
        np.expm1(out, out)
        np.multiply(v5, out, out)
        np.less(out, C0, m1)
        some23 = np.count_nonzero(m1)
        if some23:
            np.minimum(out, f2, out=t0)
            np.negative(t0, t0)
            np.log1p(t0, t0)
            np.multiply(v16, t0, t0)
        if some23 != size:
            np.copyto(t0, C1, where=~m1)
        np.subtract(t_m, t0, t0)
        np.maximum(t0, f0, out=out)
    if some27 != size:
        np.copyto(out, t, where=~m0)


def prepare_earlier_time_maxwell_all():
    return ()


def block_earlier_time_maxwell_all(out, t, v, v_2, t_m, E, tau, t0, t1, m0, m1, f0, f1, f2):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some27 = np.count_nonzero(m0)
    if some27:
        np.divide(v_2, v, out)
        np.subtract(t, t_m, t0)
        np.maximum(t0, f0, out=t0)
        np.divide(t0, tau, t0)
        np.minimum(t0, f1, out=t0)
        np.expm1(t0, t0)
        np.multiply(out, t0, t0)
        np.less(t0, C0, m1)
        some23 = np.count_nonzero(m1)
        if some23:
            np.negative(tau, out)
            np.minimum(t0, f2, out=t1)
            np.negative(t1, t1)
            np.log1p(t1, t1)
            np.multiply(out, t1, out)
        if some23 != size:
            np.copyto(out, C1, where=~m1)
        np.subtract(t_m, out, out)
        np.maximum(out, f0, out=out)
    if some27 != size:
        np.copyto(out, t, where=~m0)


def earlier_time_power_creep(t, v, v_2, t_m, E, alpha, t_0):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            if t > t_m:
                v8 = t - t_m
                v14 = log1p(v_2 / v) / (1.0 - alpha)
                v20 = t_m - (v8 if v8 > 0.0 or v8 != v8 else 0.0) * expm1(v14 if v14 < 700.0 or v14 != v14 else 700.0)
                value = v20 if v20 > 0.0 or v20 != v20 else 0.0
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return t
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_earlier_time_power_creep_t(v, v_2, t_m, E, alpha, t_0):
    v5 = v_2 / v
    v9 = np.log1p(v5)
    v11 = (1.0) - alpha
    v12 = v9 / v11
    v14 = np.minimum(v12, (700.0))
    v15 = np.expm1(v14)
    return (t_m, v15)


def block_earlier_time_power_creep_t(out, t, t_m, v15, m0, f0):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some20 = np.count_nonzero(m0)
    if some20:
        np.subtract(t, t_m, out)
        np.maximum(out, f0, out=out)
        np.multiply(out, v15, out)
        np.subtract(t_m, out, out)
        np.maximum(out, f0, out=out)
    if some20 != size:
        np.copyto(out, t, where=~m0)


def prepare_earlier_time_power_creep_all():
    return ()


def block_earlier_time_power_creep_all(out, t, v, v_2, t_m, E, alpha, t_0, t0, t1, m0, f0, f1):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some20 = np.count_nonzero(m0)
    if some20:
        np.divide(v_2, v, out)
        np.subtract(t, t_m, t0)
        np.maximum(t0, f0, out=t0)
        np.log1p(out, out)
        np.subtract(C0, alpha, t1)
        np.divide(out, t1, t1)
        np.minimum(t1, f1, out=t1)
        np.expm1(t1, t1)
        np.multiply(t0, t1, t1)
        np.subtract(t_m, t1, t1)
        np.maximum(t1, f0, out=out)
    if some20 != size:
        np.copyto(out, t, where=~m0)


def earlier_time_standard_solid(t, v, v_2, t_m, E_inf, E_1, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._earlier_time_standard_solid(t, v, v_2, t_m, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, v_2, t_m, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def ramp_force_kelvin_voigt(t, v, R, b, E, eta):
    if t.__class__ is v.__class__ is R.__class__ is b.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            value = bodies._ramp_force_kelvin_voigt(t, v, R, b, E, eta)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, R, b, E, eta):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_force_kelvin_voigt(t, v, v_2, t_m, R, b, E, eta):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is R.__class__ is b.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            value = bodies._retract_force_kelvin_voigt(t, v, v_2, t_m, R, b, E, eta)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, v_2, t_m, R, b, E, eta):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_radius_kelvin_voigt(t, v, v_2, t_m, R, b, E, eta):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is R.__class__ is b.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            if t > t_m:
                v9 = t - t_m
                v16 = t_m - v_2 / v * ((v9 if v9 > 0.0 or v9 != v9 else 0.0) + eta / E)
                v18 = v16 if v16 > 0.0 or v16 != v16 else 0.0
            else:
                v18 = t
            if v18 <= 0.0:
                return 0.0
            v20 = v * v18
            v23 = b * b
            value = sqrt(sqrt(v23 * v23 + 4.0 * (R * R) * (v20 * v20)) / R + v23 / R) * sqrt(2.0 * R) / 2.0
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_retract_radius_kelvin_voigt_t(R, b, v, v_2, t_m, E, eta):
    v8 = v_2 / v
    v12 = eta / E
    v23 = np.square(b)
    v24 = np.square(v23)
    v25 = np.square(R)
    v26 = (4.0) * v25
    v32 = v23 / R
    v35 = (2.0) * R
    v36 = np.sqrt(v35)
    v39 = v36 * (0.5)
    return (v, t_m, R, v8, v12, v24, v26, v32, v39)


def block_retract_radius_kelvin_voigt_t(out, t, v, t_m, R, v8, v12, v24, v26, v32, v39, t0, t1, m0, f0):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some18 = np.count_nonzero(m0)
    if some18:
        np.subtract(t, t_m, t0)
        np.maximum(t0, f0, out=t0)
        np.add(t0, v12, t0)
        np.multiply(v8, t0, t0)
        np.subtract(t_m, t0, t0)
        np.maximum(t0, f0, out=t0)
    if some18 != size:
        np.copyto(t0, t, where=~m0)
    np.less_equal(t0, C2, m0)
    some41 = np.count_nonzero(m0)
    if some41:
        np.copyto(out, C2)
    if some41 != size:
        other41 = t1 if some41 else out
        np.multiply(v, t0, other41)
        np.square(other41, other41)
        np.multiply(v26, other41, other41)
        np.add(v24, other41, other41)
        np.sqrt(other41, other41)
        np.divide(other41, R, other41)
        np.add(other41, v32, other41)
        np.sqrt(other41, other41)
        np.multiply(other41, v39, other41)
        if some41:
            np.copyto(out, other41, where=~m0)


def prepare_retract_radius_kelvin_voigt_all():
    return ()


def block_retract_radius_kelvin_voigt_all(out, t, R, b, v, v_2, t_m, E, eta, t0, t1, t2, t3, t4, m0, f0):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some18 = np.count_nonzero(m0)
    if some18:
        np.divide(v_2, v, t0)
        np.subtract(t, t_m, t1)
        np.maximum(t1, f0, out=t1)
        np.divide(eta, E, t2)
        np.add(t1, t2, t2)
        np.multiply(t0, t2, t2)
        np.subtract(t_m, t2, t2)
        np.maximum(t2, f0, out=t0)
    if some18 != size:
        np.copyto(t0, t, where=~m0)
    np.less_equal(t0, C2, m0)
    some40 = np.count_nonzero(m0)
    if some40:
        np.copyto(out, C2)
    if some40 != size:
        other40 = t2 if some40 else out
        np.multiply(v, t0, other40)
        np.square(b, t1)
        np.square(t1, t3)
        np.square(R, t4)
        np.multiply(C4, t4, t4)
        np.square(other40, other40)
        np.multiply(t4, other40, other40)
        np.add(t3, other40, other40)
        np.sqrt(other40, other40)
        np.divide(other40, R, other40)
        np.divide(t1, R, t1)
        np.add(other40, t1, t1)
        np.sqrt(t1, t1)
        np.multiply(C3, R, other40)
        np.sqrt(other40, other40)
        np.multiply(t1, other40, other40)
        np.multiply(other40, C5, other40)
        if some40:
            np.copyto(out, other40, where=~m0)


def retract_radius_maxwell(t, v, v_2, t_m, R, b, E, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is R.__class__ is b.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            if t > t_m:
                v9 = t - t_m
                v12 = (v9 if v9 > 0.0 or v9 != v9 else 0.0) / tau
                v16 = v_2 / v * expm1(v12 if v12 < 700.0 or v12 != v12 else 700.0)
                v28 = t_m - (-tau * log1p(-(v16 if v16 < 0.9999999999999998 or v16 != v16 else 0.9999999999999998)) if v16 < 1.0 else inf)
                v30 = v28 if v28 > 0.0 or v28 != v28 else 0.0
            else:
                v30 = t
            if v30 <= 0.0:
                value = 0.0
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            v32 = v * v30
            v35 = b * b
            value = sqrt(sqrt(v35 * v35 + 4.0 * (R * R) * (v32 * v32)) / R + v35 / R) * sqrt(2.0 * R) / 2.0
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_retract_radius_maxwell_t(R, b, v, v_2, t_m, E, tau):
    v7 = v_2 / v
    v18 = np.negative(tau)
    v34 = np.square(b)
    v35 = np.square(v34)
    v36 = np.square(R)
    v37 = (4.0) * v36
    v43 = v34 / R
    v46 = (2.0) * R
    v47 = np.sqrt(v46)
    v50 = v47 * (0.5)
    return (v, t_m, R, tau, v7, v18, v35, v37, v43, v50)


def block_retract_radius_maxwell_t(out, t, v, t_m, R, tau, v7, v18, v35, v37, v43, v50, t0, t1, m0, m1, f0, f1, f2):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some29 = np.count_nonzero(m0)
    if some29:
        np.subtract(t, t_m, t0)
        np.maximum(t0, f0, out=t0)
        np.divide(t0, tau, t0)
        np.minimum(t0, f1, out=t0)
        np.expm1(t0, t0)
        np.multiply(v7, t0, t0)
        np.less(t0, C0, m1)
        some25 = np.count_nonzero(m1)
        if some25:
            np.minimum(t0, f2, out=t1)
            np.negative(t1, t1)
            np.log1p(t1, t1)
            np.multiply(v18, t1, t1)
        if some25 != size:
            np.copyto(t1, C1, where=~m1)
        np.subtract(t_m, t1, t1)
        np.maximum(t1, f0, out=t0)
    if some29 != size:
        np.copyto(t0, t, where=~m0)
    np.less_equal(t0, C2, m0)
    some52 = np.count_nonzero(m0)
    if some52:
        np.copyto(out, C2)
    if some52 != size:
        other52 = t1 if some52 else out
        np.multiply(v, t0, other52)
        np.square(other52, other52)
        np.multiply(v37, other52, other52)
        np.add(v35, other52, other52)
        np.sqrt(other52, other52)
        np.divide(other52, R, other52)
        np.add(other52, v43, other52)
        np.sqrt(other52, other52)
        np.multiply(other52, v50, other52)
        if some52:
            np.copyto(out, other52, where=~m0)


def prepare_retract_radius_maxwell_all():
    return ()


def block_retract_radius_maxwell_all(out, t, R, b, v, v_2, t_m, E, tau, t0, t1, t2, t3, t4, m0, m1, f0, f1, f2):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some29 = np.count_nonzero(m0)
    if some29:
        np.divide(v_2, v, t0)
        np.subtract(t, t_m, t1)
        np.maximum(t1, f0, out=t1)
        np.divide(t1, tau, t1)
        np.minimum(t1, f1, out=t1)
        np.expm1(t1, t1)
        np.multiply(t0, t1, t1)
        np.less(t1, C0, m1)
        some25 = np.count_nonzero(m1)
        if some25:
            np.negative(tau, t0)
            np.minimum(t1, f2, out=t2)
            np.negative(t2, t2)
            np.log1p(t2, t2)
            np.multiply(t0, t2, t0)
        if some25 != size:
            np.copyto(t0, C1, where=~m1)
        np.subtract(t_m, t0, t0)
        np.maximum(t0, f0, out=t0)
    if some29 != size:
        np.copyto(t0, t, where=~m0)
    np.less_equal(t0, C2, m0)
    some51 = np.count_nonzero(m0)
    if some51:
        np.copyto(out, C2)
    if some51 != size:
        other51 = t1 if some51 else out
        np.multiply(v, t0, other51)
        np.square(b, t2)
        np.square(t2, t3)
        np.square(R, t4)
        np.multiply(C4, t4, t4)
        np.square(other51, other51)
        np.multiply(t4, other51, other51)
        np.add(t3, other51, other51)
        np.sqrt(other51, other51)
        np.divide(other51, R, other51)
        np.divide(t2, R, t2)
        np.add(other51, t2, t2)
        np.sqrt(t2, t2)
        np.multiply(C3, R, other51)
        np.sqrt(other51, other51)
        np.multiply(t2, other51, other51)
        np.multiply(other51, C5, other51)
        if some51:
            np.copyto(out, other51, where=~m0)


def retract_radius_power_creep(t, v, v_2, t_m, R, b, E, alpha, t_0):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is R.__class__ is b.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            if t > t_m:
                v10 = t - t_m
                v16 = log1p(v_2 / v) / (1.0 - alpha)
                v22 = t_m - (v10 if v10 > 0.0 or v10 != v10 else 0.0) * expm1(v16 if v16 < 700.0 or v16 != v16 else 700.0)
                v24 = v22 if v22 > 0.0 or v22 != v22 else 0.0
            else:
                v24 = t
            if v24 <= 0.0:
                value = 0.0
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            v26 = v * v24
            v29 = b * b
            value = sqrt(sqrt(v29 * v29 + 4.0 * (R * R) * (v26 * v26)) / R + v29 / R) * sqrt(2.0 * R) / 2.0
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_retract_radius_power_creep_t(R, b, v, v_2, t_m, E, alpha, t_0):
    v7 = v_2 / v
    v11 = np.log1p(v7)
    v13 = (1.0) - alpha
    v14 = v11 / v13
    v16 = np.minimum(v14, (700.0))
    v17 = np.expm1(v16)
    v27 = np.square(b)
    v28 = np.square(v27)
    v29 = np.square(R)
    v30 = (4.0) * v29
    v36 = v27 / R
    v39 = (2.0) * R
    v40 = np.sqrt(v39)
    v43 = v40 * (0.5)
    return (v, t_m, R, v17, v28, v30, v36, v43)


def block_retract_radius_power_creep_t(out, t, v, t_m, R, v17, v28, v30, v36, v43, t0, t1, m0, f0):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some22 = np.count_nonzero(m0)
    if some22:
        np.subtract(t, t_m, t0)
        np.maximum(t0, f0, out=t0)
        np.multiply(t0, v17, t0)
        np.subtract(t_m, t0, t0)
        np.maximum(t0, f0, out=t0)
    if some22 != size:
        np.copyto(t0, t, where=~m0)
    np.less_equal(t0, C2, m0)
    some45 = np.count_nonzero(m0)
    if some45:
        np.copyto(out, C2)
    if some45 != size:
        other45 = t1 if some45 else out
        np.multiply(v, t0, other45)
        np.square(other45, other45)
        np.multiply(v30, other45, other45)
        np.add(v28, other45, other45)
        np.sqrt(other45, other45)
        np.divide(other45, R, other45)
        np.add(other45, v36, other45)
        np.sqrt(other45, other45)
        np.multiply(other45, v43, other45)
        if some45:
            np.copyto(out, other45, where=~m0)


def prepare_retract_radius_power_creep_all():
    return ()


def block_retract_radius_power_creep_all(out, t, R, b, v, v_2, t_m, E, alpha, t_0, t0, t1, t2, t3, t4, m0, f0, f1):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some22 = np.count_nonzero(m0)
    if some22:
        np.divide(v_2, v, t0)
        np.subtract(t, t_m, t1)
        np.maximum(t1, f0, out=t1)
        np.log1p(t0, t0)
        np.subtract(C0, alpha, t2)
        np.divide(t0, t2, t2)
        np.minimum(t2, f1, out=t2)
        np.expm1(t2, t2)
        np.multiply(t1, t2, t2)
        np.subtract(t_m, t2, t2)
        np.maximum(t2, f0, out=t0)
    if some22 != size:
        np.copyto(t0, t, where=~m0)
    np.less_equal(t0, C2, m0)
    some44 = np.count_nonzero(m0)
    if some44:
        np.copyto(out, C2)
    if some44 != size:
        other44 = t2 if some44 else out
        np.multiply(v, t0, other44)
        np.square(b, t1)
        np.square(t1, t3)
        np.square(R, t4)
        np.multiply(C4, t4, t4)
        np.square(other44, other44)
        np.multiply(t4, other44, other44)
        np.add(t3, other44, other44)
        np.sqrt(other44, other44)
        np.divide(other44, R, other44)
        np.divide(t1, R, t1)
        np.add(other44, t1, t1)
        np.sqrt(t1, t1)
        np.multiply(C3, R, other44)
        np.sqrt(other44, other44)
        np.multiply(t1, other44, other44)
        np.multiply(other44, C5, other44)
        if some44:
            np.copyto(out, other44, where=~m0)


def retract_radius_standard_solid(t, v, v_2, t_m, R, b, E_inf, E_1, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is R.__class__ is b.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._retract_radius_standard_solid(t, v, v_2, t_m, R, b, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, v_2, t_m, R, b, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_force_kelvin_voigt(t, d, R, b, E, eta):
    if t.__class__ is d.__class__ is R.__class__ is b.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            value = bodies._step_force_kelvin_voigt(t, d, R, b, E, eta)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, d, R, b, E, eta):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_force_maxwell(t, d, R, b, E, tau):
    if t.__class__ is d.__class__ is R.__class__ is b.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._step_force_maxwell(t, d, R, b, E, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, d, R, b, E, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_force_power_creep(t, d, R, b, E, alpha, t_0):
    if t.__class__ is d.__class__ is R.__class__ is b.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            value = bodies._step_force_power_creep(t, d, R, b, E, alpha, t_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, d, R, b, E, alpha, t_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_force_standard_solid(t, d, R, b, E_inf, E_1, tau):
    if t.__class__ is d.__class__ is R.__class__ is b.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._step_force_standard_solid(t, d, R, b, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, d, R, b, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_load_radius_kelvin_voigt(t, F, R, b, E, eta):
    if t.__class__ is F.__class__ is R.__class__ is b.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            value = bodies._step_load_radius_kelvin_voigt(t, F, R, b, E, eta)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, F, R, b, E, eta):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_load_radius_maxwell(t, F, R, b, E, tau):
    if t.__class__ is F.__class__ is R.__class__ is b.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._step_load_radius_maxwell(t, F, R, b, E, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, F, R, b, E, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_load_radius_power_creep(t, F, R, b, E, alpha, t_0):
    if t.__class__ is F.__class__ is R.__class__ is b.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            value = bodies._step_load_radius_power_creep(t, F, R, b, E, alpha, t_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, F, R, b, E, alpha, t_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_load_radius_standard_solid(t, F, R, b, E_inf, E_1, tau):
    if t.__class__ is F.__class__ is R.__class__ is b.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._step_load_radius_standard_solid(t, F, R, b, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, F, R, b, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_contact_time_kelvin_voigt', 0, 'v', 'v_2', 't_m', 'E', 'eta'): {
        ('v', 'v_2', 't_m', 'E', 'eta'): (('v', 'v_2', 't_m', 'E', 'eta'), prepare_contact_time_kelvin_voigt_all_signed, block_contact_time_kelvin_voigt_all_signed, 1, 0, (0.0,), False),
    },
    ('_contact_time_maxwell', 0, 'v', 'v_2', 't_m', 'E', 'tau'): {
        ('v', 'v_2', 't_m', 'E', 'tau'): (('v', 'v_2', 't_m', 'E', 'tau'), prepare_contact_time_maxwell_all_signed, block_contact_time_maxwell_all_signed, 1, 0, (), False),
    },
    ('_contact_time_power_creep', 0, 'v', 'v_2', 't_m', 'E', 'alpha', 't_0'): {
        ('v', 'v_2', 't_m', 'E', 'alpha', 't_0'): (('v', 'v_2', 't_m', 'E', 'alpha', 't_0'), prepare_contact_time_power_creep_all_signed, block_contact_time_power_creep_all_signed, 1, 0, (700.0,), False),
    },
    ('_earlier_time_kelvin_voigt', 1, 't', 'v', 'v_2', 't_m', 'E', 'eta'): {
        ('t',): (('t',), prepare_earlier_time_kelvin_voigt_t, block_earlier_time_kelvin_voigt_t, 0, 1, (0.0,), False),
        ('t', 'v', 'v_2', 't_m', 'E', 'eta'): (('t', 'v', 'v_2', 't_m', 'E', 'eta'), prepare_earlier_time_kelvin_voigt_all, block_earlier_time_kelvin_voigt_all, 2, 1, (0.0,), False),
    },
    ('_earlier_time_maxwell', 1, 't', 'v', 'v_2', 't_m', 'E', 'tau'): {
        ('t',): (('t',), prepare_earlier_time_maxwell_t, block_earlier_time_maxwell_t, 1, 2, (0.0, 700.0, 0.9999999999999998), False),
        ('t', 'v', 'v_2', 't_m', 'E', 'tau'): (('t', 'v', 'v_2', 't_m', 'E', 'tau'), prepare_earlier_time_maxwell_all, block_earlier_time_maxwell_all, 2, 2, (0.0, 700.0, 0.9999999999999998), False),
    },
    ('_earlier_time_power_creep', 1, 't', 'v', 'v_2', 't_m', 'E', 'alpha', 't_0'): {
        ('t',): (('t',), prepare_earlier_time_power_creep_t, block_earlier_time_power_creep_t, 0, 1, (0.0,), False),
        ('t', 'v', 'v_2', 't_m', 'E', 'alpha', 't_0'): (('t', 'v', 'v_2', 't_m', 'E', 'alpha', 't_0'), prepare_earlier_time_power_creep_all, block_earlier_time_power_creep_all, 2, 1, (0.0, 700.0), False),
    },
    ('_retract_radius_kelvin_voigt', 1, 't', 'R', 'b', 'v', 'v_2', 't_m', 'E', 'eta'): {
        ('t',): (('t',), prepare_retract_radius_kelvin_voigt_t, block_retract_radius_kelvin_voigt_t, 2, 1, (0.0,), False),
        ('t', 'R', 'b', 'v', 'v_2', 't_m', 'E', 'eta'): (('t', 'R', 'b', 'v', 'v_2', 't_m', 'E', 'eta'), prepare_retract_radius_kelvin_voigt_all, block_retract_radius_kelvin_voigt_all, 5, 1, (0.0,), False),
    },
    ('_retract_radius_maxwell', 1, 't', 'R', 'b', 'v', 'v_2', 't_m', 'E', 'tau'): {
        ('t',): (('t',), prepare_retract_radius_maxwell_t, block_retract_radius_maxwell_t, 2, 2, (0.0, 700.0, 0.9999999999999998), False),
        ('t', 'R', 'b', 'v', 'v_2', 't_m', 'E', 'tau'): (('t', 'R', 'b', 'v', 'v_2', 't_m', 'E', 'tau'), prepare_retract_radius_maxwell_all, block_retract_radius_maxwell_all, 5, 2, (0.0, 700.0, 0.9999999999999998), False),
    },
    ('_retract_radius_power_creep', 1, 't', 'R', 'b', 'v', 'v_2', 't_m', 'E', 'alpha', 't_0'): {
        ('t',): (('t',), prepare_retract_radius_power_creep_t, block_retract_radius_power_creep_t, 2, 1, (0.0,), False),
        ('t', 'R', 'b', 'v', 'v_2', 't_m', 'E', 'alpha', 't_0'): (('t', 'R', 'b', 'v', 'v_2', 't_m', 'E', 'alpha', 't_0'), prepare_retract_radius_power_creep_all, block_retract_radius_power_creep_all, 5, 1, (0.0, 700.0), False),
    },
}
