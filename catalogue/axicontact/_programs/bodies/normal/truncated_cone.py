"""Bodies of axicontact.normal.truncated_cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan, tan

from ...._programs.bodies._runtime.inverse import between, inverse
from ...._runtime.plain import sqrt, MATH as np


def _slope_beyond(t, root, theta, b):
    v6 = tan(theta)
    return v6 * atan(root / b) + b * v6 / root


def _depth_at(a, root, theta, b):
    return tan(theta) * a * atan(root / b)


def _force_at(a, root, theta, b, E_star):
    return E_star * tan(theta) * (a * a * atan(root / b) + b * root)


def _force(a, theta, b, E_star):
    v7 = sqrt((a - b) * (a + b))
    return E_star * tan(theta) * (a * a * atan(v7 / b) + b * v7)


def _contact_from_depth(d, theta, b):
    """Contact radius a and its root sqrt(a**2 - b**2)."""

    def curve(t):
        a, root = (b * np.sqrt(1.0 + t * t), b * t)
        value = _depth_at(a, root, theta, b)
        return (value, root * root / a * _slope_beyond(a, root, theta, b) / value)
    rest = (1.587574, -0.008072401, -0.4352508, -3.570796, 8.66489, -8.150206, 3.403791, -0.4812051)
    start = between(np.log(d / curve(1.0)[0]), (0.9003, 1.0), (1.414, 1.0), -6.0, rest)
    t = inverse(curve, d, start, (1.0, 2.0), smooth=True)
    return (b * np.sqrt(1.0 + t * t), b * t)


def _radius_from_depth(d, theta, b):
    return _contact_from_depth(d, theta, b)[0]


def _contact_from_force(F, theta, b, E_star):
    """Contact radius a and its root sqrt(a**2 - b**2)."""

    def curve(t):
        a, root = (b * np.sqrt(1.0 + t * t), b * t)
        value = _force_at(a, root, theta, b, E_star)
        return (value, 2 * E_star * root * root * _slope_beyond(a, root, theta, b) / value)
    rest = (0.9995205, 0.100541, -0.3986471, 4.536442, -19.76727, 34.2219, -25.89697, 7.204481)
    start = between(np.log(F / curve(1.0)[0]), (0.778, 1.0), (0.611, 2.0), -2.75, rest)
    t = inverse(curve, F, start, (1.0, 2.0), smooth=True)
    return (b * np.sqrt(1.0 + t * t), b * t)


def _radius_from_force(F, theta, b, E_star):
    return _contact_from_force(F, theta, b, E_star)[0]


def _force_from_depth(d, theta, b, E_star):
    a, root = _contact_from_depth(d, theta, b)
    change = 2 * E_star * a * (d - _depth_at(a, root, theta, b)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force_at(a, root, theta, b, E_star) + change


def _depth_from_force(F, theta, b, E_star):
    a, root = _contact_from_force(F, theta, b, E_star)
    change = (F - _force_at(a, root, theta, b, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth_at(a, root, theta, b) + change
