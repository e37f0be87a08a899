"""Cone.

Rigid cone of inclination theta. Self-similar: the mean pressure does not depend on the load.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.functions import beside_cone
from .._runtime.interface import Array, Plain, Result, elementwise, require

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


def profile(r: ArrayLike, *, theta: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = r*tan(theta)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. Handbook: cone.f,
    the definition of the profile.

    References
    ----------
    Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import cone
    >>> value = cone.profile(0.3, theta=0.35)
    >>> round(value, 6)
    0.109509
    """
    value = plain.profile(r, theta)
    if value is not None:
        return value
    require(theta=theta)
    return elementwise(_profile, r, theta=theta)


def depth(a: ArrayLike, *, theta: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = pi*a*tan(theta)/2

    Parameters
    ----------
    a : array_like
        Contact radius [m].
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. The pressure is
    singular at the tip, as ln(r). Handbook: cone.d.

    References
    ----------
    chapter 11, equation (11.29); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import cone
    >>> value = cone.depth(1.0, theta=0.35)
    >>> round(value, 6)
    0.573385
    """
    value = plain.depth(a, theta)
    if value is not None:
        return value
    require(theta=theta)
    return elementwise(_depth, a, theta=theta)


def force(a: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force.

    F = pi*E_star*a**2*tan(theta)/2

    Parameters
    ----------
    a : array_like
        Contact radius [m].
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. The pressure is
    singular at the tip, as ln(r). Handbook: cone.F.

    References
    ----------
    chapter 11, equation (11.20); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import cone
    >>> value = cone.force(1.0, theta=0.35, E_star=1.0)
    >>> round(value, 6)
    0.573385
    """
    value = plain.force(a, theta, E_star)
    if value is not None:
        return value
    require(theta=theta, E_star=E_star)
    return elementwise(_force, a, theta=theta, E_star=E_star)


def pressure(r: ArrayLike, a: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = E_star*tan(theta)*acosh(a/r)/2

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. The pressure is
    singular at the tip, as ln(r). Handbook: cone.p.

    References
    ----------
    chapter 11, equation (11.23); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import cone
    >>> value = cone.pressure(0.3, 1.0, theta=0.35, E_star=1.0)
    >>> round(value, 6)
    0.341999
    """
    value = plain.pressure(r, a, theta, E_star)
    if value is not None:
        return value
    require(theta=theta, E_star=E_star)
    return elementwise(_pressure, r, a, theta=theta, E_star=E_star)


def displacement(r: ArrayLike, a: ArrayLike, *, theta: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = (a*asin(a/r) - r + sqrt(-a**2 + r**2))*tan(theta)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. Handbook: cone.w.

    References
    ----------
    chapter 11, equation (11.26); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import cone
    >>> value = cone.displacement(2.0, 1.0, theta=0.35)
    >>> round(value, 6)
    0.093319
    """
    value = plain.displacement(r, a, theta)
    if value is not None:
        return value
    require(theta=theta)
    return elementwise(_displacement, r, a, theta=theta)


def stiffness(a: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*E_star*a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. Handbook: cone.k.

    References
    ----------
    chapter 11, equation (11.18); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import cone
    >>> value = cone.stiffness(1.0, theta=0.35, E_star=1.0)
    >>> round(value, 6)
    2.0
    """
    value = plain.stiffness(a, E_star, theta)
    if value is not None:
        return value
    require(theta=theta, E_star=E_star)
    return elementwise(_stiffness, a, E_star=E_star, unused=(theta,))


def mean_pressure(a: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = E_star*tan(theta)/2

    Parameters
    ----------
    a : array_like
        Contact radius [m].
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. Handbook:
    cone.pm.

    References
    ----------
    Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import cone
    >>> value = cone.mean_pressure(1.0, theta=0.35, E_star=1.0)
    >>> round(value, 6)
    0.182514
    """
    value = plain.mean_pressure(a, theta, E_star)
    if value is not None:
        return value
    require(theta=theta, E_star=E_star)
    return elementwise(_mean_pressure, a, theta=theta, E_star=E_star)


def radius_from_depth(d: ArrayLike, *, theta: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a = 2*d/(pi*tan(theta))

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. Handbook:
    cone.ad.

    References
    ----------
    chapter 11, equation (11.16); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import cone
    >>> value = cone.radius_from_depth(0.5734, theta=0.35)
    >>> round(value, 6)
    1.000025
    """
    value = plain.radius_from_depth(d, theta)
    if value is not None:
        return value
    require(theta=theta)
    return elementwise(_radius_from_depth, d, theta=theta)


def radius_from_force(F: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a = sqrt(2)*sqrt(F)*sqrt(1/tan(theta))/(sqrt(pi)*sqrt(E_star))

    Parameters
    ----------
    F : array_like
        Normal force [N].
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. Handbook:
    cone.aF.

    References
    ----------
    chapter 11, equation (11.20); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import cone
    >>> value = cone.radius_from_force(0.5734, theta=0.35, E_star=1.0)
    >>> round(value, 6)
    1.000013
    """
    value = plain.radius_from_force(F, theta, E_star)
    if value is not None:
        return value
    require(theta=theta, E_star=E_star)
    return elementwise(_radius_from_force, F, theta=theta, E_star=E_star)


def force_from_depth(d: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = 2*E_star*d**2/(pi*tan(theta))

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. Handbook:
    cone.Fd.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import cone
    >>> value = cone.force_from_depth(0.5734, theta=0.35, E_star=1.0)
    >>> round(value, 6)
    0.573415
    """
    value = plain.force_from_depth(d, theta, E_star)
    if value is not None:
        return value
    require(theta=theta, E_star=E_star)
    return elementwise(_force_from_depth, d, theta=theta, E_star=E_star)


def depth_from_force(F: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = sqrt(2)*sqrt(pi)*sqrt(F)*sqrt(tan(theta))/(2*sqrt(E_star))

    Parameters
    ----------
    F : array_like
        Normal force [N].
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. Handbook:
    cone.dF.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import cone
    >>> value = cone.depth_from_force(0.5734, theta=0.35, E_star=1.0)
    >>> round(value, 6)
    0.573393
    """
    value = plain.depth_from_force(F, theta, E_star)
    if value is not None:
        return value
    require(theta=theta, E_star=E_star)
    return elementwise(_depth_from_force, F, theta=theta, E_star=E_star)


def energy(a: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike) -> Result:
    """Elastic energy, the work of pressing the indenter in.

    U = pi**2*E_star*a**3*tan(theta)**2/12

    Parameters
    ----------
    a : array_like
        Contact radius [m].
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. Handbook: cone.U.

    References
    ----------
    Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import cone
    >>> value = cone.energy(1.0, theta=0.35, E_star=1.0)
    >>> round(value, 6)
    0.10959
    """
    value = plain.energy(a, theta, E_star)
    if value is not None:
        return value
    require(theta=theta, E_star=E_star)
    return elementwise(_energy, a, theta=theta, E_star=E_star)


def load_within(r: ArrayLike, a: ArrayLike, *, theta: ArrayLike, E_star: ArrayLike) -> Result:
    """Part of the normal force that is carried within the radius r; all of it beyond the contact.

    F_r = pi*E_star*(a**2 - a*sqrt(a**2 - r**2) + r**2*acosh(a/r))*tan(theta)/2

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. Handbook:
    cone.Fr.

    References
    ----------
    Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.normal import cone
    >>> value = cone.load_within(0.3, 1.0, theta=0.35, E_star=1.0)
    >>> round(value, 6)
    0.123108
    """
    value = plain.load_within(r, a, theta, E_star)
    if value is not None:
        return value
    require(theta=theta, E_star=E_star)
    return elementwise(_load_within, r, a, theta=theta, E_star=E_star)


def _profile(r: Array, theta: Array) -> Array:
    return np.tan(theta) * r


def _slope(t: Array, theta: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t)."""
    return np.pi * np.tan(theta) / 2


def _depth(a: Array, theta: Array) -> Array:
    return np.pi * np.tan(theta) * a / 2


def _force(a: Array, theta: Array, E_star: Array) -> Array:
    return np.pi * E_star * np.tan(theta) * a**2 / 2


def _pressure(r: Array, a: Array, theta: Array, E_star: Array) -> Array:
    root = np.sqrt((a - r) * (a + r))
    return np.where(r < a, E_star * np.tan(theta) * np.log1p((a - r + root) / r) / 2, 0.0)


def _displacement(r: Array, a: Array, theta: Array) -> Array:
    outside = np.tan(theta) * a * beside_cone(r, a)
    inside = _depth(a, theta) - _profile(r, theta)
    return np.where(r > a, outside, inside)


def _stiffness(a: Array, E_star: Array) -> Array:
    return 2 * E_star * a


def _mean_pressure(a: Array, theta: Array, E_star: Array) -> Array:
    return E_star * np.tan(theta) / 2


def _energy(a: Array, theta: Array, E_star: Array) -> Array:
    return np.pi**2 * E_star * np.tan(theta) ** 2 / 12 * a**3


def _load_within(r: Array, a: Array, theta: Array, E_star: Array) -> Array:
    root = np.sqrt((a - r) * (a + r))
    within = np.pi * E_star * np.tan(theta) * r**2 * (a / (root + a) + np.log1p((a - r + root) / r)) / 2
    return np.where(r < a, np.where(r > 0.0, within, 0.0), _force(a, theta, E_star))


def _radius_from_depth(d: Array, theta: Array) -> Array:
    return 2 * d / (np.pi * np.tan(theta))


def _radius_from_force(F: Array, theta: Array, E_star: Array) -> Array:
    return np.sqrt(2 * F / (np.pi * E_star * np.tan(theta)))


def _force_from_depth(d: Array, theta: Array, E_star: Array) -> Array:
    return 2 * E_star / (np.pi * np.tan(theta)) * d**2


def _depth_from_force(F: Array, theta: Array, E_star: Array) -> Array:
    return np.sqrt(np.pi * np.tan(theta) / (2 * E_star) * F)
