"""Bodies of axicontact.graded.normal.power_law over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.growth import power_depth, power_force, power_mean, power_rate
from ....._programs.bodies._runtime.graded.punch import punch_stiffness
from ....._runtime.plain import MATH as np


def _depth(a, A, n, k):
    return A * power_depth(a, n, k)


def _rate(a, A, n, k):
    """Rate g'(a) of the depth."""
    return A * power_rate(a, n, k)


def _force(a, A, n, H, k):
    growth = A * power_force(a, n, k)
    return 2.0 * H / (1.0 + k) * growth


def _mean_pressure(a, A, n, H, k):
    growth = A * power_mean(a, n, k)
    return 2.0 * H / (1.0 + k) / np.pi * growth


def _pressure(r, a, A, n, H, k):
    from ....._programs.bodies._runtime.graded.pressure import power_pressure
    inside = np.minimum(r, a)
    growth = A * power_pressure(inside, a, n, k)
    return H / np.pi * growth if r < a else 0.0


def _displacement(r, a, A, n, k):
    from ....._programs.bodies._runtime.graded.displacement import power_displacement
    return A * power_displacement(r, a, n, k)


def _radius_from_depth(d, A, n, k):
    return (d / _depth(np.ones_like(d), A, n, k)) ** (1.0 / n)


def _radius_from_force(F, A, n, H, k):
    return (F / _force(np.ones_like(F), A, n, H, k)) ** (1.0 / (n + (1.0 + k)))


def _force_from_depth(d, A, n, H, k):
    stiffness = punch_stiffness(_radius_from_depth(d, A, n, k), H, k)
    return d * (stiffness * (n / (n + (1.0 + k)))) if (d > 0.0) & np.isfinite(d) else d


def _depth_from_force(F, A, n, H, k):
    stiffness = punch_stiffness(_radius_from_force(F, A, n, H, k), H, k)
    return F / (stiffness * (n / (n + (1.0 + k)))) if (F > 0.0) & np.isfinite(F) else F
