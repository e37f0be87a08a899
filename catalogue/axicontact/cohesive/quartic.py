"""Quartic profile with a cohesive zone.

Vanishing curvature at the tip: the pressure has a dip at the centre and its largest value on a ring.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from .._runtime.integrals import difference_root
from .._runtime.interface import Array, Result, either, elementwise, numbers, require, require_order
from .._runtime.physics.adhesion import PullOff, require_control
from .._runtime.physics.cohesive import (
    POLYNOMIAL,
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
)
from .._runtime.physics.cohesive_states import (
    State,
    Stretch,
    parted,
    radii,
    radius_of_pull_off,
    radius_under,
    state_near,
)
from ..normal import quartic as normal

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


def work_of_separation(a: ArrayLike, c: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, sigma_0: ArrayLike) -> Result:
    """Work of separation with which the cohesive zone of a contact of radius a ends at c.

    dgamma = sigma_0*(-8*A*a**4/3 + A*c**4 + 2*A*(a*sqrt(-a**2 + c**2)*(2*a**2 + 3*c**2)
    - (-8*a**4 + 3*c**4)*asin(a/c))/(3*pi) + 4*sigma_0*(a - c + sqrt(-a**2 +
    c**2)*acos(a/c))/(pi*E_star))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Outer radius of the cohesive zone [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN, as do states whose zone would
    reach beyond the profile. Handbook: quartic.coh.work.

    References
    ----------
    Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.cohesive import quartic
    >>> value = quartic.work_of_separation(1.0, 1.143, A=0.4, E_star=1.0, sigma_0=0.1)
    >>> round(value, 6)
    0.0172
    """
    require(A=A, E_star=E_star, sigma_0=sigma_0)
    require_order(
        np.all(~(numbers("a", a) > numbers("c", c))),
        "a <= c",
        "the zone surrounds the contact; exchange a and c",
        a=a,
        c=c,
    )
    return elementwise(_work_of_separation, a, c, A=A, E_star=E_star, sigma_0=sigma_0)


def cohesive_radius(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike) -> Result:
    """Outer radius c of the cohesive zone around a contact of radius a.

    c from sigma_0*(-8*A*a**4/3 + A*c**4 + 2*A*(a*sqrt(-a**2 + c**2)*(2*a**2 +
    3*c**2) - (-8*a**4 + 3*c**4)*asin(a/c))/(3*pi) + 4*sigma_0*(a - c + sqrt(-a**2
    + c**2)*acos(a/c))/(pi*E_star)) = dgamma

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN, as do states whose zone would
    reach beyond the profile. Handbook: quartic.coh.c.

    References
    ----------
    Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.cohesive import quartic
    >>> value = quartic.cohesive_radius(1.0, A=0.4, E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    1.100168
    """
    require(A=A, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_cohesive_radius, a, A=A, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def depth(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike) -> Result:
    """Indentation depth at contact radius a; negative where adhesion pulls the surface up.

    d = 8*A*a**4/3 - 2*sigma_0*sqrt(-a**2 + c**2)/E_star

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN, as do states whose zone would
    reach beyond the profile. Handbook: quartic.coh.d.

    References
    ----------
    Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.cohesive import quartic
    >>> value = quartic.depth(1.0, A=0.4, E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    0.974935
    """
    require(A=A, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_depth, a, A=A, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def force(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike) -> Result:
    """Normal force at contact radius a, negative in tension.

    F = 64*A*E_star*a**5/15 - 2*sigma_0*(a*sqrt(-a**2 + c**2) + c**2*acos(a/c))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN, as do states whose zone would
    reach beyond the profile. Handbook: quartic.coh.F.

    References
    ----------
    Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.cohesive import quartic
    >>> value = quartic.force(1.0, A=0.4, E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    1.510835
    """
    require(A=A, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_force, a, A=A, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def pressure(
    r: ArrayLike, a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Pressure, positive in compression: -sigma_0 in the cohesive zone, zero beyond.

    p = 32*A*E_star*sqrt(a**2 - r**2)*(a**2 + 2*r**2)/(9*pi) - 2*sigma_0*atan(sqrt(-a**2 +
    c**2)/sqrt(a**2 - r**2))/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN, as do states whose zone would
    reach beyond the profile. Handbook: quartic.coh.p.

    References
    ----------
    Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.cohesive import quartic
    >>> value = quartic.pressure(0.3, 1.0, A=0.4, E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    0.481058
    """
    require(A=A, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_pressure, r, a, A=A, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def displacement(
    r: ArrayLike, a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*A*(a*sqrt(-a**2 + r**2)*(2*a**2 + 3*r**2) - (-8*a**4 + 3*r**4)*asin(a/r))/(3*pi) -
    4*r*sigma_0*(-(-c**2/r**2 + 1)*(-elliptic_f(asin(a/c), c**2/r**2) +
    elliptic_k(c**2/r**2)) + elliptic_e(c**2/r**2) - elliptic_e(asin(a/c),
    c**2/r**2))/(pi*E_star) - 4*sigma_0*sqrt(-a**2 + c**2)*asin(a/r)/(pi*E_star)   for c
    < r
    w = 2*A*(a*sqrt(-a**2 + r**2)*(2*a**2 + 3*r**2) - (-8*a**4 + 3*r**4)*asin(a/r))/(3*pi) -
    4*c*sigma_0*(elliptic_e(r**2/c**2) - elliptic_e(asin(a/r), r**2/c**2))/(pi*E_star) -
    4*sigma_0*sqrt(-a**2 + c**2)*asin(a/r)/(pi*E_star)   for r < c
    with elliptic integrals of the parameter m = k**2, their last argument

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN, as do states whose zone would
    reach beyond the profile. Handbook: quartic.coh.w.

    References
    ----------
    Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.cohesive import quartic
    >>> value = quartic.displacement(2.0, 1.0, A=0.4, E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    0.247634
    """
    require(A=A, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_displacement, r, a, A=A, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def without_contact(
    c: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Separated:
    """Depth and force of surfaces that attract each other up to the radius c and do not touch.

    d = f(c) - dgamma/sigma_0 - 4*c*sigma_0/(pi*E_star)
    F = -pi*sigma_0*c**2

    Parameters
    ----------
    c : array_like
        Outer radius of the cohesive zone [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. Coming closer, the attraction begins at the depth -dgamma/sigma_0,
    where the surfaces jump together if f'(c) < 4 sigma_0/(pi E_star) next to the axis; under control of the
    depth the states with a larger f'(c) are stable.

    References
    ----------
    Steuermann 1939; Schubert 1942.
    """
    require(A=A, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return Separated(
        elementwise(_without_contact_depth, c, A=A, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0),
        elementwise(_without_contact_force, c, A=A, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0),
    )


def pull_off(
    control: str = "force", *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> PullOff:
    """State at which the contact breaks on unloading.

    The least force, or depth, on unloading. At c the gap of the contact without adhesion then changes with c
    by 4 sigma_0/(pi E_star) (phi^2/cos(phi) + 1 - cos(phi)) under control of the force, cos(phi) = a/c, and
    by 4 sigma_0/(pi E_star) (1 - cos(phi)) under control of the depth.

    Parameters
    ----------
    control : {"force", "depth"}
        What is held while the contact is unloaded.
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
        surfaces have parted, and go on attracting each other.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Where it has several minima, or one at a corner of the profile, the lowest. Valid for small slopes, 4 A
    a^3 << 1.

    References
    ----------
    Steuermann 1939; Schubert 1942.
    """
    require(A=A, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    require_control(control)
    radius = elementwise(partial(_pull_off_radius, control=control), A=A, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    zone = elementwise(_pull_off_zone, a=radius, A=A, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    force = elementwise(_force_of, a=radius, q=zone, A=A, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    depth = elementwise(_pull_off_depth, a=radius, q=zone, A=A, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return PullOff(radius, force, depth)


def radius_from_depth(
    d: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Contact radius at indentation depth d, on the branch that is stable under a given depth.

    a from d = d(a), where it grows with a.

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. NaN below pull-off.

    References
    ----------
    Steuermann 1939; Schubert 1942.
    """
    require(A=A, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_radius_from_depth, d=d, A=A, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def radius_from_force(
    F: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Contact radius under the normal force F, on the branch that is stable under a given force.

    a from F = F(a), where it grows with a.

    Parameters
    ----------
    F : array_like
        Normal force [N].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. NaN below pull-off.

    References
    ----------
    Steuermann 1939; Schubert 1942.
    """
    require(A=A, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_radius_from_force, F=F, A=A, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def _opened(q: Array, a: Array, A: Array) -> tuple[Array, Array]:
    """Gap of the normal contact at c, and its rate with c."""
    return opening(lambda t: normal._slope(t, A), q, a, POLYNOMIAL)


def _zone(a: Array, A: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    """sqrt(c**2 - a**2) of the zone."""
    return root_of_zone(partial(_opened, A=A), a, E_star, dgamma, sigma_0)


def _work_of_separation(a: Array, c: Array, A: Array, E_star: Array, sigma_0: Array) -> Array:
    return work_of_zone(partial(_opened, A=A), difference_root(c, a), a, E_star, sigma_0)


def _cohesive_radius(a: Array, A: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return outer_radius(_zone(a, A, E_star, dgamma, sigma_0), a)


def _depth_of(a: Array, q: Array, A: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return normal._depth(a, A) - sunk(q, E_star, sigma_0)


def _depth(a: Array, A: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return _depth_of(a, _zone(a, A, E_star, dgamma, sigma_0), A, E_star, dgamma, sigma_0)


def _force_of(a: Array, q: Array, A: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return normal._force(a, A, E_star) - pull_of_zone(q, a, sigma_0)


def _force(a: Array, A: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return _force_of(a, _zone(a, A, E_star, dgamma, sigma_0), A, E_star, dgamma, sigma_0)


def _pressure_of(r: Array, a: Array, q: Array, A: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return normal._pressure(r, a, A, E_star) - tension_of_zone(r, q, a, sigma_0)


def _pressure(r: Array, a: Array, A: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return _pressure_of(r, a, _zone(a, A, E_star, dgamma, sigma_0), A, E_star, dgamma, sigma_0)


def _displacement_of(r: Array, a: Array, q: Array, A: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return normal._displacement(r, a, A) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r: Array, a: Array, A: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return _displacement_of(r, a, _zone(a, A, E_star, dgamma, sigma_0), A, E_star, dgamma, sigma_0)


def _growth(a: Array, A: Array) -> Array:
    """Rate g'(a) of the depth of the normal contact."""
    return np.where(a > 0.0, normal._slope(a, A), 0.0)


def _radii(A: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Stretch:
    a = np.zeros_like(sigma_0)
    first = zone_like(partial(_opened, A=A), a, E_star, dgamma, sigma_0)
    return radii(first)


def _state(a: Array, start: Array, A: Array, E_star: Array, dgamma: Array, sigma_0: Array, control: str) -> State:
    growth = _growth(a, A)
    return state_near(partial(_opened, A=A), growth, start, a, control, E_star, dgamma, sigma_0)


def _pull_off_radius(A: Array, E_star: Array, dgamma: Array, sigma_0: Array, control: str) -> Array:
    load = _force_of if control == "force" else _depth_of
    return radius_of_pull_off(
        lambda a, start: _state(a, start, A, E_star, dgamma, sigma_0, control),
        lambda a, q: load(a, q, A, E_star, dgamma, sigma_0),
        _radii(A, E_star, dgamma, sigma_0),
    )


def _parted(A: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    first = _zone(np.zeros_like(sigma_0), A, E_star, dgamma, sigma_0)
    return parted(partial(_opened, A=A), first, E_star, sigma_0)


def _pull_off_zone(a: Array, A: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return either(
        a > 0.0,
        lambda: root_of_zone(partial(_opened, A=A), a, E_star, dgamma, sigma_0),
        lambda: np.where(a == 0.0, _parted(A, E_star, dgamma, sigma_0), np.nan),
    )


def _pull_off_depth(a: Array, q: Array, A: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return either(
        a > 0.0,
        lambda: _depth_of(a, q, A, E_star, dgamma, sigma_0),
        lambda: alone(partial(_opened, A=A), q, E_star, dgamma, sigma_0),
    )


def _without_contact_depth(c: Array, A: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    depth = alone(partial(_opened, A=A), c, E_star, dgamma, sigma_0)
    return np.where(depth <= -sunk(c, E_star, sigma_0), depth, np.nan)


def _without_contact_force(c: Array, A: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    depth = alone(partial(_opened, A=A), c, E_star, dgamma, sigma_0)
    return np.where(depth <= -sunk(c, E_star, sigma_0), -np.pi * sigma_0 * c * c, np.nan)


def _held_apart(d: Array, A: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    apart = _pull_off_radius(A, E_star, dgamma, sigma_0, "depth") == 0.0
    deeper = d >= alone(partial(_opened, A=A), _parted(A, E_star, dgamma, sigma_0), E_star, dgamma, sigma_0)
    return np.where(apart & deeper, 0.0, np.nan)


def _radius_from_depth(d: Array, A: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    a = radius_under(
        lambda a, start: _state(a, start, A, E_star, dgamma, sigma_0, "depth"),
        lambda a, q: _depth_of(a, q, A, E_star, dgamma, sigma_0),
        d,
        _radii(A, E_star, dgamma, sigma_0),
    )
    return np.where(np.isnan(a), _held_apart(d, A, E_star, dgamma, sigma_0), a)


def _radius_from_force(F: Array, A: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return radius_under(
        lambda a, start: _state(a, start, A, E_star, dgamma, sigma_0, "force"),
        lambda a, q: _force_of(a, q, A, E_star, dgamma, sigma_0),
        F,
        _radii(A, E_star, dgamma, sigma_0),
    )
