"""Cone with a rounded tip under a tangential load on a power-law graded half-space.

Parabolic tip running tangentially into a cone at r = b.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.breaks import rounded_depth, rounded_force, rounded_rate
from ..._runtime.interface import Array, Result, either, elementwise, numbers, require, require_order
from ..._runtime.physics.slip import stick_force
from ..normal import rounded_cone as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["full_slip_displacement", "stick_radius", "tangential_displacement", "tangential_force", "traction"]


def __dir__() -> list[str]:
    return __all__


def tangential_force(
    a: ArrayLike, c: ArrayLike, *, theta: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential force with a stick zone of radius c.

    F_x = mu*(F(a) - F(c))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN.
    Handbook: rounded_cone.fgm.tan.F.

    References
    ----------
    chapter 11, equation (11.78); Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.graded.tangential import rounded_cone
    >>> value = rounded_cone.tangential_force(1.0, 0.6, theta=0.42, b=0.5, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.089291
    """
    require(theta=theta, b=b, H=H, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_force, a, c, theta=theta, b=b, H=H, k=k, mu=mu)


def traction(
    r: ArrayLike,
    a: ArrayLike,
    c: ArrayLike,
    *,
    theta: ArrayLike,
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
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN.
    Handbook: rounded_cone.fgm.tan.tau.

    References
    ----------
    chapter 11, equation (11.79); Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.graded.tangential import rounded_cone
    >>> value = rounded_cone.traction(0.3, 1.0, 0.6, theta=0.42, b=0.5, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.029997
    """
    require(theta=theta, b=b, H=H, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_traction, r, a, c, theta=theta, b=b, H=H, k=k, mu=mu)


def tangential_displacement(
    a: ArrayLike,
    c: ArrayLike,
    *,
    theta: ArrayLike,
    b: ArrayLike,
    H: ArrayLike,
    H_x: ArrayLike,
    k: ArrayLike,
    mu: ArrayLike,
) -> Result:
    """Tangential displacement of the indenter with a stick zone of radius c.

    u_0 = H*mu*(a**2*tan(theta)/(b*(k + 1)) - c**2*tan(theta)/(b*(k + 1)))/H_x   for a < b
    u_0 = H*mu*((a**2/(b*(k + 1)) + a*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2)/2 - a**(1 - k)*(a**2 -
    b**2)**(k/2 + 1/2)/(b*(k + 1)))*tan(theta) - c**2*tan(theta)/(b*(k + 1)))/H_x   for c < b and b < a
    u_0 = H*mu*(-(c*IncompleteBeta(-b**2/c**2 + 1, (k + 1)/2, 1/2)/2 + c**2/(b*(k + 1)) - c**(1 - k)*(-b**2 +
    c**2)**(k/2 + 1/2)/(b*(k + 1)))*tan(theta) + (a**2/(b*(k + 1)) + a*IncompleteBeta(1 - b**2/a**2, (k +
    1)/2, 1/2)/2 - a**(1 - k)*(a**2 - b**2)**(k/2 + 1/2)/(b*(k + 1)))*tan(theta))/H_x   for b < c
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN.
    Handbook: rounded_cone.fgm.tan.u.

    References
    ----------
    chapter 11, equation (11.80); Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.graded.tangential import rounded_cone
    >>> value = rounded_cone.tangential_displacement(1.0, 0.6, theta=0.42, b=0.5, H=1.0, H_x=0.8, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.092056
    """
    require(theta=theta, b=b, H=H, H_x=H_x, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_displacement, a, c, theta=theta, b=b, H=H, H_x=H_x, k=k, mu=mu)


def stick_radius(
    F_x: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Radius of the stick zone under a tangential force; NaN beyond full slip.

    c from mu*(F(a) - F(c)) = F_x

    Parameters
    ----------
    F_x : array_like
        Tangential force [N].
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN.
    Handbook: rounded_cone.fgm.tan.c.

    References
    ----------
    chapter 11, equation (11.78); Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.graded.tangential import rounded_cone
    >>> value = rounded_cone.stick_radius(0.08929, 1.0, theta=0.42, b=0.5, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.600004
    """
    require(theta=theta, b=b, H=H, k=k, mu=mu)
    return elementwise(_stick_radius, F_x, a, theta=theta, b=b, H=H, k=k, mu=mu)


def full_slip_displacement(
    a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, H: ArrayLike, H_x: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement at the onset of full slip.

    u_0 = H*a**2*mu*tan(theta)/(H_x*b*(k + 1))   for a < b
    u_0 = H*mu*(a**2/(b*(k + 1)) + a*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2)/2 - a**(1 - k)*(a**2 -
    b**2)**(k/2 + 1/2)/(b*(k + 1)))*tan(theta)/H_x   for b < a
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN.
    Handbook: rounded_cone.fgm.tan.us.

    References
    ----------
    chapter 11, equation (11.80); Ciavarella 1999; Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.graded.tangential import rounded_cone
    >>> value = rounded_cone.full_slip_displacement(1.0, theta=0.42, b=0.5, H=1.0, H_x=0.8, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.183499
    """
    require(theta=theta, b=b, H=H, H_x=H_x, k=k, mu=mu)
    return elementwise(_full_slip_displacement, a, theta=theta, b=b, H=H, H_x=H_x, k=k, mu=mu)


def _tangential_force(a: Array, c: Array, theta: Array, b: Array, H: Array, k: Array, mu: Array) -> Array:
    from ..._runtime.graded.slip import rounded_gain

    gain = rounded_gain("force", rounded_force, rounded_rate, (b,), 0.0, c, a, k) * np.tan(theta)
    return mu * (2.0 * H / (1.0 + k)) * gain


def _traction(r: Array, a: Array, c: Array, theta: Array, b: Array, H: Array, k: Array, mu: Array) -> Array:
    from ..._runtime.graded.pressure import rounded_pressure
    from ..._runtime.graded.slip import rounded_gain

    def gain() -> Array:
        inside = np.minimum(r, c)
        return rounded_gain("pressure", rounded_pressure, rounded_rate, (b,), inside, c, a, k) * np.tan(theta)

    return mu * either(r < c, lambda: H / np.pi * gain(), lambda: normal._pressure(r, a, theta, b, H, k))


def _tangential_displacement(
    a: Array, c: Array, theta: Array, b: Array, H: Array, H_x: Array, k: Array, mu: Array
) -> Array:
    from ..._runtime.graded.slip import rounded_gain

    gain = rounded_gain("depth", rounded_depth, rounded_rate, (b,), 0.0, c, a, k) * np.tan(theta)
    return mu * (H / H_x) * gain


def _stick_radius(F_x: Array, a: Array, theta: Array, b: Array, H: Array, k: Array, mu: Array) -> Array:
    F = stick_force(normal._force(a, theta, b, H, k), F_x, mu)
    return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force(F, theta, b, H, k))


def _full_slip_displacement(a: Array, theta: Array, b: Array, H: Array, H_x: Array, k: Array, mu: Array) -> Array:
    return mu * (H / H_x) * normal._depth(a, theta, b, k)
