"""What the modules of all graded packages share: signatures, checks, documents and examples.

A doctest has one number, computed from the exact entry or, without closed form, its definition.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache, cached_property

import mpmath as mp
import sympy as sp

from ... import notation as nt
from ...entry import COMPACT, Entry
from ...letters import name_of
from ...notation import coefficients
from ...oracle.half_space import HalfSpace
from ...physics.systems import System, of
from ...profiles.profile import Profile
from .. import docstring, example
from ..imports import RUNTIME
from ..layout import fit
from ..physics import examples, text
from ..physics.examples import Values
from ..physics.text import Function, evaluate, private
from ..text import python

MATERIAL: Values = {nt.H: sp.S.One, nt.k: sp.Rational(1, 4), nt.H_x: sp.Rational(4, 5)}
DIGITS = 15


class Example(examples.Example):
    """The doctests of one module, on a half-space with k = 1/4; `elastic` are the entries of its normal contact."""

    def __init__(
        self, profile: Profile, entries: Mapping[str, Entry], system: System, elastic: Mapping[str, Entry]
    ) -> None:
        super().__init__(profile, entries, system.name, elastic)
        self.physics = system.physics

    @cached_property
    def known(self) -> Values:
        """Parameters and the middle of the contact, as for the homogeneous half-space."""
        drawn = examples.Example(self.profile, self.entries, self.group).known
        return drawn | MATERIAL | {nt.d: self.loads[nt.d]}

    def lines(self, suffix: str) -> list[str]:
        """The doctest of the function behind one entry."""
        entry, at = self.entries[suffix], dict(self.known)
        if entry.quantity.symbol == nt.w:
            at[nt.r] = 2 * at[nt.a]
        if entry.quantity.inverts:
            field = entry.quantity.arguments[0]
            at[field] = _rounded(self.number(self.entries[entry.quantity.inverts], at))
        passed = [example.literal(at[symbol]) for symbol in entry.quantity.arguments]
        passed += [self.keyword(symbol, at) for symbol in entry.parameters]
        first, *others = fit(f"value = {self.profile.name}.{entry.quantity.function}({', '.join(passed)})", 12)
        typed = [f">>> {first}", *(f"... {other}" for other in others)]
        return [*self.head(), *typed, ">>> round(value, 6)", example.result(self.number(entry, at))]

    def number(self, entry: Entry, at: Values) -> sp.Float:
        """The exact value; what an equation defines is its root near the drawn state."""
        if entry.status == "integral":
            return self.defined(entry, at)
        if entry.status == "root" and entry.composed:
            outer, inner = entry.composed
            return self.number(self.entries[outer], at | {nt.a: self.number(self.entries[inner], at)})
        if entry.suffix == "rz" and isinstance(example._case(entry, at | {nt.r_zero: at[nt.r]}).expr, sp.Eq):
            return example._root(self.profile, entry, at)
        ring = self.entries.get("rz")
        if entry.quantity.threshold and ring is not None and entry is not ring:
            at = at | {nt.r_zero: self.number(ring, at)}
        return super().number(entry, at)

    def defined(self, entry: Entry, at: Values) -> sp.Float:
        """A pressure or displacement without closed form, by quadrature."""
        half_space = HalfSpace(self.profile, at, DIGITS, graded=True)
        rules = {"normal": half_space.normal, "adhesive": half_space.adhesive, "tangential": half_space.tangential}
        with mp.workdps(2 * DIGITS):
            a = mp.mpf(str(sp.N(at[nt.a], 2 * DIGITS)))
            return sp.Float(str(mp.re(rules[self.physics.name](entry.suffix, a))), 2 * DIGITS)


def _rounded(number: sp.Float) -> sp.Rational:
    return sp.Rational(str(sp.Float(str(number), 4)))


UP = "..."
"""From a module of a graded package to the root."""
SHARED = (
    "physics.adhesion: PullOff, power_law_radius, require_control",
    "physics.branches: Branches, Samples, branches, decades, exponent_of, lowest, radii_around, radii_below",
    "physics.branches: radii_beyond, radii_of_waves, radii_to",
    "interface: Array, Kept, Result, elementwise, numbers, require, require_coefficients, require_order, require_reach",
    "functions: sine_root",
    "integrals: difference_root",
    "shapes.ring: lifted_at_zero_pressure, ring_of_zero_pressure",
    "physics.slip: stick_force",
)
LATE = (
    "physics.stable: stable_radius",
    "physics.unknowns: beyond_edge, on_the_bump, radius_itself, up_to",
)
"""Imported by the functions that call them, as are those of the files LATE_FILES: an import of a module brings along
what its depth and its force need."""
LATE_FILES = ("branches", "displacement", "inverse", "pressure", "slip")

HOMOGENEOUS = f"from ...normal import {text.NORMAL} as normal"
"""The module without grading, of which a normal contact needs the shape of the indenter alone."""


@dataclass
class Writer:
    """The functions of one module, public and private."""

    profile: Profile
    entries: Mapping[str, Entry]
    plain: Mapping[str, Entry]
    public: list[Function] = field(default_factory=list)
    private: list[str] = field(default_factory=list)

    @cached_property
    def system(self) -> System:
        """The system of its entries."""
        return of(next(iter(self.entries.values())))

    @property
    def geometry(self) -> list[str]:
        """Names of the parameters of the profile, as the interface has them."""
        return [name_of(symbol) for symbol in self.profile.parameters]

    @property
    def summed(self) -> bool:
        """Whether the profile is a polynomial, whose coefficients are passed as one tuple A."""
        return coefficients in self.profile.parameters

    @property
    def own_check(self) -> str:
        """Name under which the module calls the check of the rules between parameters."""
        return "normal._check" if self.system.base else "_check"

    @cached_property
    def example(self) -> Example:
        """The doctests of this module."""
        return Example(self.profile, self.entries, self.system, self.plain)

    def checks(self, symbols: Sequence[sp.Symbol], reach: bool = False) -> list[str]:
        """The lines that check the parameters, those of the geometry with the rules between them."""
        lines = ["A = require_coefficients(A)"] if coefficients in symbols else []
        plain = [name_of(symbol) for symbol in symbols if symbol != coefficients]
        if plain:
            ruled = bool(self.profile.rules) and set(self.profile.parameters) <= set(symbols)
            named = ", ".join(f"{name}={name}" for name in plain)
            lines.append(f"{self.own_check if ruled else 'require'}({named})")
        if reach:
            lines.append(f'require_reach(a, {self.profile.breaks[0]}, "graded.normal.flat_punch")')
        return lines

    def add(self, entry: Entry, notes: str, body: Sequence[str]) -> None:
        """A public function that one entry backs."""
        fields = [str(argument) for argument in entry.quantity.arguments]
        names = [name_of(symbol) for symbol in entry.parameters]
        document = text.document(entry, fields, names, notes)
        shown = ["", "Examples", "--------", *self.example.lines(entry.suffix)]
        quantity, doc = entry.quantity, [*document, *shown]
        self.public.append(Function(quantity.function, fields, names, quantity.summary, doc, list(body)))

    def profile_function(self) -> None:
        """The shape of the indenter, which no medium changes."""
        own, quantity = self.profile, COMPACT["f"]
        place = {nt.r: self.example.known[nt.a] * sp.Rational(3, 10)}
        passed = [example.literal(place[nt.r]), *(self.example.keyword(s, self.example.known) for s in own.parameters)]
        number = example.shape_value(own, self.example.known | place)
        shown = [*self.example.head(), f">>> value = {own.name}.profile({', '.join(passed)})", ">>> round(value, 6)"]
        notes = [f"Valid for {own.validity}. Negative or NaN field values give NaN."]
        doc = docstring.docstring(own, quantity, None, notes, [*shown, example.result(number)])
        body = [HOMOGENEOUS, "", f"return normal.profile(r, {', '.join(f'{name}={name}' for name in self.geometry)})"]
        self.public.append(Function("profile", ["r"], self.geometry, COMPACT["f"].summary, doc, body))

    def shape_of(self, place: str) -> str:
        """The call of f(r) in the module of the homogeneous half-space."""
        used: set[str] = set()
        for piece in self.profile.pieces:
            for expr in (piece.expr, piece.upper or sp.S.Zero):
                used |= {name_of(symbol) for symbol in expr.free_symbols if symbol not in (nt.r, nt.j, nt.N)}
        for symbol, expr in self.profile.abbreviations:
            if str(symbol) in used:
                used = used - {str(symbol)} | {str(s) for s in expr.free_symbols}
        if self.profile.complete:
            used.add("a")
        return f"normal._profile({', '.join([place, *(f'{n}={n}' for n in self.geometry if n in used)])})"

    def rule(
        self,
        name: str,
        fields: Sequence[str],
        needs: Sequence[str],
        lines: Sequence[str],
        doc: str = "",
        returns: str = "Array",
    ) -> None:
        """A private function; lengths that are no parameters are defined first."""
        body = "\n".join(lines)
        own = [
            f"{symbol} = {python(expr)}"
            for symbol, expr in self.profile.abbreviations
            if re.search(rf"\b{symbol}\b", body)
        ]
        late = text.imported([*LATE, *imports(late=True)], body, UP)
        late += [HOMOGENEOUS] if self.system.base is None and "normal." in body else []
        source = private(name, fields, needs, [*late, *([""] if late else []), *own, *lines], doc, returns)
        if self.summed:
            head, body = source.replace(" A: Array", " A: tuple[float, ...]").split("\n", 1)
            source = "\n".join([*fit(head, 0), body])
        self.private.append(source)

    def evaluated(
        self, function: str, fields: Sequence[str], names: Sequence[str], apart: Sequence[str] = (), **signed: str
    ) -> str:
        """The code of a call of `elementwise`; names `apart` have a say in the shape alone, `signed` go by keyword."""
        apart = [name for name in apart if not (self.summed and name == "A")]
        return evaluate(function, fields, names, self.summed and "A" in names, apart, **signed)

    def source(self, title: str) -> str:
        """The text of the module: header, the imports its code needs, public and private functions."""
        body = text.module(title, self.profile.subtitle, [*SHARED, *imports()], self.public, self.private, UP)
        if self.system.base is None:
            body = body.replace(f"from ..normal import {text.NORMAL} as normal\n", "", 1)
        return body.replace(text.NORMAL, self.profile.name)


@cache
def imports(late: bool = False) -> tuple[str, ...]:
    """The public functions of the runtime by module, of those that are imported `late` or with a module."""
    paths = sorted(path for path in (RUNTIME / "graded").glob("[a-z]*.py") if (path.stem in LATE_FILES) == late)
    found = {path.stem: re.findall(r"^def ([a-z]\w+)\(", path.read_text(), re.M) for path in paths}
    return tuple(f"graded.{stem}: {', '.join(names)}" for stem, names in found.items())
