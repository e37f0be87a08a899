"""Section 11.4: the flat punch on a half-space of modulus E_0 (z/c_0)**k, (11.32)-(11.47)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import mpmath as mp

from .equation import FORCE, LENGTH, NUMBER, STIFFNESS, STRESS, Dimension, Draw, Formula, Residual, equation
from .quadrature import across, around, graded_centre, graded_rings, singular, total_force


class Medium(NamedTuple):
    """E_0, c_0, k, nu and the number h_N(k, nu) of chapter 9, which chapter 11 leaves open and so is random here."""

    E0: Any
    c0: Any
    k: Any
    nu: Any
    h_N: Any

    @property
    def H(self) -> Any:
        """h_N E_0 / ((1 - nu**2) c_0**k), which takes the place of E*."""
        return self.h_N * self.E0 / ((1 - self.nu**2) * self.c0**self.k)

    @property
    def E_star(self) -> Any:
        """Effective modulus of the depth c_0 under a rigid indenter."""
        return self.E0 / (1 - self.nu**2)

    def foundation(self, x: Any) -> Any:
        """Stiffness per length of the Winkler foundation, (9.4)."""
        return self.h_N * self.E0 / (1 - self.nu**2) * (abs(x) / self.c0) ** self.k

    def homogeneous(self) -> Medium:
        """The same constants with k = 0, so that the modulus is E_0 at every depth."""
        return self._replace(k=mp.mpf(0))


def exponent(draw: Draw) -> Any:
    """k of either sign, away from the ends of -1 < k < 1 where the quadratures slow down."""
    return draw.sign() * draw.number(0.05, 0.5)


def medium(draw: Draw) -> Medium:
    """Random constants in the units of the draw, k of either sign and h_N between 0.5 and 1.5."""
    return Medium(draw.stress(5, 50), draw.length(), exponent(draw), draw.number(0, 0.5), draw.number(0.5, 1.5))


ZERO = mp.mpf(0)


def superposition(p: Callable[[Any], Any], r: Any, a: Any, edge: Any, medium: Medium) -> Any:
    """(11.34) in polar coordinates around the point: the area element s ds dphi leaves s**-k."""
    E0, c0, k, nu, h_N = medium

    def integrand(s: Any, phi: Any) -> Any:
        return p(mp.sqrt(r**2 + s**2 + 2 * r * s * mp.cos(phi))) * s / s ** (1 + k)

    return (1 - nu**2) * mp.cos(k * mp.pi / 2) * c0**k / (h_N * mp.pi * E0) * around(integrand, r, a, -k, edge)


def displacement_around(r: Any, a: Any, p0: Any, medium: Medium) -> Any:
    """Displacement of the surface (a length) at r < a, the double integral around that point by quadrature."""
    E0, c0, k, nu, h_N = medium

    def integrand(s: Any, phi: Any) -> Any:
        return 1 / mp.sqrt(a**2 - r**2 - 2 * r * mp.cos(phi) * s - s**2) ** (1 - k) / s**k

    factor = (1 - nu**2) * mp.cos(k * mp.pi / 2) * c0**k * p0 * a ** (1 - k) / (h_N * mp.pi * E0)
    return factor * around(integrand, r, a, -k, (k - 1) / 2)


def inner_integral(alpha: Any, beta: Any, k: Any) -> Any:
    """A pure number: the integral along the ray from A to the edge, alpha**2 = a**2 - r**2, beta = r cos(phi)."""
    head = mp.gamma(1 - k / 2) * mp.gamma((1 + k) / 2) / mp.sqrt(mp.pi) * beta / mp.sqrt(alpha**2 + beta**2)
    series = mp.hyp2f1(mp.mpf(1) / 2, (1 + k) / 2, mp.mpf(3) / 2, beta**2 / (alpha**2 + beta**2))
    return mp.pi / (2 * mp.cos(k * mp.pi / 2)) - head * series


def displacement_across(r: Any, a: Any, p0: Any, medium: Medium) -> Any:
    """Displacement of the surface (a length) at r > a, the double integral across the disc by quadrature."""
    E0, c0, k, nu, h_N = medium

    def integrand(s: Any, phi: Any) -> Any:
        return 1 / mp.sqrt(a**2 - r**2 + 2 * r * mp.cos(phi) * s - s**2) ** (1 - k) / s**k

    factor = (1 - nu**2) * mp.cos(k * mp.pi / 2) * c0**k * p0 * a ** (1 - k) / (h_N * mp.pi * E0)
    return factor * across(integrand, r, a, (k - 1) / 2)


def chord_integral(alpha_squared: Any, beta: Any, k: Any) -> Any:
    """A pure number: the integral along a chord of the disc seen from A at r > a, alpha_squared = a**2 - r**2 < 0."""
    share = (alpha_squared + beta**2) / beta**2
    head = mp.sqrt(mp.pi) * mp.gamma((1 + k) / 2) / mp.gamma(1 + k / 2)
    return head * share ** (k / 2) * mp.hyp2f1(k / 2, (1 + k) / 2, 1 + k / 2, share)


def _fall(r: Any, a: Any, k: Any) -> Any:
    """A pure number: how the displacement falls off at r > a."""
    return (a / r) ** (k + 1) * mp.hyp2f1((1 + k) / 2, (1 + k) / 2, (3 + k) / 2, a**2 / r**2)


def outside_from_pressure(r: Any, a: Any, p0: Any, medium: Medium) -> Any:
    """Displacement of the surface (a length) at r >= a, from the pressure p0 at the centre."""
    E0, c0, k, nu, h_N = medium
    factor = 2 * (1 - nu**2) * mp.cos(k * mp.pi / 2) * c0**k * p0 * a ** (1 - k) / (h_N * E0 * (1 + k))
    return factor * _fall(r, a, k)


def _disc(draw: Draw) -> tuple[Any, Any, Any, Medium]:
    a = draw.length()
    return a, draw.number(0.2, 0.6) * a, draw.stress(), medium(draw)


def _loaded(p0: Any, a: Any, k: Any) -> Callable[[Any], Any]:
    return lambda t: p0 * ((1 - t / a) * (1 + t / a)) ** ((k - 1) / 2)


def _depth_at_centre(p0: Any, a: Any, m: Medium) -> Any:
    return graded_centre(_loaded(p0, a, m.k), a, m.H, m.k)


@equation(32, lambda z, m: m.E0 * (z / m.c0) ** m.k, "value at c0, homogeneous limit, logarithmic slope k")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    m, z = medium(draw), draw.length()
    yield Residual(m.E0, formula(m.c0, m), STRESS)
    yield Residual(m.E0, formula(z, m.homogeneous()), STRESS)
    yield Residual(m.k, mp.log(formula(2 * z, m) / formula(z, m), 2), NUMBER)


@equation(
    33,
    lambda r, force, m: (
        (1 - m.nu**2) * mp.cos(m.k * mp.pi / 2) * m.c0**m.k / (m.h_N * mp.pi * m.E0) * force / r ** (1 + m.k)
    ),
    "homogeneous limit; point loads of (11.35) add up to a regularised Beta function outside",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, inside, p0, m = _disc(draw)
    force, even = draw.force(), m.homogeneous()
    yield Residual(
        force * (1 - even.nu**2) / (mp.pi * even.E0 * even.h_N * inside), formula(inside, force, even), LENGTH
    )
    r = draw.number(1.6, 3) * a

    def integrand(s: Any, phi: Any) -> Any:
        t_squared = r**2 + s**2 - 2 * r * s * mp.cos(phi)
        return formula(s, p0 * (1 - t_squared / a**2) ** ((m.k - 1) / 2), m) * s

    d = mp.pi * p0 * a ** (1 - m.k) / m.H
    share = mp.betainc((1 + m.k) / 2, (1 - m.k) / 2, 0, (a / r) ** 2, regularized=True)
    yield Residual(d * share, across(integrand, r, a, (m.k - 1) / 2), LENGTH)


@equation(34, superposition, "uniform pressure at the centre; (11.35) gives the depth found at the centre")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, r, p0, m = _disc(draw)
    near = a * mp.mpf(10) ** -30
    uniform = 2 * mp.cos(m.k * mp.pi / 2) * p0 * a ** (1 - m.k) / (m.H * (1 - m.k))
    yield Residual(uniform, formula(lambda t: p0, near, a, ZERO, m), LENGTH)
    punch = formula(lambda t: p0 * (1 - t**2 / a**2) ** ((m.k - 1) / 2), r, a, (m.k - 1) / 2, m)
    yield Residual(_depth_at_centre(p0, a, m), punch, LENGTH)


@equation(
    35,
    lambda r, a, p0, k: p0 * (1 - r**2 / a**2) ** ((k - 1) / 2),
    "two points of the loaded circle sink equally, by double quadrature",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, r, p0, m = _disc(draw)
    k, factor = m.k, mp.cos(m.k * mp.pi / 2) / (mp.pi * m.H)

    def displacement(x: Any) -> Any:
        def integrand(s: Any, phi: Any) -> Any:
            return formula(mp.sqrt(x**2 + s**2 + 2 * x * s * mp.cos(phi)), a, p0, k) * s**-k

        return factor * around(integrand, x, a, -k, (k - 1) / 2)

    yield Residual(displacement(r), displacement(draw.number(0.2, 0.6) * a), LENGTH)
    yield Residual(p0, formula(ZERO, a, p0, k), STRESS)


@equation(
    36,
    lambda s, phi, r, a, p0, k: p0 * a ** (1 - k) / mp.sqrt(a**2 - r**2 - 2 * (r * mp.cos(phi)) * s - s**2) ** (1 - k),
    "pressure at a point given by coordinates",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, r, p0, m = _disc(draw)
    phi, s = draw.number(0, 6.28), draw.number(0.1, 0.9) * (a - r)
    x, y = r + s * mp.cos(phi), s * mp.sin(phi)
    yield Residual(p0 * (1 - (x**2 + y**2) / a**2) ** ((m.k - 1) / 2), formula(s, phi, r, a, p0, m.k), STRESS)


@equation(37, displacement_around, "double quadrature at r < a against the integral for the centre")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, r, p0, m = _disc(draw)
    yield Residual(_depth_at_centre(p0, a, m), formula(r, a, p0, m), LENGTH)


@equation(38, inner_integral, "inner integral by tanh-sinh quadrature, beta of both signs")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    k = exponent(draw)
    alpha, beta = draw.length(), draw.sign() * draw.length()
    with mp.workdps(6 * mp.mp.dps):  # the integrand has a power at the end point, whose rounding counts
        end = mp.sqrt(alpha**2 + beta**2) - beta
        other = mp.sqrt(alpha**2 + beta**2) + beta
    strongest = max(float(k), float(1 - k) / 2)
    left = singular(lambda s: ((end - s) * (other + s)) ** ((k - 1) / 2) / s**k, ZERO, end, strongest)
    yield Residual(left, formula(alpha, beta, k), Dimension(0))


@equation(
    39,
    lambda a, p0, m: (1 - m.nu**2) * m.c0**m.k * mp.pi * p0 * a ** (1 - m.k) / (m.h_N * m.E0),
    "displacement of the centre and of a point r < a by quadrature of (11.34)",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, r, p0, m = _disc(draw)
    yield Residual(_depth_at_centre(p0, a, m), formula(a, p0, m), LENGTH)
    yield Residual(superposition(_loaded(p0, a, m.k), r, a, (m.k - 1) / 2, m), formula(a, p0, m), LENGTH)


@equation(
    40,
    lambda s, phi, r, a, p0, k: p0 * a ** (1 - k) / mp.sqrt(a**2 - r**2 + 2 * (r * mp.cos(phi)) * s - s**2) ** (1 - k),
    "pressure at a point given by coordinates, A outside",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, _, p0, m = _disc(draw)
    r, radius, angle = draw.number(1.5, 3) * a, draw.number(0.1, 0.9) * a, draw.number(0, 6.28)
    x, y = r - radius * mp.cos(angle), radius * mp.sin(angle)
    left = p0 * (1 - radius**2 / a**2) ** ((m.k - 1) / 2)
    yield Residual(left, formula(mp.hypot(x, y), mp.atan2(y, x), r, a, p0, m.k), STRESS)


@equation(41, displacement_across, "double quadrature at r > a against ring kernels")
def _displacement_outside(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, _, p0, m = _disc(draw)
    r = draw.number(1.6, 3) * a
    yield Residual(graded_rings(_loaded(p0, a, m.k), r, a, m.H, m.k), formula(r, a, p0, m), LENGTH)


@equation(42, chord_integral, "inner integral by tanh-sinh quadrature")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    k, a = exponent(draw), draw.length()
    r = draw.number(1.3, 3) * a
    with mp.workdps(6 * mp.mp.dps):
        sine = draw.number(0.1, 0.9) * a / r
        beta, half = r * mp.sqrt(1 - sine**2), mp.sqrt(a**2 - (r * sine) ** 2)
        near, far = beta - half, beta + half
    left = singular(lambda s: ((far - s) * (s - near)) ** ((k - 1) / 2) / s**k, near, far, max(0.0, float(1 - k) / 2))
    yield Residual(left, formula(half**2 - beta**2, beta, k), NUMBER)


@equation(43, outside_from_pressure, "ring kernels at r > a, continuity at r = a, homogeneous limit")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    yield from _displacement_outside(draw, formula)
    a, _, p0, m = _disc(draw)
    yield Residual(_depth_at_centre(p0, a, m), formula(a, a, p0, m), LENGTH)
    r, even = draw.number(1.6, 3) * a, m.homogeneous()
    yield Residual(2 / even.H * p0 * a * mp.asin(a / r), formula(r, a, p0, even), LENGTH)


@equation(
    44,
    lambda r, a, d, k: 2 * d * mp.cos(k * mp.pi / 2) / (mp.pi * (1 + k)) * _fall(r, a, k),
    "ring kernels and double quadrature at r > a",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, _, p0, m = _disc(draw)
    r, d = draw.number(1.6, 3) * a, _depth_at_centre(p0, a, m)
    yield Residual(graded_rings(_loaded(p0, a, m.k), r, a, m.H, m.k), formula(r, a, d, m.k), LENGTH)
    yield Residual(displacement_across(r, a, p0, m), formula(r, a, d, m.k), LENGTH)


def _force(p0: Any, a: Any, k: Any) -> Any:
    return total_force(_loaded(p0, a, k), a, max(0.0, float(1 - k) / 2))


@equation(45, lambda a, p0, k: 2 * mp.pi * p0 * a**2 / (k + 1), "pressure (11.35) integrated over the area")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, _, p0, m = _disc(draw)
    yield Residual(_force(p0, a, m.k), formula(a, p0, m.k), FORCE)


@equation(
    46,
    lambda a, m: 2 * m.h_N * m.E0 / ((1 - m.nu**2) * m.c0**m.k * (1 + m.k)) * a ** (1 + m.k),
    "force over depth, both by quadrature",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, _, p0, m = _disc(draw)
    yield Residual(_force(p0, a, m.k) / _depth_at_centre(p0, a, m), formula(a, m), STIFFNESS)


@equation(
    47,
    lambda r, a, d, m: m.h_N * m.E0 * d / (mp.pi * (1 - m.nu**2) * m.c0**m.k * (a**2 - r**2) ** ((1 - m.k) / 2)),
    "pressure (11.35) with p0 replaced by d found at the centre",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, r, p0, m = _disc(draw)
    yield Residual(_loaded(p0, a, m.k)(r), formula(r, a, _depth_at_centre(p0, a, m), m), STRESS)
