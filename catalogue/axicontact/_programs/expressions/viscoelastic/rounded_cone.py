"""Formulas of axicontact.viscoelastic.rounded_cone over an array library `xp`."""

from ...._programs.expressions._runtime.physics.relaxation import creep_kelvin_voigt
from ...._programs.expressions._runtime.physics.relaxation import creep_standard_solid
from ...._programs.expressions._runtime.physics.relaxation import relaxation_maxwell
from ...._programs.expressions._runtime.physics.relaxation import relaxation_power_creep
from ...._programs.expressions._runtime.physics.relaxation import relaxation_standard_solid
from ...._programs.expressions.normal.rounded_cone import force_from_depth as normal_force_from_depth
from ...._programs.expressions.normal.rounded_cone import radius_from_force as normal_radius_from_force


def step_force_maxwell(xp, t, d, theta, b, E, tau):
    return relaxation_maxwell(xp, t, E, tau) * normal_force_from_depth(xp, d, theta, b, 1.0)


def step_load_radius_maxwell(xp, t, F, theta, b, E, tau):
    return normal_radius_from_force(xp, F * ((1.0 + t / tau) / E), theta, b, 1.0)


def step_force_kelvin_voigt(xp, t, d, theta, b, E, eta):
    v1 = t > 0.0
    v2 = xp.where(v1, t, 1.0)
    return xp.where(v1, E, xp.inf) * normal_force_from_depth(xp, d, theta, b, 1.0)


def step_load_radius_kelvin_voigt(xp, t, F, theta, b, E, eta):
    return normal_radius_from_force(xp, F * creep_kelvin_voigt(xp, t, E, eta), theta, b, 1.0)


def step_force_standard_solid(xp, t, d, theta, b, E_inf, E_1, tau):
    v1 = relaxation_standard_solid(xp, t, E_inf, E_1, tau)
    return v1 * normal_force_from_depth(xp, d, theta, b, 1.0)


def step_load_radius_standard_solid(xp, t, F, theta, b, E_inf, E_1, tau):
    v3 = normal_radius_from_force(xp, F * creep_standard_solid(xp, t, E_inf, E_1, tau), theta, b, 1.0)
    return v3


def step_force_power_creep(xp, t, d, theta, b, E, alpha, t_0):
    v3 = relaxation_power_creep(xp, t, E, alpha, t_0) * normal_force_from_depth(xp, d, theta, b, 1.0)
    return v3


def step_load_radius_power_creep(xp, t, F, theta, b, E, alpha, t_0):
    return normal_radius_from_force(xp, F * ((t / t_0) ** alpha / E), theta, b, 1.0)
