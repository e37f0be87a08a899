"""Single formulas as LaTeX, for scripts and for Jupyter.

LaTeX of single expressions and entries; the book is made in `handbook`.

Entries in Jupyter, which show their formulas as the handbook prints them.
"""

from __future__ import annotations

import sympy as sp

from ..entry import Entry
from ..print.formula import Printer
from ..rows.ranges import condition, regions
from ..rows.row import names_of, row
from .handbook import handbook_sources

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
    left = "" if isinstance(entry.cases[0].expr, sp.Equality) else entry.quantity.left.partition("=")[0] + "="
    if len(found) == 1:
        return left + found[0][0]
    return left + r"\begin{cases}" + r" \\ ".join(f"{text}, & {where}" for text, where in found) + r"\end{cases}"


def markdown(entry: Entry) -> str:
    """Key, label and formula of an entry, its ranges line by line, for Markdown with LaTeX."""
    lines = [f"`{entry.key}` {entry.quantity.label}"]
    found = row(entry)
    for region in found.regions:
        formula = region.tex.replace(r"\begin{aligned}[t]", r"\begin{aligned}")
        where = rf"\qquad {region.condition}" if region.condition else ""
        lines.append(rf"$\displaystyle {formula}{where}$")
    if found.remark:
        behind = f" `{entry.key.removesuffix(entry.suffix)}{found.uses}`" if found.uses else ""
        lines.append(found.remark + behind)
    return "\n\n".join(lines)
