"""The library a scene is linked from: runtime, module of the profile, modules of the physics on it."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

from ..contact import adhesive as stuck
from ..contact import normal as plain
from ..contact import tangential as slipping
from ..contact.medium import GRADED
from ..emit import physics, python
from ..emit.graded import normal as graded_normal
from ..emit.graded.module import RUNTIME as GRADED_RUNTIME
from ..emit.imports import RUNTIME
from ..emit.nodes import nodes_source
from ..emit.physics import adhesive, tangential
from ..emit.physics.text import NormalModule
from ..entry import Entry
from ..index import NoCatalogueError, load
from ..profiles.profile import Profile
from ..records import read_entry
from .library import Module
from .module import COUNTS

OWN = Path(__file__).with_name("runtime")


@cache
def runtime() -> dict[str, Module]:
    paths = [p for folder in (RUNTIME, physics.RUNTIME, GRADED_RUNTIME, OWN) for p in sorted(folder.glob("*.py"))]
    return {path.stem: Module(path.stem, path.read_text()) for path in paths} | {
        "_nodes": Module("_nodes", nodes_source(COUNTS))
    }


def stored_entries(profile: Profile) -> dict[str, Entry]:
    """The entries of a profile of the catalogue as they were verified, or derived anew where none are stored."""
    record = evidence(profile.name)
    if record:
        return {suffix: read_entry(entry, profile) for suffix, entry in record["entries"].items()}
    return plain.derive(profile)


def evidence(name: str) -> dict[str, Any] | None:
    """The stored record of a profile of the catalogue."""
    try:
        path = load().folder.parent / "evidence" / f"{name}.json"
        record: dict[str, Any] = json.loads(path.read_bytes())
    except (NoCatalogueError, OSError, ValueError):
        return None
    return record


def stored_module(name: str, entries: Mapping[str, Entry]) -> str:
    """The text of the normal module of a profile of the catalogue."""
    try:
        return (load().folder / "normal" / f"{name}.py").read_text()
    except (NoCatalogueError, OSError):
        return python.module_source(entries)


def library(profile: Profile, entries: Mapping[str, Entry], normal: str, wanted: str) -> dict[str, Module]:
    """All modules that the functions of one physics on one profile can reach.

    Parameters
    ----------
    profile, entries : Profile, mapping
        The profile and its entries of normal contact.
    normal : str
        Text of its normal module.
    wanted : str
        Name of the physics.
    """
    modules = {**runtime(), f"normal.{profile.name}": Module(f"normal.{profile.name}", normal)}
    if wanted == "normal":
        return modules
    if wanted == "graded":
        key = f"graded.{profile.name}"
        return {**modules, key: Module(key, graded_normal.module_source(plain.derive(profile, GRADED)))}
    own, key = NormalModule.read(entries, normal), f"{wanted}.{profile.name}"
    write, above = {
        "adhesive": (adhesive.module_source, stuck.derive),
        "tangential": (tangential.module_source, slipping.derive),
    }[wanted]
    return {**modules, key: Module(key, write(own, above(profile)))}
