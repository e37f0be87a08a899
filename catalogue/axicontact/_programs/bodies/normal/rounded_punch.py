"""Bodies of axicontact.normal.rounded_punch over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.inverse import between, inverse
from ...._programs.bodies._runtime.special import arctan_gap, root_gap
from ...._runtime.plain import MATH as np


def _slope_beyond(t, root, R, b):
    """Rate g'(t) of the indentation depth g(t) for t > b."""
    angle = np.arctan2(root, b)
    return 2 * root / R - b / R * angle


def _depth_at(a, root, R, b):
    return b / R * a * arctan_gap(root / b)


def _depth(a, R, b):
    return b / R * a * root_gap(a, b)


def _force_at(a, root, R, b, E_star):
    return E_star / R * (root ** 3 / 3 + b * a ** 2 * arctan_gap(root / b))


def _force(a, R, b, E_star):
    root = np.sqrt((a - b) * (a + b))
    return E_star / R * (b * a ** 2 * root_gap(a, b) + (a - b) * (a + b) * root / 3)


def _contact_from_depth(d, R, b):
    """Contact radius a and its root sqrt(a**2 - b**2)."""

    def curve(t):
        a, root = (b * np.sqrt(1.0 + t * t), b * t)
        value = _depth_at(a, root, R, b)
        return (value, root * root / a * _slope_beyond(a, root, R, b) / value)
    rest = (0.9999152, -0.002147146, -0.02265958, -0.0720644, 0.3108858, -0.6900221, 1.077435, -0.6001833)
    start = between(np.log(d / curve(1.0)[0]), (1.098, 3.0), (3.295, 2.0), 3.5, rest)
    t = inverse(curve, d, start, (2.0, 4.0), smooth=True)
    return (b * np.sqrt(1.0 + t * t), b * t)


def _radius_from_depth(d, R, b):
    return _contact_from_depth(d, R, b)[0]


def _contact_from_force(F, R, b, E_star):
    """Contact radius a and its root sqrt(a**2 - b**2)."""

    def curve(t):
        a, root = (b * np.sqrt(1.0 + t * t), b * t)
        value = _force_at(a, root, R, b, E_star)
        return (value, 2 * E_star * root * root * _slope_beyond(a, root, R, b) / value)
    rest = (0.9634905, 0.003191853, -0.1218583, 0.3231377, -1.571447, 2.059576, -1.105184, 0.2138332)
    start = between(np.log(F / curve(1.0)[0]), (0.8743, 3.0), (1.749, 3.0), 6.0, rest)
    t = inverse(curve, F, start, (3.0, 4.0), smooth=True)
    return (b * np.sqrt(1.0 + t * t), b * t)


def _radius_from_force(F, R, b, E_star):
    return _contact_from_force(F, R, b, E_star)[0]


def _force_from_depth(d, R, b, E_star):
    a, root = _contact_from_depth(d, R, b)
    change = 2 * E_star * a * (d - _depth_at(a, root, R, b)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force_at(a, root, R, b, E_star) + change


def _depth_from_force(F, R, b, E_star):
    a, root = _contact_from_force(F, R, b, E_star)
    change = (F - _force_at(a, root, R, b, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth_at(a, root, R, b) + change
