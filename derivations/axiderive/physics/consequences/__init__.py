"""Quantities of normal contact that follow from depth, force and pressure: one file for each.

A file ends with its `CONSEQUENCE`, which says all that derivation, oracle, proof, code and print ask.  The oracle
integrates in numbers of its own what the springs of the surface carry, the second proof is a section of
`verifier/theory.txt`, and what integrates where no closed form keeps its digits is the file of the same name in
`runtime/shapes/`.  They are stated on the homogeneous half-space.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Literal, Protocol

import sympy as sp

from ...abel.form import Chain, Form
from ...abel.reduce import Reduced
from ...entry import Case, Entry, Quantity, Status
from ..medium import Medium

GROWTH, GAP = sp.symbols("growth gap", positive=True)
"""In a rate: g'(a) of a contact that grows, and d - g(a) of one with a fixed edge."""

SHORT = sp.Function("w1D")
"""How far a contact is pressed in beyond the depth of a radius, d - g(t).

The surface is as good as independent springs of stiffness 2 E* dt, which are pressed in so far along 0 < t < a.
"""


class Contact(Protocol):
    """The derivation of a compact profile, as far as a consequence asks for it."""

    medium: Medium
    reduced: Reduced
    chains: tuple[Chain, ...]
    summed: bool

    def close(self, form: Form) -> sp.Expr:
        """A reduced quantity as an expression, summed over the powers of a polynomial."""
        ...


@dataclass(frozen=True)
class Rate:
    """What proves it: its slope in a, and its value where a begins; between the cases it is continuous."""

    slope: sp.Expr
    """In symbols of quantities, GROWTH and GAP."""
    statement: str
    needs: tuple[str, ...]
    """Suffixes of the quantities that it rests on."""
    start: str = ""
    """Suffix of the quantity whose value it has at a = r; zero where none is named."""


@dataclass(frozen=True)
class Rules:
    """How the run time integrates it: `function`, `function`_tanh and `function`_beyond of its file."""

    over: Literal["slope", "depth"]
    start: str
    """What the rules add to, as code; {force} is the force of a contact that ends at r, or at a if that is smaller."""
    flat: str
    """The same where a flat face comes first."""
    scale: sp.Expr
    """What the rules are multiplied by."""
    anywhere: tuple[str, ...]
    """Over a profile of any kind, lines of code before the integral; {of_a} and {of_inner} are depths."""
    weight: str
    """What is integrated over x, from the radius `inner` on if a place is given; from_inner is x - inner."""
    whole: str
    """The value: `whole` is the integral, {force} that of a contact of radius inner, {flat} a flat face."""


@dataclass(frozen=True)
class Consequence:
    """A quantity of normal contact that follows from others."""

    compact: Quantity
    complete: Quantity
    definition: sp.Expr
    fixed_definition: sp.Expr
    """Of a contact with a fixed edge, by `SHORT`."""
    springs: sp.Expr
    """What the oracle integrates, by `SHORT` alone, for either kind of contact."""
    derive: Callable[[Contact, Mapping[str, Entry]], tuple[Status, tuple[Case, ...]]]
    fixed: Callable[[Reduced, Medium], sp.Expr]
    """The formula for a face that stays as the edge moves."""
    grown: Rate
    fixed_rate: Rate
    rules: Rules
    printed: str
    """The rule in print, in LaTeX."""

    @property
    def suffix(self) -> str:
        """The last part of its keys."""
        return self.compact.suffix

    def quantity(self, *, compact: bool) -> Quantity:
        """The quantity of either kind of contact."""
        return self.compact if compact else self.complete


def _found() -> Iterator[Consequence]:
    for path in sorted(Path(__file__).parent.glob("[a-z]*.py")):
        yield import_module(f".{path.stem}", __package__).CONSEQUENCE


CONSEQUENCES: dict[str, Consequence] = {own.suffix: own for own in _found()}
"""By suffix."""
