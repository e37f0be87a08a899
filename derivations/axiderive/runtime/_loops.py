"""Rules over plain numbers: what changes in the loop over their nodes, and these nodes."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache

from ._nodes import gauss_legendre
from ._trace import Lengths, Node

PANELS = 4
"""Panels of a rule beyond which its sum is left to the body, which carries what rounding loses."""


def is_sum(node: Node) -> bool:
    return node.name == "integral"


def loops(nodes: list[Node]) -> dict[Node, Node]:
    """The integral inside which a node changes, for those that do."""
    found: dict[Node, Node] = {}
    sums = {node.operands[2]: node for node in nodes if is_sum(node)}
    for node in nodes:
        if node in sums:
            found[node] = sums[node]
        elif not is_sum(node) and (inside := [found[x] for x in node.operands if x in found]):
            found[node] = inside[0]
    return found


@cache
def rule(lengths: Lengths) -> Callable[[float], list[tuple[float, float]]]:
    """Nodes and weights on (0, 1) for an interval of a length, in panels beyond the last one."""

    def pairs(length: float) -> list[tuple[float, float]]:
        for longest, count in lengths:
            if length <= longest:
                return _pairs(count, 1)
        panels = math.ceil(length / longest)
        if panels > PANELS:
            raise ArithmeticError
        return _pairs(count, panels)

    return pairs


@cache
def _pairs(count: int, panels: int) -> list[tuple[float, float]]:
    nodes, weights = (column.tolist() for column in gauss_legendre(count))
    panel = list(zip(nodes, weights, strict=True))
    return [((start + node) / panels, weight / panels) for start in range(panels) for node, weight in panel]
