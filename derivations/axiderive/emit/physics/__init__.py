"""Packages beyond the normal contact, as thin modules that state each rule of superposition once."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from ...profiles import COMPLETE_NAMES, NAMES
from . import adhesive
from .bounds import bounds_source
from .text import NormalModule

RUNTIME = Path(__file__).with_name("runtime")
PACKAGE = "axicontact"


def module_sources(names: Iterable[str] = NAMES) -> dict[str, str]:
    """The files of all physics as `{path below catalogue/: text}`."""
    files = {f"{PACKAGE}/{path.name}": path.read_text() for path in sorted(RUNTIME.glob("*.py"))}
    files[f"{PACKAGE}/_bounds.py"] = bounds_source()
    for name in names:
        module = NormalModule.of(name)
        if name not in COMPLETE_NAMES:
            files[f"{PACKAGE}/adhesive/{name}.py"] = adhesive.module_source(module)
    files[f"{PACKAGE}/adhesive/__init__.py"] = '"""Adhesive contact."""\n'
    return files
