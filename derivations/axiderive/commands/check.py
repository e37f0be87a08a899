"""The commands `axicontact check` and `axicontact verify`: nothing is derived.

The first verifies the stored formulas and measures their functions again, the second proves the formulas by the second
prover, without the first.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Collection, Mapping
from functools import partial
from pathlib import Path
from typing import Any

from ..build.pool import run
from ..build.verification import details
from ..build.verification import verify as verified
from ..build.work import Settings, project_root, read_entries
from ..entry import Entry
from ..exits import FAILED
from ..physics import systems
from ..physics.systems import Problem
from ..stable import records
from ..stable.measure import closure
from ..stable.records import drift
from ..store.index import Index, NoCatalogueError, evidence, load, table
from ..verifier import reasons, rests_on

HEAD = ["key", "status", "evidence"]


def check(arguments: argparse.Namespace) -> int:
    """Verify the keys asked for (profiles, problems or single formulas; all if none is); 0 if all of them passed."""
    if arguments.keys == ["chapter"]:
        return _chapter(arguments)
    settings = Settings(arguments.digits, arguments.points, arguments.seed)
    index, stored = _stored()
    started, checked, failures = time.perf_counter(), 0, []
    rows: list[list[str]] = []
    for key, selected in index.wanted(arguments.keys).items():
        problem = systems.problem(key)
        record = evidence(stored, key)
        entries = read_entries(problem, record["entries"])
        found = verified(problem, entries, settings)
        checked += len(selected)
        suffixes = [suffix for suffix in entries if f"{key}.{suffix}" in selected]
        failures += _drift(problem, entries, suffixes, record["evidence"], stored.parent)
        failures += [failure for failure in found["failures"] if failure["key"] in selected]
        for suffix in suffixes:
            own = found["entries"][suffix]
            rows.append([f"{key}.{suffix}", entries[suffix].status, own["summary"]])
            if arguments.verbose:
                rows += [["", "", line] for line in details(own)]
    print(table([HEAD, *rows]))
    for failure in failures:
        print(f"FAILED {failure['key']}: {failure['message']}", file=sys.stderr)
    print(f"{checked} formulas, {len(failures)} failures, {time.perf_counter() - started:.1f} s, seed {settings.seed}")
    return FAILED if failures else 0


def _chapter(arguments: argparse.Namespace) -> int:
    """The equations of chapter 11, with as many digits as the numerical checks carry."""
    from ..chapter11.equation import GUARD, report

    runner = partial(run, jobs=arguments.jobs, ordered=True)
    return 0 if report(max(arguments.digits - GUARD, GUARD), arguments.seed, runner) else FAILED


def _stored() -> tuple[Index, Path]:
    """The index, and the evidence of the checkout or else that beside the package."""
    index, own = load(), project_root() / "catalogue" / "evidence"
    return index, own if own.is_dir() else index.folder.parent / "evidence"


def _drift(
    problem: Problem, entries: dict[str, Entry], suffixes: Collection[str], known: dict[str, Any], package: Path
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
        for suffix, line in drift(known.get("evaluation", {}), found)
    ]


def verify(arguments: argparse.Namespace) -> int:
    """Prove the keys asked for (all if none is); 0 if all was shown that the evidence says is."""
    index, stored = _stored()
    started, rows, failures, counts = time.perf_counter(), list[list[str]](), list[str](), [0, 0]
    for key, selected in index.wanted(arguments.keys).items():
        record, below = _read(stored, key), rests_on(key)
        missing = reasons(record, _read(stored, below) if below else None)
        for suffix, proof in record["evidence"]["entries"].items():
            if f"{key}.{suffix}" not in selected or not proof["certified"]:
                continue
            cases, reason = len(record["entries"][suffix]["cases"]), missing[suffix]
            counts = [counts[0] + (0 if reason else cases), counts[1] + cases]
            rows.append([f"{key}.{suffix}", f"by the first prover only: {reason}" if reason else "shown by both"])
            if reason and proof["twice"]["shown"]:
                failures.append(f"{key}.{suffix}: {reason}")
    print(table([["key", "certified"], *rows]))
    for failure in failures:
        print(f"FAILED {failure}", file=sys.stderr)
    print(f"{counts[0]} of {counts[1]} certified cases checked twice, {time.perf_counter() - started:.1f} s")
    return FAILED if failures else 0


def _read(folder: Path, key: str) -> Mapping[str, Any]:
    record = evidence(folder, key)
    if "profile" not in record or any("twice" not in entry for entry in record["evidence"]["entries"].values()):
        message = f"the evidence of {key} holds nothing for a second prover; run axicontact build"
        raise NoCatalogueError(message)
    return record
