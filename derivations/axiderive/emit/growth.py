"""How depth and force of a compact contact grow, measured on the exact formulas for the starts of their inverses."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import mpmath as mp
import sympy as sp

from ..notation import a
from .compact import Compact
from .example import NUMERIC
from .slope_bounds import proved

DIGITS = 60
DEGREE = 8
"""Coefficients of a start: its error is below 1e-3 then, and the iteration does the rest."""
QUANTITY = {"ad": "d", "aF": "F"}
Power = tuple[float, float]
"""c and e of c t**e."""


class Growth:
    """ln d or ln F over the unknown t of its inverse, with the parameters of the sketch.

    t is the contact radius, sqrt(a**2/b**2 - 1) beyond a flat face of radius b, or artanh(a/R) below an end of the
    profile; where the curve ends with slope zero, it is the shortfall of the radius over the radius, and the value
    that of the value.
    """

    def __init__(self, compact: Compact, suffix: str) -> None:
        self.compact, self.profile = compact, compact.profile
        values = {symbol: sp.Float(str(value), DIGITS) for symbol, value in self.profile.sketch.values}
        values[sp.Symbol("E_star", positive=True)] = sp.Float(1, DIGITS)
        short = {symbol: sp.N(expr.subs(values), DIGITS) for symbol, expr in self.profile.abbreviations}
        self.known = values | short
        regimes = compact.regimes(QUANTITY[suffix])
        self.curves = {key: sp.lambdify(a, case.expr.subs(self.known), NUMERIC) for key, case in regimes.items()}

    @property
    def places(self) -> list[mp.mpf]:
        """Twelve decades of t; up to an end of the profile as far as the radius is told from it."""
        last = 6 if self.compact.scale("tip")[0] == "tanh" and self.compact.b is None else 24
        return [mp.mpf(10) ** (mp.mpf(k) / 4) for k in range(-24, last + 1)]

    def number(self, expr: sp.Expr) -> mp.mpf:
        return mp.mpf(str(sp.N(expr.subs(self.known), DIGITS)))

    def __call__(self, t: mp.mpf) -> mp.mpf:
        if self.profile.largest is not None:
            largest = self.number(self.profile.largest)
            return mp.log(self._value(largest) / self._value(largest / (1 + t)) - 1)
        kind, length = self.compact.scale("tip")
        if self.profile.truncated:
            return mp.log(self._value(self.number(self.compact.b) * mp.sqrt(1 + t * t)))
        if kind == "tanh" and self.compact.b is None:
            return mp.log(self._value(self.number(length) * mp.tanh(t)))
        return mp.log(self._value(t))

    def _value(self, radius: mp.mpf) -> mp.mpf:
        b = self.compact.b
        key = "tip" if b is None or ("tip" in self.curves and radius < self.number(b)) else "beyond"
        return self.curves[key](radius)

    def slope(self, t: mp.mpf) -> mp.mpf:
        """d ln value/d ln t by a central difference."""
        step = mp.mpf(10) ** -12
        return (self(t * (1 + step)) - self(t * (1 - step))) / (2 * step)


def exponents(compact: Compact, suffix: str) -> tuple[str, str]:
    """Whole numbers between which the slope lies.

    That is proved for sums of powers, whose slope is a mean of the powers with positive weights, and where
    `slope_bounds` says so.  For the others it is a guess, the range of the exact formulas at the places of `Growth`;
    what guarantees their brackets are the signs that `inverse` meets.
    """
    if compact.summed:
        return ("1.0", "len(A)") if suffix == "ad" else ("2.0", "len(A) + 1.0")
    known = proved(compact.profile, suffix)
    if known is not None:
        return f"{known[0]}.0", f"{known[1]}.0"
    with mp.workdps(DIGITS):
        growth = Growth(compact, suffix)
        slopes = [float(growth.slope(t)) for t in growth.places]
    low, high = min(slopes), max(slopes)
    return f"{math.floor(low + 1e-6)}.0", f"{math.ceil(high - 1e-6)}.0"


def tip_exponent(compact: Compact, suffix: str) -> str:
    """The power of the radius that the curve begins with."""
    with mp.workdps(DIGITS):
        growth = Growth(compact, suffix)
        return f"{_power(growth, growth.places[0])[1]}"


def powers(compact: Compact, suffix: str) -> str:
    """How the curve leaves its value at the break, as arguments of `inverse_across`; as powers of t.

    Where a tip that is a power of the radius lies below the curve it is what exceeds its continuation.
    """
    with mp.workdps(DIGITS):
        growth = Growth(compact, suffix)
        b, beyond, tip = growth.number(compact.b), growth.curves["beyond"], growth.curves["tip"]
        left = compact.scale("tip")[0] == "" and tip(2 * b) < beyond(2 * b)

        def more(t: mp.mpf) -> mp.mpf:
            radius = b * mp.sqrt(1 + t * t)
            return mp.log(beyond(radius) - (tip(radius) if left else beyond(b)))

        ends = (mp.mpf(10) ** -12, mp.mpf(10) ** 12)
        small, large = (round(float(2 * (more(t * 2) - more(t)) / mp.log(2))) / 2 for t in ends)
    return f"{'leaving' if left else 'powers'}=({small}, {large})"


@dataclass(frozen=True)
class Start:
    """What `between` asks for: the curve over its value at t = 1 for small and for large t, joined and corrected."""

    small: Power
    large: Power
    blend: float
    """The power of both that is summed."""
    rest: tuple[float, ...]
    """t over the q so found, a polynomial of q/(1 + q)."""
    scale: float
    """The curve at t = 1, with the parameters of the sketch."""

    def text(self, rest: str) -> str:
        return f"{self.small}, {self.large}, {self.blend}, {rest}"


def start(compact: Compact, suffix: str) -> Start:
    """An approximate inverse over all t; where one dimensionless number says all it is good for two to four digits."""
    with mp.workdps(DIGITS):
        growth = Growth(compact, suffix)
        places = growth.places
        first, last = (_power(growth, t) for t in (places[0], places[-1]))
        one = growth(mp.mpf(1))
        curve = [(float(mp.log(t)), float(growth(t) - one)) for t in places]
        blend = min((k / 4 for k in range(-24, 25) if k), key=lambda blend: _miss(curve, first, last, blend))
        reach = places[-1] / (1 + places[-1])
        nodes = [reach * (1 + mp.cos(mp.pi * (k + mp.mpf(0.5)) / DEGREE)) / 2 for k in range(DEGREE)]
        points = [(t, _joined(float(growth(t) - one), first, last, blend)) for t in (v / (1 - v) for v in nodes)]
        rest = _through([(1 - 1 / (1 + mp.exp(q)), t / mp.exp(q)) for t, q in points])
        return Start(first, last, blend, rest, float(mp.exp(one)))


def _through(points: Sequence[tuple[mp.mpf, mp.mpf]]) -> tuple[float, ...]:
    """Coefficients in ascending order of the polynomial through the points, to the digits that a start needs."""
    rows = mp.matrix([[v**j for j in range(len(points))] for v, _ in points])
    return tuple(float(f"{float(c):.7g}") for c in mp.lu_solve(rows, mp.matrix([value for _, value in points])))


def _power(growth: Growth, t: mp.mpf) -> Power:
    """Half an exponent is the least step there is; the factor is a start and needs four digits."""
    exponent = round(float(2 * growth.slope(t))) / 2
    factor = float(mp.exp(growth(t) - growth(mp.mpf(1)) - exponent * mp.log(t)))
    return float(f"{factor:.4g}"), exponent


def _joined(x: float, first: Power, last: Power, blend: float) -> float:
    """ln t by the two ends alone."""
    one, other = (blend / e * (x - math.log(c)) for c, e in (first, last))
    return (max(one, other) + math.log1p(math.exp(-abs(one - other)))) / blend


def _miss(curve: Sequence[tuple[float, float]], first: Power, last: Power, blend: float) -> float:
    """The largest error of ln t."""
    return max(abs(_joined(x, first, last, blend) - t) for t, x in curve)
