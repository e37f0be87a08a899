"""Gaussian bump on a viscoelastic half-space.

A smooth asperity of height h and width s; compact up to the radius of largest depth.
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
from ..normal import gaussian as normal

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
    t: ArrayLike, *, d: ArrayLike, h: ArrayLike, s: ArrayLike, E: ArrayLike, tau: ArrayLike
) -> Result:
    """Normal force at time t on a Maxwell fluid, held at the indentation depth d from t = 0 on.

    F from F = 2*E*h*(-a + (2*a**2 + s**2)*Dawson(a/s)/s)*exp(-t/tau)
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s, and while the contact grows. Negative or NaN times give NaN. Here a is the contact
    radius of the elastic contact at the depth d: a from 2*a*h*Dawson(a/s)/s = d; with Dawson: D(x) =
    exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D. Handbook: gaussian.vis.step_mx.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.viscoelastic import gaussian
    >>> value = gaussian.step_force_maxwell(1.0, d=0.2, h=0.7, s=1.0, E=1.0, tau=2.0)
    >>> round(value, 6)
    0.063033
    """
    require(d=d, h=h, s=s, E=E, relaxation=tau)
    return elementwise(_step_force_maxwell, t, d=d, h=h, s=s, E=E, tau=tau)


def step_load_radius_maxwell(
    t: ArrayLike, *, F: ArrayLike, h: ArrayLike, s: ArrayLike, E: ArrayLike, tau: ArrayLike
) -> Result:
    """Contact radius at time t on a Maxwell fluid, under the constant normal force F from t = 0 on.

    a from 2*E*h*(-a + (2*a**2 + s**2)*Dawson(a/s)/s)/(1 + t/tau) = F
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s, and while the contact grows. Negative or NaN times give NaN. Handbook:
    gaussian.vis.load_mx.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.viscoelastic import gaussian
    >>> value = gaussian.step_load_radius_maxwell(1.0, F=0.2, h=0.7, s=1.0, E=1.0, tau=2.0)
    >>> round(value, 6)
    0.597371
    """
    require(F=F, h=h, s=s, E=E, relaxation=tau)
    return elementwise(_step_load_radius_maxwell, t, F=F, h=h, s=s, E=E, tau=tau)


def step_force_kelvin_voigt(
    t: ArrayLike, *, d: ArrayLike, h: ArrayLike, s: ArrayLike, E: ArrayLike, eta: ArrayLike
) -> Result:
    """Normal force at time t on a Kelvin-Voigt solid, held at the indentation depth d from t = 0 on.

    F from F = 2*E*h*(-a + (2*a**2 + s**2)*Dawson(a/s)/s)
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s, and while the contact grows. Negative or NaN times give NaN. Here a is the contact
    radius of the elastic contact at the depth d: a from 2*a*h*Dawson(a/s)/s = d; with Dawson: D(x) =
    exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D. Handbook: gaussian.vis.step_kv.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.viscoelastic import gaussian
    >>> value = gaussian.step_force_kelvin_voigt(1.0, d=0.2, h=0.7, s=1.0, E=1.0, eta=1.5)
    >>> round(value, 6)
    0.103924
    """
    require(d=d, h=h, s=s, E=E, eta=eta)
    return elementwise(_step_force_kelvin_voigt, t, d=d, h=h, s=s, E=E, eta=eta)


def step_load_radius_kelvin_voigt(
    t: ArrayLike, *, F: ArrayLike, h: ArrayLike, s: ArrayLike, E: ArrayLike, eta: ArrayLike
) -> Result:
    """Contact radius at time t on a Kelvin-Voigt solid, under the constant normal force F from t = 0 on.

    a from 2*E*h*(-a + (2*a**2 + s**2)*Dawson(a/s)/s)/(1 - exp(-E*t/eta)) = F
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s, and while the contact grows. Negative or NaN times give NaN. Handbook:
    gaussian.vis.load_kv.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.viscoelastic import gaussian
    >>> value = gaussian.step_load_radius_kelvin_voigt(1.0, F=0.2, h=0.7, s=1.0, E=1.0, eta=1.5)
    >>> round(value, 6)
    0.388875
    """
    require(F=F, h=h, s=s, E=E, eta=eta)
    return elementwise(_step_load_radius_kelvin_voigt, t, F=F, h=h, s=s, E=E, eta=eta)


def step_force_standard_solid(
    t: ArrayLike, *, d: ArrayLike, h: ArrayLike, s: ArrayLike, E_inf: ArrayLike, E_1: ArrayLike, tau: ArrayLike
) -> Result:
    """Normal force at time t on a standard solid, held at the indentation depth d from t = 0 on.

    F from F = 2*h*(-a + (2*a**2 + s**2)*Dawson(a/s)/s)*(E_1*exp(-t/tau) + E_inf)
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s, and while the contact grows. Negative or NaN times give NaN. Here a is the contact
    radius of the elastic contact at the depth d: a from 2*a*h*Dawson(a/s)/s = d; with Dawson: D(x) =
    exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D. Handbook: gaussian.vis.step_sls.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.viscoelastic import gaussian
    >>> value = gaussian.step_force_standard_solid(1.0, d=0.2, h=0.7, s=1.0, E_inf=0.4, E_1=0.6, tau=2.0)
    >>> round(value, 6)
    0.079389
    """
    require(d=d, h=h, s=s, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(_step_force_standard_solid, t, d=d, h=h, s=s, E_inf=E_inf, E_1=E_1, tau=tau)


def step_load_radius_standard_solid(
    t: ArrayLike, *, F: ArrayLike, h: ArrayLike, s: ArrayLike, E_inf: ArrayLike, E_1: ArrayLike, tau: ArrayLike
) -> Result:
    """Contact radius at time t on a standard solid, under the constant normal force F from t = 0 on.

    a from 2*E_inf*h*(-a + (2*a**2 + s**2)*Dawson(a/s)/s)/(-E_1*exp(-E_inf*t/(tau*(E_1 +
    E_inf)))/(E_1 + E_inf) + 1) = F
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s, and while the contact grows. Negative or NaN times give NaN. Handbook:
    gaussian.vis.load_sls.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.viscoelastic import gaussian
    >>> value = gaussian.step_load_radius_standard_solid(1.0, F=0.2, h=0.7, s=1.0, E_inf=0.4, E_1=0.6, tau=2.0)
    >>> round(value, 6)
    0.558873
    """
    require(F=F, h=h, s=s, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(_step_load_radius_standard_solid, t, F=F, h=h, s=s, E_inf=E_inf, E_1=E_1, tau=tau)


def step_force_power_creep(
    t: ArrayLike, *, d: ArrayLike, h: ArrayLike, s: ArrayLike, E: ArrayLike, alpha: ArrayLike, t_0: ArrayLike
) -> Result:
    """Normal force at time t on a material of power-law creep, held at the indentation depth d from t = 0 on.

    F from F = 2*E*h*(t_0/t)**alpha*(-a + (2*a**2 + s**2)*Dawson(a/s)/s)/(gamma(1 - alpha)*gamma(alpha +
    1))
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s, and while the contact grows. Negative or NaN times give NaN. Here a is the contact
    radius of the elastic contact at the depth d: a from 2*a*h*Dawson(a/s)/s = d; with Dawson: D(x) =
    exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D. Handbook: gaussian.vis.step_pc.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.viscoelastic import gaussian
    >>> value = gaussian.step_force_power_creep(1.0, d=0.2, h=0.7, s=1.0, E=1.0, alpha=0.25, t_0=1.0)
    >>> round(value, 6)
    0.093564
    """
    require(d=d, h=h, s=s, E=E, alpha=alpha, t_0=t_0)
    return elementwise(_step_force_power_creep, t, d=d, h=h, s=s, E=E, alpha=alpha, t_0=t_0)


def step_load_radius_power_creep(
    t: ArrayLike, *, F: ArrayLike, h: ArrayLike, s: ArrayLike, E: ArrayLike, alpha: ArrayLike, t_0: ArrayLike
) -> Result:
    """Contact radius at time t on a material of power-law creep, under the constant normal force F from t = 0 on.

    a from 2*E*h*(-a + (2*a**2 + s**2)*Dawson(a/s)/s)/(t/t_0)**alpha = F
    with Dawson: D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s, and while the contact grows. Negative or NaN times give NaN. Handbook:
    gaussian.vis.load_pc.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.viscoelastic import gaussian
    >>> value = gaussian.step_load_radius_power_creep(1.0, F=0.2, h=0.7, s=1.0, E=1.0, alpha=0.25, t_0=1.0)
    >>> round(value, 6)
    0.508612
    """
    require(F=F, h=h, s=s, E=E, alpha=alpha, t_0=t_0)
    return elementwise(_step_load_radius_power_creep, t, F=F, h=h, s=s, E=E, alpha=alpha, t_0=t_0)


def _step_force_maxwell(t: Array, d: Array, h: Array, s: Array, E: Array, tau: Array) -> Array:
    return relaxation_maxwell(t, E, tau) * normal._force_from_depth(d, h, s, 1.0)


def _step_load_radius_maxwell(t: Array, F: Array, h: Array, s: Array, E: Array, tau: Array) -> Array:
    return normal._radius_from_force(F * creep_maxwell(t, E, tau), h, s, 1.0)


def _step_force_kelvin_voigt(t: Array, d: Array, h: Array, s: Array, E: Array, eta: Array) -> Array:
    return relaxation_kelvin_voigt(t, E, eta) * normal._force_from_depth(d, h, s, 1.0)


def _step_load_radius_kelvin_voigt(t: Array, F: Array, h: Array, s: Array, E: Array, eta: Array) -> Array:
    return normal._radius_from_force(F * creep_kelvin_voigt(t, E, eta), h, s, 1.0)


def _step_force_standard_solid(t: Array, d: Array, h: Array, s: Array, E_inf: Array, E_1: Array, tau: Array) -> Array:
    return relaxation_standard_solid(t, E_inf, E_1, tau) * normal._force_from_depth(d, h, s, 1.0)


def _step_load_radius_standard_solid(
    t: Array, F: Array, h: Array, s: Array, E_inf: Array, E_1: Array, tau: Array
) -> Array:
    return normal._radius_from_force(F * creep_standard_solid(t, E_inf, E_1, tau), h, s, 1.0)


def _step_force_power_creep(t: Array, d: Array, h: Array, s: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    return relaxation_power_creep(t, E, alpha, t_0) * normal._force_from_depth(d, h, s, 1.0)


def _step_load_radius_power_creep(t: Array, F: Array, h: Array, s: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    return normal._radius_from_force(F * creep_power_creep(t, E, alpha, t_0), h, s, 1.0)
