"""Concave paraboloid.

Concave parabolic face of depth h: the pressure vanishes first at the centre.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Plain, Result, elementwise, require
from .._runtime.shapes.powers import power_punches

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "depth_from_force",
    "displacement",
    "energy",
    "force",
    "load_within",
    "minimum_depth",
    "minimum_force",
    "pressure",
    "profile",
    "stiffness",
    "zero_radius",
]


def __dir__() -> list[str]:
    return __all__


plain = Plain(__name__, __all__)


def profile(r: ArrayLike, *, a: ArrayLike, h: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = -h*r**2/a**2

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.

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
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN. Handbook:
    concave_paraboloid.f, the definition of the profile.

    References
    ----------
    Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_paraboloid
    >>> value = concave_paraboloid.profile(0.3, a=1.0, h=0.15)
    >>> round(value, 6)
    -0.0135
    """
    value = plain.profile(r, a, h)
    if value is not None:
        return value
    require(a=a, h=h)
    return elementwise(_profile, r, a=a, h=h)


def force(d: ArrayLike, *, a: ArrayLike, h: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force.

    F = 2*E_star*a*(d + 2*h/3)

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
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
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN. The depth is
    measured at the centre of the face; the rim is at d + h. Handbook: concave_paraboloid.F.

    References
    ----------
    chapter 11, equation (11.13); chapter 11, equation (11.20); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_paraboloid
    >>> value = concave_paraboloid.force(0.6, a=1.0, h=0.15, E_star=1.0)
    >>> round(value, 6)
    1.4
    """
    value = plain.force(d, a, h, E_star)
    if value is not None:
        return value
    require(a=a, h=h, E_star=E_star)
    return elementwise(_force, d, a=a, h=h, E_star=E_star)


def pressure(r: ArrayLike, d: ArrayLike, *, a: ArrayLike, h: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = E_star*(d/sqrt(a**2 - r**2) + 2*h/sqrt(a**2 - r**2) - 4*h*sqrt(a**2 - r**2)/a**2)/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
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
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN. The depth is
    measured at the centre of the face; the rim is at d + h. Handbook: concave_paraboloid.p.

    References
    ----------
    chapter 11, equation (11.15); chapter 11, equation (11.107); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_paraboloid
    >>> value = concave_paraboloid.pressure(0.3, 0.6, a=1.0, h=0.15, E_star=1.0)
    >>> round(value, 6)
    0.118123
    """
    value = plain.pressure(r, d, a, h, E_star)
    if value is not None:
        return value
    require(a=a, h=h, E_star=E_star)
    return elementwise(_pressure, r, d, a=a, h=h, E_star=E_star)


def displacement(r: ArrayLike, d: ArrayLike, *, a: ArrayLike, h: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*(d*asin(a/r) - h*sqrt(-a**2 + r**2)/a + h*r**2*asin(a/r)/a**2)/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.

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
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN. Evaluated as an
    integral over the growing contact by a Gauss-Legendre rule. Handbook: concave_paraboloid.w.

    References
    ----------
    chapter 11, equation (11.12); chapter 11, equation (11.105); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_paraboloid
    >>> value = concave_paraboloid.displacement(2.0, 0.6, a=1.0, h=0.15)
    >>> round(value, 6)
    0.234601
    """
    value = plain.displacement(r, d, a, h)
    if value is not None:
        return value
    require(a=a, h=h)
    return elementwise(_displacement, r, d, a=a, h=h)


def stiffness(*, a: ArrayLike, h: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*E_star*a

    Parameters
    ----------
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Contact stiffness dF/dd [N/m]. A number for numbers.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN. Handbook:
    concave_paraboloid.k.

    References
    ----------
    chapter 11, equation (11.14); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_paraboloid
    >>> value = concave_paraboloid.stiffness(a=1.0, h=0.15, E_star=1.0)
    >>> round(value, 6)
    2.0
    """
    value = plain.stiffness(a, E_star, h)
    if value is not None:
        return value
    require(a=a, h=h, E_star=E_star)
    return elementwise(_stiffness, a=a, E_star=E_star, unused=(h,))


def depth_from_force(F: ArrayLike, *, a: ArrayLike, h: ArrayLike, E_star: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = -2*h/3 + F/(2*E_star*a)

    Parameters
    ----------
    F : array_like
        Normal force [N].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
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
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN. Handbook:
    concave_paraboloid.dF.

    References
    ----------
    chapter 11, equation (11.14); chapter 11, equation (11.20); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_paraboloid
    >>> value = concave_paraboloid.depth_from_force(1.4, a=1.0, h=0.15, E_star=1.0)
    >>> round(value, 6)
    0.6
    """
    value = plain.depth_from_force(F, a, h, E_star)
    if value is not None:
        return value
    require(a=a, h=h, E_star=E_star)
    return elementwise(_depth_from_force, F, a=a, h=h, E_star=E_star)


def zero_radius(*, a: ArrayLike, h: ArrayLike) -> Result:
    """Radius of the ring where the pressure first vanishes on unloading.

    r_zero = 0

    Parameters
    ----------
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.

    Returns
    -------
    float or ndarray
        Radius of the ring where the pressure first vanishes on unloading [m]. A number for numbers.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN. Handbook:
    concave_paraboloid.rz.

    References
    ----------
    Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_paraboloid
    >>> value = concave_paraboloid.zero_radius(a=1.0, h=0.15)
    >>> round(value, 6)
    0.0
    """
    value = plain.zero_radius(a, h)
    if value is not None:
        return value
    require(a=a, h=h)
    return elementwise(_zero_radius, unused=(a, h))


def minimum_depth(*, a: ArrayLike, h: ArrayLike) -> Result:
    """Least indentation depth of complete contact.

    d = 2*h

    Parameters
    ----------
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.

    Returns
    -------
    float or ndarray
        Indentation depth of the point r = 0 [m]. A number for numbers.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN. Handbook:
    concave_paraboloid.dmin.

    References
    ----------
    Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_paraboloid
    >>> value = concave_paraboloid.minimum_depth(a=1.0, h=0.15)
    >>> round(value, 6)
    0.3
    """
    value = plain.minimum_depth(h, a)
    if value is not None:
        return value
    require(a=a, h=h)
    return elementwise(_minimum_depth, h=h, unused=(a,))


def minimum_force(*, a: ArrayLike, h: ArrayLike, E_star: ArrayLike) -> Result:
    """Least normal force of complete contact.

    F = 16*E_star*a*h/3

    Parameters
    ----------
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Normal force [N]. A number for numbers.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN. Handbook:
    concave_paraboloid.Fmin.

    References
    ----------
    Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_paraboloid
    >>> value = concave_paraboloid.minimum_force(a=1.0, h=0.15, E_star=1.0)
    >>> round(value, 6)
    0.8
    """
    value = plain.minimum_force(a, h, E_star)
    if value is not None:
        return value
    require(a=a, h=h, E_star=E_star)
    return elementwise(_minimum_force, a=a, h=h, E_star=E_star)


def energy(d: ArrayLike, *, a: ArrayLike, h: ArrayLike, E_star: ArrayLike) -> Result:
    """Elastic energy, the work of pressing the indenter in.

    U = E_star*(a*d**2 + 4*a*d*h/3 + 4*a*h**2/5)

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
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
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN. Handbook:
    concave_paraboloid.U.

    References
    ----------
    Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_paraboloid
    >>> value = concave_paraboloid.energy(0.6, a=1.0, h=0.15, E_star=1.0)
    >>> round(value, 6)
    0.498
    """
    value = plain.energy(d, a, h, E_star)
    if value is not None:
        return value
    require(a=a, h=h, E_star=E_star)
    return elementwise(_energy, d, a=a, h=h, E_star=E_star)


def load_within(r: ArrayLike, d: ArrayLike, *, a: ArrayLike, h: ArrayLike, E_star: ArrayLike) -> Result:
    """Part of the normal force that is carried within the radius r; all of it beyond the contact.

    F_r = 2*E_star*((a - sqrt(a**2 - r**2))*(3*d + 2*h) - 4*h*r**2*sqrt(a**2 - r**2)/a**2)/3

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
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
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN. Handbook:
    concave_paraboloid.Fr.

    References
    ----------
    Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_paraboloid
    >>> value = concave_paraboloid.load_within(0.3, 0.6, a=1.0, h=0.15, E_star=1.0)
    >>> round(value, 6)
    0.030143
    """
    value = plain.load_within(r, d, a, h, E_star)
    if value is not None:
        return value
    require(a=a, h=h, E_star=E_star)
    return elementwise(_load_within, r, d, a=a, h=h, E_star=E_star)


def _profile(r: Array, a: Array, h: Array) -> Array:
    return np.where(r <= a, -h * r**2 / a**2, np.nan)


def _zero_radius() -> Array:
    return 0.0


def _minimum_depth(h: Array) -> Array:
    return 2 * h


def _minimum_force(a: Array, h: Array, E_star: Array) -> Array:
    return 16 * E_star * h / 3 * a


def _force(d: Array, a: Array, h: Array, E_star: Array) -> Array:
    complete = _minimum_depth(h) * (1.0 - 1e-15) <= d
    result = 2 * E_star * a * (d + 2 * h / 3)
    return np.where(complete, result, np.nan)


def _depth_from_force(F: Array, a: Array, h: Array, E_star: Array) -> Array:
    complete = _minimum_force(a, h, E_star) * (1.0 - 1e-15) <= F
    result = F / (2 * E_star * a) - 2 * h / 3
    return np.where(complete, result, np.nan)


def _stiffness(a: Array, E_star: Array) -> Array:
    return 2 * E_star * a


def _pressure(r: Array, d: Array, a: Array, h: Array, E_star: Array) -> Array:
    root = np.sqrt((a - r) * (a + r))
    face = 4 * h * r**2 / a**2
    complete = _minimum_depth(h) * (1.0 - 1e-15) <= d
    result = np.where((r <= a) & (d > 0.0), E_star / np.pi * (d - _minimum_depth(h) + face) / root, 0.0)
    return np.where(complete, result, np.nan)


def _displacement(r: Array, d: Array, a: Array, h: Array) -> Array:
    angle = np.arctan2(a, np.sqrt((r - a) * (r + a)))
    outside = 2 / np.pi * (d * angle + 2 * h * power_punches(r, a, 2))
    inside = d - _profile(r, a, h)
    complete = _minimum_depth(h) * (1.0 - 1e-15) <= d
    result = np.where(r > a, outside, inside)
    return np.where(complete, result, np.nan)


def _energy(d: Array, a: Array, h: Array, E_star: Array) -> Array:
    complete = _minimum_depth(h) * (1.0 - 1e-15) <= d
    result = E_star * (d**2 * a + 4 * h / 3 * d * a + 4 * h**2 / 5 * a)
    return np.where(complete, result, np.nan)


def _load_within(r: Array, d: Array, a: Array, h: Array, E_star: Array) -> Array:
    root = np.sqrt((a - r) * (a + r))
    rise = r**2 / (a + root)
    face = 4 * h * rise * (root + 2 * a) / (3 * a**2)
    within = 2 * E_star * rise * (d - _minimum_depth(h) + face)
    complete = _minimum_depth(h) * (1.0 - 1e-15) <= d
    result = np.where(r < a, within, _force(d, a, h, E_star))
    return np.where(complete, result, np.nan)
