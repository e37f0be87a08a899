"""The race of evaluation forms: a wrong form loses however quick it is, and what is frozen wins."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest

import axicontact
from axiderive.cli import main
from axiderive.entry import Entry
from axiderive.physics.systems import problem
from axiderive.stable import variants
from axiderive.stable.records import TOLERANCE
from axiderive.stable.slopes import RATE, rate
from axiderive.stable.variants import FULL, SPLITS, VARIANTS
from axiderive.study.forms import MARGIN, QUICKER, Written, better, race, written

ROOT = Path(axicontact.__file__).parents[1]
PACKAGE = {str(path.relative_to(ROOT)): path.read_text() for path in (ROOT / "axicontact").rglob("*.py")}


@cache
def forms_of(key: str) -> tuple[dict[str, Entry], dict[str, tuple[Written, ...]]]:
    entries = problem(key).derive()
    return entries, written(entries)


def raced(key: str, suffix: str, own: Sequence[Written]) -> list[dict[str, Any]]:
    """What is said of these forms of one function."""
    found = race(key, PACKAGE, forms_of(key)[0], {suffix: own})[suffix]
    assert [row["form"] for row in found] == [one.variant for one in own]
    assert found[0]["time"] == pytest.approx(1.0, rel=0.5)
    return found


def altered(one: Written, before: str, after: str) -> Written:
    """A form with another text."""
    wrong = replace(one, variant="wrong", source=one.source.replace(before, after))
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
def test_a_wrong_form_loses_however_quick_it_is(key: str, suffix: str, before: str, after: str) -> None:
    own = forms_of(key)[1][suffix]
    assert own[0].variant == variants.chosen(f"{key}.{suffix}").name
    rows = raced(key, suffix, (own[0], altered(own[0], before, after)))
    assert rows[0]["worst"] <= TOLERANCE < 1e6 < rows[1]["worst"]
    assert better([rows[0], rows[1] | {"time": 0.01}]) is None


def row(form: str, worst: float | None, time: float) -> dict[str, Any]:
    return {"form": form, "worst": worst, "time": time}


def test_what_is_better() -> None:
    """The quickest of those that keep their digits, and no unit of a library or tenth of a time changes anything."""
    now = row("now", 2.5, 1.0)
    assert better([now, row("quick", 2.5, 0.6), row("quicker", 2.0, 0.5), row("wrong", 80.0, 0.1)]) == "quicker"
    assert better([now, row("hardly", 2.5, QUICKER + 0.05), row("lost", None, 0.1)]) is None
    assert better([now, row("near", TOLERANCE - MARGIN / 2, 0.5)]) is None
    # where the frozen one loses its digits any that keeps them is
    assert better([row("now", TOLERANCE + MARGIN / 2, 1.0), row("dear", 1.5, 3.0)]) is None
    assert better([row("now", 60.0, 1.0), row("dear", 1.5, 3.0)]) == "dear"
    assert better([row("now", None, 1.0), row("dear", 1.5, 3.0)]) == "dear"


@pytest.mark.slow
def test_a_rule_below_and_a_closed_form_beyond() -> None:
    """The form loses its digits next to the break, the rule takes more and more nodes; where they meet is measured."""
    own = forms_of("plane.truncated_wedge")[1]["d"]
    assert own[0].variant == "angles of quotients, beyond 128 b"
    late = altered(own[0], "a < 128.0 * b", "a < 1.00001 * b")
    worst = {one["form"]: one["worst"] for one in raced("plane.truncated_wedge", "d", (*own, late))}
    assert max(worst[own[0].variant], worst["all rules"]) <= TOLERANCE
    assert min(worst["angles of quotients"], worst["wrong"]) > 2 * TOLERANCE


def test_the_command_prints_the_forms(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["study", "forms", "--quick", "--only", "truncated_cone"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].split() == ["key", "form", "worst", "time", "verdict"]
    assert lines[1].split()[:4] == ["truncated_cone.d", "angles", "of", "quotients"]


def test_frozen_choices_are_functions_and_variants() -> None:
    for key in variants.CHOSEN:
        name, _, suffix = key.rpartition(".")
        entries = problem(name).derive()
        assert suffix in entries or suffix == RATE.suffix and rate(entries) is not None
        assert variants.chosen(key) is not FULL


def test_every_variant_has_its_text() -> None:
    """A variant that changed nothing anywhere would be measured for nothing."""
    found = {
        one.variant
        for name in ("rounded_punch", "rounded_cone", "plane.truncated_wedge")
        for some in forms_of(name)[1].values()
        for one in some
    }
    assert found == {variant.name for variant in (*VARIANTS, *SPLITS)}
