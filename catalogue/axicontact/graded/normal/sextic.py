"""Sextic profile on a power-law graded half-space.

Flatter at the tip than the quartic: most of the load is carried near the rim of the contact.
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

    f = A*r**6

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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import sextic
    >>> value = sextic.profile(0.3, A=0.4)
    >>> round(value, 6)
    0.000292
    """
    from ...normal import sextic as normal

    return normal.profile(r, A=A)


def depth(a: ArrayLike, *, A: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = 48*A*a**6/((k + 1)*(k + 3)*(k + 5))

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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: sextic.fgm.d.

    References
    ----------
    chapter 11, equation (11.61); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import sextic
    >>> value = sextic.depth(1.0, A=0.4, k=0.25)
    >>> round(value, 6)
    0.90022
    """
    require(A=A, k=k)
    return elementwise(_depth, a, A=A, k=k)


def force(a: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force.

    F = 576*A*H*a**(k + 7)/((k + 1)**2*(k + 3)*(k + 5)*(k + 7))

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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: sextic.fgm.F.

    References
    ----------
    chapter 11, equation (11.51); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import sextic
    >>> value = sextic.force(1.0, A=0.4, H=1.0, k=0.25)
    >>> round(value, 6)
    1.192015
    """
    require(A=A, H=H, k=k)
    return elementwise(_force, a, A=A, H=H, k=k)


def pressure(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = 288*A*H*(a**2 - r**2)**(k/2 + 1/2)*(a**4*k**2 + 4*a**4*k + 3*a**4 + 4*a**2*k*r**2 + 4*a**2*r**2 +
    8*r**4)/(pi*(k + 1)**2*(k + 3)**2*(k + 5)**2)

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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Evaluated as an integral over
    the growing contact, by a rule that carries the weight of the grading. Handbook: sextic.fgm.p.

    References
    ----------
    chapter 11, equation (11.53); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import sextic
    >>> value = sextic.pressure(0.3, 1.0, A=0.4, H=1.0, k=0.25)
    >>> round(value, 6)
    0.347862
    """
    require(A=A, H=H, k=k)
    return elementwise(_pressure, r, a, A=A, H=H, k=k)


def displacement(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, k: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 48*A*(a**6*IncompleteBeta(a**2/r**2, (k + 1)/2, (1 - k)/2) - r**6*IncompleteBeta(a**2/r**2, (k + 7)/2,
    (1 - k)/2))*cos(pi*k/2)/(pi*(k + 1)*(k + 3)*(k + 5))
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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Evaluated as an integral over
    the displacement inside the contact. Handbook: sextic.fgm.w.

    References
    ----------
    chapter 11, equation (11.56); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import sextic
    >>> value = sextic.displacement(2.0, 1.0, A=0.4, k=0.25)
    >>> round(value, 6)
    0.155162
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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: sextic.fgm.k.

    References
    ----------
    chapter 11, equation (11.46); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import sextic
    >>> value = sextic.stiffness(1.0, A=0.4, H=1.0, k=0.25)
    >>> round(value, 6)
    1.6
    """
    require(A=A, H=H, k=k)
    return elementwise(_stiffness, a, H=H, k=k, unused=(A,))


def mean_pressure(a: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = 576*A*H*a**(k + 5)/(pi*(k + 1)**2*(k + 3)*(k + 5)*(k + 7))

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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: sextic.fgm.pm.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import sextic
    >>> value = sextic.mean_pressure(1.0, A=0.4, H=1.0, k=0.25)
    >>> round(value, 6)
    0.37943
    """
    require(A=A, H=H, k=k)
    return elementwise(_mean_pressure, a, A=A, H=H, k=k)


def radius_from_depth(d: ArrayLike, *, A: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a = 2**(1/3)*3**(5/6)*d**(1/6)*(k + 1)**(1/6)*(k + 3)**(1/6)*(k + 5)**(1/6)/(6*A**(1/6))

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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: sextic.fgm.ad.

    References
    ----------
    chapter 11, equation (11.48); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import sextic
    >>> value = sextic.radius_from_depth(0.9002, A=0.4, k=0.25)
    >>> round(value, 6)
    0.999996
    """
    require(A=A, k=k)
    return elementwise(_radius_from_depth, d, A=A, k=k)


def radius_from_force(F: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a = (F*(k + 1)**2*(k + 3)*(k + 5)*(k + 7)/(576*A*H))**(1/(k + 7))

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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: sextic.fgm.aF.

    References
    ----------
    chapter 11, equation (11.51); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import sextic
    >>> value = sextic.radius_from_force(1.192, A=0.4, H=1.0, k=0.25)
    >>> round(value, 6)
    0.999998
    """
    require(A=A, H=H, k=k)
    return elementwise(_radius_from_force, F, A=A, H=H, k=k)


def force_from_depth(d: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = 576*A*H*(2**(1/3)*3**(5/6)*d**(1/6)*(k + 1)**(1/6)*(k + 3)**(1/6)*(k + 5)**(1/6)/(6*A**(1/6)))**(k +
    7)/((k + 1)**2*(k + 3)*(k + 5)*(k + 7))

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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: sextic.fgm.Fd.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import sextic
    >>> value = sextic.force_from_depth(0.9002, A=0.4, H=1.0, k=0.25)
    >>> round(value, 6)
    1.191984
    """
    require(A=A, H=H, k=k)
    return elementwise(_force_from_depth, d, A=A, H=H, k=k)


def depth_from_force(F: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = 48*A*(F**6*(k + 1)**12*(k + 3)**6*(k + 5)**6*(k + 7)**6/(36520347436056576*A**6*H**6))**(1/(k +
    7))/((k + 1)*(k + 3)*(k + 5))

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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN field values give NaN. Handbook: sextic.fgm.dF.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import sextic
    >>> value = sextic.depth_from_force(1.192, A=0.4, H=1.0, k=0.25)
    >>> round(value, 6)
    0.90021
    """
    require(A=A, H=H, k=k)
    return elementwise(_depth_from_force, F, A=A, H=H, k=k)


def _depth(a: Array, A: Array, k: Array) -> Array:
    return A * power_depth(a, 6.0, k)


def _rate(a: Array, A: Array, k: Array) -> Array:
    """Rate g'(a) of the depth."""
    return A * power_rate(a, 6.0, k)


def _force(a: Array, A: Array, H: Array, k: Array) -> Array:
    growth = A * power_force(a, 6.0, k)
    return 2.0 * H / (1.0 + k) * growth


def _stiffness(a: Array, H: Array, k: Array) -> Array:
    return punch_stiffness(a, H, k)


def _mean_pressure(a: Array, A: Array, H: Array, k: Array) -> Array:
    growth = A * power_mean(a, 6.0, k)
    return 2.0 * H / (1.0 + k) / np.pi * growth


def _pressure(r: Array, a: Array, A: Array, H: Array, k: Array) -> Array:
    from ..._runtime.graded.pressure import power_pressure

    inside = np.minimum(r, a)
    growth = A * power_pressure(inside, a, 6.0, k)
    return np.where(r < a, H / np.pi * growth, 0.0)


def _displacement(r: Array, a: Array, A: Array, k: Array) -> Array:
    from ..._runtime.graded.displacement import power_displacement

    return A * power_displacement(r, a, 6.0, k)


def _radius_from_depth(d: Array, A: Array, k: Array) -> Array:
    return (d / _depth(np.ones_like(d), A, k)) ** (1.0 / 6.0)


def _radius_from_force(F: Array, A: Array, H: Array, k: Array) -> Array:
    return (F / _force(np.ones_like(F), A, H, k)) ** (1.0 / (7.0 + k))


def _force_from_depth(d: Array, A: Array, H: Array, k: Array) -> Array:
    stiffness = punch_stiffness(_radius_from_depth(d, A, k), H, k)
    return np.where((d > 0.0) & np.isfinite(d), d * (stiffness * (6.0 / (6.0 + (1.0 + k)))), d)


def _depth_from_force(F: Array, A: Array, H: Array, k: Array) -> Array:
    stiffness = punch_stiffness(_radius_from_force(F, A, H, k), H, k)
    return np.where((F > 0.0) & np.isfinite(F), F / (stiffness * (6.0 / (6.0 + (1.0 + k)))), F)
