"""The race of evaluation forms: every function of a problem in each form, its errors and its time.

A build writes what `stable.variants` names.  This study measures whether another form would be better by now: errors
against Arb at the points of the record, the time beside the frozen form over arrays.
"""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from importlib import import_module
from typing import Any

import numpy as np

from .. import notation as nt
from ..code import normal
from ..code.bodies.growth import add_rate
from ..code.bodies.regimes import join, split
from ..code.function import Function
from ..code.physics import loads
from ..code.plane import interface as plane
from ..code.private import PrivateFunctions
from ..code.python import package_sources
from ..entry import Entry
from ..letters import name_of
from ..physics.systems import of, problem, problems
from ..stable.measure import Sample, closure, count_for, loaded, samples, ulps
from ..stable.records import COUNT, OWN, SEED, TOLERANCE
from ..stable.samples import DOMAINS
from ..stable.slopes import RATE, rate
from ..stable.variants import FULL, SPLITS, VARIANTS, chosen
from .report import Record, paired, rounded, table

MARGIN = 1.0
"""Units of the last place by which an error moves between processors."""
QUICKER = 0.9
"""The share of the time that another form may take at most: times are no better than that."""
MANY, ROUNDS = 10_000, 7
FEW = 5
KNOWN = tuple(own.key for own in problems() if own.system in OWN)
"""The problems whose modules hold bodies of their own."""

PARTS = ("", "_at", "_beyond", "_below", "_above")
"""What the names of the functions of one quantity end on."""
RATES = ("slope", "slope_beyond", "growth", "growth_beyond")
"""Those of the rate of growth, which `rate` joins."""
FAMILIES: dict[str, Any] = {"normal": normal, "plane": plane, "loads": loads}
"""Where the functions of a system are written by the rules of `stable`: its `bodies` and `bodies_source`.

All others call them or the shapes of the runtime; the radius of pull-off of a power law and the depth and force of a
flat face have one text in every variant.  So has a partial slip: its bodies call the normal contact, whose stick radius
is the radius of a force, and what a contact gains from c to a is a shape of the runtime for its power, which errs as
much as the rule for any power and takes a hundredth of the time.
"""


@dataclass(frozen=True)
class Written:
    """One function in one variant: a module that holds it, its other functions in the frozen ones."""

    variant: str
    system: str
    source: str
    function: str


def written(entries: Mapping[str, Entry]) -> dict[str, tuple[Written, ...]]:
    """The distinct ways of each function, the frozen one first; the rate of growth goes by its own suffix."""
    first = next(iter(entries.values()))
    system = of(first).name
    if system not in FAMILIES:
        return {}
    bare = PrivateFunctions(first.profile)
    base = _functions(system, entries, bare)
    ways = {one.name: _functions(system, entries, replace(bare, functions={}, common=one)) for one in VARIANTS}
    found = {}
    for suffix, entry in with_rate(entries).items():
        function, frozen = entry.quantity.function, chosen(entry.key).name
        own = {frozen: base} | {name: way for name, way in ways.items() if name != frozen}
        for one in (one for one in SPLITS if one.name != frozen):
            below = replace(ways[FULL.name], functions=dict(ways[FULL.name].functions))
            if join(below, ways[one.above.name], function, one.beyond):
                own[one.name] = below
        texts: dict[tuple[str, ...], Written] = {}
        for name, way in own.items():
            parts = _own(way, function)
            lines = tuple(line for private in parts.values() for line in private.lines)
            if lines and lines not in texts:
                rest = {key: private for key, private in base.functions.items() if key not in _own(base, function)}
                source = FAMILIES[system].bodies_source(replace(base, functions=rest | parts), name)
                texts[lines] = Written(name, system, source, f"_{function}")
        if texts:
            found[suffix] = tuple(texts.values())
    return found


def with_rate(entries: Mapping[str, Entry]) -> dict[str, Entry]:
    """The entries with the rate of growth, where it is a function."""
    growing = rate(entries)
    return {**entries, **({RATE.suffix: growing} if growing is not None else {})}


def _functions(system: str, entries: Mapping[str, Entry], functions: PrivateFunctions) -> PrivateFunctions:
    bodies = FAMILIES[system].bodies
    compact = bodies(functions, entries)
    split(functions, entries, bodies)
    if compact is not None:
        add_rate(compact)
    return functions


def _own(functions: PrivateFunctions, function: str) -> dict[str, Function]:
    names = (*(f"{function}{part}" for part in PARTS), *(RATES if function == RATE.function else ()))
    return {name: functions.functions[name] for name in names if name in functions.functions}


def measure(names: Sequence[str] = KNOWN, *, quick: bool = False) -> Record:
    """The race of each of these problems: `{"study": "forms", "problems": {key: {suffix: rows}}}`."""
    found = {}
    for key in names:
        entries = problem(key).derive()
        found[key] = race(key, package_sources({key: entries}), entries, written(entries), FEW if quick else COUNT)
    return {"study": "forms", "problems": found}


def text(record: Record) -> str:
    """A line for every form of a function that has several; what would be taken instead is said."""
    rows = []
    for key, found in record["problems"].items():
        for suffix, forms in found.items():
            best = better(forms)
            for row in forms:
                said = f"name it in CHOSEN of stable/variants.py for {key}.{suffix}" if row["form"] == best else ""
                rows.append((f"{key}.{suffix}", row["form"], row["worst"], row["time"], said))
    return table(("key", "form", "worst", "time", "verdict"), rows)


def better(forms: Sequence[Record]) -> str | None:
    """The form that should be taken instead of the first one, which is frozen."""
    frozen = math.inf if forms[0]["worst"] is None else forms[0]["worst"]
    keeping = [row for row in forms[1:] if row["worst"] is not None and row["worst"] <= TOLERANCE - MARGIN]
    if frozen <= TOLERANCE + MARGIN:
        keeping = [row for row in keeping if row["time"] <= QUICKER]
    return min(keeping, key=lambda row: row["time"])["form"] if keeping else None


def race(
    key: str,
    sources: Mapping[str, str],
    entries: Mapping[str, Entry],
    variants: Mapping[str, Sequence[Written]],
    count: int = COUNT,
) -> dict[str, list[Record]]:
    """What measurement says of each form of the functions of a problem, by suffix.

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
    count : int
        Points in either domain, fewer where the exact value is an integral.

    Returns
    -------
    dict
        Of each function with several forms a row for each: its name, the worst error in units of the last place, none
        where a value was lost, and its time over that of the first.
    """
    module, entries = problem(key).module, with_rate(entries)
    named = {(suffix, i): one for suffix, own in variants.items() for i, one in enumerate(own) if len(own) > 1}
    texts = {f"axicontact/{one.system}/_{suffix}_{i}.py": one.source for (suffix, i), one in named.items()}
    found: dict[str, list[Record]] = {}
    with loaded(closure({**sources, **texts}, module, *texts), module) as published:
        package = published.__name__.partition(".")[0]
        for suffix in dict.fromkeys(suffix for suffix, _ in named):
            entry = entries[suffix]
            points = [s for own in DOMAINS for s in samples(entries, suffix, own, count_for(entry, count), SEED)]
            many = {symbol: np.full(MANY, points[0].values[symbol]) for symbol in entry.quantity.arguments}
            calls = [_call(package, entry, one, f"_{suffix}_{i}") for i, one in enumerate(variants[suffix])]
            runs = [partial(call, points[0].values | many) for call in calls]
            found[suffix] = [
                {"form": one.variant, "worst": _worst(call, points), "time": rounded(paired(run, runs[0], ROUNDS))}
                for one, call, run in zip(variants[suffix], calls, runs, strict=True)
            ]
    return found


def _worst(call: Callable[[Mapping[Any, Any]], Any], points: Sequence[Sample]) -> float | None:
    def error(point: Sample) -> float:
        try:
            return ulps(float(call(point.values)), point.exact)
        except (OverflowError, TypeError):  # TypeError: no rule for numbers beyond the range of doubles
            return math.inf

    return rounded(max(map(error, points), default=0.0))


def _call(package: str, entry: Entry, one: Written, name: str) -> Callable[[Mapping[Any, Any]], Any]:
    """A form as a function of the values of its symbols, by the array machinery of its package."""
    body: Callable[..., Any] = getattr(import_module(f"{package}.{one.system}.{name}"), one.function)
    elementwise = import_module(f"{package}._runtime.interface").elementwise
    known, fields = list(inspect.signature(body).parameters), {str(symbol) for symbol in entry.quantity.arguments}

    def value(given: Mapping[Any, Any]) -> Any:
        values = {name_of(symbol): number for symbol, number in given.items()}
        if nt.e in given and np.all(given.get(nt.x, 0.0) < 0.0):  # bodies take distances from the middle
            values |= {"x": -values["x"], "e": -values["e"]}
        own = {name: values[name] for name in known if name not in fields}
        several = {name: number for name, number in own.items() if isinstance(number, tuple)}
        numbers = {name: number for name, number in own.items() if name not in several}
        return elementwise(partial(body, **several), *(values[name] for name in known if name in fields), **numbers)

    return value
