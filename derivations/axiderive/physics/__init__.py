"""Contact problems as entries: one file for each physics, which ends with the `Physics` that others ask."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import sympy as sp

from ..notation import E_star
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
    spread: tuple[tuple[str, ...], ...] = ()
    """The rules that stand in front of the book, by lines of one or two."""


@dataclass(frozen=True)
class Rule:
    """What holds for every profile, as LaTeX in g, F_N, p and w, with the words behind it and the range of a field."""

    tex: str
    remark: str = ""
    where: str = ""


Printing = Callable[..., Callable[[sp.Expr], str]]
"""What gives a printer of expressions (`print.formula.Printer`): of a chain of lengths, and with names of symbols."""


OWN = sp.Symbol("own", real=True)
"""The formula of an entry in a statement about it."""
DEPTH, FORCE, PRESSURE = map(sp.Function, ("g", "F", "p"))
"""Depth and force of the contact that is superposed, of a radius; its pressure of a place and a radius, 0 outside."""
DISPLACEMENT, SHAPE = map(sp.Function, ("w", "f"))
"""In proofs: its displacement of a place beside it and a radius, and the height of the profile."""


@dataclass(frozen=True)
class Shown:
    """A step of a proof: something vanishes in every region of an entry, or in some."""

    label: str
    zero: sp.Expr
    """In `OWN`, and in depth, force and pressure of the contact that is superposed."""
    where: tuple[sp.Expr, sp.Expr] | None = None
    """In regions in which the first length lies below the second."""
    at: tuple[sp.Symbol, sp.Expr] | None = None
    """A length, and the next smaller one with which it meets; 0 below all of them."""
    given: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    """What stands for an argument of the entry."""
    known: tuple[tuple[sp.Expr, ...], ...] = ()
    """Orders of further symbols that it holds for."""


@dataclass(frozen=True)
class Proof:
    """Why the formulas of an entry are right."""

    over: str
    """Suffix of the entry of the contact below on which it rests, and whose regions it has."""
    shown: tuple[Shown, ...]
    within: sp.Symbol | None = None
    """A further length of its regions, anywhere below the contact radius and above a flat face."""
    beyond: sp.Symbol | None = None
    """One above the contact radius, and below the end of a profile that has one."""


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
    choices: Mapping[str, tuple[str, tuple[str, ...]]] = field(default_factory=dict)
    """What its functions take that is no number: what that says, and the words for it, of which the first is meant."""
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
    code: Callable[[Profile], Mapping[str, str]] | None = None
    """By quantity what its function returns, in functions of the run time; None where `code/physics` has its file."""
    results: Mapping[str, str] = field(default_factory=dict)
    """Named tuples of the run time by the functions that give them, a quantity for each member."""
    assumed: str = ""
    """What its functions take for granted, behind the range of a profile in their docstrings."""
    ordered: tuple[tuple[str, str, str], ...] = ()
    """Lengths of which the first is never above the second, with what to do if it is."""
    shown: Mapping[sp.Symbol, str] = field(default_factory=dict)
    """Numbers of its doctests, for symbols that are no lengths of a profile."""
    quantities: Mapping[str, Mapping[str, Quantity]] = field(default_factory=dict)
    """By the names of stored records: of a contact that grows, with a fixed edge, under a leaning load."""
    wanted: tuple[str, ...] = ()
    """Functions that a scene gets if it asks for none; empty where there are no scenes."""
    definitions: Callable[[Profile, Medium], dict[str, sp.Expr]] | None = None
    """What each of its quantities is, in `DEPTH`, `FORCE` and `PRESSURE` of the contact that it superposes."""
    solved: sp.Symbol | None = None
    """A length in its formulas that one of its quantities is, as the root of an equation in all of its material."""
    searched: tuple[Quantity, ...] = ()
    """What its modules search for among the values of its quantities, with a pull-off: the radii of stable branches."""
    slipped: Mapping[str, tuple[str, str]] = field(default_factory=dict)
    """By quantity with a zone of stick, which one it is once that has shrunk, or mu times `plain.` one; with words."""
    compared: str = ""
    """What these definitions are called where formulas are compared with them."""
    proofs: Callable[[Profile, Medium], dict[str, Proof]] | None = None
    """Why its formulas are those of the definitions, on a medium of the prover."""
    rules: Callable[[Medium, Printing], dict[str, Rule]] | None = None
    """The rules in print by quantity; None if every row is a formula of the profile itself."""
    noted: str = ""
    """Behind the title of its rules in front of the book."""
    printed: bool = True
    """Whether its rows stand on the pages of the profiles."""

    def parameters(self, medium: Medium) -> tuple[sp.Symbol, ...]:
        """What its functions take of the material on a medium."""
        return (*medium.moduli, *((medium.shear,) if self.shear else ()), *self.material)

    def table(self, profile: Profile) -> Mapping[str, Quantity]:
        """The quantities of a profile by suffix: the first ones of a contact that grows, else the last."""
        tables = [*self.quantities.values()]
        return tables[0 if profile.compact else -1]

    def taken(
        self, definition: sp.Expr, medium: Medium, arguments: tuple[sp.Symbol, ...] = ()
    ) -> tuple[sp.Symbol, ...]:
        """What a quantity with this definition takes of the material: forces and pressures hold the modulus."""
        elastic = definition.has(FORCE, PRESSURE)
        known = definition.free_symbols | ({medium.modulus} if elastic else set()) | {*medium.moduli[1:]}
        if self.solved in definition.free_symbols - {*arguments}:
            known |= {medium.modulus, *self.material}
        shear = (medium.shear,) if self.shear else ()
        ordered = (medium.modulus, *shear, *medium.moduli[1:], *self.material)
        return tuple(symbol for symbol in ordered if symbol in known and symbol not in arguments)

    @property
    def drawn(self) -> tuple[sp.Symbol, ...]:
        """What checks draw of the material; the modulus of the homogeneous half-space is drawn with every point."""
        moduli = (s for medium in self.wording for s in (medium.modulus, *((medium.shear,) if self.shear else ())))
        return (*self.material, *(symbol for symbol in moduli if symbol != E_star))
