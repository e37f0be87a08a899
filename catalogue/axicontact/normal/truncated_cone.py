"""Truncated cone.

Flat face of radius b with a conical flank: a worn or blunted cone. The contact radius starts at b.
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


def profile(r: ArrayLike, *, theta: ArrayLike, b: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = 0   for 0 < r < b
    f = (-b + r)*tan(theta)   for b < r

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: truncated_cone.f, the
    definition of the profile.

    References
    ----------
    Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_cone
    >>> value = truncated_cone.profile(0.3, theta=0.42, b=0.5)
    >>> round(value, 6)
    0.0
    """
    value = plain.profile(r, theta, b)
    if value is not None:
        return value
    require(theta=theta, b=b)
    return elementwise(_profile, r, theta=theta, b=b)


def depth(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = a*tan(theta)*acos(b/a)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values, and radii below b among larger ones, give NaN.
    The pressure is logarithmically infinite at the corner r = b. Handbook: truncated_cone.d.

    References
    ----------
    chapter 11, equation (11.29); Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_cone
    >>> value = truncated_cone.depth(1.0, theta=0.42, b=0.5)
    >>> round(value, 6)
    0.46765
    """
    value = plain.depth(a, theta, b)
    if value is not None:
        return value
    require(theta=theta, b=b)
    require_reach(a, b)
    return elementwise(_depth, a, theta=theta, b=b)


def force(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force.

    F = E_star*(a**2*acos(b/a) + b*sqrt(a**2 - b**2))*tan(theta)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values, and radii below b among larger ones, give NaN.
    The pressure is logarithmically infinite at the corner r = b. Handbook: truncated_cone.F.

    References
    ----------
    chapter 11, equation (11.20); Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_cone
    >>> value = truncated_cone.force(1.0, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.661021
    """
    value = plain.force(a, theta, b, E_star)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    require_reach(a, b)
    return elementwise(_force, a, theta=theta, b=b, E_star=E_star)


def pressure(r: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = E_star*(C0(b, r, a) + elliptic_f(asin(sqrt((a**2 - b**2)/(a**2 - r**2))), r**2/b**2))*tan(theta)/pi
    for r < b
    p = E_star*(b*elliptic_f(asin(sqrt((a**2 - r**2)/(a**2 - b**2))), b**2/r**2)/r + C0(b, r,
    a))*tan(theta)/pi   for b < r
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
    Valid for tan(theta) << 1. Negative or NaN field values, and radii below b among larger ones, give NaN.
    Evaluated as an integral over the growing contact by a Gauss-Legendre rule. The pressure is
    logarithmically infinite at the corner r = b. Handbook: truncated_cone.p.

    References
    ----------
    chapter 11, equation (11.23); Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_cone
    >>> value = truncated_cone.pressure(0.3, 1.0, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.252586
    """
    value = plain.pressure(r, a, theta, b, E_star)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    require_reach(a, b)
    return elementwise(_pressure, r, a, theta=theta, b=b, E_star=E_star)


def displacement(r: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*(a*acos(b/a)*asin(a/r) + b*asin(sqrt((a**2 - b**2)/(-b**2 + r**2))) - r*acos(b*sqrt(-a**2 +
    r**2)/(a*sqrt(-b**2 + r**2))) + sqrt(-a**2 + r**2)*acos(b/a))*tan(theta)/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values, and radii below b among larger ones, give NaN.
    Evaluated as an integral over the growing contact by a Gauss-Legendre rule. Handbook: truncated_cone.w.

    References
    ----------
    chapter 11, equation (11.26); Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_cone
    >>> value = truncated_cone.displacement(2.0, 1.0, theta=0.42, b=0.5)
    >>> round(value, 6)
    0.10793
    """
    value = plain.displacement(r, a, theta, b)
    if value is not None:
        return value
    require(theta=theta, b=b)
    require_reach(a, b)
    return elementwise(_displacement, r, a, theta=theta, b=b)


def stiffness(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*E_star*a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values, and radii below b among larger ones, give NaN.
    Handbook: truncated_cone.k.

    References
    ----------
    chapter 11, equation (11.18); Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_cone
    >>> value = truncated_cone.stiffness(1.0, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    2.0
    """
    value = plain.stiffness(a, E_star, theta, b)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    require_reach(a, b)
    return elementwise(_stiffness, a, E_star=E_star, unused=(theta, b))


def mean_pressure(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = E_star*(acos(b/a) + b*sqrt(a**2 - b**2)/a**2)*tan(theta)/pi

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values, and radii below b among larger ones, give NaN.
    Handbook: truncated_cone.pm.

    References
    ----------
    Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_cone
    >>> value = truncated_cone.mean_pressure(1.0, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.21041
    """
    value = plain.mean_pressure(a, theta, b, E_star)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    require_reach(a, b)
    return elementwise(_mean_pressure, a, theta=theta, b=b, E_star=E_star)


def radius_from_depth(d: ArrayLike, *, theta: ArrayLike, b: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a from a*tan(theta)*acos(b/a) = d

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: truncated_cone.ad.

    References
    ----------
    chapter 11, equation (11.16); Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_cone
    >>> value = truncated_cone.radius_from_depth(0.4677, theta=0.42, b=0.5)
    >>> round(value, 6)
    1.000069
    """
    value = plain.radius_from_depth(d, theta, b)
    if value is not None:
        return value
    require(theta=theta, b=b)
    return elementwise(_radius_from_depth, d, theta=theta, b=b)


def radius_from_force(F: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a from E_star*(a**2*acos(b/a) + b*sqrt(a**2 - b**2))*tan(theta) = F

    Parameters
    ----------
    F : array_like
        Normal force [N].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: truncated_cone.aF.

    References
    ----------
    chapter 11, equation (11.20); Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_cone
    >>> value = truncated_cone.radius_from_force(0.661, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.999985
    """
    value = plain.radius_from_force(F, theta, b, E_star)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    return elementwise(_radius_from_force, F, theta=theta, b=b, E_star=E_star)


def force_from_depth(d: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = F(a(d)), through the contact radius.

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: truncated_cone.Fd.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_cone
    >>> value = truncated_cone.force_from_depth(0.4677, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.661122
    """
    value = plain.force_from_depth(d, theta, b, E_star)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    return elementwise(_force_from_depth, d, theta=theta, b=b, E_star=E_star)


def depth_from_force(F: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = d(a(F)), through the contact radius.

    Parameters
    ----------
    F : array_like
        Normal force [N].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: truncated_cone.dF.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_cone
    >>> value = truncated_cone.depth_from_force(0.661, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.467639
    """
    value = plain.depth_from_force(F, theta, b, E_star)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    return elementwise(_depth_from_force, F, theta=theta, b=b, E_star=E_star)


def energy(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Elastic energy, the work of pressing the indenter in.

    U = E_star*(a**2*b*tan(theta)**2*acos(b/a)**2 + Integral((a*tan(theta)*acos(b/a) -
    t*tan(theta)*acos(b/t))**2, (t, b, a)))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values, and radii below b among larger ones, give NaN.
    Evaluated as an integral over the growing contact by a Gauss-Legendre rule. Handbook: truncated_cone.U.

    References
    ----------
    Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_cone
    >>> value = truncated_cone.energy(1.0, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.135109
    """
    value = plain.energy(a, theta, b, E_star)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    require_reach(a, b)
    return elementwise(_energy, a, theta=theta, b=b, E_star=E_star)


def load_within(r: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, E_star: ArrayLike) -> Result:
    """Part of the normal force that is carried within the radius r; all of it beyond the contact.

    F_r = E_star*(a**2*acos(b/a) - a*b*sqrt(a**2 - b**2)/sqrt(a**2 - r**2) - a*sqrt(a**2 - r**2)*acos(b/a) +
    b**2*elliptic_e(asin(sqrt((a**2 - b**2)/(a**2 - r**2))), r**2/b**2) + b*sqrt(a**2 - b**2) + r**2*C0(b, r,
    a) + (-b + r)*(b + r)*elliptic_f(asin(sqrt((a**2 - b**2)/(a**2 - r**2))), r**2/b**2))*tan(theta)   for r <
    b
    F_r = E_star*(a**2*acos(b/a) - a*b*sqrt(a**2 - r**2)/sqrt(a**2 - b**2) - a*sqrt(a**2 - r**2)*acos(b/a) +
    b*r*elliptic_e(asin(sqrt((a**2 - r**2)/(a**2 - b**2))), b**2/r**2) + b*sqrt(a**2 - b**2) + r**2*C0(b, r,
    a))*tan(theta)   for b < r
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
    Valid for tan(theta) << 1. Negative or NaN field values, and radii below b among larger ones, give NaN.
    Evaluated as an integral over the growing contact by a Gauss-Legendre rule. Handbook: truncated_cone.Fr.

    References
    ----------
    Ejike 1981.

    Examples
    --------
    >>> from axicontact.normal import truncated_cone
    >>> value = truncated_cone.load_within(0.3, 1.0, theta=0.42, b=0.5, E_star=1.0)
    >>> round(value, 6)
    0.066597
    """
    value = plain.load_within(r, a, theta, b, E_star)
    if value is not None:
        return value
    require(theta=theta, b=b, E_star=E_star)
    require_reach(a, b)
    return elementwise(_load_within, r, a, theta=theta, b=b, E_star=E_star)


def _profile(r: Array, theta: Array, b: Array) -> Array:
    return np.where(r < b, 0, np.tan(theta) * (r - b))


def _slope_beyond(t: Array, root: Array, theta: Array, b: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t) for t > b."""
    angle = np.arctan(root / b)
    return np.tan(theta) * angle + b * np.tan(theta) / root


def _depth_at(a: Array, root: Array, theta: Array, b: Array) -> Array:
    angle = np.arctan(root / b)
    return np.tan(theta) * a * angle


def _depth(a: Array, theta: Array, b: Array) -> Array:
    root = np.sqrt((a - b) * (a + b))
    return _depth_at(a, root, theta, b)


def _force_at(a: Array, root: Array, theta: Array, b: Array, E_star: Array) -> Array:
    angle = np.arctan(root / b)
    return E_star * np.tan(theta) * (a**2 * angle + b * root)


def _force(a: Array, theta: Array, b: Array, E_star: Array) -> Array:
    root = np.sqrt((a - b) * (a + b))
    return _force_at(a, root, theta, b, E_star)


def _pressure(r: Array, a: Array, theta: Array, b: Array, E_star: Array) -> Array:
    growth = pressure_integral_beyond(_slope_beyond, (theta, b), r, a, b)
    pressed = np.where((r == b) & (a > b), np.inf, E_star / np.pi * growth)
    inside = np.where(r < a, pressed, 0.0)
    return np.where(a >= b, inside, np.nan)


def _displacement(r: Array, a: Array, theta: Array, b: Array) -> Array:
    beyond = displacement_integral_beyond(_slope_beyond, (theta, b), r, a, b)
    outside = 2 / np.pi * beyond
    inside = _depth(a, theta, b) - _profile(r, theta, b)
    return np.where(a >= b, np.where(r > a, outside, inside), np.nan)


def _stiffness(a: Array, E_star: Array) -> Array:
    return 2 * E_star * a


def _mean_pressure(a: Array, theta: Array, b: Array, E_star: Array) -> Array:
    root = np.sqrt((a - b) * (a + b))
    angle = np.arctan(root / b)
    return E_star * np.tan(theta) / np.pi * (angle + b * root / a**2)


def _energy(a: Array, theta: Array, b: Array, E_star: Array) -> Array:
    sunk = _depth(a, theta, b)
    beyond = energy_integral_beyond(_depth_at, (theta, b), a, sunk, b)
    return np.where(a >= b, E_star * (b * sunk * sunk + beyond), np.nan)


def _load_within(r: Array, a: Array, theta: Array, b: Array, E_star: Array) -> Array:
    beyond = load_within_integral_beyond(_slope_beyond, (theta, b), r, a, b)
    found = np.where(r > b, _force(np.maximum(np.minimum(r, a), b), theta, b, E_star), 0.0) + 2 * E_star * beyond
    return np.where(a >= b, found, np.nan)


def _contact_from_depth(d: Array, theta: Array, b: Array) -> tuple[Array, Array]:
    """Contact radius a and its root sqrt(a**2 - b**2)."""

    def curve(t: Array) -> tuple[Array, Array]:
        a, root = b * np.sqrt(1.0 + t * t), b * t
        value = _depth_at(a, root, theta, b)
        return value, root * root / a * _slope_beyond(a, root, theta, b) / value

    rest = (1.587574, -0.008072401, -0.4352508, -3.570796, 8.66489, -8.150206, 3.403791, -0.4812051)
    start = between(np.log(d / curve(1.0)[0]), (0.9003, 1.0), (1.414, 1.0), -6.0, rest)
    t = inverse(curve, d, start, (1.0, 2.0), smooth=True)
    return b * np.sqrt(1.0 + t * t), b * t


def _radius_from_depth(d: Array, theta: Array, b: Array) -> Array:
    return _contact_from_depth(d, theta, b)[0]


def _contact_from_force(F: Array, theta: Array, b: Array, E_star: Array) -> tuple[Array, Array]:
    """Contact radius a and its root sqrt(a**2 - b**2)."""

    def curve(t: Array) -> tuple[Array, Array]:
        a, root = b * np.sqrt(1.0 + t * t), b * t
        value = _force_at(a, root, theta, b, E_star)
        return value, 2 * E_star * root * root * _slope_beyond(a, root, theta, b) / value

    rest = (0.9995205, 0.100541, -0.3986471, 4.536442, -19.76727, 34.2219, -25.89697, 7.204481)
    start = between(np.log(F / curve(1.0)[0]), (0.778, 1.0), (0.611, 2.0), -2.75, rest)
    t = inverse(curve, F, start, (1.0, 2.0), smooth=True)
    return b * np.sqrt(1.0 + t * t), b * t


def _radius_from_force(F: Array, theta: Array, b: Array, E_star: Array) -> Array:
    return _contact_from_force(F, theta, b, E_star)[0]


def _force_from_depth(d: Array, theta: Array, b: Array, E_star: Array) -> Array:
    a, root = _contact_from_depth(d, theta, b)
    change = np.where((a > 0.0) & (a < np.inf), 2 * E_star * a * (d - _depth_at(a, root, theta, b)), 0.0)
    return _force_at(a, root, theta, b, E_star) + change


def _depth_from_force(F: Array, theta: Array, b: Array, E_star: Array) -> Array:
    a, root = _contact_from_force(F, theta, b, E_star)
    change = np.where((a > 0.0) & (a < np.inf), (F - _force_at(a, root, theta, b, E_star)) / (2 * E_star * a), 0.0)
    return _depth_at(a, root, theta, b) + change
