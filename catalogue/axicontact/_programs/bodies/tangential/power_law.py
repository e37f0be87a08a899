"""Bodies of axicontact.tangential.power_law over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import power_law as normal
from ...._programs.bodies._runtime.physics.slip import power_gain
from ...._runtime.plain import MATH as np


def _traction(r, a, c, A, n, E_star, mu):
    sliding = normal._pressure(r, a, A, n, E_star)
    gain = E_star / np.pi * normal._slope(a, A, n) * power_gain(r, c, a, n)
    return mu * (gain if r < c else sliding)
