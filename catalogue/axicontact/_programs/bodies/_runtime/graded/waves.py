"""Bodies of axicontact._runtime.graded.waves over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._runtime.graded.waves import Array, _steepest_waves
from ....._runtime.plain import MATH as np


def steepest_waves(k: Array) -> Array:
    """The least wavelength**2/(h R) at which g' of a paraboloid with waves of height h nowhere falls below zero."""
    return np.vectorize(_steepest_waves, otypes=[float])(k)
