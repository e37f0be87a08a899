"""Bodies of axicontact.graded.adhesive.truncated_cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies.graded.normal import truncated_cone as normal
from ....._programs.bodies._runtime.graded.punch import graded_retraction, growth_of, held, least_steepness, pull_of, punch_displacement, punch_stiffness, separation
from ....._programs.bodies._runtime.physics.branches import exponent_of, stress_at
from ....._runtime.physics.single import branches, lowest
from .....graded.adhesive.truncated_cone import _held_samples, _samples
from ....._runtime.plain import MATH as np


def _depth(a, theta, b, H, k, dgamma):
    return normal._depth(a, theta, b, k) - graded_retraction(a, H, k, dgamma)


def _force(a, theta, b, H, k, dgamma):
    return normal._force(a, theta, b, H, k) - punch_stiffness(a, H, k) * graded_retraction(a, H, k, dgamma)


def _displacement(r, a, theta, b, H, k, dgamma):
    return normal._displacement(r, a, theta, b, k) - graded_retraction(a, H, k, dgamma) * punch_displacement(r, a, k)


def _branches(theta, b, H, k, dgamma, control):
    return branches(lambda a: a ** ((1.0 + k) / 2.0) * normal._rate(a, theta, b, k), _samples(theta, b, k), least_steepness(control, H, k, dgamma))


def _pull_off_radius(theta, b, H, k, dgamma, control):
    unit = exponent_of(b)
    stress, H = stress_at(unit, H, k)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    found = _branches(theta, b, H, k, dgamma, control)
    load = _force if control == 'force' else _depth
    radius = lowest(found, lambda a: load(a, theta, b, H, k, dgamma))
    return np.ldexp(radius, unit)


def _radius_from_depth(d, theta, b, H, k, dgamma):
    from ....._programs.bodies._runtime.physics.stable import stable_radius
    from ....._programs.bodies._runtime.physics.unknowns import beyond_edge, radius_itself
    unit = exponent_of(b)
    stress, H = stress_at(unit, H, k)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    d = np.ldexp(d, -unit)
    found = _branches(theta, b, H, k, dgamma, control='depth')
    slope = growth_of(normal._rate, (theta, b, k), H, k, dgamma, control='depth')
    pulled = pull_of(H, k, dgamma, control='depth')
    radius = stable_radius(d, found, lambda a: _depth(a, theta, b, H, k, dgamma), slope, pulled, radius_itself(), beyond_edge(b, 1.0 + k))
    return np.ldexp(radius, unit)


def _radius_from_force(F, theta, b, H, k, dgamma):
    from ....._programs.bodies._runtime.physics.stable import stable_radius
    from ....._programs.bodies._runtime.physics.unknowns import beyond_edge, radius_itself
    unit = exponent_of(b)
    stress, H = stress_at(unit, H, k)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    F = np.ldexp(F, -(stress + 2 * unit))
    found = _branches(theta, b, H, k, dgamma, control='force')
    slope = growth_of(normal._rate, (theta, b, k), H, k, dgamma, control='force')
    pulled = pull_of(H, k, dgamma, control='force')
    radius = stable_radius(F, found, lambda a: _force(a, theta, b, H, k, dgamma), slope, pulled, radius_itself(), beyond_edge(b, 1.0 + k))
    return np.ldexp(radius, unit)


def _work_of_adhesion_from_pull_off(F, theta, b, H, k):
    unit = exponent_of(b)
    stress, H = stress_at(unit, H, k)
    b = np.ldexp(b, -unit)
    F = np.ldexp(F, -(stress + 2 * unit))
    pull = -F if F < 0.0 else np.nan
    found = branches(lambda a: held(a, normal._rate(a, theta, b, k), normal._force(a, theta, b, 1.0, k), k), _held_samples(theta, b, k), pull / H)
    a = lowest(found, lambda a: separation(pull + normal._force(a, theta, b, H, k), a, H, k))
    work = separation(pull + normal._force(a, theta, b, H, k), a, H, k)
    return 0.0 if F == 0.0 else np.ldexp(work, stress + unit)
