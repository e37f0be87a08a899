"""Bodies of axicontact.normal.truncated_paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.inverse import between, inverse
from ...._runtime.plain import sqrt, MATH as np


def _slope_beyond(t, root, R, b):
    return 2.0 * root / R + b * b / (R * root)


def _depth_at(a, root, R):
    return a * root / R


def _force_at(a, root, R, b, E_star):
    return 2.0 * E_star / (3.0 * R) * (2.0 * (a * a) + b * b) * root


def _force(a, R, b, E_star):
    return 2.0 * E_star / (3.0 * R) * (2.0 * (a * a) + b * b) * sqrt((a - b) * (a + b))


def _contact_from_force(F, R, b, E_star):
    """Contact radius a and its root sqrt(a**2 - b**2)."""

    def curve(t):
        a, root = (b * np.sqrt(1.0 + t * t), b * t)
        value = _force_at(a, root, R, b, E_star)
        return (value, 2 * E_star * root * root * _slope_beyond(a, root, R, b) / value)
    rest = (0.9990587, 0.3089073, -0.7678073, 7.512052, -39.30687, 76.63965, -63.48232, 19.09787)
    start = between(np.log(F / curve(1.0)[0]), (0.6, 1.0), (0.4, 3.0), -1.75, rest)
    t = inverse(curve, F, start, (1.0, 3.0), smooth=True)
    return (b * np.sqrt(1.0 + t * t), b * t)


def _radius_from_force(F, R, b, E_star):
    return _contact_from_force(F, R, b, E_star)[0]


def _contact_from_depth(d, R, b):
    """Contact radius a and its root sqrt(a**2 - b**2)."""

    def curve(t):
        a, root = (b * np.sqrt(1.0 + t * t), b * t)
        value = _depth_at(a, root, R)
        return (value, root * root / a * _slope_beyond(a, root, R, b) / value)
    rest = (0.9996917, 0.05914493, 0.009062067, 1.353675, -12.15272, 28.05264, -25.52146, 8.200478)
    start = between(np.log(d / curve(1.0)[0]), (0.7071, 1.0), (0.7071, 2.0), -3.0, rest)
    t = inverse(curve, d, start, (1.0, 2.0), smooth=True)
    return (b * np.sqrt(1.0 + t * t), b * t)


def _force_from_depth(d, R, b, E_star):
    a, root = _contact_from_depth(d, R, b)
    change = 2 * E_star * a * (d - _depth_at(a, root, R)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force_at(a, root, R, b, E_star) + change


def _depth_from_force(F, R, b, E_star):
    a, root = _contact_from_force(F, R, b, E_star)
    change = (F - _force_at(a, root, R, b, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth_at(a, root, R) + change
