"""Quartic profile under a tangential load on a power-law graded half-space.

Vanishing curvature at the tip: the pressure has a dip at the centre and its largest value on a ring.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.interface import Array, Result, either, elementwise, numbers, require, require_order
from ..._runtime.physics.slip import stick_force
from ..normal import quartic as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["full_slip_displacement", "stick_radius", "tangential_displacement", "tangential_force", "traction"]


def __dir__() -> list[str]:
    return __all__


def tangential_force(a: ArrayLike, c: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike) -> Result:
    """Tangential force with a stick zone of radius c.

    F_x = mu*(64*A*H*a**(k + 5)/((k + 1)**2*(k + 3)*(k + 5)) - 64*A*H*c**(k + 5)/((k + 1)**2*(k + 3)*(k + 5)))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1; Cattaneo-Mindlin approximation. Negative or NaN field values give
    NaN. Handbook: quartic.fgm.tan.F.

    References
    ----------
    chapter 11, equation (11.78); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.tangential import quartic
    >>> value = quartic.tangential_force(1.0, 0.6, A=0.4, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.268356
    """
    require(A=A, H=H, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_force, a, c, A=A, H=H, k=k, mu=mu)


def traction(
    r: ArrayLike, a: ArrayLike, c: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential traction; zero outside the contact.

    tau = 32*A*H*mu*(a**2 - r**2)**(k/2 + 1/2)*(a**2*k + a**2 + 2*r**2)/(pi*(k + 1)**2*(k + 3)**2)   for c < r
    tau = mu*(32*A*H*(a**2 - r**2)**(k/2 + 1/2)*(a**2*k + a**2 + 2*r**2)/(pi*(k + 1)**2*(k + 3)**2) -
    32*A*H*(c**2 - r**2)**(k/2 + 1/2)*(c**2*k + c**2 + 2*r**2)/(pi*(k + 1)**2*(k + 3)**2))   for r < c

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1; Cattaneo-Mindlin approximation. Negative or NaN field values give
    NaN. Handbook: quartic.fgm.tan.tau.

    References
    ----------
    chapter 11, equation (11.79); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.tangential import quartic
    >>> value = quartic.traction(0.3, 1.0, 0.6, A=0.4, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.079262
    """
    require(A=A, H=H, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_traction, r, a, c, A=A, H=H, k=k, mu=mu)


def tangential_displacement(
    a: ArrayLike, c: ArrayLike, *, A: ArrayLike, H: ArrayLike, H_x: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement of the indenter with a stick zone of radius c.

    u_0 = H*mu*(8*A*a**4/((k + 1)*(k + 3)) - 8*A*c**4/((k + 1)*(k + 3)))/H_x

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1; Cattaneo-Mindlin approximation. Negative or NaN field values give
    NaN. Handbook: quartic.fgm.tan.u.

    References
    ----------
    chapter 11, equation (11.80); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.tangential import quartic
    >>> value = quartic.tangential_displacement(1.0, 0.6, A=0.4, H=1.0, H_x=0.8, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.257103
    """
    require(A=A, H=H, H_x=H_x, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_displacement, a, c, A=A, H=H, H_x=H_x, k=k, mu=mu)


def stick_radius(F_x: ArrayLike, a: ArrayLike, *, A: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike) -> Result:
    """Radius of the stick zone under a tangential force; NaN beyond full slip.

    c = a*(1 - F_x*a**(-k - 5)*(k + 1)**2*(k + 3)*(k + 5)/(64*A*H*mu))**(1/(k + 5))

    Parameters
    ----------
    F_x : array_like
        Tangential force [N].
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1; Cattaneo-Mindlin approximation. Negative or NaN field values give
    NaN. Handbook: quartic.fgm.tan.c.

    References
    ----------
    chapter 11, equation (11.78); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.tangential import quartic
    >>> value = quartic.stick_radius(0.2684, 1.0, A=0.4, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.599742
    """
    require(A=A, H=H, k=k, mu=mu)
    return elementwise(_stick_radius, F_x, a, A=A, H=H, k=k, mu=mu)


def full_slip_displacement(
    a: ArrayLike, *, A: ArrayLike, H: ArrayLike, H_x: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement at the onset of full slip.

    u_0 = 8*A*H*a**4*mu/(H_x*(k + 1)*(k + 3))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
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
    Valid for small slopes, 4 A a^3 << 1; Cattaneo-Mindlin approximation. Negative or NaN field values give
    NaN. Handbook: quartic.fgm.tan.us.

    References
    ----------
    chapter 11, equation (11.80); Steuermann 1939; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.tangential import quartic
    >>> value = quartic.full_slip_displacement(1.0, A=0.4, H=1.0, H_x=0.8, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.295385
    """
    require(A=A, H=H, H_x=H_x, k=k, mu=mu)
    return elementwise(_full_slip_displacement, a, A=A, H=H, H_x=H_x, k=k, mu=mu)


def _tangential_force(a: Array, c: Array, A: Array, H: Array, k: Array, mu: Array) -> Array:
    from ..._runtime.graded.slip import power_gain

    gain = A * power_gain("force", 0.0, c, a, 4.0, k)
    return mu * (2.0 * H / (1.0 + k)) * gain


def _traction(r: Array, a: Array, c: Array, A: Array, H: Array, k: Array, mu: Array) -> Array:
    from ..._runtime.graded.slip import power_gain

    def gain() -> Array:
        inside = np.minimum(r, c)
        return A * power_gain("pressure", inside, c, a, 4.0, k)

    return mu * either(r < c, lambda: H / np.pi * gain(), lambda: normal._pressure(r, a, A, H, k))


def _tangential_displacement(a: Array, c: Array, A: Array, H: Array, H_x: Array, k: Array, mu: Array) -> Array:
    from ..._runtime.graded.slip import power_gain

    gain = A * power_gain("depth", 0.0, c, a, 4.0, k)
    return mu * (H / H_x) * gain


def _stick_radius(F_x: Array, a: Array, A: Array, H: Array, k: Array, mu: Array) -> Array:
    F = stick_force(normal._force(a, A, H, k), F_x, mu)
    return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force(F, A, H, k))


def _full_slip_displacement(a: Array, A: Array, H: Array, H_x: Array, k: Array, mu: Array) -> Array:
    return mu * (H / H_x) * normal._depth(a, A, k)
