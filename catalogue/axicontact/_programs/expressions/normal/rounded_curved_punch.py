"""Formulas of axicontact.normal.rounded_curved_punch over an array library `xp`."""

from ...._programs.expressions._runtime.functions import half_tangent
from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.special import arctan_gap
from ...._programs.expressions._runtime.special import root_gap
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def depth(xp, a, R1, R2, b):
    v1 = a < b
    v5 = xp.where(v1, 2.0 * b, a)
    v11 = v5 * (v5 / R1 + b / R2 * root_gap(xp, v5, b))
    return xp.where(v1, xp.where(v1, a, 0.5 * b) ** 2.0 / R1, v11)


def force(xp, a, R1, R2, b, E_star):
    v1 = a < b
    v2 = xp.where(v1, a, 0.5 * b)
    v9 = xp.where(v1, 2.0 * b, a)
    v10 = v9 ** 2.0
    v22 = (v9 - b) * (v9 + b)
    v19 = 4.0 * (v9 * v10) / (3.0 * R1) + b / R2 * v10 * root_gap(xp, v9, b)
    v28 = E_star * (v19 + v22 * xp.sqrt(v22) / (3.0 * R2))
    return xp.where(v1, 4.0 * E_star / (3.0 * R1) * (v2 * v2 ** 2.0), v28)


def slope_beyond(xp, t, root, R1, R2, b):
    return 2.0 * t / R1 + 2.0 * root / R2 - b / R2 * xp.arctan2(root, b)


def pressure(xp, r, a, R1, R2, b, E_star):
    v36, v37 = nodes_along(xp, 1, r, a, R1, R2, b, E_star)
    v1 = r < a
    v2 = xp.where(v1, r, 0.5 * a)
    v3 = xp.minimum(a, b)
    v4 = v2 < v3
    v5 = xp.where(v4, v2, 0.5 * v3)
    v14 = xp.where(v4, 2.0 * v3, v2)
    v13 = 2.0 * E_star / (3.141592653589793 * R1) * xp.sqrt((v3 - v5) * (v3 + v5))
    v19 = xp.where(v2 == b, b * 1.0000000000000002, v2)
    v20 = xp.maximum(v19, b)
    v21 = a > v20
    v22 = xp.where(v21, a, 2.0 * v20)
    v23 = v19 < b
    v24 = xp.where(v23, v19, 0.5 * b)
    v27 = difference_root(xp, v22, xp.where(v23, 2.0 * b, v19))
    v28 = xp.where(v23, difference_root(xp, v22, b), v27)
    v35 = xp.arcsinh(v28 / xp.sqrt(xp.absolute(v19 - b) * (v19 + b)))
    v38 = v36 * v35
    v43 = xp.where(v23, v19, 0.5 * b)
    v44 = xp.where(v23, 2.0 * b, v19)
    v46 = 2.0 * xp.where(v23, 0.0, 1.0)
    v47 = 1.0 - v46
    v57 = v46 - v47 * xp.expm1(-2.0 * v35)
    v58 = v57 > 0.0
    v53 = xp.exp(-v38) * (v46 - v47 * xp.expm1(-2.0 * (v35 - v38)))
    v62 = difference_root(xp, v22, b) * (v53 / xp.where(v58, xp.where(v58, v57, 1.0), xp.inf))
    v65 = xp.sqrt(b * b + v62 * v62)
    v70 = xp.where(v21, 0.5 * v20, a)
    v69 = v35 * xp.sum(v37 * (slope_beyond(xp, v65, v62, R1, R2, b) * v62 / v65), axis=0)
    v74 = xp.where(v1, 2.0 * a, r)
    v73 = xp.where(v4, v13, 0.0) + E_star / 3.141592653589793 * xp.where(v21, v69, 0.0)
    return xp.where(v1, v73, 0.0)


def profile(xp, r, R1, R2, b):
    v1 = r < b
    v6 = xp.where(v1, 2.0 * b, r)
    v14 = v6 ** 2.0 / (2.0 * R1) + (v6 - b) ** 2.0 / (2.0 * R2)
    return xp.where(v1, xp.where(v1, r, 0.5 * b) ** 2.0 / (2.0 * R1), v14)


def displacement(xp, r, a, R1, R2, b):
    v57, v58 = nodes_along(xp, 1, r, a, R1, R2, b)
    v1 = r > a
    v2 = xp.where(v1, r, 2.0 * a)
    v3 = xp.minimum(a, b)
    v9 = half_tangent(xp, v2, v3)
    v10 = v9 * v9
    v15 = ((-0.7327347664453868 * v10 + -32.15553480435792) * v10 + -332.23363563146734) * v10
    v21 = (((v15 + -1070.7082873491413) * v10 + -85.27694715374247) * v10 + 5044.821368830373) * v10
    v31 = ((0.21387262524856868 * v10 + 32.12935731379798) * v10 + 746.8124983579742) * v10
    v37 = (((v31 + 6202.125133759036) * v10 + 23553.080984642995) * v10 + 44404.005348491315) * v10
    v26 = ((v21 + 8082.413158212496) * v10 + 3759.725330928701) * v10 + 0.26666666666720995
    v44 = v10 * (v26 / (((v37 + 40380.01430284195) * v10 + 14099.684276696918) * v10 + 1.0))
    v48 = a > b
    v49 = xp.where(v48, a, 2.0 * b)
    v50 = difference_root(xp, v2, b)
    v53 = difference_root(xp, v49, b) / difference_root(xp, v2, v49)
    v54 = b / v2
    v56 = xp.arcsinh(v53 / v54)
    v59 = v57 * v56
    v70 = 0.0 - xp.expm1(-2.0 * v56)
    v71 = v70 > 0.0
    v67 = xp.exp(-v59) * (0.0 - xp.expm1(-2.0 * (v56 - v59)))
    v75 = v53 * (v67 / xp.where(v71, xp.where(v71, v70, 1.0), xp.inf))
    v77 = v75 * v75
    v79 = xp.sqrt(1.0 + v77)
    v80 = v50 * v75 / v79
    v83 = xp.sqrt(b * b + v80 * v80)
    v89 = slope_beyond(xp, v83, v80, R1, R2, b) * v80 / v83 * xp.arctan2(v83, v50 / v79)
    v99 = xp.where(v48, 0.5 * b, a)
    v98 = v50 * (v56 * xp.sum(v58 * (v89 * (xp.sqrt(v54 * v54 + v77) / (v79 * v79 * v79))), axis=0))
    v47 = 2.0 * v3 ** 2.0 / (3.141592653589793 * R1) * (v3 / v2 * (0.6666666666666666 + v44))
    v106 = depth(xp, a, R1, R2, b) - profile(xp, xp.where(v1, 0.5 * a, r), R1, R2, b)
    return xp.where(v1, v47 + 0.6366197723675814 * xp.where(v48, v98, 0.0), v106)


def stiffness(xp, a, E_star):
    return 2.0 * E_star * a


def mean_pressure(xp, a, R1, R2, b, E_star):
    v1 = a < b
    v7 = xp.where(v1, 2.0 * b, a)
    v18 = (v7 - b) * (v7 + b)
    v15 = 4.0 * v7 / (3.0 * R1) + b / R2 * root_gap(xp, v7, b)
    v26 = E_star / 3.141592653589793 * (v15 + v18 * xp.sqrt(v18) / (3.0 * v7 ** 2.0 * R2))
    v27 = xp.where(v1, 4.0 * E_star / (9.42477796076938 * R1) * xp.where(v1, a, 0.5 * b), v26)
    return v27


def depth_beyond(xp, a, root, R1, R2, b):
    return a * (a / R1 + b / R2 * arctan_gap(xp, root / b))


def radius_from_depth(xp, d, R1, R2, b):
    v1 = depth_beyond(xp, b, 0.0, R1, R2, b)
    v2 = d > v1
    v3 = xp.where(v2, d, 2.0 * v1)
    v4 = v3 > v1
    v6 = xp.where(v4, 0.5 * v1, v3)
    v9 = xp.where(v4, xp.where(v4, v3, 2.0 * v1), 2.0 * v1) - v1
    v13 = 1.1102230246251565e-16 * v1
    v14 = xp.maximum(depth_beyond(xp, b * 1.4142135623730951, b, R1, R2, b) - v1, v13)
    v16 = xp.log(v9 / v14)
    v17 = v16 < 0.0
    v18 = xp.minimum(v16, 0.0)
    v19 = v1 / v14
    v20 = xp.log(v19)
    v22 = -1.25 * (v18 - v20)
    v25 = xp.log(xp.maximum(1.0 - v19, 1e-300))
    v27 = -0.8333333333333334 * (v18 - v25)
    v38 = xp.maximum(xp.where(v17, 1.0, v16), 0.0)
    v40 = -1.0 * (v38 - v20)
    v42 = -1.0 * (v38 - v25)
    v36 = xp.exp((xp.maximum(v22, v27) + xp.log1p(xp.exp(-xp.absolute(v22 - v27)))) / -2.5)
    v51 = xp.exp((xp.maximum(v40, v42) + xp.log1p(xp.exp(-xp.absolute(v40 - v42)))) / -2.0)

    def f52(v53):
        v54 = v53 * v53
        v55 = 1.0 + v54
        v57 = b * xp.sqrt(v55)
        v58 = b * v53
        v61 = xp.maximum(depth_beyond(xp, v57, v58, R1, R2, b) - v1, v13)
        v67 = xp.maximum(v57 * slope_beyond(xp, v57, v58, R1, R2, b) * (v54 / v55) / v61, 1.0)
        return (v61, v67)
    v68 = newton(xp, f52, v9, xp.where(v17, v36, v51), xp.inf, 1.0, xp.inf)
    v73 = xp.where(v2, 0.5 * v1, d)
    v74 = v73 > v1
    v75 = xp.where(v74, v73, 2.0 * v1)
    v78 = xp.where(v74, v1, xp.where(v74, 0.5 * v1, v73)) / v1
    v82 = v78 ** 0.5
    v90 = v82 + v82 * ((v78 / (v82 ** 2.0 * v82 ** 0.0) - 1.0) / 2.0)
    v92 = b * xp.where((v78 > 0.0) & (v78 < xp.inf), v90, v82)
    return xp.where(v2, b * xp.sqrt(1.0 + v68 * v68), v92)


def force_beyond(xp, a, root, R1, R2, b, E_star):
    v1 = a ** 2.0
    v10 = 4.0 * (a * v1) / (3.0 * R1) + root * root ** 2.0 / (3.0 * R2)
    return E_star * (v10 + b / R2 * v1 * arctan_gap(xp, root / b))


def radius_from_force(xp, F, R1, R2, b, E_star):
    v1 = force_beyond(xp, b, 0.0, R1, R2, b, E_star)
    v2 = F > v1
    v3 = xp.where(v2, F, 2.0 * v1)
    v4 = v3 > v1
    v6 = xp.where(v4, 0.5 * v1, v3)
    v9 = xp.where(v4, xp.where(v4, v3, 2.0 * v1), 2.0 * v1) - v1
    v13 = 1.1102230246251565e-16 * v1
    v14 = xp.maximum(force_beyond(xp, b * 1.4142135623730951, b, R1, R2, b, E_star) - v1, v13)
    v16 = xp.log(v9 / v14)
    v17 = v16 < 0.0
    v18 = xp.minimum(v16, 0.0)
    v20 = v1 / v14 * 1.8284271247461903
    v21 = xp.log(v20)
    v23 = -1.25 * (v18 - v21)
    v26 = xp.log(xp.maximum(1.0 - v20, 1e-300))
    v28 = -0.8333333333333334 * (v18 - v26)
    v39 = xp.maximum(xp.where(v17, 1.0, v16), 0.0)
    v41 = -1.0 * (v39 - v21)
    v43 = -1.0 * (v39 - v26)
    v37 = xp.exp((xp.maximum(v23, v28) + xp.log1p(xp.exp(-xp.absolute(v23 - v28)))) / -2.5)
    v52 = xp.exp((xp.maximum(v41, v43) + xp.log1p(xp.exp(-xp.absolute(v41 - v43)))) / -3.0)

    def f53(v54):
        v55 = v54 * v54
        v56 = 1.0 + v55
        v58 = b * xp.sqrt(v56)
        v59 = b * v54
        v62 = xp.maximum(force_beyond(xp, v58, v59, R1, R2, b, E_star) - v1, v13)
        v70 = 2.0 * E_star * v58 ** 2.0 * slope_beyond(xp, v58, v59, R1, R2, b) * (v55 / v56) / v62
        return (v62, xp.maximum(v70, 1.0))
    v72 = newton(xp, f53, v9, xp.where(v17, v37, v52), xp.inf, 1.0, xp.inf)
    v77 = xp.where(v2, 0.5 * v1, F)
    v78 = v77 > v1
    v79 = xp.where(v78, v77, 2.0 * v1)
    v82 = xp.where(v78, v1, xp.where(v78, 0.5 * v1, v77)) / v1
    v86 = v82 ** 0.3333333333333333
    v95 = v86 + v86 * ((v82 / (v86 * v86 ** 2.0 * v86 ** 0.0) - 1.0) / 3.0)
    v97 = b * xp.where((v82 > 0.0) & (v82 < xp.inf), v95, v86)
    return xp.where(v2, b * xp.sqrt(1.0 + v72 * v72), v97)


def force_from_depth(xp, d, R1, R2, b, E_star):
    v1 = radius_from_depth(xp, d, R1, R2, b)
    v10 = 2.0 * E_star * v1 * (d - depth(xp, v1, R1, R2, b))
    return force(xp, v1, R1, R2, b, E_star) + xp.where((v1 > 0.0) & (v1 < xp.inf), v10, 0.0)


def depth_from_force(xp, F, R1, R2, b, E_star):
    v1 = radius_from_force(xp, F, R1, R2, b, E_star)
    v10 = (F - force(xp, v1, R1, R2, b, E_star)) / (2.0 * E_star * v1)
    return depth(xp, v1, R1, R2, b) + xp.where((v1 > 0.0) & (v1 < xp.inf), v10, 0.0)


def energy(xp, a, R1, R2, b, E_star):
    v4, v5 = nodes_along(xp, 1, a, R1, R2, b, E_star)
    v1 = xp.minimum(a, b)
    v3 = xp.arcsinh(v1 / v1)
    v6 = v4 * v3
    v17 = 0.0 - xp.expm1(-2.0 * v3)
    v18 = v17 > 0.0
    v14 = xp.exp(-v6) * (0.0 - xp.expm1(-2.0 * (v3 - v6)))
    v22 = v1 * (v14 / xp.where(v18, xp.where(v18, v17, 1.0), xp.inf))
    v24 = depth(xp, a, R1, R2, b) - depth(xp, v22, R1, R2, b)
    v32 = a > b
    v33 = xp.where(v32, a, 2.0 * b)
    v34 = difference_root(xp, v33, b)
    v36 = xp.arcsinh(v34 / b)
    v37 = v4 * v36
    v49 = 0.0 - xp.expm1(-2.0 * v36)
    v50 = v49 > 0.0
    v46 = xp.exp(-v37) * (0.0 - xp.expm1(-2.0 * (v36 - v37)))
    v54 = v34 * (v46 / xp.where(v50, xp.where(v50, v49, 1.0), xp.inf))
    v58 = depth_beyond(xp, xp.sqrt(b * b + v54 * v54), v54, R1, R2, b)
    v59 = depth(xp, v33, R1, R2, b) - v58
    v63 = xp.where(v32, 0.5 * b, a)
    v31 = v3 * xp.sum(v5 * (v24 * v24 * xp.sqrt(v1 * v1 + v22 * v22)), axis=0)
    return E_star * (v31 + xp.where(v32, v36 * xp.sum(v5 * (v59 * v59 * v54), axis=0), 0.0))


def load_within(xp, r, a, R1, R2, b, E_star):
    v12, v13 = nodes_along(xp, 1, r, a, R1, R2, b, E_star)
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
    v43 = xp.where(r == b, b * 1.0000000000000002, r)
    v44 = xp.maximum(v43, b)
    v45 = a > v44
    v46 = xp.where(v45, a, 2.0 * v44)
    v48 = v43 < b
    v49 = xp.where(v48, v43, 0.5 * b)
    v52 = difference_root(xp, v46, xp.where(v48, 2.0 * b, v43))
    v53 = xp.where(v48, difference_root(xp, v46, b), v52)
    v60 = xp.arcsinh(v53 / xp.sqrt(xp.absolute(v43 - b) * (v43 + b)))
    v61 = v12 * v60
    v65 = xp.exp(-v61)
    v66 = xp.where(v48, v43, 0.5 * b)
    v67 = xp.where(v48, 2.0 * b, v43)
    v68 = xp.where(v48, 0.0, 1.0)
    v69 = 2.0 * v68
    v70 = 1.0 - v69
    v73 = xp.expm1(-2.0 * (v60 - v61))
    v78 = xp.expm1(-2.0 * v60)
    v80 = v69 - v70 * v78
    v81 = v80 > 0.0
    v84 = v65 * (v69 - v70 * v73) / xp.where(v81, xp.where(v81, v80, 1.0), xp.inf)
    v85 = difference_root(xp, v46, b) * v84
    v88 = xp.sqrt(b * b + v85 * v85)
    v94 = 2.0 * (1.0 - v68)
    v95 = 1.0 - v94
    v100 = v94 - v95 * v78
    v101 = v100 > 0.0
    v104 = v65 * (v94 - v95 * v73) / xp.where(v101, xp.where(v101, v100, 1.0), xp.inf)
    v105 = difference_root(xp, v46, v43) * v104
    v108 = slope_beyond(xp, v88, v85, R1, R2, b) * (v85 / v88) * (v105 / (v88 + v105))
    v111 = xp.where(v45, 0.5 * v44, a)
    v40 = xp.where(v6, v8 * (v11 * xp.sum(v13 * (2.0 * v32 / R1 * (v29 / (v32 + v29))), axis=0)), 0.0)
    v114 = 2.0 * E_star * (v40 + xp.where(v45, v43 * v43 * (v60 * xp.sum(v13 * v108, axis=0)), 0.0))
    return force(xp, xp.minimum(r, a), R1, R2, b, E_star) + v114
