"""Paraboloid with adhesion.

The tip of every smooth indenter and the parabolic approximation of the sphere: Hertz's contact.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, require
from .._runtime.physics.adhesion import (
    XI,
    PullOff,
    hess_retraction,
    lift,
    power_law_radius,
    pull,
    require_control,
    separation,
    tension,
)
from ..normal import paraboloid as normal

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
    Valid for a << R. Negative or NaN radii give NaN. Handbook: paraboloid.adh.Dl.

    References
    ----------
    chapter 11, equation (11.31); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.adhesive import paraboloid
    >>> value = paraboloid.retraction(1.0, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.250663
    """
    require(E_star=E_star, dgamma=dgamma)
    return elementwise(hess_retraction, a, E_star=E_star, dgamma=dgamma)


def depth(a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Indentation depth at contact radius a; negative where adhesion pulls the surface up.

    d = a**2/R - sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R. Negative or NaN radii give NaN. Handbook: paraboloid.adh.d.

    References
    ----------
    chapter 11, equation (11.31); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.adhesive import paraboloid
    >>> value = paraboloid.depth(1.0, R=1.6, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.374337
    """
    require(R=R, E_star=E_star, dgamma=dgamma)
    return elementwise(_depth, a, R=R, E_star=E_star, dgamma=dgamma)


def force(a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Normal force at contact radius a, negative in tension.

    F = -2*sqrt(2)*sqrt(pi)*sqrt(E_star)*a**(3/2)*sqrt(dgamma) + 4*E_star*a**3/(3*R)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R. Negative or NaN radii give NaN. Handbook: paraboloid.adh.F.

    References
    ----------
    chapter 11, equation (11.31); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.adhesive import paraboloid
    >>> value = paraboloid.force(1.0, R=1.6, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.332008
    """
    require(R=R, E_star=E_star, dgamma=dgamma)
    return elementwise(_force, a, R=R, E_star=E_star, dgamma=dgamma)


def pressure(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact pressure, positive in compression, infinite tension at the edge; zero outside the contact.

    p = -sqrt(2)*sqrt(E_star)*sqrt(a)*sqrt(dgamma)/(sqrt(pi)*sqrt(a**2 - r**2)) + 2*E_star*sqrt(a**2 -
    r**2)/(pi*R)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R. Negative or NaN radii give NaN. Handbook: paraboloid.adh.p.

    References
    ----------
    chapter 11, equation (11.31); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.adhesive import paraboloid
    >>> value = paraboloid.pressure(0.3, 1.0, R=1.6, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.295919
    """
    require(R=R, E_star=E_star, dgamma=dgamma)
    return elementwise(_pressure, r, a, R=R, E_star=E_star, dgamma=dgamma)


def displacement(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = (a*sqrt(-a**2 + r**2) - (-2*a**2 + r**2)*asin(a/r))/(pi*R) -
    2*sqrt(2)*sqrt(a)*sqrt(dgamma)*asin(a/r)/(sqrt(pi)*sqrt(E_star))

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R. Negative or NaN radii give NaN. Handbook: paraboloid.adh.w.

    References
    ----------
    chapter 11, equation (11.31); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.adhesive import paraboloid
    >>> value = paraboloid.displacement(2.0, 1.0, R=1.6, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.052693
    """
    require(R=R, E_star=E_star, dgamma=dgamma)
    return elementwise(_displacement, r, a, R=R, E_star=E_star, dgamma=dgamma)


def radius_from_depth(d: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact radius at indentation depth d, on the branch that is stable under a given depth.

    a from a**2/R - sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star) = d

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R. NaN below pull-off. Handbook: paraboloid.adh.ad.

    References
    ----------
    chapter 11, equation (11.31); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.adhesive import paraboloid
    >>> value = paraboloid.radius_from_depth(0.3743, R=1.6, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.999967
    """
    require(R=R, E_star=E_star, dgamma=dgamma)
    return elementwise(_radius_from_depth, d=d, R=R, E_star=E_star, dgamma=dgamma)


def radius_from_force(F: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact radius under the normal force F, on the branch that is stable under a given force.

    a = (sqrt(3*F*R/(4*E_star) + 9*pi*R**2*dgamma/(8*E_star)) +
    3*sqrt(2)*sqrt(pi)*R*sqrt(dgamma)/(4*sqrt(E_star)))**(2/3)

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R. NaN below pull-off. Handbook: paraboloid.adh.aF.

    References
    ----------
    chapter 11, equation (11.31); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.adhesive import paraboloid
    >>> value = paraboloid.radius_from_force(0.332, R=1.6, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.999996
    """
    require(R=R, E_star=E_star, dgamma=dgamma)
    return elementwise(_radius_from_force, F=F, R=R, E_star=E_star, dgamma=dgamma)


def pull_off(control: str = "force", *, R: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> PullOff:
    """State at which the contact breaks on unloading.

    Under control of the force:

        a_c = 3**(2/3)*pi**(1/3)*R**(2/3)*dgamma**(1/3)/(2*E_star**(1/3))
        F = -3*pi*R*dgamma/2
        d = -3**(1/3)*pi**(2/3)*R**(1/3)*dgamma**(2/3)/(4*E_star**(2/3))

    Under control of the depth:

        a_c = pi**(1/3)*R**(2/3)*dgamma**(1/3)/(2*E_star**(1/3))
        F = -5*pi*R*dgamma/6
        d = -3*pi**(2/3)*R**(1/3)*dgamma**(2/3)/(4*E_star**(2/3))

    Parameters
    ----------
    control : {"force", "depth"}
        What is held while the contact is unloaded.
    R : array_like
        Radius of curvature [m], R > 0.
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
    The least force, or depth, of a stable contact. Handbook: paraboloid.adh.ac, paraboloid.adh.am.

    References
    ----------
    chapter 11, equation (11.31); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.adhesive import paraboloid
    >>> state = paraboloid.pull_off(R=1.6, E_star=1.0, dgamma=0.01)
    >>> round(state.force, 6)
    -0.075398
    """
    require(R=R, E_star=E_star, dgamma=dgamma)
    require_control(control)
    radius = elementwise(partial(_pull_off_radius, control=control), R=R, E_star=E_star, dgamma=dgamma)
    force = elementwise(partial(_pull_off_force, control=control), radius, R=R, E_star=E_star, dgamma=dgamma)
    depth = elementwise(partial(_pull_off_depth, control=control), radius, R=R, E_star=E_star, dgamma=dgamma)
    return PullOff(radius, force, depth)


def work_of_adhesion_from_pull_off(F: ArrayLike, *, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Work of separation at which a contact breaks under the normal force F: the inverse of the force of pull_off.

    dgamma = 2*abs(F)/(3*pi*R)

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R. The force is a tension, F < 0: 0 without a force, NaN under pressure, which breaks no
    contact, and where no stable contact bears the tension.

    References
    ----------
    chapter 11, equation (11.31); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.adhesive import paraboloid
    >>> value = paraboloid.work_of_adhesion_from_pull_off(-0.0754, R=1.6, E_star=1.0)
    >>> round(value, 6)
    0.01
    """
    require(R=R, E_star=E_star)
    return elementwise(_work_of_adhesion_from_pull_off, F=F, R=R, E_star=E_star)


def _depth(a: Array, R: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._depth(a, R) - hess_retraction(a, E_star, dgamma)


def _force(a: Array, R: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._force(a, R, E_star) - pull(a, E_star, dgamma)


def _pressure(r: Array, a: Array, R: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._pressure(r, a, R, E_star) - tension(r, a, E_star, dgamma)


def _displacement(r: Array, a: Array, R: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._displacement(r, a, R) - lift(r, a, E_star, dgamma)


def _pull_off_radius(R: Array, E_star: Array, dgamma: Array, control: str) -> Array:
    if control == "force":
        radius = np.cbrt(9 * np.pi * R**2 * dgamma / (8 * E_star))
    else:
        radius = np.cbrt(np.pi * R**2 * dgamma / (8 * E_star))
    return np.where(dgamma > 0.0, radius, 0.0)


def _pull_off_depth(a: Array, R: Array, E_star: Array, dgamma: Array, control: str) -> Array:
    """With the retraction 2 a g'(a)/xi of pull-off, free of cancellation."""
    return normal._depth(a, R) * (1.0 - 4.0 / XI[control])


def _radius_from_depth(d: Array, R: Array, E_star: Array, dgamma: Array) -> Array:
    a_c = _pull_off_radius(R, E_star, dgamma, control="depth")
    least = _pull_off_depth(a_c, R, E_star, dgamma, control="depth")
    plain = normal._radius_from_depth(np.maximum(d, 0.0), R)
    return power_law_radius(d, a_c, least, 2.0, 0.5, plain)


def _pull_off_force(a: Array, R: Array, E_star: Array, dgamma: Array, control: str) -> Array:
    """With the retraction 2 a g'(a)/xi of pull-off, free of cancellation."""
    return normal._force(a, R, E_star) * (1.0 - 6.0 / XI[control])


def _radius_from_force(F: Array, R: Array, E_star: Array, dgamma: Array) -> Array:
    a_c = _pull_off_radius(R, E_star, dgamma, control="force")
    least = _pull_off_force(a_c, R, E_star, dgamma, control="force")
    plain = normal._radius_from_force(np.maximum(F, 0.0), R, E_star)
    return power_law_radius(F, a_c, least, 3.0, 1.5, plain)


def _work_of_adhesion_from_pull_off(F: Array, R: Array, E_star: Array) -> Array:
    pull = np.where(F < 0.0, -F, np.nan)
    lasting = pull
    a = normal._radius_from_force(lasting, R, E_star)
    return np.where(F == 0.0, 0.0, separation(pull + lasting, a, E_star))
