"""The machinery of a build: stored text, cache, atomic writing, processes, and what a build returns."""

from __future__ import annotations

import dataclasses
import json
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import at_work
import pytest
import sympy as sp

from axiderive.build import catalogue, pool, work
from axiderive.build.verification import checks_of
from axiderive.build.work import Settings, derivation_key, verification_key
from axiderive.code import tables
from axiderive.notation import R, a, b, r, theta
from axiderive.physics.systems import problem, problems
from axiderive.profiles.profile import Piece, Sketch
from axiderive.store import sources
from axiderive.store.cache import Cache, digest
from axiderive.store.records import ReadingError, entry_record, from_text, profile_record, read_entry, to_text

EVERY = [own.key for own in problems()]


@pytest.mark.parametrize("key", EVERY[::48])
def test_every_entry_survives_storage(key):
    """What is published is what was read back, so reading back must not change a single argument.

    The others pass through it in `test_determinism`, where all are derived anyway.
    """
    of = problem(key)
    for entry in of.system.derive(of.profile).values():
        back = read_entry(json.loads(json.dumps(entry_record(entry))), of.profile)
        assert back == entry
        assert back.primitives == entry.primitives
        assert back.text() == entry.text()


@pytest.mark.parametrize(
    "expr",
    [
        sp.Mul(2, a + b, evaluate=False),
        sp.Add(a, a, evaluate=False),
        sp.sqrt(8) * a ** sp.Rational(-7, 3),
        sp.Integral(sp.sqrt(r + a) / r, (r, a, b)),
        sp.Function("g")(a),
        sp.Piecewise((a, a < b), (b, True)),
        sp.Float("1.5", 50),
        sp.Symbol("odd name(); import os"),
    ],
    ids=str,
)
def test_stored_text_returns_the_expression_unevaluated(expr):
    assert from_text(to_text(expr)) == expr


@pytest.mark.parametrize(
    "text",
    [
        "__import__('os').system('true')",
        "Symbol('a').__class__",
        "open('/etc/passwd')",
        "Lambda(Symbol('x'), Symbol('x'))",
        "Symbol('a', positive=print)",
        "Integer(True)",
        "Integer(1.5)",
        "Add(*[1])",
        "(lambda: 1)()",
        "Add(Integer(1), Integer(2)",
        "",
        "(" * 3000,
    ],
)
def test_foreign_text_is_refused(text):
    with pytest.raises(ReadingError):
        from_text(text)


def test_functions_without_a_place_in_the_list_are_refused_on_writing():
    """Otherwise a result would be stored that cannot be read."""
    with pytest.raises(ReadingError, match="fresnels"):
        to_text(sp.fresnels(a))


KEY = digest("a key")


def test_cache_returns_what_was_put(tmp_path):
    store = Cache(tmp_path)
    assert store.get(KEY) is None
    store.put(KEY, {"text": "θ", "list": [1, None]})
    assert store.get(KEY) == {"text": "θ", "list": [1, None]}
    assert Cache(tmp_path, fresh=True).get(KEY) is None


@pytest.mark.parametrize(
    "damage",
    [
        lambda content: content[: len(content) // 2],
        lambda content: b"",
        lambda content: content.replace(b"3.5", b"3.6"),
        lambda content: b"\xff" + content,
        lambda content: b"[]",
        lambda content: content.replace(b'"sha256"', b'"sha25"'),
        lambda content: content.replace(KEY.encode(), digest("another key").encode()),
    ],
    ids=["truncated", "empty", "altered", "not text", "not a record", "no checksum", "other key"],
)
def test_damaged_cache_files_count_as_missing(tmp_path, damage):
    store = Cache(tmp_path)
    store.put(KEY, {"value": 3.5})
    path = store.path(KEY)
    path.write_bytes(damage(path.read_bytes()))
    assert store.get(KEY) is None


def test_keys_follow_everything_a_result_depends_on(monkeypatch):
    cone, sphere = problem("cone"), problem("sphere")
    assert derivation_key(cone) != derivation_key(problem("cone.vis"))
    assert derivation_key(cone) == derivation_key(cone)
    assert derivation_key(cone) != derivation_key(sphere)
    base = verification_key(cone, {}, Settings())
    others = [Settings(digits=51), Settings(points=25), Settings(seed=18)]
    keys = {
        base,
        *(verification_key(cone, {}, settings) for settings in others),
        verification_key(cone, {"d": 1}, Settings()),
    }
    assert len(keys) == 5
    before = derivation_key(cone)
    monkeypatch.setattr("axiderive.build.work.installed", lambda package: "1.99")
    assert derivation_key(cone) != before
    assert profile_record(cone.profile) != profile_record(sphere.profile)


def test_words_of_a_profile_derive_nothing_anew(monkeypatch):
    """Its title, note and picture are printed; its pieces and rules are what is derived from."""
    cone = problem("cone")
    plain, before = cone.profile, derivation_key(cone)

    def key_of(**changed):
        monkeypatch.setattr("axiderive.profiles.PROFILES", (dataclasses.replace(plain, **changed),))
        return derivation_key(cone)

    assert key_of(title="Kegel", note="sharp", validity="small", sketch=Sketch(((theta, 0.3),), a=2.0)) == before
    assert key_of(pieces=(Piece(None, 2 * r * sp.tan(theta)),)) != before
    assert key_of(chain=(a, R)) != before


def test_source_digest_sees_every_file_of_a_package(tmp_path, monkeypatch):
    package = tmp_path / "some_engine"
    package.mkdir()
    (package / "__init__.py").write_text("")
    (package / "part.py").write_text("x = 1\n")
    monkeypatch.syspath_prepend(str(tmp_path))
    first = sources.source_digest.__wrapped__("some_engine")
    (package / "part.py").write_text("x = 2\n")
    assert sources.source_digest.__wrapped__("some_engine") != first


def test_import_digest_follows_what_a_function_uses(tmp_path, monkeypatch):
    """Comments, docstrings, files and what is not used do not count, what is imported inside a function does."""
    monkeypatch.setattr(sources, "_KEPT", sources._Kept())
    monkeypatch.setattr(sources, "__file__", str(tmp_path / "engine" / "store" / "sources.py"))
    for name in ("_module", "_source"):
        monkeypatch.setattr(sources, name, getattr(sources, name).__wrapped__)
    (tmp_path / "engine").mkdir()
    first = '''"""Words."""

from . import second

def f():
    from .second import g
    return g() + second.factor * ONE

def unused():
    return 4

ONE = 1
'''
    second = "LIST = []\n\ndef g():\n    return 2\n\nfactor = 3\n\ndef other():\n    return 5\n"
    texts = {"__init__": "", "first": first, "second": second, "third": "x = 1\n"}

    def digest_with(name="engine.first.f", apart=frozenset(), **changed):
        for own, text in {**texts, **changed}.items():
            (tmp_path / "engine" / f"{own}.py").write_text(text)
        return sources.import_digest.__wrapped__(name, apart=apart)

    base = digest_with()
    assert digest_with(first=first.replace("Words.", "Other words.") + "# a remark\n") == base
    assert digest_with(first=first.replace("return 4", "return 5")) == base
    assert digest_with(second=second.replace("return 5", "return 6")) == base
    assert digest_with(third="x = 2\n") == base
    moved = digest_with(first="from .third import f\n", third=first)
    assert moved == base, "a definition that moves to another file is measured again"
    for old, new in (("+ second", "- second"), ("ONE = 1", "ONE = 2")):
        assert digest_with(first=first.replace(old, new)) != base
    for old, new in (
        ("return 2", "return 3"),
        ("factor = 3", "factor = 4"),
        ("LIST = []", "LIST = []\nLIST.append(1)"),
    ):
        assert digest_with(second=second.replace(old, new)) != base
    assert digest_with("engine.first", first=first.replace("return 4", "return 5")) != digest_with("engine.first")
    apart = frozenset({"elsewhere.second"})
    assert digest_with(apart=apart) == digest_with(apart=apart, second=second.replace("return 2", "return 3"))
    assert digest_with(apart=apart) != digest_with(apart=apart, first=first.replace("ONE = 1", "ONE = 2"))


def test_a_physics_repeats_no_check_of_another(monkeypatch):
    """Its own checks and those of normal contact count for it, whose functions it calls; what is named after others
    does not, and a new file of a physics is one more of these.
    """
    reached = {}

    def noted(*names, apart=frozenset()):
        reached["names"], reached["apart"] = set(names), {module.rpartition(".")[2] for module in apart}
        return ""

    monkeypatch.setattr(work, "import_digest", noted)
    others = {"adhesive", "tangential", "viscoelastic", "subsurface", "plane", "loads", "materials"}
    for key, own in (
        ("cone", set()),
        ("cone.tan", {"tangential"}),
        ("cone.fgm.adh", {"adhesive"}),
        ("cone.sub", {"subsurface"}),
    ):
        work._reached(problem(key), work.CHECKING)
        assert others - own <= reached["apart"]
        assert not reached["apart"] & (own | {"normal"})
        assert {f"axiderive.physics.{name}.PHYSICS" for name in own | {"normal"}} <= reached["names"]


def test_what_files_say_is_kept_by_their_contents(tmp_path, monkeypatch):
    """Nothing is read twice, a changed file is, and a damaged store is none."""
    monkeypatch.setattr(sources, "__file__", str(tmp_path / "engine" / "store" / "sources.py"))
    (tmp_path / "engine" / "store").mkdir(parents=True)
    (tmp_path / "engine" / "store" / "sources.py").write_text("")
    texts = {"first": "from .second import g\n\ndef f():\n    return g.h\n", "second": "def g():\n    return 2\n"}
    read, store = [], Cache(tmp_path / "cache")
    genuine = sources._read

    def noted(name, *given):
        read.append(name)
        return genuine(name, *given)

    monkeypatch.setattr(sources, "_read", noted)

    def digest_in(cache, **changed):
        for name in ("_module", "_source"):
            monkeypatch.setattr(sources, name, sources_own[name].__wrapped__)
        for own, text in {"__init__": "", **texts, **changed}.items():
            (tmp_path / "engine" / f"{own}.py").write_text(text)
        read.clear()
        with sources.kept(cache):
            return sources.import_digest.__wrapped__("engine.first.f")

    sources_own = {name: getattr(sources, name) for name in ("_module", "_source")}
    plain = digest_in(Cache(tmp_path / "none", fresh=True))
    assert set(read) >= {"engine.first", "engine.second"}
    assert digest_in(store) == plain
    assert set(read) >= {"engine.first", "engine.second"}
    assert digest_in(store) == plain
    assert read == []
    assert digest_in(store, second="def g():\n    return 3\n") != plain
    assert read == ["engine.second"]
    (path,) = (tmp_path / "cache").rglob("*.json")
    path.write_bytes(path.read_bytes()[:-9])
    assert digest_in(store) == plain
    assert set(read) >= {"engine.first", "engine.second"}


def test_kernels_are_fitted_once_for_the_same_sources(tmp_path, monkeypatch):
    fitted, store = [], Cache(tmp_path)
    monkeypatch.setattr(tables, "kernels_source", lambda: fitted.append(1) or "text")
    assert [catalogue.kernels(store), catalogue.kernels(store), len(fitted)] == ["text", "text", 1]
    catalogue.kernels(Cache(tmp_path, fresh=True))
    assert len(fitted) == 2
    monkeypatch.setattr(catalogue, "import_digest", lambda *names: "of other sources")
    catalogue.kernels(store)
    assert len(fitted) == 3


def test_checks_are_taken_over_from_the_same_inputs_alone(tmp_path, monkeypatch):
    """Not with other settings, not for another formula, and not where the published result is not the one made."""
    own, settings = problem("loads.uniform"), Settings()
    folder = str(tmp_path)
    made = work.task(own.key, folder, True, settings, {})
    checks = checks_of(made.evidence)
    known = {"checks": work.receipt(work.checking_key(own, made.entries, settings), checks)}
    standing = {"checks": checks, "receipts": known}

    def kept(entries=made.entries, settings=settings, **changed):
        return work.kept_checks(own, entries, settings, {**standing, **changed})

    assert kept() == checks
    assert kept(settings=Settings(seed=18)) is None
    assert kept(entries={"w": {**made.entries["w"], "status": "root"}}) is None
    assert kept(checks=[{**checks[0], "worst": "0.0"}, *checks[1:]]) is None
    assert kept(receipts={}) is None
    monkeypatch.setattr(
        "axiderive.build.verification.checks.check_problem", lambda *args, **kwargs: pytest.fail("made anew")
    )
    again = work.task(own.key, str(tmp_path / "other"), False, settings, standing)
    assert again.kept
    assert again.evidence == made.evidence
    assert not made.kept


def test_workers_have_a_fixed_hash_seed_and_all_tasks_return():
    results = list(pool.run(at_work.numbered, [(i,) for i in range(4)], jobs=2))
    assert sorted(number for _, _, number in results) == [0, 1, 2, 3]
    assert {seed for seed, _, _ in results} == {"0"}
    assert os.getpid() not in {pid for _, pid, _ in results}


def test_a_dead_worker_is_an_error_not_a_hang():
    with pytest.raises(pool.WorkerError, match="--jobs 1"):
        list(pool.run(at_work.ended, [(1,), (2,)], jobs=2))


INTERRUPTED = """
import os, signal, sys, time
from axiderive.build import pool

def work(seconds):
    os.write(1, b"at work\\n")  # in one piece, as two say it at the same time
    time.sleep(seconds)

if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell in the background hands on that it is ignored
    print("ready", flush=True)
    try:
        list(pool.run(work, [(600,), (600,), (600,)], jobs=2))
    except KeyboardInterrupt:
        print("stopped", flush=True)
        sys.exit(130)
"""


@contextmanager
def _killed_after(seconds: float, process: subprocess.Popen[str]) -> Iterator[None]:
    timer = threading.Timer(seconds, process.kill)
    timer.start()
    yield
    timer.cancel()


def _children(pid: int) -> list[int]:
    return [int(child) for child in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]


@pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="looks for processes in /proc")
@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGKILL])
def test_no_worker_outlives_the_build(tmp_path, how):
    script = tmp_path / "script.py"
    script.write_text(INTERRUPTED)
    process = subprocess.Popen([sys.executable, script], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout is not None
    with _killed_after(300, process):
        assert [process.stdout.readline() for _ in range(3)] == ["ready\n", "at work\n", "at work\n"]
    children = _children(process.pid)
    assert len(children) >= 3  # two workers and the tracker of multiprocessing
    process.send_signal(how)
    output, errors = process.communicate(timeout=30)
    if how == signal.SIGINT:
        assert (process.returncode, output, errors) == (130, "stopped\n", "")
    deadline = time.monotonic() + 30
    while any(Path(f"/proc/{child}/exe").exists() for child in children):
        assert time.monotonic() < deadline
        time.sleep(0.05)
