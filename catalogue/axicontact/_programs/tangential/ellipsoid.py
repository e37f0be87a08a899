"""Programs of axicontact.tangential.ellipsoid."""

from __future__ import annotations

from math import asinh, cosh, fsum, log1p, pow, sinh, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.tangential import ellipsoid as bodies

C0 = np.array(2.0)
C1 = np.array(0.5)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def full_slip_displacement(a, h, b, E_star, G_star, mu):
    if a.__class__ is h.__class__ is b.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            return mu * (E_star / G_star) * (h / b * a * (log1p(2.0 * a / (b - a)) / 2.0))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_full_slip_displacement_a(h, b, E_star, G_star, mu):
    v6 = E_star / G_star
    v7 = mu * v6
    v15 = h / b
    return (b, v7, v15)


def block_full_slip_displacement_a(out, a, b, v7, v15, t0):
    np.multiply(C0, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(b, a, t0)
    np.divide(out, t0, t0)
    np.log1p(t0, t0)
    np.multiply(t0, C1, t0)
    np.multiply(v15, a, out)
    np.multiply(out, t0, t0)
    np.multiply(v7, t0, out)


def prepare_full_slip_displacement_all():
    return ()


def block_full_slip_displacement_all(out, a, h, b, E_star, G_star, mu, t0, t1):
    np.divide(E_star, G_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(mu, out, out)
    np.multiply(C0, a, t0)
    np.subtract(b, a, t1)
    np.divide(t0, t1, t1)
    np.log1p(t1, t1)
    np.multiply(t1, C1, t1)
    np.divide(h, b, t0)
    np.multiply(t0, a, t0)
    np.multiply(t0, t1, t1)
    np.multiply(out, t1, out)


def stick_radius(F_x, a, h, b, E_star, mu):
    if F_x.__class__ is a.__class__ is h.__class__ is b.__class__ is E_star.__class__ is mu.__class__ is float and F_x > 1e-30 and (F_x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = bodies._stick_radius(F_x, a, h, b, E_star, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F_x, a, h, b, E_star, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_displacement(a, c, h, b, E_star, G_star, mu):
    if a.__class__ is c.__class__ is h.__class__ is b.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v9 = b - a
            v13 = h / b
            v15 = v13 * a * (log1p(2.0 * a / v9) / 2.0)
            v17 = b - c
            v22 = v13 * c * (log1p(2.0 * c / v17) / 2.0)
            v25 = v22 >= 0.25 * v15
            if v25:
                v51 = a > c
                v65 = v25 and v51
                if v65:
                    v27 = b - 0.0
                    v31 = sqrt((v27 if v27 > 0.0 or v27 != v27 else 0.0) * (b + 0.0))
                    v32 = c - 0.0
                    v36 = sqrt((v32 if v32 > 0.0 or v32 != v32 else 0.0) * (c + 0.0))
                    if v65:
                        v41 = a - 0.0
                        v45 = sqrt((v41 if v41 > 0.0 or v41 != v41 else 0.0) * (a + 0.0))
                        v49 = sqrt((v9 if v9 > 0.0 or v9 != v9 else 0.0) * (b + a))
                        v69 = 0.5 * log1p(2.0 * v31 * ((a - c) * (a + c) / (v45 + v36) if v51 else 0.0) / v49 * ((v31 + v45) / (v31 + v36)) / v49)
                    else:
                        v69 = 0.0
                    v82 = v31 * sqrt((v17 if v17 > 0.0 or v17 != v17 else 0.0) * (b + c))
                    v100 = []
                    for node, weight in RULE_0(v69 / 1.0):
                        v71 = node * v69
                        v72 = cosh(v71)
                        v73 = sinh(v71)
                        v76 = v31 * v72 + v36 * v73
                        v81 = v31 * (v36 * v72 + v31 * v73) / v76
                        v83 = v82 / v76
                        v86 = sqrt(0.0 + v81 * v81)
                        v99 = (v13 * asinh(v86 / v83) + h * v86 / (v83 * v83)) * (v83 / v31) * (v83 / v86) * pow(v86, 1.0)
                        v100.append(weight * v99)
                    v100 = fsum(v100) * v69
                    v101 = v100
                else:
                    v101 = 0.0
                v105 = v101
            else:
                v105 = v15 - v22
            value = mu * (E_star / G_star) * v105
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, h, b, E_star, G_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_force(a, c, h, b, E_star, mu):
    if a.__class__ is c.__class__ is h.__class__ is b.__class__ is E_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v8 = b - a
            v11 = log1p(2.0 * a / v8) / 2.0
            v12 = E_star * h
            v16 = a / b
            if v11 < 1.0:
                v22 = v11 * v11
                v57 = v16 * (v16 * v16) * ((((((1.0716932453474512e-06 * v22 + 0.00019982814521087247) * v22 + 0.007076196047699156) * v22 + 0.08608622548411103) * v22 + 0.3073858328214721) * v22 + 0.3333333333333333) / (((((2.565078604208634e-08 * v22 + 2.0203143566039827e-05) * v22 + 0.001617010334189783) * v22 + 0.03639274880225476) * v22 + 0.32215749846441627) * v22 + 1.0))
            else:
                v57 = v11 - v16
            v60 = v12 * (a * a * v11 / b + b * v57)
            v62 = b - c
            v65 = log1p(2.0 * c / v62) / 2.0
            v69 = c / b
            if v65 < 1.0:
                v74 = v65 * v65
                v98 = v69 * (v69 * v69) * ((((((1.0716932453474512e-06 * v74 + 0.00019982814521087247) * v74 + 0.007076196047699156) * v74 + 0.08608622548411103) * v74 + 0.3073858328214721) * v74 + 0.3333333333333333) / (((((2.565078604208634e-08 * v74 + 2.0203143566039827e-05) * v74 + 0.001617010334189783) * v74 + 0.03639274880225476) * v74 + 0.32215749846441627) * v74 + 1.0))
            else:
                v98 = v65 - v69
            v101 = v12 * (c * c * v65 / b + b * v98)
            v104 = v101 >= 0.25 * v60
            if v104:
                v131 = a > c
                v145 = v104 and v131
                if v145:
                    v107 = b - 0.0
                    v111 = sqrt((v107 if v107 > 0.0 or v107 != v107 else 0.0) * (b + 0.0))
                    v112 = c - 0.0
                    v116 = sqrt((v112 if v112 > 0.0 or v112 != v112 else 0.0) * (c + 0.0))
                    if v145:
                        v121 = a - 0.0
                        v125 = sqrt((v121 if v121 > 0.0 or v121 != v121 else 0.0) * (a + 0.0))
                        v129 = sqrt((v8 if v8 > 0.0 or v8 != v8 else 0.0) * (b + a))
                        v149 = 0.5 * log1p(2.0 * v111 * ((a - c) * (a + c) / (v125 + v116) if v131 else 0.0) / v129 * ((v111 + v125) / (v111 + v116)) / v129)
                    else:
                        v149 = 0.0
                    v161 = v111 * sqrt((v62 if v62 > 0.0 or v62 != v62 else 0.0) * (b + c))
                    v168 = h / b
                    v180 = []
                    for node, weight in RULE_0(v149 / 1.0):
                        v150 = node * v149
                        v151 = cosh(v150)
                        v152 = sinh(v150)
                        v155 = v111 * v151 + v116 * v152
                        v160 = v111 * (v116 * v151 + v111 * v152) / v155
                        v162 = v161 / v155
                        v165 = sqrt(0.0 + v160 * v160)
                        v179 = (v168 * asinh(v165 / v162) + h * v165 / (v162 * v162)) * (v162 / v111) * (v162 / v165) * (v165 * v165)
                        v180.append(weight * v179)
                    v180 = fsum(v180) * v149
                    v181 = v180
                else:
                    v181 = 0.0
                v184 = 2.0 * E_star * v181
            else:
                v184 = v60 - v101
            value = mu * v184
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, h, b, E_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def traction(r, a, c, h, b, E_star, mu):
    if r.__class__ is a.__class__ is c.__class__ is h.__class__ is b.__class__ is E_star.__class__ is mu.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = bodies._traction(r, a, c, h, b, E_star, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, c, h, b, E_star, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_full_slip_displacement', 1, 'a', 'h', 'b', 'E_star', 'G_star', 'mu'): {
        ('a',): (('a',), prepare_full_slip_displacement_a, block_full_slip_displacement_a, 1, 0, (), False),
        ('a', 'h', 'b', 'E_star', 'G_star', 'mu'): (('a', 'h', 'b', 'E_star', 'G_star', 'mu'), prepare_full_slip_displacement_all, block_full_slip_displacement_all, 2, 0, (), False),
    },
}
