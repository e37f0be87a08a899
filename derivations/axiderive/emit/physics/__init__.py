"""Packages beyond the normal contact, as thin modules that state each rule of superposition once."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from ...profiles import COMPLETE_NAMES, NAMES, load
from ...profiles.loads import LOADS
from . import adhesive, loads, tangential, viscoelastic
from .bounds import bounds_source
from .refusals import package_source, punch_source, refusal_source
from .text import NormalModule

RUNTIME = Path(__file__).with_name("runtime")
PACKAGE = "axicontact"


def module_sources(names: Iterable[str] = NAMES) -> dict[str, str]:
    """The files of all physics as `{path below catalogue/: text}`."""
    names = sorted(names)
    files = {f"{PACKAGE}/{path.name}": path.read_text() for path in sorted(RUNTIME.glob("*.py"))}
    files[f"{PACKAGE}/_bounds.py"] = bounds_source()
    for name in names:
        module = NormalModule.of(name)
        complete = name in COMPLETE_NAMES
        files[f"{PACKAGE}/viscoelastic/{name}.py"] = viscoelastic.module_source(module)
        files[f"{PACKAGE}/adhesive/{name}.py"] = (
            _complete_adhesive(name) if complete else adhesive.module_source(module)
        )
        files[f"{PACKAGE}/tangential/{name}.py"] = (
            refusal_source(load(name), "tangential") if complete else tangential.module_source(module)
        )
    for load_ in LOADS:
        files[f"{PACKAGE}/loads/{load_.name}.py"] = loads.module_source(load_)
    return files | _packages(names)


def _complete_adhesive(name: str) -> str:
    return punch_source(load(name)) if name == "flat_punch" else refusal_source(load(name), "adhesive")


def _packages(names: Sequence[str]) -> dict[str, str]:
    titles = {
        "adhesive": "Adhesive contact of a rigid indenter with an elastic half space",
        "tangential": "Tangential contact with friction, with a zone of stick",
        "viscoelastic": "Contact with a viscoelastic half space, while it grows",
    }
    files = {f"{PACKAGE}/{group}/__init__.py": package_source(title, names) for group, title in titles.items()}
    own = sorted(load.name for load in LOADS)
    files[f"{PACKAGE}/loads/__init__.py"] = package_source("Displacement under a prescribed pressure", own)
    return files
