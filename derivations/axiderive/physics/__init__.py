"""Contact problems as entries: one file for each physics, which ends with the `Physics` that others ask."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import sympy as sp

from ..profiles.pools import ROUND, Pool

if TYPE_CHECKING:
    from ..entry import Entry, Quantity
    from ..profiles.profile import Profile
    from .medium import Medium
    from .viscoelastic import Law


@dataclass(frozen=True)
class Wording:
    """What is said of a physics on one medium, which makes it a system of the catalogue."""

    place: int
    """Among the systems, in the order of the index and of a page of the book."""
    title: str
    heading: str = ""
    """Above its rows, where it is not the title."""
    note: str = ""
    """Behind the heading, in LaTeX: what the rows take for granted."""
    package: str = ""
    """First line of the docstring of its package."""
    searched: str = ""
    """Words by which it is looked for and that its title does not have."""
    button: str = ""
    """On the home page of the web edition, where a picture of a profile leads to it."""
    by_rule: tuple[str, ...] = ()
    """Quantities of a contact that grows whose formula is the rule in front of the book, with g, F_N, p or w put in."""
    by_rule_complete: tuple[str, ...] = ()
    """The same of a contact with a fixed edge."""
    subject: str = ""
    """Problem with whose entries the printed rules are compared: roots where an equation is solved, no integrals in
    fields."""


@dataclass(frozen=True, eq=False)
class Physics:
    """One kind of contact, on whatever medium, and what others need to know of it; compared by identity."""

    name: str
    """What scenes call it, and its package on the homogeneous half-space."""
    wording: Mapping[Medium, Wording]
    """By the media that it is derived on."""
    derive: Callable[..., dict[str, Entry]]
    """The entries of a profile on a medium, by suffix; those of the contact it superposes go along if known."""
    group: str = ""
    """Part of the keys behind that of the medium: cone.fgm.adh.F."""
    over: Physics | None = None
    """The contact that it superposes, and on whose modules its own rest."""
    beside: bool = False
    """Whether it leaves that contact as it is, so that the functions of both are asked for together."""
    refusal: Callable[[Profile, Medium], str] = lambda profile, medium: ""
    """Why there are no entries of a profile; empty if there are."""
    shear: bool = False
    """Whether it loads the surface along itself too, and takes the modulus of the medium for that."""
    material: tuple[sp.Symbol, ...] = ()
    """What it takes beside the moduli of the medium."""
    tension: bool = False
    """Whether the contact holds under tension: depth and force may be negative, down to a pull-off."""
    laws: tuple[Law, ...] = ()
    """Material laws in place of the modulus: all functions are of the time, and one set of each law."""
    pool: Pool = ROUND
    """The bodies that it is derived for."""
    contact: str = ""
    """What kind of contact it is, in words behind the name of a profile."""
    runtime: tuple[str, ...] = ()
    """Files of the run time that its modules may call."""
    quantities: Mapping[str, Mapping[str, Quantity]] = field(default_factory=dict)
    """By the names of stored records: of a contact that grows, with a fixed edge, under a leaning load."""
    wanted: tuple[str, ...] = ()
    """Functions that a scene gets if it asks for none."""

    def parameters(self, medium: Medium) -> tuple[sp.Symbol, ...]:
        """What its functions take of the material on a medium."""
        return (*medium.moduli, *((medium.shear,) if self.shear else ()), *self.material)
