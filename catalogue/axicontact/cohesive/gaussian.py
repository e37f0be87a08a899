"""Gaussian bump with a cohesive zone.

A smooth asperity of height h and width s; compact up to the radius of largest depth.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from .._runtime.integrals import difference_root
from .._runtime.interface import Array, Result, either, elementwise, numbers, require, require_order
from .._runtime.physics.adhesion import PullOff, require_control
from .._runtime.physics.cohesive import (
    ENTIRE,
    Separated,
    alone,
    lift_of_zone,
    opening,
    outer_radius,
    pull_of_zone,
    root_of_zone,
    sunk,
    tension_of_zone,
    work_of_zone,
    zone_like,
    zone_within,
)
from .._runtime.physics.cohesive_states import (
    State,
    Stretch,
    parted,
    radii_on_bump,
    radius_of_pull_off,
    radius_under,
    state_near,
)
from ..normal import gaussian as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "cohesive_radius",
    "depth",
    "displacement",
    "force",
    "pressure",
    "pull_off",
    "radius_from_depth",
    "radius_from_force",
    "without_contact",
    "work_of_separation",
]


def __dir__() -> list[str]:
    return __all__


def work_of_separation(
    a: ArrayLike, c: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Work of separation with which the cohesive zone of a contact of radius a ends at c.

    dgamma = sigma_0*(-2*a*h*Dawson(a/s)/s + h*(1 - exp(-c**2/s**2)) +
    2*Integral(c*psi*(2*c*h*(-2*c*sin(psi)*Dawson(c*sin(psi)/s)/s +
    1)*sin(psi)/s**2 + 2*h*Dawson(c*sin(psi)/s)/s)*cos(psi), (psi, 0, asin(a/c)))/pi +
    4*sigma_0*(a - c + sqrt(-a**2 + c**2)*acos(a/c))/(pi*E_star))
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Outer radius of the cohesive zone [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    sigma_0 : array_like
        Greatest stress of the attraction [Pa], sigma_0 > 0.

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
    Valid for h << s. Negative or NaN field values give NaN, as do states whose zone would reach beyond the
    profile. Handbook: gaussian.coh.work.

    References
    ----------
    Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.cohesive import gaussian
    >>> value = gaussian.work_of_separation(1.0, 1.143, h=0.7, s=1.0, E_star=1.0, sigma_0=0.1)
    >>> round(value, 6)
    0.003453
    """
    require(h=h, s=s, E_star=E_star, sigma_0=sigma_0)
    require_order(
        np.all(~(numbers("a", a) > numbers("c", c))),
        "a <= c",
        "the zone surrounds the contact; exchange a and c",
        a=a,
        c=c,
    )
    return elementwise(_work_of_separation, a, c, h=h, s=s, E_star=E_star, sigma_0=sigma_0)


def cohesive_radius(
    a: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Outer radius c of the cohesive zone around a contact of radius a.

    c from sigma_0*(-2*a*h*Dawson(a/s)/s + h*(1 - exp(-c**2/s**2)) +
    2*Integral(c*psi*(2*c*h*(-2*c*sin(psi)*Dawson(c*sin(psi)/s)/s +
    1)*sin(psi)/s**2 + 2*h*Dawson(c*sin(psi)/s)/s)*cos(psi), (psi, 0, asin(a/c)))/pi +
    4*sigma_0*(a - c + sqrt(-a**2 + c**2)*acos(a/c))/(pi*E_star)) = dgamma
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
    sigma_0 : array_like
        Greatest stress of the attraction [Pa], sigma_0 > 0.

    Returns
    -------
    float or ndarray
        Outer radius of the cohesive zone [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for h << s. Negative or NaN field values give NaN, as do states whose zone would reach beyond the
    profile. Handbook: gaussian.coh.c.

    References
    ----------
    Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.cohesive import gaussian
    >>> value = gaussian.cohesive_radius(1.0, h=0.7, s=1.0, E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    1.403646
    """
    require(h=h, s=s, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_cohesive_radius, a, h=h, s=s, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def depth(
    a: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Indentation depth at contact radius a; negative where adhesion pulls the surface up.

    d = 2*a*h*Dawson(a/s)/s - 2*sigma_0*sqrt(-a**2 + c**2)/E_star
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
    sigma_0 : array_like
        Greatest stress of the attraction [Pa], sigma_0 > 0.

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
    Valid for h << s. Negative or NaN field values give NaN, as do states whose zone would reach beyond the
    profile. Handbook: gaussian.coh.d.

    References
    ----------
    Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.cohesive import gaussian
    >>> value = gaussian.depth(1.0, h=0.7, s=1.0, E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    0.556312
    """
    require(h=h, s=s, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_depth, a, h=h, s=s, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def force(
    a: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Normal force at contact radius a, negative in tension.

    F = 2*E_star*h*(-a + (2*a**2 + s**2)*Dawson(a/s)/s) - 2*sigma_0*(a*sqrt(-a**2 + c**2) +
    c**2*acos(a/c))
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
    sigma_0 : array_like
        Greatest stress of the attraction [Pa], sigma_0 > 0.

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
    Valid for h << s. Negative or NaN field values give NaN, as do states whose zone would reach beyond the
    profile. Handbook: gaussian.coh.F.

    References
    ----------
    Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.cohesive import gaussian
    >>> value = gaussian.force(1.0, h=0.7, s=1.0, E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    0.35643
    """
    require(h=h, s=s, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_force, a, h=h, s=s, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def pressure(
    r: ArrayLike, a: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Pressure, positive in compression: -sigma_0 in the cohesive zone, zero beyond.

    p = E_star*Integral((2*h*Dawson(sqrt(r**2 + u**2)/s)/s + 2*h*(1 - 2*sqrt(r**2 + u**2)*Dawson(sqrt(r**2 +
    u**2)/s)/s)*sqrt(r**2 + u**2)/s**2)/sqrt(r**2 + u**2), (u, 0, sqrt(a**2 - r**2)))/pi -
    2*sigma_0*atan(sqrt(-a**2 + c**2)/sqrt(a**2 - r**2))/pi
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
    sigma_0 : array_like
        Greatest stress of the attraction [Pa], sigma_0 > 0.

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
    Valid for h << s. Negative or NaN field values give NaN, as do states whose zone would reach beyond the
    profile. Handbook: gaussian.coh.p.

    References
    ----------
    Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.cohesive import gaussian
    >>> value = gaussian.pressure(0.3, 1.0, h=0.7, s=1.0, E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    0.474568
    """
    require(h=h, s=s, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_pressure, r, a, h=h, s=s, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def displacement(
    r: ArrayLike, a: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*(Integral(g(a) - g(r*sin(turn)), (turn, 0, asin(a/r))) - 2*sigma_0*sqrt(-a**2 +
    c**2)*asin(a/r)/E_star - 2*sigma_0*Integral(sqrt(c**2 - r**2*sin(turn)**2), (turn,
    asin(a/r), pi/2))/E_star)/pi   for r < c
    w = 2*(Integral(g(a) - g(r*sin(turn)), (turn, 0, asin(a/r))) - 2*sigma_0*sqrt(-a**2 +
    c**2)*asin(a/r)/E_star - 2*sigma_0*Integral(c**2*cos(turn)**2/sqrt(-c**2*sin(turn)**2
    + r**2), (turn, asin(a/c), pi/2))/E_star)/pi   for c < r

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
    sigma_0 : array_like
        Greatest stress of the attraction [Pa], sigma_0 > 0.

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
    Valid for h << s. Negative or NaN field values give NaN, as do states whose zone would reach beyond the
    profile. Handbook: gaussian.coh.w.

    References
    ----------
    Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.cohesive import gaussian
    >>> value = gaussian.displacement(2.0, 1.0, h=0.7, s=1.0, E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    0.052703
    """
    require(h=h, s=s, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_displacement, r, a, h=h, s=s, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def without_contact(
    c: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Separated:
    """Depth and force of surfaces that attract each other up to the radius c and do not touch.

    d = f(c) - dgamma/sigma_0 - 4*c*sigma_0/(pi*E_star)
    F = -pi*sigma_0*c**2

    Parameters
    ----------
    c : array_like
        Outer radius of the cohesive zone [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.
    sigma_0 : array_like
        Greatest stress of the attraction [Pa], sigma_0 > 0.

    Returns
    -------
    Separated
        Named tuple of depth [m] and force [N]; NaN where they would touch. The shape to which the arguments
        broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for h << s. Coming closer, the attraction begins at the depth -dgamma/sigma_0, where the surfaces
    jump together if f'(c) < 4 sigma_0/(pi E_star) next to the axis; under control of the depth the states
    with a larger f'(c) are stable.

    References
    ----------
    Popov, Heß & Willert 2019.
    """
    require(h=h, s=s, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return Separated(
        elementwise(_without_contact_depth, c, h=h, s=s, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0),
        elementwise(_without_contact_force, c, h=h, s=s, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0),
    )


def pull_off(
    control: str = "force", *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> PullOff:
    """State at which the contact breaks on unloading.

    The least force, or depth, on unloading. At c the gap of the contact without adhesion then changes with c
    by 4 sigma_0/(pi E_star) (phi^2/cos(phi) + 1 - cos(phi)) under control of the force, cos(phi) = a/c, and
    by 4 sigma_0/(pi E_star) (1 - cos(phi)) under control of the depth.

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
    sigma_0 : array_like
        Greatest stress of the attraction [Pa], sigma_0 > 0.

    Returns
    -------
    PullOff
        Named tuple of radius [m], force [N] and depth [m]; the radius is 0 where the depth falls until the
        surfaces have parted, and go on attracting each other. NaN for states whose zone would reach beyond
        the profile.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Where it has several minima, or one at a corner of the profile, the lowest. Valid for h << s.

    References
    ----------
    Popov, Heß & Willert 2019.
    """
    require(h=h, s=s, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    require_control(control)
    radius = elementwise(
        partial(_pull_off_radius, control=control), h=h, s=s, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0
    )
    zone = elementwise(_pull_off_zone, a=radius, h=h, s=s, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    force = elementwise(_force_of, a=radius, q=zone, h=h, s=s, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    depth = elementwise(_pull_off_depth, a=radius, q=zone, h=h, s=s, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return PullOff(radius, force, depth)


def radius_from_depth(
    d: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Contact radius at indentation depth d, on the branch that is stable under a given depth.

    a from d = d(a), where it grows with a.

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
    sigma_0 : array_like
        Greatest stress of the attraction [Pa], sigma_0 > 0.

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
    Valid for h << s. NaN below pull-off and for states whose zone would reach beyond the profile.

    References
    ----------
    Popov, Heß & Willert 2019.
    """
    require(h=h, s=s, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_radius_from_depth, d=d, h=h, s=s, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def radius_from_force(
    F: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Contact radius under the normal force F, on the branch that is stable under a given force.

    a from F = F(a), where it grows with a.

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
    sigma_0 : array_like
        Greatest stress of the attraction [Pa], sigma_0 > 0.

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
    Valid for h << s. NaN below pull-off and for states whose zone would reach beyond the profile.

    References
    ----------
    Popov, Heß & Willert 2019.
    """
    require(h=h, s=s, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_radius_from_force, F=F, h=h, s=s, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def _opened(q: Array, a: Array, h: Array, s: Array) -> tuple[Array, Array]:
    """Gap of the normal contact at c, and its rate with c."""
    return opening(lambda t: normal._slope(t, h, s), q, a, ENTIRE)


def _zone(a: Array, h: Array, s: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    """sqrt(c**2 - a**2) of the zone."""
    largest = difference_root(1.5019752682686114 * s, a)
    a = zone_within(partial(_opened, h=h, s=s), a, E_star, dgamma, sigma_0, largest)
    return np.where(np.isnan(a), np.nan, root_of_zone(partial(_opened, h=h, s=s), a, E_star, dgamma, sigma_0, largest))


def _work_of_separation(a: Array, c: Array, h: Array, s: Array, E_star: Array, sigma_0: Array) -> Array:
    return work_of_zone(partial(_opened, h=h, s=s), difference_root(c, a), a, E_star, sigma_0)


def _cohesive_radius(a: Array, h: Array, s: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return outer_radius(_zone(a, h, s, E_star, dgamma, sigma_0), a)


def _depth_of(a: Array, q: Array, h: Array, s: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return normal._depth(a, h, s) - sunk(q, E_star, sigma_0)


def _depth(a: Array, h: Array, s: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return _depth_of(a, _zone(a, h, s, E_star, dgamma, sigma_0), h, s, E_star, dgamma, sigma_0)


def _force_of(a: Array, q: Array, h: Array, s: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return normal._force(a, h, s, E_star) - pull_of_zone(q, a, sigma_0)


def _force(a: Array, h: Array, s: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return _force_of(a, _zone(a, h, s, E_star, dgamma, sigma_0), h, s, E_star, dgamma, sigma_0)


def _pressure_of(
    r: Array, a: Array, q: Array, h: Array, s: Array, E_star: Array, dgamma: Array, sigma_0: Array
) -> Array:
    return normal._pressure(r, a, h, s, E_star) - tension_of_zone(r, q, a, sigma_0)


def _pressure(r: Array, a: Array, h: Array, s: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return _pressure_of(r, a, _zone(a, h, s, E_star, dgamma, sigma_0), h, s, E_star, dgamma, sigma_0)


def _displacement_of(
    r: Array, a: Array, q: Array, h: Array, s: Array, E_star: Array, dgamma: Array, sigma_0: Array
) -> Array:
    return normal._displacement(r, a, h, s) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r: Array, a: Array, h: Array, s: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return _displacement_of(r, a, _zone(a, h, s, E_star, dgamma, sigma_0), h, s, E_star, dgamma, sigma_0)


def _growth(a: Array, h: Array, s: Array) -> Array:
    """Rate g'(a) of the depth of the normal contact."""
    return np.where(a > 0.0, normal._slope(a, h, s), 0.0)


def _radii(h: Array, s: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Stretch:
    a = np.zeros_like(sigma_0)
    largest = difference_root(1.5019752682686114 * s, a)
    a = zone_within(partial(_opened, h=h, s=s), a, E_star, dgamma, sigma_0, largest)
    first = np.where(np.isnan(a), np.nan, zone_like(partial(_opened, h=h, s=s), a, E_star, dgamma, sigma_0, largest))
    return radii_on_bump(first, 1.5019752682686114 * s)


def _state(
    a: Array, start: Array, h: Array, s: Array, E_star: Array, dgamma: Array, sigma_0: Array, control: str
) -> State:
    growth = _growth(a, h, s)
    return state_near(
        partial(_opened, h=h, s=s),
        growth,
        start,
        a,
        control,
        E_star,
        dgamma,
        sigma_0,
        difference_root(1.5019752682686114 * s, a),
    )


def _pull_off_radius(h: Array, s: Array, E_star: Array, dgamma: Array, sigma_0: Array, control: str) -> Array:
    load = _force_of if control == "force" else _depth_of
    return radius_of_pull_off(
        lambda a, start: _state(a, start, h, s, E_star, dgamma, sigma_0, control),
        lambda a, q: load(a, q, h, s, E_star, dgamma, sigma_0),
        _radii(h, s, E_star, dgamma, sigma_0),
    )


def _parted(h: Array, s: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    first = _zone(np.zeros_like(sigma_0), h, s, E_star, dgamma, sigma_0)
    return parted(partial(_opened, h=h, s=s), first, E_star, sigma_0)


def _pull_off_zone(a: Array, h: Array, s: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    largest = difference_root(1.5019752682686114 * s, a)
    return either(
        a > 0.0,
        lambda: root_of_zone(partial(_opened, h=h, s=s), a, E_star, dgamma, sigma_0, largest),
        lambda: np.where(a == 0.0, _parted(h, s, E_star, dgamma, sigma_0), np.nan),
    )


def _pull_off_depth(a: Array, q: Array, h: Array, s: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return either(
        a > 0.0,
        lambda: _depth_of(a, q, h, s, E_star, dgamma, sigma_0),
        lambda: alone(partial(_opened, h=h, s=s), q, E_star, dgamma, sigma_0),
    )


def _without_contact_depth(c: Array, h: Array, s: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    depth = alone(partial(_opened, h=h, s=s), c, E_star, dgamma, sigma_0)
    return np.where(depth <= -sunk(c, E_star, sigma_0), depth, np.nan)


def _without_contact_force(c: Array, h: Array, s: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    depth = alone(partial(_opened, h=h, s=s), c, E_star, dgamma, sigma_0)
    return np.where(depth <= -sunk(c, E_star, sigma_0), -np.pi * sigma_0 * c * c, np.nan)


def _held_apart(d: Array, h: Array, s: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    apart = _pull_off_radius(h, s, E_star, dgamma, sigma_0, "depth") == 0.0
    deeper = d >= alone(partial(_opened, h=h, s=s), _parted(h, s, E_star, dgamma, sigma_0), E_star, dgamma, sigma_0)
    return np.where(apart & deeper, 0.0, np.nan)


def _radius_from_depth(d: Array, h: Array, s: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    a = radius_under(
        lambda a, start: _state(a, start, h, s, E_star, dgamma, sigma_0, "depth"),
        lambda a, q: _depth_of(a, q, h, s, E_star, dgamma, sigma_0),
        d,
        _radii(h, s, E_star, dgamma, sigma_0),
    )
    return np.where(np.isnan(a), _held_apart(d, h, s, E_star, dgamma, sigma_0), a)


def _radius_from_force(F: Array, h: Array, s: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return radius_under(
        lambda a, start: _state(a, start, h, s, E_star, dgamma, sigma_0, "force"),
        lambda a, q: _force_of(a, q, h, s, E_star, dgamma, sigma_0),
        F,
        _radii(h, s, E_star, dgamma, sigma_0),
    )
