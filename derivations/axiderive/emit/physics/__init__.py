"""Packages beyond the normal contact, as thin modules that state each rule of superposition once."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from ...entry import Entry
from ...profiles.loads import Load
from ..private import parameter_name
from . import adhesive, flat_punch, loads, materials, refusals, tangential, viscoelastic
from .text import PACKAGE, NormalModule

RUNTIME = Path(__file__).with_name("runtime")
TITLES = {
    "adhesive": "Adhesive contact of a rigid indenter with an elastic half space",
    "tangential": "Tangential contact with friction, with a zone of stick",
    "viscoelastic": "Contact with a viscoelastic half space, while it grows",
    "loads": "Displacement under a prescribed pressure",
}
WRITERS = {
    "adhesive": adhesive.module_source,
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
    files[f"{PACKAGE}/materials.py"] = materials.module_source(derived["materials"]["materials"])
    for group, write in WRITERS.items():
        for name, module in sorted(modules.items()):
            own = derived[group].get(name)
            files[f"{PACKAGE}/{group}/{name}.py"] = (
                write(module, own) if own is not None else _without_entries(module, group)
            )
        files[f"{PACKAGE}/{group}/__init__.py"] = refusals.package_source(TITLES[group], sorted(modules))
    for name, entries in sorted(derived["loads"].items()):
        own_load = entries["w"].profile
        assert isinstance(own_load, Load)
        files[f"{PACKAGE}/loads/{name}.py"] = loads.module_source(own_load, entries["w"])
    files[f"{PACKAGE}/loads/__init__.py"] = refusals.package_source(TITLES["loads"], sorted(derived["loads"]))
    return files


def _without_entries(module: NormalModule, group: str) -> str:
    if group == "adhesive" and module.profile.name == "flat_punch":
        return flat_punch.module_source(module)
    return refusals.module_source(module.profile, group)


def parameter_names(derived: Derived) -> set[str]:
    """The parameters these packages check, by their names in the notation."""
    systems = ("materials", *TITLES)
    entries = [entry for system in systems for own in derived[system].values() for entry in own.values()]
    loading = [entry.quantity.arguments[1:] for own in derived["viscoelastic"].values() for entry in own.values()]
    groups = [*(entry.parameters for entry in entries), *loading]
    return {parameter_name(symbol) for group in groups for symbol in group}
