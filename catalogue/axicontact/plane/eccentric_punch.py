"""Flat punch under an eccentric load.

The load acts at x = e: the punch tilts, and beyond abs(e) = a/2 one edge lifts off.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, require
from .._runtime.physics.plane import even, require_eccentricity, turned

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["contact_width", "pressure", "tilt"]


def __dir__() -> list[str]:
    return __all__


def pressure(x: ArrayLike, P: ArrayLike, *, a: ArrayLike, e: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = P*(a**2 + 2*e*x)/(pi*a**2*sqrt(a**2 - x**2))   for abs(e) < a/2
    p = P*sqrt(max(0, 3*a + x*sign(e) - 4*abs(e)))/(2*pi*sqrt(a - x*sign(e))*(a - abs(e)))   for a/2 < abs(e)

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    P : array_like
        Line load, force per length of the strip of contact [N/m].
    a : array_like
        Half-width of the punch [m], a > 0.
    e : array_like
        Eccentricity: the load acts at x = e [m], -a < e < a.

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
    Valid for sharp edges, frictionless, free to tilt. Negative P and NaN give NaN. After lift-off the
    pressure is zero on the side of the lifted edge, at distances beyond 4 abs(e) - 3 a. Handbook:
    plane.eccentric_punch.p.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import eccentric_punch
    >>> value = eccentric_punch.pressure(0.3, 1.0, a=1.0, e=0.3)
    >>> round(value, 6)
    0.393742
    """
    require(a=a)
    require_eccentricity(a, e)
    return even(_pressure, x, P, a=a, e=turned(x, e))


def tilt(P: ArrayLike, *, a: ArrayLike, e: ArrayLike, E_star: ArrayLike) -> Result:
    """Inclination of the punch under an eccentric load.

    phi = 4*P*e/(pi*E_star*a**2)   for abs(e) < a/2
    phi = P*sign(e)/(pi*E_star*(a - abs(e)))   for a/2 < abs(e)

    Parameters
    ----------
    P : array_like
        Line load, force per length of the strip of contact [N/m].
    a : array_like
        Half-width of the punch [m], a > 0.
    e : array_like
        Eccentricity: the load acts at x = e [m], -a < e < a.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Inclination of the punch, deeper on the side of positive x [rad]. The shape to which the arguments
        broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for sharp edges, frictionless, free to tilt. Negative or NaN field values give NaN. Handbook:
    plane.eccentric_punch.phi.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import eccentric_punch
    >>> value = eccentric_punch.tilt(1.0, a=1.0, e=0.3, E_star=1.0)
    >>> round(value, 6)
    0.381972
    """
    require(a=a, E_star=E_star)
    require_eccentricity(a, e)
    return elementwise(_tilt, P, a=a, e=e, E_star=E_star)


def contact_width(*, a: ArrayLike, e: ArrayLike) -> Result:
    """Width of the contact, smaller than the punch once an edge has lifted off.

    l = 2*a   for abs(e) < a/2
    l = 4*(a - abs(e))   for a/2 < abs(e)

    Parameters
    ----------
    a : array_like
        Half-width of the punch [m], a > 0.
    e : array_like
        Eccentricity: the load acts at x = e [m], -a < e < a.

    Returns
    -------
    float or ndarray
        Width of the contact [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for sharp edges, frictionless, free to tilt. After lift-off the pressure is zero on the side of the
    lifted edge, at distances beyond 4 abs(e) - 3 a. Handbook: plane.eccentric_punch.cw.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import eccentric_punch
    >>> value = eccentric_punch.contact_width(a=1.0, e=0.3)
    >>> round(value, 6)
    2.0
    """
    require(a=a)
    require_eccentricity(a, e)
    return elementwise(_contact_width, a=a, e=e)


def _pressure(x: Array, P: Array, a: Array, e: Array) -> Array:
    """Pressure for x >= 0 under a load on either side."""
    root = np.sqrt((a - x) * (a + x))
    touching = P * (x * (2 * e + a) + a * (a - x)) / (np.pi * a**2 * root)
    short, side = a - np.abs(e), np.copysign(1.0, e)
    beyond, along = 2 * np.abs(e) - a, side * x
    near, far, end = a - along, a + along, 2 * beyond - a
    reach = np.maximum(np.where(end < -a / 2, far - 2 * beyond, along - end), 0.0)
    apart = P * np.sqrt(reach / near) / (2 * np.pi * short)
    pressed = np.where(np.abs(e) < a / 2, touching, apart)
    return np.where((x <= a) & (P > 0.0), pressed, 0.0)


def _tilt(P: Array, a: Array, e: Array, E_star: Array) -> Array:
    short = a - np.abs(e)
    side = np.copysign(1.0, e)
    return np.where(np.abs(e) < a / 2, 4 * e * P / (np.pi * E_star * a**2), side / (np.pi * E_star * short) * P)


def _contact_width(a: Array, e: Array) -> Array:
    short = a - np.abs(e)
    return np.where(np.abs(e) < a / 2, 2 * a, 4 * short)
