"""Limits of a profile to simpler ones in print: what the stored checks found true, from the entries of the simpler."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from .. import notation as nt
from ..contact.normal import derive
from ..entry import Entry
from ..notation import r
from ..profiles import load
from ..profiles.profile import Limit, Profile
from .naming import LEFT
from .printer import Printer
from .shorthand import LINE, with_kappa
from .width import width

SHOWN = {"d": "g(a)", "F": LEFT["F"], "p": LEFT["p"]}
"""The quantities whose limits are printed, with what stands before the arrow."""
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
            if not _passed(evidence, suffix, limit, simpler[suffix].key):
                continue
            part = rf"{SHOWN[suffix]}\to {limit_tex(profile, limit, entries[suffix], simpler[suffix])}"
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
    """Whether the record holds the check of this limit, passed, as `proof.limits` names it."""
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
