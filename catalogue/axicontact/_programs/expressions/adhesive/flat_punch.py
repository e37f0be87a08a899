"""Formulas of axicontact.adhesive.flat_punch over an array library `xp`."""

from ...._programs.expressions._runtime.physics.adhesion import hess_retraction as retraction
from ...._programs.expressions._runtime.physics.adhesion import separation


def pull_off_force(xp, a, E_star, dgamma):
    return -2.0 * a * xp.sqrt(6.283185307179586 * E_star * dgamma * a)


def work_of_adhesion_from_pull_off(xp, F, a, E_star):
    v1 = pull_off_force(xp, a, E_star, 0.0)
    v2 = F <= v1
    v6 = xp.where(v2, 2.0 * v1, F)
    return xp.where(v2, separation(xp, v1 - xp.where(v2, F, 0.5 * v1), a, E_star), xp.nan)
