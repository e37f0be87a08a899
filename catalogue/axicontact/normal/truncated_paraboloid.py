"""Truncated paraboloid.

Flat face of radius b with a parabolic flank: a worn sphere.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Plain, Result, elementwise, require, require_reach
from .._runtime.inverse import between, inverse
from .._runtime.rules import displacement_integral_beyond, pressure_integral_beyond
from .._runtime.shapes.energy import energy_integral_beyond
from .._runtime.shapes.load_within import load_within_integral_beyond

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "depth",
    "depth_from_force",
    "displacement",
    "energy",
    "force",
    "force_from_depth",
    "load_within",
    "mean_pressure",
    "pressure",
    "profile",
    "radius_from_depth",
    "radius_from_force",
    "stiffness",
]


def __dir__() -> list[str]:
    return __all__


plain = Plain(__name__, __all__)


def profile(r: ArrayLike, *, R: ArrayLike, b: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = 0   for 0 < r < b
    f = (-b**2 + r**2)/(2*R)   for b < r

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.

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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: truncated_paraboloid.f, the definition
    of the profile.

    References
    ----------
    Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.profile(0.3, R=1.2, b=0.5)
    >>> round(value, 6)
    0.0
    """
    value = plain.profile(r, R, b)
    if value is not None:
        return value
    require(R=R, b=b)
    return elementwise(_profile, r, R=R, b=b)


def depth(a: ArrayLike, *, R: ArrayLike, b: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = a*sqrt(a**2 - b**2)/R

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.

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
    Valid for a << R. Negative or NaN field values, and radii below b among larger ones, give NaN. The
    pressure is logarithmically infinite at the corner r = b. Handbook: truncated_paraboloid.d.

    References
    ----------
    chapter 11, equation (11.29); Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.depth(1.0, R=1.2, b=0.5)
    >>> round(value, 6)
    0.721688
    """
    value = plain.depth(a, R, b)
    if value is not None:
        return value
    require(R=R, b=b)
    require_reach(a, b)
    return elementwise(_depth, a, R=R, b=b)


def force(a: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force.

    F = 2*E_star*sqrt(a**2 - b**2)*(2*a**2 + b**2)/(3*R)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.
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
    Valid for a << R. Negative or NaN field values, and radii below b among larger ones, give NaN. The
    pressure is logarithmically infinite at the corner r = b. Handbook: truncated_paraboloid.F.

    References
    ----------
    chapter 11, equation (11.20); Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.force(1.0, R=1.2, b=0.5, E_star=1.0)
    >>> round(value, 6)
    1.082532
    """
    value = plain.force(a, R, b, E_star)
    if value is not None:
        return value
    require(R=R, b=b, E_star=E_star)
    require_reach(a, b)
    return elementwise(_force, a, R=R, b=b, E_star=E_star)


def pressure(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = E_star*(2*a*sqrt(a**2 - b**2)/sqrt(a**2 - r**2) - 2*b*elliptic_e(asin(sqrt((a**2 - b**2)/(a**2 -
    r**2))), r**2/b**2) + b*elliptic_f(asin(sqrt((a**2 - b**2)/(a**2 - r**2))), r**2/b**2))/(pi*R)   for r < b
    p = E_star*(2*a*sqrt(a**2 - r**2)/sqrt(a**2 - b**2) - 2*r*elliptic_e(asin(sqrt((a**2 - r**2)/(a**2 -
    b**2))), b**2/r**2) + (-b**2 + 2*r**2)*elliptic_f(asin(sqrt((a**2 - r**2)/(a**2 - b**2))),
    b**2/r**2)/r)/(pi*R)   for b < r
    with elliptic integrals of the parameter m = k**2, their last argument

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.
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
    Valid for a << R. Negative or NaN field values, and radii below b among larger ones, give NaN. Evaluated
    as an integral over the growing contact by a Gauss-Legendre rule. The pressure is logarithmically infinite
    at the corner r = b. Handbook: truncated_paraboloid.p.

    References
    ----------
    chapter 11, equation (11.23); Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.pressure(0.3, 1.0, R=1.2, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.360444
    """
    value = plain.pressure(r, a, R, b, E_star)
    if value is not None:
        return value
    require(R=R, b=b, E_star=E_star)
    require_reach(a, b)
    return elementwise(_pressure, r, a, R=R, b=b, E_star=E_star)


def displacement(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, b: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = (2*a*sqrt(a**2 - b**2)*asin(a/r) + sqrt(-a**2 + r**2)*sqrt(a**2 - b**2) - (-b + r)*(b +
    r)*asin(sqrt((a**2 - b**2)/(-b**2 + r**2))))/(pi*R)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.

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
    Valid for a << R. Negative or NaN field values, and radii below b among larger ones, give NaN. Evaluated
    as an integral over the growing contact by a Gauss-Legendre rule. Handbook: truncated_paraboloid.w.

    References
    ----------
    chapter 11, equation (11.26); Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.displacement(2.0, 1.0, R=1.2, b=0.5)
    >>> round(value, 6)
    0.177251
    """
    value = plain.displacement(r, a, R, b)
    if value is not None:
        return value
    require(R=R, b=b)
    require_reach(a, b)
    return elementwise(_displacement, r, a, R=R, b=b)


def stiffness(a: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*E_star*a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.
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
    Valid for a << R. Negative or NaN field values, and radii below b among larger ones, give NaN. Handbook:
    truncated_paraboloid.k.

    References
    ----------
    chapter 11, equation (11.18); Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.stiffness(1.0, R=1.2, b=0.5, E_star=1.0)
    >>> round(value, 6)
    2.0
    """
    value = plain.stiffness(a, E_star, R, b)
    if value is not None:
        return value
    require(R=R, b=b, E_star=E_star)
    require_reach(a, b)
    return elementwise(_stiffness, a, E_star=E_star, unused=(R, b))


def mean_pressure(a: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = 2*E_star*sqrt(a**2 - b**2)*(2*a**2 + b**2)/(3*pi*R*a**2)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

    Returns
    -------
    float or ndarray
        Mean pressure F/(pi a^2) [Pa]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R. Negative or NaN field values, and radii below b among larger ones, give NaN. Handbook:
    truncated_paraboloid.pm.

    References
    ----------
    Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.mean_pressure(1.0, R=1.2, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.344581
    """
    value = plain.mean_pressure(a, R, b, E_star)
    if value is not None:
        return value
    require(R=R, b=b, E_star=E_star)
    require_reach(a, b)
    return elementwise(_mean_pressure, a, R=R, b=b, E_star=E_star)


def radius_from_depth(d: ArrayLike, *, R: ArrayLike, b: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a = sqrt(2)*sqrt(R)*sqrt(b**2/R + sqrt(4*R**2*d**2 + b**4)/R)/2

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.

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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: truncated_paraboloid.ad.

    References
    ----------
    chapter 11, equation (11.16); Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.radius_from_depth(0.7217, R=1.2, b=0.5)
    >>> round(value, 6)
    1.000007
    """
    value = plain.radius_from_depth(d, R, b)
    if value is not None:
        return value
    require(R=R, b=b)
    return elementwise(_radius_from_depth, d, R=R, b=b)


def radius_from_force(F: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a = sqrt(2*b**2*sinh(asinh(3*sqrt(2)*F*R/(4*E_star*b**3))/3)**2 + b**2)

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.

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
    Valid for a << R. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton iteration.
    Handbook: truncated_paraboloid.aF.

    References
    ----------
    chapter 11, equation (11.20); Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.radius_from_force(1.083, R=1.2, b=0.5, E_star=1.0)
    >>> round(value, 6)
    1.000139
    """
    value = plain.radius_from_force(F, R, b, E_star)
    if value is not None:
        return value
    require(R=R, b=b, E_star=E_star)
    return elementwise(_radius_from_force, F, R=R, b=b, E_star=E_star)


def force_from_depth(d: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = 2*E_star*sqrt(R*(b**2/R + sqrt(4*R**2*d**2 + b**4)/R)/2 - b**2)*(R*(b**2/R + sqrt(4*R**2*d**2 +
    b**4)/R) + b**2)/(3*R)

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.
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
    Valid for a << R. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton iteration.
    Handbook: truncated_paraboloid.Fd.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.force_from_depth(0.7217, R=1.2, b=0.5, E_star=1.0)
    >>> round(value, 6)
    1.082556
    """
    value = plain.force_from_depth(d, R, b, E_star)
    if value is not None:
        return value
    require(R=R, b=b, E_star=E_star)
    return elementwise(_force_from_depth, d, R=R, b=b, E_star=E_star)


def depth_from_force(F: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = sqrt(2)*b*sqrt(2*b**2*sinh(asinh(3*sqrt(2)*F*R/(4*E_star*b**3))/3)**2 +
    b**2)*sinh(asinh(3*sqrt(2)*F*R/(4*E_star*b**3))/3)/R

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.
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
    Valid for a << R. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton iteration.
    Handbook: truncated_paraboloid.dF.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.depth_from_force(1.083, R=1.2, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.721922
    """
    value = plain.depth_from_force(F, R, b, E_star)
    if value is not None:
        return value
    require(R=R, b=b, E_star=E_star)
    return elementwise(_depth_from_force, F, R=R, b=b, E_star=E_star)


def energy(a: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Elastic energy, the work of pressing the indenter in.

    U = 2*E_star*(a - b)*(4*a**4 + 4*a**3*b + 4*a**2*b**2 + 4*a*b**3 - b**4)/(15*R**2)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.
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
    Valid for a << R. Negative or NaN field values, and radii below b among larger ones, give NaN. Evaluated
    as an integral over the growing contact by a Gauss-Legendre rule. Handbook: truncated_paraboloid.U.

    References
    ----------
    Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.energy(1.0, R=1.2, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.344329
    """
    value = plain.energy(a, R, b, E_star)
    if value is not None:
        return value
    require(R=R, b=b, E_star=E_star)
    require_reach(a, b)
    return elementwise(_energy, a, R=R, b=b, E_star=E_star)


def load_within(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Part of the normal force that is carried within the radius r; all of it beyond the contact.

    F_r = 2*E_star*(a*sqrt(a**2 - b**2)*(-2*a**2 - b**2 + 4*r**2)/sqrt(a**2 - r**2) + b*(-b + r)*(b +
    r)*elliptic_f(asin(sqrt((a**2 - b**2)/(a**2 - r**2))), r**2/b**2) - b*(-b**2 +
    2*r**2)*elliptic_e(asin(sqrt((a**2 - b**2)/(a**2 - r**2))), r**2/b**2) + sqrt(a**2 - b**2)*(2*a**2 +
    b**2))/(3*R)   for r < b
    F_r = 2*E_star*(a*sqrt(a**2 - r**2)*(-2*a**2 + b**2 + 2*r**2)/sqrt(a**2 - b**2) + 2*r*(-b + r)*(b +
    r)*elliptic_f(asin(sqrt((a**2 - r**2)/(a**2 - b**2))), b**2/r**2) - r*(-b**2 +
    2*r**2)*elliptic_e(asin(sqrt((a**2 - r**2)/(a**2 - b**2))), b**2/r**2) + sqrt(a**2 - b**2)*(2*a**2 +
    b**2))/(3*R)   for b < r
    with elliptic integrals of the parameter m = k**2, their last argument

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    b : array_like
        Radius of the flat face [m], b > 0.
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
    Valid for a << R. Negative or NaN field values, and radii below b among larger ones, give NaN. Evaluated
    as an integral over the growing contact by a Gauss-Legendre rule. Handbook: truncated_paraboloid.Fr.

    References
    ----------
    Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.load_within(0.3, 1.0, R=1.2, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.095867
    """
    value = plain.load_within(r, a, R, b, E_star)
    if value is not None:
        return value
    require(R=R, b=b, E_star=E_star)
    require_reach(a, b)
    return elementwise(_load_within, r, a, R=R, b=b, E_star=E_star)


def _profile(r: Array, R: Array, b: Array) -> Array:
    return np.where(r < b, 0, (r - b) * (r + b) / (2 * R))


def _slope_beyond(t: Array, root: Array, R: Array, b: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t) for t > b."""
    return 2 * root / R + b**2 / (R * root)


def _depth_at(a: Array, root: Array, R: Array) -> Array:
    return a * root / R


def _depth(a: Array, R: Array, b: Array) -> Array:
    root = np.sqrt((a - b) * (a + b))
    return _depth_at(a, root, R)


def _force_at(a: Array, root: Array, R: Array, b: Array, E_star: Array) -> Array:
    return 2 * E_star / (3 * R) * (2 * a**2 + b**2) * root


def _force(a: Array, R: Array, b: Array, E_star: Array) -> Array:
    root = np.sqrt((a - b) * (a + b))
    return _force_at(a, root, R, b, E_star)


def _pressure(r: Array, a: Array, R: Array, b: Array, E_star: Array) -> Array:
    growth = pressure_integral_beyond(_slope_beyond, (R, b), r, a, b)
    pressed = np.where((r == b) & (a > b), np.inf, E_star / np.pi * growth)
    inside = np.where(r < a, pressed, 0.0)
    return np.where(a >= b, inside, np.nan)


def _displacement(r: Array, a: Array, R: Array, b: Array) -> Array:
    beyond = displacement_integral_beyond(_slope_beyond, (R, b), r, a, b)
    outside = 2 / np.pi * beyond
    inside = _depth(a, R, b) - _profile(r, R, b)
    return np.where(a >= b, np.where(r > a, outside, inside), np.nan)


def _stiffness(a: Array, E_star: Array) -> Array:
    return 2 * E_star * a


def _mean_pressure(a: Array, R: Array, b: Array, E_star: Array) -> Array:
    root = np.sqrt((a - b) * (a + b))
    return 4 * E_star / (3 * np.pi * R) * root + 2 * E_star * b**2 * root / (3 * np.pi * a**2 * R)


def _energy(a: Array, R: Array, b: Array, E_star: Array) -> Array:
    sunk = _depth(a, R, b)
    beyond = energy_integral_beyond(_depth_at, (R,), a, sunk, b)
    return np.where(a >= b, E_star * (b * sunk * sunk + beyond), np.nan)


def _load_within(r: Array, a: Array, R: Array, b: Array, E_star: Array) -> Array:
    beyond = load_within_integral_beyond(_slope_beyond, (R, b), r, a, b)
    found = np.where(r > b, _force(np.maximum(np.minimum(r, a), b), R, b, E_star), 0.0) + 2 * E_star * beyond
    return np.where(a >= b, found, np.nan)


def _radius_from_depth(d: Array, R: Array, b: Array) -> Array:
    root = np.sqrt(b**4 + 4 * R**2 * d**2)
    root_1 = np.sqrt(root / R + b**2 / R)
    return root_1 * np.sqrt(2 * R) / 2


def _contact_from_force(F: Array, R: Array, b: Array, E_star: Array) -> tuple[Array, Array]:
    """Contact radius a and its root sqrt(a**2 - b**2)."""

    def curve(t: Array) -> tuple[Array, Array]:
        a, root = b * np.sqrt(1.0 + t * t), b * t
        value = _force_at(a, root, R, b, E_star)
        return value, 2 * E_star * root * root * _slope_beyond(a, root, R, b) / value

    rest = (0.9990587, 0.3089073, -0.7678073, 7.512052, -39.30687, 76.63965, -63.48232, 19.09787)
    start = between(np.log(F / curve(1.0)[0]), (0.6, 1.0), (0.4, 3.0), -1.75, rest)
    t = inverse(curve, F, start, (1.0, 3.0), smooth=True)
    return b * np.sqrt(1.0 + t * t), b * t


def _radius_from_force(F: Array, R: Array, b: Array, E_star: Array) -> Array:
    return _contact_from_force(F, R, b, E_star)[0]


def _contact_from_depth(d: Array, R: Array, b: Array) -> tuple[Array, Array]:
    """Contact radius a and its root sqrt(a**2 - b**2)."""

    def curve(t: Array) -> tuple[Array, Array]:
        a, root = b * np.sqrt(1.0 + t * t), b * t
        value = _depth_at(a, root, R)
        return value, root * root / a * _slope_beyond(a, root, R, b) / value

    rest = (0.9996917, 0.05914493, 0.009062067, 1.353675, -12.15272, 28.05264, -25.52146, 8.200478)
    start = between(np.log(d / curve(1.0)[0]), (0.7071, 1.0), (0.7071, 2.0), -3.0, rest)
    t = inverse(curve, d, start, (1.0, 2.0), smooth=True)
    return b * np.sqrt(1.0 + t * t), b * t


def _force_from_depth(d: Array, R: Array, b: Array, E_star: Array) -> Array:
    a, root = _contact_from_depth(d, R, b)
    change = np.where((a > 0.0) & (a < np.inf), 2 * E_star * a * (d - _depth_at(a, root, R)), 0.0)
    return _force_at(a, root, R, b, E_star) + change


def _depth_from_force(F: Array, R: Array, b: Array, E_star: Array) -> Array:
    a, root = _contact_from_force(F, R, b, E_star)
    change = np.where((a > 0.0) & (a < np.inf), (F - _force_at(a, root, R, b, E_star)) / (2 * E_star * a), 0.0)
    return _depth_at(a, root, R) + change
