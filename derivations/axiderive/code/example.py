"""The doctests: one number per function, computed from the exact entry and not by the emitted code."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import COMPACT, Entry
from ..letters import name_of
from ..oracle import shape
from ..oracle.definitions import least
from ..oracle.evaluate import case_at, height, value_of
from ..oracle.half_space import HalfSpace
from ..oracle.layer import Layer, layer
from ..oracle.shape import Number, coefficient
from ..physics.adhesive import FORCE, TENSION, separation, work_of_peeling
from ..physics.layer import BASES
from ..physics.systems import System
from ..physics.viscoelastic import in_radius
from ..profiles.profile import Profile
from .function import fit

Values = dict[sp.Symbol, Any]
MODULI: Values = {nt.E_star: sp.S.One, nt.H: sp.S.One, nt.k: sp.Rational(1, 4)}
POLYNOMIAL = (sp.Rational(1, 10), sp.Rational(1, 4), sp.Rational(1, 20))
STICK = sp.Rational(3, 5)
"""c/a, or its place between a flat face and a."""
BESIDE = sp.Rational(8, 7)
"""A radius beside the contact, over a."""
PLACES = 97
"""Radii at which the least force is looked for: a prime, so that no break of a drawn profile is met."""
TERMS: Values = {nt.N: sp.Integer(len(POLYNOMIAL)), **{coefficient(i): c for i, c in enumerate(POLYNOMIAL, 1)}}
"""The polynomial that is drawn."""
SHOWN, DIGITS, PRECISE = 6, 15, 30
"""Decimals of a doctest, digits of a quadrature, and those of a formula."""
STEP = mp.mpf("0.001")
"""From the drawn state, with which a search begins."""
RINGS = (nt.r_zero, nt.x_zero, nt.r_peak)
"""Places on the face that an equation defines."""
DEFINED = (*RINGS, nt.t_1, nt.t_c)
"""These, and times of a way back."""


def numbers(profile: Profile) -> dict[sp.Symbol, sp.Rational]:
    """Values of the parameters, those of the sketch."""
    values = {symbol: sp.Rational(str(value)) for symbol, value in profile.sketch.values}
    return {symbol: value for symbol, value in values.items() if symbol in profile.parameters}


def value(entry: Entry, known: Values) -> Number:
    """The exact result at these values, to 30 digits."""
    expr = case_at(entry, known).expr
    return number(expr.rhs if isinstance(expr, sp.Eq) else expr, known)


def number(expr: sp.Expr, known: Values) -> Number:
    """The value, to 30 digits."""
    return value_of(expr, {**TERMS, **known}, PRECISE)


def _holds(entry: Entry, place: sp.Symbol) -> bool:
    return any(case.expr.has(place) for case in entry.cases)


def rounded(number: Number) -> sp.Rational:
    """The number to four significant digits, as an exact rational."""
    return sp.Rational(str(sp.Float(str(number), 4)))


def literal(number: Any) -> str:
    """The number as a Python float in text."""
    return repr(float(number))


def doctest(package: str, module: str, call: str, number: Number, member: str = "", name: str = "value") -> list[str]:
    """The lines of a doctest: the import, a call of the module, and a member of the result or itself, rounded."""
    first, *others = fit(f"{name} = {module}.{call}", 12)
    lines = [f">>> from {package} import {module}", f">>> {first}", *(f"... {other}" for other in others)]
    shown = f"{name}.{member}" if member else name
    return [*lines, f">>> round({shown}, {SHOWN})", repr(round(float(number), SHOWN))]


@dataclass
class Example:
    """The doctests of one module."""

    profile: Profile
    entries: Mapping[str, Entry]
    system: System
    elastic: Mapping[str, Entry]
    """The normal contact, from which a stick radius takes F(a) and a step of depth takes a(d)."""

    @cached_property
    def known(self) -> Values:
        """Parameters as drawn, unit moduli, and fields in the middle of the contact."""
        profile, shown = self.profile, self.system.physics.shown
        known = MODULI | {symbol: sp.Rational(text) for symbol, text in shown.items()} | numbers(profile)
        known |= {symbol: expr.subs(known) for symbol, expr in profile.abbreviations}
        radius = known.get(nt.a, sp.Rational(str(profile.sketch.a)))
        floor = known[profile.breaks[0]] if profile.truncated else sp.S.Zero
        stick = rounded(sp.N(floor + STICK * (radius - floor)))
        place = {self.system.pool.place: radius * sp.Rational(3, 10), nt.L: 10 * radius}
        rings = dict.fromkeys(RINGS[:2], radius * sp.Rational(2, 5)) | {nt.r_peak: (radius + floor) / 2}
        if solved := self.system.physics.solved:
            rings[solved] = rounded(sp.N(radius * BESIDE))
        return {nt.a: radius, nt.c: stick, nt.d: self.loads[nt.d], **place, **rings} | known

    @property
    def loads(self) -> Values:
        """A depth, which keeps a concave face in complete contact, and a force."""
        drawn = self.profile.sketch.d if self.profile.complete else None
        return {nt.d: sp.Rational(str(drawn)) if drawn else sp.Rational(1, 5), nt.F: sp.Rational(1, 5)}

    @cached_property
    def layered(self) -> Layer:
        """The contact with a layer, by the displacement of its surface."""
        return self._layer(adhesive=False)

    @cached_property
    def pulled(self) -> Layer:
        """The same with adhesion."""
        return self._layer(adhesive=True)

    def _layer(self, *, adhesive: bool) -> Layer:
        here = HalfSpace(self.profile, TERMS | self.known, 2 * SHOWN, graded=False)
        return layer(here, next(iter(BASES)), adhesive=adhesive)

    def lines(self, suffix: str) -> list[str]:
        """The doctest of the function behind one entry."""
        entry = self.entries[suffix]
        quantity, at = entry.quantity, dict(self.known)
        if quantity.symbol in (nt.w, nt.slope):
            at[self.system.pool.place] = 2 * at[nt.a]
        if quantity.inverts and quantity.symbol != self.system.physics.solved:
            # what is solved in numbers has no value at a rounded place
            given = self.number(self.entries[quantity.inverts], at)
            at[quantity.arguments[0]] = given if entry.status == "equation" else rounded(given)
        # a depth or a load that is held is a keyword beside the time
        held = entry.arguments[1:] if self.system.physics.laws else ()
        at |= self.loads if held else {}
        passed = [literal(at[symbol]) for symbol in entry.arguments if symbol not in held]
        passed += [self.keyword(symbol, at) for symbol in (*held, *entry.parameters)]
        return self._shown(f"{quantity.function}({', '.join(passed)})", self.number(entry, at), quantity.member)

    def shape(self) -> list[str]:
        """The doctest of the shape of the indenter."""
        place = self.system.pool.place
        passed = [literal(self.known[place]), *(self.keyword(s, self.known) for s in self.profile.parameters)]
        with mp.workdps(PRECISE):
            found = height(self.profile, TERMS | self.known, self.known[place])
        return self._shown(f"{COMPACT['f'].function}({', '.join(passed)})", found)

    def state(self, suffix: str = "") -> list[str]:
        """The doctest of the state of pull-off: its force by that entry, else the least value of F(a)."""
        entry = self.entries[suffix or "F"]
        passed = ", ".join(self.keyword(symbol, self.known) for symbol in entry.parameters)
        force = self.number(entry, self.known) if suffix else self.least_force()
        return self._shown(f"pull_off({passed})", force, "force", "state")

    def _shown(self, call: str, number: Number, member: str = "", name: str = "value") -> list[str]:
        return doctest(self.system.package, self.profile.name, call, number, member, name)

    def keyword(self, symbol: sp.Symbol | sp.IndexedBase, at: Values) -> str:
        """A keyword argument with its value as Python code, a polynomial as the tuple A."""
        if symbol == nt.coefficients:
            return f"A=({', '.join(literal(c) for c in POLYNOMIAL)})"
        return f"{name_of(symbol)}={literal(at[symbol])}"

    def number(self, entry: Entry, at: Values) -> Number:
        """The exact value; what an equation defines is its root near the drawn state."""
        symbol = entry.quantity.symbol
        if entry.status in ("equation", "expansion"):
            with mp.workdps(SHOWN + DIGITS):
                own = self.pulled if nt.dgamma in entry.parameters else self.layered
                return own.stated(entry)
        if entry.status == "integral" and self.system.medium.graded:
            return self.defined(entry, at)
        if entry.status == "root" and entry.composed:
            outer, inner = entry.composed
            return self.number(self.entries[outer], at | {nt.a: self.number(self.entries[inner], at)})
        places = (*DEFINED, self.system.physics.solved)
        for ring in self.entries.values():
            place = ring.quantity.symbol
            needed = place in places and place not in entry.arguments and ring is not entry and _holds(entry, place)
            if needed and {*ring.parameters} <= {*entry.parameters}:
                at = at | {place: self.number(ring, at)}
        if entry.status == "root" and isinstance(case_at(entry, at).expr, sp.Eq):
            if symbol in (nt.a, nt.c, *places):
                return self.root(entry, symbol, at)
            at = at | {nt.a: self.root(self.elastic["ad"], nt.a, at)}
        elif self.system.physics.laws and in_radius(entry):
            at = at | {nt.a: self.reached(entry, at)}
        return value(entry, at)

    def reached(self, entry: Entry, at: Values) -> Number:
        """The contact radius on a ramp, or on the way back from it."""
        back, law = nt.t_m in entry.parameters, entry.suffix.split("_")[1]
        until = self.number(self.entries[f"earlier_{law}"], at) if back else at[nt.time]
        radius, given = self.elastic["ad"], at | {nt.d: at[nt.v] * until}
        return self.root(radius, nt.a, given) if radius.status == "root" else value(radius, given)

    def defined(self, entry: Entry, at: Values) -> Number:
        """A pressure or displacement on a graded half-space without closed form, by quadrature."""
        here, physics = HalfSpace(self.profile, at, DIGITS, graded=True), self.system.physics
        with mp.workdps(2 * DIGITS):
            if physics.definitions:
                found = here.defined(physics.definitions(self.profile, here.medium)[entry.suffix])
            else:
                found = (here.adhesive if physics.tension else here.normal)(entry.suffix, shape.number(at[nt.a]))
            return mp.re(found)

    @property
    def floor(self) -> sp.Expr:
        """The radius at which the contact begins."""
        return self.known[self.profile.breaks[0]] if self.profile.truncated else sp.S.Zero

    def root(self, entry: Entry, unknown: sp.Symbol, at: Values) -> Number:
        """The unknown that solves the equation of an entry, to 30 digits; searched from its drawn value."""

        def missed(x: Number) -> Number:
            known = {**at, unknown: x}
            equation = case_at(entry, known).expr
            return number(equation.lhs - equation.rhs, known)

        with mp.workdps(PRECISE):
            start, low = shape.number(self.known[unknown]), shape.number(self.floor)
            if unknown == nt.a:  # at no step below a flat face
                first = mp.log(start - low)
                return low + mp.exp(_secant(lambda above: missed(low + mp.exp(above)), first, first + STEP))
            return _secant(missed, start, start * (1 + STEP))

    def least_force(self) -> Number:
        """The least of F(a)."""
        return self._least(self.entries["F"], lambda expr: expr)

    def _least(self, entry: Entry, form: Callable[[Any], Any]) -> Number:
        """The least value up to the drawn radius, to 30 digits: on a grid, then next to its lowest point."""

        def curve(x: Number) -> Number:
            known = {**self.known, nt.a: x}
            return number(form(case_at(entry, known).expr), known)

        with mp.workdps(PRECISE):
            low = shape.number(self.floor)
            reach = shape.number(self.known[nt.a]) - low
            # a break itself belongs to no case
            grid = [low + reach * mp.mpf("1e-20"), *(low + reach * i / PLACES for i in range(1, PLACES + 1))]
            values = [curve(x) for x in grid]
            best = min(range(len(grid)), key=lambda i: values[i])
            below, above = grid[max(best - 1, 0)], grid[min(best + 1, len(grid) - 1)]
            return min(values[best], least(curve, below, above))

    def separation(self, name: str) -> list[str]:
        """The doctest of the work of separation of a pull-off force: its definition, searched for the least value."""
        entry, medium = self.entries["Fc"], self.system.medium
        held = [symbol for symbol in entry.parameters if symbol != nt.dgamma]
        force = rounded(self.number(entry, self.known) if self.profile.complete else self.least_force())
        if self.profile.complete:
            work = number(work_of_peeling(self.entries), self.known | {TENSION: -force})
        else:
            state = separation(medium).subs(TENSION, -force)
            work = self._least(self.elastic["F"], lambda expr: state.subs(FORCE, expr))
        passed = ", ".join([literal(force), *(self.keyword(symbol, self.known) for symbol in held)])
        return self._shown(f"{name}({passed})", work)


def _secant(equation: Callable[[Any], Any], first: Any, second: Any) -> Any:
    # a last step of 1e-25 leaves an error of 1e-38; below that are steps of rounding, half of all
    return mp.findroot(equation, (first, second), tol=mp.mpf("1e-25"), verify=False)
