"""Which of several forms is chosen, by planted ones of known cost and error."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import permutations

import pytest
from flint import arb

from axiderive.stable.measure import Sample
from axiderive.study.forms import FIRST, MARGIN, TOLERANCE, Candidate, Points, choose

UNIT = 2.0**-52
WRONG_HERE = 1.75
"""The number of the points at which a planted formula loses its digits."""


def points(*numbers: float) -> Points:
    """Exact values half way between two doubles."""
    return {"bench": [Sample((), {}, arb(x) + UNIT / 2, {"x": x}) for x in numbers]}


def candidate(name: str, cost: int, units: float, elsewhere: float | None = None) -> Candidate:
    """It errs by so many units, a whole number and a half, at WRONG_HERE by others."""

    def call(point: Sample) -> float:
        x: float = point.values["x"]
        return x + UNIT * (0.5 + (units if elsewhere is None or x != WRONG_HERE else elsewhere))

    return Candidate(name, name, cost, call)


def chosen_of(*candidates: Candidate, given: Points | None = None) -> tuple[str, str]:
    best, second = choose(candidates, given or points(1.25, 1.5), lambda count, seed: points(1.25, WRONG_HERE))
    assert second is not None
    return best.variant, second.variant


def test_a_cheaper_form_that_keeps_its_digits_is_chosen() -> None:
    assert chosen_of(candidate("now", 20, 2.5), candidate("cheap", 10, 2.5)) == ("cheap", "now")
    assert chosen_of(candidate("now", 20, 2.5), candidate("dear", 30, 0.5)) == ("now", "dear")
    # no weight is known to a tenth
    assert chosen_of(candidate("now", 20, 2.5), candidate("hardly", 19, 2.5)) == ("now", "hardly")


@pytest.mark.parametrize("lost", [10.0, 1e9, float("inf"), float("nan")])
def test_a_cheaper_form_that_is_wrong_is_not(lost: float) -> None:
    """Wherever it is wrong: at the recorded points, or only at those that are drawn to confirm it."""
    given = points(1.25, WRONG_HERE)
    assert chosen_of(candidate("now", 20, 2.5), candidate("wrong", 1, 0.5, lost), given=given)[0] == "now"
    assert chosen_of(candidate("now", 20, 2.5), candidate("wrong", 1, 0.5, lost))[0] == "now"


def test_the_most_accurate_where_nothing_keeps_the_tolerance() -> None:
    assert chosen_of(candidate("now", 5, 1e6), candidate("better", 90, 40))[0] == "better"
    assert chosen_of(candidate("now", 5, 60), candidate("hardly", 5, 40))[0] == "now"


def test_a_unit_of_a_library_changes_nothing() -> None:
    """Both ways: what is chosen may err a unit more, and what is not chosen a unit less."""
    middle = TOLERANCE - MARGIN / 2
    assert chosen_of(candidate("now", 20, 2.5), candidate("cheap", 10, middle))[0] == "now"
    assert chosen_of(candidate("now", 20, TOLERANCE + MARGIN / 2), candidate("dear", 30, 1.5))[0] == "now"
    # a frozen choice is not given up again for the form it was better than
    assert chosen_of(candidate("cheap", 10, middle), candidate("before", 20, 2.5))[0] == "cheap"


def test_the_order_of_the_others_is_none() -> None:
    rivals: Sequence[Callable[[], Candidate]] = (
        lambda: candidate("a", 10, 2.5),
        lambda: candidate("b", 10, 1.5),
        lambda: candidate("c", 2, 80.5),
        lambda: candidate("d", 12, 0.5),
    )
    found = {chosen_of(candidate("now", 20, 2.5), *(make() for make in some)) for some in permutations(rivals)}
    assert found == {("b", "a")}


def test_dear_rivals_are_not_measured() -> None:
    """Nor what is wrong at the first points, unless nothing else comes second."""
    called: list[str] = []

    def counted(name: str, cost: int, units: float, elsewhere: float | None = None) -> Candidate:
        own = candidate(name, cost, units, elsewhere)
        inner = own.call
        own.call = lambda point: called.append(name) or inner(point)  # type: ignore[func-returns-value]
        return own

    numbers = [1.25 + i / 64 for i in range(30)]
    rivals: Sequence[Candidate] = (
        counted("cheap and wrong", 2, 50.5),
        counted("next", 21, 2.5),
        counted("dear", 22, 0.5),
    )
    assert chosen_of(candidate("now", 20, 2.5), *rivals, given=points(*numbers)) == ("now", "next")
    assert {name: called.count(name) for name in set(called)} == {"cheap and wrong": FIRST, "next": 30}
    called.clear()
    rivals = (counted("cheap and wrong", 2, 50.5), counted("worse", 1, 80.5))
    assert chosen_of(candidate("now", 20, 2.5), *rivals, given=points(*numbers)) == ("now", "cheap and wrong")
    assert called.count("cheap and wrong") == called.count("worse") == 30
