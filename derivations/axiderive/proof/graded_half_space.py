"""The graded half-space from its equations of equilibrium: h_N without the theory behind its formula.

A pressure p J0(x) on the surface of a half-space with E = z**k moves it by
c p J0(x).  The displacements U(z) J1(x), W(z) J0(x) obey two equations of second
order whose solutions at z = 0 are power series times 1 or z**(1 - k); those
without shear at the surface that vanish at a large depth give c.  The point
force (11.33) is the integral of such pressures over all wave numbers.
"""

from __future__ import annotations

import mpmath as mp

from .shape import Number

Pair = tuple[Number, Number]
DEPTH = 1.5
"""Depth at which the displacement is set to zero, per digit wanted: its image in the surface is exp(-2 depth)."""


def surface_compliance(k: Number, nu: Number, digits: int) -> Number:
    """c for E = z**k, -1 < k < 1, k != 0 and nu < 1/2, to about `digits` digits."""
    depth = mp.mpf(DEPTH) * digits
    with mp.workdps(digits + int(depth) + 20):
        k, nu = mp.mpf(k), mp.mpf(nu)
        shear, first = 1 / (2 * (1 + nu)), nu / ((1 + nu) * (1 - 2 * nu))
        wide = first + 2 * shear
        zero = mp.mpf(0)
        own = [_series(k, shear, first, zero, start, depth) for start in ((1, 0), (0, 1))]
        # the pressure 1 on the surface; z**(1 - k) in U would be a shear
        forced = _series(k, shear, first, 1 - k, (0, -1 / (wide * (1 - k))), depth)
        matrix = mp.matrix([[own[0][0], own[1][0]], [own[0][1], own[1][1]]])
        return mp.lu_solve(matrix, -mp.matrix(forced))[1]


def _series(k: Number, shear: Number, first: Number, power: Number, start: tuple[Number, Number], z: Number) -> Pair:
    """U and W at depth z of the solution z**power (start + ...)."""
    wide, both = first + 2 * shear, first + shear
    before, last = (mp.mpf(0), mp.mpf(0)), (mp.mpf(start[0]), mp.mpf(start[1]))
    total, scale, n = list(last), mp.mpf(1), 0
    while True:
        n += 1
        grade = (n + power) * (n + power - 1 + k)
        weight = both * (n - 1 + power)
        u = ((weight + k * shear) * last[1] + wide * before[0]) / (shear * grade)
        w = (-(weight + k * first) * last[0] + shear * before[1]) / (wide * grade)
        before, last = last, (u, w)
        scale *= z
        total = [total[0] + u * scale, total[1] + w * scale]
        if n > z and (abs(u) + abs(w)) * scale < mp.eps * (abs(total[0]) + abs(total[1])):
            return total[0] * z**power, total[1] * z**power


def h_N(k: Number, nu: Number, digits: int) -> Number:
    """h_N of (11.33): the point force is the integral of J0(s r) over s, and c scales with s**(k - 1)."""
    compliance = surface_compliance(k, nu, digits)
    with mp.workdps(digits + 20):
        k, nu = mp.mpf(k), mp.mpf(nu)
        fourier = 2**k * mp.gamma((1 + k) / 2) / mp.gamma((1 - k) / 2)
        return 2 * (1 - nu**2) * mp.cos(mp.pi * k / 2) / (compliance * fourier)
