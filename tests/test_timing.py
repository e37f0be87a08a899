"""Error against run time on the pages of the profiles: what is measured, what is drawn, what is said of it."""

from __future__ import annotations

import json
import math
import re
from importlib import import_module
from typing import Any

import numpy as np
import pytest
from stored_book import CATALOGUE, PROFILES, evidence

from axiderive.book.study.error import METHODS
from axiderive.book.study.timing import GOAL, REACHED, Timing, timing
from axiderive.figures.svg import Picture
from axiderive.physics.systems import problem, problems
from axiderive.study import report as pairs
from axiderive.study.error import Plan, arguments, methods, with_nodes
from axiderive.study.subject import NORMAL, RULED, subject
from axiderive.web import study

RECORD: dict[str, Any] = json.loads((CATALOGUE / "evidence" / "study" / "error.json").read_bytes())
MEASURED = {row["key"] for row in RECORD["rows"]}
MEASURED_BY = {row["method"] for row in RECORD["rows"]}
SAMPLE = ("rounded_cone", "hyperboloid", "ellipsoid", "gaussian", "cone.fgm", "truncated_cone.fgm", "plane.power_law")
PAGES = tuple(dict.fromkeys(problem(name).profile_id for name in RULED))


def keys_of(page: str) -> list[str]:
    """The formulas of a page that a rule evaluates, as far as they are measured."""
    own = [f"{name}.{suffix}" for name in RULED if problem(name).profile_id == page for suffix in RULED[name]]
    return [key for key in own if key in MEASURED]


SHOWN = tuple(page for page in PAGES if keys_of(page))


def timing_of(name: str, record: dict[str, Any] = RECORD) -> Timing:
    found = timing(record, keys_of(name))
    assert found is not None
    return found


def said_of(name: str, record: dict[str, Any] = RECORD) -> dict[str, str]:
    """The sentence on each formula of a page, by its key."""
    found = [sentence for strip in timing_of(name, record).strips for sentence in strip.sentences]
    return dict(zip(keys_of(name), found, strict=True))


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


NUMBER = re.compile(r"(\d[\d.\\,]*)(?:\\times10\^\{(-?\d+)\})?")


def _number(tex: str) -> float:
    match = NUMBER.fullmatch(tex)
    assert match, tex
    return float(f"{match[1].replace(chr(92) + ',', '')}e{match[2] or 0}")


@pytest.mark.parametrize("name", SHOWN)
def test_what_is_said_follows_from_what_was_measured(name: str) -> None:
    """The error and the points of the function, the nodes that are enough, and how long the fastest other way takes."""
    drawn = {letter for letter, _ in timing_of(name).methods}
    for key, sentence in said_of(name).items():
        rows = [row for row in RECORD["rows"] if row["key"] == key and row["worst"] is not None and not row["lost"]]
        own = next(row for row in rows if row["method"] == "emitted")
        error, points = re.findall(r"worst error \$([^$]+)\$ at (\d+) points", sentence)[0]
        assert (_number(error), int(points)) == (pytest.approx(own["worst"], rel=0.05), own["points"])
        nodes = [int(row["setting"].removeprefix("N = ")) for row in rows
                 if row["method"] == "generated rule" and row["worst"] <= REACHED]  # fmt: skip
        assert re.findall(r"(\d+) nodes of the rule reach", sentence) == [str(min(nodes))] * bool(nodes)
        others = [row for row in rows if METHODS[row["method"]].sentence and row["worst"] <= GOAL]
        others = [row for row in others if _letter(row["method"]) in drawn]
        taken = re.findall(r"takes \$([^$]+)\$ (times as long|of the time)\.", sentence)
        assert len(taken) == bool(others)
        for number, words in taken:
            best = min(others, key=lambda row: float(row["ratio"]))
            assert _number(number) == pytest.approx(best["ratio"], rel=0.1)
            assert (words == "of the time") == (best["ratio"] < 1)
            assert METHODS[best["method"]].sentence.partition(" {}")[0] in sentence


@pytest.mark.parametrize("name", SHOWN)
def test_a_letter_means_the_method_that_is_drawn_with_it(name: str) -> None:
    shown = [method for method, words in METHODS.items() if words.page and method in MEASURED_BY]
    methods = {_letter(method): method for method in shown}
    for letter, words in timing_of(name).methods:
        assert words.startswith(METHODS[methods[letter]].page.partition("{}")[0])


def test_a_formula_that_nothing_else_reaches_says_so() -> None:
    own = ("emitted", "generated rule")
    rows = [row if row["method"] in own else row | {"worst": 2 * GOAL} for row in RECORD["rows"]]
    found = timing_of("rounded_punch", {"rows": rows})
    said = [sentence for strip in found.strips for sentence in strip.sentences]
    assert all("No other way shown reaches $10^{-12}$." in sentence for sentence in said)


def test_a_method_that_lost_a_value_is_not_the_fastest() -> None:
    best = min(
        (row for row in RECORD["rows"] if row["key"] == "ellipsoid.w" and row["worst"] <= GOAL),
        key=lambda row: float(row["ratio"]) if row["method"] not in ("emitted", "generated rule") else math.inf,
    )
    rows = [row | {"lost": 1} if row is best else row for row in RECORD["rows"]]
    (changed, *others), (before, *rest) = timing_of("ellipsoid", {"rows": rows}).strips, timing_of("ellipsoid").strips
    assert changed.sentences != before.sentences
    assert others == rest


@pytest.mark.parametrize("name", SHOWN)
def test_the_panels_are_what_was_measured(name: str) -> None:
    found = timing_of(name)
    web = study.timing(RECORD, keys_of(name))
    assert web is not None
    assert web["sentences"] == [sentence for strip in found.strips for sentence in strip.sentences]
    letters = {letter for letter, _ in found.methods}
    panels = [(strip.figure, panel) for strip in found.strips for panel in strip.figure.panels]
    assert [panel.key for _, panel in panels] == keys_of(name)
    for (figure, panel), shown in zip(panels, web["panels"], strict=True):
        (x0, low), (x1, high) = figure.xticks[0], figure.xticks[-1]
        rows = [row for row in RECORD["rows"] if row["key"] == panel.key]
        points = [point for line in panel.lines for point in line.points]
        drawn = {line.letter for line in panel.lines}
        assert drawn <= letters
        measured = [(row["ratio"], row["worst"]) for row in rows if _letter(row["method"]) in drawn and row["worst"]]
        assert len(points) == len(measured)
        for (x, y), (ratio, worst) in zip(points, measured, strict=True):
            assert low + (x - x0) * (high - low) / (x1 - x0) == pytest.approx(math.log10(ratio), abs=0.02)
            assert y / figure.height * 16 - 16 == pytest.approx(max(math.log10(worst), -15.95459), abs=1e-5)
        assert _dots(shown) == len(points)


def _letter(method: str) -> str:
    methods = list(dict.fromkeys(row["method"] for row in RECORD["rows"] if row["worst"] is not None))
    return chr(ord("a") + methods.index(method))


def _dots(figure: Picture) -> int:
    return sum(element == "circle" for element, _, _ in figure.above)
