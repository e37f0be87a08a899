"""Bodies of axicontact._runtime.shapes.powers over plain numbers: the same text with `math` for NumPy."""

from __future__ import annotations


from ....._runtime.plain import at_many_radii, integral_by_length
from ....._runtime.shapes.powers import Array, Course, LENGTHS, STEEP, _DECAY
from ....._runtime.plain import MATH as np


def of_pressure(a: float, n: float) -> tuple[Course | None, float, float]:
    """Up to the axis, for powers that panels resolve."""
    return (Course(0.0, a * a, True, a) if n < STEEP else None), 0.0, a


@at_many_radii(of_pressure)
def power_pressure(r: Array, a: Array, n: Array) -> Array:
    """Integral of t**(n - 1)/sqrt(t**2 - r**2) dt from r to a, over a**(n - 1)."""
    centre = np.where(n > 1.0, 1.0 / np.abs(n - 1.0), np.inf)
    largest = np.where(n > 1.0, 1.0, (r / a) ** n * (a / r))
    return np.where(r > 0.0, largest * _fallen_pressure(_log_ratio(a, r), n), centre)


def _fallen_pressure(depth: Array, n: Array) -> Array:
    """The same over the larger end of t**(n - 1), for r = a exp(-depth)."""
    steep, rate = n > 1.0, np.abs(n - 1.0)
    cut = np.maximum(depth - _DECAY / np.maximum(rate, 1e-3), 0.0)
    stop = np.sqrt(depth)

    def integrand(step: Array) -> Array:
        # counted from the end where the power is largest, so that the difference to it is exact
        fall = np.where(steep, step * (2.0 * stop - step), step * step)
        return np.exp(-rate * fall) * _weight(np.where(steep, np.maximum(stop - step, 0.0), step))

    reach = np.where(steep, stop - np.sqrt(cut), np.sqrt(depth - cut))
    # at the edge, where nothing is left of the path, the weight has but a limit
    return np.where(depth > 0.0, integral_by_length(integrand, reach, lengths=LENGTHS), 0.0)


def _weight(s: Array) -> Array:
    """2 s/sqrt(1 - exp(-2 s**2)), for s > 0."""
    return 2.0 * s / np.sqrt(-np.expm1(-2.0 * s * s))


def _log_ratio(x: Array, y: Array) -> Array:
    """ln(x/y) for x >= y; the quotient overflows where y is subnormal."""
    excess = (x - y) / y
    return np.where(np.isfinite(excess), np.log1p(excess), np.log(x) - np.log(y))
