"""Packages of contact on the power-law graded half-space: axicontact.graded.normal, .adhesive, .tangential."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from ...entry import Entry
from ...physics import adhesive as stuck
from ...physics import normal as pressed
from ...physics import tangential as slipping
from ...physics.systems import BY_NAME, System
from ...profiles import load
from ..physics import refusals
from ..physics.refusals import package_source
from ..physics.text import PACKAGE
from . import adhesive, complete, detachment, normal, tangential

Entries = Mapping[str, Entry]
Derived = Mapping[str, Mapping[str, Entries]]
"""Entries by system (graded.normal, graded.adhesive, graded.tangential), profile and suffix."""
TITLES = {
    "normal": "Normal contact of a rigid indenter with a power-law graded half-space",
    "adhesive": "Adhesive contact of a rigid indenter with a power-law graded half-space",
    "tangential": "Tangential contact with friction on a power-law graded half-space",
}


def module_sources(names: Iterable[str], derived: Derived) -> dict[str, str]:
    """The files of the graded packages as `{path below catalogue/: text}`."""
    names = sorted(names)
    files: dict[str, str] = {}
    for group, title in TITLES.items():
        system = BY_NAME[f"graded.{group}"]
        modules = {name: text for name in names if (text := _module(system, name, derived))}
        files |= {f"{PACKAGE}/graded/{group}/{name}.py": text for name, text in modules.items()}
        files[f"{PACKAGE}/graded/{group}/__init__.py"] = package_source(title, sorted(modules))
    title = "Contact on a half-space whose modulus grows as a power of the depth"
    return files | {f"{PACKAGE}/graded/__init__.py": package_source(title, sorted(TITLES))}


def _module(system: System, name: str, derived: Derived) -> str:
    """The module of one profile; empty if its problem was left out."""
    own = derived[system.name].get(name)
    if own is not None:
        return WRITERS[system.physics](own, derived["graded.normal"][name])
    profile = load(name)
    return refusals.module_source(system, profile) if system.refusal(profile) else ""


def _normal(own: Entries, plain: Entries) -> str:
    return (normal if _grows(own) else complete).module_source(own)


def _adhesive(own: Entries, plain: Entries) -> str:
    return adhesive.module_source(own, plain) if _grows(own) else detachment.module_source(own)


def _grows(entries: Entries) -> bool:
    return next(iter(entries.values())).profile.compact


WRITERS = {pressed.PHYSICS: _normal, stuck.PHYSICS: _adhesive, slipping.PHYSICS: tangential.module_source}
"""The writer of a module by its physics, from its entries and those of the normal contact."""
