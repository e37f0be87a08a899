"""Bodies of axicontact.graded.tangential.rounded_curved_punch over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies.graded.normal import rounded_curved_punch as normal
from ....._programs.bodies._runtime.physics.slip import stick_force
from .....graded.tangential.rounded_curved_punch import Array


def _stick_radius(F_x: Array, a: Array, R1: Array, R2: Array, b: Array, H: Array, k: Array, mu: Array) -> Array:
    F = stick_force(normal._force(a, R1, R2, b, H, k), F_x, mu)
    return a if (F_x == 0.0) & (a >= 0.0) else normal._radius_from_force(F, R1, R2, b, H, k)


def _full_slip_displacement(a: Array, R1: Array, R2: Array, b: Array, H: Array, H_x: Array, k: Array, mu: Array) -> Array:
    return mu * (H / H_x) * normal._depth(a, R1, R2, b, k)
