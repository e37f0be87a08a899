"""Formulas of the plane problem as code, and bounds of their slopes.

Formulas of the plane problem as code: closed forms by region, with the names of their roots kept apart.

Bounds of the logarithmic slope of the load, from the exact formula: what makes Newton's bracket sure.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache

import mpmath as mp
import sympy as sp

from ...abel.masters import IncompleteBeta
from ...entry import Case, Entry
from ...notation import E_star, L, a, n, r, x
from ...stable.forms import EvaluationForm, plane_form
from ...stable.opaque import PowerPunches, PowerStrips, Root, named
from ...stable.signs import facts_of
from ...stable.variants import FULL, Variant
from ..example import NUMERIC
from ..private import PrivateFunctions
from ..text import printable


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


DECADES = range(-24, 25)


@cache
def exponents(entry: Entry) -> tuple[str, str]:
    """Whole numbers between which d ln P/d ln t lies; a = t, and a = b sqrt(1 + t^2) over a flat face of half-width b.

    The parameters of the sketch stand for all: P is a length scale times a function of a/b.
    """
    values = {symbol: sp.Rational(str(value)) for symbol, value in entry.profile.sketch.values} | {E_star: sp.S.One}
    (b,) = entry.profile.breaks
    t = sp.Dummy("t", positive=True)
    half_width = b * sp.sqrt(1 + t**2) if entry.profile.truncated else t * b
    slopes = []
    with mp.workdps(60):
        for case in entry.cases:
            load = case.expr.subs(a, half_width)
            slope = sp.lambdify(t, (t * sp.diff(load, t) / load).subs(values), NUMERIC)
            for k in DECADES:
                point = mp.mpf(10) ** (mp.mpf(k) / 4)
                if entry.profile.truncated or (point < 1 if case.below(a, b) else point > 1):
                    slopes.append(mp.re(slope(point)))
    return f"{math.floor(min(slopes) + mp.mpf('1e-6'))}.0", f"{math.ceil(max(slopes) - mp.mpf('1e-6'))}.0"
