"""Programs of axicontact.torsion.flat_punch."""

from __future__ import annotations

from math import atan, hypot, sqrt

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(0.5)
C1 = np.array(0.0)
C2 = np.array(1.0)
C3 = np.array(2.0)
C4 = np.array(3.141592653589793)
C5 = np.array(2.229767813968649e-06)
C6 = np.array(0.0021043873129700233)
C7 = np.array(0.04325113828415611)
C8 = np.array(0.2725778671008127)
C9 = np.array(0.7123414383945195)
C10 = np.array(0.8116412201960678)
C11 = np.array(0.3333333333333333)
C12 = np.array(0.002445452808893491)
C13 = np.array(0.06453295925870227)
C14 = np.array(0.5368820963772863)
C15 = np.array(1.9680296155712274)
C16 = np.array(3.5294070829658954)
C17 = np.array(3.034923660588189)
C18 = np.array(1.5707963267948966)
C19 = np.array(-1.2732395447351628)
C20 = np.array(5.333333333333333)


def displacement(r, z, a, beta):
    if r.__class__ is z.__class__ is a.__class__ is beta.__class__ is float and r > 1e-30 and (r < 1e+30) and (z > 1e-30) and (z < 1e+30) and (a > 1e-30) and (a < 1e+30) and (beta > 1e-30) and (beta < 1e+30):
        try:
            v4 = r - a
            v6 = r + a
            v11 = v4 * v6 + z * z
            v16 = sqrt(0.5 * (hypot(v4, z) * hypot(v6, z) + abs(v11)))
            if v11 > 0.0:
                v25 = v16
            else:
                v18 = v16 > 0.0
                v25 = z * a / (v16 if v18 else 1.0) if v18 else 0.0
            v27 = v25 > a
            if v27:
                v29 = a / (v25 if v27 else a)
                v30 = v29 * v29
                if v29 < 1.0:
                    v36 = v29 * v29
                    v79 = v29 * v36 * (((((((2.229767813968649e-06 * v36 + 0.0021043873129700233) * v36 + 0.04325113828415611) * v36 + 0.2725778671008127) * v36 + 0.7123414383945195) * v36 + 0.8116412201960678) * v36 + 0.3333333333333333) / ((((((0.002445452808893491 * v36 + 0.06453295925870227) * v36 + 0.5368820963772863) * v36 + 1.9680296155712274) * v36 + 3.5294070829658954) * v36 + 3.034923660588189) * v36 + 1.0))
                else:
                    v79 = v29 - atan(v29)
                v94 = v30 * v29 / (1.0 + v30) - v79
            else:
                v82 = (0.0 if v27 else v25) / a
                v94 = 1.5707963267948966 - atan(v82) - v82 / (1.0 + v82 * v82)
            value = beta * (2.0 * r / 3.141592653589793 * v94)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_displacement_r(z, a, beta):
    v10 = z * z
    v19 = z * a
    return (z, a, beta, v10, v19)


def block_displacement_r(out, r, z, a, beta, v10, v19, t0, t1, t2, t3, t4, t5, t6, m0, m1, f0):
    size = out.size
    np.subtract(r, a, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.hypot(out, z, t0)
    np.add(r, a, t1)
    np.hypot(t1, z, t2)
    np.multiply(t0, t2, t2)
    np.multiply(out, t1, t1)
    np.add(t1, v10, t1)
    np.absolute(t1, out)
    np.add(t2, out, out)
    np.multiply(C0, out, out)
    np.sqrt(out, out)
    np.greater(t1, C1, m0)
    some25 = np.count_nonzero(m0)
    if some25:
        np.copyto(t1, out)
    if some25 != size:
        other25 = t2 if some25 else t1
        np.greater(out, C1, m1)
        some23 = np.count_nonzero(m1)
        if some23:
            some21 = np.count_nonzero(m1)
            if some21:
                np.copyto(other25, out)
            if some21 != size:
                np.copyto(other25, C2, where=~m1)
            np.divide(v19, other25, other25)
        if some23 != size:
            np.copyto(other25, C1, where=~m1)
        if some25:
            np.copyto(t1, other25, where=~m0)
    np.greater(t1, a, m0)
    np.multiply(C3, r, out)
    np.divide(out, C4, out)
    some93 = np.count_nonzero(m0)
    if some93:
        some27 = np.count_nonzero(m0)
        if some27:
            np.copyto(t2, t1)
        if some27 != size:
            np.copyto(t2, a, where=~m0)
        np.divide(a, t2, t2)
        np.multiply(t2, t2, t0)
        np.multiply(t0, t2, t3)
        np.add(C2, t0, t0)
        np.divide(t3, t0, t0)
        np.less(t2, C2, m1)
        some78 = np.count_nonzero(m1)
        if some78:
            np.minimum(t2, f0, out=t3)
            np.multiply(t3, t3, t4)
            np.multiply(t3, t4, t3)
            np.multiply(C5, t4, t5)
            np.add(t5, C6, t5)
            np.multiply(t5, t4, t5)
            np.add(t5, C7, t5)
            np.multiply(t5, t4, t5)
            np.add(t5, C8, t5)
            np.multiply(t5, t4, t5)
            np.add(t5, C9, t5)
            np.multiply(t5, t4, t5)
            np.add(t5, C10, t5)
            np.multiply(t5, t4, t5)
            np.add(t5, C11, t5)
            np.multiply(C12, t4, t6)
            np.add(t6, C13, t6)
            np.multiply(t6, t4, t6)
            np.add(t6, C14, t6)
            np.multiply(t6, t4, t6)
            np.add(t6, C15, t6)
            np.multiply(t6, t4, t6)
            np.add(t6, C16, t6)
            np.multiply(t6, t4, t6)
            np.add(t6, C17, t6)
            np.multiply(t6, t4, t4)
            np.add(t4, C2, t4)
            np.divide(t5, t4, t4)
            np.multiply(t3, t4, t3)
        if some78 != size:
            other78 = t4 if some78 else t3
            np.arctan(t2, other78)
            np.subtract(t2, other78, other78)
            if some78:
                np.copyto(t3, other78, where=~m1)
        np.subtract(t0, t3, t2)
    if some93 != size:
        other93 = t3 if some93 else t2
        some80 = np.count_nonzero(m0)
        if some80:
            np.copyto(other93, C1)
        if some80 != size:
            np.copyto(other93, t1, where=~m0)
        np.divide(other93, a, other93)
        np.arctan(other93, t0)
        np.subtract(C18, t0, t0)
        np.multiply(other93, other93, t4)
        np.add(C2, t4, t4)
        np.divide(other93, t4, t4)
        np.subtract(t0, t4, other93)
        if some93:
            np.copyto(t2, other93, where=~m0)
    np.multiply(out, t2, t2)
    np.multiply(beta, t2, out)


def prepare_displacement_r_z(a, beta):
    return (a, beta)


def block_displacement_r_z(out, r, z, a, beta, t0, t1, t2, t3, t4, t5, t6, m0, m1, f0):
    size = out.size
    np.subtract(r, a, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_z = largest(z)
    if largest_z == np.inf:
        raise FloatingPointError
    np.hypot(out, z, t0)
    np.add(r, a, t1)
    np.hypot(t1, z, t2)
    np.multiply(t0, t2, t2)
    np.multiply(out, t1, t1)
    np.multiply(z, z, out)
    np.add(t1, out, out)
    np.absolute(out, t1)
    np.add(t2, t1, t1)
    np.multiply(C0, t1, t1)
    np.sqrt(t1, t1)
    np.greater(out, C1, m0)
    some25 = np.count_nonzero(m0)
    if some25:
        np.copyto(out, t1)
    if some25 != size:
        other25 = t2 if some25 else out
        np.greater(t1, C1, m1)
        some23 = np.count_nonzero(m1)
        if some23:
            np.multiply(z, a, other25)
            some21 = np.count_nonzero(m1)
            if some21:
                np.copyto(t0, t1)
            if some21 != size:
                np.copyto(t0, C2, where=~m1)
            np.divide(other25, t0, other25)
        if some23 != size:
            np.copyto(other25, C1, where=~m1)
        if some25:
            np.copyto(out, other25, where=~m0)
    np.greater(out, a, m0)
    np.multiply(C3, r, t1)
    np.divide(t1, C4, t1)
    some93 = np.count_nonzero(m0)
    if some93:
        some27 = np.count_nonzero(m0)
        if some27:
            np.copyto(t2, out)
        if some27 != size:
            np.copyto(t2, a, where=~m0)
        np.divide(a, t2, t2)
        np.multiply(t2, t2, t0)
        np.multiply(t0, t2, t3)
        np.add(C2, t0, t0)
        np.divide(t3, t0, t0)
        np.less(t2, C2, m1)
        some78 = np.count_nonzero(m1)
        if some78:
            np.minimum(t2, f0, out=t3)
            np.multiply(t3, t3, t4)
            np.multiply(t3, t4, t3)
            np.multiply(C5, t4, t5)
            np.add(t5, C6, t5)
            np.multiply(t5, t4, t5)
            np.add(t5, C7, t5)
            np.multiply(t5, t4, t5)
            np.add(t5, C8, t5)
            np.multiply(t5, t4, t5)
            np.add(t5, C9, t5)
            np.multiply(t5, t4, t5)
            np.add(t5, C10, t5)
            np.multiply(t5, t4, t5)
            np.add(t5, C11, t5)
            np.multiply(C12, t4, t6)
            np.add(t6, C13, t6)
            np.multiply(t6, t4, t6)
            np.add(t6, C14, t6)
            np.multiply(t6, t4, t6)
            np.add(t6, C15, t6)
            np.multiply(t6, t4, t6)
            np.add(t6, C16, t6)
            np.multiply(t6, t4, t6)
            np.add(t6, C17, t6)
            np.multiply(t6, t4, t4)
            np.add(t4, C2, t4)
            np.divide(t5, t4, t4)
            np.multiply(t3, t4, t3)
        if some78 != size:
            other78 = t4 if some78 else t3
            np.arctan(t2, other78)
            np.subtract(t2, other78, other78)
            if some78:
                np.copyto(t3, other78, where=~m1)
        np.subtract(t0, t3, t2)
    if some93 != size:
        other93 = t3 if some93 else t2
        some80 = np.count_nonzero(m0)
        if some80:
            np.copyto(other93, C1)
        if some80 != size:
            np.copyto(other93, out, where=~m0)
        np.divide(other93, a, other93)
        np.arctan(other93, t0)
        np.subtract(C18, t0, t0)
        np.multiply(other93, other93, t4)
        np.add(C2, t4, t4)
        np.divide(other93, t4, t4)
        np.subtract(t0, t4, other93)
        if some93:
            np.copyto(t2, other93, where=~m0)
    np.multiply(t1, t2, t2)
    np.multiply(beta, t2, out)


def prepare_displacement_all():
    return ()


def block_displacement_all(out, r, z, a, beta, t0, t1, t2, t3, t4, t5, t6, m0, m1, f0):
    size = out.size
    np.subtract(r, a, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_z = largest(z)
    if largest_z == np.inf:
        raise FloatingPointError
    np.hypot(out, z, t0)
    np.add(r, a, t1)
    np.hypot(t1, z, t2)
    np.multiply(t0, t2, t2)
    np.multiply(out, t1, t1)
    np.multiply(z, z, out)
    np.add(t1, out, out)
    np.absolute(out, t1)
    np.add(t2, t1, t1)
    np.multiply(C0, t1, t1)
    np.sqrt(t1, t1)
    np.greater(out, C1, m0)
    some25 = np.count_nonzero(m0)
    if some25:
        np.copyto(out, t1)
    if some25 != size:
        other25 = t2 if some25 else out
        np.greater(t1, C1, m1)
        some23 = np.count_nonzero(m1)
        if some23:
            np.multiply(z, a, other25)
            some21 = np.count_nonzero(m1)
            if some21:
                np.copyto(t0, t1)
            if some21 != size:
                np.copyto(t0, C2, where=~m1)
            np.divide(other25, t0, other25)
        if some23 != size:
            np.copyto(other25, C1, where=~m1)
        if some25:
            np.copyto(out, other25, where=~m0)
    np.greater(out, a, m0)
    np.multiply(C3, r, t1)
    np.divide(t1, C4, t1)
    some93 = np.count_nonzero(m0)
    if some93:
        some27 = np.count_nonzero(m0)
        if some27:
            np.copyto(t2, out)
        if some27 != size:
            np.copyto(t2, a, where=~m0)
        np.divide(a, t2, t2)
        np.multiply(t2, t2, t0)
        np.multiply(t0, t2, t3)
        np.add(C2, t0, t0)
        np.divide(t3, t0, t0)
        np.less(t2, C2, m1)
        some78 = np.count_nonzero(m1)
        if some78:
            np.minimum(t2, f0, out=t3)
            np.multiply(t3, t3, t4)
            np.multiply(t3, t4, t3)
            np.multiply(C5, t4, t5)
            np.add(t5, C6, t5)
            np.multiply(t5, t4, t5)
            np.add(t5, C7, t5)
            np.multiply(t5, t4, t5)
            np.add(t5, C8, t5)
            np.multiply(t5, t4, t5)
            np.add(t5, C9, t5)
            np.multiply(t5, t4, t5)
            np.add(t5, C10, t5)
            np.multiply(t5, t4, t5)
            np.add(t5, C11, t5)
            np.multiply(C12, t4, t6)
            np.add(t6, C13, t6)
            np.multiply(t6, t4, t6)
            np.add(t6, C14, t6)
            np.multiply(t6, t4, t6)
            np.add(t6, C15, t6)
            np.multiply(t6, t4, t6)
            np.add(t6, C16, t6)
            np.multiply(t6, t4, t6)
            np.add(t6, C17, t6)
            np.multiply(t6, t4, t4)
            np.add(t4, C2, t4)
            np.divide(t5, t4, t4)
            np.multiply(t3, t4, t3)
        if some78 != size:
            other78 = t4 if some78 else t3
            np.arctan(t2, other78)
            np.subtract(t2, other78, other78)
            if some78:
                np.copyto(t3, other78, where=~m1)
        np.subtract(t0, t3, t2)
    if some93 != size:
        other93 = t3 if some93 else t2
        some80 = np.count_nonzero(m0)
        if some80:
            np.copyto(other93, C1)
        if some80 != size:
            np.copyto(other93, out, where=~m0)
        np.divide(other93, a, other93)
        np.arctan(other93, t0)
        np.subtract(C18, t0, t0)
        np.multiply(other93, other93, t4)
        np.add(C2, t4, t4)
        np.divide(other93, t4, t4)
        np.subtract(t0, t4, other93)
        if some93:
            np.copyto(t2, other93, where=~m0)
    np.multiply(t1, t2, t2)
    np.multiply(beta, t2, out)


def stress_rt(r, z, a, G, beta):
    if r.__class__ is z.__class__ is a.__class__ is G.__class__ is beta.__class__ is float and r > 1e-30 and (r < 1e+30) and (z > 1e-30) and (z < 1e+30) and (a > 1e-30) and (a < 1e+30) and (G > 1e-30) and (G < 1e+30) and (beta > 1e-30) and (beta < 1e+30):
        try:
            v6 = r - a
            v8 = r + a
            v10 = hypot(v6, z) * hypot(v8, z)
            v13 = v6 * v8 + z * z
            v18 = sqrt(0.5 * (v10 + abs(v13)))
            if v13 > 0.0:
                v27 = v18
            else:
                v20 = v18 > 0.0
                v27 = z * a / (v18 if v20 else 1.0) if v20 else 0.0
            v37 = r * a / (a * a + v27 * v27)
            value = G * beta * (-1.2732395447351628 * (v27 * a / v10) * (v37 * v37))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_stress_rt_r(z, a, G, beta):
    v5 = G * beta
    v12 = z * z
    v21 = z * a
    v33 = a * a
    return (z, a, v5, v12, v21, v33)


def block_stress_rt_r(out, r, z, a, v5, v12, v21, v33, t0, t1, t2, m0, m1):
    size = out.size
    np.subtract(r, a, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.hypot(out, z, t0)
    np.add(r, a, t1)
    np.hypot(t1, z, t2)
    np.multiply(t0, t2, t2)
    np.multiply(out, t1, t1)
    np.add(t1, v12, t1)
    np.absolute(t1, out)
    np.add(t2, out, out)
    np.multiply(C0, out, out)
    np.sqrt(out, out)
    np.greater(t1, C1, m0)
    some27 = np.count_nonzero(m0)
    if some27:
        np.copyto(t1, out)
    if some27 != size:
        other27 = t0 if some27 else t1
        np.greater(out, C1, m1)
        some25 = np.count_nonzero(m1)
        if some25:
            some23 = np.count_nonzero(m1)
            if some23:
                np.copyto(other27, out)
            if some23 != size:
                np.copyto(other27, C2, where=~m1)
            np.divide(v21, other27, other27)
        if some25 != size:
            np.copyto(other27, C1, where=~m1)
        if some27:
            np.copyto(t1, other27, where=~m0)
    np.multiply(t1, a, out)
    np.divide(out, t2, t2)
    np.multiply(C19, t2, t2)
    np.multiply(r, a, out)
    np.multiply(t1, t1, t1)
    np.add(v33, t1, t1)
    np.divide(out, t1, t1)
    np.square(t1, t1)
    np.multiply(t2, t1, t1)
    np.multiply(v5, t1, out)


def prepare_stress_rt_r_z(a, G, beta):
    v5 = G * beta
    v33 = a * a
    return (a, v5, v33)


def block_stress_rt_r_z(out, r, z, a, v5, v33, t0, t1, t2, t3, m0, m1):
    size = out.size
    np.subtract(r, a, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_z = largest(z)
    if largest_z == np.inf:
        raise FloatingPointError
    np.hypot(out, z, t0)
    np.add(r, a, t1)
    np.hypot(t1, z, t2)
    np.multiply(t0, t2, t2)
    np.multiply(out, t1, t1)
    np.multiply(z, z, out)
    np.add(t1, out, out)
    np.absolute(out, t1)
    np.add(t2, t1, t1)
    np.multiply(C0, t1, t1)
    np.sqrt(t1, t1)
    np.greater(out, C1, m0)
    some27 = np.count_nonzero(m0)
    if some27:
        np.copyto(out, t1)
    if some27 != size:
        other27 = t0 if some27 else out
        np.greater(t1, C1, m1)
        some25 = np.count_nonzero(m1)
        if some25:
            np.multiply(z, a, other27)
            some23 = np.count_nonzero(m1)
            if some23:
                np.copyto(t3, t1)
            if some23 != size:
                np.copyto(t3, C2, where=~m1)
            np.divide(other27, t3, other27)
        if some25 != size:
            np.copyto(other27, C1, where=~m1)
        if some27:
            np.copyto(out, other27, where=~m0)
    np.multiply(out, a, t1)
    np.divide(t1, t2, t2)
    np.multiply(C19, t2, t2)
    np.multiply(r, a, t1)
    np.multiply(out, out, out)
    np.add(v33, out, out)
    np.divide(t1, out, out)
    np.square(out, out)
    np.multiply(t2, out, out)
    np.multiply(v5, out, out)


def prepare_stress_rt_all():
    return ()


def block_stress_rt_all(out, r, z, a, G, beta, t0, t1, t2, t3, t4, m0, m1):
    size = out.size
    np.multiply(G, beta, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_z = largest(z)
    if largest_z == np.inf:
        raise FloatingPointError
    np.subtract(r, a, t0)
    np.hypot(t0, z, t1)
    np.add(r, a, t2)
    np.hypot(t2, z, t3)
    np.multiply(t1, t3, t3)
    np.multiply(t0, t2, t2)
    np.multiply(z, z, t0)
    np.add(t2, t0, t0)
    np.absolute(t0, t2)
    np.add(t3, t2, t2)
    np.multiply(C0, t2, t2)
    np.sqrt(t2, t2)
    np.greater(t0, C1, m0)
    some27 = np.count_nonzero(m0)
    if some27:
        np.copyto(t0, t2)
    if some27 != size:
        other27 = t1 if some27 else t0
        np.greater(t2, C1, m1)
        some25 = np.count_nonzero(m1)
        if some25:
            np.multiply(z, a, other27)
            some23 = np.count_nonzero(m1)
            if some23:
                np.copyto(t4, t2)
            if some23 != size:
                np.copyto(t4, C2, where=~m1)
            np.divide(other27, t4, other27)
        if some25 != size:
            np.copyto(other27, C1, where=~m1)
        if some27:
            np.copyto(t0, other27, where=~m0)
    np.multiply(t0, a, t2)
    np.divide(t2, t3, t3)
    np.multiply(C19, t3, t3)
    np.multiply(r, a, t2)
    np.multiply(a, a, t1)
    np.multiply(t0, t0, t0)
    np.add(t1, t0, t0)
    np.divide(t2, t0, t0)
    np.square(t0, t0)
    np.multiply(t3, t0, t0)
    np.multiply(out, t0, out)


def stress_tz(r, z, a, G, beta):
    if r.__class__ is z.__class__ is a.__class__ is G.__class__ is beta.__class__ is float and r > 1e-30 and (r < 1e+30) and (z > 1e-30) and (z < 1e+30) and (a > 1e-30) and (a < 1e+30) and (G > 1e-30) and (G < 1e+30) and (beta > 1e-30) and (beta < 1e+30):
        try:
            v6 = r - a
            v8 = r + a
            v10 = hypot(v6, z) * hypot(v8, z)
            v13 = v6 * v8 + z * z
            v18 = sqrt(0.5 * (v10 + abs(v13)))
            v20 = v18 > 0.0
            v25 = z * a / (v18 if v20 else 1.0) if v20 else 0.0
            v26 = v13 > 0.0
            v27 = v18 if v26 else v25
            value = G * beta * (-1.2732395447351628 * (r * a / v10) * ((v25 if v26 else v18) * a / (a * a + v27 * v27)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_stress_tz_r(z, a, G, beta):
    v5 = G * beta
    v12 = z * z
    v21 = z * a
    v34 = a * a
    return (z, a, v5, v12, v21, v34)


def block_stress_tz_r(out, r, z, a, v5, v12, v21, v34, t0, t1, t2, t3, m0):
    size = out.size
    np.subtract(r, a, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.hypot(out, z, t0)
    np.add(r, a, t1)
    np.hypot(t1, z, t2)
    np.multiply(t0, t2, t2)
    np.multiply(out, t1, t1)
    np.add(t1, v12, t1)
    np.absolute(t1, out)
    np.add(t2, out, out)
    np.multiply(C0, out, out)
    np.sqrt(out, out)
    np.greater(out, C1, m0)
    some25 = np.count_nonzero(m0)
    if some25:
        some23 = np.count_nonzero(m0)
        if some23:
            np.copyto(t0, out)
        if some23 != size:
            np.copyto(t0, C2, where=~m0)
        np.divide(v21, t0, t0)
    if some25 != size:
        np.copyto(t0, C1, where=~m0)
    np.greater(t1, C1, m0)
    some27 = np.count_nonzero(m0)
    if some27:
        np.copyto(t1, out)
    if some27 != size:
        np.copyto(t1, t0, where=~m0)
    some28 = np.count_nonzero(m0)
    if some28:
        np.copyto(t3, t0)
    if some28 != size:
        np.copyto(t3, out, where=~m0)
    np.multiply(r, a, out)
    np.divide(out, t2, t2)
    np.multiply(C19, t2, t2)
    np.multiply(t3, a, t3)
    np.multiply(t1, t1, t1)
    np.add(v34, t1, t1)
    np.divide(t3, t1, t1)
    np.multiply(t2, t1, t1)
    np.multiply(v5, t1, out)


def prepare_stress_tz_r_z(a, G, beta):
    v5 = G * beta
    v34 = a * a
    return (a, v5, v34)


def block_stress_tz_r_z(out, r, z, a, v5, v34, t0, t1, t2, t3, m0):
    size = out.size
    np.subtract(r, a, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_z = largest(z)
    if largest_z == np.inf:
        raise FloatingPointError
    np.hypot(out, z, t0)
    np.add(r, a, t1)
    np.hypot(t1, z, t2)
    np.multiply(t0, t2, t2)
    np.multiply(out, t1, t1)
    np.multiply(z, z, out)
    np.add(t1, out, out)
    np.absolute(out, t1)
    np.add(t2, t1, t1)
    np.multiply(C0, t1, t1)
    np.sqrt(t1, t1)
    np.greater(t1, C1, m0)
    some25 = np.count_nonzero(m0)
    if some25:
        np.multiply(z, a, t0)
        some23 = np.count_nonzero(m0)
        if some23:
            np.copyto(t3, t1)
        if some23 != size:
            np.copyto(t3, C2, where=~m0)
        np.divide(t0, t3, t0)
    if some25 != size:
        np.copyto(t0, C1, where=~m0)
    np.greater(out, C1, m0)
    some27 = np.count_nonzero(m0)
    if some27:
        np.copyto(out, t1)
    if some27 != size:
        np.copyto(out, t0, where=~m0)
    some28 = np.count_nonzero(m0)
    if some28:
        np.copyto(t3, t0)
    if some28 != size:
        np.copyto(t3, t1, where=~m0)
    np.multiply(r, a, t1)
    np.divide(t1, t2, t2)
    np.multiply(C19, t2, t2)
    np.multiply(t3, a, t3)
    np.multiply(out, out, out)
    np.add(v34, out, out)
    np.divide(t3, out, out)
    np.multiply(t2, out, out)
    np.multiply(v5, out, out)


def prepare_stress_tz_all():
    return ()


def block_stress_tz_all(out, r, z, a, G, beta, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.multiply(G, beta, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_z = largest(z)
    if largest_z == np.inf:
        raise FloatingPointError
    np.subtract(r, a, t0)
    np.hypot(t0, z, t1)
    np.add(r, a, t2)
    np.hypot(t2, z, t3)
    np.multiply(t1, t3, t3)
    np.multiply(t0, t2, t2)
    np.multiply(z, z, t0)
    np.add(t2, t0, t0)
    np.absolute(t0, t2)
    np.add(t3, t2, t2)
    np.multiply(C0, t2, t2)
    np.sqrt(t2, t2)
    np.greater(t2, C1, m0)
    some25 = np.count_nonzero(m0)
    if some25:
        np.multiply(z, a, t1)
        some23 = np.count_nonzero(m0)
        if some23:
            np.copyto(t4, t2)
        if some23 != size:
            np.copyto(t4, C2, where=~m0)
        np.divide(t1, t4, t1)
    if some25 != size:
        np.copyto(t1, C1, where=~m0)
    np.greater(t0, C1, m0)
    some27 = np.count_nonzero(m0)
    if some27:
        np.copyto(t0, t2)
    if some27 != size:
        np.copyto(t0, t1, where=~m0)
    some28 = np.count_nonzero(m0)
    if some28:
        np.copyto(t4, t1)
    if some28 != size:
        np.copyto(t4, t2, where=~m0)
    np.multiply(r, a, t2)
    np.divide(t2, t3, t3)
    np.multiply(C19, t3, t3)
    np.multiply(t4, a, t4)
    np.multiply(a, a, t2)
    np.multiply(t0, t0, t0)
    np.add(t2, t0, t0)
    np.divide(t4, t0, t0)
    np.multiply(t3, t0, t0)
    np.multiply(out, t0, out)


def torque(beta, a, G):
    if beta.__class__ is a.__class__ is G.__class__ is float and beta > 1e-30 and (beta < 1e+30) and (a > 1e-30) and (a < 1e+30) and (G > 1e-30) and (G < 1e+30):
        try:
            return 5.333333333333333 * G * (a * (a * a)) * beta
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_torque_beta(a, G):
    v4 = (5.333333333333333) * G
    v6 = np.square(a)
    v7 = a * v6
    v8 = v4 * v7
    return (v8,)


def block_torque_beta(out, beta, v8):
    np.multiply(v8, beta, out)
    largest_beta = largest(beta)
    if largest_beta == np.inf:
        raise FloatingPointError


def prepare_torque_all():
    return ()


def block_torque_all(out, beta, a, G, t0):
    np.multiply(C20, G, out)
    largest_beta = largest(beta)
    if largest_beta == np.inf:
        raise FloatingPointError
    np.square(a, t0)
    np.multiply(a, t0, t0)
    np.multiply(out, t0, t0)
    np.multiply(t0, beta, out)


BLOCKS = {
    ('_displacement', 2, 'r', 'z', 'a', 'beta'): {
        ('r',): (('r',), prepare_displacement_r, block_displacement_r, 7, 2, (1.0,), False),
        ('r', 'z'): (('r', 'z'), prepare_displacement_r_z, block_displacement_r_z, 7, 2, (1.0,), False),
        ('r', 'z', 'a', 'beta'): (('r', 'z', 'a', 'beta'), prepare_displacement_all, block_displacement_all, 7, 2, (1.0,), False),
    },
    ('_stress_rt', 2, 'r', 'z', 'a', 'G', 'beta'): {
        ('r',): (('r',), prepare_stress_rt_r, block_stress_rt_r, 3, 2, (), False),
        ('r', 'z'): (('r', 'z'), prepare_stress_rt_r_z, block_stress_rt_r_z, 4, 2, (), False),
        ('r', 'z', 'a', 'G', 'beta'): (('r', 'z', 'a', 'G', 'beta'), prepare_stress_rt_all, block_stress_rt_all, 5, 2, (), False),
    },
    ('_stress_tz', 2, 'r', 'z', 'a', 'G', 'beta'): {
        ('r',): (('r',), prepare_stress_tz_r, block_stress_tz_r, 4, 1, (), False),
        ('r', 'z'): (('r', 'z'), prepare_stress_tz_r_z, block_stress_tz_r_z, 4, 1, (), False),
        ('r', 'z', 'a', 'G', 'beta'): (('r', 'z', 'a', 'G', 'beta'), prepare_stress_tz_all, block_stress_tz_all, 5, 1, (), False),
    },
    ('_torque', 1, 'beta', 'a', 'G'): {
        ('beta',): (('beta',), prepare_torque_beta, block_torque_beta, 0, 0, (), False),
        ('beta', 'a', 'G'): (('beta', 'a', 'G'), prepare_torque_all, block_torque_all, 1, 0, (), False),
    },
}
