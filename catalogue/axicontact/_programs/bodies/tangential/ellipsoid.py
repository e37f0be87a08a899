"""Bodies of axicontact.tangential.ellipsoid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import ellipsoid as normal
from ...._programs.bodies._runtime.physics.slip import growth_below, stick_force
from ...._runtime.plain import MATH as np

CLOSE = 0.25


def _traction(r, a, c, h, b, E_star, mu):
    sliding = normal._pressure(r, a, h, b, E_star)
    stuck = normal._pressure(r, c, h, b, E_star)
    close = (r < c) & (stuck >= CLOSE * sliding)
    gain = E_star / np.pi * growth_below(normal._slope, (h, b), 0, r, c, a, b, close)
    return mu * (gain if close else sliding - stuck)


def _stick_radius(F_x, a, h, b, E_star, mu):
    F = stick_force(normal._force(a, h, b, E_star), F_x, mu)
    return a if (F_x == 0.0) & (a >= 0.0) else normal._radius_from_force(F, h, b, E_star)
