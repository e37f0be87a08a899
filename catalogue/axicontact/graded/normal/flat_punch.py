"""Flat punch on a power-law graded half-space.

The elementary building block: every other contact is a superposition of flat punches.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.punch import punch_displacement, punch_pressure, punch_stiffness
from ..._runtime.interface import Array, Result, elementwise, require

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["depth_from_force", "displacement", "force", "pressure", "profile", "stiffness"]


def __dir__() -> list[str]:
    return __all__


def profile(r: ArrayLike, *, a: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = 0

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m], a > 0.

    Returns
    -------
    float or ndarray
        Profile of the indenter, measured from its apex [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for sharp edge, frictionless. Negative or NaN field values give NaN.

    References
    ----------
    Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import flat_punch
    >>> value = flat_punch.profile(0.3, a=1.0)
    >>> round(value, 6)
    0.0
    """
    from ...normal import flat_punch as normal

    return normal.profile(r, a=a)


def force(d: ArrayLike, *, a: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force.

    F = 2*H*a**(k + 1)*d/(k + 1)

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

    Returns
    -------
    float or ndarray
        Normal force [N]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for sharp edge, frictionless. Negative or NaN field values give NaN. Handbook: flat_punch.fgm.F.

    References
    ----------
    chapter 11, equation (11.45); chapter 11, equation (11.51); Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import flat_punch
    >>> value = flat_punch.force(0.25, a=1.0, H=1.0, k=0.25)
    >>> round(value, 6)
    0.4
    """
    require(a=a, H=H, k=k)
    return elementwise(_force, d, a=a, H=H, k=k)


def pressure(r: ArrayLike, d: ArrayLike, *, a: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = H*d*(a**2 - r**2)**(k/2 - 1/2)/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

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
    Valid for sharp edge, frictionless. Negative or NaN field values give NaN. Handbook: flat_punch.fgm.p.

    References
    ----------
    chapter 11, equation (11.47); chapter 11, equation (11.53); Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import flat_punch
    >>> value = flat_punch.pressure(0.3, 0.25, a=1.0, H=1.0, k=0.25)
    >>> round(value, 6)
    0.082442
    """
    require(a=a, H=H, k=k)
    return elementwise(_pressure, r, d, a=a, H=H, k=k)


def displacement(r: ArrayLike, d: ArrayLike, *, a: ArrayLike, k: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = d*cos(pi*k/2)*IncompleteBeta(a**2/r**2, (k + 1)/2, (1 - k)/2)/pi
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

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
    Valid for sharp edge, frictionless. Negative or NaN field values give NaN. Handbook: flat_punch.fgm.w.

    References
    ----------
    chapter 11, equation (11.44); chapter 11, equation (11.56); Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import flat_punch
    >>> value = flat_punch.displacement(2.0, 0.25, a=1.0, k=0.25)
    >>> round(value, 6)
    0.052876
    """
    require(a=a, k=k)
    return elementwise(_displacement, r, d, a=a, k=k)


def stiffness(*, a: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*H*a**(k + 1)/(k + 1)

    Parameters
    ----------
    a : array_like
        Contact radius [m], a > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

    Returns
    -------
    float or ndarray
        Contact stiffness dF/dd [N/m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for sharp edge, frictionless. Handbook: flat_punch.fgm.k.

    References
    ----------
    chapter 11, equation (11.46); Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import flat_punch
    >>> value = flat_punch.stiffness(a=1.0, H=1.0, k=0.25)
    >>> round(value, 6)
    1.6
    """
    require(a=a, H=H, k=k)
    return elementwise(_stiffness, a=a, H=H, k=k)


def depth_from_force(F: ArrayLike, *, a: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = F*a**(-k - 1)*(k + 1)/(2*H)

    Parameters
    ----------
    F : array_like
        Normal force [N].
    a : array_like
        Contact radius [m], a > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

    Returns
    -------
    float or ndarray
        Indentation depth of the point r = 0 [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for sharp edge, frictionless. Negative or NaN field values give NaN. Handbook: flat_punch.fgm.dF.

    References
    ----------
    chapter 11, equation (11.46); chapter 11, equation (11.51); Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import flat_punch
    >>> value = flat_punch.depth_from_force(0.4, a=1.0, H=1.0, k=0.25)
    >>> round(value, 6)
    0.25
    """
    require(a=a, H=H, k=k)
    return elementwise(_depth_from_force, F, a=a, H=H, k=k)


def _force(d: Array, a: Array, H: Array, k: Array) -> Array:
    return punch_stiffness(a, H, k) * d


def _pressure(r: Array, d: Array, a: Array, H: Array, k: Array) -> Array:
    return np.where(d > 0.0, d * punch_pressure(r, a, H, k), 0.0)


def _displacement(r: Array, d: Array, a: Array, k: Array) -> Array:
    return d * punch_displacement(r, a, k)


def _stiffness(a: Array, H: Array, k: Array) -> Array:
    return punch_stiffness(a, H, k)


def _depth_from_force(F: Array, a: Array, H: Array, k: Array) -> Array:
    return F / punch_stiffness(a, H, k)
