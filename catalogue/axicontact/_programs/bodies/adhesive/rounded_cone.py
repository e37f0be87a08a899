"""Bodies of axicontact.adhesive.rounded_cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan, tan

from ...._programs.bodies.normal import rounded_cone as normal
from ...._programs.bodies._runtime.physics.adhesion import held, hess_retraction, least_steepness, pull, separation
from ...._programs.bodies._runtime.physics.branches import exponent_of
from ...._programs.bodies._runtime.physics.stable import growth, stable_radius
from ...._programs.bodies._runtime.physics.unknowns import beyond_edge, radius_itself
from ...._runtime.physics.single import branches, lowest
from ....adhesive.rounded_cone import _held_samples, _samples
from ...._runtime.plain import sqrt, MATH as np


def _depth(a, theta, b, E_star, dgamma):
    v5 = tan(theta)
    if a < b:
        v22 = v5 / b * (a * a)
    else:
        v13 = sqrt((a - b) * (a + b))
        v22 = v5 * a * (atan(v13 / b) + b / (v13 + a))
    return v22 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)


def _force(a, theta, b, E_star, dgamma):
    v7 = tan(theta)
    v13 = a * a
    if a < b:
        v35 = 4.0 * E_star * v7 / (3.0 * b) * (a * v13)
    else:
        v19 = sqrt((a - b) * (a + b))
        v35 = E_star * v7 * (v13 * atan(v19 / b) + 4.0 * b * v13 / (3.0 * (v19 + a)) + b / 3.0 * v19)
    return v35 - 2.0 * E_star * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))


def _rate(a, theta, b):
    v10 = tan(theta)
    if a < b:
        return 2.0 * v10 / b * a
    v3 = a - b
    v8 = sqrt((v3 if v3 > 0.0 or v3 != v3 else 0.0) * (a + b))
    return v10 * (atan(v8 / b) + 2.0 * b / (v8 + a))


def _branches(theta, b, E_star, dgamma, control):
    return branches(lambda a: np.sqrt(a) * _rate(a, theta, b), _samples(theta, b), least_steepness(control, E_star, dgamma))


def _pull_off_radius(theta, b, E_star, dgamma, control):
    unit = exponent_of(b)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    found = _branches(theta, b, E_star, dgamma, control)
    load = _force if control == 'force' else _depth
    radius = lowest(found, lambda a: load(a, theta, b, E_star, dgamma))
    return np.ldexp(radius, unit)


def _radius_from_depth(d, theta, b, E_star, dgamma):
    unit = exponent_of(b)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    d = np.ldexp(d, -unit)
    found = _branches(theta, b, E_star, dgamma, control='depth')
    radius = stable_radius(d, found, lambda a: _depth(a, theta, b, E_star, dgamma), lambda a: growth(_rate(a, theta, b), a, 'depth', E_star, dgamma), lambda a: hess_retraction(a, E_star, dgamma), radius_itself(), beyond_edge(b), corner=b)
    return np.ldexp(radius, unit)


def _radius_from_force(F, theta, b, E_star, dgamma):
    unit = exponent_of(b)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    F = np.ldexp(F, -(stress + 2 * unit))
    found = _branches(theta, b, E_star, dgamma, control='force')
    radius = stable_radius(F, found, lambda a: _force(a, theta, b, E_star, dgamma), lambda a: growth(_rate(a, theta, b), a, 'force', E_star, dgamma), lambda a: pull(a, E_star, dgamma), radius_itself(), beyond_edge(b), corner=b)
    return np.ldexp(radius, unit)


def _work_of_adhesion_from_pull_off(F, theta, b, E_star):
    unit = exponent_of(b)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    b = np.ldexp(b, -unit)
    F = np.ldexp(F, -(stress + 2 * unit))
    pull = -F if F < 0.0 else np.nan
    found = branches(lambda a: held(a, _rate(a, theta, b), normal._force(a, theta, b, 1.0)), _held_samples(theta, b), pull / E_star)
    a = lowest(found, lambda a: separation(pull + normal._force(a, theta, b, E_star), a, E_star))
    work = separation(pull + normal._force(a, theta, b, E_star), a, E_star)
    return 0.0 if F == 0.0 else np.ldexp(work, stress + unit)
