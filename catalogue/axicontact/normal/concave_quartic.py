"""Concave quartic.

Concave face of fourth order: the pressure vanishes first on the ring r = a/2.
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

    f = -h*r**4/a**4

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
    concave_quartic.f, the definition of the profile.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_quartic
    >>> value = concave_quartic.profile(0.3, a=1.0, h=0.15)
    >>> round(value, 6)
    -0.001215
    """
    value = plain.profile(r, a, h)
    if value is not None:
        return value
    require(a=a, h=h)
    return elementwise(_profile, r, a=a, h=h)


def force(d: ArrayLike, *, a: ArrayLike, h: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force.

    F = 2*E_star*a*(d + 8*h/15)

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
    measured at the centre of the face; the rim is at d + h. Handbook: concave_quartic.F.

    References
    ----------
    chapter 11, equation (11.13); chapter 11, equation (11.20); Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_quartic
    >>> value = concave_quartic.force(0.6, a=1.0, h=0.15, E_star=1.0)
    >>> round(value, 6)
    1.36
    """
    value = plain.force(d, a, h, E_star)
    if value is not None:
        return value
    require(a=a, h=h, E_star=E_star)
    return elementwise(_force, d, a=a, h=h, E_star=E_star)


def pressure(r: ArrayLike, d: ArrayLike, *, a: ArrayLike, h: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = E_star*(d/sqrt(a**2 - r**2) + 8*h/(3*sqrt(a**2 - r**2)) - 32*h*sqrt(a**2 - r**2)*(a**2 +
    2*r**2)/(9*a**4))/pi

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
    measured at the centre of the face; the rim is at d + h. Handbook: concave_quartic.p.

    References
    ----------
    chapter 11, equation (11.15); chapter 11, equation (11.107); Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_quartic
    >>> value = concave_quartic.pressure(0.3, 0.6, a=1.0, h=0.15, E_star=1.0)
    >>> round(value, 6)
    0.142583
    """
    value = plain.pressure(r, d, a, h, E_star)
    if value is not None:
        return value
    require(a=a, h=h, E_star=E_star)
    return elementwise(_pressure, r, d, a=a, h=h, E_star=E_star)


def displacement(r: ArrayLike, d: ArrayLike, *, a: ArrayLike, h: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*(d*asin(a/r) - h*sqrt(-a**2 + r**2)*(2*a**2 + 3*r**2)/(3*a**3) + h*r**4*asin(a/r)/a**4)/pi

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
    integral over the growing contact by a Gauss-Legendre rule. Handbook: concave_quartic.w.

    References
    ----------
    chapter 11, equation (11.12); chapter 11, equation (11.105); Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_quartic
    >>> value = concave_quartic.displacement(2.0, 0.6, a=1.0, h=0.15)
    >>> round(value, 6)
    0.22814
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
    concave_quartic.k.

    References
    ----------
    chapter 11, equation (11.14); Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_quartic
    >>> value = concave_quartic.stiffness(a=1.0, h=0.15, E_star=1.0)
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

    d = -8*h/15 + F/(2*E_star*a)

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
    concave_quartic.dF.

    References
    ----------
    chapter 11, equation (11.14); chapter 11, equation (11.20); Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_quartic
    >>> value = concave_quartic.depth_from_force(1.36, a=1.0, h=0.15, E_star=1.0)
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

    r_zero = a/2

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
    concave_quartic.rz.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_quartic
    >>> value = concave_quartic.zero_radius(a=1.0, h=0.15)
    >>> round(value, 6)
    0.5
    """
    value = plain.zero_radius(a, h)
    if value is not None:
        return value
    require(a=a, h=h)
    return elementwise(_zero_radius, a=a, unused=(h,))


def minimum_depth(*, a: ArrayLike, h: ArrayLike) -> Result:
    """Least indentation depth of complete contact.

    d = 4*h/3

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
    concave_quartic.dmin.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_quartic
    >>> value = concave_quartic.minimum_depth(a=1.0, h=0.15)
    >>> round(value, 6)
    0.2
    """
    value = plain.minimum_depth(h, a)
    if value is not None:
        return value
    require(a=a, h=h)
    return elementwise(_minimum_depth, h=h, unused=(a,))


def minimum_force(*, a: ArrayLike, h: ArrayLike, E_star: ArrayLike) -> Result:
    """Least normal force of complete contact.

    F = 56*E_star*a*h/15

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
    concave_quartic.Fmin.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_quartic
    >>> value = concave_quartic.minimum_force(a=1.0, h=0.15, E_star=1.0)
    >>> round(value, 6)
    0.56
    """
    value = plain.minimum_force(a, h, E_star)
    if value is not None:
        return value
    require(a=a, h=h, E_star=E_star)
    return elementwise(_minimum_force, a=a, h=h, E_star=E_star)


def energy(d: ArrayLike, *, a: ArrayLike, h: ArrayLike, E_star: ArrayLike) -> Result:
    """Elastic energy, the work of pressing the indenter in.

    U = E_star*(a*d**2 + 16*a*d*h/15 + 64*a*h**2/81)

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
    concave_quartic.U.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_quartic
    >>> value = concave_quartic.energy(0.6, a=1.0, h=0.15, E_star=1.0)
    >>> round(value, 6)
    0.473778
    """
    value = plain.energy(d, a, h, E_star)
    if value is not None:
        return value
    require(a=a, h=h, E_star=E_star)
    return elementwise(_energy, d, a=a, h=h, E_star=E_star)


def load_within(r: ArrayLike, d: ArrayLike, *, a: ArrayLike, h: ArrayLike, E_star: ArrayLike) -> Result:
    """Part of the normal force that is carried within the radius r; all of it beyond the contact.

    F_r = 2*E_star*(3*(a - sqrt(a**2 - r**2))*(15*d + 8*h) - 32*h*r**2*sqrt(a**2 - r**2)*(a**2 +
    2*r**2)/a**4)/45

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
    concave_quartic.Fr.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_quartic
    >>> value = concave_quartic.load_within(0.3, 0.6, a=1.0, h=0.15, E_star=1.0)
    >>> round(value, 6)
    0.04103
    """
    value = plain.load_within(r, d, a, h, E_star)
    if value is not None:
        return value
    require(a=a, h=h, E_star=E_star)
    return elementwise(_load_within, r, d, a=a, h=h, E_star=E_star)


def _profile(r: Array, a: Array, h: Array) -> Array:
    return np.where(r <= a, -h * r**4 / a**4, np.nan)


def _zero_radius(a: Array) -> Array:
    return a / 2


def _minimum_depth(h: Array) -> Array:
    return 4 * h / 3


def _minimum_force(a: Array, h: Array, E_star: Array) -> Array:
    return 56 * E_star * h / 15 * a


def _force(d: Array, a: Array, h: Array, E_star: Array) -> Array:
    complete = _minimum_depth(h) * (1.0 - 1e-15) <= d
    result = 2 * E_star * a * (d + 8 * h / 15)
    return np.where(complete, result, np.nan)


def _depth_from_force(F: Array, a: Array, h: Array, E_star: Array) -> Array:
    complete = _minimum_force(a, h, E_star) * (1.0 - 1e-15) <= F
    result = F / (2 * E_star * a) - 8 * h / 15
    return np.where(complete, result, np.nan)


def _stiffness(a: Array, E_star: Array) -> Array:
    return 2 * E_star * a


def _pressure(r: Array, d: Array, a: Array, h: Array, E_star: Array) -> Array:
    root = np.sqrt((a - r) * (a + r))
    face = 4 * h * (2 * r - a) ** 2 * (a + 2 * r) ** 2 / (9 * a**4)
    complete = _minimum_depth(h) * (1.0 - 1e-15) <= d
    result = np.where((r <= a) & (d > 0.0), E_star / np.pi * (d - _minimum_depth(h) + face) / root, 0.0)
    return np.where(complete, result, np.nan)


def _displacement(r: Array, d: Array, a: Array, h: Array) -> Array:
    angle = np.arctan2(a, np.sqrt((r - a) * (r + a)))
    outside = 2 / np.pi * (d * angle + 8 * h / 3 * power_punches(r, a, 4))
    inside = d - _profile(r, a, h)
    complete = _minimum_depth(h) * (1.0 - 1e-15) <= d
    result = np.where(r > a, outside, inside)
    return np.where(complete, result, np.nan)


def _energy(d: Array, a: Array, h: Array, E_star: Array) -> Array:
    complete = _minimum_depth(h) * (1.0 - 1e-15) <= d
    result = E_star * (d**2 * a + 16 * h / 15 * d * a + 64 * h**2 / 81 * a)
    return np.where(complete, result, np.nan)


def _load_within(r: Array, d: Array, a: Array, h: Array, E_star: Array) -> Array:
    root = np.sqrt((a - r) * (a + r))
    rise = r**2 / (a + root)
    face = 4 * h * (5 * a**4 + rise * (rise * (120 * a**2 + rise * (16 * rise - 80 * a)) - 40 * a**3)) / (45 * a**4)
    within = 2 * E_star * rise * (d - _minimum_depth(h) + face)
    complete = _minimum_depth(h) * (1.0 - 1e-15) <= d
    result = np.where(r < a, within, _force(d, a, h, E_star))
    return np.where(complete, result, np.nan)
