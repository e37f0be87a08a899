"""Bodies of axicontact.graded.normal.capped_paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.breaks import rim_depth, rim_force, rim_rate
from ....._programs.bodies._runtime.graded.growth import power_depth, power_force, power_rate
from ....._programs.bodies._runtime.graded.punch import punch_depth, punch_force, punch_stiffness
from ....._programs.bodies._runtime.integrals import difference_root
from ....._runtime.plain import MATH as np


def _depth_at(a, root, R1, R2, b, k):
    return power_depth(a, 2.0, k) / (2 * R1) + rim_depth(a, root, b, k) * (R1 - R2) / (R1 * R2)


def _rate_at(a, root, R1, R2, b, k):
    """Rate g'(a) of the depth."""
    return power_rate(a, 2.0, k) / (2 * R1) + rim_rate(a, root, b, k) * (R1 - R2) / (R1 * R2)


def _force_at(a, root, R1, R2, b, H, k):
    growth = power_force(a, 2.0, k) / (2 * R1) + rim_force(a, root, b, k) * (R1 - R2) / (R1 * R2)
    return 2.0 * H / (1.0 + k) * growth


def _depth(a, R1, R2, b, k):
    return _depth_at(a, difference_root(a, b), R1, R2, b, k)


def _rate(a, R1, R2, b, k):
    return _rate_at(a, difference_root(a, b), R1, R2, b, k)


def _force(a, R1, R2, b, H, k):
    return _force_at(a, difference_root(a, b), R1, R2, b, H, k)


def _force_rate_at(a, root, R1, R2, b, H, k):
    """Derivative of the force."""
    return punch_stiffness(a, H, k) * _rate_at(a, root, R1, R2, b, k)


def _mean_pressure(a, R1, R2, b, H, k):
    return _force(a, R1, R2, b, H, k) / (np.pi * a * a) if a > 0.0 else 0.0


def _pressure(r, a, R1, R2, b, H, k):
    from ....._programs.bodies._runtime.graded.pressure import power_pressure, rim_pressure
    inside = np.minimum(r, a)
    growth = power_pressure(inside, a, 2.0, k) / (2 * R1) + rim_pressure(inside, a, b, k) * (R1 - R2) / (R1 * R2)
    return H / np.pi * growth if r < a else 0.0


def _displacement(r, a, R1, R2, b, k):
    from ....._programs.bodies._runtime.graded.displacement import power_displacement, rim_displacement
    return power_displacement(r, a, 2.0, k) / (2 * R1) + rim_displacement(r, a, b, k) * (R1 - R2) / (R1 * R2)


def _radius_from_depth(d, R1, R2, b, k):
    from ....._programs.bodies._runtime.graded.inverse import radius_across
    return radius_across(_depth_at, _rate_at, d, b, (R1, R2, b, k), 2.0, least=1.0 + k)


def _radius_from_force(F, R1, R2, b, H, k):
    from ....._programs.bodies._runtime.graded.inverse import radius_across
    return radius_across(_force_at, _force_rate_at, F, b, (R1, R2, b, H, k), 3.0 + k, least=1.0 + k)


def _force_from_depth(d, R1, R2, b, H, k):
    a = _radius_from_depth(d, R1, R2, b, k)
    return _force(a, R1, R2, b, H, k) + punch_force(d - _depth(a, R1, R2, b, k), a, H, k)


def _depth_from_force(F, R1, R2, b, H, k):
    a = _radius_from_force(F, R1, R2, b, H, k)
    return _depth(a, R1, R2, b, k) + punch_depth(F - _force(a, R1, R2, b, H, k), a, H, k)
