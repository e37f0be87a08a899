"""Cone under a tangential load.

Rigid cone of inclination theta. Self-similar: the mean pressure does not depend on the load.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, numbers, require, require_order
from .._runtime.physics.slip import arc_gain, gained_share, stick_force
from ..normal import cone as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["full_slip_displacement", "stick_radius", "tangential_displacement", "tangential_force", "traction"]


def __dir__() -> list[str]:
    return __all__


def tangential_force(a: ArrayLike, c: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike, mu: ArrayLike) -> Result:
    """Tangential force with a stick zone of radius c.

    F_x = mu*(pi*E_star*a**2*tan(theta)/2 - pi*E_star*c**2*tan(theta)/2)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
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
    Valid for tan(theta) << 1; a << size of the body; Cattaneo-Mindlin approximation. Negative or NaN field
    values give NaN. Handbook: cone.tan.F.

    References
    ----------
    chapter 11, equation (11.78); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.tangential import cone
    >>> value = cone.tangential_force(1.0, 0.6, theta=0.35, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.11009
    """
    require(theta=theta, E_star=E_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_force, a, c, theta=theta, E_star=E_star, mu=mu)


def traction(r: ArrayLike, a: ArrayLike, c: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike, mu: ArrayLike) -> Result:
    """Tangential traction; zero outside the contact.

    tau = E_star*mu*tan(theta)*acosh(a/r)/2   for c < r
    tau = mu*(E_star*tan(theta)*acosh(a/r)/2 - E_star*tan(theta)*acosh(c/r)/2)   for r < c

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
    Valid for tan(theta) << 1; a << size of the body; Cattaneo-Mindlin approximation. Negative or NaN field
    values give NaN. Handbook: cone.tan.tau.

    References
    ----------
    chapter 11, equation (11.79); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.tangential import cone
    >>> value = cone.traction(0.3, 1.0, 0.6, theta=0.35, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.030491
    """
    require(theta=theta, E_star=E_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_traction, r, a, c, theta=theta, E_star=E_star, mu=mu)


def tangential_displacement(
    a: ArrayLike, c: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike, G_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement of the indenter with a stick zone of radius c.

    u_0 = E_star*mu*(pi*a*tan(theta)/2 - pi*c*tan(theta)/2)/G_star

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
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
    Valid for tan(theta) << 1; a << size of the body; Cattaneo-Mindlin approximation. Negative or NaN field
    values give NaN. Handbook: cone.tan.u.

    References
    ----------
    chapter 11, equation (11.80); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.tangential import cone
    >>> value = cone.tangential_displacement(1.0, 0.6, theta=0.35, E_star=1.0, G_star=0.8, mu=0.3)
    >>> round(value, 6)
    0.086008
    """
    require(theta=theta, E_star=E_star, G_star=G_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_displacement, a, c, theta=theta, E_star=E_star, G_star=G_star, mu=mu)


def stick_radius(F_x: ArrayLike, a: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike, mu: ArrayLike) -> Result:
    """Radius of the stick zone under a tangential force; NaN beyond full slip.

    c = a*sqrt(1 - 2*F_x/(pi*E_star*a**2*mu*tan(theta)))

    Parameters
    ----------
    F_x : array_like
        Tangential force [N].
    a : array_like
        Contact radius [m].
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
    Valid for tan(theta) << 1; a << size of the body; Cattaneo-Mindlin approximation. Negative or NaN field
    values give NaN. Handbook: cone.tan.c.

    References
    ----------
    chapter 11, equation (11.78); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.tangential import cone
    >>> value = cone.stick_radius(0.1101, 1.0, theta=0.35, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.599952
    """
    require(theta=theta, E_star=E_star, mu=mu)
    return elementwise(_stick_radius, F_x, a, theta=theta, E_star=E_star, mu=mu)


def full_slip_displacement(
    a: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike, G_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement at the onset of full slip.

    u_0 = pi*E_star*a*mu*tan(theta)/(2*G_star)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
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
    Valid for tan(theta) << 1; a << size of the body; Cattaneo-Mindlin approximation. Negative or NaN field
    values give NaN. Handbook: cone.tan.us.

    References
    ----------
    chapter 11, equation (11.80); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.tangential import cone
    >>> value = cone.full_slip_displacement(1.0, theta=0.35, E_star=1.0, G_star=0.8, mu=0.3)
    >>> round(value, 6)
    0.21502
    """
    require(theta=theta, E_star=E_star, G_star=G_star, mu=mu)
    return elementwise(_full_slip_displacement, a, theta=theta, E_star=E_star, G_star=G_star, mu=mu)


def _tangential_force(a: Array, c: Array, theta: Array, E_star: Array, mu: Array) -> Array:
    return mu * normal._force(a, theta, E_star) * gained_share(c, a, 2.0)


def _traction(r: Array, a: Array, c: Array, theta: Array, E_star: Array, mu: Array) -> Array:
    sliding = normal._pressure(r, a, theta, E_star)
    gain = E_star / np.pi * normal._slope(1.0, theta) * arc_gain(r, c, a)
    return mu * np.where(r < c, gain, sliding)


def _tangential_displacement(a: Array, c: Array, theta: Array, E_star: Array, G_star: Array, mu: Array) -> Array:
    return mu * (E_star / G_star) * normal._depth(a, theta) * gained_share(c, a, 1.0)


def _stick_radius(F_x: Array, a: Array, theta: Array, E_star: Array, mu: Array) -> Array:
    F = stick_force(normal._force(a, theta, E_star), F_x, mu)
    return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force(F, theta, E_star))


def _full_slip_displacement(a: Array, theta: Array, E_star: Array, G_star: Array, mu: Array) -> Array:
    return mu * (E_star / G_star) * normal._depth(a, theta)
