"""Records of the study: pairs of times, numbers rounded for keeping, tables for reading, files beside the evidence.

Two calls are timed in turn and only the ratio is kept, because times belong to a machine.
"""

from __future__ import annotations

import hashlib
import json
import math
import statistics
import time
from collections.abc import Callable, Sequence
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from typing import Any, TypeAlias

import mpmath as mp

from ..build.work import project_root
from ..store.index import table as columns
from ..store.writing import STUDIES, write_atomic

Record: TypeAlias = dict[str, Any]
CARRIED = 60


def relative(got: Any, exact: mp.mpf) -> float:
    """Relative error, infinite where `got` is no finite number."""
    with mp.workdps(CARRIED):
        number = got if isinstance(got, mp.mpf) else mp.mpf(float(got))
        return float(abs(number / exact - 1)) if mp.isfinite(number) else math.inf


def rounded(x: float, digits: int = 2) -> float | None:
    """A few significant digits; None for what is no finite number, which JSON does not know."""
    return float(f"{x:.{digits - 1}e}") if math.isfinite(x) else None


def summary(errors: Sequence[float]) -> Record:
    """Worst and median error of the finite values, how many there are, and how many values are no finite numbers."""
    finite = [x for x in errors if math.isfinite(x)]
    return {
        "worst": rounded(max(finite, default=math.nan)),
        "median": rounded(statistics.median(finite) if finite else math.nan),
        "points": len(errors),
        "lost": len(errors) - len(finite),
    }


def measured_files() -> str:
    """Digest of the catalogue's modules: which functions a record speaks of."""
    import axicontact

    content = hashlib.sha256()
    for path in sorted(Path(axicontact.__file__).parent.rglob("*.py")):
        content.update(path.read_bytes())
    return content.hexdigest()[:16]


def versions() -> dict[str, str]:
    """What was compared: the modules of the catalogue by their digest, packages by their version."""
    packages = ("numpy", "scipy", "sympy", "mpmath", "python-flint", "tamaas")
    return {"axicontact": measured_files()} | {
        name: version(name) for name in packages if find_spec(name.removeprefix("python-"))
    }


def table(head: Sequence[str], rows: Sequence[Sequence[Any]]) -> str:
    """Columns of text."""
    return columns([head, *([_cell(x) for x in row] for row in rows)])


def _cell(x: Any) -> str:
    if x is None:
        return "-"
    return f"{x:.2g}" if isinstance(x, float) else str(x)


def to_json(record: Record) -> str:
    """Rows on lines of their own."""
    parts = []
    for name, value in record.items():
        if isinstance(value, list) and value:
            lines = ",\n".join(f"  {json.dumps(row)}" for row in value)
            parts.append(f'"{name}": [\n{lines}\n ]')
        else:
            parts.append(f'"{name}": {json.dumps(value)}')
    return "{\n " + ",\n ".join(parts) + "\n}\n"


def store(record: Record) -> Path:
    """Write the record to the evidence; a build neither makes nor removes it."""
    path = project_root() / "catalogue" / STUDIES / f"{record['study']}.json"
    write_atomic(path, to_json(record).encode())
    return path


Call = Callable[[], Any]
SHORTEST, LONGEST = 4e-3, 0.1
"""Seconds that one timing takes at least, shorter calls are repeated; longer ones are timed three times."""


def paired(call: Call, beside: Call, rounds: int) -> float:
    """Median over `rounds` of the processor time of `call` over that of `beside`, which runs right before it."""
    first = [_first(beside), _first(call)]
    counts = [max(1, int(SHORTEST / max(once, 1e-7))) for once in first]
    rounds = min(rounds, 3) if max(first) > LONGEST else rounds
    ratios = []
    for _ in range(rounds):
        own = seconds(beside, counts[0])
        ratios.append(seconds(call, counts[1]) / own)
    return statistics.median(ratios)


def _first(call: Call) -> float:
    """The shorter of two timings, as the first may fill caches; of a long one the first."""
    once = seconds(call)
    return once if once > LONGEST else min(once, seconds(call))


def seconds(call: Call, repeats: int = 1) -> float:
    """Processor time of a call, the mean of `repeats`."""
    start = time.process_time()
    for _ in range(repeats):
        call()
    return (time.process_time() - start) / repeats
