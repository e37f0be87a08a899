"""Curved punch with a rounded edge on a power-law graded half-space.

A paraboloid of radius R1 whose edge is rounded off from r = b on with the radius R2.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.breaks import rounding_depth, rounding_force, rounding_rate
from ..._runtime.graded.growth import power_depth, power_force, power_rate
from ..._runtime.graded.punch import punch_depth, punch_force, punch_stiffness
from ..._runtime.integrals import difference_root
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


def profile(r: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = r**2/(2*R1)   for 0 < r < b
    f = (-b + r)**2/(2*R2) + r**2/(2*R1)   for b < r

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
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN.

    Examples
    --------
    >>> from axicontact.graded.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.profile(0.45, R1=6.0, R2=1.2, b=1.0)
    >>> round(value, 6)
    0.016875
    """
    from ...normal import rounded_curved_punch as normal

    return normal.profile(r, R1=R1, R2=R2, b=b)


def depth(a: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = a**2/(R1*(k + 1))   for a < b
    d = -a*b*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2)/(2*R2) + a**(1 - k)*(a**2 - b**2)**(k/2 +
    1/2)/(R2*(k + 1)) + a**2/(R1*(k + 1))   for b < a
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

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
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN. Handbook:
    rounded_curved_punch.fgm.d.

    References
    ----------
    chapter 11, equation (11.61).

    Examples
    --------
    >>> from axicontact.graded.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.depth(1.5, R1=6.0, R2=1.2, b=1.0, k=0.25)
    >>> round(value, 6)
    0.542565
    """
    require(R1=R1, R2=R2, b=b, k=k)
    return elementwise(_depth, a, R1=R1, R2=R2, b=b, k=k)


def force(a: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force.

    F = 4*H*a**(k + 3)/(R1*(k + 1)**2*(k + 3))   for a < b
    F = H*(-a**(k + 2)*b*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2)/(R2*(k + 2)) + 2*(a**2 - b**2)**(k/2 +
    1/2)*(2*a**2*k + 4*a**2 - b**2*k - b**2)/(R2*(k + 1)*(k + 2)*(k + 3)) + 4*a**(k + 3)/(R1*(k + 1)*(k +
    3)))/(k + 1)   for b < a
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

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
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN. Handbook:
    rounded_curved_punch.fgm.F.

    References
    ----------
    chapter 11, equation (11.51).

    Examples
    --------
    >>> from axicontact.graded.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.force(1.5, R1=6.0, R2=1.2, b=1.0, H=1.0, k=0.25)
    >>> round(value, 6)
    1.038714
    """
    require(R1=R1, R2=R2, b=b, H=H, k=k)
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
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact, by a rule that carries the weight of the grading. Handbook: rounded_curved_punch.fgm.p.

    References
    ----------
    chapter 11, equation (11.53).

    Examples
    --------
    >>> from axicontact.graded.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.pressure(0.45, 1.5, R1=6.0, R2=1.2, b=1.0, H=1.0, k=0.25)
    >>> round(value, 6)
    0.172653
    """
    require(R1=R1, R2=R2, b=b, H=H, k=k)
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
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN. Evaluated as an integral over the
    displacement inside the contact. Handbook: rounded_curved_punch.fgm.w.

    References
    ----------
    chapter 11, equation (11.56).

    Examples
    --------
    >>> from axicontact.graded.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.displacement(3.0, 1.5, R1=6.0, R2=1.2, b=1.0, k=0.25)
    >>> round(value, 6)
    0.081052
    """
    require(R1=R1, R2=R2, b=b, k=k)
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
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN. Handbook:
    rounded_curved_punch.fgm.k.

    References
    ----------
    chapter 11, equation (11.46).

    Examples
    --------
    >>> from axicontact.graded.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.stiffness(1.5, R1=6.0, R2=1.2, b=1.0, H=1.0, k=0.25)
    >>> round(value, 6)
    2.656037
    """
    require(R1=R1, R2=R2, b=b, H=H, k=k)
    return elementwise(_stiffness, a, H=H, k=k, unused=(R1, R2, b))


def mean_pressure(a: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = 4*H*a**(k + 1)/(pi*R1*(k + 1)**2*(k + 3))   for a < b
    p_mean = H*(-a**k*b*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2)/(R2*(k + 2)) + 2*(a**2 - b**2)**(k/2 +
    1/2)*(2*a**2*k + 4*a**2 - b**2*k - b**2)/(R2*a**2*(k + 1)*(k + 2)*(k + 3)) + 4*a**(k + 1)/(R1*(k + 1)*(k +
    3)))/(pi*(k + 1))   for b < a
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

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
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN. Handbook:
    rounded_curved_punch.fgm.pm.

    Examples
    --------
    >>> from axicontact.graded.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.mean_pressure(1.5, R1=6.0, R2=1.2, b=1.0, H=1.0, k=0.25)
    >>> round(value, 6)
    0.146948
    """
    require(R1=R1, R2=R2, b=b, H=H, k=k)
    return elementwise(_mean_pressure, a, R1=R1, R2=R2, b=b, H=H, k=k)


def radius_from_depth(d: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a from a**2/(R1*(k + 1)) = d   for a < b
    a from -a*b*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2)/(2*R2) + a**(1 - k)*(a**2 - b**2)**(k/2 +
    1/2)/(R2*(k + 1)) + a**2/(R1*(k + 1)) = d   for b < a
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

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
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: rounded_curved_punch.fgm.ad.

    References
    ----------
    chapter 11, equation (11.48).

    Examples
    --------
    >>> from axicontact.graded.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.radius_from_depth(0.5426, R1=6.0, R2=1.2, b=1.0, k=0.25)
    >>> round(value, 6)
    1.500028
    """
    require(R1=R1, R2=R2, b=b, k=k)
    return elementwise(_radius_from_depth, d, R1=R1, R2=R2, b=b, k=k)


def radius_from_force(
    F: ArrayLike, *, R1: ArrayLike, R2: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike
) -> Result:
    """Contact radius under the normal force F.

    a from 4*H*a**(k + 3)/(R1*(k + 1)**2*(k + 3)) = F   for a < b
    a from H*(-a**(k + 2)*b*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2)/(R2*(k + 2)) + 2*(a**2 - b**2)**(k/2
    + 1/2)*(2*a**2*k + 4*a**2 - b**2*k - b**2)/(R2*(k + 1)*(k + 2)*(k + 3)) + 4*a**(k + 3)/(R1*(k + 1)*(k +
    3)))/(k + 1) = F   for b < a
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

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
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: rounded_curved_punch.fgm.aF.

    References
    ----------
    chapter 11, equation (11.51).

    Examples
    --------
    >>> from axicontact.graded.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.radius_from_force(1.039, R1=6.0, R2=1.2, b=1.0, H=1.0, k=0.25)
    >>> round(value, 6)
    1.500086
    """
    require(R1=R1, R2=R2, b=b, H=H, k=k)
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
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: rounded_curved_punch.fgm.Fd.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51).

    Examples
    --------
    >>> from axicontact.graded.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.force_from_depth(0.5426, R1=6.0, R2=1.2, b=1.0, H=1.0, k=0.25)
    >>> round(value, 6)
    1.038807
    """
    require(R1=R1, R2=R2, b=b, H=H, k=k)
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
    Valid for a << R1, a - b << R2. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: rounded_curved_punch.fgm.dF.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51).

    Examples
    --------
    >>> from axicontact.graded.normal import rounded_curved_punch
    >>> value = rounded_curved_punch.depth_from_force(1.039, R1=6.0, R2=1.2, b=1.0, H=1.0, k=0.25)
    >>> round(value, 6)
    0.542673
    """
    require(R1=R1, R2=R2, b=b, H=H, k=k)
    return elementwise(_depth_from_force, F, R1=R1, R2=R2, b=b, H=H, k=k)


def _depth_at(a: Array, root: Array, R1: Array, R2: Array, b: Array, k: Array) -> Array:
    return power_depth(a, 2.0, k) / (2 * R1) + rounding_depth(a, root, b, k) / R2


def _rate_at(a: Array, root: Array, R1: Array, R2: Array, b: Array, k: Array) -> Array:
    """Rate g'(a) of the depth."""
    return power_rate(a, 2.0, k) / (2 * R1) + rounding_rate(a, root, b, k) / R2


def _force_at(a: Array, root: Array, R1: Array, R2: Array, b: Array, H: Array, k: Array) -> Array:
    growth = power_force(a, 2.0, k) / (2 * R1) + rounding_force(a, root, b, k) / R2
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
    from ..._runtime.graded.pressure import power_pressure, rounding_pressure

    inside = np.minimum(r, a)
    growth = power_pressure(inside, a, 2.0, k) / (2 * R1) + rounding_pressure(inside, a, b, k) / R2
    return np.where(r < a, H / np.pi * growth, 0.0)


def _displacement(r: Array, a: Array, R1: Array, R2: Array, b: Array, k: Array) -> Array:
    from ..._runtime.graded.displacement import power_displacement, rounding_displacement

    return power_displacement(r, a, 2.0, k) / (2 * R1) + rounding_displacement(r, a, b, k) / R2


def _radius_from_depth(d: Array, R1: Array, R2: Array, b: Array, k: Array) -> Array:
    from ..._runtime.graded.inverse import radius_across

    return radius_across(_depth_at, _rate_at, d, b, (R1, R2, b, k), 2.0)


def _radius_from_force(F: Array, R1: Array, R2: Array, b: Array, H: Array, k: Array) -> Array:
    from ..._runtime.graded.inverse import radius_across

    return radius_across(_force_at, _force_rate_at, F, b, (R1, R2, b, H, k), 3.0 + k)


def _force_from_depth(d: Array, R1: Array, R2: Array, b: Array, H: Array, k: Array) -> Array:
    a = _radius_from_depth(d, R1, R2, b, k)
    return _force(a, R1, R2, b, H, k) + punch_force(d - _depth(a, R1, R2, b, k), a, H, k)


def _depth_from_force(F: Array, R1: Array, R2: Array, b: Array, H: Array, k: Array) -> Array:
    a = _radius_from_force(F, R1, R2, b, H, k)
    return _depth(a, R1, R2, b, k) + punch_depth(F - _force(a, R1, R2, b, H, k), a, H, k)
