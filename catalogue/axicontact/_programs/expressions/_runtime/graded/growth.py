"""Formulas of axicontact._runtime.graded.growth over an array library `xp`."""

from ....._programs.expressions._runtime.graded.rules import raised
from ....._programs.expressions._runtime.graded.rules import sine_mean
from ....._programs.expressions._runtime.graded.rules import sine_over
from ....._programs.expressions._runtime.graded.rules import sinh_over
from ....._runtime.steps import nodes_along
from ....._runtime.steps import rising
from ....._runtime.steps import weighted_along


def power_factor(xp, n, k):
    v1 = 1.0 + k
    v4 = v1 / 2.0
    v12 = (v1 + n) / v1 * rising(xp, 1.0, 1.0 + v4 - 1.0) / rising(xp, 1.0 + n / 2.0, v4)
    return v12


def power_force(xp, a, n, k):
    return power_factor(xp, n, k) * (n / (n + (1.0 + k))) * a ** n * raised(xp, a, k)


def axis_power(xp, n, k):
    v1 = n < 0.5
    v8 = xp.where(v1, k - 1.0 + xp.where(v1, n, 0.5 * 0.5), xp.where(v1, 2.0 * 0.5, n) - 1.0 + k)
    return v8


def power_excess(xp, n, k):
    v1 = n / 2.0
    v5 = (1.0 - k) / 2.0
    v7 = (1.0 + k) / 2.0
    v12 = 0.0 + xp.log1p(v1 / (1.0 + v1) * (v5 / (0.0 + v7)))
    v19 = v12 + xp.log1p(v1 / (2.0 + v1) * (v5 / (1.0 + v7)))
    v26 = v19 + xp.log1p(v1 / (3.0 + v1) * (v5 / (2.0 + v7)))
    v33 = v26 + xp.log1p(v1 / (4.0 + v1) * (v5 / (3.0 + v7)))
    v40 = v33 + xp.log1p(v1 / (5.0 + v1) * (v5 / (4.0 + v7)))
    v47 = v40 + xp.log1p(v1 / (6.0 + v1) * (v5 / (5.0 + v7)))
    v54 = v47 + xp.log1p(v1 / (7.0 + v1) * (v5 / (6.0 + v7)))
    v61 = v54 + xp.log1p(v1 / (8.0 + v1) * (v5 / (7.0 + v7)))
    v68 = v61 + xp.log1p(v1 / (9.0 + v1) * (v5 / (8.0 + v7)))
    v75 = v68 + xp.log1p(v1 / (10.0 + v1) * (v5 / (9.0 + v7)))
    v82 = v75 + xp.log1p(v1 / (11.0 + v1) * (v5 / (10.0 + v7)))
    v89 = v82 + xp.log1p(v1 / (12.0 + v1) * (v5 / (11.0 + v7)))
    v96 = v89 + xp.log1p(v1 / (13.0 + v1) * (v5 / (12.0 + v7)))
    v103 = v96 + xp.log1p(v1 / (14.0 + v1) * (v5 / (13.0 + v7)))
    v110 = v103 + xp.log1p(v1 / (15.0 + v1) * (v5 / (14.0 + v7)))
    v117 = v110 + xp.log1p(v1 / (16.0 + v1) * (v5 / (15.0 + v7)))
    v124 = v117 + xp.log1p(v1 / (17.0 + v1) * (v5 / (16.0 + v7)))
    v131 = v124 + xp.log1p(v1 / (18.0 + v1) * (v5 / (17.0 + v7)))
    v138 = v131 + xp.log1p(v1 / (19.0 + v1) * (v5 / (18.0 + v7)))
    v145 = v138 + xp.log1p(v1 / (20.0 + v1) * (v5 / (19.0 + v7)))
    v152 = v145 + xp.log1p(v1 / (21.0 + v1) * (v5 / (20.0 + v7)))
    v159 = v152 + xp.log1p(v1 / (22.0 + v1) * (v5 / (21.0 + v7)))
    v166 = v159 + xp.log1p(v1 / (23.0 + v1) * (v5 / (22.0 + v7)))
    v173 = v166 + xp.log1p(v1 / (24.0 + v1) * (v5 / (23.0 + v7)))
    v180 = v173 + xp.log1p(v1 / (25.0 + v1) * (v5 / (24.0 + v7)))
    v187 = v180 + xp.log1p(v1 / (26.0 + v1) * (v5 / (25.0 + v7)))
    v194 = v187 + xp.log1p(v1 / (27.0 + v1) * (v5 / (26.0 + v7)))
    v201 = v194 + xp.log1p(v1 / (28.0 + v1) * (v5 / (27.0 + v7)))
    v208 = v201 + xp.log1p(v1 / (29.0 + v1) * (v5 / (28.0 + v7)))
    v215 = v208 + xp.log1p(v1 / (30.0 + v1) * (v5 / (29.0 + v7)))
    v222 = v215 + xp.log1p(v1 / (31.0 + v1) * (v5 / (30.0 + v7)))
    v229 = v222 + xp.log1p(v1 / (32.0 + v1) * (v5 / (31.0 + v7)))
    v236 = v229 + xp.log1p(v1 / (33.0 + v1) * (v5 / (32.0 + v7)))
    v243 = v236 + xp.log1p(v1 / (34.0 + v1) * (v5 / (33.0 + v7)))
    v250 = v243 + xp.log1p(v1 / (35.0 + v1) * (v5 / (34.0 + v7)))
    v257 = v250 + xp.log1p(v1 / (36.0 + v1) * (v5 / (35.0 + v7)))
    v264 = v257 + xp.log1p(v1 / (37.0 + v1) * (v5 / (36.0 + v7)))
    v271 = v264 + xp.log1p(v1 / (38.0 + v1) * (v5 / (37.0 + v7)))
    v278 = v271 + xp.log1p(v1 / (39.0 + v1) * (v5 / (38.0 + v7)))
    v287 = 40.0 + v7 / 2.0
    v293 = v287 + v1
    v297 = 1.0 / (v287 * v287)
    v300 = 1.0 / (v293 * v293)
    v306 = -v5 * (v5 * v5 - 1.0) / 24.0
    v313 = v5 + 1.0
    v315 = v5 * (v5 - 1.0) * (v5 - 2.0) * (v5 - 3.0) * v313 / 5760.0
    v318 = v315 * (5.0 * v5 + 7.0)
    v331 = 35.0 * v313 ** 2.0 + 42.0 * v313 + 16.0
    v332 = v315 * (v5 - 4.0) * (v5 - 5.0) / -504.0 * v331
    v339 = v306 + v318 * (v297 + v300) + v332 * (v297 * v297 + v297 * v300 + v300 * v300)
    v340 = -v1 * (v287 + v293) * v297 * v300 * v339
    v291 = v278 + xp.log1p(v1 / (40.0 + v1) * (v5 / (39.0 + v7))) + v5 * xp.log1p(v1 / v287)
    v348 = v291 + xp.log1p(v340 / (1.0 + v306 * v297 + v318 * v297 * v297))
    v349 = v348 < 0.5
    v352 = xp.where(v349, 2.0 * 0.5, v348)
    v355 = xp.where(v349, xp.expm1(xp.where(v349, v348, 0.5 * 0.5)), power_factor(xp, n, k) - 1.0)
    return v355


def power_rate(xp, t, n, k):
    return power_factor(xp, n, k) * n * (t ** n / t)


def steepness(xp, a, root, v, k):
    v1 = k > 0.0
    v2 = xp.where(v1, k, 1.0)
    return xp.where(v1, v / xp.sinh(v), root / a * v)


def sphere_depth(xp, a, root, k):
    v2 = root > 0.0
    v3 = xp.where(v2, root, 1.0)
    v4 = v3 > 0.0
    v6 = xp.where(v4, xp.where(v4, v3, 1.0), a)
    v8 = xp.arcsinh(a / v6)
    v14, v15 = weighted_along(xp, 1.0 + k, a, root, k)
    v19 = xp.sum(v15 * sinh_over(xp, v14 * v8) ** k, axis=0)
    v21 = k > 0.0
    v25 = a * xp.where(v21, 1.0 / xp.where(v21, k, 1.0), xp.inf)
    v26 = xp.where(v2, a * steepness(xp, a, v6, v8, k) ** k * v8 * v19, v25)
    return xp.where(a == 0.0, 0.0, v26)


def sphere_force(xp, a, root, k):
    v2 = root > 0.0
    v3 = xp.where(v2, root, 1.0)
    v6 = v3 > 0.0
    v8 = xp.where(v6, xp.where(v6, v3, 1.0), a)
    v10 = xp.arcsinh(a / v8)
    v16, v17 = weighted_along(xp, 1.0 + k, a, root, k)
    v18 = v16 * v10
    v19 = sinh_over(xp, v18)
    v27 = xp.sum(v17 * (v19 ** k * (1.0 - (v19 * (v18 / xp.sinh(v10))) ** 2.0)), axis=0)
    v34 = k > 0.0
    v37 = xp.where(v34, 1.0 / xp.where(v34, k, 1.0), xp.inf)
    v28 = a * raised(xp, a, k) * steepness(xp, a, v8, v10, k) ** k * v10 * v27
    v39 = xp.where(v2, v28, a * raised(xp, a, k) * 2.0 / (2.0 + k) * v37)
    return xp.where(a == 0.0, 0.0, v39)


def sphere_rate(xp, t, root, k):
    v30, v31 = nodes_along(xp, 1, t, root, k)
    v1 = root > 0.0
    v2 = xp.where(v1, root, 1.0)
    v3 = v2 > 0.0
    v5 = xp.where(v3, xp.where(v3, v2, 1.0), t)
    v6 = v5 / t
    v8 = xp.arcsinh(t / v5)
    v9 = xp.minimum(v8, 8.0)
    v14, v15 = weighted_along(xp, 1.0 + k, t, root, k)
    v16 = v14 * v9
    v25 = sinh_over(xp, v16) ** k * (1.0 + (xp.hypot(t, v2) / v5 / xp.cosh(v16)) ** 2.0)
    v29 = v8 - v9
    v33 = v9 + v30 * v29
    v42 = sinh_over(xp, v33) ** k * (1.0 + (xp.hypot(t, v2) / v5 / xp.cosh(v33)) ** 2.0)
    v46 = v6 ** k * (v29 * xp.sum(v31 * (v42 * v33 ** k), axis=0))
    return xp.where(v1, (v6 * v9) ** k * v9 * xp.sum(v15 * v25, axis=0) + v46, xp.inf)


def gaussian_depth(xp, a, s, k):
    v2 = (a / s) ** 2.0
    v5, v6 = weighted_along(xp, 1.0 + k, a, s, k)
    v7 = v5 * 1.0
    return 2.0 * v2 * xp.sum(v6 * xp.exp(-((1.0 - v7) * (1.0 + v7) * v2)), axis=0)


def gaussian_rate(xp, t, s, k):
    v5, v6 = weighted_along(xp, 1.0 + k, t, s, k)
    v7 = v5 * 1.0
    v13 = (1.0 - v7) * (1.0 + v7) * (t / s) ** 2.0
    v19 = xp.sum(v6 * ((1.0 - v13) * xp.exp(-xp.minimum(v13, 700.0))), axis=0)
    return 4.0 * t / s / s * v19


def gaussian_force(xp, a, s, k):
    v4, v5 = weighted_along(xp, 1.0 + k, a, s, k)
    v6 = v4 * 1.0
    v12 = (1.0 - v6) * (1.0 + v6) * (a / s) ** 2.0
    return 2.0 * raised(xp, a, k) * xp.sum(v5 * (v12 * xp.exp(-v12)), axis=0)


def hyperboloid_depth(xp, a, b, k):
    v1 = a > 0.0
    v2 = xp.where(v1, a, 1.0)
    v3 = xp.arctan2(v2, b)
    v12 = xp.where(v1, v2 * v3 * (xp.hypot(v2, b) / v2 * v3) ** k * sine_mean(xp, v3, k), 0.0)
    return v12


def hyperboloid_force(xp, a, b, k):
    v1 = a > 0.0
    v2 = xp.where(v1, a, 1.0)
    v3 = xp.hypot(v2, b)
    v5 = xp.arctan2(v2, b)
    v11, v12 = weighted_along(xp, 1.0 + k, a, b, k)
    v13 = v11 * v5
    v22 = xp.sum(v12 * (sine_over(xp, v13) ** k * xp.sin(v5 - v13) * xp.sin(v5 + v13)), axis=0)
    return xp.where(v1, v3 * v3 * v5 * (v3 * v5) ** k * v22, 0.0)


def hyperboloid_rate(xp, t, b, k):
    v1 = xp.arctan2(t, b)
    v2 = xp.hypot(t, b)
    v9 = b / v2
    v13 = v1 * (v2 / t * v1) ** k * sine_mean(xp, v1, k) * (1.0 - k * v9 ** 2.0)
    return v13 + t / v2 * v9


def power_mean(xp, a, n, k):
    v6 = a > 0.0
    v7 = xp.where(v6, a, 1.0)
    v12 = axis_power(xp, n, k)
    v13 = v12 > 0.0
    v14 = xp.where(v13, v12, 1.0)
    v15 = v12 < 0.0
    v16 = xp.where(v15, 1.0, v12)
    v19 = xp.where(v6, v7 ** n / v7 * v7 ** k, xp.where(v13, 0.0, xp.where(v15, xp.inf, 1.0)))
    return power_factor(xp, n, k) * (n / (n + (1.0 + k))) * v19
