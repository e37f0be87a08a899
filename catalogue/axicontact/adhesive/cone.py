"""Cone with adhesion.

Rigid cone of inclination theta. Self-similar: the mean pressure does not depend on the load.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, require
from .._runtime.physics.adhesion import (
    XI,
    PullOff,
    hess_retraction,
    lift,
    power_law_radius,
    pull,
    require_control,
    separation,
    tension,
)
from ..normal import cone as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "depth",
    "displacement",
    "force",
    "pressure",
    "pull_off",
    "radius_from_depth",
    "radius_from_force",
    "retraction",
    "work_of_adhesion_from_pull_off",
]


def __dir__() -> list[str]:
    return __all__


def retraction(a: ArrayLike, *, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Retraction of the indenter from the state without adhesion, at constant contact radius.

    retraction = sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.

    Returns
    -------
    float or ndarray
        Retraction at constant contact radius, rule of Hess [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN radii give NaN. Handbook: cone.adh.Dl.

    References
    ----------
    chapter 11, equation (11.31); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import cone
    >>> value = cone.retraction(1.0, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.250663
    """
    require(E_star=E_star, dgamma=dgamma)
    return elementwise(hess_retraction, a, E_star=E_star, dgamma=dgamma)


def depth(a: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Indentation depth at contact radius a; negative where adhesion pulls the surface up.

    d = pi*a*tan(theta)/2 - sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.

    Returns
    -------
    float or ndarray
        Indentation depth of the point r = 0 [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN radii give NaN. Handbook: cone.adh.d.

    References
    ----------
    chapter 11, equation (11.31); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import cone
    >>> value = cone.depth(1.0, theta=0.35, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.322723
    """
    require(theta=theta, E_star=E_star, dgamma=dgamma)
    return elementwise(_depth, a, theta=theta, E_star=E_star, dgamma=dgamma)


def force(a: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Normal force at contact radius a, negative in tension.

    F = -2*sqrt(2)*sqrt(pi)*sqrt(E_star)*a**(3/2)*sqrt(dgamma) + pi*E_star*a**2*tan(theta)/2

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.

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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN radii give NaN. Handbook: cone.adh.F.

    References
    ----------
    chapter 11, equation (11.31); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import cone
    >>> value = cone.force(1.0, theta=0.35, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.07206
    """
    require(theta=theta, E_star=E_star, dgamma=dgamma)
    return elementwise(_force, a, theta=theta, E_star=E_star, dgamma=dgamma)


def pressure(r: ArrayLike, a: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact pressure, positive in compression, infinite tension at the edge; zero outside the contact.

    p = -sqrt(2)*sqrt(E_star)*sqrt(a)*sqrt(dgamma)/(sqrt(pi)*sqrt(a**2 - r**2)) +
    E_star*tan(theta)*acosh(a/r)/2

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.

    Returns
    -------
    float or ndarray
        Contact pressure, positive in compression [Pa]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN radii give NaN. Handbook: cone.adh.p.

    References
    ----------
    chapter 11, equation (11.31); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import cone
    >>> value = cone.pressure(0.3, 1.0, theta=0.35, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.258358
    """
    require(theta=theta, E_star=E_star, dgamma=dgamma)
    return elementwise(_pressure, r, a, theta=theta, E_star=E_star, dgamma=dgamma)


def displacement(r: ArrayLike, a: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = (a*asin(a/r) - r + sqrt(-a**2 + r**2))*tan(theta) -
    2*sqrt(2)*sqrt(a)*sqrt(dgamma)*asin(a/r)/(sqrt(pi)*sqrt(E_star))

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.

    Returns
    -------
    float or ndarray
        Surface displacement into the half-space [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN radii give NaN. Handbook: cone.adh.w.

    References
    ----------
    chapter 11, equation (11.31); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import cone
    >>> value = cone.displacement(2.0, 1.0, theta=0.35, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.009765
    """
    require(theta=theta, E_star=E_star, dgamma=dgamma)
    return elementwise(_displacement, r, a, theta=theta, E_star=E_star, dgamma=dgamma)


def radius_from_depth(d: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact radius at indentation depth d, on the branch that is stable under a given depth.

    a = (sqrt(2*d/(pi*tan(theta)) + 2*dgamma/(pi*E_star*tan(theta)**2)) +
    sqrt(2)*sqrt(dgamma)/(sqrt(pi)*sqrt(E_star)*tan(theta)))**2

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.

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
    Valid for tan(theta) << 1; a << size of the body. NaN below pull-off. Handbook: cone.adh.ad.

    References
    ----------
    chapter 11, equation (11.31); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import cone
    >>> value = cone.radius_from_depth(0.3227, theta=0.35, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.99995
    """
    require(theta=theta, E_star=E_star, dgamma=dgamma)
    return elementwise(_radius_from_depth, d=d, theta=theta, E_star=E_star, dgamma=dgamma)


def radius_from_force(F: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact radius under the normal force F, on the branch that is stable under a given force.

    a from -2*sqrt(2)*sqrt(pi)*sqrt(E_star)*a**(3/2)*sqrt(dgamma) + pi*E_star*a**2*tan(theta)/2 = F

    Parameters
    ----------
    F : array_like
        Normal force [N].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.

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
    Valid for tan(theta) << 1; a << size of the body. NaN below pull-off. Handbook: cone.adh.aF.

    References
    ----------
    chapter 11, equation (11.31); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import cone
    >>> value = cone.radius_from_force(0.07206, theta=0.35, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    1.000001
    """
    require(theta=theta, E_star=E_star, dgamma=dgamma)
    return elementwise(_radius_from_force, F=F, theta=theta, E_star=E_star, dgamma=dgamma)


def pull_off(control: str = "force", *, theta: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> PullOff:
    """State at which the contact breaks on unloading.

    Under control of the force:

        a_c = 18*dgamma/(pi*E_star*tan(theta)**2)
        F = -54*dgamma**2/(pi*E_star*tan(theta)**3)
        d = 3*dgamma/(E_star*tan(theta))

    Under control of the depth:

        a_c = 2*dgamma/(pi*E_star*tan(theta)**2)
        F = -6*dgamma**2/(pi*E_star*tan(theta)**3)
        d = -dgamma/(E_star*tan(theta))

    Parameters
    ----------
    control : {"force", "depth"}
        What is held while the contact is unloaded.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.

    Returns
    -------
    PullOff
        Named tuple of radius [m], force [N] and depth [m]; NaN without a stable contact.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    The least force, or depth, of a stable contact. Handbook: cone.adh.ac, cone.adh.am.

    References
    ----------
    chapter 11, equation (11.31); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import cone
    >>> state = cone.pull_off(theta=0.35, E_star=1.0, dgamma=0.01)
    >>> round(state.force, 6)
    -0.03534
    """
    require(theta=theta, E_star=E_star, dgamma=dgamma)
    require_control(control)
    radius = elementwise(partial(_pull_off_radius, control=control), theta=theta, E_star=E_star, dgamma=dgamma)
    force = elementwise(partial(_pull_off_force, control=control), radius, theta=theta, E_star=E_star, dgamma=dgamma)
    depth = elementwise(partial(_pull_off_depth, control=control), radius, theta=theta, E_star=E_star, dgamma=dgamma)
    return PullOff(radius, force, depth)


def work_of_adhesion_from_pull_off(F: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike) -> Result:
    """Work of separation at which a contact breaks under the normal force F: the inverse of the force of pull_off.

    dgamma = sqrt(6)*sqrt(pi)*sqrt(E_star)*sqrt(abs(F))*tan(theta)**(3/2)/18

    Parameters
    ----------
    F : array_like
        Normal force [N].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Work of separation per unit area [N/m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for tan(theta) << 1; a << size of the body. The force is a tension, F < 0: 0 without a force, NaN
    under pressure, which breaks no contact, and where no stable contact bears the tension.

    References
    ----------
    chapter 11, equation (11.31); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import cone
    >>> value = cone.work_of_adhesion_from_pull_off(-0.03534, theta=0.35, E_star=1.0)
    >>> round(value, 6)
    0.01
    """
    require(theta=theta, E_star=E_star)
    return elementwise(_work_of_adhesion_from_pull_off, F=F, theta=theta, E_star=E_star)


def _depth(a: Array, theta: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._depth(a, theta) - hess_retraction(a, E_star, dgamma)


def _force(a: Array, theta: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._force(a, theta, E_star) - pull(a, E_star, dgamma)


def _pressure(r: Array, a: Array, theta: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._pressure(r, a, theta, E_star) - tension(r, a, E_star, dgamma)


def _displacement(r: Array, a: Array, theta: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._displacement(r, a, theta) - lift(r, a, E_star, dgamma)


def _pull_off_radius(theta: Array, E_star: Array, dgamma: Array, control: str) -> Array:
    if control == "force":
        radius = 18 * dgamma / (np.pi * E_star * np.tan(theta) ** 2)
    else:
        radius = 2 * dgamma / (np.pi * E_star * np.tan(theta) ** 2)
    return np.where(dgamma > 0.0, radius, 0.0)


def _pull_off_depth(a: Array, theta: Array, E_star: Array, dgamma: Array, control: str) -> Array:
    """With the retraction 2 a g'(a)/xi of pull-off, free of cancellation."""
    return normal._depth(a, theta) * (1.0 - 2.0 / XI[control])


def _radius_from_depth(d: Array, theta: Array, E_star: Array, dgamma: Array) -> Array:
    a_c = _pull_off_radius(theta, E_star, dgamma, control="depth")
    least = _pull_off_depth(a_c, theta, E_star, dgamma, control="depth")
    plain = normal._radius_from_depth(np.maximum(d, 0.0), theta)
    return power_law_radius(d, a_c, least, 1.0, 0.5, plain)


def _pull_off_force(a: Array, theta: Array, E_star: Array, dgamma: Array, control: str) -> Array:
    """With the retraction 2 a g'(a)/xi of pull-off, free of cancellation."""
    return normal._force(a, theta, E_star) * (1.0 - 4.0 / XI[control])


def _radius_from_force(F: Array, theta: Array, E_star: Array, dgamma: Array) -> Array:
    a_c = _pull_off_radius(theta, E_star, dgamma, control="force")
    least = _pull_off_force(a_c, theta, E_star, dgamma, control="force")
    plain = normal._radius_from_force(np.maximum(F, 0.0), theta, E_star)
    return power_law_radius(F, a_c, least, 2.0, 1.5, plain)


def _work_of_adhesion_from_pull_off(F: Array, theta: Array, E_star: Array) -> Array:
    pull = np.where(F < 0.0, -F, np.nan)
    lasting = 3 * pull
    a = normal._radius_from_force(lasting, theta, E_star)
    return np.where(F == 0.0, 0.0, separation(pull + lasting, a, E_star))
