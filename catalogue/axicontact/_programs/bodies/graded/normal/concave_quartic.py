"""Bodies of axicontact.graded.normal.concave_quartic over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.punch import punch_stiffness
from ....._programs.bodies._runtime.interface import either
from ....._runtime.graded.growth import power_factor
from ....._runtime.plain import MATH as np


def _force(d, a, h, H, k):
    complete = _minimum_depth(a, h, k) * (1.0 - 1e-15) <= d
    return punch_stiffness(a, H, k) * (d + h * power_factor(4.0, k) * (1.0 + k) / (4.0 + 1.0 + k)) if complete else np.nan


def _displacement(r, d, a, h, k):
    from ....._programs.bodies._runtime.graded.displacement import power_sag, punch_share
    from .....normal import concave_quartic as normal
    complete = _minimum_depth(a, h, k) * (1.0 - 1e-15) <= d

    def outside():
        return d * punch_share(r, a, k) + h * power_sag(r, a, 4.0, k) / a ** 4.0
    value = either(r > a, outside, lambda: d - normal._profile(r, a=a, h=h))
    return value if complete else np.nan


def _depth_from_force(F, a, h, H, k):
    complete = _minimum_force(a, h, H, k) * (1.0 - 1e-15) <= F
    return F / punch_stiffness(a, H, k) - h * power_factor(4.0, k) * (1.0 + k) / (4.0 + 1.0 + k) if complete else np.nan


def _minimum_depth(a, h, k):
    v8 = k + 1.0
    return -4.0 * h * (k - 1.0) / (v8 * v8 * (k + 3.0)) + 0.0 * a


def _minimum_force(a, h, H, k):
    return punch_stiffness(a, H, k) * (_minimum_depth(a, h, k) + h * power_factor(4.0, k) * (1.0 + k) / (4.0 + 1.0 + k))
