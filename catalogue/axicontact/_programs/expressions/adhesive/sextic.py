"""Formulas of axicontact.adhesive.sextic over an array library `xp`."""

from ...._programs.expressions._runtime.physics.adhesion import growth
from ...._programs.expressions._runtime.physics.adhesion import hess_retraction as retraction
from ...._programs.expressions._runtime.physics.adhesion import lift
from ...._programs.expressions._runtime.physics.adhesion import pull
from ...._programs.expressions._runtime.physics.adhesion import separation
from ...._programs.expressions._runtime.physics.adhesion import tension
from ...._programs.expressions.normal.sextic import depth as normal_depth
from ...._programs.expressions.normal.sextic import displacement as normal_displacement
from ...._programs.expressions.normal.sextic import force as normal_force
from ...._programs.expressions.normal.sextic import pressure as normal_pressure
from ...._programs.expressions.normal.sextic import radius_from_depth as normal_radius_from_depth
from ...._programs.expressions.normal.sextic import radius_from_force as normal_radius_from_force


def depth(xp, a, A, E_star, dgamma):
    return normal_depth(xp, a, A) - retraction(xp, a, E_star, dgamma)


def force(xp, a, A, E_star, dgamma):
    return normal_force(xp, a, A, E_star) - pull(xp, a, E_star, dgamma)


def pressure(xp, r, a, A, E_star, dgamma):
    return normal_pressure(xp, r, a, A, E_star) - tension(xp, r, a, E_star, dgamma)


def displacement(xp, r, a, A, E_star, dgamma):
    return normal_displacement(xp, r, a, A) - lift(xp, r, a, E_star, dgamma)


def radius_from_depth(xp, d, A, E_star, dgamma):
    v1 = dgamma > 0.0
    v3 = 1.0 / A
    v7 = v3 ** 0.09090909090909091
    v15 = v7 + v7 * ((v3 / (v7 ** 11.0 * v7 ** 0.0) - 1.0) / 11.0)
    v20 = 78.53981633974483 * xp.where(v1, dgamma, 1.0) / (18432.0 * E_star)
    v24 = v20 ** 0.09090909090909091
    v32 = v24 + v24 * ((v20 / (v24 ** 11.0 * v24 ** 0.0) - 1.0) / 11.0)
    v17 = xp.where((v3 > 0.0) & (v3 < xp.inf), v15, v7) ** 2.0
    v35 = xp.where(v1, v17 * xp.where((v20 > 0.0) & (v20 < xp.inf), v32, v24), 0.0)
    v37 = normal_depth(xp, v35, A) * -11.0
    v38 = v37 < 0.0
    v39 = xp.where(v38, 1.0, v37)
    v43 = xp.where(v38, 1.0, v37)
    v44 = xp.where(v38, 1.0 - d / xp.where(v38, v37, -1.0), xp.inf)
    v45 = xp.absolute(v44)
    v46 = v45 < 1e-15
    v47 = xp.where(v46, v45, 0.5 * 1e-15)
    v48 = xp.where(v46, 2.0 * 1e-15, v45)
    v49 = xp.where(v46, 0.0, v44)
    v50 = v49 < 0.0
    v51 = xp.where(v50, 1.0, v49)
    v54 = v51 > 0.0
    v58 = xp.where(v51 == 0.0, 0.0, growth(xp, xp.where(v54, xp.where(v54, v51, 1.0), 1.0), 12.0))
    v62 = d >= 0.0
    v65 = normal_radius_from_depth(xp, xp.maximum(xp.where(v62, d, 1.0), 0.0), A)
    v67 = xp.where(xp.isfinite(v51), v35 * (1.0 + v58) ** 2.0, xp.where(v62, v65, xp.nan))
    return xp.where(v50, xp.nan, v67)


def radius_from_force(xp, F, A, E_star, dgamma):
    v1 = dgamma > 0.0
    v3 = 1.0 / A
    v7 = v3 ** 0.09090909090909091
    v15 = v7 + v7 * ((v3 / (v7 ** 11.0 * v7 ** 0.0) - 1.0) / 11.0)
    v20 = 78.53981633974483 * xp.where(v1, dgamma, 1.0) / (2048.0 * E_star)
    v24 = v20 ** 0.09090909090909091
    v32 = v24 + v24 * ((v20 / (v24 ** 11.0 * v24 ** 0.0) - 1.0) / 11.0)
    v17 = xp.where((v3 > 0.0) & (v3 < xp.inf), v15, v7) ** 2.0
    v35 = xp.where(v1, v17 * xp.where((v20 > 0.0) & (v20 < xp.inf), v32, v24), 0.0)
    v37 = normal_force(xp, v35, A, E_star) * -3.666666666666667
    v38 = v37 < 0.0
    v39 = xp.where(v38, 1.0, v37)
    v43 = xp.where(v38, 1.0, v37)
    v44 = xp.where(v38, 1.0 - F / xp.where(v38, v37, -1.0), xp.inf)
    v45 = xp.absolute(v44)
    v46 = v45 < 1e-15
    v47 = xp.where(v46, v45, 0.5 * 1e-15)
    v48 = xp.where(v46, 2.0 * 1e-15, v45)
    v49 = xp.where(v46, 0.0, v44)
    v50 = v49 < 0.0
    v51 = xp.where(v50, 1.0, v49)
    v54 = v51 > 0.0
    v57 = growth(xp, xp.where(v54, xp.where(v54, v51, 1.0), 1.0), 4.666666666666667)
    v62 = F >= 0.0
    v65 = normal_radius_from_force(xp, xp.maximum(xp.where(v62, F, 1.0), 0.0), A, E_star)
    v61 = v35 * (1.0 + xp.where(v51 == 0.0, 0.0, v57)) ** 0.6666666666666666
    return xp.where(v50, xp.nan, xp.where(xp.isfinite(v51), v61, xp.where(v62, v65, xp.nan)))


def work_of_adhesion_from_pull_off(xp, F, A, E_star):
    v2 = F < 0.0
    v4 = xp.where(v2, 1.0, F)
    v5 = xp.where(v2, -F, xp.nan)
    v7 = 3.0 * v5 / 11.0
    v10 = separation(xp, v5 + v7, normal_radius_from_force(xp, v7, A, E_star), E_star)
    return xp.where(F == 0.0, 0.0, v10)
