"""Gaussian bump on a power-law graded half-space.

A smooth asperity of height h and width s; compact up to the radius of largest depth.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.graded.growth import gaussian_depth, gaussian_force, gaussian_rate
from ..._runtime.graded.punch import punch_depth, punch_force, punch_stiffness
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


def profile(r: ArrayLike, *, h: ArrayLike, s: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = h*(1 - exp(-r**2/s**2))

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    h : array_like
        Height of the bump [m], h > 0.
    s : array_like
        Width of the bump, the radius at which its height is down to 37 per cent [m], s > 0.

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
    Valid for h << s. Negative or NaN field values give NaN.

    References
    ----------
    Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.graded.normal import gaussian
    >>> value = gaussian.profile(0.3, h=0.7, s=1.0)
    >>> round(value, 6)
    0.060248
    """
    from ...normal import gaussian as normal

    return normal.profile(r, h=h, s=s)


def depth(a: ArrayLike, *, h: ArrayLike, s: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = 2*a**2*h*1F1(1, (k + 3)/2, -a**2/s**2)/(s**2*(k + 1))
    with 1F1: Confluent 1F1(p; c; z)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s. Negative or NaN field values give NaN. Handbook: gaussian.fgm.d.

    References
    ----------
    chapter 11, equation (11.61); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.graded.normal import gaussian
    >>> value = gaussian.depth(1.0, h=0.7, s=1.0, k=0.25)
    >>> round(value, 6)
    0.634149
    """
    require(h=h, s=s, k=k)
    return elementwise(_depth, a, h=h, s=s, k=k)


def force(a: ArrayLike, *, h: ArrayLike, s: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force.

    F = 8*H*a**(k + 3)*h*1F1(2, (k + 5)/2, -a**2/s**2)/(s**2*(k + 1)**2*(k + 3))
    with 1F1: Confluent 1F1(p; c; z)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s. Negative or NaN field values give NaN. Handbook: gaussian.fgm.F.

    References
    ----------
    chapter 11, equation (11.51); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.graded.normal import gaussian
    >>> value = gaussian.force(1.0, h=0.7, s=1.0, H=1.0, k=0.25)
    >>> round(value, 6)
    0.528789
    """
    require(h=h, s=s, H=H, k=k)
    return elementwise(_force, a, h=h, s=s, H=H, k=k)


def pressure(r: ArrayLike, a: ArrayLike, *, h: ArrayLike, s: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = H*Integral((4*h*sqrt(r**2 + u**(2/(k + 1)))*1F1(1, (k + 3)/2, -(r**2 + u**(2/(k +
    1)))/s**2)/(s**2*(k + 1)) - 8*h*(r**2 + u**(2/(k + 1)))**(3/2)*1F1(2, (k + 3)/2 + 1, -(r**2 + u**(2/(k
    + 1)))/s**2)/(s**4*(k + 1)*(k + 3)))/sqrt(r**2 + u**(2/(k + 1))), (u, 0, (a**2 - r**2)**(k/2 +
    1/2)))/(pi*(k + 1))
    with 1F1: Confluent 1F1(p; c; z)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s. Negative or NaN field values give NaN. Evaluated as an integral over the growing
    contact, by a rule that carries the weight of the grading. Handbook: gaussian.fgm.p.

    References
    ----------
    chapter 11, equation (11.53); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.graded.normal import gaussian
    >>> value = gaussian.pressure(0.3, 1.0, h=0.7, s=1.0, H=1.0, k=0.25)
    >>> round(value, 6)
    0.326025
    """
    require(h=h, s=s, H=H, k=k)
    return elementwise(_pressure, r, a, h=h, s=s, H=H, k=k)


def displacement(r: ArrayLike, a: ArrayLike, *, h: ArrayLike, s: ArrayLike, k: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = 2*cos(pi*k/2)*Integral((2*a**2*h*1F1(1, (k + 3)/2, -a**2/s**2)/(s**2*(k + 1)) -
    2*h*r**2*sin(psi)**2*1F1(1, (k + 3)/2, -r**2*sin(psi)**2/s**2)/(s**2*(k + 1)))*tan(psi)**k, (psi, 0,
    asin(a/r)))/pi
    with 1F1: Confluent 1F1(p; c; z)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s. Negative or NaN field values give NaN. Evaluated as an integral over the displacement
    inside the contact. Handbook: gaussian.fgm.w.

    References
    ----------
    chapter 11, equation (11.56); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.graded.normal import gaussian
    >>> value = gaussian.displacement(2.0, 1.0, h=0.7, s=1.0, k=0.25)
    >>> round(value, 6)
    0.067661
    """
    require(h=h, s=s, k=k)
    return elementwise(_displacement, r, a, h=h, s=s, k=k)


def stiffness(a: ArrayLike, *, h: ArrayLike, s: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*H*a**(k + 1)/(k + 1)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s. Negative or NaN field values give NaN. Handbook: gaussian.fgm.k.

    References
    ----------
    chapter 11, equation (11.46); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.graded.normal import gaussian
    >>> value = gaussian.stiffness(1.0, h=0.7, s=1.0, H=1.0, k=0.25)
    >>> round(value, 6)
    1.6
    """
    require(h=h, s=s, H=H, k=k)
    return elementwise(_stiffness, a, H=H, k=k, unused=(h, s))


def mean_pressure(a: ArrayLike, *, h: ArrayLike, s: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = 8*H*a**(k + 1)*h*1F1(2, (k + 5)/2, -a**2/s**2)/(pi*s**2*(k + 1)**2*(k + 3))
    with 1F1: Confluent 1F1(p; c; z)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s. Negative or NaN field values give NaN. Handbook: gaussian.fgm.pm.

    References
    ----------
    Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.graded.normal import gaussian
    >>> value = gaussian.mean_pressure(1.0, h=0.7, s=1.0, H=1.0, k=0.25)
    >>> round(value, 6)
    0.168319
    """
    require(h=h, s=s, H=H, k=k)
    return elementwise(_mean_pressure, a, h=h, s=s, H=H, k=k)


def radius_from_depth(d: ArrayLike, *, h: ArrayLike, s: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a from 2*a**2*h*1F1(1, (k + 3)/2, -a**2/s**2)/(s**2*(k + 1)) = d
    with 1F1: Confluent 1F1(p; c; z)

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton iteration.
    Handbook: gaussian.fgm.ad.

    References
    ----------
    chapter 11, equation (11.48); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.graded.normal import gaussian
    >>> value = gaussian.radius_from_depth(0.6341, h=0.7, s=1.0, k=0.25)
    >>> round(value, 6)
    0.999919
    """
    require(h=h, s=s, k=k)
    return elementwise(_radius_from_depth, d, h=h, s=s, k=k)


def radius_from_force(F: ArrayLike, *, h: ArrayLike, s: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a from 8*H*a**(k + 3)*h*1F1(2, (k + 5)/2, -a**2/s**2)/(s**2*(k + 1)**2*(k + 3)) = F
    with 1F1: Confluent 1F1(p; c; z)

    Parameters
    ----------
    F : array_like
        Normal force [N].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton iteration.
    Handbook: gaussian.fgm.aF.

    References
    ----------
    chapter 11, equation (11.51); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.graded.normal import gaussian
    >>> value = gaussian.radius_from_force(0.5288, h=0.7, s=1.0, H=1.0, k=0.25)
    >>> round(value, 6)
    1.000012
    """
    require(h=h, s=s, H=H, k=k)
    return elementwise(_radius_from_force, F, h=h, s=s, H=H, k=k)


def force_from_depth(d: ArrayLike, *, h: ArrayLike, s: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = F(a(d)), through the contact radius.

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton iteration.
    Handbook: gaussian.fgm.Fd.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.graded.normal import gaussian
    >>> value = gaussian.force_from_depth(0.6341, h=0.7, s=1.0, H=1.0, k=0.25)
    >>> round(value, 6)
    0.528709
    """
    require(h=h, s=s, H=H, k=k)
    return elementwise(_force_from_depth, d, h=h, s=s, H=H, k=k)


def depth_from_force(F: ArrayLike, *, h: ArrayLike, s: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = d(a(F)), through the contact radius.

    Parameters
    ----------
    F : array_like
        Normal force [N].
    h : array_like
        Height or depth of the profile [m], h > 0.
    s : array_like
        Length scale of the profile [m], s > 0.
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
    Valid for h << s. Negative or NaN field values give NaN. Evaluated by a safeguarded Newton iteration.
    Handbook: gaussian.fgm.dF.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Popov, Heß & Willert 2019.

    Examples
    --------
    >>> from axicontact.graded.normal import gaussian
    >>> value = gaussian.depth_from_force(0.5288, h=0.7, s=1.0, H=1.0, k=0.25)
    >>> round(value, 6)
    0.634157
    """
    require(h=h, s=s, H=H, k=k)
    return elementwise(_depth_from_force, F, h=h, s=s, H=H, k=k)


def _depth(a: Array, h: Array, s: Array, k: Array) -> Array:
    growth = h * gaussian_depth(a, s, k)
    return np.where(_rate(a, h, s, k) >= 0.0, growth, np.nan)


def _rate(a: Array, h: Array, s: Array, k: Array) -> Array:
    """Rate g'(a) of the depth."""
    return h * gaussian_rate(a, s, k)


def _force(a: Array, h: Array, s: Array, H: Array, k: Array) -> Array:
    growth = h * gaussian_force(a, s, k)
    return np.where(_rate(a, h, s, k) >= 0.0, 2.0 * H / (1.0 + k) * growth, np.nan)


def _force_rate(a: Array, h: Array, s: Array, H: Array, k: Array) -> Array:
    """Derivative of the force."""
    return punch_stiffness(a, H, k) * _rate(a, h, s, k)


def _stiffness(a: Array, H: Array, k: Array) -> Array:
    return punch_stiffness(a, H, k)


def _mean_pressure(a: Array, h: Array, s: Array, H: Array, k: Array) -> Array:
    return np.where(a > 0.0, _force(a, h, s, H, k) / (np.pi * a * a), 0.0)


def _pressure(r: Array, a: Array, h: Array, s: Array, H: Array, k: Array) -> Array:
    from ..._runtime.graded.pressure import gaussian_pressure

    inside = np.minimum(r, a)
    growth = h * gaussian_pressure(inside, a, s, k)
    return np.where(_rate(a, h, s, k) >= 0.0, np.where(r < a, H / np.pi * growth, 0.0), np.nan)


def _displacement(r: Array, a: Array, h: Array, s: Array, k: Array) -> Array:
    from ..._runtime.graded.displacement import gaussian_displacement

    return h * gaussian_displacement(r, a, s, k)


def _radius_from_depth(d: Array, h: Array, s: Array, k: Array) -> Array:
    from ..._runtime.graded.inverse import gaussian_reach, radius_up_to
    from ..._runtime.physics.unknowns import on_the_bump

    return radius_up_to(_depth, _rate, d, gaussian_reach(s, k), (h, s, k), on_the_bump(s))


def _radius_from_force(F: Array, h: Array, s: Array, H: Array, k: Array) -> Array:
    from ..._runtime.graded.inverse import gaussian_reach, radius_up_to
    from ..._runtime.physics.unknowns import on_the_bump

    return radius_up_to(_force, _force_rate, F, gaussian_reach(s, k), (h, s, H, k), on_the_bump(s))


def _force_from_depth(d: Array, h: Array, s: Array, H: Array, k: Array) -> Array:
    a = _radius_from_depth(d, h, s, k)
    return _force(a, h, s, H, k) + punch_force(d - _depth(a, h, s, k), a, H, k)


def _depth_from_force(F: Array, h: Array, s: Array, H: Array, k: Array) -> Array:
    a = _radius_from_force(F, h, s, H, k)
    return _depth(a, h, s, k) + punch_depth(F - _force(a, h, s, H, k), a, H, k)
