"""Programs of axicontact.tangential.hyperboloid."""

from __future__ import annotations

from math import asinh, atan, atan2, cosh, exp, expm1, fsum, inf, log1p, pow, sinh, sqrt, tan

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.tangential import hyperboloid as bodies

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def full_slip_displacement(a, theta, b, E_star, G_star, mu):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            return mu * (E_star / G_star) * (tan(theta) * a * atan(a / b))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_full_slip_displacement_a(theta, b, E_star, G_star, mu):
    v6 = E_star / G_star
    v7 = mu * v6
    v10 = np.tan(theta)
    return (b, v7, v10)


def block_full_slip_displacement_a(out, a, b, v7, v10, t0):
    np.divide(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.arctan(out, out)
    np.multiply(v10, a, t0)
    np.multiply(t0, out, out)
    np.multiply(v7, out, out)


def prepare_full_slip_displacement_all():
    return ()


def block_full_slip_displacement_all(out, a, theta, b, E_star, G_star, mu, t0, t1):
    np.divide(E_star, G_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(mu, out, out)
    np.divide(a, b, t0)
    np.arctan(t0, t0)
    np.tan(theta, t1)
    np.multiply(t1, a, t1)
    np.multiply(t1, t0, t0)
    np.multiply(out, t0, out)


def stick_radius(F_x, a, theta, b, E_star, mu):
    if F_x.__class__ is a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is mu.__class__ is float and F_x > 1e-30 and (F_x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = bodies._stick_radius(F_x, a, theta, b, E_star, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F_x, a, theta, b, E_star, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_displacement(a, c, theta, b, E_star, G_star, mu):
    if a.__class__ is c.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v9 = tan(theta)
            v11 = v9 * a * atan(a / b)
            v15 = v9 * c * atan(c / b)
            v18 = v15 >= 0.25 * v11
            if v18:
                v31 = a > c
                v41 = v18 and v31
                if v41:
                    v20 = c - 0.0
                    v24 = sqrt((v20 if v20 > 0.0 or v20 != v20 else 0.0) * (c + 0.0))
                    if v41:
                        v25 = a - c
                        if v31:
                            v26 = a - 0.0
                            v36 = v25 * (a + c) / (sqrt((v26 if v26 > 0.0 or v26 != v26 else 0.0) * (a + 0.0)) + v24)
                        else:
                            v36 = 0.0
                        v42 = log1p((v25 + v36) / (c + v24))
                    else:
                        v42 = 0.0
                    v53 = b * v9
                    v57 = b * b
                    v63 = []
                    for node, weight in RULE_0(v42 / 1.0):
                        v44 = node * v42
                        v49 = c * cosh(v44) + v24 * sinh(v44)
                        v62 = (v9 * atan(v49 / b) + v53 * v49 / (v49 * v49 + v57)) * pow(v49, 1.0)
                        v63.append(weight * v62)
                    v63 = fsum(v63) * v42
                    v64 = v63
                else:
                    v64 = 0.0
                v68 = v64
            else:
                v68 = v11 - v15
            value = mu * (E_star / G_star) * v68
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, theta, b, E_star, G_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_force(a, c, theta, b, E_star, mu):
    if a.__class__ is c.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v7 = tan(theta)
            v8 = E_star * v7
            v12 = b * b
            v13 = a / b
            if v13 < 1.0:
                v17 = v13 * v13
                v60 = v13 * v17 * (((((((2.229767813968649e-06 * v17 + 0.0021043873129700233) * v17 + 0.04325113828415611) * v17 + 0.2725778671008127) * v17 + 0.7123414383945195) * v17 + 0.8116412201960678) * v17 + 0.3333333333333333) / ((((((0.002445452808893491 * v17 + 0.06453295925870227) * v17 + 0.5368820963772863) * v17 + 1.9680296155712274) * v17 + 3.5294070829658954) * v17 + 3.034923660588189) * v17 + 1.0))
            else:
                v60 = v13 - atan(v13)
            v63 = v8 * (a * a * atan2(a, b) + v12 * v60)
            v67 = c / b
            if v67 < 1.0:
                v70 = v67 * v67
                v100 = v67 * v70 * (((((((2.229767813968649e-06 * v70 + 0.0021043873129700233) * v70 + 0.04325113828415611) * v70 + 0.2725778671008127) * v70 + 0.7123414383945195) * v70 + 0.8116412201960678) * v70 + 0.3333333333333333) / ((((((0.002445452808893491 * v70 + 0.06453295925870227) * v70 + 0.5368820963772863) * v70 + 1.9680296155712274) * v70 + 3.5294070829658954) * v70 + 3.034923660588189) * v70 + 1.0))
            else:
                v100 = v67 - atan(v67)
            v103 = v8 * (c * c * atan2(c, b) + v12 * v100)
            v106 = v103 >= 0.25 * v63
            if v106:
                v120 = a > c
                v130 = v106 and v120
                if v130:
                    v109 = c - 0.0
                    v113 = sqrt((v109 if v109 > 0.0 or v109 != v109 else 0.0) * (c + 0.0))
                    if v130:
                        v114 = a - c
                        if v120:
                            v115 = a - 0.0
                            v125 = v114 * (a + c) / (sqrt((v115 if v115 > 0.0 or v115 != v115 else 0.0) * (a + 0.0)) + v113)
                        else:
                            v125 = 0.0
                        v131 = log1p((v114 + v125) / (c + v113))
                    else:
                        v131 = 0.0
                    v141 = b * v7
                    v148 = []
                    for node, weight in RULE_0(v131 / 1.0):
                        v132 = node * v131
                        v137 = c * cosh(v132) + v113 * sinh(v132)
                        v143 = v137 * v137
                        v147 = (v7 * atan(v137 / b) + v141 * v137 / (v143 + v12)) * v143
                        v148.append(weight * v147)
                    v148 = fsum(v148) * v131
                    v149 = v148
                else:
                    v149 = 0.0
                v152 = 2.0 * E_star * v149
            else:
                v152 = v63 - v103
            value = mu * v152
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, theta, b, E_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def traction(r, a, c, theta, b, E_star, mu):
    if r.__class__ is a.__class__ is c.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is mu.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v7 = r * r
            v10 = sqrt(v7 + b * b)
            v11 = a - r
            v16 = sqrt((v11 if v11 > 0.0 or v11 != v11 else 0.0) * (a + r))
            v42 = tan(theta)
            v44 = b * v42
            v48 = b * b
            v53 = v10 * v10
            v61 = E_star / 3.141592653589793
            if r < a:
                v18 = asinh(v16 / v10)
                v23 = 0.0 - expm1(-2.0 * v18)
                v26 = v23 if v23 > 0.0 else inf
                v57 = []
                for node, weight in RULE_0(v18 / 1.0):
                    v27 = node * v18
                    v36 = v16 * (exp(-v27) * (0.0 - expm1(-2.0 * (v18 - v27))) / v26)
                    v37 = v36 * v36
                    v39 = sqrt(v7 + v37)
                    v56 = (v42 * atan(v39 / b) + v44 * v39 / (v39 * v39 + v48)) / v39 * sqrt(v53 + v37)
                    v57.append(weight * v56)
                v57 = fsum(v57) * v18
                v63 = v61 * v57
            else:
                v63 = 0.0
            v64 = c - r
            v68 = sqrt((v64 if v64 > 0.0 or v64 != v64 else 0.0) * (c + r))
            v102 = r < c
            if v102:
                v70 = asinh(v68 / v10)
                v73 = 0.0 - expm1(-2.0 * v70)
                v75 = v73 if v73 > 0.0 else inf
                v101 = []
                for node, weight in RULE_0(v70 / 1.0):
                    v76 = node * v70
                    v85 = v68 * (exp(-v76) * (0.0 - expm1(-2.0 * (v70 - v76))) / v75)
                    v86 = v85 * v85
                    v88 = sqrt(v7 + v86)
                    v100 = (v42 * atan(v88 / b) + v44 * v88 / (v88 * v88 + v48)) / v88 * sqrt(v53 + v86)
                    v101.append(weight * v100)
                v101 = fsum(v101) * v70
                v104 = v61 * v101
            else:
                v104 = 0.0
            v108 = v102 and v104 >= 0.25 * v63
            if v108:
                v110 = a > c
                v120 = v108 and v110
                if v120:
                    if v120:
                        v109 = a - c
                        v121 = log1p((v109 + (v109 * (a + c) / (v16 + v68) if v110 else 0.0)) / (c + v68))
                    else:
                        v121 = 0.0
                    v138 = []
                    for node, weight in RULE_0(v121 / 1.0):
                        v122 = node * v121
                        v127 = c * cosh(v122) + v68 * sinh(v122)
                        v137 = (v42 * atan(v127 / b) + v44 * v127 / (v127 * v127 + v48)) * pow(v127, 0.0)
                        v138.append(weight * v137)
                    v138 = fsum(v138) * v121
                    v139 = v138
                else:
                    v139 = 0.0
                v142 = v61 * v139
            else:
                v142 = v63 - v104
            value = mu * v142
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, c, theta, b, E_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_full_slip_displacement', 1, 'a', 'theta', 'b', 'E_star', 'G_star', 'mu'): {
        ('a',): (('a',), prepare_full_slip_displacement_a, block_full_slip_displacement_a, 1, 0, (), False),
        ('a', 'theta', 'b', 'E_star', 'G_star', 'mu'): (('a', 'theta', 'b', 'E_star', 'G_star', 'mu'), prepare_full_slip_displacement_all, block_full_slip_displacement_all, 2, 0, (), False),
    },
}
