"""Formulas of axicontact._runtime.physics.retraction over an array library `xp`."""

from ....._runtime.steps import fading
from ....._runtime.steps import fraction
from ....._runtime.steps import rising


def lag_maxwell(xp, t, t_m, ratio, E, tau):
    v6 = ratio * xp.expm1(xp.minimum(xp.maximum(t - t_m, 0.0) / tau, 700.0))
    v7 = v6 < 1.0
    v14 = xp.where(v7, 2.0 * 1.0, v6)
    v13 = -tau * xp.log1p(-xp.minimum(xp.where(v7, v6, 0.5 * 1.0), 0.9999999999999998))
    return xp.where(v7, v13, xp.inf)


def earlier(xp, t, t_m, lag):
    v1 = t > t_m
    v2 = xp.where(v1, t, 2.0 * t_m)
    return xp.where(v1, xp.maximum(t_m - lag, 0.0), xp.where(v1, 0.5 * t_m, t))


def end_maxwell(xp, ratio, t_m, E, tau):
    return t_m + tau * xp.log1p(-xp.expm1(-t_m / tau) / ratio)


def lag_kelvin_voigt(xp, t, t_m, ratio, E, eta):
    return ratio * (xp.maximum(t - t_m, 0.0) + eta / E)


def end_kelvin_voigt(xp, ratio, t_m, E, eta):
    return t_m + xp.maximum(t_m / ratio - eta / E, 0.0)


def slowed(xp, x, k):
    v3 = 1.0 + k
    v6 = xp.maximum(k, 1.0)
    v7 = xp.log(v6)
    v9 = v7 + (v6 - x)
    v10 = v9 > 1.0
    v12 = xp.maximum(xp.where(v10, v9, 2.0 * 1.0), 1.0)
    v16 = xp.where(v10, 0.5 * 1.0, v9)
    v20 = v16 - xp.log1p(xp.exp(xp.minimum(v16, 1.0)))
    v22 = v7 - xp.where(v10, xp.log(v12 - xp.log(v12)), v20)
    v26 = xp.where((k > 1.0) & (2.0 * x > v3), v22, xp.maximum(x / v3, x - k))
    v30 = -xp.expm1(-v26)
    v38 = xp.maximum(v26 + (x - v26 - k * v30) / (1.0 + k * (1.0 - v30)), 0.0)
    v42 = -xp.expm1(-v38)
    v50 = xp.maximum(v38 + (x - v38 - k * v42) / (1.0 + k * (1.0 - v42)), 0.0)
    v54 = -xp.expm1(-v50)
    v62 = xp.maximum(v50 + (x - v50 - k * v54) / (1.0 + k * (1.0 - v54)), 0.0)
    v66 = -xp.expm1(-v62)
    v74 = xp.maximum(v62 + (x - v62 - k * v66) / (1.0 + k * (1.0 - v66)), 0.0)
    v78 = -xp.expm1(-v74)
    v86 = xp.maximum(v74 + (x - v74 - k * v78) / (1.0 + k * (1.0 - v78)), 0.0)
    v90 = -xp.expm1(-v86)
    v98 = xp.maximum(v86 + (x - v86 - k * v90) / (1.0 + k * (1.0 - v90)), 0.0)
    v102 = -xp.expm1(-v98)
    v110 = xp.maximum(v98 + (x - v98 - k * v102) / (1.0 + k * (1.0 - v102)), 0.0)
    v114 = -xp.expm1(-v110)
    v122 = xp.maximum(v110 + (x - v110 - k * v114) / (1.0 + k * (1.0 - v114)), 0.0)
    v126 = -xp.expm1(-v122)
    v134 = xp.maximum(v122 + (x - v122 - k * v126) / (1.0 + k * (1.0 - v126)), 0.0)
    v138 = -xp.expm1(-v134)
    v146 = xp.maximum(v134 + (x - v134 - k * v138) / (1.0 + k * (1.0 - v138)), 0.0)
    v150 = -xp.expm1(-v146)
    v158 = xp.maximum(v146 + (x - v146 - k * v150) / (1.0 + k * (1.0 - v150)), 0.0)
    v162 = -xp.expm1(-v158)
    v170 = xp.maximum(v158 + (x - v158 - k * v162) / (1.0 + k * (1.0 - v162)), 0.0)
    v174 = -xp.expm1(-v170)
    v182 = xp.maximum(v170 + (x - v170 - k * v174) / (1.0 + k * (1.0 - v174)), 0.0)
    v186 = -xp.expm1(-v182)
    v194 = xp.maximum(v182 + (x - v182 - k * v186) / (1.0 + k * (1.0 - v186)), 0.0)
    v198 = -xp.expm1(-v194)
    v206 = xp.maximum(v194 + (x - v194 - k * v198) / (1.0 + k * (1.0 - v198)), 0.0)
    v210 = -xp.expm1(-v206)
    v218 = xp.maximum(v206 + (x - v206 - k * v210) / (1.0 + k * (1.0 - v210)), 0.0)
    v222 = -xp.expm1(-v218)
    v230 = xp.maximum(v218 + (x - v218 - k * v222) / (1.0 + k * (1.0 - v222)), 0.0)
    v234 = -xp.expm1(-v230)
    v242 = xp.maximum(v230 + (x - v230 - k * v234) / (1.0 + k * (1.0 - v234)), 0.0)
    v246 = -xp.expm1(-v242)
    v254 = xp.maximum(v242 + (x - v242 - k * v246) / (1.0 + k * (1.0 - v246)), 0.0)
    v258 = -xp.expm1(-v254)
    return xp.maximum(v254 + (x - v254 - k * v258) / (1.0 + k * (1.0 - v258)), 0.0)


def lag_standard_solid(xp, t, t_m, ratio, E_inf, E_1, tau):
    v3 = xp.maximum(t - t_m, 0.0) / tau
    v4 = E_1 / E_inf
    v5 = -v3
    return tau * slowed(xp, ratio * (v3 - v4 * xp.expm1(v5)), v4 * xp.exp(v5))


def end_standard_solid(xp, ratio, t_m, E_inf, E_1, tau):
    v1 = t_m / tau
    v2 = E_1 / E_inf
    v6 = -v2 * xp.expm1(-v1)
    return t_m + tau * slowed(xp, (v1 + v6) / ratio, v2 + v6 / ratio)


def lag_power_creep(xp, t, t_m, ratio, E, alpha, t_0):
    v8 = xp.maximum(t - t_m, 0.0) * xp.expm1(xp.minimum(xp.log1p(ratio) / (1.0 - alpha), 700.0))
    return v8


def end_power_creep(xp, ratio, t_m, E, alpha, t_0):
    return t_m + t_m / xp.expm1(xp.minimum(xp.log1p(ratio) / (1.0 - alpha), 700.0))


def kept_maxwell(xp, t, t_1, since, m, E, tau):
    return E * xp.exp(-since / tau) * fading(xp, t_1 / tau, m)


def kept_standard_solid(xp, t, t_1, since, m, E_inf, E_1, tau):
    return E_inf + E_1 * xp.exp(-since / tau) * fading(xp, t_1 / tau, m)


def kept_power_creep(xp, t, t_1, since, m, E, alpha, t_0):
    v4 = 1.0 - alpha
    v8 = E * (t_0 / t) ** alpha * xp.sin(3.141592653589793 * xp.minimum(alpha, v4))
    v11 = t_1 / t
    v15 = (m + 1.0) / (m + 2.0 + v4)
    v16 = v11 < v15
    v22 = fraction(xp, xp.minimum(xp.where(v16, v11, 0.5 * v15), v15), m, v4)
    v25 = m + v4
    v33 = rising(xp, v25, 1.0 + m - v25) * rising(xp, 1.0, 1.0 + v4 - 1.0) / v4
    v41 = xp.minimum(xp.minimum(since / t, 1.0), 1.0 - v15)
    v36 = v33 / xp.maximum(xp.where(v16, 2.0 * v15, v11), v15) ** m
    v46 = v36 - m / v4 * v41 ** v4 * fraction(xp, v41, v4, m)
    v47 = xp.where(v16, xp.minimum(since / t, 1.0) ** v4 * v22, v46)
    return v8 / (3.141592653589793 * alpha) * v47
