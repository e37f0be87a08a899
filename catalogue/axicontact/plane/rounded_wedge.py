"""Wedge with a rounded tip.

Parabolic tip running tangentially into straight flanks at x = b.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, require
from .._runtime.inverse import inverse
from .._runtime.physics.plane import depth_beyond, even, odd, slope_beyond
from .._runtime.rules import pressure_integral_beyond

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["depth", "half_width_from_load", "load", "pressure", "profile", "slope"]


def __dir__() -> list[str]:
    return __all__


def profile(x: ArrayLike, *, theta: ArrayLike, b: ArrayLike) -> Result:
    """Profile f(x) of the indenter.

    f = x**2*tan(theta)/(2*b)   for 0 < x < b
    f = (-b/2 + x)*tan(theta)   for b < x

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Half-width of the rounded tip [m], b > 0.

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
    Valid for tan(theta) << 1. The formula is for x >= 0; the function is even. NaN gives NaN. Handbook:
    plane.rounded_wedge.f, the definition of the profile.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import rounded_wedge
    >>> value = rounded_wedge.profile(0.3, theta=0.42, b=0.5)
    >>> round(value, 6)
    0.040192
    """
    require(theta=theta, b=b)
    return even(_profile, x, theta=theta, b=b)


def load(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Line load at half-width a.

    P = pi*E_star*a**2*tan(theta)/(4*b)   for a < b
    P = E_star*(a**2*asin(b/a)/b + sqrt(a**2 - b**2))*tan(theta)/2   for b < a

    Parameters
    ----------
    a : array_like
        Half-width of the contact [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Half-width of the rounded tip [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: plane.rounded_wedge.P.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import rounded_wedge
    >>> value = rounded_wedge.load(1.0, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.427196
    """
    require(theta=theta, b=b, E_star=E_star)
    return elementwise(_load, a, theta=theta, b=b, E_star=E_star)


def pressure(x: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = E_star*sqrt(a**2 - x**2)*tan(theta)/(2*b)   for a < b
    p = E_star*(atanh(sqrt(a**2 - b**2)/sqrt(a**2 - x**2)) - x*atanh(x*sqrt(a**2 - b**2)/(b*sqrt(a**2 -
    x**2)))/b + sqrt(a**2 - x**2)*asin(b/a)/b)*tan(theta)/pi   for x < b and b < a
    p = E_star*(atanh(sqrt(a**2 - x**2)/sqrt(a**2 - b**2)) - x*atanh(b*sqrt(a**2 - x**2)/(x*sqrt(a**2 -
    b**2)))/b + sqrt(a**2 - x**2)*asin(b/a)/b)*tan(theta)/pi   for b < x

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    a : array_like
        Half-width of the contact [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Half-width of the rounded tip [m], b > 0.
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
    Valid for tan(theta) << 1. The formula is for x >= 0; the function is even. Negative a and NaN give NaN.
    Evaluated as an integral over the growing contact by a Gauss-Legendre rule. Handbook:
    plane.rounded_wedge.p.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import rounded_wedge
    >>> value = rounded_wedge.pressure(0.3, 1.0, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.305275
    """
    require(theta=theta, b=b, E_star=E_star)
    return even(_pressure, x, a, theta=theta, b=b, E_star=E_star)


def slope(x: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike) -> Result:
    """Slope dw/dx of the surface, inside and outside the contact.

    dw/dx = (-x + sqrt(-a**2 + x**2))*tan(theta)/b   for a < b
    dw/dx = 2*(-asin(sqrt(a**2 - b**2)/sqrt(-b**2 + x**2)) - x*asin(b*sqrt(-a**2 + x**2)/(a*sqrt(-b**2 +
    x**2)))/b + sqrt(-a**2 + x**2)*asin(b/a)/b)*tan(theta)/pi   for b < a
    and dw/dx = -f'(x) in the contact.

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    a : array_like
        Half-width of the contact [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Half-width of the rounded tip [m], b > 0.

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
    Valid for tan(theta) << 1. The formula is for x >= 0; the function is odd. Negative a and NaN give NaN.
    Evaluated as an integral over the growing contact by a Gauss-Legendre rule. Handbook:
    plane.rounded_wedge.s.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import rounded_wedge
    >>> value = rounded_wedge.slope(2.0, 1.0, theta=0.42, b=0.5)
    >>> round(value, 6)
    -0.14341
    """
    require(theta=theta, b=b)
    return odd(_slope, x, a, theta=theta, b=b)


def depth(L: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike) -> Result:
    """Indentation depth relative to the surface at the distance L.

    d = (L**2 - L*sqrt(L**2 - a**2) + a**2*acosh(L/a))*tan(theta)/(2*b)   for a < b
    d = (L**2*asin(b*sqrt(L**2 - a**2)/(a*sqrt(L**2 - b**2)))/b + 2*L*asin(sqrt(a**2 - b**2)/sqrt(L**2 -
    b**2)) - L*sqrt(L**2 - a**2)*asin(b/a)/b + a**2*acosh(L/a)*asin(b/a)/b - b*acos(b*sqrt(L**2 -
    a**2)/(a*sqrt(L**2 - b**2))) + sqrt(a**2 - b**2)*acosh(L/a))*tan(theta)/pi   for b < a

    Parameters
    ----------
    L : array_like
        Distance of the reference point from the middle of the contact [m].
    a : array_like
        Half-width of the contact [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Half-width of the rounded tip [m], b > 0.

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
    Valid for tan(theta) << 1. Negative or NaN field values, and points in the contact, L < a, give NaN.
    Evaluated as an integral over the growing contact by a Gauss-Legendre rule. Handbook:
    plane.rounded_wedge.d.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import rounded_wedge
    >>> value = rounded_wedge.depth(10.0, 1.0, theta=0.42, b=0.5)
    >>> round(value, 6)
    0.999117
    """
    require(theta=theta, b=b)
    return elementwise(_depth, L, a, theta=theta, b=b)


def half_width_from_load(P: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Half-width of the contact under the line load P.

    a from pi*E_star*a**2*tan(theta)/(4*b) = P   for a < b
    a from E_star*(a**2*asin(b/a)/b + sqrt(a**2 - b**2))*tan(theta)/2 = P   for b < a

    Parameters
    ----------
    P : array_like
        Line load, force per length of the strip of contact [N/m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Half-width of the rounded tip [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: plane.rounded_wedge.aP.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import rounded_wedge
    >>> value = rounded_wedge.half_width_from_load(0.4272, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    1.000008
    """
    require(theta=theta, b=b, E_star=E_star)
    return elementwise(_half_width_from_load, P, theta=theta, b=b, E_star=E_star)


def _profile(x: Array, theta: Array, b: Array) -> Array:
    return np.where(x > b, np.tan(theta) * (x - b / 2), np.tan(theta) / (2 * b) * x**2)


def _profile_slope(x: Array, theta: Array, b: Array) -> Array:
    """Slope f'(x) of the profile."""
    return np.where(x > b, np.tan(theta), np.tan(theta) / b * x)


def _growth(t: Array, theta: Array, b: Array) -> Array:
    """Growth P'(t)/E_star of the line load."""
    return np.pi * np.tan(theta) / (2 * b) * t


def _growth_beyond(t: Array, root: Array, theta: Array, b: Array) -> Array:
    """Growth P'(t)/E_star of the line load for t > b."""
    angle = np.arctan(b / root)
    return np.tan(theta) / b * t * angle


def _load(a: Array, theta: Array, b: Array, E_star: Array) -> Array:
    below = np.pi * E_star * np.tan(theta) / (4 * b) * a**2
    root = np.sqrt((a - b) * (a + b))
    angle = np.arctan(b / root)
    above = E_star * np.tan(theta) * (root + a**2 * angle / b) / 2
    return np.where(a < b, below, above)


def _pressure(x: Array, a: Array, theta: Array, b: Array, E_star: Array) -> Array:
    inner = np.minimum(a, b)
    root = np.sqrt((inner - x) * (inner + x))
    tip = E_star * np.tan(theta) / (2 * b) * root
    beyond = pressure_integral_beyond(_growth_beyond, (theta, b), x, a, b)
    value = np.where(x < inner, tip, 0.0) + E_star / np.pi * beyond
    return np.where(x < a, value, 0.0)


def _slope(x: Array, a: Array, theta: Array, b: Array) -> Array:
    inner = np.minimum(a, b)
    root = np.sqrt((x - inner) * (inner + x))
    conjugate = root + x
    tip = -np.tan(theta) * inner**2 / (b * conjugate)
    beyond = slope_beyond(_growth_beyond, (theta, b), x, a, b)
    value = tip - 2 / np.pi * beyond
    return np.where(x > a, value, -_profile_slope(x, theta, b))


def _depth(L: Array, a: Array, theta: Array, b: Array) -> Array:
    inner = np.minimum(a, b)
    root = np.sqrt((L - inner) * (inner + L))
    tip = np.tan(theta) / (2 * b) * inner**2 * (L / (root + L) + np.log1p((L - inner + root) / inner))
    beyond = depth_beyond(_growth_beyond, (theta, b), L, a, b)
    value = tip + 2 / np.pi * beyond
    value = np.where(a < L, value, _profile(a, theta, b))
    value = np.where(a > 0.0, value, 0.0)
    return np.where(a <= L, value, np.nan)


def _half_width_from_load(P: Array, theta: Array, b: Array, E_star: Array) -> Array:
    def curve(a: Array) -> tuple[Array, Array]:
        root = np.sqrt((a - b) * (a + b))
        growth = np.where(a < b, _growth(a, theta, b), _growth_beyond(a, root, theta, b))
        value = _load(a, theta, b, E_star)
        return value, E_star * a * growth / value

    return inverse(curve, P, np.full_like(P, 0.99 * b), (1.0, 2.0))
