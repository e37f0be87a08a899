"""Cone with a spherical tip on a power-law graded half-space.

Sphere of radius R up to b = R sin(theta), then its tangent cone: the exact sphero-conical tip.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.functions import sine_root
from ..._runtime.graded.breaks import tipped_depth, tipped_force, tipped_rate
from ..._runtime.graded.punch import punch_depth, punch_force, punch_stiffness
from ..._runtime.interface import Array, Result, elementwise, require

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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN.

    Examples
    --------
    >>> from axicontact.graded.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.profile(0.3, R=1.2, theta=0.45)
    >>> round(value, 6)
    0.038105
    """
    from ...normal import sphere_tipped_cone as normal

    return normal.profile(r, R=R, theta=theta)


def depth(a: ArrayLike, *, R: ArrayLike, theta: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = a**2*2F1(1/2, 1, (k + 3)/2, a**2/R**2)/(R*(k + 1))   for a < b
    d = a*b*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2)/(2*sqrt(R - b)*sqrt(R + b)) + a**(1 -
    k)*CapMoment(k, b, R, a)   for b < a
    with b = R*sin(theta)
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)
    with CapMoment: J(k; b, R, a) = int_0^b s (R**2 - s**2)**(-1/2) (a**2 - s**2)**((k - 1)/2) ds, for b < a,
    b < R

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: sphere_tipped_cone.fgm.d.

    References
    ----------
    chapter 11, equation (11.61).

    Examples
    --------
    >>> from axicontact.graded.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.depth(1.0, R=1.2, theta=0.45, k=0.25)
    >>> round(value, 6)
    0.516845
    """
    require(R=R, theta=theta, k=k)
    return elementwise(_depth, a, R=R, theta=theta, k=k)


def force(a: ArrayLike, *, R: ArrayLike, theta: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force.

    F = 4*H*a**(k + 3)*2F1(1/2, 2, (k + 5)/2, a**2/R**2)/(R*(k + 1)**2*(k + 3))   for a < b
    F = H*(-2*R*a**(k + 1) + a**(k + 2)*b*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2)/(sqrt(R - b)*sqrt(R +
    b)) + 2*b**2*(a**2 - b**2)**(k/2 + 1/2)/(sqrt(R - b)*sqrt(R + b)) + 2*sqrt(R**2 - b**2)*(a**2 -
    b**2)**(k/2 + 1/2) + 2*(R**2*k + R**2 + a**2)*CapMoment(k, b, R, a))/((k + 1)*(k + 2))   for b < a
    with b = R*sin(theta)
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)
    with CapMoment: J(k; b, R, a) = int_0^b s (R**2 - s**2)**(-1/2) (a**2 - s**2)**((k - 1)/2) ds, for b < a,
    b < R

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: sphere_tipped_cone.fgm.F.

    References
    ----------
    chapter 11, equation (11.51).

    Examples
    --------
    >>> from axicontact.graded.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.force(1.0, R=1.2, theta=0.45, H=1.0, k=0.25)
    >>> round(value, 6)
    0.453098
    """
    require(R=R, theta=theta, H=H, k=k)
    return elementwise(_force, a, R=R, theta=theta, H=H, k=k)


def pressure(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, theta: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
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
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact, by a rule that carries the weight of the grading. Handbook: sphere_tipped_cone.fgm.p.

    References
    ----------
    chapter 11, equation (11.53).

    Examples
    --------
    >>> from axicontact.graded.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.pressure(0.3, 1.0, R=1.2, theta=0.45, H=1.0, k=0.25)
    >>> round(value, 6)
    0.266541
    """
    require(R=R, theta=theta, H=H, k=k)
    return elementwise(_pressure, r, a, R=R, theta=theta, H=H, k=k)


def displacement(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, theta: ArrayLike, k: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*cos(pi*k/2)*Integral(t**k*(r**2 - t**2)**(-k/2 - 1/2)*(g(a) - g(t)), (t, 0, a))/pi

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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated as an integral over the
    displacement inside the contact. Handbook: sphere_tipped_cone.fgm.w.

    References
    ----------
    chapter 11, equation (11.56).

    Examples
    --------
    >>> from axicontact.graded.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.displacement(2.0, 1.0, R=1.2, theta=0.45, k=0.25)
    >>> round(value, 6)
    0.058062
    """
    require(R=R, theta=theta, k=k)
    return elementwise(_displacement, r, a, R=R, theta=theta, k=k)


def stiffness(a: ArrayLike, *, R: ArrayLike, theta: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*H*a**(k + 1)/(k + 1)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: sphere_tipped_cone.fgm.k.

    References
    ----------
    chapter 11, equation (11.46).

    Examples
    --------
    >>> from axicontact.graded.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.stiffness(1.0, R=1.2, theta=0.45, H=1.0, k=0.25)
    >>> round(value, 6)
    1.6
    """
    require(R=R, theta=theta, H=H, k=k)
    return elementwise(_stiffness, a, H=H, k=k, unused=(R, theta))


def mean_pressure(a: ArrayLike, *, R: ArrayLike, theta: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = 4*H*a**(k + 1)*2F1(1/2, 2, (k + 5)/2, a**2/R**2)/(pi*R*(k + 1)**2*(k + 3))   for a < b
    p_mean = H*(-2*R*a**(k - 1) + a**k*b*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2)/(sqrt(R - b)*sqrt(R +
    b)) + 2*b**2*(a**2 - b**2)**(k/2 + 1/2)/(a**2*sqrt(R - b)*sqrt(R + b)) + 2*sqrt(R**2 - b**2)*(a**2 -
    b**2)**(k/2 + 1/2)/a**2 + 2*(R**2*k + R**2 + a**2)*CapMoment(k, b, R, a)/a**2)/(pi*(k + 1)*(k + 2))   for
    b < a
    with b = R*sin(theta)
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)
    with CapMoment: J(k; b, R, a) = int_0^b s (R**2 - s**2)**(-1/2) (a**2 - s**2)**((k - 1)/2) ds, for b < a,
    b < R

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: sphere_tipped_cone.fgm.pm.

    Examples
    --------
    >>> from axicontact.graded.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.mean_pressure(1.0, R=1.2, theta=0.45, H=1.0, k=0.25)
    >>> round(value, 6)
    0.144225
    """
    require(R=R, theta=theta, H=H, k=k)
    return elementwise(_mean_pressure, a, R=R, theta=theta, H=H, k=k)


def radius_from_depth(d: ArrayLike, *, R: ArrayLike, theta: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a from a**2*2F1(1/2, 1, (k + 3)/2, a**2/R**2)/(R*(k + 1)) = d   for a < b
    a from a*b*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2)/(2*sqrt(R - b)*sqrt(R + b)) + a**(1 -
    k)*CapMoment(k, b, R, a) = d   for b < a
    with b = R*sin(theta)
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)
    with CapMoment: J(k; b, R, a) = int_0^b s (R**2 - s**2)**(-1/2) (a**2 - s**2)**((k - 1)/2) ds, for b < a,
    b < R

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: sphere_tipped_cone.fgm.ad.

    References
    ----------
    chapter 11, equation (11.48).

    Examples
    --------
    >>> from axicontact.graded.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.radius_from_depth(0.5168, R=1.2, theta=0.45, k=0.25)
    >>> round(value, 6)
    0.999931
    """
    require(R=R, theta=theta, k=k)
    return elementwise(_radius_from_depth, d, R=R, theta=theta, k=k)


def radius_from_force(F: ArrayLike, *, R: ArrayLike, theta: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a from 4*H*a**(k + 3)*2F1(1/2, 2, (k + 5)/2, a**2/R**2)/(R*(k + 1)**2*(k + 3)) = F   for a < b
    a from H*(-2*R*a**(k + 1) + a**(k + 2)*b*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2)/(sqrt(R - b)*sqrt(R
    + b)) + 2*b**2*(a**2 - b**2)**(k/2 + 1/2)/(sqrt(R - b)*sqrt(R + b)) + 2*sqrt(R**2 - b**2)*(a**2 -
    b**2)**(k/2 + 1/2) + 2*(R**2*k + R**2 + a**2)*CapMoment(k, b, R, a))/((k + 1)*(k + 2)) = F   for b < a
    with b = R*sin(theta)
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)
    with CapMoment: J(k; b, R, a) = int_0^b s (R**2 - s**2)**(-1/2) (a**2 - s**2)**((k - 1)/2) ds, for b < a,
    b < R

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: sphere_tipped_cone.fgm.aF.

    References
    ----------
    chapter 11, equation (11.51).

    Examples
    --------
    >>> from axicontact.graded.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.radius_from_force(0.4531, R=1.2, theta=0.45, H=1.0, k=0.25)
    >>> round(value, 6)
    1.000002
    """
    require(R=R, theta=theta, H=H, k=k)
    return elementwise(_radius_from_force, F, R=R, theta=theta, H=H, k=k)


def force_from_depth(d: ArrayLike, *, R: ArrayLike, theta: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: sphere_tipped_cone.fgm.Fd.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51).

    Examples
    --------
    >>> from axicontact.graded.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.force_from_depth(0.5168, R=1.2, theta=0.45, H=1.0, k=0.25)
    >>> round(value, 6)
    0.453025
    """
    require(R=R, theta=theta, H=H, k=k)
    return elementwise(_force_from_depth, d, R=R, theta=theta, H=H, k=k)


def depth_from_force(F: ArrayLike, *, R: ArrayLike, theta: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: sphere_tipped_cone.fgm.dF.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51).

    Examples
    --------
    >>> from axicontact.graded.normal import sphere_tipped_cone
    >>> value = sphere_tipped_cone.depth_from_force(0.4531, R=1.2, theta=0.45, H=1.0, k=0.25)
    >>> round(value, 6)
    0.516847
    """
    require(R=R, theta=theta, H=H, k=k)
    return elementwise(_depth_from_force, F, R=R, theta=theta, H=H, k=k)


def _depth_at(a: Array, root: Array, R: Array, theta: Array, k: Array) -> Array:
    b = R * np.sin(theta)
    return tipped_depth(a, root, R, b, R * np.cos(theta), k)


def _rate_at(a: Array, root: Array, R: Array, theta: Array, k: Array) -> Array:
    """Rate g'(a) of the depth."""
    b = R * np.sin(theta)
    return tipped_rate(a, root, R, b, R * np.cos(theta), k)


def _force_at(a: Array, root: Array, R: Array, theta: Array, H: Array, k: Array) -> Array:
    b = R * np.sin(theta)
    growth = tipped_force(a, root, R, b, R * np.cos(theta), k)
    return 2.0 * H / (1.0 + k) * growth


def _depth(a: Array, R: Array, theta: Array, k: Array) -> Array:
    return _depth_at(a, sine_root(a, R, theta), R, theta, k)


def _rate(a: Array, R: Array, theta: Array, k: Array) -> Array:
    return _rate_at(a, sine_root(a, R, theta), R, theta, k)


def _force(a: Array, R: Array, theta: Array, H: Array, k: Array) -> Array:
    return _force_at(a, sine_root(a, R, theta), R, theta, H, k)


def _force_rate_at(a: Array, root: Array, R: Array, theta: Array, H: Array, k: Array) -> Array:
    """Derivative of the force."""
    return punch_stiffness(a, H, k) * _rate_at(a, root, R, theta, k)


def _stiffness(a: Array, H: Array, k: Array) -> Array:
    return punch_stiffness(a, H, k)


def _mean_pressure(a: Array, R: Array, theta: Array, H: Array, k: Array) -> Array:
    return np.where(a > 0.0, _force(a, R, theta, H, k) / (np.pi * a * a), 0.0)


def _pressure(r: Array, a: Array, R: Array, theta: Array, H: Array, k: Array) -> Array:
    from ..._runtime.graded.pressure import tipped_pressure

    b = R * np.sin(theta)
    inside = np.minimum(r, a)
    growth = tipped_pressure(inside, a, R, b, R * np.cos(theta), k)
    return np.where(r < a, H / np.pi * growth, 0.0)


def _displacement(r: Array, a: Array, R: Array, theta: Array, k: Array) -> Array:
    from ..._runtime.graded.displacement import tipped_displacement

    b = R * np.sin(theta)
    return tipped_displacement(r, a, R, b, R * np.cos(theta), k)


def _radius_from_depth(d: Array, R: Array, theta: Array, k: Array) -> Array:
    from ..._runtime.graded.inverse import radius_across

    b = R * np.sin(theta)
    return radius_across(_depth_at, _rate_at, d, b, (R, theta, k), 2.0, end=R)


def _radius_from_force(F: Array, R: Array, theta: Array, H: Array, k: Array) -> Array:
    from ..._runtime.graded.inverse import radius_across

    b = R * np.sin(theta)
    return radius_across(_force_at, _force_rate_at, F, b, (R, theta, H, k), 3.0 + k, end=R)


def _force_from_depth(d: Array, R: Array, theta: Array, H: Array, k: Array) -> Array:
    a = _radius_from_depth(d, R, theta, k)
    return _force(a, R, theta, H, k) + punch_force(d - _depth(a, R, theta, k), a, H, k)


def _depth_from_force(F: Array, R: Array, theta: Array, H: Array, k: Array) -> Array:
    a = _radius_from_force(F, R, theta, H, k)
    return _depth(a, R, theta, k) + punch_depth(F - _force(a, R, theta, H, k), a, H, k)
