"""The compact index behind `axicontact list` and `axicontact show`, and the evidence files."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import sympy as sp

from .. import notation as nt

if TYPE_CHECKING:
    from ..entry import Case, Entry
    from ..profiles.profile import Profile

FORMAT = 1
Latex = Callable[[sp.Basic], str]


def to_bytes(record: Any) -> bytes:
    return (json.dumps(record, indent=1, ensure_ascii=False, sort_keys=False) + "\n").encode()


def index_record(
    catalogue: Sequence[tuple[Profile, Mapping[str, Entry]]],
    evidence: Mapping[str, Mapping[str, Any]],
    latex: Latex = sp.latex,
) -> dict[str, Any]:
    """What `list` and `show` need of every entry, as text; `evidence` by profile name."""
    return {
        "format": FORMAT,
        "physics": [{"name": "normal", "title": "Normal contact without adhesion", "module": "axicontact.normal"}],
        "units": [
            {"name": n.name, "latex": n.latex, "unit": n.unit, "domain": n.domain, "meaning": n.meaning}
            for n in nt.all_notation()
        ],
        "profiles": [_profile(profile, entries, latex) for profile, entries in catalogue],
        "entries": [
            _entry(profile, entry, evidence[profile.name]["entries"].get(suffix, {}), latex)
            for profile, entries in catalogue
            for suffix, entry in entries.items()
        ],
    }


def evidence_record(profile: Profile, records: Mapping[str, Any], evidence: Mapping[str, Any]) -> dict[str, Any]:
    """Everything stored about one profile: the entries as `check` reads them, and what was found about them."""
    return {"format": FORMAT, "profile": profile.name, "evidence": evidence, "entries": records}


def _profile(profile: Profile, entries: Mapping[str, Entry], latex: Latex) -> dict[str, Any]:
    return {
        "name": profile.name,
        "title": profile.title,
        "subtitle": profile.subtitle,
        "contact": profile.contact,
        "shape": [_piece(upper, expr, latex) for upper, expr in ((p.upper, p.expr) for p in profile.pieces)],
        "parameters": [str(getattr(p, "label", p)) for p in profile.parameters],
        "rules": [f"{sp.sstr(rule.relation())} ({rule.reason})" for rule in profile.rules],
        "validity": profile.validity,
        "sources": list(profile.sources),
        "synonyms": list(profile.synonyms),
        "note": profile.note,
        "keys": [entry.key for entry in entries.values()],
    }


def _piece(upper: sp.Expr | None, expr: sp.Expr, latex: Latex) -> dict[str, str]:
    condition = "" if upper is None else f"r < {sp.sstr(upper)}"
    return {"conditions": condition, "text": sp.sstr(expr), "latex": latex(expr)}


def _entry(profile: Profile, entry: Entry, evidence: Mapping[str, Any], latex: Latex) -> dict[str, Any]:
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
        "cases": [_case(case, latex) for case in entry.cases],
        "composed": list(entry.composed) if entry.composed else [],
        "definition": {"text": sp.sstr(entry.definition), "latex": latex(entry.definition)},
        "python": f"axicontact.normal.{profile.name}.{quantity.function}({signature})",
        "unit": nt.describe(quantity.symbol).unit,
        "domain": [nt.describe(name).domain for name in [*fields, *keywords] if nt.describe(name).domain],
        "sources": [*entry.references, *profile.sources],
        "evidence": evidence.get("summary", "none"),
        "note": entry.note,
    }


def _case(case: Case, latex: Latex) -> dict[str, str]:
    condition = " < ".join(sp.sstr(length) for length in case.chain) if len(case.chain) > 1 else ""
    return {"conditions": condition, "text": sp.sstr(case.expr), "latex": latex(case.expr)}
