"""States of a cohesive zone: where the load is least, and where it has a value on the branch on which it grows.

A state costs a root, and the zone of the next one is guessed from those around it: few states are looked at.  Between
the radii of `Stretch`, below the first and above the last of them, the load has one minimum at most.  There it goes
on from state to state until the minimum or the value lies between two; logarithms of both are nearly linear in that
of the radius.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ..interface import Array
from .cohesive import WITHIN, Opening

CORNER = (0.5, 0.9, 1.0, 1.01, 1.1, 1.5, 3.0)
BUMP = (0.1, 0.25, 0.4, 0.55, 0.7, 0.85, 0.95)
"""Radii over that of a break, and over that at which a profile ends level."""
LEAST, SHORT = 1e-20, 1e-2
"""Of contact radii over the zone of a contact that closes: what counts as none, and what is below every end."""
WALKED, STEPS, CLOSE = 90, 60, 1e-9
"""States of a walk and of a search, and how near a walk comes to the end of a profile."""
SETTLED, UNMOVED, ROUNDING = 1e-11, 1e-15, 1e-15
"""The miss, left to a last step, and the step that end a search; how far below pull-off a load counts as that."""
SHORTEST, LONGEST, STEEP, FLAT, BEYOND = 0.7, 27.0, 1.0, 0.3, 1.2
"""Steps of a walk in ln a; the power of a with which what is missed grows, and its least; how far beyond it aims."""


class State(NamedTuple):
    """Contact radius, q, the ratio of `still`, and the load."""

    a: Array
    q: Array
    ratio: Array
    load: Array


class Stretch(NamedTuple):
    """Contact radii in ascending order that separate the minima of the load."""

    first: Array
    """Radius of the zone of a contact that closes."""
    radii: list[Array]
    top: Array | float
    """What no radius is above."""
    within: Callable[[Array], Array]
    """The radius of a contact; not a number where its zone would reach beyond the profile."""
    rises: bool
    """Whether a load that falls at the last of them may grow beyond."""


Near = Callable[[Array, Array], State]
"""The state at a radius, from a guess of q."""
Missed = Callable[[State], Array]
"""Below 0 before what is looked for, above 0 beyond."""


def radii(first: Array) -> Stretch:
    """Of an endless profile without breaks."""
    return Stretch(first, [first], np.inf, endless, True)


def radii_by(first: Array, corner: Array) -> Stretch:
    """Of a profile with a break."""
    return Stretch(first, [corner * share for share in CORNER], np.inf, endless, True)


def radii_up_to(first: Array, largest: Array, within: Callable[[Array], Array]) -> Stretch:
    """Of a profile that ends steeply, where the load has one minimum."""
    return Stretch(first, [SHORT * first], WITHIN * largest, within, True)


def radii_on_bump(first: Array, largest: Array, within: Callable[[Array], Array]) -> Stretch:
    """Of a profile that ends level."""
    own = [SHORT * BUMP[0] * first, *[largest * share for share in BUMP]]
    return Stretch(first, own, WITHIN * largest, within, False)


def endless(a: Array) -> Array:
    """The radius: no zone reaches beyond."""
    return a


def radius_of_pull_off(near: Near, stretch: Stretch) -> Array:
    """That of the least load: 0 where it falls as long as there is a contact, not a number beyond the profile."""
    return _least(_risen(near, _walked(near, stretch, _by_ratio, _never))).a


def radius_under(near: Near, value: Array, stretch: Stretch) -> Array:
    """The largest radius with this load where the load grows, from that of the least load on."""

    def missed(state: State) -> Array:
        # a load that falls, or is nothing yet, says nothing of the way
        far = np.where(state.load > 0.0, np.log(np.maximum(state.load, LEAST * value) / value), -SHORTEST)
        return np.where(state.ratio < 1.0, np.log(state.ratio), np.where(state.load < value, far, 0.0))

    # where the load grows at a radius and is below the value, and reaches it above, minima further down do not matter
    found = _walked(near, stretch, missed, lambda state: (state.ratio >= 1.0) & (state.load <= value))
    if np.all(found[0].a > 0.0) and not np.all(found[-1].load >= value):
        found = _walked(near, stretch, missed, _never)
    risen, left = _risen(near, found), value < np.inf
    least, a = _least(risen), np.full_like(value, np.nan)
    for start, high, _ in risen[::-1]:
        met = left & (start.load - value <= ROUNDING * (np.abs(start.load) + np.abs(value))) & (high.load >= value)
        met = met & (start.a >= least.a)
        there = _between(near, _by_load(value, least), start, high, met)
        a, left = np.where(met, np.where(np.isnan(there.a), start.a, there.a), a), left & np.logical_not(met)
    return a


def _risen(near: Near, found: list[State]) -> list[tuple[State, State, Array]]:
    """States, or minima between two, with those that follow, and whether the load grows from there on."""
    risen = []
    for low, high in zip(found, found[1:], strict=False):
        dips = (low.ratio < 1.0) & (high.ratio >= 1.0)
        start = _chosen(dips, _between(near, _by_ratio, low, high, dips), low)
        risen.append((start, high, dips | (low.ratio >= 1.0)))
    return risen


def _least(risen: list[tuple[State, State, Array]]) -> State:
    """The state of the least load of those from which it grows."""
    best = _none(risen[0][0])
    for start, _, grows in risen:
        best = _chosen(grows & (start.load < best.load), start, best)
    return best


def parted(opened: Opening, first: Array, E_star: Array, sigma_0: Array) -> Array:
    """The radius c of a zone without contact, up to its first one, at which the depth is least; 0 where it falls."""

    def near(c: Array, q: Array) -> State:
        ratio = opened(c, np.zeros_like(c))[1] / (4.0 / np.pi * (sigma_0 / E_star))
        return State(c, c, ratio, ratio)

    last = near(first, first)
    least = _between(near, _by_ratio, _none(last)._replace(a=np.zeros_like(first)), last, last.ratio >= 1.0)
    return np.where(np.isnan(least.a), 0.0, least.a)


def _by_ratio(state: State) -> Array:
    return np.log(state.ratio)


def _by_load(value: Array, least: State) -> Missed:
    """What is missed of a load above the least one, which grows as (ln a)**2 there and as a power of a far from it."""
    size = np.abs(least.load)
    wanted = np.log1p(np.sqrt((value - least.load) / size))

    def missed(state: State) -> Array:
        known = np.log1p(np.sqrt(np.maximum(state.load - least.load, 0.0) / size))
        return np.where(np.abs(state.load - value) <= ROUNDING * (size + np.abs(value)), 0.0, known - wanted)

    return missed


def _none(state: State) -> State:
    """In the place of a state: there is none."""
    return State(
        np.full_like(state.a, np.nan), state.q, np.full_like(state.ratio, np.nan), np.full_like(state.load, np.inf)
    )


def _chosen(condition: Array, one: State, other: State) -> State:
    return State(*_picked(condition, one, other))


def _picked(condition: Array, one: tuple[Array, ...], other: tuple[Array, ...]) -> list[Array]:
    return [np.where(condition, x, y) for x, y in zip(one, other, strict=True)]


def _never(state: State) -> Array:
    return state.ratio < 0.0


def _walked(near: Near, stretch: Stretch, missed: Missed, enough: Callable[[State], Array]) -> list[State]:
    """States in ascending order on to where nothing is missed, or to the end of the profile.

    They begin at the highest of the radii at which there is `enough`, without a contact if there is none.
    """
    first, own, top, within, rises = stretch
    states, guides = list[State](), list[State]()
    for a in own[::-1]:
        guess = _guess(guides, a) if guides else first
        states.append(near(within(a), guess))
        guides.append(State(a, np.where(np.isnan(states[-1].q), guess, states[-1].q), *states[-1][2:]))
        if np.all(enough(states[-1])):
            break
    found = [] if np.all(enough(states[-1])) else [near(np.zeros_like(first), first)]
    for here, a in zip(states[::-1], own[-len(states) :], strict=True):
        # no state: the zone would reach beyond the profile
        reached = here.ratio == here.ratio
        found.append(_chosen(reached, here, found[-1]) if found else here)
        top = np.where(reached, top, np.minimum(a, top))
    last = found[-1]
    step, ended, steep = np.full_like(first, SHORTEST), first != first, np.full_like(first, STEEP)
    for _ in range(WALKED):
        short = missed(last)
        more = (short < 0.0) & (last.a * (1.0 + CLOSE) < top) & (rises | (last.ratio >= 1.0))
        if not np.count_nonzero(more):
            break
        step = np.minimum(np.maximum(-BEYOND * short / steep, step), LONGEST)
        # halves of the way to where there was none
        ahead = np.where(ended, np.sqrt(last.a * top), top)
        a = np.where(more, np.minimum(last.a * np.exp(step), ahead), last.a)
        here, step = near(within(a), _guess(found, a)), 2.0 * step
        reached = here.ratio == here.ratio
        gained = missed(here) - short
        steep = np.where(gained > 0.0, np.maximum(gained / np.log(a / last.a), FLAT), steep)
        last, top, ended = _chosen(reached, here, last), np.where(reached, top, a), ended | np.logical_not(reached)
        found.append(last)
    return found


def _guess(found: list[State], a: Array) -> Array:
    """q at a radius, by a line in logarithms through the last two states."""
    last, before = found[-1], found[-2:][0]
    known = (before.a > 0.0) & (last.a != before.a)
    slope = np.where(known, np.log(last.q / before.q) / np.log(last.a / before.a), 0.0)
    return last.q * np.where(known, (a / last.a) ** slope, 1.0)


def _between(near: Near, missed: Missed, low: State, high: State, holds: Array) -> State:
    """Where what is missed changes its sign between two states, by parabolas in ln a or halves (Chandrupatla 1997)."""
    low, high = _above_nothing(near, missed, low, high, holds)
    holds = holds & (missed(low) < 0.0)
    if not np.count_nonzero(holds):
        return _none(high)
    unit, best, left = high.a, high, holds
    # the last point, one beyond the root from it, and the one before
    x, y, z = 0.0 * unit, missed(high), np.log(high.q)
    x_b, y_b, z_b = np.log(low.a / unit), missed(low), np.log(low.q)
    x_c, y_c, z_c = x_b, y_b, z_b
    share = np.where((y > 0.0) & (y_b > -np.inf), y / (y - y_b), 0.5)
    for _ in range(STEPS):
        moved = x + share * (x_b - x)
        slope = (z_b - z) / (x_b - x)
        bend = np.where(x_c == x_b, 0.0, (slope - (z_c - z) / (x_c - x)) / (x_b - x_c))
        state = near(unit * np.exp(moved), np.exp(z + (moved - x) * (slope + (moved - x_b) * bend)))
        found, gone = missed(state), np.abs(moved - x)
        rest = np.where((np.abs(found) <= SETTLED) & (found != y), found * (moved - x) / (found - y), 0.0)
        best = _chosen(left, state._replace(a=unit * np.exp(moved - rest)), best)
        left = left & (np.abs(found) > SETTLED) & (gone > UNMOVED)
        if not np.count_nonzero(left):
            break
        same = (found >= 0.0) == (y >= 0.0)
        last, beyond = (x, y, z), (x_b, y_b, z_b)
        (x_c, y_c, z_c), (x_b, y_b, z_b) = _picked(same, last, beyond), _picked(same, beyond, last)
        x, y, z = moved, found, np.log(state.q)
        xi, phi = (x - x_b) / (x_c - x_b), (y - y_b) / (y_c - y_b)
        smooth = (phi * phi < xi) & ((1.0 - phi) * (1.0 - phi) < 1.0 - xi)
        more = (x_c - x) / (x_b - x) * (y_b / (y_c - y_b))
        share = np.where(smooth, y / (y_b - y) * (y_c / (y_b - y_c)) + y / (y_c - y) * more, 0.5)
        share = np.where((share > 0.0) & (share < 1.0), share, 0.5)
    return _chosen(holds, best, _none(best))


def _above_nothing(near: Near, missed: Missed, low: State, high: State, holds: Array) -> tuple[State, State]:
    """Two states with a contact on both sides of what is looked for, where the lower one has none."""
    step, least = np.full_like(high.a, SHORTEST), LEAST * high.a
    for _ in range(WALKED):
        more = holds & (low.a <= 0.0)
        if not np.count_nonzero(more):
            break
        step = np.minimum(np.maximum(BEYOND * missed(high) / STEEP, step), LONGEST)
        a = np.where(more, np.maximum(high.a * np.exp(-step), least), high.a)
        here, step = near(a, high.q), 2.0 * step
        beyond = (missed(here) >= 0.0) & (a > least)
        low = _chosen(more & np.logical_not(beyond), here, low)
        high = _chosen(more & beyond, here, high)
    return low, high
