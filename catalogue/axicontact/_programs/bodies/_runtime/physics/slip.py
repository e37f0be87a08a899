"""Bodies of axicontact._runtime.physics.slip over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import expm1, nan

from ....._programs.bodies._runtime.integrals import difference_root
from ....._runtime.plain import in_groups, integral, integral_in_strip
from ....._runtime.plain import log1p, sqrt, MATH as np

DECAY = 42.0
LONGEST = 256.0
NODES = 64
WAVES = ((0.25, 8,), (1.97, 16,), (4.7, 24,), (7.96, 32,), (23.3, 64,),)


def log_ratio(a, c):
    if a > c:
        return log1p((a - c) / c)
    return 0.0


def gained_share(c, a, n):
    return -expm1(-n * (log1p((a - c) / c) if a > c else 0.0))


def arc_gain(r, c, a):
    v3 = a - c
    v13 = c - r
    v17 = sqrt((v13 if v13 > 0.0 or v13 != v13 else 0.0) * (c + r))
    if a > c:
        v7 = a - r
        v20 = v3 * (a + c) / (sqrt((v7 if v7 > 0.0 or v7 != v7 else 0.0) * (a + r)) + v17)
    else:
        v20 = 0.0
    return log1p((v3 + v20) / (c + v17))


def power_gain(r, c, a, n):
    """Integral of t**(n - 1)/sqrt(t**2 - r**2) from c to a, over a**(n - 1), for r < c.

    In s with t = r exp(s**2) every integrand is smooth; its nearest singularity is at abs(s) = sqrt(pi).
    """
    growth, depth = (log_ratio(a, c), log_ratio(a, r))
    outer, inner = (np.sqrt(depth), np.sqrt(log_ratio(c, r)))
    steep, rate = (n > 1.0, np.abs(n - 1.0))
    end = DECAY / np.maximum(rate, 0.001)
    start = outer if steep else inner
    side = 1.0 - 2.0 * steep
    cut = np.sqrt(np.maximum(start * start + side * end, 0.0))
    reach = end / (start + cut) if growth > end else growth / (outer + inner)

    def integrand(step):
        fall = step * (2.0 * start + side * step)
        return np.exp(-rate * fall) * _weight(np.maximum(start + side * step, 0.0))
    largest = 1.0 if steep else (c / a) ** n * (a / c)
    within = integral(integrand, reach, NODES) if reach > 0.0 else 0.0
    centre = -np.expm1(-rate * growth) / (rate if rate > 0.0 else 1.0)
    return largest * (within if r > 0.0 else centre) if rate > 0.0 else arc_gain(r, c, a)


def _weight(s):
    if s > 0.0:
        return 2.0 * s / sqrt(-expm1(-2.0 * s * s))
    return 1.4142135623730951


def stick_force(F, F_x, mu):
    v4 = F - F_x / mu
    v10 = 0.0 if abs(v4) <= 2e-16 * F else v4
    if v10 >= 0.0:
        return v10
    return nan


@in_groups
def growth_beyond(slope, order, r, c, a, b, close):
    """From max(b, c) on; `slope` takes t and sqrt(t**2 - b**2)."""
    start = np.maximum(b, c)
    beyond, root = (difference_root(start, b), difference_root(start, r))
    gaps = _gap(a, start, difference_root(a, b), beyond) + _gap(a, start, difference_root(a, r), root)
    holds = close & (a > start)

    def integrand(v):
        side = beyond * np.cosh(v) + root * np.sinh(v)
        t = np.sqrt(b * b + side * side)
        return slope(t, side) * (side / t) * t ** order
    return (integrand, np.log1p(gaps / (beyond + root)) if holds else 0.0, 1.0, holds, 0.0)


@in_groups
def growth_below(slope, order, r, c, a, R, close):
    """For g' singular at t = R; `slope` takes t and sqrt(R**2 - t**2)."""
    scale, root, below = (difference_root(R, r), difference_root(c, r), difference_root(R, c))
    outer, last = (difference_root(a, r), difference_root(R, a))
    ratio = 2.0 * scale * _gap(a, c, outer, root) / last * ((scale + outer) / (scale + root)) / last
    holds = close & (a > c)

    def integrand(v):
        even, odd = (np.cosh(v), np.sinh(v))
        secant = scale * even + root * odd
        u, side = (scale * (root * even + scale * odd) / secant, scale * below / secant)
        t = np.sqrt(r * r + u * u)
        return slope(t, side) * (side / scale) * (side / t) * t ** order
    return (integrand, 0.5 * np.log1p(ratio) if holds else 0.0, 1.0, holds, 0.0)


def growth_waves(slope, parameters, order, r, c, a, wavelength, close):
    """For g' that oscillates with a wavelength."""
    root = difference_root(c, r)
    gap = _gap(a, c, difference_root(a, r), root)
    holds = close & (a > c) & (gap < LONGEST * wavelength)

    def integrand(u):
        t = np.sqrt(r * r + (root + u) ** 2)
        return slope(t, *parameters) * t ** (order - 1)
    return integral_in_strip(integrand, gap if holds else 0.0, wavelength, WAVES)


def _gap(a, c, outer, inner):
    if a > c:
        return (a - c) * (a + c) / (outer + inner)
    return 0.0
