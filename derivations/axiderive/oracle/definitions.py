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


def ring(shape: Shape, a: Number, digits: int) -> tuple[Number, Number]:
    """Radius at which the pressure first vanishes on unloading, and the depth at which it does."""
    with mp.workdps(2 * COARSE):
        radii, curve = [a * i / SCAN for i in range(SCAN)], _level(shape, a, COARSE)
        levels = [curve(r) for r in radii]
        best = max(range(SCAN), key=lambda i: levels[i])
        rough = _vertex(curve, radii[best], min(a / SCAN, (a - radii[best]) / 2), a, a) if best else mp.mpf(0)
    if best == 0:
        return rough, _level(shape, a, digits)(rough)
    return stationary(_level(shape, a, digits), rough, a)


def _level(shape: Shape, a: Number, digits: int) -> Callable[[Number], Number]:
    """The depth at which the pressure at r is zero."""
    face = Homogeneous(shape, mp.mpf(0), digits)
    return lambda r: face.depth(a) - mp.pi * mp.sqrt((a - r) * (a + r)) * face.pressure(a, r)


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
        if not radii[best]:
            return mp.mpf(0), pressure(digits)(mp.mpf(0))
        above = [*radii[1:], a][best] - radii[best]
        scale = min(above, radii[best] - radii[best - 1])
        rough = _vertex(pressure(COARSE), radii[best], scale / 2, a, scale)
    return stationary(pressure(digits), rough, scale)


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
