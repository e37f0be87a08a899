"""Packages of contact on the power-law graded half space: axicontact.graded.normal, .adhesive, .tangential."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from ...entry import Entry
from ...profiles import COMPLETE_NAMES, load
from ..physics.refusals import package_source
from ..physics.text import PACKAGE
from . import adhesive, complete, detachment, normal, refusals, tangential
from .module import RUNTIME

Derived = Mapping[str, Mapping[str, Mapping[str, Entry]]]
"""Entries by system (graded.normal, graded.adhesive, graded.tangential), profile and suffix."""
TITLES = {
    "normal": "Normal contact of a rigid indenter with a power-law graded half space",
    "adhesive": "Adhesive contact of a rigid indenter with a power-law graded half space",
    "tangential": "Tangential contact with friction on a power-law graded half space",
}


def module_sources(names: Iterable[str], derived: Derived) -> dict[str, str]:
    """The files of the graded packages as `{path below catalogue/: text}`."""
    names = sorted(names)
    files = {f"{PACKAGE}/{path.name}": path.read_text() for path in sorted(RUNTIME.glob("*.py"))}
    for name in names:
        for group, text in _modules(name, derived).items():
            files[f"{PACKAGE}/graded/{group}/{name}.py"] = text
    for group, title in TITLES.items():
        files[f"{PACKAGE}/graded/{group}/__init__.py"] = package_source(title, names)
    title = "Contact on a half space whose modulus grows as a power of the depth"
    return files | {f"{PACKAGE}/graded/__init__.py": package_source(title, sorted(TITLES))}


def _modules(name: str, derived: Derived) -> dict[str, str]:
    """The module of one profile in each package."""
    entries = derived["graded.normal"][name]
    if name not in COMPLETE_NAMES:
        return {
            "normal": normal.module_source(entries),
            "adhesive": adhesive.module_source(derived["graded.adhesive"][name], entries),
            "tangential": tangential.module_source(derived["graded.tangential"][name], entries),
        }
    profile, peeled = load(name), derived["graded.adhesive"].get(name)
    return {
        "normal": complete.module_source(entries),
        "adhesive": detachment.module_source(peeled) if peeled else refusals.module_source(profile, "adhesive"),
        "tangential": refusals.module_source(profile, "tangential"),
    }
