"""Bodies of axicontact.graded.normal.concave_power over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.punch import punch_pressure, punch_stiffness
from ....._programs.bodies._runtime.shapes.ring import lifted_at_zero_pressure
from .....graded.normal.concave_power import Array, power_factor
from ....._runtime.plain import MATH as np


def _force(d: Array, a: Array, h: Array, n: Array, H: Array, k: Array) -> Array:
    complete = _minimum_depth(a, h, n, k) * (1.0 - 1e-15) <= d
    return punch_stiffness(a, H, k) * (d + h * power_factor(n, k) * (1.0 + k) / (n + 1.0 + k)) if complete else np.nan


def _pressure(r: Array, d: Array, a: Array, h: Array, n: Array, H: Array, k: Array) -> Array:
    from ....._programs.bodies._runtime.graded.pressure import power_pressure
    complete = _minimum_depth(a, h, n, k) * (1.0 - 1e-15) <= d
    edge = (d + h * power_factor(n, k)) * punch_pressure(r, a, H, k)
    hollow = H / np.pi * h * power_pressure(np.minimum(r, a), a, n, k) / a ** n
    return (edge - hollow if r < a else edge) if complete else np.nan


def _displacement(r: Array, d: Array, a: Array, h: Array, n: Array, k: Array) -> Array:
    from ....._programs.bodies._runtime.graded.displacement import power_sag, punch_share
    from .....normal import concave_power as normal
    complete = _minimum_depth(a, h, n, k) * (1.0 - 1e-15) <= d
    outside = d * punch_share(r, a, k) + h * power_sag(r, a, n, k) / a ** n
    return (outside if r > a else d - normal._profile(r, a=a, h=h, n=n)) if complete else np.nan


def _depth_from_force(F: Array, a: Array, h: Array, n: Array, H: Array, k: Array) -> Array:
    complete = _minimum_force(a, h, n, H, k) * (1.0 - 1e-15) <= F
    return F / punch_stiffness(a, H, k) - h * power_factor(n, k) * (1.0 + k) / (n + 1.0 + k) if complete else np.nan


def _minimum_depth(a: Array, h: Array, n: Array, k: Array) -> Array:
    return h * power_factor(n, k) * (1.0 - k) / lifted_at_zero_pressure(n, k) + 0.0 * a


def _minimum_force(a: Array, h: Array, n: Array, H: Array, k: Array) -> Array:
    return punch_stiffness(a, H, k) * (_minimum_depth(a, h, n, k) + h * power_factor(n, k) * (1.0 + k) / (n + 1.0 + k))
