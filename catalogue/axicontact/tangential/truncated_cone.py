"""Truncated cone under a tangential load.

Flat face of radius b with a conical flank: a worn or blunted cone. The contact radius starts at b.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, numbers, require, require_order, require_reach
from .._runtime.physics.slip import CLOSE, growth_beyond, stick_force
from ..normal import truncated_cone as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["full_slip_displacement", "stick_radius", "tangential_displacement", "tangential_force", "traction"]


def __dir__() -> list[str]:
    return __all__


def tangential_force(
    a: ArrayLike, c: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential force with a stick zone of radius c.

    F_x = mu*(E_star*(a**2*acos(b/a) + b*sqrt(a**2 - b**2))*tan(theta) - E_star*(b*sqrt(-b**2 + c**2) +
    c**2*acos(b/c))*tan(theta))

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
    Valid for tan(theta) << 1; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. The
    stick zone is never smaller than the flat face: NaN for c < b. Handbook: truncated_cone.tan.F.

    References
    ----------
    chapter 11, equation (11.78); Ejike 1981.

    Examples
    --------
    >>> from axicontact.tangential import truncated_cone
    >>> value = truncated_cone.tangential_force(1.0, 0.8, theta=0.42, b=0.5, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.079678
    """
    require(theta=theta, b=b, E_star=E_star, mu=mu)
    require_reach(a, b)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_force, a, c, theta=theta, b=b, E_star=E_star, mu=mu)


def traction(
    r: ArrayLike, a: ArrayLike, c: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential traction; zero outside the contact.

    tau = mu*(E_star*(C0(b, r, a) + elliptic_f(asin(sqrt((a**2 - b**2)/(a**2 - r**2))),
    r**2/b**2))*tan(theta)/pi - E_star*(C0(b, r, c) + elliptic_f(asin(sqrt((-b**2 + c**2)/(c**2 - r**2))),
    r**2/b**2))*tan(theta)/pi)   for r < b
    tau = E_star*mu*(b*elliptic_f(asin(sqrt((a**2 - r**2)/(a**2 - b**2))), b**2/r**2)/r + C0(b, r,
    a))*tan(theta)/pi   for c < r
    tau = mu*(E_star*(b*elliptic_f(asin(sqrt((a**2 - r**2)/(a**2 - b**2))), b**2/r**2)/r + C0(b, r,
    a))*tan(theta)/pi - E_star*(b*elliptic_f(asin(sqrt((c**2 - r**2)/(-b**2 + c**2))), b**2/r**2)/r + C0(b, r,
    c))*tan(theta)/pi)   for b < r and r < c
    with C0(b, r, a) = int_{max(b, r)}^a acos(b/t) / sqrt(t**2 - r**2) dt, for 0 <= b, r < a
    with elliptic integrals of the parameter m = k**2, their last argument

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
    Valid for tan(theta) << 1; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. The
    stick zone is never smaller than the flat face: NaN for c < b. Handbook: truncated_cone.tan.tau.

    References
    ----------
    chapter 11, equation (11.79); Ejike 1981.

    Examples
    --------
    >>> from axicontact.tangential import truncated_cone
    >>> value = truncated_cone.traction(0.3, 1.0, 0.8, theta=0.42, b=0.5, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.016726
    """
    require(theta=theta, b=b, E_star=E_star, mu=mu)
    require_reach(a, b)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_traction, r, a, c, theta=theta, b=b, E_star=E_star, mu=mu)


def tangential_displacement(
    a: ArrayLike, c: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike, G_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement of the indenter with a stick zone of radius c.

    u_0 = E_star*mu*(a*tan(theta)*acos(b/a) - c*tan(theta)*acos(b/c))/G_star

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
    Valid for tan(theta) << 1; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. The
    stick zone is never smaller than the flat face: NaN for c < b. Handbook: truncated_cone.tan.u.

    References
    ----------
    chapter 11, equation (11.80); Ejike 1981.

    Examples
    --------
    >>> from axicontact.tangential import truncated_cone
    >>> value = truncated_cone.tangential_displacement(1.0, 0.8, theta=0.42, b=0.5, E_star=1.0, G_star=0.8, mu=0.3)
    >>> round(value, 6)
    0.055375
    """
    require(theta=theta, b=b, E_star=E_star, G_star=G_star, mu=mu)
    require_reach(a, b)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_displacement, a, c, theta=theta, b=b, E_star=E_star, G_star=G_star, mu=mu)


def stick_radius(
    F_x: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Radius of the stick zone under a tangential force; NaN beyond full slip.

    c from mu*(E_star*(a**2*acos(b/a) + b*sqrt(a**2 - b**2))*tan(theta) - E_star*(b*sqrt(-b**2 + c**2) +
    c**2*acos(b/c))*tan(theta)) = F_x

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
    Valid for tan(theta) << 1; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. The
    stick zone is never smaller than the flat face: NaN for c < b. Handbook: truncated_cone.tan.c.

    References
    ----------
    chapter 11, equation (11.78); Ejike 1981.

    Examples
    --------
    >>> from axicontact.tangential import truncated_cone
    >>> value = truncated_cone.stick_radius(0.07968, 1.0, theta=0.42, b=0.5, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.799994
    """
    require(theta=theta, b=b, E_star=E_star, mu=mu)
    require_reach(a, b)
    return elementwise(_stick_radius, F_x, a, theta=theta, b=b, E_star=E_star, mu=mu)


def full_slip_displacement(
    a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike, G_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement at the onset of full slip.

    u_0 = E_star*a*mu*tan(theta)*acos(b/a)/G_star

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. The
    stick zone is never smaller than the flat face: NaN for c < b. Handbook: truncated_cone.tan.us.

    References
    ----------
    chapter 11, equation (11.80); Ejike 1981.

    Examples
    --------
    >>> from axicontact.tangential import truncated_cone
    >>> value = truncated_cone.full_slip_displacement(1.0, theta=0.42, b=0.5, E_star=1.0, G_star=0.8, mu=0.3)
    >>> round(value, 6)
    0.175369
    """
    require(theta=theta, b=b, E_star=E_star, G_star=G_star, mu=mu)
    require_reach(a, b)
    return elementwise(_full_slip_displacement, a, theta=theta, b=b, E_star=E_star, G_star=G_star, mu=mu)


def _tangential_force(a: Array, c: Array, theta: Array, b: Array, E_star: Array, mu: Array) -> Array:
    whole, sticking = normal._force(a, theta, b, E_star), normal._force(c, theta, b, E_star)
    close = sticking >= CLOSE * whole
    gain = 2.0 * E_star * growth_beyond(normal._slope_beyond, (theta, b), 2, 0.0, c, a, b, close)
    return mu * np.where(close, gain, whole - sticking)


def _traction(r: Array, a: Array, c: Array, theta: Array, b: Array, E_star: Array, mu: Array) -> Array:
    sliding = normal._pressure(r, a, theta, b, E_star)
    stuck = normal._pressure(r, c, theta, b, E_star)
    # both are infinite at a tip, and where the slope of the profile jumps
    close = (r < c) & (stuck >= CLOSE * sliding)
    gain = E_star / np.pi * growth_beyond(normal._slope_beyond, (theta, b), 0, r, c, a, b, close)
    return mu * np.where(close, gain, sliding - stuck)


def _tangential_displacement(
    a: Array, c: Array, theta: Array, b: Array, E_star: Array, G_star: Array, mu: Array
) -> Array:
    whole, sticking = normal._depth(a, theta, b), normal._depth(c, theta, b)
    close = sticking >= CLOSE * whole
    gain = growth_beyond(normal._slope_beyond, (theta, b), 1, 0.0, c, a, b, close)
    return mu * (E_star / G_star) * np.where(close, gain, whole - sticking)


def _stick_radius(F_x: Array, a: Array, theta: Array, b: Array, E_star: Array, mu: Array) -> Array:
    F = stick_force(normal._force(a, theta, b, E_star), F_x, mu)
    return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force(F, theta, b, E_star))


def _full_slip_displacement(a: Array, theta: Array, b: Array, E_star: Array, G_star: Array, mu: Array) -> Array:
    return mu * (E_star / G_star) * normal._depth(a, theta, b)
