"""Formulas of axicontact.graded.adhesive.paraboloid over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import power_displacement
from ....._programs.expressions._runtime.graded.displacement import punch_share
from ....._programs.expressions._runtime.graded.growth import power_rate
from ....._programs.expressions._runtime.graded.punch import graded_retraction as retraction
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions._runtime.graded.punch import separation
from ....._programs.expressions._runtime.graded.punch import tension
from ....._programs.expressions._runtime.physics.adhesion import growth
from ....._programs.expressions.graded.normal.paraboloid import depth as graded_normal_depth
from ....._programs.expressions.graded.normal.paraboloid import force as graded_normal_force
from ....._programs.expressions.graded.normal.paraboloid import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.paraboloid import radius_from_force as graded_normal_radius_from_force


def depth(xp, a, R, H, k, dgamma):
    return graded_normal_depth(xp, a, R, k) - retraction(xp, a, H, k, dgamma)


def force(xp, a, R, H, k, dgamma):
    v4 = punch_stiffness(xp, a, H, k) * retraction(xp, a, H, k, dgamma)
    return graded_normal_force(xp, a, R, H, k) - v4


def pressure(xp, r, a, R, H, k, dgamma):
    return graded_normal_pressure(xp, r, a, R, H, k) - tension(xp, r, a, H, k, dgamma)


def displacement(xp, r, a, R, H, k, dgamma):
    v5 = r > a
    v8 = xp.where(v5, 0.5 * a, r)
    v9 = xp.where(v5, punch_share(xp, xp.where(v5, r, 2.0 * a), a, k), 1.0)
    v11 = power_displacement(xp, r, a, 2.0, k) / (2.0 * R) - retraction(xp, a, H, k, dgamma) * v9
    return v11


def radius_from_depth(xp, d, R, H, k, dgamma):
    v1 = dgamma > 0.0
    v9 = (1.0 + -1.0 * k) * xp.sqrt(3.141592653589793 * xp.where(v1, dgamma, 1.0) / (2.0 * H))
    v18 = (v9 / (power_rate(xp, 1.0, 2.0, k) / (2.0 * R))) ** (1.0 / (2.0 - (1.0 - k) / 2.0))
    v19 = xp.where(v1, v18, 0.0)
    v25 = graded_normal_depth(xp, v19, R, k) * (1.0 - 4.0 / (1.0 + -1.0 * k))
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
    v49 = growth(xp, xp.where(v42, xp.where(v42, v39, 1.0), 1.0), 2.0 / v46 + 0.0)
    v55 = d >= 0.0
    v59 = xp.maximum(xp.where(v55, d, 1.0), 0.0) / graded_normal_depth(xp, 1.0, R, k)
    v60 = v59 > 0.0
    v54 = v19 * (1.0 + xp.where(v39 == 0.0, 0.0, v49)) ** (1.0 / v46)
    v64 = xp.where(v55, xp.where(v60, xp.sqrt(xp.where(v60, v59, 1.0)), 0.0), xp.nan)
    return xp.where(v38, xp.nan, xp.where(xp.isfinite(v39), v54, v64))


def radius_from_force(xp, F, R, H, k, dgamma):
    v1 = dgamma > 0.0
    v8 = (3.0 + k) * xp.sqrt(3.141592653589793 * xp.where(v1, dgamma, 1.0) / (2.0 * H))
    v17 = (v8 / (power_rate(xp, 1.0, 2.0, k) / (2.0 * R))) ** (1.0 / (2.0 - (1.0 - k) / 2.0))
    v18 = xp.where(v1, v17, 0.0)
    v20 = 3.0 + k
    v24 = graded_normal_force(xp, v18, R, H, k) * (1.0 - 2.0 * v20 / v20)
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
    v44 = v20 / 2.0
    v47 = growth(xp, xp.where(v41, xp.where(v41, v38, 1.0), 1.0), v20 / v44 + 0.0)
    v53 = F >= 0.0
    v56 = graded_normal_radius_from_force(xp, xp.maximum(xp.where(v53, F, 1.0), 0.0), R, H, k)
    v52 = v18 * (1.0 + xp.where(v38 == 0.0, 0.0, v47)) ** (1.0 / v44)
    return xp.where(v37, xp.nan, xp.where(xp.isfinite(v38), v52, xp.where(v53, v56, xp.nan)))


def work_of_adhesion_from_pull_off(xp, F, R, H, k):
    v2 = F < 0.0
    v4 = xp.where(v2, 1.0, F)
    v5 = xp.where(v2, -F, xp.nan)
    v8 = separation(xp, v5 + v5, graded_normal_radius_from_force(xp, v5, R, H, k), H, k)
    return xp.where(F == 0.0, 0.0, v8)
