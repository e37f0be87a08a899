"""Programs of axicontact.viscoelastic.capped_cylinder."""

from __future__ import annotations

from math import exp, inf, pow, sin, sqrt

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(0.0)
C1 = np.array(np.inf)
C2 = np.array(134217729.0)
C3 = np.array(1.3333333333333333)
C4 = np.array(2.0)
C5 = np.array(3.141592653589793)


def step_force_kelvin_voigt(t, d, a, R, E, eta):
    if t.__class__ is d.__class__ is a.__class__ is R.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            v10 = R * d
            v11 = a * a
            v14 = 134217729.0 * R
            v16 = v14 - (v14 - R)
            v17 = R - v16
            v18 = 134217729.0 * d
            v20 = v18 - (v18 - d)
            v21 = d - v20
            v30 = 134217729.0 * a
            v32 = v30 - (v30 - a)
            v33 = a - v32
            v44 = (v10 - v11 + (v16 * v20 - v10 + v16 * v21 + v17 * v20 + v17 * v21 - (v32 * v32 - v11 + v32 * v33 + v33 * v32 + v33 * v33))) / R
            v45 = sqrt(v10)
            v51 = a * a / R
            value = (E if t > 0.0 else inf) * (1.3333333333333333 * (v45 if v45 < a or v45 != v45 else a) * (d if d < v51 or d != d else v51) + 2.0 * a * (v44 if v44 > 0.0 or v44 != v44 else 0.0))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_kelvin_voigt_t(d, a, R, E, eta):
    v9 = R * d
    v10 = a * a
    v11 = v9 - v10
    v13 = (134217729.0) * R
    v14 = v13 - R
    v15 = v13 - v14
    v16 = R - v15
    v17 = (134217729.0) * d
    v18 = v17 - d
    v19 = v17 - v18
    v20 = d - v19
    v21 = v15 * v19
    v22 = v21 - v9
    v23 = v15 * v20
    v24 = v22 + v23
    v25 = v16 * v19
    v26 = v24 + v25
    v27 = v16 * v20
    v28 = v26 + v27
    v29 = (134217729.0) * a
    v30 = v29 - a
    v31 = v29 - v30
    v32 = a - v31
    v33 = v31 * v31
    v34 = v33 - v10
    v35 = v31 * v32
    v36 = v34 + v35
    v37 = v32 * v31
    v38 = v36 + v37
    v39 = v32 * v32
    v40 = v38 + v39
    v41 = v28 - v40
    v42 = v11 + v41
    v43 = v42 / R
    v44 = np.sqrt(v9)
    v45 = np.minimum(v44, a)
    v47 = (1.3333333333333333) * v45
    v49 = np.square(a)
    v50 = v49 / R
    v51 = np.minimum(d, v50)
    v52 = v47 * v51
    v53 = (2.0) * a
    v54 = np.maximum(v43, (0.0))
    v55 = v53 * v54
    v56 = v52 + v55
    return (E, v56)


def block_step_force_kelvin_voigt_t(out, t, E, v56, m0):
    size = out.size
    np.greater(t, C0, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some8 = np.count_nonzero(m0)
    if some8:
        np.copyto(out, E)
    if some8 != size:
        np.copyto(out, C1, where=~m0)
    np.multiply(out, v56, out)


def prepare_step_force_kelvin_voigt_all():
    return ()


def block_step_force_kelvin_voigt_all(out, t, d, a, R, E, eta, t0, t1, t2, t3, t4, t5, t6, t7, m0, f0):
    size = out.size
    np.greater(t, C0, m0)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    some8 = np.count_nonzero(m0)
    if some8:
        np.copyto(out, E)
    if some8 != size:
        np.copyto(out, C1, where=~m0)
    np.multiply(R, d, t0)
    np.multiply(a, a, t1)
    np.subtract(t0, t1, t2)
    np.multiply(C2, R, t3)
    np.subtract(t3, R, t4)
    np.subtract(t3, t4, t4)
    np.subtract(R, t4, t3)
    np.multiply(C2, d, t5)
    np.subtract(t5, d, t6)
    np.subtract(t5, t6, t6)
    np.subtract(d, t6, t5)
    np.multiply(t4, t6, t7)
    np.subtract(t7, t0, t7)
    np.multiply(t4, t5, t4)
    np.add(t7, t4, t4)
    np.multiply(t3, t6, t6)
    np.add(t4, t6, t6)
    np.multiply(t3, t5, t5)
    np.add(t6, t5, t5)
    np.multiply(C2, a, t6)
    np.subtract(t6, a, t3)
    np.subtract(t6, t3, t3)
    np.subtract(a, t3, t6)
    np.multiply(t3, t3, t4)
    np.subtract(t4, t1, t1)
    np.multiply(t3, t6, t4)
    np.add(t1, t4, t4)
    np.multiply(t6, t3, t3)
    np.add(t4, t3, t3)
    np.multiply(t6, t6, t6)
    np.add(t3, t6, t6)
    np.subtract(t5, t6, t6)
    np.add(t2, t6, t6)
    np.divide(t6, R, t6)
    np.sqrt(t0, t0)
    np.minimum(t0, a, out=t0)
    np.multiply(C3, t0, t0)
    np.square(a, t2)
    np.divide(t2, R, t2)
    np.minimum(d, t2, out=t2)
    np.multiply(t0, t2, t2)
    np.multiply(C4, a, t0)
    np.maximum(t6, f0, out=t6)
    np.multiply(t0, t6, t6)
    np.add(t2, t6, t6)
    np.multiply(out, t6, out)


def step_force_maxwell(t, d, a, R, E, tau):
    if t.__class__ is d.__class__ is a.__class__ is R.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            v10 = R * d
            v11 = a * a
            v14 = 134217729.0 * R
            v16 = v14 - (v14 - R)
            v17 = R - v16
            v18 = 134217729.0 * d
            v20 = v18 - (v18 - d)
            v21 = d - v20
            v30 = 134217729.0 * a
            v32 = v30 - (v30 - a)
            v33 = a - v32
            v44 = (v10 - v11 + (v16 * v20 - v10 + v16 * v21 + v17 * v20 + v17 * v21 - (v32 * v32 - v11 + v32 * v33 + v33 * v32 + v33 * v33))) / R
            v45 = sqrt(v10)
            v51 = a * a / R
            value = E * exp(-t / tau) * (1.3333333333333333 * (v45 if v45 < a or v45 != v45 else a) * (d if d < v51 or d != d else v51) + 2.0 * a * (v44 if v44 > 0.0 or v44 != v44 else 0.0))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_maxwell_t(d, a, R, E, tau):
    v10 = R * d
    v11 = a * a
    v12 = v10 - v11
    v14 = (134217729.0) * R
    v15 = v14 - R
    v16 = v14 - v15
    v17 = R - v16
    v18 = (134217729.0) * d
    v19 = v18 - d
    v20 = v18 - v19
    v21 = d - v20
    v22 = v16 * v20
    v23 = v22 - v10
    v24 = v16 * v21
    v25 = v23 + v24
    v26 = v17 * v20
    v27 = v25 + v26
    v28 = v17 * v21
    v29 = v27 + v28
    v30 = (134217729.0) * a
    v31 = v30 - a
    v32 = v30 - v31
    v33 = a - v32
    v34 = v32 * v32
    v35 = v34 - v11
    v36 = v32 * v33
    v37 = v35 + v36
    v38 = v33 * v32
    v39 = v37 + v38
    v40 = v33 * v33
    v41 = v39 + v40
    v42 = v29 - v41
    v43 = v12 + v42
    v44 = v43 / R
    v45 = np.sqrt(v10)
    v46 = np.minimum(v45, a)
    v48 = (1.3333333333333333) * v46
    v50 = np.square(a)
    v51 = v50 / R
    v52 = np.minimum(d, v51)
    v53 = v48 * v52
    v54 = (2.0) * a
    v56 = np.maximum(v44, (0.0))
    v57 = v54 * v56
    v58 = v53 + v57
    return (E, tau, v58)


def block_step_force_maxwell_t(out, t, E, tau, v58):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E, out, out)
    np.multiply(out, v58, out)


def prepare_step_force_maxwell_all():
    return ()


def block_step_force_maxwell_all(out, t, d, a, R, E, tau, t0, t1, t2, t3, t4, t5, t6, t7, f0):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E, out, out)
    np.multiply(R, d, t0)
    np.multiply(a, a, t1)
    np.subtract(t0, t1, t2)
    np.multiply(C2, R, t3)
    np.subtract(t3, R, t4)
    np.subtract(t3, t4, t4)
    np.subtract(R, t4, t3)
    np.multiply(C2, d, t5)
    np.subtract(t5, d, t6)
    np.subtract(t5, t6, t6)
    np.subtract(d, t6, t5)
    np.multiply(t4, t6, t7)
    np.subtract(t7, t0, t7)
    np.multiply(t4, t5, t4)
    np.add(t7, t4, t4)
    np.multiply(t3, t6, t6)
    np.add(t4, t6, t6)
    np.multiply(t3, t5, t5)
    np.add(t6, t5, t5)
    np.multiply(C2, a, t6)
    np.subtract(t6, a, t3)
    np.subtract(t6, t3, t3)
    np.subtract(a, t3, t6)
    np.multiply(t3, t3, t4)
    np.subtract(t4, t1, t1)
    np.multiply(t3, t6, t4)
    np.add(t1, t4, t4)
    np.multiply(t6, t3, t3)
    np.add(t4, t3, t3)
    np.multiply(t6, t6, t6)
    np.add(t3, t6, t6)
    np.subtract(t5, t6, t6)
    np.add(t2, t6, t6)
    np.divide(t6, R, t6)
    np.sqrt(t0, t0)
    np.minimum(t0, a, out=t0)
    np.multiply(C3, t0, t0)
    np.square(a, t2)
    np.divide(t2, R, t2)
    np.minimum(d, t2, out=t2)
    np.multiply(t0, t2, t2)
    np.multiply(C4, a, t0)
    np.maximum(t6, f0, out=t6)
    np.multiply(t0, t6, t6)
    np.add(t2, t6, t6)
    np.multiply(out, t6, out)


def step_force_power_creep(t, d, a, R, E, alpha, t_0):
    if t.__class__ is d.__class__ is a.__class__ is R.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            v11 = 3.141592653589793 * alpha
            v15 = R * d
            v16 = a * a
            v19 = 134217729.0 * R
            v21 = v19 - (v19 - R)
            v22 = R - v21
            v23 = 134217729.0 * d
            v25 = v23 - (v23 - d)
            v26 = d - v25
            v35 = 134217729.0 * a
            v37 = v35 - (v35 - a)
            v38 = a - v37
            v49 = (v15 - v16 + (v21 * v25 - v15 + v21 * v26 + v22 * v25 + v22 * v26 - (v37 * v37 - v16 + v37 * v38 + v38 * v37 + v38 * v38))) / R
            v50 = sqrt(v15)
            v56 = a * a / R
            value = E * pow(t_0 / t, alpha) * sin(v11) / v11 * (1.3333333333333333 * (v50 if v50 < a or v50 != v50 else a) * (d if d < v56 or d != d else v56) + 2.0 * a * (v49 if v49 > 0.0 or v49 != v49 else 0.0))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_power_creep_t(d, a, R, E, alpha, t_0):
    v11 = (3.141592653589793) * alpha
    v12 = np.sin(v11)
    v15 = R * d
    v16 = a * a
    v17 = v15 - v16
    v19 = (134217729.0) * R
    v20 = v19 - R
    v21 = v19 - v20
    v22 = R - v21
    v23 = (134217729.0) * d
    v24 = v23 - d
    v25 = v23 - v24
    v26 = d - v25
    v27 = v21 * v25
    v28 = v27 - v15
    v29 = v21 * v26
    v30 = v28 + v29
    v31 = v22 * v25
    v32 = v30 + v31
    v33 = v22 * v26
    v34 = v32 + v33
    v35 = (134217729.0) * a
    v36 = v35 - a
    v37 = v35 - v36
    v38 = a - v37
    v39 = v37 * v37
    v40 = v39 - v16
    v41 = v37 * v38
    v42 = v40 + v41
    v43 = v38 * v37
    v44 = v42 + v43
    v45 = v38 * v38
    v46 = v44 + v45
    v47 = v34 - v46
    v48 = v17 + v47
    v49 = v48 / R
    v50 = np.sqrt(v15)
    v51 = np.minimum(v50, a)
    v53 = (1.3333333333333333) * v51
    v55 = np.square(a)
    v56 = v55 / R
    v57 = np.minimum(d, v56)
    v58 = v53 * v57
    v59 = (2.0) * a
    v61 = np.maximum(v49, (0.0))
    v62 = v59 * v61
    v63 = v58 + v62
    return (E, alpha, t_0, v11, v12, v63)


def block_step_force_power_creep_t(out, t, E, alpha, t_0, v11, v12, v63):
    np.divide(t_0, t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.power(out, alpha, out)
    np.multiply(E, out, out)
    np.multiply(out, v12, out)
    np.divide(out, v11, out)
    np.multiply(out, v63, out)


def prepare_step_force_power_creep_all():
    return ()


def block_step_force_power_creep_all(out, t, d, a, R, E, alpha, t_0, t0, t1, t2, t3, t4, t5, t6, t7, f0):
    np.divide(t_0, t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.power(out, alpha, out)
    np.multiply(E, out, out)
    np.multiply(C5, alpha, t0)
    np.sin(t0, t1)
    np.multiply(out, t1, t1)
    np.divide(t1, t0, t0)
    np.multiply(R, d, t1)
    np.multiply(a, a, out)
    np.subtract(t1, out, t2)
    np.multiply(C2, R, t3)
    np.subtract(t3, R, t4)
    np.subtract(t3, t4, t4)
    np.subtract(R, t4, t3)
    np.multiply(C2, d, t5)
    np.subtract(t5, d, t6)
    np.subtract(t5, t6, t6)
    np.subtract(d, t6, t5)
    np.multiply(t4, t6, t7)
    np.subtract(t7, t1, t7)
    np.multiply(t4, t5, t4)
    np.add(t7, t4, t4)
    np.multiply(t3, t6, t6)
    np.add(t4, t6, t6)
    np.multiply(t3, t5, t5)
    np.add(t6, t5, t5)
    np.multiply(C2, a, t6)
    np.subtract(t6, a, t3)
    np.subtract(t6, t3, t3)
    np.subtract(a, t3, t6)
    np.multiply(t3, t3, t4)
    np.subtract(t4, out, out)
    np.multiply(t3, t6, t4)
    np.add(out, t4, t4)
    np.multiply(t6, t3, t3)
    np.add(t4, t3, t3)
    np.multiply(t6, t6, t6)
    np.add(t3, t6, t6)
    np.subtract(t5, t6, t6)
    np.add(t2, t6, t6)
    np.divide(t6, R, t6)
    np.sqrt(t1, t1)
    np.minimum(t1, a, out=t1)
    np.multiply(C3, t1, t1)
    np.square(a, t2)
    np.divide(t2, R, t2)
    np.minimum(d, t2, out=t2)
    np.multiply(t1, t2, t2)
    np.multiply(C4, a, t1)
    np.maximum(t6, f0, out=t6)
    np.multiply(t1, t6, t6)
    np.add(t2, t6, t6)
    np.multiply(t0, t6, out)


def step_force_standard_solid(t, d, a, R, E_inf, E_1, tau):
    if t.__class__ is d.__class__ is a.__class__ is R.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            v12 = R * d
            v13 = a * a
            v16 = 134217729.0 * R
            v18 = v16 - (v16 - R)
            v19 = R - v18
            v20 = 134217729.0 * d
            v22 = v20 - (v20 - d)
            v23 = d - v22
            v32 = 134217729.0 * a
            v34 = v32 - (v32 - a)
            v35 = a - v34
            v46 = (v12 - v13 + (v18 * v22 - v12 + v18 * v23 + v19 * v22 + v19 * v23 - (v34 * v34 - v13 + v34 * v35 + v35 * v34 + v35 * v35))) / R
            v47 = sqrt(v12)
            v53 = a * a / R
            value = (E_inf + E_1 * exp(-t / tau)) * (1.3333333333333333 * (v47 if v47 < a or v47 != v47 else a) * (d if d < v53 or d != d else v53) + 2.0 * a * (v46 if v46 > 0.0 or v46 != v46 else 0.0))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_step_force_standard_solid_t(d, a, R, E_inf, E_1, tau):
    v12 = R * d
    v13 = a * a
    v14 = v12 - v13
    v16 = (134217729.0) * R
    v17 = v16 - R
    v18 = v16 - v17
    v19 = R - v18
    v20 = (134217729.0) * d
    v21 = v20 - d
    v22 = v20 - v21
    v23 = d - v22
    v24 = v18 * v22
    v25 = v24 - v12
    v26 = v18 * v23
    v27 = v25 + v26
    v28 = v19 * v22
    v29 = v27 + v28
    v30 = v19 * v23
    v31 = v29 + v30
    v32 = (134217729.0) * a
    v33 = v32 - a
    v34 = v32 - v33
    v35 = a - v34
    v36 = v34 * v34
    v37 = v36 - v13
    v38 = v34 * v35
    v39 = v37 + v38
    v40 = v35 * v34
    v41 = v39 + v40
    v42 = v35 * v35
    v43 = v41 + v42
    v44 = v31 - v43
    v45 = v14 + v44
    v46 = v45 / R
    v47 = np.sqrt(v12)
    v48 = np.minimum(v47, a)
    v50 = (1.3333333333333333) * v48
    v52 = np.square(a)
    v53 = v52 / R
    v54 = np.minimum(d, v53)
    v55 = v50 * v54
    v56 = (2.0) * a
    v58 = np.maximum(v46, (0.0))
    v59 = v56 * v58
    v60 = v55 + v59
    return (E_inf, E_1, tau, v60)


def block_step_force_standard_solid_t(out, t, E_inf, E_1, tau, v60):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E_1, out, out)
    np.add(E_inf, out, out)
    np.multiply(out, v60, out)


def prepare_step_force_standard_solid_all():
    return ()


def block_step_force_standard_solid_all(out, t, d, a, R, E_inf, E_1, tau, t0, t1, t2, t3, t4, t5, t6, t7, f0):
    np.negative(t, out)
    largest_t = largest(t)
    if largest_t == np.inf:
        raise FloatingPointError
    np.divide(out, tau, out)
    np.exp(out, out)
    np.multiply(E_1, out, out)
    np.add(E_inf, out, out)
    np.multiply(R, d, t0)
    np.multiply(a, a, t1)
    np.subtract(t0, t1, t2)
    np.multiply(C2, R, t3)
    np.subtract(t3, R, t4)
    np.subtract(t3, t4, t4)
    np.subtract(R, t4, t3)
    np.multiply(C2, d, t5)
    np.subtract(t5, d, t6)
    np.subtract(t5, t6, t6)
    np.subtract(d, t6, t5)
    np.multiply(t4, t6, t7)
    np.subtract(t7, t0, t7)
    np.multiply(t4, t5, t4)
    np.add(t7, t4, t4)
    np.multiply(t3, t6, t6)
    np.add(t4, t6, t6)
    np.multiply(t3, t5, t5)
    np.add(t6, t5, t5)
    np.multiply(C2, a, t6)
    np.subtract(t6, a, t3)
    np.subtract(t6, t3, t3)
    np.subtract(a, t3, t6)
    np.multiply(t3, t3, t4)
    np.subtract(t4, t1, t1)
    np.multiply(t3, t6, t4)
    np.add(t1, t4, t4)
    np.multiply(t6, t3, t3)
    np.add(t4, t3, t3)
    np.multiply(t6, t6, t6)
    np.add(t3, t6, t6)
    np.subtract(t5, t6, t6)
    np.add(t2, t6, t6)
    np.divide(t6, R, t6)
    np.sqrt(t0, t0)
    np.minimum(t0, a, out=t0)
    np.multiply(C3, t0, t0)
    np.square(a, t2)
    np.divide(t2, R, t2)
    np.minimum(d, t2, out=t2)
    np.multiply(t0, t2, t2)
    np.multiply(C4, a, t0)
    np.maximum(t6, f0, out=t6)
    np.multiply(t0, t6, t6)
    np.add(t2, t6, t6)
    np.multiply(out, t6, out)


BLOCKS = {
    ('_step_force_kelvin_voigt', 1, 't', 'd', 'a', 'R', 'E', 'eta'): {
        ('t',): (('t',), prepare_step_force_kelvin_voigt_t, block_step_force_kelvin_voigt_t, 0, 1, (), False),
        ('t', 'd', 'a', 'R', 'E', 'eta'): (('t', 'd', 'a', 'R', 'E', 'eta'), prepare_step_force_kelvin_voigt_all, block_step_force_kelvin_voigt_all, 8, 1, (0.0,), False),
    },
    ('_step_force_maxwell', 1, 't', 'd', 'a', 'R', 'E', 'tau'): {
        ('t',): (('t',), prepare_step_force_maxwell_t, block_step_force_maxwell_t, 0, 0, (), False),
        ('t', 'd', 'a', 'R', 'E', 'tau'): (('t', 'd', 'a', 'R', 'E', 'tau'), prepare_step_force_maxwell_all, block_step_force_maxwell_all, 8, 0, (0.0,), False),
    },
    ('_step_force_power_creep', 1, 't', 'd', 'a', 'R', 'E', 'alpha', 't_0'): {
        ('t',): (('t',), prepare_step_force_power_creep_t, block_step_force_power_creep_t, 0, 0, (), False),
        ('t', 'd', 'a', 'R', 'E', 'alpha', 't_0'): (('t', 'd', 'a', 'R', 'E', 'alpha', 't_0'), prepare_step_force_power_creep_all, block_step_force_power_creep_all, 8, 0, (0.0,), False),
    },
    ('_step_force_standard_solid', 1, 't', 'd', 'a', 'R', 'E_inf', 'E_1', 'tau'): {
        ('t',): (('t',), prepare_step_force_standard_solid_t, block_step_force_standard_solid_t, 0, 0, (), False),
        ('t', 'd', 'a', 'R', 'E_inf', 'E_1', 'tau'): (('t', 'd', 'a', 'R', 'E_inf', 'E_1', 'tau'), prepare_step_force_standard_solid_all, block_step_force_standard_solid_all, 8, 0, (0.0,), False),
    },
}
