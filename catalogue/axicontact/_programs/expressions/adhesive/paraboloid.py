"""Formulas of axicontact.adhesive.paraboloid over an array library `xp`."""

from ...._programs.expressions._runtime.physics.adhesion import growth
from ...._programs.expressions._runtime.physics.adhesion import hess_retraction as retraction
from ...._programs.expressions._runtime.physics.adhesion import lift
from ...._programs.expressions._runtime.physics.adhesion import pull
from ...._programs.expressions._runtime.physics.adhesion import separation
from ...._programs.expressions._runtime.physics.adhesion import tension
from ...._programs.expressions.normal.paraboloid import displacement as normal_displacement
from ...._programs.expressions.normal.paraboloid import force as normal_force
from ...._programs.expressions.normal.paraboloid import pressure as normal_pressure
from ...._programs.expressions.normal.paraboloid import radius_from_force as normal_radius_from_force


def depth(xp, a, R, E_star, dgamma):
    return a ** 2.0 / R - retraction(xp, a, E_star, dgamma)


def force(xp, a, R, E_star, dgamma):
    return normal_force(xp, a, R, E_star) - pull(xp, a, E_star, dgamma)


def pressure(xp, r, a, R, E_star, dgamma):
    return normal_pressure(xp, r, a, R, E_star) - tension(xp, r, a, E_star, dgamma)


def displacement(xp, r, a, R, E_star, dgamma):
    return normal_displacement(xp, r, a, R) - lift(xp, r, a, E_star, dgamma)


def radius_from_depth(xp, d, R, E_star, dgamma):
    v1 = dgamma > 0.0
    v8 = xp.cbrt(3.141592653589793 * R ** 2.0 * xp.where(v1, dgamma, 1.0) / (8.0 * E_star))
    v9 = xp.where(v1, v8, 0.0)
    v12 = v9 ** 2.0 / R * -3.0
    v13 = v12 < 0.0
    v14 = xp.where(v13, 1.0, v12)
    v18 = xp.where(v13, 1.0, v12)
    v19 = xp.where(v13, 1.0 - d / xp.where(v13, v12, -1.0), xp.inf)
    v20 = xp.absolute(v19)
    v21 = v20 < 1e-15
    v22 = xp.where(v21, v20, 0.5 * 1e-15)
    v23 = xp.where(v21, 2.0 * 1e-15, v20)
    v24 = xp.where(v21, 0.0, v19)
    v25 = v24 < 0.0
    v26 = xp.where(v25, 1.0, v24)
    v29 = v26 > 0.0
    v33 = xp.where(v26 == 0.0, 0.0, growth(xp, xp.where(v29, xp.where(v29, v26, 1.0), 1.0), 4.0))
    v37 = d >= 0.0
    v40 = R * xp.maximum(xp.where(v37, d, 1.0), 0.0)
    v41 = v40 > 0.0
    v45 = xp.where(v37, xp.where(v41, xp.sqrt(xp.where(v41, v40, 1.0)), 0.0), xp.nan)
    return xp.where(v25, xp.nan, xp.where(xp.isfinite(v26), v9 * (1.0 + v33) ** 2.0, v45))


def radius_from_force(xp, F, R, E_star, dgamma):
    v1 = dgamma > 0.0
    v8 = xp.cbrt(28.274333882308138 * R ** 2.0 * xp.where(v1, dgamma, 1.0) / (8.0 * E_star))
    v9 = xp.where(v1, v8, 0.0)
    v11 = normal_force(xp, v9, R, E_star) * -1.0
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
    v32 = xp.where(v25 == 0.0, 0.0, growth(xp, xp.where(v28, xp.where(v28, v25, 1.0), 1.0), 2.0))
    v36 = F >= 0.0
    v39 = normal_radius_from_force(xp, xp.maximum(xp.where(v36, F, 1.0), 0.0), R, E_star)
    v35 = v9 * (1.0 + v32) ** 0.6666666666666666
    return xp.where(v24, xp.nan, xp.where(xp.isfinite(v25), v35, xp.where(v36, v39, xp.nan)))


def work_of_adhesion_from_pull_off(xp, F, R, E_star):
    v2 = F < 0.0
    v4 = xp.where(v2, 1.0, F)
    v5 = xp.where(v2, -F, xp.nan)
    v8 = separation(xp, v5 + v5, normal_radius_from_force(xp, v5, R, E_star), E_star)
    return xp.where(F == 0.0, 0.0, v8)
