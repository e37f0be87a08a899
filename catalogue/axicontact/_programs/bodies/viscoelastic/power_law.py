"""Bodies of axicontact.viscoelastic.power_law over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import power_law as normal
from ...._programs.bodies._runtime.physics.relaxation import ramp_maxwell, ramp_power_creep, ramp_standard_solid


def _ramp_force_maxwell(t, v, A, n, E, tau):
    m = (n + 1) / n
    force = normal._force_from_depth(v * t, A, n, 1.0) * ramp_maxwell(t, m, E, tau)
    return 0.0 if t == 0.0 else force


def _ramp_force_standard_solid(t, v, A, n, E_inf, E_1, tau):
    m = (n + 1) / n
    force = normal._force_from_depth(v * t, A, n, 1.0) * ramp_standard_solid(t, m, E_inf, E_1, tau)
    return 0.0 if t == 0.0 else force


def _ramp_force_power_creep(t, v, A, n, E, alpha, t_0):
    m = (n + 1) / n
    force = normal._force_from_depth(v * t, A, n, 1.0) * ramp_power_creep(t, m, E, alpha, t_0)
    return 0.0 if t == 0.0 else force
