"""Builds that are killed, run twice at once or elsewhere: nothing is lost or half written, the next one is right."""

from __future__ import annotations

import contextlib
import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

HANGS = 600
"""Seconds after which a build counts as hanging: it takes a few, and a minute where many share the machine."""

ARGUMENTS = ["build", "--only", "loads.uniform,loads.hertzian,loads.punch", "--no-pdf", "--points", "4"]
# the folder of the project holds cache and catalogue; here each build gets one of its own
PROGRAM = """
import sys
from pathlib import Path
from axiderive import cli, commands
commands.project_root = lambda: Path(sys.argv[1])
if __name__ == "__main__":
    sys.exit(cli.main(sys.argv[2:]))
"""


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("program") / "build.py"
    path.write_text(PROGRAM)
    return path


def start(program: Path, root: Path, *more: str, **options: object) -> subprocess.Popen[str]:
    root.mkdir(exist_ok=True)
    command = [sys.executable, str(program), str(root), *ARGUMENTS, *(more or ("--jobs", "1"))]
    return subprocess.Popen(
        command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options
    )  # type: ignore[call-overload,no-any-return]


def finish(process: subprocess.Popen[str]) -> None:
    out, err = process.communicate(timeout=HANGS)
    assert process.returncode == 0, out + err


def written(root: Path) -> dict[str, bytes]:
    catalogue = root / "catalogue"
    return {p.relative_to(catalogue).as_posix(): p.read_bytes() for p in catalogue.rglob("*") if p.is_file()}


@pytest.fixture(scope="module")
def reference(program: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[dict[str, bytes], float]:
    """What an undisturbed build writes, and how long it takes."""
    root = tmp_path_factory.mktemp("reference")
    begun = time.monotonic()
    finish(start(program, root))
    return written(root), time.monotonic() - begun


def killed_builds(program: Path, root: Path, seconds: float, count: int, seed: int) -> int:
    """Builds killed at random moments, each with all of its workers; how many were still running."""
    dice, hit = random.Random(seed), 0
    for i in range(count):
        process, begun = start(program, root, "--jobs", str(1 + i % 2), start_new_session=True), time.monotonic()
        try:
            process.wait(dice.uniform(0.1, 1.1) * seconds)
            # a warm cache, or a machine that has become idle: the next one is killed sooner
            seconds = min(seconds, time.monotonic() - begun)
        except subprocess.TimeoutExpired:
            hit += 1
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
    return hit


@pytest.mark.parametrize("count", [4, pytest.param(100, marks=pytest.mark.slow)])
def test_a_killed_build_is_recovered(program: Path, tmp_path: Path, reference, count: int) -> None:
    """A fifth of the runs starts anew, so that early phases are hit as well as late ones."""
    files, seconds = reference
    hit = 0
    for i in range(0, count, 4):
        root = tmp_path / str(i)
        hit += killed_builds(program, root, seconds, 4, i)
        finish(start(program, root))
        assert written(root) == files
    assert hit >= count // 4


def test_two_builds_at_once_in_one_folder(program: Path, tmp_path: Path, reference) -> None:
    both = [start(program, tmp_path), start(program, tmp_path)]
    for process in both:
        finish(process)
    assert written(tmp_path) == reference[0]


def test_truncated_cache_files_are_made_anew(program: Path, tmp_path: Path, reference) -> None:
    finish(start(program, tmp_path))
    for i, path in enumerate(sorted((tmp_path / ".cache").rglob("*.json"))):
        content = path.read_bytes()
        path.write_bytes(content[: len(content) // 2] if i % 2 else b"\0" * len(content))
    finish(start(program, tmp_path))
    assert written(tmp_path) == reference[0]


@pytest.mark.parametrize(
    "environment",
    [
        {"PYTHONHASHSEED": "1", "TZ": "Pacific/Auckland", "LC_ALL": "C", "PYTHONUTF8": "0"},
        pytest.param({"PYTHONHASHSEED": "77", "LC_ALL": "tr_TR.UTF-8"}, marks=pytest.mark.slow),
    ],
    ids=["time zone", "locale"],
)
def test_bytes_do_not_depend_on_the_environment(program: Path, tmp_path: Path, reference, environment) -> None:
    root = tmp_path / "with space, ümlaut"
    finish(start(program, root, "--jobs", "2", env={**os.environ, **environment}, cwd=tmp_path))
    assert written(root) == reference[0]


def test_a_disk_that_fills_up_leaves_the_old_catalogue(program: Path, tmp_path: Path, reference) -> None:
    """No file may grow beyond 2 kB: the write fails in the middle, as on a full disk."""
    finish(start(program, tmp_path))
    module = tmp_path / "catalogue/axicontact/loads/uniform.py"
    module.write_text("# old\n")
    before = written(tmp_path)
    limited = (
        "import resource, signal; signal.signal(signal.SIGXFSZ, signal.SIG_IGN);"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000)); import runpy, sys;"
        "sys.argv = sys.argv[1:]; runpy.run_path(sys.argv[0], run_name='__main__')"
    )
    done = subprocess.run(
        [sys.executable, "-c", limited, str(program), str(tmp_path), *ARGUMENTS, "--jobs", "1", "--fresh"],
        stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=HANGS, check=False,
    )  # fmt: skip
    assert done.returncode == 3, done.stderr
    assert "File too large" in done.stderr
    assert written(tmp_path) == before
    finish(start(program, tmp_path))
    assert written(tmp_path) == reference[0]
