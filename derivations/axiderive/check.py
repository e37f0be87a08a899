"""The command `axicontact check`: the stored formulas verified again, nothing derived."""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from . import profiles
from .index import Index, NoCatalogueError, load
from .show import table
from .verification import details, verify
from .work import Settings, read_entries

HEAD = ["key", "status", "evidence"]


def check(keys: Sequence[str], folder: Path, settings: Settings, *, verbose: bool) -> bool:
    """Verify these keys (profiles or single formulas; all if empty); whether all of them passed."""
    index = load()
    wanted = _wanted(keys, index)
    started, checked, failures = time.perf_counter(), 0, []
    rows: list[list[str]] = []
    for name, selected in wanted.items():
        profile = profiles.load(name)
        record = _stored(folder if folder.is_dir() else index.folder.parent / "evidence", name)
        entries = read_entries(profile, record["entries"])
        evidence = verify(profile, entries, settings)
        checked += len(selected)
        failures += [f for f in evidence["failures"] if not f["key"].partition(".")[2] or f["key"] in selected]
        for suffix, found in evidence["entries"].items():
            if f"{name}.{suffix}" in selected:
                rows.append([f"{name}.{suffix}", entries[suffix].status, found["summary"]])
                if verbose:
                    rows += [["", "", line] for line in details(found)]
    print(table([HEAD, *rows]))
    for failure in failures:
        print(f"FAILED {failure['key']}: {failure['message']}", file=sys.stderr)
    print(f"{checked} formulas, {len(failures)} failures, {time.perf_counter() - started:.1f} s, seed {settings.seed}")
    return not failures


def _wanted(keys: Sequence[str], index: Index) -> dict[str, set[str]]:
    """The keys to check, by profile."""
    wanted: dict[str, set[str]] = {}
    for key in keys or [row["name"] for row in index.profiles]:
        for entry in index.select(key):
            wanted.setdefault(entry["profile"], set()).add(entry["key"])
    return wanted


def _stored(folder: Path, name: str) -> dict[str, Any]:
    path = folder / f"{name}.json"
    try:
        record: dict[str, Any] = json.loads(path.read_bytes())
    except FileNotFoundError as error:
        message = f"{path} does not exist; run axicontact build in a checkout of the project"
        raise NoCatalogueError(message) from error
    except ValueError as error:
        message = f"{path} is damaged ({error}); run axicontact build"
        raise NoCatalogueError(message) from error
    return record
