"""Programs of axicontact.tangential.sphere."""

from __future__ import annotations

from math import asinh, cosh, fsum, log1p, pow, sinh, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.tangential import sphere as bodies

C0 = np.array(2.0)
C1 = np.array(0.5)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def full_slip_displacement(a, R, E_star, G_star, mu):
    if a.__class__ is R.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            return mu * (E_star / G_star) * (a * (log1p(2.0 * a / (R - a)) / 2.0))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_full_slip_displacement_a(R, E_star, G_star, mu):
    v5 = E_star / G_star
    v6 = mu * v5
    return (R, v6)


def block_full_slip_displacement_a(out, a, R, v6, t0):
    np.multiply(C0, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(R, a, t0)
    np.divide(out, t0, t0)
    np.log1p(t0, t0)
    np.multiply(t0, C1, t0)
    np.multiply(a, t0, t0)
    np.multiply(v6, t0, out)


def prepare_full_slip_displacement_all():
    return ()


def block_full_slip_displacement_all(out, a, R, E_star, G_star, mu, t0, t1):
    np.divide(E_star, G_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(mu, out, out)
    np.multiply(C0, a, t0)
    np.subtract(R, a, t1)
    np.divide(t0, t1, t1)
    np.log1p(t1, t1)
    np.multiply(t1, C1, t1)
    np.multiply(a, t1, t1)
    np.multiply(out, t1, out)


def stick_radius(F_x, a, R, E_star, mu):
    if F_x.__class__ is a.__class__ is R.__class__ is E_star.__class__ is mu.__class__ is float and F_x > 1e-30 and (F_x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = bodies._stick_radius(F_x, a, R, E_star, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F_x, a, R, E_star, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_displacement(a, c, R, E_star, G_star, mu):
    if a.__class__ is c.__class__ is R.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v8 = R - a
            v12 = a * (log1p(2.0 * a / v8) / 2.0)
            v14 = R - c
            v18 = c * (log1p(2.0 * c / v14) / 2.0)
            v21 = v18 >= 0.25 * v12
            if v21:
                v47 = a > c
                v61 = v21 and v47
                if v61:
                    v23 = R - 0.0
                    v27 = sqrt((v23 if v23 > 0.0 or v23 != v23 else 0.0) * (R + 0.0))
                    v28 = c - 0.0
                    v32 = sqrt((v28 if v28 > 0.0 or v28 != v28 else 0.0) * (c + 0.0))
                    if v61:
                        v37 = a - 0.0
                        v41 = sqrt((v37 if v37 > 0.0 or v37 != v37 else 0.0) * (a + 0.0))
                        v45 = sqrt((v8 if v8 > 0.0 or v8 != v8 else 0.0) * (R + a))
                        v65 = 0.5 * log1p(2.0 * v27 * ((a - c) * (a + c) / (v41 + v32) if v47 else 0.0) / v45 * ((v27 + v41) / (v27 + v32)) / v45)
                    else:
                        v65 = 0.0
                    v78 = v27 * sqrt((v14 if v14 > 0.0 or v14 != v14 else 0.0) * (R + c))
                    v95 = []
                    for node, weight in RULE_0(v65 / 1.0):
                        v67 = node * v65
                        v68 = cosh(v67)
                        v69 = sinh(v67)
                        v72 = v27 * v68 + v32 * v69
                        v77 = v27 * (v32 * v68 + v27 * v69) / v72
                        v79 = v78 / v72
                        v82 = sqrt(0.0 + v77 * v77)
                        v94 = (asinh(v82 / v79) + R * v82 / (v79 * v79)) * (v79 / v27) * (v79 / v82) * pow(v82, 1.0)
                        v95.append(weight * v94)
                    v95 = fsum(v95) * v65
                    v96 = v95
                else:
                    v96 = 0.0
                v100 = v96
            else:
                v100 = v12 - v18
            value = mu * (E_star / G_star) * v100
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, R, E_star, G_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_force(a, c, R, E_star, mu):
    if a.__class__ is c.__class__ is R.__class__ is E_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v7 = R - a
            v10 = log1p(2.0 * a / v7) / 2.0
            v13 = R * R
            v14 = a / R
            if v10 < 1.0:
                v20 = v10 * v10
                v55 = v14 * (v14 * v14) * ((((((1.0716932453474512e-06 * v20 + 0.00019982814521087247) * v20 + 0.007076196047699156) * v20 + 0.08608622548411103) * v20 + 0.3073858328214721) * v20 + 0.3333333333333333) / (((((2.565078604208634e-08 * v20 + 2.0203143566039827e-05) * v20 + 0.001617010334189783) * v20 + 0.03639274880225476) * v20 + 0.32215749846441627) * v20 + 1.0))
            else:
                v55 = v10 - v14
            v58 = E_star * (a * a * v10 + v13 * v55)
            v60 = R - c
            v63 = log1p(2.0 * c / v60) / 2.0
            v66 = c / R
            if v63 < 1.0:
                v71 = v63 * v63
                v95 = v66 * (v66 * v66) * ((((((1.0716932453474512e-06 * v71 + 0.00019982814521087247) * v71 + 0.007076196047699156) * v71 + 0.08608622548411103) * v71 + 0.3073858328214721) * v71 + 0.3333333333333333) / (((((2.565078604208634e-08 * v71 + 2.0203143566039827e-05) * v71 + 0.001617010334189783) * v71 + 0.03639274880225476) * v71 + 0.32215749846441627) * v71 + 1.0))
            else:
                v95 = v63 - v66
            v98 = E_star * (c * c * v63 + v13 * v95)
            v101 = v98 >= 0.25 * v58
            if v101:
                v128 = a > c
                v142 = v101 and v128
                if v142:
                    v104 = R - 0.0
                    v108 = sqrt((v104 if v104 > 0.0 or v104 != v104 else 0.0) * (R + 0.0))
                    v109 = c - 0.0
                    v113 = sqrt((v109 if v109 > 0.0 or v109 != v109 else 0.0) * (c + 0.0))
                    if v142:
                        v118 = a - 0.0
                        v122 = sqrt((v118 if v118 > 0.0 or v118 != v118 else 0.0) * (a + 0.0))
                        v126 = sqrt((v7 if v7 > 0.0 or v7 != v7 else 0.0) * (R + a))
                        v146 = 0.5 * log1p(2.0 * v108 * ((a - c) * (a + c) / (v122 + v113) if v128 else 0.0) / v126 * ((v108 + v122) / (v108 + v113)) / v126)
                    else:
                        v146 = 0.0
                    v158 = v108 * sqrt((v60 if v60 > 0.0 or v60 != v60 else 0.0) * (R + c))
                    v175 = []
                    for node, weight in RULE_0(v146 / 1.0):
                        v147 = node * v146
                        v148 = cosh(v147)
                        v149 = sinh(v147)
                        v152 = v108 * v148 + v113 * v149
                        v157 = v108 * (v113 * v148 + v108 * v149) / v152
                        v159 = v158 / v152
                        v162 = sqrt(0.0 + v157 * v157)
                        v174 = (asinh(v162 / v159) + R * v162 / (v159 * v159)) * (v159 / v108) * (v159 / v162) * (v162 * v162)
                        v175.append(weight * v174)
                    v175 = fsum(v175) * v146
                    v176 = v175
                else:
                    v176 = 0.0
                v179 = 2.0 * E_star * v176
            else:
                v179 = v58 - v98
            value = mu * v179
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, R, E_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def traction(r, a, c, R, E_star, mu):
    if r.__class__ is a.__class__ is c.__class__ is R.__class__ is E_star.__class__ is mu.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = bodies._traction(r, a, c, R, E_star, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, c, R, E_star, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_full_slip_displacement', 1, 'a', 'R', 'E_star', 'G_star', 'mu'): {
        ('a',): (('a',), prepare_full_slip_displacement_a, block_full_slip_displacement_a, 1, 0, (), False),
        ('a', 'R', 'E_star', 'G_star', 'mu'): (('a', 'R', 'E_star', 'G_star', 'mu'), prepare_full_slip_displacement_all, block_full_slip_displacement_all, 2, 0, (), False),
    },
}
