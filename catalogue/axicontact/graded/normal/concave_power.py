"""Concave power law on a power-law graded half-space.

Concave face of depth h; complete contact needs the force F_min.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.growth import power_factor
from ..._runtime.graded.punch import punch_pressure, punch_stiffness
from ..._runtime.interface import Array, Result, either, elementwise, require, require_order
from ..._runtime.shapes.ring import lifted_at_zero_pressure, ring_of_zero_pressure

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


def profile(r: ArrayLike, *, a: ArrayLike, h: ArrayLike, n: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = -h*(r/a)**n

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Depth of the concave face [m], h > 0.
    n : array_like
        Exponent of the profile [1], n > 0.

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
    >>> from axicontact.graded.normal import concave_power
    >>> value = concave_power.profile(0.3, a=1.0, h=0.15, n=3.0)
    >>> round(value, 6)
    -0.00405
    """
    from ...normal import concave_power as normal

    return normal.profile(r, a=a, h=h, n=n)


def force(d: ArrayLike, *, a: ArrayLike, h: ArrayLike, n: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force.

    F = 2*H*a**(k + 1)*(d/(k + 1) + h*gamma((k + 1)/2)*gamma(n/2 + 1)/((k + n + 1)*gamma((k + n + 1)/2)))

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    below those of complete contact. Handbook: concave_power.fgm.F.

    References
    ----------
    chapter 11, equation (11.45); chapter 11, equation (11.51); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import concave_power
    >>> value = concave_power.force(0.6, a=1.0, h=0.15, n=3.0, H=1.0, k=0.25)
    >>> round(value, 6)
    1.087054
    """
    require(a=a, h=h, n=n, H=H, k=k)
    require_order(
        np.asarray(n) > 1.0 - np.asarray(k),
        "n > 1 - k",
        "a sharper dimple never reaches complete contact at a finite load; use n > 1 - k",
        n=n,
        k=k,
    )
    return elementwise(_force, d, a=a, h=h, n=n, H=H, k=k)


def pressure(
    r: ArrayLike, d: ArrayLike, *, a: ArrayLike, h: ArrayLike, n: ArrayLike, H: ArrayLike, k: ArrayLike
) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = H*(d*(a**2 - r**2)**(k/2 - 1/2) + h*(a**2 - r**2)**(k/2 - 1/2)*gamma((k + 1)/2)*gamma(n/2 +
    1)/gamma((k + n + 1)/2) - h*n*r**(k + n - 1)*IncompleteBeta(1 - r**2/a**2, (k + 1)/2, (-k - n +
    1)/2)*gamma((k + 1)/2)*gamma(n/2 + 1)/(2*a**n*gamma((k + n + 1)/2)))/pi
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
    n : array_like
        Exponent of the profile [1], n > 0.
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
    below those of complete contact. Handbook: concave_power.fgm.p.

    References
    ----------
    chapter 11, equation (11.47); chapter 11, equation (11.53); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import concave_power
    >>> value = concave_power.pressure(0.3, 0.6, a=1.0, h=0.15, n=3.0, H=1.0, k=0.25)
    >>> round(value, 6)
    0.164745
    """
    require(a=a, h=h, n=n, H=H, k=k)
    require_order(
        np.asarray(n) > 1.0 - np.asarray(k),
        "n > 1 - k",
        "a sharper dimple never reaches complete contact at a finite load; use n > 1 - k",
        n=n,
        k=k,
    )
    return elementwise(_pressure, r, d, a=a, h=h, n=n, H=H, k=k)


def displacement(r: ArrayLike, d: ArrayLike, *, a: ArrayLike, h: ArrayLike, n: ArrayLike, k: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = (d*IncompleteBeta(a**2/r**2, (k + 1)/2, (1 - k)/2) + h*r**n*IncompleteBeta(a**2/r**2, (k + n + 1)/2,
    (1 - k)/2)*gamma((k + 1)/2)*gamma(n/2 + 1)/(a**n*gamma((k + n + 1)/2)))*cos(pi*k/2)/pi
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
    n : array_like
        Exponent of the profile [1], n > 0.
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
    below those of complete contact. Handbook: concave_power.fgm.w.

    References
    ----------
    chapter 11, equation (11.44); chapter 11, equation (11.56); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import concave_power
    >>> value = concave_power.displacement(2.0, 0.6, a=1.0, h=0.15, n=3.0, k=0.25)
    >>> round(value, 6)
    0.144595
    """
    require(a=a, h=h, n=n, k=k)
    require_order(
        np.asarray(n) > 1.0 - np.asarray(k),
        "n > 1 - k",
        "a sharper dimple never reaches complete contact at a finite load; use n > 1 - k",
        n=n,
        k=k,
    )
    return elementwise(_displacement, r, d, a=a, h=h, n=n, k=k)


def stiffness(*, a: ArrayLike, h: ArrayLike, n: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*H*a**(k + 1)/(k + 1)

    Parameters
    ----------
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes; complete contact only. Handbook: concave_power.fgm.k.

    References
    ----------
    chapter 11, equation (11.46); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import concave_power
    >>> value = concave_power.stiffness(a=1.0, h=0.15, n=3.0, H=1.0, k=0.25)
    >>> round(value, 6)
    1.6
    """
    require(a=a, h=h, n=n, H=H, k=k)
    require_order(
        np.asarray(n) > 1.0 - np.asarray(k),
        "n > 1 - k",
        "a sharper dimple never reaches complete contact at a finite load; use n > 1 - k",
        n=n,
        k=k,
    )
    return elementwise(_stiffness, a=a, H=H, k=k, unused=(h, n))


def depth_from_force(F: ArrayLike, *, a: ArrayLike, h: ArrayLike, n: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = (k + 1)*(F*a**(-k - 1)/H - 2*h*gamma((k + 1)/2)*gamma(n/2 + 1)/((k + n + 1)*gamma((k + n + 1)/2)))/2

    Parameters
    ----------
    F : array_like
        Normal force [N].
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    below those of complete contact. Handbook: concave_power.fgm.dF.

    References
    ----------
    chapter 11, equation (11.46); chapter 11, equation (11.51); Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import concave_power
    >>> value = concave_power.depth_from_force(1.087, a=1.0, h=0.15, n=3.0, H=1.0, k=0.25)
    >>> round(value, 6)
    0.599966
    """
    require(a=a, h=h, n=n, H=H, k=k)
    require_order(
        np.asarray(n) > 1.0 - np.asarray(k),
        "n > 1 - k",
        "a sharper dimple never reaches complete contact at a finite load; use n > 1 - k",
        n=n,
        k=k,
    )
    return elementwise(_depth_from_force, F, a=a, h=h, n=n, H=H, k=k)


def zero_radius(*, a: ArrayLike, h: ArrayLike, n: ArrayLike, k: ArrayLike) -> Result:
    """Radius of the ring where the pressure first vanishes on unloading.

    r_zero = 0   for 1 - k < n <= 2
    r_zero from IncompleteBeta(1 - r_zero**2/a**2, k/2 + 1/2, -k/2 - n/2 + 1/2) = 2*(r_zero/a)**(-k - n +
    1)*(1 - r_zero**2/a**2)**(k/2 + 1/2)/(k*(1 - r_zero**2/a**2) + n*(1 - r_zero**2/a**2) - 1 +
    k*r_zero**2/a**2)   for 2 < n
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes; complete contact only. Handbook: concave_power.fgm.rz.

    References
    ----------
    Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import concave_power
    >>> value = concave_power.zero_radius(a=1.0, h=0.15, n=3.0, k=0.25)
    >>> round(value, 6)
    0.280582
    """
    require(a=a, h=h, n=n, k=k)
    require_order(
        np.asarray(n) > 1.0 - np.asarray(k),
        "n > 1 - k",
        "a sharper dimple never reaches complete contact at a finite load; use n > 1 - k",
        n=n,
        k=k,
    )
    return elementwise(_zero_radius, a=a, h=h, n=n, k=k)


def minimum_depth(*, a: ArrayLike, h: ArrayLike, n: ArrayLike, k: ArrayLike) -> Result:
    """Least indentation depth of complete contact.

    d = -a**2*h*(k - 1)*gamma(k/2 + 1/2)*gamma(n/2 + 1)/((a**2*k + a**2*n - a**2 - n*r_zero**2)*gamma(k/2 +
    n/2 + 1/2))

    Parameters
    ----------
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes; complete contact only. Handbook: concave_power.fgm.dmin.

    References
    ----------
    Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import concave_power
    >>> value = concave_power.minimum_depth(a=1.0, h=0.15, n=3.0, k=0.25)
    >>> round(value, 6)
    0.100552
    """
    require(a=a, h=h, n=n, k=k)
    require_order(
        np.asarray(n) > 1.0 - np.asarray(k),
        "n > 1 - k",
        "a sharper dimple never reaches complete contact at a finite load; use n > 1 - k",
        n=n,
        k=k,
    )
    return elementwise(_minimum_depth, a=a, h=h, n=n, k=k)


def minimum_force(*, a: ArrayLike, h: ArrayLike, n: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Least normal force of complete contact.

    F = 2*H*a**(k + 1)*h*n*(2*a**2 - k*r_zero**2 - r_zero**2)*gamma((k + 1)/2)*gamma(n/2 + 1)/((k + 1)*(k + n
    + 1)*(a**2*k + a**2*n - a**2 - n*r_zero**2)*gamma((k + n + 1)/2))

    Parameters
    ----------
    a : array_like
        Contact radius [m], a > 0.
    h : array_like
        Height or depth of the profile [m], h > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
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
    Valid for small slopes; complete contact only. Handbook: concave_power.fgm.Fmin.

    References
    ----------
    Barber 1976; Schubert 1942.

    Examples
    --------
    >>> from axicontact.graded.normal import concave_power
    >>> value = concave_power.minimum_force(a=1.0, h=0.15, n=3.0, H=1.0, k=0.25)
    >>> round(value, 6)
    0.287937
    """
    require(a=a, h=h, n=n, H=H, k=k)
    require_order(
        np.asarray(n) > 1.0 - np.asarray(k),
        "n > 1 - k",
        "a sharper dimple never reaches complete contact at a finite load; use n > 1 - k",
        n=n,
        k=k,
    )
    return elementwise(_minimum_force, a=a, h=h, n=n, H=H, k=k)


def _force(d: Array, a: Array, h: Array, n: Array, H: Array, k: Array) -> Array:
    complete = _minimum_depth(a, h, n, k) * (1.0 - 1e-15) <= d
    return np.where(
        complete, punch_stiffness(a, H, k) * (d + h * power_factor(n, k) * (1.0 + k) / (n + 1.0 + k)), np.nan
    )


def _pressure(r: Array, d: Array, a: Array, h: Array, n: Array, H: Array, k: Array) -> Array:
    from ..._runtime.graded.pressure import power_pressure

    complete = _minimum_depth(a, h, n, k) * (1.0 - 1e-15) <= d
    edge = (d + h * power_factor(n, k)) * punch_pressure(r, a, H, k)
    hollow = H / np.pi * h * power_pressure(np.minimum(r, a), a, n, k) / a**n
    return np.where(complete, np.where(r < a, edge - hollow, edge), np.nan)


def _displacement(r: Array, d: Array, a: Array, h: Array, n: Array, k: Array) -> Array:
    from ..._runtime.graded.displacement import power_sag, punch_share
    from ...normal import concave_power as normal

    complete = _minimum_depth(a, h, n, k) * (1.0 - 1e-15) <= d

    def outside() -> Array:
        return d * punch_share(r, a, k) + h * power_sag(r, a, n, k) / a**n

    value = either(r > a, outside, lambda: d - normal._profile(r, a=a, h=h, n=n))
    return np.where(complete, value, np.nan)


def _stiffness(a: Array, H: Array, k: Array) -> Array:
    return punch_stiffness(a, H, k)


def _depth_from_force(F: Array, a: Array, h: Array, n: Array, H: Array, k: Array) -> Array:
    complete = _minimum_force(a, h, n, H, k) * (1.0 - 1e-15) <= F
    return np.where(complete, F / punch_stiffness(a, H, k) - h * power_factor(n, k) * (1.0 + k) / (n + 1.0 + k), np.nan)


def _zero_radius(a: Array, h: Array, n: Array, k: Array) -> Array:
    return a * ring_of_zero_pressure(n, k) + 0.0 * h


def _minimum_depth(a: Array, h: Array, n: Array, k: Array) -> Array:
    return h * power_factor(n, k) * (1.0 - k) / lifted_at_zero_pressure(n, k) + 0.0 * a


def _minimum_force(a: Array, h: Array, n: Array, H: Array, k: Array) -> Array:
    return punch_stiffness(a, H, k) * (_minimum_depth(a, h, n, k) + h * power_factor(n, k) * (1.0 + k) / (n + 1.0 + k))
