"""Bodies of axicontact._runtime.graded.rules over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._runtime.graded.rules import Array
from ....._runtime.graded.single import weighted
from ....._runtime.plain import MATH as np


def raised(x: Array, k: Array) -> Array:
    """x**(1 + k), with no rounding of the exponent."""
    return x * x ** k if x > 0.0 else 0.0


def sine_integral(angle: Array, k: Array) -> Array:
    """Integral of sin(y)**k from 0 to `angle`, at most pi/2."""
    return raised(angle, k) * weighted(lambda y: sine_over(y) ** k, angle, k, 32)


def sine_over(y: Array) -> Array:
    """sin(y)/y."""
    return np.sin(y) / (y if y > 0.0 else 1.0) if y > 0.0 else 1.0


def sinh_over(v: Array) -> Array:
    """sinh(v)/v."""
    return np.sinh(v) / (v if v > 0.0 else 1.0) if v > 0.0 else 1.0
