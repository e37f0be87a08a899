"""Flat punch in torsion.

The elementary building block: every other contact is a superposition of flat punches.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from .._runtime.interface import Array, Result, elementwise, require
from .._runtime.physics.torsion import TorsionStress, on_cylinders, on_planes, turned_below

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["displacement", "stress", "torque"]


def __dir__() -> list[str]:
    return __all__


def torque(beta: ArrayLike, *, a: ArrayLike, G: ArrayLike) -> Result:
    """Torque that turns the punch by the angle beta.

    torque = 16*G*a**3*beta/3

    Parameters
    ----------
    beta : array_like
        Angle by which the punch turns [rad].
    a : array_like
        Contact radius [m], a > 0.
    G : array_like
        Shear modulus of the half-space [Pa], G > 0.

    Returns
    -------
    float or ndarray
        Torque about the axis [N m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for sharp edge, frictionless; the normal load is held while the angle grows. Negative or NaN field
    values give NaN. Handbook: flat_punch.tor.M.

    References
    ----------
    Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.torsion import flat_punch
    >>> value = flat_punch.torque(0.1, a=1.0, G=0.4)
    >>> round(value, 6)
    0.213333
    """
    require(a=a, G=G)
    return elementwise(_torque, beta, a=a, G=G)


def displacement(r: ArrayLike, z: ArrayLike, *, a: ArrayLike, beta: ArrayLike) -> Result:
    """Circumferential displacement, below the surface too.

    around = 2*r*beta*(-sqrt(2)*a*sqrt(-a**2 + r**2 + z**2 + sqrt(4*a**2*z**2 + (-a**2 + r**2 +
    z**2)**2))/(a**2 + r**2 + z**2 + sqrt(4*a**2*z**2 + (-a**2 + r**2 + z**2)**2)) + asin(sqrt(2)*a/sqrt(a**2
    + r**2 + z**2 + sqrt(4*a**2*z**2 + (-a**2 + r**2 + z**2)**2))))/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    z : array_like
        Depth below the surface [m].
    a : array_like
        Contact radius [m], a > 0.
    beta : array_like
        Angle by which the punch turns [rad], twist >= 0.

    Returns
    -------
    float or ndarray
        Circumferential displacement [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for sharp edge, frictionless; the normal load is held while the angle grows. Negative or NaN field
    values give NaN. Handbook: flat_punch.tor.ut.

    References
    ----------
    Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.torsion import flat_punch
    >>> value = flat_punch.displacement(0.3, 0.5, a=1.0, beta=0.1)
    >>> round(value, 6)
    0.013054
    """
    require(a=a, twist=beta)
    return elementwise(_displacement, r, z, a=a, beta=beta)


def stress(r: ArrayLike, z: ArrayLike, *, a: ArrayLike, G: ArrayLike, beta: ArrayLike) -> TorsionStress:
    """Shear stresses on planes z and on cylinders r, below the surface too.

    shear_tz = -4*sqrt(2)*G*a**2*r*beta*sqrt(a**2 - r**2 - z**2 + sqrt(4*a**2*z**2 + (-a**2 + r**2 +
    z**2)**2))/(pi*sqrt(4*a**2*z**2 + (-a**2 + r**2 + z**2)**2)*(a**2 + r**2 + z**2 + sqrt(4*a**2*z**2 +
    (-a**2 + r**2 + z**2)**2)))
    shear_rt = -8*sqrt(2)*G*a**3*r**2*beta*sqrt(-a**2 + r**2 + z**2 + sqrt(4*a**2*z**2 + (-a**2 + r**2 +
    z**2)**2))/(pi*sqrt(4*a**2*z**2 + (-a**2 + r**2 + z**2)**2)*(a**2 + r**2 + z**2 + sqrt(4*a**2*z**2 +
    (-a**2 + r**2 + z**2)**2))**2)

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    z : array_like
        Depth below the surface [m].
    a : array_like
        Contact radius [m], a > 0.
    G : array_like
        Shear modulus of the half-space [Pa], G > 0.
    beta : array_like
        Angle by which the punch turns [rad], twist >= 0.

    Returns
    -------
    TorsionStress
        Named tuple: tz is the circumferential shear stress on planes z [Pa], rt is the circumferential shear
        stress on cylinders r [Pa]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for sharp edge, frictionless; the normal load is held while the angle grows. Negative or NaN field
    values give NaN. Handbook: flat_punch.tor.tz, flat_punch.tor.rt.

    References
    ----------
    Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.torsion import flat_punch
    >>> value = flat_punch.stress(0.3, 0.5, a=1.0, G=0.4, beta=0.1)
    >>> round(value.tz, 6)
    -0.009685
    """
    require(a=a, G=G, twist=beta)
    return TorsionStress(
        elementwise(_stress_tz, r, z, a=a, G=G, beta=beta), elementwise(_stress_rt, r, z, a=a, G=G, beta=beta)
    )


def _torque(beta: Array, a: Array, G: Array) -> Array:
    return 16.0 / 3.0 * G * a**3 * beta


def _displacement(r: Array, z: Array, a: Array, beta: Array) -> Array:
    return beta * turned_below(r, z, a)


def _stress_tz(r: Array, z: Array, a: Array, G: Array, beta: Array) -> Array:
    return G * beta * on_planes(r, z, a)


def _stress_rt(r: Array, z: Array, a: Array, G: Array, beta: Array) -> Array:
    return G * beta * on_cylinders(r, z, a)
