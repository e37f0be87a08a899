"""Truncated paraboloid on a power-law graded half-space.

Flat face of radius b with a parabolic flank: a worn sphere.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.breaks import rim_depth, rim_force, rim_rate
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
    f = (-b**2 + r**2)/(2*R)   for b < r

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
    Valid for a << R. Negative or NaN field values give NaN.

    References
    ----------
    Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.profile(0.3, R=1.2, b=0.5)
    >>> round(value, 6)
    0.0
    """
    from ...normal import truncated_paraboloid as normal

    return normal.profile(r, R=R, b=b)


def depth(a: ArrayLike, *, R: ArrayLike, b: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = a**(1 - k)*(a**2 - b**2)**(k/2 + 1/2)/(R*(k + 1))

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
    Valid for a << R. Negative or NaN field values, and radii below b among larger ones, give NaN. Handbook:
    truncated_paraboloid.fgm.d.

    References
    ----------
    chapter 11, equation (11.61); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.depth(1.0, R=1.2, b=0.5, k=0.25)
    >>> round(value, 6)
    0.556957
    """
    require(R=R, b=b, k=k)
    require_reach(a, b, "graded.normal.flat_punch")
    return elementwise(_depth, a, R=R, b=b, k=k)


def force(a: ArrayLike, *, R: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force.

    F = 2*H*(a**2 - b**2)**(k/2 + 1/2)*(2*a**2 + b**2*k + b**2)/(R*(k + 1)**2*(k + 3))

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
    Valid for a << R. Negative or NaN field values, and radii below b among larger ones, give NaN. Handbook:
    truncated_paraboloid.fgm.F.

    References
    ----------
    chapter 11, equation (11.51); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.force(1.0, R=1.2, b=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.634075
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
    Valid for a << R. Negative or NaN field values, and radii below b among larger ones, give NaN. Evaluated
    as an integral over the growing contact, by a rule that carries the weight of the grading. Handbook:
    truncated_paraboloid.fgm.p.

    References
    ----------
    chapter 11, equation (11.53); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.pressure(0.3, 1.0, R=1.2, b=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.243697
    """
    require(R=R, b=b, H=H, k=k)
    require_reach(a, b, "graded.normal.flat_punch")
    return elementwise(_pressure, r, a, R=R, b=b, H=H, k=k)


def displacement(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, b: ArrayLike, k: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*cos(pi*k/2)*Integral((a**(1 - k)*(a**2 - b**2)**(k/2 + 1/2)/(R*(k + 1)) - (r*sin(psi))**(1 -
    k)*(-b**2 + r**2*sin(psi)**2)**(k/2 + 1/2)/(R*(k + 1)))*tan(psi)**k, (psi, asin(b/r), asin(a/r)))/pi +
    a**(1 - k)*(a**2 - b**2)**(k/2 + 1/2)*cos(pi*k/2)*IncompleteBeta(b**2/r**2, (k + 1)/2, (1 - k)/2)/(pi*R*(k
    + 1))
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
    Valid for a << R. Negative or NaN field values, and radii below b among larger ones, give NaN. Evaluated
    as an integral over the displacement inside the contact. Handbook: truncated_paraboloid.fgm.w.

    References
    ----------
    chapter 11, equation (11.56); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.displacement(2.0, 1.0, R=1.2, b=0.5, k=0.25)
    >>> round(value, 6)
    0.081797
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
    Valid for a << R. Negative or NaN field values, and radii below b among larger ones, give NaN. Handbook:
    truncated_paraboloid.fgm.k.

    References
    ----------
    chapter 11, equation (11.46); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.stiffness(1.0, R=1.2, b=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    1.6
    """
    require(R=R, b=b, H=H, k=k)
    require_reach(a, b, "graded.normal.flat_punch")
    return elementwise(_stiffness, a, H=H, k=k, unused=(R, b))


def mean_pressure(a: ArrayLike, *, R: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = 2*H*(a**2 - b**2)**(k/2 + 1/2)*(2*a**2 + b**2*k + b**2)/(pi*R*a**2*(k + 1)**2*(k + 3))

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
    Valid for a << R. Negative or NaN field values, and radii below b among larger ones, give NaN. Handbook:
    truncated_paraboloid.fgm.pm.

    References
    ----------
    Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.mean_pressure(1.0, R=1.2, b=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.201832
    """
    require(R=R, b=b, H=H, k=k)
    require_reach(a, b, "graded.normal.flat_punch")
    return elementwise(_mean_pressure, a, R=R, b=b, H=H, k=k)


def radius_from_depth(d: ArrayLike, *, R: ArrayLike, b: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a from a**(1 - k)*(a**2 - b**2)**(k/2 + 1/2)/(R*(k + 1)) = d

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
    Valid for a << R. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton iteration.
    Handbook: truncated_paraboloid.fgm.ad.

    References
    ----------
    chapter 11, equation (11.48); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.radius_from_depth(0.557, R=1.2, b=0.5, k=0.25)
    >>> round(value, 6)
    1.000032
    """
    require(R=R, b=b, k=k)
    return elementwise(_radius_from_depth, d, R=R, b=b, k=k)


def radius_from_force(F: ArrayLike, *, R: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a from 2*H*(a**2 - b**2)**(k/2 + 1/2)*(2*a**2 + b**2*k + b**2)/(R*(k + 1)**2*(k + 3)) = F

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
    Valid for a << R. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton iteration.
    Handbook: truncated_paraboloid.fgm.aF.

    References
    ----------
    chapter 11, equation (11.51); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.radius_from_force(0.6341, R=1.2, b=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    1.000012
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
    Valid for a << R. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton iteration.
    Handbook: truncated_paraboloid.fgm.Fd.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.force_from_depth(0.557, R=1.2, b=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.634143
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
    Valid for a << R. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton iteration.
    Handbook: truncated_paraboloid.fgm.dF.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Ejike 1981.

    Examples
    --------
    >>> from axicontact.graded.normal import truncated_paraboloid
    >>> value = truncated_paraboloid.depth_from_force(0.6341, R=1.2, b=0.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.556973
    """
    require(R=R, b=b, H=H, k=k)
    return elementwise(_depth_from_force, F, R=R, b=b, H=H, k=k)


def _depth_at(a: Array, root: Array, R: Array, b: Array, k: Array) -> Array:
    return rim_depth(a, root, b, k) / R


def _rate_at(a: Array, root: Array, R: Array, b: Array, k: Array) -> Array:
    """Rate g'(a) of the depth."""
    return rim_rate(a, root, b, k) / R


def _force_at(a: Array, root: Array, R: Array, b: Array, H: Array, k: Array) -> Array:
    growth = rim_force(a, root, b, k) / R
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
    from ..._runtime.graded.pressure import rim_pressure

    inside = np.minimum(r, a)
    growth = rim_pressure(inside, a, b, k) / R
    return np.where(a >= b, np.where(r < a, H / np.pi * growth, 0.0), np.nan)


def _displacement(r: Array, a: Array, R: Array, b: Array, k: Array) -> Array:
    from ..._runtime.graded.displacement import rim_displacement

    return rim_displacement(r, a, b, k) / R


def _contact_from_depth(d: Array, R: Array, b: Array, k: Array) -> tuple[Array, Array]:
    """Contact radius a and its root sqrt(a**2 - b**2)."""
    from ..._runtime.graded.inverse import contact_beyond

    return contact_beyond(_depth_at, _rate_at, d, b, (R, b, k), (1.0 + k, 2.0))


def _radius_from_depth(d: Array, R: Array, b: Array, k: Array) -> Array:
    return _contact_from_depth(d, R, b, k)[0]


def _contact_from_force(F: Array, R: Array, b: Array, H: Array, k: Array) -> tuple[Array, Array]:
    """Contact radius a and its root sqrt(a**2 - b**2)."""
    from ..._runtime.graded.inverse import contact_beyond

    return contact_beyond(_force_at, _force_rate_at, F, b, (R, b, H, k), (1.0 + k, 3.0 + k))


def _radius_from_force(F: Array, R: Array, b: Array, H: Array, k: Array) -> Array:
    return _contact_from_force(F, R, b, H, k)[0]


def _force_from_depth(d: Array, R: Array, b: Array, H: Array, k: Array) -> Array:
    a, root = _contact_from_depth(d, R, b, k)
    return _force_at(a, root, R, b, H, k) + punch_force(d - _depth_at(a, root, R, b, k), a, H, k)


def _depth_from_force(F: Array, R: Array, b: Array, H: Array, k: Array) -> Array:
    a, root = _contact_from_force(F, R, b, H, k)
    return _depth_at(a, root, R, b, k) + punch_depth(F - _force_at(a, root, R, b, H, k), a, H, k)
