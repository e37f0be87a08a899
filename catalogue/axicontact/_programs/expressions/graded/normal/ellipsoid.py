"""Formulas of axicontact.graded.normal.ellipsoid over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import sphere_displacement
from ....._programs.expressions._runtime.graded.growth import sphere_depth
from ....._programs.expressions._runtime.graded.growth import sphere_force
from ....._programs.expressions._runtime.graded.growth import sphere_rate
from ....._programs.expressions._runtime.graded.pressure import sphere
from ....._programs.expressions._runtime.graded.punch import punch_depth
from ....._programs.expressions._runtime.graded.punch import punch_force
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions._runtime.integrals import difference_root
from ....._programs.expressions.normal.ellipsoid import profile
from ....._runtime.steps import newton


def depth(xp, a, h, b, k):
    v1 = a <= b
    v2 = xp.where(v1, a, 0.5 * b)
    v7 = xp.where(v1, 2.0 * b, a)
    return xp.where(v1, h * sphere_depth(xp, v2, difference_root(xp, b, v2), k) / b, xp.nan)


def force_at(xp, a, root, h, b, H, k):
    return 2.0 * H / (1.0 + k) * (h * sphere_force(xp, a, root, k) / b)


def force(xp, a, h, b, H, k):
    v1 = a <= b
    v2 = xp.where(v1, a, 0.5 * b)
    v5 = xp.where(v1, 2.0 * b, a)
    return xp.where(v1, force_at(xp, v2, difference_root(xp, b, v2), h, b, H, k), xp.nan)


def pressure(xp, r, a, h, b, H, k):
    v1 = a <= b
    v2 = xp.where(v1, a, 0.5 * b)
    v3 = r < v2
    v6 = xp.minimum(xp.where(v3, r, 0.5 * v2), v2)
    v11 = h * sphere(xp, v6, b, difference_root(xp, v2, v6), difference_root(xp, b, v2), k) / b
    v13 = xp.where(v3, 2.0 * v2, r)
    v15 = xp.where(v1, 2.0 * b, a)
    return xp.where(v1, xp.where(v3, H / 3.141592653589793 * v11, 0.0), xp.nan)


def rate(xp, a, h, b, k):
    v1 = a <= b
    v2 = xp.where(v1, a, 0.5 * b)
    v7 = xp.where(v1, 2.0 * b, a)
    return xp.where(v1, h * sphere_rate(xp, v2, difference_root(xp, b, v2), k) / b, xp.nan)


def displacement(xp, r, a, h, b, k):
    return h * sphere_displacement(xp, r, a, b, k) / b


def stiffness(xp, a, H, k):
    return punch_stiffness(xp, a, H, k)


def mean_pressure(xp, a, h, b, H, k):
    v1 = a > 0.0
    v2 = xp.where(v1, a, 1.0)
    return xp.where(v1, force(xp, v2, h, b, H, k) / (3.141592653589793 * v2 * v2), 0.0)


def radius_from_depth(xp, d, h, b, k):
    v1 = d + 0.0
    v5 = h * sphere_depth(xp, b, 0.0, k) / b * 1.0000000000000036
    v6 = v1 <= v5
    v8 = xp.absolute(k)
    v9 = v8 < 1e-30
    v10 = xp.where(v9, v8, 0.5 * 1e-30)
    v11 = xp.where(v9, 2.0 * 1e-30, v8)
    v12 = xp.where(v9, 1e-30, k)
    v13 = -2.0 / v12
    v14 = -v12
    v15 = b / 100000000.0
    v19 = h * sphere_depth(xp, v15 * 100000000.0, v15, k) / b
    v20 = xp.minimum(xp.where(v6, v1, 0.5 * v5), v19)
    v25 = xp.expm1(v13 * xp.log1p(v14 * 0.5)) ** 0.5
    v27 = b / xp.hypot(1.0, v25)
    v34 = v14 / 2.0

    def f38(v39):
        v44 = xp.expm1(v13 * xp.log1p(v14 * v39)) ** 0.5
        v46 = b / xp.hypot(1.0, v44)
        v47 = v46 * v44
        v50 = h * sphere_depth(xp, v47, v46, k) / b
        v59 = v44 ** 2.0
        v63 = v34 * xp.log1p(v59)
        v58 = v47 * (v46 / b) ** 2.0 * (h * sphere_rate(xp, v47, v46, k) / b) / v50
        return (v50, v58 / (v59 / (1.0 + v59) * xp.exp(v63) / (-xp.expm1(v63) / v12)))
    v33 = 0.5 * (v20 / (h * sphere_depth(xp, v27 * v25, v27, k) / b))
    v72 = v14 * newton(xp, f38, v20, v33, -xp.expm1(v34 * 36.841361487904734) / v12, 1e-06, xp.inf)
    v76 = xp.expm1(v13 * xp.log1p(v72)) ** 0.5
    v80 = xp.where(v6, 2.0 * v5, v1)
    return xp.where(v6, b / xp.hypot(1.0, v76) * v76, xp.nan)


def force_rate_at(xp, a, root, h, b, H, k):
    return punch_stiffness(xp, a, H, k) * (h * sphere_rate(xp, a, root, k) / b)


def radius_from_force(xp, F, h, b, H, k):
    v1 = F + 0.0
    v3 = force_at(xp, b, 0.0, h, b, H, k) * 1.0000000000000036
    v4 = v1 <= v3
    v6 = 3.0 + k
    v8 = xp.absolute(k)
    v9 = v8 < 1e-30
    v10 = xp.where(v9, v8, 0.5 * 1e-30)
    v11 = xp.where(v9, 2.0 * 1e-30, v8)
    v12 = xp.where(v9, 1e-30, k)
    v13 = -v6 / v12
    v14 = -v12
    v15 = b / 100000000.0
    v18 = xp.minimum(xp.where(v4, v1, 0.5 * v3), force_at(xp, v15 * 100000000.0, v15, h, b, H, k))
    v23 = 1.0 / v6
    v24 = xp.expm1(v13 * xp.log1p(v14 * 0.5)) ** v23
    v26 = b / xp.hypot(1.0, v24)
    v31 = v14 / v6

    def f37(v38):
        v43 = xp.expm1(v13 * xp.log1p(v14 * v38)) ** v23
        v45 = b / xp.hypot(1.0, v43)
        v46 = v45 * v43
        v47 = force_at(xp, v46, v45, h, b, H, k)
        v54 = v43 ** v6
        v58 = v31 * xp.log1p(v54)
        v53 = v46 * (v45 / b) ** 2.0 * force_rate_at(xp, v46, v45, h, b, H, k) / v47
        return (v47, v53 / (v54 / (1.0 + v54) * xp.exp(v58) / (-xp.expm1(v58) / v12)))
    v30 = 0.5 * (v18 / force_at(xp, v26 * v24, v26, h, b, H, k))
    v37 = -xp.expm1(v31 * xp.log1p(100000000.0 ** v6)) / v12
    v71 = xp.expm1(v13 * xp.log1p(v14 * newton(xp, f37, v18, v30, v37, 1e-06, xp.inf))) ** v23
    v75 = xp.where(v4, 2.0 * v3, v1)
    return xp.where(v4, b / xp.hypot(1.0, v71) * v71, xp.nan)


def force_from_depth(xp, d, h, b, H, k):
    v1 = d + 0.0
    v5 = h * sphere_depth(xp, b, 0.0, k) / b * 1.0000000000000036
    v6 = v1 <= v5
    v8 = xp.absolute(k)
    v9 = v8 < 1e-30
    v10 = xp.where(v9, v8, 0.5 * 1e-30)
    v11 = xp.where(v9, 2.0 * 1e-30, v8)
    v12 = xp.where(v9, 1e-30, k)
    v13 = -2.0 / v12
    v14 = -v12
    v15 = b / 100000000.0
    v19 = h * sphere_depth(xp, v15 * 100000000.0, v15, k) / b
    v20 = xp.minimum(xp.where(v6, v1, 0.5 * v5), v19)
    v25 = xp.expm1(v13 * xp.log1p(v14 * 0.5)) ** 0.5
    v27 = b / xp.hypot(1.0, v25)
    v34 = v14 / 2.0

    def f38(v39):
        v44 = xp.expm1(v13 * xp.log1p(v14 * v39)) ** 0.5
        v46 = b / xp.hypot(1.0, v44)
        v47 = v46 * v44
        v50 = h * sphere_depth(xp, v47, v46, k) / b
        v59 = v44 ** 2.0
        v63 = v34 * xp.log1p(v59)
        v58 = v47 * (v46 / b) ** 2.0 * (h * sphere_rate(xp, v47, v46, k) / b) / v50
        return (v50, v58 / (v59 / (1.0 + v59) * xp.exp(v63) / (-xp.expm1(v63) / v12)))
    v33 = 0.5 * (v20 / (h * sphere_depth(xp, v27 * v25, v27, k) / b))
    v72 = v14 * newton(xp, f38, v20, v33, -xp.expm1(v34 * 36.841361487904734) / v12, 1e-06, xp.inf)
    v76 = xp.expm1(v13 * xp.log1p(v72)) ** 0.5
    v80 = xp.where(v6, 2.0 * v5, v1)
    v81 = xp.where(v6, b / xp.hypot(1.0, v76) * v76, xp.nan)
    v82 = xp.absolute(k)
    v83 = v82 < 1e-30
    v84 = xp.where(v83, v82, 0.5 * 1e-30)
    v85 = xp.where(v83, 2.0 * 1e-30, v82)
    v86 = xp.where(v83, 1e-30, k)
    v87 = -2.0 / v86
    v88 = -v86
    v89 = b / 100000000.0
    v94 = xp.minimum(v1, h * sphere_depth(xp, v89 * 100000000.0, v89, k) / b)
    v99 = xp.expm1(v87 * xp.log1p(v88 * 0.5)) ** 0.5
    v101 = b / xp.hypot(1.0, v99)
    v108 = v88 / 2.0

    def f113(v113):
        v118 = xp.expm1(v87 * xp.log1p(v88 * v113)) ** 0.5
        v120 = b / xp.hypot(1.0, v118)
        v121 = v120 * v118
        v124 = h * sphere_depth(xp, v121, v120, k) / b
        v133 = v118 ** 2.0
        v137 = v108 * xp.log1p(v133)
        v132 = v121 * (v120 / b) ** 2.0 * (h * sphere_rate(xp, v121, v120, k) / b) / v124
        return (v124, v132 / (v133 / (1.0 + v133) * xp.exp(v137) / (-xp.expm1(v137) / v86)))
    v107 = 0.5 * (v94 / (h * sphere_depth(xp, v101 * v99, v101, k) / b))
    v145 = newton(xp, f113, v94, v107, -xp.expm1(v108 * 36.841361487904734) / v86, 1e-06, xp.inf)
    v152 = b / xp.hypot(1.0, xp.expm1(v87 * xp.log1p(v88 * v145)) ** 0.5)
    v158 = punch_force(xp, d - h * sphere_depth(xp, v81, v152, k) / b, v81, H, k)
    return force_at(xp, v81, v152, h, b, H, k) + v158


def depth_from_force(xp, F, h, b, H, k):
    v1 = F + 0.0
    v3 = force_at(xp, b, 0.0, h, b, H, k) * 1.0000000000000036
    v4 = v1 <= v3
    v6 = 3.0 + k
    v8 = xp.absolute(k)
    v9 = v8 < 1e-30
    v10 = xp.where(v9, v8, 0.5 * 1e-30)
    v11 = xp.where(v9, 2.0 * 1e-30, v8)
    v12 = xp.where(v9, 1e-30, k)
    v13 = -v6 / v12
    v14 = -v12
    v15 = b / 100000000.0
    v18 = xp.minimum(xp.where(v4, v1, 0.5 * v3), force_at(xp, v15 * 100000000.0, v15, h, b, H, k))
    v23 = 1.0 / v6
    v24 = xp.expm1(v13 * xp.log1p(v14 * 0.5)) ** v23
    v26 = b / xp.hypot(1.0, v24)
    v31 = v14 / v6

    def f37(v38):
        v43 = xp.expm1(v13 * xp.log1p(v14 * v38)) ** v23
        v45 = b / xp.hypot(1.0, v43)
        v46 = v45 * v43
        v47 = force_at(xp, v46, v45, h, b, H, k)
        v54 = v43 ** v6
        v58 = v31 * xp.log1p(v54)
        v53 = v46 * (v45 / b) ** 2.0 * force_rate_at(xp, v46, v45, h, b, H, k) / v47
        return (v47, v53 / (v54 / (1.0 + v54) * xp.exp(v58) / (-xp.expm1(v58) / v12)))
    v30 = 0.5 * (v18 / force_at(xp, v26 * v24, v26, h, b, H, k))
    v37 = -xp.expm1(v31 * xp.log1p(100000000.0 ** v6)) / v12
    v71 = xp.expm1(v13 * xp.log1p(v14 * newton(xp, f37, v18, v30, v37, 1e-06, xp.inf))) ** v23
    v75 = xp.where(v4, 2.0 * v3, v1)
    v76 = xp.where(v4, b / xp.hypot(1.0, v71) * v71, xp.nan)
    v77 = 3.0 + k
    v79 = xp.absolute(k)
    v80 = v79 < 1e-30
    v81 = xp.where(v80, v79, 0.5 * 1e-30)
    v82 = xp.where(v80, 2.0 * 1e-30, v79)
    v83 = xp.where(v80, 1e-30, k)
    v84 = -v77 / v83
    v85 = -v83
    v86 = b / 100000000.0
    v89 = xp.minimum(v1, force_at(xp, v86 * 100000000.0, v86, h, b, H, k))
    v94 = 1.0 / v77
    v95 = xp.expm1(v84 * xp.log1p(v85 * 0.5)) ** v94
    v97 = b / xp.hypot(1.0, v95)
    v102 = v85 / v77

    def f109(v109):
        v114 = xp.expm1(v84 * xp.log1p(v85 * v109)) ** v94
        v116 = b / xp.hypot(1.0, v114)
        v117 = v116 * v114
        v118 = force_at(xp, v117, v116, h, b, H, k)
        v125 = v114 ** v77
        v129 = v102 * xp.log1p(v125)
        v124 = v117 * (v116 / b) ** 2.0 * force_rate_at(xp, v117, v116, h, b, H, k) / v118
        return (v118, v124 / (v125 / (1.0 + v125) * xp.exp(v129) / (-xp.expm1(v129) / v83)))
    v101 = 0.5 * (v89 / force_at(xp, v97 * v95, v97, h, b, H, k))
    v108 = -xp.expm1(v102 * xp.log1p(100000000.0 ** v77)) / v83
    v142 = xp.expm1(v84 * xp.log1p(v85 * newton(xp, f109, v89, v101, v108, 1e-06, xp.inf))) ** v94
    v144 = b / xp.hypot(1.0, v142)
    v150 = punch_depth(xp, F - force_at(xp, v76, v144, h, b, H, k), v76, H, k)
    return h * sphere_depth(xp, v76, v144, k) / b + v150
