"""Flat punch on a layer.

The elementary building block: every other contact is a superposition of flat punches.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from .._runtime.interface import Array, Result, elementwise, require
from .._runtime.physics.layer import State, added_pressure, number_of, of_states, on_layer, require_base
from ..normal import flat_punch as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["depth_from_force", "force", "pressure"]


def __dir__() -> list[str]:
    return __all__


def force(
    d: ArrayLike, *, a: ArrayLike, E_star: ArrayLike, nu: ArrayLike, thickness: ArrayLike, base: str = "bonded"
) -> Result:
    """Normal force.

    F = 2*E_star*Integral(q(t), (t, 0, a))

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    nu : array_like
        Poisson ratio [1], -1 < nu <= 1/2.
    thickness : array_like
        Thickness of the layer [m], thickness > 0.
    base : {"bonded", "frictionless"}
        How the layer lies on what is below it.

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
    The springs below the surface are pressed in by q(t) = d - g(t) + Integral(K(t, s)*q(s), (s, 0, a)), zero
    beyond t = a; K(t, s) = 2*Integral((1 - L(u))*cos(s*u/thickness)*cos(t*u/thickness), (u, 0,
    oo))/(pi*thickness), L how far a wave moves a layer, over a half-space. Valid for sharp edge,
    frictionless; the indenter and the base are rigid, E_star = E/(1 - nu^2) is that of the layer. One linear
    system for each contact, a <= 20 thickness. Negative or NaN field values give NaN. Handbook:
    flat_punch.lay.F.

    References
    ----------
    Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.layer import flat_punch
    >>> value = flat_punch.force(0.25, a=1.0, E_star=1.0, nu=0.3, thickness=2.0)
    >>> round(value, 6)
    0.812013
    """
    require(a=a, E_star=E_star, nu=nu, thickness=thickness)
    require_base(base)
    return elementwise(partial(_force, base=base), d, a=a, E_star=E_star, nu=nu, thickness=thickness)


def pressure(
    r: ArrayLike,
    d: ArrayLike,
    *,
    a: ArrayLike,
    E_star: ArrayLike,
    nu: ArrayLike,
    thickness: ArrayLike,
    base: str = "bonded",
) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = E_star*(-Integral(Derivative(q(t), t)/sqrt(-r**2 + t**2), (t, r, a)) + q(a)/sqrt(a**2 - r**2))/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    d : array_like
        Indentation depth of the point r = 0 [m].
    a : array_like
        Contact radius [m], a > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    nu : array_like
        Poisson ratio [1], -1 < nu <= 1/2.
    thickness : array_like
        Thickness of the layer [m], thickness > 0.
    base : {"bonded", "frictionless"}
        How the layer lies on what is below it.

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
    The springs below the surface are pressed in by q(t) = d - g(t) + Integral(K(t, s)*q(s), (s, 0, a)), zero
    beyond t = a; K(t, s) = 2*Integral((1 - L(u))*cos(s*u/thickness)*cos(t*u/thickness), (u, 0,
    oo))/(pi*thickness), L how far a wave moves a layer, over a half-space. Valid for sharp edge,
    frictionless; the indenter and the base are rigid, E_star = E/(1 - nu^2) is that of the layer. One linear
    system for each contact, a <= 20 thickness. Negative or NaN field values give NaN. Handbook:
    flat_punch.lay.p.

    References
    ----------
    Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.layer import flat_punch
    >>> value = flat_punch.pressure(0.3, 0.25, a=1.0, E_star=1.0, nu=0.3, thickness=2.0)
    >>> round(value, 6)
    0.14673
    """
    require(a=a, E_star=E_star, nu=nu, thickness=thickness)
    require_base(base)
    return elementwise(partial(_pressure, base=base), r, d, a=a, E_star=E_star, nu=nu, thickness=thickness)


def depth_from_force(
    F: ArrayLike, *, a: ArrayLike, E_star: ArrayLike, nu: ArrayLike, thickness: ArrayLike, base: str = "bonded"
) -> Result:
    """Indentation depth under the normal force F.

    d from 2*E_star*Integral(q(t), (t, 0, a)) = F

    Parameters
    ----------
    F : array_like
        Normal force [N].
    a : array_like
        Contact radius [m], a > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    nu : array_like
        Poisson ratio [1], -1 < nu <= 1/2.
    thickness : array_like
        Thickness of the layer [m], thickness > 0.
    base : {"bonded", "frictionless"}
        How the layer lies on what is below it.

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
    The springs below the surface are pressed in by q(t) = d - g(t) + Integral(K(t, s)*q(s), (s, 0, a)), zero
    beyond t = a; K(t, s) = 2*Integral((1 - L(u))*cos(s*u/thickness)*cos(t*u/thickness), (u, 0,
    oo))/(pi*thickness), L how far a wave moves a layer, over a half-space. Valid for sharp edge,
    frictionless; the indenter and the base are rigid, E_star = E/(1 - nu^2) is that of the layer. One linear
    system for each contact, a <= 20 thickness. Negative or NaN field values give NaN. Handbook:
    flat_punch.lay.dF.

    References
    ----------
    Boussinesq 1885; Schubert 1942.

    Examples
    --------
    >>> from axicontact.layer import flat_punch
    >>> value = flat_punch.depth_from_force(0.8120127066068663, a=1.0, E_star=1.0, nu=0.3, thickness=2.0)
    >>> round(value, 6)
    0.25
    """
    require(a=a, E_star=E_star, nu=nu, thickness=thickness)
    require_base(base)
    return elementwise(partial(_depth_from_force, base=base), F, a=a, E_star=E_star, nu=nu, thickness=thickness)


@of_states
def _contact(a: Array, nu: Array, thickness: Array, base: str) -> State:
    """What the layer changes of a contact of radius a."""
    return on_layer(a, thickness, nu, base)


def _force(d: Array, a: Array, E_star: Array, nu: Array, thickness: Array, base: str) -> Array:
    found = _contact(a, nu, thickness, base)
    return E_star * d * number_of(found, "stiffness")


def _pressure(r: Array, d: Array, a: Array, E_star: Array, nu: Array, thickness: Array, base: str) -> Array:
    found = _contact(a, nu, thickness, base)
    return normal._pressure(r, d, a, E_star) * number_of(found, "edge") + E_star * d * added_pressure(found, r)


def _depth_from_force(F: Array, a: Array, E_star: Array, nu: Array, thickness: Array, base: str) -> Array:
    found = _contact(a, nu, thickness, base)
    return F / (E_star * number_of(found, "stiffness"))
