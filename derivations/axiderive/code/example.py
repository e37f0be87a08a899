"""The doctests: one number per function, computed from the exact entry and not by the emitted code."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..abel.masters import MASTERS
from ..entry import COMPACT, Case, Entry
from ..letters import name_of
from ..oracle.definitions import least
from ..oracle.half_space import HalfSpace
from ..oracle.layer import Layer, layer
from ..oracle.shape import coefficient
from ..physics.adhesive import FORCE, TENSION, separation, work_of_peeling
from ..physics.layer import BASES
from ..physics.systems import System
from ..physics.viscoelastic import in_radius
from ..profiles.profile import Profile
from .function import fit

Values = dict[sp.Symbol, sp.Expr]
MODULI: Values = {nt.E_star: sp.S.One, nt.H: sp.S.One, nt.k: sp.Rational(1, 4)}
POLYNOMIAL = (sp.Rational(1, 10), sp.Rational(1, 4), sp.Rational(1, 20))
STICK = sp.Rational(3, 5)
"""c/a, or its place between a flat face and a."""
BESIDE = sp.Rational(8, 7)
"""A radius beside the contact, over a."""
PLACES = 97
"""Radii at which the least force is looked for: a prime, so that no break of a drawn profile is met."""
SHOWN, DIGITS = 6, 15
"""Decimals of a doctest, and digits of a quadrature."""
STEP = mp.mpf("0.001")
"""From the drawn state, with which a search begins."""
RINGS = (nt.r_zero, nt.x_zero, nt.r_peak)
"""Places on the face that an equation defines."""
DEFINED = (*RINGS, nt.t_1, nt.t_c)
"""These, and times of a way back."""
NUMERIC = [
    {"elliptic_f": mp.ellipf, "elliptic_e": mp.ellipe, **{master.__name__: master.numeric for master in MASTERS}},
    "mpmath",
]


def numbers(profile: Profile) -> dict[sp.Symbol, sp.Rational]:
    """Values of the parameters, those of the sketch."""
    values = {symbol: sp.Rational(str(value)) for symbol, value in profile.sketch.values}
    return {symbol: value for symbol, value in values.items() if symbol in profile.parameters}


def value(entry: Entry, known: Mapping[sp.Symbol, sp.Expr]) -> sp.Float:
    """The exact result at these values, to 30 digits."""
    expr = _plain(_case(entry, known).expr)
    return number(expr.rhs if isinstance(expr, sp.Eq) else expr, known)


def number(expr: sp.Expr, known: Mapping[sp.Symbol, sp.Expr]) -> sp.Float:
    """The value by mpmath at 30 digits; a definite integral by mpmath's quadrature."""
    with mp.workdps(30):
        for integral in expr.atoms(sp.Integral):
            # the variable of an integral may be a field elsewhere
            at = {symbol: value for symbol, value in known.items() if symbol != integral.limits[0][0]}
            variable, lower, upper = integral.subs(at).limits[0]
            integrand = sp.lambdify(variable, integral.subs(at).function, NUMERIC)
            ends = [mp.mpf(str(sp.N(end, 30))) for end in (lower, upper)]
            expr = expr.subs(integral, sp.Float(str(mp.re(mp.quad(integrand, ends, maxdegree=6))), 30))
        return sp.Float(str(mp.re(function(expr, known)())), 30)


def function(expr: sp.Expr, known: Mapping[sp.Symbol, sp.Expr], *unknown: sp.Symbol) -> Callable[..., Any]:
    """The expression as a function of what is unknown, over mpmath's numbers of the digits it works with.

    Numbers put into the expression by SymPy would take ten times as long.
    """
    symbols = sorted(expr.free_symbols - {*unknown}, key=str)
    values = [mp.mpf(str(sp.N(known[symbol], 40))) for symbol in symbols]
    evaluate = sp.lambdify((*unknown, *symbols), expr, NUMERIC)
    return lambda *given: evaluate(*given, *values)


def shape_value(profile: Profile, known: Mapping[sp.Symbol, sp.Expr], place: sp.Symbol = nt.r) -> sp.Float:
    """The height of the profile at a place."""
    below = (p for p in profile.pieces if p.upper is None or known[place] < sp.N(p.upper.subs(known), 30))
    return number(_plain(next(below).expr), known)


def _plain(expr: sp.Expr) -> sp.Expr:
    """A sum over powers written out for the three coefficients of the example."""
    own = {nt.coefficients[j]: c for j, c in enumerate(POLYNOMIAL, 1)}
    sums = {total: total.subs(nt.N, len(POLYNOMIAL)).doit().subs(own) for total in expr.atoms(sp.Sum)}
    return expr.xreplace(sums)


def _case(entry: Entry, known: Mapping[sp.Symbol, sp.Expr]) -> Case:
    for case in entry.cases:
        lengths = [sp.N(known.get(x, x) if x.is_Atom else x.subs(known), 30) for x in map(sp.sympify, case.chain)]
        if all(x < y for x, y in zip(lengths, lengths[1:], strict=False) if x.is_number and y.is_number):
            return case
    message = f"{entry.key}: no case applies at {known}"
    raise ValueError(message)


def _holds(entry: Entry, place: sp.Symbol) -> bool:
    return any(case.expr.has(place) for case in entry.cases)


def rounded(number: sp.Float) -> sp.Rational:
    """The number to four significant digits, as an exact rational."""
    return sp.Rational(str(sp.Float(str(number), 4)))


def literal(number: sp.Expr) -> str:
    """The number as a Python float in text."""
    return repr(float(number))


def doctest(package: str, module: str, call: str, number: sp.Float, member: str = "", name: str = "value") -> list[str]:
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
        terms = {nt.N: sp.Integer(len(POLYNOMIAL)), **{coefficient(i): c for i, c in enumerate(POLYNOMIAL, 1)}}
        here = HalfSpace(self.profile, self.known | terms, 2 * SHOWN, graded=False)
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
        height = shape_value(self.profile, self.known, place)
        return self._shown(f"{COMPACT['f'].function}({', '.join(passed)})", height)

    def state(self, suffix: str = "") -> list[str]:
        """The doctest of the state of pull-off: its force by that entry, else the least value of F(a)."""
        entry = self.entries[suffix or "F"]
        passed = ", ".join(self.keyword(symbol, self.known) for symbol in entry.parameters)
        force = self.number(entry, self.known) if suffix else self.least_force()
        return self._shown(f"pull_off({passed})", force, "force", "state")

    def _shown(self, call: str, number: sp.Float, member: str = "", name: str = "value") -> list[str]:
        return doctest(self.system.package, self.profile.name, call, number, member, name)

    def keyword(self, symbol: sp.Symbol | sp.IndexedBase, at: Values) -> str:
        """A keyword argument with its value as Python code, a polynomial as the tuple A."""
        if symbol == nt.coefficients:
            return f"A=({', '.join(literal(c) for c in POLYNOMIAL)})"
        return f"{name_of(symbol)}={literal(at[symbol])}"

    def number(self, entry: Entry, at: Values) -> sp.Float:
        """The exact value; what an equation defines is its root near the drawn state."""
        symbol = entry.quantity.symbol
        if entry.status in ("equation", "expansion"):
            with mp.workdps(SHOWN + DIGITS):
                own = self.pulled if nt.dgamma in entry.parameters else self.layered
                return sp.Float(str(own.stated(entry)), DIGITS)
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
        if entry.status == "root" and isinstance(_case(entry, at).expr, sp.Eq):
            if symbol in (nt.a, nt.c, *places):
                return self.root(entry, symbol, at)
            at = at | {nt.a: self.root(self.elastic["ad"], nt.a, at)}
        elif self.system.physics.laws and in_radius(entry):
            at = at | {nt.a: self.reached(entry, at)}
        return value(entry, at)

    def reached(self, entry: Entry, at: Values) -> sp.Float:
        """The contact radius on a ramp, or on the way back from it."""
        back, law = nt.t_m in entry.parameters, entry.suffix.split("_")[1]
        until = self.number(self.entries[f"earlier_{law}"], at) if back else at[nt.time]
        radius, given = self.elastic["ad"], at | {nt.d: at[nt.v] * until}
        return self.root(radius, nt.a, given) if radius.status == "root" else value(radius, given)

    def defined(self, entry: Entry, at: Values) -> sp.Float:
        """A pressure or displacement on a graded half-space without closed form, by quadrature."""
        here, physics = HalfSpace(self.profile, at, DIGITS, graded=True), self.system.physics
        with mp.workdps(2 * DIGITS):
            a = mp.mpf(str(sp.N(at[nt.a], 2 * DIGITS)))
            if physics.definitions:
                found = here.defined(physics.definitions(self.profile, here.medium)[entry.suffix])
            else:
                found = (here.adhesive if physics.tension else here.normal)(entry.suffix, a)
            return sp.Float(str(mp.re(found)), 2 * DIGITS)

    @property
    def floor(self) -> sp.Expr:
        """The radius at which the contact begins."""
        return self.known[self.profile.breaks[0]] if self.profile.truncated else sp.S.Zero

    def root(self, entry: Entry, unknown: sp.Symbol, at: Values) -> sp.Float:
        """The unknown that solves the equation of an entry, to 30 digits; searched from its drawn value."""
        equations = _Numeric(entry, unknown, at, lambda expr: expr.lhs - expr.rhs)
        with mp.workdps(30):
            start, low = (mp.mpf(str(sp.N(x, 30))) for x in (self.known[unknown], self.floor))
            if unknown == nt.a:  # at no step below a flat face
                first = mp.log(start - low)
                found = low + mp.exp(_secant(lambda above: equations(low + mp.exp(above)), first, first + STEP))
            else:
                found = _secant(equations, start, start * (1 + STEP))
            return sp.Float(str(found), 30)

    def least_force(self) -> sp.Float:
        """The least of F(a)."""
        return self._least(self.entries["F"], lambda expr: expr)

    def _least(self, entry: Entry, form: Callable[[Any], Any]) -> sp.Float:
        """The least value up to the drawn radius, to 30 digits: on a grid, then next to its lowest point."""
        curve = _Numeric(entry, nt.a, self.known, form)
        with mp.workdps(30):
            low = mp.mpf(str(sp.N(self.floor, 30)))
            reach = mp.mpf(str(sp.N(self.known[nt.a], 30))) - low
            # a break itself belongs to no case
            grid = [low + reach * mp.mpf("1e-20"), *(low + reach * i / PLACES for i in range(1, PLACES + 1))]
            values = [curve(x) for x in grid]
            best = min(range(len(grid)), key=lambda i: values[i])
            below, above = grid[max(best - 1, 0)], grid[min(best + 1, len(grid) - 1)]
            return sp.Float(str(min(values[best], least(curve, below, above))), 30)

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


class _Numeric:
    """The cases of an entry as functions of one unknown."""

    def __init__(self, entry: Entry, unknown: sp.Symbol, at: Values, form: Callable[[sp.Expr], sp.Expr]) -> None:
        self.entry, self.unknown, self.at, self.form = entry, unknown, at, form
        self.compiled: dict[Case, Callable[[Any], Any]] = {}

    def __call__(self, x: Any) -> Any:
        known = {**self.at, self.unknown: sp.Float(str(x), 30)}
        case = _case(self.entry, known)
        if case not in self.compiled:
            expr = _plain(self.form(case.expr))
            self.compiled[case] = function(expr, self.at, self.unknown)
        return mp.re(self.compiled[case](x))
