"""Programs of axicontact.tangential.truncated_paraboloid."""

from __future__ import annotations

from math import asinh, cosh, exp, expm1, fsum, inf, log1p, nan, nextafter, pow, sinh, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.tangential import truncated_paraboloid as bodies

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def full_slip_displacement(a, R, b, E_star, G_star, mu):
    if a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30) and (b <= a):
        try:
            return mu * (E_star / G_star) * (a * sqrt((a - b) * (a + b)) / R)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_full_slip_displacement_a(R, b, E_star, G_star, mu):
    v6 = E_star / G_star
    v7 = mu * v6
    return (R, b, v7)


def block_full_slip_displacement_a(out, a, R, b, v7, t0):
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.multiply(a, t0, t0)
    np.divide(t0, R, t0)
    np.multiply(v7, t0, out)


def prepare_full_slip_displacement_all():
    return ()


def block_full_slip_displacement_all(out, a, R, b, E_star, G_star, mu, t0, t1):
    np.divide(E_star, G_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(mu, out, out)
    np.subtract(a, b, t0)
    np.add(a, b, t1)
    np.multiply(t0, t1, t1)
    np.sqrt(t1, t1)
    np.multiply(a, t1, t1)
    np.divide(t1, R, t1)
    np.multiply(out, t1, out)


def stick_radius(F_x, a, R, b, E_star, mu):
    if F_x.__class__ is a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is mu.__class__ is float and F_x > 1e-30 and (F_x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30) and (b <= a):
        try:
            value = bodies._stick_radius(F_x, a, R, b, E_star, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F_x, a, R, b, E_star, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_displacement(a, c, R, b, E_star, G_star, mu):
    if a.__class__ is c.__class__ is R.__class__ is b.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30) and (b <= a):
        try:
            v7 = a - b
            v8 = a + b
            v12 = a * sqrt(v7 * v8) / R
            v18 = c * sqrt((c - b) * (c + b)) / R
            v21 = v18 >= 0.25 * v12
            if v21:
                v22 = b if b > c or b != b else c
                v37 = a > v22
                v53 = v21 and v37
                if v53:
                    v23 = v22 - b
                    v28 = sqrt((v23 if v23 > 0.0 or v23 != v23 else 0.0) * (v22 + b))
                    v29 = v22 - 0.0
                    v33 = sqrt((v29 if v29 > 0.0 or v29 != v29 else 0.0) * (v22 + 0.0))
                    if v53:
                        v40 = (a - v22) * (a + v22)
                        if v37:
                            v44 = a - 0.0
                            v51 = v40 / (sqrt((v44 if v44 > 0.0 or v44 != v44 else 0.0) * (a + 0.0)) + v33)
                        else:
                            v51 = 0.0
                        v57 = log1p(((v40 / (sqrt((v7 if v7 > 0.0 or v7 != v7 else 0.0) * v8) + v28) if v37 else 0.0) + v51) / (v28 + v33))
                    else:
                        v57 = 0.0
                    v65 = b * b
                    v72 = b * b
                    v80 = []
                    for node, weight in RULE_0(v57 / 1.0):
                        v59 = node * v57
                        v64 = v28 * cosh(v59) + v33 * sinh(v59)
                        v68 = sqrt(v65 + v64 * v64)
                        v79 = (2.0 * v64 / R + v72 / (R * v64)) * (v64 / v68) * pow(v68, 1.0)
                        v80.append(weight * v79)
                    v80 = fsum(v80) * v57
                    v81 = v80
                else:
                    v81 = 0.0
                v85 = v81
            else:
                v85 = v12 - v18
            value = mu * (E_star / G_star) * v85
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, R, b, E_star, G_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_force(a, c, R, b, E_star, mu):
    if a.__class__ is c.__class__ is R.__class__ is b.__class__ is E_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30) and (b <= a):
        try:
            v6 = a - b
            v7 = a + b
            v11 = 2.0 * E_star
            v14 = v11 / (3.0 * R)
            v17 = b * b
            v20 = v14 * (2.0 * (a * a) + v17) * sqrt(v6 * v7)
            v29 = v14 * (2.0 * (c * c) + v17) * sqrt((c - b) * (c + b))
            v32 = v29 >= 0.25 * v20
            if v32:
                v33 = b if b > c or b != b else c
                v48 = a > v33
                v64 = v32 and v48
                if v64:
                    v34 = v33 - b
                    v39 = sqrt((v34 if v34 > 0.0 or v34 != v34 else 0.0) * (v33 + b))
                    v40 = v33 - 0.0
                    v44 = sqrt((v40 if v40 > 0.0 or v40 != v40 else 0.0) * (v33 + 0.0))
                    if v64:
                        v51 = (a - v33) * (a + v33)
                        if v48:
                            v55 = a - 0.0
                            v62 = v51 / (sqrt((v55 if v55 > 0.0 or v55 != v55 else 0.0) * (a + 0.0)) + v44)
                        else:
                            v62 = 0.0
                        v68 = log1p(((v51 / (sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * v7) + v39) if v48 else 0.0) + v62) / (v39 + v44))
                    else:
                        v68 = 0.0
                    v76 = b * b
                    v89 = []
                    for node, weight in RULE_0(v68 / 1.0):
                        v70 = node * v68
                        v75 = v39 * cosh(v70) + v44 * sinh(v70)
                        v79 = sqrt(v76 + v75 * v75)
                        v88 = (2.0 * v75 / R + v17 / (R * v75)) * (v75 / v79) * (v79 * v79)
                        v89.append(weight * v88)
                    v89 = fsum(v89) * v68
                    v90 = v89
                else:
                    v90 = 0.0
                v93 = v11 * v90
            else:
                v93 = v20 - v29
            value = mu * v93
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, R, b, E_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def traction(r, a, c, R, b, E_star, mu):
    if r.__class__ is a.__class__ is c.__class__ is R.__class__ is b.__class__ is E_star.__class__ is mu.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30) and (b <= a):
        try:
            v7 = r == b
            v10 = nextafter(b, inf) if v7 else r
            v11 = v10 < b
            v15 = a - b
            v19 = sqrt((v15 if v15 > 0.0 or v15 != v15 else 0.0) * (a + b))
            v30 = sqrt(abs(v10 - b) * (v10 + b))
            v34 = 2.0 * (0.0 if v11 else 1.0)
            v35 = 1.0 - v34
            v43 = v10 if v10 > b or v10 != v10 else b
            v56 = b * b
            v62 = b * b
            v73 = E_star / 3.141592653589793
            if a >= b:
                if r < a:
                    if v7 and a > b:
                        v75 = inf
                    else:
                        if a > v43:
                            if v11:
                                v25 = v19
                            else:
                                v20 = a - v10
                                v25 = sqrt((v20 if v20 > 0.0 or v20 != v20 else 0.0) * (a + v10))
                            v32 = asinh(v25 / v30)
                            v40 = v34 - v35 * expm1(-2.0 * v32)
                            v42 = v40 if v40 > 0.0 else inf
                            v68 = []
                            for node, weight in RULE_0(v32 / 1.0):
                                v45 = node * v32
                                v55 = v19 * (exp(-v45) * (v34 - v35 * expm1(-2.0 * (v32 - v45))) / v42)
                                v67 = (2.0 * v55 / R + v62 / (R * v55)) * v55 / sqrt(v56 + v55 * v55)
                                v68.append(weight * v67)
                            v68 = fsum(v68) * v32
                            v69 = v68
                        else:
                            v69 = 0.0
                        v75 = v73 * v69
                    v77 = v75
                else:
                    v77 = 0.0
                v80 = v77
            else:
                v80 = nan
            v128 = r < c
            if c >= b:
                if v128:
                    if v7 and c > b:
                        v127 = inf
                    else:
                        if c > v43:
                            v81 = c - b
                            v85 = sqrt((v81 if v81 > 0.0 or v81 != v81 else 0.0) * (c + b))
                            if v11:
                                v91 = v85
                            else:
                                v86 = c - v10
                                v91 = sqrt((v86 if v86 > 0.0 or v86 != v86 else 0.0) * (c + v10))
                            v93 = asinh(v91 / v30)
                            v97 = v34 - v35 * expm1(-2.0 * v93)
                            v99 = v97 if v97 > 0.0 else inf
                            v122 = []
                            for node, weight in RULE_0(v93 / 1.0):
                                v101 = node * v93
                                v111 = v85 * (exp(-v101) * (v34 - v35 * expm1(-2.0 * (v93 - v101))) / v99)
                                v121 = (2.0 * v111 / R + v62 / (R * v111)) * v111 / sqrt(v56 + v111 * v111)
                                v122.append(weight * v121)
                            v122 = fsum(v122) * v93
                            v123 = v122
                        else:
                            v123 = 0.0
                        v127 = v73 * v123
                    v129 = v127
                else:
                    v129 = 0.0
                v131 = v129
            else:
                v131 = nan
            v135 = v128 and v131 >= 0.25 * v80
            if v135:
                v136 = b if b > c or b != b else c
                v147 = a > v136
                v163 = v135 and v147
                if v163:
                    v137 = v136 - b
                    v141 = sqrt((v137 if v137 > 0.0 or v137 != v137 else 0.0) * (v136 + b))
                    v142 = v136 - r
                    v146 = sqrt((v142 if v142 > 0.0 or v142 != v142 else 0.0) * (v136 + r))
                    if v163:
                        v150 = (a - v136) * (a + v136)
                        if v147:
                            v154 = a - r
                            v161 = v150 / (sqrt((v154 if v154 > 0.0 or v154 != v154 else 0.0) * (a + r)) + v146)
                        else:
                            v161 = 0.0
                        v167 = log1p(((v150 / (v19 + v141) if v147 else 0.0) + v161) / (v141 + v146))
                    else:
                        v167 = 0.0
                    v186 = []
                    for node, weight in RULE_0(v167 / 1.0):
                        v168 = node * v167
                        v173 = v141 * cosh(v168) + v146 * sinh(v168)
                        v176 = sqrt(v56 + v173 * v173)
                        v185 = (2.0 * v173 / R + v62 / (R * v173)) * (v173 / v176) * pow(v176, 0.0)
                        v186.append(weight * v185)
                    v186 = fsum(v186) * v167
                    v187 = v186
                else:
                    v187 = 0.0
                v190 = v73 * v187
            else:
                v190 = v80 - v131
            value = mu * v190
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, c, R, b, E_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_full_slip_displacement', 1, 'a', 'R', 'b', 'E_star', 'G_star', 'mu'): {
        ('a',): (('a',), prepare_full_slip_displacement_a, block_full_slip_displacement_a, 1, 0, (), False),
        ('a', 'R', 'b', 'E_star', 'G_star', 'mu'): (('a', 'R', 'b', 'E_star', 'G_star', 'mu'), prepare_full_slip_displacement_all, block_full_slip_displacement_all, 2, 0, (), False),
    },
}
