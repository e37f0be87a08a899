"""What the README shows is what happens."""

from __future__ import annotations

import doctest
import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

from axiderive.book.evidence import MARKS, METHODS, TIMED, matrix_tables, timing_table, with_tables

README = Path(__file__).resolve().parents[1] / "README.md"
CATALOGUE = README.parent / "catalogue"
COMMANDS = re.findall(r"^\$ axicontact ((?:list|show)\b[^#\n]*)", README.read_text(), flags=re.M)


def test_examples_print_what_the_readme_says() -> None:
    result = doctest.testfile(str(README), module_relative=False)
    assert result.attempted > 10
    assert result.failed == 0


def test_an_altered_number_is_noticed(tmp_path: Path) -> None:
    altered = tmp_path / "README.md"
    altered.write_text(README.read_text().replace("peak 1416 MPa", "peak 1415 MPa"))
    assert altered.read_text() != README.read_text()
    assert doctest.testfile(str(altered), module_relative=False, report=False).failed == 1


@pytest.mark.parametrize("command", COMMANDS)
def test_commands_run(command: str) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "axiderive.cli", *command.split()],
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.strip()


def test_pictures_exist() -> None:
    for path in re.findall(r"!\[[^]]*\]\(([^)]+)\)", README.read_text()):
        assert (README.parent / path).is_file(), path


def test_the_matrix_is_that_of_the_catalogue() -> None:
    """Every profile of every physics has a cell, and none is empty."""
    found = json.loads((CATALOGUE / "axicontact" / "index.json").read_text())["matrix"]
    assert matrix_tables(found) in README.read_text()
    assert all(cell for cells in found["profiles"].values() for cell in cells.values())


def test_the_measurement_is_that_of_the_study() -> None:
    """Every method has a row, with the setting of the least error, and what mpmath does in 15 digits."""
    measured = json.loads((CATALOGUE / "evidence" / "study" / "error.json").read_text())
    table = timing_table(measured)
    assert table in README.read_text()
    _, _, own, *others = table.splitlines()
    assert own.split("|")[2] == " 1 "
    assert len(others) == len(METHODS) - 1
    rows = [r for r in measured["rows"] if (r["key"], r["method"]) == (TIMED, "Gauss-Jacobi")]
    least = min(rows, key=lambda row: row["worst"])
    (line,) = [line for line in others if line.startswith("| Gauss")]
    assert line.split("|")[1].endswith(f", {least['setting']} ")
    assert all(len(line.split("|")) == 5 for line in others)


def test_a_readme_without_its_marks_stays_as_it_is() -> None:
    assert with_tables("# title\n", {"profiles": {}, "legend": {}}, None) == "# title\n"
    begin, end = (mark.format("matrix") for mark in MARKS)
    text = f"head\n{begin}\nold\n{end}\ntail\n"
    assert "old" not in with_tables(text, {"profiles": {}, "legend": {}}, None)
    assert with_tables(text, {"profiles": {}, "legend": {}}, None).endswith(f"{end}\ntail\n")
