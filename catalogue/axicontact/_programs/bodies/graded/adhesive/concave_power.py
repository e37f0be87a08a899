"""Bodies of axicontact.graded.adhesive.concave_power over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.punch import graded_retraction, punch_stiffness, separation
from ....._runtime.graded.growth import power_factor
from ....._runtime.plain import MATH as np


def _pull_off_depth(a, h, n, H, k, dgamma):
    return -h * power_factor(n, k) - graded_retraction(a, H, k, dgamma)


def _pull_off_force(a, h, n, H, k, dgamma):
    return -punch_stiffness(a, H, k) * (h * power_factor(n, k) * n / (n + 1.0 + k) + graded_retraction(a, H, k, dgamma))


def _work_of_adhesion_from_pull_off(F, a, h, n, H, k):
    least = _pull_off_force(a, h, n, H, k, 0.0)
    return separation(least - F, a, H, k) if least >= F else np.nan
