"""Bodies of axicontact.adhesive.paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import paraboloid as normal
from ...._programs.bodies._runtime.physics.adhesion import power_law_radius
from ...._runtime.plain import MATH as np

XI = {'force': 3.0, 'depth': 1.0}


def _pull_off_radius(R, E_star, dgamma, control):
    if control == 'force':
        radius = np.cbrt(9 * np.pi * R ** 2 * dgamma / (8 * E_star))
    else:
        radius = np.cbrt(np.pi * R ** 2 * dgamma / (8 * E_star))
    return radius if dgamma > 0.0 else 0.0


def _pull_off_depth(a, R, E_star, dgamma, control):
    """With the retraction 2 a g'(a)/xi of pull-off, free of cancellation."""
    return normal._depth(a, R) * (1.0 - 4.0 / XI[control])


def _radius_from_depth(d, R, E_star, dgamma):
    a_c = _pull_off_radius(R, E_star, dgamma, control='depth')
    least = _pull_off_depth(a_c, R, E_star, dgamma, control='depth')
    plain = normal._radius_from_depth(np.maximum(d, 0.0), R)
    return power_law_radius(d, a_c, least, 2.0, 0.5, plain)


def _pull_off_force(a, R, E_star, dgamma, control):
    """With the retraction 2 a g'(a)/xi of pull-off, free of cancellation."""
    return normal._force(a, R, E_star) * (1.0 - 6.0 / XI[control])


def _radius_from_force(F, R, E_star, dgamma):
    a_c = _pull_off_radius(R, E_star, dgamma, control='force')
    least = _pull_off_force(a_c, R, E_star, dgamma, control='force')
    plain = normal._radius_from_force(np.maximum(F, 0.0), R, E_star)
    return power_law_radius(F, a_c, least, 3.0, 1.5, plain)
