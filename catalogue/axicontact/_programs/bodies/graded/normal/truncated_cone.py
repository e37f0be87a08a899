"""Bodies of axicontact.graded.normal.truncated_cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.breaks import flank_depth, flank_force, flank_rate
from ....._programs.bodies._runtime.graded.punch import punch_depth, punch_force, punch_stiffness
from ....._programs.bodies._runtime.integrals import difference_root
from ....._runtime.plain import MATH as np


def _depth_at(a, root, theta, b, k):
    return flank_depth(a, root, b, k) * np.tan(theta)


def _rate_at(a, root, theta, b, k):
    """Rate g'(a) of the depth."""
    return flank_rate(a, root, b, k) * np.tan(theta)


def _force_at(a, root, theta, b, H, k):
    growth = flank_force(a, root, b, k) * np.tan(theta)
    return 2.0 * H / (1.0 + k) * growth


def _depth(a, theta, b, k):
    return _depth_at(a, difference_root(a, b), theta, b, k) if a >= b else np.nan


def _rate(a, theta, b, k):
    return _rate_at(a, difference_root(a, b), theta, b, k) if a >= b else np.nan


def _force(a, theta, b, H, k):
    return _force_at(a, difference_root(a, b), theta, b, H, k) if a >= b else np.nan


def _force_rate_at(a, root, theta, b, H, k):
    """Derivative of the force."""
    return punch_stiffness(a, H, k) * _rate_at(a, root, theta, b, k)


def _mean_pressure(a, theta, b, H, k):
    return _force(a, theta, b, H, k) / (np.pi * a * a)


def _displacement(r, a, theta, b, k):
    from ....._programs.bodies._runtime.graded.displacement import flank_displacement
    return flank_displacement(r, a, b, k) * np.tan(theta)


def _contact_from_depth(d, theta, b, k):
    """Contact radius a and its root sqrt(a**2 - b**2)."""
    from ....._programs.bodies._runtime.graded.inverse import contact_beyond
    return contact_beyond(_depth_at, _rate_at, d, b, (theta, b, k), (1.0 + k, 1.0))


def _radius_from_depth(d, theta, b, k):
    return _contact_from_depth(d, theta, b, k)[0]


def _contact_from_force(F, theta, b, H, k):
    """Contact radius a and its root sqrt(a**2 - b**2)."""
    from ....._programs.bodies._runtime.graded.inverse import contact_beyond
    return contact_beyond(_force_at, _force_rate_at, F, b, (theta, b, H, k), (1.0 + k, 2.0 + k))


def _radius_from_force(F, theta, b, H, k):
    return _contact_from_force(F, theta, b, H, k)[0]


def _force_from_depth(d, theta, b, H, k):
    a, root = _contact_from_depth(d, theta, b, k)
    return _force_at(a, root, theta, b, H, k) + punch_force(d - _depth_at(a, root, theta, b, k), a, H, k)


def _depth_from_force(F, theta, b, H, k):
    a, root = _contact_from_force(F, theta, b, H, k)
    return _depth_at(a, root, theta, b, k) + punch_depth(F - _force_at(a, root, theta, b, H, k), a, H, k)
