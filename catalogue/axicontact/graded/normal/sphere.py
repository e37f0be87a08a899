"""Sphere on a power-law graded half-space.

The exact spherical shape; differs from the paraboloid by terms of order a^2/R^2.
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


def profile(r: ArrayLike, *, R: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = R - sqrt(R**2 - r**2)

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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.

    References
    ----------
    Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import sphere
    >>> value = sphere.profile(0.3, R=1.5)
    >>> round(value, 6)
    0.030306
    """
    from ...normal import sphere as normal

    return normal.profile(r, R=R)


def depth(a: ArrayLike, *, R: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = a**2*2F1(1/2, 1, (k + 3)/2, a**2/R**2)/(R*(k + 1))
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Handbook: sphere.fgm.d.

    References
    ----------
    chapter 11, equation (11.61); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import sphere
    >>> value = sphere.depth(1.0, R=1.5, k=0.25)
    >>> round(value, 6)
    0.633463
    """
    require(R=R, k=k)
    return elementwise(_depth, a, R=R, k=k)


def force(a: ArrayLike, *, R: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force.

    F = 4*H*a**(k + 3)*2F1(1/2, 2, (k + 5)/2, a**2/R**2)/(R*(k + 1)**2*(k + 3))
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Handbook: sphere.fgm.F.

    References
    ----------
    chapter 11, equation (11.51); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import sphere
    >>> value = sphere.force(1.0, R=1.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.650722
    """
    require(R=R, H=H, k=k)
    return elementwise(_force, a, R=R, H=H, k=k)


def pressure(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = H*Integral((2*sqrt(r**2 + u**(2/(k + 1)))*2F1(1/2, 1, (k + 3)/2, (r**2 + u**(2/(k +
    1)))/R**2)/(R*(k + 1)) + 2*(r**2 + u**(2/(k + 1)))**(3/2)*2F1(3/2, 2, (k + 3)/2 + 1, (r**2 +
    u**(2/(k + 1)))/R**2)/(R**3*(k + 1)*(k + 3)))/sqrt(r**2 + u**(2/(k + 1))), (u, 0, (a**2 - r**2)**(k/2 +
    1/2)))/(pi*(k + 1))
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Evaluated as an integral over the growing contact, by a rule that carries the weight of the grading.
    Handbook: sphere.fgm.p.

    References
    ----------
    chapter 11, equation (11.53); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import sphere
    >>> value = sphere.pressure(0.3, 1.0, R=1.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.29722
    """
    require(R=R, H=H, k=k)
    return elementwise(_pressure, r, a, R=R, H=H, k=k)


def displacement(r: ArrayLike, a: ArrayLike, *, R: ArrayLike, k: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*cos(pi*k/2)*Integral((a**2*2F1(1/2, 1, (k + 3)/2, a**2/R**2)/(R*(k + 1)) -
    r**2*sin(psi)**2*2F1(1/2, 1, (k + 3)/2, r**2*sin(psi)**2/R**2)/(R*(k + 1)))*tan(psi)**k, (psi,
    0, asin(a/r)))/pi
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Evaluated as an integral over the displacement inside the contact. Handbook: sphere.fgm.w.

    References
    ----------
    chapter 11, equation (11.56); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import sphere
    >>> value = sphere.displacement(2.0, 1.0, R=1.5, k=0.25)
    >>> round(value, 6)
    0.083904
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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Handbook: sphere.fgm.k.

    References
    ----------
    chapter 11, equation (11.46); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import sphere
    >>> value = sphere.stiffness(1.0, R=1.5, H=1.0, k=0.25)
    >>> round(value, 6)
    1.6
    """
    require(R=R, H=H, k=k)
    return elementwise(_stiffness, a, H=H, k=k, unused=(R,))


def mean_pressure(a: ArrayLike, *, R: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = 4*H*a**(k + 1)*2F1(1/2, 2, (k + 5)/2, a**2/R**2)/(pi*R*(k + 1)**2*(k + 3))
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Handbook: sphere.fgm.pm.

    References
    ----------
    Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import sphere
    >>> value = sphere.mean_pressure(1.0, R=1.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.207131
    """
    require(R=R, H=H, k=k)
    return elementwise(_mean_pressure, a, R=R, H=H, k=k)


def radius_from_depth(d: ArrayLike, *, R: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a from a**2*2F1(1/2, 1, (k + 3)/2, a**2/R**2)/(R*(k + 1)) = d
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Evaluated by a safeguarded Newton iteration. Handbook: sphere.fgm.ad.

    References
    ----------
    chapter 11, equation (11.48); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import sphere
    >>> value = sphere.radius_from_depth(0.6335, R=1.5, k=0.25)
    >>> round(value, 6)
    1.000024
    """
    require(R=R, k=k)
    return elementwise(_radius_from_depth, d, R=R, k=k)


def radius_from_force(F: ArrayLike, *, R: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a from 4*H*a**(k + 3)*2F1(1/2, 2, (k + 5)/2, a**2/R**2)/(R*(k + 1)**2*(k + 3)) = F
    with 2F1: Gauss's 2F1(p, q; c; z) for z < 1, (11.93)

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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Evaluated by a safeguarded Newton iteration. Handbook: sphere.fgm.aF.

    References
    ----------
    chapter 11, equation (11.51); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import sphere
    >>> value = sphere.radius_from_force(0.6507, R=1.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.999991
    """
    require(R=R, H=H, k=k)
    return elementwise(_radius_from_force, F, R=R, H=H, k=k)


def force_from_depth(d: ArrayLike, *, R: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = F(a(d)), through the contact radius.

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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Evaluated by a safeguarded Newton iteration. Handbook: sphere.fgm.Fd.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import sphere
    >>> value = sphere.force_from_depth(0.6335, R=1.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.650781
    """
    require(R=R, H=H, k=k)
    return elementwise(_force_from_depth, d, R=R, H=H, k=k)


def depth_from_force(F: ArrayLike, *, R: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = d(a(F)), through the contact radius.

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
    Valid for a < R; the theory of small slopes asks for a << R. Negative or NaN field values give NaN.
    Evaluated by a safeguarded Newton iteration. Handbook: sphere.fgm.dF.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Segedin 1957; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import sphere
    >>> value = sphere.depth_from_force(0.6507, R=1.5, H=1.0, k=0.25)
    >>> round(value, 6)
    0.633449
    """
    require(R=R, H=H, k=k)
    return elementwise(_depth_from_force, F, R=R, H=H, k=k)


def _depth_at(a: Array, root: Array, R: Array, k: Array) -> Array:
    return sphere_depth(a, root, k)


def _rate_at(a: Array, root: Array, R: Array, k: Array) -> Array:
    """Rate g'(a) of the depth."""
    return sphere_rate(a, root, k)


def _force_at(a: Array, root: Array, R: Array, H: Array, k: Array) -> Array:
    growth = sphere_force(a, root, k)
    return 2.0 * H / (1.0 + k) * growth


def _depth(a: Array, R: Array, k: Array) -> Array:
    return np.where(a <= R, _depth_at(a, difference_root(R, a), R, k), np.nan)


def _rate(a: Array, R: Array, k: Array) -> Array:
    return np.where(a <= R, _rate_at(a, difference_root(R, a), R, k), np.nan)


def _force(a: Array, R: Array, H: Array, k: Array) -> Array:
    return np.where(a <= R, _force_at(a, difference_root(R, a), R, H, k), np.nan)


def _force_rate_at(a: Array, root: Array, R: Array, H: Array, k: Array) -> Array:
    """Derivative of the force."""
    return punch_stiffness(a, H, k) * _rate_at(a, root, R, k)


def _stiffness(a: Array, H: Array, k: Array) -> Array:
    return punch_stiffness(a, H, k)


def _mean_pressure(a: Array, R: Array, H: Array, k: Array) -> Array:
    return np.where(a > 0.0, _force(a, R, H, k) / (np.pi * a * a), 0.0)


def _pressure(r: Array, a: Array, R: Array, H: Array, k: Array) -> Array:
    from ..._runtime.graded.pressure import sphere_pressure

    inside = np.minimum(r, a)
    growth = sphere_pressure(inside, a, R, k)
    return np.where(a <= R, np.where(r < a, H / np.pi * growth, 0.0), np.nan)


def _displacement(r: Array, a: Array, R: Array, k: Array) -> Array:
    from ..._runtime.graded.displacement import sphere_displacement

    return sphere_displacement(r, a, R, k)


def _contact_from_depth(d: Array, R: Array, k: Array) -> tuple[Array, Array]:
    """Contact radius a and its root sqrt(R**2 - a**2)."""
    from ..._runtime.graded.inverse import contact_below

    return contact_below(_depth_at, _rate_at, d, R, (R, k), 2.0, k)


def _radius_from_depth(d: Array, R: Array, k: Array) -> Array:
    return _contact_from_depth(d, R, k)[0]


def _contact_from_force(F: Array, R: Array, H: Array, k: Array) -> tuple[Array, Array]:
    """Contact radius a and its root sqrt(R**2 - a**2)."""
    from ..._runtime.graded.inverse import contact_below

    return contact_below(_force_at, _force_rate_at, F, R, (R, H, k), 3.0 + k, k)


def _radius_from_force(F: Array, R: Array, H: Array, k: Array) -> Array:
    return _contact_from_force(F, R, H, k)[0]


def _force_from_depth(d: Array, R: Array, H: Array, k: Array) -> Array:
    a, root = _contact_from_depth(d, R, k)
    return _force_at(a, root, R, H, k) + punch_force(d - _depth_at(a, root, R, k), a, H, k)


def _depth_from_force(F: Array, R: Array, H: Array, k: Array) -> Array:
    a, root = _contact_from_force(F, R, H, k)
    return _depth_at(a, root, R, k) + punch_depth(F - _force_at(a, root, R, H, k), a, H, k)
