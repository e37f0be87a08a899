"""Bodies of axicontact.loads.power over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.physics.circle import power
from ....loads.power import Array


def _displacement(r: Array, a: Array, p_0: Array, s: Array, E_star: Array) -> Array:
    return p_0 / E_star * a * power(r, a, s)
