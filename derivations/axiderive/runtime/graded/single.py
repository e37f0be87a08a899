"""Integrals with an algebraic weight at their lower end, for plain numbers."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache

from ..nodes import gauss_legendre
from .rules import NODES, product_weights

Pairs = list[tuple[float, float]]


def weighted(
    smooth: Callable[[float], float], stop: float, power: float, count: int = NODES, above: float | None = None
) -> float:
    """Integral of x**power smooth(x) from 0 to `stop`, over stop**(1 + power), as over arrays."""
    if power >= -0.25:
        return math.fsum([weight * smooth(node * stop) for node, weight in _pairs(power, count, beyond=False)])
    above = 1.0 + power if above is None else above
    end = smooth(0.0)
    pairs = _pairs(above, count, beyond=True)
    return end / above + math.fsum([weight * (smooth(node * stop) - end) for node, weight in pairs])


@cache
def _pairs(power: float, count: int, *, beyond: bool) -> Pairs:
    """Nodes with their weights, `beyond` the value at zero over the nodes."""
    nodes, weights = gauss_legendre(count)[0], product_weights(power, count)
    return list(zip(nodes.tolist(), (weights / nodes if beyond else weights).tolist(), strict=True))
