"""Polynomial on a power-law graded half-space.

Any sum of integer powers with coefficients A_1 ... A_N >= 0: superposition at a fixed contact radius.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.growth import power_depth, power_force, power_mean, power_rate
from ..._runtime.graded.punch import punch_depth, punch_force, punch_stiffness
from ..._runtime.interface import Array, Result, elementwise, require, require_coefficients

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

    f = Sum(r**j*A[j], (j, 1, N))

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    A : sequence of float
        A is the sequence A_1, A_2, ... of coefficients of r, r^2, ..., none negative and not all zero.

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
    Valid for small slopes. Negative or NaN field values give NaN.

    References
    ----------
    Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import polynomial
    >>> value = polynomial.profile(0.3, A=(0.1, 0.25, 0.05))
    >>> round(value, 6)
    0.05385
    """
    from ...normal import polynomial as normal

    return normal.profile(r, A=A)


def depth(a: ArrayLike, *, A: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = gamma((k + 1)/2)*Sum(a**j*gamma(j/2 + 1)*A[j]/gamma((j + k + 1)/2), (j, 1, N))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN field values give NaN. Handbook: polynomial.fgm.d.

    References
    ----------
    chapter 11, equation (11.61); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import polynomial
    >>> value = polynomial.depth(1.0, A=(0.1, 0.25, 0.05), k=0.25)
    >>> round(value, 6)
    0.624992
    """
    A = require_coefficients(A)
    require(k=k)
    return elementwise(partial(_depth, A=A), a, k=k)


def force(a: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force.

    F = 2*H*gamma((k + 1)/2)*Sum(a**(j + k + 1)*j*gamma(j/2 + 1)*A[j]/((j + k + 1)*gamma((j + k + 1)/2)), (j,
    1, N))/(k + 1)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN field values give NaN. Handbook: polynomial.fgm.F.

    References
    ----------
    chapter 11, equation (11.51); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import polynomial
    >>> value = polynomial.force(1.0, A=(0.1, 0.25, 0.05), H=1.0, k=0.25)
    >>> round(value, 6)
    0.591486
    """
    A = require_coefficients(A)
    require(H=H, k=k)
    return elementwise(partial(_force, A=A), a, H=H, k=k)


def pressure(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = H*gamma((k + 1)/2)*Sum(j*r**(j + k - 1)*IncompleteBeta(1 - r**2/a**2, (k + 1)/2, (-j - k +
    1)/2)*gamma(j/2 + 1)*A[j]/gamma((j + k + 1)/2), (j, 1, N))/(2*pi)
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN field values give NaN. Evaluated as an integral over the growing
    contact, by a rule that carries the weight of the grading. Handbook: polynomial.fgm.p.

    References
    ----------
    chapter 11, equation (11.53); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import polynomial
    >>> value = polynomial.pressure(0.3, 1.0, A=(0.1, 0.25, 0.05), H=1.0, k=0.25)
    >>> round(value, 6)
    0.291619
    """
    A = require_coefficients(A)
    require(H=H, k=k)
    return elementwise(partial(_pressure, A=A), r, a, H=H, k=k)


def displacement(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, k: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = cos(pi*k/2)*gamma((k + 1)/2)*Sum((a**j*IncompleteBeta(a**2/r**2, (k + 1)/2, (1 - k)/2) -
    r**j*IncompleteBeta(a**2/r**2, (j + k + 1)/2, (1 - k)/2))*gamma(j/2 + 1)*A[j]/gamma((j + k + 1)/2), (j, 1,
    N))/pi
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN field values give NaN. Evaluated as an integral over the
    displacement inside the contact. Handbook: polynomial.fgm.w.

    References
    ----------
    chapter 11, equation (11.56); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import polynomial
    >>> value = polynomial.displacement(2.0, 1.0, A=(0.1, 0.25, 0.05), k=0.25)
    >>> round(value, 6)
    0.07612
    """
    A = require_coefficients(A)
    require(k=k)
    return elementwise(partial(_displacement, A=A), r, a, k=k)


def stiffness(a: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*H*a**(k + 1)/(k + 1)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN field values give NaN. Handbook: polynomial.fgm.k.

    References
    ----------
    chapter 11, equation (11.46); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import polynomial
    >>> value = polynomial.stiffness(1.0, A=(0.1, 0.25, 0.05), H=1.0, k=0.25)
    >>> round(value, 6)
    1.6
    """
    A = require_coefficients(A)
    require(H=H, k=k)
    return elementwise(_stiffness, a, H=H, k=k)


def mean_pressure(a: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = 2*H*gamma((k + 1)/2)*Sum(a**(j + k - 1)*j*gamma(j/2 + 1)*A[j]/((j + k + 1)*gamma((j + k + 1)/2)),
    (j, 1, N))/(pi*(k + 1))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN field values give NaN. Handbook: polynomial.fgm.pm.

    References
    ----------
    Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import polynomial
    >>> value = polynomial.mean_pressure(1.0, A=(0.1, 0.25, 0.05), H=1.0, k=0.25)
    >>> round(value, 6)
    0.188276
    """
    A = require_coefficients(A)
    require(H=H, k=k)
    return elementwise(partial(_mean_pressure, A=A), a, H=H, k=k)


def radius_from_depth(d: ArrayLike, *, A: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a from gamma((k + 1)/2)*Sum(a**j*gamma(j/2 + 1)*A[j]/gamma((j + k + 1)/2), (j, 1, N)) = d

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: polynomial.fgm.ad.

    References
    ----------
    chapter 11, equation (11.48); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import polynomial
    >>> value = polynomial.radius_from_depth(0.625, A=(0.1, 0.25, 0.05), k=0.25)
    >>> round(value, 6)
    1.000006
    """
    A = require_coefficients(A)
    require(k=k)
    return elementwise(partial(_radius_from_depth, A=A), d, k=k)


def radius_from_force(F: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a from 2*H*gamma((k + 1)/2)*Sum(a**(j + k + 1)*j*gamma(j/2 + 1)*A[j]/((j + k + 1)*gamma((j + k + 1)/2)),
    (j, 1, N))/(k + 1) = F

    Parameters
    ----------
    F : array_like
        Normal force [N].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: polynomial.fgm.aF.

    References
    ----------
    chapter 11, equation (11.51); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import polynomial
    >>> value = polynomial.radius_from_force(0.5915, A=(0.1, 0.25, 0.05), H=1.0, k=0.25)
    >>> round(value, 6)
    1.000007
    """
    A = require_coefficients(A)
    require(H=H, k=k)
    return elementwise(partial(_radius_from_force, A=A), F, H=H, k=k)


def force_from_depth(d: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = F(a(d)), through the contact radius.

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: polynomial.fgm.Fd.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import polynomial
    >>> value = polynomial.force_from_depth(0.625, A=(0.1, 0.25, 0.05), H=1.0, k=0.25)
    >>> round(value, 6)
    0.591499
    """
    A = require_coefficients(A)
    require(H=H, k=k)
    return elementwise(partial(_force_from_depth, A=A), d, H=H, k=k)


def depth_from_force(F: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = d(a(F)), through the contact radius.

    Parameters
    ----------
    F : array_like
        Normal force [N].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: polynomial.fgm.dF.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import polynomial
    >>> value = polynomial.depth_from_force(0.5915, A=(0.1, 0.25, 0.05), H=1.0, k=0.25)
    >>> round(value, 6)
    0.625001
    """
    A = require_coefficients(A)
    require(H=H, k=k)
    return elementwise(partial(_depth_from_force, A=A), F, H=H, k=k)


def _depth(a: Array, A: tuple[float, ...], k: Array) -> Array:
    return sum(A_j * power_depth(a, j, k) for j, A_j in enumerate(A, 1))


def _rate(a: Array, A: tuple[float, ...], k: Array) -> Array:
    """Rate g'(a) of the depth."""
    return sum(A_j * power_rate(a, j, k) for j, A_j in enumerate(A, 1))


def _force(a: Array, A: tuple[float, ...], H: Array, k: Array) -> Array:
    growth = sum(A_j * power_force(a, j, k) for j, A_j in enumerate(A, 1))
    return 2.0 * H / (1.0 + k) * growth


def _force_rate(a: Array, A: tuple[float, ...], H: Array, k: Array) -> Array:
    """Derivative of the force."""
    return punch_stiffness(a, H, k) * _rate(a, A, k)


def _stiffness(a: Array, H: Array, k: Array) -> Array:
    return punch_stiffness(a, H, k)


def _mean_pressure(a: Array, A: tuple[float, ...], H: Array, k: Array) -> Array:
    growth = sum(A_j * power_mean(a, j, k) for j, A_j in enumerate(A, 1))
    return 2.0 * H / (1.0 + k) / np.pi * growth


def _pressure(r: Array, a: Array, A: tuple[float, ...], H: Array, k: Array) -> Array:
    from ..._runtime.graded.pressure import power_pressure

    inside = np.minimum(r, a)
    growth = sum(A_j * power_pressure(inside, a, j, k) for j, A_j in enumerate(A, 1) if A_j)
    return np.where(r < a, H / np.pi * growth, 0.0)


def _displacement(r: Array, a: Array, A: tuple[float, ...], k: Array) -> Array:
    from ..._runtime.graded.displacement import power_displacement

    return sum(A_j * power_displacement(r, a, j, k) for j, A_j in enumerate(A, 1))


def _radius_from_depth(d: Array, A: tuple[float, ...], k: Array) -> Array:
    from ..._runtime.graded.inverse import radius_to

    return radius_to(_depth, _rate, d, 1.0, (A, k))


def _radius_from_force(F: Array, A: tuple[float, ...], H: Array, k: Array) -> Array:
    from ..._runtime.graded.inverse import radius_to

    return radius_to(_force, _force_rate, F, 1.0, (A, H, k))


def _force_from_depth(d: Array, A: tuple[float, ...], H: Array, k: Array) -> Array:
    a = _radius_from_depth(d, A, k)
    return _force(a, A, H, k) + punch_force(d - _depth(a, A, k), a, H, k)


def _depth_from_force(F: Array, A: tuple[float, ...], H: Array, k: Array) -> Array:
    a = _radius_from_force(F, A, H, k)
    return _depth(a, A, k) + punch_depth(F - _force(a, A, H, k), a, H, k)
