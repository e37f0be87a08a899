"""Packages of contact on the power-law graded half-space: axicontact.graded.normal, .adhesive, .tangential."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from ...entry import Entry
from ...profiles import COMPLETE_NAMES, load
from ..physics.refusals import package_source
from ..physics.text import PACKAGE
from . import adhesive, complete, detachment, normal, refusals, tangential

Derived = Mapping[str, Mapping[str, Mapping[str, Entry]]]
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
        modules = {name: text for name in names if (text := _module(group, name, derived))}
        files |= {f"{PACKAGE}/graded/{group}/{name}.py": text for name, text in modules.items()}
        files[f"{PACKAGE}/graded/{group}/__init__.py"] = package_source(title, sorted(modules))
    title = "Contact on a half-space whose modulus grows as a power of the depth"
    return files | {f"{PACKAGE}/graded/__init__.py": package_source(title, sorted(TITLES))}


def _module(group: str, name: str, derived: Derived) -> str:
    """The module of one profile; empty if its problem was left out."""
    plain, own = derived["graded.normal"][name], derived[f"graded.{group}"].get(name)
    compact = name not in COMPLETE_NAMES
    if own is None:
        return "" if compact else refusals.module_source(load(name), group)
    if group == "normal":
        return normal.module_source(plain) if compact else complete.module_source(plain)
    if group == "adhesive":
        return adhesive.module_source(own, plain) if compact else detachment.module_source(own)
    return tangential.module_source(own, plain)
