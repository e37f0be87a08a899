"""Numbers of one contact at the values of a scene: integrals of the definition, never the module's own rules."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

import mpmath as mp
import numpy as np
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..exits import FAILED, CommandError
from ..expression import ExpressionError
from ..expression.definition import Defined, Definition, Numeric, definition, lengths
from ..expression.validity import examine
from ..letters import name_of
from ..oracle.definitions import greatest
from ..oracle.evaluate import height
from ..oracle.half_space import HalfSpace
from ..oracle.shape import shape
from ..physics.layer import thickness
from ..profiles.profile import Profile
from . import interface

if TYPE_CHECKING:
    from .reading import Scene

DIGITS = 20
STICK = 0.6
"""Radius of the stick zone over the contact radius, or its place between a flat face and it."""
LAYER = name_of(thickness)
NEEDLE = 1e-3
"""A contact radius under a profile without lengths, in m."""
MATERIAL = {"E_star": 1.0e6, "dgamma": 0.05, "G_star": 8.0e5, "mu": 0.3, "H": 1.0e6, "k": 0.25, "H_x": 8.0e5,
            "E": 1.0e6, "E_inf": 4.0e5, "E_1": 1.3e6, "eta": 3.0e6, "tau": 2.5, "alpha": 0.3, "t_0": 1.7}  # fmt: skip
"""Material values where a scene leaves them free; those of others are shown by their physics."""


def values_of(profile: Profile, request: Scene) -> tuple[dict[str, float], float]:
    """Values of all parameters, and the radius up to which the contact is compact.

    Free parameters of an expression are all drawn as 1, where q and 1/q are the
    same: here they differ, unless the profile is not compact then.
    """
    own = _drawn(profile, request.values)
    physics = request.kind.physics
    shown = {name_of(symbol): float(sp.Rational(text)) for symbol, text in physics.shown.items()}
    drawn = shown | MATERIAL
    units = {name_of(symbol): nt.describe(symbol).unit for symbol in physics.material}
    if physics.solved or "m" in units.values():
        # shown for the modulus 1 and lengths of 1: lengths, also one that is solved for, are of the size of the contact
        modulus, length = request.values.get("E_star", MATERIAL["E_star"]), _size(profile, own)
        scales = {"m": length}
        if physics.solved:
            scales |= {"Pa": modulus, nt.describe("dgamma").unit: modulus * length}
        drawn |= {name: shown[name] * scales[unit] for name, unit in units.items() if unit in scales}
    material = {n: request.values.get(n, drawn[n]) for n in request.kind.material}
    if request.own is None:
        return own | material, np.inf
    free = [p.name for p in profile.parameters if p.name not in request.values]
    moved = {
        name: own[name] * (1.3 if name in map(str, profile.breaks) else 1.0 + 0.13 * (i + 1))
        for i, name in enumerate(free)
    }
    try:
        reach = _reach(profile, own | moved)
    except ExpressionError:
        moved, reach = {}, _reach(profile, own)
    return own | moved | material, reach


def _drawn(profile: Profile, values: Mapping[str, float]) -> dict[str, float]:
    """The free parameters as they are sketched, lengths to the scale of the frozen ones, so that all rules hold."""
    sketched, names = {p: float(v) for p, v in profile.sketch.values}, interface.parameters(profile)
    drawn = {name: sketched.get(p, 1.0) for name, p in names.items()}
    long = [name for name, p in names.items() if p in lengths([p])]
    # below a body that leaves its lengths free, that of a layer
    around = values.get(LAYER, 2.0) / 2.0
    scales = [abs(values[name] / drawn[name]) for name in long if name in values] or [around]
    first = None
    for scale in (*scales, *(min(scales) * 10.0**-i for i in range(1, 7))):
        known = {n: values.get(n, drawn[n] * (scale if n in long else 1.0)) for n in names}
        first = first or known
        exact = {p: sp.Float(known[n]) for n, p in names.items()}
        if all(rule.relation().xreplace(exact) == sp.true for rule in profile.rules):
            return known
    assert first is not None
    return first


def _size(profile: Profile, values: Mapping[str, float]) -> float:
    """A contact radius of the size of the lengths of a profile; that of a needle where it has none."""
    drawn, own = dict(profile.sketch.values), interface.parameters(profile).items()
    scales = [values[name] / float(drawn[symbol]) for name, symbol in own if lengths([symbol])]
    return min(scales) * profile.sketch.a if scales else NEEDLE


def short(place: float) -> float:
    """A place in few digits; where it lies exactly does not matter."""
    return float(f"{place:.4g}")


def _reach(profile: Profile, values: Mapping[str, float]) -> float:
    found = examine(profile, {p: values[p.name] for p in profile.parameters}).compact_to
    return np.inf if found is None else found


def worked(contact: Contact) -> str:
    """The worked example in words, by the definition."""
    with mp.workdps(DIGITS):
        a = contact.worked
        name, value = contact.request.at or ("a", a)
        states = {"a": mp.mpf(a), "d": contact.load("d", a), "F": contact.load("F", a)}
    shown = ", ".join(f"{k} = {mp.nstr(v, 7)} {nt.describe(k).unit}" for k, v in states.items() if k != name)
    return f"Example: at {name} = {value:g} {nt.describe(name).unit} it is {shown}."


class Contact:
    """Numbers of one contact at frozen and chosen values."""

    def __init__(self, profile: Profile, entries: Mapping[str, Entry], request: Scene) -> None:
        self.profile, self.entries, self.request = profile, entries, request
        self.all, self.reach = values_of(profile, request)
        self.exact = {p: sp.Rational(self.all[name]) for name, p in interface.parameters(profile).items()}
        self.compact = profile.compact
        self.found: dict[tuple[Any, ...], Any] = {}

    def given(self) -> dict[sp.Symbol, sp.Expr]:
        """Parameters, and abbreviations as floats of 40 digits."""
        known: dict[sp.Symbol, sp.Expr] = dict(self.exact)
        for symbol, expr in self.profile.abbreviations:
            known[symbol] = sp.Rational(str(sp.N(expr.xreplace(known), 40)))
        return known

    def radii(self) -> list[float]:
        """Contact radii of the size of the profile, on both sides of its breaks, and that of the worked example."""
        return [*map(short, self._drawn()), *([self.worked] if self.request.at else [])]

    def _drawn(self) -> list[float]:
        known = {s: float(v) for s, v in self.given().items()}
        breaks = [known[b] for b in self.profile.breaks]
        if breaks:
            inner = [] if self.profile.truncated else [0.6 * breaks[0]]
            found = [*inner, 1.4 * breaks[-1]]
            return [x for x in found if x < self.reach] or [breaks[-1] + 0.5 * (self.reach - breaks[-1])]
        top = min(_size(self.profile, self.all), 0.8 * self.end(), self.all.get(LAYER, np.inf))
        return [0.4 * top, top]

    def end(self) -> float:
        """The radius at which the profile, or its contact, ends; infinite for most."""
        known, own = self.given(), self.profile
        ends = [self.reach, *([float(own.largest.xreplace(known))] if own.largest is not None else [])]
        if own.chain and own.chain[-1] in known:
            ends.append(float(known[own.chain[-1]]))
        return min(ends)

    def between(self, a: float) -> list[float]:
        """A place in the last piece below the contact radius, where there is more than one."""
        inner = [b for b in (float(self.given()[b]) for b in self.profile.breaks) if b < a]
        return [0.5 * (inner[-1] + a)] if inner else []

    def stick(self, a: float) -> float:
        """The radius of a zone of stick within a contact."""
        floor = float(self.given()[self.profile.breaks[0]]) if self.profile.truncated else 0.0
        return short(floor + STICK * (a - floor))

    def peak(self, a: float) -> tuple[mp.mpf, mp.mpf]:
        """The greatest pressure and its radius, searched for once."""
        key = ("peak", a)
        # the nodes next to the edge are told from it
        with mp.workdps(3 * DIGITS):
            face = shape(self.profile, self.given() | {nt.a: sp.Rational(a)})
            place, found = self.found.get(key) or self.found.setdefault(key, greatest(face, mp.mpf(a), 2 * DIGITS))
            return mp.mpf(self.all["E_star"]) * found, place

    def height(self, at: float) -> mp.mpf:
        """f(r) at a radius, to 30 digits."""
        known = self.given() | {nt.r: sp.Rational(at)}
        with mp.workdps(30):
            return height(self.profile, known, known[nt.r])

    def half_space(self, digits: int = DIGITS, **places: float) -> HalfSpace:
        """The half-space, graded or not, under this profile at the values of the scene; `places` are fields by name."""
        known = {nt.E_star: mp.mpf(self.all.get("E_star", 1.0))}
        known |= {interface.record(name).symbol: mp.mpf(self.all[name]) for name in self.request.kind.material}
        fields = {getattr(nt, name): mp.mpf(value) for name, value in places.items()}
        values = {**known, **self.given(), **fields}
        if self.request.kind.graded or not self.compact:
            return HalfSpace(self.profile, values, digits, self.request.kind.graded)
        return Defined(self.profile, values, digits, False, self._definition)

    @cached_property
    def superposed(self) -> Mapping[str, Entry]:
        """The entries of a contact that superposes the one whose entries are known."""
        return self.request.kind.system.derive(self.profile, self.entries)

    @cached_property
    def _definition(self) -> Definition:
        return definition(self.profile, self.given(), DIGITS)

    def load(self, suffix: str, a: float, digits: int = DIGITS, **places: float) -> Any:
        """A quantity at a contact radius, with adhesion where there is some."""
        key = (suffix, a, digits, *places.items())
        if key not in self.found:
            own = self.half_space(digits, **places)
            self.found[key] = (own.adhesive if self.request.kind.physics.tension else own.normal)(suffix, mp.mpf(a))
        return self.found[key]

    @cached_property
    def _numeric(self) -> Numeric:
        return Numeric(self.profile, {s: float(v) for s, v in self.given().items()})

    def curve(self, quantity: str, a: Any) -> Any:
        """Depth or force in doubles, to see where it rises."""
        numeric = self._numeric
        E, lost = self.all["E_star"], np.zeros_like(a)
        if self.request.kind.physics.tension:
            lost = np.sqrt(2.0 * np.pi * a * self.all["dgamma"] / E)
        return numeric.depth(a) - lost if quantity == "d" else E * numeric.force(a) - 2.0 * E * a * lost

    def outermost(self, quantity: str, a: float) -> bool:
        """Whether the load rises through this radius and no larger one carries the same."""
        values = self.curve(quantity, a * np.array([0.999, *1.03 ** np.arange(120)]))
        return bool(values[0] < values[1]) and bool(np.all(values[2:] > values[1]))

    @cached_property
    def worked(self) -> float:
        """Contact radius of the worked example.

        Raises
        ------
        CommandError
            If no contact carries its load.
        """
        name, value = self.request.at or ("a", 0.0)
        if name == "a":
            return value
        floor = float(self.given()[self.profile.breaks[0]]) if self.profile.truncated else 0.0
        grid = max(self._drawn()) * 10.0 ** np.linspace(-8.0, 8.0, 4001)
        grid = grid[grid > floor]
        load = self.curve(name, grid)
        rises = np.flatnonzero((load[:-1] <= value) & (load[1:] > value))
        if not len(rises):
            message = (
                f"no contact radius carries {name} = {value:g}; change want.at, or name a radius, at = {{ a = ... }}"
            )
            raise CommandError(message, FAILED)
        low, high = grid[rises[-1]], grid[rises[-1] + 1]
        for _ in range(60):
            middle = 0.5 * (low + high)
            above = bool(self.curve(name, np.array([middle]))[0] > value)
            low, high = (low, middle) if above else (middle, high)
        return float(high)
