"""Formulas of axicontact._runtime.integrals over an array library `xp`."""


def difference_root(xp, x, y):
    v4 = xp.maximum(x - y, 0.0) * (x + y)
    v5 = v4 > 0.0
    return xp.where(v5, xp.sqrt(xp.where(v5, v4, 1.0)), 0.0)
