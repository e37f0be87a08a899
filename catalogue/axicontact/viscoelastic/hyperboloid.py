"""Hyperboloid of revolution on a viscoelastic half-space.

A cone with a smoothly rounded tip: tip radius b/tan(theta), asymptotic inclination theta.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from .._runtime.interface import Array, Result, elementwise, require
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
from ..normal import hyperboloid as normal

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


def step_force_maxwell(
    t: ArrayLike, *, d: ArrayLike, theta: ArrayLike, b: ArrayLike, E: ArrayLike, tau: ArrayLike
) -> Result:
    """Normal force at time t on a Maxwell fluid, held at the indentation depth d from t = 0 on.

    F from F = E*(a*b + (a - b)*(a + b)*atan(a/b))*exp(-t/tau)*tan(theta)

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1, and while the contact grows. Negative or NaN times give NaN. Here a is the
    contact radius of the elastic contact at the depth d: a from a*tan(theta)*atan(a/b) = d. Handbook:
    hyperboloid.vis.step_mx.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import hyperboloid
    >>> value = hyperboloid.step_force_maxwell(1.0, d=0.2, theta=0.42, b=0.4, E=1.0, tau=2.0)
    >>> round(value, 6)
    0.075969
    """
    require(d=d, theta=theta, b=b, E=E, relaxation=tau)
    return elementwise(_step_force_maxwell, t, d=d, theta=theta, b=b, E=E, tau=tau)


def step_load_radius_maxwell(
    t: ArrayLike, *, F: ArrayLike, theta: ArrayLike, b: ArrayLike, E: ArrayLike, tau: ArrayLike
) -> Result:
    """Contact radius at time t on a Maxwell fluid, under the constant normal force F from t = 0 on.

    a from E*(a*b + (a - b)*(a + b)*atan(a/b))*tan(theta)/(1 + t/tau) = F

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1, and while the contact grows. Negative or NaN times give NaN. Handbook:
    hyperboloid.vis.load_mx.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import hyperboloid
    >>> value = hyperboloid.step_load_radius_maxwell(1.0, F=0.2, theta=0.42, b=0.4, E=1.0, tau=2.0)
    >>> round(value, 6)
    0.721191
    """
    require(F=F, theta=theta, b=b, E=E, relaxation=tau)
    return elementwise(_step_load_radius_maxwell, t, F=F, theta=theta, b=b, E=E, tau=tau)


def step_force_kelvin_voigt(
    t: ArrayLike, *, d: ArrayLike, theta: ArrayLike, b: ArrayLike, E: ArrayLike, eta: ArrayLike
) -> Result:
    """Normal force at time t on a Kelvin-Voigt solid, held at the indentation depth d from t = 0 on.

    F from F = E*(a*b + (a - b)*(a + b)*atan(a/b))*tan(theta)

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1, and while the contact grows. Negative or NaN times give NaN. Here a is the
    contact radius of the elastic contact at the depth d: a from a*tan(theta)*atan(a/b) = d. Handbook:
    hyperboloid.vis.step_kv.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import hyperboloid
    >>> value = hyperboloid.step_force_kelvin_voigt(1.0, d=0.2, theta=0.42, b=0.4, E=1.0, eta=1.5)
    >>> round(value, 6)
    0.125251
    """
    require(d=d, theta=theta, b=b, E=E, eta=eta)
    return elementwise(_step_force_kelvin_voigt, t, d=d, theta=theta, b=b, E=E, eta=eta)


def step_load_radius_kelvin_voigt(
    t: ArrayLike, *, F: ArrayLike, theta: ArrayLike, b: ArrayLike, E: ArrayLike, eta: ArrayLike
) -> Result:
    """Contact radius at time t on a Kelvin-Voigt solid, under the constant normal force F from t = 0 on.

    a from E*(a*b + (a - b)*(a + b)*atan(a/b))*tan(theta)/(1 - exp(-E*t/eta)) = F

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1, and while the contact grows. Negative or NaN times give NaN. Handbook:
    hyperboloid.vis.load_kv.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import hyperboloid
    >>> value = hyperboloid.step_load_radius_kelvin_voigt(1.0, F=0.2, theta=0.42, b=0.4, E=1.0, eta=1.5)
    >>> round(value, 6)
    0.451688
    """
    require(F=F, theta=theta, b=b, E=E, eta=eta)
    return elementwise(_step_load_radius_kelvin_voigt, t, F=F, theta=theta, b=b, E=E, eta=eta)


def step_force_standard_solid(
    t: ArrayLike, *, d: ArrayLike, theta: ArrayLike, b: ArrayLike, E_inf: ArrayLike, E_1: ArrayLike, tau: ArrayLike
) -> Result:
    """Normal force at time t on a standard solid, held at the indentation depth d from t = 0 on.

    F from F = (E_1*exp(-t/tau) + E_inf)*(a*b + (a - b)*(a + b)*atan(a/b))*tan(theta)

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1, and while the contact grows. Negative or NaN times give NaN. Here a is the
    contact radius of the elastic contact at the depth d: a from a*tan(theta)*atan(a/b) = d. Handbook:
    hyperboloid.vis.step_sls.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import hyperboloid
    >>> value = hyperboloid.step_force_standard_solid(1.0, d=0.2, theta=0.42, b=0.4, E_inf=0.4, E_1=0.6, tau=2.0)
    >>> round(value, 6)
    0.095682
    """
    require(d=d, theta=theta, b=b, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(_step_force_standard_solid, t, d=d, theta=theta, b=b, E_inf=E_inf, E_1=E_1, tau=tau)


def step_load_radius_standard_solid(
    t: ArrayLike, *, F: ArrayLike, theta: ArrayLike, b: ArrayLike, E_inf: ArrayLike, E_1: ArrayLike, tau: ArrayLike
) -> Result:
    """Contact radius at time t on a standard solid, under the constant normal force F from t = 0 on.

    a from E_inf*(a*b + (a - b)*(a + b)*atan(a/b))*tan(theta)/(-E_1*exp(-E_inf*t/(tau*(E_1 +
    E_inf)))/(E_1 + E_inf) + 1) = F

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1, and while the contact grows. Negative or NaN times give NaN. Handbook:
    hyperboloid.vis.load_sls.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import hyperboloid
    >>> value = hyperboloid.step_load_radius_standard_solid(
    ...     1.0, F=0.2, theta=0.42, b=0.4, E_inf=0.4, E_1=0.6, tau=2.0
    ... )
    >>> round(value, 6)
    0.671679
    """
    require(F=F, theta=theta, b=b, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(_step_load_radius_standard_solid, t, F=F, theta=theta, b=b, E_inf=E_inf, E_1=E_1, tau=tau)


def step_force_power_creep(
    t: ArrayLike, *, d: ArrayLike, theta: ArrayLike, b: ArrayLike, E: ArrayLike, alpha: ArrayLike, t_0: ArrayLike
) -> Result:
    """Normal force at time t on a material of power-law creep, held at the indentation depth d from t = 0 on.

    F from F = E*(t_0/t)**alpha*(a*b + (a - b)*(a + b)*atan(a/b))*tan(theta)/(gamma(1 - alpha)*gamma(alpha
    + 1))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1, and while the contact grows. Negative or NaN times give NaN. Here a is the
    contact radius of the elastic contact at the depth d: a from a*tan(theta)*atan(a/b) = d. Handbook:
    hyperboloid.vis.step_pc.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import hyperboloid
    >>> value = hyperboloid.step_force_power_creep(1.0, d=0.2, theta=0.42, b=0.4, E=1.0, alpha=0.25, t_0=1.0)
    >>> round(value, 6)
    0.112766
    """
    require(d=d, theta=theta, b=b, E=E, alpha=alpha, t_0=t_0)
    return elementwise(_step_force_power_creep, t, d=d, theta=theta, b=b, E=E, alpha=alpha, t_0=t_0)


def step_load_radius_power_creep(
    t: ArrayLike, *, F: ArrayLike, theta: ArrayLike, b: ArrayLike, E: ArrayLike, alpha: ArrayLike, t_0: ArrayLike
) -> Result:
    """Contact radius at time t on a material of power-law creep, under the constant normal force F from t = 0 on.

    a from E*(a*b + (a - b)*(a + b)*atan(a/b))*tan(theta)/(t/t_0)**alpha = F

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1, and while the contact grows. Negative or NaN times give NaN. Handbook:
    hyperboloid.vis.load_pc.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import hyperboloid
    >>> value = hyperboloid.step_load_radius_power_creep(1.0, F=0.2, theta=0.42, b=0.4, E=1.0, alpha=0.25, t_0=1.0)
    >>> round(value, 6)
    0.606476
    """
    require(F=F, theta=theta, b=b, E=E, alpha=alpha, t_0=t_0)
    return elementwise(_step_load_radius_power_creep, t, F=F, theta=theta, b=b, E=E, alpha=alpha, t_0=t_0)


def _step_force_maxwell(t: Array, d: Array, theta: Array, b: Array, E: Array, tau: Array) -> Array:
    return relaxation_maxwell(t, E, tau) * normal._force_from_depth(d, theta, b, 1.0)


def _step_load_radius_maxwell(t: Array, F: Array, theta: Array, b: Array, E: Array, tau: Array) -> Array:
    return normal._radius_from_force(F * creep_maxwell(t, E, tau), theta, b, 1.0)


def _step_force_kelvin_voigt(t: Array, d: Array, theta: Array, b: Array, E: Array, eta: Array) -> Array:
    return relaxation_kelvin_voigt(t, E, eta) * normal._force_from_depth(d, theta, b, 1.0)


def _step_load_radius_kelvin_voigt(t: Array, F: Array, theta: Array, b: Array, E: Array, eta: Array) -> Array:
    return normal._radius_from_force(F * creep_kelvin_voigt(t, E, eta), theta, b, 1.0)


def _step_force_standard_solid(
    t: Array, d: Array, theta: Array, b: Array, E_inf: Array, E_1: Array, tau: Array
) -> Array:
    return relaxation_standard_solid(t, E_inf, E_1, tau) * normal._force_from_depth(d, theta, b, 1.0)


def _step_load_radius_standard_solid(
    t: Array, F: Array, theta: Array, b: Array, E_inf: Array, E_1: Array, tau: Array
) -> Array:
    return normal._radius_from_force(F * creep_standard_solid(t, E_inf, E_1, tau), theta, b, 1.0)


def _step_force_power_creep(t: Array, d: Array, theta: Array, b: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    return relaxation_power_creep(t, E, alpha, t_0) * normal._force_from_depth(d, theta, b, 1.0)


def _step_load_radius_power_creep(
    t: Array, F: Array, theta: Array, b: Array, E: Array, alpha: Array, t_0: Array
) -> Array:
    return normal._radius_from_force(F * creep_power_creep(t, E, alpha, t_0), theta, b, 1.0)
