"""Check values on the graded half-space: the definitions by quadrature, adhesion by the balance of energies."""

from __future__ import annotations

from typing import Any

import mpmath as mp
import numpy as np

from .. import notation as nt
from ..proof.half_space import HalfSpace
from . import interface
from .contact import DIGITS, Contact, short

Rows = list[tuple[tuple[float, ...], Any]]
MATERIAL = {"H": nt.H, "k": nt.k, "dgamma": nt.dgamma, "H_x": nt.H_x, "mu": nt.mu}
STICK = 0.6
"""Radius of the stick zone over the contact radius, or its place between a flat face and it."""
COARSE = 8
"""Digits of a load that is only compared with another one."""
FURTHER = 1.3 ** np.arange(1, 6)
"""Larger radii over this one at which a load is asked whether it is carried twice."""


def graded(contact: Contact, name: str) -> Rows:
    """Calls of a function with their results."""
    physics = contact.request.physics
    own = interface.functions(physics)
    rows: Rows = []
    with mp.workdps(DIGITS + 10):
        for a in contact.radii():
            at = _Radius(contact, a, adhesive=interface.kind_of(physics) == "adhesive")
            if interface.kind_of(physics) == "tangential" and name in own:
                rows += at.slipping(name, own[name])
            else:
                rows += at.pressed(name, interface.functions("normal")[name] if name not in own else own[name])
    return rows


class _Radius:
    """One contact radius."""

    def __init__(self, contact: Contact, a: float, *, adhesive: bool) -> None:
        self.contact, self.a, self.adhesive = contact, a, adhesive

    def half_space(self, digits: int = DIGITS, **places: float) -> HalfSpace:
        contact = self.contact
        known = {symbol: mp.mpf(contact.all[name]) for name, symbol in MATERIAL.items() if name in contact.all}
        fields = {getattr(nt, name): mp.mpf(value) for name, value in places.items()}
        return HalfSpace(contact.profile, {**known, **contact.given(), **fields}, digits, graded=True)

    def load(self, suffix: str, a: float | None = None, digits: int = DIGITS, **places: float) -> Any:
        """A quantity of the contact, with adhesion where there is some."""
        radius, found = a or self.a, self.contact.found
        key = (f"{suffix}, {digits} digits", radius, places.get("r"))
        if key not in found:
            own = self.half_space(digits, **places)
            found[key] = (own.adhesive if self.adhesive else own.normal)(suffix, mp.mpf(radius))
        return found[key]

    def pressed(self, name: str, function: interface.Function) -> Rows:
        """Normal contact, with or without adhesion."""
        a, height, suffix = self.a, self.contact.height, function.quantity.suffix
        places = [short(x) for x in (0.45 * a, *self.contact.between(a))]
        outside = short(1.6 * a)
        match name:
            case "profile":
                return [((r,), height(r)) for r in places]
            case "pressure":
                return [*(((r, a), self.load("p", r=r)) for r in places), ((outside, a), mp.mpf(0))]
            case "displacement":
                under = [((r, a), self.load("d") - height(r)) for r in places]
                return [((outside, a), self.load("w", r=outside)), *under]
            case "radius_from_depth" | "radius_from_force" | "force_from_depth" | "depth_from_force":
                source = "d" if name.endswith("depth") else "F"
                if self.adhesive and not self.outermost(source):
                    return []
                target = {"radius": "", "force": "F", "depth": "d"}[name.split("_")[0]]
                return [((float(self.load(source)),), self.load(target) if target else mp.mpf(a))]
        return [((a,), self.load(suffix))]

    def outermost(self, source: str) -> bool:
        """Whether the load rises through this radius and no larger one in the domain carries the same.

        That of waves is not asked: the quadrature over many of them takes more than a minute.
        """
        if nt.wavelength in self.contact.profile.parameters:
            return False
        own, control = self.half_space(), {"d": "depth", "F": "force"}[source]
        if not own.separation(control, mp.mpf(self.a)) > own.at(nt.dgamma):
            return False
        here = self.load(source, digits=COARSE)
        end = self.contact.end()
        larger = [x for x in self.a * FURTHER if x < end]
        return all(self.load(source, float(x), COARSE) > here for x in larger)

    def slipping(self, name: str, function: interface.Function) -> Rows:
        """Partial slip: mu times the difference of two normal contacts."""
        a, contact = self.a, self.contact
        floor = float(contact.given()[contact.profile.breaks[0]]) if contact.profile.truncated else 0.0
        c = short(floor + STICK * (a - floor))
        radius = mp.mpf(a)
        match name:
            case "traction":
                places = (0.5 * c, 0.5 * (a + c))
                return [((r, a, c), self.half_space(r=r, c=c).tangential("tau", radius)) for r in places]
            case "stick_radius":
                return [((float(self.half_space(c=c).tangential("F", radius)), a), mp.mpf(c))]
            case "full_slip_displacement":
                return [((a,), self.half_space().tangential("us", radius))]
        return [((a, c), self.half_space(c=c).tangential(function.quantity.suffix, radius))]
