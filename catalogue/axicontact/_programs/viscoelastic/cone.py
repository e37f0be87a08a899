"""Programs of axicontact.viscoelastic.cone."""

from __future__ import annotations

from math import exp, expm1, inf, log1p, pow, sin, sqrt, tan

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._programs.bodies.viscoelastic import cone as bodies

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


def ramp_force_kelvin_voigt(t, v, theta, E, eta):
    if t.__class__ is v.__class__ is theta.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            if t == 0.0:
                return 0.0
            v5 = v * t
            return 2.0 / (3.141592653589793 * tan(theta)) * (v5 * v5) * (E + eta * 2.0 / t)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_ramp_force_kelvin_voigt_t(theta, v, E, eta):
    v6 = np.tan(theta)
    v8 = (3.141592653589793) * v6
    v10 = (2.0) / v8
    v13 = eta * (2.0)
    return (v, E, v10, v13)


def block_ramp_force_kelvin_voigt_t(out, t, v, E, v10, v13, t0, t1, m0):
    size = out.size
    np.equal(t, C0, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some19 = np.count_nonzero(m0)
    if some19:
        np.copyto(out, C0)
    if some19 != size:
        other19 = t0 if some19 else out
        np.multiply(v, t, other19)
        np.square(other19, other19)
        np.multiply(v10, other19, other19)
        np.divide(v13, t, t1)
        np.add(E, t1, t1)
        np.multiply(other19, t1, other19)
        if some19:
            np.copyto(out, other19, where=~m0)


def prepare_ramp_force_kelvin_voigt_all():
    return ()


def block_ramp_force_kelvin_voigt_all(out, t, theta, v, E, eta, t0, t1, m0):
    size = out.size
    np.equal(t, C0, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some19 = np.count_nonzero(m0)
    if some19:
        np.copyto(out, C0)
    if some19 != size:
        other19 = t0 if some19 else out
        np.multiply(v, t, other19)
        np.tan(theta, t1)
        np.multiply(C4, t1, t1)
        np.divide(C3, t1, t1)
        np.square(other19, other19)
        np.multiply(t1, other19, other19)
        np.multiply(eta, C3, t1)
        np.divide(t1, t, t1)
        np.add(E, t1, t1)
        np.multiply(other19, t1, other19)
        if some19:
            np.copyto(out, other19, where=~m0)


def ramp_force_maxwell(t, v, theta, E, tau):
    if t.__class__ is v.__class__ is theta.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._ramp_force_maxwell(t, v, theta, E, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, theta, E, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def ramp_force_power_creep(t, v, theta, E, alpha, t_0):
    if t.__class__ is v.__class__ is theta.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            value = bodies._ramp_force_power_creep(t, v, theta, E, alpha, t_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, theta, E, alpha, t_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def ramp_force_standard_solid(t, v, theta, E_inf, E_1, tau):
    if t.__class__ is v.__class__ is theta.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._ramp_force_standard_solid(t, v, theta, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, theta, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_force_kelvin_voigt(t, v, v_2, t_m, t_h, theta, E, eta):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is theta.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            v16 = t > t_m
            v32 = 2.0 / (3.141592653589793 * tan(theta))
            if v16:
                if v16:
                    v17 = t_m - (v_2 / v * (t - t_h + eta / E) if t > t_h else 0.0)
                    v19 = v17 if v17 > 0.0 or v17 != v17 else 0.0
                else:
                    v19 = t
                if v16 and v19 > 0.0:
                    v27 = v * v19
                    value = v32 * (v27 * v27) * (E + 0.0 * v19)
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    return None
                return 0.0
            if t == 0.0:
                return 0.0
            v37 = v * t
            return v32 * (v37 * v37) * (E + eta * 2.0 / t)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_retract_force_kelvin_voigt_t(theta, v, v_2, t_m, t_h, E, eta):
    v8 = v_2 / v
    v11 = eta / E
    v25 = np.tan(theta)
    v27 = (3.141592653589793) * v25
    v29 = (2.0) / v27
    v37 = eta * (2.0)
    return (v, t_m, t_h, E, v8, v11, v29, v37)


def block_retract_force_kelvin_voigt_t(out, t, v, t_m, t_h, E, v8, v11, v29, v37, t0, t1, t2, m0, m1, f0):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some43 = np.count_nonzero(m0)
    if some43:
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
        some33 = np.count_nonzero(m1)
        if some33:
            np.multiply(C0, t0, out)
            np.add(E, out, out)
            np.multiply(v, t0, t1)
            np.square(t1, t1)
            np.multiply(v29, t1, t1)
            np.multiply(t1, out, out)
        if some33 != size:
            np.copyto(out, C0, where=~m1)
    if some43 != size:
        other43 = t0 if some43 else out
        np.equal(t, C0, m1)
        some42 = np.count_nonzero(m1)
        if some42:
            np.copyto(other43, C0)
        if some42 != size:
            other42 = t1 if some42 else other43
            np.multiply(v, t, other42)
            np.square(other42, other42)
            np.multiply(v29, other42, other42)
            np.divide(v37, t, t2)
            np.add(E, t2, t2)
            np.multiply(other42, t2, other42)
            if some42:
                np.copyto(other43, other42, where=~m1)
        if some43:
            np.copyto(out, other43, where=~m0)


def prepare_retract_force_kelvin_voigt_all():
    return ()


def block_retract_force_kelvin_voigt_all(out, t, theta, v, v_2, t_m, t_h, E, eta, t0, t1, t2, t3, m0, m1, f0):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.tan(theta, t0)
    np.multiply(C4, t0, t0)
    np.divide(C3, t0, t0)
    some43 = np.count_nonzero(m0)
    if some43:
        some19 = np.count_nonzero(m0)
        if some19:
            np.greater(t, t_h, m1)
            some15 = np.count_nonzero(m1)
            if some15:
                np.divide(v_2, v, t1)
                np.subtract(t, t_h, t2)
                np.divide(eta, E, t3)
                np.add(t2, t3, t3)
                np.multiply(t1, t3, t1)
            if some15 != size:
                np.copyto(t1, C0, where=~m1)
            np.subtract(t_m, t1, t1)
            np.maximum(t1, f0, out=t1)
        if some19 != size:
            np.copyto(t1, t, where=~m0)
        np.greater(t1, C0, m1)
        np.bitwise_and(m0, m1, m1)
        some33 = np.count_nonzero(m1)
        if some33:
            np.multiply(C0, t1, out)
            np.add(E, out, out)
            np.multiply(v, t1, t3)
            np.square(t3, t3)
            np.multiply(t0, t3, t3)
            np.multiply(t3, out, out)
        if some33 != size:
            np.copyto(out, C0, where=~m1)
    if some43 != size:
        other43 = t1 if some43 else out
        np.equal(t, C0, m1)
        some42 = np.count_nonzero(m1)
        if some42:
            np.copyto(other43, C0)
        if some42 != size:
            other42 = t3 if some42 else other43
            np.multiply(v, t, other42)
            np.square(other42, other42)
            np.multiply(t0, other42, other42)
            np.multiply(eta, C3, t2)
            np.divide(t2, t, t2)
            np.add(E, t2, t2)
            np.multiply(other42, t2, other42)
            if some42:
                np.copyto(other43, other42, where=~m1)
        if some43:
            np.copyto(out, other43, where=~m0)


def retract_force_maxwell(t, v, v_2, t_m, t_h, theta, E, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is theta.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._retract_force_maxwell(t, v, v_2, t_m, t_h, theta, E, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and t > t_h)) and ordinary(t, v, v_2, t_m, t_h, theta, E, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_force_power_creep(t, v, v_2, t_m, t_h, theta, E, alpha, t_0):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is theta.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            value = bodies._retract_force_power_creep(t, v, v_2, t_m, t_h, theta, E, alpha, t_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and t > t_h)) and ordinary(t, v, v_2, t_m, t_h, theta, E, alpha, t_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_force_standard_solid(t, v, v_2, t_m, t_h, theta, E_inf, E_1, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is theta.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._retract_force_standard_solid(t, v, v_2, t_m, t_h, theta, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and t > t_h)) and ordinary(t, v, v_2, t_m, t_h, theta, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_radius_kelvin_voigt(t, v, v_2, t_m, t_h, theta, E, eta):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is theta.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            if t > t_m:
                v17 = t_m - (v_2 / v * (t - t_h + eta / E) if t > t_h else 0.0)
                v19 = v17 if v17 > 0.0 or v17 != v17 else 0.0
            else:
                v19 = t
            if v19 <= 0.0:
                return 0.0
            return 2.0 * (v * v19) / (3.141592653589793 * tan(theta))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_retract_radius_kelvin_voigt_t(theta, v, v_2, t_m, t_h, E, eta):
    v8 = v_2 / v
    v11 = eta / E
    v24 = np.tan(theta)
    v26 = (3.141592653589793) * v24
    return (v, t_m, t_h, v8, v11, v26)


def block_retract_radius_kelvin_voigt_t(out, t, v, t_m, t_h, v8, v11, v26, t0, t1, m0, m1, f0):
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
    some28 = np.count_nonzero(m0)
    if some28:
        np.copyto(out, C0)
    if some28 != size:
        other28 = t1 if some28 else out
        np.multiply(v, t0, other28)
        np.multiply(C3, other28, other28)
        np.divide(other28, v26, other28)
        if some28:
            np.copyto(out, other28, where=~m0)


def prepare_retract_radius_kelvin_voigt_all():
    return ()


def block_retract_radius_kelvin_voigt_all(out, t, theta, v, v_2, t_m, t_h, E, eta, t0, t1, t2, m0, m1, f0):
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
    some28 = np.count_nonzero(m0)
    if some28:
        np.copyto(out, C0)
    if some28 != size:
        other28 = t2 if some28 else out
        np.multiply(v, t0, other28)
        np.multiply(C3, other28, other28)
        np.tan(theta, t1)
        np.multiply(C4, t1, t1)
        np.divide(other28, t1, other28)
        if some28:
            np.copyto(out, other28, where=~m0)


def retract_radius_maxwell(t, v, v_2, t_m, t_h, theta, E, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is theta.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
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
            value = 2.0 * (v * v35) / (3.141592653589793 * tan(theta))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_retract_radius_maxwell_t(theta, v, v_2, t_m, t_h, E, tau):
    v7 = v_2 / v
    v16 = t_h - t_m
    v17 = v16 / tau
    v18 = np.minimum(v17, (700.0))
    v19 = np.exp(v18)
    v23 = np.negative(tau)
    v39 = np.tan(theta)
    v41 = (3.141592653589793) * v39
    return (v, t_m, t_h, tau, v7, v19, v23, v41)


def block_retract_radius_maxwell_t(out, t, v, t_m, t_h, tau, v7, v19, v23, v41, t0, t1, m0, m1, f0, f1, f2):
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
    some43 = np.count_nonzero(m0)
    if some43:
        np.copyto(out, C0)
    if some43 != size:
        other43 = t1 if some43 else out
        np.multiply(v, t0, other43)
        np.multiply(C3, other43, other43)
        np.divide(other43, v41, other43)
        if some43:
            np.copyto(out, other43, where=~m0)


def prepare_retract_radius_maxwell_all():
    return ()


def block_retract_radius_maxwell_all(out, t, theta, v, v_2, t_m, t_h, E, tau, t0, t1, t2, m0, m1, f0, f1, f2):
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
    some43 = np.count_nonzero(m0)
    if some43:
        np.copyto(out, C0)
    if some43 != size:
        other43 = t1 if some43 else out
        np.multiply(v, t0, other43)
        np.multiply(C3, other43, other43)
        np.tan(theta, t2)
        np.multiply(C4, t2, t2)
        np.divide(other43, t2, other43)
        if some43:
            np.copyto(out, other43, where=~m0)


def retract_radius_power_creep(t, v, v_2, t_m, t_h, theta, E, alpha, t_0):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is theta.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
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
            value = 2.0 * (v * v30) / (3.141592653589793 * tan(theta))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_retract_radius_power_creep_t(theta, v, v_2, t_m, t_h, E, alpha, t_0):
    v7 = v_2 / v
    v15 = (1.0) - alpha
    v33 = np.tan(theta)
    v35 = (3.141592653589793) * v33
    return (v, t_m, t_h, v7, v15, v35)


def block_retract_radius_power_creep_t(out, t, v, t_m, t_h, v7, v15, v35, t0, t1, m0, m1, f0, f1):
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
    some37 = np.count_nonzero(m0)
    if some37:
        np.copyto(out, C0)
    if some37 != size:
        other37 = t1 if some37 else out
        np.multiply(v, t0, other37)
        np.multiply(C3, other37, other37)
        np.divide(other37, v35, other37)
        if some37:
            np.copyto(out, other37, where=~m0)


def prepare_retract_radius_power_creep_all():
    return ()


def block_retract_radius_power_creep_all(out, t, theta, v, v_2, t_m, t_h, E, alpha, t_0, t0, t1, t2, t3, m0, m1, f0, f1):
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
    some37 = np.count_nonzero(m0)
    if some37:
        np.copyto(out, C0)
    if some37 != size:
        other37 = t3 if some37 else out
        np.multiply(v, t0, other37)
        np.multiply(C3, other37, other37)
        np.tan(theta, t1)
        np.multiply(C4, t1, t1)
        np.divide(other37, t1, other37)
        if some37:
            np.copyto(out, other37, where=~m0)


def retract_radius_standard_solid(t, v, v_2, t_m, t_h, theta, E_inf, E_1, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is theta.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._retract_radius_standard_solid(t, v, v_2, t_m, t_h, theta, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and t > t_h)) and ordinary(t, v, v_2, t_m, t_h, theta, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_force_kelvin_voigt(t, d, theta, E, eta):
    if t.__class__ is d.__class__ is theta.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            value = (E if t > 0.0 else inf) * (2.0 / (3.141592653589793 * tan(theta)) * (d * d))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_kelvin_voigt_t(d, theta, E, eta):
    v8 = np.tan(theta)
    v10 = (3.141592653589793) * v8
    v12 = (2.0) / v10
    v13 = np.square(d)
    v14 = v12 * v13
    return (E, v14)


def block_step_force_kelvin_voigt_t(out, t, E, v14, m0):
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
    np.multiply(out, v14, out)


def prepare_step_force_kelvin_voigt_all():
    return ()


def block_step_force_kelvin_voigt_all(out, t, d, theta, E, eta, t0, t1, m0):
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
    np.tan(theta, t0)
    np.multiply(C4, t0, t0)
    np.divide(C3, t0, t0)
    np.square(d, t1)
    np.multiply(t0, t1, t1)
    np.multiply(out, t1, out)


def step_force_maxwell(t, d, theta, E, tau):
    if t.__class__ is d.__class__ is theta.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = E * exp(-t / tau) * (2.0 / (3.141592653589793 * tan(theta)) * (d * d))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_maxwell_t(d, theta, E, tau):
    v9 = np.tan(theta)
    v11 = (3.141592653589793) * v9
    v13 = (2.0) / v11
    v14 = np.square(d)
    v15 = v13 * v14
    return (E, tau, v15)


def block_step_force_maxwell_t(out, t, E, tau, v15):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E, out, out)
    np.multiply(out, v15, out)


def prepare_step_force_maxwell_all():
    return ()


def block_step_force_maxwell_all(out, t, d, theta, E, tau, t0, t1):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E, out, out)
    np.tan(theta, t0)
    np.multiply(C4, t0, t0)
    np.divide(C3, t0, t0)
    np.square(d, t1)
    np.multiply(t0, t1, t1)
    np.multiply(out, t1, out)


def step_force_power_creep(t, d, theta, E, alpha, t_0):
    if t.__class__ is d.__class__ is theta.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            v10 = 3.141592653589793 * alpha
            value = E * pow(t_0 / t, alpha) * sin(v10) / v10 * (2.0 / (3.141592653589793 * tan(theta)) * (d * d))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_power_creep_t(d, theta, E, alpha, t_0):
    v10 = (3.141592653589793) * alpha
    v11 = np.sin(v10)
    v14 = np.tan(theta)
    v15 = (3.141592653589793) * v14
    v17 = (2.0) / v15
    v18 = np.square(d)
    v19 = v17 * v18
    return (E, alpha, t_0, v10, v11, v19)


def block_step_force_power_creep_t(out, t, E, alpha, t_0, v10, v11, v19):
    np.divide(t_0, t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.power(out, alpha, out)
    np.multiply(E, out, out)
    np.multiply(out, v11, out)
    np.divide(out, v10, out)
    np.multiply(out, v19, out)


def prepare_step_force_power_creep_all():
    return ()


def block_step_force_power_creep_all(out, t, d, theta, E, alpha, t_0, t0, t1):
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
    np.tan(theta, t1)
    np.multiply(C4, t1, t1)
    np.divide(C3, t1, t1)
    np.square(d, out)
    np.multiply(t1, out, out)
    np.multiply(t0, out, out)


def step_force_standard_solid(t, d, theta, E_inf, E_1, tau):
    if t.__class__ is d.__class__ is theta.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = (E_inf + E_1 * exp(-t / tau)) * (2.0 / (3.141592653589793 * tan(theta)) * (d * d))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_standard_solid_t(d, theta, E_inf, E_1, tau):
    v11 = np.tan(theta)
    v13 = (3.141592653589793) * v11
    v15 = (2.0) / v13
    v16 = np.square(d)
    v17 = v15 * v16
    return (E_inf, E_1, tau, v17)


def block_step_force_standard_solid_t(out, t, E_inf, E_1, tau, v17):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E_1, out, out)
    np.add(E_inf, out, out)
    np.multiply(out, v17, out)


def prepare_step_force_standard_solid_all():
    return ()


def block_step_force_standard_solid_all(out, t, d, theta, E_inf, E_1, tau, t0, t1):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E_1, out, out)
    np.add(E_inf, out, out)
    np.tan(theta, t0)
    np.multiply(C4, t0, t0)
    np.divide(C3, t0, t0)
    np.square(d, t1)
    np.multiply(t0, t1, t1)
    np.multiply(out, t1, out)


def step_load_radius_kelvin_voigt(t, F, theta, E, eta):
    if t.__class__ is F.__class__ is theta.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            value = sqrt(2.0 * (F * (-expm1(-E * t / eta) / E)) / (3.141592653589793 * tan(theta)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_load_radius_kelvin_voigt_t(F, theta, E, eta):
    v5 = np.negative(E)
    v14 = np.tan(theta)
    v16 = (3.141592653589793) * v14
    return (F, E, eta, v5, v16)


def block_step_load_radius_kelvin_voigt_t(out, t, F, E, eta, v5, v16):
    np.multiply(v5, t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, eta, out)
    np.expm1(out, out)
    np.negative(out, out)
    np.divide(out, E, out)
    np.multiply(F, out, out)
    np.multiply(C3, out, out)
    np.divide(out, v16, out)
    np.sqrt(out, out)


def prepare_step_load_radius_kelvin_voigt_all():
    return ()


def block_step_load_radius_kelvin_voigt_all(out, t, F, theta, E, eta, t0):
    np.negative(E, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.multiply(out, t, out)
    np.divide(out, eta, out)
    np.expm1(out, out)
    np.negative(out, out)
    np.divide(out, E, out)
    np.multiply(F, out, out)
    np.multiply(C3, out, out)
    np.tan(theta, t0)
    np.multiply(C4, t0, t0)
    np.divide(out, t0, t0)
    np.sqrt(t0, out)


def step_load_radius_maxwell(t, F, theta, E, tau):
    if t.__class__ is F.__class__ is theta.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            return sqrt(2.0 * (F * ((1.0 + t / tau) / E)) / (3.141592653589793 * tan(theta)))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_load_radius_maxwell_t(F, theta, E, tau):
    v12 = np.tan(theta)
    v14 = (3.141592653589793) * v12
    return (F, E, tau, v14)


def block_step_load_radius_maxwell_t(out, t, F, E, tau, v14):
    np.divide(t, tau, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.add(C1, out, out)
    np.divide(out, E, out)
    np.multiply(F, out, out)
    np.multiply(C3, out, out)
    np.divide(out, v14, out)
    np.sqrt(out, out)


def prepare_step_load_radius_maxwell_all():
    return ()


def block_step_load_radius_maxwell_all(out, t, F, theta, E, tau, t0):
    np.divide(t, tau, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.add(C1, out, out)
    np.divide(out, E, out)
    np.multiply(F, out, out)
    np.multiply(C3, out, out)
    np.tan(theta, t0)
    np.multiply(C4, t0, t0)
    np.divide(out, t0, t0)
    np.sqrt(t0, out)


def step_load_radius_power_creep(t, F, theta, E, alpha, t_0):
    if t.__class__ is F.__class__ is theta.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            value = sqrt(2.0 * (F * (pow(t / t_0, alpha) / E)) / (3.141592653589793 * tan(theta)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_load_radius_power_creep_t(F, theta, E, alpha, t_0):
    v12 = np.tan(theta)
    v14 = (3.141592653589793) * v12
    return (F, E, alpha, t_0, v14)


def block_step_load_radius_power_creep_t(out, t, F, E, alpha, t_0, v14):
    np.divide(t, t_0, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.power(out, alpha, out)
    np.divide(out, E, out)
    np.multiply(F, out, out)
    np.multiply(C3, out, out)
    np.divide(out, v14, out)
    np.sqrt(out, out)


def prepare_step_load_radius_power_creep_all():
    return ()


def block_step_load_radius_power_creep_all(out, t, F, theta, E, alpha, t_0, t0):
    np.divide(t, t_0, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.power(out, alpha, out)
    np.divide(out, E, out)
    np.multiply(F, out, out)
    np.multiply(C3, out, out)
    np.tan(theta, t0)
    np.multiply(C4, t0, t0)
    np.divide(out, t0, t0)
    np.sqrt(t0, out)


def step_load_radius_standard_solid(t, F, theta, E_inf, E_1, tau):
    if t.__class__ is F.__class__ is theta.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            v6 = E_inf + E_1
            value = sqrt(2.0 * (F * (1.0 / v6 - E_1 / v6 * expm1(-(t / tau * (E_inf / v6))) / E_inf)) / (3.141592653589793 * tan(theta)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_load_radius_standard_solid_t(F, theta, E_inf, E_1, tau):
    v6 = E_inf + E_1
    v8 = E_inf / v6
    v11 = (1.0) / v6
    v12 = E_1 / v6
    v21 = np.tan(theta)
    v23 = (3.141592653589793) * v21
    return (F, E_inf, tau, v8, v11, v12, v23)


def block_step_load_radius_standard_solid_t(out, t, F, E_inf, tau, v8, v11, v12, v23):
    np.divide(t, tau, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.multiply(out, v8, out)
    np.negative(out, out)
    np.expm1(out, out)
    np.multiply(v12, out, out)
    np.divide(out, E_inf, out)
    np.subtract(v11, out, out)
    np.multiply(F, out, out)
    np.multiply(C3, out, out)
    np.divide(out, v23, out)
    np.sqrt(out, out)


def prepare_step_load_radius_standard_solid_all():
    return ()


def block_step_load_radius_standard_solid_all(out, t, F, theta, E_inf, E_1, tau, t0, t1):
    np.add(E_inf, E_1, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(t, tau, t0)
    np.divide(E_inf, out, t1)
    np.multiply(t0, t1, t1)
    np.divide(C1, out, t0)
    np.divide(E_1, out, out)
    np.negative(t1, t1)
    np.expm1(t1, t1)
    np.multiply(out, t1, t1)
    np.divide(t1, E_inf, t1)
    np.subtract(t0, t1, t1)
    np.multiply(F, t1, t1)
    np.multiply(C3, t1, t1)
    np.tan(theta, t0)
    np.multiply(C4, t0, t0)
    np.divide(t1, t0, t0)
    np.sqrt(t0, out)


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
    ('_ramp_force_kelvin_voigt', 1, 't', 'theta', 'v', 'E', 'eta'): {
        ('t',): (('t',), prepare_ramp_force_kelvin_voigt_t, block_ramp_force_kelvin_voigt_t, 2, 1, (), False),
        ('t', 'theta', 'v', 'E', 'eta'): (('t', 'theta', 'v', 'E', 'eta'), prepare_ramp_force_kelvin_voigt_all, block_ramp_force_kelvin_voigt_all, 2, 1, (), False),
    },
    ('_retract_force_kelvin_voigt', 1, 't', 'theta', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'): {
        ('t',): (('t',), prepare_retract_force_kelvin_voigt_t, block_retract_force_kelvin_voigt_t, 3, 2, (0.0,), False),
        ('t', 'theta', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'): (('t', 'theta', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'), prepare_retract_force_kelvin_voigt_all, block_retract_force_kelvin_voigt_all, 4, 2, (0.0,), False),
    },
    ('_retract_radius_kelvin_voigt', 1, 't', 'theta', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'): {
        ('t',): (('t',), prepare_retract_radius_kelvin_voigt_t, block_retract_radius_kelvin_voigt_t, 2, 2, (0.0,), False),
        ('t', 'theta', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'): (('t', 'theta', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'), prepare_retract_radius_kelvin_voigt_all, block_retract_radius_kelvin_voigt_all, 3, 2, (0.0,), False),
    },
    ('_retract_radius_maxwell', 1, 't', 'theta', 'v', 'v_2', 't_m', 't_h', 'E', 'tau'): {
        ('t',): (('t',), prepare_retract_radius_maxwell_t, block_retract_radius_maxwell_t, 2, 2, (0.0, 700.0, 0.9999999999999998), False),
        ('t', 'theta', 'v', 'v_2', 't_m', 't_h', 'E', 'tau'): (('t', 'theta', 'v', 'v_2', 't_m', 't_h', 'E', 'tau'), prepare_retract_radius_maxwell_all, block_retract_radius_maxwell_all, 3, 2, (0.0, 700.0, 0.9999999999999998), False),
    },
    ('_retract_radius_power_creep', 1, 't', 'theta', 'v', 'v_2', 't_m', 't_h', 'E', 'alpha', 't_0'): {
        ('t',): (('t',), prepare_retract_radius_power_creep_t, block_retract_radius_power_creep_t, 2, 2, (0.0, 700.0), False),
        ('t', 'theta', 'v', 'v_2', 't_m', 't_h', 'E', 'alpha', 't_0'): (('t', 'theta', 'v', 'v_2', 't_m', 't_h', 'E', 'alpha', 't_0'), prepare_retract_radius_power_creep_all, block_retract_radius_power_creep_all, 4, 2, (0.0, 700.0), False),
    },
    ('_step_force_kelvin_voigt', 1, 't', 'd', 'theta', 'E', 'eta'): {
        ('t',): (('t',), prepare_step_force_kelvin_voigt_t, block_step_force_kelvin_voigt_t, 0, 1, (), False),
        ('t', 'd', 'theta', 'E', 'eta'): (('t', 'd', 'theta', 'E', 'eta'), prepare_step_force_kelvin_voigt_all, block_step_force_kelvin_voigt_all, 2, 1, (), False),
    },
    ('_step_force_maxwell', 1, 't', 'd', 'theta', 'E', 'tau'): {
        ('t',): (('t',), prepare_step_force_maxwell_t, block_step_force_maxwell_t, 0, 0, (), False),
        ('t', 'd', 'theta', 'E', 'tau'): (('t', 'd', 'theta', 'E', 'tau'), prepare_step_force_maxwell_all, block_step_force_maxwell_all, 2, 0, (), False),
    },
    ('_step_force_power_creep', 1, 't', 'd', 'theta', 'E', 'alpha', 't_0'): {
        ('t',): (('t',), prepare_step_force_power_creep_t, block_step_force_power_creep_t, 0, 0, (), False),
        ('t', 'd', 'theta', 'E', 'alpha', 't_0'): (('t', 'd', 'theta', 'E', 'alpha', 't_0'), prepare_step_force_power_creep_all, block_step_force_power_creep_all, 2, 0, (), False),
    },
    ('_step_force_standard_solid', 1, 't', 'd', 'theta', 'E_inf', 'E_1', 'tau'): {
        ('t',): (('t',), prepare_step_force_standard_solid_t, block_step_force_standard_solid_t, 0, 0, (), False),
        ('t', 'd', 'theta', 'E_inf', 'E_1', 'tau'): (('t', 'd', 'theta', 'E_inf', 'E_1', 'tau'), prepare_step_force_standard_solid_all, block_step_force_standard_solid_all, 2, 0, (), False),
    },
    ('_step_load_radius_kelvin_voigt', 1, 't', 'F', 'theta', 'E', 'eta'): {
        ('t',): (('t',), prepare_step_load_radius_kelvin_voigt_t, block_step_load_radius_kelvin_voigt_t, 0, 0, (), False),
        ('t', 'F', 'theta', 'E', 'eta'): (('t', 'F', 'theta', 'E', 'eta'), prepare_step_load_radius_kelvin_voigt_all, block_step_load_radius_kelvin_voigt_all, 1, 0, (), False),
    },
    ('_step_load_radius_maxwell', 1, 't', 'F', 'theta', 'E', 'tau'): {
        ('t',): (('t',), prepare_step_load_radius_maxwell_t, block_step_load_radius_maxwell_t, 0, 0, (), False),
        ('t', 'F', 'theta', 'E', 'tau'): (('t', 'F', 'theta', 'E', 'tau'), prepare_step_load_radius_maxwell_all, block_step_load_radius_maxwell_all, 1, 0, (), False),
    },
    ('_step_load_radius_power_creep', 1, 't', 'F', 'theta', 'E', 'alpha', 't_0'): {
        ('t',): (('t',), prepare_step_load_radius_power_creep_t, block_step_load_radius_power_creep_t, 0, 0, (), False),
        ('t', 'F', 'theta', 'E', 'alpha', 't_0'): (('t', 'F', 'theta', 'E', 'alpha', 't_0'), prepare_step_load_radius_power_creep_all, block_step_load_radius_power_creep_all, 1, 0, (), False),
    },
    ('_step_load_radius_standard_solid', 1, 't', 'F', 'theta', 'E_inf', 'E_1', 'tau'): {
        ('t',): (('t',), prepare_step_load_radius_standard_solid_t, block_step_load_radius_standard_solid_t, 0, 0, (), False),
        ('t', 'F', 'theta', 'E_inf', 'E_1', 'tau'): (('t', 'F', 'theta', 'E_inf', 'E_1', 'tau'), prepare_step_load_radius_standard_solid_all, block_step_load_radius_standard_solid_all, 2, 0, (), False),
    },
}
