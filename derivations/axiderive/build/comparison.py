"""A catalogue just built beside the one on the disk: what differs, and what a partial build may write."""

from __future__ import annotations

import difflib
import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..physics.systems import problems, profile_ids
from ..store.index import dumps, loads
from ..store.writing import RECEIPTS
from .verification import checks_of

Record = dict[str, Any]


CHAPTER = "chapter11"
"""What the record of the chapter is called among those of the problems."""
LONGEST, MOST = 20, 10
"""Lines of difference that are shown of one file, and files of which any are."""


@dataclass(frozen=True)
class Difference:
    """A file that is not what a build writes, and the diff from the disk to the build."""

    path: str
    lines: tuple[str, ...]


def differences(files: dict[str, bytes], root: Path, stale: Sequence[str] = ()) -> list[Difference]:
    """Unified diffs, line by line, from the catalogue on the disk to the one just built."""
    found = []
    for path, content in sorted(files.items()):
        target = root / path
        old = target.read_bytes() if target.is_file() else None
        if old == content:
            continue
        before = [] if old is None else old.decode(errors="replace").splitlines()
        origin = "/dev/null" if old is None else f"committed/{path}"
        # without its own two heads, which are missing where lines differ in nothing but their ends
        diff = [*difflib.unified_diff(before, content.decode().splitlines(), lineterm="")][2:]
        found.append(Difference(path, (f"--- {origin}", f"+++ built/{path}", *(diff or ["other ends of lines"]))))
    gone = ("+++ /dev/null", "no longer generated")
    return found + [Difference(path, (f"--- committed/{path}", *gone)) for path in stale]


def shortened(found: Sequence[Difference]) -> list[str]:
    """The first lines of the first diffs, and how much of each and how many more there are."""
    lines: list[str] = []
    for one in found[:MOST]:
        lines += one.lines[:LONGEST]
        if len(one.lines) > LONGEST:
            lines.append(f"... {len(one.lines) - LONGEST} more lines of {one.path}")
    if len(found) > MOST:
        lines.append(f"... {len(found) - MOST} more files differ, from {found[MOST].path} to {found[-1].path}")
    return lines


@dataclass(frozen=True)
class Book:
    """What pages need of the book they belong to: its profiles, which number them, and the checks of chapter 11."""

    ids: tuple[str, ...]
    chapter: Record | None


def book_of(root: Path, ids: Sequence[str]) -> Book:
    """The book below `root` with these profiles in it."""
    index, chapter = (_read(root / path) for path in ("axicontact/index.json", "evidence/chapter11.json"))
    known = {*ids, *(row["name"] for row in index.get("profiles", ()))}
    return Book(tuple(name for name in profile_ids() if name in known), chapter or None)


def _read(path: Path) -> Record:
    try:
        return dict(json.loads(path.read_bytes()))
    except (OSError, ValueError):
        return {}


def only_profiles(files: dict[str, bytes], ids: Sequence[str], root: Path) -> dict[str, bytes]:
    """The files a partial build may write into a full catalogue.

    Files that belong to one of the profiles are replaced and the index is
    merged; what the profiles share is written only where it does not exist yet.
    """
    order = profile_ids()
    index_path = "axicontact/index.json"
    own = {path: text for path, text in files.items() if _owner(path) in ids}
    shared = {p: t for p, t in files.items() if p not in (*own, index_path, RECEIPTS) and not (root / p).exists()}
    new = loads(files[index_path])
    try:
        old = loads((root / index_path).read_bytes())
    except (OSError, ValueError):
        old = {"profiles": [], "entries": []}
    for part, name in (("profiles", "name"), ("entries", "profile")):
        rows = [row for row in old[part] if row[name] not in ids and row[name] in order] + new[part]
        new[part] = sorted(rows, key=lambda row: order.index(row[name]))  # noqa: B023
    for row in new["physics"]:
        row["formulas"] = sum(entry["physics"] == row["name"] for entry in new["entries"])
    new["matrix"] = _merged_matrix(old.get("matrix", {}), new["matrix"], order)
    receipts = {**_read(root / RECEIPTS), **json.loads(files.get(RECEIPTS, b"{}"))}
    return own | shared | {index_path: dumps(new).encode(), RECEIPTS: receipts_bytes(receipts)}


def _merged_matrix(old: Record, new: Record, order: Sequence[str]) -> Record:
    profiles = {**old.get("profiles", {}), **new["profiles"]}
    # what was counted over all profiles stays as the last build of all of them left it
    counted = {"twice": old["twice"]} if "twice" in old else {}
    return {**new, **counted, "profiles": {name: profiles[name] for name in order if name in profiles}}


def _owner(path: str) -> str:
    """The profile that a generated file belongs to; empty if it is shared."""
    folder, _, rest = path.partition("/")
    for problem in problems():
        if path in (problem.module, f"evidence/{problem.key}.json"):
            return problem.profile_id
        if folder == "handbook" and rest in (f"profiles/{problem.profile_id}.tex", f"html/{problem.profile_id}.html"):
            return problem.profile_id
    return ""


def receipts_bytes(receipts: Record) -> bytes:
    """The receipts as they are stored, a problem to a few lines."""
    return (json.dumps(receipts, indent=1) + "\n").encode()


def standing(root: Path, keys: Sequence[str]) -> dict[str, Record]:
    """What the evidence below `root` holds, by key of the problem: checks, measured errors, and their receipts.

    Beside the problems the record of the chapter.
    """
    receipts = _read(root / RECEIPTS)
    found: dict[str, Record] = {}
    for key in keys:
        try:
            evidence = json.loads((root / "evidence" / f"{key}.json").read_bytes())["evidence"]
            measured = evidence.get("evaluation")
            found[key] = {
                "checks": checks_of(evidence),
                "evaluation": None if measured is None else dict(measured),
                "receipts": dict(receipts.get(key, {})),
            }
        except (OSError, AttributeError, KeyError, TypeError, ValueError):
            # nothing published, or nothing that can be read: what is found now stands
            continue
    chapter = _read(root / "evidence" / f"{CHAPTER}.json")
    if chapter:
        found[CHAPTER] = {"record": chapter, "receipts": dict(receipts.get(CHAPTER, {}))}
    return found
