"""Bodies of axicontact.graded.normal.concave_power over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.punch import punch_pressure, punch_stiffness
from ....._programs.bodies._runtime.interface import either
from ....._programs.bodies._runtime.shapes.ring import lifted_at_zero_pressure
from ....._runtime.graded.growth import power_factor
from ....._runtime.plain import MATH as np


def _force(d, a, h, n, H, k):
    complete = _minimum_depth(a, h, n, k) * (1.0 - 1e-15) <= d
    return punch_stiffness(a, H, k) * (d + h * power_factor(n, k) * (1.0 + k) / (n + 1.0 + k)) if complete else np.nan


def _pressure(r, d, a, h, n, H, k):
    from ....._programs.bodies._runtime.graded.pressure import power_pressure
    complete = _minimum_depth(a, h, n, k) * (1.0 - 1e-15) <= d
    edge = (d + h * power_factor(n, k)) * punch_pressure(r, a, H, k)
    hollow = H / np.pi * h * power_pressure(np.minimum(r, a), a, n, k) / a ** n
    return (edge - hollow if r < a else edge) if complete else np.nan


def _displacement(r, d, a, h, n, k):
    from ....._programs.bodies._runtime.graded.displacement import power_sag, punch_share
    from .....normal import concave_power as normal
    complete = _minimum_depth(a, h, n, k) * (1.0 - 1e-15) <= d

    def outside():
        return d * punch_share(r, a, k) + h * power_sag(r, a, n, k) / a ** n
    value = either(r > a, outside, lambda: d - normal._profile(r, a=a, h=h, n=n))
    return value if complete else np.nan


def _depth_from_force(F, a, h, n, H, k):
    complete = _minimum_force(a, h, n, H, k) * (1.0 - 1e-15) <= F
    return F / punch_stiffness(a, H, k) - h * power_factor(n, k) * (1.0 + k) / (n + 1.0 + k) if complete else np.nan


def _minimum_depth(a, h, n, k):
    return h * power_factor(n, k) * (1.0 - k) / lifted_at_zero_pressure(n, k) + 0.0 * a


def _minimum_force(a, h, n, H, k):
    return punch_stiffness(a, H, k) * (_minimum_depth(a, h, n, k) + h * power_factor(n, k) * (1.0 + k) / (n + 1.0 + k))
