"""Bodies of axicontact.adhesive.sphere over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh

from ...._programs.bodies.normal import sphere as normal
from ...._programs.bodies._runtime.physics.adhesion import held, hess_retraction, least_steepness, pull, separation
from ...._programs.bodies._runtime.physics.branches import exponent_of
from ...._programs.bodies._runtime.physics.stable import growth, stable_radius
from ...._programs.bodies._runtime.physics.unknowns import up_to
from ...._runtime.physics.single import branches, lowest
from ....adhesive.sphere import _held_samples, _samples
from ...._runtime.plain import log1p, sqrt, MATH as np


def _depth(a, R, E_star, dgamma):
    return a * (log1p(2.0 * a / (R - a)) / 2.0) - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)


def _force(a, R, E_star, dgamma):
    v9 = log1p(2.0 * a / (R - a)) / 2.0
    v13 = a / R
    if v9 < 1.0:
        v19 = v9 * v9
        v54 = v13 * (v13 * v13) * ((((((1.0716932453474512e-06 * v19 + 0.00019982814521087247) * v19 + 0.007076196047699156) * v19 + 0.08608622548411103) * v19 + 0.3073858328214721) * v19 + 0.3333333333333333) / (((((2.565078604208634e-08 * v19 + 2.0203143566039827e-05) * v19 + 0.001617010334189783) * v19 + 0.03639274880225476) * v19 + 0.32215749846441627) * v19 + 1.0))
    else:
        v54 = v9 - v13
    return E_star * (a * a * v9 + R * R * v54) - 2.0 * E_star * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))


def _rate(a, R):
    v2 = R - a
    v7 = sqrt((v2 if v2 > 0.0 or v2 != v2 else 0.0) * (R + a))
    return asinh(a / v7) + R * a / (v7 * v7)


def _branches(R, E_star, dgamma, control):
    return branches(lambda a: np.sqrt(a) * _rate(a, R), _samples(R), least_steepness(control, E_star, dgamma))


def _pull_off_radius(R, E_star, dgamma, control):
    unit = exponent_of(R)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R = np.ldexp(R, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    found = _branches(R, E_star, dgamma, control)
    load = _force if control == 'force' else _depth
    radius = lowest(found, lambda a: load(a, R, E_star, dgamma))
    return np.ldexp(radius, unit)


def _radius_from_depth(d, R, E_star, dgamma):
    unit = exponent_of(R)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R = np.ldexp(R, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    d = np.ldexp(d, -unit)
    found = _branches(R, E_star, dgamma, control='depth')
    radius = stable_radius(d, found, lambda a: _depth(a, R, E_star, dgamma), lambda a: growth(_rate(a, R), a, 'depth', E_star, dgamma), lambda a: hess_retraction(a, E_star, dgamma), up_to(R))
    return np.ldexp(radius, unit)


def _radius_from_force(F, R, E_star, dgamma):
    unit = exponent_of(R)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R = np.ldexp(R, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    F = np.ldexp(F, -(stress + 2 * unit))
    found = _branches(R, E_star, dgamma, control='force')
    radius = stable_radius(F, found, lambda a: _force(a, R, E_star, dgamma), lambda a: growth(_rate(a, R), a, 'force', E_star, dgamma), lambda a: pull(a, E_star, dgamma), up_to(R))
    return np.ldexp(radius, unit)


def _work_of_adhesion_from_pull_off(F, R, E_star):
    unit = exponent_of(R)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R = np.ldexp(R, -unit)
    F = np.ldexp(F, -(stress + 2 * unit))
    pull = -F if F < 0.0 else np.nan
    found = branches(lambda a: held(a, _rate(a, R), normal._force(a, R, 1.0)), _held_samples(R), pull / E_star)
    a = lowest(found, lambda a: separation(pull + normal._force(a, R, E_star), a, E_star))
    work = separation(pull + normal._force(a, R, E_star), a, E_star)
    return 0.0 if F == 0.0 else np.ldexp(work, stress + unit)
