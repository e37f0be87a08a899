"""Cone with a rounded tip with a cohesive zone.

Parabolic tip running tangentially into a cone at r = b.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from .._runtime.integrals import difference_root
from .._runtime.interface import Array, Result, either, elementwise, numbers, require, require_order
from .._runtime.physics.adhesion import PullOff, require_control
from .._runtime.physics.cohesive import (
    CLOSEST,
    Separated,
    alone,
    lift_of_zone,
    opening_beyond,
    opening_tip,
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
    parted_by,
    radii_by,
    radius_of_pull_off,
    radius_under,
    state_near,
)
from ..normal import rounded_cone as normal

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
    a: ArrayLike, c: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Work of separation with which the cohesive zone of a contact of radius a ends at c.

    dgamma = sigma_0*(2*Integral(-g(a) + g(c*sin(turn)), (turn, asin(a/c), pi/2))/pi +
    4*sigma_0*(a - c + sqrt(-a**2 + c**2)*acos(a/c))/(pi*E_star))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Outer radius of the cohesive zone [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN, as do states whose zone would reach
    beyond the profile. Handbook: rounded_cone.coh.work.

    References
    ----------
    Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.cohesive import rounded_cone
    >>> value = rounded_cone.work_of_separation(1.0, 1.143, theta=0.42, b=0.5, E_star=1.0, sigma_0=0.1)
    >>> round(value, 6)
    0.0039
    """
    require(theta=theta, b=b, E_star=E_star, sigma_0=sigma_0)
    require_order(
        np.all(~(numbers("a", a) > numbers("c", c))),
        "a <= c",
        "the zone surrounds the contact; exchange a and c",
        a=a,
        c=c,
    )
    return elementwise(_work_of_separation, a, c, theta=theta, b=b, E_star=E_star, sigma_0=sigma_0)


def cohesive_radius(
    a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Outer radius c of the cohesive zone around a contact of radius a.

    c from sigma_0*(2*Integral(-g(a) + g(c*sin(turn)), (turn, asin(a/c), pi/2))/pi +
    4*sigma_0*(a - c + sqrt(-a**2 + c**2)*acos(a/c))/(pi*E_star)) = dgamma

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN, as do states whose zone would reach
    beyond the profile. Handbook: rounded_cone.coh.c.

    References
    ----------
    Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.cohesive import rounded_cone
    >>> value = rounded_cone.cohesive_radius(1.0, theta=0.42, b=0.5, E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    1.30792
    """
    require(theta=theta, b=b, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_cohesive_radius, a, theta=theta, b=b, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def depth(
    a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Indentation depth at contact radius a; negative where adhesion pulls the surface up.

    d = a**2*tan(theta)/b - 2*sigma_0*sqrt(-a**2 + c**2)/E_star   for a < b
    d = a*(a/b + acos(b/a) - sqrt(a**2 - b**2)/b)*tan(theta) - 2*sigma_0*sqrt(-a**2 + c**2)/E_star
    for b < a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN, as do states whose zone would reach
    beyond the profile. Handbook: rounded_cone.coh.d.

    References
    ----------
    Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.cohesive import rounded_cone
    >>> value = rounded_cone.depth(1.0, theta=0.42, b=0.5, E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    0.418708
    """
    require(theta=theta, b=b, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_depth, a, theta=theta, b=b, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def force(
    a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Normal force at contact radius a, negative in tension.

    F = 4*E_star*a**3*tan(theta)/(3*b) - 2*sigma_0*(a*sqrt(-a**2 + c**2) +
    c**2*acos(a/c))   for a < b
    F = E_star*(4*a**3/(3*b) + a**2*acos(b/a) - (2*a - b)*(2*a + b)*sqrt(a**2 - b**2)/(3*b))*tan(theta) -
    2*sigma_0*(a*sqrt(-a**2 + c**2) + c**2*acos(a/c))   for b < a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN, as do states whose zone would reach
    beyond the profile. Handbook: rounded_cone.coh.F.

    References
    ----------
    Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.cohesive import rounded_cone
    >>> value = rounded_cone.force(1.0, theta=0.42, b=0.5, E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    0.283417
    """
    require(theta=theta, b=b, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_force, a, theta=theta, b=b, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def pressure(
    r: ArrayLike,
    a: ArrayLike,
    *,
    theta: ArrayLike,
    b: ArrayLike,
    E_star: ArrayLike,
    dgamma: ArrayLike,
    sigma_0: ArrayLike,
) -> Result:
    """Pressure, positive in compression: -sigma_0 in the cohesive zone, zero beyond.

    p = 2*E_star*sqrt(a**2 - r**2)*tan(theta)/(pi*b) - 2*sigma_0*atan(sqrt(-a**2 + c**2)/sqrt(a**2 -
    r**2))/pi   for a < b
    p = E_star*(-2*a*sqrt(a**2 - b**2)/(b*sqrt(a**2 - r**2)) + C0(b, r, a) + 2*elliptic_e(asin(sqrt((a**2 -
    b**2)/(a**2 - r**2))), r**2/b**2) + 2*sqrt(a**2 - r**2)/b)*tan(theta)/pi - 2*sigma_0*atan(sqrt(-a**2 +
    c**2)/sqrt(a**2 - r**2))/pi   for r < b and b < a
    p = E_star*(-2*a*sqrt(a**2 - r**2)/(b*sqrt(a**2 - b**2)) + C0(b, r, a) + 2*r*elliptic_e(asin(sqrt((a**2 -
    r**2)/(a**2 - b**2))), b**2/r**2)/b + 2*sqrt(a**2 - r**2)/b - 2*(-b + r)*(b +
    r)*elliptic_f(asin(sqrt((a**2 - r**2)/(a**2 - b**2))), b**2/r**2)/(b*r))*tan(theta)/pi -
    2*sigma_0*atan(sqrt(-a**2 + c**2)/sqrt(a**2 - r**2))/pi   for b < r
    with C0(b, r, a) = int_{max(b, r)}^a acos(b/t) / sqrt(t**2 - r**2) dt, for 0 <= b, r < a
    with elliptic integrals of the parameter m = k**2, their last argument

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN, as do states whose zone would reach
    beyond the profile. Handbook: rounded_cone.coh.p.

    References
    ----------
    Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.cohesive import rounded_cone
    >>> value = rounded_cone.pressure(0.3, 1.0, theta=0.42, b=0.5, E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    0.3626
    """
    require(theta=theta, b=b, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_pressure, r, a, theta=theta, b=b, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def displacement(
    r: ArrayLike,
    a: ArrayLike,
    *,
    theta: ArrayLike,
    b: ArrayLike,
    E_star: ArrayLike,
    dgamma: ArrayLike,
    sigma_0: ArrayLike,
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
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN, as do states whose zone would reach
    beyond the profile. Handbook: rounded_cone.coh.w.

    References
    ----------
    Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.cohesive import rounded_cone
    >>> value = rounded_cone.displacement(2.0, 1.0, theta=0.42, b=0.5, E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    0.042747
    """
    require(theta=theta, b=b, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_displacement, r, a, theta=theta, b=b, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def without_contact(
    c: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Separated:
    """Depth and force of surfaces that attract each other up to the radius c and do not touch.

    d = f(c) - dgamma/sigma_0 - 4*c*sigma_0/(pi*E_star)
    F = -pi*sigma_0*c**2

    Parameters
    ----------
    c : array_like
        Outer radius of the cohesive zone [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. Coming closer, the attraction begins at the depth -dgamma/sigma_0, where the
    surfaces jump together if f'(c) < 4 sigma_0/(pi E_star) next to the axis; under control of the depth the
    states with a larger f'(c) are stable.

    References
    ----------
    Ciavarella 1999; Maugis & Barquins 1983.
    """
    require(theta=theta, b=b, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return Separated(
        elementwise(_without_contact_depth, c, theta=theta, b=b, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0),
        elementwise(_without_contact_force, c, theta=theta, b=b, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0),
    )


def pull_off(
    control: str = "force", *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> PullOff:
    """State at which the contact breaks on unloading.

    The least force, or depth, on unloading. At c the gap of the contact without adhesion then changes with c
    by 4 sigma_0/(pi E_star) (phi^2/cos(phi) + 1 - cos(phi)) under control of the force, cos(phi) = a/c, and
    by 4 sigma_0/(pi E_star) (1 - cos(phi)) under control of the depth.

    Parameters
    ----------
    control : {"force", "depth"}
        What is held while the contact is unloaded.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Where it has several minima, or one at a corner of the profile, the lowest. Valid for tan(theta) << 1.

    References
    ----------
    Ciavarella 1999; Maugis & Barquins 1983.
    """
    require(theta=theta, b=b, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    require_control(control)
    radius = elementwise(
        partial(_pull_off_radius, control=control), theta=theta, b=b, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0
    )
    zone = elementwise(_pull_off_zone, a=radius, theta=theta, b=b, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    force = elementwise(_force_of, a=radius, q=zone, theta=theta, b=b, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    depth = elementwise(
        _pull_off_depth, a=radius, q=zone, theta=theta, b=b, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0
    )
    return PullOff(radius, force, depth)


def radius_from_depth(
    d: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Contact radius at indentation depth d, on the branch that is stable under a given depth.

    a from d = d(a), where it grows with a.

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. NaN below pull-off.

    References
    ----------
    Ciavarella 1999; Maugis & Barquins 1983.
    """
    require(theta=theta, b=b, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_radius_from_depth, d=d, theta=theta, b=b, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def radius_from_force(
    F: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Contact radius under the normal force F, on the branch that is stable under a given force.

    a from F = F(a), where it grows with a.

    Parameters
    ----------
    F : array_like
        Normal force [N].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. NaN below pull-off.

    References
    ----------
    Ciavarella 1999; Maugis & Barquins 1983.
    """
    require(theta=theta, b=b, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_radius_from_force, F=F, theta=theta, b=b, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def _opened(q: Array, a: Array, theta: Array, b: Array) -> tuple[Array, Array]:
    """Gap of the normal contact at c, and its rate with c."""
    tip, tip_rate = opening_tip(lambda t: normal._slope(t, theta, b), q, a, b)
    beyond, rate = opening_beyond(lambda t, root: normal._slope_beyond(t, root, theta, b), q, a, b)
    return tip + beyond, tip_rate + rate


def _zone(a: Array, theta: Array, b: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    """sqrt(c**2 - a**2) of the zone."""
    return root_of_zone(partial(_opened, theta=theta, b=b), a, E_star, dgamma, sigma_0)


def _work_of_separation(a: Array, c: Array, theta: Array, b: Array, E_star: Array, sigma_0: Array) -> Array:
    return work_of_zone(partial(_opened, theta=theta, b=b), difference_root(c, a), a, E_star, sigma_0)


def _cohesive_radius(a: Array, theta: Array, b: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return outer_radius(_zone(a, theta, b, E_star, dgamma, sigma_0), a)


def _depth_of(a: Array, q: Array, theta: Array, b: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return normal._depth(a, theta, b) - sunk(q, E_star, sigma_0)


def _depth(a: Array, theta: Array, b: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return _depth_of(a, _zone(a, theta, b, E_star, dgamma, sigma_0), theta, b, E_star, dgamma, sigma_0)


def _force_of(a: Array, q: Array, theta: Array, b: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return normal._force(a, theta, b, E_star) - pull_of_zone(q, a, sigma_0)


def _force(a: Array, theta: Array, b: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return _force_of(a, _zone(a, theta, b, E_star, dgamma, sigma_0), theta, b, E_star, dgamma, sigma_0)


def _pressure_of(
    r: Array, a: Array, q: Array, theta: Array, b: Array, E_star: Array, dgamma: Array, sigma_0: Array
) -> Array:
    return normal._pressure(r, a, theta, b, E_star) - tension_of_zone(r, q, a, sigma_0)


def _pressure(r: Array, a: Array, theta: Array, b: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return _pressure_of(r, a, _zone(a, theta, b, E_star, dgamma, sigma_0), theta, b, E_star, dgamma, sigma_0)


def _displacement_of(
    r: Array, a: Array, q: Array, theta: Array, b: Array, E_star: Array, dgamma: Array, sigma_0: Array
) -> Array:
    return normal._displacement(r, a, theta, b) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r: Array, a: Array, theta: Array, b: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return _displacement_of(r, a, _zone(a, theta, b, E_star, dgamma, sigma_0), theta, b, E_star, dgamma, sigma_0)


def _growth(a: Array, theta: Array, b: Array) -> Array:
    """Rate g'(a) of the depth of the normal contact."""
    root = np.maximum(difference_root(a, b), CLOSEST * b)
    tip = np.minimum(a, b)
    return np.where(a < b, normal._slope(tip, theta, b), normal._slope_beyond(a, root, theta, b))


def _radii(theta: Array, b: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Stretch:
    a = np.zeros_like(sigma_0)
    first = zone_like(partial(_opened, theta=theta, b=b), a, E_star, dgamma, sigma_0)
    return radii_by(first, b)


def _state(
    a: Array, start: Array, theta: Array, b: Array, E_star: Array, dgamma: Array, sigma_0: Array, control: str
) -> State:
    growth = _growth(a, theta, b)
    return state_near(partial(_opened, theta=theta, b=b), growth, start, a, control, E_star, dgamma, sigma_0)


def _pull_off_radius(theta: Array, b: Array, E_star: Array, dgamma: Array, sigma_0: Array, control: str) -> Array:
    load = _force_of if control == "force" else _depth_of
    return radius_of_pull_off(
        lambda a, start: _state(a, start, theta, b, E_star, dgamma, sigma_0, control),
        lambda a, q: load(a, q, theta, b, E_star, dgamma, sigma_0),
        _radii(theta, b, E_star, dgamma, sigma_0),
    )


def _parted(theta: Array, b: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    first = _zone(np.zeros_like(sigma_0), theta, b, E_star, dgamma, sigma_0)
    return parted_by(partial(_opened, theta=theta, b=b), first, b, E_star, sigma_0)


def _pull_off_zone(a: Array, theta: Array, b: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return either(
        a > 0.0,
        lambda: root_of_zone(partial(_opened, theta=theta, b=b), a, E_star, dgamma, sigma_0),
        lambda: np.where(a == 0.0, _parted(theta, b, E_star, dgamma, sigma_0), np.nan),
    )


def _pull_off_depth(a: Array, q: Array, theta: Array, b: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return either(
        a > 0.0,
        lambda: _depth_of(a, q, theta, b, E_star, dgamma, sigma_0),
        lambda: alone(partial(_opened, theta=theta, b=b), q, E_star, dgamma, sigma_0),
    )


def _without_contact_depth(c: Array, theta: Array, b: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    depth = alone(partial(_opened, theta=theta, b=b), c, E_star, dgamma, sigma_0)
    return np.where(depth <= -sunk(c, E_star, sigma_0), depth, np.nan)


def _without_contact_force(c: Array, theta: Array, b: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    depth = alone(partial(_opened, theta=theta, b=b), c, E_star, dgamma, sigma_0)
    return np.where(depth <= -sunk(c, E_star, sigma_0), -np.pi * sigma_0 * c * c, np.nan)


def _held_apart(d: Array, theta: Array, b: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    apart = _pull_off_radius(theta, b, E_star, dgamma, sigma_0, "depth") == 0.0
    deeper = d >= alone(
        partial(_opened, theta=theta, b=b), _parted(theta, b, E_star, dgamma, sigma_0), E_star, dgamma, sigma_0
    )
    return np.where(apart & deeper, 0.0, np.nan)


def _radius_from_depth(d: Array, theta: Array, b: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    a = radius_under(
        lambda a, start: _state(a, start, theta, b, E_star, dgamma, sigma_0, "depth"),
        lambda a, q: _depth_of(a, q, theta, b, E_star, dgamma, sigma_0),
        d,
        _radii(theta, b, E_star, dgamma, sigma_0),
    )
    return np.where(np.isnan(a), _held_apart(d, theta, b, E_star, dgamma, sigma_0), a)


def _radius_from_force(F: Array, theta: Array, b: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return radius_under(
        lambda a, start: _state(a, start, theta, b, E_star, dgamma, sigma_0, "force"),
        lambda a, q: _force_of(a, q, theta, b, E_star, dgamma, sigma_0),
        F,
        _radii(theta, b, E_star, dgamma, sigma_0),
    )
