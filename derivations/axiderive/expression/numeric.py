"""A profile in floating point at given parameter values: g, g' and F by Gauss-Legendre rules over the profile."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import sympy as sp

from ..contact.general import Layer, layers, steepness
from ..notation import r
from ..profiles.profile import Profile

Array = Any
NODES, WEIGHTS = np.polynomial.legendre.leggauss(96)
"""Signs and starting values are asked for, not the last digits."""


class Numeric:
    """f, f', g, g' and F/E_star; the arguments are arrays of radii."""

    def __init__(self, profile: Profile, values: Mapping[sp.Symbol, float]) -> None:
        self.values = dict(values)
        self.breaks = [float(b.xreplace(self.values)) for b in profile.breaks]
        self.pieces = [self._function(piece.expr) for piece in profile.pieces]
        self.slopes = [self._function(steepness(piece.expr)) for piece in profile.pieces]
        self.layers = [self._layer(layer) for layer in layers(profile)]

    def _function(self, expr: sp.Expr) -> Callable[[Array], Array]:
        numeric = sp.lambdify(r, expr.xreplace(self.values), "numpy")
        return lambda x: numeric(x) + np.zeros_like(x)

    def _layer(self, layer: Layer) -> tuple[float, Callable[[Array], Array], float]:
        start, kink = (float(sp.sympify(x).xreplace(self.values)) for x in (layer.start, layer.kink))
        return start, self._function(layer.bend), kink

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

    def _over_angle(self, a: Array, power: int) -> Array:
        """int f'(a sin u) sin(u)**power du, piece by piece."""
        a = np.asarray(a, dtype=float)
        total, ends = np.zeros_like(a), [0.0, *self.breaks, np.inf]
        for low, high, slope in zip(ends, ends[1:], self.slopes, strict=False):
            start, stop = (np.arcsin(np.minimum(end / a, 1.0)) for end in (low, high))
            u = start + (stop - start) * (NODES[:, None] + 1.0) / 2.0
            with np.errstate(all="ignore"):
                values = slope(a * np.sin(u)) * np.sin(u) ** power
            part = (WEIGHTS[:, None] * values).sum(axis=0) * (stop - start) / 2.0
            total = total + np.where(stop > start, part, 0.0)
        return total

    def depth(self, a: Array) -> Array:
        return a * self._over_angle(a, 0)

    def force(self, a: Array) -> Array:
        return 2.0 * a**2 * self._over_angle(a, 2)

    def rate(self, a: Array) -> Array:
        """g'(a)."""
        a = np.asarray(a, dtype=float)
        total = np.zeros_like(a)
        for start, bend, kink in self.layers:
            reach = np.arccos(np.minimum(start / a, 1.0))
            x = reach * (NODES[:, None] + 1.0) / 2.0
            with np.errstate(all="ignore"):
                part = (WEIGHTS[:, None] * bend(a * np.cos(x))).sum(axis=0) * reach / 2.0
                part = part + start * kink / np.sqrt((a - start) * (a + start)) if start else part
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
