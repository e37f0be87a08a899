"""Programs of axicontact.viscoelastic.cone."""

from __future__ import annotations

from math import exp, expm1, inf, pow, sin, sqrt, tan

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._programs.bodies.viscoelastic import cone as bodies

C0 = np.array(0.0)
C1 = np.array(2.0)
C2 = np.array(3.141592653589793)
C3 = np.array(np.inf)
C4 = np.array(1.0)


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
        np.multiply(C2, t1, t1)
        np.divide(C1, t1, t1)
        np.square(other19, other19)
        np.multiply(t1, other19, other19)
        np.multiply(eta, C1, t1)
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
        np.copyto(out, C3, where=~m0)
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
        np.copyto(out, C3, where=~m0)
    np.tan(theta, t0)
    np.multiply(C2, t0, t0)
    np.divide(C1, t0, t0)
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
    np.multiply(C2, t0, t0)
    np.divide(C1, t0, t0)
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
    np.multiply(C2, alpha, t0)
    np.sin(t0, t1)
    np.multiply(out, t1, t1)
    np.divide(t1, t0, t0)
    np.tan(theta, t1)
    np.multiply(C2, t1, t1)
    np.divide(C1, t1, t1)
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
    np.multiply(C2, t0, t0)
    np.divide(C1, t0, t0)
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
    np.multiply(C1, out, out)
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
    np.multiply(C1, out, out)
    np.tan(theta, t0)
    np.multiply(C2, t0, t0)
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
    np.add(C4, out, out)
    np.divide(out, E, out)
    np.multiply(F, out, out)
    np.multiply(C1, out, out)
    np.divide(out, v14, out)
    np.sqrt(out, out)


def prepare_step_load_radius_maxwell_all():
    return ()


def block_step_load_radius_maxwell_all(out, t, F, theta, E, tau, t0):
    np.divide(t, tau, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.add(C4, out, out)
    np.divide(out, E, out)
    np.multiply(F, out, out)
    np.multiply(C1, out, out)
    np.tan(theta, t0)
    np.multiply(C2, t0, t0)
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
    np.multiply(C1, out, out)
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
    np.multiply(C1, out, out)
    np.tan(theta, t0)
    np.multiply(C2, t0, t0)
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
    np.multiply(C1, out, out)
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
    np.divide(C4, out, t0)
    np.divide(E_1, out, out)
    np.negative(t1, t1)
    np.expm1(t1, t1)
    np.multiply(out, t1, t1)
    np.divide(t1, E_inf, t1)
    np.subtract(t0, t1, t1)
    np.multiply(F, t1, t1)
    np.multiply(C1, t1, t1)
    np.tan(theta, t0)
    np.multiply(C2, t0, t0)
    np.divide(t1, t0, t0)
    np.sqrt(t0, out)


BLOCKS = {
    ('_ramp_force_kelvin_voigt', 1, 't', 'theta', 'v', 'E', 'eta'): {
        ('t',): (('t',), prepare_ramp_force_kelvin_voigt_t, block_ramp_force_kelvin_voigt_t, 2, 1, (), False),
        ('t', 'theta', 'v', 'E', 'eta'): (('t', 'theta', 'v', 'E', 'eta'), prepare_ramp_force_kelvin_voigt_all, block_ramp_force_kelvin_voigt_all, 2, 1, (), False),
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
