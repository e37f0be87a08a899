"""Formulas of axicontact.graded.adhesive.sextic over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import power_displacement
from ....._programs.expressions._runtime.graded.displacement import punch_share
from ....._programs.expressions._runtime.graded.growth import power_rate
from ....._programs.expressions._runtime.graded.punch import graded_retraction as retraction
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions._runtime.graded.punch import separation
from ....._programs.expressions._runtime.graded.punch import tension
from ....._programs.expressions._runtime.physics.adhesion import growth
from ....._programs.expressions.graded.normal.sextic import depth as graded_normal_depth
from ....._programs.expressions.graded.normal.sextic import force as graded_normal_force
from ....._programs.expressions.graded.normal.sextic import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.sextic import radius_from_force as graded_normal_radius_from_force


def depth(xp, a, A, H, k, dgamma):
    return graded_normal_depth(xp, a, A, k) - retraction(xp, a, H, k, dgamma)


def force(xp, a, A, H, k, dgamma):
    v4 = punch_stiffness(xp, a, H, k) * retraction(xp, a, H, k, dgamma)
    return graded_normal_force(xp, a, A, H, k) - v4


def pressure(xp, r, a, A, H, k, dgamma):
    return graded_normal_pressure(xp, r, a, A, H, k) - tension(xp, r, a, H, k, dgamma)


def displacement(xp, r, a, A, H, k, dgamma):
    v4 = r > a
    v7 = xp.where(v4, 0.5 * a, r)
    v8 = xp.where(v4, punch_share(xp, xp.where(v4, r, 2.0 * a), a, k), 1.0)
    return A * power_displacement(xp, r, a, 6.0, k) - retraction(xp, a, H, k, dgamma) * v8


def radius_from_depth(xp, d, A, H, k, dgamma):
    v1 = dgamma > 0.0
    v9 = (1.0 + -1.0 * k) * xp.sqrt(3.141592653589793 * xp.where(v1, dgamma, 1.0) / (2.0 * H))
    v17 = (v9 / (A * power_rate(xp, 1.0, 6.0, k))) ** (1.0 / (6.0 - (1.0 - k) / 2.0))
    v18 = xp.where(v1, v17, 0.0)
    v24 = graded_normal_depth(xp, v18, A, k) * (1.0 - 12.0 / (1.0 + -1.0 * k))
    v25 = v24 < 0.0
    v26 = xp.where(v25, 1.0, v24)
    v30 = xp.where(v25, 1.0, v24)
    v31 = xp.where(v25, 1.0 - d / xp.where(v25, v24, -1.0), xp.inf)
    v32 = xp.absolute(v31)
    v33 = v32 < 1e-15
    v34 = xp.where(v33, v32, 0.5 * 1e-15)
    v35 = xp.where(v33, 2.0 * 1e-15, v32)
    v36 = xp.where(v33, 0.0, v31)
    v37 = v36 < 0.0
    v38 = xp.where(v37, 1.0, v36)
    v41 = v38 > 0.0
    v45 = (1.0 - k) / 2.0
    v48 = growth(xp, xp.where(v41, xp.where(v41, v38, 1.0), 1.0), 6.0 / v45 + 0.0)
    v54 = d >= 0.0
    v58 = xp.maximum(xp.where(v54, d, 1.0), 0.0) / graded_normal_depth(xp, 1.0, A, k)
    v53 = v18 * (1.0 + xp.where(v38 == 0.0, 0.0, v48)) ** (1.0 / v45)
    v61 = xp.where(xp.isfinite(v38), v53, xp.where(v54, v58 ** 0.16666666666666666, xp.nan))
    return xp.where(v37, xp.nan, v61)


def radius_from_force(xp, F, A, H, k, dgamma):
    v1 = dgamma > 0.0
    v8 = (3.0 + k) * xp.sqrt(3.141592653589793 * xp.where(v1, dgamma, 1.0) / (2.0 * H))
    v16 = (v8 / (A * power_rate(xp, 1.0, 6.0, k))) ** (1.0 / (6.0 - (1.0 - k) / 2.0))
    v17 = xp.where(v1, v16, 0.0)
    v19 = 7.0 + k
    v21 = 3.0 + k
    v24 = graded_normal_force(xp, v17, A, H, k) * (1.0 - 2.0 * v19 / v21)
    v25 = v24 < 0.0
    v26 = xp.where(v25, 1.0, v24)
    v30 = xp.where(v25, 1.0, v24)
    v31 = xp.where(v25, 1.0 - F / xp.where(v25, v24, -1.0), xp.inf)
    v32 = xp.absolute(v31)
    v33 = v32 < 1e-15
    v34 = xp.where(v33, v32, 0.5 * 1e-15)
    v35 = xp.where(v33, 2.0 * 1e-15, v32)
    v36 = xp.where(v33, 0.0, v31)
    v37 = v36 < 0.0
    v38 = xp.where(v37, 1.0, v36)
    v41 = v38 > 0.0
    v44 = v21 / 2.0
    v47 = growth(xp, xp.where(v41, xp.where(v41, v38, 1.0), 1.0), v19 / v44 + 0.0)
    v53 = F >= 0.0
    v56 = graded_normal_radius_from_force(xp, xp.maximum(xp.where(v53, F, 1.0), 0.0), A, H, k)
    v52 = v17 * (1.0 + xp.where(v38 == 0.0, 0.0, v47)) ** (1.0 / v44)
    return xp.where(v37, xp.nan, xp.where(xp.isfinite(v38), v52, xp.where(v53, v56, xp.nan)))


def work_of_adhesion_from_pull_off(xp, F, A, H, k):
    v2 = F < 0.0
    v4 = xp.where(v2, 1.0, F)
    v5 = xp.where(v2, -F, xp.nan)
    v9 = v5 * (k + 3.0) / (k + 11.0)
    v12 = separation(xp, v5 + v9, graded_normal_radius_from_force(xp, v9, A, H, k), H, k)
    return xp.where(F == 0.0, 0.0, v12)
