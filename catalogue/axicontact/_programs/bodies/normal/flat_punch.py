"""Bodies of axicontact.normal.flat_punch over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....normal.flat_punch import Array


def _force(d: Array, a: Array, E_star: Array) -> Array:
    return 2 * E_star * d * a
