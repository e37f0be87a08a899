"""What a reader of the handbook, or a caller of the module, would see of a false entry."""

from __future__ import annotations

import random
from collections.abc import Mapping
from typing import Any

import mpmath as mp
import sympy as sp

from axiderive import notation as nt
from axiderive.abel.masters import StruveL
from axiderive.entry import Case, Entry
from axiderive.oracle.evaluate import evaluated
from axiderive.oracle.shape import coefficient, concrete

from .entries import (
    SUMMED,
    FalseEntry,
    known,
)

# what a reader would see

DIGITS = 15
TRIALS = 15
FAR = mp.mpf(10) ** -9


def difference(found: FalseEntry) -> str:
    """How the false entry can be told from the true one without a proof; empty if it cannot."""
    true, false = found.true, found.false
    told = ("key", "quantity", "status", "definition", "parameters", "composed", "partial")
    for name in told:
        if getattr(true, name) != getattr(false, name):
            return f"{name}: {getattr(false, name)}"
    named = set().union(*(case.expr.free_symbols for case in false.cases)) - known(true)
    unknown = sorted(str(name) for name in named if name.is_Symbol and name not in SUMMED)
    if unknown:
        return f"it names {', '.join(unknown)}, which is neither argument nor parameter"
    relations = [type(case.expr) for case in false.cases if case.expr.is_Relational]
    if any(relation is not sp.Equality for relation in relations):
        return "it is no equation"
    return _different_value(true, false)


def _different_value(true: Entry, false: Entry) -> str:
    names = known(true) | known(false)
    for case in (*false.cases, *true.cases):
        for trial in range(TRIALS):
            values = sample(case, true, names, trial)
            if values is None:
                continue
            here, there = _said(true, values), _said(false, values)
            if here is None or (here == [] and there == []):
                continue
            if there is None or len(_distinct(here)) != len(_distinct(there)) or _apart(here, there):
                point = ", ".join(f"{symbol} = {value}" for symbol, value in values.items())
                return f"at {point} it says {_shown(there)} instead of {_shown(here)}"
    return ""


def _shown(said: list[Any] | None) -> str:
    return "nothing real" if said is None else ", ".join(mp.nstr(x, 6) for x in said) or "nothing"


def _distinct(said: list[Any]) -> list[Any]:
    return [x for i, x in enumerate(said) if all(abs(x - y) > FAR * (abs(x) + abs(y)) for y in said[:i])]


def _apart(here: list[Any], there: list[Any]) -> bool:
    return any(min(abs(x - y) - FAR * (abs(x) + abs(y)) for y in here) > 0 for x in there)


def _said(entry: Entry, values: Mapping[sp.Symbol, sp.Expr]) -> list[Any] | None:
    """The values of all cases whose condition holds there, of equations lhs - rhs; None if one is not real."""
    said = []
    with mp.workdps(DIGITS):
        for case in entry.cases:
            if not _holds(case, values):
                continue
            sides = case.expr.args if isinstance(case.expr, sp.Equality) else (case.expr, sp.S.Zero)
            left, right = (_real(side, values) for side in sides)
            if left is None or right is None:
                return None
            said.append(left - right)
    return said


def _holds(case: Case, values: Mapping[sp.Symbol, sp.Expr]) -> bool:
    members = [evaluated(sp.sympify(member), values) for member in case.chain]
    return all(low < high for low, high in zip(members, members[1:], strict=False))


def _real(expr: sp.Expr, values: Mapping[sp.Symbol, sp.Expr]) -> Any:
    """The value, if it and every root, logarithm and inverse function in it are real and finite."""
    expr = sp.sympify(expr)
    if expr.has(sp.Subs, sp.oo) or any(_without_value(total) for total in expr.atoms(sp.Sum)):
        return None
    expr = concrete(expr, values)
    inner = [node for node in expr.atoms(sp.asin, sp.acos, sp.acosh, sp.atanh, sp.log, sp.exp, sp.besseli, StruveL)]
    inner += [node for node in expr.atoms(sp.Pow) if not node.exp.is_Integer and not node.base.is_Symbol]
    try:
        for node in (*inner, expr):
            value = mp.mpmathify(evaluated(node, values))
            if not mp.isfinite(value) or abs(mp.im(value)) > FAR * abs(value):
                return None
    except Exception:  # a pole, a function that no real number is in the range of, or one that nothing evaluates
        return None
    return mp.re(value)


def _without_value(total: sp.Sum) -> bool:
    """Whether a term of the sum is 0/0 as it stands."""
    return any(total.function.subs(nt.j, index).has(sp.nan, sp.zoo) for index in (1, 2, 3))


RANGES: dict[sp.Symbol, tuple[sp.Rational, sp.Rational]] = {
    symbol: (sp.Rational(low), sp.Rational(high))
    for symbols, low, high in (
        ((nt.theta,), "1/10", "7/5"),
        ((nt.k,), "-4/5", "4/5"),
        ((nt.n,), "6/5", "4"),
        ((nt.alpha,), "1/10", "9/10"),
        ((nt.nu, nt.nu_1, nt.nu_2), "-9/10", "9/20"),
        ((nt.sigma,), "-2/5", "2"),
        ((nt.mu,), "1/10", "2"),
        ((nt.e,), "-1", "1"),
        ((nt.F, nt.P), "1/10", "40"),
        ((nt.F_x,), "1/50", "2"),
    )
    for symbol in symbols
}
USUAL = (sp.Rational(1, 5), sp.Rational(3))


def sample(case: Case, true: Entry, names: set[sp.Symbol], trial: int) -> dict[sp.Symbol, sp.Expr] | None:
    """A point where the case holds and the profile exists; None if the draw missed it."""
    draw = random.Random(trial)
    members = [member for member in case.chain if sp.sympify(member).is_Symbol]
    wanted = names | {symbol for member in case.chain for symbol in sp.sympify(member).free_symbols}
    wanted |= {symbol for member in (*true.profile.chain, *true.profile.breaks[:1]) for symbol in member.free_symbols}
    values: dict[sp.Symbol, sp.Expr] = {}
    if true.profile.name == "polynomial":
        values = {nt.N: sp.Integer(3), **{coefficient(i): sp.Rational(i, 2 + trial) for i in range(1, 7)}}
    for symbol in sorted(wanted - set(SUMMED), key=lambda s: (str(s), sp.srepr(s))):
        low, high = RANGES.get(symbol, USUAL)
        share = sp.Rational(draw.randint(1, 999), 1000)
        values[symbol] = low + (high - low) * share
        if trial % 3 == 2 and symbol not in RANGES:  # a rough point, where poles lie
            values[symbol] = sp.Rational(draw.choice((1, 1, 2, 4)), 2)
    chain = [*members, *(s for s in true.profile.chain if s.is_Symbol and s not in members)]
    values.update(zip(chain, sorted(values[s] for s in chain), strict=True))
    if nt.e in values and nt.a in values:
        values[nt.e] *= values[nt.a] if trial % 5 != 4 else 0  # a load in the middle, too
        if nt.x in values:
            values[nt.x] = values[nt.a] * sp.Rational(draw.randint(-999, 999), 1000)
    values |= {symbol: expr.subs(values) for symbol, expr in true.profile.abbreviations if symbol in wanted}
    floor = true.profile.breaks[:1] if true.profile.truncated else ()
    exists = [Case(true.profile.chain, sp.S.Zero), Case((*floor, nt.a) if nt.a in values else (), sp.S.Zero)]
    with mp.workdps(DIGITS):
        return values if all(_holds(region, values) for region in (case, *exists)) else None
