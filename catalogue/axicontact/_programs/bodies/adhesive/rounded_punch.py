"""Bodies of axicontact.adhesive.rounded_punch over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan, atan2

from ...._programs.bodies.normal import rounded_punch as normal
from ...._programs.bodies._runtime.physics.adhesion import held, hess_retraction, least_steepness, pull, separation
from ...._programs.bodies._runtime.physics.branches import exponent_of
from ...._programs.bodies._runtime.physics.stable import growth, stable_radius
from ...._programs.bodies._runtime.physics.unknowns import beyond_edge, radius_itself
from ...._runtime.physics.single import branches, lowest
from ....adhesive.rounded_punch import _held_samples, _samples
from ...._runtime.plain import sqrt, MATH as np


def _depth(a, R, b, E_star, dgamma):
    v7 = a - b
    v8 = v7 / b
    if v8 < 0.42:
        v54 = v8 * sqrt(v8) * ((((((0.0005288491342179178 * v8 + 0.038096760299703034) * v8 + 0.4065213849117787) * v8 + 1.438682033198726) * v8 + 1.9979042349620892) * v8 + 0.9428090415820634) / (((((0.006421883194715949 * v8 + 0.15001504718401248) * v8 + 0.9450913324352289) * v8 + 2.37401087025821) * v8 + 2.569097449054519) * v8 + 1.0))
    else:
        v14 = sqrt(v7 * (a + b)) / b
        v54 = v14 - atan(v14)
    return b / R * a * v54 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)


def _force(a, R, b, E_star, dgamma):
    v5 = a - b
    v7 = v5 * (a + b)
    v8 = sqrt(v7)
    v13 = v5 / b
    if v13 < 0.42:
        v56 = v13 * sqrt(v13) * ((((((0.0005288491342179178 * v13 + 0.038096760299703034) * v13 + 0.4065213849117787) * v13 + 1.438682033198726) * v13 + 1.9979042349620892) * v13 + 0.9428090415820634) / (((((0.006421883194715949 * v13 + 0.15001504718401248) * v13 + 0.9450913324352289) * v13 + 2.37401087025821) * v13 + 2.569097449054519) * v13 + 1.0))
    else:
        v16 = v8 / b
        v56 = v16 - atan(v16)
    return E_star / R * (b * (a * a) * v56 + v7 * v8 / 3.0) - 2.0 * E_star * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))


def _rate(a, R, b):
    v3 = a - b
    v8 = sqrt((v3 if v3 > 0.0 or v3 != v3 else 0.0) * (a + b))
    return 2.0 * v8 / R - b / R * atan2(v8, b)


def _branches(R, b, E_star, dgamma, control):
    return branches(lambda a: np.sqrt(a) * _rate(a, R, b), _samples(R, b), least_steepness(control, E_star, dgamma))


def _pull_off_radius(R, b, E_star, dgamma, control):
    unit = exponent_of(b)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R = np.ldexp(R, -unit)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    found = _branches(R, b, E_star, dgamma, control)
    load = _force if control == 'force' else _depth
    radius = lowest(found, lambda a: load(a, R, b, E_star, dgamma))
    return np.ldexp(radius, unit)


def _radius_from_depth(d, R, b, E_star, dgamma):
    unit = exponent_of(b)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R = np.ldexp(R, -unit)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    d = np.ldexp(d, -unit)
    found = _branches(R, b, E_star, dgamma, control='depth')
    radius = stable_radius(d, found, lambda a: _depth(a, R, b, E_star, dgamma), lambda a: growth(_rate(a, R, b), a, 'depth', E_star, dgamma), lambda a: hess_retraction(a, E_star, dgamma), radius_itself(), beyond_edge(b))
    return np.ldexp(radius, unit)


def _radius_from_force(F, R, b, E_star, dgamma):
    unit = exponent_of(b)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R = np.ldexp(R, -unit)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    F = np.ldexp(F, -(stress + 2 * unit))
    found = _branches(R, b, E_star, dgamma, control='force')
    radius = stable_radius(F, found, lambda a: _force(a, R, b, E_star, dgamma), lambda a: growth(_rate(a, R, b), a, 'force', E_star, dgamma), lambda a: pull(a, E_star, dgamma), radius_itself(), beyond_edge(b))
    return np.ldexp(radius, unit)


def _work_of_adhesion_from_pull_off(F, R, b, E_star):
    unit = exponent_of(b)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R = np.ldexp(R, -unit)
    b = np.ldexp(b, -unit)
    F = np.ldexp(F, -(stress + 2 * unit))
    pull = -F if F < 0.0 else np.nan
    found = branches(lambda a: held(a, _rate(a, R, b), normal._force(a, R, b, 1.0)), _held_samples(R, b), pull / E_star)
    a = lowest(found, lambda a: separation(pull + normal._force(a, R, b, E_star), a, E_star))
    work = separation(pull + normal._force(a, R, b, E_star), a, E_star)
    return 0.0 if F == 0.0 else np.ldexp(work, stress + unit)
