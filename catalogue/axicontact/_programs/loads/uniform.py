"""Programs of axicontact.loads.uniform."""

from __future__ import annotations

from math import inf, sqrt

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(np.inf)
C1 = np.array(1.0)
C2 = np.array(0.0)
C3 = np.array(2.0)


def displacement(r, a, p_0, E_star):
    if r.__class__ is a.__class__ is p_0.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (p_0 > 1e-30) and (p_0 < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v6 = r if r > a or r != r else a
            if v6 < inf:
                v7 = r if r < a or r != r else a
                v17 = sqrt((v6 - v7) / v6 * ((v6 + v7) / v6))
            else:
                v17 = 1.0
            v22 = v17 * v17 if r <= a else 0.0
            v24 = v17 if v17 > 1e-09 or v17 != v17 else 1e-09
            v25 = 1.0 + v24
            v26 = 1.0 + v22
            v29 = 2.0 * (v22 + v24)
            v31 = 2.0 * sqrt(v24)
            v34 = v26 + v29 / v25
            v37 = 2.0 * (v29 + v26 * v31)
            v38 = v31 + v25
            v40 = 2.0 * sqrt(v31 * v25)
            v43 = v34 + v37 / v38
            v46 = 2.0 * (v37 + v34 * v40)
            v47 = v40 + v38
            v49 = 2.0 * sqrt(v40 * v38)
            v52 = v43 + v46 / v47
            v55 = 2.0 * (v46 + v43 * v49)
            v56 = v49 + v47
            v58 = 2.0 * sqrt(v49 * v47)
            v61 = v52 + v55 / v56
            v64 = 2.0 * (v55 + v52 * v58)
            v65 = v58 + v56
            v67 = 2.0 * sqrt(v58 * v56)
            v70 = v61 + v64 / v65
            v73 = 2.0 * (v64 + v61 * v67)
            v74 = v67 + v65
            v76 = 2.0 * sqrt(v67 * v65)
            v79 = v70 + v73 / v74
            v82 = 2.0 * (v73 + v70 * v76)
            v83 = v76 + v74
            v85 = 2.0 * sqrt(v76 * v74)
            v92 = v85 + v83
            value = p_0 / E_star * a * (a / v6 * ((2.0 * (v82 + v79 * v85) + (v79 + v82 / v83) * v92) / (v92 * v92)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_displacement_r(a, p_0, E_star):
    v4 = p_0 / E_star
    v5 = v4 * a
    return (a, v5)


def block_displacement_r(out, r, a, v5, t0, t1, t2, t3, t4, t5, m0, f0):
    size = out.size
    np.maximum(r, a, out=out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.less(out, C0, m0)
    some17 = np.count_nonzero(m0)
    if some17:
        np.minimum(r, a, out=t0)
        np.subtract(out, t0, t1)
        np.divide(t1, out, t1)
        np.add(out, t0, t0)
        np.divide(t0, out, t0)
        np.multiply(t1, t0, t0)
        np.sqrt(t0, t0)
    if some17 != size:
        np.copyto(t0, C1, where=~m0)
    np.divide(a, out, out)
    np.less_equal(r, a, m0)
    some22 = np.count_nonzero(m0)
    if some22:
        np.multiply(t0, t0, t1)
    if some22 != size:
        np.copyto(t1, C2, where=~m0)
    np.maximum(t0, f0, out=t0)
    np.add(C1, t0, t2)
    np.add(C1, t1, t3)
    np.add(t1, t0, t1)
    np.multiply(C3, t1, t1)
    np.sqrt(t0, t0)
    np.multiply(C3, t0, t0)
    np.multiply(t0, t2, t4)
    np.divide(t1, t2, t5)
    np.add(t3, t5, t5)
    np.multiply(t3, t0, t3)
    np.add(t1, t3, t3)
    np.multiply(C3, t3, t3)
    np.add(t0, t2, t2)
    np.sqrt(t4, t4)
    np.multiply(C3, t4, t4)
    np.multiply(t4, t2, t0)
    np.divide(t3, t2, t1)
    np.add(t5, t1, t1)
    np.multiply(t5, t4, t5)
    np.add(t3, t5, t5)
    np.multiply(C3, t5, t5)
    np.add(t4, t2, t2)
    np.sqrt(t0, t0)
    np.multiply(C3, t0, t0)
    np.multiply(t0, t2, t4)
    np.divide(t5, t2, t3)
    np.add(t1, t3, t3)
    np.multiply(t1, t0, t1)
    np.add(t5, t1, t1)
    np.multiply(C3, t1, t1)
    np.add(t0, t2, t2)
    np.sqrt(t4, t4)
    np.multiply(C3, t4, t4)
    np.multiply(t4, t2, t0)
    np.divide(t1, t2, t5)
    np.add(t3, t5, t5)
    np.multiply(t3, t4, t3)
    np.add(t1, t3, t3)
    np.multiply(C3, t3, t3)
    np.add(t4, t2, t2)
    np.sqrt(t0, t0)
    np.multiply(C3, t0, t0)
    np.multiply(t0, t2, t4)
    np.divide(t3, t2, t1)
    np.add(t5, t1, t1)
    np.multiply(t5, t0, t5)
    np.add(t3, t5, t5)
    np.multiply(C3, t5, t5)
    np.add(t0, t2, t2)
    np.sqrt(t4, t4)
    np.multiply(C3, t4, t4)
    np.multiply(t4, t2, t0)
    np.divide(t5, t2, t3)
    np.add(t1, t3, t3)
    np.multiply(t1, t4, t1)
    np.add(t5, t1, t1)
    np.multiply(C3, t1, t1)
    np.add(t4, t2, t2)
    np.sqrt(t0, t0)
    np.multiply(C3, t0, t0)
    np.divide(t1, t2, t4)
    np.add(t3, t4, t4)
    np.multiply(t3, t0, t3)
    np.add(t1, t3, t3)
    np.multiply(C3, t3, t3)
    np.add(t0, t2, t2)
    np.multiply(t4, t2, t4)
    np.add(t3, t4, t4)
    np.multiply(t2, t2, t2)
    np.divide(t4, t2, t2)
    np.multiply(out, t2, t2)
    np.multiply(v5, t2, out)


def prepare_displacement_all():
    return ()


def block_displacement_all(out, r, a, p_0, E_star, t0, t1, t2, t3, t4, t5, t6, m0, f0):
    size = out.size
    np.divide(p_0, E_star, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.multiply(out, a, out)
    np.maximum(r, a, out=t0)
    np.less(t0, C0, m0)
    some17 = np.count_nonzero(m0)
    if some17:
        np.minimum(r, a, out=t1)
        np.subtract(t0, t1, t2)
        np.divide(t2, t0, t2)
        np.add(t0, t1, t1)
        np.divide(t1, t0, t1)
        np.multiply(t2, t1, t1)
        np.sqrt(t1, t1)
    if some17 != size:
        np.copyto(t1, C1, where=~m0)
    np.divide(a, t0, t0)
    np.less_equal(r, a, m0)
    some22 = np.count_nonzero(m0)
    if some22:
        np.multiply(t1, t1, t2)
    if some22 != size:
        np.copyto(t2, C2, where=~m0)
    np.maximum(t1, f0, out=t1)
    np.add(C1, t1, t3)
    np.add(C1, t2, t4)
    np.add(t2, t1, t2)
    np.multiply(C3, t2, t2)
    np.sqrt(t1, t1)
    np.multiply(C3, t1, t1)
    np.multiply(t1, t3, t5)
    np.divide(t2, t3, t6)
    np.add(t4, t6, t6)
    np.multiply(t4, t1, t4)
    np.add(t2, t4, t4)
    np.multiply(C3, t4, t4)
    np.add(t1, t3, t3)
    np.sqrt(t5, t5)
    np.multiply(C3, t5, t5)
    np.multiply(t5, t3, t1)
    np.divide(t4, t3, t2)
    np.add(t6, t2, t2)
    np.multiply(t6, t5, t6)
    np.add(t4, t6, t6)
    np.multiply(C3, t6, t6)
    np.add(t5, t3, t3)
    np.sqrt(t1, t1)
    np.multiply(C3, t1, t1)
    np.multiply(t1, t3, t5)
    np.divide(t6, t3, t4)
    np.add(t2, t4, t4)
    np.multiply(t2, t1, t2)
    np.add(t6, t2, t2)
    np.multiply(C3, t2, t2)
    np.add(t1, t3, t3)
    np.sqrt(t5, t5)
    np.multiply(C3, t5, t5)
    np.multiply(t5, t3, t1)
    np.divide(t2, t3, t6)
    np.add(t4, t6, t6)
    np.multiply(t4, t5, t4)
    np.add(t2, t4, t4)
    np.multiply(C3, t4, t4)
    np.add(t5, t3, t3)
    np.sqrt(t1, t1)
    np.multiply(C3, t1, t1)
    np.multiply(t1, t3, t5)
    np.divide(t4, t3, t2)
    np.add(t6, t2, t2)
    np.multiply(t6, t1, t6)
    np.add(t4, t6, t6)
    np.multiply(C3, t6, t6)
    np.add(t1, t3, t3)
    np.sqrt(t5, t5)
    np.multiply(C3, t5, t5)
    np.multiply(t5, t3, t1)
    np.divide(t6, t3, t4)
    np.add(t2, t4, t4)
    np.multiply(t2, t5, t2)
    np.add(t6, t2, t2)
    np.multiply(C3, t2, t2)
    np.add(t5, t3, t3)
    np.sqrt(t1, t1)
    np.multiply(C3, t1, t1)
    np.divide(t2, t3, t5)
    np.add(t4, t5, t5)
    np.multiply(t4, t1, t4)
    np.add(t2, t4, t4)
    np.multiply(C3, t4, t4)
    np.add(t1, t3, t3)
    np.multiply(t5, t3, t5)
    np.add(t4, t5, t5)
    np.multiply(t3, t3, t3)
    np.divide(t5, t3, t3)
    np.multiply(t0, t3, t3)
    np.multiply(out, t3, out)


BLOCKS = {
    ('_displacement', 1, 'r', 'a', 'p_0', 'E_star'): {
        ('r',): (('r',), prepare_displacement_r, block_displacement_r, 6, 1, (1e-09,), False),
        ('r', 'a', 'p_0', 'E_star'): (('r', 'a', 'p_0', 'E_star'), prepare_displacement_all, block_displacement_all, 7, 1, (1e-09,), False),
    },
}
