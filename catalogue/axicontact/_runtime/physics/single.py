"""With plain numbers: the search for stable branches, step by step on the grid kept for the geometry, and springs."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from ..interface import KEPT
from .branches import CLOSEST, FAR, STEPS, Branches, Samples
from .branches import halfway as halfway_of_arrays
from .relaxation import SHARES, UNDER, WEIGHTS

Load = Callable[[float], float]
NODES = list(zip(SHARES.tolist(), WEIGHTS.tolist(), strict=True))


def branches(steepness: Load, sampled: Samples, level: float) -> Branches:
    """The branches on which the steepness is above the level, their ends in lists: searched for once in a geometry."""
    found = sampled.found.get(level)
    if found is None:
        found = _searched(steepness, sampled, level)
        if len(sampled.found) >= KEPT:
            sampled.found.clear()
        sampled.found[level] = found
    return found


def _searched(steepness: Load, sampled: Samples, level: float) -> Branches:
    radii, known = sampled.radii.ravel(), sampled.steepness.ravel()
    rises = known >= level
    # a load that grows from the least radius on has its minimum there
    first: list[float] = [float(radii[0])] if rises[0] else []
    last: list[float] = []

    def above(a: float) -> float:
        try:
            return _log(steepness(a) / level)
        except OverflowError:
            return math.nan

    for place in np.flatnonzero((rises[1:] != rises[:-1]) & (rises[1:] | (radii[:-1] < FAR))).tolist():
        low, high, before, after = (float(x[place + one]) for x in (radii, known) for one in (0, 1))
        up = bool(rises[place + 1])
        root = _change(above, low, high, _log(before / level), _log(after / level), 1.0 if up else -1.0)
        (first if up else last).append(root)
    # where g' is infinite the load may be too
    first = [min(own, math.nextafter(float(radii[-1]), 0.0)) for own in first]
    return Branches(first, [*last, float(np.max(sampled.end))][: len(first)])


def _change(above: Load, low: float, high: float, before: float, after: float, sign: float) -> float:
    """The first radius beyond a change of sign; the steps are those of `branches` over arrays."""
    before, after, stays = sign * before, sign * after, 0.0
    for step in range(STEPS + 64):
        if math.nextafter(low, high) >= high:
            break
        share = before / (before - after) if step < STEPS and before != after else math.nan
        tried = low * math.exp((share if 0.0 <= share <= 1.0 else 0.5) * math.log(high / low))
        tried = min(max(tried, low * (1.0 + CLOSEST * 2.0**step)), high * (1.0 - CLOSEST * 2.0**step))
        middle = tried if step < STEPS and low < tried < high else halfway_of_arrays(low, high).item()
        value = sign * above(middle)
        if value >= 0.0:
            before, after = (0.5 * before if stays > 0.0 else before), value
            high, stays = middle, 1.0
        else:
            before, after = value, (0.5 * after if stays < 0.0 else after)
            low, stays = middle, -1.0
    return high


def _log(x: float) -> float:
    return math.log(x) if x > 0.0 else -math.inf


def at_the_end(load: Load, a: float) -> float:
    """The load at the largest radius, where it may be infinite."""
    try:
        return load(a)
    except ZeroDivisionError:
        return math.inf


def lowest(found: Branches, load: Load) -> float:
    """Radius at which the load is lowest: pull-off; NaN without a stable contact."""
    loads = [load(first) for first in found.first]
    known = [own for own in loads if own == own]
    return float(found.first[loads.index(min(known))]) if known else math.nan


def springs(left: Load, low: float, high: float) -> float:
    """The integral of what springs bear from `low` to `high`, by the rule for arrays."""
    length = high - low
    if length == 0.0:
        return 0.0
    return length * (math.fsum([weight * left(low + length * share) for share, weight in NODES]) + UNDER * left(low))
