"""The systems of the catalogue: which contact, on which medium, for which profiles, and why not for the others.

A system applied to a profile is a problem.  Its key (`cone`, `cone.fgm.adh`,
`plane.wedge`) begins the keys of all its entries and never changes.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from pathlib import Path

from ..entry import Entry
from ..profiles.pools import BODIES, POOLS, PRESSURES, ROUND, STRIPS, Pool
from ..profiles.profile import Profile, unknown
from . import Physics, Wording
from .medium import Medium


@dataclass(frozen=True)
class System:
    """A physics on a medium, for the profiles of its pool."""

    physics: Physics
    medium: Medium

    @property
    def said(self) -> Wording:
        """What is said of it."""
        return self.physics.wording[self.medium]

    @property
    def heading(self) -> str:
        """What stands above its rows."""
        return self.said.heading or self.said.title

    @property
    def pool(self) -> Pool:
        """The bodies that it is derived for."""
        return self.physics.pool

    @property
    def name(self) -> str:
        """Package below axicontact: "adhesive", "graded.adhesive"."""
        return self.medium.key(self.medium.name, self.physics.name)

    @property
    def group(self) -> str:
        """Part of the keys between profile and quantity: "fgm.adh"."""
        return self.medium.key(self.medium.group, self.physics.group)

    @property
    def package(self) -> str:
        """Dotted name of the package of its modules, "axicontact.normal"."""
        return f"axicontact.{self.name}"

    @property
    def base(self) -> System | None:
        """The system it superposes, whose modules its own modules call."""
        return on(self.physics.over, self.medium) if self.physics.over else None

    def derive(self, profile: Profile, plain: Mapping[str, Entry] | None = None) -> dict[str, Entry]:
        """All entries of a profile, keyed by suffix; `plain` are those of the system it superposes, where known."""
        return self.physics.derive(profile, self.medium, *([plain] if plain else []))

    def refusal(self, profile: Profile) -> str:
        """Why the system has nothing to say of a profile; empty if it has."""
        return self.physics.refusal(profile, self.medium)


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
        return self.system.derive(self.profile)

    @property
    def base(self) -> Problem | None:
        """The problem that it superposes, and on whose generated module its own rests."""
        return Problem(self.system.base, self.name) if self.system.base else None


def _physics() -> Iterator[Physics]:
    """What the files of this folder end with."""
    for path in sorted(Path(__file__).parent.glob("[a-z]*.py")):
        if path.stem != "systems" and (found := getattr(import_module(f".{path.stem}", __package__), "PHYSICS", None)):
            yield found


SYSTEMS = tuple(sorted((System(p, m) for p in _physics() for m in p.wording), key=lambda own: own.said.place))
PRINTED = tuple(system for system in SYSTEMS if system.physics.printed)
"""Those of which the pages of the book and of the web edition have rows."""
BY_NAME = {system.name: system for system in SYSTEMS}


def on(physics: Physics, medium: Medium) -> System | None:
    """The system of a physics on a medium; None if it is not derived there."""
    return next((own for own in SYSTEMS if own.physics is physics and own.medium is medium), None)


def of(entry: Entry) -> System:
    """The system whose entry this is: the only place where a key is taken apart."""
    first, *groups, _ = entry.key.split(".")
    apart = {pool.prefix or pool.names[0]: pool for pool in (STRIPS, PRESSURES, BODIES)}
    found = [own for own in SYSTEMS if own.pool is apart.get(first, ROUND)]
    return next((own for own in found if own.group == ".".join(groups)), found[0])


def pool_of(profile_id: str) -> Pool:
    """The pool of a profile, as the command line and the index call it."""
    prefix, _, name = profile_id.rpartition(".")
    return next(pool for pool in POOLS if pool.prefix == prefix and name in pool.names)


def profile_ids() -> tuple[str, ...]:
    """All profiles in the order of the catalogue: cone, ..., plane.wedge, ..., loads.uniform, ..."""
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
        raise unknown(key, known, "there is no problem")
    return known[key]
