"""Bodies of axicontact.tangential.gaussian over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import gaussian as normal
from ...._programs.bodies._runtime.physics.slip import stick_force


def _stick_radius(F_x, a, h, s, E_star, mu):
    F = stick_force(normal._force(a, h, s, E_star), F_x, mu)
    return a if (F_x == 0.0) & (a >= 0.0) else normal._radius_from_force(F, h, s, E_star)
