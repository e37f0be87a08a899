"""Bodies of axicontact.normal.rounded_cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.shapes.across import inverse_beyond
from ...._runtime.plain import MATH as np


def _slope(t, theta, b):
    """Rate g'(t) of the indentation depth g(t)."""
    return 2 * np.tan(theta) / b * t


def _slope_beyond(t, root, theta, b):
    """Rate g'(t) of the indentation depth g(t) for t > b."""
    angle = np.arctan(root / b)
    return np.tan(theta) * (angle + 2 * b / (root + t))


def _depth_beyond(a, root, theta, b):
    angle = np.arctan(root / b)
    return np.tan(theta) * a * (angle + b / (root + a))


def _depth(a, theta, b):
    tip = np.tan(theta) / b * a ** 2
    root = np.sqrt((a - b) * (a + b))
    angle = np.arctan(root / b)
    beyond = np.tan(theta) * a * (angle + b / (root + a))
    return tip if a < b else beyond


def _force_beyond(a, root, theta, b, E_star):
    angle = np.arctan(root / b)
    return E_star * np.tan(theta) * (a ** 2 * angle + 4 * b * a ** 2 / (3 * (root + a)) + b / 3 * root)


def _force(a, theta, b, E_star):
    tip = 4 * E_star * np.tan(theta) / (3 * b) * a ** 3
    root = np.sqrt((a - b) * (a + b))
    angle = np.arctan(root / b)
    beyond = E_star * np.tan(theta) * (a ** 2 * angle + 4 * b * a ** 2 / (3 * (root + a)) + b / 3 * root)
    return tip if a < b else beyond


def _radius_from_depth(d, theta, b):

    def curve(a, root):
        rate = a * _slope_beyond(a, root, theta, b)
        return (_depth_beyond(a, root, theta, b), rate)
    return inverse_beyond(curve, d, b, 2.0, powers=(2.0, 1.0))


def _radius_from_force(F, theta, b, E_star):

    def curve(a, root):
        rate = 2 * E_star * a ** 2 * _slope_beyond(a, root, theta, b)
        return (_force_beyond(a, root, theta, b, E_star), rate)
    return inverse_beyond(curve, F, b, 3.0, powers=(2.0, 2.0))


def _force_from_depth(d, theta, b, E_star):
    a = _radius_from_depth(d, theta, b)
    change = 2 * E_star * a * (d - _depth(a, theta, b)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force(a, theta, b, E_star) + change


def _depth_from_force(F, theta, b, E_star):
    a = _radius_from_force(F, theta, b, E_star)
    change = (F - _force(a, theta, b, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth(a, theta, b) + change
