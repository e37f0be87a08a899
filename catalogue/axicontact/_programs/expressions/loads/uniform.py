"""Formulas of axicontact.loads.uniform over an array library `xp`."""

from ...._programs.expressions._runtime.physics.circle import uniform


def displacement(xp, r, a, p_0, E_star):
    return p_0 / E_star * a * uniform(xp, r, a)
