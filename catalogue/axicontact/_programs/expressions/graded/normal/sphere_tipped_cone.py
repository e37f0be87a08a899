"""Formulas of axicontact.graded.normal.sphere_tipped_cone over an array library `xp`."""

from ....._programs.expressions._runtime.functions import sine_root
from ....._programs.expressions._runtime.graded.breaks import tipped_depth
from ....._programs.expressions._runtime.graded.breaks import tipped_force
from ....._programs.expressions._runtime.graded.breaks import tipped_rate
from ....._programs.expressions._runtime.graded.displacement import tipped_displacement
from ....._programs.expressions._runtime.graded.pressure import tipped_pressure
from ....._programs.expressions._runtime.graded.punch import punch_depth
from ....._programs.expressions._runtime.graded.punch import punch_force
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions.normal.sphere_tipped_cone import profile
from ....._runtime.steps import newton


def depth_at(xp, a, root, R, theta, k):
    return tipped_depth(xp, a, root, R, R * xp.sin(theta), R * xp.cos(theta), k)


def force_at(xp, a, root, R, theta, H, k):
    v8 = tipped_force(xp, a, root, R, R * xp.sin(theta), R * xp.cos(theta), k)
    return 2.0 * H / (1.0 + k) * v8


def pressure(xp, r, a, R, theta, H, k):
    v1 = r < a
    v4 = xp.minimum(xp.where(v1, r, 0.5 * a), a)
    v9 = tipped_pressure(xp, v4, a, R, R * xp.sin(theta), R * xp.cos(theta), k)
    v11 = xp.where(v1, 2.0 * a, r)
    return xp.where(v1, H / 3.141592653589793 * v9, 0.0)


def displacement(xp, r, a, R, theta, k):
    return tipped_displacement(xp, r, a, R, R * xp.sin(theta), R * xp.cos(theta), k)


def rate_at(xp, a, root, R, theta, k):
    return tipped_rate(xp, a, root, R, R * xp.sin(theta), R * xp.cos(theta), k)


def depth(xp, a, R, theta, k):
    return depth_at(xp, a, sine_root(xp, a, R, theta), R, theta, k)


def force(xp, a, R, theta, H, k):
    return force_at(xp, a, sine_root(xp, a, R, theta), R, theta, H, k)


def stiffness(xp, a, H, k):
    return punch_stiffness(xp, a, H, k)


def mean_pressure(xp, a, R, theta, H, k):
    v1 = a > 0.0
    v2 = xp.where(v1, a, 1.0)
    v7 = force_at(xp, v2, sine_root(xp, v2, R, theta), R, theta, H, k) / (3.141592653589793 * v2 * v2)
    return xp.where(v1, v7, 0.0)


def radius_from_depth(xp, d, R, theta, k):
    v2 = R * xp.sin(theta)

    def f6(v7):
        v8 = v7 < 1.0
        v10 = xp.where(v8, 2.0 * 1.0, v7)
        v11 = v10 < 1.0
        v12 = xp.where(v11, v10, 0.5 * 1.0)
        v15 = xp.where(v11, 0.0, xp.where(v11, 2.0 * 1.0, v10) - 1.0)
        v20 = v2 * xp.where(v8, xp.where(v8, v7, 0.5 * 1.0), xp.sqrt(1.0 + v15 * v15))
        v21 = xp.where(v8, v7, 0.5 * 1.0)
        v25 = v2 * xp.where(v8, 0.0, xp.where(v8, 2.0 * 1.0, v7) - 1.0)
        v26 = depth_at(xp, v20, v25, R, theta, k)
        v30 = xp.where(v8, v7, 0.5 * 1.0)
        v31 = xp.where(v8, 2.0 * 1.0, v7)
        v32 = v31 < 1.0
        v33 = xp.where(v32, v31, 0.5 * 1.0)
        v36 = xp.where(v32, 0.0, xp.where(v32, 2.0 * 1.0, v31) - 1.0)
        v41 = xp.where(v8, 1.0, v31 * v36 / (1.0 + v36 * v36))
        return (v26, v20 * rate_at(xp, v20, v25, R, theta, k) / v26 * v41)
    v43 = newton(xp, f6, d, (d / depth_at(xp, v2, v2 * 0.0, R, theta, k)) ** 0.5, xp.inf, 1e-06, xp.inf)
    v44 = v43 < 1.0
    v46 = xp.where(v44, 2.0 * 1.0, v43)
    v47 = v46 < 1.0
    v48 = xp.where(v47, v46, 0.5 * 1.0)
    v51 = xp.where(v47, 0.0, xp.where(v47, 2.0 * 1.0, v46) - 1.0)
    return v2 * xp.where(v44, xp.where(v44, v43, 0.5 * 1.0), xp.sqrt(1.0 + v51 * v51))


def radius_from_force(xp, F, R, theta, H, k):
    v2 = R * xp.sin(theta)

    def f8(v9):
        v10 = v9 < 1.0
        v12 = xp.where(v10, 2.0 * 1.0, v9)
        v13 = v12 < 1.0
        v14 = xp.where(v13, v12, 0.5 * 1.0)
        v17 = xp.where(v13, 0.0, xp.where(v13, 2.0 * 1.0, v12) - 1.0)
        v22 = v2 * xp.where(v10, xp.where(v10, v9, 0.5 * 1.0), xp.sqrt(1.0 + v17 * v17))
        v23 = xp.where(v10, v9, 0.5 * 1.0)
        v27 = v2 * xp.where(v10, 0.0, xp.where(v10, 2.0 * 1.0, v9) - 1.0)
        v28 = force_at(xp, v22, v27, R, theta, H, k)
        v34 = xp.where(v10, v9, 0.5 * 1.0)
        v35 = xp.where(v10, 2.0 * 1.0, v9)
        v36 = v35 < 1.0
        v37 = xp.where(v36, v35, 0.5 * 1.0)
        v40 = xp.where(v36, 0.0, xp.where(v36, 2.0 * 1.0, v35) - 1.0)
        v33 = v22 * (punch_stiffness(xp, v22, H, k) * rate_at(xp, v22, v27, R, theta, k)) / v28
        return (v28, v33 * xp.where(v10, 1.0, v35 * v40 / (1.0 + v40 * v40)))
    v8 = (F / force_at(xp, v2, v2 * 0.0, R, theta, H, k)) ** (1.0 / (3.0 + k))
    v47 = newton(xp, f8, F, v8, xp.inf, 1e-06, xp.inf)
    v48 = v47 < 1.0
    v50 = xp.where(v48, 2.0 * 1.0, v47)
    v51 = v50 < 1.0
    v52 = xp.where(v51, v50, 0.5 * 1.0)
    v55 = xp.where(v51, 0.0, xp.where(v51, 2.0 * 1.0, v50) - 1.0)
    return v2 * xp.where(v48, xp.where(v48, v47, 0.5 * 1.0), xp.sqrt(1.0 + v55 * v55))


def force_from_depth(xp, d, R, theta, H, k):
    v1 = radius_from_depth(xp, d, R, theta, k)
    v2 = sine_root(xp, v1, R, theta)
    v6 = punch_force(xp, d - depth_at(xp, v1, v2, R, theta, k), v1, H, k)
    return force_at(xp, v1, v2, R, theta, H, k) + v6


def depth_from_force(xp, F, R, theta, H, k):
    v1 = radius_from_force(xp, F, R, theta, H, k)
    v2 = sine_root(xp, v1, R, theta)
    v6 = punch_depth(xp, F - force_at(xp, v1, v2, R, theta, H, k), v1, H, k)
    return depth_at(xp, v1, v2, R, theta, k) + v6
