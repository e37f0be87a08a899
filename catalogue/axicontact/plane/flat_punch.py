"""Flat punch.

The flat strip: every other plane contact is a superposition of flat strips.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, require
from .._runtime.physics.plane import even, odd

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["depth", "pressure", "profile", "slope"]


def __dir__() -> list[str]:
    return __all__


def profile(x: ArrayLike, *, a: ArrayLike) -> Result:
    """Profile f(x) of the indenter.

    f = 0

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    a : array_like
        Half-width of the punch [m], a > 0.

    Returns
    -------
    float or ndarray
        Height of the face [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for sharp edges, frictionless, load in the middle. The formula is for x >= 0; the function is even.
    NaN gives NaN. Handbook: plane.flat_punch.f, the definition of the profile.

    References
    ----------
    Sadowsky 1928; Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import flat_punch
    >>> value = flat_punch.profile(0.3, a=1.0)
    >>> round(value, 6)
    0.0
    """
    require(a=a)
    return even(_profile, x, a=a)


def pressure(x: ArrayLike, P: ArrayLike, *, a: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = P/(pi*sqrt(a**2 - x**2))

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    P : array_like
        Line load, force per length of the strip of contact [N/m].
    a : array_like
        Half-width of the punch [m], a > 0.

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
    Valid for sharp edges, frictionless, load in the middle. The formula is for x >= 0; the function is even.
    Negative P and NaN give NaN. The pressure is infinite at the edges. Handbook: plane.flat_punch.p.

    References
    ----------
    Sadowsky 1928; Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import flat_punch
    >>> value = flat_punch.pressure(0.3, 1.0, a=1.0)
    >>> round(value, 6)
    0.333679
    """
    require(a=a)
    return even(_pressure, x, P, a=a)


def slope(x: ArrayLike, P: ArrayLike, *, a: ArrayLike, E_star: ArrayLike) -> Result:
    """Slope dw/dx of the surface, inside and outside the contact.

    dw/dx = -2*P/(pi*E_star*sqrt(-a**2 + x**2))
    and dw/dx = -f'(x) in the contact.

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    P : array_like
        Line load, force per length of the strip of contact [N/m].
    a : array_like
        Half-width of the punch [m], a > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

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
    Valid for sharp edges, frictionless, load in the middle. The formula is for x >= 0; the function is odd.
    Negative P and NaN give NaN. Handbook: plane.flat_punch.s.

    References
    ----------
    Sadowsky 1928; Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import flat_punch
    >>> value = flat_punch.slope(2.0, 1.0, a=1.0, E_star=1.0)
    >>> round(value, 6)
    -0.367553
    """
    require(a=a, E_star=E_star)
    return odd(_slope, x, P, a=a, E_star=E_star)


def depth(L: ArrayLike, P: ArrayLike, *, a: ArrayLike, E_star: ArrayLike) -> Result:
    """Indentation depth relative to the surface at the distance L.

    d = 2*P*acosh(L/a)/(pi*E_star)

    Parameters
    ----------
    L : array_like
        Distance of the reference point from the middle of the contact [m].
    P : array_like
        Line load, force per length of the strip of contact [N/m].
    a : array_like
        Half-width of the punch [m], a > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

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
    Valid for sharp edges, frictionless, load in the middle. Negative or NaN field values, and points in the
    contact, L < a, give NaN. Handbook: plane.flat_punch.d.

    References
    ----------
    Sadowsky 1928; Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import flat_punch
    >>> value = flat_punch.depth(10.0, 1.0, a=1.0, E_star=1.0)
    >>> round(value, 6)
    1.905545
    """
    require(a=a, E_star=E_star)
    return elementwise(_depth, L, P, a=a, E_star=E_star)


def _profile(x: Array, a: Array) -> Array:
    return np.where(x <= a, np.zeros_like(x), np.nan)


def _pressure(x: Array, P: Array, a: Array) -> Array:
    root = np.sqrt((a - x) * (a + x))
    value = P / (np.pi * root)
    return np.where((x <= a) & (P > 0.0), value, 0.0)


def _slope(x: Array, P: Array, a: Array, E_star: Array) -> Array:
    root = np.sqrt((x - a) * (a + x))
    value = -2 * P / (np.pi * E_star * root)
    outside = np.where(P > 0.0, value, 0.0)
    return np.where(x >= a, outside, 0.0)


def _depth(L: Array, P: Array, a: Array, E_star: Array) -> Array:
    root = np.sqrt((L - a) * (a + L))
    value = 2 * P * np.log1p((L - a + root) / a) / (np.pi * E_star)
    return np.where(a <= L, value, np.nan)
