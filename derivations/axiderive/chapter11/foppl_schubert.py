"""Section 11.9: the solutions of Föppl and Schubert, (11.100)-(11.110)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import mpmath as mp

from .equation import FORCE, LENGTH, NUMBER, STRESS, Dimension, Draw, Formula, Residual, chain, equation
from .quadrature import (
    PowerLoadChord,
    a_load,
    around,
    derivative,
    even_pressure,
    half_turn,
    kappa,
    panels,
    power_load,
    pressure,
    rings,
    singular,
    total_force,
    weighted,
)
from .round_trip import catalogue_inversion, catalogue_pressures, load_displacements

Function = Callable[[Any], Any]
ZERO, HALF = mp.mpf(0), mp.mpf(1) / 2


def chords(p: Function, r: Any, a: Any, E_star: Any, edge: Any) -> Any:
    """(11.101): every chord through A from end to end, s < 0 on the far side of A."""

    def chord(phi: Any) -> Any:
        middle = r * mp.cos(phi)
        half = mp.sqrt(a**2 - r**2 + middle**2)

        def load(s: Any) -> Any:
            return p(mp.sqrt(r**2 + s**2 - 2 * s * middle))

        return 1 / E_star * weighted(load, middle - half, middle + half, edge, edge)

    return 1 / mp.pi * half_turn(chord, mp.acosh(a / r))


def chord_displacement(p: Function, xi: Any, a: Any, E_star: Any, edge: Any) -> tuple[Any, Any]:
    """Along the chord at distance xi from the centre, and over the radius rho."""
    half = mp.sqrt(a**2 - xi**2)
    return (
        1 / E_star * weighted(lambda y: p(mp.sqrt(xi**2 + y**2)), -half, half, edge, edge),
        2 / E_star * weighted(lambda rho: p(rho) * rho / mp.sqrt(rho**2 - xi**2), xi, a, -HALF, edge),
    )


def displacement_from_chords(w1D: Function, r: Any) -> tuple[Any, Any]:
    """Displacement at r (a length) from w1D, integrated over the angle of the chords and over their distance xi."""
    return (
        2 / mp.pi * singular(lambda phi: w1D(r * mp.sin(phi)), ZERO, mp.pi / 2),
        2 / mp.pi * singular(lambda xi: w1D(xi) / mp.sqrt(r**2 - xi**2), ZERO, r),
    )


def _abel(slope: Function, xi: Any, breaks: tuple[Any, ...]) -> Any:
    return panels(lambda rho: slope(rho) / mp.sqrt(xi**2 - rho**2), ZERO, xi, breaks)


def pressure_from_chords(slope: Function, rho: Any, a: Any, E_star: Any, breaks: tuple[Any, ...] = ()) -> Any:
    """Pressure at rho from the slope of w1D, by quadrature in panels between the breaks."""
    return -E_star / mp.pi * panels(lambda xi: slope(xi) / mp.sqrt(xi**2 - rho**2), rho, a, breaks)


def centre(w1D: Function, r: Any) -> tuple[Any, Any]:
    """Displacement of the centre (a length): w1D(0) with the integral of the kernel, and w1D(0) itself."""
    return w1D(ZERO) * 2 / mp.pi * singular(lambda xi: 1 / mp.sqrt(r**2 - xi**2), ZERO, r), w1D(ZERO)


def _double(slope: Function, lower: Function, a: Any, E_star: Any, cuts: tuple[Any, ...]) -> Any:
    """-2 E* int (int slope/sqrt(xi**2 - r**2) dxi over (lower(r), a)) r dr, inside with y = sqrt(xi**2 - r**2)."""

    def inner(r: Any) -> Any:
        def integrand(y: Any) -> Any:
            xi = mp.hypot(r, y)
            return slope(xi) / xi

        return weighted(integrand, mp.sqrt(lower(r) ** 2 - r**2), mp.sqrt(a**2 - r**2), density=0.5)

    ends = (ZERO, *cuts, a)
    parts = (weighted(lambda r: inner(r) * r, lo, hi, 0, HALF) for lo, hi in zip(ends, ends[1:], strict=False))
    return -2 * E_star * mp.fsum(parts)


def _later_lines(p: Function, w1D: Function, slope: Function, a: Any, E_star: Any) -> tuple[Any, ...]:
    """What (11.110) prints besides the second member of its first line."""

    def swapped(xi: Any) -> Any:
        return slope(xi) * weighted(lambda r: r / mp.sqrt(xi**2 - r**2), ZERO, xi, 0, -HALF, density=0.8)

    return (
        2 * mp.pi * weighted(lambda r: p(r) * r, ZERO, a, 0, HALF),
        -2 * E_star * weighted(swapped, ZERO, a),
        -2 * E_star * singular(lambda xi: xi * slope(xi), ZERO, a),
        2 * E_star * singular(w1D, ZERO, a),
    )


def force_printed(p: Function, w1D: Function, slope: Function, a: Any, E_star: Any, rho: Any) -> tuple[Any, ...]:
    """rho is a free symbol; where it is below r the root is imaginary, and the real part starts at r."""
    return *_later_lines(p, w1D, slope, a, E_star), _double(slope, lambda r: max(rho, r), a, E_star, (rho,))


def force_corrected(p: Function, w1D: Function, slope: Function, a: Any, E_star: Any, rho: Any) -> tuple[Any, ...]:
    """Every line as a force, the inner integral of the first beginning at r; rho is left unused."""
    del rho
    return *_later_lines(p, w1D, slope, a, E_star), _double(slope, lambda r: r, a, E_star, ())


@equation(
    100,
    lambda p, s, ds, dphi, E_star: (p * s * ds * dphi / (mp.pi * E_star * s), 1 / (mp.pi * E_star) * p * ds * dphi),
    "both forms integrated around A against ring kernels, smooth pressure",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, p0, E_star, _ = a_load(draw)
    r = a * draw.number(0.2, 0.6)

    def load(t: Any) -> Any:
        return p0 * mp.cos((t / a) ** 2)

    left, ds, dphi = rings(load, r, a, E_star), draw.length(), draw.number(0.1, 1)

    def integrands(s: Any, phi: Any) -> tuple[Any, Any]:
        pressure_there = load(mp.sqrt(r**2 + s**2 + 2 * r * s * mp.cos(phi)))
        first, second = formula(pressure_there, s, ds, dphi, E_star)
        return first / (ds * dphi), second / (ds * dphi)

    yield Residual(left, around(lambda s, phi: integrands(s, phi)[0], r, a), LENGTH)
    yield Residual(left, around(lambda s, phi: integrands(s, phi)[1], r, a), LENGTH)


@equation(101, chords, "full chords against ring kernels, power load of random exponent")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, p0, E_star, exponent = a_load(draw)
    r, load = a * draw.number(0.2, 0.6), power_load(p0, a, exponent)
    yield Residual(rings(load, r, a, E_star), formula(load, r, a, E_star, exponent), LENGTH)


@equation(
    102,
    lambda rho, xi, r, half: (mp.sqrt(rho**2 - xi**2) + mp.sqrt(r**2 - xi**2), mp.asin(xi / r)),
    "both points of a chord at the distance rho, given by coordinates",
    corrected=lambda rho, xi, r, half: (half * mp.sqrt(rho**2 - xi**2) + mp.sqrt(r**2 - xi**2), mp.asin(xi / r)),
    printed_form="s = sqrt(rho^2 - xi^2) + sqrt(r^2 - xi^2)",
    right_form="s = +-sqrt(rho^2 - xi^2) + sqrt(r^2 - xi^2)",
    reason="As printed, B lies on the far half of the chord only; the half with A on it gives (11.104) its factor 2",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a = draw.length()
    r, phi = a * draw.number(0.2, 0.9), draw.number(0.1, 1.4)
    xi = r * mp.sin(phi)
    rho = xi + (a - xi) * draw.number(0.1, 0.9)
    along = mp.sqrt((rho - xi) * (rho + xi))
    for half in (1, -1):
        s, angle = formula(rho, xi, r, half)
        x, y = r - s * mp.cos(phi), s * mp.sin(phi)
        middle = (xi * mp.sin(phi), xi * mp.cos(phi))
        yield Residual(middle[0] - half * along * mp.cos(phi), x, LENGTH, scale=a)
        yield Residual(middle[1] + half * along * mp.sin(phi), y, LENGTH, scale=a)
        yield Residual(phi, angle, NUMBER)


@equation(
    103,
    lambda rho, xi, r: (rho / mp.sqrt(rho**2 - xi**2), 1 / mp.sqrt(r**2 - xi**2)),
    "reciprocal slopes of the inverse maps by Cauchy's integral",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    xi, y, phi = draw.length(), draw.length(), draw.number(0.1, 1.4)
    rho, r = mp.hypot(xi, y), xi / mp.sin(phi)
    along, turning = formula(rho, xi, r)
    yield Residual(1 / derivative(lambda t: mp.sqrt(xi**2 + t**2), y, xi / 4), along, NUMBER)
    yield Residual(1 / derivative(lambda t: r * mp.sin(t), phi, HALF), turning, Dimension(-1))


@equation(104, chord_displacement, "closed w1D of Föppl's pressures and of any exponent above -1, both forms")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, p0, E_star, exponent = a_load(draw, -0.9)
    xi = a * draw.number(0.2, 0.8)
    for power in (-HALF, HALF, ZERO, exponent):
        known = PowerLoadChord(p0, a, power, E_star)
        yield from chain(known(xi), formula(power_load(p0, a, power), xi, a, E_star, power), LENGTH)


@equation(
    105,
    displacement_from_chords,
    "known displacement of Föppl's three pressures; ring kernels and the derived loads for a random exponent",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, p0, E_star, exponent = a_load(draw)
    r = a * draw.number(0.2, 0.9)
    constant, parabola = mp.pi * p0 * a / E_star, mp.pi * p0 * (2 * a**2 - r**2) / (4 * a * E_star)
    uniform = 4 * p0 * a / (mp.pi * E_star) * mp.ellipe((r / a) ** 2)
    for power, known in ((-HALF, constant), (HALF, parabola), (ZERO, uniform)):
        yield from chain(known, formula(PowerLoadChord(p0, a, power, E_star), r), LENGTH)
    left = rings(power_load(p0, a, exponent), r, a, E_star)
    yield from chain(left, formula(PowerLoadChord(p0, a, exponent, E_star), r), LENGTH)
    yield from load_displacements(draw, formula, PowerLoadChord)


@equation(
    106,
    lambda w, slope, xi, breaks=(): xi * _abel(slope, xi, breaks),
    "w = d - f of random powers and of every profile of the catalogue gives d - g",
    corrected=lambda w, slope, xi, breaks=(): w(ZERO) + xi * _abel(slope, xi, breaks),
    printed_form="w1D(xi) = xi int_0^xi w'(rho)/sqrt(xi^2 - rho^2) drho",
    right_form="w1D(xi) = w(0) + xi int_0^xi w'(rho)/sqrt(xi^2 - rho^2) drho",
    reason="The printed form vanishes at xi = 0 and contradicts (11.109): it gives -g instead of d - g",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    f, a = draw.power_sum(), draw.length()
    g = f.times(kappa)
    d, xi = g(a), a * draw.number(0.1, 0.9)
    yield Residual(d - g(xi), formula(lambda r: d - f(r), lambda r: -f.slope(r), xi), LENGTH)
    yield from catalogue_inversion(draw, formula)


@equation(
    107, pressure_from_chords, "power load, random powers, and the derived pressure of every profile of the catalogue"
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, p0, E_star, exponent = a_load(draw, 0.2)
    r = a * draw.number(0.2, 0.9)
    chord = PowerLoadChord(p0, a, exponent, E_star)
    yield Residual(power_load(p0, a, exponent)(r), formula(chord.slope, r, a, E_star), STRESS)
    g = draw.power_sum()
    yield Residual(pressure(g, r, a, E_star), formula(lambda x: -g.slope(x), r, a, E_star), STRESS)
    yield from catalogue_pressures(draw, formula)


@equation(108, lambda r: 2 / mp.pi * singular(lambda xi: 1 / mp.sqrt(r**2 - xi**2), ZERO, r), "quadrature")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    yield Residual(mp.mpf(1), formula(draw.length()), NUMBER)


@equation(109, centre, "displacement of the centre by ring kernels against both lines")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, p0, E_star, exponent = a_load(draw)
    left = rings(power_load(p0, a, exponent), ZERO, a, E_star)
    yield from chain(left, formula(PowerLoadChord(p0, a, exponent, E_star), draw.length()), LENGTH)


@equation(
    110,
    force_printed,
    "closed pressure integrated over the area against all lines",
    corrected=force_corrected,
    printed_form="first line: int_0^a (int_rho^a w1D'(xi)/sqrt(xi^2 - r^2) dxi) r dr",
    right_form="first line: int_0^a (int_r^a w1D'(xi)/sqrt(xi^2 - r^2) dxi) r dr",
    reason="Nothing defines rho here: in the pressure (11.107) at r, the integral begins at xi = r",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, a, E_star = draw.even_sum(2), draw.length(), draw.stress()
    left = total_force(lambda r: even_pressure(g, r, a, E_star), a)
    sides = formula(
        lambda r: even_pressure(g, r, a, E_star), lambda x: g(a) - g(x), lambda x: -g.slope(x), a, E_star,
        a * draw.number(0.3, 0.6),
    )  # fmt: skip
    yield from chain(left, sides, FORCE)
