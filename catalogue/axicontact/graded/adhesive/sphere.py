"""Sphere with adhesion on a power-law graded half-space.

The exact spherical shape; differs from the paraboloid by terms of order a^2/R^2.
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
from ..._runtime.interface import Array, Kept, Result, elementwise, require
from ..._runtime.physics.adhesion import PullOff, require_control
from ..._runtime.physics.branches import Branches, Samples, branches, exponent_of, lowest, radii_below, stress_at
from ..normal import sphere as normal

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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN radii give NaN. Handbook:
    sphere.fgm.adh.Dl.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.adhesive import sphere
    >>> value = sphere.retraction(1.0, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    0.250663
    """
    require(H=H, k=k, dgamma=dgamma)
    return elementwise(graded_retraction, a, H=H, k=k, dgamma=dgamma)


def depth(a: ArrayLike, *, R: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> Result:
    """Indentation depth at contact radius a; negative where adhesion pulls the surface up.

    d = a**2*2F1(1/2, 1, (k + 3)/2, a**2/R**2)/(R*(k + 1)) - sqrt(2)*sqrt(pi)*a**(1/2 -
    k/2)*sqrt(dgamma)/sqrt(H)
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN radii give NaN. Handbook:
    sphere.fgm.adh.d.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.adhesive import sphere
    >>> value = sphere.depth(1.0, R=1.5, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    0.3828
    """
    require(R=R, H=H, k=k, dgamma=dgamma)
    return elementwise(_depth, a, R=R, H=H, k=k, dgamma=dgamma)


def force(a: ArrayLike, *, R: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> Result:
    """Normal force at contact radius a, negative in tension.

    F = -2*sqrt(2)*sqrt(pi)*sqrt(H)*a**(k/2 + 3/2)*sqrt(dgamma)/(k + 1) + 4*H*a**(k + 3)*2F1(1/2,
    2, (k + 5)/2, a**2/R**2)/(R*(k + 1)**2*(k + 3))
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN radii give NaN. Handbook:
    sphere.fgm.adh.F.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.adhesive import sphere
    >>> value = sphere.force(1.0, R=1.5, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    0.249661
    """
    require(R=R, H=H, k=k, dgamma=dgamma)
    return elementwise(_force, a, R=R, H=H, k=k, dgamma=dgamma)


def pressure(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact pressure, positive in compression, infinite tension at the edge; zero outside the contact.

    p = -H*retraction*(a**2 - r**2)**(k/2 - 1/2)/pi + H*Integral((-r**2 + t**2)**(k/2 - 1/2)*Derivative(g(t),
    t), (t, r, a))/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN radii give NaN. Handbook:
    sphere.fgm.adh.p.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.adhesive import sphere
    >>> value = sphere.pressure(0.3, 1.0, R=1.5, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    0.214559
    """
    require(R=R, H=H, k=k, dgamma=dgamma)
    return elementwise(_pressure, r, a, R=R, H=H, k=k, dgamma=dgamma)


def displacement(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*cos(pi*k/2)*Integral((a**2*2F1(1/2, 1, (k + 3)/2, a**2/R**2)/(R*(k + 1)) -
    r**2*sin(psi)**2*2F1(1/2, 1, (k + 3)/2, r**2*sin(psi)**2/R**2)/(R*(k + 1)))*tan(psi)**k, (psi,
    0, asin(a/r)))/pi - sqrt(2)*a**(1/2 - k/2)*sqrt(dgamma)*cos(pi*k/2)*IncompleteBeta(a**2/r**2, (k + 1)/2,
    (1 - k)/2)/(sqrt(pi)*sqrt(H))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN radii give NaN. Handbook:
    sphere.fgm.adh.w.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.adhesive import sphere
    >>> value = sphere.displacement(2.0, 1.0, R=1.5, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    0.030888
    """
    require(R=R, H=H, k=k, dgamma=dgamma)
    return elementwise(_displacement, r, a, R=R, H=H, k=k, dgamma=dgamma)


def radius_from_depth(d: ArrayLike, *, R: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact radius at indentation depth d, on the branch that is stable under a given depth.

    a from a**2*2F1(1/2, 1, (k + 3)/2, a**2/R**2)/(R*(k + 1)) - sqrt(2)*sqrt(pi)*a**(1/2 -
    k/2)*sqrt(dgamma)/sqrt(H) = d
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a < R; the theory of small slopes asks for a << R. NaN below pull-off. Where several radii are
    stable, the largest, which is reached on unloading. Handbook: sphere.fgm.adh.ad.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.adhesive import sphere
    >>> value = sphere.radius_from_depth(0.3828, R=1.5, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    1.0
    """
    require(R=R, H=H, k=k, dgamma=dgamma)
    return elementwise(_radius_from_depth, d=d, R=R, H=H, k=k, dgamma=dgamma)


def radius_from_force(F: ArrayLike, *, R: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact radius under the normal force F, on the branch that is stable under a given force.

    a from -2*sqrt(2)*sqrt(pi)*sqrt(H)*a**(k/2 + 3/2)*sqrt(dgamma)/(k + 1) + 4*H*a**(k +
    3)*2F1(1/2, 2, (k + 5)/2, a**2/R**2)/(R*(k + 1)**2*(k + 3)) = F
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a < R; the theory of small slopes asks for a << R. NaN below pull-off. Where several radii are
    stable, the largest, which is reached on unloading. Handbook: sphere.fgm.adh.aF.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.adhesive import sphere
    >>> value = sphere.radius_from_force(0.2497, R=1.5, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    1.000021
    """
    require(R=R, H=H, k=k, dgamma=dgamma)
    return elementwise(_radius_from_force, F=F, R=R, H=H, k=k, dgamma=dgamma)


def pull_off(control: str = "force", *, R: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> PullOff:
    """State at which the contact breaks on unloading.

    At pull-off the retraction is 2 a g'(a)/xi, with the depth g(a) without adhesion, and

        a**((1 + k)/2)*g'(a) = xi*sqrt(pi*dgamma/(2*H))

    where xi = 3 + k under control of the force and 1 - k under control of the depth.

    Parameters
    ----------
    control : {"force", "depth"}
        What is held while the contact is unloaded.
    R : array_like
        Radius of curvature [m], R > 0.
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
    profile, the lowest. Handbook: sphere.fgm.adh.ac, sphere.fgm.adh.am.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.adhesive import sphere
    >>> state = sphere.pull_off(R=1.5, H=1.0, k=0.25, dgamma=0.01)
    >>> round(state.force, 6)
    -0.072805
    """
    require(R=R, H=H, k=k, dgamma=dgamma)
    require_control(control)
    radius = elementwise(partial(_pull_off_radius, control=control), R=R, H=H, k=k, dgamma=dgamma)
    force = elementwise(_force, radius, R=R, H=H, k=k, dgamma=dgamma)
    depth = elementwise(_depth, radius, R=R, H=H, k=k, dgamma=dgamma)
    return PullOff(radius, force, depth)


def work_of_adhesion_from_pull_off(F: ArrayLike, *, R: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Work of separation at which a contact breaks under the normal force F: the inverse of the force of pull_off.

    dgamma = a**(-k - 3)*(F_N + abs(F))**2*(k + 1)**2/(8*pi*H) at the radius a at which it is least, F_N the
    force without adhesion there

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a < R; the theory of small slopes asks for a << R. The force is a tension, F < 0: 0 without a
    force, NaN under pressure, which breaks no contact, and where no stable contact bears the tension.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.adhesive import sphere
    >>> value = sphere.work_of_adhesion_from_pull_off(-0.07281, R=1.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.010001
    """
    require(R=R, H=H, k=k)
    return elementwise(_work_of_adhesion_from_pull_off, F=F, R=R, H=H, k=k)


def _depth(a: Array, R: Array, H: Array, k: Array, dgamma: Array) -> Array:
    return normal._depth(a, R, k) - graded_retraction(a, H, k, dgamma)


def _force(a: Array, R: Array, H: Array, k: Array, dgamma: Array) -> Array:
    return normal._force(a, R, H, k) - punch_stiffness(a, H, k) * graded_retraction(a, H, k, dgamma)


def _pressure(r: Array, a: Array, R: Array, H: Array, k: Array, dgamma: Array) -> Array:
    return normal._pressure(r, a, R, H, k) - tension(r, a, H, k, dgamma)


def _displacement(r: Array, a: Array, R: Array, H: Array, k: Array, dgamma: Array) -> Array:
    return normal._displacement(r, a, R, k) - graded_retraction(a, H, k, dgamma) * punch_displacement(r, a, k)


@Kept
def _samples(R: Array, k: Array) -> Samples:
    """The steepness at radii that separate the minima of the load."""
    a = radii_below(R)
    return Samples(a, a ** ((1.0 + k) / 2.0) * normal._rate(a, R, k), a[-1], {})


def _branches(R: Array, H: Array, k: Array, dgamma: Array, control: str) -> Branches:
    return branches(
        lambda a: a ** ((1.0 + k) / 2.0) * normal._rate(a, R, k), _samples(R, k), least_steepness(control, H, k, dgamma)
    )


def _pull_off_radius(R: Array, H: Array, k: Array, dgamma: Array, control: str) -> Array:
    unit = exponent_of(R)
    stress, H = stress_at(unit, H, k)
    R = np.ldexp(R, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    found = _branches(R, H, k, dgamma, control)
    load = _force if control == "force" else _depth
    radius = lowest(found, lambda a: load(a, R, H, k, dgamma))
    return np.ldexp(radius, unit)


def _radius_from_depth(d: Array, R: Array, H: Array, k: Array, dgamma: Array) -> Array:
    from ..._runtime.physics.stable import stable_radius
    from ..._runtime.physics.unknowns import up_to

    unit = exponent_of(R)
    stress, H = stress_at(unit, H, k)
    R = np.ldexp(R, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    d = np.ldexp(d, -unit)
    found = _branches(R, H, k, dgamma, control="depth")
    slope = growth_of(normal._rate, (R, k), H, k, dgamma, control="depth")
    pulled = pull_of(H, k, dgamma, control="depth")
    radius = stable_radius(d, found, lambda a: _depth(a, R, H, k, dgamma), slope, pulled, up_to(R, k))
    return np.ldexp(radius, unit)


def _radius_from_force(F: Array, R: Array, H: Array, k: Array, dgamma: Array) -> Array:
    from ..._runtime.physics.stable import stable_radius
    from ..._runtime.physics.unknowns import up_to

    unit = exponent_of(R)
    stress, H = stress_at(unit, H, k)
    R = np.ldexp(R, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    F = np.ldexp(F, -(stress + 2 * unit))
    found = _branches(R, H, k, dgamma, control="force")
    slope = growth_of(normal._rate, (R, k), H, k, dgamma, control="force")
    pulled = pull_of(H, k, dgamma, control="force")
    radius = stable_radius(F, found, lambda a: _force(a, R, H, k, dgamma), slope, pulled, up_to(R, k))
    return np.ldexp(radius, unit)


@Kept
def _held_samples(R: Array, k: Array) -> Samples:
    """The force that can be held, over the modulus, at radii that separate the minima of the work of separation."""
    a = radii_below(R)
    return Samples(a, held(a, normal._rate(a, R, k), normal._force(a, R, 1.0, k), k), a[-1], {})


def _work_of_adhesion_from_pull_off(F: Array, R: Array, H: Array, k: Array) -> Array:
    unit = exponent_of(R)
    stress, H = stress_at(unit, H, k)
    R = np.ldexp(R, -unit)
    F = np.ldexp(F, -(stress + 2 * unit))
    pull = np.where(F < 0.0, -F, np.nan)
    found = branches(
        lambda a: held(a, normal._rate(a, R, k), normal._force(a, R, 1.0, k), k), _held_samples(R, k), pull / H
    )
    a = lowest(found, lambda a: separation(pull + normal._force(a, R, H, k), a, H, k))
    work = separation(pull + normal._force(a, R, H, k), a, H, k)
    return np.where(F == 0.0, 0.0, np.ldexp(work, stress + unit))
