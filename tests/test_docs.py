"""What the pages of docs/ and the examples show is what happens."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
PAGES = {"tasks.md": ("scipy",), "many_machines.md": ("dask", "xarray")}
"""What a page needs beside NumPy."""
TEXTS = [ROOT / "README.md", ROOT / "examples" / "README.md", *(ROOT / "docs").glob("*.md")]


def needs(*packages: str) -> None:
    """Skip where one is not installed."""
    for package in packages:
        if find_spec(package) is None:
            pytest.skip(f"{package} is not installed: pip install '.[examples]'")


def ran(*arguments: str | Path, cwd: Path) -> str:
    """What Python prints, in a process and a folder of its own."""
    command = [sys.executable, *map(str, arguments)]
    done = subprocess.run(command, cwd=cwd, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.mark.parametrize("page", PAGES)
def test_examples_of_a_page_print_what_it_says(page: str, tmp_path: Path) -> None:
    needs(*PAGES[page])
    ran("-m", "doctest", ROOT / "docs" / page, cwd=tmp_path)


def test_no_task_needs_more_than_five_lines() -> None:
    """Imports and measurements apart; a definition counts with its body."""
    text = (ROOT / "docs" / "tasks.md").read_text()
    tasks = re.split(r"^## ", text, flags=re.MULTILINE)[1:]
    assert len(tasks) == 12
    for task in tasks:
        lines = re.findall(r"^(?:>>>|\.\.\.|\$) (.*)", task, flags=re.MULTILINE)
        own = [line for line in lines if not line.startswith(("import", "from", "z = ", "F = 20"))]
        assert 1 <= len(own) <= 5, task


def test_links_lead_somewhere() -> None:
    for path in TEXTS:
        for target in re.findall(r"\]\((?!https?:)([^)#]+)\)", path.read_text()):
            assert (path.parent / target).exists(), (path, target)


def test_the_code_of_an_executor_is_python() -> None:
    """It needs a scheduler, and a test of a cluster is in `test_executors.py`; the commands are those of the parser."""
    text = (ROOT / "docs" / "many_machines.md").read_text()
    (code,) = (code for code in re.findall(r"```python\n(.*?)```", text, flags=re.DOTALL) if ">>>" not in code)
    compile(code, "my_cluster.py", "exec")
    shown = set(re.findall(r"--[a-z]+", "".join(re.findall(r"axicontact [^`|\n]*", text))))
    assert shown >= {"--from", "--executor"}
    said = "".join(ran("-m", "axiderive.cli", command, "--help", cwd=ROOT) for command in ("derive", "build"))
    assert all(option in said for option in shown)


def numbers(line: str) -> list[float]:
    """The numbers in a line of a table."""
    return [float(word) for word in line.split() if re.fullmatch(r"-?\d+\.\d+", word)]


def test_a_force_curve_is_fitted_within_its_deviations(tmp_path: Path) -> None:
    """The table says the truth, what the fit found, and how far that may be off."""
    needs("scipy", "matplotlib")
    said = ran(ROOT / "examples" / "force_curve.py", "--points", "300", cwd=tmp_path)
    rows = {line.split()[0]: numbers(line) for line in said.splitlines() if len(numbers(line)) == 3}
    assert set(rows) == {"E_star", "z_0", "R", "dgamma"}
    for true, found, deviation in rows.values():
        assert abs(found - true) < 4 * deviation
        assert 0 < deviation < 0.1 * true
    assert "</svg>" in (tmp_path / "force_curve.svg").read_text()


def check_map(said: str) -> None:
    """The errors are those that the deviations promise, and those of the fits one by one."""
    rows = {line[:20].strip(): numbers(line[20:]) for line in said.splitlines() if len(numbers(line[20:])) == 2}
    for error, deviation in zip(rows["rms error"], rows["as deviations say"], strict=True):
        assert abs(error / deviation - 1) < 0.05
    # a hundredth of the deviation is nothing: the error grows by the square of it
    assert max(rows["most apart"]) < 0.03


def test_a_map_of_curves_has_the_error_of_single_fits(tmp_path: Path) -> None:
    needs("scipy", "matplotlib")
    check_map(ran(ROOT / "examples" / "force_map.py", "--curves", "4000", "--compared", "30", cwd=tmp_path))
    assert (tmp_path / "force_map.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.slow
def test_a_map_has_the_same_bits_on_a_cluster(tmp_path: Path) -> None:
    """A last block that is not full is another product."""
    needs("scipy", "matplotlib", "distributed")
    said = ran(ROOT / "examples" / "force_map.py", "--curves", "20500", "--workers", "2", cwd=tmp_path)
    check_map(said)
    assert "2 workers: the same bits" in said


def test_a_contact_law_in_c_gives_the_work_of_the_impact(tmp_path: Path) -> None:
    needs("scipy")
    if shutil.which("cc") is None:
        pytest.skip("no C compiler: apt-get install gcc libc6-dev")
    said = ran(ROOT / "examples" / "particles.py", "--folder", tmp_path / "law", cwd=tmp_path)
    assert "6 values agree" in said
    (energy, work) = re.search(r"energy of the impact (\S+) uJ, work by Python (\S+) uJ", said).groups()
    (in_c,) = re.search(r"work (\S+) uJ\n", said).groups()
    assert energy == work == in_c == "0.1625"
    if find_spec("numba"):
        looped, by_numpy = re.search(r"loop of Numba (\S+) N, by NumPy (\S+) N", said).groups()
        assert looped == by_numpy
