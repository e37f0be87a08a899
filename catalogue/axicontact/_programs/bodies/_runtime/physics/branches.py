"""Bodies of axicontact._runtime.physics.branches over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.functions import halves
from ....._runtime.plain import MATH as np


def exponent_of(x):
    """The whole m with 2**m <= x < 2**(m + 1)."""
    return np.frexp(x)[1] - 1


def stress_at(unit, H, k):
    """The exponent of the power of two near H L**k for L = 2**unit, and H in units of that stress and of L."""
    mantissa, exponent = np.frexp(H)
    high, low = halves(k)
    whole = np.floor(unit * high + 0.5)
    return (exponent + exponent_of(np.exp2(whole)), mantissa * np.exp2(unit * high - whole + unit * low))
