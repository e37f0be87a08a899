"""What the definitions say about one contact at one point, and where a complete contact begins.

Rings of a contact straight from the pressure of its definition: where it first vanishes, and where it is greatest.

sqrt(a**2 - r**2) p >= 0 everywhere asks for d >= g(a) - pi sqrt(a**2 - r**2) p_0(r)/E*, with p_0 the pressure
without its edge term; the largest right-hand side over r decides.

One contact at one point, and what the definitions say about it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import mpmath as mp

from .. import notation as nt
from ..profiles.profile import Profile
from . import integrals
from .shape import Number, Shape, Values, number, shape

COARSE = 16
"""Digits of the search for the ring."""
SCAN, DENSE = 16, 40
STENCIL = 9


def level(face: Shape, a: Number, r: Number, digits: int) -> Number:
    """The depth at which the pressure at r is zero."""
    weighted = mp.pi * mp.sqrt((a - r) * (a + r)) * integrals.pressure(face, a, r, digits)
    return integrals.depth(face, a, digits) - weighted


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


def greatest(face: Shape, a: Number, digits: int) -> tuple[Number, Number]:
    """Radius of the greatest pressure and the integral of the pressure there, from a dense set of radii."""
    start = max((piece.lo for piece in face.stretches if piece.lo < a), default=mp.mpf(0))
    with mp.workdps(2 * COARSE):
        # closer next to the last break, where the pressure is steepest
        radii = [start * i / SCAN for i in range(SCAN)] if start else []
        radii += [start + (a - start) * (mp.mpf(i) / DENSE) ** 2 for i in range(DENSE)]
        heights = [integrals.pressure(face, a, r, COARSE) for r in radii]
        best = max(range(len(radii)), key=lambda i: heights[i])
        if not radii[best]:
            return mp.mpf(0), integrals.pressure(face, a, mp.mpf(0), digits)
        above = [*radii[1:], a][best] - radii[best]
        scale = min(above, radii[best] - radii[best - 1])
        rough = _vertex(lambda r: integrals.pressure(face, a, r, COARSE), radii[best], scale / 2, a, scale)
    return stationary(lambda r: integrals.pressure(face, a, r, digits), rough, scale)


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


@dataclass(frozen=True)
class Contact:
    """The shape up to the contact radius, and the depth where the edge of the face leaves it free."""

    values: Values
    digits: int
    shape: Shape
    radius: Number
    free_depth: Number | None

    def quantity(self, suffix: str) -> Number:
        """The quantity as its defining integral."""
        modulus, digits, a = number(self.values[nt.E_star]), self.digits, self.radius
        match suffix:
            case "d":
                return integrals.depth(self.shape, a, digits) if self.free_depth is None else self.free_depth
            case "F":
                return modulus * integrals.force(self.shape, a, digits, self.free_depth)
            case "pm":
                return modulus * integrals.force(self.shape, a, digits, self.free_depth) / (mp.pi * a**2)
            case "p":
                return modulus * integrals.pressure(self.shape, a, number(self.values[nt.r]), digits, self.free_depth)
            case "w":
                return integrals.displacement(self.shape, a, number(self.values[nt.r]), digits, self.free_depth)
            case "k" if self.free_depth is not None:  # the force is linear in the free depth
                deeper = integrals.force(self.shape, a, digits, self.free_depth + 1)
                return modulus * (deeper - integrals.force(self.shape, a, digits, self.free_depth))
            case "k":
                # both rates vanish where the contact ceases to be compact, hence the extra digits
                rates = [rate(self.shape, a, digits + 20) for rate in (integrals.force_rate, integrals.depth_rate)]
                return modulus * rates[0] / rates[1]
        message = f"no integral defines {suffix!r}; use d, F, p, w, k or pm"
        raise ValueError(message)


def contact(profile: Profile, values: Values, digits: int) -> Contact:
    """The contact of radius a; a complete one at the depth d, which may leave a convex face partly out of contact."""
    face, a = shape(profile, values), number(values[nt.a])
    if profile.compact:
        return Contact(values, digits, face, a, None)
    depth, full = number(values[nt.d]), integrals.depth(face, a, digits)
    if depth >= full:
        return Contact(values, digits, face, a, depth)
    radius = _partial_radius(profile, values, a * mp.sqrt(depth / full), digits)
    return Contact(values, digits, shape(profile, {**values, nt.a: radius}), radius, None)


def _partial_radius(profile: Profile, values: Values, start: Number, digits: int) -> Number:
    """g(a) = d by secants, with g by quadrature."""
    wanted = number(values[nt.d])

    def gap(a: Number) -> Number:
        return integrals.depth(shape(profile, {**values, nt.a: a}), a, digits) / wanted - 1

    nearby, tolerance = start * mp.mpf("1.001"), mp.mpf(10) ** (-2 * digits)
    return mp.findroot(gap, (start, nearby), solver="secant", tol=tolerance, verify=False)
