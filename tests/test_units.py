"""Dimensions of every term: right for the catalogue, and wrong ones are named."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp
from selected import drawn

from axiderive import notation as nt
from axiderive.abel.masters import C0
from axiderive.checks.units import Units, UnitsError, check, check_profile, same
from axiderive.physics.normal import derive
from axiderive.profiles import NAMES, load


@pytest.mark.parametrize("name", drawn(NAMES, 4))
def test_every_entry_has_the_dimension_of_its_quantity(name: str) -> None:
    profile = load(name)
    for evidence in check_profile(profile, derive(profile)).values():
        assert evidence.passed, evidence.reason


@pytest.mark.parametrize(
    ("expr", "dimension"),
    [
        (nt.A * nt.a**nt.n, nt.LENGTH),
        (nt.E_star * nt.a**2, nt.FORCE),
        (sp.sqrt(nt.a**2 - nt.r**2) / nt.b, nt.NUMBER),
        (C0(nt.b, nt.r, nt.a), nt.NUMBER),
        (sp.Sum(nt.coefficients[nt.j] * nt.a**nt.j, (nt.j, 1, nt.N)), nt.LENGTH),
        (sp.Integral(nt.u / nt.R, (nt.u, 0, nt.a)), nt.LENGTH),
    ],
)
def test_dimension(expr: sp.Expr, dimension: nt.Dimension) -> None:
    assert same(Units().dimension(expr), dimension)


@pytest.mark.parametrize(
    ("expr", "named"),
    [
        (nt.a + nt.a**2, r"a\*\*2"),
        (sp.acos(nt.b), "acos"),
        (nt.a**nt.R, "R has length"),
        (C0(nt.b, nt.theta, nt.a), "theta has a number"),
        (sp.Sum(nt.coefficients[nt.j] * nt.a ** (2 * nt.j), (nt.j, 1, nt.N)), "different for every j"),
        (sp.Integral(1 / nt.R, (nt.u, 0, nt.theta)), "limit theta"),
    ],
)
def test_a_wrong_term_is_named(expr: sp.Expr, named: str) -> None:
    with pytest.raises(UnitsError, match=named):
        Units().dimension(expr)


@pytest.mark.parametrize("name", ["cone", "quartic", "power_law", "sphere"])
@pytest.mark.parametrize("suffix", ["d", "F", "p", "w", "pm"])
def test_a_missing_length_fails(name: str, suffix: str) -> None:
    """A power of the radius too much, in the whole or in one term."""
    profile = load(name)
    entries = derive(profile)
    for change in (lambda expr: expr * nt.a, lambda expr: expr + nt.a**7):
        entry = entries[suffix]
        broken = replace(entry, cases=tuple(replace(case, expr=change(case.expr)) for case in entry.cases))
        evidence = check(profile, {**entries, suffix: broken}, suffix)
        assert evidence.outcome == "failed"
        assert evidence.reason
