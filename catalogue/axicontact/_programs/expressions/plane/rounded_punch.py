"""Formulas of axicontact.plane.rounded_punch over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def profile(xp, x, R, b):
    v1 = x > b
    v7 = xp.where(v1, 0.5 * b, x)
    return xp.where(v1, (xp.where(v1, x, 2.0 * b) - b) ** 2.0 / (2.0 * R), 0.0)


def growth_beyond(xp, t, root, R, b):
    return t * xp.arctan(root / b) / R


def load_at(xp, root, R, b, E_star):
    v4, v5 = nodes_along(xp, 1, root, R, b, E_star)
    v2 = xp.arcsinh(root / b)
    v3 = xp.minimum(v2, 42.0)
    v6 = v4 * v3
    v17 = 0.0 - xp.expm1(-2.0 * v2)
    v18 = v17 > 0.0
    v14 = xp.exp(-v6) * (0.0 - xp.expm1(-2.0 * (v2 - v6)))
    v22 = root * (v14 / xp.where(v18, xp.where(v18, v17, 1.0), xp.inf))
    v27 = growth_beyond(xp, xp.sqrt(b * b + v22 * v22), v22, R, b) * v22
    return E_star * (v3 * xp.sum(v5 * v27, axis=0))


def load_below(xp, a, R, b, E_star):
    return load_at(xp, xp.sqrt((a - b) * (a + b)), R, b, E_star)


def load_above(xp, a, R, b, E_star):
    v7 = xp.sqrt((a - b) * (a + b))
    return E_star / (2.0 * R) * (a ** 2.0 * xp.arctan(v7 / b) - b * v7)


def load(xp, a, R, b, E_star):
    v1 = 2.0 * b
    v2 = a < v1
    v6 = load_above(xp, xp.where(v2, 2.0 * v1, a), R, b, E_star)
    return xp.where(v2, load_below(xp, xp.where(v2, a, 0.5 * v1), R, b, E_star), v6)


def pressure(xp, x, a, R, b, E_star):
    v25, v26 = nodes_along(xp, 1, x, a, R, b, E_star)
    v1 = a >= b
    v2 = xp.where(v1, a, 2.0 * b)
    v3 = x < v2
    v4 = xp.where(v3, x, 0.5 * v2)
    v8 = xp.where(v4 == b, b * 1.0000000000000002, v4)
    v9 = xp.maximum(v8, b)
    v10 = v2 > v9
    v11 = xp.where(v10, v2, 2.0 * v9)
    v12 = v8 < b
    v13 = xp.where(v12, v8, 0.5 * b)
    v16 = difference_root(xp, v11, xp.where(v12, 2.0 * b, v8))
    v17 = xp.where(v12, difference_root(xp, v11, b), v16)
    v24 = xp.arcsinh(v17 / xp.sqrt(xp.absolute(v8 - b) * (v8 + b)))
    v27 = v25 * v24
    v32 = xp.where(v12, v8, 0.5 * b)
    v33 = xp.where(v12, 2.0 * b, v8)
    v35 = 2.0 * xp.where(v12, 0.0, 1.0)
    v36 = 1.0 - v35
    v46 = v35 - v36 * xp.expm1(-2.0 * v24)
    v47 = v46 > 0.0
    v42 = xp.exp(-v27) * (v35 - v36 * xp.expm1(-2.0 * (v24 - v27)))
    v51 = difference_root(xp, v11, b) * (v42 / xp.where(v47, xp.where(v47, v46, 1.0), xp.inf))
    v54 = xp.sqrt(b * b + v51 * v51)
    v59 = xp.where(v10, 0.5 * v9, v2)
    v58 = v24 * xp.sum(v26 * (growth_beyond(xp, v54, v51, R, b) * v51 / v54), axis=0)
    v62 = xp.where(v3, 2.0 * v2, x)
    v64 = xp.where(v1, 0.5 * b, a)
    v63 = xp.where(v3, E_star / 3.141592653589793 * xp.where(v10, v58, 0.0), 0.0)
    return xp.where(v1, v63, xp.nan)


def profile_slope(xp, x, R, b):
    v1 = x > b
    v5 = xp.where(v1, 0.5 * b, x)
    return xp.where(v1, (xp.where(v1, x, 2.0 * b) - b) / R, 0.0)


def slope(xp, x, a, R, b):
    v16, v17 = nodes_along(xp, 1, x, a, R, b)
    v1 = a >= b
    v2 = xp.where(v1, a, 2.0 * b)
    v3 = x > v2
    v4 = xp.where(v3, x, 2.0 * v2)
    v5 = v2 > b
    v6 = xp.where(v5, v2, 2.0 * b)
    v7 = difference_root(xp, v6, b)
    v9 = v7 / difference_root(xp, v4, v6)
    v10 = b / v4
    v12 = xp.arcsinh(v9 / v10)
    v15 = xp.minimum(v12, 42.0 + xp.arcsinh(v9))
    v18 = v16 * v15
    v29 = 0.0 - xp.expm1(-2.0 * v12)
    v30 = v29 > 0.0
    v26 = xp.exp(-v18) * (0.0 - xp.expm1(-2.0 * (v12 - v18)))
    v33 = v26 / xp.where(v30, xp.where(v30, v29, 1.0), xp.inf)
    v38 = v9 * v33
    v40 = 1.0 + v38 * v38
    v43 = v7 * v33 * (xp.sqrt(1.0 + v9 * v9) / xp.sqrt(v40))
    v46 = xp.sqrt(b * b + v43 * v43)
    v55 = v43 / v46 * (xp.sqrt((v10 / v9) ** 2.0 + v33 * v33) / v40)
    v59 = xp.where(v5, 0.5 * b, v2)
    v60 = xp.where(v5, v9 * (v15 * xp.sum(v17 * (growth_beyond(xp, v46, v43, R, b) * v55), axis=0)), 0.0)
    v64 = -profile_slope(xp, xp.where(v3, 0.5 * v2, x), R, b)
    v66 = xp.where(v1, 0.5 * b, a)
    return xp.where(v1, xp.where(v3, -0.6366197723675814 * v60, v64), xp.nan)


def depth(xp, L, a, R, b):
    v18, v19 = nodes_along(xp, 1, L, a, R, b)
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
    v63 = growth_beyond(xp, v48, v45, R, b) * v57 * v44 * xp.arcsinh(v10 * v44 / v48)
    v66 = xp.where(v7, 0.5 * b, v6)
    v68 = 0.6366197723675814 * xp.where(v7, v9 * (v17 * xp.sum(v19 * v63, axis=0)), 0.0)
    v72 = xp.where(v3, 2.0 * L, v2)
    v74 = xp.where(v1, 0.5 * b, a)
    v73 = xp.where(v3, xp.where(v5, v68, profile(xp, xp.where(v5, 2.0 * L, v4), R, b)), xp.nan)
    return xp.where(v1, v73, xp.nan)


def half_width_from_load(xp, P, R, b, E_star):

    def f0(v1):
        v2 = b * v1
        v3 = load_at(xp, v2, R, b, E_star)
        v9 = b * xp.sqrt(1.0 + v1 * v1)
        return (v3, E_star * v2 * v2 / v9 * growth_beyond(xp, v9, v2, R, b) / v3)
    v14 = newton(xp, f0, P, 1.0, xp.inf, 2.0, 3.0)
    return b * xp.sqrt(1.0 + v14 * v14)
