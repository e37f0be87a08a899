"""Bodies of axicontact._runtime.physics.slip over plain numbers: the same text with `math` for NumPy."""

from __future__ import annotations


from ....._runtime.physics.slip import Array
from ....._runtime.plain import MATH as np


def stick_force(F: Array, F_x: Array, mu: Array) -> Array:
    """The normal force of the stick zone, F - F_x/mu; NaN beyond full slip."""
    rest = F - F_x / mu
    rest = np.where(np.abs(rest) <= 2e-16 * F, 0.0, rest)
    return np.where(rest >= 0.0, rest, np.nan)
