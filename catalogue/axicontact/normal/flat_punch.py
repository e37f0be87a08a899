"""Flat punch.

The elementary building block: every other contact is a superposition of flat punches.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Plain, Result, elementwise, require

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["depth_from_force", "displacement", "energy", "force", "load_within", "pressure", "profile", "stiffness"]


def __dir__() -> list[str]:
    return __all__


plain = Plain(__name__, __all__)


def profile(r: ArrayLike, *, a: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = 0

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m], a > 0.

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
    Valid for sharp edge, frictionless. Negative or NaN field values give NaN. Handbook: flat_punch.f, the
    definition of the profile.

    References
    ----------
    Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import flat_punch
    >>> value = flat_punch.profile(0.3, a=1.0)
    >>> round(value, 6)
    0.0
    """
    value = plain.profile(r, a)
    if value is not None:
        return value
    require(a=a)
    return elementwise(_profile, r, a=a)


def force(d: ArrayLike, *, a: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force.

    F = 2*E_star*a*d

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
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
    Valid for sharp edge, frictionless. Negative or NaN field values give NaN. The pressure is infinite at the
    edge. Handbook: flat_punch.F.

    References
    ----------
    chapter 11, equation (11.13); chapter 11, equation (11.20); Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import flat_punch
    >>> value = flat_punch.force(0.25, a=1.0, E_star=1.0)
    >>> round(value, 6)
    0.5
    """
    value = plain.force(d, a, E_star)
    if value is not None:
        return value
    require(a=a, E_star=E_star)
    return elementwise(_force, d, a=a, E_star=E_star)


def pressure(r: ArrayLike, d: ArrayLike, *, a: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = E_star*d/(pi*sqrt(a**2 - r**2))

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
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
    Valid for sharp edge, frictionless. Negative or NaN field values give NaN. The pressure is infinite at the
    edge. Handbook: flat_punch.p.

    References
    ----------
    chapter 11, equation (11.15); chapter 11, equation (11.107); Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import flat_punch
    >>> value = flat_punch.pressure(0.3, 0.25, a=1.0, E_star=1.0)
    >>> round(value, 6)
    0.08342
    """
    value = plain.pressure(r, d, a, E_star)
    if value is not None:
        return value
    require(a=a, E_star=E_star)
    return elementwise(_pressure, r, d, a=a, E_star=E_star)


def displacement(r: ArrayLike, d: ArrayLike, *, a: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*d*asin(a/r)/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.

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
    Valid for sharp edge, frictionless. Negative or NaN field values give NaN. Handbook: flat_punch.w.

    References
    ----------
    chapter 11, equation (11.12); chapter 11, equation (11.105); Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import flat_punch
    >>> value = flat_punch.displacement(2.0, 0.25, a=1.0)
    >>> round(value, 6)
    0.083333
    """
    value = plain.displacement(r, d, a)
    if value is not None:
        return value
    require(a=a)
    return elementwise(_displacement, r, d, a=a)


def stiffness(*, a: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*E_star*a

    Parameters
    ----------
    a : array_like
        Contact radius [m], a > 0.
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
    Valid for sharp edge, frictionless. Negative or NaN field values give NaN. Handbook: flat_punch.k.

    References
    ----------
    chapter 11, equation (11.14); Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import flat_punch
    >>> value = flat_punch.stiffness(a=1.0, E_star=1.0)
    >>> round(value, 6)
    2.0
    """
    value = plain.stiffness(a, E_star)
    if value is not None:
        return value
    require(a=a, E_star=E_star)
    return elementwise(_stiffness, a=a, E_star=E_star)


def depth_from_force(F: ArrayLike, *, a: ArrayLike, E_star: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = F/(2*E_star*a)

    Parameters
    ----------
    F : array_like
        Normal force [N].
    a : array_like
        Contact radius [m], a > 0.
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
    Valid for sharp edge, frictionless. Negative or NaN field values give NaN. Handbook: flat_punch.dF.

    References
    ----------
    chapter 11, equation (11.14); chapter 11, equation (11.20); Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import flat_punch
    >>> value = flat_punch.depth_from_force(0.5, a=1.0, E_star=1.0)
    >>> round(value, 6)
    0.25
    """
    value = plain.depth_from_force(F, a, E_star)
    if value is not None:
        return value
    require(a=a, E_star=E_star)
    return elementwise(_depth_from_force, F, a=a, E_star=E_star)


def energy(d: ArrayLike, *, a: ArrayLike, E_star: ArrayLike) -> Result:
    """Elastic energy, the work of pressing the indenter in.

    U = E_star*a*d**2

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
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
    Valid for sharp edge, frictionless. Negative or NaN field values give NaN. Handbook: flat_punch.U.

    References
    ----------
    Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import flat_punch
    >>> value = flat_punch.energy(0.25, a=1.0, E_star=1.0)
    >>> round(value, 6)
    0.0625
    """
    value = plain.energy(d, a, E_star)
    if value is not None:
        return value
    require(a=a, E_star=E_star)
    return elementwise(_energy, d, a=a, E_star=E_star)


def load_within(r: ArrayLike, d: ArrayLike, *, a: ArrayLike, E_star: ArrayLike) -> Result:
    """Part of the normal force that is carried within the radius r; all of it beyond the contact.

    F_r = 2*E_star*d*(a - sqrt(a**2 - r**2))

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
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
    Valid for sharp edge, frictionless. Negative or NaN field values give NaN. Handbook: flat_punch.Fr.

    References
    ----------
    Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import flat_punch
    >>> value = flat_punch.load_within(0.3, 0.25, a=1.0, E_star=1.0)
    >>> round(value, 6)
    0.02303
    """
    value = plain.load_within(r, d, a, E_star)
    if value is not None:
        return value
    require(a=a, E_star=E_star)
    return elementwise(_load_within, r, d, a=a, E_star=E_star)


def _profile(r: Array, a: Array) -> Array:
    return np.where(r <= a, 0, np.nan)


def _force(d: Array, a: Array, E_star: Array) -> Array:
    return 2 * E_star * d * a


def _depth_from_force(F: Array, a: Array, E_star: Array) -> Array:
    return F / (2 * E_star * a)


def _stiffness(a: Array, E_star: Array) -> Array:
    return 2 * E_star * a


def _pressure(r: Array, d: Array, a: Array, E_star: Array) -> Array:
    root = np.sqrt((a - r) * (a + r))
    return np.where((r <= a) & (d > 0.0), E_star * d / (np.pi * root), 0.0)


def _displacement(r: Array, d: Array, a: Array) -> Array:
    root = np.sqrt((r - a) * (a + r))
    angle = np.arctan(a / root)
    outside = 2 * d * angle / np.pi
    inside = d - _profile(r, a)
    return np.where(r > a, outside, inside)


def _energy(d: Array, a: Array, E_star: Array) -> Array:
    return E_star * d**2 * a


def _load_within(r: Array, d: Array, a: Array, E_star: Array) -> Array:
    root = np.sqrt((a - r) * (a + r))
    within = 2 * E_star * d * r**2 / (root + a)
    return np.where(r < a, within, _force(d, a, E_star))
