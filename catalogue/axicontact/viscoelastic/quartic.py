"""Quartic profile on a viscoelastic half-space.

Vanishing curvature at the tip: the pressure has a dip at the centre and its largest value on a ring.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, require
from .._runtime.physics.relaxation import (
    creep_kelvin_voigt,
    creep_maxwell,
    creep_power_creep,
    creep_standard_solid,
    ramp_kelvin_voigt,
    ramp_maxwell,
    ramp_power_creep,
    ramp_standard_solid,
    relaxation_kelvin_voigt,
    relaxation_maxwell,
    relaxation_power_creep,
    relaxation_standard_solid,
)
from ..normal import quartic as normal

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
    "step_load_radius_kelvin_voigt",
    "step_load_radius_maxwell",
    "step_load_radius_power_creep",
    "step_load_radius_standard_solid",
]


def __dir__() -> list[str]:
    return __all__


def ramp_force_maxwell(t: ArrayLike, *, A: ArrayLike, v: ArrayLike, E: ArrayLike, tau: ArrayLike) -> Result:
    """Normal force at time t on a Maxwell fluid, indented at the constant speed v.

    F = 4*6**(1/4)*E*t**(5/4)*v**(5/4)*1F1(1, 9/4, -t/tau)/(5*A**(1/4))
    with 1F1: Confluent 1F1(p; c; z)

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: quartic.vis.ramp_mx.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import quartic
    >>> value = quartic.ramp_force_maxwell(1.0, A=0.4, v=0.2, E=1.0, tau=2.0)
    >>> round(value, 6)
    0.170205
    """
    require(A=A, v=v, E=E, relaxation=tau)
    return elementwise(_ramp_force_maxwell, t, A=A, v=v, E=E, tau=tau)


def step_force_maxwell(t: ArrayLike, *, d: ArrayLike, A: ArrayLike, E: ArrayLike, tau: ArrayLike) -> Result:
    """Normal force at time t on a Maxwell fluid, held at the indentation depth d from t = 0 on.

    F = 4*6**(1/4)*E*d**(5/4)*exp(-t/tau)/(5*A**(1/4))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: quartic.vis.step_mx.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import quartic
    >>> value = quartic.step_force_maxwell(1.0, d=0.2, A=0.4, E=1.0, tau=2.0)
    >>> round(value, 6)
    0.127718
    """
    require(d=d, A=A, E=E, relaxation=tau)
    return elementwise(_step_force_maxwell, t, d=d, A=A, E=E, tau=tau)


def step_load_radius_maxwell(t: ArrayLike, *, F: ArrayLike, A: ArrayLike, E: ArrayLike, tau: ArrayLike) -> Result:
    """Contact radius at time t on a Maxwell fluid, under the constant normal force F from t = 0 on.

    a = 15**(1/5)*2**(4/5)*F**(1/5)*(1 + t/tau)**(1/5)/(4*A**(1/5)*E**(1/5))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: quartic.vis.load_mx.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import quartic
    >>> value = quartic.step_load_radius_maxwell(1.0, F=0.2, A=0.4, E=1.0, tau=2.0)
    >>> round(value, 6)
    0.706309
    """
    require(F=F, A=A, E=E, relaxation=tau)
    return elementwise(_step_load_radius_maxwell, t, F=F, A=A, E=E, tau=tau)


def ramp_force_kelvin_voigt(t: ArrayLike, *, A: ArrayLike, v: ArrayLike, E: ArrayLike, eta: ArrayLike) -> Result:
    """Normal force at time t on a Kelvin-Voigt solid, indented at the constant speed v.

    F = 4*6**(1/4)*t**(5/4)*v**(5/4)*(E + 5*eta/(4*t))/(5*A**(1/4))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: quartic.vis.ramp_kv.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import quartic
    >>> value = quartic.ramp_force_kelvin_voigt(1.0, A=0.4, v=0.2, E=1.0, eta=1.5)
    >>> round(value, 6)
    0.605394
    """
    require(A=A, v=v, E=E, eta=eta)
    return elementwise(_ramp_force_kelvin_voigt, t, A=A, v=v, E=E, eta=eta)


def step_force_kelvin_voigt(t: ArrayLike, *, d: ArrayLike, A: ArrayLike, E: ArrayLike, eta: ArrayLike) -> Result:
    """Normal force at time t on a Kelvin-Voigt solid, held at the indentation depth d from t = 0 on.

    F = 4*6**(1/4)*E*d**(5/4)/(5*A**(1/4))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: quartic.vis.step_kv.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import quartic
    >>> value = quartic.step_force_kelvin_voigt(1.0, d=0.2, A=0.4, E=1.0, eta=1.5)
    >>> round(value, 6)
    0.210572
    """
    require(d=d, A=A, E=E, eta=eta)
    return elementwise(_step_force_kelvin_voigt, t, d=d, A=A, E=E, eta=eta)


def step_load_radius_kelvin_voigt(t: ArrayLike, *, F: ArrayLike, A: ArrayLike, E: ArrayLike, eta: ArrayLike) -> Result:
    """Contact radius at time t on a Kelvin-Voigt solid, under the constant normal force F from t = 0 on.

    a = 15**(1/5)*2**(4/5)*F**(1/5)/(4*A**(1/5)*E**(1/5)*(1/(1 - exp(-E*t/eta)))**(1/5))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: quartic.vis.load_kv.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import quartic
    >>> value = quartic.step_load_radius_kelvin_voigt(1.0, F=0.2, A=0.4, E=1.0, eta=1.5)
    >>> round(value, 6)
    0.563907
    """
    require(F=F, A=A, E=E, eta=eta)
    return elementwise(_step_load_radius_kelvin_voigt, t, F=F, A=A, E=E, eta=eta)


def ramp_force_standard_solid(
    t: ArrayLike, *, A: ArrayLike, v: ArrayLike, E_inf: ArrayLike, E_1: ArrayLike, tau: ArrayLike
) -> Result:
    """Normal force at time t on a standard solid, indented at the constant speed v.

    F = 4*6**(1/4)*t**(5/4)*v**(5/4)*(E_1*1F1(1, 9/4, -t/tau) + E_inf)/(5*A**(1/4))
    with 1F1: Confluent 1F1(p; c; z)

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: quartic.vis.ramp_sls.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import quartic
    >>> value = quartic.ramp_force_standard_solid(1.0, A=0.4, v=0.2, E_inf=0.4, E_1=0.6, tau=2.0)
    >>> round(value, 6)
    0.186352
    """
    require(A=A, v=v, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(_ramp_force_standard_solid, t, A=A, v=v, E_inf=E_inf, E_1=E_1, tau=tau)


def step_force_standard_solid(
    t: ArrayLike, *, d: ArrayLike, A: ArrayLike, E_inf: ArrayLike, E_1: ArrayLike, tau: ArrayLike
) -> Result:
    """Normal force at time t on a standard solid, held at the indentation depth d from t = 0 on.

    F = 4*6**(1/4)*d**(5/4)*(E_1*exp(-t/tau) + E_inf)/(5*A**(1/4))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: quartic.vis.step_sls.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import quartic
    >>> value = quartic.step_force_standard_solid(1.0, d=0.2, A=0.4, E_inf=0.4, E_1=0.6, tau=2.0)
    >>> round(value, 6)
    0.16086
    """
    require(d=d, A=A, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(_step_force_standard_solid, t, d=d, A=A, E_inf=E_inf, E_1=E_1, tau=tau)


def step_load_radius_standard_solid(
    t: ArrayLike, *, F: ArrayLike, A: ArrayLike, E_inf: ArrayLike, E_1: ArrayLike, tau: ArrayLike
) -> Result:
    """Contact radius at time t on a standard solid, under the constant normal force F from t = 0 on.

    a = 15**(1/5)*2**(4/5)*F**(1/5)/(4*A**(1/5)*E_inf**(1/5)*(1/(-E_1*exp(-E_inf*t/(tau*(E_1 +
    E_inf)))/(E_1 + E_inf) + 1))**(1/5))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: quartic.vis.load_sls.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import quartic
    >>> value = quartic.step_load_radius_standard_solid(1.0, F=0.2, A=0.4, E_inf=0.4, E_1=0.6, tau=2.0)
    >>> round(value, 6)
    0.683388
    """
    require(F=F, A=A, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(_step_load_radius_standard_solid, t, F=F, A=A, E_inf=E_inf, E_1=E_1, tau=tau)


def ramp_force_power_creep(
    t: ArrayLike, *, A: ArrayLike, v: ArrayLike, E: ArrayLike, alpha: ArrayLike, t_0: ArrayLike
) -> Result:
    """Normal force at time t on a material of power-law creep, indented at the constant speed v.

    F = 4*6**(1/4)*E*t**(5/4)*v**(5/4)*(t_0/t)**alpha*gamma(9/4)/(5*A**(1/4)*gamma(9/4 -
    alpha)*gamma(alpha + 1))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: quartic.vis.ramp_pc.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import quartic
    >>> value = quartic.ramp_force_power_creep(1.0, A=0.4, v=0.2, E=1.0, alpha=0.25, t_0=1.0)
    >>> round(value, 6)
    0.263215
    """
    require(A=A, v=v, E=E, alpha=alpha, t_0=t_0)
    return elementwise(_ramp_force_power_creep, t, A=A, v=v, E=E, alpha=alpha, t_0=t_0)


def step_force_power_creep(
    t: ArrayLike, *, d: ArrayLike, A: ArrayLike, E: ArrayLike, alpha: ArrayLike, t_0: ArrayLike
) -> Result:
    """Normal force at time t on a material of power-law creep, held at the indentation depth d from t = 0 on.

    F = 4*6**(1/4)*E*d**(5/4)*(t_0/t)**alpha/(5*A**(1/4)*gamma(1 - alpha)*gamma(alpha + 1))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: quartic.vis.step_pc.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import quartic
    >>> value = quartic.step_force_power_creep(1.0, d=0.2, A=0.4, E=1.0, alpha=0.25, t_0=1.0)
    >>> round(value, 6)
    0.189581
    """
    require(d=d, A=A, E=E, alpha=alpha, t_0=t_0)
    return elementwise(_step_force_power_creep, t, d=d, A=A, E=E, alpha=alpha, t_0=t_0)


def step_load_radius_power_creep(
    t: ArrayLike, *, F: ArrayLike, A: ArrayLike, E: ArrayLike, alpha: ArrayLike, t_0: ArrayLike
) -> Result:
    """Contact radius at time t on a material of power-law creep, under the constant normal force F from t = 0 on.

    a = 15**(1/5)*2**(4/5)*F**(1/5)*(t/t_0)**(alpha/5)/(4*A**(1/5)*E**(1/5))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: quartic.vis.load_pc.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import quartic
    >>> value = quartic.step_load_radius_power_creep(1.0, F=0.2, A=0.4, E=1.0, alpha=0.25, t_0=1.0)
    >>> round(value, 6)
    0.651293
    """
    require(F=F, A=A, E=E, alpha=alpha, t_0=t_0)
    return elementwise(_step_load_radius_power_creep, t, F=F, A=A, E=E, alpha=alpha, t_0=t_0)


def _ramp_force_maxwell(t: Array, v: Array, A: Array, E: Array, tau: Array) -> Array:
    force = normal._force_from_depth(v * t, A, 1.0) * ramp_maxwell(t, 1.25, E, tau)
    return np.where(t == 0.0, 0.0, force)


def _step_force_maxwell(t: Array, d: Array, A: Array, E: Array, tau: Array) -> Array:
    return relaxation_maxwell(t, E, tau) * normal._force_from_depth(d, A, 1.0)


def _step_load_radius_maxwell(t: Array, F: Array, A: Array, E: Array, tau: Array) -> Array:
    return normal._radius_from_force(F * creep_maxwell(t, E, tau), A, 1.0)


def _ramp_force_kelvin_voigt(t: Array, v: Array, A: Array, E: Array, eta: Array) -> Array:
    force = normal._force_from_depth(v * t, A, 1.0) * ramp_kelvin_voigt(t, 1.25, E, eta)
    return np.where(t == 0.0, 0.0, force)


def _step_force_kelvin_voigt(t: Array, d: Array, A: Array, E: Array, eta: Array) -> Array:
    return relaxation_kelvin_voigt(t, E, eta) * normal._force_from_depth(d, A, 1.0)


def _step_load_radius_kelvin_voigt(t: Array, F: Array, A: Array, E: Array, eta: Array) -> Array:
    return normal._radius_from_force(F * creep_kelvin_voigt(t, E, eta), A, 1.0)


def _ramp_force_standard_solid(t: Array, v: Array, A: Array, E_inf: Array, E_1: Array, tau: Array) -> Array:
    force = normal._force_from_depth(v * t, A, 1.0) * ramp_standard_solid(t, 1.25, E_inf, E_1, tau)
    return np.where(t == 0.0, 0.0, force)


def _step_force_standard_solid(t: Array, d: Array, A: Array, E_inf: Array, E_1: Array, tau: Array) -> Array:
    return relaxation_standard_solid(t, E_inf, E_1, tau) * normal._force_from_depth(d, A, 1.0)


def _step_load_radius_standard_solid(t: Array, F: Array, A: Array, E_inf: Array, E_1: Array, tau: Array) -> Array:
    return normal._radius_from_force(F * creep_standard_solid(t, E_inf, E_1, tau), A, 1.0)


def _ramp_force_power_creep(t: Array, v: Array, A: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    force = normal._force_from_depth(v * t, A, 1.0) * ramp_power_creep(t, 1.25, E, alpha, t_0)
    return np.where(t == 0.0, 0.0, force)


def _step_force_power_creep(t: Array, d: Array, A: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    return relaxation_power_creep(t, E, alpha, t_0) * normal._force_from_depth(d, A, 1.0)


def _step_load_radius_power_creep(t: Array, F: Array, A: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    return normal._radius_from_force(F * creep_power_creep(t, E, alpha, t_0), A, 1.0)
