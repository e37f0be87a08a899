"""The rule of cohesive zones for plain numbers."""

from __future__ import annotations

import math
from collections.abc import Callable

from ..integrals import STRIPS
from ..plain import rule


def both(
    integrand: Callable[[float], tuple[float, float]],
    stop: float,
    width: float = 1.0,
    lengths: tuple[tuple[float, int], ...] = STRIPS,
) -> tuple[float, float]:
    """The integrals of both members of a pair from 0 to `stop`, from the same nodes, in as many panels as it takes."""
    if stop != stop:
        return stop, stop
    # `rule` leaves more than a few panels to the arrays
    panels = max(math.ceil(stop / width / lengths[-1][0]), 1)
    panel = rule(lengths)(stop / width / panels)
    nodes = [((start + node) / panels, weight / panels) for start in range(panels) for node, weight in panel]
    values = [integrand(node * stop) for node, _ in nodes]
    gap, rate = ([weight * value[i] for (_, weight), value in zip(nodes, values, strict=True)] for i in (0, 1))
    return math.fsum(gap) * stop, math.fsum(rate) * stop
