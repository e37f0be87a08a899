"""Stability maps: worst error in ulps over the dimensionless ratios of each formula, emitted beside naive.

An axis is the ratio of a length to the contact radius, or the exponent n.  Half
the cells of a ratio are equal in log(x) towards 0, half in log(1 - x) towards 1.
"""

from __future__ import annotations

import math
import random
import statistics
from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from .. import notation as nt
from ..build.pool import Jobs, run
from ..entry import FOUR, Entry
from .naive import Judged, Point, judged, reference
from .report import Record, rounded, table, versions
from .subject import NAMES, OTHER, PARAMETERS, named, subject

DECADES = 12
SEED = 17
CELLS, SAMPLES = 24, 3
QUICK_CELLS, QUICK_SAMPLES = 4, 1
EXPONENTS = (-3.0, 3.0)
"""Decades of n."""
LOST = -1.0
MISSED = 1e-12
NOTE = (
    "worst[i][j]: worst error in ulps of the samples in the cell between edges[0][i..i+1] and edges[1][j..j+1] "
    "of the two axes (one row where there is one ratio); -1 if one is NaN or infinite; null without samples whose "
    "exact value is a normal double. share: part of all samples that misses 1e-12 relative, NaN and infinite included. "
    "References are Arb enclosures at the doubles given."
)


@dataclass(frozen=True)
class Axis:
    """A length as a ratio to the contact radius, smaller or larger than it, or the exponent of a power law."""

    symbol: sp.Symbol
    kind: str

    @property
    def name(self) -> str:
        """The ratio or exponent in text: b/a, a/R or n."""
        return {"below": f"{self.symbol}/a", "above": f"a/{self.symbol}", "exponent": str(self.symbol)}[self.kind]

    def place(self, u: float) -> float:
        """The symbol for a = 1 at the position 0 < u < 1 of the axis."""
        if self.kind == "exponent":
            low, high = EXPONENTS
            return float(10 ** (low + (high - low) * u))
        ratio = _ratio(u)
        return ratio if self.kind == "below" else 1.0 / ratio

    def edge(self, u: float) -> float:
        """The number at a position 0 < u < 1 of the axis: a ratio, or the exponent."""
        return self.place(u) if self.kind == "exponent" else _ratio(u)


def _ratio(u: float) -> float:
    """From 10**-DECADES/2 through 1/2 to 1 - 10**-DECADES/2."""
    near = 0.5 * float(10 ** (-DECADES * abs(1.0 - 2.0 * u)))
    return near if u < 0.5 else 1.0 - near


def axes(entry: Entry) -> tuple[Axis, ...]:
    """The ratios on which the formula depends: every length that its regions compare with a, and the exponent."""
    found: dict[sp.Symbol, Axis] = {}
    for case in entry.cases:
        for symbol in case.chain:
            if symbol != nt.a:
                found[symbol] = Axis(symbol, "below" if case.below(symbol, nt.a) else "above")
    if nt.n in entry.parameters:
        found[nt.n] = Axis(nt.n, "exponent")
    return tuple(found.values())


KNOWN = (*NAMES, OTHER)


def measure(
    names: Sequence[str] = KNOWN, *, quick: bool = False, quantities: Sequence[str] = FOUR, jobs: Jobs = 1
) -> Record:
    """The record of the study: one map for each formula that depends on a ratio."""
    cells, samples = (QUICK_CELLS, QUICK_SAMPLES) if quick else (CELLS, SAMPLES)
    keys = [(name, suffix) for name in names for suffix in quantities if axes(subject(name).entries[suffix])]
    settings = {"seed": SEED, "cells": cells, "samples": samples, "decades": DECADES, "versions": versions()}
    return {
        "study": "maps",
        "note": NOTE,
        "settings": settings | {"parameters": named(PARAMETERS) | {"a": "0.5 to 2"}},
        "maps": list(run(_map, [(name, suffix, cells, samples) for name, suffix in keys], jobs, ordered=True)),
    }


def _map(name: str, suffix: str, cells: int, samples: int) -> Record:
    entry = subject(name).entries[suffix]
    own = axes(entry)
    rng = random.Random(f"{SEED} {entry.key}")
    shape = (cells, cells) if len(own) > 1 else (1, cells)
    places, points, exact = [], [], []
    for i in range(shape[0]):
        for j in range(shape[1]):
            for _ in range(samples):
                point = _point(entry, own, (i, j) if len(own) > 1 else (j,), cells, rng)
                value = reference(name, suffix, point)
                if value is not None:
                    places.append((i, j))
                    points.append(point)
                    exact.append(value)
    found = judged(name, suffix, points, exact)
    edges = [[axis.edge(k / cells) for k in range(cells + 1)] for axis in own]
    return {
        "key": entry.key,
        "axes": [axis.name for axis in own],
        "edges": edges,
        "samples": len(points),
        **{way: _judgement(found[way], places, shape) for way in found},
    }


def _point(entry: Entry, own: tuple[Axis, ...], cell: tuple[int, ...], cells: int, rng: random.Random) -> Point:
    """A contact radius near 1 and the lengths that belong to a random place in the cell."""
    a = 2.0 ** rng.uniform(-1.0, 1.0)
    point = {symbol: PARAMETERS[symbol] for symbol in entry.parameters} | {nt.a: a}
    for axis, index in zip(own, cell, strict=True):
        size = axis.place((index + rng.random()) / cells)
        point[axis.symbol] = size if axis.kind == "exponent" else a * size
    return point


def _judgement(found: list[Judged], places: list[tuple[int, int]], shape: tuple[int, int]) -> Record:
    worst: list[list[float | None]] = [[None] * shape[1] for _ in range(shape[0])]
    for (i, j), one in zip(places, found, strict=True):
        before = worst[i][j]
        if before != LOST:
            worst[i][j] = LOST if one.lost else rounded(max(before or 0.0, one.ulps))
    finite = [one.ulps for one in found if not one.lost]
    return {
        "worst_ulps": rounded(max(finite, default=math.nan)),
        "median_ulps": rounded(statistics.median(finite) if finite else math.nan),
        "share": rounded(sum(one.relative > MISSED for one in found) / len(found)),
        "lost": len(found) - len(finite),
        "worst": worst,
    }


def text(record: Record) -> str:
    """One line per formula."""
    ways, columns = ("emitted", "naive"), {"worst_ulps": "ulps", "share": "> 1e-12", "lost": "lost"}
    head = ("key", "ratios", "samples", *(f"{way} {column}" for way in ways for column in columns.values()))
    rows = []
    for one in record["maps"]:
        figures = [one[way][what] for way in ways for what in columns]
        rows.append((one["key"], ", ".join(one["axes"]), one["samples"], *figures))
    return table(head, rows)
