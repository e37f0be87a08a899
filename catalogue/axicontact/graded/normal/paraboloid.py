"""Paraboloid on a power-law graded half-space.

The tip of every smooth indenter and the parabolic approximation of the sphere: Hertz's contact.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.growth import power_depth, power_force, power_mean, power_rate
from ..._runtime.graded.punch import punch_stiffness
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


def profile(r: ArrayLike, *, R: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = r**2/(2*R)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    R : array_like
        Radius of curvature [m], R > 0.

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
    Valid for a << R. Negative or NaN field values give NaN.

    References
    ----------
    Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import paraboloid
    >>> value = paraboloid.profile(0.3, R=1.6)
    >>> round(value, 6)
    0.028125
    """
    from ...normal import paraboloid as normal

    return normal.profile(r, R=R)


def depth(a: ArrayLike, *, R: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = a**2/(R*(k + 1))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: paraboloid.fgm.d.

    References
    ----------
    chapter 11, equation (11.61); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import paraboloid
    >>> value = paraboloid.depth(1.0, R=1.6, k=0.25)
    >>> round(value, 6)
    0.5
    """
    require(R=R, k=k)
    return elementwise(_depth, a, R=R, k=k)


def force(a: ArrayLike, *, R: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force.

    F = 4*H*a**(k + 3)/(R*(k + 1)**2*(k + 3))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: paraboloid.fgm.F.

    References
    ----------
    chapter 11, equation (11.51); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import paraboloid
    >>> value = paraboloid.force(1.0, R=1.6, H=1.0, k=0.25)
    >>> round(value, 6)
    0.492308
    """
    require(R=R, H=H, k=k)
    return elementwise(_force, a, R=R, H=H, k=k)


def pressure(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = 2*H*(a**2 - r**2)**(k/2 + 1/2)/(pi*R*(k + 1)**2)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R. Negative or NaN field values give NaN. Evaluated as an integral over the growing
    contact, by a rule that carries the weight of the grading. Handbook: paraboloid.fgm.p.

    References
    ----------
    chapter 11, equation (11.53); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import paraboloid
    >>> value = paraboloid.pressure(0.3, 1.0, R=1.6, H=1.0, k=0.25)
    >>> round(value, 6)
    0.240072
    """
    require(R=R, H=H, k=k)
    return elementwise(_pressure, r, a, R=R, H=H, k=k)


def displacement(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, k: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = (a**2*IncompleteBeta(a**2/r**2, (k + 1)/2, (1 - k)/2) - r**2*IncompleteBeta(a**2/r**2, (k + 3)/2, (1 -
    k)/2))*cos(pi*k/2)/(pi*R*(k + 1))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R. Negative or NaN field values give NaN. Evaluated as an integral over the displacement
    inside the contact. Handbook: paraboloid.fgm.w.

    References
    ----------
    chapter 11, equation (11.56); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import paraboloid
    >>> value = paraboloid.displacement(2.0, 1.0, R=1.6, k=0.25)
    >>> round(value, 6)
    0.063372
    """
    require(R=R, k=k)
    return elementwise(_displacement, r, a, R=R, k=k)


def stiffness(a: ArrayLike, *, R: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*H*a**(k + 1)/(k + 1)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: paraboloid.fgm.k.

    References
    ----------
    chapter 11, equation (11.46); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import paraboloid
    >>> value = paraboloid.stiffness(1.0, R=1.6, H=1.0, k=0.25)
    >>> round(value, 6)
    1.6
    """
    require(R=R, H=H, k=k)
    return elementwise(_stiffness, a, H=H, k=k, unused=(R,))


def mean_pressure(a: ArrayLike, *, R: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = 4*H*a**(k + 1)/(pi*R*(k + 1)**2*(k + 3))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: paraboloid.fgm.pm.

    References
    ----------
    Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import paraboloid
    >>> value = paraboloid.mean_pressure(1.0, R=1.6, H=1.0, k=0.25)
    >>> round(value, 6)
    0.156706
    """
    require(R=R, H=H, k=k)
    return elementwise(_mean_pressure, a, R=R, H=H, k=k)


def radius_from_depth(d: ArrayLike, *, R: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a = sqrt(R)*sqrt(d)*sqrt(k + 1)

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: paraboloid.fgm.ad.

    References
    ----------
    chapter 11, equation (11.48); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import paraboloid
    >>> value = paraboloid.radius_from_depth(0.5, R=1.6, k=0.25)
    >>> round(value, 6)
    1.0
    """
    require(R=R, k=k)
    return elementwise(_radius_from_depth, d, R=R, k=k)


def radius_from_force(F: ArrayLike, *, R: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a = (F*R*(k + 1)**2*(k + 3)/(4*H))**(1/(k + 3))

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: paraboloid.fgm.aF.

    References
    ----------
    chapter 11, equation (11.51); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import paraboloid
    >>> value = paraboloid.radius_from_force(0.4923, R=1.6, H=1.0, k=0.25)
    >>> round(value, 6)
    0.999995
    """
    require(R=R, H=H, k=k)
    return elementwise(_radius_from_force, F, R=R, H=H, k=k)


def force_from_depth(d: ArrayLike, *, R: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = 4*H*(sqrt(R)*sqrt(d)*sqrt(k + 1))**(k + 3)/(R*(k + 1)**2*(k + 3))

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: paraboloid.fgm.Fd.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import paraboloid
    >>> value = paraboloid.force_from_depth(0.5, R=1.6, H=1.0, k=0.25)
    >>> round(value, 6)
    0.492308
    """
    require(R=R, H=H, k=k)
    return elementwise(_force_from_depth, d, R=R, H=H, k=k)


def depth_from_force(F: ArrayLike, *, R: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = (F**2*R**2*(k + 1)**4*(k + 3)**2/(16*H**2))**(1/(k + 3))/(R*(k + 1))

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a << R. Negative or NaN field values give NaN. Handbook: paraboloid.fgm.dF.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Hertz 1882; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import paraboloid
    >>> value = paraboloid.depth_from_force(0.4923, R=1.6, H=1.0, k=0.25)
    >>> round(value, 6)
    0.499995
    """
    require(R=R, H=H, k=k)
    return elementwise(_depth_from_force, F, R=R, H=H, k=k)


def _depth(a: Array, R: Array, k: Array) -> Array:
    return power_depth(a, 2.0, k) / (2 * R)


def _rate(a: Array, R: Array, k: Array) -> Array:
    """Rate g'(a) of the depth."""
    return power_rate(a, 2.0, k) / (2 * R)


def _force(a: Array, R: Array, H: Array, k: Array) -> Array:
    growth = power_force(a, 2.0, k) / (2 * R)
    return 2.0 * H / (1.0 + k) * growth


def _stiffness(a: Array, H: Array, k: Array) -> Array:
    return punch_stiffness(a, H, k)


def _mean_pressure(a: Array, R: Array, H: Array, k: Array) -> Array:
    growth = power_mean(a, 2.0, k) / (2 * R)
    return 2.0 * H / (1.0 + k) / np.pi * growth


def _pressure(r: Array, a: Array, R: Array, H: Array, k: Array) -> Array:
    from ..._runtime.graded.pressure import power_pressure

    inside = np.minimum(r, a)
    growth = power_pressure(inside, a, 2.0, k) / (2 * R)
    return np.where(r < a, H / np.pi * growth, 0.0)


def _displacement(r: Array, a: Array, R: Array, k: Array) -> Array:
    from ..._runtime.graded.displacement import power_displacement

    return power_displacement(r, a, 2.0, k) / (2 * R)


def _radius_from_depth(d: Array, R: Array, k: Array) -> Array:
    return np.sqrt(d / _depth(np.ones_like(d), R, k))


def _radius_from_force(F: Array, R: Array, H: Array, k: Array) -> Array:
    return (F / _force(np.ones_like(F), R, H, k)) ** (1.0 / (3.0 + k))


def _force_from_depth(d: Array, R: Array, H: Array, k: Array) -> Array:
    stiffness = punch_stiffness(_radius_from_depth(d, R, k), H, k)
    return np.where((d > 0.0) & np.isfinite(d), d * (stiffness * (2.0 / (2.0 + (1.0 + k)))), d)


def _depth_from_force(F: Array, R: Array, H: Array, k: Array) -> Array:
    stiffness = punch_stiffness(_radius_from_force(F, R, H, k), H, k)
    return np.where((F > 0.0) & np.isfinite(F), F / (stiffness * (2.0 / (2.0 + (1.0 + k)))), F)
