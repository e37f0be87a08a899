"""Profiles that turn into simpler ones, in print: what the checks found true, from the entries of the simpler one.

The limits that the profile files name are those of the stored checks; others, and those of the plane, are checked here.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from .. import notation as nt
from ..entry import Case, Entry
from ..notation import R1, R2, R, a, b, h, n, r
from ..physics import complete, normal, plane
from ..physics.normal import derive
from ..print.box import width
from ..print.formula import Printer
from ..print.shorthand import LINE, with_kappa
from ..profiles import load
from ..profiles import plane as flat
from ..profiles.profile import Limit, Profile
from .approach import NEAR, Approach, approach_row

SHOWN = ("d", "F", "P", "p")
"""The quantities whose limits are printed; the depth of the plane, which ends at L, is too long."""
GAP = r",\enspace "
WHOLE, HALF = LINE - 90.0, 139.0
"""Points for the formulas of a row with the name of the simpler profile behind it, and of half a row."""


def limit_rows(profile: Profile, entries: Mapping[str, Entry], evidence: Mapping[str, Any]) -> list[dict[str, Any]]:
    """A row for each limit, half a line where there are several; `evidence` is that of the normal contact."""
    found = []
    for limit in profile.limits:
        simpler = derive(load(limit.target))  # the simple ones take less than a tenth of a second
        shown: dict[str, str] = {}
        for suffix in SHOWN:
            if suffix not in simpler or not _passed(evidence, suffix, limit, simpler[suffix].key):
                continue
            entry = entries[suffix]
            part = rf"{entry.quantity.called}\to {limit_tex(profile, limit, entry, simpler[suffix])}"
            if width(GAP.join([*shown.values(), part])) <= (HALF if len(profile.limits) > 1 else WHOLE):
                shown[suffix] = part
        if shown:
            found.append(_row(profile, limit, shown))
    return found


def _row(profile: Profile, limit: Limit, shown: Mapping[str, str]) -> dict[str, Any]:
    title, several = load(limit.target).title, len(profile.limits) > 1
    link = rf"\hyperref[sec:{limit.target}]{{{title if several else title.lower()}}}"
    return {
        "half": several,
        "comment": " ".join(["limit", *(f"{profile.name}.{suffix}" for suffix in shown)]),
        "label": link if several else "Limit",
        "small": rf"${Printer()(limit.symbol)}\to {Printer()(sp.sympify(limit.value))}$",
        "tex": GAP.join(shown.values()),
        "remark": "" if several else link,
    }


def _passed(evidence: Mapping[str, Any], suffix: str, limit: Limit, key: str) -> bool:
    """Whether the record holds the check of this limit, passed, as `checks.limits` names it."""
    checks = evidence.get("entries", {}).get(suffix, {}).get("checks", [])
    name = f"limit {limit.symbol} -> {limit.value}: {key}"
    return any(check["compared"] == name and check["outcome"] == "passed" for check in checks)


def limit_tex(profile: Profile, limit: Limit, entry: Entry, simpler: Entry) -> str:
    """The simpler formula in the parameters of the profile, without its left side."""
    case = simpler.cases[-1]
    chain = tuple(x for x in case.chain if x in entry.profile.chain or x in (nt.a, r))
    short = with_kappa(case.expr.subs(own_parameters(profile, limit, load(limit.target))))
    return Printer(chain, short.names)(short.expr)


def own_parameters(profile: Profile, limit: Limit, target: Profile) -> dict[sp.Expr, sp.Expr]:
    """Parameters of the simpler profile that this one does not have, from the equality of both shapes."""
    own = [symbol for symbol in target.parameters if symbol not in profile.parameters]
    if not own:
        return {}
    reached = profile.pieces[-1].expr.subs(limit.symbol, limit.value)
    (solution,) = sp.solve(sp.expand(target.pieces[-1].expr / reached) - 1, own[0])
    return {own[0]: solution}


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


def reduction_rows(profile: Profile, entries: Entries) -> Rows:
    """A row for each, half a line where there are several."""
    found = _reductions(profile, "s" in entries)
    return [row for one in found for row in _reduction_row(profile, entries, one, len(found) > 1)]


def _reductions(profile: Profile, in_plane: bool) -> Sequence[Reduction]:
    if not in_plane:
        return BEYOND.get(profile.name, ())
    return [
        Reduction(
            limit.target, limit.symbol, sp.sympify(limit.value), own_parameters(profile, limit, flat.load(limit.target))
        )
        for limit in profile.limits
    ]


def _reduction_row(profile: Profile, entries: Entries, one: Reduction, half: bool) -> Rows:
    in_plane = "s" in entries
    target = flat.load(one.target) if in_plane else load(one.target)
    simpler = _derived(target, in_plane)
    parts = []
    for suffix in SHOWN:
        if suffix not in simpler or suffix not in entries or (in_plane and suffix == "d"):
            continue
        if entries[suffix].status == "integral":  # the quadrature of one takes minutes there
            continue
        cases = tuple(Case(c.chain, c.expr.subs(dict(one.parameters))) for c in simpler[suffix].cases)
        left = entries[suffix].quantity.called
        parts.append(Approach(entries[suffix], left, _way(profile, one), cases))
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
    return (complete if target.complete else normal).derive(target)
