"""Formulas of axicontact._runtime.graded.inverse over an array library `xp`."""

from ....._runtime.steps import newton
from ....._runtime.steps import weighted_along


def gaussian_reach(xp, s, k):

    def f0(v1):
        v3, v4 = weighted_along(xp, 1.0 + k, s, k)
        v5 = v3 * 1.0
        v10 = (1.0 - v5) * (1.0 + v5) * v1 ** 2.0
        v14 = xp.sum(v4 * (v10 * xp.exp(-v10)), axis=0)
        v15 = v3 * 1.0
        v24 = v14 / xp.sum(v4 * xp.exp(-((1.0 - v15) * (1.0 + v15) * v1 ** 2.0)), axis=0)
        v26 = v3 * 1.0
        v31 = (1.0 - v26) * (1.0 + v26) * v1 ** 2.0
        return (v24, 2.0 * (1.0 + v24 - xp.sum(v4 * (v31 * v31 * xp.exp(-v31)), axis=0) / v14))
    return s * newton(xp, f0, 1.0, 1.5, xp.inf, 1e-06, xp.inf)
