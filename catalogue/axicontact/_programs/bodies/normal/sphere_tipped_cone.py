"""Bodies of axicontact.normal.sphere_tipped_cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.functions import sine_root
from ...._programs.bodies._runtime.rules import force_integral_beyond
from ...._programs.bodies._runtime.shapes.across import inverse_across
from ...._programs.bodies._runtime.special import tanh_gap
from ...._runtime.plain import MATH as np


def _slope(t, root, R):
    """Rate g'(t) of the indentation depth g(t)."""
    angle = np.arcsinh(t / root)
    return angle + R * t / root ** 2


def _slope_beyond(t, root, R, theta):
    """Rate g'(t) of the indentation depth g(t) for t > b."""
    b = R * np.sin(theta)
    root_Rb = R * np.cos(theta)
    angle = np.arctan2(root, b)
    logarithm = np.log1p((b ** 2 / (root + t) + b ** 2 / (root_Rb + R)) / (root + root_Rb))
    return logarithm + b * angle / root_Rb + b ** 2 * R / (t * root_Rb ** 2 + R * root * root_Rb)


def _depth_at(a, root, R, theta):
    b = R * np.sin(theta)
    root_Rb = R * np.cos(theta)
    angle = np.arctan2(root, b)
    logarithm = np.log1p((b ** 2 / (root + a) + b ** 2 / (root_Rb + R)) / (root + root_Rb))
    beyond = a * (logarithm + b * angle / root_Rb)
    angle = np.log1p(2 * a / (R - a)) / 2
    tip = a * angle
    return tip if a < b else beyond


def _depth(a, R, theta):
    return _depth_at(a, sine_root(a, R, theta), R, theta)


def _force_at(a, reach, R, theta, E_star):
    b = R * np.sin(theta)
    inner = np.minimum(a, b)
    root = np.sqrt((R - inner) * (inner + R)) if a < b else R * np.cos(theta)
    angle = np.arcsinh(inner / root)
    tip = E_star * (inner ** 2 * angle + R ** 2 * tanh_gap(angle, np.tanh(angle)))
    beyond = 2 * E_star * force_integral_beyond(_slope_beyond, (R, theta), reach, b, width=1.0 - 2.0 * theta / np.pi)
    return tip + beyond


def _force(a, R, theta, E_star):
    return _force_at(a, sine_root(a, R, theta), R, theta, E_star)


def _slope_at(a, root, R, theta):
    """Rate g'(a) of the indentation depth on both sides of the break."""
    b = R * np.sin(theta)
    root_tip = np.sqrt((R - a) * (R + a))
    return _slope(a, root_tip, R) if a < b else _slope_beyond(a, root, R, theta)


def _radius_from_depth(d, R, theta):
    b = R * np.sin(theta)

    def curve(a, root):
        rate = a * _slope_at(a, root, R, theta)
        return (_depth_at(a, root, R, theta), rate)
    return inverse_across(curve, d, b, 2.0, R, powers=(2.0, 1.0))


def _radius_from_force(F, R, theta, E_star):
    b = R * np.sin(theta)

    def curve(a, root):
        rate = 2 * E_star * a ** 2 * _slope_at(a, root, R, theta)
        return (_force_at(a, root, R, theta, E_star), rate)
    return inverse_across(curve, F, b, 3.0, R, powers=(2.0, 2.0))


def _force_from_depth(d, R, theta, E_star):
    a = _radius_from_depth(d, R, theta)
    change = 2 * E_star * a * (d - _depth(a, R, theta)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force(a, R, theta, E_star) + change


def _depth_from_force(F, R, theta, E_star):
    a = _radius_from_force(F, R, theta, E_star)
    change = (F - _force(a, R, theta, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth(a, R, theta) + change
