"""Sums and roots in a fixed number of steps, over the arrays of any library `xp`: what expressions are written with."""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce
from typing import Any

import numpy as np

from .nodes import gauss_legendre

NODES = 64
"""Nodes of a rule, for an interval of any length: those that the package takes for long ones."""
STEPS, MORE, LAST, LEAST = 4, 24, 2, 0.1
"""Steps of a root, and of one whose slope may fall below LEAST, before the last ones, of which gradients are taken.

Over 24 decades the first leave 6e-10 in all functions without breaks, with the last ones 7e-16.
"""
DIGITS = 2.0**50
"""Of a logarithm, as many as it has near one."""
FURTHEST, SETTLED = 50.0, 1e-6
"""The longest step, of a logarithm, and one that is close to the root."""
SHIFT = 12
"""By how much the argument of a gamma function is raised."""


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


def gamma(xp: Any, x: Any) -> Any:
    """Gamma(x) for x > 0, by Stirling's series from x + SHIFT on."""
    below = x
    for i in range(1, SHIFT):
        below = below * (x + i)
    w = x + SHIFT
    u = 1.0 / (w * w)
    rest = (1.0 / 12.0 - u * (1.0 / 360.0 - u * (1.0 / 1260.0 - u * (1.0 / 1680.0 - u / 1188.0)))) / w
    return w ** (w - 0.5) * xp.exp(rest - w) * (2.0 * np.pi) ** 0.5 / below
