"""How a compact contact grows: exponents, rates and proved bounds for its iterations.

How depth and force of a compact contact grow, measured on the exact formulas for the starts of their inverses.

Proved bounds of the logarithmic slope of depth and force over the unknown of their inverse.

Let q(r) = r f''/f'.  All means have positive weights, as f' >= 0.

The radius itself: g(a) = a int_0^1 f'(a s)/sqrt(1 - s^2) ds and F = 2 E* a^2 int_0^1 s^2 f'(a s)/sqrt(1 - s^2) ds, so
a g'/g is a mean of 1 + q, and a F'/F one of 2 + q.

Beyond a flat face, r^2 = b^2 (1 + tau^2) and a^2 = b^2 (1 + t^2): with tau = t s both are integrals with the weight
s/sqrt(1 - s^2), g of t sqrt(1 + t^2) f'/sqrt(1 + tau^2) and F of t f' sqrt(1 + tau^2).  With T = 1 - b^2/r^2 at tau and
T <= T(a) <= 1 the slope of g is a mean of 1 + T(a) - T (1 - q), that of F one of 1 + T (1 + q).

Below the end R of a circle or an ellipse, a = R tanh t: there g is proportional to t tanh t, its slope is
1 + 2 t/sinh 2t.  That of F is larger, as F < 2 E* a g.  And F is the integral of tanh t (tanh t + t/cosh^2 t), which
over t^2 falls as tanh t/t and 1/cosh t do: its slope is at most 3.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import mpmath as mp
import sympy as sp

from ...entry import COMPACT
from ...notation import E_star, a, r
from ...oracle.evaluate import evaluated, of_one_variable
from ...profiles.profile import Profile
from .compact import Compact

Range = tuple[sp.Expr, sp.Expr]
SHARE = sp.Symbol("x", positive=True)
CIRCLE = {"ad": (1, 2), "aF": (1, 3)}


def proved(profile: Profile, suffix: str) -> tuple[int, int] | None:
    """Whole numbers between which the slope of d ("ad") or F ("aF") lies; None where this proves no such range."""
    if len(profile.pieces) != 1 + profile.truncated:
        return None
    power = log_slope(profile.pieces[-1].expr)
    if not profile.truncated and len(profile.chain) == 2 and profile.largest is None:
        end = profile.chain[-1]
        circle = sp.cancel(power - end**2 / (end**2 - r**2)) == 0
        return CIRCLE[suffix] if circle else None
    found = _beyond(profile, power, suffix) if profile.truncated else _whole(power, suffix)
    if found is None or found[0] <= 0:
        return None
    return math.floor(found[0]), math.ceil(found[1])


def log_slope(shape: sp.Expr) -> sp.Expr:
    """q(r) = r f''/f', factor by factor."""
    total = sp.S.Zero
    for base, exponent in sp.factor(sp.diff(shape, r)).as_powers_dict().items():
        total += exponent * r * sp.diff(base, r) / base + r * sp.diff(exponent, r) * sp.log(base)
    return sp.cancel(total)


def _whole(power: sp.Expr, suffix: str) -> Range | None:
    """Over all radii, r = L x/(1 - x) with the one length L of q."""
    lengths = power.free_symbols - {r}
    if len(lengths) > 1:
        return None
    reach = sp.Mul(*lengths) * SHARE / (1 - SHARE)
    found = _range(power.subs(r, reach))
    least = 1 if suffix == "ad" else 2
    return None if found is None else (least + found[0], least + found[1])


def _beyond(profile: Profile, power: sp.Expr, suffix: str) -> Range | None:
    """Over all radii from the flat face on, r = b/x."""
    grown, power = 1 - SHARE**2, power.subs(r, profile.breaks[0] / SHARE)
    if suffix == "aF":
        return _range(1 + grown * (1 + power))
    least, most = _range(1 + grown * power), _range(2 - grown * (1 - power))
    return None if least is None or most is None else (least[0], most[1])


def _range(expr: sp.Expr) -> Range | None:
    """Least and largest value over 0 <= x <= 1, if the expression is a rational function of x alone without a pole."""
    expr = sp.cancel(expr)
    if expr.free_symbols - {SHARE} or not expr.is_rational_function(SHARE):
        return None
    _, below = sp.fraction(expr)
    turning, _ = sp.fraction(sp.cancel(sp.diff(expr, SHARE)))
    pole, turn = (sp.Poly(part, SHARE) for part in (below, turning))
    # exact roots need whole coefficients
    if not (pole.domain.is_ZZ and turn.domain.is_ZZ) or (pole.degree() > 0 and pole.count_roots(0, 1)):
        return None
    places = [sp.S.Zero, sp.S.One]
    if turn.degree() > 0:
        places += [x for x, _ in turn.real_roots(multiple=False) if 0 < x < 1]
    values = [expr.subs(SHARE, x) for x in places]
    # a root in print may lie on either side of a whole number
    if any(not value.is_Rational and abs(value - round(value)) < 1e-9 for value in values):
        return None
    return min(values), max(values)


DIGITS = 60
DEGREE = 8
"""Coefficients of a start: its error is below 1e-3 then, and the iteration does the rest."""
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
        values = {symbol: sp.Rational(str(value)) for symbol, value in self.profile.sketch.values} | {E_star: sp.S.One}
        self.known = values | {symbol: expr.subs(values) for symbol, expr in self.profile.abbreviations}
        regimes = compact.regimes(COMPACT[suffix].inverts)
        self.curves = {key: of_one_variable(case.expr, a, self.known) for key, case in regimes.items()}

    @property
    def places(self) -> list[mp.mpf]:
        """Twelve decades of t; up to an end of the profile as far as the radius is told from it."""
        last = 6 if self.compact.scale("tip")[0] == "tanh" and self.compact.b is None else 24
        return [mp.mpf(10) ** (mp.mpf(k) / 4) for k in range(-24, last + 1)]

    def number(self, expr: sp.Expr) -> mp.mpf:
        """The expression at the parameters of the sketch, as an mpmath number."""
        return evaluated(expr, self.known)

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
        """The arguments of `between` as Python code; `rest` is the text of the correcting polynomial."""
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
