"""Formulas of axicontact._runtime.physics.slip over an array library `xp`."""

from ....._programs.expressions._runtime.integrals import difference_root
from ....._runtime.steps import nodes_along


def log_ratio(xp, a, c):
    v1 = a > c
    v6 = xp.where(v1, 0.5 * c, a)
    return xp.where(v1, xp.log1p((xp.where(v1, a, 2.0 * c) - c) / c), 0.0)


def gained_share(xp, c, a, n):
    return -xp.expm1(-n * log_ratio(xp, a, c))


def stick_force(xp, F, F_x, mu):
    v2 = F - F_x / mu
    v3 = xp.absolute(v2)
    v4 = 2e-16 * F
    v5 = v3 <= v4
    v6 = xp.where(v5, v3, 0.5 * v4)
    v7 = xp.where(v5, 2.0 * v4, v3)
    v8 = xp.where(v5, 0.0, v2)
    v9 = v8 >= 0.0
    return xp.where(v9, xp.where(v9, v8, 1.0), xp.nan)


def gap(xp, a, c, outer, inner):
    v1 = a > c
    v2 = xp.where(v1, a, 2.0 * c)
    v8 = xp.where(v1, 0.5 * c, a)
    return xp.where(v1, (v2 - c) * (v2 + c) / (outer + inner), 0.0)


def root_gain(xp, r, c, a):
    v1 = a > c
    v2 = xp.where(v1, a, 2.0 * c)
    v10 = xp.where(v1, 0.5 * c, a)
    v9 = (v2 - c) * (v2 + c) / (difference_root(xp, v2, r) + difference_root(xp, c, r))
    return xp.where(v1, v9, 0.0)


def arc_gain(xp, r, c, a):
    return xp.log1p((a - c + root_gain(xp, r, c, a)) / (c + difference_root(xp, c, r)))


def weight(xp, s):
    v1 = s > 0.0
    v2 = xp.where(v1, s, 1.0)
    v10 = xp.where(v1, 2.0 * v2 / xp.sqrt(-xp.expm1(-2.0 * v2 * v2)), 1.4142135623730951)
    return v10


def power_gain(xp, r, c, a, n):
    v52, v53 = nodes_along(xp, 1, r, c, a, n)
    v2 = xp.absolute(n - 1.0)
    v3 = v2 > 0.0
    v4 = xp.where(v3, v2, 1.0)
    v5 = n > 1.0
    v6 = xp.where(v5, n, 2.0 * 1.0)
    v13 = r > 0.0
    v14 = xp.where(v13, r, 1.0)
    v15 = log_ratio(xp, a, c)
    v17 = 42.0 / xp.maximum(v4, 0.001)
    v18 = v15 > v17
    v19 = xp.where(v18, v15, 2.0 * v17)
    v20 = xp.where(v5, n, 2.0 * 1.0)
    v23 = xp.where(v5, 0.5 * 1.0, n)
    v26 = xp.where(v5, xp.sqrt(log_ratio(xp, a, v14)), xp.sqrt(log_ratio(xp, c, v14)))
    v28 = xp.where(v5, n, 2.0 * 1.0)
    v29 = xp.where(v5, 0.5 * 1.0, n)
    v35 = xp.maximum(v26 * v26 + (1.0 - 2.0 * xp.where(v5, 1.0, 0.0)) * v17, 0.0)
    v36 = v35 > 0.0
    v47 = xp.sqrt(log_ratio(xp, a, v14)) + xp.sqrt(log_ratio(xp, c, v14))
    v41 = v17 / (v26 + xp.where(v36, xp.sqrt(xp.where(v36, v35, 1.0)), 0.0))
    v49 = xp.where(v18, v41, xp.where(v18, 0.5 * v17, v15) / v47)
    v50 = v49 > 0.0
    v51 = xp.where(v50, v49, 1.0)
    v54 = v52 * v51
    v56 = xp.where(v5, n, 2.0 * 1.0)
    v59 = xp.where(v5, 0.5 * 1.0, n)
    v62 = xp.where(v5, xp.sqrt(log_ratio(xp, a, v14)), xp.sqrt(log_ratio(xp, c, v14)))
    v64 = xp.where(v5, n, 2.0 * 1.0)
    v65 = xp.where(v5, 0.5 * 1.0, n)
    v69 = (1.0 - 2.0 * xp.where(v5, 1.0, 0.0)) * v54
    v77 = xp.exp(-v4 * (v54 * (2.0 * v62 + v69))) * weight(xp, xp.maximum(v62 + v69, 0.0))
    v85 = v4 > 0.0
    v88 = -xp.expm1(-v4 * log_ratio(xp, a, c)) / xp.where(v85, xp.where(v85, v4, 1.0), 1.0)
    v89 = xp.where(v13, xp.where(v50, v51 * xp.sum(v53 * v77, axis=0), 0.0), v88)
    v90 = xp.where(v5, 1.0, (c / a) ** xp.where(v5, 0.5 * 1.0, n) * (a / c)) * v89
    return xp.where(v3, v90, arc_gain(xp, r, c, a))
