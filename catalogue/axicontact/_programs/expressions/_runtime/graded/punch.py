"""Formulas of axicontact._runtime.graded.punch over an array library `xp`."""

from ....._programs.expressions._runtime.graded.rules import raised
from ....._programs.expressions._runtime.integrals import difference_root


def graded_retraction(xp, a, H, k, dgamma):
    v1 = a > 0.0
    v2 = xp.where(v1, a, 1.0)
    v11 = xp.sqrt(6.283185307179586 * dgamma / H) * xp.sqrt(v2) * xp.sqrt(v2 ** (-k))
    return xp.where(v1, v11, 0.0)


def punch_stiffness(xp, a, H, k):
    return 2.0 * H / (1.0 + k) * raised(xp, a, k)


def punch_pressure(xp, r, a, H, k):
    v1 = r < a
    v4 = difference_root(xp, a, xp.where(v1, r, 0.5 * a))
    v8 = xp.where(v1, 2.0 * a, r)
    v9 = v8 > a
    v10 = xp.where(v9, v8, 2.0 * a)
    v11 = xp.where(v9, 0.5 * a, v8)
    return xp.where(v1, H / 3.141592653589793 * v4 ** k / v4, xp.where(v9, 0.0, xp.inf))


def tension(xp, r, a, H, k, dgamma):
    v1 = graded_retraction(xp, a, H, k, dgamma)
    v2 = v1 > 0.0
    return xp.where(v2, xp.where(v2, v1, 1.0) * punch_pressure(xp, r, a, H, k), 0.0)


def separation(xp, load, a, H, k):
    v8 = (1.0 + k) / 12.566370614359172 * (load / punch_stiffness(xp, a, H, k)) * (load / a / a)
    return v8


def punch_force(xp, d, a, H, k):
    v1 = punch_stiffness(xp, a, H, k)
    return xp.where((v1 > 0.0) & (v1 < xp.inf), v1 * d, 0.0)


def punch_depth(xp, F, a, H, k):
    v1 = punch_stiffness(xp, a, H, k)
    return xp.where((v1 > 0.0) & (v1 < xp.inf), F / v1, 0.0)
