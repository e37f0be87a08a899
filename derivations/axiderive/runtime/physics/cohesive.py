"""Contact with a cohesive zone a < r < c of constant attraction sigma_0, by q = sqrt(c**2 - a**2).

The gap of the normal contact at c is 2/pi times the integral of g'(t) arccos(t/c) from a to c: positive terms, however
close c and a are.  Its rate with c weighs g'(t) by t/(c sqrt(c**2 - t**2)).  In the angles of `opening` nothing is
singular at t = c; singularities of g' elsewhere are kept pi/2 away from the path.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ..integrals import STRIPS, difference_root, integral_by_length, integral_in_strip
from ..interface import Array, Result
from ..inverse import inverse
from .branches import radii_around, radii_below, radii_to

Opening = Callable[[Array, Array], tuple[Array, Array]]
"""Of q and a the gap of the normal contact at c, and its rate with c."""
Slope = Callable[..., Array]
NODES, SHORT, TIP = 32, 16, 64
"""Of a slope of any form, of a polynomial up to the fifth power, and of a tip of any form."""
NARROW = 0.7
"""Of pi/2: how close images of the end of a profile come to the path."""
WITHIN = 1.0 - 1e-6
"""Of the largest q: a zone that comes closer to the end of a profile is not looked for."""
DECAY = 40.0
"""exp(-40) of a gap is less than its rounding."""
EXPONENTS = (0.5, 4.0)
"""Of the gap in q, as a guess: from the ring alone to the narrow zone of a steep profile."""
CLOSEST = 1e-9
"""Root of 1 - (r/c)**2 next to r = c: no double is closer but c itself."""
EMPTY = 0.5 * np.pi - 1.0
"""Gap at the end of a ring without contact, by its load."""


class Separated(NamedTuple):
    """Depth and force where the surfaces attract each other without contact."""

    depth: Result
    force: Result


def outer_radius(q: Array, a: Array) -> Array:
    """The radius c."""
    return np.hypot(a, q)


def half_angle(q: Array, a: Array) -> Array:
    """The angle whose cosine is a/c."""
    return np.arctan2(q, a)


def both(
    integrand: Callable[[Array], tuple[Array, Array]],
    stop: Array,
    width: float = 1.0,
    lengths: tuple[tuple[float, int], ...] = STRIPS,
) -> tuple[Array, Array]:
    """The integrals of both members from 0 to `stop`."""
    gap = integral_by_length(lambda x: integrand(x)[0], stop, width, lengths)
    return gap, integral_by_length(lambda x: integrand(x)[1], stop, width, lengths)


def opening(slope: Slope, q: Array, a: Array, nodes: int) -> tuple[Array, Array]:
    """For g' without singularities."""
    c, end = np.hypot(a, q), np.arctan2(q, a)

    def gained(u: Array) -> tuple[Array, Array]:
        cosine = np.cos(u)
        growth = slope(c * cosine)
        return growth * u * np.sin(u), growth * cosine

    gap, rate = both(gained, end, 1.0, ((np.inf, nodes),))
    return 2.0 / np.pi * c * gap, 2.0 / np.pi * rate


def opening_power(slope: Slope, q: Array, a: Array, n: Array | float) -> tuple[Array, Array]:
    """For g' with singularities on the imaginary axis and at t = 0 only, where it falls as the power n - 1 of t."""
    c = np.hypot(a, q)
    far = np.where(a > 0.0, q / np.where(a > 0.0, a, 1.0), np.inf)
    end = np.minimum(np.arcsinh(far), DECAY / np.minimum(n, 1.0))

    def gained(v: Array) -> tuple[Array, Array]:
        # t = c/cosh(v)
        side, secant = np.sinh(v), np.cosh(v)
        growth = slope(c / secant) / secant
        return growth * np.arctan(side) * (side / secant), growth / secant

    gap, rate = both(gained, end)
    return 2.0 / np.pi * c * gap, 2.0 / np.pi * rate


def opening_below(slope: Slope, q: Array, a: Array, R: Array) -> tuple[Array, Array]:
    """For g' singular at t = R; `slope` takes t and sqrt(R**2 - t**2)."""
    c, angle = np.hypot(a, q), np.arctan2(q, a)
    reach = difference_root(R, a)
    left = np.sqrt(np.maximum(reach - q, 0.0) * (reach + q))
    scale = np.arcsinh(left / c)
    inside = scale > 0.0
    scale = np.where(inside, scale, 1.0)
    end = np.arcsinh(angle / scale)

    def gained(v: Array) -> tuple[Array, Array]:
        u = scale * np.sinh(v)
        sine, cosine = np.sin(u), np.cos(u)
        growth = slope(c * cosine, np.hypot(left, c * sine)) * scale * np.cosh(v)
        return growth * u * sine, growth * cosine

    gap, rate = both(gained, end, NARROW)
    return np.where(inside, 2.0 / np.pi * c * gap, np.inf), np.where(inside, 2.0 / np.pi * rate, np.inf)


def opening_tip(slope: Slope, q: Array, a: Array, b: Array, nodes: int) -> tuple[Array, Array]:
    """What is below a break at b of g' without singularities there."""
    c, end = np.hypot(a, q), np.arctan2(q, a)
    # c**2 - b**2 without a difference of squares
    outer = np.where(a < b, np.sqrt(np.maximum(q - difference_root(b, a), 0.0) * (q + difference_root(b, a))), q)
    start = np.where(a < b, np.arctan2(outer, b), end)
    start = np.minimum(np.where(c > b, start, 0.0), end)
    start = np.where(a < b, start, end)

    def gained(v: Array) -> tuple[Array, Array]:
        u = start + v
        cosine = np.cos(u)
        growth = slope(c * cosine)
        return growth * u * np.sin(u), growth * cosine

    gap, rate = both(gained, end - start, 1.0, ((np.inf, nodes),))
    return 2.0 / np.pi * c * gap, 2.0 / np.pi * rate


def opening_beyond(slope: Slope, q: Array, a: Array, b: Array) -> tuple[Array, Array]:
    """What is beyond it; `slope` takes t and sqrt(t**2 - b**2), in which it is regular but for the imaginary axis."""
    c, inner, short = np.hypot(a, q), difference_root(a, b), difference_root(b, a)
    # roots of start**2 - b**2 and c**2 - b**2, and of the difference of these
    outer = np.where(a < b, np.sqrt(np.maximum(q - short, 0.0) * (q + short)), np.hypot(inner, q))
    # next to each other the two roots are equal, and their difference is not
    whole = np.where(a < b, outer, q)
    holds = whole > 0.0
    outer, whole = np.where(holds, outer, b), np.where(holds, whole, b)
    scale = np.arcsinh(b / outer)
    # root = outer cos(angle), angle = pi/2 - scale sinh(last - v)
    angle = np.arctan2(whole, inner)
    x, y = 0.5 * np.pi / scale, np.arctan2(inner, whole) / scale
    last = np.arcsinh(x)
    end = np.arcsinh(angle / scale * (x + y) / (x * np.sqrt(1.0 + y * y) + y * np.sqrt(1.0 + x * x)))

    def gained(v: Array) -> tuple[Array, Array]:
        turned = 2.0 * scale * np.cosh(last - 0.5 * v) * np.sinh(0.5 * v)
        root, side = outer * np.cos(turned), outer * np.sin(turned)
        t = np.sqrt(b * b + root * root)
        growth = slope(t, root) * root * scale * np.cosh(last - v)
        return growth * np.arctan2(side, t) * (side / t), growth / c

    gap, rate = both(gained, end)
    return np.where(holds, 2.0 / np.pi * gap, 0.0), np.where(holds, 2.0 / np.pi * rate, 0.0)


def work_of_zone(opened: Opening, q: Array, a: Array, E_star: Array, sigma_0: Array) -> Array:
    """sigma_0 times the gap at c."""
    c, angle = np.hypot(a, q), np.arctan2(q, a)
    gap, _ = opened(q, a)
    return sigma_0 * (gap + 4.0 / np.pi * (sigma_0 / E_star) * q * (angle - q / (c + a)))


def root_within(opened: Opening, a: Array, E_star: Array, dgamma: Array, sigma_0: Array, largest: Array) -> Array:
    """The root of a profile that ends; not a number where the zone would reach beyond the largest q."""
    # a contact beyond the end leaves no q, or none but 0
    reached = (largest > 0.0) & (work_of_zone(opened, WITHIN * largest, a, E_star, sigma_0) >= dgamma)
    found = root_of_zone(opened, a, E_star, np.where(reached, dgamma, np.nan), sigma_0, largest)
    return np.where(reached, found, np.nan)


def root_of_zone(
    opened: Opening, a: Array, E_star: Array, dgamma: Array, sigma_0: Array, largest: Array | float = np.inf
) -> Array:
    """The q at which the gap at c is dgamma/sigma_0."""
    wanted, load = dgamma / sigma_0, 4.0 / np.pi * (sigma_0 / E_star)

    def curve(q: Array) -> tuple[Array, Array]:
        c, angle = np.hypot(a, q), np.arctan2(q, a)
        gap, rate = opened(q, a)
        # 1 - a/c
        short = q / c * (q / (c + a))
        whole = gap + load * q * (angle - q / (c + a))
        return whole, q / whole * (q / c) * (rate + load * (angle / (q / c) - short))

    # the gap of the ring alone is nearly q**2/(2 a + q/EMPTY) of its load
    part = wanted / load
    start = 0.5 * part / EMPTY + np.sqrt((0.5 * part / EMPTY) ** 2 + 2.0 * a * part)
    return inverse(curve, wanted, np.minimum(start, 0.75 * largest), EXPONENTS, largest, smooth=True)


def sunk(q: Array, E_star: Array, sigma_0: Array) -> Array:
    """What the ring takes of the depth."""
    return 2.0 * (sigma_0 / E_star) * q


def pull_of_zone(q: Array, a: Array, sigma_0: Array) -> Array:
    """Its pull."""
    c = np.hypot(a, q)
    return 2.0 * sigma_0 * (c * c * np.arctan2(q, a) + a * q)


def tension_of_zone(r: Array, q: Array, a: Array, sigma_0: Array) -> Array:
    """What it takes of the pressure: sigma_0 on itself, nothing beyond."""
    inside = 2.0 / np.pi * np.arctan2(q, difference_root(a, r))
    return sigma_0 * np.where(r < a, inside, np.where(r < np.hypot(a, q), 1.0, 0.0))


def lift_of_zone(r: Array, q: Array, a: Array, E_star: Array, sigma_0: Array) -> Array:
    """What it takes of the displacement: as far as the load reaches, sqrt(c**2 - x**2)/sqrt(r**2 - x**2) from a on."""
    c, place = np.hypot(a, q), np.maximum(r, a)
    wide = difference_root(place, a)
    within = place < c
    # x = r sin(turned) from the axis of the angle at the nearer of both radii
    near, far = np.minimum(place, c), np.maximum(place, c)
    reach = np.where(within, wide, q)
    kc = difference_root(far, near) / far
    held = np.where(place > a, np.arctan2(a, wide), 0.5 * np.pi)
    end = np.arctan2(reach, a)
    ring = _ring(near, far, kc, end, within)
    return 4.0 / np.pi * (sigma_0 / E_star) * (q * held + ring)


def _ring(near: Array, far: Array, kc: Array, end: Array, within: Array) -> Array:
    """Integral of sqrt(c**2 - x**2)/sqrt(r**2 - x**2) from a to the nearer of c and r.

    With x = near cos(u) the longer root is far sqrt(kc**2 + (near/far)**2 sin(u)**2): next to the edge of the ring that
    is a small number beside the sine, and in u = kc sinh(v) regular.
    """
    ratio = near / far
    scale = np.maximum(kc, CLOSEST)
    last = np.arcsinh(end / scale)

    def rate(v: Array) -> Array:
        u = scale * np.sinh(v)
        sine = np.sin(u)
        root = np.hypot(kc, ratio * sine)
        return np.where(within, far * root, near * (sine / root) * (sine * ratio)) * scale * np.cosh(v)

    return integral_in_strip(rate, last, NARROW)


def sides(a: Array, q: Array) -> tuple[Array, Array]:
    """q/c and a/c."""
    c = np.hypot(a, q)
    return q / c, a / c


def still(opened: Opening, a: Array, q: Array, control: str, E_star: Array, sigma_0: Array) -> Array:
    """Rate of the gap with c over that at which the load does not change with a: above 1 the load grows.

    What the ring adds to the gap and takes of the load has fallen out; no slope of the profile is left.
    """
    (sine, cosine), angle = sides(a, q), np.arctan2(q, a)
    level = sine * (sine / (1.0 + cosine)) + (angle * (angle / cosine) if control == "force" else 0.0)
    return opened(q, a)[1] / (4.0 / np.pi * (sigma_0 / E_star) * level)


DECADES = 10.0 ** np.arange(-20.0, 24.1, 0.5)[:, None]
"""Of contact radii over the radius of the zone as the contact closes: between infinitely long and short range."""
STEPS, SETTLED, ROUNDING = 90, 2e-16, 1e-15
"""Of a search, the changes of a logarithm that end it, and how far below pull-off a load counts as that, relative."""
Load = Callable[[Array], Array]
State = Callable[[Array], tuple[Array, Array]]
"""Of a radius the ratio of `still`, and the load."""


def radii(first: Array) -> Array:
    """Contact radii that separate the minima of the load, in ascending order, of an endless profile without breaks."""
    return first * DECADES


def radii_by(first: Array, corner: Array) -> Array:
    """Those of a profile with a break."""
    return _sorted(first, radii_around(corner))


def radii_up_to(first: Array, largest: Array) -> Array:
    """Those of a profile that ends steeply."""
    return np.minimum(_sorted(first, radii_below(largest)), WITHIN * largest)


def radii_on_bump(first: Array, largest: Array) -> Array:
    """Those of a profile that ends level."""
    return np.minimum(_sorted(first, radii_to(largest)), WITHIN * largest)


def _sorted(first: Array, others: Array) -> Array:
    parts = first * DECADES, others
    width = max(part.shape[1] for part in parts)
    return np.sort(np.concatenate([np.broadcast_to(part, (len(part), width)) for part in parts]), axis=0)


def radius_of_pull_off(state: State, grid: Array) -> Array:
    """That of the least load: 0 where it falls as long as there is a contact, not a number beyond the profile."""
    ratios, _ = state(grid)
    logs = np.log(ratios)
    starts = np.concatenate([ratios[:1] >= 1.0, (ratios[1:] >= 1.0) & (ratios[:-1] < 1.0)])
    best, least = np.full(starts.shape[1:], np.nan), np.full(starts.shape[1:], np.inf)
    for _ in range(int(starts.sum(axis=0).max(initial=0))):
        place = np.argmax(starts, axis=0)[None]
        there = np.take_along_axis(starts, place, axis=0)[0]
        a = _between(lambda a: np.log(state(a)[0]), grid, logs, place)
        load = np.where(there, state(a)[1], np.inf)
        best, least = np.where(load < least, np.where(place[0] > 0, a, 0.0), best), np.minimum(load, least)
        np.put_along_axis(starts, place, False, axis=0)
    return best


def radius_under(state: State, value: Array, grid: Array) -> Array:
    """The largest radius with this load where the load grows, from that of the least load on."""
    least = radius_of_pull_off(state, grid)
    grid = np.maximum(grid, np.where(least > 0.0, least, grid[0]))
    loads = state(grid)[1]
    unit = np.abs(loads[0]) + np.abs(value)
    known = np.arcsinh((loads - value) / unit)
    starts = (known[1:] >= 0.0) & (known[:-1] < 0.0)
    place = len(starts) - np.argmax(starts[::-1], axis=0)[None]
    a = _between(lambda a: np.arcsinh((state(a)[1] - value) / unit), grid, known, place)
    close = np.abs(value - loads[0]) <= ROUNDING * unit
    return np.where(close, grid[0], np.where(starts.any(axis=0), a, np.nan))


def _between(missed: Load, grid: Array, known: Array, place: Array) -> Array:
    """Where what is missed changes its sign before a place of the grid: false position in logarithms (Illinois)."""
    grid, before = np.log(grid) + np.zeros_like(known), np.maximum(place - 1, 0)
    low, high, under, over = (np.take_along_axis(x, at, axis=0)[0] for x in (grid, known) for at in (before, place))
    stays = tried = np.zeros_like(low)
    for _ in range(STEPS):
        share = under / (under - over)
        last, tried = tried, low + np.where((share >= 0.0) & (share <= 1.0), share, 0.5) * (high - low)
        y = missed(np.exp(tried))
        if not np.count_nonzero((np.abs(y) > SETTLED) & (np.abs(tried - last) > SETTLED)):
            break
        beyond = y >= 0.0
        under = np.where(beyond, np.where(stays > 0.0, 0.5 * under, under), y)
        over = np.where(beyond, y, np.where(stays < 0.0, 0.5 * over, over))
        low, high, stays = np.where(beyond, low, tried), np.where(beyond, tried, high), np.where(beyond, 1.0, -1.0)
    return np.exp(tried)


def alone(opened: Opening, c: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    """The depth of surfaces that attract each other up to the radius c without contact."""
    gap, _ = opened(c, np.zeros_like(c))
    return gap - dgamma / sigma_0 - 4.0 / np.pi * (sigma_0 / E_star) * c


def parted(opened: Opening, first: Array, E_star: Array, sigma_0: Array) -> Array:
    """The radius c of that zone, from its first one down, at which the depth is least; 0 where it falls up to there."""
    grid, load = first * DECADES[:41], 4.0 / np.pi * (sigma_0 / E_star)

    def missed(c: Array) -> Array:
        return np.log(opened(c, np.zeros_like(c))[1] / load)

    known = missed(grid)
    starts = (known[1:] >= 0.0) & (known[:-1] < 0.0)
    place = len(starts) - np.argmax(starts[::-1], axis=0)[None]
    return np.where(starts.any(axis=0), _between(missed, grid, known, place), 0.0)
