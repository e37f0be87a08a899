"""Ranges, domains and approaches in words, compared as sets with what the profiles and the notation demand."""

from __future__ import annotations

import itertools
import random
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..oracle.evaluate import evaluate
from ..profiles.profile import Profile
from .compare import DIGITS, difference
from .grammar import read
from .printed import holds, name_in_print, named

CLOSE = mp.mpf(10) ** -20
"""A statement agrees with the engine to twenty digits or it does not agree."""
Truth = Callable[[Mapping[str, Any]], bool]


@dataclass(frozen=True)
class Said:
    """A statement in words, and whether any text in its place is wrong."""

    tex: str
    wrong: Callable[[str], bool]


DRAWS = 200
PAIRS, HALVINGS = 16, 40
GAP = mp.mpf(10) ** -5
"""How far beside a border a range is tried, over the distance of the draws: it shows a changed fifth digit."""
SPREAD = (-70, -20, -7, -3, 3, 7, 13, 17, 20, 45, 90, 140)
"""Twentieths from which the values are drawn at which a printed range and its meaning are compared."""


def same_range(truth: Truth, names: tuple[str, ...]) -> Callable[[str], bool]:
    """Whether a printed range differs anywhere from a condition; borders, where it may be either, are not met."""
    rng = random.Random(" ".join(names))
    draws = [
        {name: mp.mpf(rng.choice(SPREAD) * 10**6 + rng.randint(1, 10**6)) / (20 * 10**6) for name in names}
        for _ in range(DRAWS)
    ]

    draws += list(_beside_borders(truth, draws))

    def wrong(tex: str) -> bool:
        return any(holds(tex, env) != truth(env) for env in draws)

    return wrong


def _beside_borders(truth: Truth, draws: list[dict[str, Any]]) -> Iterator[dict[str, Any]]:
    """Points on both sides of where the condition changes between draws inside and outside."""
    inside, outside = ([env for env in draws if truth(env) == side] for side in (True, False))
    for one, other in list(zip(inside, outside, strict=False))[:PAIRS]:
        low, high = mp.mpf(0), mp.mpf(1)
        for _ in range(HALVINGS):
            middle = (low + high) / 2
            low, high = (middle, high) if truth(_between(one, other, middle)) else (low, middle)
        yield _between(one, other, low - GAP)
        yield _between(one, other, high + GAP)


def _between(one: Mapping[str, Any], other: Mapping[str, Any], share: Any) -> dict[str, Any]:
    return {name: value + share * (other[name] - value) for name, value in one.items()}


def domain_of(record: nt.Notation) -> tuple[Truth, tuple[str, ...]]:
    """The domain of a symbol as the notation states it, `-1 < nu <= 1/2`, and the names in print it is about."""
    text = record.domain
    parts = re.split(r"<=?|>=?", text)
    names = [name for name in dict.fromkeys(re.findall(r"[A-Za-z]\w*", text)) if name != "pi"]
    symbols = {name: nt.describe(name).symbol if nt.known(name) else record.symbol for name in names}
    members = [_side(part.strip(), symbols) for part in parts]
    order = reversed(members) if ">" in text else iter(members)
    ascending = list(order)

    def truth(env: Mapping[str, Any]) -> bool:
        known = [member(env) for member in ascending]
        return all(lo < hi for lo, hi in itertools.pairwise(known))

    return truth, tuple(name_in_print(symbol) for symbol in symbols.values())


def _side(text: str, symbols: Mapping[str, sp.Symbol]) -> Callable[[Mapping[str, Any]], Any]:
    sign, name = (-1, text[1:]) if text.startswith("-") and text[1:] in symbols else (1, text)
    if name in symbols:
        printed = name_in_print(symbols[name])
        return lambda env: sign * env[printed]
    number = mp.pi / 2 if text == "pi/2" else mp.mpf(sp.Rational(text).p) / sp.Rational(text).q
    return lambda env: number


def domains() -> Iterator[Said]:
    """The domains of the symbols, in the table of the notation and in the panels."""
    for record in nt.all_notation():
        if record.domain and not isinstance(record.symbol, sp.IndexedBase):
            truth, names = domain_of(record)
            yield Said(record.domain, same_range(truth, names))


def rules(profile: Profile, plane: bool = False) -> Iterator[Said]:
    """What a profile demands of its parameters, the order of its lengths, its shorthands and its limits."""
    pairs = [(rule.left, rule.right) for rule in profile.rules]
    pairs += list(itertools.pairwise(profile.chain))
    if profile.truncated:
        pairs.append((profile.breaks[0], nt.a))
    if profile.largest is not None:
        pairs.append((nt.a, profile.largest))
    yield from _pairs(pairs)
    for piece in profile.pieces:
        if piece.upper is not None:
            place = nt.x if plane else nt.r
            yield from _pairs([(place, piece.upper), (piece.upper, place)])
    for symbol, expr in profile.abbreviations:
        yield Said(f"{symbol} = {expr}", _shorthand(symbol, expr))
    for limit in profile.limits:
        yield Said(f"{limit.symbol} -> {limit.value}", approach(limit.symbol, sp.sympify(limit.value)))


def _pairs(pairs: list[tuple[sp.Expr, sp.Expr]]) -> Iterator[Said]:
    for low, high in pairs:
        names = tuple(sorted({name_in_print(s) for s in (low - high).free_symbols}))
        yield Said(f"{low} < {high}", same_range(_ordered(low, high), names))


def _ordered(low: sp.Expr, high: sp.Expr) -> Truth:
    symbols = sorted((low - high).free_symbols, key=str)
    gap = sp.lambdify(symbols, high - low, "mpmath")
    names = [name_in_print(s) for s in symbols]
    return lambda env: bool(gap(*(env[name] for name in names)) > 0)


def _shorthand(symbol: sp.Symbol, expr: sp.Expr) -> Callable[[str], bool]:
    values = {s: sp.Rational(3 + 2 * i, 7 + i) for i, s in enumerate(sorted(expr.free_symbols, key=str))}

    def wrong(tex: str) -> bool:
        name, *members = read(tex)[0].members
        with mp.workdps(2 * DIGITS):
            want = evaluate(expr, values, DIGITS)
            found = [member(named(values)) for member in members]
        return name.name != name_in_print(symbol) or not found or any(difference(x, want) > CLOSE for x in found)

    return wrong


def approach(symbol: sp.Symbol, value: sp.Expr) -> Callable[[str], bool]:
    """A test of printed texts, true for those that do not say that the symbol goes to this value."""

    def wrong(tex: str) -> bool:
        left, arrow, right = tex.partition(r"\to ")
        if not arrow or read(left)[0].members[0].name != name_in_print(symbol):
            return True
        aim = r"\infty" if value is sp.oo else None
        return right.strip() != aim if aim else read(right)[0].members[0]({}) != value

    return wrong
