"""Formulas of axicontact.torsion.flat_punch over an array library `xp`."""

from ...._programs.expressions._runtime.physics.torsion import turned_below


def torque(xp, beta, a, G):
    return 5.333333333333333 * G * (a * a ** 2.0) * beta


def displacement(xp, r, z, a, beta):
    return beta * turned_below(xp, r, z, a)
