"""Formulas of axicontact.graded.normal.capped_paraboloid over an array library `xp`."""

from ....._programs.expressions._runtime.graded.breaks import rim_depth
from ....._programs.expressions._runtime.graded.breaks import rim_force
from ....._programs.expressions._runtime.graded.breaks import rim_rate
from ....._programs.expressions._runtime.graded.displacement import power_displacement
from ....._programs.expressions._runtime.graded.displacement import rim_displacement
from ....._programs.expressions._runtime.graded.growth import power_factor
from ....._programs.expressions._runtime.graded.growth import power_force
from ....._programs.expressions._runtime.graded.growth import power_rate
from ....._programs.expressions._runtime.graded.pressure import power_pressure
from ....._programs.expressions._runtime.graded.pressure import rim_pressure
from ....._programs.expressions._runtime.graded.punch import punch_depth
from ....._programs.expressions._runtime.graded.punch import punch_force
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions._runtime.integrals import difference_root
from ....._programs.expressions.normal.capped_paraboloid import profile
from ....._runtime.steps import newton


def depth_at(xp, a, root, R1, R2, b, k):
    v10 = rim_depth(xp, a, root, b, k) * (R1 - R2) / (R1 * R2)
    return power_factor(xp, 2.0, k) * a ** 2.0 / (2.0 * R1) + v10


def force_at(xp, a, root, R1, R2, b, H, k):
    v11 = rim_force(xp, a, root, b, k) * (R1 - R2) / (R1 * R2)
    return 2.0 * H / (1.0 + k) * (power_force(xp, a, 2.0, k) / (2.0 * R1) + v11)


def pressure(xp, r, a, R1, R2, b, H, k):
    v1 = r < a
    v4 = xp.minimum(xp.where(v1, r, 0.5 * a), a)
    v12 = rim_pressure(xp, v4, a, b, k) * (R1 - R2) / (R1 * R2)
    v15 = xp.where(v1, 2.0 * a, r)
    v14 = H / 3.141592653589793 * (power_pressure(xp, v4, a, 2.0, k) / (2.0 * R1) + v12)
    return xp.where(v1, v14, 0.0)


def displacement(xp, r, a, R1, R2, b, k):
    v8 = rim_displacement(xp, r, a, b, k) * (R1 - R2) / (R1 * R2)
    return power_displacement(xp, r, a, 2.0, k) / (2.0 * R1) + v8


def rate_at(xp, a, root, R1, R2, b, k):
    v8 = rim_rate(xp, a, root, b, k) * (R1 - R2) / (R1 * R2)
    return power_rate(xp, a, 2.0, k) / (2.0 * R1) + v8


def depth(xp, a, R1, R2, b, k):
    return depth_at(xp, a, difference_root(xp, a, b), R1, R2, b, k)


def force(xp, a, R1, R2, b, H, k):
    return force_at(xp, a, difference_root(xp, a, b), R1, R2, b, H, k)


def stiffness(xp, a, H, k):
    return punch_stiffness(xp, a, H, k)


def mean_pressure(xp, a, R1, R2, b, H, k):
    v1 = a > 0.0
    v2 = xp.where(v1, a, 1.0)
    v7 = force_at(xp, v2, difference_root(xp, v2, b), R1, R2, b, H, k) / (3.141592653589793 * v2 * v2)
    return xp.where(v1, v7, 0.0)


def radius_from_depth(xp, d, R1, R2, b, k):

    def f4(v5):
        v6 = v5 < 1.0
        v8 = xp.where(v6, 2.0 * 1.0, v5)
        v9 = v8 < 1.0
        v10 = xp.where(v9, v8, 0.5 * 1.0)
        v13 = xp.where(v9, 0.0, xp.where(v9, 2.0 * 1.0, v8) - 1.0)
        v18 = b * xp.where(v6, xp.where(v6, v5, 0.5 * 1.0), xp.sqrt(1.0 + v13 * v13))
        v19 = xp.where(v6, v5, 0.5 * 1.0)
        v23 = b * xp.where(v6, 0.0, xp.where(v6, 2.0 * 1.0, v5) - 1.0)
        v24 = depth_at(xp, v18, v23, R1, R2, b, k)
        v28 = xp.where(v6, v5, 0.5 * 1.0)
        v29 = xp.where(v6, 2.0 * 1.0, v5)
        v30 = v29 < 1.0
        v31 = xp.where(v30, v29, 0.5 * 1.0)
        v34 = xp.where(v30, 0.0, xp.where(v30, 2.0 * 1.0, v29) - 1.0)
        v39 = xp.where(v6, 1.0, v29 * v34 / (1.0 + v34 * v34))
        return (v24, v18 * rate_at(xp, v18, v23, R1, R2, b, k) / v24 * v39)
    v41 = newton(xp, f4, d, (d / depth_at(xp, b, b * 0.0, R1, R2, b, k)) ** 0.5, xp.inf, 1e-06, xp.inf)
    v42 = v41 < 1.0
    v44 = xp.where(v42, 2.0 * 1.0, v41)
    v45 = v44 < 1.0
    v46 = xp.where(v45, v44, 0.5 * 1.0)
    v49 = xp.where(v45, 0.0, xp.where(v45, 2.0 * 1.0, v44) - 1.0)
    return b * xp.where(v42, xp.where(v42, v41, 0.5 * 1.0), xp.sqrt(1.0 + v49 * v49))


def radius_from_force(xp, F, R1, R2, b, H, k):

    def f6(v7):
        v8 = v7 < 1.0
        v10 = xp.where(v8, 2.0 * 1.0, v7)
        v11 = v10 < 1.0
        v12 = xp.where(v11, v10, 0.5 * 1.0)
        v15 = xp.where(v11, 0.0, xp.where(v11, 2.0 * 1.0, v10) - 1.0)
        v20 = b * xp.where(v8, xp.where(v8, v7, 0.5 * 1.0), xp.sqrt(1.0 + v15 * v15))
        v21 = xp.where(v8, v7, 0.5 * 1.0)
        v25 = b * xp.where(v8, 0.0, xp.where(v8, 2.0 * 1.0, v7) - 1.0)
        v26 = force_at(xp, v20, v25, R1, R2, b, H, k)
        v32 = xp.where(v8, v7, 0.5 * 1.0)
        v33 = xp.where(v8, 2.0 * 1.0, v7)
        v34 = v33 < 1.0
        v35 = xp.where(v34, v33, 0.5 * 1.0)
        v38 = xp.where(v34, 0.0, xp.where(v34, 2.0 * 1.0, v33) - 1.0)
        v31 = v20 * (punch_stiffness(xp, v20, H, k) * rate_at(xp, v20, v25, R1, R2, b, k)) / v26
        return (v26, v31 * xp.where(v8, 1.0, v33 * v38 / (1.0 + v38 * v38)))
    v6 = (F / force_at(xp, b, b * 0.0, R1, R2, b, H, k)) ** (1.0 / (3.0 + k))
    v45 = newton(xp, f6, F, v6, xp.inf, 1e-06, xp.inf)
    v46 = v45 < 1.0
    v48 = xp.where(v46, 2.0 * 1.0, v45)
    v49 = v48 < 1.0
    v50 = xp.where(v49, v48, 0.5 * 1.0)
    v53 = xp.where(v49, 0.0, xp.where(v49, 2.0 * 1.0, v48) - 1.0)
    return b * xp.where(v46, xp.where(v46, v45, 0.5 * 1.0), xp.sqrt(1.0 + v53 * v53))


def force_from_depth(xp, d, R1, R2, b, H, k):
    v1 = radius_from_depth(xp, d, R1, R2, b, k)
    v2 = difference_root(xp, v1, b)
    v6 = punch_force(xp, d - depth_at(xp, v1, v2, R1, R2, b, k), v1, H, k)
    return force_at(xp, v1, v2, R1, R2, b, H, k) + v6


def depth_from_force(xp, F, R1, R2, b, H, k):
    v1 = radius_from_force(xp, F, R1, R2, b, H, k)
    v2 = difference_root(xp, v1, b)
    v6 = punch_depth(xp, F - force_at(xp, v1, v2, R1, R2, b, H, k), v1, H, k)
    return depth_at(xp, v1, v2, R1, R2, b, k) + v6
