"""Bodies of axicontact._runtime.shapes.powers over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.integrals import of_displacement
from ....._runtime.plain import at_many_radii, integral, integral_by_length
from ....._runtime.shapes.powers import Course, LENGTHS, NODES, STEEP, _DECAY
from ....._runtime.plain import MATH as np


def of_pressure(a, n):
    """Up to the axis, for powers that panels resolve."""
    return (Course(0.0, a * a, True, a) if n < STEEP else None, 0.0, a)


@at_many_radii(of_pressure)
def power_pressure(r, a, n):
    """Integral of t**(n - 1)/sqrt(t**2 - r**2) dt from r to a, over a**(n - 1)."""
    centre = 1.0 / np.abs(n - 1.0) if n > 1.0 else np.inf
    largest = 1.0 if n > 1.0 else (r / a) ** n * (a / r)
    return largest * _fallen_pressure(_log_ratio(a, r), n) if r > 0.0 else centre


def _fallen_pressure(depth, n):
    """The same over the larger end of t**(n - 1), for r = a exp(-depth)."""
    steep, rate = (n > 1.0, np.abs(n - 1.0))
    cut = np.maximum(depth - _DECAY / np.maximum(rate, 0.001), 0.0)
    stop = np.sqrt(depth)

    def integrand(step):
        fall = step * (2.0 * stop - step) if steep else step * step
        return np.exp(-rate * fall) * _weight(np.maximum(stop - step, 0.0) if steep else step)
    reach = stop - np.sqrt(cut) if steep else np.sqrt(depth - cut)
    return integral_by_length(integrand, reach, lengths=LENGTHS) if depth > 0.0 else 0.0


@at_many_radii(of_displacement)
def power_displacement(r, a, n):
    """Integral of n t**(n - 1) arcsin(t/r) dt from 0 to a < r, over a**n."""
    start, reach = _span(r, a, n)

    def integrand(step):
        s = start + step
        fall = step * (2.0 * start + step)
        ratio = a / r * np.exp(-fall)
        return np.arctan2(ratio, np.sqrt(-np.expm1(-2.0 * s * s))) * np.exp(-n * fall) * 2.0 * s
    return n * integral(integrand, reach, NODES) if a > 0.0 else 0.0


def _weight(s):
    """2 s/sqrt(1 - exp(-2 s**2)), for s > 0."""
    return 2.0 * s / np.sqrt(-np.expm1(-2.0 * s * s))


def _log_ratio(x, y):
    """ln(x/y) for x >= y; the quotient overflows where y is subnormal."""
    excess = (x - y) / y
    return np.log1p(excess) if np.isfinite(excess) else np.log(x) - np.log(y)


def _span(r, a, n):
    start = np.sqrt(_log_ratio(r, a))
    fall = _DECAY / (n + 1.0)
    return (start, fall / (np.sqrt(start * start + fall) + start))
