"""Sextic profile under a tangential load.

Flatter at the tip than the quartic: most of the load is carried near the rim of the contact.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, numbers, require, require_order
from .._runtime.physics.slip import even_gain, gained_share, stick_force
from ..normal import sextic as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["full_slip_displacement", "stick_radius", "tangential_displacement", "tangential_force", "traction"]


def __dir__() -> list[str]:
    return __all__


def tangential_force(a: ArrayLike, c: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, mu: ArrayLike) -> Result:
    """Tangential force with a stick zone of radius c.

    F_x = mu*(192*A*E_star*a**7/35 - 192*A*E_star*c**7/35)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 6 A a^5 << 1; Cattaneo-Mindlin approximation. Negative or NaN field values give
    NaN. Handbook: sextic.tan.F.

    References
    ----------
    chapter 11, equation (11.78); Schubert 1942.

    Examples
    --------
    >>> from axicontact.tangential import sextic
    >>> value = sextic.tangential_force(1.0, 0.6, A=0.4, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.639858
    """
    require(A=A, E_star=E_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_force, a, c, A=A, E_star=E_star, mu=mu)


def traction(r: ArrayLike, a: ArrayLike, c: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, mu: ArrayLike) -> Result:
    """Tangential traction; zero outside the contact.

    tau = 32*A*E_star*mu*sqrt(a**2 - r**2)*(3*a**4 + 4*a**2*r**2 + 8*r**4)/(25*pi)   for c < r
    tau = mu*(32*A*E_star*sqrt(a**2 - r**2)*(3*a**4 + 4*a**2*r**2 + 8*r**4)/(25*pi) - 32*A*E_star*sqrt(c**2 -
    r**2)*(3*c**4 + 4*c**2*r**2 + 8*r**4)/(25*pi))   for r < c

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 6 A a^5 << 1; Cattaneo-Mindlin approximation. Negative or NaN field values give
    NaN. Handbook: sextic.tan.tau.

    References
    ----------
    chapter 11, equation (11.79); Schubert 1942.

    Examples
    --------
    >>> from axicontact.tangential import sextic
    >>> value = sextic.traction(0.3, 1.0, 0.6, A=0.4, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.144918
    """
    require(A=A, E_star=E_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_traction, r, a, c, A=A, E_star=E_star, mu=mu)


def tangential_displacement(
    a: ArrayLike, c: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, G_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement of the indenter with a stick zone of radius c.

    u_0 = E_star*mu*(16*A*a**6/5 - 16*A*c**6/5)/G_star

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 6 A a^5 << 1; Cattaneo-Mindlin approximation. Negative or NaN field values give
    NaN. Handbook: sextic.tan.u.

    References
    ----------
    chapter 11, equation (11.80); Schubert 1942.

    Examples
    --------
    >>> from axicontact.tangential import sextic
    >>> value = sextic.tangential_displacement(1.0, 0.6, A=0.4, E_star=1.0, G_star=0.8, mu=0.3)
    >>> round(value, 6)
    0.457605
    """
    require(A=A, E_star=E_star, G_star=G_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_displacement, a, c, A=A, E_star=E_star, G_star=G_star, mu=mu)


def stick_radius(F_x: ArrayLike, a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, mu: ArrayLike) -> Result:
    """Radius of the stick zone under a tangential force; NaN beyond full slip.

    c = a*(1 - 35*F_x/(192*A*E_star*a**7*mu))**(1/7)

    Parameters
    ----------
    F_x : array_like
        Tangential force [N].
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 6 A a^5 << 1; Cattaneo-Mindlin approximation. Negative or NaN field values give
    NaN. Handbook: sextic.tan.c.

    References
    ----------
    chapter 11, equation (11.78); Schubert 1942.

    Examples
    --------
    >>> from axicontact.tangential import sextic
    >>> value = sextic.stick_radius(0.6399, 1.0, A=0.4, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.599804
    """
    require(A=A, E_star=E_star, mu=mu)
    return elementwise(_stick_radius, F_x, a, A=A, E_star=E_star, mu=mu)


def full_slip_displacement(
    a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, G_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement at the onset of full slip.

    u_0 = 16*A*E_star*a**6*mu/(5*G_star)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 6 A a^5 << 1; Cattaneo-Mindlin approximation. Negative or NaN field values give
    NaN. Handbook: sextic.tan.us.

    References
    ----------
    chapter 11, equation (11.80); Schubert 1942.

    Examples
    --------
    >>> from axicontact.tangential import sextic
    >>> value = sextic.full_slip_displacement(1.0, A=0.4, E_star=1.0, G_star=0.8, mu=0.3)
    >>> round(value, 6)
    0.48
    """
    require(A=A, E_star=E_star, G_star=G_star, mu=mu)
    return elementwise(_full_slip_displacement, a, A=A, E_star=E_star, G_star=G_star, mu=mu)


def _tangential_force(a: Array, c: Array, A: Array, E_star: Array, mu: Array) -> Array:
    return mu * normal._force(a, A, E_star) * gained_share(c, a, 7.0)


def _traction(r: Array, a: Array, c: Array, A: Array, E_star: Array, mu: Array) -> Array:
    sliding = normal._pressure(r, a, A, E_star)
    gain = E_star / np.pi * normal._slope(1.0, A) * even_gain(r, c, a, 6)
    return mu * np.where(r < c, gain, sliding)


def _tangential_displacement(a: Array, c: Array, A: Array, E_star: Array, G_star: Array, mu: Array) -> Array:
    return mu * (E_star / G_star) * normal._depth(a, A) * gained_share(c, a, 6.0)


def _stick_radius(F_x: Array, a: Array, A: Array, E_star: Array, mu: Array) -> Array:
    F = stick_force(normal._force(a, A, E_star), F_x, mu)
    return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force(F, A, E_star))


def _full_slip_displacement(a: Array, A: Array, E_star: Array, G_star: Array, mu: Array) -> Array:
    return mu * (E_star / G_star) * normal._depth(a, A)
