"""Scenes that are really emitted, hostile ones among them: nothing outside the folder is written or changed."""

from __future__ import annotations

import hashlib
import random
from pathlib import Path

import pytest
from scenes import NEEDLE, random_scene

from axiderive.cli import main

FOLDERS = (
    "out", "a/b/c", "./here", "..", "../out", "a/../../out", "/tmp/out", "~", "~root", "a\\\\..\\\\b", "link",
    "link/deep", "inner", "scene.toml", "scene.toml/x", ".", " ", "x\\u0000y", "con", "-rf", "$HOME",
    "%TEMP%", "a" * 190, "é",
)  # fmt: skip
MODULES = ("m.py", "../m.py", "a/m.py", "/tmp/m.py", "m.txt", ".py", "m.py/", "scene.toml", "test_m.py", "numpy.py")
EMITTED = '\n[output]\nfolder = "{}"\nmodule = "{}"\nformats = ["python", "json"]\n'


def content(root: Path) -> dict[str, str]:
    """Hash, or target, of everything below a folder."""
    found = {}
    for path in root.rglob("*"):
        name = path.relative_to(root).as_posix()
        if path.is_symlink():
            found[name] = f"-> {path.readlink()}"
        else:
            found[name] = hashlib.sha256(path.read_bytes()).hexdigest() if path.is_file() else "folder"
    return found


@pytest.fixture
def place(tmp_path: Path) -> Path:
    """A folder of scenes with neighbours, and links that lead to them and to itself."""
    scenes = tmp_path / "scenes"
    scenes.mkdir()
    (tmp_path / "neighbour").mkdir()
    (tmp_path / "neighbour" / "kept.py").write_text("kept = True\n")
    (scenes / "kept.py").write_text("kept = True\n")
    (scenes / "link").symlink_to(tmp_path / "neighbour")
    (scenes / "inner").symlink_to(scenes)
    return tmp_path


def emitted(place: Path, source: bytes, capsys: pytest.CaptureFixture[str]) -> int:
    """Emit a scene; what was there before is as it was, and what is new lies below the folder of the scenes."""
    scene = place / "scenes" / "scene.toml"
    scene.write_bytes(source)
    before = content(place)
    code = main(["emit", str(scene)])
    after = content(place)
    shown = capsys.readouterr()
    assert "Traceback" not in shown.err
    assert {name: after.get(name) for name in before} == before, source
    new = {name for name in after if name not in before}
    assert all(name.startswith("scenes/") for name in new), source
    assert bool(new) == (code == 0), source
    return code


def watched(place: Path, seeds: range, capsys: pytest.CaptureFixture[str]) -> int:
    """How many of the random scenes were emitted."""
    count = 0
    for seed in seeds:
        source = random.Random(seed)
        if source.random() < 0.5:
            data = random_scene(source)
        else:
            folder = source.choice(FOLDERS)
            module = "m.py" if source.random() < 0.5 else source.choice(MODULES)
            body = source.choice((NEEDLE, 'profile = "q*r**2"\n[want]\nquantities = ["depth"]\n'))
            data = (body + EMITTED.format(folder, module)).encode()
        if b"pdf" in data or b"[output]" not in data:
            data += b'\n[output]\nformats = ["python"]\n'
        count += emitted(place, data, capsys) == 0
        for name in set(content(place)) - {"scenes/scene.toml"}:
            path = place / name
            if path.is_file() and not path.is_symlink() and "kept" not in name and name.startswith("scenes/"):
                path.unlink()
    return count


@pytest.mark.parametrize("folder", FOLDERS)
def test_nothing_is_written_outside_for_any_folder(folder, place, capsys):
    source = 'profile = "cone"\n[want]\nquantities = ["depth"]' + EMITTED.format(folder, "m.py")
    emitted(place, source.encode(), capsys)


def test_random_scenes_write_below_their_folder_only(place, capsys):
    assert watched(place, range(15), capsys) >= 1


@pytest.mark.parametrize(
    ("seeds", "least"),
    [
        pytest.param(range(15, 300), 30, marks=pytest.mark.slow),
        pytest.param(range(300, 1000), 70, marks=pytest.mark.sweep),
    ],
)
def test_many_random_scenes_write_below_their_folder_only(place, capsys, seeds, least):
    assert watched(place, seeds, capsys) > least


EMIT = 'name = "own"\nprofile = "cone"\n[want]\nquantities = ["depth"]\n[output]\nformats = ["python"]\n'


def emitted_again(folder: Path, source: str = EMIT) -> int:
    (folder / "scene.toml").write_text(source)
    return main(["emit", str(folder / "scene.toml")])


def test_a_folder_of_an_earlier_run_is_written_again(tmp_path):
    assert emitted_again(tmp_path) == 0
    assert emitted_again(tmp_path, EMIT.replace('"depth"', '"force"')) == 0
    assert "def force" in (tmp_path / "own" / "own.py").read_text()


@pytest.mark.parametrize("name", ["own.py", "MANIFEST.json"])
def test_files_of_another_origin_are_not_overwritten(name, tmp_path, capsys):
    """Also a module that was changed by hand after it had been written."""
    (tmp_path / "own").mkdir()
    (tmp_path / "own" / name).write_text("by hand\n")
    assert emitted_again(tmp_path) == 2
    assert f"{name} in {tmp_path / 'own'} would be overwritten" in capsys.readouterr().err
    assert [path.name for path in (tmp_path / "own").iterdir()] == [name]
    (tmp_path / "own" / name).unlink()
    assert emitted_again(tmp_path) == 0
    with (tmp_path / "own" / "own.py").open("a") as module:
        module.write("# changed\n")
    assert emitted_again(tmp_path, EMIT.replace('"depth"', '"force"')) == 2


def test_a_file_in_place_of_the_folder_is_named(tmp_path, capsys):
    (tmp_path / "own").write_text("a file\n")
    assert emitted_again(tmp_path) == 2
    assert f"{tmp_path / 'own'} is a file and no folder; choose another" in capsys.readouterr().err
