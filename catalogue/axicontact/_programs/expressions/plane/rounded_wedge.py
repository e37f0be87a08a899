"""Formulas of axicontact.plane.rounded_wedge over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def profile(xp, x, theta, b):
    v1 = x > b
    v12 = xp.tan(theta) / (2.0 * b) * xp.where(v1, 0.5 * b, x) ** 2.0
    return xp.where(v1, xp.tan(theta) * (xp.where(v1, x, 2.0 * b) - b / 2.0), v12)


def load(xp, a, theta, b, E_star):
    v1 = a < b
    v10 = xp.where(v1, 2.0 * b, a)
    v16 = xp.sqrt((v10 - b) * (v10 + b))
    v24 = E_star * xp.tan(theta) * (v16 + v10 ** 2.0 * xp.arctan(b / v16) / b) / 2.0
    v9 = 3.141592653589793 * E_star * xp.tan(theta) / (4.0 * b) * xp.where(v1, a, 0.5 * b) ** 2.0
    return xp.where(v1, v9, v24)


def growth_beyond(xp, t, root, theta, b):
    return xp.tan(theta) / b * t * xp.arctan(b / root)


def pressure(xp, x, a, theta, b, E_star):
    v37, v38 = nodes_along(xp, 1, x, a, theta, b, E_star)
    v1 = x < a
    v2 = xp.where(v1, x, 0.5 * a)
    v3 = xp.minimum(a, b)
    v4 = v2 < v3
    v5 = xp.where(v4, v2, 0.5 * v3)
    v15 = xp.where(v4, 2.0 * v3, v2)
    v20 = xp.where(v2 == b, b * 1.0000000000000002, v2)
    v21 = xp.maximum(v20, b)
    v22 = a > v21
    v23 = xp.where(v22, a, 2.0 * v21)
    v24 = v20 < b
    v25 = xp.where(v24, v20, 0.5 * b)
    v28 = difference_root(xp, v23, xp.where(v24, 2.0 * b, v20))
    v29 = xp.where(v24, difference_root(xp, v23, b), v28)
    v36 = xp.arcsinh(v29 / xp.sqrt(xp.absolute(v20 - b) * (v20 + b)))
    v39 = v37 * v36
    v44 = xp.where(v24, v20, 0.5 * b)
    v45 = xp.where(v24, 2.0 * b, v20)
    v47 = 2.0 * xp.where(v24, 0.0, 1.0)
    v48 = 1.0 - v47
    v58 = v47 - v48 * xp.expm1(-2.0 * v36)
    v59 = v58 > 0.0
    v54 = xp.exp(-v39) * (v47 - v48 * xp.expm1(-2.0 * (v36 - v39)))
    v63 = difference_root(xp, v23, b) * (v54 / xp.where(v59, xp.where(v59, v58, 1.0), xp.inf))
    v66 = xp.sqrt(b * b + v63 * v63)
    v71 = xp.where(v22, 0.5 * v21, a)
    v70 = v36 * xp.sum(v38 * (growth_beyond(xp, v66, v63, theta, b) * v63 / v66), axis=0)
    v16 = xp.where(v4, E_star * xp.tan(theta) / (2.0 * b) * xp.sqrt((v3 - v5) * (v3 + v5)), 0.0)
    v75 = xp.where(v1, 2.0 * a, x)
    return xp.where(v1, v16 + E_star / 3.141592653589793 * xp.where(v22, v70, 0.0), 0.0)


def profile_slope(xp, x, theta, b):
    v1 = x > b
    v2 = xp.where(v1, x, 2.0 * b)
    return xp.where(v1, xp.tan(theta), xp.tan(theta) / b * xp.where(v1, 0.5 * b, x))


def slope(xp, x, a, theta, b):
    v26, v27 = nodes_along(xp, 1, x, a, theta, b)
    v1 = x > a
    v2 = xp.where(v1, x, 2.0 * a)
    v5 = xp.minimum(a, b)
    v15 = a > b
    v16 = xp.where(v15, a, 2.0 * b)
    v17 = difference_root(xp, v16, b)
    v19 = v17 / difference_root(xp, v2, v16)
    v20 = b / v2
    v22 = xp.arcsinh(v19 / v20)
    v25 = xp.minimum(v22, 42.0 + xp.arcsinh(v19))
    v28 = v26 * v25
    v39 = 0.0 - xp.expm1(-2.0 * v22)
    v40 = v39 > 0.0
    v36 = xp.exp(-v28) * (0.0 - xp.expm1(-2.0 * (v22 - v28)))
    v43 = v36 / xp.where(v40, xp.where(v40, v39, 1.0), xp.inf)
    v48 = v19 * v43
    v50 = 1.0 + v48 * v48
    v53 = v17 * v43 * (xp.sqrt(1.0 + v19 * v19) / xp.sqrt(v50))
    v56 = xp.sqrt(b * b + v53 * v53)
    v65 = v53 / v56 * (xp.sqrt((v20 / v19) ** 2.0 + v43 * v43) / v50)
    v69 = xp.where(v15, 0.5 * b, a)
    v68 = v19 * (v25 * xp.sum(v27 * (growth_beyond(xp, v56, v53, theta, b) * v65), axis=0))
    v14 = -xp.tan(theta) * v5 ** 2.0 / (b * (xp.sqrt((v2 - v5) * (v5 + v2)) + v2))
    v75 = -profile_slope(xp, xp.where(v1, 0.5 * a, x), theta, b)
    return xp.where(v1, v14 - 0.6366197723675814 * xp.where(v15, v68, 0.0), v75)


def depth(xp, L, a, theta, b):
    v35, v36 = nodes_along(xp, 1, L, a, theta, b)
    v1 = a <= L
    v2 = xp.where(v1, a, 0.5 * L)
    v3 = v2 > 0.0
    v4 = xp.where(v3, v2, 1.0)
    v5 = v4 < L
    v6 = xp.where(v5, v4, 0.5 * L)
    v10 = xp.minimum(v6, b)
    v13 = L - v10
    v16 = xp.sqrt(v13 * (v10 + L))
    v22 = L / (v16 + L) + xp.log1p((v13 + v16) / v10)
    v24 = v6 > b
    v25 = xp.where(v24, v6, 2.0 * b)
    v26 = difference_root(xp, v25, b)
    v27 = difference_root(xp, L, v25)
    v28 = v26 / v27
    v29 = b / L
    v31 = xp.arcsinh(v28 / v29)
    v34 = xp.minimum(v31, 42.0 + xp.arcsinh(v28))
    v37 = v35 * v34
    v48 = 0.0 - xp.expm1(-2.0 * v31)
    v49 = v48 > 0.0
    v45 = xp.exp(-v37) * (0.0 - xp.expm1(-2.0 * (v31 - v37)))
    v52 = v45 / xp.where(v49, xp.where(v49, v48, 1.0), xp.inf)
    v57 = v28 * v52
    v59 = 1.0 + v57 * v57
    v61 = xp.sqrt(1.0 + v28 * v28) / xp.sqrt(v59)
    v62 = v26 * v52 * v61
    v65 = xp.sqrt(b * b + v62 * v62)
    v74 = v62 / v65 * (xp.sqrt((v29 / v28) ** 2.0 + v52 * v52) / v59)
    v80 = growth_beyond(xp, v65, v62, theta, b) * v74 * v61 * xp.arcsinh(v27 * v61 / v65)
    v83 = xp.where(v24, 0.5 * b, v6)
    v85 = 0.6366197723675814 * xp.where(v24, v26 * (v34 * xp.sum(v36 * v80, axis=0)), 0.0)
    v86 = xp.tan(theta) / (2.0 * b) * v10 ** 2.0 * v22 + v85
    v91 = xp.where(v1, 2.0 * L, a)
    v90 = xp.where(v3, xp.where(v5, v86, profile(xp, xp.where(v5, 2.0 * L, v4), theta, b)), 0.0)
    return xp.where(v1, v90, xp.nan)


def growth(xp, t, theta, b):
    return 3.141592653589793 * xp.tan(theta) / (2.0 * b) * t


def half_width_from_load(xp, P, theta, b, E_star):

    def f1(v2):
        v3 = load(xp, v2, theta, b, E_star)
        v5 = v2 < b
        v8 = xp.where(v5, 2.0 * b, v2)
        v13 = growth_beyond(xp, v8, xp.sqrt((v8 - b) * (v8 + b)), theta, b)
        v16 = E_star * v2 * xp.where(v5, growth(xp, xp.where(v5, v2, 0.5 * b), theta, b), v13) / v3
        return (v3, v16)
    return newton(xp, f1, P, 0.99 * b, xp.inf, 1.0, 2.0)
