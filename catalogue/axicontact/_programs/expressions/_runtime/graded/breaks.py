"""Formulas of axicontact._runtime.graded.breaks over an array library `xp`."""

from ....._programs.expressions._runtime.graded.growth import sphere_depth
from ....._programs.expressions._runtime.graded.growth import sphere_force
from ....._programs.expressions._runtime.graded.growth import sphere_rate
from ....._programs.expressions._runtime.graded.rules import raised
from ....._programs.expressions._runtime.graded.rules import sine_mean
from ....._programs.expressions._runtime.graded.rules import sine_over
from ....._programs.expressions._runtime.integrals import difference_root
from ....._runtime.steps import nodes_along
from ....._runtime.steps import weighted_along


def rim_depth(xp, a, root, b, k):
    return a * a * raised(xp, root / a, k) / (1.0 + k) + 0.0 * b


def rim_force(xp, a, root, b, k):
    v5 = root / xp.maximum(a, b)
    v8 = 3.0 + k
    v9 = 1.0 + k
    v15 = a * a * raised(xp, a, k) * raised(xp, v5, k) * (v8 - v9 * v5 ** 2.0) / (v9 * v8)
    return v15 + 0.0 * b


def rim_rate(xp, t, root, b, k):
    v1 = t < b
    v2 = xp.where(v1, t, 0.5 * b)
    v3 = xp.where(v1, 2.0 * b, t)
    v8 = xp.where(v1, b, root) / v3
    v15 = xp.where(v1, 0.0, v3 * ((1.0 - k) / (1.0 + k) * raised(xp, v8, k) + v8 ** (k - 1.0)))
    return v15


def tip(xp, a, root, b, k):
    v1 = 1.0 + k
    v2 = 0.5 * a
    v3 = root < v2
    v7 = xp.where(v3, 2.0 * v2, root)
    v8 = xp.where(v3, v2, root)
    v14 = 0.5 * xp.log1p(-(xp.minimum(b, a) / a) ** 2.0)
    v19 = -xp.expm1(v1 * xp.where(v3, xp.log(xp.where(v3, root, 0.5 * v2) / a), v14)) / v1
    return v19


def rounded_depth(xp, a, root, b, k):
    v1 = a < b
    v6 = xp.where(v1, 2.0 * b, a)
    v7 = xp.where(v1, b, root)
    v11 = xp.arctan2(v7, b)
    v15 = v6 / b * tip(xp, v6, v7, b, k) + raised(xp, v11, k) * sine_mean(xp, v11, k)
    return a * xp.where(v1, xp.where(v1, a, 0.5 * b) / b / (1.0 + k), v15)


def flank_force(xp, a, root, b, k):
    v3 = xp.maximum(a, b)
    v8 = xp.arctan2(root, b)
    v12 = raised(xp, root / v3, k) * (b / v3) + raised(xp, v8, k) * sine_mean(xp, v8, k)
    return a * raised(xp, a, k) * v12 / (2.0 + k)


def rounded_force(xp, a, root, b, k):
    v3 = a < b
    v11 = xp.where(v3, 2.0 * b, a)
    v12 = xp.where(v3, b, root)
    v18 = v11 / b * (tip(xp, v11, v12, b, k) - tip(xp, v11, v12, b, k + 2.0))
    v23 = v18 + flank_force(xp, v11, v12, b, k) / (v11 * raised(xp, v11, k))
    v24 = xp.where(v3, 2.0 * xp.where(v3, a, 0.5 * b) / b / ((1.0 + k) * (3.0 + k)), v23)
    return a * raised(xp, a, k) * v24


def rounded_rate(xp, t, root, b, k):
    v1 = t < b
    v7 = xp.where(v1, 2.0 * b, t)
    v8 = xp.where(v1, b, root)
    v13 = xp.arctan2(v8, b)
    v17 = 2.0 * v7 / b * tip(xp, v7, v8, b, k) + raised(xp, v13, k) * sine_mean(xp, v13, k)
    return xp.where(v1, 2.0 * xp.where(v1, t, 0.5 * b) / b / (1.0 + k), v17)


def rounding_rate(xp, t, root, b, k):
    v7 = xp.arctan2(root, b)
    v6 = 2.0 * t * raised(xp, root / t, k) / (1.0 + k)
    return v6 - b * (raised(xp, v7, k) * sine_mean(xp, v7, k))


def rounding_depth(xp, a, root, b, k):
    v2 = xp.arctan2(root, b)
    v5, v6 = weighted_along(xp, 1.0 + k, a, root, b, k)
    v7 = v5 * v2
    v18 = 2.0 * xp.sin((v2 + v7) / 2.0) * xp.sin((v2 - v7) / 2.0) * sine_over(xp, v7) ** k
    return a * a * (raised(xp, v2, k) * xp.sum(v6 * v18, axis=0))


def rounding_force(xp, a, root, b, k):
    v4 = xp.arctan2(root, b)
    v7, v8 = weighted_along(xp, 1.0 + k, a, root, b, k)
    v9 = v7 * v4
    v20 = 2.0 * xp.sin((v4 + v9) / 2.0) * xp.sin((v4 - v9) / 2.0) * xp.cos(v9) ** 2.0
    v25 = raised(xp, v4, k) * xp.sum(v8 * (v20 * sine_over(xp, v9) ** k), axis=0)
    return a * a * raised(xp, a, k) * v25


def flank_depth(xp, a, root, b, k):
    v1 = xp.arctan2(root, b)
    return a * (raised(xp, v1, k) * sine_mean(xp, v1, k))


def tipped_depth(xp, a, root, R, b, end, k):
    v16, v17 = nodes_along(xp, 1, a, root, R, b, end, k)
    v1 = root > 0.0
    v2 = xp.where(v1, root, 1.0)
    v6 = v2 > 0.0
    v9 = xp.where(v6, xp.minimum(xp.where(v6, v2, 1.0), end), end)
    v15 = xp.log1p((b / v9) ** 2.0) / 4.0 + 0.0 * a
    v18 = v16 * v15
    v23 = v9 * xp.exp(v18)
    v25 = v9 * xp.expm1(v18) * (v23 + v9)
    v27 = xp.sqrt(v2 * v2 + v25)
    v36 = v27 ** k * (1.0 / xp.sqrt(end * end + v25)) * v23 * (v23 / v27)
    v40 = xp.hypot(v9, b)
    v41 = -(v16 * v15)
    v43 = v40 * xp.exp(v41)
    v44 = 2.0 * v9
    v45 = v43 > v44
    v48 = xp.where(v45, 0.5 * v44, v43)
    v54 = b * (b / (v40 + v9)) + v40 * xp.expm1(v41)
    v57 = xp.where(v45, xp.where(v45, v43, 2.0 * v44) - v9, v54) * (v43 + v9)
    v59 = xp.sqrt(v2 * v2 + v57)
    v68 = v59 ** k * (1.0 / xp.sqrt(end * end + v57)) * v43 * (v43 / v59)
    v71 = a ** (-k) * a * (v15 * xp.sum(v17 * v36, axis=0) + v15 * xp.sum(v17 * v68, axis=0))
    v76 = xp.minimum(a, b)
    v78 = sphere_depth(xp, v76, difference_root(xp, R, v76), k)
    return xp.where(v1, v71 + b / end * flank_depth(xp, a, v2, b, k), v78)


def tipped_force(xp, a, root, R, b, end, k):
    v13, v14 = nodes_along(xp, 1, a, root, R, b, end, k)
    v1 = root > 0.0
    v2 = xp.where(v1, root, 1.0)
    v3 = v2 > 0.0
    v6 = xp.where(v3, xp.minimum(xp.where(v3, v2, 1.0), end), end)
    v12 = xp.log1p((b / v6) ** 2.0) / 4.0 + 0.0 * a
    v15 = v13 * v12
    v20 = v6 * xp.exp(v15)
    v22 = v6 * xp.expm1(v15) * (v20 + v6)
    v24 = xp.sqrt(v2 * v2 + v22)
    v35 = v24 ** k * ((b * b - v22) / xp.sqrt(end * end + v22)) * v20 * (v20 / v24)
    v39 = xp.hypot(v6, b)
    v40 = -(v13 * v12)
    v42 = v39 * xp.exp(v40)
    v43 = 2.0 * v6
    v44 = v42 > v43
    v47 = xp.where(v44, 0.5 * v43, v42)
    v53 = b * (b / (v39 + v6)) + v39 * xp.expm1(v40)
    v56 = xp.where(v44, xp.where(v44, v42, 2.0 * v43) - v6, v53) * (v42 + v6)
    v58 = xp.sqrt(v2 * v2 + v56)
    v69 = v58 ** k * ((b * b - v56) / xp.sqrt(end * end + v56)) * v42 * (v42 / v58)
    v71 = v12 * xp.sum(v14 * v35, axis=0) + v12 * xp.sum(v14 * v69, axis=0)
    v76 = xp.minimum(a, b)
    v78 = sphere_force(xp, v76, difference_root(xp, R, v76), k)
    return xp.where(v1, v71 + b / end * flank_force(xp, a, v2, b, k), v78)


def past_tip(xp, x, R, b, end):
    v1 = end < b
    v2 = xp.where(v1, end, 0.5 * b)
    v8 = xp.where(v1, 2.0 * b, end)
    return xp.where(v1, x - R + v2 * (v2 / (R + b)), x - b)


def tipped_rate(xp, t, root, R, b, end, k):
    v15, v16 = nodes_along(xp, 1, t, root, R, b, end, k)
    v1 = root > 0.0
    v2 = xp.where(v1, root, 1.0)
    v5 = v2 > 0.0
    v8 = xp.where(v5, xp.minimum(xp.where(v5, v2, 1.0), end), end)
    v14 = xp.log1p((b / v8) ** 2.0) / 4.0 + 0.0 * t
    v17 = v15 * v14
    v22 = v8 * xp.exp(v17)
    v24 = v8 * xp.expm1(v17) * (v22 + v8)
    v26 = xp.sqrt(v2 * v2 + v24)
    v30 = xp.sqrt(end * end + v24)
    v38 = v26 ** k * ((1.0 + (R / v30) ** 2.0) / v30) * v22 * (v22 / v26)
    v42 = xp.hypot(v8, b)
    v43 = -(v15 * v14)
    v45 = v42 * xp.exp(v43)
    v46 = 2.0 * v8
    v47 = v45 > v46
    v50 = xp.where(v47, 0.5 * v46, v45)
    v56 = b * (b / (v42 + v8)) + v42 * xp.expm1(v43)
    v59 = xp.where(v47, xp.where(v47, v45, 2.0 * v46) - v8, v56) * (v45 + v8)
    v61 = xp.sqrt(v2 * v2 + v59)
    v65 = xp.sqrt(end * end + v59)
    v73 = v61 ** k * ((1.0 + (R / v65) ** 2.0) / v65) * v45 * (v45 / v61)
    v78 = xp.arctan2(v2, b)
    v76 = t ** (-k) * (v14 * xp.sum(v16 * v38, axis=0) + v14 * xp.sum(v16 * v73, axis=0))
    v84 = xp.minimum(t, b)
    v83 = v76 + b / end * (raised(xp, v78, k) * sine_mean(xp, v78, k))
    return xp.where(v1, v83, sphere_rate(xp, v84, difference_root(xp, R, v84), k))


def flank_rate(xp, t, root, b, k):
    v1 = t < b
    v2 = xp.where(v1, t, 0.5 * b)
    v3 = xp.where(v1, 2.0 * b, t)
    v4 = xp.where(v1, b, root)
    v5 = xp.arctan2(v4, b)
    v14 = raised(xp, v5, k) * sine_mean(xp, v5, k) + b / v3 * (v4 / v3) ** (k - 1.0)
    return xp.where(v1, 0.0, v14)
