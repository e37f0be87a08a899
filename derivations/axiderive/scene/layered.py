"""Check values of a contact with an elastic layer: its surface is where the indenter is, whatever the springs carry."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import mpmath as mp

from .. import notation as nt
from ..exits import FAILED, CommandError
from ..oracle.layer import Layer, layer
from .contact import DIGITS, LAYER, Contact, short
from .interface import Function

THINNEST = 5.0
"""Contact radius over thickness up to which collocation to so many digits takes seconds."""
SUNK = 0.01
"""Depth of a punch over its radius."""


class Layered:
    """One contact, at the largest radius that the values of a scene are drawn at."""

    def __init__(self, contact: Contact) -> None:
        self.contact = contact
        self.a = contact.radii()[-1] if contact.compact else contact.all["a"]
        h = contact.all[LAYER]
        if self.a > THINNEST * h:
            message = (
                f"thickness = {h:g}: values are checked up to contact radii of {THINNEST:g} thickness, and the profile "
                f"needs a = {self.a:.3g} m; use a thicker layer, or axicontact.layer.{contact.profile.name}"
            )
            raise CommandError(message, FAILED)

    @cached_property
    def solved(self) -> Layer:
        """The contact, solved once."""
        return self._solved(adhesive=False)

    @cached_property
    def pulled(self) -> Layer:
        """The same with adhesion."""
        return self._solved(adhesive=True)

    def _solved(self, *, adhesive: bool) -> Layer:
        free = {} if self.contact.compact else {nt.d.name: short(SUNK * self.a)}
        (base,) = self.contact.request.choices.values()
        return layer(self.contact.half_space(DIGITS, a=self.a, **free), base, adhesive=adhesive)

    def rows(self, function: Function) -> list[tuple[tuple[float, ...], Any]]:
        """Calls of a function with their results."""
        kind, quantity, a = self.contact.request.kind, function.quantity, self.a
        entry = kind.system.derive(self.contact.profile)[quantity.suffix]
        solved = self.pulled if nt.dgamma in entry.parameters else self.solved
        known = {nt.a: mp.mpf(a), nt.d: solved.depth, nt.F: solved.force()}
        if nt.r not in quantity.arguments:
            return [(tuple(float(known[own]) for own in quantity.arguments), solved.stated(entry))]
        places = [short(x) for x in (0.45 * a, *self.contact.between(a))]
        found = [(place, solved.pressure(mp.mpf(place))) for place in places] + [(short(1.6 * a), mp.mpf(0))]
        return [((r, *(float(known[own]) for own in quantity.arguments[1:])), value) for r, value in found]
