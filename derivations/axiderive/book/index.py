"""The compact index behind `axicontact list` and `axicontact show`, and the evidence files."""

from __future__ import annotations

import ast
import json
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import sympy as sp

from .. import notation as nt
from ..code.text import written
from ..physics import systems
from ..rows.ranges import regions
from ..rows.row import row
from ..store.records import profile_record
from . import page
from .evidence import matrix

if TYPE_CHECKING:
    from ..entry import Entry
    from ..physics.systems import Problem, System

FORMAT = 2


def to_text(record: Any) -> str:
    """The record as indented JSON, keys in the order given, with a newline at the end."""
    return json.dumps(record, indent=1, ensure_ascii=False, sort_keys=False) + "\n"


def index_record(
    derived: Mapping[str, Mapping[str, Entry]],
    evidence: Mapping[str, Mapping[str, Any]],
    modules: Mapping[str, str],
    formulas: Mapping[str, Mapping[str, Any]],
) -> dict[str, Any]:
    """What `list` and `show` need of every entry, as text.

    Parameters
    ----------
    derived, evidence : mapping
        Entries by suffix, and what was found about them, by key of the problem.
    modules : mapping
        The generated modules by path, from which the signatures are read.
    formulas : mapping
        What `formulas_of` gives of all profiles.
    """
    problems = [systems.problem(key) for key in derived]
    profiles: dict[str, list[Problem]] = {}
    for problem in problems:
        profiles.setdefault(problem.profile_id, []).append(problem)
    return {
        "format": FORMAT,
        "physics": [
            {"name": s.name, "title": s.said.title, "module": s.package, "formulas": _count(problems, derived, s)}
            for s in systems.SYSTEMS
        ],
        "units": [
            {"name": n.name, "latex": n.latex, "unit": n.unit, "domain": n.domain, "meaning": n.meaning}
            for n in nt.all_notation()
        ],
        "profiles": [_profile(own, derived) for own in profiles.values()],
        "matrix": matrix(derived, evidence),
        "entries": [row for problem in problems for row in _rows(problem, derived, evidence, modules, formulas)],
    }


def formulas_of(derived: Mapping[str, Mapping[str, Entry]]) -> dict[str, dict[str, Any]]:
    """What the index has of the formulas of some profiles, by key: nearly all its time; no profile needs another."""
    return {
        entry.key: {
            "cases": _cases(entry),
            "latex": [{"conditions": region.condition, "text": region.tex} for region in row(entry).regions],
            "composed": list(entry.composed) if entry.composed else [],
            "definition": _text(entry.definition),
        }
        for entries in derived.values()
        for entry in entries.values()
    }


def evidence_record(problem: Problem, records: Mapping[str, Any], evidence: Mapping[str, Any]) -> dict[str, Any]:
    """All that is stored of one problem: the entries as `check` and `verify` read them, and what was found of them."""
    profile = profile_record(problem.profile)
    return {"format": FORMAT, "problem": problem.key, "evidence": evidence, "profile": profile, "entries": records}


def _count(problems: Sequence[Problem], derived: Mapping[str, Mapping[str, Entry]], system: System) -> int:
    return sum(len(derived[problem.key]) for problem in problems if problem.system == system)


def _profile(problems: Sequence[Problem], derived: Mapping[str, Mapping[str, Entry]]) -> dict[str, Any]:
    profile = problems[0].profile
    return {
        "name": problems[0].profile_id,
        "title": profile.title,
        "subtitle": profile.subtitle,
        "contact": profile.contact,
        "shape": [_case("" if p.upper is None else f"r < {written(p.upper)}", p.expr) for p in profile.pieces],
        "parameters": [str(getattr(p, "label", p)) for p in profile.parameters],
        "abbreviations": [f"{symbol} = {written(expr)}" for symbol, expr in profile.abbreviations],
        "rules": [f"{written(rule.relation())} ({rule.reason})" for rule in profile.rules],
        "validity": profile.validity,
        "sources": list(profile.sources),
        "synonyms": list(profile.synonyms),
        "note": profile.note,
        "problems": {p.key: {"physics": p.system.name, "formulas": len(derived[p.key])} for p in problems},
    }


def _rows(
    problem: Problem,
    derived: Mapping[str, Mapping[str, Entry]],
    evidence: Mapping[str, Mapping[str, Any]],
    modules: Mapping[str, str],
    formulas: Mapping[str, Mapping[str, Any]],
) -> list[dict[str, Any]]:
    signatures = {name: _bare(found) for name, found in page.signatures(modules[problem.module]).items()}
    found = evidence[problem.key]["entries"]
    known = derived[problem.key].items()
    return [_entry(problem, own, found.get(end, {}), signatures, formulas[own.key]) for end, own in known]


def _bare(arguments: ast.arguments) -> str:
    """The arguments of a function without their types: `r, a, *, theta, E_star`."""
    for argument in (*arguments.args, *arguments.kwonlyargs):
        argument.annotation = None
    return ast.unparse(arguments)


def _entry(
    problem: Problem,
    entry: Entry,
    evidence: Mapping[str, Any],
    signatures: Mapping[str, str],
    formulas: Mapping[str, Any],
) -> dict[str, Any]:
    quantity = entry.quantity
    arguments = signatures[quantity.function]
    domains = [_domain(problem, symbol) for symbol in (*quantity.arguments, *entry.parameters)]
    return {
        "key": entry.key,
        "problem": problem.key,
        "profile": problem.profile_id,
        "physics": problem.system.name,
        "quantity": entry.suffix,
        "label": quantity.label,
        "function": quantity.function,
        "symbol": str(quantity.symbol),
        "status": entry.status,
        **formulas,
        "python": f"{problem.module.removesuffix('.py').replace('/', '.')}.{quantity.function}({arguments})",
        "unit": nt.describe(quantity.symbol).unit,
        "domain": list(dict.fromkeys(domain for domain in domains if domain)),
        "sources": [*entry.references, *problem.profile.sources],
        "evidence": evidence.get("summary", "none"),
        "note": entry.note,
    }


def _domain(problem: Problem, symbol: sp.Symbol) -> str:
    """Where the symbol may lie; with adhesion a contact also holds under tension, down to its pull-off."""
    least = {nt.F: "force", nt.d: "depth"}
    if problem.system.physics.tension and symbol in least:
        return f"{symbol} >= pull_off(control='{least[symbol]}').{least[symbol]}"
    return nt.describe(symbol).domain


def _cases(entry: Entry) -> list[dict[str, str]]:
    """The formulas with what tells them apart; a single one with the region on which it holds."""
    if len(entry.cases) == 1:
        (case,) = entry.cases
        chain = " < ".join(map(sp.sstr, case.chain)) if len(case.chain) > 1 else ""
        return [_case(chain, case.expr)]
    found = []
    for pairs, expr in regions(entry):
        signs = ((low, "<=" if high in entry.borders else "<", high) for low, high in pairs)
        found.append(_case(" and ".join(f"{written(low)} {sign} {written(high)}" for low, sign, high in signs), expr))
    return found


def _case(conditions: str, expr: sp.Expr) -> dict[str, str]:
    return {"conditions": conditions, "text": _text(expr)}


def _text(expr: sp.Expr) -> str:
    if isinstance(expr, sp.Equality):
        return f"{written(expr.lhs)} = {written(expr.rhs)}"
    return written(expr)
