"""Formulas of axicontact.normal.ellipsoid over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.shapes.arcs import arc_strips
from ...._programs.expressions._runtime.special import tanh_gap
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def depth(xp, a, h, b):
    return h / b * a * (xp.log1p(2.0 * a / (b - a)) / 2.0)


def force(xp, a, h, b, E_star):
    v7 = xp.log1p(2.0 * a / (b - a)) / 2.0
    return E_star * h * (a ** 2.0 * v7 / b + b * tanh_gap(xp, v7, a / b))


def pressure(xp, r, a, h, b, E_star):
    v1 = a <= b
    v2 = xp.where(v1, a, 0.5 * b)
    v3 = r < v2
    v4 = xp.where(v3, r, 0.5 * v2)
    v16 = xp.arcsinh(xp.sqrt((v2 - v4) * (v2 + v4)) / xp.sqrt((b - v2) * (v2 + b)))
    v24 = v16 / xp.sqrt((b - v4) * (v4 + b)) + arc_strips(xp, v4, v2, b) / b
    v26 = xp.where(v3, 2.0 * v2, r)
    v28 = xp.where(v1, 2.0 * b, a)
    return xp.where(v1, xp.where(v3, E_star * h / 3.141592653589793 * v24, 0.0), xp.nan)


def slope(xp, t, root, h, b):
    return h / b * xp.arcsinh(t / root) + h * t / root ** 2.0


def profile(xp, r, h, b):
    v4 = r / b
    return h * r ** 2.0 / (b ** 2.0 * (xp.sqrt((1.0 - v4) * (v4 + 1.0)) + 1.0))


def displacement(xp, r, a, h, b):
    v11, v12 = nodes_along(xp, 1, r, a, h, b)
    v1 = a <= b
    v2 = xp.where(v1, a, 0.5 * b)
    v3 = r > v2
    v4 = xp.where(v3, r, 2.0 * v2)
    v5 = xp.minimum(v4, b)
    v6 = v2 < v5
    v7 = xp.where(v6, v2, 0.5 * v5)
    v9 = v7 / difference_root(xp, v5, v7)
    v10 = xp.arcsinh(v9)
    v13 = v11 * v10
    v23 = 0.0 - xp.expm1(-2.0 * v10)
    v24 = v23 > 0.0
    v20 = xp.exp(-v13) * (0.0 - xp.expm1(-2.0 * (v10 - v13)))
    v28 = v9 * (v20 / xp.where(v24, xp.where(v24, v23, 1.0), xp.inf))
    v31 = xp.sqrt(1.0 + v28 * v28)
    v33 = v5 * (v28 / v31)
    v36 = v5 / v31
    v37 = v36 * v36
    v40 = slope(xp, v33, xp.sqrt(difference_root(xp, b, v4) ** 2.0 + v37), h, b)
    v48 = v40 * xp.arctan2(v33, xp.sqrt(difference_root(xp, v4, b) ** 2.0 + v37)) * (v36 / v31)
    v50 = xp.where(v6, 2.0 * v5, v2)
    v52 = 0.6366197723675814 * xp.where(v6, v10 * xp.sum(v12 * v48, axis=0), xp.inf)
    v58 = xp.where(v1, 2.0 * b, a)
    v57 = xp.where(v3, v52, depth(xp, v2, h, b) - profile(xp, xp.where(v3, 0.5 * v2, r), h, b))
    return xp.where(v1, v57, xp.nan)


def stiffness(xp, a, E_star):
    return 2.0 * E_star * a


def mean_pressure(xp, a, h, b, E_star):
    v1 = a > 0.0
    v2 = xp.where(v1, a, 1.0)
    return xp.where(v1, force(xp, v2, h, b, E_star) / (3.141592653589793 * v2 ** 2.0), 0.0)


def depth_at(xp, a, root, h, b):
    return h / b * a * xp.arcsinh(a / root)


def radius_from_depth(xp, d, h, b):
    v5 = xp.log(d / depth_at(xp, b * 0.7615941559557649, b / 1.5430806348152437, h, b))
    v6 = v5 - 0.2723145953206591
    v7 = 1.875 * v6
    v8 = 3.75 * v6
    v17 = xp.exp((xp.maximum(v7, v8) + xp.log1p(xp.exp(-xp.absolute(v7 - v8)))) / 3.75)
    v20 = 1.0 - 1.0 / (1.0 + v17)
    v28 = (((25.07439 * v20 + -95.06062) * v20 + 137.5431) * v20 + -93.92268) * v20 + 30.18372

    def f35(v36):
        v38 = b * xp.tanh(v36)
        v40 = b / xp.cosh(v36)
        v41 = depth_at(xp, v38, v40, h, b)
        return (v41, v36 * v40 * v40 / b * slope(xp, v38, v40, h, b) / v41)
    v35 = v17 * (((v28 * v20 + -4.0282) * v20 + 0.208363) * v20 + 0.9983865)
    return b * xp.tanh(newton(xp, f35, d, v35, xp.inf, 1.0, 2.0))


def force_at(xp, a, root, h, b, E_star):
    v3 = xp.arcsinh(a / root)
    return E_star * h * (b * tanh_gap(xp, v3, xp.tanh(v3)) + a ** 2.0 * v3 / b)


def radius_from_force(xp, F, h, b, E_star):
    v5 = xp.log(F / force_at(xp, b * 0.7615941559557649, b / 1.5430806348152437, h, b, E_star))
    v7 = 0.5833333333333334 * (v5 - 0.4879663296199081)
    v9 = 1.75 * (v5 - 0.8775499035577244)
    v18 = xp.exp((xp.maximum(v7, v9) + xp.log1p(xp.exp(-xp.absolute(v7 - v9)))) / 1.75)
    v21 = 1.0 - 1.0 / (1.0 + v18)
    v29 = (((13.75711 * v21 + -58.34092) * v21 + 91.96521) * v21 + -66.84601) * v21 + 22.20415

    def f36(v37):
        v39 = b * xp.tanh(v37)
        v41 = b / xp.cosh(v37)
        v42 = force_at(xp, v39, v41, h, b, E_star)
        v51 = 2.0 * E_star * v39 * v37 * v41 * v41 / b * slope(xp, v39, v41, h, b) / v42
        return (v42, v51)
    v36 = v18 * (((v29 * v21 + -2.915358) * v21 + 0.1558039) * v21 + 0.998775)
    return b * xp.tanh(newton(xp, f36, F, v36, xp.inf, 1.0, 3.0))


def force_from_depth(xp, d, h, b, E_star):
    v5 = xp.log(d / depth_at(xp, b * 0.7615941559557649, b / 1.5430806348152437, h, b))
    v6 = v5 - 0.2723145953206591
    v7 = 1.875 * v6
    v8 = 3.75 * v6
    v17 = xp.exp((xp.maximum(v7, v8) + xp.log1p(xp.exp(-xp.absolute(v7 - v8)))) / 3.75)
    v20 = 1.0 - 1.0 / (1.0 + v17)
    v28 = (((25.07439 * v20 + -95.06062) * v20 + 137.5431) * v20 + -93.92268) * v20 + 30.18372

    def f35(v36):
        v38 = b * xp.tanh(v36)
        v40 = b / xp.cosh(v36)
        v41 = depth_at(xp, v38, v40, h, b)
        return (v41, v36 * v40 * v40 / b * slope(xp, v38, v40, h, b) / v41)
    v35 = v17 * (((v28 * v20 + -4.0282) * v20 + 0.208363) * v20 + 0.9983865)
    v48 = newton(xp, f35, d, v35, xp.inf, 1.0, 2.0)
    v50 = b * xp.tanh(v48)
    v52 = b / xp.cosh(v48)
    v61 = 2.0 * E_star * v50 * (d - depth_at(xp, v50, v52, h, b))
    v63 = force_at(xp, v50, v52, h, b, E_star) + xp.where((v50 > 0.0) & (v50 < xp.inf), v61, 0.0)
    return v63


def depth_from_force(xp, F, h, b, E_star):
    v5 = xp.log(F / force_at(xp, b * 0.7615941559557649, b / 1.5430806348152437, h, b, E_star))
    v7 = 0.5833333333333334 * (v5 - 0.4879663296199081)
    v9 = 1.75 * (v5 - 0.8775499035577244)
    v18 = xp.exp((xp.maximum(v7, v9) + xp.log1p(xp.exp(-xp.absolute(v7 - v9)))) / 1.75)
    v21 = 1.0 - 1.0 / (1.0 + v18)
    v29 = (((13.75711 * v21 + -58.34092) * v21 + 91.96521) * v21 + -66.84601) * v21 + 22.20415

    def f36(v37):
        v39 = b * xp.tanh(v37)
        v41 = b / xp.cosh(v37)
        v42 = force_at(xp, v39, v41, h, b, E_star)
        v51 = 2.0 * E_star * v39 * v37 * v41 * v41 / b * slope(xp, v39, v41, h, b) / v42
        return (v42, v51)
    v36 = v18 * (((v29 * v21 + -2.915358) * v21 + 0.1558039) * v21 + 0.998775)
    v52 = newton(xp, f36, F, v36, xp.inf, 1.0, 3.0)
    v54 = b * xp.tanh(v52)
    v56 = b / xp.cosh(v52)
    v65 = (F - force_at(xp, v54, v56, h, b, E_star)) / (2.0 * E_star * v54)
    return depth_at(xp, v54, v56, h, b) + xp.where((v54 > 0.0) & (v54 < xp.inf), v65, 0.0)


def energy(xp, a, h, b, E_star):
    v8, v9 = nodes_along(xp, 1, a, h, b, E_star)
    v1 = a <= b
    v2 = xp.where(v1, a, 0.5 * b)
    v3 = v2 < b
    v4 = xp.where(v3, v2, 0.5 * b)
    v6 = v4 / difference_root(xp, b, v4)
    v7 = xp.arcsinh(v6)
    v10 = v8 * v7
    v21 = 0.0 - xp.expm1(-2.0 * v7)
    v22 = v21 > 0.0
    v18 = xp.exp(-v10) * (0.0 - xp.expm1(-2.0 * (v7 - v10)))
    v26 = v6 * (v18 / xp.where(v22, xp.where(v22, v21, 1.0), xp.inf))
    v29 = xp.sqrt(1.0 + v26 * v26)
    v34 = depth(xp, v4, h, b) - depth_at(xp, b * (v26 / v29), b / v29, h, b)
    v40 = xp.where(v3, 2.0 * b, v2)
    v43 = xp.where(v1, 2.0 * b, a)
    v42 = E_star * xp.where(v3, b * (v7 * xp.sum(v9 * (v34 * v34 / (v29 * v29)), axis=0)), xp.inf)
    return xp.where(v1, v42, xp.nan)


def load_within(xp, r, a, h, b, E_star):
    v16, v17 = nodes_along(xp, 1, r, a, h, b, E_star)
    v1 = a <= b
    v2 = xp.where(v1, a, 0.5 * b)
    v3 = xp.minimum(r, v2)
    v6 = v3 > 0.0
    v9 = v3 * v3
    v12 = difference_root(xp, v2, v3) / difference_root(xp, b, v2)
    v13 = v3 / b
    v15 = xp.arcsinh(v12 / v13)
    v18 = v16 * v15
    v19 = difference_root(xp, b, v3)
    v29 = 0.0 - xp.expm1(-2.0 * v15)
    v30 = v29 > 0.0
    v26 = xp.exp(-v18) * (0.0 - xp.expm1(-2.0 * (v15 - v18)))
    v34 = v12 * (v26 / xp.where(v30, xp.where(v30, v29, 1.0), xp.inf))
    v35 = v34 * v34
    v37 = xp.sqrt(1.0 + v35)
    v39 = v19 * (v34 / v37)
    v42 = xp.sqrt(v9 + v39 * v39)
    v43 = v19 / v37
    v51 = slope(xp, v42, v43, h, b) * (v39 / (v42 + v39)) * (v43 / (v37 * v37 * v42))
    v58 = xp.where(v6, v3, 1.0)
    v57 = v9 * (v15 * xp.sum(v17 * (v51 * xp.sqrt(v13 * v13 + v35)), axis=0))
    v61 = 2.0 * E_star * xp.where(v6 & (v2 < b), v57, xp.where(v6, xp.inf, 0.0))
    v63 = xp.where(v1, 2.0 * b, a)
    return xp.where(v1, force(xp, v3, h, b, E_star) + v61, xp.nan)
