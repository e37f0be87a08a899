"""Wavy paraboloid on a power-law graded half-space.

A paraboloid with concentric waves of amplitude h, 2h from valley to peak, too shallow to leave gaps.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.growth import power_depth, power_force, power_rate
from ..._runtime.graded.punch import punch_depth, punch_force, punch_stiffness
from ..._runtime.graded.waves import steepest_waves, waves_depth, waves_force, waves_rate
from ..._runtime.interface import Array, Result, elementwise, require, require_order

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "depth",
    "depth_from_force",
    "displacement",
    "force",
    "force_from_depth",
    "mean_pressure",
    "pressure",
    "profile",
    "radius_from_depth",
    "radius_from_force",
    "stiffness",
]


def __dir__() -> list[str]:
    return __all__


def profile(r: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = h*(1 - cos(2*pi*r/wavelength)) + r**2/(2*R)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Amplitude of the waves, half of their height from valley to peak [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.

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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN field values give NaN.

    References
    ----------
    Guduru 2007.

    Examples
    --------
    >>> from axicontact.graded.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.profile(0.3, R=1.6, h=0.01, wavelength=0.5)
    >>> round(value, 6)
    0.046215
    """
    from ...normal import wavy_paraboloid as normal

    return normal.profile(r, R=R, h=h, wavelength=wavelength)


def depth(a: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = pi**(3/2 - k/2)*a**(1 - k/2)*h*wavelength**(k/2 - 1)*StruveH(k/2, 2*pi*a/wavelength)*gamma((k + 1)/2)
    + a**2/(R*(k + 1))
    with StruveH: Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN field values give NaN. Handbook:
    wavy_paraboloid.fgm.d.

    References
    ----------
    chapter 11, equation (11.61); Guduru 2007.

    Examples
    --------
    >>> from axicontact.graded.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.depth(1.0, R=1.6, h=0.01, wavelength=0.5, k=0.25)
    >>> round(value, 6)
    0.486056
    """
    _check(R=R, h=h, wavelength=wavelength, k=k)
    return elementwise(_depth, a, R=R, h=h, wavelength=wavelength, k=k)


def force(a: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force.

    F = H*(-pi**(1/2 - k/2)*a**(k/2 + 1)*h*wavelength**(k/2)*StruveH(k/2 + 1, 2*pi*a/wavelength)*gamma((k +
    1)/2) + 2*pi**(3/2 - k/2)*a**(k/2 + 2)*h*wavelength**(k/2 - 1)*StruveH(k/2, 2*pi*a/wavelength)*gamma((k +
    1)/2)/(k + 1) + 4*a**(k + 3)/(R*(k + 1)**2*(k + 3)))
    with StruveH: Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN field values give NaN. Handbook:
    wavy_paraboloid.fgm.F.

    References
    ----------
    chapter 11, equation (11.51); Guduru 2007.

    Examples
    --------
    >>> from axicontact.graded.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.force(1.0, R=1.6, h=0.01, wavelength=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.456553
    """
    _check(R=R, h=h, wavelength=wavelength, H=H, k=k)
    return elementwise(_force, a, R=R, h=h, wavelength=wavelength, H=H, k=k)


def pressure(
    r: ArrayLike, a: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, H: ArrayLike, k: ArrayLike
) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = H*Integral((-r**2 + t**2)**(k/2 - 1/2)*Derivative(g(t), t), (t, r, a))/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN field values give NaN. Evaluated
    as an integral over the growing contact, by a rule that carries the weight of the grading. Handbook:
    wavy_paraboloid.fgm.p.

    References
    ----------
    chapter 11, equation (11.53); Guduru 2007.

    Examples
    --------
    >>> from axicontact.graded.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.pressure(0.3, 1.0, R=1.6, h=0.01, wavelength=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.209896
    """
    _check(R=R, h=h, wavelength=wavelength, H=H, k=k)
    return elementwise(_pressure, r, a, R=R, h=h, wavelength=wavelength, H=H, k=k)


def displacement(
    r: ArrayLike, a: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, k: ArrayLike
) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*cos(pi*k/2)*Integral((pi**(3/2 - k/2)*a**(1 - k/2)*h*wavelength**(k/2 - 1)*StruveH(k/2,
    2*pi*a/wavelength)*gamma((k + 1)/2) - pi**(3/2 - k/2)*h*wavelength**(k/2 - 1)*(r*sin(psi))**(1 -
    k/2)*StruveH(k/2, 2*pi*r*sin(psi)/wavelength)*gamma((k + 1)/2) + a**2/(R*(k + 1)) - r**2*sin(psi)**2/(R*(k
    + 1)))*tan(psi)**k, (psi, 0, asin(a/r)))/pi
    with StruveH: Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN field values give NaN. Evaluated
    as an integral over the displacement inside the contact. Handbook: wavy_paraboloid.fgm.w.

    References
    ----------
    chapter 11, equation (11.56); Guduru 2007.

    Examples
    --------
    >>> from axicontact.graded.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.displacement(2.0, 1.0, R=1.6, h=0.01, wavelength=0.5, k=0.25)
    >>> round(value, 6)
    0.058706
    """
    _check(R=R, h=h, wavelength=wavelength, k=k)
    return elementwise(_displacement, r, a, R=R, h=h, wavelength=wavelength, k=k)


def stiffness(a: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*H*a**(k + 1)/(k + 1)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN field values give NaN. Handbook:
    wavy_paraboloid.fgm.k.

    References
    ----------
    chapter 11, equation (11.46); Guduru 2007.

    Examples
    --------
    >>> from axicontact.graded.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.stiffness(1.0, R=1.6, h=0.01, wavelength=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    1.6
    """
    _check(R=R, h=h, wavelength=wavelength, H=H, k=k)
    return elementwise(_stiffness, a, H=H, k=k, unused=(R, h, wavelength))


def mean_pressure(
    a: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, H: ArrayLike, k: ArrayLike
) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = H*(2*pi**(1/2 - k/2)*a**(k/2)*h*wavelength**(k/2 - 1)*StruveH(k/2, 2*pi*a/wavelength)*gamma((k +
    1)/2)/(k + 1) - pi**(-k/2 - 1/2)*a**(k/2 - 1)*h*wavelength**(k/2)*StruveH(k/2 + 1,
    2*pi*a/wavelength)*gamma((k + 1)/2) + 4*a**(k + 1)/(pi*R*(k + 1)**2*(k + 3)))
    with StruveH: Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN field values give NaN. Handbook:
    wavy_paraboloid.fgm.pm.

    References
    ----------
    Guduru 2007.

    Examples
    --------
    >>> from axicontact.graded.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.mean_pressure(1.0, R=1.6, h=0.01, wavelength=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.145325
    """
    _check(R=R, h=h, wavelength=wavelength, H=H, k=k)
    return elementwise(_mean_pressure, a, R=R, h=h, wavelength=wavelength, H=H, k=k)


def radius_from_depth(d: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a from pi**(3/2 - k/2)*a**(1 - k/2)*h*wavelength**(k/2 - 1)*StruveH(k/2, 2*pi*a/wavelength)*gamma((k +
    1)/2) + a**2/(R*(k + 1)) = d
    with StruveH: Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN field values give NaN. Evaluated
    by a safeguarded Newton iteration. Handbook: wavy_paraboloid.fgm.ad.

    References
    ----------
    chapter 11, equation (11.48); Guduru 2007.

    Examples
    --------
    >>> from axicontact.graded.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.radius_from_depth(0.4861, R=1.6, h=0.01, wavelength=0.5, k=0.25)
    >>> round(value, 6)
    1.000037
    """
    _check(R=R, h=h, wavelength=wavelength, k=k)
    return elementwise(_radius_from_depth, d, R=R, h=h, wavelength=wavelength, k=k)


def radius_from_force(
    F: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, H: ArrayLike, k: ArrayLike
) -> Result:
    """Contact radius under the normal force F.

    a from H*(-pi**(1/2 - k/2)*a**(k/2 + 1)*h*wavelength**(k/2)*StruveH(k/2 + 1, 2*pi*a/wavelength)*gamma((k +
    1)/2) + 2*pi**(3/2 - k/2)*a**(k/2 + 2)*h*wavelength**(k/2 - 1)*StruveH(k/2, 2*pi*a/wavelength)*gamma((k +
    1)/2)/(k + 1) + 4*a**(k + 3)/(R*(k + 1)**2*(k + 3))) = F
    with StruveH: Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN field values give NaN. Evaluated
    by a safeguarded Newton iteration. Handbook: wavy_paraboloid.fgm.aF.

    References
    ----------
    chapter 11, equation (11.51); Guduru 2007.

    Examples
    --------
    >>> from axicontact.graded.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.radius_from_force(0.4566, R=1.6, h=0.01, wavelength=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    1.000025
    """
    _check(R=R, h=h, wavelength=wavelength, H=H, k=k)
    return elementwise(_radius_from_force, F, R=R, h=h, wavelength=wavelength, H=H, k=k)


def force_from_depth(
    d: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, H: ArrayLike, k: ArrayLike
) -> Result:
    """Normal force at indentation depth d.

    F = F(a(d)), through the contact radius.

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN field values give NaN. Evaluated
    by a safeguarded Newton iteration. Handbook: wavy_paraboloid.fgm.Fd.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Guduru 2007.

    Examples
    --------
    >>> from axicontact.graded.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.force_from_depth(0.4861, R=1.6, h=0.01, wavelength=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.456624
    """
    _check(R=R, h=h, wavelength=wavelength, H=H, k=k)
    return elementwise(_force_from_depth, d, R=R, h=h, wavelength=wavelength, H=H, k=k)


def depth_from_force(
    F: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, H: ArrayLike, k: ArrayLike
) -> Result:
    """Indentation depth under the normal force F.

    d = d(a(F)), through the contact radius.

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN field values give NaN. Evaluated
    by a safeguarded Newton iteration. Handbook: wavy_paraboloid.fgm.dF.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Guduru 2007.

    Examples
    --------
    >>> from axicontact.graded.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.depth_from_force(0.4566, R=1.6, h=0.01, wavelength=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.486085
    """
    _check(R=R, h=h, wavelength=wavelength, H=H, k=k)
    return elementwise(_depth_from_force, F, R=R, h=h, wavelength=wavelength, H=H, k=k)


def _depth(a: Array, R: Array, h: Array, wavelength: Array, k: Array) -> Array:
    return power_depth(a, 2.0, k) / (2 * R) + h * waves_depth(a, 2 * np.pi / wavelength, k)


def _rate(a: Array, R: Array, h: Array, wavelength: Array, k: Array) -> Array:
    """Rate g'(a) of the depth."""
    return power_rate(a, 2.0, k) / (2 * R) + h * waves_rate(a, 2 * np.pi / wavelength, k)


def _force(a: Array, R: Array, h: Array, wavelength: Array, H: Array, k: Array) -> Array:
    growth = power_force(a, 2.0, k) / (2 * R) + h * waves_force(a, 2 * np.pi / wavelength, k)
    return 2.0 * H / (1.0 + k) * growth


def _force_rate(a: Array, R: Array, h: Array, wavelength: Array, H: Array, k: Array) -> Array:
    """Derivative of the force."""
    return punch_stiffness(a, H, k) * _rate(a, R, h, wavelength, k)


def _stiffness(a: Array, H: Array, k: Array) -> Array:
    return punch_stiffness(a, H, k)


def _mean_pressure(a: Array, R: Array, h: Array, wavelength: Array, H: Array, k: Array) -> Array:
    return np.where(a > 0.0, _force(a, R, h, wavelength, H, k) / (np.pi * a * a), 0.0)


def _pressure(r: Array, a: Array, R: Array, h: Array, wavelength: Array, H: Array, k: Array) -> Array:
    from ..._runtime.graded.pressure import power_pressure, waves_pressure

    inside = np.minimum(r, a)
    growth = power_pressure(inside, a, 2.0, k) / (2 * R) + h * waves_pressure(inside, a, 2 * np.pi / wavelength, k)
    return np.where(r < a, H / np.pi * growth, 0.0)


def _displacement(r: Array, a: Array, R: Array, h: Array, wavelength: Array, k: Array) -> Array:
    from ..._runtime.graded.displacement import power_displacement, waves_displacement

    return power_displacement(r, a, 2.0, k) / (2 * R) + h * waves_displacement(r, a, 2 * np.pi / wavelength, k)


def _radius_from_depth(d: Array, R: Array, h: Array, wavelength: Array, k: Array) -> Array:
    from ..._runtime.graded.inverse import radius_to

    return radius_to(_depth, _rate, d, 1.5 * wavelength, (R, h, wavelength, k))


def _radius_from_force(F: Array, R: Array, h: Array, wavelength: Array, H: Array, k: Array) -> Array:
    from ..._runtime.graded.inverse import radius_to

    return radius_to(_force, _force_rate, F, 1.5 * wavelength, (R, h, wavelength, H, k))


def _force_from_depth(d: Array, R: Array, h: Array, wavelength: Array, H: Array, k: Array) -> Array:
    a = _radius_from_depth(d, R, h, wavelength, k)
    return _force(a, R, h, wavelength, H, k) + punch_force(d - _depth(a, R, h, wavelength, k), a, H, k)


def _depth_from_force(F: Array, R: Array, h: Array, wavelength: Array, H: Array, k: Array) -> Array:
    a = _radius_from_force(F, R, h, wavelength, H, k)
    return _depth(a, R, h, wavelength, k) + punch_depth(F - _force(a, R, h, wavelength, H, k), a, H, k)


def _check(R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, *, k: ArrayLike, **material: ArrayLike) -> None:
    require(R=R, h=h, wavelength=wavelength, k=k, **material)
    R, h, wavelength = np.asarray(R), np.asarray(h), np.asarray(wavelength)
    require_order(
        elementwise(steepest_waves, k=k) * R * h <= wavelength**2,
        "steepest_waves(k)*R*h <= wavelength**2",
        "steeper waves leave gaps and the contact is not compact; lower h or lengthen the wave",
        R=R,
        h=h,
        wavelength=wavelength,
        k=k,
    )
