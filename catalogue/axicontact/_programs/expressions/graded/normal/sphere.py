"""Formulas of axicontact.graded.normal.sphere over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import sphere_displacement
from ....._programs.expressions._runtime.graded.growth import sphere_depth
from ....._programs.expressions._runtime.graded.growth import sphere_force
from ....._programs.expressions._runtime.graded.growth import sphere_rate
from ....._programs.expressions._runtime.graded.pressure import sphere
from ....._programs.expressions._runtime.graded.punch import punch_depth
from ....._programs.expressions._runtime.graded.punch import punch_force
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions._runtime.integrals import difference_root
from ....._programs.expressions.normal.sphere import profile
from ....._runtime.steps import newton


def depth(xp, a, R, k):
    v1 = a <= R
    v2 = xp.where(v1, a, 0.5 * R)
    v5 = xp.where(v1, 2.0 * R, a)
    return xp.where(v1, sphere_depth(xp, v2, difference_root(xp, R, v2), k), xp.nan)


def force_at(xp, a, root, R, H, k):
    return 2.0 * H / (1.0 + k) * sphere_force(xp, a, root, k)


def force(xp, a, R, H, k):
    v1 = a <= R
    v2 = xp.where(v1, a, 0.5 * R)
    v5 = xp.where(v1, 2.0 * R, a)
    return xp.where(v1, force_at(xp, v2, difference_root(xp, R, v2), R, H, k), xp.nan)


def pressure(xp, r, a, R, H, k):
    v1 = a <= R
    v2 = xp.where(v1, a, 0.5 * R)
    v3 = r < v2
    v6 = xp.minimum(xp.where(v3, r, 0.5 * v2), v2)
    v9 = sphere(xp, v6, R, difference_root(xp, v2, v6), difference_root(xp, R, v2), k)
    v11 = xp.where(v3, 2.0 * v2, r)
    v13 = xp.where(v1, 2.0 * R, a)
    return xp.where(v1, xp.where(v3, H / 3.141592653589793 * v9, 0.0), xp.nan)


def rate(xp, a, R, k):
    v1 = a <= R
    v2 = xp.where(v1, a, 0.5 * R)
    v5 = xp.where(v1, 2.0 * R, a)
    return xp.where(v1, sphere_rate(xp, v2, difference_root(xp, R, v2), k), xp.nan)


def displacement(xp, r, a, R, k):
    return sphere_displacement(xp, r, a, R, k)


def stiffness(xp, a, H, k):
    return punch_stiffness(xp, a, H, k)


def mean_pressure(xp, a, R, H, k):
    v1 = a > 0.0
    v2 = xp.where(v1, a, 1.0)
    return xp.where(v1, force(xp, v2, R, H, k) / (3.141592653589793 * v2 * v2), 0.0)


def radius_from_depth(xp, d, R, k):
    v1 = d + 0.0
    v3 = sphere_depth(xp, R, 0.0, k) * 1.0000000000000036
    v4 = v1 <= v3
    v6 = xp.absolute(k)
    v7 = v6 < 1e-30
    v8 = xp.where(v7, v6, 0.5 * 1e-30)
    v9 = xp.where(v7, 2.0 * 1e-30, v6)
    v10 = xp.where(v7, 1e-30, k)
    v11 = -2.0 / v10
    v12 = -v10
    v13 = R / 100000000.0
    v16 = xp.minimum(xp.where(v4, v1, 0.5 * v3), sphere_depth(xp, v13 * 100000000.0, v13, k))
    v21 = xp.expm1(v11 * xp.log1p(v12 * 0.5)) ** 0.5
    v23 = R / xp.hypot(1.0, v21)
    v28 = v12 / 2.0

    def f32(v33):
        v38 = xp.expm1(v11 * xp.log1p(v12 * v33)) ** 0.5
        v40 = R / xp.hypot(1.0, v38)
        v41 = v40 * v38
        v42 = sphere_depth(xp, v41, v40, k)
        v49 = v38 ** 2.0
        v53 = v28 * xp.log1p(v49)
        v48 = v41 * (v40 / R) ** 2.0 * sphere_rate(xp, v41, v40, k) / v42
        return (v42, v48 / (v49 / (1.0 + v49) * xp.exp(v53) / (-xp.expm1(v53) / v10)))
    v27 = 0.5 * (v16 / sphere_depth(xp, v23 * v21, v23, k))
    v62 = v12 * newton(xp, f32, v16, v27, -xp.expm1(v28 * 36.841361487904734) / v10, 1e-06, xp.inf)
    v66 = xp.expm1(v11 * xp.log1p(v62)) ** 0.5
    v70 = xp.where(v4, 2.0 * v3, v1)
    return xp.where(v4, R / xp.hypot(1.0, v66) * v66, xp.nan)


def radius_from_force(xp, F, R, H, k):
    v1 = F + 0.0
    v3 = force_at(xp, R, 0.0, R, H, k) * 1.0000000000000036
    v4 = v1 <= v3
    v6 = 3.0 + k
    v8 = xp.absolute(k)
    v9 = v8 < 1e-30
    v10 = xp.where(v9, v8, 0.5 * 1e-30)
    v11 = xp.where(v9, 2.0 * 1e-30, v8)
    v12 = xp.where(v9, 1e-30, k)
    v13 = -v6 / v12
    v14 = -v12
    v15 = R / 100000000.0
    v18 = xp.minimum(xp.where(v4, v1, 0.5 * v3), force_at(xp, v15 * 100000000.0, v15, R, H, k))
    v23 = 1.0 / v6
    v24 = xp.expm1(v13 * xp.log1p(v14 * 0.5)) ** v23
    v26 = R / xp.hypot(1.0, v24)
    v31 = v14 / v6

    def f37(v38):
        v43 = xp.expm1(v13 * xp.log1p(v14 * v38)) ** v23
        v45 = R / xp.hypot(1.0, v43)
        v46 = v45 * v43
        v47 = force_at(xp, v46, v45, R, H, k)
        v54 = v46 * (v45 / R) ** 2.0 * (punch_stiffness(xp, v46, H, k) * sphere_rate(xp, v46, v45, k))
        v56 = v43 ** v6
        v60 = v31 * xp.log1p(v56)
        return (v47, v54 / v47 / (v56 / (1.0 + v56) * xp.exp(v60) / (-xp.expm1(v60) / v12)))
    v37 = -xp.expm1(v31 * xp.log1p(100000000.0 ** v6)) / v12
    v68 = newton(xp, f37, v18, 0.5 * (v18 / force_at(xp, v26 * v24, v26, R, H, k)), v37, 1e-06, xp.inf)
    v73 = xp.expm1(v13 * xp.log1p(v14 * v68)) ** v23
    v77 = xp.where(v4, 2.0 * v3, v1)
    return xp.where(v4, R / xp.hypot(1.0, v73) * v73, xp.nan)


def force_from_depth(xp, d, R, H, k):
    v1 = d + 0.0
    v3 = sphere_depth(xp, R, 0.0, k) * 1.0000000000000036
    v4 = v1 <= v3
    v6 = xp.absolute(k)
    v7 = v6 < 1e-30
    v8 = xp.where(v7, v6, 0.5 * 1e-30)
    v9 = xp.where(v7, 2.0 * 1e-30, v6)
    v10 = xp.where(v7, 1e-30, k)
    v11 = -2.0 / v10
    v12 = -v10
    v13 = R / 100000000.0
    v16 = xp.minimum(xp.where(v4, v1, 0.5 * v3), sphere_depth(xp, v13 * 100000000.0, v13, k))
    v21 = xp.expm1(v11 * xp.log1p(v12 * 0.5)) ** 0.5
    v23 = R / xp.hypot(1.0, v21)
    v28 = v12 / 2.0

    def f32(v33):
        v38 = xp.expm1(v11 * xp.log1p(v12 * v33)) ** 0.5
        v40 = R / xp.hypot(1.0, v38)
        v41 = v40 * v38
        v42 = sphere_depth(xp, v41, v40, k)
        v49 = v38 ** 2.0
        v53 = v28 * xp.log1p(v49)
        v48 = v41 * (v40 / R) ** 2.0 * sphere_rate(xp, v41, v40, k) / v42
        return (v42, v48 / (v49 / (1.0 + v49) * xp.exp(v53) / (-xp.expm1(v53) / v10)))
    v27 = 0.5 * (v16 / sphere_depth(xp, v23 * v21, v23, k))
    v62 = v12 * newton(xp, f32, v16, v27, -xp.expm1(v28 * 36.841361487904734) / v10, 1e-06, xp.inf)
    v66 = xp.expm1(v11 * xp.log1p(v62)) ** 0.5
    v70 = xp.where(v4, 2.0 * v3, v1)
    v71 = xp.where(v4, R / xp.hypot(1.0, v66) * v66, xp.nan)
    v72 = xp.absolute(k)
    v73 = v72 < 1e-30
    v74 = xp.where(v73, v72, 0.5 * 1e-30)
    v75 = xp.where(v73, 2.0 * 1e-30, v72)
    v76 = xp.where(v73, 1e-30, k)
    v77 = -2.0 / v76
    v78 = -v76
    v79 = R / 100000000.0
    v82 = xp.minimum(v1, sphere_depth(xp, v79 * 100000000.0, v79, k))
    v87 = xp.expm1(v77 * xp.log1p(v78 * 0.5)) ** 0.5
    v89 = R / xp.hypot(1.0, v87)
    v94 = v78 / 2.0

    def f99(v99):
        v104 = xp.expm1(v77 * xp.log1p(v78 * v99)) ** 0.5
        v106 = R / xp.hypot(1.0, v104)
        v107 = v106 * v104
        v108 = sphere_depth(xp, v107, v106, k)
        v115 = v104 ** 2.0
        v119 = v94 * xp.log1p(v115)
        v114 = v107 * (v106 / R) ** 2.0 * sphere_rate(xp, v107, v106, k) / v108
        return (v108, v114 / (v115 / (1.0 + v115) * xp.exp(v119) / (-xp.expm1(v119) / v76)))
    v93 = 0.5 * (v82 / sphere_depth(xp, v89 * v87, v89, k))
    v127 = newton(xp, f99, v82, v93, -xp.expm1(v94 * 36.841361487904734) / v76, 1e-06, xp.inf)
    v134 = R / xp.hypot(1.0, xp.expm1(v77 * xp.log1p(v78 * v127)) ** 0.5)
    v138 = punch_force(xp, d - sphere_depth(xp, v71, v134, k), v71, H, k)
    return force_at(xp, v71, v134, R, H, k) + v138


def depth_from_force(xp, F, R, H, k):
    v1 = F + 0.0
    v3 = force_at(xp, R, 0.0, R, H, k) * 1.0000000000000036
    v4 = v1 <= v3
    v6 = 3.0 + k
    v8 = xp.absolute(k)
    v9 = v8 < 1e-30
    v10 = xp.where(v9, v8, 0.5 * 1e-30)
    v11 = xp.where(v9, 2.0 * 1e-30, v8)
    v12 = xp.where(v9, 1e-30, k)
    v13 = -v6 / v12
    v14 = -v12
    v15 = R / 100000000.0
    v18 = xp.minimum(xp.where(v4, v1, 0.5 * v3), force_at(xp, v15 * 100000000.0, v15, R, H, k))
    v23 = 1.0 / v6
    v24 = xp.expm1(v13 * xp.log1p(v14 * 0.5)) ** v23
    v26 = R / xp.hypot(1.0, v24)
    v31 = v14 / v6

    def f37(v38):
        v43 = xp.expm1(v13 * xp.log1p(v14 * v38)) ** v23
        v45 = R / xp.hypot(1.0, v43)
        v46 = v45 * v43
        v47 = force_at(xp, v46, v45, R, H, k)
        v54 = v46 * (v45 / R) ** 2.0 * (punch_stiffness(xp, v46, H, k) * sphere_rate(xp, v46, v45, k))
        v56 = v43 ** v6
        v60 = v31 * xp.log1p(v56)
        return (v47, v54 / v47 / (v56 / (1.0 + v56) * xp.exp(v60) / (-xp.expm1(v60) / v12)))
    v37 = -xp.expm1(v31 * xp.log1p(100000000.0 ** v6)) / v12
    v68 = newton(xp, f37, v18, 0.5 * (v18 / force_at(xp, v26 * v24, v26, R, H, k)), v37, 1e-06, xp.inf)
    v73 = xp.expm1(v13 * xp.log1p(v14 * v68)) ** v23
    v77 = xp.where(v4, 2.0 * v3, v1)
    v78 = xp.where(v4, R / xp.hypot(1.0, v73) * v73, xp.nan)
    v79 = 3.0 + k
    v81 = xp.absolute(k)
    v82 = v81 < 1e-30
    v83 = xp.where(v82, v81, 0.5 * 1e-30)
    v84 = xp.where(v82, 2.0 * 1e-30, v81)
    v85 = xp.where(v82, 1e-30, k)
    v86 = -v79 / v85
    v87 = -v85
    v88 = R / 100000000.0
    v91 = xp.minimum(v1, force_at(xp, v88 * 100000000.0, v88, R, H, k))
    v96 = 1.0 / v79
    v97 = xp.expm1(v86 * xp.log1p(v87 * 0.5)) ** v96
    v99 = R / xp.hypot(1.0, v97)
    v104 = v87 / v79

    def f111(v111):
        v116 = xp.expm1(v86 * xp.log1p(v87 * v111)) ** v96
        v118 = R / xp.hypot(1.0, v116)
        v119 = v118 * v116
        v120 = force_at(xp, v119, v118, R, H, k)
        v126 = punch_stiffness(xp, v119, H, k) * sphere_rate(xp, v119, v118, k)
        v129 = v116 ** v79
        v133 = v104 * xp.log1p(v129)
        v139 = v129 / (1.0 + v129) * xp.exp(v133) / (-xp.expm1(v133) / v85)
        return (v120, v119 * (v118 / R) ** 2.0 * v126 / v120 / v139)
    v103 = 0.5 * (v91 / force_at(xp, v99 * v97, v99, R, H, k))
    v110 = -xp.expm1(v104 * xp.log1p(100000000.0 ** v79)) / v85
    v146 = xp.expm1(v86 * xp.log1p(v87 * newton(xp, f111, v91, v103, v110, 1e-06, xp.inf))) ** v96
    v148 = R / xp.hypot(1.0, v146)
    v152 = punch_depth(xp, F - force_at(xp, v78, v148, R, H, k), v78, H, k)
    return sphere_depth(xp, v78, v148, k) + v152
