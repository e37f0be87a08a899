"""Bodies of axicontact.normal.rounded_curved_punch over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.shapes.across import inverse_beyond
from ...._programs.bodies._runtime.special import arctan_gap, root_gap
from ...._runtime.plain import MATH as np


def _slope(t, R1):
    """Rate g'(t) of the indentation depth g(t)."""
    return 2 * t / R1


def _slope_beyond(t, root, R1, R2, b):
    """Rate g'(t) of the indentation depth g(t) for t > b."""
    angle = np.arctan2(root, b)
    return 2 * t / R1 + 2 * root / R2 - b / R2 * angle


def _depth_beyond(a, root, R1, R2, b):
    return a * (a / R1 + b / R2 * arctan_gap(root / b))


def _depth(a, R1, R2, b):
    tip = a ** 2 / R1
    beyond = a * (a / R1 + b / R2 * root_gap(a, b))
    return tip if a < b else beyond


def _force_beyond(a, root, R1, R2, b, E_star):
    return E_star * (4 * a ** 3 / (3 * R1) + root ** 3 / (3 * R2) + b / R2 * a ** 2 * arctan_gap(root / b))


def _force(a, R1, R2, b, E_star):
    tip = 4 * E_star / (3 * R1) * a ** 3
    root = np.sqrt((a - b) * (a + b))
    plus = 4 * a ** 3 / (3 * R1) + b / R2 * a ** 2 * root_gap(a, b) + (a - b) * (a + b) * root / (3 * R2)
    beyond = E_star * plus
    return tip if a < b else beyond


def _radius_from_depth(d, R1, R2, b):

    def curve(a, root):
        rate = a * _slope_beyond(a, root, R1, R2, b)
        return (_depth_beyond(a, root, R1, R2, b), rate)
    return inverse_beyond(curve, d, b, 2.0, leaving=(3.0, 2.0))


def _radius_from_force(F, R1, R2, b, E_star):

    def curve(a, root):
        rate = 2 * E_star * a ** 2 * _slope_beyond(a, root, R1, R2, b)
        return (_force_beyond(a, root, R1, R2, b, E_star), rate)
    return inverse_beyond(curve, F, b, 3.0, leaving=(3.0, 3.0))


def _force_from_depth(d, R1, R2, b, E_star):
    a = _radius_from_depth(d, R1, R2, b)
    change = 2 * E_star * a * (d - _depth(a, R1, R2, b)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force(a, R1, R2, b, E_star) + change


def _depth_from_force(F, R1, R2, b, E_star):
    a = _radius_from_force(F, R1, R2, b, E_star)
    change = (F - _force(a, R1, R2, b, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth(a, R1, R2, b) + change
