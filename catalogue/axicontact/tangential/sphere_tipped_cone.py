"""Cone with a spherical tip under a tangential load.

Sphere of radius R up to b = R sin(theta), then its tangent cone: the exact sphero-conical tip.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, numbers, require, require_order
from .._runtime.physics.slip import CLOSE, growth_below, growth_beyond, stick_force
from ..normal import sphere_tipped_cone as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["full_slip_displacement", "stick_radius", "tangential_displacement", "tangential_force", "traction"]


def __dir__() -> list[str]:
    return __all__


def tangential_force(
    a: ArrayLike, c: ArrayLike, *, R: ArrayLike, theta: ArrayLike, E_star: ArrayLike, mu: ArrayLike
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
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
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
    Handbook: sphere_tipped_cone.tan.F.

    References
    ----------
    chapter 11, equation (11.78).

    Examples
    --------
    >>> from axicontact.tangential import sphere_tipped_cone
    >>> value = sphere_tipped_cone.tangential_force(1.0, 0.6, R=1.2, theta=0.45, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.149507
    """
    require(R=R, theta=theta, E_star=E_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_force, a, c, R=R, theta=theta, E_star=E_star, mu=mu)


def traction(
    r: ArrayLike, a: ArrayLike, c: ArrayLike, *, R: ArrayLike, theta: ArrayLike, E_star: ArrayLike, mu: ArrayLike
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
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
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
    Handbook: sphere_tipped_cone.tan.tau.

    References
    ----------
    chapter 11, equation (11.79).

    Examples
    --------
    >>> from axicontact.tangential import sphere_tipped_cone
    >>> value = sphere_tipped_cone.traction(0.3, 1.0, 0.6, R=1.2, theta=0.45, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.041624
    """
    require(R=R, theta=theta, E_star=E_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_traction, r, a, c, R=R, theta=theta, E_star=E_star, mu=mu)


def tangential_displacement(
    a: ArrayLike, c: ArrayLike, *, R: ArrayLike, theta: ArrayLike, E_star: ArrayLike, G_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement of the indenter with a stick zone of radius c.

    u_0 = E_star*mu*(a*atanh(a/R) - c*atanh(c/R))/G_star   for a < b
    u_0 = E_star*mu*(a*(b*acos(b/a)/(sqrt(R - b)*sqrt(R + b)) + log((R + a)/(sqrt(R**2 - b**2) + sqrt(a**2 -
    b**2)))) - c*atanh(c/R))/G_star   for c < b and b < a
    u_0 = E_star*mu*(a*(b*acos(b/a)/(sqrt(R - b)*sqrt(R + b)) + log((R + a)/(sqrt(R**2 - b**2) + sqrt(a**2 -
    b**2)))) - c*(b*acos(b/c)/(sqrt(R - b)*sqrt(R + b)) + log((R + c)/(sqrt(R**2 - b**2) + sqrt(-b**2 +
    c**2)))))/G_star   for b < c
    with b = R*sin(theta)

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
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    G_star : array_like
        Effective shear modulus, 1/G_star = sum (2 - nu_i)/(4 G_i) [Pa], G_star > 0.
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
    Handbook: sphere_tipped_cone.tan.u.

    References
    ----------
    chapter 11, equation (11.80).

    Examples
    --------
    >>> from axicontact.tangential import sphere_tipped_cone
    >>> value = sphere_tipped_cone.tangential_displacement(
    ...     1.0, 0.6, R=1.2, theta=0.45, E_star=1.0, G_star=0.8, mu=0.3
    ... )
    >>> round(value, 6)
    0.11707
    """
    require(R=R, theta=theta, E_star=E_star, G_star=G_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_displacement, a, c, R=R, theta=theta, E_star=E_star, G_star=G_star, mu=mu)


def stick_radius(
    F_x: ArrayLike, a: ArrayLike, *, R: ArrayLike, theta: ArrayLike, E_star: ArrayLike, mu: ArrayLike
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
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
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
    Handbook: sphere_tipped_cone.tan.c.

    References
    ----------
    chapter 11, equation (11.78).

    Examples
    --------
    >>> from axicontact.tangential import sphere_tipped_cone
    >>> value = sphere_tipped_cone.stick_radius(0.1495, 1.0, R=1.2, theta=0.45, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.600024
    """
    require(R=R, theta=theta, E_star=E_star, mu=mu)
    return elementwise(_stick_radius, F_x, a, R=R, theta=theta, E_star=E_star, mu=mu)


def full_slip_displacement(
    a: ArrayLike, *, R: ArrayLike, theta: ArrayLike, E_star: ArrayLike, G_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement at the onset of full slip.

    u_0 = E_star*a*mu*atanh(a/R)/G_star   for a < b
    u_0 = E_star*a*mu*(b*acos(b/a)/(sqrt(R - b)*sqrt(R + b)) + log((R + a)/(sqrt(R**2 - b**2) + sqrt(a**2 -
    b**2))))/G_star   for b < a
    with b = R*sin(theta)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    G_star : array_like
        Effective shear modulus, 1/G_star = sum (2 - nu_i)/(4 G_i) [Pa], G_star > 0.
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
    Handbook: sphere_tipped_cone.tan.us.

    References
    ----------
    chapter 11, equation (11.80).

    Examples
    --------
    >>> from axicontact.tangential import sphere_tipped_cone
    >>> value = sphere_tipped_cone.full_slip_displacement(1.0, R=1.2, theta=0.45, E_star=1.0, G_star=0.8, mu=0.3)
    >>> round(value, 6)
    0.233488
    """
    require(R=R, theta=theta, E_star=E_star, G_star=G_star, mu=mu)
    return elementwise(_full_slip_displacement, a, R=R, theta=theta, E_star=E_star, G_star=G_star, mu=mu)


def _tangential_force(a: Array, c: Array, R: Array, theta: Array, E_star: Array, mu: Array) -> Array:
    whole, sticking = normal._force(a, R, theta, E_star), normal._force(c, R, theta, E_star)
    close = sticking >= CLOSE * whole
    b = R * np.sin(theta)
    tip = growth_below(normal._slope, (R,), 2, 0.0, c, np.minimum(a, b), R, close)
    beyond = growth_beyond(normal._slope_beyond, (R, theta), 2, 0.0, c, a, b, close, width=1.0 - 2.0 * theta / np.pi)
    gain = 2.0 * E_star * (tip + beyond)
    return mu * np.where(close, gain, whole - sticking)


def _traction(r: Array, a: Array, c: Array, R: Array, theta: Array, E_star: Array, mu: Array) -> Array:
    sliding = normal._pressure(r, a, R, theta, E_star)
    stuck = normal._pressure(r, c, R, theta, E_star)
    # both are infinite at a tip, and where the slope of the profile jumps
    close = (r < c) & (stuck >= CLOSE * sliding)
    b = R * np.sin(theta)
    tip = growth_below(normal._slope, (R,), 0, r, c, np.minimum(a, b), R, close)
    beyond = growth_beyond(normal._slope_beyond, (R, theta), 0, r, c, a, b, close, width=1.0 - 2.0 * theta / np.pi)
    gain = E_star / np.pi * (tip + beyond)
    return mu * np.where(close, gain, sliding - stuck)


def _tangential_displacement(
    a: Array, c: Array, R: Array, theta: Array, E_star: Array, G_star: Array, mu: Array
) -> Array:
    whole, sticking = normal._depth(a, R, theta), normal._depth(c, R, theta)
    close = sticking >= CLOSE * whole
    b = R * np.sin(theta)
    tip = growth_below(normal._slope, (R,), 1, 0.0, c, np.minimum(a, b), R, close)
    beyond = growth_beyond(normal._slope_beyond, (R, theta), 1, 0.0, c, a, b, close, width=1.0 - 2.0 * theta / np.pi)
    gain = tip + beyond
    return mu * (E_star / G_star) * np.where(close, gain, whole - sticking)


def _stick_radius(F_x: Array, a: Array, R: Array, theta: Array, E_star: Array, mu: Array) -> Array:
    F = stick_force(normal._force(a, R, theta, E_star), F_x, mu)
    return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force(F, R, theta, E_star))


def _full_slip_displacement(a: Array, R: Array, theta: Array, E_star: Array, G_star: Array, mu: Array) -> Array:
    return mu * (E_star / G_star) * normal._depth(a, R, theta)
