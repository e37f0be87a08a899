"""Formulas of axicontact.plane.truncated_wedge over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._runtime.steps import nodes_along


def profile(xp, x, theta, b):
    v1 = x > b
    v6 = xp.where(v1, 0.5 * b, x)
    return xp.where(v1, xp.tan(theta) * (xp.where(v1, x, 2.0 * b) - b), 0.0)


def load(xp, a, theta, b, E_star):
    return E_star * xp.tan(theta) * xp.sqrt((a - b) * (a + b))


def pressure(xp, x, a, theta, b, E_star):
    v1 = a >= b
    v2 = xp.where(v1, a, 2.0 * b)
    v3 = x < v2
    v4 = xp.where(v3, x, 0.5 * v2)
    v5 = v4 < b
    v6 = xp.where(v5, v4, 0.5 * b)
    v19 = xp.arcsinh(xp.sqrt((v2 - b) * (v2 + b)) / xp.sqrt((b - v6) * (v6 + b)))
    v21 = xp.where(v5, 2.0 * b, v4)
    v34 = xp.arcsinh(xp.sqrt((v2 - v21) * (v2 + v21)) / xp.sqrt((v21 - b) * (v21 + b)))
    v35 = E_star * xp.tan(theta) / 3.141592653589793 * v34
    v37 = xp.where(v3, 2.0 * v2, x)
    v39 = xp.where(v1, 0.5 * b, a)
    v38 = xp.where(v3, xp.where(v5, E_star * xp.tan(theta) / 3.141592653589793 * v19, v35), 0.0)
    return xp.where(v1, v38, xp.nan)


def slope(xp, x, a, theta, b):
    v1 = a >= b
    v2 = xp.where(v1, a, 2.0 * b)
    v3 = x > v2
    v4 = xp.where(v3, x, 2.0 * v2)
    v16 = xp.arctan2(xp.sqrt((v2 - b) * (v2 + b)), xp.sqrt((v4 - v2) * (v2 + v4)))
    v18 = xp.where(v3, 0.5 * v2, x)
    v19 = v18 > b
    v20 = xp.where(v19, v18, 2.0 * b)
    v22 = xp.where(v19, 0.5 * b, v18)
    v17 = -2.0 * xp.tan(theta) / 3.141592653589793 * v16
    v26 = xp.where(v1, 0.5 * b, a)
    return xp.where(v1, xp.where(v3, v17, -xp.where(v19, xp.tan(theta), 0.0)), xp.nan)


def growth_beyond(xp, t, root, theta, b):
    return xp.tan(theta) * xp.sqrt(root ** 2.0 + b ** 2.0) / root


def depth_below(xp, L, a, theta, b):
    v18, v19 = nodes_along(xp, 1, L, a, theta, b)
    v1 = a >= b
    v2 = xp.where(v1, a, 2.0 * b)
    v3 = v2 <= L
    v4 = xp.where(v3, v2, 0.5 * L)
    v5 = v4 < L
    v6 = xp.where(v5, v4, 0.5 * L)
    v7 = v6 > b
    v8 = xp.where(v7, v6, 2.0 * b)
    v9 = difference_root(xp, v8, b)
    v10 = difference_root(xp, L, v8)
    v11 = v9 / v10
    v12 = b / L
    v14 = xp.arcsinh(v11 / v12)
    v17 = xp.minimum(v14, 42.0 + xp.arcsinh(v11))
    v20 = v18 * v17
    v31 = 0.0 - xp.expm1(-2.0 * v14)
    v32 = v31 > 0.0
    v28 = xp.exp(-v20) * (0.0 - xp.expm1(-2.0 * (v14 - v20)))
    v35 = v28 / xp.where(v32, xp.where(v32, v31, 1.0), xp.inf)
    v40 = v11 * v35
    v42 = 1.0 + v40 * v40
    v44 = xp.sqrt(1.0 + v11 * v11) / xp.sqrt(v42)
    v45 = v9 * v35 * v44
    v48 = xp.sqrt(b * b + v45 * v45)
    v57 = v45 / v48 * (xp.sqrt((v12 / v11) ** 2.0 + v35 * v35) / v42)
    v63 = growth_beyond(xp, v48, v45, theta, b) * v57 * v44 * xp.arcsinh(v10 * v44 / v48)
    v66 = xp.where(v7, 0.5 * b, v6)
    v68 = 0.6366197723675814 * xp.where(v7, v9 * (v17 * xp.sum(v19 * v63, axis=0)), 0.0)
    v72 = xp.where(v3, 2.0 * L, v2)
    v74 = xp.where(v1, 0.5 * b, a)
    v73 = xp.where(v3, xp.where(v5, v68, profile(xp, xp.where(v5, 2.0 * L, v4), theta, b)), xp.nan)
    return xp.where(v1, v73, xp.nan)


def depth_above(xp, L, a, theta, b):
    v1 = a >= b
    v2 = xp.where(v1, a, 2.0 * b)
    v3 = v2 <= L
    v4 = xp.where(v3, v2, 0.5 * L)
    v11 = xp.sqrt((L - v4) * (v4 + L))
    v17 = xp.sqrt((v4 - b) * (v4 + b))
    v22 = xp.arcsinh(v11 / v4) * v17 + L * xp.arctan(v17 / v11)
    v30 = xp.where(v3, 2.0 * L, v2)
    v29 = 2.0 * xp.tan(theta) / 3.141592653589793 * (v22 - b * xp.arctan(L * v17 / (b * v11)))
    v32 = xp.where(v1, 0.5 * b, a)
    return xp.where(v1, xp.where(v3, v29, xp.nan), xp.nan)


def depth(xp, L, a, theta, b):
    v1 = 128.0 * b
    v2 = a < v1
    v6 = depth_above(xp, L, xp.where(v2, 2.0 * v1, a), theta, b)
    return xp.where(v2, depth_below(xp, L, xp.where(v2, a, 0.5 * v1), theta, b), v6)


def half_width_from_load(xp, P, theta, b, E_star):
    return xp.sqrt(P ** 2.0 / (E_star ** 2.0 * xp.tan(theta) ** 2.0) + b ** 2.0)
