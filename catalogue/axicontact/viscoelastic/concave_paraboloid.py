"""Concave paraboloid on a viscoelastic half-space.

Concave parabolic face of depth h: the pressure vanishes first at the centre.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from .._runtime.interface import Array, Result, elementwise, require
from .._runtime.physics.relaxation import (
    relaxation_kelvin_voigt,
    relaxation_maxwell,
    relaxation_power_creep,
    relaxation_standard_solid,
)
from ..normal import concave_paraboloid as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["step_force_kelvin_voigt", "step_force_maxwell", "step_force_power_creep", "step_force_standard_solid"]


def __dir__() -> list[str]:
    return __all__


def step_force_maxwell(
    t: ArrayLike, *, d: ArrayLike, a: ArrayLike, h: ArrayLike, E: ArrayLike, tau: ArrayLike
) -> Result:
    """Normal force at time t on a Maxwell fluid, held at the indentation depth d from t = 0 on.

    F = 2*E*a*(d + 2*h/3)*exp(-t/tau)

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
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
    Valid for small slopes; complete contact only, and while the contact grows. Negative or NaN times give
    NaN. Handbook: concave_paraboloid.vis.step_mx.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import concave_paraboloid
    >>> value = concave_paraboloid.step_force_maxwell(1.0, d=0.6, a=1.0, h=0.15, E=1.0, tau=2.0)
    >>> round(value, 6)
    0.849143
    """
    require(d=d, a=a, h=h, E=E, relaxation=tau)
    return elementwise(_step_force_maxwell, t, d=d, a=a, h=h, E=E, tau=tau)


def step_force_kelvin_voigt(
    t: ArrayLike, *, d: ArrayLike, a: ArrayLike, h: ArrayLike, E: ArrayLike, eta: ArrayLike
) -> Result:
    """Normal force at time t on a Kelvin-Voigt solid, held at the indentation depth d from t = 0 on.

    F = 2*E*a*(d + 2*h/3)

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
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
    Valid for small slopes; complete contact only, and while the contact grows. Negative or NaN times give
    NaN. Handbook: concave_paraboloid.vis.step_kv.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import concave_paraboloid
    >>> value = concave_paraboloid.step_force_kelvin_voigt(1.0, d=0.6, a=1.0, h=0.15, E=1.0, eta=1.5)
    >>> round(value, 6)
    1.4
    """
    require(d=d, a=a, h=h, E=E, eta=eta)
    return elementwise(_step_force_kelvin_voigt, t, d=d, a=a, h=h, E=E, eta=eta)


def step_force_standard_solid(
    t: ArrayLike, *, d: ArrayLike, a: ArrayLike, h: ArrayLike, E_inf: ArrayLike, E_1: ArrayLike, tau: ArrayLike
) -> Result:
    """Normal force at time t on a standard solid, held at the indentation depth d from t = 0 on.

    F = 2*a*(d + 2*h/3)*(E_1*exp(-t/tau) + E_inf)

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
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
    Valid for small slopes; complete contact only, and while the contact grows. Negative or NaN times give
    NaN. Handbook: concave_paraboloid.vis.step_sls.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import concave_paraboloid
    >>> value = concave_paraboloid.step_force_standard_solid(1.0, d=0.6, a=1.0, h=0.15, E_inf=0.4, E_1=0.6, tau=2.0)
    >>> round(value, 6)
    1.069486
    """
    require(d=d, a=a, h=h, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(_step_force_standard_solid, t, d=d, a=a, h=h, E_inf=E_inf, E_1=E_1, tau=tau)


def step_force_power_creep(
    t: ArrayLike, *, d: ArrayLike, a: ArrayLike, h: ArrayLike, E: ArrayLike, alpha: ArrayLike, t_0: ArrayLike
) -> Result:
    """Normal force at time t on a material of power-law creep, held at the indentation depth d from t = 0 on.

    F = 2*E*a*(t_0/t)**alpha*(d + 2*h/3)/(gamma(1 - alpha)*gamma(alpha + 1))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
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
    Valid for small slopes; complete contact only, and while the contact grows. Negative or NaN times give
    NaN. Handbook: concave_paraboloid.vis.step_pc.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.viscoelastic import concave_paraboloid
    >>> value = concave_paraboloid.step_force_power_creep(1.0, d=0.6, a=1.0, h=0.15, E=1.0, alpha=0.25, t_0=1.0)
    >>> round(value, 6)
    1.260443
    """
    require(d=d, a=a, h=h, E=E, alpha=alpha, t_0=t_0)
    return elementwise(_step_force_power_creep, t, d=d, a=a, h=h, E=E, alpha=alpha, t_0=t_0)


def _step_force_maxwell(t: Array, d: Array, a: Array, h: Array, E: Array, tau: Array) -> Array:
    return relaxation_maxwell(t, E, tau) * normal._force(d, a, h, 1.0)


def _step_force_kelvin_voigt(t: Array, d: Array, a: Array, h: Array, E: Array, eta: Array) -> Array:
    return relaxation_kelvin_voigt(t, E, eta) * normal._force(d, a, h, 1.0)


def _step_force_standard_solid(t: Array, d: Array, a: Array, h: Array, E_inf: Array, E_1: Array, tau: Array) -> Array:
    return relaxation_standard_solid(t, E_inf, E_1, tau) * normal._force(d, a, h, 1.0)


def _step_force_power_creep(t: Array, d: Array, a: Array, h: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    return relaxation_power_creep(t, E, alpha, t_0) * normal._force(d, a, h, 1.0)
