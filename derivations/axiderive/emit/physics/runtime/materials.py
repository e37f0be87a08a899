"""Effective moduli of two elastic bodies, and of a half space graded by a power of the depth."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ._bounds import require_physics
from ._domain import numbers
from ._elementwise import Array, Result, elementwise

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


def effective_modulus(E_1: ArrayLike, nu_1: ArrayLike, E_2: ArrayLike, nu_2: ArrayLike) -> Result:
    """Effective modulus E_star of two bodies.

    1/E_star = (1 - nu_1**2)/E_1 + (1 - nu_2**2)/E_2

    Parameters
    ----------
    E_1, E_2 : array_like
        Young's moduli [Pa], E > 0; infinite for a rigid body.
    nu_1, nu_2 : array_like
        Poisson ratios, -1 < nu <= 1/2.

    Returns
    -------
    float or ndarray
        Effective (plane-strain) modulus [Pa].

    Raises
    ------
    ValueError
        If a parameter is outside its domain.

    Examples
    --------
    >>> from axicontact import materials
    >>> round(materials.effective_modulus(1.0, 0.5, float("inf"), 0.3), 6)
    1.333333
    """
    _require_bodies(E_1, nu_1, E_2, nu_2)
    return elementwise(_effective_modulus, E_1=E_1, nu_1=nu_1, E_2=E_2, nu_2=nu_2)


def effective_shear_modulus(E_1: ArrayLike, nu_1: ArrayLike, E_2: ArrayLike, nu_2: ArrayLike) -> Result:
    """Effective shear modulus G_star of two bodies.

    1/G_star = (2 - nu_1)/(4 G_1) + (2 - nu_2)/(4 G_2), with G = E/(2 (1 + nu))

    Parameters
    ----------
    E_1, E_2 : array_like
        Young's moduli [Pa], E > 0; infinite for a rigid body.
    nu_1, nu_2 : array_like
        Poisson ratios, -1 < nu <= 1/2.

    Returns
    -------
    float or ndarray
        Effective shear modulus [Pa].

    Raises
    ------
    ValueError
        If a parameter is outside its domain.

    Examples
    --------
    >>> from axicontact import materials
    >>> round(materials.effective_shear_modulus(1.0, 0.5, float("inf"), 0.3), 6)
    0.888889
    """
    _require_bodies(E_1, nu_1, E_2, nu_2)
    return elementwise(_effective_shear_modulus, E_1=E_1, nu_1=nu_1, E_2=E_2, nu_2=nu_2)


def graded_modulus(E_0: ArrayLike, c_0: ArrayLike, k: ArrayLike, nu: ArrayLike) -> Result:
    """Foundation modulus H of a half space of modulus E_0 (z/c_0)**k under a rigid indenter.

    H = h_N(k, nu) E_0/((1 - nu**2) c_0**k)

    Parameters
    ----------
    E_0 : array_like
        Young's modulus at the depth c_0 [Pa], E_0 > 0.
    c_0 : array_like
        Depth of reference [m], c_0 > 0.
    k : array_like
        Exponent of grading, -1 < k < 1.
    nu : array_like
        Poisson ratio, -1 < nu <= 1/2.

    Returns
    -------
    float or ndarray
        Foundation modulus [Pa m^(-k)]; E_0/(1 - nu**2) for k = 0.

    Raises
    ------
    ValueError
        If a parameter is outside its domain.

    Examples
    --------
    >>> from axicontact import materials
    >>> round(materials.graded_modulus(3.0, 2.0, 0.0, 0.5), 6)
    4.0
    """
    require_physics(E_0=E_0, c_0=c_0, k=k, nu=nu)
    return elementwise(_graded_modulus, E_0=E_0, c_0=c_0, k=k, nu=nu)


def h_N(k: ArrayLike, nu: ArrayLike) -> Result:
    """The number h_N of a graded half space, 1 for k = 0.

    h_N = 2 (1 + k) cos(pi k/2) Gamma(1 + k/2) / (sqrt(pi) C beta sin(pi beta/2) Gamma((1 + k)/2)),
    beta**2 = (1 + k) (1 - k nu/(1 - nu)),
    C = 2**(1 + k) Gamma((3 + k + beta)/2) Gamma((3 + k - beta)/2) / (pi Gamma(2 + k))

    Parameters
    ----------
    k : array_like
        Exponent of grading, -1 < k < 1.
    nu : array_like
        Poisson ratio, -1 < nu <= 1/2.

    Returns
    -------
    float or ndarray
        The number h_N.

    Raises
    ------
    ValueError
        If a parameter is outside its domain.

    References
    ----------
    Giannakopoulos & Suresh 1997; Lee, Barber & Thouless 2009.

    Examples
    --------
    >>> from axicontact import materials
    >>> round(materials.h_N(0.0, 0.3), 6)
    1.0
    """
    require_physics(k=k, nu=nu)
    return elementwise(_h_N, k=k, nu=nu)


def _require_bodies(E_1: ArrayLike, nu_1: ArrayLike, E_2: ArrayLike, nu_2: ArrayLike) -> None:
    require_physics(E_1=_finite("E_1", E_1), nu_1=nu_1, E_2=_finite("E_2", E_2), nu_2=nu_2)


def _finite(name: str, modulus: ArrayLike) -> Array:
    """A rigid body is allowed: its infinite modulus passes as one."""
    array = numbers(name, modulus)
    return np.where(array == np.inf, 1.0, array)


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
    C = 2.0 ** (1.0 + k) * _gamma((3.0 + k + beta) / 2.0) * _gamma((3.0 + k - beta) / 2.0) / (np.pi * _gamma(2.0 + k))
    punch = 2.0 * (1.0 + k) * np.sin(np.pi * (1.0 - np.abs(k)) / 2.0) * _gamma(1.0 + k / 2.0) / _gamma((1.0 + k) / 2.0)
    return punch / (np.sqrt(np.pi) * C * beta * np.sin(np.pi * beta / 2.0))


def _gamma(x: Array) -> Array:
    return np.vectorize(math.gamma, otypes=[float])(x)
