"""Sextic profile.

Flatter at the tip than the quartic: most of the load is carried near the rim of the contact.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.functions import beside, nth_root, without_root
from .._runtime.interface import Array, Plain, Result, elementwise, require
from .._runtime.kernels import OUTSIDE_6
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


def profile(r: ArrayLike, *, A: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = A*r**6

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.

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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: sextic.f, the
    definition of the profile.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import sextic
    >>> value = sextic.profile(0.3, A=0.4)
    >>> round(value, 6)
    0.000292
    """
    value = plain.profile(r, A)
    if value is not None:
        return value
    require(A=A)
    return elementwise(_profile, r, A=A)


def depth(a: ArrayLike, *, A: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = 16*A*a**6/5

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.

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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: sextic.d.

    References
    ----------
    chapter 11, equation (11.29); Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import sextic
    >>> value = sextic.depth(1.0, A=0.4)
    >>> round(value, 6)
    1.28
    """
    value = plain.depth(a, A)
    if value is not None:
        return value
    require(A=A)
    return elementwise(_depth, a, A=A)


def force(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force.

    F = 192*A*E_star*a**7/35

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: sextic.F.

    References
    ----------
    chapter 11, equation (11.20); Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import sextic
    >>> value = sextic.force(1.0, A=0.4, E_star=1.0)
    >>> round(value, 6)
    2.194286
    """
    value = plain.force(a, A, E_star)
    if value is not None:
        return value
    require(A=A, E_star=E_star)
    return elementwise(_force, a, A=A, E_star=E_star)


def pressure(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = 32*A*E_star*sqrt(a**2 - r**2)*(3*a**4 + 4*a**2*r**2 + 8*r**4)/(25*pi)

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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: sextic.p.

    References
    ----------
    chapter 11, equation (11.23); Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import sextic
    >>> value = sextic.pressure(0.3, 1.0, A=0.4, E_star=1.0)
    >>> round(value, 6)
    0.532447
    """
    value = plain.pressure(r, a, A, E_star)
    if value is not None:
        return value
    require(A=A, E_star=E_star)
    return elementwise(_pressure, r, a, A=A, E_star=E_star)


def displacement(r: ArrayLike, a: ArrayLike, *, A: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*A*(a*sqrt(-a**2 + r**2)*(8*a**4 + 10*a**2*r**2 + 15*r**4) - 3*(-16*a**6 + 5*r**6)*asin(a/r))/(15*pi)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.

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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: sextic.w.

    References
    ----------
    chapter 11, equation (11.26); Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import sextic
    >>> value = sextic.displacement(2.0, 1.0, A=0.4)
    >>> round(value, 6)
    0.361745
    """
    value = plain.displacement(r, a, A)
    if value is not None:
        return value
    require(A=A)
    return elementwise(_displacement, r, a, A=A)


def stiffness(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*E_star*a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: sextic.k.

    References
    ----------
    chapter 11, equation (11.18); Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import sextic
    >>> value = sextic.stiffness(1.0, A=0.4, E_star=1.0)
    >>> round(value, 6)
    2.0
    """
    value = plain.stiffness(a, E_star, A)
    if value is not None:
        return value
    require(A=A, E_star=E_star)
    return elementwise(_stiffness, a, E_star=E_star, unused=(A,))


def mean_pressure(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = 192*A*E_star*a**5/(35*pi)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: sextic.pm.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import sextic
    >>> value = sextic.mean_pressure(1.0, A=0.4, E_star=1.0)
    >>> round(value, 6)
    0.698463
    """
    value = plain.mean_pressure(a, A, E_star)
    if value is not None:
        return value
    require(A=A, E_star=E_star)
    return elementwise(_mean_pressure, a, A=A, E_star=E_star)


def radius_from_depth(d: ArrayLike, *, A: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a = 2**(1/3)*5**(1/6)*d**(1/6)/(2*A**(1/6))

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.

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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: sextic.ad.

    References
    ----------
    chapter 11, equation (11.16); Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import sextic
    >>> value = sextic.radius_from_depth(1.28, A=0.4)
    >>> round(value, 6)
    1.0
    """
    value = plain.radius_from_depth(d, A)
    if value is not None:
        return value
    require(A=A)
    return elementwise(_radius_from_depth, d, A=A)


def radius_from_force(F: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a = 51030**(1/7)*F**(1/7)/(6*A**(1/7)*E_star**(1/7))

    Parameters
    ----------
    F : array_like
        Normal force [N].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: sextic.aF.

    References
    ----------
    chapter 11, equation (11.20); Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import sextic
    >>> value = sextic.radius_from_force(2.194, A=0.4, E_star=1.0)
    >>> round(value, 6)
    0.999981
    """
    value = plain.radius_from_force(F, A, E_star)
    if value is not None:
        return value
    require(A=A, E_star=E_star)
    return elementwise(_radius_from_force, F, A=A, E_star=E_star)


def force_from_depth(d: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = 6*2**(1/3)*5**(1/6)*E_star*d**(7/6)/(7*A**(1/6))

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: sextic.Fd.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import sextic
    >>> value = sextic.force_from_depth(1.28, A=0.4, E_star=1.0)
    >>> round(value, 6)
    2.194286
    """
    value = plain.force_from_depth(d, A, E_star)
    if value is not None:
        return value
    require(A=A, E_star=E_star)
    return elementwise(_force_from_depth, d, A=A, E_star=E_star)


def depth_from_force(F: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = 352947000000**(1/7)*A**(1/7)*F**(6/7)/(60*E_star**(6/7))

    Parameters
    ----------
    F : array_like
        Normal force [N].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: sextic.dF.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import sextic
    >>> value = sextic.depth_from_force(2.194, A=0.4, E_star=1.0)
    >>> round(value, 6)
    1.279857
    """
    value = plain.depth_from_force(F, A, E_star)
    if value is not None:
        return value
    require(A=A, E_star=E_star)
    return elementwise(_depth_from_force, F, A=A, E_star=E_star)


def peak_pressure(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> PeakPressure:
    """Greatest pressure, and the radius of the ring on which it is.

    p_peak = 32*A*E_star*a**5*sqrt(3 - sqrt(3))*(sqrt(3) + 3)/(25*pi)
    r_peak = a*sqrt(1 + sqrt(3))/2

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: sextic.rp,
    sextic.pp.

    References
    ----------
    chapter 11, equation (11.23); Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import sextic
    >>> value = sextic.peak_pressure(1.0, A=0.4, E_star=1.0)
    >>> round(value.pressure, 6)
    0.868401
    """
    require(A=A, E_star=E_star)
    pressure = elementwise(_peak_pressure, a, A=A, E_star=E_star)
    radius = elementwise(_peak_radius, a, unused=(A, E_star))
    return PeakPressure(pressure, radius)


def energy(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Elastic energy, the work of pressing the indenter in.

    U = 18432*A**2*E_star*a**13/2275

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: sextic.U.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import sextic
    >>> value = sextic.energy(1.0, A=0.4, E_star=1.0)
    >>> round(value, 6)
    1.296316
    """
    value = plain.energy(a, A, E_star)
    if value is not None:
        return value
    require(A=A, E_star=E_star)
    return elementwise(_energy, a, A=A, E_star=E_star)


def load_within(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Part of the normal force that is carried within the radius r; all of it beyond the contact.

    F_r = 64*A*E_star*(15*a**7 + (-a + r)*(a + r)*sqrt(a**2 - r**2)*(15*a**4 + 12*a**2*r**2 + 8*r**4))/175

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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: sextic.Fr.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import sextic
    >>> value = sextic.load_within(0.3, 1.0, A=0.4, E_star=1.0)
    >>> round(value, 6)
    0.144084
    """
    value = plain.load_within(r, a, A, E_star)
    if value is not None:
        return value
    require(A=A, E_star=E_star)
    return elementwise(_load_within, r, a, A=A, E_star=E_star)


def _profile(r: Array, A: Array) -> Array:
    return A * r**6


def _slope(t: Array, A: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t)."""
    return 96 * A / 5 * t**5


def _depth(a: Array, A: Array) -> Array:
    return 16 * A / 5 * a**6


def _force(a: Array, A: Array, E_star: Array) -> Array:
    return 192 * E_star * A / 35 * a**7


def _pressure(r: Array, a: Array, A: Array, E_star: Array) -> Array:
    root = np.sqrt((a - r) * (a + r))
    return np.where(r < a, 32 * E_star * A / (25 * np.pi) * (3 * a**4 + 4 * a**2 * r**2 + 8 * r**4) * root, 0.0)


def _displacement(r: Array, a: Array, A: Array) -> Array:
    outside = 32 * A / (5 * np.pi) * a**6 * beside(r, a, OUTSIDE_6)
    inside = _depth(a, A) - _profile(r, A)
    return np.where(r > a, outside, inside)


def _stiffness(a: Array, E_star: Array) -> Array:
    return 2 * E_star * a


def _mean_pressure(a: Array, A: Array, E_star: Array) -> Array:
    return 192 * E_star * A / (35 * np.pi) * a**5


def _peak_radius(a: Array) -> Array:
    root = np.sqrt(1 + np.sqrt(3))
    return a * root / 2


def _peak_pressure(a: Array, A: Array, E_star: Array) -> Array:
    root = np.sqrt(3 - np.sqrt(3))
    return 32 * (3 + np.sqrt(3)) * E_star * A / (25 * np.pi) * a**5 * root


def _energy(a: Array, A: Array, E_star: Array) -> Array:
    return 18432 * E_star * A**2 / 2275 * a**13


def _load_within(r: Array, a: Array, A: Array, E_star: Array) -> Array:
    root = np.sqrt((a - r) * (a + r))
    plus = 15 * a**6 / (root + a) + 3 * a**4 * root + 4 * a**2 * r**2 * root + 8 * r**4 * root
    return np.where(r < a, np.where(r > 0.0, 64 * E_star * A / 175 * r**2 * plus, 0.0), _force(a, A, E_star))


def _radius_from_depth(d: Array, A: Array) -> Array:
    return nth_root(5 * d / (16 * A), 6)


def _radius_from_force(F: Array, A: Array, E_star: Array) -> Array:
    return nth_root(35 * F / (192 * E_star * A), 7)


def _force_from_depth(d: Array, A: Array, E_star: Array) -> Array:
    return 6 * E_star / 7 * d * nth_root(20 * d / A, 6)


def _depth_from_force(F: Array, A: Array, E_star: Array) -> Array:
    return without_root(F / E_star, 7) * nth_root(117649 * A / 933120, 7)
