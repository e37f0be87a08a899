"""Flat punch with a rounded edge on a power-law graded half-space.

Flat face of radius b running tangentially into a rounding of radius R: between flat punch and sphere.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.breaks import rounding_depth, rounding_force, rounding_rate
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


def profile(r: ArrayLike, *, R: ArrayLike, b: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = 0   for 0 < r < b
    f = (-b + r)**2/(2*R)   for b < r

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values give NaN.

    References
    ----------
    Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.graded.normal import rounded_punch
    >>> value = rounded_punch.profile(0.486, R=1.45, b=1.15)
    >>> round(value, 6)
    0.0
    """
    from ...normal import rounded_punch as normal

    return normal.profile(r, R=R, b=b)


def depth(a: ArrayLike, *, R: ArrayLike, b: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = (-a*b*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2)/2 + a**(1 - k)*(a**2 - b**2)**(k/2 + 1/2)/(k +
    1))/R
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values, and radii below b among larger
    ones, give NaN. Handbook: rounded_punch.fgm.d.

    References
    ----------
    chapter 11, equation (11.61); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.graded.normal import rounded_punch
    >>> value = rounded_punch.depth(1.62, R=1.45, b=1.15, k=0.25)
    >>> round(value, 6)
    0.186464
    """
    require(R=R, b=b, k=k)
    require_reach(a, b, "graded.normal.flat_punch")
    return elementwise(_depth, a, R=R, b=b, k=k)


def force(a: ArrayLike, *, R: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force.

    F = H*(-a**(k + 2)*b*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2) + 2*(a**2 - b**2)**(k/2 +
    1/2)*(2*a**2*k + 4*a**2 - b**2*k - b**2)/((k + 1)*(k + 3)))/(R*(k + 1)*(k + 2))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values, and radii below b among larger
    ones, give NaN. Handbook: rounded_punch.fgm.F.

    References
    ----------
    chapter 11, equation (11.51); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.graded.normal import rounded_punch
    >>> value = rounded_punch.force(1.62, R=1.45, b=1.15, H=1.0, k=0.25)
    >>> round(value, 6)
    0.474013
    """
    require(R=R, b=b, H=H, k=k)
    require_reach(a, b, "graded.normal.flat_punch")
    return elementwise(_force, a, R=R, b=b, H=H, k=k)


def pressure(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values, and radii below b among larger
    ones, give NaN. Evaluated as an integral over the growing contact, by a rule that carries the weight of
    the grading. Handbook: rounded_punch.fgm.p.

    References
    ----------
    chapter 11, equation (11.53); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.graded.normal import rounded_punch
    >>> value = rounded_punch.pressure(0.486, 1.62, R=1.45, b=1.15, H=1.0, k=0.25)
    >>> round(value, 6)
    0.047349
    """
    require(R=R, b=b, H=H, k=k)
    require_reach(a, b, "graded.normal.flat_punch")
    return elementwise(_pressure, r, a, R=R, b=b, H=H, k=k)


def displacement(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, b: ArrayLike, k: ArrayLike) -> Result:
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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values, and radii below b among larger
    ones, give NaN. Evaluated as an integral over the displacement inside the contact. Handbook:
    rounded_punch.fgm.w.

    References
    ----------
    chapter 11, equation (11.56); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.graded.normal import rounded_punch
    >>> value = rounded_punch.displacement(3.24, 1.62, R=1.45, b=1.15, k=0.25)
    >>> round(value, 6)
    0.033833
    """
    require(R=R, b=b, k=k)
    require_reach(a, b, "graded.normal.flat_punch")
    return elementwise(_displacement, r, a, R=R, b=b, k=k)


def stiffness(a: ArrayLike, *, R: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*H*a**(k + 1)/(k + 1)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values, and radii below b among larger
    ones, give NaN. Handbook: rounded_punch.fgm.k.

    References
    ----------
    chapter 11, equation (11.46); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.graded.normal import rounded_punch
    >>> value = rounded_punch.stiffness(1.62, R=1.45, b=1.15, H=1.0, k=0.25)
    >>> round(value, 6)
    2.924245
    """
    require(R=R, b=b, H=H, k=k)
    require_reach(a, b, "graded.normal.flat_punch")
    return elementwise(_stiffness, a, H=H, k=k, unused=(R, b))


def mean_pressure(a: ArrayLike, *, R: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = H*(-a**k*b*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2) + 2*(a**2 - b**2)**(k/2 + 1/2)*(2*a**2*k
    + 4*a**2 - b**2*k - b**2)/(a**2*(k + 1)*(k + 3)))/(pi*R*(k + 1)*(k + 2))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values, and radii below b among larger
    ones, give NaN. Handbook: rounded_punch.fgm.pm.

    References
    ----------
    Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.graded.normal import rounded_punch
    >>> value = rounded_punch.mean_pressure(1.62, R=1.45, b=1.15, H=1.0, k=0.25)
    >>> round(value, 6)
    0.057492
    """
    require(R=R, b=b, H=H, k=k)
    require_reach(a, b, "graded.normal.flat_punch")
    return elementwise(_mean_pressure, a, R=R, b=b, H=H, k=k)


def radius_from_depth(d: ArrayLike, *, R: ArrayLike, b: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a from (-a*b*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2)/2 + a**(1 - k)*(a**2 - b**2)**(k/2 + 1/2)/(k +
    1))/R = d
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values give NaN. Evaluated by a
    safeguarded Newton iteration. Handbook: rounded_punch.fgm.ad.

    References
    ----------
    chapter 11, equation (11.48); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.graded.normal import rounded_punch
    >>> value = rounded_punch.radius_from_depth(0.1865, R=1.45, b=1.15, k=0.25)
    >>> round(value, 6)
    1.620053
    """
    require(R=R, b=b, k=k)
    return elementwise(_radius_from_depth, d, R=R, b=b, k=k)


def radius_from_force(F: ArrayLike, *, R: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a from H*(-a**(k + 2)*b*IncompleteBeta(1 - b**2/a**2, (k + 1)/2, 1/2) + 2*(a**2 - b**2)**(k/2 +
    1/2)*(2*a**2*k + 4*a**2 - b**2*k - b**2)/((k + 1)*(k + 3)))/(R*(k + 1)*(k + 2)) = F
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values give NaN. Evaluated by a
    safeguarded Newton iteration. Handbook: rounded_punch.fgm.aF.

    References
    ----------
    chapter 11, equation (11.51); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.graded.normal import rounded_punch
    >>> value = rounded_punch.radius_from_force(0.474, R=1.45, b=1.15, H=1.0, k=0.25)
    >>> round(value, 6)
    1.619994
    """
    require(R=R, b=b, H=H, k=k)
    return elementwise(_radius_from_force, F, R=R, b=b, H=H, k=k)


def force_from_depth(d: ArrayLike, *, R: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = F(a(d)), through the contact radius.

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values give NaN. Evaluated by a
    safeguarded Newton iteration. Handbook: rounded_punch.fgm.Fd.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.graded.normal import rounded_punch
    >>> value = rounded_punch.force_from_depth(0.1865, R=1.45, b=1.15, H=1.0, k=0.25)
    >>> round(value, 6)
    0.474119
    """
    require(R=R, b=b, H=H, k=k)
    return elementwise(_force_from_depth, d, R=R, b=b, H=H, k=k)


def depth_from_force(F: ArrayLike, *, R: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = d(a(F)), through the contact radius.

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R : array_like
        Radius of curvature [m], R > 0.
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
    Valid for a - b << R (parabolic rounding). Negative or NaN field values give NaN. Evaluated by a
    safeguarded Newton iteration. Handbook: rounded_punch.fgm.dF.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Schubert 1942; Ciavarella 1999.

    Examples
    --------
    >>> from axicontact.graded.normal import rounded_punch
    >>> value = rounded_punch.depth_from_force(0.474, R=1.45, b=1.15, H=1.0, k=0.25)
    >>> round(value, 6)
    0.186459
    """
    require(R=R, b=b, H=H, k=k)
    return elementwise(_depth_from_force, F, R=R, b=b, H=H, k=k)


def _depth_at(a: Array, root: Array, R: Array, b: Array, k: Array) -> Array:
    return rounding_depth(a, root, b, k) / R


def _rate_at(a: Array, root: Array, R: Array, b: Array, k: Array) -> Array:
    """Rate g'(a) of the depth."""
    return rounding_rate(a, root, b, k) / R


def _force_at(a: Array, root: Array, R: Array, b: Array, H: Array, k: Array) -> Array:
    growth = rounding_force(a, root, b, k) / R
    return 2.0 * H / (1.0 + k) * growth


def _depth(a: Array, R: Array, b: Array, k: Array) -> Array:
    return np.where(a >= b, _depth_at(a, difference_root(a, b), R, b, k), np.nan)


def _rate(a: Array, R: Array, b: Array, k: Array) -> Array:
    return np.where(a >= b, _rate_at(a, difference_root(a, b), R, b, k), np.nan)


def _force(a: Array, R: Array, b: Array, H: Array, k: Array) -> Array:
    return np.where(a >= b, _force_at(a, difference_root(a, b), R, b, H, k), np.nan)


def _force_rate_at(a: Array, root: Array, R: Array, b: Array, H: Array, k: Array) -> Array:
    """Derivative of the force."""
    return punch_stiffness(a, H, k) * _rate_at(a, root, R, b, k)


def _stiffness(a: Array, H: Array, k: Array) -> Array:
    return punch_stiffness(a, H, k)


def _mean_pressure(a: Array, R: Array, b: Array, H: Array, k: Array) -> Array:
    return _force(a, R, b, H, k) / (np.pi * a * a)


def _pressure(r: Array, a: Array, R: Array, b: Array, H: Array, k: Array) -> Array:
    from ..._runtime.graded.pressure import rounding_pressure

    inside = np.minimum(r, a)
    growth = rounding_pressure(inside, a, b, k) / R
    return np.where(a >= b, np.where(r < a, H / np.pi * growth, 0.0), np.nan)


def _displacement(r: Array, a: Array, R: Array, b: Array, k: Array) -> Array:
    from ..._runtime.graded.displacement import rounding_displacement

    return rounding_displacement(r, a, b, k) / R


def _contact_from_depth(d: Array, R: Array, b: Array, k: Array) -> tuple[Array, Array]:
    """Contact radius a and its root sqrt(a**2 - b**2)."""
    from ..._runtime.graded.inverse import contact_beyond

    return contact_beyond(_depth_at, _rate_at, d, b, (R, b, k), (3.0 + k, 2.0))


def _radius_from_depth(d: Array, R: Array, b: Array, k: Array) -> Array:
    return _contact_from_depth(d, R, b, k)[0]


def _contact_from_force(F: Array, R: Array, b: Array, H: Array, k: Array) -> tuple[Array, Array]:
    """Contact radius a and its root sqrt(a**2 - b**2)."""
    from ..._runtime.graded.inverse import contact_beyond

    return contact_beyond(_force_at, _force_rate_at, F, b, (R, b, H, k), (3.0 + k, 3.0 + k))


def _radius_from_force(F: Array, R: Array, b: Array, H: Array, k: Array) -> Array:
    return _contact_from_force(F, R, b, H, k)[0]


def _force_from_depth(d: Array, R: Array, b: Array, H: Array, k: Array) -> Array:
    a, root = _contact_from_depth(d, R, b, k)
    return _force_at(a, root, R, b, H, k) + punch_force(d - _depth_at(a, root, R, b, k), a, H, k)


def _depth_from_force(F: Array, R: Array, b: Array, H: Array, k: Array) -> Array:
    a, root = _contact_from_force(F, R, b, H, k)
    return _depth_at(a, root, R, b, k) + punch_depth(F - _force_at(a, root, R, b, H, k), a, H, k)
