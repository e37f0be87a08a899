"""What an entry is worth at a point in double precision: Arb enclosures, far beyond a double."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from contextlib import contextmanager
from functools import lru_cache
from typing import Any

import sympy as sp
from flint import acb, arb, ctx

from .. import notation as nt
from ..entry import Case, Entry
from ..oracle.balls import Ball, NotAvailableError, exact
from ..oracle.shape import coefficient, concrete
from .samples import TERMS, Floats

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
    """
    entry = entries[suffix]
    if not is_inverse(entry):
        return values, of_contact(entries, suffix, values)
    target = float(enclosed(entries[entry.quantity.inverts], values, ()))
    if not 2.3e-308 < target < 1.7e308:
        message = f"{entry.key}: the argument {target} is no normal number"
        raise UnknownError(message)
    arguments = {**values, entry.quantity.arguments[0]: target}
    return arguments, _at(entries, suffix, arguments)


def condition(entries: dict[str, Entry], suffix: str, arguments: Floats, held: Collection[sp.Symbol] = ()) -> float:
    """The sum of |d ln value/d ln x| over the arguments but for those that are `held`, by exact differences."""
    entry, total = entries[suffix], arb(0)
    hidden = {*held, nt.a} if is_inverse(entry) else set(held)
    with _precision(4 * BITS):
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
    with _precision(4 * BITS):
        equation = _case(entry, _balls(entry, values)).expr
        if not isinstance(equation, sp.Equality):
            return arb(0)
        if entry.quantity.symbol == nt.r_peak and entry.profile.breaks:
            (edge,), a = entry.profile.breaks, arb(values[nt.a])
            b = arb(values[edge])
            return b + (a - b) * share_of_peak(_plain(equation.lhs - equation.rhs), edge, b / a)
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


def share_of_peak(rest: sp.Expr, b: sp.Symbol, ratio: Any) -> arb:
    """(r - b)/(a - b) where the pressure is greatest, from its balance `rest` and b/a, a ball or an exact number."""

    def missed(share: arb) -> arb:
        return Ball({nt.a: acb(1), b: acb(found), nt.r_peak: acb(found + share * (1 - found))}, False)(rest).real

    with _precision(4 * BITS):
        found = ratio if isinstance(ratio, arb) else exact(ratio).real
        # next to b/a = 0 it is sqrt(pi b/a)/2, next to 1 it is 0.305
        return _between(missed, found.log() / 2 - 2, arb(-1) / 16, f"no greatest pressure for b/a = {ratio}")


def _between(missed: Callable[[arb], arb], low: arb, high: arb, message: str) -> arb:
    """The root between the exponentials of two numbers."""

    def positive(share: arb) -> bool:
        # most signs show in a quarter of the bits, in a fifth of the time
        with _precision(BITS):
            found = missed(share)
        return bool((found if found > 0 or found < 0 else missed(share)) > 0)

    with _precision(4 * BITS):
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
    return bool(entry.quantity.inverts) and entry.quantity.symbol != nt.c and entry.profile.compact


def _at(entries: dict[str, Entry], suffix: str, arguments: Floats, wanted: int = WANTED) -> arb:
    entry = entries[suffix]
    if not is_inverse(entry):
        return of_contact(entries, suffix, arguments, wanted)
    asked, (given,) = entry.quantity.symbol, entry.quantity.arguments
    radius = _root(entries[entry.quantity.inverts], arguments, arguments[given])
    return radius if asked == nt.a else enclosed(entries[str(asked)], arguments, ((nt.a, radius),), wanted)


@contextmanager
def _precision(bits: int) -> Iterator[None]:
    before, ctx.prec = ctx.prec, bits
    try:
        yield
    finally:
        ctx.prec = before


def _root(curve: Entry, values: Floats, target: float | arb) -> arb:
    """Newton's iteration from the radius that was rounded away, its slope from a difference."""
    with _precision(4 * BITS):
        radius = arb(values[nt.a])
        for _ in range(4):
            step = radius * arb(2) ** (-2 * BITS)
            value, ahead = (enclosed(curve, values, ((nt.a, x),), 2 * BITS + WANTED) for x in (radius, radius + step))
            radius = (radius - (value - target) * step / (ahead - value)).mid()
        if not abs(enclosed(curve, values, ((nt.a, radius),), 2 * BITS) / target - 1) < arb(2) ** -BITS:
            message = f"{curve.key}: no radius for {target}, next to a stationary value"
            raise UnknownError(message)
        return radius


def enclosed(entry: Entry, values: Floats, exact: tuple[tuple[sp.Symbol, arb], ...], wanted: int = WANTED) -> arb:
    """A ball with `wanted` correct bits around the value of the entry."""
    bits, before = max(BITS, 2 * wanted), ctx.prec
    try:
        while bits <= HIGHEST:
            ctx.prec = bits
            point = _balls(entry, values) | {symbol: acb(value) for symbol, value in exact}
            value = Point(point, False)(_plain(_case(entry, point).expr))
            if value.is_finite() and value.real.rel_accuracy_bits() >= wanted and value.imag.contains(0):
                return value.real
            bits *= 2
    except NotAvailableError as error:
        raise UnknownError(str(error)) from error
    finally:
        ctx.prec = before
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
