"""Pressure on the graded half-space: integral of g'(t) (t**2 - r**2)**((k - 1)/2) over the growth from r to a.

`slope` gives g'(t).  In u = sqrt(t**2 - r**2) the weight is u**k; each further substitution keeps
the singularities of g' away from the path, as in the rules of the homogeneous half-space.
The pressure is H/pi times this integral.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ._elementwise import Array
from ._graded_breaks import rounded_rate, rounding_rate, tipped_rate
from ._graded_growth import gaussian_rate, hyperboloid_rate, power_factor, sphere_rate
from ._graded_rules import NODES, raised, sine_integral, sinh_over, weighted
from ._graded_waves import waves_rate
from ._integrals import difference_root, integral, integral_by_panels

Slope = Callable[..., Array]
_TERMS, _PANEL = 22, 3.0


def power_pressure(r: Array, a: Array, n: Array, k: Array) -> Array:
    """The integral for f = r**n."""
    return power_factor(n, k) * n * (a**n / a * a**k) * power_growth(r, a, n, k)


def flank_pressure(r: Array, a: Array, b: Array, k: Array) -> Array:
    """The integral for f' = 1 beyond b."""

    def slope(t: Array, root: Array) -> Array:
        return _tame(t, root, k) * sine_integral(np.arctan2(root, b), k) + b / t

    return _cornered(growth_beyond(slope, r, a, b, k), r, a, b, k)


def rim_pressure(r: Array, a: Array, b: Array, k: Array) -> Array:
    """The integral for f' = r beyond b."""

    def slope(t: Array, root: Array) -> Array:
        return t * ((1.0 - k) / (1.0 + k) * (root / t) ** 2 + 1.0)

    return _cornered(growth_beyond(slope, r, a, b, k), r, a, b, k)


def rounding_pressure(r: Array, a: Array, b: Array, k: Array) -> Array:
    """The integral for f' = r - b beyond b."""
    return growth_beyond(lambda t, root: _tame(t, root, k) * rounding_rate(t, root, b, k), r, a, b, k)


def rounded_pressure(r: Array, a: Array, b: Array, k: Array) -> Array:
    """The integral for f' = r/b up to b, 1 beyond."""
    tip = np.where(r < b, power_pressure(np.minimum(r, b), np.minimum(a, b), 2.0, k) / (2.0 * b), 0.0)
    return tip + growth_beyond_cap(lambda t, root: rounded_rate(t, root, b, k), r, a, b, k)


def sphere_pressure(r: Array, a: Array, R: Array, k: Array) -> Array:
    """The integral for a sphere of unit height over radius."""
    return tanh_growth(lambda t, root: sphere_rate(t, root, k), r, a, R, k)


def tipped_pressure(r: Array, a: Array, R: Array, b: Array, end: Array, k: Array) -> Array:
    """The integral for a sphere up to b, continued by its tangent cone."""
    tip = np.where(r < b, sphere_pressure(np.minimum(r, b), np.minimum(a, b), R, k), 0.0)
    return tip + growth_beyond_cap(lambda t, root: tipped_rate(t, root, R, b, end, k), r, a, b, k)


def hyperboloid_pressure(r: Array, a: Array, b: Array, k: Array) -> Array:
    """The integral for f = sqrt(r**2 + b**2) - b."""
    return sinh_growth(lambda t: hyperboloid_rate(t, b, k), r, a, b, k)


def gaussian_pressure(r: Array, a: Array, s: Array, k: Array) -> Array:
    """The integral for f = 1 - exp(-r**2/s**2)."""
    return smooth_growth(lambda t: gaussian_rate(t, s, k), r, a, k)


def waves_pressure(r: Array, a: Array, q: Array, k: Array) -> Array:
    """The integral for f = 1 - cos(q r)."""
    return wavy_growth(lambda t: waves_rate(t, q, k), r, a, 2.0 * np.pi / q, k)


def _cornered(value: Array, r: Array, a: Array, b: Array, k: Array) -> Array:
    """The pressure at a corner, which is finite for k > 0 only."""
    return np.where((r == b) & (a > b) & (k <= 0.0), np.inf, value)


def _tame(t: Array, root: Array, k: Array) -> Array:
    return (root / t) ** (1.0 - k)


def power_growth(r: Array, a: Array, n: Array, k: Array) -> Array:
    """The integral for g'(t) = t**(n - 1), over a**(n + k - 1)."""
    # of the three numbers the two whose sum is exact first: it may cancel
    m = np.where(n < 0.5, (k - 1.0) + n, (n - 1.0) + k)
    length = np.log1p((a - r) / r)
    length = np.where(np.isfinite(length), length, np.log(a) - np.log(r))
    near = np.minimum(np.minimum(length, 1.0), 20.0 / np.maximum(np.abs(m), 1e-300))
    half, above = (k - 1.0) / 2.0, (k + 1.0) / 2.0

    def smooth(x: Array) -> Array:
        shrink = np.where(x > 0.0, -np.expm1(-2.0 * x) / np.where(x > 0.0, x, 1.0), 2.0)
        return shrink**half * np.exp(-m * (near - x))

    rest = length - near
    place = np.minimum(r / a * np.exp(near), 1.0)
    far = place**n / place * place**k
    first = np.where(rest > 0.0, far, 1.0) * near**above
    first = first * weighted(smooth, near, half, above=above)
    total = first + np.where(np.abs(m) > 20.0, _steep(rest, near, m, half), _tail(rest, near, m, half, far))
    return np.where(r > 0.0, total, np.where(m > 0.0, 1.0 / np.where(m > 0.0, m, 1.0), np.inf))


def _tail(rest: Array, near: Array, m: Array, half: Array, far: Array) -> Array:
    """What lies beyond ln(t/r) = `near` = 1: the binomial series in exp(-2 x), whose terms are positive.

    `far` is exp(-m rest), where the logarithm of a ratio far from 1 would cost its number of digits.
    """
    rest = np.where(np.isfinite(rest), rest, 0.0)
    factor, total = np.ones_like(rest + half), np.zeros_like(rest + half)
    for j in range(_TERMS):
        rate = m - 2.0 * j
        span = np.where(rate == 0.0, rest, -np.expm1(-np.abs(rate) * rest) / np.where(rate == 0.0, 1.0, np.abs(rate)))
        level = np.where(rate > 0.0, np.exp(-2.0 * j * (near + rest)), np.exp(-2.0 * j * near) * far)
        total = total + factor * span * level
        factor = factor * (j - half) / (j + 1.0)
    return total


def _steep(rest: Array, near: Array, m: Array, half: Array) -> Array:
    """What lies beyond ln(t/r) = `near`, for a large power m, of which only the upper end counts."""
    rest = np.where(np.isfinite(rest), rest, np.inf)
    stop = np.minimum(rest, 42.0 / np.maximum(np.abs(m), 20.0))

    def integrand(y: Array) -> Array:
        return np.exp(-m * y) * (-np.expm1(-2.0 * (near + (rest - y)))) ** half

    return integral(integrand, stop, NODES)


def smooth_growth(slope: Slope, r: Array, a: Array, k: Array) -> Array:
    """The integral for g'(t)/t without singularities near."""

    def smooth(u: Array) -> Array:
        t = np.sqrt(r * r + u * u)
        return slope(t) / t

    stop = difference_root(a, r)
    return raised(stop, k) * weighted(smooth, stop, k)


def wavy_growth(slope: Slope, r: Array, a: Array, wavelength: Array, k: Array) -> Array:
    """The integral where g' oscillates with a wavelength: one panel with the weight, then plain ones."""
    stop = difference_root(a, r)
    first = np.minimum(stop, wavelength)

    def smooth(u: Array) -> Array:
        t = np.sqrt(r * r + u * u)
        return slope(t) / t

    total = raised(first, k) * weighted(smooth, first, k)
    return total + integral_by_panels(lambda u: smooth(first + u) * (first + u) ** k, stop - first, wavelength, NODES)


def sinh_growth(slope: Slope, r: Array, a: Array, b: Array, k: Array) -> Array:
    """The integral where g' has a singularity at t**2 = -b**2."""
    scale = np.hypot(r, b)

    def smooth(v: Array) -> Array:
        t = np.hypot(r, scale * np.sinh(v))
        return slope(t) / t * np.cosh(v) * sinh_over(v) ** k

    stop = np.arcsinh(difference_root(a, r) / scale)
    return raised(scale, k) * raised(stop, k) * weighted(smooth, stop, k)


def tanh_growth(slope: Slope, r: Array, a: Array, R: Array, k: Array) -> Array:
    """The integral where g' has a singularity at t = R; `slope` takes t and sqrt(R**2 - t**2)."""
    scale = difference_root(R, r)

    def smooth(v: Array) -> Array:
        root = scale / np.cosh(v)
        t = np.hypot(r, scale * np.tanh(v))
        return slope(t, root) / t * (sinh_over(v) / np.cosh(v)) ** k / np.cosh(v) ** 2

    stop = np.arcsinh(difference_root(a, r) / difference_root(R, a))
    value = raised(scale, k) * raised(stop, k) * weighted(smooth, stop, k)
    return np.where(a < R, value, np.inf)


def growth_beyond(slope: Slope, r: Array, a: Array, b: Array, k: Array) -> Array:
    """The integral from max(r, b) on for a profile with a corner at b.

    `slope` takes t and sqrt(t**2 - b**2) and returns g'(t) (sqrt(t**2 - b**2)/t)**(1 - k), which is finite there.
    """
    r = np.where(r == b, np.nextafter(b, 0.0), r)
    within = r < b
    scale = np.sqrt(np.abs(r - b) * (r + b))

    def smooth(v: Array) -> Array:
        # on either side of b, the two roots are scale cosh(v) and scale sinh(v)
        root = scale * np.where(within, np.sinh(v), np.cosh(v))
        t = np.hypot(b, root)
        return slope(t, root) * (scale / t * np.cosh(v) * sinh_over(v)) ** k

    span = np.where(within, difference_root(a, b), difference_root(a, r)) / scale
    stop = np.arcsinh(span)
    first = np.minimum(stop, _PANEL)
    near = raised(first, k) * weighted(smooth, first, k)
    value = scale**k * (near + _rest(lambda v: smooth(v) * v**k, first, stop))
    return np.where(a > np.maximum(r, b), value, 0.0)


def _rest(integrand: Callable[[Array], Array], start: Array, stop: Array) -> Array:
    """Integral from start to stop, long only where r is close to b."""
    half = (stop - start) / 2.0
    first = integral(lambda v: integrand(start + v), half, NODES)
    return first + integral(lambda v: integrand(start + half + v), half, NODES)


def growth_beyond_cap(slope: Slope, r: Array, a: Array, b: Array, k: Array) -> Array:
    """The integral from max(r, b) on for a slope continuous at b; `slope` takes t and sqrt(t**2 - b**2), returns g'(t).

    There g' carries a power (t**2 - b**2)**((1 + k)/2), which a cube in the variable makes smooth.
    """
    r = np.where(r == b, np.nextafter(b, 0.0), r)
    within = r < b
    scale = np.sqrt(np.abs(r - b) * (r + b))
    span = np.where(within, difference_root(a, b), difference_root(a, r)) / scale
    stop = np.arcsinh(span)

    first = np.minimum(stop, _PANEL)

    def inner(v: Array) -> Array:
        root = scale * np.sinh(v)
        t = np.hypot(b, root)
        return slope(t, root) * root / t * (scale * np.cosh(v)) ** k

    def outer(v: Array) -> Array:
        root = scale * np.cosh(v)
        t = np.hypot(b, root)
        return slope(t, root) * root / t * sinh_over(v) ** k

    cube = integral(lambda x: inner(first * x**3) * 3.0 * x * x, np.ones_like(stop), NODES)
    below = first * cube + _rest(inner, first, stop)
    near = raised(first, k) * weighted(outer, first, k)
    beyond = scale**k * (near + _rest(lambda v: outer(v) * v**k, first, stop))
    return np.where(a > np.maximum(r, b), np.where(within, below, beyond), 0.0)
