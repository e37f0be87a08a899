"""Formulas of axicontact.graded.normal.truncated_cone over an array library `xp`."""

from ....._programs.expressions._runtime.graded.breaks import flank_depth
from ....._programs.expressions._runtime.graded.breaks import flank_force
from ....._programs.expressions._runtime.graded.breaks import flank_rate
from ....._programs.expressions._runtime.graded.displacement import flank_displacement
from ....._programs.expressions._runtime.graded.pressure import flank_pressure
from ....._programs.expressions._runtime.graded.punch import punch_depth
from ....._programs.expressions._runtime.graded.punch import punch_force
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions._runtime.integrals import difference_root
from ....._programs.expressions.normal.truncated_cone import profile
from ....._runtime.steps import newton


def depth(xp, a, theta, b, k):
    v1 = a >= b
    v2 = xp.where(v1, a, 2.0 * b)
    v7 = xp.where(v1, 0.5 * b, a)
    v8 = xp.where(v1, flank_depth(xp, v2, difference_root(xp, v2, b), b, k) * xp.tan(theta), xp.nan)
    return v8


def force_at(xp, a, root, theta, b, H, k):
    return 2.0 * H / (1.0 + k) * (flank_force(xp, a, root, b, k) * xp.tan(theta))


def force(xp, a, theta, b, H, k):
    v1 = a >= b
    v2 = xp.where(v1, a, 2.0 * b)
    v5 = xp.where(v1, 0.5 * b, a)
    return xp.where(v1, force_at(xp, v2, difference_root(xp, v2, b), theta, b, H, k), xp.nan)


def pressure(xp, r, a, theta, b, H, k):
    v1 = a >= b
    v2 = xp.where(v1, a, 2.0 * b)
    v3 = r < v2
    v9 = flank_pressure(xp, xp.minimum(xp.where(v3, r, 0.5 * v2), v2), v2, b, k) * xp.tan(theta)
    v11 = xp.where(v3, 2.0 * v2, r)
    v13 = xp.where(v1, 0.5 * b, a)
    return xp.where(v1, xp.where(v3, H / 3.141592653589793 * v9, 0.0), xp.nan)


def rate(xp, a, theta, b, k):
    v1 = a >= b
    v2 = xp.where(v1, a, 2.0 * b)
    v7 = xp.where(v1, 0.5 * b, a)
    v8 = xp.where(v1, flank_rate(xp, v2, difference_root(xp, v2, b), b, k) * xp.tan(theta), xp.nan)
    return v8


def displacement(xp, r, a, theta, b, k):
    return flank_displacement(xp, r, a, b, k) * xp.tan(theta)


def stiffness(xp, a, H, k):
    return punch_stiffness(xp, a, H, k)


def mean_pressure(xp, a, theta, b, H, k):
    return force(xp, a, theta, b, H, k) / (3.141592653589793 * a * a)


def radius_from_depth(xp, d, theta, b, k):
    v1 = d + 0.0
    v4 = difference_root(xp, b * 1.4142135623730951, b) / b
    v5 = b * v4
    v8 = xp.tan(theta)

    def f11(v12):
        v13 = b * v12
        v14 = xp.hypot(b, v13)
        v16 = flank_depth(xp, v14, v13, b, k) * v8
        return (v16, v13 * (v13 / v14) * (flank_rate(xp, v14, v13, b, k) * v8) / v16)
    v11 = v4 * (v1 / (flank_depth(xp, xp.hypot(b, v5), v5, b, k) * v8))
    return b * xp.hypot(1.0, newton(xp, f11, v1, v11, xp.inf, 1e-06, xp.inf))


def force_rate_at(xp, a, root, theta, b, H, k):
    return punch_stiffness(xp, a, H, k) * (flank_rate(xp, a, root, b, k) * xp.tan(theta))


def radius_from_force(xp, F, theta, b, H, k):
    v1 = F + 0.0
    v4 = difference_root(xp, b * 1.4142135623730951, b) / b
    v5 = b * v4

    def f9(v10):
        v11 = b * v10
        v12 = xp.hypot(b, v11)
        v13 = force_at(xp, v12, v11, theta, b, H, k)
        return (v13, v11 * (v11 / v12) * force_rate_at(xp, v12, v11, theta, b, H, k) / v13)
    v9 = v4 * (v1 / force_at(xp, xp.hypot(b, v5), v5, theta, b, H, k))
    return b * xp.hypot(1.0, newton(xp, f9, v1, v9, xp.inf, 1e-06, xp.inf))


def force_from_depth(xp, d, theta, b, H, k):
    v1 = d + 0.0
    v4 = difference_root(xp, b * 1.4142135623730951, b) / b
    v5 = b * v4
    v8 = xp.tan(theta)

    def f11(v12):
        v13 = b * v12
        v14 = xp.hypot(b, v13)
        v16 = flank_depth(xp, v14, v13, b, k) * v8
        return (v16, v13 * (v13 / v14) * (flank_rate(xp, v14, v13, b, k) * v8) / v16)
    v11 = v4 * (v1 / (flank_depth(xp, xp.hypot(b, v5), v5, b, k) * v8))
    v23 = newton(xp, f11, v1, v11, xp.inf, 1e-06, xp.inf)
    v25 = b * xp.hypot(1.0, v23)
    v26 = b * v23
    v31 = punch_force(xp, d - flank_depth(xp, v25, v26, b, k) * v8, v25, H, k)
    return force_at(xp, v25, v26, theta, b, H, k) + v31


def depth_from_force(xp, F, theta, b, H, k):
    v1 = F + 0.0
    v4 = difference_root(xp, b * 1.4142135623730951, b) / b
    v5 = b * v4

    def f9(v10):
        v11 = b * v10
        v12 = xp.hypot(b, v11)
        v13 = force_at(xp, v12, v11, theta, b, H, k)
        return (v13, v11 * (v11 / v12) * force_rate_at(xp, v12, v11, theta, b, H, k) / v13)
    v9 = v4 * (v1 / force_at(xp, xp.hypot(b, v5), v5, theta, b, H, k))
    v19 = newton(xp, f9, v1, v9, xp.inf, 1e-06, xp.inf)
    v21 = b * xp.hypot(1.0, v19)
    v22 = b * v19
    v28 = punch_depth(xp, F - force_at(xp, v21, v22, theta, b, H, k), v21, H, k)
    return flank_depth(xp, v21, v22, b, k) * xp.tan(theta) + v28
