"""Cone with a spherical tip with adhesion.

Sphere of radius R up to b = R sin(theta), then its tangent cone: the exact sphero-conical tip.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from .._runtime.functions import sine_root
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
from .._runtime.physics.branches import Branches, Samples, branches, exponent_of, lowest, radii_around
from .._runtime.physics.stable import growth, stable_radius
from .._runtime.physics.unknowns import beyond_edge, up_to
from ..normal import sphere_tipped_cone as normal

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
    Valid for tan(theta) << 1. Negative or NaN radii give NaN. Handbook: sphere_tipped_cone.adh.Dl.

    References
    ----------
    chapter 11, equation (11.31).

    Examples
    --------
    >>> from axicontact.adhesive import sphere_tipped_cone
    >>> value = sphere_tipped_cone.retraction(1.0, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.250663
    """
    require(E_star=E_star, dgamma=dgamma)
    return elementwise(hess_retraction, a, E_star=E_star, dgamma=dgamma)


def depth(a: ArrayLike, *, R: ArrayLike, theta: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Indentation depth at contact radius a; negative where adhesion pulls the surface up.

    d = a*atanh(a/R) - sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star)   for a < b
    d = a*(b*acos(b/a)/(sqrt(R - b)*sqrt(R + b)) + log((R + a)/(sqrt(R**2 - b**2) + sqrt(a**2 - b**2)))) -
    sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star)   for b < a
    with b = R*sin(theta)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN radii give NaN. Handbook: sphere_tipped_cone.adh.d.

    References
    ----------
    chapter 11, equation (11.31).

    Examples
    --------
    >>> from axicontact.adhesive import sphere_tipped_cone
    >>> value = sphere_tipped_cone.depth(1.0, R=1.2, theta=0.45, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.371972
    """
    require(R=R, theta=theta, E_star=E_star, dgamma=dgamma)
    return elementwise(_depth, a, R=R, theta=theta, E_star=E_star, dgamma=dgamma)


def force(a: ArrayLike, *, R: ArrayLike, theta: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Normal force at contact radius a, negative in tension.

    F = -2*sqrt(2)*sqrt(pi)*sqrt(E_star)*a**(3/2)*sqrt(dgamma) + E_star*(-R*a + (R**2 + a**2)*atanh(a/R))
    for a < b
    F = -2*sqrt(2)*sqrt(pi)*sqrt(E_star)*a**(3/2)*sqrt(dgamma) + E_star*(-R*a + a**2*b*acos(b/a)/(sqrt(R -
    b)*sqrt(R + b)) + b**2*sqrt(a**2 - b**2)/(sqrt(R - b)*sqrt(R + b)) + (R**2 + a**2)*log((R + a)/(sqrt(R**2
    - b**2) + sqrt(a**2 - b**2))) + sqrt(R**2 - b**2)*sqrt(a**2 - b**2))   for b < a
    with b = R*sin(theta)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN radii give NaN. Handbook: sphere_tipped_cone.adh.F.

    References
    ----------
    chapter 11, equation (11.31).

    Examples
    --------
    >>> from axicontact.adhesive import sphere_tipped_cone
    >>> value = sphere_tipped_cone.force(1.0, R=1.2, theta=0.45, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.243975
    """
    require(R=R, theta=theta, E_star=E_star, dgamma=dgamma)
    return elementwise(_force, a, R=R, theta=theta, E_star=E_star, dgamma=dgamma)


def pressure(
    r: ArrayLike, a: ArrayLike, *, R: ArrayLike, theta: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike
) -> Result:
    """Contact pressure, positive in compression, infinite tension at the edge; zero outside the contact.

    p = -E_star*retraction/(pi*sqrt(a**2 - r**2)) + E_star*Integral(Derivative(g(t), t)/sqrt(-r**2 + t**2),
    (t, r, a))/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN radii give NaN. Handbook: sphere_tipped_cone.adh.p.

    References
    ----------
    chapter 11, equation (11.31).

    Examples
    --------
    >>> from axicontact.adhesive import sphere_tipped_cone
    >>> value = sphere_tipped_cone.pressure(0.3, 1.0, R=1.2, theta=0.45, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.344863
    """
    require(R=R, theta=theta, E_star=E_star, dgamma=dgamma)
    return elementwise(_pressure, r, a, R=R, theta=theta, E_star=E_star, dgamma=dgamma)


def displacement(
    r: ArrayLike, a: ArrayLike, *, R: ArrayLike, theta: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike
) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = -2*retraction*asin(a/r)/pi + 2*Integral(asin(t/r)*Derivative(g(t), t), (t, 0, a))/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN radii give NaN. Handbook: sphere_tipped_cone.adh.w.

    References
    ----------
    chapter 11, equation (11.31).

    Examples
    --------
    >>> from axicontact.adhesive import sphere_tipped_cone
    >>> value = sphere_tipped_cone.displacement(2.0, 1.0, R=1.2, theta=0.45, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.037867
    """
    require(R=R, theta=theta, E_star=E_star, dgamma=dgamma)
    return elementwise(_displacement, r, a, R=R, theta=theta, E_star=E_star, dgamma=dgamma)


def radius_from_depth(d: ArrayLike, *, R: ArrayLike, theta: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact radius at indentation depth d, on the branch that is stable under a given depth.

    a from a*atanh(a/R) - sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star) = d   for a < b
    a from a*(b*acos(b/a)/(sqrt(R - b)*sqrt(R + b)) + log((R + a)/(sqrt(R**2 - b**2) + sqrt(a**2 - b**2)))) -
    sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star) = d   for b < a
    with b = R*sin(theta)

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. NaN below pull-off. Where several radii are stable, the largest, which is
    reached on unloading. Handbook: sphere_tipped_cone.adh.ad.

    References
    ----------
    chapter 11, equation (11.31).

    Examples
    --------
    >>> from axicontact.adhesive import sphere_tipped_cone
    >>> value = sphere_tipped_cone.radius_from_depth(0.372, R=1.2, theta=0.45, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    1.000043
    """
    require(R=R, theta=theta, E_star=E_star, dgamma=dgamma)
    return elementwise(_radius_from_depth, d=d, R=R, theta=theta, E_star=E_star, dgamma=dgamma)


def radius_from_force(F: ArrayLike, *, R: ArrayLike, theta: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact radius under the normal force F, on the branch that is stable under a given force.

    a from -2*sqrt(2)*sqrt(pi)*sqrt(E_star)*a**(3/2)*sqrt(dgamma) + E_star*(-R*a + (R**2 + a**2)*atanh(a/R)) =
    F   for a < b
    a from -2*sqrt(2)*sqrt(pi)*sqrt(E_star)*a**(3/2)*sqrt(dgamma) + E_star*(-R*a + a**2*b*acos(b/a)/(sqrt(R -
    b)*sqrt(R + b)) + b**2*sqrt(a**2 - b**2)/(sqrt(R - b)*sqrt(R + b)) + (R**2 + a**2)*log((R + a)/(sqrt(R**2
    - b**2) + sqrt(a**2 - b**2))) + sqrt(R**2 - b**2)*sqrt(a**2 - b**2)) = F   for b < a
    with b = R*sin(theta)

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. NaN below pull-off. Where several radii are stable, the largest, which is
    reached on unloading. Handbook: sphere_tipped_cone.adh.aF.

    References
    ----------
    chapter 11, equation (11.31).

    Examples
    --------
    >>> from axicontact.adhesive import sphere_tipped_cone
    >>> value = sphere_tipped_cone.radius_from_force(0.244, R=1.2, theta=0.45, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    1.000032
    """
    require(R=R, theta=theta, E_star=E_star, dgamma=dgamma)
    return elementwise(_radius_from_force, F=F, R=R, theta=theta, E_star=E_star, dgamma=dgamma)


def pull_off(
    control: str = "force", *, R: ArrayLike, theta: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike
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
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    profile, the lowest. Handbook: sphere_tipped_cone.adh.ac, sphere_tipped_cone.adh.am.

    References
    ----------
    chapter 11, equation (11.31).

    Examples
    --------
    >>> from axicontact.adhesive import sphere_tipped_cone
    >>> state = sphere_tipped_cone.pull_off(R=1.2, theta=0.45, E_star=1.0, dgamma=0.01)
    >>> round(state.force, 6)
    -0.054484
    """
    require(R=R, theta=theta, E_star=E_star, dgamma=dgamma)
    require_control(control)
    radius = elementwise(partial(_pull_off_radius, control=control), R=R, theta=theta, E_star=E_star, dgamma=dgamma)
    force = elementwise(_force, radius, R=R, theta=theta, E_star=E_star, dgamma=dgamma)
    depth = elementwise(_depth, radius, R=R, theta=theta, E_star=E_star, dgamma=dgamma)
    return PullOff(radius, force, depth)


def work_of_adhesion_from_pull_off(F: ArrayLike, *, R: ArrayLike, theta: ArrayLike, E_star: ArrayLike) -> Result:
    """Work of separation at which a contact breaks under the normal force F: the inverse of the force of pull_off.

    dgamma = (F_N + abs(F))**2/(8*pi*E_star*a**3) at the radius a at which it is least, F_N the force without
    adhesion there

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. The force is a tension, F < 0: 0 without a force, NaN under pressure, which
    breaks no contact, and where no stable contact bears the tension.

    References
    ----------
    chapter 11, equation (11.31).

    Examples
    --------
    >>> from axicontact.adhesive import sphere_tipped_cone
    >>> value = sphere_tipped_cone.work_of_adhesion_from_pull_off(-0.05448, R=1.2, theta=0.45, E_star=1.0)
    >>> round(value, 6)
    0.009999
    """
    require(R=R, theta=theta, E_star=E_star)
    return elementwise(_work_of_adhesion_from_pull_off, F=F, R=R, theta=theta, E_star=E_star)


def _depth(a: Array, R: Array, theta: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._depth(a, R, theta) - hess_retraction(a, E_star, dgamma)


def _force(a: Array, R: Array, theta: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._force(a, R, theta, E_star) - pull(a, E_star, dgamma)


def _pressure(r: Array, a: Array, R: Array, theta: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._pressure(r, a, R, theta, E_star) - tension(r, a, E_star, dgamma)


def _displacement(r: Array, a: Array, R: Array, theta: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._displacement(r, a, R, theta) - lift(r, a, E_star, dgamma)


def _rate(a: Array, R: Array, theta: Array) -> Array:
    """Derivative g'(a) of the depth without adhesion."""
    root = sine_root(a, R, theta)
    return normal._slope_at(a, root, R, theta)


@Kept
def _samples(R: Array, theta: Array) -> Samples:
    """The steepness at radii that separate the minima of the load."""
    a = radii_around(R * np.sin(theta))
    return Samples(a, np.sqrt(a) * _rate(a, R, theta), np.inf, {})


def _branches(R: Array, theta: Array, E_star: Array, dgamma: Array, control: str) -> Branches:
    return branches(
        lambda a: np.sqrt(a) * _rate(a, R, theta), _samples(R, theta), least_steepness(control, E_star, dgamma)
    )


def _pull_off_radius(R: Array, theta: Array, E_star: Array, dgamma: Array, control: str) -> Array:
    unit = exponent_of(R * np.sin(theta))
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R = np.ldexp(R, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    found = _branches(R, theta, E_star, dgamma, control)
    load = _force if control == "force" else _depth
    radius = lowest(found, lambda a: load(a, R, theta, E_star, dgamma))
    return np.ldexp(radius, unit)


def _radius_from_depth(d: Array, R: Array, theta: Array, E_star: Array, dgamma: Array) -> Array:
    unit = exponent_of(R * np.sin(theta))
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R = np.ldexp(R, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    d = np.ldexp(d, -unit)
    found = _branches(R, theta, E_star, dgamma, control="depth")
    radius = stable_radius(
        d,
        found,
        lambda a: _depth(a, R, theta, E_star, dgamma),
        lambda a: growth(_rate(a, R, theta), a, "depth", E_star, dgamma),
        lambda a: hess_retraction(a, E_star, dgamma),
        up_to(R),
        beyond_edge(R * np.sin(theta)),
        corner=R * np.sin(theta),
    )
    return np.ldexp(radius, unit)


def _radius_from_force(F: Array, R: Array, theta: Array, E_star: Array, dgamma: Array) -> Array:
    unit = exponent_of(R * np.sin(theta))
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R = np.ldexp(R, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    F = np.ldexp(F, -(stress + 2 * unit))
    found = _branches(R, theta, E_star, dgamma, control="force")
    radius = stable_radius(
        F,
        found,
        lambda a: _force(a, R, theta, E_star, dgamma),
        lambda a: growth(_rate(a, R, theta), a, "force", E_star, dgamma),
        lambda a: pull(a, E_star, dgamma),
        up_to(R),
        beyond_edge(R * np.sin(theta)),
        corner=R * np.sin(theta),
    )
    return np.ldexp(radius, unit)


@Kept
def _held_samples(R: Array, theta: Array) -> Samples:
    """The force that can be held, over the modulus, at radii that separate the minima of the work of separation."""
    a = radii_around(R * np.sin(theta))
    return Samples(a, held(a, _rate(a, R, theta), normal._force(a, R, theta, 1.0)), np.inf, {})


def _work_of_adhesion_from_pull_off(F: Array, R: Array, theta: Array, E_star: Array) -> Array:
    unit = exponent_of(R * np.sin(theta))
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    R = np.ldexp(R, -unit)
    F = np.ldexp(F, -(stress + 2 * unit))
    pull = np.where(F < 0.0, -F, np.nan)
    found = branches(
        lambda a: held(a, _rate(a, R, theta), normal._force(a, R, theta, 1.0)), _held_samples(R, theta), pull / E_star
    )
    a = lowest(found, lambda a: separation(pull + normal._force(a, R, theta, E_star), a, E_star))
    work = separation(pull + normal._force(a, R, theta, E_star), a, E_star)
    return np.where(F == 0.0, 0.0, np.ldexp(work, stress + unit))
