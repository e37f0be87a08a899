"""Formulas of axicontact.tangential.capped_paraboloid over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.slip import gap
from ...._programs.expressions._runtime.physics.slip import stick_force
from ...._programs.expressions.normal.capped_paraboloid import depth as normal_depth
from ...._programs.expressions.normal.capped_paraboloid import force as normal_force
from ...._programs.expressions.normal.capped_paraboloid import pressure as normal_pressure
from ...._programs.expressions.normal.capped_paraboloid import radius_from_force as normal_radius_from_force
from ...._programs.expressions.normal.capped_paraboloid import slope_beyond as normal_slope_beyond
from ...._runtime.steps import nodes_along


def tangential_force(xp, a, c, R1, R2, b, E_star, mu):
    v20, v21 = nodes_along(xp, 1, a, c, R1, R2, b, E_star, mu)
    v1 = normal_force(xp, c, R1, R2, b, E_star)
    v2 = normal_force(xp, a, R1, R2, b, E_star)
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
    v34 = xp.maximum(b, c)
    v36 = v7 & (a > v34)
    v38 = difference_root(xp, v34, b)
    v41 = difference_root(xp, v34, 0.0)
    v42 = gap(xp, a, v34, difference_root(xp, a, 0.0), v41)
    v46 = xp.log1p((gap(xp, a, v34, difference_root(xp, a, b), v38) + v42) / (v38 + v41))
    v47 = xp.where(v36, v46, 0.0)
    v48 = v20 * v47
    v54 = v38 * xp.cosh(v48) + v41 * xp.sinh(v48)
    v57 = xp.sqrt(b * b + v54 * v54)
    v62 = normal_slope_beyond(xp, v57, v54, R1, R2, b) * (v54 / v57) * v57 ** 2.0
    v33 = xp.where(v10, v19 * xp.sum(v21 * (2.0 * v27 / R1 * v27 ** 2.0), axis=0), 0.0)
    v66 = 2.0 * E_star * (v33 + xp.where(v36, v47 * xp.sum(v21 * v62, axis=0), 0.0))
    return mu * xp.where(v4, v66, v2 - xp.where(v4, 0.5 * v3, v1))


def traction(xp, r, a, c, R1, R2, b, E_star, mu):
    v20, v21 = nodes_along(xp, 1, r, a, c, R1, R2, b, E_star, mu)
    v2 = normal_pressure(xp, r, c, R1, R2, b, E_star)
    v3 = normal_pressure(xp, r, a, R1, R2, b, E_star)
    v6 = (r < c) & (v2 >= 0.25 * v3)
    v8 = xp.minimum(a, b)
    v10 = v6 & (v8 > c)
    v13 = difference_root(xp, c, r)
    v18 = xp.log1p((v8 - c + gap(xp, v8, c, difference_root(xp, v8, r), v13)) / (c + v13))
    v19 = xp.where(v10, v18, 0.0)
    v22 = v20 * v19
    v27 = c * xp.cosh(v22) + v13 * xp.sinh(v22)
    v34 = xp.maximum(b, c)
    v36 = v6 & (a > v34)
    v38 = difference_root(xp, v34, b)
    v41 = difference_root(xp, v34, r)
    v42 = gap(xp, a, v34, difference_root(xp, a, r), v41)
    v46 = xp.log1p((gap(xp, a, v34, difference_root(xp, a, b), v38) + v42) / (v38 + v41))
    v47 = xp.where(v36, v46, 0.0)
    v48 = v20 * v47
    v54 = v38 * xp.cosh(v48) + v41 * xp.sinh(v48)
    v57 = xp.sqrt(b * b + v54 * v54)
    v62 = normal_slope_beyond(xp, v57, v54, R1, R2, b) * (v54 / v57) * v57 ** 0.0
    v33 = xp.where(v10, v19 * xp.sum(v21 * (2.0 * v27 / R1 * v27 ** 0.0), axis=0), 0.0)
    v66 = E_star / 3.141592653589793 * (v33 + xp.where(v36, v47 * xp.sum(v21 * v62, axis=0), 0.0))
    return mu * xp.where(v6, v66, v3 - v2)


def tangential_displacement(xp, a, c, R1, R2, b, E_star, G_star, mu):
    v21, v22 = nodes_along(xp, 1, a, c, R1, R2, b, E_star, G_star, mu)
    v3 = normal_depth(xp, c, R1, R2, b)
    v4 = normal_depth(xp, a, R1, R2, b)
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
    v35 = xp.maximum(b, c)
    v37 = v8 & (a > v35)
    v39 = difference_root(xp, v35, b)
    v42 = difference_root(xp, v35, 0.0)
    v43 = gap(xp, a, v35, difference_root(xp, a, 0.0), v42)
    v47 = xp.log1p((gap(xp, a, v35, difference_root(xp, a, b), v39) + v43) / (v39 + v42))
    v48 = xp.where(v37, v47, 0.0)
    v49 = v21 * v48
    v55 = v39 * xp.cosh(v49) + v42 * xp.sinh(v49)
    v58 = xp.sqrt(b * b + v55 * v55)
    v63 = normal_slope_beyond(xp, v58, v55, R1, R2, b) * (v55 / v58) * v58 ** 1.0
    v34 = xp.where(v11, v20 * xp.sum(v22 * (2.0 * v28 / R1 * v28 ** 1.0), axis=0), 0.0)
    v66 = v34 + xp.where(v37, v48 * xp.sum(v22 * v63, axis=0), 0.0)
    return mu * (E_star / G_star) * xp.where(v6, v66, v4 - xp.where(v6, 0.5 * v5, v3))


def stick_radius(xp, F_x, a, R1, R2, b, E_star, mu):
    v5 = stick_force(xp, normal_force(xp, a, R1, R2, b, E_star), F_x, mu)
    v7 = xp.where((F_x == 0.0) & (a >= 0.0), a, normal_radius_from_force(xp, v5, R1, R2, b, E_star))
    return v7


def full_slip_displacement(xp, a, R1, R2, b, E_star, G_star, mu):
    return mu * (E_star / G_star) * normal_depth(xp, a, R1, R2, b)
