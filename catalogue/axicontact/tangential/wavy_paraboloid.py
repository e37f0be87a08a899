"""Wavy paraboloid under a tangential load.

A paraboloid with concentric waves of amplitude h, 2h from valley to peak, too shallow to leave gaps.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, numbers, require_order
from .._runtime.physics.slip import CLOSE, growth_waves, stick_force
from ..normal import wavy_paraboloid as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["full_slip_displacement", "stick_radius", "tangential_displacement", "tangential_force", "traction"]


def __dir__() -> list[str]:
    return __all__


def tangential_force(
    a: ArrayLike, c: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, E_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential force with a stick zone of radius c.

    F_x = mu*(E_star*a*(2*pi**2*a*h*StruveH(0, 2*pi*a/wavelength)/wavelength - pi*h*StruveH(1,
    2*pi*a/wavelength) + 4*a**2/(3*R)) - E_star*c*(2*pi**2*c*h*StruveH(0, 2*pi*c/wavelength)/wavelength -
    pi*h*StruveH(1, 2*pi*c/wavelength) + 4*c**2/(3*R)))
    with StruveH: Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
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
    Valid for a << R; waves so flat that g' >= 0 for every a; Cattaneo-Mindlin approximation. Negative or NaN
    field values give NaN. Handbook: wavy_paraboloid.tan.F.

    References
    ----------
    chapter 11, equation (11.78); Guduru 2007.

    Examples
    --------
    >>> from axicontact.tangential import wavy_paraboloid
    >>> value = wavy_paraboloid.tangential_force(1.0, 0.6, R=1.6, h=0.01, wavelength=0.5, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.171694
    """
    normal._check(R=R, h=h, wavelength=wavelength, E_star=E_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_force, a, c, R=R, h=h, wavelength=wavelength, E_star=E_star, mu=mu)


def traction(
    r: ArrayLike,
    a: ArrayLike,
    c: ArrayLike,
    *,
    R: ArrayLike,
    h: ArrayLike,
    wavelength: ArrayLike,
    E_star: ArrayLike,
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
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
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
    Valid for a << R; waves so flat that g' >= 0 for every a; Cattaneo-Mindlin approximation. Negative or NaN
    field values give NaN. Handbook: wavy_paraboloid.tan.tau.

    References
    ----------
    chapter 11, equation (11.79); Guduru 2007.

    Examples
    --------
    >>> from axicontact.tangential import wavy_paraboloid
    >>> value = wavy_paraboloid.traction(0.3, 1.0, 0.6, R=1.6, h=0.01, wavelength=0.5, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.046682
    """
    normal._check(R=R, h=h, wavelength=wavelength, E_star=E_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_traction, r, a, c, R=R, h=h, wavelength=wavelength, E_star=E_star, mu=mu)


def tangential_displacement(
    a: ArrayLike,
    c: ArrayLike,
    *,
    R: ArrayLike,
    h: ArrayLike,
    wavelength: ArrayLike,
    E_star: ArrayLike,
    G_star: ArrayLike,
    mu: ArrayLike,
) -> Result:
    """Tangential displacement of the indenter with a stick zone of radius c.

    u_0 = E_star*mu*(a*(pi**2*h*StruveH(0, 2*pi*a/wavelength)/wavelength + a/R) - c*(pi**2*h*StruveH(0,
    2*pi*c/wavelength)/wavelength + c/R))/G_star
    with StruveH: Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
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
    Valid for a << R; waves so flat that g' >= 0 for every a; Cattaneo-Mindlin approximation. Negative or NaN
    field values give NaN. Handbook: wavy_paraboloid.tan.u.

    References
    ----------
    chapter 11, equation (11.80); Guduru 2007.

    Examples
    --------
    >>> from axicontact.tangential import wavy_paraboloid
    >>> value = wavy_paraboloid.tangential_displacement(
    ...     1.0, 0.6, R=1.6, h=0.01, wavelength=0.5, E_star=1.0, G_star=0.8, mu=0.3
    ... )
    >>> round(value, 6)
    0.13248
    """
    normal._check(R=R, h=h, wavelength=wavelength, E_star=E_star, G_star=G_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(
        _tangential_displacement, a, c, R=R, h=h, wavelength=wavelength, E_star=E_star, G_star=G_star, mu=mu
    )


def stick_radius(
    F_x: ArrayLike, a: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, E_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Radius of the stick zone under a tangential force; NaN beyond full slip.

    c from mu*(E_star*a*(2*pi**2*a*h*StruveH(0, 2*pi*a/wavelength)/wavelength - pi*h*StruveH(1,
    2*pi*a/wavelength) + 4*a**2/(3*R)) - E_star*c*(2*pi**2*c*h*StruveH(0, 2*pi*c/wavelength)/wavelength -
    pi*h*StruveH(1, 2*pi*c/wavelength) + 4*c**2/(3*R))) = F_x
    with StruveH: Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0

    Parameters
    ----------
    F_x : array_like
        Tangential force [N].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
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
    Valid for a << R; waves so flat that g' >= 0 for every a; Cattaneo-Mindlin approximation. Negative or NaN
    field values give NaN. Handbook: wavy_paraboloid.tan.c.

    References
    ----------
    chapter 11, equation (11.78); Guduru 2007.

    Examples
    --------
    >>> from axicontact.tangential import wavy_paraboloid
    >>> value = wavy_paraboloid.stick_radius(0.1717, 1.0, R=1.6, h=0.01, wavelength=0.5, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.599986
    """
    normal._check(R=R, h=h, wavelength=wavelength, E_star=E_star, mu=mu)
    return elementwise(_stick_radius, F_x, a, R=R, h=h, wavelength=wavelength, E_star=E_star, mu=mu)


def full_slip_displacement(
    a: ArrayLike,
    *,
    R: ArrayLike,
    h: ArrayLike,
    wavelength: ArrayLike,
    E_star: ArrayLike,
    G_star: ArrayLike,
    mu: ArrayLike,
) -> Result:
    """Tangential displacement at the onset of full slip.

    u_0 = E_star*a*mu*(pi**2*h*StruveH(0, 2*pi*a/wavelength)/wavelength + a/R)/G_star
    with StruveH: Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
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
    Valid for a << R; waves so flat that g' >= 0 for every a; Cattaneo-Mindlin approximation. Negative or NaN
    field values give NaN. Handbook: wavy_paraboloid.tan.us.

    References
    ----------
    chapter 11, equation (11.80); Guduru 2007.

    Examples
    --------
    >>> from axicontact.tangential import wavy_paraboloid
    >>> value = wavy_paraboloid.full_slip_displacement(
    ...     1.0, R=1.6, h=0.01, wavelength=0.5, E_star=1.0, G_star=0.8, mu=0.3
    ... )
    >>> round(value, 6)
    0.22621
    """
    normal._check(R=R, h=h, wavelength=wavelength, E_star=E_star, G_star=G_star, mu=mu)
    return elementwise(_full_slip_displacement, a, R=R, h=h, wavelength=wavelength, E_star=E_star, G_star=G_star, mu=mu)


def _tangential_force(a: Array, c: Array, R: Array, h: Array, wavelength: Array, E_star: Array, mu: Array) -> Array:
    whole, sticking = normal._force(a, R, h, wavelength, E_star), normal._force(c, R, h, wavelength, E_star)
    close = sticking >= CLOSE * whole
    gain = 2.0 * E_star * growth_waves(normal._slope, (R, h, wavelength), 2, 0.0, c, a, wavelength, close)
    return mu * np.where(close, gain, whole - sticking)


def _traction(r: Array, a: Array, c: Array, R: Array, h: Array, wavelength: Array, E_star: Array, mu: Array) -> Array:
    sliding = normal._pressure(r, a, R, h, wavelength, E_star)
    stuck = normal._pressure(r, c, R, h, wavelength, E_star)
    # both are infinite at a tip, and where the slope of the profile jumps
    close = (r < c) & (stuck >= CLOSE * sliding)
    gain = E_star / np.pi * growth_waves(normal._slope, (R, h, wavelength), 0, r, c, a, wavelength, close)
    return mu * np.where(close, gain, sliding - stuck)


def _tangential_displacement(
    a: Array, c: Array, R: Array, h: Array, wavelength: Array, E_star: Array, G_star: Array, mu: Array
) -> Array:
    whole, sticking = normal._depth(a, R, h, wavelength), normal._depth(c, R, h, wavelength)
    close = sticking >= CLOSE * whole
    gain = growth_waves(normal._slope, (R, h, wavelength), 1, 0.0, c, a, wavelength, close)
    return mu * (E_star / G_star) * np.where(close, gain, whole - sticking)


def _stick_radius(F_x: Array, a: Array, R: Array, h: Array, wavelength: Array, E_star: Array, mu: Array) -> Array:
    F = stick_force(normal._force(a, R, h, wavelength, E_star), F_x, mu)
    return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force(F, R, h, wavelength, E_star))


def _full_slip_displacement(
    a: Array, R: Array, h: Array, wavelength: Array, E_star: Array, G_star: Array, mu: Array
) -> Array:
    return mu * (E_star / G_star) * normal._depth(a, R, h, wavelength)
