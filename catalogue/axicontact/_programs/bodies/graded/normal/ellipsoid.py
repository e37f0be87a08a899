"""Bodies of axicontact.graded.normal.ellipsoid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.growth import sphere_depth, sphere_force, sphere_rate
from ....._programs.bodies._runtime.graded.punch import punch_depth, punch_force, punch_stiffness
from ....._programs.bodies._runtime.integrals import difference_root
from ....._runtime.plain import MATH as np


def _depth_at(a, root, h, b, k):
    return h * sphere_depth(a, root, k) / b


def _rate_at(a, root, h, b, k):
    """Rate g'(a) of the depth."""
    return h * sphere_rate(a, root, k) / b


def _force_at(a, root, h, b, H, k):
    growth = h * sphere_force(a, root, k) / b
    return 2.0 * H / (1.0 + k) * growth


def _depth(a, h, b, k):
    return _depth_at(a, difference_root(b, a), h, b, k) if a <= b else np.nan


def _rate(a, h, b, k):
    return _rate_at(a, difference_root(b, a), h, b, k) if a <= b else np.nan


def _force(a, h, b, H, k):
    return _force_at(a, difference_root(b, a), h, b, H, k) if a <= b else np.nan


def _force_rate_at(a, root, h, b, H, k):
    """Derivative of the force."""
    return punch_stiffness(a, H, k) * _rate_at(a, root, h, b, k)


def _mean_pressure(a, h, b, H, k):
    return _force(a, h, b, H, k) / (np.pi * a * a) if a > 0.0 else 0.0


def _displacement(r, a, h, b, k):
    from ....._programs.bodies._runtime.graded.displacement import sphere_displacement
    return h * sphere_displacement(r, a, b, k) / b


def _contact_from_depth(d, h, b, k):
    """Contact radius a and its root sqrt(b**2 - a**2)."""
    from ....._programs.bodies._runtime.graded.inverse import contact_below
    return contact_below(_depth_at, _rate_at, d, b, (h, b, k), 2.0, k)


def _radius_from_depth(d, h, b, k):
    return _contact_from_depth(d, h, b, k)[0]


def _contact_from_force(F, h, b, H, k):
    """Contact radius a and its root sqrt(b**2 - a**2)."""
    from ....._programs.bodies._runtime.graded.inverse import contact_below
    return contact_below(_force_at, _force_rate_at, F, b, (h, b, H, k), 3.0 + k, k)


def _radius_from_force(F, h, b, H, k):
    return _contact_from_force(F, h, b, H, k)[0]


def _force_from_depth(d, h, b, H, k):
    a, root = _contact_from_depth(d, h, b, k)
    return _force_at(a, root, h, b, H, k) + punch_force(d - _depth_at(a, root, h, b, k), a, H, k)


def _depth_from_force(F, h, b, H, k):
    a, root = _contact_from_force(F, h, b, H, k)
    return _depth_at(a, root, h, b, k) + punch_depth(F - _force_at(a, root, h, b, H, k), a, H, k)
