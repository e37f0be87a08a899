"""What the README shows is what happens."""

from __future__ import annotations

import doctest
import re
import subprocess
import sys
from pathlib import Path

import pytest

README = Path(__file__).resolve().parents[1] / "README.md"
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
        timeout=60,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.strip()


def test_pictures_exist() -> None:
    for path in re.findall(r"!\[[^]]*\]\(([^)]+)\)", README.read_text()):
        assert (README.parent / path).is_file(), path


def test_the_matrix_is_that_of_the_catalogue() -> None:
    """Every profile of every physics has a cell, and none is empty."""
    import json

    from axiderive.emit.matrix import markdown

    found = json.loads((README.parent / "catalogue" / "axicontact" / "index.json").read_text())["matrix"]
    assert markdown(found) in README.read_text()
    assert all(cell for cells in found["profiles"].values() for cell in cells.values())
