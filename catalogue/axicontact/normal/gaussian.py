"""Gaussian bump.

A smooth asperity of height h and width s; compact up to the radius of largest depth.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Plain, Result, elementwise, require
from .._runtime.inverse import between, inverse_below
from .._runtime.rules import displacement_integral, force_integral, pressure_integral
from .._runtime.shapes.energy import energy_integral
from .._runtime.shapes.load_within import load_within_integral
from .._runtime.special import PeakPressure, dawson

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


def profile(r: ArrayLike, *, h: ArrayLike, s: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = h*(1 - exp(-r**2/s**2))

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    h : array_like
        Height of the bump [m], h > 0.
    s : array_like
        Width of the bump, the radius at which its height is down to 37 per cent [m], s > 0.

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
    Valid for h << s. Negative or NaN field values give NaN. Handbook: gaussian.f, the definition of the
    profile.

    References
    ----------
    Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.normal import gaussian
    >>> value = gaussian.profile(0.3, h=0.7, s=1.0)
    >>> round(value, 6)
    0.060248
    """
    value = plain.profile(r, h, s)
    if value is not None:
        return value
    require(h=h, s=s)
    return elementwise(_profile, r, h=h, s=s)


def depth(a: ArrayLike, *, h: ArrayLike, s: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = 2*a*h*Dawson(a/s)/s
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Height of the bump [m], h > 0.
    s : array_like
        Width of the bump, the radius at which its height is down to 37 per cent [m], s > 0.

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
    Valid for h << s. Negative or NaN field values give NaN. The largest radius is 1.50198 s on the
    homogeneous half-space; graded it is where g' = 0, at 1.2286 s for k = -0.5 and at 1.8788 s for k = 0.5.
    Handbook: gaussian.d.

    References
    ----------
    chapter 11, equation (11.29); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.normal import gaussian
    >>> value = gaussian.depth(1.0, h=0.7, s=1.0)
    >>> round(value, 6)
    0.753311
    """
    value = plain.depth(a, h, s)
    if value is not None:
        return value
    require(h=h, s=s)
    return elementwise(_depth, a, h=h, s=s)


def force(a: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force.

    F = 2*E_star*h*(-a + (2*a**2 + s**2)*Dawson(a/s)/s)
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Height of the bump [m], h > 0.
    s : array_like
        Width of the bump, the radius at which its height is down to 37 per cent [m], s > 0.
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
    Valid for h << s. Negative or NaN field values give NaN. Evaluated as an integral over the growing contact
    by a Gauss-Legendre rule. The largest radius is 1.50198 s on the homogeneous half-space; graded it is
    where g' = 0, at 1.2286 s for k = -0.5 and at 1.8788 s for k = 0.5. Handbook: gaussian.F.

    References
    ----------
    chapter 11, equation (11.20); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.normal import gaussian
    >>> value = gaussian.force(1.0, h=0.7, s=1.0, E_star=1.0)
    >>> round(value, 6)
    0.859934
    """
    value = plain.force(a, h, s, E_star)
    if value is not None:
        return value
    require(h=h, s=s, E_star=E_star)
    return elementwise(_force, a, h=h, s=s, E_star=E_star)


def pressure(r: ArrayLike, a: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = E_star*Integral((2*h*Dawson(sqrt(r**2 + u**2)/s)/s + 2*h*(1 - 2*sqrt(r**2 + u**2)*Dawson(sqrt(r**2 +
    u**2)/s)/s)*sqrt(r**2 + u**2)/s**2)/sqrt(r**2 + u**2), (u, 0, sqrt(a**2 - r**2)))/pi
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    h : array_like
        Height of the bump [m], h > 0.
    s : array_like
        Width of the bump, the radius at which its height is down to 37 per cent [m], s > 0.
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
    Valid for h << s. Negative or NaN field values give NaN. Evaluated as an integral over the growing contact
    by a Gauss-Legendre rule. The largest radius is 1.50198 s on the homogeneous half-space; graded it is
    where g' = 0, at 1.2286 s for k = -0.5 and at 1.8788 s for k = 0.5. Handbook: gaussian.p.

    References
    ----------
    chapter 11, equation (11.23); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.normal import gaussian
    >>> value = gaussian.pressure(0.3, 1.0, h=0.7, s=1.0, E_star=1.0)
    >>> round(value, 6)
    0.525588
    """
    value = plain.pressure(r, a, h, s, E_star)
    if value is not None:
        return value
    require(h=h, s=s, E_star=E_star)
    return elementwise(_pressure, r, a, h=h, s=s, E_star=E_star)


def displacement(r: ArrayLike, a: ArrayLike, *, h: ArrayLike, s: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*Integral(psi*r*(2*h*r*(-2*r*sin(psi)*Dawson(r*sin(psi)/s)/s + 1)*sin(psi)/s**2 +
    2*h*Dawson(r*sin(psi)/s)/s)*cos(psi), (psi, 0, asin(a/r)))/pi
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    h : array_like
        Height of the bump [m], h > 0.
    s : array_like
        Width of the bump, the radius at which its height is down to 37 per cent [m], s > 0.

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
    Valid for h << s. Negative or NaN field values give NaN. Evaluated as an integral over the growing contact
    by a Gauss-Legendre rule. Handbook: gaussian.w.

    References
    ----------
    chapter 11, equation (11.26); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.normal import gaussian
    >>> value = gaussian.displacement(2.0, 1.0, h=0.7, s=1.0)
    >>> round(value, 6)
    0.13992
    """
    value = plain.displacement(r, a, h, s)
    if value is not None:
        return value
    require(h=h, s=s)
    return elementwise(_displacement, r, a, h=h, s=s)


def stiffness(a: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*E_star*a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Height of the bump [m], h > 0.
    s : array_like
        Width of the bump, the radius at which its height is down to 37 per cent [m], s > 0.
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
    Valid for h << s. Negative or NaN field values give NaN. Handbook: gaussian.k.

    References
    ----------
    chapter 11, equation (11.18); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.normal import gaussian
    >>> value = gaussian.stiffness(1.0, h=0.7, s=1.0, E_star=1.0)
    >>> round(value, 6)
    2.0
    """
    value = plain.stiffness(a, s, E_star, h)
    if value is not None:
        return value
    require(h=h, s=s, E_star=E_star)
    return elementwise(_stiffness, a, s=s, E_star=E_star, unused=(h,))


def mean_pressure(a: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = 2*E_star*h*(-1 + (2*a**2 + s**2)*Dawson(a/s)/(a*s))/(pi*a)
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Height of the bump [m], h > 0.
    s : array_like
        Width of the bump, the radius at which its height is down to 37 per cent [m], s > 0.
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
    Valid for h << s. Negative or NaN field values give NaN. Evaluated as an integral over the growing contact
    by a Gauss-Legendre rule. Handbook: gaussian.pm.

    References
    ----------
    Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.normal import gaussian
    >>> value = gaussian.mean_pressure(1.0, h=0.7, s=1.0, E_star=1.0)
    >>> round(value, 6)
    0.273725
    """
    value = plain.mean_pressure(a, h, s, E_star)
    if value is not None:
        return value
    require(h=h, s=s, E_star=E_star)
    return elementwise(_mean_pressure, a, h=h, s=s, E_star=E_star)


def radius_from_depth(d: ArrayLike, *, h: ArrayLike, s: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a from 2*a*h*Dawson(a/s)/s = d
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    h : array_like
        Height of the bump [m], h > 0.
    s : array_like
        Width of the bump, the radius at which its height is down to 37 per cent [m], s > 0.

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
    Valid for h << s. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton iteration.
    Handbook: gaussian.ad.

    References
    ----------
    chapter 11, equation (11.16); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.normal import gaussian
    >>> value = gaussian.radius_from_depth(0.7533, h=0.7, s=1.0)
    >>> round(value, 6)
    0.999983
    """
    value = plain.radius_from_depth(d, h, s)
    if value is not None:
        return value
    require(h=h, s=s)
    return elementwise(_radius_from_depth, d, h=h, s=s)


def radius_from_force(F: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a from 2*E_star*h*(-a + (2*a**2 + s**2)*Dawson(a/s)/s) = F
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    F : array_like
        Normal force [N].
    h : array_like
        Height of the bump [m], h > 0.
    s : array_like
        Width of the bump, the radius at which its height is down to 37 per cent [m], s > 0.
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
    Valid for h << s. Negative or NaN field values give NaN. Evaluated as an integral over the growing contact
    by a Gauss-Legendre rule. Evaluated by a safeguarded Newton iteration. Handbook: gaussian.aF.

    References
    ----------
    chapter 11, equation (11.20); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.normal import gaussian
    >>> value = gaussian.radius_from_force(0.8599, h=0.7, s=1.0, E_star=1.0)
    >>> round(value, 6)
    0.999974
    """
    value = plain.radius_from_force(F, h, s, E_star)
    if value is not None:
        return value
    require(h=h, s=s, E_star=E_star)
    return elementwise(_radius_from_force, F, h=h, s=s, E_star=E_star)


def force_from_depth(d: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = F(a(d)), through the contact radius.

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    h : array_like
        Height of the bump [m], h > 0.
    s : array_like
        Width of the bump, the radius at which its height is down to 37 per cent [m], s > 0.
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
    Valid for h << s. Negative or NaN field values give NaN. Evaluated as an integral over the growing contact
    by a Gauss-Legendre rule. Evaluated by a safeguarded Newton iteration. Handbook: gaussian.Fd.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.normal import gaussian
    >>> value = gaussian.force_from_depth(0.7533, h=0.7, s=1.0, E_star=1.0)
    >>> round(value, 6)
    0.859911
    """
    value = plain.force_from_depth(d, h, s, E_star)
    if value is not None:
        return value
    require(h=h, s=s, E_star=E_star)
    return elementwise(_force_from_depth, d, h=h, s=s, E_star=E_star)


def depth_from_force(F: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = d(a(F)), through the contact radius.

    Parameters
    ----------
    F : array_like
        Normal force [N].
    h : array_like
        Height of the bump [m], h > 0.
    s : array_like
        Width of the bump, the radius at which its height is down to 37 per cent [m], s > 0.
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
    Valid for h << s. Negative or NaN field values give NaN. Evaluated as an integral over the growing contact
    by a Gauss-Legendre rule. Evaluated by a safeguarded Newton iteration. Handbook: gaussian.dF.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.normal import gaussian
    >>> value = gaussian.depth_from_force(0.8599, h=0.7, s=1.0, E_star=1.0)
    >>> round(value, 6)
    0.753294
    """
    value = plain.depth_from_force(F, h, s, E_star)
    if value is not None:
        return value
    require(h=h, s=s, E_star=E_star)
    return elementwise(_depth_from_force, F, h=h, s=s, E_star=E_star)


def peak_pressure(a: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike) -> PeakPressure:
    """Greatest pressure, and the radius of the ring on which it is.

    p_peak = E_star*Integral((2*h*Dawson(u/s)/s + 2*h*u*(1 - 2*u*Dawson(u/s)/s)/s**2)/u, (u, 0, a))/pi
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D
    r_peak = 0

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Height of the bump [m], h > 0.
    s : array_like
        Width of the bump, the radius at which its height is down to 37 per cent [m], s > 0.
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
    Valid for h << s. Negative or NaN field values give NaN. Evaluated as an integral over the growing contact
    by a Gauss-Legendre rule. Handbook: gaussian.rp, gaussian.pp.

    References
    ----------
    chapter 11, equation (11.23); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.normal import gaussian
    >>> value = gaussian.peak_pressure(1.0, h=0.7, s=1.0, E_star=1.0)
    >>> round(value.pressure, 6)
    0.606035
    """
    require(h=h, s=s, E_star=E_star)
    pressure = elementwise(_peak_pressure, a, h=h, s=s, E_star=E_star)
    radius = elementwise(_peak_radius, a, s=s, unused=(h, E_star))
    return PeakPressure(pressure, radius)


def energy(a: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike) -> Result:
    """Elastic energy, the work of pressing the indenter in.

    U = E_star*Integral((2*a*h*Dawson(a/s)/s - 2*h*t*Dawson(t/s)/s)**2, (t, 0, a))
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Height of the bump [m], h > 0.
    s : array_like
        Width of the bump, the radius at which its height is down to 37 per cent [m], s > 0.
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
    Valid for h << s. Negative or NaN field values give NaN. Evaluated as an integral over the growing contact
    by a Gauss-Legendre rule. Handbook: gaussian.U.

    References
    ----------
    Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.normal import gaussian
    >>> value = gaussian.energy(1.0, h=0.7, s=1.0, E_star=1.0)
    >>> round(value, 6)
    0.245365
    """
    value = plain.energy(a, h, s, E_star)
    if value is not None:
        return value
    require(h=h, s=s, E_star=E_star)
    return elementwise(_energy, a, h=h, s=s, E_star=E_star)


def load_within(r: ArrayLike, a: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike) -> Result:
    """Part of the normal force that is carried within the radius r; all of it beyond the contact.

    F_r = 2*E_star*h*(-r + (2*r**2 + s**2)*Dawson(r/s)/s) + 2*E_star*r**2*Integral(u*(2*h*Dawson(sqrt(r**2 +
    u**2)/s)/s + 2*h*(1 - 2*sqrt(r**2 + u**2)*Dawson(sqrt(r**2 + u**2)/s)/s)*sqrt(r**2 +
    u**2)/s**2)/(sqrt(r**2 + u**2)*(u + sqrt(r**2 + u**2))), (u, 0, sqrt(a**2 - r**2)))
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    h : array_like
        Height of the bump [m], h > 0.
    s : array_like
        Width of the bump, the radius at which its height is down to 37 per cent [m], s > 0.
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
    Valid for h << s. Negative or NaN field values give NaN. Evaluated as an integral over the growing contact
    by a Gauss-Legendre rule. Handbook: gaussian.Fr.

    References
    ----------
    Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.normal import gaussian
    >>> value = gaussian.load_within(0.3, 1.0, h=0.7, s=1.0, E_star=1.0)
    >>> round(value, 6)
    0.159773
    """
    value = plain.load_within(r, a, h, s, E_star)
    if value is not None:
        return value
    require(h=h, s=s, E_star=E_star)
    return elementwise(_load_within, r, a, h=h, s=s, E_star=E_star)


def _profile(r: Array, h: Array, s: Array) -> Array:
    return -h * np.expm1(-(r**2) / s**2)


def _slope(t: Array, h: Array, s: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t)."""
    z = t / s
    return 2 * h / s * (dawson(z) + (1 - 2 * dawson(z) * z) * z)


def _depth(a: Array, h: Array, s: Array) -> Array:
    z = a / s
    return np.where(a <= 1.5019752682686114 * s, 2 * h * dawson(z) * z, np.nan)


def _force(a: Array, h: Array, s: Array, E_star: Array) -> Array:
    tip = 2 * E_star * force_integral(lambda t: _slope(t, h, s), a, 32)
    return np.where(a <= 1.5019752682686114 * s, tip, np.nan)


def _pressure(r: Array, a: Array, h: Array, s: Array, E_star: Array) -> Array:
    within = pressure_integral(lambda t: _slope(t, h, s), r, a, 32)
    inside = np.where(r < a, E_star / np.pi * within, 0.0)
    return np.where(a <= 1.5019752682686114 * s, inside, np.nan)


def _displacement(r: Array, a: Array, h: Array, s: Array) -> Array:
    tip = displacement_integral(_slope, (h, s), r, a, 32)
    outside = 2 / np.pi * tip
    inside = _depth(a, h, s) - _profile(r, h, s)
    return np.where(a <= 1.5019752682686114 * s, np.where(r > a, outside, inside), np.nan)


def _stiffness(a: Array, s: Array, E_star: Array) -> Array:
    return np.where(a <= 1.5019752682686114 * s, 2 * E_star * a, np.nan)


def _mean_pressure(a: Array, h: Array, s: Array, E_star: Array) -> Array:
    return np.where(a > 0.0, _force(a, h, s, E_star) / (np.pi * a**2), 0.0)


def _peak_radius(a: Array, s: Array) -> Array:
    return np.where(a <= 1.5019752682686114 * s, 0.0, np.nan)


def _peak_pressure(a: Array, h: Array, s: Array, E_star: Array) -> Array:
    return _pressure(np.zeros_like(a), a, h, s, E_star)


def _energy(a: Array, h: Array, s: Array, E_star: Array) -> Array:
    sunk = _depth(a, h, s)
    tip = energy_integral(_depth, (h, s), a, sunk, a)
    return np.where(a <= 1.5019752682686114 * s, E_star * tip, np.nan)


def _load_within(r: Array, a: Array, h: Array, s: Array, E_star: Array) -> Array:
    tip = load_within_integral(_slope, (h, s), np.minimum(r, a), a)
    return np.where(a <= 1.5019752682686114 * s, _force(np.minimum(r, a), h, s, E_star) + 2 * E_star * tip, np.nan)


def _radius_from_depth(d: Array, h: Array, s: Array) -> Array:
    def curve(a: Array) -> tuple[Array, Array]:
        value = _depth(a, h, s)
        return value, a * _slope(a, h, s) / value

    def like(short: Array) -> Array:
        rest = (1.003776, 0.2435676, 0.7000671, -0.6766533, 4.031949, -6.599278, 3.971419, -0.793611)
        return between(np.log(short / 0.6348098), (1.575, 2.0), (0.4486, 2.0), -6.0, rest)

    largest = 1.5019752682686114 * s * np.ones_like(d)
    return inverse_below(curve, d, largest, (1.0, 2.0), like)


def _radius_from_force(F: Array, h: Array, s: Array, E_star: Array) -> Array:
    def curve(a: Array) -> tuple[Array, Array]:
        value = _force(a, h, s, E_star)
        return value, 2 * E_star * a**2 * _slope(a, h, s) / value

    def like(short: Array) -> Array:
        rest = (0.9994039, 0.6765872, -1.514105, 16.18697, -61.13223, 108.1267, -95.20743, 32.86326)
        return between(np.log(short / 1.360193), (1.659, 2.0), (0.1392, 3.0), -6.0, rest)

    largest = 1.5019752682686114 * s * np.ones_like(F)
    return inverse_below(curve, F, largest, (1.0, 3.0), like)


def _force_from_depth(d: Array, h: Array, s: Array, E_star: Array) -> Array:
    a = _radius_from_depth(d, h, s)
    change = np.where((a > 0.0) & (a < np.inf), 2 * E_star * a * (d - _depth(a, h, s)), 0.0)
    return _force(a, h, s, E_star) + change


def _depth_from_force(F: Array, h: Array, s: Array, E_star: Array) -> Array:
    a = _radius_from_force(F, h, s, E_star)
    change = np.where((a > 0.0) & (a < np.inf), (F - _force(a, h, s, E_star)) / (2 * E_star * a), 0.0)
    return _depth(a, h, s) + change
