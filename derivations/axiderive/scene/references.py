"""Values a module is checked with: integrals of the definition at 20 digits, never the module's own rules.

A complete contact has its edge fixed, on either half-space; adhesion breaks by the balance of energies, which is the
reference for `pull_off`; strips have both sides of the middle; a viscoelastic half-space convolves the elastic contact.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property, partial
from typing import Any

import mpmath as mp
import numpy as np
import sympy as sp

from .. import notation as nt
from ..code import example
from ..entry import COMPACT
from ..exits import FAILED, CommandError
from ..oracle.definitions import ring
from ..oracle.evaluate import case_at, evaluated
from ..oracle.half_space import HalfSpace
from ..oracle.integrals import GUARD, under_load
from ..oracle.plane import GUARD as STRIPS
from ..oracle.plane import defined, strip
from ..oracle.shape import number
from ..physics import layer
from ..physics.consequences import CONSEQUENCES
from ..profiles.loads import Load
from . import interface
from .contact import DIGITS, Contact, short
from .fields import Below
from .interface import Function
from .layered import Layered
from .relaxing import Relaxing

Rows = list[tuple[tuple[float, ...], Any]]
"""Calls of a function, by their fields, with their results."""
LOAD = 3.0
"""Line load at which the eccentric punch is checked."""
COARSE = 8
"""Digits of a load that is only compared with another one."""
PLACES = 24
"""On the face, at which the depth of complete contact is looked for."""
FURTHER = 1.3 ** np.arange(1, 6)
"""Larger radii over this one at which a load is asked whether it is carried twice."""
WIDER = 4.0 ** np.arange(6)
"""Radii over this one, of which the first is taken at which a load is on its stable branch."""
DISTANCE = 2.7
"""Of the reference point of the depth of a strip, over the half-width."""
LATER = (0.4, 1.9)
"""Times over that of the material."""
NEAR = 1e-9
"""Of a break, relative: a radius that is found at it."""
NEAREST = 1e-15
"""To a radius, relative: a length beside it."""
BELOW = ((0.45, 0.3), (1.6, 0.7))
"""Places below a face, over the radius of its edge."""
STEP = 1e-6
"""Relative: of a radius next to another one."""
NOTHING = 1e-14
"""Of the retraction: a depth that is none."""
State = tuple[float, float, float]
"""Radius, force and depth."""


@dataclass(frozen=True)
class Value:
    """One call and its result."""

    function: str
    fields: tuple[float, ...]
    keywords: tuple[tuple[str, float], ...]
    wanted: Any
    """A number, or a tuple of several results."""
    of: str = ""
    """The named tuple that its fields are."""

    def record(self) -> dict[str, Any]:
        """The call and its value as plain data."""
        several = isinstance(self.wanted, tuple)
        return {
            "function": self.function,
            "fields": list(self.fields),
            "keywords": dict(self.keywords),
            # an infinite number has no form in JSON
            "value": [x if np.isfinite(x) else repr(x) for x in self.wanted] if several else self.wanted,
        }


def check_values(contact: Contact, keywords: Mapping[str, Sequence[str]]) -> list[Value]:
    """A few values of every function that is wanted, `pull_off` left out, with the keywords of each."""
    profile, kind = contact.profile, contact.request.kind
    rows, found = _rules(contact), []
    with mp.workdps(DIGITS + (STRIPS if kind.system.pool.strip else GUARD)):
        for name in contact.request.quantities:
            if name != interface.PULL_OFF:
                function = interface.function(kind, profile, name)
                calls, of = rows(function), "SlidingStress" if function.whole and not function.fields else ""
                passed = tuple((keyword, contact.all[keyword]) for keyword in keywords[name])
                found += [Value(name, fields, passed, _plain(wanted), of) for fields, wanted in calls]
    return found


def _plain(wanted: Any) -> float | tuple[float, ...]:
    return tuple(map(float, wanted)) if isinstance(wanted, list) else float(wanted)


def _rules(contact: Contact) -> Callable[[Function], Rows]:
    """What gives the calls of a function of this contact."""
    kind = contact.request.kind
    if interface.contact_of(contact.profile) == interface.TILTED:
        return lambda function: _tilted(contact, function)
    if kind.system.pool.strip:
        widths = contact.radii() if contact.compact else [contact.all["a"]]
        return lambda function: [row for a in widths for row in _Strip(contact, a).rows(function)]
    if isinstance(contact.profile, Load):
        load = contact.profile
        return lambda function: _sunk(contact, load)
    if kind.physics is layer.PHYSICS:
        return Layered(contact).rows
    edged = Edged(contact)
    if kind.law:
        return lambda function: _relaxing(contact, edged, function)
    if kind.physics in interface.WHOLE:
        own = below(contact)
        return lambda function: own.rows(function) if function.whole else _pressed(contact, edged, function)
    return lambda function: _pressed(contact, edged, function)


def _pressed(contact: Contact, edged: Edged, function: Function) -> Rows:
    if not contact.compact:
        return edged.rows(function)
    solved = contact.request.kind.physics.solved and not contact.profile.breaks
    # integrals of integrals take seconds
    radii = contact.radii()[-1:] if solved else contact.radii()
    return [row for a in radii for row in _Radius(contact, a).rows(function)]


def below(contact: Contact) -> Below:
    """The fields below the surface."""
    edged = Edged(contact)
    return Below(contact, *((contact.radii(), contact.load) if contact.compact else (edged.depths, edged.at)))


def _sunk(contact: Contact, load: Load) -> Rows:
    """The displacement under a prescribed pressure, inside and outside its circle."""
    a = contact.all["a"]
    known = {**contact.given(), nt.E_star: sp.Rational(contact.all["E_star"])}
    exponent = number(load.exponent.xreplace(known))
    places = [short(0.45 * a), short(0.95 * a), short(1.6 * a)]
    return [
        ((r,), under_load({**known, nt.r: sp.Rational(r)}, exponent, DIGITS)) for r in places
    ]  # fmt: skip


def _tilted(contact: Contact, function: Function) -> Rows:
    """The eccentric punch by its proved formulas, which no integral of the profile defines."""
    a, entry = contact.all["a"], contact.entries[function.quantity.suffix]
    known = {**contact.given(), nt.E_star: sp.Rational(contact.all["E_star"]), nt.P: sp.Rational(LOAD)}
    if not function.leaning:
        return [((LOAD,) if function.fields else (), example.value(entry, known))]
    places = [short(share * a) for share in (-0.85, -0.3, 0.4, 0.9)]
    return [((x, LOAD), example.value(entry, {**known, nt.x: sp.Rational(x)})) for x in places]


class _Radius:
    """One radius of a contact that grows, on either half-space."""

    def __init__(self, contact: Contact, a: float) -> None:
        self.contact, self.a = contact, a

    def rows(self, function: Function) -> Rows:
        """Calls of a function with their results."""
        kind = self.contact.request.kind
        stated = kind.physics.definitions
        if stated is None or function.kind != kind:
            return self.pressed(function)
        definitions = stated(self.contact.profile, kind.system.medium)
        return (self.solved if kind.physics.solved else self.superposed)(function, definitions)

    def pressed(self, function: Function) -> Rows:
        """Normal contact, with or without adhesion."""
        a, height, quantity, load = self.a, self.contact.height, function.quantity, self.contact.load
        places = [short(x) for x in (0.45 * a, *self.contact.between(a))]
        outside = short(1.6 * a)
        match function.name:
            case "profile":
                return [((r,), height(r)) for r in places]
            case "pressure":
                return [*(((r, a), load("p", a, r=r)) for r in places), ((outside, a), mp.mpf(0))]
            case "displacement":
                under = [((r, a), load("d", a) - height(r)) for r in places]
                return [((outside, a), load("w", a, r=outside)), *under]
            case _ if quantity.suffix in CONSEQUENCES and a != self.contact.radii()[0]:
                return []  # an integral of integrals takes seconds
            case _ if quantity.place == "inside":
                return [((places[0], a), load(quantity.suffix, a, r=places[0])), ((outside, a), load("F", a))]
            case _ if quantity.member:
                return [((a,), self.contact.peak(a)[quantity.member == "radius"])]
            case _ if source := quantity.inverts:
                if self.contact.request.kind.physics.tension and not self.outermost(source):
                    return []
                target = quantity.symbol
                return [((float(load(source, a)),), mp.mpf(a) if target == nt.a else load(str(target), a))]
        return [((a,), load(quantity.suffix, a))]

    def outermost(self, source: str) -> bool:
        """Whether the load rises through this radius and no larger one in the domain carries the same.

        That of waves is not asked on a graded half-space: the quadrature over many of them takes more than a minute.
        """
        contact = self.contact
        if not contact.request.kind.graded:
            return contact.outermost(source, self.a)
        if nt.wavelength in contact.profile.parameters:
            return False
        own = contact.half_space()
        if not own.separation(COMPACT[source].function, mp.mpf(self.a)) > own.at(nt.dgamma):
            return False
        here, end = contact.load(source, self.a, COARSE), contact.end()
        return all(contact.load(source, float(x), COARSE) > here for x in self.a * FURTHER if x < end)

    def superposed(self, function: Function, stated: Mapping[str, sp.Expr]) -> Rows:
        """What superposes normal contacts, by the definitions of its physics; a field on both sides of c."""
        a, contact, quantity = self.a, self.contact, function.quantity
        c, rows = contact.stick(a), Rows()
        for r in (0.5 * c, 0.5 * (a + c)) if nt.r in quantity.arguments else (0.0,):
            here = contact.half_space(a=a, c=c, r=r)
            known = {nt.r: r, nt.a: a, nt.c: c}
            fields = (known.get(s) or float(here.defined(stated[quantity.inverts])) for s in quantity.arguments)
            found = here.at(quantity.symbol) if quantity.inverts else here.defined(stated[quantity.suffix])
            rows.append((tuple(fields), found))
        return rows

    def solved(self, function: Function, stated: Mapping[str, sp.Expr]) -> Rows:
        """A contact with a length that is the root of an equation, by the definitions at that length."""
        a, quantity, places, physics = (
            self.a,
            function.quantity,
            [short(0.45 * self.a)],
            self.contact.request.kind.physics,
        )
        if quantity in physics.searched:
            source = quantity.inverts
            own = next((one for one in self.others(WIDER) if one.rises(source)), None)
            return [((float(own.at(own.length(stated)).defined(stated[source])),), mp.mpf(own.a))] if own else []
        length, solved = self.length(stated), physics.solved
        if quantity.symbol == solved:
            return [((a,), length)]
        if quantity.place == "outside":
            places = [short(float(length * share + a * (1 - share))) for share in (0.4, 1.7)]
        rows = Rows()
        for r in places if nt.r in quantity.arguments else (0.0,):
            # what takes the length itself is defined at the rounded one
            here = self.at(mp.mpf(float(length)) if solved in quantity.arguments else length, r=r)
            fields = tuple({nt.r: r, nt.a: a, solved: float(length)}[symbol] for symbol in quantity.arguments)
            rows.append((fields, here.defined(stated[quantity.suffix])))
        return rows

    def at(self, length: Any, **places: float) -> HalfSpace:
        """The half-space with a value of the length that is solved for."""
        here, solved = self.contact.half_space(DIGITS, a=self.a, **places), self.contact.request.kind.physics.solved
        assert solved is not None
        return replace(here, values={**here.values, solved: length})

    def formula(self, suffix: str, length: Any) -> Any:
        """A quantity by its proved formula, at a value of the length; of an equation the logarithm of its sides."""
        here = self.at(length)
        known = case_at(self.contact.superposed[suffix], here.values).expr
        if not isinstance(known, sp.Equality):
            return evaluated(known, here.values)
        return mp.log(evaluated(known.lhs, here.values) / evaluated(known.rhs, here.values))

    @cached_property
    def root(self) -> str:
        """The suffix of the length that is solved for."""
        physics = self.contact.request.kind.physics
        table = physics.table(self.contact.profile)
        return next(suffix for suffix, own in table.items() if own.symbol == physics.solved)

    @cached_property
    def rough(self) -> Any:
        """The length as the root of its proved formula; None where that is beyond the profile."""
        formula, end = partial(self.formula, self.root), self.contact.end()
        ends = self.a * (1 + mp.mpf(NEAREST)), min(end * (1 - mp.mpf(NEAR)), self.a / mp.mpf(STEP))
        if self.a >= end or formula(ends[1]) < 0:
            return None
        return mp.findroot(formula, ends, solver="anderson", tol=mp.mpf(10) ** -DIGITS, verify=False)

    def length(self, stated: Mapping[str, sp.Expr]) -> Any:
        """The root by one step of the definition from that of the formula, found once."""
        contact, key = self.contact, (self.root, self.a)
        if key not in contact.found:
            start, wanted = self.rough, stated[self.root]
            if start is None:
                given = ", ".join(f"{name} = {contact.all[name]:g}" for name in contact.request.kind.material)
                message = f"{given}: at a = {float(self.a):.3g} m the zone is beyond the profile; change these values"
                raise CommandError(message, FAILED)
            here, step = self.at(start), STEP * (start - self.a)
            missing = mp.log(here.defined(wanted.lhs) / here.defined(wanted.rhs))
            contact.found[key] = start - missing * step / self.formula(self.root, start + step)
        return contact.found[key]

    def loaded(self, suffix: str) -> Any:
        """A load by its proved formula."""
        return self.formula(suffix, self.rough)

    def others(self, shares: Any) -> Iterator[_Radius]:
        """Those at other radii, over this one, whose zones end before the profile does."""
        found = (_Radius(self.contact, float(self.a * share)) for share in shares)
        return (one for one in found if one.rough is not None)

    def rises(self, suffix: str) -> bool:
        """Whether a load rises through this radius and no larger one in the domain carries the same."""
        return all(one.loaded(suffix) > self.loaded(suffix) for one in self.others((1 + STEP, *FURTHER)))


class Edged:
    """One complete contact at the values of a scene."""

    def __init__(self, contact: Contact) -> None:
        self.contact = contact

    @property
    def a(self) -> Any:
        """Radius of the edge."""
        return mp.mpf(self.contact.all["a"])

    def at(self, suffix: str, depth: float, **places: float) -> Any:
        """A quantity of the normal contact at a depth."""
        here = self.contact.half_space(DIGITS, d=depth, **places)
        radius, free = here.contact(self.a)
        place = places.get("r")
        if suffix == "p" and place is not None and place > radius:
            return mp.mpf(0)
        if suffix == "w" and place is not None and place <= radius:
            return mp.mpf(depth) - self.contact.height(place)
        if place is not None and suffix not in "pw" and place >= radius:
            return here.normal("F", radius, free)
        return here.normal(suffix, radius, free)

    @cached_property
    def depths(self) -> list[float]:
        """Above the least depth of complete contact; of a convex face also one at which its edge is free."""
        full = self.contact.half_space().depth(self.a)
        if full > 0:
            return [short(float(full * share)) for share in (0.4, 1.7)]
        least = max(self.depth_at(self.a * i / PLACES, COARSE) for i in range(PLACES)) if full else self.a / 200
        return [short(float(2 * least))]

    def depth_at(self, r: Any, digits: int) -> Any:
        """The depth at which the pressure at r vanishes."""
        here = self.contact.half_space(digits, r=r)
        full, alone = here.depth(self.a), here.pressure(r, self.a)
        return full - alone / (here.pressure(r, self.a, full + 1) - alone)

    @cached_property
    def ring(self) -> tuple[Any, Any]:
        """Where the pressure vanishes first on unloading, and the depth at which it does."""
        # of the digits of the curve the place loses seven
        return ring(self.depth_at, self.a, 2 * DIGITS)

    def rows(self, function: Function) -> Rows:
        """Calls of a function with their results."""
        kind = self.contact.request.kind
        if kind.physics.definitions and function.kind == kind:
            return self.superposed(function, kind.physics.definitions(self.contact.profile, kind.system.medium))
        a, inside, outside = float(self.a), short(0.45 * float(self.a)), short(1.6 * float(self.a))
        match function.name:
            case "profile":
                return [((inside,), self.contact.height(inside))]
            case "retraction":
                return [((), self.contact.half_space().retraction(self.a))]
            case "zero_radius" | "minimum_depth":
                return [((), self.ring[function.name == "minimum_depth"])]
            case "minimum_force":
                return [((), self.contact.half_space().force(self.a, self.ring[1]))]
            case "pressure":
                return [((r, d), self.at("p", d, r=r)) for d in self.depths for r in (inside, outside)]
            case "displacement":
                places = (inside, outside, short(3.0 * a))
                return [((r, d), self.at("w", d, r=r)) for d in self.depths for r in places]
            case "depth_from_force":
                return [((float(self.at("F", d)),), mp.mpf(d)) for d in self.depths]
        if function.quantity.place == "inside":
            suffix = function.quantity.suffix
            return [((r, d), self.at(suffix, d, r=r)) for d in self.depths for r in (inside, outside)]
        rows: Rows = [((d,), self.at(function.quantity.suffix, d)) for d in self.depths]
        return rows if interface.arguments(function, self.contact.entries) else [((), rows[0][1])]

    def superposed(self, function: Function, stated: Mapping[str, sp.Expr]) -> Rows:
        """What the physics defines over the face, a field at places below it."""
        own, rows = function.quantity, Rows()
        for r, z in BELOW if nt.z in own.arguments else BELOW[:1]:
            place = {"r": short(r * float(self.a)), "z": short(z * float(self.a))}
            found = self.contact.half_space(DIGITS, **place).defined(stated[own.suffix])
            rows.append((tuple({**self.contact.all, **place}[name] for name in function.fields), found))
        return rows


def detached(contact: Contact, control: str, radius: float) -> State | None:
    """The state of which the module says the radius: the root of dgamma nearby, None for waves, which take minutes."""
    if nt.wavelength in contact.profile.parameters:
        return None
    with mp.workdps(DIGITS + GUARD):
        if contact.request.kind.physics.solved:
            return _parted(contact, control, radius)
        here, wanted = contact.half_space(), mp.mpf(contact.all["dgamma"])
        if not contact.compact:
            a = mp.mpf(contact.all["a"])
            return float(a), float(here.adhesive("F", a)), float(here.adhesive("d", a))
        known = contact.given()
        corner = next((b for s in contact.profile.breaks if abs(radius / (b := number(known[s])) - 1) < NEAR), None)

        def missing(scale: Any) -> Any:
            return mp.log(here.separation(control, radius * scale) / wanted)

        if corner is not None and missing(corner * (1 + NEAR) / radius) > 0:
            # At a break the load may turn without being stationary. Beyond it the depth grows as the root of the
            # distance, 1e-6 of it within two units of the last place: the loads are those of the radius itself.
            at = mp.mpf(radius)
            return float(corner), float(here.adhesive("F", at)), float(here.adhesive("d", at))
        start = mp.mpf(1)
        scale = mp.findroot(missing, (start, start * (1 + mp.mpf(STEP))), solver="secant", tol=1e-30, verify=False)
        # what is held is least there where the work of separation rises through that of the scene
        place = radius * scale if missing(scale * (1 + STEP)) > 0 else mp.nan
        return float(place), float(here.adhesive("F", radius * scale)), _depth(here, radius * scale)


def _parted(contact: Contact, control: str, radius: float) -> State | None:
    """Where a load is least by the proved formulas, at a break or stationary, and the loads there by the definitions.

    None within a flat face, where the zone begins to reach beyond it: no formula is stated of such a contact.
    """
    known = contact.given()
    breaks = [b for b in (number(known[symbol]) for symbol in contact.profile.breaks) if b <= radius * (1 + NEAR)]
    if contact.profile.truncated and not breaks:
        return None
    corner = bool(breaks) and abs(radius / breaks[-1] - 1) < NEAR
    start = breaks[-1] if breaks and not corner else mp.mpf(0)

    kind = contact.request.kind
    suffixes = {name: own.quantity.suffix for name, own in interface.functions(kind).items()}

    def place(share: Any) -> Any:
        return start + (radius - start) * share

    def rate(share: Any) -> Any:
        more, less = (_Radius(contact, place(share + step)).loaded(suffixes[control]) for step in (STEP, -STEP))
        return (more - less) / STEP

    share = mp.mpf(1)
    if not corner:
        share = mp.findroot(rate, (share, share + STEP), solver="secant", tol=1e-10, verify=False)
    own = _Radius(contact, place(share))
    if not rate(share + 2 * STEP) > 0 or kind.physics.definitions is None:
        return (float("nan"),) * 3
    stated = kind.physics.definitions(contact.profile, kind.system.medium)
    here = own.at(own.length(stated))
    force, depth = (float(here.defined(stated[suffixes[load]])) for load in ("force", "depth"))
    return float(own.a), force, depth


def _depth(here: HalfSpace, a: Any) -> float:
    """The depth; where nothing but the rounding of the radius is left of it, as under r**(3/2), it is none."""
    depth = here.adhesive("d", a)
    return float(depth) if here.graded or abs(depth) > NOTHING * here.retraction(a) else 0.0


class _Strip:
    """One half-width; a complete contact carries a load that holds all of its face in contact."""

    def __init__(self, contact: Contact, a: float) -> None:
        self.contact, self.a = contact, a
        self.known = {**contact.given(), nt.a: sp.Rational(a), nt.E_star: sp.Rational(contact.all["E_star"])}
        self.other = a if contact.compact else self.load()

    def load(self) -> float:
        """A line load [N/m] well above that of complete contact, in few digits."""
        known, n = self.contact.all, self.contact.all.get("n", 2.0)
        whole = known["E_star"] * known.get("h", known["a"] / 100)
        return short(8.0 * whole * n / (n - 1.0))

    def value(self, suffix: str, **places: float) -> Any:
        """A quantity by its definition at this half-width, or this load; `places` are fields by name."""
        fields = {getattr(nt, name): sp.Rational(value) for name, value in places.items()}
        load = {} if self.contact.compact else {nt.P: sp.Rational(self.other)}
        return defined(self.contact.profile, suffix, {**self.known, **load, **fields}, DIGITS)

    def face(self, place: float, order: int) -> Any:
        """f or its slope f' at a place of the contact."""
        pieces, known = self.contact.profile.pieces, self.known
        own = next(p for p in pieces if p.upper is None or place < float(p.upper.xreplace(known)))
        expr = sp.diff(own.expr, nt.x, order).xreplace({**known, nt.x: sp.Rational(place)})
        return mp.mpf(str(sp.N(expr, 40)))

    def ring(self) -> tuple[Any, Any]:
        """Where the pressure of a concave face vanishes first on unloading, and the load at which it does."""
        faces = cache(lambda digits: strip(self.contact.profile, self.known, digits))
        place, load = ring(lambda x, digits: faces(digits).level(x), mp.mpf(self.a), 2 * DIGITS)
        return place, load * number(self.known[nt.E_star])

    def rows(self, function: Function) -> Rows:
        """Calls of a function with their results: positional arguments, and the value by the definition."""
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
                return [((), self.ring()[function.name == "minimum_load"])]
            case "half_width_from_load":
                return [((float(self.value("P")),), mp.mpf(a))]
        return [((a,), self.value("P"))]


def _relaxing(contact: Contact, edged: Edged, function: Function) -> Rows:
    """A contact that grows, or one whose edge is fixed, each at a time of its own."""
    values = contact.all
    scale = values["eta"] / values["E"] if "eta" in values else values.get("tau", values.get("t_0", 1.0))
    if contact.compact:
        found = [(mp.mpf(a), mp.mpf(a), contact.load("F", a)) for a in contact.radii()]
    else:
        found = [(mp.mpf(d), edged.a, edged.at("F", d)) for d in edged.depths * 2]
    times, sunk = [mp.mpf(f"{later * scale:.4g}") for later in LATER], partial(contact.load, "d")
    return [Relaxing(contact, sunk, *one, t).row(function) for one, t in zip(found, times, strict=False)]
