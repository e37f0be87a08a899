"""Formulas of axicontact._runtime.shapes.powers over an array library `xp`."""

from ....._runtime.steps import nodes_along


def log_ratio(xp, x, y):
    v2 = (x - y) / y
    return xp.where(xp.isfinite(v2), xp.log1p(v2), xp.log(x) - xp.log(y))


def weight(xp, s):
    return 2.0 * s / xp.sqrt(-xp.expm1(-2.0 * s * s))


def fallen_pressure(xp, depth, n):
    v30, v31 = nodes_along(xp, 1, depth, n)
    v1 = depth > 0.0
    v2 = xp.where(v1, depth, 1.0)
    v3 = n > 1.0
    v10 = v2 - 42.0 / xp.maximum(xp.absolute(xp.where(v3, n, 2.0 * 1.0) - 1.0), 0.001)
    v11 = xp.maximum(v10, 0.0)
    v12 = v11 > 0.0
    v22 = v2 - 42.0 / xp.maximum(xp.absolute(xp.where(v3, 0.5 * 1.0, n) - 1.0), 0.001)
    v24 = v2 - xp.maximum(v22, 0.0)
    v25 = v24 > 0.0
    v16 = xp.sqrt(v2) - xp.where(v12, xp.sqrt(xp.where(v12, v11, 1.0)), 0.0)
    v29 = xp.where(v3, v16, xp.where(v25, xp.sqrt(xp.where(v25, v24, 1.0)), 0.0))
    v32 = v30 * v29
    v36 = xp.where(v3, n, 2.0 * 1.0)
    v41 = xp.where(v3, 0.5 * 1.0, n)
    v44 = -xp.absolute(n - 1.0) * xp.where(v3, v32 * (2.0 * xp.sqrt(v2) - v32), v32 * v32)
    v46 = xp.where(v3, n, 2.0 * 1.0)
    v50 = xp.where(v3, 0.5 * 1.0, n)
    v53 = xp.exp(v44) * weight(xp, xp.where(v3, xp.maximum(xp.sqrt(v2) - v32, 0.0), v32))
    return xp.where(v1, v29 * xp.sum(v31 * v53, axis=0), 0.0)


def power_pressure(xp, r, a, n):
    v1 = r > 0.0
    v2 = xp.where(v1, r, 1.0)
    v3 = n > 1.0
    v4 = xp.where(v3, n, 2.0 * 1.0)
    v10 = xp.where(v3, 1.0, (v2 / a) ** xp.where(v3, 0.5 * 1.0, n) * (a / v2))
    v14 = n > 1.0
    v19 = xp.where(v14, 0.5 * 1.0, n)
    v20 = xp.where(v14, 1.0 / xp.absolute(xp.where(v14, n, 2.0 * 1.0) - 1.0), xp.inf)
    return xp.where(v1, v10 * fallen_pressure(xp, log_ratio(xp, a, v2), n), v20)


def power_displacement(xp, r, a, n):
    v12, v13 = nodes_along(xp, 1, r, a, n)
    v1 = a > 0.0
    v2 = xp.where(v1, a, 1.0)
    v4 = 42.0 / (n + 1.0)
    v6 = xp.sqrt(log_ratio(xp, r, v2))
    v11 = v4 / (xp.sqrt(v6 * v6 + v4) + v6)
    v14 = v12 * v11
    v18 = v14 * (2.0 * v6 + v14)
    v22 = v6 + v14
    v28 = xp.arctan2(v2 / r * xp.exp(-v18), xp.sqrt(-xp.expm1(-2.0 * v22 * v22)))
    v36 = n * (v11 * xp.sum(v13 * (v28 * xp.exp(-n * v18) * 2.0 * v22), axis=0))
    return xp.where(v1, v36, 0.0)


def power_punches(xp, r, a, n):
    v11, v12 = nodes_along(xp, 1, r, a, n)
    v2 = n + 1.0
    v3 = 42.0 / v2
    v5 = xp.sqrt(log_ratio(xp, r, a))
    v10 = v3 / (xp.sqrt(v5 * v5 + v3) + v5)
    v13 = v11 * v10
    v22 = xp.exp(-v2 * v13 * (2.0 * v5 + v13)) * weight(xp, v5 + v13)
    return a / r * (v10 * xp.sum(v12 * v22, axis=0))


def power_strips(xp, x, a, n):
    v15, v16 = nodes_along(xp, 1, x, a, n)
    v1 = a > 0.0
    v2 = xp.where(v1, a, 1.0)
    v6 = n + 2.0
    v7 = 42.0 / v6
    v9 = xp.sqrt(log_ratio(xp, x, v2))
    v14 = v7 / (xp.sqrt(v9 * v9 + v7) + v9)
    v17 = v15 * v14
    v24 = v9 + v17
    v26 = xp.exp(-v6 * v17 * (2.0 * v9 + v17)) * weight(xp, v24)
    v34 = v14 * xp.sum(v16 * (v26 / (1.0 + xp.sqrt(-xp.expm1(-2.0 * v24 * v24)))), axis=0)
    return xp.where(v1, 1.0 + n * (v2 / x) ** 2.0 * v34, 1.0) / x
