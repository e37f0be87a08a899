"""Formulas of axicontact.tangential.rounded_cone over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.slip import gap
from ...._programs.expressions._runtime.physics.slip import stick_force
from ...._programs.expressions.normal.rounded_cone import depth as normal_depth
from ...._programs.expressions.normal.rounded_cone import force as normal_force
from ...._programs.expressions.normal.rounded_cone import pressure as normal_pressure
from ...._programs.expressions.normal.rounded_cone import radius_from_force as normal_radius_from_force
from ...._programs.expressions.normal.rounded_cone import slope as normal_slope
from ...._programs.expressions.normal.rounded_cone import slope_beyond as normal_slope_beyond
from ...._runtime.steps import nodes_along


def tangential_force(xp, a, c, theta, b, E_star, mu):
    v20, v21 = nodes_along(xp, 1, a, c, theta, b, E_star, mu)
    v1 = normal_force(xp, c, theta, b, E_star)
    v2 = normal_force(xp, a, theta, b, E_star)
    v3 = 0.25 * v2
    v4 = v1 >= v3
    v7 = xp.where(v4, v1, 2.0 * v3) >= v3
    v8 = xp.minimum(a, b)
    v10 = v7 & (v8 > c)
    v13 = difference_root(xp, c, 0.0)
    v18 = xp.log1p((v8 - c + gap(xp, v8, c, difference_root(xp, v8, 0.0), v13)) / (c + v13))
    v19 = xp.where(v10, v18, 0.0)
    v22 = v20 * v19
    v27 = c * xp.cosh(v22) + v13 * xp.sinh(v22)
    v31 = v19 * xp.sum(v21 * (normal_slope(xp, v27, theta, b) * v27 ** 2.0), axis=0)
    v33 = xp.maximum(b, c)
    v35 = v7 & (a > v33)
    v37 = difference_root(xp, v33, b)
    v40 = difference_root(xp, v33, 0.0)
    v41 = gap(xp, a, v33, difference_root(xp, a, 0.0), v40)
    v45 = xp.log1p((gap(xp, a, v33, difference_root(xp, a, b), v37) + v41) / (v37 + v40))
    v46 = xp.where(v35, v45, 0.0)
    v47 = v20 * v46
    v53 = v37 * xp.cosh(v47) + v40 * xp.sinh(v47)
    v56 = xp.sqrt(b * b + v53 * v53)
    v61 = normal_slope_beyond(xp, v56, v53, theta, b) * (v53 / v56) * v56 ** 2.0
    v64 = xp.where(v10, v31, 0.0) + xp.where(v35, v46 * xp.sum(v21 * v61, axis=0), 0.0)
    return mu * xp.where(v4, 2.0 * E_star * v64, v2 - xp.where(v4, 0.5 * v3, v1))


def traction(xp, r, a, c, theta, b, E_star, mu):
    v20, v21 = nodes_along(xp, 1, r, a, c, theta, b, E_star, mu)
    v2 = normal_pressure(xp, r, c, theta, b, E_star)
    v3 = normal_pressure(xp, r, a, theta, b, E_star)
    v6 = (r < c) & (v2 >= 0.25 * v3)
    v8 = xp.minimum(a, b)
    v10 = v6 & (v8 > c)
    v13 = difference_root(xp, c, r)
    v18 = xp.log1p((v8 - c + gap(xp, v8, c, difference_root(xp, v8, r), v13)) / (c + v13))
    v19 = xp.where(v10, v18, 0.0)
    v22 = v20 * v19
    v27 = c * xp.cosh(v22) + v13 * xp.sinh(v22)
    v31 = v19 * xp.sum(v21 * (normal_slope(xp, v27, theta, b) * v27 ** 0.0), axis=0)
    v33 = xp.maximum(b, c)
    v35 = v6 & (a > v33)
    v37 = difference_root(xp, v33, b)
    v40 = difference_root(xp, v33, r)
    v41 = gap(xp, a, v33, difference_root(xp, a, r), v40)
    v45 = xp.log1p((gap(xp, a, v33, difference_root(xp, a, b), v37) + v41) / (v37 + v40))
    v46 = xp.where(v35, v45, 0.0)
    v47 = v20 * v46
    v53 = v37 * xp.cosh(v47) + v40 * xp.sinh(v47)
    v56 = xp.sqrt(b * b + v53 * v53)
    v61 = normal_slope_beyond(xp, v56, v53, theta, b) * (v53 / v56) * v56 ** 0.0
    v64 = xp.where(v10, v31, 0.0) + xp.where(v35, v46 * xp.sum(v21 * v61, axis=0), 0.0)
    return mu * xp.where(v6, E_star / 3.141592653589793 * v64, v3 - v2)


def tangential_displacement(xp, a, c, theta, b, E_star, G_star, mu):
    v21, v22 = nodes_along(xp, 1, a, c, theta, b, E_star, G_star, mu)
    v3 = normal_depth(xp, c, theta, b)
    v4 = normal_depth(xp, a, theta, b)
    v5 = 0.25 * v4
    v6 = v3 >= v5
    v8 = xp.where(v6, v3, 2.0 * v5) >= v5
    v9 = xp.minimum(a, b)
    v11 = v8 & (v9 > c)
    v14 = difference_root(xp, c, 0.0)
    v19 = xp.log1p((v9 - c + gap(xp, v9, c, difference_root(xp, v9, 0.0), v14)) / (c + v14))
    v20 = xp.where(v11, v19, 0.0)
    v23 = v21 * v20
    v28 = c * xp.cosh(v23) + v14 * xp.sinh(v23)
    v32 = v20 * xp.sum(v22 * (normal_slope(xp, v28, theta, b) * v28 ** 1.0), axis=0)
    v34 = xp.maximum(b, c)
    v36 = v8 & (a > v34)
    v38 = difference_root(xp, v34, b)
    v41 = difference_root(xp, v34, 0.0)
    v42 = gap(xp, a, v34, difference_root(xp, a, 0.0), v41)
    v46 = xp.log1p((gap(xp, a, v34, difference_root(xp, a, b), v38) + v42) / (v38 + v41))
    v47 = xp.where(v36, v46, 0.0)
    v48 = v21 * v47
    v54 = v38 * xp.cosh(v48) + v41 * xp.sinh(v48)
    v57 = xp.sqrt(b * b + v54 * v54)
    v62 = normal_slope_beyond(xp, v57, v54, theta, b) * (v54 / v57) * v57 ** 1.0
    v65 = xp.where(v11, v32, 0.0) + xp.where(v36, v47 * xp.sum(v22 * v62, axis=0), 0.0)
    return mu * (E_star / G_star) * xp.where(v6, v65, v4 - xp.where(v6, 0.5 * v5, v3))


def stick_radius(xp, F_x, a, theta, b, E_star, mu):
    v5 = stick_force(xp, normal_force(xp, a, theta, b, E_star), F_x, mu)
    v7 = xp.where((F_x == 0.0) & (a >= 0.0), a, normal_radius_from_force(xp, v5, theta, b, E_star))
    return v7


def full_slip_displacement(xp, a, theta, b, E_star, G_star, mu):
    return mu * (E_star / G_star) * normal_depth(xp, a, theta, b)
