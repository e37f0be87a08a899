"""Bodies of axicontact.graded.normal.rounded_cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.breaks import rounded_depth, rounded_force, rounded_rate
from ....._programs.bodies._runtime.graded.punch import punch_depth, punch_force, punch_stiffness
from ....._programs.bodies._runtime.integrals import difference_root
from ....._runtime.plain import MATH as np


def _depth_at(a, root, theta, b, k):
    return rounded_depth(a, root, b, k) * np.tan(theta)


def _rate_at(a, root, theta, b, k):
    """Rate g'(a) of the depth."""
    return rounded_rate(a, root, b, k) * np.tan(theta)


def _force_at(a, root, theta, b, H, k):
    growth = rounded_force(a, root, b, k) * np.tan(theta)
    return 2.0 * H / (1.0 + k) * growth


def _depth(a, theta, b, k):
    return _depth_at(a, difference_root(a, b), theta, b, k)


def _rate(a, theta, b, k):
    return _rate_at(a, difference_root(a, b), theta, b, k)


def _force(a, theta, b, H, k):
    return _force_at(a, difference_root(a, b), theta, b, H, k)


def _force_rate_at(a, root, theta, b, H, k):
    """Derivative of the force."""
    return punch_stiffness(a, H, k) * _rate_at(a, root, theta, b, k)


def _mean_pressure(a, theta, b, H, k):
    return _force(a, theta, b, H, k) / (np.pi * a * a) if a > 0.0 else 0.0


def _displacement(r, a, theta, b, k):
    from ....._programs.bodies._runtime.graded.displacement import rounded_displacement
    return rounded_displacement(r, a, b, k) * np.tan(theta)


def _radius_from_depth(d, theta, b, k):
    from ....._programs.bodies._runtime.graded.inverse import radius_across
    return radius_across(_depth_at, _rate_at, d, b, (theta, b, k), 2.0)


def _radius_from_force(F, theta, b, H, k):
    from ....._programs.bodies._runtime.graded.inverse import radius_across
    return radius_across(_force_at, _force_rate_at, F, b, (theta, b, H, k), 3.0 + k)


def _force_from_depth(d, theta, b, H, k):
    a = _radius_from_depth(d, theta, b, k)
    return _force(a, theta, b, H, k) + punch_force(d - _depth(a, theta, b, k), a, H, k)


def _depth_from_force(F, theta, b, H, k):
    a = _radius_from_force(F, theta, b, H, k)
    return _depth(a, theta, b, k) + punch_depth(F - _force(a, theta, b, H, k), a, H, k)
