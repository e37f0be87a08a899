"""Bodies of axicontact.graded.normal.flat_punch over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.punch import punch_displacement


def _displacement(r, d, a, k):
    return d * punch_displacement(r, a, k)
