"""Bodies of axicontact.adhesive.sphere_tipped_cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import sphere_tipped_cone as normal
from ...._programs.bodies._runtime.functions import sine_root
from ...._programs.bodies._runtime.physics.adhesion import hess_retraction, least_steepness, pull
from ...._programs.bodies._runtime.physics.branches import exponent_of
from ...._programs.bodies._runtime.physics.stable import growth, stable_radius
from ...._programs.bodies._runtime.physics.unknowns import beyond_edge, up_to
from ...._runtime.physics.single import branches, lowest
from ....adhesive.sphere_tipped_cone import _samples
from ...._runtime.plain import MATH as np


def _depth(a, R, theta, E_star, dgamma):
    return normal._depth(a, R, theta) - hess_retraction(a, E_star, dgamma)


def _force(a, R, theta, E_star, dgamma):
    return normal._force(a, R, theta, E_star) - pull(a, E_star, dgamma)


def _rate(a, R, theta):
    """Derivative g'(a) of the depth without adhesion."""
    root = sine_root(a, R, theta)
    return normal._slope_at(a, root, R, theta)


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
