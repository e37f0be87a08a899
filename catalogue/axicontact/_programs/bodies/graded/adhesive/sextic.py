"""Bodies of axicontact.graded.adhesive.sextic over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies.graded.normal import sextic as normal
from ....._programs.bodies._runtime.graded.punch import graded_retraction, punch_displacement, punch_stiffness, separation, stationary, tension, unloading_radius
from ....._programs.bodies._runtime.physics.adhesion import power_law_radius
from ....._runtime.plain import MATH as np


def _depth(a, A, H, k, dgamma):
    return normal._depth(a, A, k) - graded_retraction(a, H, k, dgamma)


def _force(a, A, H, k, dgamma):
    return normal._force(a, A, H, k) - punch_stiffness(a, H, k) * graded_retraction(a, H, k, dgamma)


def _pressure(r, a, A, H, k, dgamma):
    return normal._pressure(r, a, A, H, k) - tension(r, a, H, k, dgamma)


def _displacement(r, a, A, H, k, dgamma):
    return normal._displacement(r, a, A, k) - graded_retraction(a, H, k, dgamma) * punch_displacement(r, a, k)


def _pull_off_radius(A, H, k, dgamma, control):
    rate = normal._rate(np.ones_like(H * k), A, k)
    own = unloading_radius(rate, 6.0, H, k, dgamma, control)
    return own if dgamma > 0.0 else 0.0


def _pull_off_depth(a, A, H, k, dgamma, control):
    """With the retraction 2 a g'(a)/xi of pull-off, free of cancellation."""
    return normal._depth(a, A, k) * (1.0 - 2.0 * 6.0 / stationary(control, k))


def _radius_from_depth(d, A, H, k, dgamma):
    a_c = _pull_off_radius(A, H, k, dgamma, control='depth')
    least = _pull_off_depth(a_c, A, H, k, dgamma, control='depth')
    plain = normal._radius_from_depth(np.maximum(d, 0.0), A, k)
    return power_law_radius(d, a_c, least, 6.0, (1.0 - k) / 2.0, plain)


def _pull_off_force(a, A, H, k, dgamma, control):
    """With the retraction 2 a g'(a)/xi of pull-off, free of cancellation."""
    return normal._force(a, A, H, k) * (1.0 - 2.0 * (6.0 + 1.0 + k) / stationary(control, k))


def _radius_from_force(F, A, H, k, dgamma):
    a_c = _pull_off_radius(A, H, k, dgamma, control='force')
    least = _pull_off_force(a_c, A, H, k, dgamma, control='force')
    plain = normal._radius_from_force(np.maximum(F, 0.0), A, H, k)
    return power_law_radius(F, a_c, least, 6.0 + 1.0 + k, (3.0 + k) / 2.0, plain)


def _work_of_adhesion_from_pull_off(F, A, H, k):
    pull = -F if F < 0.0 else np.nan
    lasting = pull * (k + 3) / (k + 11)
    a = normal._radius_from_force(lasting, A, H, k)
    return 0.0 if F == 0.0 else separation(pull + lasting, a, H, k)
