"""The command `axicontact verify`: the stored formulas proved again by the second prover, without the first."""

from __future__ import annotations

import sys
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from ..store.index import NoCatalogueError, evidence, load, table
from ..verifier import reasons, rests_on

ONLY_FIRST = "by the first prover only"


def verify(keys: Sequence[str], folder: Path) -> bool:
    """Prove these keys (profiles, problems or single formulas; all if empty).

    Returns
    -------
    bool
        Whether all was shown that the evidence says is.
    """
    index = load()
    stored = folder if folder.is_dir() else index.folder.parent / "evidence"
    started, rows, failures, counts = time.perf_counter(), list[list[str]](), list[str](), [0, 0]
    for key, selected in index.wanted(keys).items():
        record, below = _read(stored, key), rests_on(key)
        missing = reasons(record, _read(stored, below) if below else None)
        for suffix, proof in record["evidence"]["entries"].items():
            if f"{key}.{suffix}" not in selected or not proof["certified"]:
                continue
            cases, reason = len(record["entries"][suffix]["cases"]), missing[suffix]
            counts = [counts[0] + (0 if reason else cases), counts[1] + cases]
            rows.append([f"{key}.{suffix}", f"{ONLY_FIRST}: {reason}" if reason else "shown by both"])
            if reason and proof["twice"]["shown"]:
                failures.append(f"{key}.{suffix}: {reason}")
    print(table([["key", "certified"], *rows]))
    for failure in failures:
        print(f"FAILED {failure}", file=sys.stderr)
    print(f"{counts[0]} of {counts[1]} certified cases checked twice, {time.perf_counter() - started:.1f} s")
    return not failures


def _read(folder: Path, key: str) -> Mapping[str, Any]:
    record = evidence(folder, key)
    if "profile" not in record or any("twice" not in entry for entry in record["evidence"]["entries"].values()):
        message = f"the evidence of {key} holds nothing for a second prover; run axicontact build"
        raise NoCatalogueError(message)
    return record
