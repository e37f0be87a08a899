"""Bodies of axicontact.graded.normal.sphere_tipped_cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.functions import sine_root
from ....._programs.bodies._runtime.graded.breaks import tipped_depth, tipped_force, tipped_rate
from ....._programs.bodies._runtime.graded.punch import punch_depth, punch_force, punch_stiffness
from ....._runtime.plain import MATH as np


def _depth_at(a, root, R, theta, k):
    b = R * np.sin(theta)
    return tipped_depth(a, root, R, b, R * np.cos(theta), k)


def _rate_at(a, root, R, theta, k):
    """Rate g'(a) of the depth."""
    b = R * np.sin(theta)
    return tipped_rate(a, root, R, b, R * np.cos(theta), k)


def _force_at(a, root, R, theta, H, k):
    b = R * np.sin(theta)
    growth = tipped_force(a, root, R, b, R * np.cos(theta), k)
    return 2.0 * H / (1.0 + k) * growth


def _depth(a, R, theta, k):
    return _depth_at(a, sine_root(a, R, theta), R, theta, k)


def _rate(a, R, theta, k):
    return _rate_at(a, sine_root(a, R, theta), R, theta, k)


def _force(a, R, theta, H, k):
    return _force_at(a, sine_root(a, R, theta), R, theta, H, k)


def _force_rate_at(a, root, R, theta, H, k):
    """Derivative of the force."""
    return punch_stiffness(a, H, k) * _rate_at(a, root, R, theta, k)


def _mean_pressure(a, R, theta, H, k):
    return _force(a, R, theta, H, k) / (np.pi * a * a) if a > 0.0 else 0.0


def _displacement(r, a, R, theta, k):
    from ....._programs.bodies._runtime.graded.displacement import tipped_displacement
    b = R * np.sin(theta)
    return tipped_displacement(r, a, R, b, R * np.cos(theta), k)


def _radius_from_depth(d, R, theta, k):
    from ....._programs.bodies._runtime.graded.inverse import radius_across
    b = R * np.sin(theta)
    return radius_across(_depth_at, _rate_at, d, b, (R, theta, k), 2.0, end=R)


def _radius_from_force(F, R, theta, H, k):
    from ....._programs.bodies._runtime.graded.inverse import radius_across
    b = R * np.sin(theta)
    return radius_across(_force_at, _force_rate_at, F, b, (R, theta, H, k), 3.0 + k, end=R)


def _force_from_depth(d, R, theta, H, k):
    a = _radius_from_depth(d, R, theta, k)
    return _force(a, R, theta, H, k) + punch_force(d - _depth(a, R, theta, k), a, H, k)


def _depth_from_force(F, R, theta, H, k):
    a = _radius_from_force(F, R, theta, H, k)
    return _depth(a, R, theta, k) + punch_depth(F - _force(a, R, theta, H, k), a, H, k)
