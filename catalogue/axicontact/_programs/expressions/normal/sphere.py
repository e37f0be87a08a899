"""Formulas of axicontact.normal.sphere over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.shapes.arcs import arc_strips
from ...._programs.expressions._runtime.special import tanh_gap
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def depth(xp, a, R):
    return a * (xp.log1p(2.0 * a / (R - a)) / 2.0)


def force(xp, a, R, E_star):
    v6 = xp.log1p(2.0 * a / (R - a)) / 2.0
    return E_star * (a ** 2.0 * v6 + R ** 2.0 * tanh_gap(xp, v6, a / R))


def pressure(xp, r, a, R, E_star):
    v1 = a <= R
    v2 = xp.where(v1, a, 0.5 * R)
    v3 = r < v2
    v4 = xp.where(v3, r, 0.5 * v2)
    v16 = R * xp.arcsinh(xp.sqrt((v2 - v4) * (v2 + v4)) / xp.sqrt((R - v2) * (v2 + R)))
    v23 = v16 / xp.sqrt((R - v4) * (v4 + R)) + arc_strips(xp, v4, v2, R)
    v25 = xp.where(v3, 2.0 * v2, r)
    v27 = xp.where(v1, 2.0 * R, a)
    return xp.where(v1, xp.where(v3, E_star / 3.141592653589793 * v23, 0.0), xp.nan)


def slope(xp, t, root, R):
    return xp.arcsinh(t / root) + R * t / root ** 2.0


def profile(xp, r, R):
    return r ** 2.0 / (xp.sqrt((R - r) * (r + R)) + R)


def displacement(xp, r, a, R):
    v11, v12 = nodes_along(xp, 1, r, a, R)
    v1 = a <= R
    v2 = xp.where(v1, a, 0.5 * R)
    v3 = r > v2
    v4 = xp.where(v3, r, 2.0 * v2)
    v5 = xp.minimum(v4, R)
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
    v40 = slope(xp, v33, xp.sqrt(difference_root(xp, R, v4) ** 2.0 + v37), R)
    v48 = v40 * xp.arctan2(v33, xp.sqrt(difference_root(xp, v4, R) ** 2.0 + v37)) * (v36 / v31)
    v50 = xp.where(v6, 2.0 * v5, v2)
    v52 = 0.6366197723675814 * xp.where(v6, v10 * xp.sum(v12 * v48, axis=0), xp.inf)
    v58 = xp.where(v1, 2.0 * R, a)
    v57 = xp.where(v3, v52, depth(xp, v2, R) - profile(xp, xp.where(v3, 0.5 * v2, r), R))
    return xp.where(v1, v57, xp.nan)


def stiffness(xp, a, E_star):
    return 2.0 * E_star * a


def mean_pressure(xp, a, R, E_star):
    v1 = a > 0.0
    v2 = xp.where(v1, a, 1.0)
    return xp.where(v1, force(xp, v2, R, E_star) / (3.141592653589793 * v2 ** 2.0), 0.0)


def radius_from_depth(xp, d, R):
    v1 = R * 0.7615941559557649
    v8 = xp.log(d / (v1 * xp.arcsinh(v1 / (R / 1.5430806348152437)))) - 0.2723145953206591
    v9 = 1.875 * v8
    v10 = 3.75 * v8
    v19 = xp.exp((xp.maximum(v9, v10) + xp.log1p(xp.exp(-xp.absolute(v9 - v10)))) / 3.75)
    v22 = 1.0 - 1.0 / (1.0 + v19)
    v30 = (((25.07439 * v22 + -95.06062) * v22 + 137.5431) * v22 + -93.92268) * v22 + 30.18372

    def f37(v38):
        v40 = R * xp.tanh(v38)
        v42 = R / xp.cosh(v38)
        v45 = v40 * xp.arcsinh(v40 / v42)
        return (v45, v38 * v42 * v42 / R * slope(xp, v40, v42, R) / v45)
    v37 = v19 * (((v30 * v22 + -4.0282) * v22 + 0.208363) * v22 + 0.9983865)
    return R * xp.tanh(newton(xp, f37, d, v37, xp.inf, 1.0, 2.0))


def force_at(xp, a, root, R, E_star):
    v3 = xp.arcsinh(a / root)
    return E_star * (a ** 2.0 * v3 + R ** 2.0 * tanh_gap(xp, v3, xp.tanh(v3)))


def radius_from_force(xp, F, R, E_star):
    v5 = xp.log(F / force_at(xp, R * 0.7615941559557649, R / 1.5430806348152437, R, E_star))
    v7 = 0.5833333333333334 * (v5 - 0.4879663296199081)
    v9 = 1.75 * (v5 - 0.8775499035577244)
    v18 = xp.exp((xp.maximum(v7, v9) + xp.log1p(xp.exp(-xp.absolute(v7 - v9)))) / 1.75)
    v21 = 1.0 - 1.0 / (1.0 + v18)
    v29 = (((13.75711 * v21 + -58.34092) * v21 + 91.96521) * v21 + -66.84601) * v21 + 22.20415

    def f36(v37):
        v39 = R * xp.tanh(v37)
        v41 = R / xp.cosh(v37)
        v42 = force_at(xp, v39, v41, R, E_star)
        v51 = 2.0 * E_star * v39 * v37 * v41 * v41 / R * slope(xp, v39, v41, R) / v42
        return (v42, v51)
    v36 = v18 * (((v29 * v21 + -2.915358) * v21 + 0.1558039) * v21 + 0.998775)
    return R * xp.tanh(newton(xp, f36, F, v36, xp.inf, 1.0, 3.0))


def force_from_depth(xp, d, R, E_star):
    v1 = R * 0.7615941559557649
    v8 = xp.log(d / (v1 * xp.arcsinh(v1 / (R / 1.5430806348152437)))) - 0.2723145953206591
    v9 = 1.875 * v8
    v10 = 3.75 * v8
    v19 = xp.exp((xp.maximum(v9, v10) + xp.log1p(xp.exp(-xp.absolute(v9 - v10)))) / 3.75)
    v22 = 1.0 - 1.0 / (1.0 + v19)
    v30 = (((25.07439 * v22 + -95.06062) * v22 + 137.5431) * v22 + -93.92268) * v22 + 30.18372

    def f37(v38):
        v40 = R * xp.tanh(v38)
        v42 = R / xp.cosh(v38)
        v45 = v40 * xp.arcsinh(v40 / v42)
        return (v45, v38 * v42 * v42 / R * slope(xp, v40, v42, R) / v45)
    v37 = v19 * (((v30 * v22 + -4.0282) * v22 + 0.208363) * v22 + 0.9983865)
    v52 = newton(xp, f37, d, v37, xp.inf, 1.0, 2.0)
    v54 = R * xp.tanh(v52)
    v56 = R / xp.cosh(v52)
    v67 = 2.0 * E_star * v54 * (d - v54 * xp.arcsinh(v54 / v56))
    return force_at(xp, v54, v56, R, E_star) + xp.where((v54 > 0.0) & (v54 < xp.inf), v67, 0.0)


def depth_from_force(xp, F, R, E_star):
    v5 = xp.log(F / force_at(xp, R * 0.7615941559557649, R / 1.5430806348152437, R, E_star))
    v7 = 0.5833333333333334 * (v5 - 0.4879663296199081)
    v9 = 1.75 * (v5 - 0.8775499035577244)
    v18 = xp.exp((xp.maximum(v7, v9) + xp.log1p(xp.exp(-xp.absolute(v7 - v9)))) / 1.75)
    v21 = 1.0 - 1.0 / (1.0 + v18)
    v29 = (((13.75711 * v21 + -58.34092) * v21 + 91.96521) * v21 + -66.84601) * v21 + 22.20415

    def f36(v37):
        v39 = R * xp.tanh(v37)
        v41 = R / xp.cosh(v37)
        v42 = force_at(xp, v39, v41, R, E_star)
        v51 = 2.0 * E_star * v39 * v37 * v41 * v41 / R * slope(xp, v39, v41, R) / v42
        return (v42, v51)
    v36 = v18 * (((v29 * v21 + -2.915358) * v21 + 0.1558039) * v21 + 0.998775)
    v52 = newton(xp, f36, F, v36, xp.inf, 1.0, 3.0)
    v54 = R * xp.tanh(v52)
    v56 = R / xp.cosh(v52)
    v67 = (F - force_at(xp, v54, v56, R, E_star)) / (2.0 * E_star * v54)
    return v54 * xp.arcsinh(v54 / v56) + xp.where((v54 > 0.0) & (v54 < xp.inf), v67, 0.0)


def energy(xp, a, R, E_star):
    v8, v9 = nodes_along(xp, 1, a, R, E_star)
    v1 = a <= R
    v2 = xp.where(v1, a, 0.5 * R)
    v3 = v2 < R
    v4 = xp.where(v3, v2, 0.5 * R)
    v6 = v4 / difference_root(xp, R, v4)
    v7 = xp.arcsinh(v6)
    v10 = v8 * v7
    v21 = 0.0 - xp.expm1(-2.0 * v7)
    v22 = v21 > 0.0
    v18 = xp.exp(-v10) * (0.0 - xp.expm1(-2.0 * (v7 - v10)))
    v26 = v6 * (v18 / xp.where(v22, xp.where(v22, v21, 1.0), xp.inf))
    v29 = xp.sqrt(1.0 + v26 * v26)
    v31 = R * (v26 / v29)
    v36 = depth(xp, v4, R) - v31 * xp.arcsinh(v31 / (R / v29))
    v42 = xp.where(v3, 2.0 * R, v2)
    v45 = xp.where(v1, 2.0 * R, a)
    v44 = E_star * xp.where(v3, R * (v7 * xp.sum(v9 * (v36 * v36 / (v29 * v29)), axis=0)), xp.inf)
    return xp.where(v1, v44, xp.nan)


def load_within(xp, r, a, R, E_star):
    v16, v17 = nodes_along(xp, 1, r, a, R, E_star)
    v1 = a <= R
    v2 = xp.where(v1, a, 0.5 * R)
    v3 = xp.minimum(r, v2)
    v6 = v3 > 0.0
    v9 = v3 * v3
    v12 = difference_root(xp, v2, v3) / difference_root(xp, R, v2)
    v13 = v3 / R
    v15 = xp.arcsinh(v12 / v13)
    v18 = v16 * v15
    v19 = difference_root(xp, R, v3)
    v29 = 0.0 - xp.expm1(-2.0 * v15)
    v30 = v29 > 0.0
    v26 = xp.exp(-v18) * (0.0 - xp.expm1(-2.0 * (v15 - v18)))
    v34 = v12 * (v26 / xp.where(v30, xp.where(v30, v29, 1.0), xp.inf))
    v35 = v34 * v34
    v37 = xp.sqrt(1.0 + v35)
    v39 = v19 * (v34 / v37)
    v42 = xp.sqrt(v9 + v39 * v39)
    v43 = v19 / v37
    v51 = slope(xp, v42, v43, R) * (v39 / (v42 + v39)) * (v43 / (v37 * v37 * v42))
    v58 = xp.where(v6, v3, 1.0)
    v57 = v9 * (v15 * xp.sum(v17 * (v51 * xp.sqrt(v13 * v13 + v35)), axis=0))
    v61 = 2.0 * E_star * xp.where(v6 & (v2 < R), v57, xp.where(v6, xp.inf, 0.0))
    v63 = xp.where(v1, 2.0 * R, a)
    return xp.where(v1, force(xp, v3, R, E_star) + v61, xp.nan)
