"""Elastic constants.

Effective moduli of two elastic bodies, and of a half-space graded by a power of the depth.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ._runtime.functions import gamma
from ._runtime.interface import Array, Result, elementwise, numbers, require

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["effective_modulus", "effective_shear_modulus", "graded_modulus", "h_N"]


def __dir__() -> list[str]:
    return __all__


def effective_modulus(E_1: ArrayLike, nu_1: ArrayLike, E_2: ArrayLike, nu_2: ArrayLike) -> Result:
    """Effective modulus E_star of two bodies; the modulus of a rigid one is infinite.

    1/E_star = (1 - nu_2**2)/E_2 + (1 - nu_1**2)/E_1

    Parameters
    ----------
    E_1 : array_like
        Young's modulus of the first body [Pa], E_1 > 0.
    nu_1 : array_like
        Poisson ratio of the first body [1], -1 < nu_1 <= 1/2.
    E_2 : array_like
        Young's modulus of the second body [Pa], E_2 > 0.
    nu_2 : array_like
        Poisson ratio of the second body [1], -1 < nu_2 <= 1/2.

    Returns
    -------
    float or ndarray
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa].

    Raises
    ------
    ValueError
        If a parameter is outside its domain.

    Notes
    -----
    Handbook: materials.E_star.

    Examples
    --------
    >>> from axicontact import materials
    >>> value = materials.effective_modulus(1.0, 0.3, 2.0, 0.5)
    >>> round(value, 6)
    0.77821
    """
    _require_bodies(E_1, nu_1, E_2, nu_2)
    return elementwise(_effective_modulus, E_1=E_1, nu_1=nu_1, E_2=E_2, nu_2=nu_2)


def effective_shear_modulus(E_1: ArrayLike, nu_1: ArrayLike, E_2: ArrayLike, nu_2: ArrayLike) -> Result:
    """Effective shear modulus G_star of two bodies; the modulus of a rigid one is infinite.

    1/G_star = (2 - nu_2)*(nu_2 + 1)/(2*E_2) + (2 - nu_1)*(nu_1 + 1)/(2*E_1)

    Parameters
    ----------
    E_1 : array_like
        Young's modulus of the first body [Pa], E_1 > 0.
    nu_1 : array_like
        Poisson ratio of the first body [1], -1 < nu_1 <= 1/2.
    E_2 : array_like
        Young's modulus of the second body [Pa], E_2 > 0.
    nu_2 : array_like
        Poisson ratio of the second body [1], -1 < nu_2 <= 1/2.

    Returns
    -------
    float or ndarray
        Effective shear modulus, 1/G_star = sum (2 - nu_i)/(4 G_i) [Pa].

    Raises
    ------
    ValueError
        If a parameter is outside its domain.

    Notes
    -----
    Handbook: materials.G_star.

    References
    ----------
    chapter 11, equation (11.68).

    Examples
    --------
    >>> from axicontact import materials
    >>> value = materials.effective_shear_modulus(1.0, 0.3, 2.0, 0.5)
    >>> round(value, 6)
    0.5997
    """
    _require_bodies(E_1, nu_1, E_2, nu_2)
    return elementwise(_effective_shear_modulus, E_1=E_1, nu_1=nu_1, E_2=E_2, nu_2=nu_2)


def graded_modulus(E_0: ArrayLike, c_0: ArrayLike, k: ArrayLike, nu: ArrayLike) -> Result:
    """Foundation modulus H of a half-space of modulus E_0 (z/c_0)**k under a rigid indenter.

    H = E_0*h_N/(c_0**k*(1 - nu**2))

    Parameters
    ----------
    E_0 : array_like
        Young's modulus at the depth of reference [Pa], E_0 > 0.
    c_0 : array_like
        Depth of reference of the graded half-space [m], c_0 > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.
    nu : array_like
        Poisson ratio [1], -1 < nu <= 1/2.

    Returns
    -------
    float or ndarray
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)].

    Raises
    ------
    ValueError
        If a parameter is outside its domain.

    Notes
    -----
    Handbook: materials.H.

    References
    ----------
    chapter 11, equation (11.39); chapter 11, equation (11.65).

    Examples
    --------
    >>> from axicontact import materials
    >>> value = materials.graded_modulus(3.0, 2.0, 0.25, 0.3)
    >>> round(value, 6)
    3.294033
    """
    require(E_0=E_0, c_0=c_0, k=k, nu=nu)
    return elementwise(_graded_modulus, E_0=E_0, c_0=c_0, k=k, nu=nu)


def h_N(k: ArrayLike, nu: ArrayLike) -> Result:
    """Factor h_N of a graded half-space, 1 for k = 0.

    h_N = (k + 1)**2*cos(pi*k/2)*gamma(k/2 + 1)**2/(beta*sin(pi*beta/2)*gamma(-beta/2 + k/2 +
    3/2)*gamma(beta/2 + k/2 + 3/2)) with beta = sqrt(k + 1)*sqrt(-k*nu/(1 - nu) + 1)

    Parameters
    ----------
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.
    nu : array_like
        Poisson ratio [1], -1 < nu <= 1/2.

    Returns
    -------
    float or ndarray
        Factor of the graded half-space, 1 for k = 0 [1].

    Raises
    ------
    ValueError
        If a parameter is outside its domain.

    Notes
    -----
    Compared with a numerical solution of the equations of equilibrium of the graded half-space. Handbook:
    materials.h_N.

    References
    ----------
    chapter 11, equation (11.33).

    Examples
    --------
    >>> from axicontact import materials
    >>> value = materials.h_N(0.25, 0.3)
    >>> round(value, 6)
    1.188244
    """
    require(k=k, nu=nu)
    return elementwise(_h_N, k=k, nu=nu)


def _effective_modulus(E_1: Array, nu_1: Array, E_2: Array, nu_2: Array) -> Array:
    compliance = np.divide((1.0 - nu_1) * (1.0 + nu_1), E_1) + np.divide((1.0 - nu_2) * (1.0 + nu_2), E_2)
    return np.divide(1.0, compliance)


def _effective_shear_modulus(E_1: Array, nu_1: Array, E_2: Array, nu_2: Array) -> Array:
    compliance = np.divide((2.0 - nu_1) * (1.0 + nu_1), E_1) + np.divide((2.0 - nu_2) * (1.0 + nu_2), E_2)
    return np.divide(2.0, compliance)


def _graded_modulus(E_0: Array, c_0: Array, k: Array, nu: Array) -> Array:
    return _h_N(k, nu) * E_0 / ((1.0 - nu) * (1.0 + nu) * c_0**k)


def _h_N(k: Array, nu: Array) -> Array:
    beta = np.sqrt((1.0 + k) * ((1.0 - nu) - k * nu) / (1.0 - nu))
    gammas = gamma((3.0 + k + beta) / 2.0) * gamma((3.0 + k - beta) / 2.0)
    # the cosine of pi k/2, without the rounding of pi/2 near k = 1 and k = -1
    cosine = np.sin(np.pi * (1.0 - np.abs(k)) / 2.0)
    punch = ((1.0 + k) * gamma(1.0 + k / 2.0)) ** 2 * cosine
    return punch / (beta * np.sin(np.pi * beta / 2.0) * gammas)


def _require_bodies(E_1: ArrayLike, nu_1: ArrayLike, E_2: ArrayLike, nu_2: ArrayLike) -> None:
    require(young_1=_finite("E_1", E_1), nu_1=nu_1, young_2=_finite("E_2", E_2), nu_2=nu_2)


def _finite(name: str, modulus: ArrayLike) -> Array:
    """A rigid body is allowed: its infinite modulus passes as one."""
    array = numbers(name, modulus)
    return np.where(array == np.inf, 1.0, array)
