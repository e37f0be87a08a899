"""Bodies of axicontact.tangential.ellipsoid over plain numbers: the same text with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import ellipsoid as normal
from ...._programs.bodies._runtime.physics.slip import stick_force
from ....tangential.ellipsoid import Array
from ...._runtime.plain import MATH as np


def _stick_radius(F_x: Array, a: Array, h: Array, b: Array, E_star: Array, mu: Array) -> Array:
    F = stick_force(normal._force(a, h, b, E_star), F_x, mu)
    return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force(F, h, b, E_star))
