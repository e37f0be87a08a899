"""Programs of axicontact.viscoelastic.hyperboloid."""

from __future__ import annotations

from math import expm1, inf, log1p

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._programs.bodies.viscoelastic import hyperboloid as bodies

C0 = np.array(1.0)
C1 = np.array(np.inf)


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


def ramp_force_kelvin_voigt(t, v, theta, b, E, eta):
    if t.__class__ is v.__class__ is theta.__class__ is b.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            value = bodies._ramp_force_kelvin_voigt(t, v, theta, b, E, eta)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, theta, b, E, eta):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_force_kelvin_voigt(t, v, v_2, t_m, theta, b, E, eta):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is theta.__class__ is b.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            value = bodies._retract_force_kelvin_voigt(t, v, v_2, t_m, theta, b, E, eta)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, v_2, t_m, theta, b, E, eta):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_radius_kelvin_voigt(t, v, v_2, t_m, theta, b, E, eta):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is theta.__class__ is b.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            value = bodies._retract_radius_kelvin_voigt(t, v, v_2, t_m, theta, b, E, eta)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, v_2, t_m, theta, b, E, eta):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_radius_maxwell(t, v, v_2, t_m, theta, b, E, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is theta.__class__ is b.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._retract_radius_maxwell(t, v, v_2, t_m, theta, b, E, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, v_2, t_m, theta, b, E, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_radius_power_creep(t, v, v_2, t_m, theta, b, E, alpha, t_0):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is theta.__class__ is b.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            value = bodies._retract_radius_power_creep(t, v, v_2, t_m, theta, b, E, alpha, t_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, v_2, t_m, theta, b, E, alpha, t_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_radius_standard_solid(t, v, v_2, t_m, theta, b, E_inf, E_1, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is theta.__class__ is b.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._retract_radius_standard_solid(t, v, v_2, t_m, theta, b, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, v_2, t_m, theta, b, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_force_kelvin_voigt(t, d, theta, b, E, eta):
    if t.__class__ is d.__class__ is theta.__class__ is b.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            value = bodies._step_force_kelvin_voigt(t, d, theta, b, E, eta)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, d, theta, b, E, eta):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_force_maxwell(t, d, theta, b, E, tau):
    if t.__class__ is d.__class__ is theta.__class__ is b.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._step_force_maxwell(t, d, theta, b, E, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, d, theta, b, E, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_force_power_creep(t, d, theta, b, E, alpha, t_0):
    if t.__class__ is d.__class__ is theta.__class__ is b.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            value = bodies._step_force_power_creep(t, d, theta, b, E, alpha, t_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, d, theta, b, E, alpha, t_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_force_standard_solid(t, d, theta, b, E_inf, E_1, tau):
    if t.__class__ is d.__class__ is theta.__class__ is b.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._step_force_standard_solid(t, d, theta, b, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, d, theta, b, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_load_radius_kelvin_voigt(t, F, theta, b, E, eta):
    if t.__class__ is F.__class__ is theta.__class__ is b.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            value = bodies._step_load_radius_kelvin_voigt(t, F, theta, b, E, eta)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, F, theta, b, E, eta):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_load_radius_maxwell(t, F, theta, b, E, tau):
    if t.__class__ is F.__class__ is theta.__class__ is b.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._step_load_radius_maxwell(t, F, theta, b, E, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, F, theta, b, E, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_load_radius_power_creep(t, F, theta, b, E, alpha, t_0):
    if t.__class__ is F.__class__ is theta.__class__ is b.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            value = bodies._step_load_radius_power_creep(t, F, theta, b, E, alpha, t_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, F, theta, b, E, alpha, t_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_load_radius_standard_solid(t, F, theta, b, E_inf, E_1, tau):
    if t.__class__ is F.__class__ is theta.__class__ is b.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._step_load_radius_standard_solid(t, F, theta, b, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, F, theta, b, E_inf, E_1, tau):
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
}
