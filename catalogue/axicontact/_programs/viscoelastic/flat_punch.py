"""Programs of axicontact.viscoelastic.flat_punch."""

from __future__ import annotations

from math import exp, inf, pow, sin

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._programs.bodies.viscoelastic import flat_punch as bodies

C0 = np.array(0.0)
C1 = np.array(2.0)
C2 = np.array(np.inf)
C3 = np.array(3.141592653589793)


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
        np.multiply(C1, other17, other17)
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
        np.multiply(C1, v, out)
        np.multiply(out, a, out)
        np.multiply(out, eta, out)
    if some17 != size:
        other17 = t0 if some17 else out
        np.multiply(v, t, other17)
        np.multiply(C1, other17, other17)
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
    np.multiply(C1, d, t0)
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
    np.multiply(C1, d, t0)
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
    np.multiply(C3, alpha, t0)
    np.sin(t0, t1)
    np.multiply(out, t1, t1)
    np.divide(t1, t0, t0)
    np.multiply(C1, d, t1)
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
    np.multiply(C1, d, t0)
    np.multiply(t0, a, t0)
    np.multiply(out, t0, out)


BLOCKS = {
    ('_ramp_force_kelvin_voigt', 1, 't', 'a', 'v', 'E', 'eta'): {
        ('t',): (('t',), prepare_ramp_force_kelvin_voigt_t, block_ramp_force_kelvin_voigt_t, 2, 1, (), False),
        ('t', 'a', 'v', 'E', 'eta'): (('t', 'a', 'v', 'E', 'eta'), prepare_ramp_force_kelvin_voigt_all, block_ramp_force_kelvin_voigt_all, 2, 1, (), False),
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
