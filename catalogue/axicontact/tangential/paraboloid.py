"""Paraboloid under a tangential load.

The tip of every smooth indenter and the parabolic approximation of the sphere: Hertz's contact.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, numbers, require, require_order
from .._runtime.physics.slip import gained_share, root_gain, stick_force
from ..normal import paraboloid as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["full_slip_displacement", "stick_radius", "tangential_displacement", "tangential_force", "traction"]


def __dir__() -> list[str]:
    return __all__


def tangential_force(a: ArrayLike, c: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, mu: ArrayLike) -> Result:
    """Tangential force with a stick zone of radius c.

    F_x = mu*(4*E_star*a**3/(3*R) - 4*E_star*c**3/(3*R))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    paraboloid.tan.F.

    References
    ----------
    chapter 11, equation (11.78); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.tangential import paraboloid
    >>> value = paraboloid.tangential_force(1.0, 0.6, R=1.6, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.196
    """
    require(R=R, E_star=E_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_force, a, c, R=R, E_star=E_star, mu=mu)


def traction(r: ArrayLike, a: ArrayLike, c: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, mu: ArrayLike) -> Result:
    """Tangential traction; zero outside the contact.

    tau = 2*E_star*mu*sqrt(a**2 - r**2)/(pi*R)   for c < r
    tau = mu*(2*E_star*sqrt(a**2 - r**2)/(pi*R) - 2*E_star*sqrt(c**2 - r**2)/(pi*R))   for r < c

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
    Valid for a << R; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    paraboloid.tan.tau.

    References
    ----------
    chapter 11, equation (11.79); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.tangential import paraboloid
    >>> value = paraboloid.traction(0.3, 1.0, 0.6, R=1.6, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.051844
    """
    require(R=R, E_star=E_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_traction, r, a, c, R=R, E_star=E_star, mu=mu)


def tangential_displacement(
    a: ArrayLike, c: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, G_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement of the indenter with a stick zone of radius c.

    u_0 = E_star*mu*(a**2/R - c**2/R)/G_star

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    paraboloid.tan.u.

    References
    ----------
    chapter 11, equation (11.80); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.tangential import paraboloid
    >>> value = paraboloid.tangential_displacement(1.0, 0.6, R=1.6, E_star=1.0, G_star=0.8, mu=0.3)
    >>> round(value, 6)
    0.15
    """
    require(R=R, E_star=E_star, G_star=G_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_displacement, a, c, R=R, E_star=E_star, G_star=G_star, mu=mu)


def stick_radius(F_x: ArrayLike, a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, mu: ArrayLike) -> Result:
    """Radius of the stick zone under a tangential force; NaN beyond full slip.

    c = a*(1 - 3*F_x*R/(4*E_star*a**3*mu))**(1/3)

    Parameters
    ----------
    F_x : array_like
        Tangential force [N].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    paraboloid.tan.c.

    References
    ----------
    chapter 11, equation (11.78); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.tangential import paraboloid
    >>> value = paraboloid.stick_radius(0.196, 1.0, R=1.6, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.6
    """
    require(R=R, E_star=E_star, mu=mu)
    return elementwise(_stick_radius, F_x, a, R=R, E_star=E_star, mu=mu)


def full_slip_displacement(
    a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, G_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement at the onset of full slip.

    u_0 = E_star*a**2*mu/(G_star*R)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    paraboloid.tan.us.

    References
    ----------
    chapter 11, equation (11.80); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.tangential import paraboloid
    >>> value = paraboloid.full_slip_displacement(1.0, R=1.6, E_star=1.0, G_star=0.8, mu=0.3)
    >>> round(value, 6)
    0.234375
    """
    require(R=R, E_star=E_star, G_star=G_star, mu=mu)
    return elementwise(_full_slip_displacement, a, R=R, E_star=E_star, G_star=G_star, mu=mu)


def _tangential_force(a: Array, c: Array, R: Array, E_star: Array, mu: Array) -> Array:
    return mu * normal._force(a, R, E_star) * gained_share(c, a, 3.0)


def _traction(r: Array, a: Array, c: Array, R: Array, E_star: Array, mu: Array) -> Array:
    sliding = normal._pressure(r, a, R, E_star)
    gain = E_star / np.pi * normal._slope(1.0, R) * root_gain(r, c, a)
    return mu * np.where(r < c, gain, sliding)


def _tangential_displacement(a: Array, c: Array, R: Array, E_star: Array, G_star: Array, mu: Array) -> Array:
    return mu * (E_star / G_star) * normal._depth(a, R) * gained_share(c, a, 2.0)


def _stick_radius(F_x: Array, a: Array, R: Array, E_star: Array, mu: Array) -> Array:
    F = stick_force(normal._force(a, R, E_star), F_x, mu)
    return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force(F, R, E_star))


def _full_slip_displacement(a: Array, R: Array, E_star: Array, G_star: Array, mu: Array) -> Array:
    return mu * (E_star / G_star) * normal._depth(a, R)
