"""Bodies of axicontact.viscoelastic.cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import cone as normal
from ...._programs.bodies._runtime.physics.relaxation import ramp_maxwell, ramp_power_creep, ramp_standard_solid


def _ramp_force_maxwell(t, v, theta, E, tau):
    force = normal._force_from_depth(v * t, theta, 1.0) * ramp_maxwell(t, 2.0, E, tau)
    return 0.0 if t == 0.0 else force


def _ramp_force_standard_solid(t, v, theta, E_inf, E_1, tau):
    force = normal._force_from_depth(v * t, theta, 1.0) * ramp_standard_solid(t, 2.0, E_inf, E_1, tau)
    return 0.0 if t == 0.0 else force


def _ramp_force_power_creep(t, v, theta, E, alpha, t_0):
    force = normal._force_from_depth(v * t, theta, 1.0) * ramp_power_creep(t, 2.0, E, alpha, t_0)
    return 0.0 if t == 0.0 else force
