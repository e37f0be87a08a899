"""Programs of axicontact.viscoelastic.flat_punch."""

from __future__ import annotations

from math import exp, expm1, inf, log1p, pow, sin

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._programs.bodies.viscoelastic import flat_punch as bodies

C0 = np.array(0.0)
C1 = np.array(1.0)
C2 = np.array(np.inf)
C3 = np.array(2.0)
C4 = np.array(3.141592653589793)


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


def ramp_force_kelvin_voigt(t, v, a, E, eta):
    if t.__class__ is v.__class__ is a.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            if t == 0.0:
                return 2.0 * v * a * eta
            return 2.0 * (v * t) * a * (E + eta / t)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_ramp_force_kelvin_voigt_t(a, v, E, eta):
    v14 = (2.0) * v
    v15 = v14 * a
    v16 = v15 * eta
    return (v, a, E, eta, v16)


def block_ramp_force_kelvin_voigt_t(out, t, v, a, E, eta, v16, t0, t1, m0):
    size = out.size
    np.equal(t, C0, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some17 = np.count_nonzero(m0)
    if some17:
        np.copyto(out, v16)
    if some17 != size:
        other17 = t0 if some17 else out
        np.multiply(v, t, other17)
        np.multiply(C3, other17, other17)
        np.multiply(other17, a, other17)
        np.divide(eta, t, t1)
        np.add(E, t1, t1)
        np.multiply(other17, t1, other17)
        if some17:
            np.copyto(out, other17, where=~m0)


def prepare_ramp_force_kelvin_voigt_all():
    return ()


def block_ramp_force_kelvin_voigt_all(out, t, a, v, E, eta, t0, t1, m0):
    size = out.size
    np.equal(t, C0, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some17 = np.count_nonzero(m0)
    if some17:
        np.multiply(C3, v, out)
        np.multiply(out, a, out)
        np.multiply(out, eta, out)
    if some17 != size:
        other17 = t0 if some17 else out
        np.multiply(v, t, other17)
        np.multiply(C3, other17, other17)
        np.multiply(other17, a, other17)
        np.divide(eta, t, t1)
        np.add(E, t1, t1)
        np.multiply(other17, t1, other17)
        if some17:
            np.copyto(out, other17, where=~m0)


def ramp_force_maxwell(t, v, a, E, tau):
    if t.__class__ is v.__class__ is a.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._ramp_force_maxwell(t, v, a, E, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, a, E, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def ramp_force_power_creep(t, v, a, E, alpha, t_0):
    if t.__class__ is v.__class__ is a.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            value = bodies._ramp_force_power_creep(t, v, a, E, alpha, t_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, a, E, alpha, t_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def ramp_force_standard_solid(t, v, a, E_inf, E_1, tau):
    if t.__class__ is v.__class__ is a.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._ramp_force_standard_solid(t, v, a, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, a, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_force_kelvin_voigt(t, v, v_2, t_m, t_h, a, E, eta):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is a.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            v16 = t > t_m
            if v16:
                if v16:
                    v17 = t_m - (v_2 / v * (t - t_h + eta / E) if t > t_h else 0.0)
                    v19 = v17 if v17 > 0.0 or v17 != v17 else 0.0
                else:
                    v19 = t
                if v16 and v19 > 0.0:
                    value = 2.0 * (v * v19) * a * (E + 0.0 * v19)
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    return None
                return 0.0
            if t == 0.0:
                return 2.0 * v * a * eta
            return 2.0 * (v * t) * a * (E + eta / t)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_retract_force_kelvin_voigt_t(a, v, v_2, t_m, t_h, E, eta):
    v8 = v_2 / v
    v11 = eta / E
    v37 = (2.0) * v
    v38 = v37 * a
    v39 = v38 * eta
    return (v, t_m, t_h, a, E, eta, v8, v11, v39)


def block_retract_force_kelvin_voigt_t(out, t, v, t_m, t_h, a, E, eta, v8, v11, v39, t0, t1, t2, m0, m1, f0):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some41 = np.count_nonzero(m0)
    if some41:
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
        some29 = np.count_nonzero(m1)
        if some29:
            np.multiply(C0, t0, out)
            np.add(E, out, out)
            np.multiply(v, t0, t1)
            np.multiply(C3, t1, t1)
            np.multiply(t1, a, t1)
            np.multiply(t1, out, out)
        if some29 != size:
            np.copyto(out, C0, where=~m1)
    if some41 != size:
        other41 = t0 if some41 else out
        np.equal(t, C0, m1)
        some40 = np.count_nonzero(m1)
        if some40:
            np.copyto(other41, v39)
        if some40 != size:
            other40 = t1 if some40 else other41
            np.multiply(v, t, other40)
            np.multiply(C3, other40, other40)
            np.multiply(other40, a, other40)
            np.divide(eta, t, t2)
            np.add(E, t2, t2)
            np.multiply(other40, t2, other40)
            if some40:
                np.copyto(other41, other40, where=~m1)
        if some41:
            np.copyto(out, other41, where=~m0)


def prepare_retract_force_kelvin_voigt_all():
    return ()


def block_retract_force_kelvin_voigt_all(out, t, a, v, v_2, t_m, t_h, E, eta, t0, t1, t2, m0, m1, f0):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some41 = np.count_nonzero(m0)
    if some41:
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
        some29 = np.count_nonzero(m1)
        if some29:
            np.multiply(C0, t0, out)
            np.add(E, out, out)
            np.multiply(v, t0, t2)
            np.multiply(C3, t2, t2)
            np.multiply(t2, a, t2)
            np.multiply(t2, out, out)
        if some29 != size:
            np.copyto(out, C0, where=~m1)
    if some41 != size:
        other41 = t0 if some41 else out
        np.equal(t, C0, m1)
        some40 = np.count_nonzero(m1)
        if some40:
            np.multiply(C3, v, other41)
            np.multiply(other41, a, other41)
            np.multiply(other41, eta, other41)
        if some40 != size:
            other40 = t2 if some40 else other41
            np.multiply(v, t, other40)
            np.multiply(C3, other40, other40)
            np.multiply(other40, a, other40)
            np.divide(eta, t, t1)
            np.add(E, t1, t1)
            np.multiply(other40, t1, other40)
            if some40:
                np.copyto(other41, other40, where=~m1)
        if some41:
            np.copyto(out, other41, where=~m0)


def retract_force_maxwell(t, v, v_2, t_m, t_h, a, E, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is a.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._retract_force_maxwell(t, v, v_2, t_m, t_h, a, E, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and t > t_h)) and ordinary(t, v, v_2, t_m, t_h, a, E, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_force_power_creep(t, v, v_2, t_m, t_h, a, E, alpha, t_0):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is a.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            value = bodies._retract_force_power_creep(t, v, v_2, t_m, t_h, a, E, alpha, t_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and t > t_h)) and ordinary(t, v, v_2, t_m, t_h, a, E, alpha, t_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_force_standard_solid(t, v, v_2, t_m, t_h, a, E_inf, E_1, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is a.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._retract_force_standard_solid(t, v, v_2, t_m, t_h, a, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and t > t_h)) and ordinary(t, v, v_2, t_m, t_h, a, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_force_kelvin_voigt(t, d, a, E, eta):
    if t.__class__ is d.__class__ is a.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            value = (E if t > 0.0 else inf) * (2.0 * d * a)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_kelvin_voigt_t(d, a, E, eta):
    v9 = (2.0) * d
    v10 = v9 * a
    return (E, v10)


def block_step_force_kelvin_voigt_t(out, t, E, v10, m0):
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
    np.multiply(out, v10, out)


def prepare_step_force_kelvin_voigt_all():
    return ()


def block_step_force_kelvin_voigt_all(out, t, d, a, E, eta, t0, m0):
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
    np.multiply(t0, a, t0)
    np.multiply(out, t0, out)


def step_force_maxwell(t, d, a, E, tau):
    if t.__class__ is d.__class__ is a.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = E * exp(-t / tau) * (2.0 * d * a)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_maxwell_t(d, a, E, tau):
    v10 = (2.0) * d
    v11 = v10 * a
    return (E, tau, v11)


def block_step_force_maxwell_t(out, t, E, tau, v11):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E, out, out)
    np.multiply(out, v11, out)


def prepare_step_force_maxwell_all():
    return ()


def block_step_force_maxwell_all(out, t, d, a, E, tau, t0):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E, out, out)
    np.multiply(C3, d, t0)
    np.multiply(t0, a, t0)
    np.multiply(out, t0, out)


def step_force_power_creep(t, d, a, E, alpha, t_0):
    if t.__class__ is d.__class__ is a.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            v10 = 3.141592653589793 * alpha
            value = E * pow(t_0 / t, alpha) * sin(v10) / v10 * (2.0 * d * a)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_power_creep_t(d, a, E, alpha, t_0):
    v10 = (3.141592653589793) * alpha
    v11 = np.sin(v10)
    v15 = (2.0) * d
    v16 = v15 * a
    return (E, alpha, t_0, v10, v11, v16)


def block_step_force_power_creep_t(out, t, E, alpha, t_0, v10, v11, v16):
    np.divide(t_0, t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.power(out, alpha, out)
    np.multiply(E, out, out)
    np.multiply(out, v11, out)
    np.divide(out, v10, out)
    np.multiply(out, v16, out)


def prepare_step_force_power_creep_all():
    return ()


def block_step_force_power_creep_all(out, t, d, a, E, alpha, t_0, t0, t1):
    np.divide(t_0, t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.power(out, alpha, out)
    np.multiply(E, out, out)
    np.multiply(C4, alpha, t0)
    np.sin(t0, t1)
    np.multiply(out, t1, t1)
    np.divide(t1, t0, t0)
    np.multiply(C3, d, t1)
    np.multiply(t1, a, t1)
    np.multiply(t0, t1, out)


def step_force_standard_solid(t, d, a, E_inf, E_1, tau):
    if t.__class__ is d.__class__ is a.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = (E_inf + E_1 * exp(-t / tau)) * (2.0 * d * a)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_standard_solid_t(d, a, E_inf, E_1, tau):
    v12 = (2.0) * d
    v13 = v12 * a
    return (E_inf, E_1, tau, v13)


def block_step_force_standard_solid_t(out, t, E_inf, E_1, tau, v13):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E_1, out, out)
    np.add(E_inf, out, out)
    np.multiply(out, v13, out)


def prepare_step_force_standard_solid_all():
    return ()


def block_step_force_standard_solid_all(out, t, d, a, E_inf, E_1, tau, t0):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E_1, out, out)
    np.add(E_inf, out, out)
    np.multiply(C3, d, t0)
    np.multiply(t0, a, t0)
    np.multiply(out, t0, out)


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
    ('_ramp_force_kelvin_voigt', 1, 't', 'a', 'v', 'E', 'eta'): {
        ('t',): (('t',), prepare_ramp_force_kelvin_voigt_t, block_ramp_force_kelvin_voigt_t, 2, 1, (), False),
        ('t', 'a', 'v', 'E', 'eta'): (('t', 'a', 'v', 'E', 'eta'), prepare_ramp_force_kelvin_voigt_all, block_ramp_force_kelvin_voigt_all, 2, 1, (), False),
    },
    ('_retract_force_kelvin_voigt', 1, 't', 'a', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'): {
        ('t',): (('t',), prepare_retract_force_kelvin_voigt_t, block_retract_force_kelvin_voigt_t, 3, 2, (0.0,), False),
        ('t', 'a', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'): (('t', 'a', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'), prepare_retract_force_kelvin_voigt_all, block_retract_force_kelvin_voigt_all, 3, 2, (0.0,), False),
    },
    ('_step_force_kelvin_voigt', 1, 't', 'd', 'a', 'E', 'eta'): {
        ('t',): (('t',), prepare_step_force_kelvin_voigt_t, block_step_force_kelvin_voigt_t, 0, 1, (), False),
        ('t', 'd', 'a', 'E', 'eta'): (('t', 'd', 'a', 'E', 'eta'), prepare_step_force_kelvin_voigt_all, block_step_force_kelvin_voigt_all, 1, 1, (), False),
    },
    ('_step_force_maxwell', 1, 't', 'd', 'a', 'E', 'tau'): {
        ('t',): (('t',), prepare_step_force_maxwell_t, block_step_force_maxwell_t, 0, 0, (), False),
        ('t', 'd', 'a', 'E', 'tau'): (('t', 'd', 'a', 'E', 'tau'), prepare_step_force_maxwell_all, block_step_force_maxwell_all, 1, 0, (), False),
    },
    ('_step_force_power_creep', 1, 't', 'd', 'a', 'E', 'alpha', 't_0'): {
        ('t',): (('t',), prepare_step_force_power_creep_t, block_step_force_power_creep_t, 0, 0, (), False),
        ('t', 'd', 'a', 'E', 'alpha', 't_0'): (('t', 'd', 'a', 'E', 'alpha', 't_0'), prepare_step_force_power_creep_all, block_step_force_power_creep_all, 2, 0, (), False),
    },
    ('_step_force_standard_solid', 1, 't', 'd', 'a', 'E_inf', 'E_1', 'tau'): {
        ('t',): (('t',), prepare_step_force_standard_solid_t, block_step_force_standard_solid_t, 0, 0, (), False),
        ('t', 'd', 'a', 'E_inf', 'E_1', 'tau'): (('t', 'd', 'a', 'E_inf', 'E_1', 'tau'), prepare_step_force_standard_solid_all, block_step_force_standard_solid_all, 1, 0, (), False),
    },
}
