"""Bodies of axicontact.viscoelastic.quartic over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import quartic as normal
from ...._programs.bodies._runtime.physics.relaxation import ramp_maxwell, ramp_power_creep, ramp_standard_solid


def _ramp_force_maxwell(t, v, A, E, tau):
    force = normal._force_from_depth(v * t, A, 1.0) * ramp_maxwell(t, 1.25, E, tau)
    return 0.0 if t == 0.0 else force


def _ramp_force_standard_solid(t, v, A, E_inf, E_1, tau):
    force = normal._force_from_depth(v * t, A, 1.0) * ramp_standard_solid(t, 1.25, E_inf, E_1, tau)
    return 0.0 if t == 0.0 else force


def _ramp_force_power_creep(t, v, A, E, alpha, t_0):
    force = normal._force_from_depth(v * t, A, 1.0) * ramp_power_creep(t, 1.25, E, alpha, t_0)
    return 0.0 if t == 0.0 else force
