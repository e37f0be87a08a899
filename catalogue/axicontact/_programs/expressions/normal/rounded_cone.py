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
    v2 = depth_beyond(xp, b, 1e-100 * b, theta, b)
    v3 = d > v2
    v4 = xp.where(v3, d, 2.0 * v2)
    v5 = v4 > v2
    v7 = xp.where(v5, 0.5 * v2, v4)
    v10 = xp.where(v5, xp.where(v5, v4, 2.0 * v2), 2.0 * v2) - v2
    v11 = b * 1.4142135623730951
    v13 = depth_beyond(xp, v11, b, theta, b) - v2
    v14 = 1.1102230246251565e-16 * v2
    v15 = 16.0 * v14
    v16 = v13 > v15
    v18 = xp.where(v16, 0.5 * v15, v13)
    v22 = v11 * slope_beyond(xp, v11, b, theta, b) * 0.5 / 2.0
    v25 = xp.where(v16, xp.where(v16, v13, 2.0 * v15), xp.maximum(v22, 1.1102230246251565e-16 * v14))
    v27 = xp.log(v10 / v25)
    v34 = (xp.maximum(v11 * slope_beyond(xp, v11, b, theta, b) * 0.5 / v25, 1.0) - 2.0) / -1.0
    v36 = xp.minimum(xp.maximum(v34, 1e-12), 0.999999999999)
    v41 = 0.75 * (v27 - xp.log(1.0 / (1.0 - v36)))
    v45 = 1.5 * (v27 - xp.log(1.0 / v36))

    def f54(v55):
        v56 = v55 * v55
        v57 = 1.0 + v56
        v59 = b * xp.sqrt(v57)
        v60 = b * v55
        v62 = depth_beyond(xp, v59, v60, theta, b) - v2
        v63 = v62 > v15
        v65 = xp.where(v63, 0.5 * v15, v62)
        v70 = v59 * slope_beyond(xp, v59, v60, theta, b) * (v56 / v57) / 2.0
        v73 = xp.where(v63, xp.where(v63, v62, 2.0 * v15), xp.maximum(v70, 1.1102230246251565e-16 * v14))
        v79 = xp.maximum(v59 * slope_beyond(xp, v59, v60, theta, b) * (v56 / v57) / v73, 1.0)
        return (v73, v79)
    v54 = xp.exp((xp.maximum(v41, v45) + xp.log1p(xp.exp(-xp.absolute(v41 - v45)))) / 1.5)
    v80 = newton(xp, f54, v10, v54, xp.inf, 1.0, xp.inf)
    v85 = xp.where(v3, 0.5 * v2, d)
    v86 = v85 > v2
    v87 = xp.where(v86, v85, 2.0 * v2)
    v90 = xp.where(v86, v2, xp.where(v86, 0.5 * v2, v85)) / v2
    v94 = v90 ** 0.5
    v102 = v94 + v94 * ((v90 / (v94 ** 2.0 * v94 ** 0.0) - 1.0) / 2.0)
    v104 = b * xp.where((v90 > 0.0) & (v90 < xp.inf), v102, v94)
    return xp.where(v3, b * xp.sqrt(1.0 + v80 * v80), v104)


def force_beyond(xp, a, root, theta, b, E_star):
    v3 = a ** 2.0
    v15 = v3 * xp.arctan(root / b) + 4.0 * b * v3 / (3.0 * (root + a)) + b / 3.0 * root
    return E_star * xp.tan(theta) * v15


def radius_from_force(xp, F, theta, b, E_star):
    v2 = force_beyond(xp, b, 1e-100 * b, theta, b, E_star)
    v3 = F > v2
    v4 = xp.where(v3, F, 2.0 * v2)
    v5 = v4 > v2
    v7 = xp.where(v5, 0.5 * v2, v4)
    v10 = xp.where(v5, xp.where(v5, v4, 2.0 * v2), 2.0 * v2) - v2
    v11 = b * 1.4142135623730951
    v13 = force_beyond(xp, v11, b, theta, b, E_star) - v2
    v14 = 1.1102230246251565e-16 * v2
    v15 = 16.0 * v14
    v16 = v13 > v15
    v18 = xp.where(v16, 0.5 * v15, v13)
    v25 = 2.0 * E_star * v11 ** 2.0 * slope_beyond(xp, v11, b, theta, b) * 0.5 / 2.0
    v28 = xp.where(v16, xp.where(v16, v13, 2.0 * v15), xp.maximum(v25, 1.1102230246251565e-16 * v14))
    v30 = xp.log(v10 / v28)
    v31 = v30 < 0.0
    v32 = 2.0 * E_star
    v40 = xp.where(v31, 1.0, v30)
    v39 = xp.maximum(v32 * v11 ** 2.0 * slope_beyond(xp, v11, b, theta, b) * 0.5 / v28, 1.0)

    def f43(v44):
        v45 = v44 * v44
        v46 = 1.0 + v45
        v48 = b * xp.sqrt(v46)
        v49 = b * v44
        v51 = force_beyond(xp, v48, v49, theta, b, E_star) - v2
        v52 = v51 > v15
        v54 = xp.where(v52, 0.5 * v15, v51)
        v61 = v32 * v48 ** 2.0 * slope_beyond(xp, v48, v49, theta, b) * (v45 / v46) / 2.0
        v64 = xp.where(v52, xp.where(v52, v51, 2.0 * v15), xp.maximum(v61, 1.1102230246251565e-16 * v14))
        v71 = v32 * v48 ** 2.0 * slope_beyond(xp, v48, v49, theta, b) * (v45 / v46) / v64
        return (v64, xp.maximum(v71, 1.0))
    v73 = newton(xp, f43, v10, xp.exp(v30 / xp.where(v31, v39, 2.0)), xp.inf, 1.0, xp.inf)
    v78 = xp.where(v3, 0.5 * v2, F)
    v79 = v78 > v2
    v80 = xp.where(v79, v78, 2.0 * v2)
    v83 = xp.where(v79, v2, xp.where(v79, 0.5 * v2, v78)) / v2
    v87 = v83 ** 0.3333333333333333
    v96 = v87 + v87 * ((v83 / (v87 * v87 ** 2.0 * v87 ** 0.0) - 1.0) / 3.0)
    v98 = b * xp.where((v83 > 0.0) & (v83 < xp.inf), v96, v87)
    return xp.where(v3, b * xp.sqrt(1.0 + v73 * v73), v98)


def force_from_depth(xp, d, theta, b, E_star):
    v1 = radius_from_depth(xp, d, theta, b)
    v10 = 2.0 * E_star * v1 * (d - depth(xp, v1, theta, b))
    return force(xp, v1, theta, b, E_star) + xp.where((v1 > 0.0) & (v1 < xp.inf), v10, 0.0)


def depth_from_force(xp, F, theta, b, E_star):
    v1 = radius_from_force(xp, F, theta, b, E_star)
    v10 = (F - force(xp, v1, theta, b, E_star)) / (2.0 * E_star * v1)
    return depth(xp, v1, theta, b) + xp.where((v1 > 0.0) & (v1 < xp.inf), v10, 0.0)
