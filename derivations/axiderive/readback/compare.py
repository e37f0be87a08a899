"""Every printed row against the entry it was printed from, through its LaTeX source alone."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Case, Entry
from ..oracle.evaluate import case_at, decades, evaluate
from ..oracle.shape import number
from ..oracle.values import evaluated
from ..physics.systems import of
from ..rows import laws
from ..rows.in_print import texts_of
from ..rows.points import points_of
from ..rows.row import Row, row
from .grammar import read
from .meaning import Node, environment
from .printed import Printed, bound, holding, name_of

Values = dict[Any, Any]
Entries = Mapping[str, Entry]
WORKING = 60
DIGITS = 30
INTEGRATING = 38
"""Working digits of a row that is an integral, or refers to one."""


def worst_residual(one: Row, entries: Entries, count: int = 3, seed: int = 17, base: Entries | None = None) -> Any:
    """Largest relative difference between the printed row and its entry over random points of every case.

    `base` are the entries of the normal contact on the same medium, which the rules refer to.

    Raises
    ------
    SyntaxError, KeyError
        If the source cannot be read, or uses what it does not define.
    """
    return max(residuals(one, entries, count, seed, base))


def residuals(one: Row, entries: Entries, count: int = 3, seed: int = 17, base: Entries | None = None) -> Iterator[Any]:
    """The relative differences one after the other."""
    base = entries if base is None else base
    if one.parts:
        yield from _parts(one, entries, count, seed, base)
        return
    printed = Printed(entries, base)
    for entry in (one.entry, *one.also):
        for case, values in points_of(entry, one.kind, entries, count, seed):
            # a displacement far outside leaves a^7/r of terms of the size of r^5 a
            with mp.workdps(INTEGRATING if integrates(one, base) else WORKING + 10 * decades(values)):
                yield from _compared(one, entry, printed, case, values)


def _parts(one: Row, entries: Entries, count: int, seed: int, base: Entries) -> Iterator[Any]:
    """Every formula of a row of several as the row of its own that it stands for."""
    for part, text in zip(one.parts, texts_of(one.regions[0].tex), strict=True):
        own = replace(part, regions=(replace(part.regions[0], lines=(text,)),))
        yield from residuals(own, entries, count, seed, base)


def integrates(one: Row, base: Entries) -> bool:
    """Whether reading the row back takes a quadrature, of its own or in a row that it refers to."""
    needed = {"p": "p", "tau": "p", "w": "w"}.get(one.suffix)
    rows = [one, row(base[needed])] if needed and needed in base else [one]
    return any(r"\int" in region.tex for own in rows for region in own.regions)


def value_of(expr: sp.Expr, values: Values) -> Any:
    """The value at a point: integrals by quadrature, all else evaluated to 30 digits."""
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
    if one.kind == "definition":
        return _definition(one, printed, case, values)
    return _inverse(one, printed, case, values)


def _environment(entry: Entry, printed: Printed, values: Values) -> dict[str, Any]:
    """The names a row may use; of the two radii of pull-off only that of its own control."""
    env = printed.environment(values)
    other = {"c": "a_m", "m": "a_c"}.get(entry.suffix[-1]) if of(entry).physics.tension else None
    env.pop(other or "", None)
    return env


def _formula(one: Row, printed: Printed, case: Case, values: Values) -> list[Any]:
    env = _environment(one.entry, printed, values)
    statements = read(holding(one, env).tex)
    env = environment(statements[1:], env)
    first = statements[0].members
    if isinstance(case.expr, sp.Equality):
        wanted = [value_of(side, values) for side in (case.expr.lhs, case.expr.rhs)]
        return [difference(m(env), want) for m, want in zip(first, wanted, strict=True)]
    if one.suffix == "pm":
        env["F_N"] = env["F_N()"](env["a"])
    return _stated(first, env, one.entry, value_of(case.expr, values))


def _definition(one: Row, printed: Printed, case: Case, values: Values) -> list[Any]:
    """An equation about an elastic constant, and about another one that it may be stated with."""
    own = bound(name_of(one.entry), value_of(case.expr, values), _environment(one.entry, printed, values))
    if one.uses:
        other = printed.entries[one.uses]
        own = bound(name_of(other), value_of(other.cases[0].expr, values), own)
    first = read(one.regions[0].tex)[0].members
    return [difference(first[0](own), first[1](own))]


def _stated(members: Sequence[Node], env: Mapping[str, Any], entry: Entry, want: Any) -> list[Any]:
    """The members of left = ... = right: the first is the quantity itself, and the others are its value."""
    own = bound(name_of(entry), want, env)
    return [difference(members[0](own), want), *(difference(member(env), want) for member in members[1:])]


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
        return [difference(first[0](env), first[1](env))]
    want = _inverse_value(one.entry, printed.entries, values, argument, value, result)
    return _stated(first, env, one.entry, want)


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
    physics = of(entry).physics
    if physics.laws:
        return _law(one, entry, printed, case, values)
    statements = read(one.regions[0].tex)
    if entry.suffix in LOADED or entry.suffix in ("ac", "am"):
        balance(entry, case, values)
        env = _environment(entry, printed, values)
        left, right = (member(env) for member in statements[0].members)
        return [difference(left, right)]
    if physics.tension and entry.suffix[-1] in "cm":
        _pull_off(entry, printed.entries, case, values)
    env = _environment(entry, printed, values)
    want = value_of(case.expr, values)
    return _stated(statements[0].members, environment(statements[1:], env), entry, want)


def balance(entry: Entry, case: Case, values: Values) -> None:
    """The unknown takes its closed value, or the load the value that goes with the unknown."""
    unknown = {"c": nt.c, "ad": nt.a, "aF": nt.a}.get(entry.suffix, nt.a_c)
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
    balance(radius, own, values)


def _law(one: Row, entry: Entry, printed: Printed, case: Case, values: Values) -> list[Any]:
    """A row of a viscoelastic contact with the printed functions of one law put in."""
    law = next(law for law in laws.laws() if entry.suffix.endswith("_" + law.suffix))
    if entry.suffix.startswith("load") and isinstance(case.expr, sp.Equality):
        values[nt.F] = values[nt.F] * evaluate(case.expr.lhs, values, DIGITS) / evaluate(case.expr.rhs, values, DIGITS)
    values[nt.E_star] = sp.Integer(3)
    if nt.a not in values and entry.suffix.startswith("step") and "ad" in printed.base:
        values[nt.a] = evaluate(case_at(printed.base["ad"], values).expr, values, DIGITS + 15)
    env = _environment(entry, printed, values)
    statements = read(one.regions[0].tex)
    env = environment(statements[1:], env)
    env |= {name: _function(text, env) for name, text in law.functions().items()}
    first = statements[0].members
    if entry.suffix.startswith("load") and isinstance(case.expr, sp.Equality):
        return [difference(first[0](env), first[1](env))]
    expr = case.expr.rhs if isinstance(case.expr, sp.Equality) else case.expr
    if "Fd" not in printed.base:
        env["F_N()"] = lambda depth: printed.at("F", {**env, "d": depth})
    return _stated(first, env, one.entry, value_of(expr, values))


def _function(text: str, env: Mapping[str, Any]) -> Any:
    body = read(text)[0].members[-1]
    return lambda t: body({**env, "t": t})


def difference(got: Any, want: Any) -> Any:
    """Relative difference of two values; absolute where the wanted one is zero."""
    return abs(got - want) / abs(want) if want else abs(got)
