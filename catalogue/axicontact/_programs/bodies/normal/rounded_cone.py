"""Bodies of axicontact.normal.rounded_cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.shapes.across import inverse_beyond
from ....normal.rounded_cone import Array
from ...._runtime.plain import MATH as np


def _slope(t: Array, theta: Array, b: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t)."""
    return 2 * np.tan(theta) / b * t


def _slope_beyond(t: Array, root: Array, theta: Array, b: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t) for t > b."""
    angle = np.arctan(root / b)
    return np.tan(theta) * (angle + 2 * b / (root + t))


def _depth_beyond(a: Array, root: Array, theta: Array, b: Array) -> Array:
    angle = np.arctan(root / b)
    return np.tan(theta) * a * (angle + b / (root + a))


def _depth(a: Array, theta: Array, b: Array) -> Array:
    tip = np.tan(theta) / b * a ** 2
    root = np.sqrt((a - b) * (a + b))
    angle = np.arctan(root / b)
    beyond = np.tan(theta) * a * (angle + b / (root + a))
    return tip if a < b else beyond


def _force_beyond(a: Array, root: Array, theta: Array, b: Array, E_star: Array) -> Array:
    angle = np.arctan(root / b)
    return E_star * np.tan(theta) * (a ** 2 * angle + 4 * b * a ** 2 / (3 * (root + a)) + b / 3 * root)


def _force(a: Array, theta: Array, b: Array, E_star: Array) -> Array:
    tip = 4 * E_star * np.tan(theta) / (3 * b) * a ** 3
    root = np.sqrt((a - b) * (a + b))
    angle = np.arctan(root / b)
    beyond = E_star * np.tan(theta) * (a ** 2 * angle + 4 * b * a ** 2 / (3 * (root + a)) + b / 3 * root)
    return tip if a < b else beyond


def _radius_from_depth(d: Array, theta: Array, b: Array) -> Array:

    def curve(a: Array, root: Array) -> tuple[Array, Array]:
        rate = a * _slope_beyond(a, root, theta, b)
        return (_depth_beyond(a, root, theta, b), rate)
    return inverse_beyond(curve, d, b, 2.0, powers=(2.0, 1.0))


def _radius_from_force(F: Array, theta: Array, b: Array, E_star: Array) -> Array:

    def curve(a: Array, root: Array) -> tuple[Array, Array]:
        rate = 2 * E_star * a ** 2 * _slope_beyond(a, root, theta, b)
        return (_force_beyond(a, root, theta, b, E_star), rate)
    return inverse_beyond(curve, F, b, 3.0, powers=(2.0, 2.0))


def _force_from_depth(d: Array, theta: Array, b: Array, E_star: Array) -> Array:
    a = _radius_from_depth(d, theta, b)
    change = 2 * E_star * a * (d - _depth(a, theta, b)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force(a, theta, b, E_star) + change


def _depth_from_force(F: Array, theta: Array, b: Array, E_star: Array) -> Array:
    a = _radius_from_force(F, theta, b, E_star)
    change = (F - _force(a, theta, b, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth(a, theta, b) + change
