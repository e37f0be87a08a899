"""How well the formulas are known, as plain data: the matrix of profile and physics, and the evidence of a page.

The cells of the matrix say what is certified and what was compared; no cell is silent. Of a page it is certificates,
agreement with definitions and measured errors.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from ..entry import Entry
from ..physics import systems
from ..print.words import prose
from ..profiles import pools

LEGEND = {
    "✓": "certified: an exact proof of the formula, or of the equation and its one root",
    "○": "closed form without a certificate, compared with its definition to the digits behind it",
    "∫": "one integral without a closed form, compared with its definition to the digits behind it",
    "√": "root of an equation, solved by iteration and compared with its definition to the digits behind it",
    "–": "not meaningful; the module says why",
}
LEFT_OUT = "left out"
NOT_VERIFIED = "not verified"
SIGNS = {"closed": "○", "integral": "∫", "root": "√"}


def matrix(derived: Iterable[str], evidence: Mapping[str, Mapping[str, Any]]) -> dict[str, Any]:
    """The cells by profile and system.

    Parameters
    ----------
    derived : iterable of str
        Keys of the problems.
    evidence : mapping
        What was found about them, by key.
    """
    profiles: dict[str, dict[str, str]] = {}
    for key in derived:
        problem = systems.problem(key)
        profiles.setdefault(problem.profile_id, {})[problem.system.name] = _known(evidence[key]["entries"])
    for pool in pools.POOLS:
        for system in (system for system in systems.SYSTEMS if system.pool is pool):
            for name in pool.names:
                if pool.id(name) in profiles and system.refusal(pool.load(name)):
                    profiles[pool.id(name)][system.name] = "–"
    ordered = {
        name: {s.name: cells[s.name] for s in systems.SYSTEMS if s.name in cells} for name, cells in profiles.items()
    }
    found = [entry for record in evidence.values() for entry in record.get("entries", {}).values()]
    return {"legend": LEGEND, "profiles": ordered, "twice": twice(found)}


def twice(found: Iterable[Mapping[str, Any]]) -> str:
    """How many certified formulas were proved by both provers; a formula of several cases counts as many."""
    proofs = [entry["twice"] for entry in found if entry["certified"] and "twice" in entry]
    shown, certified = (sum(proof["cases"] for proof in own) for own in ([p for p in proofs if p["shown"]], proofs))
    return (
        f"{shown} of {certified} certified formulas were proved again by a second program, which shares no code with"
        " the first and reads only what is stored"
    )


NONE = {"formulas": 0, "certified": 0, "twice": 0, **dict.fromkeys(SIGNS, 0)}
"""How the formulas of nothing are known."""


def coverage(found: Sequence[Mapping[str, Any]]) -> dict[str, int]:
    """How formulas are known by what was found of each: counts, and the least digits of their comparisons.

    `least` counts every check of every formula, and is zero where one agreed with nothing.
    """
    left = [one for one in found if not one["certified"]]
    agreed = [[c["digits"] for c in one["checks"] if c["outcome"] == "passed" and c.get("digits")] for one in found]
    return {
        "formulas": len(found),
        "certified": len(found) - len(left),
        "twice": sum(bool(one.get("twice", {}).get("shown")) for one in found if one["certified"]),
        **{status: sum(one["status"] == status for one in left) for status in SIGNS},
        "digits": min((digits for one in found if (digits := _digits(one["checks"]))), default=0),
        "least": min((min(digits, default=0) for digits in agreed), default=0),
    }


def _known(entries: Mapping[str, Mapping[str, Any]]) -> str:
    certified, others = 0, dict[str, list[int]]()
    for found in entries.values():
        if found["certified"]:
            certified += 1
        else:
            others.setdefault(SIGNS[found["status"]], []).append(_digits(found["checks"]))
    parts = [f"{certified} ✓"] if certified else []
    parts += [f"{len(digits)} {sign}{min(digits)}" for sign, digits in others.items()]
    return ", ".join(parts) or NOT_VERIFIED


def _digits(checks: Iterable[Mapping[str, Any]]) -> int:
    """Digits of the best comparison that passed."""
    return max((check["digits"] for check in checks if check["outcome"] == "passed" and check["worst"]), default=0)


def evidence_rows(
    profile_id: str, own: Mapping[str, Mapping[str, Entry]], evidence: Mapping[str, Any]
) -> dict[str, Any]:
    """Certificate and checks of every entry; nothing is claimed that is not recorded.

    Those of the problem the spread begins with as a table without empty columns, the others in short: the fewest
    digits that agreed.
    """
    table: list[dict[str, Any]] = []
    grid: list[dict[str, Any]] = []
    for key, entries in own.items():
        records = evidence.get(key, {}).get("entries", {})
        measured = evidence.get(key, {}).get("evaluation", {})
        for suffix, entry in entries.items():
            if suffix not in records:
                continue
            found = _evidence(entry, records[suffix], measured.get(suffix, {}), profile_id)
            (table if key == profile_id else grid).append(found)
    used = [i for i, _ in enumerate(CHECKS) if any(row["cells"][i] != NOTHING for row in table)]
    for row in table:
        row["cells"] = [row["cells"][i] for i in used]
    return {"heads": [list(CHECKS.values())[i] for i in used], "table": table, "grid": grid}


def _evidence(entry: Entry, record: Mapping[str, Any], measured: Mapping[str, Any], profile_id: str) -> dict[str, Any]:
    passed = [check for check in record.get("checks", []) if check["outcome"] == "passed"]
    by_kind: dict[str, list[Any]] = {kind: [] for kind in CHECKS}
    for check in passed:
        by_kind[kind_of(check["compared"])].append(check)
    digits = [check["digits"] for check in passed if check.get("digits")]
    return {
        "suffix": entry.key[len(profile_id) + 1 :],
        "certified": bool(record.get("certified")),
        "twice": bool(record.get("twice", {}).get("shown")),
        "cells": [_agreement(by_kind[kind]) for kind in CHECKS],
        "evaluation": _evaluation(measured) if measured else [],
        "ruled": measured.get("form") == "rule",
        "digits": str(min(digits)) if digits else "--",
        "count": str(sum(check.get("count", 0) for check in passed if check.get("digits"))),
    }


CHECKS = {
    "quadrature": "defining integral", "enclosure": "ball arithmetic", "identity": "identities", "units": "units",
}  # fmt: skip
"""Heads of the columns of the evidence table by the kind of check."""
NOTHING = "--"
"""The cell of a kind of check that an entry has not passed."""


def kind_of(compared: str) -> str:
    """Which column of the evidence table a check belongs to."""
    words = compared.lower()
    if "quadrature" in words:
        return "quadrature"
    if "ball" in words or "arb" in words or "enclosure" in words:
        return "enclosure"
    return "units" if "dimension" in words or "unit" in words else "identity"


def missing_certificates(
    profile_id: str, own: Mapping[str, Mapping[str, Entry]], evidence: Mapping[str, Any]
) -> list[tuple[list[str], str]]:
    """Ends of the keys without a certificate and the reason, those of one reason together."""
    groups: dict[str, list[str]] = {}
    for key, entries in own.items():
        for suffix, entry in entries.items():
            record = evidence.get(key, {}).get("entries", {}).get(suffix, {"certified": True})
            reason = record.get("certificate", {}).get("reason", "")
            if not record.get("certified") and reason:
                groups.setdefault(_reason(reason, entry.key, profile_id), []).append(entry.key[len(profile_id) + 1 :])
    return [
        (suffixes, reason.replace("as they rest", "as it rests") if len(suffixes) == 1 else reason)
        for reason, suffixes in groups.items()
    ]


_RESTS = re.compile(r"rests on (\S+), which is not proved|(\S+) is ((?:the root|an integral).*)")


def _reason(text: str, key: str, profile_id: str) -> str:
    """The reason in words; another entry of the spread by the end of its key."""
    plain = text.removeprefix(f"{key} is ").removeprefix(f"{key.rpartition('.')[2]} is ")
    found = _RESTS.fullmatch(plain)
    base = (found[1] or found[2]) if found else ""
    if not base.startswith(f"{profile_id}."):
        return prose(plain)
    return rf"as they rest on \own{{{base.removeprefix(f'{profile_id}.')}}}"


def _agreement(checks: list[Any]) -> str:
    """The fewest digits / all points, and the worst residual of all."""
    if not checks:
        return NOTHING
    counted = [check for check in checks if check.get("digits")]
    if not counted:
        return r"\ok"
    least = min(check["digits"] for check in counted)
    worst = max((check["worst"] for check in counted), key=float)
    residual = power_of_ten(worst) if float(worst) else "0"
    return rf"{least}\,/\,{sum(check['count'] for check in counted)}\enspace${residual}$"


FORMS = {"closed": "closed form", "kernel": "special function", "rule": "Gauss rule", "root": "iteration"}
"""How a function of the catalogue evaluates its formula."""


def _evaluation(measured: Mapping[str, Any]) -> list[str]:
    """The way of evaluation and the worst errors in ulps: usual lengths, extreme ones, the printed formula."""
    # bodies that rest on another module have no form of their own
    nodes = ", ".join(str(count) for count in measured.get("nodes", ()))
    form = FORMS.get(measured.get("form", ""), "--") + (f", {nodes} nodes" if nodes else "")
    usual, extreme = measured["bench"], measured["extreme"]
    return [form, *(_ulps(found) for found in (usual, extreme, usual.get("naive", {})))]


NO_DIGIT = 2.0**52
"""Units in the last place from which no digit is right."""


def _ulps(found: Mapping[str, Any]) -> str:
    """The worst error and at how many points, those lost as NaN or infinite in brackets."""
    if not found.get("points"):
        return "--"
    if found.get("worst_ulp", 0.0) >= NO_DIGIT:
        return "no digit"
    worst = f"{found['worst_ulp']:.2g}" if "worst_ulp" in found else ""
    lost = f" ({found['lost']} lost)" if found["lost"] else ""
    return rf"${power_of_ten(worst)}$\,/\,{found['points']}{lost}" if worst else f"all {found['lost']} lost"


def power_of_ten(text: str) -> str:
    """2.7e-51 as 2.7 x 10^-51."""
    mantissa, _, exponent = text.partition("e")
    if exponent and float(mantissa) == 0:
        return "0"
    return f"{mantissa}\\times10^{{{int(exponent)}}}" if exponent else text
