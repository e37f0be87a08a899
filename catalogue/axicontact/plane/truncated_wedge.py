"""Truncated wedge.

Flat face of half-width b with straight flanks. The half-width of the contact starts at b.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, require, require_reach
from .._runtime.physics.plane import depth_beyond, even, odd

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["depth", "half_width_from_load", "load", "pressure", "profile", "slope"]


def __dir__() -> list[str]:
    return __all__


def profile(x: ArrayLike, *, theta: ArrayLike, b: ArrayLike) -> Result:
    """Profile f(x) of the indenter.

    f = 0   for 0 < x < b
    f = (-b + x)*tan(theta)   for b < x

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Half-width of the flat face [m], b > 0.

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
    plane.truncated_wedge.f, the definition of the profile.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import truncated_wedge
    >>> value = truncated_wedge.profile(0.3, theta=0.42, b=0.5)
    >>> round(value, 6)
    0.0
    """
    require(theta=theta, b=b)
    return even(_profile, x, theta=theta, b=b)


def load(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Line load at half-width a.

    P = E_star*sqrt(a**2 - b**2)*tan(theta)

    Parameters
    ----------
    a : array_like
        Half-width of the contact [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Half-width of the flat face [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN field values, and half-widths below b among larger ones, give
    NaN. Handbook: plane.truncated_wedge.P.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import truncated_wedge
    >>> value = truncated_wedge.load(1.0, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.386743
    """
    require(theta=theta, b=b, E_star=E_star)
    require_reach(a, b, "plane.flat_punch")
    return elementwise(_load, a, theta=theta, b=b, E_star=E_star)


def pressure(x: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = E_star*tan(theta)*atanh(sqrt(a**2 - b**2)/sqrt(a**2 - x**2))/pi   for x < b
    p = E_star*tan(theta)*atanh(sqrt(a**2 - x**2)/sqrt(a**2 - b**2))/pi   for b < x

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    a : array_like
        Half-width of the contact [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Half-width of the flat face [m], b > 0.
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
    Valid for tan(theta) << 1. The formula is for x >= 0; the function is even. Negative a and NaN, and
    half-widths below b among larger ones, give NaN. The pressure is logarithmically infinite at the corner x
    = b; from the general solution of Schubert. Handbook: plane.truncated_wedge.p.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import truncated_wedge
    >>> value = truncated_wedge.pressure(0.3, 1.0, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.21537
    """
    require(theta=theta, b=b, E_star=E_star)
    require_reach(a, b, "plane.flat_punch")
    return even(_pressure, x, a, theta=theta, b=b, E_star=E_star)


def slope(x: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike) -> Result:
    """Slope dw/dx of the surface, inside and outside the contact.

    dw/dx = -2*tan(theta)*asin(sqrt(a**2 - b**2)/sqrt(-b**2 + x**2))/pi
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
        Half-width of the flat face [m], b > 0.

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
    Valid for tan(theta) << 1. The formula is for x >= 0; the function is odd. Negative a and NaN, and
    half-widths below b among larger ones, give NaN. Handbook: plane.truncated_wedge.s.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import truncated_wedge
    >>> value = truncated_wedge.slope(2.0, 1.0, theta=0.42, b=0.5)
    >>> round(value, 6)
    -0.131814
    """
    require(theta=theta, b=b)
    require_reach(a, b, "plane.flat_punch")
    return odd(_slope, x, a, theta=theta, b=b)


def depth(L: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike) -> Result:
    """Indentation depth relative to the surface at the distance L.

    d = 2*(L*asin(sqrt(a**2 - b**2)/sqrt(L**2 - b**2)) - b*acos(b*sqrt(L**2 - a**2)/(a*sqrt(L**2 - b**2))) +
    sqrt(a**2 - b**2)*acosh(L/a))*tan(theta)/pi

    Parameters
    ----------
    L : array_like
        Distance of the reference point from the middle of the contact [m].
    a : array_like
        Half-width of the contact [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Half-width of the flat face [m], b > 0.

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
    Valid for tan(theta) << 1. Negative or NaN field values, and points in the contact, L < a, and half-widths
    below b among larger ones, give NaN. Evaluated as an integral over the growing contact by a Gauss-Legendre
    rule. Handbook: plane.truncated_wedge.d.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import truncated_wedge
    >>> value = truncated_wedge.depth(10.0, 1.0, theta=0.42, b=0.5)
    >>> round(value, 6)
    0.834617
    """
    require(theta=theta, b=b)
    require_reach(a, b, "plane.flat_punch")
    return elementwise(_depth, L, a, theta=theta, b=b)


def half_width_from_load(P: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Half-width of the contact under the line load P.

    a = sqrt(b**2 + P**2/(E_star**2*tan(theta)**2))

    Parameters
    ----------
    P : array_like
        Line load, force per length of the strip of contact [N/m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Half-width of the flat face [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: plane.truncated_wedge.aP.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import truncated_wedge
    >>> value = truncated_wedge.half_width_from_load(0.3867, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.999916
    """
    require(theta=theta, b=b, E_star=E_star)
    return elementwise(_half_width_from_load, P, theta=theta, b=b, E_star=E_star)


def _profile(x: Array, theta: Array, b: Array) -> Array:
    return np.where(x > b, np.tan(theta) * (x - b), 0.0)


def _profile_slope(x: Array, theta: Array, b: Array) -> Array:
    """Slope f'(x) of the profile."""
    return np.where(x > b, np.tan(theta), 0.0)


def _growth_beyond(t: Array, root: Array, theta: Array, b: Array) -> Array:
    """Growth P'(t)/E_star of the line load for t > b."""
    return np.tan(theta) * np.sqrt(root**2 + b**2) / root


def _load(a: Array, theta: Array, b: Array, E_star: Array) -> Array:
    root = np.sqrt((a - b) * (a + b))
    return E_star * np.tan(theta) * root


def _pressure(x: Array, a: Array, theta: Array, b: Array, E_star: Array) -> Array:
    root = np.sqrt((a - b) * (a + b))
    root_bx = np.sqrt((b - x) * (x + b))
    below = E_star * np.tan(theta) / np.pi * np.arcsinh(root / root_bx)
    root_ax = np.sqrt((a - x) * (a + x))
    root_xb = np.sqrt((x - b) * (x + b))
    above = E_star * np.tan(theta) / np.pi * np.arcsinh(root_ax / root_xb)
    value = np.where(x < b, below, above)
    return np.where(a >= b, np.where(x < a, value, 0.0), np.nan)


def _slope(x: Array, a: Array, theta: Array, b: Array) -> Array:
    root = np.sqrt((a - b) * (a + b))
    root_xa = np.sqrt((x - a) * (a + x))
    value = -2 * np.tan(theta) / np.pi * np.arctan2(root, root_xa)
    return np.where(a >= b, np.where(x > a, value, -_profile_slope(x, theta, b)), np.nan)


def _half_width_from_load(P: Array, theta: Array, b: Array, E_star: Array) -> Array:
    return np.sqrt(P**2 / (E_star**2 * np.tan(theta) ** 2) + b**2)


def _depth_below(L: Array, a: Array, theta: Array, b: Array) -> Array:
    beyond = depth_beyond(_growth_beyond, (theta, b), L, a, b)
    value = 2 / np.pi * beyond
    value = np.where(a < L, value, _profile(a, theta, b))
    return np.where(a >= b, np.where(a <= L, value, np.nan), np.nan)


def _depth_above(L: Array, a: Array, theta: Array, b: Array) -> Array:
    root = np.sqrt((L - a) * (a + L))
    root_ab = np.sqrt((a - b) * (a + b))
    angle = np.arctan(root_ab / root)
    angle_1 = np.arctan(L * root_ab / (b * root))
    value = 2 * np.tan(theta) / np.pi * (np.arcsinh(root / a) * root_ab + L * angle - b * angle_1)
    return np.where(a >= b, np.where(a <= L, value, np.nan), np.nan)


def _depth(L: Array, a: Array, theta: Array, b: Array) -> Array:
    return np.where(a < 128.0 * b, _depth_below(L, a, theta, b), _depth_above(L, a, theta, b))
