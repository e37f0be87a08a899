"""Section 11.7: tangential contact, (11.67)-(11.80).

Cerruti's solution is the independent route for tangential displacements: at a
point inside, a traction tau along x moves the surface by
1/(2 pi G) int int tau [(1 - nu) + nu cos(phi)**2] ds dphi around the point.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import mpmath as mp

from .equation import FORCE, LENGTH, NUMBER, STRESS, Draw, Formula, PowerSum, Residual, equation
from .quadrature import area_force, around, even_pressure, pressure, rings, singular, total_force

Function = Callable[[Any], Any]
ZERO = mp.mpf(0)
HALF = mp.mpf(1) / 2


class Solid(NamedTuple):
    """One elastic half-space under a rigid body: G, nu and the effective moduli."""

    G: Any
    nu: Any

    @property
    def E_star(self) -> Any:
        """Effective modulus of the normal contact, a stress."""
        return 2 * self.G / (1 - self.nu)

    @property
    def G_star(self) -> Any:
        """Effective modulus of the tangential contact, a stress."""
        return 4 * self.G / (2 - self.nu)


def load(slope: Function, r: Any, a: Any, modulus: Any) -> tuple[Any, Any]:
    """Force, and stress at r, from the slope of g or h by quadrature; the modulus is that of their direction."""
    return (
        2 * modulus * singular(lambda x: x * slope(x), ZERO, a),
        modulus / mp.pi * singular(lambda x: 1 / mp.sqrt(x**2 - r**2) * slope(x), r, a),
    )


def force_of_second_step(
    h_slope: Function, g_slope: Function, lam: Any, c: Any, a: Any, G_star: Any
) -> tuple[Any, Any]:
    """Tangential force gained while the contact grows from c to a: from the slope of h, and from lam and that of g."""
    return (
        2 * G_star * singular(lambda x: x * h_slope(x), c, a),
        2 * G_star * lam * singular(lambda x: x * g_slope(x), c, a),
    )


def traction_of_second_step(slope: Function, lam: Any, r: Any, c: Any, a: Any, G_star: Any) -> Any:
    """Traction at r gained while the contact grows from c to a, by quadrature; at r > c it begins when r is reached."""
    if r < c:
        return G_star / mp.pi * lam * singular(lambda x: 1 / mp.sqrt(x**2 - r**2) * slope(x), c, a)
    return G_star / mp.pi * lam * singular(lambda x: 1 / mp.sqrt(x**2 - r**2) * slope(x), r, a)


def friction(lam: Any, G_star: Any, E_star: Any) -> Any:
    """The coefficient of friction, a pure number."""
    return lam * G_star / E_star


def solution(slope: Function, mu: Any, r: Any, c: Any, a: Any, E_star: Any) -> tuple[Any, Any]:
    """Tangential force, and traction at r, by quadrature; c is the radius of the stuck circle."""

    def abel(end: Any) -> Any:
        return singular(lambda x: 1 / mp.sqrt(x**2 - r**2) * slope(x), r, end)

    force = 2 * mu * E_star * singular(lambda x: x * slope(x), c, a)
    if r < c:
        return force, mu * E_star / mp.pi * (abel(a) - abel(c))
    return force, mu * E_star / mp.pi * abel(a)


def traction_by_pressures(p: Callable[[Any, Any], Any], mu: Any, r: Any, c: Any, a: Any) -> Any:
    """Traction at r from the pressures p(r, a) and p(r, c) at two contact radii."""
    if r < c:
        return mu * (p(r, a) - p(r, c))
    return mu * p(r, a)


def cerruti(tau: Function, r: Any, a: Any, edge: Any, solid: Solid) -> Any:
    """u_x at the point (r, 0) inside a disc under the traction tau along x."""

    def integrand(s: Any, phi: Any) -> Any:
        t = mp.sqrt(r**2 + s**2 + 2 * r * s * mp.cos(phi))
        return tau(t) * (1 - solid.nu + solid.nu * mp.cos(phi) ** 2)

    return around(integrand, r, a, upper=edge) / (2 * mp.pi * solid.G)


def _solid(draw: Draw) -> Solid:
    return Solid(draw.stress(5, 50), draw.number(0, 0.5))


def _radii(draw: Draw) -> tuple[Any, Any]:
    """Stick radius c and contact radius a."""
    a = draw.length()
    return a * draw.number(0.4, 0.8), a


def _slipping(draw: Draw) -> tuple[PowerSum, Any, Any, Solid, Any]:
    """g, both radii, the half-space, and the ratio of the sideways increments to those of the depth."""
    return draw.power_sum(), *_radii(draw), _solid(draw), draw.number(0.2, 1)


def _places(draw: Draw, c: Any, a: Any) -> tuple[Any, Any]:
    """A radius that sticks and one that slips."""
    return c * draw.number(0.1, 0.9), c + (a - c) * draw.number(0.1, 0.9)


def _superposed(g: PowerSum, mu: Any, r: Any, c: Any, a: Any, E_star: Any) -> Any:
    """Closed traction of random powers."""
    inner = pressure(g, r, c, E_star) if r < c else mp.mpf(0)
    return mu * (pressure(g, r, a, E_star) - inner)


def _stuck_displacement(g: PowerSum, mu: Any, r: Any, c: Any, a: Any, solid: Solid) -> Any:
    """u_x at r < c by Cerruti's kernel under mu [p(.; a) - p(.; c)], each on its own disc."""
    full = cerruti(lambda t: even_pressure(g, t, a, solid.E_star), r, a, HALF, solid)
    core = cerruti(lambda t: even_pressure(g, t, c, solid.E_star), r, c, HALF, solid)
    return mu * (full - core)


@equation(
    67,
    lambda r, a, d, E_star: (2 * E_star * a * d, 1 / mp.pi * E_star * d / mp.sqrt(a**2 - r**2)),
    "depth by ring kernels; force and pressure from (11.1)",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, d, solid = draw.length(), draw.length(), _solid(draw)
    r = a * draw.number(0.1, 0.9)
    p0 = solid.E_star * d / (mp.pi * a)

    def punch(t: Any) -> Any:
        return formula(t, a, d, solid.E_star)[1]

    yield Residual(rings(punch, ZERO, a, solid.E_star), d, LENGTH)
    force, p = formula(r, a, d, solid.E_star)
    yield Residual(total_force(lambda t: p0 / mp.sqrt(1 - t**2 / a**2), a), force, FORCE)
    yield Residual(p0 / mp.sqrt(1 - r**2 / a**2), p, STRESS)


@equation(
    68,
    lambda r, a, u0, G_star: (2 * G_star * a * u0, 1 / mp.pi * G_star * u0 / mp.sqrt(a**2 - r**2)),
    "displacement by Cerruti's kernel at r < a; force 8 G a u0/(2 - nu)",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, u0, solid = draw.length(), draw.length(), _solid(draw)
    r = a * draw.number(0.2, 0.6)
    shear = cerruti(lambda t: formula(t, a, u0, solid.G_star)[1], r, a, -HALF, solid)
    yield Residual(shear, u0, LENGTH)
    yield Residual(solid.G_star * u0 / (mp.pi * mp.sqrt(a**2 - r**2)), formula(r, a, u0, solid.G_star)[1], STRESS)
    yield Residual(8 * solid.G * a * u0 / (2 - solid.nu), formula(r, a, u0, solid.G_star)[0], FORCE)


@equation(
    69,
    lambda g, h, a: (g(a), h(a)),
    "displacements of the centre by ring kernels and by Cerruti's kernel, smooth g and h",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, h, a, solid = draw.even_sum(), draw.even_sum(1), draw.length(), _solid(draw)
    r = a * mp.mpf(10) ** -30
    depth, shift = formula(g, h, a)
    yield Residual(rings(lambda t: even_pressure(g, t, a, solid.E_star), ZERO, a, solid.E_star), depth, LENGTH)
    yield Residual(cerruti(lambda t: even_pressure(h, t, a, solid.G_star), r, a, HALF, solid), shift, LENGTH)


@equation(70, load, "closed pressure of random powers and its integral over the area")
@equation(71, load, "closed traction of random powers and its integral over the area")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, a, modulus = draw.power_sum(), draw.length(), draw.stress()
    r = a * draw.number(0.1, 0.9)
    force, stress = formula(g.slope, r, a, modulus)
    yield Residual(area_force(g, a, modulus), force, FORCE)
    yield Residual(pressure(g, r, a, modulus), stress, STRESS)


@equation(
    72, lambda lam, dg: lam * dg, "displacement of the stuck circle by Cerruti's kernel is the sum of the increments"
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, (c, a), solid, lam = draw.even_sum(2), _radii(draw), _solid(draw), draw.number(0.2, 1)
    mu = lam * solid.G_star / solid.E_star
    summed = singular(lambda x: formula(lam, g.slope(x)), c, a)
    yield Residual(_stuck_displacement(g, mu, c * draw.number(0.2, 0.6), c, a, solid), summed, LENGTH)


@equation(73, force_of_second_step, "both forms against mu [F(a) - F(c)], forces over the area")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, c, a, solid, lam = _slipping(draw)
    mu = lam * solid.G_star / solid.E_star
    whole, core = (area_force(g, end, solid.E_star) for end in (a, c))
    for side in formula(lambda x: lam * g.slope(x), g.slope, lam, c, a, solid.G_star):
        yield Residual(mu * (whole - core), side, FORCE)


@equation(74, traction_of_second_step, "stick and slip: closed p(r; a) - p(r; c) of random powers")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, c, a, solid, lam = _slipping(draw)
    mu = lam * solid.G_star / solid.E_star
    for r in _places(draw, c, a):
        left = _superposed(g, mu, r, c, a, solid.E_star)
        yield Residual(left, formula(g.slope, lam, r, c, a, solid.G_star), STRESS)


@equation(75, lambda p, lam, G_star, E_star: lam * G_star / E_star * p, "integral of the second step in the slip ring")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, c, a, solid, lam = _slipping(draw)
    r = c + (a - c) * draw.number(0.1, 0.9)
    left = traction_of_second_step(g.slope, lam, r, c, a, solid.G_star)
    yield Residual(left, formula(pressure(g, r, a, solid.E_star), lam, solid.G_star, solid.E_star), STRESS)


@equation(76, friction, "traction over pressure in the slip ring; forces of full slip")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, c, a, solid, lam = _slipping(draw)
    r = c + (a - c) * draw.number(0.1, 0.9)
    mu = formula(lam, solid.G_star, solid.E_star)
    left = traction_of_second_step(g.slope, lam, r, c, a, solid.G_star) / pressure(g, r, a, solid.E_star)
    yield Residual(left, mu, NUMBER)
    sliding = force_of_second_step(g.slope, g.slope, lam, ZERO, a, solid.G_star)[1]
    yield Residual(sliding / total_force(lambda t: pressure(g, t, a, solid.E_star), a), mu, NUMBER)


@equation(
    77,
    lambda u0, mu, p: (u0, mu * p),
    "Cerruti's displacement at two points of the stuck circle; traction in the slip ring",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, (c, a), solid, mu = draw.even_sum(2), _radii(draw), _solid(draw), draw.number(0.1, 0.9)
    slip = c + (a - c) * draw.number(0.1, 0.9)
    u0 = mu * solid.E_star / solid.G_star * (g(a) - g(c))
    stuck, sliding = formula(u0, mu, pressure(g, slip, a, solid.E_star))
    for share in (0.2, 0.5):
        yield Residual(_stuck_displacement(g, mu, c * draw.number(share, share + 0.1), c, a, solid), stuck, LENGTH)
    lam = mu * solid.E_star / solid.G_star
    yield Residual(traction_of_second_step(g.slope, lam, slip, c, a, solid.G_star), sliding, STRESS)


@equation(78, solution, "force over the area; closed tractions, stick and slip")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, (c, a), E_star, mu = draw.power_sum(), _radii(draw), draw.stress(), draw.number(0.1, 0.9)
    whole, core = (area_force(g, end, E_star) for end in (a, c))
    for r in _places(draw, c, a):
        force, tau = formula(g.slope, mu, r, c, a, E_star)
        yield Residual(mu * (whole - core), force, FORCE)
        yield Residual(_superposed(g, mu, r, c, a, E_star), tau, STRESS)


@equation(79, traction_by_pressures, "integral of the second step, stick and slip")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, (c, a), solid, mu = draw.power_sum(), _radii(draw), _solid(draw), draw.number(0.1, 0.9)
    lam = mu * solid.E_star / solid.G_star
    for r in _places(draw, c, a):
        right = formula(lambda t, end: pressure(g, t, end, solid.E_star), mu, r, c, a)
        yield Residual(traction_of_second_step(g.slope, lam, r, c, a, solid.G_star), right, STRESS)


@equation(
    80,
    lambda g, mu, c, a, E_star, G_star: mu * E_star / G_star * (g(a) - g(c)),
    "displacement of the stuck circle by Cerruti's kernel",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    g, (c, a), solid, mu = draw.even_sum(2), _radii(draw), _solid(draw), draw.number(0.1, 0.9)
    left = _stuck_displacement(g, mu, c * draw.number(0.2, 0.6), c, a, solid)
    yield Residual(left, formula(g, mu, c, a, solid.E_star, solid.G_star), LENGTH)
