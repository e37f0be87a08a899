"""Bodies of axicontact.graded.tangential.rounded_cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies.graded.normal import rounded_cone as normal
from ....._programs.bodies._runtime.physics.slip import stick_force


def _stick_radius(F_x, a, theta, b, H, k, mu):
    F = stick_force(normal._force(a, theta, b, H, k), F_x, mu)
    return a if (F_x == 0.0) & (a >= 0.0) else normal._radius_from_force(F, theta, b, H, k)


def _full_slip_displacement(a, theta, b, H, H_x, k, mu):
    return mu * (H / H_x) * normal._depth(a, theta, b, k)
