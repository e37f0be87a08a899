"""Bodies of axicontact.viscoelastic.hyperboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import hyperboloid as normal
from ...._programs.bodies._runtime.physics.relaxation import creep_kelvin_voigt, creep_maxwell, creep_power_creep, creep_standard_solid, relaxation_kelvin_voigt, relaxation_maxwell, relaxation_power_creep, relaxation_standard_solid


def _step_force_maxwell(t, d, theta, b, E, tau):
    return relaxation_maxwell(t, E, tau) * normal._force_from_depth(d, theta, b, 1.0)


def _step_load_radius_maxwell(t, F, theta, b, E, tau):
    return normal._radius_from_force(F * creep_maxwell(t, E, tau), theta, b, 1.0)


def _step_force_kelvin_voigt(t, d, theta, b, E, eta):
    return relaxation_kelvin_voigt(t, E, eta) * normal._force_from_depth(d, theta, b, 1.0)


def _step_load_radius_kelvin_voigt(t, F, theta, b, E, eta):
    return normal._radius_from_force(F * creep_kelvin_voigt(t, E, eta), theta, b, 1.0)


def _step_force_standard_solid(t, d, theta, b, E_inf, E_1, tau):
    return relaxation_standard_solid(t, E_inf, E_1, tau) * normal._force_from_depth(d, theta, b, 1.0)


def _step_load_radius_standard_solid(t, F, theta, b, E_inf, E_1, tau):
    return normal._radius_from_force(F * creep_standard_solid(t, E_inf, E_1, tau), theta, b, 1.0)


def _step_force_power_creep(t, d, theta, b, E, alpha, t_0):
    return relaxation_power_creep(t, E, alpha, t_0) * normal._force_from_depth(d, theta, b, 1.0)


def _step_load_radius_power_creep(t, F, theta, b, E, alpha, t_0):
    return normal._radius_from_force(F * creep_power_creep(t, E, alpha, t_0), theta, b, 1.0)
