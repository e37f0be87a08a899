"""Values a module is checked with: integrals of the definition at 20 digits, never the module's own rules."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import mpmath as mp
import sympy as sp

from ... import notation as nt
from ...code import example
from ...oracle.load_quadrature import displacement
from ...oracle.shape import number
from ...profiles.loads import Load
from .. import interface
from .contact import DIGITS, Contact, short
from .references import Edged, graded, plane, relaxing

Rows = list[tuple[tuple[float, ...], Any]]
LOAD = 3.0
"""Line load at which the eccentric punch is checked."""
STICK = 0.6
"""Radius of the stick zone over the contact radius, or its place between a flat face and it."""


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
        elif request.kind.graded:
            rows = graded(contact, name)
        else:
            rows = _compact(contact, name)
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
        return [((r,), displacement({**known, nt.r: sp.Rational(r)}, exponent, DIGITS)) for r in places]


def _compact(contact: Contact, name: str) -> Rows:
    rows: Rows = []
    for a in contact.radii():
        with mp.workdps(DIGITS + 10):
            rows += [(fields, value) for fields, value in _at(contact, name, a) if value is not None]
    return rows


def _at(contact: Contact, name: str, a: float) -> Rows:
    """Calls at one contact radius with their results."""
    own = _slipping(contact, name, a) if contact.request.kind.physics.shear else []
    return own or _pressed(contact, name, a)


def _pressed(contact: Contact, name: str, a: float) -> Rows:
    """Normal contact, with or without adhesion."""
    E, pi, moved = mp.mpf(contact.all["E_star"]), mp.pi, contact.moved(a)
    outside, places = short(1.6 * a), [short(x) for x in (0.45 * a, *contact.between(a))]

    def pulled(inside: float) -> Any:
        return E * moved / (pi * mp.sqrt((mp.mpf(a) - inside) * (mp.mpf(a) + inside)))

    match name:
        case "profile":
            return [((inside,), contact.height(inside)) for inside in places]
        case "depth":
            return [((a,), contact.depth(a))]
        case "force":
            return [((a,), contact.force(a))]
        case "pressure":
            under = [((inside, a), contact.normal("p", a, inside) - pulled(inside)) for inside in places]
            return [*under, ((outside, a), mp.mpf(0))]
        case "displacement":
            lift = 2 / pi * mp.asin(mp.mpf(a) / outside) * moved
            under = [((inside, a), contact.depth(a) - contact.height(inside)) for inside in places]
            return [((outside, a), contact.normal("w", a, outside) - lift), *under]
        case "stiffness":
            return [((a,), 2 * E * a)]
        case "mean_pressure":
            return [((a,), contact.force(a) / (pi * mp.mpf(a) ** 2))]
        case "retraction":
            return [((a,), moved)]
        case "peak_pressure" | "peak_radius":
            return [((a,), contact.peak(a)[name == "peak_radius"])]
        case _ if name in interface.INVERSES:
            quantity = interface.functions(interface.NORMAL)[name].quantity
            if contact.request.kind.physics.tension and not contact.outermost(quantity.inverts, a):
                return []
            state = {nt.a: mp.mpf, nt.d: contact.depth, nt.F: contact.force}
            return [((float(state[quantity.arguments[0]](a)),), state[quantity.symbol](a))]
    return []


def _slipping(contact: Contact, name: str, a: float) -> Rows:
    """Partial slip: mu times the difference of two normal contacts."""
    floor = float(contact.given()[contact.profile.breaks[0]]) if contact.profile.truncated else 0.0
    c = floor + STICK * (a - floor)
    mu, G = mp.mpf(contact.all["mu"]), mp.mpf(contact.all["G_star"])
    ratio = mu * mp.mpf(contact.all["E_star"]) / G
    match name:
        case "tangential_force":
            return [((a, c), mu * (contact.force(a) - contact.force(c)))]
        case "traction":
            stuck, slipped = 0.5 * c, 0.5 * (a + c)
            difference = contact.normal("p", a, stuck) - contact.normal("p", c, stuck)
            return [((stuck, a, c), mu * difference), ((slipped, a, c), mu * contact.normal("p", a, slipped))]
        case "tangential_displacement":
            return [((a, c), ratio * (contact.depth(a) - contact.depth(c)))]
        case "stick_radius":
            return [((float(mu * (contact.force(a) - contact.force(c))), a), mp.mpf(c))]
        case "full_slip_displacement":
            return [((a,), ratio * contact.depth(a))]
    return []


def _tilted(contact: Contact, function: interface.Function) -> Rows:
    """The eccentric punch by its proved formulas, which no integral of the profile defines."""
    a, entry = contact.all["a"], contact.entries[function.quantity.suffix]
    known = {**contact.given(), nt.E_star: sp.Rational(contact.all["E_star"]), nt.P: sp.Rational(LOAD)}
    places = [short(share * a) for share in (-0.85, -0.3, 0.4, 0.9)] if function.leaning else []
    calls: list[tuple[tuple[float, ...], dict[sp.Symbol, sp.Expr]]]
    calls = [((x, LOAD), {nt.x: sp.Rational(x)}) for x in places]
    calls = calls or [((LOAD,) if function.fields else (), {})]
    return [(fields, example.value(entry, known | at)) for fields, at in calls]
