"""Formulas of axicontact.normal.sphere_tipped_cone over an array library `xp`."""

from ...._programs.expressions._runtime.functions import sine_root
from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.shapes.arcs import arc_strips
from ...._programs.expressions._runtime.special import tanh_gap
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def depth_at(xp, a, root, R, theta):
    v2 = R * xp.sin(theta)
    v3 = a < v2
    v4 = xp.where(v3, a, 0.5 * v2)
    v11 = xp.where(v3, 2.0 * v2, a)
    v12 = xp.where(v3, v2, root)
    v13 = v2 ** 2.0
    v17 = R * xp.cos(theta)
    v23 = xp.log1p((v13 / (v12 + v11) + v13 / (v17 + R)) / (v12 + v17))
    v28 = v11 * (v23 + v2 * xp.arctan2(v12, v2) / v17)
    return xp.where(v3, v4 * (xp.log1p(2.0 * v4 / (R - v4)) / 2.0), v28)


def slope_beyond(xp, t, root, R, theta):
    v2 = R * xp.sin(theta)
    v3 = v2 ** 2.0
    v7 = R * xp.cos(theta)
    v13 = xp.log1p((v3 / (root + t) + v3 / (v7 + R)) / (root + v7))
    v25 = v13 + v2 * xp.arctan2(root, v2) / v7 + v3 * R / (t * v7 ** 2.0 + R * root * v7)
    return v25


def force_at(xp, a, reach, R, theta, E_star):
    v28, v29 = nodes_along(xp, 1, a, reach, R, theta, E_star)
    v2 = R * xp.sin(theta)
    v3 = xp.minimum(a, v2)
    v5 = a < v2
    v7 = xp.minimum(xp.where(v5, a, 0.5 * v2), v2)
    v12 = xp.where(v5, 2.0 * v2, a)
    v17 = xp.arcsinh(v3 / xp.where(v5, xp.sqrt((R - v7) * (v7 + R)), R * xp.cos(theta)))
    v27 = xp.arcsinh(reach / v2)
    v30 = v28 * v27
    v41 = 0.0 - xp.expm1(-2.0 * v27)
    v42 = v41 > 0.0
    v38 = xp.exp(-v30) * (0.0 - xp.expm1(-2.0 * (v27 - v30)))
    v46 = reach * (v38 / xp.where(v42, xp.where(v42, v41, 1.0), xp.inf))
    v49 = xp.sqrt(v2 * v2 + v46 * v46)
    v53 = v27 * xp.sum(v29 * (slope_beyond(xp, v49, v46, R, theta) * v46 * v49), axis=0)
    v24 = E_star * (v3 ** 2.0 * v17 + R ** 2.0 * tanh_gap(xp, v17, xp.tanh(v17)))
    return v24 + 2.0 * E_star * v53


def pressure(xp, r, a, R, theta, E_star):
    v57, v58 = nodes_along(xp, 1, r, a, R, theta, E_star)
    v1 = r < a
    v2 = xp.where(v1, r, 0.5 * a)
    v4 = R * xp.sin(theta)
    v5 = xp.minimum(a, v4)
    v6 = v2 < v5
    v7 = xp.where(v6, v2, 0.5 * v5)
    v13 = a < v4
    v15 = xp.minimum(xp.where(v13, a, 0.5 * v4), v4)
    v20 = xp.where(v13, 2.0 * v4, a)
    v23 = xp.where(v13, xp.sqrt((R - v15) * (v15 + R)), R * xp.cos(theta))
    v31 = R * xp.arcsinh(xp.sqrt((v5 - v7) * (v5 + v7)) / v23) / xp.sqrt((R - v7) * (v7 + R))
    v35 = xp.where(v6, 2.0 * v5, v2)
    v40 = xp.where(v2 == v4, v4 * 1.0000000000000002, v2)
    v41 = xp.maximum(v40, v4)
    v42 = a > v41
    v43 = xp.where(v42, a, 2.0 * v41)
    v44 = v40 < v4
    v45 = xp.where(v44, v40, 0.5 * v4)
    v48 = difference_root(xp, v43, xp.where(v44, 2.0 * v4, v40))
    v49 = xp.where(v44, difference_root(xp, v43, v4), v48)
    v56 = xp.arcsinh(v49 / xp.sqrt(xp.absolute(v40 - v4) * (v40 + v4)))
    v59 = v57 * v56
    v64 = xp.where(v44, v40, 0.5 * v4)
    v65 = xp.where(v44, 2.0 * v4, v40)
    v67 = 2.0 * xp.where(v44, 0.0, 1.0)
    v68 = 1.0 - v67
    v78 = v67 - v68 * xp.expm1(-2.0 * v56)
    v79 = v78 > 0.0
    v74 = xp.exp(-v59) * (v67 - v68 * xp.expm1(-2.0 * (v56 - v59)))
    v83 = difference_root(xp, v43, v4) * (v74 / xp.where(v79, xp.where(v79, v78, 1.0), xp.inf))
    v86 = xp.sqrt(v4 * v4 + v83 * v83)
    v91 = xp.where(v42, 0.5 * v41, a)
    v90 = v56 * xp.sum(v58 * (slope_beyond(xp, v86, v83, R, theta) * v83 / v86), axis=0)
    v36 = xp.where(v6, E_star / 3.141592653589793 * (v31 + arc_strips(xp, v7, v5, R)), 0.0)
    v95 = xp.where(v1, 2.0 * a, r)
    return xp.where(v1, v36 + E_star / 3.141592653589793 * xp.where(v42, v90, 0.0), 0.0)


def slope(xp, t, root, R):
    return xp.arcsinh(t / root) + R * t / root ** 2.0


def profile(xp, r, R, theta):
    v2 = R * xp.sin(theta)
    v3 = r < v2
    v4 = xp.where(v3, r, 0.5 * v2)
    v15 = R * xp.cos(theta)
    v20 = v2 * ((xp.where(v3, 2.0 * v2, r) - v2) / v15 + v2 / (v15 + R))
    return xp.where(v3, v4 ** 2.0 / (xp.sqrt((R - v4) * (v4 + R)) + R), v20)


def displacement(xp, r, a, R, theta):
    v12, v13 = nodes_along(xp, 1, r, a, R, theta)
    v1 = r > a
    v2 = xp.where(v1, r, 2.0 * a)
    v4 = R * xp.sin(theta)
    v5 = xp.minimum(a, v4)
    v6 = xp.minimum(v2, R)
    v7 = v5 < v6
    v8 = xp.where(v7, v5, 0.5 * v6)
    v10 = v8 / difference_root(xp, v6, v8)
    v11 = xp.arcsinh(v10)
    v14 = v12 * v11
    v24 = 0.0 - xp.expm1(-2.0 * v11)
    v25 = v24 > 0.0
    v21 = xp.exp(-v14) * (0.0 - xp.expm1(-2.0 * (v11 - v14)))
    v29 = v10 * (v21 / xp.where(v25, xp.where(v25, v24, 1.0), xp.inf))
    v32 = xp.sqrt(1.0 + v29 * v29)
    v34 = v6 * (v29 / v32)
    v37 = v6 / v32
    v38 = v37 * v37
    v41 = slope(xp, v34, xp.sqrt(difference_root(xp, R, v2) ** 2.0 + v38), R)
    v49 = v41 * xp.arctan2(v34, xp.sqrt(difference_root(xp, v2, R) ** 2.0 + v38)) * (v37 / v32)
    v51 = xp.where(v7, 2.0 * v6, v5)
    v53 = a > v4
    v54 = xp.where(v53, a, 2.0 * v4)
    v55 = difference_root(xp, v2, v4)
    v58 = difference_root(xp, v54, v4) / difference_root(xp, v2, v54)
    v59 = v4 / v2
    v61 = xp.arcsinh(v58 / v59)
    v62 = v12 * v61
    v73 = 0.0 - xp.expm1(-2.0 * v61)
    v74 = v73 > 0.0
    v70 = xp.exp(-v62) * (0.0 - xp.expm1(-2.0 * (v61 - v62)))
    v78 = v58 * (v70 / xp.where(v74, xp.where(v74, v73, 1.0), xp.inf))
    v80 = v78 * v78
    v82 = xp.sqrt(1.0 + v80)
    v83 = v55 * v78 / v82
    v86 = xp.sqrt(v4 * v4 + v83 * v83)
    v92 = slope_beyond(xp, v86, v83, R, theta) * v83 / v86 * xp.arctan2(v86, v55 / v82)
    v102 = xp.where(v53, 0.5 * v4, a)
    v101 = v55 * (v61 * xp.sum(v13 * (v92 * (xp.sqrt(v59 * v59 + v80) / (v82 * v82 * v82))), axis=0))
    v104 = xp.where(v7, v11 * xp.sum(v13 * v49, axis=0), xp.inf) + xp.where(v53, v101, 0.0)
    v108 = depth_at(xp, a, sine_root(xp, a, R, theta), R, theta)
    v110 = v108 - profile(xp, xp.where(v1, 0.5 * a, r), R, theta)
    return xp.where(v1, 0.6366197723675814 * v104, v110)


def slope_at(xp, a, root, R, theta):
    v2 = R * xp.sin(theta)
    v3 = a < v2
    v4 = xp.where(v3, a, 0.5 * v2)
    v12 = slope_beyond(xp, xp.where(v3, 2.0 * v2, a), xp.where(v3, v2, root), R, theta)
    return xp.where(v3, slope(xp, v4, xp.sqrt((R - v4) * (R + v4)), R), v12)


def depth(xp, a, R, theta):
    return depth_at(xp, a, sine_root(xp, a, R, theta), R, theta)


def force(xp, a, R, theta, E_star):
    return force_at(xp, a, sine_root(xp, a, R, theta), R, theta, E_star)


def stiffness(xp, a, E_star):
    return 2.0 * E_star * a


def mean_pressure(xp, a, R, theta, E_star):
    v1 = a > 0.0
    v2 = xp.where(v1, a, 1.0)
    v4 = force_at(xp, v2, sine_root(xp, v2, R, theta), R, theta, E_star)
    return xp.where(v1, v4 / (3.141592653589793 * v2 ** 2.0), 0.0)


def radius_from_depth(xp, d, R, theta):
    v2 = R * xp.sin(theta)

    def f6(v7):
        v8 = v7 < 1.0
        v10 = xp.where(v8, 2.0 * 1.0, v7)
        v11 = v10 < 1.0
        v12 = xp.where(v11, v10, 0.5 * 1.0)
        v15 = xp.where(v11, 0.0, xp.where(v11, 2.0 * 1.0, v10) - 1.0)
        v20 = v2 * xp.where(v8, xp.where(v8, v7, 0.5 * 1.0), xp.sqrt(1.0 + v15 * v15))
        v21 = xp.where(v8, v7, 0.5 * 1.0)
        v25 = v2 * xp.where(v8, 0.0, xp.where(v8, 2.0 * 1.0, v7) - 1.0)
        v26 = depth_at(xp, v20, v25, R, theta)
        v30 = xp.where(v8, v7, 0.5 * 1.0)
        v31 = xp.where(v8, 2.0 * 1.0, v7)
        v32 = v31 < 1.0
        v33 = xp.where(v32, v31, 0.5 * 1.0)
        v36 = xp.where(v32, 0.0, xp.where(v32, 2.0 * 1.0, v31) - 1.0)
        v41 = xp.where(v8, 1.0, v31 * v36 / (1.0 + v36 * v36))
        return (v26, v20 * slope_at(xp, v20, v25, R, theta) / v26 * v41)
    v43 = newton(xp, f6, d, (d / depth_at(xp, v2, v2 * 0.0, R, theta)) ** 0.5, xp.inf, 1e-06, xp.inf)
    v44 = v43 < 1.0
    v46 = xp.where(v44, 2.0 * 1.0, v43)
    v47 = v46 < 1.0
    v48 = xp.where(v47, v46, 0.5 * 1.0)
    v51 = xp.where(v47, 0.0, xp.where(v47, 2.0 * 1.0, v46) - 1.0)
    return v2 * xp.where(v44, xp.where(v44, v43, 0.5 * 1.0), xp.sqrt(1.0 + v51 * v51))


def radius_from_force(xp, F, R, theta, E_star):
    v2 = R * xp.sin(theta)

    def f6(v7):
        v8 = v7 < 1.0
        v10 = xp.where(v8, 2.0 * 1.0, v7)
        v11 = v10 < 1.0
        v12 = xp.where(v11, v10, 0.5 * 1.0)
        v15 = xp.where(v11, 0.0, xp.where(v11, 2.0 * 1.0, v10) - 1.0)
        v20 = v2 * xp.where(v8, xp.where(v8, v7, 0.5 * 1.0), xp.sqrt(1.0 + v15 * v15))
        v21 = xp.where(v8, v7, 0.5 * 1.0)
        v25 = v2 * xp.where(v8, 0.0, xp.where(v8, 2.0 * 1.0, v7) - 1.0)
        v26 = force_at(xp, v20, v25, R, theta, E_star)
        v33 = xp.where(v8, v7, 0.5 * 1.0)
        v34 = xp.where(v8, 2.0 * 1.0, v7)
        v35 = v34 < 1.0
        v36 = xp.where(v35, v34, 0.5 * 1.0)
        v39 = xp.where(v35, 0.0, xp.where(v35, 2.0 * 1.0, v34) - 1.0)
        v32 = 2.0 * E_star * v20 ** 2.0 * slope_at(xp, v20, v25, R, theta) / v26
        return (v26, v32 * xp.where(v8, 1.0, v34 * v39 / (1.0 + v39 * v39)))
    v6 = (F / force_at(xp, v2, v2 * 0.0, R, theta, E_star)) ** 0.3333333333333333
    v46 = newton(xp, f6, F, v6, xp.inf, 1e-06, xp.inf)
    v47 = v46 < 1.0
    v49 = xp.where(v47, 2.0 * 1.0, v46)
    v50 = v49 < 1.0
    v51 = xp.where(v50, v49, 0.5 * 1.0)
    v54 = xp.where(v50, 0.0, xp.where(v50, 2.0 * 1.0, v49) - 1.0)
    return v2 * xp.where(v47, xp.where(v47, v46, 0.5 * 1.0), xp.sqrt(1.0 + v54 * v54))


def force_from_depth(xp, d, R, theta, E_star):
    v1 = radius_from_depth(xp, d, R, theta)
    v2 = sine_root(xp, v1, R, theta)
    v11 = 2.0 * E_star * v1 * (d - depth_at(xp, v1, v2, R, theta))
    v13 = force_at(xp, v1, v2, R, theta, E_star) + xp.where((v1 > 0.0) & (v1 < xp.inf), v11, 0.0)
    return v13


def depth_from_force(xp, F, R, theta, E_star):
    v1 = radius_from_force(xp, F, R, theta, E_star)
    v2 = sine_root(xp, v1, R, theta)
    v11 = (F - force_at(xp, v1, v2, R, theta, E_star)) / (2.0 * E_star * v1)
    return depth_at(xp, v1, v2, R, theta) + xp.where((v1 > 0.0) & (v1 < xp.inf), v11, 0.0)
