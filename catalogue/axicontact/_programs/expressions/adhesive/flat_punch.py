"""Formulas of axicontact.adhesive.flat_punch over an array library `xp`."""


def pull_off_depth(xp, a, E_star, dgamma):
    v0 = xp.sqrt(a)
    v1 = 6.283185307179586 * dgamma
    v2 = v1 / E_star
    v3 = xp.sqrt(v2)
    v4 = v0 * v3
    v5 = -v4
    return v5


def pull_off_force(xp, a, E_star, dgamma):
    v0 = (-2.0) * a
    v1 = 6.283185307179586 * E_star
    v2 = v1 * dgamma
    v3 = v2 * a
    v4 = xp.sqrt(v3)
    v5 = v0 * v4
    return v5
