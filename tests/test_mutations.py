"""Is the prover itself any good?  True formulas are corrupted in one place each; none may be accepted.

The uncorrupted formulas are certified by `test_certificate`, and once more here
for every entry a mutant is made of, so that nothing passes because everything
is refused.
"""

from __future__ import annotations

import functools
import random
from dataclasses import dataclass, replace

import mpmath as mp
import pytest
import sympy as sp
from selected import few
from stored_book import evidence

from axiderive import notation as nt
from axiderive import profiles
from axiderive.entry import Case, Entry
from axiderive.oracle.evaluate import evaluated
from axiderive.physics.normal import derive
from axiderive.proof.certificate import certify, certify_profile
from axiderive.proof.statement import summand

PROFILES = (
    "cone", "quartic", "power_law", "polynomial", "sphere", "ellipsoid", "hyperboloid", "truncated_cone",
    "truncated_paraboloid", "rounded_cone", "capped_paraboloid", "rounded_punch", "rounded_curved_punch",
    "sphere_tipped_cone", "flat_punch", "capped_cylinder", "concave_power", "concave_paraboloid", "concave_quartic",
)  # fmt: skip
ALWAYS = (
    "cone", "sphere", "truncated_paraboloid", "rounded_curved_punch", "concave_power", "concave_paraboloid",
)  # fmt: skip
ACCEPTED = ("cone", "power_law", "polynomial", "flat_punch")
"""Those whose formulas are proved once more; the build proves all."""
SEED = 1882
LENGTHS = (nt.r, nt.a, nt.b, nt.R, nt.R1, nt.R2)
Entries = dict[str, Entry]


@dataclass(frozen=True)
class Mutant:
    """One corrupted entry among the true ones of its profile."""

    kind: str
    suffix: str
    text: str
    entries: Entries


@functools.cache
def true_entries(name: str) -> Entries:
    return derive(profiles.load(name))


def replaced(tree: sp.Expr, old: sp.Expr, new: sp.Expr) -> sp.Expr:
    """The tree with one node rebuilt, whichever place it is found at first."""
    if tree == old:
        return new
    for i, arg in enumerate(tree.args):
        if arg.has(old) or arg == old:
            return tree.func(*tree.args[:i], replaced(arg, old, new), *tree.args[i + 1 :])
    return tree


def nodes(expr: sp.Expr) -> list[sp.Expr]:
    return sorted(set(sp.preorder_traversal(expr)), key=sp.default_sort_key)


def flipped_sign(expr: sp.Expr, rng: random.Random) -> sp.Expr | None:
    sums = [node for node in nodes(expr) if node.is_Add]
    if not sums:
        return -expr
    chosen = rng.choice(sums)
    term = rng.choice(chosen.args)
    return replaced(expr, chosen, chosen - 2 * term)


def wrong_factor(expr: sp.Expr, rng: random.Random) -> sp.Expr | None:
    products = [node for node in nodes(expr) if node.is_Mul]
    chosen = rng.choice(products or [expr])
    return replaced(expr, chosen, chosen * rng.choice([2, sp.Rational(3, 2), sp.Rational(1, 3)]))


def wrong_exponent(expr: sp.Expr, rng: random.Random) -> sp.Expr | None:
    powers = [node for node in nodes(expr) if node.is_Pow and node.base.free_symbols]
    if not powers:
        return None
    chosen = rng.choice(powers)
    return replaced(expr, chosen, chosen.base ** (chosen.exp + rng.choice([1, 2])))


def swapped_symbols(expr: sp.Expr, rng: random.Random) -> sp.Expr | None:
    lengths = [symbol for symbol in LENGTHS if expr.has(symbol)]
    if len(lengths) < 2:
        return None
    one, other = rng.sample(lengths, 2)
    return expr.xreplace({one: other}) if rng.random() < 0.5 else expr.xreplace({one: other, other: one})


def wrong_constant(suffix: str, case: Case, entry: Entry) -> sp.Expr | None:
    """A constant of the right dimension that no derivative in a sees: only the end value finds it."""
    fixed = [s for s in entry.profile.parameters if s in (nt.b, nt.R, nt.R1, nt.h)]
    if suffix not in ("F", "w") or not fixed:
        return None
    return case.expr + (nt.E_star * fixed[-1] ** 2 if suffix == "F" else fixed[-1])


def sample(case: Case) -> dict[sp.Symbol, sp.Rational]:
    """A point of the region; lengths of a complete contact that are not compared come after the chain."""
    ordered = [*(m for m in case.chain if m.is_Symbol), *LENGTHS, nt.n, nt.h, nt.d, nt.A, nt.E_star, nt.F, nt.z]
    values = {symbol: sp.Rational(7 + 4 * i, 10) for i, symbol in enumerate(dict.fromkeys(ordered))}
    return {**values, nt.theta: sp.Rational(3, 10), nt.j: sp.Integer(3), nt.R2: sp.Rational(1, 2)}


def differs(new: sp.Expr, case: Case) -> bool:
    """Whether a mutant is a different function: evaluated, not compared as text."""
    point = sample(case)
    try:
        here, there = (mp.mpmathify(evaluated(summand(expr), point)) for expr in (case.expr, new))
    except (
        KeyError,
        TypeError,
        ValueError,
        ZeroDivisionError,
    ):  # it left the range of a function
        return True
    return not mp.isfinite(there) or abs(there - here) > 1e-9 * abs(here)


def with_case(entry: Entry, index: int, expr: sp.Expr) -> Entry:
    """The entry with another formula; in complete contact the one for a fixed face follows suit."""
    cases = list(entry.cases)
    cases[index] = replace(cases[index], expr=expr)
    faces = tuple(replace(face, expr=expr.subs(nt.h, nt.C * nt.a ** power_of_face(entry))) for face in entry.fixed_face)
    return replace(entry, cases=tuple(cases), fixed_face=faces)


def power_of_face(entry: Entry) -> sp.Expr:
    face = entry.profile.pieces[0].expr
    return sp.cancel(nt.r * sp.diff(face, nt.r) / face) if face != 0 else sp.S.Zero


MUTATIONS = (
    ("sign", flipped_sign),
    ("factor", wrong_factor),
    ("exponent", wrong_exponent),
    ("symbol", swapped_symbols),
)


def corrupted_cases(suffix: str, entry: Entry, rng: random.Random) -> list[tuple[str, Entry]]:
    index = rng.randrange(len(entry.cases))
    case, out = entry.cases[index], []
    for kind, mutate in rng.sample(MUTATIONS, 2):
        expr = mutate(case.expr, rng)
        if expr is not None and differs(expr, case):
            out.append((kind, with_case(entry, index, expr)))
    shifted = wrong_constant(suffix, case, entry)
    if shifted is not None:
        out.append(("constant", with_case(entry, index, shifted)))
    if len({c.expr for c in entry.cases}) > 1:
        turned = (*entry.cases[1:], entry.cases[0])
        cases = tuple(replace(case, expr=other.expr) for case, other in zip(entry.cases, turned, strict=True))
        out.append(("branch", replace(entry, cases=cases)))
    return out


def corrupted_primitives(entry: Entry) -> list[tuple[str, Entry]]:
    """Antiderivatives of something else, or not all of them."""
    chain = entry.cases[-1].chain
    first, *rest = entry.primitives[chain]
    doubled = replace(first, integrand=2 * first.integrand, expr=2 * first.expr)
    other_integrand = replace(first, integrand=first.integrand * nt.x / nt.a)
    other_expr = replace(first, expr=first.expr * nt.x / nt.a)
    swaps = [(doubled, *rest), (other_integrand, *rest), (other_expr, *rest), tuple(rest)]
    return [("primitive", replace(entry, primitives={**entry.primitives, chain: swap})) for swap in swaps]


def certified(name: str) -> set[str]:
    """The true entries of a profile that the build has certified."""
    return {suffix for suffix, one in evidence(name)["entries"].items() if one["certified"]}


@functools.cache
def mutants(name: str) -> tuple[Mutant, ...]:
    rng, entries, out = random.Random(f"{SEED} {name}"), true_entries(name), []
    for suffix in sorted(certified(name) & {"d", "F", "p", "w", "k", "pm", "ad", "aF", "Fd", "dF", "dmin", "Fmin"}):
        wrong = corrupted_cases(suffix, entries[suffix], rng)
        wrong += corrupted_primitives(entries[suffix]) if suffix == "d" else []
        out += [Mutant(kind, suffix, entry.text(), {**entries, suffix: entry}) for kind, entry in wrong]
    return tuple(out)


@pytest.mark.parametrize("name", few(PROFILES, ALWAYS))
def test_no_mutant_is_accepted(name: str) -> None:
    profile = profiles.load(name)
    accepted = [
        f"{mutant.kind}: {mutant.text}"
        for mutant in mutants(name)
        if certify(profile, mutant.entries, mutant.suffix).proved
    ]
    assert not accepted, "\n".join(accepted)


@pytest.mark.parametrize("name", few(PROFILES, ACCEPTED))
def test_the_true_formula_behind_every_mutant_is_accepted(name: str) -> None:
    found = certify_profile(profiles.load(name), true_entries(name))
    assert {suffix for suffix, certificate in found.items() if certificate.proved} == certified(name)
    assert mutants(name)


@pytest.mark.parametrize(
    ("names", "least"),
    [pytest.param(ALWAYS, 4, id="plain run"), pytest.param(PROFILES, 10, id="all", marks=pytest.mark.slow)],
)
def test_there_are_enough_mutants_of_every_kind(names: tuple[str, ...], least: int) -> None:
    found = [mutant.kind for name in names for mutant in mutants(name)]
    assert len(found) >= 10 * least
    for kind in ("sign", "factor", "exponent", "symbol", "constant", "branch", "primitive"):
        assert found.count(kind) >= least, kind


def test_mutants_are_the_same_in_every_run() -> None:
    first = [(m.kind, m.text) for m in mutants("rounded_cone")]
    mutants.cache_clear()
    assert first == [(m.kind, m.text) for m in mutants("rounded_cone")]
