"""The choice among the variants of an evaluation form, by counted cost and measured error, the same everywhere."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest

import axicontact
from axiderive import index
from axiderive.contact.normal import derive
from axiderive.contact.systems import problem
from axiderive.emit.plane import module_source
from axiderive.emit.selected import forms
from axiderive.emit.variants import written
from axiderive.entry import Entry
from axiderive.profiles import load
from axiderive.show import _entry_text
from axiderive.stable import chosen
from axiderive.stable.closure import closure
from axiderive.stable.cost import POWER, cost
from axiderive.stable.drift import better, drift, settled
from axiderive.stable.records import record
from axiderive.stable.selection import TOLERANCE
from axiderive.stable.slopes import RATE, rate
from axiderive.stable.variants import FULL
from axiderive.stable.written import Written, modules

ROOT = Path(axicontact.__file__).parents[1]
RUNTIME = {str(path.relative_to(ROOT)): path.read_text() for path in (ROOT / "axicontact").glob("_*.py")}


def cone() -> tuple[dict[str, Entry], dict[str, str]]:
    entries = derive(load("truncated_cone"))
    path = "axicontact/normal/truncated_cone.py"
    return entries, RUNTIME | {path: (ROOT / path).read_text()}


def selected(own: dict[str, Sequence[Written]]) -> dict[str, Any]:
    entries, sources = cone()
    others = modules(own)
    texts = closure(sources | others, "axicontact/normal/truncated_cone.py", *others)
    return record("truncated_cone", texts, entries, ["d"], variants=own)["d"]


@cache
def strips(name: str) -> tuple[dict[str, Entry], dict[str, tuple[Written, ...]]]:
    entries = problem(f"plane.{name}").derive()
    return entries, written(entries)


def selected_strip(name: str, suffix: str, *more: Written) -> dict[str, Any]:
    """What is recorded of one function of a plane contact, with planted variants."""
    entries, own = strips(name)
    path = f"axicontact/plane/{name}.py"
    some = {suffix: (*own[suffix], *more)}
    others = modules(some)
    texts = closure(RUNTIME | {path: module_source(entries)} | others, path, *others)
    asked = "P" if suffix == RATE.suffix else suffix
    return record(f"plane.{name}", texts, entries, [asked], variants=some)[suffix]


def test_a_plane_form_is_chosen_too(monkeypatch: pytest.MonkeyPatch) -> None:
    """A wrong load of a rounded wedge is not, whatever it costs; where all rules stand, the frozen form is found."""
    _, own = strips("rounded_wedge")
    for line, wrong in (("root + a**2 * angle / b", "root + a**2 * angle / a"), (") / 2\n", ") / 4\n")):
        planted = replace(own["P"][0], variant="wrong", source=own["P"][0].source.replace(line, wrong), cost=1)
        assert planted.source != own["P"][0].source
        assert "better" not in selected_strip("rounded_wedge", "P", planted)["selection"]
    monkeypatch.setitem(own, "P", own["P"][1::-1])
    assert [one.variant for one in own["P"]] == ["all rules", "angles of quotients"]
    assert selected_strip("rounded_wedge", "P")["selection"]["better"] == "angles of quotients"


def test_the_rate_of_growth_is_chosen_by_itself() -> None:
    """All rules call it; with a wrong coefficient it loses."""
    row = selected_strip("rounded_wedge", RATE.suffix)
    assert row["selection"]["chosen"]["form"] == "angles of quotients"
    assert "better" not in row["selection"]
    assert row["extreme"]["worst_ulp"] <= TOLERANCE
    (own, *_) = strips("rounded_wedge")[1][RATE.suffix]
    wrong = replace(
        own, variant="wrong", source=own.source.replace("(theta) / b * t * angle", "(theta) / b * t"), cost=1
    )
    assert wrong.source != own.source
    assert "better" not in selected_strip("rounded_wedge", RATE.suffix, wrong)["selection"]


def test_a_rule_below_and_a_closed_form_beyond() -> None:
    """The form loses its digits next to the break, the rule takes more and more nodes; where they meet is measured."""
    row = selected_strip("truncated_wedge", "d")
    assert row["selection"]["chosen"]["form"] == "angles of quotients, beyond 128 b"
    assert "better" not in row["selection"]
    assert row["extreme"]["worst_ulp"] <= TOLERANCE
    own = strips("truncated_wedge")[1]["d"]
    alone = {one.variant: one for one in own}
    assert forms_of(own[0], alone["angles of quotients"])["extreme"]["worst_ulp"] > 10 * TOLERANCE
    assert forms_of(own[0], alone["all rules"])["extreme"]["worst_ulp"] <= TOLERANCE
    source = own[0].source.replace("a < 128.0 * b", "a < 1.00001 * b")
    assert source != own[0].source
    early = forms_of(own[0], replace(own[0], variant="too early", source=source, cost=own[0].cost + 1))
    assert early["bench"]["worst_ulp"] > 2 * TOLERANCE


def forms_of(*own: Written) -> dict[str, Any]:
    """The errors of the second of two forms of the depth of a truncated wedge."""
    entries, _ = strips("truncated_wedge")
    path = "axicontact/plane/truncated_wedge.py"
    others = modules({"d": own})
    texts = closure(RUNTIME | {path: module_source(entries)} | others, path, *others)
    found: dict[str, Any] = record("plane.truncated_wedge", texts, entries, ["d"], variants={"d": own})["d"]
    return dict(found["selection"]["runner_up"])


def test_planted_variants_of_a_real_function() -> None:
    """The depth of a truncated cone: half of it costs less, and so would the same text."""
    entries, _ = cone()
    own = written(entries, ["d"])["d"]
    assert [one.variant for one in own] == ["angles of quotients", "all rules", "without angles"]
    half = own[0].source.replace("return np.tan", "return 0.5 * np.tan")
    wrong = replace(own[0], variant="half", source=half, cost=1)
    assert wrong.source != own[0].source
    row = selected({"d": (*own, wrong)})
    assert "better" not in row["selection"]
    assert row["selection"]["runner_up"]["form"] == "all rules"
    assert row["selection"]["runner_up"]["extreme"]["worst_ulp"] <= TOLERANCE
    same = selected({"d": (*own, replace(own[0], variant="same", cost=1))})
    assert same["selection"]["better"] == "same"
    assert "`same` (cost 1) would be chosen, not `angles of quotients`" in better(same["selection"])
    assert selected({"d": (*own, wrong)}) == row


def test_the_choice_is_measured_anew(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where nothing is frozen, measurement finds what is."""
    monkeypatch.setattr(chosen, "CHOSEN", {})
    entries, _ = cone()
    row = selected({"d": written(entries, ["d"])["d"]})
    assert row["selection"]["chosen"]["form"] == FULL.name
    assert row["selection"]["better"] == "angles of quotients"


def test_frozen_choices_are_functions_and_variants() -> None:
    for key in chosen.CHOSEN:
        name, _, suffix = key.rpartition(".")
        entries = problem(name).derive()
        assert suffix in entries or suffix == RATE.suffix and rate(entries) is not None
        assert chosen.chosen(key) is not FULL


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


def test_drift_of_a_choice() -> None:
    entries, _ = cone()
    now = {"d": selected({"d": written(entries, ["d"])["d"]})}
    assert drift(now, now) == []
    before = {"d": {name: value for name, value in now["d"].items() if name != "selection"}}
    assert drift(before, now) == [("d", "the choice of its form is not recorded; run axicontact build")]
    assert settled(before, now) == now
    worse = json.loads(json.dumps(now))
    worse["d"]["selection"]["better"] = "roots alone"
    ((_, sentence),) = drift(now, worse)
    assert "would be chosen" in sentence
    other = json.loads(json.dumps(now))
    other["d"]["selection"]["chosen"]["cost"] += 1
    assert len(drift(other, now)) == 1
    assert forms(now["d"])[1].startswith("not all rules, cost 17, at most ")
    assert forms(before["d"]) == []


def test_show_prints_both_forms() -> None:
    found = index.load()
    (entry,) = found.select("truncated_cone.d")
    text = _entry_text({**entry, "forms": ["angles of quotients, cost 13", "not all rules, cost 17"]}, brief=False)
    assert "computed  angles of quotients, cost 13\n            not all rules, cost 17" in text
    assert "computed" not in _entry_text({**entry, "forms": []}, brief=False)
