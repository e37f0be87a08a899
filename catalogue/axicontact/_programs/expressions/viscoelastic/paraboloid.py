"""Formulas of axicontact.viscoelastic.paraboloid over an array library `xp`."""

from ...._programs.expressions._runtime.physics.relaxation import creep_kelvin_voigt
from ...._programs.expressions._runtime.physics.relaxation import creep_standard_solid
from ...._programs.expressions._runtime.physics.relaxation import ramp_power_creep
from ...._programs.expressions._runtime.physics.relaxation import ramp_standard_solid
from ...._programs.expressions._runtime.physics.relaxation import relaxation_maxwell
from ...._programs.expressions._runtime.physics.relaxation import relaxation_power_creep
from ...._programs.expressions._runtime.physics.relaxation import relaxation_standard_solid
from ...._programs.expressions.normal.paraboloid import force_from_depth as normal_force_from_depth
from ...._programs.expressions.normal.paraboloid import radius_from_force as normal_radius_from_force
from ...._runtime.steps import fading


def ramp_force_maxwell(xp, t, v, R, E, tau):
    v7 = normal_force_from_depth(xp, v * t, R, 1.0) * (E * fading(xp, t / tau, 1.5))
    return xp.where(t == 0.0, 0.0, v7)


def step_force_maxwell(xp, t, d, R, E, tau):
    return relaxation_maxwell(xp, t, E, tau) * normal_force_from_depth(xp, d, R, 1.0)


def step_load_radius_maxwell(xp, t, F, R, E, tau):
    return normal_radius_from_force(xp, F * ((1.0 + t / tau) / E), R, 1.0)


def ramp_force_kelvin_voigt(xp, t, v, R, E, eta):
    v7 = normal_force_from_depth(xp, v * t, R, 1.0) * (E + eta * 1.5 / t)
    return xp.where(t == 0.0, 0.0, v7)


def step_force_kelvin_voigt(xp, t, d, R, E, eta):
    v1 = t > 0.0
    v2 = xp.where(v1, t, 1.0)
    return xp.where(v1, E, xp.inf) * normal_force_from_depth(xp, d, R, 1.0)


def step_load_radius_kelvin_voigt(xp, t, F, R, E, eta):
    return normal_radius_from_force(xp, F * creep_kelvin_voigt(xp, t, E, eta), R, 1.0)


def ramp_force_standard_solid(xp, t, v, R, E_inf, E_1, tau):
    v5 = normal_force_from_depth(xp, v * t, R, 1.0) * ramp_standard_solid(xp, t, 1.5, E_inf, E_1, tau)
    return xp.where(t == 0.0, 0.0, v5)


def step_force_standard_solid(xp, t, d, R, E_inf, E_1, tau):
    v3 = relaxation_standard_solid(xp, t, E_inf, E_1, tau) * normal_force_from_depth(xp, d, R, 1.0)
    return v3


def step_load_radius_standard_solid(xp, t, F, R, E_inf, E_1, tau):
    return normal_radius_from_force(xp, F * creep_standard_solid(xp, t, E_inf, E_1, tau), R, 1.0)


def ramp_force_power_creep(xp, t, v, R, E, alpha, t_0):
    v5 = normal_force_from_depth(xp, v * t, R, 1.0) * ramp_power_creep(xp, t, 1.5, E, alpha, t_0)
    return xp.where(t == 0.0, 0.0, v5)


def step_force_power_creep(xp, t, d, R, E, alpha, t_0):
    return relaxation_power_creep(xp, t, E, alpha, t_0) * normal_force_from_depth(xp, d, R, 1.0)


def step_load_radius_power_creep(xp, t, F, R, E, alpha, t_0):
    return normal_radius_from_force(xp, F * ((t / t_0) ** alpha / E), R, 1.0)
