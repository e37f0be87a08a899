"""Hyperboloid of revolution on a power-law graded half-space.

A cone with a smoothly rounded tip: tip radius b/tan(theta), asymptotic inclination theta.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.growth import hyperboloid_depth, hyperboloid_force, hyperboloid_rate
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


def profile(r: ArrayLike, *, theta: ArrayLike, b: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = (-b + sqrt(b**2 + r**2))*tan(theta)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Length of the rounded tip, whose radius of curvature is b/tan(theta) [m], b > 0.

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

    References
    ----------
    Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import hyperboloid
    >>> value = hyperboloid.profile(0.3, theta=0.42, b=0.4)
    >>> round(value, 6)
    0.044657
    """
    from ...normal import hyperboloid as normal

    return normal.profile(r, theta=theta, b=b)


def depth(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = a**2*tan(theta)*2F1(1/2, 1, (k + 3)/2, -a**2/b**2)/(b*(k + 1))
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: hyperboloid.fgm.d.

    References
    ----------
    chapter 11, equation (11.61); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import hyperboloid
    >>> value = hyperboloid.depth(1.0, theta=0.42, b=0.4, k=0.25)
    >>> round(value, 6)
    0.44209
    """
    require(theta=theta, b=b, k=k)
    return elementwise(_depth, a, theta=theta, b=b, k=k)


def force(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force.

    F = 4*H*a**(k + 3)*tan(theta)*2F1(1/2, 2, (k + 5)/2, -a**2/b**2)/(b*(k + 1)**2*(k + 3))
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: hyperboloid.fgm.F.

    References
    ----------
    chapter 11, equation (11.51); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import hyperboloid
    >>> value = hyperboloid.force(1.0, theta=0.42, b=0.4, H=1.0, k=0.25)
    >>> round(value, 6)
    0.378525
    """
    require(theta=theta, b=b, H=H, k=k)
    return elementwise(_force, a, theta=theta, b=b, H=H, k=k)


def pressure(r: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = H*Integral((2*sqrt(r**2 + u**(2/(k + 1)))*tan(theta)*2F1(1/2, 1, (k + 3)/2, -(r**2 +
    u**(2/(k + 1)))/b**2)/(b*(k + 1)) - 2*(r**2 + u**(2/(k + 1)))**(3/2)*tan(theta)*2F1(3/2, 2, (k
    + 3)/2 + 1, -(r**2 + u**(2/(k + 1)))/b**2)/(b**3*(k + 1)*(k + 3)))/sqrt(r**2 + u**(2/(k + 1))), (u, 0,
    (a**2 - r**2)**(k/2 + 1/2)))/(pi*(k + 1))
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    growing contact, by a rule that carries the weight of the grading. Handbook: hyperboloid.fgm.p.

    References
    ----------
    chapter 11, equation (11.53); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import hyperboloid
    >>> value = hyperboloid.pressure(0.3, 1.0, theta=0.42, b=0.4, H=1.0, k=0.25)
    >>> round(value, 6)
    0.220053
    """
    require(theta=theta, b=b, H=H, k=k)
    return elementwise(_pressure, r, a, theta=theta, b=b, H=H, k=k)


def displacement(r: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, k: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*cos(pi*k/2)*Integral((a**2*tan(theta)*2F1(1/2, 1, (k + 3)/2, -a**2/b**2)/(b*(k + 1)) -
    r**2*sin(psi)**2*tan(theta)*2F1(1/2, 1, (k + 3)/2, -r**2*sin(psi)**2/b**2)/(b*(k +
    1)))*tan(psi)**k, (psi, 0, asin(a/r)))/pi
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    displacement inside the contact. Handbook: hyperboloid.fgm.w.

    References
    ----------
    chapter 11, equation (11.56); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import hyperboloid
    >>> value = hyperboloid.displacement(2.0, 1.0, theta=0.42, b=0.4, k=0.25)
    >>> round(value, 6)
    0.04853
    """
    require(theta=theta, b=b, k=k)
    return elementwise(_displacement, r, a, theta=theta, b=b, k=k)


def stiffness(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*H*a**(k + 1)/(k + 1)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: hyperboloid.fgm.k.

    References
    ----------
    chapter 11, equation (11.46); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import hyperboloid
    >>> value = hyperboloid.stiffness(1.0, theta=0.42, b=0.4, H=1.0, k=0.25)
    >>> round(value, 6)
    1.6
    """
    require(theta=theta, b=b, H=H, k=k)
    return elementwise(_stiffness, a, H=H, k=k, unused=(theta, b))


def mean_pressure(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = 4*H*a**(k + 1)*tan(theta)*2F1(1/2, 2, (k + 5)/2, -a**2/b**2)/(pi*b*(k + 1)**2*(k + 3))
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    Valid for tan(theta) << 1. Negative or NaN field values give NaN. Handbook: hyperboloid.fgm.pm.

    References
    ----------
    Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import hyperboloid
    >>> value = hyperboloid.mean_pressure(1.0, theta=0.42, b=0.4, H=1.0, k=0.25)
    >>> round(value, 6)
    0.120488
    """
    require(theta=theta, b=b, H=H, k=k)
    return elementwise(_mean_pressure, a, theta=theta, b=b, H=H, k=k)


def radius_from_depth(d: ArrayLike, *, theta: ArrayLike, b: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a from a**2*tan(theta)*2F1(1/2, 1, (k + 3)/2, -a**2/b**2)/(b*(k + 1)) = d
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    iteration. Handbook: hyperboloid.fgm.ad.

    References
    ----------
    chapter 11, equation (11.48); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import hyperboloid
    >>> value = hyperboloid.radius_from_depth(0.4421, theta=0.42, b=0.4, k=0.25)
    >>> round(value, 6)
    1.000018
    """
    require(theta=theta, b=b, k=k)
    return elementwise(_radius_from_depth, d, theta=theta, b=b, k=k)


def radius_from_force(F: ArrayLike, *, theta: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a from 4*H*a**(k + 3)*tan(theta)*2F1(1/2, 2, (k + 5)/2, -a**2/b**2)/(b*(k + 1)**2*(k + 3)) = F
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    F : array_like
        Normal force [N].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    iteration. Handbook: hyperboloid.fgm.aF.

    References
    ----------
    chapter 11, equation (11.51); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import hyperboloid
    >>> value = hyperboloid.radius_from_force(0.3785, theta=0.42, b=0.4, H=1.0, k=0.25)
    >>> round(value, 6)
    0.999973
    """
    require(theta=theta, b=b, H=H, k=k)
    return elementwise(_radius_from_force, F, theta=theta, b=b, H=H, k=k)


def force_from_depth(d: ArrayLike, *, theta: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = F(a(d)), through the contact radius.

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    iteration. Handbook: hyperboloid.fgm.Fd.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import hyperboloid
    >>> value = hyperboloid.force_from_depth(0.4421, theta=0.42, b=0.4, H=1.0, k=0.25)
    >>> round(value, 6)
    0.378542
    """
    require(theta=theta, b=b, H=H, k=k)
    return elementwise(_force_from_depth, d, theta=theta, b=b, H=H, k=k)


def depth_from_force(F: ArrayLike, *, theta: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = d(a(F)), through the contact radius.

    Parameters
    ----------
    F : array_like
        Normal force [N].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    iteration. Handbook: hyperboloid.fgm.dF.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import hyperboloid
    >>> value = hyperboloid.depth_from_force(0.3785, theta=0.42, b=0.4, H=1.0, k=0.25)
    >>> round(value, 6)
    0.442074
    """
    require(theta=theta, b=b, H=H, k=k)
    return elementwise(_depth_from_force, F, theta=theta, b=b, H=H, k=k)


def _depth(a: Array, theta: Array, b: Array, k: Array) -> Array:
    return hyperboloid_depth(a, b, k) * np.tan(theta)


def _rate(a: Array, theta: Array, b: Array, k: Array) -> Array:
    """Rate g'(a) of the depth."""
    return hyperboloid_rate(a, b, k) * np.tan(theta)


def _force(a: Array, theta: Array, b: Array, H: Array, k: Array) -> Array:
    growth = hyperboloid_force(a, b, k) * np.tan(theta)
    return 2.0 * H / (1.0 + k) * growth


def _force_rate(a: Array, theta: Array, b: Array, H: Array, k: Array) -> Array:
    """Derivative of the force."""
    return punch_stiffness(a, H, k) * _rate(a, theta, b, k)


def _stiffness(a: Array, H: Array, k: Array) -> Array:
    return punch_stiffness(a, H, k)


def _mean_pressure(a: Array, theta: Array, b: Array, H: Array, k: Array) -> Array:
    return np.where(a > 0.0, _force(a, theta, b, H, k) / (np.pi * a * a), 0.0)


def _pressure(r: Array, a: Array, theta: Array, b: Array, H: Array, k: Array) -> Array:
    from ..._runtime.graded.pressure import hyperboloid_pressure

    inside = np.minimum(r, a)
    growth = hyperboloid_pressure(inside, a, b, k) * np.tan(theta)
    return np.where(r < a, H / np.pi * growth, 0.0)


def _displacement(r: Array, a: Array, theta: Array, b: Array, k: Array) -> Array:
    from ..._runtime.graded.displacement import hyperboloid_displacement

    return hyperboloid_displacement(r, a, b, k) * np.tan(theta)


def _radius_from_depth(d: Array, theta: Array, b: Array, k: Array) -> Array:
    from ..._runtime.graded.inverse import radius_to

    return radius_to(_depth, _rate, d, 1.5 * b, (theta, b, k))


def _radius_from_force(F: Array, theta: Array, b: Array, H: Array, k: Array) -> Array:
    from ..._runtime.graded.inverse import radius_to

    return radius_to(_force, _force_rate, F, 1.5 * b, (theta, b, H, k))


def _force_from_depth(d: Array, theta: Array, b: Array, H: Array, k: Array) -> Array:
    a = _radius_from_depth(d, theta, b, k)
    return _force(a, theta, b, H, k) + punch_force(d - _depth(a, theta, b, k), a, H, k)


def _depth_from_force(F: Array, theta: Array, b: Array, H: Array, k: Array) -> Array:
    a = _radius_from_force(F, theta, b, H, k)
    return _depth(a, theta, b, k) + punch_depth(F - _force(a, theta, b, H, k), a, H, k)
