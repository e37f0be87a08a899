"""Cone with a spherical tip.

Sphere of radius R up to b = R sin(theta), then its tangent cone: the exact sphero-conical tip.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.functions import sine_root
from .._runtime.interface import Array, Plain, Result, elementwise, require
from .._runtime.rules import (
    displacement_integral_beyond,
    displacement_integral_tanh,
    force_integral_beyond,
    pressure_integral_beyond,
)
from .._runtime.shapes.across import inverse_across
from .._runtime.shapes.arcs import arc_strips
from .._runtime.shapes.energy import energy_integral, energy_integral_beyond
from .._runtime.shapes.load_within import load_within_integral_beyond, load_within_integral_tanh
from .._runtime.special import tanh_gap

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


def profile(r: ArrayLike, *, R: ArrayLike, theta: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = R - sqrt(R**2 - r**2)   for 0 < r < b
    f = R + b*(-b + r)/sqrt(R**2 - b**2) - sqrt(R**2 - b**2)   for b < r
    with b = R*sin(theta)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.

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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: sphere_tipped_cone.f, the
    definition of the profile.

    Examples
    --------
    >>> from axicontact.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.profile(0.3, R=1.2, theta=0.45)
    >>> round(value, 6)
    0.038105
    """
    value = plain.profile(r, R, theta)
    if value is not None:
        return value
    require(R=R, theta=theta)
    return elementwise(_profile, r, R=R, theta=theta)


def depth(a: ArrayLike, *, R: ArrayLike, theta: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = a*atanh(a/R)   for a < b
    d = a*(b*acos(b/a)/(sqrt(R - b)*sqrt(R + b)) + log((R + a)/(sqrt(R**2 - b**2) + sqrt(a**2 - b**2))))   for
    b < a
    with b = R*sin(theta)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.

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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: sphere_tipped_cone.d.

    References
    ----------
    chapter 11, equation (11.29).

    Examples
    --------
    >>> from axicontact.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.depth(1.0, R=1.2, theta=0.45)
    >>> round(value, 6)
    0.622635
    """
    value = plain.depth(a, R, theta)
    if value is not None:
        return value
    require(R=R, theta=theta)
    return elementwise(_depth, a, R=R, theta=theta)


def force(a: ArrayLike, *, R: ArrayLike, theta: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force.

    F = E_star*(-R*a + (R**2 + a**2)*atanh(a/R))   for a < b
    F = E_star*(-R*a + a**2*b*acos(b/a)/(sqrt(R - b)*sqrt(R + b)) + b**2*sqrt(a**2 - b**2)/(sqrt(R - b)*sqrt(R
    + b)) + (R**2 + a**2)*log((R + a)/(sqrt(R**2 - b**2) + sqrt(a**2 - b**2))) + sqrt(R**2 - b**2)*sqrt(a**2 -
    b**2))   for b < a
    with b = R*sin(theta)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact by a Gauss-Legendre rule. Handbook: sphere_tipped_cone.F.

    References
    ----------
    chapter 11, equation (11.20).

    Examples
    --------
    >>> from axicontact.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.force(1.0, R=1.2, theta=0.45, E_star=1.0)
    >>> round(value, 6)
    0.7453
    """
    value = plain.force(a, R, theta, E_star)
    if value is not None:
        return value
    require(R=R, theta=theta, E_star=E_star)
    return elementwise(_force, a, R=R, theta=theta, E_star=E_star)


def pressure(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, theta: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = E_star*Integral(Derivative(g(t), t)/sqrt(-r**2 + t**2), (t, r, a))/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact by a Gauss-Legendre rule. Handbook: sphere_tipped_cone.p.

    References
    ----------
    chapter 11, equation (11.23).

    Examples
    --------
    >>> from axicontact.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.pressure(0.3, 1.0, R=1.2, theta=0.45, E_star=1.0)
    >>> round(value, 6)
    0.428504
    """
    value = plain.pressure(r, a, R, theta, E_star)
    if value is not None:
        return value
    require(R=R, theta=theta, E_star=E_star)
    return elementwise(_pressure, r, a, R=R, theta=theta, E_star=E_star)


def displacement(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, theta: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*Integral(asin(t/r)*Derivative(g(t), t), (t, 0, a))/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.

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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact by a Gauss-Legendre rule. Handbook: sphere_tipped_cone.w.

    References
    ----------
    chapter 11, equation (11.26).

    Examples
    --------
    >>> from axicontact.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.displacement(2.0, 1.0, R=1.2, theta=0.45)
    >>> round(value, 6)
    0.121421
    """
    value = plain.displacement(r, a, R, theta)
    if value is not None:
        return value
    require(R=R, theta=theta)
    return elementwise(_displacement, r, a, R=R, theta=theta)


def stiffness(a: ArrayLike, *, R: ArrayLike, theta: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*E_star*a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: sphere_tipped_cone.k.

    References
    ----------
    chapter 11, equation (11.18).

    Examples
    --------
    >>> from axicontact.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.stiffness(1.0, R=1.2, theta=0.45, E_star=1.0)
    >>> round(value, 6)
    2.0
    """
    value = plain.stiffness(a, E_star, R, theta)
    if value is not None:
        return value
    require(R=R, theta=theta, E_star=E_star)
    return elementwise(_stiffness, a, E_star=E_star, unused=(R, theta))


def mean_pressure(a: ArrayLike, *, R: ArrayLike, theta: ArrayLike, E_star: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = E_star*(-R + (R**2 + a**2)*atanh(a/R)/a)/(pi*a)   for a < b
    p_mean = E_star*(b*acos(b/a)/(sqrt(R - b)*sqrt(R + b)) + b**2*sqrt(a**2 - b**2)/(a**2*sqrt(R - b)*sqrt(R +
    b)) + (R**2 + a**2)*log((R + a)/(sqrt(R**2 - b**2) + sqrt(a**2 - b**2)))/a**2 - (R*a - sqrt(R**2 -
    b**2)*sqrt(a**2 - b**2))/a**2)/pi   for b < a
    with b = R*sin(theta)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact by a Gauss-Legendre rule. Handbook: sphere_tipped_cone.pm.

    Examples
    --------
    >>> from axicontact.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.mean_pressure(1.0, R=1.2, theta=0.45, E_star=1.0)
    >>> round(value, 6)
    0.237236
    """
    value = plain.mean_pressure(a, R, theta, E_star)
    if value is not None:
        return value
    require(R=R, theta=theta, E_star=E_star)
    return elementwise(_mean_pressure, a, R=R, theta=theta, E_star=E_star)


def radius_from_depth(d: ArrayLike, *, R: ArrayLike, theta: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a from a*atanh(a/R) = d   for a < b
    a from a*(b*acos(b/a)/(sqrt(R - b)*sqrt(R + b)) + log((R + a)/(sqrt(R**2 - b**2) + sqrt(a**2 - b**2)))) =
    d   for b < a
    with b = R*sin(theta)

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.

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
    iteration. Handbook: sphere_tipped_cone.ad.

    References
    ----------
    chapter 11, equation (11.16).

    Examples
    --------
    >>> from axicontact.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.radius_from_depth(0.6226, R=1.2, theta=0.45)
    >>> round(value, 6)
    0.999954
    """
    value = plain.radius_from_depth(d, R, theta)
    if value is not None:
        return value
    require(R=R, theta=theta)
    return elementwise(_radius_from_depth, d, R=R, theta=theta)


def radius_from_force(F: ArrayLike, *, R: ArrayLike, theta: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a from E_star*(-R*a + (R**2 + a**2)*atanh(a/R)) = F   for a < b
    a from E_star*(-R*a + a**2*b*acos(b/a)/(sqrt(R - b)*sqrt(R + b)) + b**2*sqrt(a**2 - b**2)/(sqrt(R -
    b)*sqrt(R + b)) + (R**2 + a**2)*log((R + a)/(sqrt(R**2 - b**2) + sqrt(a**2 - b**2))) + sqrt(R**2 -
    b**2)*sqrt(a**2 - b**2)) = F   for b < a
    with b = R*sin(theta)

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact by a Gauss-Legendre rule. Evaluated by a safeguarded Newton iteration. Handbook:
    sphere_tipped_cone.aF.

    References
    ----------
    chapter 11, equation (11.20).

    Examples
    --------
    >>> from axicontact.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.radius_from_force(0.7453, R=1.2, theta=0.45, E_star=1.0)
    >>> round(value, 6)
    1.0
    """
    value = plain.radius_from_force(F, R, theta, E_star)
    if value is not None:
        return value
    require(R=R, theta=theta, E_star=E_star)
    return elementwise(_radius_from_force, F, R=R, theta=theta, E_star=E_star)


def force_from_depth(d: ArrayLike, *, R: ArrayLike, theta: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = F(a(d)), through the contact radius.

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact by a Gauss-Legendre rule. Evaluated by a safeguarded Newton iteration. Handbook:
    sphere_tipped_cone.Fd.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20).

    Examples
    --------
    >>> from axicontact.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.force_from_depth(0.6226, R=1.2, theta=0.45, E_star=1.0)
    >>> round(value, 6)
    0.74523
    """
    value = plain.force_from_depth(d, R, theta, E_star)
    if value is not None:
        return value
    require(R=R, theta=theta, E_star=E_star)
    return elementwise(_force_from_depth, d, R=R, theta=theta, E_star=E_star)


def depth_from_force(F: ArrayLike, *, R: ArrayLike, theta: ArrayLike, E_star: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = d(a(F)), through the contact radius.

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact by a Gauss-Legendre rule. Evaluated by a safeguarded Newton iteration. Handbook:
    sphere_tipped_cone.dF.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20).

    Examples
    --------
    >>> from axicontact.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.depth_from_force(0.7453, R=1.2, theta=0.45, E_star=1.0)
    >>> round(value, 6)
    0.622635
    """
    value = plain.depth_from_force(F, R, theta, E_star)
    if value is not None:
        return value
    require(R=R, theta=theta, E_star=E_star)
    return elementwise(_depth_from_force, F, R=R, theta=theta, E_star=E_star)


def energy(a: ArrayLike, *, R: ArrayLike, theta: ArrayLike, E_star: ArrayLike) -> Result:
    """Elastic energy, the work of pressing the indenter in.

    U = E_star*Integral((g(a) - g(t))**2, (t, 0, a))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact by a Gauss-Legendre rule. Handbook: sphere_tipped_cone.U.

    Examples
    --------
    >>> from axicontact.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.energy(1.0, R=1.2, theta=0.45, E_star=1.0)
    >>> round(value, 6)
    0.179178
    """
    value = plain.energy(a, R, theta, E_star)
    if value is not None:
        return value
    require(R=R, theta=theta, E_star=E_star)
    return elementwise(_energy, a, R=R, theta=theta, E_star=E_star)


def load_within(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, theta: ArrayLike, E_star: ArrayLike) -> Result:
    """Part of the normal force that is carried within the radius r; all of it beyond the contact.

    F_r = 2*pi*Integral(t*p(t), (t, 0, r))

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact by a Gauss-Legendre rule. Handbook: sphere_tipped_cone.Fr.

    Examples
    --------
    >>> from axicontact.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.load_within(0.3, 1.0, R=1.2, theta=0.45, E_star=1.0)
    >>> round(value, 6)
    0.125102
    """
    value = plain.load_within(r, a, R, theta, E_star)
    if value is not None:
        return value
    require(R=R, theta=theta, E_star=E_star)
    return elementwise(_load_within, r, a, R=R, theta=theta, E_star=E_star)


def _profile(r: Array, R: Array, theta: Array) -> Array:
    b = R * np.sin(theta)
    root_Rr = np.sqrt((R - r) * (r + R))
    root_Rb = R * np.cos(theta)
    return np.where(r < b, r**2 / (root_Rr + R), b * ((r - b) / root_Rb + b / (root_Rb + R)))


def _slope(t: Array, root: Array, R: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t)."""
    angle = np.arcsinh(t / root)
    return angle + R * t / root**2


def _slope_beyond(t: Array, root: Array, R: Array, theta: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t) for t > b."""
    b = R * np.sin(theta)
    root_Rb = R * np.cos(theta)
    angle = np.arctan2(root, b)
    logarithm = np.log1p((b**2 / (root + t) + b**2 / (root_Rb + R)) / (root + root_Rb))
    return logarithm + b * angle / root_Rb + b**2 * R / (t * root_Rb**2 + R * root * root_Rb)


def _depth_at(a: Array, root: Array, R: Array, theta: Array) -> Array:
    b = R * np.sin(theta)
    root_Rb = R * np.cos(theta)
    angle = np.arctan2(root, b)
    logarithm = np.log1p((b**2 / (root + a) + b**2 / (root_Rb + R)) / (root + root_Rb))
    beyond = a * (logarithm + b * angle / root_Rb)
    angle = np.log1p(2 * a / (R - a)) / 2
    tip = a * angle
    return np.where(a < b, tip, beyond)


def _depth(a: Array, R: Array, theta: Array) -> Array:
    return _depth_at(a, sine_root(a, R, theta), R, theta)


def _force_at(a: Array, reach: Array, R: Array, theta: Array, E_star: Array) -> Array:
    b = R * np.sin(theta)
    inner = np.minimum(a, b)
    root = np.where(a < b, np.sqrt((R - inner) * (inner + R)), R * np.cos(theta))
    angle = np.arcsinh(inner / root)
    tip = E_star * (inner**2 * angle + R**2 * tanh_gap(angle, np.tanh(angle)))
    beyond = 2 * E_star * force_integral_beyond(_slope_beyond, (R, theta), reach, b, width=1.0 - 2.0 * theta / np.pi)
    return tip + beyond


def _force(a: Array, R: Array, theta: Array, E_star: Array) -> Array:
    return _force_at(a, sine_root(a, R, theta), R, theta, E_star)


def _pressure(r: Array, a: Array, R: Array, theta: Array, E_star: Array) -> Array:
    b = R * np.sin(theta)
    inner = np.minimum(a, b)
    root_Rr = np.sqrt((R - r) * (r + R))
    root = np.where(a < b, np.sqrt((R - inner) * (inner + R)), R * np.cos(theta))
    root_ar = np.sqrt((inner - r) * (inner + r))
    within = E_star / np.pi * (R * np.arcsinh(root_ar / root) / root_Rr + arc_strips(r, inner, R))
    tip = np.where(r < inner, within, 0.0)
    growth = pressure_integral_beyond(_slope_beyond, (R, theta), r, a, b, width=1.0 - 2.0 * theta / np.pi)
    return np.where(r < a, tip + E_star / np.pi * growth, 0.0)


def _displacement(r: Array, a: Array, R: Array, theta: Array) -> Array:
    b = R * np.sin(theta)
    inner = np.minimum(a, b)
    tip = displacement_integral_tanh(_slope, (R,), r, inner, R)
    beyond = displacement_integral_beyond(_slope_beyond, (R, theta), r, a, b, width=1.0 - 2.0 * theta / np.pi)
    outside = 2 / np.pi * (tip + beyond)
    inside = _depth(a, R, theta) - _profile(r, R, theta)
    return np.where(r > a, outside, inside)


def _stiffness(a: Array, E_star: Array) -> Array:
    return 2 * E_star * a


def _mean_pressure(a: Array, R: Array, theta: Array, E_star: Array) -> Array:
    return np.where(a > 0.0, _force(a, R, theta, E_star) / (np.pi * a**2), 0.0)


def _energy(a: Array, R: Array, theta: Array, E_star: Array) -> Array:
    b = R * np.sin(theta)
    sunk = _depth(a, R, theta)
    inner = np.minimum(a, b)
    tip = energy_integral(_depth, (R, theta), inner, sunk, R, width=1.0 - 2.0 * theta / np.pi)
    beyond = energy_integral_beyond(_depth_at, (R, theta), a, sunk, b, width=1.0 - 2.0 * theta / np.pi)
    return E_star * (tip + beyond)


def _load_within(r: Array, a: Array, R: Array, theta: Array, E_star: Array) -> Array:
    b = R * np.sin(theta)
    inner = np.minimum(a, b)
    tip = load_within_integral_tanh(_slope, (R,), np.minimum(r, inner), inner, R)
    beyond = load_within_integral_beyond(_slope_beyond, (R, theta), r, a, b, width=1.0 - 2.0 * theta / np.pi)
    return _force(np.minimum(r, a), R, theta, E_star) + 2 * E_star * (tip + beyond)


def _slope_at(a: Array, root: Array, R: Array, theta: Array) -> Array:
    """Rate g'(a) of the indentation depth on both sides of the break."""
    b = R * np.sin(theta)
    root_tip = np.sqrt((R - a) * (R + a))
    return np.where(a < b, _slope(a, root_tip, R), _slope_beyond(a, root, R, theta))


def _radius_from_depth(d: Array, R: Array, theta: Array) -> Array:
    b = R * np.sin(theta)

    def curve(a: Array, root: Array) -> tuple[Array, Array]:
        rate = a * _slope_at(a, root, R, theta)
        return _depth_at(a, root, R, theta), rate

    return inverse_across(curve, d, b, 2.0, R, powers=(2.0, 1.0))


def _radius_from_force(F: Array, R: Array, theta: Array, E_star: Array) -> Array:
    b = R * np.sin(theta)

    def curve(a: Array, root: Array) -> tuple[Array, Array]:
        rate = 2 * E_star * a**2 * _slope_at(a, root, R, theta)
        return _force_at(a, root, R, theta, E_star), rate

    return inverse_across(curve, F, b, 3.0, R, powers=(2.0, 2.0))


def _force_from_depth(d: Array, R: Array, theta: Array, E_star: Array) -> Array:
    a = _radius_from_depth(d, R, theta)
    change = np.where((a > 0.0) & (a < np.inf), 2 * E_star * a * (d - _depth(a, R, theta)), 0.0)
    return _force(a, R, theta, E_star) + change


def _depth_from_force(F: Array, R: Array, theta: Array, E_star: Array) -> Array:
    a = _radius_from_force(F, R, theta, E_star)
    change = np.where((a > 0.0) & (a < np.inf), (F - _force(a, R, theta, E_star)) / (2 * E_star * a), 0.0)
    return _depth(a, R, theta) + change
