"""Bodies of axicontact.adhesive.ellipsoid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh

from ...._programs.bodies.normal import ellipsoid as normal
from ...._programs.bodies._runtime.physics.adhesion import held, hess_retraction, least_steepness, pull, separation
from ...._programs.bodies._runtime.physics.branches import exponent_of
from ...._programs.bodies._runtime.physics.stable import growth, stable_radius
from ...._programs.bodies._runtime.physics.unknowns import up_to
from ...._runtime.physics.single import branches, lowest
from ....adhesive.ellipsoid import _held_samples, _samples
from ...._runtime.plain import log1p, sqrt, MATH as np


def _depth(a, h, b, E_star, dgamma):
    return h / b * a * (log1p(2.0 * a / (b - a)) / 2.0) - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)


def _force(a, h, b, E_star, dgamma):
    v10 = log1p(2.0 * a / (b - a)) / 2.0
    v15 = a / b
    if v10 < 1.0:
        v21 = v10 * v10
        v56 = v15 * (v15 * v15) * ((((((1.0716932453474512e-06 * v21 + 0.00019982814521087247) * v21 + 0.007076196047699156) * v21 + 0.08608622548411103) * v21 + 0.3073858328214721) * v21 + 0.3333333333333333) / (((((2.565078604208634e-08 * v21 + 2.0203143566039827e-05) * v21 + 0.001617010334189783) * v21 + 0.03639274880225476) * v21 + 0.32215749846441627) * v21 + 1.0))
    else:
        v56 = v10 - v15
    return E_star * h * (a * a * v10 / b + b * v56) - 2.0 * E_star * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))


def _rate(a, h, b):
    v3 = b - a
    v8 = sqrt((v3 if v3 > 0.0 or v3 != v3 else 0.0) * (b + a))
    return h / b * asinh(a / v8) + h * a / (v8 * v8)


def _branches(h, b, E_star, dgamma, control):
    return branches(lambda a: np.sqrt(a) * _rate(a, h, b), _samples(h, b), least_steepness(control, E_star, dgamma))


def _pull_off_radius(h, b, E_star, dgamma, control):
    unit = exponent_of(b)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    h = np.ldexp(h, -unit)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    found = _branches(h, b, E_star, dgamma, control)
    load = _force if control == 'force' else _depth
    radius = lowest(found, lambda a: load(a, h, b, E_star, dgamma))
    return np.ldexp(radius, unit)


def _radius_from_depth(d, h, b, E_star, dgamma):
    unit = exponent_of(b)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    h = np.ldexp(h, -unit)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    d = np.ldexp(d, -unit)
    found = _branches(h, b, E_star, dgamma, control='depth')
    radius = stable_radius(d, found, lambda a: _depth(a, h, b, E_star, dgamma), lambda a: growth(_rate(a, h, b), a, 'depth', E_star, dgamma), lambda a: hess_retraction(a, E_star, dgamma), up_to(b))
    return np.ldexp(radius, unit)


def _radius_from_force(F, h, b, E_star, dgamma):
    unit = exponent_of(b)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    h = np.ldexp(h, -unit)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    F = np.ldexp(F, -(stress + 2 * unit))
    found = _branches(h, b, E_star, dgamma, control='force')
    radius = stable_radius(F, found, lambda a: _force(a, h, b, E_star, dgamma), lambda a: growth(_rate(a, h, b), a, 'force', E_star, dgamma), lambda a: pull(a, E_star, dgamma), up_to(b))
    return np.ldexp(radius, unit)


def _work_of_adhesion_from_pull_off(F, h, b, E_star):
    unit = exponent_of(b)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    h = np.ldexp(h, -unit)
    b = np.ldexp(b, -unit)
    F = np.ldexp(F, -(stress + 2 * unit))
    pull = -F if F < 0.0 else np.nan
    found = branches(lambda a: held(a, _rate(a, h, b), normal._force(a, h, b, 1.0)), _held_samples(h, b), pull / E_star)
    a = lowest(found, lambda a: separation(pull + normal._force(a, h, b, E_star), a, E_star))
    work = separation(pull + normal._force(a, h, b, E_star), a, E_star)
    return 0.0 if F == 0.0 else np.ldexp(work, stress + unit)
