"""The second prover shows what the first one certified, refuses what is false, and shares no code with it."""

from __future__ import annotations

import ast
import functools
import re
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from false_entries import PROBLEMS, FalseEntry, derived, difference, of

import axiderive.verifier
from axiderive.entry import Entry
from axiderive.physics import systems
from axiderive.store.records import ReadingError, RecordError, entry_record, profile_record
from axiderive.verifier import reasons, rests_on
from axiderive.verifier.problem import Problem
from axiderive.verifier.rules import rule_of

FOLDER = Path(axiderive.verifier.__file__).parent
SAMPLE = (
    "cone", "paraboloid", "rounded_cone", "capped_cylinder", "concave_paraboloid", "paraboloid.fgm", "flat_punch.fgm",
    "cone.adh", "flat_punch.fgm.adh", "paraboloid.tan", "paraboloid.vis", "plane.parabola", "plane.truncated_wedge",
    "plane.eccentric_punch", "materials",
)  # fmt: skip
NOT_SHOWN = {"materials.H", "materials.h_N", "cone.adh.aF", *(f"rounded_cone.{s}" for s in ("ad", "aF", "Fd", "dF"))}
"""Of the sample, what no prover certifies."""
QUICK = (
    "paraboloid",
    "flat_punch",
    "paraboloid.fgm",
    "cone.adh",
    "paraboloid.tan",
    "plane.eccentric_punch",
    "materials",
)
OUTSIDE = re.compile(r"\bk = -?[1-9]\d*\b(?!/)")
"""A point where the theory does not hold, -1 < k < 1: what is false only there is not false."""


def record(problem: str, entries: dict[str, Entry]) -> dict[str, Any]:
    profile = profile_record(systems.problem(problem).profile)
    return {"problem": problem, "profile": profile, "entries": {s: entry_record(e) for s, e in entries.items()}}


@functools.cache
def below(problem: str) -> dict[str, Any] | None:
    plain = rests_on(problem)
    return record(plain, derived(plain)) if plain else None


@pytest.mark.parametrize("problem", SAMPLE)
def test_what_the_first_prover_certifies_is_shown_again(problem: str) -> None:
    missing = reasons(record(problem, derived(problem)), below(problem))
    assert {f"{problem}.{suffix}" for suffix, reason in missing.items() if reason} <= NOT_SHOWN, missing


def refused(found: FalseEntry) -> bool:
    try:
        stored = record(found.problem, found.entries)
    except (RecordError, ReadingError, StopIteration):
        # what cannot be stored is never read
        return True
    plain = below(found.problem)
    # what `reasons` asks of every quantity of the problem, of this one alone and of what it rests on
    return bool(Problem(stored, rule_of, Problem(plain, rule_of) if plain else None).prove(found.suffix))


@pytest.mark.parametrize(
    "problem", [pytest.param(key, marks=() if key in QUICK else pytest.mark.sweep) for key in PROBLEMS]
)
def test_no_false_entry_is_shown(problem: str) -> None:
    accepted = [found for found in of(problem) if not refused(found) and not OUTSIDE.search(difference(found))]
    assert not accepted, "\n".join(found.text() for found in accepted)


def test_what_rests_on_a_false_entry_is_not_shown() -> None:
    entries = derived("cone")
    false = {**entries, "d": replace(entries["d"], cases=entries["F"].cases)}
    missing = reasons(record("cone", false))
    assert all(missing[suffix] for suffix in ("d", "F", "p", "w", "k", "pm", "ad", "aF", "Fd", "dF"))


def test_it_imports_nothing_of_the_engine_and_no_computer_algebra() -> None:
    allowed = {*sys.stdlib_module_names, "flint"}
    for path in FOLDER.glob("*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Import):
                assert {alias.name.partition(".")[0] for alias in node.names} <= allowed, path
            if isinstance(node, ast.ImportFrom):
                assert node.level == 1 or (node.level == 0 and str(node.module).partition(".")[0] in allowed), path
