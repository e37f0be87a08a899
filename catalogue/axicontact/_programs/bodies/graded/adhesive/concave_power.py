"""Bodies of axicontact.graded.adhesive.concave_power over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.punch import graded_retraction, punch_stiffness
from ....._runtime.graded.growth import power_factor


def _pull_off_depth(a, h, n, H, k, dgamma):
    return -h * power_factor(n, k) - graded_retraction(a, H, k, dgamma)


def _pull_off_force(a, h, n, H, k, dgamma):
    return -punch_stiffness(a, H, k) * (h * power_factor(n, k) * n / (n + 1.0 + k) + graded_retraction(a, H, k, dgamma))
