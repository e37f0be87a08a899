"""Gaussian bump under a tangential load.

A smooth asperity of height h and width s; compact up to the radius of largest depth.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, numbers, require, require_order
from .._runtime.physics.slip import CLOSE, growth, stick_force
from ..normal import gaussian as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["full_slip_displacement", "stick_radius", "tangential_displacement", "tangential_force", "traction"]


def __dir__() -> list[str]:
    return __all__


def tangential_force(
    a: ArrayLike, c: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential force with a stick zone of radius c.

    F_x = mu*(2*E_star*h*(-a + (2*a**2 + s**2)*Dawson(a/s)/s) - 2*E_star*h*(-c + (2*c**2 +
    s**2)*Dawson(c/s)/s))
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    gaussian.tan.F.

    References
    ----------
    chapter 11, equation (11.78); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.tangential import gaussian
    >>> value = gaussian.tangential_force(1.0, 0.6, h=0.7, s=1.0, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.167011
    """
    require(h=h, s=s, E_star=E_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_force, a, c, h=h, s=s, E_star=E_star, mu=mu)


def traction(
    r: ArrayLike, a: ArrayLike, c: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential traction; zero outside the contact.

    tau = E_star*mu*Integral((2*h*Dawson(sqrt(r**2 + u**2)/s)/s + 2*h*(1 - 2*sqrt(r**2 +
    u**2)*Dawson(sqrt(r**2 + u**2)/s)/s)*sqrt(r**2 + u**2)/s**2)/sqrt(r**2 + u**2), (u, 0, sqrt(a**2 -
    r**2)))/pi   for c < r
    tau = mu*(E_star*Integral((2*h*Dawson(sqrt(r**2 + u**2)/s)/s + 2*h*(1 - 2*sqrt(r**2 +
    u**2)*Dawson(sqrt(r**2 + u**2)/s)/s)*sqrt(r**2 + u**2)/s**2)/sqrt(r**2 + u**2), (u, 0, sqrt(a**2 -
    r**2)))/pi - E_star*Integral((2*h*Dawson(sqrt(r**2 + u**2)/s)/s + 2*h*(1 - 2*sqrt(r**2 +
    u**2)*Dawson(sqrt(r**2 + u**2)/s)/s)*sqrt(r**2 + u**2)/s**2)/sqrt(r**2 + u**2), (u, 0, sqrt(c**2 -
    r**2)))/pi)   for r < c
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    gaussian.tan.tau.

    References
    ----------
    chapter 11, equation (11.79); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.tangential import gaussian
    >>> value = gaussian.traction(0.3, 1.0, 0.6, h=0.7, s=1.0, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.048144
    """
    require(h=h, s=s, E_star=E_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_traction, r, a, c, h=h, s=s, E_star=E_star, mu=mu)


def tangential_displacement(
    a: ArrayLike, c: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike, G_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement of the indenter with a stick zone of radius c.

    u_0 = E_star*mu*(2*a*h*Dawson(a/s)/s - 2*c*h*Dawson(c/s)/s)/G_star
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    gaussian.tan.u.

    References
    ----------
    chapter 11, equation (11.80); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.tangential import gaussian
    >>> value = gaussian.tangential_displacement(1.0, 0.6, h=0.7, s=1.0, E_star=1.0, G_star=0.8, mu=0.3)
    >>> round(value, 6)
    0.132941
    """
    require(h=h, s=s, E_star=E_star, G_star=G_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_displacement, a, c, h=h, s=s, E_star=E_star, G_star=G_star, mu=mu)


def stick_radius(
    F_x: ArrayLike, a: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Radius of the stick zone under a tangential force; NaN beyond full slip.

    c from mu*(2*E_star*h*(-a + (2*a**2 + s**2)*Dawson(a/s)/s) - 2*E_star*h*(-c + (2*c**2 +
    s**2)*Dawson(c/s)/s)) = F_x
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    F_x : array_like
        Tangential force [N].
    a : array_like
        Contact radius [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    gaussian.tan.c.

    References
    ----------
    chapter 11, equation (11.78); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.tangential import gaussian
    >>> value = gaussian.stick_radius(0.167, 1.0, h=0.7, s=1.0, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.60003
    """
    require(h=h, s=s, E_star=E_star, mu=mu)
    return elementwise(_stick_radius, F_x, a, h=h, s=s, E_star=E_star, mu=mu)


def full_slip_displacement(
    a: ArrayLike, *, h: ArrayLike, s: ArrayLike, E_star: ArrayLike, G_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement at the onset of full slip.

    u_0 = 2*E_star*a*h*mu*Dawson(a/s)/(G_star*s)
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    gaussian.tan.us.

    References
    ----------
    chapter 11, equation (11.80); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.tangential import gaussian
    >>> value = gaussian.full_slip_displacement(1.0, h=0.7, s=1.0, E_star=1.0, G_star=0.8, mu=0.3)
    >>> round(value, 6)
    0.282492
    """
    require(h=h, s=s, E_star=E_star, G_star=G_star, mu=mu)
    return elementwise(_full_slip_displacement, a, h=h, s=s, E_star=E_star, G_star=G_star, mu=mu)


def _tangential_force(a: Array, c: Array, h: Array, s: Array, E_star: Array, mu: Array) -> Array:
    whole, sticking = normal._force(a, h, s, E_star), normal._force(c, h, s, E_star)
    close = sticking >= CLOSE * whole
    gain = 2.0 * E_star * growth(normal._slope, (h, s), 2, 0.0, c, a, close)
    return mu * np.where(close, gain, whole - sticking)


def _traction(r: Array, a: Array, c: Array, h: Array, s: Array, E_star: Array, mu: Array) -> Array:
    sliding = normal._pressure(r, a, h, s, E_star)
    stuck = normal._pressure(r, c, h, s, E_star)
    # both are infinite at a tip, and where the slope of the profile jumps
    close = (r < c) & (stuck >= CLOSE * sliding)
    gain = E_star / np.pi * growth(normal._slope, (h, s), 0, r, c, a, close)
    return mu * np.where(close, gain, sliding - stuck)


def _tangential_displacement(a: Array, c: Array, h: Array, s: Array, E_star: Array, G_star: Array, mu: Array) -> Array:
    whole, sticking = normal._depth(a, h, s), normal._depth(c, h, s)
    close = sticking >= CLOSE * whole
    gain = growth(normal._slope, (h, s), 1, 0.0, c, a, close)
    return mu * (E_star / G_star) * np.where(close, gain, whole - sticking)


def _stick_radius(F_x: Array, a: Array, h: Array, s: Array, E_star: Array, mu: Array) -> Array:
    F = stick_force(normal._force(a, h, s, E_star), F_x, mu)
    return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force(F, h, s, E_star))


def _full_slip_displacement(a: Array, h: Array, s: Array, E_star: Array, G_star: Array, mu: Array) -> Array:
    return mu * (E_star / G_star) * normal._depth(a, h, s)
