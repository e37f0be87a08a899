"""The second prover shows what the first one certified, and shares no code with it.

That it refuses what is false is asked in `test_false_entries`, of the entries that the first one refuses there.
"""

from __future__ import annotations

import ast
import sys
from dataclasses import replace
from pathlib import Path

import pytest
from false_entries import below, derived, record

import axiderive.verifier
from axiderive.verifier import reasons

FOLDER = Path(axiderive.verifier.__file__).parent
SAMPLE = (
    "cone", "paraboloid", "rounded_cone", "capped_cylinder", "concave_paraboloid", "paraboloid.fgm", "flat_punch.fgm",
    "cone.adh", "flat_punch.fgm.adh", "paraboloid.tan", "paraboloid.vis", "plane.parabola", "plane.truncated_wedge",
    "plane.eccentric_punch", "materials", "cone.sub",
)  # fmt: skip
AT_A_BREAK = {f"rounded_cone.{suffix}" for suffix in ("ad", "aF", "Fd", "dF", "U")}
NOT_SHOWN = {"materials.H", "materials.h_N", "cone.adh.aF", *AT_A_BREAK}
"""Of the sample, what no prover certifies."""


@pytest.mark.parametrize("problem", SAMPLE)
def test_what_the_first_prover_certifies_is_shown_again(problem: str) -> None:
    missing = reasons(record(problem, derived(problem)), below(problem))
    assert {f"{problem}.{suffix}" for suffix, reason in missing.items() if reason} <= NOT_SHOWN, missing


def test_what_rests_on_a_false_entry_is_not_shown() -> None:
    entries = derived("cone")
    false = {**entries, "d": replace(entries["d"], cases=entries["F"].cases)}
    missing = reasons(record("cone", false))
    assert all(missing[suffix] for suffix in ("d", "F", "p", "w", "k", "pm", "ad", "aF", "Fd", "dF"))


@pytest.mark.parametrize("status", ["integral", "root"])
def test_a_closed_formula_is_stored_as_one(status: str) -> None:
    entries = derived("cone")
    said = reasons(record("cone", {**entries, "k": replace(entries["k"], status=status)}))["k"]
    assert said.startswith("its status"), said


def test_it_imports_nothing_of_the_engine_and_no_computer_algebra() -> None:
    allowed = {*sys.stdlib_module_names, "flint"}
    for path in FOLDER.glob("*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Import):
                assert {alias.name.partition(".")[0] for alias in node.names} <= allowed, path
            if isinstance(node, ast.ImportFrom):
                assert node.level == 1 or (node.level == 0 and str(node.module).partition(".")[0] in allowed), path
