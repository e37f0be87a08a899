"""Bodies of axicontact.normal.capped_paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.shapes.across import inverse_beyond
from ...._runtime.plain import MATH as np


def _slope(t, R1):
    """Rate g'(t) of the indentation depth g(t)."""
    return 2 * t / R1


def _slope_beyond(t, root, R1, R2, b):
    """Rate g'(t) of the indentation depth g(t) for t > b."""
    return 2 * t / R1 + 2 * (R1 - R2) / (R1 * R2) * root + b ** 2 * (R1 - R2) / (R1 * R2 * root)


def _depth_beyond(a, root, R1, R2):
    return a * (a + (R1 - R2) / R2 * root) / R1


def _depth(a, R1, R2, b):
    tip = a ** 2 / R1
    root = np.sqrt((a - b) * (a + b))
    beyond = a * (a + (R1 - R2) / R2 * root) / R1
    return tip if a < b else beyond


def _force_beyond(a, root, R1, R2, b, E_star):
    return 2 * E_star / (3 * R1) * (2 * a ** 3 + (R1 - R2) / R2 * (2 * a ** 2 + b ** 2) * root)


def _force(a, R1, R2, b, E_star):
    tip = 4 * E_star / (3 * R1) * a ** 3
    root = np.sqrt((a - b) * (a + b))
    beyond = 2 * E_star / (3 * R1) * (2 * a ** 3 + (R1 - R2) / R2 * (2 * a ** 2 + b ** 2) * root)
    return tip if a < b else beyond


def _radius_from_depth(d, R1, R2, b):

    def curve(a, root):
        rate = a * _slope_beyond(a, root, R1, R2, b)
        return (_depth_beyond(a, root, R1, R2), rate)
    return inverse_beyond(curve, d, b, 2.0, leaving=(1.0, 2.0))


def _radius_from_force(F, R1, R2, b, E_star):

    def curve(a, root):
        rate = 2 * E_star * a ** 2 * _slope_beyond(a, root, R1, R2, b)
        return (_force_beyond(a, root, R1, R2, b, E_star), rate)
    return inverse_beyond(curve, F, b, 3.0, leaving=(1.0, 3.0))


def _force_from_depth(d, R1, R2, b, E_star):
    a = _radius_from_depth(d, R1, R2, b)
    change = 2 * E_star * a * (d - _depth(a, R1, R2, b)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force(a, R1, R2, b, E_star) + change


def _depth_from_force(F, R1, R2, b, E_star):
    a = _radius_from_force(F, R1, R2, b, E_star)
    change = (F - _force(a, R1, R2, b, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth(a, R1, R2, b) + change
