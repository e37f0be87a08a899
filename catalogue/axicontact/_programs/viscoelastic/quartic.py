"""Programs of axicontact.viscoelastic.quartic."""

from __future__ import annotations

from math import exp, expm1, inf, pow, sin, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._programs.bodies.viscoelastic import quartic as bodies

C0 = np.array(0.0)
C1 = np.array(0.8)
C2 = np.array(6.0)
C3 = np.array(1.25)
C4 = np.array(np.inf)
C5 = np.array(3.141592653589793)
C6 = np.array(15.0)
C7 = np.array(0.2)
C8 = np.array(5.0)
C9 = np.array(1.0)
C10 = np.array(64.0)


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
        np.multiply(C1, other21, t1)
        np.multiply(C2, other21, other21)
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
        np.multiply(C1, other21, t1)
        np.multiply(C2, other21, other21)
        np.divide(other21, A, other21)
        np.sqrt(other21, other21)
        np.sqrt(other21, other21)
        np.multiply(t1, other21, other21)
        np.multiply(eta, C3, t1)
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
        np.copyto(out, C4, where=~m0)
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
        np.copyto(out, C4, where=~m0)
    np.multiply(C1, d, t0)
    np.multiply(C2, d, t1)
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
    np.multiply(C1, d, t0)
    np.multiply(C2, d, t1)
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
    np.multiply(C5, alpha, t0)
    np.sin(t0, t1)
    np.multiply(out, t1, t1)
    np.divide(t1, t0, t0)
    np.multiply(C1, d, t1)
    np.multiply(C2, d, out)
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
    np.multiply(C1, d, t0)
    np.multiply(C2, d, t1)
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
    np.multiply(C6, t0, t0)
    np.divide(t0, v15, t0)
    np.power(t0, C7, t1)
    np.greater(t0, C0, m0)
    np.less(t0, C4, m1)
    np.bitwise_and(m0, m1, m1)
    some34 = np.count_nonzero(m1)
    if some34:
        np.power(t1, C8, out)
        np.power(t1, C0, t2)
        np.multiply(out, t2, t2)
        np.divide(t0, t2, t2)
        np.subtract(t2, C9, t2)
        np.divide(t2, C8, t2)
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
    np.multiply(C6, t0, t0)
    np.multiply(C10, A, t1)
    np.divide(t0, t1, t1)
    np.power(t1, C7, t0)
    np.greater(t1, C0, m0)
    np.less(t1, C4, m1)
    np.bitwise_and(m0, m1, m1)
    some34 = np.count_nonzero(m1)
    if some34:
        np.power(t0, C8, out)
        np.power(t0, C0, t2)
        np.multiply(out, t2, t2)
        np.divide(t1, t2, t2)
        np.subtract(t2, C9, t2)
        np.divide(t2, C8, t2)
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
    np.add(C9, t0, t0)
    np.divide(t0, E, t0)
    np.multiply(F, t0, t0)
    np.multiply(C6, t0, t0)
    np.divide(t0, v13, t0)
    np.power(t0, C7, t1)
    np.greater(t0, C0, m0)
    np.less(t0, C4, m1)
    np.bitwise_and(m0, m1, m1)
    some31 = np.count_nonzero(m1)
    if some31:
        np.power(t1, C8, out)
        np.power(t1, C0, t2)
        np.multiply(out, t2, t2)
        np.divide(t0, t2, t2)
        np.subtract(t2, C9, t2)
        np.divide(t2, C8, t2)
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
    np.add(C9, t0, t0)
    np.divide(t0, E, t0)
    np.multiply(F, t0, t0)
    np.multiply(C6, t0, t0)
    np.multiply(C10, A, t1)
    np.divide(t0, t1, t1)
    np.power(t1, C7, t0)
    np.greater(t1, C0, m0)
    np.less(t1, C4, m1)
    np.bitwise_and(m0, m1, m1)
    some31 = np.count_nonzero(m1)
    if some31:
        np.power(t0, C8, out)
        np.power(t0, C0, t2)
        np.multiply(out, t2, t2)
        np.divide(t1, t2, t2)
        np.subtract(t2, C9, t2)
        np.divide(t2, C8, t2)
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
    np.multiply(C6, t0, t0)
    np.divide(t0, v13, t0)
    np.power(t0, C7, t1)
    np.greater(t0, C0, m0)
    np.less(t0, C4, m1)
    np.bitwise_and(m0, m1, m1)
    some32 = np.count_nonzero(m1)
    if some32:
        np.power(t1, C8, out)
        np.power(t1, C0, t2)
        np.multiply(out, t2, t2)
        np.divide(t0, t2, t2)
        np.subtract(t2, C9, t2)
        np.divide(t2, C8, t2)
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
    np.multiply(C6, t0, t0)
    np.multiply(C10, A, t1)
    np.divide(t0, t1, t1)
    np.power(t1, C7, t0)
    np.greater(t1, C0, m0)
    np.less(t1, C4, m1)
    np.bitwise_and(m0, m1, m1)
    some32 = np.count_nonzero(m1)
    if some32:
        np.power(t0, C8, out)
        np.power(t0, C0, t2)
        np.multiply(out, t2, t2)
        np.divide(t1, t2, t2)
        np.subtract(t2, C9, t2)
        np.divide(t2, C8, t2)
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
    np.multiply(C6, t0, t0)
    np.divide(t0, v22, t0)
    np.power(t0, C7, t1)
    np.greater(t0, C0, m0)
    np.less(t0, C4, m1)
    np.bitwise_and(m0, m1, m1)
    some40 = np.count_nonzero(m1)
    if some40:
        np.power(t1, C8, out)
        np.power(t1, C0, t2)
        np.multiply(out, t2, t2)
        np.divide(t0, t2, t2)
        np.subtract(t2, C9, t2)
        np.divide(t2, C8, t2)
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
    np.divide(C9, t0, t1)
    np.divide(E_1, t0, t0)
    np.negative(t2, t2)
    np.expm1(t2, t2)
    np.multiply(t0, t2, t2)
    np.divide(t2, E_inf, t2)
    np.subtract(t1, t2, t2)
    np.multiply(F, t2, t2)
    np.multiply(C6, t2, t2)
    np.multiply(C10, A, t1)
    np.divide(t2, t1, t1)
    np.power(t1, C7, t2)
    np.greater(t1, C0, m0)
    np.less(t1, C4, m1)
    np.bitwise_and(m0, m1, m1)
    some40 = np.count_nonzero(m1)
    if some40:
        np.power(t2, C8, out)
        np.power(t2, C0, t0)
        np.multiply(out, t0, t0)
        np.divide(t1, t0, t0)
        np.subtract(t0, C9, t0)
        np.divide(t0, C8, t0)
        np.multiply(t2, t0, t0)
        np.add(t2, t0, out)
    if some40 != size:
        np.copyto(out, t2, where=~m1)


BLOCKS = {
    ('_ramp_force_kelvin_voigt', 1, 't', 'A', 'v', 'E', 'eta'): {
        ('t',): (('t',), prepare_ramp_force_kelvin_voigt_t, block_ramp_force_kelvin_voigt_t, 2, 1, (), False),
        ('t', 'A', 'v', 'E', 'eta'): (('t', 'A', 'v', 'E', 'eta'), prepare_ramp_force_kelvin_voigt_all, block_ramp_force_kelvin_voigt_all, 2, 1, (), False),
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
