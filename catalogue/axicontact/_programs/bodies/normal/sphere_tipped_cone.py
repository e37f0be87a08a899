"""Bodies of axicontact.normal.sphere_tipped_cone over plain numbers: the same text with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.shapes.across import inverse_across
from ....normal.sphere_tipped_cone import Array
from ...._runtime.plain import MATH as np


def _slope(t: Array, root: Array, R: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t)."""
    angle = np.arcsinh(t / root)
    return angle + R * t / root**2


def _slope_beyond(t: Array, root: Array, R: Array, theta: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t) for t > b."""
    b = R * np.sin(theta)
    root_Rb = R * np.cos(theta)
    angle = np.arctan2(root, b)
    logarithm = np.log1p((b**2 / (root + t) + b**2 / (root_Rb + R)) / (root + root_Rb))
    return logarithm + b * angle / root_Rb + b**2 * R / (t * root_Rb**2 + R * root * root_Rb)


def _depth_at(a: Array, root: Array, R: Array, theta: Array) -> Array:
    b = R * np.sin(theta)
    root_Rb = R * np.cos(theta)
    angle = np.arctan2(root, b)
    logarithm = np.log1p((b**2 / (root + a) + b**2 / (root_Rb + R)) / (root + root_Rb))
    beyond = a * (logarithm + b * angle / root_Rb)
    angle = np.log1p(2 * a / (R - a)) / 2
    tip = a * angle
    return np.where(a < b, tip, beyond)


def _slope_at(a: Array, root: Array, R: Array, theta: Array) -> Array:
    """Rate g'(a) of the indentation depth on both sides of the break."""
    b = R * np.sin(theta)
    root_tip = np.sqrt((R - a) * (R + a))
    return np.where(a < b, _slope(a, root_tip, R), _slope_beyond(a, root, R, theta))


def _radius_from_depth(d: Array, R: Array, theta: Array) -> Array:
    b = R * np.sin(theta)

    def curve(a: Array, root: Array) -> tuple[Array, Array]:
        rate = a * _slope_at(a, root, R, theta)
        return _depth_at(a, root, R, theta), rate

    return inverse_across(curve, d, b, 2.0, R, powers=(2.0, 1.0))
