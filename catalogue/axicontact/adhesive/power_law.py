"""Power law with adhesion.

Every self-similar profile: F ~ d^(1 + 1/n). Cone, paraboloid and quartic are n = 1, 2, 4.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from .._runtime.functions import nth_root
from .._runtime.interface import Array, Result, elementwise, require, require_order
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
from .._runtime.special import gamma_ratio
from ..normal import power_law as normal

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
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN radii give NaN. Handbook: power_law.adh.Dl.

    References
    ----------
    chapter 11, equation (11.31); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import power_law
    >>> value = power_law.retraction(1.0, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.250663
    """
    require(E_star=E_star, dgamma=dgamma)
    return elementwise(hess_retraction, a, E_star=E_star, dgamma=dgamma)


def depth(a: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Indentation depth at contact radius a; negative where adhesion pulls the surface up.

    d = sqrt(pi)*A*a**n*gamma(n/2 + 1)/gamma((n + 1)/2) - sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN radii give NaN. Handbook: power_law.adh.d.

    References
    ----------
    chapter 11, equation (11.31); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import power_law
    >>> value = power_law.depth(1.0, A=0.45, n=1.5, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.558082
    """
    require(A=A, n=n, E_star=E_star, dgamma=dgamma)
    return elementwise(_depth, a, A=A, n=n, E_star=E_star, dgamma=dgamma)


def force(a: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Normal force at contact radius a, negative in tension.

    F = 2*sqrt(pi)*A*E_star*a**(n + 1)*n*gamma(n/2 + 1)/((n + 1)*gamma((n + 1)/2)) -
    2*sqrt(2)*sqrt(pi)*sqrt(E_star)*a**(3/2)*sqrt(dgamma)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN radii give NaN. Handbook: power_law.adh.F.

    References
    ----------
    chapter 11, equation (11.31); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import power_law
    >>> value = power_law.force(1.0, A=0.45, n=1.5, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.469168
    """
    require(A=A, n=n, E_star=E_star, dgamma=dgamma)
    return elementwise(_force, a, A=A, n=n, E_star=E_star, dgamma=dgamma)


def pressure(r: ArrayLike, a: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact pressure, positive in compression, infinite tension at the edge; zero outside the contact.

    p = A*E_star*n*r**(n - 1)*IncompleteBeta(1 - r**2/a**2, 1/2, (1 - n)/2)*gamma(n/2 +
    1)/(2*sqrt(pi)*gamma((n + 1)/2)) - sqrt(2)*sqrt(E_star)*sqrt(a)*sqrt(dgamma)/(sqrt(pi)*sqrt(a**2 - r**2))
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
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN radii give NaN. Handbook: power_law.adh.p.

    References
    ----------
    chapter 11, equation (11.31); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import power_law
    >>> value = power_law.pressure(0.3, 1.0, A=0.45, n=1.5, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.423308
    """
    require(A=A, n=n, E_star=E_star, dgamma=dgamma)
    return elementwise(_pressure, r, a, A=A, n=n, E_star=E_star, dgamma=dgamma)


def displacement(
    r: ArrayLike, a: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike
) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = A*(2*a**n*asin(a/r) - r**n*IncompleteBeta(a**2/r**2, (n + 1)/2, 1/2))*gamma(n/2 +
    1)/(sqrt(pi)*gamma((n + 1)/2)) - 2*sqrt(2)*sqrt(a)*sqrt(dgamma)*asin(a/r)/(sqrt(pi)*sqrt(E_star))
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
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1. Negative or NaN radii give NaN. Handbook: power_law.adh.w.

    References
    ----------
    chapter 11, equation (11.31); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import power_law
    >>> value = power_law.displacement(2.0, 1.0, A=0.45, n=1.5, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    0.074795
    """
    require(A=A, n=n, E_star=E_star, dgamma=dgamma)
    return elementwise(_displacement, r, a, A=A, n=n, E_star=E_star, dgamma=dgamma)


def radius_from_depth(d: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact radius at indentation depth d, on the branch that is stable under a given depth.

    a from sqrt(pi)*A*a**n*gamma(n/2 + 1)/gamma((n + 1)/2) -
    sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star) = d

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1. NaN below pull-off. Exists only for n > 1/2. Handbook:
    power_law.adh.ad.

    References
    ----------
    chapter 11, equation (11.31); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import power_law
    >>> value = power_law.radius_from_depth(0.5581, A=0.45, n=1.5, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    1.000017
    """
    require(A=A, n=n, E_star=E_star, dgamma=dgamma)
    require_order(
        np.asarray(n) > 0.5,
        "n > 1/2",
        "a sharper profile has no pull-off, its adhesive contact is unstable at every radius; use n > 1/2, or"
        " force(a) and depth(a) for the states of equilibrium",
        n=n,
    )
    return elementwise(_radius_from_depth, d=d, A=A, n=n, E_star=E_star, dgamma=dgamma)


def radius_from_force(F: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> Result:
    """Contact radius under the normal force F, on the branch that is stable under a given force.

    a from 2*sqrt(pi)*A*E_star*a**(n + 1)*n*gamma(n/2 + 1)/((n + 1)*gamma((n + 1)/2)) -
    2*sqrt(2)*sqrt(pi)*sqrt(E_star)*a**(3/2)*sqrt(dgamma) = F

    Parameters
    ----------
    F : array_like
        Normal force [N].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1. NaN below pull-off. Exists only for n > 1/2. Handbook:
    power_law.adh.aF.

    References
    ----------
    chapter 11, equation (11.31); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import power_law
    >>> value = power_law.radius_from_force(0.4692, A=0.45, n=1.5, E_star=1.0, dgamma=0.01)
    >>> round(value, 6)
    1.000019
    """
    require(A=A, n=n, E_star=E_star, dgamma=dgamma)
    require_order(
        np.asarray(n) > 0.5,
        "n > 1/2",
        "a sharper profile has no pull-off, its adhesive contact is unstable at every radius; use n > 1/2, or"
        " force(a) and depth(a) for the states of equilibrium",
        n=n,
    )
    return elementwise(_radius_from_force, F=F, A=A, n=n, E_star=E_star, dgamma=dgamma)


def pull_off(control: str = "force", *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike) -> PullOff:
    """State at which the contact breaks on unloading.

    Under control of the force:

        a_c = (3*sqrt(2)*sqrt(dgamma)*gamma((n + 1)/2)/(2*A*sqrt(E_star)*n*gamma(n/2 + 1)))**(1/(n - 1/2))
        F = -2*sqrt(pi)*A*E_star*a_c**(n + 1)*n*(2*n - 1)*gamma(n/2 + 1)/(3*(n + 1)*gamma((n + 1)/2))
        d = -sqrt(pi)*A*a_c**n*(2*n - 3)*gamma(n/2 + 1)/(3*gamma((n + 1)/2))

    Under control of the depth:

        a_c = (sqrt(2)*sqrt(dgamma)*gamma((n + 1)/2)/(2*A*sqrt(E_star)*n*gamma(n/2 + 1)))**(1/(n - 1/2))
        F = -2*sqrt(pi)*A*E_star*a_c**(n + 1)*n*(2*n + 1)*gamma(n/2 + 1)/((n + 1)*gamma((n + 1)/2))
        d = -sqrt(pi)*A*a_c**n*(2*n - 1)*gamma(n/2 + 1)/gamma((n + 1)/2)

    Parameters
    ----------
    control : {"force", "depth"}
        What is held while the contact is unloaded.
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    The least force, or depth, of a stable contact. Exists only for n > 1/2. Handbook: power_law.adh.ac,
    power_law.adh.am.

    References
    ----------
    chapter 11, equation (11.31); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import power_law
    >>> state = power_law.pull_off(A=0.45, n=1.5, E_star=1.0, dgamma=0.01)
    >>> round(state.force, 6)
    -0.034602
    """
    require(A=A, n=n, E_star=E_star, dgamma=dgamma)
    require_control(control)
    require_order(
        np.asarray(n) > 0.5,
        "n > 1/2",
        "a sharper profile has no pull-off, its adhesive contact is unstable at every radius; use n > 1/2, or"
        " force(a) and depth(a) for the states of equilibrium",
        n=n,
    )
    radius = elementwise(partial(_pull_off_radius, control=control), A=A, n=n, E_star=E_star, dgamma=dgamma)
    force = elementwise(partial(_pull_off_force, control=control), radius, A=A, n=n, E_star=E_star, dgamma=dgamma)
    depth = elementwise(partial(_pull_off_depth, control=control), radius, A=A, n=n, E_star=E_star, dgamma=dgamma)
    return PullOff(radius, force, depth)


def work_of_adhesion_from_pull_off(F: ArrayLike, *, A: ArrayLike, n: ArrayLike, E_star: ArrayLike) -> Result:
    """Work of separation at which a contact breaks under the normal force F: the inverse of the force of pull_off.

    dgamma = abs(F)**2*(8*pi**(3/2)*A**3*E_star**3*n**3*(2*n - 1)**3*gamma(n/2 + 1)**3/(27*abs(F)**3*(n +
    1)**3*gamma((n + 1)/2)**3))**(1/(n + 1))*(n + 1)**2/(2*pi*E_star*(2*n - 1)**2)

    Parameters
    ----------
    F : array_like
        Normal force [N].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes, n A a^(n-1) << 1. The force is a tension, F < 0: 0 without a force, NaN under
    pressure, which breaks no contact, and where no stable contact bears the tension.

    References
    ----------
    chapter 11, equation (11.31); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.adhesive import power_law
    >>> value = power_law.work_of_adhesion_from_pull_off(-0.0346, A=0.45, n=1.5, E_star=1.0)
    >>> round(value, 6)
    0.01
    """
    require(A=A, n=n, E_star=E_star)
    require_order(
        np.asarray(n) > 0.5,
        "n > 1/2",
        "a sharper profile has no pull-off, its adhesive contact is unstable at every radius; use n > 1/2, or"
        " force(a) and depth(a) for the states of equilibrium",
        n=n,
    )
    return elementwise(_work_of_adhesion_from_pull_off, F=F, A=A, n=n, E_star=E_star)


def _depth(a: Array, A: Array, n: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._depth(a, A, n) - hess_retraction(a, E_star, dgamma)


def _force(a: Array, A: Array, n: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._force(a, A, n, E_star) - pull(a, E_star, dgamma)


def _pressure(r: Array, a: Array, A: Array, n: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._pressure(r, a, A, n, E_star) - tension(r, a, E_star, dgamma)


def _displacement(r: Array, a: Array, A: Array, n: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._displacement(r, a, A, n) - lift(r, a, E_star, dgamma)


def _pull_off_radius(A: Array, n: Array, E_star: Array, dgamma: Array, control: str) -> Array:
    kappa = gamma_ratio(n / 2 + 1 / 2)
    if control == "force":
        ratio = 3 * np.sqrt(2 * dgamma / E_star) / (2 * n * A * kappa)
        radius = nth_root(ratio, 2 * n - 1) ** 2
    else:
        ratio = np.sqrt(2 * dgamma / E_star) / (2 * n * A * kappa)
        radius = nth_root(ratio, 2 * n - 1) ** 2
    return np.where(n > 0.5, np.where(dgamma > 0.0, radius, 0.0), np.nan)


def _pull_off_depth(a: Array, A: Array, n: Array, E_star: Array, dgamma: Array, control: str) -> Array:
    """With the retraction 2 a g'(a)/xi of pull-off, free of cancellation."""
    return normal._depth(a, A, n) * (1.0 - 2 * n / XI[control])


def _radius_from_depth(d: Array, A: Array, n: Array, E_star: Array, dgamma: Array) -> Array:
    a_c = _pull_off_radius(A, n, E_star, dgamma, control="depth")
    least = _pull_off_depth(a_c, A, n, E_star, dgamma, control="depth")
    plain = normal._radius_from_depth(np.maximum(d, 0.0), A, n)
    return power_law_radius(d, a_c, least, n, 0.5, plain)


def _pull_off_force(a: Array, A: Array, n: Array, E_star: Array, dgamma: Array, control: str) -> Array:
    """With the retraction 2 a g'(a)/xi of pull-off, free of cancellation."""
    return normal._force(a, A, n, E_star) * (1.0 - 2 * (n + 1) / XI[control])


def _radius_from_force(F: Array, A: Array, n: Array, E_star: Array, dgamma: Array) -> Array:
    a_c = _pull_off_radius(A, n, E_star, dgamma, control="force")
    least = _pull_off_force(a_c, A, n, E_star, dgamma, control="force")
    plain = normal._radius_from_force(np.maximum(F, 0.0), A, n, E_star)
    return power_law_radius(F, a_c, least, n + 1, 1.5, plain)


def _work_of_adhesion_from_pull_off(F: Array, A: Array, n: Array, E_star: Array) -> Array:
    pull = np.where(F < 0.0, -F, np.nan)
    lasting = 3 * pull / (2 * n - 1)
    a = normal._radius_from_force(lasting, A, n, E_star)
    return np.where(F == 0.0, 0.0, separation(pull + lasting, a, E_star))
