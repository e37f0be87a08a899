"""The strips of an arc by their rule alone, which needs no table."""

from __future__ import annotations

import numpy as np

from ..interface import Array
from ..rules import pressure_integral_tanh


def arc_strips(r: Array, a: Array, R: Array) -> Array:
    """Integral of artanh(t/R)/sqrt(t**2 - r**2) from r to a <= R, for r < a."""
    return pressure_integral_tanh(_arc_rate, (), r, a, R)


def _arc_rate(t: Array, root: Array) -> Array:
    return np.arcsinh(t / root)
