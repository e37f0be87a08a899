"""What a build writes: whole or not at all, and nothing that is not its own."""

from __future__ import annotations

import errno
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from axiderive.build.comparison import LONGEST, MOST, Book, book_of, differences, only_profiles, shortened, standing
from axiderive.store import writing

CATALOGUE = Path(__file__).resolve().parents[1] / "catalogue"
FILES = {"axicontact/index.json": b"{}\n", "axicontact/normal/cone.py": b"new\n", "evidence/cone.json": b"{}\n"}


def _catalogue(root: Path) -> dict[str, bytes]:
    files = {path.relative_to(root).as_posix(): path.read_bytes() for path in root.rglob("*") if path.is_file()}
    return dict(sorted(files.items()))


@pytest.fixture
def root(tmp_path):
    """A catalogue as an earlier build left it, with a stale file and files that are not ours."""
    root = tmp_path / "catalogue"
    old = {"axicontact/index.json": "old", "axicontact/normal/cone.py": "old\n", "axicontact/normal/kone.py": "stale"}
    for path, text in {**old, "axicontact/notes.txt": "mine", "mine/own.py": "mine"}.items():
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(text)
    return root


def test_publishing_replaces_adds_and_removes_only_what_is_generated(root):
    written, removed = writing.publish(FILES, root, prune=True)
    assert written == sorted(FILES)
    assert removed == ["axicontact/normal/kone.py"]
    assert _catalogue(root) == dict(sorted({**FILES, "axicontact/notes.txt": b"mine", "mine/own.py": b"mine"}.items()))
    assert writing.publish(FILES, root, prune=True) == ([], [])


def test_nothing_is_removed_where_no_catalogue_was(tmp_path):
    (tmp_path / "evidence").mkdir()
    (tmp_path / "evidence" / "of_something_else.json").write_text("{}")
    writing.publish(FILES, tmp_path, prune=True)
    assert (tmp_path / "evidence" / "of_something_else.json").exists()


def test_a_failing_disk_leaves_the_old_catalogue(root, monkeypatch):
    before = _catalogue(root)
    calls = []

    def fsync(descriptor):
        calls.append(descriptor)
        if len(calls) == 3:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", fsync)
    with pytest.raises(writing.WritingError, match=r"cannot write .*No space left on device.*"):
        writing.publish(FILES, root, prune=True)
    assert _catalogue(root) == before


def test_a_file_that_may_not_grow_leaves_the_old_catalogue(root):
    """The same with the kernel's refusal: no file may be longer than 64 bytes."""
    script = f"""
import resource
from pathlib import Path
from axiderive.store.writing import WritingError, publish
resource.setrlimit(resource.RLIMIT_FSIZE, (64, resource.getrlimit(resource.RLIMIT_FSIZE)[1]))
try:
    publish({{**{FILES!r}, "handbook/long.tex": b"x" * 1000}}, Path({str(root)!r}), prune=True)
except WritingError as error:
    print(error)
"""
    before = _catalogue(root)
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=300, check=True)
    assert "File too large" in done.stdout
    assert _catalogue(root) == before


def test_a_folder_that_cannot_be_is_refused_before_the_work(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(writing.WritingError, match="cannot write a catalogue to .*--out"):
        writing.ensure_writable(tmp_path / "file" / "catalogue")


def test_leftovers_of_a_killed_build_are_cleared(root):
    process = subprocess.Popen([sys.executable, "-c", ""])
    process.wait()
    dead, alive = root / f".staging-{process.pid}", root / f".staging-{os.getppid()}"
    dead.mkdir()
    alive.mkdir()
    writing.publish(FILES, root, prune=True)
    assert not dead.exists()
    assert alive.exists()


def test_an_atomic_write_that_fails_leaves_no_trace(tmp_path, monkeypatch):
    target = tmp_path / "file"
    writing.write_atomic(target, b"old")
    monkeypatch.setattr(os, "replace", lambda *paths: (_ for _ in ()).throw(OSError(errno.EIO, "broken")))
    with pytest.raises(OSError, match="broken"):
        writing.write_atomic(target, b"new")
    assert _catalogue(tmp_path) == {"file": b"old"}


def test_differences_name_changed_new_and_stale_files(root):
    found = differences(FILES, root, ["axicontact/normal/kone.py"])
    text = "\n".join(line for one in found for line in one.lines)
    assert "-old\n+new" in text
    assert "--- /dev/null\n+++ built/evidence/cone.json" in text
    assert "--- committed/axicontact/normal/kone.py" in text
    writing.publish(FILES, root, prune=True)
    assert differences(FILES, root) == []


def test_ends_of_lines_are_a_difference(root):
    writing.publish(FILES, root, prune=True)
    path, content = next((path, content) for path, content in FILES.items() if content.endswith(b"\n"))
    (root / path).write_bytes(content.replace(b"\n", b"\r\n"))
    assert [one.path for one in differences(FILES, root)] == [path]


def test_of_a_long_difference_the_first_lines_are_shown_and_the_rest_is_counted(tmp_path):
    """A catalogue of another engine differs in a hundred thousand lines; whoever reads them wants to know where."""
    files = {f"evidence/{i:02}.json": b"a line\n" * 100 for i in range(13)}
    found = differences(files, tmp_path)
    lines = shortened(found)
    assert len(lines) == MOST * (LONGEST + 1) + 1
    assert lines[LONGEST] == "... 83 more lines of evidence/00.json"  # of 100 and three heads
    assert lines[-1] == "... 3 more files differ, from evidence/10.json to evidence/12.json"
    few = differences({"short.json": b"a line\n" * 17}, tmp_path)
    assert shortened(few) == list(few[0].lines)


def test_measured_errors_are_read_back_from_what_a_build_wrote(tmp_path):
    """Evidence is no index: read as one it is nothing, and no error that was measured would ever stand."""
    key = "cone"
    found = standing(CATALOGUE, [key, "unheard.of"])
    stored = json.loads((CATALOGUE / "evidence" / f"{key}.json").read_bytes())["evidence"]
    assert set(found) == {key, "chapter11"}
    assert found[key]["evaluation"] == stored["evaluation"]
    assert found[key]["evaluation"]["p"]["bench"]["points"] > 0
    assert [check for check in found[key]["checks"] if check["key"] == "cone.p"] == stored["entries"]["p"]["checks"]
    assert standing(tmp_path, [key]) == {}


def test_a_page_belongs_to_the_book_that_stands(tmp_path):
    """Its links to chapter 11 lead somewhere, and its number counts the profiles before it."""
    whole = book_of(CATALOGUE, ["sphere"])
    assert len(whole.ids) > 30
    assert list(whole.ids[:2]) == ["cone", "sphere_tipped_cone"]
    assert whole.chapter == json.loads((CATALOGUE / "evidence" / "chapter11.json").read_bytes())
    assert book_of(tmp_path, ["sphere", "cone"]) == Book(("cone", "sphere"), None)


def test_a_partial_build_keeps_the_other_profiles(tmp_path):
    row = {"symbol": "p", "label": "Pressure", "status": "closed", "definition": "", "python": "pressure(r, a)"}

    def index(*names):
        rows = {
            "units": [],
            "physics": [{"name": "normal", "formulas": len(names)}, {"name": "plane", "formulas": 0}],
            "profiles": [{"name": n, "problems": {n: {"physics": "normal"}}} for n in names],
            "entries": [{**row, "profile": n, "key": f"{n}.p"} for n in names],
        }
        return json.dumps(rows | {"matrix": {"profiles": {n: {"normal": "1 ✓"} for n in names}}}).encode()

    shared = {"axicontact/__init__.py": b"all", "handbook/handbook.tex": b"all"}
    receipts = {"evidence/receipts.json": b'{"cone": {"checks": "1"}, "paraboloid": {"checks": "2"}}'}
    before = {**shared, **receipts, "axicontact/index.json": index("cone", "sphere", "gone")}
    writing.publish(before, tmp_path, prune=False)
    part = {"axicontact/__init__.py": b"part", "axicontact/extra.py": b"x", "axicontact/normal/paraboloid.py": b"y"}
    part |= {"evidence/receipts.json": b'{"paraboloid": {"checks": "3"}}'}
    files = only_profiles({**part, "axicontact/index.json": index("paraboloid")}, ["paraboloid"], tmp_path)
    own = ["axicontact/extra.py", "axicontact/index.json", "axicontact/normal/paraboloid.py", "evidence/receipts.json"]
    assert sorted(files) == own
    assert json.loads(files["evidence/receipts.json"]) == {"cone": {"checks": "1"}, "paraboloid": {"checks": "3"}}
    merged = json.loads(files["axicontact/index.json"])
    assert [row["name"] for row in merged["profiles"]] == ["cone", "paraboloid", "sphere"]
    assert [row["key"] for row in merged["entries"]] == ["cone.p", "paraboloid.p", "sphere.p"]
    assert list(merged["matrix"]["profiles"]) == ["cone", "paraboloid", "sphere"]
    assert {row["name"]: row["formulas"] for row in merged["physics"]} == {"normal": 3, "plane": 0}
