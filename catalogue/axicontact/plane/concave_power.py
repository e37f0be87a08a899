"""Concave power law.

Concave face of depth h; complete contact needs the line load P_min.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.functions import lower_power
from .._runtime.interface import Array, Result, elementwise, require, require_order
from .._runtime.physics.plane import even, odd
from .._runtime.shapes.powers import power_pressure, power_strips
from .._runtime.shapes.ring import outside_zero_pressure, ring_of_zero_pressure
from .._runtime.special import gamma_ratio

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["depth", "minimum_load", "pressure", "profile", "slope", "zero_distance"]


def __dir__() -> list[str]:
    return __all__


def profile(x: ArrayLike, *, a: ArrayLike, h: ArrayLike, n: ArrayLike) -> Result:
    """Profile f(x) of the indenter.

    f = -h*(x/a)**n

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    a : array_like
        Half-width of the punch [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
    n : array_like
        Exponent of the profile [1], n > 0.

    Returns
    -------
    float or ndarray
        Height of the face [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes; complete contact only. The formula is for x >= 0; the function is even. NaN gives
    NaN. Handbook: plane.concave_power.f, the definition of the profile.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import concave_power
    >>> value = concave_power.profile(0.3, a=1.0, h=0.15, n=3.0)
    >>> round(value, 6)
    -0.00405
    """
    _check(a=a, h=h, n=n)
    return even(_profile, x, a=a, h=h, n=n)


def pressure(x: ArrayLike, P: ArrayLike, *, a: ArrayLike, h: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = (-E_star*h*n**2*x**(n - 1)*IncompleteBeta(1 - x**2/a**2, 1/2, (1 - n)/2)*gamma((n +
    1)/2)/(sqrt(pi)*a**n) + 2*(sqrt(pi)*E_star*h*n*gamma((n + 1)/2) + 2*P*gamma(n/2 + 1))/(pi*sqrt(a**2 -
    x**2)))/(4*gamma(n/2 + 1))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    P : array_like
        Line load, force per length of the strip of contact [N/m].
    a : array_like
        Half-width of the punch [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
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
    Valid for small slopes; complete contact only. The formula is for x >= 0; the function is even. Negative P
    and NaN, and loads below minimum_load(), give NaN. Evaluated as an integral over the growing contact by a
    Gauss-Legendre rule. The place of first zero pressure is found by Newton's method. Handbook:
    plane.concave_power.p.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import concave_power
    >>> value = concave_power.pressure(0.3, 1.0, a=1.0, h=0.15, n=3.0, E_star=1.0)
    >>> round(value, 6)
    0.272985
    """
    _check(a=a, h=h, n=n, E_star=E_star)
    return even(_pressure, x, P, a=a, h=h, n=n, E_star=E_star)


def slope(x: ArrayLike, P: ArrayLike, *, a: ArrayLike, h: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Slope dw/dx of the surface, inside and outside the contact.

    dw/dx = (h*n**2*x**(n - 1)*IncompleteBeta(a**2/x**2, n/2, 1/2)*gamma((n + 1)/2)/(2*sqrt(pi)*a**n) -
    (sqrt(pi)*E_star*h*n*gamma((n + 1)/2) + 2*P*gamma(n/2 + 1))/(pi*E_star*sqrt(-a**2 + x**2)))/gamma(n/2 + 1)
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q
    and dw/dx = -f'(x) in the contact.

    Parameters
    ----------
    x : array_like
        Place across the contact, zero in the middle; of either sign [m].
    P : array_like
        Line load, force per length of the strip of contact [N/m].
    a : array_like
        Half-width of the punch [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

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
    Valid for small slopes; complete contact only. The formula is for x >= 0; the function is odd. Negative P
    and NaN, and loads below minimum_load(), give NaN. Evaluated as an integral over the growing contact by a
    Gauss-Legendre rule. The place of first zero pressure is found by Newton's method. Handbook:
    plane.concave_power.s.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import concave_power
    >>> value = concave_power.slope(2.0, 1.0, a=1.0, h=0.15, n=3.0, E_star=1.0)
    >>> round(value, 6)
    -0.374014
    """
    _check(a=a, h=h, n=n, E_star=E_star)
    return odd(_slope, x, P, a=a, h=h, n=n, E_star=E_star)


def depth(L: ArrayLike, P: ArrayLike, *, a: ArrayLike, h: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Indentation depth relative to the surface at the distance L.

    d = -L**n*h*n*IncompleteBeta(a**2/L**2, n/2, 1/2)*gamma((n + 1)/2)/(2*sqrt(pi)*a**n*gamma(n/2 + 1)) +
    2*P*acosh(L/a)/(pi*E_star)
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    L : array_like
        Distance of the reference point from the middle of the contact [m].
    P : array_like
        Line load, force per length of the strip of contact [N/m].
    a : array_like
        Half-width of the punch [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

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
    Valid for small slopes; complete contact only. Negative or NaN field values, and points in the contact, L
    < a, and loads below minimum_load(), give NaN. Evaluated as an integral over the growing contact by a
    Gauss-Legendre rule. The place of first zero pressure is found by Newton's method. Handbook:
    plane.concave_power.d.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import concave_power
    >>> value = concave_power.depth(10.0, 1.0, a=1.0, h=0.15, n=3.0, E_star=1.0)
    >>> round(value, 6)
    1.841691
    """
    _check(a=a, h=h, n=n, E_star=E_star)
    return elementwise(_depth, L, P, a=a, h=h, n=n, E_star=E_star)


def zero_distance(*, a: ArrayLike, h: ArrayLike, n: ArrayLike) -> Result:
    """Distance from the middle where the pressure first vanishes on unloading.

    x_zero = 0   for 1 < n <= 2
    x_zero from IncompleteBeta(1 - x_zero**2/a**2, 1/2, 1/2 - n/2) = 2*(x_zero/a)**(1 - n)*sqrt(1 -
    x_zero**2/a**2)/(n*(1 - x_zero**2/a**2) - 1)   for 2 < n
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    a : array_like
        Half-width of the punch [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
    n : array_like
        Exponent of the profile [1], n > 0.

    Returns
    -------
    float or ndarray
        Distance from the middle where the pressure first vanishes on unloading [m]. The shape to which the
        arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes; complete contact only. The place of first zero pressure is found by Newton's
    method. Handbook: plane.concave_power.xz.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import concave_power
    >>> value = concave_power.zero_distance(a=1.0, h=0.15, n=3.0)
    >>> round(value, 6)
    0.347683
    """
    _check(a=a, h=h, n=n)
    return elementwise(_zero_distance, a=a, n=n, unused=(h,))


def minimum_load(*, a: ArrayLike, h: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Least line load of complete contact.

    P = sqrt(pi)*E_star*a**2*h*n*gamma(n/2 + 1/2)/(2*(a**2*n - a**2 - n*x_zero**2)*gamma(n/2 + 1))

    Parameters
    ----------
    a : array_like
        Half-width of the punch [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
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
    Valid for small slopes; complete contact only. The place of first zero pressure is found by Newton's
    method. Handbook: plane.concave_power.Pmin.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.plane import concave_power
    >>> value = concave_power.minimum_load(a=1.0, h=0.15, n=3.0, E_star=1.0)
    >>> round(value, 6)
    0.183223
    """
    _check(a=a, h=h, n=n, E_star=E_star)
    return elementwise(_minimum_load, h=h, n=n, E_star=E_star, unused=(a,))


def _check(a: ArrayLike, h: ArrayLike, n: ArrayLike, **material: ArrayLike) -> None:
    require(a=a, h=h, n=n, **material)
    n = np.asarray(n)
    require_order(
        n > 1,
        "1 < n",
        "a concave wedge or a sharper notch never reaches complete contact at a finite load; use n > 1",
        n=n,
    )


def _profile(x: Array, a: Array, h: Array, n: Array) -> Array:
    return np.where(x <= a, -h * x**n / a**n, np.nan)


def _profile_slope(x: Array, a: Array, h: Array, n: Array) -> Array:
    """Slope f'(x) of the profile."""
    return -n * h * lower_power(x, n) / a**n


def _zero_distance(a: Array, n: Array) -> Array:
    return a * ring_of_zero_pressure(n)


def _minimum_load(h: Array, n: Array, E_star: Array) -> Array:
    kappa = gamma_ratio(n / 2 + 1 / 2)
    zeta = outside_zero_pressure(n)
    return np.sqrt(np.pi) * E_star * n * h / (2 * (n * zeta - 1) * kappa)


def _pressure(x: Array, P: Array, a: Array, h: Array, n: Array, E_star: Array) -> Array:
    root = np.sqrt((a - x) * (a + x))
    strip = P / (np.pi * root)
    kappa = gamma_ratio((n + 1) / 2)
    face = E_star * n * h * (1 / root - n * power_pressure(x, a, n) / a) / (2 * np.sqrt(np.pi) * kappa)
    value = strip + face
    complete = _minimum_load(h, n, E_star) * (1.0 - 1e-15) <= P
    result = np.where((x <= a) & (P > 0.0), value, 0.0)
    return np.where(complete, result, np.nan)


def _slope(x: Array, P: Array, a: Array, h: Array, n: Array, E_star: Array) -> Array:
    root = np.sqrt((x - a) * (a + x))
    strip = -2 * P / (np.pi * E_star * root)
    kappa = gamma_ratio((n + 1) / 2)
    face = n * h * (power_strips(x, a, n) - 1 / root) / (np.sqrt(np.pi) * kappa)
    value = strip + face
    outside = np.where(P > 0.0, value, 0.0)
    complete = _minimum_load(h, n, E_star) * (1.0 - 1e-15) <= P
    result = np.where(x >= a, outside, -_profile_slope(x, a, h, n))
    return np.where(complete, result, np.nan)


def _depth(L: Array, P: Array, a: Array, h: Array, n: Array, E_star: Array) -> Array:
    root = np.sqrt((L - a) * (a + L))
    strip = 2 * P * np.log1p((L - a + root) / a) / (np.pi * E_star)
    kappa = gamma_ratio((n + 1) / 2)
    face = h * L * power_strips(L, a, n) / (np.sqrt(np.pi) * kappa)
    value = strip - face
    complete = _minimum_load(h, n, E_star) * (1.0 - 1e-15) <= P
    result = np.where(a <= L, value, np.nan)
    return np.where(complete, result, np.nan)
