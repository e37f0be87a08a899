"""Programs of axicontact.viscoelastic.truncated_paraboloid."""

from __future__ import annotations

from math import exp, expm1, inf, log1p, pow, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._programs.bodies.viscoelastic import truncated_paraboloid as bodies

C0 = np.array(0.0)
C1 = np.array(1.0)
C2 = np.array(np.inf)
C3 = np.array(2.0)
C4 = np.array(4.0)
C5 = np.array(0.5)


def contact_time_kelvin_voigt(v, v_2, t_m, t_h, E, eta):
    if v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is E.__class__ is eta.__class__ is float and v > 1e-30 and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            v9 = t_m / (v_2 / v) - eta / E
            return t_h + (v9 if v9 > 0.0 or v9 != v9 else 0.0)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_contact_time_kelvin_voigt_all_signed():
    return ()


def block_contact_time_kelvin_voigt_all_signed(out, v, v_2, t_m, t_h, E, eta, t0, f0):
    np.divide(v_2, v, out)
    np.divide(t_m, out, out)
    np.divide(eta, E, t0)
    np.subtract(out, t0, t0)
    np.maximum(t0, f0, out=t0)
    np.add(t_h, t0, out)


def contact_time_maxwell(v, v_2, t_m, t_h, E, tau):
    if v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is E.__class__ is tau.__class__ is float and v > 1e-30 and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = t_h + tau * log1p(-expm1(-t_m / tau) * exp((t_m - t_h) / tau) / (v_2 / v))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_contact_time_maxwell_all_signed():
    return ()


def block_contact_time_maxwell_all_signed(out, v, v_2, t_m, t_h, E, tau, t0, t1):
    np.divide(v_2, v, out)
    np.negative(t_m, t0)
    np.divide(t0, tau, t0)
    np.expm1(t0, t0)
    np.negative(t0, t0)
    np.subtract(t_m, t_h, t1)
    np.divide(t1, tau, t1)
    np.exp(t1, t1)
    np.multiply(t0, t1, t1)
    np.divide(t1, out, out)
    np.log1p(out, out)
    np.multiply(tau, out, out)
    np.add(t_h, out, out)


def contact_time_power_creep(v, v_2, t_m, t_h, E, alpha, t_0):
    if v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and v > 1e-30 and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            value = bodies._contact_time_power_creep(v, v_2, t_m, t_h, E, alpha, t_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(v, v_2, t_m, t_h, E, alpha, t_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def contact_time_standard_solid(v, v_2, t_m, t_h, E_inf, E_1, tau):
    if v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and v > 1e-30 and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > -1e+30) and (tau < 1e+30):
        try:
            value = bodies._contact_time_standard_solid(v, v_2, t_m, t_h, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(v, v_2, t_m, t_h, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def earlier_time_kelvin_voigt(t, v, v_2, t_m, t_h, E, eta):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            if t > t_m:
                v16 = t_m - (v_2 / v * (t - t_h + eta / E) if t > t_h else 0.0)
                return v16 if v16 > 0.0 or v16 != v16 else 0.0
            return t
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_earlier_time_kelvin_voigt_t(v, v_2, t_m, t_h, E, eta):
    v7 = v_2 / v
    v10 = eta / E
    return (t_m, t_h, v7, v10)


def block_earlier_time_kelvin_voigt_t(out, t, t_m, t_h, v7, v10, m0, m1, f0):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some18 = np.count_nonzero(m0)
    if some18:
        np.greater(t, t_h, m1)
        some14 = np.count_nonzero(m1)
        if some14:
            np.subtract(t, t_h, out)
            np.add(out, v10, out)
            np.multiply(v7, out, out)
        if some14 != size:
            np.copyto(out, C0, where=~m1)
        np.subtract(t_m, out, out)
        np.maximum(out, f0, out=out)
    if some18 != size:
        np.copyto(out, t, where=~m0)


def prepare_earlier_time_kelvin_voigt_all():
    return ()


def block_earlier_time_kelvin_voigt_all(out, t, v, v_2, t_m, t_h, E, eta, t0, t1, m0, m1, f0):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some18 = np.count_nonzero(m0)
    if some18:
        np.greater(t, t_h, m1)
        some14 = np.count_nonzero(m1)
        if some14:
            np.divide(v_2, v, out)
            np.subtract(t, t_h, t0)
            np.divide(eta, E, t1)
            np.add(t0, t1, t1)
            np.multiply(out, t1, out)
        if some14 != size:
            np.copyto(out, C0, where=~m1)
        np.subtract(t_m, out, out)
        np.maximum(out, f0, out=out)
    if some18 != size:
        np.copyto(out, t, where=~m0)


def earlier_time_maxwell(t, v, v_2, t_m, t_h, E, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            if t > t_m:
                v8 = t - t_h
                v11 = (v8 if v8 > 0.0 or v8 != v8 else 0.0) / tau
                v17 = (t_h - t_m) / tau
                v20 = v_2 / v * expm1(v11 if v11 < 700.0 or v11 != v11 else 700.0) * exp(v17 if v17 < 700.0 or v17 != v17 else 700.0)
                v32 = t_m - (-tau * log1p(-(v20 if v20 < 0.9999999999999998 or v20 != v20 else 0.9999999999999998)) if v20 < 1.0 else inf)
                value = v32 if v32 > 0.0 or v32 != v32 else 0.0
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return t
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_earlier_time_maxwell_t(v, v_2, t_m, t_h, E, tau):
    v6 = v_2 / v
    v15 = t_h - t_m
    v16 = v15 / tau
    v17 = np.minimum(v16, (700.0))
    v18 = np.exp(v17)
    v22 = np.negative(tau)
    return (t_m, t_h, tau, v6, v18, v22)


def block_earlier_time_maxwell_t(out, t, t_m, t_h, tau, v6, v18, v22, t0, m0, m1, f0, f1, f2):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some33 = np.count_nonzero(m0)
    if some33:
        np.subtract(t, t_h, out)
        np.maximum(out, f0, out=out)
        np.divide(out, tau, out)
        np.minimum(out, f1, out=out)
        np.expm1(out, out)
        np.multiply(v6, out, out)
        np.multiply(out, v18, out)
        np.less(out, C1, m1)
        some29 = np.count_nonzero(m1)
        if some29:
            np.minimum(out, f2, out=t0)
            np.negative(t0, t0)
            np.log1p(t0, t0)
            np.multiply(v22, t0, t0)
        if some29 != size:
            np.copyto(t0, C2, where=~m1)
        np.subtract(t_m, t0, t0)
        np.maximum(t0, f0, out=out)
    if some33 != size:
        np.copyto(out, t, where=~m0)


def prepare_earlier_time_maxwell_all():
    return ()


def block_earlier_time_maxwell_all(out, t, v, v_2, t_m, t_h, E, tau, t0, t1, m0, m1, f0, f1, f2):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some33 = np.count_nonzero(m0)
    if some33:
        np.divide(v_2, v, out)
        np.subtract(t, t_h, t0)
        np.maximum(t0, f0, out=t0)
        np.divide(t0, tau, t0)
        np.minimum(t0, f1, out=t0)
        np.expm1(t0, t0)
        np.multiply(out, t0, t0)
        np.subtract(t_h, t_m, out)
        np.divide(out, tau, out)
        np.minimum(out, f1, out=out)
        np.exp(out, out)
        np.multiply(t0, out, out)
        np.less(out, C1, m1)
        some29 = np.count_nonzero(m1)
        if some29:
            np.negative(tau, t0)
            np.minimum(out, f2, out=t1)
            np.negative(t1, t1)
            np.log1p(t1, t1)
            np.multiply(t0, t1, t0)
        if some29 != size:
            np.copyto(t0, C2, where=~m1)
        np.subtract(t_m, t0, t0)
        np.maximum(t0, f0, out=out)
    if some33 != size:
        np.copyto(out, t, where=~m0)


def earlier_time_power_creep(t, v, v_2, t_m, t_h, E, alpha, t_0):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            if t > t_m:
                v11 = t - t_m
                v16 = 1.0 - alpha
                v21 = log1p(v_2 / v * pow((t - t_h) / v11 if t > t_h else 0.0, v16)) / v16
                v27 = t_m - (v11 if v11 > 0.0 or v11 != v11 else 0.0) * expm1(v21 if v21 < 700.0 or v21 != v21 else 700.0)
                value = v27 if v27 > 0.0 or v27 != v27 else 0.0
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return t
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_earlier_time_power_creep_t(v, v_2, t_m, t_h, E, alpha, t_0):
    v6 = v_2 / v
    v14 = (1.0) - alpha
    return (t_m, t_h, v6, v14)


def block_earlier_time_power_creep_t(out, t, t_m, t_h, v6, v14, t0, m0, m1, f0, f1):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some27 = np.count_nonzero(m0)
    if some27:
        np.greater(t, t_h, m1)
        np.subtract(t, t_m, out)
        some12 = np.count_nonzero(m1)
        if some12:
            np.subtract(t, t_h, t0)
            np.divide(t0, out, t0)
        if some12 != size:
            np.copyto(t0, C0, where=~m1)
        np.maximum(out, f0, out=out)
        np.power(t0, v14, t0)
        np.multiply(v6, t0, t0)
        np.log1p(t0, t0)
        np.divide(t0, v14, t0)
        np.minimum(t0, f1, out=t0)
        np.expm1(t0, t0)
        np.multiply(out, t0, t0)
        np.subtract(t_m, t0, t0)
        np.maximum(t0, f0, out=out)
    if some27 != size:
        np.copyto(out, t, where=~m0)


def prepare_earlier_time_power_creep_all():
    return ()


def block_earlier_time_power_creep_all(out, t, v, v_2, t_m, t_h, E, alpha, t_0, t0, t1, t2, m0, m1, f0, f1):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some27 = np.count_nonzero(m0)
    if some27:
        np.divide(v_2, v, out)
        np.greater(t, t_h, m1)
        np.subtract(t, t_m, t0)
        some12 = np.count_nonzero(m1)
        if some12:
            np.subtract(t, t_h, t1)
            np.divide(t1, t0, t1)
        if some12 != size:
            np.copyto(t1, C0, where=~m1)
        np.subtract(C1, alpha, t2)
        np.maximum(t0, f0, out=t0)
        np.power(t1, t2, t1)
        np.multiply(out, t1, t1)
        np.log1p(t1, t1)
        np.divide(t1, t2, t2)
        np.minimum(t2, f1, out=t2)
        np.expm1(t2, t2)
        np.multiply(t0, t2, t2)
        np.subtract(t_m, t2, t2)
        np.maximum(t2, f0, out=out)
    if some27 != size:
        np.copyto(out, t, where=~m0)


def earlier_time_standard_solid(t, v, v_2, t_m, t_h, E_inf, E_1, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._earlier_time_standard_solid(t, v, v_2, t_m, t_h, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and t > t_h)) and ordinary(t, v, v_2, t_m, t_h, E_inf, E_1, tau):
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


def ramp_force_maxwell(t, v, R, b, E, tau):
    if t.__class__ is v.__class__ is R.__class__ is b.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._ramp_force_maxwell(t, v, R, b, E, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, R, b, E, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def ramp_force_power_creep(t, v, R, b, E, alpha, t_0):
    if t.__class__ is v.__class__ is R.__class__ is b.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            value = bodies._ramp_force_power_creep(t, v, R, b, E, alpha, t_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, R, b, E, alpha, t_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def ramp_force_standard_solid(t, v, R, b, E_inf, E_1, tau):
    if t.__class__ is v.__class__ is R.__class__ is b.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._ramp_force_standard_solid(t, v, R, b, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, R, b, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_force_kelvin_voigt(t, v, v_2, t_m, t_h, R, b, E, eta):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is R.__class__ is b.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            value = bodies._retract_force_kelvin_voigt(t, v, v_2, t_m, t_h, R, b, E, eta)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and t > t_h)) and ordinary(t, v, v_2, t_m, t_h, R, b, E, eta):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_force_maxwell(t, v, v_2, t_m, t_h, R, b, E, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is R.__class__ is b.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._retract_force_maxwell(t, v, v_2, t_m, t_h, R, b, E, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and t > t_h)) and ordinary(t, v, v_2, t_m, t_h, R, b, E, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_force_power_creep(t, v, v_2, t_m, t_h, R, b, E, alpha, t_0):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is R.__class__ is b.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            value = bodies._retract_force_power_creep(t, v, v_2, t_m, t_h, R, b, E, alpha, t_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and t > t_h)) and ordinary(t, v, v_2, t_m, t_h, R, b, E, alpha, t_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_force_standard_solid(t, v, v_2, t_m, t_h, R, b, E_inf, E_1, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is R.__class__ is b.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._retract_force_standard_solid(t, v, v_2, t_m, t_h, R, b, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and t > t_h)) and ordinary(t, v, v_2, t_m, t_h, R, b, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_radius_kelvin_voigt(t, v, v_2, t_m, t_h, R, b, E, eta):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is R.__class__ is b.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            if t > t_m:
                v18 = t_m - (v_2 / v * (t - t_h + eta / E) if t > t_h else 0.0)
                v20 = v18 if v18 > 0.0 or v18 != v18 else 0.0
            else:
                v20 = t
            if v20 <= 0.0:
                return 0.0
            v22 = v * v20
            v25 = b * b
            value = sqrt(sqrt(v25 * v25 + 4.0 * (R * R) * (v22 * v22)) / R + v25 / R) * sqrt(2.0 * R) / 2.0
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_retract_radius_kelvin_voigt_t(R, b, v, v_2, t_m, t_h, E, eta):
    v9 = v_2 / v
    v12 = eta / E
    v25 = np.square(b)
    v26 = np.square(v25)
    v27 = np.square(R)
    v28 = (4.0) * v27
    v34 = v25 / R
    v37 = (2.0) * R
    v38 = np.sqrt(v37)
    v41 = v38 * (0.5)
    return (v, t_m, t_h, R, v9, v12, v26, v28, v34, v41)


def block_retract_radius_kelvin_voigt_t(out, t, v, t_m, t_h, R, v9, v12, v26, v28, v34, v41, t0, t1, m0, m1, f0):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some20 = np.count_nonzero(m0)
    if some20:
        np.greater(t, t_h, m1)
        some16 = np.count_nonzero(m1)
        if some16:
            np.subtract(t, t_h, t0)
            np.add(t0, v12, t0)
            np.multiply(v9, t0, t0)
        if some16 != size:
            np.copyto(t0, C0, where=~m1)
        np.subtract(t_m, t0, t0)
        np.maximum(t0, f0, out=t0)
    if some20 != size:
        np.copyto(t0, t, where=~m0)
    np.less_equal(t0, C0, m0)
    some43 = np.count_nonzero(m0)
    if some43:
        np.copyto(out, C0)
    if some43 != size:
        other43 = t1 if some43 else out
        np.multiply(v, t0, other43)
        np.square(other43, other43)
        np.multiply(v28, other43, other43)
        np.add(v26, other43, other43)
        np.sqrt(other43, other43)
        np.divide(other43, R, other43)
        np.add(other43, v34, other43)
        np.sqrt(other43, other43)
        np.multiply(other43, v41, other43)
        if some43:
            np.copyto(out, other43, where=~m0)


def prepare_retract_radius_kelvin_voigt_all():
    return ()


def block_retract_radius_kelvin_voigt_all(out, t, R, b, v, v_2, t_m, t_h, E, eta, t0, t1, t2, t3, t4, m0, m1, f0):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some20 = np.count_nonzero(m0)
    if some20:
        np.greater(t, t_h, m1)
        some16 = np.count_nonzero(m1)
        if some16:
            np.divide(v_2, v, t0)
            np.subtract(t, t_h, t1)
            np.divide(eta, E, t2)
            np.add(t1, t2, t2)
            np.multiply(t0, t2, t0)
        if some16 != size:
            np.copyto(t0, C0, where=~m1)
        np.subtract(t_m, t0, t0)
        np.maximum(t0, f0, out=t0)
    if some20 != size:
        np.copyto(t0, t, where=~m0)
    np.less_equal(t0, C0, m0)
    some42 = np.count_nonzero(m0)
    if some42:
        np.copyto(out, C0)
    if some42 != size:
        other42 = t2 if some42 else out
        np.multiply(v, t0, other42)
        np.square(b, t1)
        np.square(t1, t3)
        np.square(R, t4)
        np.multiply(C4, t4, t4)
        np.square(other42, other42)
        np.multiply(t4, other42, other42)
        np.add(t3, other42, other42)
        np.sqrt(other42, other42)
        np.divide(other42, R, other42)
        np.divide(t1, R, t1)
        np.add(other42, t1, t1)
        np.sqrt(t1, t1)
        np.multiply(C3, R, other42)
        np.sqrt(other42, other42)
        np.multiply(t1, other42, other42)
        np.multiply(other42, C5, other42)
        if some42:
            np.copyto(out, other42, where=~m0)


def retract_radius_maxwell(t, v, v_2, t_m, t_h, R, b, E, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is R.__class__ is b.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            if t > t_m:
                v10 = t - t_h
                v13 = (v10 if v10 > 0.0 or v10 != v10 else 0.0) / tau
                v19 = (t_h - t_m) / tau
                v22 = v_2 / v * expm1(v13 if v13 < 700.0 or v13 != v13 else 700.0) * exp(v19 if v19 < 700.0 or v19 != v19 else 700.0)
                v34 = t_m - (-tau * log1p(-(v22 if v22 < 0.9999999999999998 or v22 != v22 else 0.9999999999999998)) if v22 < 1.0 else inf)
                v36 = v34 if v34 > 0.0 or v34 != v34 else 0.0
            else:
                v36 = t
            if v36 <= 0.0:
                value = 0.0
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            v38 = v * v36
            v41 = b * b
            value = sqrt(sqrt(v41 * v41 + 4.0 * (R * R) * (v38 * v38)) / R + v41 / R) * sqrt(2.0 * R) / 2.0
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_retract_radius_maxwell_t(R, b, v, v_2, t_m, t_h, E, tau):
    v8 = v_2 / v
    v17 = t_h - t_m
    v18 = v17 / tau
    v19 = np.minimum(v18, (700.0))
    v20 = np.exp(v19)
    v24 = np.negative(tau)
    v40 = np.square(b)
    v41 = np.square(v40)
    v42 = np.square(R)
    v43 = (4.0) * v42
    v49 = v40 / R
    v52 = (2.0) * R
    v53 = np.sqrt(v52)
    v56 = v53 * (0.5)
    return (v, t_m, t_h, R, tau, v8, v20, v24, v41, v43, v49, v56)


def block_retract_radius_maxwell_t(out, t, v, t_m, t_h, R, tau, v8, v20, v24, v41, v43, v49, v56, t0, t1, m0, m1, f0, f1, f2):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some35 = np.count_nonzero(m0)
    if some35:
        np.subtract(t, t_h, t0)
        np.maximum(t0, f0, out=t0)
        np.divide(t0, tau, t0)
        np.minimum(t0, f1, out=t0)
        np.expm1(t0, t0)
        np.multiply(v8, t0, t0)
        np.multiply(t0, v20, t0)
        np.less(t0, C1, m1)
        some31 = np.count_nonzero(m1)
        if some31:
            np.minimum(t0, f2, out=t1)
            np.negative(t1, t1)
            np.log1p(t1, t1)
            np.multiply(v24, t1, t1)
        if some31 != size:
            np.copyto(t1, C2, where=~m1)
        np.subtract(t_m, t1, t1)
        np.maximum(t1, f0, out=t0)
    if some35 != size:
        np.copyto(t0, t, where=~m0)
    np.less_equal(t0, C0, m0)
    some58 = np.count_nonzero(m0)
    if some58:
        np.copyto(out, C0)
    if some58 != size:
        other58 = t1 if some58 else out
        np.multiply(v, t0, other58)
        np.square(other58, other58)
        np.multiply(v43, other58, other58)
        np.add(v41, other58, other58)
        np.sqrt(other58, other58)
        np.divide(other58, R, other58)
        np.add(other58, v49, other58)
        np.sqrt(other58, other58)
        np.multiply(other58, v56, other58)
        if some58:
            np.copyto(out, other58, where=~m0)


def prepare_retract_radius_maxwell_all():
    return ()


def block_retract_radius_maxwell_all(out, t, R, b, v, v_2, t_m, t_h, E, tau, t0, t1, t2, t3, t4, m0, m1, f0, f1, f2):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some35 = np.count_nonzero(m0)
    if some35:
        np.divide(v_2, v, t0)
        np.subtract(t, t_h, t1)
        np.maximum(t1, f0, out=t1)
        np.divide(t1, tau, t1)
        np.minimum(t1, f1, out=t1)
        np.expm1(t1, t1)
        np.multiply(t0, t1, t1)
        np.subtract(t_h, t_m, t0)
        np.divide(t0, tau, t0)
        np.minimum(t0, f1, out=t0)
        np.exp(t0, t0)
        np.multiply(t1, t0, t0)
        np.less(t0, C1, m1)
        some31 = np.count_nonzero(m1)
        if some31:
            np.negative(tau, t1)
            np.minimum(t0, f2, out=t2)
            np.negative(t2, t2)
            np.log1p(t2, t2)
            np.multiply(t1, t2, t1)
        if some31 != size:
            np.copyto(t1, C2, where=~m1)
        np.subtract(t_m, t1, t1)
        np.maximum(t1, f0, out=t0)
    if some35 != size:
        np.copyto(t0, t, where=~m0)
    np.less_equal(t0, C0, m0)
    some57 = np.count_nonzero(m0)
    if some57:
        np.copyto(out, C0)
    if some57 != size:
        other57 = t1 if some57 else out
        np.multiply(v, t0, other57)
        np.square(b, t2)
        np.square(t2, t3)
        np.square(R, t4)
        np.multiply(C4, t4, t4)
        np.square(other57, other57)
        np.multiply(t4, other57, other57)
        np.add(t3, other57, other57)
        np.sqrt(other57, other57)
        np.divide(other57, R, other57)
        np.divide(t2, R, t2)
        np.add(other57, t2, t2)
        np.sqrt(t2, t2)
        np.multiply(C3, R, other57)
        np.sqrt(other57, other57)
        np.multiply(t2, other57, other57)
        np.multiply(other57, C5, other57)
        if some57:
            np.copyto(out, other57, where=~m0)


def retract_radius_power_creep(t, v, v_2, t_m, t_h, R, b, E, alpha, t_0):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is R.__class__ is b.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            if t > t_m:
                v13 = t - t_m
                v18 = 1.0 - alpha
                v23 = log1p(v_2 / v * pow((t - t_h) / v13 if t > t_h else 0.0, v18)) / v18
                v29 = t_m - (v13 if v13 > 0.0 or v13 != v13 else 0.0) * expm1(v23 if v23 < 700.0 or v23 != v23 else 700.0)
                v31 = v29 if v29 > 0.0 or v29 != v29 else 0.0
            else:
                v31 = t
            if v31 <= 0.0:
                value = 0.0
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            v33 = v * v31
            v36 = b * b
            value = sqrt(sqrt(v36 * v36 + 4.0 * (R * R) * (v33 * v33)) / R + v36 / R) * sqrt(2.0 * R) / 2.0
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_retract_radius_power_creep_t(R, b, v, v_2, t_m, t_h, E, alpha, t_0):
    v8 = v_2 / v
    v16 = (1.0) - alpha
    v34 = np.square(b)
    v35 = np.square(v34)
    v36 = np.square(R)
    v37 = (4.0) * v36
    v43 = v34 / R
    v46 = (2.0) * R
    v47 = np.sqrt(v46)
    v50 = v47 * (0.5)
    return (v, t_m, t_h, R, v8, v16, v35, v37, v43, v50)


def block_retract_radius_power_creep_t(out, t, v, t_m, t_h, R, v8, v16, v35, v37, v43, v50, t0, t1, m0, m1, f0, f1):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some29 = np.count_nonzero(m0)
    if some29:
        np.greater(t, t_h, m1)
        np.subtract(t, t_m, t0)
        some14 = np.count_nonzero(m1)
        if some14:
            np.subtract(t, t_h, t1)
            np.divide(t1, t0, t1)
        if some14 != size:
            np.copyto(t1, C0, where=~m1)
        np.maximum(t0, f0, out=t0)
        np.power(t1, v16, t1)
        np.multiply(v8, t1, t1)
        np.log1p(t1, t1)
        np.divide(t1, v16, t1)
        np.minimum(t1, f1, out=t1)
        np.expm1(t1, t1)
        np.multiply(t0, t1, t1)
        np.subtract(t_m, t1, t1)
        np.maximum(t1, f0, out=t0)
    if some29 != size:
        np.copyto(t0, t, where=~m0)
    np.less_equal(t0, C0, m0)
    some52 = np.count_nonzero(m0)
    if some52:
        np.copyto(out, C0)
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


def prepare_retract_radius_power_creep_all():
    return ()


def block_retract_radius_power_creep_all(out, t, R, b, v, v_2, t_m, t_h, E, alpha, t_0, t0, t1, t2, t3, t4, m0, m1, f0, f1):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some29 = np.count_nonzero(m0)
    if some29:
        np.divide(v_2, v, t0)
        np.greater(t, t_h, m1)
        np.subtract(t, t_m, t1)
        some14 = np.count_nonzero(m1)
        if some14:
            np.subtract(t, t_h, t2)
            np.divide(t2, t1, t2)
        if some14 != size:
            np.copyto(t2, C0, where=~m1)
        np.subtract(C1, alpha, t3)
        np.maximum(t1, f0, out=t1)
        np.power(t2, t3, t2)
        np.multiply(t0, t2, t2)
        np.log1p(t2, t2)
        np.divide(t2, t3, t3)
        np.minimum(t3, f1, out=t3)
        np.expm1(t3, t3)
        np.multiply(t1, t3, t3)
        np.subtract(t_m, t3, t3)
        np.maximum(t3, f0, out=t0)
    if some29 != size:
        np.copyto(t0, t, where=~m0)
    np.less_equal(t0, C0, m0)
    some51 = np.count_nonzero(m0)
    if some51:
        np.copyto(out, C0)
    if some51 != size:
        other51 = t3 if some51 else out
        np.multiply(v, t0, other51)
        np.square(b, t1)
        np.square(t1, t2)
        np.square(R, t4)
        np.multiply(C4, t4, t4)
        np.square(other51, other51)
        np.multiply(t4, other51, other51)
        np.add(t2, other51, other51)
        np.sqrt(other51, other51)
        np.divide(other51, R, other51)
        np.divide(t1, R, t1)
        np.add(other51, t1, t1)
        np.sqrt(t1, t1)
        np.multiply(C3, R, other51)
        np.sqrt(other51, other51)
        np.multiply(t1, other51, other51)
        np.multiply(other51, C5, other51)
        if some51:
            np.copyto(out, other51, where=~m0)


def retract_radius_standard_solid(t, v, v_2, t_m, t_h, R, b, E_inf, E_1, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is R.__class__ is b.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._retract_radius_standard_solid(t, v, v_2, t_m, t_h, R, b, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and t > t_h)) and ordinary(t, v, v_2, t_m, t_h, R, b, E_inf, E_1, tau):
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
    ('_contact_time_kelvin_voigt', 0, 'v', 'v_2', 't_m', 't_h', 'E', 'eta'): {
        ('v', 'v_2', 't_m', 't_h', 'E', 'eta'): (('v', 'v_2', 't_m', 't_h', 'E', 'eta'), prepare_contact_time_kelvin_voigt_all_signed, block_contact_time_kelvin_voigt_all_signed, 1, 0, (0.0,), False),
    },
    ('_contact_time_maxwell', 0, 'v', 'v_2', 't_m', 't_h', 'E', 'tau'): {
        ('v', 'v_2', 't_m', 't_h', 'E', 'tau'): (('v', 'v_2', 't_m', 't_h', 'E', 'tau'), prepare_contact_time_maxwell_all_signed, block_contact_time_maxwell_all_signed, 2, 0, (), False),
    },
    ('_earlier_time_kelvin_voigt', 1, 't', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'): {
        ('t',): (('t',), prepare_earlier_time_kelvin_voigt_t, block_earlier_time_kelvin_voigt_t, 0, 2, (0.0,), False),
        ('t', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'): (('t', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'), prepare_earlier_time_kelvin_voigt_all, block_earlier_time_kelvin_voigt_all, 2, 2, (0.0,), False),
    },
    ('_earlier_time_maxwell', 1, 't', 'v', 'v_2', 't_m', 't_h', 'E', 'tau'): {
        ('t',): (('t',), prepare_earlier_time_maxwell_t, block_earlier_time_maxwell_t, 1, 2, (0.0, 700.0, 0.9999999999999998), False),
        ('t', 'v', 'v_2', 't_m', 't_h', 'E', 'tau'): (('t', 'v', 'v_2', 't_m', 't_h', 'E', 'tau'), prepare_earlier_time_maxwell_all, block_earlier_time_maxwell_all, 2, 2, (0.0, 700.0, 0.9999999999999998), False),
    },
    ('_earlier_time_power_creep', 1, 't', 'v', 'v_2', 't_m', 't_h', 'E', 'alpha', 't_0'): {
        ('t',): (('t',), prepare_earlier_time_power_creep_t, block_earlier_time_power_creep_t, 1, 2, (0.0, 700.0), False),
        ('t', 'v', 'v_2', 't_m', 't_h', 'E', 'alpha', 't_0'): (('t', 'v', 'v_2', 't_m', 't_h', 'E', 'alpha', 't_0'), prepare_earlier_time_power_creep_all, block_earlier_time_power_creep_all, 3, 2, (0.0, 700.0), False),
    },
    ('_retract_radius_kelvin_voigt', 1, 't', 'R', 'b', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'): {
        ('t',): (('t',), prepare_retract_radius_kelvin_voigt_t, block_retract_radius_kelvin_voigt_t, 2, 2, (0.0,), False),
        ('t', 'R', 'b', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'): (('t', 'R', 'b', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'), prepare_retract_radius_kelvin_voigt_all, block_retract_radius_kelvin_voigt_all, 5, 2, (0.0,), False),
    },
    ('_retract_radius_maxwell', 1, 't', 'R', 'b', 'v', 'v_2', 't_m', 't_h', 'E', 'tau'): {
        ('t',): (('t',), prepare_retract_radius_maxwell_t, block_retract_radius_maxwell_t, 2, 2, (0.0, 700.0, 0.9999999999999998), False),
        ('t', 'R', 'b', 'v', 'v_2', 't_m', 't_h', 'E', 'tau'): (('t', 'R', 'b', 'v', 'v_2', 't_m', 't_h', 'E', 'tau'), prepare_retract_radius_maxwell_all, block_retract_radius_maxwell_all, 5, 2, (0.0, 700.0, 0.9999999999999998), False),
    },
    ('_retract_radius_power_creep', 1, 't', 'R', 'b', 'v', 'v_2', 't_m', 't_h', 'E', 'alpha', 't_0'): {
        ('t',): (('t',), prepare_retract_radius_power_creep_t, block_retract_radius_power_creep_t, 2, 2, (0.0, 700.0), False),
        ('t', 'R', 'b', 'v', 'v_2', 't_m', 't_h', 'E', 'alpha', 't_0'): (('t', 'R', 'b', 'v', 'v_2', 't_m', 't_h', 'E', 'alpha', 't_0'), prepare_retract_radius_power_creep_all, block_retract_radius_power_creep_all, 5, 2, (0.0, 700.0), False),
    },
}
