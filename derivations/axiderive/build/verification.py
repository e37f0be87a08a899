"""All evidence about one problem in one record: certificates, and the checks that do not trust them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from ..checks import checks
from ..checks.comparison import Evidence
from ..physics import systems
from ..proof import certificate
from ..store.records import entry_record, profile_record
from ..verifier import reasons, rests_on

if TYPE_CHECKING:
    from ..entry import Entry
    from ..physics.systems import Problem
    from ..proof.certificate import Certificate
    from .work import Settings


def verify(
    problem: Problem,
    entries: Mapping[str, Entry],
    settings: Settings,
    kept: Sequence[Mapping[str, Any]] | None = None,
) -> dict[str, Any]:
    """Certify and check the entries of a problem; `kept` are its checks where they need not be made again.

    Returns
    -------
    dict
        JSON-able: `settings`, `entries` (by suffix: status, whether certified, what the
        second prover says of it, worst residual, a summary, the certificate and the
        checks) and `failures`, a list of key and message.
    """
    certificates = certificate.certify_profile(problem.profile, dict(entries))
    second = reasons(*_stored(problem, entries))
    if kept is None:
        found = checks.check_problem(problem, entries, **settings.record())
    else:
        found = [Evidence(**check) for check in kept]
    by_key: dict[str, list[Evidence]] = {entry.key: [] for entry in entries.values()}
    for check in found:
        by_key[check.key].append(check)
    return {
        "settings": settings.record(),
        "entries": {
            suffix: _entry(entry, certificates[suffix], second[suffix], by_key[entry.key])
            for suffix, entry in entries.items()
        },
        "failures": [{"key": c.key, "message": _failure(c)} for c in found if c.outcome == "failed"],
    }


def checks_of(evidence: Mapping[str, Any]) -> list[dict[str, Any]]:
    """The checks of a record, those of all its entries."""
    return [check for entry in evidence["entries"].values() for check in entry["checks"]]


def _stored(problem: Problem, entries: Mapping[str, Entry]) -> list[dict[str, Any]]:
    """The problem as the evidence stores it, and the normal contact it rests on, derived anew."""
    below = rests_on(problem.key)
    own = {"problem": problem.key, "entries": {suffix: entry_record(entry) for suffix, entry in entries.items()}}
    both = [own, _derived(below)] if below else [own]
    return [{**record, "profile": profile_record(problem.profile)} for record in both]


@lru_cache(maxsize=4)
def _derived(key: str) -> dict[str, Any]:
    """The record of a normal contact; the problems of a profile, one behind the other, rest on the same."""
    derived = systems.problem(key).derive()
    return {"problem": key, "entries": {suffix: entry_record(entry) for suffix, entry in derived.items()}}


def _entry(entry: Entry, proof: Certificate, missing: str, checks: Sequence[Evidence]) -> dict[str, Any]:
    residuals = [check.worst for check in checks if check.passed and check.worst]
    return {
        "status": entry.status,
        "certified": proof.proved,
        "twice": {"cases": len(entry.cases), "shown": proof.proved and not missing, "reason": missing},
        "residual": max(residuals, key=float, default=""),
        "summary": _summary(proof, missing, checks),
        "certificate": {"proved": proof.proved, "steps": list(proof.steps), "reason": proof.reason},
        "checks": [asdict(check) for check in checks],
    }


def _summary(proof: Certificate, missing: str, checks: Sequence[Evidence]) -> str:
    """One line for `show`, the docstring and the handbook."""
    parts = ["certified" if proof.proved else "not certified"]
    if proof.proved:
        parts.append("by the first prover only" if missing else "by two provers")
    parts += [f"{check.compared}: {_short(check)}" for check in checks if check.outcome != "not available"]
    return "; ".join(parts)


def _short(check: Evidence) -> str:
    if not check.worst:
        return str(check.outcome)
    points = "1 point" if check.count == 1 else f"{check.count} points"
    return f"{check.outcome}, {check.digits} digits at {points}"


def details(found: Mapping[str, Any]) -> list[str]:
    """Every step of the certificate and every check of one entry of a record, a line each."""
    proof = found["certificate"]
    lines = [f"certificate: {step}" for step in proof["steps"]]
    if not proof["proved"]:
        lines.append(f"no certificate: {proof['reason']}")
    if proof["proved"] and found["twice"]["reason"]:
        lines.append(f"by the first prover only: {found['twice']['reason']}")
    for check in found["checks"]:
        text = f"{check['compared']}: {check['outcome']}"
        if check["worst"]:
            where = _point(check["worst_point"])
            text += f", {check['digits']} digits at {check['count']} points, worst residual {check['worst']} at {where}"
        lines.append(text + (f" ({check['reason']})" if check["reason"] else ""))
    return lines


def _failure(check: Evidence) -> str:
    found = f"agrees to {check.digits} of {check.required} digits" if check.required else check.reason or "failed"
    where = f" at {_point(check.worst_point)}" if check.worst_point else ""
    return f"compared with {check.compared}: {found}, residual {check.worst or 'unknown'}{where}"


def _point(values: Mapping[str, str]) -> str:
    return ", ".join(f"{name} = {value}" for name, value in values.items())
