"""The strips of a circular or elliptic arc: the part of its pressure that is a difference of dilogarithms."""

from __future__ import annotations

import numpy as np

from ..integrals import difference_root
from ..interface import Array
from ..kernels import LEGENDRE_CHI
from ..rules import pressure_integral_tanh

END = 0.7
"""Up to here Legendre's chi function has a kernel; beyond, the integral has its rule."""


def arc_strips(r: Array, a: Array, R: Array) -> Array:
    """Integral of artanh(t/R)/sqrt(t**2 - r**2) from r to a <= R, for r < a.

    It is chi(high) - chi(low) with low high = (r/(R + sqrt(R**2 - r**2)))**2 and chi(x) = x + x**3/9 + x**5/25 + ...;
    with chi(x) = x P(x**2) the difference quotient of P is summed along with P, so that nothing is subtracted.
    """
    reach, below = difference_root(a, r), R + difference_root(R, r)
    high = (a + reach) / below
    low = r * (r / (a + reach)) / below
    upper, lower = high * high, low * low
    value, quotient = LEGENDRE_CHI[0][-1], 0.0
    for coefficient in LEGENDRE_CHI[0][-2::-1]:
        quotient = quotient * lower + value
        value = value * upper + coefficient
    near = 2.0 * reach / below * (value + low * (low + high) * quotient)
    beyond = high > END
    if not np.any(beyond):
        return near
    return np.where(beyond, pressure_integral_tanh(_arc_rate, (), r, a, R), near)


def _arc_rate(t: Array, root: Array) -> Array:
    return np.arcsinh(t / root)
