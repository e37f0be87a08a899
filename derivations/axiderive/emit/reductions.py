"""Profiles that turn into simpler ones in a limit the profile files do not name, and those of the plane."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from ..contact import complete, normal, plane
from ..entry import Case, Entry
from ..notation import R1, R2, R, a, b, h, n
from ..profiles import load
from ..profiles import plane as flat
from ..profiles.profile import Profile
from .approach import NEAR, Approach, approach_row
from .limits import own_parameters
from .naming import LEFT
from .printer import Printer

Entries = Mapping[str, Entry]
Rows = list[dict[str, Any]]
Way = tuple[tuple[sp.Symbol, sp.Expr], ...]


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
QUANTITIES = (("d", "g(a)"), ("F", LEFT["F"]), ("P", "P"), ("p", LEFT["p"]))
"""What is printed, in this order; the depth of the plane, which ends at L, is too long."""


def reduction_rows(profile: Profile, entries: Entries) -> Rows:
    """A row for each, half a line where there are several."""
    found = _reductions(profile, "s" in entries)
    return [row for one in found for row in _row(profile, entries, one, len(found) > 1)]


def _reductions(profile: Profile, in_plane: bool) -> Sequence[Reduction]:
    if not in_plane:
        return BEYOND.get(profile.name, ())
    return [
        Reduction(
            limit.target, limit.symbol, sp.sympify(limit.value), own_parameters(profile, limit, flat.load(limit.target))
        )
        for limit in profile.limits
    ]


def _row(profile: Profile, entries: Entries, one: Reduction, half: bool) -> Rows:
    in_plane = "s" in entries
    target = flat.load(one.target) if in_plane else load(one.target)
    simpler = _derived(target, in_plane)
    parts = []
    for suffix, left in QUANTITIES:
        if suffix not in simpler or suffix not in entries or (in_plane and suffix == "d"):
            continue
        if entries[suffix].status == "integral":  # the quadrature of one takes minutes there
            continue
        cases = tuple(Case(c.chain, c.expr.subs(dict(one.parameters))) for c in simpler[suffix].cases)
        shown = left.replace("r", "x") if in_plane and suffix == "p" else left
        parts.append(Approach(entries[suffix], shown, _way(profile, one), cases))
    title = target.title if half else target.title.lower()
    link = rf"\hyperref[sec:{'plane.' if in_plane else ''}{one.target}]{{{title}}}"
    end = r"\infty" if one.end == sp.oo else Printer()(one.end)
    way = rf"{Printer()(one.symbol)}\to {end}"
    rows = approach_row("Limit", way, parts, half, kind="limit") or approach_row("Limit", way, parts, False, "limit")
    return [row | ({"label": link} if half else {"remark": link}) for row in rows]


def _way(profile: Profile, one: Reduction) -> Way:
    """The symbol next to its end, measured by the contact radius; what is short for it goes along."""
    if one.end.is_Integer and one.end != 0:
        return ((one.symbol, one.end),)
    next_to = {sp.oo: a / NEAR, sp.S.Zero: a * NEAR}.get(one.end, one.end * (1 + NEAR))
    return ((one.symbol, next_to), *profile.abbreviations)


def _derived(target: Profile, in_plane: bool) -> Entries:
    if in_plane:
        return plane.derive(target)
    return (complete if target.contact == "complete" else normal).derive(target)
