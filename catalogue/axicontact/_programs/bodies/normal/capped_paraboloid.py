"""Bodies of axicontact.normal.capped_paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.shapes.across import inverse_beyond
from ...._runtime.plain import sqrt, MATH as np


def _slope_beyond(t, root, R1, R2, b):
    v8 = R1 - R2
    v10 = R1 * R2
    return 2.0 * t / R1 + 2.0 * v8 / v10 * root + b * b * v8 / (v10 * root)


def _depth_beyond(a, root, R1, R2):
    return a * (a + (R1 - R2) / R2 * root) / R1


def _depth(a, R1, R2, b):
    if a < b:
        return a * a / R1
    return a * (a + (R1 - R2) / R2 * sqrt((a - b) * (a + b))) / R1


def _force_beyond(a, root, R1, R2, b, E_star):
    v11 = a * a
    return 2.0 * E_star / (3.0 * R1) * (2.0 * (a * v11) + (R1 - R2) / R2 * (2.0 * v11 + b * b) * root)


def _force(a, R1, R2, b, E_star):
    v8 = 3.0 * R1
    v11 = a * a
    v12 = a * v11
    if a < b:
        return 4.0 * E_star / v8 * v12
    return 2.0 * E_star / v8 * (2.0 * v12 + (R1 - R2) / R2 * (2.0 * v11 + b * b) * sqrt((a - b) * (a + b)))


def _radius_from_depth(d, R1, R2, b):

    def curve(a, root):
        rate = a * _slope_beyond(a, root, R1, R2, b)
        return (_depth_beyond(a, root, R1, R2), rate)
    return inverse_beyond(curve, d, b, 2.0, leaving=(1.0, 2.0))


def _radius_from_force(F, R1, R2, b, E_star):

    def curve(a, root):
        rate = 2 * E_star * a ** 2 * _slope_beyond(a, root, R1, R2, b)
        return (_force_beyond(a, root, R1, R2, b, E_star), rate)
    return inverse_beyond(curve, F, b, 3.0, leaving=(1.0, 3.0))


def _force_from_depth(d, R1, R2, b, E_star):
    a = _radius_from_depth(d, R1, R2, b)
    change = 2 * E_star * a * (d - _depth(a, R1, R2, b)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force(a, R1, R2, b, E_star) + change


def _depth_from_force(F, R1, R2, b, E_star):
    a = _radius_from_force(F, R1, R2, b, E_star)
    change = (F - _force(a, R1, R2, b, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth(a, R1, R2, b) + change
