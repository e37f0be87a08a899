"""Programs of axicontact.viscoelastic.concave_paraboloid."""

from __future__ import annotations

from math import exp, inf, nan, pow, sin

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(0.0)
C1 = np.array(np.inf)
C2 = np.array(2.0)
C3 = np.array(0.999999999999999)
C4 = np.array(3.0)
C5 = np.array(np.nan)
C6 = np.array(3.141592653589793)


def step_force_kelvin_voigt(t, d, a, h, E, eta):
    if t.__class__ is d.__class__ is a.__class__ is h.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            v11 = 2.0 * h
            value = (E if t > 0.0 else inf) * (2.0 * a * (d + v11 / 3.0) if v11 * 0.999999999999999 <= d else nan)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_kelvin_voigt_t(d, a, h, E, eta):
    v10 = (2.0) * h
    v12 = v10 * (0.999999999999999)
    v13 = np.less_equal(v12, d)
    v14 = (2.0) * a
    v16 = v10 / (3.0)
    v17 = d + v16
    v18 = v14 * v17
    v20 = v18 if v13 else (np.nan)
    return (E, v20)


def block_step_force_kelvin_voigt_t(out, t, E, v20, m0):
    size = out.size
    np.greater(t, C0, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some8 = np.count_nonzero(m0)
    if some8:
        np.copyto(out, E)
    if some8 != size:
        np.copyto(out, C1, where=~m0)
    np.multiply(out, v20, out)


def prepare_step_force_kelvin_voigt_all():
    return ()


def block_step_force_kelvin_voigt_all(out, t, d, a, h, E, eta, t0, t1, t2, m0):
    size = out.size
    np.greater(t, C0, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some8 = np.count_nonzero(m0)
    if some8:
        np.copyto(out, E)
    if some8 != size:
        np.copyto(out, C1, where=~m0)
    np.multiply(C2, h, t0)
    np.multiply(t0, C3, t1)
    np.less_equal(t1, d, m0)
    some20 = np.count_nonzero(m0)
    if some20:
        np.multiply(C2, a, t1)
        np.divide(t0, C4, t2)
        np.add(d, t2, t2)
        np.multiply(t1, t2, t1)
    if some20 != size:
        np.copyto(t1, C5, where=~m0)
    np.multiply(out, t1, out)


def step_force_maxwell(t, d, a, h, E, tau):
    if t.__class__ is d.__class__ is a.__class__ is h.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            v11 = 2.0 * h
            value = E * exp(-t / tau) * (2.0 * a * (d + v11 / 3.0) if v11 * 0.999999999999999 <= d else nan)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_maxwell_t(d, a, h, E, tau):
    v11 = (2.0) * h
    v13 = v11 * (0.999999999999999)
    v14 = np.less_equal(v13, d)
    v15 = (2.0) * a
    v17 = v11 / (3.0)
    v18 = d + v17
    v19 = v15 * v18
    v21 = v19 if v14 else (np.nan)
    return (E, tau, v21)


def block_step_force_maxwell_t(out, t, E, tau, v21):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E, out, out)
    np.multiply(out, v21, out)


def prepare_step_force_maxwell_all():
    return ()


def block_step_force_maxwell_all(out, t, d, a, h, E, tau, t0, t1, t2, m0):
    size = out.size
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E, out, out)
    np.multiply(C2, h, t0)
    np.multiply(t0, C3, t1)
    np.less_equal(t1, d, m0)
    some21 = np.count_nonzero(m0)
    if some21:
        np.multiply(C2, a, t1)
        np.divide(t0, C4, t2)
        np.add(d, t2, t2)
        np.multiply(t1, t2, t1)
    if some21 != size:
        np.copyto(t1, C5, where=~m0)
    np.multiply(out, t1, out)


def step_force_power_creep(t, d, a, h, E, alpha, t_0):
    if t.__class__ is d.__class__ is a.__class__ is h.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            v11 = 3.141592653589793 * alpha
            v16 = 2.0 * h
            value = E * pow(t_0 / t, alpha) * sin(v11) / v11 * (2.0 * a * (d + v16 / 3.0) if v16 * 0.999999999999999 <= d else nan)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_power_creep_t(d, a, h, E, alpha, t_0):
    v11 = (3.141592653589793) * alpha
    v12 = np.sin(v11)
    v16 = (2.0) * h
    v18 = v16 * (0.999999999999999)
    v19 = np.less_equal(v18, d)
    v20 = (2.0) * a
    v22 = v16 / (3.0)
    v23 = d + v22
    v24 = v20 * v23
    v26 = v24 if v19 else (np.nan)
    return (E, alpha, t_0, v11, v12, v26)


def block_step_force_power_creep_t(out, t, E, alpha, t_0, v11, v12, v26):
    np.divide(t_0, t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.power(out, alpha, out)
    np.multiply(E, out, out)
    np.multiply(out, v12, out)
    np.divide(out, v11, out)
    np.multiply(out, v26, out)


def prepare_step_force_power_creep_all():
    return ()


def block_step_force_power_creep_all(out, t, d, a, h, E, alpha, t_0, t0, t1, t2, m0):
    size = out.size
    np.divide(t_0, t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.power(out, alpha, out)
    np.multiply(E, out, out)
    np.multiply(C6, alpha, t0)
    np.sin(t0, t1)
    np.multiply(out, t1, t1)
    np.divide(t1, t0, t0)
    np.multiply(C2, h, t1)
    np.multiply(t1, C3, out)
    np.less_equal(out, d, m0)
    some26 = np.count_nonzero(m0)
    if some26:
        np.multiply(C2, a, out)
        np.divide(t1, C4, t2)
        np.add(d, t2, t2)
        np.multiply(out, t2, out)
    if some26 != size:
        np.copyto(out, C5, where=~m0)
    np.multiply(t0, out, out)


def step_force_standard_solid(t, d, a, h, E_inf, E_1, tau):
    if t.__class__ is d.__class__ is a.__class__ is h.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            v13 = 2.0 * h
            value = (E_inf + E_1 * exp(-t / tau)) * (2.0 * a * (d + v13 / 3.0) if v13 * 0.999999999999999 <= d else nan)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_standard_solid_t(d, a, h, E_inf, E_1, tau):
    v13 = (2.0) * h
    v15 = v13 * (0.999999999999999)
    v16 = np.less_equal(v15, d)
    v17 = (2.0) * a
    v19 = v13 / (3.0)
    v20 = d + v19
    v21 = v17 * v20
    v23 = v21 if v16 else (np.nan)
    return (E_inf, E_1, tau, v23)


def block_step_force_standard_solid_t(out, t, E_inf, E_1, tau, v23):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E_1, out, out)
    np.add(E_inf, out, out)
    np.multiply(out, v23, out)


def prepare_step_force_standard_solid_all():
    return ()


def block_step_force_standard_solid_all(out, t, d, a, h, E_inf, E_1, tau, t0, t1, t2, m0):
    size = out.size
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E_1, out, out)
    np.add(E_inf, out, out)
    np.multiply(C2, h, t0)
    np.multiply(t0, C3, t1)
    np.less_equal(t1, d, m0)
    some23 = np.count_nonzero(m0)
    if some23:
        np.multiply(C2, a, t1)
        np.divide(t0, C4, t2)
        np.add(d, t2, t2)
        np.multiply(t1, t2, t1)
    if some23 != size:
        np.copyto(t1, C5, where=~m0)
    np.multiply(out, t1, out)


BLOCKS = {
    ('_step_force_kelvin_voigt', 1, 't', 'd', 'a', 'h', 'E', 'eta'): {
        ('t',): (('t',), prepare_step_force_kelvin_voigt_t, block_step_force_kelvin_voigt_t, 0, 1, (), False),
        ('t', 'd', 'a', 'h', 'E', 'eta'): (('t', 'd', 'a', 'h', 'E', 'eta'), prepare_step_force_kelvin_voigt_all, block_step_force_kelvin_voigt_all, 3, 1, (), False),
    },
    ('_step_force_maxwell', 1, 't', 'd', 'a', 'h', 'E', 'tau'): {
        ('t',): (('t',), prepare_step_force_maxwell_t, block_step_force_maxwell_t, 0, 0, (), False),
        ('t', 'd', 'a', 'h', 'E', 'tau'): (('t', 'd', 'a', 'h', 'E', 'tau'), prepare_step_force_maxwell_all, block_step_force_maxwell_all, 3, 1, (), False),
    },
    ('_step_force_power_creep', 1, 't', 'd', 'a', 'h', 'E', 'alpha', 't_0'): {
        ('t',): (('t',), prepare_step_force_power_creep_t, block_step_force_power_creep_t, 0, 0, (), False),
        ('t', 'd', 'a', 'h', 'E', 'alpha', 't_0'): (('t', 'd', 'a', 'h', 'E', 'alpha', 't_0'), prepare_step_force_power_creep_all, block_step_force_power_creep_all, 3, 1, (), False),
    },
    ('_step_force_standard_solid', 1, 't', 'd', 'a', 'h', 'E_inf', 'E_1', 'tau'): {
        ('t',): (('t',), prepare_step_force_standard_solid_t, block_step_force_standard_solid_t, 0, 0, (), False),
        ('t', 'd', 'a', 'h', 'E_inf', 'E_1', 'tau'): (('t', 'd', 'a', 'h', 'E_inf', 'E_1', 'tau'), prepare_step_force_standard_solid_all, block_step_force_standard_solid_all, 3, 1, (), False),
    },
}
