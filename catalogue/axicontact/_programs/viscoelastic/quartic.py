"""Programs of axicontact.viscoelastic.quartic."""

from __future__ import annotations

from math import exp, expm1, inf, log1p, pow, sin, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._programs.bodies.viscoelastic import quartic as bodies

C0 = np.array(0.0)
C1 = np.array(1.0)
C2 = np.array(np.inf)
C3 = np.array(0.8)
C4 = np.array(6.0)
C5 = np.array(1.25)
C6 = np.array(3.0)
C7 = np.array(8.0)
C8 = np.array(3.141592653589793)
C9 = np.array(15.0)
C10 = np.array(0.2)
C11 = np.array(5.0)
C12 = np.array(64.0)


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


def ramp_force_kelvin_voigt(t, v, A, E, eta):
    if t.__class__ is v.__class__ is A.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            if t == 0.0:
                return 0.0
            v5 = v * t
            return 0.8 * v5 * sqrt(sqrt(6.0 * v5 / A)) * (E + eta * 1.25 / t)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_ramp_force_kelvin_voigt_t(A, v, E, eta):
    v15 = eta * (1.25)
    return (v, A, E, v15)


def block_ramp_force_kelvin_voigt_t(out, t, v, A, E, v15, t0, t1, m0):
    size = out.size
    np.equal(t, C0, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some21 = np.count_nonzero(m0)
    if some21:
        np.copyto(out, C0)
    if some21 != size:
        other21 = t0 if some21 else out
        np.multiply(v, t, other21)
        np.multiply(C3, other21, t1)
        np.multiply(C4, other21, other21)
        np.divide(other21, A, other21)
        np.sqrt(other21, other21)
        np.sqrt(other21, other21)
        np.multiply(t1, other21, other21)
        np.divide(v15, t, t1)
        np.add(E, t1, t1)
        np.multiply(other21, t1, other21)
        if some21:
            np.copyto(out, other21, where=~m0)


def prepare_ramp_force_kelvin_voigt_all():
    return ()


def block_ramp_force_kelvin_voigt_all(out, t, A, v, E, eta, t0, t1, m0):
    size = out.size
    np.equal(t, C0, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some21 = np.count_nonzero(m0)
    if some21:
        np.copyto(out, C0)
    if some21 != size:
        other21 = t0 if some21 else out
        np.multiply(v, t, other21)
        np.multiply(C3, other21, t1)
        np.multiply(C4, other21, other21)
        np.divide(other21, A, other21)
        np.sqrt(other21, other21)
        np.sqrt(other21, other21)
        np.multiply(t1, other21, other21)
        np.multiply(eta, C5, t1)
        np.divide(t1, t, t1)
        np.add(E, t1, t1)
        np.multiply(other21, t1, other21)
        if some21:
            np.copyto(out, other21, where=~m0)


def ramp_force_maxwell(t, v, A, E, tau):
    if t.__class__ is v.__class__ is A.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._ramp_force_maxwell(t, v, A, E, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, A, E, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def ramp_force_power_creep(t, v, A, E, alpha, t_0):
    if t.__class__ is v.__class__ is A.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            value = bodies._ramp_force_power_creep(t, v, A, E, alpha, t_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, A, E, alpha, t_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def ramp_force_standard_solid(t, v, A, E_inf, E_1, tau):
    if t.__class__ is v.__class__ is A.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._ramp_force_standard_solid(t, v, A, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, A, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_force_kelvin_voigt(t, v, v_2, t_m, t_h, A, E, eta):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is A.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            v16 = t > t_m
            if v16:
                if v16:
                    v17 = t_m - (v_2 / v * (t - t_h + eta / E) if t > t_h else 0.0)
                    v19 = v17 if v17 > 0.0 or v17 != v17 else 0.0
                else:
                    v19 = t
                if v16 and v19 > 0.0:
                    v27 = v * v19
                    value = 0.8 * v27 * sqrt(sqrt(6.0 * v27 / A)) * (E + 0.0 * v19)
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    return None
                return 0.0
            if t == 0.0:
                return 0.0
            v38 = v * t
            return 0.8 * v38 * sqrt(sqrt(6.0 * v38 / A)) * (E + eta * 1.25 / t)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_retract_force_kelvin_voigt_t(A, v, v_2, t_m, t_h, E, eta):
    v8 = v_2 / v
    v11 = eta / E
    v43 = eta * (1.25)
    return (v, t_m, t_h, A, E, v8, v11, v43)


def block_retract_force_kelvin_voigt_t(out, t, v, t_m, t_h, A, E, v8, v11, v43, t0, t1, t2, m0, m1, f0):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some49 = np.count_nonzero(m0)
    if some49:
        some19 = np.count_nonzero(m0)
        if some19:
            np.greater(t, t_h, m1)
            some15 = np.count_nonzero(m1)
            if some15:
                np.subtract(t, t_h, t0)
                np.add(t0, v11, t0)
                np.multiply(v8, t0, t0)
            if some15 != size:
                np.copyto(t0, C0, where=~m1)
            np.subtract(t_m, t0, t0)
            np.maximum(t0, f0, out=t0)
        if some19 != size:
            np.copyto(t0, t, where=~m0)
        np.greater(t0, C0, m1)
        np.bitwise_and(m0, m1, m1)
        some34 = np.count_nonzero(m1)
        if some34:
            np.multiply(C0, t0, out)
            np.add(E, out, out)
            np.multiply(v, t0, t1)
            np.multiply(C3, t1, t2)
            np.multiply(C4, t1, t1)
            np.divide(t1, A, t1)
            np.sqrt(t1, t1)
            np.sqrt(t1, t1)
            np.multiply(t2, t1, t1)
            np.multiply(t1, out, out)
        if some34 != size:
            np.copyto(out, C0, where=~m1)
    if some49 != size:
        other49 = t0 if some49 else out
        np.equal(t, C0, m1)
        some48 = np.count_nonzero(m1)
        if some48:
            np.copyto(other49, C0)
        if some48 != size:
            other48 = t1 if some48 else other49
            np.multiply(v, t, other48)
            np.multiply(C3, other48, t2)
            np.multiply(C4, other48, other48)
            np.divide(other48, A, other48)
            np.sqrt(other48, other48)
            np.sqrt(other48, other48)
            np.multiply(t2, other48, other48)
            np.divide(v43, t, t2)
            np.add(E, t2, t2)
            np.multiply(other48, t2, other48)
            if some48:
                np.copyto(other49, other48, where=~m1)
        if some49:
            np.copyto(out, other49, where=~m0)


def prepare_retract_force_kelvin_voigt_all():
    return ()


def block_retract_force_kelvin_voigt_all(out, t, A, v, v_2, t_m, t_h, E, eta, t0, t1, t2, m0, m1, f0):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some49 = np.count_nonzero(m0)
    if some49:
        some19 = np.count_nonzero(m0)
        if some19:
            np.greater(t, t_h, m1)
            some15 = np.count_nonzero(m1)
            if some15:
                np.divide(v_2, v, t0)
                np.subtract(t, t_h, t1)
                np.divide(eta, E, t2)
                np.add(t1, t2, t2)
                np.multiply(t0, t2, t0)
            if some15 != size:
                np.copyto(t0, C0, where=~m1)
            np.subtract(t_m, t0, t0)
            np.maximum(t0, f0, out=t0)
        if some19 != size:
            np.copyto(t0, t, where=~m0)
        np.greater(t0, C0, m1)
        np.bitwise_and(m0, m1, m1)
        some34 = np.count_nonzero(m1)
        if some34:
            np.multiply(C0, t0, out)
            np.add(E, out, out)
            np.multiply(v, t0, t2)
            np.multiply(C3, t2, t1)
            np.multiply(C4, t2, t2)
            np.divide(t2, A, t2)
            np.sqrt(t2, t2)
            np.sqrt(t2, t2)
            np.multiply(t1, t2, t2)
            np.multiply(t2, out, out)
        if some34 != size:
            np.copyto(out, C0, where=~m1)
    if some49 != size:
        other49 = t0 if some49 else out
        np.equal(t, C0, m1)
        some48 = np.count_nonzero(m1)
        if some48:
            np.copyto(other49, C0)
        if some48 != size:
            other48 = t2 if some48 else other49
            np.multiply(v, t, other48)
            np.multiply(C3, other48, t1)
            np.multiply(C4, other48, other48)
            np.divide(other48, A, other48)
            np.sqrt(other48, other48)
            np.sqrt(other48, other48)
            np.multiply(t1, other48, other48)
            np.multiply(eta, C5, t1)
            np.divide(t1, t, t1)
            np.add(E, t1, t1)
            np.multiply(other48, t1, other48)
            if some48:
                np.copyto(other49, other48, where=~m1)
        if some49:
            np.copyto(out, other49, where=~m0)


def retract_force_maxwell(t, v, v_2, t_m, t_h, A, E, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is A.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._retract_force_maxwell(t, v, v_2, t_m, t_h, A, E, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and t > t_h)) and ordinary(t, v, v_2, t_m, t_h, A, E, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_force_power_creep(t, v, v_2, t_m, t_h, A, E, alpha, t_0):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is A.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            value = bodies._retract_force_power_creep(t, v, v_2, t_m, t_h, A, E, alpha, t_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and t > t_h)) and ordinary(t, v, v_2, t_m, t_h, A, E, alpha, t_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_force_standard_solid(t, v, v_2, t_m, t_h, A, E_inf, E_1, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is A.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._retract_force_standard_solid(t, v, v_2, t_m, t_h, A, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and t > t_h)) and ordinary(t, v, v_2, t_m, t_h, A, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_radius_kelvin_voigt(t, v, v_2, t_m, t_h, A, E, eta):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is A.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            if t > t_m:
                v17 = t_m - (v_2 / v * (t - t_h + eta / E) if t > t_h else 0.0)
                v19 = v17 if v17 > 0.0 or v17 != v17 else 0.0
            else:
                v19 = t
            if v19 <= 0.0:
                return 0.0
            return sqrt(sqrt(3.0 * (v * v19) / (8.0 * A)))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_retract_radius_kelvin_voigt_t(A, v, v_2, t_m, t_h, E, eta):
    v8 = v_2 / v
    v11 = eta / E
    v25 = (8.0) * A
    return (v, t_m, t_h, v8, v11, v25)


def block_retract_radius_kelvin_voigt_t(out, t, v, t_m, t_h, v8, v11, v25, t0, t1, m0, m1, f0):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some19 = np.count_nonzero(m0)
    if some19:
        np.greater(t, t_h, m1)
        some15 = np.count_nonzero(m1)
        if some15:
            np.subtract(t, t_h, t0)
            np.add(t0, v11, t0)
            np.multiply(v8, t0, t0)
        if some15 != size:
            np.copyto(t0, C0, where=~m1)
        np.subtract(t_m, t0, t0)
        np.maximum(t0, f0, out=t0)
    if some19 != size:
        np.copyto(t0, t, where=~m0)
    np.less_equal(t0, C0, m0)
    some29 = np.count_nonzero(m0)
    if some29:
        np.copyto(out, C0)
    if some29 != size:
        other29 = t1 if some29 else out
        np.multiply(v, t0, other29)
        np.multiply(C6, other29, other29)
        np.divide(other29, v25, other29)
        np.sqrt(other29, other29)
        np.sqrt(other29, other29)
        if some29:
            np.copyto(out, other29, where=~m0)


def prepare_retract_radius_kelvin_voigt_all():
    return ()


def block_retract_radius_kelvin_voigt_all(out, t, A, v, v_2, t_m, t_h, E, eta, t0, t1, t2, m0, m1, f0):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some19 = np.count_nonzero(m0)
    if some19:
        np.greater(t, t_h, m1)
        some15 = np.count_nonzero(m1)
        if some15:
            np.divide(v_2, v, t0)
            np.subtract(t, t_h, t1)
            np.divide(eta, E, t2)
            np.add(t1, t2, t2)
            np.multiply(t0, t2, t0)
        if some15 != size:
            np.copyto(t0, C0, where=~m1)
        np.subtract(t_m, t0, t0)
        np.maximum(t0, f0, out=t0)
    if some19 != size:
        np.copyto(t0, t, where=~m0)
    np.less_equal(t0, C0, m0)
    some29 = np.count_nonzero(m0)
    if some29:
        np.copyto(out, C0)
    if some29 != size:
        other29 = t2 if some29 else out
        np.multiply(v, t0, other29)
        np.multiply(C6, other29, other29)
        np.multiply(C7, A, t1)
        np.divide(other29, t1, t1)
        np.sqrt(t1, t1)
        np.sqrt(t1, other29)
        if some29:
            np.copyto(out, other29, where=~m0)


def retract_radius_maxwell(t, v, v_2, t_m, t_h, A, E, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is A.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            if t > t_m:
                v9 = t - t_h
                v12 = (v9 if v9 > 0.0 or v9 != v9 else 0.0) / tau
                v18 = (t_h - t_m) / tau
                v21 = v_2 / v * expm1(v12 if v12 < 700.0 or v12 != v12 else 700.0) * exp(v18 if v18 < 700.0 or v18 != v18 else 700.0)
                v33 = t_m - (-tau * log1p(-(v21 if v21 < 0.9999999999999998 or v21 != v21 else 0.9999999999999998)) if v21 < 1.0 else inf)
                v35 = v33 if v33 > 0.0 or v33 != v33 else 0.0
            else:
                v35 = t
            if v35 <= 0.0:
                value = 0.0
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            value = sqrt(sqrt(3.0 * (v * v35) / (8.0 * A)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_retract_radius_maxwell_t(A, v, v_2, t_m, t_h, E, tau):
    v7 = v_2 / v
    v16 = t_h - t_m
    v17 = v16 / tau
    v18 = np.minimum(v17, (700.0))
    v19 = np.exp(v18)
    v23 = np.negative(tau)
    v40 = (8.0) * A
    return (v, t_m, t_h, tau, v7, v19, v23, v40)


def block_retract_radius_maxwell_t(out, t, v, t_m, t_h, tau, v7, v19, v23, v40, t0, t1, m0, m1, f0, f1, f2):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some34 = np.count_nonzero(m0)
    if some34:
        np.subtract(t, t_h, t0)
        np.maximum(t0, f0, out=t0)
        np.divide(t0, tau, t0)
        np.minimum(t0, f1, out=t0)
        np.expm1(t0, t0)
        np.multiply(v7, t0, t0)
        np.multiply(t0, v19, t0)
        np.less(t0, C1, m1)
        some30 = np.count_nonzero(m1)
        if some30:
            np.minimum(t0, f2, out=t1)
            np.negative(t1, t1)
            np.log1p(t1, t1)
            np.multiply(v23, t1, t1)
        if some30 != size:
            np.copyto(t1, C2, where=~m1)
        np.subtract(t_m, t1, t1)
        np.maximum(t1, f0, out=t0)
    if some34 != size:
        np.copyto(t0, t, where=~m0)
    np.less_equal(t0, C0, m0)
    some44 = np.count_nonzero(m0)
    if some44:
        np.copyto(out, C0)
    if some44 != size:
        other44 = t1 if some44 else out
        np.multiply(v, t0, other44)
        np.multiply(C6, other44, other44)
        np.divide(other44, v40, other44)
        np.sqrt(other44, other44)
        np.sqrt(other44, other44)
        if some44:
            np.copyto(out, other44, where=~m0)


def prepare_retract_radius_maxwell_all():
    return ()


def block_retract_radius_maxwell_all(out, t, A, v, v_2, t_m, t_h, E, tau, t0, t1, t2, m0, m1, f0, f1, f2):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some34 = np.count_nonzero(m0)
    if some34:
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
        some30 = np.count_nonzero(m1)
        if some30:
            np.negative(tau, t1)
            np.minimum(t0, f2, out=t2)
            np.negative(t2, t2)
            np.log1p(t2, t2)
            np.multiply(t1, t2, t1)
        if some30 != size:
            np.copyto(t1, C2, where=~m1)
        np.subtract(t_m, t1, t1)
        np.maximum(t1, f0, out=t0)
    if some34 != size:
        np.copyto(t0, t, where=~m0)
    np.less_equal(t0, C0, m0)
    some44 = np.count_nonzero(m0)
    if some44:
        np.copyto(out, C0)
    if some44 != size:
        other44 = t1 if some44 else out
        np.multiply(v, t0, other44)
        np.multiply(C6, other44, other44)
        np.multiply(C7, A, t2)
        np.divide(other44, t2, t2)
        np.sqrt(t2, t2)
        np.sqrt(t2, other44)
        if some44:
            np.copyto(out, other44, where=~m0)


def retract_radius_power_creep(t, v, v_2, t_m, t_h, A, E, alpha, t_0):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is A.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            if t > t_m:
                v12 = t - t_m
                v17 = 1.0 - alpha
                v22 = log1p(v_2 / v * pow((t - t_h) / v12 if t > t_h else 0.0, v17)) / v17
                v28 = t_m - (v12 if v12 > 0.0 or v12 != v12 else 0.0) * expm1(v22 if v22 < 700.0 or v22 != v22 else 700.0)
                v30 = v28 if v28 > 0.0 or v28 != v28 else 0.0
            else:
                v30 = t
            if v30 <= 0.0:
                value = 0.0
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            value = sqrt(sqrt(3.0 * (v * v30) / (8.0 * A)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_retract_radius_power_creep_t(A, v, v_2, t_m, t_h, E, alpha, t_0):
    v7 = v_2 / v
    v15 = (1.0) - alpha
    v34 = (8.0) * A
    return (v, t_m, t_h, v7, v15, v34)


def block_retract_radius_power_creep_t(out, t, v, t_m, t_h, v7, v15, v34, t0, t1, m0, m1, f0, f1):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some28 = np.count_nonzero(m0)
    if some28:
        np.greater(t, t_h, m1)
        np.subtract(t, t_m, t0)
        some13 = np.count_nonzero(m1)
        if some13:
            np.subtract(t, t_h, t1)
            np.divide(t1, t0, t1)
        if some13 != size:
            np.copyto(t1, C0, where=~m1)
        np.maximum(t0, f0, out=t0)
        np.power(t1, v15, t1)
        np.multiply(v7, t1, t1)
        np.log1p(t1, t1)
        np.divide(t1, v15, t1)
        np.minimum(t1, f1, out=t1)
        np.expm1(t1, t1)
        np.multiply(t0, t1, t1)
        np.subtract(t_m, t1, t1)
        np.maximum(t1, f0, out=t0)
    if some28 != size:
        np.copyto(t0, t, where=~m0)
    np.less_equal(t0, C0, m0)
    some38 = np.count_nonzero(m0)
    if some38:
        np.copyto(out, C0)
    if some38 != size:
        other38 = t1 if some38 else out
        np.multiply(v, t0, other38)
        np.multiply(C6, other38, other38)
        np.divide(other38, v34, other38)
        np.sqrt(other38, other38)
        np.sqrt(other38, other38)
        if some38:
            np.copyto(out, other38, where=~m0)


def prepare_retract_radius_power_creep_all():
    return ()


def block_retract_radius_power_creep_all(out, t, A, v, v_2, t_m, t_h, E, alpha, t_0, t0, t1, t2, t3, m0, m1, f0, f1):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some28 = np.count_nonzero(m0)
    if some28:
        np.divide(v_2, v, t0)
        np.greater(t, t_h, m1)
        np.subtract(t, t_m, t1)
        some13 = np.count_nonzero(m1)
        if some13:
            np.subtract(t, t_h, t2)
            np.divide(t2, t1, t2)
        if some13 != size:
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
    if some28 != size:
        np.copyto(t0, t, where=~m0)
    np.less_equal(t0, C0, m0)
    some38 = np.count_nonzero(m0)
    if some38:
        np.copyto(out, C0)
    if some38 != size:
        other38 = t3 if some38 else out
        np.multiply(v, t0, other38)
        np.multiply(C6, other38, other38)
        np.multiply(C7, A, t1)
        np.divide(other38, t1, t1)
        np.sqrt(t1, t1)
        np.sqrt(t1, other38)
        if some38:
            np.copyto(out, other38, where=~m0)


def retract_radius_standard_solid(t, v, v_2, t_m, t_h, A, E_inf, E_1, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is A.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._retract_radius_standard_solid(t, v, v_2, t_m, t_h, A, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and t > t_h)) and ordinary(t, v, v_2, t_m, t_h, A, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_force_kelvin_voigt(t, d, A, E, eta):
    if t.__class__ is d.__class__ is A.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            value = (E if t > 0.0 else inf) * (0.8 * d * sqrt(sqrt(6.0 * d / A)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_kelvin_voigt_t(d, A, E, eta):
    v9 = (0.8) * d
    v11 = (6.0) * d
    v12 = v11 / A
    v13 = np.sqrt(v12)
    v14 = np.sqrt(v13)
    v15 = v9 * v14
    return (E, v15)


def block_step_force_kelvin_voigt_t(out, t, E, v15, m0):
    size = out.size
    np.greater(t, C0, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some7 = np.count_nonzero(m0)
    if some7:
        np.copyto(out, E)
    if some7 != size:
        np.copyto(out, C2, where=~m0)
    np.multiply(out, v15, out)


def prepare_step_force_kelvin_voigt_all():
    return ()


def block_step_force_kelvin_voigt_all(out, t, d, A, E, eta, t0, t1, m0):
    size = out.size
    np.greater(t, C0, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some7 = np.count_nonzero(m0)
    if some7:
        np.copyto(out, E)
    if some7 != size:
        np.copyto(out, C2, where=~m0)
    np.multiply(C3, d, t0)
    np.multiply(C4, d, t1)
    np.divide(t1, A, t1)
    np.sqrt(t1, t1)
    np.sqrt(t1, t1)
    np.multiply(t0, t1, t1)
    np.multiply(out, t1, out)


def step_force_maxwell(t, d, A, E, tau):
    if t.__class__ is d.__class__ is A.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = E * exp(-t / tau) * (0.8 * d * sqrt(sqrt(6.0 * d / A)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_maxwell_t(d, A, E, tau):
    v10 = (0.8) * d
    v12 = (6.0) * d
    v13 = v12 / A
    v14 = np.sqrt(v13)
    v15 = np.sqrt(v14)
    v16 = v10 * v15
    return (E, tau, v16)


def block_step_force_maxwell_t(out, t, E, tau, v16):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E, out, out)
    np.multiply(out, v16, out)


def prepare_step_force_maxwell_all():
    return ()


def block_step_force_maxwell_all(out, t, d, A, E, tau, t0, t1):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E, out, out)
    np.multiply(C3, d, t0)
    np.multiply(C4, d, t1)
    np.divide(t1, A, t1)
    np.sqrt(t1, t1)
    np.sqrt(t1, t1)
    np.multiply(t0, t1, t1)
    np.multiply(out, t1, out)


def step_force_power_creep(t, d, A, E, alpha, t_0):
    if t.__class__ is d.__class__ is A.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            v10 = 3.141592653589793 * alpha
            value = E * pow(t_0 / t, alpha) * sin(v10) / v10 * (0.8 * d * sqrt(sqrt(6.0 * d / A)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_power_creep_t(d, A, E, alpha, t_0):
    v10 = (3.141592653589793) * alpha
    v11 = np.sin(v10)
    v15 = (0.8) * d
    v17 = (6.0) * d
    v18 = v17 / A
    v19 = np.sqrt(v18)
    v20 = np.sqrt(v19)
    v21 = v15 * v20
    return (E, alpha, t_0, v10, v11, v21)


def block_step_force_power_creep_t(out, t, E, alpha, t_0, v10, v11, v21):
    np.divide(t_0, t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.power(out, alpha, out)
    np.multiply(E, out, out)
    np.multiply(out, v11, out)
    np.divide(out, v10, out)
    np.multiply(out, v21, out)


def prepare_step_force_power_creep_all():
    return ()


def block_step_force_power_creep_all(out, t, d, A, E, alpha, t_0, t0, t1):
    np.divide(t_0, t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.power(out, alpha, out)
    np.multiply(E, out, out)
    np.multiply(C8, alpha, t0)
    np.sin(t0, t1)
    np.multiply(out, t1, t1)
    np.divide(t1, t0, t0)
    np.multiply(C3, d, t1)
    np.multiply(C4, d, out)
    np.divide(out, A, out)
    np.sqrt(out, out)
    np.sqrt(out, out)
    np.multiply(t1, out, out)
    np.multiply(t0, out, out)


def step_force_standard_solid(t, d, A, E_inf, E_1, tau):
    if t.__class__ is d.__class__ is A.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = (E_inf + E_1 * exp(-t / tau)) * (0.8 * d * sqrt(sqrt(6.0 * d / A)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_standard_solid_t(d, A, E_inf, E_1, tau):
    v12 = (0.8) * d
    v14 = (6.0) * d
    v15 = v14 / A
    v16 = np.sqrt(v15)
    v17 = np.sqrt(v16)
    v18 = v12 * v17
    return (E_inf, E_1, tau, v18)


def block_step_force_standard_solid_t(out, t, E_inf, E_1, tau, v18):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E_1, out, out)
    np.add(E_inf, out, out)
    np.multiply(out, v18, out)


def prepare_step_force_standard_solid_all():
    return ()


def block_step_force_standard_solid_all(out, t, d, A, E_inf, E_1, tau, t0, t1):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E_1, out, out)
    np.add(E_inf, out, out)
    np.multiply(C3, d, t0)
    np.multiply(C4, d, t1)
    np.divide(t1, A, t1)
    np.sqrt(t1, t1)
    np.sqrt(t1, t1)
    np.multiply(t0, t1, t1)
    np.multiply(out, t1, out)


def step_load_radius_kelvin_voigt(t, F, A, E, eta):
    if t.__class__ is F.__class__ is A.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            v16 = 15.0 * (F * (-expm1(-E * t / eta) / E)) / (64.0 * A)
            v18 = pow(v16, 0.2)
            if v16 > 0.0 and v16 < inf:
                value = v18 + v18 * ((v16 / (pow(v18, 5.0) * pow(v18, 0.0)) - 1.0) / 5.0)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            value = v18
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_load_radius_kelvin_voigt_t(F, A, E, eta):
    v5 = np.negative(E)
    v15 = (64.0) * A
    return (F, E, eta, v5, v15)


def block_step_load_radius_kelvin_voigt_t(out, t, F, E, eta, v5, v15, t0, t1, t2, m0, m1):
    size = out.size
    np.multiply(v5, t, t0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(t0, eta, t0)
    np.expm1(t0, t0)
    np.negative(t0, t0)
    np.divide(t0, E, t0)
    np.multiply(F, t0, t0)
    np.multiply(C9, t0, t0)
    np.divide(t0, v15, t0)
    np.power(t0, C10, t1)
    np.greater(t0, C0, m0)
    np.less(t0, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some34 = np.count_nonzero(m1)
    if some34:
        np.power(t1, C11, out)
        np.power(t1, C0, t2)
        np.multiply(out, t2, t2)
        np.divide(t0, t2, t2)
        np.subtract(t2, C1, t2)
        np.divide(t2, C11, t2)
        np.multiply(t1, t2, t2)
        np.add(t1, t2, out)
    if some34 != size:
        np.copyto(out, t1, where=~m1)


def prepare_step_load_radius_kelvin_voigt_all():
    return ()


def block_step_load_radius_kelvin_voigt_all(out, t, F, A, E, eta, t0, t1, t2, m0, m1):
    size = out.size
    np.negative(E, t0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.multiply(t0, t, t0)
    np.divide(t0, eta, t0)
    np.expm1(t0, t0)
    np.negative(t0, t0)
    np.divide(t0, E, t0)
    np.multiply(F, t0, t0)
    np.multiply(C9, t0, t0)
    np.multiply(C12, A, t1)
    np.divide(t0, t1, t1)
    np.power(t1, C10, t0)
    np.greater(t1, C0, m0)
    np.less(t1, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some34 = np.count_nonzero(m1)
    if some34:
        np.power(t0, C11, out)
        np.power(t0, C0, t2)
        np.multiply(out, t2, t2)
        np.divide(t1, t2, t2)
        np.subtract(t2, C1, t2)
        np.divide(t2, C11, t2)
        np.multiply(t0, t2, t2)
        np.add(t0, t2, out)
    if some34 != size:
        np.copyto(out, t0, where=~m1)


def step_load_radius_maxwell(t, F, A, E, tau):
    if t.__class__ is F.__class__ is A.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            v14 = 15.0 * (F * ((1.0 + t / tau) / E)) / (64.0 * A)
            v16 = pow(v14, 0.2)
            if v14 > 0.0 and v14 < inf:
                value = v16 + v16 * ((v14 / (pow(v16, 5.0) * pow(v16, 0.0)) - 1.0) / 5.0)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return v16
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_load_radius_maxwell_t(F, A, E, tau):
    v13 = (64.0) * A
    return (F, E, tau, v13)


def block_step_load_radius_maxwell_t(out, t, F, E, tau, v13, t0, t1, t2, m0, m1):
    size = out.size
    np.divide(t, tau, t0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.add(C1, t0, t0)
    np.divide(t0, E, t0)
    np.multiply(F, t0, t0)
    np.multiply(C9, t0, t0)
    np.divide(t0, v13, t0)
    np.power(t0, C10, t1)
    np.greater(t0, C0, m0)
    np.less(t0, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some31 = np.count_nonzero(m1)
    if some31:
        np.power(t1, C11, out)
        np.power(t1, C0, t2)
        np.multiply(out, t2, t2)
        np.divide(t0, t2, t2)
        np.subtract(t2, C1, t2)
        np.divide(t2, C11, t2)
        np.multiply(t1, t2, t2)
        np.add(t1, t2, out)
    if some31 != size:
        np.copyto(out, t1, where=~m1)


def prepare_step_load_radius_maxwell_all():
    return ()


def block_step_load_radius_maxwell_all(out, t, F, A, E, tau, t0, t1, t2, m0, m1):
    size = out.size
    np.divide(t, tau, t0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.add(C1, t0, t0)
    np.divide(t0, E, t0)
    np.multiply(F, t0, t0)
    np.multiply(C9, t0, t0)
    np.multiply(C12, A, t1)
    np.divide(t0, t1, t1)
    np.power(t1, C10, t0)
    np.greater(t1, C0, m0)
    np.less(t1, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some31 = np.count_nonzero(m1)
    if some31:
        np.power(t0, C11, out)
        np.power(t0, C0, t2)
        np.multiply(out, t2, t2)
        np.divide(t1, t2, t2)
        np.subtract(t2, C1, t2)
        np.divide(t2, C11, t2)
        np.multiply(t0, t2, t2)
        np.add(t0, t2, out)
    if some31 != size:
        np.copyto(out, t0, where=~m1)


def step_load_radius_power_creep(t, F, A, E, alpha, t_0):
    if t.__class__ is F.__class__ is A.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            v14 = 15.0 * (F * (pow(t / t_0, alpha) / E)) / (64.0 * A)
            v16 = pow(v14, 0.2)
            if v14 > 0.0 and v14 < inf:
                value = v16 + v16 * ((v14 / (pow(v16, 5.0) * pow(v16, 0.0)) - 1.0) / 5.0)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            value = v16
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_load_radius_power_creep_t(F, A, E, alpha, t_0):
    v13 = (64.0) * A
    return (F, E, alpha, t_0, v13)


def block_step_load_radius_power_creep_t(out, t, F, E, alpha, t_0, v13, t0, t1, t2, m0, m1):
    size = out.size
    np.divide(t, t_0, t0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.power(t0, alpha, t0)
    np.divide(t0, E, t0)
    np.multiply(F, t0, t0)
    np.multiply(C9, t0, t0)
    np.divide(t0, v13, t0)
    np.power(t0, C10, t1)
    np.greater(t0, C0, m0)
    np.less(t0, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some32 = np.count_nonzero(m1)
    if some32:
        np.power(t1, C11, out)
        np.power(t1, C0, t2)
        np.multiply(out, t2, t2)
        np.divide(t0, t2, t2)
        np.subtract(t2, C1, t2)
        np.divide(t2, C11, t2)
        np.multiply(t1, t2, t2)
        np.add(t1, t2, out)
    if some32 != size:
        np.copyto(out, t1, where=~m1)


def prepare_step_load_radius_power_creep_all():
    return ()


def block_step_load_radius_power_creep_all(out, t, F, A, E, alpha, t_0, t0, t1, t2, m0, m1):
    size = out.size
    np.divide(t, t_0, t0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.power(t0, alpha, t0)
    np.divide(t0, E, t0)
    np.multiply(F, t0, t0)
    np.multiply(C9, t0, t0)
    np.multiply(C12, A, t1)
    np.divide(t0, t1, t1)
    np.power(t1, C10, t0)
    np.greater(t1, C0, m0)
    np.less(t1, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some32 = np.count_nonzero(m1)
    if some32:
        np.power(t0, C11, out)
        np.power(t0, C0, t2)
        np.multiply(out, t2, t2)
        np.divide(t1, t2, t2)
        np.subtract(t2, C1, t2)
        np.divide(t2, C11, t2)
        np.multiply(t0, t2, t2)
        np.add(t0, t2, out)
    if some32 != size:
        np.copyto(out, t0, where=~m1)


def step_load_radius_standard_solid(t, F, A, E_inf, E_1, tau):
    if t.__class__ is F.__class__ is A.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            v6 = E_inf + E_1
            v23 = 15.0 * (F * (1.0 / v6 - E_1 / v6 * expm1(-(t / tau * (E_inf / v6))) / E_inf)) / (64.0 * A)
            v25 = pow(v23, 0.2)
            if v23 > 0.0 and v23 < inf:
                value = v25 + v25 * ((v23 / (pow(v25, 5.0) * pow(v25, 0.0)) - 1.0) / 5.0)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            value = v25
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_load_radius_standard_solid_t(F, A, E_inf, E_1, tau):
    v6 = E_inf + E_1
    v8 = E_inf / v6
    v11 = (1.0) / v6
    v12 = E_1 / v6
    v22 = (64.0) * A
    return (F, E_inf, tau, v8, v11, v12, v22)


def block_step_load_radius_standard_solid_t(out, t, F, E_inf, tau, v8, v11, v12, v22, t0, t1, t2, m0, m1):
    size = out.size
    np.divide(t, tau, t0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.multiply(t0, v8, t0)
    np.negative(t0, t0)
    np.expm1(t0, t0)
    np.multiply(v12, t0, t0)
    np.divide(t0, E_inf, t0)
    np.subtract(v11, t0, t0)
    np.multiply(F, t0, t0)
    np.multiply(C9, t0, t0)
    np.divide(t0, v22, t0)
    np.power(t0, C10, t1)
    np.greater(t0, C0, m0)
    np.less(t0, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some40 = np.count_nonzero(m1)
    if some40:
        np.power(t1, C11, out)
        np.power(t1, C0, t2)
        np.multiply(out, t2, t2)
        np.divide(t0, t2, t2)
        np.subtract(t2, C1, t2)
        np.divide(t2, C11, t2)
        np.multiply(t1, t2, t2)
        np.add(t1, t2, out)
    if some40 != size:
        np.copyto(out, t1, where=~m1)


def prepare_step_load_radius_standard_solid_all():
    return ()


def block_step_load_radius_standard_solid_all(out, t, F, A, E_inf, E_1, tau, t0, t1, t2, m0, m1):
    size = out.size
    np.add(E_inf, E_1, t0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(t, tau, t1)
    np.divide(E_inf, t0, t2)
    np.multiply(t1, t2, t2)
    np.divide(C1, t0, t1)
    np.divide(E_1, t0, t0)
    np.negative(t2, t2)
    np.expm1(t2, t2)
    np.multiply(t0, t2, t2)
    np.divide(t2, E_inf, t2)
    np.subtract(t1, t2, t2)
    np.multiply(F, t2, t2)
    np.multiply(C9, t2, t2)
    np.multiply(C12, A, t1)
    np.divide(t2, t1, t1)
    np.power(t1, C10, t2)
    np.greater(t1, C0, m0)
    np.less(t1, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some40 = np.count_nonzero(m1)
    if some40:
        np.power(t2, C11, out)
        np.power(t2, C0, t0)
        np.multiply(out, t0, t0)
        np.divide(t1, t0, t0)
        np.subtract(t0, C1, t0)
        np.divide(t0, C11, t0)
        np.multiply(t2, t0, t0)
        np.add(t2, t0, out)
    if some40 != size:
        np.copyto(out, t2, where=~m1)


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
    ('_ramp_force_kelvin_voigt', 1, 't', 'A', 'v', 'E', 'eta'): {
        ('t',): (('t',), prepare_ramp_force_kelvin_voigt_t, block_ramp_force_kelvin_voigt_t, 2, 1, (), False),
        ('t', 'A', 'v', 'E', 'eta'): (('t', 'A', 'v', 'E', 'eta'), prepare_ramp_force_kelvin_voigt_all, block_ramp_force_kelvin_voigt_all, 2, 1, (), False),
    },
    ('_retract_force_kelvin_voigt', 1, 't', 'A', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'): {
        ('t',): (('t',), prepare_retract_force_kelvin_voigt_t, block_retract_force_kelvin_voigt_t, 3, 2, (0.0,), False),
        ('t', 'A', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'): (('t', 'A', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'), prepare_retract_force_kelvin_voigt_all, block_retract_force_kelvin_voigt_all, 3, 2, (0.0,), False),
    },
    ('_retract_radius_kelvin_voigt', 1, 't', 'A', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'): {
        ('t',): (('t',), prepare_retract_radius_kelvin_voigt_t, block_retract_radius_kelvin_voigt_t, 2, 2, (0.0,), False),
        ('t', 'A', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'): (('t', 'A', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'), prepare_retract_radius_kelvin_voigt_all, block_retract_radius_kelvin_voigt_all, 3, 2, (0.0,), False),
    },
    ('_retract_radius_maxwell', 1, 't', 'A', 'v', 'v_2', 't_m', 't_h', 'E', 'tau'): {
        ('t',): (('t',), prepare_retract_radius_maxwell_t, block_retract_radius_maxwell_t, 2, 2, (0.0, 700.0, 0.9999999999999998), False),
        ('t', 'A', 'v', 'v_2', 't_m', 't_h', 'E', 'tau'): (('t', 'A', 'v', 'v_2', 't_m', 't_h', 'E', 'tau'), prepare_retract_radius_maxwell_all, block_retract_radius_maxwell_all, 3, 2, (0.0, 700.0, 0.9999999999999998), False),
    },
    ('_retract_radius_power_creep', 1, 't', 'A', 'v', 'v_2', 't_m', 't_h', 'E', 'alpha', 't_0'): {
        ('t',): (('t',), prepare_retract_radius_power_creep_t, block_retract_radius_power_creep_t, 2, 2, (0.0, 700.0), False),
        ('t', 'A', 'v', 'v_2', 't_m', 't_h', 'E', 'alpha', 't_0'): (('t', 'A', 'v', 'v_2', 't_m', 't_h', 'E', 'alpha', 't_0'), prepare_retract_radius_power_creep_all, block_retract_radius_power_creep_all, 4, 2, (0.0, 700.0), False),
    },
    ('_step_force_kelvin_voigt', 1, 't', 'd', 'A', 'E', 'eta'): {
        ('t',): (('t',), prepare_step_force_kelvin_voigt_t, block_step_force_kelvin_voigt_t, 0, 1, (), False),
        ('t', 'd', 'A', 'E', 'eta'): (('t', 'd', 'A', 'E', 'eta'), prepare_step_force_kelvin_voigt_all, block_step_force_kelvin_voigt_all, 2, 1, (), False),
    },
    ('_step_force_maxwell', 1, 't', 'd', 'A', 'E', 'tau'): {
        ('t',): (('t',), prepare_step_force_maxwell_t, block_step_force_maxwell_t, 0, 0, (), False),
        ('t', 'd', 'A', 'E', 'tau'): (('t', 'd', 'A', 'E', 'tau'), prepare_step_force_maxwell_all, block_step_force_maxwell_all, 2, 0, (), False),
    },
    ('_step_force_power_creep', 1, 't', 'd', 'A', 'E', 'alpha', 't_0'): {
        ('t',): (('t',), prepare_step_force_power_creep_t, block_step_force_power_creep_t, 0, 0, (), False),
        ('t', 'd', 'A', 'E', 'alpha', 't_0'): (('t', 'd', 'A', 'E', 'alpha', 't_0'), prepare_step_force_power_creep_all, block_step_force_power_creep_all, 2, 0, (), False),
    },
    ('_step_force_standard_solid', 1, 't', 'd', 'A', 'E_inf', 'E_1', 'tau'): {
        ('t',): (('t',), prepare_step_force_standard_solid_t, block_step_force_standard_solid_t, 0, 0, (), False),
        ('t', 'd', 'A', 'E_inf', 'E_1', 'tau'): (('t', 'd', 'A', 'E_inf', 'E_1', 'tau'), prepare_step_force_standard_solid_all, block_step_force_standard_solid_all, 2, 0, (), False),
    },
    ('_step_load_radius_kelvin_voigt', 1, 't', 'F', 'A', 'E', 'eta'): {
        ('t',): (('t',), prepare_step_load_radius_kelvin_voigt_t, block_step_load_radius_kelvin_voigt_t, 3, 2, (), False),
        ('t', 'F', 'A', 'E', 'eta'): (('t', 'F', 'A', 'E', 'eta'), prepare_step_load_radius_kelvin_voigt_all, block_step_load_radius_kelvin_voigt_all, 3, 2, (), False),
    },
    ('_step_load_radius_maxwell', 1, 't', 'F', 'A', 'E', 'tau'): {
        ('t',): (('t',), prepare_step_load_radius_maxwell_t, block_step_load_radius_maxwell_t, 3, 2, (), False),
        ('t', 'F', 'A', 'E', 'tau'): (('t', 'F', 'A', 'E', 'tau'), prepare_step_load_radius_maxwell_all, block_step_load_radius_maxwell_all, 3, 2, (), False),
    },
    ('_step_load_radius_power_creep', 1, 't', 'F', 'A', 'E', 'alpha', 't_0'): {
        ('t',): (('t',), prepare_step_load_radius_power_creep_t, block_step_load_radius_power_creep_t, 3, 2, (), False),
        ('t', 'F', 'A', 'E', 'alpha', 't_0'): (('t', 'F', 'A', 'E', 'alpha', 't_0'), prepare_step_load_radius_power_creep_all, block_step_load_radius_power_creep_all, 3, 2, (), False),
    },
    ('_step_load_radius_standard_solid', 1, 't', 'F', 'A', 'E_inf', 'E_1', 'tau'): {
        ('t',): (('t',), prepare_step_load_radius_standard_solid_t, block_step_load_radius_standard_solid_t, 3, 2, (), False),
        ('t', 'F', 'A', 'E_inf', 'E_1', 'tau'): (('t', 'F', 'A', 'E_inf', 'E_1', 'tau'), prepare_step_load_radius_standard_solid_all, block_step_load_radius_standard_solid_all, 3, 2, (), False),
    },
}
