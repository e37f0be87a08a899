"""Wavy paraboloid.

A paraboloid with concentric waves of amplitude h, 2h from valley to peak, too shallow to leave gaps.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, require, require_order
from .._runtime.rules import displacement_integral_waves, pressure_integral_waves
from .._runtime.shapes.energy import energy_integral
from .._runtime.shapes.load_within import load_within_integral
from .._runtime.shapes.waves import inverse_over_waves
from .._runtime.special import struve_h0, struve_h1

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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN field values give NaN. Handbook:
    wavy_paraboloid.f, the definition of the profile.

    References
    ----------
    Guduru 2007.

    Examples
    --------
    >>> from axicontact.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.profile(0.3, R=1.6, h=0.01, wavelength=0.5)
    >>> round(value, 6)
    0.046215
    """
    _check(R=R, h=h, wavelength=wavelength)
    return elementwise(_profile, r, R=R, h=h, wavelength=wavelength)


def depth(a: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = a*(pi**2*h*StruveH(0, 2*pi*a/wavelength)/wavelength + a/R)
    with StruveH: Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Amplitude of the waves, half of their height from valley to peak [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.

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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN field values give NaN. The
    number 12.3914 of the homogeneous half-space is another on a graded one, where g' >= 0 asks for 15.5992 at
    k = -0.5 and for 10.1777 at k = 0.5. Handbook: wavy_paraboloid.d.

    References
    ----------
    chapter 11, equation (11.29); Guduru 2007.

    Examples
    --------
    >>> from axicontact.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.depth(1.0, R=1.6, h=0.01, wavelength=0.5)
    >>> round(value, 6)
    0.603226
    """
    _check(R=R, h=h, wavelength=wavelength)
    return elementwise(_depth, a, R=R, h=h, wavelength=wavelength)


def force(a: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force.

    F = E_star*a*(2*pi**2*a*h*StruveH(0, 2*pi*a/wavelength)/wavelength - pi*h*StruveH(1, 2*pi*a/wavelength) +
    4*a**2/(3*R))
    with StruveH: Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Amplitude of the waves, half of their height from valley to peak [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN field values give NaN. The
    number 12.3914 of the homogeneous half-space is another on a graded one, where g' >= 0 asks for 15.5992 at
    k = -0.5 and for 10.1777 at k = 0.5. Handbook: wavy_paraboloid.F.

    References
    ----------
    chapter 11, equation (11.20); Guduru 2007.

    Examples
    --------
    >>> from axicontact.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.force(1.0, R=1.6, h=0.01, wavelength=0.5, E_star=1.0)
    >>> round(value, 6)
    0.774814
    """
    _check(R=R, h=h, wavelength=wavelength, E_star=E_star)
    return elementwise(_force, a, R=R, h=h, wavelength=wavelength, E_star=E_star)


def pressure(
    r: ArrayLike, a: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, E_star: ArrayLike
) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = E_star*Integral((pi**2*h*StruveH(0, 2*pi*sqrt(r**2 + u**2)/wavelength)/wavelength + sqrt(r**2 +
    u**2)*(2*pi**3*h*(-StruveH(1, 2*pi*sqrt(r**2 + u**2)/wavelength) + 2/pi)/wavelength**2 + 1/R) + sqrt(r**2
    + u**2)/R)/sqrt(r**2 + u**2), (u, 0, sqrt(a**2 - r**2)))/pi
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
        Amplitude of the waves, half of their height from valley to peak [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN field values give NaN. Evaluated
    as an integral over the growing contact by a Gauss-Legendre rule. The number 12.3914 of the homogeneous
    half-space is another on a graded one, where g' >= 0 asks for 15.5992 at k = -0.5 and for 10.1777 at k =
    0.5. Handbook: wavy_paraboloid.p.

    References
    ----------
    chapter 11, equation (11.23); Guduru 2007.

    Examples
    --------
    >>> from axicontact.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.pressure(0.3, 1.0, R=1.6, h=0.01, wavelength=0.5, E_star=1.0)
    >>> round(value, 6)
    0.313678
    """
    _check(R=R, h=h, wavelength=wavelength, E_star=E_star)
    return elementwise(_pressure, r, a, R=R, h=h, wavelength=wavelength, E_star=E_star)


def displacement(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*Integral(psi*r*(pi**2*h*StruveH(0, 2*pi*r*sin(psi)/wavelength)/wavelength +
    r*(2*pi**3*h*(-StruveH(1, 2*pi*r*sin(psi)/wavelength) + 2/pi)/wavelength**2 + 1/R)*sin(psi) +
    r*sin(psi)/R)*cos(psi), (psi, 0, asin(a/r)))/pi
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
        Amplitude of the waves, half of their height from valley to peak [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.

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
    as an integral over the growing contact by a Gauss-Legendre rule. Handbook: wavy_paraboloid.w.

    References
    ----------
    chapter 11, equation (11.26); Guduru 2007.

    Examples
    --------
    >>> from axicontact.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.displacement(2.0, 1.0, R=1.6, h=0.01, wavelength=0.5)
    >>> round(value, 6)
    0.126604
    """
    _check(R=R, h=h, wavelength=wavelength)
    return elementwise(_displacement, r, a, R=R, h=h, wavelength=wavelength)


def stiffness(a: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*E_star*a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Amplitude of the waves, half of their height from valley to peak [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN field values give NaN. Handbook:
    wavy_paraboloid.k.

    References
    ----------
    chapter 11, equation (11.18); Guduru 2007.

    Examples
    --------
    >>> from axicontact.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.stiffness(1.0, R=1.6, h=0.01, wavelength=0.5, E_star=1.0)
    >>> round(value, 6)
    2.0
    """
    _check(R=R, h=h, wavelength=wavelength, E_star=E_star)
    return elementwise(_stiffness, a, E_star=E_star, unused=(R, h, wavelength))


def mean_pressure(a: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, E_star: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = E_star*(2*pi*h*StruveH(0, 2*pi*a/wavelength)/wavelength - h*StruveH(1, 2*pi*a/wavelength)/a +
    4*a/(3*pi*R))
    with StruveH: Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Amplitude of the waves, half of their height from valley to peak [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN field values give NaN. Handbook:
    wavy_paraboloid.pm.

    References
    ----------
    Guduru 2007.

    Examples
    --------
    >>> from axicontact.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.mean_pressure(1.0, R=1.6, h=0.01, wavelength=0.5, E_star=1.0)
    >>> round(value, 6)
    0.246631
    """
    _check(R=R, h=h, wavelength=wavelength, E_star=E_star)
    return elementwise(_mean_pressure, a, R=R, h=h, wavelength=wavelength, E_star=E_star)


def radius_from_depth(d: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a from a*(pi**2*h*StruveH(0, 2*pi*a/wavelength)/wavelength + a/R) = d
    with StruveH: Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Amplitude of the waves, half of their height from valley to peak [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.

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
    by a safeguarded Newton iteration. Handbook: wavy_paraboloid.ad.

    References
    ----------
    chapter 11, equation (11.16); Guduru 2007.

    Examples
    --------
    >>> from axicontact.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.radius_from_depth(0.6032, R=1.6, h=0.01, wavelength=0.5)
    >>> round(value, 6)
    0.999984
    """
    _check(R=R, h=h, wavelength=wavelength)
    return elementwise(_radius_from_depth, d, R=R, h=h, wavelength=wavelength)


def radius_from_force(F: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, E_star: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a from E_star*a*(2*pi**2*a*h*StruveH(0, 2*pi*a/wavelength)/wavelength - pi*h*StruveH(1, 2*pi*a/wavelength)
    + 4*a**2/(3*R)) = F
    with StruveH: Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Amplitude of the waves, half of their height from valley to peak [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN field values give NaN. Evaluated
    by a safeguarded Newton iteration. Handbook: wavy_paraboloid.aF.

    References
    ----------
    chapter 11, equation (11.20); Guduru 2007.

    Examples
    --------
    >>> from axicontact.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.radius_from_force(0.7748, R=1.6, h=0.01, wavelength=0.5, E_star=1.0)
    >>> round(value, 6)
    0.999996
    """
    _check(R=R, h=h, wavelength=wavelength, E_star=E_star)
    return elementwise(_radius_from_force, F, R=R, h=h, wavelength=wavelength, E_star=E_star)


def force_from_depth(d: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, E_star: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = F(a(d)), through the contact radius.

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Amplitude of the waves, half of their height from valley to peak [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN field values give NaN. Evaluated
    by a safeguarded Newton iteration. Handbook: wavy_paraboloid.Fd.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Guduru 2007.

    Examples
    --------
    >>> from axicontact.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.force_from_depth(0.6032, R=1.6, h=0.01, wavelength=0.5, E_star=1.0)
    >>> round(value, 6)
    0.774762
    """
    _check(R=R, h=h, wavelength=wavelength, E_star=E_star)
    return elementwise(_force_from_depth, d, R=R, h=h, wavelength=wavelength, E_star=E_star)


def depth_from_force(F: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, E_star: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = d(a(F)), through the contact radius.

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Amplitude of the waves, half of their height from valley to peak [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN field values give NaN. Evaluated
    by a safeguarded Newton iteration. Handbook: wavy_paraboloid.dF.

    References
    ----------
    chapter 11, equation (11.16); chapter 11, equation (11.20); Guduru 2007.

    Examples
    --------
    >>> from axicontact.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.depth_from_force(0.7748, R=1.6, h=0.01, wavelength=0.5, E_star=1.0)
    >>> round(value, 6)
    0.603219
    """
    _check(R=R, h=h, wavelength=wavelength, E_star=E_star)
    return elementwise(_depth_from_force, F, R=R, h=h, wavelength=wavelength, E_star=E_star)


def energy(a: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, E_star: ArrayLike) -> Result:
    """Elastic energy, the work of pressing the indenter in.

    U = E_star*Integral((a*(pi**2*h*StruveH(0, 2*pi*a/wavelength)/wavelength + a/R) - t*(pi**2*h*StruveH(0,
    2*pi*t/wavelength)/wavelength + t/R))**2, (t, 0, a))
    with StruveH: Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Amplitude of the waves, half of their height from valley to peak [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN field values give NaN. Evaluated
    as an integral over the growing contact by a Gauss-Legendre rule. Handbook: wavy_paraboloid.U.

    References
    ----------
    Guduru 2007.

    Examples
    --------
    >>> from axicontact.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.energy(1.0, R=1.6, h=0.01, wavelength=0.5, E_star=1.0)
    >>> round(value, 6)
    0.182654
    """
    _check(R=R, h=h, wavelength=wavelength, E_star=E_star)
    return elementwise(_energy, a, R=R, h=h, wavelength=wavelength, E_star=E_star)


def load_within(
    r: ArrayLike, a: ArrayLike, *, R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, E_star: ArrayLike
) -> Result:
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
    h : array_like
        Amplitude of the waves, half of their height from valley to peak [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
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
    Valid for a << R; waves so flat that g' >= 0 for every a. Negative or NaN field values give NaN. Evaluated
    as an integral over the growing contact by a Gauss-Legendre rule. Handbook: wavy_paraboloid.Fr.

    References
    ----------
    Guduru 2007.

    Examples
    --------
    >>> from axicontact.normal import wavy_paraboloid
    >>> value = wavy_paraboloid.load_within(0.3, 1.0, R=1.6, h=0.01, wavelength=0.5, E_star=1.0)
    >>> round(value, 6)
    0.099723
    """
    _check(R=R, h=h, wavelength=wavelength, E_star=E_star)
    return elementwise(_load_within, r, a, R=R, h=h, wavelength=wavelength, E_star=E_star)


def _check(R: ArrayLike, h: ArrayLike, wavelength: ArrayLike, **material: ArrayLike) -> None:
    require(R=R, h=h, wavelength=wavelength, **material)
    R, h, wavelength = np.asarray(R), np.asarray(h), np.asarray(wavelength)
    require_order(
        12.391420936291585 * h * R <= wavelength**2,
        "12.391420936291584*R*h <= wavelength**2",
        "steeper waves leave gaps and the contact is not compact; lower h or lengthen the wave",
        R=R,
        h=h,
        wavelength=wavelength,
    )


def _profile(r: Array, R: Array, h: Array, wavelength: Array) -> Array:
    return 2 * h * np.sin(np.pi / wavelength * r) ** 2 + r**2 / (2 * R)


def _slope(t: Array, R: Array, h: Array, wavelength: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t)."""
    z = 2 * np.pi / wavelength * t
    plus = 4 * np.pi**2 * h / wavelength**2 * t + np.pi**2 * h / wavelength * struve_h0(z) + 2 * t / R
    minus = 2 * np.pi**3 * h / wavelength**2 * t * struve_h1(z)
    return plus - minus


def _depth(a: Array, R: Array, h: Array, wavelength: Array) -> Array:
    z = 2 * np.pi / wavelength * a
    return a * (np.pi**2 * h / wavelength * struve_h0(z) + a / R)


def _force(a: Array, R: Array, h: Array, wavelength: Array, E_star: Array) -> Array:
    z = 2 * np.pi / wavelength * a
    plus = 2 * np.pi**2 * h / wavelength * a * struve_h0(z) + 4 * a**2 / (3 * R)
    minus = np.pi * h * struve_h1(z)
    return E_star * a * (plus - minus)


def _pressure(r: Array, a: Array, R: Array, h: Array, wavelength: Array, E_star: Array) -> Array:
    within = pressure_integral_waves(lambda t: _slope(t, R, h, wavelength), r, a, wavelength)
    return np.where(r < a, E_star / np.pi * within, 0.0)


def _displacement(r: Array, a: Array, R: Array, h: Array, wavelength: Array) -> Array:
    tip = displacement_integral_waves(lambda t: _slope(t, R, h, wavelength), r, a, wavelength)
    outside = 2 / np.pi * tip
    inside = _depth(a, R, h, wavelength) - _profile(r, R, h, wavelength)
    return np.where(r > a, outside, inside)


def _stiffness(a: Array, E_star: Array) -> Array:
    return 2 * E_star * a


def _mean_pressure(a: Array, R: Array, h: Array, wavelength: Array, E_star: Array) -> Array:
    return np.where(a > 0.0, _force(a, R, h, wavelength, E_star) / (np.pi * a**2), 0.0)


def _energy(a: Array, R: Array, h: Array, wavelength: Array, E_star: Array) -> Array:
    sunk = _depth(a, R, h, wavelength)
    tip = energy_integral(_depth, (R, h, wavelength), a, sunk, a, width=1.0 / (1.0 + 4.0 * np.pi / wavelength * a))
    return E_star * tip


def _load_within(r: Array, a: Array, R: Array, h: Array, wavelength: Array, E_star: Array) -> Array:
    tip = load_within_integral(
        _slope, (R, h, wavelength), np.minimum(r, a), a, width=1.0 / (1.0 + 4.0 * np.pi / wavelength * a)
    )
    return _force(np.minimum(r, a), R, h, wavelength, E_star) + 2 * E_star * tip


def _radius_from_depth(d: Array, R: Array, h: Array, wavelength: Array) -> Array:
    unit = wavelength / (2 * np.pi)
    waves = 2 * np.pi**3 * h * R / wavelength**2
    return unit * inverse_over_waves(d / unit * (R / unit), waves, 1)


def _radius_from_force(F: Array, R: Array, h: Array, wavelength: Array, E_star: Array) -> Array:
    unit = wavelength / (2 * np.pi)
    waves = 2 * np.pi**3 * h * R / wavelength**2
    return unit * inverse_over_waves(F / unit * (R / unit) / (2 * E_star * unit), waves, 2)


def _force_from_depth(d: Array, R: Array, h: Array, wavelength: Array, E_star: Array) -> Array:
    a = _radius_from_depth(d, R, h, wavelength)
    change = np.where((a > 0.0) & (a < np.inf), 2 * E_star * a * (d - _depth(a, R, h, wavelength)), 0.0)
    return _force(a, R, h, wavelength, E_star) + change


def _depth_from_force(F: Array, R: Array, h: Array, wavelength: Array, E_star: Array) -> Array:
    a = _radius_from_force(F, R, h, wavelength, E_star)
    change = np.where((a > 0.0) & (a < np.inf), (F - _force(a, R, h, wavelength, E_star)) / (2 * E_star * a), 0.0)
    return _depth(a, R, h, wavelength) + change
