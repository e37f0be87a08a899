"""Packages of contact on the power-law graded half space: axicontact.graded.normal, .adhesive, .tangential."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from ...contact.medium import GRADED
from ...entry import Entry
from ...profiles import COMPLETE_NAMES, NAMES, load
from ..physics.refusals import package_source
from . import normal
from .module import RUNTIME

PACKAGE = "axicontact"
Derived = Mapping[str, Mapping[str, Mapping[str, Entry]]]
"""Entries by system (normal, adhesive, tangential), profile and suffix."""


def module_sources(names: Iterable[str] = NAMES, derived: Derived | None = None) -> dict[str, str]:
    """The files of the graded packages as `{path below catalogue/: text}`."""
    names = sorted(names)
    derived = derive(names) if derived is None else derived
    files = {f"{PACKAGE}/{path.name}": path.read_text() for path in sorted(RUNTIME.glob("*.py"))}
    for name in names:
        if name not in COMPLETE_NAMES:
            files[f"{PACKAGE}/graded/normal/{name}.py"] = normal.module_source(derived["normal"][name])
    return files | _packages(names)


def derive(names: Sequence[str]) -> dict[str, dict[str, dict[str, Entry]]]:
    """The entries of these profiles."""
    from ...contact import adhesive as stuck
    from ...contact import normal as plain
    from ...contact import tangential as slipping

    compact = [name for name in names if name not in COMPLETE_NAMES]
    return {
        "normal": {name: plain.derive(load(name), GRADED) for name in names},
        "adhesive": {name: stuck.derive(load(name), GRADED) for name in compact},
        "tangential": {name: slipping.derive(load(name), GRADED) for name in compact},
    }


def _packages(names: Sequence[str]) -> dict[str, str]:
    titles = {"normal": "Normal contact on a power-law graded half space"}
    files = {f"{PACKAGE}/graded/{group}/__init__.py": package_source(title, names) for group, title in titles.items()}
    files[f"{PACKAGE}/graded/__init__.py"] = package_source(
        "Contact on a power-law graded half space", ("adhesive", "normal", "tangential")
    )
    return files
