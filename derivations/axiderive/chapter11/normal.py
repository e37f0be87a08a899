"""Section 11.2: normal contact of a profile on the homogeneous half-space, (11.16)-(11.29)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import mpmath as mp

from .equation import FORCE, LENGTH, STIFFNESS, STRESS, Draw, Formula, PowerSum, Residual, chain, equation
from .quadrature import even_pressure, kappa, panels, pressure, rings, singular, total_force, weighted
from .round_trip import catalogue_depths

Function = Callable[[Any], Any]
ZERO = mp.mpf(0)


def depth_of_radius(g: Function, a: Any) -> Any:
    """The depth g(a), a length, at the contact radius a."""
    return g(a)


def force_by_increments(stiffness: Function, slope: Function, a: Any) -> Any:
    """Normal force: stiffness times the slope of g, integrated over the radii the contact has grown through."""
    return singular(lambda x: stiffness(x) * slope(x), ZERO, a)


def differential_stiffness(x: Any, E_star: Any) -> Any:
    """Stiffness (force over length) of a contact of radius x."""
    return 2 * E_star * x


def force_from_slope(slope: Function, a: Any, E_star: Any) -> Any:
    """Normal force from g', by quadrature."""
    return 2 * E_star * singular(lambda x: x * slope(x), ZERO, a)


def force_by_parts(g: Function, d: Any, a: Any, E_star: Any) -> tuple[Any, Any, Any]:
    """Normal force from g by quadrature, in the three forms that integration by parts leaves."""
    return (
        2 * E_star * (a * g(a) - singular(g, ZERO, a)),
        2 * E_star * singular(lambda x: g(a) - g(x), ZERO, a),
        2 * E_star * singular(lambda x: d - g(x), ZERO, a),
    )


def pressure_increment(r: Any, x: Any, dd: Any, E_star: Any) -> Any:
    """Pressure added at r < x when a contact of radius x sinks by dd."""
    return 1 / mp.pi * E_star / mp.sqrt(x**2 - r**2) * dd


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


def pressure_from_slope(slope: Function, r: Any, a: Any, E_star: Any) -> Any:
    """Pressure at r from g', by quadrature over the contact radii from r to a."""
    return E_star / mp.pi * singular(lambda x: 1 / mp.sqrt(x**2 - r**2) * slope(x), r, a)


def displacement_increment(x: Any, a: Any, dd: Any) -> Any:
    """Displacement (a length) added at the radius a when a contact of radius x < a sinks by dd."""
    return 2 / mp.pi * mp.asin(x / a) * dd


def displacement_by_increments(radius: Function, slope: Function, a: Any, d: Any) -> tuple[Any, Any]:
    """Displacement of the edge (a length), summed over the growing depth and over the growing radius."""
    return (
        2 / mp.pi * singular(lambda depth: mp.asin(radius(depth) / a), ZERO, d),
        2 / mp.pi * singular(lambda x: mp.asin(x / a) * slope(x), ZERO, a),
    )


def displacement_from_slope(slope: Function, a: Any) -> Any:
    """Displacement of the edge r = a (a length) from g', by quadrature."""
    return 2 / mp.pi * singular(lambda x: mp.asin(x / a) * slope(x), ZERO, a)


def profile_from_depth(g: Function, a: Any) -> Any:
    """The profile f(a), a length, from g by quadrature."""
    return 2 / mp.pi * singular(lambda x: g(x) / mp.sqrt(a**2 - x**2), ZERO, a)


def depth_from_slope(slope: Function, a: Any, breaks: tuple[Any, ...] = ()) -> Any:
    """g(a), a length, from the slope of the profile by quadrature in panels between the breaks."""
    return a * panels(lambda x: slope(x) / mp.sqrt(a**2 - x**2), ZERO, a, breaks)


def _power(draw: Draw) -> tuple[PowerSum, Function]:
    """One power and its inverse."""
    g = draw.power_sum(terms=1)
    ((c, n),) = g.terms
    return g, lambda depth: (depth / c) ** (1 / n)


def _depth_by_quadrature(f: PowerSum) -> PowerSum:
    """(11.29) applied to a sum of powers: the integral of each power over the unit interval scales with a**n."""
    return f.times(lambda n: singular(lambda x: n * x ** (n - 1) / mp.sqrt((1 - x) * (1 + x)), ZERO, mp.mpf(1)))


@equation(16, depth_of_radius, "displacement of the centre by ring kernels is g(a), smooth g")
def check_depth_of_radius(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """Displacement of the centre by ring kernels, under the closed pressure of an even g, beside g(a)."""
    g, a, E_star = draw.even_sum(), draw.length(), draw.stress()
    yield Residual(rings(lambda r: even_pressure(g, r, a, E_star), ZERO, a, E_star), formula(g, a), LENGTH)


@equation(17, force_by_increments, "closed pressure of random powers integrated over the area")
def check_force_by_increments(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """The closed pressure of random powers, integrated over the area, beside the integral of the stiffness 2 E* x."""
    g, a, E_star = draw.power_sum(), draw.length(), draw.stress()
    left = total_force(lambda r: pressure(g, r, a, E_star), a)
    yield Residual(left, formula(lambda x: 2 * E_star * x, g.slope, a), FORCE)


@equation(18, differential_stiffness, "its integral over dg is a difference of forces; flat punch by ring kernels")
def check_differential_stiffness(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """Difference of two area forces beside the integral over dg; force over depth of a flat punch beside the value."""
    g, E_star = draw.power_sum(), draw.stress()
    first = draw.length()
    last = first * draw.number(1.2, 2)
    before = total_force(lambda r: pressure(g, r, first, E_star), first)
    after = total_force(lambda r: pressure(g, r, last, E_star), last)
    summed = singular(lambda x: formula(x, E_star) * g.slope(x), first, last)
    yield Residual(after - before, summed, FORCE)
    depth = rings(lambda r: E_star / mp.sqrt(first**2 - r**2), ZERO, first, E_star)
    yield Residual(2 * mp.pi * E_star * first / depth, formula(first, E_star), STIFFNESS)


@equation(19, force_from_slope, "closed pressure of random powers integrated over the area")
def check_force_from_slope(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """The closed pressure of random powers, integrated over the area, beside the force from g'."""
    g, a, E_star = draw.power_sum(), draw.length(), draw.stress()
    yield Residual(total_force(lambda r: pressure(g, r, a, E_star), a), formula(g.slope, a, E_star), FORCE)


@equation(20, force_by_parts, "closed pressure integrated over the area against the three forms")
def check_force_by_parts(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """The closed pressure of random powers, integrated over the area, beside each of the three forms."""
    g, a, E_star = draw.power_sum(), draw.length(), draw.stress()
    left = total_force(lambda r: pressure(g, r, a, E_star), a)
    yield from chain(left, formula(g, g(a), a, E_star), FORCE)


@equation(21, pressure_increment, "its integral over dg is a difference of closed pressures")
def check_pressure_increment(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """Difference of the closed pressures at two contact radii beside the integral over dg from one to the other."""
    g, E_star = draw.power_sum(), draw.stress()
    first = draw.length()
    last, r = first * draw.number(1.2, 2), first * draw.number(0.1, 0.9)
    left = pressure(g, r, last, E_star) - pressure(g, r, first, E_star)
    yield Residual(left, singular(lambda x: formula(r, x, g.slope(x), E_star), first, last), STRESS)


@equation(22, pressure_by_increments, "both parametrisations against the closed pressure of a power")
def check_pressure_by_increments(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """The closed pressure of one random power beside the integral over the depth and the one over the radius."""
    (g, radius), a, E_star = _power(draw), draw.length(), draw.stress()
    r = a * draw.number(0.1, 0.9)
    yield from chain(pressure(g, r, a, E_star), formula(g, g.slope, radius, r, a, E_star), STRESS)


@equation(23, pressure_from_slope, "closed pressure of random powers; its integral over the area is the force")
def check_pressure_from_slope(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """Closed pressure of random powers beside the integral of g', whose area integral is beside the closed force."""
    g, a, E_star = draw.power_sum(), draw.length(), draw.stress()
    r = a * draw.number(0.1, 0.9)
    yield Residual(pressure(g, r, a, E_star), formula(g.slope, r, a, E_star), STRESS)
    even = draw.even_sum(2)
    force = 2 * E_star * mp.fsum(c * n / (n + 1) * a ** (n + 1) for c, n in even.terms)
    area = weighted(lambda t: 2 * mp.pi * t * formula(even.slope, t, a, E_star), ZERO, a, 0, mp.mpf(1) / 2, density=0.8)
    yield Residual(force, area, FORCE)


@equation(24, displacement_increment, "displacement beside a flat punch by ring kernels")
def check_displacement_increment(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """Displacement at r = a outside a flat punch of radius x, by ring kernels, beside the arcsine."""
    x, dd, E_star = draw.length(), draw.length(), draw.stress()
    a = x * draw.number(1.1, 3)
    left = rings(lambda t: E_star * dd / (mp.pi * mp.sqrt(x**2 - t**2)), a, x, E_star)
    yield Residual(left, formula(x, a, dd), LENGTH)


@equation(25, displacement_by_increments, "both forms against d - f of a power")
def check_displacement_by_increments(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """d - f(a) of one random power, g in closed form, beside both integrals."""
    (g, radius), a = _power(draw), draw.length()
    f = g.times(lambda n: 1 / kappa(n))
    yield from chain(g(a) - f(a), formula(radius, g.slope, a, g(a)), LENGTH)


@equation(26, displacement_from_slope, "displacement of the edge by ring kernels, smooth g")
def check_displacement_from_slope(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """Displacement of the edge by ring kernels, under the closed pressure of an even g, beside the integral of g'."""
    g, a, E_star = draw.even_sum(), draw.length(), draw.stress()
    left = rings(lambda r: even_pressure(g, r, a, E_star), a, a, E_star)
    yield Residual(left, formula(g.slope, a), LENGTH)


@equation(27, displacement_from_slope, "d - f(a) of random powers with g by quadrature")
def check_gap_at_edge(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """d - f(a) of random powers, g found by quadrature of (11.29), beside the integral of g'."""
    f, a = draw.power_sum(), draw.length()
    g = _depth_by_quadrature(f)
    yield Residual(g(a) - f(a), formula(g.slope, a), LENGTH)


@equation(28, profile_from_depth, "f from g by quadrature; f from the displacement by ring kernels")
def check_profile_from_depth(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """f of random powers, and d less the displacement by ring kernels, each beside the integral of g."""
    f, a = draw.power_sum(), draw.length()
    yield Residual(f(a), formula(_depth_by_quadrature(f), a), LENGTH)
    g, E_star, r = draw.even_sum(), draw.stress(), a * draw.number(0.2, 0.8)
    left = g(a) - rings(lambda t: even_pressure(g, t, a, E_star), r, a, E_star)
    yield Residual(left, formula(g, r), LENGTH)


@equation(29, depth_from_slope, "random powers, (11.28) applied to it returns f; the depths of the catalogue")
def check_depth_from_slope(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """Closed g of random powers and of the catalogue beside the integral of f'; a power f beside (11.28) of its g."""
    f, a = draw.power_sum(), draw.length()
    yield Residual(f.times(kappa)(a), formula(f.slope, a), LENGTH)
    power = draw.power_sum(terms=1)
    ((_, n),) = power.terms
    back = weighted(
        lambda x: 2 / mp.pi * formula(power.slope, x) / mp.sqrt(a**2 - x**2), ZERO, a, n, -mp.mpf(1) / 2, 0.8
    )
    yield Residual(power(a), back, LENGTH)
    yield from catalogue_depths(draw, formula)
