"""Formulas of axicontact._runtime.shapes.ring over an array library `xp`."""

from ....._runtime.steps import nodes_along


def start(xp, m, k):
    v1 = m < 2.0
    v2 = xp.where(v1, m, 0.5 * 2.0)
    v3 = 1.0 - k
    v8 = 1.2732395447351628 * xp.sin(1.5707963267948966 * v3) / (1.0 + k)
    v17 = 0.36 + 0.4 * k
    v20 = (2.0 * xp.expm1(-0.5 * v3 * xp.log(v3 / 4.0)) - v8) * (1.0 + v17) * v2
    v28 = xp.log1p((v8 + v20 / (v2 + 2.0 * xp.maximum(v17, 0.0))) / v2) / v3
    v36 = xp.where(v1, 2.0 * 2.0, m)
    v37 = 1.0 - k
    v42 = 1.2732395447351628 * xp.sin(1.5707963267948966 * v37) / (1.0 + k)
    v51 = 0.36 + 0.4 * k
    v54 = (2.0 * xp.expm1(-0.5 * v37 * xp.log(v37 / 4.0)) - v42) * (1.0 + v51) * v36
    v62 = xp.log1p((v42 + v54 / (v36 + 2.0 * xp.maximum(v51, 0.0))) / v36) / v37
    return xp.where(v1, xp.maximum(v28, xp.log(v2 * (v2 + 2.0) / (2.0 * v3)) / v2), v62)


def balance(xp, length, m, k):
    v3, v4 = nodes_along(xp, 1, length, m, k)
    v2 = (1.0 - k) * length
    v5 = v3 * 1.0
    v7 = v5 ** 2.0 * v5
    v9 = v7 * v7 * v5
    v11 = v9 * v5
    v12 = 1.0 - v11
    v15 = -2.0 * length
    v18 = -xp.expm1(v15 * v11)
    v20 = -xp.expm1(v15)
    v28 = xp.expm1(m * length * v11)
    v38 = v28 - 0.5 * m * (v28 + 1.0) * v18 * (-xp.expm1(v15 * v12) / v20)
    v41 = 8.0 * v9 * (xp.exp(v2 * v12) * (v18 / v20) ** ((k - 1.0) / 2.0) * v38 / v18)
    return v2 * (1.0 * xp.sum(v4 * v41, axis=0))


def log_ratio(xp, n, k):
    v1 = n > 2.0
    v3 = xp.where(v1, 0.5 * 2.0, n)
    v4 = xp.where(v1, xp.where(v1, n, 2.0 * 2.0), 3.0)
    v5 = v4 - 2.0
    v6 = start(xp, v5, k)
    v7 = balance(xp, v6, v5, k)
    v11 = 1.0 + k
    v12 = (1.0 - k) * v11
    v18 = -xp.expm1(-2.0 * v6)
    v20 = v4 - 1.0 + k
    v26 = xp.maximum(v20 - v4 * xp.exp(-2.0 * xp.minimum(v6, 300.0)), v11)
    v30 = 2.0 * v20
    v35 = v12 * xp.exp(v5 * v6) / (v18 * v26) + (v7 - 1.0) * (v30 / v26 - v11 / v18)
    v37 = v6 - xp.log(v7) * v7 / v35
    v38 = balance(xp, v37, v5, k)
    v46 = -xp.expm1(-2.0 * v37)
    v52 = xp.maximum(v20 - v4 * xp.exp(-2.0 * xp.minimum(v37, 300.0)), v11)
    v60 = v12 * xp.exp(v5 * v37) / (v46 * v52) + (v38 - 1.0) * (v30 / v52 - v11 / v46)
    v62 = v37 - xp.log(v38) * v38 / v60
    v63 = balance(xp, v62, v5, k)
    v71 = -xp.expm1(-2.0 * v62)
    v77 = xp.maximum(v20 - v4 * xp.exp(-2.0 * xp.minimum(v62, 300.0)), v11)
    v85 = v12 * xp.exp(v5 * v62) / (v71 * v77) + (v63 - 1.0) * (v30 / v77 - v11 / v71)
    v87 = v62 - xp.log(v63) * v63 / v85
    v88 = balance(xp, v87, v5, k)
    v96 = -xp.expm1(-2.0 * v87)
    v102 = xp.maximum(v20 - v4 * xp.exp(-2.0 * xp.minimum(v87, 300.0)), v11)
    v110 = v12 * xp.exp(v5 * v87) / (v96 * v102) + (v88 - 1.0) * (v30 / v102 - v11 / v96)
    v112 = v87 - xp.log(v88) * v88 / v110
    v113 = balance(xp, v112, v5, k)
    v121 = -xp.expm1(-2.0 * v112)
    v127 = xp.maximum(v20 - v4 * xp.exp(-2.0 * xp.minimum(v112, 300.0)), v11)
    v135 = v12 * xp.exp(v5 * v112) / (v121 * v127) + (v113 - 1.0) * (v30 / v127 - v11 / v121)
    return v112 - xp.log(v113) * v113 / v135


def lifted_at_zero_pressure(xp, n, k):
    v9, v10 = nodes_along(xp, 1, n, k)
    v1 = n > 2.0
    v2 = xp.where(v1, n, 2.0 * 2.0)
    v3 = 1.0 + k
    v7 = log_ratio(xp, v2, k)
    v11 = v9 * 1.0
    v13 = v11 ** 2.0 * v11
    v15 = v13 * v13 * v11
    v21 = v15 * v11
    v25 = -2.0 * v7
    v33 = (-xp.expm1(v25 * v21) / -xp.expm1(v25)) ** (v3 / 2.0)
    v35 = 8.0 * v15 * (xp.exp(-(v2 - 3.0 + k) * v7 * (1.0 - v21)) * v33)
    v40 = v2 * v3 / ((v2 - 2.0) * (1.0 - (v2 - 4.0) * v7 * (1.0 * xp.sum(v10 * v35, axis=0))))
    return xp.where(v1, v40, xp.where(v1, 0.5 * 2.0, n) - 1.0 + k)


def ring_of_zero_pressure(xp, n, k):
    v1 = n > 2.0
    v6 = xp.where(v1, 0.5 * 2.0, n)
    return xp.where(v1, xp.exp(-log_ratio(xp, xp.where(v1, n, 2.0 * 2.0), k)), 0.0)


def outside_zero_pressure(xp, n, k):
    v1 = n > 2.0
    v7 = xp.where(v1, 0.5 * 2.0, n)
    v8 = xp.where(v1, -xp.expm1(-2.0 * log_ratio(xp, xp.where(v1, n, 2.0 * 2.0), k)), 1.0)
    return v8
