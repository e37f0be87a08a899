"""Bodies of axicontact.viscoelastic.flat_punch over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import flat_punch as normal
from ...._programs.bodies._runtime.physics.relaxation import ramp_maxwell, ramp_power_creep, ramp_standard_solid


def _ramp_force_maxwell(t, v, a, E, tau):
    force = normal._force(v * t, a, 1.0) * ramp_maxwell(t, 1.0, E, tau)
    return 0.0 if t == 0.0 else force


def _ramp_force_standard_solid(t, v, a, E_inf, E_1, tau):
    force = normal._force(v * t, a, 1.0) * ramp_standard_solid(t, 1.0, E_inf, E_1, tau)
    return 0.0 if t == 0.0 else force


def _ramp_force_power_creep(t, v, a, E, alpha, t_0):
    force = normal._force(v * t, a, 1.0) * ramp_power_creep(t, 1.0, E, alpha, t_0)
    return 0.0 if t == 0.0 else force
