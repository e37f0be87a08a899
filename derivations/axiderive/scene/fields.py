"""Values of fields below the surface at those of a scene: integrals over the wave number of the pressure's transform.

On the surface they are those of the pressure and of the load within the radius. A search finds its place first, as the
waves of the integrals end at a depth alone: its values are those of the definition, or of the formulas in exact
numbers, next to the place that the module found.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from itertools import cycle
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import FOUR, Entry
from ..letters import name_of
from ..oracle.half_space import HalfSpace
from ..oracle.rules import middle
from ..oracle.shape import Number
from ..oracle.subsurface import numbers, pressed
from ..physics import subsurface
from ..physics.consequences.load_within import CONSEQUENCE
from ..stable.fields import RESULTS, SHALLOW, exact_numbers
from .contact import DIGITS, Contact, short
from .interface import Function

_, FORCE, PRESSURE, _ = FOUR
WITHIN = CONSEQUENCE.compact.suffix
PLACES = ((0.45, 0.6), (1.6, 0.7))
"""Distances from the axis and depths, in contact radii."""
TURN = 0.7
"""From the direction of the traction."""
DEEP = 0.3
"""Contact radii from which the integrals over wave numbers have their digits."""
STRESS = (-0.7, -0.2, -1.3, 0.15, 0.4, -0.25)
"""A state rr, tt, zz, rt, rz, tz of which the measures are asked, over the modulus."""
STEP = mp.mpf("1e-6")
"""Of the differences next to a greatest value, in depths."""
TOWARDS = (1e-4, 1e-8, 1e-12)
"""Distances from a place, in contact radii, over which an infinite pressure grows by as much again."""
State = Mapping[sp.Symbol, Number]
"""S_m, D_m and W by their symbols."""
At = Callable[..., Number]
"""A quantity of the normal contact by its suffix, the radius or depth, and the place r."""


def principal(stress: Sequence[Number]) -> list[Number]:
    """The principal stresses of rr, tt, zz, rt, rz, tz, the largest first."""
    rr, tt, zz, rt, rz, tz = stress
    values = mp.eigsy(mp.matrix([[rr, rt, rz], [rt, tt, tz], [rz, tz, zz]]), eigvals_only=True)
    return sorted(values, reverse=True)


def von_mises(stress: Sequence[Number]) -> Number:
    """Equivalent stress of von Mises."""
    x, y, z = principal(stress)
    return mp.sqrt(((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2) / 2)


def tresca(stress: Sequence[Number]) -> Number:
    """Difference of the greatest and the least principal stress."""
    first, _, third = principal(stress)
    return first - third


MEASURES: dict[str, Callable[[Sequence[Number]], Any]] = {
    "add": lambda stress: list(stress),
    "hydrostatic": lambda stress: sum(stress[:3]) / 3,
    "principal": principal,
    "tresca": tresca,
    "von_mises": von_mises,
}
GREATEST: dict[str, Callable[[Sequence[Number]], Number]] = {
    "greatest_von_mises": von_mises,
    "greatest_shear": lambda stress: tresca(stress) / 2,
}


class Below:
    """The fields below one profile, at its contact radii or depths; `at` gives quantities of the normal contact."""

    def __init__(self, contact: Contact, sizes: Sequence[float], at: At) -> None:
        self.contact, self.sizes, self.at = contact, sizes, at
        self.known = {symbol: mp.mpf(contact.all[symbol.name]) for symbol in (nt.E_star, nt.nu, nt.mu)}
        self.known[subsurface.ANGLE] = mp.mpf(TURN)

    def rows(self, function: Function) -> list[tuple[tuple[float, ...], Any]]:
        """Calls of a function with their results; of a measure its stress, and of a search nothing yet."""
        if function.name in GREATEST:
            return [((self.sizes[-1],), [])]
        if not function.fields:
            stress = [short(x * self.contact.all["E_star"]) for x in STRESS]
            return [(tuple(stress), MEASURES[function.name](list(map(mp.mpf, stress))))]
        return [self._row(function, size, place) for size, place in zip(cycle(self.sizes), PLACES, strict=False)]

    def _row(self, function: Function, size: float, place: tuple[float, float]) -> tuple[tuple[float, ...], Any]:
        asked, radius = function.quantity.arguments, size if self.contact.compact else self.contact.all["a"]
        r, z = (short(x * radius) for x in place)
        fields = {nt.r: r, nt.z: z, subsurface.ANGLE: TURN, nt.a: size, nt.d: size, nt.c: self.contact.stick(size)}
        state = self.below(size, r, z) if nt.z in asked else self.on_surface(size, r, radius)
        if nt.c in asked:
            held = self.below(fields[nt.c], r, z)
            state = {symbol: value - held[symbol] for symbol, value in state.items()}
        found = self.components(function.name, state, r, z if nt.z in asked else 0.0)
        return tuple(fields[symbol] for symbol in asked), found if len(found) > 1 else found[0]

    def below(self, size: float, r: Number, z: Number) -> State:
        """The numbers by their definition."""
        key = ("below", size, r, z)
        if key not in self.contact.found:
            given = {name_of(nt.a if self.contact.compact else nt.d): size}
            values = self.contact.half_space(DIGITS, r=r, z=z, **given).values
            own, face = HalfSpace(self.contact.profile, values, DIGITS, graded=False), ("pressed", size)
            if face not in self.contact.found:
                self.contact.found[face] = pressed(own)
            found = numbers(own, self.contact.found[face])
            self.contact.found[key] = {subsurface.NUMBERS[suffix].symbol: value for suffix, value in found.items()}
        state: State = self.contact.found[key]
        return state

    def on_surface(self, size: float, r: float, radius: float) -> State:
        """The numbers at z = 0: S_0 of the pressure, and S_0 + S_2 of the load within the radius."""
        inside = r < radius or not self.contact.compact
        pressed = self.at(PRESSURE, size, r=r) if inside else mp.mpf(0)
        carried = self.at(WITHIN, size, r=r) if inside else self.at(FORCE, size)
        state = dict.fromkeys((*subsurface.SURFACE, *subsurface.DEEPER, nt.W), mp.mpf(0))
        state[nt.S_0] = mp.pi * pressed / self.known[nt.E_star]
        state[nt.S_2] = carried / (self.known[nt.E_star] * mp.mpf(r) ** 2) - state[nt.S_0]
        return state

    def components(self, name: str, state: State, r: Number, z: Number) -> list[Number]:
        """The results of a function, of its numbers."""
        values = {**self.known, **state, nt.r: mp.mpf(r), nt.z: mp.mpf(z)}
        return [sp.lambdify([*values], expr, "mpmath")(*values.values()) for expr in RESULTS[name].values()]

    def greatest(self, name: str, size: float, known: Sequence[float]) -> tuple[float, ...]:
        """The greatest value and its place next to those that are known: where the slopes of the measure vanish."""
        with mp.workdps(DIGITS + 10):
            value, r, z = map(mp.mpf, known)
            radius = size if self.contact.compact else self.contact.all["a"]
            if value == mp.inf:
                return float(value if self._grows(size, r, radius) else mp.nan), *known[1:]

            def measured(x: Number, y: Number) -> Number:
                state = self.below(size, x, y) if y > DEEP * radius else self.exact(size, x, y)
                rr, tt, zz, rz = self.components("stress", state, x, y)
                return GREATEST[name]((rr, tt, zz, mp.mpf(0), rz, mp.mpf(0)))

            here, h, zero = measured(r, z), z * STEP, mp.mpf(0)
            if z == 0:
                return float(here), *known[1:]
            ways = [(zero, h), *([(h, zero)] if r > h else [])]
            both = [(measured(r + x, z + y), measured(r - x, z - y)) for x, y in ways]
            slope = mp.matrix([(more - less) / 2 for more, less in both])
            bent = mp.diag([more - 2 * here + less for more, less in both])
            if r > h:
                bent[0, 1] = bent[1, 0] = measured(r + h, z + h) - both[0][0] - both[1][0] + here
            moved = mp.lu_solve(bent, -slope)
            top = here + (slope.T * moved)[0] / 2
            ends = [x + sum(m * way[i] for m, way in zip(moved, ways, strict=True)) for i, x in enumerate((r, z))]
            return tuple(map(float, (top, *ends)))

    def exact(self, size: float, r: Number, z: Number) -> State:
        """The numbers by their formulas, next to the surface too."""
        radius = size if self.contact.compact else self.contact.all["a"]
        place = {nt.r: r, nt.z: z or SHALLOW * radius, nt.a if self.contact.compact else nt.d: size}
        exact = {symbol: sp.Rational(str(sp.Float(x, 40))) for symbol, x in place.items()}
        return {s: middle(x.real) for s, x in exact_numbers(self.entries, self.contact.given() | exact).items()}

    @cached_property
    def entries(self) -> Mapping[str, Entry]:
        """The formulas of the profile."""
        return self.contact.request.kind.system.derive(self.contact.profile)

    def _grows(self, size: float, r: Number, radius: float) -> bool:
        """Whether the pressure grows towards a place by as much over each four decades."""
        near = [self.at(PRESSURE, size, r=abs(r - x * radius)) for x in TOWARDS]
        return 0.9 * (near[1] - near[0]) < near[2] - near[1] > 0
