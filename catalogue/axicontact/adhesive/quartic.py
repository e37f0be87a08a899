"""Quartic profile with adhesion.

Vanishing curvature at the tip: the pressure has a dip at the centre and its largest value on a ring.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from .._runtime.functions import nth_root
from .._runtime.interface import Array, Result, elementwise, require
from .._runtime.physics.adhesion import (
    XI,
    PullOff,
    hess_retraction,
    lift,
    power_law_radius,
    pull,
    require_control,
    separation,
    tension,
)
from ..normal import quartic as normal

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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN radii give NaN. Handbook: quartic.adh.Dl.

    References
    ----------
    chapter 11, equation (11.31); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.adhesive import quartic
    >>> value = quartic.retraction(1.0, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.250663
    """
    require(E_star=E_star, dgamma=dgamma)
    return elementwise(hess_retraction, a, E_star=E_star, dgamma=dgamma)


def depth(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Indentation depth at contact radius a; negative where adhesion pulls the surface up.

    d = 8*A*a**4/3 - sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN radii give NaN. Handbook: quartic.adh.d.

    References
    ----------
    chapter 11, equation (11.31); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.adhesive import quartic
    >>> value = quartic.depth(1.0, A=0.4, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.816004
    """
    require(A=A, E_star=E_star, dgamma=dgamma)
    return elementwise(_depth, a, A=A, E_star=E_star, dgamma=dgamma)


def force(a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Normal force at contact radius a, negative in tension.

    F = 64*A*E_star*a**5/15 - 2*sqrt(2)*sqrt(pi)*sqrt(E_star)*a**(3/2)*sqrt(dgamma)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN radii give NaN. Handbook: quartic.adh.F.

    References
    ----------
    chapter 11, equation (11.31); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.adhesive import quartic
    >>> value = quartic.force(1.0, A=0.4, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    1.205341
    """
    require(A=A, E_star=E_star, dgamma=dgamma)
    return elementwise(_force, a, A=A, E_star=E_star, dgamma=dgamma)


def pressure(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact pressure, positive in compression, infinite tension at the edge; zero outside the contact.

    p = 32*A*E_star*sqrt(a**2 - r**2)*(a**2 + 2*r**2)/(9*pi) -
    sqrt(2)*sqrt(E_star)*sqrt(a)*sqrt(dgamma)/(sqrt(pi)*sqrt(a**2 - r**2))

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN radii give NaN. Handbook: quartic.adh.p.

    References
    ----------
    chapter 11, equation (11.31); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.adhesive import quartic
    >>> value = quartic.pressure(0.3, 1.0, A=0.4, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.425948
    """
    require(A=A, E_star=E_star, dgamma=dgamma)
    return elementwise(_pressure, r, a, A=A, E_star=E_star, dgamma=dgamma)


def displacement(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*A*(a*sqrt(-a**2 + r**2)*(2*a**2 + 3*r**2) - (-8*a**4 + 3*r**4)*asin(a/r))/(3*pi) -
    2*sqrt(2)*sqrt(a)*sqrt(dgamma)*asin(a/r)/(sqrt(pi)*sqrt(E_star))

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. Negative or NaN radii give NaN. Handbook: quartic.adh.w.

    References
    ----------
    chapter 11, equation (11.31); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.adhesive import quartic
    >>> value = quartic.displacement(2.0, 1.0, A=0.4, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.196962
    """
    require(A=A, E_star=E_star, dgamma=dgamma)
    return elementwise(_displacement, r, a, A=A, E_star=E_star, dgamma=dgamma)


def radius_from_depth(d: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact radius at indentation depth d, on the branch that is stable under a given depth.

    a from 8*A*a**4/3 - sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star) = d

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. NaN below pull-off. Handbook: quartic.adh.ad.

    References
    ----------
    chapter 11, equation (11.31); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.adhesive import quartic
    >>> value = quartic.radius_from_depth(0.816, A=0.4, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.999999
    """
    require(A=A, E_star=E_star, dgamma=dgamma)
    return elementwise(_radius_from_depth, d=d, A=A, E_star=E_star, dgamma=dgamma)


def radius_from_force(F: ArrayLike, *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact radius under the normal force F, on the branch that is stable under a given force.

    a from 64*A*E_star*a**5/15 - 2*sqrt(2)*sqrt(pi)*sqrt(E_star)*a**(3/2)*sqrt(dgamma) = F

    Parameters
    ----------
    F : array_like
        Normal force [N].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. NaN below pull-off. Handbook: quartic.adh.aF.

    References
    ----------
    chapter 11, equation (11.31); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.adhesive import quartic
    >>> value = quartic.radius_from_force(1.205, A=0.4, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.999956
    """
    require(A=A, E_star=E_star, dgamma=dgamma)
    return elementwise(_radius_from_force, F=F, A=A, E_star=E_star, dgamma=dgamma)


def pull_off(control: str = "force", *, A: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> PullOff:
    """State at which the contact breaks on unloading.

    Under control of the force:

        a_c = 2**(3/7)*3**(4/7)*pi**(1/7)*dgamma**(1/7)/(4*A**(2/7)*E_star**(1/7))
        F = -7*2**(1/7)*3**(6/7)*pi**(5/7)*E_star**(2/7)*dgamma**(5/7)/(20*A**(3/7))
        d = -5*2**(5/7)*3**(2/7)*pi**(4/7)*dgamma**(4/7)/(16*A**(1/7)*E_star**(4/7))

    Under control of the depth:

        a_c = 2**(3/7)*3**(2/7)*pi**(1/7)*dgamma**(1/7)/(4*A**(2/7)*E_star**(1/7))
        F = -9*2**(1/7)*3**(3/7)*pi**(5/7)*E_star**(2/7)*dgamma**(5/7)/(20*A**(3/7))
        d = -7*2**(5/7)*3**(1/7)*pi**(4/7)*dgamma**(4/7)/(16*A**(1/7)*E_star**(4/7))

    Parameters
    ----------
    control : {"force", "depth"}
        What is held while the contact is unloaded.
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    The least force, or depth, of a stable contact. Handbook: quartic.adh.ac, quartic.adh.am.

    References
    ----------
    chapter 11, equation (11.31); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.adhesive import quartic
    >>> state = quartic.pull_off(A=0.4, E_star=1.0, dgamma=0.01)
    >>> round(state.force, 6)
    -0.123912
    """
    require(A=A, E_star=E_star, dgamma=dgamma)
    require_control(control)
    radius = elementwise(partial(_pull_off_radius, control=control), A=A, E_star=E_star, dgamma=dgamma)
    force = elementwise(partial(_pull_off_force, control=control), radius, A=A, E_star=E_star, dgamma=dgamma)
    depth = elementwise(partial(_pull_off_depth, control=control), radius, A=A, E_star=E_star, dgamma=dgamma)
    return PullOff(radius, force, depth)


def work_of_adhesion_from_pull_off(F: ArrayLike, *, A: ArrayLike, E_star: ArrayLike) -> Result:
    """Work of separation at which a contact breaks under the normal force F: the inverse of the force of pull_off.

    dgamma = 20*14**(3/5)*45**(2/5)*A**(3/5)*abs(F)**(7/5)/(441*pi*E_star**(2/5))

    Parameters
    ----------
    F : array_like
        Normal force [N].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1. The force is a tension, F < 0: 0 without a force, NaN under
    pressure, which breaks no contact, and where no stable contact bears the tension.

    References
    ----------
    chapter 11, equation (11.31); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.adhesive import quartic
    >>> value = quartic.work_of_adhesion_from_pull_off(-0.1239, A=0.4, E_star=1.0)
    >>> round(value, 6)
    0.009999
    """
    require(A=A, E_star=E_star)
    return elementwise(_work_of_adhesion_from_pull_off, F=F, A=A, E_star=E_star)


def _depth(a: Array, A: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._depth(a, A) - hess_retraction(a, E_star, dgamma)


def _force(a: Array, A: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._force(a, A, E_star) - pull(a, E_star, dgamma)


def _pressure(r: Array, a: Array, A: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._pressure(r, a, A, E_star) - tension(r, a, E_star, dgamma)


def _displacement(r: Array, a: Array, A: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._displacement(r, a, A) - lift(r, a, E_star, dgamma)


def _pull_off_radius(A: Array, E_star: Array, dgamma: Array, control: str) -> Array:
    if control == "force":
        radius = nth_root(1 / A, 7) ** 2 * nth_root(81 * np.pi * dgamma / (2048 * E_star), 7)
    else:
        radius = nth_root(1 / A, 7) ** 2 * nth_root(9 * np.pi * dgamma / (2048 * E_star), 7)
    return np.where(dgamma > 0.0, radius, 0.0)


def _pull_off_depth(a: Array, A: Array, E_star: Array, dgamma: Array, control: str) -> Array:
    """With the retraction 2 a g'(a)/xi of pull-off, free of cancellation."""
    return normal._depth(a, A) * (1.0 - 8.0 / XI[control])


def _radius_from_depth(d: Array, A: Array, E_star: Array, dgamma: Array) -> Array:
    a_c = _pull_off_radius(A, E_star, dgamma, control="depth")
    least = _pull_off_depth(a_c, A, E_star, dgamma, control="depth")
    plain = normal._radius_from_depth(np.maximum(d, 0.0), A)
    return power_law_radius(d, a_c, least, 4.0, 0.5, plain)


def _pull_off_force(a: Array, A: Array, E_star: Array, dgamma: Array, control: str) -> Array:
    """With the retraction 2 a g'(a)/xi of pull-off, free of cancellation."""
    return normal._force(a, A, E_star) * (1.0 - 10.0 / XI[control])


def _radius_from_force(F: Array, A: Array, E_star: Array, dgamma: Array) -> Array:
    a_c = _pull_off_radius(A, E_star, dgamma, control="force")
    least = _pull_off_force(a_c, A, E_star, dgamma, control="force")
    plain = normal._radius_from_force(np.maximum(F, 0.0), A, E_star)
    return power_law_radius(F, a_c, least, 5.0, 1.5, plain)


def _work_of_adhesion_from_pull_off(F: Array, A: Array, E_star: Array) -> Array:
    pull = np.where(F < 0.0, -F, np.nan)
    lasting = 3 * pull / 7
    a = normal._radius_from_force(lasting, A, E_star)
    return np.where(F == 0.0, 0.0, separation(pull + lasting, a, E_star))
