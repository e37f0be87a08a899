"""The measured accuracy of the emitted functions of one problem, as it is kept with the evidence; what is drift."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Mapping
from functools import partial
from typing import Any

import sympy as sp

from ..entry import FOUR, Entry
from ..physics import subsurface
from ..physics.systems import SYSTEMS, System, problem
from ..profiles.pools import BODIES, ROUND
from . import fields
from .measure import Sample, count_for, form, function_of, loaded, naive, samples, ulps, value
from .reference import DOMAINS, UnknownError, condition, is_inverse

COUNT, SEED = 30, 17
MEASURED = tuple(own for own in SYSTEMS if own.pool is not BODIES and not own.physics.laws)
"""Systems whose functions are measured."""
OWN = tuple(own for own in MEASURED if own.base is None and not own.medium.graded)
"""Systems whose modules hold bodies of their own; all closed formulas of theirs are measured."""
DIRECT = (*FOUR, "k", "pm", "Dl", "tau", "u", "us")
"""Quantities of the compact contacts beyond those systems whose printed formulas are enclosed as they stand.

Of a physics that states what its functions return these are all closed formulas.
"""
FIELDS = {subsurface.PHYSICS: fields.measured}
"""Functions with several components, which are sums of entries; they are recorded by their names."""
TOLERANCE = 5.0
CHECKED = 4
"""Points above the tolerance whose condition is found."""
Record = dict[str, Any]


def record(
    key: str,
    sources: Mapping[str, str],
    entries: Mapping[str, Entry],
    suffixes: Collection[str] | None = None,
    *,
    count: int = COUNT,
    seed: int = SEED,
) -> dict[str, Record]:
    """Errors of the functions of a problem, by suffix: of all in normal contact, elsewhere of the closed formulas.

    Parameters
    ----------
    key : str
        Key of the problem, as `cone`.
    sources : mapping of str to str
        The texts of the package by path; the module and what it imports are taken from there.
    entries : mapping of str to Entry
        What the functions shall evaluate, by suffix.
    suffixes : collection of str, optional
        The functions to measure; all of them where none are named.
    count, seed : int
        Points in either domain, a tenth where the exact value is an integral, half at roots; where they start.

    Returns
    -------
    dict
        `form` and `nodes` as `emitted.form` tells where a module holds its own bodies (normal contact), for
        `bench` and `extreme` the worst error in units of the last place, the share above five and the number of
        lost values, and where the printed formula can be evaluated by NumPy the same of it under `naive`.
        Where errors exceed five units, `over_condition` is the largest of them over 1 + the sum of
        |d ln value/d ln argument|, which rounding one argument would cost anyway.
        Errors are rounded up to two digits: NumPy's functions differ by a unit between processors.
    """
    found = problem(key)
    system = found.system
    if system.physics in FIELDS:
        with loaded(sources, found.module) as module:
            return _of_fields(FIELDS[system.physics](module, entries, seed))
    wanted = [suffix for suffix in entries if suffixes is None or suffix in suffixes]
    if not (system in OWN and system.pool is ROUND):
        wanted = [suffix for suffix in wanted if _direct(entries[suffix], system)]
    rows: dict[str, Record] = {}
    with loaded(sources, found.module) as module:
        for suffix in wanted:
            entry = entries[suffix]
            row = _form(sources[found.module], entry) if system in OWN else {}
            # half of the points where every exact value is at a root
            share = 1 if system.physics.solved is None else 2
            row["sample"] = {"seed": seed, "count": max(1, count_for(entry, count) // share)}
            evaluate = partial(value, function_of(entry, module))
            rows[suffix] = row | _errors(entries, suffix, *_measured(entries, suffix, evaluate, row["sample"]))
    return rows


def _of_fields(found: Iterable[tuple[str, str, list[float], list[float]]]) -> dict[str, Record]:
    """The record of functions with components: units of the last place of the largest one, and those of each."""
    rows: dict[str, Record] = {}
    for function, domain, along, own in found:
        worst = {"by_component": rounded_up(max(own))} if own else {}
        rows.setdefault(function, {})[domain] = summary(along) | worst
    return rows


def _direct(entry: Entry, system: System) -> bool:
    """Whether the exact value is an enclosure of the printed formula, or a root of one, without an integral in it."""
    solved = system.physics.solved
    known = entry.status == "closed" or is_inverse(entry) or entry.quantity.symbol == solved
    if not known or any(case.expr.has(sp.Integral) for case in entry.cases):
        return False
    stated = system.physics.code is not None or solved is not None
    return system in OWN or stated or entry.suffix in DIRECT and entry.profile.compact


def _form(source: str, entry: Entry) -> Record:
    kind, nodes = form(source, entry.quantity.function)
    return {"form": kind, "nodes": nodes}


def _measured(
    entries: Mapping[str, Entry], suffix: str, evaluate: Callable[[Sample], float], sample: Record
) -> tuple[dict[str, list[Sample]], dict[str, list[float]]]:
    """Points and errors by domain; at points that break a rule of the function there are none.

    The waves of a graded contact have a rule with k.
    """
    points: dict[str, list[Sample]] = {domain.name: [] for domain in DOMAINS}
    errors: dict[str, list[float]] = {domain.name: [] for domain in DOMAINS}
    for domain in DOMAINS:
        for point in samples(entries, suffix, domain, sample["count"], sample["seed"]):
            try:
                error = ulps(evaluate(point), point.exact)
            except ValueError:
                continue
            points[domain.name].append(point)
            errors[domain.name].append(error)
    return points, errors


def _errors(
    entries: Mapping[str, Entry], suffix: str, points: Mapping[str, list[Sample]], errors: Mapping[str, list[float]]
) -> Record:
    row: Record = {}
    printed = naive(entries[suffix])
    for domain, some in points.items():
        row[domain] = summary(errors[domain]) | _conditioned(entries, suffix, some, errors[domain])
        if printed is not None:
            row[domain]["naive"] = summary([ulps(printed(point.values), point.exact) for point in some])
    return row


def summary(errors: list[float]) -> Record:
    """Errors as they are recorded: the worst, the share above five units, the number of lost values."""
    finite = [error for error in errors if math.isfinite(error)]
    lost = len(errors) - len(finite)
    if not errors:
        return {"points": 0}
    above = sum(error > TOLERANCE for error in errors)
    worst = {"worst_ulp": rounded_up(max(finite))} if finite else {}
    return {"points": len(errors), **worst, "share_above_5": round(above / len(errors), 4), "lost": lost}


def _conditioned(entries: Mapping[str, Entry], suffix: str, points: list[Sample], errors: list[float]) -> Record:
    wrong = [i for i in range(len(errors)) if TOLERANCE < errors[i] < math.inf]
    wrong = sorted(wrong, key=errors.__getitem__, reverse=True)[:CHECKED]
    shares = []
    for i in wrong:
        try:
            shares.append(errors[i] / (1.0 + condition(dict(entries), suffix, points[i].values)))
        except UnknownError:
            continue
    return {"over_condition": rounded_up(max(shares))} if shares else {}


def rounded_up(x: float) -> float:
    """To two digits."""
    if not 0.0 < x < math.inf:
        return x
    unit = 10.0 ** (math.floor(math.log10(x)) - 1)
    return float(f"{math.ceil(x / unit) * unit:.2g}")


UNITS, FACTOR = 1.0, 3.0
"""How far a worst error may move: NumPy's functions differ by a unit between processors, and roots amplify that.

With AVX-512 off it moved from 2.1 to 6.4 units at most, in a force at given depth.
"""
MANY = 1e3
"""Units above which a sum has cancelled: only the number of lost digits is compared."""
NOTHING = 2.0**52
"""Units at which a printed formula has lost all digits; what it gives there is noise, as is the last one it keeps."""
JUMP, SMALL = 10.0, 32.0
"""A worst error of more units than SMALL that is this many times what it was: a function that has become worse."""
STATED = ("form", "nodes", "sample")


def settled(kept: Mapping[str, Record], found: Mapping[str, Record]) -> dict[str, Record]:
    """The kept row of every function whose errors have not drifted, so that a record does not depend on the machine."""
    return {suffix: row if drift(kept, {suffix: row}) else kept[suffix] for suffix, row in found.items()}


def jumps(kept: Mapping[str, Record], found: Mapping[str, Record]) -> list[tuple[str, str]]:
    """The functions that lost digits since the kept record, as suffix and sentence: what a build must not hide."""
    lines = []
    for suffix, row in found.items():
        for domain in [name for name in row if name not in STATED and name in kept.get(suffix, {})]:
            old, new = kept[suffix][domain], row[domain]
            before, now, more = _worst(old), _worst(new), new.get("lost", 0) - old.get("lost", 0)
            if more > 0:
                lines.append((suffix, f"{domain}: {more} more values are lost"))
            elif now > max(SMALL, JUMP * before) and _moved(old, new):
                lines.append((suffix, f"{domain}: the worst error was {before}, is {now} units in the last place"))
    return lines


def drift(kept: Mapping[str, Record], found: Mapping[str, Record]) -> list[tuple[str, str]]:
    """What no difference between machines explains, as suffix and sentence; only functions in `found` are compared.

    The same form, nodes and points are wanted, the same number of lost values, and a worst error that is at most
    one unit more than three times the smaller of both; of the printed formula, half or twice the digits that were lost.
    """
    lines = []
    for suffix, row in found.items():
        if suffix in kept:
            lines += [(suffix, line) for line in _row(kept[suffix], row)]
        else:
            lines.append((suffix, "there is no record of them; run axicontact build"))
    return lines


def _row(kept: Record, found: Record) -> list[str]:
    stated = [(name, kept.get(name), found.get(name)) for name in STATED]
    lines = [f"{name} was {before}, is {now}" for name, before, now in stated if before != now]
    for domain, new in found.items():
        if domain not in STATED:
            lines += [f"{domain}: {line}" for line in _moved(kept.get(domain, {}), new)]
    return lines


def _moved(old: Record, new: Record) -> list[str]:
    lines = [
        f"{name} was {old.get(name)}, is {new[name]}" for name in ("points", "lost") if old.get(name) != new.get(name)
    ]
    before, now = _worst(old), _worst(new)
    noise = min(before, now) > MANY and not _other_digits(before, now)
    if max(before, now) > UNITS + FACTOR * min(before, now) and not noise:
        lines.append(f"the worst error was {before}, is {now} units")
    if ("naive" in old) != ("naive" in new):
        lines.append(f"the printed formula was {'' if 'naive' in old else 'not '}measured")
    elif "naive" in new:
        before, now = _worst(old["naive"]), _worst(new["naive"])
        if _other_digits(before, now):
            lines.append(f"the worst error of the printed formula was {before}, is {now} units")
    return lines


def _other_digits(*errors: float) -> bool:
    """Whether one of two errors has lost more than twice the digits of the other."""
    low, high = sorted(math.log2(1.0 + min(error, NOTHING)) for error in errors)
    return high > UNITS + 2.0 * low


def _worst(errors: Record) -> float:
    """Infinite where every value was lost, nought where there was no point."""
    return float(errors.get("worst_ulp", math.inf if errors.get("points") else 0.0))
