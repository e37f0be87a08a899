"""Bodies of axicontact.graded.normal.hyperboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.growth import hyperboloid_depth, hyperboloid_force, hyperboloid_rate
from ....._programs.bodies._runtime.graded.punch import punch_depth, punch_force, punch_stiffness
from ....._runtime.plain import MATH as np


def _depth(a, theta, b, k):
    return hyperboloid_depth(a, b, k) * np.tan(theta)


def _rate(a, theta, b, k):
    """Rate g'(a) of the depth."""
    return hyperboloid_rate(a, b, k) * np.tan(theta)


def _force(a, theta, b, H, k):
    growth = hyperboloid_force(a, b, k) * np.tan(theta)
    return 2.0 * H / (1.0 + k) * growth


def _force_rate(a, theta, b, H, k):
    """Derivative of the force."""
    return punch_stiffness(a, H, k) * _rate(a, theta, b, k)


def _mean_pressure(a, theta, b, H, k):
    return _force(a, theta, b, H, k) / (np.pi * a * a) if a > 0.0 else 0.0


def _displacement(r, a, theta, b, k):
    from ....._programs.bodies._runtime.graded.displacement import hyperboloid_displacement
    return hyperboloid_displacement(r, a, b, k) * np.tan(theta)


def _radius_from_depth(d, theta, b, k):
    from ....._programs.bodies._runtime.graded.inverse import radius_to
    return radius_to(_depth, _rate, d, 1.5 * b, (theta, b, k))


def _radius_from_force(F, theta, b, H, k):
    from ....._programs.bodies._runtime.graded.inverse import radius_to
    return radius_to(_force, _force_rate, F, 1.5 * b, (theta, b, H, k))


def _force_from_depth(d, theta, b, H, k):
    a = _radius_from_depth(d, theta, b, k)
    return _force(a, theta, b, H, k) + punch_force(d - _depth(a, theta, b, k), a, H, k)


def _depth_from_force(F, theta, b, H, k):
    a = _radius_from_force(F, theta, b, H, k)
    return _depth(a, theta, b, k) + punch_depth(F - _force(a, theta, b, H, k), a, H, k)
