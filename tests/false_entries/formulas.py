"""Families that change a formula: terms that are zero on one side, other branches, constants, roots, sums."""

from __future__ import annotations

import functools
import random
from collections.abc import Callable
from dataclasses import replace
from zlib import crc32

import sympy as sp
from test_mutations import flipped_sign, swapped_symbols, wrong_exponent, wrong_factor

from axiderive import notation as nt
from axiderive.abel.masters import StruveL
from axiderive.entry import Case, Entry

from .entries import (
    COMPACT,
    JUMPS,
    LENGTHS,
    PLANE,
    Found,
    U,
    changed,
    derived,
    known,
    ratios,
    renamed,
    stated,
    times,
    with_formula,
)


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
        yield "branch", suffix, renamed(entry, {sp.sqrt(inside): -sp.sqrt(inside)})
        turned = {inside: sp.expand(-inside)}
        yield "branch", suffix, renamed(entry, turned)


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


def rounded_numbers(key: str) -> Found:
    """A coefficient of one digit: SymPy subtracts an exact number from it at one digit, and finds nothing left."""
    for suffix, entry in derived(key).items():
        if stated(entry):
            yield "rounded number", suffix, changed(entry, _rounded)
            fractions = set().union(*(case.expr.atoms(sp.Rational) for case in entry.cases))
            one_digit = {q: sp.Float(q, 1) for q in fractions if not q.is_Integer}
            if one_digit:
                yield "rounded number", suffix, renamed(entry, one_digit)
            yield "rounded number", suffix, renamed(entry, {sp.pi: sp.Rational(22, 7)})


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
