"""The generated package: the modules of all systems, from the entries of all problems."""

from __future__ import annotations

from collections.abc import Mapping

from ..contact import systems
from ..entry import Entry
from . import python

Derived = Mapping[str, Mapping[str, Entry]]
"""Entries by key of the problem and suffix."""


def package_sources(derived: Derived) -> dict[str, str]:
    """The files of the package as `{path below catalogue/: text}`."""
    families: dict[str, dict[str, Mapping[str, Entry]]] = {system.name: {} for system in systems.SYSTEMS}
    for key, entries in derived.items():
        problem = systems.problem(key)
        families[problem.system.name][problem.name] = entries
    return python.module_sources(families["normal"])
