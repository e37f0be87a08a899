"""Bodies of axicontact.tangential.polynomial over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import polynomial as normal
from ...._programs.bodies._runtime.physics.slip import gained_share, power_gain, stick_force
from ...._runtime.plain import MATH as np


def _tangential_force(a, c, A, E_star, mu):
    gains = (normal._force(a, (0.0,) * (j - 1) + (A_j,), E_star) * gained_share(c, a, j + 1) for j, A_j in enumerate(A, 1))
    return mu * sum(gains)


def _traction(r, a, c, A, E_star, mu):
    sliding = normal._pressure(r, a, A, E_star)
    gains = (normal._slope(a, (0.0,) * (j - 1) + (A_j,)) * power_gain(r, c, a, j) for j, A_j in enumerate(A, 1))
    return mu * (E_star / np.pi * sum(gains) if r < c else sliding)


def _tangential_displacement(a, c, A, E_star, G_star, mu):
    gains = (normal._depth(a, (0.0,) * (j - 1) + (A_j,)) * gained_share(c, a, j) for j, A_j in enumerate(A, 1))
    return mu * (E_star / G_star) * sum(gains)


def _stick_radius(F_x, a, A, E_star, mu):
    F = stick_force(normal._force(a, A, E_star), F_x, mu)
    return a if (F_x == 0.0) & (a >= 0.0) else normal._radius_from_force(F, A, E_star)


def _full_slip_displacement(a, A, E_star, G_star, mu):
    return mu * (E_star / G_star) * normal._depth(a, A)
