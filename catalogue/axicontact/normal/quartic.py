"""Quartic profile.

Vanishing curvature at the tip: the pressure has a dip at the centre and its largest value on a ring.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.functions import beside, nth_root, without_root
from .._runtime.interface import Array, Plain, Result, elementwise, require
from .._runtime.kernels import OUTSIDE_4
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

    f = A*r**4

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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: quartic.f, the
    definition of the profile.

    References
    ----------
    Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import quartic
    >>> value = quartic.profile(0.3, A=0.4)
    >>> round(value, 6)
    0.00324
    """
    value = plain.profile(r, A)
    if value is not None:
        return value
    require(A=A)
    return elementwise(_profile, r, A=A)


def depth(a: ArrayLike, *, A: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = 8*A*a**4/3

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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: quartic.d.

    References
    ----------
    chapter 11, equation (11.29); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import quartic
    >>> value = quartic.depth(1.0, A=0.4)
    >>> round(value, 6)
    1.066667
    """
    value = plain.depth(a, A)
    if value is not None:
        return value
    require(A=A)
    return elementwise(_depth, a, A=A)


def force(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force.

    F = 64*A*E_star*a**5/15

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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: quartic.F.

    References
    ----------
    chapter 11, equation (11.20); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import quartic
    >>> value = quartic.force(1.0, A=0.4, E_star=1.0)
    >>> round(value, 6)
    1.706667
    """
    value = plain.force(a, A, E_star)
    if value is not None:
        return value
    require(A=A, E_star=E_star)
    return elementwise(_force, a, A=A, E_star=E_star)


def pressure(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = 32*A*E_star*sqrt(a**2 - r**2)*(a**2 + 2*r**2)/(9*pi)

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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: quartic.p.

    References
    ----------
    chapter 11, equation (11.23); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import quartic
    >>> value = quartic.pressure(0.3, 1.0, A=0.4, E_star=1.0)
    >>> round(value, 6)
    0.509589
    """
    value = plain.pressure(r, a, A, E_star)
    if value is not None:
        return value
    require(A=A, E_star=E_star)
    return elementwise(_pressure, r, a, A=A, E_star=E_star)


def displacement(r: ArrayLike, a: ArrayLike, *, A: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*A*(a*sqrt(-a**2 + r**2)*(2*a**2 + 3*r**2) - (-8*a**4 + 3*r**4)*asin(a/r))/(3*pi)

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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: quartic.w.

    References
    ----------
    chapter 11, equation (11.26); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import quartic
    >>> value = quartic.displacement(2.0, 1.0, A=0.4)
    >>> round(value, 6)
    0.280517
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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: quartic.k.

    References
    ----------
    chapter 11, equation (11.18); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import quartic
    >>> value = quartic.stiffness(1.0, A=0.4, E_star=1.0)
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

    p_mean = 64*A*E_star*a**3/(15*pi)

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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: quartic.pm.

    References
    ----------
    Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import quartic
    >>> value = quartic.mean_pressure(1.0, A=0.4, E_star=1.0)
    >>> round(value, 6)
    0.543249
    """
    value = plain.mean_pressure(a, A, E_star)
    if value is not None:
        return value
    require(A=A, E_star=E_star)
    return elementwise(_mean_pressure, a, A=A, E_star=E_star)


def radius_from_depth(d: ArrayLike, *, A: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a = 6**(1/4)*d**(1/4)/(2*A**(1/4))

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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: quartic.ad.

    References
    ----------
    chapter 11, equation (11.16); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import quartic
    >>> value = quartic.radius_from_depth(1.067, A=0.4)
    >>> round(value, 6)
    1.000078
    """
    value = plain.radius_from_depth(d, A)
    if value is not None:
        return value
    require(A=A)
    return elementwise(_radius_from_depth, d, A=A)


def radius_from_force(F: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a = 15**(1/5)*2**(4/5)*F**(1/5)/(4*A**(1/5)*E_star**(1/5))

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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: quartic.aF.

    References
    ----------
    chapter 11, equation (11.20); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import quartic
    >>> value = quartic.radius_from_force(1.707, A=0.4, E_star=1.0)
    >>> round(value, 6)
    1.000039
    """
    value = plain.radius_from_force(F, A, E_star)
    if value is not None:
        return value
    require(A=A, E_star=E_star)
    return elementwise(_radius_from_force, F, A=A, E_star=E_star)


def force_from_depth(d: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = 4*6**(1/4)*E_star*d**(5/4)/(5*A**(1/4))

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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: quartic.Fd.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import quartic
    >>> value = quartic.force_from_depth(1.067, A=0.4, E_star=1.0)
    >>> round(value, 6)
    1.707333
    """
    value = plain.force_from_depth(d, A, E_star)
    if value is not None:
        return value
    require(A=A, E_star=E_star)
    return elementwise(_force_from_depth, d, A=A, E_star=E_star)


def depth_from_force(F: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = 15**(4/5)*2**(1/5)*A**(1/5)*F**(4/5)/(12*E_star**(4/5))

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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: quartic.dF.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import quartic
    >>> value = quartic.depth_from_force(1.707, A=0.4, E_star=1.0)
    >>> round(value, 6)
    1.066833
    """
    value = plain.depth_from_force(F, A, E_star)
    if value is not None:
        return value
    require(A=A, E_star=E_star)
    return elementwise(_depth_from_force, F, A=A, E_star=E_star)


def peak_pressure(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> PeakPressure:
    """Greatest pressure, and the radius of the ring on which it is.

    p_peak = 32*sqrt(2)*A*E_star*a**3/(9*pi)
    r_peak = sqrt(2)*a/2

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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: quartic.rp,
    quartic.pp.

    References
    ----------
    chapter 11, equation (11.23); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import quartic
    >>> value = quartic.peak_pressure(1.0, A=0.4, E_star=1.0)
    >>> round(value.pressure, 6)
    0.640225
    """
    require(A=A, E_star=E_star)
    pressure = elementwise(_peak_pressure, a, A=A, E_star=E_star)
    radius = elementwise(_peak_radius, a, unused=(A, E_star))
    return PeakPressure(pressure, radius)


def energy(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Elastic energy, the work of pressing the indenter in.

    U = 2048*A**2*E_star*a**9/405

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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: quartic.U.

    References
    ----------
    Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import quartic
    >>> value = quartic.energy(1.0, A=0.4, E_star=1.0)
    >>> round(value, 6)
    0.809086
    """
    value = plain.energy(a, A, E_star)
    if value is not None:
        return value
    require(A=A, E_star=E_star)
    return elementwise(_energy, a, A=A, E_star=E_star)


def load_within(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Part of the normal force that is carried within the radius r; all of it beyond the contact.

    F_r = 64*A*E_star*(3*a**5 + (-a + r)*(a + r)*sqrt(a**2 - r**2)*(3*a**2 + 2*r**2))/45

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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: quartic.Fr.

    References
    ----------
    Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import quartic
    >>> value = quartic.load_within(0.3, 1.0, A=0.4, E_star=1.0)
    >>> round(value, 6)
    0.136244
    """
    value = plain.load_within(r, a, A, E_star)
    if value is not None:
        return value
    require(A=A, E_star=E_star)
    return elementwise(_load_within, r, a, A=A, E_star=E_star)


def _profile(r: Array, A: Array) -> Array:
    return A * r**4


def _slope(t: Array, A: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t)."""
    return 32 * A / 3 * t**3


def _depth(a: Array, A: Array) -> Array:
    return 8 * A / 3 * a**4


def _force(a: Array, A: Array, E_star: Array) -> Array:
    return 64 * E_star * A / 15 * a**5


def _pressure(r: Array, a: Array, A: Array, E_star: Array) -> Array:
    root = np.sqrt((a - r) * (a + r))
    return np.where(r < a, 32 * E_star * A / (9 * np.pi) * (a**2 + 2 * r**2) * root, 0.0)


def _displacement(r: Array, a: Array, A: Array) -> Array:
    outside = 16 * A / (3 * np.pi) * a**4 * beside(r, a, OUTSIDE_4)
    inside = _depth(a, A) - _profile(r, A)
    return np.where(r > a, outside, inside)


def _stiffness(a: Array, E_star: Array) -> Array:
    return 2 * E_star * a


def _mean_pressure(a: Array, A: Array, E_star: Array) -> Array:
    return 64 * E_star * A / (15 * np.pi) * a**3


def _peak_radius(a: Array) -> Array:
    return a * np.sqrt(2) / 2


def _peak_pressure(a: Array, A: Array, E_star: Array) -> Array:
    return 32 * E_star * A / (9 * np.pi) * a**3 * np.sqrt(2)


def _energy(a: Array, A: Array, E_star: Array) -> Array:
    return 2048 * E_star * A**2 / 405 * a**9


def _load_within(r: Array, a: Array, A: Array, E_star: Array) -> Array:
    root = np.sqrt((a - r) * (a + r))
    within = 64 * E_star * A / 45 * r**2 * (3 * a**4 / (root + a) + a**2 * root + 2 * r**2 * root)
    return np.where(r < a, np.where(r > 0.0, within, 0.0), _force(a, A, E_star))


def _radius_from_depth(d: Array, A: Array) -> Array:
    return np.sqrt(np.sqrt(3 * d / (8 * A)))


def _radius_from_force(F: Array, A: Array, E_star: Array) -> Array:
    return nth_root(15 * F / (64 * E_star * A), 5)


def _force_from_depth(d: Array, A: Array, E_star: Array) -> Array:
    return 4 * E_star / 5 * d * np.sqrt(np.sqrt(6 * d / A))


def _depth_from_force(F: Array, A: Array, E_star: Array) -> Array:
    return without_root(F / E_star, 5) * nth_root(625 * A / 1536, 5)
