"""Sums and roots in a fixed number of steps, over the arrays of any library `xp`: what expressions are written with."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, reduce
from typing import Any

import numpy as np

from .nodes import gauss_legendre

NODES = 64
"""Nodes of a rule, for an interval of any length: those that the package takes for long ones."""
STEPS, MORE, MOST, LAST, LEAST = 4, 24, 48, 2, 0.1
"""Steps of a root, of one whose slope may fall below LEAST and of a stable radius, before those that gradients pass.

Over 24 decades the first leave 6e-10 in all functions without breaks, with the last ones 7e-16.
"""
DIGITS = 2.0**50
"""Of a logarithm, as many as it has near one."""
FURTHEST, SETTLED, NEAR = 50.0, 1e-6, 1e-3
"""The longest step, of a logarithm, one that is close to the root, and the longest of the last ones."""
WAVES = 64.0
"""Waves in which stable radii are looked for."""


def nodes_along(xp: Any, panels: int, *arrays: Any) -> Any:
    """Nodes and weights of some panels of (0, 1), along an axis before all those of the arrays."""
    nodes, weights = gauss_legendre(NODES)
    starts = np.arange(float(panels))[:, None]
    return [along(xp, column, arrays) for column in ((starts + nodes) / panels, weights / panels + 0.0 * starts)]


def along(xp: Any, column: Any, arrays: tuple[Any, ...]) -> Any:
    """Numbers as an array along an axis before all those of the arrays."""
    axes = max(getattr(own, "ndim", 0) for own in arrays)
    return xp.asarray(column.reshape(-1, *(1,) * axes))


def newton(xp: Any, curve: Callable[[Any], Any], value: Any, start: Any, largest: Any, least: Any, most: Any) -> Any:
    """The t at which a curve, given with its logarithmic slope, has this value: by Newton's steps in logarithms.

    The bounds of the slope keep them from running away, and what was met on either side.  The last ones are linear in
    t: the first and the second derivative are those of the root.
    """
    wanted = xp.where(value > 0.0, value, 1.0)
    t = xp.minimum(start, largest)
    low, high, before = -np.inf, np.inf, np.inf
    few = not (isinstance(least, float) and least < LEAST)
    for _ in range(STEPS if few else MORE):
        y, slope = curve(t)
        # at the largest radius of all a curve may have no value
        inside = (y > 0.0) & (y < np.inf)
        missed = xp.where(inside, xp.log(wanted / xp.where(inside, y, wanted)), xp.where(y > 0.0, -1.0, 1.0))
        at = xp.log(t)
        low, high = xp.where(missed > 0.0, at, low), xp.where(missed < 0.0, at, high)
        ends = missed / least, missed / most
        step = xp.maximum(missed / slope, xp.minimum(*ends))
        step = xp.minimum(xp.maximum(xp.minimum(step, xp.maximum(*ends)), -FURTHEST), FURTHEST)
        between = (low > -np.inf) & (high < np.inf)
        # at a kink steps from either side lead to the other one
        far = between & (xp.absolute(step) > xp.maximum(0.5 * before, np.inf if few else SETTLED))
        met = (low <= at + step) & (at + step <= high) & ~far
        halved = xp.where(between, 0.5 * (xp.where(between, low, at) + xp.where(between, high, at)), at)
        moved = xp.where(met, at + step, halved)
        t, before = xp.minimum(xp.exp(moved), largest), xp.absolute(moved - at)
    t = xp.minimum(held(xp, t), largest)
    for _ in range(LAST):
        y, slope = curve(t)
        change = (wanted - y) / y / slope
        t = xp.where(xp.absolute(change) < LEAST, t * (1.0 + change), t)
    return xp.where(value > 0.0, xp.minimum(t, largest), 0.0 * value)


def held(xp: Any, t: Any) -> Any:
    """A number as it is, of which no gradient is taken: that of a rounding is zero."""
    return xp.exp(xp.round(xp.log(t) * DIGITS) / DIGITS)


def numbered(coefficients: Any) -> list[tuple[int, Any]]:
    """The coefficients of r, r**2, ..., with these exponents."""
    alone = isinstance(coefficients, (int, float)) or getattr(coefficients, "ndim", 1) == 0
    return list(enumerate([coefficients] if alone else coefficients, 1))


def least(xp: Any, terms: list[Any]) -> Any:
    """The least of all terms."""
    return reduce(xp.minimum, terms)


def weighted_along(xp: Any, above: Any, *arrays: Any) -> Any:
    """Nodes and weights for x**(above - 1): next to `above` = 0 nearly all weight lies at the lower end, a node."""
    moments = [1.0 / (1.0 + above)]
    for j in range(1, NODES):
        moments.append(moments[-1] * ((above + (1.0 - j)) / (above + (1.0 + j))))
    moment = xp.stack([xp.asarray(own) for own in moments])
    rest = max(getattr(own, "ndim", 0) for own in arrays) - (moment.ndim - 1)
    moment = xp.reshape(moment, (NODES, *(1,) * rest, *moment.shape[1:]))
    nodes, table = _over_nodes()
    weights = xp.tensordot(xp.asarray(table), moment, axes=1)
    end = 1.0 / above - xp.sum(weights, axis=0)
    return along(xp, nodes, arrays), xp.concatenate([weights, xp.reshape(end, (1, *weights.shape[1:]))])


@cache
def _over_nodes() -> tuple[Any, Any]:
    """The nodes and the end, and from moments to weights over the nodes."""
    from .graded.rules import legendre_table

    nodes = gauss_legendre(NODES)[0]
    return np.append(nodes, 0.0), legendre_table(NODES) / nodes[:, None]


def radii_along(xp: Any, kind: str, *arrays: Any) -> Any:
    """The radii of a grid for the length one, along an axis before all those of the arrays."""
    from .physics import branches

    lengths = {"decades": (), "radii_of_waves": (1.0, WAVES)}.get(kind, (1.0,))
    return along(xp, getattr(branches, kind)(*lengths), arrays)


def stable(xp: Any, curve: Callable[[Any], Any], value: Any, radii: Any) -> Any:
    """The largest radius at which a curve, given with its slope, rises to this value; NaN without any.

    Between two radii of a grid of which the first is below it, or on a branch that falls; there by steps that halve
    it, or are Newton's.
    """
    y, slope = curve(radii)
    last = xp.asarray(np.arange(1.0, y.shape[0]).reshape(-1, *(1,) * (y.ndim - 1)))
    below = (y[:-1] <= value) | ((slope[:-1] < 0.0) & (slope[1:] > 0.0))
    # beyond its domain a curve that rises goes on
    beyond = (y[1:] >= value) | ((slope[:-1] > 0.0) & ~(y[1:] < np.inf))
    # the least load of the one may be above the value
    both = [xp.max(xp.where(own & beyond, last, 0.0), axis=0) for own in (below, y[:-1] <= value)]
    low, high, first = (
        xp.stack([xp.sum(xp.where(last == place, own, 0.0), axis=0) for place in both])
        for own in (radii[:-1], radii[1:], y[:-1])
    )
    exists = low > 0.0
    low, high, before = xp.where(exists, low, 1.0), xp.where(exists, high, 1.0), np.inf
    a, ends = xp.sqrt(low) * xp.sqrt(high), (low, high)
    for _ in range(MOST):
        y, slope = curve(a)
        rises = slope > 0.0
        step = (value - y) / xp.where(rises, slope, 1.0)
        # no number is beyond the domain
        beyond = (rises & (y >= value)) | ~(y < np.inf)
        low, high = xp.where(beyond, low, a), xp.where(beyond, a, high)
        far = xp.absolute(step) > xp.maximum(0.5 * before, SETTLED * a)
        met = rises & (low <= a + step) & (a + step <= high) & ~far
        moved = xp.where(met, a + step, xp.sqrt(low) * xp.sqrt(high))
        a, before = moved, xp.absolute(moved - a)
    # where the least load is above the value the slope may be infinite
    exists = exists & ((first <= value) | (curve(a)[0] - value <= SETTLED * (xp.absolute(value) + xp.absolute(first))))
    a = xp.minimum(xp.maximum(held(xp, a), ends[0]), ends[1])
    for _ in range(LAST):
        y, slope = curve(a)
        change = (value - y) / slope
        exists = exists & (y == y) & ~(xp.absolute(change) >= NEAR * a)
        a = xp.minimum(xp.where(xp.absolute(change) < NEAR * a, a + change, a), ends[1])
    a = xp.where(exists, a, np.nan)
    return xp.where(a[0] > 0.0, a[0], a[1])


def rising(xp: Any, x: Any, e: Any) -> Any:
    """Gamma(x + e)/Gamma(x) for x >= 1 and 0 < e < 1, by the series from x + FAR on."""
    from .graded.growth import FAR, series

    near = sum(xp.log1p(e / (x + i)) for i in range(int(FAR)))
    w = x + FAR + (e - 1.0) / 2.0
    first, second, third = series(e)
    return w**e * (1.0 + (first + (second + third / (w * w)) / (w * w)) / (w * w)) * xp.exp(-near)


def fading(xp: Any, x: Any, m: Any) -> Any:
    """1F1(1; m + 1; -x) by all terms of its series, and by a rule beyond."""
    from .physics.relaxation import SWITCH, TERMS

    low = xp.minimum(x, SWITCH)
    term = total = xp.exp(-low)
    for k in range(1, TERMS):
        term = term * low / k
        total = total + term * (m / (m + k))
    high = xp.maximum(x, SWITCH)
    nodes, weights = nodes_along(xp, 1, x, m)
    stop = 0.999999 * SWITCH / high
    place = nodes * stop
    tail = stop * xp.sum(weights * m * xp.exp((m - 1.0) * xp.log1p(-place) - high * place), axis=0)
    return xp.where(x <= SWITCH, total, tail)


def fraction(xp: Any, x: Any, p: Any, q: Any) -> Any:
    """The continued fraction of an incomplete beta function, by as many terms as p, q < 50 ask for."""
    from .physics.retraction import coefficients

    above, below = 1.0, 1.0 / (1.0 - (p + q) * x / (p + 1.0))
    total = below
    for k in range(1, MOST):
        for own in coefficients(k, x, p, q):
            below = 1.0 / (1.0 + own * below)
            above = 1.0 + own / above
            total = total * (above * below)
    return total
