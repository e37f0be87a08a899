"""Formulas of axicontact._runtime.physics.adhesion over an array library `xp`."""

from ....._programs.expressions._runtime.integrals import difference_root
from ....._runtime.steps import newton
from ....._runtime.steps import nodes_along


def hess_retraction(xp, a, E_star, dgamma):
    return xp.sqrt(a) * xp.sqrt(6.283185307179586 * dgamma / E_star)


def pull(xp, a, E_star, dgamma):
    return 2.0 * E_star * a * hess_retraction(xp, a, E_star, dgamma)


def tension(xp, r, a, E_star, dgamma):
    v1 = r <= a
    v3 = hess_retraction(xp, a, E_star, dgamma)
    v4 = v3 > 0.0
    v8 = 3.141592653589793 * difference_root(xp, a, xp.where(v1, r, 0.5 * a))
    v11 = xp.where(v1, 2.0 * a, r)
    return xp.where(v1, xp.where(v4, E_star * xp.where(v4, v3, 1.0) / v8, 0.0), 0.0)


def lift(xp, r, a, E_star, dgamma):
    v2 = r > a
    v7 = xp.where(v2, 0.5 * a, r)
    v6 = 0.6366197723675814 * xp.arctan2(a, difference_root(xp, xp.where(v2, r, 2.0 * a), a))
    return hess_retraction(xp, a, E_star, dgamma) * xp.where(v2, v6, 1.0)


def separation(xp, load, a, E_star):
    return (load / a) ** 2.0 / (25.132741228718345 * E_star * a)


def growth(xp, e, m):
    v36, v37 = nodes_along(xp, 1, e, m)
    v1 = e * m
    v2 = v1 < 1.0
    v3 = xp.where(v2, v1, 0.5 * 1.0)
    v7 = xp.where(v2, 2.0 * 1.0, v1)
    v9 = (m - 1.0) * e
    v20 = m * xp.expm1(xp.log1p(v9 + m * xp.expm1(xp.log1p(v9 + m * 0.0) / m)) / m)
    v27 = xp.maximum(m, 2.0)

    def f27(v28):
        v30 = xp.minimum(v28, 4.0) * v27
        v31 = v30 < 4.0
        v32 = xp.where(v31, v30, 0.5 * 4.0)
        v33 = xp.minimum(v28, 2.0)
        v38 = v36 * 1.0
        v46 = 1.0 * xp.sum(v37 * ((1.0 - v38) * xp.exp((m - 2.0) * xp.log1p(v33 * v38))), axis=0)
        v48 = xp.where(v31, 2.0 * 4.0, v30)
        v49 = 1.0 + v28
        v51 = m - 1.0
        v53 = v51 * xp.log1p(v28)
        v62 = v49 * (m * xp.where((v28 > 1.0) & (v53 > 1.0), v49 ** v51 - 1.0, xp.expm1(v53)) / v51)
        v65 = xp.where(v31, m * v33 * v33 * v46, v62 / m - v28)
        v67 = m - 1.0
        v69 = v67 * xp.log1p(v28)
        v78 = m * xp.where((v28 > 1.0) & (v69 > 1.0), (1.0 + v28) ** v67 - 1.0, xp.expm1(v69)) / v67
        return (v65, v28 * v78 / v65)
    v25 = xp.where(v2, xp.sqrt(2.0 * e / m), xp.expm1(xp.log1p(v9 + v20) / m))
    return newton(xp, f27, e, v25, xp.inf, xp.minimum(m, 2.0), v27)
