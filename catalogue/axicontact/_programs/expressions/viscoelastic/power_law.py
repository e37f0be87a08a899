"""Formulas of axicontact.viscoelastic.power_law over an array library `xp`."""

from ...._programs.expressions._runtime.physics.relaxation import creep_kelvin_voigt
from ...._programs.expressions._runtime.physics.relaxation import creep_standard_solid
from ...._programs.expressions._runtime.physics.relaxation import ramp_power_creep
from ...._programs.expressions._runtime.physics.relaxation import ramp_standard_solid
from ...._programs.expressions._runtime.physics.relaxation import relaxation_maxwell
from ...._programs.expressions._runtime.physics.relaxation import relaxation_power_creep
from ...._programs.expressions._runtime.physics.relaxation import relaxation_standard_solid
from ...._programs.expressions.normal.power_law import force_from_depth as normal_force_from_depth
from ...._programs.expressions.normal.power_law import radius_from_force as normal_radius_from_force
from ...._runtime.steps import fading


def ramp_force_maxwell(xp, t, v, A, n, E, tau):
    v9 = normal_force_from_depth(xp, v * t, A, n, 1.0) * (E * fading(xp, t / tau, (n + 1.0) / n))
    return xp.where(t == 0.0, 0.0, v9)


def step_force_maxwell(xp, t, d, A, n, E, tau):
    return relaxation_maxwell(xp, t, E, tau) * normal_force_from_depth(xp, d, A, n, 1.0)


def step_load_radius_maxwell(xp, t, F, A, n, E, tau):
    return normal_radius_from_force(xp, F * ((1.0 + t / tau) / E), A, n, 1.0)


def ramp_force_kelvin_voigt(xp, t, v, A, n, E, eta):
    v9 = normal_force_from_depth(xp, v * t, A, n, 1.0) * (E + eta * ((n + 1.0) / n) / t)
    return xp.where(t == 0.0, 0.0, v9)


def step_force_kelvin_voigt(xp, t, d, A, n, E, eta):
    v1 = t > 0.0
    v2 = xp.where(v1, t, 1.0)
    return xp.where(v1, E, xp.inf) * normal_force_from_depth(xp, d, A, n, 1.0)


def step_load_radius_kelvin_voigt(xp, t, F, A, n, E, eta):
    return normal_radius_from_force(xp, F * creep_kelvin_voigt(xp, t, E, eta), A, n, 1.0)


def ramp_force_standard_solid(xp, t, v, A, n, E_inf, E_1, tau):
    v6 = ramp_standard_solid(xp, t, (n + 1.0) / n, E_inf, E_1, tau)
    return xp.where(t == 0.0, 0.0, normal_force_from_depth(xp, v * t, A, n, 1.0) * v6)


def step_force_standard_solid(xp, t, d, A, n, E_inf, E_1, tau):
    v3 = relaxation_standard_solid(xp, t, E_inf, E_1, tau) * normal_force_from_depth(xp, d, A, n, 1.0)
    return v3


def step_load_radius_standard_solid(xp, t, F, A, n, E_inf, E_1, tau):
    v3 = normal_radius_from_force(xp, F * creep_standard_solid(xp, t, E_inf, E_1, tau), A, n, 1.0)
    return v3


def ramp_force_power_creep(xp, t, v, A, n, E, alpha, t_0):
    v6 = ramp_power_creep(xp, t, (n + 1.0) / n, E, alpha, t_0)
    return xp.where(t == 0.0, 0.0, normal_force_from_depth(xp, v * t, A, n, 1.0) * v6)


def step_force_power_creep(xp, t, d, A, n, E, alpha, t_0):
    v3 = relaxation_power_creep(xp, t, E, alpha, t_0) * normal_force_from_depth(xp, d, A, n, 1.0)
    return v3


def step_load_radius_power_creep(xp, t, F, A, n, E, alpha, t_0):
    return normal_radius_from_force(xp, F * ((t / t_0) ** alpha / E), A, n, 1.0)
