"""Paraboloid with a flatter cap on a power-law graded half-space.

Radius of curvature R1 up to r = b, the smaller R2 beyond: a worn sphere of finite cap curvature.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.breaks import rim_depth, rim_force, rim_rate
from ..._runtime.graded.growth import power_depth, power_force, power_rate
from ..._runtime.graded.punch import punch_depth, punch_force, punch_stiffness
from ..._runtime.integrals import difference_root
from ..._runtime.interface import Array, Result, elementwise

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


def profile(r: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = r**2/(2*R1)   for 0 < r < b
    f = (-b**2 + r**2)/(2*R2) + b**2/(2*R1)   for b < r

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius of the inner part [m], b > 0.

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
    Valid for a << R2. Negative or NaN field values give NaN.

    References
    ----------
    Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.graded.normal import capped_paraboloid
    >>> value = capped_paraboloid.profile(0.3, R1=4.0, R2=1.0, b=0.5)
    >>> round(value, 6)
    0.01125
    """
    from ...normal import capped_paraboloid as normal

    return normal.profile(r, R1=R1, R2=R2, b=b)


def depth(a: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = a**2/(R1*(k + 1))   for a < b
    d = (a**2 + a**(1 - k)*(R1 - R2)*(a**2 - b**2)**(k/2 + 1/2)/R2)/(R1*(k + 1))   for b < a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
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
    Valid for a << R2. Negative or NaN field values give NaN. Handbook: capped_paraboloid.fgm.d.

    References
    ----------
    chapter 11, equation (11.61); Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.graded.normal import capped_paraboloid
    >>> value = capped_paraboloid.depth(1.0, R1=4.0, R2=1.0, b=0.5, k=0.25)
    >>> round(value, 6)
    0.701262
    """
    _check(R1=R1, R2=R2, b=b, k=k)
    return elementwise(_depth, a, R1=R1, R2=R2, b=b, k=k)


def force(a: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force.

    F = 4*H*a**(k + 3)/(R1*(k + 1)**2*(k + 3))   for a < b
    F = 2*H*(2*a**(k + 3) + (R1 - R2)*(a**2 - b**2)**(k/2 + 1/2)*(2*a**2 + b**2*k + b**2)/R2)/(R1*(k +
    1)**2*(k + 3))   for b < a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
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
    Valid for a << R2. Negative or NaN field values give NaN. Handbook: capped_paraboloid.fgm.F.

    References
    ----------
    chapter 11, equation (11.51); Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.graded.normal import capped_paraboloid
    >>> value = capped_paraboloid.force(1.0, R1=4.0, R2=1.0, b=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.76759
    """
    _check(R1=R1, R2=R2, b=b, H=H, k=k)
    return elementwise(_force, a, R1=R1, R2=R2, b=b, H=H, k=k)


def pressure(
    r: ArrayLike, a: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike
) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = H*Integral((-r**2 + t**2)**(k/2 - 1/2)*Derivative(g(t), t), (t, r, a))/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
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
    Valid for a << R2. Negative or NaN field values give NaN. Evaluated as an integral over the growing
    contact, by a rule that carries the weight of the grading. Handbook: capped_paraboloid.fgm.p.

    References
    ----------
    chapter 11, equation (11.53); Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.graded.normal import capped_paraboloid
    >>> value = capped_paraboloid.pressure(0.3, 1.0, R1=4.0, R2=1.0, b=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.315356
    """
    _check(R1=R1, R2=R2, b=b, H=H, k=k)
    return elementwise(_pressure, r, a, R1=R1, R2=R2, b=b, H=H, k=k)


def displacement(r: ArrayLike, a: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, k: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*cos(pi*k/2)*Integral(t**k*(r**2 - t**2)**(-k/2 - 1/2)*(g(a) - g(t)), (t, 0, a))/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
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
    Valid for a << R2. Negative or NaN field values give NaN. Evaluated as an integral over the displacement
    inside the contact. Handbook: capped_paraboloid.fgm.w.

    References
    ----------
    chapter 11, equation (11.56); Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.graded.normal import capped_paraboloid
    >>> value = capped_paraboloid.displacement(2.0, 1.0, R1=4.0, R2=1.0, b=0.5, k=0.25)
    >>> round(value, 6)
    0.098966
    """
    _check(R1=R1, R2=R2, b=b, k=k)
    return elementwise(_displacement, r, a, R1=R1, R2=R2, b=b, k=k)


def stiffness(a: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*H*a**(k + 1)/(k + 1)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
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
    Valid for a << R2. Negative or NaN field values give NaN. Handbook: capped_paraboloid.fgm.k.

    References
    ----------
    chapter 11, equation (11.46); Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.graded.normal import capped_paraboloid
    >>> value = capped_paraboloid.stiffness(1.0, R1=4.0, R2=1.0, b=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    1.6
    """
    _check(R1=R1, R2=R2, b=b, H=H, k=k)
    return elementwise(_stiffness, a, H=H, k=k, unused=(R1, R2, b))


def mean_pressure(a: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = 4*H*a**(k + 1)/(pi*R1*(k + 1)**2*(k + 3))   for a < b
    p_mean = 2*H*(2*a**(k + 1) + (R1 - R2)*(a**2 - b**2)**(k/2 + 1/2)*(2*a**2 + b**2*k +
    b**2)/(R2*a**2))/(pi*R1*(k + 1)**2*(k + 3))   for b < a

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
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
    Valid for a << R2. Negative or NaN field values give NaN. Handbook: capped_paraboloid.fgm.pm.

    References
    ----------
    Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.graded.normal import capped_paraboloid
    >>> value = capped_paraboloid.mean_pressure(1.0, R1=4.0, R2=1.0, b=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.244332
    """
    _check(R1=R1, R2=R2, b=b, H=H, k=k)
    return elementwise(_mean_pressure, a, R1=R1, R2=R2, b=b, H=H, k=k)


def radius_from_depth(d: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a from a**2/(R1*(k + 1)) = d   for a < b
    a from (a**2 + a**(1 - k)*(R1 - R2)*(a**2 - b**2)**(k/2 + 1/2)/R2)/(R1*(k + 1)) = d   for b < a

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
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
    Valid for a << R2. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton iteration.
    Handbook: capped_paraboloid.fgm.ad.

    References
    ----------
    chapter 11, equation (11.48); Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.graded.normal import capped_paraboloid
    >>> value = capped_paraboloid.radius_from_depth(0.7013, R1=4.0, R2=1.0, b=0.5, k=0.25)
    >>> round(value, 6)
    1.000024
    """
    _check(R1=R1, R2=R2, b=b, k=k)
    return elementwise(_radius_from_depth, d, R1=R1, R2=R2, b=b, k=k)


def radius_from_force(
    F: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike
) -> Result:
    """Contact radius under the normal force F.

    a from 4*H*a**(k + 3)/(R1*(k + 1)**2*(k + 3)) = F   for a < b
    a from 2*H*(2*a**(k + 3) + (R1 - R2)*(a**2 - b**2)**(k/2 + 1/2)*(2*a**2 + b**2*k + b**2)/R2)/(R1*(k +
    1)**2*(k + 3)) = F   for b < a

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
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
    Valid for a << R2. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton iteration.
    Handbook: capped_paraboloid.fgm.aF.

    References
    ----------
    chapter 11, equation (11.51); Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.graded.normal import capped_paraboloid
    >>> value = capped_paraboloid.radius_from_force(0.7676, R1=4.0, R2=1.0, b=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    1.000004
    """
    _check(R1=R1, R2=R2, b=b, H=H, k=k)
    return elementwise(_radius_from_force, F, R1=R1, R2=R2, b=b, H=H, k=k)


def force_from_depth(d: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = F(a(d)), through the contact radius.

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
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
    Valid for a << R2. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton iteration.
    Handbook: capped_paraboloid.fgm.Fd.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.graded.normal import capped_paraboloid
    >>> value = capped_paraboloid.force_from_depth(0.7013, R1=4.0, R2=1.0, b=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.767652
    """
    _check(R1=R1, R2=R2, b=b, H=H, k=k)
    return elementwise(_force_from_depth, d, R1=R1, R2=R2, b=b, H=H, k=k)


def depth_from_force(F: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = d(a(F)), through the contact radius.

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
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
    Valid for a << R2. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton iteration.
    Handbook: capped_paraboloid.fgm.dF.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Maugis & Barquins 1983.

    Examples
    --------
    >>> from axicontact.graded.normal import capped_paraboloid
    >>> value = capped_paraboloid.depth_from_force(0.7676, R1=4.0, R2=1.0, b=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.701268
    """
    _check(R1=R1, R2=R2, b=b, H=H, k=k)
    return elementwise(_depth_from_force, F, R1=R1, R2=R2, b=b, H=H, k=k)


def _depth_at(a: Array, root: Array, R1: Array, R2: Array, b: Array, k: Array) -> Array:
    return power_depth(a, 2.0, k) / (2 * R1) + rim_depth(a, root, b, k) * (R1 - R2) / (R1 * R2)


def _rate_at(a: Array, root: Array, R1: Array, R2: Array, b: Array, k: Array) -> Array:
    """Rate g'(a) of the depth."""
    return power_rate(a, 2.0, k) / (2 * R1) + rim_rate(a, root, b, k) * (R1 - R2) / (R1 * R2)


def _force_at(a: Array, root: Array, R1: Array, R2: Array, b: Array, H: Array, k: Array) -> Array:
    growth = power_force(a, 2.0, k) / (2 * R1) + rim_force(a, root, b, k) * (R1 - R2) / (R1 * R2)
    return 2.0 * H / (1.0 + k) * growth


def _depth(a: Array, R1: Array, R2: Array, b: Array, k: Array) -> Array:
    return _depth_at(a, difference_root(a, b), R1, R2, b, k)


def _rate(a: Array, R1: Array, R2: Array, b: Array, k: Array) -> Array:
    return _rate_at(a, difference_root(a, b), R1, R2, b, k)


def _force(a: Array, R1: Array, R2: Array, b: Array, H: Array, k: Array) -> Array:
    return _force_at(a, difference_root(a, b), R1, R2, b, H, k)


def _force_rate_at(a: Array, root: Array, R1: Array, R2: Array, b: Array, H: Array, k: Array) -> Array:
    """Derivative of the force."""
    return punch_stiffness(a, H, k) * _rate_at(a, root, R1, R2, b, k)


def _stiffness(a: Array, H: Array, k: Array) -> Array:
    return punch_stiffness(a, H, k)


def _mean_pressure(a: Array, R1: Array, R2: Array, b: Array, H: Array, k: Array) -> Array:
    return np.where(a > 0.0, _force(a, R1, R2, b, H, k) / (np.pi * a * a), 0.0)


def _pressure(r: Array, a: Array, R1: Array, R2: Array, b: Array, H: Array, k: Array) -> Array:
    from ..._runtime.graded.pressure import power_pressure, rim_pressure

    inside = np.minimum(r, a)
    growth = power_pressure(inside, a, 2.0, k) / (2 * R1) + rim_pressure(inside, a, b, k) * (R1 - R2) / (R1 * R2)
    return np.where(r < a, H / np.pi * growth, 0.0)


def _displacement(r: Array, a: Array, R1: Array, R2: Array, b: Array, k: Array) -> Array:
    from ..._runtime.graded.displacement import power_displacement, rim_displacement

    return power_displacement(r, a, 2.0, k) / (2 * R1) + rim_displacement(r, a, b, k) * (R1 - R2) / (R1 * R2)


def _radius_from_depth(d: Array, R1: Array, R2: Array, b: Array, k: Array) -> Array:
    from ..._runtime.graded.inverse import radius_across

    return radius_across(_depth_at, _rate_at, d, b, (R1, R2, b, k), 2.0, least=1.0 + k)


def _radius_from_force(F: Array, R1: Array, R2: Array, b: Array, H: Array, k: Array) -> Array:
    from ..._runtime.graded.inverse import radius_across

    return radius_across(_force_at, _force_rate_at, F, b, (R1, R2, b, H, k), 3.0 + k, least=1.0 + k)


def _force_from_depth(d: Array, R1: Array, R2: Array, b: Array, H: Array, k: Array) -> Array:
    a = _radius_from_depth(d, R1, R2, b, k)
    return _force(a, R1, R2, b, H, k) + punch_force(d - _depth(a, R1, R2, b, k), a, H, k)


def _depth_from_force(F: Array, R1: Array, R2: Array, b: Array, H: Array, k: Array) -> Array:
    a = _radius_from_force(F, R1, R2, b, H, k)
    return _depth(a, R1, R2, b, k) + punch_depth(F - _force(a, R1, R2, b, H, k), a, H, k)


def _check(R1: ArrayLike, R2: ArrayLike, b: ArrayLike, *, k: ArrayLike, **material: ArrayLike) -> None:
    from ...normal import capped_paraboloid as normal

    normal._check(R1=R1, R2=R2, b=b, k=k, **material)
