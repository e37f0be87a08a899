"""A profile in floating point at given parameter values: g, g' and F by a trapezoidal rule over the profile."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import sympy as sp
from sympy.printing.numpy import NumPyPrinter

from ..contact.general import Layer, beyond, excess, layers, steepness
from ..notation import r
from ..profiles.profile import Profile

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
        return self._piecewise(self.pieces, x)

    def slope(self, x: Array) -> Array:
        return self._piecewise(self.slopes, x)

    def kinks(self) -> list[tuple[float, float]]:
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
        return a * self._whole(a, 0)

    def force(self, a: Array) -> Array:
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
