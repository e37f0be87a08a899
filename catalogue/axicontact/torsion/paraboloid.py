"""Paraboloid in torsion.

The tip of every smooth indenter and the parabolic approximation of the sphere: Hertz's contact.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, numbers, require, require_order
from .._runtime.physics.torsion import slipping_torque, slipping_traction, turned

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["full_slip_torque", "slip_angle", "torque", "traction"]


def __dir__() -> list[str]:
    return __all__


def torque(a: ArrayLike, c: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, mu: ArrayLike) -> Result:
    """Torque with a stick zone of radius c.

    torque = 16*E_star*a*c**3*mu*(-elliptic_e(1 - c**2/a**2) + elliptic_k(1 - c**2/a**2))/(3*pi*R) +
    16*E_star*mu*(a**2 - c**2)**(3/2)*Integral((1 - sin(turn)**2)*(c*sqrt(a**2 - c**2)*sin(turn)/(2*sqrt(c**2
    + (a**2 - c**2)*sin(turn)**2)) + sqrt(c**2 + (a**2 - c**2)*sin(turn)**2)*atan(sqrt(a**2 -
    c**2)*sin(turn)/c)/2)*sin(turn), (turn, 0, pi/2))/(pi*R)
    with elliptic integrals of the parameter m = k**2, their last argument

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
        Torque about the axis [N m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R; the normal load is held while the angle grows. Negative or NaN field values give NaN.
    Handbook: paraboloid.tor.M.

    References
    ----------
    Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.torsion import paraboloid
    >>> value = paraboloid.torque(1.0, 0.6, R=1.6, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.12012
    """
    require(R=R, E_star=E_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c",
        c=c,
        a=a,
    )
    return elementwise(_torque, a, c, R=R, E_star=E_star, mu=mu)


def slip_angle(a: ArrayLike, c: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, G: ArrayLike, mu: ArrayLike) -> Result:
    """Angle by which the indenter has turned when slip has come to the radius c.

    beta = E_star*a*mu*(-elliptic_e(1 - c**2/a**2) + elliptic_k(1 - c**2/a**2))/(pi*G*R)
    with elliptic integrals of the parameter m = k**2, their last argument

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
    G : array_like
        Shear modulus of the half-space [Pa], G > 0.
    mu : array_like
        Coefficient of friction [1], mu >= 0.

    Returns
    -------
    float or ndarray
        Angle by which the punch turns [rad]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R; the normal load is held while the angle grows. Negative or NaN field values give NaN.
    Handbook: paraboloid.tor.b.

    References
    ----------
    Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.torsion import paraboloid
    >>> value = paraboloid.slip_angle(1.0, 0.6, R=1.6, E_star=1.0, G=0.4, mu=0.3)
    >>> round(value, 6)
    0.107273
    """
    require(R=R, E_star=E_star, G=G, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c",
        c=c,
        a=a,
    )
    return elementwise(_slip_angle, a, c, R=R, E_star=E_star, G=G, mu=mu)


def traction(r: ArrayLike, a: ArrayLike, c: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, mu: ArrayLike) -> Result:
    """Circumferential traction; zero outside the contact.

    tau = 4*E_star*mu*r*Integral(a*elliptic_e(1 - ring**2/a**2)/(ring*sqrt(-r**2 + ring**2)), (ring, c,
    a))/(pi**2*R)   for r < c
    tau = 2*E_star*mu*sqrt(a**2 - r**2)/(pi*R)   for c < r
    with elliptic integrals of the parameter m = k**2, their last argument

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
    Valid for a << R; the normal load is held while the angle grows. Negative or NaN field values give NaN.
    Handbook: paraboloid.tor.tau.

    References
    ----------
    Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.torsion import paraboloid
    >>> value = paraboloid.traction(0.3, 1.0, 0.6, R=1.6, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.02317
    """
    require(R=R, E_star=E_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c",
        c=c,
        a=a,
    )
    return elementwise(_traction, r, a, c, R=R, E_star=E_star, mu=mu)


def full_slip_torque(a: ArrayLike, *, R: ArrayLike, E_star: ArrayLike, mu: ArrayLike) -> Result:
    """Torque under which the whole contact slips.

    full_torque = pi*E_star*a**4*mu/(4*R)

    Parameters
    ----------
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
        Torque at full slip [N m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R; the normal load is held while the angle grows. Negative or NaN field values give NaN.
    Handbook: paraboloid.tor.Ms.

    References
    ----------
    Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.torsion import paraboloid
    >>> value = paraboloid.full_slip_torque(1.0, R=1.6, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.147262
    """
    require(R=R, E_star=E_star, mu=mu)
    return elementwise(_full_slip_torque, a, R=R, E_star=E_star, mu=mu)


def _torque(a: Array, c: Array, R: Array, E_star: Array, mu: Array) -> Array:
    return E_star * mu / R * slipping_torque(a, c)


def _slip_angle(a: Array, c: Array, R: Array, E_star: Array, G: Array, mu: Array) -> Array:
    return E_star * mu / R / (np.pi * G) * turned(a, c)


def _traction(r: Array, a: Array, c: Array, R: Array, E_star: Array, mu: Array) -> Array:
    return E_star * mu / R * slipping_traction(r, a, c)


def _full_slip_torque(a: Array, R: Array, E_star: Array, mu: Array) -> Array:
    return np.pi / 4.0 * E_star * mu / R * a**4
