"""Exact expression -> evaluation form, by rewriting with fixed rules.

Radicals sqrt(x**2 - y**2) become named roots of exact differences, angles
become atan2 of roots, and where terms cancel three rules are tried: conjugates
(X - Y = (X**2 - Y**2)/(X + Y)), the gap functions x - atan(x) and atanh(x) - x,
and ln(X/Y) = log1p((X - Y)/Y).  The form says whether that was enough; which
of the rules an entry is worth is measured (`axicontact study forms`).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import sympy as sp

from .arcs import arc_integrals
from .powers import power_integrals
from .ratios import gamma_ratios
from .rewriting import Rewriting
from .signs import Facts, cancels
from .variants import FULL, Variant


@dataclass(frozen=True)
class EvaluationForm:
    """Named intermediates in order of use, the value, and whether cancellation remains."""

    steps: tuple[tuple[sp.Symbol, sp.Expr], ...]
    value: sp.Expr
    cancels: bool

    def needs(self) -> set[sp.Symbol]:
        """The symbols that must be given."""
        named = {name for name, _ in self.steps}
        used = self.value.free_symbols.union(*(expr.free_symbols for _, expr in self.steps))
        return used - named


@lru_cache(maxsize=2048)
def evaluation_form(expr: sp.Expr, facts: Facts, variant: Variant = FULL) -> EvaluationForm:
    """The form with roots and angles named and, if possible, without cancellation."""
    work = Rewriting(facts, variant)
    value = work.named(work.with_named_ratio(gamma_ratios(arc_integrals(power_integrals(expr)))))
    if cancels(value, work.facts):
        value = work.rewritten(value)
    value = work.with_named_powers(work.with_named_arguments(value))
    value = sp.expand(value) if variant.expanded else value
    steps = work.steps(value)
    loses = not variant.closed and any(cancels(part, work.facts) for part in (value, *(expr for _, expr in steps)))
    return EvaluationForm(steps, value, loses)
