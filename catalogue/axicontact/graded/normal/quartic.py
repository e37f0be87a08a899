"""Quartic profile on a power-law graded half-space.

Vanishing curvature at the tip: the pressure has a dip at the centre and its largest value on a ring.
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


def profile(r: ArrayLike, *, A: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = A*r**4

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.

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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN.

    References
    ----------
    Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import quartic
    >>> value = quartic.profile(0.3, A=0.4)
    >>> round(value, 6)
    0.00324
    """
    from ...normal import quartic as normal

    return normal.profile(r, A=A)


def depth(a: ArrayLike, *, A: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = 8*A*a**4/((k + 1)*(k + 3))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: quartic.fgm.d.

    References
    ----------
    chapter 11, equation (11.61); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import quartic
    >>> value = quartic.depth(1.0, A=0.4, k=0.25)
    >>> round(value, 6)
    0.787692
    """
    require(A=A, k=k)
    return elementwise(_depth, a, A=A, k=k)


def force(a: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force.

    F = 64*A*H*a**(k + 5)/((k + 1)**2*(k + 3)*(k + 5))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: quartic.fgm.F.

    References
    ----------
    chapter 11, equation (11.51); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import quartic
    >>> value = quartic.force(1.0, A=0.4, H=1.0, k=0.25)
    >>> round(value, 6)
    0.960234
    """
    require(A=A, H=H, k=k)
    return elementwise(_force, a, A=A, H=H, k=k)


def pressure(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = 32*A*H*(a**2 - r**2)**(k/2 + 1/2)*(a**2*k + a**2 + 2*r**2)/(pi*(k + 1)**2*(k + 3)**2)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Evaluated as an integral over
    the growing contact, by a rule that carries the weight of the grading. Handbook: quartic.fgm.p.

    References
    ----------
    chapter 11, equation (11.53); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import quartic
    >>> value = quartic.pressure(0.3, 1.0, A=0.4, H=1.0, k=0.25)
    >>> round(value, 6)
    0.332821
    """
    require(A=A, H=H, k=k)
    return elementwise(_pressure, r, a, A=A, H=H, k=k)


def displacement(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, k: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 8*A*(a**4*IncompleteBeta(a**2/r**2, (k + 1)/2, (1 - k)/2) - r**4*IncompleteBeta(a**2/r**2, (k + 5)/2,
    (1 - k)/2))*cos(pi*k/2)/(pi*(k + 1)*(k + 3))
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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Evaluated as an integral over
    the displacement inside the contact. Handbook: quartic.fgm.w.

    References
    ----------
    chapter 11, equation (11.56); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import quartic
    >>> value = quartic.displacement(2.0, 1.0, A=0.4, k=0.25)
    >>> round(value, 6)
    0.124483
    """
    require(A=A, k=k)
    return elementwise(_displacement, r, a, A=A, k=k)


def stiffness(a: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*H*a**(k + 1)/(k + 1)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: quartic.fgm.k.

    References
    ----------
    chapter 11, equation (11.46); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import quartic
    >>> value = quartic.stiffness(1.0, A=0.4, H=1.0, k=0.25)
    >>> round(value, 6)
    1.6
    """
    require(A=A, H=H, k=k)
    return elementwise(_stiffness, a, H=H, k=k, unused=(A,))


def mean_pressure(a: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = 64*A*H*a**(k + 3)/(pi*(k + 1)**2*(k + 3)*(k + 5))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: quartic.fgm.pm.

    References
    ----------
    Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import quartic
    >>> value = quartic.mean_pressure(1.0, A=0.4, H=1.0, k=0.25)
    >>> round(value, 6)
    0.305652
    """
    require(A=A, H=H, k=k)
    return elementwise(_mean_pressure, a, A=A, H=H, k=k)


def radius_from_depth(d: ArrayLike, *, A: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a = 2**(1/4)*d**(1/4)*(k + 1)**(1/4)*(k + 3)**(1/4)/(2*A**(1/4))

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: quartic.fgm.ad.

    References
    ----------
    chapter 11, equation (11.48); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import quartic
    >>> value = quartic.radius_from_depth(0.7877, A=0.4, k=0.25)
    >>> round(value, 6)
    1.000002
    """
    require(A=A, k=k)
    return elementwise(_radius_from_depth, d, A=A, k=k)


def radius_from_force(F: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a = (F*(k + 1)**2*(k + 3)*(k + 5)/(64*A*H))**(1/(k + 5))

    Parameters
    ----------
    F : array_like
        Normal force [N].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: quartic.fgm.aF.

    References
    ----------
    chapter 11, equation (11.51); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import quartic
    >>> value = quartic.radius_from_force(0.9602, A=0.4, H=1.0, k=0.25)
    >>> round(value, 6)
    0.999993
    """
    require(A=A, H=H, k=k)
    return elementwise(_radius_from_force, F, A=A, H=H, k=k)


def force_from_depth(d: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = 64*A*H*(2**(1/4)*d**(1/4)*(k + 1)**(1/4)*(k + 3)**(1/4)/(2*A**(1/4)))**(k + 5)/((k + 1)**2*(k + 3)*(k
    + 5))

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: quartic.fgm.Fd.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import quartic
    >>> value = quartic.force_from_depth(0.7877, A=0.4, H=1.0, k=0.25)
    >>> round(value, 6)
    0.960247
    """
    require(A=A, H=H, k=k)
    return elementwise(_force_from_depth, d, A=A, H=H, k=k)


def depth_from_force(F: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = 8*A*(F**4*(k + 1)**8*(k + 3)**4*(k + 5)**4/(16777216*A**4*H**4))**(1/(k + 5))/((k + 1)*(k + 3))

    Parameters
    ----------
    F : array_like
        Normal force [N].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN field values give NaN. Handbook: quartic.fgm.dF.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import quartic
    >>> value = quartic.depth_from_force(0.9602, A=0.4, H=1.0, k=0.25)
    >>> round(value, 6)
    0.787671
    """
    require(A=A, H=H, k=k)
    return elementwise(_depth_from_force, F, A=A, H=H, k=k)


def _depth(a: Array, A: Array, k: Array) -> Array:
    return A * power_depth(a, 4.0, k)


def _rate(a: Array, A: Array, k: Array) -> Array:
    """Rate g'(a) of the depth."""
    return A * power_rate(a, 4.0, k)


def _force(a: Array, A: Array, H: Array, k: Array) -> Array:
    growth = A * power_force(a, 4.0, k)
    return 2.0 * H / (1.0 + k) * growth


def _stiffness(a: Array, H: Array, k: Array) -> Array:
    return punch_stiffness(a, H, k)


def _mean_pressure(a: Array, A: Array, H: Array, k: Array) -> Array:
    growth = A * power_mean(a, 4.0, k)
    return 2.0 * H / (1.0 + k) / np.pi * growth


def _pressure(r: Array, a: Array, A: Array, H: Array, k: Array) -> Array:
    from ..._runtime.graded.pressure import power_pressure

    inside = np.minimum(r, a)
    growth = A * power_pressure(inside, a, 4.0, k)
    return np.where(r < a, H / np.pi * growth, 0.0)


def _displacement(r: Array, a: Array, A: Array, k: Array) -> Array:
    from ..._runtime.graded.displacement import power_displacement

    return A * power_displacement(r, a, 4.0, k)


def _radius_from_depth(d: Array, A: Array, k: Array) -> Array:
    return (d / _depth(np.ones_like(d), A, k)) ** (1.0 / 4.0)


def _radius_from_force(F: Array, A: Array, H: Array, k: Array) -> Array:
    return (F / _force(np.ones_like(F), A, H, k)) ** (1.0 / (5.0 + k))


def _force_from_depth(d: Array, A: Array, H: Array, k: Array) -> Array:
    stiffness = punch_stiffness(_radius_from_depth(d, A, k), H, k)
    return np.where((d > 0.0) & np.isfinite(d), d * (stiffness * (4.0 / (4.0 + (1.0 + k)))), d)


def _depth_from_force(F: Array, A: Array, H: Array, k: Array) -> Array:
    stiffness = punch_stiffness(_radius_from_force(F, A, H, k), H, k)
    return np.where((F > 0.0) & np.isfinite(F), F / (stiffness * (4.0 / (4.0 + (1.0 + k)))), F)
