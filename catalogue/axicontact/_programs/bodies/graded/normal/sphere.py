"""Bodies of axicontact.graded.normal.sphere over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.growth import sphere_depth, sphere_force, sphere_rate
from ....._programs.bodies._runtime.graded.punch import punch_depth, punch_force, punch_stiffness
from ....._programs.bodies._runtime.integrals import difference_root
from ....._runtime.plain import MATH as np


def _depth_at(a, root, R, k):
    return sphere_depth(a, root, k)


def _rate_at(a, root, R, k):
    """Rate g'(a) of the depth."""
    return sphere_rate(a, root, k)


def _force_at(a, root, R, H, k):
    growth = sphere_force(a, root, k)
    return 2.0 * H / (1.0 + k) * growth


def _depth(a, R, k):
    return _depth_at(a, difference_root(R, a), R, k) if a <= R else np.nan


def _rate(a, R, k):
    return _rate_at(a, difference_root(R, a), R, k) if a <= R else np.nan


def _force(a, R, H, k):
    return _force_at(a, difference_root(R, a), R, H, k) if a <= R else np.nan


def _force_rate_at(a, root, R, H, k):
    """Derivative of the force."""
    return punch_stiffness(a, H, k) * _rate_at(a, root, R, k)


def _mean_pressure(a, R, H, k):
    return _force(a, R, H, k) / (np.pi * a * a) if a > 0.0 else 0.0


def _displacement(r, a, R, k):
    from ....._programs.bodies._runtime.graded.displacement import sphere_displacement
    return sphere_displacement(r, a, R, k)


def _contact_from_depth(d, R, k):
    """Contact radius a and its root sqrt(R**2 - a**2)."""
    from ....._programs.bodies._runtime.graded.inverse import contact_below
    return contact_below(_depth_at, _rate_at, d, R, (R, k), 2.0, k)


def _radius_from_depth(d, R, k):
    return _contact_from_depth(d, R, k)[0]


def _contact_from_force(F, R, H, k):
    """Contact radius a and its root sqrt(R**2 - a**2)."""
    from ....._programs.bodies._runtime.graded.inverse import contact_below
    return contact_below(_force_at, _force_rate_at, F, R, (R, H, k), 3.0 + k, k)


def _radius_from_force(F, R, H, k):
    return _contact_from_force(F, R, H, k)[0]


def _force_from_depth(d, R, H, k):
    a, root = _contact_from_depth(d, R, k)
    return _force_at(a, root, R, H, k) + punch_force(d - _depth_at(a, root, R, k), a, H, k)


def _depth_from_force(F, R, H, k):
    a, root = _contact_from_force(F, R, H, k)
    return _depth_at(a, root, R, k) + punch_depth(F - _force_at(a, root, R, H, k), a, H, k)
