"""Packages beyond the normal contact, as thin modules that state each rule of superposition once."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

from ...entry import Entry
from ...profiles.loads import Load
from ...profiles.profile import Profile
from . import adhesive, detachment, loads, materials, refusals, tangential, viscoelastic
from .text import PACKAGE, NormalModule

RUNTIME = Path(__file__).parents[2] / "runtime" / "physics"
TITLES = {
    "adhesive": "Adhesive contact of a rigid indenter with an elastic half-space",
    "tangential": "Tangential contact with friction, with a zone of stick",
    "viscoelastic": "Contact with a viscoelastic half-space, while it grows",
    "loads": "Displacement under a prescribed pressure",
}
WRITERS = {
    "adhesive": lambda module, entries: _adhesive(module.profile)(module, entries),
    "tangential": tangential.module_source,
    "viscoelastic": viscoelastic.module_source,
}
Derived = Mapping[str, Mapping[str, Mapping[str, Entry]]]


def module_sources(derived: Derived, normal_texts: Mapping[str, str]) -> dict[str, str]:
    """The files of these packages as `{path below catalogue/: text}`.

    `derived` holds the entries by system, profile and suffix; `normal_texts` the
    module of the normal contact of each profile, on which the others rest.
    """
    modules = {name: NormalModule.read(derived["normal"][name], text) for name, text in normal_texts.items()}
    files = {f"{PACKAGE}/{path.name}": path.read_text() for path in sorted(RUNTIME.glob("*.py"))}
    if constants := derived["materials"].get("materials"):
        files[f"{PACKAGE}/materials.py"] = materials.module_source(constants)
    for group in WRITERS:
        written = {name: text for name, module in sorted(modules.items()) if (text := _module(group, module, derived))}
        files |= {f"{PACKAGE}/{group}/{name}.py": text for name, text in written.items()}
        files[f"{PACKAGE}/{group}/__init__.py"] = refusals.package_source(TITLES[group], sorted(written))
    for name, entries in sorted(derived["loads"].items()):
        own_load = entries["w"].profile
        assert isinstance(own_load, Load)
        files[f"{PACKAGE}/loads/{name}.py"] = loads.module_source(own_load, entries["w"])
    files[f"{PACKAGE}/loads/__init__.py"] = refusals.package_source(TITLES["loads"], sorted(derived["loads"]))
    return files


def _module(group: str, module: NormalModule, derived: Derived) -> str:
    """The module of one profile; empty if its problem was left out."""
    own = derived[group].get(module.profile.name)
    if own is not None:
        return WRITERS[group](module, own)
    refused = module.profile.complete and group != "viscoelastic"
    return refusals.module_source(module.profile, group) if refused else ""


def _adhesive(profile: Profile) -> Callable[[NormalModule, Mapping[str, Entry]], str]:
    return adhesive.module_source if profile.compact else detachment.module_source
