"""Bodies of axicontact._runtime.physics.cohesive_states over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._runtime.physics.cohesive_states import State, Stretch
from ....._runtime.plain import MATH as np

BEYOND = 1.2
BUMP = (0.1, 0.25, 0.4, 0.55, 0.7, 0.85, 0.95,)
CLOSE = 1e-09
CORNER = (0.5, 0.9, 1.0, 1.01, 1.1, 1.5, 3.0,)
FLAT = 0.3
LEAST = 1e-20
LONGEST = 27.0
ROUNDING = 1e-15
SETTLED = 1e-11
SHORT = 0.01
SHORTEST = 0.7
STEEP = 1.0
STEPS = 60
UNMOVED = 1e-15
WALKED = 90
WITHIN = 0.999999


def radii(first):
    """Of an endless profile without breaks."""
    return Stretch(first, [first], np.inf, endless, True)


def radii_by(first, corner):
    """Of a profile with a break."""
    return Stretch(first, [corner * share for share in CORNER], np.inf, endless, True)


def radii_up_to(first, largest, within):
    """Of a profile that ends steeply, where the load has one minimum."""
    return Stretch(first, [SHORT * first], WITHIN * largest, within, True)


def radii_on_bump(first, largest, within):
    """Of a profile that ends level."""
    own = [SHORT * BUMP[0] * first, *[largest * share for share in BUMP]]
    return Stretch(first, own, WITHIN * largest, within, False)


def endless(a):
    return a


def radius_of_pull_off(near, stretch):
    """That of the least load: 0 where it falls as long as there is a contact, not a number beyond the profile."""
    return _least(_risen(near, _walked(near, stretch, _by_ratio, _never))).a


def radius_under(near, value, stretch):
    """The largest radius with this load where the load grows, from that of the least load on."""

    def missed(state):
        far = np.log(np.maximum(state.load, LEAST * value) / value) if state.load > 0.0 else -SHORTEST
        return np.log(state.ratio) if state.ratio < 1.0 else far if state.load < value else 0.0
    found = _walked(near, stretch, missed, lambda state: (state.ratio >= 1.0) & (state.load <= value))
    if np.all(found[0].a > 0.0) and (not np.all(found[-1].load >= value)):
        found = _walked(near, stretch, missed, _never)
    risen, left = (_risen(near, found), value < np.inf)
    least, a = (_least(risen), np.full_like(value, np.nan))
    for start, high, _ in risen[::-1]:
        met = left & (start.load - value <= ROUNDING * (np.abs(start.load) + np.abs(value))) & (high.load >= value)
        met = met & (start.a >= least.a)
        there = _between(near, _by_load(value, least), start, high, met)
        a, left = ((start.a if np.isnan(there.a) else there.a) if met else a, left & np.logical_not(met))
    return a


def _risen(near, found):
    """States, or minima between two, with those that follow, and whether the load grows from there on."""
    risen = []
    for low, high in zip(found, found[1:], strict=False):
        dips = (low.ratio < 1.0) & (high.ratio >= 1.0)
        start = _chosen(dips, _between(near, _by_ratio, low, high, dips), low)
        risen.append((start, high, dips | (low.ratio >= 1.0)))
    return risen


def _least(risen):
    """The state of the least load of those from which it grows."""
    best = _none(risen[0][0])
    for start, _, grows in risen:
        best = _chosen(grows & (start.load < best.load), start, best)
    return best


def parted(opened, first, E_star, sigma_0):
    """The radius c of a zone without contact, up to its first one, at which the depth is least; 0 where it falls."""

    def near(c, q):
        ratio = opened(c, np.zeros_like(c))[1] / (4.0 / np.pi * (sigma_0 / E_star))
        return State(c, c, ratio, ratio)
    last = near(first, first)
    least = _between(near, _by_ratio, _none(last)._replace(a=np.zeros_like(first)), last, last.ratio >= 1.0)
    return 0.0 if np.isnan(least.a) else least.a


def _by_ratio(state):
    return np.log(state.ratio)


def _by_load(value, least):
    """What is missed of a load above the least one, which grows as (ln a)**2 there and as a power of a far from it."""
    size = np.abs(least.load)
    wanted = np.log1p(np.sqrt((value - least.load) / size))

    def missed(state):
        known = np.log1p(np.sqrt(np.maximum(state.load - least.load, 0.0) / size))
        return 0.0 if np.abs(state.load - value) <= ROUNDING * (size + np.abs(value)) else known - wanted
    return missed


def _none(state):
    """In the place of a state: there is none."""
    return State(np.full_like(state.a, np.nan), state.q, np.full_like(state.ratio, np.nan), np.full_like(state.load, np.inf))


def _chosen(condition, one, other):
    return State(*_picked(condition, one, other))


def _picked(condition, one, other):
    return [x if condition else y for x, y in zip(one, other, strict=True)]


def _never(state):
    return state.ratio < 0.0


def _walked(near, stretch, missed, enough):
    """States in ascending order on to where nothing is missed, or to the end of the profile.

    They begin at the highest of the radii at which there is `enough`, without a contact if there is none.
    """
    first, own, top, within, rises = stretch
    states, guides = (list[State](), list[State]())
    for a in own[::-1]:
        guess = _guess(guides, a) if guides else first
        states.append(near(within(a), guess))
        guides.append(State(a, guess if np.isnan(states[-1].q) else states[-1].q, *states[-1][2:]))
        if np.all(enough(states[-1])):
            break
    found = [] if np.all(enough(states[-1])) else [near(np.zeros_like(first), first)]
    for here, a in zip(states[::-1], own[-len(states):], strict=True):
        reached = here.ratio == here.ratio
        found.append(_chosen(reached, here, found[-1]) if found else here)
        top = top if reached else np.minimum(a, top)
    last = found[-1]
    step, ended, steep = (np.full_like(first, SHORTEST), first != first, np.full_like(first, STEEP))
    for _ in range(WALKED):
        short = missed(last)
        more = (short < 0.0) & (last.a * (1.0 + CLOSE) < top) & (rises | (last.ratio >= 1.0))
        if not np.count_nonzero(more):
            break
        step = np.minimum(np.maximum(-BEYOND * short / steep, step), LONGEST)
        ahead = np.sqrt(last.a * top) if ended else top
        a = np.minimum(last.a * np.exp(step), ahead) if more else last.a
        here, step = (near(within(a), _guess(found, a)), 2.0 * step)
        reached = here.ratio == here.ratio
        gained = missed(here) - short
        steep = np.maximum(gained / np.log(a / last.a), FLAT) if gained > 0.0 else steep
        last, top, ended = (_chosen(reached, here, last), top if reached else a, ended | np.logical_not(reached))
        found.append(last)
    return found


def _guess(found, a):
    """q at a radius, by a line in logarithms through the last two states."""
    last, before = (found[-1], found[-2:][0])
    known = (before.a > 0.0) & (last.a != before.a)
    slope = np.log(last.q / before.q) / np.log(last.a / before.a) if known else 0.0
    return last.q * ((a / last.a) ** slope if known else 1.0)


def _between(near, missed, low, high, holds):
    """Where what is missed changes its sign between two states, by parabolas in ln a or halves (Chandrupatla 1997)."""
    low, high = _above_nothing(near, missed, low, high, holds)
    holds = holds & (missed(low) < 0.0)
    if not np.count_nonzero(holds):
        return _none(high)
    unit, best, left = (high.a, high, holds)
    x, y, z = (0.0 * unit, missed(high), np.log(high.q))
    x_b, y_b, z_b = (np.log(low.a / unit), missed(low), np.log(low.q))
    x_c, y_c, z_c = (x_b, y_b, z_b)
    share = y / (y - y_b) if (y > 0.0) & (y_b > -np.inf) else 0.5
    for _ in range(STEPS):
        moved = x + share * (x_b - x)
        slope = (z_b - z) / (x_b - x)
        bend = 0.0 if x_c == x_b else (slope - (z_c - z) / (x_c - x)) / (x_b - x_c)
        state = near(unit * np.exp(moved), np.exp(z + (moved - x) * (slope + (moved - x_b) * bend)))
        found, gone = (missed(state), np.abs(moved - x))
        rest = found * (moved - x) / (found - y) if (np.abs(found) <= SETTLED) & (found != y) else 0.0
        best = _chosen(left, state._replace(a=unit * np.exp(moved - rest)), best)
        left = left & (np.abs(found) > SETTLED) & (gone > UNMOVED)
        if not np.count_nonzero(left):
            break
        same = (found >= 0.0) == (y >= 0.0)
        last, beyond = ((x, y, z), (x_b, y_b, z_b))
        (x_c, y_c, z_c), (x_b, y_b, z_b) = (_picked(same, last, beyond), _picked(same, beyond, last))
        x, y, z = (moved, found, np.log(state.q))
        xi, phi = ((x - x_b) / (x_c - x_b), (y - y_b) / (y_c - y_b))
        smooth = (phi * phi < xi) & ((1.0 - phi) * (1.0 - phi) < 1.0 - xi)
        more = (x_c - x) / (x_b - x) * (y_b / (y_c - y_b))
        share = y / (y_b - y) * (y_c / (y_b - y_c)) + y / (y_c - y) * more if smooth else 0.5
        share = share if (share > 0.0) & (share < 1.0) else 0.5
    return _chosen(holds, best, _none(best))


def _above_nothing(near, missed, low, high, holds):
    """Two states with a contact on both sides of what is looked for, where the lower one has none."""
    step, least = (np.full_like(high.a, SHORTEST), LEAST * high.a)
    for _ in range(WALKED):
        more = holds & (low.a <= 0.0)
        if not np.count_nonzero(more):
            break
        step = np.minimum(np.maximum(BEYOND * missed(high) / STEEP, step), LONGEST)
        a = np.maximum(high.a * np.exp(-step), least) if more else high.a
        here, step = (near(a, high.q), 2.0 * step)
        beyond = (missed(here) >= 0.0) & (a > least)
        low = _chosen(more & np.logical_not(beyond), here, low)
        high = _chosen(more & beyond, here, high)
    return (low, high)
