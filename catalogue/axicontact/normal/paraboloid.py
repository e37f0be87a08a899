"""Paraboloid.

The tip of every smooth indenter and the parabolic approximation of the sphere: Hertz's contact.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.functions import beside
from .._runtime.interface import Array, Plain, Result, elementwise, require
from .._runtime.kernels import OUTSIDE_2
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


def profile(r: ArrayLike, *, R: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = r**2/(2*R)

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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: paraboloid.f, the definition of the
    profile.

    References
    ----------
    Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import paraboloid
    >>> value = paraboloid.profile(0.3, R=1.6)
    >>> round(value, 6)
    0.028125
    """
    value = plain.profile(r, R)
    if value is not None:
        return value
    require(R=R)
    return elementwise(_profile, r, R=R)


def depth(a: ArrayLike, *, R: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = a**2/R

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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: paraboloid.d.

    References
    ----------
    chapter 11, equation (11.29); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import paraboloid
    >>> value = paraboloid.depth(1.0, R=1.6)
    >>> round(value, 6)
    0.625
    """
    value = plain.depth(a, R)
    if value is not None:
        return value
    require(R=R)
    return elementwise(_depth, a, R=R)


def force(a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force.

    F = 4*E_star*a**3/(3*R)

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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: paraboloid.F.

    References
    ----------
    chapter 11, equation (11.20); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import paraboloid
    >>> value = paraboloid.force(1.0, R=1.6, E_star=1.0)
    >>> round(value, 6)
    0.833333
    """
    value = plain.force(a, R, E_star)
    if value is not None:
        return value
    require(R=R, E_star=E_star)
    return elementwise(_force, a, R=R, E_star=E_star)


def pressure(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = 2*E_star*sqrt(a**2 - r**2)/(pi*R)

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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: paraboloid.p.

    References
    ----------
    chapter 11, equation (11.23); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import paraboloid
    >>> value = paraboloid.pressure(0.3, 1.0, R=1.6, E_star=1.0)
    >>> round(value, 6)
    0.37956
    """
    value = plain.pressure(r, a, R, E_star)
    if value is not None:
        return value
    require(R=R, E_star=E_star)
    return elementwise(_pressure, r, a, R=R, E_star=E_star)


def displacement(r: ArrayLike, a: ArrayLike, *, R: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = (a*sqrt(-a**2 + r**2) - (-2*a**2 + r**2)*asin(a/r))/(pi*R)

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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: paraboloid.w.

    References
    ----------
    chapter 11, equation (11.26); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import paraboloid
    >>> value = paraboloid.displacement(2.0, 1.0, R=1.6)
    >>> round(value, 6)
    0.136247
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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: paraboloid.k.

    References
    ----------
    chapter 11, equation (11.18); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import paraboloid
    >>> value = paraboloid.stiffness(1.0, R=1.6, E_star=1.0)
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

    p_mean = 4*E_star*a/(3*pi*R)

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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: paraboloid.pm.

    References
    ----------
    Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import paraboloid
    >>> value = paraboloid.mean_pressure(1.0, R=1.6, E_star=1.0)
    >>> round(value, 6)
    0.265258
    """
    value = plain.mean_pressure(a, R, E_star)
    if value is not None:
        return value
    require(R=R, E_star=E_star)
    return elementwise(_mean_pressure, a, R=R, E_star=E_star)


def radius_from_depth(d: ArrayLike, *, R: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a = sqrt(R)*sqrt(d)

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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: paraboloid.ad.

    References
    ----------
    chapter 11, equation (11.16); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import paraboloid
    >>> value = paraboloid.radius_from_depth(0.625, R=1.6)
    >>> round(value, 6)
    1.0
    """
    value = plain.radius_from_depth(d, R)
    if value is not None:
        return value
    require(R=R)
    return elementwise(_radius_from_depth, d, R=R)


def radius_from_force(F: ArrayLike, *, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a = 6**(1/3)*F**(1/3)*R**(1/3)/(2*E_star**(1/3))

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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: paraboloid.aF.

    References
    ----------
    chapter 11, equation (11.20); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import paraboloid
    >>> value = paraboloid.radius_from_force(0.8333, R=1.6, E_star=1.0)
    >>> round(value, 6)
    0.999987
    """
    value = plain.radius_from_force(F, R, E_star)
    if value is not None:
        return value
    require(R=R, E_star=E_star)
    return elementwise(_radius_from_force, F, R=R, E_star=E_star)


def force_from_depth(d: ArrayLike, *, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = 4*E_star*sqrt(R)*d**(3/2)/3

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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: paraboloid.Fd.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import paraboloid
    >>> value = paraboloid.force_from_depth(0.625, R=1.6, E_star=1.0)
    >>> round(value, 6)
    0.833333
    """
    value = plain.force_from_depth(d, R, E_star)
    if value is not None:
        return value
    require(R=R, E_star=E_star)
    return elementwise(_force_from_depth, d, R=R, E_star=E_star)


def depth_from_force(F: ArrayLike, *, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = 6**(2/3)*F**(2/3)/(4*E_star**(2/3)*R**(1/3))

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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: paraboloid.dF.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import paraboloid
    >>> value = paraboloid.depth_from_force(0.8333, R=1.6, E_star=1.0)
    >>> round(value, 6)
    0.624983
    """
    value = plain.depth_from_force(F, R, E_star)
    if value is not None:
        return value
    require(R=R, E_star=E_star)
    return elementwise(_depth_from_force, F, R=R, E_star=E_star)


def peak_pressure(a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike) -> PeakPressure:
    """Greatest pressure, and the radius of the ring on which it is.

    p_peak = 2*E_star*a/(pi*R)
    r_peak = 0

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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: paraboloid.rp, paraboloid.pp.

    References
    ----------
    chapter 11, equation (11.23); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import paraboloid
    >>> value = paraboloid.peak_pressure(1.0, R=1.6, E_star=1.0)
    >>> round(value.pressure, 6)
    0.397887
    """
    require(R=R, E_star=E_star)
    pressure = elementwise(_peak_pressure, a, R=R, E_star=E_star)
    radius = elementwise(_peak_radius, a, unused=(R, E_star))
    return PeakPressure(pressure, radius)


def energy(a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Elastic energy, the work of pressing the indenter in.

    U = 8*E_star*a**5/(15*R**2)

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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: paraboloid.U.

    References
    ----------
    Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import paraboloid
    >>> value = paraboloid.energy(1.0, R=1.6, E_star=1.0)
    >>> round(value, 6)
    0.208333
    """
    value = plain.energy(a, R, E_star)
    if value is not None:
        return value
    require(R=R, E_star=E_star)
    return elementwise(_energy, a, R=R, E_star=E_star)


def load_within(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Part of the normal force that is carried within the radius r; all of it beyond the contact.

    F_r = 4*E_star*(a**3 + (-a + r)*(a + r)*sqrt(a**2 - r**2))/(3*R)

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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: paraboloid.Fr.

    References
    ----------
    Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import paraboloid
    >>> value = paraboloid.load_within(0.3, 1.0, R=1.6, E_star=1.0)
    >>> round(value, 6)
    0.109929
    """
    value = plain.load_within(r, a, R, E_star)
    if value is not None:
        return value
    require(R=R, E_star=E_star)
    return elementwise(_load_within, r, a, R=R, E_star=E_star)


def _profile(r: Array, R: Array) -> Array:
    return r**2 / (2 * R)


def _slope(t: Array, R: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t)."""
    return 2 * t / R


def _depth(a: Array, R: Array) -> Array:
    return a**2 / R


def _force(a: Array, R: Array, E_star: Array) -> Array:
    return 4 * E_star / (3 * R) * a**3


def _pressure(r: Array, a: Array, R: Array, E_star: Array) -> Array:
    root = np.sqrt((a - r) * (a + r))
    return np.where(r < a, 2 * E_star / (np.pi * R) * root, 0.0)


def _displacement(r: Array, a: Array, R: Array) -> Array:
    outside = 2 * a**2 / (np.pi * R) * beside(r, a, OUTSIDE_2)
    inside = _depth(a, R) - _profile(r, R)
    return np.where(r > a, outside, inside)


def _stiffness(a: Array, E_star: Array) -> Array:
    return 2 * E_star * a


def _mean_pressure(a: Array, R: Array, E_star: Array) -> Array:
    return 4 * E_star / (3 * np.pi * R) * a


def _peak_radius(a: Array) -> Array:
    return np.zeros_like(a)


def _peak_pressure(a: Array, R: Array, E_star: Array) -> Array:
    return _pressure(np.zeros_like(a), a, R, E_star)


def _energy(a: Array, R: Array, E_star: Array) -> Array:
    return 8 * E_star / (15 * R**2) * a**5


def _load_within(r: Array, a: Array, R: Array, E_star: Array) -> Array:
    root = np.sqrt((a - r) * (a + r))
    return np.where(
        r < a, np.where(r > 0.0, 4 * E_star / (3 * R) * r**2 * (root + a**2 / (root + a)), 0.0), _force(a, R, E_star)
    )


def _radius_from_depth(d: Array, R: Array) -> Array:
    return np.sqrt(R * d)


def _radius_from_force(F: Array, R: Array, E_star: Array) -> Array:
    return np.cbrt(3 * R / (4 * E_star) * F)


def _force_from_depth(d: Array, R: Array, E_star: Array) -> Array:
    return 4 * E_star / 3 * d * np.sqrt(R * d)


def _depth_from_force(F: Array, R: Array, E_star: Array) -> Array:
    return np.cbrt(9 * F**2 / (16 * E_star**2 * R))
