"""Work on many machines: the same bytes by every executor, also after a worker died, and one process that writes."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from concurrent.futures import BrokenExecutor, Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from contextlib import contextmanager
from importlib.util import find_spec
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import pytest

from axiderive import cli
from axiderive.build import catalogue, pool, work
from axiderive.build.work import Settings
from axiderive.commands import scene
from axiderive.exits import CommandError
from axiderive.physics.systems import problem
from axiderive.store.cache import Cache
from axiderive.study import extremes

IDS = ["loads.uniform", "loads.hertzian"]
QUICK = Settings(digits=20, points=4)


class Inline(Executor):
    """Runs a task where it is asked for; the simplest executor there is."""

    def submit(self, function: Callable[..., Any], /, *task: Any, **named: Any) -> Future[Any]:
        future: Future[Any] = Future()
        try:
            future.set_result(function(*task, **named))
        except BaseException as error:
            future.set_exception(error)
        return future


class Broken(Inline):
    """What it is given is lost."""

    def submit(self, function: Callable[..., Any], /, *task: Any, **named: Any) -> Future[Any]:
        future: Future[Any] = Future()
        future.set_exception(BrokenExecutor("three machines are gone"))
        return future


class Forgetful(Inline):
    """Takes no more work."""

    def submit(self, function: Callable[..., Any], /, *task: Any, **named: Any) -> Future[Any]:
        message = "after shutdown"
        raise RuntimeError(message)


@contextmanager
def two_processes() -> Iterator[Executor]:
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as executor:
        yield executor


def built(folder: Path, jobs: pool.Jobs) -> dict[str, bytes]:
    return catalogue.build(IDS, cache=Cache(folder), settings=QUICK, jobs=jobs).files


def test_an_executor_gives_the_bytes_of_one_process_and_its_cache(tmp_path: Path) -> None:
    """The cache too, by content: what one executor has made, no other makes again."""
    alone = built(tmp_path / "alone", 1)
    with two_processes() as executor:
        assert built(tmp_path / "two", executor) == alone
    kept = [{path.name for path in (tmp_path / name).rglob("*.json")} for name in ("alone", "two")]
    assert kept[0] == kept[1]
    assert built(tmp_path / "two", Broken()) == alone, "nothing is left to be run"


def test_a_task_writes_nothing(tmp_path: Path) -> None:
    """It may run on a machine that does not know the folder: what it made goes back with its outcome."""
    folder = tmp_path / "cache"
    outcome = work.task("loads.uniform", str(folder), False, QUICK, {})
    assert not folder.exists()
    own = problem("loads.uniform")
    keys = {work.derivation_key(own), work.verification_key(own, outcome.entries, QUICK)}
    assert set(outcome.made) == keys


def _number(number: int) -> int:
    return number


def _wrong(number: int) -> int:
    raise ValueError(number)


def test_results_come_in_order_where_that_is_asked_for() -> None:
    with ThreadPoolExecutor(3) as executor:
        assert list(pool.run(_number, [(i,) for i in range(20)], executor, ordered=True)) == list(range(20))


def test_what_a_task_raises_is_no_fault_of_the_executor() -> None:
    for executor in (Inline(), ThreadPoolExecutor(2)):
        with pytest.raises(ValueError, match="3") as caught, executor:
            list(pool.run(_wrong, [(3,)], executor))
        assert "in _wrong" in caught.value.__notes__[0]


@pytest.mark.parametrize("executor", [Broken(), Forgetful()])
def test_a_broken_executor_is_an_error_that_says_so(executor: Executor) -> None:
    with pytest.raises(pool.WorkerError, match=r"^(Broken|Forgetful) failed, .*(are gone|after shutdown) .*are kept"):
        list(pool.run(_number, [(1,)], executor))


def test_threads_of_a_worker_take_turns(monkeypatch: pytest.MonkeyPatch) -> None:
    """The precision of mpmath is that of its process."""
    at_work: list[int] = []

    def alone(number: int) -> bool:
        at_work.append(number)
        found = len(at_work) == 1
        for _ in range(2000):
            os.getpid()
        at_work.remove(number)
        return found

    monkeypatch.setattr(sys, "getswitchinterval", sys.getswitchinterval)
    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    try:
        with ThreadPoolExecutor(4) as executor:
            assert all(pool.run(alone, [(i,) for i in range(40)], executor))
    finally:
        sys.setswitchinterval(before)


def test_a_worker_with_another_engine_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """Its results would be stored as those of this one."""
    digests = iter(["of this engine", "of another"])
    monkeypatch.setattr(pool, "engine", lambda: next(digests))
    with pytest.raises(pool.WorkerError, match="install the same on all machines"):
        list(pool.run(_number, [(1,)], Inline()))


@pytest.mark.parametrize(
    ("named", "said"),
    [
        ("nowhere_at_all:make", "ModuleNotFoundError: No module named 'nowhere_at_all'"),
        ("os:nothing", "AttributeError: module 'os' has no attribute 'nothing'"),
        ("os", "AttributeError"),
        (":make", "ValueError"),
        ("os:sep", "TypeError: 'str' object is not callable"),
        ("os:getcwd", "it returns '/"),
        ("__import__('os'):x", "ModuleNotFoundError"),
    ],
)
def test_what_is_no_executor_is_said_before_any_work(named: str, said: str) -> None:
    with pytest.raises(CommandError, match="--executor") as caught, pool.workers(named, 1):
        pytest.fail("began")
    assert said in str(caught.value)
    assert caught.value.code == 2


def test_a_module_beside_the_user_is_found_and_its_executor_ended(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    source = "from concurrent.futures import ThreadPoolExecutor\n\ndef three():\n    return ThreadPoolExecutor(3)\n"
    (tmp_path / "my_three_threads.py").write_text(source)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", [*sys.path])
    with pool.workers("my_three_threads:three", 1) as jobs:
        assert isinstance(jobs, ThreadPoolExecutor)
        assert list(pool.run(_number, [(7,)], jobs)) == [7]
    with pytest.raises(RuntimeError, match="after shutdown"):
        jobs.submit(_number, 1)


PROFILES = "# of two indenters\nr**2/(2*R)\n\nr*tan(theta)   # a cone\nr +* 2\n"


@pytest.fixture
def listed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(scene, "project_root", lambda: tmp_path)
    path = tmp_path / "profiles.txt"
    path.write_text(PROFILES)
    return path


def test_a_file_of_profiles_is_derived_line_by_line(
    listed: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each as alone; one that is wrong is named and takes no other with it; nothing is derived twice."""
    assert cli.main(["derive", "--", "r*tan(theta)"]) == 0
    alone = capsys.readouterr().out
    assert cli.main(["derive", "--from", str(listed), "--jobs", "1"]) == 1
    first = capsys.readouterr()
    assert [line for line in first.out.splitlines() if line.startswith("line ")] == ["line 2", "line 4"]
    assert f"line 4\n{alone}" in first.out
    assert first.err.startswith("axicontact: line 5: r +* 2: ")
    asked: list[str] = []
    monkeypatch.setattr(scene, "_own_record", lambda text, *_: asked.append(text) or {"error": "again"})
    assert cli.main(["derive", "--from", str(listed), "--executor", "concurrent.futures:ThreadPoolExecutor"]) == 1
    assert capsys.readouterr().out == first.out
    assert asked == ["r +* 2"]


def test_a_file_of_profiles_is_written_as_each_alone(listed: Path, tmp_path: Path) -> None:
    listed.write_text("r*tan(theta)\n")
    assert cli.main(["derive", "--out", str(tmp_path / "alone"), "--", "r*tan(theta)"]) == 0
    assert cli.main(["derive", "--out", str(tmp_path / "many"), "--from", str(listed)]) == 0
    alone, many = ({p.name: p.read_bytes() for p in (tmp_path / name).iterdir()} for name in ("alone", "many/line-1"))
    assert alone == many


@pytest.mark.parametrize(
    ("name", "code", "said"),
    [
        ("nowhere.txt", 3, "No such file or directory: 'nowhere.txt'"),
        ("empty.txt", 2, "empty.txt has no expression"),
        ("picture.png", 1, "line 1: "),
    ],
)
def test_a_file_that_cannot_be_derived_is_refused(
    name: str, code: int, said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "empty.txt").write_text("# none\n")
    (tmp_path / "picture.png").write_bytes(b"\x89PNG\r\n")
    monkeypatch.chdir(tmp_path)
    assert cli.main(["derive", "--from", name]) == code
    assert said in capsys.readouterr().err


def test_a_study_is_the_same_by_an_executor() -> None:
    """Of errors and not of times, so every number is."""
    names = extremes.KNOWN[:1]
    assert extremes.measure(names, quick=True, jobs=Inline()) == extremes.measure(names, quick=True)


CLUSTER = """
import os, signal, threading, time
from distributed import Client, LocalCluster

def executor():
    '''Two workers; one dies with the first task it has.'''
    cluster = LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=50)
    client = Client(cluster)
    first, *_ = client.run(os.getpid).values()
    def kill():
        while not any(client.processing().values()):
            time.sleep(0.01)
        os.kill(first, signal.SIGKILL)
        print("killed", first, flush=True)
    threading.Thread(target=kill).start()
    return client.get_executor()
"""
COMMAND = """
import sys
from pathlib import Path
from axiderive import cli
from axiderive.commands import build, scene

if __name__ == "__main__":
    build.project_root = scene.project_root = Path.cwd
    sys.exit(cli.main(sys.argv[1:]))
"""


@pytest.mark.slow
@pytest.mark.skipif(find_spec("distributed") is None, reason="Dask is not installed: pip install distributed")
def test_dask_gives_the_same_bytes_also_where_a_worker_dies(tmp_path: Path) -> None:
    """What the lost worker had begun is begun again, by the executor."""
    (tmp_path / "cluster.py").write_text(CLUSTER)
    (tmp_path / "command.py").write_text(COMMAND)
    (tmp_path / "profiles.txt").write_text("r*tan(theta)\n")
    build = ["build", "--only", ",".join(IDS), "--no-pdf", "--quiet", "--digits", "20", "--points", "4"]
    derive = ["derive", "--from", "profiles.txt"]

    def run(*arguments: str) -> str:
        command = [sys.executable, "-W", "ignore", "command.py", *arguments]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=300, check=False)
        assert done.returncode == 0, done.stderr
        return done.stdout

    assert "killed" in run(*build, "--out", "many", "--executor", "cluster:executor")
    found = {
        str(path.relative_to(tmp_path / "many")): path.read_bytes()
        for path in (tmp_path / "many").rglob("*")
        if path.is_file()
    }
    assert found == built(tmp_path / "alone", 1)
    said = run(*derive, "--executor", "cluster:executor")
    assert "killed" in said
    lines = [line for line in said.splitlines() if "killed" not in line]
    shutil.rmtree(tmp_path / ".cache")
    assert lines == run(*derive).splitlines()
