"""Points in double precision at which emitted functions are measured, and what an entry is exactly worth there.

The points lie in a bench domain, and at the ends of the range; the values are Arb enclosures, far beyond a double.
"""

from __future__ import annotations

import itertools
import math
import random
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache, lru_cache
from typing import Any

import sympy as sp
from flint import acb, arb, ctx

from .. import notation as nt
from ..entry import Case, Entry
from ..oracle.balls import Ball, NotAvailableError, exact
from ..oracle.shape import coefficient, concrete
from ..physics.cohesive import cohesive
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
        if symbol == nt.sigma_0:
            return self[nt.E_star] * 10 ** rng.uniform(-12, 2)
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
        if self.profile.largest is not None and not max(self[nt.a], self.values.get(cohesive, 0.0)) <= self.largest():
            return False
        return all(self.number(rule.left) <= self.number(rule.right) for rule in self.profile.rules)


@cache
def _share_of_springs(profile: Profile) -> float:
    """For k = -1 the depth is a f'(a) but for a factor: the radius of its largest value over that of k = 0."""
    units = dict.fromkeys(profile.parameters, 1)
    shape, end = profile.pieces[0].expr.subs(units), float(sp.sympify(profile.largest).subs(units))
    return float(sp.nsolve(sp.diff(nt.r * sp.diff(shape, nt.r), nt.r), end / 2.0)) / end


# exact values

BITS, HIGHEST, WANTED, STEP = 160, 1 << 13, 70, 90
RINGS = (nt.r_zero, nt.x_zero, nt.r_peak)
"""Where the pressure of a complete contact vanishes first, round and plane, and that of a compact one is greatest."""


class UnknownError(ArithmeticError):
    """No enclosure, or no region of the entry that surely holds the point."""


REAL: dict[Any, Callable[..., acb]] = {
    sp.Abs: lambda x: acb(abs(x.real)),
    sp.sign: lambda x: acb(x.real.sgn()),
    sp.Max: lambda x, y: acb(x.real.max(y.real)),
    sp.elliptic_k: lambda m: m.elliptic_k(),
    sp.elliptic_e: lambda m: m.elliptic_e(),
}
"""What stands in no integrand: of a load on either side, and complete elliptic integrals."""


class Point(Ball):
    """A ball at real numbers alone."""

    def _value(self, expr: sp.Expr) -> acb:
        rule = REAL.get(type(expr))
        if rule is None or isinstance(expr, sp.elliptic_e) and len(expr.args) > 1:
            return super()._value(expr)
        return rule(*(self(arg) for arg in expr.args))


def reference(entries: dict[str, Entry], suffix: str, values: Floats) -> tuple[Floats, arb]:
    """The arguments of the emitted function by symbol, and the exact value it stands for.

    For an inverse the point holds the contact radius; the depth or force is
    rounded to a double there, and the radius that belongs to it found again.
    So is a length in a formula, which is the root of another entry.
    """
    entry = entries[suffix]
    root = entry if is_inverse(entry) else _solved(entries, entry)
    if root is None:
        return values, of_contact(entries, suffix, values)
    curve = entries[root.quantity.inverts]
    target = float(enclosed(curve, values, ()))
    if not 2.3e-308 < target < 1.7e308:
        message = f"{entry.key}: the argument {target} is no normal number"
        raise UnknownError(message)
    arguments = {**values, curve.quantity.symbol: target}
    return arguments, _at(entries, suffix, arguments)


def condition(entries: dict[str, Entry], suffix: str, arguments: Floats, held: Collection[sp.Symbol] = ()) -> float:
    """The sum of |d ln value/d ln x| over the arguments but for those that are `held`, by exact differences."""
    entry, total = entries[suffix], arb(0)
    solved = _solved(entries, entry)
    hidden = {*held, nt.a} if is_inverse(entry) else {*held, solved.quantity.symbol} if solved else set(held)
    with ctx.workprec(4 * BITS):
        here = _at(entries, suffix, arguments, STEP + WANTED)
        for symbol, number in arguments.items():
            if symbol in hidden or isinstance(number, tuple):
                continue
            moved = {**arguments, symbol: arb(number) * (1 + arb(2) ** -STEP)}
            total += abs(_at(entries, suffix, moved, STEP + WANTED) / here - 1) * arb(2) ** STEP
    return float(total)


def of_contact(entries: Mapping[str, Entry], suffix: str, values: Floats, wanted: int = WANTED) -> arb:
    """The value of an entry, at the ring where the pressure vanishes first, or is greatest, if it depends on that."""
    entry = entries[suffix]
    if entry.quantity.symbol in RINGS and entry.status == "root":
        return _ring(entry, values)
    named = {place for place in RINGS if any(case.expr.has(place) for case in entry.cases)}
    rests = [own for own in entries.values() if own.quantity.symbol in named]
    return enclosed(entry, values, tuple((own.quantity.symbol, _ring(own, values)) for own in rests), wanted)


def _ring(entry: Entry, values: Floats) -> arb:
    """Zero, or the root of the equation of the place."""
    with ctx.workprec(4 * BITS):
        equation = _case(entry, _balls(entry, values)).expr
        if not isinstance(equation, sp.Equality):
            return arb(0)
        if entry.quantity.symbol == nt.r_peak and entry.profile.breaks:
            (edge,), a = entry.profile.breaks, arb(values[nt.a])
            b = arb(values[edge])
            return b + (a - b) * share_of_peak(_plain(equation.lhs - equation.rhs), edge, b / a)
        if entry.quantity.symbol == nt.r_peak and entry.profile.chain:
            end = entry.profile.chain[-1]
            return arb(values[nt.a]) * _share_of_arc(equation.lhs - equation.rhs, end, values[nt.a], values[end])
        n = values[nt.n]
        find = _share_of_ring if isinstance(n, float) else _share_of_ring.__wrapped__
        rest = (equation.lhs - equation.rhs).subs(entry.quantity.symbol, nt.r_zero)
        return arb(values[nt.a]) * find(_plain(rest), n)


@lru_cache(maxsize=256)
def _share_of_ring(rest: sp.Expr, n: float | arb) -> arb:
    """r_0/a: bisected in decades, then by Newton's iteration; all entries of a point ask for the same."""

    def missed(share: arb) -> arb:
        return Ball({nt.n: acb(n), nt.a: acb(1), nt.r_zero: acb(share)}, False)(rest).real

    # up to the radius where 1 - r**2/a**2 is 1/n and a side of the equation of zero pressure infinite
    return _between(missed, arb(-80), (1 - 1 / arb(n)).sqrt().log(), f"no ring for n = {n}")


def _share_of_arc(rest: sp.Expr, end: sp.Symbol, *values: float | arb) -> arb:
    """r_max/a beyond the radius at which the ring leaves the axis."""
    a, R = map(arb, values)

    def missed(share: arb) -> arb:
        return Ball({nt.a: acb(a), end: acb(R), nt.r_peak: acb(a * share)}, False)(rest).real

    # 1 - (r/a)**2 is between 1 and 8 times this, which is little next to the edge of the body
    beyond = (R / a) ** 2 - 1
    low = (1 - 8 * beyond).log() / 2 if beyond < arb(1) / 8 else arb(-80)
    return _between(missed, low, (1 - beyond).log() / 2, f"no ring for a/{end} = {a / R}")


def share_of_peak(rest: sp.Expr, b: sp.Symbol, ratio: Any) -> arb:
    """(r - b)/(a - b) where the pressure is greatest, from its balance `rest` and b/a, a ball or an exact number."""

    def missed(share: arb) -> arb:
        return Ball({nt.a: acb(1), b: acb(found), nt.r_peak: acb(found + share * (1 - found))}, False)(rest).real

    with ctx.workprec(4 * BITS):
        found = ratio if isinstance(ratio, arb) else exact(ratio).real
        # next to b/a = 0 it is sqrt(pi b/a)/2, next to 1 it is 0.305
        return _between(missed, found.log() / 2 - 2, arb(-1) / 16, f"no greatest pressure for b/a = {ratio}")


def _between(missed: Callable[[arb], arb], low: arb, high: arb, message: str) -> arb:
    """The root between the exponentials of two numbers."""

    def positive(share: arb) -> bool:
        # most signs show in a quarter of the bits, in a fifth of the time
        with ctx.workprec(BITS):
            found = missed(share)
        return bool((found if found > 0 or found < 0 else missed(share)) > 0)

    with ctx.workprec(4 * BITS):
        first = positive(low.exp())
        for _ in range(40):
            middle = ((low + high) / 2).mid()
            low, high = (middle, high) if positive(middle.exp()) == first else (low, middle)
        share = ((low + high) / 2).exp().mid()
        for _ in range(4):
            step = share * arb(2) ** (-2 * BITS)
            here = missed(share)
            share = (share - here * step / (missed(share + step) - here)).mid()
        before, beyond = (missed(share * (1 + side * arb(2) ** -BITS)) for side in (-1, 1))
    if not before * beyond < 0:
        raise UnknownError(message)
    return share


def is_inverse(entry: Entry) -> bool:
    """Whether a depth or force of a growing contact is given, so that its radius has to be found."""
    own = entry.quantity
    return bool(own.inverts) and own.symbol != nt.c and nt.a not in own.arguments and entry.profile.compact


def _solved(entries: Mapping[str, Entry], entry: Entry) -> Entry | None:
    """The entry of which a length in a formula, none of its arguments, is the root at a given contact radius."""
    roots = (own for own in entries.values() if own.status == "root" and own.quantity.arguments == (nt.a,))
    return next((own for own in roots if own.quantity.inverts and own.quantity.symbol not in entry.arguments), None)


def _at(entries: dict[str, Entry], suffix: str, arguments: Floats, wanted: int = WANTED) -> arb:
    entry = entries[suffix]
    if solved := _solved(entries, entry):
        curve, symbol = entries[solved.quantity.inverts], solved.quantity.symbol
        length = _root(curve, arguments, arguments[curve.quantity.symbol], symbol)
        return length if entry is solved else enclosed(entry, arguments, ((symbol, length),), wanted)
    if not is_inverse(entry):
        return of_contact(entries, suffix, arguments, wanted)
    asked, (given,) = entry.quantity.symbol, entry.quantity.arguments
    radius = _root(entries[entry.quantity.inverts], arguments, arguments[given])
    return radius if asked == nt.a else enclosed(entries[str(asked)], arguments, ((nt.a, radius),), wanted)


def _root(curve: Entry, values: Floats, target: float | arb, length: sp.Symbol = nt.a) -> arb:
    """Newton's iteration from the radius that was rounded away, its slope from a difference."""
    with ctx.workprec(4 * BITS):
        radius = arb(values[length])
        for _ in range(4):
            step = radius * arb(2) ** (-2 * BITS)
            value, ahead = (enclosed(curve, values, ((length, x),), 2 * BITS + WANTED) for x in (radius, radius + step))
            radius = (radius - (value - target) * step / (ahead - value)).mid()
        if not abs(enclosed(curve, values, ((length, radius),), 2 * BITS) / target - 1) < arb(2) ** -BITS:
            message = f"{curve.key}: no radius for {target}, next to a stationary value"
            raise UnknownError(message)
        return radius


def enclosed(entry: Entry, values: Floats, exact: tuple[tuple[sp.Symbol, arb], ...], wanted: int = WANTED) -> arb:
    """A ball with `wanted` correct bits around the value of the entry."""
    bits = max(BITS, 2 * wanted)
    while bits <= HIGHEST:
        with ctx.workprec(bits):
            try:
                point = _balls(entry, values) | {symbol: acb(value) for symbol, value in exact}
                value = Point(point, False)(_plain(_case(entry, point).expr))
            except NotAvailableError as error:
                raise UnknownError(str(error)) from error
            if value.is_finite() and value.real.rel_accuracy_bits() >= wanted and value.imag.contains(0):
                return value.real
        bits *= 2
    message = f"{entry.key}: no enclosure below {HIGHEST} bits at {values}"
    raise UnknownError(message)


def _balls(entry: Entry, values: Floats) -> dict[Any, acb]:
    point: dict[Any, acb] = {}
    for symbol, value in values.items():
        if isinstance(value, tuple):
            point |= {coefficient(j): acb(number) for j, number in enumerate(value, 1)}
        else:
            point[symbol] = acb(value)
    for symbol, expr in entry.profile.abbreviations:
        point[symbol] = Ball(point, False)(expr)
    return point


def _case(entry: Entry, point: dict[Any, acb]) -> Case:
    for case in entry.cases:
        sizes = [Point(point, False)(_plain(sp.sympify(x))).real for x in case.chain]
        if all(low < high for low, high in zip(sizes, sizes[1:], strict=False)):
            return case
    message = f"{entry.key}: no region surely holds the point"
    raise UnknownError(message)


@lru_cache(maxsize=4096)
def _plain(expr: sp.Expr) -> sp.Expr:
    """Floats of the profile as the doubles they are, sums written out."""
    expr = concrete(expr, {nt.N: sp.Integer(TERMS)})
    return expr.xreplace({x: sp.Rational(float(x)) for x in expr.atoms(sp.Float)})
