"""Polynomial with a cohesive zone.

Any sum of integer powers with coefficients A_1 ... A_N >= 0: superposition at a fixed contact radius.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from .._runtime.functions import depth_over_height
from .._runtime.integrals import difference_root
from .._runtime.interface import (
    Array,
    Result,
    either,
    elementwise,
    numbers,
    require,
    require_coefficients,
    require_order,
)
from .._runtime.physics.adhesion import PullOff, require_control
from .._runtime.physics.cohesive import (
    ENTIRE,
    Separated,
    alone,
    lift_of_zone,
    opening,
    outer_radius,
    pull_of_zone,
    root_of_zone,
    sunk,
    tension_of_zone,
    work_of_zone,
    zone_like,
)
from .._runtime.physics.cohesive_states import (
    State,
    Stretch,
    parted,
    radii,
    radius_of_pull_off,
    radius_under,
    state_near,
)
from ..normal import polynomial as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "cohesive_radius",
    "depth",
    "displacement",
    "force",
    "pressure",
    "pull_off",
    "radius_from_depth",
    "radius_from_force",
    "without_contact",
    "work_of_separation",
]


def __dir__() -> list[str]:
    return __all__


def work_of_separation(a: ArrayLike, c: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, sigma_0: ArrayLike) -> Result:
    """Work of separation with which the cohesive zone of a contact of radius a ends at c.

    dgamma = sigma_0*(Sum(c**j*A[j], (j, 1, N)) - sqrt(pi)*Sum(a**j*gamma(j/2 + 1)*A[j]/gamma((j +
    1)/2), (j, 1, N)) + Sum((2*a**j*asin(a/c) - c**j*IncompleteBeta(a**2/c**2, (j + 1)/2,
    1/2))*gamma(j/2 + 1)*A[j]/gamma((j + 1)/2), (j, 1, N))/sqrt(pi) + 4*sigma_0*(a - c + sqrt(-a**2 +
    c**2)*acos(a/c))/(pi*E_star))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Outer radius of the cohesive zone [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    sigma_0 : array_like
        Greatest stress of the attraction [Pa], sigma_0 > 0.

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
    Valid for small slopes. Negative or NaN field values give NaN, as do states whose zone would reach beyond
    the profile. Handbook: polynomial.coh.work.

    References
    ----------
    Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.cohesive import polynomial
    >>> value = polynomial.work_of_separation(1.0, 1.143, A=(0.1, 0.25, 0.05), E_star=1.0, sigma_0=0.1)
    >>> round(value, 6)
    0.006661
    """
    A = require_coefficients(A)
    require(E_star=E_star, sigma_0=sigma_0)
    require_order(
        np.all(~(numbers("a", a) > numbers("c", c))),
        "a <= c",
        "the zone surrounds the contact; exchange a and c",
        a=a,
        c=c,
    )
    return elementwise(partial(_work_of_separation, A=A), a, c, E_star=E_star, sigma_0=sigma_0)


def cohesive_radius(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike) -> Result:
    """Outer radius c of the cohesive zone around a contact of radius a.

    c from sigma_0*(Sum(c**j*A[j], (j, 1, N)) - sqrt(pi)*Sum(a**j*gamma(j/2 + 1)*A[j]/gamma((j +
    1)/2), (j, 1, N)) + Sum((2*a**j*asin(a/c) - c**j*IncompleteBeta(a**2/c**2, (j + 1)/2,
    1/2))*gamma(j/2 + 1)*A[j]/gamma((j + 1)/2), (j, 1, N))/sqrt(pi) + 4*sigma_0*(a - c + sqrt(-a**2 +
    c**2)*acos(a/c))/(pi*E_star)) = dgamma
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

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
    sigma_0 : array_like
        Greatest stress of the attraction [Pa], sigma_0 > 0.

    Returns
    -------
    float or ndarray
        Outer radius of the cohesive zone [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes. Negative or NaN field values give NaN, as do states whose zone would reach beyond
    the profile. Handbook: polynomial.coh.c.

    References
    ----------
    Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.cohesive import polynomial
    >>> value = polynomial.cohesive_radius(1.0, A=(0.1, 0.25, 0.05), E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    1.192326
    """
    A = require_coefficients(A)
    require(E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(partial(_cohesive_radius, A=A), a, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def depth(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike) -> Result:
    """Indentation depth at contact radius a; negative where adhesion pulls the surface up.

    d = sqrt(pi)*Sum(a**j*gamma(j/2 + 1)*A[j]/gamma((j + 1)/2), (j, 1, N)) - 2*sigma_0*sqrt(-a**2 +
    c**2)/E_star

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
    sigma_0 : array_like
        Greatest stress of the attraction [Pa], sigma_0 > 0.

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
    Valid for small slopes. Negative or NaN field values give NaN, as do states whose zone would reach beyond
    the profile. Handbook: polynomial.coh.d.

    References
    ----------
    Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.cohesive import polynomial
    >>> value = polynomial.depth(1.0, A=(0.1, 0.25, 0.05), E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    0.645021
    """
    A = require_coefficients(A)
    require(E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(partial(_depth, A=A), a, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def force(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike) -> Result:
    """Normal force at contact radius a, negative in tension.

    F = 2*sqrt(pi)*E_star*Sum(a**(j + 1)*j*gamma(j/2 + 1)*A[j]/((j + 1)*gamma((j + 1)/2)), (j, 1, N)) -
    2*sigma_0*(a*sqrt(-a**2 + c**2) + c**2*acos(a/c))

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
    sigma_0 : array_like
        Greatest stress of the attraction [Pa], sigma_0 > 0.

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
    Valid for small slopes. Negative or NaN field values give NaN, as do states whose zone would reach beyond
    the profile. Handbook: polynomial.coh.F.

    References
    ----------
    Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.cohesive import polynomial
    >>> value = polynomial.force(1.0, A=(0.1, 0.25, 0.05), E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    0.706845
    """
    A = require_coefficients(A)
    require(E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(partial(_force, A=A), a, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def pressure(
    r: ArrayLike, a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Pressure, positive in compression: -sigma_0 in the cohesive zone, zero beyond.

    p = E_star*Sum(j*r**(j - 1)*IncompleteBeta(1 - r**2/a**2, 1/2, (1 - j)/2)*gamma(j/2 + 1)*A[j]/gamma((j +
    1)/2), (j, 1, N))/(2*sqrt(pi)) - 2*sigma_0*atan(sqrt(-a**2 + c**2)/sqrt(a**2 - r**2))/pi
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
    sigma_0 : array_like
        Greatest stress of the attraction [Pa], sigma_0 > 0.

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
    Valid for small slopes. Negative or NaN field values give NaN, as do states whose zone would reach beyond
    the profile. Handbook: polynomial.coh.p.

    References
    ----------
    Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.cohesive import polynomial
    >>> value = polynomial.pressure(0.3, 1.0, A=(0.1, 0.25, 0.05), E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    0.422437
    """
    A = require_coefficients(A)
    require(E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(partial(_pressure, A=A), r, a, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def displacement(
    r: ArrayLike, a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*(Integral(g(a) - g(r*sin(turn)), (turn, 0, asin(a/r))) - 2*sigma_0*sqrt(-a**2 +
    c**2)*asin(a/r)/E_star - 2*sigma_0*Integral(sqrt(c**2 - r**2*sin(turn)**2), (turn,
    asin(a/r), pi/2))/E_star)/pi   for r < c
    w = 2*(Integral(g(a) - g(r*sin(turn)), (turn, 0, asin(a/r))) - 2*sigma_0*sqrt(-a**2 +
    c**2)*asin(a/r)/E_star - 2*sigma_0*Integral(c**2*cos(turn)**2/sqrt(-c**2*sin(turn)**2
    + r**2), (turn, asin(a/c), pi/2))/E_star)/pi   for c < r

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
    sigma_0 : array_like
        Greatest stress of the attraction [Pa], sigma_0 > 0.

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
    Valid for small slopes. Negative or NaN field values give NaN, as do states whose zone would reach beyond
    the profile. Handbook: polynomial.coh.w.

    References
    ----------
    Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.cohesive import polynomial
    >>> value = polynomial.displacement(2.0, 1.0, A=(0.1, 0.25, 0.05), E_star=1.0, dgamma=0.01, sigma_0=0.1)
    >>> round(value, 6)
    0.113848
    """
    A = require_coefficients(A)
    require(E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(partial(_displacement, A=A), r, a, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def without_contact(
    c: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Separated:
    """Depth and force of surfaces that attract each other up to the radius c and do not touch.

    d = f(c) - dgamma/sigma_0 - 4*c*sigma_0/(pi*E_star)
    F = -pi*sigma_0*c**2

    Parameters
    ----------
    c : array_like
        Outer radius of the cohesive zone [m].
    A : sequence of float
        Coefficients of r, r^2, ..., none negative and not all zero.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.
    sigma_0 : array_like
        Greatest stress of the attraction [Pa], sigma_0 > 0.

    Returns
    -------
    Separated
        Named tuple of depth [m] and force [N]; NaN where they would touch. The shape to which the arguments
        broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes. Coming closer, the attraction begins at the depth -dgamma/sigma_0, where the
    surfaces jump together if f'(c) < 4 sigma_0/(pi E_star) next to the axis; under control of the depth the
    states with a larger f'(c) are stable.

    References
    ----------
    Schubert 1942; Sneddon 1965.
    """
    A = require_coefficients(A)
    require(E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return Separated(
        elementwise(partial(_without_contact_depth, A=A), c, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0),
        elementwise(partial(_without_contact_force, A=A), c, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0),
    )


def pull_off(
    control: str = "force", *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> PullOff:
    """State at which the contact breaks on unloading.

    The least force, or depth, on unloading. At c the gap of the contact without adhesion then changes with c
    by 4 sigma_0/(pi E_star) (phi^2/cos(phi) + 1 - cos(phi)) under control of the force, cos(phi) = a/c, and
    by 4 sigma_0/(pi E_star) (1 - cos(phi)) under control of the depth.

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
    sigma_0 : array_like
        Greatest stress of the attraction [Pa], sigma_0 > 0.

    Returns
    -------
    PullOff
        Named tuple of radius [m], force [N] and depth [m]; the radius is 0 where the depth falls until the
        surfaces have parted, and go on attracting each other.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Where it has several minima, or one at a corner of the profile, the lowest. Valid for small slopes.

    References
    ----------
    Schubert 1942; Sneddon 1965.
    """
    A = require_coefficients(A)
    require(E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    require_control(control)
    radius = elementwise(partial(_pull_off_radius, A=A, control=control), E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    zone = elementwise(partial(_pull_off_zone, A=A), a=radius, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    force = elementwise(partial(_force_of, A=A), a=radius, q=zone, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    depth = elementwise(partial(_pull_off_depth, A=A), a=radius, q=zone, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return PullOff(radius, force, depth)


def radius_from_depth(
    d: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Contact radius at indentation depth d, on the branch that is stable under a given depth.

    a from d = d(a), where it grows with a.

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
    sigma_0 : array_like
        Greatest stress of the attraction [Pa], sigma_0 > 0.

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
    Valid for small slopes. NaN below pull-off.

    References
    ----------
    Schubert 1942; Sneddon 1965.
    """
    A = require_coefficients(A)
    require(E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(partial(_radius_from_depth, A=A), d=d, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def radius_from_force(
    F: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike
) -> Result:
    """Contact radius under the normal force F, on the branch that is stable under a given force.

    a from F = F(a), where it grows with a.

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
    sigma_0 : array_like
        Greatest stress of the attraction [Pa], sigma_0 > 0.

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
    Valid for small slopes. NaN below pull-off.

    References
    ----------
    Schubert 1942; Sneddon 1965.
    """
    A = require_coefficients(A)
    require(E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(partial(_radius_from_force, A=A), F=F, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def _opened(q: Array, a: Array, A: tuple[float, ...]) -> tuple[Array, Array]:
    """Gap of the normal contact at c, and its rate with c."""
    terms = [(j - 1, j * depth_over_height(j) * A_j) for j, A_j in enumerate(A, 1)]
    return opening(lambda t: sum(rate * t**power for power, rate in terms), q, a, ENTIRE)


def _zone(a: Array, A: tuple[float, ...], E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    """sqrt(c**2 - a**2) of the zone."""
    return root_of_zone(partial(_opened, A=A), a, E_star, dgamma, sigma_0)


def _work_of_separation(a: Array, c: Array, A: tuple[float, ...], E_star: Array, sigma_0: Array) -> Array:
    return work_of_zone(partial(_opened, A=A), difference_root(c, a), a, E_star, sigma_0)


def _cohesive_radius(a: Array, A: tuple[float, ...], E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return outer_radius(_zone(a, A, E_star, dgamma, sigma_0), a)


def _depth_of(a: Array, q: Array, A: tuple[float, ...], E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return normal._depth(a, A) - sunk(q, E_star, sigma_0)


def _depth(a: Array, A: tuple[float, ...], E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return _depth_of(a, _zone(a, A, E_star, dgamma, sigma_0), A, E_star, dgamma, sigma_0)


def _force_of(a: Array, q: Array, A: tuple[float, ...], E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return normal._force(a, A, E_star) - pull_of_zone(q, a, sigma_0)


def _force(a: Array, A: tuple[float, ...], E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return _force_of(a, _zone(a, A, E_star, dgamma, sigma_0), A, E_star, dgamma, sigma_0)


def _pressure_of(
    r: Array, a: Array, q: Array, A: tuple[float, ...], E_star: Array, dgamma: Array, sigma_0: Array
) -> Array:
    return normal._pressure(r, a, A, E_star) - tension_of_zone(r, q, a, sigma_0)


def _pressure(r: Array, a: Array, A: tuple[float, ...], E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return _pressure_of(r, a, _zone(a, A, E_star, dgamma, sigma_0), A, E_star, dgamma, sigma_0)


def _displacement_of(
    r: Array, a: Array, q: Array, A: tuple[float, ...], E_star: Array, dgamma: Array, sigma_0: Array
) -> Array:
    return normal._displacement(r, a, A) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r: Array, a: Array, A: tuple[float, ...], E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return _displacement_of(r, a, _zone(a, A, E_star, dgamma, sigma_0), A, E_star, dgamma, sigma_0)


def _growth(a: Array, A: tuple[float, ...]) -> Array:
    """Rate g'(a) of the depth of the normal contact."""
    return np.where(a > 0.0, normal._slope(a, A), 0.0)


def _radii(A: tuple[float, ...], E_star: Array, dgamma: Array, sigma_0: Array) -> Stretch:
    a = np.zeros_like(sigma_0)
    first = zone_like(partial(_opened, A=A), a, E_star, dgamma, sigma_0)
    return radii(first)


def _state(
    a: Array, start: Array, A: tuple[float, ...], E_star: Array, dgamma: Array, sigma_0: Array, control: str
) -> State:
    growth = _growth(a, A)
    return state_near(partial(_opened, A=A), growth, start, a, control, E_star, dgamma, sigma_0)


def _pull_off_radius(A: tuple[float, ...], E_star: Array, dgamma: Array, sigma_0: Array, control: str) -> Array:
    load = _force_of if control == "force" else _depth_of
    return radius_of_pull_off(
        lambda a, start: _state(a, start, A, E_star, dgamma, sigma_0, control),
        lambda a, q: load(a, q, A, E_star, dgamma, sigma_0),
        _radii(A, E_star, dgamma, sigma_0),
    )


def _parted(A: tuple[float, ...], E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    first = _zone(np.zeros_like(sigma_0), A, E_star, dgamma, sigma_0)
    return parted(partial(_opened, A=A), first, E_star, sigma_0)


def _pull_off_zone(a: Array, A: tuple[float, ...], E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return either(
        a > 0.0,
        lambda: root_of_zone(partial(_opened, A=A), a, E_star, dgamma, sigma_0),
        lambda: np.where(a == 0.0, _parted(A, E_star, dgamma, sigma_0), np.nan),
    )


def _pull_off_depth(a: Array, q: Array, A: tuple[float, ...], E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return either(
        a > 0.0,
        lambda: _depth_of(a, q, A, E_star, dgamma, sigma_0),
        lambda: alone(partial(_opened, A=A), q, E_star, dgamma, sigma_0),
    )


def _without_contact_depth(c: Array, A: tuple[float, ...], E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    depth = alone(partial(_opened, A=A), c, E_star, dgamma, sigma_0)
    return np.where(depth <= -sunk(c, E_star, sigma_0), depth, np.nan)


def _without_contact_force(c: Array, A: tuple[float, ...], E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    depth = alone(partial(_opened, A=A), c, E_star, dgamma, sigma_0)
    return np.where(depth <= -sunk(c, E_star, sigma_0), -np.pi * sigma_0 * c * c, np.nan)


def _held_apart(d: Array, A: tuple[float, ...], E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    apart = _pull_off_radius(A, E_star, dgamma, sigma_0, "depth") == 0.0
    deeper = d >= alone(partial(_opened, A=A), _parted(A, E_star, dgamma, sigma_0), E_star, dgamma, sigma_0)
    return np.where(apart & deeper, 0.0, np.nan)


def _radius_from_depth(d: Array, A: tuple[float, ...], E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    a = radius_under(
        lambda a, start: _state(a, start, A, E_star, dgamma, sigma_0, "depth"),
        lambda a, q: _depth_of(a, q, A, E_star, dgamma, sigma_0),
        d,
        _radii(A, E_star, dgamma, sigma_0),
    )
    return np.where(np.isnan(a), _held_apart(d, A, E_star, dgamma, sigma_0), a)


def _radius_from_force(F: Array, A: tuple[float, ...], E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return radius_under(
        lambda a, start: _state(a, start, A, E_star, dgamma, sigma_0, "force"),
        lambda a, q: _force_of(a, q, A, E_star, dgamma, sigma_0),
        F,
        _radii(A, E_star, dgamma, sigma_0),
    )
