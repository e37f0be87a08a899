"""Section 11.1: the flat punch on the homogeneous half-space, (11.1)-(11.15)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import mpmath as mp

from .equation import AREA, FORCE, LENGTH, NUMBER, STIFFNESS, STRESS, Draw, Formula, Residual, chain, equation
from .quadrature import across, around, rings, singular, total_force, weighted

HALF = mp.mpf(1) / 2


def superposition(p: Callable[[Any], Any], r: Any, a: Any, E_star: Any, edge: Any) -> Any:
    """(11.2) in polar coordinates around the point: the area element s ds dphi cancels the distance."""
    return 1 / (mp.pi * E_star) * around(lambda s, phi: p(_radius(r, s, phi)), r, a, upper=edge)


def _radius(r: Any, s: Any, phi: Any) -> Any:
    return mp.sqrt(r**2 + s**2 + 2 * r * s * mp.cos(phi))


def pressure_around(s: Any, phi: Any, r: Any, a: Any, p0: Any) -> tuple[Any, Any, Any]:
    """The pressure at the distance s and angle phi from a point A at r < a, in three ways of writing it."""
    alpha_squared, beta = a**2 - r**2, r * mp.cos(phi)
    return (
        p0 * (1 - (r**2 + s**2 + 2 * r * s * mp.cos(phi)) / a**2) ** (-mp.mpf(1) / 2),
        p0 * a * (a**2 - r**2 - s**2 - 2 * r * s * mp.cos(phi)) ** (-mp.mpf(1) / 2),
        p0 * a * (alpha_squared - 2 * beta * s - s**2) ** (-mp.mpf(1) / 2),
    )


def displacement_around(r: Any, a: Any, p0: Any, E_star: Any) -> Any:
    """Displacement of the surface (a length) at r < a, the double integral around that point by quadrature."""

    def integrand(s: Any, phi: Any) -> Any:
        return (a**2 - r**2 - 2 * r * mp.cos(phi) * s - s**2) ** (-mp.mpf(1) / 2)

    return 1 / (mp.pi * E_star) * p0 * a * around(integrand, r, a, upper=-HALF)


def displacement_across(r: Any, a: Any, p0: Any, E_star: Any) -> Any:
    """Displacement of the surface (a length) at r > a, the double integral across the disc by quadrature."""

    def integrand(s: Any, phi: Any) -> Any:
        return (a**2 - r**2 + 2 * r * mp.cos(phi) * s - s**2) ** (-mp.mpf(1) / 2)

    return 1 / (mp.pi * E_star) * p0 * a * across(integrand, r, a, -HALF)


def _disc(draw: Draw) -> tuple[Any, Any, Any]:
    return draw.length(), draw.stress(), draw.stress(5, 50)


def _inside(draw: Draw, a: Any) -> Any:
    return draw.number(0.2, 0.65) * a


def _outside(draw: Draw, a: Any) -> Any:
    return draw.number(1.5, 3) * a


def _sunk(r: Any, a: Any, p0: Any, E_star: Any) -> Any:
    """Displacement at r under (11.1), by ring kernels."""
    return rings(lambda t: p0 / mp.sqrt(1 - t**2 / a**2), r, a, E_star)


@equation(
    1,
    lambda r, a, p0: p0 * (1 - r**2 / a**2) ** (-mp.mpf(1) / 2),
    "two points of the loaded circle sink equally, by ring kernels",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, p0, E_star = _disc(draw)
    inner, outer = (rings(lambda t: formula(t, a, p0), _inside(draw, a), a, E_star) for _ in range(2))
    yield Residual(inner, outer, LENGTH)
    yield Residual(p0, formula(mp.mpf(0), a, p0), STRESS)


@equation(2, superposition, "Hertz and uniform pressure with known displacement; a smooth pressure by ring kernels")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, p0, E_star = _disc(draw)
    r, near = _inside(draw, a), a * mp.mpf(10) ** -30
    hertz = mp.pi * p0 * (2 * a**2 - r**2) / (4 * a * E_star)
    yield Residual(hertz, formula(lambda t: p0 * mp.sqrt(1 - t**2 / a**2), r, a, E_star, HALF), LENGTH)
    yield Residual(2 * p0 * a / E_star, formula(lambda t: p0, near, a, E_star, 0), LENGTH)

    def smooth(t: Any) -> Any:
        return p0 * mp.cos((t / a) ** 2)

    yield Residual(rings(smooth, r, a, E_star), formula(smooth, r, a, E_star, 0), LENGTH)


@equation(3, pressure_around, "pressure at a point given by coordinates; the three lines agree")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, p0, _ = _disc(draw)
    r, phi = _inside(draw, a), draw.number(0, 6.28)
    s = draw.number(0.1, 0.9) * (a - r)
    x, y = r + s * mp.cos(phi), s * mp.sin(phi)
    left = p0 / mp.sqrt(1 - (x**2 + y**2) / a**2)
    yield from chain(left, formula(s, phi, r, a, p0), STRESS)


@equation(4, displacement_around, "double integral around A against ring kernels, r < a")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, p0, E_star = _disc(draw)
    r = _inside(draw, a)
    yield Residual(_sunk(r, a, p0, E_star), formula(r, a, p0, E_star), LENGTH)


@equation(
    5,
    lambda alpha, beta: mp.pi / 2 - mp.atan(beta / alpha),
    "inner integral by tanh-sinh quadrature, beta of both signs",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    alpha, beta = draw.length(), draw.sign() * draw.length()
    with mp.workdps(3 * mp.mp.dps):  # an error of the root counts with its square root
        end, other = mp.sqrt(alpha**2 + beta**2) - beta, mp.sqrt(alpha**2 + beta**2) + beta
    left = singular(lambda s: 1 / mp.sqrt((end - s) * (other + s)), mp.mpf(0), end)
    yield Residual(left, formula(alpha, beta), NUMBER)


@equation(
    6, lambda a, p0, E_star: mp.pi * p0 * a / E_star, "displacement by ring kernels at the centre and at two radii"
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, p0, E_star = _disc(draw)
    for r in (mp.mpf(0), _inside(draw, a), draw.number(0.8, 0.95) * a):
        yield Residual(_sunk(r, a, p0, E_star), formula(a, p0, E_star), LENGTH)


@equation(
    7,
    lambda s, phi, r, a, p0: p0 * a * (a**2 - r**2 + 2 * (r * mp.cos(phi)) * s - s**2) ** (-mp.mpf(1) / 2),
    "pressure at a point given by coordinates, A outside",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, p0, _ = _disc(draw)
    r, radius, angle = _outside(draw, a), draw.number(0.1, 0.9) * a, draw.number(0, 6.28)
    x, y = r - radius * mp.cos(angle), radius * mp.sin(angle)
    left = p0 / mp.sqrt(1 - radius**2 / a**2)
    yield Residual(left, formula(mp.hypot(x, y), mp.atan2(y, x), r, a, p0), STRESS)


@equation(8, displacement_across, "double integral across the disc against ring kernels, r > a")
def _displacement_across(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, p0, E_star = _disc(draw)
    r = _outside(draw, a)
    yield Residual(_sunk(r, a, p0, E_star), formula(r, a, p0, E_star), LENGTH)


@equation(
    9,
    lambda s, alpha_squared, beta: alpha_squared + 2 * beta * s - s**2,
    "a point of the circle t = a given by coordinates is a root",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a = draw.length()
    r, angle = _outside(draw, a), draw.number(0, 6.28)
    x, y = r - a * mp.cos(angle), a * mp.sin(angle)
    on_circle = formula(mp.hypot(x, y), a**2 - r**2, r * mp.cos(mp.atan2(y, x)))
    yield Residual(0, on_circle, AREA, scale=r**2)


@equation(10, lambda: mp.pi, "inner integral by Gauss-Jacobi quadrature")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a = draw.length()
    r = _outside(draw, a)
    beta = r * mp.cos(draw.number(0.1, 0.9) * mp.asin(a / r))
    half = mp.sqrt(a**2 - r**2 + beta**2)
    left = weighted(lambda s: 1 / mp.sqrt(a**2 - r**2 + 2 * beta * s - s**2), beta - half, beta + half, -HALF, -HALF)
    yield Residual(left, formula(), NUMBER)


@equation(
    11,
    lambda r, a, p0, E_star: 2 / E_star * p0 * a * mp.asin(a / r),
    "displacement by ring kernels, r > a, and continuity at r = a",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    yield from _displacement_across(draw, formula)
    a, p0, E_star = _disc(draw)
    yield Residual(_sunk(mp.mpf(0), a, p0, E_star), formula(a, a, p0, E_star), LENGTH)


@equation(
    12, lambda r, a, d: 2 / mp.pi * d * mp.asin(a / r), "displacement by ring kernels, r > a, with d by ring kernels"
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, p0, E_star = _disc(draw)
    r, d = _outside(draw, a), _sunk(mp.mpf(0), a, p0, E_star)
    yield Residual(_sunk(r, a, p0, E_star), formula(r, a, d), LENGTH)
    yield Residual(d, formula(a, a, d), LENGTH)


@equation(13, lambda a, p0: 2 * mp.pi * p0 * a**2, "pressure (11.1) integrated over the area")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, p0, _ = _disc(draw)
    yield Residual(total_force(lambda r: p0 * (1 - r**2 / a**2) ** -HALF, a), formula(a, p0), FORCE)


@equation(14, lambda a, E_star: 2 * a * E_star, "force by quadrature over depth by ring kernels")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, p0, E_star = _disc(draw)
    force = total_force(lambda r: p0 / mp.sqrt(1 - r**2 / a**2), a)
    yield Residual(force / _sunk(mp.mpf(0), a, p0, E_star), formula(a, E_star), STIFFNESS)


@equation(
    15,
    lambda r, a, d, E_star: 1 / mp.pi * E_star * d / mp.sqrt(a**2 - r**2),
    "pressure (11.1) with p0 replaced by d of ring kernels",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, p0, E_star = _disc(draw)
    r, d = _inside(draw, a), _sunk(mp.mpf(0), a, p0, E_star)
    yield Residual(p0 / mp.sqrt(1 - r**2 / a**2), formula(r, a, d, E_star), STRESS)
