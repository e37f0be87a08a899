"""The library a scene is linked from: runtime, module of the profile, modules of the physics on it."""

from __future__ import annotations

import ast
import json
from collections import ChainMap
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

from ... import profiles
from ...abel.reduce import NotReducibleError
from ...code import physics, plane, python
from ...code.graded import adhesive as graded_adhesive
from ...code.graded import complete as graded_complete
from ...code.graded import detachment as graded_detachment
from ...code.graded import normal as graded_normal
from ...code.graded import tangential as graded_tangential
from ...code.graded.families import family
from ...code.graded.module import RUNTIME as GRADED_RUNTIME
from ...code.imports import RUNTIME
from ...code.physics import adhesive, tangential, viscoelastic
from ...code.physics import detachment as peeled
from ...code.physics import loads as pressures
from ...code.physics.text import NormalModule
from ...code.python import NODE_COUNTS
from ...code.tables import kernels_source, nodes_source
from ...entry import Entry
from ...notation import r
from ...physics import adhesive as stuck
from ...physics import detachment
from ...physics import loads as prescribed
from ...physics import normal as plain
from ...physics import plane as strips
from ...physics import tangential as slipping
from ...physics import viscoelastic as creeping
from ...physics.medium import GRADED
from ...profiles.loads import Load
from ...profiles.profile import Profile
from ...store.index import NoCatalogueError, package
from ...store.records import read_entry
from .. import interface
from .inlining import rules, ungrouped
from .linking import Module

FOLDERS = (RUNTIME, physics.RUNTIME, GRADED_RUNTIME)
OWN = Path(__file__).with_name("runtime")
"""New modules, and definitions in place of others of the same name."""


class _Runtime(dict[str, Module]):
    """The modules of the runtime by name, each parsed when it is asked for: a scene needs a third of them."""

    def __missing__(self, name: str) -> Module:
        if name == "_nodes":
            found = _module(name, nodes_source(NODE_COUNTS))
        elif name == "_kernels":
            found = _module(name, polynomials(stored("_kernels.py") or kernels_source()))
        else:
            paths = [path for folder in (*FOLDERS, OWN) if (path := folder / f"{name}.py").is_file()]
            if not paths:
                raise KeyError(name)
            first, *over = (_module(name, path.read_text()) for path in paths)
            for other in over:
                first.definitions.update(other.definitions)
            found = first
        return self.setdefault(name, found)


@cache
def runtime() -> dict[str, Module]:
    """The modules of the runtime by name, parsed when they are asked for; KeyError for a name that is none."""
    return _Runtime()


def polynomials(kernels: str) -> str:
    """The module with kernels of denominator 1 as coefficients in descending order, for `np.polyval`."""
    found = []
    for node in ast.parse(kernels).body:
        match node:
            case ast.Assign(value=ast.Tuple(elts=[ast.Tuple() as top, ast.Tuple(elts=[ast.Constant(value=1.0)])])):
                rows = "".join(f"    {ast.unparse(coefficient)},\n" for coefficient in reversed(top.elts))
                found.append((ast.get_source_segment(kernels, node.value) or "", f"(\n{rows})"))
    for old, new in found:
        kernels = kernels.replace(old, new)
    return kernels


@cache
def _rules() -> dict[str, int]:
    paths = (RUNTIME / "_rules.py", RUNTIME / "_plane.py", physics.RUNTIME / "_slip_rules.py")
    return {name: count for path in paths for name, count in rules(path.read_text()).items()}


def _module(name: str, text: str) -> Module:
    return Module(name, ungrouped(text, _rules()))


def stored(path: str) -> str | None:
    """A file of the package in the catalogue, if there is one."""
    try:
        return (package() / path).read_text()
    except (NoCatalogueError, OSError):
        return None


def stored_entries(profile: Profile, physics: str) -> dict[str, Entry]:
    """The entries of a profile of the catalogue as they were verified, or derived anew where none are stored."""
    record = evidence(interface.id_of(physics, profile.name))
    if record:
        return {suffix: read_entry(entry, profile) for suffix, entry in record["entries"].items()}
    if isinstance(profile, Load):
        return prescribed.derive(profile)
    return strips.derive(profile) if physics == "plane" else plain.derive(profile)


def evidence(name: str) -> dict[str, Any] | None:
    """The stored record of a profile of the catalogue."""
    try:
        path = package().parent / "evidence" / f"{name}.json"
        record: dict[str, Any] = json.loads(path.read_bytes())
    except (NoCatalogueError, OSError, ValueError):
        return None
    return record


def stored_module(name: str, entries: Mapping[str, Entry], physics: str) -> str:
    """The text of the normal module of a profile of the catalogue, of the plane one, or of that of a pressure."""
    if physics == "loads":
        return stored(f"loads/{name}.py") or pressures.module_source(entries["w"])
    if physics == "plane":
        return stored(f"plane/{name}.py") or plane.module_source(entries)
    return stored(f"normal/{name}.py") or python.module_source(entries)


@cache
def _viscoelastic(name: str) -> str:
    """The viscoelastic module of a profile of the catalogue."""
    text = stored(f"viscoelastic/{name}.py")
    if text is None:
        profile = profiles.load(name)
        entries = stored_entries(profile, "normal")
        own = NormalModule.read(entries, stored_module(name, entries, "normal"))
        text = viscoelastic.module_source(own, creeping.derive(profile))
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


def _graded(profile: Profile, wanted: str) -> dict[str, str]:
    """The modules of a contact on the graded half-space, those of the catalogue where they are stored."""
    kind = wanted.partition(".")[2]
    keys = [f"graded.{group}.{profile.name}" for group in ("normal", kind) if group]
    found = {key: text for key in keys if (text := stored(f"{key.replace('.', '/')}.py"))}
    if len(found) == len(keys):
        return found
    pressed = plain.derive(profile, GRADED)
    if profile.complete:
        found = {keys[0]: graded_complete.module_source(pressed)}
        above = {keys[1]: graded_detachment.module_source(detachment.derive(profile, GRADED))} if kind else {}
        return found | above
    found = {keys[0]: graded_normal.module_source(pressed)}
    if kind == "adhesive":
        found[keys[1]] = graded_adhesive.module_source(stuck.derive(profile, GRADED, pressed), pressed)
    elif kind == "tangential":
        found[keys[1]] = graded_tangential.module_source(slipping.derive(profile, GRADED, pressed), pressed)
    return found


def library(profile: Profile, entries: Mapping[str, Entry], normal: str, wanted: str) -> ChainMap[str, Module]:
    """All modules that the functions of one physics on one profile can reach.

    Parameters
    ----------
    profile, entries : Profile, mapping
        The profile and its entries of normal contact.
    normal : str
        Text of its normal module, or of that of the plane contact or the prescribed pressure.
    wanted : str
        Name of the physics.
    """
    first = f"{wanted if wanted in ('plane', 'loads') else 'normal'}.{profile.name}"
    modules = ChainMap({first: _module(first, normal)}, runtime())
    if wanted in ("normal", "plane", "loads"):
        return modules
    if wanted.startswith("graded"):
        return modules | {key: _module(key, text) for key, text in _graded(profile, wanted).items()}
    if wanted.startswith("viscoelastic."):
        key = f"viscoelastic.{profile.name}"
        known = profile.name in profiles.NAMES
        text = (
            _viscoelastic(profile.name) if known else viscoelastic.formulas_source(NormalModule.read(entries, normal))
        )
        return modules | {key: _module(key, text)}
    own, key = NormalModule.read(entries, normal), f"{wanted}.{profile.name}"
    if profile.complete:
        peeling = peeled.module_source(own, detachment.derive(profile))
        return modules | {key: _module(key, peeling)}
    write, above = {
        "adhesive": (adhesive.module_source, stuck.derive),
        "tangential": (tangential.module_source, slipping.derive),
    }[wanted]
    return modules | {key: _module(key, write(own, above(profile, plain=entries), interface=False))}
