"""The library a scene is linked from: runtime, module of the profile, modules of the physics on it."""

from __future__ import annotations

import ast
import json
from collections import ChainMap
from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any

from ... import profiles
from ...abel.reduce import NotReducibleError
from ...code.graded.families import family
from ...code.module import PLACE, RUNTIME
from ...code.python import NODE_COUNTS
from ...code.systems import alone, superposed
from ...code.tables import kernels_source, nodes_source
from ...entry import Entry
from ...notation import r
from ...physics import normal as plain
from ...physics import viscoelastic as creeping
from ...physics.medium import GRADED
from ...physics.systems import BY_NAME, System
from ...profiles.profile import Profile
from ...store.index import NoCatalogueError, package
from ...store.records import read_entry
from ..interface import NORMAL, Kind
from .library import Module

CREEPING = BY_NAME["viscoelastic"]
FOR_SCENES = "over_profile"
"""A module of the run time that scenes alone have."""
SHORTER = {"functions": ("rational", "beside"), "special": ("dawson",), "shapes/arcs": ("arc_strips",)}
"""Functions of which it has a shorter equal, by their file."""


class _Runtime(dict[str, Module]):
    """The modules of the runtime by name, each parsed when it is asked for: a scene needs a third of them."""

    def __missing__(self, name: str) -> Module:
        path = f"{name.replace('.', '/')}.py"
        if path == f"{PLACE}/nodes.py":
            found = Module(name, nodes_source(NODE_COUNTS))
        elif path == f"{PLACE}/kernels.py":
            found = _polynomials(Module(name, stored(path) or kernels_source()))
        else:
            file = path.removeprefix(f"{PLACE}/").removesuffix(".py")
            folder = Path(__file__).with_name("runtime") if file == FOR_SCENES else RUNTIME
            if not path.startswith(f"{PLACE}/") or not (folder / f"{file}.py").is_file():
                raise KeyError(name)
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
        path = package().parent / "evidence" / f"{name}.json"
        record: dict[str, Any] = json.loads(path.read_bytes())
    except (NoCatalogueError, OSError, ValueError):
        return None
    return record


def stored_module(name: str, entries: Mapping[str, Entry], kind: Kind) -> str:
    """The text of the normal module of a profile of the catalogue, of the plane one, or of that of a pressure."""
    return stored(f"{kind.plain.name}/{name}.py") or alone(kind.plain, entries).source()


def _parameters(module: Module) -> dict[str, list[str]]:
    """What each function of a module takes."""
    return {name: own.parameters for name, own in module.definitions.items()}


@cache
def _viscoelastic(name: str) -> str:
    """The viscoelastic module of a profile of the catalogue."""
    text = stored(f"viscoelastic/{name}.py")
    if text is None:
        profile = profiles.load(name)
        entries = stored_entries(profile, NORMAL)
        normal = Module(name, stored_module(name, entries, NORMAL))
        text = superposed(CREEPING, creeping.derive(profile), entries, _parameters(normal)).source()
    return text


def ramps(profile: Profile | None) -> bool:
    """Whether the force under a ramp of the depth is known: that on the elastic half-space is a power of the depth."""
    if profile is None or profile.name in profiles.NAMES:
        return profile is not None and "def _ramp_force" in _viscoelastic(profile.name)
    power = profile.pieces[0].expr.as_independent(r, as_Add=False)[1]
    return not profile.breaks and bool(power.as_base_exp()[0] == r)


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


def _graded(profile: Profile, systems: Sequence[System]) -> dict[str, str]:
    """The modules of a contact on the graded half-space, those of the catalogue where they are stored."""
    names = {own: f"{own.name}.{profile.name}" for own in systems}
    found = {name: text for name in names.values() if (text := stored(f"{name.replace('.', '/')}.py"))}
    if len(found) == len(names):
        return found
    pressed = plain.derive(profile, GRADED)
    base, *above = systems
    normal = alone(base, pressed)
    found = {names[base]: normal.source()}
    for own in above:
        entries = own.derive(profile, pressed)
        found[names[own]] = superposed(own, entries, pressed, normal.parameters, interface=False).source()
    return found


def library(profile: Profile, entries: Mapping[str, Entry], normal: str, wanted: Kind) -> ChainMap[str, Module]:
    """All modules that the functions of one kind of contact on one profile can reach.

    Parameters
    ----------
    profile, entries : Profile, mapping
        The profile and its entries of normal contact.
    normal : str
        Text of its normal module, or of that of the plane contact or the prescribed pressure.
    wanted : Kind
        The kind of contact.
    """
    system, first = wanted.system, f"{wanted.plain.name}.{profile.name}"
    below = Module(first, normal)
    modules = ChainMap({first: below}, RUN_TIME)
    if wanted.graded:
        texts = _graded(profile, [own for own in (system.base, system) if own])
    elif system.base is None:
        return modules
    elif wanted.law and profile.name in profiles.NAMES:
        texts = {f"{system.name}.{profile.name}": _viscoelastic(profile.name)}
    else:
        own = {} if wanted.law else system.derive(profile, entries)
        above = superposed(system, own, entries, _parameters(below), interface=False)
        texts = {f"{system.name}.{profile.name}": above.source()}
    return modules | {key: Module(key, text) for key, text in texts.items()}
