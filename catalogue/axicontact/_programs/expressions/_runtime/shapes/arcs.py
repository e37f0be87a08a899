"""Formulas of axicontact._runtime.shapes.arcs over an array library `xp`."""

from ....._programs.expressions._runtime.integrals import difference_root
from ....._runtime.steps import nodes_along


def arc_strips(xp, r, a, R):
    v14, v15 = nodes_along(xp, 1, r, a, R)
    v1 = difference_root(xp, a, r)
    v2 = a + v1
    v3 = difference_root(xp, R, r)
    v4 = R + v3
    v5 = v2 / v4
    v6 = v5 > 0.7
    v7 = xp.where(v6, v5, 2.0 * 0.7)
    v8 = a < R
    v9 = xp.where(v8, a, 0.5 * R)
    v12 = difference_root(xp, v9, r) / difference_root(xp, R, v9)
    v13 = xp.arcsinh(v12)
    v16 = v14 * v13
    v27 = 0.0 - xp.expm1(-2.0 * v13)
    v28 = v27 > 0.0
    v24 = xp.exp(-v16) * (0.0 - xp.expm1(-2.0 * (v13 - v16)))
    v32 = v12 * (v24 / xp.where(v28, xp.where(v28, v27, 1.0), xp.inf))
    v35 = xp.sqrt(1.0 + v32 * v32)
    v37 = v3 * (v32 / v35)
    v40 = xp.sqrt(r * r + v37 * v37)
    v41 = v3 / v35
    v48 = xp.where(v8, 2.0 * R, a)
    v47 = v13 * xp.sum(v15 * (xp.arcsinh(v40 / v41) / v40 * (v41 / v35)), axis=0)
    v50 = xp.where(v6, 0.5 * 0.7, v5)
    v53 = v50 * v50
    v55 = 0.13579013365982337 * v53 + -0.4846453962188766
    v57 = v55 * v53 + 0.8293825948837366
    v59 = v57 * v53 + -0.8745573865774817
    v61 = v59 * v53 + 0.6371928816963097
    v63 = v61 * v53 + -0.3332798652335896
    v65 = v63 * v53 + 0.13289328569967984
    v67 = v65 * v53 + -0.03710676078458442
    v69 = v67 * v53 + 0.011089560042611895
    v71 = v69 * v53 + 0.0012521687336059639
    v73 = v71 * v53 + 0.0036572276005780893
    v75 = v73 * v53 + 0.004425450516633092
    v77 = v75 * v53 + 0.005918487051520244
    v79 = v77 * v53 + 0.008264397984935742
    v81 = v79 * v53 + 0.012345681107818056
    v83 = v81 * v53 + 0.020408163224119494
    v85 = v83 * v53 + 0.04000000000042643
    v87 = v85 * v53 + 0.11111111111110937
    v92 = r * (r / v2) / v4
    v95 = v92 * v92
    v105 = ((((0.0 * v95 + 0.13579013365982337) * v95 + v55) * v95 + v57) * v95 + v59) * v95 + v61
    v117 = (((((v105 * v95 + v63) * v95 + v65) * v95 + v67) * v95 + v69) * v95 + v71) * v95 + v73
    v129 = (((((v117 * v95 + v75) * v95 + v77) * v95 + v79) * v95 + v81) * v95 + v83) * v95 + v85
    v134 = 2.0 * v1 / v4 * (v87 * v53 + 1.0 + v92 * (v92 + v50) * (v129 * v95 + v87))
    return xp.where(v6, xp.where(v8, v47, xp.inf), v134)
