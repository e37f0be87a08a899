"""Emitted plane modules in a folder of their own, with drawn parameters."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from stored_book import kernels

from axiderive.code.module import PLACE, runtime_sources
from axiderive.code.programs import program_sources
from axiderive.code.python import NODE_COUNTS
from axiderive.code.tables import nodes_source, symbols_sources
from axiderive.entry import Entry
from axiderive.physics.plane import derive
from axiderive.profiles import plane

ACCURACY = 5e-15
"""Of a value away from zeros, relative; 2.5e-15 is measured (power law, rounded punch)."""
CONCAVE = [name for name in plane.COMPLETE_NAMES if name.startswith("concave")]


@cache
def entries(name: str) -> dict[str, Entry]:
    return derive(plane.load(name))


def written(folder: Path, package: str, sources: dict[str, str]) -> None:
    """The runtime and these modules as a package."""
    base = folder / package
    tables = {"nodes.py": nodes_source(NODE_COUNTS), "kernels.py": kernels()}
    tables |= symbols_sources({"theta", "R", "A", "b", "h", "n", "a", "E_star"})
    files = {"__init__.py": "", **runtime_sources(), **{f"{PLACE}/{name}": text for name, text in tables.items()}}
    files |= {"plane/__init__.py": ""} | {
        str(Path(path).relative_to("axicontact")): text for path, text in sources.items()
    }
    files |= {
        path.removeprefix("axicontact/"): text
        for path, text in program_sources({f"axicontact/{path}": text for path, text in files.items()}).items()
    }
    for path, text in files.items():
        (base / path).parent.mkdir(parents=True, exist_ok=True)
        (base / path).write_text(text)


SMOOTH = [name for name in plane.NAMES if name != "eccentric_punch"]
