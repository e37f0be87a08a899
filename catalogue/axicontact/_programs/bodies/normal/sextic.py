"""Bodies of axicontact.normal.sextic over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.functions import nth_root


def _depth(a, A):
    return 16 * A / 5 * a ** 6


def _force(a, A, E_star):
    return 192 * E_star * A / 35 * a ** 7


def _radius_from_depth(d, A):
    return nth_root(5 * d / (16 * A), 6)


def _radius_from_force(F, A, E_star):
    return nth_root(35 * F / (192 * E_star * A), 7)


def _force_from_depth(d, A, E_star):
    return 6 * E_star / 7 * d * nth_root(20 * d / A, 6)
