"""Cone on a power-law graded half-space.

Rigid cone of inclination theta. Self-similar: the mean pressure does not depend on the load.
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


def profile(r: ArrayLike, *, theta: ArrayLike) -> Result:
    """Profile f(r) of the indenter.

    f = r*tan(theta)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.

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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN.

    References
    ----------
    Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import cone
    >>> value = cone.profile(0.3, theta=0.35)
    >>> round(value, 6)
    0.109509
    """
    from ...normal import cone as normal

    return normal.profile(r, theta=theta)


def depth(a: ArrayLike, *, theta: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth at contact radius a.

    d = sqrt(pi)*a*tan(theta)*gamma((k + 1)/2)/(2*gamma(k/2 + 1))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. Handbook:
    cone.fgm.d.

    References
    ----------
    chapter 11, equation (11.61); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import cone
    >>> value = cone.depth(1.0, theta=0.35, k=0.25)
    >>> round(value, 6)
    0.492772
    """
    require(theta=theta, k=k)
    return elementwise(_depth, a, theta=theta, k=k)


def force(a: ArrayLike, *, theta: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force.

    F = sqrt(pi)*H*a**(k + 2)*tan(theta)*gamma((k + 1)/2)/((k + 1)*(k + 2)*gamma(k/2 + 1))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. Handbook:
    cone.fgm.F.

    References
    ----------
    chapter 11, equation (11.51); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import cone
    >>> value = cone.force(1.0, theta=0.35, H=1.0, k=0.25)
    >>> round(value, 6)
    0.350415
    """
    require(theta=theta, H=H, k=k)
    return elementwise(_force, a, theta=theta, H=H, k=k)


def pressure(r: ArrayLike, a: ArrayLike, *, theta: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = H*r**k*tan(theta)*IncompleteBeta(1 - r**2/a**2, (k + 1)/2, -k/2)*gamma((k +
    1)/2)/(4*sqrt(pi)*gamma(k/2 + 1))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. Evaluated as an
    integral over the growing contact, by a rule that carries the weight of the grading. Handbook: cone.fgm.p.

    References
    ----------
    chapter 11, equation (11.53); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import cone
    >>> value = cone.pressure(0.3, 1.0, theta=0.35, H=1.0, k=0.25)
    >>> round(value, 6)
    0.214798
    """
    require(theta=theta, H=H, k=k)
    return elementwise(_pressure, r, a, theta=theta, H=H, k=k)


def displacement(r: ArrayLike, a: ArrayLike, *, theta: ArrayLike, k: ArrayLike) -> Result:
    """Displacement of the surface into the half-space, inside and outside the contact.

    w = (a*IncompleteBeta(a**2/r**2, (k + 1)/2, (1 - k)/2) - r*IncompleteBeta(a**2/r**2, k/2 + 1, (1 -
    k)/2))*cos(pi*k/2)*tan(theta)*gamma((k + 1)/2)/(2*sqrt(pi)*gamma(k/2 + 1))
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. Evaluated as an
    integral over the displacement inside the contact. Handbook: cone.fgm.w.

    References
    ----------
    chapter 11, equation (11.56); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import cone
    >>> value = cone.displacement(2.0, 1.0, theta=0.35, k=0.25)
    >>> round(value, 6)
    0.04484
    """
    require(theta=theta, k=k)
    return elementwise(_displacement, r, a, theta=theta, k=k)


def stiffness(a: ArrayLike, *, theta: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact stiffness dF/dd.

    dF/dd = 2*H*a**(k + 1)/(k + 1)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. Handbook:
    cone.fgm.k.

    References
    ----------
    chapter 11, equation (11.46); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import cone
    >>> value = cone.stiffness(1.0, theta=0.35, H=1.0, k=0.25)
    >>> round(value, 6)
    1.6
    """
    require(theta=theta, H=H, k=k)
    return elementwise(_stiffness, a, H=H, k=k, unused=(theta,))


def mean_pressure(a: ArrayLike, *, theta: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Mean pressure F/(pi a^2).

    p_mean = H*a**k*tan(theta)*gamma((k + 1)/2)/(sqrt(pi)*(k + 1)*(k + 2)*gamma(k/2 + 1))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. Handbook:
    cone.fgm.pm.

    References
    ----------
    Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import cone
    >>> value = cone.mean_pressure(1.0, theta=0.35, H=1.0, k=0.25)
    >>> round(value, 6)
    0.111541
    """
    require(theta=theta, H=H, k=k)
    return elementwise(_mean_pressure, a, theta=theta, H=H, k=k)


def radius_from_depth(d: ArrayLike, *, theta: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius at indentation depth d.

    a = 2*d*gamma(k/2 + 1)/(sqrt(pi)*tan(theta)*gamma((k + 1)/2))

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. Handbook:
    cone.fgm.ad.

    References
    ----------
    chapter 11, equation (11.48); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import cone
    >>> value = cone.radius_from_depth(0.4928, theta=0.35, k=0.25)
    >>> round(value, 6)
    1.000058
    """
    require(theta=theta, k=k)
    return elementwise(_radius_from_depth, d, theta=theta, k=k)


def radius_from_force(F: ArrayLike, *, theta: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Contact radius under the normal force F.

    a = (F*(k + 1)*(k + 2)*gamma(k/2 + 1)/(sqrt(pi)*H*tan(theta)*gamma((k + 1)/2)))**(1/(k + 2))

    Parameters
    ----------
    F : array_like
        Normal force [N].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. Handbook:
    cone.fgm.aF.

    References
    ----------
    chapter 11, equation (11.51); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import cone
    >>> value = cone.radius_from_force(0.3504, theta=0.35, H=1.0, k=0.25)
    >>> round(value, 6)
    0.99998
    """
    require(theta=theta, H=H, k=k)
    return elementwise(_radius_from_force, F, theta=theta, H=H, k=k)


def force_from_depth(d: ArrayLike, *, theta: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Normal force at indentation depth d.

    F = sqrt(pi)*H*(2*d*gamma(k/2 + 1)/(sqrt(pi)*tan(theta)*gamma((k + 1)/2)))**(k + 2)*tan(theta)*gamma((k +
    1)/2)/((k + 1)*(k + 2)*gamma(k/2 + 1))

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. Handbook:
    cone.fgm.Fd.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import cone
    >>> value = cone.force_from_depth(0.4928, theta=0.35, H=1.0, k=0.25)
    >>> round(value, 6)
    0.350461
    """
    require(theta=theta, H=H, k=k)
    return elementwise(_force_from_depth, d, theta=theta, H=H, k=k)


def depth_from_force(F: ArrayLike, *, theta: ArrayLike, H: ArrayLike, k: ArrayLike) -> Result:
    """Indentation depth under the normal force F.

    d = sqrt(pi)*(F*(k + 1)*(k + 2)*gamma(k/2 + 1)/(sqrt(pi)*H*tan(theta)*gamma((k + 1)/2)))**(1/(k +
    2))*tan(theta)*gamma((k + 1)/2)/(2*gamma(k/2 + 1))

    Parameters
    ----------
    F : array_like
        Normal force [N].
    theta : array_like
        Inclination of the flank to the surface [rad], 0 < theta < pi/2.
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
    Valid for tan(theta) << 1; a << size of the body. Negative or NaN field values give NaN. Handbook:
    cone.fgm.dF.

    References
    ----------
    chapter 11, equation (11.48); chapter 11, equation (11.51); Love 1939; Schubert 1942; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.normal import cone
    >>> value = cone.depth_from_force(0.3504, theta=0.35, H=1.0, k=0.25)
    >>> round(value, 6)
    0.492762
    """
    require(theta=theta, H=H, k=k)
    return elementwise(_depth_from_force, F, theta=theta, H=H, k=k)


def _depth(a: Array, theta: Array, k: Array) -> Array:
    return power_depth(a, 1.0, k) * np.tan(theta)


def _rate(a: Array, theta: Array, k: Array) -> Array:
    """Rate g'(a) of the depth."""
    return power_rate(a, 1.0, k) * np.tan(theta)


def _force(a: Array, theta: Array, H: Array, k: Array) -> Array:
    growth = power_force(a, 1.0, k) * np.tan(theta)
    return 2.0 * H / (1.0 + k) * growth


def _stiffness(a: Array, H: Array, k: Array) -> Array:
    return punch_stiffness(a, H, k)


def _mean_pressure(a: Array, theta: Array, H: Array, k: Array) -> Array:
    growth = power_mean(a, 1.0, k) * np.tan(theta)
    return 2.0 * H / (1.0 + k) / np.pi * growth


def _pressure(r: Array, a: Array, theta: Array, H: Array, k: Array) -> Array:
    from ..._runtime.graded.pressure import power_pressure

    inside = np.minimum(r, a)
    growth = power_pressure(inside, a, 1.0, k) * np.tan(theta)
    return np.where(r < a, H / np.pi * growth, 0.0)


def _displacement(r: Array, a: Array, theta: Array, k: Array) -> Array:
    from ..._runtime.graded.displacement import power_displacement

    return power_displacement(r, a, 1.0, k) * np.tan(theta)


def _radius_from_depth(d: Array, theta: Array, k: Array) -> Array:
    return d / _depth(np.ones_like(d), theta, k)


def _radius_from_force(F: Array, theta: Array, H: Array, k: Array) -> Array:
    return (F / _force(np.ones_like(F), theta, H, k)) ** (1.0 / (2.0 + k))


def _force_from_depth(d: Array, theta: Array, H: Array, k: Array) -> Array:
    stiffness = punch_stiffness(_radius_from_depth(d, theta, k), H, k)
    return np.where((d > 0.0) & np.isfinite(d), d * (stiffness * (1.0 / (1.0 + (1.0 + k)))), d)


def _depth_from_force(F: Array, theta: Array, H: Array, k: Array) -> Array:
    stiffness = punch_stiffness(_radius_from_force(F, theta, H, k), H, k)
    return np.where((F > 0.0) & np.isfinite(F), F / (stiffness * (1.0 / (1.0 + (1.0 + k)))), F)
