"""Formulas of axicontact._runtime.graded.rules over an array library `xp`."""

from ....._runtime.steps import weighted_along


def raised(xp, x, k):
    v1 = x > 0.0
    v2 = xp.where(v1, x, 1.0)
    return xp.where(v1, v2 * v2 ** k, 0.0)


def sinh_over(xp, v):
    v1 = v > 0.0
    v2 = xp.where(v1, v, 1.0)
    v4 = v2 > 0.0
    return xp.where(v1, xp.sinh(v2) / xp.where(v4, xp.where(v4, v2, 1.0), 1.0), 1.0)


def sine_over(xp, y):
    v1 = y > 0.0
    v2 = xp.where(v1, y, 1.0)
    v4 = v2 > 0.0
    return xp.where(v1, xp.sin(v2) / xp.where(v4, xp.where(v4, v2, 1.0), 1.0), 1.0)


def sine_mean(xp, angle, k):
    v2, v3 = weighted_along(xp, 1.0 + k, angle, k)
    return xp.sum(v3 * sine_over(xp, v2 * angle) ** k, axis=0)
