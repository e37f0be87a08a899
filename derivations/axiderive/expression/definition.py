"""The quantities of an expression straight from their definitions.

By mpmath, which formulas and generated rules are measured against, and in floating point at given parameter values:
g, g' and F by a trapezoidal rule over the profile.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping
from typing import Any

import mpmath as mp
import numpy as np
import sympy as sp
from flint import acb, arb, ctx
from sympy.printing.numpy import NumPyPrinter

from ..notation import r
from ..oracle.rules import middle
from ..oracle.shape import number
from ..physics.general import Layer, beyond, excess, layers, steepness
from ..profiles.profile import Profile

GUARD = 15
Number = Any
Function = Callable[[Number], Number]


def _ball(x: Number) -> Any:
    sign, mantissa, exponent, _ = x._mpf_
    return arb((-int(mantissa) if sign else int(mantissa), int(exponent)))


def kernel(s: Number, r: Number, a: Number) -> Number:
    """int dt/sqrt((t**2 - s**2) (t**2 - r**2)) from max(s, r) to a, by Carlson's R_F as Arb has it."""
    large, small = max(s, r), min(s, r)
    with ctx.workprec(mp.mp.prec):
        m, low, end = _ball(large), _ball(small), _ball(a)
        gap, rest = (m - low) * (m + low), (end - m) * (end + m)
        return middle((acb.elliptic_rf(gap / rest, gap / rest + gap / (m * m), gap / rest + 1) / m).real)


def _flattening(function: Function) -> int:
    """The m with which x = v**m takes away the singularity of a function that falls as a power of x."""
    tiny = mp.mpf(10) ** -30
    exponent = mp.log(abs(function(2 * tiny) / function(tiny)), 2) if function(tiny) else mp.mpf(0)
    return int(mp.ceil(1 / (1 + exponent) - mp.mpf("1e-9"))) if -1 < exponent < 0 else 1


def _over(f: Function, length: Number, power: int, ends: list[Any], method: str = "tanh-sinh") -> Number:
    """Integral from 0 to length, with a power of the variable, by a sum whose error is a relative one."""
    size = max(abs(f(length * x)) for x in (mp.mpf("0.3"), mp.mpf("0.6"), mp.mpf("0.9"))) or mp.mpf(1)

    def scaled(v: Number) -> Number:
        return f(length * v**power) / size * power * v ** (power - 1)

    return length * size * mp.quad(scaled, ends, method=method)


class Definition:
    """(11.29), (11.20), (11.23), (11.26) with the order of iterated integrals exchanged, E_star = 1."""

    def __init__(self, profile: Profile, values: Mapping[sp.Symbol, sp.Expr], digits: int = 20) -> None:
        self.digits, self.exact = digits, dict(values)
        with self._precision():
            self.breaks = [number(b.xreplace(self.exact)) for b in profile.breaks]
            slopes = [sp.diff(piece.expr, r) for piece in profile.pieces]
            bends = [slope + r * sp.diff(slope, r) for slope in slopes]
            starts = (sp.S.Zero, *profile.breaks)
            self.slopes = [self._function(slope, b) for slope, b in zip(slopes, starts, strict=True)]
            self.entire = [slope.is_polynomial(r) for slope in slopes]
            self.bends = [self._function(bend, b) for bend, b in zip(bends, starts, strict=True)]

    def _precision(self) -> Any:
        return mp.workdps(self.digits + GUARD)

    def _function(self, expr: sp.Expr, start: sp.Expr) -> Function:
        """As a function of r - start, which is positive."""
        function: Function = sp.lambdify(excess, beyond(expr, start).xreplace(self.exact), "mpmath")
        return function

    def _pieces(self, a: Number) -> list[tuple[int, Number, Number]]:
        ends = [mp.mpf(0), *self.breaks, mp.inf]
        found = [(i, low, min(high, a)) for i, (low, high) in enumerate(itertools.pairwise(ends))]
        return [(i, low, high) for i, low, high in found if low < high]

    def _over_angle(self, a: Number, weight: Callable[[Number, Number], Number]) -> Number:
        total = mp.mpf(0)
        for i, low, high in self._pieces(a):
            slope = self.slopes[i]
            start, stop = (mp.asin(x / a) for x in (low, high))
            # without a singularity anywhere Gauss needs a fifth of the nodes of tanh-sinh
            method = "gauss-legendre" if self.entire[i] else "tanh-sinh"
            ends, power = ([0, 1], 1) if self.entire[i] else (mp.linspace(0, 1, 4), _flattening(slope))

            def over(u: Number, slope: Function = slope, start: Number = start) -> Number:
                past = 2 * a * mp.cos(start + u / 2) * mp.sin(u / 2)
                return slope(past) * weight(a * mp.sin(start + u), a * mp.cos(start + u))

            total += _over(over, stop - start, power, ends, method)
        return total

    def quantity(self, suffix: str, a: float, at: float | None = None) -> Number:
        """d, F, p or w at a contact radius and, for the fields, at a radius."""
        with self._precision():
            radius, place = mp.mpf(a), None if at is None else mp.mpf(at)
            quantities: dict[str, Callable[[], Number]] = {
                "d": lambda: radius * self._over_angle(radius, lambda s, z: 1),
                "F": lambda: 2 * self._over_angle(radius, lambda s, z: s * s),
                "p": lambda: self._pressure(radius, place),
                "w": lambda: self._displacement(radius, place),
            }
            return quantities[suffix]()

    def _pressure(self, a: Number, at: Number) -> Number:
        total = mp.mpf(0)
        for i, low, high in self._pieces(a):
            ends = [low, at, high] if low < at < high else [low, high]
            for start, stop in itertools.pairwise(ends):

                def over(x: Number, bend: Function = self.bends[i], low: Number = low, start: Number = start) -> Number:
                    return bend(start - low + x) * kernel(start + x, at, a)

                power = 1 if start > low or self.entire[i] else _flattening(self.bends[i])
                total += _over(over, stop - start, power, [0, 0.5, 1])
        below = mp.mpf(0)
        for i, b in enumerate(self.breaks):
            if b < a:
                total += b * (self.slopes[i + 1](mp.mpf(0)) - self.slopes[i](b - below)) * kernel(b, at, a)
            below = b
        return total / mp.pi

    def _displacement(self, a: Number, at: Number) -> Number:
        q = mp.sqrt((at - a) * (at + a))
        inclination = mp.asin(a / at)
        return 2 / mp.pi * self._over_angle(a, lambda s, z: a * inclination - z * mp.atan(z / q))


Array = Any
PRINTED = {"fully_qualified_modules": False, "inline": True, "allow_unknown_functions": True}
STEP = 0.125
PLACES = np.arange(-14.0, 14.0, STEP)[:, None]
RISE = np.exp(PLACES + PLACES**3 / 75.0)
NEAR, SPEED = np.hypot(1.0, RISE), STEP * (1.0 + PLACES**2 / 25.0)
"""Distances from both ends as powers of a radius: signs are asked for, whatever the lengths of the profile are."""


class Numeric:
    """f, f', g, g' and F/E_star; the arguments are arrays of radii."""

    def __init__(self, profile: Profile, values: Mapping[sp.Symbol, float]) -> None:
        self.values = dict(values)
        self.breaks = [float(b.xreplace(self.values)) for b in profile.breaks]
        self.pieces = [self._function(piece.expr) for piece in profile.pieces]
        self.slopes = [self._function(steepness(piece.expr)) for piece in profile.pieces]
        self.layers = [self._layer(layer) for layer in layers(profile)]

    def _function(self, expr: sp.Expr, variable: sp.Symbol = r) -> Callable[[Array], Array]:
        # with "numpy" for the modules lambdify would import all of it, f2py and its tests included
        numeric = sp.lambdify(variable, expr.xreplace(self.values), [{}], printer=NumPyPrinter(PRINTED))
        return lambda x: numeric(x) + np.zeros_like(x)

    def _layer(self, layer: Layer) -> tuple[float, Callable[[Array], Array], float]:
        start, kink = (float(sp.sympify(x).xreplace(self.values)) for x in (layer.start, layer.kink))
        return start, self._function(beyond(layer.bend, layer.start), excess), kink

    def _piecewise(self, functions: list[Callable[[Array], Array]], x: Array) -> Array:
        x = np.asarray(x, dtype=float)
        with np.errstate(all="ignore"):
            out = functions[0](x)
            for b, function in zip(self.breaks, functions[1:], strict=True):
                out = np.where(x > b, function(x), out)
        return out

    def height(self, x: Array) -> Array:
        """f at these radii."""
        return self._piecewise(self.pieces, x)

    def slope(self, x: Array) -> Array:
        """f' at these radii; at a break that of the piece below it."""
        return self._piecewise(self.slopes, x)

    def kinks(self) -> list[tuple[float, float]]:
        """Radius and jump of the slope f' for every layer that begins off the axis."""
        return [(start, kink) for start, _, kink in self.layers if start > 0.0]

    @staticmethod
    def _over_angle(function: Callable[[Array], Array], a: Array, low: float, high: float = np.inf) -> Array:
        """int function(s - low) du with s = a sin(u), for low < s < high."""
        end = np.minimum(high, a)
        width, rest = (np.sqrt(np.maximum(x - y, 0.0) * (x + y)) for x, y in ((end, low), (a, end)))
        with np.errstate(all="ignore"):
            p, q = width * (RISE / NEAR), width / NEAR
            s, z = np.hypot(low, p), np.hypot(rest, q)
            total = (function(p * (p / (s + low))) * (p / s) * (q / z) * (RISE / NEAR**2) * SPEED).sum(axis=0)
        return np.where(width > 0.0, total, 0.0)

    def _whole(self, a: Array, power: int) -> Array:
        """int f'(s) (s/a)**power du, piece by piece."""
        a, ends = np.asarray(a, dtype=float), [0.0, *self.breaks, np.inf]
        total = np.zeros_like(a)
        for low, high, slope in zip(ends, ends[1:], self.slopes, strict=False):

            def weighted(x: Array, slope: Callable[[Array], Array] = slope, low: float = low) -> Array:
                return slope(low + x) * ((low + x) / a) ** power

            total = total + self._over_angle(weighted, a, low, high)
        return total

    def depth(self, a: Array) -> Array:
        """g at these contact radii, by quadrature of f'."""
        return a * self._whole(a, 0)

    def force(self, a: Array) -> Array:
        """F/E_star at these contact radii, by quadrature of f'."""
        return 2.0 * a**2 * self._whole(a, 2)

    def rate(self, a: Array) -> Array:
        """g'(a)."""
        a = np.asarray(a, dtype=float)
        total = np.zeros_like(a)
        for start, bend, kink in self.layers:
            part = self._over_angle(bend, a, start)
            with np.errstate(all="ignore"):
                part = part + start * kink / np.sqrt((a - start) * (a + start)) if start and kink else part
            total = total + np.where(a > start, part, 0.0)
        return total

    def exponents(self, compact_to: float | None) -> tuple[float, float]:
        """Safe lower bounds of the logarithmic slopes of depth and force, half of the least that occurs."""
        t = 10.0 ** np.linspace(-2.0, 3.0, 121)
        truncated = self.layers[0][0]
        scale = self.breaks[0] if self.breaks else 1.0
        a = truncated * np.sqrt(1.0 + t * t) if truncated else scale * t
        a = a[a < (np.inf if compact_to is None else compact_to)]
        step = (a - truncated) * (a + truncated) / a if truncated else a
        with np.errstate(all="ignore"):
            rate = self.rate(a)
            slopes = step * rate / self.depth(a), 2.0 * a * step * rate / self.force(a)
        least = [s[np.isfinite(s) & (s > 0.0)].min(initial=2.0) for s in slopes]
        return float(f"{max(least[0] / 2.0, 0.05):.1g}"), float(f"{max(least[1] / 2.0, 0.05):.1g}")
