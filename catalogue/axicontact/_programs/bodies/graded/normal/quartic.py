"""Bodies of axicontact.graded.normal.quartic over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.growth import power_depth, power_force, power_mean, power_rate
from .....graded.normal.quartic import Array
from ....._runtime.plain import MATH as np


def _depth(a: Array, A: Array, k: Array) -> Array:
    return A * power_depth(a, 4.0, k)


def _rate(a: Array, A: Array, k: Array) -> Array:
    """Rate g'(a) of the depth."""
    return A * power_rate(a, 4.0, k)


def _force(a: Array, A: Array, H: Array, k: Array) -> Array:
    growth = A * power_force(a, 4.0, k)
    return 2.0 * H / (1.0 + k) * growth


def _mean_pressure(a: Array, A: Array, H: Array, k: Array) -> Array:
    growth = A * power_mean(a, 4.0, k)
    return 2.0 * H / (1.0 + k) / np.pi * growth


def _pressure(r: Array, a: Array, A: Array, H: Array, k: Array) -> Array:
    from ....._programs.bodies._runtime.graded.pressure import power_pressure
    inside = np.minimum(r, a)
    growth = A * power_pressure(inside, a, 4.0, k)
    return H / np.pi * growth if r < a else 0.0


def _displacement(r: Array, a: Array, A: Array, k: Array) -> Array:
    from ....._programs.bodies._runtime.graded.displacement import power_displacement
    return A * power_displacement(r, a, 4.0, k)


def _radius_from_depth(d: Array, A: Array, k: Array) -> Array:
    return (d / _depth(np.ones_like(d), A, k)) ** (1.0 / 4.0)


def _radius_from_force(F: Array, A: Array, H: Array, k: Array) -> Array:
    return (F / _force(np.ones_like(F), A, H, k)) ** (1.0 / (5.0 + k))


def _force_from_depth(d: Array, A: Array, H: Array, k: Array) -> Array:
    return _force(_radius_from_depth(d, A, k), A, H, k)


def _depth_from_force(F: Array, A: Array, H: Array, k: Array) -> Array:
    return _depth(_radius_from_force(F, A, H, k), A, k)
