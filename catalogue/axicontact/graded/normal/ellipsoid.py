"""Ellipsoid of revolution on a power-law graded half-space.

Semi-axis h along the axis, b across: the sphere stretched by h/b.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.growth import sphere_depth, sphere_force, sphere_rate
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


def profile(r: ArrayLike, *, h: ArrayLike, b: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = h*(1 - sqrt(1 - r**2/b**2))

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    h : array_like
        Semi-axis along the axis of revolution [m], h > 0.
    b : array_like
        Semi-axis across, the largest radius of the body [m], b > 0.

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
    Valid for a < b; small slopes. Negative or NaN field values give NaN.

    References
    ----------
    Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import ellipsoid
    >>> value = ellipsoid.profile(0.3, h=0.9, b=1.5)
    >>> round(value, 6)
    0.018184
    """
    from ...normal import ellipsoid as normal

    return normal.profile(r, h=h, b=b)


def depth(a: ArrayLike, *, h: ArrayLike, b: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = a**2*h*2F1(1/2, 1, (k + 3)/2, a**2/b**2)/(b**2*(k + 1))
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Handbook: ellipsoid.fgm.d.

    References
    ----------
    chapter 11, equation (11.61); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import ellipsoid
    >>> value = ellipsoid.depth(1.0, h=0.9, b=1.5, k=0.25)
    >>> round(value, 6)
    0.380078
    """
    require(h=h, b=b, k=k)
    return elementwise(_depth, a, h=h, b=b, k=k)


def force(a: ArrayLike, *, h: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force.

    F = 4*H*a**(k + 3)*h*2F1(1/2, 2, (k + 5)/2, a**2/b**2)/(b**2*(k + 1)**2*(k + 3))
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Handbook: ellipsoid.fgm.F.

    References
    ----------
    chapter 11, equation (11.51); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import ellipsoid
    >>> value = ellipsoid.force(1.0, h=0.9, b=1.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.390433
    """
    require(h=h, b=b, H=H, k=k)
    return elementwise(_force, a, h=h, b=b, H=H, k=k)


def pressure(r: ArrayLike, a: ArrayLike, *, h: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = H*Integral((2*h*sqrt(r**2 + u**(2/(k + 1)))*2F1(1/2, 1, (k + 3)/2, (r**2 + u**(2/(k +
    1)))/b**2)/(b**2*(k + 1)) + 2*h*(r**2 + u**(2/(k + 1)))**(3/2)*2F1(3/2, 2, (k + 3)/2 + 1, (r**2
    + u**(2/(k + 1)))/b**2)/(b**4*(k + 1)*(k + 3)))/sqrt(r**2 + u**(2/(k + 1))), (u, 0, (a**2 - r**2)**(k/2 +
    1/2)))/(pi*(k + 1))
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Evaluated as an integral over the
    growing contact, by a rule that carries the weight of the grading. Handbook: ellipsoid.fgm.p.

    References
    ----------
    chapter 11, equation (11.53); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import ellipsoid
    >>> value = ellipsoid.pressure(0.3, 1.0, h=0.9, b=1.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.178332
    """
    require(h=h, b=b, H=H, k=k)
    return elementwise(_pressure, r, a, h=h, b=b, H=H, k=k)


def displacement(r: ArrayLike, a: ArrayLike, *, h: ArrayLike, b: ArrayLike, k: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*cos(pi*k/2)*Integral((a**2*h*2F1(1/2, 1, (k + 3)/2, a**2/b**2)/(b**2*(k + 1)) -
    h*r**2*sin(psi)**2*2F1(1/2, 1, (k + 3)/2, r**2*sin(psi)**2/b**2)/(b**2*(k + 1)))*tan(psi)**k,
    (psi, 0, asin(a/r)))/pi
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Evaluated as an integral over the
    displacement inside the contact. Handbook: ellipsoid.fgm.w.

    References
    ----------
    chapter 11, equation (11.56); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import ellipsoid
    >>> value = ellipsoid.displacement(2.0, 1.0, h=0.9, b=1.5, k=0.25)
    >>> round(value, 6)
    0.050342
    """
    require(h=h, b=b, k=k)
    return elementwise(_displacement, r, a, h=h, b=b, k=k)


def stiffness(a: ArrayLike, *, h: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*H*a**(k + 1)/(k + 1)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Handbook: ellipsoid.fgm.k.

    References
    ----------
    chapter 11, equation (11.46); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import ellipsoid
    >>> value = ellipsoid.stiffness(1.0, h=0.9, b=1.5, H=1.0, k=0.25)
    >>> round(value, 6)
    1.6
    """
    require(h=h, b=b, H=H, k=k)
    return elementwise(_stiffness, a, H=H, k=k, unused=(h, b))


def mean_pressure(a: ArrayLike, *, h: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = 4*H*a**(k + 1)*h*2F1(1/2, 2, (k + 5)/2, a**2/b**2)/(pi*b**2*(k + 1)**2*(k + 3))
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Handbook: ellipsoid.fgm.pm.

    References
    ----------
    Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import ellipsoid
    >>> value = ellipsoid.mean_pressure(1.0, h=0.9, b=1.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.124279
    """
    require(h=h, b=b, H=H, k=k)
    return elementwise(_mean_pressure, a, h=h, b=b, H=H, k=k)


def radius_from_depth(d: ArrayLike, *, h: ArrayLike, b: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a from a**2*h*2F1(1/2, 1, (k + 3)/2, a**2/b**2)/(b**2*(k + 1)) = d
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: ellipsoid.fgm.ad.

    References
    ----------
    chapter 11, equation (11.48); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import ellipsoid
    >>> value = ellipsoid.radius_from_depth(0.3801, h=0.9, b=1.5, k=0.25)
    >>> round(value, 6)
    1.000024
    """
    require(h=h, b=b, k=k)
    return elementwise(_radius_from_depth, d, h=h, b=b, k=k)


def radius_from_force(F: ArrayLike, *, h: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a from 4*H*a**(k + 3)*h*2F1(1/2, 2, (k + 5)/2, a**2/b**2)/(b**2*(k + 1)**2*(k + 3)) = F
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

    Parameters
    ----------
    F : array_like
        Normal force [N].
    h : array_like
        Height or depth of the profile [m], h > 0.
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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: ellipsoid.fgm.aF.

    References
    ----------
    chapter 11, equation (11.51); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import ellipsoid
    >>> value = ellipsoid.radius_from_force(0.3904, h=0.9, b=1.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.999978
    """
    require(h=h, b=b, H=H, k=k)
    return elementwise(_radius_from_force, F, h=h, b=b, H=H, k=k)


def force_from_depth(d: ArrayLike, *, h: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = F(a(d)), through the contact radius.

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: ellipsoid.fgm.Fd.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import ellipsoid
    >>> value = ellipsoid.force_from_depth(0.3801, h=0.9, b=1.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.390469
    """
    require(h=h, b=b, H=H, k=k)
    return elementwise(_force_from_depth, d, h=h, b=b, H=H, k=k)


def depth_from_force(F: ArrayLike, *, h: ArrayLike, b: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = d(a(F)), through the contact radius.

    Parameters
    ----------
    F : array_like
        Normal force [N].
    h : array_like
        Height or depth of the profile [m], h > 0.
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
    Valid for a < b; small slopes. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton
    iteration. Handbook: ellipsoid.fgm.dF.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import ellipsoid
    >>> value = ellipsoid.depth_from_force(0.3904, h=0.9, b=1.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.380057
    """
    require(h=h, b=b, H=H, k=k)
    return elementwise(_depth_from_force, F, h=h, b=b, H=H, k=k)


def _depth_at(a: Array, root: Array, h: Array, b: Array, k: Array) -> Array:
    return h * sphere_depth(a, root, k) / b


def _rate_at(a: Array, root: Array, h: Array, b: Array, k: Array) -> Array:
    """Rate g'(a) of the depth."""
    return h * sphere_rate(a, root, k) / b


def _force_at(a: Array, root: Array, h: Array, b: Array, H: Array, k: Array) -> Array:
    growth = h * sphere_force(a, root, k) / b
    return 2.0 * H / (1.0 + k) * growth


def _depth(a: Array, h: Array, b: Array, k: Array) -> Array:
    return np.where(a <= b, _depth_at(a, difference_root(b, a), h, b, k), np.nan)


def _rate(a: Array, h: Array, b: Array, k: Array) -> Array:
    return np.where(a <= b, _rate_at(a, difference_root(b, a), h, b, k), np.nan)


def _force(a: Array, h: Array, b: Array, H: Array, k: Array) -> Array:
    return np.where(a <= b, _force_at(a, difference_root(b, a), h, b, H, k), np.nan)


def _force_rate_at(a: Array, root: Array, h: Array, b: Array, H: Array, k: Array) -> Array:
    """Derivative of the force."""
    return punch_stiffness(a, H, k) * _rate_at(a, root, h, b, k)


def _stiffness(a: Array, H: Array, k: Array) -> Array:
    return punch_stiffness(a, H, k)


def _mean_pressure(a: Array, h: Array, b: Array, H: Array, k: Array) -> Array:
    return np.where(a > 0.0, _force(a, h, b, H, k) / (np.pi * a * a), 0.0)


def _pressure(r: Array, a: Array, h: Array, b: Array, H: Array, k: Array) -> Array:
    from ..._runtime.graded.pressure import sphere_pressure

    inside = np.minimum(r, a)
    growth = h * sphere_pressure(inside, a, b, k) / b
    return np.where(a <= b, np.where(r < a, H / np.pi * growth, 0.0), np.nan)


def _displacement(r: Array, a: Array, h: Array, b: Array, k: Array) -> Array:
    from ..._runtime.graded.displacement import sphere_displacement

    return h * sphere_displacement(r, a, b, k) / b


def _contact_from_depth(d: Array, h: Array, b: Array, k: Array) -> tuple[Array, Array]:
    """Contact radius a and its root sqrt(b**2 - a**2)."""
    from ..._runtime.graded.inverse import contact_below

    return contact_below(_depth_at, _rate_at, d, b, (h, b, k), 2.0, k)


def _radius_from_depth(d: Array, h: Array, b: Array, k: Array) -> Array:
    return _contact_from_depth(d, h, b, k)[0]


def _contact_from_force(F: Array, h: Array, b: Array, H: Array, k: Array) -> tuple[Array, Array]:
    """Contact radius a and its root sqrt(b**2 - a**2)."""
    from ..._runtime.graded.inverse import contact_below

    return contact_below(_force_at, _force_rate_at, F, b, (h, b, H, k), 3.0 + k, k)


def _radius_from_force(F: Array, h: Array, b: Array, H: Array, k: Array) -> Array:
    return _contact_from_force(F, h, b, H, k)[0]


def _force_from_depth(d: Array, h: Array, b: Array, H: Array, k: Array) -> Array:
    a, root = _contact_from_depth(d, h, b, k)
    return _force_at(a, root, h, b, H, k) + punch_force(d - _depth_at(a, root, h, b, k), a, H, k)


def _depth_from_force(F: Array, h: Array, b: Array, H: Array, k: Array) -> Array:
    a, root = _contact_from_force(F, h, b, H, k)
    return _depth_at(a, root, h, b, k) + punch_depth(F - _force_at(a, root, h, b, H, k), a, H, k)
