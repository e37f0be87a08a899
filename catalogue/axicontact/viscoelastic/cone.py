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
from .._runtime.physics.retraction import (
    earlier,
    end_kelvin_voigt,
    end_maxwell,
    end_power_creep,
    end_standard_solid,
    kept_kelvin_voigt,
    kept_maxwell,
    kept_power_creep,
    kept_standard_solid,
    lag_kelvin_voigt,
    lag_maxwell,
    lag_power_creep,
    lag_standard_solid,
    passed,
    require_hold,
)
from ..normal import cone as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "contact_time_kelvin_voigt",
    "contact_time_maxwell",
    "contact_time_power_creep",
    "contact_time_standard_solid",
    "earlier_time_kelvin_voigt",
    "earlier_time_maxwell",
    "earlier_time_power_creep",
    "earlier_time_standard_solid",
    "ramp_force_kelvin_voigt",
    "ramp_force_maxwell",
    "ramp_force_power_creep",
    "ramp_force_standard_solid",
    "retract_force_kelvin_voigt",
    "retract_force_maxwell",
    "retract_force_power_creep",
    "retract_force_standard_solid",
    "retract_radius_kelvin_voigt",
    "retract_radius_maxwell",
    "retract_radius_power_creep",
    "retract_radius_standard_solid",
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


def earlier_time_maxwell(
    t: ArrayLike,
    *,
    v: ArrayLike,
    v_2: ArrayLike,
    t_m: ArrayLike,
    t_h: ArrayLike | None = None,
    E: ArrayLike,
    tau: ArrayLike,
) -> Result:
    """Time before t at which the contact was as large on a Maxwell fluid; zero after its end.

    t_1 = tau*log(1 - v_2*(-exp((t_h - t_m)/tau) + exp((-t_m + t)/tau))/v) + t_m

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    v : array_like
        Speed of indentation, d = v t [m/s], v > 0.
    v_2 : array_like
        Speed of retraction, from t_h on [m/s], v_2 > 0.
    t_m : array_like
        Time at which the indenter stops [s], t_m > 0.
    t_h : array_like, optional
        Time at which the indenter goes back, held at v t_m until then [s], t_h >= t_m; t_m if it is not
        given.
    E : array_like
        Effective (plane-strain) modulus of the viscoelastic law [Pa], E > 0.
    tau : array_like
        Relaxation time [s], tau > 0.

    Returns
    -------
    float or ndarray
        Time before at which the contact was as large [s]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for tan(theta) << 1; a << size of the body, a ramp up to t_m, a depth that is held up to t_h and
    then a constant speed back, so that the contact has one maximum, and no adhesion. Negative or NaN times
    give NaN. Here t_1 is t up to t_m, and t_m while the depth is held. Handbook: cone.vis.earlier_mx.

    References
    ----------
    chapter 11, equation (11.16); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.earlier_time_maxwell(1.0, v=0.2, v_2=0.05, t_m=0.8, t_h=0.9, E=1.0, tau=2.0)
    >>> round(value, 6)
    0.772867
    """
    t_h = require_hold(t_m, t_h)
    require(v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, relaxation=tau)
    return elementwise(_earlier_time_maxwell, t, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, tau=tau)


def contact_time_maxwell(
    *, v: ArrayLike, v_2: ArrayLike, t_m: ArrayLike, t_h: ArrayLike | None = None, E: ArrayLike, tau: ArrayLike
) -> Result:
    """Time at which the contact with a Maxwell fluid ends on the way back.

    t_c = tau*log(v*(exp(t_m/tau) - 1)*exp(-t_h/tau)/v_2 + 1) + t_h

    Parameters
    ----------
    v : array_like
        Speed of indentation, d = v t [m/s], v > 0.
    v_2 : array_like
        Speed of retraction, from t_h on [m/s], v_2 > 0.
    t_m : array_like
        Time at which the indenter stops [s], t_m > 0.
    t_h : array_like, optional
        Time at which the indenter goes back, held at v t_m until then [s], t_h >= t_m; t_m if it is not
        given.
    E : array_like
        Effective (plane-strain) modulus of the viscoelastic law [Pa], E > 0.
    tau : array_like
        Relaxation time [s], tau > 0.

    Returns
    -------
    float or ndarray
        Time at which the contact ends [s]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for tan(theta) << 1; a << size of the body, a ramp up to t_m, a depth that is held up to t_h and
    then a constant speed back, so that the contact has one maximum, and no adhesion. Handbook:
    cone.vis.end_mx.

    References
    ----------
    chapter 11, equation (11.16); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.contact_time_maxwell(v=0.2, v_2=0.05, t_m=0.8, t_h=0.9, E=1.0, tau=2.0)
    >>> round(value, 6)
    2.525772
    """
    t_h = require_hold(t_m, t_h)
    require(v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, relaxation=tau)
    return elementwise(_contact_time_maxwell, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, tau=tau)


def retract_force_maxwell(
    t: ArrayLike,
    *,
    theta: ArrayLike,
    v: ArrayLike,
    v_2: ArrayLike,
    t_m: ArrayLike,
    t_h: ArrayLike | None = None,
    E: ArrayLike,
    tau: ArrayLike,
) -> Result:
    """Normal force at time t on a Maxwell fluid, pressed in at v until t_m, from t_h on back at v_2.

    F = 2*E*t_1**2*v**2*exp((t_1 - t)/tau)*1F1(1, 3, -t_1/tau)/(pi*tan(theta))
    with 1F1: Confluent 1F1(p; c; z)

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    v : array_like
        Speed of indentation, d = v t [m/s], v > 0.
    v_2 : array_like
        Speed of retraction, from t_h on [m/s], v_2 > 0.
    t_m : array_like
        Time at which the indenter stops [s], t_m > 0.
    t_h : array_like, optional
        Time at which the indenter goes back, held at v t_m until then [s], t_h >= t_m; t_m if it is not
        given.
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
    Valid for tan(theta) << 1; a << size of the body, a ramp up to t_m, a depth that is held up to t_h and
    then a constant speed back, so that the contact has one maximum, and no adhesion. Negative or NaN times
    give NaN. Here t_1 is earlier_time_maxwell; up to t_m it is t, and the force that of the ramp. Handbook:
    cone.vis.retract_mx.

    References
    ----------
    chapter 11, equation (11.16); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.retract_force_maxwell(1.0, theta=0.35, v=0.2, v_2=0.05, t_m=0.8, t_h=0.9, E=1.0, tau=2.0)
    >>> round(value, 6)
    0.032834
    """
    t_h = require_hold(t_m, t_h)
    require(theta=theta, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, relaxation=tau)
    return elementwise(_retract_force_maxwell, t, theta=theta, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, tau=tau)


def retract_radius_maxwell(
    t: ArrayLike,
    *,
    theta: ArrayLike,
    v: ArrayLike,
    v_2: ArrayLike,
    t_m: ArrayLike,
    t_h: ArrayLike | None = None,
    E: ArrayLike,
    tau: ArrayLike,
) -> Result:
    """Contact radius at time t on a Maxwell fluid, pressed in at v until t_m, from t_h on back at v_2.

    a = 2*t_1*v/(pi*tan(theta))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    v : array_like
        Speed of indentation, d = v t [m/s], v > 0.
    v_2 : array_like
        Speed of retraction, from t_h on [m/s], v_2 > 0.
    t_m : array_like
        Time at which the indenter stops [s], t_m > 0.
    t_h : array_like, optional
        Time at which the indenter goes back, held at v t_m until then [s], t_h >= t_m; t_m if it is not
        given.
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
    Valid for tan(theta) << 1; a << size of the body, a ramp up to t_m, a depth that is held up to t_h and
    then a constant speed back, so that the contact has one maximum, and no adhesion. Negative or NaN times
    give NaN. Here t_1 is earlier_time_maxwell; up to t_m it is t, and the force that of the ramp. Handbook:
    cone.vis.radius_mx.

    References
    ----------
    chapter 11, equation (11.16); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.retract_radius_maxwell(1.0, theta=0.35, v=0.2, v_2=0.05, t_m=0.8, t_h=0.9, E=1.0, tau=2.0)
    >>> round(value, 6)
    0.26958
    """
    t_h = require_hold(t_m, t_h)
    require(theta=theta, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, relaxation=tau)
    return elementwise(_retract_radius_maxwell, t, theta=theta, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, tau=tau)


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


def earlier_time_kelvin_voigt(
    t: ArrayLike,
    *,
    v: ArrayLike,
    v_2: ArrayLike,
    t_m: ArrayLike,
    t_h: ArrayLike | None = None,
    E: ArrayLike,
    eta: ArrayLike,
) -> Result:
    """Time before t at which the contact was as large on a Kelvin-Voigt solid; zero after its end.

    t_1 = t_m - v_2*(-t_h + t + eta/E)/v

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    v : array_like
        Speed of indentation, d = v t [m/s], v > 0.
    v_2 : array_like
        Speed of retraction, from t_h on [m/s], v_2 > 0.
    t_m : array_like
        Time at which the indenter stops [s], t_m > 0.
    t_h : array_like, optional
        Time at which the indenter goes back, held at v t_m until then [s], t_h >= t_m; t_m if it is not
        given.
    E : array_like
        Effective (plane-strain) modulus of the viscoelastic law [Pa], E > 0.
    eta : array_like
        Effective viscosity [Pa s], eta > 0.

    Returns
    -------
    float or ndarray
        Time before at which the contact was as large [s]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for tan(theta) << 1; a << size of the body, a ramp up to t_m, a depth that is held up to t_h and
    then a constant speed back, so that the contact has one maximum, and no adhesion. Negative or NaN times
    give NaN. Here t_1 is t up to t_m, and t_m while the depth is held. Handbook: cone.vis.earlier_kv.

    References
    ----------
    chapter 11, equation (11.16); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.earlier_time_kelvin_voigt(1.0, v=0.2, v_2=0.05, t_m=0.8, t_h=0.9, E=1.0, eta=1.5)
    >>> round(value, 6)
    0.4
    """
    t_h = require_hold(t_m, t_h)
    require(v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, eta=eta)
    return elementwise(_earlier_time_kelvin_voigt, t, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, eta=eta)


def contact_time_kelvin_voigt(
    *, v: ArrayLike, v_2: ArrayLike, t_m: ArrayLike, t_h: ArrayLike | None = None, E: ArrayLike, eta: ArrayLike
) -> Result:
    """Time at which the contact with a Kelvin-Voigt solid ends on the way back.

    t_c = t_h + t_m*v/v_2 - eta/E

    Parameters
    ----------
    v : array_like
        Speed of indentation, d = v t [m/s], v > 0.
    v_2 : array_like
        Speed of retraction, from t_h on [m/s], v_2 > 0.
    t_m : array_like
        Time at which the indenter stops [s], t_m > 0.
    t_h : array_like, optional
        Time at which the indenter goes back, held at v t_m until then [s], t_h >= t_m; t_m if it is not
        given.
    E : array_like
        Effective (plane-strain) modulus of the viscoelastic law [Pa], E > 0.
    eta : array_like
        Effective viscosity [Pa s], eta > 0.

    Returns
    -------
    float or ndarray
        Time at which the contact ends [s]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for tan(theta) << 1; a << size of the body, a ramp up to t_m, a depth that is held up to t_h and
    then a constant speed back, so that the contact has one maximum, and no adhesion. Handbook:
    cone.vis.end_kv.

    References
    ----------
    chapter 11, equation (11.16); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.contact_time_kelvin_voigt(v=0.2, v_2=0.05, t_m=0.8, t_h=0.9, E=1.0, eta=1.5)
    >>> round(value, 6)
    2.6
    """
    t_h = require_hold(t_m, t_h)
    require(v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, eta=eta)
    return elementwise(_contact_time_kelvin_voigt, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, eta=eta)


def retract_force_kelvin_voigt(
    t: ArrayLike,
    *,
    theta: ArrayLike,
    v: ArrayLike,
    v_2: ArrayLike,
    t_m: ArrayLike,
    t_h: ArrayLike | None = None,
    E: ArrayLike,
    eta: ArrayLike,
) -> Result:
    """Normal force at time t on a Kelvin-Voigt solid, pressed in at v until t_m, from t_h on back at v_2.

    F = 2*E*t_1**2*v**2/(pi*tan(theta))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    v : array_like
        Speed of indentation, d = v t [m/s], v > 0.
    v_2 : array_like
        Speed of retraction, from t_h on [m/s], v_2 > 0.
    t_m : array_like
        Time at which the indenter stops [s], t_m > 0.
    t_h : array_like, optional
        Time at which the indenter goes back, held at v t_m until then [s], t_h >= t_m; t_m if it is not
        given.
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
    Valid for tan(theta) << 1; a << size of the body, a ramp up to t_m, a depth that is held up to t_h and
    then a constant speed back, so that the contact has one maximum, and no adhesion. Negative or NaN times
    give NaN. Here t_1 is earlier_time_kelvin_voigt; up to t_m it is t, and the force that of the ramp.
    Handbook: cone.vis.retract_kv.

    References
    ----------
    chapter 11, equation (11.16); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.retract_force_kelvin_voigt(1.0, theta=0.35, v=0.2, v_2=0.05, t_m=0.8, t_h=0.9, E=1.0, eta=1.5)
    >>> round(value, 6)
    0.011162
    """
    t_h = require_hold(t_m, t_h)
    require(theta=theta, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, eta=eta)
    return elementwise(_retract_force_kelvin_voigt, t, theta=theta, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, eta=eta)


def retract_radius_kelvin_voigt(
    t: ArrayLike,
    *,
    theta: ArrayLike,
    v: ArrayLike,
    v_2: ArrayLike,
    t_m: ArrayLike,
    t_h: ArrayLike | None = None,
    E: ArrayLike,
    eta: ArrayLike,
) -> Result:
    """Contact radius at time t on a Kelvin-Voigt solid, pressed in at v until t_m, from t_h on back at v_2.

    a = 2*t_1*v/(pi*tan(theta))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    v : array_like
        Speed of indentation, d = v t [m/s], v > 0.
    v_2 : array_like
        Speed of retraction, from t_h on [m/s], v_2 > 0.
    t_m : array_like
        Time at which the indenter stops [s], t_m > 0.
    t_h : array_like, optional
        Time at which the indenter goes back, held at v t_m until then [s], t_h >= t_m; t_m if it is not
        given.
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
    Valid for tan(theta) << 1; a << size of the body, a ramp up to t_m, a depth that is held up to t_h and
    then a constant speed back, so that the contact has one maximum, and no adhesion. Negative or NaN times
    give NaN. Here t_1 is earlier_time_kelvin_voigt; up to t_m it is t, and the force that of the ramp.
    Handbook: cone.vis.radius_kv.

    References
    ----------
    chapter 11, equation (11.16); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.retract_radius_kelvin_voigt(1.0, theta=0.35, v=0.2, v_2=0.05, t_m=0.8, t_h=0.9, E=1.0, eta=1.5)
    >>> round(value, 6)
    0.139522
    """
    t_h = require_hold(t_m, t_h)
    require(theta=theta, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, eta=eta)
    return elementwise(_retract_radius_kelvin_voigt, t, theta=theta, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, eta=eta)


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


def earlier_time_standard_solid(
    t: ArrayLike,
    *,
    v: ArrayLike,
    v_2: ArrayLike,
    t_m: ArrayLike,
    t_h: ArrayLike | None = None,
    E_inf: ArrayLike,
    E_1: ArrayLike,
    tau: ArrayLike,
) -> Result:
    """Time before t at which the contact was as large on a standard solid; zero after its end.

    t_1 from E_1*tau*(1 - exp(-(-t_1 + t)/tau)) + E_inf*(-t_1 + t) = E_1*tau*(1 -
    exp(-(-t_m + t)/tau)) + E_inf*(-t_m + t) + v_2*(E_1*tau*(1 - exp(-(-t_h +
    t)/tau)) + E_inf*(-t_h + t))/v

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    v : array_like
        Speed of indentation, d = v t [m/s], v > 0.
    v_2 : array_like
        Speed of retraction, from t_h on [m/s], v_2 > 0.
    t_m : array_like
        Time at which the indenter stops [s], t_m > 0.
    t_h : array_like, optional
        Time at which the indenter goes back, held at v t_m until then [s], t_h >= t_m; t_m if it is not
        given.
    E_inf : array_like
        Long-time effective modulus [Pa], E_inf > 0.
    E_1 : array_like
        Relaxing part of the effective modulus [Pa], E_1 >= 0.
    tau : array_like
        Relaxation time [s], tau > 0.

    Returns
    -------
    float or ndarray
        Time before at which the contact was as large [s]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for tan(theta) << 1; a << size of the body, a ramp up to t_m, a depth that is held up to t_h and
    then a constant speed back, so that the contact has one maximum, and no adhesion. Negative or NaN times
    give NaN. Here t_1 is t up to t_m, and t_m while the depth is held. Handbook: cone.vis.earlier_sls.

    References
    ----------
    chapter 11, equation (11.16); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.earlier_time_standard_solid(
    ...     1.0, v=0.2, v_2=0.05, t_m=0.8, t_h=0.9, E_inf=0.4, E_1=0.6, tau=2.0
    ... )
    >>> round(value, 6)
    0.773779
    """
    t_h = require_hold(t_m, t_h)
    require(v=v, v_2=v_2, t_m=t_m, t_h=t_h, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(_earlier_time_standard_solid, t, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E_inf=E_inf, E_1=E_1, tau=tau)


def contact_time_standard_solid(
    *,
    v: ArrayLike,
    v_2: ArrayLike,
    t_m: ArrayLike,
    t_h: ArrayLike | None = None,
    E_inf: ArrayLike,
    E_1: ArrayLike,
    tau: ArrayLike,
) -> Result:
    """Time at which the contact with a standard solid ends on the way back.

    t_c from E_1*tau*(1 - exp(-t_c/tau)) + E_inf*t_c = E_1*tau*(1 - exp(-(t_c -
    t_m)/tau)) + E_inf*(t_c - t_m) + v_2*(E_1*tau*(1 - exp(-(t_c - t_h)/tau)) +
    E_inf*(t_c - t_h))/v

    Parameters
    ----------
    v : array_like
        Speed of indentation, d = v t [m/s], v > 0.
    v_2 : array_like
        Speed of retraction, from t_h on [m/s], v_2 > 0.
    t_m : array_like
        Time at which the indenter stops [s], t_m > 0.
    t_h : array_like, optional
        Time at which the indenter goes back, held at v t_m until then [s], t_h >= t_m; t_m if it is not
        given.
    E_inf : array_like
        Long-time effective modulus [Pa], E_inf > 0.
    E_1 : array_like
        Relaxing part of the effective modulus [Pa], E_1 >= 0.
    tau : array_like
        Relaxation time [s], tau > 0.

    Returns
    -------
    float or ndarray
        Time at which the contact ends [s]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for tan(theta) << 1; a << size of the body, a ramp up to t_m, a depth that is held up to t_h and
    then a constant speed back, so that the contact has one maximum, and no adhesion. Handbook:
    cone.vis.end_sls.

    References
    ----------
    chapter 11, equation (11.16); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.contact_time_standard_solid(v=0.2, v_2=0.05, t_m=0.8, t_h=0.9, E_inf=0.4, E_1=0.6, tau=2.0)
    >>> round(value, 6)
    3.220085
    """
    t_h = require_hold(t_m, t_h)
    require(v=v, v_2=v_2, t_m=t_m, t_h=t_h, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(_contact_time_standard_solid, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E_inf=E_inf, E_1=E_1, tau=tau)


def retract_force_standard_solid(
    t: ArrayLike,
    *,
    theta: ArrayLike,
    v: ArrayLike,
    v_2: ArrayLike,
    t_m: ArrayLike,
    t_h: ArrayLike | None = None,
    E_inf: ArrayLike,
    E_1: ArrayLike,
    tau: ArrayLike,
) -> Result:
    """Normal force at time t on a standard solid, pressed in at v until t_m, from t_h on back at v_2.

    F = 2*t_1**2*v**2*(E_1*exp((t_1 - t)/tau)*1F1(1, 3, -t_1/tau) + E_inf)/(pi*tan(theta))
    with 1F1: Confluent 1F1(p; c; z)

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    v : array_like
        Speed of indentation, d = v t [m/s], v > 0.
    v_2 : array_like
        Speed of retraction, from t_h on [m/s], v_2 > 0.
    t_m : array_like
        Time at which the indenter stops [s], t_m > 0.
    t_h : array_like, optional
        Time at which the indenter goes back, held at v t_m until then [s], t_h >= t_m; t_m if it is not
        given.
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
    Valid for tan(theta) << 1; a << size of the body, a ramp up to t_m, a depth that is held up to t_h and
    then a constant speed back, so that the contact has one maximum, and no adhesion. Negative or NaN times
    give NaN. Here t_1 is earlier_time_standard_solid; up to t_m it is t, and the force that of the ramp.
    Handbook: cone.vis.retract_sls.

    References
    ----------
    chapter 11, equation (11.16); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.retract_force_standard_solid(
    ...     1.0, theta=0.35, v=0.2, v_2=0.05, t_m=0.8, t_h=0.9, E_inf=0.4, E_1=0.6, tau=2.0
    ... )
    >>> round(value, 6)
    0.036461
    """
    t_h = require_hold(t_m, t_h)
    require(theta=theta, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(
        _retract_force_standard_solid, t, theta=theta, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E_inf=E_inf, E_1=E_1, tau=tau
    )


def retract_radius_standard_solid(
    t: ArrayLike,
    *,
    theta: ArrayLike,
    v: ArrayLike,
    v_2: ArrayLike,
    t_m: ArrayLike,
    t_h: ArrayLike | None = None,
    E_inf: ArrayLike,
    E_1: ArrayLike,
    tau: ArrayLike,
) -> Result:
    """Contact radius at time t on a standard solid, pressed in at v until t_m, from t_h on back at v_2.

    a = 2*t_1*v/(pi*tan(theta))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    v : array_like
        Speed of indentation, d = v t [m/s], v > 0.
    v_2 : array_like
        Speed of retraction, from t_h on [m/s], v_2 > 0.
    t_m : array_like
        Time at which the indenter stops [s], t_m > 0.
    t_h : array_like, optional
        Time at which the indenter goes back, held at v t_m until then [s], t_h >= t_m; t_m if it is not
        given.
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
    Valid for tan(theta) << 1; a << size of the body, a ramp up to t_m, a depth that is held up to t_h and
    then a constant speed back, so that the contact has one maximum, and no adhesion. Negative or NaN times
    give NaN. Here t_1 is earlier_time_standard_solid; up to t_m it is t, and the force that of the ramp.
    Handbook: cone.vis.radius_sls.

    References
    ----------
    chapter 11, equation (11.16); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.retract_radius_standard_solid(
    ...     1.0, theta=0.35, v=0.2, v_2=0.05, t_m=0.8, t_h=0.9, E_inf=0.4, E_1=0.6, tau=2.0
    ... )
    >>> round(value, 6)
    0.269898
    """
    t_h = require_hold(t_m, t_h)
    require(theta=theta, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E_inf=E_inf, E_1=E_1, relaxation=tau)
    return elementwise(
        _retract_radius_standard_solid, t, theta=theta, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E_inf=E_inf, E_1=E_1, tau=tau
    )


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


def earlier_time_power_creep(
    t: ArrayLike,
    *,
    v: ArrayLike,
    v_2: ArrayLike,
    t_m: ArrayLike,
    t_h: ArrayLike | None = None,
    E: ArrayLike,
    alpha: ArrayLike,
    t_0: ArrayLike,
) -> Result:
    """Time before t at which the contact was as large on a material of power-law creep; zero after its end.

    t_1 = t - (1 + v_2*((-t_m + t)/(-t_h + t))**(alpha - 1)/v)**(1/(1 - alpha))*(-t_m + t)

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    v : array_like
        Speed of indentation, d = v t [m/s], v > 0.
    v_2 : array_like
        Speed of retraction, from t_h on [m/s], v_2 > 0.
    t_m : array_like
        Time at which the indenter stops [s], t_m > 0.
    t_h : array_like, optional
        Time at which the indenter goes back, held at v t_m until then [s], t_h >= t_m; t_m if it is not
        given.
    E : array_like
        Effective (plane-strain) modulus of the viscoelastic law [Pa], E > 0.
    alpha : array_like
        Exponent of power-law creep [1], 0 < alpha < 1.
    t_0 : array_like
        Reference time of power-law creep, J = (t/t_0)^alpha/E [s], t_0 > 0.

    Returns
    -------
    float or ndarray
        Time before at which the contact was as large [s]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for tan(theta) << 1; a << size of the body, a ramp up to t_m, a depth that is held up to t_h and
    then a constant speed back, so that the contact has one maximum, and no adhesion. Negative or NaN times
    give NaN. Here t_1 is t up to t_m, and t_m while the depth is held. Handbook: cone.vis.earlier_pc.

    References
    ----------
    chapter 11, equation (11.16); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.earlier_time_power_creep(1.0, v=0.2, v_2=0.05, t_m=0.8, t_h=0.9, E=1.0, alpha=0.25, t_0=1.0)
    >>> round(value, 6)
    0.759408
    """
    t_h = require_hold(t_m, t_h)
    require(v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, alpha=alpha, t_0=t_0)
    return elementwise(_earlier_time_power_creep, t, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, alpha=alpha, t_0=t_0)


def contact_time_power_creep(
    *,
    v: ArrayLike,
    v_2: ArrayLike,
    t_m: ArrayLike,
    t_h: ArrayLike | None = None,
    E: ArrayLike,
    alpha: ArrayLike,
    t_0: ArrayLike,
) -> Result:
    """Time at which the contact with a material of power-law creep ends on the way back.

    t_c from E*t_0**alpha*t_c**(1 - alpha)/((1 - alpha)*gamma(1 - alpha)*gamma(alpha + 1)) = E*t_0**alpha*(t_c
    - t_m)**(1 - alpha)/((1 - alpha)*gamma(1 - alpha)*gamma(alpha + 1)) + E*t_0**alpha*v_2*(t_c - t_h)**(1 -
    alpha)/(v*(1 - alpha)*gamma(1 - alpha)*gamma(alpha + 1))

    Parameters
    ----------
    v : array_like
        Speed of indentation, d = v t [m/s], v > 0.
    v_2 : array_like
        Speed of retraction, from t_h on [m/s], v_2 > 0.
    t_m : array_like
        Time at which the indenter stops [s], t_m > 0.
    t_h : array_like, optional
        Time at which the indenter goes back, held at v t_m until then [s], t_h >= t_m; t_m if it is not
        given.
    E : array_like
        Effective (plane-strain) modulus of the viscoelastic law [Pa], E > 0.
    alpha : array_like
        Exponent of power-law creep [1], 0 < alpha < 1.
    t_0 : array_like
        Reference time of power-law creep, J = (t/t_0)^alpha/E [s], t_0 > 0.

    Returns
    -------
    float or ndarray
        Time at which the contact ends [s]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for tan(theta) << 1; a << size of the body, a ramp up to t_m, a depth that is held up to t_h and
    then a constant speed back, so that the contact has one maximum, and no adhesion. Handbook:
    cone.vis.end_pc.

    References
    ----------
    chapter 11, equation (11.16); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.contact_time_power_creep(v=0.2, v_2=0.05, t_m=0.8, t_h=0.9, E=1.0, alpha=0.25, t_0=1.0)
    >>> round(value, 6)
    3.186706
    """
    t_h = require_hold(t_m, t_h)
    require(v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, alpha=alpha, t_0=t_0)
    return elementwise(_contact_time_power_creep, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, alpha=alpha, t_0=t_0)


def retract_force_power_creep(
    t: ArrayLike,
    *,
    theta: ArrayLike,
    v: ArrayLike,
    v_2: ArrayLike,
    t_m: ArrayLike,
    t_h: ArrayLike | None = None,
    E: ArrayLike,
    alpha: ArrayLike,
    t_0: ArrayLike,
) -> Result:
    """Normal force at time t on a material of power-law creep, pressed in at v until t_m, from t_h on back at v_2.

    F = 4*E*t_0**alpha*t**(2 - alpha)*v**2*IncompleteBeta(t_1/t, 2, 1 - alpha)/(pi*tan(theta)*gamma(1 -
    alpha)*gamma(alpha + 1))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    v : array_like
        Speed of indentation, d = v t [m/s], v > 0.
    v_2 : array_like
        Speed of retraction, from t_h on [m/s], v_2 > 0.
    t_m : array_like
        Time at which the indenter stops [s], t_m > 0.
    t_h : array_like, optional
        Time at which the indenter goes back, held at v t_m until then [s], t_h >= t_m; t_m if it is not
        given.
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
    Valid for tan(theta) << 1; a << size of the body, a ramp up to t_m, a depth that is held up to t_h and
    then a constant speed back, so that the contact has one maximum, and no adhesion. Negative or NaN times
    give NaN. Here t_1 is earlier_time_power_creep; up to t_m it is t, and the force that of the ramp.
    Handbook: cone.vis.retract_pc.

    References
    ----------
    chapter 11, equation (11.16); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.retract_force_power_creep(
    ...     1.0, theta=0.35, v=0.2, v_2=0.05, t_m=0.8, t_h=0.9, E=1.0, alpha=0.25, t_0=1.0
    ... )
    >>> round(value, 6)
    0.044103
    """
    t_h = require_hold(t_m, t_h)
    require(theta=theta, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, alpha=alpha, t_0=t_0)
    return elementwise(
        _retract_force_power_creep, t, theta=theta, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, alpha=alpha, t_0=t_0
    )


def retract_radius_power_creep(
    t: ArrayLike,
    *,
    theta: ArrayLike,
    v: ArrayLike,
    v_2: ArrayLike,
    t_m: ArrayLike,
    t_h: ArrayLike | None = None,
    E: ArrayLike,
    alpha: ArrayLike,
    t_0: ArrayLike,
) -> Result:
    """Contact radius at time t on a material of power-law creep, pressed in at v until t_m, from t_h on back at v_2.

    a = 2*t_1*v/(pi*tan(theta))

    Parameters
    ----------
    t : array_like
        Time since first contact [s].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    v : array_like
        Speed of indentation, d = v t [m/s], v > 0.
    v_2 : array_like
        Speed of retraction, from t_h on [m/s], v_2 > 0.
    t_m : array_like
        Time at which the indenter stops [s], t_m > 0.
    t_h : array_like, optional
        Time at which the indenter goes back, held at v t_m until then [s], t_h >= t_m; t_m if it is not
        given.
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
    Valid for tan(theta) << 1; a << size of the body, a ramp up to t_m, a depth that is held up to t_h and
    then a constant speed back, so that the contact has one maximum, and no adhesion. Negative or NaN times
    give NaN. Here t_1 is earlier_time_power_creep; up to t_m it is t, and the force that of the ramp.
    Handbook: cone.vis.radius_pc.

    References
    ----------
    chapter 11, equation (11.16); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.viscoelastic import cone
    >>> value = cone.retract_radius_power_creep(
    ...     1.0, theta=0.35, v=0.2, v_2=0.05, t_m=0.8, t_h=0.9, E=1.0, alpha=0.25, t_0=1.0
    ... )
    >>> round(value, 6)
    0.264886
    """
    t_h = require_hold(t_m, t_h)
    require(theta=theta, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, alpha=alpha, t_0=t_0)
    return elementwise(
        _retract_radius_power_creep, t, theta=theta, v=v, v_2=v_2, t_m=t_m, t_h=t_h, E=E, alpha=alpha, t_0=t_0
    )


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


def _earlier_time_maxwell(t: Array, v: Array, v_2: Array, t_m: Array, t_h: Array, E: Array, tau: Array) -> Array:
    return earlier(t, t_m, lag_maxwell(t, t_m, t_h, v_2 / v, E, tau))


def _retract_radius_maxwell(
    t: Array, v: Array, v_2: Array, t_m: Array, t_h: Array, theta: Array, E: Array, tau: Array
) -> Array:
    t_1 = earlier(t, t_m, lag_maxwell(t, t_m, t_h, v_2 / v, E, tau))
    return np.where(t_1 <= 0.0, 0.0, normal._radius_from_depth(v * t_1, theta))


def _retract_force_maxwell(
    t: Array, v: Array, v_2: Array, t_m: Array, t_h: Array, theta: Array, E: Array, tau: Array
) -> Array:
    lag = lag_maxwell(t, t_m, t_h, v_2 / v, E, tau)
    t_1 = earlier(t, t_m, lag)
    kept = kept_maxwell(t, t_1, passed(t, t_m, lag), 2.0, E, tau)
    back = np.where((t > t_m) & (t_1 > 0.0), normal._force_from_depth(v * t_1, theta, 1.0) * kept, 0.0)
    return np.where(t > t_m, back, _ramp_force_maxwell(t, v, theta, E, tau))


def _contact_time_maxwell(v: Array, v_2: Array, t_m: Array, t_h: Array, E: Array, tau: Array) -> Array:
    return end_maxwell(v_2 / v, t_m, t_h, E, tau)


def _ramp_force_kelvin_voigt(t: Array, v: Array, theta: Array, E: Array, eta: Array) -> Array:
    force = normal._force_from_depth(v * t, theta, 1.0) * ramp_kelvin_voigt(t, 2.0, E, eta)
    return np.where(t == 0.0, 0.0, force)


def _step_force_kelvin_voigt(t: Array, d: Array, theta: Array, E: Array, eta: Array) -> Array:
    return relaxation_kelvin_voigt(t, E, eta) * normal._force_from_depth(d, theta, 1.0)


def _step_load_radius_kelvin_voigt(t: Array, F: Array, theta: Array, E: Array, eta: Array) -> Array:
    return normal._radius_from_force(F * creep_kelvin_voigt(t, E, eta), theta, 1.0)


def _earlier_time_kelvin_voigt(t: Array, v: Array, v_2: Array, t_m: Array, t_h: Array, E: Array, eta: Array) -> Array:
    return earlier(t, t_m, lag_kelvin_voigt(t, t_m, t_h, v_2 / v, E, eta))


def _retract_radius_kelvin_voigt(
    t: Array, v: Array, v_2: Array, t_m: Array, t_h: Array, theta: Array, E: Array, eta: Array
) -> Array:
    t_1 = earlier(t, t_m, lag_kelvin_voigt(t, t_m, t_h, v_2 / v, E, eta))
    return np.where(t_1 <= 0.0, 0.0, normal._radius_from_depth(v * t_1, theta))


def _retract_force_kelvin_voigt(
    t: Array, v: Array, v_2: Array, t_m: Array, t_h: Array, theta: Array, E: Array, eta: Array
) -> Array:
    lag = lag_kelvin_voigt(t, t_m, t_h, v_2 / v, E, eta)
    t_1 = earlier(t, t_m, lag)
    kept = kept_kelvin_voigt(t, t_1, passed(t, t_m, lag), 2.0, E, eta)
    back = np.where((t > t_m) & (t_1 > 0.0), normal._force_from_depth(v * t_1, theta, 1.0) * kept, 0.0)
    return np.where(t > t_m, back, _ramp_force_kelvin_voigt(t, v, theta, E, eta))


def _contact_time_kelvin_voigt(v: Array, v_2: Array, t_m: Array, t_h: Array, E: Array, eta: Array) -> Array:
    return end_kelvin_voigt(v_2 / v, t_m, t_h, E, eta)


def _ramp_force_standard_solid(t: Array, v: Array, theta: Array, E_inf: Array, E_1: Array, tau: Array) -> Array:
    force = normal._force_from_depth(v * t, theta, 1.0) * ramp_standard_solid(t, 2.0, E_inf, E_1, tau)
    return np.where(t == 0.0, 0.0, force)


def _step_force_standard_solid(t: Array, d: Array, theta: Array, E_inf: Array, E_1: Array, tau: Array) -> Array:
    return relaxation_standard_solid(t, E_inf, E_1, tau) * normal._force_from_depth(d, theta, 1.0)


def _step_load_radius_standard_solid(t: Array, F: Array, theta: Array, E_inf: Array, E_1: Array, tau: Array) -> Array:
    return normal._radius_from_force(F * creep_standard_solid(t, E_inf, E_1, tau), theta, 1.0)


def _earlier_time_standard_solid(
    t: Array, v: Array, v_2: Array, t_m: Array, t_h: Array, E_inf: Array, E_1: Array, tau: Array
) -> Array:
    return earlier(t, t_m, lag_standard_solid(t, t_m, t_h, v_2 / v, E_inf, E_1, tau))


def _retract_radius_standard_solid(
    t: Array, v: Array, v_2: Array, t_m: Array, t_h: Array, theta: Array, E_inf: Array, E_1: Array, tau: Array
) -> Array:
    t_1 = earlier(t, t_m, lag_standard_solid(t, t_m, t_h, v_2 / v, E_inf, E_1, tau))
    return np.where(t_1 <= 0.0, 0.0, normal._radius_from_depth(v * t_1, theta))


def _retract_force_standard_solid(
    t: Array, v: Array, v_2: Array, t_m: Array, t_h: Array, theta: Array, E_inf: Array, E_1: Array, tau: Array
) -> Array:
    lag = lag_standard_solid(t, t_m, t_h, v_2 / v, E_inf, E_1, tau)
    t_1 = earlier(t, t_m, lag)
    kept = kept_standard_solid(t, t_1, passed(t, t_m, lag), 2.0, E_inf, E_1, tau)
    back = np.where((t > t_m) & (t_1 > 0.0), normal._force_from_depth(v * t_1, theta, 1.0) * kept, 0.0)
    return np.where(t > t_m, back, _ramp_force_standard_solid(t, v, theta, E_inf, E_1, tau))


def _contact_time_standard_solid(
    v: Array, v_2: Array, t_m: Array, t_h: Array, E_inf: Array, E_1: Array, tau: Array
) -> Array:
    return end_standard_solid(v_2 / v, t_m, t_h, E_inf, E_1, tau)


def _ramp_force_power_creep(t: Array, v: Array, theta: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    force = normal._force_from_depth(v * t, theta, 1.0) * ramp_power_creep(t, 2.0, E, alpha, t_0)
    return np.where(t == 0.0, 0.0, force)


def _step_force_power_creep(t: Array, d: Array, theta: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    return relaxation_power_creep(t, E, alpha, t_0) * normal._force_from_depth(d, theta, 1.0)


def _step_load_radius_power_creep(t: Array, F: Array, theta: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    return normal._radius_from_force(F * creep_power_creep(t, E, alpha, t_0), theta, 1.0)


def _earlier_time_power_creep(
    t: Array, v: Array, v_2: Array, t_m: Array, t_h: Array, E: Array, alpha: Array, t_0: Array
) -> Array:
    return earlier(t, t_m, lag_power_creep(t, t_m, t_h, v_2 / v, E, alpha, t_0))


def _retract_radius_power_creep(
    t: Array, v: Array, v_2: Array, t_m: Array, t_h: Array, theta: Array, E: Array, alpha: Array, t_0: Array
) -> Array:
    t_1 = earlier(t, t_m, lag_power_creep(t, t_m, t_h, v_2 / v, E, alpha, t_0))
    return np.where(t_1 <= 0.0, 0.0, normal._radius_from_depth(v * t_1, theta))


def _retract_force_power_creep(
    t: Array, v: Array, v_2: Array, t_m: Array, t_h: Array, theta: Array, E: Array, alpha: Array, t_0: Array
) -> Array:
    lag = lag_power_creep(t, t_m, t_h, v_2 / v, E, alpha, t_0)
    t_1 = earlier(t, t_m, lag)
    kept = kept_power_creep(t, t_1, passed(t, t_m, lag), 2.0, E, alpha, t_0)
    back = np.where((t > t_m) & (t_1 > 0.0), normal._force_from_depth(v * t_1, theta, 1.0) * kept, 0.0)
    return np.where(t > t_m, back, _ramp_force_power_creep(t, v, theta, E, alpha, t_0))


def _contact_time_power_creep(
    v: Array, v_2: Array, t_m: Array, t_h: Array, E: Array, alpha: Array, t_0: Array
) -> Array:
    return end_power_creep(v_2 / v, t_m, t_h, E, alpha, t_0)
