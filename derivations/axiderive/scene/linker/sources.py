"""The library a scene is linked from: runtime, module of the profile, modules of the physics on it."""

from __future__ import annotations

import ast
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ...abel.reduce import NotReducibleError
from ...code.graded.families import family
from ...code.module import PLACE, RUNTIME
from ...code.python import NODE_COUNTS
from ...code.systems import alone, superposed
from ...code.tables import kernels_source, nodes_source
from ...entry import Entry
from ...physics.systems import BY_NAME, System
from ...profiles.profile import Profile
from ...store.index import NoCatalogueError, package
from ...store.records import read_entry
from ..interface import Kind
from .library import Module

FOR_SCENES = "over_profile"
"""A module of the run time that scenes alone have."""
SHORTER = {"functions": ("rational", "beside"), "special": ("dawson",), "shapes/arcs": ("arc_strips",)}
"""Functions of which it has a shorter equal, by their file."""


class _Runtime(dict[str, Module]):
    """The modules of the runtime by name, each parsed when it is asked for: a scene needs a third of them."""

    def __missing__(self, name: str) -> Module:
        file = name.removeprefix(f"{PLACE}.").replace(".", "/")
        match file:
            case "nodes":
                found = Module(name, nodes_source(NODE_COUNTS))
            case "kernels":
                found = _polynomials(Module(name, stored(f"{PLACE}/kernels.py") or kernels_source()))
            case _:
                folder = Path(__file__).with_name("runtime") if file == FOR_SCENES else RUNTIME
                found = Module(name, (folder / f"{file}.py").read_text())
        for own in SHORTER.get(file, ()):
            found.definitions[own] = self[f"{PLACE}.{FOR_SCENES}"].definitions[own]
        return self.setdefault(name, found)


RUN_TIME = _Runtime()


def _polynomials(kernels: Module) -> Module:
    """The module with kernels of denominator 1 as coefficients in descending order, for `np.polyval`."""
    for own in kernels.definitions.values():
        match own.node:
            case ast.Assign(value=ast.Tuple(elts=[ast.Tuple(elts=top), ast.Tuple(elts=[ast.Constant(value=1.0)])])):
                own.node.value = ast.Tuple(top[::-1], ast.Load())
    return kernels


def stored(path: str) -> str | None:
    """A file of the package in the catalogue, if there is one."""
    try:
        return (package() / path).read_text()
    except (NoCatalogueError, OSError):
        return None


def stored_entries(profile: Profile, kind: Kind) -> dict[str, Entry]:
    """The entries of a profile of the catalogue as they were verified, or derived anew where none are stored."""
    record = evidence(kind.plain.pool.id(profile.name))
    if record:
        return {suffix: read_entry(entry, profile) for suffix, entry in record["entries"].items()}
    return kind.plain.derive(profile)


def evidence(name: str) -> dict[str, Any] | None:
    """The stored record of a profile of the catalogue."""
    try:
        record: dict[str, Any] | None = json.loads(stored(f"../evidence/{name}.json") or "null")
    except ValueError:
        return None
    return record


def graded_refusal(profile: Profile) -> str:
    """Why no module of a profile is emitted for a graded half-space; empty if one is."""
    try:
        family(profile)
    except (NotReducibleError, AssertionError, ValueError):
        return (
            "on the graded half-space there are rules for sums of powers of r, with at most one break of "
            "straight or parabolic pieces, and not for these pieces"
        )
    return ""


class Library(dict[str, Module]):
    """All modules that the functions of a scene can reach, each made when it is asked for.

    Parameters
    ----------
    entries : mapping
        The entries of normal contact of a profile.
    normal : str
        The text of its module; empty for a profile of the catalogue.
    """

    def __init__(self, entries: Mapping[str, Entry], normal: str) -> None:
        super().__init__()
        self.entries, self.normal = entries, normal
        self.profile = next(iter(entries.values())).profile

    def __missing__(self, name: str) -> Module:
        if name.startswith(PLACE):
            return RUN_TIME[name]
        return self.setdefault(name, Module(name, self._text(BY_NAME[name.rpartition(".")[0]])))

    def _text(self, system: System) -> str:
        """The module of a system as the catalogue has it, or written: by itself, or what it adds to the one below."""
        known, below, graded = not self.normal, system.base, system.medium.graded
        if known and (text := stored(f"{system.name.replace('.', '/')}/{self.profile.name}.py")):
            return text
        if below is None:
            return self.normal if self.normal and not graded else alone(system, self._entries(system)).source()
        plain, found = self._entries(below), self[f"{below.name}.{self.profile.name}"].definitions
        parameters = {name: own.parameters for name, own in found.items()}
        # a law takes from the normal contact what its functions say
        own = {} if system.physics.laws else system.derive(self.profile, plain)
        return superposed(system, own, plain, parameters, interface=False).source()

    def _entries(self, system: System) -> Mapping[str, Entry]:
        """Those of normal contact on the half-space of a system."""
        return system.derive(self.profile) if system.medium.graded else self.entries
