"""Formulas of axicontact._runtime.physics.cohesive over an array library `xp`."""

from ....._programs.expressions._runtime.integrals import difference_root
from ....._runtime.steps import nodes_along


def ring_of_zone(xp, q, a, E_star, sigma_0):
    v8 = xp.arctan2(q, a) - q / (xp.hypot(a, q) + a)
    return 1.2732395447351628 * (sigma_0 / E_star) * q * v8


def pull_of_zone(xp, q, a, sigma_0):
    v2 = xp.hypot(a, q)
    return 2.0 * sigma_0 * (v2 * v2 * xp.arctan2(q, a) + a * q)


def tension_of_zone(xp, r, q, a, sigma_0):
    v1 = r < a
    v6 = xp.where(v1, 2.0 * a, r)
    v7 = xp.hypot(a, q)
    v8 = v6 < v7
    v9 = xp.where(v8, v6, 0.5 * v7)
    v10 = xp.where(v8, 2.0 * v7, v6)
    v5 = 0.6366197723675814 * xp.arctan2(q, difference_root(xp, a, xp.where(v1, r, 0.5 * a)))
    return sigma_0 * xp.where(v1, v5, xp.where(v8, 1.0, 0.0))


def lift_of_zone(xp, r, q, a, E_star, sigma_0):
    v25, v26 = nodes_along(xp, 1, r, q, a, E_star, sigma_0)
    v3 = xp.maximum(r, a)
    v4 = v3 > a
    v8 = xp.where(v4, 0.5 * a, v3)
    v7 = xp.arctan2(a, difference_root(xp, xp.where(v4, v3, 2.0 * a), a))
    v11 = xp.hypot(a, q)
    v12 = v3 < v11
    v15 = xp.where(v12, 2.0 * v11, v3)
    v18 = xp.maximum(v3, v11)
    v22 = xp.maximum(difference_root(xp, v18, xp.minimum(v3, v11)) / v18, 1e-09)
    v23 = xp.arctan2(xp.where(v12, difference_root(xp, xp.where(v12, v3, 0.5 * v11), a), q), a) / v22
    v24 = xp.arcsinh(v23)
    v27 = v25 * v24
    v28 = xp.where(v12, v3, 0.5 * v11)
    v29 = xp.maximum(v28, v11)
    v30 = xp.minimum(v28, v11)
    v32 = difference_root(xp, v29, v30) / v29
    v41 = xp.where(v12, 2.0 * v11, v3)
    v42 = xp.minimum(v41, v11)
    v43 = xp.maximum(v41, v11)
    v45 = difference_root(xp, v43, v42) / v43
    v49 = xp.sin(xp.maximum(v45, 1e-09) * xp.sinh(v27))
    v50 = v42 / v43
    v40 = v29 * xp.hypot(v32, v30 / v29 * xp.sin(xp.maximum(v32, 1e-09) * xp.sinh(v27)))
    v58 = xp.where(v12, v40, v42 * (v49 / xp.hypot(v45, v50 * v49)) * (v49 * v50)) * v22
    v62 = q * xp.where(v4, v7, 1.5707963267948966) + v24 * xp.sum(v26 * (v58 * xp.cosh(v27)), axis=0)
    return 1.2732395447351628 * (sigma_0 / E_star) * v62
