"""Cylinder with a parabolic cap on a power-law graded half-space.

A paraboloid until the depth a^2/R brings the sharp edge into contact, a curved punch from then on.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.growth import power_depth, power_force
from ..._runtime.graded.punch import punch_displacement, punch_pressure, punch_stiffness
from ..._runtime.interface import Array, Result, elementwise, require

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["depth_from_force", "displacement", "force", "pressure", "profile", "stiffness"]


def __dir__() -> list[str]:
    return __all__


def profile(r: ArrayLike, *, a: ArrayLike, R: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = r**2/(2*R)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m], a > 0.
    R : array_like
        Radius of curvature [m], R > 0.

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
    Valid for a << R. Negative or NaN field values give NaN.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import capped_cylinder
    >>> value = capped_cylinder.profile(0.3, a=1.0, R=2.2)
    >>> round(value, 6)
    0.020455
    """
    from ...normal import capped_cylinder as normal

    return normal.profile(r, a=a, R=R)


def force(d: ArrayLike, *, a: ArrayLike, R: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force.

    F = 4*H*(sqrt(R)*sqrt(d)*sqrt(k + 1))**(k + 3)/(R*(k + 1)**2*(k + 3))   for sqrt(R)*sqrt(d)*sqrt(k + 1) <
    a
    F = 2*H*(a**(k + 1)*d - a**(k + 3)/(R*(k + 3)))/(k + 1)   for a < sqrt(R)*sqrt(d)*sqrt(k + 1)

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: capped_cylinder.fgm.F.

    References
    ----------
    chapter 11, equation (11.45); chapter 11, equation (11.51); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import capped_cylinder
    >>> value = capped_cylinder.force(0.6, a=1.0, R=2.2, H=1.0, k=0.25)
    >>> round(value, 6)
    0.736224
    """
    require(a=a, R=R, H=H, k=k)
    return elementwise(_force, d, a=a, R=R, H=H, k=k)


def pressure(r: ArrayLike, d: ArrayLike, *, a: ArrayLike, R: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = 2*H*(R*d*(k + 1) - r**2)**(k/2 + 1/2)/(pi*R*(k + 1)**2)   for sqrt(R)*sqrt(d)*sqrt(k + 1) < a
    p = H*(d*(a**2 - r**2)**(k/2 - 1/2) - a**2*(a**2 - r**2)**(k/2 - 1/2)/(R*(k + 1)) + 2*(a**2 - r**2)**(k/2
    + 1/2)/(R*(k + 1)**2))/pi   for a < sqrt(R)*sqrt(d)*sqrt(k + 1)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: capped_cylinder.fgm.p.

    References
    ----------
    chapter 11, equation (11.47); chapter 11, equation (11.53); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import capped_cylinder
    >>> value = capped_cylinder.pressure(0.3, 0.6, a=1.0, R=2.2, H=1.0, k=0.25)
    >>> round(value, 6)
    0.252543
    """
    require(a=a, R=R, H=H, k=k)
    return elementwise(_pressure, r, d, a=a, R=R, H=H, k=k)


def displacement(r: ArrayLike, d: ArrayLike, *, a: ArrayLike, R: ArrayLike, k: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = (R*d*(k + 1)*IncompleteBeta(R*d*(k + 1)/r**2, (k + 1)/2, (1 - k)/2) - r**2*IncompleteBeta(R*d*(k +
    1)/r**2, (k + 3)/2, (1 - k)/2))*cos(pi*k/2)/(pi*R*(k + 1))   for sqrt(R)*sqrt(d)*sqrt(k + 1) < a
    w = (d*IncompleteBeta(a**2/r**2, (k + 1)/2, (1 - k)/2) - r**2*IncompleteBeta(a**2/r**2, (k + 3)/2, (1 -
    k)/2)/(R*(k + 1)))*cos(pi*k/2)/pi   for a < sqrt(R)*sqrt(d)*sqrt(k + 1)
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
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: capped_cylinder.fgm.w.

    References
    ----------
    chapter 11, equation (11.44); chapter 11, equation (11.56); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import capped_cylinder
    >>> value = capped_cylinder.displacement(2.0, 0.6, a=1.0, R=2.2, k=0.25)
    >>> round(value, 6)
    0.096081
    """
    require(a=a, R=R, k=k)
    return elementwise(_displacement, r, d, a=a, R=R, k=k)


def stiffness(d: ArrayLike, *, a: ArrayLike, R: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*H*(sqrt(R)*sqrt(d)*sqrt(k + 1))**(k + 1)/(k + 1)   for sqrt(R)*sqrt(d)*sqrt(k + 1) < a
    dF/dd = 2*H*a**(k + 1)/(k + 1)   for a < sqrt(R)*sqrt(d)*sqrt(k + 1)

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: capped_cylinder.fgm.k.

    References
    ----------
    chapter 11, equation (11.46); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import capped_cylinder
    >>> value = capped_cylinder.stiffness(0.6, a=1.0, R=2.2, H=1.0, k=0.25)
    >>> round(value, 6)
    1.6
    """
    require(a=a, R=R, H=H, k=k)
    return elementwise(_stiffness, d, a=a, R=R, H=H, k=k)


def depth_from_force(F: ArrayLike, *, a: ArrayLike, R: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = (F**2*R**2*(k + 1)**4*(k + 3)**2/(16*H**2))**(1/(k + 3))/(R*(k + 1))   for F < 4*H*a**(k + 3)/(R*(k +
    1)**2*(k + 3))
    d = F*a**(-k - 1)*(k + 1)/(2*H) + a**2/(R*(k + 3))   for 4*H*a**(k + 3)/(R*(k + 1)**2*(k + 3)) < F

    Parameters
    ----------
    F : array_like
        Normal force [N].
    a : array_like
        Contact radius [m], a > 0.
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: capped_cylinder.fgm.dF.

    References
    ----------
    chapter 11, equation (11.46); chapter 11, equation (11.51); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import capped_cylinder
    >>> value = capped_cylinder.depth_from_force(0.7362, a=1.0, R=2.2, H=1.0, k=0.25)
    >>> round(value, 6)
    0.599985
    """
    require(a=a, R=R, H=H, k=k)
    return elementwise(_depth_from_force, F, a=a, R=R, H=H, k=k)


def _contact(d: Array, a: Array, R: Array, k: Array) -> tuple[Array, Array]:
    """Contact radius, and the depth that the edge adds."""
    free = power_depth(a, 2.0, k) / (2 * R)
    rho = a * np.minimum(d / free, 1.0) ** (1.0 / 2.0)
    return rho, np.maximum(d - free, 0.0)


def _force(d: Array, a: Array, R: Array, H: Array, k: Array) -> Array:
    rho, rest = _contact(d, a, R, k)
    cap = 2.0 * H / (1.0 + k) * power_force(rho, 2.0, k) / (2 * R)
    return cap + rest * punch_stiffness(rho, H, k)


def _pressure(r: Array, d: Array, a: Array, R: Array, H: Array, k: Array) -> Array:
    from ..._runtime.graded.pressure import power_pressure

    rho, rest = _contact(d, a, R, k)
    edge = np.where(rest > 0.0, rest * punch_pressure(r, rho, H, k), 0.0)
    cap = H / np.pi * power_pressure(np.minimum(r, rho), rho, 2.0, k) / (2 * R)
    return np.where(r <= rho, edge + np.where(r < rho, cap, 0.0), 0.0)


def _displacement(r: Array, d: Array, a: Array, R: Array, k: Array) -> Array:
    from ..._runtime.graded.displacement import power_displacement

    rho, rest = _contact(d, a, R, k)
    cap = power_displacement(r, rho, 2.0, k) / (2 * R)
    return cap + rest * punch_displacement(r, rho, k)


def _stiffness(d: Array, a: Array, R: Array, H: Array, k: Array) -> Array:
    rho, rest = _contact(d, a, R, k)
    return punch_stiffness(rho, H, k)


def _depth_from_force(F: Array, a: Array, R: Array, H: Array, k: Array) -> Array:
    full = 2.0 * H / (1.0 + k) * power_force(a, 2.0, k) / (2 * R)
    free = power_depth(a, 2.0, k) / (2 * R)
    before = free * (F / full) ** (2.0 / (2.0 + 1.0 + k))
    return np.where(full > F, before, free + (F - full) / punch_stiffness(a, H, k))
