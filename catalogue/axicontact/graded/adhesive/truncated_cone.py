"""Truncated cone with adhesion on a power-law graded half-space.

Flat face of radius b with a conical flank: a worn or blunted cone. The contact radius starts at b.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.punch import (
    graded_retraction,
    growth_of,
    held,
    least_steepness,
    pull_of,
    punch_displacement,
    punch_stiffness,
    separation,
    tension,
)
from ..._runtime.interface import Array, Kept, Result, elementwise, require, require_reach
from ..._runtime.physics.adhesion import PullOff, require_control
from ..._runtime.physics.branches import Branches, Samples, branches, exponent_of, lowest, radii_beyond, stress_at
from ..normal import truncated_cone as normal

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
    Valid for tan(theta) << 1. Negative or NaN radii give NaN. Handbook: truncated_cone.fgm.adh.Dl.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.adhesive import truncated_cone
    >>> value = truncated_cone.retraction(1.0, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    0.250663
    """
    require(H=H, k=k, dgamma=dgamma)
    return elementwise(graded_retraction, a, H=H, k=k, dgamma=dgamma)


def depth(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> Result:
    """Indentation depth at contact radius a; negative where adhesion pulls the surface up.

    d = a*tan(theta)*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2)/2 - sqrt(2)*sqrt(pi)*a**(1/2 -
    k/2)*sqrt(dgamma)/sqrt(H)
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN radii give NaN. Handbook: truncated_cone.fgm.adh.d.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.adhesive import truncated_cone
    >>> value = truncated_cone.depth(1.0, theta=0.42, b=0.5, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    0.121084
    """
    require(theta=theta, b=b, H=H, k=k, dgamma=dgamma)
    require_reach(a, b, "graded.normal.flat_punch")
    return elementwise(_depth, a, theta=theta, b=b, H=H, k=k, dgamma=dgamma)


def force(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> Result:
    """Normal force at contact radius a, negative in tension.

    F = -2*sqrt(2)*sqrt(pi)*sqrt(H)*a**(k/2 + 3/2)*sqrt(dgamma)/(k + 1) + H*(a**(k + 2)*IncompleteBeta(1 -
    b**2/a**2, (k + 1)/2, 1/2) + 2*b*(a**2 - b**2)**(k/2 + 1/2))*tan(theta)/((k + 1)*(k + 2))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN radii give NaN. Handbook: truncated_cone.fgm.adh.F.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.adhesive import truncated_cone
    >>> value = truncated_cone.force(1.0, theta=0.42, b=0.5, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    -0.004056
    """
    require(theta=theta, b=b, H=H, k=k, dgamma=dgamma)
    require_reach(a, b, "graded.normal.flat_punch")
    return elementwise(_force, a, theta=theta, b=b, H=H, k=k, dgamma=dgamma)


def pressure(
    r: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike
) -> Result:
    """Contact pressure, positive in compression, infinite tension at the edge; zero outside the contact.

    p = -sqrt(2)*sqrt(H)*a**(1/2 - k/2)*sqrt(dgamma)*(a**2 - r**2)**(k/2 - 1/2)/sqrt(pi) +
    H*Integral((b*(-b**2/(r**2 + u**(2/(k + 1))) + 1)**((k + 1)/2 - 1)*tan(theta)/sqrt(r**2 + u**(2/(k + 1)))
    + tan(theta)*IncompleteBeta(-b**2/(r**2 + u**(2/(k + 1))) + 1, (k + 1)/2, 1/2)/2)/sqrt(r**2 + u**(2/(k +
    1))), (u, (b**2 - r**2)**(k/2 + 1/2), (a**2 - r**2)**(k/2 + 1/2)))/(pi*(k + 1))   for r < b
    p = -sqrt(2)*sqrt(H)*a**(1/2 - k/2)*sqrt(dgamma)*(a**2 - r**2)**(k/2 - 1/2)/sqrt(pi) +
    H*Integral((b*(-b**2/(r**2 + u**(2/(k + 1))) + 1)**((k + 1)/2 - 1)*tan(theta)/sqrt(r**2 + u**(2/(k + 1)))
    + tan(theta)*IncompleteBeta(-b**2/(r**2 + u**(2/(k + 1))) + 1, (k + 1)/2, 1/2)/2)/sqrt(r**2 + u**(2/(k +
    1))), (u, 0, (a**2 - r**2)**(k/2 + 1/2)))/(pi*(k + 1))   for b < r
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN radii give NaN. Handbook: truncated_cone.fgm.adh.p.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.adhesive import truncated_cone
    >>> value = truncated_cone.pressure(0.3, 1.0, theta=0.42, b=0.5, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    0.088535
    """
    require(theta=theta, b=b, H=H, k=k, dgamma=dgamma)
    require_reach(a, b, "graded.normal.flat_punch")
    return elementwise(_pressure, r, a, theta=theta, b=b, H=H, k=k, dgamma=dgamma)


def displacement(
    r: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike
) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = -retraction*cos(pi*k/2)*IncompleteBeta(a**2/r**2, (k + 1)/2, (1 - k)/2)/pi +
    2*cos(pi*k/2)*Integral(t**k*(r**2 - t**2)**(-k/2 - 1/2)*(g(a) - g(t)), (t, 0, a))/pi
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN radii give NaN. Handbook: truncated_cone.fgm.adh.w.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.adhesive import truncated_cone
    >>> value = truncated_cone.displacement(2.0, 1.0, theta=0.42, b=0.5, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    -0.001984
    """
    require(theta=theta, b=b, H=H, k=k, dgamma=dgamma)
    require_reach(a, b, "graded.normal.flat_punch")
    return elementwise(_displacement, r, a, theta=theta, b=b, H=H, k=k, dgamma=dgamma)


def radius_from_depth(
    d: ArrayLike, *, theta: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike
) -> Result:
    """Contact radius at indentation depth d, on the branch that is stable under a given depth.

    a from a*tan(theta)*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2)/2 - sqrt(2)*sqrt(pi)*a**(1/2 -
    k/2)*sqrt(dgamma)/sqrt(H) = d
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. NaN below pull-off. Where several radii are stable, the largest, which is
    reached on unloading. Handbook: truncated_cone.fgm.adh.ad.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.adhesive import truncated_cone
    >>> value = truncated_cone.radius_from_depth(0.1211, theta=0.42, b=0.5, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    1.000031
    """
    require(theta=theta, b=b, H=H, k=k, dgamma=dgamma)
    return elementwise(_radius_from_depth, d=d, theta=theta, b=b, H=H, k=k, dgamma=dgamma)


def radius_from_force(
    F: ArrayLike, *, theta: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike
) -> Result:
    """Contact radius under the normal force F, on the branch that is stable under a given force.

    a from -2*sqrt(2)*sqrt(pi)*sqrt(H)*a**(k/2 + 3/2)*sqrt(dgamma)/(k + 1) + H*(a**(k + 2)*IncompleteBeta(1 -
    b**2/a**2, (k + 1)/2, 1/2) + 2*b*(a**2 - b**2)**(k/2 + 1/2))*tan(theta)/((k + 1)*(k + 2)) = F
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    F : array_like
        Normal force [N].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. NaN below pull-off. Where several radii are stable, the largest, which is
    reached on unloading. Handbook: truncated_cone.fgm.adh.aF.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.adhesive import truncated_cone
    >>> value = truncated_cone.radius_from_force(-0.004056, theta=0.42, b=0.5, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    0.999999
    """
    require(theta=theta, b=b, H=H, k=k, dgamma=dgamma)
    return elementwise(_radius_from_force, F=F, theta=theta, b=b, H=H, k=k, dgamma=dgamma)


def pull_off(
    control: str = "force", *, theta: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike
) -> PullOff:
    """State at which the contact breaks on unloading.

    At pull-off the retraction is 2 a g'(a)/xi, with the depth g(a) without adhesion, and

        a**((1 + k)/2)*g'(a) = xi*sqrt(pi*dgamma/(2*H))

    where xi = 3 + k under control of the force and 1 - k under control of the depth.

    Parameters
    ----------
    control : {"force", "depth"}
        What is held while the contact is unloaded.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    The least force, or depth, of a stable contact. Where it has several minima, or one at a corner of the
    profile, the lowest. Handbook: truncated_cone.fgm.adh.ac, truncated_cone.fgm.adh.am.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.adhesive import truncated_cone
    >>> state = truncated_cone.pull_off(theta=0.42, b=0.5, H=1.0, k=0.25, dgamma=0.01)
    >>> round(state.force, 6)
    -0.130028
    """
    require(theta=theta, b=b, H=H, k=k, dgamma=dgamma)
    require_control(control)
    radius = elementwise(partial(_pull_off_radius, control=control), theta=theta, b=b, H=H, k=k, dgamma=dgamma)
    force = elementwise(_force, radius, theta=theta, b=b, H=H, k=k, dgamma=dgamma)
    depth = elementwise(_depth, radius, theta=theta, b=b, H=H, k=k, dgamma=dgamma)
    return PullOff(radius, force, depth)


def work_of_adhesion_from_pull_off(
    F: ArrayLike, *, theta: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike
) -> Result:
    """Work of separation at which a contact breaks under the normal force F: the inverse of the force of pull_off.

    dgamma = a**(-k - 3)*(F_N + abs(F))**2*(k + 1)**2/(8*pi*H) at the radius a at which it is least, F_N the
    force without adhesion there

    Parameters
    ----------
    F : array_like
        Normal force [N].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. The force is a tension, F < 0: 0 without a force, NaN under pressure, which
    breaks no contact, and where no stable contact bears the tension.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.adhesive import truncated_cone
    >>> value = truncated_cone.work_of_adhesion_from_pull_off(-0.13, theta=0.42, b=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.009996
    """
    require(theta=theta, b=b, H=H, k=k)
    return elementwise(_work_of_adhesion_from_pull_off, F=F, theta=theta, b=b, H=H, k=k)


def _depth(a: Array, theta: Array, b: Array, H: Array, k: Array, dgamma: Array) -> Array:
    return normal._depth(a, theta, b, k) - graded_retraction(a, H, k, dgamma)


def _force(a: Array, theta: Array, b: Array, H: Array, k: Array, dgamma: Array) -> Array:
    return normal._force(a, theta, b, H, k) - punch_stiffness(a, H, k) * graded_retraction(a, H, k, dgamma)


def _pressure(r: Array, a: Array, theta: Array, b: Array, H: Array, k: Array, dgamma: Array) -> Array:
    return normal._pressure(r, a, theta, b, H, k) - tension(r, a, H, k, dgamma)


def _displacement(r: Array, a: Array, theta: Array, b: Array, H: Array, k: Array, dgamma: Array) -> Array:
    return normal._displacement(r, a, theta, b, k) - graded_retraction(a, H, k, dgamma) * punch_displacement(r, a, k)


@Kept
def _samples(theta: Array, b: Array, k: Array) -> Samples:
    """The steepness at radii that separate the minima of the load."""
    a = radii_beyond(b)
    return Samples(a, a ** ((1.0 + k) / 2.0) * normal._rate(a, theta, b, k), np.inf, {})


def _branches(theta: Array, b: Array, H: Array, k: Array, dgamma: Array, control: str) -> Branches:
    return branches(
        lambda a: a ** ((1.0 + k) / 2.0) * normal._rate(a, theta, b, k),
        _samples(theta, b, k),
        least_steepness(control, H, k, dgamma),
    )


def _pull_off_radius(theta: Array, b: Array, H: Array, k: Array, dgamma: Array, control: str) -> Array:
    unit = exponent_of(b)
    stress, H = stress_at(unit, H, k)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    found = _branches(theta, b, H, k, dgamma, control)
    load = _force if control == "force" else _depth
    radius = lowest(found, lambda a: load(a, theta, b, H, k, dgamma))
    return np.ldexp(radius, unit)


def _radius_from_depth(d: Array, theta: Array, b: Array, H: Array, k: Array, dgamma: Array) -> Array:
    from ..._runtime.physics.stable import stable_radius
    from ..._runtime.physics.unknowns import beyond_edge, radius_itself

    unit = exponent_of(b)
    stress, H = stress_at(unit, H, k)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    d = np.ldexp(d, -unit)
    found = _branches(theta, b, H, k, dgamma, control="depth")
    slope = growth_of(normal._rate, (theta, b, k), H, k, dgamma, control="depth")
    pulled = pull_of(H, k, dgamma, control="depth")
    radius = stable_radius(
        d, found, lambda a: _depth(a, theta, b, H, k, dgamma), slope, pulled, radius_itself(), beyond_edge(b, 1.0 + k)
    )
    return np.ldexp(radius, unit)


def _radius_from_force(F: Array, theta: Array, b: Array, H: Array, k: Array, dgamma: Array) -> Array:
    from ..._runtime.physics.stable import stable_radius
    from ..._runtime.physics.unknowns import beyond_edge, radius_itself

    unit = exponent_of(b)
    stress, H = stress_at(unit, H, k)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    F = np.ldexp(F, -(stress + 2 * unit))
    found = _branches(theta, b, H, k, dgamma, control="force")
    slope = growth_of(normal._rate, (theta, b, k), H, k, dgamma, control="force")
    pulled = pull_of(H, k, dgamma, control="force")
    radius = stable_radius(
        F, found, lambda a: _force(a, theta, b, H, k, dgamma), slope, pulled, radius_itself(), beyond_edge(b, 1.0 + k)
    )
    return np.ldexp(radius, unit)


@Kept
def _held_samples(theta: Array, b: Array, k: Array) -> Samples:
    """The force that can be held, over the modulus, at radii that separate the minima of the work of separation."""
    a = radii_beyond(b)
    return Samples(a, held(a, normal._rate(a, theta, b, k), normal._force(a, theta, b, 1.0, k), k), np.inf, {})


def _work_of_adhesion_from_pull_off(F: Array, theta: Array, b: Array, H: Array, k: Array) -> Array:
    unit = exponent_of(b)
    stress, H = stress_at(unit, H, k)
    b = np.ldexp(b, -unit)
    F = np.ldexp(F, -(stress + 2 * unit))
    pull = np.where(F < 0.0, -F, np.nan)
    found = branches(
        lambda a: held(a, normal._rate(a, theta, b, k), normal._force(a, theta, b, 1.0, k), k),
        _held_samples(theta, b, k),
        pull / H,
    )
    a = lowest(found, lambda a: separation(pull + normal._force(a, theta, b, H, k), a, H, k))
    work = separation(pull + normal._force(a, theta, b, H, k), a, H, k)
    return np.where(F == 0.0, 0.0, np.ldexp(work, stress + unit))
