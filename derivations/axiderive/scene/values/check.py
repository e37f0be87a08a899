"""Values a module is checked with: integrals of the definition at 20 digits, never the module's own rules."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import mpmath as mp
import sympy as sp

from ... import notation as nt
from ...code import example
from ...oracle.integrals import under_load
from ...oracle.shape import number
from ...profiles.loads import Load
from .. import interface
from .contact import DIGITS, Contact, short
from .references import Edged, compact, plane, relaxing

Rows = list[tuple[tuple[float, ...], Any]]
LOAD = 3.0
"""Line load at which the eccentric punch is checked."""


@dataclass(frozen=True)
class Value:
    """One call and its result."""

    function: str
    fields: tuple[float, ...]
    keywords: tuple[tuple[str, float], ...]
    wanted: float

    def record(self) -> dict[str, Any]:
        """The call and its value as plain data."""
        return {
            "function": self.function,
            "fields": list(self.fields),
            "keywords": dict(self.keywords),
            "value": self.wanted,
        }


def check_values(contact: Contact, keywords: Callable[[Sequence[str]], tuple[str, ...]]) -> list[Value]:
    """A few values of every function that is wanted, `pull_off` left out."""
    profile, request = contact.profile, contact.request
    edged, shape = Edged(contact), interface.contact_of(profile)
    found = []
    for name in request.quantities:
        if name == interface.PULL_OFF:
            continue
        if shape == interface.TILTED:
            rows = _tilted(contact, interface.functions(request.kind, shape)[name])
        elif request.kind.system.pool.strip:
            rows = plane(contact, interface.functions(request.kind, shape)[name])
        elif isinstance(profile, Load):
            rows = _sunk(contact, profile)
        elif request.kind.law:
            rows = relaxing(contact, edged, interface.functions(request.kind, shape)[name])
        elif not contact.compact:
            rows = edged.rows(name)
        else:
            rows = compact(contact, name)
        parameters = [*interface.parameters(profile), *request.kind.material]
        free = tuple((k, contact.all[k]) for k in keywords(parameters))
        found += [Value(name, fields, free, float(wanted)) for fields, wanted in rows]
    return found


def _sunk(contact: Contact, load: Load) -> Rows:
    """The displacement under a prescribed pressure, inside and outside its circle."""
    a = contact.all["a"]
    known = {**contact.given(), nt.E_star: sp.Rational(contact.all["E_star"])}
    with mp.workdps(DIGITS + 10):
        exponent = number(load.exponent.xreplace(known))
        places = [short(0.45 * a), short(0.95 * a), short(1.6 * a)]
        return [((r,), under_load({**known, nt.r: sp.Rational(r)}, exponent, DIGITS)) for r in places]


def _tilted(contact: Contact, function: interface.Function) -> Rows:
    """The eccentric punch by its proved formulas, which no integral of the profile defines."""
    a, entry = contact.all["a"], contact.entries[function.quantity.suffix]
    known = {**contact.given(), nt.E_star: sp.Rational(contact.all["E_star"]), nt.P: sp.Rational(LOAD)}
    places = [short(share * a) for share in (-0.85, -0.3, 0.4, 0.9)] if function.leaning else []
    calls: list[tuple[tuple[float, ...], dict[sp.Symbol, sp.Expr]]]
    calls = [((x, LOAD), {nt.x: sp.Rational(x)}) for x in places]
    calls = calls or [((LOAD,) if function.fields else (), {})]
    return [(fields, example.value(entry, known | at)) for fields, at in calls]
