"""Truncated cone with adhesion.

Flat face of radius b with a conical flank: a worn or blunted cone. The contact radius starts at b.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Kept, Result, elementwise, require, require_reach
from .._runtime.physics.adhesion import (
    PullOff,
    held,
    hess_retraction,
    least_steepness,
    lift,
    pull,
    require_control,
    separation,
    tension,
)
from .._runtime.physics.branches import Branches, Samples, branches, exponent_of, lowest, radii_beyond
from .._runtime.physics.stable import growth, stable_radius
from .._runtime.physics.unknowns import beyond_edge, radius_itself
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
    Valid for tan(theta) << 1. Negative or NaN radii give NaN. Handbook: truncated_cone.adh.Dl.

    References
    ----------
    chapter 11, equation (11.31); Ejike 1981.

    Examples
    --------
    >>> from axicontact.adhesive import truncated_cone
    >>> value = truncated_cone.retraction(1.0, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.250663
    """
    require(E_star=E_star, dgamma=dgamma)
    return elementwise(hess_retraction, a, E_star=E_star, dgamma=dgamma)


def depth(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Indentation depth at contact radius a; negative where adhesion pulls the surface up.

    d = a*tan(theta)*acos(b/a) - sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN radii give NaN. Handbook: truncated_cone.adh.d.

    References
    ----------
    chapter 11, equation (11.31); Ejike 1981.

    Examples
    --------
    >>> from axicontact.adhesive import truncated_cone
    >>> value = truncated_cone.depth(1.0, theta=0.42, b=0.5, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.216987
    """
    require(theta=theta, b=b, E_star=E_star, dgamma=dgamma)
    require_reach(a, b)
    return elementwise(_depth, a, theta=theta, b=b, E_star=E_star, dgamma=dgamma)


def force(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Normal force at contact radius a, negative in tension.

    F = -2*sqrt(2)*sqrt(pi)*sqrt(E_star)*a**(3/2)*sqrt(dgamma) + E_star*(a**2*acos(b/a) + b*sqrt(a**2 -
    b**2))*tan(theta)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN radii give NaN. Handbook: truncated_cone.adh.F.

    References
    ----------
    chapter 11, equation (11.31); Ejike 1981.

    Examples
    --------
    >>> from axicontact.adhesive import truncated_cone
    >>> value = truncated_cone.force(1.0, theta=0.42, b=0.5, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.159696
    """
    require(theta=theta, b=b, E_star=E_star, dgamma=dgamma)
    require_reach(a, b)
    return elementwise(_force, a, theta=theta, b=b, E_star=E_star, dgamma=dgamma)


def pressure(
    r: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike
) -> Result:
    """Contact pressure, positive in compression, infinite tension at the edge; zero outside the contact.

    p = -sqrt(2)*sqrt(E_star)*sqrt(a)*sqrt(dgamma)/(sqrt(pi)*sqrt(a**2 - r**2)) + E_star*(C0(b, r, a) +
    elliptic_f(asin(sqrt((a**2 - b**2)/(a**2 - r**2))), r**2/b**2))*tan(theta)/pi   for r < b
    p = -sqrt(2)*sqrt(E_star)*sqrt(a)*sqrt(dgamma)/(sqrt(pi)*sqrt(a**2 - r**2)) +
    E_star*(b*elliptic_f(asin(sqrt((a**2 - r**2)/(a**2 - b**2))), b**2/r**2)/r + C0(b, r, a))*tan(theta)/pi
    for b < r
    with C0(b, r, a) = int_{max(b, r)}^a acos(b/t) / sqrt(t**2 - r**2) dt, for 0 <= b, r < a
    with elliptic integrals of the parameter m = k**2, their last argument

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
    Valid for tan(theta) << 1. Negative or NaN radii give NaN. Handbook: truncated_cone.adh.p.

    References
    ----------
    chapter 11, equation (11.31); Ejike 1981.

    Examples
    --------
    >>> from axicontact.adhesive import truncated_cone
    >>> value = truncated_cone.pressure(0.3, 1.0, theta=0.42, b=0.5, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.168945
    """
    require(theta=theta, b=b, E_star=E_star, dgamma=dgamma)
    require_reach(a, b)
    return elementwise(_pressure, r, a, theta=theta, b=b, E_star=E_star, dgamma=dgamma)


def displacement(
    r: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike
) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*(a*acos(b/a)*asin(a/r) + b*asin(sqrt((a**2 - b**2)/(-b**2 + r**2))) - r*acos(b*sqrt(-a**2 +
    r**2)/(a*sqrt(-b**2 + r**2))) + sqrt(-a**2 + r**2)*acos(b/a))*tan(theta)/pi -
    2*sqrt(2)*sqrt(a)*sqrt(dgamma)*asin(a/r)/(sqrt(pi)*sqrt(E_star))

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
    Valid for tan(theta) << 1. Negative or NaN radii give NaN. Handbook: truncated_cone.adh.w.

    References
    ----------
    chapter 11, equation (11.31); Ejike 1981.

    Examples
    --------
    >>> from axicontact.adhesive import truncated_cone
    >>> value = truncated_cone.displacement(2.0, 1.0, theta=0.42, b=0.5, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.024375
    """
    require(theta=theta, b=b, E_star=E_star, dgamma=dgamma)
    require_reach(a, b)
    return elementwise(_displacement, r, a, theta=theta, b=b, E_star=E_star, dgamma=dgamma)


def radius_from_depth(d: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact radius at indentation depth d, on the branch that is stable under a given depth.

    a from a*tan(theta)*acos(b/a) - sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star) = d

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. NaN below pull-off. Where several radii are stable, the largest, which is
    reached on unloading. Handbook: truncated_cone.adh.ad.

    References
    ----------
    chapter 11, equation (11.31); Ejike 1981.

    Examples
    --------
    >>> from axicontact.adhesive import truncated_cone
    >>> value = truncated_cone.radius_from_depth(0.217, theta=0.42, b=0.5, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    1.000022
    """
    require(theta=theta, b=b, E_star=E_star, dgamma=dgamma)
    return elementwise(_radius_from_depth, d=d, theta=theta, b=b, E_star=E_star, dgamma=dgamma)


def radius_from_force(F: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact radius under the normal force F, on the branch that is stable under a given force.

    a from -2*sqrt(2)*sqrt(pi)*sqrt(E_star)*a**(3/2)*sqrt(dgamma) + E_star*(a**2*acos(b/a) + b*sqrt(a**2 -
    b**2))*tan(theta) = F

    Parameters
    ----------
    F : array_like
        Normal force [N].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. NaN below pull-off. Where several radii are stable, the largest, which is
    reached on unloading. Handbook: truncated_cone.adh.aF.

    References
    ----------
    chapter 11, equation (11.31); Ejike 1981.

    Examples
    --------
    >>> from axicontact.adhesive import truncated_cone
    >>> value = truncated_cone.radius_from_force(0.1597, theta=0.42, b=0.5, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    1.000006
    """
    require(theta=theta, b=b, E_star=E_star, dgamma=dgamma)
    return elementwise(_radius_from_force, F=F, theta=theta, b=b, E_star=E_star, dgamma=dgamma)


def pull_off(
    control: str = "force", *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike
) -> PullOff:
    """State at which the contact breaks on unloading.

    Under control of the force:

        g'(a_c) = 3*sqrt(2)*sqrt(pi)*sqrt(dgamma)/(2*sqrt(E_star)*sqrt(a_c))
        F = F(a_c)
        d = d(a_c)
        with the depth g(a) without adhesion

    Under control of the depth:

        g'(a_c) = sqrt(2)*sqrt(pi)*sqrt(dgamma)/(2*sqrt(E_star)*sqrt(a_c))
        F = F(a_c)
        d = d(a_c)
        with the depth g(a) without adhesion

    Parameters
    ----------
    control : {"force", "depth"}
        What is held while the contact is unloaded.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    The least force, or depth, of a stable contact. Where it has several minima, or one at a corner of the
    profile, the lowest. Handbook: truncated_cone.adh.ac, truncated_cone.adh.am.

    References
    ----------
    chapter 11, equation (11.31); Ejike 1981.

    Examples
    --------
    >>> from axicontact.adhesive import truncated_cone
    >>> state = truncated_cone.pull_off(theta=0.42, b=0.5, E_star=1.0, dgamma=0.01)
    >>> round(state.force, 6)
    -0.177245
    """
    require(theta=theta, b=b, E_star=E_star, dgamma=dgamma)
    require_control(control)
    radius = elementwise(partial(_pull_off_radius, control=control), theta=theta, b=b, E_star=E_star, dgamma=dgamma)
    force = elementwise(_force, radius, theta=theta, b=b, E_star=E_star, dgamma=dgamma)
    depth = elementwise(_depth, radius, theta=theta, b=b, E_star=E_star, dgamma=dgamma)
    return PullOff(radius, force, depth)


def work_of_adhesion_from_pull_off(F: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Work of separation at which a contact breaks under the normal force F: the inverse of the force of pull_off.

    dgamma = (F_N + abs(F))**2/(8*pi*E_star*a**3) at the radius a at which it is least, F_N the force without
    adhesion there

    Parameters
    ----------
    F : array_like
        Normal force [N].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. The force is a tension, F < 0: 0 without a force, NaN under pressure, which
    breaks no contact, and where no stable contact bears the tension.

    References
    ----------
    chapter 11, equation (11.31); Ejike 1981.

    Examples
    --------
    >>> from axicontact.adhesive import truncated_cone
    >>> value = truncated_cone.work_of_adhesion_from_pull_off(-0.1772, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.009995
    """
    require(theta=theta, b=b, E_star=E_star)
    return elementwise(_work_of_adhesion_from_pull_off, F=F, theta=theta, b=b, E_star=E_star)


def _depth(a: Array, theta: Array, b: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._depth(a, theta, b) - hess_retraction(a, E_star, dgamma)


def _force(a: Array, theta: Array, b: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._force(a, theta, b, E_star) - pull(a, E_star, dgamma)


def _pressure(r: Array, a: Array, theta: Array, b: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._pressure(r, a, theta, b, E_star) - tension(r, a, E_star, dgamma)


def _displacement(r: Array, a: Array, theta: Array, b: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._displacement(r, a, theta, b) - lift(r, a, E_star, dgamma)


def _rate(a: Array, theta: Array, b: Array) -> Array:
    """Derivative g'(a) of the depth without adhesion."""
    root = np.sqrt(np.maximum(a - b, 0.0) * (a + b))
    return normal._slope_beyond(a, root, theta, b)


@Kept
def _samples(theta: Array, b: Array) -> Samples:
    """The steepness at radii that separate the minima of the load."""
    a = radii_beyond(b)
    return Samples(a, np.sqrt(a) * _rate(a, theta, b), np.inf, {})


def _branches(theta: Array, b: Array, E_star: Array, dgamma: Array, control: str) -> Branches:
    return branches(
        lambda a: np.sqrt(a) * _rate(a, theta, b), _samples(theta, b), least_steepness(control, E_star, dgamma)
    )


def _pull_off_radius(theta: Array, b: Array, E_star: Array, dgamma: Array, control: str) -> Array:
    unit = exponent_of(b)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    found = _branches(theta, b, E_star, dgamma, control)
    load = _force if control == "force" else _depth
    radius = lowest(found, lambda a: load(a, theta, b, E_star, dgamma))
    return np.ldexp(radius, unit)


def _radius_from_depth(d: Array, theta: Array, b: Array, E_star: Array, dgamma: Array) -> Array:
    unit = exponent_of(b)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    d = np.ldexp(d, -unit)
    found = _branches(theta, b, E_star, dgamma, control="depth")
    radius = stable_radius(
        d,
        found,
        lambda a: _depth(a, theta, b, E_star, dgamma),
        lambda a: growth(_rate(a, theta, b), a, "depth", E_star, dgamma),
        lambda a: hess_retraction(a, E_star, dgamma),
        radius_itself(),
        beyond_edge(b),
    )
    return np.ldexp(radius, unit)


def _radius_from_force(F: Array, theta: Array, b: Array, E_star: Array, dgamma: Array) -> Array:
    unit = exponent_of(b)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    b = np.ldexp(b, -unit)
    dgamma = np.ldexp(dgamma, -(stress + unit))
    F = np.ldexp(F, -(stress + 2 * unit))
    found = _branches(theta, b, E_star, dgamma, control="force")
    radius = stable_radius(
        F,
        found,
        lambda a: _force(a, theta, b, E_star, dgamma),
        lambda a: growth(_rate(a, theta, b), a, "force", E_star, dgamma),
        lambda a: pull(a, E_star, dgamma),
        radius_itself(),
        beyond_edge(b),
    )
    return np.ldexp(radius, unit)


@Kept
def _held_samples(theta: Array, b: Array) -> Samples:
    """The force that can be held, over the modulus, at radii that separate the minima of the work of separation."""
    a = radii_beyond(b)
    return Samples(a, held(a, _rate(a, theta, b), normal._force(a, theta, b, 1.0)), np.inf, {})


def _work_of_adhesion_from_pull_off(F: Array, theta: Array, b: Array, E_star: Array) -> Array:
    unit = exponent_of(b)
    stress = exponent_of(E_star)
    E_star = np.ldexp(E_star, -stress)
    b = np.ldexp(b, -unit)
    F = np.ldexp(F, -(stress + 2 * unit))
    pull = np.where(F < 0.0, -F, np.nan)
    found = branches(
        lambda a: held(a, _rate(a, theta, b), normal._force(a, theta, b, 1.0)), _held_samples(theta, b), pull / E_star
    )
    a = lowest(found, lambda a: separation(pull + normal._force(a, theta, b, E_star), a, E_star))
    work = separation(pull + normal._force(a, theta, b, E_star), a, E_star)
    return np.where(F == 0.0, 0.0, np.ldexp(work, stress + unit))
