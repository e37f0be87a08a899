"""The range in which each formula of an entry holds, as it is printed."""

from __future__ import annotations

import itertools

import sympy as sp

from ..entry import Entry
from ..notation import F, L, a, d, e, n, r, x
from ..print.box import bracket
from ..print.formula import Printer

Pairs = tuple[tuple[sp.Expr, sp.Expr], ...]
"""Comparisons low < high."""


def regions(entry: Entry) -> tuple[tuple[Pairs, sp.Expr], ...]:
    """As `Entry.regions`, with the whole chain where the cases do not compare the same lengths.

    What is zero beyond a place, as the pressure below a lifted edge, is two formulas.
    """
    lengths = {frozenset(case.chain) for case in entry.cases}
    if len(lengths) == 1 or len(entry.cases) == 1:
        found = entry.regions()
    else:
        found = tuple((tuple(zip(case.chain, case.chain[1:], strict=False)), case.expr) for case in entry.cases)
    return tuple(side for pairs, expr in found for side in _sides(pairs, expr))


def _sides(pairs: Pairs, expr: sp.Expr) -> tuple[tuple[Pairs, sp.Expr], ...]:
    """A formula on either side of the place at which its max(0, ...) begins, in the order of the figure."""
    tops = positive_parts(expr)
    if not tops:
        return ((pairs, expr),)
    ((top, value),) = tops.items()
    rest, place = value.as_independent(x, as_Add=True)
    return (
        ((*pairs, (-rest, place)), expr.xreplace({top: value})),
        ((*pairs, (place, -rest)), expr.xreplace({top: sp.S.Zero})),
    )


def positive_parts(expr: sp.Expr) -> dict[sp.Expr, sp.Expr]:
    """Every max(0, u) of a formula, and its u."""
    return {top: next(u for u in top.args if u != 0) for top in expr.atoms(sp.Max) if 0 in top.args}


def chain_of(entry: Entry, expr: sp.Expr) -> tuple[sp.Expr, ...]:
    """The ascending lengths of the case that a formula of the entry belongs to; StopIteration if none has it."""
    return next(case.chain for case in entry.cases if any(expr == own for _, own in _sides((), case.expr)))


def condition(entry: Entry, pairs: Pairs, chain: tuple[sp.Expr, ...], printer: Printer) -> str:
    """The range in print: r <= a for the pressure, a <= r outside, and what tells the cases apart."""
    own = _own_range(entry, chain)
    loose = [pair for pair in own if not _implied(pair, (*pairs, *_always(entry)))]
    steps = [*pairs, *loose]
    if not steps:
        return ""
    if len(steps) == 1 and (steps[0][1] in (r, x, d, F, n) or steps[0][1].has(e)):  # the variable stands on the left
        ((low, high),) = steps
        sign = r"\ge" if steps[0] in own else ">"
        return f"{_flat(high, printer)}{sign} {_flat(low, printer)}"
    ascending = _as_chain(steps)
    signs = {pair: r"\le" if pair in own or pair[1] in entry.borders else "<" for pair in steps}

    def text(length: sp.Expr) -> str:
        return _flat(length, printer)

    if ascending is None:
        return ",\\; \\allowbreak ".join(f"{text(lo)}{signs[lo, hi]} {text(hi)}" for lo, hi in steps)
    out = text(ascending[0])
    for lo, hi in zip(ascending, ascending[1:], strict=False):
        out += f"{signs[lo, hi]} {text(hi)}"
    return out


def _flat(expr: sp.Expr, printer: Printer) -> str:
    """A length as it stands in the grey under a label, without a built-up fraction: a/2."""
    above, below = sp.fraction(sp.together(expr))
    if below == 1:
        return printer.small(expr)
    divisor = printer.small(below)
    # a range that is too long for the column ends its line behind the solidus, and not within the bracket
    return f"{printer.small(above)}/" + (rf"\allowbreak {{{bracket(divisor)}}}" if below.is_Mul else divisor)


def _always(entry: Entry) -> Pairs:
    """Comparisons of lengths other than the place that hold in every case: b < a for a truncated cone."""
    shared = [set(itertools.combinations([y for y in case.chain if y not in (r, x, L)], 2)) for case in entry.cases]
    return tuple(set.intersection(*shared)) if shared else ()


def _own_range(entry: Entry, chain: tuple[sp.Expr, ...]) -> Pairs:
    """Inside or outside the contact, whose radius is an expression as long as a complete contact is still partial."""
    if entry.profile.contact == "prescribed":
        return ()
    radius = next((y for y in chain if not y.is_Symbol and a in chain and chain.index(y) < chain.index(a)), a)
    place = next((s for s in entry.quantity.arguments if s in (r, x)), r)
    if e in entry.profile.parameters or not entry.quantity.place:
        return ((a, L),) if L in chain else ()
    return ((place, radius),) if entry.quantity.place == "inside" else ((radius, place),)


def _implied(pair: tuple[sp.Expr, sp.Expr], pairs: Pairs) -> bool:
    reached, grown = {pair[0]}, True
    while grown:
        more = {hi for lo, hi in pairs if lo in reached} - reached
        reached, grown = reached | more, bool(more)
    return pair[1] in reached


def _as_chain(steps: list[tuple[sp.Expr, sp.Expr]]) -> list[sp.Expr] | None:
    """The steps as one ascending chain, or None if they branch."""
    following = dict(steps)
    starts = [lo for lo, _ in steps if lo not in following.values()]
    if len(following) != len(steps) or len(starts) != 1:
        return None
    chain = starts
    while chain[-1] in following:
        chain.append(following[chain[-1]])
    return chain
