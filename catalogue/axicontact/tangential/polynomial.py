"""Polynomial under a tangential load.

Any sum of integer powers with coefficients A_1 ... A_N >= 0: superposition at a fixed contact radius.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, numbers, require, require_coefficients, require_order
from .._runtime.physics.slip import gained_share, power_gain, stick_force
from ..normal import polynomial as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["full_slip_displacement", "stick_radius", "tangential_displacement", "tangential_force", "traction"]


def __dir__() -> list[str]:
    return __all__


def tangential_force(a: ArrayLike, c: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, mu: ArrayLike) -> Result:
    """Tangential force with a stick zone of radius c.

    F_x = mu*(2*sqrt(pi)*E_star*Sum(a**(j + 1)*j*gamma(j/2 + 1)*A[j]/((j + 1)*gamma((j + 1)/2)), (j, 1, N)) -
    2*sqrt(pi)*E_star*Sum(c**(j + 1)*j*gamma(j/2 + 1)*A[j]/((j + 1)*gamma((j + 1)/2)), (j, 1, N)))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    polynomial.tan.F.

    References
    ----------
    chapter 11, equation (11.78); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.tangential import polynomial
    >>> value = polynomial.tangential_force(1.0, 0.6, A=(0.1, 0.25, 0.05), E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.233103
    """
    A = require_coefficients(A)
    require(E_star=E_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(partial(_tangential_force, A=A), a, c, E_star=E_star, mu=mu)


def traction(r: ArrayLike, a: ArrayLike, c: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, mu: ArrayLike) -> Result:
    """Tangential traction; zero outside the contact.

    tau = E_star*mu*Sum(j*r**(j - 1)*IncompleteBeta(1 - r**2/a**2, 1/2, (1 - j)/2)*gamma(j/2 +
    1)*A[j]/gamma((j + 1)/2), (j, 1, N))/(2*sqrt(pi))   for c < r
    tau = mu*(E_star*Sum(j*r**(j - 1)*IncompleteBeta(1 - r**2/a**2, 1/2, (1 - j)/2)*gamma(j/2 +
    1)*A[j]/gamma((j + 1)/2), (j, 1, N))/(2*sqrt(pi)) - E_star*Sum(j*r**(j - 1)*IncompleteBeta(1 - r**2/c**2,
    1/2, (1 - j)/2)*gamma(j/2 + 1)*A[j]/gamma((j + 1)/2), (j, 1, N))/(2*sqrt(pi)))   for r < c
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    polynomial.tan.tau.

    References
    ----------
    chapter 11, equation (11.79); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.tangential import polynomial
    >>> value = polynomial.traction(0.3, 1.0, 0.6, A=(0.1, 0.25, 0.05), E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.06151
    """
    A = require_coefficients(A)
    require(E_star=E_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(partial(_traction, A=A), r, a, c, E_star=E_star, mu=mu)


def tangential_displacement(
    a: ArrayLike, c: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, G_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement of the indenter with a stick zone of radius c.

    u_0 = E_star*mu*(sqrt(pi)*Sum(a**j*gamma(j/2 + 1)*A[j]/gamma((j + 1)/2), (j, 1, N)) -
    sqrt(pi)*Sum(c**j*gamma(j/2 + 1)*A[j]/gamma((j + 1)/2), (j, 1, N)))/G_star

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    polynomial.tan.u.

    References
    ----------
    chapter 11, equation (11.80); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.tangential import polynomial
    >>> value = polynomial.tangential_displacement(1.0, 0.6, A=(0.1, 0.25, 0.05), E_star=1.0, G_star=0.8, mu=0.3)
    >>> round(value, 6)
    0.178198
    """
    A = require_coefficients(A)
    require(E_star=E_star, G_star=G_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(partial(_tangential_displacement, A=A), a, c, E_star=E_star, G_star=G_star, mu=mu)


def stick_radius(F_x: ArrayLike, a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, mu: ArrayLike) -> Result:
    """Radius of the stick zone under a tangential force; NaN beyond full slip.

    c from mu*(2*sqrt(pi)*E_star*Sum(a**(j + 1)*j*gamma(j/2 + 1)*A[j]/((j + 1)*gamma((j + 1)/2)), (j, 1, N)) -
    2*sqrt(pi)*E_star*Sum(c**(j + 1)*j*gamma(j/2 + 1)*A[j]/((j + 1)*gamma((j + 1)/2)), (j, 1, N))) = F_x

    Parameters
    ----------
    F_x : array_like
        Tangential force [N].
    a : array_like
        Contact radius [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    polynomial.tan.c.

    References
    ----------
    chapter 11, equation (11.78); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.tangential import polynomial
    >>> value = polynomial.stick_radius(0.2331, 1.0, A=(0.1, 0.25, 0.05), E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.600009
    """
    A = require_coefficients(A)
    require(E_star=E_star, mu=mu)
    return elementwise(partial(_stick_radius, A=A), F_x, a, E_star=E_star, mu=mu)


def full_slip_displacement(
    a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, G_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement at the onset of full slip.

    u_0 = sqrt(pi)*E_star*mu*Sum(a**j*gamma(j/2 + 1)*A[j]/gamma((j + 1)/2), (j, 1, N))/G_star

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    polynomial.tan.us.

    References
    ----------
    chapter 11, equation (11.80); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.tangential import polynomial
    >>> value = polynomial.full_slip_displacement(1.0, A=(0.1, 0.25, 0.05), E_star=1.0, G_star=0.8, mu=0.3)
    >>> round(value, 6)
    0.290584
    """
    A = require_coefficients(A)
    require(E_star=E_star, G_star=G_star, mu=mu)
    return elementwise(partial(_full_slip_displacement, A=A), a, E_star=E_star, G_star=G_star, mu=mu)


def _tangential_force(a: Array, c: Array, A: tuple[float, ...], E_star: Array, mu: Array) -> Array:
    gains = (
        normal._force(a, (0.0,) * (j - 1) + (A_j,), E_star) * gained_share(c, a, j + 1) for j, A_j in enumerate(A, 1)
    )
    return mu * sum(gains)


def _traction(r: Array, a: Array, c: Array, A: tuple[float, ...], E_star: Array, mu: Array) -> Array:
    sliding = normal._pressure(r, a, A, E_star)
    gains = (normal._slope(a, (0.0,) * (j - 1) + (A_j,)) * power_gain(r, c, a, j) for j, A_j in enumerate(A, 1))
    return mu * np.where(r < c, E_star / np.pi * sum(gains), sliding)


def _tangential_displacement(
    a: Array, c: Array, A: tuple[float, ...], E_star: Array, G_star: Array, mu: Array
) -> Array:
    gains = (normal._depth(a, (0.0,) * (j - 1) + (A_j,)) * gained_share(c, a, j) for j, A_j in enumerate(A, 1))
    return mu * (E_star / G_star) * sum(gains)


def _stick_radius(F_x: Array, a: Array, A: tuple[float, ...], E_star: Array, mu: Array) -> Array:
    F = stick_force(normal._force(a, A, E_star), F_x, mu)
    return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force(F, A, E_star))


def _full_slip_displacement(a: Array, A: tuple[float, ...], E_star: Array, G_star: Array, mu: Array) -> Array:
    return mu * (E_star / G_star) * normal._depth(a, A)
