"""The race of evaluation forms: a wrong form loses whatever it costs, and what is frozen wins."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest

import axicontact
from axiderive.entry import Entry
from axiderive.physics.normal import derive
from axiderive.physics.systems import problem
from axiderive.profiles import load
from axiderive.stable import variants
from axiderive.stable.slopes import RATE, rate
from axiderive.stable.variants import FULL
from axiderive.study.forms import POWER, TOLERANCE, Written, cost, race, text, written

ROOT = Path(axicontact.__file__).parents[1]
PACKAGE = {str(path.relative_to(ROOT)): path.read_text() for path in (ROOT / "axicontact").rglob("*.py")}


@cache
def forms_of(key: str) -> tuple[dict[str, Entry], dict[str, tuple[Written, ...]]]:
    entries = problem(key).derive()
    return entries, written(entries)


def raced(key: str, suffix: str, own: Sequence[Written]) -> dict[str, Any]:
    """What is said of one function with these forms."""
    found = race(key, PACKAGE, forms_of(key)[0], {suffix: own})[suffix]
    assert found["chosen"]["form"] == own[0].variant
    return found


def altered(one: Written, before: str, after: str, cost: int = 1) -> Written:
    """A form with another text that pretends to cost next to nothing."""
    wrong = replace(one, variant="wrong", source=one.source.replace(before, after), cost=cost)
    assert wrong.source != one.source
    return wrong


@pytest.mark.parametrize(
    ("key", "suffix", "before", "after"),
    [
        ("truncated_cone", "d", "return np.tan", "return 0.5 * np.tan"),
        pytest.param("plane.rounded_wedge", "P", ") / 2\n", ") / 4\n", marks=pytest.mark.slow),
        pytest.param("plane.rounded_wedge", RATE.suffix, "/ b * t * angle", "/ b * t", marks=pytest.mark.slow),
        pytest.param("loads.punch", "w", "2 * p_0", "3 * p_0", marks=pytest.mark.slow),
    ],
)
def test_a_wrong_form_loses_whatever_it_costs(key: str, suffix: str, before: str, after: str) -> None:
    own = forms_of(key)[1][suffix]
    assert own[0].variant == variants.chosen(f"{key}.{suffix}").name
    row = raced(key, suffix, (*own, altered(own[0], before, after)))
    assert "better" not in row
    assert row["runner_up"]["form"] != "wrong"


def test_the_same_for_less_wins() -> None:
    own = forms_of("truncated_cone")[1]["d"]
    assert [one.variant for one in own] == ["angles of quotients", "all rules", "without angles"]
    row = raced("truncated_cone", "d", (*own, replace(own[0], variant="same", cost=1)))
    assert row["better"] == "same"
    assert "name `same` in CHOSEN" in text({"problems": {"truncated_cone": {"d": row}}})


def test_what_is_frozen_is_found_again() -> None:
    own = forms_of("truncated_cone")[1]["d"]
    assert raced("truncated_cone", "d", own[1::-1])["better"] == own[0].variant == "angles of quotients"


@pytest.mark.slow
def test_a_rule_below_and_a_closed_form_beyond() -> None:
    """The form loses its digits next to the break, the rule takes more and more nodes; where they meet is measured."""
    key, suffix = "plane.truncated_wedge", "d"
    own = forms_of(key)[1][suffix]
    alone = {one.variant: one for one in own}
    assert own[0].variant == "angles of quotients, beyond 128 b"
    assert "better" not in raced(key, suffix, own)

    def beside(other: Written, domain: str = "extreme") -> float:
        return float(raced(key, suffix, (own[0], other))["runner_up"][domain]["worst_ulp"])

    assert beside(alone["angles of quotients"]) > 10 * TOLERANCE
    assert beside(alone["all rules"]) <= TOLERANCE
    assert beside(altered(own[0], "a < 128.0 * b", "a < 1.00001 * b", own[0].cost + 1), "bench") > 2 * TOLERANCE


def test_frozen_choices_are_functions_and_variants() -> None:
    for key in variants.CHOSEN:
        name, _, suffix = key.rpartition(".")
        entries = problem(name).derive()
        assert suffix in entries or suffix == RATE.suffix and rate(entries) is not None
        assert variants.chosen(key) is not FULL


def test_the_cost_of_a_body() -> None:
    """Per value: what stands alone costs nothing, a root three products, a rule the integrand at each node."""
    source = """
def _slope(t, R):
    return 2 * t / R

def _depth(a, R, theta):
    scale = np.tan(theta) / R**3
    root = np.sqrt((R - a) * (R + a))
    return scale * root * a

def _force(a, R):
    return R * force_integral(lambda t: _slope(t, R), a, 8)

def _moments(a):
    return a**3 + a**4 + a**8
"""
    assert cost(source, "_depth", ["a"]) == 1 + 1 + 1 + 3 + 2
    assert cost(source, "_depth", ["a", "theta"]) == cost(source, "_depth", ["a"]) + 5 + 1
    assert cost(source, "_force", ["a"]) == 8 * 2 + 1
    assert cost(source, "_moments", ["a"]) == 2 + 2 + POWER + 2


def test_every_variant_has_its_text() -> None:
    """A variant that changed nothing anywhere would be measured for nothing."""
    found = {
        one.variant
        for name in ("rounded_punch", "rounded_cone")
        for some in written(derive(load(name))).values()
        for one in some
    }
    assert found == {
        "all rules", "angles of quotients", "expanded sums", "expanded sums without lengths", "roots alone",
        "without angles", "without conjugates", "without gaps", "without lengths",
    }  # fmt: skip
