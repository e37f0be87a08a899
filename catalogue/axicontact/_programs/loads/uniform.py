"""Programs of axicontact.loads.uniform."""

from __future__ import annotations

from math import inf, sqrt

import numpy as np

from ..._runtime.arrays.blocks import Program, largest

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


def block_displacement_r(out, r, a, v5, w0, w1, w2, w3, w4, w5, m0, f0):
    size = out.size
    np.maximum(r, a, out=out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.less(out, C0, m0)
    some17 = np.count_nonzero(m0)
    if some17:
        np.minimum(r, a, out=w0)
        np.subtract(out, w0, w1)
        np.divide(w1, out, w1)
        np.add(out, w0, w0)
        np.divide(w0, out, w0)
        np.multiply(w1, w0, w0)
        np.sqrt(w0, w0)
    if some17 != size:
        np.copyto(w0, C1, where=~m0)
    np.divide(a, out, out)
    np.less_equal(r, a, m0)
    some22 = np.count_nonzero(m0)
    if some22:
        np.multiply(w0, w0, w1)
    if some22 != size:
        np.copyto(w1, C2, where=~m0)
    np.maximum(w0, f0, out=w0)
    np.add(C1, w0, w2)
    np.add(C1, w1, w3)
    np.add(w1, w0, w1)
    np.multiply(C3, w1, w1)
    np.sqrt(w0, w0)
    np.multiply(C3, w0, w0)
    np.multiply(w0, w2, w4)
    np.divide(w1, w2, w5)
    np.add(w3, w5, w5)
    np.multiply(w3, w0, w3)
    np.add(w1, w3, w3)
    np.multiply(C3, w3, w3)
    np.add(w0, w2, w2)
    np.sqrt(w4, w4)
    np.multiply(C3, w4, w4)
    np.multiply(w4, w2, w0)
    np.divide(w3, w2, w1)
    np.add(w5, w1, w1)
    np.multiply(w5, w4, w5)
    np.add(w3, w5, w5)
    np.multiply(C3, w5, w5)
    np.add(w4, w2, w2)
    np.sqrt(w0, w0)
    np.multiply(C3, w0, w0)
    np.multiply(w0, w2, w4)
    np.divide(w5, w2, w3)
    np.add(w1, w3, w3)
    np.multiply(w1, w0, w1)
    np.add(w5, w1, w1)
    np.multiply(C3, w1, w1)
    np.add(w0, w2, w2)
    np.sqrt(w4, w4)
    np.multiply(C3, w4, w4)
    np.multiply(w4, w2, w0)
    np.divide(w1, w2, w5)
    np.add(w3, w5, w5)
    np.multiply(w3, w4, w3)
    np.add(w1, w3, w3)
    np.multiply(C3, w3, w3)
    np.add(w4, w2, w2)
    np.sqrt(w0, w0)
    np.multiply(C3, w0, w0)
    np.multiply(w0, w2, w4)
    np.divide(w3, w2, w1)
    np.add(w5, w1, w1)
    np.multiply(w5, w0, w5)
    np.add(w3, w5, w5)
    np.multiply(C3, w5, w5)
    np.add(w0, w2, w2)
    np.sqrt(w4, w4)
    np.multiply(C3, w4, w4)
    np.multiply(w4, w2, w0)
    np.divide(w5, w2, w3)
    np.add(w1, w3, w3)
    np.multiply(w1, w4, w1)
    np.add(w5, w1, w1)
    np.multiply(C3, w1, w1)
    np.add(w4, w2, w2)
    np.sqrt(w0, w0)
    np.multiply(C3, w0, w0)
    np.divide(w1, w2, w4)
    np.add(w3, w4, w4)
    np.multiply(w3, w0, w3)
    np.add(w1, w3, w3)
    np.multiply(C3, w3, w3)
    np.add(w0, w2, w2)
    np.multiply(w4, w2, w4)
    np.add(w3, w4, w4)
    np.multiply(w2, w2, w2)
    np.divide(w4, w2, w2)
    np.multiply(out, w2, w2)
    np.multiply(v5, w2, out)


def prepare_displacement_all():
    return ()


def block_displacement_all(out, r, a, p_0, E_star, w0, w1, w2, w3, w4, w5, w6, m0, f0):
    size = out.size
    np.divide(p_0, E_star, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.multiply(out, a, out)
    np.maximum(r, a, out=w0)
    np.less(w0, C0, m0)
    some17 = np.count_nonzero(m0)
    if some17:
        np.minimum(r, a, out=w1)
        np.subtract(w0, w1, w2)
        np.divide(w2, w0, w2)
        np.add(w0, w1, w1)
        np.divide(w1, w0, w1)
        np.multiply(w2, w1, w1)
        np.sqrt(w1, w1)
    if some17 != size:
        np.copyto(w1, C1, where=~m0)
    np.divide(a, w0, w0)
    np.less_equal(r, a, m0)
    some22 = np.count_nonzero(m0)
    if some22:
        np.multiply(w1, w1, w2)
    if some22 != size:
        np.copyto(w2, C2, where=~m0)
    np.maximum(w1, f0, out=w1)
    np.add(C1, w1, w3)
    np.add(C1, w2, w4)
    np.add(w2, w1, w2)
    np.multiply(C3, w2, w2)
    np.sqrt(w1, w1)
    np.multiply(C3, w1, w1)
    np.multiply(w1, w3, w5)
    np.divide(w2, w3, w6)
    np.add(w4, w6, w6)
    np.multiply(w4, w1, w4)
    np.add(w2, w4, w4)
    np.multiply(C3, w4, w4)
    np.add(w1, w3, w3)
    np.sqrt(w5, w5)
    np.multiply(C3, w5, w5)
    np.multiply(w5, w3, w1)
    np.divide(w4, w3, w2)
    np.add(w6, w2, w2)
    np.multiply(w6, w5, w6)
    np.add(w4, w6, w6)
    np.multiply(C3, w6, w6)
    np.add(w5, w3, w3)
    np.sqrt(w1, w1)
    np.multiply(C3, w1, w1)
    np.multiply(w1, w3, w5)
    np.divide(w6, w3, w4)
    np.add(w2, w4, w4)
    np.multiply(w2, w1, w2)
    np.add(w6, w2, w2)
    np.multiply(C3, w2, w2)
    np.add(w1, w3, w3)
    np.sqrt(w5, w5)
    np.multiply(C3, w5, w5)
    np.multiply(w5, w3, w1)
    np.divide(w2, w3, w6)
    np.add(w4, w6, w6)
    np.multiply(w4, w5, w4)
    np.add(w2, w4, w4)
    np.multiply(C3, w4, w4)
    np.add(w5, w3, w3)
    np.sqrt(w1, w1)
    np.multiply(C3, w1, w1)
    np.multiply(w1, w3, w5)
    np.divide(w4, w3, w2)
    np.add(w6, w2, w2)
    np.multiply(w6, w1, w6)
    np.add(w4, w6, w6)
    np.multiply(C3, w6, w6)
    np.add(w1, w3, w3)
    np.sqrt(w5, w5)
    np.multiply(C3, w5, w5)
    np.multiply(w5, w3, w1)
    np.divide(w6, w3, w4)
    np.add(w2, w4, w4)
    np.multiply(w2, w5, w2)
    np.add(w6, w2, w2)
    np.multiply(C3, w2, w2)
    np.add(w5, w3, w3)
    np.sqrt(w1, w1)
    np.multiply(C3, w1, w1)
    np.divide(w2, w3, w5)
    np.add(w4, w5, w5)
    np.multiply(w4, w1, w4)
    np.add(w2, w4, w4)
    np.multiply(C3, w4, w4)
    np.add(w1, w3, w3)
    np.multiply(w5, w3, w5)
    np.add(w4, w5, w5)
    np.multiply(w3, w3, w3)
    np.divide(w5, w3, w3)
    np.multiply(w0, w3, w3)
    np.multiply(out, w3, out)


BLOCKS = {
    ('_displacement', 1, 'r', 'a', 'p_0', 'E_star'): {
        ('r',): Program(('r',), prepare_displacement_r, block_displacement_r, scratch=6, masks=1, filled=(1e-09,)),
        ('r', 'a', 'p_0', 'E_star'): Program(('r', 'a', 'p_0', 'E_star'), prepare_displacement_all, block_displacement_all, scratch=7, masks=1, filled=(1e-09,)),
    },
}
