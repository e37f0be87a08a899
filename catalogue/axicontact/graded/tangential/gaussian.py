"""Gaussian bump under a tangential load on a power-law graded half-space.

A smooth asperity of height h and width s; compact up to the radius of largest depth.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.growth import gaussian_depth, gaussian_force, gaussian_rate
from ..._runtime.interface import Array, Result, either, elementwise, numbers, require, require_order
from ..._runtime.physics.slip import stick_force
from ..normal import gaussian as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["full_slip_displacement", "stick_radius", "tangential_displacement", "tangential_force", "traction"]


def __dir__() -> list[str]:
    return __all__


def tangential_force(
    a: ArrayLike, c: ArrayLike, *, h: ArrayLike, s: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential force with a stick zone of radius c.

    F_x = mu*(8*H*a**(k + 3)*h*1F1(2, (k + 5)/2, -a**2/s**2)/(s**2*(k + 1)**2*(k + 3)) - 8*H*c**(k +
    3)*h*1F1(2, (k + 5)/2, -c**2/s**2)/(s**2*(k + 1)**2*(k + 3)))
    with 1F1: Confluent 1F1(p; c; z)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    gaussian.fgm.tan.F.

    References
    ----------
    chapter 11, equation (11.78); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.graded.tangential import gaussian
    >>> value = gaussian.tangential_force(1.0, 0.6, h=0.7, s=1.0, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.110672
    """
    require(h=h, s=s, H=H, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_force, a, c, h=h, s=s, H=H, k=k, mu=mu)


def traction(
    r: ArrayLike, a: ArrayLike, c: ArrayLike, *, h: ArrayLike, s: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike
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
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    gaussian.fgm.tan.tau.

    References
    ----------
    chapter 11, equation (11.79); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.graded.tangential import gaussian
    >>> value = gaussian.traction(0.3, 1.0, 0.6, h=0.7, s=1.0, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.038186
    """
    require(h=h, s=s, H=H, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_traction, r, a, c, h=h, s=s, H=H, k=k, mu=mu)


def tangential_displacement(
    a: ArrayLike, c: ArrayLike, *, h: ArrayLike, s: ArrayLike, H: ArrayLike, H_x: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement of the indenter with a stick zone of radius c.

    u_0 = H*mu*(2*a**2*h*1F1(1, (k + 3)/2, -a**2/s**2)/(s**2*(k + 1)) - 2*c**2*h*1F1(1, (k + 3)/2,
    -c**2/s**2)/(s**2*(k + 1)))/H_x
    with 1F1: Confluent 1F1(p; c; z)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    gaussian.fgm.tan.u.

    References
    ----------
    chapter 11, equation (11.80); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.graded.tangential import gaussian
    >>> value = gaussian.tangential_displacement(1.0, 0.6, h=0.7, s=1.0, H=1.0, H_x=0.8, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.115932
    """
    require(h=h, s=s, H=H, H_x=H_x, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_displacement, a, c, h=h, s=s, H=H, H_x=H_x, k=k, mu=mu)


def stick_radius(
    F_x: ArrayLike, a: ArrayLike, *, h: ArrayLike, s: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Radius of the stick zone under a tangential force; NaN beyond full slip.

    c from mu*(8*H*a**(k + 3)*h*1F1(2, (k + 5)/2, -a**2/s**2)/(s**2*(k + 1)**2*(k + 3)) - 8*H*c**(k +
    3)*h*1F1(2, (k + 5)/2, -c**2/s**2)/(s**2*(k + 1)**2*(k + 3))) = F_x
    with 1F1: Confluent 1F1(p; c; z)

    Parameters
    ----------
    F_x : array_like
        Tangential force [N].
    a : array_like
        Contact radius [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    gaussian.fgm.tan.c.

    References
    ----------
    chapter 11, equation (11.78); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.graded.tangential import gaussian
    >>> value = gaussian.stick_radius(0.1107, 1.0, h=0.7, s=1.0, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.59987
    """
    require(h=h, s=s, H=H, k=k, mu=mu)
    return elementwise(_stick_radius, F_x, a, h=h, s=s, H=H, k=k, mu=mu)


def full_slip_displacement(
    a: ArrayLike, *, h: ArrayLike, s: ArrayLike, H: ArrayLike, H_x: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement at the onset of full slip.

    u_0 = 2*H*a**2*h*mu*1F1(1, (k + 3)/2, -a**2/s**2)/(H_x*s**2*(k + 1))
    with 1F1: Confluent 1F1(p; c; z)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN. Handbook:
    gaussian.fgm.tan.us.

    References
    ----------
    chapter 11, equation (11.80); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.graded.tangential import gaussian
    >>> value = gaussian.full_slip_displacement(1.0, h=0.7, s=1.0, H=1.0, H_x=0.8, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.237806
    """
    require(h=h, s=s, H=H, H_x=H_x, k=k, mu=mu)
    return elementwise(_full_slip_displacement, a, h=h, s=s, H=H, H_x=H_x, k=k, mu=mu)


def _tangential_force(a: Array, c: Array, h: Array, s: Array, H: Array, k: Array, mu: Array) -> Array:
    from ..._runtime.graded.slip import smooth_gain

    gain = h * smooth_gain("force", gaussian_force, gaussian_rate, (s,), 0.0, c, a, k)
    return np.where(normal._rate(a, h, s, k) >= 0.0, mu * (2.0 * H / (1.0 + k)) * gain, np.nan)


def _traction(r: Array, a: Array, c: Array, h: Array, s: Array, H: Array, k: Array, mu: Array) -> Array:
    from ..._runtime.graded.pressure import gaussian_pressure
    from ..._runtime.graded.slip import smooth_gain

    def gain() -> Array:
        inside = np.minimum(r, c)
        return h * smooth_gain("pressure", gaussian_pressure, gaussian_rate, (s,), inside, c, a, k)

    return np.where(
        normal._rate(a, h, s, k) >= 0.0,
        mu * either(r < c, lambda: H / np.pi * gain(), lambda: normal._pressure(r, a, h, s, H, k)),
        np.nan,
    )


def _tangential_displacement(
    a: Array, c: Array, h: Array, s: Array, H: Array, H_x: Array, k: Array, mu: Array
) -> Array:
    from ..._runtime.graded.slip import smooth_gain

    gain = h * smooth_gain("depth", gaussian_depth, gaussian_rate, (s,), 0.0, c, a, k)
    return np.where(normal._rate(a, h, s, k) >= 0.0, mu * (H / H_x) * gain, np.nan)


def _stick_radius(F_x: Array, a: Array, h: Array, s: Array, H: Array, k: Array, mu: Array) -> Array:
    F = stick_force(normal._force(a, h, s, H, k), F_x, mu)
    return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force(F, h, s, H, k))


def _full_slip_displacement(a: Array, h: Array, s: Array, H: Array, H_x: Array, k: Array, mu: Array) -> Array:
    return mu * (H / H_x) * normal._depth(a, h, s, k)
