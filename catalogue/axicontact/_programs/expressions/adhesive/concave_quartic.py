"""Formulas of axicontact.adhesive.concave_quartic over an array library `xp`."""

from ...._programs.expressions._runtime.physics.adhesion import hess_retraction as retraction
from ...._programs.expressions._runtime.physics.adhesion import separation


def pull_off_force(xp, a, h, E_star, dgamma):
    v6 = -2.0 * a * xp.sqrt(6.283185307179586 * E_star * dgamma * a)
    return v6 - 64.0 * E_star * h / 15.0 * a


def work_of_adhesion_from_pull_off(xp, F, a, h, E_star):
    v1 = pull_off_force(xp, a, h, E_star, 0.0)
    v2 = v1 >= F
    v6 = xp.where(v2, 0.5 * F, v1)
    return xp.where(v2, separation(xp, xp.where(v2, v1, 2.0 * F) - F, a, E_star), xp.nan)
