"""Formulas of axicontact.adhesive.cone over an array library `xp`."""

from ...._programs.expressions._runtime.physics.adhesion import growth
from ...._programs.expressions._runtime.physics.adhesion import hess_retraction as retraction
from ...._programs.expressions._runtime.physics.adhesion import lift
from ...._programs.expressions._runtime.physics.adhesion import pull
from ...._programs.expressions._runtime.physics.adhesion import separation
from ...._programs.expressions._runtime.physics.adhesion import tension
from ...._programs.expressions.normal.cone import depth as normal_depth
from ...._programs.expressions.normal.cone import displacement as normal_displacement
from ...._programs.expressions.normal.cone import force as normal_force
from ...._programs.expressions.normal.cone import pressure as normal_pressure
from ...._programs.expressions.normal.cone import radius_from_depth as normal_radius_from_depth
from ...._programs.expressions.normal.cone import radius_from_force as normal_radius_from_force


def depth(xp, a, theta, E_star, dgamma):
    return normal_depth(xp, a, theta) - retraction(xp, a, E_star, dgamma)


def force(xp, a, theta, E_star, dgamma):
    return normal_force(xp, a, theta, E_star) - pull(xp, a, E_star, dgamma)


def pressure(xp, r, a, theta, E_star, dgamma):
    return normal_pressure(xp, r, a, theta, E_star) - tension(xp, r, a, E_star, dgamma)


def displacement(xp, r, a, theta, E_star, dgamma):
    return normal_displacement(xp, r, a, theta) - lift(xp, r, a, E_star, dgamma)


def radius_from_depth(xp, d, theta, E_star, dgamma):
    v1 = dgamma > 0.0
    v8 = 2.0 * xp.where(v1, dgamma, 1.0) / (3.141592653589793 * E_star * xp.tan(theta) ** 2.0)
    v9 = xp.where(v1, v8, 0.0)
    v11 = normal_depth(xp, v9, theta) * -1.0
    v12 = v11 < 0.0
    v13 = xp.where(v12, 1.0, v11)
    v17 = xp.where(v12, 1.0, v11)
    v18 = xp.where(v12, 1.0 - d / xp.where(v12, v11, -1.0), xp.inf)
    v19 = xp.absolute(v18)
    v20 = v19 < 1e-15
    v21 = xp.where(v20, v19, 0.5 * 1e-15)
    v22 = xp.where(v20, 2.0 * 1e-15, v19)
    v23 = xp.where(v20, 0.0, v18)
    v24 = v23 < 0.0
    v25 = xp.where(v24, 1.0, v23)
    v28 = v25 > 0.0
    v32 = xp.where(v25 == 0.0, 0.0, growth(xp, xp.where(v28, xp.where(v28, v25, 1.0), 1.0), 2.0))
    v36 = d >= 0.0
    v39 = normal_radius_from_depth(xp, xp.maximum(xp.where(v36, d, 1.0), 0.0), theta)
    v41 = xp.where(xp.isfinite(v25), v9 * (1.0 + v32) ** 2.0, xp.where(v36, v39, xp.nan))
    return xp.where(v24, xp.nan, v41)


def radius_from_force(xp, F, theta, E_star, dgamma):
    v1 = dgamma > 0.0
    v8 = 18.0 * xp.where(v1, dgamma, 1.0) / (3.141592653589793 * E_star * xp.tan(theta) ** 2.0)
    v9 = xp.where(v1, v8, 0.0)
    v11 = normal_force(xp, v9, theta, E_star) * -0.33333333333333326
    v12 = v11 < 0.0
    v13 = xp.where(v12, 1.0, v11)
    v17 = xp.where(v12, 1.0, v11)
    v18 = xp.where(v12, 1.0 - F / xp.where(v12, v11, -1.0), xp.inf)
    v19 = xp.absolute(v18)
    v20 = v19 < 1e-15
    v21 = xp.where(v20, v19, 0.5 * 1e-15)
    v22 = xp.where(v20, 2.0 * 1e-15, v19)
    v23 = xp.where(v20, 0.0, v18)
    v24 = v23 < 0.0
    v25 = xp.where(v24, 1.0, v23)
    v28 = v25 > 0.0
    v31 = growth(xp, xp.where(v28, xp.where(v28, v25, 1.0), 1.0), 1.3333333333333333)
    v36 = F >= 0.0
    v39 = normal_radius_from_force(xp, xp.maximum(xp.where(v36, F, 1.0), 0.0), theta, E_star)
    v35 = v9 * (1.0 + xp.where(v25 == 0.0, 0.0, v31)) ** 0.6666666666666666
    return xp.where(v24, xp.nan, xp.where(xp.isfinite(v25), v35, xp.where(v36, v39, xp.nan)))


def work_of_adhesion_from_pull_off(xp, F, theta, E_star):
    v2 = F < 0.0
    v4 = xp.where(v2, 1.0, F)
    v5 = xp.where(v2, -F, xp.nan)
    v6 = 3.0 * v5
    v9 = separation(xp, v5 + v6, normal_radius_from_force(xp, v6, theta, E_star), E_star)
    return xp.where(F == 0.0, 0.0, v9)
