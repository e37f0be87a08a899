"""LaTeX of single expressions and entries; the book is made in `handbook`."""

from __future__ import annotations

import sympy as sp

from ..entry import Entry
from .handbook import handbook_sources
from .naming import left_of
from .printer import Printer
from .ranges import condition, regions
from .rows import names_of

__all__ = ["entry_latex", "handbook_sources", "latex"]


def latex(expr: sp.Expr, chain: tuple[sp.Expr, ...] = ()) -> str:
    """An expression as LaTeX; `chain` is the ascending order of lengths that holds for it."""
    return Printer(chain)(expr)


def entry_latex(entry: Entry) -> str:
    """The formula of an entry without shorthands, its cases in a cases environment."""
    found = []
    for pairs, expr in regions(entry):
        chain = next(case.chain for case in entry.cases if case.expr == expr)
        printer = Printer(chain, names_of(entry))
        found.append((printer(expr), condition(entry, pairs, chain, printer)))
    left = "" if isinstance(entry.cases[0].expr, sp.Equality) else left_of(entry).partition("=")[0] + "="
    if len(found) == 1:
        return left + found[0][0]
    return left + r"\begin{cases}" + r" \\ ".join(f"{text}, & {where}" for text, where in found) + r"\end{cases}"
