"""Bodies of axicontact.plane.rounded_punch over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, atan, exp, expm1, fsum, inf

from ...._programs.bodies._runtime.inverse import inverse
from ...._runtime.plain import sqrt, rule, MATH as np

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def _growth_beyond(t, root, R, b):
    return t * atan(root / b) / R


def _load_at(root, R, b, E_star):
    v5 = asinh(root / b)
    v11 = 0.0 - expm1(-2.0 * v5)
    v14 = v11 if v11 > 0.0 else inf
    v16 = v5 if v5 < 42.0 or v5 != v5 else 42.0
    v27 = b * b
    v36 = []
    for node, weight in RULE_0(v16 / 1.0):
        v17 = node * v16
        v26 = root * (exp(-v17) * (0.0 - expm1(-2.0 * (v5 - v17))) / v14)
        v35 = sqrt(v27 + v26 * v26) * atan(v26 / b) / R * v26
        v36.append(weight * v35)
    v36 = fsum(v36) * v16
    return E_star * v36


def _half_width_from_load(P, R, b, E_star):

    def curve(t):
        a, root = (b * np.sqrt(1.0 + t * t), b * t)
        value = _load_at(root, R, b, E_star)
        return (value, E_star * root * root / a * _growth_beyond(a, root, R, b) / value)
    t = inverse(curve, P, np.ones_like(P), (2.0, 3.0))
    return b * np.sqrt(1.0 + t * t)
