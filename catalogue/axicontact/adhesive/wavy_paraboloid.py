"""Wavy paraboloid with adhesion.

A paraboloid with concentric waves of amplitude h, 2h from valley to peak, too shallow to leave gaps.
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
from .._runtime.physics.branches import Branches, Samples, branches, exponent_of, lowest, radii_of_waves
from .._runtime.physics.stable import growth, stable_radius
from .._runtime.physics.unknowns import radius_itself
from ..normal import wavy_paraboloid as normal

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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN radii give NaN. Handbook:
    wavy_paraboloid.adh.Dl.

    References
    ----------
    chapter 11, equation (11.31); Guduru 2007.

    Examples
    --------
    >>> from axicontact.adhesive import wavy_paraboloid
    >>> value = wavy_paraboloid.retraction(1.0, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.250663
    """
    require(E_star=E_star, dgamma=dgamma)
    return elementwise(hess_retraction, a, E_star=E_star, dgamma=dgamma)


def depth(
    a: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike
) -> Result:
    """Indentation depth at contact radius a; negative where adhesion pulls the surface up.

    d = a*(pi**2*h*StruveH(0, 2*pi*a/wavelength)/wavelength + a/R) -
    sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star)
    with StruveH: Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN radii give NaN. Handbook:
    wavy_paraboloid.adh.d.

    References
    ----------
    chapter 11, equation (11.31); Guduru 2007.

    Examples
    --------
    >>> from axicontact.adhesive import wavy_paraboloid
    >>> value = wavy_paraboloid.depth(1.0, R=1.6, h=0.01, wavelength=0.5, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.352564
    """
    normal._check(R=R, h=h, wavelength=wavelength, E_star=E_star, dgamma=dgamma)
    return elementwise(_depth, a, R=R, h=h, wavelength=wavelength, E_star=E_star, dgamma=dgamma)


def force(
    a: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike
) -> Result:
    """Normal force at contact radius a, negative in tension.

    F = -2*sqrt(2)*sqrt(pi)*sqrt(E_star)*a**(3/2)*sqrt(dgamma) + E_star*a*(2*pi**2*a*h*StruveH(0,
    2*pi*a/wavelength)/wavelength - pi*h*StruveH(1, 2*pi*a/wavelength) + 4*a**2/(3*R))
    with StruveH: Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN radii give NaN. Handbook:
    wavy_paraboloid.adh.F.

    References
    ----------
    chapter 11, equation (11.31); Guduru 2007.

    Examples
    --------
    >>> from axicontact.adhesive import wavy_paraboloid
    >>> value = wavy_paraboloid.force(1.0, R=1.6, h=0.01, wavelength=0.5, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.273489
    """
    normal._check(R=R, h=h, wavelength=wavelength, E_star=E_star, dgamma=dgamma)
    return elementwise(_force, a, R=R, h=h, wavelength=wavelength, E_star=E_star, dgamma=dgamma)


def pressure(
    r: ArrayLike,
    a: ArrayLike,
    *,
    R: ArrayLike,
    h: ArrayLike,
    wavelength: ArrayLike,
    E_star: ArrayLike,
    dgamma: ArrayLike,
) -> Result:
    """Contact pressure, positive in compression, infinite tension at the edge; zero outside the contact.

    p = -sqrt(2)*sqrt(E_star)*sqrt(a)*sqrt(dgamma)/(sqrt(pi)*sqrt(a**2 - r**2)) +
    E_star*Integral((pi**2*h*StruveH(0, 2*pi*sqrt(r**2 + u**2)/wavelength)/wavelength + sqrt(r**2 +
    u**2)*(2*pi**3*h*(-StruveH(1, 2*pi*sqrt(r**2 + u**2)/wavelength) + 2/pi)/wavelength**2 + 1/R) + sqrt(r**2
    + u**2)/R)/sqrt(r**2 + u**2), (u, 0, sqrt(a**2 - r**2)))/pi
    with StruveH: Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN radii give NaN. Handbook:
    wavy_paraboloid.adh.p.

    References
    ----------
    chapter 11, equation (11.31); Guduru 2007.

    Examples
    --------
    >>> from axicontact.adhesive import wavy_paraboloid
    >>> value = wavy_paraboloid.pressure(0.3, 1.0, R=1.6, h=0.01, wavelength=0.5, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.230037
    """
    normal._check(R=R, h=h, wavelength=wavelength, E_star=E_star, dgamma=dgamma)
    return elementwise(_pressure, r, a, R=R, h=h, wavelength=wavelength, E_star=E_star, dgamma=dgamma)


def displacement(
    r: ArrayLike,
    a: ArrayLike,
    *,
    R: ArrayLike,
    h: ArrayLike,
    wavelength: ArrayLike,
    E_star: ArrayLike,
    dgamma: ArrayLike,
) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*Integral(psi*r*(pi**2*h*StruveH(0, 2*pi*r*sin(psi)/wavelength)/wavelength +
    r*(2*pi**3*h*(-StruveH(1, 2*pi*r*sin(psi)/wavelength) + 2/pi)/wavelength**2 + 1/R)*sin(psi) +
    r*sin(psi)/R)*cos(psi), (psi, 0, asin(a/r)))/pi -
    2*sqrt(2)*sqrt(a)*sqrt(dgamma)*asin(a/r)/(sqrt(pi)*sqrt(E_star))
    with StruveH: Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN radii give NaN. Handbook:
    wavy_paraboloid.adh.w.

    References
    ----------
    chapter 11, equation (11.31); Guduru 2007.

    Examples
    --------
    >>> from axicontact.adhesive import wavy_paraboloid
    >>> value = wavy_paraboloid.displacement(2.0, 1.0, R=1.6, h=0.01, wavelength=0.5, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.04305
    """
    normal._check(R=R, h=h, wavelength=wavelength, E_star=E_star, dgamma=dgamma)
    return elementwise(_displacement, r, a, R=R, h=h, wavelength=wavelength, E_star=E_star, dgamma=dgamma)


def radius_from_depth(
    d: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike
) -> Result:
    """Contact radius at indentation depth d, on the branch that is stable under a given depth.

    a from a*(pi**2*h*StruveH(0, 2*pi*a/wavelength)/wavelength + a/R) -
    sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star) = d
    with StruveH: Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
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
    Valid for a << R; waves so flat that g' >= 0 for every a. NaN below pull-off. Where several radii are
    stable, the largest, which is reached on unloading. Handbook: wavy_paraboloid.adh.ad.

    References
    ----------
    chapter 11, equation (11.31); Guduru 2007.

    Examples
    --------
    >>> from axicontact.adhesive import wavy_paraboloid
    >>> value = wavy_paraboloid.radius_from_depth(0.3526, R=1.6, h=0.01, wavelength=0.5, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    1.000024
    """
    normal._check(R=R, h=h, wavelength=wavelength, E_star=E_star, dgamma=dgamma)
    return elementwise(_radius_from_depth, d=d, R=R, h=h, wavelength=wavelength, E_star=E_star, dgamma=dgamma)


def radius_from_force(
    F: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike
) -> Result:
    """Contact radius under the normal force F, on the branch that is stable under a given force.

    a from -2*sqrt(2)*sqrt(pi)*sqrt(E_star)*a**(3/2)*sqrt(dgamma) + E_star*a*(2*pi**2*a*h*StruveH(0,
    2*pi*a/wavelength)/wavelength - pi*h*StruveH(1, 2*pi*a/wavelength) + 4*a**2/(3*R)) = F
    with StruveH: Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
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
    Valid for a << R; waves so flat that g' >= 0 for every a. NaN below pull-off. Where several radii are
    stable, the largest, which is reached on unloading. Handbook: wavy_paraboloid.adh.aF.

    References
    ----------
    chapter 11, equation (11.31); Guduru 2007.

    Examples
    --------
    >>> from axicontact.adhesive import wavy_paraboloid
    >>> value = wavy_paraboloid.radius_from_force(0.2735, R=1.6, h=0.01, wavelength=0.5, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    1.000005
    """
    normal._check(R=R, h=h, wavelength=wavelength, E_star=E_star, dgamma=dgamma)
    return elementwise(_radius_from_force, F=F, R=R, h=h, wavelength=wavelength, E_star=E_star, dgamma=dgamma)


def pull_off(
    control: str = "force", *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike
) -> PullOff:
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
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
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
    profile, the lowest. Handbook: wavy_paraboloid.adh.ac, wavy_paraboloid.adh.am.

    References
    ----------
    chapter 11, equation (11.31); Guduru 2007.

    Examples
    --------
    >>> from axicontact.adhesive import wavy_paraboloid
    >>> state = wavy_paraboloid.pull_off(R=1.6, h=0.01, wavelength=0.5, E_star=1.0, dgamma=0.01)
    >>> round(state.force, 6)
    -0.101395
    """
    normal._check(R=R, h=h, wavelength=wavelength, E_star=E_star, dgamma=dgamma)
    require_control(control)
    radius = elementwise(
        partial(_pull_off_radius, control=control), R=R, h=h, wavelength=wavelength, E_star=E_star, dgamma=dgamma
    )
    force = elementwise(_force, radius, R=R, h=h, wavelength=wavelength, E_star=E_star, dgamma=dgamma)
    depth = elementwise(_depth, radius, R=R, h=h, wavelength=wavelength, E_star=E_star, dgamma=dgamma)
    return PullOff(radius, force, depth)


def work_of_adhesion_from_pull_off(
    F: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, E_star: ArrayLike
) -> Result:
    """Work of separation at which a contact breaks under the normal force F: the inverse of the force of pull_off.

    dgamma = (F_N + abs(F))**2/(8*pi*E_star*a**3) at the radius a at which it is least, F_N the force without
    adhesion there

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
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
    Valid for a << R; waves so flat that g' >= 0 for every a. The force is a tension, F < 0: 0 without a
    force, NaN under pressure, which breaks no contact, and where no stable contact bears the tension.

    References
    ----------
    chapter 11, equation (11.31); Guduru 2007.

    Examples
    --------
    >>> from axicontact.adhesive import wavy_paraboloid
    >>> value = wavy_paraboloid.work_of_adhesion_from_pull_off(-0.1014, R=1.6, h=0.01, wavelength=0.5, E_star=1.0)
    >>> round(value, 6)
    0.010001
    """
    normal._check(R=R, h=h, wavelength=wavelength, E_star=E_star)
    return elementwise(_work_of_adhesion_from_pull_off, F=F, R=R, h=h, wavelength=wavelength, E_star=E_star)


def _depth(a: Array, R: Array, h: Array, wavelength: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._depth(a, R, h, wavelength) - hess_retraction(a, E_star, dgamma)


def _force(a: Array, R: Array, h: Array, wavelength: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._force(a, R, h, wavelength, E_star) - pull(a, E_star, dgamma)


def _pressure(r: Array, a: Array, R: Array, h: Array, wavelength: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._pressure(r, a, R, h, wavelength, E_star) - tension(r, a, E_star, dgamma)


def _displacement(r: Array, a: Array, R: Array, h: Array, wavelength: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._displacement(r, a, R, h, wavelength) - lift(r, a, E_star, dgamma)


def _rate(a: Array, R: Array, h: Array, wavelength: Array) -> Array:
    """Derivative g'(a) of the depth without adhesion."""
    return normal._slope(a, R, h, wavelength)


@Kept
def _samples(R: Array, h: Array, wavelength: Array, E_star: Array, dgamma: Array) -> Samples:
    """The steepness at radii that separate the minima of the load."""
    a = radii_of_waves(wavelength, (np.sqrt(4.5 * np.pi * dgamma / E_star) * 2.0 * R) ** (2.0 / 3.0))
    return Samples(a, np.sqrt(a) * _rate(a, R, h, wavelength), np.inf, {})


def _branches(R: Array, h: Array, wavelength: Array, E_star: Array, dgamma: Array, control: str) -> Branches:
    return branches(
        lambda a: np.sqrt(a) * _rate(a, R, h, wavelength),
        _samples(R, h, wavelength, E_star, dgamma),
        least_steepness(control, E_star, dgamma),
    )


def _pull_off_radius(R: Array, h: Array, wavelength: Array, E_star: Array, dgamma: Array, control: str) -> Array:
    unit = exponent_of(wavelength)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R = np.ldexp(R, -unit)
    h = np.ldexp(h, -unit)
    wavelength = np.ldexp(wavelength, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    found = _branches(R, h, wavelength, E_star, dgamma, control)
    load = _force if control == "force" else _depth
    radius = lowest(found, lambda a: load(a, R, h, wavelength, E_star, dgamma))
    return np.ldexp(radius, unit)


def _radius_from_depth(d: Array, R: Array, h: Array, wavelength: Array, E_star: Array, dgamma: Array) -> Array:
    unit = exponent_of(wavelength)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R = np.ldexp(R, -unit)
    h = np.ldexp(h, -unit)
    wavelength = np.ldexp(wavelength, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    d = np.ldexp(d, -unit)
    found = _branches(R, h, wavelength, E_star, dgamma, control="depth")
    radius = stable_radius(
        d,
        found,
        lambda a: _depth(a, R, h, wavelength, E_star, dgamma),
        lambda a: growth(_rate(a, R, h, wavelength), a, "depth", E_star, dgamma),
        lambda a: hess_retraction(a, E_star, dgamma),
        radius_itself(),
    )
    return np.ldexp(radius, unit)


def _radius_from_force(F: Array, R: Array, h: Array, wavelength: Array, E_star: Array, dgamma: Array) -> Array:
    unit = exponent_of(wavelength)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R = np.ldexp(R, -unit)
    h = np.ldexp(h, -unit)
    wavelength = np.ldexp(wavelength, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    F = np.ldexp(F, -(stress + 2 * unit))
    found = _branches(R, h, wavelength, E_star, dgamma, control="force")
    radius = stable_radius(
        F,
        found,
        lambda a: _force(a, R, h, wavelength, E_star, dgamma),
        lambda a: growth(_rate(a, R, h, wavelength), a, "force", E_star, dgamma),
        lambda a: pull(a, E_star, dgamma),
        radius_itself(),
    )
    return np.ldexp(radius, unit)


@Kept
def _held_samples(R: Array, h: Array, wavelength: Array, E_star: Array, pull: Array) -> Samples:
    """The force that can be held, over the modulus, at radii that separate the minima of the work of separation."""
    a = radii_of_waves(wavelength, (12.0 * R * pull / E_star) ** (1.0 / 3.0))
    return Samples(a, held(a, _rate(a, R, h, wavelength), normal._force(a, R, h, wavelength, 1.0)), np.inf, {})


def _work_of_adhesion_from_pull_off(F: Array, R: Array, h: Array, wavelength: Array, E_star: Array) -> Array:
    unit = exponent_of(wavelength)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R = np.ldexp(R, -unit)
    h = np.ldexp(h, -unit)
    wavelength = np.ldexp(wavelength, -unit)
    F = np.ldexp(F, -(stress + 2 * unit))
    pull = np.where(F < 0.0, -F, np.nan)
    found = branches(
        lambda a: held(a, _rate(a, R, h, wavelength), normal._force(a, R, h, wavelength, 1.0)),
        _held_samples(R, h, wavelength, E_star, pull),
        pull / E_star,
    )
    a = lowest(found, lambda a: separation(pull + normal._force(a, R, h, wavelength, E_star), a, E_star))
    work = separation(pull + normal._force(a, R, h, wavelength, E_star), a, E_star)
    return np.where(F == 0.0, 0.0, np.ldexp(work, stress + unit))
