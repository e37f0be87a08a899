"""Evaluation forms in the compiled source: another formula, or an integral, that takes the value of the entry."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Protocol

import mpmath as mp

from ... import notation as nt
from ...entry import Entry
from ...proof.evaluate import decades, evaluate
from ..evaluated_slip import close_share
from .borders import Place, misplaced, places_of
from .compare import DIGITS, difference, value_of
from .exact import Entries, Stored, base_of, functions
from .grammar import read
from .left import bound, name_of
from .nodes import Node, Statement, environment
from .points import points_of
from .printed import Printed, Values, holds, named
from .statements import CLOSE


class Stated(Protocol):
    """The keys of a row, what stands beside it, and its formula."""

    @property
    def keys(self) -> tuple[str, ...]: ...
    @property
    def small(self) -> str: ...
    @property
    def tex(self) -> str: ...


def differs(members: Sequence[Node], env: Mapping[str, Any], own: Mapping[str, Any], want: Any) -> bool:
    """Whether a chain of equalities is not one at a point where its first member is `want`."""
    return len(members) < 2 or any(
        difference(member(own if i == 0 else env), want) > CLOSE for i, member in enumerate(members)
    )


def as_named(entry: Entry, want: Any, env: Mapping[str, Any]) -> dict[str, Any]:
    """The quantity under its name; a depth is also that of the function g."""
    own = bound(name_of(entry), want, env)
    return bound("g(a)", want, own) if entry.suffix == "d" and "a" in own else own


def evaluation_differs(one: Stated, stored: Stored) -> bool:
    """Whether an evaluation form has another value than its entry, or a range that is none of its cases."""
    statements = read(one.tex)
    count = len(one.keys)
    parts = zip(one.keys, statements, strict=False)
    return count > len(statements) or any(_form_differs(*part, statements[count:], one, stored) for part in parts)


def _form_differs(key: str, first: Statement, definitions: list[Statement], one: Stated, stored: Stored) -> bool:
    problem, _, suffix = key.rpartition(".")
    entries, base, met = stored(problem), base_of(problem, stored), False
    entry = entries[suffix]
    loads = any(name in one.small for name in ("(a)", ";a)"))
    if loads and _switches_elsewhere(one.small):
        return True
    for case, values in points_of(entry, "formula", entries, 2, 7):
        # psi less the first terms of its series leaves seven powers of a far distance; quadratures take long
        with mp.workdps(2 * DIGITS + (1 if r"\int" in one.tex else 10) * decades(values)):
            env = named(values) | Printed(entries, base).kappa
            if base is not entries or nt.k in values:
                env |= functions(base, values) | _retraction(entries, values)
            if nt.c in values and nt.r in values and values[nt.r] > values[nt.c]:
                continue  # the slip ring, where nothing is subtracted
            if not loads and not holds(one.small, env):
                continue
            met = True
            want = value_of(case.expr, values)
            if differs(first.members, environment(definitions, env), as_named(entry, want, env), want):
                return True
    return not met or bool(one.small and not loads and _misplaced(entry, entries, one.small))


def _retraction(entries: Entries, values: Values) -> dict[str, Any]:
    return {"Delta ell": evaluate(entries["Dl"].cases[0].expr, values, DIGITS)} if "Dl" in entries else {}


LOADED = ("F_N()", "g()", "p()")
"""What a contact is told close by."""
SIDES = mp.mpf(10) ** -9


def _switches_elsewhere(small: str) -> bool:
    """Whether the share from which on growth is integrated is not the one of the module."""
    share = mp.mpf(close_share().p) / close_share().q
    same = {name: (lambda *at: at[-1]) for name in LOADED}
    near = [{"a": mp.mpf(3), "c": 3 * share * (1 + side), "r": mp.mpf(0), **same} for side in (SIDES, -SIDES)]
    return [holds(small, env) for env in near] != [True, False]


def _misplaced(entry: Entry, entries: Entries, condition: str) -> bool:
    places: list[Place] = places_of(entry, "formula", entries)
    return any(misplaced(entry, [condition], places, partial=True))
