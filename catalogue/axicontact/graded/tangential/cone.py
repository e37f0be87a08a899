"""Cone under a tangential load on a power-law graded half-space.

Rigid cone of inclination theta. Self-similar: the mean pressure does not depend on the load.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.interface import Array, Result, either, elementwise, numbers, require, require_order
from ..._runtime.physics.slip import stick_force
from ..normal import cone as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["full_slip_displacement", "stick_radius", "tangential_displacement", "tangential_force", "traction"]


def __dir__() -> list[str]:
    return __all__


def tangential_force(
    a: ArrayLike, c: ArrayLike, *, theta: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential force with a stick zone of radius c.

    F_x = mu*(sqrt(pi)*H*a**(k + 2)*tan(theta)*gamma((k + 1)/2)/((k + 1)*(k + 2)*gamma(k/2 + 1)) -
    sqrt(pi)*H*c**(k + 2)*tan(theta)*gamma((k + 1)/2)/((k + 1)*(k + 2)*gamma(k/2 + 1)))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body; Cattaneo-Mindlin approximation. Negative or NaN field
    values give NaN. Handbook: cone.fgm.tan.F.

    References
    ----------
    chapter 11, equation (11.78); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.tangential import cone
    >>> value = cone.tangential_force(1.0, 0.6, theta=0.35, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.071817
    """
    require(theta=theta, H=H, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_force, a, c, theta=theta, H=H, k=k, mu=mu)


def traction(
    r: ArrayLike, a: ArrayLike, c: ArrayLike, *, theta: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential traction; zero outside the contact.

    tau = H*mu*r**k*tan(theta)*IncompleteBeta(1 - r**2/a**2, (k + 1)/2, -k/2)*gamma((k +
    1)/2)/(4*sqrt(pi)*gamma(k/2 + 1))   for c < r
    tau = mu*(H*r**k*tan(theta)*IncompleteBeta(1 - r**2/a**2, (k + 1)/2, -k/2)*gamma((k +
    1)/2)/(4*sqrt(pi)*gamma(k/2 + 1)) - H*r**k*tan(theta)*IncompleteBeta(1 - r**2/c**2, (k + 1)/2,
    -k/2)*gamma((k + 1)/2)/(4*sqrt(pi)*gamma(k/2 + 1)))   for r < c
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body; Cattaneo-Mindlin approximation. Negative or NaN field
    values give NaN. Handbook: cone.fgm.tan.tau.

    References
    ----------
    chapter 11, equation (11.79); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.tangential import cone
    >>> value = cone.traction(0.3, 1.0, 0.6, theta=0.35, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.024055
    """
    require(theta=theta, H=H, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_traction, r, a, c, theta=theta, H=H, k=k, mu=mu)


def tangential_displacement(
    a: ArrayLike, c: ArrayLike, *, theta: ArrayLike, H: ArrayLike, H_x: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement of the indenter with a stick zone of radius c.

    u_0 = H*mu*(sqrt(pi)*a*tan(theta)*gamma((k + 1)/2)/(2*gamma(k/2 + 1)) - sqrt(pi)*c*tan(theta)*gamma((k +
    1)/2)/(2*gamma(k/2 + 1)))/H_x

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body; Cattaneo-Mindlin approximation. Negative or NaN field
    values give NaN. Handbook: cone.fgm.tan.u.

    References
    ----------
    chapter 11, equation (11.80); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.tangential import cone
    >>> value = cone.tangential_displacement(1.0, 0.6, theta=0.35, H=1.0, H_x=0.8, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.073916
    """
    require(theta=theta, H=H, H_x=H_x, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_displacement, a, c, theta=theta, H=H, H_x=H_x, k=k, mu=mu)


def stick_radius(
    F_x: ArrayLike, a: ArrayLike, *, theta: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Radius of the stick zone under a tangential force; NaN beyond full slip.

    c = a*(-F_x*a**(-k - 2)*(k + 1)*(k + 2)*gamma(k/2 + 1)/(sqrt(pi)*H*mu*tan(theta)*gamma((k + 1)/2)) +
    1)**(1/(k + 2))

    Parameters
    ----------
    F_x : array_like
        Tangential force [N].
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body; Cattaneo-Mindlin approximation. Negative or NaN field
    values give NaN. Handbook: cone.fgm.tan.c.

    References
    ----------
    chapter 11, equation (11.78); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.tangential import cone
    >>> value = cone.stick_radius(0.07182, 1.0, theta=0.35, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.599975
    """
    require(theta=theta, H=H, k=k, mu=mu)
    return elementwise(_stick_radius, F_x, a, theta=theta, H=H, k=k, mu=mu)


def full_slip_displacement(
    a: ArrayLike, *, theta: ArrayLike, H: ArrayLike, H_x: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement at the onset of full slip.

    u_0 = sqrt(pi)*H*a*mu*tan(theta)*gamma((k + 1)/2)/(2*H_x*gamma(k/2 + 1))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body; Cattaneo-Mindlin approximation. Negative or NaN field
    values give NaN. Handbook: cone.fgm.tan.us.

    References
    ----------
    chapter 11, equation (11.80); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.tangential import cone
    >>> value = cone.full_slip_displacement(1.0, theta=0.35, H=1.0, H_x=0.8, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.184789
    """
    require(theta=theta, H=H, H_x=H_x, k=k, mu=mu)
    return elementwise(_full_slip_displacement, a, theta=theta, H=H, H_x=H_x, k=k, mu=mu)


def _tangential_force(a: Array, c: Array, theta: Array, H: Array, k: Array, mu: Array) -> Array:
    from ..._runtime.graded.slip import power_gain

    gain = power_gain("force", 0.0, c, a, 1.0, k) * np.tan(theta)
    return mu * (2.0 * H / (1.0 + k)) * gain


def _traction(r: Array, a: Array, c: Array, theta: Array, H: Array, k: Array, mu: Array) -> Array:
    from ..._runtime.graded.slip import power_gain

    def gain() -> Array:
        inside = np.minimum(r, c)
        return power_gain("pressure", inside, c, a, 1.0, k) * np.tan(theta)

    return mu * either(r < c, lambda: H / np.pi * gain(), lambda: normal._pressure(r, a, theta, H, k))


def _tangential_displacement(a: Array, c: Array, theta: Array, H: Array, H_x: Array, k: Array, mu: Array) -> Array:
    from ..._runtime.graded.slip import power_gain

    gain = power_gain("depth", 0.0, c, a, 1.0, k) * np.tan(theta)
    return mu * (H / H_x) * gain


def _stick_radius(F_x: Array, a: Array, theta: Array, H: Array, k: Array, mu: Array) -> Array:
    F = stick_force(normal._force(a, theta, H, k), F_x, mu)
    return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force(F, theta, H, k))


def _full_slip_displacement(a: Array, theta: Array, H: Array, H_x: Array, k: Array, mu: Array) -> Array:
    return mu * (H / H_x) * normal._depth(a, theta, k)
