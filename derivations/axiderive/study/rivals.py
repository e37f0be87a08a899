"""Other ways to the same numbers, each written from its definition, on every half-space.

Pressure (11.23), (11.53) from g'(t); displacement (11.26), (11.56) as that of flat punches of the depth g'(t) dt; depth
and force (11.29), (11.20), (11.51) as moments of f'(s); the radius under adhesion by the retraction (11.63).  With the
edge term of (11.107) where the depth is free.  A rule of Gauss and Jacobi takes a singularity into its weight; a script
gives the integrals to adaptive quadrature from break to break, in double precision or in many digits.

On a grid, after their descriptions and not their authors' programs: by parts with central differences and trapezoids
(Benad 2018), convolution over r**2 by FFT (Willert 2021); the boundary element method where tamaas is installed.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, partial
from importlib import import_module
from importlib.util import find_spec
from typing import Any, ClassVar

import mpmath as mp
import numpy as np
from scipy import integrate, optimize, special

from .. import notation as nt
from .subject import RADIUS, Array, Subject

a = RADIUS
WIDTH = 3.0
"""Side of the square of boundary elements in contact radii."""
TOLERANCE, ITERATIONS = 1e-9, 2000
"""Where their solver stops."""


@cache
def jacobi(count: int, lower: float, upper: float) -> tuple[Array, Array]:
    """Nodes on (0, 1) and weights for x**lower (1 - x)**upper."""
    nodes, weights = special.roots_jacobi(count, upper, lower)
    return (1 + nodes) / 2, weights / 2 ** (1 + upper + lower)


def punch_pressure(subject: Subject, r: Array) -> Array:
    """The edge term of (11.107), (11.47), of a depth beyond that of the profile."""
    return subject.excess * subject.modulus / np.pi * ((a - r) * (a + r)) ** subject.power if subject.excess else 0.0


def beside_punch(k: float, share: Array) -> Array:
    """Displacement over the depth of a flat punch whose radius has this share of that of the place."""
    return special.betainc((1 + k) / 2, (1 - k) / 2, share**2) if k else 2 / np.pi * np.arcsin(share)


def jacobi_pressure(subject: Subject, r: Array, count: int) -> Array:
    """In t**2, whose distance from the lower limit carries the power (k - 1)/2; a break is such a limit."""
    total, power = 0.0, subject.power
    for start, end in subject.spans():
        low = np.clip(r, start, end)
        width = (end - low) * (end + low)
        for node, weight in zip(*jacobi(count, power, 0.0), strict=True):
            past = width * node
            t = np.sqrt(low * low + past)
            kernel = (past / (past + (low - r) * (low + r))) ** -power
            total = total + width ** (1 + power) * weight * subject.rate(t) / (2 * t) * kernel
    return subject.modulus / np.pi * total + punch_pressure(subject, r)


def jacobi_displacement(subject: Subject, r: Array, count: int) -> Array:
    """In t - b, with the power that g' may have at a break, else with that of the displacement of small punches."""
    total, k = subject.excess * beside_punch(subject.exponent, a / r), subject.exponent
    for low, high in subject.spans():
        power = subject.power if low else k
        for node, weight in zip(*jacobi(count, power, 0.0), strict=True):
            t = low + (high - low) * node
            rate = (high - low) * weight * node**-power * float(subject.rate(t))
            total = total + rate * beside_punch(k, t / r)
    return total


def jacobi_force(subject: Subject, d: Array, count: int) -> Array:
    """Depth and force over the profile with the power (k - 1)/2 at r = a; the radius by brentq."""

    def moment(x: float, power: int) -> float:
        total = 0.0
        for low, high in subject.spans(x):
            singular = subject.power if high == x else 0.0
            nodes, weights = jacobi(count, 0.0, singular)
            s = low + (high - low) * nodes
            scale = (high - low) ** (1 + singular) * (x - s if high < x else 1.0) ** (subject.power - singular)
            total += float(np.sum(scale * weights * subject.slope(s) * s**power * (x + s) ** subject.power))
        return total

    return np.array([_force(subject, moment, root(subject, _gap(subject, moment, x))) for x in map(float, d)])


Moment = Callable[[Any, int], Any]
"""int f'(s) s**power (x**2 - s**2)**((k - 1)/2) ds of a radius x."""


def _gap(subject: Subject, moment: Moment, depth: Any) -> Callable[[Any], Any]:
    """How far the depth of a contact is above the given one."""
    return lambda x: x ** (1 - subject.exponent) * moment(x, 0) - depth


def _force(subject: Subject, moment: Moment, x: Any) -> Any:
    """The force on a contact of the radius x."""
    return 2 * subject.modulus / (1 + subject.exponent) * moment(x, 2)


def root(subject: Subject, gap: Callable[[float], float]) -> float:
    """The radius between the edge and the largest one, by brentq."""
    low = subject.edge * (1 + 1e-14) if subject.edge else 1e-9 * a
    return float(optimize.brentq(gap, low, subject.largest * (1 - 1e-9), xtol=1e-300, rtol=1e-14))


def radius(subject: Subject, depth: float) -> float:
    """The radius of the contact of that depth, by its formula."""
    return root(subject, lambda x: float(subject.depth(np.float64(x))) - depth)


def table_radius(subject: Subject, d: Array, count: int) -> Array:
    """A table of d(a) on a uniform grid from a/2 on, read by linear interpolation."""
    x = np.linspace(a / 2, a, count + 1)
    return np.interp(d, subject.depth(x), x)


@dataclass(frozen=True)
class Script:
    """Quantities by adaptive quadrature, point by point in the functions of `math`, by scipy's quad and brentq."""

    subject: Subject
    substituted: bool = False
    """Whether the integral of the pressure is taken in t = r cosh(v)."""
    functions: ClassVar[Any] = math
    number: ClassVar[Any] = float
    kind: ClassVar[str] = "math"

    def pressure(self, r: Array) -> Array:
        """p at the radii r < a."""
        return self.over(r, self._pressure)

    def displacement(self, r: Array) -> Array:
        """w at the radii r > a."""
        return self.over(r, self._displacement)

    def force(self, d: Array) -> Array:
        """F at the depths d."""
        return self.over(d, lambda d: _force(self.subject, self._moment, self.root(self._gap(d), d)))

    def radius(self, d: Array) -> Array:
        """The radius with adhesion at the depths d."""
        work, lib = self.subject.values[nt.dgamma] / self.subject.modulus, self.functions

        def one(d: Any) -> Any:
            gap = self._gap(d)
            return self.root(lambda x: gap(x) - lib.sqrt(2 * lib.pi * work * x), d)

        return self.over(d, one)

    def over(self, x: Array, one: Callable[[Any], Any]) -> Any:
        """A quantity at every point."""
        return np.array([one(float(value)) for value in x])

    def quad(self, integrand: Callable[[Any], Any], low: Any, high: Any) -> Any:
        """An integral between two numbers."""
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # its error estimate; what the error is, the study measures
            value, _ = integrate.quad(integrand, low, high, epsabs=0.0, epsrel=1e-13, limit=200)
        return float(value)

    def root(self, gap: Callable[[Any], Any], depth: Any) -> Any:
        """The radius at which a gap vanishes, where the depth is the given one."""
        return root(self.subject, gap)

    def excess(self) -> Any:
        """The depth beyond that of the profile."""
        return self.subject.excess

    def rate(self, t: Any) -> Any:
        """g'(t)."""
        return getattr(self.subject.rate, self.kind)(t)

    def slope(self, s: Any) -> Any:
        """f'(s)."""
        return getattr(self.subject.slope, self.kind)(s)

    def beside_punch(self, share: Any) -> Any:
        """What `beside_punch` says."""
        return beside_punch(self.subject.exponent, share)

    def _gap(self, depth: Any) -> Callable[[Any], Any]:
        return _gap(self.subject, self._moment, depth)

    def _pressure(self, r: Any) -> Any:
        """From break to break, as it stands in u = t - low, where no node falls below r."""
        lib, power, total = self.functions, self.number(self.subject.power), self.number(0)

        def over_angle(v: Any) -> Any:
            return self._risen(r * lib.cosh(v), low) * (r * lib.sinh(v)) ** (2 * power + 1)

        def over_rest(u: Any) -> Any:
            return self._risen(low + u, low) * ((u + (low - r)) * (u + low + r)) ** power

        for start, end in self._spans():
            low = max(r, start)
            if end > r and self.substituted:
                total += self.quad(over_angle, lib.acosh(low / r), lib.acosh(end / r))
            elif end > r:
                total += self.quad(over_rest, 0, end - low)
        if self.subject.profile.complete:
            total += self.excess() * ((a - r) * (a + r)) ** power
        return self.subject.modulus * total / lib.pi

    def _displacement(self, r: Any) -> Any:
        total = self.excess() * self.beside_punch(a / r) if self.subject.profile.complete else self.number(0)

        def flat(low: Any, t: Any) -> Any:
            return self._risen(t, low) * self.beside_punch(t / r)

        for low, high in self._spans():
            total += self.quad(partial(flat, low), low, high)
        return total

    def _moment(self, x: Any, power: int) -> Any:
        """Over the angle y with s = x cos(y)."""
        k, lib = self.number(self.subject.exponent), self.functions

        def integrand(y: Any) -> Any:
            s = x * abs(lib.cos(y))  # rounding takes the last nodes beyond pi/2
            return self.slope(s) * s**power * (x * lib.sin(y)) ** k

        return sum(self.quad(integrand, lib.acos(high / x), lib.acos(low / x)) for low, high in self._spans(x))

    def _spans(self, end: Any = a) -> list[tuple[Any, Any]]:
        return [(self.number(low), self.number(high)) for low, high in self.subject.spans(end)]

    def _risen(self, t: Any, low: Any) -> Any:
        """g'(t), which may be infinite at the break below: rounding takes the first nodes there."""
        return self.rate(t) if t > low else 0


@dataclass(frozen=True)
class Digits(Script):
    """The same in so many digits, by mpmath's quadrature and secants."""

    digits: int = mp.mp.dps
    functions: ClassVar[Any] = mp
    number: ClassVar[Any] = mp.mpf
    kind: ClassVar[str] = "mpmath"

    def over(self, x: Array, one: Callable[[Any], Any]) -> list[mp.mpf]:
        """A quantity at every point."""
        with mp.workdps(self.digits):
            return [one(mp.mpf(float(value))) for value in x]

    def quad(self, integrand: Callable[[Any], Any], low: Any, high: Any) -> Any:
        """An integral between two numbers."""
        return mp.quad(integrand, [low, high])

    def root(self, gap: Callable[[Any], Any], depth: Any) -> Any:
        """From the radius in double precision, as for any iteration with many digits."""
        start = mp.mpf(radius(self.subject, float(depth)))
        nearby = start * (1 + mp.mpf(10) ** (-min(self.digits, 15) // 2))
        return mp.findroot(lambda x: gap(x) / depth, (start, nearby), tol=mp.eps**1.5, verify=False)

    def excess(self) -> Any:
        """The depth beyond that of the profile."""
        return mp.mpf(self.subject.freed) - self.subject.depth.mpmath(mp.mpf(a))

    def beside_punch(self, share: Any) -> Any:
        """What `beside_punch` says."""
        k = mp.mpf(self.subject.exponent)
        return mp.betainc((1 + k) / 2, (1 - k) / 2, 0, share**2, regularized=True) if k else 2 * mp.asin(share) / mp.pi


def trapezoid_pressure(subject: Subject, count: int) -> tuple[Array, Array]:
    """By parts, central differences and trapezoids on a uniform grid: radii and pressures."""
    x = np.linspace(0.0, a, count + 1)
    first = np.gradient(subject.depth(x), x, edge_order=2)
    second = np.gradient(first, x, edge_order=2)
    r = x[1:-1]
    kernel = np.arccosh(np.maximum(x / r[:, None], 1.0))
    kernel[:, -1] /= 2
    smooth = subject.modulus / np.pi * (first[-1] * np.arccosh(a / r) - x[1] * (kernel @ second))
    return r, smooth + punch_pressure(subject, r)


def trapezoid_displacement(subject: Subject, r: Array, count: int) -> Array:
    """Trapezoids over w_1D/sqrt(r**2 - x**2) on the same grid."""
    x = np.linspace(0.0, a, count + 1)
    sunk = subject.excess + subject.depth(np.float64(a)) - subject.depth(x)
    return 2 / np.pi * integrate.trapezoid(sunk / np.sqrt((r[:, None] - x) * (r[:, None] + x)), x, axis=1)


def trapezoid_force(subject: Subject, d: Array, count: int) -> Array:
    """A table of g on the grid, the radius by interpolation, the force by trapezoids."""
    x = np.linspace(0.0, a, count + 1)
    depth = subject.depth(x)
    below = np.concatenate([[0.0], np.cumsum((depth[1:] + depth[:-1]) / 2) * x[1]])
    first = int(np.searchsorted(x, subject.edge))
    reached = np.interp(d, depth[first:], x[first:])
    return 2 * subject.modulus * (d * reached - np.interp(reached, x, below))


def fft_pressure(subject: Subject, count: int) -> tuple[Array, Array]:
    """Convolution over r**2 with exact weights in each cell: radii and pressures.

    The density g'/(2x) is linear in a cell, or constant where it is infinite at a break.
    """
    squares = np.linspace(0.0, a * a, count + 1)
    x = np.sqrt(squares)
    rise = np.diff(subject.depth(x)) / squares[1]
    if subject.edge and not np.isfinite(_silent(subject.rate.math, subject.edge)):
        total = _convolution_of_steps(rise[::-1], squares[1])[::-1]
    else:
        density = np.append(rise[0], subject.rate(x[1:]) / (2 * x[1:]))
        total = _convolution(density[::-1], squares[1], count + 1)[::-1]
    return x[1:-1], subject.modulus / np.pi * total[1:-1]


def fft_displacement(subject: Subject, count: int) -> tuple[Array, Array]:
    """The same for w = 2/pi (d asin(a/r) - int g/sqrt(r**2 - x**2) dx), a < r < 2a."""
    squares = np.linspace(0.0, 4 * a * a, 4 * count + 1)
    x = np.sqrt(squares)
    near = x[: count + 1].copy()
    near[0] = 1e-8 * a
    total = _convolution(subject.depth(near) / (2 * near), squares[1], len(squares))
    w = 2 / np.pi * (subject.depth(np.float64(a)) * np.arcsin(np.minimum(a / x[1:], 1.0)) - total[1:])
    return x[count + 1 :], w[count:]


def _convolution(density: Array, cell: float, size: int) -> Array:
    """int density(y) (x - y)**(-1/2) dy from 0 to x at x = 0, cell, ..., the density linear between its nodes."""
    lag = np.arange(size, dtype=np.float64)
    zeroth, first = np.diff(2 * np.sqrt(lag)), np.diff(2 / 3 * lag**1.5)
    far, near = first - lag[:-1] * zeroth, lag[1:] * zeroth - first
    total = np.zeros(size)
    total[1:] += _convolved(density[:-1], far)[: size - 1]
    inner = density.copy()
    inner[0] = 0.0
    total[: size - 1] += _convolved(inner, near)[: size - 1]
    return math.sqrt(cell) * total


def _convolution_of_steps(density: Array, cell: float) -> Array:
    """The same for a density that is constant in each cell."""
    weights = np.diff(2 * np.sqrt(np.arange(len(density) + 1, dtype=np.float64)))
    total = _convolved(density, weights)[: len(density)]
    return math.sqrt(cell) * np.append(0.0, total)


def _convolved(one: Array, other: Array) -> Array:
    from scipy import signal  # which brings scipy.stats along: half a second that no other method needs

    return np.asarray(signal.fftconvolve(one, other))


def _silent(function: Callable[[float], float], x: float) -> float:
    try:
        return function(x)
    except ZeroDivisionError:
        return math.inf


def no_boundary_elements() -> str:
    """Why there are none to run; empty if there are."""
    return "" if find_spec("tamaas") else "tamaas is not installed (pip install tamaas)"


def boundary_elements(subject: Subject, force: float, count: int) -> tuple[Array, Array]:
    """By tamaas, under a prescribed force: radii and pressures of the cells in contact."""
    tamaas = import_module("tamaas")
    tamaas.set_log_level(tamaas.LogLevel.error)
    side = WIDTH * RADIUS
    centres = (np.arange(count) - count // 2 + 0.5) * side / count
    r = np.hypot(*np.meshgrid(centres, centres, indexing="ij"))
    model = tamaas.Model(tamaas.model_type.basic_2d, [side, side], [count, count])
    model.E, model.nu = subject.modulus, 0.0
    tamaas.ModelFactory.registerNonPeriodic(model, "dcfft")
    # a sphere ends at its equator, the square beyond it is far from contact
    solver = tamaas.PolonskyKeerRey(model, -subject.height(np.minimum(r, subject.largest)), TOLERANCE)
    solver.setIntegralOperator("dcfft")
    solver.max_iter = ITERATIONS
    solver.solve(force / side**2)
    traction = np.array(model.traction).reshape(count, count)
    inside = r < RADIUS
    return r[inside], traction[inside]
