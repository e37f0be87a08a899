"""Concave quartic.

Concave face of fourth order: the pressure vanishes first at x = a/2.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, require
from .._runtime.physics.plane import even, odd

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["depth", "minimum_load", "pressure", "profile", "slope", "zero_distance"]


def __dir__() -> list[str]:
    return __all__


def profile(x: ArrayLike, *, a: ArrayLike, h: ArrayLike) -> Result:
    """Profile f(x) of the indenter.

    f = -h*x**4/a**4

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    a : array_like
        Half-width of the punch [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.

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
    Valid for small slopes; complete contact only. The formula is for x >= 0; the function is even. NaN gives
    NaN. Handbook: plane.concave_quartic.f, the definition of the profile.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import concave_quartic
    >>> value = concave_quartic.profile(0.3, a=1.0, h=0.15)
    >>> round(value, 6)
    -0.001215
    """
    require(a=a, h=h)
    return even(_profile, x, a=a, h=h)


def pressure(x: ArrayLike, P: ArrayLike, *, a: ArrayLike, h: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = -E_star*h*sqrt(a**2 - x**2)*(a**2 + 2*x**2)/a**4 + (3*pi*E_star*h + 4*P)/(4*pi*sqrt(a**2 - x**2))

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    P : array_like
        Line load, force per length of the strip of contact [N/m].
    a : array_like
        Half-width of the punch [m], a > 0.
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
    Valid for small slopes; complete contact only. The formula is for x >= 0; the function is even. Negative P
    and NaN, and loads below minimum_load(), give NaN. Handbook: plane.concave_quartic.p.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import concave_quartic
    >>> value = concave_quartic.pressure(0.3, 1.0, a=1.0, h=0.15, E_star=1.0)
    >>> round(value, 6)
    0.282764
    """
    require(a=a, h=h, E_star=E_star)
    return even(_pressure, x, P, a=a, h=h, E_star=E_star)


def slope(x: ArrayLike, P: ArrayLike, *, a: ArrayLike, h: ArrayLike, E_star: ArrayLike) -> Result:
    """Slope dw/dx of the surface, inside and outside the contact.

    dw/dx = 4*h*x**3/a**4 - 2*h*sqrt(-a**2 + x**2)*(a**2 + 2*x**2)/a**4 - (3*pi*E_star*h +
    4*P)/(2*pi*E_star*sqrt(-a**2 + x**2))
    and dw/dx = -f'(x) in the contact.

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    P : array_like
        Line load, force per length of the strip of contact [N/m].
    a : array_like
        Half-width of the punch [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
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
    Valid for small slopes; complete contact only. The formula is for x >= 0; the function is odd. Negative P
    and NaN, and loads below minimum_load(), give NaN. Handbook: plane.concave_quartic.s.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import concave_quartic
    >>> value = concave_quartic.slope(2.0, 1.0, a=1.0, h=0.15, E_star=1.0)
    >>> round(value, 6)
    -0.373994
    """
    require(a=a, h=h, E_star=E_star)
    return odd(_slope, x, P, a=a, h=h, E_star=E_star)


def depth(L: ArrayLike, P: ArrayLike, *, a: ArrayLike, h: ArrayLike, E_star: ArrayLike) -> Result:
    """Indentation depth relative to the surface at the distance L.

    d = -L**4*h/a**4 + L*h*sqrt(L**2 - a**2)*(2*L**2 + a**2)/(2*a**4) + 2*P*acosh(L/a)/(pi*E_star)

    Parameters
    ----------
    L : array_like
        Distance of the reference point from the middle of the contact [m].
    P : array_like
        Line load, force per length of the strip of contact [N/m].
    a : array_like
        Half-width of the punch [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
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
    Valid for small slopes; complete contact only. Negative or NaN field values, and points in the contact, L
    < a, and loads below minimum_load(), give NaN. Handbook: plane.concave_quartic.d.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import concave_quartic
    >>> value = concave_quartic.depth(10.0, 1.0, a=1.0, h=0.15, E_star=1.0)
    >>> round(value, 6)
    1.849106
    """
    require(a=a, h=h, E_star=E_star)
    return elementwise(_depth, L, P, a=a, h=h, E_star=E_star)


def zero_distance(*, a: ArrayLike, h: ArrayLike) -> Result:
    """Distance from the middle where the pressure first vanishes on unloading.

    x_zero = a/2

    Parameters
    ----------
    a : array_like
        Half-width of the punch [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.

    Returns
    -------
    float or ndarray
        Distance from the middle where the pressure first vanishes on unloading [m]. The shape to which the
        arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes; complete contact only. Handbook: plane.concave_quartic.xz.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import concave_quartic
    >>> value = concave_quartic.zero_distance(a=1.0, h=0.15)
    >>> round(value, 6)
    0.5
    """
    require(a=a, h=h)
    return elementwise(_zero_distance, a=a, unused=(h,))


def minimum_load(*, a: ArrayLike, h: ArrayLike, E_star: ArrayLike) -> Result:
    """Least line load of complete contact.

    P = 3*pi*E_star*h/8

    Parameters
    ----------
    a : array_like
        Half-width of the punch [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
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
    Valid for small slopes; complete contact only. Handbook: plane.concave_quartic.Pmin.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import concave_quartic
    >>> value = concave_quartic.minimum_load(a=1.0, h=0.15, E_star=1.0)
    >>> round(value, 6)
    0.176715
    """
    require(a=a, h=h, E_star=E_star)
    return elementwise(_minimum_load, h=h, E_star=E_star, unused=(a,))


def _profile(x: Array, a: Array, h: Array) -> Array:
    return np.where(x <= a, -h * x**4 / a**4, np.nan)


def _profile_slope(x: Array, a: Array, h: Array) -> Array:
    """Slope f'(x) of the profile."""
    return -4 * h * x**3 / a**4


def _zero_distance(a: Array) -> Array:
    return a / 2


def _minimum_load(h: Array, E_star: Array) -> Array:
    return 3 * np.pi * E_star * h / 8


def _pressure(x: Array, P: Array, a: Array, h: Array, E_star: Array) -> Array:
    root = np.sqrt((a - x) * (a + x))
    face = np.pi * E_star * h * (2 * x - a) ** 2 * (a + 2 * x) ** 2 / (8 * a**4)
    carried = P - _minimum_load(h, E_star) + face
    value = carried / (np.pi * root)
    complete = _minimum_load(h, E_star) * (1.0 - 1e-15) <= P
    result = np.where((x <= a) & (P > 0.0), value, 0.0)
    return np.where(complete, result, np.nan)


def _slope(x: Array, P: Array, a: Array, h: Array, E_star: Array) -> Array:
    root = np.sqrt((x - a) * (a + x))
    strip = -2 * P / (np.pi * E_star * root)
    conjugate = 8 * root**4 + 8 * x**3 * root + 3 * a**4 + 12 * a**2 * root**2
    face = h * a**2 * (a**2 + 8 * x**2) / (2 * conjugate * root)
    value = strip - face
    outside = np.where(P > 0.0, value, 0.0)
    complete = _minimum_load(h, E_star) * (1.0 - 1e-15) <= P
    result = np.where(x >= a, outside, -_profile_slope(x, a, h))
    return np.where(complete, result, np.nan)


def _depth(L: Array, P: Array, a: Array, h: Array, E_star: Array) -> Array:
    root = np.sqrt((L - a) * (a + L))
    strip = 2 * P * np.log1p((L - a + root) / a) / (np.pi * E_star)
    conjugate = a**2 * root + 2 * L**3 + 2 * L**2 * root
    face = h * L * (a**2 + 3 * L**2) / (2 * conjugate)
    value = strip - face
    complete = _minimum_load(h, E_star) * (1.0 - 1e-15) <= P
    result = np.where(a <= L, value, np.nan)
    return np.where(complete, result, np.nan)
