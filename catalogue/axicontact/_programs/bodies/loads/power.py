"""Bodies of axicontact.loads.power over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.physics.circle import power


def _displacement(r, a, p_0, s, E_star):
    return p_0 / E_star * a * power(r, a, s)
