"""Integration rules of the checks, and routes that are independent of the chapter's.

No rule estimates its own error; agreement with another route is the measure.  The routes: displacement of a loaded
disc by rings or by chords, known pressures of power laws, and pressures p0 (1 - r**2/a**2)**s, Föppl's three among
them, with the closed displacement of their chords.  The ring kernels are exact: (11.2) integrated over the angle is an
arithmetic-geometric mean, (11.34) a hypergeometric function of (t/r)**2.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Any

import mpmath as mp

from .equation import Draw, PowerSum

Function = Callable[[Any], Any]


@lru_cache(maxsize=16)
def _tanh_sinh(wanted: int, carried: int) -> tuple[tuple[Any, Any, Any], ...]:
    """(u, 1 - u, weight) on (0, 1) for `wanted` digits, as far as u and 1 - u stay above 10**-carried."""
    with mp.workdps(carried):
        step = mp.pi**2 / (wanted * mp.log(10)) * mp.mpf("0.45")
        last = int(mp.asinh(carried * mp.log(10) / mp.pi) / step)
        nodes = []
        for i in range(-last, last + 1):
            y = mp.exp(-mp.pi * mp.sinh(i * step))
            u, v = 1 / (1 + y), y / (1 + y)
            nodes.append((u, v, step * mp.pi * mp.cosh(i * step) * u * v))
        return tuple(nodes)


def singular(f: Function, lo: Any, hi: Any, strongest: float = 0.5) -> Any:
    """int f over (lo, hi) whatever happens at the ends, by the tanh-sinh rule.

    f is evaluated at a precision at which the rounding of x next to an end
    where f grows like the power -`strongest` costs none of the digits wanted.
    """
    wanted = mp.mp.dps
    carried = int(wanted / (1 - strongest)) + 5
    width = hi - lo
    offset = max(abs(lo), abs(hi)) / abs(width)
    with mp.workdps(carried + int(mp.log10(offset)) + 1):
        width = hi - lo
        nodes = _tanh_sinh(wanted, carried)
        total = width * mp.fsum(w * f(lo + width * u if u < v else hi - width * v) for u, v, w in nodes)
    return +total


def panels(f: Function, lo: Any, hi: Any, breaks: tuple[Any, ...] = (), strongest: float = 0.5) -> Any:
    """The same where f may also have kinks, jumps or singularities at the breaks."""
    ends = (lo, *breaks, hi)
    return mp.fsum(singular(f, x, y, strongest) for x, y in zip(ends, ends[1:], strict=False))


def to_infinity(f: Function, lo: Any) -> Any:
    """int f over (lo, oo) for an f that falls off like exp(-x), at worst 1/sqrt at lo; x = lo + exp(t - exp(-t))."""
    wanted = mp.mp.dps
    with mp.workdps(2 * wanted + 5):
        step = mp.pi**2 / (wanted * mp.log(10)) * mp.mpf("0.45")
        reach = mp.log(3 * wanted * mp.log(10))
        total = mp.mpf(0)
        for i in range(int(-reach / step), int(reach / step) + 1):
            fall = mp.exp(-i * step)
            x = mp.exp(i * step - fall)
            total += x * (1 + fall) * f(lo + x)
        total *= step
    return +total


@lru_cache(maxsize=64)
def _jacobi(nodes: int, lower: Any, upper: Any, precision: int) -> tuple[tuple[Any, Any], ...]:
    """(u, weight / (u**lower (1 - u)**upper)) of the Gauss rule on (0, 1)."""
    with mp.workprec(precision + 30):
        rule = zip(*mp.gauss_quadrature(nodes, "jacobi", upper, lower), strict=True)
        halved = (((1 + z) / 2, (1 - z) / 2, weight) for z, weight in sorted(rule))
        return tuple((u, weight / (2 ** (lower + upper + 1) * u**lower * v**upper)) for u, v, weight in halved)


def weighted(f: Function, lo: Any, hi: Any, lower: Any = 0, upper: Any = 0, density: float = 1.3) -> Any:
    """int f over (lo, hi) where f behaves like (x - lo)**lower and (hi - x)**upper times analytic factors.

    `density` is the number of nodes per digit; 1.3 serves down to singularities a fifth of the interval away.
    """
    width = hi - lo
    nodes = int(density * mp.mp.dps)
    return width * mp.fsum(w * f(lo + width * u) for u, w in _jacobi(nodes, mp.mpf(lower), mp.mpf(upper), mp.mp.prec))


def half_turn(f: Function, decay: Any) -> Any:
    """int f over (0, pi) for an even f of period 2 pi, whose singularities are `decay` away from the real axis."""
    count = int(mp.mp.dps * mp.log(10) / decay / 2) + 3
    inner = mp.fsum(f(mp.pi * i / count) for i in range(1, count))
    return mp.pi / count * (inner + (f(mp.mpf(0)) + f(mp.pi)) / 2)


HALF = mp.mpf(1) / 2


def power_load(p0: Any, a: Any, exponent: Any) -> Callable[[Any], Any]:
    """p0 (1 - r**2/a**2)**exponent; Föppl took -1/2, 1/2 and 0."""
    return lambda r: p0 * ((1 - r / a) * (1 + r / a)) ** exponent


class PowerLoadChord:
    """Closed w1D of a power load: p0 a/E* B(s + 1, 1/2) (1 - xi**2/a**2)**(s + 1/2)."""

    def __init__(self, p0: Any, a: Any, exponent: Any, E_star: Any) -> None:
        self.a, self.power = a, exponent + HALF
        self.at_centre = p0 * a / E_star * mp.beta(exponent + 1, HALF)

    def __call__(self, xi: Any) -> Any:
        return self.at_centre * ((1 - xi / self.a) * (1 + xi / self.a)) ** self.power

    def slope(self, xi: Any) -> Any:
        """The derivative of w1D at xi, a pure number."""
        factor = -2 * self.power * xi / self.a**2
        return self.at_centre * factor * ((1 - xi / self.a) * (1 + xi / self.a)) ** (self.power - 1)


def a_load(draw: Draw, lo: float = -0.5) -> tuple[Any, Any, Any, Any]:
    """a, p0, E*, and an exponent above -1."""
    return draw.length(), draw.stress(), draw.stress(5, 50), draw.number(lo, 1.5)


Polar = Callable[[Any, Any], Any]
"""f(s, phi) with s the distance from the point A where the displacement is asked for."""


def rings(p: Function, r: Any, a: Any, E_star: Any) -> Any:
    """Displacement at r under p on a disc of radius a: 2/E* int p t dt / agm(r + t, abs(r - t))."""

    def ring(t: Any) -> Any:
        return p(t) * t / mp.agm(r + t, abs(r - t)) if t != r else mp.mpf(0)

    if r == 0:
        return 2 / E_star * singular(p, mp.mpf(0), a)
    parts = ((mp.mpf(0), r), (r, a)) if r < a else ((mp.mpf(0), a),)
    return 2 / E_star * mp.fsum(singular(ring, lo, hi) for lo, hi in parts)


def graded_rings(p: Function, r: Any, a: Any, H: Any, k: Any) -> Any:
    """The same at r > a on a half-space of exponent k; H = h_N E_0 / ((1 - nu**2) c_0**k)."""
    e = (1 + k) / 2

    def ring(t: Any) -> Any:
        return p(t) * t * mp.hyp2f1(e, e, 1, (t / r) ** 2)

    strongest = max(0.0, float(1 - k) / 2)
    return 2 * mp.cos(k * mp.pi / 2) / (H * r ** (1 + k)) * singular(ring, mp.mpf(0), a, strongest)


def graded_centre(p: Function, a: Any, H: Any, k: Any) -> Any:
    """The same at r = 0, where every ring of radius t contributes 2 pi t**-k."""
    strongest = max(float(k), float(1 - k) / 2)
    return 2 * mp.cos(k * mp.pi / 2) / H * singular(lambda t: p(t) * t**-k, mp.mpf(0), a, strongest)


def around(f: Polar, r: Any, a: Any, lower: Any = 0, upper: Any = 0) -> Any:
    """int int f ds dphi over the disc around a point A at r < a; f is even in phi and s turns from A outwards.

    `lower` and `upper` are the powers of f at A and at the edge of the disc.
    """

    def ray(phi: Any) -> Any:
        beta = r * mp.cos(phi)
        return weighted(lambda s: f(s, phi), mp.mpf(0), mp.sqrt(a**2 - r**2 + beta**2) - beta, lower, upper)

    return 2 * half_turn(ray, mp.acosh(a / r))


def across(f: Polar, r: Any, a: Any, edge: Any) -> Any:
    """The same for A at r > a with phi measured from the direction of the centre; `edge` is the power of f at the edge.

    With sin(phi) = z a/r the outer integrand is (1 - z**2)**(edge + 1/2) times an even analytic function.
    """

    def chord(z: Any) -> Any:
        sine = z * a / r
        phi, middle, half = mp.asin(sine), r * mp.sqrt(1 - sine**2), a * mp.sqrt(1 - z**2)
        inner = weighted(lambda s: f(s, phi), middle - half, middle + half, edge, edge)
        return inner * (a / r) / mp.sqrt(1 - sine**2)

    return weighted(chord, mp.mpf(-1), mp.mpf(1), edge + mp.mpf(1) / 2, edge + mp.mpf(1) / 2)


def kappa(n: Any, k: Any = 0) -> Any:
    """g(1) of the profile r**n: n/2 B(n/2, (1 + k)/2)."""
    return n / 2 * mp.beta(n / 2, (1 + mp.mpf(k)) / 2)


def pressure(g: PowerSum, r: Any, a: Any, E_star: Any, k: Any = 0) -> Any:
    """Closed pressure of the depth g = sum c a**n; with k, E_star stands for H of `graded_rings`."""
    # the argument 1 - r^2/a^2 of 2F1 must not round to 1, where 2F1 is infinite for n < 1 - k
    with mp.workdps(mp.mp.dps + 2 * max(0, int(mp.log10(a / r)))):
        square = (a - r) * (a + r)
        head = E_star / mp.pi * square ** ((1 + mp.mpf(k)) / 2) / (1 + k)
        shape = (3 + mp.mpf(k)) / 2
        terms = (c * n * a ** (n - 2) * mp.hyp2f1(1, 1 - n / 2, shape, square / a**2) for c, n in g.terms)
        total = head * mp.fsum(terms)
    return +total


def even_pressure(g: PowerSum, r: Any, a: Any, E_star: Any, k: Any = 0) -> Any:
    """The same for even powers, where the series ends."""
    square, e = (a - r) * (a + r), (1 + mp.mpf(k)) / 2
    total = mp.mpf(0)
    for c, n in g.terms:
        m = int(n) // 2 - 1
        binomial = (mp.binomial(m, i) * r ** (2 * (m - i)) * square ** (i + e) / (i + e) for i in range(m + 1))
        total += c * n / 2 * mp.fsum(binomial)
    return E_star / mp.pi * total


def total_force(p: Function, a: Any, edge: float = 0.5) -> Any:
    """2 pi int p r dr over the disc."""
    return 2 * mp.pi * singular(lambda r: p(r) * r, mp.mpf(0), a, edge)


def area_force(g: PowerSum, a: Any, E_star: Any, k: Any = 0) -> Any:
    """The closed pressure of the depth g, integrated over the area."""
    return total_force(lambda r: pressure(g, r, a, E_star, k), a)


def derivative(f: Function, x: Any, reach: Any, order: int = 1) -> Any:
    """f'(x), or f''(x), by Cauchy's integral over a circle of radius `reach`, inside which f is analytic."""
    count = int(mp.mp.dps * 3.4)
    turns = [mp.expjpi(mp.mpf(2 * i) / count) for i in range(count)]
    return order * mp.fsum(f(x + reach * t) / t**order for t in turns) / (count * reach**order)
