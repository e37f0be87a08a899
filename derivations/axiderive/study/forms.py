"""The race of evaluation forms: the functions of a problem in every variant, the cheapest that keeps its digits.

A build writes what `stable.chosen` names. This study measures whether another form would be better by now.
"""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from importlib import import_module
from typing import Any

from .. import notation as nt
from ..contact.systems import Problem, problem, problems
from ..emit.modules import package_sources
from ..entry import Entry
from ..letters import name_of
from ..show import table
from ..stable.closure import closure
from ..stable.emitted import loaded
from ..stable.measure import Sample, count_for, samples
from ..stable.records import COUNT, OWN, SEED, summary
from ..stable.samples import DOMAINS, Floats
from ..stable.slopes import RATE, rate
from .choice import Candidate, Points, choose
from .report import Record
from .variants import Written, written

Variants = Mapping[str, Sequence[Written]]
"""The distinct variants of functions by suffix, the chosen one first."""


def names() -> tuple[str, ...]:
    """The problems whose modules hold bodies of their own."""
    return tuple(own.key for own in problems() if own.system.name in OWN)


def measure(keys: Sequence[str]) -> Record:
    """The race of each of these problems: `{"study": "forms", "problems": {key: {suffix: row}}}`."""
    return {"study": "forms", "problems": {key: _race(problem(key)) for key in keys}}


def text(record: Record) -> str:
    """A line for every function that has several forms; what would be taken instead is said."""
    rows = [["key", "form", "cost", "beside it", "cost", "verdict"]]
    for key, found in record["problems"].items():
        for suffix, row in found.items():
            other = row.get("runner_up", {"form": "", "cost": ""})
            verdict = f"name `{row['better']}` in CHOSEN of stable/chosen.py" if "better" in row else "stays"
            chosen = row["chosen"]
            rows.append([f"{key}.{suffix}", chosen["form"], chosen["cost"], other["form"], other["cost"], verdict])
    return table([[str(cell) for cell in row] for row in rows])


def _race(own: Problem) -> dict[str, Record]:
    entries = own.derive()
    sources = package_sources({own.key: entries})
    return race(own.key, sources, entries, written(entries))


def race(key: str, sources: Mapping[str, str], entries: Mapping[str, Entry], variants: Variants) -> dict[str, Record]:
    """What measurement says of the forms of the functions of a problem, by suffix.

    Parameters
    ----------
    key : str
        Key of the problem, as `cone`.
    sources : mapping of str to str
        The texts of the package by path.
    entries : mapping of str to Entry
        What the functions shall evaluate, by suffix.
    variants : mapping of str to sequence of Written
        Their forms, the one of the published module first.

    Returns
    -------
    dict
        Of each function with several forms the one it has (`chosen`), the next best with its errors (`runner_up`),
        and the name of a better one (`better`) where there is one.
    """
    module = problem(key).module
    growing = rate(entries)
    entries = {**entries, **({RATE.suffix: growing} if growing is not None else {})}
    texts = {
        f"axicontact/{one.system}/{_name(suffix, i)}.py": one.source
        for suffix, own in variants.items()
        for i, one in enumerate(own)
    }
    with loaded(closure({**sources, **texts}, module, *texts), module) as published:
        package = published.__name__.partition(".")[0]
        return {suffix: _row(package, entries, suffix, own) for suffix, own in variants.items() if len(own) > 1}


def _row(package: str, entries: Mapping[str, Entry], suffix: str, own: Sequence[Written]) -> Record:
    def draw(count: int, seed: int) -> Points:
        number = count_for(entries[suffix], count)
        return {domain.name: list(samples(entries, suffix, domain, number, seed)) for domain in DOMAINS}

    candidates = [
        Candidate(one.variant, one.formula, one.cost, _call(package, entries[suffix], own, i))
        for i, one in enumerate(own)
    ]
    standing = candidates[0]
    best, second = choose(candidates, draw(COUNT, SEED), draw)
    row: Record = {"chosen": _described(standing)}
    if best is not standing:
        row["better"], second = best.variant, best
    if second is not None:
        row["runner_up"] = _described(second) | {name: summary(errors) for name, errors in second.errors.items()}
    return row


def _described(candidate: Candidate) -> Record:
    return {"form": candidate.variant, "formula": candidate.formula, "cost": candidate.cost}


def _name(suffix: str, i: int) -> str:
    return f"_{suffix}_{i}"


def _call(package: str, entry: Entry, own: Sequence[Written], i: int) -> Callable[[Sample], float]:
    """The value of a variant at a point, by the array machinery of its package."""
    module = import_module(f"{package}.{own[i].system}.{_name(entry.suffix, i)}")
    body: Callable[..., Any] = getattr(module, own[i].function)
    elementwise = import_module(f"{package}._elementwise").elementwise
    known, fields = list(inspect.signature(body).parameters), {str(symbol) for symbol in entry.quantity.arguments}

    def value(point: Sample) -> float:
        values = {name_of(symbol): number for symbol, number in _turned(point.values).items()}
        given = {name: values[name] for name in known if name not in fields}
        several = {name: number for name, number in given.items() if isinstance(number, tuple)}
        function = partial(body, **several) if several else body
        numbers = {name: number for name, number in given.items() if name not in several}
        try:
            return float(elementwise(function, *(values[name] for name in known if name in fields), **numbers))
        except (OverflowError, TypeError):  # TypeError: no rule for numbers beyond the range of doubles
            return math.nan

    return value


def _turned(values: Floats) -> Floats:
    """Seen from the side of x: bodies take distances from the middle."""
    if nt.e in values and values.get(nt.x, 0.0) < 0.0:
        return {**values, nt.x: -values[nt.x], nt.e: -values[nt.e]}
    return values
