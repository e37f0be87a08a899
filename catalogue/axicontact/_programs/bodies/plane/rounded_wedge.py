"""Bodies of axicontact.plane.rounded_wedge over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan, tan

from ...._programs.bodies._runtime.inverse import inverse
from ...._runtime.plain import sqrt, MATH as np


def _growth(t, theta, b):
    return 3.141592653589793 * tan(theta) / (2.0 * b) * t


def _growth_beyond(t, root, theta, b):
    return tan(theta) / b * t * atan(b / root)


def _load(a, theta, b, E_star):
    v6 = tan(theta)
    v12 = a * a
    if a < b:
        return 3.141592653589793 * E_star * v6 / (4.0 * b) * v12
    v17 = sqrt((a - b) * (a + b))
    return E_star * v6 * (v17 + v12 * atan(b / v17) / b) / 2.0


def _half_width_from_load(P, theta, b, E_star):

    def curve(a):
        root = np.sqrt((a - b) * (a + b))
        growth = _growth(a, theta, b) if a < b else _growth_beyond(a, root, theta, b)
        value = _load(a, theta, b, E_star)
        return (value, E_star * a * growth / value)
    return inverse(curve, P, np.full_like(P, 0.99 * b), (1.0, 2.0))
