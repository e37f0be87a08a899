"""What every row of a problem says, exactly: the value of its quantity in a case, or that its sides are equal there.

It is taken from the entries, never from the text of the row: also the loads and radii that belong together.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TypeAlias

import sympy as sp

from .. import notation as nt
from ..entry import Case, Entry
from ..physics.adhesive import CONTROLS
from ..physics.systems import of
from .row import Row

Entries = Mapping[str, Entry]
Exact: TypeAlias = sp.Basic | Entry
"""An expression, an equation, or an entry in whichever of its cases holds at a point."""
Given = tuple[tuple[sp.Symbol, Exact], ...]
"""Symbols that follow from those before them."""


@dataclass(frozen=True)
class Claim:
    """A statement about every point of a case, once the symbols that are given there have their values."""

    given: Given = ()
    value: Exact | None = None
    """Of the quantity on the left, or of each side of an equation; None of an equation that holds there."""


def claim(one: Row, entry: Entry, case: Case, entries: Entries, base: Entries) -> Claim:
    """What a row says of an entry that it is about, in a case of that entry or, of an inverse, of the forward formula.

    `base` are the entries of the normal contact on the same medium.
    """
    own, slip = entry.quantity, _slip(entry, base)
    if one.kind == "formula":
        return Claim((*slip, (nt.F, base["F"])) if own.symbol == nt.p_mean else slip, case.expr)
    if one.kind == "definition":
        also = ((entries[one.uses].quantity.symbol, entries[one.uses]),) if one.uses else ()
        return Claim(((own.symbol, case.expr), *also))
    if one.kind == "root":
        return Claim(((own.arguments[0], case.expr),))
    if one.kind == "composition" and entry.composed:
        known = entry if entry.status == "closed" else entries[entry.composed[0]]
        return Claim(((own.arguments[0], case.expr),), known)
    if of(entry).physics.laws:
        return _law(entry, case, base)
    if own.inverts or own.symbol == nt.a_c:
        return Claim((*slip, *_balance(entry, case)))
    return Claim(_pulled(entry, case, entries), case.expr)


def _slip(entry: Entry, base: Entries) -> Given:
    """A tangential force between full stick and full slip under the force that the outer radius belongs to."""
    if nt.F_x not in entry.quantity.arguments:
        return ()
    return ((nt.F, base["F"]), (nt.F_x, nt.F * nt.mu * sp.Rational(3, 7)))


def _balance(entry: Entry, case: Case) -> Given:
    """The unknown takes its closed value, or what balances the equation the value that goes with the unknown."""
    if not isinstance(case.expr, sp.Equality):
        return ((entry.quantity.symbol, case.expr),)
    left, right = case.expr.args
    loads = entry.quantity.arguments
    return ((loads[0], left),) if loads else ((nt.dgamma, nt.dgamma * (left / right) ** 2),)


def _pulled(entry: Entry, case: Case, entries: Entries) -> Given:
    """Radius and work of separation that belong together at pull-off; nothing else has a control."""
    if not entry.quantity.control:
        return ()
    radius = entries[CONTROLS[entry.quantity.control][0]]
    same = (other for other in radius.cases if radius.status == "closed" or other.chain == case.chain)
    return _balance(radius, next(same))


def _law(entry: Entry, case: Case, base: Entries) -> Claim:
    """Of a viscoelastic contact at any modulus: the row has E* beside the functions of the law, the entry has not."""
    equation = isinstance(case.expr, sp.Equality)
    given: Given = ((nt.E_star, sp.Integer(3)),)
    if equation and entry.quantity.symbol == nt.a:
        left, right = case.expr.args
        return Claim((*given, (nt.F, nt.F * left / right)))
    known = {s for x in (*case.chain, case.expr) for s in x.free_symbols}
    if nt.d in entry.quantity.arguments and nt.a not in known and "ad" in base:
        given = (*given, (nt.a, base["ad"]))
    return Claim(given, case.expr.args[1] if equation else case.expr)
