"""The compact index behind `axicontact list` and `axicontact show`, and the evidence files."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import sympy as sp

from .. import notation as nt
from .ranges import regions
from .rows import row

if TYPE_CHECKING:
    from ..entry import Entry
    from ..profiles.profile import Profile

FORMAT = 1


def to_bytes(record: Any) -> bytes:
    return (json.dumps(record, indent=1, ensure_ascii=False, sort_keys=False) + "\n").encode()


def index_record(
    catalogue: Sequence[tuple[Profile, Mapping[str, Entry]]],
    evidence: Mapping[str, Mapping[str, Any]],
) -> dict[str, Any]:
    """What `list` and `show` need of every entry, as text; `evidence` by profile name."""
    return {
        "format": FORMAT,
        "physics": [{"name": "normal", "title": "Normal contact without adhesion", "module": "axicontact.normal"}],
        "units": [
            {"name": n.name, "latex": n.latex, "unit": n.unit, "domain": n.domain, "meaning": n.meaning}
            for n in nt.all_notation()
        ],
        "profiles": [_profile(profile, entries) for profile, entries in catalogue],
        "entries": [
            _entry(profile, entry, evidence[profile.name]["entries"].get(suffix, {}))
            for profile, entries in catalogue
            for suffix, entry in entries.items()
        ],
    }


def evidence_record(profile: Profile, records: Mapping[str, Any], evidence: Mapping[str, Any]) -> dict[str, Any]:
    """Everything stored about one profile: the entries as `check` reads them, and what was found about them."""
    return {"format": FORMAT, "profile": profile.name, "evidence": evidence, "entries": records}


def _profile(profile: Profile, entries: Mapping[str, Entry]) -> dict[str, Any]:
    return {
        "name": profile.name,
        "title": profile.title,
        "subtitle": profile.subtitle,
        "contact": profile.contact,
        "shape": [_piece(upper, expr) for upper, expr in ((p.upper, p.expr) for p in profile.pieces)],
        "parameters": [str(getattr(p, "label", p)) for p in profile.parameters],
        "abbreviations": [f"{symbol} = {sp.sstr(expr)}" for symbol, expr in profile.abbreviations],
        "rules": [f"{sp.sstr(rule.relation())} ({rule.reason})" for rule in profile.rules],
        "validity": profile.validity,
        "sources": list(profile.sources),
        "synonyms": list(profile.synonyms),
        "note": profile.note,
        "keys": [entry.key for entry in entries.values()],
    }


def _piece(upper: sp.Expr | None, expr: sp.Expr) -> dict[str, str]:
    condition = "" if upper is None else f"r < {sp.sstr(upper)}"
    return {"conditions": condition, "text": _text(expr)}


def _entry(profile: Profile, entry: Entry, evidence: Mapping[str, Any]) -> dict[str, Any]:
    quantity = entry.quantity
    fields = [str(argument) for argument in quantity.arguments]
    parameters = [str(getattr(p, "label", p)) for p in entry.parameters]
    keywords = [name for name in parameters if name not in fields]
    signature = ", ".join([*fields, *(["*", *keywords] if keywords else [])])
    return {
        "key": entry.key,
        "profile": profile.name,
        "quantity": entry.suffix,
        "label": quantity.label,
        "function": quantity.function,
        "symbol": str(quantity.symbol),
        "status": entry.status,
        "cases": _cases(entry),
        "latex": [{"conditions": region.condition, "text": region.tex} for region in row(entry).regions],
        "composed": list(entry.composed) if entry.composed else [],
        "definition": _text(entry.definition),
        "python": f"axicontact.normal.{profile.name}.{quantity.function}({signature})",
        "unit": nt.describe(quantity.symbol).unit,
        "domain": [nt.describe(name).domain for name in [*fields, *keywords] if nt.describe(name).domain],
        "sources": [*entry.references, *profile.sources],
        "evidence": evidence.get("summary", "none"),
        "note": entry.note,
    }


def _cases(entry: Entry) -> list[dict[str, str]]:
    """The formulas with what tells them apart; a single one with the region on which it holds."""
    if len(entry.cases) == 1:
        (case,) = entry.cases
        chain = " < ".join(map(sp.sstr, case.chain)) if len(case.chain) > 1 else ""
        return [_case(chain, case.expr)]
    found = []
    for pairs, expr in regions(entry):
        found.append(_case(" and ".join(f"{sp.sstr(low)} < {sp.sstr(high)}" for low, high in pairs), expr))
    return found


def _case(conditions: str, expr: sp.Expr) -> dict[str, str]:
    return {"conditions": conditions, "text": _text(expr)}


def _text(expr: sp.Expr) -> str:
    if isinstance(expr, sp.Equality):
        return f"{sp.sstr(expr.lhs)} = {sp.sstr(expr.rhs)}"
    return str(sp.sstr(expr))
