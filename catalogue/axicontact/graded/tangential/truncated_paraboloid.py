"""Truncated paraboloid under a tangential load on a power-law graded half-space.

Flat face of radius b with a parabolic flank: a worn sphere.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.breaks import rim_depth, rim_force, rim_rate
from ..._runtime.interface import Array, Result, either, elementwise, numbers, require, require_order, require_reach
from ..._runtime.physics.slip import stick_force
from ..normal import truncated_paraboloid as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["full_slip_displacement", "stick_radius", "tangential_displacement", "tangential_force", "traction"]


def __dir__() -> list[str]:
    return __all__


def tangential_force(
    a: ArrayLike, c: ArrayLike, *, R: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential force with a stick zone of radius c.

    F_x = mu*(2*H*(a**2 - b**2)**(k/2 + 1/2)*(2*a**2 + b**2*k + b**2)/(R*(k + 1)**2*(k + 3)) - 2*H*(-b**2 +
    c**2)**(k/2 + 1/2)*(b**2*k + b**2 + 2*c**2)/(R*(k + 1)**2*(k + 3)))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.
    mu : array_like
        Coefficient of friction [1], mu >= 0.

    Returns
    -------
    float or ndarray
        Tangential force [N]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. The stick zone is
    never smaller than the flat face: NaN for c < b. Handbook: truncated_paraboloid.fgm.tan.F.

    References
    ----------
    chapter 11, equation (11.78); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.tangential import truncated_paraboloid
    >>> value = truncated_paraboloid.tangential_force(1.0, 0.8, R=1.2, b=0.5, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.103174
    """
    require(R=R, b=b, H=H, k=k, mu=mu)
    require_reach(a, b, "graded.normal.flat_punch")
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_force, a, c, R=R, b=b, H=H, k=k, mu=mu)


def traction(
    r: ArrayLike, a: ArrayLike, c: ArrayLike, *, R: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential traction; zero outside the contact.

    tau = mu*(p(r, a) - p(r, c))

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.
    mu : array_like
        Coefficient of friction [1], mu >= 0.

    Returns
    -------
    float or ndarray
        Tangential traction [Pa]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. The stick zone is
    never smaller than the flat face: NaN for c < b. Handbook: truncated_paraboloid.fgm.tan.tau.

    References
    ----------
    chapter 11, equation (11.79); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.tangential import truncated_paraboloid
    >>> value = truncated_paraboloid.traction(0.3, 1.0, 0.8, R=1.2, b=0.5, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.026354
    """
    require(R=R, b=b, H=H, k=k, mu=mu)
    require_reach(a, b, "graded.normal.flat_punch")
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_traction, r, a, c, R=R, b=b, H=H, k=k, mu=mu)


def tangential_displacement(
    a: ArrayLike, c: ArrayLike, *, R: ArrayLike, b: ArrayLike, H: ArrayLike, H_x: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement of the indenter with a stick zone of radius c.

    u_0 = H*mu*(a**(1 - k)*(a**2 - b**2)**(k/2 + 1/2)/(R*(k + 1)) - c**(1 - k)*(-b**2 + c**2)**(k/2 +
    1/2)/(R*(k + 1)))/H_x

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    H_x : array_like
        Tangential foundation modulus, c_T(x) = H_x |x|^k [Pa m^(-k)], H_x > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.
    mu : array_like
        Coefficient of friction [1], mu >= 0.

    Returns
    -------
    float or ndarray
        Tangential displacement of the rigid body [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. The stick zone is
    never smaller than the flat face: NaN for c < b. Handbook: truncated_paraboloid.fgm.tan.u.

    References
    ----------
    chapter 11, equation (11.80); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.tangential import truncated_paraboloid
    >>> value = truncated_paraboloid.tangential_displacement(1.0, 0.8, R=1.2, b=0.5, H=1.0, H_x=0.8, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.091458
    """
    require(R=R, b=b, H=H, H_x=H_x, k=k, mu=mu)
    require_reach(a, b, "graded.normal.flat_punch")
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_displacement, a, c, R=R, b=b, H=H, H_x=H_x, k=k, mu=mu)


def stick_radius(
    F_x: ArrayLike, a: ArrayLike, *, R: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Radius of the stick zone under a tangential force; NaN beyond full slip.

    c from mu*(2*H*(a**2 - b**2)**(k/2 + 1/2)*(2*a**2 + b**2*k + b**2)/(R*(k + 1)**2*(k + 3)) - 2*H*(-b**2 +
    c**2)**(k/2 + 1/2)*(b**2*k + b**2 + 2*c**2)/(R*(k + 1)**2*(k + 3))) = F_x

    Parameters
    ----------
    F_x : array_like
        Tangential force [N].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.
    mu : array_like
        Coefficient of friction [1], mu >= 0.

    Returns
    -------
    float or ndarray
        Radius of the stick zone [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. The stick zone is
    never smaller than the flat face: NaN for c < b. Handbook: truncated_paraboloid.fgm.tan.c.

    References
    ----------
    chapter 11, equation (11.78); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.tangential import truncated_paraboloid
    >>> value = truncated_paraboloid.stick_radius(0.1032, 1.0, R=1.2, b=0.5, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.799934
    """
    require(R=R, b=b, H=H, k=k, mu=mu)
    require_reach(a, b, "graded.normal.flat_punch")
    return elementwise(_stick_radius, F_x, a, R=R, b=b, H=H, k=k, mu=mu)


def full_slip_displacement(
    a: ArrayLike, *, R: ArrayLike, b: ArrayLike, H: ArrayLike, H_x: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement at the onset of full slip.

    u_0 = H*a**(1 - k)*mu*(a**2 - b**2)**(k/2 + 1/2)/(H_x*R*(k + 1))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    H_x : array_like
        Tangential foundation modulus, c_T(x) = H_x |x|^k [Pa m^(-k)], H_x > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.
    mu : array_like
        Coefficient of friction [1], mu >= 0.

    Returns
    -------
    float or ndarray
        Tangential displacement of the rigid body [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. The stick zone is
    never smaller than the flat face: NaN for c < b. Handbook: truncated_paraboloid.fgm.tan.us.

    References
    ----------
    chapter 11, equation (11.80); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.tangential import truncated_paraboloid
    >>> value = truncated_paraboloid.full_slip_displacement(1.0, R=1.2, b=0.5, H=1.0, H_x=0.8, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.208859
    """
    require(R=R, b=b, H=H, H_x=H_x, k=k, mu=mu)
    require_reach(a, b, "graded.normal.flat_punch")
    return elementwise(_full_slip_displacement, a, R=R, b=b, H=H, H_x=H_x, k=k, mu=mu)


def _tangential_force(a: Array, c: Array, R: Array, b: Array, H: Array, k: Array, mu: Array) -> Array:
    from ..._runtime.graded.slip import beyond_gain

    gain = beyond_gain("force", rim_force, rim_rate, (b,), 0.0, c, a, k) / R
    return np.where(c >= b, mu * (2.0 * H / (1.0 + k)) * gain, np.nan)


def _traction(r: Array, a: Array, c: Array, R: Array, b: Array, H: Array, k: Array, mu: Array) -> Array:
    from ..._runtime.graded.pressure import rim_pressure
    from ..._runtime.graded.slip import beyond_gain

    def gain() -> Array:
        inside = np.minimum(r, c)
        return beyond_gain("pressure", rim_pressure, rim_rate, (b,), inside, c, a, k) / R

    return np.where(
        c >= b, mu * either(r < c, lambda: H / np.pi * gain(), lambda: normal._pressure(r, a, R, b, H, k)), np.nan
    )


def _tangential_displacement(
    a: Array, c: Array, R: Array, b: Array, H: Array, H_x: Array, k: Array, mu: Array
) -> Array:
    from ..._runtime.graded.slip import beyond_gain

    gain = beyond_gain("depth", rim_depth, rim_rate, (b,), 0.0, c, a, k) / R
    return np.where(c >= b, mu * (H / H_x) * gain, np.nan)


def _stick_radius(F_x: Array, a: Array, R: Array, b: Array, H: Array, k: Array, mu: Array) -> Array:
    F = stick_force(normal._force(a, R, b, H, k), F_x, mu)
    return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force(F, R, b, H, k))


def _full_slip_displacement(a: Array, R: Array, b: Array, H: Array, H_x: Array, k: Array, mu: Array) -> Array:
    return mu * (H / H_x) * normal._depth(a, R, b, k)
