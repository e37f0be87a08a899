"""Modules `axicontact.plane.<profile>`: strips on the elastic half plane."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from ... import notation as nt
from ...entry import Entry, Quantity
from ...letters import name_of
from ...physics.plane_quantities import PLANE, PLANE_COMPLETE, PLANE_ECCENTRIC
from ...physics.systems import BY_NAME
from ...profiles.profile import Profile
from ..bodies.regimes import split
from ..example import Example
from ..function import Function, reached
from ..module import Module
from ..private import PrivateFunctions
from ..writer import check, unused
from . import complete, document
from .compact import Compact
from .complete import Complete

SYSTEM = BY_NAME["plane"]
SHAPE = Quantity("f", "profile", "Profile", nt.f, (nt.x,), parity="even", summary="Profile f(x) of the indenter.")


def module(entries: Mapping[str, Entry]) -> Module:
    """The module of one profile."""
    own = _Interface(entries)
    profile, known = own.profile, own.functions.functions.values()
    public = [own.public(quantity) for quantity in own.quantities]
    checked = [] if own.eccentric or not profile.rules else [check(profile)]
    return Module(SYSTEM, profile.name, profile.title, profile.subtitle, public, [*checked, *reached(known, public)])


def bodies(functions: PrivateFunctions, entries: Mapping[str, Entry]) -> Compact | None:
    """Add the private functions."""
    if nt.e in functions.profile.parameters:
        complete.add_all(entries, functions)
        return None
    if functions.profile.complete:
        Complete(entries, functions).add_all()
        return None
    compact = Compact(entries, functions)
    compact.add_all()
    return compact


def bodies_source(functions: PrivateFunctions, title: str) -> str:
    """A module of private functions alone: to be measured, not to be published."""
    profile, private = functions.profile, list(functions.functions.values())
    return Module(SYSTEM, profile.name, profile.title, title, [], private).source()


@dataclass
class _Interface:
    """The public functions of one profile."""

    entries: Mapping[str, Entry]

    def __post_init__(self) -> None:
        self.profile: Profile = next(iter(self.entries.values())).profile
        self.functions = PrivateFunctions(self.profile)
        self.eccentric = nt.e in self.profile.parameters
        known = PLANE
        if self.eccentric:
            known = PLANE_ECCENTRIC
        elif self.profile.complete:
            known = PLANE_COMPLETE
        bodies(self.functions, self.entries)
        split(self.functions, self.entries, bodies)
        shape = [] if self.eccentric else [SHAPE]
        self.quantities = shape + [quantity for suffix, quantity in known.items() if suffix in self.entries]

    @cached_property
    def example(self) -> Example:
        """The doctests of the module."""
        return Example(self.profile, self.entries, SYSTEM, self.entries)

    def public(self, quantity: Quantity) -> Function:
        """The public function of one quantity; without an entry that of the shape f(x)."""
        entry = self.entries.get(quantity.suffix)
        symbols = entry.parameters if entry else self.profile.parameters
        fields, keywords = ([name_of(symbol) for symbol in own] for own in (quantity.arguments, symbols))
        private = self.functions.functions[quantity.function]
        body = [*self._checks(keywords, fields), f"return {self._evaluation(quantity, private, fields, keywords)}"]
        used = private.uses.union(*(own.uses for own in reached(self.functions.functions.values(), [private])))
        shown = self.example.lines(quantity.suffix) if entry else self.example.shape()
        doc = document.text(self.profile, quantity, entry, symbols, document.notes(self.profile, quantity, used), shown)
        return Function(quantity.function, fields, keywords, body, doc, "Result")

    def _checks(self, keywords: list[str], fields: list[str]) -> list[str]:
        if self.eccentric:
            plain = ", ".join(f"{name}={name}" for name in keywords if name != "e")
            return [f"require({plain})", "require_eccentricity(a, e)"]
        owner = "_check" if self.profile.rules else "require"
        lines = [f"{owner}({', '.join(f'{name}={name}' for name in keywords)})"]
        if self.profile.truncated and "a" in fields:
            lines.append(f'require_reach(a, {self.profile.breaks[0]}, "plane.flat_punch")')
        return lines

    def _evaluation(self, quantity: Quantity, private: Function, fields: list[str], keywords: list[str]) -> str:
        given = {"e": "turned(x, e)"} if quantity.symbol == nt.p else {}
        passed = [f"{name}={given.get(name, name)}" for name in private.needs]
        wrapper = quantity.parity or "elementwise"
        spread = unused(name for name in keywords if name not in private.needs)
        return f"{wrapper}({', '.join([private.name, *fields, *passed, *spread])})"
