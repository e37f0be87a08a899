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


def energy(xp, a, R, theta, E_star):
    v6, v7 = nodes_along(xp, 1, a, R, theta, E_star)
    v2 = R * xp.sin(theta)
    v3 = xp.minimum(a, v2)
    v5 = xp.arcsinh(v3 / R)
    v8 = v6 * v5
    v20 = 0.0 - xp.expm1(-2.0 * v5)
    v21 = v20 > 0.0
    v17 = xp.exp(-v8) * (0.0 - xp.expm1(-2.0 * (v5 - v8)))
    v25 = v3 * (v17 / xp.where(v21, xp.where(v21, v20, 1.0), xp.inf))
    v27 = depth_at(xp, v25, sine_root(xp, v25, R, theta), R, theta)
    v28 = depth_at(xp, a, sine_root(xp, a, R, theta), R, theta) - v27
    v36 = a > v2
    v37 = xp.where(v36, a, 2.0 * v2)
    v38 = difference_root(xp, v37, v2)
    v40 = xp.arcsinh(v38 / v2)
    v41 = v6 * v40
    v54 = 0.0 - xp.expm1(-2.0 * v40)
    v55 = v54 > 0.0
    v51 = xp.exp(-v41) * (0.0 - xp.expm1(-2.0 * (v40 - v41)))
    v59 = v38 * (v51 / xp.where(v55, xp.where(v55, v54, 1.0), xp.inf))
    v63 = depth_at(xp, xp.sqrt(v2 * v2 + v59 * v59), v59, R, theta)
    v64 = depth_at(xp, v37, sine_root(xp, v37, R, theta), R, theta) - v63
    v68 = xp.where(v36, 0.5 * v2, a)
    v35 = v5 * xp.sum(v7 * (v28 * v28 * xp.sqrt(R * R + v25 * v25)), axis=0)
    return E_star * (v35 + xp.where(v36, v40 * xp.sum(v7 * (v64 * v64 * v59), axis=0), 0.0))


def load_within(xp, r, a, R, theta, E_star):
    v19, v20 = nodes_along(xp, 1, r, a, R, theta, E_star)
    v1 = xp.minimum(r, a)
    v6 = R * xp.sin(theta)
    v7 = xp.minimum(a, v6)
    v8 = xp.minimum(r, v7)
    v9 = v8 > 0.0
    v12 = v8 * v8
    v15 = difference_root(xp, v7, v8) / difference_root(xp, R, v7)
    v16 = v8 / R
    v18 = xp.arcsinh(v15 / v16)
    v21 = v19 * v18
    v22 = difference_root(xp, R, v8)
    v32 = 0.0 - xp.expm1(-2.0 * v18)
    v33 = v32 > 0.0
    v29 = xp.exp(-v21) * (0.0 - xp.expm1(-2.0 * (v18 - v21)))
    v37 = v15 * (v29 / xp.where(v33, xp.where(v33, v32, 1.0), xp.inf))
    v38 = v37 * v37
    v40 = xp.sqrt(1.0 + v38)
    v42 = v22 * (v37 / v40)
    v45 = xp.sqrt(v12 + v42 * v42)
    v46 = v22 / v40
    v54 = slope(xp, v45, v46, R) * (v42 / (v45 + v42)) * (v46 / (v40 * v40 * v45))
    v61 = xp.where(v9, v8, 1.0)
    v60 = v12 * (v18 * xp.sum(v20 * (v54 * xp.sqrt(v16 * v16 + v38)), axis=0))
    v66 = xp.where(r == v6, v6 * 1.0000000000000002, r)
    v67 = xp.maximum(v66, v6)
    v68 = a > v67
    v69 = xp.where(v68, a, 2.0 * v67)
    v71 = v66 < v6
    v72 = xp.where(v71, v66, 0.5 * v6)
    v75 = difference_root(xp, v69, xp.where(v71, 2.0 * v6, v66))
    v76 = xp.where(v71, difference_root(xp, v69, v6), v75)
    v83 = xp.arcsinh(v76 / xp.sqrt(xp.absolute(v66 - v6) * (v66 + v6)))
    v84 = v19 * v83
    v88 = xp.exp(-v84)
    v89 = xp.where(v71, v66, 0.5 * v6)
    v90 = xp.where(v71, 2.0 * v6, v66)
    v91 = xp.where(v71, 0.0, 1.0)
    v92 = 2.0 * v91
    v93 = 1.0 - v92
    v96 = xp.expm1(-2.0 * (v83 - v84))
    v101 = xp.expm1(-2.0 * v83)
    v103 = v92 - v93 * v101
    v104 = v103 > 0.0
    v107 = v88 * (v92 - v93 * v96) / xp.where(v104, xp.where(v104, v103, 1.0), xp.inf)
    v108 = difference_root(xp, v69, v6) * v107
    v111 = xp.sqrt(v6 * v6 + v108 * v108)
    v117 = 2.0 * (1.0 - v91)
    v118 = 1.0 - v117
    v123 = v117 - v118 * v101
    v124 = v123 > 0.0
    v127 = v88 * (v117 - v118 * v96) / xp.where(v124, xp.where(v124, v123, 1.0), xp.inf)
    v128 = difference_root(xp, v69, v66) * v127
    v131 = slope_beyond(xp, v111, v108, R, theta) * (v108 / v111) * (v128 / (v111 + v128))
    v134 = xp.where(v68, 0.5 * v67, a)
    v135 = xp.where(v68, v66 * v66 * (v83 * xp.sum(v20 * v131, axis=0)), 0.0)
    v137 = 2.0 * E_star * (xp.where(v9 & (v7 < R), v60, xp.where(v9, xp.inf, 0.0)) + v135)
    return force_at(xp, v1, sine_root(xp, v1, R, theta), R, theta, E_star) + v137
