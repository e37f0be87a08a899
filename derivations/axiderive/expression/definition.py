"""The quantities straight from their definitions, by mpmath: what formulas and generated rules are measured against."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping
from typing import Any

import mpmath as mp
import sympy as sp
from flint import acb, arb, ctx

from ..notation import r
from ..profiles.profile import Profile
from ..proof.shape import number

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
        value = (acb.elliptic_rf(gap / rest, gap / rest + gap / (m * m), gap / rest + 1) / m).real
        mantissa, exponent = value.mid().man_exp()
    return mp.ldexp(mp.mpf(int(mantissa)), int(exponent))


class Definition:
    """(11.29), (11.20), (11.23), (11.26) with the order of iterated integrals exchanged, E_star = 1."""

    def __init__(self, profile: Profile, values: Mapping[sp.Symbol, sp.Expr], digits: int = 20) -> None:
        self.digits, self.exact = digits, dict(values)
        with self._precision():
            self.breaks = [number(b.xreplace(self.exact)) for b in profile.breaks]
            slopes = [sp.diff(piece.expr, r) for piece in profile.pieces]
            self.slopes = [self._function(slope) for slope in slopes]
            self.entire = [slope.is_polynomial(r) for slope in slopes]
            self.bends = [self._function(slope + r * sp.diff(slope, r)) for slope in slopes]

    def _precision(self) -> Any:
        return mp.workdps(self.digits + GUARD)

    def _function(self, expr: sp.Expr) -> Function:
        function: Function = sp.lambdify(r, expr.xreplace(self.exact), "mpmath")
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
            ends, method = (
                ([start, stop], "gauss-legendre") if self.entire[i] else (mp.linspace(start, stop, 4), "tanh-sinh")
            )
            total += mp.quad(
                lambda u, f=slope: f(a * mp.sin(u)) * weight(a * mp.sin(u), a * mp.cos(u)), ends, method=method
            )
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
                total += mp.quad(lambda s, f=self.bends[i]: f(s) * kernel(s, at, a), [start, (start + stop) / 2, stop])
        for i, b in enumerate(self.breaks):
            if b < a:
                total += b * (self.slopes[i + 1](b) - self.slopes[i](b)) * kernel(b, at, a)
        return total / mp.pi

    def _displacement(self, a: Number, at: Number) -> Number:
        q = mp.sqrt((at - a) * (at + a))
        inclination = mp.asin(a / at)
        return 2 / mp.pi * self._over_angle(a, lambda s, z: a * inclination - z * mp.atan(z / q))
