"""Bodies of axicontact.graded.normal.polynomial over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.growth import power_depth, power_force, power_mean, power_rate
from ....._programs.bodies._runtime.graded.punch import punch_depth, punch_force, punch_stiffness
from ....._runtime.plain import MATH as np


def _depth(a, A, k):
    return sum((A_j * power_depth(a, j, k) for j, A_j in enumerate(A, 1)))


def _rate(a, A, k):
    """Rate g'(a) of the depth."""
    return sum((A_j * power_rate(a, j, k) for j, A_j in enumerate(A, 1)))


def _force(a, A, H, k):
    growth = sum((A_j * power_force(a, j, k) for j, A_j in enumerate(A, 1)))
    return 2.0 * H / (1.0 + k) * growth


def _force_rate(a, A, H, k):
    """Derivative of the force."""
    return punch_stiffness(a, H, k) * _rate(a, A, k)


def _mean_pressure(a, A, H, k):
    growth = sum((A_j * power_mean(a, j, k) for j, A_j in enumerate(A, 1)))
    return 2.0 * H / (1.0 + k) / np.pi * growth


def _pressure(r, a, A, H, k):
    from ....._programs.bodies._runtime.graded.pressure import power_pressure
    inside = np.minimum(r, a)
    growth = sum((A_j * power_pressure(inside, a, j, k) for j, A_j in enumerate(A, 1) if A_j))
    return H / np.pi * growth if r < a else 0.0


def _displacement(r, a, A, k):
    from ....._programs.bodies._runtime.graded.displacement import power_displacement
    return sum((A_j * power_displacement(r, a, j, k) for j, A_j in enumerate(A, 1)))


def _radius_from_depth(d, A, k):
    from ....._programs.bodies._runtime.graded.inverse import radius_to
    return radius_to(_depth, _rate, d, 1.0, (A, k))


def _radius_from_force(F, A, H, k):
    from ....._programs.bodies._runtime.graded.inverse import radius_to
    return radius_to(_force, _force_rate, F, 1.0, (A, H, k))


def _force_from_depth(d, A, H, k):
    a = _radius_from_depth(d, A, k)
    return _force(a, A, H, k) + punch_force(d - _depth(a, A, k), a, H, k)


def _depth_from_force(F, A, H, k):
    a = _radius_from_force(F, A, H, k)
    return _depth(a, A, k) + punch_depth(F - _force(a, A, H, k), a, H, k)
