"""Error against run time of what a rule evaluates: what is measured, and how."""

from __future__ import annotations

import json
from importlib import import_module
from typing import Any

import numpy as np
import pytest
from stored_book import CATALOGUE, PROFILES, evidence

from axiderive.physics.systems import problem, problems
from axiderive.study import report as pairs
from axiderive.study.error import Plan, arguments, methods, with_nodes
from axiderive.study.subject import NORMAL, RULED, subject

RECORD: dict[str, Any] = json.loads((CATALOGUE / "evidence" / "study" / "error.json").read_bytes())
MEASURED = {row["key"] for row in RECORD["rows"]}
SAMPLE = ("rounded_cone", "hyperboloid", "ellipsoid", "gaussian", "cone.fgm", "truncated_cone.fgm", "plane.power_law")


def test_every_normal_contact_that_a_rule_evaluates_is_measured() -> None:
    """By what the build measured of its functions, not by the list of the study."""
    found = {}
    for name in (name for name in PROFILES if problem(name).system.name == "normal"):
        forms = {suffix: one.get("form") for suffix, one in evidence(name).get("evaluation", {}).items()}
        suffixes = [suffix for suffix in ("p", "w") if forms.get(suffix) == "rule"]
        # the force of a concave face is a closed formula behind a bound that rests on a rule
        suffixes += ["Fd"] if forms.get("F") == "rule" and subject(name).profile.contact == "compact" else []
        if suffixes:
            found[name] = tuple(suffixes)
    assert found == NORMAL, (
        "study.subject.NORMAL names what is measured; add the profile, and its parameters to FURTHER"
    )
    assert {f"{name}.{suffix}" for name in RULED for suffix in RULED[name]} <= MEASURED
    assert all(row["lost"] == 0 for row in RECORD["rows"] if row["method"] == "emitted")


def test_every_other_contact_whose_pressure_a_rule_evaluates_is_measured() -> None:
    """By what the modules say of themselves."""
    other = []
    for one in problems():
        if one.system.name in ("graded.normal", "plane"):
            function = import_module(f"{one.system.package}.{one.name}").pressure
            if "as an integral over the growing contact" in " ".join(function.__doc__.split()):
                other.append(one.key)
    assert set(other) <= set(RULED) - set(NORMAL)


@pytest.mark.parametrize("name", SAMPLE)
def test_a_rule_of_as_many_nodes_is_that_of_the_catalogue(name: str) -> None:
    """With its own number of nodes it gives the values of the function; with few it does not."""
    suffix = RULED[name][0]
    x = arguments(subject(name), suffix, 6)
    plan = Plan(6, 6, 2, 1, bem=(), longest=np.inf)  # not fewer points on a machine that is busy
    found = {one.name + one.setting: one for one in methods(subject(name), suffix, plan)}
    own = np.asarray(found["emitted"].run())
    assert np.allclose(found["generated ruleN = 64"].run(), own, rtol=5e-15, atol=0)
    assert np.max(np.abs(np.asarray(found["generated ruleN = 8"].run()) / own - 1)) > 1e-14
    # nothing of it stays behind
    assert np.array_equal(found["emitted"].run(), own)
    assert len(x) == len(own)


def test_nodes_are_put_back_after_an_error() -> None:
    from axicontact._runtime import integrals

    before = integrals.integral, integrals.FEW

    def refuses(x: Any) -> Any:
        assert before[1] != integrals.FEW
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        with_nodes(refuses, np.ones(2), 8)
    assert (integrals.integral, integrals.FEW) == before


def test_a_pair_is_the_ratio_of_its_times(monkeypatch: pytest.MonkeyPatch) -> None:
    """On a clock that each call moves by its own time: the second one is a hundred times as long."""
    now = [0.0]
    monkeypatch.setattr(pairs.time, "process_time", lambda: now[0])

    def takes(span: float) -> Any:
        return lambda: now.__setitem__(0, now[0] + span)

    assert pairs.paired(takes(1.0), takes(0.01), 5) == pytest.approx(100)
    assert pairs.paired(takes(1e-3), takes(2e-3), 5) == pytest.approx(0.5)
