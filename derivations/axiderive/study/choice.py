"""Which of the variants of a function the catalogue takes: the cheapest that keeps its digits, by measurement.

Cost is counted, errors are measured against Arb: at the points of the record, and what would win at fresh ones too.
The variant that is chosen now stays unless another is better by a margin that no library of a machine explains.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from ..stable.measure import Sample, ulps

TOLERANCE, MARGIN = 5.0, 1.0
"""Units of the last place: what a function may err, and how far that moves between processors."""
FACTOR = 3.0
"""Where nothing keeps the tolerance another variant must be more accurate by this, and by the margin."""
CHEAPER = 0.9
"""The share of the cost that another variant may have at most: weights are no better than that."""
FEW, MANY = (20, 4711), (300, 1234)
"""Points in either domain and their seeds, at which a variant must keep its digits before it is taken."""
FIRST = 5
"""Of the recorded points in either domain, at which most rivals lose."""
Points = Mapping[str, Sequence[Sample]]
"""Calls and exact values by domain."""
Draw = Callable[[int, int], Points]
"""Points by their number and seed."""


@dataclass
class Candidate:
    """A variant of one function."""

    variant: str
    formula: str
    cost: int
    call: Callable[[Sample], float]
    """The value at a point."""
    worst: float = 0.0
    """Of all points so far, in units of the last place; infinite if a value was lost."""
    errors: dict[str, list[float]] = field(default_factory=dict)
    """By domain, at the points that are recorded."""

    def measure(self, points: Points) -> dict[str, list[float]]:
        return self.met(
            {domain: [ulps(self.call(point), point.exact) for point in some] for domain, some in points.items()}
        )

    def met(self, errors: dict[str, list[float]]) -> dict[str, list[float]]:
        self.worst = max(self.worst, *(error for some in errors.values() for error in some), 0.0)
        return errors

    def keeps(self, tolerance: float) -> bool:
        return self.worst <= tolerance


def choose(candidates: Sequence[Candidate], given: Points, draw: Draw) -> tuple[Candidate, Candidate | None]:
    """The best of some candidates and the next best; the first of them is the one chosen so far.

    Parameters
    ----------
    candidates : sequence of Candidate
        All without errors, the first may have its own.
    given : mapping
        The points whose errors are recorded: most candidates lose here, where the exact values are known anyway.
    draw : callable
        Fresh points by their number and seed, for those that do not: a few, then many.
    """
    standing, *others = candidates
    if not others or not any(given.values()):
        return standing, None
    standing.errors = standing.met(standing.errors) if standing.errors else standing.measure(given)
    measured = list(_measured(sorted(others, key=_cost), standing, given))
    rivals = sorted((rival for rival in measured if _wins(rival, standing)), key=_merit)
    best = next((rival for rival in rivals if _confirmed(rival, standing, draw)), standing)
    if best is not standing or not any(rival.keeps(TOLERANCE) for rival in measured):
        _complete(others, given)
        measured = others
    return best, min((candidate for candidate in (standing, *measured) if candidate is not best), key=_merit)


def _cost(candidate: Candidate) -> int:
    return candidate.cost


def _measured(others: Sequence[Candidate], standing: Candidate, given: Points) -> Iterator[Candidate]:
    """Those that may win or come second, in the order of their cost, with all errors.

    What errs too much at a few points can do neither, unless the standing one errs too; nor can what costs as much as
    that and more than one that keeps its digits.
    """
    second = math.inf
    for other in others:
        if other.cost > max(second, CHEAPER * standing.cost) and standing.keeps(TOLERANCE + MARGIN):
            return
        if standing.keeps(TOLERANCE + MARGIN):
            other.errors = other.measure({domain: some[:FIRST] for domain, some in given.items()})
            if not other.keeps(TOLERANCE):
                continue
        _complete([other], given)
        if other.keeps(TOLERANCE):
            second = min(second, other.cost)
        yield other


def _complete(others: Sequence[Candidate], given: Points) -> None:
    """Measure what has not been measured."""
    for other in others:
        left = {domain: some[len(other.errors.get(domain, ())) :] for domain, some in given.items()}
        found = other.measure(left)
        other.errors = {domain: [*other.errors.get(domain, ()), *errors] for domain, errors in found.items()}


def _confirmed(rival: Candidate, standing: Candidate, draw: Draw) -> bool:
    """Whether a rival wins at further points too."""
    for sample in (FEW, MANY):
        points = draw(*sample)
        rival.measure(points)
        standing.measure(points)
        if not any(points.values()) or not _wins(rival, standing):
            return False
    return True


def _merit(candidate: Candidate) -> tuple[bool, float, float, str]:
    """Ascending: the cheapest within the tolerance, then the most accurate."""
    if candidate.keeps(TOLERANCE):
        return False, candidate.cost, candidate.worst, candidate.variant
    return True, candidate.worst, candidate.cost, candidate.variant


def _wins(rival: Candidate, standing: Candidate) -> bool:
    """Whether a rival is better by the margins."""
    if rival.keeps(TOLERANCE - MARGIN):
        return rival.cost <= CHEAPER * standing.cost or not standing.keeps(TOLERANCE + MARGIN)
    return not standing.keeps(TOLERANCE + MARGIN) and FACTOR * rival.worst + MARGIN < standing.worst
