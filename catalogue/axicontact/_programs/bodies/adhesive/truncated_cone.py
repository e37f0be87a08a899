"""Bodies of axicontact.adhesive.truncated_cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan, tan

from ...._programs.bodies.normal import truncated_cone as normal
from ...._programs.bodies._runtime.physics.adhesion import held, hess_retraction, least_steepness, pull, separation
from ...._programs.bodies._runtime.physics.branches import exponent_of
from ...._programs.bodies._runtime.physics.stable import growth, stable_radius
from ...._programs.bodies._runtime.physics.unknowns import beyond_edge, radius_itself
from ...._runtime.physics.single import branches, lowest
from ....adhesive.truncated_cone import _held_samples, _samples
from ...._runtime.plain import sqrt, MATH as np


def _depth(a, theta, b, E_star, dgamma):
    return tan(theta) * a * atan(sqrt((a - b) * (a + b)) / b) - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)


def _force(a, theta, b, E_star, dgamma):
    v8 = sqrt((a - b) * (a + b))
    return E_star * tan(theta) * (a * a * atan(v8 / b) + b * v8) - 2.0 * E_star * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))


def _rate(a, theta, b):
    v3 = a - b
    v8 = sqrt((v3 if v3 > 0.0 or v3 != v3 else 0.0) * (a + b))
    v11 = tan(theta)
    return v11 * atan(v8 / b) + b * v11 / v8


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
    radius = stable_radius(d, found, lambda a: _depth(a, theta, b, E_star, dgamma), lambda a: growth(_rate(a, theta, b), a, 'depth', E_star, dgamma), lambda a: hess_retraction(a, E_star, dgamma), radius_itself(), beyond_edge(b))
    return np.ldexp(radius, unit)


def _radius_from_force(F, theta, b, E_star, dgamma):
    unit = exponent_of(b)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    F = np.ldexp(F, -(stress + 2 * unit))
    found = _branches(theta, b, E_star, dgamma, control='force')
    radius = stable_radius(F, found, lambda a: _force(a, theta, b, E_star, dgamma), lambda a: growth(_rate(a, theta, b), a, 'force', E_star, dgamma), lambda a: pull(a, E_star, dgamma), radius_itself(), beyond_edge(b))
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
