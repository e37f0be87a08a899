"""Bodies of axicontact.adhesive.hyperboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan, atan2, tan

from ...._programs.bodies.normal import hyperboloid as normal
from ...._programs.bodies._runtime.physics.adhesion import held, hess_retraction, least_steepness, pull, separation
from ...._programs.bodies._runtime.physics.branches import exponent_of
from ...._programs.bodies._runtime.physics.stable import growth, stable_radius
from ...._programs.bodies._runtime.physics.unknowns import radius_itself
from ...._runtime.physics.single import branches, lowest
from ....adhesive.hyperboloid import _held_samples, _samples
from ...._runtime.plain import sqrt, MATH as np


def _depth(a, theta, b, E_star, dgamma):
    return tan(theta) * a * atan(a / b) - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)


def _force(a, theta, b, E_star, dgamma):
    v12 = a / b
    if v12 < 1.0:
        v16 = v12 * v12
        v59 = v12 * v16 * (((((((2.229767813968649e-06 * v16 + 0.0021043873129700233) * v16 + 0.04325113828415611) * v16 + 0.2725778671008127) * v16 + 0.7123414383945195) * v16 + 0.8116412201960678) * v16 + 0.3333333333333333) / ((((((0.002445452808893491 * v16 + 0.06453295925870227) * v16 + 0.5368820963772863) * v16 + 1.9680296155712274) * v16 + 3.5294070829658954) * v16 + 3.034923660588189) * v16 + 1.0))
    else:
        v59 = v12 - atan(v12)
    return E_star * tan(theta) * (a * a * atan2(a, b) + b * b * v59) - 2.0 * E_star * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))


def _rate(a, theta, b):
    v5 = tan(theta)
    return v5 * atan(a / b) + b * v5 * a / (a * a + b * b)


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
    radius = stable_radius(d, found, lambda a: _depth(a, theta, b, E_star, dgamma), lambda a: growth(_rate(a, theta, b), a, 'depth', E_star, dgamma), lambda a: hess_retraction(a, E_star, dgamma), radius_itself())
    return np.ldexp(radius, unit)


def _radius_from_force(F, theta, b, E_star, dgamma):
    unit = exponent_of(b)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    F = np.ldexp(F, -(stress + 2 * unit))
    found = _branches(theta, b, E_star, dgamma, control='force')
    radius = stable_radius(F, found, lambda a: _force(a, theta, b, E_star, dgamma), lambda a: growth(_rate(a, theta, b), a, 'force', E_star, dgamma), lambda a: pull(a, E_star, dgamma), radius_itself())
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
