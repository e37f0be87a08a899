"""Power law under a tangential load on a power-law graded half-space.

Every self-similar profile: F ~ d^(1 + 1/n). Cone, paraboloid and quartic are n = 1, 2, 4.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._runtime.interface import Array, Result, either, elementwise, numbers, require, require_order
from ..._runtime.physics.slip import stick_force
from ..normal import power_law as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["full_slip_displacement", "stick_radius", "tangential_displacement", "tangential_force", "traction"]


def __dir__() -> list[str]:
    return __all__


def tangential_force(
    a: ArrayLike, c: ArrayLike, *, A: ArrayLike, n: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential force with a stick zone of radius c.

    F_x = mu*(2*A*H*a**(k + n + 1)*n*gamma((k + 1)/2)*gamma(n/2 + 1)/((k + 1)*(k + n + 1)*gamma((k + n +
    1)/2)) - 2*A*H*c**(k + n + 1)*n*gamma((k + 1)/2)*gamma(n/2 + 1)/((k + 1)*(k + n + 1)*gamma((k + n +
    1)/2)))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.
    mu : array_like
        Coefficient of friction [1], mu >= 0.

    Returns
    -------
    float or ndarray
        Tangential force [N]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes, n A a^(n-1) << 1; Cattaneo-Mindlin approximation. Negative or NaN field values
    give NaN. Handbook: power_law.fgm.tan.F.

    References
    ----------
    chapter 11, equation (11.78); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.tangential import power_law
    >>> value = power_law.tangential_force(1.0, 0.6, A=0.45, n=1.5, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.131858
    """
    require(A=A, n=n, H=H, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_force, a, c, A=A, n=n, H=H, k=k, mu=mu)


def traction(
    r: ArrayLike, a: ArrayLike, c: ArrayLike, *, A: ArrayLike, n: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential traction; zero outside the contact.

    tau = A*H*mu*n*r**(k + n - 1)*IncompleteBeta(1 - r**2/a**2, (k + 1)/2, (-k - n + 1)/2)*gamma((k +
    1)/2)*gamma(n/2 + 1)/(2*pi*gamma((k + n + 1)/2))   for c < r
    tau = mu*(A*H*n*r**(k + n - 1)*IncompleteBeta(1 - r**2/a**2, (k + 1)/2, (-k - n + 1)/2)*gamma((k +
    1)/2)*gamma(n/2 + 1)/(2*pi*gamma((k + n + 1)/2)) - A*H*n*r**(k + n - 1)*IncompleteBeta(1 - r**2/c**2, (k +
    1)/2, (-k - n + 1)/2)*gamma((k + 1)/2)*gamma(n/2 + 1)/(2*pi*gamma((k + n + 1)/2)))   for r < c
    with IncompleteBeta: B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any
    real q

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.
    mu : array_like
        Coefficient of friction [1], mu >= 0.

    Returns
    -------
    float or ndarray
        Tangential traction [Pa]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes, n A a^(n-1) << 1; Cattaneo-Mindlin approximation. Negative or NaN field values
    give NaN. Handbook: power_law.fgm.tan.tau.

    References
    ----------
    chapter 11, equation (11.79); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.tangential import power_law
    >>> value = power_law.traction(0.3, 1.0, 0.6, A=0.45, n=1.5, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.043182
    """
    require(A=A, n=n, H=H, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_traction, r, a, c, A=A, n=n, H=H, k=k, mu=mu)


def tangential_displacement(
    a: ArrayLike, c: ArrayLike, *, A: ArrayLike, n: ArrayLike, H: ArrayLike, H_x: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement of the indenter with a stick zone of radius c.

    u_0 = H*mu*(A*a**n*gamma((k + 1)/2)*gamma(n/2 + 1)/gamma((k + n + 1)/2) - A*c**n*gamma((k +
    1)/2)*gamma(n/2 + 1)/gamma((k + n + 1)/2))/H_x

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    H_x : array_like
        Tangential foundation modulus, c_T(x) = H_x |x|^k [Pa m^(-k)], H_x > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.
    mu : array_like
        Coefficient of friction [1], mu >= 0.

    Returns
    -------
    float or ndarray
        Tangential displacement of the rigid body [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes, n A a^(n-1) << 1; Cattaneo-Mindlin approximation. Negative or NaN field values
    give NaN. Handbook: power_law.fgm.tan.u.

    References
    ----------
    chapter 11, equation (11.80); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.tangential import power_law
    >>> value = power_law.tangential_displacement(1.0, 0.6, A=0.45, n=1.5, H=1.0, H_x=0.8, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.133963
    """
    require(A=A, n=n, H=H, H_x=H_x, k=k, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return elementwise(_tangential_displacement, a, c, A=A, n=n, H=H, H_x=H_x, k=k, mu=mu)


def stick_radius(
    F_x: ArrayLike, a: ArrayLike, *, A: ArrayLike, n: ArrayLike, H: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Radius of the stick zone under a tangential force; NaN beyond full slip.

    c = a*(1 - F_x*a**(-k - n - 1)*(k + 1)*(k + n + 1)*gamma((k + n + 1)/2)/(2*A*H*mu*n*gamma((k +
    1)/2)*gamma(n/2 + 1)))**(1/(k + n + 1))

    Parameters
    ----------
    F_x : array_like
        Tangential force [N].
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.
    mu : array_like
        Coefficient of friction [1], mu >= 0.

    Returns
    -------
    float or ndarray
        Radius of the stick zone [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes, n A a^(n-1) << 1; Cattaneo-Mindlin approximation. Negative or NaN field values
    give NaN. Handbook: power_law.fgm.tan.c.

    References
    ----------
    chapter 11, equation (11.78); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.tangential import power_law
    >>> value = power_law.stick_radius(0.1319, 1.0, A=0.45, n=1.5, H=1.0, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.599788
    """
    require(A=A, n=n, H=H, k=k, mu=mu)
    return elementwise(_stick_radius, F_x, a, A=A, n=n, H=H, k=k, mu=mu)


def full_slip_displacement(
    a: ArrayLike, *, A: ArrayLike, n: ArrayLike, H: ArrayLike, H_x: ArrayLike, k: ArrayLike, mu: ArrayLike
) -> Result:
    """Tangential displacement at the onset of full slip.

    u_0 = A*H*a**n*mu*gamma((k + 1)/2)*gamma(n/2 + 1)/(H_x*gamma((k + n + 1)/2))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    A : array_like
        Coefficient of a power-law profile [m^(1-n)], A > 0.
    n : array_like
        Exponent of the profile [1], n > 0.
    H : array_like
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)], H > 0.
    H_x : array_like
        Tangential foundation modulus, c_T(x) = H_x |x|^k [Pa m^(-k)], H_x > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.
    mu : array_like
        Coefficient of friction [1], mu >= 0.

    Returns
    -------
    float or ndarray
        Tangential displacement of the rigid body [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for small slopes, n A a^(n-1) << 1; Cattaneo-Mindlin approximation. Negative or NaN field values
    give NaN. Handbook: power_law.fgm.tan.us.

    References
    ----------
    chapter 11, equation (11.80); Galin 1946; Sneddon 1965.

    Examples
    --------
    >>> from axicontact.graded.tangential import power_law
    >>> value = power_law.full_slip_displacement(1.0, A=0.45, n=1.5, H=1.0, H_x=0.8, k=0.25, mu=0.3)
    >>> round(value, 6)
    0.250285
    """
    require(A=A, n=n, H=H, H_x=H_x, k=k, mu=mu)
    return elementwise(_full_slip_displacement, a, A=A, n=n, H=H, H_x=H_x, k=k, mu=mu)


def _tangential_force(a: Array, c: Array, A: Array, n: Array, H: Array, k: Array, mu: Array) -> Array:
    from ..._runtime.graded.slip import power_gain

    gain = A * power_gain("force", 0.0, c, a, n, k)
    return mu * (2.0 * H / (1.0 + k)) * gain


def _traction(r: Array, a: Array, c: Array, A: Array, n: Array, H: Array, k: Array, mu: Array) -> Array:
    from ..._runtime.graded.slip import power_gain

    def gain() -> Array:
        inside = np.minimum(r, c)
        return A * power_gain("pressure", inside, c, a, n, k)

    return mu * either(r < c, lambda: H / np.pi * gain(), lambda: normal._pressure(r, a, A, n, H, k))


def _tangential_displacement(
    a: Array, c: Array, A: Array, n: Array, H: Array, H_x: Array, k: Array, mu: Array
) -> Array:
    from ..._runtime.graded.slip import power_gain

    gain = A * power_gain("depth", 0.0, c, a, n, k)
    return mu * (H / H_x) * gain


def _stick_radius(F_x: Array, a: Array, A: Array, n: Array, H: Array, k: Array, mu: Array) -> Array:
    F = stick_force(normal._force(a, A, n, H, k), F_x, mu)
    return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force(F, A, n, H, k))


def _full_slip_displacement(a: Array, A: Array, n: Array, H: Array, H_x: Array, k: Array, mu: Array) -> Array:
    return mu * (H / H_x) * normal._depth(a, A, n, k)
