"""Bodies of axicontact.graded.normal.truncated_paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.breaks import rim_depth, rim_force, rim_rate
from ....._programs.bodies._runtime.graded.punch import punch_depth, punch_force, punch_stiffness
from ....._programs.bodies._runtime.integrals import difference_root
from ....._runtime.plain import MATH as np


def _depth_at(a, root, R, b, k):
    return rim_depth(a, root, b, k) / R


def _rate_at(a, root, R, b, k):
    """Rate g'(a) of the depth."""
    return rim_rate(a, root, b, k) / R


def _force_at(a, root, R, b, H, k):
    growth = rim_force(a, root, b, k) / R
    return 2.0 * H / (1.0 + k) * growth


def _depth(a, R, b, k):
    return _depth_at(a, difference_root(a, b), R, b, k) if a >= b else np.nan


def _rate(a, R, b, k):
    return _rate_at(a, difference_root(a, b), R, b, k) if a >= b else np.nan


def _force(a, R, b, H, k):
    return _force_at(a, difference_root(a, b), R, b, H, k) if a >= b else np.nan


def _force_rate_at(a, root, R, b, H, k):
    """Derivative of the force."""
    return punch_stiffness(a, H, k) * _rate_at(a, root, R, b, k)


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
