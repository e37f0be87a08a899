"""Bodies of axicontact.graded.adhesive.polynomial over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies.graded.normal import polynomial as normal
from ....._programs.bodies._runtime.graded.punch import graded_retraction, growth_of, held, least_steepness, pull_of, punch_displacement, punch_stiffness, separation, tension
from ....._runtime.physics.single import branches, lowest
from .....graded.adhesive.polynomial import _held_samples, _samples
from ....._runtime.plain import MATH as np


def _depth(a, A, H, k, dgamma):
    return normal._depth(a, A, k) - graded_retraction(a, H, k, dgamma)


def _force(a, A, H, k, dgamma):
    return normal._force(a, A, H, k) - punch_stiffness(a, H, k) * graded_retraction(a, H, k, dgamma)


def _pressure(r, a, A, H, k, dgamma):
    return normal._pressure(r, a, A, H, k) - tension(r, a, H, k, dgamma)


def _displacement(r, a, A, H, k, dgamma):
    return normal._displacement(r, a, A, k) - graded_retraction(a, H, k, dgamma) * punch_displacement(r, a, k)


def _branches(A, H, k, dgamma, control):
    return branches(lambda a: a ** ((1.0 + k) / 2.0) * normal._rate(a, A, k), _samples(A, k), least_steepness(control, H, k, dgamma))


def _pull_off_radius(A, H, k, dgamma, control):
    found = _branches(A, H, k, dgamma, control)
    load = _force if control == 'force' else _depth
    return lowest(found, lambda a: load(a, A, H, k, dgamma))


def _radius_from_depth(d, A, H, k, dgamma):
    from ....._programs.bodies._runtime.physics.stable import stable_radius
    from ....._programs.bodies._runtime.physics.unknowns import radius_itself
    found = _branches(A, H, k, dgamma, control='depth')
    slope = growth_of(normal._rate, (A, k), H, k, dgamma, control='depth')
    pulled = pull_of(H, k, dgamma, control='depth')
    return stable_radius(d, found, lambda a: _depth(a, A, H, k, dgamma), slope, pulled, radius_itself())


def _radius_from_force(F, A, H, k, dgamma):
    from ....._programs.bodies._runtime.physics.stable import stable_radius
    from ....._programs.bodies._runtime.physics.unknowns import radius_itself
    found = _branches(A, H, k, dgamma, control='force')
    slope = growth_of(normal._rate, (A, k), H, k, dgamma, control='force')
    pulled = pull_of(H, k, dgamma, control='force')
    return stable_radius(F, found, lambda a: _force(a, A, H, k, dgamma), slope, pulled, radius_itself())


def _work_of_adhesion_from_pull_off(F, A, H, k):
    pull = -F if F < 0.0 else np.nan
    found = branches(lambda a: held(a, normal._rate(a, A, k), normal._force(a, A, 1.0, k), k), _held_samples(A, k), pull / H)
    a = lowest(found, lambda a: separation(pull + normal._force(a, A, H, k), a, H, k))
    work = separation(pull + normal._force(a, A, H, k), a, H, k)
    return 0.0 if F == 0.0 else work
