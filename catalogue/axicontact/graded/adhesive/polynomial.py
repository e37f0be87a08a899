"""Polynomial with adhesion on a power-law graded half-space.

Any sum of integer powers with coefficients A_1 ... A_N >= 0: superposition at a fixed contact radius.
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
from ..._runtime.interface import Array, Kept, Result, elementwise, require, require_coefficients
from ..._runtime.physics.adhesion import PullOff, require_control
from ..._runtime.physics.branches import Branches, Samples, branches, decades, lowest
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
    Valid for small slopes. Negative or NaN radii give NaN. Handbook: polynomial.fgm.adh.Dl.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.adhesive import polynomial
    >>> value = polynomial.retraction(1.0, H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    0.250663
    """
    require(H=H, k=k, dgamma=dgamma)
    return elementwise(graded_retraction, a, H=H, k=k, dgamma=dgamma)


def depth(a: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> Result:
    """Indentation depth at contact radius a; negative where adhesion pulls the surface up.

    d = gamma((k + 1)/2)*Sum(a**j*gamma(j/2 + 1)*A[j]/gamma((j + k + 1)/2), (j, 1, N)) -
    sqrt(2)*sqrt(pi)*a**(1/2 - k/2)*sqrt(dgamma)/sqrt(H)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN radii give NaN. Handbook: polynomial.fgm.adh.d.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.adhesive import polynomial
    >>> value = polynomial.depth(1.0, A=(0.1, 0.25, 0.05), H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    0.374329
    """
    A = require_coefficients(A)
    require(H=H, k=k, dgamma=dgamma)
    return elementwise(partial(_depth, A=A), a, H=H, k=k, dgamma=dgamma)


def force(a: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> Result:
    """Normal force at contact radius a, negative in tension.

    F = -2*sqrt(2)*sqrt(pi)*sqrt(H)*a**(k/2 + 3/2)*sqrt(dgamma)/(k + 1) + 2*H*gamma((k + 1)/2)*Sum(a**(j + k +
    1)*j*gamma(j/2 + 1)*A[j]/((j + k + 1)*gamma((j + k + 1)/2)), (j, 1, N))/(k + 1)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. Negative or NaN radii give NaN. Handbook: polynomial.fgm.adh.F.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.adhesive import polynomial
    >>> value = polynomial.force(1.0, A=(0.1, 0.25, 0.05), H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    0.190426
    """
    A = require_coefficients(A)
    require(H=H, k=k, dgamma=dgamma)
    return elementwise(partial(_force, A=A), a, H=H, k=k, dgamma=dgamma)


def pressure(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact pressure, positive in compression, infinite tension at the edge; zero outside the contact.

    p = -sqrt(2)*sqrt(H)*a**(1/2 - k/2)*sqrt(dgamma)*(a**2 - r**2)**(k/2 - 1/2)/sqrt(pi) + H*gamma((k +
    1)/2)*Sum(j*r**(j + k - 1)*IncompleteBeta(1 - r**2/a**2, (k + 1)/2, (-j - k + 1)/2)*gamma(j/2 +
    1)*A[j]/gamma((j + k + 1)/2), (j, 1, N))/(2*pi)
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
    Valid for small slopes. Negative or NaN radii give NaN. Handbook: polynomial.fgm.adh.p.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.adhesive import polynomial
    >>> value = polynomial.pressure(0.3, 1.0, A=(0.1, 0.25, 0.05), H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    0.208958
    """
    A = require_coefficients(A)
    require(H=H, k=k, dgamma=dgamma)
    return elementwise(partial(_pressure, A=A), r, a, H=H, k=k, dgamma=dgamma)


def displacement(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = cos(pi*k/2)*gamma((k + 1)/2)*Sum((a**j*IncompleteBeta(a**2/r**2, (k + 1)/2, (1 - k)/2) -
    r**j*IncompleteBeta(a**2/r**2, (j + k + 1)/2, (1 - k)/2))*gamma(j/2 + 1)*A[j]/gamma((j + k + 1)/2), (j, 1,
    N))/pi - sqrt(2)*a**(1/2 - k/2)*sqrt(dgamma)*cos(pi*k/2)*IncompleteBeta(a**2/r**2, (k + 1)/2, (1 -
    k)/2)/(sqrt(pi)*sqrt(H))
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
    Valid for small slopes. Negative or NaN radii give NaN. Handbook: polynomial.fgm.adh.w.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.adhesive import polynomial
    >>> value = polynomial.displacement(2.0, 1.0, A=(0.1, 0.25, 0.05), H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    0.023103
    """
    A = require_coefficients(A)
    require(H=H, k=k, dgamma=dgamma)
    return elementwise(partial(_displacement, A=A), r, a, H=H, k=k, dgamma=dgamma)


def radius_from_depth(d: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact radius at indentation depth d, on the branch that is stable under a given depth.

    a from gamma((k + 1)/2)*Sum(a**j*gamma(j/2 + 1)*A[j]/gamma((j + k + 1)/2), (j, 1, N)) -
    sqrt(2)*sqrt(pi)*a**(1/2 - k/2)*sqrt(dgamma)/sqrt(H) = d

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. NaN below pull-off. Where several radii are stable, the largest, which is reached
    on unloading. Handbook: polynomial.fgm.adh.ad.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.adhesive import polynomial
    >>> value = polynomial.radius_from_depth(0.3743, A=(0.1, 0.25, 0.05), H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    0.999973
    """
    A = require_coefficients(A)
    require(H=H, k=k, dgamma=dgamma)
    return elementwise(partial(_radius_from_depth, A=A), d=d, H=H, k=k, dgamma=dgamma)


def radius_from_force(F: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact radius under the normal force F, on the branch that is stable under a given force.

    a from -2*sqrt(2)*sqrt(pi)*sqrt(H)*a**(k/2 + 3/2)*sqrt(dgamma)/(k + 1) + 2*H*gamma((k + 1)/2)*Sum(a**(j +
    k + 1)*j*gamma(j/2 + 1)*A[j]/((j + k + 1)*gamma((j + k + 1)/2)), (j, 1, N))/(k + 1) = F

    Parameters
    ----------
    F : array_like
        Normal force [N].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. NaN below pull-off. Where several radii are stable, the largest, which is reached
    on unloading. Handbook: polynomial.fgm.adh.aF.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.adhesive import polynomial
    >>> value = polynomial.radius_from_force(0.1904, A=(0.1, 0.25, 0.05), H=1.0, k=0.25, dgamma=0.01)
    >>> round(value, 6)
    0.99998
    """
    A = require_coefficients(A)
    require(H=H, k=k, dgamma=dgamma)
    return elementwise(partial(_radius_from_force, A=A), F=F, H=H, k=k, dgamma=dgamma)


def pull_off(control: str = "force", *, A: ArrayLike, H: ArrayLike, k: ArrayLike, dgamma: ArrayLike) -> PullOff:
    """State at which the contact breaks on unloading.

    At pull-off the retraction is 2 a g'(a)/xi, with the depth g(a) without adhesion, and

        a**((1 + k)/2)*g'(a) = xi*sqrt(pi*dgamma/(2*H))

    where xi = 3 + k under control of the force and 1 - k under control of the depth.

    Parameters
    ----------
    control : {"force", "depth"}
        What is held while the contact is unloaded.
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    profile, the lowest. Handbook: polynomial.fgm.adh.ac, polynomial.fgm.adh.am.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.adhesive import polynomial
    >>> state = polynomial.pull_off(A=(0.1, 0.25, 0.05), H=1.0, k=0.25, dgamma=0.01)
    >>> round(state.force, 6)
    -0.063229
    """
    A = require_coefficients(A)
    require(H=H, k=k, dgamma=dgamma)
    require_control(control)
    radius = elementwise(partial(_pull_off_radius, A=A, control=control), H=H, k=k, dgamma=dgamma)
    force = elementwise(partial(_force, A=A), radius, H=H, k=k, dgamma=dgamma)
    depth = elementwise(partial(_depth, A=A), radius, H=H, k=k, dgamma=dgamma)
    return PullOff(radius, force, depth)


def work_of_adhesion_from_pull_off(F: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Work of separation at which a contact breaks under the normal force F: the inverse of the force of pull_off.

    dgamma = a**(-k - 3)*(F_N + abs(F))**2*(k + 1)**2/(8*pi*H) at the radius a at which it is least, F_N the
    force without adhesion there

    Parameters
    ----------
    F : array_like
        Normal force [N].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
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
    Valid for small slopes. The force is a tension, F < 0: 0 without a force, NaN under pressure, which breaks
    no contact, and where no stable contact bears the tension.

    References
    ----------
    chapter 11, equation (11.64); chapter 11, equation (11.66); Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.adhesive import polynomial
    >>> value = polynomial.work_of_adhesion_from_pull_off(-0.06323, A=(0.1, 0.25, 0.05), H=1.0, k=0.25)
    >>> round(value, 6)
    0.01
    """
    A = require_coefficients(A)
    require(H=H, k=k)
    return elementwise(partial(_work_of_adhesion_from_pull_off, A=A), F=F, H=H, k=k)


def _depth(a: Array, A: tuple[float, ...], H: Array, k: Array, dgamma: Array) -> Array:
    return normal._depth(a, A, k) - graded_retraction(a, H, k, dgamma)


def _force(a: Array, A: tuple[float, ...], H: Array, k: Array, dgamma: Array) -> Array:
    return normal._force(a, A, H, k) - punch_stiffness(a, H, k) * graded_retraction(a, H, k, dgamma)


def _pressure(r: Array, a: Array, A: tuple[float, ...], H: Array, k: Array, dgamma: Array) -> Array:
    return normal._pressure(r, a, A, H, k) - tension(r, a, H, k, dgamma)


def _displacement(r: Array, a: Array, A: tuple[float, ...], H: Array, k: Array, dgamma: Array) -> Array:
    return normal._displacement(r, a, A, k) - graded_retraction(a, H, k, dgamma) * punch_displacement(r, a, k)


@Kept
def _samples(A: tuple[float, ...], k: Array) -> Samples:
    """The steepness at radii that separate the minima of the load."""
    a = decades()
    return Samples(a, a ** ((1.0 + k) / 2.0) * normal._rate(a, A, k), np.inf, {})


def _branches(A: tuple[float, ...], H: Array, k: Array, dgamma: Array, control: str) -> Branches:
    return branches(
        lambda a: a ** ((1.0 + k) / 2.0) * normal._rate(a, A, k), _samples(A, k), least_steepness(control, H, k, dgamma)
    )


def _pull_off_radius(A: tuple[float, ...], H: Array, k: Array, dgamma: Array, control: str) -> Array:
    found = _branches(A, H, k, dgamma, control)
    load = _force if control == "force" else _depth
    return lowest(found, lambda a: load(a, A, H, k, dgamma))


def _radius_from_depth(d: Array, A: tuple[float, ...], H: Array, k: Array, dgamma: Array) -> Array:
    from ..._runtime.physics.stable import stable_radius
    from ..._runtime.physics.unknowns import radius_itself

    found = _branches(A, H, k, dgamma, control="depth")
    slope = growth_of(normal._rate, (A, k), H, k, dgamma, control="depth")
    pulled = pull_of(H, k, dgamma, control="depth")
    return stable_radius(d, found, lambda a: _depth(a, A, H, k, dgamma), slope, pulled, radius_itself())


def _radius_from_force(F: Array, A: tuple[float, ...], H: Array, k: Array, dgamma: Array) -> Array:
    from ..._runtime.physics.stable import stable_radius
    from ..._runtime.physics.unknowns import radius_itself

    found = _branches(A, H, k, dgamma, control="force")
    slope = growth_of(normal._rate, (A, k), H, k, dgamma, control="force")
    pulled = pull_of(H, k, dgamma, control="force")
    return stable_radius(F, found, lambda a: _force(a, A, H, k, dgamma), slope, pulled, radius_itself())


@Kept
def _held_samples(A: tuple[float, ...], k: Array) -> Samples:
    """The force that can be held, over the modulus, at radii that separate the minima of the work of separation."""
    a = decades()
    return Samples(a, held(a, normal._rate(a, A, k), normal._force(a, A, 1.0, k), k), np.inf, {})


def _work_of_adhesion_from_pull_off(F: Array, A: tuple[float, ...], H: Array, k: Array) -> Array:
    pull = np.where(F < 0.0, -F, np.nan)
    found = branches(
        lambda a: held(a, normal._rate(a, A, k), normal._force(a, A, 1.0, k), k), _held_samples(A, k), pull / H
    )
    a = lowest(found, lambda a: separation(pull + normal._force(a, A, H, k), a, H, k))
    work = separation(pull + normal._force(a, A, H, k), a, H, k)
    return np.where(F == 0.0, 0.0, work)
