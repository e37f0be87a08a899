"""Bodies of axicontact.normal.flat_punch over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations




def _force(d, a, E_star):
    return 2.0 * E_star * d * a
