"""Cone with a rounded tip.

Parabolic tip running tangentially into a cone at r = b.
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
from .._runtime.special import PeakPressure

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


def profile(r: ArrayLike, *, theta: ArrayLike, b: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = r**2*tan(theta)/(2*b)   for 0 < r < b
    f = (-b/2 + r)*tan(theta)   for b < r

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: rounded_cone.f, the definition
    of the profile.

    References
    ----------
    Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.normal import rounded_cone
    >>> value = rounded_cone.profile(0.3, theta=0.42, b=0.5)
    >>> round(value, 6)
    0.040192
    """
    value = plain.profile(r, theta, b)
    if value is not None:
        return value
    require(theta=theta, b=b)
    return elementwise(_profile, r, theta=theta, b=b)


def depth(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = a**2*tan(theta)/b   for a < b
    d = a*(a/b + acos(b/a) - sqrt(a**2 - b**2)/b)*tan(theta)   for b < a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: rounded_cone.d.

    References
    ----------
    chapter 11, equation (11.29); Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.normal import rounded_cone
    >>> value = rounded_cone.depth(1.0, theta=0.42, b=0.5)
    >>> round(value, 6)
    0.587308
    """
    value = plain.depth(a, theta, b)
    if value is not None:
        return value
    require(theta=theta, b=b)
    return elementwise(_depth, a, theta=theta, b=b)


def force(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force.

    F = 4*E_star*a**3*tan(theta)/(3*b)   for a < b
    F = E_star*(4*a**3/(3*b) + a**2*acos(b/a) - (2*a - b)*(2*a + b)*sqrt(a**2 - b**2)/(3*b))*tan(theta)   for
    b < a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: rounded_cone.F.

    References
    ----------
    chapter 11, equation (11.20); Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.normal import rounded_cone
    >>> value = rounded_cone.force(1.0, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.691652
    """
    value = plain.force(a, theta, b, E_star)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    return elementwise(_force, a, theta=theta, b=b, E_star=E_star)


def pressure(r: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = 2*E_star*sqrt(a**2 - r**2)*tan(theta)/(pi*b)   for a < b
    p = E_star*(-2*a*sqrt(a**2 - b**2)/(b*sqrt(a**2 - r**2)) + C0(b, r, a) + 2*elliptic_e(asin(sqrt((a**2 -
    b**2)/(a**2 - r**2))), r**2/b**2) + 2*sqrt(a**2 - r**2)/b)*tan(theta)/pi   for r < b and b < a
    p = E_star*(-2*a*sqrt(a**2 - r**2)/(b*sqrt(a**2 - b**2)) + C0(b, r, a) + 2*r*elliptic_e(asin(sqrt((a**2 -
    r**2)/(a**2 - b**2))), b**2/r**2)/b + 2*sqrt(a**2 - r**2)/b - 2*(-b + r)*(b +
    r)*elliptic_f(asin(sqrt((a**2 - r**2)/(a**2 - b**2))), b**2/r**2)/(b*r))*tan(theta)/pi   for b < r
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact by a Gauss-Legendre rule. Handbook: rounded_cone.p.

    References
    ----------
    chapter 11, equation (11.23); Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.normal import rounded_cone
    >>> value = rounded_cone.pressure(0.3, 1.0, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.408675
    """
    value = plain.pressure(r, a, theta, b, E_star)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    return elementwise(_pressure, r, a, theta=theta, b=b, E_star=E_star)


def displacement(r: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = (a*sqrt(-a**2 + r**2) - (-2*a**2 + r**2)*asin(a/r))*tan(theta)/(pi*b)   for a < b
    w = (2*a*acos(b/a)*asin(a/r) + a*sqrt(-a**2 + r**2)/b - 2*a*sqrt(a**2 - b**2)*asin(a/r)/b -
    2*r*acos(b*sqrt(-a**2 + r**2)/(a*sqrt(-b**2 + r**2))) + 2*sqrt(-a**2 + r**2)*acos(b/a) - (-2*a**2 +
    r**2)*asin(a/r)/b - sqrt(-a**2 + r**2)*sqrt(a**2 - b**2)/b + (b**2 + r**2)*asin(sqrt((a**2 - b**2)/(-b**2
    + r**2)))/b)*tan(theta)/pi   for b < a

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact by a Gauss-Legendre rule. Handbook: rounded_cone.w.

    References
    ----------
    chapter 11, equation (11.26); Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.normal import rounded_cone
    >>> value = rounded_cone.displacement(2.0, 1.0, theta=0.42, b=0.5)
    >>> round(value, 6)
    0.112658
    """
    value = plain.displacement(r, a, theta, b)
    if value is not None:
        return value
    require(theta=theta, b=b)
    return elementwise(_displacement, r, a, theta=theta, b=b)


def stiffness(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*E_star*a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: rounded_cone.k.

    References
    ----------
    chapter 11, equation (11.18); Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.normal import rounded_cone
    >>> value = rounded_cone.stiffness(1.0, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    2.0
    """
    value = plain.stiffness(a, E_star, theta, b)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    return elementwise(_stiffness, a, E_star=E_star, unused=(theta, b))


def mean_pressure(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = 4*E_star*a*tan(theta)/(3*pi*b)   for a < b
    p_mean = E_star*(4*a/(3*b) + acos(b/a) - (2*a - b)*(2*a + b)*sqrt(a**2 - b**2)/(3*a**2*b))*tan(theta)/pi
    for b < a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: rounded_cone.pm.

    References
    ----------
    Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.normal import rounded_cone
    >>> value = rounded_cone.mean_pressure(1.0, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.22016
    """
    value = plain.mean_pressure(a, theta, b, E_star)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    return elementwise(_mean_pressure, a, theta=theta, b=b, E_star=E_star)


def radius_from_depth(d: ArrayLike, *, theta: ArrayLike, b: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a from a**2*tan(theta)/b = d   for a < b
    a from a*(a/b + acos(b/a) - sqrt(a**2 - b**2)/b)*tan(theta) = d   for b < a

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: rounded_cone.ad.

    References
    ----------
    chapter 11, equation (11.16); Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.normal import rounded_cone
    >>> value = rounded_cone.radius_from_depth(0.5873, theta=0.42, b=0.5)
    >>> round(value, 6)
    0.999988
    """
    value = plain.radius_from_depth(d, theta, b)
    if value is not None:
        return value
    require(theta=theta, b=b)
    return elementwise(_radius_from_depth, d, theta=theta, b=b)


def radius_from_force(F: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a from 4*E_star*a**3*tan(theta)/(3*b) = F   for a < b
    a from E_star*(4*a**3/(3*b) + a**2*acos(b/a) - (2*a - b)*(2*a + b)*sqrt(a**2 - b**2)/(3*b))*tan(theta) = F
    for b < a

    Parameters
    ----------
    F : array_like
        Normal force [N].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: rounded_cone.aF.

    References
    ----------
    chapter 11, equation (11.20); Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.normal import rounded_cone
    >>> value = rounded_cone.radius_from_force(0.6917, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    1.000034
    """
    value = plain.radius_from_force(F, theta, b, E_star)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    return elementwise(_radius_from_force, F, theta=theta, b=b, E_star=E_star)


def force_from_depth(d: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = F(a(d)), through the contact radius.

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: rounded_cone.Fd.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.normal import rounded_cone
    >>> value = rounded_cone.force_from_depth(0.5873, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.691635
    """
    value = plain.force_from_depth(d, theta, b, E_star)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    return elementwise(_force_from_depth, d, theta=theta, b=b, E_star=E_star)


def depth_from_force(F: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = d(a(F)), through the contact radius.

    Parameters
    ----------
    F : array_like
        Normal force [N].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: rounded_cone.dF.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.normal import rounded_cone
    >>> value = rounded_cone.depth_from_force(0.6917, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.587332
    """
    value = plain.depth_from_force(F, theta, b, E_star)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    return elementwise(_depth_from_force, F, theta=theta, b=b, E_star=E_star)


def peak_pressure(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> PeakPressure:
    """Greatest pressure, and the radius of the ring on which it is.

    p_peak = 2*E_star*a*tan(theta)/(pi*b)   for a < b
    p_peak = E_star*(2*a/b + C0(b, 0, a) + 2*asin(sqrt(a**2 - b**2)/a) - 2*sqrt(a**2 - b**2)/b)*tan(theta)/pi
    for b < a
    with C0(b, r, a) = int_{max(b, r)}^a acos(b/t) / sqrt(t**2 - r**2) dt, for 0 <= b, r < a
    r_peak = 0

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius of the inner part [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact by a Gauss-Legendre rule. Handbook: rounded_cone.rp, rounded_cone.pp.

    References
    ----------
    chapter 11, equation (11.23); Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.normal import rounded_cone
    >>> value = rounded_cone.peak_pressure(1.0, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value.pressure, 6)
    0.446028
    """
    require(theta=theta, b=b, E_star=E_star)
    pressure = elementwise(_peak_pressure, a, theta=theta, b=b, E_star=E_star)
    radius = elementwise(_peak_radius, a, unused=(theta, b, E_star))
    return PeakPressure(pressure, radius)


def energy(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Elastic energy, the work of pressing the indenter in.

    U = 8*E_star*a**5*tan(theta)**2/(15*b**2)   for a < b
    U = E_star*(Integral((a*(a/b + acos(b/a) - sqrt(a**2 - b**2)/b)*tan(theta) - t**2*tan(theta)/b)**2, (t, 0,
    b)) + Integral((a*(a/b + acos(b/a) - sqrt(a**2 - b**2)/b)*tan(theta) - t*(acos(b/t) + t/b - sqrt(-b**2 +
    t**2)/b)*tan(theta))**2, (t, b, a)))   for b < a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact by a Gauss-Legendre rule. Handbook: rounded_cone.U.

    References
    ----------
    Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.normal import rounded_cone
    >>> value = rounded_cone.energy(1.0, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.15515
    """
    value = plain.energy(a, theta, b, E_star)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    return elementwise(_energy, a, theta=theta, b=b, E_star=E_star)


def load_within(r: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Part of the normal force that is carried within the radius r; all of it beyond the contact.

    F_r = 2*pi*Integral(t*p(t), (t, 0, r))

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact by a Gauss-Legendre rule. Handbook: rounded_cone.Fr.

    References
    ----------
    Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.normal import rounded_cone
    >>> value = rounded_cone.load_within(0.3, 1.0, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.120941
    """
    value = plain.load_within(r, a, theta, b, E_star)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    return elementwise(_load_within, r, a, theta=theta, b=b, E_star=E_star)


def _profile(r: Array, theta: Array, b: Array) -> Array:
    return np.where(r < b, np.tan(theta) / (2 * b) * r**2, np.tan(theta) * (r - b / 2))


def _slope(t: Array, theta: Array, b: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t)."""
    return 2 * np.tan(theta) / b * t


def _slope_beyond(t: Array, root: Array, theta: Array, b: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t) for t > b."""
    angle = np.arctan(root / b)
    return np.tan(theta) * (angle + 2 * b / (root + t))


def _depth_beyond(a: Array, root: Array, theta: Array, b: Array) -> Array:
    angle = np.arctan(root / b)
    return np.tan(theta) * a * (angle + b / (root + a))


def _depth(a: Array, theta: Array, b: Array) -> Array:
    tip = np.tan(theta) / b * a**2
    root = np.sqrt((a - b) * (a + b))
    angle = np.arctan(root / b)
    beyond = np.tan(theta) * a * (angle + b / (root + a))
    return np.where(a < b, tip, beyond)


def _force_beyond(a: Array, root: Array, theta: Array, b: Array, E_star: Array) -> Array:
    angle = np.arctan(root / b)
    return E_star * np.tan(theta) * (a**2 * angle + 4 * b * a**2 / (3 * (root + a)) + b / 3 * root)


def _force(a: Array, theta: Array, b: Array, E_star: Array) -> Array:
    tip = 4 * E_star * np.tan(theta) / (3 * b) * a**3
    root = np.sqrt((a - b) * (a + b))
    angle = np.arctan(root / b)
    beyond = E_star * np.tan(theta) * (a**2 * angle + 4 * b * a**2 / (3 * (root + a)) + b / 3 * root)
    return np.where(a < b, tip, beyond)


def _pressure(r: Array, a: Array, theta: Array, b: Array, E_star: Array) -> Array:
    inner = np.minimum(a, b)
    root = np.sqrt((inner - r) * (inner + r))
    tip = np.where(r < inner, 2 * E_star * np.tan(theta) / (np.pi * b) * root, 0.0)
    growth = pressure_integral_beyond(_slope_beyond, (theta, b), r, a, b)
    return np.where(r < a, tip + E_star / np.pi * growth, 0.0)


def _displacement(r: Array, a: Array, theta: Array, b: Array) -> Array:
    inner = np.minimum(a, b)
    beyond = displacement_integral_beyond(_slope_beyond, (theta, b), r, a, b)
    outside = 2 * np.tan(theta) / (np.pi * b) * inner**2 * beside(r, inner, OUTSIDE_2) + 2 / np.pi * beyond
    inside = _depth(a, theta, b) - _profile(r, theta, b)
    return np.where(r > a, outside, inside)


def _stiffness(a: Array, E_star: Array) -> Array:
    return 2 * E_star * a


def _mean_pressure(a: Array, theta: Array, b: Array, E_star: Array) -> Array:
    tip = 4 * E_star * np.tan(theta) / (3 * np.pi * b) * a
    root = np.sqrt((a - b) * (a + b))
    angle = np.arctan(root / b)
    beyond = E_star * np.tan(theta) / np.pi * (angle + 4 * b / (3 * (root + a)) + b * root / (3 * a**2))
    return np.where(a < b, tip, beyond)


def _peak_radius(a: Array) -> Array:
    return np.zeros_like(a)


def _peak_pressure(a: Array, theta: Array, b: Array, E_star: Array) -> Array:
    return _pressure(np.zeros_like(a), a, theta, b, E_star)


def _energy(a: Array, theta: Array, b: Array, E_star: Array) -> Array:
    sunk = _depth(a, theta, b)
    inner = np.minimum(a, b)
    tip = energy_integral(_depth, (theta, b), inner, sunk, inner)
    beyond = energy_integral_beyond(_depth_beyond, (theta, b), a, sunk, b)
    return E_star * (tip + beyond)


def _load_within(r: Array, a: Array, theta: Array, b: Array, E_star: Array) -> Array:
    inner = np.minimum(a, b)
    tip = load_within_integral(_slope, (theta, b), np.minimum(r, inner), inner)
    beyond = load_within_integral_beyond(_slope_beyond, (theta, b), r, a, b)
    return _force(np.minimum(r, a), theta, b, E_star) + 2 * E_star * (tip + beyond)


def _radius_from_depth(d: Array, theta: Array, b: Array) -> Array:
    def curve(a: Array, root: Array) -> tuple[Array, Array]:
        rate = a * _slope_beyond(a, root, theta, b)
        return _depth_beyond(a, root, theta, b), rate

    return inverse_beyond(curve, d, b, 2.0, powers=(2.0, 1.0))


def _radius_from_force(F: Array, theta: Array, b: Array, E_star: Array) -> Array:
    def curve(a: Array, root: Array) -> tuple[Array, Array]:
        rate = 2 * E_star * a**2 * _slope_beyond(a, root, theta, b)
        return _force_beyond(a, root, theta, b, E_star), rate

    return inverse_beyond(curve, F, b, 3.0, powers=(2.0, 2.0))


def _force_from_depth(d: Array, theta: Array, b: Array, E_star: Array) -> Array:
    a = _radius_from_depth(d, theta, b)
    change = np.where((a > 0.0) & (a < np.inf), 2 * E_star * a * (d - _depth(a, theta, b)), 0.0)
    return _force(a, theta, b, E_star) + change


def _depth_from_force(F: Array, theta: Array, b: Array, E_star: Array) -> Array:
    a = _radius_from_force(F, theta, b, E_star)
    change = np.where((a > 0.0) & (a < np.inf), (F - _force(a, theta, b, E_star)) / (2 * E_star * a), 0.0)
    return _depth(a, theta, b) + change
