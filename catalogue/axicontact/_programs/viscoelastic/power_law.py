"""Programs of axicontact.viscoelastic.power_law."""

from __future__ import annotations

from math import exp, expm1, inf, log1p, pow, sin, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._programs.bodies.viscoelastic import power_law as bodies

C0 = np.array(0.0)
C1 = np.array(1.0)
C2 = np.array(np.inf)
C3 = np.array(0.5)
C4 = np.array(1.75)
C5 = np.array(1.5)
C6 = np.array(0.75)
C7 = np.array(0.01524698625788054)
C8 = np.array(0.5334320651111477)
C9 = np.array(2.250488865813539)
C10 = np.array(2.8612106440066865)
C11 = np.array(1.3794681629043655)
C12 = np.array(0.2596058532893223)
C13 = np.array(0.015624999999999823)
C14 = np.array(3.278794792785737)
C15 = np.array(49.328555418276075)
C16 = np.array(167.28648538571198)
C17 = np.array(195.37226190335065)
C18 = np.array(90.69722535867314)
C19 = np.array(16.763212110504565)
C20 = np.array(1.7724538509055159)
C21 = np.array(3.5449077018110318)
C22 = np.array(3.141592653589793)


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


def ramp_force_kelvin_voigt(t, v, A, n, E, eta):
    if t.__class__ is v.__class__ is A.__class__ is n.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            if t == 0.0:
                return 0.0
            v7 = n + 1.0
            v13 = n / 2.0 + 0.5
            v15 = v13 + 1.75
            v19 = (v13 + 0.5) * (v13 + 1.5)
            v32 = 1.0 / (v15 * v15)
            v73 = (v13 * (v13 + 1.0) / v19 if v13 < 1.0 else 1.0 - (v13 + 0.75) / v19) * sqrt(v15) * (1.0 + v32 * (((((((0.01524698625788054 * v32 + 0.5334320651111477) * v32 + 2.250488865813539) * v32 + 2.8612106440066865) * v32 + 1.3794681629043655) * v32 + 0.2596058532893223) * v32 + 0.015624999999999823) / ((((((3.278794792785737 * v32 + 49.328555418276075) * v32 + 167.28648538571198) * v32 + 195.37226190335065) * v32 + 90.69722535867314) * v32 + 16.763212110504565) * v32 + 1.0)))
            v77 = v * t / (1.7724538509055159 * A * v73)
            v85 = n + 0.0
            v87 = pow(v77, 1.0 / v85)
            value = 3.5449077018110318 * n * A / v7 * v73 * v77 * (v87 + v87 * ((v77 / (pow(v87, n) * pow(v87, 0.0)) - 1.0) / v85) if v77 > 0.0 and v77 < inf else v87) * (E + eta * (v7 / n) / t)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_ramp_force_kelvin_voigt_t(A, n, v, E, eta):
    v7 = n + (1.0)
    v8 = v7 / n
    v11 = n / (2.0)
    v13 = v11 + (0.5)
    v15 = v13 + (1.75)
    v16 = v13 + (0.5)
    v18 = v13 + (1.5)
    v19 = v16 * v18
    v20 = np.less(v13, (1.0))
    v21 = v13 + (1.0)
    v22 = v13 * v21
    v23 = v22 / v19
    v25 = v13 + (0.75)
    v26 = v25 / v19
    v27 = (1.0) - v26
    v28 = v23 if v20 else v27
    v29 = np.sqrt(v15)
    v30 = v28 * v29
    v31 = v15 * v15
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
    v76 = v75 * v73
    v79 = (3.5449077018110318) * n
    v80 = v79 * A
    v81 = v80 / v7
    v82 = v81 * v73
    v85 = n + (0.0)
    v86 = (1.0) / v85
    v102 = eta * v8
    return (v, n, E, v76, v82, v85, v86, v102)


def block_ramp_force_kelvin_voigt_t(out, t, v, n, E, v76, v82, v85, v86, v102, t0, t1, t2, t3, t4, m0, m1, m2):
    size = out.size
    np.equal(t, C0, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some107 = np.count_nonzero(m0)
    if some107:
        np.copyto(out, C0)
    if some107 != size:
        other107 = t0 if some107 else out
        np.multiply(v, t, other107)
        np.divide(other107, v76, other107)
        np.multiply(v82, other107, t1)
        np.power(other107, v86, t2)
        np.greater(other107, C0, m1)
        np.less(other107, C2, m2)
        np.bitwise_and(m1, m2, m2)
        some100 = np.count_nonzero(m2)
        if some100:
            np.power(t2, n, t3)
            np.power(t2, C0, t4)
            np.multiply(t3, t4, t4)
            np.divide(other107, t4, t4)
            np.subtract(t4, C1, t4)
            np.divide(t4, v85, t4)
            np.multiply(t2, t4, t4)
            np.add(t2, t4, t3)
        if some100 != size:
            np.copyto(t3, t2, where=~m2)
        np.multiply(t1, t3, t3)
        np.divide(v102, t, t1)
        np.add(E, t1, t1)
        np.multiply(t3, t1, other107)
        if some107:
            np.copyto(out, other107, where=~m0)


def prepare_ramp_force_kelvin_voigt_all():
    return ()


def block_ramp_force_kelvin_voigt_all(out, t, A, n, v, E, eta, t0, t1, t2, t3, t4, t5, t6, t7, m0, m1, m2):
    size = out.size
    np.equal(t, C0, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some107 = np.count_nonzero(m0)
    if some107:
        np.copyto(out, C0)
    if some107 != size:
        other107 = t0 if some107 else out
        np.add(n, C1, other107)
        np.divide(other107, n, t1)
        np.multiply(v, t, t2)
        np.multiply(n, C3, t3)
        np.add(t3, C3, t3)
        np.add(t3, C4, t4)
        np.add(t3, C3, t5)
        np.add(t3, C5, t6)
        np.multiply(t5, t6, t6)
        np.less(t3, C1, m1)
        some28 = np.count_nonzero(m1)
        if some28:
            np.add(t3, C1, t5)
            np.multiply(t3, t5, t5)
            np.divide(t5, t6, t5)
        if some28 != size:
            other28 = t7 if some28 else t5
            np.add(t3, C6, other28)
            np.divide(other28, t6, other28)
            np.subtract(C1, other28, other28)
            if some28:
                np.copyto(t5, other28, where=~m1)
        np.sqrt(t4, t6)
        np.multiply(t5, t6, t6)
        np.multiply(t4, t4, t4)
        np.divide(C1, t4, t4)
        np.multiply(C7, t4, t5)
        np.add(t5, C8, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C9, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C10, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C11, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C12, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C13, t5)
        np.multiply(C14, t4, t3)
        np.add(t3, C15, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C16, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C17, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C18, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C19, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C1, t3)
        np.divide(t5, t3, t3)
        np.multiply(t4, t3, t3)
        np.add(C1, t3, t3)
        np.multiply(t6, t3, t3)
        np.multiply(C20, A, t6)
        np.multiply(t6, t3, t6)
        np.divide(t2, t6, t6)
        np.multiply(C21, n, t2)
        np.multiply(t2, A, t2)
        np.divide(t2, other107, other107)
        np.multiply(other107, t3, t3)
        np.multiply(t3, t6, t3)
        np.add(n, C0, other107)
        np.divide(C1, other107, t2)
        np.power(t6, t2, t2)
        np.greater(t6, C0, m1)
        np.less(t6, C2, m2)
        np.bitwise_and(m1, m2, m2)
        some100 = np.count_nonzero(m2)
        if some100:
            np.power(t2, n, t4)
            np.power(t2, C0, t5)
            np.multiply(t4, t5, t5)
            np.divide(t6, t5, t5)
            np.subtract(t5, C1, t5)
            np.divide(t5, other107, t5)
            np.multiply(t2, t5, t5)
            np.add(t2, t5, t4)
        if some100 != size:
            np.copyto(t4, t2, where=~m2)
        np.multiply(t3, t4, t4)
        np.multiply(eta, t1, t1)
        np.divide(t1, t, t1)
        np.add(E, t1, t1)
        np.multiply(t4, t1, other107)
        if some107:
            np.copyto(out, other107, where=~m0)


def ramp_force_maxwell(t, v, A, n, E, tau):
    if t.__class__ is v.__class__ is A.__class__ is n.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._ramp_force_maxwell(t, v, A, n, E, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, A, n, E, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def ramp_force_power_creep(t, v, A, n, E, alpha, t_0):
    if t.__class__ is v.__class__ is A.__class__ is n.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            value = bodies._ramp_force_power_creep(t, v, A, n, E, alpha, t_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, A, n, E, alpha, t_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def ramp_force_standard_solid(t, v, A, n, E_inf, E_1, tau):
    if t.__class__ is v.__class__ is A.__class__ is n.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._ramp_force_standard_solid(t, v, A, n, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, A, n, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_force_kelvin_voigt(t, v, v_2, t_m, t_h, A, n, E, eta):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is A.__class__ is n.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            v17 = t > t_m
            v22 = n + 1.0
            v35 = n / 2.0 + 0.5
            v37 = v35 + 1.75
            v41 = (v35 + 0.5) * (v35 + 1.5)
            v54 = 1.0 / (v37 * v37)
            v95 = (v35 * (v35 + 1.0) / v41 if v35 < 1.0 else 1.0 - (v35 + 0.75) / v41) * sqrt(v37) * (1.0 + v54 * (((((((0.01524698625788054 * v54 + 0.5334320651111477) * v54 + 2.250488865813539) * v54 + 2.8612106440066865) * v54 + 1.3794681629043655) * v54 + 0.2596058532893223) * v54 + 0.015624999999999823) / ((((((3.278794792785737 * v54 + 49.328555418276075) * v54 + 167.28648538571198) * v54 + 195.37226190335065) * v54 + 90.69722535867314) * v54 + 16.763212110504565) * v54 + 1.0)))
            v98 = 1.7724538509055159 * A * v95
            v104 = 3.5449077018110318 * n * A / v22 * v95
            v106 = n + 0.0
            v107 = 1.0 / v106
            if v17:
                if v17:
                    v18 = t_m - (v_2 / v * (t - t_h + eta / E) if t > t_h else 0.0)
                    v20 = v18 if v18 > 0.0 or v18 != v18 else 0.0
                else:
                    v20 = t
                if v17 and v20 > 0.0:
                    v99 = v * v20 / v98
                    v108 = pow(v99, v107)
                    value = v104 * v99 * (v108 + v108 * ((v99 / (pow(v108, n) * pow(v108, 0.0)) - 1.0) / v106) if v99 > 0.0 and v99 < inf else v108) * (E + 0.0 * v20)
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    return None
                return 0.0
            if t == 0.0:
                return 0.0
            v126 = v * t / v98
            v128 = pow(v126, v107)
            value = v104 * v126 * (v128 + v128 * ((v126 / (pow(v128, n) * pow(v128, 0.0)) - 1.0) / v106) if v126 > 0.0 and v126 < inf else v128) * (E + eta * (v22 / n) / t)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_retract_force_kelvin_voigt_t(A, n, v, v_2, t_m, t_h, E, eta):
    v9 = v_2 / v
    v12 = eta / E
    v22 = n + (1.0)
    v23 = v22 / n
    v30 = n / (2.0)
    v32 = v30 + (0.5)
    v34 = v32 + (1.75)
    v35 = v32 + (0.5)
    v37 = v32 + (1.5)
    v38 = v35 * v37
    v39 = np.less(v32, (1.0))
    v40 = v32 + (1.0)
    v41 = v32 * v40
    v42 = v41 / v38
    v44 = v32 + (0.75)
    v45 = v44 / v38
    v46 = (1.0) - v45
    v47 = v42 if v39 else v46
    v48 = np.sqrt(v34)
    v49 = v47 * v48
    v50 = v34 * v34
    v51 = (1.0) / v50
    v53 = (0.01524698625788054) * v51
    v55 = v53 + (0.5334320651111477)
    v56 = v55 * v51
    v58 = v56 + (2.250488865813539)
    v59 = v58 * v51
    v61 = v59 + (2.8612106440066865)
    v62 = v61 * v51
    v64 = v62 + (1.3794681629043655)
    v65 = v64 * v51
    v67 = v65 + (0.2596058532893223)
    v68 = v67 * v51
    v70 = v68 + (0.015624999999999823)
    v72 = (3.278794792785737) * v51
    v74 = v72 + (49.328555418276075)
    v75 = v74 * v51
    v77 = v75 + (167.28648538571198)
    v78 = v77 * v51
    v80 = v78 + (195.37226190335065)
    v81 = v80 * v51
    v83 = v81 + (90.69722535867314)
    v84 = v83 * v51
    v86 = v84 + (16.763212110504565)
    v87 = v86 * v51
    v88 = v87 + (1.0)
    v89 = v70 / v88
    v90 = v51 * v89
    v91 = (1.0) + v90
    v92 = v49 * v91
    v94 = (1.7724538509055159) * A
    v95 = v94 * v92
    v98 = (3.5449077018110318) * n
    v99 = v98 * A
    v100 = v99 / v22
    v101 = v100 * v92
    v103 = n + (0.0)
    v104 = (1.0) / v103
    v139 = eta * v23
    return (v, t_m, t_h, n, E, v9, v12, v95, v101, v103, v104, v139)


def block_retract_force_kelvin_voigt_t(out, t, v, t_m, t_h, n, E, v9, v12, v95, v101, v103, v104, v139, t0, t1, t2, t3, t4, t5, m0, m1, m2, m3, f0):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some145 = np.count_nonzero(m0)
    if some145:
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
        np.greater(t0, C0, m1)
        np.bitwise_and(m0, m1, m1)
        some121 = np.count_nonzero(m1)
        if some121:
            np.multiply(C0, t0, out)
            np.add(E, out, out)
            np.multiply(v, t0, t1)
            np.divide(t1, v95, t1)
            np.multiply(v101, t1, t2)
            np.power(t1, v104, t3)
            np.greater(t1, C0, m2)
            np.less(t1, C2, m3)
            np.bitwise_and(m2, m3, m3)
            some118 = np.count_nonzero(m3)
            if some118:
                np.power(t3, n, t4)
                np.power(t3, C0, t5)
                np.multiply(t4, t5, t5)
                np.divide(t1, t5, t5)
                np.subtract(t5, C1, t5)
                np.divide(t5, v103, t5)
                np.multiply(t3, t5, t5)
                np.add(t3, t5, t4)
            if some118 != size:
                np.copyto(t4, t3, where=~m3)
            np.multiply(t2, t4, t4)
            np.multiply(t4, out, out)
        if some121 != size:
            np.copyto(out, C0, where=~m1)
    if some145 != size:
        other145 = t0 if some145 else out
        np.equal(t, C0, m1)
        some144 = np.count_nonzero(m1)
        if some144:
            np.copyto(other145, C0)
        if some144 != size:
            other144 = t4 if some144 else other145
            np.multiply(v, t, other144)
            np.divide(other144, v95, other144)
            np.multiply(v101, other144, t2)
            np.power(other144, v104, t1)
            np.greater(other144, C0, m3)
            np.less(other144, C2, m2)
            np.bitwise_and(m3, m2, m2)
            some137 = np.count_nonzero(m2)
            if some137:
                np.power(t1, n, t3)
                np.power(t1, C0, t5)
                np.multiply(t3, t5, t5)
                np.divide(other144, t5, t5)
                np.subtract(t5, C1, t5)
                np.divide(t5, v103, t5)
                np.multiply(t1, t5, t5)
                np.add(t1, t5, t3)
            if some137 != size:
                np.copyto(t3, t1, where=~m2)
            np.multiply(t2, t3, t3)
            np.divide(v139, t, t2)
            np.add(E, t2, t2)
            np.multiply(t3, t2, other144)
            if some144:
                np.copyto(other145, other144, where=~m1)
        if some145:
            np.copyto(out, other145, where=~m0)


def prepare_retract_force_kelvin_voigt_all():
    return ()


def block_retract_force_kelvin_voigt_all(out, t, A, n, v, v_2, t_m, t_h, E, eta, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, m0, m1, m2, m3, f0):
    size = out.size
    np.greater(t, t_m, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.add(n, C1, t0)
    np.multiply(n, C3, t1)
    np.add(t1, C3, t1)
    np.add(t1, C4, t2)
    np.add(t1, C3, t3)
    np.add(t1, C5, t4)
    np.multiply(t3, t4, t4)
    np.less(t1, C1, m1)
    some47 = np.count_nonzero(m1)
    if some47:
        np.add(t1, C1, t3)
        np.multiply(t1, t3, t3)
        np.divide(t3, t4, t3)
    if some47 != size:
        other47 = t5 if some47 else t3
        np.add(t1, C6, other47)
        np.divide(other47, t4, other47)
        np.subtract(C1, other47, other47)
        if some47:
            np.copyto(t3, other47, where=~m1)
    np.sqrt(t2, t4)
    np.multiply(t3, t4, t4)
    np.multiply(t2, t2, t2)
    np.divide(C1, t2, t2)
    np.multiply(C7, t2, t3)
    np.add(t3, C8, t3)
    np.multiply(t3, t2, t3)
    np.add(t3, C9, t3)
    np.multiply(t3, t2, t3)
    np.add(t3, C10, t3)
    np.multiply(t3, t2, t3)
    np.add(t3, C11, t3)
    np.multiply(t3, t2, t3)
    np.add(t3, C12, t3)
    np.multiply(t3, t2, t3)
    np.add(t3, C13, t3)
    np.multiply(C14, t2, t1)
    np.add(t1, C15, t1)
    np.multiply(t1, t2, t1)
    np.add(t1, C16, t1)
    np.multiply(t1, t2, t1)
    np.add(t1, C17, t1)
    np.multiply(t1, t2, t1)
    np.add(t1, C18, t1)
    np.multiply(t1, t2, t1)
    np.add(t1, C19, t1)
    np.multiply(t1, t2, t1)
    np.add(t1, C1, t1)
    np.divide(t3, t1, t1)
    np.multiply(t2, t1, t1)
    np.add(C1, t1, t1)
    np.multiply(t4, t1, t1)
    np.multiply(C20, A, t4)
    np.multiply(t4, t1, t4)
    np.multiply(C21, n, t2)
    np.multiply(t2, A, t2)
    np.divide(t2, t0, t2)
    np.multiply(t2, t1, t1)
    np.add(n, C0, t2)
    np.divide(C1, t2, t3)
    some145 = np.count_nonzero(m0)
    if some145:
        some20 = np.count_nonzero(m0)
        if some20:
            np.greater(t, t_h, m1)
            some16 = np.count_nonzero(m1)
            if some16:
                np.divide(v_2, v, t5)
                np.subtract(t, t_h, t6)
                np.divide(eta, E, t7)
                np.add(t6, t7, t7)
                np.multiply(t5, t7, t5)
            if some16 != size:
                np.copyto(t5, C0, where=~m1)
            np.subtract(t_m, t5, t5)
            np.maximum(t5, f0, out=t5)
        if some20 != size:
            np.copyto(t5, t, where=~m0)
        np.greater(t5, C0, m1)
        np.bitwise_and(m0, m1, m1)
        some121 = np.count_nonzero(m1)
        if some121:
            np.multiply(C0, t5, out)
            np.add(E, out, out)
            np.multiply(v, t5, t7)
            np.divide(t7, t4, t7)
            np.multiply(t1, t7, t6)
            np.power(t7, t3, t8)
            np.greater(t7, C0, m2)
            np.less(t7, C2, m3)
            np.bitwise_and(m2, m3, m3)
            some118 = np.count_nonzero(m3)
            if some118:
                np.power(t8, n, t9)
                np.power(t8, C0, t10)
                np.multiply(t9, t10, t10)
                np.divide(t7, t10, t10)
                np.subtract(t10, C1, t10)
                np.divide(t10, t2, t10)
                np.multiply(t8, t10, t10)
                np.add(t8, t10, t9)
            if some118 != size:
                np.copyto(t9, t8, where=~m3)
            np.multiply(t6, t9, t9)
            np.multiply(t9, out, out)
        if some121 != size:
            np.copyto(out, C0, where=~m1)
    if some145 != size:
        other145 = t5 if some145 else out
        np.equal(t, C0, m1)
        some144 = np.count_nonzero(m1)
        if some144:
            np.copyto(other145, C0)
        if some144 != size:
            other144 = t9 if some144 else other145
            np.divide(t0, n, other144)
            np.multiply(v, t, t6)
            np.divide(t6, t4, t6)
            np.multiply(t1, t6, t7)
            np.power(t6, t3, t8)
            np.greater(t6, C0, m3)
            np.less(t6, C2, m2)
            np.bitwise_and(m3, m2, m2)
            some137 = np.count_nonzero(m2)
            if some137:
                np.power(t8, n, t10)
                np.power(t8, C0, t11)
                np.multiply(t10, t11, t11)
                np.divide(t6, t11, t11)
                np.subtract(t11, C1, t11)
                np.divide(t11, t2, t11)
                np.multiply(t8, t11, t11)
                np.add(t8, t11, t10)
            if some137 != size:
                np.copyto(t10, t8, where=~m2)
            np.multiply(t7, t10, t10)
            np.multiply(eta, other144, other144)
            np.divide(other144, t, other144)
            np.add(E, other144, other144)
            np.multiply(t10, other144, other144)
            if some144:
                np.copyto(other145, other144, where=~m1)
        if some145:
            np.copyto(out, other145, where=~m0)


def retract_force_maxwell(t, v, v_2, t_m, t_h, A, n, E, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is A.__class__ is n.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._retract_force_maxwell(t, v, v_2, t_m, t_h, A, n, E, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and t > t_h)) and ordinary(t, v, v_2, t_m, t_h, A, n, E, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_force_power_creep(t, v, v_2, t_m, t_h, A, n, E, alpha, t_0):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is A.__class__ is n.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            value = bodies._retract_force_power_creep(t, v, v_2, t_m, t_h, A, n, E, alpha, t_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and t > t_h)) and ordinary(t, v, v_2, t_m, t_h, A, n, E, alpha, t_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_force_standard_solid(t, v, v_2, t_m, t_h, A, n, E_inf, E_1, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is A.__class__ is n.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._retract_force_standard_solid(t, v, v_2, t_m, t_h, A, n, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and t > t_h)) and ordinary(t, v, v_2, t_m, t_h, A, n, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def retract_radius_kelvin_voigt(t, v, v_2, t_m, t_h, A, n, E, eta):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is A.__class__ is n.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            if t > t_m:
                v18 = t_m - (v_2 / v * (t - t_h + eta / E) if t > t_h else 0.0)
                v20 = v18 if v18 > 0.0 or v18 != v18 else 0.0
            else:
                v20 = t
            if v20 <= 0.0:
                return 0.0
            v26 = n / 2.0 + 0.5
            v28 = v26 + 1.75
            v32 = (v26 + 0.5) * (v26 + 1.5)
            v46 = 1.0 / (v28 * v28)
            v91 = v * v20 / (1.7724538509055159 * A * ((v26 * (v26 + 1.0) / v32 if v26 < 1.0 else 1.0 - (v26 + 0.75) / v32) * sqrt(v28) * (1.0 + v46 * (((((((0.01524698625788054 * v46 + 0.5334320651111477) * v46 + 2.250488865813539) * v46 + 2.8612106440066865) * v46 + 1.3794681629043655) * v46 + 0.2596058532893223) * v46 + 0.015624999999999823) / ((((((3.278794792785737 * v46 + 49.328555418276075) * v46 + 167.28648538571198) * v46 + 195.37226190335065) * v46 + 90.69722535867314) * v46 + 16.763212110504565) * v46 + 1.0)))))
            v92 = n + 0.0
            v94 = pow(v91, 1.0 / v92)
            if v91 > 0.0 and v91 < inf:
                value = v94 + v94 * ((v91 / (pow(v94, n) * pow(v94, 0.0)) - 1.0) / v92)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            value = v94
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_retract_radius_kelvin_voigt_t(A, n, v, v_2, t_m, t_h, E, eta):
    v9 = v_2 / v
    v12 = eta / E
    v24 = n / (2.0)
    v26 = v24 + (0.5)
    v28 = v26 + (1.75)
    v29 = v26 + (0.5)
    v31 = v26 + (1.5)
    v32 = v29 * v31
    v34 = np.less(v26, (1.0))
    v35 = v26 + (1.0)
    v36 = v26 * v35
    v37 = v36 / v32
    v39 = v26 + (0.75)
    v40 = v39 / v32
    v41 = (1.0) - v40
    v42 = v37 if v34 else v41
    v43 = np.sqrt(v28)
    v44 = v42 * v43
    v45 = v28 * v28
    v46 = (1.0) / v45
    v48 = (0.01524698625788054) * v46
    v50 = v48 + (0.5334320651111477)
    v51 = v50 * v46
    v53 = v51 + (2.250488865813539)
    v54 = v53 * v46
    v56 = v54 + (2.8612106440066865)
    v57 = v56 * v46
    v59 = v57 + (1.3794681629043655)
    v60 = v59 * v46
    v62 = v60 + (0.2596058532893223)
    v63 = v62 * v46
    v65 = v63 + (0.015624999999999823)
    v67 = (3.278794792785737) * v46
    v69 = v67 + (49.328555418276075)
    v70 = v69 * v46
    v72 = v70 + (167.28648538571198)
    v73 = v72 * v46
    v75 = v73 + (195.37226190335065)
    v76 = v75 * v46
    v78 = v76 + (90.69722535867314)
    v79 = v78 * v46
    v81 = v79 + (16.763212110504565)
    v82 = v81 * v46
    v83 = v82 + (1.0)
    v84 = v65 / v83
    v85 = v46 * v84
    v86 = (1.0) + v85
    v87 = v44 * v86
    v89 = (1.7724538509055159) * A
    v90 = v89 * v87
    v92 = n + (0.0)
    v93 = (1.0) / v92
    return (v, t_m, t_h, n, v9, v12, v90, v92, v93)


def block_retract_radius_kelvin_voigt_t(out, t, v, t_m, t_h, n, v9, v12, v90, v92, v93, t0, t1, t2, t3, t4, m0, m1, m2, f0):
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
    some108 = np.count_nonzero(m0)
    if some108:
        np.copyto(out, C0)
    if some108 != size:
        other108 = t1 if some108 else out
        np.multiply(v, t0, t2)
        np.divide(t2, v90, t2)
        np.power(t2, v93, t3)
        np.greater(t2, C0, m1)
        np.less(t2, C2, m2)
        np.bitwise_and(m1, m2, m2)
        some107 = np.count_nonzero(m2)
        if some107:
            np.power(t3, n, other108)
            np.power(t3, C0, t4)
            np.multiply(other108, t4, t4)
            np.divide(t2, t4, t4)
            np.subtract(t4, C1, t4)
            np.divide(t4, v92, t4)
            np.multiply(t3, t4, t4)
            np.add(t3, t4, other108)
        if some107 != size:
            np.copyto(other108, t3, where=~m2)
        if some108:
            np.copyto(out, other108, where=~m0)


def prepare_retract_radius_kelvin_voigt_all():
    return ()


def block_retract_radius_kelvin_voigt_all(out, t, A, n, v, v_2, t_m, t_h, E, eta, t0, t1, t2, t3, t4, t5, t6, t7, m0, m1, m2, f0):
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
    some108 = np.count_nonzero(m0)
    if some108:
        np.copyto(out, C0)
    if some108 != size:
        other108 = t2 if some108 else out
        np.multiply(v, t0, t1)
        np.multiply(n, C3, t3)
        np.add(t3, C3, t3)
        np.add(t3, C4, t4)
        np.add(t3, C3, t5)
        np.add(t3, C5, t6)
        np.multiply(t5, t6, t6)
        np.less(t3, C1, m1)
        some42 = np.count_nonzero(m1)
        if some42:
            np.add(t3, C1, t5)
            np.multiply(t3, t5, t5)
            np.divide(t5, t6, t5)
        if some42 != size:
            other42 = t7 if some42 else t5
            np.add(t3, C6, other42)
            np.divide(other42, t6, other42)
            np.subtract(C1, other42, other42)
            if some42:
                np.copyto(t5, other42, where=~m1)
        np.sqrt(t4, t6)
        np.multiply(t5, t6, t6)
        np.multiply(t4, t4, t4)
        np.divide(C1, t4, t4)
        np.multiply(C7, t4, t5)
        np.add(t5, C8, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C9, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C10, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C11, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C12, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C13, t5)
        np.multiply(C14, t4, t3)
        np.add(t3, C15, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C16, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C17, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C18, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C19, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C1, t3)
        np.divide(t5, t3, t3)
        np.multiply(t4, t3, t3)
        np.add(C1, t3, t3)
        np.multiply(t6, t3, t3)
        np.multiply(C20, A, t6)
        np.multiply(t6, t3, t3)
        np.divide(t1, t3, t3)
        np.add(n, C0, t1)
        np.divide(C1, t1, t6)
        np.power(t3, t6, t6)
        np.greater(t3, C0, m1)
        np.less(t3, C2, m2)
        np.bitwise_and(m1, m2, m2)
        some107 = np.count_nonzero(m2)
        if some107:
            np.power(t6, n, other108)
            np.power(t6, C0, t4)
            np.multiply(other108, t4, t4)
            np.divide(t3, t4, t4)
            np.subtract(t4, C1, t4)
            np.divide(t4, t1, t4)
            np.multiply(t6, t4, t4)
            np.add(t6, t4, other108)
        if some107 != size:
            np.copyto(other108, t6, where=~m2)
        if some108:
            np.copyto(out, other108, where=~m0)


def retract_radius_maxwell(t, v, v_2, t_m, t_h, A, n, E, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is A.__class__ is n.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
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
            v42 = n / 2.0 + 0.5
            v44 = v42 + 1.75
            v48 = (v42 + 0.5) * (v42 + 1.5)
            v61 = 1.0 / (v44 * v44)
            v106 = v * v36 / (1.7724538509055159 * A * ((v42 * (v42 + 1.0) / v48 if v42 < 1.0 else 1.0 - (v42 + 0.75) / v48) * sqrt(v44) * (1.0 + v61 * (((((((0.01524698625788054 * v61 + 0.5334320651111477) * v61 + 2.250488865813539) * v61 + 2.8612106440066865) * v61 + 1.3794681629043655) * v61 + 0.2596058532893223) * v61 + 0.015624999999999823) / ((((((3.278794792785737 * v61 + 49.328555418276075) * v61 + 167.28648538571198) * v61 + 195.37226190335065) * v61 + 90.69722535867314) * v61 + 16.763212110504565) * v61 + 1.0)))))
            v107 = n + 0.0
            v109 = pow(v106, 1.0 / v107)
            if v106 > 0.0 and v106 < inf:
                value = v109 + v109 * ((v106 / (pow(v109, n) * pow(v109, 0.0)) - 1.0) / v107)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            value = v109
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_retract_radius_maxwell_t(A, n, v, v_2, t_m, t_h, E, tau):
    v8 = v_2 / v
    v17 = t_h - t_m
    v18 = v17 / tau
    v19 = np.minimum(v18, (700.0))
    v20 = np.exp(v19)
    v24 = np.negative(tau)
    v39 = n / (2.0)
    v41 = v39 + (0.5)
    v43 = v41 + (1.75)
    v44 = v41 + (0.5)
    v46 = v41 + (1.5)
    v47 = v44 * v46
    v48 = np.less(v41, (1.0))
    v49 = v41 + (1.0)
    v50 = v41 * v49
    v51 = v50 / v47
    v53 = v41 + (0.75)
    v54 = v53 / v47
    v55 = (1.0) - v54
    v56 = v51 if v48 else v55
    v57 = np.sqrt(v43)
    v58 = v56 * v57
    v59 = v43 * v43
    v60 = (1.0) / v59
    v62 = (0.01524698625788054) * v60
    v64 = v62 + (0.5334320651111477)
    v65 = v64 * v60
    v67 = v65 + (2.250488865813539)
    v68 = v67 * v60
    v70 = v68 + (2.8612106440066865)
    v71 = v70 * v60
    v73 = v71 + (1.3794681629043655)
    v74 = v73 * v60
    v76 = v74 + (0.2596058532893223)
    v77 = v76 * v60
    v79 = v77 + (0.015624999999999823)
    v81 = (3.278794792785737) * v60
    v83 = v81 + (49.328555418276075)
    v84 = v83 * v60
    v86 = v84 + (167.28648538571198)
    v87 = v86 * v60
    v89 = v87 + (195.37226190335065)
    v90 = v89 * v60
    v92 = v90 + (90.69722535867314)
    v93 = v92 * v60
    v95 = v93 + (16.763212110504565)
    v96 = v95 * v60
    v97 = v96 + (1.0)
    v98 = v79 / v97
    v99 = v60 * v98
    v100 = (1.0) + v99
    v101 = v58 * v100
    v103 = (1.7724538509055159) * A
    v104 = v103 * v101
    v106 = n + (0.0)
    v107 = (1.0) / v106
    return (v, t_m, t_h, n, tau, v8, v20, v24, v104, v106, v107)


def block_retract_radius_maxwell_t(out, t, v, t_m, t_h, n, tau, v8, v20, v24, v104, v106, v107, t0, t1, t2, t3, t4, m0, m1, m2, f0, f1, f2):
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
    some121 = np.count_nonzero(m0)
    if some121:
        np.copyto(out, C0)
    if some121 != size:
        other121 = t1 if some121 else out
        np.multiply(v, t0, t2)
        np.divide(t2, v104, t2)
        np.power(t2, v107, t3)
        np.greater(t2, C0, m1)
        np.less(t2, C2, m2)
        np.bitwise_and(m1, m2, m2)
        some120 = np.count_nonzero(m2)
        if some120:
            np.power(t3, n, other121)
            np.power(t3, C0, t4)
            np.multiply(other121, t4, t4)
            np.divide(t2, t4, t4)
            np.subtract(t4, C1, t4)
            np.divide(t4, v106, t4)
            np.multiply(t3, t4, t4)
            np.add(t3, t4, other121)
        if some120 != size:
            np.copyto(other121, t3, where=~m2)
        if some121:
            np.copyto(out, other121, where=~m0)


def prepare_retract_radius_maxwell_all():
    return ()


def block_retract_radius_maxwell_all(out, t, A, n, v, v_2, t_m, t_h, E, tau, t0, t1, t2, t3, t4, t5, t6, t7, m0, m1, m2, f0, f1, f2):
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
    some121 = np.count_nonzero(m0)
    if some121:
        np.copyto(out, C0)
    if some121 != size:
        other121 = t1 if some121 else out
        np.multiply(v, t0, t2)
        np.multiply(n, C3, t3)
        np.add(t3, C3, t3)
        np.add(t3, C4, t4)
        np.add(t3, C3, t5)
        np.add(t3, C5, t6)
        np.multiply(t5, t6, t6)
        np.less(t3, C1, m1)
        some56 = np.count_nonzero(m1)
        if some56:
            np.add(t3, C1, t5)
            np.multiply(t3, t5, t5)
            np.divide(t5, t6, t5)
        if some56 != size:
            other56 = t7 if some56 else t5
            np.add(t3, C6, other56)
            np.divide(other56, t6, other56)
            np.subtract(C1, other56, other56)
            if some56:
                np.copyto(t5, other56, where=~m1)
        np.sqrt(t4, t6)
        np.multiply(t5, t6, t6)
        np.multiply(t4, t4, t4)
        np.divide(C1, t4, t4)
        np.multiply(C7, t4, t5)
        np.add(t5, C8, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C9, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C10, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C11, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C12, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C13, t5)
        np.multiply(C14, t4, t3)
        np.add(t3, C15, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C16, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C17, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C18, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C19, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C1, t3)
        np.divide(t5, t3, t3)
        np.multiply(t4, t3, t3)
        np.add(C1, t3, t3)
        np.multiply(t6, t3, t3)
        np.multiply(C20, A, t6)
        np.multiply(t6, t3, t3)
        np.divide(t2, t3, t3)
        np.add(n, C0, t2)
        np.divide(C1, t2, t6)
        np.power(t3, t6, t6)
        np.greater(t3, C0, m1)
        np.less(t3, C2, m2)
        np.bitwise_and(m1, m2, m2)
        some120 = np.count_nonzero(m2)
        if some120:
            np.power(t6, n, other121)
            np.power(t6, C0, t4)
            np.multiply(other121, t4, t4)
            np.divide(t3, t4, t4)
            np.subtract(t4, C1, t4)
            np.divide(t4, t2, t4)
            np.multiply(t6, t4, t4)
            np.add(t6, t4, other121)
        if some120 != size:
            np.copyto(other121, t6, where=~m2)
        if some121:
            np.copyto(out, other121, where=~m0)


def retract_radius_power_creep(t, v, v_2, t_m, t_h, A, n, E, alpha, t_0):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is A.__class__ is n.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
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
            v37 = n / 2.0 + 0.5
            v39 = v37 + 1.75
            v43 = (v37 + 0.5) * (v37 + 1.5)
            v56 = 1.0 / (v39 * v39)
            v101 = v * v31 / (1.7724538509055159 * A * ((v37 * (v37 + 1.0) / v43 if v37 < 1.0 else 1.0 - (v37 + 0.75) / v43) * sqrt(v39) * (1.0 + v56 * (((((((0.01524698625788054 * v56 + 0.5334320651111477) * v56 + 2.250488865813539) * v56 + 2.8612106440066865) * v56 + 1.3794681629043655) * v56 + 0.2596058532893223) * v56 + 0.015624999999999823) / ((((((3.278794792785737 * v56 + 49.328555418276075) * v56 + 167.28648538571198) * v56 + 195.37226190335065) * v56 + 90.69722535867314) * v56 + 16.763212110504565) * v56 + 1.0)))))
            v102 = n + 0.0
            v104 = pow(v101, 1.0 / v102)
            if v101 > 0.0 and v101 < inf:
                value = v104 + v104 * ((v101 / (pow(v104, n) * pow(v104, 0.0)) - 1.0) / v102)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            value = v104
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_retract_radius_power_creep_t(A, n, v, v_2, t_m, t_h, E, alpha, t_0):
    v8 = v_2 / v
    v16 = (1.0) - alpha
    v33 = n / (2.0)
    v35 = v33 + (0.5)
    v37 = v35 + (1.75)
    v38 = v35 + (0.5)
    v40 = v35 + (1.5)
    v41 = v38 * v40
    v42 = np.less(v35, (1.0))
    v43 = v35 + (1.0)
    v44 = v35 * v43
    v45 = v44 / v41
    v47 = v35 + (0.75)
    v48 = v47 / v41
    v49 = (1.0) - v48
    v50 = v45 if v42 else v49
    v51 = np.sqrt(v37)
    v52 = v50 * v51
    v53 = v37 * v37
    v54 = (1.0) / v53
    v56 = (0.01524698625788054) * v54
    v58 = v56 + (0.5334320651111477)
    v59 = v58 * v54
    v61 = v59 + (2.250488865813539)
    v62 = v61 * v54
    v64 = v62 + (2.8612106440066865)
    v65 = v64 * v54
    v67 = v65 + (1.3794681629043655)
    v68 = v67 * v54
    v70 = v68 + (0.2596058532893223)
    v71 = v70 * v54
    v73 = v71 + (0.015624999999999823)
    v75 = (3.278794792785737) * v54
    v77 = v75 + (49.328555418276075)
    v78 = v77 * v54
    v80 = v78 + (167.28648538571198)
    v81 = v80 * v54
    v83 = v81 + (195.37226190335065)
    v84 = v83 * v54
    v86 = v84 + (90.69722535867314)
    v87 = v86 * v54
    v89 = v87 + (16.763212110504565)
    v90 = v89 * v54
    v91 = v90 + (1.0)
    v92 = v73 / v91
    v93 = v54 * v92
    v94 = (1.0) + v93
    v95 = v52 * v94
    v97 = (1.7724538509055159) * A
    v98 = v97 * v95
    v100 = n + (0.0)
    v101 = (1.0) / v100
    return (v, t_m, t_h, n, v8, v16, v98, v100, v101)


def block_retract_radius_power_creep_t(out, t, v, t_m, t_h, n, v8, v16, v98, v100, v101, t0, t1, t2, t3, t4, m0, m1, m2, f0, f1):
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
    some116 = np.count_nonzero(m0)
    if some116:
        np.copyto(out, C0)
    if some116 != size:
        other116 = t1 if some116 else out
        np.multiply(v, t0, t2)
        np.divide(t2, v98, t2)
        np.power(t2, v101, t3)
        np.greater(t2, C0, m1)
        np.less(t2, C2, m2)
        np.bitwise_and(m1, m2, m2)
        some115 = np.count_nonzero(m2)
        if some115:
            np.power(t3, n, other116)
            np.power(t3, C0, t4)
            np.multiply(other116, t4, t4)
            np.divide(t2, t4, t4)
            np.subtract(t4, C1, t4)
            np.divide(t4, v100, t4)
            np.multiply(t3, t4, t4)
            np.add(t3, t4, other116)
        if some115 != size:
            np.copyto(other116, t3, where=~m2)
        if some116:
            np.copyto(out, other116, where=~m0)


def prepare_retract_radius_power_creep_all():
    return ()


def block_retract_radius_power_creep_all(out, t, A, n, v, v_2, t_m, t_h, E, alpha, t_0, t0, t1, t2, t3, t4, t5, t6, t7, m0, m1, m2, f0, f1):
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
    some116 = np.count_nonzero(m0)
    if some116:
        np.copyto(out, C0)
    if some116 != size:
        other116 = t3 if some116 else out
        np.multiply(v, t0, t1)
        np.multiply(n, C3, t2)
        np.add(t2, C3, t2)
        np.add(t2, C4, t4)
        np.add(t2, C3, t5)
        np.add(t2, C5, t6)
        np.multiply(t5, t6, t6)
        np.less(t2, C1, m1)
        some50 = np.count_nonzero(m1)
        if some50:
            np.add(t2, C1, t5)
            np.multiply(t2, t5, t5)
            np.divide(t5, t6, t5)
        if some50 != size:
            other50 = t7 if some50 else t5
            np.add(t2, C6, other50)
            np.divide(other50, t6, other50)
            np.subtract(C1, other50, other50)
            if some50:
                np.copyto(t5, other50, where=~m1)
        np.sqrt(t4, t6)
        np.multiply(t5, t6, t6)
        np.multiply(t4, t4, t4)
        np.divide(C1, t4, t4)
        np.multiply(C7, t4, t5)
        np.add(t5, C8, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C9, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C10, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C11, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C12, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C13, t5)
        np.multiply(C14, t4, t2)
        np.add(t2, C15, t2)
        np.multiply(t2, t4, t2)
        np.add(t2, C16, t2)
        np.multiply(t2, t4, t2)
        np.add(t2, C17, t2)
        np.multiply(t2, t4, t2)
        np.add(t2, C18, t2)
        np.multiply(t2, t4, t2)
        np.add(t2, C19, t2)
        np.multiply(t2, t4, t2)
        np.add(t2, C1, t2)
        np.divide(t5, t2, t2)
        np.multiply(t4, t2, t2)
        np.add(C1, t2, t2)
        np.multiply(t6, t2, t2)
        np.multiply(C20, A, t6)
        np.multiply(t6, t2, t2)
        np.divide(t1, t2, t2)
        np.add(n, C0, t1)
        np.divide(C1, t1, t6)
        np.power(t2, t6, t6)
        np.greater(t2, C0, m1)
        np.less(t2, C2, m2)
        np.bitwise_and(m1, m2, m2)
        some115 = np.count_nonzero(m2)
        if some115:
            np.power(t6, n, other116)
            np.power(t6, C0, t4)
            np.multiply(other116, t4, t4)
            np.divide(t2, t4, t4)
            np.subtract(t4, C1, t4)
            np.divide(t4, t1, t4)
            np.multiply(t6, t4, t4)
            np.add(t6, t4, other116)
        if some115 != size:
            np.copyto(other116, t6, where=~m2)
        if some116:
            np.copyto(out, other116, where=~m0)


def retract_radius_standard_solid(t, v, v_2, t_m, t_h, A, n, E_inf, E_1, tau):
    if t.__class__ is v.__class__ is v_2.__class__ is t_m.__class__ is t_h.__class__ is A.__class__ is n.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (v_2 > 1e-30) and (v_2 < 1e+30) and (t_m > 1e-30) and (t_m < 1e+30) and (t_h > 1e-30) and (t_h < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._retract_radius_standard_solid(t, v, v_2, t_m, t_h, A, n, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and t > t_h)) and ordinary(t, v, v_2, t_m, t_h, A, n, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_force_kelvin_voigt(t, d, A, n, E, eta):
    if t.__class__ is d.__class__ is A.__class__ is n.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            v13 = n / 2.0 + 0.5
            v15 = v13 + 1.75
            v19 = (v13 + 0.5) * (v13 + 1.5)
            v33 = 1.0 / (v15 * v15)
            v74 = (v13 * (v13 + 1.0) / v19 if v13 < 1.0 else 1.0 - (v13 + 0.75) / v19) * sqrt(v15) * (1.0 + v33 * (((((((0.01524698625788054 * v33 + 0.5334320651111477) * v33 + 2.250488865813539) * v33 + 2.8612106440066865) * v33 + 1.3794681629043655) * v33 + 0.2596058532893223) * v33 + 0.015624999999999823) / ((((((3.278794792785737 * v33 + 49.328555418276075) * v33 + 167.28648538571198) * v33 + 195.37226190335065) * v33 + 90.69722535867314) * v33 + 16.763212110504565) * v33 + 1.0)))
            v78 = d / (1.7724538509055159 * A * v74)
            v86 = n + 0.0
            v88 = pow(v78, 1.0 / v86)
            value = (E if t > 0.0 else inf) * (3.5449077018110318 * n * A / (n + 1.0) * v74 * v78 * (v88 + v88 * ((v78 / (pow(v88, n) * pow(v88, 0.0)) - 1.0) / v86) if v78 > 0.0 and v78 < inf else v88))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_kelvin_voigt_t(d, A, n, E, eta):
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
    v76 = v75 * v73
    v77 = d / v76
    v79 = (3.5449077018110318) * n
    v80 = v79 * A
    v81 = n + (1.0)
    v82 = v80 / v81
    v83 = v82 * v73
    v84 = v83 * v77
    v85 = n + (0.0)
    v86 = (1.0) / v85
    v87 = np.power(v77, v86)
    v88 = np.greater(v77, (0.0))
    v89 = np.less(v77, (np.inf))
    v90 = np.bitwise_and(v88, v89)
    v91 = np.power(v87, n)
    v92 = np.power(v87, (0.0))
    v93 = v91 * v92
    v94 = v77 / v93
    v95 = v94 - (1.0)
    v96 = v95 / v85
    v97 = v87 * v96
    v98 = v87 + v97
    v99 = v98 if v90 else v87
    v100 = v84 * v99
    return (E, v100)


def block_step_force_kelvin_voigt_t(out, t, E, v100, m0):
    size = out.size
    np.greater(t, C0, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some8 = np.count_nonzero(m0)
    if some8:
        np.copyto(out, E)
    if some8 != size:
        np.copyto(out, C2, where=~m0)
    np.multiply(out, v100, out)


def prepare_step_force_kelvin_voigt_all():
    return ()


def block_step_force_kelvin_voigt_all(out, t, d, A, n, E, eta, t0, t1, t2, t3, t4, t5, m0, m1):
    size = out.size
    np.greater(t, C0, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some8 = np.count_nonzero(m0)
    if some8:
        np.copyto(out, E)
    if some8 != size:
        np.copyto(out, C2, where=~m0)
    np.multiply(n, C3, t0)
    np.add(t0, C3, t0)
    np.add(t0, C4, t1)
    np.add(t0, C3, t2)
    np.add(t0, C5, t3)
    np.multiply(t2, t3, t3)
    np.less(t0, C1, m0)
    some28 = np.count_nonzero(m0)
    if some28:
        np.add(t0, C1, t2)
        np.multiply(t0, t2, t2)
        np.divide(t2, t3, t2)
    if some28 != size:
        other28 = t4 if some28 else t2
        np.add(t0, C6, other28)
        np.divide(other28, t3, other28)
        np.subtract(C1, other28, other28)
        if some28:
            np.copyto(t2, other28, where=~m0)
    np.sqrt(t1, t3)
    np.multiply(t2, t3, t3)
    np.multiply(t1, t1, t1)
    np.divide(C1, t1, t1)
    np.multiply(C7, t1, t2)
    np.add(t2, C8, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C9, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C10, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C11, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C12, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C13, t2)
    np.multiply(C14, t1, t0)
    np.add(t0, C15, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C16, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C17, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C18, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C19, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C1, t0)
    np.divide(t2, t0, t0)
    np.multiply(t1, t0, t0)
    np.add(C1, t0, t0)
    np.multiply(t3, t0, t0)
    np.multiply(C20, A, t3)
    np.multiply(t3, t0, t3)
    np.divide(d, t3, t3)
    np.multiply(C21, n, t1)
    np.multiply(t1, A, t1)
    np.add(n, C1, t2)
    np.divide(t1, t2, t2)
    np.multiply(t2, t0, t0)
    np.multiply(t0, t3, t0)
    np.add(n, C0, t2)
    np.divide(C1, t2, t1)
    np.power(t3, t1, t1)
    np.greater(t3, C0, m0)
    np.less(t3, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some99 = np.count_nonzero(m1)
    if some99:
        np.power(t1, n, t4)
        np.power(t1, C0, t5)
        np.multiply(t4, t5, t5)
        np.divide(t3, t5, t5)
        np.subtract(t5, C1, t5)
        np.divide(t5, t2, t5)
        np.multiply(t1, t5, t5)
        np.add(t1, t5, t4)
    if some99 != size:
        np.copyto(t4, t1, where=~m1)
    np.multiply(t0, t4, t4)
    np.multiply(out, t4, out)


def step_force_maxwell(t, d, A, n, E, tau):
    if t.__class__ is d.__class__ is A.__class__ is n.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            v13 = n / 2.0 + 0.5
            v15 = v13 + 1.75
            v19 = (v13 + 0.5) * (v13 + 1.5)
            v33 = 1.0 / (v15 * v15)
            v74 = (v13 * (v13 + 1.0) / v19 if v13 < 1.0 else 1.0 - (v13 + 0.75) / v19) * sqrt(v15) * (1.0 + v33 * (((((((0.01524698625788054 * v33 + 0.5334320651111477) * v33 + 2.250488865813539) * v33 + 2.8612106440066865) * v33 + 1.3794681629043655) * v33 + 0.2596058532893223) * v33 + 0.015624999999999823) / ((((((3.278794792785737 * v33 + 49.328555418276075) * v33 + 167.28648538571198) * v33 + 195.37226190335065) * v33 + 90.69722535867314) * v33 + 16.763212110504565) * v33 + 1.0)))
            v78 = d / (1.7724538509055159 * A * v74)
            v87 = n + 0.0
            v89 = pow(v78, 1.0 / v87)
            value = E * exp(-t / tau) * (3.5449077018110318 * n * A / (n + 1.0) * v74 * v78 * (v89 + v89 * ((v78 / (pow(v89, n) * pow(v89, 0.0)) - 1.0) / v87) if v78 > 0.0 and v78 < inf else v89))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_maxwell_t(d, A, n, E, tau):
    v11 = n / (2.0)
    v13 = v11 + (0.5)
    v15 = v13 + (1.75)
    v16 = v13 + (0.5)
    v18 = v13 + (1.5)
    v19 = v16 * v18
    v21 = np.less(v13, (1.0))
    v22 = v13 + (1.0)
    v23 = v13 * v22
    v24 = v23 / v19
    v26 = v13 + (0.75)
    v27 = v26 / v19
    v28 = (1.0) - v27
    v29 = v24 if v21 else v28
    v30 = np.sqrt(v15)
    v31 = v29 * v30
    v32 = v15 * v15
    v33 = (1.0) / v32
    v35 = (0.01524698625788054) * v33
    v37 = v35 + (0.5334320651111477)
    v38 = v37 * v33
    v40 = v38 + (2.250488865813539)
    v41 = v40 * v33
    v43 = v41 + (2.8612106440066865)
    v44 = v43 * v33
    v46 = v44 + (1.3794681629043655)
    v47 = v46 * v33
    v49 = v47 + (0.2596058532893223)
    v50 = v49 * v33
    v52 = v50 + (0.015624999999999823)
    v54 = (3.278794792785737) * v33
    v56 = v54 + (49.328555418276075)
    v57 = v56 * v33
    v59 = v57 + (167.28648538571198)
    v60 = v59 * v33
    v62 = v60 + (195.37226190335065)
    v63 = v62 * v33
    v65 = v63 + (90.69722535867314)
    v66 = v65 * v33
    v68 = v66 + (16.763212110504565)
    v69 = v68 * v33
    v70 = v69 + (1.0)
    v71 = v52 / v70
    v72 = v33 * v71
    v73 = (1.0) + v72
    v74 = v31 * v73
    v76 = (1.7724538509055159) * A
    v77 = v76 * v74
    v78 = d / v77
    v80 = (3.5449077018110318) * n
    v81 = v80 * A
    v82 = n + (1.0)
    v83 = v81 / v82
    v84 = v83 * v74
    v85 = v84 * v78
    v87 = n + (0.0)
    v88 = (1.0) / v87
    v89 = np.power(v78, v88)
    v90 = np.greater(v78, (0.0))
    v92 = np.less(v78, (np.inf))
    v93 = np.bitwise_and(v90, v92)
    v94 = np.power(v89, n)
    v95 = np.power(v89, (0.0))
    v96 = v94 * v95
    v97 = v78 / v96
    v98 = v97 - (1.0)
    v99 = v98 / v87
    v100 = v89 * v99
    v101 = v89 + v100
    v102 = v101 if v93 else v89
    v103 = v85 * v102
    return (E, tau, v103)


def block_step_force_maxwell_t(out, t, E, tau, v103):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E, out, out)
    np.multiply(out, v103, out)


def prepare_step_force_maxwell_all():
    return ()


def block_step_force_maxwell_all(out, t, d, A, n, E, tau, t0, t1, t2, t3, t4, t5, m0, m1):
    size = out.size
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E, out, out)
    np.multiply(n, C3, t0)
    np.add(t0, C3, t0)
    np.add(t0, C4, t1)
    np.add(t0, C3, t2)
    np.add(t0, C5, t3)
    np.multiply(t2, t3, t3)
    np.less(t0, C1, m0)
    some29 = np.count_nonzero(m0)
    if some29:
        np.add(t0, C1, t2)
        np.multiply(t0, t2, t2)
        np.divide(t2, t3, t2)
    if some29 != size:
        other29 = t4 if some29 else t2
        np.add(t0, C6, other29)
        np.divide(other29, t3, other29)
        np.subtract(C1, other29, other29)
        if some29:
            np.copyto(t2, other29, where=~m0)
    np.sqrt(t1, t3)
    np.multiply(t2, t3, t3)
    np.multiply(t1, t1, t1)
    np.divide(C1, t1, t1)
    np.multiply(C7, t1, t2)
    np.add(t2, C8, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C9, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C10, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C11, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C12, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C13, t2)
    np.multiply(C14, t1, t0)
    np.add(t0, C15, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C16, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C17, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C18, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C19, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C1, t0)
    np.divide(t2, t0, t0)
    np.multiply(t1, t0, t0)
    np.add(C1, t0, t0)
    np.multiply(t3, t0, t0)
    np.multiply(C20, A, t3)
    np.multiply(t3, t0, t3)
    np.divide(d, t3, t3)
    np.multiply(C21, n, t1)
    np.multiply(t1, A, t1)
    np.add(n, C1, t2)
    np.divide(t1, t2, t2)
    np.multiply(t2, t0, t0)
    np.multiply(t0, t3, t0)
    np.add(n, C0, t2)
    np.divide(C1, t2, t1)
    np.power(t3, t1, t1)
    np.greater(t3, C0, m0)
    np.less(t3, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some102 = np.count_nonzero(m1)
    if some102:
        np.power(t1, n, t4)
        np.power(t1, C0, t5)
        np.multiply(t4, t5, t5)
        np.divide(t3, t5, t5)
        np.subtract(t5, C1, t5)
        np.divide(t5, t2, t5)
        np.multiply(t1, t5, t5)
        np.add(t1, t5, t4)
    if some102 != size:
        np.copyto(t4, t1, where=~m1)
    np.multiply(t0, t4, t4)
    np.multiply(out, t4, out)


def step_force_power_creep(t, d, A, n, E, alpha, t_0):
    if t.__class__ is d.__class__ is A.__class__ is n.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            v11 = 3.141592653589793 * alpha
            v18 = n / 2.0 + 0.5
            v20 = v18 + 1.75
            v24 = (v18 + 0.5) * (v18 + 1.5)
            v38 = 1.0 / (v20 * v20)
            v79 = (v18 * (v18 + 1.0) / v24 if v18 < 1.0 else 1.0 - (v18 + 0.75) / v24) * sqrt(v20) * (1.0 + v38 * (((((((0.01524698625788054 * v38 + 0.5334320651111477) * v38 + 2.250488865813539) * v38 + 2.8612106440066865) * v38 + 1.3794681629043655) * v38 + 0.2596058532893223) * v38 + 0.015624999999999823) / ((((((3.278794792785737 * v38 + 49.328555418276075) * v38 + 167.28648538571198) * v38 + 195.37226190335065) * v38 + 90.69722535867314) * v38 + 16.763212110504565) * v38 + 1.0)))
            v83 = d / (1.7724538509055159 * A * v79)
            v92 = n + 0.0
            v94 = pow(v83, 1.0 / v92)
            value = E * pow(t_0 / t, alpha) * sin(v11) / v11 * (3.5449077018110318 * n * A / (n + 1.0) * v79 * v83 * (v94 + v94 * ((v83 / (pow(v94, n) * pow(v94, 0.0)) - 1.0) / v92) if v83 > 0.0 and v83 < inf else v94))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_power_creep_t(d, A, n, E, alpha, t_0):
    v11 = (3.141592653589793) * alpha
    v12 = np.sin(v11)
    v16 = n / (2.0)
    v18 = v16 + (0.5)
    v20 = v18 + (1.75)
    v21 = v18 + (0.5)
    v23 = v18 + (1.5)
    v24 = v21 * v23
    v26 = np.less(v18, (1.0))
    v27 = v18 + (1.0)
    v28 = v18 * v27
    v29 = v28 / v24
    v31 = v18 + (0.75)
    v32 = v31 / v24
    v33 = (1.0) - v32
    v34 = v29 if v26 else v33
    v35 = np.sqrt(v20)
    v36 = v34 * v35
    v37 = v20 * v20
    v38 = (1.0) / v37
    v40 = (0.01524698625788054) * v38
    v42 = v40 + (0.5334320651111477)
    v43 = v42 * v38
    v45 = v43 + (2.250488865813539)
    v46 = v45 * v38
    v48 = v46 + (2.8612106440066865)
    v49 = v48 * v38
    v51 = v49 + (1.3794681629043655)
    v52 = v51 * v38
    v54 = v52 + (0.2596058532893223)
    v55 = v54 * v38
    v57 = v55 + (0.015624999999999823)
    v59 = (3.278794792785737) * v38
    v61 = v59 + (49.328555418276075)
    v62 = v61 * v38
    v64 = v62 + (167.28648538571198)
    v65 = v64 * v38
    v67 = v65 + (195.37226190335065)
    v68 = v67 * v38
    v70 = v68 + (90.69722535867314)
    v71 = v70 * v38
    v73 = v71 + (16.763212110504565)
    v74 = v73 * v38
    v75 = v74 + (1.0)
    v76 = v57 / v75
    v77 = v38 * v76
    v78 = (1.0) + v77
    v79 = v36 * v78
    v81 = (1.7724538509055159) * A
    v82 = v81 * v79
    v83 = d / v82
    v85 = (3.5449077018110318) * n
    v86 = v85 * A
    v87 = n + (1.0)
    v88 = v86 / v87
    v89 = v88 * v79
    v90 = v89 * v83
    v92 = n + (0.0)
    v93 = (1.0) / v92
    v94 = np.power(v83, v93)
    v95 = np.greater(v83, (0.0))
    v97 = np.less(v83, (np.inf))
    v98 = np.bitwise_and(v95, v97)
    v99 = np.power(v94, n)
    v100 = np.power(v94, (0.0))
    v101 = v99 * v100
    v102 = v83 / v101
    v103 = v102 - (1.0)
    v104 = v103 / v92
    v105 = v94 * v104
    v106 = v94 + v105
    v107 = v106 if v98 else v94
    v108 = v90 * v107
    return (E, alpha, t_0, v11, v12, v108)


def block_step_force_power_creep_t(out, t, E, alpha, t_0, v11, v12, v108):
    np.divide(t_0, t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.power(out, alpha, out)
    np.multiply(E, out, out)
    np.multiply(out, v12, out)
    np.divide(out, v11, out)
    np.multiply(out, v108, out)


def prepare_step_force_power_creep_all():
    return ()


def block_step_force_power_creep_all(out, t, d, A, n, E, alpha, t_0, t0, t1, t2, t3, t4, t5, m0, m1):
    size = out.size
    np.divide(t_0, t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.power(out, alpha, out)
    np.multiply(E, out, out)
    np.multiply(C22, alpha, t0)
    np.sin(t0, t1)
    np.multiply(out, t1, t1)
    np.divide(t1, t0, t0)
    np.multiply(n, C3, t1)
    np.add(t1, C3, t1)
    np.add(t1, C4, out)
    np.add(t1, C3, t2)
    np.add(t1, C5, t3)
    np.multiply(t2, t3, t3)
    np.less(t1, C1, m0)
    some34 = np.count_nonzero(m0)
    if some34:
        np.add(t1, C1, t2)
        np.multiply(t1, t2, t2)
        np.divide(t2, t3, t2)
    if some34 != size:
        other34 = t4 if some34 else t2
        np.add(t1, C6, other34)
        np.divide(other34, t3, other34)
        np.subtract(C1, other34, other34)
        if some34:
            np.copyto(t2, other34, where=~m0)
    np.sqrt(out, t3)
    np.multiply(t2, t3, t3)
    np.multiply(out, out, out)
    np.divide(C1, out, out)
    np.multiply(C7, out, t2)
    np.add(t2, C8, t2)
    np.multiply(t2, out, t2)
    np.add(t2, C9, t2)
    np.multiply(t2, out, t2)
    np.add(t2, C10, t2)
    np.multiply(t2, out, t2)
    np.add(t2, C11, t2)
    np.multiply(t2, out, t2)
    np.add(t2, C12, t2)
    np.multiply(t2, out, t2)
    np.add(t2, C13, t2)
    np.multiply(C14, out, t1)
    np.add(t1, C15, t1)
    np.multiply(t1, out, t1)
    np.add(t1, C16, t1)
    np.multiply(t1, out, t1)
    np.add(t1, C17, t1)
    np.multiply(t1, out, t1)
    np.add(t1, C18, t1)
    np.multiply(t1, out, t1)
    np.add(t1, C19, t1)
    np.multiply(t1, out, t1)
    np.add(t1, C1, t1)
    np.divide(t2, t1, t1)
    np.multiply(out, t1, t1)
    np.add(C1, t1, t1)
    np.multiply(t3, t1, t1)
    np.multiply(C20, A, t3)
    np.multiply(t3, t1, t3)
    np.divide(d, t3, t3)
    np.multiply(C21, n, out)
    np.multiply(out, A, out)
    np.add(n, C1, t2)
    np.divide(out, t2, t2)
    np.multiply(t2, t1, t1)
    np.multiply(t1, t3, t1)
    np.add(n, C0, t2)
    np.divide(C1, t2, out)
    np.power(t3, out, out)
    np.greater(t3, C0, m0)
    np.less(t3, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some107 = np.count_nonzero(m1)
    if some107:
        np.power(out, n, t4)
        np.power(out, C0, t5)
        np.multiply(t4, t5, t5)
        np.divide(t3, t5, t5)
        np.subtract(t5, C1, t5)
        np.divide(t5, t2, t5)
        np.multiply(out, t5, t5)
        np.add(out, t5, t4)
    if some107 != size:
        np.copyto(t4, out, where=~m1)
    np.multiply(t1, t4, t4)
    np.multiply(t0, t4, out)


def step_force_standard_solid(t, d, A, n, E_inf, E_1, tau):
    if t.__class__ is d.__class__ is A.__class__ is n.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            v15 = n / 2.0 + 0.5
            v17 = v15 + 1.75
            v21 = (v15 + 0.5) * (v15 + 1.5)
            v35 = 1.0 / (v17 * v17)
            v76 = (v15 * (v15 + 1.0) / v21 if v15 < 1.0 else 1.0 - (v15 + 0.75) / v21) * sqrt(v17) * (1.0 + v35 * (((((((0.01524698625788054 * v35 + 0.5334320651111477) * v35 + 2.250488865813539) * v35 + 2.8612106440066865) * v35 + 1.3794681629043655) * v35 + 0.2596058532893223) * v35 + 0.015624999999999823) / ((((((3.278794792785737 * v35 + 49.328555418276075) * v35 + 167.28648538571198) * v35 + 195.37226190335065) * v35 + 90.69722535867314) * v35 + 16.763212110504565) * v35 + 1.0)))
            v80 = d / (1.7724538509055159 * A * v76)
            v89 = n + 0.0
            v91 = pow(v80, 1.0 / v89)
            value = (E_inf + E_1 * exp(-t / tau)) * (3.5449077018110318 * n * A / (n + 1.0) * v76 * v80 * (v91 + v91 * ((v80 / (pow(v91, n) * pow(v91, 0.0)) - 1.0) / v89) if v80 > 0.0 and v80 < inf else v91))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_standard_solid_t(d, A, n, E_inf, E_1, tau):
    v13 = n / (2.0)
    v15 = v13 + (0.5)
    v17 = v15 + (1.75)
    v18 = v15 + (0.5)
    v20 = v15 + (1.5)
    v21 = v18 * v20
    v23 = np.less(v15, (1.0))
    v24 = v15 + (1.0)
    v25 = v15 * v24
    v26 = v25 / v21
    v28 = v15 + (0.75)
    v29 = v28 / v21
    v30 = (1.0) - v29
    v31 = v26 if v23 else v30
    v32 = np.sqrt(v17)
    v33 = v31 * v32
    v34 = v17 * v17
    v35 = (1.0) / v34
    v37 = (0.01524698625788054) * v35
    v39 = v37 + (0.5334320651111477)
    v40 = v39 * v35
    v42 = v40 + (2.250488865813539)
    v43 = v42 * v35
    v45 = v43 + (2.8612106440066865)
    v46 = v45 * v35
    v48 = v46 + (1.3794681629043655)
    v49 = v48 * v35
    v51 = v49 + (0.2596058532893223)
    v52 = v51 * v35
    v54 = v52 + (0.015624999999999823)
    v56 = (3.278794792785737) * v35
    v58 = v56 + (49.328555418276075)
    v59 = v58 * v35
    v61 = v59 + (167.28648538571198)
    v62 = v61 * v35
    v64 = v62 + (195.37226190335065)
    v65 = v64 * v35
    v67 = v65 + (90.69722535867314)
    v68 = v67 * v35
    v70 = v68 + (16.763212110504565)
    v71 = v70 * v35
    v72 = v71 + (1.0)
    v73 = v54 / v72
    v74 = v35 * v73
    v75 = (1.0) + v74
    v76 = v33 * v75
    v78 = (1.7724538509055159) * A
    v79 = v78 * v76
    v80 = d / v79
    v82 = (3.5449077018110318) * n
    v83 = v82 * A
    v84 = n + (1.0)
    v85 = v83 / v84
    v86 = v85 * v76
    v87 = v86 * v80
    v89 = n + (0.0)
    v90 = (1.0) / v89
    v91 = np.power(v80, v90)
    v92 = np.greater(v80, (0.0))
    v94 = np.less(v80, (np.inf))
    v95 = np.bitwise_and(v92, v94)
    v96 = np.power(v91, n)
    v97 = np.power(v91, (0.0))
    v98 = v96 * v97
    v99 = v80 / v98
    v100 = v99 - (1.0)
    v101 = v100 / v89
    v102 = v91 * v101
    v103 = v91 + v102
    v104 = v103 if v95 else v91
    v105 = v87 * v104
    return (E_inf, E_1, tau, v105)


def block_step_force_standard_solid_t(out, t, E_inf, E_1, tau, v105):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E_1, out, out)
    np.add(E_inf, out, out)
    np.multiply(out, v105, out)


def prepare_step_force_standard_solid_all():
    return ()


def block_step_force_standard_solid_all(out, t, d, A, n, E_inf, E_1, tau, t0, t1, t2, t3, t4, t5, m0, m1):
    size = out.size
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E_1, out, out)
    np.add(E_inf, out, out)
    np.multiply(n, C3, t0)
    np.add(t0, C3, t0)
    np.add(t0, C4, t1)
    np.add(t0, C3, t2)
    np.add(t0, C5, t3)
    np.multiply(t2, t3, t3)
    np.less(t0, C1, m0)
    some31 = np.count_nonzero(m0)
    if some31:
        np.add(t0, C1, t2)
        np.multiply(t0, t2, t2)
        np.divide(t2, t3, t2)
    if some31 != size:
        other31 = t4 if some31 else t2
        np.add(t0, C6, other31)
        np.divide(other31, t3, other31)
        np.subtract(C1, other31, other31)
        if some31:
            np.copyto(t2, other31, where=~m0)
    np.sqrt(t1, t3)
    np.multiply(t2, t3, t3)
    np.multiply(t1, t1, t1)
    np.divide(C1, t1, t1)
    np.multiply(C7, t1, t2)
    np.add(t2, C8, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C9, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C10, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C11, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C12, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C13, t2)
    np.multiply(C14, t1, t0)
    np.add(t0, C15, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C16, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C17, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C18, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C19, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C1, t0)
    np.divide(t2, t0, t0)
    np.multiply(t1, t0, t0)
    np.add(C1, t0, t0)
    np.multiply(t3, t0, t0)
    np.multiply(C20, A, t3)
    np.multiply(t3, t0, t3)
    np.divide(d, t3, t3)
    np.multiply(C21, n, t1)
    np.multiply(t1, A, t1)
    np.add(n, C1, t2)
    np.divide(t1, t2, t2)
    np.multiply(t2, t0, t0)
    np.multiply(t0, t3, t0)
    np.add(n, C0, t2)
    np.divide(C1, t2, t1)
    np.power(t3, t1, t1)
    np.greater(t3, C0, m0)
    np.less(t3, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some104 = np.count_nonzero(m1)
    if some104:
        np.power(t1, n, t4)
        np.power(t1, C0, t5)
        np.multiply(t4, t5, t5)
        np.divide(t3, t5, t5)
        np.subtract(t5, C1, t5)
        np.divide(t5, t2, t5)
        np.multiply(t1, t5, t5)
        np.add(t1, t5, t4)
    if some104 != size:
        np.copyto(t4, t1, where=~m1)
    np.multiply(t0, t4, t4)
    np.multiply(out, t4, out)


def step_load_radius_kelvin_voigt(t, F, A, n, E, eta):
    if t.__class__ is F.__class__ is A.__class__ is n.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            v16 = n / 2.0 + 0.5
            v18 = v16 + 1.75
            v22 = (v16 + 0.5) * (v16 + 1.5)
            v36 = 1.0 / (v18 * v18)
            v78 = n + 1.0
            v84 = v78 * (F * (-expm1(-E * t / eta) / E)) / (3.5449077018110318 * n * A * ((v16 * (v16 + 1.0) / v22 if v16 < 1.0 else 1.0 - (v16 + 0.75) / v22) * sqrt(v18) * (1.0 + v36 * (((((((0.01524698625788054 * v36 + 0.5334320651111477) * v36 + 2.250488865813539) * v36 + 2.8612106440066865) * v36 + 1.3794681629043655) * v36 + 0.2596058532893223) * v36 + 0.015624999999999823) / ((((((3.278794792785737 * v36 + 49.328555418276075) * v36 + 167.28648538571198) * v36 + 195.37226190335065) * v36 + 90.69722535867314) * v36 + 16.763212110504565) * v36 + 1.0)))))
            v86 = pow(v84, 1.0 / v78)
            if v84 > 0.0 and v84 < inf:
                value = v86 + v86 * ((v84 / (pow(v86, n) * pow(v86, 1.0)) - 1.0) / v78)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            value = v86
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_load_radius_kelvin_voigt_t(F, A, n, E, eta):
    v6 = np.negative(E)
    v14 = n / (2.0)
    v16 = v14 + (0.5)
    v18 = v16 + (1.75)
    v19 = v16 + (0.5)
    v21 = v16 + (1.5)
    v22 = v19 * v21
    v24 = np.less(v16, (1.0))
    v25 = v16 + (1.0)
    v26 = v16 * v25
    v27 = v26 / v22
    v29 = v16 + (0.75)
    v30 = v29 / v22
    v31 = (1.0) - v30
    v32 = v27 if v24 else v31
    v33 = np.sqrt(v18)
    v34 = v32 * v33
    v35 = v18 * v18
    v36 = (1.0) / v35
    v38 = (0.01524698625788054) * v36
    v40 = v38 + (0.5334320651111477)
    v41 = v40 * v36
    v43 = v41 + (2.250488865813539)
    v44 = v43 * v36
    v46 = v44 + (2.8612106440066865)
    v47 = v46 * v36
    v49 = v47 + (1.3794681629043655)
    v50 = v49 * v36
    v52 = v50 + (0.2596058532893223)
    v53 = v52 * v36
    v55 = v53 + (0.015624999999999823)
    v57 = (3.278794792785737) * v36
    v59 = v57 + (49.328555418276075)
    v60 = v59 * v36
    v62 = v60 + (167.28648538571198)
    v63 = v62 * v36
    v65 = v63 + (195.37226190335065)
    v66 = v65 * v36
    v68 = v66 + (90.69722535867314)
    v69 = v68 * v36
    v71 = v69 + (16.763212110504565)
    v72 = v71 * v36
    v73 = v72 + (1.0)
    v74 = v55 / v73
    v75 = v36 * v74
    v76 = (1.0) + v75
    v77 = v34 * v76
    v78 = n + (1.0)
    v81 = (3.5449077018110318) * n
    v82 = v81 * A
    v83 = v82 * v77
    v85 = (1.0) / v78
    return (F, n, E, eta, v6, v78, v83, v85)


def block_step_load_radius_kelvin_voigt_t(out, t, F, n, E, eta, v6, v78, v83, v85, t0, t1, t2, m0, m1):
    size = out.size
    np.multiply(v6, t, t0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(t0, eta, t0)
    np.expm1(t0, t0)
    np.negative(t0, t0)
    np.divide(t0, E, t0)
    np.multiply(F, t0, t0)
    np.multiply(v78, t0, t0)
    np.divide(t0, v83, t0)
    np.power(t0, v85, t1)
    np.greater(t0, C0, m0)
    np.less(t0, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some100 = np.count_nonzero(m1)
    if some100:
        np.power(t1, n, out)
        np.power(t1, C1, t2)
        np.multiply(out, t2, t2)
        np.divide(t0, t2, t2)
        np.subtract(t2, C1, t2)
        np.divide(t2, v78, t2)
        np.multiply(t1, t2, t2)
        np.add(t1, t2, out)
    if some100 != size:
        np.copyto(out, t1, where=~m1)


def prepare_step_load_radius_kelvin_voigt_all():
    return ()


def block_step_load_radius_kelvin_voigt_all(out, t, F, A, n, E, eta, t0, t1, t2, t3, t4, t5, m0, m1):
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
    np.multiply(n, C3, t1)
    np.add(t1, C3, t1)
    np.add(t1, C4, t2)
    np.add(t1, C3, t3)
    np.add(t1, C5, t4)
    np.multiply(t3, t4, t4)
    np.less(t1, C1, m0)
    some32 = np.count_nonzero(m0)
    if some32:
        np.add(t1, C1, t3)
        np.multiply(t1, t3, t3)
        np.divide(t3, t4, t3)
    if some32 != size:
        other32 = t5 if some32 else t3
        np.add(t1, C6, other32)
        np.divide(other32, t4, other32)
        np.subtract(C1, other32, other32)
        if some32:
            np.copyto(t3, other32, where=~m0)
    np.sqrt(t2, t4)
    np.multiply(t3, t4, t4)
    np.multiply(t2, t2, t2)
    np.divide(C1, t2, t2)
    np.multiply(C7, t2, t3)
    np.add(t3, C8, t3)
    np.multiply(t3, t2, t3)
    np.add(t3, C9, t3)
    np.multiply(t3, t2, t3)
    np.add(t3, C10, t3)
    np.multiply(t3, t2, t3)
    np.add(t3, C11, t3)
    np.multiply(t3, t2, t3)
    np.add(t3, C12, t3)
    np.multiply(t3, t2, t3)
    np.add(t3, C13, t3)
    np.multiply(C14, t2, t1)
    np.add(t1, C15, t1)
    np.multiply(t1, t2, t1)
    np.add(t1, C16, t1)
    np.multiply(t1, t2, t1)
    np.add(t1, C17, t1)
    np.multiply(t1, t2, t1)
    np.add(t1, C18, t1)
    np.multiply(t1, t2, t1)
    np.add(t1, C19, t1)
    np.multiply(t1, t2, t1)
    np.add(t1, C1, t1)
    np.divide(t3, t1, t1)
    np.multiply(t2, t1, t1)
    np.add(C1, t1, t1)
    np.multiply(t4, t1, t1)
    np.add(n, C1, t4)
    np.multiply(t4, t0, t0)
    np.multiply(C21, n, t2)
    np.multiply(t2, A, t2)
    np.multiply(t2, t1, t1)
    np.divide(t0, t1, t1)
    np.divide(C1, t4, t0)
    np.power(t1, t0, t0)
    np.greater(t1, C0, m0)
    np.less(t1, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some100 = np.count_nonzero(m1)
    if some100:
        np.power(t0, n, out)
        np.power(t0, C1, t2)
        np.multiply(out, t2, t2)
        np.divide(t1, t2, t2)
        np.subtract(t2, C1, t2)
        np.divide(t2, t4, t2)
        np.multiply(t0, t2, t2)
        np.add(t0, t2, out)
    if some100 != size:
        np.copyto(out, t0, where=~m1)


def step_load_radius_maxwell(t, F, A, n, E, tau):
    if t.__class__ is F.__class__ is A.__class__ is n.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            v14 = n / 2.0 + 0.5
            v16 = v14 + 1.75
            v20 = (v14 + 0.5) * (v14 + 1.5)
            v33 = 1.0 / (v16 * v16)
            v75 = n + 1.0
            v81 = v75 * (F * ((1.0 + t / tau) / E)) / (3.5449077018110318 * n * A * ((v14 * (v14 + 1.0) / v20 if v14 < 1.0 else 1.0 - (v14 + 0.75) / v20) * sqrt(v16) * (1.0 + v33 * (((((((0.01524698625788054 * v33 + 0.5334320651111477) * v33 + 2.250488865813539) * v33 + 2.8612106440066865) * v33 + 1.3794681629043655) * v33 + 0.2596058532893223) * v33 + 0.015624999999999823) / ((((((3.278794792785737 * v33 + 49.328555418276075) * v33 + 167.28648538571198) * v33 + 195.37226190335065) * v33 + 90.69722535867314) * v33 + 16.763212110504565) * v33 + 1.0)))))
            v83 = pow(v81, 1.0 / v75)
            if v81 > 0.0 and v81 < inf:
                value = v83 + v83 * ((v81 / (pow(v83, n) * pow(v83, 1.0)) - 1.0) / v75)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            value = v83
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_load_radius_maxwell_t(F, A, n, E, tau):
    v12 = n / (2.0)
    v14 = v12 + (0.5)
    v16 = v14 + (1.75)
    v17 = v14 + (0.5)
    v19 = v14 + (1.5)
    v20 = v17 * v19
    v21 = np.less(v14, (1.0))
    v22 = v14 + (1.0)
    v23 = v14 * v22
    v24 = v23 / v20
    v26 = v14 + (0.75)
    v27 = v26 / v20
    v28 = (1.0) - v27
    v29 = v24 if v21 else v28
    v30 = np.sqrt(v16)
    v31 = v29 * v30
    v32 = v16 * v16
    v33 = (1.0) / v32
    v35 = (0.01524698625788054) * v33
    v37 = v35 + (0.5334320651111477)
    v38 = v37 * v33
    v40 = v38 + (2.250488865813539)
    v41 = v40 * v33
    v43 = v41 + (2.8612106440066865)
    v44 = v43 * v33
    v46 = v44 + (1.3794681629043655)
    v47 = v46 * v33
    v49 = v47 + (0.2596058532893223)
    v50 = v49 * v33
    v52 = v50 + (0.015624999999999823)
    v54 = (3.278794792785737) * v33
    v56 = v54 + (49.328555418276075)
    v57 = v56 * v33
    v59 = v57 + (167.28648538571198)
    v60 = v59 * v33
    v62 = v60 + (195.37226190335065)
    v63 = v62 * v33
    v65 = v63 + (90.69722535867314)
    v66 = v65 * v33
    v68 = v66 + (16.763212110504565)
    v69 = v68 * v33
    v70 = v69 + (1.0)
    v71 = v52 / v70
    v72 = v33 * v71
    v73 = (1.0) + v72
    v74 = v31 * v73
    v75 = n + (1.0)
    v78 = (3.5449077018110318) * n
    v79 = v78 * A
    v80 = v79 * v74
    v82 = (1.0) / v75
    return (F, n, E, tau, v75, v80, v82)


def block_step_load_radius_maxwell_t(out, t, F, n, E, tau, v75, v80, v82, t0, t1, t2, m0, m1):
    size = out.size
    np.divide(t, tau, t0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.add(C1, t0, t0)
    np.divide(t0, E, t0)
    np.multiply(F, t0, t0)
    np.multiply(v75, t0, t0)
    np.divide(t0, v80, t0)
    np.power(t0, v82, t1)
    np.greater(t0, C0, m0)
    np.less(t0, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some97 = np.count_nonzero(m1)
    if some97:
        np.power(t1, n, out)
        np.power(t1, C1, t2)
        np.multiply(out, t2, t2)
        np.divide(t0, t2, t2)
        np.subtract(t2, C1, t2)
        np.divide(t2, v75, t2)
        np.multiply(t1, t2, t2)
        np.add(t1, t2, out)
    if some97 != size:
        np.copyto(out, t1, where=~m1)


def prepare_step_load_radius_maxwell_all():
    return ()


def block_step_load_radius_maxwell_all(out, t, F, A, n, E, tau, t0, t1, t2, t3, t4, t5, m0, m1):
    size = out.size
    np.divide(t, tau, t0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.add(C1, t0, t0)
    np.divide(t0, E, t0)
    np.multiply(F, t0, t0)
    np.multiply(n, C3, t1)
    np.add(t1, C3, t1)
    np.add(t1, C4, t2)
    np.add(t1, C3, t3)
    np.add(t1, C5, t4)
    np.multiply(t3, t4, t4)
    np.less(t1, C1, m0)
    some29 = np.count_nonzero(m0)
    if some29:
        np.add(t1, C1, t3)
        np.multiply(t1, t3, t3)
        np.divide(t3, t4, t3)
    if some29 != size:
        other29 = t5 if some29 else t3
        np.add(t1, C6, other29)
        np.divide(other29, t4, other29)
        np.subtract(C1, other29, other29)
        if some29:
            np.copyto(t3, other29, where=~m0)
    np.sqrt(t2, t4)
    np.multiply(t3, t4, t4)
    np.multiply(t2, t2, t2)
    np.divide(C1, t2, t2)
    np.multiply(C7, t2, t3)
    np.add(t3, C8, t3)
    np.multiply(t3, t2, t3)
    np.add(t3, C9, t3)
    np.multiply(t3, t2, t3)
    np.add(t3, C10, t3)
    np.multiply(t3, t2, t3)
    np.add(t3, C11, t3)
    np.multiply(t3, t2, t3)
    np.add(t3, C12, t3)
    np.multiply(t3, t2, t3)
    np.add(t3, C13, t3)
    np.multiply(C14, t2, t1)
    np.add(t1, C15, t1)
    np.multiply(t1, t2, t1)
    np.add(t1, C16, t1)
    np.multiply(t1, t2, t1)
    np.add(t1, C17, t1)
    np.multiply(t1, t2, t1)
    np.add(t1, C18, t1)
    np.multiply(t1, t2, t1)
    np.add(t1, C19, t1)
    np.multiply(t1, t2, t1)
    np.add(t1, C1, t1)
    np.divide(t3, t1, t1)
    np.multiply(t2, t1, t1)
    np.add(C1, t1, t1)
    np.multiply(t4, t1, t1)
    np.add(n, C1, t4)
    np.multiply(t4, t0, t0)
    np.multiply(C21, n, t2)
    np.multiply(t2, A, t2)
    np.multiply(t2, t1, t1)
    np.divide(t0, t1, t1)
    np.divide(C1, t4, t0)
    np.power(t1, t0, t0)
    np.greater(t1, C0, m0)
    np.less(t1, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some97 = np.count_nonzero(m1)
    if some97:
        np.power(t0, n, out)
        np.power(t0, C1, t2)
        np.multiply(out, t2, t2)
        np.divide(t1, t2, t2)
        np.subtract(t2, C1, t2)
        np.divide(t2, t4, t2)
        np.multiply(t0, t2, t2)
        np.add(t0, t2, out)
    if some97 != size:
        np.copyto(out, t0, where=~m1)


def step_load_radius_power_creep(t, F, A, n, E, alpha, t_0):
    if t.__class__ is F.__class__ is A.__class__ is n.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            v14 = n / 2.0 + 0.5
            v16 = v14 + 1.75
            v20 = (v14 + 0.5) * (v14 + 1.5)
            v34 = 1.0 / (v16 * v16)
            v76 = n + 1.0
            v82 = v76 * (F * (pow(t / t_0, alpha) / E)) / (3.5449077018110318 * n * A * ((v14 * (v14 + 1.0) / v20 if v14 < 1.0 else 1.0 - (v14 + 0.75) / v20) * sqrt(v16) * (1.0 + v34 * (((((((0.01524698625788054 * v34 + 0.5334320651111477) * v34 + 2.250488865813539) * v34 + 2.8612106440066865) * v34 + 1.3794681629043655) * v34 + 0.2596058532893223) * v34 + 0.015624999999999823) / ((((((3.278794792785737 * v34 + 49.328555418276075) * v34 + 167.28648538571198) * v34 + 195.37226190335065) * v34 + 90.69722535867314) * v34 + 16.763212110504565) * v34 + 1.0)))))
            v84 = pow(v82, 1.0 / v76)
            if v82 > 0.0 and v82 < inf:
                value = v84 + v84 * ((v82 / (pow(v84, n) * pow(v84, 1.0)) - 1.0) / v76)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            value = v84
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_load_radius_power_creep_t(F, A, n, E, alpha, t_0):
    v12 = n / (2.0)
    v14 = v12 + (0.5)
    v16 = v14 + (1.75)
    v17 = v14 + (0.5)
    v19 = v14 + (1.5)
    v20 = v17 * v19
    v22 = np.less(v14, (1.0))
    v23 = v14 + (1.0)
    v24 = v14 * v23
    v25 = v24 / v20
    v27 = v14 + (0.75)
    v28 = v27 / v20
    v29 = (1.0) - v28
    v30 = v25 if v22 else v29
    v31 = np.sqrt(v16)
    v32 = v30 * v31
    v33 = v16 * v16
    v34 = (1.0) / v33
    v36 = (0.01524698625788054) * v34
    v38 = v36 + (0.5334320651111477)
    v39 = v38 * v34
    v41 = v39 + (2.250488865813539)
    v42 = v41 * v34
    v44 = v42 + (2.8612106440066865)
    v45 = v44 * v34
    v47 = v45 + (1.3794681629043655)
    v48 = v47 * v34
    v50 = v48 + (0.2596058532893223)
    v51 = v50 * v34
    v53 = v51 + (0.015624999999999823)
    v55 = (3.278794792785737) * v34
    v57 = v55 + (49.328555418276075)
    v58 = v57 * v34
    v60 = v58 + (167.28648538571198)
    v61 = v60 * v34
    v63 = v61 + (195.37226190335065)
    v64 = v63 * v34
    v66 = v64 + (90.69722535867314)
    v67 = v66 * v34
    v69 = v67 + (16.763212110504565)
    v70 = v69 * v34
    v71 = v70 + (1.0)
    v72 = v53 / v71
    v73 = v34 * v72
    v74 = (1.0) + v73
    v75 = v32 * v74
    v76 = n + (1.0)
    v79 = (3.5449077018110318) * n
    v80 = v79 * A
    v81 = v80 * v75
    v83 = (1.0) / v76
    return (F, n, E, alpha, t_0, v76, v81, v83)


def block_step_load_radius_power_creep_t(out, t, F, n, E, alpha, t_0, v76, v81, v83, t0, t1, t2, m0, m1):
    size = out.size
    np.divide(t, t_0, t0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.power(t0, alpha, t0)
    np.divide(t0, E, t0)
    np.multiply(F, t0, t0)
    np.multiply(v76, t0, t0)
    np.divide(t0, v81, t0)
    np.power(t0, v83, t1)
    np.greater(t0, C0, m0)
    np.less(t0, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some98 = np.count_nonzero(m1)
    if some98:
        np.power(t1, n, out)
        np.power(t1, C1, t2)
        np.multiply(out, t2, t2)
        np.divide(t0, t2, t2)
        np.subtract(t2, C1, t2)
        np.divide(t2, v76, t2)
        np.multiply(t1, t2, t2)
        np.add(t1, t2, out)
    if some98 != size:
        np.copyto(out, t1, where=~m1)


def prepare_step_load_radius_power_creep_all():
    return ()


def block_step_load_radius_power_creep_all(out, t, F, A, n, E, alpha, t_0, t0, t1, t2, t3, t4, t5, m0, m1):
    size = out.size
    np.divide(t, t_0, t0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.power(t0, alpha, t0)
    np.divide(t0, E, t0)
    np.multiply(F, t0, t0)
    np.multiply(n, C3, t1)
    np.add(t1, C3, t1)
    np.add(t1, C4, t2)
    np.add(t1, C3, t3)
    np.add(t1, C5, t4)
    np.multiply(t3, t4, t4)
    np.less(t1, C1, m0)
    some30 = np.count_nonzero(m0)
    if some30:
        np.add(t1, C1, t3)
        np.multiply(t1, t3, t3)
        np.divide(t3, t4, t3)
    if some30 != size:
        other30 = t5 if some30 else t3
        np.add(t1, C6, other30)
        np.divide(other30, t4, other30)
        np.subtract(C1, other30, other30)
        if some30:
            np.copyto(t3, other30, where=~m0)
    np.sqrt(t2, t4)
    np.multiply(t3, t4, t4)
    np.multiply(t2, t2, t2)
    np.divide(C1, t2, t2)
    np.multiply(C7, t2, t3)
    np.add(t3, C8, t3)
    np.multiply(t3, t2, t3)
    np.add(t3, C9, t3)
    np.multiply(t3, t2, t3)
    np.add(t3, C10, t3)
    np.multiply(t3, t2, t3)
    np.add(t3, C11, t3)
    np.multiply(t3, t2, t3)
    np.add(t3, C12, t3)
    np.multiply(t3, t2, t3)
    np.add(t3, C13, t3)
    np.multiply(C14, t2, t1)
    np.add(t1, C15, t1)
    np.multiply(t1, t2, t1)
    np.add(t1, C16, t1)
    np.multiply(t1, t2, t1)
    np.add(t1, C17, t1)
    np.multiply(t1, t2, t1)
    np.add(t1, C18, t1)
    np.multiply(t1, t2, t1)
    np.add(t1, C19, t1)
    np.multiply(t1, t2, t1)
    np.add(t1, C1, t1)
    np.divide(t3, t1, t1)
    np.multiply(t2, t1, t1)
    np.add(C1, t1, t1)
    np.multiply(t4, t1, t1)
    np.add(n, C1, t4)
    np.multiply(t4, t0, t0)
    np.multiply(C21, n, t2)
    np.multiply(t2, A, t2)
    np.multiply(t2, t1, t1)
    np.divide(t0, t1, t1)
    np.divide(C1, t4, t0)
    np.power(t1, t0, t0)
    np.greater(t1, C0, m0)
    np.less(t1, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some98 = np.count_nonzero(m1)
    if some98:
        np.power(t0, n, out)
        np.power(t0, C1, t2)
        np.multiply(out, t2, t2)
        np.divide(t1, t2, t2)
        np.subtract(t2, C1, t2)
        np.divide(t2, t4, t2)
        np.multiply(t0, t2, t2)
        np.add(t0, t2, out)
    if some98 != size:
        np.copyto(out, t0, where=~m1)


def step_load_radius_standard_solid(t, F, A, n, E_inf, E_1, tau):
    if t.__class__ is F.__class__ is A.__class__ is n.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            v7 = E_inf + E_1
            v23 = n / 2.0 + 0.5
            v25 = v23 + 1.75
            v29 = (v23 + 0.5) * (v23 + 1.5)
            v42 = 1.0 / (v25 * v25)
            v84 = n + 1.0
            v90 = v84 * (F * (1.0 / v7 - E_1 / v7 * expm1(-(t / tau * (E_inf / v7))) / E_inf)) / (3.5449077018110318 * n * A * ((v23 * (v23 + 1.0) / v29 if v23 < 1.0 else 1.0 - (v23 + 0.75) / v29) * sqrt(v25) * (1.0 + v42 * (((((((0.01524698625788054 * v42 + 0.5334320651111477) * v42 + 2.250488865813539) * v42 + 2.8612106440066865) * v42 + 1.3794681629043655) * v42 + 0.2596058532893223) * v42 + 0.015624999999999823) / ((((((3.278794792785737 * v42 + 49.328555418276075) * v42 + 167.28648538571198) * v42 + 195.37226190335065) * v42 + 90.69722535867314) * v42 + 16.763212110504565) * v42 + 1.0)))))
            v92 = pow(v90, 1.0 / v84)
            if v90 > 0.0 and v90 < inf:
                value = v92 + v92 * ((v90 / (pow(v92, n) * pow(v92, 1.0)) - 1.0) / v84)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            value = v92
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_load_radius_standard_solid_t(F, A, n, E_inf, E_1, tau):
    v7 = E_inf + E_1
    v9 = E_inf / v7
    v12 = (1.0) / v7
    v13 = E_1 / v7
    v21 = n / (2.0)
    v23 = v21 + (0.5)
    v25 = v23 + (1.75)
    v26 = v23 + (0.5)
    v28 = v23 + (1.5)
    v29 = v26 * v28
    v30 = np.less(v23, (1.0))
    v31 = v23 + (1.0)
    v32 = v23 * v31
    v33 = v32 / v29
    v35 = v23 + (0.75)
    v36 = v35 / v29
    v37 = (1.0) - v36
    v38 = v33 if v30 else v37
    v39 = np.sqrt(v25)
    v40 = v38 * v39
    v41 = v25 * v25
    v42 = (1.0) / v41
    v44 = (0.01524698625788054) * v42
    v46 = v44 + (0.5334320651111477)
    v47 = v46 * v42
    v49 = v47 + (2.250488865813539)
    v50 = v49 * v42
    v52 = v50 + (2.8612106440066865)
    v53 = v52 * v42
    v55 = v53 + (1.3794681629043655)
    v56 = v55 * v42
    v58 = v56 + (0.2596058532893223)
    v59 = v58 * v42
    v61 = v59 + (0.015624999999999823)
    v63 = (3.278794792785737) * v42
    v65 = v63 + (49.328555418276075)
    v66 = v65 * v42
    v68 = v66 + (167.28648538571198)
    v69 = v68 * v42
    v71 = v69 + (195.37226190335065)
    v72 = v71 * v42
    v74 = v72 + (90.69722535867314)
    v75 = v74 * v42
    v77 = v75 + (16.763212110504565)
    v78 = v77 * v42
    v79 = v78 + (1.0)
    v80 = v61 / v79
    v81 = v42 * v80
    v82 = (1.0) + v81
    v83 = v40 * v82
    v84 = n + (1.0)
    v87 = (3.5449077018110318) * n
    v88 = v87 * A
    v89 = v88 * v83
    v91 = (1.0) / v84
    return (F, n, E_inf, tau, v9, v12, v13, v84, v89, v91)


def block_step_load_radius_standard_solid_t(out, t, F, n, E_inf, tau, v9, v12, v13, v84, v89, v91, t0, t1, t2, m0, m1):
    size = out.size
    np.divide(t, tau, t0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.multiply(t0, v9, t0)
    np.negative(t0, t0)
    np.expm1(t0, t0)
    np.multiply(v13, t0, t0)
    np.divide(t0, E_inf, t0)
    np.subtract(v12, t0, t0)
    np.multiply(F, t0, t0)
    np.multiply(v84, t0, t0)
    np.divide(t0, v89, t0)
    np.power(t0, v91, t1)
    np.greater(t0, C0, m0)
    np.less(t0, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some106 = np.count_nonzero(m1)
    if some106:
        np.power(t1, n, out)
        np.power(t1, C1, t2)
        np.multiply(out, t2, t2)
        np.divide(t0, t2, t2)
        np.subtract(t2, C1, t2)
        np.divide(t2, v84, t2)
        np.multiply(t1, t2, t2)
        np.add(t1, t2, out)
    if some106 != size:
        np.copyto(out, t1, where=~m1)


def prepare_step_load_radius_standard_solid_all():
    return ()


def block_step_load_radius_standard_solid_all(out, t, F, A, n, E_inf, E_1, tau, t0, t1, t2, t3, t4, t5, m0, m1):
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
    np.multiply(n, C3, t1)
    np.add(t1, C3, t1)
    np.add(t1, C4, t0)
    np.add(t1, C3, t3)
    np.add(t1, C5, t4)
    np.multiply(t3, t4, t4)
    np.less(t1, C1, m0)
    some38 = np.count_nonzero(m0)
    if some38:
        np.add(t1, C1, t3)
        np.multiply(t1, t3, t3)
        np.divide(t3, t4, t3)
    if some38 != size:
        other38 = t5 if some38 else t3
        np.add(t1, C6, other38)
        np.divide(other38, t4, other38)
        np.subtract(C1, other38, other38)
        if some38:
            np.copyto(t3, other38, where=~m0)
    np.sqrt(t0, t4)
    np.multiply(t3, t4, t4)
    np.multiply(t0, t0, t0)
    np.divide(C1, t0, t0)
    np.multiply(C7, t0, t3)
    np.add(t3, C8, t3)
    np.multiply(t3, t0, t3)
    np.add(t3, C9, t3)
    np.multiply(t3, t0, t3)
    np.add(t3, C10, t3)
    np.multiply(t3, t0, t3)
    np.add(t3, C11, t3)
    np.multiply(t3, t0, t3)
    np.add(t3, C12, t3)
    np.multiply(t3, t0, t3)
    np.add(t3, C13, t3)
    np.multiply(C14, t0, t1)
    np.add(t1, C15, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C16, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C17, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C18, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C19, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C1, t1)
    np.divide(t3, t1, t1)
    np.multiply(t0, t1, t1)
    np.add(C1, t1, t1)
    np.multiply(t4, t1, t1)
    np.add(n, C1, t4)
    np.multiply(t4, t2, t2)
    np.multiply(C21, n, t0)
    np.multiply(t0, A, t0)
    np.multiply(t0, t1, t1)
    np.divide(t2, t1, t1)
    np.divide(C1, t4, t2)
    np.power(t1, t2, t2)
    np.greater(t1, C0, m0)
    np.less(t1, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some106 = np.count_nonzero(m1)
    if some106:
        np.power(t2, n, out)
        np.power(t2, C1, t0)
        np.multiply(out, t0, t0)
        np.divide(t1, t0, t0)
        np.subtract(t0, C1, t0)
        np.divide(t0, t4, t0)
        np.multiply(t2, t0, t0)
        np.add(t2, t0, out)
    if some106 != size:
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
    ('_ramp_force_kelvin_voigt', 1, 't', 'A', 'n', 'v', 'E', 'eta'): {
        ('t',): (('t',), prepare_ramp_force_kelvin_voigt_t, block_ramp_force_kelvin_voigt_t, 5, 3, (), False),
        ('t', 'A', 'n', 'v', 'E', 'eta'): (('t', 'A', 'n', 'v', 'E', 'eta'), prepare_ramp_force_kelvin_voigt_all, block_ramp_force_kelvin_voigt_all, 8, 3, (), False),
    },
    ('_retract_force_kelvin_voigt', 1, 't', 'A', 'n', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'): {
        ('t',): (('t',), prepare_retract_force_kelvin_voigt_t, block_retract_force_kelvin_voigt_t, 6, 4, (0.0,), False),
        ('t', 'A', 'n', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'): (('t', 'A', 'n', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'), prepare_retract_force_kelvin_voigt_all, block_retract_force_kelvin_voigt_all, 12, 4, (0.0,), False),
    },
    ('_retract_radius_kelvin_voigt', 1, 't', 'A', 'n', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'): {
        ('t',): (('t',), prepare_retract_radius_kelvin_voigt_t, block_retract_radius_kelvin_voigt_t, 5, 3, (0.0,), False),
        ('t', 'A', 'n', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'): (('t', 'A', 'n', 'v', 'v_2', 't_m', 't_h', 'E', 'eta'), prepare_retract_radius_kelvin_voigt_all, block_retract_radius_kelvin_voigt_all, 8, 3, (0.0,), False),
    },
    ('_retract_radius_maxwell', 1, 't', 'A', 'n', 'v', 'v_2', 't_m', 't_h', 'E', 'tau'): {
        ('t',): (('t',), prepare_retract_radius_maxwell_t, block_retract_radius_maxwell_t, 5, 3, (0.0, 700.0, 0.9999999999999998), False),
        ('t', 'A', 'n', 'v', 'v_2', 't_m', 't_h', 'E', 'tau'): (('t', 'A', 'n', 'v', 'v_2', 't_m', 't_h', 'E', 'tau'), prepare_retract_radius_maxwell_all, block_retract_radius_maxwell_all, 8, 3, (0.0, 700.0, 0.9999999999999998), False),
    },
    ('_retract_radius_power_creep', 1, 't', 'A', 'n', 'v', 'v_2', 't_m', 't_h', 'E', 'alpha', 't_0'): {
        ('t',): (('t',), prepare_retract_radius_power_creep_t, block_retract_radius_power_creep_t, 5, 3, (0.0, 700.0), False),
        ('t', 'A', 'n', 'v', 'v_2', 't_m', 't_h', 'E', 'alpha', 't_0'): (('t', 'A', 'n', 'v', 'v_2', 't_m', 't_h', 'E', 'alpha', 't_0'), prepare_retract_radius_power_creep_all, block_retract_radius_power_creep_all, 8, 3, (0.0, 700.0), False),
    },
    ('_step_force_kelvin_voigt', 1, 't', 'd', 'A', 'n', 'E', 'eta'): {
        ('t',): (('t',), prepare_step_force_kelvin_voigt_t, block_step_force_kelvin_voigt_t, 0, 1, (), False),
        ('t', 'd', 'A', 'n', 'E', 'eta'): (('t', 'd', 'A', 'n', 'E', 'eta'), prepare_step_force_kelvin_voigt_all, block_step_force_kelvin_voigt_all, 6, 2, (), False),
    },
    ('_step_force_maxwell', 1, 't', 'd', 'A', 'n', 'E', 'tau'): {
        ('t',): (('t',), prepare_step_force_maxwell_t, block_step_force_maxwell_t, 0, 0, (), False),
        ('t', 'd', 'A', 'n', 'E', 'tau'): (('t', 'd', 'A', 'n', 'E', 'tau'), prepare_step_force_maxwell_all, block_step_force_maxwell_all, 6, 2, (), False),
    },
    ('_step_force_power_creep', 1, 't', 'd', 'A', 'n', 'E', 'alpha', 't_0'): {
        ('t',): (('t',), prepare_step_force_power_creep_t, block_step_force_power_creep_t, 0, 0, (), False),
        ('t', 'd', 'A', 'n', 'E', 'alpha', 't_0'): (('t', 'd', 'A', 'n', 'E', 'alpha', 't_0'), prepare_step_force_power_creep_all, block_step_force_power_creep_all, 6, 2, (), False),
    },
    ('_step_force_standard_solid', 1, 't', 'd', 'A', 'n', 'E_inf', 'E_1', 'tau'): {
        ('t',): (('t',), prepare_step_force_standard_solid_t, block_step_force_standard_solid_t, 0, 0, (), False),
        ('t', 'd', 'A', 'n', 'E_inf', 'E_1', 'tau'): (('t', 'd', 'A', 'n', 'E_inf', 'E_1', 'tau'), prepare_step_force_standard_solid_all, block_step_force_standard_solid_all, 6, 2, (), False),
    },
    ('_step_load_radius_kelvin_voigt', 1, 't', 'F', 'A', 'n', 'E', 'eta'): {
        ('t',): (('t',), prepare_step_load_radius_kelvin_voigt_t, block_step_load_radius_kelvin_voigt_t, 3, 2, (), False),
        ('t', 'F', 'A', 'n', 'E', 'eta'): (('t', 'F', 'A', 'n', 'E', 'eta'), prepare_step_load_radius_kelvin_voigt_all, block_step_load_radius_kelvin_voigt_all, 6, 2, (), False),
    },
    ('_step_load_radius_maxwell', 1, 't', 'F', 'A', 'n', 'E', 'tau'): {
        ('t',): (('t',), prepare_step_load_radius_maxwell_t, block_step_load_radius_maxwell_t, 3, 2, (), False),
        ('t', 'F', 'A', 'n', 'E', 'tau'): (('t', 'F', 'A', 'n', 'E', 'tau'), prepare_step_load_radius_maxwell_all, block_step_load_radius_maxwell_all, 6, 2, (), False),
    },
    ('_step_load_radius_power_creep', 1, 't', 'F', 'A', 'n', 'E', 'alpha', 't_0'): {
        ('t',): (('t',), prepare_step_load_radius_power_creep_t, block_step_load_radius_power_creep_t, 3, 2, (), False),
        ('t', 'F', 'A', 'n', 'E', 'alpha', 't_0'): (('t', 'F', 'A', 'n', 'E', 'alpha', 't_0'), prepare_step_load_radius_power_creep_all, block_step_load_radius_power_creep_all, 6, 2, (), False),
    },
    ('_step_load_radius_standard_solid', 1, 't', 'F', 'A', 'n', 'E_inf', 'E_1', 'tau'): {
        ('t',): (('t',), prepare_step_load_radius_standard_solid_t, block_step_load_radius_standard_solid_t, 3, 2, (), False),
        ('t', 'F', 'A', 'n', 'E_inf', 'E_1', 'tau'): (('t', 'F', 'A', 'n', 'E_inf', 'E_1', 'tau'), prepare_step_load_radius_standard_solid_all, block_step_load_radius_standard_solid_all, 6, 2, (), False),
    },
}
