"""Formulas of axicontact.normal.paraboloid over an array library `xp`."""

from ...._programs.expressions._runtime.functions import half_tangent


def force(xp, a, R, E_star):
    return 4.0 * E_star / (3.0 * R) * (a * a ** 2.0)


def pressure(xp, r, a, R, E_star):
    v1 = r < a
    v2 = xp.where(v1, r, 0.5 * a)
    v11 = xp.where(v1, 2.0 * a, r)
    v12 = xp.where(v1, 2.0 * E_star / (3.141592653589793 * R) * xp.sqrt((a - v2) * (a + v2)), 0.0)
    return v12


def displacement(xp, r, a, R):
    v1 = r > a
    v2 = xp.where(v1, r, 2.0 * a)
    v8 = half_tangent(xp, v2, a)
    v9 = v8 * v8
    v14 = ((-0.7327347664453868 * v9 + -32.15553480435792) * v9 + -332.23363563146734) * v9
    v20 = (((v14 + -1070.7082873491413) * v9 + -85.27694715374247) * v9 + 5044.821368830373) * v9
    v30 = ((0.21387262524856868 * v9 + 32.12935731379798) * v9 + 746.8124983579742) * v9
    v36 = (((v30 + 6202.125133759036) * v9 + 23553.080984642995) * v9 + 44404.005348491315) * v9
    v25 = ((v20 + 8082.413158212496) * v9 + 3759.725330928701) * v9 + 0.26666666666720995
    v43 = v9 * (v25 / (((v36 + 40380.01430284195) * v9 + 14099.684276696918) * v9 + 1.0))
    v46 = 2.0 * a ** 2.0 / (3.141592653589793 * R) * (a / v2 * (0.6666666666666666 + v43))
    return xp.where(v1, v46, a ** 2.0 / R - xp.where(v1, 0.5 * a, r) ** 2.0 / (2.0 * R))


def radius_from_force(xp, F, R, E_star):
    return xp.cbrt(3.0 * R / (4.0 * E_star) * F)


def profile(xp, r, R):
    return r ** 2.0 / (2.0 * R)


def depth(xp, a, R):
    return a ** 2.0 / R


def stiffness(xp, a, E_star):
    return 2.0 * E_star * a


def mean_pressure(xp, a, R, E_star):
    return 4.0 * E_star / (9.42477796076938 * R) * a


def radius_from_depth(xp, d, R):
    return xp.sqrt(R * d)


def force_from_depth(xp, d, R, E_star):
    return 4.0 * E_star / 3.0 * d * xp.sqrt(R * d)


def depth_from_force(xp, F, R, E_star):
    return xp.cbrt(9.0 * F ** 2.0 / (16.0 * E_star ** 2.0 * R))


def energy(xp, a, R, E_star):
    return 8.0 * E_star / (15.0 * R ** 2.0) * a ** 5.0


def load_within(xp, r, a, R, E_star):
    v1 = r < a
    v2 = xp.where(v1, r, 0.5 * a)
    v3 = v2 > 0.0
    v4 = xp.where(v3, v2, 1.0)
    v13 = xp.sqrt((a - v4) * (a + v4))
    v18 = 4.0 * E_star / (3.0 * R) * v4 ** 2.0 * (v13 + a ** 2.0 / (v13 + a))
    v20 = xp.where(v1, 2.0 * a, r)
    return xp.where(v1, xp.where(v3, v18, 0.0), force(xp, a, R, E_star))
