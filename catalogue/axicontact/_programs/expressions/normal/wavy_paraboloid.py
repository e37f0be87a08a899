"""Formulas of axicontact.normal.wavy_paraboloid over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.special import struve_h0
from ...._programs.expressions._runtime.special import struve_h1
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def depth(xp, a, R, h, wavelength):
    v6 = 9.869604401089358 * h / wavelength * struve_h0(xp, 6.283185307179586 / wavelength * a)
    return a * (v6 + a / R)


def force(xp, a, R, h, wavelength, E_star):
    v6 = 6.283185307179586 / wavelength * a
    v8 = 19.739208802178716 * h / wavelength * a * struve_h0(xp, v6)
    v17 = v8 + 4.0 * a ** 2.0 / (3.0 * R) - 3.141592653589793 * h * struve_h1(xp, v6)
    return E_star * a * v17


def slope(xp, t, R, h, wavelength):
    v2 = wavelength ** 2.0
    v8 = 6.283185307179586 / wavelength * t
    v10 = 9.869604401089358 * h / wavelength * struve_h0(xp, v8)
    v14 = 39.47841760435743 * h / v2 * t + v10 + 2.0 * t / R
    return v14 - 62.01255336059963 * h / v2 * t * struve_h1(xp, v8)


def pressure(xp, r, a, R, h, wavelength, E_star):
    v5, v6 = nodes_along(xp, 4, r, a, R, h, wavelength, E_star)
    v1 = r < a
    v2 = xp.where(v1, r, 0.5 * a)
    v4 = difference_root(xp, a, v2)
    v7 = v5 * v4
    v11 = xp.sqrt(v2 * v2 + v7 * v7)
    v14 = v4 * xp.sum(v6 * (slope(xp, v11, R, h, wavelength) / v11), axis=0)
    v16 = xp.where(v1, 2.0 * a, r)
    return xp.where(v1, E_star / 3.141592653589793 * v14, 0.0)


def profile(xp, r, R, h, wavelength):
    v10 = 2.0 * h * xp.sin(3.141592653589793 / wavelength * r) ** 2.0 + r ** 2.0 / (2.0 * R)
    return v10


def displacement(xp, r, a, R, h, wavelength):
    v5, v6 = nodes_along(xp, 4, r, a, R, h, wavelength)
    v1 = r > a
    v2 = xp.where(v1, r, 2.0 * a)
    v4 = xp.arctan2(a, difference_root(xp, v2, a))
    v7 = v5 * v4
    v13 = slope(xp, v2 * xp.sin(v7), R, h, wavelength) * v7 * xp.cos(v7)
    v20 = depth(xp, a, R, h, wavelength) - profile(xp, xp.where(v1, 0.5 * a, r), R, h, wavelength)
    return xp.where(v1, 0.6366197723675814 * (v2 * (v4 * xp.sum(v6 * v13, axis=0))), v20)


def stiffness(xp, a, E_star):
    return 2.0 * E_star * a


def mean_pressure(xp, a, R, h, wavelength, E_star):
    v1 = a > 0.0
    v2 = xp.where(v1, a, 1.0)
    v7 = xp.where(v1, force(xp, v2, R, h, wavelength, E_star) / (3.141592653589793 * v2 ** 2.0), 0.0)
    return v7


def radius_from_depth(xp, d, R, h, wavelength):
    v1 = wavelength / 6.283185307179586
    v4 = d / v1 * (R / v1)
    v5 = xp.sqrt(v4)
    v9 = 62.01255336059963 * h * R / wavelength ** 2.0

    def f16(v17):
        v20 = struve_h0(xp, v17)
        v22 = v17 * v17 + v9 * v17 * v20
        v31 = v17 * (2.0 * v17 + v9 * (v20 + v17 * (0.6366197723675814 - struve_h1(xp, v17)))) / v22
        return (v22, v31)
    v16 = v5 / xp.sqrt(1.0 + 0.6366197723675814 * v9 / (1.0 + v5 * v5))
    return v1 * newton(xp, f16, v4, v16, xp.inf, 1e-06, xp.inf)


def radius_from_force(xp, F, R, h, wavelength, E_star):
    v1 = wavelength / 6.283185307179586
    v7 = F / v1 * (R / v1) / (2.0 * E_star * v1)
    v9 = xp.cbrt(1.5 * v7)
    v13 = 62.01255336059963 * h * R / wavelength ** 2.0

    def f20(v21):
        v23 = v21 * v21
        v25 = struve_h0(xp, v21)
        v27 = struve_h1(xp, v21)
        v31 = 0.6666666666666666 * v21 * v23 + v13 * (v23 * v25 - v21 * v27)
        return (v31, v23 * (2.0 * v21 + v13 * (v25 + v21 * (0.6366197723675814 - v27))) / v31)
    v20 = v9 / xp.cbrt(1.0 + 0.6366197723675814 * v13 / (1.0 + v9 * v9))
    return v1 * newton(xp, f20, v7, v20, xp.inf, 1e-06, xp.inf)


def force_from_depth(xp, d, R, h, wavelength, E_star):
    v1 = radius_from_depth(xp, d, R, h, wavelength)
    v10 = 2.0 * E_star * v1 * (d - depth(xp, v1, R, h, wavelength))
    v12 = force(xp, v1, R, h, wavelength, E_star) + xp.where((v1 > 0.0) & (v1 < xp.inf), v10, 0.0)
    return v12


def depth_from_force(xp, F, R, h, wavelength, E_star):
    v1 = radius_from_force(xp, F, R, h, wavelength, E_star)
    v10 = (F - force(xp, v1, R, h, wavelength, E_star)) / (2.0 * E_star * v1)
    return depth(xp, v1, R, h, wavelength) + xp.where((v1 > 0.0) & (v1 < xp.inf), v10, 0.0)


def energy(xp, a, R, h, wavelength, E_star):
    v3, v4 = nodes_along(xp, 1, a, R, h, wavelength, E_star)
    v2 = xp.arcsinh(a / a)
    v5 = v3 * v2
    v16 = 0.0 - xp.expm1(-2.0 * v2)
    v17 = v16 > 0.0
    v13 = xp.exp(-v5) * (0.0 - xp.expm1(-2.0 * (v2 - v5)))
    v21 = a * (v13 / xp.where(v17, xp.where(v17, v16, 1.0), xp.inf))
    v23 = depth(xp, a, R, h, wavelength) - depth(xp, v21, R, h, wavelength)
    return E_star * (v2 * xp.sum(v4 * (v23 * v23 * xp.sqrt(a * a + v21 * v21)), axis=0))


def load_within(xp, r, a, R, h, wavelength, E_star):
    v10, v11 = nodes_along(xp, 1, r, a, R, h, wavelength, E_star)
    v1 = xp.minimum(r, a)
    v4 = v1 > 0.0
    v5 = xp.where(v4, v1, 1.0)
    v6 = v5 * v5
    v7 = difference_root(xp, a, v5)
    v9 = xp.arcsinh(v7 / v5)
    v12 = v10 * v9
    v22 = 0.0 - xp.expm1(-2.0 * v9)
    v23 = v22 > 0.0
    v19 = xp.exp(-v12) * (0.0 - xp.expm1(-2.0 * (v9 - v12)))
    v27 = v7 * (v19 / xp.where(v23, xp.where(v23, v22, 1.0), xp.inf))
    v30 = xp.sqrt(v6 + v27 * v27)
    v36 = v6 * (v9 * xp.sum(v11 * (slope(xp, v30, R, h, wavelength) * (v27 / (v30 + v27))), axis=0))
    return force(xp, v1, R, h, wavelength, E_star) + 2.0 * E_star * xp.where(v4, v36, 0.0)
