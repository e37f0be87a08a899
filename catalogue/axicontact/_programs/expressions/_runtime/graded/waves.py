"""Formulas of axicontact._runtime.graded.waves over an array library `xp`."""

from ....._programs.expressions._runtime.graded.rules import raised
from ....._runtime.steps import nodes_along
from ....._runtime.steps import weighted_along


def waves_depth(xp, a, q, k):
    v27, v28 = nodes_along(xp, 4, a, q, k)
    v1 = q * a
    v4 = xp.minimum(1.5707963267948966, 8.0 / xp.maximum(v1, 1e-300))
    v8, v9 = weighted_along(xp, 1.0 + k, a, q, k)
    v10 = v8 * v4
    v14 = v10 > 0.0
    v15 = xp.where(v14, v10, 1.0)
    v17 = v15 > 0.0
    v22 = xp.where(v14, xp.sin(v15) / xp.where(v17, xp.where(v17, v15, 1.0), 1.0), 1.0) ** k
    v26 = 1.5707963267948966 - v4
    v30 = v4 + v27 * v26
    v37 = v26 * xp.sum(v28 * (xp.sin(v1 * xp.cos(v30)) * xp.sin(v30) ** k), axis=0)
    v39 = v1 * (v4 * v4 ** k * xp.sum(v9 * (xp.sin(v1 * xp.cos(v10)) * v22), axis=0) + v37)
    return v39


def waves_force(xp, a, q, k):
    v31, v32 = nodes_along(xp, 4, a, q, k)
    v1 = q * a
    v6 = xp.minimum(1.5707963267948966, 8.0 / xp.maximum(v1, 1e-300))
    v10, v11 = weighted_along(xp, 1.0 + k, a, q, k)
    v12 = v10 * v6
    v13 = xp.cos(v12)
    v18 = v12 > 0.0
    v19 = xp.where(v18, v12, 1.0)
    v21 = v19 > 0.0
    v26 = xp.where(v18, xp.sin(v19) / xp.where(v21, xp.where(v21, v19, 1.0), 1.0), 1.0) ** k
    v30 = 1.5707963267948966 - v6
    v34 = v6 + v31 * v30
    v35 = xp.cos(v34)
    v43 = v30 * xp.sum(v32 * (xp.sin(v1 * v35) * v35 * v35 * xp.sin(v34) ** k), axis=0)
    v44 = v6 * v6 ** k * xp.sum(v11 * (xp.sin(v1 * v13) * v13 * v13 * v26), axis=0) + v43
    return v1 * raised(xp, a, k) * v44


def tilted(xp, x, tangent):
    return (2.0 * tangent + x * ((1.0 - tangent) * (1.0 + tangent))) / (1.0 + tangent * tangent)


def waves_rate(xp, t, q, k):
    v29, v30 = nodes_along(xp, 4, t, q, k)
    v1 = q * t
    v4 = xp.minimum(1.5707963267948966, 8.0 / xp.maximum(v1, 1e-300))
    v8, v9 = weighted_along(xp, 1.0 + k, t, q, k)
    v10 = v8 * v4
    v12 = v1 * xp.cos(v10)
    v16 = v10 > 0.0
    v17 = xp.where(v16, v10, 1.0)
    v19 = v17 > 0.0
    v24 = xp.where(v16, xp.sin(v17) / xp.where(v19, xp.where(v19, v17, 1.0), 1.0), 1.0) ** k
    v28 = 1.5707963267948966 - v4
    v32 = v4 + v29 * v28
    v34 = v1 * xp.cos(v32)
    v41 = v28 * xp.sum(v30 * (tilted(xp, v34, xp.tan(0.5 * v34)) * xp.sin(v32) ** k), axis=0)
    v42 = v4 * v4 ** k * xp.sum(v9 * (tilted(xp, v12, xp.tan(0.5 * v12)) * v24), axis=0) + v41
    return q * v42
