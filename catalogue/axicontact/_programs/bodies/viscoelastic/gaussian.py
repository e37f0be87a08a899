"""Bodies of axicontact.viscoelastic.gaussian over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import gaussian as normal
from ...._programs.bodies._runtime.physics.relaxation import creep_kelvin_voigt, creep_maxwell, creep_power_creep, creep_standard_solid, relaxation_kelvin_voigt, relaxation_maxwell, relaxation_power_creep, relaxation_standard_solid


def _step_force_maxwell(t, d, h, s, E, tau):
    return relaxation_maxwell(t, E, tau) * normal._force_from_depth(d, h, s, 1.0)


def _step_load_radius_maxwell(t, F, h, s, E, tau):
    return normal._radius_from_force(F * creep_maxwell(t, E, tau), h, s, 1.0)


def _step_force_kelvin_voigt(t, d, h, s, E, eta):
    return relaxation_kelvin_voigt(t, E, eta) * normal._force_from_depth(d, h, s, 1.0)


def _step_load_radius_kelvin_voigt(t, F, h, s, E, eta):
    return normal._radius_from_force(F * creep_kelvin_voigt(t, E, eta), h, s, 1.0)


def _step_force_standard_solid(t, d, h, s, E_inf, E_1, tau):
    return relaxation_standard_solid(t, E_inf, E_1, tau) * normal._force_from_depth(d, h, s, 1.0)


def _step_load_radius_standard_solid(t, F, h, s, E_inf, E_1, tau):
    return normal._radius_from_force(F * creep_standard_solid(t, E_inf, E_1, tau), h, s, 1.0)


def _step_force_power_creep(t, d, h, s, E, alpha, t_0):
    return relaxation_power_creep(t, E, alpha, t_0) * normal._force_from_depth(d, h, s, 1.0)


def _step_load_radius_power_creep(t, F, h, s, E, alpha, t_0):
    return normal._radius_from_force(F * creep_power_creep(t, E, alpha, t_0), h, s, 1.0)
