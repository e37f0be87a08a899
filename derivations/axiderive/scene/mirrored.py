"""Check values of plane contact: the defining integrals over strips, on both sides of the middle."""

from __future__ import annotations

from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..proof import plane_integrals as integrals
from ..proof.plane_quadrature import defined
from ..proof.threshold import stationary
from . import interface
from .contact import DIGITS, Contact, short

Rows = list[tuple[tuple[float, ...], Any]]
DISTANCE = 2.7
"""Of the reference point of the depth, over the half-width."""


def plane(contact: Contact, function: interface.Function) -> Rows:
    """Calls of a function with their results."""
    rows: Rows = []
    with mp.workdps(DIGITS + integrals.GUARD):
        for a in contact.radii() if contact.compact else [contact.all["a"]]:
            rows += _Strip(contact, a).rows(function)
    return rows


class _Strip:
    """One half-width; a complete contact carries a load that holds all of its face in contact."""

    def __init__(self, contact: Contact, a: float) -> None:
        self.contact, self.a = contact, a
        self.known = {**contact.given(), nt.a: sp.Rational(a), nt.E_star: sp.Rational(contact.all["E_star"])}
        self.other = a if contact.compact else self.load()

    def load(self) -> float:
        known, n = self.contact.all, self.contact.all.get("n", 2.0)
        whole = known["E_star"] * known.get("h", known["a"] / 100)
        return short(8.0 * whole * n / (n - 1.0))

    def value(self, suffix: str, **places: float) -> Any:
        fields = {getattr(nt, name): sp.Rational(value) for name, value in places.items()}
        load = {} if self.contact.compact else {nt.P: sp.Rational(self.other)}
        return defined(self.contact.profile, suffix, {**self.known, **load, **fields}, DIGITS)

    def face(self, place: float, order: int) -> Any:
        """f or its slope f' at a place of the contact."""
        pieces, known = self.contact.profile.pieces, self.known
        own = next(p for p in pieces if p.upper is None or place < float(p.upper.xreplace(known)))
        expr = sp.diff(own.expr, nt.x, order).xreplace({**known, nt.x: sp.Rational(place)})
        return mp.mpf(str(sp.N(expr, 40)))

    def level(self) -> tuple[Any, Any]:
        """Where the pressure of a concave face vanishes first on unloading, and the load at which it does."""
        known, a = self.known, mp.mpf(self.a)

        def missing(x: Any) -> Any:
            own = {**known, nt.P: sp.S.Zero, nt.x: sp.Rational(str(x)) if x else sp.S.Zero}
            return -mp.pi * mp.sqrt((a - x) * (a + x)) * defined(self.contact.profile, "p", own, DIGITS)

        rough, step = mp.mpf("0.5"), mp.mpf("0.25")
        while step > 1e-4:
            rough = max((abs(rough - step), rough, min(rough + step, mp.mpf("0.99"))), key=lambda s: missing(a * s))
            step /= 2
        if rough < 1e-3:
            return mp.mpf(0), missing(mp.mpf(0))
        return stationary(missing, a * rough, a)

    def rows(self, function: interface.Function) -> Rows:
        a, other = self.a, self.other
        places = [short(x) for x in (0.45 * a, *self.contact.between(a))]
        outside = short(1.6 * a)
        match function.name:
            case "profile":
                return [((sign * x,), self.face(x, 0)) for x in places for sign in (1.0, -1.0)]
            case "pressure":
                under = [((sign * x, other), self.value("p", x=x)) for x in places for sign in (1.0, -1.0)]
                return [*under, ((outside, other), mp.mpf(0))]
            case "slope":
                beside = self.value("s", x=outside)
                under = [((x, other), -self.face(x, 1)) for x in places]
                return [((outside, other), beside), ((-outside, other), -beside), *under]
            case "depth":
                distance = short(DISTANCE * a)
                return [((distance, other), self.value("d", L=distance))]
            case "zero_distance" | "minimum_load":
                return [((), self.level()[0 if function.name == "zero_distance" else 1])]
            case "half_width_from_load":
                return [((float(self.value("P")),), mp.mpf(a))]
        return [((a,), self.value("P"))]
