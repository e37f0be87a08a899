"""The functions a scene can ask for, by physics: name, fields, and one line that says what they are."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from .. import notation as nt
from ..contact import adhesive, tangential
from ..emit import docstring
from ..emit.physics import adhesive as adhesive_text
from ..emit.physics import tangential as tangential_text
from ..entry import COMPACT, COMPLETE, Entry, Quantity

MATERIAL = {
    "normal": ("E_star",),
    "adhesive": ("E_star", "dgamma"),
    "tangential": ("E_star", "G_star", "mu"),
    "graded": ("H", "k"),
}
GROUP = {"normal": "", "adhesive": "adh.", "tangential": "tan.", "graded": "fgm."}
PULL_OFF = "pull_off"
INVERSES = frozenset(["radius_from_depth", "radius_from_force", "force_from_depth", "depth_from_force"])
SIGNED = {("adhesive", "radius_from_depth"), ("adhesive", "radius_from_force")}


@dataclass(frozen=True)
class Function:
    """One function of the interface."""

    physics: str
    quantity: Quantity
    summary: str

    @property
    def name(self) -> str:
        return self.quantity.function

    @property
    def fields(self) -> tuple[str, ...]:
        return tuple(str(argument) for argument in self.quantity.arguments)

    @property
    def signed(self) -> bool:
        return (self.physics, self.name) in SIGNED

    def doc(self, profile: str) -> str:
        """The docstring: summary, unit of the result, key of the formula."""
        unit = nt.describe(self.quantity.symbol).unit
        return f"{self.summary.rstrip('.')} [{unit}]; {profile}.{GROUP[self.physics]}{self.quantity.suffix}."


def functions(physics: str, contact: str = "compact") -> dict[str, Function]:
    """All functions of a physics by name, `pull_off` left out."""
    table: Mapping[str, Quantity]
    if physics == "graded":
        return {name: replace(own, physics=physics) for name, own in functions("normal").items()}
    if physics == "adhesive":
        table, text = adhesive.QUANTITIES, adhesive_text.SUMMARY
    elif physics == "tangential":
        table, text = tangential.QUANTITIES, tangential_text.SUMMARY
    else:
        table, text = COMPACT if contact == "compact" else COMPLETE, docstring.SUMMARY
    return {
        quantity.function: Function(physics, quantity, text[suffix])
        for suffix, quantity in table.items()
        if suffix in text
    }


def arguments(function: Function, entries: Mapping[str, Entry]) -> tuple[str, ...]:
    """Fields of a function; the stiffness of a capped cylinder takes the depth."""
    entry = entries.get(function.quantity.suffix)
    if function.quantity.suffix == "k" and entry is not None and any(c.expr.has(nt.d) for c in entry.cases):
        return ("d",)
    return function.fields
