"""Identities across entries: they hold over the catalogue, and each of them notices a wrong entry."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp
from selected import few

from axiderive import notation as nt
from axiderive.checks import identities, superposed
from axiderive.checks.comparison import Comparison
from axiderive.entry import Entry
from axiderive.physics import adhesive, loads, normal, tangential, viscoelastic
from axiderive.physics.medium import GRADED, HOMOGENEOUS
from axiderive.physics.normal import derive
from axiderive.profiles import NAMES, load
from axiderive.profiles.loads import LOADS

SEED = 1


@pytest.mark.parametrize("name", few(NAMES, ["cone", "concave_quartic"]))
def test_identities_hold(name: str) -> None:
    profile = load(name)
    entries = derive(profile)
    evidence = identities.check_profile(Comparison(profile, entries, seed=SEED))
    assert {one.compared for one in evidence} >= {"F = 2 pi int p r dr", "w(a) = d - f(a)"}
    assert {one.key for one in evidence} <= {entry.key for entry in entries.values()}
    for one in evidence:
        assert one.outcome != "failed", one
        if one.outcome == "not available":
            assert "integral" in one.reason
        else:
            assert one.digits >= 40, one


def scaled(entry: Entry) -> Entry:
    factor = 1 + sp.Rational(1, 10**36)
    return replace(entry, cases=tuple(replace(case, expr=case.expr * factor) for case in entry.cases))


@pytest.mark.parametrize(
    ("check", "suffix", "name"),
    [
        (identities.stiffness, "F", "rounded_punch"),
        (identities.force_of_pressure, "p", "cone"),
        pytest.param(identities.force_of_pressure, "p", "rounded_punch", marks=pytest.mark.slow),
        (identities.edge, "w", "rounded_punch"),
        (identities.profile_from_depth, "d", "rounded_punch"),
    ],
)
def test_each_identity_notices_a_wrong_factor(check, suffix: str, name: str) -> None:
    profile = load(name)
    entries = derive(profile)
    assert check(Comparison(profile, entries, seed=SEED)).passed
    entries[suffix] = scaled(entries[suffix])
    evidence = check(Comparison(profile, entries, seed=SEED))
    assert evidence.outcome == "failed"
    assert 35 <= evidence.digits <= 37


def test_a_step_between_cases_is_noticed() -> None:
    profile = load("rounded_cone")
    entry = derive(profile)["d"]
    inner, outer = entry.cases
    stepped = replace(entry, cases=(inner, replace(outer, expr=outer.expr + nt.b * sp.Rational(1, 10**30))))
    assert identities.continuity(Comparison(profile, {"d": entry}, seed=SEED), "d").passed
    assert identities.continuity(Comparison(profile, {"d": stepped}, seed=SEED), "d").outcome == "failed"


def test_a_limit_to_the_wrong_profile_is_noticed() -> None:
    profile = load("truncated_cone")
    target = load("cone")
    (limit,) = profile.limits
    own, simpler = Comparison(profile, derive(profile), seed=SEED), derive(target)["F"]
    assert identities.to_limit(own, "F", limit, target, simpler).passed
    wrong = identities.to_limit(own, "F", limit, target, scaled(simpler))
    assert wrong.outcome == "failed"


# the other physics


def changed(entries: dict[str, Entry], suffixes: str, change) -> dict[str, Entry]:
    new = {
        s: replace(entries[s], cases=tuple(replace(case, expr=change(case.expr)) for case in entries[s].cases))
        for s in suffixes.split()
    }
    return {**entries, **new}


def failed(checks) -> set[tuple[str, str]]:
    return {(check.key, check.compared) for check in checks if check.outcome == "failed"}


@pytest.mark.parametrize("medium", [HOMOGENEOUS, GRADED], ids=["homogeneous", "graded"])
def test_a_retraction_of_twice_the_energy_is_noticed_by_the_crack(medium) -> None:
    """Consistent in all entries, so that neither stationarity nor the limit without adhesion is violated."""
    profile = load("paraboloid")
    plain, entries = normal.derive(profile, medium), adhesive.derive(profile, medium)
    assert failed(superposed.adhesion(Comparison(profile, entries, adhesive.PHYSICS, seed=SEED), plain)) == set()
    more = changed(entries, "Dl d F p w ac Fc dc am Fm dm", lambda x: x.subs(nt.dgamma, 2 * nt.dgamma))
    found = failed(superposed.adhesion(Comparison(profile, more, adhesive.PHYSICS, seed=SEED), plain))
    assert {compared.split(",")[0].split(" -")[0] for _, compared in found} >= {"work of closing the crack"}
    assert not any("da = 0" in compared or "symbolically" in compared for _, compared in found)
    assert any(compared.startswith("known value") for _, compared in found)


@pytest.mark.parametrize(
    ("suffix", "compared"), [("ac", "dF/da = 0"), ("am", "dd/da = 0"), ("Fc", "F at ac"), ("dm", "d at am")]
)
def test_a_wrong_pull_off_is_noticed(suffix: str, compared: str) -> None:
    profile = load("truncated_cone")
    plain, entries = normal.derive(profile), adhesive.derive(profile)

    def wrong(expr: sp.Expr) -> sp.Expr:
        return sp.Eq(expr.lhs * TWICE, expr.rhs) if isinstance(expr, sp.Eq) else expr * TWICE

    own = Comparison(profile, changed(entries, suffix, wrong), adhesive.PHYSICS, seed=SEED)
    found = failed(superposed.adhesion(own, plain))
    assert (entries[suffix].key, compared) in found


TWICE = 1 + sp.Rational(1, 10**30)


@pytest.mark.parametrize("suffix", ["F", "u", "us", "tau"])
def test_a_wrong_partial_slip_is_noticed(suffix: str) -> None:
    profile = load("paraboloid")
    plain, entries = normal.derive(profile), tangential.derive(profile)
    assert failed(superposed.slip(Comparison(profile, entries, tangential.PHYSICS, seed=SEED), plain)) == set()
    wrong = changed(entries, suffix, lambda x: x * (1 + sp.Rational(1, 10**15)))
    assert failed(superposed.slip(Comparison(profile, wrong, tangential.PHYSICS, seed=SEED), plain))


def test_another_elastic_limit_is_noticed() -> None:
    profile = load("cone")
    plain, entries = normal.derive(profile), viscoelastic.derive(profile)
    assert failed(superposed.elastic(Comparison(profile, entries, viscoelastic.PHYSICS, seed=SEED), plain)) == set()
    for suffix, entry in entries.items():
        if entry.status == "root":  # has no limit of its own
            continue
        wrong = Comparison(profile, changed(entries, suffix, lambda x: x * TWICE), viscoelastic.PHYSICS)
        found = failed(superposed.elastic(wrong, plain))
        assert {key for key, _ in found} == {entry.key}


@pytest.mark.parametrize(
    "own", few(LOADS, [own for own in LOADS if own.name != "power"], pytest.mark.slow), ids=lambda own: own.name
)
def test_reciprocity_notices_both_sides_of_the_edge(own) -> None:
    entries = loads.derive(own)
    assert superposed.reciprocity(Comparison(own, entries, loads.PHYSICS, seed=SEED), own).passed
    for place in (0, 1):
        cases = list(entries["w"].cases)
        cases[place] = replace(cases[place], expr=cases[place].expr * TWICE)
        wrong = Comparison(own, {"w": replace(entries["w"], cases=tuple(cases))}, loads.PHYSICS)
        assert not superposed.reciprocity(wrong, own).passed
