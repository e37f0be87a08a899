"""Formulas of axicontact.normal.polynomial over an array library `xp`."""


def stiffness(xp, a, E_star):
    v0 = 2.0 * E_star
    v1 = v0 * a
    return v1
