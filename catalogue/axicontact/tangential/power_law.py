"""Power law under a tangential load.

Every self-similar profile: F ~ d^(1 + 1/n). Cone, paraboloid and quartic are n = 1, 2, 4.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, numbers, require, require_order
from .._runtime.physics.slip import gained_share, power_gain, stick_force
from ..normal import power_law as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["full_slip_displacement", "stick_radius", "tangential_displacement", "tangential_force", "traction"]


def __dir__() -> list[str]:
    return __all__


def tangential_force(
    a: ArrayLike, c: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential force with a stick zone of radius c.

    F_x = mu*(2*sqrt(pi)*A*E_star*a**(n + 1)*n*gamma(n/2 + 1)/((n + 1)*gamma((n + 1)/2)) -
    2*sqrt(pi)*A*E_star*c**(n + 1)*n*gamma(n/2 + 1)/((n + 1)*gamma((n + 1)/2)))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1; Cattaneo-Mindlin approximation. Negative or NaN field values
    give NaN. Handbook: power_law.tan.F.

    References
    ----------
    chapter 11, equation (11.78); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.tangential import power_law
    >>> value = power_law.tangential_force(1.0, 0.6, A=0.45, n=1.5, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.20996
    """
    require(A=A, n=n, E_star=E_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_force, a, c, A=A, n=n, E_star=E_star, mu=mu)


def traction(
    r: ArrayLike, a: ArrayLike, c: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential traction; zero outside the contact.

    tau = A*E_star*mu*n*r**(n - 1)*IncompleteBeta(1 - r**2/a**2, 1/2, (1 - n)/2)*gamma(n/2 +
    1)/(2*sqrt(pi)*gamma((n + 1)/2))   for c < r
    tau = mu*(A*E_star*n*r**(n - 1)*IncompleteBeta(1 - r**2/a**2, 1/2, (1 - n)/2)*gamma(n/2 +
    1)/(2*sqrt(pi)*gamma((n + 1)/2)) - A*E_star*n*r**(n - 1)*IncompleteBeta(1 - r**2/c**2, 1/2, (1 -
    n)/2)*gamma(n/2 + 1)/(2*sqrt(pi)*gamma((n + 1)/2)))   for r < c
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
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1; Cattaneo-Mindlin approximation. Negative or NaN field values
    give NaN. Handbook: power_law.tan.tau.

    References
    ----------
    chapter 11, equation (11.79); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.tangential import power_law
    >>> value = power_law.traction(0.3, 1.0, 0.6, A=0.45, n=1.5, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.056816
    """
    require(A=A, n=n, E_star=E_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_traction, r, a, c, A=A, n=n, E_star=E_star, mu=mu)


def tangential_displacement(
    a: ArrayLike, c: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike, G_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement of the indenter with a stick zone of radius c.

    u_0 = E_star*mu*(sqrt(pi)*A*a**n*gamma(n/2 + 1)/gamma((n + 1)/2) - sqrt(pi)*A*c**n*gamma(n/2 + 1)/gamma((n
    + 1)/2))/G_star

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1; Cattaneo-Mindlin approximation. Negative or NaN field values
    give NaN. Handbook: power_law.tan.u.

    References
    ----------
    chapter 11, equation (11.80); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.tangential import power_law
    >>> value = power_law.tangential_displacement(1.0, 0.6, A=0.45, n=1.5, E_star=1.0, G_star=0.8, mu=0.3)
    >>> round(value, 6)
    0.162328
    """
    require(A=A, n=n, E_star=E_star, G_star=G_star, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_displacement, a, c, A=A, n=n, E_star=E_star, G_star=G_star, mu=mu)


def stick_radius(
    F_x: ArrayLike, a: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Radius of the stick zone under a tangential force; NaN beyond full slip.

    c = a*(1 - F_x*a**(-n - 1)*(n + 1)*gamma((n + 1)/2)/(2*sqrt(pi)*A*E_star*mu*n*gamma(n/2 + 1)))**(1/(n +
    1))

    Parameters
    ----------
    F_x : array_like
        Tangential force [N].
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1; Cattaneo-Mindlin approximation. Negative or NaN field values
    give NaN. Handbook: power_law.tan.c.

    References
    ----------
    chapter 11, equation (11.78); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.tangential import power_law
    >>> value = power_law.stick_radius(0.21, 1.0, A=0.45, n=1.5, E_star=1.0, mu=0.3)
    >>> round(value, 6)
    0.599882
    """
    require(A=A, n=n, E_star=E_star, mu=mu)
    return elementwise(_stick_radius, F_x, a, A=A, n=n, E_star=E_star, mu=mu)


def full_slip_displacement(
    a: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike, G_star: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement at the onset of full slip.

    u_0 = sqrt(pi)*A*E_star*a**n*mu*gamma(n/2 + 1)/(G_star*gamma((n + 1)/2))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1; Cattaneo-Mindlin approximation. Negative or NaN field values
    give NaN. Handbook: power_law.tan.us.

    References
    ----------
    chapter 11, equation (11.80); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.tangential import power_law
    >>> value = power_law.full_slip_displacement(1.0, A=0.45, n=1.5, E_star=1.0, G_star=0.8, mu=0.3)
    >>> round(value, 6)
    0.303279
    """
    require(A=A, n=n, E_star=E_star, G_star=G_star, mu=mu)
    return elementwise(_full_slip_displacement, a, A=A, n=n, E_star=E_star, G_star=G_star, mu=mu)


def _tangential_force(a: Array, c: Array, A: Array, n: Array, E_star: Array, mu: Array) -> Array:
    return mu * normal._force(a, A, n, E_star) * gained_share(c, a, n + 1)


def _traction(r: Array, a: Array, c: Array, A: Array, n: Array, E_star: Array, mu: Array) -> Array:
    sliding = normal._pressure(r, a, A, n, E_star)
    gain = E_star / np.pi * normal._slope(a, A, n) * power_gain(r, c, a, n)
    return mu * np.where(r < c, gain, sliding)


def _tangential_displacement(a: Array, c: Array, A: Array, n: Array, E_star: Array, G_star: Array, mu: Array) -> Array:
    return mu * (E_star / G_star) * normal._depth(a, A, n) * gained_share(c, a, n)


def _stick_radius(F_x: Array, a: Array, A: Array, n: Array, E_star: Array, mu: Array) -> Array:
    F = stick_force(normal._force(a, A, n, E_star), F_x, mu)
    return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force(F, A, n, E_star))


def _full_slip_displacement(a: Array, A: Array, n: Array, E_star: Array, G_star: Array, mu: Array) -> Array:
    return mu * (E_star / G_star) * normal._depth(a, A, n)
