"""The distribution: what the wheel carries, what importing costs, and that the house has the roots it says it has."""

from __future__ import annotations

import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())


def run(*arguments, **options):
    return subprocess.run(
        [sys.executable, *arguments], capture_output=True, text=True, timeout=600, check=True, **options
    )


def test_source_roots_are_no_packages():
    """PyPI has a `catalogue` (spaCy needs it); a package of that name here would clobber it."""
    assert not (ROOT / "derivations" / "__init__.py").exists()
    assert not (ROOT / "catalogue" / "__init__.py").exists()


def test_only_numpy_is_needed_to_evaluate():
    assert [text.split(">")[0] for text in PROJECT["project"]["dependencies"]] == ["numpy"]


def test_both_packages_are_importable_and_light():
    code = "import sys, axiderive, axicontact; print(sorted({'sympy', 'scipy', 'mpmath', 'jinja2'} & set(sys.modules)))"
    assert run("-c", code).stdout == "[]\n"


@pytest.mark.slow
def test_wheel_holds_both_packages_and_the_index(tmp_path):
    """Built and installed into an empty folder, the command answers from the index inside."""
    wheel_arguments = ("wheel", "--quiet", "--no-deps", "--wheel-dir", str(tmp_path), str(ROOT))
    run("-m", "pip", *wheel_arguments, stdin=subprocess.DEVNULL)
    (wheel,) = tmp_path.glob("axicontact-*.whl")
    names = zipfile.ZipFile(wheel).namelist()
    tops = {name.split("/")[0] for name in names}
    assert {top for top in tops if not top.endswith(".dist-info")} == {"axiderive", "axicontact"}
    assert "axicontact/index.json" in names
    assert "axicontact/normal/cone.py" in names
    assert any(name.startswith("axiderive/book/templates/") for name in names)
    target = tmp_path / "site"
    run("-m", "pip", "install", "--quiet", "--no-deps", "--target", str(target), str(wheel), stdin=subprocess.DEVNULL)
    code = f"import sys; sys.path.insert(0, {str(target)!r}); from axiderive.cli import main; main(['show', 'cone.F'])"
    shown = run("-S", "-c", code, cwd=tmp_path).stdout
    assert shown.startswith("cone.F  Normal force [N]")


def test_makefile_and_ci_need_no_input():
    """A recipe that could wait for input would hang a fresh machine."""
    lines = [
        line for line in (ROOT / "Makefile").read_text().splitlines() if line.startswith("\t") and "$(PY) -m" in line
    ]
    assert lines
    assert all("</dev/null" in line for line in lines)
    assert "set -euo pipefail" in (ROOT / ".ci" / "run").read_text()
