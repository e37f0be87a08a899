"""Bodies of axicontact.plane.rounded_punch over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.inverse import inverse
from ...._programs.bodies._runtime.physics.plane import load_beyond
from ...._runtime.plain import MATH as np


def _growth_beyond(t, root, R, b):
    """Growth P'(t)/E_star of the line load for t > b."""
    angle = np.arctan(root / b)
    return t * angle / R


def _load_at(root, R, b, E_star):
    """Line load at a = sqrt(b**2 + root**2)."""
    return E_star * load_beyond(_growth_beyond, (R, b), root, b)


def _half_width_from_load(P, R, b, E_star):

    def curve(t):
        a, root = (b * np.sqrt(1.0 + t * t), b * t)
        value = _load_at(root, R, b, E_star)
        return (value, E_star * root * root / a * _growth_beyond(a, root, R, b) / value)
    t = inverse(curve, P, np.ones_like(P), (2.0, 3.0))
    return b * np.sqrt(1.0 + t * t)
