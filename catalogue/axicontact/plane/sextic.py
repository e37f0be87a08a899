"""Sextic profile.

Flatter tip than the quartic, and a deeper dip of the pressure in the middle.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.functions import nth_root
from .._runtime.interface import Array, Result, elementwise, require
from .._runtime.physics.plane import even, odd

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["depth", "half_width_from_load", "load", "pressure", "profile", "slope"]


def __dir__() -> list[str]:
    return __all__


def profile(x: ArrayLike, *, A: ArrayLike) -> Result:
    """Profile f(x) of the indenter.

    f = A*x**6

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.

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
    Valid for small slopes, 6 A a^5 << 1. The formula is for x >= 0; the function is even. NaN gives NaN.
    Handbook: plane.sextic.f, the definition of the profile.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import sextic
    >>> value = sextic.profile(0.3, A=0.4)
    >>> round(value, 6)
    0.000292
    """
    require(A=A)
    return even(_profile, x, A=A)


def load(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Line load at half-width a.

    P = 15*pi*A*E_star*a**6/16

    Parameters
    ----------
    a : array_like
        Half-width of the contact [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: plane.sextic.P.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import sextic
    >>> value = sextic.load(1.0, A=0.4, E_star=1.0)
    >>> round(value, 6)
    1.178097
    """
    require(A=A, E_star=E_star)
    return elementwise(_load, a, A=A, E_star=E_star)


def pressure(x: ArrayLike, a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = 3*A*E_star*sqrt(a**2 - x**2)*(3*a**4 + 4*a**2*x**2 + 8*x**4)/8

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    a : array_like
        Half-width of the contact [m].
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
    Valid for small slopes, 6 A a^5 << 1. The formula is for x >= 0; the function is even. Negative a and NaN
    give NaN. Handbook: plane.sextic.p.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import sextic
    >>> value = sextic.pressure(0.3, 1.0, A=0.4, E_star=1.0)
    >>> round(value, 6)
    0.490058
    """
    require(A=A, E_star=E_star)
    return even(_pressure, x, a, A=A, E_star=E_star)


def slope(x: ArrayLike, a: ArrayLike, *, A: ArrayLike) -> Result:
    """Slope dw/dx of the surface, inside and outside the contact.

    dw/dx = 3*A*(-2*x**5 + sqrt(-a**2 + x**2)*(3*a**4 + 4*a**2*x**2 + 8*x**4)/4)
    and dw/dx = -f'(x) in the contact.

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    a : array_like
        Half-width of the contact [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.

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
    Valid for small slopes, 6 A a^5 << 1. The formula is for x >= 0; the function is odd. Negative a and NaN
    give NaN. Handbook: plane.sextic.s.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import sextic
    >>> value = sextic.slope(2.0, 1.0, A=0.4)
    >>> round(value, 6)
    -0.416559
    """
    require(A=A)
    return odd(_slope, x, a, A=A)


def depth(L: ArrayLike, a: ArrayLike, *, A: ArrayLike) -> Result:
    """Indentation depth relative to the surface at the distance L.

    d = A*(L**6 - L*sqrt(L**2 - a**2)*(8*L**4 + 4*L**2*a**2 + 3*a**4)/8 + 15*a**6*acosh(L/a)/8)

    Parameters
    ----------
    L : array_like
        Distance of the reference point from the middle of the contact [m].
    a : array_like
        Half-width of the contact [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.

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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values, and points in the contact, L < a, give
    NaN. Handbook: plane.sextic.d.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import sextic
    >>> value = sextic.depth(10.0, 1.0, A=0.4)
    >>> round(value, 6)
    2.370389
    """
    require(A=A)
    return elementwise(_depth, L, a, A=A)


def half_width_from_load(P: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Half-width of the contact under the line load P.

    a = 15**(5/6)*2**(2/3)*P**(1/6)/(15*pi**(1/6)*A**(1/6)*E_star**(1/6))

    Parameters
    ----------
    P : array_like
        Line load, force per length of the strip of contact [N/m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: plane.sextic.aP.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import sextic
    >>> value = sextic.half_width_from_load(1.178, A=0.4, E_star=1.0)
    >>> round(value, 6)
    0.999986
    """
    require(A=A, E_star=E_star)
    return elementwise(_half_width_from_load, P, A=A, E_star=E_star)


def _profile(x: Array, A: Array) -> Array:
    return A * x**6


def _profile_slope(x: Array, A: Array) -> Array:
    """Slope f'(x) of the profile."""
    return 6 * A * x**5


def _load(a: Array, A: Array, E_star: Array) -> Array:
    return 15 * np.pi * E_star * A * a**6 / 16


def _pressure(x: Array, a: Array, A: Array, E_star: Array) -> Array:
    root = np.sqrt((a - x) * (a + x))
    value = 3 * E_star * A * (3 * a**4 + 4 * a**2 * x**2 + 8 * x**4) * root / 8
    return np.where(x < a, value, 0.0)


def _slope(x: Array, a: Array, A: Array) -> Array:
    root = np.sqrt((x - a) * (a + x))
    conjugate = 8 * x**4 * root + 3 * a**4 * root + 4 * a**2 * x**2 * root + 8 * x**5
    value = -3 * A * a**6 * (9 * a**4 + 15 * a**2 * x**2 + 40 * x**4) / (4 * conjugate)
    return np.where(x > a, value, -_profile_slope(x, A))


def _depth(L: Array, a: Array, A: Array) -> Array:
    root = np.sqrt((L - a) * (a + L))
    conjugate = 8 * L**5 + (3 * a**4 + 8 * L**4 + 4 * a**2 * L**2) * root
    plus = 15 * np.arcsinh(root / a) + L * (9 * a**4 + 40 * L**4 + 15 * a**2 * L**2) / conjugate
    value = A * a**6 * plus / 8
    value = np.where(a > 0.0, value, 0.0)
    return np.where(a <= L, value, np.nan)


def _half_width_from_load(P: Array, A: Array, E_star: Array) -> Array:
    return nth_root(16 * P / (15 * np.pi * E_star * A), 6)
