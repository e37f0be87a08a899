"""Every printed row against the entry it was printed from, through its LaTeX source alone."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Case, Entry
from ..proof.evaluate import case_at, decades, evaluate
from ..proof.sampling import points
from ..proof.shape import coefficient, number, numeric_symbols
from .readback import environment, read
from .rows import Region, Row, kappa_row, row
from .values import evaluated

Values = dict[Any, Any]
WORKING = 60
DIGITS = 30


def worst_residual(one: Row, entries: Mapping[str, Entry], count: int = 3, seed: int = 17) -> Any:
    """Largest relative difference between the printed row and its entry over random points of every case.

    Raises
    ------
    SyntaxError, KeyError
        If the source cannot be read, or uses what it does not define.
    """
    residuals = []
    for case, values in _points(one, entries, count, seed):
        # a displacement far outside leaves a^7/r of terms of the size of r^5 a
        with mp.workdps(WORKING + 10 * decades(values)):
            residuals += _compared(one, entries, case, values)
    return max(residuals)


def _points(one: Row, entries: Mapping[str, Entry], count: int, seed: int) -> list[tuple[Case, Values]]:
    """Points of every case; an inverse is met where its forward formula leads."""
    entry = one.entry
    if one.kind == "formula":
        drawn = [
            (case, points(entry.profile, _lengths(case), count, seed, _fields(entry, case))) for case in entry.cases
        ]
        return [(case, _within(case, point.values)) for case, found in drawn for point in found]
    forward = entries["d" if entry.suffix in ("ad", "Fd") else "F"]
    return [(case, p.values) for case in forward.cases for p in points(entry.profile, case.chain, count, seed)]


def _lengths(case: Case) -> tuple[sp.Expr, ...]:
    """The chain to draw from; numbers around an exponent are seen to afterwards."""
    return () if any(x.is_number for x in case.chain) else case.chain


def _fields(entry: Entry, case: Case) -> tuple[sp.Symbol, ...]:
    unknown = (nt.r_zero,) if case.expr.has(nt.r_zero) else ()
    return (*entry.quantity.arguments, *unknown)


def _within(case: Case, values: Values) -> Values:
    """A chain of numbers around an exponent, 1 < n < 2, is kept; the ring lies inside the contact."""
    fixed = dict(values)
    for i, x in enumerate(case.chain):
        if x.is_Symbol and i and case.chain[i - 1].is_number:
            room = case.chain[i + 1] - case.chain[i - 1] if i + 1 < len(case.chain) else sp.Integer(3)
            fixed[x] = case.chain[i - 1] + room * sp.Rational(3, 7)
    if nt.r_zero in fixed:
        fixed[nt.r_zero] = fixed[nt.a] * sp.Rational(7, 11)
    return fixed


def _value(expr: sp.Expr, values: Values) -> Any:
    return evaluated(expr, values) if expr.has(sp.Integral) else evaluate(expr, values, DIGITS)


def _compared(one: Row, entries: Mapping[str, Entry], case: Case, values: Values) -> list[Any]:
    env = _named(values) | {"g()": _forward(entries, "d", values), "F_N()": _forward(entries, "F", values)}
    env |= environment(read(text), {}) if (text := kappa_row(tuple(entries.values()))) else {}
    statements = read(_holding(one, env).tex)
    env = environment(statements[1:], env)
    first = statements[0].members
    if one.kind == "formula":
        if isinstance(case.expr, sp.Equality):
            wanted = [_value(side, values) for side in (case.expr.lhs, case.expr.rhs)]
            return [_difference(m(env), want) for m, want in zip(first, wanted, strict=True)]
        want = _value(case.expr, values)
        if one.suffix == "pm":
            env["F_N"] = _forward(entries, "F", values)(values[nt.a])
        return [_difference(member(env), want) for member in first[1:]]
    value = evaluate(case.expr, values, DIGITS)  # d(a) or F(a) of the forward formula
    argument, result = {"ad": ("d", "a"), "aF": ("F_N", "a"), "Fd": ("d", "F_N"), "dF": ("F_N", "d")}[one.suffix]
    env[argument] = value
    if one.kind == "root":
        return [_difference(first[0](env), first[1](env))]
    return [_difference(first[1](env), _inverse_value(one.entry, entries, values, argument, value, result))]


def _inverse_value(
    entry: Entry, entries: Mapping[str, Entry], values: Values, argument: str, value: Any, result: str
) -> Any:
    """The closed result at this depth or force, or without one the forward formula at the radius behind it."""
    if entry.status == "closed":
        known = values | {(nt.d if argument == "d" else nt.F): value}
        return evaluate(case_at(entry, known).expr, known, DIGITS)
    outer = entries["F" if result == "F_N" else "d"]
    return evaluate(case_at(outer, values).expr, values, DIGITS)


def _forward(entries: Mapping[str, Entry], suffix: str, values: Values) -> Callable[[Any], Any]:
    """g or F_N as its own printed row gives it."""

    def value(radius: Any) -> Any:
        env = _named(values | {nt.a: radius})
        if text := kappa_row(tuple(entries.values())):
            env |= environment(read(text), {})
        statements = read(_holding(row(entries[suffix]), env).tex)
        return statements[0].members[-1](environment(statements[1:], env))

    return value


def _holding(one: Row, env: Mapping[str, Any]) -> Region:
    """The one region whose printed range contains the point."""
    found = [region for region in one.regions if holds(region.condition, env)]
    if len(found) != 1:
        message = f"{one.key}: {len(found)} printed ranges hold at one point: {[region.condition for region in found]}"
        raise LookupError(message)
    return found[0]


def holds(condition: str, env: Mapping[str, Any]) -> bool:
    """Whether a printed range, chains of < and <= separated by commas, contains the point."""
    for chain in filter(None, condition.split(r",\; ")):
        if re.search(r">|\\ge(?![a-z])", chain):
            chain = "<".join(reversed(re.split(r">|\\ge(?![a-z])", chain)))
        members = [read(part)[0].members[0](env) for part in re.split(r"<|\\le(?![a-z])", chain)]
        if any(lo >= hi for lo, hi in zip(members, members[1:], strict=False)):
            return False
    return True


def _named(values: Values) -> dict[str, Any]:
    """The values under the names their symbols have in print."""
    env: dict[str, Any] = {name_in_print(s): number(values[s]) for s in numeric_symbols(values) if nt.known(s.name)}
    if nt.N in values:
        env["A_j"] = [number(values[coefficient(i)]) for i in range(1, int(values[nt.N]) + 1)]
    return env


def name_in_print(symbol: sp.Symbol) -> str:
    return read(nt.describe(symbol).latex)[0].members[0].name


def _difference(got: Any, want: Any) -> Any:
    return abs(got - want) / abs(want) if want else abs(got)
