"""Programs of axicontact.loads.hertzian."""

from __future__ import annotations

from math import sqrt

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(-0.7327347664453868)
C1 = np.array(-32.15553480435792)
C2 = np.array(-332.23363563146734)
C3 = np.array(-1070.7082873491413)
C4 = np.array(-85.27694715374247)
C5 = np.array(5044.821368830373)
C6 = np.array(8082.413158212496)
C7 = np.array(3759.725330928701)
C8 = np.array(0.26666666666720995)
C9 = np.array(0.21387262524856868)
C10 = np.array(32.12935731379798)
C11 = np.array(746.8124983579742)
C12 = np.array(6202.125133759036)
C13 = np.array(23553.080984642995)
C14 = np.array(44404.005348491315)
C15 = np.array(40380.01430284195)
C16 = np.array(14099.684276696918)
C17 = np.array(1.0)
C18 = np.array(0.6666666666666666)
C19 = np.array(2.0)
C20 = np.array(3.141592653589793)


def displacement(r, a, p_0, E_star):
    if r.__class__ is a.__class__ is p_0.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (p_0 > 1e-30) and (p_0 < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if r > a:
                v11 = a / (r + sqrt((r - a) * (r + a)))
                v13 = v11 * v11
                value = p_0 / E_star * a * (a / r * (0.6666666666666666 + v13 * (((((((((-0.7327347664453868 * v13 + -32.15553480435792) * v13 + -332.23363563146734) * v13 + -1070.7082873491413) * v13 + -85.27694715374247) * v13 + 5044.821368830373) * v13 + 8082.413158212496) * v13 + 3759.725330928701) * v13 + 0.26666666666720995) / ((((((((0.21387262524856868 * v13 + 32.12935731379798) * v13 + 746.8124983579742) * v13 + 6202.125133759036) * v13 + 23553.080984642995) * v13 + 44404.005348491315) * v13 + 40380.01430284195) * v13 + 14099.684276696918) * v13 + 1.0))))
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return 3.141592653589793 * p_0 / (2.0 * E_star) * a * (1.0 - r * r / (2.0 * (a * a)))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_displacement_r(a, p_0, E_star):
    v4 = p_0 / E_star
    v5 = v4 * a
    v71 = (3.141592653589793) * p_0
    v73 = (2.0) * E_star
    v74 = v71 / v73
    v75 = v74 * a
    v77 = np.square(a)
    v78 = (2.0) * v77
    return (a, v5, v75, v78)


def block_displacement_r(out, r, a, v5, v75, v78, t0, t1, t2, m0):
    size = out.size
    np.greater(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some83 = np.count_nonzero(m0)
    if some83:
        np.subtract(r, a, out)
        np.add(r, a, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.add(r, t0, t0)
        np.divide(a, t0, t0)
        np.divide(a, r, out)
        np.multiply(t0, t0, t0)
        np.multiply(C0, t0, t1)
        np.add(t1, C1, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C2, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C3, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C4, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C5, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C6, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C7, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C8, t1)
        np.multiply(C9, t0, t2)
        np.add(t2, C10, t2)
        np.multiply(t2, t0, t2)
        np.add(t2, C11, t2)
        np.multiply(t2, t0, t2)
        np.add(t2, C12, t2)
        np.multiply(t2, t0, t2)
        np.add(t2, C13, t2)
        np.multiply(t2, t0, t2)
        np.add(t2, C14, t2)
        np.multiply(t2, t0, t2)
        np.add(t2, C15, t2)
        np.multiply(t2, t0, t2)
        np.add(t2, C16, t2)
        np.multiply(t2, t0, t2)
        np.add(t2, C17, t2)
        np.divide(t1, t2, t2)
        np.multiply(t0, t2, t2)
        np.add(C18, t2, t2)
        np.multiply(out, t2, t2)
        np.multiply(v5, t2, out)
    if some83 != size:
        other83 = t2 if some83 else out
        np.square(r, other83)
        np.divide(other83, v78, other83)
        np.subtract(C17, other83, other83)
        np.multiply(v75, other83, other83)
        if some83:
            np.copyto(out, other83, where=~m0)


def prepare_displacement_all():
    return ()


def block_displacement_all(out, r, a, p_0, E_star, t0, t1, t2, t3, m0):
    size = out.size
    np.greater(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some83 = np.count_nonzero(m0)
    if some83:
        np.divide(p_0, E_star, out)
        np.multiply(out, a, out)
        np.subtract(r, a, t0)
        np.add(r, a, t1)
        np.multiply(t0, t1, t1)
        np.sqrt(t1, t1)
        np.add(r, t1, t1)
        np.divide(a, t1, t1)
        np.divide(a, r, t0)
        np.multiply(t1, t1, t1)
        np.multiply(C0, t1, t2)
        np.add(t2, C1, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C2, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C3, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C4, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C5, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C6, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C7, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C8, t2)
        np.multiply(C9, t1, t3)
        np.add(t3, C10, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C11, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C12, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C13, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C14, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C15, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C16, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C17, t3)
        np.divide(t2, t3, t3)
        np.multiply(t1, t3, t3)
        np.add(C18, t3, t3)
        np.multiply(t0, t3, t3)
        np.multiply(out, t3, out)
    if some83 != size:
        other83 = t3 if some83 else out
        np.multiply(C20, p_0, other83)
        np.multiply(C19, E_star, t0)
        np.divide(other83, t0, t0)
        np.multiply(t0, a, t0)
        np.square(r, other83)
        np.square(a, t1)
        np.multiply(C19, t1, t1)
        np.divide(other83, t1, t1)
        np.subtract(C17, t1, t1)
        np.multiply(t0, t1, other83)
        if some83:
            np.copyto(out, other83, where=~m0)


BLOCKS = {
    ('_displacement', 1, 'r', 'a', 'p_0', 'E_star'): {
        ('r',): (('r',), prepare_displacement_r, block_displacement_r, 3, 1, (), False),
        ('r', 'a', 'p_0', 'E_star'): (('r', 'a', 'p_0', 'E_star'), prepare_displacement_all, block_displacement_all, 4, 1, (), False),
    },
}
