"""Uniform pressure.

Constant pressure on a circle.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from .._runtime.interface import Array, Result, elementwise, require
from .._runtime.physics.circle import uniform

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["displacement"]


def __dir__() -> list[str]:
    return __all__


def displacement(r: ArrayLike, *, a: ArrayLike, p_0: ArrayLike, E_star: ArrayLike) -> Result:
    """Displacement of the surface into the half-space.

    w = 4*a*p_0*elliptic_e(r**2/a**2)/(pi*E_star)   for r < a
    w = 4*p_0*r*(-(-a**2/r**2 + 1)*elliptic_k(a**2/r**2) + elliptic_e(a**2/r**2))/(pi*E_star)   for a < r
    with elliptic integrals of the parameter m = k**2, their last argument

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
    Frictionless half-space. Negative or NaN radii give NaN. Handbook: loads.uniform.w.

    References
    ----------
    chapter 11, equation (11.104); chapter 11, equation (11.105); Föppl 1941.

    Examples
    --------
    >>> from axicontact.loads import uniform
    >>> value = uniform.displacement(2.0, a=1.0, p_0=1.0, E_star=1.0)
    >>> round(value, 6)
    0.517316
    """
    require(a=a, p_0=p_0, E_star=E_star)
    return elementwise(_displacement, r, a=a, p_0=p_0, E_star=E_star)


def _displacement(r: Array, a: Array, p_0: Array, E_star: Array) -> Array:
    return p_0 / E_star * a * uniform(r, a)
