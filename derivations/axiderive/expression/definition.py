"""The quantities of an expression straight from their definitions.

By mpmath, which formulas and generated rules are measured against, and in floating point at given parameter values:
g, g' and F by a trapezoidal rule over the profile.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

import mpmath as mp
import numpy as np
import sympy as sp
from sympy.printing.numpy import NumPyPrinter

from ..notation import LENGTH, E_star, describe, known, r
from ..oracle.half_space import HalfSpace
from ..oracle.integrals import Homogeneous, kernel
from ..oracle.shape import Number, Shape, Stretch, number
from ..physics.general import Layer, beyond, excess, layers, steepness
from ..profiles.profile import Profile

GUARD = 25
"""Digits beyond those asked for: a root of the distance to a break has half of those of the radius."""
Function = Callable[[Number], Number]


def _flattening(function: Function) -> int:
    """The m with which x = v**m takes away the singularity of a function that falls as a power of x."""
    tiny = mp.mpf(10) ** -30
    near, far = function(tiny), function(2 * tiny)
    exponent = mp.log(abs(far / near), 2) if near and far else mp.mpf(0)
    return int(mp.ceil(1 / (1 + exponent) - mp.mpf("1e-9"))) if -1 < exponent < 0 else 1


def _over(f: Function, length: Number, power: int, ends: list[Any], method: str = "tanh-sinh") -> Number:
    """Integral from 0 to length, with a power of the variable, by a sum whose error is a relative one."""
    size = max(abs(f(length * x)) for x in (mp.mpf("0.3"), mp.mpf("0.6"), mp.mpf("0.9"))) or mp.mpf(1)

    def scaled(v: Number) -> Number:
        return f(length * v**power) / size * power * v ** (power - 1)

    return length * size * mp.quad(scaled, ends, method=method)


@dataclass(frozen=True)
class Definition(Homogeneous):
    """The integrals of a profile that may be singular at its tip and at every break, by a rule that can be so there."""

    depths: dict[Number, Number] = field(default_factory=dict)

    def depth(self, a: Number) -> Number:
        """g(a), which is asked for again and again."""
        if a not in self.depths:
            self.depths[a] = super().depth(a)
        return self.depths[a]

    def _over_angle(
        self, a: Number, weighted: Callable[[Stretch, Number, Number], Number], extra: tuple[complex, ...]
    ) -> Number:
        total = mp.mpf(0)
        with mp.workdps(self.digits + GUARD):
            for piece in self.shape.stretches:
                start, stop = (mp.asin(min(x / a, 1)) for x in (piece.lo, piece.hi))

                def over(u: Number, piece: Stretch = piece, start: Number = start) -> Number:
                    return weighted(piece, a * mp.sin(start + u), a * mp.cos(start + u))

                if stop > start and piece.singular:
                    total += _over(over, stop - start, _flattening(over), mp.linspace(0, 1, 4))
                elif stop > start:
                    # without a singularity anywhere Gauss needs a fifth of the nodes of tanh-sinh
                    total += _over(over, stop - start, 1, [0, 1], "gauss-legendre")
        return total

    def _pressure_piece(self, piece: Stretch, a: Number, r: Number) -> Number:
        total, low, high = mp.mpf(0), piece.lo, min(piece.hi, a)
        with mp.workdps(self.digits + GUARD):
            for start, stop in itertools.pairwise(
                [low, r, high] if low < r < high else [low, high][: 2 * (low < high)]
            ):

                def over(x: Number, start: Number = start) -> Number:
                    s = start + x
                    # rounding reaches the ends themselves, which weigh nothing
                    return piece.bend(s) * kernel(s, r, a) if r != s < a else mp.mpf(0)

                power = _flattening(over) if piece.singular and start == low else 1
                total += _over(over, stop - start, power, [0, 0.5, 1])
        return total


def definition(profile: Profile, values: Mapping[sp.Symbol, sp.Expr], digits: int = 20) -> Definition:
    """The integrals of a profile, at these values of its parameters."""

    def function(expr: sp.Expr, start: sp.Expr) -> Function:
        """Of r, by what it is in r - start, which is positive."""
        own = sp.lambdify(excess, beyond(expr, start).xreplace(dict(values)), "mpmath")
        low = number(start.xreplace(dict(values)))
        return lambda s: own(max(s - low, s * mp.eps))

    with mp.workdps(digits + GUARD):
        starts = (sp.S.Zero, *profile.breaks)
        ends = [*(number(b.xreplace(dict(values))) for b in starts), mp.inf]
        stretches = []
        for piece, start, low, high in zip(profile.pieces, starts, ends, ends[1:], strict=False):
            slope = sp.diff(piece.expr, r)
            height, inclination, bend = (function(e, start) for e in (piece.expr, slope, slope + r * sp.diff(slope, r)))
            singular = () if slope.is_polynomial(r) else (complex(low),)
            stretches.append(Stretch(low, high, height, inclination, bend, singular, bend, np.inf))
        pairs = itertools.pairwise(stretches)
        kinks = tuple((own.lo, own.slope(own.lo) - below.slope(own.lo)) for below, own in pairs)
    return Definition(Shape(tuple(stretches), kinks), mp.mpf(0), digits)


@dataclass(frozen=True)
class Defined(HalfSpace):
    """The homogeneous half-space under any profile that grows, also outside the normal form."""

    integrals: Definition

    def face(self, a: Number, digits: int | None = None) -> Definition:
        """The integrals of the profile, whatever the radius."""
        return self.integrals


def quantity(own: Definition, profile: Profile, suffix: str, a: sp.Expr, at: sp.Expr | None = None) -> Number:
    """d, F, p or w at a contact radius and, for the fields, at a radius, for E* = 1."""
    with mp.workdps(own.digits + GUARD):
        values = {E_star: mp.mpf(1), r: number(at or 0)}
        return Defined(profile, values, own.digits, False, own).normal(suffix, number(a))


def lengths(parameters: Iterable[sp.Symbol]) -> list[sp.Symbol]:
    """Those that are lengths."""
    return [p for p in parameters if known(p.name) and describe(p).dimension == LENGTH]


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
