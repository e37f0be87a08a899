"""Bodies of axicontact.graded.normal.truncated_paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import nan, pow

from ....._programs.bodies._runtime.graded.punch import punch_depth, punch_force
from ....._runtime.plain import sqrt, MATH as np


def _depth_at(a, root, R, b, k):
    v5 = root / a
    return (a * a * (v5 * pow(v5, k) if v5 > 0.0 else 0.0) / (1.0 + k) + 0.0 * b) / R


def _rate_at(a, root, R, b, k):
    if a < b:
        v21 = 0.0
    else:
        v5 = root / a
        v21 = a * ((1.0 - k) / (1.0 + k) * (v5 * pow(v5, k) if v5 > 0.0 else 0.0) + pow(v5, k - 1.0))
    return v21 / R


def _force_at(a, root, R, b, H, k):
    v7 = root / (a if a > b or a != a else b)
    v21 = 3.0 + k
    v23 = 1.0 + k
    return 2.0 * H / v23 * ((a * a * (a * pow(a, k) if a > 0.0 else 0.0) * (v7 * pow(v7, k) if v7 > 0.0 else 0.0) * (v21 - v23 * (v7 * v7)) / (v23 * v21) + 0.0 * b) / R)


def _rate(a, R, b, k):
    if a >= b:
        if a < b:
            v26 = 0.0
        else:
            v5 = a - b
            v11 = sqrt((v5 if v5 > 0.0 or v5 != v5 else 0.0) * (a + b)) / a
            v26 = a * ((1.0 - k) / (1.0 + k) * (v11 * pow(v11, k) if v11 > 0.0 else 0.0) + pow(v11, k - 1.0))
        return v26 / R
    return nan


def _force(a, R, b, H, k):
    if a >= b:
        v6 = a - b
        v13 = sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * (a + b)) / (a if a > b or a != a else b)
        v26 = 3.0 + k
        v28 = 1.0 + k
        return 2.0 * H / v28 * ((a * a * (a * pow(a, k) if a > 0.0 else 0.0) * (v13 * pow(v13, k) if v13 > 0.0 else 0.0) * (v26 - v28 * (v13 * v13)) / (v28 * v26) + 0.0 * b) / R)
    return nan


def _force_rate_at(a, root, R, b, H, k):
    v9 = 1.0 + k
    if a < b:
        v30 = 0.0
    else:
        v17 = root / a
        v30 = a * ((1.0 - k) / v9 * (v17 * pow(v17, k) if v17 > 0.0 else 0.0) + pow(v17, k - 1.0))
    return 2.0 * H / v9 * (a * pow(a, k) if a > 0.0 else 0.0) * (v30 / R)


def _pressure(r, a, R, b, H, k):
    from ....._programs.bodies._runtime.graded.pressure import rim_pressure
    inside = np.minimum(r, a)
    growth = rim_pressure(inside, a, b, k) / R
    return (H / np.pi * growth if r < a else 0.0) if a >= b else np.nan


def _displacement(r, a, R, b, k):
    from ....._programs.bodies._runtime.graded.displacement import rim_displacement
    return rim_displacement(r, a, b, k) / R


def _contact_from_depth(d, R, b, k):
    """Contact radius a and its root sqrt(a**2 - b**2)."""
    from ....._programs.bodies._runtime.graded.inverse import contact_beyond
    return contact_beyond(_depth_at, _rate_at, d, b, (R, b, k), (1.0 + k, 2.0))


def _radius_from_depth(d, R, b, k):
    return _contact_from_depth(d, R, b, k)[0]


def _contact_from_force(F, R, b, H, k):
    """Contact radius a and its root sqrt(a**2 - b**2)."""
    from ....._programs.bodies._runtime.graded.inverse import contact_beyond
    return contact_beyond(_force_at, _force_rate_at, F, b, (R, b, H, k), (1.0 + k, 3.0 + k))


def _radius_from_force(F, R, b, H, k):
    return _contact_from_force(F, R, b, H, k)[0]


def _force_from_depth(d, R, b, H, k):
    a, root = _contact_from_depth(d, R, b, k)
    return _force_at(a, root, R, b, H, k) + punch_force(d - _depth_at(a, root, R, b, k), a, H, k)


def _depth_from_force(F, R, b, H, k):
    a, root = _contact_from_force(F, R, b, H, k)
    return _depth_at(a, root, R, b, k) + punch_depth(F - _force_at(a, root, R, b, H, k), a, H, k)
