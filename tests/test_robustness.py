"""Builds that are killed, run twice at once or elsewhere: nothing is lost or half written, the next one is right."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest
from stored_book import kernels

HANGS = 600
"""Seconds after which a build counts as hanging: it takes a few, and a minute where many share the machine."""

ARGUMENTS = ["build", "--only", "loads.uniform,loads.hertzian,loads.punch", "--no-pdf", "--points", "4"]
# the folder of the project holds cache and catalogue; here each build gets one of its own, and is killed with all of
# its workers when it has touched that folder so many times, and so many seconds have passed since
PROGRAM = """
import os, signal, sys, time
from pathlib import Path
from threading import Thread
from axiderive import cli
from axiderive.code import python
from axiderive.commands import build as commands
root, steps = sys.argv[1], 0
last, pause = int(os.environ.get("LAST_STEP", 0)), float(os.environ.get("PAUSE", 0))

def die():
    time.sleep(pause)
    os.killpg(0, signal.SIGKILL)

def count(event, given):
    global steps
    if event in ("open", "os.rename", "os.mkdir") and str(given[0]).startswith(root):
        steps += 1
        if steps == last:
            Thread(target=die, daemon=True).start() if pause else die()

commands.project_root = lambda: Path(root)
# fitted anew in every build they would take longer than all the rest of it
python.kernels_source = lambda: {kernels!r}
if __name__ == "__main__":
    sys.addaudithook(count)
    code = cli.main(sys.argv[2:])
    if 0 < last <= steps:
        os.killpg(0, signal.SIGKILL)  # at the latest: the pause is longer than what was left
    print(steps, "steps", file=sys.stderr)
    sys.exit(code)
"""
EARLY = 40
"""Steps of a build by which everything is derived and verified, and nothing is published."""


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("program") / "build.py"
    path.write_text(PROGRAM.replace("{kernels!r}", repr(kernels())))
    return path


def start(program: Path, root: Path, *more: str, **options: object) -> subprocess.Popen[str]:
    root.mkdir(exist_ok=True)
    command = [sys.executable, str(program), str(root), *ARGUMENTS, *(more or ("--jobs", "1"))]
    return subprocess.Popen(
        command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options
    )  # type: ignore[call-overload,no-any-return]


def finish(process: subprocess.Popen[str]) -> int:
    """How many steps the build took."""
    out, err = process.communicate(timeout=HANGS)
    assert process.returncode == 0, out + err
    return int(err.split()[-2])


def written(root: Path) -> dict[str, bytes]:
    catalogue = root / "catalogue"
    return {p.relative_to(catalogue).as_posix(): p.read_bytes() for p in catalogue.rglob("*") if p.is_file()}


@dataclass(frozen=True)
class Reference:
    """What an undisturbed build writes, and its steps in a new folder and in one where all is there."""

    files: dict[str, bytes]
    anew: int
    again: int

    def steps(self, root: Path) -> int:
        """Steps that a build takes from where the last one was stopped, by the files that are missing."""
        missing = len(self.files.keys() - written(root).keys()) / len(self.files)
        return self.again + int(missing * (self.anew - self.again))


@pytest.fixture(scope="module")
def reference(program: Path, tmp_path_factory: pytest.TempPathFactory) -> Reference:
    root = tmp_path_factory.mktemp("reference")
    anew = finish(start(program, root))
    files = written(root)
    again = finish(start(program, root))
    assert written(root) == files
    return Reference(files, anew, again)


def killed_builds(program: Path, root: Path, reference: Reference, count: int, seed: int) -> int:
    """Builds killed at a random step or soon after, each with all of its workers; how many did not come to an end."""
    dice, hit = random.Random(seed), 0
    for i in range(count):
        steps = reference.steps(root)
        last = dice.randint(1, min(steps, dice.choice((EARLY, steps))))
        pause = dice.choice((0.0, dice.uniform(0.0, 0.02), 0.0 if i else dice.uniform(0.0, 1.0)))
        environment = {**os.environ, "LAST_STEP": str(last), "PAUSE": str(pause)}
        process = start(program, root, "--jobs", str(1 + i % 2), start_new_session=True, env=environment)
        _, err = process.communicate(timeout=HANGS)
        assert process.returncode in (0, -signal.SIGKILL), err
        hit += process.returncode != 0
    return hit


@pytest.mark.parametrize(
    "count", [pytest.param(10, marks=pytest.mark.slow), pytest.param(100, marks=pytest.mark.sweep)]
)
def test_a_killed_build_is_recovered(program: Path, tmp_path: Path, reference, count: int) -> None:
    """Every tenth run starts anew, so that early phases are hit as well as late ones."""
    hit, together = 0, min(count, 10)
    for i in range(0, count, together):
        root = tmp_path / str(i)
        hit += killed_builds(program, root, reference, together, i)
        finish(start(program, root))
        assert written(root) == reference.files
    # with two processes a sixth of the steps are those of the workers, so that a few builds come to their end
    assert hit >= 0.9 * count - 1


@pytest.mark.slow
def test_two_builds_at_once_in_one_folder(program: Path, tmp_path: Path, reference) -> None:
    both = [start(program, tmp_path), start(program, tmp_path)]
    for process in both:
        finish(process)
    assert written(tmp_path) == reference.files


def test_truncated_cache_files_are_made_anew(program: Path, tmp_path: Path, reference) -> None:
    finish(start(program, tmp_path))
    for i, path in enumerate(sorted((tmp_path / ".cache").rglob("*.json"))):
        content = path.read_bytes()
        path.write_bytes(content[: len(content) // 2] if i % 2 else b"\0" * len(content))
    finish(start(program, tmp_path))
    assert written(tmp_path) == reference.files


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
    assert written(root) == reference.files


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
    assert written(tmp_path) == reference.files
