"""Formulas of axicontact.viscoelastic.concave_power over an array library `xp`."""

from ...._programs.expressions._runtime.physics.relaxation import relaxation_maxwell
from ...._programs.expressions._runtime.physics.relaxation import relaxation_power_creep
from ...._programs.expressions._runtime.physics.relaxation import relaxation_standard_solid
from ...._programs.expressions.normal.concave_power import force as normal_force


def step_force_maxwell(xp, t, d, a, h, n, E, tau):
    return relaxation_maxwell(xp, t, E, tau) * normal_force(xp, d, a, h, n, 1.0)


def step_force_kelvin_voigt(xp, t, d, a, h, n, E, eta):
    v1 = t > 0.0
    v2 = xp.where(v1, t, 1.0)
    return xp.where(v1, E, xp.inf) * normal_force(xp, d, a, h, n, 1.0)


def step_force_standard_solid(xp, t, d, a, h, n, E_inf, E_1, tau):
    return relaxation_standard_solid(xp, t, E_inf, E_1, tau) * normal_force(xp, d, a, h, n, 1.0)


def step_force_power_creep(xp, t, d, a, h, n, E, alpha, t_0):
    return relaxation_power_creep(xp, t, E, alpha, t_0) * normal_force(xp, d, a, h, n, 1.0)
