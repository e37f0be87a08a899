"""Concave paraboloid with adhesion.

Concave parabolic face of depth h: the pressure vanishes first at the centre.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, require
from .._runtime.physics.adhesion import PullOff, hess_retraction, require_control, separation

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["pull_off", "retraction", "work_of_adhesion_from_pull_off"]


def __dir__() -> list[str]:
    return __all__


def retraction(*, a: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Retraction of the edge at which it peels off.

    retraction = sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star)

    Parameters
    ----------
    a : array_like
        Contact radius [m], a > 0.
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
    Valid for small slopes; complete contact only. Handbook: concave_paraboloid.adh.Dl.

    References
    ----------
    chapter 11, equation (11.31); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.adhesive import concave_paraboloid
    >>> value = concave_paraboloid.retraction(a=1.0, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.250663
    """
    require(a=a, E_star=E_star, dgamma=dgamma)
    return elementwise(hess_retraction, a=a, E_star=E_star, dgamma=dgamma)


def pull_off(control: str = "force", *, a: ArrayLike, h: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> PullOff:
    """State at which the edge peels off, and with it the whole face.

    F = -2*sqrt(2)*sqrt(pi)*sqrt(E_star)*a**(3/2)*sqrt(dgamma) - 8*E_star*a*h/3
    d = -2*h - sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star)

    Parameters
    ----------
    control : {"force", "depth"}
        What is held while the contact is unloaded; the state is the same.
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.

    Returns
    -------
    PullOff
        Named tuple of radius [m], force [N] and depth [m].

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    A smaller contact needs a greater depth and a greater force, so that the edge does not stop. Handbook:
    concave_paraboloid.adh.Fc, concave_paraboloid.adh.dc.

    References
    ----------
    chapter 11, equation (11.31); Barber 1976; Schubert 1942; Kendall 1971.

    Examples
    --------
    >>> from axicontact.adhesive import concave_paraboloid
    >>> state = concave_paraboloid.pull_off(a=1.0, h=0.15, E_star=1.0, dgamma=0.01)
    >>> round(state.force, 6)
    -0.901326
    """
    require(a=a, h=h, E_star=E_star, dgamma=dgamma)
    require_control(control)
    depth = elementwise(_pull_off_depth, a=a, h=h, E_star=E_star, dgamma=dgamma)
    force = elementwise(_pull_off_force, a=a, h=h, E_star=E_star, dgamma=dgamma)
    return PullOff(depth * 0.0 + a, force, depth)


def work_of_adhesion_from_pull_off(F: ArrayLike, *, a: ArrayLike, h: ArrayLike, E_star: ArrayLike) -> Result:
    """Work of separation at which a contact breaks under the normal force F: the inverse of the force of pull_off.

    dgamma = (8*E_star*a*h - 3*abs(F))**2/(72*pi*E_star*a**3)

    Parameters
    ----------
    F : array_like
        Normal force [N].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
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
    Valid for small slopes; complete contact only. The force is a tension, F < 0: NaN above the force at which
    the edge is without tension, as under pressure.

    References
    ----------
    chapter 11, equation (11.31); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.adhesive import concave_paraboloid
    >>> value = concave_paraboloid.work_of_adhesion_from_pull_off(-0.9013, a=1.0, h=0.15, E_star=1.0)
    >>> round(value, 6)
    0.009999
    """
    require(a=a, h=h, E_star=E_star)
    return elementwise(_work_of_adhesion_from_pull_off, F=F, a=a, h=h, E_star=E_star)


def _pull_off_depth(a: Array, h: Array, E_star: Array, dgamma: Array) -> Array:
    return -2 * h - hess_retraction(a, E_star, dgamma)


def _pull_off_force(a: Array, h: Array, E_star: Array, dgamma: Array) -> Array:
    return -2 * a * np.sqrt(2 * np.pi * E_star * dgamma * a) - 8 * E_star * h / 3 * a


def _work_of_adhesion_from_pull_off(F: Array, a: Array, h: Array, E_star: Array) -> Array:
    least = _pull_off_force(a, h, E_star, 0.0)
    return np.where(least >= F, separation(least - F, a, E_star), np.nan)
