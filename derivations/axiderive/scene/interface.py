"""The functions a scene can ask for, by physics: name, fields, and one line that says what they are."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from .. import notation as nt
from ..contact import adhesive, loads, tangential, viscoelastic
from ..contact.plane_quantities import PLANE, PLANE_COMPLETE
from ..emit import docstring
from ..emit import plane as plane_text
from ..emit.physics import adhesive as adhesive_text
from ..emit.physics import loads as loads_text
from ..emit.physics import tangential as tangential_text
from ..emit.physics import viscoelastic as viscoelastic_text
from ..emit.physics.text import name_of
from ..entry import COMPACT, COMPLETE, Entry, Quantity

LAWS = {law.name: law for law in viscoelastic.LAWS}
LETTERS = {"tau": "relaxation"}
"""Parameters that share their letter with another symbol of the notation."""
MATERIAL = {
    "normal": ("E_star",),
    "adhesive": ("E_star", "dgamma"),
    "tangential": ("E_star", "G_star", "mu"),
    "plane": ("E_star",),
    "loads": ("E_star",),
    "graded": ("H", "k"),
    "graded.adhesive": ("H", "k", "dgamma"),
    "graded.tangential": ("H", "k", "H_x", "mu"),
    **{f"viscoelastic.{name}": tuple(map(name_of, law.parameters)) for name, law in LAWS.items()},
}
GROUP = {
    "normal": "", "plane": "", "loads": "", "adhesive": "adh.", "tangential": "tan.", "viscoelastic": "vis.",
    "graded.normal": "fgm.", "graded.adhesive": "fgm.adh.", "graded.tangential": "fgm.tan.",
}  # fmt: skip
LOADED = {"ramp": ("v",), "step": ("d",), "load": ("F",)}
"""What is given beside the time, by the kind of loading."""
PULL_OFF = "pull_off"
INVERSES = frozenset(["radius_from_depth", "radius_from_force", "force_from_depth", "depth_from_force"])
BELOW = {"tangential": "normal", "graded.tangential": "graded"}
"""The contact whose functions come with those of another."""
SIGNED = frozenset(["radius_from_depth", "radius_from_force"])
"""Fields that are negative where adhesion pulls."""


@dataclass(frozen=True)
class Function:
    """One function of the interface."""

    physics: str
    quantity: Quantity
    summary: str

    @property
    def law(self) -> str:
        """The material law in its name in the catalogue."""
        return law_of(self.physics)

    @property
    def name(self) -> str:
        return self.quantity.function.removesuffix(f"_{self.law}") if self.law else self.quantity.function

    @property
    def module(self) -> str:
        """The package it is in, below that of the catalogue."""
        return "viscoelastic" if self.law else {"graded": "graded.normal"}.get(self.physics, self.physics)

    @property
    def fields(self) -> tuple[str, ...]:
        if self.law:
            return ("t", *LOADED[self.quantity.suffix.partition("_")[0]])
        return tuple(str(argument) for argument in self.quantity.arguments)

    @property
    def signed(self) -> bool:
        return kind_of(self.physics) == "adhesive" and self.name in SIGNED

    @property
    def parity(self) -> str:
        """Whether a field takes places on both sides of the middle, where it is even or odd."""
        return plane_text.EVALUATED.get(self.quantity.suffix, "") if self.physics == "plane" else ""

    def doc(self, profile: str) -> str:
        """The docstring: summary, unit of the result, key of the formula."""
        unit = nt.describe(self.quantity.symbol).unit
        return f"{self.summary.rstrip('.')} [{unit}]; {profile}.{GROUP[self.module]}{self.quantity.suffix}."


def law_of(physics: str) -> str:
    """The material law of a viscoelastic contact, empty for any other."""
    group, _, law = physics.partition(".")
    return law if group == "viscoelastic" else ""


def kind_of(physics: str) -> str:
    """The kind of contact on whatever medium: normal, adhesive, tangential, viscoelastic, plane or loads."""
    group, _, kind = physics.partition(".")
    return (kind or "normal") if group == "graded" else group


def id_of(physics: str, profile: str) -> str:
    """How the catalogue calls a profile: strips and pressures are told apart from round profiles of the same name."""
    return f"{physics}.{profile}" if physics in ("plane", "loads") else profile


def functions(physics: str, contact: str = "compact") -> dict[str, Function]:
    """All functions of a physics by name, `pull_off` left out."""
    table: Mapping[str, Quantity]
    if physics.startswith("viscoelastic."):
        return _viscoelastic(physics)
    if physics.startswith("graded"):
        return {name: replace(own, physics=physics) for name, own in functions(kind_of(physics)).items()}
    if physics == "adhesive":
        table, text = adhesive.QUANTITIES, adhesive_text.SUMMARY
    elif physics == "tangential":
        table, text = tangential.QUANTITIES, tangential_text.SUMMARY
    elif physics == "loads":
        table, text = loads.QUANTITIES, loads_text.SUMMARY
    elif physics == "plane":
        own = PLANE if contact == "compact" else PLANE_COMPLETE
        # a result without a field is a number, and no function of a scene
        fields = {suffix: quantity for suffix, quantity in own.items() if quantity.arguments}
        table, text = {"f": plane_text.SHAPE, **fields}, plane_text.document.SUMMARY
    else:
        table, text = COMPACT if contact == "compact" else COMPLETE, docstring.SUMMARY
    return {
        quantity.function: Function(physics, quantity, text[suffix])
        for suffix, quantity in table.items()
        if suffix in text
    }


def _viscoelastic(physics: str) -> dict[str, Function]:
    law = LAWS[physics.partition(".")[2]]
    text = {kind: line.format(viscoelastic_text.MATERIAL[law.name]) for kind, line in viscoelastic_text.SUMMARY.items()}
    kinds = ((kind, viscoelastic.QUANTITIES[f"{kind}_{law.suffix}"]) for kind in LOADED)
    found = [Function(physics, quantity, text[kind]) for kind, quantity in kinds]
    return {function.name: function for function in found}


def record(name: str) -> nt.Notation:
    """The notation of a parameter by its name in the functions."""
    return nt.describe(LETTERS.get(name, name))


def arguments(function: Function, entries: Mapping[str, Entry]) -> tuple[str, ...]:
    """Fields of a function; the stiffness of a capped cylinder takes the depth."""
    entry = entries.get(function.quantity.suffix)
    if function.quantity.suffix == "k" and entry is not None and any(c.expr.has(nt.d) for c in entry.cases):
        return ("d",)
    return function.fields
