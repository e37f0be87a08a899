"""Bodies of axicontact._runtime.physics.cohesive_states over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.interface import either
from ....._programs.bodies._runtime.physics.cohesive import with_ring
from ....._runtime.physics.cohesive_states import State, Stretch
from ....._runtime.plain import MATH as np

ALIKE = 0.5
BESIDE = 4.440892098500626e-16
BEYOND = 1.2
BUMP = (0.1, 0.25, 0.4, 0.55, 0.7, 0.85, 0.95,)
CLOSE = 1e-09
CORNER = (0.5, 0.9, 1.0, 1.01, 1.1, 1.5, 3.0,)
DEGREES = (0.5, 16.0,)
FINE = 1e-07
FURTHEST = 3.0
LEAST = 1e-20
LONGEST = 27.0
LOOKS = 60
LOOSE = 8.0
MARGIN = 0.05
NARROW = 0.0001
NARROWEST = 1e-06
NOISE = 1e-13
PATIENCE = 8
ROUGH = 0.2
ROUNDING = 4e-15
SETTLED = 1e-15
SHORT = 0.01
SHORTEST = 0.7
SMALL = 0.0001
STEEP = 8.0
STEPS = 80
STIFF = 100000000.0
WALKED = 90
WITHIN = 0.999999


def radii(first):
    """Of an endless profile without breaks."""
    return Stretch(first, [first], np.inf, True)


def radii_by(first, corner):
    """Of a profile with a break."""
    return Stretch(first, [corner * share for share in CORNER], np.inf, True)


def radii_up_to(first, largest):
    """Of a profile that ends steeply, where the load has one minimum."""
    return Stretch(first, [SHORT * first], WITHIN * largest, True)


def radii_on_bump(first, largest):
    """Of a profile that ends level."""
    own = [SHORT * BUMP[0] * first, *[largest * share for share in BUMP]]
    return Stretch(first, own, WITHIN * largest, False)


def state_near(opened, growth, start, a, control, E_star, dgamma, sigma_0, largest=np.inf):
    """The state at a contact radius from a guess of q, with g'(a).

    The last step to the root of the zone is not looked at: what it changes is known.  The gap is a function of a and c
    of a degree n, a dgap/da + c dgap/dc = n gap, and its rate one of the degree n - 1, as far as n is constant.
    """
    share, value, last = (4.0 / np.pi * (sigma_0 / E_star), dgamma / sigma_0, WITHIN * largest)
    lifted = 2.0 / np.pi * growth * a
    q, low, high = (np.minimum(start, last), 0.0 * start, last + 0.0 * start)
    for _ in range(LOOKS):
        c, angle = (np.hypot(a, q), np.arctan2(q, a))
        gap, rate = opened(q, a)
        whole, rise = with_ring(gap, rate, q, a, share)
        short_of = (value - whole) / whole
        nearly = np.abs(short_of) < 0.5
        off = (np.log1p(short_of if nearly else 0.0) if nearly else np.log(value / whole)) * whole / rise
        off = np.minimum(np.maximum(off, -FURTHEST), FURTHEST)
        edge = lifted * (a / c) / (q * rate if rate > 0.0 else 1.0) if rate > 0.0 else 0.0
        known = gap > 0.0
        degree = (c * rate - lifted * angle) / (gap if known else 1.0)
        degree = (degree if q > NARROWEST * a else 2.0) if known else STIFF
        doubt = np.abs(off) * (1.0 + edge + np.abs(degree) + q / (largest - q))
        left = (doubt > ROUGH) & (np.abs(off) > FINE) & ((off < 0.0) | (q < last))
        if not np.count_nonzero(left):
            break
        low, high = (q if off > 0.0 else low, q if off < 0.0 else high)
        ahead = np.minimum(q * np.exp(off), last)
        halved = np.sqrt(np.maximum(low, LEAST * high)) * np.sqrt(high)
        q = (ahead if (ahead > low) & (ahead <= high) else halved) if left else q
    reached = (q < last) | (off <= 0.0)
    power = np.minimum(np.maximum(degree, DEGREES[0]), DEGREES[1]) - 1.0
    sine = q / c
    along = sine * sine * (power + edge)
    gap = gap * np.exp(off * (q * sine * rate / (gap if known else 1.0) if known else 0.0))
    rate = rate * np.exp(np.minimum(np.maximum(off * along, -FURTHEST), FURTHEST))
    q = q * np.exp(off)
    c, angle = (np.hypot(a, q), np.arctan2(q, a))
    sine, cosine, short = (q / c, a / c, q / c * (q / (c + a)))
    _, rise = with_ring(gap, rate, q, a, share)
    gained = degree * gap - q * sine * rate if q < a else a * cosine * rate - lifted * angle
    widening = (share * a * cosine * short - gained) / rise
    steepening = cosine * cosine * power - sine * sine * edge + along * widening
    turn = sine * cosine * (widening - 1.0)
    level, bend, ratio = (short, sine, rate / share)
    if control == 'force':
        level, bend, ratio = (cosine * short + angle * angle, (2.0 * cosine - 1.0) * sine + 2.0 * angle, ratio * cosine)
        steepening = steepening + sine * sine * (1.0 - widening)
        pull = 4.0 * sigma_0 * q * (q * angle + a)
        gain = 2.0 * E_star * a * a * growth - 4.0 * sigma_0 * a * a * angle - pull * widening
    else:
        pull = 2.0 * (sigma_0 / E_star) * q
        gain = a * growth - pull * widening
    steepening = steepening - bend * turn / level
    ratio, blur = (ratio / level if reached else np.nan, pull * np.abs(off) * doubt)
    return State(a, q, ratio, np.nan * a, widening, steepening, gain, off, doubt, blur)


def radius_of_pull_off(near, loaded, stretch):
    """That of the least load: 0 where it falls as long as there is a contact, not a number beyond the profile."""
    risen = _risen(near, _walked(near, stretch, _by_ratio, _never), stretch.first == stretch.first)
    return _least([(_weighed(loaded, start, grows), high, grows) for start, high, grows in risen]).a


def radius_under(near_to, loaded, value, stretch):
    """The largest radius with this load where the load grows, from that of the least load on."""

    def near(a, start):
        state = _weighed(loaded, near_to(a, start), value == value)
        unclear = (np.abs(state.load - value) <= state.blur) & (np.abs(state.off) > NOISE)
        if not np.count_nonzero(unclear):
            return state
        return _chosen(unclear, _weighed(loaded, near_to(a, state.q), value == value), state)

    def missed(state):
        some, falls, below = (state.load > 0.0, state.ratio < 1.0, state.load < value)
        far = np.log(np.maximum(state.load, LEAST * value) / value) if some else -SHORTEST
        rate = state.steepening if falls else state.gain / (state.load if some else 1.0) if some else 0.0
        return (np.log(state.ratio) if falls else far if below else 0.0, rate, state.doubt)
    found = _walked(near, stretch, missed, lambda state: (state.ratio >= 1.0) & (state.load <= value))
    if np.all(found[0].a > 0.0) and (not np.all(found[-1].load >= value)):
        found = _walked(near, stretch, missed, _never)
    sought = value == value
    for low, high in zip(found, found[1:], strict=False):
        grows = (low.a >= stretch.radii[-1]) & (low.ratio >= 1.0)
        sought = sought & np.logical_not(grows & (low.load <= value) & (high.load >= value))
    risen, left = (_risen(near, found, sought), value < np.inf)
    least, a = (_least(risen), np.full_like(value, np.nan))
    for start, high, _ in risen[::-1]:
        met = left & (start.load - value <= ROUNDING * (np.abs(start.load) + np.abs(value))) & (high.load >= value)
        met = met & (start.a >= least.a)
        there = _between(near, _by_load(value, least), start, high, met, exact=True)
        a, left = ((start.a if np.isnan(there.a) else there.a) if met else a, left & np.logical_not(met))
    return a


def _risen(near, found, sought):
    """States, or minima between two that are sought, with those that follow; and where the load begins to grow."""
    risen, grown = ([], sought & False)
    for low, high in zip(found, found[1:], strict=False):
        dips, begins = (sought & (low.ratio < 1.0) & (high.ratio >= 1.0), (low.ratio >= 1.0) & np.logical_not(grown))
        vague = begins & (np.abs(low.off) > FINE)
        if np.count_nonzero(vague):
            low = _chosen(vague, near(low.a, low.q), low)
        start = _chosen(dips, _between(near, _by_ratio, low, high, dips), low)
        risen.append((start, high, dips | begins))
        grown = dips | (low.ratio >= 1.0)
    return risen


def _least(risen):
    """The state of the least load of those from which it grows."""
    best = _none(risen[0][0])
    for start, _, grows in risen:
        best = _chosen(grows & (start.load < best.load), start, best)
    return best


def parted(opened, first, E_star, sigma_0):
    """The radius c of a zone without contact, up to its first one, at which the depth is least; 0 where it falls."""
    near = _without_contact(opened, E_star, sigma_0)
    return _least_depth(near, near(LEAST * first, first), near(first, first))


def parted_by(opened, first, corner, E_star, sigma_0):
    """The same for a profile with a break, at which its slope may jump."""
    near = _without_contact(opened, E_star, sigma_0)
    before, after, beyond = (near((1.0 - BESIDE) * corner, first), near((1.0 + BESIDE) * corner, first), first > corner)

    def elsewhere():
        low = _chosen(beyond & (after.ratio < 1.0), after, near(LEAST * first, first))
        high = _chosen(beyond & (before.ratio >= 1.0), before, near(first, first))
        return _least_depth(near, low, high)
    return either(beyond & (before.ratio < 1.0) & (after.ratio >= 1.0), lambda: corner + 0.0 * first, elsewhere)


def _without_contact(opened, E_star, sigma_0):

    def near(c, q):
        gap, rate = opened(c, np.zeros_like(c))
        ratio, known = (rate / (4.0 / np.pi * (sigma_0 / E_star)), gap > 0.0)
        degree = c * rate / (gap if known else 1.0) if known else 2.0
        return State(c, c, ratio, ratio, np.ones_like(c), degree - 1.0, ratio, 0.0 * q, 0.0 * q, 0.0 * q)
    return near


def _least_depth(near, low, high):
    least = _between(near, _by_ratio, low, high, high.ratio >= 1.0)
    return 0.0 if np.isnan(least.a) else least.a


def _by_ratio(state):
    return (np.log(state.ratio), state.steepening, state.doubt)


def _by_load(value, least):
    """What is missed of a load above the least one, which grows as (ln a)**2 there and as a power of a far from it."""
    size = np.abs(least.load)
    wanted = np.sqrt((value - least.load) / size)

    def missed(state):
        known = np.sqrt(np.maximum(state.load - least.load, 0.0) / size)
        same = np.abs(state.load - value) <= ROUNDING * (size + np.abs(value))
        slope = 1.0 / size / (2.0 * known * (1.0 + known) if known > 0.0 else 1.0)
        return (0.0 if same else np.log1p(known) - np.log1p(wanted), state.gain * slope, state.blur * slope)
    return missed


def _weighed(loaded, state, asked):
    """A state with its load where that is asked for."""
    load = either(asked, lambda: loaded(state.a, state.q), lambda: np.full_like(state.a, np.inf))
    return state._replace(load=load)


def _none(state):
    """In the place of a state: there is none."""
    nothing = np.full_like(state.a, np.nan)
    return state._replace(a=nothing, ratio=nothing, load=np.full_like(state.load, np.inf))


def _chosen(condition, one, other):
    return State(*[x if condition else y for x, y in zip(one, other, strict=True)])


def _never(state):
    return state.ratio < 0.0


def _walked(near, stretch, missed, enough):
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
        reached = here.ratio == here.ratio
        top = top if reached else np.minimum(here.a, top)
        found.append(_chosen(reached, here, found[-1]) if found else here)
    if not np.all(beyond[0].ratio == beyond[0].ratio):
        found = [*found, *_beyond(near, found[-1], stretch._replace(top=top), missed)[1:]]
    return found


def _beyond(near, last, stretch, missed):
    """A state and those beyond it, as long as something is missed."""
    found, top, rises = ([last], stretch.top, stretch.rises)
    step, ended = (np.full_like(last.a, SHORTEST), last.a != last.a)
    for _ in range(WALKED):
        short, rate, _ = missed(last)
        more = (short < 0.0) & (last.a * (1.0 + CLOSE) < top) & (rises | (last.ratio >= 1.0))
        more = more & (last.ratio == last.ratio)
        if not np.count_nonzero(more):
            break
        aimed = -BEYOND * short / (rate if rate > 0.0 else 1.0) if rate > 0.0 else step
        step = np.minimum(np.maximum(aimed, step), LONGEST)
        ahead = np.sqrt(last.a * top) if ended else top
        a = np.minimum(last.a * np.exp(step), ahead) if more else last.a
        here, step = (near(a, _guess(last, a)), 2.0 * step)
        reached = here.ratio == here.ratio
        last, top = (_chosen(more & reached, here, last), top if reached else a)
        ended = ended | np.logical_not(reached)
        found.append(last)
    return found


def _guess(state, a):
    """q at another radius; next to a break its rate is that of the break alone."""
    known = (state.a > 0.0) & (state.ratio == state.ratio) & (np.abs(state.widening) < 1.0 / NARROWEST)
    wider = np.log(a / (state.a if known else 1.0) if known else 1.0) * (state.widening if known else 0.0)
    return state.q * np.exp(np.minimum(np.maximum(wider, -FURTHEST), FURTHEST))


def _between(near, missed, low, high, holds, exact=False):
    """Where what is missed changes its sign between two states, by steps along its rate, or secants, or halves."""
    unit = high.a
    (y_low, rate_low, doubt_low), (y, rate, doubt) = (missed(low), missed(high))
    bottom = np.log(np.maximum(low.a / unit, LEAST)) - (MARGIN if np.abs(y_low) < doubt_low else 0.0)
    top = MARGIN if np.abs(y) < doubt else 0.0 * unit
    holds = holds & (y_low < 0.0)
    if not np.count_nonzero(holds):
        return _none(high)
    closer = (low.a > 0.0) & (-y_low < y) & (rate_low * (top - bottom) < STEEP * (y - y_low))
    here, best, left = (_chosen(closer, low, high), high, holds)
    x = np.log(np.maximum(low.a / unit, LEAST)) if closer else 0.0
    (y, rate, doubt), moved, bend = (missed(here), np.ones_like(unit), np.ones_like(unit) / SETTLED)
    for number in range(STEPS):
        sure = (np.minimum(np.abs(y), ROUGH) >= doubt) & (y > -np.inf) | (np.abs(here.off) <= NOISE)
        loose = 0.0 if exact else 0.0 if np.abs(here.off) <= NOISE else LOOSE * np.abs(here.off)
        bottom = np.maximum(bottom, x - loose) if sure & (y < 0.0) else bottom
        top = np.minimum(top, x + loose) if sure & (y > 0.0) else top
        aim = x - y / (rate if rate > 0.0 else 1.0) if sure else x
        stuck = sure & (np.abs(y) > SMALL) & (np.abs(aim - x) <= SETTLED)
        halved = stuck | np.logical_not((aim >= bottom) & (aim <= top))
        if number >= PATIENCE and number % 2 == 0:
            halved = halved | sure & (4.0 * np.abs(aim - x) > moved)
        aim = 0.5 * (bottom + top) if halved else aim
        step, closed = (np.abs(aim - x), top - bottom <= 0.25 * SETTLED)
        a = unit * np.exp(bottom if closed else aim)
        q = _guess(here, a)
        best = _chosen(left, here._replace(a=a, q=q), best)
        narrow = here.q <= NARROW * here.a
        after = 1.0 if halved else np.maximum(moved, step) if narrow | (not exact) else step
        known = sure & (np.abs(here.off) <= FINE) & (np.abs(y) <= SMALL)
        left = left & ((step * after * bend > SETTLED) | np.logical_not(known)) & np.logical_not(closed)
        if not np.count_nonzero(left):
            break
        here = near(a, q)
        before, x, moved = ((x, y, rate), aim, step if step > 0.0 else moved)
        y, rate, doubt = missed(here)
        alike = (step < ALIKE) & (step > 0.0) & (narrow | (not exact)) & (before[1] > -np.inf) & (y > -np.inf)
        secant = (y - before[1]) / (x - before[0] if alike else 1.0) if alike else 0.0
        rate = secant if secant > 0.0 else rate
        apart = step * (rate if rate > 0.0 else 0.0)
        turned = np.abs(rate - before[2]) / (apart if apart > 0.0 else 1.0)
        bend = np.maximum(turned, 1.0) if (apart > 0.0) & (turned < np.inf) else bend
    return _chosen(holds, best, _none(best))
