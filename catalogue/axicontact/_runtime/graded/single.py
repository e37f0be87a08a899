"""Integrals with an algebraic weight at their lower end, for plain numbers."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import Any

from ..nodes import gauss_legendre
from .rules import NODES, product_weights, quarter

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


def over_quarter(of: Callable[[float], float], points: float, k: float) -> float:
    """Integral of of(cos(y)) sin(y)**k over a quarter turn, as over arrays."""
    pairs, whole = _turned(k)
    if whole is None:
        return math.fsum([weight * of(cosine) for cosine, weight in pairs])
    end = of(1.0)
    return end * whole + math.fsum([weight * (of(cosine) - end) for cosine, weight in pairs])


@cache
def _turned(k: float) -> tuple[Pairs, float | None]:
    cosines, weights, whole = quarter(k)
    return list(zip(cosines.tolist(), weights.tolist(), strict=True)), whole


def far_out(phase: float, k: float, factor: Callable[..., Any]) -> float:
    """The integral of a wave on paths off the real axis: over arrays of complex numbers."""
    from . import waves

    return float(waves.far_out(phase, k, factor))


@cache
def _pairs(power: float, count: int, *, beyond: bool) -> Pairs:
    """Nodes with their weights, `beyond` the value at zero over the nodes."""
    nodes, weights = gauss_legendre(count)[0], product_weights(power, count)
    return list(zip(nodes.tolist(), (weights / nodes if beyond else weights).tolist(), strict=True))
