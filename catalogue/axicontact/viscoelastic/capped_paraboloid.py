"""Paraboloid with a flatter cap on a viscoelastic half-space.

Radius of curvature R1 up to r = b, the smaller R2 beyond: a worn sphere of finite cap curvature.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from .._runtime.interface import Array, Result, elementwise
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
from ..normal import capped_paraboloid as normal

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
    t: ArrayLike, *, d: ArrayLike, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, E: ArrayLike, tau: ArrayLike
) -> Result:
    """Normal force at time t on a Maxwell fluid, held at the indentation depth d from t = 0 on.

    F = Integral(E(-s + t)*Derivative(F(s), s)/E_star, (s, 0, t))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
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
    Valid for a << R2, and while the contact grows. Negative or NaN times give NaN. Handbook:
    capped_paraboloid.vis.step_mx.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.viscoelastic import capped_paraboloid
    >>> value = capped_paraboloid.step_force_maxwell(1.0, d=0.2, R1=4.0, R2=1.0, b=0.5, E=1.0, tau=2.0)
    >>> round(value, 6)
    0.113353
    """
    normal._check(d=d, R1=R1, R2=R2, b=b, E=E, relaxation=tau)
    return elementwise(_step_force_maxwell, t, d=d, R1=R1, R2=R2, b=b, E=E, tau=tau)


def step_load_radius_maxwell(
    t: ArrayLike, *, F: ArrayLike, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, E: ArrayLike, tau: ArrayLike
) -> Result:
    """Contact radius at time t on a Maxwell fluid, under the constant normal force F from t = 0 on.

    a from 4*E*a**3/(3*R1*(1 + t/tau)) = F   for a < b
    a from 2*E*(2*a**3 + (R1 - R2)*sqrt(a**2 - b**2)*(2*a**2 + b**2)/R2)/(3*R1*(1 + t/tau)) = F
    for b < a

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
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
    Valid for a << R2, and while the contact grows. Negative or NaN times give NaN. Handbook:
    capped_paraboloid.vis.load_mx.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.viscoelastic import capped_paraboloid
    >>> value = capped_paraboloid.step_load_radius_maxwell(1.0, F=0.2, R1=4.0, R2=1.0, b=0.5, E=1.0, tau=2.0)
    >>> round(value, 6)
    0.639463
    """
    normal._check(F=F, R1=R1, R2=R2, b=b, E=E, relaxation=tau)
    return elementwise(_step_load_radius_maxwell, t, F=F, R1=R1, R2=R2, b=b, E=E, tau=tau)


def step_force_kelvin_voigt(
    t: ArrayLike, *, d: ArrayLike, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, E: ArrayLike, eta: ArrayLike
) -> Result:
    """Normal force at time t on a Kelvin-Voigt solid, held at the indentation depth d from t = 0 on.

    F = Integral(E(-s + t)*Derivative(F(s), s)/E_star, (s, 0, t))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
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
    Valid for a << R2, and while the contact grows. Negative or NaN times give NaN. Handbook:
    capped_paraboloid.vis.step_kv.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.viscoelastic import capped_paraboloid
    >>> value = capped_paraboloid.step_force_kelvin_voigt(1.0, d=0.2, R1=4.0, R2=1.0, b=0.5, E=1.0, eta=1.5)
    >>> round(value, 6)
    0.186888
    """
    normal._check(d=d, R1=R1, R2=R2, b=b, E=E, eta=eta)
    return elementwise(_step_force_kelvin_voigt, t, d=d, R1=R1, R2=R2, b=b, E=E, eta=eta)


def step_load_radius_kelvin_voigt(
    t: ArrayLike, *, F: ArrayLike, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, E: ArrayLike, eta: ArrayLike
) -> Result:
    """Contact radius at time t on a Kelvin-Voigt solid, under the constant normal force F from t = 0 on.

    a from 4*E*a**3/(3*R1*(1 - exp(-E*t/eta))) = F   for a < b
    a from 2*E*(2*a**3 + (R1 - R2)*sqrt(a**2 - b**2)*(2*a**2 + b**2)/R2)/(3*R1*(1 - exp(-E*t/eta))) = F
    for b < a

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
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
    Valid for a << R2, and while the contact grows. Negative or NaN times give NaN. Handbook:
    capped_paraboloid.vis.load_kv.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.viscoelastic import capped_paraboloid
    >>> value = capped_paraboloid.step_load_radius_kelvin_voigt(1.0, F=0.2, R1=4.0, R2=1.0, b=0.5, E=1.0, eta=1.5)
    >>> round(value, 6)
    0.516832
    """
    normal._check(F=F, R1=R1, R2=R2, b=b, E=E, eta=eta)
    return elementwise(_step_load_radius_kelvin_voigt, t, F=F, R1=R1, R2=R2, b=b, E=E, eta=eta)


def step_force_standard_solid(
    t: ArrayLike,
    *,
    d: ArrayLike,
    R1: ArrayLike,
    R2: ArrayLike,
    b: ArrayLike,
    E_inf: ArrayLike,
    E_1: ArrayLike,
    tau: ArrayLike,
) -> Result:
    """Normal force at time t on a standard solid, held at the indentation depth d from t = 0 on.

    F = Integral(E(-s + t)*Derivative(F(s), s)/E_star, (s, 0, t))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
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
    Valid for a << R2, and while the contact grows. Negative or NaN times give NaN. Handbook:
    capped_paraboloid.vis.step_sls.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.viscoelastic import capped_paraboloid
    >>> value = capped_paraboloid.step_force_standard_solid(
    ...     1.0, d=0.2, R1=4.0, R2=1.0, b=0.5, E_inf=0.4, E_1=0.6, tau=2.0
    ... )
    >>> round(value, 6)
    0.142767
    """
    normal._check(d=d, R1=R1, R2=R2, b=b, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(_step_force_standard_solid, t, d=d, R1=R1, R2=R2, b=b, E_inf=E_inf, E_1=E_1, tau=tau)


def step_load_radius_standard_solid(
    t: ArrayLike,
    *,
    F: ArrayLike,
    R1: ArrayLike,
    R2: ArrayLike,
    b: ArrayLike,
    E_inf: ArrayLike,
    E_1: ArrayLike,
    tau: ArrayLike,
) -> Result:
    """Contact radius at time t on a standard solid, under the constant normal force F from t = 0 on.

    a from 4*E_inf*a**3/(3*R1*(-E_1*exp(-E_inf*t/(tau*(E_1 + E_inf)))/(E_1 + E_inf) + 1)) = F   for
    a < b
    a from 2*E_inf*(2*a**3 + (R1 - R2)*sqrt(a**2 - b**2)*(2*a**2 +
    b**2)/R2)/(3*R1*(-E_1*exp(-E_inf*t/(tau*(E_1 + E_inf)))/(E_1 + E_inf) + 1)) = F   for b < a

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
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
    Valid for a << R2, and while the contact grows. Negative or NaN times give NaN. Handbook:
    capped_paraboloid.vis.load_sls.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.viscoelastic import capped_paraboloid
    >>> value = capped_paraboloid.step_load_radius_standard_solid(
    ...     1.0, F=0.2, R1=4.0, R2=1.0, b=0.5, E_inf=0.4, E_1=0.6, tau=2.0
    ... )
    >>> round(value, 6)
    0.613004
    """
    normal._check(F=F, R1=R1, R2=R2, b=b, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(_step_load_radius_standard_solid, t, F=F, R1=R1, R2=R2, b=b, E_inf=E_inf, E_1=E_1, tau=tau)


def step_force_power_creep(
    t: ArrayLike,
    *,
    d: ArrayLike,
    R1: ArrayLike,
    R2: ArrayLike,
    b: ArrayLike,
    E: ArrayLike,
    alpha: ArrayLike,
    t_0: ArrayLike,
) -> Result:
    """Normal force at time t on a material of power-law creep, held at the indentation depth d from t = 0 on.

    F = Integral(E(-s + t)*Derivative(F(s), s)/E_star, (s, 0, t))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    d : array_like
        Indentation depth of the point r = 0 [m], d >= 0.
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
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
    Valid for a << R2, and while the contact grows. Negative or NaN times give NaN. Handbook:
    capped_paraboloid.vis.step_pc.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.viscoelastic import capped_paraboloid
    >>> value = capped_paraboloid.step_force_power_creep(
    ...     1.0, d=0.2, R1=4.0, R2=1.0, b=0.5, E=1.0, alpha=0.25, t_0=1.0
    ... )
    >>> round(value, 6)
    0.168258
    """
    normal._check(d=d, R1=R1, R2=R2, b=b, E=E, alpha=alpha, t_0=t_0)
    return elementwise(_step_force_power_creep, t, d=d, R1=R1, R2=R2, b=b, E=E, alpha=alpha, t_0=t_0)


def step_load_radius_power_creep(
    t: ArrayLike,
    *,
    F: ArrayLike,
    R1: ArrayLike,
    R2: ArrayLike,
    b: ArrayLike,
    E: ArrayLike,
    alpha: ArrayLike,
    t_0: ArrayLike,
) -> Result:
    """Contact radius at time t on a material of power-law creep, under the constant normal force F from t = 0 on.

    a from 4*E*a**3/(3*R1*(t/t_0)**alpha) = F   for a < b
    a from 2*E*(2*a**3 + (R1 - R2)*sqrt(a**2 - b**2)*(2*a**2 + b**2)/R2)/(3*R1*(t/t_0)**alpha) = F   for b
    < a

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    F : array_like
        Normal force [N], F >= 0.
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
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
    Valid for a << R2, and while the contact grows. Negative or NaN times give NaN. Handbook:
    capped_paraboloid.vis.load_pc.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.viscoelastic import capped_paraboloid
    >>> value = capped_paraboloid.step_load_radius_power_creep(
    ...     1.0, F=0.2, R1=4.0, R2=1.0, b=0.5, E=1.0, alpha=0.25, t_0=1.0
    ... )
    >>> round(value, 6)
    0.579584
    """
    normal._check(F=F, R1=R1, R2=R2, b=b, E=E, alpha=alpha, t_0=t_0)
    return elementwise(_step_load_radius_power_creep, t, F=F, R1=R1, R2=R2, b=b, E=E, alpha=alpha, t_0=t_0)


def _step_force_maxwell(t: Array, d: Array, R1: Array, R2: Array, b: Array, E: Array, tau: Array) -> Array:
    return relaxation_maxwell(t, E, tau) * normal._force_from_depth(d, R1, R2, b, 1.0)


def _step_load_radius_maxwell(t: Array, F: Array, R1: Array, R2: Array, b: Array, E: Array, tau: Array) -> Array:
    return normal._radius_from_force(F * creep_maxwell(t, E, tau), R1, R2, b, 1.0)


def _step_force_kelvin_voigt(t: Array, d: Array, R1: Array, R2: Array, b: Array, E: Array, eta: Array) -> Array:
    return relaxation_kelvin_voigt(t, E, eta) * normal._force_from_depth(d, R1, R2, b, 1.0)


def _step_load_radius_kelvin_voigt(t: Array, F: Array, R1: Array, R2: Array, b: Array, E: Array, eta: Array) -> Array:
    return normal._radius_from_force(F * creep_kelvin_voigt(t, E, eta), R1, R2, b, 1.0)


def _step_force_standard_solid(
    t: Array, d: Array, R1: Array, R2: Array, b: Array, E_inf: Array, E_1: Array, tau: Array
) -> Array:
    return relaxation_standard_solid(t, E_inf, E_1, tau) * normal._force_from_depth(d, R1, R2, b, 1.0)


def _step_load_radius_standard_solid(
    t: Array, F: Array, R1: Array, R2: Array, b: Array, E_inf: Array, E_1: Array, tau: Array
) -> Array:
    return normal._radius_from_force(F * creep_standard_solid(t, E_inf, E_1, tau), R1, R2, b, 1.0)


def _step_force_power_creep(
    t: Array, d: Array, R1: Array, R2: Array, b: Array, E: Array, alpha: Array, t_0: Array
) -> Array:
    return relaxation_power_creep(t, E, alpha, t_0) * normal._force_from_depth(d, R1, R2, b, 1.0)


def _step_load_radius_power_creep(
    t: Array, F: Array, R1: Array, R2: Array, b: Array, E: Array, alpha: Array, t_0: Array
) -> Array:
    return normal._radius_from_force(F * creep_power_creep(t, E, alpha, t_0), R1, R2, b, 1.0)
