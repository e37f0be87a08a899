"""Points in double precision at which emitted functions are measured: a bench domain, and the ends of the range."""

from __future__ import annotations

import itertools
import math
import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..profiles.profile import Profile

Floats = dict[Any, Any]
"""Doubles by symbol; the coefficients of a polynomial as a tuple."""
TERMS, ATTEMPTS = 3, 400
SMALLEST, LARGEST = 2.3e-308, 1.7e308
MODULI = (nt.E_star, nt.F, nt.H, nt.G_star, nt.H_x)


@dataclass(frozen=True)
class Domain:
    """Decades: of lengths, of ratios towards 0 and towards 1, of exponents and of slopes."""

    name: str
    lengths: tuple[float, float]
    small: float
    close: float
    exponents: tuple[float, float]
    slopes: float


BENCH = Domain("bench", (-9, 1), -6, -6, (-1, 1), -2)
EXTREME = Domain("extreme", (-300, 300), -300, -15.3, (-3, 3), -300)
DOMAINS = (BENCH, EXTREME)


def floats(
    entry: Entry, domain: Domain, count: int, seed: int = 17, more: Sequence[sp.Symbol] = ()
) -> Iterator[Floats]:
    """Points of all regions of an entry in turn, with `more` symbols; those that break a rule are drawn again."""
    rng = random.Random(f"{seed} {domain.name} {entry.key}")
    for case in itertools.islice(itertools.cycle(entry.cases), count):
        for _ in range(ATTEMPTS):
            draw = Draw(entry.profile, domain, rng)
            if entry.profile.largest is not None and nt.k in entry.parameters:
                draw[nt.k]
            draw.chain(case.chain)
            for symbol in (*entry.quantity.arguments, *entry.profile.free_depth, *entry.parameters, *more):
                draw[symbol]
            if draw.allowed():
                yield draw.values
                break


@dataclass
class Draw:
    """One point: the chain of its region first, then every parameter, then what the arguments still leave open."""

    profile: Profile
    domain: Domain
    rng: random.Random
    values: Floats = field(default_factory=dict)

    def __getitem__(self, symbol: Any) -> Any:
        if symbol not in self.values:
            self.values[symbol] = self._value(symbol)
        return self.values[symbol]

    def chain(self, chain: tuple[sp.Expr, ...]) -> None:
        """Ascending lengths by ratios, starting from one that follows from parameters, else from any of them."""
        fixed = [i for i, x in enumerate(chain) if not (x.is_Symbol and x not in dict(self.profile.abbreviations))]
        anchor = fixed[0] if fixed else self.rng.randrange(max(1, len(chain)))
        places = [*range(anchor, len(chain)), *range(anchor - 1, -1, -1)]
        sizes: dict[int, float] = {}
        for i in places:
            if i == anchor or chain[i] in self.values or i in fixed:
                sizes[i] = self.number(chain[i])
                continue
            near = sizes[i + 1] * self.ratio() if i < anchor else sizes[i - 1] / self.ratio()
            self.values[chain[i]] = sizes[i] = near
        for symbol in self.profile.parameters:
            self[symbol]
        if self.profile.compact:
            self[nt.a]
        self[nt.E_star]

    def number(self, expr: sp.Expr) -> float:
        """The value of an expression of parameters, drawn where they are open."""
        expr = sp.sympify(expr)
        if expr.is_Symbol and expr not in dict(self.profile.abbreviations):
            return float(self[expr])
        expr = expr.subs(dict(self.profile.abbreviations))
        # in the order of their names: each draws from the generator
        symbols = sorted(expr.free_symbols, key=str)
        return float(sp.N(expr.subs({symbol: sp.Float(self[symbol], 30) for symbol in symbols})))

    def ratio(self) -> float:
        """A number in (0, 1): half of them log-uniform towards 0, half towards 1."""
        if self.rng.random() < 0.5:
            decades = self.domain.small if self.rng.random() < 0.5 else max(self.domain.small, -6)
            return float(10 ** self.rng.uniform(decades, 0))
        return 1.0 - 10 ** self.rng.uniform(self.domain.close, 0)

    def length(self) -> float:
        """Half of the extreme lengths stay within thirty decades, so that their products exist."""
        low, high = self.domain.lengths
        if self.rng.random() < 0.5:
            low, high = max(low, -30), min(high, 30)
        return float(10 ** self.rng.uniform(low, high))

    def largest(self) -> float:
        """A radius up to which the contact is compact: that of k = 0 holds for k > 0, that of k = -1 for all k."""
        end = self.number(self.profile.largest)
        return end * _share_of_springs(self.profile) if self.values.get(nt.k, 0.0) < 0.0 else end

    def _value(self, symbol: Any) -> Any:
        rng, domain, profile = self.rng, self.domain, self.profile
        if symbol == nt.theta:
            return 1.5 * 10 ** rng.uniform(domain.slopes if rng.random() < 0.5 else -2, 0)
        if symbol == nt.n:
            return 10 ** rng.uniform(*domain.exponents)
        if symbol in MODULI and symbol not in profile.parameters:
            return 10 ** rng.uniform(-3, 12)
        if symbol == nt.dgamma:
            # an energy that pulls the surface by a visible part of the contact radius, or by none
            return self[nt.a] * 10 ** rng.uniform(-12, 12)
        if symbol == nt.mu:
            return 10 ** rng.uniform(-3, 0)
        if symbol == nt.k:
            return self._grading()
        if symbol == nt.sigma:
            return 10 ** rng.uniform(*domain.exponents) - 1.0
        if symbol == nt.e:
            return self._eccentricity()
        if symbol == nt.x and nt.e in profile.parameters:
            return self._place()
        if symbol == nt.c:
            return self[nt.a] * self.ratio()
        if symbol == nt.coefficients:
            return tuple(self._amplitude(j) for j in range(1, TERMS + 1))
        if symbol == nt.A:
            power = profile.pieces[0].expr.as_independent(nt.r)[1].as_base_exp()[1]
            return self._amplitude(self.number(power))
        if symbol == nt.wavelength:
            return self[nt.a] / 10 ** rng.uniform(-3, 1.3)
        if symbol == nt.a and profile.largest is not None:
            return self.largest() * self.ratio()
        if symbol == nt.R2 and profile.rules:
            return self[nt.R1] * self.ratio()
        if symbol == nt.h and profile.rules and nt.wavelength in profile.parameters:
            (rule,) = profile.rules
            return self.number(rule.right) / self.number(rule.left / nt.h) * rng.random()
        return self.length()

    def _grading(self) -> float:
        """Of the elastic modulus; half of the extreme ones next to -1, 0 and 1."""
        if self.domain.close == BENCH.close or self.rng.random() < 0.5:
            return self.rng.uniform(-0.9, 0.9)
        near = 10 ** self.rng.uniform(self.domain.close, -1)
        return self.rng.choice((-1.0 + near, -near, near, 1.0 - near))

    def _eccentricity(self) -> float:
        """Of a load on either side: a third of them anywhere, a third next to a/2, where an edge lifts off."""
        kind = self.rng.randrange(3)
        if kind == 0:
            share = self.rng.random()
        elif kind == 1:
            share = 0.5 * (1.0 + self.rng.choice((-1, 1)) * 10 ** self.rng.uniform(self.domain.close, -1))
        else:
            share = self.ratio()
        return self.rng.choice((-1.0, 1.0)) * share * float(self[nt.a])

    def _place(self) -> float:
        """On either side of the middle; half of those after lift-off by their distance from the end of the contact."""
        a, e = float(self[nt.a]), float(self[nt.e])
        end, width = 2.0 * (2.0 * abs(e) - a) - a, 4.0 * (a - abs(e))
        if width < 2.0 * a and self.rng.random() < 0.5:
            return math.copysign(1.0, e) * (end + width * 10 ** self.rng.uniform(self.domain.close, 0))
        return self.rng.choice((-1.0, 1.0)) * a * self.ratio()

    def _amplitude(self, n: float) -> float:
        """A of A r**n such that the height at r = a is a length."""
        if not SMALLEST < self[nt.a] < LARGEST:
            return 0.0
        decades = math.log10(self.length()) - n * math.log10(self[nt.a])
        return 10**decades if abs(decades) < 308 else 0.0

    def allowed(self) -> bool:
        """Whether all numbers are normal doubles, the contact is within its largest radius, and the rules hold."""
        sizes = [value for symbol, value in self.values.items() if symbol not in (nt.k, nt.sigma)]
        numbers = [x for value in sizes for x in (value if isinstance(value, tuple) else (value,))]
        # a length of zero or infinity is drawn where a ratio leaves the range of doubles
        if not all(SMALLEST < abs(x) < LARGEST for x in numbers):
            return False
        if self.profile.largest is not None and not self[nt.a] <= self.largest():
            return False
        return all(self.number(rule.left) <= self.number(rule.right) for rule in self.profile.rules)


@cache
def _share_of_springs(profile: Profile) -> float:
    """For k = -1 the depth is a f'(a) but for a factor: the radius of its largest value over that of k = 0."""
    units = dict.fromkeys(profile.parameters, 1)
    shape, end = profile.pieces[0].expr.subs(units), float(sp.sympify(profile.largest).subs(units))
    return float(sp.nsolve(sp.diff(nt.r * sp.diff(shape, nt.r), nt.r), end / 2.0)) / end
