"""Bodies of axicontact.tangential.sphere_tipped_cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import sphere_tipped_cone as normal
from ...._programs.bodies._runtime.physics.slip import growth_below, growth_beyond, stick_force
from ...._runtime.plain import MATH as np

CLOSE = 0.25


def _traction(r, a, c, R, theta, E_star, mu):
    sliding = normal._pressure(r, a, R, theta, E_star)
    stuck = normal._pressure(r, c, R, theta, E_star)
    close = (r < c) & (stuck >= CLOSE * sliding)
    b = R * np.sin(theta)
    tip = growth_below(normal._slope, (R,), 0, r, c, np.minimum(a, b), R, close)
    beyond = growth_beyond(normal._slope_beyond, (R, theta), 0, r, c, a, b, close, width=1.0 - 2.0 * theta / np.pi)
    gain = E_star / np.pi * (tip + beyond)
    return mu * (gain if close else sliding - stuck)


def _stick_radius(F_x, a, R, theta, E_star, mu):
    F = stick_force(normal._force(a, R, theta, E_star), F_x, mu)
    return a if (F_x == 0.0) & (a >= 0.0) else normal._radius_from_force(F, R, theta, E_star)
