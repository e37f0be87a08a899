"""The same for profiles with a break at r = b: flank, rim, rounding, rounded cone and cone with a spherical tip.

Their growth takes the radius and root = sqrt(a**2 - b**2), which the radius alone cannot carry close to b.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..integrals import difference_root, integral_in_strip
from ..interface import Array, either
from .growth import sphere_depth, sphere_force, sphere_rate
from .rules import raised, sine_integral, sine_over, weighted


def flank_depth(a: Array, root: Array, b: Array, k: Array) -> Array:
    """g(a) of the flank f' = 1 for r > b."""
    return a * sine_integral(np.arctan2(root, b), k)


def flank_rate(t: Array, root: Array, b: Array, k: Array) -> Array:
    return np.where(t < b, 0.0, sine_integral(np.arctan2(root, b), k) + b / t * (root / t) ** (k - 1.0))


def flank_force(a: Array, root: Array, b: Array, k: Array) -> Array:
    within = np.maximum(a, b)
    sides = raised(root / within, k) * (b / within) + sine_integral(np.arctan2(root, b), k)
    return a * raised(a, k) * sides / (2.0 + k)


def rim_depth(a: Array, root: Array, b: Array, k: Array) -> Array:
    """g(a) of the rim f' = r for r > b."""
    sine = root / a
    return a * a * raised(sine, k) / (1.0 + k) + 0.0 * b


def rim_rate(t: Array, root: Array, b: Array, k: Array) -> Array:
    sine = root / t
    return np.where(t < b, 0.0, t * ((1.0 - k) / (1.0 + k) * raised(sine, k) + sine ** (k - 1.0)))


def rim_force(a: Array, root: Array, b: Array, k: Array) -> Array:
    sine = root / np.maximum(a, b)
    return a * a * raised(a, k) * raised(sine, k) * (3.0 + k - (1.0 + k) * sine**2) / ((1.0 + k) * (3.0 + k)) + 0.0 * b


def rounding_depth(a: Array, root: Array, b: Array, k: Array) -> Array:
    """g(a) of the rounding f' = r - b for r > b."""
    return a * a * _rounding(root, b, k, lambda y, fall: fall)


def rounding_rate(t: Array, root: Array, b: Array, k: Array) -> Array:
    angle = np.arctan2(root, b)
    return 2.0 * t * raised(root / t, k) / (1.0 + k) - b * sine_integral(angle, k)


def rounding_force(a: Array, root: Array, b: Array, k: Array) -> Array:
    return a * a * raised(a, k) * _rounding(root, b, k, lambda y, fall: fall * np.cos(y) ** 2)


def _rounding(root: Array, b: Array, k: Array, of: Callable[..., Array]) -> Array:
    """Integral of of(y, cos(y) - cos(Y)) sin(y)**k from 0 to Y = arccos(b/a)."""
    angle = np.arctan2(root, b)

    def smooth(y: Array) -> Array:
        fall = 2.0 * np.sin((angle + y) / 2.0) * np.sin((angle - y) / 2.0)
        return of(y, fall) * sine_over(y) ** k

    return raised(angle, k) * weighted(smooth, angle, k, 32)


def rounded_depth(a: Array, root: Array, b: Array, k: Array) -> Array:
    """g(a) of f' = r/b for r < b, 1 beyond: the cone with a parabolic tip."""
    beyond = a / b * _tip(a, root, b, k) + sine_integral(np.arctan2(root, b), k)
    return a * np.where(a < b, a / b / (1.0 + k), beyond)


def rounded_rate(t: Array, root: Array, b: Array, k: Array) -> Array:
    def beyond() -> Array:
        return 2.0 * t / b * _tip(t, root, b, k) + sine_integral(np.arctan2(root, b), k)

    return either(t < b, lambda: 2.0 * t / b / (1.0 + k), beyond)


def rounded_force(a: Array, root: Array, b: Array, k: Array) -> Array:
    tip = a / b * (_tip(a, root, b, k) - _tip(a, root, b, k + 2.0))
    inside = 2.0 * a / b / ((1.0 + k) * (3.0 + k))
    square = a * raised(a, k)
    return square * np.where(a < b, inside, tip + flank_force(a, root, b, k) / square)


def _tip(a: Array, root: Array, b: Array, k: Array) -> Array:
    """Integral of cos(y) sin(y)**k from arccos(b/a) to pi/2."""
    log = np.where(root < 0.5 * a, np.log(root / a), 0.5 * np.log1p(-((np.minimum(b, a) / a) ** 2)))
    return -np.expm1((1.0 + k) * log) / (1.0 + k)


def past_tip(x: Array, R: Array, b: Array, end: Array) -> Array:
    """x - b for the b = sqrt(R**2 - end**2) at which a spherical tip ends.

    A steep flank multiplies the rounding of b, of which the distance from R is free.
    """
    return np.where(end < b, (x - R) + end * (end / (R + b)), x - b)


def tipped_depth(a: Array, root: Array, R: Array, b: Array, end: Array, k: Array) -> Array:
    """g(a) of the sphere R up to r = b, continued by its tangent cone; `end` is sqrt(R**2 - b**2).

    Next to b the root says on which side of it a contact is: a radius rounds to b up to t = 1e-8.
    """

    def beyond() -> Array:
        cap = a**-k * a * _cap(a, root, b, end, k, lambda below, far: 1.0 / far)
        return cap + b / end * flank_depth(a, root, b, k)

    return either(root > 0.0, beyond, lambda: sphere_depth(*_within(a, R, b), k))


def tipped_rate(t: Array, root: Array, R: Array, b: Array, end: Array, k: Array) -> Array:
    def beyond() -> Array:
        cap = t**-k * _cap(t, root, b, end, k, lambda below, far: (1.0 + (R / far) ** 2) / far)
        return cap + b / end * sine_integral(np.arctan2(root, b), k)

    return either(root > 0.0, beyond, lambda: sphere_rate(*_within(t, R, b), k))


def tipped_force(a: Array, root: Array, R: Array, b: Array, end: Array, k: Array) -> Array:
    def beyond() -> Array:
        cap = _cap(a, root, b, end, k, lambda below, far: below / far)
        return cap + b / end * flank_force(a, root, b, k)

    return either(root > 0.0, beyond, lambda: sphere_force(*_within(a, R, b), k))


def _within(a: Array, R: Array, b: Array) -> tuple[Array, Array]:
    inner = np.minimum(a, b)
    return inner, difference_root(R, inner)


def _cap(t: Array, root: Array, b: Array, end: Array, k: Array, of: Callable[..., Array]) -> Array:
    """Integral of z**k of(t**2 - z**2, sqrt(R**2 - t**2 + z**2)) over sqrt(t**2 - b**2) < z < t.

    In the logarithm of the distance to the nearest of z = 0 and the end of the sphere, as that of the displacement.
    """
    low: Array = np.where(root > 0.0, np.minimum(root, end), end)
    top, half = np.hypot(low, b), np.log1p((b / low) ** 2) / 4.0 + 0.0 * t

    def along(near: Array, risen: Array) -> Array:
        more = risen * (near + low)
        z = np.sqrt(root * root + more)
        return z**k * of(b * b - more, np.sqrt(end * end + more)) * near * (near / z)

    def from_low(x: Array) -> Array:
        return along(low * np.exp(x), low * np.expm1(x))

    def from_top(x: Array) -> Array:
        near = top * np.exp(-x)
        return along(near, np.where(near > 2.0 * low, near - low, b * (b / (top + low)) + top * np.expm1(-x)))

    return integral_in_strip(from_low, half) + integral_in_strip(from_top, half)
