"""Numbers of the doctests of plane modules, from the exact results."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import sympy as sp

from ... import notation as nt
from ...entry import Case, Entry, Quantity
from ...profiles.profile import Profile
from .. import example


def lines(
    profile: Profile, entries: Mapping[str, Entry], quantity: Quantity, symbols: tuple[sp.Symbol, ...]
) -> list[str]:
    """The call with the numbers of the sketch, and its result."""
    suffix = quantity.suffix
    known = environment(profile, entries, suffix)
    arguments = [example.literal(known[symbol]) for symbol in quantity.arguments]
    arguments += [f"{symbol}={example.literal(known[symbol])}" for symbol in symbols]
    result = shape(profile, known) if suffix == "f" else value(profile, entries, suffix, known)
    call = f"{profile.name}.{quantity.function}({', '.join(arguments)})"
    start = [f">>> from axicontact.plane import {profile.name}", f">>> value = {call}"]
    return [*start, ">>> round(value, 6)", example.result(result)]


def environment(profile: Profile, entries: Mapping[str, Entry], suffix: str) -> dict[sp.Symbol, sp.Expr]:
    """The sketch: its parameters and contact, a point inside or twice as far as the edge, and the load to it."""
    known = example.environment(profile)
    known.setdefault(nt.a, sp.Rational(str(profile.sketch.a)))
    known[nt.x] = known[nt.a] * (2 if suffix == "s" else sp.Rational(3, 10))
    known[nt.L] = 10 * known[nt.a]
    if "P" in entries:
        known[nt.P] = example.rounded(example.value(profile, entries["P"], known))
    else:
        known[nt.P] = sp.S.One
    return known


def value(profile: Profile, entries: Mapping[str, Entry], suffix: str, known: Mapping[sp.Symbol, sp.Expr]) -> sp.Float:
    """The exact result; the place of first zero pressure from its equation where the result needs it."""
    entry = entries[suffix]
    if suffix == "xz" and entry.status == "root":
        cases = tuple(Case(case.chain, case.expr.subs(nt.x_zero, nt.r_zero)) for case in entry.cases)
        return example.value(profile, replace(entry, cases=cases), known)
    if entry.cases[0].expr.has(nt.x_zero):
        known = {**known, nt.x_zero: value(profile, entries, "xz", known)}
    return example.value(profile, entry, known)


def shape(profile: Profile, known: Mapping[sp.Symbol, sp.Expr]) -> sp.Float:
    """f(x) at these numbers."""
    piece = next(piece for piece in profile.pieces if piece.upper is None or known[nt.x] < piece.upper.subs(known))
    return example.number(piece.expr, known)
