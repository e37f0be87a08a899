"""Entries that are false, made of true ones: formulas, regions and definitions that nobody may certify.

Each differs from the true entry in what a reader of the handbook or a caller
of the module would get: another value at a point of its region, a formula that
is not real there, an unknown symbol, another region, or another definition.
`difference` says which.  Nothing here is drawn: the corpus is the same in every
run, and only its mutations use a generator, seeded by the names they belong to.
"""

from __future__ import annotations

import functools
import random
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any
from zlib import crc32

import mpmath as mp
import sympy as sp
from test_mutations import flipped_sign, power_of_face, swapped_symbols, wrong_exponent, wrong_factor

from axiderive import notation as nt
from axiderive.abel.masters import StruveL
from axiderive.entry import Case, Entry, Primitive
from axiderive.oracle.evaluate import evaluated
from axiderive.oracle.shape import coefficient, concrete
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
    return changed if _before_the_edge(case) else _with_face(changed, expr)


def _with_face(entry: Entry, expr: sp.Expr) -> Entry:
    if not entry.fixed_face or isinstance(expr, sp.Equality):
        return entry
    fixed = expr.subs(nt.h, nt.C * nt.a ** power_of_face(entry))
    return replace(entry, fixed_face=tuple(replace(face, expr=fixed) for face in entry.fixed_face))


def _before_the_edge(case: Case) -> bool:
    """Whether the current radius, or the force, is below its value at the edge."""
    inner = [member for member in case.chain if member not in (nt.r, nt.a)]
    if not inner or not (case.chain[0] == nt.F or inner[0].has(nt.d)):
        return False
    return case.chain[0] == nt.F if nt.F in case.chain else nt.a in case.chain and case.below(inner[0], nt.a)


def changed(entry: Entry, change: Change) -> Entry:
    """The same change in every case; of an equation only the side that is not a bare symbol changes."""
    for index, case in enumerate(entry.cases):
        entry = with_formula(entry, index, _changed(case.expr, change))
    return entry


def _changed(expr: sp.Expr, change: Change) -> sp.Expr:
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
EQUATIONS = ("ac", "am", "rz", "rp", "xz", "aP")


def stated(entry: Entry) -> bool:
    """What a prover says something about: closed formulas, and equations that are shown to have the right root."""
    return entry.status == "closed" or entry.suffix in EQUATIONS or entry.suffix.startswith("step_")


Found = Iterator[tuple[str, str, Entry]]
"""Family, suffix and false entry; every family takes the key of a problem."""


def piecewise_constant(key: str) -> Found:
    """A term that is zero on one side, in every formula of every problem; the derivative does not see it."""
    count = crc32(key.encode())
    for suffix, entry in derived(key).items():
        if not stated(entry):
            continue
        found = ratios(entry)
        for step in (0, 5):
            jump = JUMPS[(count + step) % len(JUMPS)].subs(U, found[count % len(found)])
            yield "piecewise constant", suffix, changed(entry, times(1 + jump))
        count += 1


def named_jumps(key: str) -> Found:
    """The same where every variable of a quantity has its turn."""
    first, turned, r, a, R, d = JUMPS[0], JUMPS[1], nt.r, nt.a, nt.R, nt.d
    for owner, suffix, u in (
        ("paraboloid", "k", a / R),
        ("paraboloid", "pm", a / R),
        ("paraboloid", "ad", d / R),
        ("paraboloid", "aF", nt.F / (nt.E_star * R**2)),
        ("paraboloid", "Fd", d / R),
        ("paraboloid", "dF", nt.F / (nt.E_star * R**2)),
        ("flat_punch", "p", d / a),
        ("flat_punch", "F", d / a),
        ("flat_punch", "w", d / a),
        ("flat_punch", "dF", nt.F / (nt.E_star * a**2)),
        ("concave_paraboloid", "dmin", nt.h / a),
        ("concave_paraboloid", "Fmin", nt.h / a),
        ("concave_paraboloid", "p", nt.h / a),
        ("paraboloid.tan", "tau", a / R),
        ("paraboloid.tan", "tau", 2 * r / a),
        ("paraboloid.tan", "c", 2 * nt.F_x * R / (nt.E_star * a**3 * nt.mu)),
        ("paraboloid.adh", "ac", nt.dgamma / (nt.E_star * R)),
        ("paraboloid.adh", "Fc", nt.dgamma / (nt.E_star * R)),
        ("paraboloid.adh", "aF", nt.dgamma / (nt.E_star * R)),
        ("cone.adh", "ad", nt.dgamma / (nt.E_star * d)),
        ("paraboloid.fgm", "pm", nt.k + sp.Rational(3, 2)),
        ("paraboloid.fgm.adh", "Fc", 2 * nt.a_c / R),
        ("paraboloid.fgm.tan", "tau", a / R),
        ("cone.vis", "step_mx", nt.time / nt.relaxation),
        ("cone.vis", "load_mx", nt.time / nt.relaxation),
        ("cone.vis", "ramp_mx", nt.time / nt.relaxation),
        ("plane.wedge", "aP", nt.theta),
        ("materials", "E_star", nt.young_1 / nt.young_2),
        ("materials", "G_star", nt.nu_1 + 1),
    ):
        if owner != key:
            continue
        entry = derived(key)[suffix]
        for jump in (first, turned):
            yield "piecewise constant", suffix, changed(entry, times(1 + jump.subs(U, 2 * u)))
    if key != "paraboloid":
        return
    force, radius = nt.E_star * first.subs(U, a / R), R * first.subs(U, d / R)
    yield "piecewise constant", "pm", changed(derived("paraboloid")["pm"], lambda e: e + force)
    yield "piecewise constant", "ad", changed(derived("paraboloid")["ad"], lambda e: e + radius)


CIRCULAR = {"ad": nt.a, "aF": nt.a, "aP": nt.a, "c": nt.c}


def circular_inverses(key: str) -> Found:
    """Inverses that name what they are asked for: the forward formula put in gives it back whatever they are."""
    for suffix, entry in derived(key).items():
        target = CIRCULAR.get(suffix)
        if target is not None:
            own = entry.cases[0].expr
            closed = [] if isinstance(own, sp.Equality) else [own]
            for expr in (target, *((e**2 / target) for e in closed), *((e + target) / 2 for e in closed)):
                cases = tuple(Case(case.chain, expr) for case in entry.cases)
                yield "circular inverse", suffix, replace(entry, status="closed", cases=cases)
            free = replace(entry, status="closed", cases=(Case((), target),))
            if len(entry.cases) > 1 or entry.cases[0].chain:
                yield "circular inverse", suffix, free
        elif suffix in ("Fd", "dF") and not entry.fixed_face:
            forward = derived(key)[{"Fd": "F", "dF": "d"}[suffix]]
            whole = replace(entry, status="closed", cases=forward.cases)
            yield "circular inverse", suffix, whole
            bare = tuple(Case((), case.expr) for case in forward.cases[:1])
            yield "circular inverse", suffix, replace(entry, status="closed", cases=bare)


def unused_cases(key: str) -> Found:
    """A wrong case beside the right ones: at the end, in front, in the middle, and on a region of its own."""
    for count, (suffix, entry) in enumerate(derived(key).items()):
        if not stated(entry):
            continue
        own = entry.cases[count % len(entry.cases)]
        wrong = _changed(own.expr, lambda true: 2 * true if true != 0 else nt.a / 2)
        names = [symbol for symbol in LENGTHS if symbol in known(entry) and symbol != nt.e]
        ordered = tuple(names[:2]) if len(names) > 1 else own.chain
        shapes = (
            (len(entry.cases), Case(own.chain, wrong)),
            (0, Case(own.chain, wrong)),
            (0, Case(ordered, wrong)),
            (len(entry.cases), Case(ordered[::-1], wrong)),
            (0, Case((), wrong)),
            (len(entry.cases) // 2, Case((), wrong)),
        )
        for place, case in (shapes[count % 6], shapes[(count + 3) % 6]):
            yield "unused case", suffix, with_case(entry, place, case)


def conditions(key: str) -> Found:
    """Conditions that are weaker, stronger, turned or about something else; and regions of complete contact."""
    for count, (suffix, entry) in enumerate(derived(key).items()):
        if not stated(entry):
            continue
        place = count % len(entry.cases)
        chain = entry.cases[place].chain
        family = "region" if entry.profile.contact == "complete" else "condition"
        names = [symbol for symbol in LENGTHS if symbol in known(entry) and symbol not in chain and symbol != nt.e]
        shapes = [chain[::-1]] if len(chain) > 1 else []
        shapes += [(*chain, symbol) for symbol in names[:1]] if chain else [tuple(names[:2])]
        shapes += [(symbol, *chain) for symbol in names[:1]] if chain else []
        shapes += [(), chain[1:], chain[:-1]] if len(chain) > 1 else []
        for shape in shapes:
            yield family, suffix, with_chain(entry, place, shape)
        if len(entry.cases) > 1:
            kept = (*entry.cases[:place], *entry.cases[place + 1 :])
            yield family, suffix, replace(entry, cases=kept)


def eccentric(key: str) -> Found:
    """Absolute values, maxima and signs that hold for e > 0, x > 0 only, and formulas of the substitutes of a proof."""
    if key != ECCENTRIC:
        return
    entries, a, e, x, P = derived(ECCENTRIC), nt.a, nt.e, nt.x, nt.P
    strip, lifted = (case.expr for case in entries["p"].cases)
    tilt, lifted_tilt = (case.expr for case in entries["phi"].cases)
    room = 3 * a + x * sp.sign(e) - 4 * sp.Abs(e)
    bare = P / (2 * sp.pi * sp.sqrt(a - x * sp.sign(e)) * (a - sp.Abs(e)))
    wrong: dict[str, list[tuple[int, sp.Expr]]] = {
        "cw": [
            (1, 4 * (a - e)),
            (1, 4 * (a + e)),
            (1, 4 * (a - sp.Max(0, e))),
            (1, 2 * nt.c),
            (1, sp.Abs(4 * (a - e))),
            (1, 4 * (a - sp.Abs(e)) * sp.sign(e)),
            (1, 2 * (a - sp.Abs(e)) * (1 + sp.sign(e))),
            (1, sp.Max(0, 4 * (a - e))),
            (1, 2 * a),
            (0, 2 * a * sp.sign(e)),
            (0, 4 * e * (a + nt.t) / a),
            (0, 4 * sp.Abs(e) * (a + nt.t) / a),
            (0, 2 * a + sp.Abs(e) - e),
            (0, 2 * a + sp.Abs(x) - x),
            (0, 4 * (a - sp.Abs(e))),
        ],
        "phi": [
            (0, sp.Abs(tilt)),
            (0, tilt * sp.sign(e)),
            (0, -tilt),
            (0, tilt * sp.sign(x)),
            (0, 2 * tilt),
            (1, lifted_tilt * sp.sign(e)),
            (1, P / (sp.pi * nt.E_star * (a - e))),
            (1, P / (sp.pi * nt.E_star * (a - sp.Abs(e)))),
            (1, P * sp.Abs(e) / (e * sp.pi * nt.E_star * (a - e))),
            (1, 2 * P * sp.sign(e) / (sp.pi * nt.E_star * nt.c)),
            (1, lifted_tilt * (1 + sp.sign(e)) / 2),
            (1, lifted_tilt * sp.sign(x) * sp.sign(e)),
        ],
        "p": [
            (0, P * (a**2 + 2 * sp.Abs(e * x)) / (sp.pi * a**2 * sp.sqrt(a**2 - x**2))),
            (0, P * (a**2 + 2 * sp.Abs(e) * sp.Abs(x)) / (sp.pi * a**2 * sp.sqrt(a**2 - x**2))),
            (0, P * sp.Max(0, a**2 + 2 * sp.Abs(e) * sp.Abs(x)) / (sp.pi * a**2 * sp.sqrt(a**2 - x**2))),
            (0, strip * (1 + sp.sign(e) ** 2) / 2 + P * (sp.sign(x) * sp.sign(e) - 1) / a),
            (0, P * (a**2 - 2 * e * x) / (sp.pi * a**2 * sp.sqrt(a**2 - x**2))),
            (0, strip * sp.sign(x) ** 2 * sp.sign(e) * sp.sign(x)),
            (1, bare * sp.sqrt(room)),
            (1, bare * sp.sqrt(sp.Abs(room))),
            (1, bare * sp.sqrt(sp.Max(0, 3 * a + sp.Abs(x) - 4 * sp.Abs(e)))),
            (1, lifted.subs(a - sp.Abs(e), nt.c / 2)),
            (1, P * sp.sqrt(sp.Max(0, room)) / (2 * sp.pi * sp.sqrt(a - x * sp.sign(e)) * (a - e))),
            (1, P * sp.sqrt(sp.Max(0, room)) / (2 * sp.pi * sp.sqrt(a - sp.Abs(x)) * (a - sp.Abs(e)))),
            (1, bare * sp.Max(0, sp.sqrt(room))),
            (1, lifted * sp.sign(x) * sp.sign(e)),
        ],
    }
    for suffix, changes in wrong.items():
        for place, expr in changes:
            yield "eccentric", suffix, with_formula(entries[suffix], place, expr)
    for suffix, entry in entries.items():
        one, other = entry.cases
        yield "eccentric", suffix, replace(entry, cases=(other, one))
        turned = (replace(one, expr=other.expr), replace(other, expr=one.expr))
        yield "eccentric", suffix, replace(entry, cases=turned)
        yield "eccentric", suffix, with_chain(entry, 0, (nt.e, nt.a / 2))
        yield "eccentric", suffix, with_chain(entry, 1, (nt.a / 2, nt.e))


def definitions(key: str) -> Found:
    """All of an entry that is no formula: its definition, parameters, quantity, profile, composition and status."""
    place = crc32(key.encode())
    entries = derived(key)
    names = list(entries)
    for count, (suffix, entry) in enumerate(entries.items()):
        if not stated(entry):
            continue
        other = entries[names[(count + 1) % len(names)]]
        doctored = [
            replace(entry, definition=_doctored(entry.definition)),
            replace(entry, parameters=entry.parameters[1:]),
            replace(entry, parameters=(*entry.parameters, nt.nu)),
            replace(entry, quantity=other.quantity),
            replace(entry, key=other.key),
            replace(entry, parameters=entry.parameters[::-1]),
            replace(entry, composed=("p", "w")),
            replace(entry, status="closed" if entry.status == "root" else "root"),
            replace(entry, definition=other.definition),
            replace(entry, quantity=replace(entry.quantity, arguments=entry.quantity.arguments[::-1] or (nt.r,))),
            replace(entry, quantity=replace(entry.quantity, symbol=nt.nu, label="Poisson ratio")),
        ]
        yield from (
            ("definition", suffix, wrong)
            for wrong in (doctored[(count + place) % len(doctored)], doctored[(count + place + 4) % len(doctored)])
            if wrong != entry
        )
        if entry.partial is not None:
            doubled = changed(entry.partial, times(2))
            yield "definition", suffix, replace(entry, partial=doubled)
            yield "definition", suffix, replace(entry, partial=None)
    for suffix, modulus in (("E_star", nt.E_star), ("G_star", nt.G_star), ("R", nt.R)) if key == "materials" else ():
        entry = derived("materials")[suffix]
        halved = sp.Eq(1 / modulus, 2 * entry.definition.rhs)
        yield "definition", suffix, replace(changed(entry, times(sp.S.Half)), definition=halved)
        renamed = sp.Eq(1 / nt.E, entry.definition.rhs)
        yield "definition", suffix, replace(entry, definition=renamed)


def _doctored(definition: sp.Expr) -> sp.Expr:
    if isinstance(definition, sp.Equality):
        return sp.Eq(definition.lhs, 2 * definition.rhs, evaluate=False)
    return 2 * definition


def foreign_symbols(key: str) -> Found:
    """A symbol of the same name without its sign, and symbols that only proofs know."""
    kappa, share, shifted = (sp.Symbol(name, positive=True) for name in ("kappa", "s_c", "sigma_1"))
    for count, (suffix, entry) in enumerate(derived(key).items()):
        if not stated(entry) or count % 3:
            continue
        names = sorted(set().union(*(case.expr.free_symbols for case in entry.cases)), key=str)
        if names:
            chosen = names[count % len(names)]
            yield "foreign symbol", suffix, _renamed(entry, {chosen: sp.Symbol(chosen.name)})
            yield "foreign symbol", suffix, _renamed(entry, {chosen: sp.Symbol(chosen.name, real=True)})
        if any(case.expr.has(nt.k) for case in entry.cases):
            yield "foreign symbol", suffix, _renamed(entry, {nt.k: kappa - 1})
    entries = derived(key)
    if key == "loads.power":
        yield "foreign symbol", "w", _renamed(entries["w"], {nt.sigma: shifted - 1})
    if key == "paraboloid.adh":
        yield "foreign symbol", "aF", changed(entries["aF"], lambda e: e + nt.a * (share - share**2))
    if key == "paraboloid.tan":
        yield "foreign symbol", "u", _renamed(entries["u"], {nt.mu: nt.alpha})
    if key == "paraboloid":
        yield "foreign symbol", "F", _renamed(entries["F"], {nt.E_star: nt.E})


def _renamed(entry: Entry, names: Mapping[sp.Symbol, sp.Expr]) -> Entry:
    cases = tuple(replace(case, expr=case.expr.xreplace(dict(names))) for case in entry.cases)
    faces = tuple(replace(face, expr=face.expr.xreplace(dict(names))) for face in entry.fixed_face)
    return replace(entry, cases=cases, fixed_face=faces)


MUTATIONS = (flipped_sign, wrong_factor, wrong_exponent, swapped_symbols)


def mutations(key: str) -> Found:
    """One sign, factor, exponent or symbol."""
    for count, (suffix, entry) in enumerate(derived(key).items()):
        if not stated(entry):
            continue
        rng = random.Random(f"{key} {suffix}")
        index = count % len(entry.cases)
        expr = entry.cases[index].expr
        for step in (0, 1):
            mutate = MUTATIONS[(count + step) % len(MUTATIONS)]
            new = _mutated(expr, functools.partial(mutate, rng=rng))
            if new is not None and new != expr:
                yield "corruption", suffix, with_formula(entry, index, new)


def media(key: str) -> Found:
    """The formula of the homogeneous half-space with the moduli of the graded one, and the reverse."""
    if ".fgm" not in key:
        return
    names = {nt.E_star: nt.H, nt.G_star: nt.H_x}
    for suffix, entry in derived(key).items():
        plain = derived(key.replace(".fgm", "")).get(suffix)
        if plain is None or not stated(entry) or [c.chain for c in plain.cases] != [c.chain for c in entry.cases]:
            continue
        yield "another medium", suffix, replace(_renamed(plain, names), **_frame(entry))
        limit = {nt.k: sp.S.Zero, nt.H: nt.E_star, nt.H_x: nt.G_star}
        yield "another medium", suffix, replace(_renamed(entry, limit), key=plain.key)
        yield "another medium", suffix, _renamed(entry, {nt.k: -nt.k})
        yield "another medium", suffix, _renamed(entry, {nt.k: nt.k / 2})


def _frame(entry: Entry) -> dict[str, Any]:
    """All of an entry but its formulas."""
    return {
        "key": entry.key,
        "quantity": entry.quantity,
        "definition": entry.definition,
        "parameters": entry.parameters,
        "primitives": entry.primitives,
    }


def _mutated(expr: sp.Expr, change: Callable[[sp.Expr], sp.Expr | None]) -> sp.Expr | None:
    if expr.is_number:
        return None
    if not isinstance(expr, sp.Equality):
        return change(expr)
    new = change(expr.rhs if expr.lhs.is_Symbol else expr.lhs)
    if new is None:
        return None
    return sp.Eq(expr.lhs, new, evaluate=False) if expr.lhs.is_Symbol else sp.Eq(new, expr.rhs, evaluate=False)


BRANCHES: tuple[tuple[type[sp.Function], Callable[[sp.Expr], sp.Expr]], ...] = (
    (sp.asin, lambda z: sp.pi - sp.asin(z)),
    (sp.asin, lambda z: -sp.acos(z)),
    (sp.asin, lambda z: sp.asin(z) + 2 * sp.pi),
    (sp.acos, lambda z: -sp.acos(z)),
    (sp.acos, lambda z: -sp.asin(z)),
    (sp.acos, lambda z: sp.acos(-z)),
    (sp.acosh, lambda z: -sp.acosh(z)),
    (sp.acosh, lambda z: sp.log(z - sp.sqrt(z**2 - 1))),
    (sp.atanh, lambda z: sp.atanh(1 / z)),
    (sp.atanh, lambda z: sp.acoth(z)),
    (sp.atanh, lambda z: sp.log((1 + z) / (z - 1)) / 2),
    (sp.acos, lambda z: sp.acos(z) - sp.pi),
    (sp.elliptic_f, lambda z, m: sp.elliptic_k(m) - sp.elliptic_f(z, m)),
    (sp.elliptic_k, lambda m: sp.elliptic_k(1 / m)),
    (sp.elliptic_e, lambda m: sp.elliptic_e(1 - m)),
)  # fmt: skip


def branches(key: str) -> Found:
    """Functions with the same derivative, or the other branch; roots of the wrong sign."""
    for suffix, entry in derived(key).items():
        if not stated(entry):
            continue
        for head, other in BRANCHES:
            if any(case.expr.has(head) for case in entry.cases):
                try:
                    wrong = changed(entry, lambda true, h=head, o=other: true.replace(h, o))
                except TypeError:  # incomplete and complete elliptic integrals differ in their arguments
                    continue
                yield "branch", suffix, wrong
    for owner, suffix, inside in (
        ("paraboloid", "p", nt.a**2 - nt.r**2),
        ("paraboloid", "w", nt.r**2 - nt.a**2),
        ("flat_punch", "p", nt.a**2 - nt.r**2),
        ("capped_cylinder", "p", nt.a**2 - nt.r**2),
        ("plane.parabola", "p", nt.a**2 - nt.x**2),
        ("plane.flat_punch", "s", nt.x**2 - nt.a**2),
        ("paraboloid.tan", "tau", nt.a**2 - nt.r**2),
        ("paraboloid.adh", "p", nt.a**2 - nt.r**2),
    ):
        if owner != key:
            continue
        entry = derived(key)[suffix]
        yield "branch", suffix, _renamed(entry, {sp.sqrt(inside): -sp.sqrt(inside)})
        turned = {inside: sp.expand(-inside)}
        yield "branch", suffix, _renamed(entry, turned)


def constants(key: str) -> Found:
    """Constants of the right dimension that no derivative sees."""
    if key not in (*COMPACT, "paraboloid.adh", "paraboloid.fgm", "flat_punch", "concave_paraboloid", *PLANE[:4]):
        return
    for suffix in ("d", "F", "p", "w", "P", "s", "k", "pm"):
        entry = derived(key).get(suffix)
        if entry is None or not stated(entry):
            continue
        scale = next((s for s in (nt.R, nt.b, nt.h) if s in entry.parameters), None)
        modulus = next((s for s in (nt.E_star, nt.H) if s in entry.parameters), sp.S.One)
        length = {"d": 1, "F": 2, "p": 0, "w": 1, "P": 1, "s": 0, "k": 1, "pm": 0}[suffix]
        unit = modulus * (scale**length if scale is not None else sp.S.One)
        yield "constant", suffix, changed(entry, lambda true, c=unit: true + c)
        if scale is not None:
            flat = unit * (JUMPS[0].subs(U, nt.a / scale))
            yield "constant", suffix, changed(entry, lambda true, c=flat: true + c)


def equations(key: str) -> Found:
    """Equations with other roots: sides changed, turned into a product, an inequality or another unknown."""
    for suffix, entry in derived(key).items():
        for index, case in enumerate(entry.cases):
            if not isinstance(case.expr, sp.Equality) or not stated(entry):
                continue
            lhs, rhs = case.expr.lhs, case.expr.rhs
            extra = 1 - nt.a / (2 * next(s for s in (nt.R, nt.b, nt.h, nt.a_c, nt.s) if s in known(entry) or s == nt.s))
            wrong = [
                sp.Eq(2 * lhs, rhs, evaluate=False),
                sp.Eq(lhs, rhs + lhs, evaluate=False),
                sp.Eq(lhs * extra, rhs * extra, evaluate=False),
                sp.Ne(lhs, rhs, evaluate=False),
                sp.Ge(lhs, rhs, evaluate=False),
                sp.Lt(lhs, rhs, evaluate=False),
                sp.Eq(rhs, rhs, evaluate=False),
                sp.Eq(lhs, lhs, evaluate=False),
            ]
            for expr in wrong:
                yield "equation", suffix, with_formula(entry, index, expr)


def doctored_primitives(key: str) -> Found:
    """Depths that are not the integral of the slope, with antiderivatives that add up to them."""
    if key not in ("cone", "paraboloid", "sphere", "truncated_cone", "rounded_cone", "paraboloid.fgm", "plane.wedge"):
        return
    suffix = "P" if key.startswith("plane") else "d"
    entry = derived(key)[suffix]
    for factor in (sp.Integer(2), 1 + JUMPS[0].subs(U, 2 * nt.a / (nt.R if nt.R in entry.parameters else nt.b))):
        found = {
            chain: tuple(replace(p, integrand=factor * p.integrand, expr=factor * p.expr) for p in own)
            for chain, own in entry.primitives.items()
        }
        yield "primitive", suffix, replace(changed(entry, times(factor)), primitives=found)
        only = {c: tuple(replace(p, expr=factor * p.expr) for p in own) for c, own in entry.primitives.items()}
        yield "primitive", suffix, replace(changed(entry, times(factor)), primitives=only)


def fixed_faces(key: str) -> Found:
    """Complete contact: the formula of the region doctored beside a true one for the fixed face, and the reverse."""
    if key not in ("flat_punch", "capped_cylinder", "concave_paraboloid", "concave_quartic", "flat_punch.fgm"):
        return
    for suffix, entry in derived(key).items():
        if not entry.fixed_face:
            continue
        jump = 1 + JUMPS[0].subs(U, 2 * nt.C) if key.startswith("concave") else 1 + JUMPS[0].subs(U, nt.E_star)
        after = [i for i, case in enumerate(entry.cases) if not _before_the_edge(case)]
        wrong = entry
        for i in after:
            wrong = with_formula(wrong, i, 2 * wrong.cases[i].expr)
        yield "fixed face", suffix, replace(wrong, fixed_face=entry.fixed_face)
        yield "fixed face", suffix, replace(wrong, fixed_face=())
        loose = sp.S.One + nt.h / nt.a if key.startswith("concave") else jump
        yield "fixed face", suffix, changed(entry, times(loose))


def rounded_numbers(key: str) -> Found:
    """A coefficient of one digit: SymPy subtracts an exact number from it at one digit, and finds nothing left."""
    for suffix, entry in derived(key).items():
        if stated(entry):
            yield "rounded number", suffix, changed(entry, _rounded)
            fractions = set().union(*(case.expr.atoms(sp.Rational) for case in entry.cases))
            one_digit = {q: sp.Float(q, 1) for q in fractions if not q.is_Integer}
            if one_digit:
                yield "rounded number", suffix, _renamed(entry, one_digit)
            yield "rounded number", suffix, _renamed(entry, {sp.pi: sp.Rational(22, 7)})


def _rounded(expr: sp.Expr) -> sp.Expr:
    coefficient, rest = expr.as_coeff_Mul()
    return sp.Float(coefficient, 1) * rest


S = sp.Symbol("s", positive=True)
ONE_SIDED = (
    sp.log(U - 1),
    1 / (U - 1),
    sp.sqrt(U - 1),
    sp.besseli(sp.S.Half, U - 1),
    StruveL(sp.S.Half, U - 1),
    (-2) ** U,
    sp.exp(sp.I * U),
)
"""Real for u > 1 alone, or for no u."""
POLE = sp.Subs(1 / S, S, 0)
ENDLESS = sp.Sum(S, (S, 1, sp.oo))


def cancelled_terms(key: str) -> Found:
    """Terms that cancel once they are multiplied out, real only on one side: what evaluates them finds no number."""
    for count, (suffix, entry) in enumerate(derived(key).items()):
        names = sorted(known(entry) - {nt.e, nt.N}, key=str)
        if not stated(entry) or len(names) < 2:
            continue
        found = ratios(entry)
        one, other, u = names[0], names[1], found[count % len(found)]
        for part in (*(part.subs(U, u) for part in ONE_SIDED), POLE, ENDLESS):
            if any(isinstance(case.expr, sp.Equality) for case in entry.cases):
                yield "cancelled term", suffix, _both_sides(entry, part)
            else:
                nothing = (one + other) * part - one * part - other * part
                yield "cancelled term", suffix, changed(entry, lambda true, c=nothing: true + c)
                whole, spelled = (one + part) ** 2, one**2 + 2 * one * part + part**2
                yield "cancelled term", suffix, changed(entry, times(whole / spelled))


def _both_sides(entry: Entry, part: sp.Expr) -> Entry:
    cases = []
    for case in entry.cases:
        expr = case.expr
        if isinstance(expr, sp.Equality):
            expr = sp.Eq(expr.lhs + part, expr.rhs + part, evaluate=False)
        cases.append(replace(case, expr=expr))
    return replace(entry, cases=tuple(cases))


def idle_primitives(key: str) -> Found:
    """Antiderivatives over no interval: they prove nothing of the slope, but an increment of theirs is put in."""
    for suffix in ("d", "P"):
        entry = derived(key).get(suffix)
        if entry is None or not entry.primitives:
            continue
        unit = nt.E_star if suffix == "P" else sp.S.One
        for index, case in enumerate(entry.cases):
            own = entry.primitives.get(case.chain, ())
            ends = [sp.S.Zero, *case.chain[: case.chain.index(nt.a) + 1]]
            for lo, hi in ((ends[-1], ends[-2]), (ends[-1], ends[-1]), (ends[-2], ends[-1])):
                for expr in (unit * nt.x, unit * nt.a):
                    idle = Primitive(lo, hi, sp.S.Zero, expr)
                    shifted = case.expr + expr.subs(nt.x, hi) - expr.subs(nt.x, lo) + (nt.a if lo == hi else 0) * unit
                    wrong = with_formula(entry, index, shifted)
                    yield "primitive", suffix, replace(wrong, primitives={**entry.primitives, case.chain: (*own, idle)})


def exchanged_regions(key: str) -> Found:
    """Formulas and regions in the right order each, but not beside each other."""
    for suffix, entry in derived(key).items():
        if stated(entry) and len(entry.cases) > 1:
            chains = [case.chain for case in entry.cases]
            pairs = zip(entry.cases, (*chains[1:], chains[0]), strict=True)
            cases = tuple(Case(chain, case.expr) for case, chain in pairs)
            yield "exchanged regions", suffix, replace(entry, cases=cases)
            yield "exchanged regions", suffix, replace(entry, cases=cases[::-1])
            exprs = [case.expr for case in entry.cases][::-1]
            cases = tuple(replace(case, expr=expr) for case, expr in zip(entry.cases, exprs, strict=True))
            yield "exchanged regions", suffix, replace(entry, cases=cases)


def sums(key: str) -> Found:
    """Other limits, other coefficients, summands without a value at j = 1 or 2, and what is no multiple of the sum."""
    A, j, N = nt.coefficients, nt.j, nt.N
    for suffix, entry in derived(key).items():
        if not stated(entry) or not any(case.expr.has(sp.Sum) for case in entry.cases):
            continue
        nothing = sp.Sum(A[j] * (nt.mu**j * (j**2 - 1) / ((j - 1) * (j + 1)) - nt.mu**j), (j, 1, N)).xreplace(
            {nt.mu: nt.mu if nt.mu in known(entry) else next(s for s in LENGTHS if s in known(entry))}
        )
        for change in (
            lambda total: sp.Sum(total.function, (j, 1, N + 1)),
            lambda total: sp.Sum(total.function, (j, 2, N)),
            lambda total: sp.Sum(total.function, (j, 1, 2 * N)),
            lambda total: sp.Sum(total.function.subs(A[j], A[j + 1]), (j, 1, N)),
            lambda total: sp.Sum(total.function.subs(A[j], A[1]), (j, 1, N)),
            lambda total: sp.Sum(total.function.subs(A[j], A[N]), (j, 1, N)),
            lambda total: sp.Sum(total.function * A[j], (j, 1, N)),
            lambda total: sp.Sum(total.function * (j**2 - 1) / ((j - 1) * (j + 1)), (j, 1, N)),
            lambda total: sp.Sum(total.function * (j**2 - 4) / ((j - 2) * (j + 2)), (j, 1, N)),
            lambda total: sp.Sum(
                total.function * sp.sqrt(j**2 - 3 * j + sp.Rational(9, 4)) / (j - sp.Rational(3, 2)), (j, 1, N)
            ),
            lambda total: total * N / (N + 1),
            lambda total, c=nothing: total + c,
            lambda total: total**2,
        ):
            yield (
                "sum",
                suffix,
                changed(entry, lambda true, change=change: true.replace(sp.Sum, lambda *a, c=change: c(sp.Sum(*a)))),
            )


def material_constants(key: str) -> Found:
    """Moduli that are rational functions once poles and logarithms have cancelled; and conditions on the bodies."""
    if key != "materials":
        return
    one, other, nu = nt.young_1, nt.young_2, nt.nu_1
    for suffix in ("E_star", "G_star"):
        entry = derived(key)[suffix]
        for unity in (
            (one**2 - other**2) / ((one - other) * (one + other)),
            (nu + sp.log(nu)) ** 2 / (nu**2 + 2 * nu * sp.log(nu) + sp.log(nu) ** 2),
            (nu - nt.nu_2) * (nu + nt.nu_2) / (nu**2 - nt.nu_2**2),
            sp.sqrt(nu**2 - 2 * nu * nt.nu_2 + nt.nu_2**2) / (nu - nt.nu_2),
            (one + sp.sqrt(nu)) ** 2 / (one**2 + 2 * one * sp.sqrt(nu) + nu),
        ):
            yield "material", suffix, changed(entry, times(unity))
        for chain in ((one, other), (one,), (nu, nt.nu_2), (nu, sp.S.Zero)):
            yield ("material", suffix, with_chain(entry, 0, chain))
    # a root with the sign of C_13, of the difference of both moduli, or of the excess of the cup; and other powers
    for suffix, factor in (
        ("E_ti", sp.sqrt(nt.C_13**2) / nt.C_13),
        ("E_ti", sp.sqrt((nt.C_11 - nt.C_33) ** 2) / (nt.C_11 - nt.C_33)),
        ("E_ti", nt.C_44 / nt.C_33),
        ("E_ti", (1 + nt.C_13 / nt.C_11) / (1 + nt.C_13 / nt.C_33)),
        ("R", sp.sqrt((nt.radius_1 - 2 * nt.radius_2) ** 2) / (nt.radius_1 - 2 * nt.radius_2)),
        ("R", sp.sqrt(nt.radius_2**2) / nt.radius_2),
        ("mu_T", sp.cbrt(nt.z_0 * nt.E_star / nt.dgamma)),
        ("lambda_M", sp.cbrt(sp.Rational(16, 9))),
        ("lambda_M", sp.sqrt((nt.R - nt.dgamma / nt.sigma_0) ** 2) / (nt.R - nt.dgamma / nt.sigma_0)),
    ):
        yield "material", suffix, changed(derived(key)[suffix], times(factor))


def mirrored(key: str) -> Found:
    """Eccentric load: right on the half 0 < x of the contact, for e > 0, and next to zero; wrong elsewhere."""
    if key != ECCENTRIC:
        return
    entries, a, e, x, P = derived(key), nt.a, nt.e, nt.x, nt.P
    pressure, tilt, width = entries["p"], entries["phi"], entries["cw"]
    strip, lifted = (case.expr for case in pressure.cases)
    root = sp.pi * a**2 * sp.sqrt(a**2 - x**2)
    size_x, size_e = (sp.sqrt(s**4 + a**2 * s**2) / sp.sqrt(s**2 + a**2) for s in (x, e))
    middle, side = 2 * sp.Abs(e) - a, x * sp.sign(e)
    room, away = 3 * a + side - 4 * sp.Abs(e), sp.sqrt(sp.expand((side - middle) ** 2))
    bare = P / (2 * sp.pi * sp.sqrt(a - side) * (a - sp.Abs(e)))
    for place, expr in (
        (0, P * (a**2 + 2 * size_x * sp.Abs(e)) / root),
        (0, P * (a**2 + 2 * size_x * size_e) / root),
        (0, P * (a**2 + e * x + size_x * size_e) / root),
        (0, strip * size_x * size_e / (x * e)),
        (0, strip * sp.sign(e) ** 2),
        (0, strip + P * (1 - sp.sign(e) ** 2) / a),
        (0, strip * sp.Abs(e) * sp.sign(e) / e),
        (1, lifted * (1 + away / a - (side - middle) / a)),
        (1, lifted * away / (side - middle)),
        (1, bare * sp.sqrt(sp.Max(0, sp.sqrt(sp.expand(room**2))))),
        (1, bare * sp.Max(0, room) / sp.sqrt(room)),
        (1, bare * sp.sqrt(sp.sqrt(sp.expand(room**2)))),
        (1, bare * room / sp.sqrt(sp.Max(0, room))),
        (1, bare * sp.sqrt(sp.Max(0, room**2)) / sp.sqrt(room)),
        (1, bare * sp.Max(0, room) ** sp.Rational(3, 2) / room + P * (sp.Max(0, room) - room) / a**2),
        (1, lifted * (1 + sp.Max(0, room) - room)),
        (1, bare * sp.sqrt(sp.Max(0, room**3)) / sp.sqrt(room**2)),
    ):
        yield "eccentric", "p", with_formula(pressure, place, expr)
    for place, expr in (
        (0, tilt.cases[0].expr * size_e / sp.Abs(e) + P * (1 - sp.sign(e) ** 2) * sp.sign(e)),
        (0, tilt.cases[0].expr / sp.sign(e) ** 2),
        (0, 4 * P * e**3 / (sp.pi * nt.E_star * a**2 * size_e**2)),
    ):
        yield "eccentric", "phi", with_formula(tilt, place, expr)
    for expr in (
        2 * a * sp.sign(e) ** 2,
        2 * a * size_e / sp.Abs(e),
        2 * a * sp.Abs(e) / size_e,
        2 * a * sp.sign(e) / e * sp.Abs(e),
    ):
        yield "eccentric", "cw", with_formula(width, 0, expr)


FAMILIES: tuple[tuple[Callable[[str], Found], int], ...] = (
    (piecewise_constant, 5),
    (named_jumps, 1),
    (circular_inverses, 2),
    (unused_cases, 7),
    (conditions, 11),
    (eccentric, 1),
    (definitions, 7),
    (foreign_symbols, 3),
    (mutations, 7),
    (media, 5),
    (branches, 5),
    (constants, 3),
    (equations, 3),
    (doctored_primitives, 1),
    (fixed_faces, 1),
    (rounded_numbers, 5),
    (cancelled_terms, 31),
    (idle_primitives, 1),
    (exchanged_regions, 1),
    (sums, 5),
    (material_constants, 1),
    (mirrored, 1),
)
"""Each family and how many of its members there are to one of the corpus."""


def candidates(key: str, *, whole: bool = False) -> Iterator[FalseEntry]:
    """What the families make of the true entries of a problem, or, `whole`, everything that they could make."""
    seen: set[tuple[str, Entry]] = set()
    for number, (family, stride) in enumerate(FAMILIES):
        first = crc32(f"{key} {number}".encode())
        for index, (name, suffix, entry) in enumerate(family(key), start=first):
            if (whole or index % stride == 0) and (suffix, entry) not in seen:
                seen.add((suffix, entry))
                yield FalseEntry(name, key, suffix, {**derived(key), suffix: entry})
    yield from conspiracies(key)


def conspiracies(key: str) -> Iterator[FalseEntry]:
    """Several false entries that bear each other out."""
    entries = derived(key)
    if "rz" in entries and any(isinstance(case.expr, sp.Equality) for case in entries["rz"].cases):
        nothing = sp.asin(nt.r_zero / nt.a) + sp.acos(nt.r_zero / nt.a) - sp.pi / 2
        least = changed(entries["dmin"], lambda true: nothing * nt.h)
        for number in (sp.gamma(nt.n / 2 + 1), sp.gamma((nt.n + 1) / 2), sp.sqrt(sp.pi)):
            ring = changed(entries["rz"], lambda true: true)
            cases = (ring.cases[0], replace(ring.cases[1], expr=sp.Eq(number, 0, evaluate=False)))
            both = {**entries, "rz": replace(ring, cases=cases), "dmin": least}
            yield FalseEntry("conspiracy", key, "rz", both)
            yield FalseEntry("conspiracy", key, "dmin", both)
    for base, *others in (("d", "F", "p", "w", "k"), ("F", "k", "pm"), ("P", "p", "s"), ("Dl", "d", "F"), ("p", "rz")):
        if base in entries and all(stated(entries[suffix]) for suffix in (base, *others) if suffix in entries):
            doubled = {suffix: changed(entries[suffix], times(2)) for suffix in (base, *others) if suffix in entries}
            found = entries[base].primitives.items()
            twice = {c: tuple(replace(p, integrand=2 * p.integrand, expr=2 * p.expr) for p in own) for c, own in found}
            doubled[base] = replace(doubled[base], primitives=twice)
            for suffix in list(doubled)[:2]:
                if doubled[suffix] != entries[suffix]:
                    yield FalseEntry("conspiracy", key, suffix, {**entries, **doubled})


@functools.cache
def of(problem: str) -> tuple[FalseEntry, ...]:
    """The candidates that differ from the true entry at a point, or in what they say beside the formula."""
    told = ((found, difference(found)) for found in candidates(problem))
    return tuple(replace(found, told=text) for found, text in told if text)


@functools.cache
def false_entries() -> tuple[FalseEntry, ...]:
    """The whole corpus; `of` makes the part of one problem, for tests that share the problems among workers."""
    return tuple(found for problem in PROBLEMS for found in of(problem))


# what a reader would see

DIGITS = 15
TRIALS = 15
FAR = mp.mpf(10) ** -9


def difference(found: FalseEntry) -> str:
    """How the false entry can be told from the true one without a proof; empty if it cannot."""
    true, false = found.true, found.false
    told = ("key", "quantity", "status", "definition", "parameters", "composed", "partial")
    for name in told:
        if getattr(true, name) != getattr(false, name):
            return f"{name}: {getattr(false, name)}"
    named = set().union(*(case.expr.free_symbols for case in false.cases)) - known(true)
    unknown = sorted(str(name) for name in named if name.is_Symbol and name not in SUMMED)
    if unknown:
        return f"it names {', '.join(unknown)}, which is neither argument nor parameter"
    relations = [type(case.expr) for case in false.cases if case.expr.is_Relational]
    if any(relation is not sp.Equality for relation in relations):
        return "it is no equation"
    return _different_value(true, false)


def _different_value(true: Entry, false: Entry) -> str:
    names = known(true) | known(false)
    for case in (*false.cases, *true.cases):
        for trial in range(TRIALS):
            values = sample(case, true, names, trial)
            if values is None:
                continue
            here, there = _said(true, values), _said(false, values)
            if here is None or (here == [] and there == []):
                continue
            if there is None or len(_distinct(here)) != len(_distinct(there)) or _apart(here, there):
                point = ", ".join(f"{symbol} = {value}" for symbol, value in values.items())
                return f"at {point} it says {_shown(there)} instead of {_shown(here)}"
    return ""


def _shown(said: list[Any] | None) -> str:
    return "nothing real" if said is None else ", ".join(mp.nstr(x, 6) for x in said) or "nothing"


def _distinct(said: list[Any]) -> list[Any]:
    return [x for i, x in enumerate(said) if all(abs(x - y) > FAR * (abs(x) + abs(y)) for y in said[:i])]


def _apart(here: list[Any], there: list[Any]) -> bool:
    return any(min(abs(x - y) - FAR * (abs(x) + abs(y)) for y in here) > 0 for x in there)


def _said(entry: Entry, values: Mapping[sp.Symbol, sp.Expr]) -> list[Any] | None:
    """The values of all cases whose condition holds there, of equations lhs - rhs; None if one is not real."""
    said = []
    with mp.workdps(DIGITS):
        for case in entry.cases:
            if not _holds(case, values):
                continue
            sides = case.expr.args if isinstance(case.expr, sp.Equality) else (case.expr, sp.S.Zero)
            left, right = (_real(side, values) for side in sides)
            if left is None or right is None:
                return None
            said.append(left - right)
    return said


def _holds(case: Case, values: Mapping[sp.Symbol, sp.Expr]) -> bool:
    members = [evaluated(sp.sympify(member), values) for member in case.chain]
    return all(low < high for low, high in zip(members, members[1:], strict=False))


def _real(expr: sp.Expr, values: Mapping[sp.Symbol, sp.Expr]) -> Any:
    """The value, if it and every root, logarithm and inverse function in it are real and finite."""
    expr = sp.sympify(expr)
    if expr.has(sp.Subs, sp.oo) or any(_without_value(total) for total in expr.atoms(sp.Sum)):
        return None
    expr = concrete(expr, values)
    inner = [node for node in expr.atoms(sp.asin, sp.acos, sp.acosh, sp.atanh, sp.log, sp.exp, sp.besseli, StruveL)]
    inner += [node for node in expr.atoms(sp.Pow) if not node.exp.is_Integer and not node.base.is_Symbol]
    try:
        for node in (*inner, expr):
            value = mp.mpmathify(evaluated(node, values))
            if not mp.isfinite(value) or abs(mp.im(value)) > FAR * abs(value):
                return None
    except Exception:  # a pole, a function that no real number is in the range of, or one that nothing evaluates
        return None
    return mp.re(value)


def _without_value(total: sp.Sum) -> bool:
    """Whether a term of the sum is 0/0 as it stands."""
    return any(total.function.subs(nt.j, index).has(sp.nan, sp.zoo) for index in (1, 2, 3))


RANGES: dict[sp.Symbol, tuple[sp.Rational, sp.Rational]] = {
    symbol: (sp.Rational(low), sp.Rational(high))
    for symbols, low, high in (
        ((nt.theta,), "1/10", "7/5"),
        ((nt.k,), "-4/5", "4/5"),
        ((nt.n,), "6/5", "4"),
        ((nt.alpha,), "1/10", "9/10"),
        ((nt.nu, nt.nu_1, nt.nu_2), "-9/10", "9/20"),
        ((nt.sigma,), "-2/5", "2"),
        ((nt.mu,), "1/10", "2"),
        ((nt.e,), "-1", "1"),
        ((nt.F, nt.P), "1/10", "40"),
        ((nt.F_x,), "1/50", "2"),
    )
    for symbol in symbols
}
USUAL = (sp.Rational(1, 5), sp.Rational(3))


def sample(case: Case, true: Entry, names: set[sp.Symbol], trial: int) -> dict[sp.Symbol, sp.Expr] | None:
    """A point where the case holds and the profile exists; None if the draw missed it."""
    draw = random.Random(trial)
    members = [member for member in case.chain if sp.sympify(member).is_Symbol]
    wanted = names | {symbol for member in case.chain for symbol in sp.sympify(member).free_symbols}
    wanted |= {symbol for member in (*true.profile.chain, *true.profile.breaks[:1]) for symbol in member.free_symbols}
    values: dict[sp.Symbol, sp.Expr] = {}
    if true.profile.name == "polynomial":
        values = {nt.N: sp.Integer(3), **{coefficient(i): sp.Rational(i, 2 + trial) for i in range(1, 7)}}
    for symbol in sorted(wanted - set(SUMMED), key=lambda s: (str(s), sp.srepr(s))):
        low, high = RANGES.get(symbol, USUAL)
        share = sp.Rational(draw.randint(1, 999), 1000)
        values[symbol] = low + (high - low) * share
        if trial % 3 == 2 and symbol not in RANGES:  # a rough point, where poles lie
            values[symbol] = sp.Rational(draw.choice((1, 1, 2, 4)), 2)
    chain = [*members, *(s for s in true.profile.chain if s.is_Symbol and s not in members)]
    values.update(zip(chain, sorted(values[s] for s in chain), strict=True))
    if nt.e in values and nt.a in values:
        values[nt.e] *= values[nt.a] if trial % 5 != 4 else 0  # a load in the middle, too
        if nt.x in values:
            values[nt.x] = values[nt.a] * sp.Rational(draw.randint(-999, 999), 1000)
    values |= {symbol: expr.subs(values) for symbol, expr in true.profile.abbreviations if symbol in wanted}
    floor = true.profile.breaks[:1] if true.profile.truncated else ()
    exists = [Case(true.profile.chain, sp.S.Zero), Case((*floor, nt.a) if nt.a in values else (), sp.S.Zero)]
    with mp.workdps(DIGITS):
        return values if all(_holds(region, values) for region in (case, *exists)) else None
