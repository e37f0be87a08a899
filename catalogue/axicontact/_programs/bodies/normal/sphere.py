"""Bodies of axicontact.normal.sphere over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.inverse import between, inverse
from ...._programs.bodies._runtime.shapes.arcs import arc_strips
from ...._programs.bodies._runtime.special import tanh_gap
from ...._runtime.plain import MATH as np


def _slope(t, root, R):
    """Rate g'(t) of the indentation depth g(t)."""
    angle = np.arcsinh(t / root)
    return angle + R * t / root ** 2


def _depth_at(a, root):
    angle = np.arcsinh(a / root)
    return a * angle


def _depth(a, R):
    angle = np.log1p(2 * a / (R - a)) / 2
    return a * angle


def _force_at(a, root, R, E_star):
    angle = np.arcsinh(a / root)
    return E_star * (a ** 2 * angle + R ** 2 * tanh_gap(angle, np.tanh(angle)))


def _force(a, R, E_star):
    angle = np.log1p(2 * a / (R - a)) / 2
    return E_star * (a ** 2 * angle + R ** 2 * tanh_gap(angle, a / R))


def _pressure(r, a, R, E_star):
    root_Rr = np.sqrt((R - r) * (r + R))
    root = np.sqrt((R - a) * (a + R))
    root_ar = np.sqrt((a - r) * (a + r))
    pressed = E_star / np.pi * (R * np.arcsinh(root_ar / root) / root_Rr + arc_strips(r, a, R))
    inside = pressed if r < a else 0.0
    return inside if a <= R else np.nan


def _contact_from_depth(d, R):
    """Contact radius a and its root sqrt(R**2 - a**2)."""

    def curve(t):
        a, root = (R * np.tanh(t), R / np.cosh(t))
        value = _depth_at(a, root)
        return (value, t * root * root / R * _slope(a, root, R) / value)
    rest = (0.9983865, 0.208363, -4.0282, 30.18372, -93.92268, 137.5431, -95.06062, 25.07439)
    start = between(np.log(d / curve(1.0)[0]), (1.313, 2.0), (1.313, 1.0), 3.75, rest)
    t = inverse(curve, d, start, (1.0, 2.0), smooth=True)
    return (R * np.tanh(t), R / np.cosh(t))


def _radius_from_depth(d, R):
    return _contact_from_depth(d, R)[0]


def _contact_from_force(F, R, E_star):
    """Contact radius a and its root sqrt(R**2 - a**2)."""

    def curve(t):
        a, root = (R * np.tanh(t), R / np.cosh(t))
        value = _force_at(a, root, R, E_star)
        return (value, 2 * E_star * a * t * root * root / R * _slope(a, root, R) / value)
    rest = (0.998775, 0.1558039, -2.915358, 22.20415, -66.84601, 91.96521, -58.34092, 13.75711)
    start = between(np.log(F / curve(1.0)[0]), (1.629, 3.0), (2.405, 1.0), 1.75, rest)
    t = inverse(curve, F, start, (1.0, 3.0), smooth=True)
    return (R * np.tanh(t), R / np.cosh(t))


def _radius_from_force(F, R, E_star):
    return _contact_from_force(F, R, E_star)[0]


def _force_from_depth(d, R, E_star):
    a, root = _contact_from_depth(d, R)
    change = 2 * E_star * a * (d - _depth_at(a, root)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force_at(a, root, R, E_star) + change


def _depth_from_force(F, R, E_star):
    a, root = _contact_from_force(F, R, E_star)
    change = (F - _force_at(a, root, R, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth_at(a, root) + change
