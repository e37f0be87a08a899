"""Curved punch with a rounded edge on a layer.

A paraboloid of radius R1 whose edge is rounded off from r = b on with the radius R2.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, elementwise, require
from .._runtime.physics.adhesion import tension
from .._runtime.physics.layer import (
    State,
    added_pressure,
    below_punch,
    number_of,
    of_states,
    on_layer,
    radius_on_layer,
    require_base,
    retraction_on_layer,
    wave_sum,
)
from ..normal import rounded_curved_punch as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "adhesive_depth",
    "adhesive_force",
    "adhesive_pressure",
    "depth",
    "depth_first_order",
    "depth_from_force",
    "force",
    "force_from_depth",
    "force_second_order",
    "pressure",
    "radius_from_depth",
    "radius_from_force",
]


def __dir__() -> list[str]:
    return __all__


def depth(
    a: ArrayLike,
    *,
    R1: ArrayLike,
    R2: ArrayLike,
    b: ArrayLike,
    nu: ArrayLike,
    thickness: ArrayLike,
    base: str = "bonded",
) -> Result:
    """Indentation depth at contact radius a.

    d = g(a) - Integral(K(a, t)*q(t), (t, 0, a))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    at t = a; K(t, s) = 2*Integral((1 - L(u))*cos(s*u/thickness)*cos(t*u/thickness), (u, 0,
    oo))/(pi*thickness), L how far a wave moves a layer, over a half-space. Valid for a << R1, a - b << R2;
    the indenter and the base are rigid, E_star = E/(1 - nu^2) is that of the layer. One linear system for
    each contact, a <= 20 thickness. Negative or NaN field values give NaN. Handbook:
    rounded_curved_punch.lay.d.

    Examples
    --------
    >>> from axicontact.layer import rounded_curved_punch
    >>> value = rounded_curved_punch.depth(1.5, R1=6.0, R2=1.2, b=1.0, nu=0.3, thickness=2.0)
    >>> round(value, 6)
    0.466668
    """
    require(R1=R1, R2=R2, b=b, nu=nu, thickness=thickness)
    require_base(base)
    return elementwise(partial(_depth, base=base), a, R1=R1, R2=R2, b=b, nu=nu, thickness=thickness)


def force(
    a: ArrayLike,
    *,
    R1: ArrayLike,
    R2: ArrayLike,
    b: ArrayLike,
    E_star: ArrayLike,
    nu: ArrayLike,
    thickness: ArrayLike,
    base: str = "bonded",
) -> Result:
    """Normal force.

    F = 2*E_star*Integral(q(t), (t, 0, a))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    at t = a; K(t, s) = 2*Integral((1 - L(u))*cos(s*u/thickness)*cos(t*u/thickness), (u, 0,
    oo))/(pi*thickness), L how far a wave moves a layer, over a half-space. Valid for a << R1, a - b << R2;
    the indenter and the base are rigid, E_star = E/(1 - nu^2) is that of the layer. One linear system for
    each contact, a <= 20 thickness. Negative or NaN field values give NaN. Handbook:
    rounded_curved_punch.lay.F.

    Examples
    --------
    >>> from axicontact.layer import rounded_curved_punch
    >>> value = rounded_curved_punch.force(1.5, R1=6.0, R2=1.2, b=1.0, E_star=1.0, nu=0.3, thickness=2.0)
    >>> round(value, 6)
    1.87736
    """
    require(R1=R1, R2=R2, b=b, E_star=E_star, nu=nu, thickness=thickness)
    require_base(base)
    return elementwise(partial(_force, base=base), a, R1=R1, R2=R2, b=b, E_star=E_star, nu=nu, thickness=thickness)


def pressure(
    r: ArrayLike,
    a: ArrayLike,
    *,
    R1: ArrayLike,
    R2: ArrayLike,
    b: ArrayLike,
    E_star: ArrayLike,
    nu: ArrayLike,
    thickness: ArrayLike,
    base: str = "bonded",
) -> Result:
    """Contact pressure, positive in compression; zero outside the contact.

    p = -E_star*Integral(Derivative(q(t), t)/sqrt(-r**2 + t**2), (t, r, a))/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    at t = a; K(t, s) = 2*Integral((1 - L(u))*cos(s*u/thickness)*cos(t*u/thickness), (u, 0,
    oo))/(pi*thickness), L how far a wave moves a layer, over a half-space. Valid for a << R1, a - b << R2;
    the indenter and the base are rigid, E_star = E/(1 - nu^2) is that of the layer. One linear system for
    each contact, a <= 20 thickness. Negative or NaN field values give NaN. Handbook:
    rounded_curved_punch.lay.p.

    Examples
    --------
    >>> from axicontact.layer import rounded_curved_punch
    >>> value = rounded_curved_punch.pressure(0.45, 1.5, R1=6.0, R2=1.2, b=1.0, E_star=1.0, nu=0.3, thickness=2.0)
    >>> round(value, 6)
    0.291155
    """
    require(R1=R1, R2=R2, b=b, E_star=E_star, nu=nu, thickness=thickness)
    require_base(base)
    return elementwise(
        partial(_pressure, base=base), r, a, R1=R1, R2=R2, b=b, E_star=E_star, nu=nu, thickness=thickness
    )


def radius_from_depth(
    d: ArrayLike,
    *,
    R1: ArrayLike,
    R2: ArrayLike,
    b: ArrayLike,
    nu: ArrayLike,
    thickness: ArrayLike,
    base: str = "bonded",
) -> Result:
    """Contact radius at indentation depth d.

    a from g(a) - Integral(K(a, t)*q(t), (t, 0, a)) = d

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
    nu : array_like
        Poisson ratio [1], -1 < nu <= 1/2.
    thickness : array_like
        Thickness of the layer [m], thickness > 0.
    base : {"bonded", "frictionless"}
        How the layer lies on what is below it.

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
    The springs below the surface are pressed in by q(t) = d - g(t) + Integral(K(t, s)*q(s), (s, 0, a)), zero
    at t = a; K(t, s) = 2*Integral((1 - L(u))*cos(s*u/thickness)*cos(t*u/thickness), (u, 0,
    oo))/(pi*thickness), L how far a wave moves a layer, over a half-space. Valid for a << R1, a - b << R2;
    the indenter and the base are rigid, E_star = E/(1 - nu^2) is that of the layer. One linear system for
    each contact, a <= 20 thickness. Negative or NaN field values give NaN. Handbook:
    rounded_curved_punch.lay.ad.

    Examples
    --------
    >>> from axicontact.layer import rounded_curved_punch
    >>> value = rounded_curved_punch.radius_from_depth(
    ...     0.46666760942117086, R1=6.0, R2=1.2, b=1.0, nu=0.3, thickness=2.0
    ... )
    >>> round(value, 6)
    1.5
    """
    require(R1=R1, R2=R2, b=b, nu=nu, thickness=thickness)
    require_base(base)
    return elementwise(partial(_radius_from_depth, base=base), d, R1=R1, R2=R2, b=b, nu=nu, thickness=thickness)


def radius_from_force(
    F: ArrayLike,
    *,
    R1: ArrayLike,
    R2: ArrayLike,
    b: ArrayLike,
    E_star: ArrayLike,
    nu: ArrayLike,
    thickness: ArrayLike,
    base: str = "bonded",
) -> Result:
    """Contact radius under the normal force F.

    a from 2*E_star*Integral(q(t), (t, 0, a)) = F

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
        Contact radius [m]. The shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    The springs below the surface are pressed in by q(t) = d - g(t) + Integral(K(t, s)*q(s), (s, 0, a)), zero
    at t = a; K(t, s) = 2*Integral((1 - L(u))*cos(s*u/thickness)*cos(t*u/thickness), (u, 0,
    oo))/(pi*thickness), L how far a wave moves a layer, over a half-space. Valid for a << R1, a - b << R2;
    the indenter and the base are rigid, E_star = E/(1 - nu^2) is that of the layer. One linear system for
    each contact, a <= 20 thickness. Negative or NaN field values give NaN. Handbook:
    rounded_curved_punch.lay.aF.

    Examples
    --------
    >>> from axicontact.layer import rounded_curved_punch
    >>> value = rounded_curved_punch.radius_from_force(
    ...     1.8773597191833584, R1=6.0, R2=1.2, b=1.0, E_star=1.0, nu=0.3, thickness=2.0
    ... )
    >>> round(value, 6)
    1.5
    """
    require(R1=R1, R2=R2, b=b, E_star=E_star, nu=nu, thickness=thickness)
    require_base(base)
    return elementwise(
        partial(_radius_from_force, base=base), F, R1=R1, R2=R2, b=b, E_star=E_star, nu=nu, thickness=thickness
    )


def force_from_depth(
    d: ArrayLike,
    *,
    R1: ArrayLike,
    R2: ArrayLike,
    b: ArrayLike,
    E_star: ArrayLike,
    nu: ArrayLike,
    thickness: ArrayLike,
    base: str = "bonded",
) -> Result:
    """Normal force at indentation depth d.

    F = 2*E_star*Integral(q(t), (t, 0, a))

    Parameters
    ----------
    d : array_like
        Indentation depth of the point r = 0 [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    at t = a; K(t, s) = 2*Integral((1 - L(u))*cos(s*u/thickness)*cos(t*u/thickness), (u, 0,
    oo))/(pi*thickness), L how far a wave moves a layer, over a half-space. Valid for a << R1, a - b << R2;
    the indenter and the base are rigid, E_star = E/(1 - nu^2) is that of the layer. One linear system for
    each contact, a <= 20 thickness. Negative or NaN field values give NaN. Handbook:
    rounded_curved_punch.lay.Fd.

    Examples
    --------
    >>> from axicontact.layer import rounded_curved_punch
    >>> value = rounded_curved_punch.force_from_depth(
    ...     0.46666760942117086, R1=6.0, R2=1.2, b=1.0, E_star=1.0, nu=0.3, thickness=2.0
    ... )
    >>> round(value, 6)
    1.87736
    """
    require(R1=R1, R2=R2, b=b, E_star=E_star, nu=nu, thickness=thickness)
    require_base(base)
    return elementwise(
        partial(_force_from_depth, base=base), d, R1=R1, R2=R2, b=b, E_star=E_star, nu=nu, thickness=thickness
    )


def depth_from_force(
    F: ArrayLike,
    *,
    R1: ArrayLike,
    R2: ArrayLike,
    b: ArrayLike,
    E_star: ArrayLike,
    nu: ArrayLike,
    thickness: ArrayLike,
    base: str = "bonded",
) -> Result:
    """Indentation depth under the normal force F.

    d = g(a) - Integral(K(a, t)*q(t), (t, 0, a))

    Parameters
    ----------
    F : array_like
        Normal force [N].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    at t = a; K(t, s) = 2*Integral((1 - L(u))*cos(s*u/thickness)*cos(t*u/thickness), (u, 0,
    oo))/(pi*thickness), L how far a wave moves a layer, over a half-space. Valid for a << R1, a - b << R2;
    the indenter and the base are rigid, E_star = E/(1 - nu^2) is that of the layer. One linear system for
    each contact, a <= 20 thickness. Negative or NaN field values give NaN. Handbook:
    rounded_curved_punch.lay.dF.

    Examples
    --------
    >>> from axicontact.layer import rounded_curved_punch
    >>> value = rounded_curved_punch.depth_from_force(
    ...     1.8773597191833584, R1=6.0, R2=1.2, b=1.0, E_star=1.0, nu=0.3, thickness=2.0
    ... )
    >>> round(value, 6)
    0.466668
    """
    require(R1=R1, R2=R2, b=b, E_star=E_star, nu=nu, thickness=thickness)
    require_base(base)
    return elementwise(
        partial(_depth_from_force, base=base), F, R1=R1, R2=R2, b=b, E_star=E_star, nu=nu, thickness=thickness
    )


def depth_first_order(
    a: ArrayLike,
    *,
    R1: ArrayLike,
    R2: ArrayLike,
    b: ArrayLike,
    nu: ArrayLike,
    thickness: ArrayLike,
    base: str = "bonded",
) -> Result:
    """Indentation depth on a thick layer to the first order, under the force of the half-space.

    d = g(a) - m_0*F(a)/(pi*E_star*thickness)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    G and F are those of the half-space, m_0 = Integral(1 - L(u), (u, 0, oo)), L how far a wave moves a layer,
    over a half-space. What is left out is a share of the order of (a/thickness)^3: -0.93 % at thickness = 5 a
    on a bonded base for nu = 1/2, which is the stiffest, by the solution of the equation. Valid for a << R1,
    a - b << R2 and a << thickness; the indenter and the base are rigid, E_star = E/(1 - nu^2) is that of the
    layer. Negative or NaN field values give NaN. Handbook: rounded_curved_punch.lay.d1.

    Examples
    --------
    >>> from axicontact.layer import rounded_curved_punch
    >>> value = rounded_curved_punch.depth_first_order(1.5, R1=6.0, R2=1.2, b=1.0, nu=0.3, thickness=2.0)
    >>> round(value, 6)
    0.35799
    """
    require(R1=R1, R2=R2, b=b, nu=nu, thickness=thickness)
    require_base(base)
    return elementwise(partial(_depth_first_order, base=base), a, R1=R1, R2=R2, b=b, nu=nu, thickness=thickness)


def force_second_order(
    a: ArrayLike,
    *,
    R1: ArrayLike,
    R2: ArrayLike,
    b: ArrayLike,
    E_star: ArrayLike,
    nu: ArrayLike,
    thickness: ArrayLike,
    base: str = "bonded",
) -> Result:
    """Normal force on a thick layer to the second order.

    F = (2*a**3*m_2/(3*pi*thickness**3) + 1)*F(a)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
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
    G and F are those of the half-space, m_2 = Integral(u**2*(1 - L(u)), (u, 0, oo)), L how far a wave moves a
    layer, over a half-space. What is left out is a share of the order of (a/thickness)^5: +0.035 % at
    thickness = 5 a on a bonded base for nu = 1/2, which is the stiffest, by the solution of the equation.
    Valid for a << R1, a - b << R2 and a << thickness; the indenter and the base are rigid, E_star = E/(1 -
    nu^2) is that of the layer. Negative or NaN field values give NaN. Handbook: rounded_curved_punch.lay.F2.

    Examples
    --------
    >>> from axicontact.layer import rounded_curved_punch
    >>> value = rounded_curved_punch.force_second_order(
    ...     1.5, R1=6.0, R2=1.2, b=1.0, E_star=1.0, nu=0.3, thickness=2.0
    ... )
    >>> round(value, 6)
    2.030002
    """
    require(R1=R1, R2=R2, b=b, E_star=E_star, nu=nu, thickness=thickness)
    require_base(base)
    return elementwise(
        partial(_force_second_order, base=base), a, R1=R1, R2=R2, b=b, E_star=E_star, nu=nu, thickness=thickness
    )


def adhesive_depth(
    a: ArrayLike,
    *,
    R1: ArrayLike,
    R2: ArrayLike,
    b: ArrayLike,
    E_star: ArrayLike,
    nu: ArrayLike,
    thickness: ArrayLike,
    dgamma: ArrayLike,
    base: str = "bonded",
) -> Result:
    """Indentation depth at contact radius a with short-ranged adhesion (JKR).

    d = g(a) - Integral(K(a, t)*q(t), (t, 0, a)) - sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star)

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    nu : array_like
        Poisson ratio [1], -1 < nu <= 1/2.
    thickness : array_like
        Thickness of the layer [m], thickness > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.
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
    The springs below the surface are pressed in by q(t) = d - g(t) + Integral(K(t, s)*q(s), (s, 0, a)),
    -sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star) at t = a; K(t, s) = 2*Integral((1 -
    L(u))*cos(s*u/thickness)*cos(t*u/thickness), (u, 0, oo))/(pi*thickness), L how far a wave moves a layer,
    over a half-space. Valid for a << R1, a - b << R2; the indenter and the base are rigid, E_star = E/(1 -
    nu^2) is that of the layer. One linear system for each contact, a <= 20 thickness. Negative or NaN field
    values give NaN. Handbook: rounded_curved_punch.lay.dadh.

    Examples
    --------
    >>> from axicontact.layer import rounded_curved_punch
    >>> value = rounded_curved_punch.adhesive_depth(
    ...     1.5, R1=6.0, R2=1.2, b=1.0, E_star=1.0, nu=0.3, thickness=2.0, dgamma=0.01
    ... )
    >>> round(value, 6)
    0.298661
    """
    require(R1=R1, R2=R2, b=b, E_star=E_star, nu=nu, thickness=thickness, dgamma=dgamma)
    require_base(base)
    return elementwise(
        partial(_adhesive_depth, base=base),
        a,
        R1=R1,
        R2=R2,
        b=b,
        E_star=E_star,
        nu=nu,
        thickness=thickness,
        dgamma=dgamma,
    )


def adhesive_force(
    a: ArrayLike,
    *,
    R1: ArrayLike,
    R2: ArrayLike,
    b: ArrayLike,
    E_star: ArrayLike,
    nu: ArrayLike,
    thickness: ArrayLike,
    dgamma: ArrayLike,
    base: str = "bonded",
) -> Result:
    """Normal force at contact radius a with short-ranged adhesion (JKR).

    F = 2*E_star*Integral(q(t), (t, 0, a))

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    nu : array_like
        Poisson ratio [1], -1 < nu <= 1/2.
    thickness : array_like
        Thickness of the layer [m], thickness > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.
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
    The springs below the surface are pressed in by q(t) = d - g(t) + Integral(K(t, s)*q(s), (s, 0, a)),
    -sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star) at t = a; K(t, s) = 2*Integral((1 -
    L(u))*cos(s*u/thickness)*cos(t*u/thickness), (u, 0, oo))/(pi*thickness), L how far a wave moves a layer,
    over a half-space. Valid for a << R1, a - b << R2; the indenter and the base are rigid, E_star = E/(1 -
    nu^2) is that of the layer. One linear system for each contact, a <= 20 thickness. Negative or NaN field
    values give NaN. Handbook: rounded_curved_punch.lay.Fadh.

    Examples
    --------
    >>> from axicontact.layer import rounded_curved_punch
    >>> value = rounded_curved_punch.adhesive_force(
    ...     1.5, R1=6.0, R2=1.2, b=1.0, E_star=1.0, nu=0.3, thickness=2.0, dgamma=0.01
    ... )
    >>> round(value, 6)
    0.849791
    """
    require(R1=R1, R2=R2, b=b, E_star=E_star, nu=nu, thickness=thickness, dgamma=dgamma)
    require_base(base)
    return elementwise(
        partial(_adhesive_force, base=base),
        a,
        R1=R1,
        R2=R2,
        b=b,
        E_star=E_star,
        nu=nu,
        thickness=thickness,
        dgamma=dgamma,
    )


def adhesive_pressure(
    r: ArrayLike,
    a: ArrayLike,
    *,
    R1: ArrayLike,
    R2: ArrayLike,
    b: ArrayLike,
    E_star: ArrayLike,
    nu: ArrayLike,
    thickness: ArrayLike,
    dgamma: ArrayLike,
    base: str = "bonded",
) -> Result:
    """Contact pressure with short-ranged adhesion (JKR); infinite at the edge, zero outside.

    p = E_star*(-Integral(Derivative(q(t), t)/sqrt(-r**2 + t**2), (t, r, a)) + q(a)/sqrt(a**2 - r**2))/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R1 : array_like
        Radius of curvature of the inner part [m], R1 > 0.
    R2 : array_like
        Radius of curvature of the outer part [m], R2 > 0.
    b : array_like
        Radius at which the profile breaks, or its length across [m], b > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    nu : array_like
        Poisson ratio [1], -1 < nu <= 1/2.
    thickness : array_like
        Thickness of the layer [m], thickness > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.
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
    The springs below the surface are pressed in by q(t) = d - g(t) + Integral(K(t, s)*q(s), (s, 0, a)),
    -sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star) at t = a; K(t, s) = 2*Integral((1 -
    L(u))*cos(s*u/thickness)*cos(t*u/thickness), (u, 0, oo))/(pi*thickness), L how far a wave moves a layer,
    over a half-space. Valid for a << R1, a - b << R2; the indenter and the base are rigid, E_star = E/(1 -
    nu^2) is that of the layer. One linear system for each contact, a <= 20 thickness. Negative or NaN field
    values give NaN. Handbook: rounded_curved_punch.lay.padh.

    Examples
    --------
    >>> from axicontact.layer import rounded_curved_punch
    >>> value = rounded_curved_punch.adhesive_pressure(
    ...     0.45, 1.5, R1=6.0, R2=1.2, b=1.0, E_star=1.0, nu=0.3, thickness=2.0, dgamma=0.01
    ... )
    >>> round(value, 6)
    0.199675
    """
    require(R1=R1, R2=R2, b=b, E_star=E_star, nu=nu, thickness=thickness, dgamma=dgamma)
    require_base(base)
    return elementwise(
        partial(_adhesive_pressure, base=base),
        r,
        a,
        R1=R1,
        R2=R2,
        b=b,
        E_star=E_star,
        nu=nu,
        thickness=thickness,
        dgamma=dgamma,
    )


@of_states
def _contact(a: Array, R1: Array, R2: Array, b: Array, nu: Array, thickness: Array, base: str) -> State:
    """What the layer changes of a contact of radius a."""
    return on_layer(a, thickness, nu, base, lambda t: normal._depth(t, R1, R2, b), (b,))


def _depth(a: Array, R1: Array, R2: Array, b: Array, nu: Array, thickness: Array, base: str) -> Array:
    found = _contact(a, R1, R2, b, nu, thickness, base)
    return normal._depth(a, R1, R2, b) - number_of(found, "less")


def _force(a: Array, R1: Array, R2: Array, b: Array, E_star: Array, nu: Array, thickness: Array, base: str) -> Array:
    found = _contact(a, R1, R2, b, nu, thickness, base)
    return normal._force(a, R1, R2, b, E_star) + E_star * number_of(found, "more")


def _pressure(
    r: Array, a: Array, R1: Array, R2: Array, b: Array, E_star: Array, nu: Array, thickness: Array, base: str
) -> Array:
    found = _contact(a, R1, R2, b, nu, thickness, base)
    return normal._pressure(r, a, R1, R2, b, E_star) + E_star * added_pressure(found, r)


def _radius_from_depth(d: Array, R1: Array, R2: Array, b: Array, nu: Array, thickness: Array, base: str) -> Array:
    def curve(t: Array) -> tuple[Array, Array]:
        found = _contact(t, R1, R2, b, nu, thickness, base)
        value = normal._depth(t, R1, R2, b) - number_of(found, "less")
        return value, t * number_of(found, "rate") / value

    return radius_on_layer(curve, d, normal._radius_from_depth(d, R1, R2, b), thickness, np.inf, False)


def _radius_from_force(
    F: Array, R1: Array, R2: Array, b: Array, E_star: Array, nu: Array, thickness: Array, base: str
) -> Array:
    def curve(t: Array) -> tuple[Array, Array]:
        found = _contact(t, R1, R2, b, nu, thickness, base)
        value = normal._force(t, R1, R2, b, E_star) + E_star * number_of(found, "more")
        return value, t * E_star * number_of(found, "stiffness") * number_of(found, "rate") / value

    return radius_on_layer(curve, F, normal._radius_from_force(F, R1, R2, b, E_star), thickness, np.inf, False)


def _force_from_depth(
    d: Array, R1: Array, R2: Array, b: Array, E_star: Array, nu: Array, thickness: Array, base: str
) -> Array:
    return _force(_radius_from_depth(d, R1, R2, b, nu, thickness, base), R1, R2, b, E_star, nu, thickness, base)


def _depth_from_force(
    F: Array, R1: Array, R2: Array, b: Array, E_star: Array, nu: Array, thickness: Array, base: str
) -> Array:
    return _depth(_radius_from_force(F, R1, R2, b, E_star, nu, thickness, base), R1, R2, b, nu, thickness, base)


def _depth_first_order(a: Array, R1: Array, R2: Array, b: Array, nu: Array, thickness: Array, base: str) -> Array:
    sunk = normal._depth(a, R1, R2, b)
    carried = normal._force(a, R1, R2, b, 1.0)
    m_0 = wave_sum(nu, base, 0)
    lost = carried * m_0 / (np.pi * thickness)
    return sunk - lost


def _force_second_order(
    a: Array, R1: Array, R2: Array, b: Array, E_star: Array, nu: Array, thickness: Array, base: str
) -> Array:
    carried = normal._force(a, R1, R2, b, 1.0)
    m_2 = wave_sum(nu, base, 2)
    ratio = a / thickness
    return E_star * carried * (2 * m_2 * ratio**3 / (3 * np.pi) + 1)


def _adhesive_depth(
    a: Array, R1: Array, R2: Array, b: Array, E_star: Array, nu: Array, thickness: Array, dgamma: Array, base: str
) -> Array:
    return _depth(a, R1, R2, b, nu, thickness, base) - retraction_on_layer(a, E_star, nu, thickness, dgamma, base)


def _adhesive_force(
    a: Array, R1: Array, R2: Array, b: Array, E_star: Array, nu: Array, thickness: Array, dgamma: Array, base: str
) -> Array:
    punch = below_punch(a, thickness, nu, base)
    drawn = E_star * retraction_on_layer(a, E_star, nu, thickness, dgamma, base)
    return _force(a, R1, R2, b, E_star, nu, thickness, base) - drawn * number_of(punch, "stiffness")


def _adhesive_pressure(
    r: Array,
    a: Array,
    R1: Array,
    R2: Array,
    b: Array,
    E_star: Array,
    nu: Array,
    thickness: Array,
    dgamma: Array,
    base: str,
) -> Array:
    punch = below_punch(a, thickness, nu, base)
    drawn = E_star * retraction_on_layer(a, E_star, nu, thickness, dgamma, base)
    pulled = tension(r, a, E_star, dgamma) + drawn * added_pressure(punch, r)
    return _pressure(r, a, R1, R2, b, E_star, nu, thickness, base) - pulled
