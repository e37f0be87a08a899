"""Check values of a contact with a viscoelastic half-space: convolutions of the elastic one, and a way back to it.

The speed of a way back is chosen so that the contact is as large as it was at a chosen time.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any

import mpmath as mp

from ..checks.viscoelastic import material
from ..letters import name_of
from ..oracle.rules import gauss_rule, integrate
from ..oracle.shape import number
from .contact import DIGITS, Contact
from .interface import Function

TURNED = mp.mpf("0.7")
"""Of a time, when the indenter went back, of that, when it was stopped, and of that, when the contact was as large."""
NODES = 60
"""On a piece of a profile, for the springs below it."""


class Relaxing:
    """One contact on a viscoelastic half-space at a time t; after a way back it is as large as it was at t_1."""

    def __init__(self, contact: Contact, sunk: Callable[[Any], Any], size: Any, a: Any, force: Any, t: Any) -> None:
        """`sunk` is the depth of a smaller contact; `size` is the radius, or the depth where the edge is fixed."""
        law, values = contact.request.kind.law, contact.all
        assert law is not None
        self.own = material(law.suffix, {symbol: mp.mpf(values[name_of(symbol)]) for symbol in law.parameters})
        self.contact, self.sunk, self.size, self.a, self.force, self.t = contact, sunk, size, a, force, t
        self.depth = sunk(a) if contact.compact else size

    def row(self, function: Function) -> tuple[tuple[float, ...], Any]:
        """A call of a function with its result."""
        t, own = float(self.t), self.own
        match function.name:
            case "step_load_radius":
                return (t, float(self.force / own.creep(self.t, DIGITS))), self.size
            case "step_force":
                return (t, float(self.depth)), own.relaxation(self.t) * self.force
            case "ramp_force":
                return (t, float(self.depth / self.t)), self.pressed(self.t)
        t_h = TURNED * self.t
        t_m = TURNED * t_h
        t_1 = mp.mpf(0) if function.name == "contact_time" else TURNED * t_m
        v = self.depth / (t_1 or t_m)
        # what came after t_1 and what went since t_h have left nothing
        came = self.gained(self.t - t_1) - self.gained(self.t - t_m)
        turned = (float(v), float(v * came / self.gained(self.t - t_h)), float(t_m), float(t_h))
        if function.name == "contact_time":
            return turned, self.t
        found = {"earlier_time": t_1, "retract_radius": self.size}.get(function.name)
        return (t, *turned), self.pressed(t_1) if found is None else found

    def gained(self, time: Any) -> Any:
        """int E ds over the time since a spring was touched, with the impulse of a dashpot."""
        whole = integrate(self.own.relaxation, mp.mpf(0), time, (0j,), DIGITS, self.own.least)
        return self.own.impulse + whole

    def pressed(self, until: Any) -> Any:
        """int E(t - s) dF_el/ds ds up to a time: 2 v int (I(t - g(x)/v) - I(t - until)) dx over the springs below a.

        The edges of a piece, where g and I are no power series, are flattened.
        """
        v, gone = self.depth / until, self.gained(self.t - until) if until < self.t else mp.mpf(0)
        known = self.contact.given()
        breaks = [b for b in (number(known[b]) for b in self.contact.profile.breaks) if b < self.a]
        touched = self.a if not self.contact.compact else breaks[0] if self.contact.profile.truncated else mp.mpf(0)
        total = touched * self.gained(self.t) - self.a * gone
        for low, high in pairwise(sorted({touched, *breaks, self.a})):
            for s, weight in gauss_rule(NODES, mp.mp.prec):
                x = low + (high - low) * s**3 * (10 - 15 * s + 6 * s**2)
                left = self.t - self.sunk(x) / v
                total += 30 * (high - low) * weight * (s * (1 - s)) ** 2 * self.gained(max(left, mp.mpf(0)))
        return 2 * v * total
