"""Profiles that turn into simpler ones, in print, from the entries of the simpler one.

What the profile files name was found true by the stored checks; other limits, and those of the plane, are checked here.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import sympy as sp

from ..entry import Case, Entry
from ..notation import R1, R2, R, a, b, h, n
from ..physics import complete, normal, plane
from ..print.formula import Printer
from ..profiles import load
from ..profiles import plane as flat
from ..profiles.profile import Limit, Profile
from .approaches import NEAR, Approach, Entries, Rows, fitted_row

SHOWN = ("d", "F", "P", "p")
"""The quantities whose limits are printed; the depth of the plane, which ends at L, is too long."""


@dataclass(frozen=True)
class Reduction:
    """Simpler profile, the symbol that moves, where it goes, and what the parameters of the simpler one are then."""

    target: str
    symbol: sp.Symbol
    end: sp.Expr
    parameters: Mapping[sp.Expr, sp.Expr] = field(default_factory=dict)


BEYOND: dict[str, tuple[Reduction, ...]] = {
    "ellipsoid": (Reduction("sphere", h, b, {R: b}),),
    "hyperboloid": (Reduction("cone", b, sp.S.Zero),),
    "sphere_tipped_cone": (Reduction("cone", R, sp.S.Zero),),
    "capped_paraboloid": (Reduction("truncated_paraboloid", R1, sp.oo, {R: R2}),),
    "rounded_curved_punch": (Reduction("rounded_punch", R1, sp.oo, {R: R2}),),
    "wavy_paraboloid": (Reduction("paraboloid", h, sp.S.Zero),),
    "capped_cylinder": (Reduction("flat_punch", R, sp.oo),),
    "concave_power": (
        Reduction("concave_paraboloid", n, sp.Integer(2)),
        Reduction("concave_quartic", n, sp.Integer(4)),
    ),
    "concave_paraboloid": (Reduction("flat_punch", h, sp.S.Zero),),
    "concave_quartic": (Reduction("flat_punch", h, sp.S.Zero),),
}


def limit_rows(profile: Profile, entries: Entries, evidence: Mapping[str, Any]) -> Rows:
    """A row for each limit that the evidence of the normal contact holds a check of, passed."""
    found: Rows = []
    for limit in profile.limits:
        one = _named(profile, limit, load(limit.target))
        parts = [part for part, key in _parts(profile, entries, one) if _passed(evidence, part.entry, limit, key)]
        found += _row(one, [replace(part, recorded=True) for part in parts], len(profile.limits) > 1)
    return found


def reduction_rows(profile: Profile, entries: Entries) -> Rows:
    """A row for each other limit, and in the plane for each, half a line where there are several."""
    in_plane = "s" in entries
    found: Sequence[Reduction] = BEYOND.get(profile.name, ())
    if in_plane:
        found = [_named(profile, limit, flat.load(limit.target)) for limit in profile.limits]
    rows: Rows = []
    for one in found:
        # the quadrature of an integral takes minutes there
        parts = [part for part, _ in _parts(profile, entries, one) if part.entry.status != "integral"]
        rows += _row(one, parts, len(found) > 1, "plane." if in_plane else "")
    return rows


def _named(profile: Profile, limit: Limit, target: Profile) -> Reduction:
    """A limit of the profile file; parameters that only the simpler profile has follow from both shapes."""
    value, own = sp.sympify(limit.value), [symbol for symbol in target.parameters if symbol not in profile.parameters]
    if not own:
        return Reduction(limit.target, limit.symbol, value)
    reached = profile.pieces[-1].expr.subs(limit.symbol, value)
    (solution,) = sp.solve(sp.expand(target.pieces[-1].expr / reached) - 1, own[0])
    return Reduction(limit.target, limit.symbol, value, {own[0]: solution})


def _passed(evidence: Mapping[str, Any], entry: Entry, limit: Limit, key: str) -> bool:
    """Whether the record holds the check of this limit, passed, as `checks.identities` names it."""
    checks = evidence.get("entries", {}).get(entry.suffix, {}).get("checks", [])
    name = f"limit {limit.symbol} -> {limit.value}: {key}"
    return any(check["compared"] == name and check["outcome"] == "passed" for check in checks)


def _parts(profile: Profile, entries: Entries, one: Reduction) -> list[tuple[Approach, str]]:
    """The quantities of both profiles on their way, each with the key of the simpler formula."""
    in_plane, found = "s" in entries, []
    target = flat.load(one.target) if in_plane else load(one.target)
    simpler = (plane if in_plane else complete if target.complete else normal).derive(target)
    for suffix in SHOWN:
        if suffix in simpler and suffix in entries and not (in_plane and suffix == "d"):
            cases = tuple(Case(c.chain, c.expr.subs(dict(one.parameters))) for c in simpler[suffix].cases)
            found.append((Approach(entries[suffix], _way(profile, one), cases), simpler[suffix].key))
    return found


def _row(one: Reduction, parts: list[Approach], half: bool, pool: str = "") -> Rows:
    title = (flat.load(one.target) if pool else load(one.target)).title
    link = rf"\hyperref[sec:{pool}{one.target}]{{{title if half else title.lower()}}}"
    end = r"\infty" if one.end == sp.oo else Printer()(one.end)
    way = rf"{Printer()(one.symbol)}\to {end}"
    rows = fitted_row("Limit", way, parts, half=half, kind="limit")
    return [replace(row, label=link) if half else replace(row, remark=link) for row in rows]


def _way(profile: Profile, one: Reduction) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    """The symbol next to its end, measured by the contact radius; what is short for it goes along."""
    if one.end.is_Integer and one.end != 0:
        return ((one.symbol, one.end),)
    next_to = {sp.oo: a / NEAR, sp.S.Zero: a * NEAR}.get(one.end, one.end * (1 + NEAR))
    return ((one.symbol, next_to), *profile.abbreviations)
