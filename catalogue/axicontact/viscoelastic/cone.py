"""Cone on a viscoelastic half-space.

Rigid cone of inclination theta. Self-similar: the mean pressure does not depend on the load.
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
from ..normal import cone as normal

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


def ramp_force_maxwell(t: ArrayLike, *, theta: ArrayLike, v: ArrayLike, E: ArrayLike, tau: ArrayLike) -> Result:
    """Normal force at time t on a Maxwell fluid, indented at the constant speed v.

    F = 2*E*t**2*v**2*1F1(1, 3, -t/tau)/(pi*tan(theta))
    with 1F1: Confluent 1F1(p; c; z)

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body, and while the contact grows. Negative or NaN times give
    NaN. Handbook: cone.vis.ramp_mx.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.ramp_force_maxwell(1.0, theta=0.35, v=0.2, E=1.0, tau=2.0)
    >>> round(value, 6)
    0.059454
    """
    require(theta=theta, v=v, E=E, relaxation=tau)
    return elementwise(_ramp_force_maxwell, t, theta=theta, v=v, E=E, tau=tau)


def step_force_maxwell(t: ArrayLike, *, d: ArrayLike, theta: ArrayLike, E: ArrayLike, tau: ArrayLike) -> Result:
    """Normal force at time t on a Maxwell fluid, held at the indentation depth d from t = 0 on.

    F = 2*E*d**2*exp(-t/tau)/(pi*tan(theta))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body, and while the contact grows. Negative or NaN times give
    NaN. Handbook: cone.vis.step_mx.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.step_force_maxwell(1.0, d=0.2, theta=0.35, E=1.0, tau=2.0)
    >>> round(value, 6)
    0.042312
    """
    require(d=d, theta=theta, E=E, relaxation=tau)
    return elementwise(_step_force_maxwell, t, d=d, theta=theta, E=E, tau=tau)


def step_load_radius_maxwell(t: ArrayLike, *, F: ArrayLike, theta: ArrayLike, E: ArrayLike, tau: ArrayLike) -> Result:
    """Contact radius at time t on a Maxwell fluid, under the constant normal force F from t = 0 on.

    a = sqrt(2)*sqrt(F)*sqrt(1 + t/tau)*sqrt(1/tan(theta))/(sqrt(pi)*sqrt(E))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body, and while the contact grows. Negative or NaN times give
    NaN. Handbook: cone.vis.load_mx.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.step_load_radius_maxwell(1.0, F=0.2, theta=0.35, E=1.0, tau=2.0)
    >>> round(value, 6)
    0.723331
    """
    require(F=F, theta=theta, E=E, relaxation=tau)
    return elementwise(_step_load_radius_maxwell, t, F=F, theta=theta, E=E, tau=tau)


def ramp_force_kelvin_voigt(t: ArrayLike, *, theta: ArrayLike, v: ArrayLike, E: ArrayLike, eta: ArrayLike) -> Result:
    """Normal force at time t on a Kelvin-Voigt solid, indented at the constant speed v.

    F = 2*t**2*v**2*(E + 2*eta/t)/(pi*tan(theta))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body, and while the contact grows. Negative or NaN times give
    NaN. Handbook: cone.vis.ramp_kv.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.ramp_force_kelvin_voigt(1.0, theta=0.35, v=0.2, E=1.0, eta=1.5)
    >>> round(value, 6)
    0.279044
    """
    require(theta=theta, v=v, E=E, eta=eta)
    return elementwise(_ramp_force_kelvin_voigt, t, theta=theta, v=v, E=E, eta=eta)


def step_force_kelvin_voigt(t: ArrayLike, *, d: ArrayLike, theta: ArrayLike, E: ArrayLike, eta: ArrayLike) -> Result:
    """Normal force at time t on a Kelvin-Voigt solid, held at the indentation depth d from t = 0 on.

    F = 2*E*d**2/(pi*tan(theta))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body, and while the contact grows. Negative or NaN times give
    NaN. Handbook: cone.vis.step_kv.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.step_force_kelvin_voigt(1.0, d=0.2, theta=0.35, E=1.0, eta=1.5)
    >>> round(value, 6)
    0.069761
    """
    require(d=d, theta=theta, E=E, eta=eta)
    return elementwise(_step_force_kelvin_voigt, t, d=d, theta=theta, E=E, eta=eta)


def step_load_radius_kelvin_voigt(
    t: ArrayLike, *, F: ArrayLike, theta: ArrayLike, E: ArrayLike, eta: ArrayLike
) -> Result:
    """Contact radius at time t on a Kelvin-Voigt solid, under the constant normal force F from t = 0 on.

    a = sqrt(2)*sqrt(F)*sqrt(1/tan(theta))/(sqrt(pi)*sqrt(E)*sqrt(1/(1 - exp(-E*t/eta))))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body, and while the contact grows. Negative or NaN times give
    NaN. Handbook: cone.vis.load_kv.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.step_load_radius_kelvin_voigt(1.0, F=0.2, theta=0.35, E=1.0, eta=1.5)
    >>> round(value, 6)
    0.411974
    """
    require(F=F, theta=theta, E=E, eta=eta)
    return elementwise(_step_load_radius_kelvin_voigt, t, F=F, theta=theta, E=E, eta=eta)


def ramp_force_standard_solid(
    t: ArrayLike, *, theta: ArrayLike, v: ArrayLike, E_inf: ArrayLike, E_1: ArrayLike, tau: ArrayLike
) -> Result:
    """Normal force at time t on a standard solid, indented at the constant speed v.

    F = 2*t**2*v**2*(E_1*1F1(1, 3, -t/tau) + E_inf)/(pi*tan(theta))
    with 1F1: Confluent 1F1(p; c; z)

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body, and while the contact grows. Negative or NaN times give
    NaN. Handbook: cone.vis.ramp_sls.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.ramp_force_standard_solid(1.0, theta=0.35, v=0.2, E_inf=0.4, E_1=0.6, tau=2.0)
    >>> round(value, 6)
    0.063577
    """
    require(theta=theta, v=v, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(_ramp_force_standard_solid, t, theta=theta, v=v, E_inf=E_inf, E_1=E_1, tau=tau)


def step_force_standard_solid(
    t: ArrayLike, *, d: ArrayLike, theta: ArrayLike, E_inf: ArrayLike, E_1: ArrayLike, tau: ArrayLike
) -> Result:
    """Normal force at time t on a standard solid, held at the indentation depth d from t = 0 on.

    F = 2*d**2*(E_1*exp(-t/tau) + E_inf)/(pi*tan(theta))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body, and while the contact grows. Negative or NaN times give
    NaN. Handbook: cone.vis.step_sls.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.step_force_standard_solid(1.0, d=0.2, theta=0.35, E_inf=0.4, E_1=0.6, tau=2.0)
    >>> round(value, 6)
    0.053292
    """
    require(d=d, theta=theta, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(_step_force_standard_solid, t, d=d, theta=theta, E_inf=E_inf, E_1=E_1, tau=tau)


def step_load_radius_standard_solid(
    t: ArrayLike, *, F: ArrayLike, theta: ArrayLike, E_inf: ArrayLike, E_1: ArrayLike, tau: ArrayLike
) -> Result:
    """Contact radius at time t on a standard solid, under the constant normal force F from t = 0 on.

    a = sqrt(2)*sqrt(F)*sqrt(1/tan(theta))/(sqrt(pi)*sqrt(E_inf)*sqrt(1/(-E_1*exp(-E_inf*t/(tau*(E_1
    + E_inf)))/(E_1 + E_inf) + 1)))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body, and while the contact grows. Negative or NaN times give
    NaN. Handbook: cone.vis.load_sls.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.step_load_radius_standard_solid(1.0, F=0.2, theta=0.35, E_inf=0.4, E_1=0.6, tau=2.0)
    >>> round(value, 6)
    0.666068
    """
    require(F=F, theta=theta, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(_step_load_radius_standard_solid, t, F=F, theta=theta, E_inf=E_inf, E_1=E_1, tau=tau)


def ramp_force_power_creep(
    t: ArrayLike, *, theta: ArrayLike, v: ArrayLike, E: ArrayLike, alpha: ArrayLike, t_0: ArrayLike
) -> Result:
    """Normal force at time t on a material of power-law creep, indented at the constant speed v.

    F = 4*E*t**2*v**2*(t_0/t)**alpha/(pi*tan(theta)*gamma(3 - alpha)*gamma(alpha + 1))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body, and while the contact grows. Negative or NaN times give
    NaN. Handbook: cone.vis.ramp_pc.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.ramp_force_power_creep(1.0, theta=0.35, v=0.2, E=1.0, alpha=0.25, t_0=1.0)
    >>> round(value, 6)
    0.095706
    """
    require(theta=theta, v=v, E=E, alpha=alpha, t_0=t_0)
    return elementwise(_ramp_force_power_creep, t, theta=theta, v=v, E=E, alpha=alpha, t_0=t_0)


def step_force_power_creep(
    t: ArrayLike, *, d: ArrayLike, theta: ArrayLike, E: ArrayLike, alpha: ArrayLike, t_0: ArrayLike
) -> Result:
    """Normal force at time t on a material of power-law creep, held at the indentation depth d from t = 0 on.

    F = 2*E*d**2*(t_0/t)**alpha/(pi*tan(theta)*gamma(1 - alpha)*gamma(alpha + 1))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body, and while the contact grows. Negative or NaN times give
    NaN. Handbook: cone.vis.step_pc.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.step_force_power_creep(1.0, d=0.2, theta=0.35, E=1.0, alpha=0.25, t_0=1.0)
    >>> round(value, 6)
    0.062807
    """
    require(d=d, theta=theta, E=E, alpha=alpha, t_0=t_0)
    return elementwise(_step_force_power_creep, t, d=d, theta=theta, E=E, alpha=alpha, t_0=t_0)


def step_load_radius_power_creep(
    t: ArrayLike, *, F: ArrayLike, theta: ArrayLike, E: ArrayLike, alpha: ArrayLike, t_0: ArrayLike
) -> Result:
    """Contact radius at time t on a material of power-law creep, under the constant normal force F from t = 0 on.

    a = sqrt(2)*sqrt(F)*(t/t_0)**(alpha/2)*sqrt(1/tan(theta))/(sqrt(pi)*sqrt(E))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body, and while the contact grows. Negative or NaN times give
    NaN. Handbook: cone.vis.load_pc.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.step_load_radius_power_creep(1.0, F=0.2, theta=0.35, E=1.0, alpha=0.25, t_0=1.0)
    >>> round(value, 6)
    0.590598
    """
    require(F=F, theta=theta, E=E, alpha=alpha, t_0=t_0)
    return elementwise(_step_load_radius_power_creep, t, F=F, theta=theta, E=E, alpha=alpha, t_0=t_0)


def _ramp_force_maxwell(t: Array, v: Array, theta: Array, E: Array, tau: Array) -> Array:
    force = normal._force_from_depth(v * t, theta, 1.0) * ramp_maxwell(t, 2.0, E, tau)
    return np.where(t == 0.0, 0.0, force)


def _step_force_maxwell(t: Array, d: Array, theta: Array, E: Array, tau: Array) -> Array:
    return relaxation_maxwell(t, E, tau) * normal._force_from_depth(d, theta, 1.0)


def _step_load_radius_maxwell(t: Array, F: Array, theta: Array, E: Array, tau: Array) -> Array:
    return normal._radius_from_force(F * creep_maxwell(t, E, tau), theta, 1.0)


def _ramp_force_kelvin_voigt(t: Array, v: Array, theta: Array, E: Array, eta: Array) -> Array:
    force = normal._force_from_depth(v * t, theta, 1.0) * ramp_kelvin_voigt(t, 2.0, E, eta)
    return np.where(t == 0.0, 0.0, force)


def _step_force_kelvin_voigt(t: Array, d: Array, theta: Array, E: Array, eta: Array) -> Array:
    return relaxation_kelvin_voigt(t, E, eta) * normal._force_from_depth(d, theta, 1.0)


def _step_load_radius_kelvin_voigt(t: Array, F: Array, theta: Array, E: Array, eta: Array) -> Array:
    return normal._radius_from_force(F * creep_kelvin_voigt(t, E, eta), theta, 1.0)


def _ramp_force_standard_solid(t: Array, v: Array, theta: Array, E_inf: Array, E_1: Array, tau: Array) -> Array:
    force = normal._force_from_depth(v * t, theta, 1.0) * ramp_standard_solid(t, 2.0, E_inf, E_1, tau)
    return np.where(t == 0.0, 0.0, force)


def _step_force_standard_solid(t: Array, d: Array, theta: Array, E_inf: Array, E_1: Array, tau: Array) -> Array:
    return relaxation_standard_solid(t, E_inf, E_1, tau) * normal._force_from_depth(d, theta, 1.0)


def _step_load_radius_standard_solid(t: Array, F: Array, theta: Array, E_inf: Array, E_1: Array, tau: Array) -> Array:
    return normal._radius_from_force(F * creep_standard_solid(t, E_inf, E_1, tau), theta, 1.0)


def _ramp_force_power_creep(t: Array, v: Array, theta: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    force = normal._force_from_depth(v * t, theta, 1.0) * ramp_power_creep(t, 2.0, E, alpha, t_0)
    return np.where(t == 0.0, 0.0, force)


def _step_force_power_creep(t: Array, d: Array, theta: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    return relaxation_power_creep(t, E, alpha, t_0) * normal._force_from_depth(d, theta, 1.0)


def _step_load_radius_power_creep(t: Array, F: Array, theta: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    return normal._radius_from_force(F * creep_power_creep(t, E, alpha, t_0), theta, 1.0)
