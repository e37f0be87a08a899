"""Identities across entries: they hold over the catalogue, and each of them notices a wrong entry."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp

from axiderive import notation as nt
from axiderive.contact.normal import derive
from axiderive.entry import Entry
from axiderive.profiles import NAMES, load
from axiderive.proof import identities, limits

SEED = 1


@pytest.mark.parametrize("name", NAMES)
def test_identities_hold(name: str) -> None:
    profile = load(name)
    entries = derive(profile)
    evidence = identities.check_profile(profile, entries, seed=SEED)
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
    ("check", "suffix"),
    [
        (identities.check_stiffness, "F"),
        (identities.check_force_of_pressure, "p"),
        (identities.check_edge, "w"),
        (identities.check_profile_from_depth, "d"),
    ],
)
def test_each_identity_notices_a_wrong_factor(check, suffix: str) -> None:
    profile = load("rounded_punch")
    entries = derive(profile)
    assert check(profile, entries, digits=50, seed=SEED).passed
    entries[suffix] = scaled(entries[suffix])
    evidence = check(profile, entries, digits=50, seed=SEED)
    assert evidence.outcome == "failed"
    assert 35 <= evidence.digits <= 37


def test_a_step_between_cases_is_noticed() -> None:
    profile = load("rounded_cone")
    entry = derive(profile)["d"]
    inner, outer = entry.cases
    stepped = replace(entry, cases=(inner, replace(outer, expr=outer.expr + nt.b * sp.Rational(1, 10**30))))
    assert identities.check_continuity(profile, entry, digits=50, seed=SEED).passed
    assert identities.check_continuity(profile, stepped, digits=50, seed=SEED).outcome == "failed"


def test_a_limit_to_the_wrong_profile_is_noticed() -> None:
    profile = load("truncated_cone")
    target = load("cone")
    (limit,) = profile.limits
    entry, simpler = derive(profile)["F"], derive(target)["F"]
    assert limits.check_limit(profile, entry, limit, target, simpler, digits=50, seed=SEED).passed
    wrong = limits.check_limit(profile, entry, limit, target, scaled(simpler), digits=50, seed=SEED)
    assert wrong.outcome == "failed"
