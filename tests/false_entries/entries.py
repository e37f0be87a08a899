"""True entries, how one is changed, and what false ones are made of."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp
from test_mutations import power_of_face

from axiderive import notation as nt
from axiderive.entry import Case, Entry
from axiderive.physics import systems
from axiderive.store.records import entry_record, profile_record
from axiderive.verifier import rests_on

Entries = dict[str, Entry]
Change = Callable[[sp.Expr], sp.Expr]


@dataclass(frozen=True)
class FalseEntry:
    """One false entry in its place among the true ones of its problem."""

    family: str
    problem: str
    suffix: str
    entries: Entries
    told: str = ""
    """How it can be told from the true entry."""

    @property
    def false(self) -> Entry:
        return self.entries[self.suffix]

    @property
    def true(self) -> Entry:
        return derived(self.problem)[self.suffix]

    @property
    def physics(self) -> str:
        """The system, and for round contacts whether the edge of the contact is free."""
        system = systems.problem(self.problem).system.name
        kind = self.true.profile.contact
        return f"{system}, {kind}" if kind in ("compact", "complete") else system

    def text(self) -> str:
        return f"{self.family}: {self.false.text()}"


@functools.cache
def derived(problem: str) -> Entries:
    return systems.problem(problem).derive()


@functools.cache
def _encoded(problem: str) -> dict[str, Any]:
    return {suffix: entry_record(entry) for suffix, entry in derived(problem).items()}


def record(problem: str, entries: Entries) -> dict[str, Any]:
    """The problem as the evidence stores it, with these entries."""
    true, known = derived(problem), _encoded(problem)
    stored = {s: known[s] if entry is true.get(s) else entry_record(entry) for s, entry in entries.items()}
    return {"problem": problem, "profile": profile_record(systems.problem(problem).profile), "entries": stored}


@functools.cache
def below(problem: str) -> dict[str, Any] | None:
    """The normal contact that it rests on, as it is stored."""
    plain = rests_on(problem)
    return record(plain, derived(plain)) if plain else None


# how an entry is changed


def with_formula(entry: Entry, index: int, expr: sp.Expr) -> Entry:
    """Another formula in one case; where the edge is reached, the formula for a fixed face follows suit."""
    case = entry.cases[index]
    changed = replace(entry, cases=(*entry.cases[:index], replace(case, expr=expr), *entry.cases[index + 1 :]))
    return changed if before_the_edge(case) else _with_face(changed, expr)


def _with_face(entry: Entry, expr: sp.Expr) -> Entry:
    if not entry.fixed_face or isinstance(expr, sp.Equality):
        return entry
    fixed = expr.subs(nt.h, nt.C * nt.a ** power_of_face(entry))
    return replace(entry, fixed_face=tuple(replace(face, expr=fixed) for face in entry.fixed_face))


def before_the_edge(case: Case) -> bool:
    """Whether the current radius, or the force, is below its value at the edge."""
    inner = [member for member in case.chain if member not in (nt.r, nt.a)]
    if not inner or not (case.chain[0] == nt.F or inner[0].has(nt.d)):
        return False
    return case.chain[0] == nt.F if nt.F in case.chain else nt.a in case.chain and case.below(inner[0], nt.a)


def changed(entry: Entry, change: Change) -> Entry:
    """The same change in every case; of an equation only the side that is not a bare symbol changes."""
    for index, case in enumerate(entry.cases):
        entry = with_formula(entry, index, changed_formula(case.expr, change))
    return entry


def changed_formula(expr: sp.Expr, change: Change) -> sp.Expr:
    if not isinstance(expr, sp.Equality):
        return change(expr)
    if expr.lhs.is_Symbol:
        return sp.Eq(expr.lhs, change(expr.rhs), evaluate=False)
    return sp.Eq(change(expr.lhs), expr.rhs, evaluate=False)


def with_chain(entry: Entry, index: int, chain: tuple[sp.Expr, ...], *, face: bool = True) -> Entry:
    cases = (*entry.cases[:index], replace(entry.cases[index], chain=chain), *entry.cases[index + 1 :])
    faces = entry.fixed_face
    if face and len(entry.cases) == 1:
        faces = tuple(replace(fixed, chain=chain) for fixed in faces)
    return replace(entry, cases=cases, fixed_face=faces)


def with_case(entry: Entry, place: int, case: Case) -> Entry:
    return replace(entry, cases=(*entry.cases[:place], case, *entry.cases[place:]))


def renamed(entry: Entry, names: Mapping[sp.Symbol, sp.Expr]) -> Entry:
    cases = tuple(replace(case, expr=case.expr.xreplace(dict(names))) for case in entry.cases)
    faces = tuple(replace(face, expr=face.expr.xreplace(dict(names))) for face in entry.fixed_face)
    return replace(entry, cases=cases, fixed_face=faces)


# functions that are zero on one side only

U = sp.Symbol("u", positive=True)
JUMPS: tuple[sp.Expr, ...] = (
    sp.atan(U - 1) + sp.atan(1 / (U - 1)) + sp.pi / 2,
    sp.atan(sp.tan(U)) - U,
    sp.atan(2 * U / (1 - U**2)) - 2 * sp.atan(U),
    sp.sqrt(U**2 - 2 * U + 1) - (U - 1),
    sp.Heaviside(U - 1),
    sp.asin(2 * U / (1 + U**2)) - 2 * sp.atan(U),
    sp.floor(U),
    sp.Abs(U - 1) + U - 1,
    sp.atan2(U, 1 - U) - sp.atan(U / (1 - U)),
    sp.Piecewise((0, U < 1), (1, True)),
    sp.Max(U, 1) - 1,
    sp.acos(sp.cos(2 * U)) - 2 * U,
    (U - 1) / sp.sqrt(U**2 - 2 * U + 1) + 1,
    sp.sign(U - 1) + 1,
    sp.asin(U) + sp.acos(U) - sp.pi / 2,
    sp.atanh(U - 1) - sp.log(U / (2 - U)) / 2,
    sp.log((U - 1) ** 2) - 2 * sp.log(1 - U),
    sp.acosh(U) - sp.log(U + sp.sqrt(U**2 - 1)),
    sp.asin(sp.sin(2 * U)) - 2 * U,
    sp.ceiling(U) - 1,
    sp.Mod(U, 1) - U,
    sp.Min(U, 1) - U,
    sp.acosh(sp.cosh(U - 1)) - (U - 1),
    sp.LambertW(-U * sp.exp(-U)) + U,
    (U**2 - 1) / ((U - 1) * (U + 1)) - 1,
)
"""Zero for some u > 0, and for others not zero, not real or not defined; most have the derivative 0."""
LENGTHS = (
    nt.a, nt.R, nt.b, nt.r, nt.x, nt.d, nt.c, nt.L, nt.h, nt.a_c, nt.s, nt.R1, nt.wavelength, nt.e, nt.c_0,
)  # fmt: skip
NUMBERS = {nt.theta: nt.theta, nt.n: nt.n / 2, nt.k: nt.k + 1, nt.alpha: 2 * nt.alpha, nt.mu: nt.mu}
PAIRS = (
    (nt.time, nt.relaxation), (nt.time, nt.t_0), (nt.E * nt.time, nt.eta), (nt.F_x, nt.mu * nt.F), (nt.E_1, nt.E_inf),
    (nt.E_star, nt.G_star), (nt.H, nt.H_x), (nt.young_1, nt.young_2), (nt.F, nt.E_star * nt.R**2),
    (nt.d, nt.v * nt.time), (nt.P, nt.E_star * nt.R), (nt.F, nt.E_star * nt.a * nt.h), (nt.F, nt.E_star * nt.b**2),
    (nt.dgamma, nt.E_star * nt.R),
)  # fmt: skip
SUMMED = (nt.j, nt.N, nt.coefficients.label)
"""What is no number by itself: index, degree and coefficients of a polynomial profile."""


def known(entry: Entry) -> set[sp.Symbol]:
    """What a formula of the entry may name: arguments, parameters, abbreviations, and what the true one names."""
    names = {*entry.quantity.arguments, *entry.parameters, *(symbol for symbol, _ in entry.profile.abbreviations)}
    own: set[sp.Symbol] = set().union(*(case.expr.free_symbols | _named(case.chain) for case in entry.cases))
    return {name for name in names | own if name.is_Symbol and name not in SUMMED}


def _named(chain: tuple[sp.Expr, ...]) -> set[sp.Symbol]:
    return set().union(*(sp.sympify(member).free_symbols for member in chain)) if chain else set()


def ratios(entry: Entry) -> list[sp.Expr]:
    """Numbers about 1 made of what the entry may name."""
    names = known(entry)
    lengths = [symbol for symbol in LENGTHS if symbol in names]
    found = [2 * one / other for i, one in enumerate(lengths) for other in lengths[i + 1 :]]
    found += [one / other for one, other in PAIRS if one.free_symbols | other.free_symbols <= names]
    found += [number for symbol, number in NUMBERS.items() if symbol in names]
    return found or sorted(names, key=str)


def times(expr: sp.Expr) -> Change:
    return lambda true: true * expr


EQUATIONS = ("ac", "am", "rz", "rp", "xz", "aP")


def stated(entry: Entry) -> bool:
    """What a prover says something about: closed formulas, and equations that are shown to have the right root."""
    return entry.status == "closed" or entry.suffix in EQUATIONS or entry.suffix.startswith("step_")


Found = Iterator[tuple[str, str, Entry]]
"""Family, suffix and false entry; every family takes the key of a problem."""


# the families

COMPACT = ("cone", "paraboloid", "power_law", "sphere", "truncated_cone", "rounded_cone")
FREE = ("flat_punch", "capped_cylinder", "concave_power", "concave_paraboloid", "concave_quartic")
PLANE = tuple(
    f"plane.{name}"
    for name in (
        "wedge", "parabola", "truncated_wedge", "rounded_punch", "flat_punch", "concave_power", "concave_parabola",
        "concave_quartic",
    )
)  # fmt: skip
ECCENTRIC = "plane.eccentric_punch"
LOADS = tuple(f"loads.{name}" for name in ("uniform", "hertzian", "punch", "power"))
PROBLEMS = (
    *COMPACT,
    *FREE,
    *("paraboloid.fgm", "power_law.fgm", "sphere.fgm", "truncated_cone.fgm"),
    *("flat_punch.fgm", "capped_cylinder.fgm", "concave_power.fgm", "concave_paraboloid.fgm"),
    *("cone.adh", "paraboloid.adh", "power_law.adh", "truncated_cone.adh"),
    *("flat_punch.adh", "concave_paraboloid.adh", "flat_punch.fgm.adh", "concave_quartic.fgm.adh"),
    *("cone.fgm.adh", "paraboloid.fgm.adh"),
    *("paraboloid.tan", "power_law.tan", "truncated_paraboloid.tan", "rounded_punch.tan"),
    *("paraboloid.fgm.tan", "truncated_cone.fgm.tan"),
    *("polynomial", "polynomial.adh", "polynomial.tan"),
    *("quartic", "rounded_punch", "power_law"),
    *("cone.sub", "concave_paraboloid.sub"),
    *("cone.vis", "sphere.vis", "flat_punch.vis", "capped_cylinder.vis"),
    *PLANE,
    ECCENTRIC,
    *LOADS,
    "materials",
)
