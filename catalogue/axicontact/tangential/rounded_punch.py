"""Flat punch with a rounded edge under a tangential load.

Flat face of radius b running tangentially into a rounding of radius R: between flat punch and sphere.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, numbers, require, require_order, require_reach
from .._runtime.physics.slip import CLOSE, growth_beyond, stick_force
from ..normal import rounded_punch as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["full_slip_displacement", "stick_radius", "tangential_displacement", "tangential_force", "traction"]


def __dir__() -> list[str]:
    return __all__


def tangential_force(
    a: ArrayLike, c: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential force with a stick zone of radius c.

    F_x = mu*(E_star*(-a**2*b*acos(b/a) + (2*a - b)*(2*a + b)*sqrt(a**2 - b**2)/3)/R -
    E_star*(-b*c**2*acos(b/c) + (-b + 2*c)*(b + 2*c)*sqrt(-b**2 + c**2)/3)/R)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a - b << R (parabolic rounding); Cattaneo-Mindlin approximation. Negative or NaN field values
    give NaN. The stick zone is never smaller than the flat face: NaN for c < b. Handbook:
    rounded_punch.tan.F.

    References
    ----------
    chapter 11, equation (11.78); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.tangential import rounded_punch
    >>> value = rounded_punch.tangential_force(1.62, 1.432, R=1.45, b=1.15, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.140603
    """
    require(R=R, b=b, E_star=E_star, mu=mu)
    require_reach(a, b)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_force, a, c, R=R, b=b, E_star=E_star, mu=mu)


def traction(
    r: ArrayLike, a: ArrayLike, c: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike, mu: ArrayLike
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
    Valid for a - b << R (parabolic rounding); Cattaneo-Mindlin approximation. Negative or NaN field values
    give NaN. The stick zone is never smaller than the flat face: NaN for c < b. Handbook:
    rounded_punch.tan.tau.

    References
    ----------
    chapter 11, equation (11.79); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.tangential import rounded_punch
    >>> value = rounded_punch.traction(0.486, 1.62, 1.432, R=1.45, b=1.15, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.010078
    """
    require(R=R, b=b, E_star=E_star, mu=mu)
    require_reach(a, b)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_traction, r, a, c, R=R, b=b, E_star=E_star, mu=mu)


def tangential_displacement(
    a: ArrayLike, c: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike, G_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement of the indenter with a stick zone of radius c.

    u_0 = E_star*mu*(a*(-b*acos(b/a) + sqrt(a**2 - b**2))/R - c*(-b*acos(b/c) + sqrt(-b**2 + c**2))/R)/G_star

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a - b << R (parabolic rounding); Cattaneo-Mindlin approximation. Negative or NaN field values
    give NaN. The stick zone is never smaller than the flat face: NaN for c < b. Handbook:
    rounded_punch.tan.u.

    References
    ----------
    chapter 11, equation (11.80); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.tangential import rounded_punch
    >>> value = rounded_punch.tangential_displacement(1.62, 1.432, R=1.45, b=1.15, E_star=1.0, G_star=0.8, mu=0.3)
    >>> round(value, 6)
    0.057382
    """
    require(R=R, b=b, E_star=E_star, G_star=G_star, mu=mu)
    require_reach(a, b)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_displacement, a, c, R=R, b=b, E_star=E_star, G_star=G_star, mu=mu)


def stick_radius(
    F_x: ArrayLike, a: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Radius of the stick zone under a tangential force; NaN beyond full slip.

    c from mu*(E_star*(-a**2*b*acos(b/a) + (2*a - b)*(2*a + b)*sqrt(a**2 - b**2)/3)/R -
    E_star*(-b*c**2*acos(b/c) + (-b + 2*c)*(b + 2*c)*sqrt(-b**2 + c**2)/3)/R) = F_x

    Parameters
    ----------
    F_x : array_like
        Tangential force [N].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a - b << R (parabolic rounding); Cattaneo-Mindlin approximation. Negative or NaN field values
    give NaN. The stick zone is never smaller than the flat face: NaN for c < b. Handbook:
    rounded_punch.tan.c.

    References
    ----------
    chapter 11, equation (11.78); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.tangential import rounded_punch
    >>> value = rounded_punch.stick_radius(0.1406, 1.62, R=1.45, b=1.15, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    1.432005
    """
    require(R=R, b=b, E_star=E_star, mu=mu)
    require_reach(a, b)
    return elementwise(_stick_radius, F_x, a, R=R, b=b, E_star=E_star, mu=mu)


def full_slip_displacement(
    a: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike, G_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement at the onset of full slip.

    u_0 = E_star*a*mu*(-b*acos(b/a) + sqrt(a**2 - b**2))/(G_star*R)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a - b << R (parabolic rounding); Cattaneo-Mindlin approximation. Negative or NaN field values
    give NaN. The stick zone is never smaller than the flat face: NaN for c < b. Handbook:
    rounded_punch.tan.us.

    References
    ----------
    chapter 11, equation (11.80); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.tangential import rounded_punch
    >>> value = rounded_punch.full_slip_displacement(1.62, R=1.45, b=1.15, E_star=1.0, G_star=0.8, mu=0.3)
    >>> round(value, 6)
    0.101521
    """
    require(R=R, b=b, E_star=E_star, G_star=G_star, mu=mu)
    require_reach(a, b)
    return elementwise(_full_slip_displacement, a, R=R, b=b, E_star=E_star, G_star=G_star, mu=mu)


def _tangential_force(a: Array, c: Array, R: Array, b: Array, E_star: Array, mu: Array) -> Array:
    whole, sticking = normal._force(a, R, b, E_star), normal._force(c, R, b, E_star)
    close = sticking >= CLOSE * whole
    gain = 2.0 * E_star * growth_beyond(normal._slope_beyond, (R, b), 2, 0.0, c, a, b, close)
    return mu * np.where(close, gain, whole - sticking)


def _traction(r: Array, a: Array, c: Array, R: Array, b: Array, E_star: Array, mu: Array) -> Array:
    sliding = normal._pressure(r, a, R, b, E_star)
    stuck = normal._pressure(r, c, R, b, E_star)
    # both are infinite at a tip, and where the slope of the profile jumps
    close = (r < c) & (stuck >= CLOSE * sliding)
    gain = E_star / np.pi * growth_beyond(normal._slope_beyond, (R, b), 0, r, c, a, b, close)
    return mu * np.where(close, gain, sliding - stuck)


def _tangential_displacement(a: Array, c: Array, R: Array, b: Array, E_star: Array, G_star: Array, mu: Array) -> Array:
    whole, sticking = normal._depth(a, R, b), normal._depth(c, R, b)
    close = sticking >= CLOSE * whole
    gain = growth_beyond(normal._slope_beyond, (R, b), 1, 0.0, c, a, b, close)
    return mu * (E_star / G_star) * np.where(close, gain, whole - sticking)


def _stick_radius(F_x: Array, a: Array, R: Array, b: Array, E_star: Array, mu: Array) -> Array:
    F = stick_force(normal._force(a, R, b, E_star), F_x, mu)
    return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force(F, R, b, E_star))


def _full_slip_displacement(a: Array, R: Array, b: Array, E_star: Array, G_star: Array, mu: Array) -> Array:
    return mu * (E_star / G_star) * normal._depth(a, R, b)
