"""The command `axicontact check`: stored formulas verified and their functions measured again, nothing derived."""

from __future__ import annotations

import sys
import time
from collections.abc import Collection, Sequence
from pathlib import Path
from typing import Any

from ..build.verification import details, verify
from ..build.work import Settings, read_entries
from ..entry import Entry
from ..physics import systems
from ..physics.systems import Problem
from ..stable import records
from ..stable.measure import closure
from ..stable.records import drift
from ..store.index import evidence as stored_in
from ..store.index import load, table

HEAD = ["key", "status", "evidence"]


def check(keys: Sequence[str], folder: Path, settings: Settings, *, verbose: bool) -> bool:
    """Verify these keys (profiles, problems or single formulas; all if empty); whether all of them passed."""
    index = load()
    stored = folder if folder.is_dir() else index.folder.parent / "evidence"
    started, checked, failures = time.perf_counter(), 0, []
    rows: list[list[str]] = []
    for key, selected in index.wanted(keys).items():
        problem = systems.problem(key)
        record = stored_in(stored, key)
        entries = read_entries(problem, record["entries"])
        evidence = verify(problem, entries, settings)
        checked += len(selected)
        suffixes = [suffix for suffix in entries if f"{key}.{suffix}" in selected]
        failures += _drift(problem, entries, suffixes, record["evidence"], stored.parent)
        failures += [failure for failure in evidence["failures"] if failure["key"] in selected]
        for suffix, found in evidence["entries"].items():
            if f"{key}.{suffix}" in selected:
                rows.append([f"{key}.{suffix}", entries[suffix].status, found["summary"]])
                if verbose:
                    rows += [["", "", line] for line in details(found)]
    print(table([HEAD, *rows]))
    for failure in failures:
        print(f"FAILED {failure['key']}: {failure['message']}", file=sys.stderr)
    print(f"{checked} formulas, {len(failures)} failures, {time.perf_counter() - started:.1f} s, seed {settings.seed}")
    return not failures


def _drift(
    problem: Problem, entries: dict[str, Entry], suffixes: Collection[str], evidence: dict[str, Any], package: Path
) -> list[dict[str, str]]:
    """What the functions of the package below a folder err today and the stored record does not say."""
    if problem.system not in records.MEASURED:
        return []
    sources = {path.relative_to(package).as_posix(): path.read_text() for path in package.rglob("*.py")}
    if problem.module not in sources:
        return [{"key": problem.key, "message": f"there is no {package / problem.module}; run axicontact build"}]
    found = records.record(problem.key, closure(sources, problem.module), entries, suffixes)
    return [
        {"key": f"{problem.key}.{suffix}", "message": f"the measured errors have drifted: {line}"}
        for suffix, line in drift(evidence.get("evaluation", {}), found)
    ]
