"""Packages beyond the normal contact, as thin modules that state each rule of superposition once."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

from ...entry import Entry
from ...physics import Physics
from ...physics import adhesive as stuck
from ...physics import tangential as slipping
from ...physics import viscoelastic as creeping
from ...physics.systems import BY_NAME, System
from . import adhesive, detachment, loads, materials, refusals, tangential, viscoelastic
from .text import PACKAGE, NormalModule

TITLES = {
    "adhesive": "Adhesive contact of a rigid indenter with an elastic half-space",
    "tangential": "Tangential contact with friction, with a zone of stick",
    "viscoelastic": "Contact with a viscoelastic half-space, while it grows",
    "loads": "Displacement under a prescribed pressure",
}
Derived = Mapping[str, Mapping[str, Mapping[str, Entry]]]


def module_sources(derived: Derived, normal_texts: Mapping[str, str]) -> dict[str, str]:
    """The files of these packages as `{path below catalogue/: text}`.

    `derived` holds the entries by system, profile and suffix; `normal_texts` the
    module of the normal contact of each profile, on which the others rest.
    """
    modules = {name: NormalModule.read(derived["normal"][name], text) for name, text in normal_texts.items()}
    files: dict[str, str] = {}
    if constants := derived["materials"].get("materials"):
        files[f"{PACKAGE}/materials.py"] = materials.module_source(constants)
    for kind in WRITERS:
        system = BY_NAME[kind.name]
        written = {name: text for name, module in sorted(modules.items()) if (text := _module(system, module, derived))}
        files |= {f"{PACKAGE}/{system.name}/{name}.py": text for name, text in written.items()}
        files[f"{PACKAGE}/{system.name}/__init__.py"] = refusals.package_source(TITLES[system.name], sorted(written))
    for name, entries in sorted(derived["loads"].items()):
        files[f"{PACKAGE}/loads/{name}.py"] = loads.module_source(entries["w"])
    files[f"{PACKAGE}/loads/__init__.py"] = refusals.package_source(TITLES["loads"], sorted(derived["loads"]))
    return files


def _module(system: System, module: NormalModule, derived: Derived) -> str:
    """The module of one profile; empty if its problem was left out."""
    own = derived[system.name].get(module.profile.name)
    if own is not None:
        return WRITERS[system.physics](module, own)
    return refusals.module_source(system, module.profile) if system.refusal(module.profile) else ""


def _adhesive(module: NormalModule, entries: Mapping[str, Entry], *, interface: bool = True) -> str:
    if not module.profile.compact:
        return detachment.module_source(module, entries)
    return adhesive.module_source(module, entries, interface=interface)


WRITERS: dict[Physics, Callable[[NormalModule, Mapping[str, Entry]], str]] = {
    stuck.PHYSICS: _adhesive,
    slipping.PHYSICS: tangential.module_source,
    creeping.PHYSICS: viscoelastic.module_source,
}
"""The writer of a module by its physics, from the module of the normal contact and the entries."""
FORMULAS: dict[Physics, Callable[[NormalModule, Mapping[str, Entry]], str]] = {
    stuck.PHYSICS: partial(_adhesive, interface=False),
    slipping.PHYSICS: partial(tangential.module_source, interface=False),
    creeping.PHYSICS: lambda module, entries: viscoelastic.formulas_source(module),
}
"""The same with the private functions alone."""
