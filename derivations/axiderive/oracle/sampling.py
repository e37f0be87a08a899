"""Exact points at which formulas are checked: random ones and extreme ones, from a recorded seed."""

from __future__ import annotations

import itertools
import random
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..profiles.profile import Profile
from .evaluate import evaluated
from .shape import coefficient

Values = dict[Any, Any]

NEARLY_ZERO = sp.Rational(1, 10**9)
NEARLY_ONE = 1 - NEARLY_ZERO
EXPONENTS = (sp.Rational(1, 2), sp.Integer(1), sp.Integer(2), sp.Rational(37, 10), sp.Integer(40))
POLYNOMIAL = 4
"""Degree at which the polynomial profile is checked."""
_SIZE = sp.Symbol("size", positive=True)


@dataclass(frozen=True)
class Point:
    """Exact values by symbol, and whether a ratio of neighbouring lengths is next to 0 or 1."""

    values: Values
    extreme: bool


def points(
    profile: Profile, chain: tuple[sp.Expr, ...], count: int, seed: int, fields: tuple[sp.Symbol, ...] = ()
) -> list[Point]:
    """`count` points of the region lo < ... < hi of the chain, the extreme ones early.

    `fields` are further symbols that need a value.  Ratios of neighbours in the
    chain are 1e-9, 1 - 1e-9 or random; everything is a rational number, or an
    exact expression where an abbreviation of the profile asks for one.
    """
    rng = random.Random(f"{seed} {profile.name} {chain}")
    plans = _plans(max(0, len(chain) - 1))
    return [_draw(profile, chain, fields, next(plans), i, rng) for i in range(count)]


def fields(profile: Profile, entry: Entry) -> tuple[sp.Symbol, ...]:
    """What besides the parameters needs a value: the arguments of the entry, and the depth where it is free."""
    return (*entry.quantity.arguments, *profile.free_depth)


def border(
    profile: Profile,
    chain: tuple[sp.Expr, ...],
    position: int,
    gap: sp.Rational,
    seed: int,
    fields: tuple[sp.Symbol, ...],
) -> Values:
    """A random point at which the elements `position` and `position + 1` of the chain are a ratio 1 - gap apart."""
    rng = random.Random(f"{seed} {profile.name} {chain} {position}")
    plan = tuple(1 - gap if i == position else None for i in range(len(chain) - 1))
    return _draw(profile, chain, fields, plan, 0, rng).values


def _plans(pairs: int) -> Any:
    """Ratios of neighbours, None for random: low and high alternate, then every combination, then random."""
    yield (None,) * pairs
    marks = (NEARLY_ZERO, NEARLY_ONE)
    alternating = [tuple(marks[(i + start) % 2] for i in range(pairs)) for start in (0, 1)]
    if pairs:
        yield from alternating
        yield from (plan for plan in itertools.product(marks, repeat=pairs) if plan not in alternating)
    while True:
        yield (None,) * pairs


def _ratio(rng: random.Random) -> sp.Rational:
    """Half uniform in (0, 1), a quarter log-uniform towards each end."""
    kind = rng.randrange(4)
    if kind < 2:
        return sp.Rational(rng.randint(1, 9999), 10000)
    small = sp.Rational(rng.randint(10, 99), 10 ** rng.randint(3, 8))
    return small if kind == 2 else 1 - small


def _length(rng: random.Random) -> sp.Rational:
    return sp.Rational(rng.randint(200, 5000), 1000)


def _draw(
    profile: Profile,
    chain: tuple[sp.Expr, ...],
    fields: tuple[sp.Symbol, ...],
    plan: tuple[sp.Rational | None, ...],
    index: int,
    rng: random.Random,
) -> Point:
    for attempt in range(1000):
        ratios = [_ratio(rng) if fixed is None else fixed for fixed in plan]
        values = _chain_values(chain, ratios, rng)
        _neighbours(profile, values, rng)
        _parameters(profile, fields, values, index + attempt, rng)
        if _allowed(profile, values):
            return Point(values, any(fixed is not None for fixed in plan))
    message = f"{profile.name}: no point found in {chain} that keeps the rules of the profile; check chain and rules"
    raise LookupError(message)


def _chain_values(chain: tuple[sp.Expr, ...], ratios: list[sp.Rational], rng: random.Random) -> Values:
    """Symbols of the chain first; expressions of them are solved for what they still leave open."""
    sizes: list[sp.Expr] = [_length(rng)]
    for ratio in reversed(ratios):
        sizes.insert(0, sizes[0] * ratio)
    values: Values = {x: size for x, size in zip(chain, sizes, strict=False) if x.is_Symbol}
    for element, size in zip(chain, sizes, strict=False):
        if not element.is_Symbol and element.free_symbols:
            _solve(element, size, values, rng)
    return values


def _solve(element: sp.Expr, size: sp.Expr, values: Values, rng: random.Random) -> None:
    """Choose the symbols of the element so that it takes the given size."""
    open_symbols = sorted(element.free_symbols - set(values), key=str)
    for symbol in open_symbols[:-1]:
        values[symbol] = _length(rng)
    if open_symbols:
        values[open_symbols[-1]] = _inverse(element, open_symbols[-1]).xreplace(values | {_SIZE: size})


@lru_cache(maxsize=256)
def _inverse(element: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    """The symbol in terms of the size of the element: solved with letters, numbers would have to be factored."""
    roots: list[sp.Expr] = sp.solve(element - _SIZE, symbol)
    return min(roots, key=sp.count_ops)


def _order(profile: Profile) -> list[tuple[sp.Expr, sp.Expr]]:
    """Pairs of lengths in ascending order that hold in every contact with the profile."""
    pairs = list(itertools.pairwise(profile.chain))
    if profile.largest is not None:
        pairs.append((nt.a, profile.largest.xreplace({x: sp.Rational(x) for x in profile.largest.atoms(sp.Float)})))
    return pairs


def _neighbours(profile: Profile, values: Values, rng: random.Random) -> None:
    """Lengths that the profile orders, such as a < R, but the case does not mention."""
    for lo, hi in _order(profile):
        ratio = rng.choice((NEARLY_ZERO, NEARLY_ONE, None, None)) or _ratio(rng)
        if not lo.free_symbols - set(values) and hi.free_symbols - set(values):
            _solve(hi, lo.xreplace(values) / ratio, values, rng)


def _parameters(
    profile: Profile, fields: tuple[sp.Symbol, ...], values: Values, index: int, rng: random.Random
) -> None:
    scale = values.get(nt.a, sp.Integer(1))
    for symbol, expr in profile.abbreviations:
        if symbol in values:
            _solve(expr, values[symbol], values, rng)
    for symbol in (*profile.parameters, *fields, nt.E_star):
        if symbol in values:
            continue
        if symbol == nt.coefficients:
            values[nt.N] = sp.Integer(POLYNOMIAL)
            values |= {coefficient(i): _length(rng) for i in range(1, POLYNOMIAL + 1)}
        elif symbol == nt.n:
            values[symbol] = EXPONENTS[index % len(EXPONENTS)]
        elif symbol == nt.theta:
            values[symbol] = sp.Rational(rng.randint(5, 140), 100)
        elif symbol == nt.wavelength:
            values[symbol] = scale / sp.Rational(rng.randint(5, 1000), 100)
        elif symbol == nt.h:
            values[symbol] = scale * sp.Rational(rng.randint(1, 99), 10 ** rng.randint(2, 6))
        elif nt.describe(symbol).dimension == nt.LENGTH:
            values[symbol] = scale * rng.choice((_ratio(rng), 1 / _ratio(rng), 1 / _ratio(rng)))
        else:
            values[symbol] = _length(rng)
    for symbol, expr in profile.abbreviations:
        if symbol not in values:
            values[symbol] = expr.xreplace(values)


def _allowed(profile: Profile, values: Values) -> bool:
    for lo, hi in _order(profile):
        if not (lo.free_symbols | hi.free_symbols) - set(values) and evaluated(lo, values) >= evaluated(hi, values):
            return False
    for rule in profile.rules:
        left, right = evaluated(rule.left, values), evaluated(rule.right, values)
        if left > right or (rule.strict and left == right):
            return False
    return True
