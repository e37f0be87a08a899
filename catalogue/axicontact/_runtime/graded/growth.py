"""How a contact on the graded half-space grows: depth, force and rate g'(t) of the shapes that profiles are made of.

With s = t cos(y) the depth is g(t) = t times the integral of f'(s) sin(y)**k over a
quarter turn, and the force 2 H/(1 + k) t**k times that of f'(s) s**2 sin(y)**k.
Every function below is one of these integrals, or a closed form of it; `*_force` is
the force over 2 H/(1 + k), `root` the distance sqrt(t**2 - b**2) or sqrt(R**2 - t**2).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable

import numpy as np

from ..integrals import integral_in_strip
from ..interface import Array, Kept
from .rules import nodes_for, raised, sine_mean, sine_over, sinh_over, weighted

FAR = 40.0
_LONGEST = 8.0


@Kept
def power_factor(n: Array, k: Array) -> Array:
    """Gamma(n/2 + 1) Gamma((1 + k)/2)/Gamma((n + 1 + k)/2): the depth of f = r**n over a**n."""
    half = (1.0 + k) / 2.0
    return (1.0 + k + n) / (1.0 + k) * _gamma(1.0 + half) / _rising(1.0 + n / 2.0, half)


@Kept
def power_excess(n: Array, k: Array) -> Array:
    """What is left of it less 1: the product over m of 1 + (n/2) (1 - k)/2/((m + 1 + n/2) (m + (1 + k)/2)), less 1."""
    x, e, half = n / 2.0, (1.0 - k) / 2.0, (1.0 + k) / 2.0
    log = np.zeros_like(x * e)
    for m in range(int(FAR)):
        log = log + np.log1p(x / (m + 1.0 + x) * (e / (m + half)))
    # the rest of the product is a quotient of two of the series of `_rising`
    low, high = FAR + half / 2.0, FAR + half / 2.0 + x
    u, v = 1.0 / (low * low), 1.0 / (high * high)
    first, second, third = series(e)
    change = -x * (low + high) * u * v * (first + second * (u + v) + third * (u * u + u * v + v * v))
    log = log + e * np.log1p(x / low) + np.log1p(change / (1.0 + first * u + second * u * u))
    return np.where(log < 0.5, np.expm1(log), power_factor(n, k) - 1.0)


def axis_power(n: Array, k: Array) -> Array:
    """n + k - 1, with which a pressure of f = r**n begins; the two first whose sum is exact, where it may cancel."""
    return np.where(n < 0.5, (k - 1.0) + n, (n - 1.0) + k)


def power_depth(a: Array, n: Array, k: Array) -> Array:
    """g(a) of f = r**n."""
    return power_factor(n, k) * a**n


def power_rate(t: Array, n: Array, k: Array) -> Array:
    return power_factor(n, k) * n * (t**n / t)


def power_force(a: Array, n: Array, k: Array) -> Array:
    return power_factor(n, k) * (n / (n + (1.0 + k))) * a**n * raised(a, k)


def power_mean(a: Array, n: Array, k: Array) -> Array:
    """Force over the square of the radius."""
    m = axis_power(n, k)
    power = np.where(a > 0.0, a**n / a * a**k, np.where(m > 0.0, 0.0, np.where(m < 0.0, np.inf, 1.0)))
    return power_factor(n, k) * (n / (n + (1.0 + k))) * power


def _gamma(x: Array) -> Array:
    return np.vectorize(math.gamma, otypes=[float])(x)


def _rising(x: Array, e: Array) -> Array:
    """Gamma(x + e)/Gamma(x) for x >= 1 and 0 < e < 1."""
    x, e = np.asarray(x, dtype=np.float64), np.asarray(e, dtype=np.float64)
    # Gamma(x + e) takes up the rounding of x + e many times over, 54 units of the last place at x = 39;
    # the quotients (x + i + e)/(x + i) take up the same one within a binade, 12 units
    steps = np.ceil(np.maximum(FAR - x, 0.0))
    if np.ndim(x + e) == 0:
        near = _near(float(x), float(e), int(steps))
    else:
        shifts = reversed(range(int(np.max(steps, initial=0.0))))
        near = _to_the_last_digit(np.where(i < steps, np.log1p(e / (x + i)), 0.0) for i in shifts)
    # the series of Tricomi and Erdelyi (1951) in w = x + (e - 1)/2
    w = x + steps + (e - 1.0) / 2.0
    first, second, third = series(e)
    # of numbers alone the operator has another rounding than of arrays
    return np.power(w, e) * (1.0 + (first + (second + third / (w * w)) / (w * w)) / (w * w)) * np.exp(-near)


def _near(x: float, e: float, steps: int) -> float:
    """The logarithm of the first `steps` quotients (x + i + e)/(x + i), summed as below."""
    total, lost = 0.0, 0.0
    for i in range(steps - 1, -1, -1):
        part = math.log1p(e / (x + i)) - lost
        before, total = total, total + part
        lost = (total - before) - part
    return total


def _to_the_last_digit(terms: Iterable[Array]) -> Array:
    """Their sum (Kahan), of which an exponential takes up every unit."""
    total, lost = 0.0, 0.0
    for term in terms:
        part = term - lost
        before, total = total, total + part
        lost = (total - before) - part
    return total


def series(e: Array) -> tuple[Array, Array, Array]:
    """Its coefficients of 1/w**2, 1/w**4 and 1/w**6."""
    first = -e * (e * e - 1.0) / 24.0
    second = e * (e - 1.0) * (e - 2.0) * (e - 3.0) * (e + 1.0) / 5760.0
    third = second * (e - 4.0) * (e - 5.0) / -504.0 * (35.0 * (e + 1.0) ** 2 + 42.0 * (e + 1.0) + 16.0)
    return first, second * (5.0 * e + 7.0), third


def sphere_depth(a: Array, root: Array, k: Array) -> Array:
    """g(a) of f = R - sqrt(R**2 - r**2); the ellipsoid is the sphere stretched by h/b."""
    open_ = np.where(root > 0.0, root, a)
    v = np.arcsinh(a / open_)
    value = a * _steepness(a, open_, v, k) ** k * v * weighted(lambda x: sinh_over(x) ** k, v, k, nodes_for(v))
    return np.where(a == 0.0, 0.0, np.where(root > 0.0, value, a * _last(k)))


def sphere_rate(t: Array, root: Array, k: Array) -> Array:
    open_ = np.where(root > 0.0, root, t)
    v, far = np.arcsinh(t / open_), np.hypot(t, root) / open_

    def integrand(x: Array) -> Array:
        return sinh_over(x) ** k * (1.0 + (far / np.cosh(x)) ** 2)

    # 2e4 units at the end of the sphere from one panel over all of v
    first = np.minimum(v, _LONGEST)
    total = (open_ / t * first) ** k * first * weighted(integrand, first, k, nodes_for(first))
    if np.any(v > first):
        rest = integral_in_strip(lambda x: integrand(first + x) * (first + x) ** k, v - first)
        total = total + (open_ / t) ** k * rest
    return np.where(root > 0.0, total, np.inf)


def sphere_force(a: Array, root: Array, k: Array) -> Array:
    open_ = np.where(root > 0.0, root, a)
    v = np.arcsinh(a / open_)
    whole = np.sinh(v)

    def integrand(x: Array) -> Array:
        over = sinh_over(x)
        return over**k * (1.0 - (over * (x / whole)) ** 2)

    value = a * raised(a, k) * _steepness(a, open_, v, k) ** k * v * weighted(integrand, v, k, nodes_for(v))
    return np.where(a == 0.0, 0.0, np.where(root > 0.0, value, a * raised(a, k) * 2.0 / (2.0 + k) * _last(k)))


def _steepness(a: Array, root: Array, v: Array, k: Array) -> Array:
    """v root/a, from the v at whose end the integral is largest for k > 0: a unit of v is 16 of its sinh at a = R."""
    return np.where(k > 0.0, v / np.sinh(v), root / a * v)


def _last(k: Array) -> Array:
    """Depth over radius where the sphere is vertical."""
    return np.where(k > 0.0, 1.0 / k, np.inf)


def hyperboloid_depth(a: Array, b: Array, k: Array) -> Array:
    """g(a) of f = sqrt(r**2 + b**2) - b."""
    # of one power: of two the rounding of the angle's would come to that of the radius'
    angle = np.arctan2(a, b)
    return np.where(a > 0.0, a * angle * (np.hypot(a, b) / a * angle) ** k * sine_mean(angle, k), 0.0)


def hyperboloid_rate(t: Array, b: Array, k: Array) -> Array:
    c, angle = np.hypot(t, b), np.arctan2(t, b)
    return angle * (c / t * angle) ** k * sine_mean(angle, k) * (1.0 - k * (b / c) ** 2) + t / c * (b / c)


def hyperboloid_force(a: Array, b: Array, k: Array) -> Array:
    angle = np.arctan2(a, b)

    def integrand(y: Array) -> Array:
        return sine_over(y) ** k * np.sin(angle - y) * np.sin(angle + y)

    c = np.hypot(a, b)
    return np.where(a > 0.0, c * c * angle * (c * angle) ** k * weighted(integrand, angle, k), 0.0)


def gaussian_depth(a: Array, s: Array, k: Array) -> Array:
    """g(a) of f = 1 - exp(-r**2/s**2)."""
    return 2.0 * (a / s) ** 2 * _bell(a, s, k, lambda fall: np.exp(-fall))


def gaussian_rate(t: Array, s: Array, k: Array) -> Array:
    # beyond the bump the sign is asked for, of what would underflow
    return 4.0 * t / s / s * _bell(t, s, k, lambda fall: (1.0 - fall) * np.exp(-np.minimum(fall, 700.0)))


def gaussian_force(a: Array, s: Array, k: Array) -> Array:
    return 2.0 * raised(a, k) * _bell(a, s, k, lambda fall: fall * np.exp(-fall))


def _bell(a: Array, s: Array, k: Array, of: Callable[..., Array]) -> Array:
    """Integral of x**k of(fall) from 0 to 1, where fall = (a/s)**2 (1 - x**2)."""
    square = (a / s) ** 2
    one = np.ones_like(np.asarray(square, dtype=np.float64))
    return weighted(lambda x: of((1.0 - x) * (1.0 + x) * square), one, k)
