"""Concave quartic with adhesion on a power-law graded half-space.

Concave face of fourth order: the pressure vanishes first on the ring r = a/2.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.growth import power_factor
from ..._runtime.graded.punch import graded_retraction, punch_stiffness, separation
from ..._runtime.interface import Array, Result, elementwise, require
from ..._runtime.physics.adhesion import PullOff, require_control

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["pull_off", "retraction", "work_of_adhesion_from_pull_off"]


def __dir__() -> list[str]:
    return __all__


def retraction(*, a: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> Result:
    """Retraction of the edge at which it peels off.

    retraction = sqrt(2)*sqrt(pi)*a**(1/2 - k/2)*sqrt(dgamma)/sqrt(H)

    Parameters
    ----------
    a : array_like
        Contact radius [m], a > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.
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
    Valid for small slopes; complete contact only. Handbook: concave_quartic.fgm.adh.Dl.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.adhesive import concave_quartic
    >>> value = concave_quartic.retraction(a=1.0, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    0.250663
    """
    require(a=a, H=H, k=k, dgamma=dgamma)
    return elementwise(graded_retraction, a=a, H=H, k=k, dgamma=dgamma)


def pull_off(
    control: str = "force", *, a: ArrayLike, h: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike
) -> PullOff:
    """State at which the edge peels off, and with it the whole face.

    F = -2*sqrt(2)*sqrt(pi)*sqrt(H)*a**(k/2 + 3/2)*sqrt(dgamma)/(k + 1) - 64*H*a**(k + 1)*h/((k + 1)**2*(k +
    3)*(k + 5))
    d = -8*h/((k + 1)*(k + 3)) - sqrt(2)*sqrt(pi)*a**(1/2 - k/2)*sqrt(dgamma)/sqrt(H)

    Parameters
    ----------
    control : {"force", "depth"}
        What is held while the contact is unloaded; the state is the same.
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.
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
    concave_quartic.fgm.adh.Fc, concave_quartic.fgm.adh.dc.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Schubert 1942; Kendall 1971.

    Examples
    --------
    >>> from axicontact.graded.adhesive import concave_quartic
    >>> state = concave_quartic.pull_off(a=1.0, h=0.15, H=1.0, k=0.25, dgamma=0.01)
    >>> round(state.force, 6)
    -0.761148
    """
    require(a=a, h=h, H=H, k=k, dgamma=dgamma)
    require_control(control)
    depth = elementwise(_pull_off_depth, a=a, h=h, H=H, k=k, dgamma=dgamma)
    force = elementwise(_pull_off_force, a=a, h=h, H=H, k=k, dgamma=dgamma)
    return PullOff(depth * 0.0 + a, force, depth)


def work_of_adhesion_from_pull_off(F: ArrayLike, *, a: ArrayLike, h: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Work of separation at which a contact breaks under the normal force F: the inverse of the force of pull_off.

    dgamma = a**(-k - 3)*(64*H*a*a**k*h - abs(F)*k**4 - 10*abs(F)*k**3 - 32*abs(F)*k**2 - 38*abs(F)*k -
    15*abs(F))**2/(8*pi*H*(k + 1)**2*(k + 3)**2*(k + 5)**2)

    Parameters
    ----------
    F : array_like
        Normal force [N].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

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
    chapter 11, equation (11.64); chapter 11, equation (11.66); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.adhesive import concave_quartic
    >>> value = concave_quartic.work_of_adhesion_from_pull_off(-0.7611, a=1.0, h=0.15, H=1.0, k=0.25)
    >>> round(value, 6)
    0.009998
    """
    require(a=a, h=h, H=H, k=k)
    return elementwise(_work_of_adhesion_from_pull_off, F=F, a=a, h=h, H=H, k=k)


def _pull_off_depth(a: Array, h: Array, H: Array, k: Array, dgamma: Array) -> Array:
    return -h * power_factor(4.0, k) - graded_retraction(a, H, k, dgamma)


def _pull_off_force(a: Array, h: Array, H: Array, k: Array, dgamma: Array) -> Array:
    return -punch_stiffness(a, H, k) * (
        h * power_factor(4.0, k) * 4.0 / (4.0 + 1.0 + k) + graded_retraction(a, H, k, dgamma)
    )


def _work_of_adhesion_from_pull_off(F: Array, a: Array, h: Array, H: Array, k: Array) -> Array:
    least = _pull_off_force(a, h, H, k, 0.0)
    return np.where(least >= F, separation(least - F, a, H, k), np.nan)
