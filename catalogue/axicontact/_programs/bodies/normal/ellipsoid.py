"""Bodies of axicontact.normal.ellipsoid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.inverse import between, inverse
from ...._programs.bodies._runtime.shapes.arcs import arc_strips
from ...._programs.bodies._runtime.special import tanh_gap
from ...._runtime.plain import MATH as np


def _slope(t, root, h, b):
    """Rate g'(t) of the indentation depth g(t)."""
    angle = np.arcsinh(t / root)
    return h / b * angle + h * t / root ** 2


def _depth_at(a, root, h, b):
    angle = np.arcsinh(a / root)
    return h / b * a * angle


def _depth(a, h, b):
    angle = np.log1p(2 * a / (b - a)) / 2
    return h / b * a * angle


def _force_at(a, root, h, b, E_star):
    angle = np.arcsinh(a / root)
    return E_star * h * (b * tanh_gap(angle, np.tanh(angle)) + a ** 2 * angle / b)


def _force(a, h, b, E_star):
    angle = np.log1p(2 * a / (b - a)) / 2
    return E_star * h * (a ** 2 * angle / b + b * tanh_gap(angle, a / b))


def _pressure(r, a, h, b, E_star):
    root_br = np.sqrt((b - r) * (r + b))
    root = np.sqrt((a - r) * (a + r))
    root_ba = np.sqrt((b - a) * (a + b))
    pressed = E_star * h / np.pi * (np.arcsinh(root / root_ba) / root_br + arc_strips(r, a, b) / b)
    inside = pressed if r < a else 0.0
    return inside if a <= b else np.nan


def _contact_from_depth(d, h, b):
    """Contact radius a and its root sqrt(b**2 - a**2)."""

    def curve(t):
        a, root = (b * np.tanh(t), b / np.cosh(t))
        value = _depth_at(a, root, h, b)
        return (value, t * root * root / b * _slope(a, root, h, b) / value)
    rest = (0.9983865, 0.208363, -4.0282, 30.18372, -93.92268, 137.5431, -95.06062, 25.07439)
    start = between(np.log(d / curve(1.0)[0]), (1.313, 2.0), (1.313, 1.0), 3.75, rest)
    t = inverse(curve, d, start, (1.0, 2.0), smooth=True)
    return (b * np.tanh(t), b / np.cosh(t))


def _radius_from_depth(d, h, b):
    return _contact_from_depth(d, h, b)[0]


def _contact_from_force(F, h, b, E_star):
    """Contact radius a and its root sqrt(b**2 - a**2)."""

    def curve(t):
        a, root = (b * np.tanh(t), b / np.cosh(t))
        value = _force_at(a, root, h, b, E_star)
        return (value, 2 * E_star * a * t * root * root / b * _slope(a, root, h, b) / value)
    rest = (0.998775, 0.1558039, -2.915358, 22.20415, -66.84601, 91.96521, -58.34092, 13.75711)
    start = between(np.log(F / curve(1.0)[0]), (1.629, 3.0), (2.405, 1.0), 1.75, rest)
    t = inverse(curve, F, start, (1.0, 3.0), smooth=True)
    return (b * np.tanh(t), b / np.cosh(t))


def _radius_from_force(F, h, b, E_star):
    return _contact_from_force(F, h, b, E_star)[0]


def _force_from_depth(d, h, b, E_star):
    a, root = _contact_from_depth(d, h, b)
    change = 2 * E_star * a * (d - _depth_at(a, root, h, b)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force_at(a, root, h, b, E_star) + change


def _depth_from_force(F, h, b, E_star):
    a, root = _contact_from_force(F, h, b, E_star)
    change = (F - _force_at(a, root, h, b, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth_at(a, root, h, b) + change
