"""Cone with a spherical tip under a tangential load on a power-law graded half-space.

Sphere of radius R up to b = R sin(theta), then its tangent cone: the exact sphero-conical tip.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.breaks import tipped_depth, tipped_force, tipped_rate
from ..._runtime.interface import Array, Result, either, elementwise, numbers, require, require_order
from ..._runtime.physics.slip import stick_force
from ..normal import sphere_tipped_cone as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["full_slip_displacement", "stick_radius", "tangential_displacement", "tangential_force", "traction"]


def __dir__() -> list[str]:
    return __all__


def tangential_force(
    a: ArrayLike, c: ArrayLike, *, R: ArrayLike, theta: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential force with a stick zone of radius c.

    F_x = mu*(F(a) - F(c))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Handbook: sphere_tipped_cone.fgm.tan.F.

    References
    ----------
    chapter 11, equation (11.78).

    Examples
    --------
    >>> from axicontact.graded.tangential import sphere_tipped_cone
    >>> value = sphere_tipped_cone.tangential_force(1.0, 0.6, R=1.2, theta=0.45, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.097089
    """
    require(R=R, theta=theta, H=H, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_force, a, c, R=R, theta=theta, H=H, k=k, mu=mu)


def traction(
    r: ArrayLike,
    a: ArrayLike,
    c: ArrayLike,
    *,
    R: ArrayLike,
    theta: ArrayLike,
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
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Handbook: sphere_tipped_cone.fgm.tan.tau.

    References
    ----------
    chapter 11, equation (11.79).

    Examples
    --------
    >>> from axicontact.graded.tangential import sphere_tipped_cone
    >>> value = sphere_tipped_cone.traction(0.3, 1.0, 0.6, R=1.2, theta=0.45, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.032654
    """
    require(R=R, theta=theta, H=H, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_traction, r, a, c, R=R, theta=theta, H=H, k=k, mu=mu)


def tangential_displacement(
    a: ArrayLike,
    c: ArrayLike,
    *,
    R: ArrayLike,
    theta: ArrayLike,
    H: ArrayLike,
    H_x: ArrayLike,
    k: ArrayLike,
    mu: ArrayLike,
) -> Result:
    """Tangential displacement of the indenter with a stick zone of radius c.

    u_0 = H*mu*(a**2*2F1(1/2, 1, (k + 3)/2, a**2/R**2)/(R*(k + 1)) - c**2*2F1(1/2, 1, (k
    + 3)/2, c**2/R**2)/(R*(k + 1)))/H_x   for a < b
    u_0 = H*mu*(a*b*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2)/(2*sqrt(R - b)*sqrt(R + b)) + a**(1 -
    k)*CapMoment(k, b, R, a) - c**2*2F1(1/2, 1, (k + 3)/2, c**2/R**2)/(R*(k + 1)))/H_x   for c < b
    and b < a
    u_0 = H*mu*(a*b*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2)/(2*sqrt(R - b)*sqrt(R + b)) + a**(1 -
    k)*CapMoment(k, b, R, a) - b*c*IncompleteBeta(-b**2/c**2 + 1, (k + 1)/2, 1/2)/(2*sqrt(R - b)*sqrt(R + b))
    - c**(1 - k)*CapMoment(k, b, R, c))/H_x   for b < c
    with b = R*sin(theta)
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)
    with CapMoment: J(k; b, R, a) = int_0^b s (R**2 - s**2)**(-1/2) (a**2 - s**2)**((k - 1)/2) ds, for b < a,
    b < R

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Handbook: sphere_tipped_cone.fgm.tan.u.

    References
    ----------
    chapter 11, equation (11.80).

    Examples
    --------
    >>> from axicontact.graded.tangential import sphere_tipped_cone
    >>> value = sphere_tipped_cone.tangential_displacement(
    ...     1.0, 0.6, R=1.2, theta=0.45, H=1.0, H_x=0.8, k=0.25, mu=0.3
    ... )
    >>> round(value, 6)
    0.100159
    """
    require(R=R, theta=theta, H=H, H_x=H_x, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_displacement, a, c, R=R, theta=theta, H=H, H_x=H_x, k=k, mu=mu)


def stick_radius(
    F_x: ArrayLike, a: ArrayLike, *, R: ArrayLike, theta: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Radius of the stick zone under a tangential force; NaN beyond full slip.

    c from mu*(F(a) - F(c)) = F_x

    Parameters
    ----------
    F_x : array_like
        Tangential force [N].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Handbook: sphere_tipped_cone.fgm.tan.c.

    References
    ----------
    chapter 11, equation (11.78).

    Examples
    --------
    >>> from axicontact.graded.tangential import sphere_tipped_cone
    >>> value = sphere_tipped_cone.stick_radius(0.09709, 1.0, R=1.2, theta=0.45, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.599992
    """
    require(R=R, theta=theta, H=H, k=k, mu=mu)
    return elementwise(_stick_radius, F_x, a, R=R, theta=theta, H=H, k=k, mu=mu)


def full_slip_displacement(
    a: ArrayLike, *, R: ArrayLike, theta: ArrayLike, H: ArrayLike, H_x: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement at the onset of full slip.

    u_0 = H*a**2*mu*2F1(1/2, 1, (k + 3)/2, a**2/R**2)/(H_x*R*(k + 1))   for a < b
    u_0 = H*mu*(a*b*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2)/(2*sqrt(R - b)*sqrt(R + b)) + a**(1 -
    k)*CapMoment(k, b, R, a))/H_x   for b < a
    with b = R*sin(theta)
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)
    with CapMoment: J(k; b, R, a) = int_0^b s (R**2 - s**2)**(-1/2) (a**2 - s**2)**((k - 1)/2) ds, for b < a,
    b < R

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Handbook: sphere_tipped_cone.fgm.tan.us.

    References
    ----------
    chapter 11, equation (11.80).

    Examples
    --------
    >>> from axicontact.graded.tangential import sphere_tipped_cone
    >>> value = sphere_tipped_cone.full_slip_displacement(1.0, R=1.2, theta=0.45, H=1.0, H_x=0.8, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.193817
    """
    require(R=R, theta=theta, H=H, H_x=H_x, k=k, mu=mu)
    return elementwise(_full_slip_displacement, a, R=R, theta=theta, H=H, H_x=H_x, k=k, mu=mu)


def _tangential_force(a: Array, c: Array, R: Array, theta: Array, H: Array, k: Array, mu: Array) -> Array:
    from ..._runtime.graded.slip import tipped_gain

    b = R * np.sin(theta)
    gain = tipped_gain("force", tipped_force, tipped_rate, (R, b, R * np.cos(theta)), 0.0, c, a, k)
    return mu * (2.0 * H / (1.0 + k)) * gain


def _traction(r: Array, a: Array, c: Array, R: Array, theta: Array, H: Array, k: Array, mu: Array) -> Array:
    from ..._runtime.graded.pressure import tipped_pressure
    from ..._runtime.graded.slip import tipped_gain

    b = R * np.sin(theta)

    def gain() -> Array:
        inside = np.minimum(r, c)
        return tipped_gain("pressure", tipped_pressure, tipped_rate, (R, b, R * np.cos(theta)), inside, c, a, k)

    return mu * either(r < c, lambda: H / np.pi * gain(), lambda: normal._pressure(r, a, R, theta, H, k))


def _tangential_displacement(
    a: Array, c: Array, R: Array, theta: Array, H: Array, H_x: Array, k: Array, mu: Array
) -> Array:
    from ..._runtime.graded.slip import tipped_gain

    b = R * np.sin(theta)
    gain = tipped_gain("depth", tipped_depth, tipped_rate, (R, b, R * np.cos(theta)), 0.0, c, a, k)
    return mu * (H / H_x) * gain


def _stick_radius(F_x: Array, a: Array, R: Array, theta: Array, H: Array, k: Array, mu: Array) -> Array:
    F = stick_force(normal._force(a, R, theta, H, k), F_x, mu)
    return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force(F, R, theta, H, k))


def _full_slip_displacement(a: Array, R: Array, theta: Array, H: Array, H_x: Array, k: Array, mu: Array) -> Array:
    return mu * (H / H_x) * normal._depth(a, R, theta, k)
