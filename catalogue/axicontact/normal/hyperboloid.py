"""Hyperboloid of revolution.

A cone with a smoothly rounded tip: tip radius b/tan(theta), asymptotic inclination theta.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Plain, Result, elementwise, require
from .._runtime.inverse import inverse
from .._runtime.rules import displacement_integral_sinh, pressure_integral_sinh
from .._runtime.shapes.energy import energy_integral
from .._runtime.shapes.load_within import load_within_integral
from .._runtime.special import PeakPressure, arctan_gap

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

    f = (-b + sqrt(b**2 + r**2))*tan(theta)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Length of the rounded tip, whose radius of curvature is b/tan(theta) [m], b > 0.

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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: hyperboloid.f, the definition
    of the profile.

    References
    ----------
    Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import hyperboloid
    >>> value = hyperboloid.profile(0.3, theta=0.42, b=0.4)
    >>> round(value, 6)
    0.044657
    """
    value = plain.profile(r, theta, b)
    if value is not None:
        return value
    require(theta=theta, b=b)
    return elementwise(_profile, r, theta=theta, b=b)


def depth(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = a*tan(theta)*atan(a/b)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Length of the rounded tip, whose radius of curvature is b/tan(theta) [m], b > 0.

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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: hyperboloid.d.

    References
    ----------
    chapter 11, equation (11.29); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import hyperboloid
    >>> value = hyperboloid.depth(1.0, theta=0.42, b=0.4)
    >>> round(value, 6)
    0.531551
    """
    value = plain.depth(a, theta, b)
    if value is not None:
        return value
    require(theta=theta, b=b)
    return elementwise(_depth, a, theta=theta, b=b)


def force(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force.

    F = E_star*(a*b + (a - b)*(a + b)*atan(a/b))*tan(theta)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Length of the rounded tip, whose radius of curvature is b/tan(theta) [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: hyperboloid.F.

    References
    ----------
    chapter 11, equation (11.20); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import hyperboloid
    >>> value = hyperboloid.force(1.0, theta=0.42, b=0.4, E_star=1.0)
    >>> round(value, 6)
    0.625132
    """
    value = plain.force(a, theta, b, E_star)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    return elementwise(_force, a, theta=theta, b=b, E_star=E_star)


def pressure(r: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = E_star*(b*atan(sqrt(a**2 - r**2)/sqrt(b**2 + r**2))/sqrt(b**2 + r**2) - ArctanIntegral((a - sqrt(a**2
    - r**2))/(b + sqrt(b**2 + r**2))) + ArctanIntegral((a + sqrt(a**2 - r**2))/(b + sqrt(b**2 +
    r**2))))*tan(theta)/pi
    with ArctanIntegral: Ti_2(x) = int_0^x atan(t)/t dt = Im Li_2(i x)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Length of the rounded tip, whose radius of curvature is b/tan(theta) [m], b > 0.
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
    growing contact by a Gauss-Legendre rule. Handbook: hyperboloid.p.

    References
    ----------
    chapter 11, equation (11.23); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import hyperboloid
    >>> value = hyperboloid.pressure(0.3, 1.0, theta=0.42, b=0.4, E_star=1.0)
    >>> round(value, 6)
    0.353587
    """
    value = plain.pressure(r, a, theta, b, E_star)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    return elementwise(_pressure, r, a, theta=theta, b=b, E_star=E_star)


def displacement(r: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*(a*asin(a/r)*atan(a/b) + b*asin(a/r) + sqrt(-a**2 + r**2)*atan(a/b) - sqrt(b**2 +
    r**2)*atan(a*sqrt(b**2 + r**2)/(b*sqrt(-a**2 + r**2))))*tan(theta)/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Length of the rounded tip, whose radius of curvature is b/tan(theta) [m], b > 0.

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
    growing contact by a Gauss-Legendre rule. Handbook: hyperboloid.w.

    References
    ----------
    chapter 11, equation (11.26); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import hyperboloid
    >>> value = hyperboloid.displacement(2.0, 1.0, theta=0.42, b=0.4)
    >>> round(value, 6)
    0.101888
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
        Length of the rounded tip, whose radius of curvature is b/tan(theta) [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: hyperboloid.k.

    References
    ----------
    chapter 11, equation (11.18); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import hyperboloid
    >>> value = hyperboloid.stiffness(1.0, theta=0.42, b=0.4, E_star=1.0)
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

    p_mean = E_star*(b + (a - b)*(a + b)*atan(a/b)/a)*tan(theta)/(pi*a)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Length of the rounded tip, whose radius of curvature is b/tan(theta) [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: hyperboloid.pm.

    References
    ----------
    Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import hyperboloid
    >>> value = hyperboloid.mean_pressure(1.0, theta=0.42, b=0.4, E_star=1.0)
    >>> round(value, 6)
    0.198986
    """
    value = plain.mean_pressure(a, theta, b, E_star)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    return elementwise(_mean_pressure, a, theta=theta, b=b, E_star=E_star)


def radius_from_depth(d: ArrayLike, *, theta: ArrayLike, b: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a from a*tan(theta)*atan(a/b) = d

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Length of the rounded tip, whose radius of curvature is b/tan(theta) [m], b > 0.

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
    iteration. Handbook: hyperboloid.ad.

    References
    ----------
    chapter 11, equation (11.16); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import hyperboloid
    >>> value = hyperboloid.radius_from_depth(0.5315, theta=0.42, b=0.4)
    >>> round(value, 6)
    0.999926
    """
    value = plain.radius_from_depth(d, theta, b)
    if value is not None:
        return value
    require(theta=theta, b=b)
    return elementwise(_radius_from_depth, d, theta=theta, b=b)


def radius_from_force(F: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a from E_star*(a*b + (a - b)*(a + b)*atan(a/b))*tan(theta) = F

    Parameters
    ----------
    F : array_like
        Normal force [N].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Length of the rounded tip, whose radius of curvature is b/tan(theta) [m], b > 0.
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
    iteration. Handbook: hyperboloid.aF.

    References
    ----------
    chapter 11, equation (11.20); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import hyperboloid
    >>> value = hyperboloid.radius_from_force(0.6251, theta=0.42, b=0.4, E_star=1.0)
    >>> round(value, 6)
    0.999977
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
        Length of the rounded tip, whose radius of curvature is b/tan(theta) [m], b > 0.
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
    iteration. Handbook: hyperboloid.Fd.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import hyperboloid
    >>> value = hyperboloid.force_from_depth(0.5315, theta=0.42, b=0.4, E_star=1.0)
    >>> round(value, 6)
    0.62503
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
        Length of the rounded tip, whose radius of curvature is b/tan(theta) [m], b > 0.
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
    iteration. Handbook: hyperboloid.dF.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import hyperboloid
    >>> value = hyperboloid.depth_from_force(0.6251, theta=0.42, b=0.4, E_star=1.0)
    >>> round(value, 6)
    0.531535
    """
    value = plain.depth_from_force(F, theta, b, E_star)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    return elementwise(_depth_from_force, F, theta=theta, b=b, E_star=E_star)


def peak_pressure(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> PeakPressure:
    """Greatest pressure, and the radius of the ring on which it is.

    p_peak = E_star*(ArctanIntegral(a/b) + atan(a/b))*tan(theta)/pi
    with ArctanIntegral: Ti_2(x) = int_0^x atan(t)/t dt = Im Li_2(i x)
    r_peak = 0

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Length of the rounded tip, whose radius of curvature is b/tan(theta) [m], b > 0.
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
    growing contact by a Gauss-Legendre rule. Handbook: hyperboloid.rp, hyperboloid.pp.

    References
    ----------
    chapter 11, equation (11.23); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import hyperboloid
    >>> value = hyperboloid.peak_pressure(1.0, theta=0.42, b=0.4, E_star=1.0)
    >>> round(value.pressure, 6)
    0.429695
    """
    require(theta=theta, b=b, E_star=E_star)
    pressure = elementwise(_peak_pressure, a, theta=theta, b=b, E_star=E_star)
    radius = elementwise(_peak_radius, a, unused=(theta, b, E_star))
    return PeakPressure(pressure, radius)


def energy(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Elastic energy, the work of pressing the indenter in.

    U = E_star*Integral((a*tan(theta)*atan(a/b) - t*tan(theta)*atan(t/b))**2, (t, 0, a))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Length of the rounded tip, whose radius of curvature is b/tan(theta) [m], b > 0.
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
    growing contact by a Gauss-Legendre rule. Handbook: hyperboloid.U.

    References
    ----------
    Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import hyperboloid
    >>> value = hyperboloid.energy(1.0, theta=0.42, b=0.4, E_star=1.0)
    >>> round(value, 6)
    0.125007
    """
    value = plain.energy(a, theta, b, E_star)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    return elementwise(_energy, a, theta=theta, b=b, E_star=E_star)


def load_within(r: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Part of the normal force that is carried within the radius r; all of it beyond the contact.

    F_r = E_star*(a*b - a*sqrt(a**2 - r**2)*atan(a/b) - b*sqrt(a**2 - r**2) + b*sqrt(b**2 +
    r**2)*atan(sqrt(a**2 - r**2)/sqrt(b**2 + r**2)) - r**2*ArctanIntegral((a - sqrt(a**2 - r**2))/(b +
    sqrt(b**2 + r**2))) + r**2*ArctanIntegral((a + sqrt(a**2 - r**2))/(b + sqrt(b**2 + r**2))) + (a - b)*(a +
    b)*atan(a/b))*tan(theta)
    with ArctanIntegral: Ti_2(x) = int_0^x atan(t)/t dt = Im Li_2(i x)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Length of the rounded tip, whose radius of curvature is b/tan(theta) [m], b > 0.
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
    growing contact by a Gauss-Legendre rule. Handbook: hyperboloid.Fr.

    References
    ----------
    Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import hyperboloid
    >>> value = hyperboloid.load_within(0.3, 1.0, theta=0.42, b=0.4, E_star=1.0)
    >>> round(value, 6)
    0.10983
    """
    value = plain.load_within(r, a, theta, b, E_star)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    return elementwise(_load_within, r, a, theta=theta, b=b, E_star=E_star)


def _profile(r: Array, theta: Array, b: Array) -> Array:
    root = np.sqrt(r**2 + b**2)
    return np.tan(theta) * r**2 / (root + b)


def _slope(t: Array, theta: Array, b: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t)."""
    angle = np.arctan(t / b)
    return np.tan(theta) * angle + b * np.tan(theta) * t / (t**2 + b**2)


def _depth(a: Array, theta: Array, b: Array) -> Array:
    angle = np.arctan(a / b)
    return np.tan(theta) * a * angle


def _force(a: Array, theta: Array, b: Array, E_star: Array) -> Array:
    angle = np.arctan2(a, b)
    return E_star * np.tan(theta) * (a**2 * angle + b**2 * arctan_gap(a / b))


def _pressure(r: Array, a: Array, theta: Array, b: Array, E_star: Array) -> Array:
    within = pressure_integral_sinh(_slope, (theta, b), r, a, b)
    return np.where(r < a, E_star / np.pi * within, 0.0)


def _displacement(r: Array, a: Array, theta: Array, b: Array) -> Array:
    tip = displacement_integral_sinh(_slope, (theta, b), r, a, b)
    outside = 2 / np.pi * tip
    inside = _depth(a, theta, b) - _profile(r, theta, b)
    return np.where(r > a, outside, inside)


def _stiffness(a: Array, E_star: Array) -> Array:
    return 2 * E_star * a


def _mean_pressure(a: Array, theta: Array, b: Array, E_star: Array) -> Array:
    return np.where(a > 0.0, _force(a, theta, b, E_star) / (np.pi * a**2), 0.0)


def _peak_radius(a: Array) -> Array:
    return np.zeros_like(a)


def _peak_pressure(a: Array, theta: Array, b: Array, E_star: Array) -> Array:
    return _pressure(np.zeros_like(a), a, theta, b, E_star)


def _energy(a: Array, theta: Array, b: Array, E_star: Array) -> Array:
    sunk = _depth(a, theta, b)
    tip = energy_integral(_depth, (theta, b), a, sunk, b)
    return E_star * tip


def _load_within(r: Array, a: Array, theta: Array, b: Array, E_star: Array) -> Array:
    tip = load_within_integral(_slope, (theta, b), np.minimum(r, a), a)
    return _force(np.minimum(r, a), theta, b, E_star) + 2 * E_star * tip


def _radius_from_depth(d: Array, theta: Array, b: Array) -> Array:
    def curve(a: Array) -> tuple[Array, Array]:
        value = _depth(a, theta, b)
        return value, a * _slope(a, theta, b) / value

    return inverse(curve, d, b / 1000 * np.ones_like(d), (1.0, 2.0), smooth=True)


def _radius_from_force(F: Array, theta: Array, b: Array, E_star: Array) -> Array:
    def curve(a: Array) -> tuple[Array, Array]:
        value = _force(a, theta, b, E_star)
        return value, 2 * E_star * a**2 * _slope(a, theta, b) / value

    return inverse(curve, F, b / 1000 * np.ones_like(F), (2.0, 3.0), smooth=True)


def _force_from_depth(d: Array, theta: Array, b: Array, E_star: Array) -> Array:
    a = _radius_from_depth(d, theta, b)
    change = np.where((a > 0.0) & (a < np.inf), 2 * E_star * a * (d - _depth(a, theta, b)), 0.0)
    return _force(a, theta, b, E_star) + change


def _depth_from_force(F: Array, theta: Array, b: Array, E_star: Array) -> Array:
    a = _radius_from_force(F, theta, b, E_star)
    change = np.where((a > 0.0) & (a < np.inf), (F - _force(a, theta, b, E_star)) / (2 * E_star * a), 0.0)
    return _depth(a, theta, b) + change
