"""Wedge.

Rigid wedge of inclination theta; the mean pressure does not depend on the load.
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


def profile(x: ArrayLike, *, theta: ArrayLike) -> Result:
    """Profile f(x) of the indenter.

    f = x*tan(theta)

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.

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
    Valid for tan(theta) << 1; a << size of the body. The formula is for x >= 0; the function is even. NaN
    gives NaN. Handbook: plane.wedge.f, the definition of the profile.

    References
    ----------
    Schubert 1942; Johnson 1985.

    Examples
    --------
    >>> from axicontact.plane import wedge
    >>> value = wedge.profile(0.3, theta=0.35)
    >>> round(value, 6)
    0.109509
    """
    require(theta=theta)
    return even(_profile, x, theta=theta)


def load(a: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike) -> Result:
    """Line load at half-width a.

    P = E_star*a*tan(theta)

    Parameters
    ----------
    a : array_like
        Half-width of the contact [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. Handbook:
    plane.wedge.P.

    References
    ----------
    Schubert 1942; Johnson 1985.

    Examples
    --------
    >>> from axicontact.plane import wedge
    >>> value = wedge.load(1.0, theta=0.35, E_star=1.0)
    >>> round(value, 6)
    0.365028
    """
    require(theta=theta, E_star=E_star)
    return elementwise(_load, a, theta=theta, E_star=E_star)


def pressure(x: ArrayLike, a: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = E_star*tan(theta)*acosh(a/x)/pi

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    a : array_like
        Half-width of the contact [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body. The formula is for x >= 0; the function is even.
    Negative a and NaN give NaN. The pressure is singular at the tip, as ln(x). Handbook: plane.wedge.p.

    References
    ----------
    Schubert 1942; Johnson 1985.

    Examples
    --------
    >>> from axicontact.plane import wedge
    >>> value = wedge.pressure(0.3, 1.0, theta=0.35, E_star=1.0)
    >>> round(value, 6)
    0.217723
    """
    require(theta=theta, E_star=E_star)
    return even(_pressure, x, a, theta=theta, E_star=E_star)


def slope(x: ArrayLike, a: ArrayLike, *, theta: ArrayLike) -> Result:
    """Slope dw/dx of the surface, inside and outside the contact.

    dw/dx = -2*tan(theta)*asin(a/x)/pi
    and dw/dx = -f'(x) in the contact.

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    a : array_like
        Half-width of the contact [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.

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
    Valid for tan(theta) << 1; a << size of the body. The formula is for x >= 0; the function is odd. Negative
    a and NaN give NaN. Handbook: plane.wedge.s.

    References
    ----------
    Schubert 1942; Johnson 1985.

    Examples
    --------
    >>> from axicontact.plane import wedge
    >>> value = wedge.slope(2.0, 1.0, theta=0.35)
    >>> round(value, 6)
    -0.121676
    """
    require(theta=theta)
    return odd(_slope, x, a, theta=theta)


def depth(L: ArrayLike, a: ArrayLike, *, theta: ArrayLike) -> Result:
    """Indentation depth relative to the surface at the distance L.

    d = 2*(L*asin(a/L) + a*acosh(L/a))*tan(theta)/pi

    Parameters
    ----------
    L : array_like
        Distance of the reference point from the middle of the contact [m].
    a : array_like
        Half-width of the contact [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.

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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values, and points in the contact,
    L < a, give NaN. Handbook: plane.wedge.d.

    References
    ----------
    Schubert 1942; Johnson 1985.

    Examples
    --------
    >>> from axicontact.plane import wedge
    >>> value = wedge.depth(10.0, 1.0, theta=0.35)
    >>> round(value, 6)
    0.928352
    """
    require(theta=theta)
    return elementwise(_depth, L, a, theta=theta)


def half_width_from_load(P: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike) -> Result:
    """Half-width of the contact under the line load P.

    a = P/(E_star*tan(theta))

    Parameters
    ----------
    P : array_like
        Line load, force per length of the strip of contact [N/m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. Handbook:
    plane.wedge.aP.

    References
    ----------
    Schubert 1942; Johnson 1985.

    Examples
    --------
    >>> from axicontact.plane import wedge
    >>> value = wedge.half_width_from_load(0.365, theta=0.35, E_star=1.0)
    >>> round(value, 6)
    0.999922
    """
    require(theta=theta, E_star=E_star)
    return elementwise(_half_width_from_load, P, theta=theta, E_star=E_star)


def _profile(x: Array, theta: Array) -> Array:
    return np.tan(theta) * x


def _profile_slope(x: Array, theta: Array) -> Array:
    """Slope f'(x) of the profile."""
    return np.tan(theta) * np.ones_like(x)


def _load(a: Array, theta: Array, E_star: Array) -> Array:
    return E_star * np.tan(theta) * a


def _pressure(x: Array, a: Array, theta: Array, E_star: Array) -> Array:
    root = np.sqrt((a - x) * (a + x))
    value = E_star * np.tan(theta) / np.pi * np.log1p((a - x + root) / x)
    return np.where(x < a, value, 0.0)


def _slope(x: Array, a: Array, theta: Array) -> Array:
    root = np.sqrt((x - a) * (a + x))
    angle = np.arctan2(a, root)
    value = -2 * np.tan(theta) / np.pi * angle
    return np.where(x > a, value, -_profile_slope(x, theta))


def _depth(L: Array, a: Array, theta: Array) -> Array:
    root = np.sqrt((L - a) * (a + L))
    angle = np.arctan2(a, root)
    value = 2 * np.tan(theta) / np.pi * (L * angle + a * np.log1p((L - a + root) / a))
    value = np.where(a > 0.0, value, 0.0)
    return np.where(a <= L, value, np.nan)


def _half_width_from_load(P: Array, theta: Array, E_star: Array) -> Array:
    return P / (E_star * np.tan(theta))
