"""Numbers in the words of the guide, each computed from what it says, so that none is typed."""

from __future__ import annotations

from typing import Any

import mpmath as mp

BERKOVICH = 24.5
"""Projected area of a Berkovich or a Vickers pyramid over the square of its depth."""
CUBE_CORNER = 1.5 * 3**0.5


def half_angle(area: float) -> float:
    """Half-angle in degrees of the cone that has this area over the square of its depth."""
    return float(mp.degrees(mp.atan(mp.sqrt(area / mp.pi))))


def slope(angle: float) -> float:
    """Slope of the flank of a cone of this half-angle in degrees."""
    return float(mp.cot(mp.radians(angle)))


def slope_factor(angle: float, nu: float) -> float:
    """Stiffness of a cone of this half-angle over that of small slopes (Hay, Bolshakov and Pharr 1999)."""
    steep = mp.cot(mp.radians(angle)) * (1 - 2 * nu) / (4 * (1 - nu))
    return float(mp.pi * (mp.pi / 4 + 0.15483073 * steep) / (mp.pi / 2 - 0.83119312 * steep) ** 2)


def sphere_over_paraboloid(ratio: float) -> float:
    """Force of a sphere over that of its paraboloid at the contact radius `ratio` times R, from the integrals."""
    return float(_force(lambda x: x / mp.sqrt(1 - x * x), ratio) / _force(lambda x: x, ratio))


def _force(slope: Any, a: float) -> Any:
    """F/E* = 2 (a g(a) - int_0^a g dt) with g(t) = t int_0^t f'(r)/sqrt(t^2 - r^2) dr."""

    def depth(t: Any) -> Any:
        return t * mp.quad(lambda angle: slope(t * mp.sin(angle)), [0, mp.pi / 2])

    return 2 * (a * depth(mp.mpf(a)) - mp.quad(depth, [0, a]))


def layer_factor(ratio: float, nu: float) -> float:
    """Force of a paraboloid on a bonded layer over that on a half-space, at sqrt(R d) = `ratio` times the thickness.

    To the second order in the ratio; the kernel is that of a layer on a rigid base.
    """
    k = 3 - 4 * mp.mpf(nu)

    def lost(u: Any) -> Any:
        # with exp(-2 u) in front of both, so that nothing overflows
        fall = mp.exp(-2 * u)
        above = fall * (2 * k * fall + 4 * u * u + 4 * u + 1 + k * k)
        return above / (k * (1 + fall**2) + (4 * u * u + 1 + k * k) * fall)

    first = 2 / mp.pi * mp.quad(lost, [0, 1, 4, mp.inf]) * ratio
    return float(1 + first + mp.mpf(7) / 6 * first**2)


def first_yield(nu: float) -> tuple[float, float]:
    """Greatest shear stress on the axis of Hertz's contact over p_0, and its depth over the contact radius."""

    def shear(z: Any) -> Any:
        along = -1 / (1 + z * z)
        across = -(1 + nu) * (1 - z * mp.acot(z)) + 1 / (2 * (1 + z * z))
        return (across - along) / 2

    depth = mp.findroot(lambda z: mp.diff(shear, z), 0.5)
    return float(shear(depth)), float(depth)


def without_slip(nu: float) -> float:
    """Stiffness of a flat punch that sticks over that of one without friction (Spence 1968)."""
    return float((1 - nu) * mp.log(3 - 4 * nu) / (1 - 2 * nu))


def retraction_at_pull_off() -> float:
    """Retraction over Tabor's number times the range of adhesion, for the paraboloid under given force."""
    return float(mp.sqrt(2 * mp.pi) * (9 * mp.pi / 8) ** (mp.mpf(1) / 6))
