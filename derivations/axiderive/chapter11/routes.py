"""The independent routes: displacement of a loaded disc by rings or by chords, and known pressures of power laws.

The ring kernels are exact.  (11.2) integrated over the angle is an
arithmetic-geometric mean, (11.34) a hypergeometric function of (t/r)**2.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath as mp

from .draw import PowerSum
from .quadrature import half_turn, singular, weighted

Function = Callable[[Any], Any]
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


def derivative(f: Function, x: Any, reach: Any, nodes: int = 0) -> Any:
    """f'(x) by Cauchy's integral over a circle of radius `reach`, inside which f is analytic."""
    count = nodes or int(mp.mp.dps * 3.4)
    turns = [mp.expjpi(mp.mpf(2 * i) / count) for i in range(count)]
    return mp.fsum(f(x + reach * t) / t for t in turns) / (count * reach)
