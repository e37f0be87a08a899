"""Check values by the definitions, by quadrature: complete, adhesive, graded, plane and viscoelastic contact.

A complete contact has its edge fixed, on either half-space; adhesion breaks by the balance of energies, which is the
reference for `pull_off`; strips have both sides of the middle; a viscoelastic half-space convolves the elastic contact.
"""

from __future__ import annotations

import math
from functools import cached_property
from typing import Any

import mpmath as mp
import numpy as np
import sympy as sp

from ... import notation as nt
from ...entry import COMPACT
from ...letters import name_of
from ...oracle import plane as integrals
from ...oracle.definitions import stationary
from ...oracle.integrals import GUARD
from ...oracle.plane import defined
from ...oracle.shape import number
from .. import interface
from .contact import DIGITS, Contact, short

Rows = list[tuple[tuple[float, ...], Any]]
STICK = 0.6
"""Radius of the stick zone over the contact radius, or its place between a flat face and it."""
COARSE = 8
"""Digits of a load that is only compared with another one."""
FURTHER = 1.3 ** np.arange(1, 6)
"""Larger radii over this one at which a load is asked whether it is carried twice."""


def compact(contact: Contact, name: str) -> Rows:
    """Calls of a function of a contact that grows, with their results."""
    kind = contact.request.kind
    own, below = interface.functions(kind), interface.functions(interface.NORMAL)
    rows: Rows = []
    with mp.workdps(DIGITS + 10):
        for a in contact.radii():
            at = _Radius(contact, a)
            if kind.physics.shear and name in own:
                rows += at.slipping(name, own[name])
            else:
                rows += at.pressed(name, own.get(name) or below.get(name) or interface.peaks(contact.profile)[name])
    return rows


class _Radius:
    """One contact radius, on either half-space."""

    def __init__(self, contact: Contact, a: float) -> None:
        self.contact, self.a = contact, a
        self.adhesive, self.graded = contact.request.kind.physics.tension, contact.request.kind.graded

    def load(self, suffix: str, a: float | None = None, digits: int = DIGITS, **places: float) -> Any:
        """A quantity of the contact, with adhesion where there is some."""
        radius, found = a or self.a, self.contact.found
        if not self.graded:
            return self.contact.quantity(suffix, radius, places.get("r"))
        key = (f"{suffix}, {digits} digits", radius, places.get("r"))
        if key not in found:
            own = self.contact.half_space(digits, **places)
            found[key] = (own.adhesive if self.adhesive else own.normal)(suffix, mp.mpf(radius))
        return found[key]

    def pressed(self, name: str, function: interface.Function) -> Rows:
        """Normal contact, with or without adhesion."""
        a, height, quantity = self.a, self.contact.height, function.quantity
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
            case _ if quantity.member:
                return [((a,), self.contact.peak(a)[quantity.member == "radius"])]
            case _ if source := quantity.inverts:
                if self.adhesive and not self.outermost(source):
                    return []
                target = quantity.symbol
                return [((float(self.load(source)),), mp.mpf(a) if target == nt.a else self.load(str(target)))]
        return [((a,), self.load(quantity.suffix))]

    def outermost(self, source: str) -> bool:
        """Whether the load rises through this radius and no larger one in the domain carries the same.

        That of waves is not asked on a graded half-space: the quadrature over many of them takes more than a minute.
        """
        if not self.graded:
            return self.contact.outermost(source, self.a)
        if nt.wavelength in self.contact.profile.parameters:
            return False
        own = self.contact.half_space()
        if not own.separation(COMPACT[source].function, mp.mpf(self.a)) > own.at(nt.dgamma):
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
        match name:
            case "traction":
                return [((r, a, c), self.slip("tau", c, r)) for r in (0.5 * c, 0.5 * (a + c))]
            case "stick_radius":
                return [((float(self.slip("F", c)), a), mp.mpf(c))]
            case "full_slip_displacement":
                return [((a,), self.slip("us", c))]
        return [((a, c), self.slip(function.quantity.suffix, c))]

    def slip(self, suffix: str, c: float, r: float = 0.0) -> Any:
        """A quantity of partial slip with this stick radius."""
        if self.graded:
            return self.contact.half_space(c=c, r=r).tangential(suffix, mp.mpf(self.a))
        own, a = self.contact.normal, self.a
        friction, E, G = (mp.mpf(self.contact.all[name]) for name in ("mu", "E_star", "G_star"))
        if suffix == "tau":
            return friction * (own("p", a, r) - own("p", c, r))
        if suffix == "F":
            return friction * (own("F", a) - own("F", c))
        return friction * E / G * (own("d", a) - (own("d", c) if suffix == "u" else 0))


"""Digits of a pressure that is only compared with others."""
PLACES = tuple(i / 24 for i in range(1, 24))
"""Over the radius of the edge: where the weighted pressure is looked at for its least value."""


class Edged:
    """One complete contact at the values of a scene."""

    def __init__(self, contact: Contact) -> None:
        self.contact = contact
        self.graded = contact.request.kind.graded

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
        return here.normal(suffix, radius, free)

    @cached_property
    def depths(self) -> list[float]:
        """Above the least depth of complete contact; of a convex face also one at which its edge is free."""
        full = self.contact.half_space().depth(self.a)
        if full > 0:
            return [short(float(full * share)) for share in (0.4, 1.7)]
        if full == 0:
            return [short(float(self.a / 100))]
        least = full - min(self.weighted(self.a * share, COARSE) for share in (0.0, *PLACES))
        return [short(float(2 * least))]

    def weighted(self, r: Any, digits: int = DIGITS) -> Any:
        """The depth that the face alone needs for its pressure at r to vanish, with the sign turned."""
        here = self.contact.half_space(digits, r=r)
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
        return self.contact.half_space().depth(self.a) - self.weighted(self.ring)

    def pulled(self) -> tuple[Any, Any]:
        """Force and depth at which the edge peels: the contact without adhesion, short of its depth by Dl."""
        here = self.contact.half_space()
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
                return [((), self.contact.half_space().retraction(self.a))]
            case "zero_radius":
                return [((), self.ring)]
            case "minimum_depth":
                return [((), self.least)]
            case "minimum_force":
                return [((), self.contact.half_space().force(self.a, self.least))]
        rows: Rows = []
        for depth in self.depths:
            match name:
                case "force":
                    rows.append(((depth,), self.at("F", depth)))
                case "depth_from_force":
                    rows.append(((float(self.at("F", depth)),), mp.mpf(depth)))
                case "stiffness":
                    fields = interface.arguments(
                        interface.functions(interface.NORMAL, interface.contact_of(self.contact.profile))[name],
                        self.contact.entries,
                    )
                    rows.append(((depth,) if fields else (), self.at("k", depth)))
                case "pressure":
                    rows += [((r, depth), self.at("p", depth, r=r)) for r in (inside, outside)]
                case "displacement":
                    rows += [((r, depth), self.at("w", depth, r=r)) for r in (inside, outside, short(3.0 * a))]
        return rows[:1] if rows and not rows[0][0] else rows


NEAR = 1e-9
"""Of a break, relative: a radius that is found at it."""
STEP = 1e-6
"""Relative; the loads differ by its square, which 20 digits show."""
NOTHING = 1e-14
"""Of the retraction: a depth that is none."""
State = tuple[float, float, float]
"""Radius, force and depth."""


def _corners(contact: Contact) -> list[Any]:
    known = contact.given()
    return [number(known[b]) for b in contact.profile.breaks]


def _least(contact: Contact, control: str, radius: float, corner: Any) -> State:
    """The loads at a radius on both sides of which the one that is held is larger; NaN where it is not."""
    load = {"force": contact.force, "depth": contact.depth}[control]
    place = radius if corner is None else float(corner)
    here = load(place)
    # a flat tip carries nothing at a smaller radius
    turns = here < load(place * (1 + STEP)) and (contact.profile.truncated or here < load(place * (1 - STEP)))
    return place if turns else math.nan, float(contact.force(radius)), _depth(contact, radius, contact.depth(radius))


def _depth(contact: Contact, radius: float, depth: Any) -> float:
    """The depth; where nothing but the rounding of the radius is left of it, as under r**(3/2), it is none."""
    return float(depth) if abs(depth) > NOTHING * contact.moved(radius) else 0.0


def detached(contact: Contact, control: str, radius: float) -> State | None:
    """The state of which the module says the radius: the root of dgamma nearby, None for waves, which take minutes."""
    if nt.wavelength in contact.profile.parameters:
        return None
    edged = Edged(contact)
    with mp.workdps(DIGITS + GUARD):
        if not contact.compact:
            force, depth = edged.pulled()
            return float(edged.a), float(force), float(depth)
        corner = next((b for b in _corners(contact) if abs(radius / b - 1) < NEAR), None)
        if contact.request.own is not None and not edged.graded:
            return _least(contact, control, radius, corner)
        here, wanted = contact.half_space(), mp.mpf(contact.all["dgamma"])

        def missing(scale: Any) -> Any:
            return mp.log(here.separation(control, radius * scale) / wanted)

        if corner is not None and missing(corner * (1 + NEAR) / radius) > 0:
            # At a break the load may turn without being stationary. Beyond it the depth grows as the root of the
            # distance, 1e-6 of it within two units of the last place: the loads are those of the radius itself.
            at = mp.mpf(radius)
            return float(corner), float(here.adhesive("F", at)), float(here.adhesive("d", at))
        start = mp.mpf(1)
        scale = mp.findroot(missing, (start, start * (1 + mp.mpf(10) ** -6)), solver="secant", tol=1e-30, verify=False)
        a = radius * scale
        return float(a), float(here.adhesive("F", a)), _depth(contact, float(a), here.adhesive("d", a))


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
                return [((), self.level()[0 if function.name == "zero_distance" else 1])]
            case "half_width_from_load":
                return [((float(self.value("P")),), mp.mpf(a))]
        return [((a,), self.value("P"))]


LATER = (0.4, 1.9)
"""Times over that of the material."""


def relaxing(contact: Contact, edged: Edged, function: interface.Function) -> list[tuple[tuple[float, ...], Any]]:
    """Calls of a function with their results."""
    law = function.kind.law
    assert law is not None
    known = {symbol: sp.Float(contact.all[name_of(symbol)], 40) for symbol in law.parameters}
    modulus = sp.lambdify(nt.time, law.relaxation.xreplace(known), "mpmath")
    creep = sp.lambdify(nt.time, law.creep.xreplace(known), "mpmath")
    values = contact.all
    own = values["eta"] / values["E"] if "eta" in values else values.get("tau", values.get("t_0", 1.0))
    rows: list[tuple[tuple[float, ...], Any]] = []
    impulse = mp.mpf(str(law.impulse.xreplace(known)))
    with mp.workdps(DIGITS + 10):
        if not contact.compact:
            for d, later in zip(edged.depths * 2, LATER, strict=False):
                t = float(f"{later * own:.4g}")
                rows.append(_held(edged, function, d, t, modulus, impulse))
            return rows
        for a, later in zip(contact.radii(), LATER, strict=False):
            t, force, depth = float(f"{later * own:.4g}"), contact.normal("F", a), contact.normal("d", a)
            at = mp.mpf(t)
            if function.name == "step_load_radius":
                rows.append(((t, float(force / creep(at))), mp.mpf(a)))
            elif function.name == "step_force":
                rows.append(((t, float(depth)), modulus(at) * force))
            else:
                rows.append(((t, float(depth / at)), _ramp(contact, a, at, modulus, impulse)))
    return rows


def _held(
    edged: Edged, function: interface.Function, depth: float, t: float, modulus: Any, impulse: Any
) -> tuple[tuple[float, ...], Any]:
    """A complete contact: its edge, and so its radius, is fixed, and the force of a flat face grows as the depth."""
    force, at = edged.at("F", depth), mp.mpf(t)
    if function.name == "step_force":
        return (t, depth), modulus(at) * force
    whole = mp.quad(lambda y: modulus(at * y), [0, mp.mpf(1) / 2, 1])
    return (t, float(depth / at)), force * (whole + impulse / at)


def _ramp(contact: Contact, a: float, t: Any, modulus: Any, impulse: Any) -> Any:
    """int E(t - s) dF_el/ds ds with F_el ~ s**m; the exponent is that between this radius and half of it."""
    force, depth = contact.normal("F", a), contact.normal("d", a)
    m = mp.log(force / contact.normal("F", a / 2)) / mp.log(depth / contact.normal("d", a / 2))
    whole = mp.quad(lambda y: m * (1 - y) ** (m - 1) * modulus(t * y), [0, mp.mpf(1) / 2, 1])
    return force * (whole + impulse * m / t)
