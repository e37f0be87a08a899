"""Bodies of axicontact.adhesive.wavy_paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import wavy_paraboloid as normal
from ...._programs.bodies._runtime.physics.adhesion import hess_retraction, least_steepness, lift, pull, tension
from ...._programs.bodies._runtime.physics.branches import exponent_of
from ...._programs.bodies._runtime.physics.stable import growth, stable_radius
from ...._programs.bodies._runtime.physics.unknowns import radius_itself
from ...._runtime.physics.single import branches, lowest
from ....adhesive.wavy_paraboloid import _samples
from ...._runtime.plain import MATH as np


def _depth(a, R, h, wavelength, E_star, dgamma):
    return normal._depth(a, R, h, wavelength) - hess_retraction(a, E_star, dgamma)


def _force(a, R, h, wavelength, E_star, dgamma):
    return normal._force(a, R, h, wavelength, E_star) - pull(a, E_star, dgamma)


def _pressure(r, a, R, h, wavelength, E_star, dgamma):
    return normal._pressure(r, a, R, h, wavelength, E_star) - tension(r, a, E_star, dgamma)


def _displacement(r, a, R, h, wavelength, E_star, dgamma):
    return normal._displacement(r, a, R, h, wavelength) - lift(r, a, E_star, dgamma)


def _rate(a, R, h, wavelength):
    """Derivative g'(a) of the depth without adhesion."""
    return normal._slope(a, R, h, wavelength)


def _branches(R, h, wavelength, E_star, dgamma, control):
    return branches(lambda a: np.sqrt(a) * _rate(a, R, h, wavelength), _samples(R, h, wavelength, E_star, dgamma), least_steepness(control, E_star, dgamma))


def _pull_off_radius(R, h, wavelength, E_star, dgamma, control):
    unit = exponent_of(wavelength)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R = np.ldexp(R, -unit)
    h = np.ldexp(h, -unit)
    wavelength = np.ldexp(wavelength, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    found = _branches(R, h, wavelength, E_star, dgamma, control)
    load = _force if control == 'force' else _depth
    radius = lowest(found, lambda a: load(a, R, h, wavelength, E_star, dgamma))
    return np.ldexp(radius, unit)


def _radius_from_depth(d, R, h, wavelength, E_star, dgamma):
    unit = exponent_of(wavelength)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R = np.ldexp(R, -unit)
    h = np.ldexp(h, -unit)
    wavelength = np.ldexp(wavelength, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    d = np.ldexp(d, -unit)
    found = _branches(R, h, wavelength, E_star, dgamma, control='depth')
    radius = stable_radius(d, found, lambda a: _depth(a, R, h, wavelength, E_star, dgamma), lambda a: growth(_rate(a, R, h, wavelength), a, 'depth', E_star, dgamma), lambda a: hess_retraction(a, E_star, dgamma), radius_itself())
    return np.ldexp(radius, unit)


def _radius_from_force(F, R, h, wavelength, E_star, dgamma):
    unit = exponent_of(wavelength)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R = np.ldexp(R, -unit)
    h = np.ldexp(h, -unit)
    wavelength = np.ldexp(wavelength, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    F = np.ldexp(F, -(stress + 2 * unit))
    found = _branches(R, h, wavelength, E_star, dgamma, control='force')
    radius = stable_radius(F, found, lambda a: _force(a, R, h, wavelength, E_star, dgamma), lambda a: growth(_rate(a, R, h, wavelength), a, 'force', E_star, dgamma), lambda a: pull(a, E_star, dgamma), radius_itself())
    return np.ldexp(radius, unit)
