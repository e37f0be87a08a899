"""Formulas of axicontact._runtime.graded.slip over an array library `xp`."""

from ....._programs.expressions._runtime.graded.rules import raised
from ....._programs.expressions._runtime.integrals import difference_root
from ....._runtime.steps import nodes_along


def span(xp, c, a, distance):
    v1 = a > c
    v2 = xp.where(v1, a, 2.0 * c)
    v10 = xp.where(v1, 0.5 * c, a)
    return xp.where(v1, 0.5 * xp.log1p((v2 - c) / distance * ((v2 + c) / distance)), 0.0)


def power_growth(xp, r, c, a, n, k):
    v34, v35 = nodes_along(xp, 4, r, c, a, n, k)
    v2 = n + (k - 1.0)
    v3 = v2 >= 0.0
    v4 = xp.where(v3, v2, 1.0)
    v5 = xp.where(v3, a, c)
    v9 = xp.where(v3, v2, 1.0)
    v11 = difference_root(xp, c, r)
    v12 = xp.where(v3, difference_root(xp, a, r), v11)
    v17 = difference_root(xp, a, r)
    v20 = n - 2.0
    v25 = (a / v17) ** 2.0 * -xp.expm1(-84.0 / xp.maximum(v20, 0.001))
    v31 = -0.5 * xp.log1p(-xp.minimum(v25, 0.9999999999999999))
    v33 = xp.minimum(span(xp, c, a, v11), xp.where((n > 2.0) & (v25 < 1.0), v31, xp.inf))
    v36 = v34 * v33
    v37 = xp.where(v3, v2, 1.0)
    v40 = 1.0 - 2.0 * xp.where(v3, 1.0, 0.0)
    v47 = xp.where(v3, v2, 1.0)
    v49 = v47 >= 0.0
    v50 = xp.where(v49, v47, 1.0)
    v52 = xp.where(v49, v47, 1.0)
    v58 = xp.where(v49, v17, v11) * xp.exp((1.0 - 2.0 * xp.where(v49, 1.0, 0.0)) * v36)
    v46 = v12 * v12 * xp.absolute(xp.expm1(2.0 * v40 * v36))
    v66 = v20 * (0.5 * xp.log1p(v46 / xp.where(v3, r * r + v58 * v58, c * c)))
    v72 = v33 * xp.sum(v35 * xp.exp(v40 * (v66 + (1.0 + k) * v36)), axis=0)
    return v5 ** n / v5 / v5 * raised(xp, v12, k) * v72
