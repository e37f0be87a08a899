"""Formulas of axicontact.torsion.paraboloid over an array library `xp`."""

from ...._programs.expressions._runtime.physics.torsion import slipping_torque
from ...._programs.expressions._runtime.physics.torsion import slipping_traction
from ...._programs.expressions._runtime.physics.torsion import turned


def torque(xp, a, c, R, E_star, mu):
    return E_star * mu / R * slipping_torque(xp, a, c)


def slip_angle(xp, a, c, R, E_star, G, mu):
    return E_star * mu / R / (3.141592653589793 * G) * turned(xp, a, c)


def traction(xp, r, a, c, R, E_star, mu):
    return E_star * mu / R * slipping_traction(xp, r, a, c)


def full_slip_torque(xp, a, R, E_star, mu):
    return 0.7853981633974483 * E_star * mu / R * (a ** 2.0) ** 2.0
