"""Power law on a power-law graded half-space.

Every self-similar profile: F ~ d^(1 + 1/n). Cone, paraboloid and quartic are n = 1, 2, 4.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.growth import power_depth, power_force, power_mean, power_rate
from ..._runtime.graded.punch import punch_stiffness
from ..._runtime.interface import Array, Result, elementwise, require

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "depth",
    "depth_from_force",
    "displacement",
    "force",
    "force_from_depth",
    "mean_pressure",
    "pressure",
    "profile",
    "radius_from_depth",
    "radius_from_force",
    "stiffness",
]


def __dir__() -> list[str]:
    return __all__


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
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN.

    References
    ----------
    Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import power_law
    >>> value = power_law.profile(0.3, A=0.45, n=1.5)
    >>> round(value, 6)
    0.073943
    """
    from ...normal import power_law as normal

    return normal.profile(r, A=A, n=n)


def depth(a: ArrayLike, *, A: ArrayLike, n: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = A*a**n*gamma((k + 1)/2)*gamma(n/2 + 1)/gamma((k + n + 1)/2)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

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
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. Handbook:
    power_law.fgm.d.

    References
    ----------
    chapter 11, equation (11.61); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import power_law
    >>> value = power_law.depth(1.0, A=0.45, n=1.5, k=0.25)
    >>> round(value, 6)
    0.667428
    """
    require(A=A, n=n, k=k)
    return elementwise(_depth, a, A=A, n=n, k=k)


def force(a: ArrayLike, *, A: ArrayLike, n: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force.

    F = 2*A*H*a**(k + n + 1)*n*gamma((k + 1)/2)*gamma(n/2 + 1)/((k + 1)*(k + n + 1)*gamma((k + n + 1)/2))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

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
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. Handbook:
    power_law.fgm.F.

    References
    ----------
    chapter 11, equation (11.51); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import power_law
    >>> value = power_law.force(1.0, A=0.45, n=1.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.582482
    """
    require(A=A, n=n, H=H, k=k)
    return elementwise(_force, a, A=A, n=n, H=H, k=k)


def pressure(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, n: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = A*H*n*r**(k + n - 1)*IncompleteBeta(1 - r**2/a**2, (k + 1)/2, (-k - n + 1)/2)*gamma((k +
    1)/2)*gamma(n/2 + 1)/(2*pi*gamma((k + n + 1)/2))
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
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

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
    over the growing contact, by a rule that carries the weight of the grading. Handbook: power_law.fgm.p.

    References
    ----------
    chapter 11, equation (11.53); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import power_law
    >>> value = power_law.pressure(0.3, 1.0, A=0.45, n=1.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.31832
    """
    require(A=A, n=n, H=H, k=k)
    return elementwise(_pressure, r, a, A=A, n=n, H=H, k=k)


def displacement(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, n: ArrayLike, k: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = A*(a**n*IncompleteBeta(a**2/r**2, (k + 1)/2, (1 - k)/2) - r**n*IncompleteBeta(a**2/r**2, (k + n +
    1)/2, (1 - k)/2))*cos(pi*k/2)*gamma((k + 1)/2)*gamma(n/2 + 1)/(pi*gamma((k + n + 1)/2))
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
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

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
    over the displacement inside the contact. Handbook: power_law.fgm.w.

    References
    ----------
    chapter 11, equation (11.56); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import power_law
    >>> value = power_law.displacement(2.0, 1.0, A=0.45, n=1.5, k=0.25)
    >>> round(value, 6)
    0.074781
    """
    require(A=A, n=n, k=k)
    return elementwise(_displacement, r, a, A=A, n=n, k=k)


def stiffness(a: ArrayLike, *, A: ArrayLike, n: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*H*a**(k + 1)/(k + 1)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

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
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. Handbook:
    power_law.fgm.k.

    References
    ----------
    chapter 11, equation (11.46); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import power_law
    >>> value = power_law.stiffness(1.0, A=0.45, n=1.5, H=1.0, k=0.25)
    >>> round(value, 6)
    1.6
    """
    require(A=A, n=n, H=H, k=k)
    return elementwise(_stiffness, a, H=H, k=k, unused=(A, n))


def mean_pressure(a: ArrayLike, *, A: ArrayLike, n: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = 2*A*H*a**(k + n - 1)*n*gamma((k + 1)/2)*gamma(n/2 + 1)/(pi*(k + 1)*(k + n + 1)*gamma((k + n +
    1)/2))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

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
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. Handbook:
    power_law.fgm.pm.

    References
    ----------
    Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import power_law
    >>> value = power_law.mean_pressure(1.0, A=0.45, n=1.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.18541
    """
    require(A=A, n=n, H=H, k=k)
    return elementwise(_mean_pressure, a, A=A, n=n, H=H, k=k)


def radius_from_depth(d: ArrayLike, *, A: ArrayLike, n: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a = (d*gamma((k + n + 1)/2)/(A*gamma((k + 1)/2)*gamma(n/2 + 1)))**(1/n)

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

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
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. Handbook:
    power_law.fgm.ad.

    References
    ----------
    chapter 11, equation (11.48); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import power_law
    >>> value = power_law.radius_from_depth(0.6674, A=0.45, n=1.5, k=0.25)
    >>> round(value, 6)
    0.999972
    """
    require(A=A, n=n, k=k)
    return elementwise(_radius_from_depth, d, A=A, n=n, k=k)


def radius_from_force(F: ArrayLike, *, A: ArrayLike, n: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a = (F*(k + 1)*(k + n + 1)*gamma((k + n + 1)/2)/(2*A*H*n*gamma((k + 1)/2)*gamma(n/2 + 1)))**(1/(k + n +
    1))

    Parameters
    ----------
    F : array_like
        Normal force [N].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

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
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. Handbook:
    power_law.fgm.aF.

    References
    ----------
    chapter 11, equation (11.51); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import power_law
    >>> value = power_law.radius_from_force(0.5825, A=0.45, n=1.5, H=1.0, k=0.25)
    >>> round(value, 6)
    1.000011
    """
    require(A=A, n=n, H=H, k=k)
    return elementwise(_radius_from_force, F, A=A, n=n, H=H, k=k)


def force_from_depth(d: ArrayLike, *, A: ArrayLike, n: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = 2*A*H*n*(d*gamma((k + n + 1)/2)/(A*gamma((k + 1)/2)*gamma(n/2 + 1)))**((k + n + 1)/n)*gamma((k +
    1)/2)*gamma(n/2 + 1)/((k + 1)*(k + n + 1)*gamma((k + n + 1)/2))

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

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
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. Handbook:
    power_law.fgm.Fd.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import power_law
    >>> value = power_law.force_from_depth(0.6674, A=0.45, n=1.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.582438
    """
    require(A=A, n=n, H=H, k=k)
    return elementwise(_force_from_depth, d, A=A, n=n, H=H, k=k)


def depth_from_force(F: ArrayLike, *, A: ArrayLike, n: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = A*(F*(k + 1)*(k + n + 1)*gamma((k + n + 1)/2)/(2*A*H*n*gamma((k + 1)/2)*gamma(n/2 + 1)))**(n/(k + n +
    1))*gamma((k + 1)/2)*gamma(n/2 + 1)/gamma((k + n + 1)/2)

    Parameters
    ----------
    F : array_like
        Normal force [N].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

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
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN field values give NaN. Handbook:
    power_law.fgm.dF.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import power_law
    >>> value = power_law.depth_from_force(0.5825, A=0.45, n=1.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.667439
    """
    require(A=A, n=n, H=H, k=k)
    return elementwise(_depth_from_force, F, A=A, n=n, H=H, k=k)


def _depth(a: Array, A: Array, n: Array, k: Array) -> Array:
    return A * power_depth(a, n, k)


def _rate(a: Array, A: Array, n: Array, k: Array) -> Array:
    """Rate g'(a) of the depth."""
    return A * power_rate(a, n, k)


def _force(a: Array, A: Array, n: Array, H: Array, k: Array) -> Array:
    growth = A * power_force(a, n, k)
    return 2.0 * H / (1.0 + k) * growth


def _stiffness(a: Array, H: Array, k: Array) -> Array:
    return punch_stiffness(a, H, k)


def _mean_pressure(a: Array, A: Array, n: Array, H: Array, k: Array) -> Array:
    growth = A * power_mean(a, n, k)
    return 2.0 * H / (1.0 + k) / np.pi * growth


def _pressure(r: Array, a: Array, A: Array, n: Array, H: Array, k: Array) -> Array:
    from ..._runtime.graded.pressure import power_pressure

    inside = np.minimum(r, a)
    growth = A * power_pressure(inside, a, n, k)
    return np.where(r < a, H / np.pi * growth, 0.0)


def _displacement(r: Array, a: Array, A: Array, n: Array, k: Array) -> Array:
    from ..._runtime.graded.displacement import power_displacement

    return A * power_displacement(r, a, n, k)


def _radius_from_depth(d: Array, A: Array, n: Array, k: Array) -> Array:
    return (d / _depth(np.ones_like(d), A, n, k)) ** (1.0 / n)


def _radius_from_force(F: Array, A: Array, n: Array, H: Array, k: Array) -> Array:
    return (F / _force(np.ones_like(F), A, n, H, k)) ** (1.0 / (n + (1.0 + k)))


def _force_from_depth(d: Array, A: Array, n: Array, H: Array, k: Array) -> Array:
    stiffness = punch_stiffness(_radius_from_depth(d, A, n, k), H, k)
    return np.where((d > 0.0) & np.isfinite(d), d * (stiffness * (n / (n + (1.0 + k)))), d)


def _depth_from_force(F: Array, A: Array, n: Array, H: Array, k: Array) -> Array:
    stiffness = punch_stiffness(_radius_from_force(F, A, n, H, k), H, k)
    return np.where((F > 0.0) & np.isfinite(F), F / (stiffness * (n / (n + (1.0 + k)))), F)
