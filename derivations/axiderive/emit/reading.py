"""Every printed row against the entry it was printed from, through its LaTeX source alone."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Case, Entry
from ..proof.evaluate import case_at, decades, evaluate
from ..proof.evaluate import holds as holds_at
from ..proof.sampling import points
from ..proof.shape import number
from . import laws
from .printed import Printed, holding, holds, name_in_print
from .readback import environment, read
from .rows import Row, row, system_of
from .values import evaluated

__all__ = ["holds", "name_in_print", "worst_residual"]

Values = dict[Any, Any]
Entries = Mapping[str, Entry]
WORKING = 60
DIGITS = 30
INTEGRATING = 34
"""Working digits of a row that integrates a derivative."""


def worst_residual(one: Row, entries: Entries, count: int = 3, seed: int = 17, base: Entries | None = None) -> Any:
    """Largest relative difference between the printed row and its entry over random points of every case.

    `base` are the entries of the normal contact on the same medium, which the rules refer to.

    Raises
    ------
    SyntaxError, KeyError
        If the source cannot be read, or uses what it does not define.
    """
    base = entries if base is None else base
    residuals = []
    for entry in (one.entry, *one.also):
        for case, values in _points(entry, one.kind, entries, count, seed):
            # a displacement far outside leaves a^7/r of terms of the size of r^5 a
            with mp.workdps(INTEGRATING if integrates(one, base) else WORKING + 10 * decades(values)):
                residuals += _compared(one, entry, Printed(entries, base), case, values)
    return max(residuals)


def integrates(one: Row, base: Entries) -> bool:
    """Whether reading the row back integrates the derivative of another one, which takes seconds."""
    needed = {"p": "p", "tau": "p", "w": "w"}.get(one.suffix)
    if one.kind != "rule" or needed is None or needed not in base:
        return False
    own = row(base[needed])
    return own.kind == "rule" or base[needed].status == "integral"


def _points(entry: Entry, kind: str, entries: Entries, count: int, seed: int) -> list[tuple[Case, Values]]:
    """Points of every case; an inverse without a formula is met where its forward formula leads."""
    source = entry
    if kind in ("root", "composition"):
        source = entries[{"ad": "d", "Fd": "d", "aP": "P"}.get(entry.suffix, "F")]
    drawn = [
        (case, points(entry.profile, _lengths(case), count, seed, _fields(entry, source, case)))
        for case in source.cases
    ]
    return [(case, _completed(entry, case, point.values)) for case, found in drawn for point in found]


def _lengths(case: Case) -> tuple[sp.Expr, ...]:
    """The chain to draw from; numbers around an exponent and the side of a load are seen to afterwards."""
    return () if any(x.is_number or x.has(sp.Abs, nt.k) for x in case.chain) else case.chain


def _grading(case: Case) -> sp.Rational:
    """The exponent of the half space; below zero the integrals across a break converge too slowly to be read back."""
    return EXPONENT_OF_GRADING[len(case.chain) % 2 if not case.expr.has(sp.Integral) else 0]


SEPARATE = {nt.k, nt.e, nt.E_star, nt.n}
"""Symbols that are not drawn as lengths or stresses are."""
EXPONENT_OF_GRADING = (sp.Rational(3, 5), sp.Rational(-2, 5))
POISSON = sp.Rational(2, 7)
STABLE_EXPONENT = sp.Rational(17, 10)


def _fields(entry: Entry, source: Entry, case: Case) -> tuple[sp.Symbol, ...]:
    lengths = {s for x in case.chain for s in x.free_symbols}
    own = {*source.quantity.arguments, *source.parameters, *entry.parameters, *case.expr.free_symbols, *lengths}
    own -= {nt.F, nt.d} if source is not entry else set()
    fixed = {*entry.profile.parameters, *SEPARATE, nt.coefficients, nt.j, nt.N}
    integrated = {integral.limits[0][0] for integral in case.expr.atoms(sp.Integral)}
    return tuple(s for s in sorted(own - fixed - integrated, key=str) if isinstance(s, sp.Symbol))


def _completed(entry: Entry, case: Case, values: Values) -> Values:
    """What a chain of lengths cannot say: exponents, the side of an eccentric load, a place inside the contact."""
    fixed = dict(values)
    system = system_of(entry)
    if nt.k in entry.parameters:
        fixed[nt.k] = _grading(case)
    fixed |= {ratio: POISSON for ratio in (nt.nu, nt.nu_1, nt.nu_2) if ratio in fixed}
    fixed |= {symbol: expr.xreplace(fixed) for symbol, expr in entry.profile.abbreviations if expr.has(nt.k)}
    fixed = {symbol: value for symbol, value in fixed.items() if not sp.sympify(value).free_symbols}
    if nt.alpha in fixed:
        fixed[nt.alpha] = sp.Rational(2, 5)
    if nt.n in fixed and system.endswith(("adhesive", "tangential", "viscoelastic")):
        fixed[nt.n] = STABLE_EXPONENT
    for i, x in enumerate(case.chain):
        if x.is_Symbol and i and not (low := case.chain[i - 1].xreplace(fixed)).free_symbols and x == nt.n:
            room = case.chain[i + 1] - low if i + 1 < len(case.chain) else sp.Integer(3)
            fixed[x] = low + room * sp.Rational(3, 7)
    for ring in (nt.r_zero, nt.x_zero):
        if ring in fixed:
            fixed[ring] = fixed[nt.a] * sp.Rational(7, 11)
    if nt.F_x in fixed and nt.F in fixed:
        fixed[nt.F_x] = fixed[nt.F] * fixed[nt.mu] * sp.Rational(3, 7)
    if any(x.has(nt.k) and not x.is_Symbol for x in case.chain) and nt.n not in fixed:
        return _moved_into(case, fixed)
    if nt.e in entry.profile.parameters:
        fixed[nt.e] = -fixed[nt.a] * sp.Rational(*((2, 7) if case.chain[0] != nt.a / 2 else (5, 7)))
        fixed[nt.x] = -fixed[nt.a] * sp.Rational(8, 9)
    return fixed


def _moved_into(case: Case, values: Values) -> Values:
    """A depth or force, and a radius, that lie in the region; its border has no inverse in closed form."""
    load = next(s for s in (nt.F, nt.d) if s in values)
    for power, share in itertools.product(
        range(-6, 7), (sp.Rational(1, 9), sp.Rational(8, 9), sp.Integer(2), sp.Integer(9))
    ):
        moved = {**values, load: values[load] * sp.Integer(4) ** power}
        if nt.r in values:
            moved[nt.r] = values[nt.a] * share
        if holds_at(case, moved):
            return moved
    message = f"no point found in {case.chain}"
    raise LookupError(message)


def _value(expr: sp.Expr, values: Values) -> Any:
    return evaluated(expr, values) if expr.has(sp.Integral) else evaluate(expr, values, DIGITS)


def _slipping(printed: Printed, values: Values) -> Values:
    """A tangential force between full stick and full slip under the force that the outer radius belongs to."""
    force = evaluate(case_at(printed.base["F"], values).expr, values, DIGITS + 15)
    return values | {nt.F: force, nt.F_x: force * number(values[nt.mu]) * 3 / 7}


def _compared(one: Row, entry: Entry, printed: Printed, case: Case, values: Values) -> list[Any]:
    if entry.suffix == "c":
        values = _slipping(printed, values)
    if one.kind == "formula":
        return _formula(one, printed, case, values)
    if one.kind == "rule":
        return _rule(one, entry, printed, case, values)
    return _inverse(one, printed, case, values)


def _formula(one: Row, printed: Printed, case: Case, values: Values) -> list[Any]:
    env = printed.environment(values)
    statements = read(holding(one, env).tex)
    env = environment(statements[1:], env)
    first = statements[0].members
    if isinstance(case.expr, sp.Equality):
        wanted = [_value(side, values) for side in (case.expr.lhs, case.expr.rhs)]
        return [_difference(m(env), want) for m, want in zip(first, wanted, strict=True)]
    if one.suffix == "pm":
        env["F_N"] = env["F_N()"](env["a"])
    want = _value(case.expr, values)
    return [_difference(member(env), want) for member in first[1:]]


def _inverse(one: Row, printed: Printed, case: Case, values: Values) -> list[Any]:
    """An equation to be solved, or a composition, at the value its forward formula takes."""
    env = printed.environment(values)
    first = read(one.regions[0].tex)[0].members
    value = evaluate(case.expr, values, DIGITS)
    argument, result = {
        "ad": ("d", "a"), "aF": ("F_N", "a"), "Fd": ("d", "F_N"), "dF": ("F_N", "d"), "aP": ("P", "a"),
    }[one.suffix]  # fmt: skip
    env[argument] = value
    if one.kind == "root":
        return [_difference(first[0](env), first[1](env))]
    return [_difference(first[1](env), _inverse_value(one.entry, printed.entries, values, argument, value, result))]


def _inverse_value(entry: Entry, entries: Entries, values: Values, argument: str, value: Any, result: str) -> Any:
    """The closed result at this depth or force, or without one the forward formula at the radius behind it."""
    if entry.status == "closed":
        known = values | {(nt.d if argument == "d" else nt.F): value}
        return evaluate(case_at(entry, known).expr, known, DIGITS)
    outer = entries["F" if result == "F_N" else "d"]
    return evaluate(case_at(outer, values).expr, values, DIGITS)


LOADED = {"ad": nt.d, "aF": nt.F, "c": nt.F_x}
"""What balances an equation of equilibrium at any radius."""


def _rule(one: Row, entry: Entry, printed: Printed, case: Case, values: Values) -> list[Any]:
    values = dict(values)
    system = system_of(entry)
    if system == "viscoelastic":
        return _law(one, entry, printed, case, values)
    statements = read(one.regions[0].tex)
    if entry.suffix in LOADED or entry.suffix in ("ac", "am"):
        _balance(entry, case, values)
        env = printed.environment(values)
        left, right = (member(env) for member in statements[0].members)
        return [_difference(left, right)]
    if system.endswith("adhesive") and entry.suffix[-1] in "cm":
        _pull_off(entry, printed.entries, case, values)
    env = printed.environment(values)
    want = _value(case.expr, values)
    return [_difference(statements[0].members[-1](environment(statements[1:], env)), want)]


def _balance(entry: Entry, case: Case, values: Values) -> None:
    """The unknown takes its closed value, or the load the value that goes with the unknown."""
    unknown = {"c": nt.c}.get(entry.suffix, nt.a_c)
    if not isinstance(case.expr, sp.Equality):
        values[unknown] = evaluate(case.expr, values, DIGITS + 15)
        return
    left = evaluate(case.expr.lhs, values, DIGITS + 15)
    if entry.suffix in LOADED:
        values[LOADED[entry.suffix]] = left
        return
    level = evaluate(case.expr.rhs, values, DIGITS + 15)
    values[nt.dgamma] = values[nt.dgamma] * (left / level) ** 2


def _pull_off(entry: Entry, entries: Entries, case: Case, values: Values) -> None:
    """Radius and work of separation that belong together at pull-off."""
    radius = entries["a" + entry.suffix[-1]]
    if radius.status == "closed":
        values[nt.a_c] = evaluate(radius.cases[0].expr, values, DIGITS + 15)
        return
    own = next(other for other in radius.cases if other.chain == case.chain)
    _balance(radius, own, values)


def _law(one: Row, entry: Entry, printed: Printed, case: Case, values: Values) -> list[Any]:
    """A row of a viscoelastic contact with the printed functions of one law put in."""
    law = next(law for law in laws.laws() if entry.suffix.endswith("_" + law.suffix))
    if entry.suffix.startswith("load") and isinstance(case.expr, sp.Equality):
        values[nt.F] = values[nt.F] * evaluate(case.expr.lhs, values, DIGITS) / evaluate(case.expr.rhs, values, DIGITS)
    values[nt.E_star] = sp.Integer(3)
    if nt.a not in values and entry.suffix.startswith("step") and "ad" in printed.base:
        values[nt.a] = evaluate(case_at(printed.base["ad"], values).expr, values, DIGITS + 15)
    env = printed.environment(values)
    statements = read(one.regions[0].tex)
    env = environment(statements[1:], env)
    env |= {name: _function(text, env) for name, text in law.functions().items()}
    first = statements[0].members
    if entry.suffix.startswith("load") and isinstance(case.expr, sp.Equality):
        return [_difference(first[0](env), first[1](env))]
    expr = case.expr.rhs if isinstance(case.expr, sp.Equality) else case.expr
    if "Fd" not in printed.base:
        env["F_N()"] = lambda depth: printed.at("F", values | {nt.d: depth})
    return [_difference(first[-1](env), _value(expr, values))]


def _function(text: str, env: Mapping[str, Any]) -> Any:
    body = read(text)[0].members[-1]
    return lambda t: body({**env, "t": t})


def _difference(got: Any, want: Any) -> Any:
    return abs(got - want) / abs(want) if want else abs(got)
