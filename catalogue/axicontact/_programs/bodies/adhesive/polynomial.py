"""Bodies of axicontact.adhesive.polynomial over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import polynomial as normal
from ...._programs.bodies._runtime.physics.adhesion import held, hess_retraction, least_steepness, lift, pull, separation, tension
from ...._programs.bodies._runtime.physics.stable import growth, stable_radius
from ...._programs.bodies._runtime.physics.unknowns import radius_itself
from ...._runtime.physics.single import branches, lowest
from ....adhesive.polynomial import _held_samples, _samples
from ...._runtime.plain import MATH as np


def _depth(a, A, E_star, dgamma):
    return normal._depth(a, A) - hess_retraction(a, E_star, dgamma)


def _force(a, A, E_star, dgamma):
    return normal._force(a, A, E_star) - pull(a, E_star, dgamma)


def _pressure(r, a, A, E_star, dgamma):
    return normal._pressure(r, a, A, E_star) - tension(r, a, E_star, dgamma)


def _displacement(r, a, A, E_star, dgamma):
    return normal._displacement(r, a, A) - lift(r, a, E_star, dgamma)


def _rate(a, A):
    """Derivative g'(a) of the depth without adhesion."""
    return normal._slope(a, A)


def _branches(A, E_star, dgamma, control):
    return branches(lambda a: np.sqrt(a) * _rate(a, A), _samples(A), least_steepness(control, E_star, dgamma))


def _pull_off_radius(A, E_star, dgamma, control):
    found = _branches(A, E_star, dgamma, control)
    load = _force if control == 'force' else _depth
    return lowest(found, lambda a: load(a, A, E_star, dgamma))


def _radius_from_depth(d, A, E_star, dgamma):
    found = _branches(A, E_star, dgamma, control='depth')
    return stable_radius(d, found, lambda a: _depth(a, A, E_star, dgamma), lambda a: growth(_rate(a, A), a, 'depth', E_star, dgamma), lambda a: hess_retraction(a, E_star, dgamma), radius_itself())


def _radius_from_force(F, A, E_star, dgamma):
    found = _branches(A, E_star, dgamma, control='force')
    return stable_radius(F, found, lambda a: _force(a, A, E_star, dgamma), lambda a: growth(_rate(a, A), a, 'force', E_star, dgamma), lambda a: pull(a, E_star, dgamma), radius_itself())


def _work_of_adhesion_from_pull_off(F, A, E_star):
    pull = -F if F < 0.0 else np.nan
    found = branches(lambda a: held(a, _rate(a, A), normal._force(a, A, 1.0)), _held_samples(A), pull / E_star)
    a = lowest(found, lambda a: separation(pull + normal._force(a, A, E_star), a, E_star))
    work = separation(pull + normal._force(a, A, E_star), a, E_star)
    return 0.0 if F == 0.0 else work
