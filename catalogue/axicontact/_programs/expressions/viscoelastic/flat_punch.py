"""Formulas of axicontact.viscoelastic.flat_punch over an array library `xp`."""

from ...._programs.expressions._runtime.physics.relaxation import ramp_power_creep
from ...._programs.expressions._runtime.physics.relaxation import ramp_standard_solid
from ...._programs.expressions._runtime.physics.relaxation import relaxation_maxwell
from ...._programs.expressions._runtime.physics.relaxation import relaxation_power_creep
from ...._programs.expressions._runtime.physics.relaxation import relaxation_standard_solid
from ...._runtime.steps import fading


def ramp_force_maxwell(xp, t, v, a, E, tau):
    return xp.where(t == 0.0, 0.0, 2.0 * (v * t) * a * (E * fading(xp, t / tau, 1.0)))


def step_force_maxwell(xp, t, d, a, E, tau):
    return relaxation_maxwell(xp, t, E, tau) * (2.0 * d * a)


def ramp_force_kelvin_voigt(xp, t, v, a, E, eta):
    return xp.where(t == 0.0, 2.0 * v * a * eta, 2.0 * (v * t) * a * (E + eta / t))


def step_force_kelvin_voigt(xp, t, d, a, E, eta):
    v1 = t > 0.0
    v2 = xp.where(v1, t, 1.0)
    return xp.where(v1, E, xp.inf) * (2.0 * d * a)


def ramp_force_standard_solid(xp, t, v, a, E_inf, E_1, tau):
    v6 = 2.0 * (v * t) * a * ramp_standard_solid(xp, t, 1.0, E_inf, E_1, tau)
    return xp.where(t == 0.0, 0.0, v6)


def step_force_standard_solid(xp, t, d, a, E_inf, E_1, tau):
    return relaxation_standard_solid(xp, t, E_inf, E_1, tau) * (2.0 * d * a)


def ramp_force_power_creep(xp, t, v, a, E, alpha, t_0):
    v7 = xp.where(t == 0.0, 0.0, 2.0 * (v * t) * a * ramp_power_creep(xp, t, 1.0, E, alpha, t_0))
    return v7


def step_force_power_creep(xp, t, d, a, E, alpha, t_0):
    return relaxation_power_creep(xp, t, E, alpha, t_0) * (2.0 * d * a)
