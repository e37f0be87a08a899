"""Values a module is checked with: integrals of the definition at 20 digits, never the module's own rules."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..emit import example
from ..entry import Entry
from ..profiles.loads import Load
from ..profiles.profile import Profile
from ..proof.load_quadrature import displacement
from . import interface
from .contact import DIGITS, Contact, short
from .grading import graded
from .mirrored import plane
from .relaxing import relaxing

if TYPE_CHECKING:
    from .request import Request

Rows = list[tuple[tuple[float, ...], Any]]
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
        return {
            "function": self.function,
            "fields": list(self.fields),
            "keywords": dict(self.keywords),
            "value": self.wanted,
        }


def check_values(
    profile: Profile,
    entries: Mapping[str, Entry],
    request: Request,
    keywords: Callable[[Sequence[str]], tuple[str, ...]],
) -> list[Value]:
    """A few values of every function that is wanted, `pull_off` left out."""
    contact = Contact(profile, entries, request)
    found = []
    for name in request.quantities:
        if name == interface.PULL_OFF:
            continue
        if request.physics.startswith("graded"):
            rows = graded(contact, name)
        elif request.physics == "plane":
            rows = plane(contact, interface.functions("plane", profile.contact)[name])
        elif isinstance(profile, Load):
            rows = _sunk(contact, profile)
        elif interface.law_of(request.physics):
            rows = relaxing(contact, interface.functions(request.physics)[name])
        else:
            rows = _compact(contact, request.physics, name) if contact.compact else _complete(contact, name)
        parameters = [*(p.name for p in profile.parameters), *interface.MATERIAL[request.physics]]
        free = tuple((k, contact.all[k]) for k in keywords(parameters))
        found += [Value(name, fields, free, float(wanted)) for fields, wanted in rows]
    return found


def _sunk(contact: Contact, load: Load) -> Rows:
    """The displacement under a prescribed pressure, inside and outside its circle."""
    a = contact.all["a"]
    known = {**contact.given(), nt.E_star: sp.Rational(contact.all["E_star"])}
    with mp.workdps(DIGITS + 10):
        exponent = mp.mpf(load.exponent.p) / load.exponent.q
        places = [short(0.45 * a), short(0.95 * a), short(1.6 * a)]
        return [((r,), displacement({**known, nt.r: sp.Rational(r)}, exponent, DIGITS)) for r in places]


def _compact(contact: Contact, physics: str, name: str) -> Rows:
    rows: Rows = []
    for a in contact.radii():
        with mp.workdps(DIGITS + 10):
            rows += [(fields, value) for fields, value in _at(contact, physics, name, a) if value is not None]
    return rows


def _at(contact: Contact, physics: str, name: str, a: float) -> Rows:
    """Calls at one contact radius with their results."""
    own = _slipping(contact, name, a) if physics == "tangential" else []
    return own or _pressed(contact, physics, name, a)


def _pressed(contact: Contact, physics: str, name: str, a: float) -> Rows:
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
        case "radius_from_depth" | "radius_from_force" | "force_from_depth" | "depth_from_force":
            source = "d" if name.endswith("depth") else "F"
            if physics == "adhesive" and not contact.outermost(source, a):
                return []
            given = float(contact.depth(a) if source == "d" else contact.force(a))
            target = {"radius": mp.mpf, "force": contact.force, "depth": contact.depth}[name.split("_")[0]]
            return [((given,), target(a))]
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


def _complete(contact: Contact, name: str) -> Rows:
    """A complete contact by its closed entries, at a depth above the least one."""
    functions = interface.functions("normal", "complete")
    entry = contact.entries.get(functions[name].quantity.suffix)
    known: dict[sp.Symbol, sp.Expr] = {**contact.given(), nt.E_star: sp.Rational(contact.all["E_star"])}
    if entry is None or entry.status == "root" or any(e.has(nt.r_zero) for e in [c.expr for c in entry.cases]):
        return []
    a = known.get(nt.a, sp.S.One)
    least = contact.entries.get("dmin")
    depth = a / 100
    if least is not None and least.status == "closed" and not least.cases[0].expr.has(nt.r_zero):
        depth = 2 * sp.Rational(str(example.value(contact.profile, least, known)))
    fields = {nt.d: float(depth), nt.r: float(a) * (1.5 if name == "displacement" else 0.4)}
    if name == "depth_from_force":
        at = known | {nt.d: sp.Rational(fields[nt.d])}
        fields[nt.F] = float(example.value(contact.profile, contact.entries["F"], at))
    arguments = interface.arguments(functions[name], contact.entries)
    own = {nt.describe(n).symbol: sp.Rational(fields[nt.describe(n).symbol]) for n in arguments}
    return [(tuple(float(v) for v in own.values()), example.value(contact.profile, entry, known | own))]
