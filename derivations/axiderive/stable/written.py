"""The variants of a function as emitted modules, how they are called, and what is recorded of the choice among them."""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from importlib import import_module
from typing import Any

from .. import notation as nt
from ..entry import Entry
from ..letters import name_of
from .measure import Sample, count_for, samples
from .samples import DOMAINS, Floats
from .selection import Candidate, Points, choose

Record = dict[str, Any]
Summary = Callable[[list[float]], Record]


@dataclass(frozen=True)
class Written:
    """One function in one variant."""

    variant: str
    source: str
    """A module that holds it, its other functions in the chosen variants."""
    function: str
    formula: str
    cost: int
    system: str = "normal"
    """Whose package the module belongs to."""


Variants = Mapping[str, Sequence[Written]]
"""The distinct variants of functions by suffix, the chosen one first."""


def modules(variants: Variants) -> dict[str, str]:
    """The texts by path, where there is something to choose from."""
    return {
        f"axicontact/{written.system}/{_name(suffix, i)}.py": written.source
        for suffix, own in variants.items()
        for i, written in enumerate(own)
        if len(own) > 1
    }


def selection(
    package: str,
    entries: Mapping[str, Entry],
    suffix: str,
    own: Sequence[Written],
    points: Points,
    errors: Mapping[str, list[float]],
    summary: Summary,
) -> Record:
    """What is recorded of the choice: the form the module has, and the next best or, where there is one, a better one.

    Parameters
    ----------
    package : str
        Name under which the package with the `modules` is loaded.
    entries : mapping of str to Entry
        What the functions shall evaluate.
    suffix : str
        The function.
    own : sequence of Written
        Its variants, the one that the published module has first.
    points, errors : mapping
        The points whose errors are recorded, and those of the published function there.
    summary : callable
        Errors as they are recorded.
    """

    def draw(count: int, seed: int) -> Points:
        number = count_for(entries[suffix], count)
        return {domain.name: list(samples(entries, suffix, domain, number, seed)) for domain in DOMAINS}

    candidates = [Candidate(w.variant, w.formula, w.cost, lambda point: math.nan) for w in own]
    if len(own) > 1:
        for i, candidate in enumerate(candidates):
            candidate.call = call(package, entries[suffix], own, i)
    standing = candidates[0]
    standing.errors = dict(errors)
    best, second = choose(candidates, points, draw)
    row: Record = {"chosen": _described(standing), "candidates": len(own)}
    if best is not standing:
        row["better"] = best.variant
        second = best
    if second is not None:
        row["runner_up"] = _described(second) | {name: summary(errors) for name, errors in second.errors.items()}
    return row


def _described(candidate: Candidate) -> Record:
    return {"form": candidate.variant, "formula": candidate.formula, "cost": candidate.cost}


def _name(suffix: str, i: int) -> str:
    return f"_{suffix}_{i}"


def call(package: str, entry: Entry, own: Sequence[Written], i: int) -> Callable[[Sample], float]:
    """The value of a variant at a point, by the array machinery of its package."""
    module = import_module(f"{package}.{own[i].system}.{_name(entry.suffix, i)}")
    body: Callable[..., Any] = getattr(module, own[i].function)
    elementwise = import_module(f"{package}._elementwise").elementwise
    names, fields = list(inspect.signature(body).parameters), {str(symbol) for symbol in entry.quantity.arguments}

    def value(point: Sample) -> float:
        values = {name_of(symbol): number for symbol, number in _turned(point.values).items()}
        given = {name: values[name] for name in names if name not in fields}
        several = {name: number for name, number in given.items() if isinstance(number, tuple)}
        function = partial(body, **several) if several else body
        numbers = {name: number for name, number in given.items() if name not in several}
        try:
            return float(elementwise(function, *(values[name] for name in names if name in fields), **numbers))
        except (OverflowError, TypeError):  # TypeError: no rule for numbers beyond the range of doubles
            return math.nan

    return value


def _turned(values: Floats) -> Floats:
    """Seen from the side of x: bodies take distances from the middle."""
    if nt.e in values and values.get(nt.x, 0.0) < 0.0:
        return {**values, nt.x: -values[nt.x], nt.e: -values[nt.e]}
    return values
