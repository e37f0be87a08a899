"""Programs of axicontact.viscoelastic.flat_punch."""

from __future__ import annotations

from math import exp, expm1, inf, log1p, pow, sin

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._programs.bodies.viscoelastic import flat_punch as bodies

C0 = np.array(1.0)
C1 = np.array(np.inf)
C2 = np.array(0.0)
C3 = np.array(2.0)
C4 = np.array(3.141592653589793)


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
    np.equal(t, C2, m0)
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
    np.equal(t, C2, m0)
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


def retract_force_kelvin_voigt(t, v, v_2, t_m, a, E, eta):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is a.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            v14 = t > t_m
            if v14:
                if v14:
                    v8 = t - t_m
                    v15 = t_m - v_2 / v * ((v8 if v8 > 0.0 or v8 != v8 else 0.0) + eta / E)
                    v17 = v15 if v15 > 0.0 or v15 != v15 else 0.0
                else:
                    v17 = t
                if v17 > 0.0:
                    value = 2.0 * (v * v17) * a * (E + 0.0 * v17)
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


def prepare_retract_force_kelvin_voigt_t(a, v, v_2, t_m, E, eta):
    v7 = v_2 / v
    v11 = eta / E
    v34 = (2.0) * v
    v35 = v34 * a
    v36 = v35 * eta
    return (v, t_m, a, E, eta, v7, v11, v36)


def block_retract_force_kelvin_voigt_t(out, t, v, t_m, a, E, eta, v7, v11, v36, t0, t1, t2, m0, m1, f0):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some38 = np.count_nonzero(m0)
    if some38:
        some17 = np.count_nonzero(m0)
        if some17:
            np.subtract(t, t_m, t0)
            np.maximum(t0, f0, out=t0)
            np.add(t0, v11, t0)
            np.multiply(v7, t0, t0)
            np.subtract(t_m, t0, t0)
            np.maximum(t0, f0, out=t0)
        if some17 != size:
            np.copyto(t0, t, where=~m0)
        np.greater(t0, C2, m1)
        some26 = np.count_nonzero(m1)
        if some26:
            np.multiply(v, t0, out)
            np.multiply(C3, out, out)
            np.multiply(out, a, out)
            np.multiply(C2, t0, t1)
            np.add(E, t1, t1)
            np.multiply(out, t1, out)
        if some26 != size:
            np.copyto(out, C2, where=~m1)
    if some38 != size:
        other38 = t0 if some38 else out
        np.equal(t, C2, m1)
        some37 = np.count_nonzero(m1)
        if some37:
            np.copyto(other38, v36)
        if some37 != size:
            other37 = t1 if some37 else other38
            np.multiply(v, t, other37)
            np.multiply(C3, other37, other37)
            np.multiply(other37, a, other37)
            np.divide(eta, t, t2)
            np.add(E, t2, t2)
            np.multiply(other37, t2, other37)
            if some37:
                np.copyto(other38, other37, where=~m1)
        if some38:
            np.copyto(out, other38, where=~m0)


def prepare_retract_force_kelvin_voigt_all():
    return ()


def block_retract_force_kelvin_voigt_all(out, t, a, v, v_2, t_m, E, eta, t0, t1, t2, m0, m1, f0):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some38 = np.count_nonzero(m0)
    if some38:
        some17 = np.count_nonzero(m0)
        if some17:
            np.divide(v_2, v, t0)
            np.subtract(t, t_m, t1)
            np.maximum(t1, f0, out=t1)
            np.divide(eta, E, t2)
            np.add(t1, t2, t2)
            np.multiply(t0, t2, t2)
            np.subtract(t_m, t2, t2)
            np.maximum(t2, f0, out=t0)
        if some17 != size:
            np.copyto(t0, t, where=~m0)
        np.greater(t0, C2, m1)
        some26 = np.count_nonzero(m1)
        if some26:
            np.multiply(v, t0, out)
            np.multiply(C3, out, out)
            np.multiply(out, a, out)
            np.multiply(C2, t0, t2)
            np.add(E, t2, t2)
            np.multiply(out, t2, out)
        if some26 != size:
            np.copyto(out, C2, where=~m1)
    if some38 != size:
        other38 = t0 if some38 else out
        np.equal(t, C2, m1)
        some37 = np.count_nonzero(m1)
        if some37:
            np.multiply(C3, v, other38)
            np.multiply(other38, a, other38)
            np.multiply(other38, eta, other38)
        if some37 != size:
            other37 = t2 if some37 else other38
            np.multiply(v, t, other37)
            np.multiply(C3, other37, other37)
            np.multiply(other37, a, other37)
            np.divide(eta, t, t1)
            np.add(E, t1, t1)
            np.multiply(other37, t1, other37)
            if some37:
                np.copyto(other38, other37, where=~m1)
        if some38:
            np.copyto(out, other38, where=~m0)


def retract_force_maxwell(t, v, v_2, t_m, a, E, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is a.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._retract_force_maxwell(t, v, v_2, t_m, a, E, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, v_2, t_m, a, E, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_force_power_creep(t, v, v_2, t_m, a, E, alpha, t_0):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is a.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            value = bodies._retract_force_power_creep(t, v, v_2, t_m, a, E, alpha, t_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, v_2, t_m, a, E, alpha, t_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_force_standard_solid(t, v, v_2, t_m, a, E_inf, E_1, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is a.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._retract_force_standard_solid(t, v, v_2, t_m, a, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, v_2, t_m, a, E_inf, E_1, tau):
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
    np.greater(t, C2, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some7 = np.count_nonzero(m0)
    if some7:
        np.copyto(out, E)
    if some7 != size:
        np.copyto(out, C1, where=~m0)
    np.multiply(out, v10, out)


def prepare_step_force_kelvin_voigt_all():
    return ()


def block_step_force_kelvin_voigt_all(out, t, d, a, E, eta, t0, m0):
    size = out.size
    np.greater(t, C2, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some7 = np.count_nonzero(m0)
    if some7:
        np.copyto(out, E)
    if some7 != size:
        np.copyto(out, C1, where=~m0)
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
    ('_ramp_force_kelvin_voigt', 1, 't', 'a', 'v', 'E', 'eta'): {
        ('t',): (('t',), prepare_ramp_force_kelvin_voigt_t, block_ramp_force_kelvin_voigt_t, 2, 1, (), False),
        ('t', 'a', 'v', 'E', 'eta'): (('t', 'a', 'v', 'E', 'eta'), prepare_ramp_force_kelvin_voigt_all, block_ramp_force_kelvin_voigt_all, 2, 1, (), False),
    },
    ('_retract_force_kelvin_voigt', 1, 't', 'a', 'v', 'v_2', 't_m', 'E', 'eta'): {
        ('t',): (('t',), prepare_retract_force_kelvin_voigt_t, block_retract_force_kelvin_voigt_t, 3, 2, (0.0,), False),
        ('t', 'a', 'v', 'v_2', 't_m', 'E', 'eta'): (('t', 'a', 'v', 'v_2', 't_m', 'E', 'eta'), prepare_retract_force_kelvin_voigt_all, block_retract_force_kelvin_voigt_all, 3, 2, (0.0,), False),
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
