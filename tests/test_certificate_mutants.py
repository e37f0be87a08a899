"""Corrupted formulas of graded, adhesive, tangential and viscoelastic contact are refused."""

from __future__ import annotations

import functools
import random
from dataclasses import replace

import pytest
import sympy as sp
from certificates import Entries, entries, expected
from selected import few
from test_mutations import flipped_sign, swapped_symbols, wrong_exponent, wrong_factor

from axiderive import notation as nt
from axiderive import profiles
from axiderive.entry import Case, Entry
from axiderive.physics import adhesive, loads, normal
from axiderive.physics.medium import GRADED
from axiderive.profiles.loads import LOADS
from axiderive.profiles.profile import Profile
from axiderive.proof.certificate import certify

MUTATED = [
    *(("graded", name) for name in ("cone", "power_law", "sphere", "hyperboloid", "truncated_cone", "gaussian")),
    *(("graded", name) for name in ("wavy_paraboloid", "sphere_tipped_cone", "flat_punch", "concave_quartic")),
    *(("adhesive", name) for name in ("cone", "power_law", "truncated_paraboloid")),
    *(("graded adhesive", name) for name in ("paraboloid", "sphere")),
    *(("tangential", name) for name in ("cone", "rounded_cone")),
    ("graded tangential", "truncated_cone"),
    *(("viscoelastic", name) for name in ("cone", "flat_punch", "capped_cylinder")),
]
ALWAYS = [
    *(("graded", name) for name in ("cone", "truncated_cone", "flat_punch")),
    ("adhesive", "cone"),
    ("graded adhesive", "paraboloid"),
    ("tangential", "cone"),
    ("viscoelastic", "capped_cylinder"),
]
MUTATIONS = (flipped_sign, wrong_factor, wrong_exponent, swapped_symbols)
SYMBOLS = (
    nt.r, nt.c, nt.b, nt.a, nt.a_c, nt.R, nt.wavelength, nt.s, nt.n, nt.h, nt.d, nt.A, nt.E_star, nt.H, nt.F, nt.dgamma,
    nt.G_star, nt.H_x, nt.F_x, nt.time, nt.v, nt.E, nt.E_1, nt.E_inf, nt.eta, nt.relaxation, nt.t_0, nt.p_0,
    nt.t_1, nt.t_m, nt.t_h, nt.t_c, nt.v_2,
)  # fmt: skip


def sample(chain: tuple[sp.Expr, ...]) -> dict[sp.Symbol, sp.Rational]:
    ordered = dict.fromkeys([*(m for m in chain if m.is_Symbol), *SYMBOLS])
    values = {symbol: sp.Rational(7 + 4 * i, 10) for i, symbol in enumerate(ordered)}
    fixed = dict.fromkeys((nt.theta, nt.k, nt.alpha, nt.mu, nt.sigma), sp.Rational(3, 10))
    return {**values, **fixed, nt.F: sp.Integer(100)}


def differs(new: sp.Expr, case: Case) -> bool:
    """Whether a mutant is a different function: evaluated, not compared as text."""
    values = sample(case.chain)
    try:
        gap, size = sp.N((new - case.expr).subs(values)), sp.N(case.expr.subs(values))
    except (TypeError, ValueError, ZeroDivisionError):  # the mutant left the real range of a function
        return True
    return not gap.is_number or gap.has(sp.zoo, sp.nan) or abs(gap) > 1e-9 * abs(size)


def mutants(found: Entries, proved: list[str], seed: str) -> list[tuple[str, Entry]]:
    """Two corrupted entries for each proved quantity, and one with its regimes turned."""
    rng, out = random.Random(seed), []
    for suffix in proved:
        entry = found[suffix]
        index = rng.randrange(len(entry.cases))
        case = entry.cases[index]
        equation = isinstance(case.expr, sp.Equality)
        true = case.expr.lhs if equation else case.expr
        for mutate in rng.sample(MUTATIONS, 2):
            wrong = mutate(true, rng)
            if wrong is None or not differs(wrong, Case(case.chain, true)):
                continue
            changed = replace(case, expr=sp.Eq(wrong, case.expr.rhs) if equation else wrong)
            out.append((suffix, with_case(entry, index, changed)))
        if len({other.expr for other in entry.cases}) > 1:
            turned = (*entry.cases[1:], entry.cases[0])
            pairs = zip(entry.cases, turned, strict=True)
            cases = tuple(replace(own, expr=other.expr) for own, other in pairs)
            out.append((suffix, replace(entry, cases=cases)))
    return out


def with_case(entry: Entry, index: int, changed: Case) -> Entry:
    cases = (*entry.cases[:index], changed, *entry.cases[index + 1 :])
    faces = tuple(replace(face, expr=changed.expr.subs(nt.h, nt.C * nt.a**4)) for face in entry.fixed_face)
    return replace(entry, cases=cases, fixed_face=faces)


@functools.cache
def corrupted(kind: str, name: str) -> tuple[tuple[str, Entry], ...]:
    found = entries(kind, name)
    proved = [suffix for suffix in found if expected(found[suffix], found) and suffix != "rz"]
    return tuple(mutants(found, proved, f"{kind} {name}"))


@pytest.mark.parametrize(("kind", "name"), few(MUTATED, ALWAYS, pytest.mark.slow))
def test_no_mutant_is_accepted(kind: str, name: str) -> None:
    profile, found = profiles.load(name), entries(kind, name)
    accepted = [
        wrong.text()
        for suffix, wrong in corrupted(kind, name)
        if certify(profile, {**found, suffix: wrong}, suffix).proved
    ]
    assert not accepted, "\n".join(accepted)


@pytest.mark.parametrize(
    ("cells", "least"),
    [pytest.param(ALWAYS, 80, id="plain run"), pytest.param(MUTATED, 200, id="all", marks=pytest.mark.slow)],
)
def test_there_are_enough_mutants(cells: list[tuple[str, str]], least: int) -> None:
    """Measured: 90, and 257 of all."""
    assert all(corrupted(*cell) for cell in cells)
    assert sum(len(corrupted(*cell)) for cell in cells) >= least


@pytest.mark.parametrize("load", LOADS, ids=lambda load: load.name)
def test_no_corrupted_load_is_accepted(load: Profile) -> None:
    found = loads.derive(load)
    for seed in range(4):
        for suffix, wrong in mutants(found, ["w"], f"{load.name} {seed}"):
            assert not certify(load, {suffix: wrong}, suffix).proved, wrong.text()


def test_an_antiderivative_of_another_kernel_is_refused() -> None:
    """The primitives of the homogeneous half-space do not prove the depth on the graded one."""
    profile = profiles.load("sphere")
    soft, plain = normal.derive(profile, GRADED), normal.derive(profile)
    borrowed = {**soft, "d": replace(soft["d"], primitives=plain["d"].primitives)}
    assert not certify(profile, borrowed, "d").proved


def test_a_depth_is_also_proved_by_the_integral_that_defines_its_function() -> None:
    """Euler's integral is the depth of the sphere; an incomplete Beta function has an antiderivative only."""
    for name, proved in (("sphere", True), ("truncated_cone", False)):
        profile = profiles.load(name)
        soft = normal.derive(profile, GRADED)
        assert certify(profile, {**soft, "d": replace(soft["d"], primitives={})}, "d").proved == proved
        doubled = tuple(replace(case, expr=2 * case.expr) for case in soft["d"].cases)
        assert not certify(profile, {**soft, "d": replace(soft["d"], cases=doubled, primitives={})}, "d").proved


def test_a_formula_above_an_unproved_one_is_not_proved() -> None:
    profile = profiles.load("sphere")
    certificate = certify(profile, adhesive.derive(profile, GRADED), "p")
    assert certificate.reason == "rests on sphere.fgm.p, which is not proved"
    assert certificate.steps
