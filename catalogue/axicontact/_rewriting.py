"""Exact rewriting of a graph before it becomes a program: powers of two leave the arrays."""

from __future__ import annotations

import math

from ._trace import Graph, Node, needed


def depending(nodes: list[Node], given: set[str]) -> set[Node]:
    """The nodes that depend on an array."""
    found: set[Node] = set()
    for node in nodes:
        if (node.name == "argument" and node.value in given) or any(x in found for x in node.operands):
            found.add(node)
    return found


def numbers_first(result: Node, given: set[str]) -> Node:
    """The same with powers of two moved from arrays to the numbers before them, which no rounding notices."""
    graph, made = Graph(), dict[Node, Node]()
    nodes = needed(result)
    arrays = depending(nodes, given)
    numbers: set[Node] = set()
    for node in nodes:
        operands = [made[x] for x in node.operands]
        factor = _power_of_two(node) if node in arrays else None
        if factor is not None:
            made[node] = _times(graph, operands[0], graph.number(factor), numbers)
        elif node.name in ("argument", "number"):
            made[node] = graph.copied(node)
        elif node.name == "where":
            made[node] = graph.choice(*operands)
        elif node.name == "unless":
            made[node] = graph.unless(*operands)
        else:
            made[node] = graph.operation(node.name, *operands)
        if node not in arrays:
            numbers.add(made[node])
    return made[result]


def _power_of_two(node: Node) -> float | None:
    """k where the node is x*k or x/(1/k)."""
    if node.name not in ("multiply", "divide") or node.operands[1].name != "number":
        return None
    value = float(node.operands[1].value or 0.0)
    if value == 0.0 or not math.isfinite(value) or abs(math.frexp(value)[0]) != 0.5 or abs(math.frexp(value)[1]) > 64:
        return None
    return value if node.name == "multiply" else 1.0 / value


def _times(graph: Graph, x: Node, factor: Node, numbers: set[Node]) -> Node:
    if x.name in ("multiply", "divide"):
        y, z = x.operands
        if y in numbers:
            return graph.operation(x.name, graph.operation("multiply", y, factor), z)
        if z in numbers:
            return graph.operation(x.name, y, graph.operation(x.name, z, factor))
    return graph.operation("multiply", x, factor)
