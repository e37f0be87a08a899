"""Curved punch with a rounded edge.

A paraboloid of radius R1 whose edge is rounded off from r = b on with the radius R2.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.functions import beside
from .._runtime.interface import Array, Plain, Result, elementwise, require
from .._runtime.kernels import OUTSIDE_2
from .._runtime.rules import displacement_integral_beyond, pressure_integral_beyond
from .._runtime.shapes.across import inverse_beyond
from .._runtime.shapes.energy import energy_integral, energy_integral_beyond
from .._runtime.shapes.load_within import load_within_integral, load_within_integral_beyond
from .._runtime.special import arctan_gap, root_gap

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "depth",
    "depth_from_force",
    "displacement",
    "energy",
    "force",
    "force_from_depth",
    "load_within",
    "mean_pressure",
    "pressure",
    "profile",
    "radius_from_depth",
    "radius_from_force",
    "stiffness",
]


def __dir__() -> list[str]:
    return __all__


plain = Plain(__name__, __all__)


def profile(r: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = r**2/(2*R1)   for 0 < r < b
    f = (-b + r)**2/(2*R2) + r**2/(2*R1)   for b < r

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius of the inner part [m], b > 0.

    Returns
    -------
    float or ndarray
        Profile of the indenter, measured from its apex [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN. Handbook: rounded_curved_punch.f,
    the definition of the profile.

    Examples
    --------
    >>> from axicontact.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.profile(0.45, R1=6.0, R2=1.2, b=1.0)
    >>> round(value, 6)
    0.016875
    """
    value = plain.profile(r, R1, R2, b)
    if value is not None:
        return value
    require(R1=R1, R2=R2, b=b)
    return elementwise(_profile, r, R1=R1, R2=R2, b=b)


def depth(a: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = a**2/R1   for a < b
    d = a*(-b*acos(b/a)/R2 + sqrt(a**2 - b**2)/R2 + a/R1)   for b < a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius of the inner part [m], b > 0.

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
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN. Handbook: rounded_curved_punch.d.

    References
    ----------
    chapter 11, equation (11.29).

    Examples
    --------
    >>> from axicontact.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.depth(1.5, R1=6.0, R2=1.2, b=1.0)
    >>> round(value, 6)
    0.721207
    """
    value = plain.depth(a, R1, R2, b)
    if value is not None:
        return value
    require(R1=R1, R2=R2, b=b)
    return elementwise(_depth, a, R1=R1, R2=R2, b=b)


def force(a: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force.

    F = 4*E_star*a**3/(3*R1)   for a < b
    F = E_star*(-a**2*b*acos(b/a)/R2 + (2*a - b)*(2*a + b)*sqrt(a**2 - b**2)/(3*R2) + 4*a**3/(3*R1))   for b <
    a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius of the inner part [m], b > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

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
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN. Handbook: rounded_curved_punch.F.

    References
    ----------
    chapter 11, equation (11.20).

    Examples
    --------
    >>> from axicontact.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.force(1.5, R1=6.0, R2=1.2, b=1.0, E_star=1.0)
    >>> round(value, 6)
    1.657516
    """
    value = plain.force(a, R1, R2, b, E_star)
    if value is not None:
        return value
    require(R1=R1, R2=R2, b=b, E_star=E_star)
    return elementwise(_force, a, R1=R1, R2=R2, b=b, E_star=E_star)


def pressure(r: ArrayLike, a: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = 2*E_star*sqrt(a**2 - r**2)/(pi*R1)   for a < b
    p = E_star*(2*a*sqrt(a**2 - b**2)/(R2*sqrt(a**2 - r**2)) - b*C0(b, r, a)/R2 -
    2*b*elliptic_e(asin(sqrt((a**2 - b**2)/(a**2 - r**2))), r**2/b**2)/R2 + 2*sqrt(a**2 - r**2)/R1)/pi   for r
    < b and b < a
    p = E_star*(2*a*sqrt(a**2 - r**2)/(R2*sqrt(a**2 - b**2)) - b*C0(b, r, a)/R2 -
    2*r*elliptic_e(asin(sqrt((a**2 - r**2)/(a**2 - b**2))), b**2/r**2)/R2 + 2*(-b + r)*(b +
    r)*elliptic_f(asin(sqrt((a**2 - r**2)/(a**2 - b**2))), b**2/r**2)/(R2*r) + 2*sqrt(a**2 - r**2)/R1)/pi
    for b < r
    with C0(b, r, a) = int_{max(b, r)}^a acos(b/t) / sqrt(t**2 - r**2) dt, for 0 <= b, r < a
    with elliptic integrals of the parameter m = k**2, their last argument

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius of the inner part [m], b > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

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
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact by a Gauss-Legendre rule. Handbook: rounded_curved_punch.p.

    References
    ----------
    chapter 11, equation (11.23).

    Examples
    --------
    >>> from axicontact.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.pressure(0.45, 1.5, R1=6.0, R2=1.2, b=1.0, E_star=1.0)
    >>> round(value, 6)
    0.242628
    """
    value = plain.pressure(r, a, R1, R2, b, E_star)
    if value is not None:
        return value
    require(R1=R1, R2=R2, b=b, E_star=E_star)
    return elementwise(_pressure, r, a, R1=R1, R2=R2, b=b, E_star=E_star)


def displacement(r: ArrayLike, a: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = (a*sqrt(-a**2 + r**2) - (-2*a**2 + r**2)*asin(a/r))/(pi*R1)   for a < b
    w = (-2*a*b*acos(b/a)*asin(a/r)/R2 + 2*a*sqrt(a**2 - b**2)*asin(a/r)/R2 + 2*b*r*acos(b*sqrt(-a**2 +
    r**2)/(a*sqrt(-b**2 + r**2)))/R2 - 2*b*sqrt(-a**2 + r**2)*acos(b/a)/R2 + sqrt(-a**2 + r**2)*sqrt(a**2 -
    b**2)/R2 - (b**2 + r**2)*asin(sqrt((a**2 - b**2)/(-b**2 + r**2)))/R2 + a*sqrt(-a**2 + r**2)/R1 - (-2*a**2
    + r**2)*asin(a/r)/R1)/pi   for b < a

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius of the inner part [m], b > 0.

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
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact by a Gauss-Legendre rule. Handbook: rounded_curved_punch.w.

    References
    ----------
    chapter 11, equation (11.26).

    Examples
    --------
    >>> from axicontact.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.displacement(3.0, 1.5, R1=6.0, R2=1.2, b=1.0)
    >>> round(value, 6)
    0.181518
    """
    value = plain.displacement(r, a, R1, R2, b)
    if value is not None:
        return value
    require(R1=R1, R2=R2, b=b)
    return elementwise(_displacement, r, a, R1=R1, R2=R2, b=b)


def stiffness(a: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*E_star*a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius of the inner part [m], b > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Contact stiffness dF/dd [N/m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN. Handbook: rounded_curved_punch.k.

    References
    ----------
    chapter 11, equation (11.18).

    Examples
    --------
    >>> from axicontact.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.stiffness(1.5, R1=6.0, R2=1.2, b=1.0, E_star=1.0)
    >>> round(value, 6)
    3.0
    """
    value = plain.stiffness(a, E_star, R1, R2, b)
    if value is not None:
        return value
    require(R1=R1, R2=R2, b=b, E_star=E_star)
    return elementwise(_stiffness, a, E_star=E_star, unused=(R1, R2, b))


def mean_pressure(a: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = 4*E_star*a/(3*pi*R1)   for a < b
    p_mean = E_star*(-b*acos(b/a)/R2 + (2*a - b)*(2*a + b)*sqrt(a**2 - b**2)/(3*R2*a**2) + 4*a/(3*R1))/pi
    for b < a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius of the inner part [m], b > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Mean pressure F/(pi a^2) [Pa]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN. Handbook: rounded_curved_punch.pm.

    Examples
    --------
    >>> from axicontact.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.mean_pressure(1.5, R1=6.0, R2=1.2, b=1.0, E_star=1.0)
    >>> round(value, 6)
    0.234491
    """
    value = plain.mean_pressure(a, R1, R2, b, E_star)
    if value is not None:
        return value
    require(R1=R1, R2=R2, b=b, E_star=E_star)
    return elementwise(_mean_pressure, a, R1=R1, R2=R2, b=b, E_star=E_star)


def radius_from_depth(d: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a from a**2/R1 = d   for a < b
    a from a*(-b*acos(b/a)/R2 + sqrt(a**2 - b**2)/R2 + a/R1) = d   for b < a

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius of the inner part [m], b > 0.

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
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: rounded_curved_punch.ad.

    References
    ----------
    chapter 11, equation (11.16).

    Examples
    --------
    >>> from axicontact.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.radius_from_depth(0.7212, R1=6.0, R2=1.2, b=1.0)
    >>> round(value, 6)
    1.499996
    """
    value = plain.radius_from_depth(d, R1, R2, b)
    if value is not None:
        return value
    require(R1=R1, R2=R2, b=b)
    return elementwise(_radius_from_depth, d, R1=R1, R2=R2, b=b)


def radius_from_force(F: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a from 4*E_star*a**3/(3*R1) = F   for a < b
    a from E_star*(-a**2*b*acos(b/a)/R2 + (2*a - b)*(2*a + b)*sqrt(a**2 - b**2)/(3*R2) + 4*a**3/(3*R1)) = F
    for b < a

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius of the inner part [m], b > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

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
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: rounded_curved_punch.aF.

    References
    ----------
    chapter 11, equation (11.20).

    Examples
    --------
    >>> from axicontact.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.radius_from_force(1.658, R1=6.0, R2=1.2, b=1.0, E_star=1.0)
    >>> round(value, 6)
    1.500097
    """
    value = plain.radius_from_force(F, R1, R2, b, E_star)
    if value is not None:
        return value
    require(R1=R1, R2=R2, b=b, E_star=E_star)
    return elementwise(_radius_from_force, F, R1=R1, R2=R2, b=b, E_star=E_star)


def force_from_depth(d: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = F(a(d)), through the contact radius.

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius of the inner part [m], b > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

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
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: rounded_curved_punch.Fd.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20).

    Examples
    --------
    >>> from axicontact.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.force_from_depth(0.7212, R1=6.0, R2=1.2, b=1.0, E_star=1.0)
    >>> round(value, 6)
    1.657496
    """
    value = plain.force_from_depth(d, R1, R2, b, E_star)
    if value is not None:
        return value
    require(R1=R1, R2=R2, b=b, E_star=E_star)
    return elementwise(_force_from_depth, d, R1=R1, R2=R2, b=b, E_star=E_star)


def depth_from_force(F: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = d(a(F)), through the contact radius.

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius of the inner part [m], b > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

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
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: rounded_curved_punch.dF.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20).

    Examples
    --------
    >>> from axicontact.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.depth_from_force(1.658, R1=6.0, R2=1.2, b=1.0, E_star=1.0)
    >>> round(value, 6)
    0.721368
    """
    value = plain.depth_from_force(F, R1, R2, b, E_star)
    if value is not None:
        return value
    require(R1=R1, R2=R2, b=b, E_star=E_star)
    return elementwise(_depth_from_force, F, R1=R1, R2=R2, b=b, E_star=E_star)


def energy(a: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Elastic energy, the work of pressing the indenter in.

    U = 8*E_star*a**5/(15*R1**2)   for a < b
    U = E_star*(Integral((a*(-b*acos(b/a)/R2 + sqrt(a**2 - b**2)/R2 + a/R1) - t**2/R1)**2, (t, 0, b)) +
    Integral((a*(-b*acos(b/a)/R2 + sqrt(a**2 - b**2)/R2 + a/R1) - t*(-b*acos(b/t)/R2 + sqrt(-b**2 + t**2)/R2 +
    t/R1))**2, (t, b, a)))   for b < a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius of the inner part [m], b > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Elastic energy, the work of pressing the indenter in [J]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact by a Gauss-Legendre rule. Handbook: rounded_curved_punch.U.

    Examples
    --------
    >>> from axicontact.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.energy(1.5, R1=6.0, R2=1.2, b=1.0, E_star=1.0)
    >>> round(value, 6)
    0.512059
    """
    value = plain.energy(a, R1, R2, b, E_star)
    if value is not None:
        return value
    require(R1=R1, R2=R2, b=b, E_star=E_star)
    return elementwise(_energy, a, R1=R1, R2=R2, b=b, E_star=E_star)


def load_within(r: ArrayLike, a: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Part of the normal force that is carried within the radius r; all of it beyond the contact.

    F_r = 2*pi*Integral(t*p(t), (t, 0, r))

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius of the inner part [m], b > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Part of the normal force that is carried within the radius r [N]. The shape to which the arguments
        broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact by a Gauss-Legendre rule. Handbook: rounded_curved_punch.Fr.

    Examples
    --------
    >>> from axicontact.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.load_within(0.45, 1.5, R1=6.0, R2=1.2, b=1.0, E_star=1.0)
    >>> round(value, 6)
    0.154773
    """
    value = plain.load_within(r, a, R1, R2, b, E_star)
    if value is not None:
        return value
    require(R1=R1, R2=R2, b=b, E_star=E_star)
    return elementwise(_load_within, r, a, R1=R1, R2=R2, b=b, E_star=E_star)


def _profile(r: Array, R1: Array, R2: Array, b: Array) -> Array:
    return np.where(r < b, r**2 / (2 * R1), r**2 / (2 * R1) + (r - b) ** 2 / (2 * R2))


def _slope(t: Array, R1: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t)."""
    return 2 * t / R1


def _slope_beyond(t: Array, root: Array, R1: Array, R2: Array, b: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t) for t > b."""
    angle = np.arctan2(root, b)
    return 2 * t / R1 + 2 * root / R2 - b / R2 * angle


def _depth_beyond(a: Array, root: Array, R1: Array, R2: Array, b: Array) -> Array:
    return a * (a / R1 + b / R2 * arctan_gap(root / b))


def _depth(a: Array, R1: Array, R2: Array, b: Array) -> Array:
    tip = a**2 / R1
    beyond = a * (a / R1 + b / R2 * root_gap(a, b))
    return np.where(a < b, tip, beyond)


def _force_beyond(a: Array, root: Array, R1: Array, R2: Array, b: Array, E_star: Array) -> Array:
    return E_star * (4 * a**3 / (3 * R1) + root**3 / (3 * R2) + b / R2 * a**2 * arctan_gap(root / b))


def _force(a: Array, R1: Array, R2: Array, b: Array, E_star: Array) -> Array:
    tip = 4 * E_star / (3 * R1) * a**3
    root = np.sqrt((a - b) * (a + b))
    plus = 4 * a**3 / (3 * R1) + b / R2 * a**2 * root_gap(a, b) + (a - b) * (a + b) * root / (3 * R2)
    beyond = E_star * plus
    return np.where(a < b, tip, beyond)


def _pressure(r: Array, a: Array, R1: Array, R2: Array, b: Array, E_star: Array) -> Array:
    inner = np.minimum(a, b)
    root = np.sqrt((inner - r) * (inner + r))
    tip = np.where(r < inner, 2 * E_star / (np.pi * R1) * root, 0.0)
    growth = pressure_integral_beyond(_slope_beyond, (R1, R2, b), r, a, b)
    return np.where(r < a, tip + E_star / np.pi * growth, 0.0)


def _displacement(r: Array, a: Array, R1: Array, R2: Array, b: Array) -> Array:
    inner = np.minimum(a, b)
    beyond = displacement_integral_beyond(_slope_beyond, (R1, R2, b), r, a, b)
    outside = 2 * inner**2 / (np.pi * R1) * beside(r, inner, OUTSIDE_2) + 2 / np.pi * beyond
    inside = _depth(a, R1, R2, b) - _profile(r, R1, R2, b)
    return np.where(r > a, outside, inside)


def _stiffness(a: Array, E_star: Array) -> Array:
    return 2 * E_star * a


def _mean_pressure(a: Array, R1: Array, R2: Array, b: Array, E_star: Array) -> Array:
    tip = 4 * E_star / (3 * np.pi * R1) * a
    root = np.sqrt((a - b) * (a + b))
    plus = 4 * a / (3 * R1) + b / R2 * root_gap(a, b) + (a - b) * (a + b) * root / (3 * a**2 * R2)
    beyond = E_star / np.pi * plus
    return np.where(a < b, tip, beyond)


def _energy(a: Array, R1: Array, R2: Array, b: Array, E_star: Array) -> Array:
    sunk = _depth(a, R1, R2, b)
    inner = np.minimum(a, b)
    tip = energy_integral(_depth, (R1, R2, b), inner, sunk, inner)
    beyond = energy_integral_beyond(_depth_beyond, (R1, R2, b), a, sunk, b)
    return E_star * (tip + beyond)


def _load_within(r: Array, a: Array, R1: Array, R2: Array, b: Array, E_star: Array) -> Array:
    inner = np.minimum(a, b)
    tip = load_within_integral(_slope, (R1,), np.minimum(r, inner), inner)
    beyond = load_within_integral_beyond(_slope_beyond, (R1, R2, b), r, a, b)
    return _force(np.minimum(r, a), R1, R2, b, E_star) + 2 * E_star * (tip + beyond)


def _radius_from_depth(d: Array, R1: Array, R2: Array, b: Array) -> Array:
    def curve(a: Array, root: Array) -> tuple[Array, Array]:
        rate = a * _slope_beyond(a, root, R1, R2, b)
        return _depth_beyond(a, root, R1, R2, b), rate

    return inverse_beyond(curve, d, b, 2.0, leaving=(3.0, 2.0))


def _radius_from_force(F: Array, R1: Array, R2: Array, b: Array, E_star: Array) -> Array:
    def curve(a: Array, root: Array) -> tuple[Array, Array]:
        rate = 2 * E_star * a**2 * _slope_beyond(a, root, R1, R2, b)
        return _force_beyond(a, root, R1, R2, b, E_star), rate

    return inverse_beyond(curve, F, b, 3.0, leaving=(3.0, 3.0))


def _force_from_depth(d: Array, R1: Array, R2: Array, b: Array, E_star: Array) -> Array:
    a = _radius_from_depth(d, R1, R2, b)
    change = np.where((a > 0.0) & (a < np.inf), 2 * E_star * a * (d - _depth(a, R1, R2, b)), 0.0)
    return _force(a, R1, R2, b, E_star) + change


def _depth_from_force(F: Array, R1: Array, R2: Array, b: Array, E_star: Array) -> Array:
    a = _radius_from_force(F, R1, R2, b, E_star)
    change = np.where((a > 0.0) & (a < np.inf), (F - _force(a, R1, R2, b, E_star)) / (2 * E_star * a), 0.0)
    return _depth(a, R1, R2, b) + change
