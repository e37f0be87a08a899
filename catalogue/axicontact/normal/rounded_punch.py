"""Flat punch with a rounded edge.

Flat face of radius b running tangentially into a rounding of radius R: between flat punch and sphere.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Plain, Result, elementwise, require, require_reach
from .._runtime.inverse import between, inverse
from .._runtime.rules import displacement_integral_beyond, peak_integral_beyond, pressure_integral_beyond
from .._runtime.shapes.energy import energy_integral_beyond
from .._runtime.shapes.load_within import load_within_integral_beyond
from .._runtime.special import PeakPressure, arctan_gap, peak_share, root_gap

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
    "peak_pressure",
    "pressure",
    "profile",
    "radius_from_depth",
    "radius_from_force",
    "stiffness",
]


def __dir__() -> list[str]:
    return __all__


plain = Plain(__name__, __all__)


def profile(r: ArrayLike, *, R: ArrayLike, b: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = 0   for 0 < r < b
    f = (-b + r)**2/(2*R)   for b < r

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.

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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values give NaN. Handbook:
    rounded_punch.f, the definition of the profile.

    References
    ----------
    Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.normal import rounded_punch
    >>> value = rounded_punch.profile(0.486, R=1.45, b=1.15)
    >>> round(value, 6)
    0.0
    """
    value = plain.profile(r, R, b)
    if value is not None:
        return value
    require(R=R, b=b)
    return elementwise(_profile, r, R=R, b=b)


def depth(a: ArrayLike, *, R: ArrayLike, b: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = a*(-b*acos(b/a) + sqrt(a**2 - b**2))/R

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.

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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values, and radii below b among larger
    ones, give NaN. The pressure is bounded. Handbook: rounded_punch.d.

    References
    ----------
    chapter 11, equation (11.29); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.normal import rounded_punch
    >>> value = rounded_punch.depth(1.62, R=1.45, b=1.15)
    >>> round(value, 6)
    0.270723
    """
    value = plain.depth(a, R, b)
    if value is not None:
        return value
    require(R=R, b=b)
    require_reach(a, b)
    return elementwise(_depth, a, R=R, b=b)


def force(a: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force.

    F = E_star*(-a**2*b*acos(b/a) + (2*a - b)*(2*a + b)*sqrt(a**2 - b**2)/3)/R

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.
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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values, and radii below b among larger
    ones, give NaN. The pressure is bounded. Handbook: rounded_punch.F.

    References
    ----------
    chapter 11, equation (11.20); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.normal import rounded_punch
    >>> value = rounded_punch.force(1.62, R=1.45, b=1.15, E_star=1.0)
    >>> round(value, 6)
    0.780061
    """
    value = plain.force(a, R, b, E_star)
    if value is not None:
        return value
    require(R=R, b=b, E_star=E_star)
    require_reach(a, b)
    return elementwise(_force, a, R=R, b=b, E_star=E_star)


def pressure(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = E_star*(2*a*sqrt(a**2 - b**2)/sqrt(a**2 - r**2) - b*C0(b, r, a) - 2*b*elliptic_e(asin(sqrt((a**2 -
    b**2)/(a**2 - r**2))), r**2/b**2))/(pi*R)   for r < b
    p = E_star*(2*a*sqrt(a**2 - r**2)/sqrt(a**2 - b**2) - b*C0(b, r, a) - 2*r*elliptic_e(asin(sqrt((a**2 -
    r**2)/(a**2 - b**2))), b**2/r**2) + 2*(-b + r)*(b + r)*elliptic_f(asin(sqrt((a**2 - r**2)/(a**2 - b**2))),
    b**2/r**2)/r)/(pi*R)   for b < r
    with C0(b, r, a) = int_{max(b, r)}^a acos(b/t) / sqrt(t**2 - r**2) dt, for 0 <= b, r < a
    with elliptic integrals of the parameter m = k**2, their last argument

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.
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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values, and radii below b among larger
    ones, give NaN. Evaluated as an integral over the growing contact by a Gauss-Legendre rule. The pressure
    is bounded. Handbook: rounded_punch.p.

    References
    ----------
    chapter 11, equation (11.23); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.normal import rounded_punch
    >>> value = rounded_punch.pressure(0.486, 1.62, R=1.45, b=1.15, E_star=1.0)
    >>> round(value, 6)
    0.064187
    """
    value = plain.pressure(r, a, R, b, E_star)
    if value is not None:
        return value
    require(R=R, b=b, E_star=E_star)
    require_reach(a, b)
    return elementwise(_pressure, r, a, R=R, b=b, E_star=E_star)


def displacement(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, b: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = (-2*a*b*acos(b/a)*asin(a/r) + 2*a*sqrt(a**2 - b**2)*asin(a/r) + 2*b*r*acos(b*sqrt(-a**2 +
    r**2)/(a*sqrt(-b**2 + r**2))) - 2*b*sqrt(-a**2 + r**2)*acos(b/a) + sqrt(-a**2 + r**2)*sqrt(a**2 - b**2) -
    (b**2 + r**2)*asin(sqrt((a**2 - b**2)/(-b**2 + r**2))))/(pi*R)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.

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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values, and radii below b among larger
    ones, give NaN. Evaluated as an integral over the growing contact by a Gauss-Legendre rule. Handbook:
    rounded_punch.w.

    References
    ----------
    chapter 11, equation (11.26); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.normal import rounded_punch
    >>> value = rounded_punch.displacement(3.24, 1.62, R=1.45, b=1.15)
    >>> round(value, 6)
    0.07949
    """
    value = plain.displacement(r, a, R, b)
    if value is not None:
        return value
    require(R=R, b=b)
    require_reach(a, b)
    return elementwise(_displacement, r, a, R=R, b=b)


def stiffness(a: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*E_star*a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.
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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values, and radii below b among larger
    ones, give NaN. Handbook: rounded_punch.k.

    References
    ----------
    chapter 11, equation (11.18); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.normal import rounded_punch
    >>> value = rounded_punch.stiffness(1.62, R=1.45, b=1.15, E_star=1.0)
    >>> round(value, 6)
    3.24
    """
    value = plain.stiffness(a, E_star, R, b)
    if value is not None:
        return value
    require(R=R, b=b, E_star=E_star)
    require_reach(a, b)
    return elementwise(_stiffness, a, E_star=E_star, unused=(R, b))


def mean_pressure(a: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = E_star*(-b*acos(b/a) + (2*a - b)*(2*a + b)*sqrt(a**2 - b**2)/(3*a**2))/(pi*R)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.
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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values, and radii below b among larger
    ones, give NaN. Handbook: rounded_punch.pm.

    References
    ----------
    Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.normal import rounded_punch
    >>> value = rounded_punch.mean_pressure(1.62, R=1.45, b=1.15, E_star=1.0)
    >>> round(value, 6)
    0.094613
    """
    value = plain.mean_pressure(a, R, b, E_star)
    if value is not None:
        return value
    require(R=R, b=b, E_star=E_star)
    require_reach(a, b)
    return elementwise(_mean_pressure, a, R=R, b=b, E_star=E_star)


def radius_from_depth(d: ArrayLike, *, R: ArrayLike, b: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a from a*(-b*acos(b/a) + sqrt(a**2 - b**2))/R = d

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.

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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values give NaN. Evaluated by a
    safeguarded Newton iteration. Handbook: rounded_punch.ad.

    References
    ----------
    chapter 11, equation (11.16); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.normal import rounded_punch
    >>> value = rounded_punch.radius_from_depth(0.2707, R=1.45, b=1.15)
    >>> round(value, 6)
    1.619976
    """
    value = plain.radius_from_depth(d, R, b)
    if value is not None:
        return value
    require(R=R, b=b)
    return elementwise(_radius_from_depth, d, R=R, b=b)


def radius_from_force(F: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a from E_star*(-a**2*b*acos(b/a) + (2*a - b)*(2*a + b)*sqrt(a**2 - b**2)/3)/R = F

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.
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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values give NaN. Evaluated by a
    safeguarded Newton iteration. Handbook: rounded_punch.aF.

    References
    ----------
    chapter 11, equation (11.20); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.normal import rounded_punch
    >>> value = rounded_punch.radius_from_force(0.7801, R=1.45, b=1.15, E_star=1.0)
    >>> round(value, 6)
    1.620013
    """
    value = plain.radius_from_force(F, R, b, E_star)
    if value is not None:
        return value
    require(R=R, b=b, E_star=E_star)
    return elementwise(_radius_from_force, F, R=R, b=b, E_star=E_star)


def force_from_depth(d: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = F(a(d)), through the contact radius.

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.
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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values give NaN. Evaluated by a
    safeguarded Newton iteration. Handbook: rounded_punch.Fd.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.normal import rounded_punch
    >>> value = rounded_punch.force_from_depth(0.2707, R=1.45, b=1.15, E_star=1.0)
    >>> round(value, 6)
    0.779986
    """
    value = plain.force_from_depth(d, R, b, E_star)
    if value is not None:
        return value
    require(R=R, b=b, E_star=E_star)
    return elementwise(_force_from_depth, d, R=R, b=b, E_star=E_star)


def depth_from_force(F: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = d(a(F)), through the contact radius.

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.
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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values give NaN. Evaluated by a
    safeguarded Newton iteration. Handbook: rounded_punch.dF.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.normal import rounded_punch
    >>> value = rounded_punch.depth_from_force(0.7801, R=1.45, b=1.15, E_star=1.0)
    >>> round(value, 6)
    0.270735
    """
    value = plain.depth_from_force(F, R, b, E_star)
    if value is not None:
        return value
    require(R=R, b=b, E_star=E_star)
    return elementwise(_depth_from_force, F, R=R, b=b, E_star=E_star)


def peak_pressure(a: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> PeakPressure:
    """Greatest pressure, and the radius of the ring on which it is.

    p_peak = E_star*(2*a*sqrt(a**2 - r_peak**2)/sqrt(a**2 - b**2) - b*C0(b, r_peak, a) -
    2*r_peak*elliptic_e(asin(sqrt((a**2 - r_peak**2)/(a**2 - b**2))), b**2/r_peak**2) + 2*(-b + r_peak)*(b +
    r_peak)*elliptic_f(asin(sqrt((a**2 - r_peak**2)/(a**2 - b**2))), b**2/r_peak**2)/r_peak)/(pi*R)
    with C0(b, r, a) = int_{max(b, r)}^a acos(b/t) / sqrt(t**2 - r**2) dt, for 0 <= b, r < a
    with elliptic integrals of the parameter m = k**2, their last argument
    r_peak from -2*elliptic_e(asin(sqrt((a**2 - r_peak**2)/(a**2 - b**2))), b**2/r_peak**2) + (-b**2 +
    2*r_peak**2)*elliptic_f(asin(sqrt((a**2 - r_peak**2)/(a**2 - b**2))), b**2/r_peak**2)/r_peak**2 +
    2*b**2*sqrt(a**2 - r_peak**2)/(a*r_peak*sqrt(a**2 - b**2)) + b*sqrt(a**2 - r_peak**2)*acos(b/a)/(a*r_peak)
    = r_peak*(-b*acos(b/a) + 2*sqrt(a**2 - b**2))/(a*sqrt(a**2 - r_peak**2))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    PeakPressure
        Named tuple of pressure [Pa] and radius [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a - b << R (parabolic rounding). Negative or NaN field values, and radii below b among larger
    ones, give NaN. Evaluated as an integral over the growing contact by a Gauss-Legendre rule. Handbook:
    rounded_punch.rp, rounded_punch.pp.

    References
    ----------
    chapter 11, equation (11.23); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.normal import rounded_punch
    >>> value = rounded_punch.peak_pressure(1.62, R=1.45, b=1.15, E_star=1.0)
    >>> round(value.pressure, 6)
    0.136456
    """
    require(R=R, b=b, E_star=E_star)
    require_reach(a, b)
    pressure = elementwise(_peak_pressure, a, R=R, b=b, E_star=E_star)
    radius = elementwise(_peak_radius, a, b=b, unused=(R, E_star))
    return PeakPressure(pressure, radius)


def energy(a: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Elastic energy, the work of pressing the indenter in.

    U = E_star*(Integral((a*(-b*acos(b/a) + sqrt(a**2 - b**2))/R - t*(-b*acos(b/t) + sqrt(-b**2 +
    t**2))/R)**2, (t, b, a)) + a**2*b*(-b*acos(b/a) + sqrt(a**2 - b**2))**2/R**2)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.
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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values, and radii below b among larger
    ones, give NaN. Evaluated as an integral over the growing contact by a Gauss-Legendre rule. Handbook:
    rounded_punch.U.

    References
    ----------
    Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.normal import rounded_punch
    >>> value = rounded_punch.energy(1.62, R=1.45, b=1.15, E_star=1.0)
    >>> round(value, 6)
    0.100523
    """
    value = plain.energy(a, R, b, E_star)
    if value is not None:
        return value
    require(R=R, b=b, E_star=E_star)
    require_reach(a, b)
    return elementwise(_energy, a, R=R, b=b, E_star=E_star)


def load_within(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Part of the normal force that is carried within the radius r; all of it beyond the contact.

    F_r = E_star*(-a**2*b*acos(b/a) + a*b*sqrt(a**2 - r**2)*acos(b/a) + a*sqrt(a**2 - b**2)*(-4*a**2 + b**2 +
    8*r**2)/(3*sqrt(a**2 - r**2)) - b*r**2*C0(b, r, a) - b*(-b + r)*(b + r)*elliptic_f(asin(sqrt((a**2 -
    b**2)/(a**2 - r**2))), r**2/b**2)/3 - b*(b**2 + 4*r**2)*elliptic_e(asin(sqrt((a**2 - b**2)/(a**2 -
    r**2))), r**2/b**2)/3 + (2*a - b)*(2*a + b)*sqrt(a**2 - b**2)/3)/R   for r < b
    F_r = E_star*(-a**2*b*acos(b/a) + a*b*sqrt(a**2 - r**2)*acos(b/a) + a*sqrt(a**2 - r**2)*(-4*a**2 + 5*b**2
    + 4*r**2)/(3*sqrt(a**2 - b**2)) - b*r**2*C0(b, r, a) + 4*r*(-b + r)*(b + r)*elliptic_f(asin(sqrt((a**2 -
    r**2)/(a**2 - b**2))), b**2/r**2)/3 - r*(b**2 + 4*r**2)*elliptic_e(asin(sqrt((a**2 - r**2)/(a**2 -
    b**2))), b**2/r**2)/3 + (2*a - b)*(2*a + b)*sqrt(a**2 - b**2)/3)/R   for b < r
    with C0(b, r, a) = int_{max(b, r)}^a acos(b/t) / sqrt(t**2 - r**2) dt, for 0 <= b, r < a
    with elliptic integrals of the parameter m = k**2, their last argument

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.
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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values, and radii below b among larger
    ones, give NaN. Evaluated as an integral over the growing contact by a Gauss-Legendre rule. Handbook:
    rounded_punch.Fr.

    References
    ----------
    Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.normal import rounded_punch
    >>> value = rounded_punch.load_within(0.486, 1.62, R=1.45, b=1.15, E_star=1.0)
    >>> round(value, 6)
    0.046124
    """
    value = plain.load_within(r, a, R, b, E_star)
    if value is not None:
        return value
    require(R=R, b=b, E_star=E_star)
    require_reach(a, b)
    return elementwise(_load_within, r, a, R=R, b=b, E_star=E_star)


def _profile(r: Array, R: Array, b: Array) -> Array:
    return np.where(r < b, 0, (r - b) ** 2 / (2 * R))


def _slope_beyond(t: Array, root: Array, R: Array, b: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t) for t > b."""
    angle = np.arctan2(root, b)
    return 2 * root / R - b / R * angle


def _depth_at(a: Array, root: Array, R: Array, b: Array) -> Array:
    return b / R * a * arctan_gap(root / b)


def _depth(a: Array, R: Array, b: Array) -> Array:
    return b / R * a * root_gap(a, b)


def _force_at(a: Array, root: Array, R: Array, b: Array, E_star: Array) -> Array:
    return E_star / R * (root**3 / 3 + b * a**2 * arctan_gap(root / b))


def _force(a: Array, R: Array, b: Array, E_star: Array) -> Array:
    root = np.sqrt((a - b) * (a + b))
    return E_star / R * (b * a**2 * root_gap(a, b) + (a - b) * (a + b) * root / 3)


def _pressure(r: Array, a: Array, R: Array, b: Array, E_star: Array) -> Array:
    growth = pressure_integral_beyond(_slope_beyond, (R, b), r, a, b)
    inside = np.where(r < a, E_star / np.pi * growth, 0.0)
    return np.where(a >= b, inside, np.nan)


def _displacement(r: Array, a: Array, R: Array, b: Array) -> Array:
    beyond = displacement_integral_beyond(_slope_beyond, (R, b), r, a, b)
    outside = 2 / np.pi * beyond
    inside = _depth(a, R, b) - _profile(r, R, b)
    return np.where(a >= b, np.where(r > a, outside, inside), np.nan)


def _stiffness(a: Array, E_star: Array) -> Array:
    return 2 * E_star * a


def _mean_pressure(a: Array, R: Array, b: Array, E_star: Array) -> Array:
    root = np.sqrt((a - b) * (a + b))
    return E_star / (np.pi * R) * (b * root_gap(a, b) + (a - b) * (a + b) * root / (3 * a**2))


def _peak_radius(a: Array, b: Array) -> Array:
    return np.where(a >= b, np.where(a < np.inf, b + (a - b) * peak_share(a, b), a), np.nan)


def _peak_pressure(a: Array, R: Array, b: Array, E_star: Array) -> Array:
    growth = peak_integral_beyond(_slope_beyond, (R, b), peak_share(a, b), a, b)
    return np.where(a >= b, np.where(a < np.inf, E_star / np.pi * growth, a), np.nan)


def _energy(a: Array, R: Array, b: Array, E_star: Array) -> Array:
    sunk = _depth(a, R, b)
    beyond = energy_integral_beyond(_depth_at, (R, b), a, sunk, b)
    return np.where(a >= b, E_star * (b * sunk * sunk + beyond), np.nan)


def _load_within(r: Array, a: Array, R: Array, b: Array, E_star: Array) -> Array:
    beyond = load_within_integral_beyond(_slope_beyond, (R, b), r, a, b)
    found = np.where(r > b, _force(np.maximum(np.minimum(r, a), b), R, b, E_star), 0.0) + 2 * E_star * beyond
    return np.where(a >= b, found, np.nan)


def _contact_from_depth(d: Array, R: Array, b: Array) -> tuple[Array, Array]:
    """Contact radius a and its root sqrt(a**2 - b**2)."""

    def curve(t: Array) -> tuple[Array, Array]:
        a, root = b * np.sqrt(1.0 + t * t), b * t
        value = _depth_at(a, root, R, b)
        return value, root * root / a * _slope_beyond(a, root, R, b) / value

    rest = (0.9999152, -0.002147146, -0.02265958, -0.0720644, 0.3108858, -0.6900221, 1.077435, -0.6001833)
    start = between(np.log(d / curve(1.0)[0]), (1.098, 3.0), (3.295, 2.0), 3.5, rest)
    t = inverse(curve, d, start, (2.0, 4.0), smooth=True)
    return b * np.sqrt(1.0 + t * t), b * t


def _radius_from_depth(d: Array, R: Array, b: Array) -> Array:
    return _contact_from_depth(d, R, b)[0]


def _contact_from_force(F: Array, R: Array, b: Array, E_star: Array) -> tuple[Array, Array]:
    """Contact radius a and its root sqrt(a**2 - b**2)."""

    def curve(t: Array) -> tuple[Array, Array]:
        a, root = b * np.sqrt(1.0 + t * t), b * t
        value = _force_at(a, root, R, b, E_star)
        return value, 2 * E_star * root * root * _slope_beyond(a, root, R, b) / value

    rest = (0.9634905, 0.003191853, -0.1218583, 0.3231377, -1.571447, 2.059576, -1.105184, 0.2138332)
    start = between(np.log(F / curve(1.0)[0]), (0.8743, 3.0), (1.749, 3.0), 6.0, rest)
    t = inverse(curve, F, start, (3.0, 4.0), smooth=True)
    return b * np.sqrt(1.0 + t * t), b * t


def _radius_from_force(F: Array, R: Array, b: Array, E_star: Array) -> Array:
    return _contact_from_force(F, R, b, E_star)[0]


def _force_from_depth(d: Array, R: Array, b: Array, E_star: Array) -> Array:
    a, root = _contact_from_depth(d, R, b)
    change = np.where((a > 0.0) & (a < np.inf), 2 * E_star * a * (d - _depth_at(a, root, R, b)), 0.0)
    return _force_at(a, root, R, b, E_star) + change


def _depth_from_force(F: Array, R: Array, b: Array, E_star: Array) -> Array:
    a, root = _contact_from_force(F, R, b, E_star)
    change = np.where((a > 0.0) & (a < np.inf), (F - _force_at(a, root, R, b, E_star)) / (2 * E_star * a), 0.0)
    return _depth_at(a, root, R, b) + change
