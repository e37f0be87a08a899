"""Paraboloid with a flatter cap under a tangential load on a power-law graded half-space.

Radius of curvature R1 up to r = b, the smaller R2 beyond: a worn sphere of finite cap curvature.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.breaks import rim_depth, rim_force, rim_rate
from ..._runtime.interface import Array, Result, either, elementwise, numbers, require_order
from ..._runtime.physics.slip import stick_force
from ..normal import capped_paraboloid as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["full_slip_displacement", "stick_radius", "tangential_displacement", "tangential_force", "traction"]


def __dir__() -> list[str]:
    return __all__


def tangential_force(
    a: ArrayLike, c: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential force with a stick zone of radius c.

    F_x = mu*(4*H*a**(k + 3)/(R1*(k + 1)**2*(k + 3)) - 4*H*c**(k + 3)/(R1*(k + 1)**2*(k + 3)))   for a < b
    F_x = mu*(-4*H*c**(k + 3)/(R1*(k + 1)**2*(k + 3)) + 2*H*(2*a**(k + 3) + (R1 - R2)*(a**2 - b**2)**(k/2 +
    1/2)*(2*a**2 + b**2*k + b**2)/R2)/(R1*(k + 1)**2*(k + 3)))   for c < b and b < a
    F_x = mu*(2*H*(2*a**(k + 3) + (R1 - R2)*(a**2 - b**2)**(k/2 + 1/2)*(2*a**2 + b**2*k + b**2)/R2)/(R1*(k +
    1)**2*(k + 3)) - 2*H*(2*c**(k + 3) + (R1 - R2)*(-b**2 + c**2)**(k/2 + 1/2)*(b**2*k + b**2 +
    2*c**2)/R2)/(R1*(k + 1)**2*(k + 3)))   for b < c

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
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
    Valid for a << R2; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    capped_paraboloid.fgm.tan.F.

    References
    ----------
    chapter 11, equation (11.78); Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.graded.tangential import capped_paraboloid
    >>> value = capped_paraboloid.tangential_force(1.0, 0.6, R1=4.0, R2=1.0, b=0.5, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.196018
    """
    normal._check(R1=R1, R2=R2, b=b, H=H, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_force, a, c, R1=R1, R2=R2, b=b, H=H, k=k, mu=mu)


def traction(
    r: ArrayLike,
    a: ArrayLike,
    c: ArrayLike,
    *,
    R1: ArrayLike,
    R2: ArrayLike,
    b: ArrayLike,
    H: ArrayLike,
    k: ArrayLike,
    mu: ArrayLike,
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
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
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
    Valid for a << R2; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    capped_paraboloid.fgm.tan.tau.

    References
    ----------
    chapter 11, equation (11.79); Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.graded.tangential import capped_paraboloid
    >>> value = capped_paraboloid.traction(0.3, 1.0, 0.6, R1=4.0, R2=1.0, b=0.5, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.063208
    """
    normal._check(R1=R1, R2=R2, b=b, H=H, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_traction, r, a, c, R1=R1, R2=R2, b=b, H=H, k=k, mu=mu)


def tangential_displacement(
    a: ArrayLike,
    c: ArrayLike,
    *,
    R1: ArrayLike,
    R2: ArrayLike,
    b: ArrayLike,
    H: ArrayLike,
    H_x: ArrayLike,
    k: ArrayLike,
    mu: ArrayLike,
) -> Result:
    """Tangential displacement of the indenter with a stick zone of radius c.

    u_0 = H*mu*(a**2/(R1*(k + 1)) - c**2/(R1*(k + 1)))/H_x   for a < b
    u_0 = H*mu*(-c**2/(R1*(k + 1)) + (a**2 + a**(1 - k)*(R1 - R2)*(a**2 - b**2)**(k/2 + 1/2)/R2)/(R1*(k +
    1)))/H_x   for c < b and b < a
    u_0 = H*mu*((a**2 + a**(1 - k)*(R1 - R2)*(a**2 - b**2)**(k/2 + 1/2)/R2)/(R1*(k + 1)) - (c**2 + c**(1 -
    k)*(R1 - R2)*(-b**2 + c**2)**(k/2 + 1/2)/R2)/(R1*(k + 1)))/H_x   for b < c

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
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
    Valid for a << R2; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    capped_paraboloid.fgm.tan.u.

    References
    ----------
    chapter 11, equation (11.80); Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.graded.tangential import capped_paraboloid
    >>> value = capped_paraboloid.tangential_displacement(
    ...     1.0, 0.6, R1=4.0, R2=1.0, b=0.5, H=1.0, H_x=0.8, k=0.25, mu=0.3
    ... )
    >>> round(value, 6)
    0.197366
    """
    normal._check(R1=R1, R2=R2, b=b, H=H, H_x=H_x, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_displacement, a, c, R1=R1, R2=R2, b=b, H=H, H_x=H_x, k=k, mu=mu)


def stick_radius(
    F_x: ArrayLike,
    a: ArrayLike,
    *,
    R1: ArrayLike,
    R2: ArrayLike,
    b: ArrayLike,
    H: ArrayLike,
    k: ArrayLike,
    mu: ArrayLike,
) -> Result:
    """Radius of the stick zone under a tangential force; NaN beyond full slip.

    c from mu*(4*H*a**(k + 3)/(R1*(k + 1)**2*(k + 3)) - 4*H*c**(k + 3)/(R1*(k + 1)**2*(k + 3))) = F_x   for a
    < b
    c from mu*(-4*H*c**(k + 3)/(R1*(k + 1)**2*(k + 3)) + 2*H*(2*a**(k + 3) + (R1 - R2)*(a**2 - b**2)**(k/2 +
    1/2)*(2*a**2 + b**2*k + b**2)/R2)/(R1*(k + 1)**2*(k + 3))) = F_x   for c < b and b < a
    c from mu*(2*H*(2*a**(k + 3) + (R1 - R2)*(a**2 - b**2)**(k/2 + 1/2)*(2*a**2 + b**2*k + b**2)/R2)/(R1*(k +
    1)**2*(k + 3)) - 2*H*(2*c**(k + 3) + (R1 - R2)*(-b**2 + c**2)**(k/2 + 1/2)*(b**2*k + b**2 +
    2*c**2)/R2)/(R1*(k + 1)**2*(k + 3))) = F_x   for b < c

    Parameters
    ----------
    F_x : array_like
        Tangential force [N].
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
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
    Valid for a << R2; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    capped_paraboloid.fgm.tan.c.

    References
    ----------
    chapter 11, equation (11.78); Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.graded.tangential import capped_paraboloid
    >>> value = capped_paraboloid.stick_radius(0.196, 1.0, R1=4.0, R2=1.0, b=0.5, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.600065
    """
    normal._check(R1=R1, R2=R2, b=b, H=H, k=k, mu=mu)
    return elementwise(_stick_radius, F_x, a, R1=R1, R2=R2, b=b, H=H, k=k, mu=mu)


def full_slip_displacement(
    a: ArrayLike,
    *,
    R1: ArrayLike,
    R2: ArrayLike,
    b: ArrayLike,
    H: ArrayLike,
    H_x: ArrayLike,
    k: ArrayLike,
    mu: ArrayLike,
) -> Result:
    """Tangential displacement at the onset of full slip.

    u_0 = H*a**2*mu/(H_x*R1*(k + 1))   for a < b
    u_0 = H*mu*(a**2 + a**(1 - k)*(R1 - R2)*(a**2 - b**2)**(k/2 + 1/2)/R2)/(H_x*R1*(k + 1))   for b < a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
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
    Valid for a << R2; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    capped_paraboloid.fgm.tan.us.

    References
    ----------
    chapter 11, equation (11.80); Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.graded.tangential import capped_paraboloid
    >>> value = capped_paraboloid.full_slip_displacement(1.0, R1=4.0, R2=1.0, b=0.5, H=1.0, H_x=0.8, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.262973
    """
    normal._check(R1=R1, R2=R2, b=b, H=H, H_x=H_x, k=k, mu=mu)
    return elementwise(_full_slip_displacement, a, R1=R1, R2=R2, b=b, H=H, H_x=H_x, k=k, mu=mu)


def _tangential_force(a: Array, c: Array, R1: Array, R2: Array, b: Array, H: Array, k: Array, mu: Array) -> Array:
    from ..._runtime.graded.slip import beyond_gain, power_gain

    power = power_gain("force", 0.0, c, a, 2.0, k) / (2 * R1)
    rim = beyond_gain("force", rim_force, rim_rate, (b,), 0.0, c, a, k) * (R1 - R2) / (R1 * R2)
    gain = power + rim
    return mu * (2.0 * H / (1.0 + k)) * gain


def _traction(r: Array, a: Array, c: Array, R1: Array, R2: Array, b: Array, H: Array, k: Array, mu: Array) -> Array:
    from ..._runtime.graded.pressure import rim_pressure
    from ..._runtime.graded.slip import beyond_gain, power_gain

    def gain() -> Array:
        inside = np.minimum(r, c)
        power = power_gain("pressure", inside, c, a, 2.0, k) / (2 * R1)
        rim = beyond_gain("pressure", rim_pressure, rim_rate, (b,), inside, c, a, k) * (R1 - R2) / (R1 * R2)
        return power + rim

    return mu * either(r < c, lambda: H / np.pi * gain(), lambda: normal._pressure(r, a, R1, R2, b, H, k))


def _tangential_displacement(
    a: Array, c: Array, R1: Array, R2: Array, b: Array, H: Array, H_x: Array, k: Array, mu: Array
) -> Array:
    from ..._runtime.graded.slip import beyond_gain, power_gain

    power = power_gain("depth", 0.0, c, a, 2.0, k) / (2 * R1)
    rim = beyond_gain("depth", rim_depth, rim_rate, (b,), 0.0, c, a, k) * (R1 - R2) / (R1 * R2)
    gain = power + rim
    return mu * (H / H_x) * gain


def _stick_radius(F_x: Array, a: Array, R1: Array, R2: Array, b: Array, H: Array, k: Array, mu: Array) -> Array:
    F = stick_force(normal._force(a, R1, R2, b, H, k), F_x, mu)
    return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force(F, R1, R2, b, H, k))


def _full_slip_displacement(
    a: Array, R1: Array, R2: Array, b: Array, H: Array, H_x: Array, k: Array, mu: Array
) -> Array:
    return mu * (H / H_x) * normal._depth(a, R1, R2, b, k)
