"""Parabola.

Cylinder of radius R in line contact, a << R.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, require
from .._runtime.physics.plane import even, odd

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["depth", "half_width_from_load", "load", "pressure", "profile", "slope"]


def __dir__() -> list[str]:
    return __all__


def profile(x: ArrayLike, *, R: ArrayLike) -> Result:
    """Profile f(x) of the indenter.

    f = x**2/(2*R)

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    R : array_like
        Radius of curvature [m], R > 0.

    Returns
    -------
    float or ndarray
        Height of the profile above its lowest point in the middle [m]. The shape to which the arguments
        broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R. The formula is for x >= 0; the function is even. NaN gives NaN. Handbook:
    plane.parabola.f, the definition of the profile.

    References
    ----------
    Schubert 1942; Johnson 1985.

    Examples
    --------
    >>> from axicontact.plane import parabola
    >>> value = parabola.profile(0.3, R=1.45)
    >>> round(value, 6)
    0.031034
    """
    require(R=R)
    return even(_profile, x, R=R)


def load(a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Line load at half-width a.

    P = pi*E_star*a**2/(4*R)

    Parameters
    ----------
    a : array_like
        Half-width of the contact [m].
    R : array_like
        Radius of curvature [m], R > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Line load, force per length of the strip of contact [N/m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R. Negative or NaN field values give NaN. Handbook: plane.parabola.P.

    References
    ----------
    Schubert 1942; Johnson 1985.

    Examples
    --------
    >>> from axicontact.plane import parabola
    >>> value = parabola.load(1.0, R=1.45, E_star=1.0)
    >>> round(value, 6)
    0.541654
    """
    require(R=R, E_star=E_star)
    return elementwise(_load, a, R=R, E_star=E_star)


def pressure(x: ArrayLike, a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = E_star*sqrt(a**2 - x**2)/(2*R)

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    a : array_like
        Half-width of the contact [m].
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
    Valid for a << R. The formula is for x >= 0; the function is even. Negative a and NaN give NaN. Handbook:
    plane.parabola.p.

    References
    ----------
    Schubert 1942; Johnson 1985.

    Examples
    --------
    >>> from axicontact.plane import parabola
    >>> value = parabola.pressure(0.3, 1.0, R=1.45, E_star=1.0)
    >>> round(value, 6)
    0.328945
    """
    require(R=R, E_star=E_star)
    return even(_pressure, x, a, R=R, E_star=E_star)


def slope(x: ArrayLike, a: ArrayLike, *, R: ArrayLike) -> Result:
    """Slope dw/dx of the surface, inside and outside the contact.

    dw/dx = (-x + sqrt(-a**2 + x**2))/R
    and dw/dx = -f'(x) in the contact.

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    a : array_like
        Half-width of the contact [m].
    R : array_like
        Radius of curvature [m], R > 0.

    Returns
    -------
    float or ndarray
        Slope of the surface, negative where the displacement into the half-space falls with x [1]. The shape
        to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R. The formula is for x >= 0; the function is odd. Negative a and NaN give NaN. Handbook:
    plane.parabola.s.

    References
    ----------
    Schubert 1942; Johnson 1985.

    Examples
    --------
    >>> from axicontact.plane import parabola
    >>> value = parabola.slope(2.0, 1.0, R=1.45)
    >>> round(value, 6)
    -0.184793
    """
    require(R=R)
    return odd(_slope, x, a, R=R)


def depth(L: ArrayLike, a: ArrayLike, *, R: ArrayLike) -> Result:
    """Indentation depth relative to the surface at the distance L.

    d = (L**2 - L*sqrt(L**2 - a**2) + a**2*acosh(L/a))/(2*R)

    Parameters
    ----------
    L : array_like
        Distance of the reference point from the middle of the contact [m].
    a : array_like
        Half-width of the contact [m].
    R : array_like
        Radius of curvature [m], R > 0.

    Returns
    -------
    float or ndarray
        Depth of the middle of the contact relative to the surface at the distance L [m]. The shape to which
        the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R. Negative or NaN field values, and points in the contact, L < a, give NaN. Handbook:
    plane.parabola.d.

    References
    ----------
    Schubert 1942; Johnson 1985.

    Examples
    --------
    >>> from axicontact.plane import parabola
    >>> value = parabola.depth(10.0, 1.0, R=1.45)
    >>> round(value, 6)
    1.204993
    """
    require(R=R)
    return elementwise(_depth, L, a, R=R)


def half_width_from_load(P: ArrayLike, *, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Half-width of the contact under the line load P.

    a = 2*sqrt(P)*sqrt(R)/(sqrt(pi)*sqrt(E_star))

    Parameters
    ----------
    P : array_like
        Line load, force per length of the strip of contact [N/m].
    R : array_like
        Radius of curvature [m], R > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Half-width of the contact [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R. Negative or NaN field values give NaN. Handbook: plane.parabola.aP.

    References
    ----------
    Schubert 1942; Johnson 1985.

    Examples
    --------
    >>> from axicontact.plane import parabola
    >>> value = parabola.half_width_from_load(0.5417, R=1.45, E_star=1.0)
    >>> round(value, 6)
    1.000043
    """
    require(R=R, E_star=E_star)
    return elementwise(_half_width_from_load, P, R=R, E_star=E_star)


def _profile(x: Array, R: Array) -> Array:
    return x**2 / (2 * R)


def _profile_slope(x: Array, R: Array) -> Array:
    """Slope f'(x) of the profile."""
    return x / R


def _load(a: Array, R: Array, E_star: Array) -> Array:
    return np.pi * E_star / (4 * R) * a**2


def _pressure(x: Array, a: Array, R: Array, E_star: Array) -> Array:
    root = np.sqrt((a - x) * (a + x))
    value = E_star / (2 * R) * root
    return np.where(x < a, value, 0.0)


def _slope(x: Array, a: Array, R: Array) -> Array:
    root = np.sqrt((x - a) * (a + x))
    conjugate = root + x
    value = -(a**2) / (R * conjugate)
    return np.where(x > a, value, -_profile_slope(x, R))


def _depth(L: Array, a: Array, R: Array) -> Array:
    root = np.sqrt((L - a) * (a + L))
    value = a**2 * (L / (root + L) + np.log1p((L - a + root) / a)) / (2 * R)
    value = np.where(a > 0.0, value, 0.0)
    return np.where(a <= L, value, np.nan)


def _half_width_from_load(P: Array, R: Array, E_star: Array) -> Array:
    return np.sqrt(4 * R / (np.pi * E_star) * P)
