"""Flat punch with rounded edges.

Flat face of half-width b running tangentially into roundings of radius R.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, require, require_reach
from .._runtime.inverse import inverse
from .._runtime.physics.plane import depth_beyond, even, load_beyond, odd, slope_beyond
from .._runtime.rules import pressure_integral_beyond

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["depth", "half_width_from_load", "load", "pressure", "profile", "slope"]


def __dir__() -> list[str]:
    return __all__


def profile(x: ArrayLike, *, R: ArrayLike, b: ArrayLike) -> Result:
    """Profile f(x) of the indenter.

    f = 0   for 0 < x < b
    f = (-b + x)**2/(2*R)   for b < x

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a - b << R (parabolic rounding). The formula is for x >= 0; the function is even. NaN gives NaN.
    Handbook: plane.rounded_punch.f, the definition of the profile.

    References
    ----------
    Schubert 1942; Ciavarella, Hills & Monno 1998.

    Examples
    --------
    >>> from axicontact.plane import rounded_punch
    >>> value = rounded_punch.profile(0.486, R=1.45, b=1.15)
    >>> round(value, 6)
    0.0
    """
    require(R=R, b=b)
    return even(_profile, x, R=R, b=b)


def load(a: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Line load at half-width a.

    P = E_star*(a**2*acos(b/a) - b*sqrt(a**2 - b**2))/(2*R)

    Parameters
    ----------
    a : array_like
        Half-width of the contact [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values, and half-widths below b among
    larger ones, give NaN. Evaluated as an integral over the growing contact by a Gauss-Legendre rule.
    Handbook: plane.rounded_punch.P.

    References
    ----------
    Schubert 1942; Ciavarella, Hills & Monno 1998.

    Examples
    --------
    >>> from axicontact.plane import rounded_punch
    >>> value = rounded_punch.load(1.62, R=1.45, b=1.15, E_star=1.0)
    >>> round(value, 6)
    0.254738
    """
    require(R=R, b=b, E_star=E_star)
    require_reach(a, b, "plane.flat_punch")
    return elementwise(_load, a, R=R, b=b, E_star=E_star)


def pressure(x: ArrayLike, a: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = E_star*(-b*atanh(sqrt(a**2 - b**2)/sqrt(a**2 - x**2)) + x*atanh(x*sqrt(a**2 - b**2)/(b*sqrt(a**2 -
    x**2))) + sqrt(a**2 - x**2)*acos(b/a))/(pi*R)   for x < b
    p = E_star*(-b*atanh(sqrt(a**2 - x**2)/sqrt(a**2 - b**2)) + x*atanh(b*sqrt(a**2 - x**2)/(x*sqrt(a**2 -
    b**2))) + sqrt(a**2 - x**2)*acos(b/a))/(pi*R)   for b < x

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    a : array_like
        Half-width of the contact [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a - b << R (parabolic rounding). The formula is for x >= 0; the function is even. Negative a and
    NaN, and half-widths below b among larger ones, give NaN. Evaluated as an integral over the growing
    contact by a Gauss-Legendre rule. The pressure is bounded. Handbook: plane.rounded_punch.p.

    References
    ----------
    Schubert 1942; Ciavarella, Hills & Monno 1998.

    Examples
    --------
    >>> from axicontact.plane import rounded_punch
    >>> value = rounded_punch.pressure(0.486, 1.62, R=1.45, b=1.15, E_star=1.0)
    >>> round(value, 6)
    0.060527
    """
    require(R=R, b=b, E_star=E_star)
    require_reach(a, b, "plane.flat_punch")
    return even(_pressure, x, a, R=R, b=b, E_star=E_star)


def slope(x: ArrayLike, a: ArrayLike, *, R: ArrayLike, b: ArrayLike) -> Result:
    """Slope dw/dx of the surface, inside and outside the contact.

    dw/dx = 2*(b*asin(sqrt(a**2 - b**2)/sqrt(-b**2 + x**2)) - x*acos(b*sqrt(-a**2 + x**2)/(a*sqrt(-b**2 +
    x**2))) + sqrt(-a**2 + x**2)*acos(b/a))/(pi*R)
    and dw/dx = -f'(x) in the contact.

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    a : array_like
        Half-width of the contact [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a - b << R (parabolic rounding). The formula is for x >= 0; the function is odd. Negative a and
    NaN, and half-widths below b among larger ones, give NaN. Evaluated as an integral over the growing
    contact by a Gauss-Legendre rule. Handbook: plane.rounded_punch.s.

    References
    ----------
    Schubert 1942; Ciavarella, Hills & Monno 1998.

    Examples
    --------
    >>> from axicontact.plane import rounded_punch
    >>> value = rounded_punch.slope(3.24, 1.62, R=1.45, b=1.15)
    >>> round(value, 6)
    -0.055941
    """
    require(R=R, b=b)
    require_reach(a, b, "plane.flat_punch")
    return odd(_slope, x, a, R=R, b=b)


def depth(L: ArrayLike, a: ArrayLike, *, R: ArrayLike, b: ArrayLike) -> Result:
    """Indentation depth relative to the surface at the distance L.

    d = (-2*L*b*asin(sqrt(a**2 - b**2)/sqrt(L**2 - b**2)) - L*sqrt(L**2 - a**2)*acos(b/a) +
    a**2*acos(b/a)*acosh(L/a) - b*sqrt(a**2 - b**2)*acosh(L/a) + (L**2 + b**2)*acos(b*sqrt(L**2 -
    a**2)/(a*sqrt(L**2 - b**2))))/(pi*R)

    Parameters
    ----------
    L : array_like
        Distance of the reference point from the middle of the contact [m].
    a : array_like
        Half-width of the contact [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values, and points in the contact, L < a,
    and half-widths below b among larger ones, give NaN. Evaluated as an integral over the growing contact by
    a Gauss-Legendre rule. Handbook: plane.rounded_punch.d.

    References
    ----------
    Schubert 1942; Ciavarella, Hills & Monno 1998.

    Examples
    --------
    >>> from axicontact.plane import rounded_punch
    >>> value = rounded_punch.depth(16.2, 1.62, R=1.45, b=1.15)
    >>> round(value, 6)
    0.505411
    """
    require(R=R, b=b)
    require_reach(a, b, "plane.flat_punch")
    return elementwise(_depth, L, a, R=R, b=b)


def half_width_from_load(P: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Half-width of the contact under the line load P.

    a from E_star*(a**2*acos(b/a) - b*sqrt(a**2 - b**2))/(2*R) = P

    Parameters
    ----------
    P : array_like
        Line load, force per length of the strip of contact [N/m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values give NaN. Evaluated as an integral
    over the growing contact by a Gauss-Legendre rule. Evaluated by a safeguarded Newton iteration. Handbook:
    plane.rounded_punch.aP.

    References
    ----------
    Schubert 1942; Ciavarella, Hills & Monno 1998.

    Examples
    --------
    >>> from axicontact.plane import rounded_punch
    >>> value = rounded_punch.half_width_from_load(0.2547, R=1.45, b=1.15, E_star=1.0)
    >>> round(value, 6)
    1.619957
    """
    require(R=R, b=b, E_star=E_star)
    return elementwise(_half_width_from_load, P, R=R, b=b, E_star=E_star)


def _profile(x: Array, R: Array, b: Array) -> Array:
    return np.where(x > b, (x - b) ** 2 / (2 * R), 0.0)


def _profile_slope(x: Array, R: Array, b: Array) -> Array:
    """Slope f'(x) of the profile."""
    return np.where(x > b, (x - b) / R, 0.0)


def _growth_beyond(t: Array, root: Array, R: Array, b: Array) -> Array:
    """Growth P'(t)/E_star of the line load for t > b."""
    angle = np.arctan(root / b)
    return t * angle / R


def _load_at(root: Array, R: Array, b: Array, E_star: Array) -> Array:
    """Line load at a = sqrt(b**2 + root**2)."""
    return E_star * load_beyond(_growth_beyond, (R, b), root, b)


def _pressure(x: Array, a: Array, R: Array, b: Array, E_star: Array) -> Array:
    beyond = pressure_integral_beyond(_growth_beyond, (R, b), x, a, b)
    value = E_star / np.pi * beyond
    return np.where(a >= b, np.where(x < a, value, 0.0), np.nan)


def _slope(x: Array, a: Array, R: Array, b: Array) -> Array:
    beyond = slope_beyond(_growth_beyond, (R, b), x, a, b)
    value = -2 / np.pi * beyond
    return np.where(a >= b, np.where(x > a, value, -_profile_slope(x, R, b)), np.nan)


def _depth(L: Array, a: Array, R: Array, b: Array) -> Array:
    beyond = depth_beyond(_growth_beyond, (R, b), L, a, b)
    value = 2 / np.pi * beyond
    value = np.where(a < L, value, _profile(a, R, b))
    return np.where(a >= b, np.where(a <= L, value, np.nan), np.nan)


def _half_width_from_load(P: Array, R: Array, b: Array, E_star: Array) -> Array:
    def curve(t: Array) -> tuple[Array, Array]:
        a, root = b * np.sqrt(1.0 + t * t), b * t
        value = _load_at(root, R, b, E_star)
        return value, E_star * root * root / a * _growth_beyond(a, root, R, b) / value

    t = inverse(curve, P, np.ones_like(P), (2.0, 3.0))
    return b * np.sqrt(1.0 + t * t)


def _load_below(a: Array, R: Array, b: Array, E_star: Array) -> Array:
    root = np.sqrt((a - b) * (a + b))
    return _load_at(root, R, b, E_star)


def _load_above(a: Array, R: Array, b: Array, E_star: Array) -> Array:
    root = np.sqrt((a - b) * (a + b))
    angle = np.arctan(root / b)
    return E_star / (2 * R) * (a**2 * angle - b * root)


def _load(a: Array, R: Array, b: Array, E_star: Array) -> Array:
    return np.where(a < 2.0 * b, _load_below(a, R, b, E_star), _load_above(a, R, b, E_star))
