"""The generated package: every module as text, a pure function of the derived entries."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import PurePosixPath

import sympy as sp

from ..entry import Entry
from ..notation import coefficients, e
from ..physics.medium import GRADED
from ..physics.systems import SYSTEMS, System, problem
from . import subsurface
from .module import PACKAGE, PLACE, Module, package_source, runtime_sources
from .private import parameter_name
from .programs import program_sources
from .systems import alone, refusal_source, superposed
from .tables import kernels_source, nodes_source, symbols_sources

NODE_COUNTS = (8, 16, 24, 32, 64, 128)
TITLES = {
    "": "Closed forms of elastic contact as NumPy functions, a package per kind of contact, a module per profile",
    GRADED.name: "Contact on a half-space whose modulus grows as a power of the depth",
    **{system.name: system.said.package for system in SYSTEMS if system.said.package},
}
"""Of the packages, by their names below the first."""
MEMBERS = {"": "attribute", "normal": "profile", "subsurface": "profile"}
"""What they call their modules in an error message, where it is another word."""
Derived = Mapping[str, Mapping[str, Entry]]
"""Entries by key of the problem and suffix."""


def package_sources(
    derived: Derived, kernels: str | None = None, written: Mapping[str, str] | None = None
) -> dict[str, str]:
    """The files of the package as `{path below catalogue/: text}`.

    `kernels` is the text of `kernels.py` where it is known, as to fit them takes six seconds, and `written` what
    `module_sources` has of all profiles.
    """
    files = shared_sources(kernels)
    tables = symbols_sources(parameter_names(derived), _arguments(derived))
    files |= {f"{PACKAGE}/{PLACE}/{name}": text for name, text in tables.items()}
    files |= module_sources(derived) if written is None else written
    for package, title in TITLES.items():
        place = "/".join([PACKAGE, *filter(None, package.split("."))])
        shared = subsurface.SHARED if package == subsurface.SYSTEM.name else ()
        names = sorted([*_names(place, files), *shared])
        text = package_source(title, names, MEMBERS.get(package, "member"))
        files[f"{place}/__init__.py"] = subsurface.package(text) if shared else text
    return files | program_sources(files)


def module_sources(derived: Derived) -> dict[str, str]:
    """The modules of some profiles, all problems of each, as `{path: text}`; no profile needs another one's."""
    found: dict[str, dict[str, Mapping[str, Entry]]] = {system.name: {} for system in SYSTEMS}
    for key, entries in derived.items():
        own = problem(key)
        found[own.system.name][own.name] = entries
    files: dict[str, str] = {}
    below: dict[str, dict[str, Module]] = {}
    for system in SYSTEMS:
        below[system.name] = modules(system, found, below)
        files |= {module.path: module.source() for module in below[system.name].values()}
        files |= _refusals(system, found)
    return files


def modules(
    system: System, found: Mapping[str, Mapping[str, Mapping[str, Entry]]], below: Mapping[str, Mapping[str, Module]]
) -> dict[str, Module]:
    """The modules of a system by profile, from entries by system and profile and from the modules `below`."""
    own = sorted(found[system.name].items())
    if system.base is None:
        return {name: alone(system, entries) for name, entries in own}
    plain, base = found[system.base.name], below[system.base.name]
    return {name: superposed(system, entries, plain[name], base[name].parameters) for name, entries in own}


def _refusals(system: System, found: Mapping[str, Mapping[str, Mapping[str, Entry]]]) -> dict[str, str]:
    """The modules of profiles for which the system holds no functions."""
    names = set(found[system.base.name]) - set(found[system.name]) if system.base else set()
    reasons = {name: system.refusal(system.pool.load(name)) for name in names}
    place = system.package.replace(".", "/")
    return {f"{place}/{name}.py": refusal_source(system, system.pool.load(name)) for name in reasons if reasons[name]}


def shared_sources(kernels: str | None = None) -> dict[str, str]:
    """What all packages share as `{path: text}`."""
    files = {f"{PACKAGE}/{path}": text for path, text in runtime_sources().items()}
    files[f"{PACKAGE}/py.typed"] = ""
    files[f"{PACKAGE}/{PLACE}/nodes.py"] = nodes_source(NODE_COUNTS)
    files[f"{PACKAGE}/{PLACE}/kernels.py"] = kernels_source() if kernels is None else kernels
    return files


def parameter_names(derived: Derived) -> set[str]:
    """The keyword parameters with a domain of their own, by their names in the notation."""
    unbound = {coefficients, e}  # a sequence, and a place between the edges of the strip
    found = set()
    for key, entries in derived.items():
        physics = problem(key).system.physics
        loaded = physics.laws
        # fields below the surface take what the entries, their sums, do not hold
        found |= {parameter_name(symbol) for symbol in physics.material}
        for entry in entries.values():
            # a depth or a load that is held is a keyword beside the time
            held = entry.quantity.arguments[1:] if loaded else ()
            found |= {parameter_name(symbol) for symbol in (*entry.parameters, *held) if symbol not in unbound}
    return found


def _arguments(derived: Derived) -> set[sp.Symbol | sp.IndexedBase]:
    """The symbols of all fields and parameters."""
    every = [entry for entries in derived.values() for entry in entries.values()]
    return {symbol for entry in every for symbol in (*entry.quantity.arguments, *entry.parameters)}


def _names(place: str, paths: Iterable[str]) -> list[str]:
    """The public names directly below a package: folders with modules, and modules."""
    below = {PurePosixPath(path).relative_to(place).parts[0] for path in paths if path.startswith(f"{place}/")}
    return sorted(name.removesuffix(".py") for name in below if not name.startswith("_") and name != "py.typed")
