"""Truncated cone on a power-law graded half-space.

Flat face of radius b with a conical flank: a worn or blunted cone. The contact radius starts at b.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.breaks import flank_depth, flank_force, flank_rate
from ..._runtime.graded.punch import punch_depth, punch_force, punch_stiffness
from ..._runtime.integrals import difference_root
from ..._runtime.interface import Array, Result, elementwise, require, require_reach

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

    f = 0   for 0 < r < b
    f = (-b + r)*tan(theta)   for b < r

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
    b : array_like
        Radius of the flat face [m], b > 0.

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
    Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.normal import truncated_cone
    >>> value = truncated_cone.profile(0.3, theta=0.42, b=0.5)
    >>> round(value, 6)
    0.0
    """
    from ...normal import truncated_cone as normal

    return normal.profile(r, theta=theta, b=b)


def depth(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = a*tan(theta)*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2)/2
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

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
    Valid for tan(theta) << 1. Negative or NaN field values, and radii below b among larger ones, give NaN.
    Handbook: truncated_cone.fgm.d.

    References
    ----------
    chapter 11, equation (11.61); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.normal import truncated_cone
    >>> value = truncated_cone.depth(1.0, theta=0.42, b=0.5, k=0.25)
    >>> round(value, 6)
    0.371747
    """
    require(theta=theta, b=b, k=k)
    require_reach(a, b, "graded.normal.flat_punch")
    return elementwise(_depth, a, theta=theta, b=b, k=k)


def force(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force.

    F = H*(a**(k + 2)*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2) + 2*b*(a**2 - b**2)**(k/2 +
    1/2))*tan(theta)/((k + 1)*(k + 2))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

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
    Valid for tan(theta) << 1. Negative or NaN field values, and radii below b among larger ones, give NaN.
    Handbook: truncated_cone.fgm.F.

    References
    ----------
    chapter 11, equation (11.51); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.normal import truncated_cone
    >>> value = truncated_cone.force(1.0, theta=0.42, b=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.397005
    """
    require(theta=theta, b=b, H=H, k=k)
    require_reach(a, b, "graded.normal.flat_punch")
    return elementwise(_force, a, theta=theta, b=b, H=H, k=k)


def pressure(r: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = H*Integral((b*(-b**2/(r**2 + u**(2/(k + 1))) + 1)**((k + 1)/2 - 1)*tan(theta)/sqrt(r**2 + u**(2/(k +
    1))) + tan(theta)*IncompleteBeta(-b**2/(r**2 + u**(2/(k + 1))) + 1, (k + 1)/2, 1/2)/2)/sqrt(r**2 +
    u**(2/(k + 1))), (u, (b**2 - r**2)**(k/2 + 1/2), (a**2 - r**2)**(k/2 + 1/2)))/(pi*(k + 1))   for r < b
    p = H*Integral((b*(-b**2/(r**2 + u**(2/(k + 1))) + 1)**((k + 1)/2 - 1)*tan(theta)/sqrt(r**2 + u**(2/(k +
    1))) + tan(theta)*IncompleteBeta(-b**2/(r**2 + u**(2/(k + 1))) + 1, (k + 1)/2, 1/2)/2)/sqrt(r**2 +
    u**(2/(k + 1))), (u, 0, (a**2 - r**2)**(k/2 + 1/2)))/(pi*(k + 1))   for b < r
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

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
    Valid for tan(theta) << 1. Negative or NaN field values, and radii below b among larger ones, give NaN.
    Evaluated as an integral over the growing contact, by a rule that carries the weight of the grading.
    Handbook: truncated_cone.fgm.p.

    References
    ----------
    chapter 11, equation (11.53); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.normal import truncated_cone
    >>> value = truncated_cone.pressure(0.3, 1.0, theta=0.42, b=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.171195
    """
    require(theta=theta, b=b, H=H, k=k)
    require_reach(a, b, "graded.normal.flat_punch")
    return elementwise(_pressure, r, a, theta=theta, b=b, H=H, k=k)


def displacement(r: ArrayLike, a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, k: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = a*cos(pi*k/2)*tan(theta)*IncompleteBeta(b**2/r**2, (k + 1)/2, (1 - k)/2)*IncompleteBeta(1 - b**2/a**2,
    (k + 1)/2, 1/2)/(2*pi) + 2*cos(pi*k/2)*Integral((a*tan(theta)*IncompleteBeta(1 - b**2/a**2, (k + 1)/2,
    1/2)/2 - r*sin(psi)*tan(theta)*IncompleteBeta(-b**2/(r**2*sin(psi)**2) + 1, (k + 1)/2,
    1/2)/2)*tan(psi)**k, (psi, asin(b/r), asin(a/r)))/pi
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

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
    Valid for tan(theta) << 1. Negative or NaN field values, and radii below b among larger ones, give NaN.
    Evaluated as an integral over the displacement inside the contact. Handbook: truncated_cone.fgm.w.

    References
    ----------
    chapter 11, equation (11.56); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.normal import truncated_cone
    >>> value = truncated_cone.displacement(2.0, 1.0, theta=0.42, b=0.5, k=0.25)
    >>> round(value, 6)
    0.051032
    """
    require(theta=theta, b=b, k=k)
    require_reach(a, b, "graded.normal.flat_punch")
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
    Valid for tan(theta) << 1. Negative or NaN field values, and radii below b among larger ones, give NaN.
    Handbook: truncated_cone.fgm.k.

    References
    ----------
    chapter 11, equation (11.46); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.normal import truncated_cone
    >>> value = truncated_cone.stiffness(1.0, theta=0.42, b=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    1.6
    """
    require(theta=theta, b=b, H=H, k=k)
    require_reach(a, b, "graded.normal.flat_punch")
    return elementwise(_stiffness, a, H=H, k=k, unused=(theta, b))


def mean_pressure(a: ArrayLike, *, theta: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = H*(a**k*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2) + 2*b*(a**2 - b**2)**(k/2 +
    1/2)/a**2)*tan(theta)/(pi*(k + 1)*(k + 2))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

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
    Valid for tan(theta) << 1. Negative or NaN field values, and radii below b among larger ones, give NaN.
    Handbook: truncated_cone.fgm.pm.

    References
    ----------
    Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.normal import truncated_cone
    >>> value = truncated_cone.mean_pressure(1.0, theta=0.42, b=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.126371
    """
    require(theta=theta, b=b, H=H, k=k)
    require_reach(a, b, "graded.normal.flat_punch")
    return elementwise(_mean_pressure, a, theta=theta, b=b, H=H, k=k)


def radius_from_depth(d: ArrayLike, *, theta: ArrayLike, b: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a from a*tan(theta)*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2)/2 = d
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

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
    iteration. Handbook: truncated_cone.fgm.ad.

    References
    ----------
    chapter 11, equation (11.48); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.normal import truncated_cone
    >>> value = truncated_cone.radius_from_depth(0.3717, theta=0.42, b=0.5, k=0.25)
    >>> round(value, 6)
    0.999925
    """
    require(theta=theta, b=b, k=k)
    return elementwise(_radius_from_depth, d, theta=theta, b=b, k=k)


def radius_from_force(F: ArrayLike, *, theta: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a from H*(a**(k + 2)*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2) + 2*b*(a**2 - b**2)**(k/2 +
    1/2))*tan(theta)/((k + 1)*(k + 2)) = F
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

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
    iteration. Handbook: truncated_cone.fgm.aF.

    References
    ----------
    chapter 11, equation (11.51); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.normal import truncated_cone
    >>> value = truncated_cone.radius_from_force(0.397, theta=0.42, b=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.999995
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
    iteration. Handbook: truncated_cone.fgm.Fd.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.normal import truncated_cone
    >>> value = truncated_cone.force_from_depth(0.3717, theta=0.42, b=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.39693
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
    iteration. Handbook: truncated_cone.fgm.dF.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.normal import truncated_cone
    >>> value = truncated_cone.depth_from_force(0.397, theta=0.42, b=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.371744
    """
    require(theta=theta, b=b, H=H, k=k)
    return elementwise(_depth_from_force, F, theta=theta, b=b, H=H, k=k)


def _depth_at(a: Array, root: Array, theta: Array, b: Array, k: Array) -> Array:
    return flank_depth(a, root, b, k) * np.tan(theta)


def _rate_at(a: Array, root: Array, theta: Array, b: Array, k: Array) -> Array:
    """Rate g'(a) of the depth."""
    return flank_rate(a, root, b, k) * np.tan(theta)


def _force_at(a: Array, root: Array, theta: Array, b: Array, H: Array, k: Array) -> Array:
    growth = flank_force(a, root, b, k) * np.tan(theta)
    return 2.0 * H / (1.0 + k) * growth


def _depth(a: Array, theta: Array, b: Array, k: Array) -> Array:
    return np.where(a >= b, _depth_at(a, difference_root(a, b), theta, b, k), np.nan)


def _rate(a: Array, theta: Array, b: Array, k: Array) -> Array:
    return np.where(a >= b, _rate_at(a, difference_root(a, b), theta, b, k), np.nan)


def _force(a: Array, theta: Array, b: Array, H: Array, k: Array) -> Array:
    return np.where(a >= b, _force_at(a, difference_root(a, b), theta, b, H, k), np.nan)


def _force_rate_at(a: Array, root: Array, theta: Array, b: Array, H: Array, k: Array) -> Array:
    """Derivative of the force."""
    return punch_stiffness(a, H, k) * _rate_at(a, root, theta, b, k)


def _stiffness(a: Array, H: Array, k: Array) -> Array:
    return punch_stiffness(a, H, k)


def _mean_pressure(a: Array, theta: Array, b: Array, H: Array, k: Array) -> Array:
    return _force(a, theta, b, H, k) / (np.pi * a * a)


def _pressure(r: Array, a: Array, theta: Array, b: Array, H: Array, k: Array) -> Array:
    from ..._runtime.graded.pressure import flank_pressure

    inside = np.minimum(r, a)
    growth = flank_pressure(inside, a, b, k) * np.tan(theta)
    return np.where(a >= b, np.where(r < a, H / np.pi * growth, 0.0), np.nan)


def _displacement(r: Array, a: Array, theta: Array, b: Array, k: Array) -> Array:
    from ..._runtime.graded.displacement import flank_displacement

    return flank_displacement(r, a, b, k) * np.tan(theta)


def _contact_from_depth(d: Array, theta: Array, b: Array, k: Array) -> tuple[Array, Array]:
    """Contact radius a and its root sqrt(a**2 - b**2)."""
    from ..._runtime.graded.inverse import contact_beyond

    return contact_beyond(_depth_at, _rate_at, d, b, (theta, b, k), (1.0 + k, 1.0))


def _radius_from_depth(d: Array, theta: Array, b: Array, k: Array) -> Array:
    return _contact_from_depth(d, theta, b, k)[0]


def _contact_from_force(F: Array, theta: Array, b: Array, H: Array, k: Array) -> tuple[Array, Array]:
    """Contact radius a and its root sqrt(a**2 - b**2)."""
    from ..._runtime.graded.inverse import contact_beyond

    return contact_beyond(_force_at, _force_rate_at, F, b, (theta, b, H, k), (1.0 + k, 2.0 + k))


def _radius_from_force(F: Array, theta: Array, b: Array, H: Array, k: Array) -> Array:
    return _contact_from_force(F, theta, b, H, k)[0]


def _force_from_depth(d: Array, theta: Array, b: Array, H: Array, k: Array) -> Array:
    a, root = _contact_from_depth(d, theta, b, k)
    return _force_at(a, root, theta, b, H, k) + punch_force(d - _depth_at(a, root, theta, b, k), a, H, k)


def _depth_from_force(F: Array, theta: Array, b: Array, H: Array, k: Array) -> Array:
    a, root = _contact_from_force(F, theta, b, H, k)
    return _depth_at(a, root, theta, b, k) + punch_depth(F - _force_at(a, root, theta, b, H, k), a, H, k)
