"""Formulas of axicontact.graded.normal.gaussian over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import gaussian_displacement
from ....._programs.expressions._runtime.graded.growth import gaussian_depth
from ....._programs.expressions._runtime.graded.growth import gaussian_force
from ....._programs.expressions._runtime.graded.growth import gaussian_rate
from ....._programs.expressions._runtime.graded.inverse import gaussian_reach
from ....._programs.expressions._runtime.graded.pressure import gaussian_pressure
from ....._programs.expressions._runtime.graded.punch import punch_depth
from ....._programs.expressions._runtime.graded.punch import punch_force
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions.normal.gaussian import profile
from ....._runtime.steps import newton


def depth(xp, a, h, s, k):
    v2 = h * gaussian_rate(xp, a, s, k)
    v3 = v2 >= 0.0
    v4 = xp.where(v3, v2, 1.0)
    return xp.where(v3, h * gaussian_depth(xp, a, s, k), xp.nan)


def force(xp, a, h, s, H, k):
    v2 = h * gaussian_rate(xp, a, s, k)
    v3 = v2 >= 0.0
    v4 = xp.where(v3, v2, 1.0)
    return xp.where(v3, 2.0 * H / (1.0 + k) * (h * gaussian_force(xp, a, s, k)), xp.nan)


def pressure(xp, r, a, h, s, H, k):
    v2 = h * gaussian_rate(xp, a, s, k)
    v3 = v2 >= 0.0
    v4 = xp.where(v3, v2, 1.0)
    v5 = r < a
    v10 = h * gaussian_pressure(xp, xp.minimum(xp.where(v5, r, 0.5 * a), a), a, s, k)
    v12 = xp.where(v5, 2.0 * a, r)
    return xp.where(v3, xp.where(v5, H / 3.141592653589793 * v10, 0.0), xp.nan)


def displacement(xp, r, a, h, s, k):
    return h * gaussian_displacement(xp, r, a, s, k)


def stiffness(xp, a, H, k):
    return punch_stiffness(xp, a, H, k)


def mean_pressure(xp, a, h, s, H, k):
    v1 = a > 0.0
    v2 = xp.where(v1, a, 1.0)
    return xp.where(v1, force(xp, v2, h, s, H, k) / (3.141592653589793 * v2 * v2), 0.0)


def radius_from_depth(xp, d, h, s, k):
    v1 = d + 0.0
    v2 = gaussian_reach(xp, s, k)
    v3 = v2 * 0.9999999999999982
    v7 = xp.where(xp.isnan(depth(xp, v3, h, s, k)), v2 * 0.9999999999708962, v3)
    v11 = xp.where(xp.isnan(depth(xp, v7, h, s, k)), v2 * 0.9999990463256836, v7)
    v15 = xp.where(xp.isnan(depth(xp, v11, h, s, k)), v2 * 0.9990234375, v11)
    v19 = xp.where(xp.isnan(depth(xp, v15, h, s, k)), v2 * 0.96875, v15)
    v20 = depth(xp, v19, h, s, k)
    v21 = v20 * 1.0000000000000036
    v22 = v1 <= v21
    v23 = xp.where(v22, v1, 0.5 * v21)
    v25 = 6.661338147750939e-16 * v20
    v27 = v23 / xp.maximum(v20 - v23, v25)
    v32 = -xp.expm1(-(v19 / s) ** 2.0)

    def f34(v35):
        v37 = 1.0 + v35 / v32
        v38 = v35 / v37
        v42 = xp.sqrt(-xp.log1p(-v38))
        v43 = s * v42
        v44 = depth(xp, v43, h, s, k)
        v46 = xp.maximum(v20 - v44, v25)
        v57 = v35 * (s / (2.0 * v42 * (1.0 - v38)) / v37 ** 2.0) * (h * gaussian_rate(xp, v43, s, k))
        return (v44 / v46, v57 * (1.0 / v44 + 1.0 / v46))
    v62 = newton(xp, f34, v27, v32 * xp.sqrt(v27), xp.inf, 1e-06, xp.inf)
    v71 = xp.where(v22, 2.0 * v21, v1)
    return xp.where(v22, s * xp.sqrt(-xp.log1p(-(v62 / (1.0 + v62 / v32)))), xp.nan)


def force_rate(xp, a, h, s, H, k):
    return punch_stiffness(xp, a, H, k) * (h * gaussian_rate(xp, a, s, k))


def radius_from_force(xp, F, h, s, H, k):
    v1 = F + 0.0
    v2 = gaussian_reach(xp, s, k)
    v3 = v2 * 0.9999999999999982
    v7 = xp.where(xp.isnan(force(xp, v3, h, s, H, k)), v2 * 0.9999999999708962, v3)
    v11 = xp.where(xp.isnan(force(xp, v7, h, s, H, k)), v2 * 0.9999990463256836, v7)
    v15 = xp.where(xp.isnan(force(xp, v11, h, s, H, k)), v2 * 0.9990234375, v11)
    v19 = xp.where(xp.isnan(force(xp, v15, h, s, H, k)), v2 * 0.96875, v15)
    v20 = force(xp, v19, h, s, H, k)
    v21 = v20 * 1.0000000000000036
    v22 = v1 <= v21
    v23 = xp.where(v22, v1, 0.5 * v21)
    v25 = 6.661338147750939e-16 * v20
    v27 = v23 / xp.maximum(v20 - v23, v25)
    v32 = -xp.expm1(-(v19 / s) ** 2.0)

    def f34(v35):
        v37 = 1.0 + v35 / v32
        v38 = v35 / v37
        v42 = xp.sqrt(-xp.log1p(-v38))
        v43 = s * v42
        v44 = force(xp, v43, h, s, H, k)
        v46 = xp.maximum(v20 - v44, v25)
        v56 = v35 * (s / (2.0 * v42 * (1.0 - v38)) / v37 ** 2.0) * force_rate(xp, v43, h, s, H, k)
        return (v44 / v46, v56 * (1.0 / v44 + 1.0 / v46))
    v61 = newton(xp, f34, v27, v32 * xp.sqrt(v27), xp.inf, 1e-06, xp.inf)
    v70 = xp.where(v22, 2.0 * v21, v1)
    return xp.where(v22, s * xp.sqrt(-xp.log1p(-(v61 / (1.0 + v61 / v32)))), xp.nan)


def force_from_depth(xp, d, h, s, H, k):
    v1 = radius_from_depth(xp, d, h, s, k)
    return force(xp, v1, h, s, H, k) + punch_force(xp, d - depth(xp, v1, h, s, k), v1, H, k)


def depth_from_force(xp, F, h, s, H, k):
    v1 = radius_from_force(xp, F, h, s, H, k)
    return depth(xp, v1, h, s, k) + punch_depth(xp, F - force(xp, v1, h, s, H, k), v1, H, k)
