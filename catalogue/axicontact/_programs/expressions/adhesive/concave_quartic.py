"""Formulas of axicontact.adhesive.concave_quartic over an array library `xp`."""


def pull_off_depth(xp, a, h, E_star, dgamma):
    v0 = (-8.0) * h
    v1 = v0 / 3.0
    v2 = xp.sqrt(a)
    v3 = 6.283185307179586 * dgamma
    v4 = v3 / E_star
    v5 = xp.sqrt(v4)
    v6 = v2 * v5
    v7 = v1 - v6
    return v7


def pull_off_force(xp, a, h, E_star, dgamma):
    v0 = (-2.0) * a
    v1 = 6.283185307179586 * E_star
    v2 = v1 * dgamma
    v3 = v2 * a
    v4 = xp.sqrt(v3)
    v5 = v0 * v4
    v6 = 64.0 * E_star
    v7 = v6 * h
    v8 = v7 / 15.0
    v9 = v8 * a
    v10 = v5 - v9
    return v10
