"""Rings of a contact straight from the pressure of its definition: where it first vanishes, and where it is greatest.

sqrt(a**2 - r**2) p >= 0 everywhere asks for d >= g(a) - pi sqrt(a**2 - r**2) p_0(r)/E*, with p_0 the pressure
without its edge term; the largest right-hand side over r decides.
"""

from __future__ import annotations

from collections.abc import Callable

import mpmath as mp

from .integrals import Homogeneous
from .shape import Number, Shape

COARSE = 16
"""Digits of the search for the ring."""
SCAN, DENSE = 16, 40
STENCIL = 9


def level(shape: Shape, a: Number, r: Number, digits: int) -> Number:
    """The depth at which the pressure at r is zero."""
    face = Homogeneous(shape, mp.mpf(0), digits)
    return face.depth(a) - mp.pi * mp.sqrt((a - r) * (a + r)) * face.pressure(a, r)


def ring(level: Callable[[Number, int], Number], a: Number, digits: int) -> tuple[Number, Number]:
    """Where the pressure first vanishes on unloading, and the level at which it does.

    `level` gives the depth, or load, at which it vanishes at a place, to some digits.
    """
    with mp.workdps(2 * COARSE):
        radii = [a * i / SCAN for i in range(SCAN)]
        levels = [level(r, COARSE) for r in radii]
        best = max(range(SCAN), key=lambda i: levels[i])
        width = min(a / SCAN, (a - radii[best]) / 2)
        rough = _vertex(lambda r: level(r, COARSE), radii[best], width, a, a) if best else mp.mpf(0)
    if best == 0:
        return rough, level(rough, digits)
    return stationary(lambda r: level(r, digits), rough, a)


def first_zero(shape: Shape, a: Number, digits: int) -> tuple[Number, Number]:
    """Radius at which the pressure of a round contact first vanishes on unloading, and the depth at which it does."""
    return ring(lambda r, digits: level(shape, a, r, digits), a, digits)


def greatest(shape: Shape, a: Number, digits: int) -> tuple[Number, Number]:
    """Radius of the greatest pressure and the integral of the pressure there, from a dense set of radii."""

    def pressure(digits: int) -> Callable[[Number], Number]:
        face = Homogeneous(shape, mp.mpf(0), digits)
        return lambda r: face.pressure(a, r)

    start = max((piece.lo for piece in shape.stretches if piece.lo < a), default=mp.mpf(0))
    with mp.workdps(2 * COARSE):
        # closer next to the last break, where the pressure is steepest
        radii = [start * i / SCAN for i in range(SCAN)] if start else []
        radii += [start + (a - start) * (mp.mpf(i) / DENSE) ** 2 for i in range(DENSE)]
        heights = [pressure(COARSE)(r) for r in radii]
        best = max(range(len(radii)), key=lambda i: heights[i])
        if radii[best]:
            above = [*radii[1:], a][best] - radii[best]
            scale = min(above, radii[best] - radii[best - 1])
            rough = _vertex(pressure(COARSE), radii[best], scale / 2, a, scale)
    if not radii[best]:
        return mp.mpf(0), pressure(digits)(mp.mpf(0))
    return stationary(pressure(digits), rough, scale)


def least(curve: Callable[[Number], Number], low: Number, high: Number) -> Number:
    """The least value between two points, by the golden section: exact to the square of the width that is left."""
    ratio = (mp.sqrt(5) - 1) / 2
    x, y = high - ratio * (high - low), low + ratio * (high - low)
    below, above = curve(x), curve(y)
    for _ in range(40):
        if below < above:
            high, y, above = y, x, below
            x = high - ratio * (high - low)
            below = curve(x)
        else:
            low, x, below = x, y, above
            y = low + ratio * (high - low)
            above = curve(y)
    return min(below, above)


def _vertex(curve: Callable[[Number], Number], start: Number, width: Number, end: Number, scale: Number) -> Number:
    """Repeated parabolas through three values, narrower each time that the vertex lies between them."""
    while width > scale * mp.mpf(10) ** -5:
        below, here, above = (curve(start + i * width) for i in (-1, 0, 1))
        move = (below - above) / (2 * (below - 2 * here + above))
        start += max(-1, min(1, move)) * width
        width = min(width / 10 if abs(move) < 1 else width, (end - start) / 2)
    return start


def stationary(curve: Callable[[Number], Number], rough: Number, scale: Number) -> tuple[Number, Number]:
    """Where the polynomial through equidistant values 1e-7 of a scale apart has no slope, and its value there.

    Its error is the ninth power of the distance; of the digits of the curve the place loses seven.
    """
    step, half = scale * mp.mpf(10) ** -7, STENCIL // 2
    coefficients = _interpolate([curve(rough + i * step) for i in range(-half, half + 1)], half)
    x = mp.mpf(0)
    for _ in range(20):
        slope = mp.polyval([c * (len(coefficients) - 1 - i) for i, c in enumerate(coefficients[:-1])], x)
        bend = mp.polyval([c * (n := len(coefficients) - 1 - i) * (n - 1) for i, c in enumerate(coefficients[:-2])], x)
        x -= slope / bend
    return rough + x * step, mp.polyval(coefficients, x)


def _interpolate(levels: list[Number], half: int) -> list[Number]:
    """Coefficients, highest first, of the polynomial through the levels at -half ... half."""
    nodes = range(-half, half + 1)
    matrix = mp.matrix([[mp.mpf(i) ** k for k in range(2 * half, -1, -1)] for i in nodes])
    return list(mp.lu_solve(matrix, mp.matrix(levels)))
