"""Power law.

Every self-similar profile: P ~ a^n. Wedge, parabola and quartic are n = 1, 2, 4.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.functions import lower_power, nth_root
from .._runtime.interface import Array, Result, elementwise, require
from .._runtime.physics.plane import even, odd
from .._runtime.shapes.powers import power_pressure, power_strips
from .._runtime.special import gamma_ratio

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["depth", "half_width_from_load", "load", "pressure", "profile", "slope"]


def __dir__() -> list[str]:
    return __all__


def profile(x: ArrayLike, *, A: ArrayLike, n: ArrayLike) -> Result:
    """Profile f(x) of the indenter.

    f = A*x**n

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.

    Returns
    -------
    float or ndarray
        Height of the profile above its lowest point in the middle [m]. The shape to which the arguments
        broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes, n A a^(n-1) << 1. The formula is for x >= 0; the function is even. NaN gives NaN.
    Handbook: plane.power_law.f, the definition of the profile.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import power_law
    >>> value = power_law.profile(0.3, A=0.45, n=1.5)
    >>> round(value, 6)
    0.073943
    """
    require(A=A, n=n)
    return even(_profile, x, A=A, n=n)


def load(a: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Line load at half-width a.

    P = sqrt(pi)*A*E_star*a**n*n*gamma((n + 1)/2)/(2*gamma(n/2 + 1))

    Parameters
    ----------
    a : array_like
        Half-width of the contact [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Line load, force per length of the strip of contact [N/m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. Handbook:
    plane.power_law.P.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import power_law
    >>> value = power_law.load(1.0, A=0.45, n=1.5, E_star=1.0)
    >>> round(value, 6)
    0.589963
    """
    require(A=A, n=n, E_star=E_star)
    return elementwise(_load, a, A=A, n=n, E_star=E_star)


def pressure(x: ArrayLike, a: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = A*E_star*n**2*x**(n - 1)*IncompleteBeta(1 - x**2/a**2, 1/2, (1 - n)/2)*gamma((n +
    1)/2)/(4*sqrt(pi)*gamma(n/2 + 1))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    a : array_like
        Half-width of the contact [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Contact pressure, positive in compression [Pa]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes, n A a^(n-1) << 1. The formula is for x >= 0; the function is even. Negative a and
    NaN give NaN. Evaluated as an integral over the growing contact by a Gauss-Legendre rule. The pressure in
    the middle is finite only for n > 1; n = 1, 2, 4 and 6 are solutions of Schubert. Handbook:
    plane.power_law.p.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import power_law
    >>> value = power_law.pressure(0.3, 1.0, A=0.45, n=1.5, E_star=1.0)
    >>> round(value, 6)
    0.369809
    """
    require(A=A, n=n, E_star=E_star)
    return even(_pressure, x, a, A=A, n=n, E_star=E_star)


def slope(x: ArrayLike, a: ArrayLike, *, A: ArrayLike, n: ArrayLike) -> Result:
    """Slope dw/dx of the surface, inside and outside the contact.

    dw/dx = -A*n**2*x**(n - 1)*IncompleteBeta(a**2/x**2, n/2, 1/2)*gamma((n + 1)/2)/(2*sqrt(pi)*gamma(n/2 +
    1))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q
    and dw/dx = -f'(x) in the contact.

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    a : array_like
        Half-width of the contact [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.

    Returns
    -------
    float or ndarray
        Slope of the surface, negative where the displacement into the half-space falls with x [1]. The shape
        to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes, n A a^(n-1) << 1. The formula is for x >= 0; the function is odd. Negative a and
    NaN give NaN. Evaluated as an integral over the growing contact by a Gauss-Legendre rule. Handbook:
    plane.power_law.s.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import power_law
    >>> value = power_law.slope(2.0, 1.0, A=0.45, n=1.5)
    >>> round(value, 6)
    -0.199274
    """
    require(A=A, n=n)
    return odd(_slope, x, a, A=A, n=n)


def depth(L: ArrayLike, a: ArrayLike, *, A: ArrayLike, n: ArrayLike) -> Result:
    """Indentation depth relative to the surface at the distance L.

    d = A*n*(L**n*IncompleteBeta(a**2/L**2, n/2, 1/2)/2 + a**n*acosh(L/a))*gamma((n +
    1)/2)/(sqrt(pi)*gamma(n/2 + 1))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    L : array_like
        Distance of the reference point from the middle of the contact [m].
    a : array_like
        Half-width of the contact [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.

    Returns
    -------
    float or ndarray
        Depth of the middle of the contact relative to the surface at the distance L [m]. The shape to which
        the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values, and points in the contact, L < a,
    give NaN. Evaluated as an integral over the growing contact by a Gauss-Legendre rule. Handbook:
    plane.power_law.d.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import power_law
    >>> value = power_law.depth(10.0, 1.0, A=0.45, n=1.5)
    >>> round(value, 6)
    1.375128
    """
    require(A=A, n=n)
    return elementwise(_depth, L, a, A=A, n=n)


def half_width_from_load(P: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Half-width of the contact under the line load P.

    a = (2*P*gamma(n/2 + 1)/(sqrt(pi)*A*E_star*n*gamma((n + 1)/2)))**(1/n)

    Parameters
    ----------
    P : array_like
        Line load, force per length of the strip of contact [N/m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Half-width of the contact [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. Handbook:
    plane.power_law.aP.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import power_law
    >>> value = power_law.half_width_from_load(0.59, A=0.45, n=1.5, E_star=1.0)
    >>> round(value, 6)
    1.000042
    """
    require(A=A, n=n, E_star=E_star)
    return elementwise(_half_width_from_load, P, A=A, n=n, E_star=E_star)


def _profile(x: Array, A: Array, n: Array) -> Array:
    return A * x**n


def _profile_slope(x: Array, A: Array, n: Array) -> Array:
    """Slope f'(x) of the profile."""
    return n * A * lower_power(x, n)


def _load(a: Array, A: Array, n: Array, E_star: Array) -> Array:
    kappa = gamma_ratio(n / 2 + 1 / 2)
    return np.sqrt(np.pi) * E_star * n * A * a**n / (2 * kappa)


def _pressure(x: Array, a: Array, A: Array, n: Array, E_star: Array) -> Array:
    kappa = gamma_ratio((n + 1) / 2)
    value = E_star * n**2 * A * lower_power(a, n) * power_pressure(x, a, n) / (2 * np.sqrt(np.pi) * kappa)
    return np.where(x < a, value, 0.0)


def _slope(x: Array, a: Array, A: Array, n: Array) -> Array:
    kappa = gamma_ratio((n + 1) / 2)
    value = -n * A * a**n * power_strips(x, a, n) / (np.sqrt(np.pi) * kappa)
    return np.where(x > a, value, -_profile_slope(x, A, n))


def _depth(L: Array, a: Array, A: Array, n: Array) -> Array:
    kappa = gamma_ratio((n + 1) / 2)
    root = np.sqrt((L - a) * (a + L))
    value = A * a**n * (L * power_strips(L, a, n) + n * np.log1p((L - a + root) / a)) / (np.sqrt(np.pi) * kappa)
    value = np.where(a > 0.0, value, 0.0)
    return np.where(a <= L, value, np.nan)


def _half_width_from_load(P: Array, A: Array, n: Array, E_star: Array) -> Array:
    kappa = gamma_ratio(n / 2 + 1 / 2)
    ratio = 2 * P * kappa / (np.sqrt(np.pi) * E_star * n * A)
    return nth_root(ratio, n)
