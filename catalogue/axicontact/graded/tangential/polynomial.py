"""Polynomial under a tangential load on a power-law graded half-space.

Any sum of integer powers with coefficients A_1 ... A_N >= 0: superposition at a fixed contact radius.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.interface import (
    Array,
    Result,
    either,
    elementwise,
    numbers,
    require,
    require_coefficients,
    require_order,
)
from ..._runtime.physics.slip import stick_force
from ..normal import polynomial as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["full_slip_displacement", "stick_radius", "tangential_displacement", "tangential_force", "traction"]


def __dir__() -> list[str]:
    return __all__


def tangential_force(a: ArrayLike, c: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike) -> Result:
    """Tangential force with a stick zone of radius c.

    F_x = mu*(2*H*gamma((k + 1)/2)*Sum(a**(j + k + 1)*j*gamma(j/2 + 1)*A[j]/((j + k + 1)*gamma((j + k +
    1)/2)), (j, 1, N))/(k + 1) - 2*H*gamma((k + 1)/2)*Sum(c**(j + k + 1)*j*gamma(j/2 + 1)*A[j]/((j + k +
    1)*gamma((j + k + 1)/2)), (j, 1, N))/(k + 1))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.
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
    Valid for small slopes; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    polynomial.fgm.tan.F.

    References
    ----------
    chapter 11, equation (11.78); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.tangential import polynomial
    >>> value = polynomial.tangential_force(1.0, 0.6, A=(0.1, 0.25, 0.05), H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.142382
    """
    A = require_coefficients(A)
    require(H=H, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(partial(_tangential_force, A=A), a, c, H=H, k=k, mu=mu)


def traction(
    r: ArrayLike, a: ArrayLike, c: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential traction; zero outside the contact.

    tau = H*mu*gamma((k + 1)/2)*Sum(j*r**(j + k - 1)*IncompleteBeta(1 - r**2/a**2, (k + 1)/2, (-j - k +
    1)/2)*gamma(j/2 + 1)*A[j]/gamma((j + k + 1)/2), (j, 1, N))/(2*pi)   for c < r
    tau = mu*(H*gamma((k + 1)/2)*Sum(j*r**(j + k - 1)*IncompleteBeta(1 - r**2/a**2, (k + 1)/2, (-j - k +
    1)/2)*gamma(j/2 + 1)*A[j]/gamma((j + k + 1)/2), (j, 1, N))/(2*pi) - H*gamma((k + 1)/2)*Sum(j*r**(j + k -
    1)*IncompleteBeta(1 - r**2/c**2, (k + 1)/2, (-j - k + 1)/2)*gamma(j/2 + 1)*A[j]/gamma((j + k + 1)/2), (j,
    1, N))/(2*pi))   for r < c
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
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.
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
    Valid for small slopes; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    polynomial.fgm.tan.tau.

    References
    ----------
    chapter 11, equation (11.79); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.tangential import polynomial
    >>> value = polynomial.traction(0.3, 1.0, 0.6, A=(0.1, 0.25, 0.05), H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.045542
    """
    A = require_coefficients(A)
    require(H=H, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(partial(_traction, A=A), r, a, c, H=H, k=k, mu=mu)


def tangential_displacement(
    a: ArrayLike, c: ArrayLike, *, A: ArrayLike, H: ArrayLike, H_x: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement of the indenter with a stick zone of radius c.

    u_0 = H*mu*(gamma((k + 1)/2)*Sum(a**j*gamma(j/2 + 1)*A[j]/gamma((j + k + 1)/2), (j, 1, N)) - gamma((k +
    1)/2)*Sum(c**j*gamma(j/2 + 1)*A[j]/gamma((j + k + 1)/2), (j, 1, N)))/H_x

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    H_x : array_like
        Tangential foundation modulus, c_T(x) = H_x |x|^k [Pa m^(-k)], H_x > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.
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
    Valid for small slopes; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    polynomial.fgm.tan.u.

    References
    ----------
    chapter 11, equation (11.80); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.tangential import polynomial
    >>> value = polynomial.tangential_displacement(1.0, 0.6, A=(0.1, 0.25, 0.05), H=1.0, H_x=0.8, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.142708
    """
    A = require_coefficients(A)
    require(H=H, H_x=H_x, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(partial(_tangential_displacement, A=A), a, c, H=H, H_x=H_x, k=k, mu=mu)


def stick_radius(F_x: ArrayLike, a: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike) -> Result:
    """Radius of the stick zone under a tangential force; NaN beyond full slip.

    c from mu*(2*H*gamma((k + 1)/2)*Sum(a**(j + k + 1)*j*gamma(j/2 + 1)*A[j]/((j + k + 1)*gamma((j + k +
    1)/2)), (j, 1, N))/(k + 1) - 2*H*gamma((k + 1)/2)*Sum(c**(j + k + 1)*j*gamma(j/2 + 1)*A[j]/((j + k +
    1)*gamma((j + k + 1)/2)), (j, 1, N))/(k + 1)) = F_x

    Parameters
    ----------
    F_x : array_like
        Tangential force [N].
    a : array_like
        Contact radius [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.
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
    Valid for small slopes; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    polynomial.fgm.tan.c.

    References
    ----------
    chapter 11, equation (11.78); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.tangential import polynomial
    >>> value = polynomial.stick_radius(0.1424, 1.0, A=(0.1, 0.25, 0.05), H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.599898
    """
    A = require_coefficients(A)
    require(H=H, k=k, mu=mu)
    return elementwise(partial(_stick_radius, A=A), F_x, a, H=H, k=k, mu=mu)


def full_slip_displacement(
    a: ArrayLike, *, A: ArrayLike, H: ArrayLike, H_x: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement at the onset of full slip.

    u_0 = H*mu*gamma((k + 1)/2)*Sum(a**j*gamma(j/2 + 1)*A[j]/gamma((j + k + 1)/2), (j, 1, N))/H_x

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    H_x : array_like
        Tangential foundation modulus, c_T(x) = H_x |x|^k [Pa m^(-k)], H_x > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.
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
    Valid for small slopes; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    polynomial.fgm.tan.us.

    References
    ----------
    chapter 11, equation (11.80); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.tangential import polynomial
    >>> value = polynomial.full_slip_displacement(1.0, A=(0.1, 0.25, 0.05), H=1.0, H_x=0.8, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.234372
    """
    A = require_coefficients(A)
    require(H=H, H_x=H_x, k=k, mu=mu)
    return elementwise(partial(_full_slip_displacement, A=A), a, H=H, H_x=H_x, k=k, mu=mu)


def _tangential_force(a: Array, c: Array, A: tuple[float, ...], H: Array, k: Array, mu: Array) -> Array:
    from ..._runtime.graded.slip import power_gain

    gain = sum(A_j * power_gain("force", 0.0, c, a, j, k) for j, A_j in enumerate(A, 1))
    return mu * (2.0 * H / (1.0 + k)) * gain


def _traction(r: Array, a: Array, c: Array, A: tuple[float, ...], H: Array, k: Array, mu: Array) -> Array:
    from ..._runtime.graded.slip import power_gain

    def gain() -> Array:
        inside = np.minimum(r, c)
        return sum(A_j * power_gain("pressure", inside, c, a, j, k) for j, A_j in enumerate(A, 1))

    return mu * either(r < c, lambda: H / np.pi * gain(), lambda: normal._pressure(r, a, A, H, k))


def _tangential_displacement(
    a: Array, c: Array, A: tuple[float, ...], H: Array, H_x: Array, k: Array, mu: Array
) -> Array:
    from ..._runtime.graded.slip import power_gain

    gain = sum(A_j * power_gain("depth", 0.0, c, a, j, k) for j, A_j in enumerate(A, 1))
    return mu * (H / H_x) * gain


def _stick_radius(F_x: Array, a: Array, A: tuple[float, ...], H: Array, k: Array, mu: Array) -> Array:
    F = stick_force(normal._force(a, A, H, k), F_x, mu)
    return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force(F, A, H, k))


def _full_slip_displacement(a: Array, A: tuple[float, ...], H: Array, H_x: Array, k: Array, mu: Array) -> Array:
    return mu * (H / H_x) * normal._depth(a, A, k)
