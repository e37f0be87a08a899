"""Families of bodies, and what a contact of one of them calls its place and its load."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp

from ..notation import F, P, beta, k, nu, r, x
from . import NAMES, load, plane
from . import loads as prescribed
from .profile import Profile, Sketch


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


ELASTIC = Profile(
    name="materials",
    title="Elastic constants",
    subtitle="Effective modulus and radius of two bodies, moduli of transversely isotropic and of graded half-spaces, "
    "numbers of adhesion.",
    contact="none",
    parameters=(),
    pieces=(),
    validity="linear elasticity",
    sources=("Elliott 1949", "Maugis 1992", "Tabor 1977"),
    sketch=Sketch((), a=1.0),
    abbreviations=((beta, sp.sqrt((1 + k) * (1 - k * nu / (1 - nu)))),),
)
"""The half-space without an indenter: what its constants come to in a contact."""

ROUND = Pool("", NAMES, load)
STRIPS = Pool("plane", plane.NAMES, plane.load, x, P)
PRESSURES = Pool("loads", tuple(load.name for load in prescribed.LOADS), prescribed.load)
BODIES = Pool("", ("materials",), lambda name: ELASTIC)
POOLS = (ROUND, STRIPS, PRESSURES, BODIES)
