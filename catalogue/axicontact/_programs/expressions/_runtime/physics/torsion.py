"""Formulas of axicontact._runtime.physics.torsion over an array library `xp`."""

from ....._programs.expressions._runtime.integrals import difference_root
from ....._programs.expressions._runtime.physics.circle import elliptic
from ....._programs.expressions._runtime.special import arctan_gap
from ....._runtime.steps import nodes_along


def turned_below(xp, r, z, a):
    v3 = r - a
    v4 = r + a
    v7 = v3 * v4 + z * z
    v8 = v7 > 0.0
    v23 = xp.sqrt(0.5 * (xp.hypot(v3, z) * xp.hypot(v4, z) + xp.absolute(v7)))
    v24 = v23 > 0.0
    v25 = xp.where(v24, v23, 1.0)
    v27 = v25 > 0.0
    v31 = xp.where(v24, z * a / xp.where(v27, xp.where(v27, v25, 1.0), 1.0), 0.0)
    v16 = xp.sqrt(0.5 * (xp.hypot(v3, z) * xp.hypot(v4, z) + xp.absolute(xp.where(v8, v7, 1.0))))
    v32 = xp.where(v8, v16, v31)
    v33 = v32 > a
    v34 = xp.where(v33, v32, 2.0 * a)
    v35 = v34 > a
    v37 = xp.where(v35, 0.5 * a, v34)
    v39 = a / xp.where(v35, xp.where(v35, v34, 2.0 * a), a)
    v40 = v39 * v39
    v46 = xp.where(v33, 0.5 * a, v32)
    v47 = v46 > a
    v48 = xp.where(v47, v46, 2.0 * a)
    v51 = xp.where(v47, 0.0, xp.where(v47, 0.5 * a, v46)) / a
    v57 = 1.5707963267948966 - xp.arctan(v51) - v51 / (1.0 + v51 * v51)
    v58 = xp.where(v33, v40 * v39 / (1.0 + v40) - arctan_gap(xp, v39), v57)
    return 2.0 * r / 3.141592653589793 * v58


def turned(xp, a, c):
    v1 = c / a
    v2 = v1 < 1e-08
    v7 = xp.where(v2, 2.0 * 1e-08, v1)
    v14 = v7 < 1e-08
    v15 = xp.where(v14, v7, 0.5 * 1e-08)
    v17 = xp.where(v14, 1.0, xp.where(v14, 2.0 * 1e-08, v7))
    v13 = 0.7853981633974483 * ((a - c) / a * ((a + c) / a))
    v21 = v13 * (elliptic(xp, v17, 1.0) - elliptic(xp, v17, 0.0))
    return a * xp.where(v2, xp.log(4.0 / xp.where(v2, v1, 0.5 * 1e-08)) - 1.0, v21)


def slipping_torque(xp, a, c):
    v19, v20 = nodes_along(xp, 1, a, c)
    v2 = xp.maximum(c, 1e-09 * a)
    v8 = difference_root(xp, a, v2)
    v11 = a > v2
    v12 = xp.where(v11, a, 2.0 * v2)
    v14 = xp.maximum(c, 1e-09 * v12)
    v15 = difference_root(xp, v12, v14)
    v16 = v15 / v14
    v18 = xp.arcsinh(0.7071067811865476 * v16)
    v21 = v19 * v18
    v23 = xp.sinh(v21) / v16
    v29 = v14 * xp.cosh(v21)
    v38 = 0.5 * v29 * xp.arctan(v16 * v23) + 0.5 * v14 * v15 * v23 / v29
    v43 = v19 * 0.7853981633974483
    v44 = xp.sin(v43)
    v46 = xp.cos(v43)
    v52 = xp.sqrt(v14 * v14 + (v15 * v46) ** 2.0)
    v61 = 0.5 * v52 * xp.arctan(v16 * v46) + 0.5 * v14 * v15 * v46 / v52
    v42 = v18 * xp.sum(v20 * (xp.sqrt(1.0 - v23 * v23) * v23 * v38 * v29 / v15), axis=0)
    v65 = xp.where(v11, 0.5 * v2, a)
    v64 = v42 + 0.7853981633974483 * xp.sum(v20 * (v44 * v44 * v46 * v61), axis=0)
    v7 = v2 * v2 ** 2.0 / 3.0 * turned(xp, a, v2)
    return 5.092958178940651 * (v7 + v8 * v8 ** 2.0 * xp.where(v11, v64, 0.0))


def slipping_traction(xp, r, a, c):
    v23, v24 = nodes_along(xp, 1, r, a, c)
    v1 = r < c
    v2 = xp.where(v1, r, 0.5 * c)
    v4 = v2 < c
    v5 = xp.where(v4, v2, 0.5 * c)
    v7 = v5 < c
    v9 = xp.where(v7, 2.0 * c, v5)
    v10 = xp.where(v7, xp.where(v7, v5, 0.5 * c), 0.0)
    v11 = difference_root(xp, c, v10)
    v21 = xp.where(v4, 2.0 * c, v2)
    v20 = xp.log1p((a - c) / (c + v11) * (1.0 + (a + c) / (difference_root(xp, a, v10) + v11)))
    v22 = xp.where(v4, v20, 0.0)
    v25 = v23 * v22
    v29 = xp.where(v4, 2.0 * c, v2)
    v33 = difference_root(xp, c, xp.where(v4, xp.where(v4, v2, 0.5 * c), 0.0)) * xp.sinh(v25)
    v34 = c * xp.cosh(v25) + v33
    v37 = xp.minimum(v34 / a, 1.0)
    v41 = v22 * xp.sum(v24 * (a / v34 * elliptic(xp, v37, v37 * v37)), axis=0)
    v46 = 0.6366197723675814 * difference_root(xp, a, xp.minimum(xp.where(v1, 2.0 * c, r), a))
    return xp.where(v1, v2 / 3.141592653589793 * v41, v46)
