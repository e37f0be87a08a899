"""Formulas of axicontact.graded.adhesive.power_law over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import power_displacement
from ....._programs.expressions._runtime.graded.displacement import punch_share
from ....._programs.expressions._runtime.graded.growth import power_rate
from ....._programs.expressions._runtime.graded.punch import graded_retraction as retraction
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions._runtime.graded.punch import separation
from ....._programs.expressions._runtime.graded.punch import tension
from ....._programs.expressions._runtime.physics.adhesion import growth
from ....._programs.expressions.graded.normal.power_law import depth as graded_normal_depth
from ....._programs.expressions.graded.normal.power_law import force as graded_normal_force
from ....._programs.expressions.graded.normal.power_law import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.power_law import radius_from_depth as graded_normal_radius_from_depth
from ....._programs.expressions.graded.normal.power_law import radius_from_force as graded_normal_radius_from_force


def depth(xp, a, A, n, H, k, dgamma):
    return graded_normal_depth(xp, a, A, n, k) - retraction(xp, a, H, k, dgamma)


def force(xp, a, A, n, H, k, dgamma):
    v4 = punch_stiffness(xp, a, H, k) * retraction(xp, a, H, k, dgamma)
    return graded_normal_force(xp, a, A, n, H, k) - v4


def pressure(xp, r, a, A, n, H, k, dgamma):
    return graded_normal_pressure(xp, r, a, A, n, H, k) - tension(xp, r, a, H, k, dgamma)


def displacement(xp, r, a, A, n, H, k, dgamma):
    v4 = r > a
    v7 = xp.where(v4, 0.5 * a, r)
    v8 = xp.where(v4, punch_share(xp, xp.where(v4, r, 2.0 * a), a, k), 1.0)
    return A * power_displacement(xp, r, a, n, k) - retraction(xp, a, H, k, dgamma) * v8


def radius_from_depth(xp, d, A, n, H, k, dgamma):
    v1 = dgamma > 0.0
    v9 = (1.0 + -1.0 * k) * xp.sqrt(3.141592653589793 * xp.where(v1, dgamma, 1.0) / (2.0 * H))
    v18 = xp.where(v1, (v9 / (A * power_rate(xp, 1.0, n, k))) ** (1.0 / (n - (1.0 - k) / 2.0)), 0.0)
    v25 = graded_normal_depth(xp, v18, A, n, k) * (1.0 - 2.0 * n / (1.0 + -1.0 * k))
    v26 = v25 < 0.0
    v27 = xp.where(v26, 1.0, v25)
    v31 = xp.where(v26, 1.0, v25)
    v32 = xp.where(v26, 1.0 - d / xp.where(v26, v25, -1.0), xp.inf)
    v33 = xp.absolute(v32)
    v34 = v33 < 1e-15
    v35 = xp.where(v34, v33, 0.5 * 1e-15)
    v36 = xp.where(v34, 2.0 * 1e-15, v33)
    v37 = xp.where(v34, 0.0, v32)
    v38 = v37 < 0.0
    v39 = xp.where(v38, 1.0, v37)
    v42 = v39 > 0.0
    v46 = (1.0 - k) / 2.0
    v49 = growth(xp, xp.where(v42, xp.where(v42, v39, 1.0), 1.0), n / v46 + 0.0)
    v55 = d >= 0.0
    v58 = graded_normal_radius_from_depth(xp, xp.maximum(xp.where(v55, d, 1.0), 0.0), A, n, k)
    v54 = v18 * (1.0 + xp.where(v39 == 0.0, 0.0, v49)) ** (1.0 / v46)
    return xp.where(v38, xp.nan, xp.where(xp.isfinite(v39), v54, xp.where(v55, v58, xp.nan)))


def radius_from_force(xp, F, A, n, H, k, dgamma):
    v1 = dgamma > 0.0
    v8 = (3.0 + k) * xp.sqrt(3.141592653589793 * xp.where(v1, dgamma, 1.0) / (2.0 * H))
    v17 = xp.where(v1, (v8 / (A * power_rate(xp, 1.0, n, k))) ** (1.0 / (n - (1.0 - k) / 2.0)), 0.0)
    v20 = n + 1.0 + k
    v22 = 3.0 + k
    v25 = graded_normal_force(xp, v17, A, n, H, k) * (1.0 - 2.0 * v20 / v22)
    v26 = v25 < 0.0
    v27 = xp.where(v26, 1.0, v25)
    v31 = xp.where(v26, 1.0, v25)
    v32 = xp.where(v26, 1.0 - F / xp.where(v26, v25, -1.0), xp.inf)
    v33 = xp.absolute(v32)
    v34 = v33 < 1e-15
    v35 = xp.where(v34, v33, 0.5 * 1e-15)
    v36 = xp.where(v34, 2.0 * 1e-15, v33)
    v37 = xp.where(v34, 0.0, v32)
    v38 = v37 < 0.0
    v39 = xp.where(v38, 1.0, v37)
    v42 = v39 > 0.0
    v45 = v22 / 2.0
    v48 = growth(xp, xp.where(v42, xp.where(v42, v39, 1.0), 1.0), v20 / v45 + 0.0)
    v54 = F >= 0.0
    v57 = graded_normal_radius_from_force(xp, xp.maximum(xp.where(v54, F, 1.0), 0.0), A, n, H, k)
    v53 = v17 * (1.0 + xp.where(v39 == 0.0, 0.0, v48)) ** (1.0 / v45)
    return xp.where(v38, xp.nan, xp.where(xp.isfinite(v39), v53, xp.where(v54, v57, xp.nan)))


def work_of_adhesion_from_pull_off(xp, F, A, n, H, k):
    v2 = F < 0.0
    v4 = xp.where(v2, 1.0, F)
    v5 = xp.where(v2, -F, xp.nan)
    v11 = v5 * (k + 3.0) / (k + 2.0 * n - 1.0)
    v14 = separation(xp, v5 + v11, graded_normal_radius_from_force(xp, v11, A, n, H, k), H, k)
    return xp.where(F == 0.0, 0.0, v14)
