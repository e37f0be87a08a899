"""Bodies of axicontact.adhesive.cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import cone as normal
from ...._programs.bodies._runtime.physics.adhesion import power_law_radius
from ...._runtime.plain import MATH as np

XI = {'force': 3.0, 'depth': 1.0}


def _pull_off_radius(theta, E_star, dgamma, control):
    if control == 'force':
        radius = 18 * dgamma / (np.pi * E_star * np.tan(theta) ** 2)
    else:
        radius = 2 * dgamma / (np.pi * E_star * np.tan(theta) ** 2)
    return radius if dgamma > 0.0 else 0.0


def _pull_off_depth(a, theta, E_star, dgamma, control):
    """With the retraction 2 a g'(a)/xi of pull-off, free of cancellation."""
    return normal._depth(a, theta) * (1.0 - 2.0 / XI[control])


def _radius_from_depth(d, theta, E_star, dgamma):
    a_c = _pull_off_radius(theta, E_star, dgamma, control='depth')
    least = _pull_off_depth(a_c, theta, E_star, dgamma, control='depth')
    plain = normal._radius_from_depth(np.maximum(d, 0.0), theta)
    return power_law_radius(d, a_c, least, 1.0, 0.5, plain)


def _pull_off_force(a, theta, E_star, dgamma, control):
    """With the retraction 2 a g'(a)/xi of pull-off, free of cancellation."""
    return normal._force(a, theta, E_star) * (1.0 - 4.0 / XI[control])


def _radius_from_force(F, theta, E_star, dgamma):
    a_c = _pull_off_radius(theta, E_star, dgamma, control='force')
    least = _pull_off_force(a_c, theta, E_star, dgamma, control='force')
    plain = normal._radius_from_force(np.maximum(F, 0.0), theta, E_star)
    return power_law_radius(F, a_c, least, 2.0, 1.5, plain)
