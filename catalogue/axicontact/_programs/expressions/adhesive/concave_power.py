"""Formulas of axicontact.adhesive.concave_power over an array library `xp`."""

from ...._programs.expressions._runtime.physics.adhesion import hess_retraction as retraction
from ...._programs.expressions._runtime.physics.adhesion import separation
from ...._programs.expressions._runtime.special import gamma_ratio


def pull_off_force(xp, a, h, n, E_star, dgamma):
    v12 = 3.5449077018110318 * E_star * n * h / (n + 1.0) * a
    v6 = -2.0 * a * xp.sqrt(6.283185307179586 * E_star * dgamma * a)
    return v6 - v12 * gamma_ratio(xp, n / 2.0 + 0.5)


def work_of_adhesion_from_pull_off(xp, F, a, h, n, E_star):
    v1 = pull_off_force(xp, a, h, n, E_star, 0.0)
    v2 = v1 >= F
    v6 = xp.where(v2, 0.5 * F, v1)
    return xp.where(v2, separation(xp, xp.where(v2, v1, 2.0 * F) - F, a, E_star), xp.nan)
