"""Formulas of axicontact.graded.normal.truncated_paraboloid over an array library `xp`."""

from ....._programs.expressions._runtime.graded.breaks import rim_depth
from ....._programs.expressions._runtime.graded.breaks import rim_force
from ....._programs.expressions._runtime.graded.breaks import rim_rate
from ....._programs.expressions._runtime.graded.displacement import rim_displacement
from ....._programs.expressions._runtime.graded.pressure import rim_pressure
from ....._programs.expressions._runtime.graded.punch import punch_depth
from ....._programs.expressions._runtime.graded.punch import punch_force
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions._runtime.integrals import difference_root
from ....._programs.expressions.normal.truncated_paraboloid import profile
from ....._runtime.steps import newton


def depth(xp, a, R, b, k):
    v1 = a >= b
    v2 = xp.where(v1, a, 2.0 * b)
    v6 = xp.where(v1, 0.5 * b, a)
    return xp.where(v1, rim_depth(xp, v2, difference_root(xp, v2, b), b, k) / R, xp.nan)


def force_at(xp, a, root, R, b, H, k):
    return 2.0 * H / (1.0 + k) * (rim_force(xp, a, root, b, k) / R)


def force(xp, a, R, b, H, k):
    v1 = a >= b
    v2 = xp.where(v1, a, 2.0 * b)
    v5 = xp.where(v1, 0.5 * b, a)
    return xp.where(v1, force_at(xp, v2, difference_root(xp, v2, b), R, b, H, k), xp.nan)


def pressure(xp, r, a, R, b, H, k):
    v1 = a >= b
    v2 = xp.where(v1, a, 2.0 * b)
    v3 = r < v2
    v8 = rim_pressure(xp, xp.minimum(xp.where(v3, r, 0.5 * v2), v2), v2, b, k) / R
    v10 = xp.where(v3, 2.0 * v2, r)
    v12 = xp.where(v1, 0.5 * b, a)
    return xp.where(v1, xp.where(v3, H / 3.141592653589793 * v8, 0.0), xp.nan)


def rate(xp, a, R, b, k):
    v1 = a >= b
    v2 = xp.where(v1, a, 2.0 * b)
    v6 = xp.where(v1, 0.5 * b, a)
    return xp.where(v1, rim_rate(xp, v2, difference_root(xp, v2, b), b, k) / R, xp.nan)


def displacement(xp, r, a, R, b, k):
    return rim_displacement(xp, r, a, b, k) / R


def stiffness(xp, a, H, k):
    return punch_stiffness(xp, a, H, k)


def mean_pressure(xp, a, R, b, H, k):
    return force(xp, a, R, b, H, k) / (3.141592653589793 * a * a)


def radius_from_depth(xp, d, R, b, k):
    v1 = d + 0.0
    v4 = difference_root(xp, b * 1.4142135623730951, b) / b
    v5 = b * v4

    def f10(v11):
        v12 = b * v11
        v13 = xp.hypot(b, v12)
        v15 = rim_depth(xp, v13, v12, b, k) / R
        return (v15, v12 * (v12 / v13) * (rim_rate(xp, v13, v12, b, k) / R) / v15)
    v10 = v4 * (v1 / (rim_depth(xp, xp.hypot(b, v5), v5, b, k) / R))
    return b * xp.hypot(1.0, newton(xp, f10, v1, v10, xp.inf, 1e-06, xp.inf))


def force_rate_at(xp, a, root, R, b, H, k):
    return punch_stiffness(xp, a, H, k) * (rim_rate(xp, a, root, b, k) / R)


def radius_from_force(xp, F, R, b, H, k):
    v1 = F + 0.0
    v4 = difference_root(xp, b * 1.4142135623730951, b) / b
    v5 = b * v4

    def f9(v10):
        v11 = b * v10
        v12 = xp.hypot(b, v11)
        v13 = force_at(xp, v12, v11, R, b, H, k)
        return (v13, v11 * (v11 / v12) * force_rate_at(xp, v12, v11, R, b, H, k) / v13)
    v9 = v4 * (v1 / force_at(xp, xp.hypot(b, v5), v5, R, b, H, k))
    return b * xp.hypot(1.0, newton(xp, f9, v1, v9, xp.inf, 1e-06, xp.inf))


def force_from_depth(xp, d, R, b, H, k):
    v1 = d + 0.0
    v4 = difference_root(xp, b * 1.4142135623730951, b) / b
    v5 = b * v4

    def f10(v11):
        v12 = b * v11
        v13 = xp.hypot(b, v12)
        v15 = rim_depth(xp, v13, v12, b, k) / R
        return (v15, v12 * (v12 / v13) * (rim_rate(xp, v13, v12, b, k) / R) / v15)
    v10 = v4 * (v1 / (rim_depth(xp, xp.hypot(b, v5), v5, b, k) / R))
    v22 = newton(xp, f10, v1, v10, xp.inf, 1e-06, xp.inf)
    v24 = b * xp.hypot(1.0, v22)
    v25 = b * v22
    v30 = punch_force(xp, d - rim_depth(xp, v24, v25, b, k) / R, v24, H, k)
    return force_at(xp, v24, v25, R, b, H, k) + v30


def depth_from_force(xp, F, R, b, H, k):
    v1 = F + 0.0
    v4 = difference_root(xp, b * 1.4142135623730951, b) / b
    v5 = b * v4

    def f9(v10):
        v11 = b * v10
        v12 = xp.hypot(b, v11)
        v13 = force_at(xp, v12, v11, R, b, H, k)
        return (v13, v11 * (v11 / v12) * force_rate_at(xp, v12, v11, R, b, H, k) / v13)
    v9 = v4 * (v1 / force_at(xp, xp.hypot(b, v5), v5, R, b, H, k))
    v19 = newton(xp, f9, v1, v9, xp.inf, 1e-06, xp.inf)
    v21 = b * xp.hypot(1.0, v19)
    v22 = b * v19
    v27 = punch_depth(xp, F - force_at(xp, v21, v22, R, b, H, k), v21, H, k)
    return rim_depth(xp, v21, v22, b, k) / R + v27
