"""Sphere under a tangential load on a power-law graded half-space.

The exact spherical shape; differs from the paraboloid by terms of order a^2/R^2.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.growth import sphere_depth, sphere_force, sphere_rate
from ..._runtime.interface import Array, Result, either, elementwise, numbers, require, require_order
from ..._runtime.physics.slip import stick_force
from ..normal import sphere as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["full_slip_displacement", "stick_radius", "tangential_displacement", "tangential_force", "traction"]


def __dir__() -> list[str]:
    return __all__


def tangential_force(a: ArrayLike, c: ArrayLike, *, R: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike) -> Result:
    """Tangential force with a stick zone of radius c.

    F_x = mu*(4*H*a**(k + 3)*2F1(1/2, 2, (k + 5)/2, a**2/R**2)/(R*(k + 1)**2*(k + 3)) - 4*H*c**(k +
    3)*2F1(1/2, 2, (k + 5)/2, c**2/R**2)/(R*(k + 1)**2*(k + 3)))
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a < R; the theory of small slopes asks for a << R; Cattaneo-Mindlin approximation. Negative or
    NaN field values give NaN. Handbook: sphere.fgm.tan.F.

    References
    ----------
    chapter 11, equation (11.78); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.tangential import sphere
    >>> value = sphere.tangential_force(1.0, 0.6, R=1.5, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.163237
    """
    require(R=R, H=H, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_force, a, c, R=R, H=H, k=k, mu=mu)


def traction(
    r: ArrayLike, a: ArrayLike, c: ArrayLike, *, R: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike
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
    Valid for a < R; the theory of small slopes asks for a << R; Cattaneo-Mindlin approximation. Negative or
    NaN field values give NaN. Handbook: sphere.fgm.tan.tau.

    References
    ----------
    chapter 11, equation (11.79); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.tangential import sphere
    >>> value = sphere.traction(0.3, 1.0, 0.6, R=1.5, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.051125
    """
    require(R=R, H=H, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_traction, r, a, c, R=R, H=H, k=k, mu=mu)


def tangential_displacement(
    a: ArrayLike, c: ArrayLike, *, R: ArrayLike, H: ArrayLike, H_x: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement of the indenter with a stick zone of radius c.

    u_0 = H*mu*(a**2*2F1(1/2, 1, (k + 3)/2, a**2/R**2)/(R*(k + 1)) - c**2*2F1(1/2, 1, (k
    + 3)/2, c**2/R**2)/(R*(k + 1)))/H_x
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a < R; the theory of small slopes asks for a << R; Cattaneo-Mindlin approximation. Negative or
    NaN field values give NaN. Handbook: sphere.fgm.tan.u.

    References
    ----------
    chapter 11, equation (11.80); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.tangential import sphere
    >>> value = sphere.tangential_displacement(1.0, 0.6, R=1.5, H=1.0, H_x=0.8, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.161639
    """
    require(R=R, H=H, H_x=H_x, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_displacement, a, c, R=R, H=H, H_x=H_x, k=k, mu=mu)


def stick_radius(F_x: ArrayLike, a: ArrayLike, *, R: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike) -> Result:
    """Radius of the stick zone under a tangential force; NaN beyond full slip.

    c from mu*(4*H*a**(k + 3)*2F1(1/2, 2, (k + 5)/2, a**2/R**2)/(R*(k + 1)**2*(k + 3)) - 4*H*c**(k
    + 3)*2F1(1/2, 2, (k + 5)/2, c**2/R**2)/(R*(k + 1)**2*(k + 3))) = F_x
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    F_x : array_like
        Tangential force [N].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a < R; the theory of small slopes asks for a << R; Cattaneo-Mindlin approximation. Negative or
    NaN field values give NaN. Handbook: sphere.fgm.tan.c.

    References
    ----------
    chapter 11, equation (11.78); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.tangential import sphere
    >>> value = sphere.stick_radius(0.1632, 1.0, R=1.5, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.600206
    """
    require(R=R, H=H, k=k, mu=mu)
    return elementwise(_stick_radius, F_x, a, R=R, H=H, k=k, mu=mu)


def full_slip_displacement(
    a: ArrayLike, *, R: ArrayLike, H: ArrayLike, H_x: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement at the onset of full slip.

    u_0 = H*a**2*mu*2F1(1/2, 1, (k + 3)/2, a**2/R**2)/(H_x*R*(k + 1))
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a < R; the theory of small slopes asks for a << R; Cattaneo-Mindlin approximation. Negative or
    NaN field values give NaN. Handbook: sphere.fgm.tan.us.

    References
    ----------
    chapter 11, equation (11.80); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.tangential import sphere
    >>> value = sphere.full_slip_displacement(1.0, R=1.5, H=1.0, H_x=0.8, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.237549
    """
    require(R=R, H=H, H_x=H_x, k=k, mu=mu)
    return elementwise(_full_slip_displacement, a, R=R, H=H, H_x=H_x, k=k, mu=mu)


def _tangential_force(a: Array, c: Array, R: Array, H: Array, k: Array, mu: Array) -> Array:
    from ..._runtime.graded.slip import below_gain

    gain = below_gain("force", sphere_force, sphere_rate, (R,), 0.0, c, a, k)
    return np.where(a <= R, mu * (2.0 * H / (1.0 + k)) * gain, np.nan)


def _traction(r: Array, a: Array, c: Array, R: Array, H: Array, k: Array, mu: Array) -> Array:
    from ..._runtime.graded.pressure import sphere_pressure
    from ..._runtime.graded.slip import below_gain

    def gain() -> Array:
        inside = np.minimum(r, c)
        return below_gain("pressure", sphere_pressure, sphere_rate, (R,), inside, c, a, k)

    return np.where(
        a <= R, mu * either(r < c, lambda: H / np.pi * gain(), lambda: normal._pressure(r, a, R, H, k)), np.nan
    )


def _tangential_displacement(a: Array, c: Array, R: Array, H: Array, H_x: Array, k: Array, mu: Array) -> Array:
    from ..._runtime.graded.slip import below_gain

    gain = below_gain("depth", sphere_depth, sphere_rate, (R,), 0.0, c, a, k)
    return np.where(a <= R, mu * (H / H_x) * gain, np.nan)


def _stick_radius(F_x: Array, a: Array, R: Array, H: Array, k: Array, mu: Array) -> Array:
    F = stick_force(normal._force(a, R, H, k), F_x, mu)
    return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force(F, R, H, k))


def _full_slip_displacement(a: Array, R: Array, H: Array, H_x: Array, k: Array, mu: Array) -> Array:
    return mu * (H / H_x) * normal._depth(a, R, k)
