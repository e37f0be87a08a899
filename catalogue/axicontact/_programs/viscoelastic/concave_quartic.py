"""Programs of axicontact.viscoelastic.concave_quartic."""

from __future__ import annotations

from math import exp, inf, nan, pow, sin

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(0.0)
C1 = np.array(np.inf)
C2 = np.array(4.0)
C3 = np.array(3.0)
C4 = np.array(0.999999999999999)
C5 = np.array(2.0)
C6 = np.array(8.0)
C7 = np.array(15.0)
C8 = np.array(np.nan)
C9 = np.array(3.141592653589793)


def step_force_kelvin_voigt(t, d, a, h, E, eta):
    if t.__class__ is d.__class__ is a.__class__ is h.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            value = (E if t > 0.0 else inf) * (2.0 * a * (d + 8.0 * h / 15.0) if 4.0 * h / 3.0 * 0.999999999999999 <= d else nan)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_kelvin_voigt_t(d, a, h, E, eta):
    v10 = (4.0) * h
    v12 = v10 / (3.0)
    v14 = v12 * (0.999999999999999)
    v15 = np.less_equal(v14, d)
    v17 = (2.0) * a
    v19 = (8.0) * h
    v21 = v19 / (15.0)
    v22 = d + v21
    v23 = v17 * v22
    v25 = v23 if v15 else (np.nan)
    return (E, v25)


def block_step_force_kelvin_voigt_t(out, t, E, v25, m0):
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
    np.multiply(out, v25, out)


def prepare_step_force_kelvin_voigt_all():
    return ()


def block_step_force_kelvin_voigt_all(out, t, d, a, h, E, eta, t0, t1, m0):
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
    np.divide(t0, C3, t0)
    np.multiply(t0, C4, t0)
    np.less_equal(t0, d, m0)
    some25 = np.count_nonzero(m0)
    if some25:
        np.multiply(C5, a, t0)
        np.multiply(C6, h, t1)
        np.divide(t1, C7, t1)
        np.add(d, t1, t1)
        np.multiply(t0, t1, t0)
    if some25 != size:
        np.copyto(t0, C8, where=~m0)
    np.multiply(out, t0, out)


def step_force_maxwell(t, d, a, h, E, tau):
    if t.__class__ is d.__class__ is a.__class__ is h.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = E * exp(-t / tau) * (2.0 * a * (d + 8.0 * h / 15.0) if 4.0 * h / 3.0 * 0.999999999999999 <= d else nan)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_maxwell_t(d, a, h, E, tau):
    v11 = (4.0) * h
    v13 = v11 / (3.0)
    v15 = v13 * (0.999999999999999)
    v16 = np.less_equal(v15, d)
    v18 = (2.0) * a
    v20 = (8.0) * h
    v22 = v20 / (15.0)
    v23 = d + v22
    v24 = v18 * v23
    v26 = v24 if v16 else (np.nan)
    return (E, tau, v26)


def block_step_force_maxwell_t(out, t, E, tau, v26):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E, out, out)
    np.multiply(out, v26, out)


def prepare_step_force_maxwell_all():
    return ()


def block_step_force_maxwell_all(out, t, d, a, h, E, tau, t0, t1, m0):
    size = out.size
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E, out, out)
    np.multiply(C2, h, t0)
    np.divide(t0, C3, t0)
    np.multiply(t0, C4, t0)
    np.less_equal(t0, d, m0)
    some26 = np.count_nonzero(m0)
    if some26:
        np.multiply(C5, a, t0)
        np.multiply(C6, h, t1)
        np.divide(t1, C7, t1)
        np.add(d, t1, t1)
        np.multiply(t0, t1, t0)
    if some26 != size:
        np.copyto(t0, C8, where=~m0)
    np.multiply(out, t0, out)


def step_force_power_creep(t, d, a, h, E, alpha, t_0):
    if t.__class__ is d.__class__ is a.__class__ is h.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            v11 = 3.141592653589793 * alpha
            value = E * pow(t_0 / t, alpha) * sin(v11) / v11 * (2.0 * a * (d + 8.0 * h / 15.0) if 4.0 * h / 3.0 * 0.999999999999999 <= d else nan)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_power_creep_t(d, a, h, E, alpha, t_0):
    v11 = (3.141592653589793) * alpha
    v12 = np.sin(v11)
    v16 = (4.0) * h
    v18 = v16 / (3.0)
    v20 = v18 * (0.999999999999999)
    v21 = np.less_equal(v20, d)
    v23 = (2.0) * a
    v25 = (8.0) * h
    v27 = v25 / (15.0)
    v28 = d + v27
    v29 = v23 * v28
    v31 = v29 if v21 else (np.nan)
    return (E, alpha, t_0, v11, v12, v31)


def block_step_force_power_creep_t(out, t, E, alpha, t_0, v11, v12, v31):
    np.divide(t_0, t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.power(out, alpha, out)
    np.multiply(E, out, out)
    np.multiply(out, v12, out)
    np.divide(out, v11, out)
    np.multiply(out, v31, out)


def prepare_step_force_power_creep_all():
    return ()


def block_step_force_power_creep_all(out, t, d, a, h, E, alpha, t_0, t0, t1, m0):
    size = out.size
    np.divide(t_0, t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.power(out, alpha, out)
    np.multiply(E, out, out)
    np.multiply(C9, alpha, t0)
    np.sin(t0, t1)
    np.multiply(out, t1, t1)
    np.divide(t1, t0, t0)
    np.multiply(C2, h, t1)
    np.divide(t1, C3, t1)
    np.multiply(t1, C4, t1)
    np.less_equal(t1, d, m0)
    some31 = np.count_nonzero(m0)
    if some31:
        np.multiply(C5, a, t1)
        np.multiply(C6, h, out)
        np.divide(out, C7, out)
        np.add(d, out, out)
        np.multiply(t1, out, t1)
    if some31 != size:
        np.copyto(t1, C8, where=~m0)
    np.multiply(t0, t1, out)


def step_force_standard_solid(t, d, a, h, E_inf, E_1, tau):
    if t.__class__ is d.__class__ is a.__class__ is h.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = (E_inf + E_1 * exp(-t / tau)) * (2.0 * a * (d + 8.0 * h / 15.0) if 4.0 * h / 3.0 * 0.999999999999999 <= d else nan)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_standard_solid_t(d, a, h, E_inf, E_1, tau):
    v13 = (4.0) * h
    v15 = v13 / (3.0)
    v17 = v15 * (0.999999999999999)
    v18 = np.less_equal(v17, d)
    v20 = (2.0) * a
    v22 = (8.0) * h
    v24 = v22 / (15.0)
    v25 = d + v24
    v26 = v20 * v25
    v28 = v26 if v18 else (np.nan)
    return (E_inf, E_1, tau, v28)


def block_step_force_standard_solid_t(out, t, E_inf, E_1, tau, v28):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E_1, out, out)
    np.add(E_inf, out, out)
    np.multiply(out, v28, out)


def prepare_step_force_standard_solid_all():
    return ()


def block_step_force_standard_solid_all(out, t, d, a, h, E_inf, E_1, tau, t0, t1, m0):
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
    np.divide(t0, C3, t0)
    np.multiply(t0, C4, t0)
    np.less_equal(t0, d, m0)
    some28 = np.count_nonzero(m0)
    if some28:
        np.multiply(C5, a, t0)
        np.multiply(C6, h, t1)
        np.divide(t1, C7, t1)
        np.add(d, t1, t1)
        np.multiply(t0, t1, t0)
    if some28 != size:
        np.copyto(t0, C8, where=~m0)
    np.multiply(out, t0, out)


BLOCKS = {
    ('_step_force_kelvin_voigt', 1, 't', 'd', 'a', 'h', 'E', 'eta'): {
        ('t',): (('t',), prepare_step_force_kelvin_voigt_t, block_step_force_kelvin_voigt_t, 0, 1, (), False),
        ('t', 'd', 'a', 'h', 'E', 'eta'): (('t', 'd', 'a', 'h', 'E', 'eta'), prepare_step_force_kelvin_voigt_all, block_step_force_kelvin_voigt_all, 2, 1, (), False),
    },
    ('_step_force_maxwell', 1, 't', 'd', 'a', 'h', 'E', 'tau'): {
        ('t',): (('t',), prepare_step_force_maxwell_t, block_step_force_maxwell_t, 0, 0, (), False),
        ('t', 'd', 'a', 'h', 'E', 'tau'): (('t', 'd', 'a', 'h', 'E', 'tau'), prepare_step_force_maxwell_all, block_step_force_maxwell_all, 2, 1, (), False),
    },
    ('_step_force_power_creep', 1, 't', 'd', 'a', 'h', 'E', 'alpha', 't_0'): {
        ('t',): (('t',), prepare_step_force_power_creep_t, block_step_force_power_creep_t, 0, 0, (), False),
        ('t', 'd', 'a', 'h', 'E', 'alpha', 't_0'): (('t', 'd', 'a', 'h', 'E', 'alpha', 't_0'), prepare_step_force_power_creep_all, block_step_force_power_creep_all, 2, 1, (), False),
    },
    ('_step_force_standard_solid', 1, 't', 'd', 'a', 'h', 'E_inf', 'E_1', 'tau'): {
        ('t',): (('t',), prepare_step_force_standard_solid_t, block_step_force_standard_solid_t, 0, 0, (), False),
        ('t', 'd', 'a', 'h', 'E_inf', 'E_1', 'tau'): (('t', 'd', 'a', 'h', 'E_inf', 'E_1', 'tau'), prepare_step_force_standard_solid_all, block_step_force_standard_solid_all, 2, 1, (), False),
    },
}
