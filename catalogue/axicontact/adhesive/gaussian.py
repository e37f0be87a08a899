"""Gaussian bump with adhesion.

A smooth asperity of height h and width s; compact up to the radius of largest depth.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Kept, Result, elementwise, require
from .._runtime.physics.adhesion import (
    PullOff,
    held,
    hess_retraction,
    least_steepness,
    lift,
    pull,
    require_control,
    separation,
    tension,
)
from .._runtime.physics.branches import Branches, Samples, branches, exponent_of, lowest, radii_to
from .._runtime.physics.stable import growth, stable_radius
from .._runtime.physics.unknowns import on_the_bump
from ..normal import gaussian as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "depth",
    "displacement",
    "force",
    "pressure",
    "pull_off",
    "radius_from_depth",
    "radius_from_force",
    "retraction",
    "work_of_adhesion_from_pull_off",
]


def __dir__() -> list[str]:
    return __all__


def retraction(a: ArrayLike, *, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Retraction of the indenter from the state without adhesion, at constant contact radius.

    retraction = sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.

    Returns
    -------
    float or ndarray
        Retraction at constant contact radius, rule of Hess [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for h << s. Negative or NaN radii give NaN. Handbook: gaussian.adh.Dl.

    References
    ----------
    chapter 11, equation (11.31); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.adhesive import gaussian
    >>> value = gaussian.retraction(1.0, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.250663
    """
    require(E_star=E_star, dgamma=dgamma)
    return elementwise(hess_retraction, a, E_star=E_star, dgamma=dgamma)


def depth(a: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Indentation depth at contact radius a; negative where adhesion pulls the surface up.

    d = 2*a*h*Dawson(a/s)/s - sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star)
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.

    Returns
    -------
    float or ndarray
        Indentation depth of the point r = 0 [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for h << s. Negative or NaN radii give NaN. Handbook: gaussian.adh.d.

    References
    ----------
    chapter 11, equation (11.31); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.adhesive import gaussian
    >>> value = gaussian.depth(1.0, h=0.7, s=1.0, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.502648
    """
    require(h=h, s=s, E_star=E_star, dgamma=dgamma)
    return elementwise(_depth, a, h=h, s=s, E_star=E_star, dgamma=dgamma)


def force(a: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Normal force at contact radius a, negative in tension.

    F = -2*sqrt(2)*sqrt(pi)*sqrt(E_star)*a**(3/2)*sqrt(dgamma) + 2*E_star*h*(-a + (2*a**2 +
    s**2)*Dawson(a/s)/s)
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.

    Returns
    -------
    float or ndarray
        Normal force [N]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for h << s. Negative or NaN radii give NaN. Handbook: gaussian.adh.F.

    References
    ----------
    chapter 11, equation (11.31); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.adhesive import gaussian
    >>> value = gaussian.force(1.0, h=0.7, s=1.0, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.358608
    """
    require(h=h, s=s, E_star=E_star, dgamma=dgamma)
    return elementwise(_force, a, h=h, s=s, E_star=E_star, dgamma=dgamma)


def pressure(r: ArrayLike, a: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact pressure, positive in compression, infinite tension at the edge; zero outside the contact.

    p = -sqrt(2)*sqrt(E_star)*sqrt(a)*sqrt(dgamma)/(sqrt(pi)*sqrt(a**2 - r**2)) +
    E_star*Integral((2*h*Dawson(sqrt(r**2 + u**2)/s)/s + 2*h*(1 - 2*sqrt(r**2 + u**2)*Dawson(sqrt(r**2 +
    u**2)/s)/s)*sqrt(r**2 + u**2)/s**2)/sqrt(r**2 + u**2), (u, 0, sqrt(a**2 - r**2)))/pi
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.

    Returns
    -------
    float or ndarray
        Contact pressure, positive in compression [Pa]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for h << s. Negative or NaN radii give NaN. Handbook: gaussian.adh.p.

    References
    ----------
    chapter 11, equation (11.31); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.adhesive import gaussian
    >>> value = gaussian.pressure(0.3, 1.0, h=0.7, s=1.0, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.441947
    """
    require(h=h, s=s, E_star=E_star, dgamma=dgamma)
    return elementwise(_pressure, r, a, h=h, s=s, E_star=E_star, dgamma=dgamma)


def displacement(
    r: ArrayLike, a: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike
) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*Integral(psi*r*(2*h*r*(-2*r*sin(psi)*Dawson(r*sin(psi)/s)/s + 1)*sin(psi)/s**2 +
    2*h*Dawson(r*sin(psi)/s)/s)*cos(psi), (psi, 0, asin(a/r)))/pi -
    2*sqrt(2)*sqrt(a)*sqrt(dgamma)*asin(a/r)/(sqrt(pi)*sqrt(E_star))
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.

    Returns
    -------
    float or ndarray
        Surface displacement into the half-space [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for h << s. Negative or NaN radii give NaN. Handbook: gaussian.adh.w.

    References
    ----------
    chapter 11, equation (11.31); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.adhesive import gaussian
    >>> value = gaussian.displacement(2.0, 1.0, h=0.7, s=1.0, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.056366
    """
    require(h=h, s=s, E_star=E_star, dgamma=dgamma)
    return elementwise(_displacement, r, a, h=h, s=s, E_star=E_star, dgamma=dgamma)


def radius_from_depth(d: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact radius at indentation depth d, on the branch that is stable under a given depth.

    a from 2*a*h*Dawson(a/s)/s - sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star) = d
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.

    Returns
    -------
    float or ndarray
        Contact radius [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for h << s. NaN below pull-off. Where several radii are stable, the largest, which is reached on
    unloading. Handbook: gaussian.adh.ad.

    References
    ----------
    chapter 11, equation (11.31); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.adhesive import gaussian
    >>> value = gaussian.radius_from_depth(0.5026, h=0.7, s=1.0, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.999907
    """
    require(h=h, s=s, E_star=E_star, dgamma=dgamma)
    return elementwise(_radius_from_depth, d=d, h=h, s=s, E_star=E_star, dgamma=dgamma)


def radius_from_force(F: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact radius under the normal force F, on the branch that is stable under a given force.

    a from -2*sqrt(2)*sqrt(pi)*sqrt(E_star)*a**(3/2)*sqrt(dgamma) + 2*E_star*h*(-a + (2*a**2 +
    s**2)*Dawson(a/s)/s) = F
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    F : array_like
        Normal force [N].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.

    Returns
    -------
    float or ndarray
        Contact radius [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for h << s. NaN below pull-off. Where several radii are stable, the largest, which is reached on
    unloading. Handbook: gaussian.adh.aF.

    References
    ----------
    chapter 11, equation (11.31); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.adhesive import gaussian
    >>> value = gaussian.radius_from_force(0.3586, h=0.7, s=1.0, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.999985
    """
    require(h=h, s=s, E_star=E_star, dgamma=dgamma)
    return elementwise(_radius_from_force, F=F, h=h, s=s, E_star=E_star, dgamma=dgamma)


def pull_off(control: str = "force", *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> PullOff:
    """State at which the contact breaks on unloading.

    Under control of the force:

        g'(a_c) = 3*sqrt(2)*sqrt(pi)*sqrt(dgamma)/(2*sqrt(E_star)*sqrt(a_c))
        F = F(a_c)
        d = d(a_c)
        with the depth g(a) without adhesion

    Under control of the depth:

        g'(a_c) = sqrt(2)*sqrt(pi)*sqrt(dgamma)/(2*sqrt(E_star)*sqrt(a_c))
        F = F(a_c)
        d = d(a_c)
        with the depth g(a) without adhesion

    Parameters
    ----------
    control : {"force", "depth"}
        What is held while the contact is unloaded.
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.

    Returns
    -------
    PullOff
        Named tuple of radius [m], force [N] and depth [m]; NaN without a stable contact.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    The least force, or depth, of a stable contact. Where it has several minima, or one at a corner of the
    profile, the lowest. Handbook: gaussian.adh.ac, gaussian.adh.am.

    References
    ----------
    chapter 11, equation (11.31); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.adhesive import gaussian
    >>> state = gaussian.pull_off(h=0.7, s=1.0, E_star=1.0, dgamma=0.01)
    >>> round(state.force, 6)
    -0.035788
    """
    require(h=h, s=s, E_star=E_star, dgamma=dgamma)
    require_control(control)
    radius = elementwise(partial(_pull_off_radius, control=control), h=h, s=s, E_star=E_star, dgamma=dgamma)
    force = elementwise(_force, radius, h=h, s=s, E_star=E_star, dgamma=dgamma)
    depth = elementwise(_depth, radius, h=h, s=s, E_star=E_star, dgamma=dgamma)
    return PullOff(radius, force, depth)


def work_of_adhesion_from_pull_off(F: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike) -> Result:
    """Work of separation at which a contact breaks under the normal force F: the inverse of the force of pull_off.

    dgamma = (F_N + abs(F))**2/(8*pi*E_star*a**3) at the radius a at which it is least, F_N the force without
    adhesion there

    Parameters
    ----------
    F : array_like
        Normal force [N].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Work of separation per unit area [N/m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for h << s. The force is a tension, F < 0: 0 without a force, NaN under pressure, which breaks no
    contact, and where no stable contact bears the tension.

    References
    ----------
    chapter 11, equation (11.31); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.adhesive import gaussian
    >>> value = gaussian.work_of_adhesion_from_pull_off(-0.03579, h=0.7, s=1.0, E_star=1.0)
    >>> round(value, 6)
    0.010001
    """
    require(h=h, s=s, E_star=E_star)
    return elementwise(_work_of_adhesion_from_pull_off, F=F, h=h, s=s, E_star=E_star)


def _depth(a: Array, h: Array, s: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._depth(a, h, s) - hess_retraction(a, E_star, dgamma)


def _force(a: Array, h: Array, s: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._force(a, h, s, E_star) - pull(a, E_star, dgamma)


def _pressure(r: Array, a: Array, h: Array, s: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._pressure(r, a, h, s, E_star) - tension(r, a, E_star, dgamma)


def _displacement(r: Array, a: Array, h: Array, s: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._displacement(r, a, h, s) - lift(r, a, E_star, dgamma)


def _rate(a: Array, h: Array, s: Array) -> Array:
    """Derivative g'(a) of the depth without adhesion."""
    return normal._slope(a, h, s)


@Kept
def _samples(h: Array, s: Array) -> Samples:
    """The steepness at radii that separate the minima of the load."""
    a = radii_to(1.5019752682686114 * s)
    return Samples(a, np.sqrt(a) * _rate(a, h, s), a[-1], {})


def _branches(h: Array, s: Array, E_star: Array, dgamma: Array, control: str) -> Branches:
    return branches(lambda a: np.sqrt(a) * _rate(a, h, s), _samples(h, s), least_steepness(control, E_star, dgamma))


def _pull_off_radius(h: Array, s: Array, E_star: Array, dgamma: Array, control: str) -> Array:
    unit = exponent_of(s)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    h = np.ldexp(h, -unit)
    s = np.ldexp(s, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    found = _branches(h, s, E_star, dgamma, control)
    load = _force if control == "force" else _depth
    radius = lowest(found, lambda a: load(a, h, s, E_star, dgamma))
    return np.ldexp(radius, unit)


def _radius_from_depth(d: Array, h: Array, s: Array, E_star: Array, dgamma: Array) -> Array:
    unit = exponent_of(s)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    h = np.ldexp(h, -unit)
    s = np.ldexp(s, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    d = np.ldexp(d, -unit)
    found = _branches(h, s, E_star, dgamma, control="depth")
    radius = stable_radius(
        d,
        found,
        lambda a: _depth(a, h, s, E_star, dgamma),
        lambda a: growth(_rate(a, h, s), a, "depth", E_star, dgamma),
        lambda a: hess_retraction(a, E_star, dgamma),
        on_the_bump(s),
    )
    return np.ldexp(radius, unit)


def _radius_from_force(F: Array, h: Array, s: Array, E_star: Array, dgamma: Array) -> Array:
    unit = exponent_of(s)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    h = np.ldexp(h, -unit)
    s = np.ldexp(s, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    F = np.ldexp(F, -(stress + 2 * unit))
    found = _branches(h, s, E_star, dgamma, control="force")
    radius = stable_radius(
        F,
        found,
        lambda a: _force(a, h, s, E_star, dgamma),
        lambda a: growth(_rate(a, h, s), a, "force", E_star, dgamma),
        lambda a: pull(a, E_star, dgamma),
        on_the_bump(s),
    )
    return np.ldexp(radius, unit)


@Kept
def _held_samples(h: Array, s: Array) -> Samples:
    """The force that can be held, over the modulus, at radii that separate the minima of the work of separation."""
    a = radii_to(1.5019752682686114 * s)
    return Samples(a, held(a, _rate(a, h, s), normal._force(a, h, s, 1.0)), a[-1], {})


def _work_of_adhesion_from_pull_off(F: Array, h: Array, s: Array, E_star: Array) -> Array:
    unit = exponent_of(s)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    h = np.ldexp(h, -unit)
    s = np.ldexp(s, -unit)
    F = np.ldexp(F, -(stress + 2 * unit))
    pull = np.where(F < 0.0, -F, np.nan)
    found = branches(lambda a: held(a, _rate(a, h, s), normal._force(a, h, s, 1.0)), _held_samples(h, s), pull / E_star)
    a = lowest(found, lambda a: separation(pull + normal._force(a, h, s, E_star), a, E_star))
    work = separation(pull + normal._force(a, h, s, E_star), a, E_star)
    return np.where(F == 0.0, 0.0, np.ldexp(work, stress + unit))
