"""Formulas of axicontact.cohesive.truncated_cone over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.cohesive import lift_of_zone
from ...._programs.expressions._runtime.physics.cohesive import pull_of_zone
from ...._programs.expressions._runtime.physics.cohesive import tension_of_zone
from ...._programs.expressions.normal.truncated_cone import depth as normal_depth
from ...._programs.expressions.normal.truncated_cone import displacement as normal_displacement
from ...._programs.expressions.normal.truncated_cone import force as normal_force
from ...._programs.expressions.normal.truncated_cone import pressure as normal_pressure
from ...._programs.expressions.normal.truncated_cone import slope_beyond as normal_slope_beyond
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def work_of_separation(xp, a, c, theta, b, E_star, sigma_0):
    v67, v68 = nodes_along(xp, 1, a, c, theta, b, E_star, sigma_0)
    v1 = a < b
    v2 = xp.where(v1, a, 0.5 * b)
    v3 = v2 < b
    v4 = xp.where(v3, v2, 0.5 * b)
    v5 = difference_root(xp, c, v4)
    v6 = difference_root(xp, b, v4)
    v10 = xp.maximum(v5 - v6, 0.0) * (v5 + v6)
    v11 = v10 > 0.0
    v15 = xp.where(v3, 2.0 * b, v2)
    v18 = xp.hypot(difference_root(xp, v15, b), difference_root(xp, c, v15))
    v19 = xp.where(v3, xp.where(v11, xp.sqrt(xp.where(v11, v10, 1.0)), 0.0), v18)
    v22 = xp.where(v1, v19, difference_root(xp, c, xp.where(v1, 2.0 * b, a)))
    v23 = v22 > 0.0
    v24 = xp.where(v23, v22, 1.0)
    v25 = v24 > 0.0
    v27 = xp.where(v25, xp.where(v25, v24, 1.0), b)
    v28 = difference_root(xp, a, b)
    v30 = xp.where(v25, v24, 1.0)
    v31 = xp.where(v1, a, 0.5 * b)
    v32 = difference_root(xp, c, v31)
    v33 = difference_root(xp, b, v31)
    v37 = xp.maximum(v32 - v33, 0.0) * (v32 + v33)
    v38 = v37 > 0.0
    v42 = xp.where(v1, 2.0 * b, a)
    v45 = xp.hypot(difference_root(xp, v42, b), difference_root(xp, c, v42))
    v47 = xp.where(v25, xp.where(v1, xp.where(v38, xp.sqrt(xp.where(v38, v37, 1.0)), 0.0), v45), b)
    v49 = xp.arcsinh(b / v47)
    v51 = 1.5707963267948966 / v49
    v53 = xp.arctan2(v28, v27) / v49
    v64 = v51 * xp.sqrt(1.0 + v53 * v53) + v53 * xp.sqrt(1.0 + v51 * v51)
    v66 = xp.arcsinh(xp.arctan2(v27, v28) / v49 * (v51 + v53) / v64)
    v69 = v67 * v66
    v72 = xp.arcsinh(v51)
    v73 = 0.5 * v69
    v78 = 2.0 * v49 * xp.cosh(v72 - v73) * xp.sinh(v73)
    v80 = v47 * xp.cos(v78)
    v83 = xp.sqrt(b * b + v80 * v80)
    v91 = v47 * xp.sin(v78)
    v89 = normal_slope_beyond(xp, v83, v80, theta, b) * v80 * v49 * xp.cosh(v72 - v69)
    v97 = 0.6366197723675814 * (v66 * xp.sum(v68 * (v89 * xp.arctan2(v91, v83) * (v91 / v83)), axis=0))
    v101 = difference_root(xp, c, a)
    v107 = xp.arctan2(v101, a) - v101 / (xp.hypot(a, v101) + a)
    v109 = xp.where(v23, v97, 0.0) + 1.2732395447351628 * (sigma_0 / E_star) * v101 * v107
    return sigma_0 * v109


def zone(xp, a, theta, b, E_star, dgamma, sigma_0):
    v76, v77 = nodes_along(xp, 1, a, theta, b, E_star, dgamma, sigma_0)
    v1 = dgamma / sigma_0
    v4 = 0.7853981633974483 * v1 * (E_star / sigma_0)
    v6 = 0.5 * v4 / 0.5707963267948966

    def f13(v14):
        v15 = a < b
        v16 = xp.where(v15, a, 0.5 * b)
        v17 = v16 < b
        v19 = difference_root(xp, b, xp.where(v17, v16, 0.5 * b))
        v23 = xp.maximum(v14 - v19, 0.0) * (v14 + v19)
        v24 = v23 > 0.0
        v30 = xp.hypot(difference_root(xp, xp.where(v17, 2.0 * b, v16), b), v14)
        v32 = xp.where(v15, 2.0 * b, a)
        v31 = xp.where(v17, xp.where(v24, xp.sqrt(xp.where(v24, v23, 1.0)), 0.0), v30)
        v33 = xp.where(v15, v31, v14)
        v34 = v33 > 0.0
        v35 = xp.where(v34, v33, 1.0)
        v36 = v35 > 0.0
        v38 = xp.where(v36, xp.where(v36, v35, 1.0), b)
        v39 = difference_root(xp, a, b)
        v41 = xp.where(v36, v35, 1.0)
        v43 = difference_root(xp, b, xp.where(v15, a, 0.5 * b))
        v47 = xp.maximum(v14 - v43, 0.0) * (v14 + v43)
        v48 = v47 > 0.0
        v54 = xp.hypot(difference_root(xp, xp.where(v15, 2.0 * b, a), b), v14)
        v56 = xp.where(v36, xp.where(v15, xp.where(v48, xp.sqrt(xp.where(v48, v47, 1.0)), 0.0), v54), b)
        v58 = xp.arcsinh(b / v56)
        v60 = 1.5707963267948966 / v58
        v62 = xp.arctan2(v39, v38) / v58
        v73 = v60 * xp.sqrt(1.0 + v62 * v62) + v62 * xp.sqrt(1.0 + v60 * v60)
        v75 = xp.arcsinh(xp.arctan2(v38, v39) / v58 * (v60 + v62) / v73)
        v78 = v76 * v75
        v81 = xp.arcsinh(v60)
        v82 = 0.5 * v78
        v87 = 2.0 * v58 * xp.cosh(v81 - v82) * xp.sinh(v82)
        v89 = v56 * xp.cos(v87)
        v92 = xp.sqrt(b * b + v89 * v89)
        v100 = v56 * xp.sin(v87)
        v98 = normal_slope_beyond(xp, v92, v89, theta, b) * v89 * v58 * xp.cosh(v81 - v78)
        v105 = v75 * xp.sum(v77 * (v98 * xp.arctan2(v100, v92) * (v100 / v92)), axis=0)
        v109 = 1.2732395447351628 * (sigma_0 / E_star)
        v111 = xp.arctan2(v14, a)
        v112 = xp.hypot(a, v14)
        v114 = v14 / (v112 + a)
        v117 = xp.where(v34, 0.6366197723675814 * v105, 0.0) + v109 * v14 * (v111 - v114)
        v119 = v14 / v112
        v121 = xp.where(v34, v33, 1.0)
        v122 = v121 > 0.0
        v124 = xp.where(v122, xp.where(v122, v121, 1.0), b)
        v125 = difference_root(xp, a, b)
        v127 = xp.where(v122, v121, 1.0)
        v129 = difference_root(xp, b, xp.where(v15, a, 0.5 * b))
        v133 = xp.maximum(v14 - v129, 0.0) * (v14 + v129)
        v134 = v133 > 0.0
        v140 = xp.hypot(difference_root(xp, xp.where(v15, 2.0 * b, a), b), v14)
        v141 = xp.where(v15, xp.where(v134, xp.sqrt(xp.where(v134, v133, 1.0)), 0.0), v140)
        v142 = xp.where(v122, v141, b)
        v144 = xp.arcsinh(b / v142)
        v146 = 1.5707963267948966 / v144
        v148 = xp.arctan2(v125, v124) / v144
        v159 = v146 * xp.sqrt(1.0 + v148 * v148) + v148 * xp.sqrt(1.0 + v146 * v146)
        v161 = xp.arcsinh(xp.arctan2(v124, v125) / v144 * (v146 + v148) / v159)
        v162 = v76 * v161
        v165 = xp.arcsinh(v146)
        v166 = 0.5 * v162
        v173 = v142 * xp.cos(2.0 * v144 * xp.cosh(v165 - v166) * xp.sinh(v166))
        v179 = normal_slope_beyond(xp, xp.sqrt(b * b + v173 * v173), v173, theta, b) * v173 * v144
        v185 = 0.6366197723675814 * (v161 * xp.sum(v77 * (v179 * xp.cosh(v165 - v162) / v112), axis=0))
        v192 = v14 / v117 * v119 * (xp.where(v34, v185, 0.0) + v109 * (v111 / v119 - v119 * v114))
        return (v117, v192)
    v13 = xp.minimum(v6 + xp.sqrt(v6 ** 2.0 + 2.0 * a * v4), xp.inf)
    return newton(xp, f13, v1, v13, xp.inf, 0.5, 4.0)


def cohesive_radius(xp, a, theta, b, E_star, dgamma, sigma_0):
    return xp.hypot(a, zone(xp, a, theta, b, E_star, dgamma, sigma_0))


def depth_of(xp, a, q, theta, b, E_star, dgamma, sigma_0):
    v1 = a < b
    v2 = xp.where(v1, a, 0.5 * b)
    v5 = xp.where(v1, 0.0, normal_depth(xp, xp.where(v1, 2.0 * b, a), theta, b))
    return v5 - 2.0 * (sigma_0 / E_star) * q


def depth(xp, a, theta, b, E_star, dgamma, sigma_0):
    v2 = depth_of(xp, a, zone(xp, a, theta, b, E_star, dgamma, sigma_0), theta, b, E_star, dgamma, sigma_0)
    return v2


def force_of(xp, a, q, theta, b, E_star, dgamma, sigma_0):
    v1 = a < b
    v2 = xp.where(v1, a, 0.5 * b)
    v5 = xp.where(v1, 0.0, normal_force(xp, xp.where(v1, 2.0 * b, a), theta, b, E_star))
    return v5 - pull_of_zone(xp, q, a, sigma_0)


def force(xp, a, theta, b, E_star, dgamma, sigma_0):
    v2 = force_of(xp, a, zone(xp, a, theta, b, E_star, dgamma, sigma_0), theta, b, E_star, dgamma, sigma_0)
    return v2


def pressure_of(xp, r, a, q, theta, b, E_star, dgamma, sigma_0):
    v1 = a < b
    v2 = xp.where(v1, a, 0.5 * b)
    v5 = xp.where(v1, 0.0, normal_pressure(xp, r, xp.where(v1, 2.0 * b, a), theta, b, E_star))
    return v5 - tension_of_zone(xp, r, q, a, sigma_0)


def pressure(xp, r, a, theta, b, E_star, dgamma, sigma_0):
    v1 = zone(xp, a, theta, b, E_star, dgamma, sigma_0)
    return pressure_of(xp, r, a, v1, theta, b, E_star, dgamma, sigma_0)


def displacement_of(xp, r, a, q, theta, b, E_star, dgamma, sigma_0):
    v1 = a < b
    v2 = xp.where(v1, a, 0.5 * b)
    v5 = xp.where(v1, 0.0, normal_displacement(xp, r, xp.where(v1, 2.0 * b, a), theta, b))
    return v5 - lift_of_zone(xp, r, q, a, E_star, sigma_0)


def displacement(xp, r, a, theta, b, E_star, dgamma, sigma_0):
    v1 = zone(xp, a, theta, b, E_star, dgamma, sigma_0)
    return displacement_of(xp, r, a, v1, theta, b, E_star, dgamma, sigma_0)
