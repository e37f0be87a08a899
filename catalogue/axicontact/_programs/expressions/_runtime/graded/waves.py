"""Formulas of axicontact._runtime.graded.waves over an array library `xp`."""

from ....._programs.expressions._runtime.graded.rules import raised
from ....._programs.expressions._runtime.graded.rules import sine_over
from ....._runtime.steps import nodes_along
from ....._runtime.steps import weighted_along


def waves_depth(xp, a, q, k):
    v23, v24 = nodes_along(xp, 4, a, q, k)
    v1 = q * a
    v2 = v1 > xp.inf
    v3 = xp.where(v2, v1, 2.0 * xp.inf)
    v5 = xp.minimum(xp.where(v2, 0.5 * xp.inf, v1), xp.inf)
    v8 = xp.minimum(1.5707963267948966, 8.0 / xp.maximum(v5, 1e-300))
    v11, v12 = weighted_along(xp, 1.0 + k, a, q, k)
    v13 = v11 * v8
    v20 = xp.sum(v12 * (xp.sin(v5 * xp.cos(v13)) * sine_over(xp, v13) ** k), axis=0)
    v22 = 1.5707963267948966 - v8
    v26 = v8 + v23 * v22
    v33 = v22 * xp.sum(v24 * (xp.sin(v5 * xp.cos(v26)) * xp.sin(v26) ** k), axis=0)
    return v1 * xp.where(v2, 0.0, raised(xp, v8, k) * v20 + v33)


def waves_force(xp, a, q, k):
    v27, v28 = nodes_along(xp, 4, a, q, k)
    v1 = q * a
    v4 = v1 > xp.inf
    v5 = xp.where(v4, v1, 2.0 * xp.inf)
    v7 = xp.minimum(xp.where(v4, 0.5 * xp.inf, v1), xp.inf)
    v10 = xp.minimum(1.5707963267948966, 8.0 / xp.maximum(v7, 1e-300))
    v13, v14 = weighted_along(xp, 1.0 + k, a, q, k)
    v15 = v13 * v10
    v16 = xp.cos(v15)
    v24 = xp.sum(v14 * (xp.sin(v7 * v16) * v16 * v16 * sine_over(xp, v15) ** k), axis=0)
    v26 = 1.5707963267948966 - v10
    v30 = v10 + v27 * v26
    v31 = xp.cos(v30)
    v39 = v26 * xp.sum(v28 * (xp.sin(v7 * v31) * v31 * v31 * xp.sin(v30) ** k), axis=0)
    return v1 * raised(xp, a, k) * xp.where(v4, 0.0, raised(xp, v10, k) * v24 + v39)


def waves_rate(xp, t, q, k):
    v26, v27 = nodes_along(xp, 4, t, q, k)
    v1 = q * t
    v2 = v1 > xp.inf
    v3 = xp.where(v2, v1, 2.0 * xp.inf)
    v5 = xp.minimum(xp.where(v2, 0.5 * xp.inf, v1), xp.inf)
    v8 = xp.minimum(1.5707963267948966, 8.0 / xp.maximum(v5, 1e-300))
    v11, v12 = weighted_along(xp, 1.0 + k, t, q, k)
    v13 = v11 * v8
    v15 = v5 * xp.cos(v13)
    v23 = xp.sum(v12 * ((xp.sin(v15) + v15 * xp.cos(v15)) * sine_over(xp, v13) ** k), axis=0)
    v25 = 1.5707963267948966 - v8
    v29 = v8 + v26 * v25
    v31 = v5 * xp.cos(v29)
    v39 = v25 * xp.sum(v27 * ((xp.sin(v31) + v31 * xp.cos(v31)) * xp.sin(v29) ** k), axis=0)
    return q * xp.where(v2, 0.0, raised(xp, v8, k) * v23 + v39)
