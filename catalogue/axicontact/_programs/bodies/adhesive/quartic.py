"""Bodies of axicontact.adhesive.quartic over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import quartic as normal
from ...._programs.bodies._runtime.functions import nth_root
from ...._programs.bodies._runtime.physics.adhesion import power_law_radius
from ...._runtime.plain import MATH as np

XI = {'force': 3.0, 'depth': 1.0}


def _pull_off_radius(A, E_star, dgamma, control):
    if control == 'force':
        radius = nth_root(1 / A, 7) ** 2 * nth_root(81 * np.pi * dgamma / (2048 * E_star), 7)
    else:
        radius = nth_root(1 / A, 7) ** 2 * nth_root(9 * np.pi * dgamma / (2048 * E_star), 7)
    return radius if dgamma > 0.0 else 0.0


def _pull_off_depth(a, A, E_star, dgamma, control):
    """With the retraction 2 a g'(a)/xi of pull-off, free of cancellation."""
    return normal._depth(a, A) * (1.0 - 8.0 / XI[control])


def _radius_from_depth(d, A, E_star, dgamma):
    a_c = _pull_off_radius(A, E_star, dgamma, control='depth')
    least = _pull_off_depth(a_c, A, E_star, dgamma, control='depth')
    plain = normal._radius_from_depth(np.maximum(d, 0.0), A)
    return power_law_radius(d, a_c, least, 4.0, 0.5, plain)


def _pull_off_force(a, A, E_star, dgamma, control):
    """With the retraction 2 a g'(a)/xi of pull-off, free of cancellation."""
    return normal._force(a, A, E_star) * (1.0 - 10.0 / XI[control])


def _radius_from_force(F, A, E_star, dgamma):
    a_c = _pull_off_radius(A, E_star, dgamma, control='force')
    least = _pull_off_force(a_c, A, E_star, dgamma, control='force')
    plain = normal._radius_from_force(np.maximum(F, 0.0), A, E_star)
    return power_law_radius(F, a_c, least, 5.0, 1.5, plain)
