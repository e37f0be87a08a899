"""Formulas of axicontact.adhesive.power_law over an array library `xp`."""

from ...._programs.expressions._runtime.physics.adhesion import growth
from ...._programs.expressions._runtime.physics.adhesion import hess_retraction as retraction
from ...._programs.expressions._runtime.physics.adhesion import lift
from ...._programs.expressions._runtime.physics.adhesion import pull
from ...._programs.expressions._runtime.physics.adhesion import separation
from ...._programs.expressions._runtime.physics.adhesion import tension
from ...._programs.expressions._runtime.special import gamma_ratio
from ...._programs.expressions.normal.power_law import depth as normal_depth
from ...._programs.expressions.normal.power_law import displacement as normal_displacement
from ...._programs.expressions.normal.power_law import force as normal_force
from ...._programs.expressions.normal.power_law import pressure as normal_pressure
from ...._programs.expressions.normal.power_law import radius_from_depth as normal_radius_from_depth
from ...._programs.expressions.normal.power_law import radius_from_force as normal_radius_from_force


def depth(xp, a, A, n, E_star, dgamma):
    return normal_depth(xp, a, A, n) - retraction(xp, a, E_star, dgamma)


def force(xp, a, A, n, E_star, dgamma):
    return normal_force(xp, a, A, n, E_star) - pull(xp, a, E_star, dgamma)


def pressure(xp, r, a, A, n, E_star, dgamma):
    return normal_pressure(xp, r, a, A, n, E_star) - tension(xp, r, a, E_star, dgamma)


def displacement(xp, r, a, A, n, E_star, dgamma):
    return normal_displacement(xp, r, a, A, n) - lift(xp, r, a, E_star, dgamma)


def radius_from_depth(xp, d, A, n, E_star, dgamma):
    v1 = n > 0.5
    v2 = xp.where(v1, n, 2.0 * 0.5)
    v3 = dgamma > 0.0
    v8 = 2.0 * v2
    v7 = xp.sqrt(2.0 * xp.where(v3, dgamma, 1.0) / E_star)
    v14 = v7 / (v8 * A * gamma_ratio(xp, v2 / 2.0 + 0.5))
    v18 = v8 - 1.0
    v19 = v18 + 0.0
    v21 = v14 ** (1.0 / v19)
    v29 = v21 + v21 * ((v14 / (v21 ** v18 * v21 ** 0.0) - 1.0) / v19)
    v33 = xp.where(v1, 0.5 * 0.5, n)
    v32 = xp.where(v3, xp.where((v14 > 0.0) & (v14 < xp.inf), v29, v21) ** 2.0, 0.0)
    v34 = xp.where(v1, v32, xp.nan)
    v38 = normal_depth(xp, v34, A, n) * (1.0 - 2.0 * n)
    v39 = v38 < 0.0
    v40 = xp.where(v39, 1.0, v38)
    v44 = xp.where(v39, 1.0, v38)
    v45 = xp.where(v39, 1.0 - d / xp.where(v39, v38, -1.0), xp.inf)
    v46 = xp.absolute(v45)
    v47 = v46 < 1e-15
    v48 = xp.where(v47, v46, 0.5 * 1e-15)
    v49 = xp.where(v47, 2.0 * 1e-15, v46)
    v50 = xp.where(v47, 0.0, v45)
    v51 = v50 < 0.0
    v52 = xp.where(v51, 1.0, v50)
    v55 = v52 > 0.0
    v60 = growth(xp, xp.where(v55, xp.where(v55, v52, 1.0), 1.0), n / 0.5 + 0.0)
    v65 = d >= 0.0
    v68 = normal_radius_from_depth(xp, xp.maximum(xp.where(v65, d, 1.0), 0.0), A, n)
    v64 = v34 * (1.0 + xp.where(v52 == 0.0, 0.0, v60)) ** 2.0
    return xp.where(v51, xp.nan, xp.where(xp.isfinite(v52), v64, xp.where(v65, v68, xp.nan)))


def radius_from_force(xp, F, A, n, E_star, dgamma):
    v1 = n > 0.5
    v2 = xp.where(v1, n, 2.0 * 0.5)
    v3 = dgamma > 0.0
    v9 = 2.0 * v2
    v8 = 3.0 * xp.sqrt(2.0 * xp.where(v3, dgamma, 1.0) / E_star)
    v15 = v8 / (v9 * A * gamma_ratio(xp, v2 / 2.0 + 0.5))
    v19 = v9 - 1.0
    v20 = v19 + 0.0
    v22 = v15 ** (1.0 / v20)
    v30 = v22 + v22 * ((v15 / (v22 ** v19 * v22 ** 0.0) - 1.0) / v20)
    v34 = xp.where(v1, 0.5 * 0.5, n)
    v33 = xp.where(v3, xp.where((v15 > 0.0) & (v15 < xp.inf), v30, v22) ** 2.0, 0.0)
    v35 = xp.where(v1, v33, xp.nan)
    v37 = n + 1.0
    v41 = normal_force(xp, v35, A, n, E_star) * (1.0 - 2.0 * v37 / 3.0)
    v42 = v41 < 0.0
    v43 = xp.where(v42, 1.0, v41)
    v47 = xp.where(v42, 1.0, v41)
    v48 = xp.where(v42, 1.0 - F / xp.where(v42, v41, -1.0), xp.inf)
    v49 = xp.absolute(v48)
    v50 = v49 < 1e-15
    v51 = xp.where(v50, v49, 0.5 * 1e-15)
    v52 = xp.where(v50, 2.0 * 1e-15, v49)
    v53 = xp.where(v50, 0.0, v48)
    v54 = v53 < 0.0
    v55 = xp.where(v54, 1.0, v53)
    v58 = v55 > 0.0
    v63 = growth(xp, xp.where(v58, xp.where(v58, v55, 1.0), 1.0), v37 / 1.5 + 0.0)
    v68 = F >= 0.0
    v71 = normal_radius_from_force(xp, xp.maximum(xp.where(v68, F, 1.0), 0.0), A, n, E_star)
    v67 = v35 * (1.0 + xp.where(v55 == 0.0, 0.0, v63)) ** 0.6666666666666666
    return xp.where(v54, xp.nan, xp.where(xp.isfinite(v55), v67, xp.where(v68, v71, xp.nan)))


def work_of_adhesion_from_pull_off(xp, F, A, n, E_star):
    v2 = F < 0.0
    v4 = xp.where(v2, 1.0, F)
    v5 = xp.where(v2, -F, xp.nan)
    v9 = 3.0 * v5 / (2.0 * n - 1.0)
    v12 = separation(xp, v5 + v9, normal_radius_from_force(xp, v9, A, n, E_star), E_star)
    return xp.where(F == 0.0, 0.0, v12)
