"""Sextic profile with adhesion on a power-law graded half-space.

Flatter at the tip than the quartic: most of the load is carried near the rim of the contact.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.punch import (
    graded_retraction,
    punch_displacement,
    punch_stiffness,
    separation,
    stationary,
    tension,
    unloading_radius,
)
from ..._runtime.interface import Array, Result, elementwise, require
from ..._runtime.physics.adhesion import PullOff, power_law_radius, require_control
from ..normal import sextic as normal

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


def retraction(a: ArrayLike, *, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> Result:
    """Retraction of the indenter from the state without adhesion, at constant contact radius.

    retraction = sqrt(2)*sqrt(pi)*a**(1/2 - k/2)*sqrt(dgamma)/sqrt(H)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
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
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN radii give NaN. Handbook: sextic.fgm.adh.Dl.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.adhesive import sextic
    >>> value = sextic.retraction(1.0, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    0.250663
    """
    require(H=H, k=k, dgamma=dgamma)
    return elementwise(graded_retraction, a, H=H, k=k, dgamma=dgamma)


def depth(a: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> Result:
    """Indentation depth at contact radius a; negative where adhesion pulls the surface up.

    d = 48*A*a**6/((k + 1)*(k + 3)*(k + 5)) - sqrt(2)*sqrt(pi)*a**(1/2 - k/2)*sqrt(dgamma)/sqrt(H)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
        Indentation depth of the point r = 0 [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN radii give NaN. Handbook: sextic.fgm.adh.d.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.adhesive import sextic
    >>> value = sextic.depth(1.0, A=0.4, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    0.649557
    """
    require(A=A, H=H, k=k, dgamma=dgamma)
    return elementwise(_depth, a, A=A, H=H, k=k, dgamma=dgamma)


def force(a: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> Result:
    """Normal force at contact radius a, negative in tension.

    F = 576*A*H*a**(k + 7)/((k + 1)**2*(k + 3)*(k + 5)*(k + 7)) - 2*sqrt(2)*sqrt(pi)*sqrt(H)*a**(k/2 +
    3/2)*sqrt(dgamma)/(k + 1)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
        Normal force [N]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN radii give NaN. Handbook: sextic.fgm.adh.F.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.adhesive import sextic
    >>> value = sextic.force(1.0, A=0.4, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    0.790955
    """
    require(A=A, H=H, k=k, dgamma=dgamma)
    return elementwise(_force, a, A=A, H=H, k=k, dgamma=dgamma)


def pressure(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact pressure, positive in compression, infinite tension at the edge; zero outside the contact.

    p = 288*A*H*(a**2 - r**2)**(k/2 + 1/2)*(a**4*k**2 + 4*a**4*k + 3*a**4 + 4*a**2*k*r**2 + 4*a**2*r**2 +
    8*r**4)/(pi*(k + 1)**2*(k + 3)**2*(k + 5)**2) - sqrt(2)*sqrt(H)*a**(1/2 - k/2)*sqrt(dgamma)*(a**2 -
    r**2)**(k/2 - 1/2)/sqrt(pi)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
        Contact pressure, positive in compression [Pa]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN radii give NaN. Handbook: sextic.fgm.adh.p.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.adhesive import sextic
    >>> value = sextic.pressure(0.3, 1.0, A=0.4, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    0.265202
    """
    require(A=A, H=H, k=k, dgamma=dgamma)
    return elementwise(_pressure, r, a, A=A, H=H, k=k, dgamma=dgamma)


def displacement(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 48*A*(a**6*IncompleteBeta(a**2/r**2, (k + 1)/2, (1 - k)/2) - r**6*IncompleteBeta(a**2/r**2, (k + 7)/2,
    (1 - k)/2))*cos(pi*k/2)/(pi*(k + 1)*(k + 3)*(k + 5)) - sqrt(2)*a**(1/2 -
    k/2)*sqrt(dgamma)*cos(pi*k/2)*IncompleteBeta(a**2/r**2, (k + 1)/2, (1 - k)/2)/(sqrt(pi)*sqrt(H))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
        Surface displacement into the half-space [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes, 6 A a^5 << 1. Negative or NaN radii give NaN. Handbook: sextic.fgm.adh.w.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.adhesive import sextic
    >>> value = sextic.displacement(2.0, 1.0, A=0.4, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    0.102145
    """
    require(A=A, H=H, k=k, dgamma=dgamma)
    return elementwise(_displacement, r, a, A=A, H=H, k=k, dgamma=dgamma)


def radius_from_depth(d: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact radius at indentation depth d, on the branch that is stable under a given depth.

    a from 48*A*a**6/((k + 1)*(k + 3)*(k + 5)) - sqrt(2)*sqrt(pi)*a**(1/2 - k/2)*sqrt(dgamma)/sqrt(H) = d

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
        Contact radius [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes, 6 A a^5 << 1. NaN below pull-off. Handbook: sextic.fgm.adh.ad.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.adhesive import sextic
    >>> value = sextic.radius_from_depth(0.6496, A=0.4, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    1.000008
    """
    require(A=A, H=H, k=k, dgamma=dgamma)
    return elementwise(_radius_from_depth, d=d, A=A, H=H, k=k, dgamma=dgamma)


def radius_from_force(F: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact radius under the normal force F, on the branch that is stable under a given force.

    a from 576*A*H*a**(k + 7)/((k + 1)**2*(k + 3)*(k + 5)*(k + 7)) - 2*sqrt(2)*sqrt(pi)*sqrt(H)*a**(k/2 +
    3/2)*sqrt(dgamma)/(k + 1) = F

    Parameters
    ----------
    F : array_like
        Normal force [N].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
        Contact radius [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes, 6 A a^5 << 1. NaN below pull-off. Handbook: sextic.fgm.adh.aF.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.adhesive import sextic
    >>> value = sextic.radius_from_force(0.791, A=0.4, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    1.000006
    """
    require(A=A, H=H, k=k, dgamma=dgamma)
    return elementwise(_radius_from_force, F=F, A=A, H=H, k=k, dgamma=dgamma)


def pull_off(control: str = "force", *, A: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> PullOff:
    """State at which the contact breaks on unloading.

    At pull-off the retraction is 2 a g'(a)/xi, with the depth g(a) without adhesion, and

        a**((1 + k)/2)*g'(a) = xi*sqrt(pi*dgamma/(2*H))

    where xi = 3 + k under control of the force and 1 - k under control of the depth.

    Parameters
    ----------
    control : {"force", "depth"}
        What is held while the contact is unloaded.
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
        Named tuple of radius [m], force [N] and depth [m]; NaN without a stable contact.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    The least force, or depth, of a stable contact. Handbook: sextic.fgm.adh.ac, sextic.fgm.adh.am.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.adhesive import sextic
    >>> state = sextic.pull_off(A=0.4, H=1.0, k=0.25, dgamma=0.01)
    >>> round(state.force, 6)
    -0.147469
    """
    require(A=A, H=H, k=k, dgamma=dgamma)
    require_control(control)
    radius = elementwise(partial(_pull_off_radius, control=control), A=A, H=H, k=k, dgamma=dgamma)
    force = elementwise(partial(_pull_off_force, control=control), radius, A=A, H=H, k=k, dgamma=dgamma)
    depth = elementwise(partial(_pull_off_depth, control=control), radius, A=A, H=H, k=k, dgamma=dgamma)
    return PullOff(radius, force, depth)


def work_of_adhesion_from_pull_off(F: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Work of separation at which a contact breaks under the normal force F: the inverse of the force of pull_off.

    dgamma = abs(F)**2*(abs(F)*(k + 1)**2*(k + 3)**2*(k + 5)*(k + 7)/(576*A*H*(k + 11)))**((-k - 3)/(k +
    7))*(k + 1)**2*(k + 7)**2/(2*pi*H*(k + 11)**2)

    Parameters
    ----------
    F : array_like
        Normal force [N].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 6 A a^5 << 1. The force is a tension, F < 0: 0 without a force, NaN under
    pressure, which breaks no contact, and where no stable contact bears the tension.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.adhesive import sextic
    >>> value = sextic.work_of_adhesion_from_pull_off(-0.1475, A=0.4, H=1.0, k=0.25)
    >>> round(value, 6)
    0.010003
    """
    require(A=A, H=H, k=k)
    return elementwise(_work_of_adhesion_from_pull_off, F=F, A=A, H=H, k=k)


def _depth(a: Array, A: Array, H: Array, k: Array, dgamma: Array) -> Array:
    return normal._depth(a, A, k) - graded_retraction(a, H, k, dgamma)


def _force(a: Array, A: Array, H: Array, k: Array, dgamma: Array) -> Array:
    return normal._force(a, A, H, k) - punch_stiffness(a, H, k) * graded_retraction(a, H, k, dgamma)


def _pressure(r: Array, a: Array, A: Array, H: Array, k: Array, dgamma: Array) -> Array:
    return normal._pressure(r, a, A, H, k) - tension(r, a, H, k, dgamma)


def _displacement(r: Array, a: Array, A: Array, H: Array, k: Array, dgamma: Array) -> Array:
    return normal._displacement(r, a, A, k) - graded_retraction(a, H, k, dgamma) * punch_displacement(r, a, k)


def _pull_off_radius(A: Array, H: Array, k: Array, dgamma: Array, control: str) -> Array:
    rate = normal._rate(np.ones_like(H * k), A, k)
    own = unloading_radius(rate, 6.0, H, k, dgamma, control)
    return np.where(dgamma > 0.0, own, 0.0)


def _pull_off_depth(a: Array, A: Array, H: Array, k: Array, dgamma: Array, control: str) -> Array:
    """With the retraction 2 a g'(a)/xi of pull-off, free of cancellation."""
    return normal._depth(a, A, k) * (1.0 - 2.0 * 6.0 / stationary(control, k))


def _radius_from_depth(d: Array, A: Array, H: Array, k: Array, dgamma: Array) -> Array:
    a_c = _pull_off_radius(A, H, k, dgamma, control="depth")
    least = _pull_off_depth(a_c, A, H, k, dgamma, control="depth")
    plain = normal._radius_from_depth(np.maximum(d, 0.0), A, k)
    return power_law_radius(d, a_c, least, 6.0, (1.0 - k) / 2.0, plain)


def _pull_off_force(a: Array, A: Array, H: Array, k: Array, dgamma: Array, control: str) -> Array:
    """With the retraction 2 a g'(a)/xi of pull-off, free of cancellation."""
    return normal._force(a, A, H, k) * (1.0 - 2.0 * (6.0 + 1.0 + k) / stationary(control, k))


def _radius_from_force(F: Array, A: Array, H: Array, k: Array, dgamma: Array) -> Array:
    a_c = _pull_off_radius(A, H, k, dgamma, control="force")
    least = _pull_off_force(a_c, A, H, k, dgamma, control="force")
    plain = normal._radius_from_force(np.maximum(F, 0.0), A, H, k)
    return power_law_radius(F, a_c, least, 6.0 + 1.0 + k, (3.0 + k) / 2.0, plain)


def _work_of_adhesion_from_pull_off(F: Array, A: Array, H: Array, k: Array) -> Array:
    pull = np.where(F < 0.0, -F, np.nan)
    lasting = pull * (k + 3) / (k + 11)
    a = normal._radius_from_force(lasting, A, H, k)
    return np.where(F == 0.0, 0.0, separation(pull + lasting, a, H, k))
