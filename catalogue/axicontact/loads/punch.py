"""Pressure of the flat punch.

The pressure that moves its circle as a whole.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, require

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["displacement"]


def __dir__() -> list[str]:
    return __all__


def displacement(r: ArrayLike, *, a: ArrayLike, p_0: ArrayLike, E_star: ArrayLike) -> Result:
    """Displacement of the surface into the half-space.

    w = pi*a*p_0/E_star   for r < a
    w = 2*a*p_0*asin(a/r)/E_star   for a < r

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m], a > 0.
    p_0 : array_like
        Scale of a prescribed pressure [Pa], p_0 > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Surface displacement into the half-space [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Frictionless half-space. Negative or NaN radii give NaN. Handbook: loads.punch.w.

    References
    ----------
    chapter 11, equation (11.104); chapter 11, equation (11.105); Föppl 1941.

    Examples
    --------
    >>> from axicontact.loads import punch
    >>> value = punch.displacement(2.0, a=1.0, p_0=1.0, E_star=1.0)
    >>> round(value, 6)
    1.047198
    """
    require(a=a, p_0=p_0, E_star=E_star)
    return elementwise(_displacement, r, a=a, p_0=p_0, E_star=E_star)


def _displacement(r: Array, a: Array, p_0: Array, E_star: Array) -> Array:
    root = np.sqrt((r - a) * (a + r))
    angle = np.arctan(a / root)
    outside = 2 * p_0 / E_star * a * angle
    inside = np.pi * p_0 / E_star * a
    return np.where(r > a, outside, inside)
