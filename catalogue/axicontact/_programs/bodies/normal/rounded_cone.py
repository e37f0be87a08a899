"""Bodies of axicontact.normal.rounded_cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan, tan

from ...._programs.bodies._runtime.shapes.across import inverse_beyond
from ...._runtime.plain import sqrt, MATH as np


def _slope_beyond(t, root, theta, b):
    return tan(theta) * (atan(root / b) + 2.0 * b / (root + t))


def _depth_beyond(a, root, theta, b):
    return tan(theta) * a * (atan(root / b) + b / (root + a))


def _depth(a, theta, b):
    v3 = tan(theta)
    if a < b:
        return v3 / b * (a * a)
    v11 = sqrt((a - b) * (a + b))
    return v3 * a * (atan(v11 / b) + b / (v11 + a))


def _force_beyond(a, root, theta, b, E_star):
    v10 = a * a
    return E_star * tan(theta) * (v10 * atan(root / b) + 4.0 * b * v10 / (3.0 * (root + a)) + b / 3.0 * root)


def _force(a, theta, b, E_star):
    v6 = tan(theta)
    v12 = a * a
    if a < b:
        return 4.0 * E_star * v6 / (3.0 * b) * (a * v12)
    v18 = sqrt((a - b) * (a + b))
    return E_star * v6 * (v12 * atan(v18 / b) + 4.0 * b * v12 / (3.0 * (v18 + a)) + b / 3.0 * v18)


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
