"""Printed ranges against what holds: beside a row the cases of its entry, in words the profiles and the notation."""

from __future__ import annotations

import itertools
import random
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..oracle.shape import coefficient, number, numeric_symbols
from ..profiles.profile import Profile
from ..rows.approaches import BEYOND
from ..rows.claims import points_of
from ..rows.ranges import positive_parts
from .claims import Line, holds, name_in_print, stated
from .grammar import read

Truth = Callable[[Mapping[str, Any]], bool]
DRAWS = 200
PAIRS, HALVINGS = 16, 40
GAP = mp.mpf(10) ** -5
"""How far beside a border a range is tried, over the distance of the draws: it shows a changed fifth digit."""
SPREAD = (-70, -20, -7, -3, 3, 7, 13, 17, 20, 45, 90, 140)
"""Twentieths from which the values are drawn at which a printed range and its meaning are compared."""


def in_order(members: Sequence[sp.Expr], called: Callable[[sp.Symbol], str] = name_in_print) -> Callable[[str], bool]:
    """Whether a printed range differs anywhere from the order of these members, the least of them first.

    Borders, where it may be either, are not met.
    """
    symbols = sorted({s for member in members for s in member.free_symbols}, key=str)
    names = [called(symbol) for symbol in symbols]
    gaps = sp.lambdify(symbols, [high - low for low, high in itertools.pairwise(members)], "mpmath")

    def truth(env: Mapping[str, Any]) -> bool:
        return all(gap > 0 for gap in gaps(*(env[name] for name in names)))

    rng = random.Random(" ".join(names))
    draws = [
        {name: mp.mpf(rng.choice(SPREAD) * 10**6 + rng.randint(1, 10**6)) / (20 * 10**6) for name in names}
        for _ in range(DRAWS)
    ]
    draws += list(_beside_borders(truth, draws))
    return lambda tex: any(holds(tex, env) != truth(env) for env in draws)


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


def domains() -> Iterator[Line]:
    """The domains of the symbols as the notation states them, `-1 < nu <= 1/2`, in its table and in the panels."""
    for record in nt.all_notation():
        text = record.domain
        if not text or isinstance(record.symbol, sp.IndexedBase):
            continue
        names = set(re.findall(r"[A-Za-z]\w*", text)) - {"pi"}
        symbols = {name: nt.describe(name).symbol if nt.known(name) else record.symbol for name in names}
        members = [sp.sympify(part, symbols) for part in re.split(r"<=?|>=?", text)]
        yield Line("domain", text, in_order(members[::-1] if ">" in text else members))


def rules(profile: Profile, plane: bool = False) -> Iterator[Line]:
    """What a profile demands of its parameters, the order of its lengths, its shorthands and its limits."""
    pairs = [(rule.left, rule.right) for rule in profile.rules]
    pairs += list(itertools.pairwise(profile.chain))
    if profile.truncated:
        pairs.append((profile.breaks[0], nt.a))
    if profile.largest is not None:
        pairs.append((nt.a, profile.largest))
    place = nt.x if plane else nt.r
    pairs += [side for b in profile.breaks for side in ((place, b), (b, place))]
    for low, high in pairs:
        yield Line(profile.name, f"{low} < {high}", in_order([sp.sympify(low), sp.sympify(high)]))
    for symbol, expr in profile.abbreviations:
        values = {s: sp.Rational(3 + 2 * i, 7 + i) for i, s in enumerate(sorted(expr.free_symbols, key=str))}
        yield stated(expr, values, name_in_print(symbol)).line(profile.name, f"{symbol} = {expr}")
    limits = [(limit.symbol, sp.sympify(limit.value)) for limit in profile.limits]
    for symbol, end in (*limits, *((one.symbol, one.end) for one in BEYOND.get(profile.name, ()))):
        yield Line(profile.name, f"{symbol} -> {end}", approach(symbol, end))


def approach(symbol: sp.Symbol, value: sp.Expr) -> Callable[[str], bool]:
    """A test of printed texts, true for those that do not say that the symbol goes to this value."""

    def wrong(tex: str) -> bool:
        left, arrow, right = tex.partition(r"\to ")
        if not arrow or read(left)[0].members[0].name != name_in_print(symbol):
            return True
        end = read(right)[0].members[0]
        if value.is_Symbol:
            return end.name != name_in_print(value)
        return bool(end.name or end({}) != (mp.inf if value is sp.oo else value))

    return wrong


Numbers = dict[sp.Symbol, float]
BESIDE = 1e-3
"""How far a point lies from the border beside it."""
WIDEST = 64.0
"""Factor within which a length is moved to reach a border."""
PLACES = (nt.r, nt.x, nt.L)


@dataclass(frozen=True)
class Place:
    """A point, which case of its entry contains it, None outside of all, and which positive parts are not zero."""

    values: Numbers
    case: int | None
    parts: tuple[bool, ...] = ()


def misplaced(entry: Entry, conditions: Sequence[str], places: Sequence[Place]) -> Iterator[str]:
    """Complaints about printed ranges that do not tell the cases of an entry apart as the cases are defined.

    Every case belongs to one range, and no range holds outside of the cases.
    """
    if conditions == [""]:
        return
    known: dict[tuple[int | None, tuple[bool, ...]], tuple[bool, ...]] = {(None, ()): (False,) * len(conditions)}
    for place in places:
        env = {name_in_print(s): mp.mpf(value) for s, value in place.values.items() if nt.known(s.name)}
        found = tuple(holds(condition, env) for condition in conditions)
        wanted = known.setdefault((place.case, place.parts), found)
        if found != wanted or sum(found) > 1 or (place.case is not None and not any(found)):
            where = "outside" if place.case is None else f"in case {place.case + 1}"
            yield f"{entry.key}: {conditions} hold as {found} {where}, at {place.values}"


def places_of(entry: Entry, kind: str, entries: Mapping[str, Entry], seed: int = 17) -> list[Place]:
    """Points inside of every case, and beside every border that moving one length can reach."""
    members = dict.fromkeys(x for case in entry.cases for x in case.chain)
    meeting = [*itertools.combinations(members, 2)]
    meeting += [(part, sp.S.Zero) for case in entry.cases for part in positive_parts(case.expr).values()]
    found = []
    for case, exact in points_of(entry, kind, entries, 1, seed):
        values = {s: float(number(exact[s])) for s in numeric_symbols(exact)}
        values |= {coefficient(i): 1.0 for i in range(1, 1 + int(exact.get(nt.N, 0)))}
        found += [_placed(entry, values, entry.cases.index(case)), *_on_borders(entry, values)]
        for moved in _moved(entry, meeting, values):
            if _stands(entry, moved):
                reached = (i for i, own in enumerate(entry.cases) if _ascends(own.chain, moved))
                found.append(_placed(entry, moved, next(reached, None)))
    return found


def _on_borders(entry: Entry, values: Numbers) -> Iterator[Place]:
    """Points of the exponent at which an equation begins: the formula that ends there still holds."""
    formulas = {own.chain[-1]: i for i, own in enumerate(entry.cases) if not isinstance(own.expr, sp.Equality)}
    for border, exponent in (own.chain[:2] for own in entry.cases if isinstance(own.expr, sp.Equality) and own.chain):
        if border.is_number and exponent.is_Symbol and border in formulas:
            yield Place({**values, exponent: float(border)}, formulas[border])


def _placed(entry: Entry, values: Numbers, case: int | None) -> Place:
    parts = () if case is None else positive_parts(entry.cases[case].expr).values()
    return Place(values, case, tuple(_value(part, values) > 0 for part in parts))


def _moved(entry: Entry, meeting: list[tuple[sp.Expr, ...]], values: Numbers) -> Iterator[Numbers]:
    """The point with one length moved to either side of where two lengths meet."""
    short = dict(entry.profile.abbreviations)
    free = {s for pair in meeting for x in pair for s in x.free_symbols | short.get(x, x).free_symbols}
    for symbol in sorted(free & set(values) - set(short), key=str):
        for pair in meeting:
            factor = _crossing(entry, pair, symbol, values)
            if factor:
                yield from (_with(entry, symbol, values, factor * side) for side in (1 - BESIDE, 1 + BESIDE))


def _with(entry: Entry, symbol: sp.Symbol, values: Numbers, factor: float) -> Numbers:
    """The point with a symbol times a factor, and with what is short for expressions of it."""
    moved = {**values, symbol: values[symbol] * factor}
    for name, expr in entry.profile.abbreviations:
        if symbol in expr.free_symbols and name in moved:
            moved[name] = _value(expr, moved)
    return moved


def _crossing(entry: Entry, pair: tuple[sp.Expr, ...], symbol: sp.Symbol, values: Numbers) -> float | None:
    """The factor of a symbol at which two members are equal, by bisection; None where they keep their order."""

    def gap(factor: float) -> float:
        moved = _with(entry, symbol, values, factor)
        return _value(pair[0], moved) - _value(pair[1], moved)

    low, high = 1.0, next((step for step in (WIDEST, 1 / WIDEST) if gap(1.0) * gap(step) < 0), None)
    if high is None:
        return None
    for _ in range(HALVINGS):
        middle = (low * high) ** 0.5
        low, high = (middle, high) if gap(middle) * gap(1.0) > 0 else (low, middle)
    return high


@lru_cache(maxsize=1024)
def _compiled(expr: sp.Expr) -> tuple[tuple[sp.Symbol, ...], Any]:
    symbols = tuple(sorted(expr.free_symbols, key=str))
    return symbols, sp.lambdify(symbols, expr, "math")


def _value(expr: sp.Expr, values: Numbers) -> float:
    symbols, function = _compiled(sp.sympify(expr))
    try:
        return float(function(*(values[s] for s in symbols)))
    except (ValueError, OverflowError):
        return float("nan")


def _ascends(chain: Sequence[sp.Expr], values: Numbers) -> bool:
    known = [_value(x, values) for x in chain if x.free_symbols <= set(values)]
    return all(lo < hi for lo, hi in itertools.pairwise(known))


def _stands(entry: Entry, values: Numbers) -> bool:
    """Whether the point keeps what holds for every contact of the profile, inside and outside of its regions."""
    profile = entry.profile
    rules = all(_value(rule.left, values) <= _value(rule.right, values) for rule in profile.rules)
    domains = abs(values.get(nt.k, 0.0)) < 1 and values.get(nt.theta, 0.0) < float(sp.pi) / 2
    # what every case says of the lengths of its contact, leaving out the place where a field is asked for
    chains = ([x for x in case.chain if not x.has(*PLACES)] for case in entry.cases)
    shared = set.intersection(*(set(itertools.combinations(chain, 2)) for chain in chains))
    return rules and domains and all(_ascends(pair, values) for pair in (profile.chain, *shared))
