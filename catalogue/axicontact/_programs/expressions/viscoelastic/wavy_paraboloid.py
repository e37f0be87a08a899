"""Formulas of axicontact.viscoelastic.wavy_paraboloid over an array library `xp`."""

from ...._programs.expressions._runtime.physics.relaxation import creep_kelvin_voigt
from ...._programs.expressions._runtime.physics.relaxation import creep_standard_solid
from ...._programs.expressions._runtime.physics.relaxation import relaxation_maxwell
from ...._programs.expressions._runtime.physics.relaxation import relaxation_power_creep
from ...._programs.expressions._runtime.physics.relaxation import relaxation_standard_solid
from ...._programs.expressions.normal.wavy_paraboloid import force_from_depth as normal_force_from_depth
from ...._programs.expressions.normal.wavy_paraboloid import radius_from_force as normal_radius_from_force


def step_force_maxwell(xp, t, d, R, h, wavelength, E, tau):
    v3 = relaxation_maxwell(xp, t, E, tau) * normal_force_from_depth(xp, d, R, h, wavelength, 1.0)
    return v3


def step_load_radius_maxwell(xp, t, F, R, h, wavelength, E, tau):
    return normal_radius_from_force(xp, F * ((1.0 + t / tau) / E), R, h, wavelength, 1.0)


def step_force_kelvin_voigt(xp, t, d, R, h, wavelength, E, eta):
    v1 = t > 0.0
    v2 = xp.where(v1, t, 1.0)
    return xp.where(v1, E, xp.inf) * normal_force_from_depth(xp, d, R, h, wavelength, 1.0)


def step_load_radius_kelvin_voigt(xp, t, F, R, h, wavelength, E, eta):
    v3 = normal_radius_from_force(xp, F * creep_kelvin_voigt(xp, t, E, eta), R, h, wavelength, 1.0)
    return v3


def step_force_standard_solid(xp, t, d, R, h, wavelength, E_inf, E_1, tau):
    v2 = normal_force_from_depth(xp, d, R, h, wavelength, 1.0)
    return relaxation_standard_solid(xp, t, E_inf, E_1, tau) * v2


def step_load_radius_standard_solid(xp, t, F, R, h, wavelength, E_inf, E_1, tau):
    v2 = F * creep_standard_solid(xp, t, E_inf, E_1, tau)
    return normal_radius_from_force(xp, v2, R, h, wavelength, 1.0)


def step_force_power_creep(xp, t, d, R, h, wavelength, E, alpha, t_0):
    v2 = normal_force_from_depth(xp, d, R, h, wavelength, 1.0)
    return relaxation_power_creep(xp, t, E, alpha, t_0) * v2


def step_load_radius_power_creep(xp, t, F, R, h, wavelength, E, alpha, t_0):
    return normal_radius_from_force(xp, F * ((t / t_0) ** alpha / E), R, h, wavelength, 1.0)
