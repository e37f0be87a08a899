"""The library a scene is linked from: runtime, module of the profile, modules of the physics on it."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import cache
from pathlib import Path

from .. import work
from ..emit import physics, python
from ..emit.nodes import nodes_source
from ..emit.physics import adhesive, tangential
from ..emit.physics.text import SIGNATURE, NormalModule
from ..entry import Entry
from ..index import NoCatalogueError, load
from ..profiles.profile import Profile
from .library import Module
from .module import COUNTS

OWN = Path(__file__).with_name("runtime")


@cache
def runtime() -> dict[str, Module]:
    paths = [p for folder in (python.RUNTIME, physics.RUNTIME, OWN) for p in sorted(folder.glob("*.py"))]
    return {path.stem: Module(path.stem, path.read_text()) for path in paths} | {
        "_nodes": Module("_nodes", nodes_source(COUNTS))
    }


def stored_entries(profile: Profile) -> dict[str, Entry]:
    """The entries of a profile of the catalogue as they were verified, or derived anew where none are stored."""
    record = evidence(profile.name)
    if record:
        return work.read_entries(profile, record["entries"])
    from ..contact.normal import derive

    return derive(profile)


def evidence(name: str) -> dict[str, object] | None:
    """The stored record of a profile of the catalogue."""
    try:
        path = load().folder.parent / "evidence" / f"{name}.json"
        record: dict[str, object] = json.loads(path.read_bytes())
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
    found = SIGNATURE.findall(normal)
    signatures = {name: [part.split(":")[0] for part in text.split(", ")] for name, text in found}
    own = NormalModule(profile, entries, {name: list(map(str.strip, names)) for name, names in signatures.items()})
    build = {"adhesive": adhesive, "tangential": tangential}[wanted]
    key = f"{wanted}.{profile.name}"
    return {**modules, key: Module(key, build.module_source(own))}
