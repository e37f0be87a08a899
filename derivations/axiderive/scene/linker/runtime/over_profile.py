"""What the run time has for scenes alone.

Integrals over the profile itself, for profiles with any number of breaks or without closed forms; and shorter equals
of functions of the run time, in whose place they stand, which do without their speed.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from .integrals import difference_root
from .interface import BLOCK, Array
from .kernels import DAWSON
from .rules import pressure_integral_tanh

Weight = Callable[[Array, Array, Array, Array], Array]
STEP, HALVINGS, AGREED = 0.25, 4, 1e-8
"""The error of a rule is about the square of its difference to the rule of twice the step."""
STRETCH, FAR = 75.0, 13.5
"""x = t + t**3/STRETCH: at t = FAR what is left of an integral is exp(-46)."""


def over_profile(weight: Weight, a: Array, low: Array, high: Array, reach: float = FAR) -> Array:
    """Integral of weight/z over low < s < min(high, a), z**2 = a**2 - s**2; `weight` takes s, z, s - low and q.

    With q**2 = min(high, a)**2 - s**2 and sqrt(s**2 - low**2)/q = exp(x) the integrand falls exponentially on
    both sides, and the singularities that lengths of the profile bring, of any size, stay pi/2 from the path in x.
    """
    end = np.minimum(high, a)
    width, rest = difference_root(end, low), difference_root(a, end)

    def ordinates(t: Array) -> Array:
        total = np.zeros_like(a)
        for part in np.array_split(t, 1 + t.size * np.size(a) // BLOCK):
            v = part.reshape(-1, *(1,) * np.ndim(a))
            rise = np.exp(v + v**3 / STRETCH)
            near = np.hypot(1.0, rise)
            p, q = width * (rise / near), width / near
            s, z = np.hypot(low, p), np.hypot(rest, q)
            share = (p / s) * (q / z) * (rise / near**2) * (1.0 + 3.0 * v * v / STRETCH)
            total = total + np.sum(weight(s, z, p * (p / (s + low)), q) * share, axis=0)
        return total

    step = STEP
    total = step * ordinates(np.arange(-reach, FAR, step))
    for _ in range(HALVINGS):
        before, step = total, step / 2.0
        total = total / 2.0 + step * ordinates(np.arange(-reach + step, FAR, 2.0 * step))
        if not np.any(np.abs(total - before) > AGREED * np.abs(total)):
            break
    return np.where(width > 0.0, total, 0.0)


def pressure_over_profile(
    bend: Callable[[Array], Array], r: Array, a: Array, b: Array, kink: Array, reach: float = FAR
) -> Array:
    """Integral of g'(t)/sqrt(t**2 - r**2) from max(r, b) to a, for a profile with (s f')' = bend(s - b) from b on."""
    outer, start = difference_root(a, r), np.maximum(r, b)
    step = difference_root(start, r)

    def below(s: Array, z: Array, excess: Array, q: Array) -> Array:
        return bend(excess) * z * punches(r, a, q, outer, z)

    def above(s: Array, z: Array, excess: Array, q: Array) -> Array:
        gap = np.hypot(np.sqrt(excess * (s + start)), step)
        return bend(start - b + excess) * z * punches(s, a, gap, z, outer)

    whole = over_profile(below, a, b, r, reach) + over_profile(above, a, start, a, reach)
    gap, inner = difference_root(start, np.minimum(r, b)), difference_root(a, np.minimum(r, b))
    edge = b * kink * punches(start, a, gap, difference_root(a, start), inner)
    return np.where(a > start, whole + np.where(b > 0.0, edge, 0.0), 0.0)


def punches(m: Array, a: Array, gap: Array, rest: Array, other: Array) -> Array:
    """Integral of 1/sqrt((t**2 - m**2) (t**2 - n**2)) from m > n to a, by Carlson's R_F.

    The roots of m**2 - n**2, a**2 - m**2 and a**2 - n**2 are given.
    """
    x, y, z = (m / a * gap / a) ** 2, (gap / a) ** 2, (m / a * other / a) ** 2
    for _ in range(12):
        shift = np.sqrt(x) * np.sqrt(y) + np.sqrt(z) * (np.sqrt(x) + np.sqrt(y))
        x, y, z = (x + shift) / 4.0, (y + shift) / 4.0, (z + shift) / 4.0
    mean = (x + y + z) / 3.0
    u, v = 1.0 - x / mean, 1.0 - y / mean
    second, third = -(u * u + u * v + v * v), -u * v * (u + v)
    series = 1.0 - second / 10.0 + third / 14.0 + second * second / 24.0 - 3.0 * second * third / 44.0
    return rest / a / a * series / np.sqrt(mean)


def across(x: Array, excess: Array, r: Array) -> Array:
    """u (x + u) with u = sqrt(x**2 - r**2) and x = r + excess."""
    square = np.maximum(excess * (x + r), 1e-300)  # next to r, where what it divides is 0, the product underflows
    return square + x * np.sqrt(square)


def rational(v: Array, top: Sequence[float], bottom: Sequence[float]) -> Array:
    """P(v)/Q(v) with coefficients in ascending order."""
    return np.polyval(top[::-1], v) / np.polyval(bottom[::-1], v)


def beside(r: Array, a: Array, kernel: tuple[Sequence[float], Sequence[float], float]) -> Array:
    """pi/2 w(r)/g(a) beside a contact whose depth g is a power of its radius a < r."""
    square = (a / (r + np.sqrt((r - a) * (r + a)))) ** 2
    rest = np.polyval(kernel[0][::-1], square) / np.polyval(kernel[1][::-1], square)
    return a / r * (kernel[2] + square * rest)


def dawson(x: Array) -> Array:
    """Dawson's integral exp(-x**2) int_0^x exp(u**2) du for 0 <= x <= 25/16."""
    return x / np.polyval(DAWSON[0][::-1], x * x)


def arc_strips(r: Array, a: Array, R: Array) -> Array:
    """Integral of artanh(t/R)/sqrt(t**2 - r**2) from r to a <= R, for r < a."""
    return pressure_integral_tanh(_arc_rate, (), r, a, R)


def _arc_rate(t: Array, root: Array) -> Array:
    return np.arcsinh(t / root)
