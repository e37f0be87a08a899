"""Bodies of axicontact.graded.normal.gaussian over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.growth import gaussian_depth, gaussian_force, gaussian_rate
from ....._programs.bodies._runtime.graded.punch import punch_depth, punch_force, punch_stiffness
from ....._runtime.plain import MATH as np


def _depth(a, h, s, k):
    growth = h * gaussian_depth(a, s, k)
    return growth if _rate(a, h, s, k) >= 0.0 else np.nan


def _rate(a, h, s, k):
    """Rate g'(a) of the depth."""
    return h * gaussian_rate(a, s, k)


def _force(a, h, s, H, k):
    growth = h * gaussian_force(a, s, k)
    return 2.0 * H / (1.0 + k) * growth if _rate(a, h, s, k) >= 0.0 else np.nan


def _force_rate(a, h, s, H, k):
    """Derivative of the force."""
    return punch_stiffness(a, H, k) * _rate(a, h, s, k)


def _mean_pressure(a, h, s, H, k):
    return _force(a, h, s, H, k) / (np.pi * a * a) if a > 0.0 else 0.0


def _displacement(r, a, h, s, k):
    from ....._programs.bodies._runtime.graded.displacement import gaussian_displacement
    return h * gaussian_displacement(r, a, s, k)


def _radius_from_depth(d, h, s, k):
    from ....._runtime.graded.inverse import gaussian_reach
    from ....._programs.bodies._runtime.graded.inverse import radius_up_to
    from ....._programs.bodies._runtime.physics.unknowns import on_the_bump
    return radius_up_to(_depth, _rate, d, gaussian_reach(s, k), (h, s, k), on_the_bump(s))


def _radius_from_force(F, h, s, H, k):
    from ....._runtime.graded.inverse import gaussian_reach
    from ....._programs.bodies._runtime.graded.inverse import radius_up_to
    from ....._programs.bodies._runtime.physics.unknowns import on_the_bump
    return radius_up_to(_force, _force_rate, F, gaussian_reach(s, k), (h, s, H, k), on_the_bump(s))


def _force_from_depth(d, h, s, H, k):
    a = _radius_from_depth(d, h, s, k)
    return _force(a, h, s, H, k) + punch_force(d - _depth(a, h, s, k), a, H, k)


def _depth_from_force(F, h, s, H, k):
    a = _radius_from_force(F, h, s, H, k)
    return _depth(a, h, s, k) + punch_depth(F - _force(a, h, s, H, k), a, H, k)
