"""Bodies of axicontact.graded.normal.cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.growth import power_depth, power_force, power_mean, power_rate
from .....graded.normal.cone import Array
from ....._runtime.plain import MATH as np


def _depth(a: Array, theta: Array, k: Array) -> Array:
    return power_depth(a, 1.0, k) * np.tan(theta)


def _rate(a: Array, theta: Array, k: Array) -> Array:
    """Rate g'(a) of the depth."""
    return power_rate(a, 1.0, k) * np.tan(theta)


def _force(a: Array, theta: Array, H: Array, k: Array) -> Array:
    growth = power_force(a, 1.0, k) * np.tan(theta)
    return 2.0 * H / (1.0 + k) * growth


def _mean_pressure(a: Array, theta: Array, H: Array, k: Array) -> Array:
    growth = power_mean(a, 1.0, k) * np.tan(theta)
    return 2.0 * H / (1.0 + k) / np.pi * growth


def _pressure(r: Array, a: Array, theta: Array, H: Array, k: Array) -> Array:
    from ....._programs.bodies._runtime.graded.pressure import power_pressure
    inside = np.minimum(r, a)
    growth = power_pressure(inside, a, 1.0, k) * np.tan(theta)
    return H / np.pi * growth if r < a else 0.0


def _displacement(r: Array, a: Array, theta: Array, k: Array) -> Array:
    from ....._programs.bodies._runtime.graded.displacement import power_displacement
    return power_displacement(r, a, 1.0, k) * np.tan(theta)


def _radius_from_depth(d: Array, theta: Array, k: Array) -> Array:
    return d / _depth(np.ones_like(d), theta, k)


def _radius_from_force(F: Array, theta: Array, H: Array, k: Array) -> Array:
    return (F / _force(np.ones_like(F), theta, H, k)) ** (1.0 / (2.0 + k))


def _force_from_depth(d: Array, theta: Array, H: Array, k: Array) -> Array:
    return _force(_radius_from_depth(d, theta, k), theta, H, k)


def _depth_from_force(F: Array, theta: Array, H: Array, k: Array) -> Array:
    return _depth(_radius_from_force(F, theta, H, k), theta, k)
