"""Polynomial.

Any sum of integer powers with coefficients A_1 ... A_N >= 0: superposition at a fixed contact radius.
"""

from __future__ import annotations

from functools import partial, reduce
from typing import TYPE_CHECKING

import numpy as np

from .._runtime.functions import depth_over_height
from .._runtime.interface import Array, Result, elementwise, require, require_coefficients
from .._runtime.inverse import inverse
from .._runtime.shapes.energy import energy_integral
from .._runtime.shapes.load_within import load_within_integral
from .._runtime.shapes.powers import power_displacement, power_pressure

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
    Valid for small slopes. Negative or NaN field values give NaN. Handbook: polynomial.f, the definition of
    the profile.

    References
    ----------
    Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import polynomial
    >>> value = polynomial.profile(0.3, A=(0.1, 0.25, 0.05))
    >>> round(value, 6)
    0.05385
    """
    A = require_coefficients(A)
    return elementwise(partial(_profile, A=A), r)


def depth(a: ArrayLike, *, A: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = sqrt(pi)*Sum(a**j*gamma(j/2 + 1)*A[j]/gamma((j + 1)/2), (j, 1, N))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : sequence of float
        A is the sequence A_1, A_2, ... of coefficients of r, r^2, ..., none negative and not all zero.

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
    Valid for small slopes. Negative or NaN field values give NaN. Handbook: polynomial.d.

    References
    ----------
    chapter 11, equation (11.29); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import polynomial
    >>> value = polynomial.depth(1.0, A=(0.1, 0.25, 0.05))
    >>> round(value, 6)
    0.774889
    """
    A = require_coefficients(A)
    return elementwise(partial(_depth, A=A), a)


def force(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force.

    F = 2*sqrt(pi)*E_star*Sum(a**(j + 1)*j*gamma(j/2 + 1)*A[j]/((j + 1)*gamma((j + 1)/2)), (j, 1, N))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : sequence of float
        A is the sequence A_1, A_2, ... of coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN field values give NaN. Handbook: polynomial.F.

    References
    ----------
    chapter 11, equation (11.20); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import polynomial
    >>> value = polynomial.force(1.0, A=(0.1, 0.25, 0.05), E_star=1.0)
    >>> round(value, 6)
    1.000461
    """
    A = require_coefficients(A)
    require(E_star=E_star)
    return elementwise(partial(_force, A=A), a, E_star=E_star)


def pressure(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = E_star*Sum(j*r**(j - 1)*IncompleteBeta(1 - r**2/a**2, 1/2, (1 - j)/2)*gamma(j/2 + 1)*A[j]/gamma((j +
    1)/2), (j, 1, N))/(2*sqrt(pi))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    A : sequence of float
        A is the sequence A_1, A_2, ... of coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN field values give NaN. Evaluated as an integral over the growing
    contact by a Gauss-Legendre rule. Handbook: polynomial.p.

    References
    ----------
    chapter 11, equation (11.23); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import polynomial
    >>> value = polynomial.pressure(0.3, 1.0, A=(0.1, 0.25, 0.05), E_star=1.0)
    >>> round(value, 6)
    0.460485
    """
    A = require_coefficients(A)
    require(E_star=E_star)
    return elementwise(partial(_pressure, A=A), r, a, E_star=E_star)


def displacement(r: ArrayLike, a: ArrayLike, *, A: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = Sum((2*a**j*asin(a/r) - r**j*IncompleteBeta(a**2/r**2, (j + 1)/2, 1/2))*gamma(j/2 + 1)*A[j]/gamma((j +
    1)/2), (j, 1, N))/sqrt(pi)
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    A : sequence of float
        A is the sequence A_1, A_2, ... of coefficients of r, r^2, ..., none negative and not all zero.

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
    Valid for small slopes. Negative or NaN field values give NaN. Evaluated as an integral over the growing
    contact by a Gauss-Legendre rule. Handbook: polynomial.w.

    References
    ----------
    chapter 11, equation (11.26); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import polynomial
    >>> value = polynomial.displacement(2.0, 1.0, A=(0.1, 0.25, 0.05))
    >>> round(value, 6)
    0.163544
    """
    A = require_coefficients(A)
    return elementwise(partial(_displacement, A=A), r, a)


def stiffness(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*E_star*a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : sequence of float
        A is the sequence A_1, A_2, ... of coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN field values give NaN. Handbook: polynomial.k.

    References
    ----------
    chapter 11, equation (11.18); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import polynomial
    >>> value = polynomial.stiffness(1.0, A=(0.1, 0.25, 0.05), E_star=1.0)
    >>> round(value, 6)
    2.0
    """
    require_coefficients(A)
    require(E_star=E_star)
    return elementwise(_stiffness, a, E_star=E_star)


def mean_pressure(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = 2*E_star*Sum(a**(j - 1)*j*gamma(j/2 + 1)*A[j]/((j + 1)*gamma((j + 1)/2)), (j, 1, N))/sqrt(pi)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : sequence of float
        A is the sequence A_1, A_2, ... of coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN field values give NaN. Handbook: polynomial.pm.

    References
    ----------
    Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import polynomial
    >>> value = polynomial.mean_pressure(1.0, A=(0.1, 0.25, 0.05), E_star=1.0)
    >>> round(value, 6)
    0.318457
    """
    A = require_coefficients(A)
    require(E_star=E_star)
    return elementwise(partial(_mean_pressure, A=A), a, E_star=E_star)


def radius_from_depth(d: ArrayLike, *, A: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a from sqrt(pi)*Sum(a**j*gamma(j/2 + 1)*A[j]/gamma((j + 1)/2), (j, 1, N)) = d

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    A : sequence of float
        A is the sequence A_1, A_2, ... of coefficients of r, r^2, ..., none negative and not all zero.

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
    iteration. Handbook: polynomial.ad.

    References
    ----------
    chapter 11, equation (11.16); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import polynomial
    >>> value = polynomial.radius_from_depth(0.7749, A=(0.1, 0.25, 0.05))
    >>> round(value, 6)
    1.000007
    """
    A = require_coefficients(A)
    return elementwise(partial(_radius_from_depth, A=A), d)


def radius_from_force(F: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a from 2*sqrt(pi)*E_star*Sum(a**(j + 1)*j*gamma(j/2 + 1)*A[j]/((j + 1)*gamma((j + 1)/2)), (j, 1, N)) = F

    Parameters
    ----------
    F : array_like
        Normal force [N].
    A : sequence of float
        A is the sequence A_1, A_2, ... of coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: polynomial.aF.

    References
    ----------
    chapter 11, equation (11.20); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import polynomial
    >>> value = polynomial.radius_from_force(1.0, A=(0.1, 0.25, 0.05), E_star=1.0)
    >>> round(value, 6)
    0.999847
    """
    A = require_coefficients(A)
    require(E_star=E_star)
    return elementwise(partial(_radius_from_force, A=A), F, E_star=E_star)


def force_from_depth(d: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = F(a(d)), through the contact radius.

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    A : sequence of float
        A is the sequence A_1, A_2, ... of coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: polynomial.Fd.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import polynomial
    >>> value = polynomial.force_from_depth(0.7749, A=(0.1, 0.25, 0.05), E_star=1.0)
    >>> round(value, 6)
    1.000482
    """
    A = require_coefficients(A)
    require(E_star=E_star)
    return elementwise(partial(_force_from_depth, A=A), d, E_star=E_star)


def depth_from_force(F: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = d(a(F)), through the contact radius.

    Parameters
    ----------
    F : array_like
        Normal force [N].
    A : sequence of float
        A is the sequence A_1, A_2, ... of coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: polynomial.dF.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import polynomial
    >>> value = polynomial.depth_from_force(1.0, A=(0.1, 0.25, 0.05), E_star=1.0)
    >>> round(value, 6)
    0.774659
    """
    A = require_coefficients(A)
    require(E_star=E_star)
    return elementwise(partial(_depth_from_force, A=A), F, E_star=E_star)


def energy(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Elastic energy, the work of pressing the indenter in.

    U = E_star*Integral((sqrt(pi)*Sum(a**j*gamma(j/2 + 1)*A[j]/gamma((j + 1)/2), (j, 1, N)) -
    sqrt(pi)*Sum(t**j*gamma(j/2 + 1)*A[j]/gamma((j + 1)/2), (j, 1, N)))**2, (t, 0, a))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : sequence of float
        A is the sequence A_1, A_2, ... of coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN field values give NaN. Evaluated as an integral over the growing
    contact by a Gauss-Legendre rule. Handbook: polynomial.U.

    References
    ----------
    Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import polynomial
    >>> value = polynomial.energy(1.0, A=(0.1, 0.25, 0.05), E_star=1.0)
    >>> round(value, 6)
    0.301307
    """
    A = require_coefficients(A)
    require(E_star=E_star)
    return elementwise(partial(_energy, A=A), a, E_star=E_star)


def load_within(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Part of the normal force that is carried within the radius r; all of it beyond the contact.

    F_r = sqrt(pi)*E_star*Sum(j*(-2*a**j*sqrt(a**2 - r**2) + 2*a**(j + 1) + r**(j + 1)*IncompleteBeta(1 -
    r**2/a**2, 1/2, (1 - j)/2))*gamma(j/2 + 1)*A[j]/((j + 1)*gamma((j + 1)/2)), (j, 1, N))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    A : sequence of float
        A is the sequence A_1, A_2, ... of coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN field values give NaN. Evaluated as an integral over the growing
    contact by a Gauss-Legendre rule. Handbook: polynomial.Fr.

    References
    ----------
    Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import polynomial
    >>> value = polynomial.load_within(0.3, 1.0, A=(0.1, 0.25, 0.05), E_star=1.0)
    >>> round(value, 6)
    0.138736
    """
    A = require_coefficients(A)
    require(E_star=E_star)
    return elementwise(partial(_load_within, A=A), r, a, E_star=E_star)


def _profile(r: Array, A: tuple[float, ...]) -> Array:
    return sum(r**j * A_j for j, A_j in enumerate(A, 1))


def _slope(a: Array, A: tuple[float, ...]) -> Array:
    """Rate g'(a) of the indentation depth."""
    return sum(j * depth_over_height(j) * a ** (j - 1) * A_j for j, A_j in enumerate(A, 1))


def _depth(a: Array, A: tuple[float, ...]) -> Array:
    return sum(depth_over_height(j) * a**j * A_j for j, A_j in enumerate(A, 1))


def _force(a: Array, A: tuple[float, ...], E_star: Array) -> Array:
    terms = (j * depth_over_height(j) / (j + 1) * a ** (j + 1) * A_j for j, A_j in enumerate(A, 1))
    return 2 * E_star * sum(terms)


def _pressure(r: Array, a: Array, A: tuple[float, ...], E_star: Array) -> Array:
    terms = (
        j * depth_over_height(j) * a ** (j - 1) * power_pressure(r, a, j) * A_j for j, A_j in enumerate(A, 1) if A_j
    )
    return np.where(r < a, E_star / np.pi * sum(terms), 0.0)


def _displacement(r: Array, a: Array, A: tuple[float, ...]) -> Array:
    terms = (depth_over_height(j) * a**j * power_displacement(r, a, j) * A_j for j, A_j in enumerate(A, 1))
    outside = 2 * sum(terms) / np.pi
    inside = _depth(a, A) - _profile(r, A)
    return np.where(r > a, outside, inside)


def _stiffness(a: Array, E_star: Array) -> Array:
    return 2 * E_star * a


def _mean_pressure(a: Array, A: tuple[float, ...], E_star: Array) -> Array:
    terms = (j * depth_over_height(j) / (j + 1) * a ** (j - 1) * A_j for j, A_j in enumerate(A, 1))
    return 2 * E_star / np.pi * sum(terms)


def _energy(a: Array, A: tuple[float, ...], E_star: Array) -> Array:
    sunk = _depth(a, A)
    tip = energy_integral(lambda t: _depth(t, A), (), a, sunk, a)
    return E_star * tip


def _load_within(r: Array, a: Array, A: tuple[float, ...], E_star: Array) -> Array:
    tip = load_within_integral(lambda t: _slope(t, A), (), np.minimum(r, a), a)
    return _force(np.minimum(r, a), A, E_star) + 2 * E_star * tip


def _radius_from_depth(d: Array, A: tuple[float, ...]) -> Array:
    def curve(a: Array) -> tuple[Array, Array]:
        value = _depth(a, A)
        return value, a * _slope(a, A) / value

    alone = (d / depth_over_height(j) / A_j for j, A_j in enumerate(A, 1))
    terms = (np.log(share) / j for j, share in enumerate(alone, 1))
    start = np.exp(reduce(np.minimum, terms))
    return inverse(curve, d, start, (1.0, len(A)), smooth=True)


def _radius_from_force(F: Array, A: tuple[float, ...], E_star: Array) -> Array:
    def curve(a: Array) -> tuple[Array, Array]:
        value = _force(a, A, E_star)
        return value, 2 * E_star * a**2 * _slope(a, A) / value

    alone = ((j + 1) / (2 * E_star * j * depth_over_height(j)) * F / A_j for j, A_j in enumerate(A, 1))
    terms = (np.log(share) / (j + 1) for j, share in enumerate(alone, 1))
    start = np.exp(reduce(np.minimum, terms))
    return inverse(curve, F, start, (2.0, len(A) + 1.0), smooth=True)


def _force_from_depth(d: Array, A: tuple[float, ...], E_star: Array) -> Array:
    a = _radius_from_depth(d, A)
    change = np.where((a > 0.0) & (a < np.inf), 2 * E_star * a * (d - _depth(a, A)), 0.0)
    return _force(a, A, E_star) + change


def _depth_from_force(F: Array, A: tuple[float, ...], E_star: Array) -> Array:
    a = _radius_from_force(F, A, E_star)
    change = np.where((a > 0.0) & (a < np.inf), (F - _force(a, A, E_star)) / (2 * E_star * a), 0.0)
    return _depth(a, A) + change
