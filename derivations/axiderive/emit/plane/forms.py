"""Formulas of the plane problem as code: closed forms by region, with the names of their roots kept apart."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ...abel.masters import IncompleteBeta
from ...entry import Case, Entry
from ...notation import L, a, n, r, x
from ...stable.conjugates import plane_form
from ...stable.forms import EvaluationForm
from ...stable.opaque import PowerPunches, PowerStrips, Root, named
from ...stable.signs import facts_of
from ...stable.variants import FULL, Variant
from ..code import printable
from ..private import PrivateFunctions


@dataclass(frozen=True)
class Region:
    """A closed form and the comparisons low < high that single it out."""

    comparisons: tuple[tuple[sp.Expr, sp.Expr], ...]
    form: EvaluationForm


def regions(entry: Entry, variant: Variant = FULL) -> tuple[Region, ...]:
    """The distinct formulas of an entry as evaluation forms; those that are roots of an equation are not asked for."""
    first = {case.expr: case for case in reversed(entry.cases)}
    return tuple(Region(comparisons, form_of(first[expr], variant)) for comparisons, expr in entry.regions())


def form_of(case: Case, variant: Variant = FULL) -> EvaluationForm:
    """The evaluation form of a case in a variant; by all rules where NumPy lacks a function of that."""
    form = _form_of(case, variant)
    return form if printable(form) else _form_of(case, FULL)


def _form_of(case: Case, variant: Variant) -> EvaluationForm:
    """Incomplete Beta functions as integrals over the growing contact."""
    lengths = case.chain if all(length.is_Symbol for length in case.chain) else ()
    point = L if case.expr.has(L) else x
    if not case.expr.has(IncompleteBeta):
        return plane_form(case.expr, facts_of(lengths), variant)
    in_r = case.expr.subs(point, r)
    facts = facts_of(tuple(r if length == point else length for length in lengths))
    form = plane_form(in_r, facts, variant)
    steps = tuple((name, strips(expr).subs(r, point)) for name, expr in form.steps)
    return EvaluationForm(steps, strips(form.value).subs(r, point), form.cancels)


def strips(expr: sp.Expr) -> sp.Expr:
    """Integrals of t^(n-1) through the function that stays exact for small n."""
    expr = expr.subs(PowerPunches(r, a, n - 1), a / n * PowerStrips(r, a, n))
    return sp.factor_terms(sp.Add(*(sp.powsimp(term) for term in sp.Add.make_args(sp.expand(expr)))))


def moved(form: EvaluationForm, old: sp.Symbol, new: str) -> EvaluationForm:
    """The form at another value of a length."""
    symbol = sp.Symbol(new, positive=True)
    steps = tuple((name, expr.subs(old, symbol)) for name, expr in form.steps)
    return EvaluationForm(steps, form.value.subs(old, symbol), form.cancels)


def told_apart(forms: tuple[EvaluationForm, ...]) -> tuple[EvaluationForm, ...]:
    """The forms with a root of the same name but another meaning named after its lengths."""
    taken: dict[sp.Symbol, sp.Expr] = {}
    out = []
    for form in forms:
        renamed = {
            name: named("root_" + "".join(map(str, expr.args)))
            for name, expr in form.steps
            if isinstance(expr, Root) and taken.setdefault(name, expr) != expr
        }
        steps = tuple((renamed.get(name, name), expr.subs(renamed)) for name, expr in form.steps)
        out.append(EvaluationForm(steps, form.value.subs(renamed), form.cancels))
    return tuple(out)


def lines_of(functions: PrivateFunctions, name: str, form: EvaluationForm, lines: list[str]) -> None:
    """Append the steps that are not there yet, and `name = value`."""
    for line in functions.steps(form):
        if line not in lines:
            lines.append(line)
    lines.append(f"{name} = {functions.value_lines(form.value, lines)}")
