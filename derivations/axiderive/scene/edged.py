"""Check values of complete contacts, whose edge is fixed, on either half-space: the definitions by quadrature."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import mpmath as mp

from .. import notation as nt
from ..proof.half_space import HalfSpace
from ..proof.integrals import GUARD
from ..proof.physics_quadrature import contact as of_depth
from ..proof.threshold import stationary
from . import interface
from .contact import DIGITS, Contact, short
from .grading import MATERIAL

Rows = list[tuple[tuple[float, ...], Any]]
COARSE = 8
"""Digits of a pressure that is only compared with others."""
PLACES = tuple(i / 24 for i in range(1, 24))
"""Over the radius of the edge: where the weighted pressure is looked at for its least value."""


class Edged:
    """One complete contact at the values of a scene."""

    def __init__(self, contact: Contact) -> None:
        self.contact = contact
        self.graded = contact.request.physics.startswith("graded")

    @property
    def a(self) -> Any:
        """Radius of the edge."""
        return mp.mpf(self.contact.all["a"])

    def half_space(self, digits: int = DIGITS, **places: float) -> HalfSpace:
        own, known = self.contact, {nt.E_star: mp.mpf(self.contact.all.get("E_star", 1.0))}
        known |= {symbol: mp.mpf(own.all[name]) for name, symbol in MATERIAL.items() if name in own.all}
        fields = {getattr(nt, name): mp.mpf(value) for name, value in places.items()}
        return HalfSpace(own.profile, {**known, **own.given(), **fields}, digits, graded=self.graded)

    def at(self, suffix: str, depth: float, **places: float) -> Any:
        """A quantity of the normal contact at a depth."""
        here = self.half_space(DIGITS, d=depth, **places)
        radius, free = of_depth(here, self.a)
        place = places.get("r")
        if suffix == "p" and place is not None and place > radius:
            return mp.mpf(0)
        if suffix == "w" and place is not None and place <= radius:
            return mp.mpf(depth) - self.contact.height(place)
        return here.normal(suffix, radius, free)

    @cached_property
    def depths(self) -> list[float]:
        """Above the least depth of complete contact; of a convex face also one at which its edge is free."""
        full = self.half_space().depth(self.a)
        if full > 0:
            return [short(float(full * share)) for share in (0.4, 1.7)]
        if full == 0:
            return [short(float(self.a / 100))]
        least = full - min(self.weighted(self.a * share, COARSE) for share in (0.0, *PLACES))
        return [short(float(2 * least))]

    def weighted(self, r: Any, digits: int = DIGITS) -> Any:
        """The depth that the face alone needs for its pressure at r to vanish, with the sign turned."""
        here = self.half_space(digits, r=r)
        punch = here.pressure(r, self.a, here.depth(self.a) + 1) - here.pressure(r, self.a)
        return here.pressure(r, self.a) / punch

    @cached_property
    def ring(self) -> Any:
        """Where the pressure vanishes first on unloading."""
        rough = min((0.0, *PLACES), key=lambda share: self.weighted(self.a * share, COARSE))
        if rough == 0.0:
            return mp.mpf(0)
        step = mp.mpf(PLACES[0]) / 2
        place = mp.mpf(rough)
        while step > 1e-4:
            place = min((place - step, place, place + step), key=lambda share: self.weighted(self.a * share, COARSE))
            step /= 2
        # of the digits of the curve the place loses seven
        return stationary(lambda r: self.weighted(r, 2 * DIGITS), self.a * place, self.a)[0]

    @cached_property
    def least(self) -> Any:
        """The least depth of complete contact."""
        return self.half_space().depth(self.a) - self.weighted(self.ring)

    def pulled(self) -> tuple[Any, Any]:
        """Force and depth at which the edge peels: the contact without adhesion, short of its depth by Dl."""
        here = self.half_space()
        depth = here.depth(self.a) - here.retraction(self.a)
        return here.force(self.a, depth), depth

    def rows(self, name: str) -> Rows:
        """Calls of a function with their results."""
        with mp.workdps(DIGITS + GUARD):
            return self._rows(name)

    def _rows(self, name: str) -> Rows:
        a, inside, outside = float(self.a), short(0.45 * float(self.a)), short(1.6 * float(self.a))
        match name:
            case "profile":
                return [((inside,), self.contact.height(inside))]
            case "retraction":
                return [((), self.half_space().retraction(self.a))]
            case "zero_radius":
                return [((), self.ring)]
            case "minimum_depth":
                return [((), self.least)]
            case "minimum_force":
                return [((), self.half_space().force(self.a, self.least))]
        rows: Rows = []
        for depth in self.depths:
            match name:
                case "force":
                    rows.append(((depth,), self.at("F", depth)))
                case "depth_from_force":
                    rows.append(((float(self.at("F", depth)),), mp.mpf(depth)))
                case "stiffness":
                    fields = interface.arguments(
                        interface.functions("normal", interface.contact_of(self.contact.profile))[name],
                        self.contact.entries,
                    )
                    rows.append(((depth,) if fields else (), self.at("k", depth)))
                case "pressure":
                    rows += [((r, depth), self.at("p", depth, r=r)) for r in (inside, outside)]
                case "displacement":
                    rows += [((r, depth), self.at("w", depth, r=r)) for r in (inside, outside, short(3.0 * a))]
        return rows[:1] if rows and not rows[0][0] else rows
