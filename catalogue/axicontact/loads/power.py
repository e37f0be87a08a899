"""Power of the distance to the edge.

Any exponent s > -1 of 1 - r^2/a^2.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from .._runtime.interface import Array, Result, elementwise, require
from .._runtime.physics.circle import power

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["displacement"]


def __dir__() -> list[str]:
    return __all__


def displacement(r: ArrayLike, *, a: ArrayLike, p_0: ArrayLike, s: ArrayLike, E_star: ArrayLike) -> Result:
    """Displacement of the surface into the half-space.

    w = sqrt(pi)*a*p_0*2F1(-s - 1/2, 1/2, 1, r**2/a**2)*gamma(s + 2)/(E_star*(s +
    1)*gamma(s + 3/2))   for r < a
    w = a**2*p_0*2F1(1/2, 1/2, s + 2, a**2/r**2)/(E_star*r*(s + 1))   for a < r
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m], a > 0.
    p_0 : array_like
        Scale of a prescribed pressure [Pa], p_0 > 0.
    s : array_like
        Exponent of a prescribed pressure [1], s > -1.
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
    Frictionless half-space. Negative or NaN radii give NaN. Handbook: loads.power.w.

    References
    ----------
    chapter 11, equation (11.104); chapter 11, equation (11.105); Föppl 1941.

    Examples
    --------
    >>> from axicontact.loads import power
    >>> value = power.displacement(2.0, a=1.0, p_0=1.0, s=0.3, E_star=1.0)
    >>> round(value, 6)
    0.396084
    """
    require(a=a, p_0=p_0, sigma=s, E_star=E_star)
    return elementwise(_displacement, r, a=a, p_0=p_0, s=s, E_star=E_star)


def _displacement(r: Array, a: Array, p_0: Array, s: Array, E_star: Array) -> Array:
    return p_0 / E_star * a * power(r, a, s)
