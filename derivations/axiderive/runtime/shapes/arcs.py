"""Circular and elliptic arcs: the part of the pressure that is a difference of dilogarithms, and the greatest pressure.

With a = R tanh(y), the level (y tanh(y) - 1)/cosh(y)**2 rises up to y = 1.71792 and falls beyond, to zero.  There the
ring of greatest pressure has left the axis: r_max/a is sqrt(1 - (sinh(v)/sinh(y))**2) with v < y of the same level.
"""

from __future__ import annotations

import numpy as np

from ..functions import rational
from ..integrals import difference_root
from ..interface import Array
from ..kernels import ARC_BEND, ARC_END, ARC_FAR, ARC_NEAR, ARC_PEAK, LEGENDRE_CHI
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


def arc_peak_radius(a: Array, R: Array) -> Array:
    """r_max for a <= R."""
    y, root = _angle(a, R)
    share = np.sinh(_lower_angle(y)) * root / a
    return np.where(y > ARC_PEAK, a * np.sqrt((1.0 - share) * (1.0 + share)), 0.0)


def arc_peak_pressure(a: Array, R: Array) -> Array:
    """pi/E* times the greatest pressure under R - sqrt(R**2 - r**2), a <= R."""
    y, root = _angle(a, R)
    v = _lower_angle(y)
    strips = arc_strips(arc_peak_radius(a, R), a, R)
    return R * v / (root * np.cosh(v)) + np.where((a > 0.0) & (a < R), strips, 0.0)


def _angle(a: Array, R: Array) -> tuple[Array, Array]:
    """artanh(a/R), of which beyond 40 nothing is asked, and sqrt(R**2 - a**2)."""
    root = difference_root(R, a)
    return np.minimum(np.arcsinh(a / root), 40.0), root


def _lower_angle(y: Array) -> Array:
    """The other angle of the same level; y itself up to the peak."""
    beyond = np.maximum(y - ARC_PEAK, 0.0)
    near = np.minimum(beyond, ARC_END)
    short = np.maximum(ARC_BEND - (y * np.tanh(y) - 1.0) / np.cosh(y) ** 2, 0.0)
    return np.where(beyond > ARC_END, rational(short, *ARC_FAR), y - near * rational(near, *ARC_NEAR))
