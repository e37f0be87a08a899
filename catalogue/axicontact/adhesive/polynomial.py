"""Polynomial with adhesion.

Any sum of integer powers with coefficients A_1 ... A_N >= 0: superposition at a fixed contact radius.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Kept, Result, elementwise, require, require_coefficients
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
from .._runtime.physics.branches import Branches, Samples, branches, decades, lowest
from .._runtime.physics.stable import growth, stable_radius
from .._runtime.physics.unknowns import radius_itself
from ..normal import polynomial as normal

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
    Valid for small slopes. Negative or NaN radii give NaN. Handbook: polynomial.adh.Dl.

    References
    ----------
    chapter 11, equation (11.31); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import polynomial
    >>> value = polynomial.retraction(1.0, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.250663
    """
    require(E_star=E_star, dgamma=dgamma)
    return elementwise(hess_retraction, a, E_star=E_star, dgamma=dgamma)


def depth(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Indentation depth at contact radius a; negative where adhesion pulls the surface up.

    d = sqrt(pi)*Sum(a**j*gamma(j/2 + 1)*A[j]/gamma((j + 1)/2), (j, 1, N)) -
    sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN radii give NaN. Handbook: polynomial.adh.d.

    References
    ----------
    chapter 11, equation (11.31); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import polynomial
    >>> value = polynomial.depth(1.0, A=(0.1, 0.25, 0.05), E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.524227
    """
    A = require_coefficients(A)
    require(E_star=E_star, dgamma=dgamma)
    return elementwise(partial(_depth, A=A), a, E_star=E_star, dgamma=dgamma)


def force(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Normal force at contact radius a, negative in tension.

    F = -2*sqrt(2)*sqrt(pi)*sqrt(E_star)*a**(3/2)*sqrt(dgamma) + 2*sqrt(pi)*E_star*Sum(a**(j + 1)*j*gamma(j/2
    + 1)*A[j]/((j + 1)*gamma((j + 1)/2)), (j, 1, N))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN radii give NaN. Handbook: polynomial.adh.F.

    References
    ----------
    chapter 11, equation (11.31); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import polynomial
    >>> value = polynomial.force(1.0, A=(0.1, 0.25, 0.05), E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.499135
    """
    A = require_coefficients(A)
    require(E_star=E_star, dgamma=dgamma)
    return elementwise(partial(_force, A=A), a, E_star=E_star, dgamma=dgamma)


def pressure(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact pressure, positive in compression, infinite tension at the edge; zero outside the contact.

    p = -sqrt(2)*sqrt(E_star)*sqrt(a)*sqrt(dgamma)/(sqrt(pi)*sqrt(a**2 - r**2)) + E_star*Sum(j*r**(j -
    1)*IncompleteBeta(1 - r**2/a**2, 1/2, (1 - j)/2)*gamma(j/2 + 1)*A[j]/gamma((j + 1)/2), (j, 1,
    N))/(2*sqrt(pi))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN radii give NaN. Handbook: polynomial.adh.p.

    References
    ----------
    chapter 11, equation (11.31); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import polynomial
    >>> value = polynomial.pressure(0.3, 1.0, A=(0.1, 0.25, 0.05), E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.376844
    """
    A = require_coefficients(A)
    require(E_star=E_star, dgamma=dgamma)
    return elementwise(partial(_pressure, A=A), r, a, E_star=E_star, dgamma=dgamma)


def displacement(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = Sum((2*a**j*asin(a/r) - r**j*IncompleteBeta(a**2/r**2, (j + 1)/2, 1/2))*gamma(j/2 + 1)*A[j]/gamma((j +
    1)/2), (j, 1, N))/sqrt(pi) - 2*sqrt(2)*sqrt(a)*sqrt(dgamma)*asin(a/r)/(sqrt(pi)*sqrt(E_star))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN radii give NaN. Handbook: polynomial.adh.w.

    References
    ----------
    chapter 11, equation (11.31); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import polynomial
    >>> value = polynomial.displacement(2.0, 1.0, A=(0.1, 0.25, 0.05), E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.07999
    """
    A = require_coefficients(A)
    require(E_star=E_star, dgamma=dgamma)
    return elementwise(partial(_displacement, A=A), r, a, E_star=E_star, dgamma=dgamma)


def radius_from_depth(d: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact radius at indentation depth d, on the branch that is stable under a given depth.

    a from sqrt(pi)*Sum(a**j*gamma(j/2 + 1)*A[j]/gamma((j + 1)/2), (j, 1, N)) -
    sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star) = d

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. NaN below pull-off. Where several radii are stable, the largest, which is reached
    on unloading. Handbook: polynomial.adh.ad.

    References
    ----------
    chapter 11, equation (11.31); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import polynomial
    >>> value = polynomial.radius_from_depth(0.5242, A=(0.1, 0.25, 0.05), E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.999981
    """
    A = require_coefficients(A)
    require(E_star=E_star, dgamma=dgamma)
    return elementwise(partial(_radius_from_depth, A=A), d=d, E_star=E_star, dgamma=dgamma)


def radius_from_force(F: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact radius under the normal force F, on the branch that is stable under a given force.

    a from -2*sqrt(2)*sqrt(pi)*sqrt(E_star)*a**(3/2)*sqrt(dgamma) + 2*sqrt(pi)*E_star*Sum(a**(j +
    1)*j*gamma(j/2 + 1)*A[j]/((j + 1)*gamma((j + 1)/2)), (j, 1, N)) = F

    Parameters
    ----------
    F : array_like
        Normal force [N].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. NaN below pull-off. Where several radii are stable, the largest, which is reached
    on unloading. Handbook: polynomial.adh.aF.

    References
    ----------
    chapter 11, equation (11.31); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import polynomial
    >>> value = polynomial.radius_from_force(0.4991, A=(0.1, 0.25, 0.05), E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.999984
    """
    A = require_coefficients(A)
    require(E_star=E_star, dgamma=dgamma)
    return elementwise(partial(_radius_from_force, A=A), F=F, E_star=E_star, dgamma=dgamma)


def pull_off(control: str = "force", *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> PullOff:
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
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    profile, the lowest. Handbook: polynomial.adh.ac, polynomial.adh.am.

    References
    ----------
    chapter 11, equation (11.31); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import polynomial
    >>> state = polynomial.pull_off(A=(0.1, 0.25, 0.05), E_star=1.0, dgamma=0.01)
    >>> round(state.force, 6)
    -0.054575
    """
    A = require_coefficients(A)
    require(E_star=E_star, dgamma=dgamma)
    require_control(control)
    radius = elementwise(partial(_pull_off_radius, A=A, control=control), E_star=E_star, dgamma=dgamma)
    force = elementwise(partial(_force, A=A), radius, E_star=E_star, dgamma=dgamma)
    depth = elementwise(partial(_depth, A=A), radius, E_star=E_star, dgamma=dgamma)
    return PullOff(radius, force, depth)


def work_of_adhesion_from_pull_off(F: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Work of separation at which a contact breaks under the normal force F: the inverse of the force of pull_off.

    dgamma = (F_N + abs(F))**2/(8*pi*E_star*a**3) at the radius a at which it is least, F_N the force without
    adhesion there

    Parameters
    ----------
    F : array_like
        Normal force [N].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. The force is a tension, F < 0: 0 without a force, NaN under pressure, which breaks
    no contact, and where no stable contact bears the tension.

    References
    ----------
    chapter 11, equation (11.31); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import polynomial
    >>> value = polynomial.work_of_adhesion_from_pull_off(-0.05457, A=(0.1, 0.25, 0.05), E_star=1.0)
    >>> round(value, 6)
    0.009999
    """
    A = require_coefficients(A)
    require(E_star=E_star)
    return elementwise(partial(_work_of_adhesion_from_pull_off, A=A), F=F, E_star=E_star)


def _depth(a: Array, A: tuple[float, ...], E_star: Array, dgamma: Array) -> Array:
    return normal._depth(a, A) - hess_retraction(a, E_star, dgamma)


def _force(a: Array, A: tuple[float, ...], E_star: Array, dgamma: Array) -> Array:
    return normal._force(a, A, E_star) - pull(a, E_star, dgamma)


def _pressure(r: Array, a: Array, A: tuple[float, ...], E_star: Array, dgamma: Array) -> Array:
    return normal._pressure(r, a, A, E_star) - tension(r, a, E_star, dgamma)


def _displacement(r: Array, a: Array, A: tuple[float, ...], E_star: Array, dgamma: Array) -> Array:
    return normal._displacement(r, a, A) - lift(r, a, E_star, dgamma)


def _rate(a: Array, A: tuple[float, ...]) -> Array:
    """Derivative g'(a) of the depth without adhesion."""
    return normal._slope(a, A)


@Kept
def _samples(A: tuple[float, ...]) -> Samples:
    """The steepness at radii that separate the minima of the load."""
    a = decades()
    return Samples(a, np.sqrt(a) * _rate(a, A), np.inf, {})


def _branches(A: tuple[float, ...], E_star: Array, dgamma: Array, control: str) -> Branches:
    return branches(lambda a: np.sqrt(a) * _rate(a, A), _samples(A), least_steepness(control, E_star, dgamma))


def _pull_off_radius(A: tuple[float, ...], E_star: Array, dgamma: Array, control: str) -> Array:
    found = _branches(A, E_star, dgamma, control)
    load = _force if control == "force" else _depth
    return lowest(found, lambda a: load(a, A, E_star, dgamma))


def _radius_from_depth(d: Array, A: tuple[float, ...], E_star: Array, dgamma: Array) -> Array:
    found = _branches(A, E_star, dgamma, control="depth")
    return stable_radius(
        d,
        found,
        lambda a: _depth(a, A, E_star, dgamma),
        lambda a: growth(_rate(a, A), a, "depth", E_star, dgamma),
        lambda a: hess_retraction(a, E_star, dgamma),
        radius_itself(),
    )


def _radius_from_force(F: Array, A: tuple[float, ...], E_star: Array, dgamma: Array) -> Array:
    found = _branches(A, E_star, dgamma, control="force")
    return stable_radius(
        F,
        found,
        lambda a: _force(a, A, E_star, dgamma),
        lambda a: growth(_rate(a, A), a, "force", E_star, dgamma),
        lambda a: pull(a, E_star, dgamma),
        radius_itself(),
    )


@Kept
def _held_samples(A: tuple[float, ...]) -> Samples:
    """The force that can be held, over the modulus, at radii that separate the minima of the work of separation."""
    a = decades()
    return Samples(a, held(a, _rate(a, A), normal._force(a, A, 1.0)), np.inf, {})


def _work_of_adhesion_from_pull_off(F: Array, A: tuple[float, ...], E_star: Array) -> Array:
    pull = np.where(F < 0.0, -F, np.nan)
    found = branches(lambda a: held(a, _rate(a, A), normal._force(a, A, 1.0)), _held_samples(A), pull / E_star)
    a = lowest(found, lambda a: separation(pull + normal._force(a, A, E_star), a, E_star))
    work = separation(pull + normal._force(a, A, E_star), a, E_star)
    return np.where(F == 0.0, 0.0, work)
