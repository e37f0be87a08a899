"""Polynomial on a viscoelastic half-space.

Any sum of integer powers with coefficients A_1 ... A_N >= 0: superposition at a fixed contact radius.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from .._runtime.interface import Array, Result, elementwise, require, require_coefficients
from .._runtime.physics.relaxation import (
    creep_kelvin_voigt,
    creep_maxwell,
    creep_power_creep,
    creep_standard_solid,
    relaxation_kelvin_voigt,
    relaxation_maxwell,
    relaxation_power_creep,
    relaxation_standard_solid,
)
from ..normal import polynomial as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "step_force_kelvin_voigt",
    "step_force_maxwell",
    "step_force_power_creep",
    "step_force_standard_solid",
    "step_load_radius_kelvin_voigt",
    "step_load_radius_maxwell",
    "step_load_radius_power_creep",
    "step_load_radius_standard_solid",
]


def __dir__() -> list[str]:
    return __all__


def step_force_maxwell(t: ArrayLike, *, d: ArrayLike, A: ArrayLike, E: ArrayLike, tau: ArrayLike) -> Result:
    """Normal force at time t on a Maxwell fluid, held at the indentation depth d from t = 0 on.

    F from F = 2*sqrt(pi)*E*exp(-t/tau)*Sum(a**(j + 1)*j*gamma(j/2 + 1)*A[j]/((j + 1)*gamma((j +
    1)/2)), (j, 1, N))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
    E : array_like
        Effective (plane-strain) modulus of the viscoelastic law [Pa], E > 0.
    tau : array_like
        Relaxation time [s], tau > 0.

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
    Valid for small slopes, and while the contact grows. Negative or NaN times give NaN. Here a is the contact
    radius of the elastic contact at the depth d: a from sqrt(pi)*Sum(a**j*gamma(j/2 + 1)*A[j]/gamma((j +
    1)/2), (j, 1, N)) = d. Handbook: polynomial.vis.step_mx.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import polynomial
    >>> value = polynomial.step_force_maxwell(1.0, d=0.2, A=(0.1, 0.25, 0.05), E=1.0, tau=2.0)
    >>> round(value, 6)
    0.070258
    """
    A = require_coefficients(A)
    require(d=d, E=E, relaxation=tau)
    return elementwise(partial(_step_force_maxwell, A=A), t, d=d, E=E, tau=tau)


def step_load_radius_maxwell(t: ArrayLike, *, F: ArrayLike, A: ArrayLike, E: ArrayLike, tau: ArrayLike) -> Result:
    """Contact radius at time t on a Maxwell fluid, under the constant normal force F from t = 0 on.

    a from 2*sqrt(pi)*E*Sum(a**(j + 1)*j*gamma(j/2 + 1)*A[j]/((j + 1)*gamma((j + 1)/2)), (j, 1, N))/(1 +
    t/tau) = F

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
    E : array_like
        Effective (plane-strain) modulus of the viscoelastic law [Pa], E > 0.
    tau : array_like
        Relaxation time [s], tau > 0.

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
    Valid for small slopes, and while the contact grows. Negative or NaN times give NaN. Handbook:
    polynomial.vis.load_mx.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import polynomial
    >>> value = polynomial.step_load_radius_maxwell(1.0, F=0.2, A=(0.1, 0.25, 0.05), E=1.0, tau=2.0)
    >>> round(value, 6)
    0.664941
    """
    A = require_coefficients(A)
    require(F=F, E=E, relaxation=tau)
    return elementwise(partial(_step_load_radius_maxwell, A=A), t, F=F, E=E, tau=tau)


def step_force_kelvin_voigt(t: ArrayLike, *, d: ArrayLike, A: ArrayLike, E: ArrayLike, eta: ArrayLike) -> Result:
    """Normal force at time t on a Kelvin-Voigt solid, held at the indentation depth d from t = 0 on.

    F from F = 2*sqrt(pi)*E*Sum(a**(j + 1)*j*gamma(j/2 + 1)*A[j]/((j + 1)*gamma((j + 1)/2)), (j, 1, N))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
    E : array_like
        Effective (plane-strain) modulus of the viscoelastic law [Pa], E > 0.
    eta : array_like
        Effective viscosity [Pa s], eta > 0.

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
    Valid for small slopes, and while the contact grows. Negative or NaN times give NaN. Here a is the contact
    radius of the elastic contact at the depth d: a from sqrt(pi)*Sum(a**j*gamma(j/2 + 1)*A[j]/gamma((j +
    1)/2), (j, 1, N)) = d. Handbook: polynomial.vis.step_kv.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import polynomial
    >>> value = polynomial.step_force_kelvin_voigt(1.0, d=0.2, A=(0.1, 0.25, 0.05), E=1.0, eta=1.5)
    >>> round(value, 6)
    0.115836
    """
    A = require_coefficients(A)
    require(d=d, E=E, eta=eta)
    return elementwise(partial(_step_force_kelvin_voigt, A=A), t, d=d, E=E, eta=eta)


def step_load_radius_kelvin_voigt(t: ArrayLike, *, F: ArrayLike, A: ArrayLike, E: ArrayLike, eta: ArrayLike) -> Result:
    """Contact radius at time t on a Kelvin-Voigt solid, under the constant normal force F from t = 0 on.

    a from 2*sqrt(pi)*E*Sum(a**(j + 1)*j*gamma(j/2 + 1)*A[j]/((j + 1)*gamma((j + 1)/2)), (j, 1, N))/(1 -
    exp(-E*t/eta)) = F

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
    E : array_like
        Effective (plane-strain) modulus of the viscoelastic law [Pa], E > 0.
    eta : array_like
        Effective viscosity [Pa s], eta > 0.

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
    Valid for small slopes, and while the contact grows. Negative or NaN times give NaN. Handbook:
    polynomial.vis.load_kv.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import polynomial
    >>> value = polynomial.step_load_radius_kelvin_voigt(1.0, F=0.2, A=(0.1, 0.25, 0.05), E=1.0, eta=1.5)
    >>> round(value, 6)
    0.445891
    """
    A = require_coefficients(A)
    require(F=F, E=E, eta=eta)
    return elementwise(partial(_step_load_radius_kelvin_voigt, A=A), t, F=F, E=E, eta=eta)


def step_force_standard_solid(
    t: ArrayLike, *, d: ArrayLike, A: ArrayLike, E_inf: ArrayLike, E_1: ArrayLike, tau: ArrayLike
) -> Result:
    """Normal force at time t on a standard solid, held at the indentation depth d from t = 0 on.

    F from F = 2*sqrt(pi)*(E_1*exp(-t/tau) + E_inf)*Sum(a**(j + 1)*j*gamma(j/2 + 1)*A[j]/((j +
    1)*gamma((j + 1)/2)), (j, 1, N))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
    E_inf : array_like
        Long-time effective modulus [Pa], E_inf > 0.
    E_1 : array_like
        Relaxing part of the effective modulus [Pa], E_1 >= 0.
    tau : array_like
        Relaxation time [s], tau > 0.

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
    Valid for small slopes, and while the contact grows. Negative or NaN times give NaN. Here a is the contact
    radius of the elastic contact at the depth d: a from sqrt(pi)*Sum(a**j*gamma(j/2 + 1)*A[j]/gamma((j +
    1)/2), (j, 1, N)) = d. Handbook: polynomial.vis.step_sls.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import polynomial
    >>> value = polynomial.step_force_standard_solid(1.0, d=0.2, A=(0.1, 0.25, 0.05), E_inf=0.4, E_1=0.6, tau=2.0)
    >>> round(value, 6)
    0.088489
    """
    A = require_coefficients(A)
    require(d=d, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(partial(_step_force_standard_solid, A=A), t, d=d, E_inf=E_inf, E_1=E_1, tau=tau)


def step_load_radius_standard_solid(
    t: ArrayLike, *, F: ArrayLike, A: ArrayLike, E_inf: ArrayLike, E_1: ArrayLike, tau: ArrayLike
) -> Result:
    """Contact radius at time t on a standard solid, under the constant normal force F from t = 0 on.

    a from 2*sqrt(pi)*E_inf*Sum(a**(j + 1)*j*gamma(j/2 + 1)*A[j]/((j + 1)*gamma((j + 1)/2)), (j, 1,
    N))/(-E_1*exp(-E_inf*t/(tau*(E_1 + E_inf)))/(E_1 + E_inf) + 1) = F

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
    E_inf : array_like
        Long-time effective modulus [Pa], E_inf > 0.
    E_1 : array_like
        Relaxing part of the effective modulus [Pa], E_1 >= 0.
    tau : array_like
        Relaxation time [s], tau > 0.

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
    Valid for small slopes, and while the contact grows. Negative or NaN times give NaN. Handbook:
    polynomial.vis.load_sls.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import polynomial
    >>> value = polynomial.step_load_radius_standard_solid(
    ...     1.0, F=0.2, A=(0.1, 0.25, 0.05), E_inf=0.4, E_1=0.6, tau=2.0
    ... )
    >>> round(value, 6)
    0.627853
    """
    A = require_coefficients(A)
    require(F=F, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(partial(_step_load_radius_standard_solid, A=A), t, F=F, E_inf=E_inf, E_1=E_1, tau=tau)


def step_force_power_creep(
    t: ArrayLike, *, d: ArrayLike, A: ArrayLike, E: ArrayLike, alpha: ArrayLike, t_0: ArrayLike
) -> Result:
    """Normal force at time t on a material of power-law creep, held at the indentation depth d from t = 0 on.

    F from F = 2*sqrt(pi)*E*(t_0/t)**alpha*Sum(a**(j + 1)*j*gamma(j/2 + 1)*A[j]/((j + 1)*gamma((j + 1)/2)),
    (j, 1, N))/(gamma(1 - alpha)*gamma(alpha + 1))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
    E : array_like
        Effective (plane-strain) modulus of the viscoelastic law [Pa], E > 0.
    alpha : array_like
        Exponent of power-law creep [1], 0 < alpha < 1.
    t_0 : array_like
        Reference time of power-law creep, J = (t/t_0)^alpha/E [s], t_0 > 0.

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
    Valid for small slopes, and while the contact grows. Negative or NaN times give NaN. Here a is the contact
    radius of the elastic contact at the depth d: a from sqrt(pi)*Sum(a**j*gamma(j/2 + 1)*A[j]/gamma((j +
    1)/2), (j, 1, N)) = d. Handbook: polynomial.vis.step_pc.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import polynomial
    >>> value = polynomial.step_force_power_creep(1.0, d=0.2, A=(0.1, 0.25, 0.05), E=1.0, alpha=0.25, t_0=1.0)
    >>> round(value, 6)
    0.104289
    """
    A = require_coefficients(A)
    require(d=d, E=E, alpha=alpha, t_0=t_0)
    return elementwise(partial(_step_force_power_creep, A=A), t, d=d, E=E, alpha=alpha, t_0=t_0)


def step_load_radius_power_creep(
    t: ArrayLike, *, F: ArrayLike, A: ArrayLike, E: ArrayLike, alpha: ArrayLike, t_0: ArrayLike
) -> Result:
    """Contact radius at time t on a material of power-law creep, under the constant normal force F from t = 0 on.

    a from 2*sqrt(pi)*E*Sum(a**(j + 1)*j*gamma(j/2 + 1)*A[j]/((j + 1)*gamma((j + 1)/2)), (j, 1,
    N))/(t/t_0)**alpha = F

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
    E : array_like
        Effective (plane-strain) modulus of the viscoelastic law [Pa], E > 0.
    alpha : array_like
        Exponent of power-law creep [1], 0 < alpha < 1.
    t_0 : array_like
        Reference time of power-law creep, J = (t/t_0)^alpha/E [s], t_0 > 0.

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
    Valid for small slopes, and while the contact grows. Negative or NaN times give NaN. Handbook:
    polynomial.vis.load_pc.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import polynomial
    >>> value = polynomial.step_load_radius_power_creep(1.0, F=0.2, A=(0.1, 0.25, 0.05), E=1.0, alpha=0.25, t_0=1.0)
    >>> round(value, 6)
    0.57705
    """
    A = require_coefficients(A)
    require(F=F, E=E, alpha=alpha, t_0=t_0)
    return elementwise(partial(_step_load_radius_power_creep, A=A), t, F=F, E=E, alpha=alpha, t_0=t_0)


def _step_force_maxwell(t: Array, d: Array, A: tuple[float, ...], E: Array, tau: Array) -> Array:
    return relaxation_maxwell(t, E, tau) * normal._force_from_depth(d, A, 1.0)


def _step_load_radius_maxwell(t: Array, F: Array, A: tuple[float, ...], E: Array, tau: Array) -> Array:
    return normal._radius_from_force(F * creep_maxwell(t, E, tau), A, 1.0)


def _step_force_kelvin_voigt(t: Array, d: Array, A: tuple[float, ...], E: Array, eta: Array) -> Array:
    return relaxation_kelvin_voigt(t, E, eta) * normal._force_from_depth(d, A, 1.0)


def _step_load_radius_kelvin_voigt(t: Array, F: Array, A: tuple[float, ...], E: Array, eta: Array) -> Array:
    return normal._radius_from_force(F * creep_kelvin_voigt(t, E, eta), A, 1.0)


def _step_force_standard_solid(t: Array, d: Array, A: tuple[float, ...], E_inf: Array, E_1: Array, tau: Array) -> Array:
    return relaxation_standard_solid(t, E_inf, E_1, tau) * normal._force_from_depth(d, A, 1.0)


def _step_load_radius_standard_solid(
    t: Array, F: Array, A: tuple[float, ...], E_inf: Array, E_1: Array, tau: Array
) -> Array:
    return normal._radius_from_force(F * creep_standard_solid(t, E_inf, E_1, tau), A, 1.0)


def _step_force_power_creep(t: Array, d: Array, A: tuple[float, ...], E: Array, alpha: Array, t_0: Array) -> Array:
    return relaxation_power_creep(t, E, alpha, t_0) * normal._force_from_depth(d, A, 1.0)


def _step_load_radius_power_creep(
    t: Array, F: Array, A: tuple[float, ...], E: Array, alpha: Array, t_0: Array
) -> Array:
    return normal._radius_from_force(F * creep_power_creep(t, E, alpha, t_0), A, 1.0)
