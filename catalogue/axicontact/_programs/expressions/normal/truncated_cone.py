"""Formulas of axicontact.normal.truncated_cone over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def depth_at(xp, a, root, theta, b):
    return xp.tan(theta) * a * xp.arctan(root / b)


def depth(xp, a, theta, b):
    return depth_at(xp, a, xp.sqrt((a - b) * (a + b)), theta, b)


def force_at(xp, a, root, theta, b, E_star):
    return E_star * xp.tan(theta) * (a ** 2.0 * xp.arctan(root / b) + b * root)


def force(xp, a, theta, b, E_star):
    return force_at(xp, a, xp.sqrt((a - b) * (a + b)), theta, b, E_star)


def slope_beyond(xp, t, root, theta, b):
    v1 = xp.tan(theta)
    return v1 * xp.arctan(root / b) + b * v1 / root


def pressure(xp, r, a, theta, b, E_star):
    v27, v28 = nodes_along(xp, 1, r, a, theta, b, E_star)
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
    v60 = v26 * xp.sum(v28 * (slope_beyond(xp, v56, v53, theta, b) * v53 / v56), axis=0)
    v65 = xp.where(v3, 2.0 * v2, r)
    v64 = xp.where(v5 & (v2 > b), xp.inf, E_star / 3.141592653589793 * xp.where(v12, v60, 0.0))
    v67 = xp.where(v1, 0.5 * b, a)
    return xp.where(v1, xp.where(v3, v64, 0.0), xp.nan)


def profile(xp, r, theta, b):
    v1 = r < b
    v2 = xp.where(v1, r, 0.5 * b)
    return xp.where(v1, 0.0, xp.tan(theta) * (xp.where(v1, 2.0 * b, r) - b))


def displacement(xp, r, a, theta, b):
    v14, v15 = nodes_along(xp, 1, r, a, theta, b)
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
    v46 = slope_beyond(xp, v40, v37, theta, b) * v37 / v40 * xp.arctan2(v40, v7 / v36)
    v56 = xp.where(v5, 0.5 * b, v2)
    v55 = v7 * (v13 * xp.sum(v15 * (v46 * (xp.sqrt(v11 * v11 + v34) / (v36 * v36 * v36))), axis=0))
    v62 = depth(xp, v2, theta, b) - profile(xp, xp.where(v3, 0.5 * v2, r), theta, b)
    v64 = xp.where(v1, 0.5 * b, a)
    return xp.where(v1, xp.where(v3, 0.6366197723675814 * xp.where(v5, v55, 0.0), v62), xp.nan)


def stiffness(xp, a, E_star):
    return 2.0 * E_star * a


def mean_pressure(xp, a, theta, b, E_star):
    v7 = xp.sqrt((a - b) * (a + b))
    v13 = xp.arctan(v7 / b) + b * v7 / a ** 2.0
    return E_star * xp.tan(theta) / 3.141592653589793 * v13


def radius_from_depth(xp, d, theta, b):
    v4 = xp.log(d / depth_at(xp, b * 1.4142135623730951, b, theta, b))
    v6 = -6.0 * (v4 - -0.10502723786770594)
    v8 = -6.0 * (v4 - 0.34642256747438094)
    v17 = xp.exp((xp.maximum(v6, v8) + xp.log1p(xp.exp(-xp.absolute(v6 - v8)))) / -6.0)
    v20 = 1.0 - 1.0 / (1.0 + v17)
    v28 = (((-0.4812051 * v20 + 3.403791) * v20 + -8.150206) * v20 + 8.66489) * v20 + -3.570796

    def f35(v36):
        v40 = b * xp.sqrt(1.0 + v36 * v36)
        v41 = b * v36
        v42 = depth_at(xp, v40, v41, theta, b)
        return (v42, v41 * v41 / v40 * slope_beyond(xp, v40, v41, theta, b) / v42)
    v35 = v17 * (((v28 * v20 + -0.4352508) * v20 + -0.008072401) * v20 + 1.587574)
    v48 = newton(xp, f35, d, v35, xp.inf, 1.0, 2.0)
    return b * xp.sqrt(1.0 + v48 * v48)


def radius_from_force(xp, F, theta, b, E_star):
    v4 = xp.log(F / force_at(xp, b * 1.4142135623730951, b, theta, b, E_star))
    v6 = -2.75 * (v4 - -0.2510287548037454)
    v8 = -1.375 * (v4 - -0.49265831981054176)
    v17 = xp.exp((xp.maximum(v6, v8) + xp.log1p(xp.exp(-xp.absolute(v6 - v8)))) / -2.75)
    v20 = 1.0 - 1.0 / (1.0 + v17)
    v28 = (((7.204481 * v20 + -25.89697) * v20 + 34.2219) * v20 + -19.76727) * v20 + 4.536442

    def f35(v36):
        v40 = b * xp.sqrt(1.0 + v36 * v36)
        v41 = b * v36
        v42 = force_at(xp, v40, v41, theta, b, E_star)
        return (v42, 2.0 * E_star * v41 * v41 * slope_beyond(xp, v40, v41, theta, b) / v42)
    v35 = v17 * (((v28 * v20 + -0.3986471) * v20 + 0.100541) * v20 + 0.9995205)
    v49 = newton(xp, f35, F, v35, xp.inf, 1.0, 2.0)
    return b * xp.sqrt(1.0 + v49 * v49)


def force_from_depth(xp, d, theta, b, E_star):
    v4 = xp.log(d / depth_at(xp, b * 1.4142135623730951, b, theta, b))
    v6 = -6.0 * (v4 - -0.10502723786770594)
    v8 = -6.0 * (v4 - 0.34642256747438094)
    v17 = xp.exp((xp.maximum(v6, v8) + xp.log1p(xp.exp(-xp.absolute(v6 - v8)))) / -6.0)
    v20 = 1.0 - 1.0 / (1.0 + v17)
    v28 = (((-0.4812051 * v20 + 3.403791) * v20 + -8.150206) * v20 + 8.66489) * v20 + -3.570796

    def f35(v36):
        v40 = b * xp.sqrt(1.0 + v36 * v36)
        v41 = b * v36
        v42 = depth_at(xp, v40, v41, theta, b)
        return (v42, v41 * v41 / v40 * slope_beyond(xp, v40, v41, theta, b) / v42)
    v35 = v17 * (((v28 * v20 + -0.4352508) * v20 + -0.008072401) * v20 + 1.587574)
    v48 = newton(xp, f35, d, v35, xp.inf, 1.0, 2.0)
    v52 = b * xp.sqrt(1.0 + v48 * v48)
    v53 = b * v48
    v62 = 2.0 * E_star * v52 * (d - depth_at(xp, v52, v53, theta, b))
    v64 = force_at(xp, v52, v53, theta, b, E_star) + xp.where((v52 > 0.0) & (v52 < xp.inf), v62, 0.0)
    return v64


def depth_from_force(xp, F, theta, b, E_star):
    v4 = xp.log(F / force_at(xp, b * 1.4142135623730951, b, theta, b, E_star))
    v6 = -2.75 * (v4 - -0.2510287548037454)
    v8 = -1.375 * (v4 - -0.49265831981054176)
    v17 = xp.exp((xp.maximum(v6, v8) + xp.log1p(xp.exp(-xp.absolute(v6 - v8)))) / -2.75)
    v20 = 1.0 - 1.0 / (1.0 + v17)
    v28 = (((7.204481 * v20 + -25.89697) * v20 + 34.2219) * v20 + -19.76727) * v20 + 4.536442

    def f35(v36):
        v40 = b * xp.sqrt(1.0 + v36 * v36)
        v41 = b * v36
        v42 = force_at(xp, v40, v41, theta, b, E_star)
        return (v42, 2.0 * E_star * v41 * v41 * slope_beyond(xp, v40, v41, theta, b) / v42)
    v35 = v17 * (((v28 * v20 + -0.3986471) * v20 + 0.100541) * v20 + 0.9995205)
    v49 = newton(xp, f35, F, v35, xp.inf, 1.0, 2.0)
    v53 = b * xp.sqrt(1.0 + v49 * v49)
    v54 = b * v49
    v63 = (F - force_at(xp, v53, v54, theta, b, E_star)) / (2.0 * E_star * v53)
    return depth_at(xp, v53, v54, theta, b) + xp.where((v53 > 0.0) & (v53 < xp.inf), v63, 0.0)


def energy(xp, a, theta, b, E_star):
    v11, v12 = nodes_along(xp, 1, a, theta, b, E_star)
    v1 = a >= b
    v2 = xp.where(v1, a, 2.0 * b)
    v3 = depth(xp, v2, theta, b)
    v6 = v2 > b
    v7 = xp.where(v6, v2, 2.0 * b)
    v8 = difference_root(xp, v7, b)
    v10 = xp.arcsinh(v8 / b)
    v13 = v11 * v10
    v25 = 0.0 - xp.expm1(-2.0 * v10)
    v26 = v25 > 0.0
    v22 = xp.exp(-v13) * (0.0 - xp.expm1(-2.0 * (v10 - v13)))
    v30 = v8 * (v22 / xp.where(v26, xp.where(v26, v25, 1.0), xp.inf))
    v35 = depth(xp, v7, theta, b) - depth_at(xp, xp.sqrt(b * b + v30 * v30), v30, theta, b)
    v39 = xp.where(v6, 0.5 * b, v2)
    v43 = xp.where(v1, 0.5 * b, a)
    v42 = E_star * (b * v3 * v3 + xp.where(v6, v10 * xp.sum(v12 * (v35 * v35 * v30), axis=0), 0.0))
    return xp.where(v1, v42, xp.nan)


def load_within(xp, r, a, theta, b, E_star):
    v31, v32 = nodes_along(xp, 1, r, a, theta, b, E_star)
    v1 = a >= b
    v2 = xp.where(v1, a, 2.0 * b)
    v3 = r > b
    v8 = xp.where(v3, 0.5 * b, r)
    v7 = force(xp, xp.maximum(xp.minimum(xp.where(v3, r, 2.0 * b), v2), b), theta, b, E_star)
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
    v80 = slope_beyond(xp, v60, v57, theta, b) * (v57 / v60) * (v77 / (v60 + v77))
    v83 = xp.where(v15, 0.5 * v14, v2)
    v85 = 2.0 * E_star * xp.where(v15, v13 * v13 * (v30 * xp.sum(v32 * v80, axis=0)), 0.0)
    v87 = xp.where(v1, 0.5 * b, a)
    return xp.where(v1, xp.where(v3, v7, 0.0) + v85, xp.nan)
