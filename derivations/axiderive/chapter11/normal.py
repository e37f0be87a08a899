"""Normal contact of a profile on the homogeneous half-space, section 11.2, and on the graded one, section 11.5."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import mpmath as mp

from .equation import FORCE, LENGTH, STIFFNESS, STRESS, Draw, Formula, PowerSum, Residual, chain, equation
from .graded_punch import Medium, exponent, medium
from .quadrature import (
    area_force,
    around,
    even_pressure,
    graded_centre,
    graded_rings,
    kappa,
    panels,
    pressure,
    rings,
    singular,
    weighted,
)  # fmt: skip
from .round_trip import catalogue_depths, graded_catalogue_pressures

Function = Callable[[Any], Any]
ZERO = mp.mpf(0)


def depth_of_radius(g: Function, a: Any) -> Any:
    """The depth g(a), a length, at the contact radius a."""
    return g(a)


def force_by_parts(g: Function, d: Any, a: Any, E_star: Any) -> tuple[Any, Any, Any]:
    """Normal force from g by quadrature, in the three forms that integration by parts leaves."""
    return (
        2 * E_star * (a * g(a) - singular(g, ZERO, a)),
        2 * E_star * singular(lambda x: g(a) - g(x), ZERO, a),
        2 * E_star * singular(lambda x: d - g(x), ZERO, a),
    )


def pressure_by_increments(
    g: Function, slope: Function, radius: Function, r: Any, a: Any, E_star: Any
) -> tuple[Any, Any]:
    """Over the depth, which needs the radius as a function of it, and over the radius."""
    with mp.workdps(2 * mp.mp.dps + 10):  # an error of g(r) counts with its square root
        first, last = g(r), g(a)
    return (
        singular(lambda depth: 1 / mp.pi * E_star / mp.sqrt(radius(depth) ** 2 - r**2), first, last),
        singular(lambda x: 1 / mp.pi * E_star / mp.sqrt(x**2 - r**2) * slope(x), r, a),
    )


def displacement_by_increments(radius: Function, slope: Function, a: Any, d: Any) -> tuple[Any, Any]:
    """Displacement of the edge (a length), summed over the growing depth and over the growing radius."""
    return (
        2 / mp.pi * singular(lambda depth: mp.asin(radius(depth) / a), ZERO, d),
        2 / mp.pi * singular(lambda x: mp.asin(x / a) * slope(x), ZERO, a),
    )


def displacement_from_slope(slope: Function, a: Any) -> Any:
    """Displacement of the edge r = a (a length) from g', by quadrature."""
    return 2 / mp.pi * singular(lambda x: mp.asin(x / a) * slope(x), ZERO, a)


def _power(draw: Draw) -> tuple[PowerSum, Function]:
    """One power and its inverse."""
    g = draw.power_sum(terms=1)
    ((c, n),) = g.terms
    return g, lambda depth: (depth / c) ** (1 / n)


@equation(16, depth_of_radius, "displacement of the centre by ring kernels is g(a), smooth g")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, a, E_star = draw.even_sum(), draw.length(), draw.stress()
    yield Residual(rings(lambda r: even_pressure(g, r, a, E_star), ZERO, a, E_star), formula(g, a), LENGTH)


@equation(
    17,
    lambda stiffness, slope, a: singular(lambda x: stiffness(x) * slope(x), ZERO, a),
    "closed pressure of random powers integrated over the area",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, a, E_star = draw.power_sum(), draw.length(), draw.stress()
    yield Residual(area_force(g, a, E_star), formula(lambda x: 2 * E_star * x, g.slope, a), FORCE)


@equation(
    18, lambda x, E_star: 2 * E_star * x, "its integral over dg is a difference of forces; flat punch by ring kernels"
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, E_star = draw.power_sum(), draw.stress()
    first = draw.length()
    last = first * draw.number(1.2, 2)
    summed = singular(lambda x: formula(x, E_star) * g.slope(x), first, last)
    yield Residual(area_force(g, last, E_star) - area_force(g, first, E_star), summed, FORCE)
    depth = rings(lambda r: E_star / mp.sqrt(first**2 - r**2), ZERO, first, E_star)
    yield Residual(2 * mp.pi * E_star * first / depth, formula(first, E_star), STIFFNESS)


@equation(
    19,
    lambda slope, a, E_star: 2 * E_star * singular(lambda x: x * slope(x), ZERO, a),
    "closed pressure of random powers integrated over the area",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, a, E_star = draw.power_sum(), draw.length(), draw.stress()
    yield Residual(area_force(g, a, E_star), formula(g.slope, a, E_star), FORCE)


@equation(20, force_by_parts, "closed pressure integrated over the area against the three forms")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, a, E_star = draw.power_sum(), draw.length(), draw.stress()
    yield from chain(area_force(g, a, E_star), formula(g, g(a), a, E_star), FORCE)


@equation(
    21,
    lambda r, x, dd, E_star: 1 / mp.pi * E_star / mp.sqrt(x**2 - r**2) * dd,
    "its integral over dg is a difference of closed pressures",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, E_star = draw.power_sum(), draw.stress()
    first = draw.length()
    last, r = first * draw.number(1.2, 2), first * draw.number(0.1, 0.9)
    left = pressure(g, r, last, E_star) - pressure(g, r, first, E_star)
    yield Residual(left, singular(lambda x: formula(r, x, g.slope(x), E_star), first, last), STRESS)


@equation(22, pressure_by_increments, "both parametrisations against the closed pressure of a power")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    (g, radius), a, E_star = _power(draw), draw.length(), draw.stress()
    r = a * draw.number(0.1, 0.9)
    yield from chain(pressure(g, r, a, E_star), formula(g, g.slope, radius, r, a, E_star), STRESS)


@equation(
    23,
    lambda slope, r, a, E_star: E_star / mp.pi * singular(lambda x: 1 / mp.sqrt(x**2 - r**2) * slope(x), r, a),
    "closed pressure of random powers; its integral over the area is the force",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, a, E_star = draw.power_sum(), draw.length(), draw.stress()
    r = a * draw.number(0.1, 0.9)
    yield Residual(pressure(g, r, a, E_star), formula(g.slope, r, a, E_star), STRESS)
    even = draw.even_sum(2)
    force = 2 * E_star * mp.fsum(c * n / (n + 1) * a ** (n + 1) for c, n in even.terms)
    area = weighted(lambda t: 2 * mp.pi * t * formula(even.slope, t, a, E_star), ZERO, a, 0, mp.mpf(1) / 2, density=0.8)
    yield Residual(force, area, FORCE)


@equation(24, lambda x, a, dd: 2 / mp.pi * mp.asin(x / a) * dd, "displacement beside a flat punch by ring kernels")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    x, dd, E_star = draw.length(), draw.length(), draw.stress()
    a = x * draw.number(1.1, 3)
    left = rings(lambda t: E_star * dd / (mp.pi * mp.sqrt(x**2 - t**2)), a, x, E_star)
    yield Residual(left, formula(x, a, dd), LENGTH)


@equation(25, displacement_by_increments, "both forms against d - f of a power")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    (g, radius), a = _power(draw), draw.length()
    f = g.times(lambda n: 1 / kappa(n))
    yield from chain(g(a) - f(a), formula(radius, g.slope, a, g(a)), LENGTH)


@equation(26, displacement_from_slope, "displacement of the edge by ring kernels, smooth g")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, a, E_star = draw.even_sum(), draw.length(), draw.stress()
    left = rings(lambda r: even_pressure(g, r, a, E_star), a, a, E_star)
    yield Residual(left, formula(g.slope, a), LENGTH)


@equation(27, displacement_from_slope, "d - f(a) of random powers with g by quadrature")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    f, a = draw.power_sum(), draw.length()
    g = _depth_by_quadrature(f)
    yield Residual(g(a) - f(a), formula(g.slope, a), LENGTH)


@equation(
    28,
    lambda g, a: 2 / mp.pi * singular(lambda x: g(x) / mp.sqrt(a**2 - x**2), ZERO, a),
    "f from g by quadrature; f from the displacement by ring kernels",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    f, a = draw.power_sum(), draw.length()
    yield Residual(f(a), formula(_depth_by_quadrature(f), a), LENGTH)
    g, E_star, r = draw.even_sum(), draw.stress(), a * draw.number(0.2, 0.8)
    left = g(a) - rings(lambda t: even_pressure(g, t, a, E_star), r, a, E_star)
    yield Residual(left, formula(g, r), LENGTH)


@equation(
    29,
    lambda slope, a, breaks=(): a * panels(lambda x: slope(x) / mp.sqrt(a**2 - x**2), ZERO, a, breaks),
    "random powers, (11.28) applied to it returns f; the depths of the catalogue",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    f, a = draw.power_sum(), draw.length()
    yield Residual(f.times(kappa)(a), formula(f.slope, a), LENGTH)
    power = draw.power_sum(terms=1)
    ((_, n),) = power.terms
    back = weighted(
        lambda x: 2 / mp.pi * formula(power.slope, x) / mp.sqrt(a**2 - x**2), ZERO, a, n, -mp.mpf(1) / 2, 0.8
    )
    yield Residual(power(a), back, LENGTH)
    yield from catalogue_depths(draw, formula)


def force_increment(x: Any, dd: Any, slope: Function, dx: Any, m: Medium) -> tuple[Any, Any]:
    """Force added when a contact of radius x sinks by dd, and the same with g'(x) dx in the place of dd."""
    E0, c0, k, nu, h_N = m
    factor = 2 * h_N * E0 / ((1 - nu**2) * c0**k * (1 + k))
    return factor * x ** (1 + k) * dd, factor * x ** (1 + k) * slope(x) * dx


def graded_force_from_slope(slope: Function, a: Any, m: Medium) -> Any:
    """Normal force from g', by quadrature over the radii the contact has grown through."""
    E0, c0, k, nu, h_N = m
    return 2 * h_N * E0 / ((1 - nu**2) * c0**k * (1 + k)) * singular(lambda x: x ** (1 + k) * slope(x), ZERO, a)


def graded_force_by_parts(g: Function, d: Any, a: Any, foundation: Function, m: Medium) -> tuple[Any, Any]:
    """Normal force from g over the radii 0 to a, and from the springs of the foundation between -a and a."""
    E0, c0, k, nu, h_N = m
    return (
        2 * h_N * E0 / ((1 - nu**2) * c0**k) * singular(lambda x: x**k * (g(a) - g(x)), ZERO, a),
        panels(lambda x: foundation(x) * (d - g(abs(x))), -a, a, (ZERO,)),
    )


def graded_pressure_increment(r: Any, x: Any, dd: Any, slope: Function, dx: Any, m: Medium) -> tuple[Any, Any]:
    """Pressure added at r < x when a contact of radius x sinks by dd, and with g'(x) dx in the place of dd."""
    E0, c0, k, nu, h_N = m
    factor = h_N * E0 / (mp.pi * (1 - nu**2) * c0**k * (x**2 - r**2) ** ((1 - k) / 2))
    return factor * dd, factor * slope(x) * dx


def graded_pressure_from_slope(
    slope: Function, w1D_slope: Function, foundation: Function, r: Any, a: Any, m: Medium, breaks: tuple[Any, ...] = ()
) -> tuple[Any, Any]:
    """Pressure at r from the slope of g, and from the slope of w1D with the stiffness of the foundation at c_0."""
    E0, c0, k, nu, h_N = m

    def abel(f: Function) -> Any:
        return panels(lambda x: f(x) / (x**2 - r**2) ** ((1 - k) / 2), r, a, breaks, max(0.0, float(1 - k) / 2))

    return h_N * E0 / (mp.pi * (1 - nu**2) * c0**k) * abel(slope), -foundation(c0) / (mp.pi * c0**k) * abel(w1D_slope)


def _spread(x: Any, r: Any, k: Any) -> Any:
    """A pure number: how the displacement that a punch of radius x leaves falls off at r > x."""
    return (x / r) ** (1 + k) * mp.hyp2f1((1 + k) / 2, (1 + k) / 2, (3 + k) / 2, x**2 / r**2)


def graded_displacement_from_slope(slope: Function, r: Any, a: Any, k: Any) -> Any:
    """Displacement (a length) at r > a from the slope of g, by quadrature of a hypergeometric kernel."""
    return 2 * mp.cos(k * mp.pi / 2) / (mp.pi * (1 + k)) * singular(lambda x: _spread(x, r, k) * slope(x), ZERO, a)


def displacement_by_parts(g: Function, w1D: Function, r: Any, a: Any, k: Any) -> tuple[Any, Any]:
    """Displacement (a length) at r > a by an Abel kernel: from g(a) - g, and from w1D."""
    factor = 2 * mp.cos(k * mp.pi / 2) / mp.pi
    return (
        factor * singular(lambda x: x**k * (g(a) - g(x)) / (r**2 - x**2) ** ((1 + k) / 2), ZERO, a),
        factor * singular(lambda x: x**k * w1D(x) / (r**2 - x**2) ** ((1 + k) / 2), ZERO, a),
    )


def displacement_inside(slope: Function, r: Any, a: Any, k: Any) -> Any:
    """Displacement (a length) at r < a: the depth gained since the contact passed r, and what it gave r before that."""
    before = singular(lambda x: _spread(x, r, k) * slope(x), ZERO, r)
    return singular(slope, r, a) + 2 * mp.cos(k * mp.pi / 2) / (mp.pi * (1 + k)) * before


def _abel(g: Function, r: Any, k: Any) -> Any:
    """int x**k g(x) (r**2 - x**2)**(-(1 + k)/2) dx over (0, r)."""
    return singular(lambda x: x**k * g(x) / (r**2 - x**2) ** ((1 + k) / 2), ZERO, r, max(0.0, float(1 + k) / 2))


def graded_depth_from_slope(slope: Function, x: Any, k: Any, breaks: tuple[Any, ...] = ()) -> Any:
    """g(x), a length, from the slope of the profile by quadrature in panels between the breaks; x may be negative."""
    strongest = max(0.0, float(1 - k) / 2)
    return abs(x) ** (1 - k) * panels(
        lambda r: slope(r) / (x**2 - r**2) ** ((1 - k) / 2), ZERO, abs(x), breaks, strongest
    )


def _contact(draw: Draw) -> tuple[PowerSum, Any, Medium]:
    return draw.power_sum(), draw.length(), medium(draw)


def _depth_by_quadrature(f: PowerSum, k: Any = ZERO) -> PowerSum:
    """(11.29) or (11.61) applied to a sum of powers: each integral over the unit interval scales with x**n."""
    strongest = max(0.0, float(1 - k) / 2)

    def unit(n: Any) -> Any:
        return singular(lambda x: n * x ** (n - 1) * ((1 - x) * (1 + x)) ** ((k - 1) / 2), ZERO, mp.mpf(1), strongest)

    return f.times(unit)


@equation(48, depth_of_radius, "displacement of the centre by quadrature of (11.34) is g(a), smooth g")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, a, m = draw.even_sum(), draw.length(), medium(draw)
    yield Residual(graded_centre(lambda r: even_pressure(g, r, a, m.H, m.k), a, m.H, m.k), formula(g, a), LENGTH)


@equation(49, force_increment, "its integral is a difference of forces over the area")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, first, m = _contact(draw)
    last = first * draw.number(1.2, 2)
    left = area_force(g, last, m.H, m.k) - area_force(g, first, m.H, m.k)
    dx = draw.length()

    def summed(i: int) -> Any:
        return singular(lambda x: formula(x, g.slope(x) * dx, g.slope, dx, m)[i] / dx, first, last)

    yield from chain(left, (summed(0), summed(1)), FORCE)


@equation(50, graded_force_from_slope, "closed pressure of random powers integrated over the area")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, a, m = _contact(draw)
    yield Residual(area_force(g, a, m.H, m.k), formula(g.slope, a, m), FORCE)


@equation(51, graded_force_by_parts, "closed pressure integrated over the area against both forms")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, a, m = _contact(draw)
    yield from chain(area_force(g, a, m.H, m.k), formula(g, g(a), a, m.foundation, m), FORCE)


@equation(52, graded_pressure_increment, "its integral is a difference of closed pressures")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, first, m = _contact(draw)
    last, r = first * draw.number(1.2, 2), first * draw.number(0.1, 0.9)
    left = pressure(g, r, last, m.H, m.k) - pressure(g, r, first, m.H, m.k)
    dx = draw.length()

    def summed(i: int) -> Any:
        return singular(lambda x: formula(r, x, g.slope(x) * dx, g.slope, dx, m)[i] / dx, first, last)

    yield from chain(left, (summed(0), summed(1)), STRESS)


@equation(
    53,
    graded_pressure_from_slope,
    "closed pressure of random powers against both forms; closed graded pressures of the catalogue",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, a, m = _contact(draw)
    r = a * draw.number(0.2, 0.9)
    sides = formula(g.slope, lambda x: -g.slope(x), m.foundation, r, a, m)
    yield from chain(pressure(g, r, a, m.H, m.k), sides, STRESS)

    def inverted(w1D_slope: Function, r: Any, a: Any, breaks: tuple[Any, ...]) -> Any:
        return formula(lambda x: -w1D_slope(x), w1D_slope, m.foundation, r, a, m, breaks)[1]

    yield from graded_catalogue_pressures(draw, inverted, m.H, m.k)


@equation(
    54,
    lambda r, x, dd, k: dd if r < x else 2 * mp.cos(k * mp.pi / 2) / (mp.pi * (1 + k)) * _spread(x, r, k) * dd,
    "flat punch: depth at the centre, ring kernels outside",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    x, dd, m = draw.length(), draw.length(), medium(draw)

    def punch(t: Any) -> Any:
        return m.H * dd / (mp.pi * ((x - t) * (x + t)) ** ((1 - m.k) / 2))

    yield Residual(graded_centre(punch, x, m.H, m.k), formula(x * draw.number(0.1, 0.9), x, dd, m.k), LENGTH)
    r = x * draw.number(1.5, 3)
    yield Residual(graded_rings(punch, r, x, m.H, m.k), formula(r, x, dd, m.k), LENGTH)


@equation(55, graded_displacement_from_slope, "ring kernels under the closed pressure, smooth g")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, a, m = draw.even_sum(2), draw.length(), medium(draw)
    r = a * draw.number(1.5, 3)
    left = graded_rings(lambda t: even_pressure(g, t, a, m.H, m.k), r, a, m.H, m.k)
    yield Residual(left, formula(g.slope, r, a, m.k), LENGTH)


@equation(56, displacement_by_parts, "ring kernels under the closed pressure against both forms")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, a, m = draw.even_sum(2), draw.length(), medium(draw)
    r = a * draw.number(1.5, 3)
    left = graded_rings(lambda t: even_pressure(g, t, a, m.H, m.k), r, a, m.H, m.k)
    yield from chain(left, formula(g, lambda x: g(a) - g(x), r, a, m.k), LENGTH)


@equation(57, displacement_inside, "d - f(r) of random powers with g by quadrature")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    f, a, k = draw.power_sum(), draw.length(), exponent(draw)
    g = _depth_by_quadrature(f, k)
    r = a * draw.number(0.2, 0.9)
    yield Residual(g(a) - f(r), formula(g.slope, r, a, k), LENGTH)


@equation(
    58,
    lambda g, r, a, k: g(a) - 2 * mp.cos(k * mp.pi / 2) / mp.pi * _abel(g, r, k),
    "d - f(r) of random powers with g by quadrature",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    f, a, k = draw.power_sum(), draw.length(), exponent(draw)
    g = _depth_by_quadrature(f, k)
    r = a * draw.number(0.2, 0.9)
    yield Residual(g(a) - f(r), formula(g, r, a, k), LENGTH)


@equation(59, lambda f, r, d: d - f(r), "closed pressure of a smooth g put into the double integral (11.34)")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, a, m = draw.even_sum(), draw.length(), medium(draw)
    f, r = g.times(lambda n: 1 / kappa(n, m.k)), a * draw.number(0.2, 0.6)

    def integrand(s: Any, phi: Any) -> Any:
        t = mp.sqrt(r**2 + s**2 + 2 * r * s * mp.cos(phi))
        return even_pressure(g, t, a, m.H, m.k) * s**-m.k

    left = mp.cos(m.k * mp.pi / 2) / (mp.pi * m.H) * around(integrand, r, a, -m.k, (1 + m.k) / 2)
    yield Residual(left, formula(f, r, g(a)), LENGTH)


@equation(
    60,
    lambda g, r, k: 2 * mp.cos(k * mp.pi / 2) / mp.pi * _abel(g, r, k),
    "f of random powers from g by quadrature and from the closed g",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    f, r, k = draw.power_sum(), draw.length(), exponent(draw)
    yield Residual(f(r), formula(_depth_by_quadrature(f, k), r, k), LENGTH)
    yield Residual(f(r), formula(f.times(lambda n: kappa(n, k)), r, k), LENGTH)


@equation(
    61,
    graded_depth_from_slope,
    "closed g of random powers, (11.60) applied to it returns f; the graded depths of the catalogue",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
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
    yield from catalogue_depths(draw, formula, k)
