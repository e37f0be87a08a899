"""Concave paraboloid on a power-law graded half-space.

Concave parabolic face of depth h: the pressure vanishes first at the centre.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.growth import power_factor
from ..._runtime.graded.punch import punch_pressure, punch_stiffness
from ..._runtime.interface import Array, Result, either, elementwise, require

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "depth_from_force",
    "displacement",
    "force",
    "minimum_depth",
    "minimum_force",
    "pressure",
    "profile",
    "stiffness",
    "zero_radius",
]


def __dir__() -> list[str]:
    return __all__


def profile(r: ArrayLike, *, a: ArrayLike, h: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = -h*r**2/a**2

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.

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
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN.

    References
    ----------
    Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import concave_paraboloid
    >>> value = concave_paraboloid.profile(0.3, a=1.0, h=0.15)
    >>> round(value, 6)
    -0.0135
    """
    from ...normal import concave_paraboloid as normal

    return normal.profile(r, a=a, h=h)


def force(d: ArrayLike, *, a: ArrayLike, h: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force.

    F = 2*H*a**(k + 1)*(d + 2*h/(k + 3))/(k + 1)

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
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
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN, and so do loads
    below those of complete contact. Handbook: concave_paraboloid.fgm.F.

    References
    ----------
    chapter 11, equation (11.45); chapter 11, equation (11.51); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import concave_paraboloid
    >>> value = concave_paraboloid.force(0.6, a=1.0, h=0.15, H=1.0, k=0.25)
    >>> round(value, 6)
    1.107692
    """
    require(a=a, h=h, H=H, k=k)
    return elementwise(_force, d, a=a, h=h, H=H, k=k)


def pressure(r: ArrayLike, d: ArrayLike, *, a: ArrayLike, h: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = H*(d*(a**2 - r**2)**(k/2 - 1/2) + 2*h*(a**2 - r**2)**(k/2 - 1/2)/(k + 1) - 4*h*(a**2 - r**2)**(k/2 +
    1/2)/(a**2*(k + 1)**2))/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
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
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN, and so do loads
    below those of complete contact. Handbook: concave_paraboloid.fgm.p.

    References
    ----------
    chapter 11, equation (11.47); chapter 11, equation (11.53); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import concave_paraboloid
    >>> value = concave_paraboloid.pressure(0.3, 0.6, a=1.0, h=0.15, H=1.0, k=0.25)
    >>> round(value, 6)
    0.161771
    """
    require(a=a, h=h, H=H, k=k)
    return elementwise(_pressure, r, d, a=a, h=h, H=H, k=k)


def displacement(r: ArrayLike, d: ArrayLike, *, a: ArrayLike, h: ArrayLike, k: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = (d*IncompleteBeta(a**2/r**2, (k + 1)/2, (1 - k)/2) + 2*h*r**2*IncompleteBeta(a**2/r**2, (k + 3)/2, (1
    - k)/2)/(a**2*(k + 1)))*cos(pi*k/2)/pi
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
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
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN, and so do loads
    below those of complete contact. Handbook: concave_paraboloid.fgm.w.

    References
    ----------
    chapter 11, equation (11.44); chapter 11, equation (11.56); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import concave_paraboloid
    >>> value = concave_paraboloid.displacement(2.0, 0.6, a=1.0, h=0.15, k=0.25)
    >>> round(value, 6)
    0.147246
    """
    require(a=a, h=h, k=k)
    return elementwise(_displacement, r, d, a=a, h=h, k=k)


def stiffness(*, a: ArrayLike, h: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*H*a**(k + 1)/(k + 1)

    Parameters
    ----------
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
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
    Valid for small slopes; complete contact only. Handbook: concave_paraboloid.fgm.k.

    References
    ----------
    chapter 11, equation (11.46); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import concave_paraboloid
    >>> value = concave_paraboloid.stiffness(a=1.0, h=0.15, H=1.0, k=0.25)
    >>> round(value, 6)
    1.6
    """
    require(a=a, h=h, H=H, k=k)
    return elementwise(_stiffness, a=a, H=H, k=k, unused=(h,))


def depth_from_force(F: ArrayLike, *, a: ArrayLike, h: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = F*a**(-k - 1)*(k + 1)/(2*H) - 2*h/(k + 3)

    Parameters
    ----------
    F : array_like
        Normal force [N].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
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
    Valid for small slopes; complete contact only. Negative or NaN field values give NaN, and so do loads
    below those of complete contact. Handbook: concave_paraboloid.fgm.dF.

    References
    ----------
    chapter 11, equation (11.46); chapter 11, equation (11.51); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import concave_paraboloid
    >>> value = concave_paraboloid.depth_from_force(1.108, a=1.0, h=0.15, H=1.0, k=0.25)
    >>> round(value, 6)
    0.600192
    """
    require(a=a, h=h, H=H, k=k)
    return elementwise(_depth_from_force, F, a=a, h=h, H=H, k=k)


def zero_radius(*, a: ArrayLike, h: ArrayLike, k: ArrayLike) -> Result:
    """Radius of the ring where the pressure first vanishes on unloading.

    r_zero = 0

    Parameters
    ----------
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.

    Returns
    -------
    float or ndarray
        Radius of the ring where the pressure first vanishes on unloading [m]. The shape to which the
        arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes; complete contact only. Handbook: concave_paraboloid.fgm.rz.

    References
    ----------
    Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import concave_paraboloid
    >>> value = concave_paraboloid.zero_radius(a=1.0, h=0.15, k=0.25)
    >>> round(value, 6)
    0.0
    """
    require(a=a, h=h, k=k)
    return elementwise(_zero_radius, a=a, h=h, k=k)


def minimum_depth(*, a: ArrayLike, h: ArrayLike, k: ArrayLike) -> Result:
    """Least indentation depth of complete contact.

    d = -2*h*(k - 1)/(k + 1)**2

    Parameters
    ----------
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
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
    Valid for small slopes; complete contact only. Handbook: concave_paraboloid.fgm.dmin.

    References
    ----------
    Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import concave_paraboloid
    >>> value = concave_paraboloid.minimum_depth(a=1.0, h=0.15, k=0.25)
    >>> round(value, 6)
    0.144
    """
    require(a=a, h=h, k=k)
    return elementwise(_minimum_depth, a=a, h=h, k=k)


def minimum_force(*, a: ArrayLike, h: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Least normal force of complete contact.

    F = 16*H*a**(k + 1)*h/((k + 1)**3*(k + 3))

    Parameters
    ----------
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
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
    Valid for small slopes; complete contact only. Handbook: concave_paraboloid.fgm.Fmin.

    References
    ----------
    Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import concave_paraboloid
    >>> value = concave_paraboloid.minimum_force(a=1.0, h=0.15, H=1.0, k=0.25)
    >>> round(value, 6)
    0.378092
    """
    require(a=a, h=h, H=H, k=k)
    return elementwise(_minimum_force, a=a, h=h, H=H, k=k)


def _force(d: Array, a: Array, h: Array, H: Array, k: Array) -> Array:
    complete = _minimum_depth(a, h, k) * (1.0 - 1e-15) <= d
    return np.where(
        complete, punch_stiffness(a, H, k) * (d + h * power_factor(2.0, k) * (1.0 + k) / (2.0 + 1.0 + k)), np.nan
    )


def _pressure(r: Array, d: Array, a: Array, h: Array, H: Array, k: Array) -> Array:
    least = _minimum_depth(a, h, k)
    face = 4 * h * r**2 / (a**2 * (k + 1) ** 2)
    pressure = (d - least + face) * punch_pressure(r, a, H, k)
    return np.where(least * (1.0 - 1e-15) <= d, pressure, np.nan)


def _displacement(r: Array, d: Array, a: Array, h: Array, k: Array) -> Array:
    from ..._runtime.graded.displacement import power_sag, punch_share
    from ...normal import concave_paraboloid as normal

    complete = _minimum_depth(a, h, k) * (1.0 - 1e-15) <= d

    def outside() -> Array:
        return d * punch_share(r, a, k) + h * power_sag(r, a, 2.0, k) / a**2.0

    value = either(r > a, outside, lambda: d - normal._profile(r, a=a, h=h))
    return np.where(complete, value, np.nan)


def _stiffness(a: Array, H: Array, k: Array) -> Array:
    return punch_stiffness(a, H, k)


def _depth_from_force(F: Array, a: Array, h: Array, H: Array, k: Array) -> Array:
    complete = _minimum_force(a, h, H, k) * (1.0 - 1e-15) <= F
    return np.where(
        complete, F / punch_stiffness(a, H, k) - h * power_factor(2.0, k) * (1.0 + k) / (2.0 + 1.0 + k), np.nan
    )


def _zero_radius(a: Array, h: Array, k: Array) -> Array:
    return 0.0 * a + 0.0 * h


def _minimum_depth(a: Array, h: Array, k: Array) -> Array:
    return -2 * h * (k - 1) / (k + 1) ** 2 + 0.0 * a


def _minimum_force(a: Array, h: Array, H: Array, k: Array) -> Array:
    return punch_stiffness(a, H, k) * (_minimum_depth(a, h, k) + h * power_factor(2.0, k) * (1.0 + k) / (2.0 + 1.0 + k))
