"""Families of bodies, and what a contact of one of them calls its place and its load."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp

from ..notation import F, P, r, x
from . import NAMES, load, plane
from . import loads as prescribed
from .materials import PROFILE as ELASTIC
from .profile import Profile


@dataclass(frozen=True)
class Pool:
    """Profiles that a family of systems draws on; `prefix` tells those of the same name apart."""

    prefix: str
    names: tuple[str, ...]
    load: Callable[[str], Profile]
    place: sp.Symbol = r
    """Along the surface."""
    force: sp.Symbol = F
    """The load; in the plane by length."""

    @property
    def strip(self) -> bool:
        """Whether the bodies are strips, the same at every cross-section."""
        return self.place == x

    def id(self, name: str) -> str:
        """How the profile is called on the command line and in the index."""
        return ".".join(part for part in (self.prefix, name) if part)


ROUND = Pool("", NAMES, load)
STRIPS = Pool("plane", plane.NAMES, plane.load, x, P)
PRESSURES = Pool("loads", tuple(load.name for load in prescribed.LOADS), prescribed.load)
BODIES = Pool("", ("materials",), lambda name: ELASTIC)
POOLS = (ROUND, STRIPS, PRESSURES, BODIES)
