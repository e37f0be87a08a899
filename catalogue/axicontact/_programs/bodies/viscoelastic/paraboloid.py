"""Bodies of axicontact.viscoelastic.paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import paraboloid as normal
from ...._programs.bodies._runtime.physics.relaxation import ramp_maxwell, ramp_power_creep, ramp_standard_solid
from ....viscoelastic.paraboloid import Array


def _ramp_force_maxwell(t: Array, v: Array, R: Array, E: Array, tau: Array) -> Array:
    force = normal._force_from_depth(v * t, R, 1.0) * ramp_maxwell(t, 1.5, E, tau)
    return 0.0 if t == 0.0 else force


def _ramp_force_standard_solid(t: Array, v: Array, R: Array, E_inf: Array, E_1: Array, tau: Array) -> Array:
    force = normal._force_from_depth(v * t, R, 1.0) * ramp_standard_solid(t, 1.5, E_inf, E_1, tau)
    return 0.0 if t == 0.0 else force


def _ramp_force_power_creep(t: Array, v: Array, R: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    force = normal._force_from_depth(v * t, R, 1.0) * ramp_power_creep(t, 1.5, E, alpha, t_0)
    return 0.0 if t == 0.0 else force
