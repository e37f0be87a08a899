"""Ellipsoid of revolution.

Semi-axis h along the axis, b across: the sphere stretched by h/b.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Plain, Result, elementwise, require
from .._runtime.inverse import between, inverse
from .._runtime.rules import displacement_integral_tanh
from .._runtime.shapes.arcs import arc_peak_pressure, arc_peak_radius, arc_strips
from .._runtime.shapes.energy import energy_integral_tanh
from .._runtime.shapes.load_within import load_within_integral_tanh
from .._runtime.special import PeakPressure, tanh_gap

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


def profile(r: ArrayLike, *, h: ArrayLike, b: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = h*(1 - sqrt(1 - r**2/b**2))

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    h : array_like
        Semi-axis along the axis of revolution [m], h > 0.
    b : array_like
        Semi-axis across, the largest radius of the body [m], b > 0.

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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Handbook: ellipsoid.f, the
    definition of the profile.

    References
    ----------
    Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import ellipsoid
    >>> value = ellipsoid.profile(0.3, h=0.9, b=1.5)
    >>> round(value, 6)
    0.018184
    """
    value = plain.profile(r, h, b)
    if value is not None:
        return value
    require(h=h, b=b)
    return elementwise(_profile, r, h=h, b=b)


def depth(a: ArrayLike, *, h: ArrayLike, b: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = a*h*atanh(a/b)/b

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Semi-axis along the axis of revolution [m], h > 0.
    b : array_like
        Semi-axis across, the largest radius of the body [m], b > 0.

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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Handbook: ellipsoid.d.

    References
    ----------
    chapter 11, equation (11.29); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import ellipsoid
    >>> value = ellipsoid.depth(1.0, h=0.9, b=1.5)
    >>> round(value, 6)
    0.482831
    """
    value = plain.depth(a, h, b)
    if value is not None:
        return value
    require(h=h, b=b)
    return elementwise(_depth, a, h=h, b=b)


def force(a: ArrayLike, *, h: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force.

    F = E_star*h*(-a + (a**2 + b**2)*atanh(a/b)/b)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Semi-axis along the axis of revolution [m], h > 0.
    b : array_like
        Semi-axis across, the largest radius of the body [m], b > 0.
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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Handbook: ellipsoid.F.

    References
    ----------
    chapter 11, equation (11.20); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import ellipsoid
    >>> value = ellipsoid.force(1.0, h=0.9, b=1.5, E_star=1.0)
    >>> round(value, 6)
    0.669202
    """
    value = plain.force(a, h, b, E_star)
    if value is not None:
        return value
    require(h=h, b=b, E_star=E_star)
    return elementwise(_force, a, h=h, b=b, E_star=E_star)


def pressure(r: ArrayLike, a: ArrayLike, *, h: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = E_star*h*(atanh(sqrt(a**2 - r**2)/sqrt(b**2 - r**2))/sqrt(b**2 - r**2) - LegendreChi2((a - sqrt(a**2 -
    r**2))/(b + sqrt(b**2 - r**2)))/b + LegendreChi2((a + sqrt(a**2 - r**2))/(b + sqrt(b**2 - r**2)))/b)/pi
    with LegendreChi2: chi_2(x) = int_0^x atanh(t)/t dt = (Li_2(x) - Li_2(-x))/2, for 0 <= x < 1

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    h : array_like
        Semi-axis along the axis of revolution [m], h > 0.
    b : array_like
        Semi-axis across, the largest radius of the body [m], b > 0.
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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Handbook: ellipsoid.p.

    References
    ----------
    chapter 11, equation (11.23); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import ellipsoid
    >>> value = ellipsoid.pressure(0.3, 1.0, h=0.9, b=1.5, E_star=1.0)
    >>> round(value, 6)
    0.280783
    """
    value = plain.pressure(r, a, h, b, E_star)
    if value is not None:
        return value
    require(h=h, b=b, E_star=E_star)
    return elementwise(_pressure, r, a, h=h, b=b, E_star=E_star)


def displacement(r: ArrayLike, a: ArrayLike, *, h: ArrayLike, b: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*h*(a*asin(a/r)*atanh(a/b)/b - asin(a/r) + sqrt(-a**2 + r**2)*atanh(a/b)/b + sqrt(b**2 -
    r**2)*atan(a*sqrt(b**2 - r**2)/(b*sqrt(-a**2 + r**2)))/b)/pi   for r < b
    w = 2*h*(a*asin(a/r)*atanh(a/b)/b - asin(a/r) + sqrt(-a**2 + r**2)*atanh(a/b)/b - sqrt(-b**2 +
    r**2)*atanh(a*sqrt(-b**2 + r**2)/(b*sqrt(-a**2 + r**2)))/b)/pi   for b < r

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    h : array_like
        Semi-axis along the axis of revolution [m], h > 0.
    b : array_like
        Semi-axis across, the largest radius of the body [m], b > 0.

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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact by a Gauss-Legendre rule. Handbook: ellipsoid.w.

    References
    ----------
    chapter 11, equation (11.26); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import ellipsoid
    >>> value = ellipsoid.displacement(2.0, 1.0, h=0.9, b=1.5)
    >>> round(value, 6)
    0.109557
    """
    value = plain.displacement(r, a, h, b)
    if value is not None:
        return value
    require(h=h, b=b)
    return elementwise(_displacement, r, a, h=h, b=b)


def stiffness(a: ArrayLike, *, h: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*E_star*a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Semi-axis along the axis of revolution [m], h > 0.
    b : array_like
        Semi-axis across, the largest radius of the body [m], b > 0.
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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Handbook: ellipsoid.k.

    References
    ----------
    chapter 11, equation (11.18); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import ellipsoid
    >>> value = ellipsoid.stiffness(1.0, h=0.9, b=1.5, E_star=1.0)
    >>> round(value, 6)
    2.0
    """
    value = plain.stiffness(a, E_star, h, b)
    if value is not None:
        return value
    require(h=h, b=b, E_star=E_star)
    return elementwise(_stiffness, a, E_star=E_star, unused=(h, b))


def mean_pressure(a: ArrayLike, *, h: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = E_star*h*(-1 + (a**2 + b**2)*atanh(a/b)/(a*b))/(pi*a)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Semi-axis along the axis of revolution [m], h > 0.
    b : array_like
        Semi-axis across, the largest radius of the body [m], b > 0.
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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Handbook: ellipsoid.pm.

    References
    ----------
    Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import ellipsoid
    >>> value = ellipsoid.mean_pressure(1.0, h=0.9, b=1.5, E_star=1.0)
    >>> round(value, 6)
    0.213014
    """
    value = plain.mean_pressure(a, h, b, E_star)
    if value is not None:
        return value
    require(h=h, b=b, E_star=E_star)
    return elementwise(_mean_pressure, a, h=h, b=b, E_star=E_star)


def radius_from_depth(d: ArrayLike, *, h: ArrayLike, b: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a from a*h*atanh(a/b)/b = d

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    h : array_like
        Semi-axis along the axis of revolution [m], h > 0.
    b : array_like
        Semi-axis across, the largest radius of the body [m], b > 0.

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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: ellipsoid.ad.

    References
    ----------
    chapter 11, equation (11.16); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import ellipsoid
    >>> value = ellipsoid.radius_from_depth(0.4828, h=0.9, b=1.5)
    >>> round(value, 6)
    0.999974
    """
    value = plain.radius_from_depth(d, h, b)
    if value is not None:
        return value
    require(h=h, b=b)
    return elementwise(_radius_from_depth, d, h=h, b=b)


def radius_from_force(F: ArrayLike, *, h: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a from E_star*h*(-a + (a**2 + b**2)*atanh(a/b)/b) = F

    Parameters
    ----------
    F : array_like
        Normal force [N].
    h : array_like
        Semi-axis along the axis of revolution [m], h > 0.
    b : array_like
        Semi-axis across, the largest radius of the body [m], b > 0.
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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: ellipsoid.aF.

    References
    ----------
    chapter 11, equation (11.20); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import ellipsoid
    >>> value = ellipsoid.radius_from_force(0.6692, h=0.9, b=1.5, E_star=1.0)
    >>> round(value, 6)
    0.999999
    """
    value = plain.radius_from_force(F, h, b, E_star)
    if value is not None:
        return value
    require(h=h, b=b, E_star=E_star)
    return elementwise(_radius_from_force, F, h=h, b=b, E_star=E_star)


def force_from_depth(d: ArrayLike, *, h: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = F(a(d)), through the contact radius.

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    h : array_like
        Semi-axis along the axis of revolution [m], h > 0.
    b : array_like
        Semi-axis across, the largest radius of the body [m], b > 0.
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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: ellipsoid.Fd.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import ellipsoid
    >>> value = ellipsoid.force_from_depth(0.4828, h=0.9, b=1.5, E_star=1.0)
    >>> round(value, 6)
    0.669139
    """
    value = plain.force_from_depth(d, h, b, E_star)
    if value is not None:
        return value
    require(h=h, b=b, E_star=E_star)
    return elementwise(_force_from_depth, d, h=h, b=b, E_star=E_star)


def depth_from_force(F: ArrayLike, *, h: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = d(a(F)), through the contact radius.

    Parameters
    ----------
    F : array_like
        Normal force [N].
    h : array_like
        Semi-axis along the axis of revolution [m], h > 0.
    b : array_like
        Semi-axis across, the largest radius of the body [m], b > 0.
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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: ellipsoid.dF.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import ellipsoid
    >>> value = ellipsoid.depth_from_force(0.6692, h=0.9, b=1.5, E_star=1.0)
    >>> round(value, 6)
    0.48283
    """
    value = plain.depth_from_force(F, h, b, E_star)
    if value is not None:
        return value
    require(h=h, b=b, E_star=E_star)
    return elementwise(_depth_from_force, F, h=h, b=b, E_star=E_star)


def peak_pressure(a: ArrayLike, *, h: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> PeakPressure:
    """Greatest pressure, and the radius of the ring on which it is.

    p_peak = E_star*h*(atanh(sqrt(a**2 - r_peak**2)/sqrt(b**2 - r_peak**2))/sqrt(b**2 - r_peak**2) -
    LegendreChi2((a - sqrt(a**2 - r_peak**2))/(b + sqrt(b**2 - r_peak**2)))/b + LegendreChi2((a + sqrt(a**2 -
    r_peak**2))/(b + sqrt(b**2 - r_peak**2)))/b)/pi
    with LegendreChi2: chi_2(x) = int_0^x atanh(t)/t dt = (Li_2(x) - Li_2(-x))/2, for 0 <= x < 1
    r_peak = 0   for (a/b - b/(3*a))*atanh(a/b) < 1
    r_peak from -a*atanh(a/b)/b + 1 = (-sqrt(a**2 - r_peak**2)*atanh(sqrt(a**2 - r_peak**2)/sqrt(b**2 -
    r_peak**2))/sqrt(b**2 - r_peak**2) + 1)/(1 - r_peak**2/b**2)   for 1 < (a/b - b/(3*a))*atanh(a/b)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Semi-axis along the axis of revolution [m], h > 0.
    b : array_like
        Semi-axis across, the largest radius of the body [m], b > 0.
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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Handbook: ellipsoid.rp,
    ellipsoid.pp.

    References
    ----------
    chapter 11, equation (11.23); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import ellipsoid
    >>> value = ellipsoid.peak_pressure(1.0, h=0.9, b=1.5, E_star=1.0)
    >>> round(value.pressure, 6)
    0.288624
    """
    require(h=h, b=b, E_star=E_star)
    pressure = elementwise(_peak_pressure, a, h=h, b=b, E_star=E_star)
    radius = elementwise(_peak_radius, a, b=b, unused=(h, E_star))
    return PeakPressure(pressure, radius)


def energy(a: ArrayLike, *, h: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Elastic energy, the work of pressing the indenter in.

    U = E_star*Integral((a*h*atanh(a/b)/b - h*t*atanh(t/b)/b)**2, (t, 0, a))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Semi-axis along the axis of revolution [m], h > 0.
    b : array_like
        Semi-axis across, the largest radius of the body [m], b > 0.
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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact by a Gauss-Legendre rule. Handbook: ellipsoid.U.

    References
    ----------
    Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import ellipsoid
    >>> value = ellipsoid.energy(1.0, h=0.9, b=1.5, E_star=1.0)
    >>> round(value, 6)
    0.131349
    """
    value = plain.energy(a, h, b, E_star)
    if value is not None:
        return value
    require(h=h, b=b, E_star=E_star)
    return elementwise(_energy, a, h=h, b=b, E_star=E_star)


def load_within(r: ArrayLike, a: ArrayLike, *, h: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Part of the normal force that is carried within the radius r; all of it beyond the contact.

    F_r = E_star*h*(-a - a*sqrt(a**2 - r**2)*atanh(a/b)/b + sqrt(a**2 - r**2) - sqrt(b**2 -
    r**2)*atanh(sqrt(a**2 - r**2)/sqrt(b**2 - r**2)) - r**2*LegendreChi2((a - sqrt(a**2 - r**2))/(b +
    sqrt(b**2 - r**2)))/b + r**2*LegendreChi2((a + sqrt(a**2 - r**2))/(b + sqrt(b**2 - r**2)))/b + (a**2 +
    b**2)*atanh(a/b)/b)
    with LegendreChi2: chi_2(x) = int_0^x atanh(t)/t dt = (Li_2(x) - Li_2(-x))/2, for 0 <= x < 1

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    h : array_like
        Semi-axis along the axis of revolution [m], h > 0.
    b : array_like
        Semi-axis across, the largest radius of the body [m], b > 0.
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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact by a Gauss-Legendre rule. Handbook: ellipsoid.Fr.

    References
    ----------
    Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import ellipsoid
    >>> value = ellipsoid.load_within(0.3, 1.0, h=0.9, b=1.5, E_star=1.0)
    >>> round(value, 6)
    0.080517
    """
    value = plain.load_within(r, a, h, b, E_star)
    if value is not None:
        return value
    require(h=h, b=b, E_star=E_star)
    return elementwise(_load_within, r, a, h=h, b=b, E_star=E_star)


def _profile(r: Array, h: Array, b: Array) -> Array:
    root_0 = np.sqrt((1 - r / b) * (r / b + 1))
    return h * r**2 / (b**2 * (root_0 + 1))


def _slope(t: Array, root: Array, h: Array, b: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t)."""
    angle = np.arcsinh(t / root)
    return h / b * angle + h * t / root**2


def _depth_at(a: Array, root: Array, h: Array, b: Array) -> Array:
    angle = np.arcsinh(a / root)
    return h / b * a * angle


def _depth(a: Array, h: Array, b: Array) -> Array:
    angle = np.log1p(2 * a / (b - a)) / 2
    return h / b * a * angle


def _force_at(a: Array, root: Array, h: Array, b: Array, E_star: Array) -> Array:
    angle = np.arcsinh(a / root)
    return E_star * h * (b * tanh_gap(angle, np.tanh(angle)) + a**2 * angle / b)


def _force(a: Array, h: Array, b: Array, E_star: Array) -> Array:
    angle = np.log1p(2 * a / (b - a)) / 2
    return E_star * h * (a**2 * angle / b + b * tanh_gap(angle, a / b))


def _pressure(r: Array, a: Array, h: Array, b: Array, E_star: Array) -> Array:
    root_br = np.sqrt((b - r) * (r + b))
    root = np.sqrt((a - r) * (a + r))
    root_ba = np.sqrt((b - a) * (a + b))
    pressed = E_star * h / np.pi * (np.arcsinh(root / root_ba) / root_br + arc_strips(r, a, b) / b)
    inside = np.where(r < a, pressed, 0.0)
    return np.where(a <= b, inside, np.nan)


def _displacement(r: Array, a: Array, h: Array, b: Array) -> Array:
    tip = displacement_integral_tanh(_slope, (h, b), r, a, b)
    outside = 2 / np.pi * tip
    inside = _depth(a, h, b) - _profile(r, h, b)
    return np.where(a <= b, np.where(r > a, outside, inside), np.nan)


def _stiffness(a: Array, E_star: Array) -> Array:
    return 2 * E_star * a


def _mean_pressure(a: Array, h: Array, b: Array, E_star: Array) -> Array:
    return np.where(a > 0.0, _force(a, h, b, E_star) / (np.pi * a**2), 0.0)


def _peak_radius(a: Array, b: Array) -> Array:
    return np.where(a <= b, arc_peak_radius(a, b), np.nan)


def _peak_pressure(a: Array, h: Array, b: Array, E_star: Array) -> Array:
    return np.where(a <= b, E_star * h / (np.pi * b) * arc_peak_pressure(a, b), np.nan)


def _energy(a: Array, h: Array, b: Array, E_star: Array) -> Array:
    sunk = _depth(a, h, b)
    tip = energy_integral_tanh(_depth_at, (h, b), a, sunk, b)
    return np.where(a <= b, E_star * tip, np.nan)


def _load_within(r: Array, a: Array, h: Array, b: Array, E_star: Array) -> Array:
    tip = load_within_integral_tanh(_slope, (h, b), np.minimum(r, a), a, b)
    return np.where(a <= b, _force(np.minimum(r, a), h, b, E_star) + 2 * E_star * tip, np.nan)


def _contact_from_depth(d: Array, h: Array, b: Array) -> tuple[Array, Array]:
    """Contact radius a and its root sqrt(b**2 - a**2)."""

    def curve(t: Array) -> tuple[Array, Array]:
        a, root = b * np.tanh(t), b / np.cosh(t)
        value = _depth_at(a, root, h, b)
        return value, t * root * root / b * _slope(a, root, h, b) / value

    rest = (0.9983865, 0.208363, -4.0282, 30.18372, -93.92268, 137.5431, -95.06062, 25.07439)
    start = between(np.log(d / curve(1.0)[0]), (1.313, 2.0), (1.313, 1.0), 3.75, rest)
    t = inverse(curve, d, start, (1.0, 2.0), smooth=True)
    return b * np.tanh(t), b / np.cosh(t)


def _radius_from_depth(d: Array, h: Array, b: Array) -> Array:
    return _contact_from_depth(d, h, b)[0]


def _contact_from_force(F: Array, h: Array, b: Array, E_star: Array) -> tuple[Array, Array]:
    """Contact radius a and its root sqrt(b**2 - a**2)."""

    def curve(t: Array) -> tuple[Array, Array]:
        a, root = b * np.tanh(t), b / np.cosh(t)
        value = _force_at(a, root, h, b, E_star)
        return value, 2 * E_star * a * t * root * root / b * _slope(a, root, h, b) / value

    rest = (0.998775, 0.1558039, -2.915358, 22.20415, -66.84601, 91.96521, -58.34092, 13.75711)
    start = between(np.log(F / curve(1.0)[0]), (1.629, 3.0), (2.405, 1.0), 1.75, rest)
    t = inverse(curve, F, start, (1.0, 3.0), smooth=True)
    return b * np.tanh(t), b / np.cosh(t)


def _radius_from_force(F: Array, h: Array, b: Array, E_star: Array) -> Array:
    return _contact_from_force(F, h, b, E_star)[0]


def _force_from_depth(d: Array, h: Array, b: Array, E_star: Array) -> Array:
    a, root = _contact_from_depth(d, h, b)
    change = np.where((a > 0.0) & (a < np.inf), 2 * E_star * a * (d - _depth_at(a, root, h, b)), 0.0)
    return _force_at(a, root, h, b, E_star) + change


def _depth_from_force(F: Array, h: Array, b: Array, E_star: Array) -> Array:
    a, root = _contact_from_force(F, h, b, E_star)
    change = np.where((a > 0.0) & (a < np.inf), (F - _force_at(a, root, h, b, E_star)) / (2 * E_star * a), 0.0)
    return _depth_at(a, root, h, b) + change
