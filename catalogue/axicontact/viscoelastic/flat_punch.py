"""Flat punch on a viscoelastic half-space.

The elementary building block: every other contact is a superposition of flat punches.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, require
from .._runtime.physics.relaxation import (
    ramp_kelvin_voigt,
    ramp_maxwell,
    ramp_power_creep,
    ramp_standard_solid,
    relaxation_kelvin_voigt,
    relaxation_maxwell,
    relaxation_power_creep,
    relaxation_standard_solid,
)
from ..normal import flat_punch as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "ramp_force_kelvin_voigt",
    "ramp_force_maxwell",
    "ramp_force_power_creep",
    "ramp_force_standard_solid",
    "step_force_kelvin_voigt",
    "step_force_maxwell",
    "step_force_power_creep",
    "step_force_standard_solid",
]


def __dir__() -> list[str]:
    return __all__


def ramp_force_maxwell(t: ArrayLike, *, a: ArrayLike, v: ArrayLike, E: ArrayLike, tau: ArrayLike) -> Result:
    """Normal force at time t on a Maxwell fluid, indented at the constant speed v.

    F = 2*E*a*t*v*1F1(1, 2, -t/tau)
    with 1F1: Confluent 1F1(p; c; z)

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    a : array_like
        Contact radius [m], a > 0.
    v : array_like
        Speed of indentation, d = v t [m/s], v > 0.
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
    Valid for sharp edge, frictionless, and while the contact grows. Negative or NaN times give NaN. Handbook:
    flat_punch.vis.ramp_mx.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import flat_punch
    >>> value = flat_punch.ramp_force_maxwell(1.0, a=1.0, v=0.2, E=1.0, tau=2.0)
    >>> round(value, 6)
    0.314775
    """
    require(a=a, v=v, E=E, relaxation=tau)
    return elementwise(_ramp_force_maxwell, t, a=a, v=v, E=E, tau=tau)


def step_force_maxwell(t: ArrayLike, *, d: ArrayLike, a: ArrayLike, E: ArrayLike, tau: ArrayLike) -> Result:
    """Normal force at time t on a Maxwell fluid, held at the indentation depth d from t = 0 on.

    F = 2*E*a*d*exp(-t/tau)

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    a : array_like
        Contact radius [m], a > 0.
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
    Valid for sharp edge, frictionless, and while the contact grows. Negative or NaN times give NaN. Handbook:
    flat_punch.vis.step_mx.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import flat_punch
    >>> value = flat_punch.step_force_maxwell(1.0, d=0.25, a=1.0, E=1.0, tau=2.0)
    >>> round(value, 6)
    0.303265
    """
    require(d=d, a=a, E=E, relaxation=tau)
    return elementwise(_step_force_maxwell, t, d=d, a=a, E=E, tau=tau)


def ramp_force_kelvin_voigt(t: ArrayLike, *, a: ArrayLike, v: ArrayLike, E: ArrayLike, eta: ArrayLike) -> Result:
    """Normal force at time t on a Kelvin-Voigt solid, indented at the constant speed v.

    F = 2*a*t*v*(E + eta/t)

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    a : array_like
        Contact radius [m], a > 0.
    v : array_like
        Speed of indentation, d = v t [m/s], v > 0.
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
    Valid for sharp edge, frictionless, and while the contact grows. Negative or NaN times give NaN. Handbook:
    flat_punch.vis.ramp_kv.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import flat_punch
    >>> value = flat_punch.ramp_force_kelvin_voigt(1.0, a=1.0, v=0.2, E=1.0, eta=1.5)
    >>> round(value, 6)
    1.0
    """
    require(a=a, v=v, E=E, eta=eta)
    return elementwise(_ramp_force_kelvin_voigt, t, a=a, v=v, E=E, eta=eta)


def step_force_kelvin_voigt(t: ArrayLike, *, d: ArrayLike, a: ArrayLike, E: ArrayLike, eta: ArrayLike) -> Result:
    """Normal force at time t on a Kelvin-Voigt solid, held at the indentation depth d from t = 0 on.

    F = 2*E*a*d

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    a : array_like
        Contact radius [m], a > 0.
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
    Valid for sharp edge, frictionless, and while the contact grows. Negative or NaN times give NaN. Handbook:
    flat_punch.vis.step_kv.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import flat_punch
    >>> value = flat_punch.step_force_kelvin_voigt(1.0, d=0.25, a=1.0, E=1.0, eta=1.5)
    >>> round(value, 6)
    0.5
    """
    require(d=d, a=a, E=E, eta=eta)
    return elementwise(_step_force_kelvin_voigt, t, d=d, a=a, E=E, eta=eta)


def ramp_force_standard_solid(
    t: ArrayLike, *, a: ArrayLike, v: ArrayLike, E_inf: ArrayLike, E_1: ArrayLike, tau: ArrayLike
) -> Result:
    """Normal force at time t on a standard solid, indented at the constant speed v.

    F = 2*a*t*v*(E_1*1F1(1, 2, -t/tau) + E_inf)
    with 1F1: Confluent 1F1(p; c; z)

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    a : array_like
        Contact radius [m], a > 0.
    v : array_like
        Speed of indentation, d = v t [m/s], v > 0.
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
    Valid for sharp edge, frictionless, and while the contact grows. Negative or NaN times give NaN. Handbook:
    flat_punch.vis.ramp_sls.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import flat_punch
    >>> value = flat_punch.ramp_force_standard_solid(1.0, a=1.0, v=0.2, E_inf=0.4, E_1=0.6, tau=2.0)
    >>> round(value, 6)
    0.348865
    """
    require(a=a, v=v, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(_ramp_force_standard_solid, t, a=a, v=v, E_inf=E_inf, E_1=E_1, tau=tau)


def step_force_standard_solid(
    t: ArrayLike, *, d: ArrayLike, a: ArrayLike, E_inf: ArrayLike, E_1: ArrayLike, tau: ArrayLike
) -> Result:
    """Normal force at time t on a standard solid, held at the indentation depth d from t = 0 on.

    F = 2*a*d*(E_1*exp(-t/tau) + E_inf)

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    a : array_like
        Contact radius [m], a > 0.
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
    Valid for sharp edge, frictionless, and while the contact grows. Negative or NaN times give NaN. Handbook:
    flat_punch.vis.step_sls.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import flat_punch
    >>> value = flat_punch.step_force_standard_solid(1.0, d=0.25, a=1.0, E_inf=0.4, E_1=0.6, tau=2.0)
    >>> round(value, 6)
    0.381959
    """
    require(d=d, a=a, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(_step_force_standard_solid, t, d=d, a=a, E_inf=E_inf, E_1=E_1, tau=tau)


def ramp_force_power_creep(
    t: ArrayLike, *, a: ArrayLike, v: ArrayLike, E: ArrayLike, alpha: ArrayLike, t_0: ArrayLike
) -> Result:
    """Normal force at time t on a material of power-law creep, indented at the constant speed v.

    F = 2*E*a*t*v*(t_0/t)**alpha/(gamma(2 - alpha)*gamma(alpha + 1))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    a : array_like
        Contact radius [m], a > 0.
    v : array_like
        Speed of indentation, d = v t [m/s], v > 0.
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
    Valid for sharp edge, frictionless, and while the contact grows. Negative or NaN times give NaN. Handbook:
    flat_punch.vis.ramp_pc.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import flat_punch
    >>> value = flat_punch.ramp_force_power_creep(1.0, a=1.0, v=0.2, E=1.0, alpha=0.25, t_0=1.0)
    >>> round(value, 6)
    0.480169
    """
    require(a=a, v=v, E=E, alpha=alpha, t_0=t_0)
    return elementwise(_ramp_force_power_creep, t, a=a, v=v, E=E, alpha=alpha, t_0=t_0)


def step_force_power_creep(
    t: ArrayLike, *, d: ArrayLike, a: ArrayLike, E: ArrayLike, alpha: ArrayLike, t_0: ArrayLike
) -> Result:
    """Normal force at time t on a material of power-law creep, held at the indentation depth d from t = 0 on.

    F = 2*E*a*d*(t_0/t)**alpha/(gamma(1 - alpha)*gamma(alpha + 1))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    a : array_like
        Contact radius [m], a > 0.
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
    Valid for sharp edge, frictionless, and while the contact grows. Negative or NaN times give NaN. Handbook:
    flat_punch.vis.step_pc.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import flat_punch
    >>> value = flat_punch.step_force_power_creep(1.0, d=0.25, a=1.0, E=1.0, alpha=0.25, t_0=1.0)
    >>> round(value, 6)
    0.450158
    """
    require(d=d, a=a, E=E, alpha=alpha, t_0=t_0)
    return elementwise(_step_force_power_creep, t, d=d, a=a, E=E, alpha=alpha, t_0=t_0)


def _ramp_force_maxwell(t: Array, v: Array, a: Array, E: Array, tau: Array) -> Array:
    force = normal._force(v * t, a, 1.0) * ramp_maxwell(t, 1.0, E, tau)
    return np.where(t == 0.0, 0.0, force)


def _step_force_maxwell(t: Array, d: Array, a: Array, E: Array, tau: Array) -> Array:
    return relaxation_maxwell(t, E, tau) * normal._force(d, a, 1.0)


def _ramp_force_kelvin_voigt(t: Array, v: Array, a: Array, E: Array, eta: Array) -> Array:
    force = normal._force(v * t, a, 1.0) * ramp_kelvin_voigt(t, 1.0, E, eta)
    # the viscous part of a force that grows in proportion to the depth does not start from zero
    return np.where(t == 0.0, normal._force(v, a, 1.0) * eta, force)


def _step_force_kelvin_voigt(t: Array, d: Array, a: Array, E: Array, eta: Array) -> Array:
    return relaxation_kelvin_voigt(t, E, eta) * normal._force(d, a, 1.0)


def _ramp_force_standard_solid(t: Array, v: Array, a: Array, E_inf: Array, E_1: Array, tau: Array) -> Array:
    force = normal._force(v * t, a, 1.0) * ramp_standard_solid(t, 1.0, E_inf, E_1, tau)
    return np.where(t == 0.0, 0.0, force)


def _step_force_standard_solid(t: Array, d: Array, a: Array, E_inf: Array, E_1: Array, tau: Array) -> Array:
    return relaxation_standard_solid(t, E_inf, E_1, tau) * normal._force(d, a, 1.0)


def _ramp_force_power_creep(t: Array, v: Array, a: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    force = normal._force(v * t, a, 1.0) * ramp_power_creep(t, 1.0, E, alpha, t_0)
    return np.where(t == 0.0, 0.0, force)


def _step_force_power_creep(t: Array, d: Array, a: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    return relaxation_power_creep(t, E, alpha, t_0) * normal._force(d, a, 1.0)
