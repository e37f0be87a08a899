"""The only module that writes files: each one whole, and a catalogue only after all of it is safely on the disk."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterable, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

GENERATED_FOLDERS = ("axicontact", "handbook", "evidence")
GENERATED_SUFFIXES = frozenset(
    {".py", ".pyi", ".typed", ".json", ".tex", ".sty", ".cls", ".html", ".css", ".js", ".svg"}
)
STUDIES = "evidence/study/"
"""Records of `axicontact study`: measured by a command of their own, neither made nor removed by a build."""
RECEIPTS = "evidence/receipts.json"
"""What the inputs of every check and measurement were: no result, and not compared."""
INDEX = "axicontact/index.json"


class WritingError(OSError):
    """A file could not be written; the message names it and says what still stands."""


def write_atomic(path: Path, content: bytes) -> None:
    """Write a file so that a reader sees the old or the new content, never a part of it."""
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f"{path.name}.tmp-{os.getpid()}")
    try:
        _write_synced(temporary, content)
        os.replace(temporary, path)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise


def ensure_writable(root: Path) -> None:
    """Fail before the work rather than after it if a catalogue cannot be written below `root`."""
    try:
        root.mkdir(parents=True, exist_ok=True)
        with _staging(root):
            pass
    except OSError as error:
        message = f"cannot write a catalogue to {root}: {error.strerror or error}; choose another folder with --out"
        raise WritingError(message) from error


def publish(files: Mapping[str, bytes], root: Path, *, prune: bool) -> tuple[list[str], list[str]]:
    """Bring the catalogue below `root` up to date; returns the paths (written, removed).

    New files are first written to a folder beside the catalogue, on the same
    disk, and renamed only when all of them are there: a full disk leaves the old
    catalogue as it was.  With `prune`, generated files that are no longer
    generated are removed, but only where a catalogue has been written before.
    """
    had_catalogue = (root / INDEX).exists()
    changed = {path: content for path, content in sorted(files.items()) if _content(root / path) != content}
    try:
        if changed:
            root.mkdir(parents=True, exist_ok=True)
            with _staging(root) as staging:
                for path, content in changed.items():
                    (staging / path).parent.mkdir(parents=True, exist_ok=True)
                    _write_synced(staging / path, content)
                for path in changed:
                    (root / path).parent.mkdir(parents=True, exist_ok=True)
                for path in changed:
                    os.replace(staging / path, root / path)
        stale = stale_files(files, root) if prune and had_catalogue else []
        for path in stale:
            (root / path).unlink()
    except OSError as error:
        reason = error.strerror or str(error)
        message = f"cannot write the catalogue to {root}: {reason}; nothing half written, the files there are whole"
        raise WritingError(message) from error
    return list(changed), stale


def stale_files(files: Iterable[str], root: Path) -> list[str]:
    """Generated files below `root` that a build would no longer write."""
    current = set(files)
    found = (
        path.relative_to(root).as_posix()
        for folder in GENERATED_FOLDERS
        for path in (root / folder).rglob("*")
        if path.suffix in GENERATED_SUFFIXES and path.is_file()
    )
    return sorted(path for path in set(found) - current if not path.startswith(STUDIES))


@contextmanager
def _staging(root: Path) -> Iterator[Path]:
    for abandoned in root.glob(".staging-*"):
        if not _alive(int(abandoned.name.removeprefix(".staging-"))):
            shutil.rmtree(abandoned, ignore_errors=True)
    staging = root / f".staging-{os.getpid()}"
    try:
        staging.mkdir(exist_ok=True)
        yield staging
    finally:
        shutil.rmtree(staging, ignore_errors=True)


def _write_synced(path: Path, content: bytes) -> None:
    with path.open("wb") as stream:
        stream.write(content)
        stream.flush()
        os.fsync(stream.fileno())


def _content(path: Path) -> bytes | None:
    try:
        return path.read_bytes()
    except OSError:
        return None


def _alive(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    except PermissionError:
        return True
    return True
