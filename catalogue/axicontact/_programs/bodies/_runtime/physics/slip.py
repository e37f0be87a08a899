"""Bodies of axicontact._runtime.physics.slip over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.integrals import difference_root
from ....._runtime.physics.slip import DECAY, LONGEST, NODES, WAVES
from ....._runtime.plain import in_groups, integral, integral_in_strip
from ....._runtime.plain import MATH as np


def log_ratio(a, c):
    """ln(a/c) for c <= a."""
    return np.log1p((a - c) / c) if a > c else 0.0


def gained_share(c, a, n):
    """1 - (c/a)**n."""
    return -np.expm1(-n * log_ratio(a, c))


def root_gain(r, c, a):
    """sqrt(a**2 - r**2) - sqrt(c**2 - r**2) for r <= c <= a."""
    return (a - c) * (a + c) / (difference_root(a, r) + difference_root(c, r)) if a > c else 0.0


def arc_gain(r, c, a):
    """Integral of 1/sqrt(t**2 - r**2) from c to a."""
    return np.log1p((a - c + root_gain(r, c, a)) / (c + difference_root(c, r)))


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
    """2 s/sqrt(1 - exp(-2 s**2)), sqrt(2) at s = 0."""
    return 2.0 * s / np.sqrt(-np.expm1(-2.0 * s * s)) if s > 0.0 else np.sqrt(2.0)


def stick_force(F, F_x, mu):
    """The normal force of the stick zone, F - F_x/mu; NaN beyond full slip."""
    rest = F - F_x / mu
    rest = 0.0 if np.abs(rest) <= 2e-16 * F else rest
    return rest if rest >= 0.0 else np.nan


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
    """outer - inner, their squares being a**2 and c**2 less the same number."""
    return (a - c) * (a + c) / (outer + inner) if a > c else 0.0
