"""The search for the states of a cohesive zone with plain numbers.

A state costs as much as a root: a few samples and steps that lengthen take the place of the grid of the arrays.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from ..integrals import STRIPS
from ..plain import rule
from .cohesive import ROUNDING, STEPS, WITHIN

Load = Callable[[float], float]
State = Callable[[float], tuple[float, float]]
Sample = tuple[float, float, float]
"""A radius with its state."""
Point = tuple[float, float]
Radii = tuple[list[float], float]
"""Those from which the minima of the load are looked for, and the largest."""
LEAST, SETTLED = 1e-20, 2e-15
"""Of contact radii over the first one, and the change of a logarithm that ends a search: the load is level there."""
CORNER = (0.5, 0.9, 1.0, 1.01, 1.1, 1.5, 3.0)
WHOLE = (0.1, 0.25, 0.4, 0.55, 0.7, 0.85, 0.95)
"""Samples over the radius of a break, or the largest; beyond them one minimum is left."""


def both(
    integrand: Callable[[float], tuple[float, float]],
    stop: float,
    width: float = 1.0,
    lengths: tuple[tuple[float, int], ...] = STRIPS,
) -> tuple[float, float]:
    """The integrals of both members from 0 to `stop`, from the same nodes."""
    if stop != stop:
        return stop, stop
    # as many panels as it takes, where `rule` leaves more than a few to the arrays
    panels = max(math.ceil(stop / width / lengths[-1][0]), 1)
    panel = rule(lengths)(stop / width / panels)
    nodes = [((start + node) / panels, weight / panels) for start in range(panels) for node, weight in panel]
    values = [integrand(node * stop) for node, _ in nodes]
    gap, rate = ([weight * value[i] for (_, weight), value in zip(nodes, values, strict=True)] for i in (0, 1))
    return math.fsum(gap) * stop, math.fsum(rate) * stop


def radii(first: float) -> Radii:
    """Of an endless profile without breaks, where the load has one minimum."""
    return [first], math.inf


def radii_by(first: float, corner: float) -> Radii:
    """Of a profile with a break."""
    return [corner * share for share in CORNER], math.inf


def radii_up_to(first: float, largest: float) -> Radii:
    """Of a profile that ends steeply."""
    # the zone of a contact as wide as the first one may reach beyond the end
    return [0.01 * first, first] if first == first else [largest * share for share in WHOLE], WITHIN * largest


def radii_on_bump(first: float, largest: float) -> Radii:
    """Of a profile that ends level."""
    return sorted([*([0.01 * first] * (first == first)), *(largest * share for share in WHOLE)]), WITHIN * largest


def radius_of_pull_off(state: State, sampled: Radii) -> float:
    """That of the least load: 0 where it falls as long as there is a contact, not a number beyond the profile."""
    found = _samples(state, sampled)
    minima = [(found[0][2], 0.0)] if found and found[0][1] >= 1.0 else []
    for low, high in zip(found, found[1:], strict=False):
        if low[1] < 1.0 <= high[1]:
            a = _minimum(state, low, high)
            minima.append((state(a)[1], a))
    return min(minima)[1] if minima else math.nan


def radius_under(state: State, value: float, sampled: Radii) -> float:
    """The largest radius with this load where the load grows, from that of the least load on."""
    found = _samples(state, sampled, value)
    for low, high in reversed([*zip(found, found[1:], strict=False)]):
        if high[2] < value:
            continue
        if low[2] >= value and low[1] < 1.0 <= high[1]:
            a = _minimum(state, low, high)
            low = (a, *state(a))
            if abs(low[2] - value) <= ROUNDING * (abs(low[2]) + abs(value)):
                return a
        if low[2] < value:
            return _reached(state, value, low, high)
    return math.nan


def _reached(state: State, value: float, low: Sample, high: Sample) -> float:
    unit = abs(low[2]) + abs(value)

    def missed(load: float) -> float:
        return math.asinh((load - value) / unit)

    return _between(lambda a: missed(state(a)[1]), *((own[0], missed(own[2])) for own in (low, high)))


def _samples(state: State, sampled: Radii, value: float = -math.inf) -> list[Sample]:
    """States in ascending order, from where the load falls to where it grows and is no less than a value."""
    own, top = sampled
    found = [(a, *state(a)) for a in own if a < top]
    found = [one for one in found if one[1] == one[1]]
    step, least = 4.0, LEAST * own[0]
    while found and found[0][1] >= 1.0 and found[0][0] > least:
        a = max(found[0][0] / step, least)
        found.insert(0, (a, *state(a)))
        step = min(step * step, 1e8)
    step = 4.0
    while found and (found[-1][1] < 1.0 or found[-1][2] < value) and found[-1][0] * (1.0 + ROUNDING) < top:
        a = min(found[-1][0] * step, top)
        here = state(a)
        if here[0] == here[0]:
            found.append((a, *here))
            step = min(step * step, 1e8)
        else:
            # the zone would reach beyond the profile
            top, step = a, math.sqrt(a / found[-1][0])
    return found


def _minimum(state: State, low: Sample, high: Sample) -> float:
    return _between(lambda a: _log(state(a)[0]), *((own[0], _log(own[1])) for own in (low, high)))


def _log(ratio: float) -> float:
    """Of the ratio of a state, which is nothing within a flat face."""
    return math.log(ratio) if ratio > 0.0 else -math.inf


def _between(missed: Load, low: Point, high: Point) -> float:
    """Where what is missed changes its sign: the steps are those of the arrays."""
    (start, under), (end, over), stays = low, high, 0.0
    start, end = math.log(start), math.log(end)
    tried = end
    for _ in range(STEPS):
        share = under / (under - over) if under != over else 0.5
        last, tried = tried, start + (share if 0.0 <= share <= 1.0 else 0.5) * (end - start)
        y = missed(math.exp(tried))
        if abs(y) <= SETTLED or abs(tried - last) <= SETTLED:
            break
        if y >= 0.0:
            end, over, under, stays = tried, y, (0.5 * under if stays > 0.0 else under), 1.0
        else:
            start, under, over, stays = tried, y, (0.5 * over if stays < 0.0 else over), -1.0
    return math.exp(tried)


def parted(opened: Callable[..., tuple[float, float]], first: float, E_star: float, sigma_0: float) -> float:
    """The radius c of a zone without contact, from its first one down, at which the depth is least; 0 if it falls."""

    def missed(c: float) -> float:
        return math.log(opened(c, 0.0)[1] / (4.0 / math.pi * (sigma_0 / E_star)))

    high, step = (first, missed(first)), 2.0
    while high[1] >= 0.0 and high[0] > LEAST * first:
        low = (high[0] / step, missed(high[0] / step))
        if low[1] < 0.0:
            return _between(missed, low, high)
        high, step = low, min(step * step, 1e8)
    return 0.0
