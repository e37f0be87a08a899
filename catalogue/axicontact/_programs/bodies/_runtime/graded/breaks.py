"""Bodies of axicontact._runtime.graded.breaks over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import expm1, pow

from ....._programs.bodies._runtime.graded.growth import sphere_depth, sphere_force, sphere_rate
from ....._programs.bodies._runtime.graded.rules import raised, sine_integral, sine_over
from ....._programs.bodies._runtime.interface import either
from ....._runtime.graded.single import weighted
from ....._runtime.plain import integral_in_strip
from ....._runtime.plain import log, log1p, sqrt, MATH as np


def flank_depth(a, root, b, k):
    """g(a) of the flank f' = 1 for r > b."""
    return a * sine_integral(np.arctan2(root, b), k)


def flank_rate(t, root, b, k):
    return 0.0 if t < b else sine_integral(np.arctan2(root, b), k) + b / t * (root / t) ** (k - 1.0)


def flank_force(a, root, b, k):
    within = np.maximum(a, b)
    sides = raised(root / within, k) * (b / within) + sine_integral(np.arctan2(root, b), k)
    return a * raised(a, k) * sides / (2.0 + k)


def rim_depth(a, root, b, k):
    v4 = root / a
    return a * a * (v4 * pow(v4, k) if v4 > 0.0 else 0.0) / (1.0 + k) + 0.0 * b


def rim_rate(t, root, b, k):
    if t < b:
        return 0.0
    v4 = root / t
    return t * ((1.0 - k) / (1.0 + k) * (v4 * pow(v4, k) if v4 > 0.0 else 0.0) + pow(v4, k - 1.0))


def rim_force(a, root, b, k):
    v5 = root / (a if a > b or a != a else b)
    v19 = 3.0 + k
    v21 = 1.0 + k
    return a * a * (a * pow(a, k) if a > 0.0 else 0.0) * (v5 * pow(v5, k) if v5 > 0.0 else 0.0) * (v19 - v21 * (v5 * v5)) / (v21 * v19) + 0.0 * b


def rounding_depth(a, root, b, k):
    """g(a) of the rounding f' = r - b for r > b."""
    return a * a * _rounding(root, b, k, lambda y, fall: fall)


def rounding_rate(t, root, b, k):
    angle = np.arctan2(root, b)
    return 2.0 * t * raised(root / t, k) / (1.0 + k) - b * sine_integral(angle, k)


def rounding_force(a, root, b, k):
    return a * a * raised(a, k) * _rounding(root, b, k, lambda y, fall: fall * np.cos(y) ** 2)


def _rounding(root, b, k, of):
    """Integral of of(y, cos(y) - cos(Y)) sin(y)**k from 0 to Y = arccos(b/a)."""
    angle = np.arctan2(root, b)

    def smooth(y):
        fall = 2.0 * np.sin((angle + y) / 2.0) * np.sin((angle - y) / 2.0)
        return of(y, fall) * sine_over(y) ** k
    return raised(angle, k) * weighted(smooth, angle, k, 32)


def rounded_depth(a, root, b, k):
    """g(a) of f' = r/b for r < b, 1 beyond: the cone with a parabolic tip."""
    beyond = a / b * _tip(a, root, b, k) + sine_integral(np.arctan2(root, b), k)
    return a * (a / b / (1.0 + k) if a < b else beyond)


def rounded_rate(t, root, b, k):

    def beyond():
        return 2.0 * t / b * _tip(t, root, b, k) + sine_integral(np.arctan2(root, b), k)
    return either(t < b, lambda: 2.0 * t / b / (1.0 + k), beyond)


def rounded_force(a, root, b, k):
    tip = a / b * (_tip(a, root, b, k) - _tip(a, root, b, k + 2.0))
    inside = 2.0 * a / b / ((1.0 + k) * (3.0 + k))
    square = a * raised(a, k)
    return square * (inside if a < b else tip + flank_force(a, root, b, k) / square)


def _tip(a, root, b, k):
    if root < 0.5 * a:
        v16 = log(root / a)
    else:
        v10 = (b if b < a or b != b else a) / a
        v16 = 0.5 * log1p(-(v10 * v10))
    v18 = 1.0 + k
    return -expm1(v18 * v16) / v18


def past_tip(x, R, b, end):
    if end < b:
        return x - R + end * (end / (R + b))
    return x - b


def tipped_depth(a, root, R, b, end, k):
    """g(a) of the sphere R up to r = b, continued by its tangent cone; `end` is sqrt(R**2 - b**2).

    Next to b the root says on which side of it a contact is: a radius rounds to b up to t = 1e-8.
    """

    def beyond():
        cap = a ** (-k) * a * _cap(a, root, b, end, k, lambda below, far: 1.0 / far)
        return cap + b / end * flank_depth(a, root, b, k)
    return either(root > 0.0, beyond, lambda: sphere_depth(*_within(a, R, b), k))


def tipped_rate(t, root, R, b, end, k):

    def beyond():
        cap = t ** (-k) * _cap(t, root, b, end, k, lambda below, far: (1.0 + (R / far) ** 2) / far)
        return cap + b / end * sine_integral(np.arctan2(root, b), k)
    return either(root > 0.0, beyond, lambda: sphere_rate(*_within(t, R, b), k))


def tipped_force(a, root, R, b, end, k):

    def beyond():
        cap = _cap(a, root, b, end, k, lambda below, far: below / far)
        return cap + b / end * flank_force(a, root, b, k)
    return either(root > 0.0, beyond, lambda: sphere_force(*_within(a, R, b), k))


def _within(a, R, b):
    v3 = a if a < b or a != a else b
    v4 = R - v3
    return (v3, sqrt((v4 if v4 > 0.0 or v4 != v4 else 0.0) * (R + v3)))


def _cap(t, root, b, end, k, of):
    """Integral of z**k of(t**2 - z**2, sqrt(R**2 - t**2 + z**2)) over sqrt(t**2 - b**2) < z < t.

    In the logarithm of the distance to the nearest of z = 0 and the end of the sphere, as that of the displacement.
    """
    low = np.minimum(root, end) if root > 0.0 else end
    top, half = (np.hypot(low, b), np.log1p((b / low) ** 2) / 4.0 + 0.0 * t)

    def along(near, risen):
        more = risen * (near + low)
        z = np.sqrt(root * root + more)
        return z ** k * of(b * b - more, np.sqrt(end * end + more)) * near * (near / z)

    def from_low(x):
        return along(low * np.exp(x), low * np.expm1(x))

    def from_top(x):
        near = top * np.exp(-x)
        return along(near, near - low if near > 2.0 * low else b * (b / (top + low)) + top * np.expm1(-x))
    return integral_in_strip(from_low, half) + integral_in_strip(from_top, half)
