"""Builds that are killed, run twice at once or elsewhere: nothing is lost or half written, the next one is right."""

from __future__ import annotations

import os
import random
import resource
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import pytest
from stored_book import kernels

from axiderive import cli
from axiderive.commands import build
from axiderive.store import sources
from axiderive.store.cache import Cache

HANGS = 600
"""Seconds after which a build counts as hanging: it takes a few, and a minute where many share the machine."""

ARGUMENTS = [
    "build",
    "--only",
    "loads.uniform,loads.hertzian,loads.punch",
    "--no-pdf",
    "--points",
    "4",
    "--digits",
    "20",
]
# the folder of the project holds cache and catalogue; here each build gets one of its own, and is killed with all of
# its workers when it has touched that folder so many times, and so many seconds have passed since
PROGRAM = """
import os, signal, sys, time
from pathlib import Path
from threading import Thread
from axiderive import cli
from axiderive.code import tables
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
tables.kernels_source = lambda: {kernels!r}
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
    # by its contents what each file of the engine says, which takes every process two seconds to read
    known = Cache(Path(__file__).parents[1] / ".cache").get(sources._KEPT.key)
    if known is not None and not (root / ".cache").exists():
        Cache(root / ".cache").put(sources._KEPT.key, known)
    command = [sys.executable, str(program), str(root), *ARGUMENTS, *(more or ("--jobs", "1"))]
    return subprocess.Popen(
        command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options
    )  # type: ignore[call-overload,no-any-return]


def finish(process: subprocess.Popen[str]) -> int:
    """How many steps the build took."""
    out, err = process.communicate(timeout=HANGS)
    assert process.returncode == 0, out + err
    return int(err.split()[-2])


def built(root: Path, *more: str) -> int:
    """The exit code of a build in this process: what is tested is the folder, and a process takes seconds to start."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(build, "project_root", lambda: root)
        return cli.main([*ARGUMENTS, "--jobs", "1", *more])


def written(root: Path) -> dict[str, bytes]:
    catalogue = root / "catalogue"
    return {p.relative_to(catalogue).as_posix(): p.read_bytes() for p in catalogue.rglob("*") if p.is_file()}


@dataclass(frozen=True)
class Steps:
    """Steps of an undisturbed build in a new folder and in one where all is there."""

    anew: int
    again: int

    def left(self, root: Path, files: dict[str, bytes]) -> int:
        """Steps that a build takes from where the last one was stopped, by the files that are missing."""
        missing = len(files.keys() - written(root).keys()) / len(files)
        return self.again + int(missing * (self.anew - self.again))


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder that an undisturbed build has filled, which is only read."""
    root = tmp_path_factory.mktemp("reference")
    assert built(root) == 0
    return root


@pytest.fixture(scope="module")
def reference(whole: Path) -> dict[str, bytes]:
    """What an undisturbed build writes."""
    return written(whole)


@pytest.fixture
def filled(whole: Path, tmp_path: Path) -> Path:
    """The same folder at another place, with its cache."""
    return shutil.copytree(whole, tmp_path / "filled")


@pytest.fixture(scope="module")
def steps(program: Path, reference: dict[str, bytes], tmp_path_factory: pytest.TempPathFactory) -> Steps:
    root = tmp_path_factory.mktemp("steps")
    anew = finish(start(program, root))
    assert written(root) == reference
    again = finish(start(program, root))
    assert written(root) == reference
    return Steps(anew, again)


def killed_builds(program: Path, root: Path, steps: Steps, files: dict[str, bytes], count: int, seed: int) -> int:
    """Builds killed at a random step or soon after, each with all of its workers; how many did not come to an end."""
    dice, hit = random.Random(seed), 0
    for i in range(count):
        left = steps.left(root, files)
        last = dice.randint(1, min(left, dice.choice((EARLY, left))))
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
def test_a_killed_build_is_recovered(program: Path, tmp_path: Path, reference, steps, count: int) -> None:
    """Every tenth run starts anew, so that early phases are hit as well as late ones."""
    hit, together = 0, min(count, 10)
    for i in range(0, count, together):
        root = tmp_path / str(i)
        hit += killed_builds(program, root, steps, reference, together, i)
        finish(start(program, root))
        assert written(root) == reference
    # with two processes a sixth of the steps are those of the workers, so that a few builds come to their end
    assert hit >= 0.9 * count - 1


@pytest.mark.slow
def test_two_builds_at_once_in_one_folder(program: Path, tmp_path: Path, reference) -> None:
    both = [start(program, tmp_path), start(program, tmp_path)]
    for process in both:
        finish(process)
    assert written(tmp_path) == reference


def test_what_is_there_is_not_written_again(filled: Path, reference) -> None:
    before = {path: path.stat().st_mtime_ns for path in filled.rglob("*") if path.is_file()}
    assert built(filled) == 0
    assert {path: path.stat().st_mtime_ns for path in filled.rglob("*") if path.is_file()} == before
    assert written(filled) == reference


def test_truncated_cache_files_are_made_anew(filled: Path, reference) -> None:
    # what this process knows already of the sources of the engine it does not ask for again
    cached = [path for path in sorted((filled / ".cache").rglob("*.json")) if path.stem != sources._KEPT.key]
    sizes = [path.stat().st_size for path in cached]
    for i, path in enumerate(cached):
        content = path.read_bytes()
        path.write_bytes(content[: len(content) // 2] if i % 2 else b"\0" * len(content))
    shutil.rmtree(filled / "catalogue")
    assert built(filled) == 0
    assert written(filled) == reference
    # to the digit of the seconds that a step has taken, which are stored beside its result
    assert [path.stat().st_size for path in cached] == pytest.approx(sizes, abs=4)
    assert not any(b"\0" in path.read_bytes() for path in cached)


@pytest.mark.parametrize(
    ("environment", "jobs"),
    [
        # without workers, which have a hash seed of their own
        ({"PYTHONHASHSEED": "1", "TZ": "Pacific/Auckland", "LC_ALL": "C", "PYTHONUTF8": "0"}, "1"),
        pytest.param({"PYTHONHASHSEED": "77", "LC_ALL": "tr_TR.UTF-8"}, "2", marks=pytest.mark.slow),
    ],
    ids=["time zone", "locale"],
)
def test_bytes_do_not_depend_on_the_environment(
    program: Path, tmp_path: Path, reference, environment, jobs: str
) -> None:
    root = tmp_path / "with space, ümlaut"
    finish(start(program, root, "--jobs", jobs, env={**os.environ, **environment}, cwd=tmp_path))
    assert written(root) == reference


@contextmanager
def small_files_only() -> Iterator[None]:
    """No file of this process may grow beyond 1 kB: a write fails in the middle, as on a full disk."""
    limits, handler = resource.getrlimit(resource.RLIMIT_FSIZE), signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, limits[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
        signal.signal(signal.SIGXFSZ, handler)


@pytest.mark.parametrize("more", [["--fresh"], []], ids=["while it derives", "while it publishes"])
def test_a_disk_that_fills_up_leaves_the_old_catalogue(filled: Path, reference, capsys, more: list[str]) -> None:
    module = filled / "catalogue/axicontact/loads/uniform.py"
    module.write_text("# old\n")
    before = written(filled)
    with small_files_only():
        assert built(filled, *more) == 3
    assert "File too large" in capsys.readouterr().err
    assert written(filled) == before
    assert built(filled) == 0
    assert written(filled) == reference
