"""Wavy paraboloid under a tangential load on a power-law graded half-space.

A paraboloid with concentric waves of amplitude h, 2h from valley to peak, too shallow to leave gaps.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.waves import waves_depth, waves_force, waves_rate
from ..._runtime.interface import Array, Result, either, elementwise, numbers, require_order
from ..._runtime.physics.slip import stick_force
from ..normal import wavy_paraboloid as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["full_slip_displacement", "stick_radius", "tangential_displacement", "tangential_force", "traction"]


def __dir__() -> list[str]:
    return __all__


def tangential_force(
    a: ArrayLike,
    c: ArrayLike,
    *,
    R: ArrayLike,
    h: ArrayLike,
    wavelength: ArrayLike,
    H: ArrayLike,
    k: ArrayLike,
    mu: ArrayLike,
) -> Result:
    """Tangential force with a stick zone of radius c.

    F_x = mu*(F(a) - F(c))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
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
    mu : array_like
        Coefficient of friction [1], mu >= 0.

    Returns
    -------
    float or ndarray
        Tangential force [N]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R; waves so flat that g' >= 0 for every a; Cattaneo-Mindlin approximation. Negative or NaN
    field values give NaN. Handbook: wavy_paraboloid.fgm.tan.F.

    References
    ----------
    chapter 11, equation (11.78); Guduru 2007.

    Examples
    --------
    >>> from axicontact.graded.tangential import wavy_paraboloid
    >>> value = wavy_paraboloid.tangential_force(1.0, 0.6, R=1.6, h=0.01, wavelength=0.5, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.106501
    """
    normal._check(R=R, h=h, wavelength=wavelength, H=H, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_force, a, c, R=R, h=h, wavelength=wavelength, H=H, k=k, mu=mu)


def traction(
    r: ArrayLike,
    a: ArrayLike,
    c: ArrayLike,
    *,
    R: ArrayLike,
    h: ArrayLike,
    wavelength: ArrayLike,
    H: ArrayLike,
    k: ArrayLike,
    mu: ArrayLike,
) -> Result:
    """Tangential traction; zero outside the contact.

    tau = mu*(p(r, a) - p(r, c))

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
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
    mu : array_like
        Coefficient of friction [1], mu >= 0.

    Returns
    -------
    float or ndarray
        Tangential traction [Pa]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R; waves so flat that g' >= 0 for every a; Cattaneo-Mindlin approximation. Negative or NaN
    field values give NaN. Handbook: wavy_paraboloid.fgm.tan.tau.

    References
    ----------
    chapter 11, equation (11.79); Guduru 2007.

    Examples
    --------
    >>> from axicontact.graded.tangential import wavy_paraboloid
    >>> value = wavy_paraboloid.traction(0.3, 1.0, 0.6, R=1.6, h=0.01, wavelength=0.5, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.035389
    """
    normal._check(R=R, h=h, wavelength=wavelength, H=H, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_traction, r, a, c, R=R, h=h, wavelength=wavelength, H=H, k=k, mu=mu)


def tangential_displacement(
    a: ArrayLike,
    c: ArrayLike,
    *,
    R: ArrayLike,
    h: ArrayLike,
    wavelength: ArrayLike,
    H: ArrayLike,
    H_x: ArrayLike,
    k: ArrayLike,
    mu: ArrayLike,
) -> Result:
    """Tangential displacement of the indenter with a stick zone of radius c.

    u_0 = H*mu*(pi**(3/2 - k/2)*a**(1 - k/2)*h*wavelength**(k/2 - 1)*StruveH(k/2, 2*pi*a/wavelength)*gamma((k
    + 1)/2) - pi**(3/2 - k/2)*c**(1 - k/2)*h*wavelength**(k/2 - 1)*StruveH(k/2, 2*pi*c/wavelength)*gamma((k +
    1)/2) + a**2/(R*(k + 1)) - c**2/(R*(k + 1)))/H_x
    with StruveH: Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    H_x : array_like
        Tangential foundation modulus, c_T(x) = H_x |x|^k [Pa m^(-k)], H_x > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.
    mu : array_like
        Coefficient of friction [1], mu >= 0.

    Returns
    -------
    float or ndarray
        Tangential displacement of the rigid body [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R; waves so flat that g' >= 0 for every a; Cattaneo-Mindlin approximation. Negative or NaN
    field values give NaN. Handbook: wavy_paraboloid.fgm.tan.u.

    References
    ----------
    chapter 11, equation (11.80); Guduru 2007.

    Examples
    --------
    >>> from axicontact.graded.tangential import wavy_paraboloid
    >>> value = wavy_paraboloid.tangential_displacement(
    ...     1.0, 0.6, R=1.6, h=0.01, wavelength=0.5, H=1.0, H_x=0.8, k=0.25, mu=0.3
    ... )
    >>> round(value, 6)
    0.108797
    """
    normal._check(R=R, h=h, wavelength=wavelength, H=H, H_x=H_x, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_displacement, a, c, R=R, h=h, wavelength=wavelength, H=H, H_x=H_x, k=k, mu=mu)


def stick_radius(
    F_x: ArrayLike,
    a: ArrayLike,
    *,
    R: ArrayLike,
    h: ArrayLike,
    wavelength: ArrayLike,
    H: ArrayLike,
    k: ArrayLike,
    mu: ArrayLike,
) -> Result:
    """Radius of the stick zone under a tangential force; NaN beyond full slip.

    c from mu*(F(a) - F(c)) = F_x

    Parameters
    ----------
    F_x : array_like
        Tangential force [N].
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
    mu : array_like
        Coefficient of friction [1], mu >= 0.

    Returns
    -------
    float or ndarray
        Radius of the stick zone [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R; waves so flat that g' >= 0 for every a; Cattaneo-Mindlin approximation. Negative or NaN
    field values give NaN. Handbook: wavy_paraboloid.fgm.tan.c.

    References
    ----------
    chapter 11, equation (11.78); Guduru 2007.

    Examples
    --------
    >>> from axicontact.graded.tangential import wavy_paraboloid
    >>> value = wavy_paraboloid.stick_radius(0.1065, 1.0, R=1.6, h=0.01, wavelength=0.5, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.600006
    """
    normal._check(R=R, h=h, wavelength=wavelength, H=H, k=k, mu=mu)
    return elementwise(_stick_radius, F_x, a, R=R, h=h, wavelength=wavelength, H=H, k=k, mu=mu)


def full_slip_displacement(
    a: ArrayLike,
    *,
    R: ArrayLike,
    h: ArrayLike,
    wavelength: ArrayLike,
    H: ArrayLike,
    H_x: ArrayLike,
    k: ArrayLike,
    mu: ArrayLike,
) -> Result:
    """Tangential displacement at the onset of full slip.

    u_0 = H*mu*(pi**(3/2 - k/2)*a**(1 - k/2)*h*wavelength**(k/2 - 1)*StruveH(k/2, 2*pi*a/wavelength)*gamma((k
    + 1)/2) + a**2/(R*(k + 1)))/H_x
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
    H_x : array_like
        Tangential foundation modulus, c_T(x) = H_x |x|^k [Pa m^(-k)], H_x > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.
    mu : array_like
        Coefficient of friction [1], mu >= 0.

    Returns
    -------
    float or ndarray
        Tangential displacement of the rigid body [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R; waves so flat that g' >= 0 for every a; Cattaneo-Mindlin approximation. Negative or NaN
    field values give NaN. Handbook: wavy_paraboloid.fgm.tan.us.

    References
    ----------
    chapter 11, equation (11.80); Guduru 2007.

    Examples
    --------
    >>> from axicontact.graded.tangential import wavy_paraboloid
    >>> value = wavy_paraboloid.full_slip_displacement(
    ...     1.0, R=1.6, h=0.01, wavelength=0.5, H=1.0, H_x=0.8, k=0.25, mu=0.3
    ... )
    >>> round(value, 6)
    0.182271
    """
    normal._check(R=R, h=h, wavelength=wavelength, H=H, H_x=H_x, k=k, mu=mu)
    return elementwise(_full_slip_displacement, a, R=R, h=h, wavelength=wavelength, H=H, H_x=H_x, k=k, mu=mu)


def _tangential_force(
    a: Array, c: Array, R: Array, h: Array, wavelength: Array, H: Array, k: Array, mu: Array
) -> Array:
    from ..._runtime.graded.slip import power_gain, waves_gain

    power = power_gain("force", 0.0, c, a, 2.0, k) / (2 * R)
    waves = h * waves_gain("force", waves_force, waves_rate, (2 * np.pi / wavelength,), 0.0, c, a, k)
    gain = power + waves
    return mu * (2.0 * H / (1.0 + k)) * gain


def _traction(
    r: Array, a: Array, c: Array, R: Array, h: Array, wavelength: Array, H: Array, k: Array, mu: Array
) -> Array:
    from ..._runtime.graded.pressure import waves_pressure
    from ..._runtime.graded.slip import power_gain, waves_gain

    def gain() -> Array:
        inside = np.minimum(r, c)
        power = power_gain("pressure", inside, c, a, 2.0, k) / (2 * R)
        waves = h * waves_gain("pressure", waves_pressure, waves_rate, (2 * np.pi / wavelength,), inside, c, a, k)
        return power + waves

    return mu * either(r < c, lambda: H / np.pi * gain(), lambda: normal._pressure(r, a, R, h, wavelength, H, k))


def _tangential_displacement(
    a: Array, c: Array, R: Array, h: Array, wavelength: Array, H: Array, H_x: Array, k: Array, mu: Array
) -> Array:
    from ..._runtime.graded.slip import power_gain, waves_gain

    power = power_gain("depth", 0.0, c, a, 2.0, k) / (2 * R)
    waves = h * waves_gain("depth", waves_depth, waves_rate, (2 * np.pi / wavelength,), 0.0, c, a, k)
    gain = power + waves
    return mu * (H / H_x) * gain


def _stick_radius(F_x: Array, a: Array, R: Array, h: Array, wavelength: Array, H: Array, k: Array, mu: Array) -> Array:
    F = stick_force(normal._force(a, R, h, wavelength, H, k), F_x, mu)
    return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force(F, R, h, wavelength, H, k))


def _full_slip_displacement(
    a: Array, R: Array, h: Array, wavelength: Array, H: Array, H_x: Array, k: Array, mu: Array
) -> Array:
    return mu * (H / H_x) * normal._depth(a, R, h, wavelength, k)
