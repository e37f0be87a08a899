"""Bodies of axicontact.torsion.paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.physics.torsion import slipping_torque, slipping_traction


def _torque(a, c, R, E_star, mu):
    return E_star * mu / R * slipping_torque(a, c)


def _traction(r, a, c, R, E_star, mu):
    return E_star * mu / R * slipping_traction(r, a, c)
