"""Numbers of fields below the surface as entries: which are proved, that false ones are not, and what ties them."""

from __future__ import annotations

import random
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from typing import Any

import mpmath as mp
import pytest
import sympy as sp
from false_entries import with_formula
from selected import few
from test_mutations import differs, flipped_sign, wrong_exponent, wrong_factor

import axicontact
from axiderive import notation as nt
from axiderive.abel.field_moments import Moments, kernel
from axiderive.checks import subsurface as checks
from axiderive.checks.comparison import Comparison
from axiderive.oracle.evaluate import evaluated
from axiderive.physics import subsurface, systems
from axiderive.profiles.pools import ROUND
from axiderive.proof.certificate import certify, certify_profile
from axiderive.stable.fields import RESULTS
from axiderive.stable.measure import closure
from axiderive.stable.records import record

ELEMENTARY = (
    "cone", "paraboloid", "quartic", "sextic", "flat_punch", "capped_cylinder", "concave_paraboloid", "concave_quartic",
)  # fmt: skip
ROOT = Path(axicontact.__file__).parents[1]
PUNCHES = "axicontact/_runtime/subsurface/punches.py"
QUICK = ("cone", "flat_punch", "capped_cylinder", "concave_paraboloid")


def entries(name: str) -> dict[str, Any]:
    return systems.problem(f"{name}.sub").derive()


def test_every_profile_has_all_numbers_and_polynomial_slopes_need_no_integral() -> None:
    closed = set()
    for name in ROUND.names:
        found = entries(name)
        assert set(found) == {"W", *(f"{letter}{m}" for letter in "SD" for m in range(4))}
        if all(entry.status == "closed" for entry in found.values()):
            closed.add(name)
        else:
            assert {entry.status for entry in found.values()} == {"integral"}
    assert closed == set(ELEMENTARY)


@pytest.mark.parametrize("name", few(ELEMENTARY, QUICK[1::2]))
def test_elementary_numbers_are_certified(name: str) -> None:
    found = certify_profile(ROUND.load(name), entries(name))
    assert not [own.reason for own in found.values() if not own.proved]


@pytest.mark.parametrize("name", few(ELEMENTARY, QUICK[::2], pytest.mark.slow))
def test_a_formula_with_one_error_is_not_certified(name: str) -> None:
    dice, profile, true = random.Random(name), ROUND.load(name), entries(name)
    for suffix, entry in true.items():
        for change in (flipped_sign, wrong_factor, wrong_exponent):
            index = dice.randrange(len(entry.cases))
            wrong = change(entry.cases[index].expr, dice)
            if wrong is None or not differs(wrong, entry.cases[index]):
                continue
            false = with_formula(entry, index, wrong)
            assert not certify(profile, {**true, suffix: false}, suffix).proved, (suffix, change.__name__, wrong)


def test_what_stands_beside_a_formula_is_not_certified_if_it_is_another() -> None:
    profile, true = ROUND.load("cone"), entries("cone")
    loss = true["D1"]
    for false in (
        replace(loss, definition=true["D2"].definition),
        replace(loss, cases=(*loss.cases, *loss.cases)),
        replace(loss, cases=true["S1"].cases),
        replace(loss, cases=tuple(replace(case, expr=case.expr.subs(nt.a, nt.R)) for case in loss.cases)),
        replace(loss, parameters=()),
    ):
        assert not certify(profile, {**true, "D1": false}, "D1").proved
    assert not certify(profile, {**true, "S1": replace(true["S1"], cases=true["S2"].cases)}, "D1").proved


@pytest.mark.parametrize(("name", "suffix"), [("cone", "S1"), ("cone", "W"), ("capped_cylinder", "W")])
def test_a_region_too_many_too_few_or_another_is_not_certified(name: str, suffix: str) -> None:
    true = entries(name)
    cases = true[suffix].cases
    other = replace(cases[0], chain=(nt.r, *cases[0].chain))
    for wrong in ((*cases, cases[-1]), cases[:-1], (other, *cases[1:])):
        false = replace(true[suffix], cases=wrong)
        assert not certify(ROUND.load(name), {**true, suffix: false}, suffix).proved


@pytest.mark.parametrize("suffix", ["W", "S0", "D0"])
def test_before_the_edge_is_reached_a_formula_must_not_name_it(suffix: str) -> None:
    """The radius of the edge in the place of that of the contact: at equal radii both are the same formula."""
    true = entries("capped_cylinder")
    before = true[suffix].cases[0]
    radius = before.chain[0]
    false = with_formula(true[suffix], 0, before.expr.subs(radius, nt.a))
    assert before.expr.has(radius)
    assert not before.expr.has(nt.a)
    assert not certify(ROUND.load("capped_cylinder"), {**true, suffix: false}, suffix).proved


@pytest.mark.parametrize(("j", "m"), [(0, 0), (0, 3), (1, 0), (2, 1), (4, 3)])
def test_moments_are_integrals_of_the_field_of_a_punch(j: int, m: int) -> None:
    values = {nt.r: sp.Rational(7, 10), nt.z: sp.Rational(2, 5), nt.a: sp.Rational(13, 10)}
    moment = Moments()(j, m)
    with mp.workdps(40):
        r, z, a = (mp.mpf(x.p) / x.q for x in values.values())

        def field(t: Any) -> Any:
            rho = mp.sqrt(z + 1j * (t - r)) * mp.sqrt(z + 1j * (t + r))
            return (r / (rho + z + 1j * t)) ** m / rho

        wanted = mp.quad(lambda t: t**j * field(t), [0, r, a])
        assert abs(evaluated(moment.real.expr(), values) - wanted.real) < 1e-35
        assert abs(evaluated(moment.imaginary.expr(), values) - wanted.imag) < 1e-35
        assert abs(evaluated(kernel(m, nt.a).imaginary.expr(), values) - field(a).imag) < 1e-35


NORM, CLOSE, COMPONENT = 450.0, 45.0, 4500.0
"""1e-13 beside the largest component at a point, 1e-14 away from edge and breaks, 1e-12 of a component beyond what a
rounding of the place changes in it, in units of the last place."""


def modules(*changed: tuple[str, str]) -> dict[str, str]:
    """The texts of the package, with some words of the sums over punches changed."""
    texts = {path.relative_to(ROOT).as_posix(): path.read_text() for path in (ROOT / "axicontact").rglob("*.py")}
    for old, new in changed:
        assert old in texts[PUNCHES]
        texts[PUNCHES] = texts[PUNCHES].replace(old, new)
    return texts


def worst(name: str, *changed: tuple[str, str]) -> dict[str, Any]:
    """The measured errors of the functions of a profile."""
    key = f"{name}.sub"
    return record(key, closure(modules(*changed), f"axicontact/subsurface/{name}.py"), entries(name))


@pytest.mark.parametrize("name", few(ROUND.names, ["cone", "rounded_punch"]))
def test_emitted_fields_keep_their_digits_everywhere(name: str) -> None:
    found = worst(name)
    assert set(found) == {asked for asked in RESULTS if hasattr(import_module(f"axicontact.subsurface.{name}"), asked)}
    for function, row in found.items():
        for domain, bound in (("bench", CLOSE), ("extreme", NORM)):
            errors = row[domain]
            if errors["points"]:
                assert errors["lost"] == 0, (function, domain)
                assert errors["worst_ulp"] < bound, (function, domain, errors)
                assert errors["by_component"] < COMPONENT, (function, domain, errors)


def test_a_wrong_or_careless_sum_over_punches_is_measured() -> None:
    wrong = ("* deep * (r / root)\n    return pressed", "* deep * (r / root) * 1.0000001\n    return pressed")
    assert worst("cone", wrong)["stress"]["bench"]["worst_ulp"] > 1e6
    careless = worst("cone", ("        pressed * ss,", "        pressed - deep * kappa * (c * y + s * x) / r,"))
    assert careless["sliding_stress"]["extreme"]["by_component"] > 1e6


PROFILE = "cone"


def placed(true: dict[str, Any]) -> tuple[Comparison, tuple[int, Any]]:
    """The comparison of some entries, and the last case with a point of it."""
    own = Comparison(ROUND.load(PROFILE), true, subsurface.PHYSICS, seed=1)
    return own, (len(true["S0"].cases) - 1, checks._places(own, true["S0"].cases[-1])[-1])


@pytest.mark.parametrize(
    ("identity", "suffixes"),
    [
        (checks._beside, ("S2",)),
        (checks._carried, ("S0",)),  # of D0 a plane carries nothing
        (checks._hooke, ("S0", "S2", "D0", "D1", "D2", "W")),
    ],
)
def test_each_identity_notices_a_wrong_factor(identity: Any, suffixes: tuple[str, ...]) -> None:
    """That of a factor of all numbers is noticed by the load and by the surface."""
    true = entries(PROFILE)
    own, last = placed(true)
    assert identity(own, *last)[1] < 1e-13
    for suffix in suffixes:
        (case,) = true[suffix].cases
        false = {**true, suffix: with_formula(true[suffix], 0, case.expr * (1 + sp.Rational(1, 10**10)))}
        assert identity(placed(false)[0], *last)[1] > 1e-11, suffix


def test_what_is_recorded_of_the_numbers() -> None:
    found = checks.check_profile(placed(entries(PROFILE))[0])
    assert all(one.outcome == "passed" and one.required > 10 for one in found)
    assert {one.compared for one in found if one.digits < 20} == {
        "2 int (S0 + D0) r dr = F/E_star over a plane", "Hooke's law of displacements and stresses",
    }  # fmt: skip
    assert {one.compared for one in found} >= {"pi p/E_star on the surface", "S0 + D0 of a point load F far away"}
