"""What is stored of graded entries besides their definitions: exact at k = 0, pressures that carry the force, rings.

Also how far convolutions are checked, and what is said of the cylinder that has no adhesive entries.
"""

from __future__ import annotations

from dataclasses import replace
from types import ModuleType

import pytest
import sympy as sp
from test_identities import SEED, TWICE, changed, failed

from axiderive import notation as nt
from axiderive.checks import identities, quadrature
from axiderive.checks import viscoelastic as convolution
from axiderive.checks.comparison import Comparison
from axiderive.entry import Entry
from axiderive.physics import adhesive, complete, normal, systems, viscoelastic
from axiderive.physics.medium import GRADED, HOMOGENEOUS
from axiderive.profiles import load
from axiderive.proof import certificate
from axiderive.proof.algebra.domain import NotProvedError
from axiderive.proof.rules import graded


def at_zero(name: str, entries: dict[str, Entry]):
    profile = load(name)
    below = certificate.homogeneous_statements(profile)
    return identities.homogeneous(Comparison(profile, entries, seed=SEED), normal.derive(profile), below)


@pytest.mark.parametrize(("name", "integrals"), [("cone", ""), ("capped_paraboloid", "p w")])
def test_another_homogeneous_limit_is_noticed(name: str, integrals: str) -> None:
    """Formulas and equations symbol by symbol, integrals by their values; every entry by one of both."""
    entries = normal.derive(load(name), GRADED)
    checks = at_zero(name, entries)
    assert failed(checks) == set()
    compared = {check.key: check for check in checks if check.outcome == "passed"}
    assert {key.rpartition(".")[2] for key, check in compared.items() if check.digits} == set(integrals.split())
    assert all(check.count for check in compared.values())
    inverses = {entry.key for suffix, entry in entries.items() if suffix in ("ad", "Fd")}
    assert set(compared) >= {entry.key for entry in entries.values()} - inverses
    for suffix in ("d", "F", "p", "w", "k", "pm"):
        wrong = changed(entries, suffix, lambda x: x * TWICE)
        assert {key for key, _ in failed(at_zero(name, wrong))} == {entries[suffix].key}


def test_an_equation_of_another_half_space_is_noticed() -> None:
    profile = load("sphere")
    entries = normal.derive(profile, GRADED)
    below = certificate.homogeneous_statements(profile)
    (case,) = entries["ad"].cases
    assert graded.homogeneous_limit("ad", entries, normal.derive(profile), below)
    wrong = replace(case, expr=sp.Eq(case.expr.lhs * TWICE, case.expr.rhs))
    with pytest.raises(NotProvedError, match="does not hold"):
        graded.homogeneous_limit(
            "ad", {**entries, "ad": replace(entries["ad"], cases=(wrong,))}, normal.derive(profile), below
        )


def test_a_wrong_stiffness_is_noticed() -> None:
    profile = load("capped_paraboloid")
    entries = normal.derive(profile, GRADED)
    assert identities.stiffness(Comparison(profile, entries, seed=SEED)).passed
    wrong = changed(entries, "d", lambda x: x * TWICE)
    assert not identities.stiffness(Comparison(profile, wrong, seed=SEED)).passed


@pytest.mark.parametrize(("name", "physics"), [("cone", normal), ("concave_quartic", normal), ("cone", adhesive)])
def test_a_pressure_that_does_not_carry_the_force_is_noticed(name: str, physics: ModuleType) -> None:
    """At two exponents; a wrong power of the edge, a wrong factor and a wrong force are told from rounding."""
    profile = load(name)
    entries = physics.derive(profile, GRADED)
    right = identities.pressure_carried(Comparison(profile, entries, physics.PHYSICS, seed=SEED))
    assert right.passed
    assert right.digits >= 40
    assert right.count == 2
    near_k = nt.k + sp.Rational(1, 10**25)
    for suffix, change in (("F", lambda x: x * TWICE), ("p", lambda x: x.subs(nt.k, near_k))):
        other = changed(entries, suffix, change)
        assert not identities.pressure_carried(Comparison(profile, other, physics.PHYSICS, seed=SEED)).passed


def test_a_sum_over_a_pressure_that_is_an_integral_is_said_to_be_missing() -> None:
    entries = normal.derive(load("gaussian"), GRADED)
    check = identities.pressure_carried(Comparison(load("gaussian"), entries, seed=SEED))
    assert check.outcome == "not available"
    assert "itself an integral" in check.reason


@pytest.mark.parametrize("name", ["concave_paraboloid", pytest.param("concave_power", marks=pytest.mark.slow)])
def test_the_ring_is_known_to_most_of_the_digits(name: str) -> None:
    profile = load(name)
    entries = normal.derive(profile, GRADED)
    right = quadrature.ring(Comparison(profile, entries, seed=SEED), "rz")
    assert right.passed
    assert right.digits >= 40
    near = sp.Rational(1, 10**30)

    def moved(expr: sp.Expr) -> sp.Expr:
        if isinstance(expr, sp.Eq):
            return sp.Eq(expr.lhs * (1 + near), expr.rhs)
        return nt.a * near if expr == 0 else expr

    wrong = changed(entries, "rz", moved)
    assert not quadrature.ring(Comparison(profile, wrong, seed=SEED), "rz").passed


def test_convolutions_are_checked_to_forty_digits() -> None:
    profile = load("cone")
    entries = viscoelastic.derive(profile)
    for suffix in ("ramp_sls", "load_pc"):
        right = Comparison(profile, entries, viscoelastic.PHYSICS, points=2, seed=SEED)
        assert convolution.check(right, suffix).required >= 40
        wrong = changed(entries, suffix, lambda x: x * (1 + sp.Rational(1, 10**38)))
        assert not convolution.check(replace(right, entries=wrong), suffix).passed


@pytest.mark.parametrize("medium", [HOMOGENEOUS, GRADED], ids=["homogeneous", "graded"])
def test_a_paraboloid_reaches_the_edge_of_its_cylinder_where_the_refusal_says(medium) -> None:
    """Depth and force of the adhesive paraboloid at the radius a are those of complete contact with w1D(a) = -Dl(a)."""
    capped = load("capped_cylinder")
    inner = adhesive.derive(load("paraboloid"), medium)
    shift = medium.retraction()
    level = complete.edge_depth(capped, medium) - shift
    whole = complete.derive(capped, medium)["F"].cases[-1].expr
    assert sp.simplify(inner["d"].cases[0].expr - level) == 0
    assert sp.simplify(sp.powsimp(sp.expand(inner["F"].cases[0].expr - whole.subs(nt.d, level)))) == 0
    assert sp.simplify(sp.diff(whole, nt.d) - medium.stiffness()) == 0
    package = "graded.adhesive" if medium.k != 0 else "adhesive"
    assert f"use axicontact.{package}.paraboloid for radii below a" in systems.BY_NAME[package].refusal(capped)
