"""Programs of axicontact.tangential.truncated_cone."""

from __future__ import annotations

from math import asinh, atan, cosh, exp, expm1, fsum, inf, log1p, nan, nextafter, pow, sinh, sqrt, tan

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.tangential import truncated_cone as bodies

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def full_slip_displacement(a, theta, b, E_star, G_star, mu):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30) and (b <= a):
        try:
            return mu * (E_star / G_star) * (tan(theta) * a * atan(sqrt((a - b) * (a + b)) / b))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_full_slip_displacement_a(theta, b, E_star, G_star, mu):
    v6 = E_star / G_star
    v7 = mu * v6
    v14 = np.tan(theta)
    return (b, v7, v14)


def block_full_slip_displacement_a(out, a, b, v7, v14, t0):
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.divide(t0, b, t0)
    np.arctan(t0, t0)
    np.multiply(v14, a, out)
    np.multiply(out, t0, t0)
    np.multiply(v7, t0, out)


def prepare_full_slip_displacement_all():
    return ()


def block_full_slip_displacement_all(out, a, theta, b, E_star, G_star, mu, t0, t1):
    np.divide(E_star, G_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(mu, out, out)
    np.subtract(a, b, t0)
    np.add(a, b, t1)
    np.multiply(t0, t1, t1)
    np.sqrt(t1, t1)
    np.divide(t1, b, t1)
    np.arctan(t1, t1)
    np.tan(theta, t0)
    np.multiply(t0, a, t0)
    np.multiply(t0, t1, t1)
    np.multiply(out, t1, out)


def stick_radius(F_x, a, theta, b, E_star, mu):
    if F_x.__class__ is a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is mu.__class__ is float and F_x > 1e-30 and (F_x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30) and (b <= a):
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
    if a.__class__ is c.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30) and (b <= a):
        try:
            v7 = a - b
            v8 = a + b
            v13 = tan(theta)
            v15 = v13 * a * atan(sqrt(v7 * v8) / b)
            v23 = v13 * c * atan(sqrt((c - b) * (c + b)) / b)
            v26 = v23 >= 0.25 * v15
            if v26:
                v27 = b if b > c or b != b else c
                v42 = a > v27
                v58 = v26 and v42
                if v58:
                    v28 = v27 - b
                    v33 = sqrt((v28 if v28 > 0.0 or v28 != v28 else 0.0) * (v27 + b))
                    v34 = v27 - 0.0
                    v38 = sqrt((v34 if v34 > 0.0 or v34 != v34 else 0.0) * (v27 + 0.0))
                    if v58:
                        v45 = (a - v27) * (a + v27)
                        if v42:
                            v49 = a - 0.0
                            v56 = v45 / (sqrt((v49 if v49 > 0.0 or v49 != v49 else 0.0) * (a + 0.0)) + v38)
                        else:
                            v56 = 0.0
                        v62 = log1p(((v45 / (sqrt((v7 if v7 > 0.0 or v7 != v7 else 0.0) * v8) + v33) if v42 else 0.0) + v56) / (v33 + v38))
                    else:
                        v62 = 0.0
                    v70 = b * b
                    v77 = b * v13
                    v84 = []
                    for node, weight in RULE_0(v62 / 1.0):
                        v64 = node * v62
                        v69 = v33 * cosh(v64) + v38 * sinh(v64)
                        v73 = sqrt(v70 + v69 * v69)
                        v83 = (v13 * atan(v69 / b) + v77 / v69) * (v69 / v73) * pow(v73, 1.0)
                        v84.append(weight * v83)
                    v84 = fsum(v84) * v62
                    v85 = v84
                else:
                    v85 = 0.0
                v89 = v85
            else:
                v89 = v15 - v23
            value = mu * (E_star / G_star) * v89
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, theta, b, E_star, G_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_force(a, c, theta, b, E_star, mu):
    if a.__class__ is c.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30) and (b <= a):
        try:
            v6 = a - b
            v7 = a + b
            v9 = sqrt(v6 * v7)
            v12 = tan(theta)
            v13 = E_star * v12
            v19 = v13 * (a * a * atan(v9 / b) + b * v9)
            v23 = sqrt((c - b) * (c + b))
            v30 = v13 * (c * c * atan(v23 / b) + b * v23)
            v33 = v30 >= 0.25 * v19
            if v33:
                v35 = b if b > c or b != b else c
                v50 = a > v35
                v66 = v33 and v50
                if v66:
                    v36 = v35 - b
                    v41 = sqrt((v36 if v36 > 0.0 or v36 != v36 else 0.0) * (v35 + b))
                    v42 = v35 - 0.0
                    v46 = sqrt((v42 if v42 > 0.0 or v42 != v42 else 0.0) * (v35 + 0.0))
                    if v66:
                        v53 = (a - v35) * (a + v35)
                        if v50:
                            v57 = a - 0.0
                            v64 = v53 / (sqrt((v57 if v57 > 0.0 or v57 != v57 else 0.0) * (a + 0.0)) + v46)
                        else:
                            v64 = 0.0
                        v70 = log1p(((v53 / (sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * v7) + v41) if v50 else 0.0) + v64) / (v41 + v46))
                    else:
                        v70 = 0.0
                    v78 = b * b
                    v85 = b * v12
                    v92 = []
                    for node, weight in RULE_0(v70 / 1.0):
                        v72 = node * v70
                        v77 = v41 * cosh(v72) + v46 * sinh(v72)
                        v81 = sqrt(v78 + v77 * v77)
                        v91 = (v12 * atan(v77 / b) + v85 / v77) * (v77 / v81) * (v81 * v81)
                        v92.append(weight * v91)
                    v92 = fsum(v92) * v70
                    v93 = v92
                else:
                    v93 = 0.0
                v96 = 2.0 * E_star * v93
            else:
                v96 = v19 - v30
            value = mu * v96
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, theta, b, E_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def traction(r, a, c, theta, b, E_star, mu):
    if r.__class__ is a.__class__ is c.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is mu.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30) and (b <= a):
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
            v62 = tan(theta)
            v64 = b * v62
            v74 = E_star / 3.141592653589793
            if a >= b:
                if r < a:
                    if v7 and a > b:
                        v76 = inf
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
                            v69 = []
                            for node, weight in RULE_0(v32 / 1.0):
                                v45 = node * v32
                                v55 = v19 * (exp(-v45) * (v34 - v35 * expm1(-2.0 * (v32 - v45))) / v42)
                                v68 = (v62 * atan(v55 / b) + v64 / v55) * v55 / sqrt(v56 + v55 * v55)
                                v69.append(weight * v68)
                            v69 = fsum(v69) * v32
                            v70 = v69
                        else:
                            v70 = 0.0
                        v76 = v74 * v70
                    v78 = v76
                else:
                    v78 = 0.0
                v81 = v78
            else:
                v81 = nan
            v129 = r < c
            if c >= b:
                if v129:
                    if v7 and c > b:
                        v128 = inf
                    else:
                        if c > v43:
                            v82 = c - b
                            v86 = sqrt((v82 if v82 > 0.0 or v82 != v82 else 0.0) * (c + b))
                            if v11:
                                v92 = v86
                            else:
                                v87 = c - v10
                                v92 = sqrt((v87 if v87 > 0.0 or v87 != v87 else 0.0) * (c + v10))
                            v94 = asinh(v92 / v30)
                            v98 = v34 - v35 * expm1(-2.0 * v94)
                            v100 = v98 if v98 > 0.0 else inf
                            v123 = []
                            for node, weight in RULE_0(v94 / 1.0):
                                v102 = node * v94
                                v112 = v86 * (exp(-v102) * (v34 - v35 * expm1(-2.0 * (v94 - v102))) / v100)
                                v122 = (v62 * atan(v112 / b) + v64 / v112) * v112 / sqrt(v56 + v112 * v112)
                                v123.append(weight * v122)
                            v123 = fsum(v123) * v94
                            v124 = v123
                        else:
                            v124 = 0.0
                        v128 = v74 * v124
                    v130 = v128
                else:
                    v130 = 0.0
                v132 = v130
            else:
                v132 = nan
            v136 = v129 and v132 >= 0.25 * v81
            if v136:
                v137 = b if b > c or b != b else c
                v148 = a > v137
                v164 = v136 and v148
                if v164:
                    v138 = v137 - b
                    v142 = sqrt((v138 if v138 > 0.0 or v138 != v138 else 0.0) * (v137 + b))
                    v143 = v137 - r
                    v147 = sqrt((v143 if v143 > 0.0 or v143 != v143 else 0.0) * (v137 + r))
                    if v164:
                        v151 = (a - v137) * (a + v137)
                        if v148:
                            v155 = a - r
                            v162 = v151 / (sqrt((v155 if v155 > 0.0 or v155 != v155 else 0.0) * (a + r)) + v147)
                        else:
                            v162 = 0.0
                        v168 = log1p(((v151 / (v19 + v142) if v148 else 0.0) + v162) / (v142 + v147))
                    else:
                        v168 = 0.0
                    v187 = []
                    for node, weight in RULE_0(v168 / 1.0):
                        v169 = node * v168
                        v174 = v142 * cosh(v169) + v147 * sinh(v169)
                        v177 = sqrt(v56 + v174 * v174)
                        v186 = (v62 * atan(v174 / b) + v64 / v174) * (v174 / v177) * pow(v177, 0.0)
                        v187.append(weight * v186)
                    v187 = fsum(v187) * v168
                    v188 = v187
                else:
                    v188 = 0.0
                v191 = v74 * v188
            else:
                v191 = v81 - v132
            value = mu * v191
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
