"""Emitted plane modules in a folder of their own, with drawn parameters."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from axiderive.code.imports import RUNTIME
from axiderive.code.python import NODE_COUNTS
from axiderive.code.tables import kernels_source, nodes_source, symbols_sources
from axiderive.entry import Entry
from axiderive.physics.plane import derive
from axiderive.profiles import plane

PACKAGE = "emitted_plane"


ACCURACY = 5e-15
"""Of a value away from zeros, relative; 2.5e-15 is measured (power law, rounded punch)."""
CONCAVE = [name for name in plane.COMPLETE_NAMES if name.startswith("concave")]


@cache
def entries(name: str) -> dict[str, Entry]:
    return derive(plane.load(name))


@cache
def kernels() -> str:
    """Fitted anew they take five seconds."""
    return kernels_source()


def written(folder: Path, package: str, sources: dict[str, str]) -> None:
    """The runtime and these modules as a package."""
    base = folder / package
    (base / "plane").mkdir(parents=True)
    for path in RUNTIME.glob("*.py"):
        (base / path.name).write_text(path.read_text())
    (base / "_nodes.py").write_text(nodes_source(NODE_COUNTS))
    (base / "_kernels.py").write_text(kernels())
    (base / "__init__.py").write_text("")
    for name, text in symbols_sources({"theta", "R", "A", "b", "h", "n", "a", "E_star"}).items():
        (base / name).write_text(text)
    for path_, text in sources.items():
        (base / Path(path_).relative_to("axicontact")).write_text(text)


SMOOTH = [name for name in plane.NAMES if name != "eccentric_punch"]
