"""Section 11.5: normal contact of a profile on the graded half-space, (11.48)-(11.61)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import mpmath as mp

from .equation import FORCE, LENGTH, STRESS, Draw, Formula, PowerSum, Residual, chain, equation
from .graded_punch import Medium, exponent, medium
from .quadrature import (
    around,
    even_pressure,
    graded_centre,
    graded_rings,
    kappa,
    panels,
    pressure,
    singular,
    total_force,
    weighted,
)
from .round_trip import graded_catalogue_depths, graded_catalogue_pressures

Function = Callable[[Any], Any]
ZERO = mp.mpf(0)


def depth_of_radius(g: Function, a: Any) -> Any:
    """The depth g(a), a length, at the contact radius a."""
    return g(a)


def force_increment(x: Any, dd: Any, slope: Function, dx: Any, m: Medium) -> tuple[Any, Any]:
    """Force added when a contact of radius x sinks by dd, and the same with g'(x) dx in the place of dd."""
    E0, c0, k, nu, h_N = m
    factor = 2 * h_N * E0 / ((1 - nu**2) * c0**k * (1 + k))
    return factor * x ** (1 + k) * dd, factor * x ** (1 + k) * slope(x) * dx


def force_from_slope(slope: Function, a: Any, m: Medium) -> Any:
    """Normal force from g', by quadrature over the radii the contact has grown through."""
    E0, c0, k, nu, h_N = m
    return 2 * h_N * E0 / ((1 - nu**2) * c0**k * (1 + k)) * singular(lambda x: x ** (1 + k) * slope(x), ZERO, a)


def force_by_parts(g: Function, d: Any, a: Any, foundation: Function, m: Medium) -> tuple[Any, Any]:
    """Normal force from g over the radii 0 to a, and from the springs of the foundation between -a and a."""
    E0, c0, k, nu, h_N = m
    return (
        2 * h_N * E0 / ((1 - nu**2) * c0**k) * singular(lambda x: x**k * (g(a) - g(x)), ZERO, a),
        panels(lambda x: foundation(x) * (d - g(abs(x))), -a, a, (ZERO,)),
    )


def pressure_increment(r: Any, x: Any, dd: Any, slope: Function, dx: Any, m: Medium) -> tuple[Any, Any]:
    """Pressure added at r < x when a contact of radius x sinks by dd, and with g'(x) dx in the place of dd."""
    E0, c0, k, nu, h_N = m
    factor = h_N * E0 / (mp.pi * (1 - nu**2) * c0**k * (x**2 - r**2) ** ((1 - k) / 2))
    return factor * dd, factor * slope(x) * dx


def pressure_from_slope(
    slope: Function, w1D_slope: Function, foundation: Function, r: Any, a: Any, m: Medium, breaks: tuple[Any, ...] = ()
) -> tuple[Any, Any]:
    """Pressure at r from the slope of g, and from the slope of w1D with the stiffness of the foundation at c_0."""
    E0, c0, k, nu, h_N = m

    def abel(f: Function) -> Any:
        return panels(lambda x: f(x) / (x**2 - r**2) ** ((1 - k) / 2), r, a, breaks, max(0.0, float(1 - k) / 2))

    return h_N * E0 / (mp.pi * (1 - nu**2) * c0**k) * abel(slope), -foundation(c0) / (mp.pi * c0**k) * abel(w1D_slope)


def displacement_increment(r: Any, x: Any, dd: Any, k: Any) -> Any:
    """Displacement (a length) added at r by a contact of radius x that sinks by dd: all of dd where r < x."""
    if r < x:
        return dd
    factor = 2 * mp.cos(k * mp.pi / 2) / (mp.pi * (1 + k))
    return factor * (x / r) ** (1 + k) * mp.hyp2f1((1 + k) / 2, (1 + k) / 2, (3 + k) / 2, x**2 / r**2) * dd


def displacement_from_slope(slope: Function, r: Any, a: Any, k: Any) -> Any:
    """Displacement (a length) at r > a from the slope of g, by quadrature of a hypergeometric kernel."""

    def integrand(x: Any) -> Any:
        return (x / r) ** (1 + k) * mp.hyp2f1((1 + k) / 2, (1 + k) / 2, (3 + k) / 2, x**2 / r**2) * slope(x)

    return 2 * mp.cos(k * mp.pi / 2) / (mp.pi * (1 + k)) * singular(integrand, ZERO, a)


def displacement_by_parts(g: Function, w1D: Function, r: Any, a: Any, k: Any) -> tuple[Any, Any]:
    """Displacement (a length) at r > a by an Abel kernel: from g(a) - g, and from w1D."""
    factor = 2 * mp.cos(k * mp.pi / 2) / mp.pi
    return (
        factor * singular(lambda x: x**k * (g(a) - g(x)) / (r**2 - x**2) ** ((1 + k) / 2), ZERO, a),
        factor * singular(lambda x: x**k * w1D(x) / (r**2 - x**2) ** ((1 + k) / 2), ZERO, a),
    )


def displacement_inside(slope: Function, r: Any, a: Any, k: Any) -> Any:
    """Displacement (a length) at r < a: the depth gained since the contact passed r, and what it gave r before that."""

    def integrand(x: Any) -> Any:
        return (x / r) ** (1 + k) * mp.hyp2f1((1 + k) / 2, (1 + k) / 2, (3 + k) / 2, x**2 / r**2) * slope(x)

    return singular(slope, r, a) + 2 * mp.cos(k * mp.pi / 2) / (mp.pi * (1 + k)) * singular(integrand, ZERO, r)


def _abel(g: Function, r: Any, k: Any) -> Any:
    """int x**k g(x) (r**2 - x**2)**(-(1 + k)/2) dx over (0, r)."""
    return singular(lambda x: x**k * g(x) / (r**2 - x**2) ** ((1 + k) / 2), ZERO, r, max(0.0, float(1 + k) / 2))


def inside_by_parts(g: Function, r: Any, a: Any, k: Any) -> Any:
    """Displacement (a length) at r < a from g itself, by an Abel kernel."""
    return g(a) - 2 * mp.cos(k * mp.pi / 2) / mp.pi * _abel(g, r, k)


def inside_from_profile(f: Function, r: Any, d: Any) -> Any:
    """Displacement d - f(r), a length, to which the indenter forces the surface."""
    return d - f(r)


def profile_from_depth(g: Function, r: Any, k: Any) -> Any:
    """The profile f(r), a length, from g by quadrature."""
    return 2 * mp.cos(k * mp.pi / 2) / mp.pi * _abel(g, r, k)


def depth_from_slope(slope: Function, x: Any, k: Any, breaks: tuple[Any, ...] = ()) -> Any:
    """g(x), a length, from the slope of the profile by quadrature in panels between the breaks; x may be negative."""
    strongest = max(0.0, float(1 - k) / 2)
    return abs(x) ** (1 - k) * panels(
        lambda r: slope(r) / (x**2 - r**2) ** ((1 - k) / 2), ZERO, abs(x), breaks, strongest
    )


def _contact(draw: Draw) -> tuple[PowerSum, Any, Medium]:
    return draw.power_sum(), draw.length(), medium(draw)


def _depth_by_quadrature(f: PowerSum, k: Any) -> PowerSum:
    """(11.61) applied to a sum of powers: each integral over the unit interval scales with x**n."""
    strongest = max(0.0, float(1 - k) / 2)

    def unit(n: Any) -> Any:
        return singular(lambda x: n * x ** (n - 1) * ((1 - x) * (1 + x)) ** ((k - 1) / 2), ZERO, mp.mpf(1), strongest)

    return f.times(unit)


def _area_force(g: PowerSum, a: Any, m: Medium) -> Any:
    return total_force(lambda r: pressure(g, r, a, m.H, m.k), a)


@equation(48, depth_of_radius, "displacement of the centre by quadrature of (11.34) is g(a), smooth g")
def check_depth_of_radius(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """Displacement of the centre under the closed pressure of an even g, by quadrature of (11.34), beside g(a)."""
    g, a, m = draw.even_sum(), draw.length(), medium(draw)
    yield Residual(graded_centre(lambda r: even_pressure(g, r, a, m.H, m.k), a, m.H, m.k), formula(g, a), LENGTH)


@equation(49, force_increment, "its integral is a difference of forces over the area")
def check_force_increment(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """Difference of two forces, each a pressure over its area, beside each form integrated between the two radii."""
    g, first, m = _contact(draw)
    last = first * draw.number(1.2, 2)
    left = _area_force(g, last, m) - _area_force(g, first, m)
    dx = draw.length()
    side = singular(lambda x: formula(x, g.slope(x) * dx, g.slope, dx, m)[0] / dx, first, last)
    yield Residual(left, side, FORCE)
    side = singular(lambda x: formula(x, g.slope(x) * dx, g.slope, dx, m)[1] / dx, first, last)
    yield Residual(left, side, FORCE)


@equation(50, force_from_slope, "closed pressure of random powers integrated over the area")
def check_force_from_slope(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """The closed pressure of random powers, integrated over the area, beside the force from g'."""
    g, a, m = _contact(draw)
    yield Residual(_area_force(g, a, m), formula(g.slope, a, m), FORCE)


@equation(51, force_by_parts, "closed pressure integrated over the area against both forms")
def check_force_by_parts(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """The closed pressure of random powers, integrated over the area, beside both forms."""
    g, a, m = _contact(draw)
    yield from chain(_area_force(g, a, m), formula(g, g(a), a, m.foundation, m), FORCE)


@equation(52, pressure_increment, "its integral is a difference of closed pressures")
def check_pressure_increment(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """Difference of the closed pressures at two contact radii beside each form integrated from one to the other."""
    g, first, m = _contact(draw)
    last, r = first * draw.number(1.2, 2), first * draw.number(0.1, 0.9)
    left = pressure(g, r, last, m.H, m.k) - pressure(g, r, first, m.H, m.k)
    dx = draw.length()
    side = singular(lambda x: formula(r, x, g.slope(x) * dx, g.slope, dx, m)[0] / dx, first, last)
    yield Residual(left, side, STRESS)
    side = singular(lambda x: formula(r, x, g.slope(x) * dx, g.slope, dx, m)[1] / dx, first, last)
    yield Residual(left, side, STRESS)


@equation(
    53,
    pressure_from_slope,
    "closed pressure of random powers against both forms; closed graded pressures of the catalogue",
)
def check_pressure_from_slope(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """The closed pressure of random powers beside both integrals, that of catalogue profiles beside the second."""
    g, a, m = _contact(draw)
    r = a * draw.number(0.2, 0.9)
    sides = formula(g.slope, lambda x: -g.slope(x), m.foundation, r, a, m)
    yield from chain(pressure(g, r, a, m.H, m.k), sides, STRESS)

    def inverted(w1D_slope: Function, r: Any, a: Any, breaks: tuple[Any, ...]) -> Any:
        return formula(lambda x: -w1D_slope(x), w1D_slope, m.foundation, r, a, m, breaks)[1]

    yield from graded_catalogue_pressures(draw, inverted, m.H, m.k)


@equation(54, displacement_increment, "flat punch: depth at the centre, ring kernels outside")
def check_displacement_increment(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """Flat punches of pressure (11.47): the depth at the centre, ring kernels outside."""
    x, dd, m = draw.length(), draw.length(), medium(draw)

    def punch(t: Any) -> Any:
        return m.H * dd / (mp.pi * ((x - t) * (x + t)) ** ((1 - m.k) / 2))

    yield Residual(graded_centre(punch, x, m.H, m.k), formula(x * draw.number(0.1, 0.9), x, dd, m.k), LENGTH)
    r = x * draw.number(1.5, 3)
    yield Residual(graded_rings(punch, r, x, m.H, m.k), formula(r, x, dd, m.k), LENGTH)


@equation(55, displacement_from_slope, "ring kernels under the closed pressure, smooth g")
def check_displacement_from_slope(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """Displacement at r > a by ring kernels, under the closed pressure of an even g, beside the integral of g'."""
    g, a, m = draw.even_sum(2), draw.length(), medium(draw)
    r = a * draw.number(1.5, 3)
    left = graded_rings(lambda t: even_pressure(g, t, a, m.H, m.k), r, a, m.H, m.k)
    yield Residual(left, formula(g.slope, r, a, m.k), LENGTH)


@equation(56, displacement_by_parts, "ring kernels under the closed pressure against both forms")
def check_displacement_by_parts(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """Displacement at r > a by ring kernels, under the closed pressure of an even g, beside both forms."""
    g, a, m = draw.even_sum(2), draw.length(), medium(draw)
    r = a * draw.number(1.5, 3)
    left = graded_rings(lambda t: even_pressure(g, t, a, m.H, m.k), r, a, m.H, m.k)
    yield from chain(left, formula(g, lambda x: g(a) - g(x), r, a, m.k), LENGTH)


@equation(57, displacement_inside, "d - f(r) of random powers with g by quadrature")
def check_displacement_inside(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """d - f(r) of random powers, g found by quadrature of (11.61), beside both integrals of g'."""
    f, a, k = draw.power_sum(), draw.length(), exponent(draw)
    g = _depth_by_quadrature(f, k)
    r = a * draw.number(0.2, 0.9)
    yield Residual(g(a) - f(r), formula(g.slope, r, a, k), LENGTH)


@equation(58, inside_by_parts, "d - f(r) of random powers with g by quadrature")
def check_inside_by_parts(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """d - f(r) of random powers, g found by quadrature of (11.61), beside the Abel integral of g."""
    f, a, k = draw.power_sum(), draw.length(), exponent(draw)
    g = _depth_by_quadrature(f, k)
    r = a * draw.number(0.2, 0.9)
    yield Residual(g(a) - f(r), formula(g, r, a, k), LENGTH)


@equation(59, inside_from_profile, "closed pressure of a smooth g put into the double integral (11.34)")
def check_inside_from_profile(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """The pressure of g put into the double integral (11.34) leaves d - f under the indenter."""
    g, a, m = draw.even_sum(), draw.length(), medium(draw)
    f, r = g.times(lambda n: 1 / kappa(n, m.k)), a * draw.number(0.2, 0.6)

    def integrand(s: Any, phi: Any) -> Any:
        t = mp.sqrt(r**2 + s**2 + 2 * r * s * mp.cos(phi))
        return even_pressure(g, t, a, m.H, m.k) * s**-m.k

    left = mp.cos(m.k * mp.pi / 2) / (mp.pi * m.H) * around(integrand, r, a, -m.k, (1 + m.k) / 2)
    yield Residual(left, formula(f, r, g(a)), LENGTH)


@equation(60, profile_from_depth, "f of random powers from g by quadrature and from the closed g")
def check_profile_from_depth(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """f(r) of random powers beside the integral of g, which is found by quadrature and in closed form."""
    f, r, k = draw.power_sum(), draw.length(), exponent(draw)
    yield Residual(f(r), formula(_depth_by_quadrature(f, k), r, k), LENGTH)
    yield Residual(f(r), formula(f.times(lambda n: kappa(n, k)), r, k), LENGTH)


@equation(
    61,
    depth_from_slope,
    "closed g of random powers, (11.60) applied to it returns f; the graded depths of the catalogue",
)
def check_depth_from_slope(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """Closed g of random powers and of the catalogue beside the integral of f'; a power f beside (11.60) of its g."""
    f, a, k = draw.power_sum(), draw.length(), exponent(draw)
    g = f.times(lambda n: kappa(n, k))
    for x in (a, -a):
        yield Residual(g(a), formula(f.slope, x, k), LENGTH)
    power = draw.power_sum(terms=1)
    ((_, n),) = power.terms
    factor = 2 * mp.cos(k * mp.pi / 2) / mp.pi

    def integrand(x: Any) -> Any:
        return factor * x**k * formula(power.slope, x, k) / (a**2 - x**2) ** ((1 + k) / 2)

    yield Residual(power(a), weighted(integrand, ZERO, a, n + k, -(1 + k) / 2, density=0.8), LENGTH)
    yield from graded_catalogue_depths(draw, formula, k)
