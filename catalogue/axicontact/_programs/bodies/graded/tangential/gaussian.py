"""Bodies of axicontact.graded.tangential.gaussian over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies.graded.normal import gaussian as normal
from ....._programs.bodies._runtime.physics.slip import stick_force


def _stick_radius(F_x, a, h, s, H, k, mu):
    F = stick_force(normal._force(a, h, s, H, k), F_x, mu)
    return a if (F_x == 0.0) & (a >= 0.0) else normal._radius_from_force(F, h, s, H, k)


def _full_slip_displacement(a, h, s, H, H_x, k, mu):
    return mu * (H / H_x) * normal._depth(a, h, s, k)
