"""Bodies of axicontact.graded.normal.cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.growth import power_depth, power_force, power_mean, power_rate
from ....._programs.bodies._runtime.graded.punch import punch_stiffness
from ....._runtime.plain import MATH as np


def _depth(a, theta, k):
    return power_depth(a, 1.0, k) * np.tan(theta)


def _rate(a, theta, k):
    """Rate g'(a) of the depth."""
    return power_rate(a, 1.0, k) * np.tan(theta)


def _force(a, theta, H, k):
    growth = power_force(a, 1.0, k) * np.tan(theta)
    return 2.0 * H / (1.0 + k) * growth


def _mean_pressure(a, theta, H, k):
    growth = power_mean(a, 1.0, k) * np.tan(theta)
    return 2.0 * H / (1.0 + k) / np.pi * growth


def _pressure(r, a, theta, H, k):
    from ....._programs.bodies._runtime.graded.pressure import power_pressure
    inside = np.minimum(r, a)
    growth = power_pressure(inside, a, 1.0, k) * np.tan(theta)
    return H / np.pi * growth if r < a else 0.0


def _displacement(r, a, theta, k):
    from ....._programs.bodies._runtime.graded.displacement import power_displacement
    return power_displacement(r, a, 1.0, k) * np.tan(theta)


def _radius_from_depth(d, theta, k):
    return d / _depth(np.ones_like(d), theta, k)


def _radius_from_force(F, theta, H, k):
    return (F / _force(np.ones_like(F), theta, H, k)) ** (1.0 / (2.0 + k))


def _force_from_depth(d, theta, H, k):
    stiffness = punch_stiffness(_radius_from_depth(d, theta, k), H, k)
    return d * (stiffness * (1.0 / (1.0 + (1.0 + k)))) if (d > 0.0) & np.isfinite(d) else d


def _depth_from_force(F, theta, H, k):
    stiffness = punch_stiffness(_radius_from_force(F, theta, H, k), H, k)
    return F / (stiffness * (1.0 / (1.0 + (1.0 + k)))) if (F > 0.0) & np.isfinite(F) else F
