"""Programs of axicontact.viscoelastic.paraboloid."""

from __future__ import annotations

from math import cbrt, exp, expm1, inf, pow, sin, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._programs.bodies.viscoelastic import paraboloid as bodies

C0 = np.array(0.0)
C1 = np.array(1.3333333333333333)
C2 = np.array(1.5)
C3 = np.array(np.inf)
C4 = np.array(3.141592653589793)
C5 = np.array(0.75)
C6 = np.array(1.0)


def ramp_force_kelvin_voigt(t, v, R, E, eta):
    if t.__class__ is v.__class__ is R.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            if t == 0.0:
                return 0.0
            v5 = v * t
            return 1.3333333333333333 * v5 * sqrt(R * v5) * (E + eta * 1.5 / t)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_ramp_force_kelvin_voigt_t(R, v, E, eta):
    v12 = eta * (1.5)
    return (v, R, E, v12)


def block_ramp_force_kelvin_voigt_t(out, t, v, R, E, v12, t0, t1, m0):
    size = out.size
    np.equal(t, C0, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some18 = np.count_nonzero(m0)
    if some18:
        np.copyto(out, C0)
    if some18 != size:
        other18 = t0 if some18 else out
        np.multiply(v, t, other18)
        np.multiply(C1, other18, t1)
        np.multiply(R, other18, other18)
        np.sqrt(other18, other18)
        np.multiply(t1, other18, other18)
        np.divide(v12, t, t1)
        np.add(E, t1, t1)
        np.multiply(other18, t1, other18)
        if some18:
            np.copyto(out, other18, where=~m0)


def prepare_ramp_force_kelvin_voigt_all():
    return ()


def block_ramp_force_kelvin_voigt_all(out, t, R, v, E, eta, t0, t1, m0):
    size = out.size
    np.equal(t, C0, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some18 = np.count_nonzero(m0)
    if some18:
        np.copyto(out, C0)
    if some18 != size:
        other18 = t0 if some18 else out
        np.multiply(v, t, other18)
        np.multiply(C1, other18, t1)
        np.multiply(R, other18, other18)
        np.sqrt(other18, other18)
        np.multiply(t1, other18, other18)
        np.multiply(eta, C2, t1)
        np.divide(t1, t, t1)
        np.add(E, t1, t1)
        np.multiply(other18, t1, other18)
        if some18:
            np.copyto(out, other18, where=~m0)


def ramp_force_maxwell(t, v, R, E, tau):
    if t.__class__ is v.__class__ is R.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._ramp_force_maxwell(t, v, R, E, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, R, E, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def ramp_force_power_creep(t, v, R, E, alpha, t_0):
    if t.__class__ is v.__class__ is R.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            value = bodies._ramp_force_power_creep(t, v, R, E, alpha, t_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, R, E, alpha, t_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def ramp_force_standard_solid(t, v, R, E_inf, E_1, tau):
    if t.__class__ is v.__class__ is R.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (v > 1e-30) and (v < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._ramp_force_standard_solid(t, v, R, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, v, R, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_force_kelvin_voigt(t, d, R, E, eta):
    if t.__class__ is d.__class__ is R.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            value = (E if t > 0.0 else inf) * (1.3333333333333333 * d * sqrt(R * d))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_kelvin_voigt_t(d, R, E, eta):
    v9 = (1.3333333333333333) * d
    v10 = R * d
    v11 = np.sqrt(v10)
    v12 = v9 * v11
    return (E, v12)


def block_step_force_kelvin_voigt_t(out, t, E, v12, m0):
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
    np.multiply(out, v12, out)


def prepare_step_force_kelvin_voigt_all():
    return ()


def block_step_force_kelvin_voigt_all(out, t, d, R, E, eta, t0, t1, m0):
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
    np.multiply(C1, d, t0)
    np.multiply(R, d, t1)
    np.sqrt(t1, t1)
    np.multiply(t0, t1, t1)
    np.multiply(out, t1, out)


def step_force_maxwell(t, d, R, E, tau):
    if t.__class__ is d.__class__ is R.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = E * exp(-t / tau) * (1.3333333333333333 * d * sqrt(R * d))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_maxwell_t(d, R, E, tau):
    v10 = (1.3333333333333333) * d
    v11 = R * d
    v12 = np.sqrt(v11)
    v13 = v10 * v12
    return (E, tau, v13)


def block_step_force_maxwell_t(out, t, E, tau, v13):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E, out, out)
    np.multiply(out, v13, out)


def prepare_step_force_maxwell_all():
    return ()


def block_step_force_maxwell_all(out, t, d, R, E, tau, t0, t1):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E, out, out)
    np.multiply(C1, d, t0)
    np.multiply(R, d, t1)
    np.sqrt(t1, t1)
    np.multiply(t0, t1, t1)
    np.multiply(out, t1, out)


def step_force_power_creep(t, d, R, E, alpha, t_0):
    if t.__class__ is d.__class__ is R.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            v10 = 3.141592653589793 * alpha
            value = E * pow(t_0 / t, alpha) * sin(v10) / v10 * (1.3333333333333333 * d * sqrt(R * d))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_power_creep_t(d, R, E, alpha, t_0):
    v10 = (3.141592653589793) * alpha
    v11 = np.sin(v10)
    v15 = (1.3333333333333333) * d
    v16 = R * d
    v17 = np.sqrt(v16)
    v18 = v15 * v17
    return (E, alpha, t_0, v10, v11, v18)


def block_step_force_power_creep_t(out, t, E, alpha, t_0, v10, v11, v18):
    np.divide(t_0, t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.power(out, alpha, out)
    np.multiply(E, out, out)
    np.multiply(out, v11, out)
    np.divide(out, v10, out)
    np.multiply(out, v18, out)


def prepare_step_force_power_creep_all():
    return ()


def block_step_force_power_creep_all(out, t, d, R, E, alpha, t_0, t0, t1):
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
    np.multiply(C1, d, t1)
    np.multiply(R, d, out)
    np.sqrt(out, out)
    np.multiply(t1, out, out)
    np.multiply(t0, out, out)


def step_force_standard_solid(t, d, R, E_inf, E_1, tau):
    if t.__class__ is d.__class__ is R.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = (E_inf + E_1 * exp(-t / tau)) * (1.3333333333333333 * d * sqrt(R * d))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_standard_solid_t(d, R, E_inf, E_1, tau):
    v12 = (1.3333333333333333) * d
    v13 = R * d
    v14 = np.sqrt(v13)
    v15 = v12 * v14
    return (E_inf, E_1, tau, v15)


def block_step_force_standard_solid_t(out, t, E_inf, E_1, tau, v15):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E_1, out, out)
    np.add(E_inf, out, out)
    np.multiply(out, v15, out)


def prepare_step_force_standard_solid_all():
    return ()


def block_step_force_standard_solid_all(out, t, d, R, E_inf, E_1, tau, t0, t1):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E_1, out, out)
    np.add(E_inf, out, out)
    np.multiply(C1, d, t0)
    np.multiply(R, d, t1)
    np.sqrt(t1, t1)
    np.multiply(t0, t1, t1)
    np.multiply(out, t1, out)


def step_load_radius_kelvin_voigt(t, F, R, E, eta):
    if t.__class__ is F.__class__ is R.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            value = cbrt(3.0 * R / 4.0 * (F * (-expm1(-E * t / eta) / E)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_load_radius_kelvin_voigt_t(F, R, E, eta):
    v5 = np.negative(E)
    v13 = (3.0) * R
    v15 = v13 / (4.0)
    return (F, E, eta, v5, v15)


def block_step_load_radius_kelvin_voigt_t(out, t, F, E, eta, v5, v15):
    np.multiply(v5, t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, eta, out)
    np.expm1(out, out)
    np.negative(out, out)
    np.divide(out, E, out)
    np.multiply(F, out, out)
    np.multiply(v15, out, out)
    np.cbrt(out, out)


def prepare_step_load_radius_kelvin_voigt_all():
    return ()


def block_step_load_radius_kelvin_voigt_all(out, t, F, R, E, eta, t0):
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
    np.multiply(C5, R, t0)
    np.multiply(t0, out, out)
    np.cbrt(out, out)


def step_load_radius_maxwell(t, F, R, E, tau):
    if t.__class__ is F.__class__ is R.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            return cbrt(3.0 * R / 4.0 * (F * ((1.0 + t / tau) / E)))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_load_radius_maxwell_t(F, R, E, tau):
    v11 = (3.0) * R
    v13 = v11 / (4.0)
    return (F, E, tau, v13)


def block_step_load_radius_maxwell_t(out, t, F, E, tau, v13):
    np.divide(t, tau, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.add(C6, out, out)
    np.divide(out, E, out)
    np.multiply(F, out, out)
    np.multiply(v13, out, out)
    np.cbrt(out, out)


def prepare_step_load_radius_maxwell_all():
    return ()


def block_step_load_radius_maxwell_all(out, t, F, R, E, tau, t0):
    np.divide(t, tau, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.add(C6, out, out)
    np.divide(out, E, out)
    np.multiply(F, out, out)
    np.multiply(C5, R, t0)
    np.multiply(t0, out, out)
    np.cbrt(out, out)


def step_load_radius_power_creep(t, F, R, E, alpha, t_0):
    if t.__class__ is F.__class__ is R.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            value = cbrt(3.0 * R / 4.0 * (F * (pow(t / t_0, alpha) / E)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_load_radius_power_creep_t(F, R, E, alpha, t_0):
    v11 = (3.0) * R
    v13 = v11 / (4.0)
    return (F, E, alpha, t_0, v13)


def block_step_load_radius_power_creep_t(out, t, F, E, alpha, t_0, v13):
    np.divide(t, t_0, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.power(out, alpha, out)
    np.divide(out, E, out)
    np.multiply(F, out, out)
    np.multiply(v13, out, out)
    np.cbrt(out, out)


def prepare_step_load_radius_power_creep_all():
    return ()


def block_step_load_radius_power_creep_all(out, t, F, R, E, alpha, t_0, t0):
    np.divide(t, t_0, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.power(out, alpha, out)
    np.divide(out, E, out)
    np.multiply(F, out, out)
    np.multiply(C5, R, t0)
    np.multiply(t0, out, out)
    np.cbrt(out, out)


def step_load_radius_standard_solid(t, F, R, E_inf, E_1, tau):
    if t.__class__ is F.__class__ is R.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            v6 = E_inf + E_1
            value = cbrt(3.0 * R / 4.0 * (F * (1.0 / v6 - E_1 / v6 * expm1(-(t / tau * (E_inf / v6))) / E_inf)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_load_radius_standard_solid_t(F, R, E_inf, E_1, tau):
    v6 = E_inf + E_1
    v8 = E_inf / v6
    v11 = (1.0) / v6
    v12 = E_1 / v6
    v20 = (3.0) * R
    v22 = v20 / (4.0)
    return (F, E_inf, tau, v8, v11, v12, v22)


def block_step_load_radius_standard_solid_t(out, t, F, E_inf, tau, v8, v11, v12, v22):
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
    np.multiply(v22, out, out)
    np.cbrt(out, out)


def prepare_step_load_radius_standard_solid_all():
    return ()


def block_step_load_radius_standard_solid_all(out, t, F, R, E_inf, E_1, tau, t0, t1):
    np.add(E_inf, E_1, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(t, tau, t0)
    np.divide(E_inf, out, t1)
    np.multiply(t0, t1, t1)
    np.divide(C6, out, t0)
    np.divide(E_1, out, out)
    np.negative(t1, t1)
    np.expm1(t1, t1)
    np.multiply(out, t1, t1)
    np.divide(t1, E_inf, t1)
    np.subtract(t0, t1, t1)
    np.multiply(F, t1, t1)
    np.multiply(C5, R, t0)
    np.multiply(t0, t1, t1)
    np.cbrt(t1, out)


BLOCKS = {
    ('_ramp_force_kelvin_voigt', 1, 't', 'R', 'v', 'E', 'eta'): {
        ('t',): (('t',), prepare_ramp_force_kelvin_voigt_t, block_ramp_force_kelvin_voigt_t, 2, 1, (), False),
        ('t', 'R', 'v', 'E', 'eta'): (('t', 'R', 'v', 'E', 'eta'), prepare_ramp_force_kelvin_voigt_all, block_ramp_force_kelvin_voigt_all, 2, 1, (), False),
    },
    ('_step_force_kelvin_voigt', 1, 't', 'd', 'R', 'E', 'eta'): {
        ('t',): (('t',), prepare_step_force_kelvin_voigt_t, block_step_force_kelvin_voigt_t, 0, 1, (), False),
        ('t', 'd', 'R', 'E', 'eta'): (('t', 'd', 'R', 'E', 'eta'), prepare_step_force_kelvin_voigt_all, block_step_force_kelvin_voigt_all, 2, 1, (), False),
    },
    ('_step_force_maxwell', 1, 't', 'd', 'R', 'E', 'tau'): {
        ('t',): (('t',), prepare_step_force_maxwell_t, block_step_force_maxwell_t, 0, 0, (), False),
        ('t', 'd', 'R', 'E', 'tau'): (('t', 'd', 'R', 'E', 'tau'), prepare_step_force_maxwell_all, block_step_force_maxwell_all, 2, 0, (), False),
    },
    ('_step_force_power_creep', 1, 't', 'd', 'R', 'E', 'alpha', 't_0'): {
        ('t',): (('t',), prepare_step_force_power_creep_t, block_step_force_power_creep_t, 0, 0, (), False),
        ('t', 'd', 'R', 'E', 'alpha', 't_0'): (('t', 'd', 'R', 'E', 'alpha', 't_0'), prepare_step_force_power_creep_all, block_step_force_power_creep_all, 2, 0, (), False),
    },
    ('_step_force_standard_solid', 1, 't', 'd', 'R', 'E_inf', 'E_1', 'tau'): {
        ('t',): (('t',), prepare_step_force_standard_solid_t, block_step_force_standard_solid_t, 0, 0, (), False),
        ('t', 'd', 'R', 'E_inf', 'E_1', 'tau'): (('t', 'd', 'R', 'E_inf', 'E_1', 'tau'), prepare_step_force_standard_solid_all, block_step_force_standard_solid_all, 2, 0, (), False),
    },
    ('_step_load_radius_kelvin_voigt', 1, 't', 'F', 'R', 'E', 'eta'): {
        ('t',): (('t',), prepare_step_load_radius_kelvin_voigt_t, block_step_load_radius_kelvin_voigt_t, 0, 0, (), False),
        ('t', 'F', 'R', 'E', 'eta'): (('t', 'F', 'R', 'E', 'eta'), prepare_step_load_radius_kelvin_voigt_all, block_step_load_radius_kelvin_voigt_all, 1, 0, (), False),
    },
    ('_step_load_radius_maxwell', 1, 't', 'F', 'R', 'E', 'tau'): {
        ('t',): (('t',), prepare_step_load_radius_maxwell_t, block_step_load_radius_maxwell_t, 0, 0, (), False),
        ('t', 'F', 'R', 'E', 'tau'): (('t', 'F', 'R', 'E', 'tau'), prepare_step_load_radius_maxwell_all, block_step_load_radius_maxwell_all, 1, 0, (), False),
    },
    ('_step_load_radius_power_creep', 1, 't', 'F', 'R', 'E', 'alpha', 't_0'): {
        ('t',): (('t',), prepare_step_load_radius_power_creep_t, block_step_load_radius_power_creep_t, 0, 0, (), False),
        ('t', 'F', 'R', 'E', 'alpha', 't_0'): (('t', 'F', 'R', 'E', 'alpha', 't_0'), prepare_step_load_radius_power_creep_all, block_step_load_radius_power_creep_all, 1, 0, (), False),
    },
    ('_step_load_radius_standard_solid', 1, 't', 'F', 'R', 'E_inf', 'E_1', 'tau'): {
        ('t',): (('t',), prepare_step_load_radius_standard_solid_t, block_step_load_radius_standard_solid_t, 0, 0, (), False),
        ('t', 'F', 'R', 'E_inf', 'E_1', 'tau'): (('t', 'F', 'R', 'E_inf', 'E_1', 'tau'), prepare_step_load_radius_standard_solid_all, block_step_load_radius_standard_solid_all, 2, 0, (), False),
    },
}
