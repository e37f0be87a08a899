"""Cylinder with a parabolic cap.

A paraboloid until the depth a^2/R brings the sharp edge into contact, a curved punch from then on.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.functions import beside, difference_of_products
from .._runtime.interface import Array, Plain, Result, elementwise, require
from .._runtime.kernels import OUTSIDE_2

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["depth_from_force", "displacement", "energy", "force", "load_within", "pressure", "profile", "stiffness"]


def __dir__() -> list[str]:
    return __all__


plain = Plain(__name__, __all__)


def profile(r: ArrayLike, *, a: ArrayLike, R: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = r**2/(2*R)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m], a > 0.
    R : array_like
        Radius of curvature [m], R > 0.

    Returns
    -------
    float or ndarray
        Profile of the indenter, measured from its apex [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R. Negative or NaN field values give NaN. Handbook: capped_cylinder.f, the definition of
    the profile.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import capped_cylinder
    >>> value = capped_cylinder.profile(0.3, a=1.0, R=2.2)
    >>> round(value, 6)
    0.020455
    """
    value = plain.profile(r, a, R)
    if value is not None:
        return value
    require(a=a, R=R)
    return elementwise(_profile, r, a=a, R=R)


def force(d: ArrayLike, *, a: ArrayLike, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force.

    F = 4*E_star*sqrt(R)*d**(3/2)/3   for sqrt(R)*sqrt(d) < a
    F = 2*E_star*a*(d - a**2/(3*R))   for a < sqrt(R)*sqrt(d)

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    R : array_like
        Radius of curvature [m], R > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: capped_cylinder.F.

    References
    ----------
    chapter 11, equation (11.13); chapter 11, equation (11.20); Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import capped_cylinder
    >>> value = capped_cylinder.force(0.6, a=1.0, R=2.2, E_star=1.0)
    >>> round(value, 6)
    0.89697
    """
    value = plain.force(d, a, R, E_star)
    if value is not None:
        return value
    require(a=a, R=R, E_star=E_star)
    return elementwise(_force, d, a=a, R=R, E_star=E_star)


def pressure(r: ArrayLike, d: ArrayLike, *, a: ArrayLike, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = 2*E_star*sqrt(R*d - r**2)/(pi*R)   for sqrt(R)*sqrt(d) < a
    p = E_star*(d/sqrt(a**2 - r**2) - a**2/(R*sqrt(a**2 - r**2)) + 2*sqrt(a**2 - r**2)/R)/pi   for a <
    sqrt(R)*sqrt(d)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    R : array_like
        Radius of curvature [m], R > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: capped_cylinder.p.

    References
    ----------
    chapter 11, equation (11.15); chapter 11, equation (11.107); Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import capped_cylinder
    >>> value = capped_cylinder.pressure(0.3, 0.6, a=1.0, R=2.2, E_star=1.0)
    >>> round(value, 6)
    0.324579
    """
    value = plain.pressure(r, d, a, R, E_star)
    if value is not None:
        return value
    require(a=a, R=R, E_star=E_star)
    return elementwise(_pressure, r, d, a=a, R=R, E_star=E_star)


def displacement(r: ArrayLike, d: ArrayLike, *, a: ArrayLike, R: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = (sqrt(R)*sqrt(d)*sqrt(-R*d + r**2) - (-2*R*d + r**2)*asin(sqrt(R)*sqrt(d)/r))/(pi*R)   for
    sqrt(R)*sqrt(d) < a
    w = (2*d*asin(a/r) + a*sqrt(-a**2 + r**2)/R - r**2*asin(a/r)/R)/pi   for a < sqrt(R)*sqrt(d)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    R : array_like
        Radius of curvature [m], R > 0.

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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: capped_cylinder.w.

    References
    ----------
    chapter 11, equation (11.12); chapter 11, equation (11.105); Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import capped_cylinder
    >>> value = capped_cylinder.displacement(2.0, 0.6, a=1.0, R=2.2)
    >>> round(value, 6)
    0.147574
    """
    value = plain.displacement(r, d, a, R)
    if value is not None:
        return value
    require(a=a, R=R)
    return elementwise(_displacement, r, d, a=a, R=R)


def stiffness(d: ArrayLike, *, a: ArrayLike, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*E_star*sqrt(R)*sqrt(d)   for sqrt(R)*sqrt(d) < a
    dF/dd = 2*E_star*a   for a < sqrt(R)*sqrt(d)

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    R : array_like
        Radius of curvature [m], R > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Contact stiffness dF/dd [N/m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R. Negative or NaN field values give NaN. Handbook: capped_cylinder.k.

    References
    ----------
    chapter 11, equation (11.14); Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import capped_cylinder
    >>> value = capped_cylinder.stiffness(0.6, a=1.0, R=2.2, E_star=1.0)
    >>> round(value, 6)
    2.0
    """
    value = plain.stiffness(d, a, R, E_star)
    if value is not None:
        return value
    require(a=a, R=R, E_star=E_star)
    return elementwise(_stiffness, d, a=a, R=R, E_star=E_star)


def depth_from_force(F: ArrayLike, *, a: ArrayLike, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = 6**(2/3)*F**(2/3)/(4*E_star**(2/3)*R**(1/3))   for F < 4*E_star*a**3/(3*R)
    d = a**2/(3*R) + F/(2*E_star*a)   for 4*E_star*a**3/(3*R) < F

    Parameters
    ----------
    F : array_like
        Normal force [N].
    a : array_like
        Contact radius [m], a > 0.
    R : array_like
        Radius of curvature [m], R > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: capped_cylinder.dF.

    References
    ----------
    chapter 11, equation (11.14); chapter 11, equation (11.20); Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import capped_cylinder
    >>> value = capped_cylinder.depth_from_force(0.897, a=1.0, R=2.2, E_star=1.0)
    >>> round(value, 6)
    0.600015
    """
    value = plain.depth_from_force(F, a, R, E_star)
    if value is not None:
        return value
    require(a=a, R=R, E_star=E_star)
    return elementwise(_depth_from_force, F, a=a, R=R, E_star=E_star)


def energy(d: ArrayLike, *, a: ArrayLike, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Elastic energy, the work of pressing the indenter in.

    U = 8*E_star*sqrt(R)*d**(5/2)/15   for sqrt(R)*sqrt(d) < a
    U = E_star*(a*d**2 - 2*a**3*d/(3*R) + a**5/(5*R**2))   for a < sqrt(R)*sqrt(d)

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    R : array_like
        Radius of curvature [m], R > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Elastic energy, the work of pressing the indenter in [J]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R. Negative or NaN field values give NaN. Handbook: capped_cylinder.U.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import capped_cylinder
    >>> value = capped_cylinder.energy(0.6, a=1.0, R=2.2, E_star=1.0)
    >>> round(value, 6)
    0.219504
    """
    value = plain.energy(d, a, R, E_star)
    if value is not None:
        return value
    require(a=a, R=R, E_star=E_star)
    return elementwise(_energy, d, a=a, R=R, E_star=E_star)


def load_within(r: ArrayLike, d: ArrayLike, *, a: ArrayLike, R: ArrayLike, E_star: ArrayLike) -> Result:
    """Part of the normal force that is carried within the radius r; all of it beyond the contact.

    F_r = 4*E_star*(R**(3/2)*d**(3/2) + (-sqrt(R)*sqrt(d) + r)*(sqrt(R)*sqrt(d) + r)*sqrt(R*d - r**2))/(3*R)
    for sqrt(R)*sqrt(d) < a
    F_r = 2*E_star*(2*r**2*sqrt(a**2 - r**2) + (a - sqrt(a**2 - r**2))*(3*R*d - a**2))/(3*R)   for a <
    sqrt(R)*sqrt(d)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    R : array_like
        Radius of curvature [m], R > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Part of the normal force that is carried within the radius r [N]. The shape to which the arguments
        broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R. Negative or NaN field values give NaN. Handbook: capped_cylinder.Fr.

    References
    ----------
    Schubert 1942.

    Examples
    --------
    >>> from axicontact.normal import capped_cylinder
    >>> value = capped_cylinder.load_within(0.3, 0.6, a=1.0, R=2.2, E_star=1.0)
    >>> round(value, 6)
    0.093348
    """
    value = plain.load_within(r, d, a, R, E_star)
    if value is not None:
        return value
    require(a=a, R=R, E_star=E_star)
    return elementwise(_load_within, r, d, a=a, R=R, E_star=E_star)


def _profile(r: Array, a: Array, R: Array) -> Array:
    return np.where(r <= a, r**2 / (2 * R), np.nan)


def _force(d: Array, a: Array, R: Array, E_star: Array) -> Array:
    excess = difference_of_products(R, d, a, a) / R
    rho = np.minimum(np.sqrt(R * d), a)
    return 4 * E_star / 3 * rho * np.minimum(d, a**2 / R) + 2 * E_star * a * np.maximum(excess, 0.0)


def _stiffness(d: Array, a: Array, R: Array, E_star: Array) -> Array:
    rho = np.minimum(np.sqrt(R * d), a)
    return 2 * E_star * rho


def _pressure(r: Array, d: Array, a: Array, R: Array, E_star: Array) -> Array:
    excess = difference_of_products(R, d, a, a) / R
    square = np.where(excess > 0.0, (a - r) * (a + r), difference_of_products(R, d, r, r))
    root = np.sqrt(np.maximum(square, 0.0))
    face = 2 * E_star * root / (np.pi * R)
    edge = np.where(excess > 0.0, E_star / np.pi * excess / np.sqrt((a - r) * (a + r)), 0.0)
    return np.where(r <= a, face + edge, 0.0)


def _displacement(r: Array, d: Array, a: Array, R: Array) -> Array:
    excess = difference_of_products(R, d, a, a) / R
    rho = np.minimum(np.sqrt(R * d), a)
    face = np.minimum(d, a**2 / R) * beside(r, rho, OUTSIDE_2)
    angle = np.arctan2(a, np.sqrt((r - a) * (r + a)))
    edge = np.where(excess > 0.0, np.maximum(excess, 0.0) * angle, 0.0)
    return np.where(r > rho, 2 / np.pi * (face + edge), d - _profile(r, a, R))


def _depth_from_force(F: Array, a: Array, R: Array, E_star: Array) -> Array:
    edge = 4 * E_star / (3 * R) * a**3
    below = np.cbrt(9 * F**2 / (16 * E_star**2 * R))
    above = F / (2 * E_star * a) + a**2 / (3 * R)
    return np.where(edge > F, below, above)


def _energy(d: Array, a: Array, R: Array, E_star: Array) -> Array:
    whole = np.sqrt(R * d)
    rho = np.minimum(whole, a)
    return 8 * E_star / (15 * R**2) * rho**5 + np.where(
        whole > a, -E_star / (3 * R**2) * a * (a**2 - R * d) * (a**2 + 3 * R * d), 0.0
    )


def _load_within(r: Array, d: Array, a: Array, R: Array, E_star: Array) -> Array:
    whole = np.sqrt(R * d)
    rho = np.minimum(whole, a)
    root = np.sqrt((a - r) * (a + r))
    root_rhor = np.sqrt((rho - r) * (rho + r))
    within = 4 * E_star / (3 * R) * r**2 * (root_rhor + rho**2 / (rho + root_rhor)) + np.where(
        whole > a, -2 * E_star * r**2 * (a**2 - R * d) / (R * (root + a)), 0.0
    )
    return np.where(r < rho, within, _force(d, a, R, E_star))
