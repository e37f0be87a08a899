"""Formulas of axicontact.graded.normal.rounded_cone over an array library `xp`."""

from ....._programs.expressions._runtime.graded.breaks import rounded_depth
from ....._programs.expressions._runtime.graded.breaks import rounded_force
from ....._programs.expressions._runtime.graded.breaks import rounded_rate
from ....._programs.expressions._runtime.graded.displacement import rounded_displacement
from ....._programs.expressions._runtime.graded.pressure import rounded_pressure
from ....._programs.expressions._runtime.graded.punch import punch_depth
from ....._programs.expressions._runtime.graded.punch import punch_force
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions._runtime.integrals import difference_root
from ....._programs.expressions.normal.rounded_cone import profile
from ....._runtime.steps import newton


def depth(xp, a, theta, b, k):
    return rounded_depth(xp, a, difference_root(xp, a, b), b, k) * xp.tan(theta)


def force_at(xp, a, root, theta, b, H, k):
    return 2.0 * H / (1.0 + k) * (rounded_force(xp, a, root, b, k) * xp.tan(theta))


def pressure(xp, r, a, theta, b, H, k):
    v1 = r < a
    v7 = rounded_pressure(xp, xp.minimum(xp.where(v1, r, 0.5 * a), a), a, b, k) * xp.tan(theta)
    v9 = xp.where(v1, 2.0 * a, r)
    return xp.where(v1, H / 3.141592653589793 * v7, 0.0)


def rate(xp, a, theta, b, k):
    return rounded_rate(xp, a, difference_root(xp, a, b), b, k) * xp.tan(theta)


def force(xp, a, theta, b, H, k):
    return force_at(xp, a, difference_root(xp, a, b), theta, b, H, k)


def displacement(xp, r, a, theta, b, k):
    return rounded_displacement(xp, r, a, b, k) * xp.tan(theta)


def stiffness(xp, a, H, k):
    return punch_stiffness(xp, a, H, k)


def mean_pressure(xp, a, theta, b, H, k):
    v1 = a > 0.0
    v2 = xp.where(v1, a, 1.0)
    v7 = force_at(xp, v2, difference_root(xp, v2, b), theta, b, H, k) / (3.141592653589793 * v2 * v2)
    return xp.where(v1, v7, 0.0)


def radius_from_depth(xp, d, theta, b, k):
    v3 = xp.tan(theta)

    def f6(v7):
        v8 = v7 < 1.0
        v10 = xp.where(v8, 2.0 * 1.0, v7)
        v11 = v10 < 1.0
        v12 = xp.where(v11, v10, 0.5 * 1.0)
        v15 = xp.where(v11, 0.0, xp.where(v11, 2.0 * 1.0, v10) - 1.0)
        v20 = b * xp.where(v8, xp.where(v8, v7, 0.5 * 1.0), xp.sqrt(1.0 + v15 * v15))
        v21 = xp.where(v8, v7, 0.5 * 1.0)
        v25 = b * xp.where(v8, 0.0, xp.where(v8, 2.0 * 1.0, v7) - 1.0)
        v27 = rounded_depth(xp, v20, v25, b, k) * v3
        v32 = xp.where(v8, v7, 0.5 * 1.0)
        v33 = xp.where(v8, 2.0 * 1.0, v7)
        v34 = v33 < 1.0
        v35 = xp.where(v34, v33, 0.5 * 1.0)
        v38 = xp.where(v34, 0.0, xp.where(v34, 2.0 * 1.0, v33) - 1.0)
        v31 = v20 * (rounded_rate(xp, v20, v25, b, k) * v3) / v27
        return (v27, v31 * xp.where(v8, 1.0, v33 * v38 / (1.0 + v38 * v38)))
    v6 = (d / (rounded_depth(xp, b, b * 0.0, b, k) * v3)) ** 0.5
    v45 = newton(xp, f6, d, v6, xp.inf, 1e-06, xp.inf)
    v46 = v45 < 1.0
    v48 = xp.where(v46, 2.0 * 1.0, v45)
    v49 = v48 < 1.0
    v50 = xp.where(v49, v48, 0.5 * 1.0)
    v53 = xp.where(v49, 0.0, xp.where(v49, 2.0 * 1.0, v48) - 1.0)
    return b * xp.where(v46, xp.where(v46, v45, 0.5 * 1.0), xp.sqrt(1.0 + v53 * v53))


def force_rate_at(xp, a, root, theta, b, H, k):
    return punch_stiffness(xp, a, H, k) * (rounded_rate(xp, a, root, b, k) * xp.tan(theta))


def radius_from_force(xp, F, theta, b, H, k):

    def f6(v7):
        v8 = v7 < 1.0
        v10 = xp.where(v8, 2.0 * 1.0, v7)
        v11 = v10 < 1.0
        v12 = xp.where(v11, v10, 0.5 * 1.0)
        v15 = xp.where(v11, 0.0, xp.where(v11, 2.0 * 1.0, v10) - 1.0)
        v20 = b * xp.where(v8, xp.where(v8, v7, 0.5 * 1.0), xp.sqrt(1.0 + v15 * v15))
        v21 = xp.where(v8, v7, 0.5 * 1.0)
        v25 = b * xp.where(v8, 0.0, xp.where(v8, 2.0 * 1.0, v7) - 1.0)
        v26 = force_at(xp, v20, v25, theta, b, H, k)
        v30 = xp.where(v8, v7, 0.5 * 1.0)
        v31 = xp.where(v8, 2.0 * 1.0, v7)
        v32 = v31 < 1.0
        v33 = xp.where(v32, v31, 0.5 * 1.0)
        v36 = xp.where(v32, 0.0, xp.where(v32, 2.0 * 1.0, v31) - 1.0)
        v29 = v20 * force_rate_at(xp, v20, v25, theta, b, H, k) / v26
        return (v26, v29 * xp.where(v8, 1.0, v31 * v36 / (1.0 + v36 * v36)))
    v6 = (F / force_at(xp, b, b * 0.0, theta, b, H, k)) ** (1.0 / (3.0 + k))
    v43 = newton(xp, f6, F, v6, xp.inf, 1e-06, xp.inf)
    v44 = v43 < 1.0
    v46 = xp.where(v44, 2.0 * 1.0, v43)
    v47 = v46 < 1.0
    v48 = xp.where(v47, v46, 0.5 * 1.0)
    v51 = xp.where(v47, 0.0, xp.where(v47, 2.0 * 1.0, v46) - 1.0)
    return b * xp.where(v44, xp.where(v44, v43, 0.5 * 1.0), xp.sqrt(1.0 + v51 * v51))


def force_from_depth(xp, d, theta, b, H, k):
    v1 = radius_from_depth(xp, d, theta, b, k)
    v3 = force_at(xp, v1, difference_root(xp, v1, b), theta, b, H, k)
    return v3 + punch_force(xp, d - depth(xp, v1, theta, b, k), v1, H, k)


def depth_from_force(xp, F, theta, b, H, k):
    v1 = radius_from_force(xp, F, theta, b, H, k)
    v6 = punch_depth(xp, F - force_at(xp, v1, difference_root(xp, v1, b), theta, b, H, k), v1, H, k)
    return depth(xp, v1, theta, b, k) + v6
