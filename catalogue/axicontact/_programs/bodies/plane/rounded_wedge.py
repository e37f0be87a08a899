"""Bodies of axicontact.plane.rounded_wedge over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.inverse import inverse
from ...._runtime.plain import MATH as np


def _growth(t, theta, b):
    """Growth P'(t)/E_star of the line load."""
    return np.pi * np.tan(theta) / (2 * b) * t


def _growth_beyond(t, root, theta, b):
    """Growth P'(t)/E_star of the line load for t > b."""
    angle = np.arctan(b / root)
    return np.tan(theta) / b * t * angle


def _load(a, theta, b, E_star):
    below = np.pi * E_star * np.tan(theta) / (4 * b) * a ** 2
    root = np.sqrt((a - b) * (a + b))
    angle = np.arctan(b / root)
    above = E_star * np.tan(theta) * (root + a ** 2 * angle / b) / 2
    return below if a < b else above


def _half_width_from_load(P, theta, b, E_star):

    def curve(a):
        root = np.sqrt((a - b) * (a + b))
        growth = _growth(a, theta, b) if a < b else _growth_beyond(a, root, theta, b)
        value = _load(a, theta, b, E_star)
        return (value, E_star * a * growth / value)
    return inverse(curve, P, np.full_like(P, b), (1.0, 2.0))
