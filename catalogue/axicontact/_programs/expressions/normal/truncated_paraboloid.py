"""Formulas of axicontact.normal.truncated_paraboloid over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def depth(xp, a, R, b):
    return a * xp.sqrt((a - b) * (a + b)) / R


def force_at(xp, a, root, R, b, E_star):
    return 2.0 * E_star / (3.0 * R) * (2.0 * a ** 2.0 + b ** 2.0) * root


def force(xp, a, R, b, E_star):
    return force_at(xp, a, xp.sqrt((a - b) * (a + b)), R, b, E_star)


def slope_beyond(xp, t, root, R, b):
    return 2.0 * root / R + b ** 2.0 / (R * root)


def pressure(xp, r, a, R, b, E_star):
    v27, v28 = nodes_along(xp, 1, r, a, R, b, E_star)
    v1 = a >= b
    v2 = xp.where(v1, a, 2.0 * b)
    v3 = r < v2
    v4 = xp.where(v3, r, 0.5 * v2)
    v5 = v4 == b
    v10 = xp.where(v5, b * 1.0000000000000002, v4)
    v11 = xp.maximum(v10, b)
    v12 = v2 > v11
    v13 = xp.where(v12, v2, 2.0 * v11)
    v14 = v10 < b
    v15 = xp.where(v14, v10, 0.5 * b)
    v18 = difference_root(xp, v13, xp.where(v14, 2.0 * b, v10))
    v19 = xp.where(v14, difference_root(xp, v13, b), v18)
    v26 = xp.arcsinh(v19 / xp.sqrt(xp.absolute(v10 - b) * (v10 + b)))
    v29 = v27 * v26
    v34 = xp.where(v14, v10, 0.5 * b)
    v35 = xp.where(v14, 2.0 * b, v10)
    v37 = 2.0 * xp.where(v14, 0.0, 1.0)
    v38 = 1.0 - v37
    v48 = v37 - v38 * xp.expm1(-2.0 * v26)
    v49 = v48 > 0.0
    v44 = xp.exp(-v29) * (v37 - v38 * xp.expm1(-2.0 * (v26 - v29)))
    v53 = difference_root(xp, v13, b) * (v44 / xp.where(v49, xp.where(v49, v48, 1.0), xp.inf))
    v56 = xp.sqrt(b * b + v53 * v53)
    v61 = xp.where(v12, 0.5 * v11, v2)
    v60 = v26 * xp.sum(v28 * (slope_beyond(xp, v56, v53, R, b) * v53 / v56), axis=0)
    v65 = xp.where(v3, 2.0 * v2, r)
    v64 = xp.where(v5 & (v2 > b), xp.inf, E_star / 3.141592653589793 * xp.where(v12, v60, 0.0))
    v67 = xp.where(v1, 0.5 * b, a)
    return xp.where(v1, xp.where(v3, v64, 0.0), xp.nan)


def profile(xp, r, R, b):
    v1 = r < b
    v2 = xp.where(v1, r, 0.5 * b)
    v3 = xp.where(v1, 2.0 * b, r)
    return xp.where(v1, 0.0, (v3 - b) * (v3 + b) / (2.0 * R))


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
    v7 = xp.sqrt((a - b) * (a + b))
    v16 = 2.0 * E_star * b ** 2.0 * v7 / (9.42477796076938 * a ** 2.0 * R)
    return 4.0 * E_star / (9.42477796076938 * R) * v7 + v16


def radius_from_depth(xp, d, R, b):
    v1 = b ** 2.0
    v12 = xp.sqrt(xp.sqrt(v1 ** 2.0 + 4.0 * R ** 2.0 * d ** 2.0) / R + v1 / R)
    return v12 * xp.sqrt(2.0 * R) / 2.0


def radius_from_force(xp, F, R, b, E_star):
    v4 = xp.log(F / force_at(xp, b * 1.4142135623730951, b, R, b, E_star))
    v6 = -1.75 * (v4 - -0.5108256237659907)
    v8 = -0.5833333333333334 * (v4 - -0.916290731874155)
    v17 = xp.exp((xp.maximum(v6, v8) + xp.log1p(xp.exp(-xp.absolute(v6 - v8)))) / -1.75)
    v20 = 1.0 - 1.0 / (1.0 + v17)
    v28 = (((19.09787 * v20 + -63.48232) * v20 + 76.63965) * v20 + -39.30687) * v20 + 7.512052

    def f35(v36):
        v40 = b * xp.sqrt(1.0 + v36 * v36)
        v41 = b * v36
        v42 = force_at(xp, v40, v41, R, b, E_star)
        return (v42, 2.0 * E_star * v41 * v41 * slope_beyond(xp, v40, v41, R, b) / v42)
    v35 = v17 * (((v28 * v20 + -0.7678073) * v20 + 0.3089073) * v20 + 0.9990587)
    v49 = newton(xp, f35, F, v35, xp.inf, 1.0, 3.0)
    return b * xp.sqrt(1.0 + v49 * v49)


def force_from_depth(xp, d, R, b, E_star):
    v6 = xp.log(d / (b * 1.4142135623730951 * b / R)) - -0.346583180371942
    v7 = -3.0 * v6
    v8 = -1.5 * v6
    v17 = xp.exp((xp.maximum(v7, v8) + xp.log1p(xp.exp(-xp.absolute(v7 - v8)))) / -3.0)
    v20 = 1.0 - 1.0 / (1.0 + v17)
    v28 = (((8.200478 * v20 + -25.52146) * v20 + 28.05264) * v20 + -12.15272) * v20 + 1.353675

    def f35(v36):
        v40 = b * xp.sqrt(1.0 + v36 * v36)
        v41 = b * v36
        v43 = v40 * v41 / R
        return (v43, v41 * v41 / v40 * slope_beyond(xp, v40, v41, R, b) / v43)
    v35 = v17 * (((v28 * v20 + 0.009062067) * v20 + 0.05914493) * v20 + 0.9996917)
    v49 = newton(xp, f35, d, v35, xp.inf, 1.0, 2.0)
    v53 = b * xp.sqrt(1.0 + v49 * v49)
    v54 = b * v49
    v65 = xp.where((v53 > 0.0) & (v53 < xp.inf), 2.0 * E_star * v53 * (d - v53 * v54 / R), 0.0)
    return force_at(xp, v53, v54, R, b, E_star) + v65


def depth_from_force(xp, F, R, b, E_star):
    v4 = xp.log(F / force_at(xp, b * 1.4142135623730951, b, R, b, E_star))
    v6 = -1.75 * (v4 - -0.5108256237659907)
    v8 = -0.5833333333333334 * (v4 - -0.916290731874155)
    v17 = xp.exp((xp.maximum(v6, v8) + xp.log1p(xp.exp(-xp.absolute(v6 - v8)))) / -1.75)
    v20 = 1.0 - 1.0 / (1.0 + v17)
    v28 = (((19.09787 * v20 + -63.48232) * v20 + 76.63965) * v20 + -39.30687) * v20 + 7.512052

    def f35(v36):
        v40 = b * xp.sqrt(1.0 + v36 * v36)
        v41 = b * v36
        v42 = force_at(xp, v40, v41, R, b, E_star)
        return (v42, 2.0 * E_star * v41 * v41 * slope_beyond(xp, v40, v41, R, b) / v42)
    v35 = v17 * (((v28 * v20 + -0.7678073) * v20 + 0.3089073) * v20 + 0.9990587)
    v49 = newton(xp, f35, F, v35, xp.inf, 1.0, 3.0)
    v53 = b * xp.sqrt(1.0 + v49 * v49)
    v54 = b * v49
    v64 = (F - force_at(xp, v53, v54, R, b, E_star)) / (2.0 * E_star * v53)
    return v53 * v54 / R + xp.where((v53 > 0.0) & (v53 < xp.inf), v64, 0.0)


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
    v36 = depth(xp, v7, R, b) - xp.sqrt(b * b + v30 * v30) * v30 / R
    v40 = xp.where(v6, 0.5 * b, v2)
    v44 = xp.where(v1, 0.5 * b, a)
    v43 = E_star * (b * v3 * v3 + xp.where(v6, v10 * xp.sum(v12 * (v36 * v36 * v30), axis=0), 0.0))
    return xp.where(v1, v43, xp.nan)


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
