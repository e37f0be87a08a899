"""Power law on a viscoelastic half-space.

Every self-similar profile: F ~ d^(1 + 1/n). Cone, paraboloid and quartic are n = 1, 2, 4.
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
from ..normal import power_law as normal

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


def ramp_force_maxwell(
    t: ArrayLike, *, A: ArrayLike, n: ArrayLike, v: ArrayLike, E: ArrayLike, tau: ArrayLike
) -> Result:
    """Normal force at time t on a Maxwell fluid, indented at the constant speed v.

    F = 2*sqrt(pi)*A*E*n*(t*v*gamma((n + 1)/2)/(sqrt(pi)*A*gamma(n/2 + 1)))**((n + 1)/n)*1F1(1, 1 + (n +
    1)/n, -t/tau)*gamma(n/2 + 1)/((n + 1)*gamma((n + 1)/2))
    with 1F1: Confluent 1F1(p; c; z)

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: power_law.vis.ramp_mx.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import power_law
    >>> value = power_law.ramp_force_maxwell(1.0, A=0.45, n=1.5, v=0.2, E=1.0, tau=2.0)
    >>> round(value, 6)
    0.079007
    """
    require(A=A, n=n, v=v, E=E, relaxation=tau)
    return elementwise(_ramp_force_maxwell, t, A=A, n=n, v=v, E=E, tau=tau)


def step_force_maxwell(
    t: ArrayLike, *, d: ArrayLike, A: ArrayLike, n: ArrayLike, E: ArrayLike, tau: ArrayLike
) -> Result:
    """Normal force at time t on a Maxwell fluid, held at the indentation depth d from t = 0 on.

    F = 2*sqrt(pi)*A*E*n*(d*gamma((n + 1)/2)/(sqrt(pi)*A*gamma(n/2 + 1)))**((n +
    1)/n)*exp(-t/tau)*gamma(n/2 + 1)/((n + 1)*gamma((n + 1)/2))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: power_law.vis.step_mx.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import power_law
    >>> value = power_law.step_force_maxwell(1.0, d=0.2, A=0.45, n=1.5, E=1.0, tau=2.0)
    >>> round(value, 6)
    0.057351
    """
    require(d=d, A=A, n=n, E=E, relaxation=tau)
    return elementwise(_step_force_maxwell, t, d=d, A=A, n=n, E=E, tau=tau)


def step_load_radius_maxwell(
    t: ArrayLike, *, F: ArrayLike, A: ArrayLike, n: ArrayLike, E: ArrayLike, tau: ArrayLike
) -> Result:
    """Contact radius at time t on a Maxwell fluid, under the constant normal force F from t = 0 on.

    a = (F*(1 + t/tau)*(n + 1)*gamma((n + 1)/2)/(2*sqrt(pi)*A*E*n*gamma(n/2 + 1)))**(1/(n + 1))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: power_law.vis.load_mx.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import power_law
    >>> value = power_law.step_load_radius_maxwell(1.0, F=0.2, A=0.45, n=1.5, E=1.0, tau=2.0)
    >>> round(value, 6)
    0.625247
    """
    require(F=F, A=A, n=n, E=E, relaxation=tau)
    return elementwise(_step_load_radius_maxwell, t, F=F, A=A, n=n, E=E, tau=tau)


def ramp_force_kelvin_voigt(
    t: ArrayLike, *, A: ArrayLike, n: ArrayLike, v: ArrayLike, E: ArrayLike, eta: ArrayLike
) -> Result:
    """Normal force at time t on a Kelvin-Voigt solid, indented at the constant speed v.

    F = 2*sqrt(pi)*A*n*(t*v*gamma((n + 1)/2)/(sqrt(pi)*A*gamma(n/2 + 1)))**((n + 1)/n)*(E + eta*(n +
    1)/(n*t))*gamma(n/2 + 1)/((n + 1)*gamma((n + 1)/2))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: power_law.vis.ramp_kv.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import power_law
    >>> value = power_law.ramp_force_kelvin_voigt(1.0, A=0.45, n=1.5, v=0.2, E=1.0, eta=1.5)
    >>> round(value, 6)
    0.330947
    """
    require(A=A, n=n, v=v, E=E, eta=eta)
    return elementwise(_ramp_force_kelvin_voigt, t, A=A, n=n, v=v, E=E, eta=eta)


def step_force_kelvin_voigt(
    t: ArrayLike, *, d: ArrayLike, A: ArrayLike, n: ArrayLike, E: ArrayLike, eta: ArrayLike
) -> Result:
    """Normal force at time t on a Kelvin-Voigt solid, held at the indentation depth d from t = 0 on.

    F = 2*sqrt(pi)*A*E*n*(d*gamma((n + 1)/2)/(sqrt(pi)*A*gamma(n/2 + 1)))**((n + 1)/n)*gamma(n/2 + 1)/((n +
    1)*gamma((n + 1)/2))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: power_law.vis.step_kv.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import power_law
    >>> value = power_law.step_force_kelvin_voigt(1.0, d=0.2, A=0.45, n=1.5, E=1.0, eta=1.5)
    >>> round(value, 6)
    0.094556
    """
    require(d=d, A=A, n=n, E=E, eta=eta)
    return elementwise(_step_force_kelvin_voigt, t, d=d, A=A, n=n, E=E, eta=eta)


def step_load_radius_kelvin_voigt(
    t: ArrayLike, *, F: ArrayLike, A: ArrayLike, n: ArrayLike, E: ArrayLike, eta: ArrayLike
) -> Result:
    """Contact radius at time t on a Kelvin-Voigt solid, under the constant normal force F from t = 0 on.

    a = (F*(1 - exp(-E*t/eta))*(n + 1)*gamma((n + 1)/2)/(2*sqrt(pi)*A*E*n*gamma(n/2 + 1)))**(1/(n + 1))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: power_law.vis.load_kv.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import power_law
    >>> value = power_law.step_load_radius_kelvin_voigt(1.0, F=0.2, A=0.45, n=1.5, E=1.0, eta=1.5)
    >>> round(value, 6)
    0.398545
    """
    require(F=F, A=A, n=n, E=E, eta=eta)
    return elementwise(_step_load_radius_kelvin_voigt, t, F=F, A=A, n=n, E=E, eta=eta)


def ramp_force_standard_solid(
    t: ArrayLike, *, A: ArrayLike, n: ArrayLike, v: ArrayLike, E_inf: ArrayLike, E_1: ArrayLike, tau: ArrayLike
) -> Result:
    """Normal force at time t on a standard solid, indented at the constant speed v.

    F = 2*sqrt(pi)*A*n*(t*v*gamma((n + 1)/2)/(sqrt(pi)*A*gamma(n/2 + 1)))**((n + 1)/n)*(E_1*1F1(1, 1 +
    (n + 1)/n, -t/tau) + E_inf)*gamma(n/2 + 1)/((n + 1)*gamma((n + 1)/2))
    with 1F1: Confluent 1F1(p; c; z)

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: power_law.vis.ramp_sls.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import power_law
    >>> value = power_law.ramp_force_standard_solid(1.0, A=0.45, n=1.5, v=0.2, E_inf=0.4, E_1=0.6, tau=2.0)
    >>> round(value, 6)
    0.085227
    """
    require(A=A, n=n, v=v, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(_ramp_force_standard_solid, t, A=A, n=n, v=v, E_inf=E_inf, E_1=E_1, tau=tau)


def step_force_standard_solid(
    t: ArrayLike, *, d: ArrayLike, A: ArrayLike, n: ArrayLike, E_inf: ArrayLike, E_1: ArrayLike, tau: ArrayLike
) -> Result:
    """Normal force at time t on a standard solid, held at the indentation depth d from t = 0 on.

    F = 2*sqrt(pi)*A*n*(d*gamma((n + 1)/2)/(sqrt(pi)*A*gamma(n/2 + 1)))**((n +
    1)/n)*(E_1*exp(-t/tau) + E_inf)*gamma(n/2 + 1)/((n + 1)*gamma((n + 1)/2))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: power_law.vis.step_sls.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import power_law
    >>> value = power_law.step_force_standard_solid(1.0, d=0.2, A=0.45, n=1.5, E_inf=0.4, E_1=0.6, tau=2.0)
    >>> round(value, 6)
    0.072233
    """
    require(d=d, A=A, n=n, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(_step_force_standard_solid, t, d=d, A=A, n=n, E_inf=E_inf, E_1=E_1, tau=tau)


def step_load_radius_standard_solid(
    t: ArrayLike, *, F: ArrayLike, A: ArrayLike, n: ArrayLike, E_inf: ArrayLike, E_1: ArrayLike, tau: ArrayLike
) -> Result:
    """Contact radius at time t on a standard solid, under the constant normal force F from t = 0 on.

    a = (F*(n + 1)*(-E_1*exp(-E_inf*t/(tau*(E_1 + E_inf)))/(E_1 + E_inf) + 1)*gamma((n +
    1)/2)/(2*sqrt(pi)*A*E_inf*n*gamma(n/2 + 1)))**(1/(n + 1))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: power_law.vis.load_sls.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import power_law
    >>> value = power_law.step_load_radius_standard_solid(1.0, F=0.2, A=0.45, n=1.5, E_inf=0.4, E_1=0.6, tau=2.0)
    >>> round(value, 6)
    0.585324
    """
    require(F=F, A=A, n=n, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(_step_load_radius_standard_solid, t, F=F, A=A, n=n, E_inf=E_inf, E_1=E_1, tau=tau)


def ramp_force_power_creep(
    t: ArrayLike, *, A: ArrayLike, n: ArrayLike, v: ArrayLike, E: ArrayLike, alpha: ArrayLike, t_0: ArrayLike
) -> Result:
    """Normal force at time t on a material of power-law creep, indented at the constant speed v.

    F = 2*sqrt(pi)*A*E*n*(t_0/t)**alpha*(t*v*gamma((n + 1)/2)/(sqrt(pi)*A*gamma(n/2 + 1)))**((n +
    1)/n)*gamma(1 + (n + 1)/n)*gamma(n/2 + 1)/((n + 1)*gamma(alpha + 1)*gamma((n + 1)/2)*gamma(-alpha + 1 + (n
    + 1)/n))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: power_law.vis.ramp_pc.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import power_law
    >>> value = power_law.ramp_force_power_creep(1.0, A=0.45, n=1.5, v=0.2, E=1.0, alpha=0.25, t_0=1.0)
    >>> round(value, 6)
    0.124981
    """
    require(A=A, n=n, v=v, E=E, alpha=alpha, t_0=t_0)
    return elementwise(_ramp_force_power_creep, t, A=A, n=n, v=v, E=E, alpha=alpha, t_0=t_0)


def step_force_power_creep(
    t: ArrayLike, *, d: ArrayLike, A: ArrayLike, n: ArrayLike, E: ArrayLike, alpha: ArrayLike, t_0: ArrayLike
) -> Result:
    """Normal force at time t on a material of power-law creep, held at the indentation depth d from t = 0 on.

    F = 2*sqrt(pi)*A*E*n*(t_0/t)**alpha*(d*gamma((n + 1)/2)/(sqrt(pi)*A*gamma(n/2 + 1)))**((n +
    1)/n)*gamma(n/2 + 1)/((n + 1)*gamma(1 - alpha)*gamma(alpha + 1)*gamma((n + 1)/2))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: power_law.vis.step_pc.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import power_law
    >>> value = power_law.step_force_power_creep(1.0, d=0.2, A=0.45, n=1.5, E=1.0, alpha=0.25, t_0=1.0)
    >>> round(value, 6)
    0.085131
    """
    require(d=d, A=A, n=n, E=E, alpha=alpha, t_0=t_0)
    return elementwise(_step_force_power_creep, t, d=d, A=A, n=n, E=E, alpha=alpha, t_0=t_0)


def step_load_radius_power_creep(
    t: ArrayLike, *, F: ArrayLike, A: ArrayLike, n: ArrayLike, E: ArrayLike, alpha: ArrayLike, t_0: ArrayLike
) -> Result:
    """Contact radius at time t on a material of power-law creep, under the constant normal force F from t = 0 on.

    a = (F*(t/t_0)**alpha*(n + 1)*gamma((n + 1)/2)/(2*sqrt(pi)*A*E*n*gamma(n/2 + 1)))**(1/(n + 1))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1, and while the contact grows. Negative or NaN times give NaN.
    Handbook: power_law.vis.load_pc.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import power_law
    >>> value = power_law.step_load_radius_power_creep(1.0, F=0.2, A=0.45, n=1.5, E=1.0, alpha=0.25, t_0=1.0)
    >>> round(value, 6)
    0.531637
    """
    require(F=F, A=A, n=n, E=E, alpha=alpha, t_0=t_0)
    return elementwise(_step_load_radius_power_creep, t, F=F, A=A, n=n, E=E, alpha=alpha, t_0=t_0)


def _ramp_force_maxwell(t: Array, v: Array, A: Array, n: Array, E: Array, tau: Array) -> Array:
    m = (n + 1) / n
    force = normal._force_from_depth(v * t, A, n, 1.0) * ramp_maxwell(t, m, E, tau)
    return np.where(t == 0.0, 0.0, force)


def _step_force_maxwell(t: Array, d: Array, A: Array, n: Array, E: Array, tau: Array) -> Array:
    return relaxation_maxwell(t, E, tau) * normal._force_from_depth(d, A, n, 1.0)


def _step_load_radius_maxwell(t: Array, F: Array, A: Array, n: Array, E: Array, tau: Array) -> Array:
    return normal._radius_from_force(F * creep_maxwell(t, E, tau), A, n, 1.0)


def _ramp_force_kelvin_voigt(t: Array, v: Array, A: Array, n: Array, E: Array, eta: Array) -> Array:
    m = (n + 1) / n
    force = normal._force_from_depth(v * t, A, n, 1.0) * ramp_kelvin_voigt(t, m, E, eta)
    return np.where(t == 0.0, 0.0, force)


def _step_force_kelvin_voigt(t: Array, d: Array, A: Array, n: Array, E: Array, eta: Array) -> Array:
    return relaxation_kelvin_voigt(t, E, eta) * normal._force_from_depth(d, A, n, 1.0)


def _step_load_radius_kelvin_voigt(t: Array, F: Array, A: Array, n: Array, E: Array, eta: Array) -> Array:
    return normal._radius_from_force(F * creep_kelvin_voigt(t, E, eta), A, n, 1.0)


def _ramp_force_standard_solid(t: Array, v: Array, A: Array, n: Array, E_inf: Array, E_1: Array, tau: Array) -> Array:
    m = (n + 1) / n
    force = normal._force_from_depth(v * t, A, n, 1.0) * ramp_standard_solid(t, m, E_inf, E_1, tau)
    return np.where(t == 0.0, 0.0, force)


def _step_force_standard_solid(t: Array, d: Array, A: Array, n: Array, E_inf: Array, E_1: Array, tau: Array) -> Array:
    return relaxation_standard_solid(t, E_inf, E_1, tau) * normal._force_from_depth(d, A, n, 1.0)


def _step_load_radius_standard_solid(
    t: Array, F: Array, A: Array, n: Array, E_inf: Array, E_1: Array, tau: Array
) -> Array:
    return normal._radius_from_force(F * creep_standard_solid(t, E_inf, E_1, tau), A, n, 1.0)


def _ramp_force_power_creep(t: Array, v: Array, A: Array, n: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    m = (n + 1) / n
    force = normal._force_from_depth(v * t, A, n, 1.0) * ramp_power_creep(t, m, E, alpha, t_0)
    return np.where(t == 0.0, 0.0, force)


def _step_force_power_creep(t: Array, d: Array, A: Array, n: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    return relaxation_power_creep(t, E, alpha, t_0) * normal._force_from_depth(d, A, n, 1.0)


def _step_load_radius_power_creep(t: Array, F: Array, A: Array, n: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    return normal._radius_from_force(F * creep_power_creep(t, E, alpha, t_0), A, n, 1.0)
