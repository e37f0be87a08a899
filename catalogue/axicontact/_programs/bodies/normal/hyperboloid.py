"""Bodies of axicontact.normal.hyperboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.inverse import inverse
from ...._programs.bodies._runtime.special import arctan_gap
from ...._runtime.plain import MATH as np


def _slope(t, theta, b):
    """Rate g'(t) of the indentation depth g(t)."""
    angle = np.arctan(t / b)
    return np.tan(theta) * angle + b * np.tan(theta) * t / (t ** 2 + b ** 2)


def _depth(a, theta, b):
    angle = np.arctan(a / b)
    return np.tan(theta) * a * angle


def _force(a, theta, b, E_star):
    angle = np.arctan2(a, b)
    return E_star * np.tan(theta) * (a ** 2 * angle + b ** 2 * arctan_gap(a / b))


def _radius_from_depth(d, theta, b):

    def curve(a):
        value = _depth(a, theta, b)
        return (value, a * _slope(a, theta, b) / value)
    return inverse(curve, d, b / 1000 * np.ones_like(d), (1.0, 2.0), smooth=True)


def _radius_from_force(F, theta, b, E_star):

    def curve(a):
        value = _force(a, theta, b, E_star)
        return (value, 2 * E_star * a ** 2 * _slope(a, theta, b) / value)
    return inverse(curve, F, b / 1000 * np.ones_like(F), (2.0, 3.0), smooth=True)


def _force_from_depth(d, theta, b, E_star):
    a = _radius_from_depth(d, theta, b)
    change = 2 * E_star * a * (d - _depth(a, theta, b)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force(a, theta, b, E_star) + change


def _depth_from_force(F, theta, b, E_star):
    a = _radius_from_force(F, theta, b, E_star)
    change = (F - _force(a, theta, b, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth(a, theta, b) + change
