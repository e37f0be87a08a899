"""Power law.

Every self-similar profile: F ~ d^(1 + 1/n). Cone, paraboloid and quartic are n = 1, 2, 4.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.functions import lower_power, nth_root, without_root
from .._runtime.interface import Array, Plain, Result, elementwise, require
from .._runtime.shapes.powers import power_displacement, power_pressure
from .._runtime.shapes.ring import ring_of_greatest_pressure, rise_to_greatest_pressure
from .._runtime.special import PeakPressure, gamma_ratio

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "depth",
    "depth_from_force",
    "displacement",
    "energy",
    "force",
    "force_from_depth",
    "load_within",
    "mean_pressure",
    "peak_pressure",
    "pressure",
    "profile",
    "radius_from_depth",
    "radius_from_force",
    "stiffness",
]


def __dir__() -> list[str]:
    return __all__


plain = Plain(__name__, __all__)


def profile(r: ArrayLike, *, A: ArrayLike, n: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = A*r**n

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. Handbook: power_law.f,
    the definition of the profile.

    References
    ----------
    Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import power_law
    >>> value = power_law.profile(0.3, A=0.45, n=1.5)
    >>> round(value, 6)
    0.073943
    """
    value = plain.profile(r, A, n)
    if value is not None:
        return value
    require(A=A, n=n)
    return elementwise(_profile, r, A=A, n=n)


def depth(a: ArrayLike, *, A: ArrayLike, n: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = sqrt(pi)*A*a**n*gamma(n/2 + 1)/gamma((n + 1)/2)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.

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
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. The pressure at the
    centre is finite only for n > 1. Handbook: power_law.d.

    References
    ----------
    chapter 11, equation (11.29); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import power_law
    >>> value = power_law.depth(1.0, A=0.45, n=1.5)
    >>> round(value, 6)
    0.808745
    """
    value = plain.depth(a, A, n)
    if value is not None:
        return value
    require(A=A, n=n)
    return elementwise(_depth, a, A=A, n=n)


def force(a: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force.

    F = 2*sqrt(pi)*A*E_star*a**(n + 1)*n*gamma(n/2 + 1)/((n + 1)*gamma((n + 1)/2))

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
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. The pressure at the
    centre is finite only for n > 1. Handbook: power_law.F.

    References
    ----------
    chapter 11, equation (11.20); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import power_law
    >>> value = power_law.force(1.0, A=0.45, n=1.5, E_star=1.0)
    >>> round(value, 6)
    0.970494
    """
    value = plain.force(a, A, n, E_star)
    if value is not None:
        return value
    require(A=A, n=n, E_star=E_star)
    return elementwise(_force, a, A=A, n=n, E_star=E_star)


def pressure(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = A*E_star*n*r**(n - 1)*IncompleteBeta(1 - r**2/a**2, 1/2, (1 - n)/2)*gamma(n/2 +
    1)/(2*sqrt(pi)*gamma((n + 1)/2))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
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
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. Evaluated as an integral
    over the growing contact by a Gauss-Legendre rule. The pressure at the centre is finite only for n > 1.
    Handbook: power_law.p.

    References
    ----------
    chapter 11, equation (11.23); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import power_law
    >>> value = power_law.pressure(0.3, 1.0, A=0.45, n=1.5, E_star=1.0)
    >>> round(value, 6)
    0.506949
    """
    value = plain.pressure(r, a, A, n, E_star)
    if value is not None:
        return value
    require(A=A, n=n, E_star=E_star)
    return elementwise(_pressure, r, a, A=A, n=n, E_star=E_star)


def displacement(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, n: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = A*(2*a**n*asin(a/r) - r**n*IncompleteBeta(a**2/r**2, (n + 1)/2, 1/2))*gamma(n/2 +
    1)/(sqrt(pi)*gamma((n + 1)/2))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. Evaluated as an integral
    over the growing contact by a Gauss-Legendre rule. Handbook: power_law.w.

    References
    ----------
    chapter 11, equation (11.26); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import power_law
    >>> value = power_law.displacement(2.0, 1.0, A=0.45, n=1.5)
    >>> round(value, 6)
    0.15835
    """
    value = plain.displacement(r, a, A, n)
    if value is not None:
        return value
    require(A=A, n=n)
    return elementwise(_displacement, r, a, A=A, n=n)


def stiffness(a: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*E_star*a

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

    Returns
    -------
    float or ndarray
        Contact stiffness dF/dd [N/m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. Handbook: power_law.k.

    References
    ----------
    chapter 11, equation (11.18); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import power_law
    >>> value = power_law.stiffness(1.0, A=0.45, n=1.5, E_star=1.0)
    >>> round(value, 6)
    2.0
    """
    value = plain.stiffness(a, E_star, A, n)
    if value is not None:
        return value
    require(A=A, n=n, E_star=E_star)
    return elementwise(_stiffness, a, E_star=E_star, unused=(A, n))


def mean_pressure(a: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = 2*A*E_star*a**(n - 1)*n*gamma(n/2 + 1)/(sqrt(pi)*(n + 1)*gamma((n + 1)/2))

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

    Returns
    -------
    float or ndarray
        Mean pressure F/(pi a^2) [Pa]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. Handbook: power_law.pm.

    References
    ----------
    Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import power_law
    >>> value = power_law.mean_pressure(1.0, A=0.45, n=1.5, E_star=1.0)
    >>> round(value, 6)
    0.308918
    """
    value = plain.mean_pressure(a, A, n, E_star)
    if value is not None:
        return value
    require(A=A, n=n, E_star=E_star)
    return elementwise(_mean_pressure, a, A=A, n=n, E_star=E_star)


def radius_from_depth(d: ArrayLike, *, A: ArrayLike, n: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a = (d*gamma((n + 1)/2)/(sqrt(pi)*A*gamma(n/2 + 1)))**(1/n)

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.

    Returns
    -------
    float or ndarray
        Contact radius [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. Handbook: power_law.ad.

    References
    ----------
    chapter 11, equation (11.16); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import power_law
    >>> value = power_law.radius_from_depth(0.8087, A=0.45, n=1.5)
    >>> round(value, 6)
    0.999963
    """
    value = plain.radius_from_depth(d, A, n)
    if value is not None:
        return value
    require(A=A, n=n)
    return elementwise(_radius_from_depth, d, A=A, n=n)


def radius_from_force(F: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a = (F*(n + 1)*gamma((n + 1)/2)/(2*sqrt(pi)*A*E_star*n*gamma(n/2 + 1)))**(1/(n + 1))

    Parameters
    ----------
    F : array_like
        Normal force [N].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Contact radius [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. Handbook: power_law.aF.

    References
    ----------
    chapter 11, equation (11.20); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import power_law
    >>> value = power_law.radius_from_force(0.9705, A=0.45, n=1.5, E_star=1.0)
    >>> round(value, 6)
    1.000003
    """
    value = plain.radius_from_force(F, A, n, E_star)
    if value is not None:
        return value
    require(A=A, n=n, E_star=E_star)
    return elementwise(_radius_from_force, F, A=A, n=n, E_star=E_star)


def force_from_depth(d: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = 2*sqrt(pi)*A*E_star*n*(d*gamma((n + 1)/2)/(sqrt(pi)*A*gamma(n/2 + 1)))**((n + 1)/n)*gamma(n/2 + 1)/((n
    + 1)*gamma((n + 1)/2))

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. Handbook: power_law.Fd.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import power_law
    >>> value = power_law.force_from_depth(0.8087, A=0.45, n=1.5, E_star=1.0)
    >>> round(value, 6)
    0.970404
    """
    value = plain.force_from_depth(d, A, n, E_star)
    if value is not None:
        return value
    require(A=A, n=n, E_star=E_star)
    return elementwise(_force_from_depth, d, A=A, n=n, E_star=E_star)


def depth_from_force(F: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = sqrt(pi)*A*(F*(n + 1)*gamma((n + 1)/2)/(2*sqrt(pi)*A*E_star*n*gamma(n/2 + 1)))**(n/(n + 1))*gamma(n/2
    + 1)/gamma((n + 1)/2)

    Parameters
    ----------
    F : array_like
        Normal force [N].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. Handbook: power_law.dF.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import power_law
    >>> value = power_law.depth_from_force(0.9705, A=0.45, n=1.5, E_star=1.0)
    >>> round(value, 6)
    0.808748
    """
    value = plain.depth_from_force(F, A, n, E_star)
    if value is not None:
        return value
    require(A=A, n=n, E_star=E_star)
    return elementwise(_depth_from_force, F, A=A, n=n, E_star=E_star)


def peak_pressure(a: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> PeakPressure:
    """Greatest pressure, and the radius of the ring on which it is.

    p_peak = A*E_star*a**(n - 1)*n*gamma(n/2 + 1)/(sqrt(pi)*sqrt(1 - r_peak**2/a**2)*(n - 1)*gamma((n + 1)/2))
    r_peak = 0   for 1 < n <= 2
    r_peak from IncompleteBeta(1 - r_peak**2/a**2, 1/2, 3/2 - n/2) = 2*(a/r_peak)**(n - 3)/(sqrt(1 -
    r_peak**2/a**2)*(n - 2))   for 2 < n
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

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

    Returns
    -------
    PeakPressure
        Named tuple of pressure [Pa] and radius [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. Handbook: power_law.rp,
    power_law.pp.

    References
    ----------
    chapter 11, equation (11.23); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import power_law
    >>> value = power_law.peak_pressure(1.0, A=0.45, n=1.5, E_star=1.0)
    >>> round(value.pressure, 6)
    0.772294
    """
    require(A=A, n=n, E_star=E_star)
    pressure = elementwise(_peak_pressure, a, A=A, n=n, E_star=E_star)
    radius = elementwise(_peak_radius, a, n=n, unused=(A, E_star))
    return PeakPressure(pressure, radius)


def energy(a: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Elastic energy, the work of pressing the indenter in.

    U = 2*pi*A**2*E_star*a**(2*n + 1)*n**2*gamma(n/2 + 1)**2/((n + 1)*(2*n + 1)*gamma(n/2 + 1/2)**2)

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
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. Handbook: power_law.U.

    References
    ----------
    Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import power_law
    >>> value = power_law.energy(1.0, A=0.45, n=1.5, E_star=1.0)
    >>> round(value, 6)
    0.294331
    """
    value = plain.energy(a, A, n, E_star)
    if value is not None:
        return value
    require(A=A, n=n, E_star=E_star)
    return elementwise(_energy, a, A=A, n=n, E_star=E_star)


def load_within(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Part of the normal force that is carried within the radius r; all of it beyond the contact.

    F_r = sqrt(pi)*A*E_star*n*(-2*a**n*sqrt(a**2 - r**2) + 2*a**(n + 1) + r**(n + 1)*IncompleteBeta(1 -
    r**2/a**2, 1/2, (1 - n)/2))*gamma(n/2 + 1)/((n + 1)*gamma((n + 1)/2))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. Evaluated as an integral
    over the growing contact by a Gauss-Legendre rule. Handbook: power_law.Fr.

    References
    ----------
    Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import power_law
    >>> value = power_law.load_within(0.3, 1.0, A=0.45, n=1.5, E_star=1.0)
    >>> round(value, 6)
    0.159371
    """
    value = plain.load_within(r, a, A, n, E_star)
    if value is not None:
        return value
    require(A=A, n=n, E_star=E_star)
    return elementwise(_load_within, r, a, A=A, n=n, E_star=E_star)


def _profile(r: Array, A: Array, n: Array) -> Array:
    return A * r**n


def _slope(t: Array, A: Array, n: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t)."""
    return np.sqrt(np.pi) * n * A * gamma_ratio(n / 2 + 1 / 2) * t**n / t


def _depth(a: Array, A: Array, n: Array) -> Array:
    kappa = gamma_ratio(n / 2 + 1 / 2)
    return np.sqrt(np.pi) * A * a**n * kappa


def _force(a: Array, A: Array, n: Array, E_star: Array) -> Array:
    kappa = gamma_ratio(n / 2 + 1 / 2)
    return 2 * np.sqrt(np.pi) * E_star * n * A / (n + 1) * a * a**n * kappa


def _pressure(r: Array, a: Array, A: Array, n: Array, E_star: Array) -> Array:
    kappa = gamma_ratio(n / 2 + 1 / 2)
    pressed = E_star * n * A / np.sqrt(np.pi) * lower_power(a, n) * power_pressure(r, a, n) * kappa
    return np.where(r < a, pressed, 0.0)


def _displacement(r: Array, a: Array, A: Array, n: Array) -> Array:
    kappa = gamma_ratio(n / 2 + 1 / 2)
    outside = 2 * A / np.sqrt(np.pi) * a**n * power_displacement(r, a, n) * kappa
    inside = _depth(a, A, n) - _profile(r, A, n)
    return np.where(r > a, outside, inside)


def _stiffness(a: Array, E_star: Array) -> Array:
    return 2 * E_star * a


def _mean_pressure(a: Array, A: Array, n: Array, E_star: Array) -> Array:
    kappa = gamma_ratio(n / 2 + 1 / 2)
    return 2 * E_star * n * A / (np.sqrt(np.pi) * (n + 1)) * lower_power(a, n) * kappa


def _peak_radius(a: Array, n: Array) -> Array:
    return a * ring_of_greatest_pressure(n)


def _peak_pressure(a: Array, A: Array, n: Array, E_star: Array) -> Array:
    kappa = gamma_ratio(n / 2 + 1 / 2)
    rise = rise_to_greatest_pressure(n)
    greatest = E_star * n * A * rise / (np.sqrt(np.pi) * (n - 1)) * lower_power(a, n) * kappa
    return np.where(n > 1.0, greatest, np.inf)


def _energy(a: Array, A: Array, n: Array, E_star: Array) -> Array:
    kappa = gamma_ratio(n / 2 + 1 / 2)
    return 2 * np.pi * E_star * n**2 * A**2 / ((2 * n + 1) * (n + 1)) * a * a ** (2 * n) * kappa**2


def _load_within(r: Array, a: Array, A: Array, n: Array, E_star: Array) -> Array:
    kappa = gamma_ratio(n / 2 + 1 / 2)
    root = np.sqrt((a - r) * (a + r))
    share = power_pressure(r, a, n)
    within = 2 * np.sqrt(np.pi) * E_star * n * A / (n + 1) * a**n * r**2 * (1 / (root + a) + share / a) * kappa
    return np.where(r < a, np.where(r > 0.0, within, 0.0), _force(a, A, n, E_star))


def _radius_from_depth(d: Array, A: Array, n: Array) -> Array:
    kappa = gamma_ratio(n / 2 + 1 / 2)
    ratio = d / (np.sqrt(np.pi) * A * kappa)
    return nth_root(ratio, n)


def _radius_from_force(F: Array, A: Array, n: Array, E_star: Array) -> Array:
    kappa = gamma_ratio(n / 2 + 1 / 2)
    ratio = (n + 1) * F / (2 * np.sqrt(np.pi) * E_star * n * A * kappa)
    return nth_root(ratio, n, 1)


def _force_from_depth(d: Array, A: Array, n: Array, E_star: Array) -> Array:
    kappa = gamma_ratio(n / 2 + 1 / 2)
    ratio = d / (np.sqrt(np.pi) * A * kappa)
    return 2 * np.sqrt(np.pi) * E_star * n * A / (n + 1) * kappa * ratio * nth_root(ratio, n)


def _depth_from_force(F: Array, A: Array, n: Array, E_star: Array) -> Array:
    kappa = gamma_ratio(n / 2 + 1 / 2)
    ratio = (n + 1) * F / (2 * np.sqrt(np.pi) * E_star * n * A * kappa)
    return np.sqrt(np.pi) * A * kappa * without_root(ratio, n, 1)
