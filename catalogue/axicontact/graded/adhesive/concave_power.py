"""Concave power law with adhesion on a power-law graded half-space.

Concave face of depth h; complete contact needs the force F_min.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.growth import power_factor
from ..._runtime.graded.punch import graded_retraction, punch_stiffness, separation
from ..._runtime.interface import Array, Result, elementwise, require, require_order
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
    Valid for small slopes; complete contact only. Handbook: concave_power.fgm.adh.Dl.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.adhesive import concave_power
    >>> value = concave_power.retraction(a=1.0, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    0.250663
    """
    require(a=a, H=H, k=k, dgamma=dgamma)
    return elementwise(graded_retraction, a=a, H=H, k=k, dgamma=dgamma)


def pull_off(
    control: str = "force", *, a: ArrayLike, h: ArrayLike, n: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike
) -> PullOff:
    """State at which the edge peels off, and with it the whole face.

    F = -2*sqrt(2)*sqrt(pi)*sqrt(H)*a**(k/2 + 3/2)*sqrt(dgamma)/(k + 1) - 2*H*a**(k + 1)*h*n*gamma(k/2 +
    1/2)*gamma(n/2 + 1)/((k + 1)*(k + n + 1)*gamma(k/2 + n/2 + 1/2))
    d = -h*gamma((k + 1)/2)*gamma(n/2 + 1)/gamma((k + n + 1)/2) - sqrt(2)*sqrt(pi)*a**(1/2 -
    k/2)*sqrt(dgamma)/sqrt(H)

    Parameters
    ----------
    control : {"force", "depth"}
        What is held while the contact is unloaded; the state is the same.
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    concave_power.fgm.adh.Fc, concave_power.fgm.adh.dc.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Barber 1976; Schubert 1942; Kendall 1971.

    Examples
    --------
    >>> from axicontact.graded.adhesive import concave_power
    >>> state = concave_power.pull_off(a=1.0, h=0.15, n=3.0, H=1.0, k=0.25, dgamma=0.01)
    >>> round(state.force, 6)
    -0.705991
    """
    require(a=a, h=h, n=n, H=H, k=k, dgamma=dgamma)
    require_order(
        np.asarray(n) > 1.0 - np.asarray(k),
        "n > 1 - k",
        "a sharper dimple never reaches complete contact at a finite load; use n > 1 - k",
        n=n,
        k=k,
    )
    require_control(control)
    depth = elementwise(_pull_off_depth, a=a, h=h, n=n, H=H, k=k, dgamma=dgamma)
    force = elementwise(_pull_off_force, a=a, h=h, n=n, H=H, k=k, dgamma=dgamma)
    return PullOff(depth * 0.0 + a, force, depth)


def work_of_adhesion_from_pull_off(
    F: ArrayLike, *, a: ArrayLike, h: ArrayLike, n: ArrayLike, H: ArrayLike, k: ArrayLike
) -> Result:
    """Work of separation at which a contact breaks under the normal force F: the inverse of the force of pull_off.

    dgamma = a**(-k - 3)*(2*H*a*a**k*h*n*gamma(k/2 + 1/2)*gamma(n/2 + 1) - abs(F)*k**2*gamma(k/2 + n/2 + 1/2)
    - abs(F)*k*n*gamma(k/2 + n/2 + 1/2) - 2*abs(F)*k*gamma(k/2 + n/2 + 1/2) - abs(F)*n*gamma(k/2 + n/2 + 1/2)
    - abs(F)*gamma(k/2 + n/2 + 1/2))**2/(8*pi*H*(k + n + 1)**2*gamma(k/2 + n/2 + 1/2)**2)

    Parameters
    ----------
    F : array_like
        Normal force [N].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    chapter 11, equation (11.64); chapter 11, equation (11.66); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.adhesive import concave_power
    >>> value = concave_power.work_of_adhesion_from_pull_off(-0.706, a=1.0, h=0.15, n=3.0, H=1.0, k=0.25)
    >>> round(value, 6)
    0.01
    """
    require(a=a, h=h, n=n, H=H, k=k)
    require_order(
        np.asarray(n) > 1.0 - np.asarray(k),
        "n > 1 - k",
        "a sharper dimple never reaches complete contact at a finite load; use n > 1 - k",
        n=n,
        k=k,
    )
    return elementwise(_work_of_adhesion_from_pull_off, F=F, a=a, h=h, n=n, H=H, k=k)


def _pull_off_depth(a: Array, h: Array, n: Array, H: Array, k: Array, dgamma: Array) -> Array:
    return -h * power_factor(n, k) - graded_retraction(a, H, k, dgamma)


def _pull_off_force(a: Array, h: Array, n: Array, H: Array, k: Array, dgamma: Array) -> Array:
    return -punch_stiffness(a, H, k) * (h * power_factor(n, k) * n / (n + 1.0 + k) + graded_retraction(a, H, k, dgamma))


def _work_of_adhesion_from_pull_off(F: Array, a: Array, h: Array, n: Array, H: Array, k: Array) -> Array:
    least = _pull_off_force(a, h, n, H, k, 0.0)
    return np.where(least >= F, separation(least - F, a, H, k), np.nan)
