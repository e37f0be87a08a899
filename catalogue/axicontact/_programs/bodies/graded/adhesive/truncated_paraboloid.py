"""Bodies of axicontact.graded.adhesive.truncated_paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import nan, pow

from ....._programs.bodies.graded.normal import truncated_paraboloid as normal
from ....._programs.bodies._runtime.graded.punch import graded_retraction, growth_of, held, least_steepness, pull_of, punch_displacement, separation, tension
from ....._programs.bodies._runtime.physics.branches import exponent_of, stress_at
from ....._runtime.physics.single import branches, lowest
from .....graded.adhesive.truncated_paraboloid import _held_samples, _samples
from ....._runtime.plain import sqrt, MATH as np


def _depth(a, R, b, H, k, dgamma):
    if a >= b:
        v7 = a - b
        v13 = sqrt((v7 if v7 > 0.0 or v7 != v7 else 0.0) * (a + b)) / a
        v27 = (a * a * (v13 * pow(v13, k) if v13 > 0.0 else 0.0) / (1.0 + k) + 0.0 * b) / R
    else:
        v27 = nan
    return v27 - (sqrt(6.283185307179586 * dgamma / H) * sqrt(a) * sqrt(pow(a, -k)) if a > 0.0 else 0.0)


def _force(a, R, b, H, k, dgamma):
    v16 = a > 0.0
    v19 = a * pow(a, k) if v16 else 0.0
    v29 = 1.0 + k
    v41 = 2.0 * H / v29
    if a >= b:
        v7 = a - b
        v14 = sqrt((v7 if v7 > 0.0 or v7 != v7 else 0.0) * (a + b)) / (a if a > b or a != a else b)
        v27 = 3.0 + k
        v44 = v41 * ((a * a * v19 * (v14 * pow(v14, k) if v14 > 0.0 else 0.0) * (v27 - v29 * (v14 * v14)) / (v29 * v27) + 0.0 * b) / R)
    else:
        v44 = nan
    return v44 - v41 * v19 * (sqrt(6.283185307179586 * dgamma / H) * sqrt(a) * sqrt(pow(a, -k)) if v16 else 0.0)


def _pressure(r, a, R, b, H, k, dgamma):
    return normal._pressure(r, a, R, b, H, k) - tension(r, a, H, k, dgamma)


def _displacement(r, a, R, b, H, k, dgamma):
    return normal._displacement(r, a, R, b, k) - graded_retraction(a, H, k, dgamma) * punch_displacement(r, a, k)


def _branches(R, b, H, k, dgamma, control):
    return branches(lambda a: a ** ((1.0 + k) / 2.0) * normal._rate(a, R, b, k), _samples(R, b, k), least_steepness(control, H, k, dgamma))


def _pull_off_radius(R, b, H, k, dgamma, control):
    unit = exponent_of(b)
    stress, H = stress_at(unit, H, k)
    R = np.ldexp(R, -unit)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    found = _branches(R, b, H, k, dgamma, control)
    load = _force if control == 'force' else _depth
    radius = lowest(found, lambda a: load(a, R, b, H, k, dgamma))
    return np.ldexp(radius, unit)


def _radius_from_depth(d, R, b, H, k, dgamma):
    from ....._programs.bodies._runtime.physics.stable import stable_radius
    from ....._programs.bodies._runtime.physics.unknowns import beyond_edge, radius_itself
    unit = exponent_of(b)
    stress, H = stress_at(unit, H, k)
    R = np.ldexp(R, -unit)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    d = np.ldexp(d, -unit)
    found = _branches(R, b, H, k, dgamma, control='depth')
    slope = growth_of(normal._rate, (R, b, k), H, k, dgamma, control='depth')
    pulled = pull_of(H, k, dgamma, control='depth')
    radius = stable_radius(d, found, lambda a: _depth(a, R, b, H, k, dgamma), slope, pulled, radius_itself(), beyond_edge(b, 1.0 + k))
    return np.ldexp(radius, unit)


def _radius_from_force(F, R, b, H, k, dgamma):
    from ....._programs.bodies._runtime.physics.stable import stable_radius
    from ....._programs.bodies._runtime.physics.unknowns import beyond_edge, radius_itself
    unit = exponent_of(b)
    stress, H = stress_at(unit, H, k)
    R = np.ldexp(R, -unit)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    F = np.ldexp(F, -(stress + 2 * unit))
    found = _branches(R, b, H, k, dgamma, control='force')
    slope = growth_of(normal._rate, (R, b, k), H, k, dgamma, control='force')
    pulled = pull_of(H, k, dgamma, control='force')
    radius = stable_radius(F, found, lambda a: _force(a, R, b, H, k, dgamma), slope, pulled, radius_itself(), beyond_edge(b, 1.0 + k))
    return np.ldexp(radius, unit)


def _work_of_adhesion_from_pull_off(F, R, b, H, k):
    unit = exponent_of(b)
    stress, H = stress_at(unit, H, k)
    R = np.ldexp(R, -unit)
    b = np.ldexp(b, -unit)
    F = np.ldexp(F, -(stress + 2 * unit))
    pull = -F if F < 0.0 else np.nan
    found = branches(lambda a: held(a, normal._rate(a, R, b, k), normal._force(a, R, b, 1.0, k), k), _held_samples(R, b, k), pull / H)
    a = lowest(found, lambda a: separation(pull + normal._force(a, R, b, H, k), a, H, k))
    work = separation(pull + normal._force(a, R, b, H, k), a, H, k)
    return 0.0 if F == 0.0 else np.ldexp(work, stress + unit)
