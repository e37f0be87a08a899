"""Least depth of complete contact, straight from the pressure: where it first vanishes and at which depth.

sqrt(a**2 - r**2) p >= 0 everywhere asks for d >= g(a) - pi sqrt(a**2 - r**2) p_0(r)/E*, with p_0 the pressure
without its edge term; the largest right-hand side over r decides.
"""

from __future__ import annotations

import mpmath as mp

from . import integrals
from .shape import Number, Shape

COARSE = 16
"""Digits of the search for the ring."""
STENCIL = 9


def level(face: Shape, a: Number, r: Number, digits: int) -> Number:
    """The depth at which the pressure at r is zero."""
    weighted = mp.pi * mp.sqrt((a - r) * (a + r)) * integrals.pressure(face, a, r, digits)
    return integrals.depth(face, a, digits) - weighted


def ring(face: Shape, a: Number, digits: int) -> tuple[Number, Number]:
    """Radius at which the pressure first vanishes on unloading, and the depth at which it does."""
    with mp.workdps(2 * COARSE):
        step = a / 16
        radii = [step * i for i in range(16)]
        best = max(range(16), key=lambda i: level(face, a, radii[i], COARSE))
        if best == 0:
            rough = mp.mpf(0)
        else:
            rough = _golden(face, a, radii[best] - step, min(radii[best] + step, a * (1 - mp.mpf(10) ** -3)))
    if rough == 0:
        return rough, level(face, a, rough, digits)
    return _refined(face, a, rough, digits)


def _golden(face: Shape, a: Number, lo: Number, hi: Number) -> Number:
    """Golden section for the maximum of the level: good to the square root of the precision."""
    ratio = (mp.sqrt(5) - 1) / 2
    inner, outer = hi - ratio * (hi - lo), lo + ratio * (hi - lo)
    levels = [level(face, a, x, COARSE) for x in (inner, outer)]
    while hi - lo > a * mp.mpf(10) ** -6:
        if levels[0] > levels[1]:
            hi, outer, inner = outer, inner, outer - ratio * (outer - lo)
            levels = [level(face, a, inner, COARSE), levels[0]]
        else:
            lo, inner, outer = inner, outer, inner + ratio * (hi - inner)
            levels = [levels[1], level(face, a, outer, COARSE)]
    return (lo + hi) / 2


def _refined(face: Shape, a: Number, rough: Number, digits: int) -> tuple[Number, Number]:
    """Maximum of the polynomial through equidistant levels 1e-6 a apart; its error is the ninth power of that."""
    step, half = a * mp.mpf(10) ** -6, STENCIL // 2
    levels = [level(face, a, rough + i * step, digits) for i in range(-half, half + 1)]
    coefficients = _interpolate(levels, half)
    x = mp.mpf(0)
    for _ in range(20):
        slope = mp.polyval([c * (len(coefficients) - 1 - i) for i, c in enumerate(coefficients[:-1])], x)
        bend = mp.polyval(
            [c * (n := len(coefficients) - 1 - i) * (n - 1) for i, c in enumerate(coefficients[:-2])], x
        )
        x -= slope / bend
    return rough + x * step, mp.polyval(coefficients, x)


def _interpolate(levels: list[Number], half: int) -> list[Number]:
    """Coefficients, highest first, of the polynomial through the levels at -half ... half."""
    nodes = range(-half, half + 1)
    matrix = mp.matrix([[mp.mpf(i) ** k for k in range(2 * half, -1, -1)] for i in nodes])
    return list(mp.lu_solve(matrix, mp.matrix(levels)))
