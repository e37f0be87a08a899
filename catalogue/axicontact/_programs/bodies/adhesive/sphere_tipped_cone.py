"""Bodies of axicontact.adhesive.sphere_tipped_cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, atan2, cos, exp, expm1, fsum, inf, sin, tanh

from ...._programs.bodies.normal import sphere_tipped_cone as normal
from ...._programs.bodies._runtime.physics.adhesion import held, hess_retraction, least_steepness, pull, separation
from ...._programs.bodies._runtime.physics.branches import exponent_of
from ...._programs.bodies._runtime.physics.stable import growth, stable_radius
from ...._programs.bodies._runtime.physics.unknowns import beyond_edge, up_to
from ...._runtime.physics.single import branches, lowest
from ....adhesive.sphere_tipped_cone import _held_samples, _samples
from ...._runtime.plain import log1p, sqrt, rule, MATH as np

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def _depth(a, R, theta, E_star, dgamma):
    v6 = R * sin(theta)
    v11 = R - a
    if a < v6:
        v43 = a * (log1p(2.0 * a / v11) / 2.0)
    else:
        v8 = R * cos(theta)
        v18 = v8 * v8 - v11 * (R + a) if v8 < v6 else (a - v6) * (a + v6)
        v21 = sqrt(v18 if v18 > 0.0 or v18 != v18 else 0.0)
        v24 = v6 * v6
        v43 = a * (log1p((v24 / (v21 + a) + v24 / (v8 + R)) / (v21 + v8)) + v6 * atan2(v21, v6) / v8)
    return v43 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)


def _force(a, R, theta, E_star, dgamma):
    v6 = R * sin(theta)
    v8 = R * cos(theta)
    v18 = v8 * v8 - (R - a) * (R + a) if v8 < v6 else (a - v6) * (a + v6)
    v21 = sqrt(v18 if v18 > 0.0 or v18 != v18 else 0.0)
    v22 = a if a < v6 or a != a else v6
    v30 = asinh(v22 / (sqrt((R - v22) * (v22 + R)) if a < v6 else v8))
    v35 = tanh(v30)
    if v30 < 1.0:
        v41 = v30 * v30
        v76 = v35 * (v35 * v35) * ((((((1.0716932453474512e-06 * v41 + 0.00019982814521087247) * v41 + 0.007076196047699156) * v41 + 0.08608622548411103) * v41 + 0.3073858328214721) * v41 + 0.3333333333333333) / (((((2.565078604208634e-08 * v41 + 2.0203143566039827e-05) * v41 + 0.001617010334189783) * v41 + 0.03639274880225476) * v41 + 0.32215749846441627) * v41 + 1.0))
    else:
        v76 = v30 - v35
    v80 = 2.0 * E_star
    v84 = 1.0 - 2.0 * theta / 3.141592653589793
    v86 = asinh(v21 / v6)
    v90 = 0.0 - expm1(-2.0 * v86)
    v93 = v90 if v90 > 0.0 else inf
    v104 = v6 * v6
    v109 = v6 * v6
    v113 = v109 / (v8 + R)
    v121 = v109 * R
    v122 = v8 * v8
    v131 = []
    for node, weight in RULE_0(v86 / v84):
        v94 = node * v86
        v103 = v21 * (exp(-v94) * (0.0 - expm1(-2.0 * (v86 - v94))) / v93)
        v107 = sqrt(v104 + v103 * v103)
        v130 = (log1p((v109 / (v103 + v107) + v113) / (v103 + v8)) + v6 * atan2(v103, v6) / v8 + v121 / (v107 * v122 + R * v103 * v8)) * v103 * v107
        v131.append(weight * v130)
    v131 = fsum(v131) * v86
    return E_star * (v22 * v22 * v30 + R * R * v76) + v80 * v131 - v80 * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))


def _rate(a, R, theta):
    v4 = R * sin(theta)
    v11 = (R - a) * (R + a)
    if a < v4:
        v20 = sqrt(v11)
        return asinh(a / v20) + R * a / (v20 * v20)
    v6 = R * cos(theta)
    v16 = v6 * v6 - v11 if v6 < v4 else (a - v4) * (a + v4)
    v19 = sqrt(v16 if v16 > 0.0 or v16 != v16 else 0.0)
    v30 = v4 * v4
    return log1p((v30 / (v19 + a) + v30 / (v6 + R)) / (v19 + v6)) + v4 * atan2(v19, v4) / v6 + v30 * R / (a * (v6 * v6) + R * v19 * v6)


def _branches(R, theta, E_star, dgamma, control):
    return branches(lambda a: np.sqrt(a) * _rate(a, R, theta), _samples(R, theta), least_steepness(control, E_star, dgamma))


def _pull_off_radius(R, theta, E_star, dgamma, control):
    unit = exponent_of(R * np.sin(theta))
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R = np.ldexp(R, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    found = _branches(R, theta, E_star, dgamma, control)
    load = _force if control == 'force' else _depth
    radius = lowest(found, lambda a: load(a, R, theta, E_star, dgamma))
    return np.ldexp(radius, unit)


def _radius_from_depth(d, R, theta, E_star, dgamma):
    unit = exponent_of(R * np.sin(theta))
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R = np.ldexp(R, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    d = np.ldexp(d, -unit)
    found = _branches(R, theta, E_star, dgamma, control='depth')
    radius = stable_radius(d, found, lambda a: _depth(a, R, theta, E_star, dgamma), lambda a: growth(_rate(a, R, theta), a, 'depth', E_star, dgamma), lambda a: hess_retraction(a, E_star, dgamma), up_to(R), beyond_edge(R * np.sin(theta)), corner=R * np.sin(theta))
    return np.ldexp(radius, unit)


def _radius_from_force(F, R, theta, E_star, dgamma):
    unit = exponent_of(R * np.sin(theta))
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R = np.ldexp(R, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    F = np.ldexp(F, -(stress + 2 * unit))
    found = _branches(R, theta, E_star, dgamma, control='force')
    radius = stable_radius(F, found, lambda a: _force(a, R, theta, E_star, dgamma), lambda a: growth(_rate(a, R, theta), a, 'force', E_star, dgamma), lambda a: pull(a, E_star, dgamma), up_to(R), beyond_edge(R * np.sin(theta)), corner=R * np.sin(theta))
    return np.ldexp(radius, unit)


def _work_of_adhesion_from_pull_off(F, R, theta, E_star):
    unit = exponent_of(R * np.sin(theta))
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R = np.ldexp(R, -unit)
    F = np.ldexp(F, -(stress + 2 * unit))
    pull = -F if F < 0.0 else np.nan
    found = branches(lambda a: held(a, _rate(a, R, theta), normal._force(a, R, theta, 1.0)), _held_samples(R, theta), pull / E_star)
    a = lowest(found, lambda a: separation(pull + normal._force(a, R, theta, E_star), a, E_star))
    work = separation(pull + normal._force(a, R, theta, E_star), a, E_star)
    return 0.0 if F == 0.0 else np.ldexp(work, stress + unit)
