"""Bodies of axicontact.normal.rounded_punch over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan, atan2

from ...._programs.bodies._runtime.inverse import between, inverse
from ...._runtime.plain import sqrt, MATH as np


def _slope_beyond(t, root, R, b):
    return 2.0 * root / R - b / R * atan2(root, b)


def _depth_at(a, root, R, b):
    v6 = root / b
    if v6 < 1.0:
        v10 = v6 * v6
        v53 = v6 * v10 * (((((((2.229767813968649e-06 * v10 + 0.0021043873129700233) * v10 + 0.04325113828415611) * v10 + 0.2725778671008127) * v10 + 0.7123414383945195) * v10 + 0.8116412201960678) * v10 + 0.3333333333333333) / ((((((0.002445452808893491 * v10 + 0.06453295925870227) * v10 + 0.5368820963772863) * v10 + 1.9680296155712274) * v10 + 3.5294070829658954) * v10 + 3.034923660588189) * v10 + 1.0))
    else:
        v53 = v6 - atan(v6)
    return b / R * a * v53


def _force_at(a, root, R, b, E_star):
    v13 = root / b
    if v13 < 1.0:
        v17 = v13 * v13
        v60 = v13 * v17 * (((((((2.229767813968649e-06 * v17 + 0.0021043873129700233) * v17 + 0.04325113828415611) * v17 + 0.2725778671008127) * v17 + 0.7123414383945195) * v17 + 0.8116412201960678) * v17 + 0.3333333333333333) / ((((((0.002445452808893491 * v17 + 0.06453295925870227) * v17 + 0.5368820963772863) * v17 + 1.9680296155712274) * v17 + 3.5294070829658954) * v17 + 3.034923660588189) * v17 + 1.0))
    else:
        v60 = v13 - atan(v13)
    return E_star / R * (root * (root * root) / 3.0 + b * (a * a) * v60)


def _force(a, R, b, E_star):
    v4 = a - b
    v6 = v4 * (a + b)
    v7 = sqrt(v6)
    v12 = v4 / b
    if v12 < 0.42:
        v55 = v12 * sqrt(v12) * ((((((0.0005288491342179178 * v12 + 0.038096760299703034) * v12 + 0.4065213849117787) * v12 + 1.438682033198726) * v12 + 1.9979042349620892) * v12 + 0.9428090415820634) / (((((0.006421883194715949 * v12 + 0.15001504718401248) * v12 + 0.9450913324352289) * v12 + 2.37401087025821) * v12 + 2.569097449054519) * v12 + 1.0))
    else:
        v15 = v7 / b
        v55 = v15 - atan(v15)
    return E_star / R * (b * (a * a) * v55 + v6 * v7 / 3.0)


def _contact_from_depth(d, R, b):
    """Contact radius a and its root sqrt(a**2 - b**2)."""

    def curve(t):
        a, root = (b * np.sqrt(1.0 + t * t), b * t)
        value = _depth_at(a, root, R, b)
        return (value, root * root / a * _slope_beyond(a, root, R, b) / value)
    rest = (0.9999152, -0.002147146, -0.02265958, -0.0720644, 0.3108858, -0.6900221, 1.077435, -0.6001833)
    start = between(np.log(d / curve(1.0)[0]), (1.098, 3.0), (3.295, 2.0), 3.5, rest)
    t = inverse(curve, d, start, (2.0, 4.0), smooth=True)
    return (b * np.sqrt(1.0 + t * t), b * t)


def _radius_from_depth(d, R, b):
    return _contact_from_depth(d, R, b)[0]


def _contact_from_force(F, R, b, E_star):
    """Contact radius a and its root sqrt(a**2 - b**2)."""

    def curve(t):
        a, root = (b * np.sqrt(1.0 + t * t), b * t)
        value = _force_at(a, root, R, b, E_star)
        return (value, 2 * E_star * root * root * _slope_beyond(a, root, R, b) / value)
    rest = (0.9634905, 0.003191853, -0.1218583, 0.3231377, -1.571447, 2.059576, -1.105184, 0.2138332)
    start = between(np.log(F / curve(1.0)[0]), (0.8743, 3.0), (1.749, 3.0), 6.0, rest)
    t = inverse(curve, F, start, (3.0, 4.0), smooth=True)
    return (b * np.sqrt(1.0 + t * t), b * t)


def _radius_from_force(F, R, b, E_star):
    return _contact_from_force(F, R, b, E_star)[0]


def _force_from_depth(d, R, b, E_star):
    a, root = _contact_from_depth(d, R, b)
    change = 2 * E_star * a * (d - _depth_at(a, root, R, b)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force_at(a, root, R, b, E_star) + change


def _depth_from_force(F, R, b, E_star):
    a, root = _contact_from_force(F, R, b, E_star)
    change = (F - _force_at(a, root, R, b, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth_at(a, root, R, b) + change
