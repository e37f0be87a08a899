"""Formulas of axicontact.adhesive.concave_paraboloid over an array library `xp`."""


def pull_off_depth(xp, a, h, E_star, dgamma):
    v0 = (-2.0) * h
    v1 = xp.sqrt(a)
    v2 = 6.283185307179586 * dgamma
    v3 = v2 / E_star
    v4 = xp.sqrt(v3)
    v5 = v1 * v4
    v6 = v0 - v5
    return v6


def pull_off_force(xp, a, h, E_star, dgamma):
    v0 = (-2.0) * a
    v1 = 6.283185307179586 * E_star
    v2 = v1 * dgamma
    v3 = v2 * a
    v4 = xp.sqrt(v3)
    v5 = v0 * v4
    v6 = 8.0 * E_star
    v7 = v6 * h
    v8 = v7 / 3.0
    v9 = v8 * a
    v10 = v5 - v9
    return v10
