"""Bodies of axicontact.graded.normal.flat_punch over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.punch import punch_displacement
from .....graded.normal.flat_punch import Array


def _displacement(r: Array, d: Array, a: Array, k: Array) -> Array:
    return d * punch_displacement(r, a, k)
