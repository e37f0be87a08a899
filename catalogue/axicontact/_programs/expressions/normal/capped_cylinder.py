"""Formulas of axicontact.normal.capped_cylinder over an array library `xp`."""

from ...._programs.expressions._runtime.functions import half_tangent
from ...._programs.expressions._runtime.functions import difference_of_products


def profile(xp, r, a, R):
    v1 = r <= a
    v6 = xp.where(v1, 2.0 * a, r)
    return xp.where(v1, xp.where(v1, r, 0.5 * a) ** 2.0 / (2.0 * R), xp.nan)


def force(xp, d, a, R, E_star):
    v10 = 4.0 * E_star / 3.0 * xp.minimum(xp.sqrt(R * d), a) * xp.minimum(d, a ** 2.0 / R)
    v17 = v10 + 2.0 * E_star * a * xp.maximum(difference_of_products(xp, R, d, a, a) / R, 0.0)
    return v17


def pressure(xp, r, d, a, R, E_star):
    v1 = r <= a
    v2 = xp.where(v1, r, 0.5 * a)
    v5 = difference_of_products(xp, R, d, a, a) / R
    v6 = v5 > 0.0
    v7 = xp.where(v6, v5, 1.0)
    v13 = xp.maximum(xp.where(v6, (a - v2) * (a + v2), difference_of_products(xp, R, d, v2, v2)), 0.0)
    v14 = v13 > 0.0
    v18 = 2.0 * E_star * xp.where(v14, xp.sqrt(xp.where(v14, v13, 1.0)), 0.0)
    v28 = E_star / 3.141592653589793 * xp.where(v6, v5, 1.0) / xp.sqrt((a - v2) * (a + v2))
    v31 = xp.where(v1, 2.0 * a, r)
    return xp.where(v1, v18 / (3.141592653589793 * R) + xp.where(v6, v28, 0.0), 0.0)


def displacement(xp, r, d, a, R):
    v3 = xp.minimum(xp.sqrt(R * d), a)
    v4 = r > v3
    v5 = xp.where(v4, r, 2.0 * v3)
    v10 = half_tangent(xp, v5, v3)
    v11 = v10 * v10
    v16 = ((-0.7327347664453868 * v11 + -32.15553480435792) * v11 + -332.23363563146734) * v11
    v22 = (((v16 + -1070.7082873491413) * v11 + -85.27694715374247) * v11 + 5044.821368830373) * v11
    v32 = ((0.21387262524856868 * v11 + 32.12935731379798) * v11 + 746.8124983579742) * v11
    v38 = (((v32 + 6202.125133759036) * v11 + 23553.080984642995) * v11 + 44404.005348491315) * v11
    v27 = ((v22 + 8082.413158212496) * v11 + 3759.725330928701) * v11 + 0.26666666666720995
    v45 = v11 * (v27 / (((v38 + 40380.01430284195) * v11 + 14099.684276696918) * v11 + 1.0))
    v50 = difference_of_products(xp, R, d, a, a) / R
    v51 = v50 > 0.0
    v59 = xp.maximum(xp.where(v51, v50, 1.0), 0.0) * xp.arctan2(a, xp.sqrt((v5 - a) * (v5 + a)))
    v48 = xp.minimum(d, a ** 2.0 / R) * (v3 / v5 * (0.6666666666666666 + v45))
    v62 = 0.6366197723675814 * (v48 + xp.where(v51, v59, 0.0))
    return xp.where(v4, v62, d - profile(xp, xp.where(v4, 0.5 * v3, r), a, R))


def stiffness(xp, d, a, R, E_star):
    return 2.0 * E_star * xp.minimum(xp.sqrt(R * d), a)


def depth_from_force(xp, F, a, R, E_star):
    v2 = 3.0 * R
    v4 = a ** 2.0
    v6 = 4.0 * E_star / v2 * (a * v4)
    v7 = v6 > F
    v8 = xp.where(v7, v6, 2.0 * F)
    v16 = xp.where(v7, 0.5 * F, v6)
    v15 = xp.cbrt(9.0 * F ** 2.0 / (16.0 * E_star ** 2.0 * R))
    return xp.where(v7, v15, F / (2.0 * E_star * a) + v4 / v2)


def energy(xp, d, a, R, E_star):
    v2 = R ** 2.0
    v5 = R * d
    v6 = xp.sqrt(v5)
    v10 = v6 > a
    v11 = xp.where(v10, v6, 2.0 * a)
    v16 = a ** 2.0
    v23 = xp.where(v10, 0.5 * a, v6)
    v24 = xp.where(v10, -E_star / (3.0 * v2) * a * (v16 - v5) * (v16 + 3.0 * R * d), 0.0)
    return 8.0 * E_star / (15.0 * v2) * xp.minimum(v6, a) ** 5.0 + v24


def load_within(xp, r, d, a, R, E_star):
    v1 = R * d
    v2 = xp.sqrt(v1)
    v3 = xp.minimum(v2, a)
    v4 = r < v3
    v5 = xp.where(v4, r, 0.5 * v3)
    v9 = v5 ** 2.0
    v14 = xp.sqrt((v3 - v5) * (v3 + v5))
    v20 = v2 > a
    v21 = xp.where(v20, v2, 2.0 * a)
    v34 = xp.where(v20, 0.5 * a, v2)
    v33 = -2.0 * E_star * v9 * (a ** 2.0 - v1) / (R * (xp.sqrt((a - v5) * (a + v5)) + a))
    v19 = 4.0 * E_star / (3.0 * R) * v9 * (v14 + v3 ** 2.0 / (v3 + v14))
    v37 = xp.where(v4, 2.0 * v3, r)
    return xp.where(v4, v19 + xp.where(v20, v33, 0.0), force(xp, d, a, R, E_star))
