"""Formulas of axicontact.normal.rounded_cone over an array library `xp`."""

from ...._programs.expressions._runtime.functions import half_tangent
from ...._programs.expressions._runtime.integrals import difference_root
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def depth(xp, a, theta, b):
    v1 = a < b
    v7 = xp.where(v1, 2.0 * b, a)
    v13 = xp.sqrt((v7 - b) * (v7 + b))
    v19 = xp.tan(theta) * v7 * (xp.arctan(v13 / b) + b / (v13 + v7))
    return xp.where(v1, xp.tan(theta) / b * xp.where(v1, a, 0.5 * b) ** 2.0, v19)


def force(xp, a, theta, b, E_star):
    v1 = a < b
    v2 = xp.where(v1, a, 0.5 * b)
    v11 = xp.where(v1, 2.0 * b, a)
    v14 = v11 ** 2.0
    v18 = xp.sqrt((v11 - b) * (v11 + b))
    v30 = v14 * xp.arctan(v18 / b) + 4.0 * b * v14 / (3.0 * (v18 + v11)) + b / 3.0 * v18
    v10 = 4.0 * E_star * xp.tan(theta) / (3.0 * b) * (v2 * v2 ** 2.0)
    return xp.where(v1, v10, E_star * xp.tan(theta) * v30)


def slope_beyond(xp, t, root, theta, b):
    return xp.tan(theta) * (xp.arctan(root / b) + 2.0 * b / (root + t))


def pressure(xp, r, a, theta, b, E_star):
    v38, v39 = nodes_along(xp, 1, r, a, theta, b, E_star)
    v1 = r < a
    v2 = xp.where(v1, r, 0.5 * a)
    v3 = xp.minimum(a, b)
    v4 = v2 < v3
    v5 = xp.where(v4, v2, 0.5 * v3)
    v16 = xp.where(v4, 2.0 * v3, v2)
    v15 = 2.0 * E_star * xp.tan(theta) / (3.141592653589793 * b) * xp.sqrt((v3 - v5) * (v3 + v5))
    v21 = xp.where(v2 == b, b * 1.0000000000000002, v2)
    v22 = xp.maximum(v21, b)
    v23 = a > v22
    v24 = xp.where(v23, a, 2.0 * v22)
    v25 = v21 < b
    v26 = xp.where(v25, v21, 0.5 * b)
    v29 = difference_root(xp, v24, xp.where(v25, 2.0 * b, v21))
    v30 = xp.where(v25, difference_root(xp, v24, b), v29)
    v37 = xp.arcsinh(v30 / xp.sqrt(xp.absolute(v21 - b) * (v21 + b)))
    v40 = v38 * v37
    v45 = xp.where(v25, v21, 0.5 * b)
    v46 = xp.where(v25, 2.0 * b, v21)
    v48 = 2.0 * xp.where(v25, 0.0, 1.0)
    v49 = 1.0 - v48
    v59 = v48 - v49 * xp.expm1(-2.0 * v37)
    v60 = v59 > 0.0
    v55 = xp.exp(-v40) * (v48 - v49 * xp.expm1(-2.0 * (v37 - v40)))
    v64 = difference_root(xp, v24, b) * (v55 / xp.where(v60, xp.where(v60, v59, 1.0), xp.inf))
    v67 = xp.sqrt(b * b + v64 * v64)
    v72 = xp.where(v23, 0.5 * v22, a)
    v71 = v37 * xp.sum(v39 * (slope_beyond(xp, v67, v64, theta, b) * v64 / v67), axis=0)
    v76 = xp.where(v1, 2.0 * a, r)
    v75 = xp.where(v4, v15, 0.0) + E_star / 3.141592653589793 * xp.where(v23, v71, 0.0)
    return xp.where(v1, v75, 0.0)


def profile(xp, r, theta, b):
    v1 = r < b
    v7 = xp.tan(theta) / (2.0 * b) * xp.where(v1, r, 0.5 * b) ** 2.0
    return xp.where(v1, v7, xp.tan(theta) * (xp.where(v1, 2.0 * b, r) - b / 2.0))


def displacement(xp, r, a, theta, b):
    v59, v60 = nodes_along(xp, 1, r, a, theta, b)
    v1 = r > a
    v2 = xp.where(v1, r, 2.0 * a)
    v7 = xp.minimum(a, b)
    v11 = half_tangent(xp, v2, v7)
    v12 = v11 * v11
    v17 = ((-0.7327347664453868 * v12 + -32.15553480435792) * v12 + -332.23363563146734) * v12
    v23 = (((v17 + -1070.7082873491413) * v12 + -85.27694715374247) * v12 + 5044.821368830373) * v12
    v33 = ((0.21387262524856868 * v12 + 32.12935731379798) * v12 + 746.8124983579742) * v12
    v39 = (((v33 + 6202.125133759036) * v12 + 23553.080984642995) * v12 + 44404.005348491315) * v12
    v28 = ((v23 + 8082.413158212496) * v12 + 3759.725330928701) * v12 + 0.26666666666720995
    v46 = v12 * (v28 / (((v39 + 40380.01430284195) * v12 + 14099.684276696918) * v12 + 1.0))
    v9 = 2.0 * xp.tan(theta) / (3.141592653589793 * b) * v7 ** 2.0
    v50 = a > b
    v51 = xp.where(v50, a, 2.0 * b)
    v52 = difference_root(xp, v2, b)
    v55 = difference_root(xp, v51, b) / difference_root(xp, v2, v51)
    v56 = b / v2
    v58 = xp.arcsinh(v55 / v56)
    v61 = v59 * v58
    v72 = 0.0 - xp.expm1(-2.0 * v58)
    v73 = v72 > 0.0
    v69 = xp.exp(-v61) * (0.0 - xp.expm1(-2.0 * (v58 - v61)))
    v77 = v55 * (v69 / xp.where(v73, xp.where(v73, v72, 1.0), xp.inf))
    v79 = v77 * v77
    v81 = xp.sqrt(1.0 + v79)
    v82 = v52 * v77 / v81
    v85 = xp.sqrt(b * b + v82 * v82)
    v91 = slope_beyond(xp, v85, v82, theta, b) * v82 / v85 * xp.arctan2(v85, v52 / v81)
    v101 = xp.where(v50, 0.5 * b, a)
    v100 = v52 * (v58 * xp.sum(v60 * (v91 * (xp.sqrt(v56 * v56 + v79) / (v81 * v81 * v81))), axis=0))
    v103 = 0.6366197723675814 * xp.where(v50, v100, 0.0)
    v108 = depth(xp, a, theta, b) - profile(xp, xp.where(v1, 0.5 * a, r), theta, b)
    return xp.where(v1, v9 * (v7 / v2 * (0.6666666666666666 + v46)) + v103, v108)


def slope(xp, t, theta, b):
    return 2.0 * xp.tan(theta) / b * t


def stiffness(xp, a, E_star):
    return 2.0 * E_star * a


def mean_pressure(xp, a, theta, b, E_star):
    v1 = a < b
    v9 = xp.where(v1, 2.0 * b, a)
    v16 = xp.sqrt((v9 - b) * (v9 + b))
    v28 = xp.arctan(v16 / b) + 4.0 * b / (3.0 * (v16 + v9)) + b * v16 / (3.0 * v9 ** 2.0)
    v8 = 4.0 * E_star * xp.tan(theta) / (9.42477796076938 * b) * xp.where(v1, a, 0.5 * b)
    return xp.where(v1, v8, E_star * xp.tan(theta) / 3.141592653589793 * v28)


def depth_beyond(xp, a, root, theta, b):
    return xp.tan(theta) * a * (xp.arctan(root / b) + b / (root + a))


def radius_from_depth(xp, d, theta, b):
    v1 = depth_beyond(xp, b, 0.0, theta, b)
    v2 = d > v1
    v3 = xp.where(v2, d, 2.0 * v1)
    v4 = v3 > v1
    v6 = xp.where(v4, 0.5 * v1, v3)
    v9 = xp.where(v4, xp.where(v4, v3, 2.0 * v1), 2.0 * v1) - v1
    v10 = b * 1.4142135623730951
    v12 = depth_beyond(xp, v10, b, theta, b) - v1
    v13 = 1.1102230246251565e-16 * v1
    v14 = 16.0 * v13
    v15 = v12 > v14
    v17 = xp.where(v15, 0.5 * v14, v12)
    v21 = v10 * slope_beyond(xp, v10, b, theta, b) * 0.5 / 2.0
    v24 = xp.where(v15, xp.where(v15, v12, 2.0 * v14), xp.maximum(v21, 1.1102230246251565e-16 * v13))
    v26 = xp.log(v9 / v24)
    v33 = (xp.maximum(v10 * slope_beyond(xp, v10, b, theta, b) * 0.5 / v24, 1.0) - 2.0) / -1.0
    v35 = xp.minimum(xp.maximum(v33, 1e-12), 0.999999999999)
    v40 = 0.75 * (v26 - xp.log(1.0 / (1.0 - v35)))
    v44 = 1.5 * (v26 - xp.log(1.0 / v35))

    def f53(v54):
        v55 = v54 * v54
        v56 = 1.0 + v55
        v58 = b * xp.sqrt(v56)
        v59 = b * v54
        v61 = depth_beyond(xp, v58, v59, theta, b) - v1
        v62 = v61 > v14
        v64 = xp.where(v62, 0.5 * v14, v61)
        v69 = v58 * slope_beyond(xp, v58, v59, theta, b) * (v55 / v56) / 2.0
        v72 = xp.where(v62, xp.where(v62, v61, 2.0 * v14), xp.maximum(v69, 1.1102230246251565e-16 * v13))
        v78 = xp.maximum(v58 * slope_beyond(xp, v58, v59, theta, b) * (v55 / v56) / v72, 1.0)
        return (v72, v78)
    v53 = xp.exp((xp.maximum(v40, v44) + xp.log1p(xp.exp(-xp.absolute(v40 - v44)))) / 1.5)
    v79 = newton(xp, f53, v9, v53, xp.inf, 1.0, xp.inf)
    v84 = xp.where(v2, 0.5 * v1, d)
    v85 = v84 > v1
    v86 = xp.where(v85, v84, 2.0 * v1)
    v89 = xp.where(v85, v1, xp.where(v85, 0.5 * v1, v84)) / v1
    v93 = v89 ** 0.5
    v101 = v93 + v93 * ((v89 / (v93 ** 2.0 * v93 ** 0.0) - 1.0) / 2.0)
    v103 = b * xp.where((v89 > 0.0) & (v89 < xp.inf), v101, v93)
    return xp.where(v2, b * xp.sqrt(1.0 + v79 * v79), v103)


def force_beyond(xp, a, root, theta, b, E_star):
    v3 = a ** 2.0
    v15 = v3 * xp.arctan(root / b) + 4.0 * b * v3 / (3.0 * (root + a)) + b / 3.0 * root
    return E_star * xp.tan(theta) * v15


def radius_from_force(xp, F, theta, b, E_star):
    v1 = force_beyond(xp, b, 0.0, theta, b, E_star)
    v2 = F > v1
    v3 = xp.where(v2, F, 2.0 * v1)
    v4 = v3 > v1
    v6 = xp.where(v4, 0.5 * v1, v3)
    v9 = xp.where(v4, xp.where(v4, v3, 2.0 * v1), 2.0 * v1) - v1
    v10 = b * 1.4142135623730951
    v12 = force_beyond(xp, v10, b, theta, b, E_star) - v1
    v13 = 1.1102230246251565e-16 * v1
    v14 = 16.0 * v13
    v15 = v12 > v14
    v17 = xp.where(v15, 0.5 * v14, v12)
    v24 = 2.0 * E_star * v10 ** 2.0 * slope_beyond(xp, v10, b, theta, b) * 0.5 / 2.0
    v27 = xp.where(v15, xp.where(v15, v12, 2.0 * v14), xp.maximum(v24, 1.1102230246251565e-16 * v13))
    v29 = xp.log(v9 / v27)
    v30 = v29 < 0.0
    v31 = 2.0 * E_star
    v39 = xp.where(v30, 1.0, v29)
    v38 = xp.maximum(v31 * v10 ** 2.0 * slope_beyond(xp, v10, b, theta, b) * 0.5 / v27, 1.0)

    def f42(v43):
        v44 = v43 * v43
        v45 = 1.0 + v44
        v47 = b * xp.sqrt(v45)
        v48 = b * v43
        v50 = force_beyond(xp, v47, v48, theta, b, E_star) - v1
        v51 = v50 > v14
        v53 = xp.where(v51, 0.5 * v14, v50)
        v60 = v31 * v47 ** 2.0 * slope_beyond(xp, v47, v48, theta, b) * (v44 / v45) / 2.0
        v63 = xp.where(v51, xp.where(v51, v50, 2.0 * v14), xp.maximum(v60, 1.1102230246251565e-16 * v13))
        v70 = v31 * v47 ** 2.0 * slope_beyond(xp, v47, v48, theta, b) * (v44 / v45) / v63
        return (v63, xp.maximum(v70, 1.0))
    v72 = newton(xp, f42, v9, xp.exp(v29 / xp.where(v30, v38, 2.0)), xp.inf, 1.0, xp.inf)
    v77 = xp.where(v2, 0.5 * v1, F)
    v78 = v77 > v1
    v79 = xp.where(v78, v77, 2.0 * v1)
    v82 = xp.where(v78, v1, xp.where(v78, 0.5 * v1, v77)) / v1
    v86 = v82 ** 0.3333333333333333
    v95 = v86 + v86 * ((v82 / (v86 * v86 ** 2.0 * v86 ** 0.0) - 1.0) / 3.0)
    v97 = b * xp.where((v82 > 0.0) & (v82 < xp.inf), v95, v86)
    return xp.where(v2, b * xp.sqrt(1.0 + v72 * v72), v97)


def force_from_depth(xp, d, theta, b, E_star):
    v1 = radius_from_depth(xp, d, theta, b)
    v10 = 2.0 * E_star * v1 * (d - depth(xp, v1, theta, b))
    return force(xp, v1, theta, b, E_star) + xp.where((v1 > 0.0) & (v1 < xp.inf), v10, 0.0)


def depth_from_force(xp, F, theta, b, E_star):
    v1 = radius_from_force(xp, F, theta, b, E_star)
    v10 = (F - force(xp, v1, theta, b, E_star)) / (2.0 * E_star * v1)
    return depth(xp, v1, theta, b) + xp.where((v1 > 0.0) & (v1 < xp.inf), v10, 0.0)


def energy(xp, a, theta, b, E_star):
    v4, v5 = nodes_along(xp, 1, a, theta, b, E_star)
    v1 = xp.minimum(a, b)
    v3 = xp.arcsinh(v1 / v1)
    v6 = v4 * v3
    v17 = 0.0 - xp.expm1(-2.0 * v3)
    v18 = v17 > 0.0
    v14 = xp.exp(-v6) * (0.0 - xp.expm1(-2.0 * (v3 - v6)))
    v22 = v1 * (v14 / xp.where(v18, xp.where(v18, v17, 1.0), xp.inf))
    v24 = depth(xp, a, theta, b) - depth(xp, v22, theta, b)
    v32 = a > b
    v33 = xp.where(v32, a, 2.0 * b)
    v34 = difference_root(xp, v33, b)
    v36 = xp.arcsinh(v34 / b)
    v37 = v4 * v36
    v49 = 0.0 - xp.expm1(-2.0 * v36)
    v50 = v49 > 0.0
    v46 = xp.exp(-v37) * (0.0 - xp.expm1(-2.0 * (v36 - v37)))
    v54 = v34 * (v46 / xp.where(v50, xp.where(v50, v49, 1.0), xp.inf))
    v59 = depth(xp, v33, theta, b) - depth_beyond(xp, xp.sqrt(b * b + v54 * v54), v54, theta, b)
    v63 = xp.where(v32, 0.5 * b, a)
    v31 = v3 * xp.sum(v5 * (v24 * v24 * xp.sqrt(v1 * v1 + v22 * v22)), axis=0)
    return E_star * (v31 + xp.where(v32, v36 * xp.sum(v5 * (v59 * v59 * v54), axis=0), 0.0))


def load_within(xp, r, a, theta, b, E_star):
    v12, v13 = nodes_along(xp, 1, r, a, theta, b, E_star)
    v4 = xp.minimum(a, b)
    v5 = xp.minimum(r, v4)
    v6 = v5 > 0.0
    v7 = xp.where(v6, v5, 1.0)
    v8 = v7 * v7
    v9 = difference_root(xp, v4, v7)
    v11 = xp.arcsinh(v9 / v7)
    v14 = v12 * v11
    v24 = 0.0 - xp.expm1(-2.0 * v11)
    v25 = v24 > 0.0
    v21 = xp.exp(-v14) * (0.0 - xp.expm1(-2.0 * (v11 - v14)))
    v29 = v9 * (v21 / xp.where(v25, xp.where(v25, v24, 1.0), xp.inf))
    v32 = xp.sqrt(v8 + v29 * v29)
    v38 = v8 * (v11 * xp.sum(v13 * (slope(xp, v32, theta, b) * (v29 / (v32 + v29))), axis=0))
    v42 = xp.where(r == b, b * 1.0000000000000002, r)
    v43 = xp.maximum(v42, b)
    v44 = a > v43
    v45 = xp.where(v44, a, 2.0 * v43)
    v47 = v42 < b
    v48 = xp.where(v47, v42, 0.5 * b)
    v51 = difference_root(xp, v45, xp.where(v47, 2.0 * b, v42))
    v52 = xp.where(v47, difference_root(xp, v45, b), v51)
    v59 = xp.arcsinh(v52 / xp.sqrt(xp.absolute(v42 - b) * (v42 + b)))
    v60 = v12 * v59
    v64 = xp.exp(-v60)
    v65 = xp.where(v47, v42, 0.5 * b)
    v66 = xp.where(v47, 2.0 * b, v42)
    v67 = xp.where(v47, 0.0, 1.0)
    v68 = 2.0 * v67
    v69 = 1.0 - v68
    v72 = xp.expm1(-2.0 * (v59 - v60))
    v77 = xp.expm1(-2.0 * v59)
    v79 = v68 - v69 * v77
    v80 = v79 > 0.0
    v83 = v64 * (v68 - v69 * v72) / xp.where(v80, xp.where(v80, v79, 1.0), xp.inf)
    v84 = difference_root(xp, v45, b) * v83
    v87 = xp.sqrt(b * b + v84 * v84)
    v93 = 2.0 * (1.0 - v67)
    v94 = 1.0 - v93
    v99 = v93 - v94 * v77
    v100 = v99 > 0.0
    v103 = v64 * (v93 - v94 * v72) / xp.where(v100, xp.where(v100, v99, 1.0), xp.inf)
    v104 = difference_root(xp, v45, v42) * v103
    v107 = slope_beyond(xp, v87, v84, theta, b) * (v84 / v87) * (v104 / (v87 + v104))
    v110 = xp.where(v44, 0.5 * v43, a)
    v111 = xp.where(v44, v42 * v42 * (v59 * xp.sum(v13 * v107, axis=0)), 0.0)
    v113 = 2.0 * E_star * (xp.where(v6, v38, 0.0) + v111)
    return force(xp, xp.minimum(r, a), theta, b, E_star) + v113
