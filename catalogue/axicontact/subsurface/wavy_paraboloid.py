"""Wavy paraboloid: stresses below the surface.

A paraboloid with concentric waves of amplitude h, 2h from valley to peak, too shallow to leave gaps.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime.interface import Array, Result, numbers, require_order
from .._runtime.subsurface.punches import PLAIN, Piece
from .._runtime.subsurface.stresses import (
    Displacement,
    Greatest,
    SlidingStress,
    Stress,
    SurfaceStress,
    displacement_below,
    greatest_below,
    held,
    largest_shear,
    sliding_below,
    stress_below,
    von_mises,
)
from ..normal import wavy_paraboloid as normal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "displacement",
    "greatest_shear",
    "greatest_von_mises",
    "partial_slip_stress",
    "sliding_stress",
    "stress",
    "surface_displacement",
    "surface_stress",
]


def __dir__() -> list[str]:
    return __all__


def stress(
    r: ArrayLike,
    z: ArrayLike,
    a: ArrayLike,
    *,
    R: ArrayLike,
    h: ArrayLike,
    wavelength: ArrayLike,
    E_star: ArrayLike,
    nu: ArrayLike,
    d: ArrayLike | None = None,
) -> Stress:
    """Stress below the contact.

        zz = -E_star*(D_0 + S_0)/pi
        rz = -D_1*E_star/pi
        rr + tt = E_star*(D_0 - S_0*(2*nu + 1))/pi
        rr - tt = E_star*(-D_2 - 2*S_2*nu + S_2)/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    z : array_like
        Depth below the surface [m]; NaN above it.
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Amplitude of the waves, half of their height from valley to peak [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    nu : array_like
        Poisson ratio [1], -1 < nu <= 1/2.
    d : array_like, optional
        Depth [m] of a contact whose edge is under tension or pressed in, as with adhesion; g(a) without it.

    Returns
    -------
    Stress
        Named tuple of rr, tt, zz and rz [Pa], tension positive, z into the half-space.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R; waves so flat that g' >= 0 for every a. At the edge of a face, at a tip and at a kink
    the pressure, and with it zz, is infinite. S_m, D_m and W are those of flat punches of all radii t up to
    the contact, times g'(t), summed over t. Their formulas are wavy_paraboloid.sub.S0 to S3, D0 to D3 and
    wavy_paraboloid.sub.W.

    References
    ----------
    Guduru 2007.
    """
    normal._check(R=R, h=h, wavelength=wavelength, E_star=E_star, nu=nu)
    return stress_below(_shape, r, z, a, E_star, nu, R=R, h=h, wavelength=wavelength, **held(d))


def displacement(
    r: ArrayLike,
    z: ArrayLike,
    a: ArrayLike,
    *,
    R: ArrayLike,
    h: ArrayLike,
    wavelength: ArrayLike,
    nu: ArrayLike,
    d: ArrayLike | None = None,
) -> Displacement:
    """Displacement below the contact.

        z = (S_0*z/(1 - nu) + 2*W)/pi
        r = -r*(-D_0 - D_2 + S_0 + S_2 - 2*nu*(S_0 + S_2))/(2*pi*(1 - nu))

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    z : array_like
        Depth below the surface [m]; NaN above it.
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Amplitude of the waves, half of their height from valley to peak [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
    nu : array_like
        Poisson ratio [1], -1 < nu <= 1/2.
    d : array_like, optional
        Depth [m] of a contact whose edge is under tension or pressed in, as with adhesion; g(a) without it.

    Returns
    -------
    Displacement
        Named tuple of r and z [m], away from the axis and into the half-space.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R; waves so flat that g' >= 0 for every a. S_m, D_m and W are those of flat punches of all
    radii t up to the contact, times g'(t), summed over t. Their formulas are wavy_paraboloid.sub.S0 to S3, D0
    to D3 and wavy_paraboloid.sub.W.

    References
    ----------
    Guduru 2007.
    """
    normal._check(R=R, h=h, wavelength=wavelength, nu=nu)
    return displacement_below(_shape, r, z, a, nu, R=R, h=h, wavelength=wavelength, **held(d))


def surface_stress(
    r: ArrayLike,
    a: ArrayLike,
    *,
    R: ArrayLike,
    h: ArrayLike,
    wavelength: ArrayLike,
    E_star: ArrayLike,
    nu: ArrayLike,
    d: ArrayLike | None = None,
) -> SurfaceStress:
    """Stress of the surface.

        rr + tt = E_star*(D_0 - S_0*(2*nu + 1))/pi
        rr - tt = E_star*(-D_2 - 2*S_2*nu + S_2)/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Amplitude of the waves, half of their height from valley to peak [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    nu : array_like
        Poisson ratio [1], -1 < nu <= 1/2.
    d : array_like, optional
        Depth [m] of a contact whose edge is under tension or pressed in, as with adhesion; g(a) without it.

    Returns
    -------
    SurfaceStress
        Named tuple of rr and tt [Pa], tension positive.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R; waves so flat that g' >= 0 for every a. At the edge of a face, at a tip and at a kink
    the pressure, and with it zz, is infinite. S_m, D_m and W are those of flat punches of all radii t up to
    the contact, times g'(t), summed over t. Their formulas are wavy_paraboloid.sub.S0 to S3, D0 to D3 and
    wavy_paraboloid.sub.W.

    References
    ----------
    Guduru 2007.
    """
    normal._check(R=R, h=h, wavelength=wavelength, E_star=E_star, nu=nu)
    return SurfaceStress(*stress_below(_shape, r, 0.0, a, E_star, nu, R=R, h=h, wavelength=wavelength, **held(d))[:2])


def surface_displacement(
    r: ArrayLike,
    a: ArrayLike,
    *,
    R: ArrayLike,
    h: ArrayLike,
    wavelength: ArrayLike,
    nu: ArrayLike,
    d: ArrayLike | None = None,
) -> Result:
    """Displacement of the surface away from the axis.

        r = -r*(-D_0 - D_2 + S_0 + S_2 - 2*nu*(S_0 + S_2))/(2*pi*(1 - nu))

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Amplitude of the waves, half of their height from valley to peak [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
    nu : array_like
        Poisson ratio [1], -1 < nu <= 1/2.
    d : array_like, optional
        Depth [m] of a contact whose edge is under tension or pressed in, as with adhesion; g(a) without it.

    Returns
    -------
    float or ndarray
        Displacement away from the axis [m].

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R; waves so flat that g' >= 0 for every a. S_m, D_m and W are those of flat punches of all
    radii t up to the contact, times g'(t), summed over t. Their formulas are wavy_paraboloid.sub.S0 to S3, D0
    to D3 and wavy_paraboloid.sub.W.

    References
    ----------
    Guduru 2007.
    """
    normal._check(R=R, h=h, wavelength=wavelength, nu=nu)
    return displacement_below(_shape, r, 0.0, a, nu, R=R, h=h, wavelength=wavelength, **held(d)).r


def sliding_stress(
    r: ArrayLike,
    phi: ArrayLike,
    z: ArrayLike,
    a: ArrayLike,
    *,
    R: ArrayLike,
    h: ArrayLike,
    wavelength: ArrayLike,
    E_star: ArrayLike,
    nu: ArrayLike,
    mu: ArrayLike,
    d: ArrayLike | None = None,
) -> SlidingStress:
    """Stress that friction adds where the whole contact slides.

        rr + tt = E_star*mu*(D_1 - S_1*(2*nu + 2))*cos(phi)/pi
        rr - tt = E_star*mu*(D_1/2 - D_3/2 + S_1*(nu - 2) - S_3*nu)*cos(phi)/pi
        zz = -D_1*E_star*mu*cos(phi)/pi
        rt = -E_star*mu*(D_1/2 + D_3/2 + S_1*(nu - 2) + S_3*nu)*sin(phi)/(2*pi)
        rz = -E_star*mu*(-D_0/2 + D_2/2 + S_0)*cos(phi)/pi
        tz = E_star*mu*(-D_0/2 - D_2/2 + S_0)*sin(phi)/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    phi : array_like
        Angle from the direction of the traction on the half-space [rad].
    z : array_like
        Depth below the surface [m]; NaN above it.
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Amplitude of the waves, half of their height from valley to peak [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    nu : array_like
        Poisson ratio [1], -1 < nu <= 1/2.
    mu : array_like
        Coefficient of friction [1], mu >= 0.
    d : array_like, optional
        Depth [m] of a contact whose edge is under tension or pressed in, as with adhesion; g(a) without it.

    Returns
    -------
    SlidingStress
        Named tuple of rr, tt, zz, rt, rz and tz [Pa], tension positive, z into the half-space.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R; waves so flat that g' >= 0 for every a. The traction mu p does not change the pressure.
    At the edge of a face, at a tip and at a kink it is infinite, and with it rz and tz. The whole stress is
    the `add` of this and of `stress`. S_m, D_m and W are those of flat punches of all radii t up to the
    contact, times g'(t), summed over t. Their formulas are wavy_paraboloid.sub.S0 to S3, D0 to D3 and
    wavy_paraboloid.sub.W.

    References
    ----------
    Guduru 2007.
    """
    normal._check(R=R, h=h, wavelength=wavelength, E_star=E_star, nu=nu, mu=mu)
    return sliding_below(_shape, r, phi, z, a, E_star, nu, mu, R=R, h=h, wavelength=wavelength, **held(d))


def partial_slip_stress(
    r: ArrayLike,
    phi: ArrayLike,
    z: ArrayLike,
    a: ArrayLike,
    c: ArrayLike,
    *,
    R: ArrayLike,
    h: ArrayLike,
    wavelength: ArrayLike,
    E_star: ArrayLike,
    nu: ArrayLike,
    mu: ArrayLike,
) -> SlidingStress:
    """Stress that friction adds where the contact sticks within the radius c.

        rr + tt = E_star*mu*(D_1 - S_1*(2*nu + 2))*cos(phi)/pi
        rr - tt = E_star*mu*(D_1/2 - D_3/2 + S_1*(nu - 2) - S_3*nu)*cos(phi)/pi
        zz = -D_1*E_star*mu*cos(phi)/pi
        rt = -E_star*mu*(D_1/2 + D_3/2 + S_1*(nu - 2) + S_3*nu)*sin(phi)/(2*pi)
        rz = -E_star*mu*(-D_0/2 + D_2/2 + S_0)*cos(phi)/pi
        tz = E_star*mu*(-D_0/2 - D_2/2 + S_0)*sin(phi)/pi

    Parameters
    ----------
    r : array_like
        Distance from the axis [m].
    phi : array_like
        Angle from the direction of the traction on the half-space [rad].
    z : array_like
        Depth below the surface [m]; NaN above it.
    a : array_like
        Contact radius [m].
    c : array_like
        Radius of the stick zone [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Amplitude of the waves, half of their height from valley to peak [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    nu : array_like
        Poisson ratio [1], -1 < nu <= 1/2.
    mu : array_like
        Coefficient of friction [1], mu >= 0.

    Returns
    -------
    SlidingStress
        Named tuple of rr, tt, zz, rt, rz and tz [Pa], tension positive, z into the half-space.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R; waves so flat that g' >= 0 for every a. The traction is mu times the difference of the
    pressures of radii a and c. At the edge of a face, at a tip and at a kink it is infinite, and with it rz
    and tz. Within c it is finite. S_m, D_m and W are those of flat punches of all radii t up to the contact,
    times g'(t), summed over t. Their formulas are wavy_paraboloid.sub.S0 to S3, D0 to D3 and
    wavy_paraboloid.sub.W.

    References
    ----------
    Guduru 2007.
    """
    normal._check(R=R, h=h, wavelength=wavelength, E_star=E_star, nu=nu, mu=mu)
    require_order(
        np.all(~(numbers("c", c) > numbers("a", a))),
        "c <= a",
        "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",
        c=c,
        a=a,
    )
    return sliding_below(_shape, r, phi, z, a, E_star, nu, mu, c, R=R, h=h, wavelength=wavelength)


def greatest_von_mises(
    a: ArrayLike,
    *,
    R: ArrayLike,
    h: ArrayLike,
    wavelength: ArrayLike,
    E_star: ArrayLike,
    nu: ArrayLike,
    d: ArrayLike | None = None,
) -> Greatest:
    """The greatest stress of von Mises below the contact.

        the largest of all points with z >= 0

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Amplitude of the waves, half of their height from valley to peak [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    nu : array_like
        Poisson ratio [1], -1 < nu <= 1/2.
    d : array_like, optional
        Depth [m] of a contact whose edge is under tension or pressed in, as with adhesion; g(a) without it.

    Returns
    -------
    Greatest
        Named tuple of value [Pa], r and z [m], the point at which it is.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R; waves so flat that g' >= 0 for every a. Infinite where the pressure is, on the surface.
    The point is known to about 1e-8 of the contact radius. S_m, D_m and W are those of flat punches of all
    radii t up to the contact, times g'(t), summed over t. Their formulas are wavy_paraboloid.sub.S0 to S3, D0
    to D3 and wavy_paraboloid.sub.W.

    References
    ----------
    Guduru 2007.
    """
    normal._check(R=R, h=h, wavelength=wavelength, E_star=E_star, nu=nu)
    return greatest_below(_shape, von_mises, a, E_star, nu, R=R, h=h, wavelength=wavelength, **held(d))


def greatest_shear(
    a: ArrayLike,
    *,
    R: ArrayLike,
    h: ArrayLike,
    wavelength: ArrayLike,
    E_star: ArrayLike,
    nu: ArrayLike,
    d: ArrayLike | None = None,
) -> Greatest:
    """The greatest shear stress below the contact.

        the largest of all points with z >= 0

    Parameters
    ----------
    a : array_like
        Contact radius [m].
    R : array_like
        Radius of curvature [m], R > 0.
    h : array_like
        Amplitude of the waves, half of their height from valley to peak [m], h > 0.
    wavelength : array_like
        Wavelength of the waviness [m], wavelength > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    nu : array_like
        Poisson ratio [1], -1 < nu <= 1/2.
    d : array_like, optional
        Depth [m] of a contact whose edge is under tension or pressed in, as with adhesion; g(a) without it.

    Returns
    -------
    Greatest
        Named tuple of value [Pa], r and z [m], the point at which it is.

    Raises
    ------
    ValueError
        If a keyword parameter is outside its domain.

    Notes
    -----
    Valid for a << R; waves so flat that g' >= 0 for every a. Infinite where the pressure is, on the surface.
    The point is known to about 1e-8 of the contact radius. S_m, D_m and W are those of flat punches of all
    radii t up to the contact, times g'(t), summed over t. Their formulas are wavy_paraboloid.sub.S0 to S3, D0
    to D3 and wavy_paraboloid.sub.W.

    References
    ----------
    Guduru 2007.
    """
    normal._check(R=R, h=h, wavelength=wavelength, E_star=E_star, nu=nu)
    return greatest_below(_shape, largest_shear, a, E_star, nu, R=R, h=h, wavelength=wavelength, **held(d))


def _shape(
    a: Array, R: Array, h: Array, wavelength: Array, d: Array | None = None
) -> tuple[Array, Array, tuple[Piece, ...]]:
    """Contact radius, what its edge is pressed in beyond g, and the slope g' piece by piece."""
    depth = normal._depth(a, R, h, wavelength)
    radius = np.where(np.isnan(depth), np.nan, a)
    edge = 0.0 if d is None else d - depth
    tip = Piece(PLAIN, 0.0, a, normal._slope, (R, h, wavelength), longest=2 * wavelength / np.pi)
    return radius, edge, (tip,)
