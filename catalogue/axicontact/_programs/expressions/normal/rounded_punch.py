"""Formulas of axicontact.normal.rounded_punch over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.special import arctan_gap
from ...._programs.expressions._runtime.special import root_gap
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def depth(xp, a, R, b):
    return b / R * a * root_gap(xp, a, b)


def force(xp, a, R, b, E_star):
    v8 = (a - b) * (a + b)
    return E_star / R * (b * a ** 2.0 * root_gap(xp, a, b) + v8 * xp.sqrt(v8) / 3.0)


def slope_beyond(xp, t, root, R, b):
    return 2.0 * root / R - b / R * xp.arctan2(root, b)


def pressure(xp, r, a, R, b, E_star):
    v25, v26 = nodes_along(xp, 1, r, a, R, b, E_star)
    v1 = a >= b
    v2 = xp.where(v1, a, 2.0 * b)
    v3 = r < v2
    v4 = xp.where(v3, r, 0.5 * v2)
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
    v58 = v24 * xp.sum(v26 * (slope_beyond(xp, v54, v51, R, b) * v51 / v54), axis=0)
    v62 = xp.where(v3, 2.0 * v2, r)
    v64 = xp.where(v1, 0.5 * b, a)
    v63 = xp.where(v3, E_star / 3.141592653589793 * xp.where(v10, v58, 0.0), 0.0)
    return xp.where(v1, v63, xp.nan)


def profile(xp, r, R, b):
    v1 = r < b
    v2 = xp.where(v1, r, 0.5 * b)
    return xp.where(v1, 0.0, (xp.where(v1, 2.0 * b, r) - b) ** 2.0 / (2.0 * R))


def displacement(xp, r, a, R, b):
    v14, v15 = nodes_along(xp, 1, r, a, R, b)
    v1 = a >= b
    v2 = xp.where(v1, a, 2.0 * b)
    v3 = r > v2
    v4 = xp.where(v3, r, 2.0 * v2)
    v5 = v2 > b
    v6 = xp.where(v5, v2, 2.0 * b)
    v7 = difference_root(xp, v4, b)
    v10 = difference_root(xp, v6, b) / difference_root(xp, v4, v6)
    v11 = b / v4
    v13 = xp.arcsinh(v10 / v11)
    v16 = v14 * v13
    v27 = 0.0 - xp.expm1(-2.0 * v13)
    v28 = v27 > 0.0
    v24 = xp.exp(-v16) * (0.0 - xp.expm1(-2.0 * (v13 - v16)))
    v32 = v10 * (v24 / xp.where(v28, xp.where(v28, v27, 1.0), xp.inf))
    v34 = v32 * v32
    v36 = xp.sqrt(1.0 + v34)
    v37 = v7 * v32 / v36
    v40 = xp.sqrt(b * b + v37 * v37)
    v46 = slope_beyond(xp, v40, v37, R, b) * v37 / v40 * xp.arctan2(v40, v7 / v36)
    v56 = xp.where(v5, 0.5 * b, v2)
    v55 = v7 * (v13 * xp.sum(v15 * (v46 * (xp.sqrt(v11 * v11 + v34) / (v36 * v36 * v36))), axis=0))
    v62 = depth(xp, v2, R, b) - profile(xp, xp.where(v3, 0.5 * v2, r), R, b)
    v64 = xp.where(v1, 0.5 * b, a)
    return xp.where(v1, xp.where(v3, 0.6366197723675814 * xp.where(v5, v55, 0.0), v62), xp.nan)


def stiffness(xp, a, E_star):
    return 2.0 * E_star * a


def mean_pressure(xp, a, R, b, E_star):
    v7 = (a - b) * (a + b)
    v13 = b * root_gap(xp, a, b) + v7 * xp.sqrt(v7) / (3.0 * a ** 2.0)
    return E_star / (3.141592653589793 * R) * v13


def depth_at(xp, a, root, R, b):
    return b / R * a * arctan_gap(xp, root / b)


def radius_from_depth(xp, d, R, b):
    v4 = xp.log(d / depth_at(xp, b * 1.4142135623730951, b, R, b))
    v6 = 1.1666666666666667 * (v4 - 0.09349034308733897)
    v8 = 1.75 * (v4 - 1.1924061679544706)
    v17 = xp.exp((xp.maximum(v6, v8) + xp.log1p(xp.exp(-xp.absolute(v6 - v8)))) / 3.5)
    v20 = 1.0 - 1.0 / (1.0 + v17)
    v27 = (((-0.6001833 * v20 + 1.077435) * v20 + -0.6900221) * v20 + 0.3108858) * v20
    v34 = (((v27 + -0.0720644) * v20 + -0.02265958) * v20 + -0.002147146) * v20 + 0.9999152

    def f35(v36):
        v40 = b * xp.sqrt(1.0 + v36 * v36)
        v41 = b * v36
        v42 = depth_at(xp, v40, v41, R, b)
        return (v42, v41 * v41 / v40 * slope_beyond(xp, v40, v41, R, b) / v42)
    v48 = newton(xp, f35, d, v17 * v34, xp.inf, 2.0, 4.0)
    return b * xp.sqrt(1.0 + v48 * v48)


def force_at(xp, a, root, R, b, E_star):
    v11 = E_star / R * (root * root ** 2.0 / 3.0 + b * a ** 2.0 * arctan_gap(xp, root / b))
    return v11


def radius_from_force(xp, F, R, b, E_star):
    v4 = xp.log(F / force_at(xp, b * 1.4142135623730951, b, R, b, E_star))
    v6 = 2.0 * (v4 - -0.1343317127952918)
    v8 = 2.0 * (v4 - 0.559044196036465)
    v17 = xp.exp((xp.maximum(v6, v8) + xp.log1p(xp.exp(-xp.absolute(v6 - v8)))) / 6.0)
    v20 = 1.0 - 1.0 / (1.0 + v17)
    v28 = (((0.2138332 * v20 + -1.105184) * v20 + 2.059576) * v20 + -1.571447) * v20 + 0.3231377

    def f35(v36):
        v40 = b * xp.sqrt(1.0 + v36 * v36)
        v41 = b * v36
        v42 = force_at(xp, v40, v41, R, b, E_star)
        return (v42, 2.0 * E_star * v41 * v41 * slope_beyond(xp, v40, v41, R, b) / v42)
    v35 = v17 * (((v28 * v20 + -0.1218583) * v20 + 0.003191853) * v20 + 0.9634905)
    v49 = newton(xp, f35, F, v35, xp.inf, 3.0, 4.0)
    return b * xp.sqrt(1.0 + v49 * v49)


def force_from_depth(xp, d, R, b, E_star):
    v4 = xp.log(d / depth_at(xp, b * 1.4142135623730951, b, R, b))
    v6 = 1.1666666666666667 * (v4 - 0.09349034308733897)
    v8 = 1.75 * (v4 - 1.1924061679544706)
    v17 = xp.exp((xp.maximum(v6, v8) + xp.log1p(xp.exp(-xp.absolute(v6 - v8)))) / 3.5)
    v20 = 1.0 - 1.0 / (1.0 + v17)
    v27 = (((-0.6001833 * v20 + 1.077435) * v20 + -0.6900221) * v20 + 0.3108858) * v20
    v34 = (((v27 + -0.0720644) * v20 + -0.02265958) * v20 + -0.002147146) * v20 + 0.9999152

    def f35(v36):
        v40 = b * xp.sqrt(1.0 + v36 * v36)
        v41 = b * v36
        v42 = depth_at(xp, v40, v41, R, b)
        return (v42, v41 * v41 / v40 * slope_beyond(xp, v40, v41, R, b) / v42)
    v48 = newton(xp, f35, d, v17 * v34, xp.inf, 2.0, 4.0)
    v52 = b * xp.sqrt(1.0 + v48 * v48)
    v53 = b * v48
    v62 = 2.0 * E_star * v52 * (d - depth_at(xp, v52, v53, R, b))
    v64 = force_at(xp, v52, v53, R, b, E_star) + xp.where((v52 > 0.0) & (v52 < xp.inf), v62, 0.0)
    return v64


def depth_from_force(xp, F, R, b, E_star):
    v4 = xp.log(F / force_at(xp, b * 1.4142135623730951, b, R, b, E_star))
    v6 = 2.0 * (v4 - -0.1343317127952918)
    v8 = 2.0 * (v4 - 0.559044196036465)
    v17 = xp.exp((xp.maximum(v6, v8) + xp.log1p(xp.exp(-xp.absolute(v6 - v8)))) / 6.0)
    v20 = 1.0 - 1.0 / (1.0 + v17)
    v28 = (((0.2138332 * v20 + -1.105184) * v20 + 2.059576) * v20 + -1.571447) * v20 + 0.3231377

    def f35(v36):
        v40 = b * xp.sqrt(1.0 + v36 * v36)
        v41 = b * v36
        v42 = force_at(xp, v40, v41, R, b, E_star)
        return (v42, 2.0 * E_star * v41 * v41 * slope_beyond(xp, v40, v41, R, b) / v42)
    v35 = v17 * (((v28 * v20 + -0.1218583) * v20 + 0.003191853) * v20 + 0.9634905)
    v49 = newton(xp, f35, F, v35, xp.inf, 3.0, 4.0)
    v53 = b * xp.sqrt(1.0 + v49 * v49)
    v54 = b * v49
    v63 = (F - force_at(xp, v53, v54, R, b, E_star)) / (2.0 * E_star * v53)
    return depth_at(xp, v53, v54, R, b) + xp.where((v53 > 0.0) & (v53 < xp.inf), v63, 0.0)


def energy(xp, a, R, b, E_star):
    v11, v12 = nodes_along(xp, 1, a, R, b, E_star)
    v1 = a >= b
    v2 = xp.where(v1, a, 2.0 * b)
    v3 = depth(xp, v2, R, b)
    v6 = v2 > b
    v7 = xp.where(v6, v2, 2.0 * b)
    v8 = difference_root(xp, v7, b)
    v10 = xp.arcsinh(v8 / b)
    v13 = v11 * v10
    v25 = 0.0 - xp.expm1(-2.0 * v10)
    v26 = v25 > 0.0
    v22 = xp.exp(-v13) * (0.0 - xp.expm1(-2.0 * (v10 - v13)))
    v30 = v8 * (v22 / xp.where(v26, xp.where(v26, v25, 1.0), xp.inf))
    v35 = depth(xp, v7, R, b) - depth_at(xp, xp.sqrt(b * b + v30 * v30), v30, R, b)
    v39 = xp.where(v6, 0.5 * b, v2)
    v43 = xp.where(v1, 0.5 * b, a)
    v42 = E_star * (b * v3 * v3 + xp.where(v6, v10 * xp.sum(v12 * (v35 * v35 * v30), axis=0), 0.0))
    return xp.where(v1, v42, xp.nan)


def load_within(xp, r, a, R, b, E_star):
    v31, v32 = nodes_along(xp, 1, r, a, R, b, E_star)
    v1 = a >= b
    v2 = xp.where(v1, a, 2.0 * b)
    v3 = r > b
    v8 = xp.where(v3, 0.5 * b, r)
    v7 = force(xp, xp.maximum(xp.minimum(xp.where(v3, r, 2.0 * b), v2), b), R, b, E_star)
    v13 = xp.where(r == b, b * 1.0000000000000002, r)
    v14 = xp.maximum(v13, b)
    v15 = v2 > v14
    v16 = xp.where(v15, v2, 2.0 * v14)
    v18 = v13 < b
    v19 = xp.where(v18, v13, 0.5 * b)
    v22 = difference_root(xp, v16, xp.where(v18, 2.0 * b, v13))
    v23 = xp.where(v18, difference_root(xp, v16, b), v22)
    v30 = xp.arcsinh(v23 / xp.sqrt(xp.absolute(v13 - b) * (v13 + b)))
    v33 = v31 * v30
    v37 = xp.exp(-v33)
    v38 = xp.where(v18, v13, 0.5 * b)
    v39 = xp.where(v18, 2.0 * b, v13)
    v40 = xp.where(v18, 0.0, 1.0)
    v41 = 2.0 * v40
    v42 = 1.0 - v41
    v45 = xp.expm1(-2.0 * (v30 - v33))
    v50 = xp.expm1(-2.0 * v30)
    v52 = v41 - v42 * v50
    v53 = v52 > 0.0
    v56 = v37 * (v41 - v42 * v45) / xp.where(v53, xp.where(v53, v52, 1.0), xp.inf)
    v57 = difference_root(xp, v16, b) * v56
    v60 = xp.sqrt(b * b + v57 * v57)
    v66 = 2.0 * (1.0 - v40)
    v67 = 1.0 - v66
    v72 = v66 - v67 * v50
    v73 = v72 > 0.0
    v76 = v37 * (v66 - v67 * v45) / xp.where(v73, xp.where(v73, v72, 1.0), xp.inf)
    v77 = difference_root(xp, v16, v13) * v76
    v80 = slope_beyond(xp, v60, v57, R, b) * (v57 / v60) * (v77 / (v60 + v77))
    v83 = xp.where(v15, 0.5 * v14, v2)
    v85 = 2.0 * E_star * xp.where(v15, v13 * v13 * (v30 * xp.sum(v32 * v80, axis=0)), 0.0)
    v87 = xp.where(v1, 0.5 * b, a)
    return xp.where(v1, xp.where(v3, v7, 0.0) + v85, xp.nan)
