"""Profiles the engine has never seen: random piecewise polynomials with two breaks, against their definitions."""

from __future__ import annotations

import random
from functools import lru_cache

import mpmath as mp
import pytest
import sympy as sp

from axiderive.abel.masters import MASTERS
from axiderive.entry import Entry
from axiderive.notation import E_star, a, r
from axiderive.oracle.integrals import GUARD, Homogeneous
from axiderive.oracle.shape import shape
from axiderive.physics.normal import derive
from axiderive.profiles.profile import Piece, Profile, Sketch

B1, B2 = sp.symbols("b1 b2", positive=True)
DIGITS = 30
FEW, SOME, MANY = range(3), range(3, 15), range(15, 40)


def random_polynomial(source: random.Random) -> sp.Expr:
    """Without a constant, of degree at most five, sparse."""
    degrees = source.sample(range(1, 6), source.randint(1, 4))
    return sp.Add(*(sp.Rational(source.randint(1, 9), source.randint(1, 9)) * r**degree for degree in degrees))


def random_profile(seed: int) -> Profile:
    """Continuous, with kinks of either sign at both breaks; every fifth has a flat tip."""
    source = random.Random(seed)
    polynomials = [sp.S.Zero if seed % 5 == 0 else random_polynomial(source)]
    polynomials += [source.choice((1, -1)) * random_polynomial(source) for _ in range(2)]
    return profile_of(f"heldout{seed}", polynomials)


def profile_of(name: str, polynomials: list[sp.Expr]) -> Profile:
    """Pieces that rise as polynomials do, each from where the one before ends."""
    pieces, height, start = [], sp.S.Zero, sp.S.Zero
    for upper, polynomial in zip((B1, B2, None), polynomials, strict=True):
        expr = sp.expand(height + polynomial - polynomial.subs(r, start))
        pieces.append(Piece(upper, expr))
        if upper is not None:
            height, start = expr.subs(r, upper), upper
    return Profile(
        name=name, title="", subtitle="", contact="compact", parameters=(B1, B2), pieces=tuple(pieces),
        validity="", sources=(), sketch=Sketch((), a=1.0),
    )  # fmt: skip


@lru_cache(maxsize=8)
def derived(seed: int) -> tuple[Profile, dict[str, Entry]]:
    profile = random_profile(seed)
    return profile, derive(profile)


def evaluated(expr: sp.Expr, values: dict[sp.Symbol, sp.Rational]) -> mp.mpf:
    own = {master.__name__: master.numeric for master in MASTERS}
    numbers = [mp.mpf(int(x.p)) / int(x.q) for x in values.values()]
    return sp.lambdify(list(values), expr, [own, "mpmath"])(*numbers)


def defined(suffix: str, profile: Profile, values: dict[sp.Symbol, sp.Rational]) -> mp.mpf:
    """The quantity as its defining integral, with E* = 1."""
    face = Homogeneous(shape(profile, values), mp.mpf(0), DIGITS)
    radius, place = (mp.mpf(int(x.p)) / int(x.q) for x in (values[a], values[r]))
    match suffix:
        case "d":
            return face.depth(radius)
        case "F":
            return face.force(radius)
        case "p":
            return face.pressure(radius, place)
        case _:
            return face.displacement(radius, place)


def random_point(chain: tuple[sp.Symbol, ...], source: random.Random) -> dict[sp.Symbol, sp.Rational]:
    """Lengths in the order of the chain; those that it leaves out are put behind it."""
    names = (*chain, *(x for x in (B1, B2, a, r) if x not in chain))
    lengths = sorted(source.sample(range(20, 300), len(names)))
    return {name: sp.Rational(length, 100) for name, length in zip(names, lengths, strict=True)}


def check(seed: int) -> None:
    checked(*derived(seed), random.Random(1000 + seed))


def checked(profile: Profile, entries: dict[str, Entry], source: random.Random) -> None:
    """Every case at a point of its region, against the definition."""
    for suffix in ("d", "F", "p", "w"):
        assert entries[suffix].status == "closed"
        for case in entries[suffix].cases:
            values = random_point(case.chain, source)
            with mp.workdps(DIGITS + GUARD):
                exact = defined(suffix, profile, values)
                error = abs(evaluated(case.expr.subs(E_star, 1), values) - exact) / abs(exact)
            assert error < mp.mpf("1e-25"), (suffix, case.chain, values)


@pytest.mark.parametrize("seed", FEW)
def test_closed_forms_of_a_random_profile(seed):
    check(seed)


@pytest.mark.parametrize(
    "seed",
    [*(pytest.param(seed, marks=pytest.mark.slow) for seed in SOME),
     *(pytest.param(seed, marks=pytest.mark.sweep) for seed in MANY)],
)  # fmt: skip
def test_closed_forms_of_many_random_profiles(seed):
    check(seed)


@pytest.mark.parametrize(("seed", "counts"), [(0, [2, 2, 5, 3]), (1, [3, 3, 6, 6])], ids=["flat tip", "tip"])
def test_every_place_among_the_breaks_is_a_case(seed, counts):
    _, entries = derived(seed)
    assert [len(entries[suffix].cases) for suffix in ("d", "F", "p", "w")] == counts


def test_a_paraboloid_that_changes_its_curvature_twice() -> None:
    """The path of the random ones, by what is quickest to derive."""
    profile = profile_of("paraboloids", [r**2, r**2 / 2, 3 * r**2])
    entries = derive(profile)
    assert [len(entries[suffix].cases) for suffix in ("d", "F", "p", "w")] == [3, 3, 6, 6]
    checked(profile, entries, random.Random(7))
