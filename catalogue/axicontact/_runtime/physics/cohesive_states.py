"""States of a cohesive zone: where the load is least, and where it has a value on the branch on which it grows.

A state knows how it goes on with the contact radius, and the zone of the next one is guessed from that: most ask for
the gap once.  Between the radii of `Stretch`, below the first and above the last of them, the load has one minimum at
most.  There it goes on from state to state until the minimum or the value lies between two; logarithms of both are
nearly linear in that of the radius.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ..interface import Array, either
from .cohesive import WITHIN, Opening, with_ring

CORNER = (0.5, 0.9, 1.0, 1.01, 1.1, 1.5, 3.0)
BUMP = (0.1, 0.25, 0.4, 0.55, 0.7, 0.85, 0.95)
"""Radii over that of a break, and over that at which a profile ends level."""
LEAST, SHORT, BESIDE = 1e-20, 1e-2, 2.0**-51
"""Of contact radii over the zone of a contact that closes: what counts as none, and what is below every end; of radii
over that of a break: what is beside it."""
WALKED, STEPS, LOOKS, CLOSE = 90, 80, 60, 1e-9
"""States of a walk and of a search, looks at one of them, and how near a walk comes to the end of a profile."""
DEGREES, STIFF, ROUGH, FURTHEST, FINE, NOISE = (0.5, 16.0), 1e8, 0.2, 3.0, 1e-7, 1e-13
"""Degrees of the gap but next to breaks, and in the place of one where there is no gap yet; what the last step may
change by itself, the largest step in ln q, one that leaves a load exact, and one that is rounding."""
NARROW, NARROWEST = 1e-4, 1e-6
"""Over a: a q at which the degree of the gap has lost half of its digits, and at which it is nearly all rounding."""
SETTLED, SMALL, PATIENCE, STEEP = 1e-15, 1e-4, 8, 8.0
"""What a last step leaves and what is missed before it, where a search ends; the steps after which every other one
halves unless it gets shorter; and the rate, over that of the chord, where none begins."""
ROUNDING, MARGIN, LOOSE, ALIKE = 4e-15, 0.05, 8.0, 0.5
"""How far below pull-off a load counts as that; in ln a: how far beyond a state in doubt the root may be, by itself and
by its last step, and the length of a secant."""
SHORTEST, LONGEST, BEYOND = 0.7, 27.0, 1.2
"""Steps of a walk in ln a, and how far beyond what is looked for they aim."""


class State(NamedTuple):
    """Contact radius, q and load; above a ratio of 1 the load grows.  Rates are those with ln a."""

    a: Array
    q: Array
    ratio: Array
    """Rate of the gap with c over that at which the load does not change with a; not a number beyond the profile."""
    load: Array
    """Not a number where it is not asked for."""
    widening: Array
    """Rate of ln q."""
    steepening: Array
    """Rate of ln ratio, for a gap that goes on like a power."""
    gain: Array
    """Rate of the load."""
    off: Array
    """How far ln q was from the root at the last look."""
    doubt: Array
    """What that may leave wrong of ln ratio."""
    blur: Array
    """What that may leave wrong of the load."""


class Stretch(NamedTuple):
    """Contact radii in ascending order that separate the minima of the load."""

    first: Array
    """Radius of the zone of a contact that closes."""
    radii: list[Array]
    top: Array | float
    """What no radius is above."""
    rises: bool
    """Whether a load that falls at the last of them may grow beyond."""


Near = Callable[[Array, Array], State]
"""The state at a radius, from a guess of q."""
Loaded = Callable[[Array, Array], Array]
"""The load at a radius and a q."""
Missed = Callable[[State], tuple[Array, Array, Array]]
"""Below 0 before what is looked for, above 0 beyond; its rate with ln a; and what may be wrong of it."""


def radii(first: Array) -> Stretch:
    """Of an endless profile without breaks."""
    return Stretch(first, [first], np.inf, True)


def radii_by(first: Array, corner: Array) -> Stretch:
    """Of a profile with a break."""
    return Stretch(first, [corner * share for share in CORNER], np.inf, True)


def radii_up_to(first: Array, largest: Array) -> Stretch:
    """Of a profile that ends steeply, where the load has one minimum."""
    return Stretch(first, [SHORT * first], WITHIN * largest, True)


def radii_on_bump(first: Array, largest: Array) -> Stretch:
    """Of a profile that ends level."""
    own = [SHORT * BUMP[0] * first, *[largest * share for share in BUMP]]
    return Stretch(first, own, WITHIN * largest, False)


def state_near(
    opened: Opening,
    growth: Array,
    start: Array,
    a: Array,
    control: str,
    E_star: Array,
    dgamma: Array,
    sigma_0: Array,
    largest: Array | float = np.inf,
) -> State:
    """The state at a contact radius from a guess of q, with g'(a).

    The last step to the root of the zone is not looked at: what it changes is known.  The gap is a function of a and c
    of a degree n, a dgap/da + c dgap/dc = n gap, and its rate one of the degree n - 1, as far as n is constant.
    """
    share, value, last = 4.0 / np.pi * (sigma_0 / E_star), dgamma / sigma_0, WITHIN * largest
    lifted = 2.0 / np.pi * growth * a
    q, low, high = np.minimum(start, last), 0.0 * start, last + 0.0 * start
    for _ in range(LOOKS):
        c, angle = np.hypot(a, q), np.arctan2(q, a)
        gap, rate = opened(q, a)
        whole, rise = with_ring(gap, rate, q, a, share)
        short_of = (value - whole) / whole
        nearly = np.abs(short_of) < 0.5
        off = np.where(nearly, np.log1p(np.where(nearly, short_of, 0.0)), np.log(value / whole)) * whole / rise
        off = np.minimum(np.maximum(off, -FURTHEST), FURTHEST)
        # the share of the edge at a in the rate of the gap
        edge = np.where(rate > 0.0, lifted * (a / c) / np.where(rate > 0.0, q * rate, 1.0), 0.0)
        known = gap > 0.0
        degree = (c * rate - lifted * angle) / np.where(known, gap, 1.0)
        degree = np.where(known, np.where(q > NARROWEST * a, degree, 2.0), STIFF)
        doubt = np.abs(off) * (1.0 + edge + np.abs(degree) + q / (largest - q))
        left = (doubt > ROUGH) & (np.abs(off) > FINE) & ((off < 0.0) | (q < last))
        if not np.count_nonzero(left):
            break
        low, high = np.where(off > 0.0, q, low), np.where(off < 0.0, q, high)
        ahead = np.minimum(q * np.exp(off), last)
        # where the gap begins, steps would go to and fro
        halved = np.sqrt(np.maximum(low, LEAST * high)) * np.sqrt(high)
        q = np.where(left, np.where((ahead > low) & (ahead <= high), ahead, halved), q)
    reached = (q < last) | (off <= 0.0)
    power = np.minimum(np.maximum(degree, DEGREES[0]), DEGREES[1]) - 1.0
    sine = q / c
    along = sine * sine * (power + edge)
    gap = gap * np.exp(off * np.where(known, q * sine * rate / np.where(known, gap, 1.0), 0.0))
    rate = rate * np.exp(np.minimum(np.maximum(off * along, -FURTHEST), FURTHEST))
    q = q * np.exp(off)
    c, angle = np.hypot(a, q), np.arctan2(q, a)
    sine, cosine, short = q / c, a / c, q / c * (q / (c + a))
    _, rise = with_ring(gap, rate, q, a, share)
    # what the gap gains with a where q stays: the difference of two large numbers in one form or in the other
    gained = np.where(q < a, degree * gap - q * sine * rate, a * cosine * rate - lifted * angle)
    widening = (share * a * cosine * short - gained) / rise
    steepening = cosine * cosine * power - sine * sine * edge + along * widening
    turn = sine * cosine * (widening - 1.0)
    level, bend, ratio = short, sine, rate / share
    if control == "force":
        # what the ring adds to the gap and takes of the load has fallen out
        level, bend, ratio = cosine * short + angle * angle, (2.0 * cosine - 1.0) * sine + 2.0 * angle, ratio * cosine
        steepening = steepening + sine * sine * (1.0 - widening)
        pull = 4.0 * sigma_0 * q * (q * angle + a)
        gain = 2.0 * E_star * a * a * growth - 4.0 * sigma_0 * a * a * angle - pull * widening
    else:
        pull = 2.0 * (sigma_0 / E_star) * q
        gain = a * growth - pull * widening
    steepening = steepening - bend * turn / level
    ratio, blur = np.where(reached, ratio / level, np.nan), pull * np.abs(off) * doubt
    return State(a, q, ratio, np.nan * a, widening, steepening, gain, off, doubt, blur)


def radius_of_pull_off(near: Near, loaded: Loaded, stretch: Stretch) -> Array:
    """That of the least load: 0 where it falls as long as there is a contact, not a number beyond the profile."""
    risen = _risen(near, _walked(near, stretch, _by_ratio, _never), stretch.first == stretch.first)
    return _least([(_weighed(loaded, start, grows), high, grows) for start, high, grows in risen]).a


def radius_under(near_to: Near, loaded: Loaded, value: Array, stretch: Stretch) -> Array:
    """The largest radius with this load where the load grows, from that of the least load on."""

    def near(a: Array, start: Array) -> State:
        # one that is on neither side of the value is looked at again
        state = _weighed(loaded, near_to(a, start), value == value)
        unclear = (np.abs(state.load - value) <= state.blur) & (np.abs(state.off) > NOISE)
        if not np.count_nonzero(unclear):
            return state
        return _chosen(unclear, _weighed(loaded, near_to(a, state.q), value == value), state)

    def missed(state: State) -> tuple[Array, Array, Array]:
        # a load that falls, or is nothing yet, says nothing of the way
        some, falls, below = state.load > 0.0, state.ratio < 1.0, state.load < value
        far = np.where(some, np.log(np.maximum(state.load, LEAST * value) / value), -SHORTEST)
        rate = np.where(falls, state.steepening, np.where(some, state.gain / np.where(some, state.load, 1.0), 0.0))
        return np.where(falls, np.log(state.ratio), np.where(below, far, 0.0)), rate, state.doubt

    # where the load grows at a radius and is below the value, and reaches it above, minima further down do not matter
    found = _walked(near, stretch, missed, lambda state: (state.ratio >= 1.0) & (state.load <= value))
    if np.all(found[0].a > 0.0) and not np.all(found[-1].load >= value):
        found = _walked(near, stretch, missed, _never)
    sought = value == value
    for low, high in zip(found, found[1:], strict=False):
        # beyond the radii there is one minimum, above which the load grows
        grows = (low.a >= stretch.radii[-1]) & (low.ratio >= 1.0)
        sought = sought & np.logical_not(grows & (low.load <= value) & (high.load >= value))
    risen, left = _risen(near, found, sought), value < np.inf
    least, a = _least(risen), np.full_like(value, np.nan)
    for start, high, _ in risen[::-1]:
        met = left & (start.load - value <= ROUNDING * (np.abs(start.load) + np.abs(value))) & (high.load >= value)
        met = met & (start.a >= least.a)
        there = _between(near, _by_load(value, least), start, high, met, exact=True)
        a, left = np.where(met, np.where(np.isnan(there.a), start.a, there.a), a), left & np.logical_not(met)
    return a


def _risen(near: Near, found: list[State], sought: Array) -> list[tuple[State, State, Array]]:
    """States, or minima between two that are sought, with those that follow; and where the load begins to grow."""
    risen, grown = [], sought & False
    for low, high in zip(found, found[1:], strict=False):
        dips, begins = sought & (low.ratio < 1.0) & (high.ratio >= 1.0), (low.ratio >= 1.0) & np.logical_not(grown)
        # its load is compared with that of a minimum, which is exact
        vague = begins & (np.abs(low.off) > FINE)
        if np.count_nonzero(vague):
            low = _chosen(vague, near(low.a, low.q), low)
        start = _chosen(dips, _between(near, _by_ratio, low, high, dips), low)
        risen.append((start, high, dips | begins))
        grown = dips | (low.ratio >= 1.0)
    return risen


def _least(risen: list[tuple[State, State, Array]]) -> State:
    """The state of the least load of those from which it grows."""
    best = _none(risen[0][0])
    for start, _, grows in risen:
        best = _chosen(grows & (start.load < best.load), start, best)
    return best


def parted(opened: Opening, first: Array, E_star: Array, sigma_0: Array) -> Array:
    """The radius c of a zone without contact, up to its first one, at which the depth is least; 0 where it falls."""
    near = _without_contact(opened, E_star, sigma_0)
    return _least_depth(near, near(LEAST * first, first), near(first, first))


def parted_by(opened: Opening, first: Array, corner: Array, E_star: Array, sigma_0: Array) -> Array:
    """The same for a profile with a break, at which its slope may jump."""
    near = _without_contact(opened, E_star, sigma_0)
    before, after, beyond = near((1.0 - BESIDE) * corner, first), near((1.0 + BESIDE) * corner, first), first > corner

    def elsewhere() -> Array:
        low = _chosen(beyond & (after.ratio < 1.0), after, near(LEAST * first, first))
        high = _chosen(beyond & (before.ratio >= 1.0), before, near(first, first))
        return _least_depth(near, low, high)

    return either(beyond & (before.ratio < 1.0) & (after.ratio >= 1.0), lambda: corner + 0.0 * first, elsewhere)


def _without_contact(opened: Opening, E_star: Array, sigma_0: Array) -> Near:
    def near(c: Array, q: Array) -> State:
        gap, rate = opened(c, np.zeros_like(c))
        ratio, known = rate / (4.0 / np.pi * (sigma_0 / E_star)), gap > 0.0
        degree = np.where(known, c * rate / np.where(known, gap, 1.0), 2.0)
        return State(c, c, ratio, ratio, np.ones_like(c), degree - 1.0, ratio, 0.0 * q, 0.0 * q, 0.0 * q)

    return near


def _least_depth(near: Near, low: State, high: State) -> Array:
    least = _between(near, _by_ratio, low, high, high.ratio >= 1.0)
    return np.where(np.isnan(least.a), 0.0, least.a)


def _by_ratio(state: State) -> tuple[Array, Array, Array]:
    return np.log(state.ratio), state.steepening, state.doubt


def _by_load(value: Array, least: State) -> Missed:
    """What is missed of a load above the least one, which grows as (ln a)**2 there and as a power of a far from it."""
    size = np.abs(least.load)
    wanted = np.sqrt((value - least.load) / size)

    def missed(state: State) -> tuple[Array, Array, Array]:
        known = np.sqrt(np.maximum(state.load - least.load, 0.0) / size)
        same = np.abs(state.load - value) <= ROUNDING * (size + np.abs(value))
        slope = 1.0 / size / np.where(known > 0.0, 2.0 * known * (1.0 + known), 1.0)
        return np.where(same, 0.0, np.log1p(known) - np.log1p(wanted)), state.gain * slope, state.blur * slope

    return missed


def _weighed(loaded: Loaded, state: State, asked: Array) -> State:
    """A state with its load where that is asked for."""
    load = either(asked, lambda: loaded(state.a, state.q), lambda: np.full_like(state.a, np.inf))
    return state._replace(load=load)


def _none(state: State) -> State:
    """In the place of a state: there is none."""
    nothing = np.full_like(state.a, np.nan)
    return state._replace(a=nothing, ratio=nothing, load=np.full_like(state.load, np.inf))


def _chosen(condition: Array, one: State, other: State) -> State:
    return State(*[np.where(condition, x, y) for x, y in zip(one, other, strict=True)])


def _never(state: State) -> Array:
    return state.ratio < 0.0


def _walked(near: Near, stretch: Stretch, missed: Missed, enough: Callable[[State], Array]) -> list[State]:
    """States in ascending order on to where nothing is missed, or to the end of the profile.

    They begin at the highest of the radii if there is `enough` there or beyond, or further down: at the highest with
    enough, without a contact if there is none.
    """
    first, own, top, _ = stretch
    beyond = _beyond(near, near(own[-1], first), stretch, missed)
    met = enough(beyond[0])
    for here in beyond[1:]:
        met = met | enough(here)
    if np.all(met):
        return beyond
    states = beyond[:1]
    for a in own[:-1][::-1]:
        states.append(near(a, _guess(states[-1], a)))
        if np.all(enough(states[-1])):
            break
    found = [] if np.all(enough(states[-1])) else [near(np.zeros_like(first), first)]
    for here in [*states[1:][::-1], *beyond]:
        # no state: the zone would reach beyond the profile
        reached = here.ratio == here.ratio
        top = np.where(reached, top, np.minimum(here.a, top))
        found.append(_chosen(reached, here, found[-1]) if found else here)
    if not np.all(beyond[0].ratio == beyond[0].ratio):
        found = [*found, *_beyond(near, found[-1], stretch._replace(top=top), missed)[1:]]
    return found


def _beyond(near: Near, last: State, stretch: Stretch, missed: Missed) -> list[State]:
    """A state and those beyond it, as long as something is missed."""
    found, top, rises = [last], stretch.top, stretch.rises
    step, ended = np.full_like(last.a, SHORTEST), last.a != last.a
    for _ in range(WALKED):
        short, rate, _ = missed(last)
        more = (short < 0.0) & (last.a * (1.0 + CLOSE) < top) & (rises | (last.ratio >= 1.0))
        more = more & (last.ratio == last.ratio)
        if not np.count_nonzero(more):
            break
        aimed = np.where(rate > 0.0, -BEYOND * short / np.where(rate > 0.0, rate, 1.0), step)
        step = np.minimum(np.maximum(aimed, step), LONGEST)
        # halves of the way to where there was none
        ahead = np.where(ended, np.sqrt(last.a * top), top)
        a = np.where(more, np.minimum(last.a * np.exp(step), ahead), last.a)
        here, step = near(a, _guess(last, a)), 2.0 * step
        reached = here.ratio == here.ratio
        last, top = _chosen(more & reached, here, last), np.where(reached, top, a)
        ended = ended | np.logical_not(reached)
        found.append(last)
    return found


def _guess(state: State, a: Array) -> Array:
    """q at another radius; next to a break its rate is that of the break alone."""
    known = (state.a > 0.0) & (state.ratio == state.ratio) & (np.abs(state.widening) < 1.0 / NARROWEST)
    wider = np.log(np.where(known, a / np.where(known, state.a, 1.0), 1.0)) * np.where(known, state.widening, 0.0)
    return state.q * np.exp(np.minimum(np.maximum(wider, -FURTHEST), FURTHEST))


def _between(near: Near, missed: Missed, low: State, high: State, holds: Array, exact: bool = False) -> State:
    """Where what is missed changes its sign between two states, by steps along its rate, or secants, or halves."""
    unit = high.a
    (y_low, rate_low, doubt_low), (y, rate, doubt) = missed(low), missed(high)
    bottom = np.log(np.maximum(low.a / unit, LEAST)) - np.where(np.abs(y_low) < doubt_low, MARGIN, 0.0)
    top = np.where(np.abs(y) < doubt, MARGIN, 0.0 * unit)
    holds = holds & (y_low < 0.0)
    if not np.count_nonzero(holds):
        return _none(high)
    # not from where the rate is infinite, or nearly so
    closer = (low.a > 0.0) & (-y_low < y) & (rate_low * (top - bottom) < STEEP * (y - y_low))
    here, best, left = _chosen(closer, low, high), high, holds
    x = np.where(closer, np.log(np.maximum(low.a / unit, LEAST)), 0.0)
    (y, rate, doubt), moved, bend = missed(here), np.ones_like(unit), np.ones_like(unit) / SETTLED
    for number in range(STEPS):
        # in doubt it may be on the other side of a break; before one, the rate of no gap does not tell
        sure = ((np.minimum(np.abs(y), ROUGH) >= doubt) & (y > -np.inf)) | (np.abs(here.off) <= NOISE)
        # the last step may have led over a break, where rates jump and loads do not
        loose = 0.0 if exact else np.where(np.abs(here.off) <= NOISE, 0.0, LOOSE * np.abs(here.off))
        bottom = np.where(sure & (y < 0.0), np.maximum(bottom, x - loose), bottom)
        top = np.where(sure & (y > 0.0), np.minimum(top, x + loose), top)
        # a state in doubt is looked at again
        aim = np.where(sure, x - y / np.where(rate > 0.0, rate, 1.0), x)
        # nor does a rate that is infinite lead anywhere
        stuck = sure & (np.abs(y) > SMALL) & (np.abs(aim - x) <= SETTLED)
        halved = stuck | np.logical_not((aim >= bottom) & (aim <= top))
        if number >= PATIENCE and number % 2 == 0:
            halved = halved | (sure & (4.0 * np.abs(aim - x) > moved))
        aim = np.where(halved, 0.5 * (bottom + top), aim)
        # where what is missed jumps, as close as numbers are, and before it: beyond a break loads grow steeply
        step, closed = np.abs(aim - x), top - bottom <= 0.25 * SETTLED
        a = unit * np.exp(np.where(closed, bottom, aim))
        q = _guess(here, a)
        best = _chosen(left, here._replace(a=a, q=q), best)
        narrow = here.q <= NARROW * here.a
        after = np.where(halved, 1.0, np.where(narrow | (not exact), np.maximum(moved, step), step))
        known = sure & (np.abs(here.off) <= FINE) & (np.abs(y) <= SMALL)
        left = left & ((step * after * bend > SETTLED) | np.logical_not(known)) & np.logical_not(closed)
        if not np.count_nonzero(left):
            break
        here = near(a, q)
        before, x, moved = (x, y, rate), aim, np.where(step > 0.0, step, moved)
        y, rate, doubt = missed(here)
        alike = (step < ALIKE) & (step > 0.0) & (narrow | (not exact)) & (before[1] > -np.inf) & (y > -np.inf)
        secant = np.where(alike, (y - before[1]) / np.where(alike, x - before[0], 1.0), 0.0)
        rate = np.where(secant > 0.0, secant, rate)
        # beyond a break the rate changes as fast as the root of what is left to it
        apart = step * np.where(rate > 0.0, rate, 0.0)
        turned = np.abs(rate - before[2]) / np.where(apart > 0.0, apart, 1.0)
        bend = np.where((apart > 0.0) & (turned < np.inf), np.maximum(turned, 1.0), bend)
    return _chosen(holds, best, _none(best))
