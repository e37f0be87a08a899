"""Bodies of axicontact.adhesive.capped_paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import capped_paraboloid as normal
from ...._programs.bodies._runtime.physics.adhesion import held, hess_retraction, least_steepness, pull, separation
from ...._programs.bodies._runtime.physics.branches import exponent_of
from ...._programs.bodies._runtime.physics.stable import growth, stable_radius
from ...._programs.bodies._runtime.physics.unknowns import beyond_edge, radius_itself
from ...._runtime.physics.single import branches, lowest
from ....adhesive.capped_paraboloid import _held_samples, _samples
from ...._runtime.plain import sqrt, MATH as np


def _depth(a, R1, R2, b, E_star, dgamma):
    return (a * a / R1 if a < b else a * (a + (R1 - R2) / R2 * sqrt((a - b) * (a + b))) / R1) - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)


def _force(a, R1, R2, b, E_star, dgamma):
    v9 = 3.0 * R1
    v12 = a * a
    v13 = a * v12
    v19 = 2.0 * E_star
    return (4.0 * E_star / v9 * v13 if a < b else v19 / v9 * (2.0 * v13 + (R1 - R2) / R2 * (2.0 * v12 + b * b) * sqrt((a - b) * (a + b)))) - v19 * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))


def _rate(a, R1, R2, b):
    v13 = 2.0 * a / R1
    if a < b:
        return v13
    v4 = a - b
    v9 = sqrt((v4 if v4 > 0.0 or v4 != v4 else 0.0) * (a + b))
    v14 = R1 - R2
    v16 = R1 * R2
    return v13 + 2.0 * v14 / v16 * v9 + b * b * v14 / (v16 * v9)


def _branches(R1, R2, b, E_star, dgamma, control):
    return branches(lambda a: np.sqrt(a) * _rate(a, R1, R2, b), _samples(R1, R2, b), least_steepness(control, E_star, dgamma))


def _pull_off_radius(R1, R2, b, E_star, dgamma, control):
    unit = exponent_of(b)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R1 = np.ldexp(R1, -unit)
    R2 = np.ldexp(R2, -unit)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    found = _branches(R1, R2, b, E_star, dgamma, control)
    load = _force if control == 'force' else _depth
    radius = lowest(found, lambda a: load(a, R1, R2, b, E_star, dgamma))
    return np.ldexp(radius, unit)


def _radius_from_depth(d, R1, R2, b, E_star, dgamma):
    unit = exponent_of(b)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R1 = np.ldexp(R1, -unit)
    R2 = np.ldexp(R2, -unit)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    d = np.ldexp(d, -unit)
    found = _branches(R1, R2, b, E_star, dgamma, control='depth')
    radius = stable_radius(d, found, lambda a: _depth(a, R1, R2, b, E_star, dgamma), lambda a: growth(_rate(a, R1, R2, b), a, 'depth', E_star, dgamma), lambda a: hess_retraction(a, E_star, dgamma), radius_itself(), beyond_edge(b), corner=b)
    return np.ldexp(radius, unit)


def _radius_from_force(F, R1, R2, b, E_star, dgamma):
    unit = exponent_of(b)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R1 = np.ldexp(R1, -unit)
    R2 = np.ldexp(R2, -unit)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    F = np.ldexp(F, -(stress + 2 * unit))
    found = _branches(R1, R2, b, E_star, dgamma, control='force')
    radius = stable_radius(F, found, lambda a: _force(a, R1, R2, b, E_star, dgamma), lambda a: growth(_rate(a, R1, R2, b), a, 'force', E_star, dgamma), lambda a: pull(a, E_star, dgamma), radius_itself(), beyond_edge(b), corner=b)
    return np.ldexp(radius, unit)


def _work_of_adhesion_from_pull_off(F, R1, R2, b, E_star):
    unit = exponent_of(b)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R1 = np.ldexp(R1, -unit)
    R2 = np.ldexp(R2, -unit)
    b = np.ldexp(b, -unit)
    F = np.ldexp(F, -(stress + 2 * unit))
    pull = -F if F < 0.0 else np.nan
    found = branches(lambda a: held(a, _rate(a, R1, R2, b), normal._force(a, R1, R2, b, 1.0)), _held_samples(R1, R2, b), pull / E_star)
    a = lowest(found, lambda a: separation(pull + normal._force(a, R1, R2, b, E_star), a, E_star))
    work = separation(pull + normal._force(a, R1, R2, b, E_star), a, E_star)
    return 0.0 if F == 0.0 else np.ldexp(work, stress + unit)
