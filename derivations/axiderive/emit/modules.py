"""The generated package: the modules of all systems, from the entries of all problems."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import PurePosixPath

import sympy as sp

from ..contact import systems
from ..entry import Entry
from ..notation import coefficients, e
from . import graded, physics, plane, python
from .private import parameter_name
from .public import PACKAGE
from .symbols import symbols_sources

Derived = Mapping[str, Mapping[str, Entry]]
"""Entries by key of the problem and suffix."""


def package_sources(derived: Derived) -> dict[str, str]:
    """The files of the package as `{path below catalogue/: text}`."""
    families: dict[str, dict[str, Mapping[str, Entry]]] = {system.name: {} for system in systems.SYSTEMS}
    for key, entries in derived.items():
        problem = systems.problem(key)
        families[problem.system.name][problem.name] = entries
    files = python.module_sources(families["normal"])
    normal_texts = {name: files[f"{PACKAGE}/normal/{name}.py"] for name in families["normal"]}
    files |= physics.module_sources(families, normal_texts)
    files |= graded.module_sources(families["graded.normal"], families)
    files |= plane.module_sources(families["plane"])
    tables = symbols_sources(parameter_names(derived), _arguments(derived))
    files |= {f"{PACKAGE}/{name}": text for name, text in tables.items()}
    files[f"{PACKAGE}/__init__.py"] = python.package_source(_packages(files))
    return files


def parameter_names(derived: Derived) -> set[str]:
    """The keyword parameters with a domain of their own, by their names in the notation."""
    unbound = {coefficients, e}  # a sequence, and a place between the edges of the strip
    found = set()
    for key, entries in derived.items():
        loaded = systems.problem(key).system.name == "viscoelastic"
        for entry in entries.values():
            # a depth or a load that is held is a keyword beside the time
            held = entry.quantity.arguments[1:] if loaded else ()
            found |= {parameter_name(symbol) for symbol in (*entry.parameters, *held) if symbol not in unbound}
    return found


def _arguments(derived: Derived) -> set[sp.Symbol | sp.IndexedBase]:
    """The symbols of all fields and parameters."""
    every = [entry for entries in derived.values() for entry in entries.values()]
    return {symbol for entry in every for symbol in (*entry.quantity.arguments, *entry.parameters)}


def _packages(paths: Iterable[str]) -> list[str]:
    """The public names directly below the package: folders with modules, and modules."""
    below = {PurePosixPath(path).parts[1] for path in paths if path.startswith(f"{PACKAGE}/")}
    return sorted(name.removesuffix(".py") for name in below if not name.startswith("_") and name != "py.typed")
