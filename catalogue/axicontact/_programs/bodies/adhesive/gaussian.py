"""Bodies of axicontact.adhesive.gaussian over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import fsum, inf, nan

from ...._programs.bodies.normal import gaussian as normal
from ...._programs.bodies._runtime.physics.adhesion import held, hess_retraction, least_steepness, pull, separation
from ...._programs.bodies._runtime.physics.branches import exponent_of
from ...._programs.bodies._runtime.physics.stable import growth, stable_radius
from ...._programs.bodies._runtime.physics.unknowns import on_the_bump
from ...._runtime.physics.single import branches, lowest
from ....adhesive.gaussian import _held_samples, _samples
from ...._runtime.plain import sqrt, rule, MATH as np

RULE_0 = rule(((inf, 32),))


def _depth(a, h, s, E_star, dgamma):
    if a <= 1.5019752682686114 * s:
        v5 = a / s
        v11 = v5 * v5
        v49 = ((((((((((((1.567077144036674e-13 * v11 + -3.840375691006307e-12) * v11 + 3.8015754128174666e-11) * v11 + -1.8423006918213799e-10) * v11 + 4.472469827763728e-10) * v11 + -1.1927516362741588e-09) * v11 + 6.225892246861416e-09) * v11 + 3.4413148480148793e-09) * v11 + -9.933344851449817e-08) * v11 + -5.127541706569233e-07) * v11 + 1.8119768160503268e-06) * v11 + 2.151585040783394e-05) * v11 + 4.61098799999374e-06) * v11
        v71 = 2.0 * h * (v5 / ((((((v49 + -0.000684089638073553) * v11 + -0.002257495580553435) * v11 + 0.016931216930225715) * v11 + 0.17777777777782838) * v11 + 0.6666666666666656) * v11 + 1.0)) * v5
    else:
        v71 = nan
    return v71 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)


def _force(a, h, s, E_star, dgamma):
    v6 = 2.0 * E_star
    if a <= 1.5019752682686114 * s:
        v11 = 2.0 * h / s
        v75 = []
        for node, weight in RULE_0(a / 1.0):
            v8 = node * a
            v9 = v8 / s
            v12 = v9 * v9
            v50 = ((((((((((((1.567077144036674e-13 * v12 + -3.840375691006307e-12) * v12 + 3.8015754128174666e-11) * v12 + -1.8423006918213799e-10) * v12 + 4.472469827763728e-10) * v12 + -1.1927516362741588e-09) * v12 + 6.225892246861416e-09) * v12 + 3.4413148480148793e-09) * v12 + -9.933344851449817e-08) * v12 + -5.127541706569233e-07) * v12 + 1.8119768160503268e-06) * v12 + 2.151585040783394e-05) * v12 + 4.61098799999374e-06) * v12
            v67 = v9 / ((((((v50 + -0.000684089638073553) * v12 + -0.002257495580553435) * v12 + 0.016931216930225715) * v12 + 0.17777777777782838) * v12 + 0.6666666666666656) * v12 + 1.0)
            v74 = v8 * (v11 * (v67 + (1.0 - 2.0 * v67 * v9) * v9))
            v75.append(weight * v74)
        v75 = fsum(v75) * a
        v81 = v6 * v75
    else:
        v81 = nan
    return v81 - v6 * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))


def _rate(a, h, s):
    v3 = a / s
    v7 = v3 * v3
    v45 = ((((((((((((1.567077144036674e-13 * v7 + -3.840375691006307e-12) * v7 + 3.8015754128174666e-11) * v7 + -1.8423006918213799e-10) * v7 + 4.472469827763728e-10) * v7 + -1.1927516362741588e-09) * v7 + 6.225892246861416e-09) * v7 + 3.4413148480148793e-09) * v7 + -9.933344851449817e-08) * v7 + -5.127541706569233e-07) * v7 + 1.8119768160503268e-06) * v7 + 2.151585040783394e-05) * v7 + 4.61098799999374e-06) * v7
    v63 = v3 / ((((((v45 + -0.000684089638073553) * v7 + -0.002257495580553435) * v7 + 0.016931216930225715) * v7 + 0.17777777777782838) * v7 + 0.6666666666666656) * v7 + 1.0)
    return 2.0 * h / s * (v63 + (1.0 - 2.0 * v63 * v3) * v3)


def _branches(h, s, E_star, dgamma, control):
    return branches(lambda a: np.sqrt(a) * _rate(a, h, s), _samples(h, s), least_steepness(control, E_star, dgamma))


def _pull_off_radius(h, s, E_star, dgamma, control):
    unit = exponent_of(s)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    h = np.ldexp(h, -unit)
    s = np.ldexp(s, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    found = _branches(h, s, E_star, dgamma, control)
    load = _force if control == 'force' else _depth
    radius = lowest(found, lambda a: load(a, h, s, E_star, dgamma))
    return np.ldexp(radius, unit)


def _radius_from_depth(d, h, s, E_star, dgamma):
    unit = exponent_of(s)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    h = np.ldexp(h, -unit)
    s = np.ldexp(s, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    d = np.ldexp(d, -unit)
    found = _branches(h, s, E_star, dgamma, control='depth')
    radius = stable_radius(d, found, lambda a: _depth(a, h, s, E_star, dgamma), lambda a: growth(_rate(a, h, s), a, 'depth', E_star, dgamma), lambda a: hess_retraction(a, E_star, dgamma), on_the_bump(s))
    return np.ldexp(radius, unit)


def _radius_from_force(F, h, s, E_star, dgamma):
    unit = exponent_of(s)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    h = np.ldexp(h, -unit)
    s = np.ldexp(s, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    F = np.ldexp(F, -(stress + 2 * unit))
    found = _branches(h, s, E_star, dgamma, control='force')
    radius = stable_radius(F, found, lambda a: _force(a, h, s, E_star, dgamma), lambda a: growth(_rate(a, h, s), a, 'force', E_star, dgamma), lambda a: pull(a, E_star, dgamma), on_the_bump(s))
    return np.ldexp(radius, unit)


def _work_of_adhesion_from_pull_off(F, h, s, E_star):
    unit = exponent_of(s)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    h = np.ldexp(h, -unit)
    s = np.ldexp(s, -unit)
    F = np.ldexp(F, -(stress + 2 * unit))
    pull = -F if F < 0.0 else np.nan
    found = branches(lambda a: held(a, _rate(a, h, s), normal._force(a, h, s, 1.0)), _held_samples(h, s), pull / E_star)
    a = lowest(found, lambda a: separation(pull + normal._force(a, h, s, E_star), a, E_star))
    work = separation(pull + normal._force(a, h, s, E_star), a, E_star)
    return 0.0 if F == 0.0 else np.ldexp(work, stress + unit)
