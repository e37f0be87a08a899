"""The systems of the catalogue: which contact, on which medium, for which profiles, and why not for the others.

A system applied to a profile is a problem.  Its key (`cone`, `cone.fgm.adh`,
`plane.wedge`) begins the keys of all its entries and never changes.
"""

from __future__ import annotations

import difflib
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from typing import Any

from .. import profiles
from ..entry import Entry
from ..profiles import loads as prescribed
from ..profiles import plane as plane_profiles
from ..profiles.materials import PROFILE as ELASTIC
from ..profiles.profile import Profile
from . import adhesive, detachment, loads, materials, normal, plane, tangential, viscoelastic
from .medium import GRADED, HOMOGENEOUS, Medium


def _always(profile: Profile) -> str:
    return ""


@dataclass(frozen=True)
class Pool:
    """Profiles that a family of systems draws on; `prefix` tells those of the same name apart."""

    prefix: str
    names: tuple[str, ...]
    load: Callable[[str], Profile]

    def id(self, name: str) -> str:
        """How the profile is called on the command line and in the index."""
        return ".".join(part for part in (self.prefix, name) if part)


ROUND = Pool("", profiles.NAMES, profiles.load)
STRIPS = Pool("plane", plane_profiles.NAMES, plane_profiles.load)
PRESSURES = Pool("loads", tuple(load.name for load in prescribed.LOADS), prescribed.load)
BODIES = Pool("", ("materials",), lambda name: ELASTIC)
POOLS = (ROUND, STRIPS, PRESSURES, BODIES)


@dataclass(frozen=True)
class System:
    """A kind of contact on a medium, with the rule that derives it from a profile."""

    name: str
    """Package below axicontact."""
    title: str
    rule: Callable[[Any], dict[str, Entry]]
    pool: Pool = ROUND
    group: str = ""
    """Part of the keys between profile and quantity."""
    rests_on: tuple[str, ...] = ()
    """Systems whose modules its own modules call."""
    refusal: Callable[[Profile], str] = _always
    """Why the system has nothing to say of a profile; empty if it has."""

    @property
    def package(self) -> str:
        """Dotted name of the package of its modules, "axicontact.normal"."""
        return f"axicontact.{self.name}"


@dataclass(frozen=True)
class Problem:
    """A system applied to one profile."""

    system: System
    name: str

    @property
    def profile(self) -> Profile:
        """The profile of that name in the pool of the system."""
        return self.system.pool.load(self.name)

    @property
    def profile_id(self) -> str:
        """The profile as the command line and the index call it: "cone", "plane.wedge"."""
        return self.system.pool.id(self.name)

    @property
    def key(self) -> str:
        """What the keys of its entries begin with: "cone", "cone.fgm.adh", "plane.wedge"."""
        return ".".join(part for part in (self.profile_id, self.system.group) if part)

    @property
    def module(self) -> str:
        """Path of the generated module below catalogue/; a system of a single problem is a module by itself."""
        if self.name == self.system.name:
            return f"axicontact/{self.name}.py"
        return f"{self.system.package.replace('.', '/')}/{self.name}.py"

    def derive(self) -> dict[str, Entry]:
        """All entries of the problem, keyed by suffix."""
        return self.system.rule(self.profile)

    def base_keys(self) -> set[str]:
        """Keys of the problems that the generated module of this one rests on."""
        return {Problem(BY_NAME[name], self.name).key for name in self.system.rests_on}


def _on(rule: Callable[[Profile, Medium], dict[str, Entry]], medium: Medium) -> Callable[[Profile], dict[str, Entry]]:
    def derive(profile: Profile) -> dict[str, Entry]:
        return rule(profile, medium)

    return derive


def _graded_adhesive_refusal(profile: Profile) -> str:
    return detachment.refusal(profile, GRADED)


def _adhesive(profile: Profile, medium: Medium) -> dict[str, Entry]:
    rule = adhesive.derive if profile.compact else detachment.derive
    return rule(profile, medium)


SYSTEMS = (
    System("normal", "Normal contact without adhesion", _on(normal.derive, HOMOGENEOUS)),
    System(
        "adhesive", "Adhesive contact", _on(_adhesive, HOMOGENEOUS), group="adh",
        rests_on=("normal",), refusal=detachment.refusal,
    ),
    System(
        "tangential", "Tangential contact with partial slip", _on(tangential.derive, HOMOGENEOUS),
        group="tan", rests_on=("normal",), refusal=tangential.refusal,
    ),
    System("graded.normal", "Normal contact, graded half-space", _on(normal.derive, GRADED), group="fgm"),
    System(
        "graded.adhesive", "Adhesive contact, graded half-space", _on(_adhesive, GRADED),
        group="fgm.adh", rests_on=("graded.normal",), refusal=_graded_adhesive_refusal,
    ),
    System(
        "graded.tangential", "Tangential contact, graded half-space", _on(tangential.derive, GRADED),
        group="fgm.tan", rests_on=("graded.normal",), refusal=tangential.refusal,
    ),
    System(
        "viscoelastic", "Growing contact, viscoelastic half-space", viscoelastic.derive,
        group="vis", rests_on=("normal",),
    ),
    System("plane", "Plane contact", plane.derive, STRIPS),
    System("loads", "Prescribed pressure", loads.derive, PRESSURES),
    System("materials", "Elastic constants", lambda profile: materials.derive(), BODIES),
)  # fmt: skip
BY_NAME = {system.name: system for system in SYSTEMS}


def profile_ids() -> tuple[str, ...]:
    """All profiles in the order of the handbook: cone, ..., plane.wedge, ..., loads.uniform, ..."""
    return tuple(pool.id(name) for pool in POOLS for name in pool.names)


def problems(ids: Iterable[str] | None = None) -> Iterator[Problem]:
    """The problems of these profiles, or of all, profile by profile in the order of the handbook."""
    wanted = None if ids is None else set(ids)
    for pool in POOLS:
        for name in pool.names:
            if wanted is None or pool.id(name) in wanted:
                profile = pool.load(name)
                yield from (Problem(s, name) for s in SYSTEMS if s.pool is pool and not s.refusal(profile))


@cache
def _by_key() -> dict[str, Problem]:
    return {found.key: found for found in problems()}


def problem(key: str) -> Problem:
    """The problem of that key; `KeyError` with the nearest key if there is none."""
    known = _by_key()
    if key not in known:
        near = difflib.get_close_matches(key, known, n=1)
        message = f"there is no problem {key!r}" + (f"; did you mean {near[0]!r}?" if near else "")
        raise KeyError(message)
    return known[key]
