"""Sphere.

The exact spherical shape; differs from the paraboloid by terms of order a^2/R^2.
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


def profile(r: ArrayLike, *, R: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = R - sqrt(R**2 - r**2)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    R : array_like
        Radius of curvature [m], R > 0.

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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Handbook: sphere.f, the definition of the profile.

    References
    ----------
    Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import sphere
    >>> value = sphere.profile(0.3, R=1.5)
    >>> round(value, 6)
    0.030306
    """
    value = plain.profile(r, R)
    if value is not None:
        return value
    require(R=R)
    return elementwise(_profile, r, R=R)


def depth(a: ArrayLike, *, R: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = a*atanh(a/R)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.

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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Handbook: sphere.d.

    References
    ----------
    chapter 11, equation (11.29); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import sphere
    >>> value = sphere.depth(1.0, R=1.5)
    >>> round(value, 6)
    0.804719
    """
    value = plain.depth(a, R)
    if value is not None:
        return value
    require(R=R)
    return elementwise(_depth, a, R=R)


def force(a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force.

    F = E_star*(-R*a + (R**2 + a**2)*atanh(a/R))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Handbook: sphere.F.

    References
    ----------
    chapter 11, equation (11.20); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import sphere
    >>> value = sphere.force(1.0, R=1.5, E_star=1.0)
    >>> round(value, 6)
    1.115337
    """
    value = plain.force(a, R, E_star)
    if value is not None:
        return value
    require(R=R, E_star=E_star)
    return elementwise(_force, a, R=R, E_star=E_star)


def pressure(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = E_star*(R*atanh(sqrt(a**2 - r**2)/sqrt(R**2 - r**2))/sqrt(R**2 - r**2) - LegendreChi2((a - sqrt(a**2 -
    r**2))/(R + sqrt(R**2 - r**2))) + LegendreChi2((a + sqrt(a**2 - r**2))/(R + sqrt(R**2 - r**2))))/pi
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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Handbook: sphere.p.

    References
    ----------
    chapter 11, equation (11.23); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import sphere
    >>> value = sphere.pressure(0.3, 1.0, R=1.5, E_star=1.0)
    >>> round(value, 6)
    0.467972
    """
    value = plain.pressure(r, a, R, E_star)
    if value is not None:
        return value
    require(R=R, E_star=E_star)
    return elementwise(_pressure, r, a, R=R, E_star=E_star)


def displacement(r: ArrayLike, a: ArrayLike, *, R: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*(-R*asin(a/r) + a*asin(a/r)*atanh(a/R) + sqrt(R**2 - r**2)*atan(a*sqrt(R**2 - r**2)/(R*sqrt(-a**2 +
    r**2))) + sqrt(-a**2 + r**2)*atanh(a/R))/pi   for r < R
    w = 2*(-R*asin(a/r) + a*asin(a/r)*atanh(a/R) - sqrt(-R**2 + r**2)*atanh(a*sqrt(-R**2 + r**2)/(R*sqrt(-a**2
    + r**2))) + sqrt(-a**2 + r**2)*atanh(a/R))/pi   for R < r

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.

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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Evaluated as an integral over the growing contact by a Gauss-Legendre rule. Handbook: sphere.w.

    References
    ----------
    chapter 11, equation (11.26); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import sphere
    >>> value = sphere.displacement(2.0, 1.0, R=1.5)
    >>> round(value, 6)
    0.182594
    """
    value = plain.displacement(r, a, R)
    if value is not None:
        return value
    require(R=R)
    return elementwise(_displacement, r, a, R=R)


def stiffness(a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*E_star*a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Handbook: sphere.k.

    References
    ----------
    chapter 11, equation (11.18); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import sphere
    >>> value = sphere.stiffness(1.0, R=1.5, E_star=1.0)
    >>> round(value, 6)
    2.0
    """
    value = plain.stiffness(a, E_star, R)
    if value is not None:
        return value
    require(R=R, E_star=E_star)
    return elementwise(_stiffness, a, E_star=E_star, unused=(R,))


def mean_pressure(a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = E_star*(-R + (R**2 + a**2)*atanh(a/R)/a)/(pi*a)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Handbook: sphere.pm.

    References
    ----------
    Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import sphere
    >>> value = sphere.mean_pressure(1.0, R=1.5, E_star=1.0)
    >>> round(value, 6)
    0.355023
    """
    value = plain.mean_pressure(a, R, E_star)
    if value is not None:
        return value
    require(R=R, E_star=E_star)
    return elementwise(_mean_pressure, a, R=R, E_star=E_star)


def radius_from_depth(d: ArrayLike, *, R: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a from a*atanh(a/R) = d

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R : array_like
        Radius of curvature [m], R > 0.

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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Evaluated by a safeguarded Newton iteration. Handbook: sphere.ad.

    References
    ----------
    chapter 11, equation (11.16); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import sphere
    >>> value = sphere.radius_from_depth(0.8047, R=1.5)
    >>> round(value, 6)
    0.999991
    """
    value = plain.radius_from_depth(d, R)
    if value is not None:
        return value
    require(R=R)
    return elementwise(_radius_from_depth, d, R=R)


def radius_from_force(F: ArrayLike, *, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a from E_star*(-R*a + (R**2 + a**2)*atanh(a/R)) = F

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Evaluated by a safeguarded Newton iteration. Handbook: sphere.aF.

    References
    ----------
    chapter 11, equation (11.20); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import sphere
    >>> value = sphere.radius_from_force(1.115, R=1.5, E_star=1.0)
    >>> round(value, 6)
    0.999916
    """
    value = plain.radius_from_force(F, R, E_star)
    if value is not None:
        return value
    require(R=R, E_star=E_star)
    return elementwise(_radius_from_force, F, R=R, E_star=E_star)


def force_from_depth(d: ArrayLike, *, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = F(a(d)), through the contact radius.

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Evaluated by a safeguarded Newton iteration. Handbook: sphere.Fd.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import sphere
    >>> value = sphere.force_from_depth(0.8047, R=1.5, E_star=1.0)
    >>> round(value, 6)
    1.115299
    """
    value = plain.force_from_depth(d, R, E_star)
    if value is not None:
        return value
    require(R=R, E_star=E_star)
    return elementwise(_force_from_depth, d, R=R, E_star=E_star)


def depth_from_force(F: ArrayLike, *, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = d(a(F)), through the contact radius.

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Evaluated by a safeguarded Newton iteration. Handbook: sphere.dF.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import sphere
    >>> value = sphere.depth_from_force(1.115, R=1.5, E_star=1.0)
    >>> round(value, 6)
    0.804551
    """
    value = plain.depth_from_force(F, R, E_star)
    if value is not None:
        return value
    require(R=R, E_star=E_star)
    return elementwise(_depth_from_force, F, R=R, E_star=E_star)


def peak_pressure(a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike) -> PeakPressure:
    """Greatest pressure, and the radius of the ring on which it is.

    p_peak = E_star*(R*atanh(sqrt(a**2 - r_peak**2)/sqrt(R**2 - r_peak**2))/sqrt(R**2 - r_peak**2) -
    LegendreChi2((a - sqrt(a**2 - r_peak**2))/(R + sqrt(R**2 - r_peak**2))) + LegendreChi2((a + sqrt(a**2 -
    r_peak**2))/(R + sqrt(R**2 - r_peak**2))))/pi
    with LegendreChi2: chi_2(x) = int_0^x atanh(t)/t dt = (Li_2(x) - Li_2(-x))/2, for 0 <= x < 1
    r_peak = 0   for (-R/(3*a) + a/R)*atanh(a/R) < 1
    r_peak from 1 - a*atanh(a/R)/R = (1 - sqrt(a**2 - r_peak**2)*atanh(sqrt(a**2 - r_peak**2)/sqrt(R**2 -
    r_peak**2))/sqrt(R**2 - r_peak**2))/(1 - r_peak**2/R**2)   for 1 < (-R/(3*a) + a/R)*atanh(a/R)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Handbook: sphere.rp, sphere.pp.

    References
    ----------
    chapter 11, equation (11.23); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import sphere
    >>> value = sphere.peak_pressure(1.0, R=1.5, E_star=1.0)
    >>> round(value.pressure, 6)
    0.48104
    """
    require(R=R, E_star=E_star)
    pressure = elementwise(_peak_pressure, a, R=R, E_star=E_star)
    radius = elementwise(_peak_radius, a, R=R, unused=(E_star,))
    return PeakPressure(pressure, radius)


def energy(a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Elastic energy, the work of pressing the indenter in.

    U = E_star*Integral((a*atanh(a/R) - t*atanh(t/R))**2, (t, 0, a))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Evaluated as an integral over the growing contact by a Gauss-Legendre rule. Handbook: sphere.U.

    References
    ----------
    Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import sphere
    >>> value = sphere.energy(1.0, R=1.5, E_star=1.0)
    >>> round(value, 6)
    0.36486
    """
    value = plain.energy(a, R, E_star)
    if value is not None:
        return value
    require(R=R, E_star=E_star)
    return elementwise(_energy, a, R=R, E_star=E_star)


def load_within(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Part of the normal force that is carried within the radius r; all of it beyond the contact.

    F_r = E_star*(-R*a - R*sqrt(R**2 - r**2)*atanh(sqrt(a**2 - r**2)/sqrt(R**2 - r**2)) + R*sqrt(a**2 - r**2)
    - a*sqrt(a**2 - r**2)*atanh(a/R) - r**2*LegendreChi2((a - sqrt(a**2 - r**2))/(R + sqrt(R**2 - r**2))) +
    r**2*LegendreChi2((a + sqrt(a**2 - r**2))/(R + sqrt(R**2 - r**2))) + (R**2 + a**2)*atanh(a/R))
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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Evaluated as an integral over the growing contact by a Gauss-Legendre rule. Handbook: sphere.Fr.

    References
    ----------
    Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import sphere
    >>> value = sphere.load_within(0.3, 1.0, R=1.5, E_star=1.0)
    >>> round(value, 6)
    0.134196
    """
    value = plain.load_within(r, a, R, E_star)
    if value is not None:
        return value
    require(R=R, E_star=E_star)
    return elementwise(_load_within, r, a, R=R, E_star=E_star)


def _profile(r: Array, R: Array) -> Array:
    root_Rr = np.sqrt((R - r) * (r + R))
    return r**2 / (root_Rr + R)


def _slope(t: Array, root: Array, R: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t)."""
    angle = np.arcsinh(t / root)
    return angle + R * t / root**2


def _depth_at(a: Array, root: Array) -> Array:
    angle = np.arcsinh(a / root)
    return a * angle


def _depth(a: Array, R: Array) -> Array:
    angle = np.log1p(2 * a / (R - a)) / 2
    return a * angle


def _force_at(a: Array, root: Array, R: Array, E_star: Array) -> Array:
    angle = np.arcsinh(a / root)
    return E_star * (a**2 * angle + R**2 * tanh_gap(angle, np.tanh(angle)))


def _force(a: Array, R: Array, E_star: Array) -> Array:
    angle = np.log1p(2 * a / (R - a)) / 2
    return E_star * (a**2 * angle + R**2 * tanh_gap(angle, a / R))


def _pressure(r: Array, a: Array, R: Array, E_star: Array) -> Array:
    root_Rr = np.sqrt((R - r) * (r + R))
    root = np.sqrt((R - a) * (a + R))
    root_ar = np.sqrt((a - r) * (a + r))
    pressed = E_star / np.pi * (R * np.arcsinh(root_ar / root) / root_Rr + arc_strips(r, a, R))
    inside = np.where(r < a, pressed, 0.0)
    return np.where(a <= R, inside, np.nan)


def _displacement(r: Array, a: Array, R: Array) -> Array:
    tip = displacement_integral_tanh(_slope, (R,), r, a, R)
    outside = 2 / np.pi * tip
    inside = _depth(a, R) - _profile(r, R)
    return np.where(a <= R, np.where(r > a, outside, inside), np.nan)


def _stiffness(a: Array, E_star: Array) -> Array:
    return 2 * E_star * a


def _mean_pressure(a: Array, R: Array, E_star: Array) -> Array:
    return np.where(a > 0.0, _force(a, R, E_star) / (np.pi * a**2), 0.0)


def _peak_radius(a: Array, R: Array) -> Array:
    return np.where(a <= R, arc_peak_radius(a, R), np.nan)


def _peak_pressure(a: Array, R: Array, E_star: Array) -> Array:
    return np.where(a <= R, E_star / np.pi * arc_peak_pressure(a, R), np.nan)


def _energy(a: Array, R: Array, E_star: Array) -> Array:
    sunk = _depth(a, R)
    tip = energy_integral_tanh(_depth_at, (), a, sunk, R)
    return np.where(a <= R, E_star * tip, np.nan)


def _load_within(r: Array, a: Array, R: Array, E_star: Array) -> Array:
    tip = load_within_integral_tanh(_slope, (R,), np.minimum(r, a), a, R)
    return np.where(a <= R, _force(np.minimum(r, a), R, E_star) + 2 * E_star * tip, np.nan)


def _contact_from_depth(d: Array, R: Array) -> tuple[Array, Array]:
    """Contact radius a and its root sqrt(R**2 - a**2)."""

    def curve(t: Array) -> tuple[Array, Array]:
        a, root = R * np.tanh(t), R / np.cosh(t)
        value = _depth_at(a, root)
        return value, t * root * root / R * _slope(a, root, R) / value

    rest = (0.9983865, 0.208363, -4.0282, 30.18372, -93.92268, 137.5431, -95.06062, 25.07439)
    start = between(np.log(d / curve(1.0)[0]), (1.313, 2.0), (1.313, 1.0), 3.75, rest)
    t = inverse(curve, d, start, (1.0, 2.0), smooth=True)
    return R * np.tanh(t), R / np.cosh(t)


def _radius_from_depth(d: Array, R: Array) -> Array:
    return _contact_from_depth(d, R)[0]


def _contact_from_force(F: Array, R: Array, E_star: Array) -> tuple[Array, Array]:
    """Contact radius a and its root sqrt(R**2 - a**2)."""

    def curve(t: Array) -> tuple[Array, Array]:
        a, root = R * np.tanh(t), R / np.cosh(t)
        value = _force_at(a, root, R, E_star)
        return value, 2 * E_star * a * t * root * root / R * _slope(a, root, R) / value

    rest = (0.998775, 0.1558039, -2.915358, 22.20415, -66.84601, 91.96521, -58.34092, 13.75711)
    start = between(np.log(F / curve(1.0)[0]), (1.629, 3.0), (2.405, 1.0), 1.75, rest)
    t = inverse(curve, F, start, (1.0, 3.0), smooth=True)
    return R * np.tanh(t), R / np.cosh(t)


def _radius_from_force(F: Array, R: Array, E_star: Array) -> Array:
    return _contact_from_force(F, R, E_star)[0]


def _force_from_depth(d: Array, R: Array, E_star: Array) -> Array:
    a, root = _contact_from_depth(d, R)
    change = np.where((a > 0.0) & (a < np.inf), 2 * E_star * a * (d - _depth_at(a, root)), 0.0)
    return _force_at(a, root, R, E_star) + change


def _depth_from_force(F: Array, R: Array, E_star: Array) -> Array:
    a, root = _contact_from_force(F, R, E_star)
    change = np.where((a > 0.0) & (a < np.inf), (F - _force_at(a, root, R, E_star)) / (2 * E_star * a), 0.0)
    return _depth_at(a, root) + change
