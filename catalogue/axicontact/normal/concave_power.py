"""Concave power law.

Concave face of depth h; complete contact needs the force F_min.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, require, require_order
from .._runtime.shapes.powers import power_pressure, power_punches
from .._runtime.shapes.ring import outside_zero_pressure, ring_of_zero_pressure
from .._runtime.special import gamma_ratio

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "depth_from_force",
    "displacement",
    "energy",
    "force",
    "load_within",
    "minimum_depth",
    "minimum_force",
    "pressure",
    "profile",
    "stiffness",
    "zero_radius",
]


def __dir__() -> list[str]:
    return __all__


def profile(r: ArrayLike, *, a: ArrayLike, h: ArrayLike, n: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = -h*(r/a)**n

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
    n : array_like
        Exponent of the profile [1], n > 0.

    Returns
    -------
    float or ndarray
        Profile of the indenter, measured from its apex [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN. Handbook:
    concave_power.f, the definition of the profile.

    References
    ----------
    Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_power
    >>> value = concave_power.profile(0.3, a=1.0, h=0.15, n=3.0)
    >>> round(value, 6)
    -0.00405
    """
    _check(a=a, h=h, n=n)
    return elementwise(_profile, r, a=a, h=h, n=n)


def force(d: ArrayLike, *, a: ArrayLike, h: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force.

    F = 2*E_star*a*(d + sqrt(pi)*h*gamma(n/2 + 1)/((n + 1)*gamma((n + 1)/2)))

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Normal force [N]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN. The depth is
    measured at the centre of the face; the rim is at d + h. Handbook: concave_power.F.

    References
    ----------
    chapter 11, equation (11.13); chapter 11, equation (11.20); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_power
    >>> value = concave_power.force(0.6, a=1.0, h=0.15, n=3.0, E_star=1.0)
    >>> round(value, 6)
    1.376715
    """
    _check(a=a, h=h, n=n, E_star=E_star)
    return elementwise(_force, d, a=a, h=h, n=n, E_star=E_star)


def pressure(r: ArrayLike, d: ArrayLike, *, a: ArrayLike, h: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = E_star*(d/(pi*sqrt(a**2 - r**2)) + h*gamma(n/2 + 1)/(sqrt(pi)*sqrt(a**2 - r**2)*gamma((n + 1)/2)) -
    h*n*r**(n - 1)*IncompleteBeta(1 - r**2/a**2, 1/2, (1 - n)/2)*gamma(n/2 + 1)/(2*sqrt(pi)*a**n*gamma((n +
    1)/2)))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
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
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN. Evaluated as an
    integral over the growing contact by a Gauss-Legendre rule. The depth is measured at the centre of the
    face; the rim is at d + h. Handbook: concave_power.p.

    References
    ----------
    chapter 11, equation (11.15); chapter 11, equation (11.107); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_power
    >>> value = concave_power.pressure(0.3, 0.6, a=1.0, h=0.15, n=3.0, E_star=1.0)
    >>> round(value, 6)
    0.128704
    """
    _check(a=a, h=h, n=n, E_star=E_star)
    return elementwise(_pressure, r, d, a=a, h=h, n=n, E_star=E_star)


def displacement(r: ArrayLike, d: ArrayLike, *, a: ArrayLike, h: ArrayLike, n: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*d*asin(a/r)/pi + h*r**n*IncompleteBeta(a**2/r**2, (n + 1)/2, 1/2)*gamma(n/2 +
    1)/(sqrt(pi)*a**n*gamma((n + 1)/2))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
    n : array_like
        Exponent of the profile [1], n > 0.

    Returns
    -------
    float or ndarray
        Surface displacement into the half-space [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN. Evaluated as an
    integral over the growing contact by a Gauss-Legendre rule. Handbook: concave_power.w.

    References
    ----------
    chapter 11, equation (11.12); chapter 11, equation (11.105); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_power
    >>> value = concave_power.displacement(2.0, 0.6, a=1.0, h=0.15, n=3.0)
    >>> round(value, 6)
    0.230866
    """
    _check(a=a, h=h, n=n)
    return elementwise(_displacement, r, d, a=a, h=h, n=n)


def stiffness(*, a: ArrayLike, h: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*E_star*a

    Parameters
    ----------
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Contact stiffness dF/dd [N/m]. A number for numbers.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN. Handbook:
    concave_power.k.

    References
    ----------
    chapter 11, equation (11.14); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_power
    >>> value = concave_power.stiffness(a=1.0, h=0.15, n=3.0, E_star=1.0)
    >>> round(value, 6)
    2.0
    """
    _check(a=a, h=h, n=n, E_star=E_star)
    return elementwise(_stiffness, a=a, E_star=E_star, unused=(h, n))


def depth_from_force(F: ArrayLike, *, a: ArrayLike, h: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = -sqrt(pi)*h*gamma(n/2 + 1)/((n + 1)*gamma((n + 1)/2)) + F/(2*E_star*a)

    Parameters
    ----------
    F : array_like
        Normal force [N].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Indentation depth of the point r = 0 [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN. Handbook:
    concave_power.dF.

    References
    ----------
    chapter 11, equation (11.14); chapter 11, equation (11.20); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_power
    >>> value = concave_power.depth_from_force(1.377, a=1.0, h=0.15, n=3.0, E_star=1.0)
    >>> round(value, 6)
    0.600143
    """
    _check(a=a, h=h, n=n, E_star=E_star)
    return elementwise(_depth_from_force, F, a=a, h=h, n=n, E_star=E_star)


def zero_radius(*, a: ArrayLike, h: ArrayLike, n: ArrayLike) -> Result:
    """Radius of the ring where the pressure first vanishes on unloading.

    r_zero = 0   for 1 < n <= 2
    r_zero from IncompleteBeta(1 - r_zero**2/a**2, 1/2, 1/2 - n/2) = 2*(r_zero/a)**(1 - n)*sqrt(1 -
    r_zero**2/a**2)/(n*(1 - r_zero**2/a**2) - 1)   for 2 < n
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
    n : array_like
        Exponent of the profile [1], n > 0.

    Returns
    -------
    float or ndarray
        Radius of the ring where the pressure first vanishes on unloading [m]. A number for numbers.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN. Handbook:
    concave_power.rz.

    References
    ----------
    Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_power
    >>> value = concave_power.zero_radius(a=1.0, h=0.15, n=3.0)
    >>> round(value, 6)
    0.347683
    """
    _check(a=a, h=h, n=n)
    return elementwise(_zero_radius, a=a, n=n, unused=(h,))


def minimum_depth(*, a: ArrayLike, h: ArrayLike, n: ArrayLike) -> Result:
    """Least indentation depth of complete contact.

    d = sqrt(pi)*a**2*h*gamma(n/2 + 1)/((a**2*n - a**2 - n*r_zero**2)*gamma(n/2 + 1/2))

    Parameters
    ----------
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
    n : array_like
        Exponent of the profile [1], n > 0.

    Returns
    -------
    float or ndarray
        Indentation depth of the point r = 0 [m]. A number for numbers.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN. Handbook:
    concave_power.dmin.

    References
    ----------
    Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_power
    >>> value = concave_power.minimum_depth(a=1.0, h=0.15, n=3.0)
    >>> round(value, 6)
    0.215854
    """
    _check(a=a, h=h, n=n)
    return elementwise(_minimum_depth, h=h, n=n, unused=(a,))


def minimum_force(*, a: ArrayLike, h: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Least normal force of complete contact.

    F = 2*sqrt(pi)*E_star*a*h*n*(2*a**2 - r_zero**2)*gamma(n/2 + 1)/((n + 1)*(a**2*n - a**2 -
    n*r_zero**2)*gamma(n/2 + 1/2))

    Parameters
    ----------
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Normal force [N]. A number for numbers.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN. Handbook:
    concave_power.Fmin.

    References
    ----------
    Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_power
    >>> value = concave_power.minimum_force(a=1.0, h=0.15, n=3.0, E_star=1.0)
    >>> round(value, 6)
    0.608423
    """
    _check(a=a, h=h, n=n, E_star=E_star)
    return elementwise(_minimum_force, a=a, h=h, n=n, E_star=E_star)


def energy(d: ArrayLike, *, a: ArrayLike, h: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Elastic energy, the work of pressing the indenter in.

    U = E_star*a*(d**2 + 2*sqrt(pi)*d*h*gamma(n/2 + 1)/((n + 1)*gamma((n + 1)/2)) + pi*h**2*gamma(n/2 +
    1)**2/((2*n + 1)*gamma((n + 1)/2)**2))

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Elastic energy, the work of pressing the indenter in [J]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN. Handbook:
    concave_power.U.

    References
    ----------
    Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_power
    >>> value = concave_power.energy(0.6, a=1.0, h=0.15, n=3.0, E_star=1.0)
    >>> round(value, 6)
    0.483873
    """
    _check(a=a, h=h, n=n, E_star=E_star)
    return elementwise(_energy, d, a=a, h=h, n=n, E_star=E_star)


def load_within(r: ArrayLike, d: ArrayLike, *, a: ArrayLike, h: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Part of the normal force that is carried within the radius r; all of it beyond the contact.

    F_r = 2*E_star*((a - sqrt(a**2 - r**2))*(d*n*gamma((n + 1)/2) + d*gamma((n + 1)/2) + sqrt(pi)*h*gamma(n/2
    + 1)) - sqrt(pi)*h*n*r**(n + 1)*IncompleteBeta(1 - r**2/a**2, 1/2, (1 - n)/2)*gamma(n/2 + 1)/(2*a**n))/((n
    + 1)*gamma((n + 1)/2))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Part of the normal force that is carried within the radius r [N]. The shape to which the arguments
        broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN. Evaluated as an
    integral over the growing contact by a Gauss-Legendre rule. Handbook: concave_power.Fr.

    References
    ----------
    Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import concave_power
    >>> value = concave_power.load_within(0.3, 0.6, a=1.0, h=0.15, n=3.0, E_star=1.0)
    >>> round(value, 6)
    0.036632
    """
    _check(a=a, h=h, n=n, E_star=E_star)
    return elementwise(_load_within, r, d, a=a, h=h, n=n, E_star=E_star)


def _check(a: ArrayLike, h: ArrayLike, n: ArrayLike, **material: ArrayLike) -> None:
    require(a=a, h=h, n=n, **material)
    n = np.asarray(n)
    require_order(
        n > 1,
        "1 < n",
        "a concave cone or a sharper dimple never reaches complete contact at a finite load; use n > 1",
        n=n,
    )


def _profile(r: Array, a: Array, h: Array, n: Array) -> Array:
    return np.where(r <= a, -h * (r / a) ** n, np.nan)


def _zero_radius(a: Array, n: Array) -> Array:
    return a * ring_of_zero_pressure(n)


def _minimum_depth(h: Array, n: Array) -> Array:
    zeta = outside_zero_pressure(n)
    kappa = gamma_ratio(n / 2 + 1 / 2)
    drop = n * zeta - 1
    return np.sqrt(np.pi) * h * kappa / drop


def _minimum_force(a: Array, h: Array, n: Array, E_star: Array) -> Array:
    zeta = outside_zero_pressure(n)
    kappa = gamma_ratio(n / 2 + 1 / 2)
    drop = (n + 1) * (n * zeta - 1)
    return 2 * np.sqrt(np.pi) * E_star * n * h * (zeta + 1) * a * kappa / drop


def _force(d: Array, a: Array, h: Array, n: Array, E_star: Array) -> Array:
    kappa = gamma_ratio(n / 2 + 1 / 2)
    complete = _minimum_depth(h, n) * (1.0 - 1e-15) <= d
    result = 2 * E_star * a * (d + np.sqrt(np.pi) * h / (n + 1) * kappa)
    return np.where(complete, result, np.nan)


def _depth_from_force(F: Array, a: Array, h: Array, n: Array, E_star: Array) -> Array:
    kappa = gamma_ratio(n / 2 + 1 / 2)
    complete = _minimum_force(a, h, n, E_star) * (1.0 - 1e-15) <= F
    result = F / (2 * E_star * a) - np.sqrt(np.pi) * h / (n + 1) * kappa
    return np.where(complete, result, np.nan)


def _stiffness(a: Array, E_star: Array) -> Array:
    return 2 * E_star * a


def _pressure(r: Array, d: Array, a: Array, h: Array, n: Array, E_star: Array) -> Array:
    kappa = gamma_ratio(n / 2 + 1 / 2)
    root = np.sqrt((a - r) * (a + r))
    plus = d / (np.pi * root) + h * kappa / (np.sqrt(np.pi) * root)
    minus = n * h * power_pressure(r, a, n) * kappa / (np.sqrt(np.pi) * a)
    complete = _minimum_depth(h, n) * (1.0 - 1e-15) <= d
    result = np.where((r <= a) & (d > 0.0), E_star * (plus - minus), 0.0)
    return np.where(complete, result, np.nan)


def _displacement(r: Array, d: Array, a: Array, h: Array, n: Array) -> Array:
    kappa = gamma_ratio(n / 2 + 1 / 2)
    root = np.sqrt((r - a) * (a + r))
    angle = np.arctan2(a, root)
    outside = 2 * d * angle / np.pi + 2 * h / np.sqrt(np.pi) * power_punches(r, a, n) * kappa
    inside = d - _profile(r, a, h, n)
    complete = _minimum_depth(h, n) * (1.0 - 1e-15) <= d
    result = np.where(r > a, outside, inside)
    return np.where(complete, result, np.nan)


def _energy(d: Array, a: Array, h: Array, n: Array, E_star: Array) -> Array:
    kappa = gamma_ratio(n / 2 + 1 / 2)
    plus = d**2 + 2 * np.sqrt(np.pi) * h / (n + 1) * d * kappa + np.pi * h**2 / (2 * n + 1) * kappa**2
    complete = _minimum_depth(h, n) * (1.0 - 1e-15) <= d
    result = E_star * a * plus
    return np.where(complete, result, np.nan)


def _load_within(r: Array, d: Array, a: Array, h: Array, n: Array, E_star: Array) -> Array:
    kappa = gamma_ratio(n / 2 + 1 / 2)
    root = np.sqrt((a - r) * (a + r))
    share = power_pressure(r, a, n)
    punch = n * d * r**2 / (root + a) + d * r**2 / (root + a)
    face = np.sqrt(np.pi) * h * r**2 * kappa / (root + a) - np.sqrt(np.pi) * n * h * share * r**2 * kappa / a
    within = 2 * E_star / (n + 1) * (punch + face)
    complete = _minimum_depth(h, n) * (1.0 - 1e-15) <= d
    result = np.where(r < a, within, _force(d, a, h, n, E_star))
    return np.where(complete, result, np.nan)
