"""Formulas of axicontact.graded.adhesive.concave_paraboloid over an array library `xp`."""

from ....._programs.expressions._runtime.graded.growth import power_factor
from ....._programs.expressions._runtime.graded.punch import graded_retraction as retraction
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions._runtime.graded.punch import separation


def pull_off_force(xp, a, h, H, k, dgamma):
    v9 = h * power_factor(xp, 2.0, k) * 2.0 / (3.0 + k) + retraction(xp, a, H, k, dgamma)
    return -punch_stiffness(xp, a, H, k) * v9


def work_of_adhesion_from_pull_off(xp, F, a, h, H, k):
    v1 = pull_off_force(xp, a, h, H, k, 0.0)
    v2 = v1 >= F
    v6 = xp.where(v2, 0.5 * F, v1)
    return xp.where(v2, separation(xp, xp.where(v2, v1, 2.0 * F) - F, a, H, k), xp.nan)
