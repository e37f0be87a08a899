"""Formulas of axicontact.normal.gaussian over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.special import dawson
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def depth(xp, a, h, s):
    v1 = 1.5019752682686114 * s
    v2 = a <= v1
    v5 = xp.where(v2, a, 0.5 * v1) / s
    v9 = xp.where(v2, 2.0 * v1, a)
    return xp.where(v2, 2.0 * h * dawson(xp, v5) * v5, xp.nan)


def slope(xp, t, h, s):
    v3 = t / s
    v4 = dawson(xp, v3)
    return 2.0 * h / s * (v4 + (1.0 - 2.0 * v4 * v3) * v3)


def force(xp, a, h, s, E_star):
    v5, v6 = nodes_along(xp, 1, a, h, s, E_star)
    v1 = 1.5019752682686114 * s
    v2 = a <= v1
    v3 = xp.where(v2, a, 0.5 * v1)
    v7 = v5 * v3
    v12 = xp.where(v2, 2.0 * v1, a)
    v13 = xp.where(v2, 2.0 * E_star * (v3 * xp.sum(v6 * (v7 * slope(xp, v7, h, s)), axis=0)), xp.nan)
    return v13


def pressure(xp, r, a, h, s, E_star):
    v8, v9 = nodes_along(xp, 1, r, a, h, s, E_star)
    v1 = 1.5019752682686114 * s
    v2 = a <= v1
    v3 = xp.where(v2, a, 0.5 * v1)
    v4 = r < v3
    v5 = xp.where(v4, r, 0.5 * v3)
    v7 = difference_root(xp, v3, v5)
    v10 = v8 * v7
    v14 = xp.sqrt(v5 * v5 + v10 * v10)
    v19 = xp.where(v4, 2.0 * v3, r)
    v18 = E_star / 3.141592653589793 * (v7 * xp.sum(v9 * (slope(xp, v14, h, s) / v14), axis=0))
    v21 = xp.where(v2, 2.0 * v1, a)
    return xp.where(v2, xp.where(v4, v18, 0.0), xp.nan)


def profile(xp, r, h, s):
    return -h * xp.expm1(-r ** 2.0 / s ** 2.0)


def displacement(xp, r, a, h, s):
    v8, v9 = nodes_along(xp, 1, r, a, h, s)
    v1 = 1.5019752682686114 * s
    v2 = a <= v1
    v3 = xp.where(v2, a, 0.5 * v1)
    v4 = r > v3
    v5 = xp.where(v4, r, 2.0 * v3)
    v7 = xp.arctan2(v3, difference_root(xp, v5, v3))
    v10 = v8 * v7
    v18 = v5 * (v7 * xp.sum(v9 * (slope(xp, v5 * xp.sin(v10), h, s) * v10 * xp.cos(v10)), axis=0))
    v23 = depth(xp, v3, h, s) - profile(xp, xp.where(v4, 0.5 * v3, r), h, s)
    v25 = xp.where(v2, 2.0 * v1, a)
    return xp.where(v2, xp.where(v4, 0.6366197723675814 * v18, v23), xp.nan)


def stiffness(xp, a, s, E_star):
    v1 = 1.5019752682686114 * s
    v2 = a <= v1
    v6 = xp.where(v2, 2.0 * v1, a)
    return xp.where(v2, 2.0 * E_star * xp.where(v2, a, 0.5 * v1), xp.nan)


def mean_pressure(xp, a, h, s, E_star):
    v1 = a > 0.0
    v2 = xp.where(v1, a, 1.0)
    return xp.where(v1, force(xp, v2, h, s, E_star) / (3.141592653589793 * v2 ** 2.0), 0.0)


def radius_from_depth(xp, d, h, s):
    v1 = 1.5019752682686114 * s
    v2 = depth(xp, v1, h, s)
    v3 = v2 * 1.0000000000000036
    v4 = d <= v3
    v5 = xp.where(v4, d, 0.5 * v3)
    v8 = xp.maximum((v2 - v5) / v5, 0.0)
    v10 = xp.log(v8 / 0.6348098)
    v12 = -3.0 * (v10 - 0.4542552722775964)
    v14 = -3.0 * (v10 - -0.8016236568960291)
    v23 = xp.exp((xp.maximum(v12, v14) + xp.log1p(xp.exp(-xp.absolute(v12 - v14)))) / -6.0)
    v26 = 1.0 - 1.0 / (1.0 + v23)
    v33 = (((-0.793611 * v26 + 3.971419) * v26 + -6.599278) * v26 + 4.031949) * v26

    def f41(v42):
        v43 = 1.0 + v42
        v44 = v1 / v43
        v45 = depth(xp, v44, h, s)
        v47 = (v2 - v45) / v45
        v48 = 1.0 + v47
        v50 = 16.0 * (1.1102230246251565e-16 * v48)
        v51 = v47 > v50
        v59 = 1.0 + xp.where(v51, 0.5 * v50, v47)
        v61 = v42 / v43 * (v44 * slope(xp, v44, h, s) / v45) * v59 / 2.0
        v64 = xp.maximum(v61, 1.1102230246251565e-16 * (1.1102230246251565e-16 * v59))
        v65 = xp.where(v51, xp.where(v51, v47, 2.0 * v50), v64)
        v73 = xp.maximum(v42 / v43 * (v44 * slope(xp, v44, h, s) / v45) * v48 / v65, 1.0)
        return (v65, v73)
    v41 = v23 * ((((v33 + -0.6766533) * v26 + 0.7000671) * v26 + 0.2435676) * v26 + 1.003776)
    v77 = xp.where(v4, 2.0 * v3, d)
    return xp.where(v4, v1 / (1.0 + newton(xp, f41, v8, v41, xp.inf, 1.0, 2.0)), xp.nan)


def radius_from_force(xp, F, h, s, E_star):
    v1 = 1.5019752682686114 * s
    v2 = force(xp, v1, h, s, E_star)
    v3 = v2 * 1.0000000000000036
    v4 = F <= v3
    v5 = xp.where(v4, F, 0.5 * v3)
    v8 = xp.maximum((v2 - v5) / v5, 0.0)
    v10 = xp.log(v8 / 1.360193)
    v12 = -3.0 * (v10 - 0.5062150112083075)
    v14 = -2.0 * (v10 - -1.9718435310818179)
    v23 = xp.exp((xp.maximum(v12, v14) + xp.log1p(xp.exp(-xp.absolute(v12 - v14)))) / -6.0)
    v26 = 1.0 - 1.0 / (1.0 + v23)
    v34 = (((32.86326 * v26 + -95.20743) * v26 + 108.1267) * v26 + -61.13223) * v26 + 16.18697

    def f41(v42):
        v43 = 1.0 + v42
        v44 = v1 / v43
        v45 = force(xp, v44, h, s, E_star)
        v47 = (v2 - v45) / v45
        v48 = 1.0 + v47
        v50 = 16.0 * (1.1102230246251565e-16 * v48)
        v51 = v47 > v50
        v62 = 1.0 + xp.where(v51, 0.5 * v50, v47)
        v64 = v42 / v43 * (2.0 * E_star * v44 ** 2.0 * slope(xp, v44, h, s) / v45) * v62 / 2.0
        v67 = xp.maximum(v64, 1.1102230246251565e-16 * (1.1102230246251565e-16 * v62))
        v68 = xp.where(v51, xp.where(v51, v47, 2.0 * v50), v67)
        v78 = v42 / v43 * (2.0 * E_star * v44 ** 2.0 * slope(xp, v44, h, s) / v45) * v48 / v68
        return (v68, xp.maximum(v78, 1.0))
    v41 = v23 * (((v34 * v26 + -1.514105) * v26 + 0.6765872) * v26 + 0.9994039)
    v83 = xp.where(v4, 2.0 * v3, F)
    return xp.where(v4, v1 / (1.0 + newton(xp, f41, v8, v41, xp.inf, 1.0, 3.0)), xp.nan)


def force_from_depth(xp, d, h, s, E_star):
    v1 = radius_from_depth(xp, d, h, s)
    v11 = xp.where((v1 > 0.0) & (v1 < xp.inf), 2.0 * E_star * v1 * (d - depth(xp, v1, h, s)), 0.0)
    return force(xp, v1, h, s, E_star) + v11


def depth_from_force(xp, F, h, s, E_star):
    v1 = radius_from_force(xp, F, h, s, E_star)
    v10 = (F - force(xp, v1, h, s, E_star)) / (2.0 * E_star * v1)
    return depth(xp, v1, h, s) + xp.where((v1 > 0.0) & (v1 < xp.inf), v10, 0.0)


def energy(xp, a, h, s, E_star):
    v6, v7 = nodes_along(xp, 1, a, h, s, E_star)
    v1 = 1.5019752682686114 * s
    v2 = a <= v1
    v3 = xp.where(v2, a, 0.5 * v1)
    v5 = xp.arcsinh(v3 / v3)
    v8 = v6 * v5
    v19 = 0.0 - xp.expm1(-2.0 * v5)
    v20 = v19 > 0.0
    v16 = xp.exp(-v8) * (0.0 - xp.expm1(-2.0 * (v5 - v8)))
    v24 = v3 * (v16 / xp.where(v20, xp.where(v20, v19, 1.0), xp.inf))
    v26 = depth(xp, v3, h, s) - depth(xp, v24, h, s)
    v35 = xp.where(v2, 2.0 * v1, a)
    v34 = E_star * (v5 * xp.sum(v7 * (v26 * v26 * xp.sqrt(v3 * v3 + v24 * v24)), axis=0))
    return xp.where(v2, v34, xp.nan)


def load_within(xp, r, a, h, s, E_star):
    v13, v14 = nodes_along(xp, 1, r, a, h, s, E_star)
    v1 = 1.5019752682686114 * s
    v2 = a <= v1
    v3 = xp.where(v2, a, 0.5 * v1)
    v4 = xp.minimum(r, v3)
    v7 = v4 > 0.0
    v8 = xp.where(v7, v4, 1.0)
    v9 = v8 * v8
    v10 = difference_root(xp, v3, v8)
    v12 = xp.arcsinh(v10 / v8)
    v15 = v13 * v12
    v25 = 0.0 - xp.expm1(-2.0 * v12)
    v26 = v25 > 0.0
    v22 = xp.exp(-v15) * (0.0 - xp.expm1(-2.0 * (v12 - v15)))
    v30 = v10 * (v22 / xp.where(v26, xp.where(v26, v25, 1.0), xp.inf))
    v33 = xp.sqrt(v9 + v30 * v30)
    v39 = v9 * (v12 * xp.sum(v14 * (slope(xp, v33, h, s) * (v30 / (v33 + v30))), axis=0))
    v43 = xp.where(v2, 2.0 * v1, a)
    v44 = xp.where(v2, force(xp, v4, h, s, E_star) + 2.0 * E_star * xp.where(v7, v39, 0.0), xp.nan)
    return v44
