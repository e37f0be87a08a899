"""The quantities straight from their definitions, by mpmath: what formulas and generated rules are measured against."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping
from typing import Any

import mpmath as mp
import sympy as sp
from flint import acb, arb, ctx

from ..contact.general import beyond, excess
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
