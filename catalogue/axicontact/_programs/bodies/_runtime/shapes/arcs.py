"""Bodies of axicontact._runtime.shapes.arcs over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh

from ....._programs.bodies._runtime.integrals import difference_root
from ....._programs.bodies._runtime.rules import pressure_integral_tanh
from ....._runtime.shapes.arcs import LEGENDRE_CHI
from ....._runtime.plain import MATH as np

END = 0.7


def arc_strips(r, a, R):
    """Integral of artanh(t/R)/sqrt(t**2 - r**2) from r to a <= R, for r < a.

    It is chi(high) - chi(low) with low high = (r/(R + sqrt(R**2 - r**2)))**2 and chi(x) = x + x**3/9 + x**5/25 + ...;
    with chi(x) = x P(x**2) the difference quotient of P is summed along with P, so that nothing is subtracted.
    """
    reach, below = (difference_root(a, r), R + difference_root(R, r))
    high = (a + reach) / below
    low = r * (r / (a + reach)) / below
    upper, lower = (high * high, low * low)
    value, quotient = (LEGENDRE_CHI[0][-1], 0.0)
    for coefficient in LEGENDRE_CHI[0][-2::-1]:
        quotient = quotient * lower + value
        value = value * upper + coefficient
    near = 2.0 * reach / below * (value + low * (low + high) * quotient)
    beyond = high > END
    if not np.any(beyond):
        return near
    return pressure_integral_tanh(_arc_rate, (), r, a, R) if beyond else near


def _arc_rate(t, root):
    return asinh(t / root)
