"""Bodies of axicontact.adhesive.power_law over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import power_law as normal
from ...._programs.bodies._runtime.functions import nth_root
from ...._programs.bodies._runtime.physics.adhesion import power_law_radius
from ...._programs.bodies._runtime.special import gamma_ratio
from ...._runtime.plain import MATH as np

XI = {'force': 3.0, 'depth': 1.0}


def _pull_off_radius(A, n, E_star, dgamma, control):
    kappa = gamma_ratio(n / 2 + 1 / 2)
    if control == 'force':
        ratio = 3 * np.sqrt(2 * dgamma / E_star) / (2 * n * A * kappa)
        radius = nth_root(ratio, 2 * n - 1) ** 2
    else:
        ratio = np.sqrt(2 * dgamma / E_star) / (2 * n * A * kappa)
        radius = nth_root(ratio, 2 * n - 1) ** 2
    return (radius if dgamma > 0.0 else 0.0) if n > 0.5 else np.nan


def _pull_off_depth(a, A, n, E_star, dgamma, control):
    """With the retraction 2 a g'(a)/xi of pull-off, free of cancellation."""
    return normal._depth(a, A, n) * (1.0 - 2 * n / XI[control])


def _radius_from_depth(d, A, n, E_star, dgamma):
    a_c = _pull_off_radius(A, n, E_star, dgamma, control='depth')
    least = _pull_off_depth(a_c, A, n, E_star, dgamma, control='depth')
    plain = normal._radius_from_depth(np.maximum(d, 0.0), A, n)
    return power_law_radius(d, a_c, least, n, 0.5, plain)


def _pull_off_force(a, A, n, E_star, dgamma, control):
    """With the retraction 2 a g'(a)/xi of pull-off, free of cancellation."""
    return normal._force(a, A, n, E_star) * (1.0 - 2 * (n + 1) / XI[control])


def _radius_from_force(F, A, n, E_star, dgamma):
    a_c = _pull_off_radius(A, n, E_star, dgamma, control='force')
    least = _pull_off_force(a_c, A, n, E_star, dgamma, control='force')
    plain = normal._radius_from_force(np.maximum(F, 0.0), A, n, E_star)
    return power_law_radius(F, a_c, least, n + 1, 1.5, plain)
