"""Sphere with a cohesive zone.

The exact spherical shape; differs from the paraboloid by terms of order a^2/R^2.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from .._runtime.integrals import difference_root
from .._runtime.interface import Array, Result, either, elementwise, numbers, require, require_order
from .._runtime.physics.adhesion import PullOff, require_control
from .._runtime.physics.cohesive import (
    Separated,
    alone,
    lift_of_zone,
    opening_below,
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
    radii_up_to,
    radius_of_pull_off,
    radius_under,
    state_near,
)
from ..normal import sphere as normal

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


def work_of_separation(a: ArrayLike, c: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, sigma_0: ArrayLike) -> Result:
    """Work of separation with which the cohesive zone of a contact of radius a ends at c.

    dgamma = sigma_0*(R - a*atanh(a/R) - sqrt(R**2 - c**2) + 2*(-R*asin(a/c) +
    a*asin(a/c)*atanh(a/R) + sqrt(R**2 - c**2)*atan(a*sqrt(R**2 - c**2)/(R*sqrt(-a**2 +
    c**2))) + sqrt(-a**2 + c**2)*atanh(a/R))/pi + 4*sigma_0*(a - c + sqrt(-a**2 +
    c**2)*acos(a/c))/(pi*E_star))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Outer radius of the cohesive zone [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN, as do
    states whose zone would reach beyond the profile. Handbook: sphere.coh.work.

    References
    ----------
    Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.cohesive import sphere
    >>> value = sphere.work_of_separation(1.0, 1.143, R=1.5, E_star=1.0, sigma_0=0.1)
    >>> round(value, 6)
    0.008743
    """
    require(R=R, E_star=E_star, sigma_0=sigma_0)
    require_order(
        np.all(~(numbers("a", a) > numbers("c", c))),
        "a <= c",
        "the zone surrounds the contact; exchange a and c",
        a=a,
        c=c,
    )
    return elementwise(_work_of_separation, a, c, R=R, E_star=E_star, sigma_0=sigma_0)


def cohesive_radius(a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike) -> Result:
    """Outer radius c of the cohesive zone around a contact of radius a.

    c from sigma_0*(R - a*atanh(a/R) - sqrt(R**2 - c**2) + 2*(-R*asin(a/c) +
    a*asin(a/c)*atanh(a/R) + sqrt(R**2 - c**2)*atan(a*sqrt(R**2 - c**2)/(R*sqrt(-a**2 +
    c**2))) + sqrt(-a**2 + c**2)*atanh(a/R))/pi + 4*sigma_0*(a - c + sqrt(-a**2 +
    c**2)*acos(a/c))/(pi*E_star)) = dgamma

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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN, as do
    states whose zone would reach beyond the profile. Handbook: sphere.coh.c.

    References
    ----------
    Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.cohesive import sphere
    >>> value = sphere.cohesive_radius(1.0, R=1.5, E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    1.156675
    """
    require(R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_cohesive_radius, a, R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def depth(a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike) -> Result:
    """Indentation depth at contact radius a; negative where adhesion pulls the surface up.

    d = a*atanh(a/R) - 2*sigma_0*sqrt(-a**2 + c**2)/E_star

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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN, as do
    states whose zone would reach beyond the profile. Handbook: sphere.coh.d.

    References
    ----------
    Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.cohesive import sphere
    >>> value = sphere.depth(1.0, R=1.5, E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    0.688461
    """
    require(R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_depth, a, R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def force(a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike) -> Result:
    """Normal force at contact radius a, negative in tension.

    F = E_star*(-R*a + (R**2 + a**2)*atanh(a/R)) - 2*sigma_0*(a*sqrt(-a**2 + c**2) +
    c**2*acos(a/c))

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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN, as do
    states whose zone would reach beyond the profile. Handbook: sphere.coh.F.

    References
    ----------
    Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.cohesive import sphere
    >>> value = sphere.force(1.0, R=1.5, E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    0.858186
    """
    require(R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_force, a, R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def pressure(
    r: ArrayLike, a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Pressure, positive in compression: -sigma_0 in the cohesive zone, zero beyond.

    p = E_star*(R*atanh(sqrt(a**2 - r**2)/sqrt(R**2 - r**2))/sqrt(R**2 - r**2) - LegendreChi2((a - sqrt(a**2 -
    r**2))/(R + sqrt(R**2 - r**2))) + LegendreChi2((a + sqrt(a**2 - r**2))/(R + sqrt(R**2 - r**2))))/pi -
    2*sigma_0*atan(sqrt(-a**2 + c**2)/sqrt(a**2 - r**2))/pi
    with LegendreChi2: chi_2(x) = int_0^x atanh(t)/t dt = (Li_2(x) - Li_2(-x))/2, for 0 <= x < 1

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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN, as do
    states whose zone would reach beyond the profile. Handbook: sphere.coh.p.

    References
    ----------
    Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.cohesive import sphere
    >>> value = sphere.pressure(0.3, 1.0, R=1.5, E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    0.433131
    """
    require(R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_pressure, r, a, R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def displacement(
    r: ArrayLike, a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
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
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN, as do
    states whose zone would reach beyond the profile. Handbook: sphere.coh.w.

    References
    ----------
    Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.cohesive import sphere
    >>> value = sphere.displacement(2.0, 1.0, R=1.5, E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    0.13921
    """
    require(R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_displacement, r, a, R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def without_contact(
    c: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Separated:
    """Depth and force of surfaces that attract each other up to the radius c and do not touch.

    d = f(c) - dgamma/sigma_0 - 4*c*sigma_0/(pi*E_star)
    F = -pi*sigma_0*c**2

    Parameters
    ----------
    c : array_like
        Outer radius of the cohesive zone [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a < R; the theory of small slopes asks for a << R. Coming closer, the attraction begins at the
    depth -dgamma/sigma_0, where the surfaces jump together if f'(c) < 4 sigma_0/(pi E_star) next to the axis;
    under control of the depth the states with a larger f'(c) are stable.

    References
    ----------
    Segedin 1957; Sneddon 1965.
    """
    require(R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return Separated(
        elementwise(_without_contact_depth, c, R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0),
        elementwise(_without_contact_force, c, R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0),
    )


def pull_off(
    control: str = "force", *, R: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> PullOff:
    """State at which the contact breaks on unloading.

    The least force, or depth, on unloading. At c the gap of the contact without adhesion then changes with c
    by 4 sigma_0/(pi E_star) (phi^2/cos(phi) + 1 - cos(phi)) under control of the force, cos(phi) = a/c, and
    by 4 sigma_0/(pi E_star) (1 - cos(phi)) under control of the depth.

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
    Where it has several minima, or one at a corner of the profile, the lowest. Valid for a < R; the theory of
    small slopes asks for a << R.

    References
    ----------
    Segedin 1957; Sneddon 1965.
    """
    require(R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    require_control(control)
    radius = elementwise(partial(_pull_off_radius, control=control), R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    zone = elementwise(_pull_off_zone, a=radius, R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    force = elementwise(_force_of, a=radius, q=zone, R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    depth = elementwise(_pull_off_depth, a=radius, q=zone, R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return PullOff(radius, force, depth)


def radius_from_depth(
    d: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Contact radius at indentation depth d, on the branch that is stable under a given depth.

    a from d = d(a), where it grows with a.

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
    Valid for a < R; the theory of small slopes asks for a << R. NaN below pull-off and for states whose zone
    would reach beyond the profile.

    References
    ----------
    Segedin 1957; Sneddon 1965.
    """
    require(R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_radius_from_depth, d=d, R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def radius_from_force(
    F: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Contact radius under the normal force F, on the branch that is stable under a given force.

    a from F = F(a), where it grows with a.

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
    Valid for a < R; the theory of small slopes asks for a << R. NaN below pull-off and for states whose zone
    would reach beyond the profile.

    References
    ----------
    Segedin 1957; Sneddon 1965.
    """
    require(R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_radius_from_force, F=F, R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def _opened(q: Array, a: Array, R: Array) -> tuple[Array, Array]:
    """Gap of the normal contact at c, and its rate with c."""
    return opening_below(lambda t, root: normal._slope(t, root, R), q, a, R)


def _zone(a: Array, R: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    """sqrt(c**2 - a**2) of the zone."""
    largest = difference_root(R, a)
    a = zone_within(partial(_opened, R=R), a, E_star, dgamma, sigma_0, largest)
    return np.where(np.isnan(a), np.nan, root_of_zone(partial(_opened, R=R), a, E_star, dgamma, sigma_0, largest))


def _work_of_separation(a: Array, c: Array, R: Array, E_star: Array, sigma_0: Array) -> Array:
    return work_of_zone(partial(_opened, R=R), difference_root(c, a), a, E_star, sigma_0)


def _cohesive_radius(a: Array, R: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return outer_radius(_zone(a, R, E_star, dgamma, sigma_0), a)


def _depth_of(a: Array, q: Array, R: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return normal._depth(a, R) - sunk(q, E_star, sigma_0)


def _depth(a: Array, R: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return _depth_of(a, _zone(a, R, E_star, dgamma, sigma_0), R, E_star, dgamma, sigma_0)


def _force_of(a: Array, q: Array, R: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return normal._force(a, R, E_star) - pull_of_zone(q, a, sigma_0)


def _force(a: Array, R: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return _force_of(a, _zone(a, R, E_star, dgamma, sigma_0), R, E_star, dgamma, sigma_0)


def _pressure_of(r: Array, a: Array, q: Array, R: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return normal._pressure(r, a, R, E_star) - tension_of_zone(r, q, a, sigma_0)


def _pressure(r: Array, a: Array, R: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return _pressure_of(r, a, _zone(a, R, E_star, dgamma, sigma_0), R, E_star, dgamma, sigma_0)


def _displacement_of(r: Array, a: Array, q: Array, R: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return normal._displacement(r, a, R) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r: Array, a: Array, R: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return _displacement_of(r, a, _zone(a, R, E_star, dgamma, sigma_0), R, E_star, dgamma, sigma_0)


def _growth(a: Array, R: Array) -> Array:
    """Rate g'(a) of the depth of the normal contact."""
    return np.where(a > 0.0, normal._slope(a, difference_root(R, a), R), 0.0)


def _radii(R: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Stretch:
    a = np.zeros_like(sigma_0)
    largest = difference_root(R, a)
    a = zone_within(partial(_opened, R=R), a, E_star, dgamma, sigma_0, largest)
    first = np.where(np.isnan(a), np.nan, zone_like(partial(_opened, R=R), a, E_star, dgamma, sigma_0, largest))
    return radii_up_to(first, R)


def _state(a: Array, start: Array, R: Array, E_star: Array, dgamma: Array, sigma_0: Array, control: str) -> State:
    growth = _growth(a, R)
    return state_near(partial(_opened, R=R), growth, start, a, control, E_star, dgamma, sigma_0, difference_root(R, a))


def _pull_off_radius(R: Array, E_star: Array, dgamma: Array, sigma_0: Array, control: str) -> Array:
    load = _force_of if control == "force" else _depth_of
    return radius_of_pull_off(
        lambda a, start: _state(a, start, R, E_star, dgamma, sigma_0, control),
        lambda a, q: load(a, q, R, E_star, dgamma, sigma_0),
        _radii(R, E_star, dgamma, sigma_0),
    )


def _parted(R: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    first = _zone(np.zeros_like(sigma_0), R, E_star, dgamma, sigma_0)
    return parted(partial(_opened, R=R), first, E_star, sigma_0)


def _pull_off_zone(a: Array, R: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    largest = difference_root(R, a)
    return either(
        a > 0.0,
        lambda: root_of_zone(partial(_opened, R=R), a, E_star, dgamma, sigma_0, largest),
        lambda: np.where(a == 0.0, _parted(R, E_star, dgamma, sigma_0), np.nan),
    )


def _pull_off_depth(a: Array, q: Array, R: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return either(
        a > 0.0,
        lambda: _depth_of(a, q, R, E_star, dgamma, sigma_0),
        lambda: alone(partial(_opened, R=R), q, E_star, dgamma, sigma_0),
    )


def _without_contact_depth(c: Array, R: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    depth = alone(partial(_opened, R=R), c, E_star, dgamma, sigma_0)
    return np.where(depth <= -sunk(c, E_star, sigma_0), depth, np.nan)


def _without_contact_force(c: Array, R: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    depth = alone(partial(_opened, R=R), c, E_star, dgamma, sigma_0)
    return np.where(depth <= -sunk(c, E_star, sigma_0), -np.pi * sigma_0 * c * c, np.nan)


def _held_apart(d: Array, R: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    apart = _pull_off_radius(R, E_star, dgamma, sigma_0, "depth") == 0.0
    deeper = d >= alone(partial(_opened, R=R), _parted(R, E_star, dgamma, sigma_0), E_star, dgamma, sigma_0)
    return np.where(apart & deeper, 0.0, np.nan)


def _radius_from_depth(d: Array, R: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    a = radius_under(
        lambda a, start: _state(a, start, R, E_star, dgamma, sigma_0, "depth"),
        lambda a, q: _depth_of(a, q, R, E_star, dgamma, sigma_0),
        d,
        _radii(R, E_star, dgamma, sigma_0),
    )
    return np.where(np.isnan(a), _held_apart(d, R, E_star, dgamma, sigma_0), a)


def _radius_from_force(F: Array, R: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return radius_under(
        lambda a, start: _state(a, start, R, E_star, dgamma, sigma_0, "force"),
        lambda a, q: _force_of(a, q, R, E_star, dgamma, sigma_0),
        F,
        _radii(R, E_star, dgamma, sigma_0),
    )
