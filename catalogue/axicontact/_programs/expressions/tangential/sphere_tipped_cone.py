"""Formulas of axicontact.tangential.sphere_tipped_cone over an array library `xp`."""

from ...._programs.expressions._runtime.functions import sine_root
from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.slip import gap
from ...._programs.expressions._runtime.physics.slip import stick_force
from ...._programs.expressions.normal.sphere_tipped_cone import depth_at as normal_depth_at
from ...._programs.expressions.normal.sphere_tipped_cone import force_at as normal_force_at
from ...._programs.expressions.normal.sphere_tipped_cone import pressure as normal_pressure
from ...._programs.expressions.normal.sphere_tipped_cone import radius_from_force as normal_radius_from_force
from ...._programs.expressions.normal.sphere_tipped_cone import slope as normal_slope
from ...._programs.expressions.normal.sphere_tipped_cone import slope_beyond as normal_slope_beyond
from ...._runtime.steps import nodes_along


def tangential_force(xp, a, c, R, theta, E_star, mu):
    v31, v32 = nodes_along(xp, 1, a, c, R, theta, E_star, mu)
    v2 = normal_force_at(xp, c, sine_root(xp, c, R, theta), R, theta, E_star)
    v4 = normal_force_at(xp, a, sine_root(xp, a, R, theta), R, theta, E_star)
    v5 = 0.25 * v4
    v6 = v2 >= v5
    v9 = xp.where(v6, v2, 2.0 * v5) >= v5
    v11 = R * xp.sin(theta)
    v12 = xp.minimum(a, v11)
    v14 = v9 & (v12 > c)
    v15 = difference_root(xp, R, 0.0)
    v17 = difference_root(xp, v12, 0.0)
    v18 = difference_root(xp, c, 0.0)
    v21 = difference_root(xp, R, v12)
    v27 = 2.0 * v15 * gap(xp, v12, c, v17, v18) / v21 * ((v15 + v17) / (v15 + v18)) / v21
    v30 = xp.where(v14, 0.5 * xp.log1p(v27), 0.0)
    v33 = v31 * v30
    v34 = xp.cosh(v33)
    v36 = xp.sinh(v33)
    v42 = v15 * v34 + v18 * v36
    v43 = v15 * (v18 * v34 + v15 * v36) / v42
    v46 = xp.sqrt(0.0 + v43 * v43)
    v49 = v15 * difference_root(xp, R, c) / v42
    v56 = normal_slope(xp, v46, v49, R) * (v49 / v15) * (v49 / v46) * v46 ** 2.0
    v59 = xp.maximum(v11, c)
    v61 = v9 & (a > v59)
    v63 = difference_root(xp, v59, v11)
    v66 = difference_root(xp, v59, 0.0)
    v67 = gap(xp, a, v59, difference_root(xp, a, 0.0), v66)
    v71 = xp.log1p((gap(xp, a, v59, difference_root(xp, a, v11), v63) + v67) / (v63 + v66))
    v72 = xp.where(v61, v71, 0.0)
    v73 = v31 * v72
    v79 = v63 * xp.cosh(v73) + v66 * xp.sinh(v73)
    v82 = xp.sqrt(v11 * v11 + v79 * v79)
    v87 = normal_slope_beyond(xp, v82, v79, R, theta) * (v79 / v82) * v82 ** 2.0
    v89 = xp.where(v61, v72 * xp.sum(v32 * v87, axis=0), 0.0)
    v91 = 2.0 * E_star * (xp.where(v14, v30 * xp.sum(v32 * v56, axis=0), 0.0) + v89)
    return mu * xp.where(v6, v91, v4 - xp.where(v6, 0.5 * v5, v2))


def traction(xp, r, a, c, R, theta, E_star, mu):
    v29, v30 = nodes_along(xp, 1, r, a, c, R, theta, E_star, mu)
    v2 = normal_pressure(xp, r, c, R, theta, E_star)
    v3 = normal_pressure(xp, r, a, R, theta, E_star)
    v6 = (r < c) & (v2 >= 0.25 * v3)
    v9 = R * xp.sin(theta)
    v10 = xp.minimum(a, v9)
    v12 = v6 & (v10 > c)
    v13 = difference_root(xp, R, r)
    v15 = difference_root(xp, v10, r)
    v16 = difference_root(xp, c, r)
    v19 = difference_root(xp, R, v10)
    v25 = 2.0 * v13 * gap(xp, v10, c, v15, v16) / v19 * ((v13 + v15) / (v13 + v16)) / v19
    v28 = xp.where(v12, 0.5 * xp.log1p(v25), 0.0)
    v31 = v29 * v28
    v33 = xp.cosh(v31)
    v35 = xp.sinh(v31)
    v41 = v13 * v33 + v16 * v35
    v42 = v13 * (v16 * v33 + v13 * v35) / v41
    v45 = xp.sqrt(r * r + v42 * v42)
    v48 = v13 * difference_root(xp, R, c) / v41
    v55 = normal_slope(xp, v45, v48, R) * (v48 / v13) * (v48 / v45) * v45 ** 0.0
    v58 = xp.maximum(v9, c)
    v60 = v6 & (a > v58)
    v62 = difference_root(xp, v58, v9)
    v65 = difference_root(xp, v58, r)
    v63 = gap(xp, a, v58, difference_root(xp, a, v9), v62)
    v70 = xp.log1p((v63 + gap(xp, a, v58, difference_root(xp, a, r), v65)) / (v62 + v65))
    v71 = xp.where(v60, v70, 0.0)
    v72 = v29 * v71
    v78 = v62 * xp.cosh(v72) + v65 * xp.sinh(v72)
    v81 = xp.sqrt(v9 * v9 + v78 * v78)
    v86 = normal_slope_beyond(xp, v81, v78, R, theta) * (v78 / v81) * v81 ** 0.0
    v88 = xp.where(v60, v71 * xp.sum(v30 * v86, axis=0), 0.0)
    v90 = E_star / 3.141592653589793 * (xp.where(v12, v28 * xp.sum(v30 * v55, axis=0), 0.0) + v88)
    return mu * xp.where(v6, v90, v3 - v2)


def tangential_displacement(xp, a, c, R, theta, E_star, G_star, mu):
    v32, v33 = nodes_along(xp, 1, a, c, R, theta, E_star, G_star, mu)
    v4 = normal_depth_at(xp, c, sine_root(xp, c, R, theta), R, theta)
    v6 = normal_depth_at(xp, a, sine_root(xp, a, R, theta), R, theta)
    v7 = 0.25 * v6
    v8 = v4 >= v7
    v10 = xp.where(v8, v4, 2.0 * v7) >= v7
    v12 = R * xp.sin(theta)
    v13 = xp.minimum(a, v12)
    v15 = v10 & (v13 > c)
    v16 = difference_root(xp, R, 0.0)
    v18 = difference_root(xp, v13, 0.0)
    v19 = difference_root(xp, c, 0.0)
    v22 = difference_root(xp, R, v13)
    v28 = 2.0 * v16 * gap(xp, v13, c, v18, v19) / v22 * ((v16 + v18) / (v16 + v19)) / v22
    v31 = xp.where(v15, 0.5 * xp.log1p(v28), 0.0)
    v34 = v32 * v31
    v35 = xp.cosh(v34)
    v37 = xp.sinh(v34)
    v43 = v16 * v35 + v19 * v37
    v44 = v16 * (v19 * v35 + v16 * v37) / v43
    v47 = xp.sqrt(0.0 + v44 * v44)
    v50 = v16 * difference_root(xp, R, c) / v43
    v57 = normal_slope(xp, v47, v50, R) * (v50 / v16) * (v50 / v47) * v47 ** 1.0
    v60 = xp.maximum(v12, c)
    v62 = v10 & (a > v60)
    v64 = difference_root(xp, v60, v12)
    v67 = difference_root(xp, v60, 0.0)
    v68 = gap(xp, a, v60, difference_root(xp, a, 0.0), v67)
    v72 = xp.log1p((gap(xp, a, v60, difference_root(xp, a, v12), v64) + v68) / (v64 + v67))
    v73 = xp.where(v62, v72, 0.0)
    v74 = v32 * v73
    v80 = v64 * xp.cosh(v74) + v67 * xp.sinh(v74)
    v83 = xp.sqrt(v12 * v12 + v80 * v80)
    v88 = normal_slope_beyond(xp, v83, v80, R, theta) * (v80 / v83) * v83 ** 1.0
    v90 = xp.where(v62, v73 * xp.sum(v33 * v88, axis=0), 0.0)
    v91 = xp.where(v15, v31 * xp.sum(v33 * v57, axis=0), 0.0) + v90
    return mu * (E_star / G_star) * xp.where(v8, v91, v6 - xp.where(v8, 0.5 * v7, v4))


def stick_radius(xp, F_x, a, R, theta, E_star, mu):
    v6 = stick_force(xp, normal_force_at(xp, a, sine_root(xp, a, R, theta), R, theta, E_star), F_x, mu)
    v8 = xp.where((F_x == 0.0) & (a >= 0.0), a, normal_radius_from_force(xp, v6, R, theta, E_star))
    return v8


def full_slip_displacement(xp, a, R, theta, E_star, G_star, mu):
    return mu * (E_star / G_star) * normal_depth_at(xp, a, sine_root(xp, a, R, theta), R, theta)
