"""Quartic profile.

Vanishing curvature at the tip: the pressure has a dip in the middle.
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


def profile(x: ArrayLike, *, A: ArrayLike) -> Result:
    """Profile f(x) of the indenter.

    f = A*x**4

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
    Valid for small slopes, 4 A a^3 << 1. The formula is for x >= 0; the function is even. NaN gives NaN.
    Handbook: plane.quartic.f, the definition of the profile.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import quartic
    >>> value = quartic.profile(0.3, A=0.4)
    >>> round(value, 6)
    0.00324
    """
    require(A=A)
    return even(_profile, x, A=A)


def load(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Line load at half-width a.

    P = 3*pi*A*E_star*a**4/4

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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: plane.quartic.P.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import quartic
    >>> value = quartic.load(1.0, A=0.4, E_star=1.0)
    >>> round(value, 6)
    0.942478
    """
    require(A=A, E_star=E_star)
    return elementwise(_load, a, A=A, E_star=E_star)


def pressure(x: ArrayLike, a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = A*E_star*sqrt(a**2 - x**2)*(a**2 + 2*x**2)

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
    Valid for small slopes, 4 A a^3 << 1. The formula is for x >= 0; the function is even. Negative a and NaN
    give NaN. Handbook: plane.quartic.p.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import quartic
    >>> value = quartic.pressure(0.3, 1.0, A=0.4, E_star=1.0)
    >>> round(value, 6)
    0.450259
    """
    require(A=A, E_star=E_star)
    return even(_pressure, x, a, A=A, E_star=E_star)


def slope(x: ArrayLike, a: ArrayLike, *, A: ArrayLike) -> Result:
    """Slope dw/dx of the surface, inside and outside the contact.

    dw/dx = 2*A*(-2*x**3 + sqrt(-a**2 + x**2)*(a**2 + 2*x**2))
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
    Valid for small slopes, 4 A a^3 << 1. The formula is for x >= 0; the function is odd. Negative a and NaN
    give NaN. Handbook: plane.quartic.s.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import quartic
    >>> value = quartic.slope(2.0, 1.0, A=0.4)
    >>> round(value, 6)
    -0.329234
    """
    require(A=A)
    return odd(_slope, x, a, A=A)


def depth(L: ArrayLike, a: ArrayLike, *, A: ArrayLike) -> Result:
    """Indentation depth relative to the surface at the distance L.

    d = A*(L**4 - L*sqrt(L**2 - a**2)*(2*L**2 + a**2)/2 + 3*a**4*acosh(L/a)/2)

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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values, and points in the contact, L < a, give
    NaN. Handbook: plane.quartic.d.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import quartic
    >>> value = quartic.depth(10.0, 1.0, A=0.4)
    >>> round(value, 6)
    1.946437
    """
    require(A=A)
    return elementwise(_depth, L, a, A=A)


def half_width_from_load(P: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Half-width of the contact under the line load P.

    a = sqrt(2)*3**(3/4)*P**(1/4)/(3*pi**(1/4)*A**(1/4)*E_star**(1/4))

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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: plane.quartic.aP.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import quartic
    >>> value = quartic.half_width_from_load(0.9425, A=0.4, E_star=1.0)
    >>> round(value, 6)
    1.000006
    """
    require(A=A, E_star=E_star)
    return elementwise(_half_width_from_load, P, A=A, E_star=E_star)


def _profile(x: Array, A: Array) -> Array:
    return A * x**4


def _profile_slope(x: Array, A: Array) -> Array:
    """Slope f'(x) of the profile."""
    return 4 * A * x**3


def _load(a: Array, A: Array, E_star: Array) -> Array:
    return 3 * np.pi * E_star * A * a**4 / 4


def _pressure(x: Array, a: Array, A: Array, E_star: Array) -> Array:
    root = np.sqrt((a - x) * (a + x))
    value = E_star * A * (a**2 + 2 * x**2) * root
    return np.where(x < a, value, 0.0)


def _slope(x: Array, a: Array, A: Array) -> Array:
    root = np.sqrt((x - a) * (a + x))
    conjugate = 2 * x**2 * root + a**2 * root + 2 * x**3
    value = -2 * A * a**4 * (a**2 + 3 * x**2) / conjugate
    return np.where(x > a, value, -_profile_slope(x, A))


def _depth(L: Array, a: Array, A: Array) -> Array:
    root = np.sqrt((L - a) * (a + L))
    conjugate = 2 * L**3 + (a**2 + 2 * L**2) * root
    value = A * a**4 * (3 * np.arcsinh(root / a) + L * (a**2 + 3 * L**2) / conjugate) / 2
    value = np.where(a > 0.0, value, 0.0)
    return np.where(a <= L, value, np.nan)


def _half_width_from_load(P: Array, A: Array, E_star: Array) -> Array:
    return np.sqrt(np.sqrt(4 * P / (3 * np.pi * E_star * A)))
